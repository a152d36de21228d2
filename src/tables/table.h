/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table.h - the parts of the format table that are not rows: its head, lines, and summary.
*/
#ifndef FOURLINK_TABLE_H
#define FOURLINK_TABLE_H

#include "sheet.h"

/* Write the title, if there is one; the kind of mechanism; then its type, its lengths, and its speed with
** what has a mass or a load. */
void head_put_title(sheet *s);
void head_put_kind(sheet *s);
void head_put_all(sheet *s);

/* Write the head and the inputs of a summary; a fact; the extremes of a column, as in sheet_format. */
void summary_put_inputs(sheet *s);
void summary_put_fact(sheet *s, const fourlink_value *fact);
void summary_put_extremes(sheet *s, const fourlink_value *column, const fourlink_value *least,
                          const fourlink_value *most, int branch);

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
