/* SPDX-License-Identifier: GPL-3.0-or-later
**
** summary.h - a summary in the format table: inputs, then results, a line each, 100 columns wide.
*/
#ifndef FOURLINK_SUMMARY_H
#define FOURLINK_SUMMARY_H

#include "sheet.h"

/* Write the head and the inputs; a fact. */
void summary_put_inputs(sheet *s);
void summary_put_fact(sheet *s, const fourlink_value *fact);

#endif
