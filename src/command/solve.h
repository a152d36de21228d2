/* SPDX-License-Identifier: GPL-3.0-or-later
**
** solve.h - questions answered backwards: at which values of an input a result has a value.
*/
#ifndef FOURLINK_COMMAND_SOLVE_H
#define FOURLINK_COMMAND_SOLVE_H

#include <stdio.h>

#include "input.h"

/* Answer --solve: write a line for each solution on each branch or, with --print-deck, the deck of the first.
** Returns the exit status: EXIT_ROWS if there is none. */
int solve_write(FILE *out, input *in);

#endif
