/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table_lines.h - the parts of the format table that are lines of text: facts, lists, comparisons, designs.
*/
#ifndef FOURLINK_TABLES_TABLE_LINES_H
#define FOURLINK_TABLES_TABLE_LINES_H

#include "sheet.h"

/* Write the head of a sheet of designs. */
void table_begin(sheet *s);

/* Write the number and variables of a design; the head of a deck. */
void table_put_design_comment(sheet *s);
void table_put_head(sheet *s);

/* As in sheet_format. */
void table_put_column(sheet *s, const fourlink_value *column);
void table_put_fact(sheet *s, const fourlink_value *fact);
void table_put_check(sheet *s, const fourlink_check *check);
void table_put_design(sheet *s, fourlink_branch branch, const sheet_output *outputs,
                      const char *why);
void table_refuse(sheet *s, const char *why);
void table_put_mark(sheet *s, const sheet_mark *m);
void table_close(sheet *s);

#endif
