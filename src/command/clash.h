/* SPDX-License-Identifier: GPL-3.0-or-later
**
** clash.h - whether what is to be written is something else already.
*/
#ifndef FOURLINK_CLASH_H
#define FOURLINK_CLASH_H

#include "options.h"

/* 1 if a file is one of those that are to be written. */
int clash_is_output(const options *o, const char *path);

/* Tell the first output file that is an input, or that is another output too; the exit status. */
int clash_find(const options *o);

#endif
