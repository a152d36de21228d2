/* SPDX-License-Identifier: GPL-3.0-or-later
**
** head.h - the head of a table: what was computed, in four lines.
*/
#ifndef FOURLINK_TABLES_HEAD_H
#define FOURLINK_TABLES_HEAD_H

#include "sheet.h"

/* Write the title, if there is one; the kind of mechanism; then its type, its lengths, and its speed with
** what has a mass or a load. */
void head_put_title(sheet *s);
void head_put_kind(sheet *s);
void head_put_properties(sheet *s);

#endif
