/* SPDX-License-Identifier: GPL-3.0-or-later
**
** summary.h - a summary in the format table: inputs, results, extremes of columns, a line each.
*/
#ifndef FOURLINK_TABLES_SUMMARY_H
#define FOURLINK_TABLES_SUMMARY_H

#include "sheet.h"

/* Write the head and the inputs of a summary; a fact; the extremes of a column, as in sheet_format. */
void summary_put_inputs(sheet *s);
void summary_put_fact(sheet *s, const fourlink_value *fact);
void summary_put_extremes(sheet *s, const fourlink_value *column, const fourlink_value *least,
                          const fourlink_value *most, int branch);

#endif
