/* SPDX-License-Identifier: GPL-3.0-or-later
**
** series.h - numbers of all steps in few letters, for player.js.
*/
#ifndef FOURLINK_SERIES_H
#define FOURLINK_SERIES_H

#include <stddef.h>

#include "tables/line.h"

/* Write a number, rounded to so many parts of its unit. */
void series_put_rounded(line *l, double x, double parts);

/* Write numbers as a text, in so many parts of their unit: the first, and how each differs from where
** the two before lead to.  One that is not there stands still. */
void series_put(line *l, const double *x, size_t n, double parts);

/* The same, or the first one to its sixth decimal if they are all the same but for so much. */
void series_put_or_one(line *l, const double *x, size_t n, double parts, double near);

#endif
