/* SPDX-License-Identifier: GPL-3.0-or-later
**
** mechanisms.h - mechanisms without mass, and their motion, for the tests of kinematics.
*/
#ifndef FOURLINK_MECHANISMS_H
#define FOURLINK_MECHANISMS_H

#include "check.h"
#include "fourlink.h"

static const fourlink_branch branches[2] = {FOURLINK_OPEN, FOURLINK_CROSSED};

static inline fourlink_design design_of(double a, double b, double c, double d)
{
    fourlink_design design;

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_FOUR_BAR;
    design.link[FOURLINK_GROUND].length = d;
    design.link[FOURLINK_CRANK].length = a;
    design.link[FOURLINK_COUPLER].length = b;
    design.link[FOURLINK_FOLLOWER].length = c;
    return design;
}

static inline fourlink_mechanism four_bar(double a, double b, double c, double d)
{
    fourlink_design design = design_of(a, b, c, d);
    fourlink_mechanism mechanism;

    assert_int_equal(fourlink_prepare(&design, &mechanism), FOURLINK_OK);
    return mechanism;
}

static inline fourlink_mechanism slider_crank(double r, double l, double e)
{
    fourlink_mechanism mechanism;
    fourlink_design design;

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_SLIDER_CRANK;
    design.link[2].length = r;
    design.link[3].length = l;
    design.offset = e;
    assert_int_equal(fourlink_prepare(&design, &mechanism), FOURLINK_OK);
    return mechanism;
}

static inline int analyse(const fourlink_mechanism *mechanism, fourlink_branch branch,
                          double theta2, double omega2, double alpha2, fourlink_state *state)
{
    fourlink_crank crank;

    crank.theta2 = theta2;
    crank.omega2 = omega2;
    crank.alpha2 = alpha2;
    return fourlink_analyse(mechanism, branch, &crank, NULL, 0, state, NULL);
}

#endif
