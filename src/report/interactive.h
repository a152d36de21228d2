/* SPDX-License-Identifier: GPL-3.0-or-later
**
** interactive.h - the rows of the interactive drawing as JSON, for drawing.js.
*/
#ifndef FOURLINK_INTERACTIVE_H
#define FOURLINK_INTERACTIVE_H

#include <stdio.h>

#include "rows.h"
#include "tables/line.h"

/* Write the rows of branches; the drawing begins at the step nearest to `start`, a crank angle or a time
** in the deck's unit.  Returns 0 without memory. */
int interactive_write(FILE *out, rows *t, const fourlink_branch *branches, int n, double start);

/* What it consists of, in scene_json.c: links, polygons, forces by the names of their tracks.  Members of an
** object with a comma after the last. */
void interactive_put_scene(line *l, const rows *t);

/* Write JSON into an element <script>: %s a text as it is, %q a string, %lu a whole number. */
void interactive_put(line *l, const char *format, ...);

/* Write a name typeset, for the script: its symbol, what stands below it, and what above. */
void interactive_put_label(line *l, const char *name);

#endif
