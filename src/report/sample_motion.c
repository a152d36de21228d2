/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_motion.c - position, velocities and accelerations of the sample calculation, by the loop equation of
** each kind and its derivatives.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "mathml.h"
#include "report.h"
#include "sample_motion.h"

static void put_heading(math *m, const char *words)
{
    page_print(m->p, "<h3>%s</h3>\n", words);
}

static void put_words(math *m, const char *words)
{
    page_print(m->p, "<p>%s</p>\n", words);
}

void sample_put_derived(math *m, int second, const char *words)
{
    int first = second - 1;

    page_print(m->p,
               "<p>Equations (<a href=\"#equation-%d\">%d</a>) and (<a href=\"#equation-%d\">"
               "%d</a>), %s</p>\n",
               first, first, second, second, words);
}

/* Of the last two equations, or of two of some equations before. */
static void put_derived(math *m, int before, const char *words)
{
    sample_put_derived(m, m->p->n_equations - before, words);
}

/* Of what is given, the crank, which all kinds have. */
static void end_given(report *r, math *m)
{
    const fourlink_crank *crank = &r->now.row.crank;

    math_given(m, "theta2", crank->theta2);
    math_given(m, "omega2", crank->omega2);
    math_given(m, "alpha2", crank->alpha2);
    page_print(m->p, "</ul>\n");
    put_heading(m, "Position");
}

/* Write an angle whose equation, with the value `plain`, may need a full turn more or less, so that it is the
** library's, in (-pi, pi]. */
static void let_turned(math *m, const char *name, const char *equation, double plain, double angle)
{
    const char *turn = plain - angle > M_PI    ? " - 360deg"
                       : plain - angle < -M_PI ? " + 360deg"
                                               : "";
    char whole[200];

    flk_text_join(whole, sizeof whole, equation, turn, (char *)NULL);
    math_let(m, name, whole, angle);
}

void sample_put_acceleration_of_B(report *r, math *m)
{
    const fourlink_vector *a = &r->now.state.link[3].acceleration;
    int is_r = r->v.kind.shape[FOURLINK_FOLLOWER] == FOURLINK_SHAPE_BLOCK;

    if (math_has(m, "aBx"))
        return;
    math_let(m, "aBx",
             is_r ? "<alpha2 - r * alpha2 * sin theta2 > - r * omega2 ^2 * cos theta2"
                  : "<alpha2 - a * alpha2 * sin theta2 > - a * omega2 ^2 * cos theta2",
             a->x);
    math_let(m, "aBy",
             is_r ? "<alpha2 r * alpha2 * cos theta2 > - r * omega2 ^2 * sin theta2"
                  : "<alpha2 a * alpha2 * cos theta2 > - a * omega2 ^2 * sin theta2",
             a->y);
}

/* ------------------------------------------------------------------------------ four-bar */

/* The triangle BCD: f = BD, psi the angle of B->D, beta3 and beta4 its angles at B and D. */
static void put_four_bar_position(report *r, math *m)
{
    const fourlink_state *now = &r->now.state;
    const fourlink_vector *B = &now->link[3].origin;
    double a = r->v.design->link[2].length, b = r->v.design->link[3].length;
    double c = r->v.design->link[4].length, d = r->v.design->link[1].length;
    double f = gsl_hypot(d - B->x, B->y), psi = atan2(-B->y, d - B->x),
           side = now->sine > 0 ? 1 : -1;
    double theta3 = now->link[3].theta, theta4 = now->link[4].theta;
    double beta3 = fabs(flk_cycle_beside(theta3 - psi, 2 * M_PI)),
           beta4 = fabs(flk_cycle_beside(psi + M_PI - theta4, 2 * M_PI));

    put_words(m, "Pin B, then the diagonal BD of the loop, its length f and its angle \317\210:");
    math_let(m, "xB", "a * cos theta2", B->x);
    math_let(m, "yB", "a * sin theta2", B->y);
    math_let(m, "f", "[ ( d - xB )^2 + yB ^2 ]", f);
    math_let(m, "psi", "atan2 ( - yB , d - xB )", psi);
    put_words(m, side > 0 ? "The triangle BCD by the law of cosines; C lies to the left of BD:"
                          : "The triangle BCD by the law of cosines; C lies to the right of BD:");
    math_let(m, "beta3", "acos { b ^2 + f ^2 - c ^2 | 2 * b * f }", beta3);
    math_let(m, "beta4", "acos { c ^2 + f ^2 - b ^2 | 2 * c * f }", beta4);
    let_turned(m, "theta3", side > 0 ? "psi + beta3" : "psi - beta3", psi + side * beta3, theta3);
    let_turned(m, "theta4", side > 0 ? "psi + 180deg - beta4" : "psi + 180deg + beta4",
               psi + M_PI - side * beta4, theta4);
    put_words(m, "The loop A, B, C, D closes along x and along y:");
    math_zero(m, "a * cos theta2 + b * cos theta3 - c * cos theta4 - d",
              a * cos(r->now.row.crank.theta2) + b * cos(theta3) - c * cos(theta4) - d,
              a + b + c + d, MATH_LENGTH);
    math_zero(m, "a * sin theta2 + b * sin theta3 - c * sin theta4",
              a * sin(r->now.row.crank.theta2) + b * sin(theta3) - c * sin(theta4), a + b + c + d,
              MATH_LENGTH);
}

