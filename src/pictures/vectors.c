/* SPDX-License-Identifier: GPL-3.0-or-later
**
** vectors.c - the graphical method at one position: velocity and acceleration polygons, free
** bodies and their polygons of forces, which close.
**
**    v_C = v_B + v_CB,   of a slider on a lever  v_B = v_B4 + slide_v u
**    a_C = a_B + a_CB^n + a_CB^t,  a^n = -omega^2 r, a^t = alpha x r
**    a_B = a_B4^n + a_B4^t + 2 omega4 x slide_v u + slide_a u,   B4 the point of the lever at B
**    sum F - m a_G = 0
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "friction_circle.h"
#include "spring.h"

/* The height of a letter in these small drawings. */
#define LETTER 0.045

/* A side shorter than this fraction of the largest is shorter than the head of an arrow. */
#define SHORTEST 0.01

/* The couple of a guide is rounding if it is this fraction of the largest force times the crank's length. */
#define ROUNDING 1e-12

static const fourlink_vector zero = {0, 0};

/* A polygon of vectors of one quantity; its sides in the deck's unit. */
typedef struct polygon {
    sketch s;
    const picture *p;
    quantity q;
    arrow_list sides;
    fourlink_vector middle;
} polygon;

static void open_polygon(polygon *g, picture *p, quantity q)
{
    g->p = p;
    g->q = q;
    g->sides.n = 0;
    sketch_open(&g->s, &p->on, 1);
    g->s.letter = LETTER;
}

static fourlink_vector end_of(const arrow *x)
{
    return place_beside(x->at, x->F.x, x->F.y);
}

/* Add a vector in SI units at the tip of another; returns its end. */
static fourlink_vector put_side(polygon *g, pen kind, const char *name, fourlink_vector from,
                                fourlink_vector v)
{
    v.x = view_value(&g->p->v, g->q, v.x);
    v.y = view_value(&g->p->v, g->q, v.y);
    arrow_put(&g->sides, kind, name, from, v);
    return place_beside(from, v.x, v.y);
}

static const char *all_zero(quantity q)
{
    return q == QUANTITY_SPEED          ? "all velocities are zero"
           : q == QUANTITY_ACCELERATION ? "all accelerations are zero"
                                        : "all forces are zero";
}

static void find_size(polygon *g)
{
    int i, n = g->sides.n;

    g->s.size = arrow_largest(&g->sides);
    if (g->s.size == 0)
        g->s.size = 1;
    g->middle = zero;
    for (i = 0; i < n; i++) {
        const arrow *x = &g->sides.list[i];

        g->middle.x += (x->at.x + end_of(x).x) / (2 * n);
        g->middle.y += (x->at.y + end_of(x).y) / (2 * n);
    }
}

/* Draw the sides, with their names away from the middle of the polygon.  A side too short for a head has no
** name. */
static void draw_sides(polygon *g)
{
    int i;

    find_size(g);
    if (arrow_largest(&g->sides) == 0)
        sketch_text(&g->s, zero, 0, 1, all_zero(g->q));
    for (i = 0; i < g->sides.n; i++) {
        const arrow *x = &g->sides.list[i];
        fourlink_vector to = end_of(x);
        double dx = to.x - x->at.x, dy = to.y - x->at.y, length = gsl_hypot(dx, dy), nx, ny, out;

        if (length <= 1e-12 * g->s.size)
            continue; /* rounding */
        figure_note(&g->s, g->p, x->name, view_si(&g->p->v, g->q, length), g->q);
        if (length < SHORTEST * g->s.size) {
            sketch_line(&g->s, x->kind, x->at, to);
            continue;
        }
        sketch_arrow(&g->s, x->kind, x->at, to);
        nx = -dy / length;
        ny = dx / length;
        out = nx * (x->at.x - g->middle.x) + ny * (x->at.y - g->middle.y) < 0 ? -1 : 1;
        sketch_text(&g->s, place_at((x->at.x + to.x) / 2, (x->at.y + to.y) / 2), out * nx, out * ny,
                    x->name);
    }
}

