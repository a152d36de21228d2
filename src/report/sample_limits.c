/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_limits.c - the limits of a mechanism in the sample calculation: swing or stroke, time ratio,
** transmission angle.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "mathml.h"
#include "report.h"
#include "sample_limits.h"

static void begin(math *m, const char *words)
{
    page_print(m->p, "<h3>Limits</h3>\n<p>%s</p>\n", words);
}

/* The crank turns by 180 deg + delta and by the rest of a turn between the limits. */
static void put_time_ratio(math *m, double delta, const fourlink_limits *limits)
{
    page_print(m->p, "<p>The time ratio Q, of the two ways at constant speed of the crank:</p>\n");
    math_let(m, "Q",
             delta < 0 ? "{ 180deg - delta | 180deg + delta }"
                       : "{ 180deg + delta | 180deg - delta }",
             limits->time_ratio);
}

/* The triangles ACD with AC = a + b and b - a; the crossed branch is their mirror image. */
static void put_crank_rocker(report *r, math *m, const fourlink_limits *limits)
{
    int is_open = r->now.branch == FOURLINK_OPEN;
    double stretched = is_open ? limits->theta2_min : limits->theta2_max,
           folded = is_open ? limits->theta2_max : limits->theta2_min;
    double delta =
        flk_cycle_beside((is_open ? folded - stretched : stretched - folded) - M_PI, 2 * M_PI);
    double end = is_open ? limits->theta4_min : limits->theta4_max,
           betas = M_PI - fabs(flk_cycle_beside(end, 2 * M_PI));
    double a = r->v.design->link[2].length, b = r->v.design->link[3].length;

    begin(m,
          "Crank and coupler are in line in both limits of the rocker, stretched (s) and folded "
          "(f), with "
          "AC = u. The triangle ACD by the law of cosines, its angle at A and then \316\262 at D:");
    math_let(m, "us", "a + b", a + b);
    math_let(m, "uf", "b - a", b - a);
    math_let(m, "theta2s",
             is_open ? "acos { us ^2 + d ^2 - c ^2 | 2 * us * d }"
                     : "360deg - acos { us ^2 + d ^2 - c ^2 | 2 * us * d }",
             stretched);
    math_let(m, "theta2f",
             is_open ? "180deg + acos { uf ^2 + d ^2 - c ^2 | 2 * uf * d }"
                     : "180deg - acos { uf ^2 + d ^2 - c ^2 | 2 * uf * d }",
             folded);
    math_let(m, "betas", "acos { c ^2 + d ^2 - us ^2 | 2 * c * d }", betas);
    math_let(m, "betaf", "acos { c ^2 + d ^2 - uf ^2 | 2 * c * d }",
             betas - (limits->theta4_max - limits->theta4_min));
    page_print(m->p, "<p>The swing \317\210 of the rocker:</p>\n");
    math_let(m, "psi", "betas - betaf", limits->theta4_max - limits->theta4_min);
    math_let(m, "delta", is_open ? "theta2f - theta2s - 180deg" : "theta2s - theta2f - 180deg",
             delta);
    put_time_ratio(m, delta, limits);
}

/* The angle between coupler and rocker is least, and greatest, where the crank is in line with the ground. */
static void put_transmission(report *r, math *m, const fourlink_limits *limits)
{
    double a = r->v.design->link[2].length, d = r->v.design->link[1].length;

    page_print(
        m->p,
        "<p>The angle \316\263 between coupler and rocker is least and greatest where the crank "
        "is in line with the ground, with BD = f:</p>\n");
    math_let(m, "fmin", "d - a", d - a);
    math_let(m, "fmax", "d + a", d + a);
    math_let(m, "gammamin", "acos { b ^2 + c ^2 - fmin ^2 | 2 * b * c }", limits->gamma_min);
    math_let(m, "gammamax", "acos { b ^2 + c ^2 - fmax ^2 | 2 * b * c }", limits->gamma_max);
}

static void put_piston(report *r, math *m, const fourlink_limits *limits)
{
    double side = (double)r->now.branch;
    double delta = side * flk_cycle_beside(limits->outer - limits->inner - M_PI, 2 * M_PI);

    begin(m, "Crank and rod are in line at both dead centres; the stroke s between them:");
    if (r->v.design->offset == 0) {
        math_let(m, "s", "2 * r", limits->stroke);
        return;
    }
    math_let(m, "s", "[ ( l + r )^2 - e ^2 ] - [ ( l - r )^2 - e ^2 ]", limits->stroke);
    math_let(m, "delta", "asin { e | l - r } - asin { e | l + r }", delta);
    put_time_ratio(m, delta, limits);
}

static void put_lever(math *m, const fourlink_limits *limits)
{
    begin(m, limits->has_swing
                 ? "The crank is at right angles to the lever in both limits; its swing \316\264:"
                 : "A tool on the lever reverses where the lever is at right angles to AD:");
    math_let(m, "delta", limits->has_swing ? "2 * asin { a | d }" : "2 * asin { d | a }",
             M_PI * (limits->time_ratio - 1) / (limits->time_ratio + 1));
    put_time_ratio(m, 1, limits);
}

void sample_put_limits(report *r, math *m)
{
    const fourlink_mechanism *mechanism = &r->v.problem.mechanism;
    fourlink_limits limits;

    fourlink_limits_of(mechanism, r->now.branch, &limits);
    switch (r->v.design->kind) {
    case FOURLINK_FOUR_BAR:
        if (!limits.has_swing)
            return;
        put_crank_rocker(r, m, &limits);
        put_transmission(r, m, &limits);
        return;
    case FOURLINK_SLIDER_CRANK:
        if (limits.stroke > 0)
            put_piston(r, m, &limits);
        return;
    case FOURLINK_INVERTED_SLIDER_CRANK:
        if (limits.time_ratio > 0 && mechanism->h == 0)
            put_lever(m, &limits);
        return;
    case FOURLINK_SCOTCH_YOKE:
        if (limits.stroke > 0) {
            begin(m, "The stroke s of the yoke:");
            math_let(m, "s",
                     sin(r->v.design->angle) < 0 ? "- { 2 * a | sin beta }"
                                                 : "{ 2 * a | sin beta }",
                     limits.stroke);
        }
    }
}