/* Alvi, eqs. 4.1 and 4.2 and section 3.3, corrected; see four_bar.c. */
static void put_four_bar(report *r, math *m)
{
    const fourlink_link_state *link = r->now.state.link;

    math_given(m, "a", r->v.design->link[2].length);
    math_given(m, "b", r->v.design->link[3].length);
    math_given(m, "c", r->v.design->link[4].length);
    math_given(m, "d", r->v.design->link[1].length);
    end_given(r, m);
    put_four_bar_position(r, m);
    put_heading(m, "Velocity");
    put_derived(m, 0, "differentiated by time, and solved:");
    math_show(m,
              "- a * omega2 * sin theta2 - b * omega3 * sin theta3 + c * omega4 * sin theta4 = 0");
    math_show(m, "a * omega2 * cos theta2 + b * omega3 * cos theta3 - c * omega4 * cos theta4 = 0");
    math_let(m, "omega3", "{ a * omega2 * sin ( theta4 - theta2 ) | b * sin ( theta3 - theta4 ) }",
             link[3].omega);
    math_let(m, "omega4", "{ a * omega2 * sin ( theta3 - theta2 ) | c * sin ( theta3 - theta4 ) }",
             link[4].omega);
    put_heading(m, "Acceleration");
    put_derived(m, 2, "differentiated once more, and solved:");
    math_let(m, "alpha3",
             "{ <alpha2 a * alpha2 * sin ( theta4 - theta2 ) > - a * omega2 ^2 * cos ( theta4 - "
             "theta2 ) - b * omega3 ^2 * cos ( theta4 - theta3 ) + c * omega4 ^2 | "
             "b * sin ( theta3 - theta4 ) }",
             link[3].alpha);
    math_let(m, "alpha4",
             "{ <alpha2 a * alpha2 * sin ( theta3 - theta2 ) > - a * omega2 ^2 * cos ( theta3 - "
             "theta2 ) - b * omega3 ^2 + c * omega4 ^2 * cos ( theta3 - theta4 ) | "
             "c * sin ( theta3 - theta4 ) }",
             link[4].alpha);
}

/* ------------------------------------------------------------------------------ slider-crank */

static void put_from_dead_centre(report *r, math *m)
{
    page_print(m->p,
               "<p>In the tables the %s is counted from its inner dead centre: x = %.6g%U, "
               "v = %.6g%U, a = %.6g%U.</p>\n",
               r->v.kind.link[4], math_shown(m, r->now.state.x, MATH_LENGTH),
               m->units.of[MATH_LENGTH].name, math_shown(m, r->now.state.v, MATH_SPEED),
               m->units.of[MATH_SPEED].name, math_shown(m, r->now.state.a, MATH_ACCELERATION),
               m->units.of[MATH_ACCELERATION].name);
}

