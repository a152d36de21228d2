/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_output_type.h - what differs between types of outputs in the sample calculation.
*/
#ifndef FOURLINK_REPORT_SAMPLE_OUTPUT_TYPE_H
#define FOURLINK_REPORT_SAMPLE_OUTPUT_TYPE_H

#include "sample_template.h"

/* The motion of a point of a link. */
typedef struct sample_point {
    fourlink_vector place, velocity, acceleration;
} sample_point;

/* What is known of an output in a position. */
typedef struct sample_hung {
    sample_point P,
        D; /* D: the pin of a rocker, or the point of a slider's line, which does not move */
    const fourlink_link_state *rod, *end;
    double s5, sdot5;         /* of a block in its slot */
    double s6, sdot6, sddot6; /* of a slider */
} sample_hung;

/* A type: its position ends with the two equations of its loop. */
typedef struct sample_output_type {
    const char *words; /* what hangs on P of the carrying link, whose name is put in */
    void (*place)(const sample_output *o, const sample_hung *now);
    void (*move)(const sample_output *o, const sample_hung *now);
    void (*accelerate)(const sample_output *o, const sample_hung *now);
} sample_output_type;

const sample_output_type *sample_output_type_of(const fourlink_group *group);

#endif
