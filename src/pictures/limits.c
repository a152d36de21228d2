/* SPDX-License-Identifier: GPL-3.0-or-later
**
** limits.c - what a mechanism can do: its limits with the swing of link 4 or the stroke of the piston, or
** its dead positions; at one position the transmission angle and the instantaneous centres; and the limits
** of outputs.
**
** By the theorem of Kennedy the centres of any three links are on one line: I13 is on the lines I12 I23 and
** I14 I34, I24 on I12 I14 and I23 I34.  From the velocities, k = omega / omega2 and k_B = v_B / omega2:
**
**    I13 = B + (-k_By, k_Bx) / k3
**    I24 = (-d k4 / (1 - k4), 0), with D on the x axis;  of a piston (0, -k_C)
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include <string.h>

#include "base/cycle.h"
#include "figure.h"
#include "view/results.h"

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

/* Draw a mechanism at a crank angle in rad, with the angle beside B; 0 if it cannot be assembled there. */
static int put_position_of(sketch *s, const picture *p, const fourlink_mechanism *mechanism,
                           fourlink_branch branch, double theta2, fourlink_state *state)
{
    char mark[PICTURE_MARK];
    figure_pins pins;

    if (fourlink_position(mechanism, branch, theta2, state) != FOURLINK_OK)
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

/* The four links alone: their limits can be where an output is not assembled. */
static int put_position(sketch *s, const picture *p, fourlink_branch branch, double theta2,
                        fourlink_state *state)
{
    fourlink_mechanism bare = *p->v.mechanism;

    bare.design.n_groups = 0;
    return put_position_of(s, p, &bare, branch, theta2, state);
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
    fourlink_state bare = *shown;
    sketch s;

    bare.last = FOURLINK_FOLLOWER;
    fourlink_limits_of(p->v.mechanism, branch, &limits);
    fourlink_reach_of(p->v.mechanism, &reach);
    figure_open(&s, p, branch);
    figure_frame(&s, p, &bare);
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
        figure_outline(&s, p, &bare, PEN_OF_LINK);
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

/* ------------------------------------------------------------------------------------------ outputs */

/* A fact of an output, NAME.WHAT; null if it has none. */
static const fourlink_value *find_fact(const picture *p, fourlink_branch branch, int i,
                                       const char *what)
{
    const fourlink_value *facts;
    unsigned long n, k;
    char name[MESSAGE_SIZE];

    flk_text_join(name, sizeof name, fourlink_deck_link_text(p->v.deck, FOURLINK_END_OF(i)), ".",
                  what, (char *)NULL);
    results_facts(p->v.results, (int)branch, FOURLINK_FACTS_LIMITS, &facts, &n);
    for (k = 0; k < n; k++)
        if (strcmp(facts[k].name, name) == 0)
            return &facts[k];
    return NULL;
}

/* Put a fact of an output beside the drawing, with the crank angle where it is, if it is at one. */
static void put_fact(sketch *s, const picture *p, const fourlink_value *fact)
{
    char words[PICTURE_WORDS], crank[PICTURE_MARK];
    quantity q = flk_quantity_find(fact->quantity);

    if (q == QUANTITY_ANGLE)
        flk_text_join(words, sizeof words, fact->name, " = ",
                      figure_angle(p, fact->value * fact->to_si, 5, crank), (char *)NULL);
    else
        picture_words(p, fact->name, fact->value * fact->to_si, q, words);
    if (fact->has_angle)
        sketch_note(s, "%s at " FIGURE_THETA SUB_2 " = %s", words,
                    figure_angle(p, view_si(&p->v, QUANTITY_ANGLE, fact->angle), 5, crank));
    else
        sketch_note(s, "%s", words);
}

/* Draw the mechanism with the links that carry outputs, and the pins of output i. */
static void put_with_output(sketch *s, const picture *p, const fourlink_state *state, int i)
{
    geometry_output x = geometry_find_output(&p->v, state, i);
    int link;

    for (link = FOURLINK_CRANK; link <= state->last; link++)
        hull_draw(s, p, state, link);
    figure_outline(s, p, state, PEN_OF_LINK);
    sketch_pin(s, x.P, "P");
    sketch_pin(s, x.Q, "Q");
    sketch_pin(s, x.D, "D");
}

/* Draw the mechanism where an output has a limit, with the limit beside the drawing. */
static int put_output_at(sketch *s, const picture *p, const fourlink_value *fact,
                         fourlink_branch branch, int i, fourlink_state *state)
{
    double theta2 = view_si(&p->v, QUANTITY_ANGLE, fact->angle) - view_direction(&p->v, 0);

    put_fact(s, p, fact);
    if (!put_position_of(s, p, p->v.mechanism, branch, theta2, state))
        return 0;
    put_with_output(s, p, state, i);
    return 1;
}

#define TURN 360

/* Why an output has no limits. */
static const char *why_unlimited(const picture *p, fourlink_branch branch)
{
    fourlink_state state;
    int k;

    for (k = 0; k < TURN; k++)
        if (fourlink_position(p->v.mechanism, branch, 2 * M_PI * k / TURN, &state) != FOURLINK_OK)
            return "no limits: the crank does not turn fully";
    return "no limits: it turns fully";
}

/* The way of the slider between two states, beside it; the arc of a rocker about a fixed pin. */
static void put_way(sketch *s, const picture *p, const fourlink_state state[2], int i)
{
    const fourlink_group *g = &p->v.design->group[i];
    const fourlink_link_state *least = &state[0].link[FOURLINK_END_OF(i)],
                              *most = &state[1].link[FOURLINK_END_OF(i)];

    if (g->end == FOURLINK_GROUP_SLIDES) {
        double below = -2 * FIGURE_HIGH * FIGURE_BLOCK * s->size;
        fourlink_vector from = place_in(least->origin, g->direction, 0, below),
                        to = place_in(most->origin, g->direction, 0, below),
                        middle = place_middle(from, to);

        sketch_arrow(s, PEN_RESULT, middle, from);
        sketch_arrow(s, PEN_RESULT, middle, to);
        sketch_text(s, middle, g->direction.y, -g->direction.x, "stroke");
    } else if (g->to <= FOURLINK_GROUND) {
        double radius = SWING * s->size,
               swing = flk_cycle_place(most->theta - least->theta, 0, 2 * M_PI),
               middle = least->theta + swing / 2;

        sketch_turn_arrow(s, PEN_RESULT, least->origin, radius, middle, least->theta);
        sketch_turn_arrow(s, PEN_RESULT, least->origin, radius, middle, least->theta + swing);
        sketch_text_around(s, least->origin, radius, middle, "swing");
    }
}

static void put_output(picture *p, const fourlink_state *shown, int i)
{
    int slides = p->v.design->group[i].end == FOURLINK_GROUP_SLIDES;
    fourlink_branch branch = shown->branch;
    const fourlink_value *fact;
    fourlink_state state[2];
    sketch s;

    figure_open(&s, p, branch);
    figure_frame(&s, p, shown);
    fact = find_fact(p, branch, i, slides ? "x_min" : "theta_min");
    if (fact && put_output_at(&s, p, fact, branch, i, &state[0]) &&
        (fact = find_fact(p, branch, i, slides ? "x_max" : "theta_max")) != NULL &&
        put_output_at(&s, p, fact, branch, i, &state[1])) {
        put_way(&s, p, state, i);
        put_fact(&s, p, find_fact(p, branch, i, slides ? "stroke" : "swing"));
        if ((fact = find_fact(p, branch, i, "time_ratio")) != NULL)
            sketch_note(&s, "%s = %.5g", fact->name, fact->value);
    } else {
        put_with_output(&s, p, shown, i);
        sketch_note(&s, "%s", why_unlimited(p, branch));
    }
    sketch_close(&s, "%s: limits of %s", fourlink_branch_text((int)branch),
                 fourlink_deck_link_text(p->v.deck, FOURLINK_END_OF(i)));
}

const char *picture_limits(picture *p, fourlink_branch branch)
{
    fourlink_instant now;
    sketch s;
    int status = picture_position(p, branch, &now, p->loads), i;

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
    for (i = 0; i < p->v.design->n_groups; i++)
        put_output(p, &now.state, i);
    return NULL;
}