/* Put the letter of a corner away from the middle. */
static void put_letter(polygon *g, fourlink_vector at, const char *letter)
{
    if (arrow_largest(&g->sides) > 0)
        sketch_text(&g->s, at, at.x - g->middle.x, at.y - g->middle.y, letter);
}

/* Put the image of a point of a link, which ends its velocity or acceleration from the pole. */
static void put_image(polygon *g, const fourlink_state *state, int link, const fourlink_vector *at,
                      const char *letter)
{
    fourlink_vector v, a, end;

    fourlink_point(state, link, at, NULL, &v, &a);
    end = g->q == QUANTITY_SPEED ? v : a;
    end = place_at(view_value(&g->p->v, g->q, end.x), view_value(&g->p->v, g->q, end.y));
    sketch_line(&g->s, PEN_CONSTRUCTION, zero, end);
    sketch_dot(&g->s, end);
    put_letter(g, end, letter);
}

/* Put the images of centres of mass and of tracer points. */
static void put_images(polygon *g, const fourlink_state *state)
{
    static const char *const letters[][5] = {{"", "", "g" SUB_2, "g" SUB_3, "g" SUB_4},
                                             {"", "", "g'" SUB_2, "g'" SUB_3, "g'" SUB_4}};
    const char *name, *mark = g->q == QUANTITY_SPEED ? "" : "'";
    fourlink_vector at;
    unsigned long i;
    char letter[80];
    int link;

    if (arrow_largest(&g->sides) == 0)
        return;
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
        if (g->p->v.design->link[link].mass > 0)
            put_image(g, state, link, &g->p->v.design->link[link].cg,
                      letters[g->q != QUANTITY_SPEED][link]);
    for (i = 0; i < g->p->v.problem.n_points; i++) {
        fourlink_deck_point(g->p->v.deck, i, &name, &link, &at);
        put_image(g, state, link, &at,
                  flk_text_join(letter, sizeof letter, name, mark, (char *)NULL));
    }
}

/* The motion of pin C, the end of link 3. */
static void motion_of_C(const picture *p, const fourlink_state *state, fourlink_vector *v,
                        fourlink_vector *a)
{
    fourlink_vector at = place_at(p->v.design->link[FOURLINK_COUPLER].length, 0);

    fourlink_point(state, FOURLINK_COUPLER, &at, NULL, v, a);
}

/* The arm from D to the point of the lever at B. */
static fourlink_vector arm_of_lever(const fourlink_state *state)
{
    const fourlink_vector *B = &state->link[FOURLINK_COUPLER].origin,
                          *D = &state->link[FOURLINK_FOLLOWER].origin;

    return place_at(B->x - D->x, B->y - D->y);
}

/* Of a slider: the velocity of the lever's point at B, and along the slide. */
static void put_sliding(picture *p, const fourlink_state *state)
{
    const fourlink_link_state *slider = &state->link[FOURLINK_COUPLER];
    fourlink_vector u = slider->axis, r = arm_of_lever(state), b, b4;
    double w = state->link[FOURLINK_FOLLOWER].omega;
    polygon g;

    open_polygon(&g, p, QUANTITY_SPEED);
    b = put_side(&g, PEN_CRANK, "vB", zero, slider->velocity);
    b4 = put_side(&g, PEN_FOLLOWER, "vB4", zero, place_at(-w * r.y, w * r.x));
    put_side(&g, PEN_COUPLER, "slide_v", b4, place_at(state->slide_v * u.x, state->slide_v * u.y));
    draw_sides(&g);
    put_letter(&g, zero, "o");
    put_letter(&g, b, "b");
    put_letter(&g, b4, "b4");
    put_images(&g, state);
    sketch_close(&g.s, "velocity polygon", p->v.units[g.q].name);
}

