/* SPDX-License-Identifier: GPL-3.0-or-later
**
** spring.c - what joins two points: springs as a zigzag, dampers as a cylinder with its piston, actuators
** as a cylinder with its rod; torsional springs as a spiral.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "figure.h"

#define FEWEST_TEETH 5
#define MOST_TEETH 15
#define USUAL_TEETH 8 /* without a free length, from which their number follows */
#define TURNS 2       /* of a spiral */

/* As fractions of the drawing: half the width of a zigzag and of a cylinder, the distance of a spring's
** teeth when it is free, and the radius of a spiral. */
#define HALF_WIDTH 0.018
#define PITCH 0.035
#define RADIUS 0.05

/* As fractions of the length of a spring: its straight ends, and a damper's cylinder and piston. */
#define LEAD 0.2
#define CYLINDER 0.3
#define PISTON 0.55
#define OPEN_END 0.7

/* A spring from one end to the other, and a parallel to it where spring and damper are side by side. */
typedef struct strand {
    sketch *s;
    int link[2]; /* at its ends */
    fourlink_vector from, axis;
    double length, half; /* half the width of a zigzag */
    double side;         /* of the parallel to the left, in these halves */
} strand;

/* A place, by fractions of the length and halves of the width. */
static fourlink_vector place(const strand *x, double along, double across)
{
    return place_in(x->from, x->axis, along * x->length, (across + x->side) * x->half);
}

static void put_line(const strand *x, double along, double across, double to_along,
                     double to_across)
{
    sketch_line(x->s, PEN_GROUND, place(x, along, across), place(x, to_along, to_across));
}

/* The number stays while the spring is compressed or drawn out. */
static int teeth_of(const sketch *s, double free_length)
{
    double n = free_length > 0 ? floor((1 - 2 * LEAD) * free_length / (PITCH * s->size) + 0.5)
                               : USUAL_TEETH;

    return (int)GSL_MIN_DBL(GSL_MAX_DBL(n, FEWEST_TEETH), MOST_TEETH);
}

static void put_zigzag(const strand *x, int teeth)
{
    double step = (1 - 2 * LEAD) / (2 * teeth), last = 0;
    int i;

    for (i = 0; i < 2 * teeth; i++) {
        double next = i == 2 * teeth - 1 ? 0 : i % 2 ? -1 : 1;

        put_line(x, LEAD + i * step, last, LEAD + (i + 1) * step, next);
        last = next;
    }
}

static void put_damper(const strand *x)
{
    put_line(x, LEAD, 0, CYLINDER, 0);
    put_line(x, CYLINDER, -1, CYLINDER, 1);
    put_line(x, CYLINDER, -1, OPEN_END, -1);
    put_line(x, CYLINDER, 1, OPEN_END, 1);
    put_line(x, PISTON, -0.7, PISTON, 0.7);
    put_line(x, PISTON, 0, 1 - LEAD, 0);
}

/* What follows is along the spring from one of its ends to the other. */
static void go_along(const strand *x, int from, int is_stretched)
{
    fourlink_vector end[2];

    end[0] = x->from;
    end[1] = place_in(x->from, x->axis, x->length, 0);
    sketch_with(x->s, x->link[from]);
    sketch_along(x->s, end[from], x->link[!from], end[!from], is_stretched);
}

/* Ground at an end, across the spring. */
static void put_wall(const strand *x, int at, double outward)
{
    int i;

    go_along(x, at, 0);
    put_line(x, at, -1.2, at, 1.2);
    for (i = -1; i <= 2; i++) {
        fourlink_vector p = place(x, at, 0.8 * i - 0.4);

        sketch_line(x->s, PEN_CONSTRUCTION, p,
                    place_in(p, x->axis, outward * 0.8 * x->half, -0.8 * x->half));
    }
}

/* Draw the place of an end on its link: a point, with thin lines if it is off the link's line; or ground. */
static void put_end(const strand *x, const picture *p, const fourlink_state *state, int at)
{
    int link = x->link[at];
    figure_pins pins = figure_place(p, state);
    fourlink_vector end = place(x, at, -x->side);

    if (link == FOURLINK_GROUND) {
        put_wall(x, at, at > 0 ? 1 : -1);
        return;
    }
    sketch_with(x->s, link == p->v.kind.slotted ? FOURLINK_GROUND : link);
    if (link == FOURLINK_CRANK)
        figure_off(x->s, pins.A, pins.B, end);
    else if (!p->v.kind.slides_on[link])
        figure_off(x->s, link == FOURLINK_COUPLER ? pins.B : pins.D, pins.C, end);
    sketch_with(x->s, link);
    sketch_dot(x->s, end, "");
}