static void put_slider_crank_position(report *r, math *m)
{
    const fourlink_state *now = &r->now.state;
    double a = r->v.design->link[2].length, l = r->v.design->link[3].length,
           e = r->v.design->offset;
    double theta2 = r->now.row.crank.theta2, theta3 = now->link[3].theta;
    double phi = asin(GSL_MAX_DBL(-1, GSL_MIN_DBL(1, (e - a * sin(theta2)) / l)));

    if (now->sine > 0)
        math_let(m, "theta3", "asin { <e e > - r * sin theta2 | l }", theta3);
    else
        let_turned(m, "theta3", "180deg - asin { <e e > - r * sin theta2 | l }", M_PI - phi,
                   theta3);
    math_let(m, "xC", "r * cos theta2 + l * cos theta3", now->link[4].origin.x);
    put_words(m, "The loop closes at right angles to the line of stroke:");
    math_zero(m, "r * sin theta2 + l * sin theta3 <e - e >", a * sin(theta2) + l * sin(theta3) - e,
              a + l + fabs(e), MATH_LENGTH);
}

/* DFA, eq. 1, and its derivatives; see slider_crank.c. */
static void put_slider_crank(report *r, math *m)
{
    const fourlink_link_state *link = r->now.state.link;

    math_given(m, "r", r->v.design->link[2].length);
    math_given(m, "l", r->v.design->link[3].length);
    math_given(m, "e", r->v.design->offset);
    end_given(r, m);
    put_words(m,
              "x runs along the line of stroke; \316\270\342\202\203 is the angle of the rod from "
              "crank pin B to piston C:");
    put_slider_crank_position(r, m);
    put_heading(m, "Velocity");
    put_derived(m, 0, "differentiated by time:");
    math_let(m, "omega3", "- { r * omega2 * cos theta2 | l * cos theta3 }", link[3].omega);
    math_let(m, "vC", "- r * omega2 * sin theta2 - l * omega3 * sin theta3", link[4].velocity.x);
    put_heading(m, "Acceleration");
    put_derived(m, 0, "differentiated once more:");
    math_let(m, "alpha3",
             "{ <alpha2 - r * alpha2 * cos theta2 > + r * omega2 ^2 * sin theta2 + l * omega3 ^2 * "
             "sin theta3 | l * cos theta3 }",
             link[3].alpha);
    math_let(m, "aC",
             "<alpha2 - r * alpha2 * sin theta2 > - r * omega2 ^2 * cos theta2 - l * alpha3 * sin "
             "theta3 - l * omega3 ^2 * cos theta3",
             link[4].acceleration.x);
    put_from_dead_centre(r, m);
}

/* ------------------------------------------------------------------------------ inverted */

static void put_inverted_position(report *r, math *m)
{
    const fourlink_state *now = &r->now.state;
    double a = r->v.design->link[2].length, d = r->v.design->link[1].length,
           h = r->v.problem.mechanism.h;
    double theta2 = r->now.row.crank.theta2, theta3 = now->link[3].theta, s = now->s;
    const fourlink_vector *B = &now->link[3].origin;

    put_words(m, "From D to pin B:");
    math_let(m, "rx", "a * cos theta2 - d", B->x - d);
    math_let(m, "ry", "a * sin theta2", B->y);
    math_let(m, "f", "[ rx ^2 + ry ^2 ]", gsl_hypot(B->x - d, B->y));
    put_words(m, "s runs along the slide from the foot of the perpendicular from D, whose length "
                 "is h; \316\270\342\202\203 is the angle of the slide:");
    math_let(m, "s", s > 0 ? "[ f ^2 - h ^2 ]" : "- [ f ^2 - h ^2 ]", s);
    math_let(m, "theta3", "atan2 ( s * ry <h - h * rx > , s * rx <h + h * ry > )", theta3);
    let_turned(m, "theta4", "theta3 <gamma - gamma >", theta3 - r->v.design->angle,
               now->link[4].theta);
    put_words(m, "The loop A, B, D closes along x and along y:");
    math_zero(m, "a * cos theta2 - d - s * cos theta3 <h + h * sin theta3 >",
              a * cos(theta2) - d - s * cos(theta3) + h * sin(theta3), a + d, MATH_LENGTH);
    math_zero(m, "a * sin theta2 - s * sin theta3 <h - h * cos theta3 >",
              a * sin(theta2) - s * sin(theta3) - h * cos(theta3), a + d, MATH_LENGTH);
}

static void give_slide(report *r, math *m)
{
    double c = r->v.design->link[4].length, h = r->v.problem.mechanism.h;

    math_given(m, "a", r->v.design->link[2].length);
    math_given(m, "d", r->v.design->link[1].length);
    math_set(m, "gamma", 0);
    if (c > 0) {
        math_given(m, "c", c);
        math_given(m, "gamma", r->v.design->angle);
    }
    math_given(m, "h", h);
}

