/* SPDX-License-Identifier: GPL-3.0-or-later
**
** solutions.h - the solutions of a [synthesis] as a table, a line for each: written as designs of a
** sweep are.
*/
#ifndef FOURLINK_COMMAND_SOLUTIONS_H
#define FOURLINK_COMMAND_SOLUTIONS_H

#include <stdio.h>

#include "input.h"

/* Write a line for each solution of a [synthesis]. */
int solutions_write(FILE *out, const input *in);

#endif
