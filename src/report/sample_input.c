/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_input.c - in the sample calculation, how another coordinate that is prescribed gives the crank's
** motion.
**
** The loop equation of each kind is solved for the crank angle, and with K = dq/dtheta2 and L = d2q/dtheta2^2
**
**    dq/dt = K omega2,   d2q/dt2 = K alpha2 + L omega2^2
**
** K and L are velocity and acceleration for omega2 = 1 and alpha2 = 0.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/text.h"
#include "mathml.h"
#include "report.h"
#include "sample_input.h"

/* The symbols of a coordinate, its rates and its derivatives by theta2, and the values of these rates. */
typedef struct coordinate {
    const char *name, *rate, *second, *K, *L;
    double at_rate, at_second;
} coordinate;

/* Velocities and accelerations of the links in the same position, at unit speed of the crank. */
static int find_unit(const report *r, fourlink_state *at_one)
{
    const fourlink_mechanism *mechanism = &r->v.problem.mechanism;

    *at_one = r->now.state;
    return fourlink_velocity(mechanism, 1, at_one) == FOURLINK_OK &&
           fourlink_acceleration(mechanism, 0, at_one) == FOURLINK_OK;
}

/* Write theta2 = EQUATION, whose value may be whole turns beside the angle of the crank. */
static void let_crank(report *r, math *m, const char *equation, double plain)
{
    double theta2 = r->now.row.crank.theta2, turns = floor((theta2 - plain) / (2 * M_PI) + 0.5);
    char whole[MATH_EQUATION], number[FORMAT_SIZE];

    flk_text_join(whole, sizeof whole, equation, (char *)NULL);
    if (turns != 0)
        flk_text_join(whole + strlen(whole), sizeof whole - strlen(whole),
                      turns > 0 ? " + " : " - ", format_general(fabs(360 * turns), 9, number),
                      "deg", (char *)NULL);
    math_let(m, "theta2", whole, theta2);
}

/* Write theta2 = psi + beta or psi - beta, of which one is the crank's. */
static void let_either(report *r, math *m, const char *with_plus, double plus,
                       const char *with_minus, double minus)
{
    double theta2 = r->now.row.crank.theta2;
    int is_plus = fabs(flk_cycle_beside(theta2 - plus, 2 * M_PI)) <=
                  fabs(flk_cycle_beside(theta2 - minus, 2 * M_PI));

    let_crank(r, m, is_plus ? with_plus : with_minus, is_plus ? plus : minus);
}

static double angle_of(double cosine)
{
    return acos(GSL_MAX_DBL(-1, GSL_MIN_DBL(1, cosine)));
}

static void put_heading_of_rates(math *m)
{
    page_print(m->p, "<p>K and L are the first and the second derivative by \316\270\342\202\202:"
                     "</p>\n");
}

/* The triangle ABC: f = AC, psi its direction. */
static void put_triangle(report *r, math *m, const fourlink_vector *C, const char *f,
                         const char *psi, const char *beta, double rod)
{
    double a = r->v.design->link[FOURLINK_CRANK].length, AC = gsl_hypot(C->x, C->y);
    double of_AC = atan2(C->y, C->x), of_B = angle_of((a * a + AC * AC - rod * rod) / (2 * a * AC));

    math_let(m, "fA", f, AC);
    math_let(m, "psiA", psi, of_AC);
    math_let(m, "betaA", beta, of_B);
    let_either(r, m, "psiA + betaA", of_AC + of_B, "psiA - betaA", of_AC - of_B);
}

/* ------------------------------------------------------------------------------ four-bar */

static void put_rocker_of_four_bar(report *r, math *m, const fourlink_state *at_one)
{
    const fourlink_design *design = r->v.design;
    double theta4 = r->now.state.link[4].theta, c = design->link[4].length;
    fourlink_vector C;

    C.x = design->link[1].length + c * cos(theta4);
    C.y = c * sin(theta4);
    page_print(m->p,
               "<p>Pin C, and the triangle ABC by the law of cosines, with f = AC, its direction "
               "\317\210 and its angle \316\262 at A:</p>\n");
    math_let(m, "xC", "d + c * cos theta4", C.x);
    math_let(m, "yC", "c * sin theta4", C.y);
    put_triangle(r, m, &C, "[ xC ^2 + yC ^2 ]", "atan2 ( yC , xC )",
                 "acos { a ^2 + fA ^2 - b ^2 | 2 * a * fA }", design->link[3].length);
    put_heading_of_rates(m);
    math_let(m, "K3", "{ a * sin ( theta4 - theta2 ) | b * sin ( theta3 - theta4 ) }",
             at_one->link[3].omega);
    math_let(m, "K4", "{ a * sin ( theta3 - theta2 ) | c * sin ( theta3 - theta4 ) }",
             at_one->link[4].omega);
    math_let(m, "L4",
             "{ - a * cos ( theta3 - theta2 ) - b * K3 ^2 + c * K4 ^2 * cos ( theta3 - theta4 ) | "
             "c * sin ( theta3 - theta4 ) }",
             at_one->link[4].alpha);
}