/* See inverted.c. */
static void put_inverted(report *r, math *m)
{
    const fourlink_state *now = &r->now.state;

    give_slide(r, m);
    end_given(r, m);
    put_inverted_position(r, m);
    put_heading(m, "Velocity");
    put_words(m, "Slider and lever turn together.");
    put_derived(m, 0, "differentiated by time, across the slide and along it:");
    math_let(m, "omega3", "{ a * omega2 * cos ( theta3 - theta2 ) | s }", now->link[3].omega);
    math_let(m, "sdot", "a * omega2 * sin ( theta3 - theta2 ) <h + h * omega3 >", now->slide_v);
    put_heading(m, "Acceleration");
    put_derived(m, 0,
                "differentiated once more; the third line is the Coriolis acceleration of B:");
    math_let(m, "alpha3",
             "{ <alpha2 a * alpha2 * cos ( theta3 - theta2 ) > + a * omega2 ^2 * sin ( theta3 - "
             "theta2 ) - 2 * sdot * omega3 <h + h * omega3 ^2 > | s }",
             now->link[3].alpha);
    math_let(m, "sddot",
             "<alpha2 a * alpha2 * sin ( theta3 - theta2 ) > - a * omega2 ^2 * cos ( theta3 - "
             "theta2 ) <h + h * alpha3 > + s * omega3 ^2",
             now->slide_a);
    math_let(m, "acor", "2 * omega3 * sdot", now->coriolis);
}

/* ------------------------------------------------------------------------------ Scotch yoke */

static void put_yoke_position(report *r, math *m)
{
    const fourlink_state *now = &r->now.state;
    double a = r->v.design->link[2].length, e = r->v.design->offset, beta = r->v.design->angle;
    double theta2 = r->now.row.crank.theta2, s = now->s, X = now->link[4].origin.x;

    put_words(m, "s runs along the slot from C, where its line meets the line of the guide; x "
                 "along the guide:");
    math_let(m, "s", "{ a * sin theta2 <e - e > | sin beta }", s);
    math_let(m, "xC", "a * cos theta2 - s * cos beta", X);
    put_words(m, "The loop A, B, C closes along x and along y:");
    math_zero(m, "a * cos theta2 - s * cos beta - xC", a * cos(theta2) - s * cos(beta) - X,
              a + fabs(s), MATH_LENGTH);
    math_zero(m, "a * sin theta2 - s * sin beta <e - e >", a * sin(theta2) - s * sin(beta) - e,
              a + fabs(s), MATH_LENGTH);
}

/* See scotch_yoke.c. */
static void put_yoke(report *r, math *m)
{
    const fourlink_state *now = &r->now.state;

    math_given(m, "a", r->v.design->link[2].length);
    math_given(m, "beta", r->v.design->angle);
    math_given(m, "e", r->v.design->offset);
    end_given(r, m);
    put_yoke_position(r, m);
    put_heading(m, "Velocity");
    put_words(m, "Block and yoke do not turn.");
    put_derived(m, 0, "differentiated by time:");
    math_let(m, "sdot", "{ a * omega2 * cos theta2 | sin beta }", now->slide_v);
    math_let(m, "vC", "- a * omega2 * sin theta2 - sdot * cos beta", now->link[4].velocity.x);
    put_heading(m, "Acceleration");
    put_derived(m, 0, "differentiated once more:");
    math_let(m, "sddot",
             "{ <alpha2 a * alpha2 * cos theta2 > - a * omega2 ^2 * sin theta2 | sin beta }",
             now->slide_a);
    math_let(m, "aC",
             "<alpha2 - a * alpha2 * sin theta2 > - a * omega2 ^2 * cos theta2 - sddot * cos beta",
             now->link[4].acceleration.x);
    put_from_dead_centre(r, m);
}

void sample_put_motion(report *r, math *m)
{
    put_heading(m, "Given");
    page_print(m->p, "<ul class=\"given\">\n");
    switch (r->v.design->kind) {
    case FOURLINK_FOUR_BAR:
        put_four_bar(r, m);
        break;
    case FOURLINK_SLIDER_CRANK:
        put_slider_crank(r, m);
        break;
    case FOURLINK_INVERTED_SLIDER_CRANK:
        put_inverted(r, m);
        break;
    case FOURLINK_SCOTCH_YOKE:
        put_yoke(r, m);
    }
}
