/* SPDX-License-Identifier: GPL-3.0-or-later
**
** interactive.h - the rows of the interactive drawing as JSON, for drawing.js.
*/
#ifndef FOURLINK_INTERACTIVE_H
#define FOURLINK_INTERACTIVE_H

#include <stdio.h>

#include "rows.h"

/* Write the rows of branches; the drawing begins at the step nearest to `start`, a crank angle or a time
** in the deck's unit.  Returns 0 without memory. */
int interactive_write(FILE *out, rows *t, const fourlink_branch *branches, int n, double start);

#endif
