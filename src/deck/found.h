/* SPDX-License-Identifier: GPL-3.0-or-later
**
** found.h - finds the linkage of [synthesis], whose lengths the deck then has.
*/
#ifndef FOURLINK_DECK_FOUND_H
#define FOURLINK_DECK_FOUND_H

#include "synthesis.h"

/* Find the linkage; 0 after a mistake, or if there is none. */
int flk_synthesis_run(struct parser *p);

/* Set the lengths of the linkage found, its working range, branch and coupler point, and write its text. */
void flk_synthesis_assign(struct parser *p);

/* The structural error at a crank angle of the linkage found, rad or m; NaN where the wanted function is not
** defined, or the linkage does not reach. */
double flk_synthesis_error(const deck_synthesis *t, double theta2);

/* The crank angles between which it is defined, rad, in the order of the function's range; 0 if the task
** has no function. */
int flk_synthesis_range(const deck_synthesis *t, double theta2[2]);

#endif
