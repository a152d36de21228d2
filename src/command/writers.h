/* SPDX-License-Identifier: GPL-3.0-or-later
**
** writers.h - what is made of an input besides a sheet and a picture.
*/
#ifndef FOURLINK_WRITERS_H
#define FOURLINK_WRITERS_H

#include <stdio.h>

#include "input.h"

/* Each returns the exit status.  If a signal stops it, after a whole line, its number is `signal_number`,
** otherwise 0. */

/* In designs.c: the designs of a [sweep] that are asked for. */
int designs_write(FILE *out, const input *in, int *signal_number);

/* In best.c: the design that --best asks for, as a deck. */
int best_write(FILE *out, const input *in, int *signal_number);

/* In solutions.c: a line for each solution of a [synthesis]. */
int solutions_write(FILE *out, const input *in);

/* In reporting.c: the report that the options ask for. */
int reporting_write(const input *in);

#endif
