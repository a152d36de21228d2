/* SPDX-License-Identifier: GPL-3.0-or-later
**
** limits.c - what a mechanism can do: its limits with the swing of link 4 or the stroke of the piston, or its
** dead positions; and at one position the transmission angle and the instantaneous centres.
**
** By the theorem of Kennedy the centres of any three links are on one line: I13 is on the lines I12 I23 and
** I14 I34, I24 on I12 I14 and I23 I34.  From the velocities, k = omega / omega2 and k_B = v_B / omega2:
**
**    I13 = B + (-k_By, k_Bx) / k3
**    I24 = (-d k4 / (1 - k4), 0), with D on the x axis;  of a piston (0, -k_C)
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "figure.h"

#define I_13 "I" SUB_1 SUB_3
#define I_24 "I" SUB_2 SUB_4
#define MU "\316\274"

/* rad: a dead position has no direction of motion; it is drawn so far inside the reach */
#define INSIDE 1e-12

/* As fractions of the drawing: radii of the arcs of swing and transmission angle. */
#define SWING 0.2
#define TRANSMISSION 0.1

/* A centre farther from A than so many times the drawing is not drawn. */
#define FAR 2.5

/* ------------------------------------------------------------------------------------------- limits */

/* Draw the mechanism at a crank angle in rad, with the angle beside B; 0 if it cannot be assembled there. */
static int put_position(sketch *s, const picture *p, fourlink_branch branch, double theta2,
                        fourlink_state *state)
{
    char mark[PICTURE_MARK];
    figure_pins pins;

    if (fourlink_position(p->v.mechanism, branch, theta2, state) != FOURLINK_OK)
        return 0;
    pins = figure_place(p, state);
    figure_outline(s, p, state, PEN_OF_LINK);
    sketch_pin(s, pins.A, "A");
    sketch_pin(s, pins.B, "B");
    sketch_pin(s, pins.C, "C");
    figure_letter(s, pins.B, pins.A, pins.A,
                  figure_angle(p, view_direction(&p->v, theta2), 4, mark));
    return 1;
}

/* Put "NAME = 40°" beside the drawing; or of a limit "NAME = 40° at θ2 = 60°". */
static void put_angle(sketch *s, const picture *p, const char *name, double angle)
{
    char mark[PICTURE_MARK];

    sketch_note(s, "%s = %s", name, figure_angle(p, angle, 5, mark));
}

static void put_limit(sketch *s, const picture *p, const char *name, double angle, double at)
{
    char mark[PICTURE_MARK], crank[PICTURE_MARK];

    sketch_note(s, "%s = %s at " FIGURE_THETA SUB_2 " = %s", name,
                figure_angle(p, view_direction(&p->v, angle), 5, mark),
                figure_angle(p, view_direction(&p->v, at), 5, crank));
}

/* Draw both limits of rocker or lever, and the angle between them. */
static void put_swing(sketch *s, const picture *p, fourlink_branch branch,
                      const fourlink_limits *limits)
{
    double middle = (limits->theta4_min + limits->theta4_max) / 2, radius = SWING * s->size;
    fourlink_state state;
    fourlink_vector D;

    if (!put_position(s, p, branch, limits->theta2_min, &state) ||
        !put_position(s, p, branch, limits->theta2_max, &state))
        return;
    D = figure_place(p, &state).D;
    figure_letter(s, D, place_beside(D, 0, 1), place_beside(D, 0, 1), "D");
    sketch_turn_arrow(s, PEN_RESULT, D, radius, middle, limits->theta4_min);
    sketch_turn_arrow(s, PEN_RESULT, D, radius, middle, limits->theta4_max);
    sketch_text_around(s, D, radius, middle, "swing");
    put_limit(s, p, FIGURE_THETA SUB_4 " min", limits->theta4_min, limits->theta2_min);
    put_limit(s, p, FIGURE_THETA SUB_4 " max", limits->theta4_max, limits->theta2_max);
    put_angle(s, p, "swing", limits->theta4_max - limits->theta4_min);
}

/* Draw both dead centres of a piston, and the stroke below the guide. */
static void put_stroke(sketch *s, const picture *p, fourlink_branch branch,
                       const fourlink_limits *limits)
{
    fourlink_vector inner, outer, middle;
    fourlink_state state;
    double below = -2 * FIGURE_HIGH * FIGURE_BLOCK * s->size;

    if (!put_position(s, p, branch, limits->outer, &state))
        return;
    outer = place_beside(figure_place(p, &state).C, 0, below);
    if (!put_position(s, p, branch, limits->inner, &state))
        return;
    inner = place_beside(figure_place(p, &state).C, 0, below);
    middle = place_middle(inner, outer);
    sketch_arrow(s, PEN_RESULT, middle, inner);
    sketch_arrow(s, PEN_RESULT, middle, outer);
    sketch_text(s, middle, 0, -1, "stroke");
    figure_note(s, p, "stroke", limits->stroke, QUANTITY_LENGTH);
    put_angle(s, p, "inner dead centre", view_direction(&p->v, limits->inner));
    put_angle(s, p, "outer dead centre", view_direction(&p->v, limits->outer));
}

/* Draw the dead positions, between which the crank swings. */
static void put_dead(sketch *s, const picture *p, fourlink_branch branch,
                     const fourlink_reach *reach)
{
    fourlink_state state;
    int i;

    for (i = 0; i < reach->n_ranges; i++) {
        put_position(s, p, branch, reach->from[i] + INSIDE, &state);
        put_position(s, p, branch, reach->to[i] - INSIDE, &state);
        put_angle(s, p, "dead at " FIGURE_THETA SUB_2, view_direction(&p->v, reach->from[i]));
        put_angle(s, p, "dead at " FIGURE_THETA SUB_2, view_direction(&p->v, reach->to[i]));
    }
}

