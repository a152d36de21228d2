/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_output_type.c - the loops of outputs of each type and their derivatives in the sample calculation,
** as in mechanics/group_rod.c and group_slot.c.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/text.h"
#include "sample_output_type.h"

static double cross(fourlink_vector u, fourlink_vector v)
{
    return u.x * v.y - u.y * v.x;
}

static void put_line(const sample_output *o, const char *words)
{
    page_print(o->m->p, "<p>%s</p>\n", words);
}

/* Write an angle, which may need a full turn more or less. */
static void let_angle(const sample_output *o, const char *name, const char *equation, double plain,
                      double angle)
{
    const char *turn = plain - angle > M_PI    ? " - 360deg"
                       : plain - angle < -M_PI ? " + 360deg"
                                               : "";
    char whole[SAMPLE_EQUATION];

    flk_text_join(whole, sizeof whole, equation, turn, (char *)NULL);
    sample_output_let(o, name, whole, angle);
}

static void put_loop(const sample_output *o, const char *x, const char *y, fourlink_vector gap,
                     double size)
{
    char equation[SAMPLE_EQUATION];

    put_line(o, "The loop closes along x and along y:");
    math_zero(o->m, sample_output_words(o, x, equation), gap.x, size, MATH_LENGTH);
    math_zero(o->m, sample_output_words(o, y, equation), gap.y, size, MATH_LENGTH);
}

/* From P along link 5 by `first`, less link 6 by `second`, from D. */
static fourlink_vector gap_of(const sample_hung *now, double first, double second)
{
    fourlink_vector gap;

    gap.x = now->P.place.x + first * now->rod->axis.x - second * now->end->axis.x - now->D.place.x;
    gap.y = now->P.place.y + first * now->rod->axis.y - second * now->end->axis.y - now->D.place.y;
    return gap;
}

static double size_of(const sample_hung *now, double first, double second)
{
    return fabs(first) + fabs(second) + gsl_hypot(now->P.place.x, now->P.place.y) +
           gsl_hypot(now->D.place.x, now->D.place.y);
}

static double bounded(double x)
{
    return GSL_MAX_DBL(-1, GSL_MIN_DBL(1, x));
}

/* P - D, or from the point of the line. */
static fourlink_vector from_D(const sample_hung *now)
{
    fourlink_vector d;

    d.x = now->P.place.x - now->D.place.x;
    d.y = now->P.place.y - now->D.place.y;
    return d;
}

/* ---- slider, rod */

static void place_slider(const sample_output *o, const sample_hung *now)
{
    double l = o->group->rod, h = cross(now->end->axis, from_D(now)), phi = asin(bounded(h / l));

    put_line(o, "P lies at the distance h to the left of the line of stroke. s is the place of Q "
                "along the line, from its point 0:");
    sample_output_let(o, "hP", "( yP - y0 ) * cos theta6 - ( xP - x0 ) * sin theta6", h);
    if (o->group->side > 0)
        let_angle(o, "theta5", "theta6 - asin { hP | l5 }", now->end->theta - phi, now->rod->theta);
    else
        let_angle(o, "theta5", "theta6 + 180deg + asin { hP | l5 }", now->end->theta + M_PI + phi,
                  now->rod->theta);
    sample_output_let(
        o, "s6",
        "( xP - x0 ) * cos theta6 + ( yP - y0 ) * sin theta6 + l5 * cos ( theta5 - theta6 )",
        now->s6);
    put_loop(o, "xP + l5 * cos theta5 - s6 * cos theta6 - x0",
             "yP + l5 * sin theta5 - s6 * sin theta6 - y0", gap_of(now, l, now->s6),
             size_of(now, l, now->s6));
}

static void move_slider(const sample_output *o, const sample_hung *now)
{
    sample_output_let(o, "omega5",
                      "{ vPx * sin theta6 - vPy * cos theta6 | l5 * cos ( theta5 - theta6 ) }",
                      now->rod->omega);
    sample_output_let(o, "sdot6",
                      "vPx * cos theta6 + vPy * sin theta6 - l5 * omega5 * sin ( theta5 - theta6 )",
                      now->sdot6);
}

static void accelerate_slider(const sample_output *o, const sample_hung *now)
{
    sample_output_let(o, "alpha5",
                      "{ aPx * sin theta6 - aPy * cos theta6 + l5 * omega5 ^2 * sin ( theta5 - "
                      "theta6 ) | l5 * cos ( theta5 - theta6 ) }",
                      now->rod->alpha);
    sample_output_let(o, "sddot6",
                      "aPx * cos theta6 + aPy * sin theta6 - l5 * alpha5 * sin ( theta5 - theta6 ) "
                      "- l5 * omega5 ^2 * cos ( theta5 - theta6 )",
                      now->sddot6);
}

