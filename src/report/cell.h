/* SPDX-License-Identifier: GPL-3.0-or-later
**
** cell.h - tables of names and values.
*/
#ifndef FOURLINK_CELL_H
#define FOURLINK_CELL_H

#include "page.h"

/* Markup of the headings that several tables have. */
#define CELL_HEAD(words) "<th scope=\"col\">" words "</th>"
#define CELL_AT CELL_HEAD("at \316\270\342\202\202")

/* Begin a table with a heading h3, unless it is null, and the headings of its columns; end it. */
void cell_begin(page *p, const char *heading, const char *columns);
void cell_end(page *p);

/* Write a number with the digits of a deck; undefined and unbounded ones as signs.  The same as a cell. */
void cell_number(page *p, double value, int digits);
void cell_put(page *p, double value, int digits);

#endif
