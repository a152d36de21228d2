/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_sides.h - what is known of a link's three equations, in the sample calculation.
*/
#ifndef FOURLINK_REPORT_SAMPLE_SIDES_H
#define FOURLINK_REPORT_SAMPLE_SIDES_H

#include "mathml.h"
#include "report.h"

#define SAMPLE_HEADING 160

/* The heading of a table, with the name of a unit, or of two, in brackets. */
const char *sample_with_units(char out[SAMPLE_HEADING], const char *words, const char *first,
                              const char *second);

/* A right-hand side and its parts: inertia, weight, loads, and what outputs do to the link. */
typedef struct sample_side {
    double inertia, weight, load, carried, b;
} sample_side;

/* The parts of a link's three equations but for outputs; moments about its centre of mass, or its origin. */
void sample_find_sides(const fourlink_link *data, const fourlink_body *body,
                       const fourlink_link_state *now, int is_about_origin, sample_side side[3]);

/* Begin their table; write the three of a link. */
void sample_begin_sides(report *r, math *m, const char *caption);
void sample_put_sides(report *r, math *m, const char *link, const sample_side side[3]);

#endif
