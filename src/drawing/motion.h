/* SPDX-License-Identifier: GPL-3.0-or-later
**
** motion.h - display lists of many steps as one: items whose places are tracks, a place for each step.
*/
#ifndef FOURLINK_MOTION_H
#define FOURLINK_MOTION_H

#include "display.h"

/* An item of all steps.  Its tracks are its places in pixels; of an arc its centre, and (from, span) in
** hundredths of a radian; of a text that is no label its place without (dx, dy), and these.  A curve stands
** still: it is that of the first step, and has places of its own. */
typedef struct motion_item {
    display_item like; /* in words and names, offsets of the motion's; its places are not used */
    size_t first, n;   /* of its tracks; of a curve, of its places */
    size_t row;        /* of its values */
    int varies;        /* 1: its value is not the same at all steps */
    int unit_varies;   /* 1: nor is its unit */
} motion_item;

/* What an item shows at a step: offsets of texts; MOTION_NONE: it is not there. */
typedef struct motion_value {
    size_t value, unit;
} motion_value;

#define MOTION_NONE ((size_t)-1)

typedef struct motion {
    size_t n_steps;
    motion_item *items; /* in the order in which they are drawn */
    size_t n_items, items_capacity;
    fourlink_vector *tracks; /* n_steps places each; NaN where the item is not there */
    size_t n_tracks, tracks_capacity;
    unsigned long *holds; /* by track: the frame that holds it, by its key; 0: the sheet */
    size_t holds_capacity;
    fourlink_vector *curves;
    size_t n_curves, curves_capacity;
    motion_value *values; /* by row and step */
    size_t values_capacity;
    display kept; /* the texts */
} motion;

void motion_open(motion *m, size_t n_steps);
void motion_close(motion *m);

/* 1 for a label, which the script places; see display.h. */
int motion_is_label(const motion_item *x);

/* Add the panel of a display list as one step.  An item that has the same key, sort and look as one of the
** steps before continues it; it has the same words, but its value and its unit may differ. */
void motion_add(motion *m, size_t step, const display *d);

/* The number of the frame that holds a track, among the items; of all of them for the sheet.  The
** coordinates of a track in a frame at a step, and the angle of the frame, rad, downwards as pixels are. */
size_t motion_frame_of(const motion *m, size_t track);
fourlink_vector motion_seen(const motion *m, size_t frame, size_t track, size_t step);
double motion_angle(const motion *m, size_t frame, size_t step);

/* 1 if an item is there at a step; the value that it shows. */
int motion_has(const motion *m, size_t item, size_t step);
motion_value *motion_value_at(const motion *m, size_t item, size_t step);

#endif
