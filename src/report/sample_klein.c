/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_klein.c - Klein's construction in the sample calculation: its lengths by the sides of its
** triangles, velocity and acceleration from them.
*/
#include "mathml.h"
#include "report.h"
#include "sample_klein.h"

/* See mechanics/klein.c.  On the crossed branch the piston is on the other side, so that the signs of OM
** and ON, which are those of v and a in the tables, are the others. */
static void put_lengths(report *r, math *m, const fourlink_klein *klein)
{
    int is_open = r->now.branch == FOURLINK_OPEN;

    math_let(m, "BM", "- { r * cos theta2 | cos theta3 }", klein->BM);
    math_let(m, "OM",
             is_open ? "r * sin theta2 + BM * sin theta3" : "- r * sin theta2 - BM * sin theta3",
             klein->OM);
    math_let(m, "BQ", "{ BM ^2 | l }", klein->BQ);
    math_let(m, "QN", "{ r * sin theta2 + BQ * sin theta3 | cos theta3 }", klein->QN);
    math_let(m, "ON",
             is_open ? "r * cos theta2 + BQ * cos theta3 + QN * sin theta3"
                     : "- r * cos theta2 - BQ * cos theta3 - QN * sin theta3",
             klein->ON);
}

/* The terms with alpha2 are those of the velocities, as v = omega2 OM. */
static void put_readings(report *r, math *m)
{
    int is_open = r->now.branch == FOURLINK_OPEN;
    const fourlink_state *now = &r->now.state;

    math_let(m, "omega3", "{ omega2 * BM | l }", now->link[FOURLINK_COUPLER].omega);
    math_let(m, "vC", is_open ? "- omega2 * OM" : "omega2 * OM",
             now->link[FOURLINK_FOLLOWER].velocity.x);
    math_let(m, "alpha3", "{ omega2 ^2 * QN <alpha2 + alpha2 * BM > | l }",
             now->link[FOURLINK_COUPLER].alpha);
    math_let(m, "aC",
             is_open ? "- omega2 ^2 * ON <alpha2 - alpha2 * OM >"
                     : "omega2 ^2 * ON <alpha2 + alpha2 * OM >",
             now->link[FOURLINK_FOLLOWER].acceleration.x);
}

void sample_put_klein(report *r, math *m)
{
    fourlink_klein klein;

    if (fourlink_klein_construction(&r->v.problem.mechanism, &r->now.state, &klein) != FOURLINK_OK)
        return;
    page_print(m->p,
               "<h3>Klein's construction</h3>\n<p>O is the crankshaft. The line of the rod meets "
               "the perpendicular to the line of stroke through O in M. The circle about B through "
               "M and the circle on the rod as diameter have a common chord, which meets the rod "
               "in Q and the parallel to the line of stroke through O in N. OBM is the polygon of "
               "velocities, OBQN that of accelerations:</p>\n");
    put_lengths(r, m, &klein);
    page_print(m->p, "<p>From them, as above:</p>\n");
    put_readings(r, m);
}
