/* SPDX-License-Identifier: GPL-3.0-or-later
**
** interactive.h - the moving drawings and the rows of the table as JSON, for player.js.
*/
#ifndef FOURLINK_INTERACTIVE_H
#define FOURLINK_INTERACTIVE_H

#include <stdio.h>

#include "pictures/moving.h"
#include "rows.h"
#include "tables/line.h"

/* The drawings that are wanted. */
typedef struct interactive_form {
    double start; /* crank angle or time in the deck's unit: they begin at the nearest step */
    int is_brief; /* 1: the mechanism alone */
    moving_sheet *sheets; /* of the mechanism by branch; they keep what is found; null: none */
} interactive_form;

/* Write drawings and rows of branches.  Returns 0 without memory. */
int interactive_write(FILE *out, rows *t, const fourlink_branch *branches, int n,
                      const interactive_form *form);

/* What can be dragged, in scene_json.c: links and tracer points, by the names of their pins and discs.
** Members of an object with a comma after the last. */
void interactive_put_scene(line *l, const rows *t);

/* One of the drawings, in moving_json.c; 0 without memory. */
int moving_json_put(line *l, const moving_panel *panel);

/* Write what stands before an entry of a list; `n` counts them. */
void interactive_put_comma(line *l, int *n);

/* Write JSON into an element <script>: %s a text as it is, %q a string, %lu a whole number. */
void interactive_put(line *l, const char *format, ...);

/* Write a name typeset, for the script: its symbol, what stands below it, and what above. */
void interactive_put_label(line *l, const char *name);

#endif
