/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample.c - the sample calculation of a report, as a textbook writes it.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mathml.h"
#include "report.h"
#include "sample_forces.h"
#include "sample_motion.h"

/* The sizes of values: what the crank alone would have, and the largest pin force. */
static void set_sizes(const report *r, math *m)
{
    const fourlink_crank *crank = &r->now.row.crank;
    double a = r->v.design->link[FOURLINK_CRANK].length, omega = fabs(crank->omega2), force = 0;
    double alpha = GSL_MAX_DBL(omega * omega, fabs(crank->alpha2)), x[9];
    int i;

    fourlink_unknowns(r->v.mechanism, &r->now.forces, x);
    for (i = 0; i < 8; i++)
        force = GSL_MAX_DBL(force, fabs(x[i]));
    m->size[MATH_M] = a;
    m->size[MATH_RAD_S] = omega;
    m->size[MATH_RAD_S2] = alpha;
    m->size[MATH_M_S] = omega * a;
    m->size[MATH_M_S2] = alpha * a;
    m->size[MATH_N] = r->v.problem.has_forces ? force : 0;
    m->size[MATH_NM] = r->v.problem.has_forces ? force * a : 0;
}

void report_put_sample(report *r)
{
    page *p = &r->page;
    math m;

    if (r->now.status != FOURLINK_OK) {
        page_print(p, "<p>At \316\270\342\202\202 = %s there is none: %s.</p>\n", r->at,
                   fourlink_status_text(r->now.status));
        return;
    }
    if (*r->why)
        page_print(p, "<p>Chosen position: %s.</p>\n", r->why);
    memset(&m, 0, sizeof m);
    m.p = p;
    set_sizes(r, &m);
    page_print(p,
               "<p>At \316\270\342\202\202 = %s, %s branch, in SI units; angles and torques are "
               "positive counter-clockwise.  Numbers are computed with 16 digits and printed with "
               "%d, angles with four decimals.</p>\n",
               r->at, fourlink_branch_text((int)r->now.branch), MATH_DIGITS);
    sample_put_motion(r, &m);
    if (r->v.problem.has_forces)
        sample_put_forces(r, &m);
    else
        page_print(p, "<p>The deck has no masses and no loads, so there are no forces.</p>\n");
}