static void put_limits(picture *p, const fourlink_state *shown)
{
    fourlink_branch branch = shown->branch;
    const char *title = "neither limits nor dead positions";
    fourlink_limits limits;
    fourlink_reach reach;
    sketch s;

    fourlink_limits_of(p->v.mechanism, branch, &limits);
    fourlink_reach_of(p->v.mechanism, &reach);
    figure_open(&s, p, branch);
    figure_frame(&s, p, shown);
    if (limits.has_swing) {
        title = "limits of link 4";
        put_swing(&s, p, branch, &limits);
    } else if (limits.stroke > 0) {
        title = "dead centres";
        put_stroke(&s, p, branch, &limits);
    } else if (reach.n_ranges && reach.to[0] - reach.from[0] < 2 * M_PI * (1 - 1e-9)) {
        title = "dead positions";
        put_dead(&s, p, branch, &reach);
    } else {
        figure_outline(&s, p, shown, PEN_OF_LINK);
    }
    put_angle(&s, p, MU " min", limits.mu_min);
    put_angle(&s, p, MU " max", limits.mu_max);
    if (limits.time_ratio > 0)
        sketch_note(&s, "time ratio = %.5g", limits.time_ratio);
    figure_slope(&s, p);
    sketch_close(&s, "%s: %s", fourlink_branch_text((int)branch), title);
}

/* ---------------------------------------------------------------------------- transmission, centres */

/* The transmission angle at C: from the rod to the rocker, or to the perpendicular of the stroke. */
static void put_transmission(sketch *s, const picture *p, const fourlink_state *state)
{
    figure_pins pins = figure_place(p, state);
    double radius = TRANSMISSION * s->size, rod, other, span;

    if (p->v.kind.slotted)
        return;
    rod = atan2(pins.B.y - pins.C.y, pins.B.x - pins.C.x);
    other = p->v.kind.guided ? M_PI_2 : atan2(pins.D.y - pins.C.y, pins.D.x - pins.C.x);
    span = flk_cycle_beside(other - rod, M_PI); /* the acute one */
    if (p->v.kind.guided)
        sketch_line(s, PEN_CONSTRUCTION, pins.C, place_polar(pins.C, 1.5 * radius, rod + span));
    else if (cos(rod + span - other) < 0) /* beyond C */
        sketch_line(s, PEN_CONSTRUCTION, pins.C, place_polar(pins.C, -1.5 * radius, other));
    sketch_arc(s, PEN_RESULT, pins.C, radius, GSL_MIN_DBL(rod, rod + span),
               GSL_MAX_DBL(rod, rod + span));
    sketch_text_around(s, pins.C, radius, rod + span / 2, MU);
}

/* Draw a centre with lines to two points on the lines that meet there; beside the drawing, its place. */
static void put_centre(sketch *s, const picture *p, const char *name, fourlink_vector I,
                       fourlink_vector first, fourlink_vector second)
{
    char own[NOTATION_SIZE];
    double far = gsl_hypot(I.x, I.y);
    fourlink_vector on_page;

    if (!(far <= 1e6 * s->size)) {
        sketch_note(s, "%s at infinity", name);
        return;
    }
    on_page = view_place(&p->v, I);
    sketch_note(s, "%s = (%.5g, %.5g) %s", name, view_value(&p->v, QUANTITY_LENGTH, on_page.x),
                view_value(&p->v, QUANTITY_LENGTH, on_page.y),
                canvas_unit(&p->on, s->unit->name, own));
    if (far > FAR * s->size)
        return;
    sketch_line(s, PEN_CONSTRUCTION, first, I);
    sketch_line(s, PEN_CONSTRUCTION, second, I);
    sketch_dot(s, I, "I");
    sketch_text(s, I, 1, 1, name);
}

static void put_centres(sketch *s, const picture *p, const fourlink_state *state)
{
    const fourlink_link_state *coupler = &state->link[FOURLINK_COUPLER],
                              *follower = &state->link[FOURLINK_FOLLOWER];
    double d = p->v.design->link[FOURLINK_GROUND].length;
    figure_pins pins = figure_place(p, state);
    fourlink_vector I13, I24;

    /* a division by 0 is a centre at infinity */
    I13 = place_in(coupler->origin, coupler->k_origin, 0, 1 / coupler->k);
    I24 = p->v.kind.guided ? place_at(0, -follower->k_origin.x)
                           : place_at(-d * follower->k / (1 - follower->k), 0);
    put_centre(s, p, I_13, I13, pins.A, p->v.kind.guided ? pins.C : pins.D);
    put_centre(s, p, I_24, I24, pins.A, p->v.kind.slotted ? pins.B : pins.C);
}

const char *picture_limits(picture *p, fourlink_branch branch)
{
    fourlink_instant now;
    sketch s;
    int status = picture_position(p, branch, &now, p->loads);

    if (status != FOURLINK_OK)
        return fourlink_status_text(status);
    put_limits(p, &now.state);
    figure_open(&s, p, branch);
    figure_frame(&s, p, &now.state);
    figure_draw(&s, p, &now.state, 0);
    put_transmission(&s, p, &now.state);
    put_angle(&s, p, MU, now.state.mu);
    put_centres(&s, p, &now.state);
    sketch_note(&s, "I" SUB_1 SUB_2 " A, I" SUB_2 SUB_3 " B%s%s",
                p->v.kind.slotted ? "" : ", I" SUB_3 SUB_4 " C",
                p->v.kind.guided ? "" : ", I" SUB_1 SUB_4 " D");
    figure_close(&s, p, &now, "");
    return NULL;
}
