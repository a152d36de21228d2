/* SPDX-License-Identifier: GPL-3.0-or-later
**
** solutions.h - the solutions of a [synthesis] as a table.
*/
#ifndef FOURLINK_SOLUTIONS_H
#define FOURLINK_SOLUTIONS_H

#include <stdio.h>

#include "input.h"

/* Write a line for each solution; returns the exit status. */
int solutions_write(FILE *out, const input *in);

#endif