static void put_velocities(picture *p, const fourlink_state *state)
{
    fourlink_vector v_B = state->link[FOURLINK_COUPLER].velocity, v_C, b, c;
    polygon g;

    motion_of_C(p, state, &v_C, NULL);
    open_polygon(&g, p, QUANTITY_SPEED);
    b = put_side(&g, PEN_CRANK, "vB", zero, v_B);
    put_side(&g, PEN_FOLLOWER, "vC", zero, v_C);
    c = put_side(&g, PEN_COUPLER, "vCB", b, place_beside(v_C, -v_B.x, -v_B.y));
    draw_sides(&g);
    put_letter(&g, zero, "o");
    put_letter(&g, b, "b");
    put_letter(&g, c, "c");
    put_images(&g, state);
    sketch_close(&g.s, "velocity polygon", p->v.units[g.q].name);
}

/* Add the normal and the tangential acceleration of a link's end about its origin. */
static fourlink_vector put_parts(polygon *g, const fourlink_state *state, int link,
                                 const char *normal, const char *tangential, fourlink_vector from)
{
    const fourlink_link_state *l = &state->link[link];
    double length = g->p->v.design->link[link].length, n = -l->omega * l->omega * length,
           t = l->alpha * length;

    from = put_side(g, (pen)link, normal, from, place_at(n * l->axis.x, n * l->axis.y));
    return put_side(g, (pen)link, tangential, from, place_at(-t * l->axis.y, t * l->axis.x));
}

/* Of a slider: the accelerations of the lever's point at B, that of Coriolis, and along the slide. */
static void put_coriolis(picture *p, const fourlink_state *state)
{
    const fourlink_link_state *lever = &state->link[FOURLINK_FOLLOWER];
    fourlink_vector u = state->link[FOURLINK_COUPLER].axis, r = arm_of_lever(state), b, b4;
    double n = -lever->omega * lever->omega, c = state->coriolis, a = state->slide_a;
    polygon g;

    open_polygon(&g, p, QUANTITY_ACCELERATION);
    b = put_parts(&g, state, FOURLINK_CRANK, "aBn", "aBt", zero);
    b4 = put_side(&g, PEN_FOLLOWER, "aB4n", zero, place_at(n * r.x, n * r.y));
    b4 = put_side(&g, PEN_FOLLOWER, "aB4t", b4, place_at(-lever->alpha * r.y, lever->alpha * r.x));
    put_side(&g, PEN_COUPLER, "slide_a",
             put_side(&g, PEN_RESULT, "coriolis", b4, place_at(-c * u.y, c * u.x)),
             place_at(a * u.x, a * u.y));
    draw_sides(&g);
    sketch_line(&g.s, PEN_CONSTRUCTION, zero, b);
    sketch_line(&g.s, PEN_CONSTRUCTION, zero, b4);
    put_letter(&g, zero, "o'");
    put_letter(&g, b, "b'");
    put_letter(&g, b4, "b4'");
    put_images(&g, state);
    sketch_close(&g.s, "acceleration polygon", p->v.units[g.q].name);
}

static void put_accelerations(picture *p, const fourlink_state *state)
{
    fourlink_vector a_C, b, c;
    polygon g;

    motion_of_C(p, state, NULL, &a_C);
    open_polygon(&g, p, QUANTITY_ACCELERATION);
    b = put_parts(&g, state, FOURLINK_CRANK, "aBn", "aBt", zero);
    c = put_parts(&g, state, FOURLINK_COUPLER, "aCBn", "aCBt", b);
    if (p->v.kind.has_stroke)
        put_side(&g, PEN_FOLLOWER, "aC", zero, a_C);
    else
        put_parts(&g, state, FOURLINK_FOLLOWER, "aCn", "aCt", zero);
    draw_sides(&g);
    sketch_line(&g.s, PEN_CONSTRUCTION, zero, c);
    sketch_line(&g.s, PEN_CONSTRUCTION, b, c);
    put_letter(&g, zero, "o'");
    put_letter(&g, b, "b'");
    put_letter(&g, c, "c'");
    put_images(&g, state);
    sketch_close(&g.s, "acceleration polygon", p->v.units[g.q].name);
}

/* A link with the forces on it: from its two neighbours, weight, loads, and -m a_G, which balances them. */
typedef struct free_body {
    int link, is_slider;
    fourlink_vector first, second, G; /* its pins, and its centre of mass */
    double length;
    friction_circle circle[2]; /* of the pins */
    double circle_scale;
    arrow_list forces;
} free_body;

