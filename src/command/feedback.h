/* SPDX-License-Identifier: GPL-3.0-or-later
**
** feedback.h - a text for each student: what was asked, given, right or wrong, and why.
*/
#ifndef FOURLINK_FEEDBACK_H
#define FOURLINK_FEEDBACK_H

#include "marks.h"

/* Write the text of an input that has been marked into the folder of --feedback; returns the exit status. */
int feedback_write(const marks *m, const input *in, const sheet_mark *mark);

#endif