/* ---- rocker, rod */

static void place_rocker(const sample_output *o, const sample_hung *now)
{
    double l = o->group->rod, r = o->group->length, side = o->group->side;
    fourlink_vector d = from_D(now);
    double psi = atan2(-d.y, -d.x);
    double beta5 = fabs(flk_cycle_beside(now->rod->theta - psi, 2 * M_PI)),
           beta6 = fabs(flk_cycle_beside(psi + M_PI - now->end->theta, 2 * M_PI));

    put_line(o, "From P to the pin D of the rocker:");
    sample_output_let(o, "f5", "[ ( xD6 - xP )^2 + ( yD6 - yP )^2 ]", gsl_hypot(d.x, d.y));
    sample_output_let(o, "psi5", "atan2 ( yD6 - yP , xD6 - xP )", psi);
    put_line(o, side > 0 ? "The triangle PQD by the law of cosines; Q lies to the left of PD:"
                         : "The triangle PQD by the law of cosines; Q lies to the right of PD:");
    sample_output_let(o, "beta5", "acos { l5 ^2 + f5 ^2 - r6 ^2 | 2 * l5 * f5 }", beta5);
    sample_output_let(o, "beta6", "acos { r6 ^2 + f5 ^2 - l5 ^2 | 2 * r6 * f5 }", beta6);
    let_angle(o, "theta5", side > 0 ? "psi5 + beta5" : "psi5 - beta5", psi + side * beta5,
              now->rod->theta);
    let_angle(o, "theta6", side > 0 ? "psi5 + 180deg - beta6" : "psi5 + 180deg + beta6",
              psi + M_PI - side * beta6, now->end->theta);
    put_loop(o, "xP + l5 * cos theta5 - r6 * cos theta6 - xD6",
             "yP + l5 * sin theta5 - r6 * sin theta6 - yD6", gap_of(now, l, r), size_of(now, l, r));
}

static void move_rocker(const sample_output *o, const sample_hung *now)
{
    if (sample_output_floats(o->group)) {
        sample_output_let(o, "vEx", "vPx - vD6x", now->P.velocity.x - now->D.velocity.x);
        sample_output_let(o, "vEy", "vPy - vD6y", now->P.velocity.y - now->D.velocity.y);
    }
    sample_output_let(o, "omega5",
                      "- { vEx * cos theta6 + vEy * sin theta6 | l5 * sin ( theta6 - theta5 ) }",
                      now->rod->omega);
    sample_output_let(o, "omega6",
                      "- { vEx * cos theta5 + vEy * sin theta5 | r6 * sin ( theta6 - theta5 ) }",
                      now->end->omega);
}

static void accelerate_rocker(const sample_output *o, const sample_hung *now)
{
    if (sample_output_floats(o->group)) {
        sample_output_let(o, "aEx", "aPx - aD6x", now->P.acceleration.x - now->D.acceleration.x);
        sample_output_let(o, "aEy", "aPy - aD6y", now->P.acceleration.y - now->D.acceleration.y);
    }
    sample_output_let(o, "alpha5",
                      "{ l5 * omega5 ^2 * cos ( theta6 - theta5 ) - r6 * omega6 ^2 - aEx * cos "
                      "theta6 - aEy * sin theta6 | l5 * sin ( theta6 - theta5 ) }",
                      now->rod->alpha);
    sample_output_let(o, "alpha6",
                      "{ l5 * omega5 ^2 - r6 * omega6 ^2 * cos ( theta6 - theta5 ) - aEx * cos "
                      "theta5 - aEy * sin theta5 | r6 * sin ( theta6 - theta5 ) }",
                      now->end->alpha);
}

/* ---- slider, slot of its own */

static void place_slider_with_slot(const sample_output *o, const sample_hung *now)
{
    put_line(o, "The slot does not turn. Q is where it meets the line of stroke; s<sub>6</sub> is "
                "the place of Q along the line from its point 0, s<sub>5</sub> that of P along the "
                "slot from Q:");
    let_angle(o, "theta5", "theta6 + beta5",
              now->end->theta + atan2(o->group->slot.y, o->group->slot.x), now->rod->theta);
    sample_output_let(
        o, "s6",
        "{ ( xP - x0 ) * sin theta5 - ( yP - y0 ) * cos theta5 | sin ( theta5 - theta6 ) }",
        now->s6);
    sample_output_let(
        o, "s5",
        "{ ( yP - y0 ) * cos theta6 - ( xP - x0 ) * sin theta6 | sin ( theta5 - theta6 ) }",
        now->s5);
    put_loop(o, "xP - s5 * cos theta5 - s6 * cos theta6 - x0",
             "yP - s5 * sin theta5 - s6 * sin theta6 - y0", gap_of(now, -now->s5, now->s6),
             size_of(now, now->s5, now->s6));
}

