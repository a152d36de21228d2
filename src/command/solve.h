/* SPDX-License-Identifier: GPL-3.0-or-later
**
** solve.h - questions answered backwards: at which values of an input a result has a value.
*/
#ifndef FOURLINK_COMMAND_SOLVE_H
#define FOURLINK_COMMAND_SOLVE_H

#include <stdio.h>

#include "input.h"
#include "tables/sheet.h"

/* Answer --solve: write a line for each solution on each branch or, with --print-deck, the deck of the first.
** Returns the exit status: EXIT_ROWS if there is none. */
int solve_write(FILE *out, input *in);

/* The same in a sheet of values, with the columns that solve_columns gives: SOLVE_COLUMNS, or 0 if the
** deck has no such question; `name` holds that of the value, at its angle.  A deck without a solution
** has a line that says why. */
#define SOLVE_COLUMNS 2
#define SOLVE_NAME MESSAGE_SIZE
unsigned long solve_columns(input *in, fourlink_value columns[SOLVE_COLUMNS],
                            char name[SOLVE_NAME]);
int solve_put(sheet *s, input *in);

#endif