/* Add the force at a pin, 0 or 1, by a neighbour; returns its place in the list, -1 if it is 0. */
static int add_pin(free_body *b, const picture *p, const picture_row *r, int pin, int by)
{
    int n = b->forces.n;

    arrow_add_joint(&b->forces, p, r, by, b->link);
    b->circle[pin] = friction_circle_of(p, r, b->link - FOURLINK_CRANK + pin, b->link,
                                        n < b->forces.n ? b->forces.list[n].F : zero);
    return n < b->forces.n ? n : -1;
}

/* Move the force of a pin to where it touches the friction circle. */
static void touch(free_body *b, int pin, int i)
{
    if (i >= 0)
        b->forces.list[i].at = friction_circle_touch(&b->circle[pin], b->circle_scale,
                                                     b->forces.list[i].at, b->forces.list[i].F);
}

static void open_body(free_body *b, const picture *p, const picture_row *r, int link)
{
    const fourlink_link *body = &p->v.design->link[link];
    const fourlink_state *state = &r->now.state;
    figure_pins pins = figure_place(p, state);
    int first, second;
    fourlink_vector a_G;

    b->link = link;
    b->is_slider = p->v.kind.slides_on[link];
    b->first = link == FOURLINK_CRANK ? pins.A : link == FOURLINK_COUPLER ? pins.B : pins.C;
    b->second = link == FOURLINK_CRANK                     ? pins.B
                : link == FOURLINK_COUPLER || b->is_slider ? pins.C
                                                           : pins.D;
    b->G = figure_of_link(p, state, link, &body->cg);
    b->length = gsl_hypot(b->second.x - b->first.x, b->second.y - b->first.y);
    if (b->length == 0)
        b->length = figure_length(p, p->v.design->link[FOURLINK_CRANK].length);
    b->forces.n = 0;
    first = add_pin(b, p, r, 0, link - 1);
    second = add_pin(b, p, r, 1, link == FOURLINK_FOLLOWER ? FOURLINK_GROUND : link + 1);
    b->circle_scale = friction_circle_scale(b->length, &b->circle[0], &b->circle[1]);
    touch(b, 0, first);
    touch(b, 1, second);
    arrow_add_loads(&b->forces, p, r, link, 1);
    fourlink_point(state, link, &body->cg, NULL, NULL, &a_G);
    arrow_add(&b->forces, PEN_RESULT, "-m aG", b->G, -body->mass * a_G.x, -body->mass * a_G.y);
}

/* Draw a pin, in the middle of its friction circle if it has one. */
static void draw_pin(sketch *s, const picture *p, const free_body *b, int pin)
{
    fourlink_vector at = pin ? b->second : b->first, other = pin ? b->first : b->second;

    if (b->circle[pin].radius > 0) {
        friction_circle_draw(s, &b->circle[pin], b->circle_scale, at);
        sketch_dot(s, at);
    } else {
        sketch_pin(s, at);
    }
    figure_letter(s, at, other, other, p->v.kind.joint[b->link - FOURLINK_CRANK + pin].letter);
}

/* Draw the body between its pins, out to its loads, with its centre of mass. */
static void draw_body(sketch *s, const picture *p, const picture_row *r, const free_body *b)
{
    unsigned long i;

    if (b->is_slider)
        figure_piston(s, (pen)b->link, b->first, &r->now.state.link[b->link].axis);
    else if (p->v.kind.has_slot && b->link == FOURLINK_FOLLOWER)
        figure_lever(s, p, &r->now.state, PEN_FOLLOWER);
    else
        sketch_line(s, (pen)b->link, b->first, b->second);
    for (i = 0; i < p->v.problem.n_loads; i++)
        if (r->loads[i].link == b->link)
            figure_off(s, b->first, b->second,
                       figure_of_link(p, &r->now.state, b->link, &r->loads[i].at));
    if (p->v.design->link[b->link].mass > 0) {
        figure_off(s, b->first, b->second, b->G);
        sketch_centre(s, b->G);
    }
    draw_pin(s, p, b, 0);
    if (!b->is_slider)
        draw_pin(s, p, b, 1);
}

