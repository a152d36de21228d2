/* SPDX-License-Identifier: GPL-3.0-or-later
**
** batch.h - the sheet of decks, or of one deck with the answers of many, one at a time.
*/
#ifndef FOURLINK_BATCH_H
#define FOURLINK_BATCH_H

#include "input.h"

/* Write the sheet of one input that is open; returns the exit status. */
int batch_write_one(FILE *out, input *in, const grade_answers *answers);

/* Read the decks of the options, or for `deck` the answers to it, and write their sheet to the output of
** the options; returns the exit status.  One is open at a time: where the sheet needs to know of all,
** they are read twice. */
int batch_run(const options *o, const grade_answers *answers, const input *deck);

#endif
