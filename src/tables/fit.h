/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fit.h - a table that fits a terminal: which columns stand side by side.
*/
#ifndef FOURLINK_FIT_H
#define FOURLINK_FIT_H

#include "style.h"

/* Give each column a page, whose columns fit the sheet's width: of kinematics, of forces, of torques, and
** several of them where they fit.  Returns the number of pages, 1 if there is no width. */
int fit_columns(const sheet *s, style *styles);

/* 1 if a column stands on the present page. */
#define FIT_HAS(s, x) ((x)->page == (s)->page || (x)->page == EACH_PAGE)

/* 1 if the first column that is printed is the crank angle. */
int fit_begins_with_angle(const sheet *s);

#endif