/* Draw the body with forces and torques. */
static void put_free_body(picture *p, const picture_row *r, const free_body *b)
{
    double inertia = p->v.design->link[b->link].inertia, alpha = r->now.state.link[b->link].alpha;
    double largest = arrow_largest(&b->forces), crank = p->v.design->link[FOURLINK_CRANK].length;
    char words[80];
    sketch s;

    sketch_open(&s, &p->on, 1.4 * b->length);
    s.letter = LETTER;
    draw_body(&s, p, r, b);
    if (largest > 0) {
        arrow_draw(&b->forces, &s, p, 0.8 * b->length / largest);
        arrow_draw_scale(&s, p, QUANTITY_FORCE, 0.8 * b->length / largest, largest);
    } else {
        sketch_note(&s, all_zero(QUANTITY_FORCE));
    }
    arrow_draw_load_torques(&s, p, r, b->link, 1);
    if (b->link == FOURLINK_CRANK)
        arrow_draw_torque(&s, p, PEN_FORCE, "Ts", zero, view_driving_torque(&p->v, &r->now.forces));
    if (p->v.kind.has_slot && b->link != FOURLINK_CRANK)
        arrow_draw_torque(&s, p, PEN_FORCE, b->is_slider ? "M" SUB_4 SUB_3 : "M" SUB_3 SUB_4,
                          b->first, b->is_slider ? -r->now.forces.M34 : r->now.forces.M34);
    if (p->v.kind.has_stroke && b->is_slider &&
        fabs(r->now.forces.M14) > ROUNDING * largest * crank)
        arrow_draw_torque(&s, p, PEN_FORCE, "M" SUB_1 SUB_4, b->first, r->now.forces.M14);
    if (alpha != 0 && inertia > 0)
        arrow_draw_torque(&s, p, PEN_RESULT, "-I\316\261", b->G, -inertia * alpha);
    if (b->circle[0].radius > 0 || b->circle[1].radius > 0)
        friction_circle_note(&s, b->circle_scale);
    flk_text_join(words, sizeof words, "free body of the ", p->v.kind.link[b->link], (char *)NULL);
    sketch_close(&s, words, p->v.units[QUANTITY_LENGTH].name);
}

/* Draw the same forces in sequence: the polygon closes. */
static void put_force_polygon(picture *p, const free_body *b)
{
    fourlink_vector at = zero;
    char words[80];
    polygon g;
    int i;

    open_polygon(&g, p, QUANTITY_FORCE);
    for (i = 0; i < b->forces.n; i++)
        at = put_side(&g, b->forces.list[i].kind, b->forces.list[i].name, at, b->forces.list[i].F);
    draw_sides(&g);
    flk_text_join(words, sizeof words, "forces on the ", p->v.kind.link[b->link], (char *)NULL);
    sketch_close(&g.s, words, p->v.units[QUANTITY_FORCE].name);
}

static void put_mechanism(picture *p, const fourlink_instant *now)
{
    sketch s;

    figure_open(&s, p, now->branch, 0);
    s.letter = LETTER;
    figure_frame(&s, p, &now->state);
    figure_draw(&s, p, &now->state, 1);
    spring_draw(&s, p, &now->state, 0);
    figure_close(&s, p, now, "");
}

const char *picture_vectors(picture *p, fourlink_branch branch)
{
    picture_row r;
    free_body bodies[FOURLINK_FOLLOWER + 1];
    int link, status = picture_position(p, branch, &r.now, r.loads);

    if (status != FOURLINK_OK)
        return fourlink_status_text(status);
    put_mechanism(p, &r.now);
    (p->v.kind.has_slot ? put_sliding : put_velocities)(p, &r.now.state);
    (p->v.kind.has_slot ? put_coriolis : put_accelerations)(p, &r.now.state);
    if (!p->v.problem.has_forces)
        return NULL;
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++) {
        open_body(&bodies[link], p, &r, link);
        put_free_body(p, &r, &bodies[link]);
    }
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
        put_force_polygon(p, &bodies[link]);
    return NULL;
}
