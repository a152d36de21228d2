/* SPDX-License-Identifier: GPL-3.0-or-later
**
** references.h - the machines whose forces with springs and friction an independent solver gave, and random
** machines of the three kinds.
*/
#ifndef FOURLINK_REFERENCES_H
#define FOURLINK_REFERENCES_H

#include "samples.h"

/* Alvi's linkage with the masses of the matrix example. */
static inline sample rocker(double degrees)
{
    static const double length[5] = {0, 0.080, 0.020, 0.066, 0.056};
    static const double mass[5] = {0, 0, 0.1, 0.3, 0.25}, k[5] = {0, 0, 0.008, 0.025, 0.020};
    sample s;
    int i;

    memset(&s, 0, sizeof s);
    s.design.kind = FOURLINK_FOUR_BAR;
    for (i = 1; i <= 4; i++) {
        s.design.link[i].length = length[i];
        s.design.link[i].mass = mass[i];
        s.design.link[i].inertia = mass[i] * k[i] * k[i];
    }
    s.design.link[2].cg.x = 0.010;
    s.design.link[3].cg.x = 0.030 * cos(10 * DEG);
    s.design.link[3].cg.y = 0.030 * sin(10 * DEG);
    s.design.link[4].cg.x = 0.028 * cos(5 * DEG);
    s.design.link[4].cg.y = -0.028 * sin(5 * DEG);
    s.design.gravity.y = -9.81;
    s.branch = FOURLINK_OPEN;
    s.crank.theta2 = degrees * DEG;
    s.crank.omega2 = 10.5;
    return s;
}

/* Crank and slotted lever with a force on the lever. */
static inline sample lever(double degrees)
{
    sample s;

    memset(&s, 0, sizeof s);
    s.design.kind = FOURLINK_INVERTED_SLIDER_CRANK;
    s.design.link[1].length = 0.24;
    s.design.link[2].length = 0.12;
    s.design.link[2].mass = 0.8;
    s.design.link[3].mass = 0.3;
    s.design.link[4].mass = 2.5;
    s.design.link[2].inertia = 0.0015;
    s.design.link[3].inertia = 0.00012;
    s.design.link[4].inertia = 0.035;
    s.design.link[2].cg.x = 0.05;
    s.design.link[2].cg.y = 0.004;
    s.design.link[3].cg.x = 0.002;
    s.design.link[3].cg.y = -0.001;
    s.design.link[4].cg.x = 0.21;
    s.design.link[4].cg.y = 0.012;
    s.design.gravity.y = -9.81;
    s.branch = FOURLINK_OPEN;
    s.crank.theta2 = degrees * DEG;
    s.crank.omega2 = 10;
    s.load[0].link = 4;
    s.load[0].at.x = 0.45;
    s.load[0].force.x = -150;
    s.n_loads = 1;
    return s;
}

/* As draw_design, and every third an inverted slider-crank. */
static inline void draw_any(uint64_t *seed, int n, sample *s)
{
    draw_design(seed, n, s);
    if (n % 3 != 2)
        return;
    s->design.kind = FOURLINK_INVERTED_SLIDER_CRANK;
    if (n % 2)
        s->design.link[4].length = 0;
    s->design.offset = uniform(seed, -0.3, 0.3);
    s->design.angle = n % 2 ? 0 : uniform(seed, -3, 3);
}

/* Its motion; a status. */
static inline int move(sample *s)
{
    assert_int_equal(fourlink_prepare(&s->design, &s->mechanism), FOURLINK_OK);
    return fourlink_analyse(&s->mechanism, s->branch, &s->crank, s->load, s->n_loads, &s->state,
                            &s->forces);
}

#endif