/* ---------------------------------------------------------------------------- slider-crank, Scotch yoke */

/* Where x is prescribed, from the inner dead centre. */
static void put_pin_of_displacement(report *r, math *m, int is_displacement)
{
    int is_open = r->now.branch == FOURLINK_OPEN;

    if (!is_displacement)
        return;
    page_print(m->p, "<p>The inner dead centre is at x<sub>0</sub>:</p>\n<ul class=\"given\">\n");
    math_given(m, "x0", r->v.problem.mechanism.dead_centre);
    math_given(m, "x", r->now.state.x);
    page_print(m->p, "</ul>\n");
    math_let(m, "xC", is_open ? "x0 - x" : "x - x0", r->now.state.link[4].origin.x);
}

static void put_piston(report *r, math *m, const fourlink_state *at_one)
{
    const fourlink_design *design = r->v.design;
    fourlink_vector C = r->now.state.link[4].origin;

    page_print(m->p,
               "<p>The triangle ABC by the law of cosines, with f = AC, its direction \317\210 and "
               "its angle \316\262 at A:</p>\n");
    put_triangle(r, m, &C, "[ xC ^2 + e ^2 ]", "atan2 ( e , xC )",
                 "acos { r ^2 + fA ^2 - l ^2 | 2 * r * fA }", design->link[3].length);
    put_heading_of_rates(m);
    math_let(m, "K3", "- { r * cos theta2 | l * cos theta3 }", at_one->link[3].omega);
    math_let(m, "KC", "- r * sin theta2 - l * K3 * sin theta3", at_one->link[4].velocity.x);
    math_let(m, "L3", "{ r * sin theta2 + l * K3 ^2 * sin theta3 | l * cos theta3 }",
             at_one->link[3].alpha);
    math_let(m, "LC", "- r * cos theta2 - l * L3 * sin theta3 - l * K3 ^2 * cos theta3",
             at_one->link[4].acceleration.x);
}

static void put_yoke(report *r, math *m, const fourlink_state *at_one)
{
    double a = r->v.design->link[2].length, e = r->v.design->offset, beta = r->v.design->angle;
    double sine = (r->now.state.link[4].origin.x * sin(beta) - e * cos(beta)) / a;
    double angle = M_PI_2 - angle_of(sine);

    page_print(m->p, "<p>The loop equations without s, solved for \316\270\342\202\202:</p>\n");
    let_either(r, m, "beta - asin { xC * sin beta <e - e * cos beta > | a }", beta - angle,
               "beta - 180deg + asin { xC * sin beta <e - e * cos beta > | a }",
               beta - M_PI + angle);
    put_heading_of_rates(m);
    math_let(m, "Ks", "{ a * cos theta2 | sin beta }", at_one->slide_v);
    math_let(m, "KC", "- a * sin theta2 - Ks * cos beta", at_one->link[4].velocity.x);
    math_let(m, "Ls", "- { a * sin theta2 | sin beta }", at_one->slide_a);
    math_let(m, "LC", "- a * cos theta2 - Ls * cos beta", at_one->link[4].acceleration.x);
}

/* ------------------------------------------------------------------------------ inverted */

static void put_rates_of_lever(math *m, const fourlink_state *at_one)
{
    put_heading_of_rates(m);
    math_let(m, "K3", "{ a * cos ( theta3 - theta2 ) | s }", at_one->link[3].omega);
    math_let(m, "Ks", "a * sin ( theta3 - theta2 ) <h + h * K3 >", at_one->slide_v);
    math_let(m, "L3", "{ a * sin ( theta3 - theta2 ) - 2 * Ks * K3 <h + h * K3 ^2 > | s }",
             at_one->link[3].alpha);
}

