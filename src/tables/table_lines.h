/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table_lines.h - the parts of the format table that are lines of text: facts, lists, comparisons, designs.
*/
#ifndef FOURLINK_TABLES_TABLE_LINES_H
#define FOURLINK_TABLES_TABLE_LINES_H

#include "sheet.h"

/* Write the number and variables of a design; the head of a list. */
void table_put_design_comment(sheet *s);
void table_put_list_head(sheet *s);

/* As in sheet_frame. */
void table_begin_designs(sheet *s);
void table_begin_values(sheet *s);
void table_begin_scores(sheet *s);
void table_close_checks(sheet *s);
void table_refuse(sheet *s, const char *why);
void table_refuse_rows(sheet *s, const char *why);
void table_refuse_values(sheet *s, const char *why);

/* As in sheet_format. */
void table_put_column(sheet *s, const fourlink_value *column);
void table_put_listed(sheet *s, const fourlink_value *fact);
void table_put_check(sheet *s, const fourlink_check *check);
void table_put_design(sheet *s, fourlink_branch branch, const sheet_output *outputs,
                      const char *why);
void table_put_values(sheet *s, fourlink_branch branch, const sheet_output *outputs,
                      const char *why);
void table_put_mark(sheet *s, const sheet_mark *m);

#endif
