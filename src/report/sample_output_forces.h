/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_output_forces.h - the forces in outputs in the sample calculation, and what outputs do to the
** links that carry them.
*/
#ifndef FOURLINK_REPORT_SAMPLE_OUTPUT_FORCES_H
#define FOURLINK_REPORT_SAMPLE_OUTPUT_FORCES_H

#include "mathml.h"
#include "report.h"

/* The forces in an output. */
typedef struct sample_pins {
    fourlink_vector FP, FQ, FD; /* N, as NAME.FP, NAME.FQ, NAME.FD */
    double N, M;                /* of the guide of a slider */
} sample_pins;

/* Of all outputs, and what they do to the links that carry them. */
typedef struct sample_carried {
    double b[FOURLINK_MOST_GROUPS]
            [6]; /* what is known of links 5 and 6, with moments about their origins */
    sample_pins pins[FOURLINK_MOST_GROUPS];
    fourlink_vector force[FOURLINK_LINKS]; /* N, of outputs on each link that carries them */
    double
        moment[FOURLINK_LINKS]; /* N m, about its centre of mass, or of 5, 6 ... about its origin */
} sample_carried;

/* With `drives`, what drives is among the loads, if it is not the crank. */
void sample_find_carried(report *r, const fourlink_body bodies[FOURLINK_LINKS], int drives,
                         sample_carried *found);

/* The accelerations of the centres of mass of links 5, 6 ... */
void sample_put_output_centres(report *r, math *m, const fourlink_body bodies[FOURLINK_LINKS]);

/* The forces of all outputs, the last one first. */
void sample_put_output_forces(report *r, math *m, const fourlink_body bodies[FOURLINK_LINKS],
                              const sample_carried *carried);

#endif