static void draw_linear(sketch *s, const picture *p, const fourlink_state *state,
                        const fourlink_spring *spring, const char *name)
{
    fourlink_vector to = geometry_of_link(state, spring->to, &spring->to_at);
    int has_coil = scene_has_coil(spring), has_damper = scene_has_damper(spring);
    double end;
    strand x;

    x.s = s;
    x.side = 0;
    x.link[0] = spring->link;
    x.link[1] = spring->to;
    x.from = geometry_of_link(state, spring->link, &spring->at);
    x.length = place_distance(x.from, to);
    x.half = HALF_WIDTH * s->size;
    if (x.length == 0)
        return;
    x.axis = place_at((to.x - x.from.x) / x.length, (to.y - x.from.y) / x.length);
    put_end(&x, p, state, 0);
    put_end(&x, p, state, 1);
    go_along(&x, 0, 1);
    put_line(&x, 0, 0, LEAD, 0);
    put_line(&x, 1 - LEAD, 0, 1, 0);
    end = has_coil && has_damper ? 1.4 : 0; /* side by side */
    put_line(&x, LEAD, -end, LEAD, end);
    put_line(&x, 1 - LEAD, -end, 1 - LEAD, end);
    x.side = end;
    if (has_coil)
        put_zigzag(&x, teeth_of(s, spring->free_length));
    x.side = -end;
    if (has_damper)
        put_damper(&x);
    x.side = 0;
    sketch_text(s, place(&x, 0.5, end + 1), -x.axis.y, x.axis.x, name);
}

/* As fractions of the length of an actuator: the end of its cylinder, and its piston. */
#define BARREL 0.6
#define HEAD 0.5

static void draw_actuator(sketch *s, const picture *p, const fourlink_state *state,
                          const fourlink_actuator *actuator)
{
    fourlink_vector to = geometry_of_link(state, actuator->link, &actuator->at);
    strand x;

    x.s = s;
    x.side = 0;
    x.link[0] = actuator->to;
    x.link[1] = actuator->link;
    x.from = geometry_of_link(state, actuator->to, &actuator->to_at);
    x.length = place_distance(x.from, to);
    x.half = HALF_WIDTH * s->size;
    if (x.length == 0)
        return;
    x.axis = place_at((to.x - x.from.x) / x.length, (to.y - x.from.y) / x.length);
    put_end(&x, p, state, 0);
    put_end(&x, p, state, 1);
    go_along(&x, 0, 1);
    put_line(&x, 0, -1, 0, 1);
    put_line(&x, 0, -1, BARREL, -1);
    put_line(&x, 0, 1, BARREL, 1);
    put_line(&x, BARREL, -1, BARREL, -0.3);
    put_line(&x, BARREL, 0.3, BARREL, 1);
    put_line(&x, HEAD, -1, HEAD, 1);
    put_line(&x, HEAD, 0, 1, 0);
    sketch_text(s, place(&x, 0.3, 1), -x.axis.y, x.axis.x, actuator->name);
}

/* The direction of a link from a pin; of the ground downwards. */
static double direction_from(const picture *p, const fourlink_state *state, int link,
                             fourlink_vector pin)
{
    if (link == FOURLINK_GROUND)
        return -M_PI_2;
    return place_distance(state->link[link].origin, pin) < 0.5 * p->v.design->link[link].length
               ? state->link[link].theta
               : state->link[link].theta + M_PI;
}

static void draw_torsional(sketch *s, const picture *p, const fourlink_state *state,
                           const fourlink_spring *spring, const char *name)
{
    int joint = scene_joint_of(spring);
    fourlink_vector pin = geometry_joint(&p->v, state, joint);
    double from = direction_from(p, state, spring->to, pin);
    double span = direction_from(p, state, spring->link, pin) - from;

    span += 2 * M_PI * (TURNS - flk_cycle_count(span, 2 * M_PI));
    sketch_with(s, p->v.kind.joint[joint].at);
    sketch_spiral(s, PEN_GROUND, pin, 0.3 * RADIUS * s->size, RADIUS * s->size, from, from + span);
    if (spring->link != p->v.kind.slotted || joint != 2) /* where the coupler, a block, slides */
        sketch_with(s, spring->link);
    sketch_text_around(s, pin, RADIUS * s->size, from + span + 2, name);
}

void spring_draw(sketch *s, const picture *p, const fourlink_state *state, int has_values)
{
    fourlink_spring spring;
    fourlink_spring_state at;
    const char *name = "";
    fourlink_actuator actuator;
    unsigned long i;

    for (i = 0; fourlink_deck_actuator(p->v.deck, i, &actuator) == FOURLINK_OK; i++) {
        sketch_show(s, SKETCH_SPRING, p->v.problem.n_springs + i);
        draw_actuator(s, p, state, &actuator);
    }
    for (i = 0; i < p->v.problem.n_springs; i++) {
        fourlink_deck_spring(p->v.deck, i, &name, &spring);
        sketch_show(s, SKETCH_SPRING, i);
        (spring.is_torsional ? draw_torsional : draw_linear)(s, p, state, &spring, name);
        if (has_values && fourlink_spring_at(p->v.mechanism, state, &spring, &at) == FOURLINK_OK)
            figure_note(s, p, name, at.force,
                        spring.is_torsional ? QUANTITY_TORQUE : QUANTITY_FORCE);
    }
}