static void put_slide(report *r, math *m, const fourlink_state *at_one)
{
    double a = r->v.design->link[2].length, d = r->v.design->link[1].length,
           h = r->v.problem.mechanism.h, f = gsl_hypot(r->now.state.s, h);
    double of_B = angle_of((a * a + d * d - f * f) / (2 * a * d));

    page_print(m->p,
               "<p>The triangle ABD by the law of cosines, with f = BD and its angle \316\262 at "
               "A:</p>\n");
    math_let(m, "f", "[ s ^2 + h ^2 ]", f);
    math_let(m, "betaA", "acos { a ^2 + d ^2 - f ^2 | 2 * a * d }", of_B);
    let_either(r, m, "betaA", of_B, "- betaA", -of_B);
    put_rates_of_lever(m, at_one);
    math_let(m, "Ls", "- a * cos ( theta3 - theta2 ) <h + h * L3 > + s * K3 ^2", at_one->slide_a);
}

static void put_lever(report *r, math *m, const fourlink_state *at_one)
{
    double a = r->v.design->link[2].length, d = r->v.design->link[1].length;
    double theta3 = r->now.state.link[3].theta, h = r->v.problem.mechanism.h;
    double angle = M_PI_2 - angle_of((h - d * sin(theta3)) / a);

    page_print(m->p, "<p>The loop equations without s, solved for \316\270\342\202\202:</p>\n");
    let_either(r, m, "theta3 + asin { <h h > - d * sin theta3 | a }", theta3 + angle,
               "theta3 + 180deg - asin { <h h > - d * sin theta3 | a }", theta3 + M_PI - angle);
    put_rates_of_lever(m, at_one);
}

/* ------------------------------------------------------------------------------ all */

/* The crank's speed and acceleration from those of the coordinate. */
static void put_rates(report *r, math *m, const coordinate *q)
{
    const fourlink_crank *crank = &r->now.row.crank;
    char equation[MATH_EQUATION];

    if (q->at_rate == 0 && q->at_second == 0)
        return;
    math_set(m, q->rate, q->at_rate);
    math_set(m, q->second, q->at_second);
    page_print(m->p, "<p>Speed and acceleration of the crank:</p>\n");
    flk_text_join(equation, sizeof equation, "{ ", q->rate, " | ", q->K, " }", (char *)NULL);
    math_let(m, "omega2", equation, crank->omega2);
    flk_text_join(equation, sizeof equation, "{ ", q->second, " - ", q->L, " * omega2 ^2 | ", q->K,
                  " }", (char *)NULL);
    math_let(m, "alpha2", equation, crank->alpha2);
}

/* 1 for an input from which the crank follows in closed form by what is written here. */
static int is_known(const char *name)
{
    static const char *const known[] = {"theta4", "x", "C.x", "slide"};
    size_t k;

    for (k = 0; k < sizeof known / sizeof known[0]; k++)
        if (strcmp(name, known[k]) == 0)
            return 1;
    return 0;
}

void sample_put_input(report *r, math *m)
{
    static const coordinate of_piston = {"xC", "vC", "aC", "KC", "LC", 0, 0},
                            of_rocker = {"theta4", "omega4", "alpha4", "K4", "L4", 0, 0},
                            of_lever = {"theta3", "omega3", "alpha3", "K3", "L3", 0, 0},
                            of_slide = {"s", "sdot", "sddot", "Ks", "Ls", 0, 0};
    const char *name = view_input(&r->v);
    const fourlink_state *now = &r->now.state;
    fourlink_state at_one;
    coordinate q;
    int is_slide;

    if (!name || !is_known(name) || !find_unit(r, &at_one))
        return;
    is_slide = strcmp(name, "slide") == 0;
    page_print(m->p,
               "<h3>Crank from the input</h3>\n<p>The deck prescribes %s; that the crank moves "
               "as given above follows from it.</p>\n",
               is_slide ? "the slide" : name);
    switch (r->v.design->kind) {
    case FOURLINK_FOUR_BAR:
        q = of_rocker;
        q.at_rate = now->link[4].omega;
        q.at_second = now->link[4].alpha;
        put_rocker_of_four_bar(r, m, &at_one);
        break;
    case FOURLINK_INVERTED_SLIDER_CRANK:
        q = is_slide ? of_slide : of_lever;
        q.at_rate = is_slide ? now->slide_v : now->link[3].omega;
        q.at_second = is_slide ? now->slide_a : now->link[3].alpha;
        (is_slide ? put_slide : put_lever)(r, m, &at_one);
        break;
    default:
        q = of_piston;
        q.at_rate = now->link[4].velocity.x;
        q.at_second = now->link[4].acceleration.x;
        put_pin_of_displacement(r, m, strcmp(name, "x") == 0);
        (r->v.kind.has_one_branch ? put_yoke : put_piston)(r, m, &at_one);
    }
    put_rates(r, m, &q);
}
