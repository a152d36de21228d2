/* SPDX-License-Identifier: GPL-3.0-or-later
**
** motion.h - display lists of many steps as one: items whose places are tracks, a place for each step.
*/
#ifndef FOURLINK_MOTION_H
#define FOURLINK_MOTION_H

#include "display.h"

/* An item of all steps.  Its tracks are its places in pixels; of an arc its centre, and (from, span) in
** hundredths of a radian; of a text its place without (dx, dy), and these.  A curve stands still: it is
** that of the first step, and has places of its own. */
typedef struct motion_item {
    display_item like; /* in words and names, offsets of the motion's; its places are not used */
    size_t first, n;   /* of its tracks; of a curve, of its places */
    size_t row;        /* of its words */
    int varies;        /* 1: they are not the same at all steps */
} motion_item;

typedef struct motion {
    size_t n_steps;
    motion_item *items; /* in the order in which they are drawn */
    size_t n_items, items_capacity;
    fourlink_vector *tracks; /* n_steps places each; NaN where the item is not there */
    size_t n_tracks, tracks_capacity;
    fourlink_vector *curves;
    size_t n_curves, curves_capacity;
    size_t *words; /* by row and step: an offset of words; MOTION_NONE: the item is not there */
    size_t words_capacity;
    display kept; /* the words */
} motion;

/* What may differ in the words of a note or a scale: what is behind its equals sign, or all. */
const char *motion_value(const char *words);

#define MOTION_NONE ((size_t)-1)

void motion_open(motion *m, size_t n_steps);
void motion_close(motion *m);

/* Add the panel of a display list as one step.  An item that has the same sort, look, name and words as one
** of the steps before continues it; the words of notes may differ. */
void motion_add(motion *m, size_t step, const display *d);

/* The words of an item at a step; null if it is not there. */
const char *motion_words(const motion *m, size_t item, size_t step);

#endif