static void move_slider_with_slot(const sample_output *o, const sample_hung *now)
{
    sample_output_let(o, "sdot6",
                      "{ vPx * sin theta5 - vPy * cos theta5 | sin ( theta5 - theta6 ) }",
                      now->sdot6);
    sample_output_let(o, "sdot5",
                      "{ vPy * cos theta6 - vPx * sin theta6 | sin ( theta5 - theta6 ) }",
                      now->sdot5);
}

static void accelerate_slider_with_slot(const sample_output *o, const sample_hung *now)
{
    sample_output_let(o, "sddot6",
                      "{ aPx * sin theta5 - aPy * cos theta5 | sin ( theta5 - theta6 ) }",
                      now->sddot6);
}

/* ---- slider in a slot of the carrying link */

static void let_slot_of_link(const sample_output *o, const sample_hung *now)
{
    double beta = atan2(o->group->slot.y, o->group->slot.x);

    put_line(o, "The angle of the slot, which turns with the link; s<sub>5</sub> is the place of Q "
                "along it from P:");
    let_angle(o, "theta5", "thetak + beta5",
              flk_cycle_beside(o->r->now.state.link[o->group->link].theta, 2 * M_PI) + beta,
              now->rod->theta);
}

static void place_slider_in_slot(const sample_output *o, const sample_hung *now)
{
    let_slot_of_link(o, now);
    sample_output_let(
        o, "s6",
        "{ ( xP - x0 ) * sin theta5 - ( yP - y0 ) * cos theta5 | sin ( theta5 - theta6 ) }",
        now->s6);
    sample_output_let(
        o, "s5",
        "{ ( xP - x0 ) * sin theta6 - ( yP - y0 ) * cos theta6 | sin ( theta5 - theta6 ) }",
        now->s5);
    put_loop(o, "xP + s5 * cos theta5 - s6 * cos theta6 - x0",
             "yP + s5 * sin theta5 - s6 * sin theta6 - y0", gap_of(now, now->s5, now->s6),
             size_of(now, now->s5, now->s6));
}

static void move_slider_in_slot(const sample_output *o, const sample_hung *now)
{
    int does_turn = sample_can_turn(o->r, o->group->link);

    sample_output_let(o, "sdot6",
                      does_turn
                          ? "{ vPy * cos theta5 - vPx * sin theta5 + s5 * omegak | sin ( "
                            "theta6 - theta5 ) }"
                          : "{ vPy * cos theta5 - vPx * sin theta5 | sin ( theta6 - theta5 ) }",
                      now->sdot6);
    sample_output_let(o, "sdot5",
                      "sdot6 * cos ( theta5 - theta6 ) - vPx * cos theta5 - vPy * sin theta5",
                      now->sdot5);
}

static void accelerate_slider_in_slot(const sample_output *o, const sample_hung *now)
{
    sample_output_let(
        o, "sddot6",
        sample_can_turn(o->r, o->group->link)
            ? "{ aPy * cos theta5 - aPx * sin theta5 <alphak + s5 * alphak > + 2 * sdot5 * omegak "
              "| sin ( theta6 - theta5 ) }"
            : "{ aPy * cos theta5 - aPx * sin theta5 | sin ( theta6 - theta5 ) }",
        now->sddot6);
}

/* ---- rocker, slot of its own */

static void place_rocker_with_slot(const sample_output *o, const sample_hung *now)
{
    double h = o->group->offset;
    fourlink_vector d = from_D(now), gap = gap_of(now, -now->s5, 0);

    gap.x += h * now->end->axis.y;
    gap.y -= h * now->end->axis.x;
    put_line(o, "From the pin D of the rocker to P. s runs along the slot from the foot of the "
                "perpendicular from D, whose length is h:");
    sample_output_let(o, "rx6", "xP - xD6", d.x);
    sample_output_let(o, "ry6", "yP - yD6", d.y);
    sample_output_let(o, "f5", "[ rx6 ^2 + ry6 ^2 ]", gsl_hypot(d.x, d.y));
    sample_output_let(o, "s5", now->s5 > 0 ? "[ f5 ^2 - h6 ^2 ]" : "- [ f5 ^2 - h6 ^2 ]", now->s5);
    sample_output_let(o, "theta6",
                      "atan2 ( s5 * ry6 <h6 - h6 * rx6 > , s5 * rx6 <h6 + h6 * ry6 > )",
                      now->end->theta);
    put_loop(o, "xP - s5 * cos theta6 <h6 + h6 * sin theta6 > - xD6",
             "yP - s5 * sin theta6 <h6 - h6 * cos theta6 > - yD6", gap, size_of(now, now->s5, h));
}

