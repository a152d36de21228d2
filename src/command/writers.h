/* SPDX-License-Identifier: GPL-3.0-or-later
**
** writers.h - what is made of an input besides a sheet and a picture.
*/
#ifndef FOURLINK_WRITERS_H
#define FOURLINK_WRITERS_H

#include <stdio.h>

#include "input.h"

/* Each returns the exit status.  A signal stops a sweep after a whole line. */

/* In designs.c: the designs of a [sweep] that are asked for. */
int designs_write(FILE *out, const input *in);

/* In best.c: the design that --best asks for, as a deck. */
int best_write(FILE *out, const input *in);

/* In solutions.c: a line for each solution of a [synthesis]. */
int solutions_write(FILE *out, const input *in);

/* In catalogue.c: the columns and facts of any deck. */
int catalogue_write(FILE *out, const options *o);

/* In drawing.c: the report that the options ask for. */
int drawing_report(const input *in);

#endif