static void move_rocker_with_slot(const sample_output *o, const sample_hung *now)
{
    sample_output_let(o, "omega6", "{ vPy * cos theta6 - vPx * sin theta6 | s5 }", now->end->omega);
    sample_output_let(o, "sdot5", "vPx * cos theta6 + vPy * sin theta6 <h6 + h6 * omega6 >",
                      now->sdot5);
}

static void accelerate_rocker_with_slot(const sample_output *o, const sample_hung *now)
{
    sample_output_let(o, "alpha6",
                      "{ aPy * cos theta6 - aPx * sin theta6 - 2 * sdot5 * omega6 <h6 + h6 * "
                      "omega6 ^2 > | s5 }",
                      now->end->alpha);
}

/* ---- rocker with its pin in a slot of the carrying link */

static void place_rocker_in_slot(const sample_output *o, const sample_hung *now)
{
    double r = o->group->length, theta5 = now->rod->theta, h = cross(now->rod->axis, from_D(now)),
           phi = asin(bounded(h / r));

    let_slot_of_link(o, now);
    put_line(o, "The slot passes D at the distance h on its left:");
    sample_output_let(o, "h5", "( yP - yD6 ) * cos theta5 - ( xP - xD6 ) * sin theta5", h);
    if (o->group->side > 0)
        let_angle(o, "theta6", "theta5 + asin { h5 | r6 }", theta5 + phi, now->end->theta);
    else
        let_angle(o, "theta6", "theta5 + 180deg - asin { h5 | r6 }", theta5 + M_PI - phi,
                  now->end->theta);
    sample_output_let(o, "s5",
                      "r6 * cos ( theta6 - theta5 ) - ( xP - xD6 ) * cos theta5 - ( yP - yD6 ) * "
                      "sin theta5",
                      now->s5);
    put_loop(o, "xP + s5 * cos theta5 - r6 * cos theta6 - xD6",
             "yP + s5 * sin theta5 - r6 * sin theta6 - yD6", gap_of(now, now->s5, r),
             size_of(now, now->s5, r));
}

static void move_rocker_in_slot(const sample_output *o, const sample_hung *now)
{
    int does_turn = sample_can_turn(o->r, o->group->link);

    sample_output_let(
        o, "omega6",
        does_turn ? "{ vPy * cos theta5 - vPx * sin theta5 + s5 * omegak | r6 * cos ( theta6 - "
                    "theta5 ) }"
                  : "{ vPy * cos theta5 - vPx * sin theta5 | r6 * cos ( theta6 - theta5 ) }",
        now->end->omega);
    sample_output_let(o, "sdot5",
                      "- r6 * omega6 * sin ( theta6 - theta5 ) - vPx * cos theta5 - vPy * sin "
                      "theta5",
                      now->sdot5);
}

static void accelerate_rocker_in_slot(const sample_output *o, const sample_hung *now)
{
    sample_output_let(
        o, "alpha6",
        sample_can_turn(o->r, o->group->link)
            ? "{ aPy * cos theta5 - aPx * sin theta5 <alphak + s5 * alphak > + 2 * sdot5 * omegak "
              "+ r6 * omega6 ^2 * sin ( theta6 - theta5 ) | r6 * cos ( theta6 - theta5 ) }"
            : "{ aPy * cos theta5 - aPx * sin theta5 + r6 * omega6 ^2 * sin ( theta6 - theta5 ) | "
              "r6 * cos ( theta6 - theta5 ) }",
        now->end->alpha);
}

/* By fourlink_group_end and fourlink_group_hang. */
static const sample_output_type types[3][3] = {
    {{NULL, NULL, NULL, NULL}, {NULL, NULL, NULL, NULL}, {NULL, NULL, NULL, NULL}},
    {{"A rod on pin P of the %s drives the slider by its other pin Q.", place_slider, move_slider,
      accelerate_slider},
     {"Pin P of the %s runs in a slot of the slider.", place_slider_with_slot,
      move_slider_with_slot, accelerate_slider_with_slot},
     {"Pin Q of the slider runs in a slot of the %s, through its point P.", place_slider_in_slot,
      move_slider_in_slot, accelerate_slider_in_slot}},
    {{"A rod on pin P of the %s drives the rocker by its other pin Q.", place_rocker, move_rocker,
      accelerate_rocker},
     {"Pin P of the %s runs in a slot of the rocker.", place_rocker_with_slot,
      move_rocker_with_slot, accelerate_rocker_with_slot},
     {"Pin Q of the rocker runs in a slot of the %s, through its point P.", place_rocker_in_slot,
      move_rocker_in_slot, accelerate_rocker_in_slot}}};

const sample_output_type *sample_output_type_of(const fourlink_group *group)
{
    return &types[group->end][group->hang];
}
