/* SPDX-License-Identifier: GPL-3.0-or-later
**
** vectors.c - the graphical method at one position: velocity and acceleration polygons, free
** bodies and their polygons of forces, which close.
**
**    v_C = v_B + v_CB
**    a_C = a_B + a_CB^n + a_CB^t,  a^n = -omega^2 r, a^t = alpha x r
**    sum F - m a_G = 0
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "arrow.h"
#include "picture.h"
#include "tables/print.h"

/* Of these small drawings. */
#define LETTER 0.045

/* Below this fraction of the largest a side is shorter than the head of an arrow. */
#define SHORTEST 0.01

static const fourlink_vector zero = {0, 0};

/* One vector of a polygon. */
typedef struct side {
    fourlink_vector from, to; /* in the deck's unit of the quantity */
    pen p;
    char name[40];
} side;

#define MOST_SIDES (MOST_ARROWS + 4)

/* A polygon of vectors of one quantity. */
typedef struct polygon {
    sketch s;
    const deck *d;
    quantity q;
    side sides[MOST_SIDES];
    int n;
    fourlink_vector middle;
} polygon;

static fourlink_vector in_unit(const polygon *p, fourlink_vector si)
{
    si.x = flk_unit_from_si(si.x, p->d->units[p->q].unit);
    si.y = flk_unit_from_si(si.y, p->d->units[p->q].unit);
    return si;
}

static fourlink_vector midpoint(fourlink_vector x, fourlink_vector y)
{
    x.x = (x.x + y.x) / 2;
    x.y = (x.y + y.y) / 2;
    return x;
}

static fourlink_vector sum(fourlink_vector x, fourlink_vector y)
{
    x.x += y.x;
    x.y += y.y;
    return x;
}

/* Add a vector at the tip of another; where it ends. */
static fourlink_vector put_side(polygon *p, pen kind, const char *name, fourlink_vector from,
                                fourlink_vector v)
{
    side *new = &p->sides[p->n++];

    new->from = from;
    new->to = sum(from, v);
    new->p = kind;
    flk_text_join(new->name, sizeof new->name, name, (char *)NULL);
    return new->to;
}

static void open_polygon(polygon *p, canvas *c, const deck *d, quantity q)
{
    p->d = d;
    p->q = q;
    p->n = 0;
    sketch_open(&p->s, c, 1);
    p->s.letter = LETTER;
}

static double length_of(const side *x)
{
    return gsl_hypot(x->to.x - x->from.x, x->to.y - x->from.y);
}

static void find_size(polygon *p)
{
    int i;

    p->s.size = 0;
    p->middle = zero;
    for (i = 0; i < p->n; i++) {
        p->s.size = GSL_MAX_DBL(p->s.size, length_of(&p->sides[i]));
        p->middle.x += (p->sides[i].from.x + p->sides[i].to.x) / (2 * p->n);
        p->middle.y += (p->sides[i].from.y + p->sides[i].to.y) / (2 * p->n);
    }
    if (p->s.size == 0)
        p->s.size = 1;
}

/* Draw the sides; each has its name on the side that is away from the middle of the polygon.  One too
** short for a head has no name. */
static void draw_sides(polygon *p)
{
    char words[ARROW_WORDS];
    int i;

    find_size(p);
    for (i = 0; i < p->n; i++) {
        const side *x = &p->sides[i];
        double length = length_of(x), nx, ny, out;

        if (length <= 1e-12 * p->s.size)
            continue; /* rounding */
        sketch_note(&p->s,
                    arrow_words(p->d, x->name, flk_unit_to_si(length, p->d->units[p->q].unit), p->q,
                                words));
        if (length < SHORTEST * p->s.size) {
            sketch_line(&p->s, x->p, x->from, x->to);
            continue;
        }
        sketch_arrow(&p->s, x->p, x->from, x->to);
        nx = -(x->to.y - x->from.y) / length;
        ny = (x->to.x - x->from.x) / length;
        out = nx * (x->from.x - p->middle.x) + ny * (x->from.y - p->middle.y) < 0 ? -1 : 1;
        sketch_text(&p->s, midpoint(x->from, x->to), out * nx, out * ny, x->name);
    }
}

/* The letter of a corner, away from the middle. */
static void put_letter(polygon *p, fourlink_vector at, const char *letter)
{
    sketch_text(&p->s, at, at.x - p->middle.x, at.y - p->middle.y, letter);
}

/* Motion of pin C: of link 3 at its end. */
static void motion_of_C(const deck *d, const fourlink_state *state, fourlink_vector *v,
                        fourlink_vector *a)
{
    fourlink_vector at = {0, 0};

    at.x = d->design.link[FOURLINK_COUPLER].length;
    fourlink_point(state, FOURLINK_COUPLER, &at, NULL, v, a);
}

static void put_velocities(canvas *on, const deck *d, const result *r)
{
    fourlink_vector b, c, v_C, v_CB;
    polygon p;

    motion_of_C(d, &r->state, &v_C, NULL);
    v_CB.x = v_C.x - r->state.link[FOURLINK_COUPLER].velocity.x;
    v_CB.y = v_C.y - r->state.link[FOURLINK_COUPLER].velocity.y;
    open_polygon(&p, on, d, QUANTITY_SPEED);
    b = put_side(&p, PEN_CRANK, "vB", zero, in_unit(&p, r->state.link[FOURLINK_COUPLER].velocity));
    put_side(&p, PEN_FOLLOWER, "vC", zero, in_unit(&p, v_C));
    c = put_side(&p, PEN_COUPLER, "vCB", b, in_unit(&p, v_CB));
    draw_sides(&p);
    put_letter(&p, zero, "o");
    put_letter(&p, b, "b");
    put_letter(&p, c, "c");
    sketch_close(&p.s, "velocity polygon", d->units[p.q].name);
}

/* Normal and tangential part of the acceleration of a link's end about its origin. */
static void parts_of(const deck *d, const fourlink_state *state, int link, fourlink_vector *normal,
                     fourlink_vector *tangential)
{
    const fourlink_link_state *l = &state->link[link];
    double length = d->design.link[link].length;

    normal->x = -l->omega * l->omega * length * l->axis.x;
    normal->y = -l->omega * l->omega * length * l->axis.y;
    tangential->x = -l->alpha * length * l->axis.y;
    tangential->y = l->alpha * length * l->axis.x;
}

static void put_accelerations(canvas *on, const deck *d, const result *r)
{
    fourlink_vector n[5], t[5], a_C, b, c;
    polygon p;
    int i;

    motion_of_C(d, &r->state, NULL, &a_C);
    open_polygon(&p, on, d, QUANTITY_ACCELERATION);
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++) {
        parts_of(d, &r->state, i, &n[i], &t[i]);
        n[i] = in_unit(&p, n[i]);
        t[i] = in_unit(&p, t[i]);
    }
    b = put_side(&p, PEN_CRANK, "aBn", zero, n[FOURLINK_CRANK]);
    b = put_side(&p, PEN_CRANK, "aBt", b, t[FOURLINK_CRANK]);
    c = put_side(&p, PEN_COUPLER, "aCBn", b, n[FOURLINK_COUPLER]);
    c = put_side(&p, PEN_COUPLER, "aCBt", c, t[FOURLINK_COUPLER]);
    if (d->design.kind == FOURLINK_FOUR_BAR)
        put_side(&p, PEN_FOLLOWER, "aCt", put_side(&p, PEN_FOLLOWER, "aCn", zero, n[4]), t[4]);
    else
        put_side(&p, PEN_FOLLOWER, "aC", zero, in_unit(&p, a_C));
    draw_sides(&p);
    sketch_line(&p.s, PEN_CONSTRUCTION, zero, c);
    sketch_line(&p.s, PEN_CONSTRUCTION, b, c);
    put_letter(&p, zero, "o'");
    put_letter(&p, b, "b'");
    put_letter(&p, c, "c'");
    sketch_close(&p.s, "acceleration polygon", d->units[p.q].name);
}

/* The forces on one link: at its two pins, weight, loads, and -m a_G, with which they are balanced. */
static void collect(const analysis *a, const result *r, int link, arrow_list *arrows)
{
    const deck *d = a->d;
    const fourlink_forces *f = &r->forces;
    double m = d->design.link[link].mass;
    figure_pins pins = figure_place(d, &r->state);
    fourlink_vector G = figure_of_link(d, &r->state, link, &d->design.link[link].cg), a_G;

    arrows->n = 0;
    if (link == FOURLINK_CRANK) {
        arrow_add(arrows, PEN_FORCE, "F12", pins.A, f->F12x, f->F12y);
        arrow_add(arrows, PEN_FORCE, "F32", pins.B, -f->F23x, -f->F23y);
    } else if (link == FOURLINK_COUPLER) {
        arrow_add(arrows, PEN_FORCE, "F23", pins.B, f->F23x, f->F23y);
        arrow_add(arrows, PEN_FORCE, "F43", pins.C, -f->F34x, -f->F34y);
    } else if (d->design.kind == FOURLINK_FOUR_BAR) {
        arrow_add(arrows, PEN_FORCE, "F34", pins.C, f->F34x, f->F34y);
        arrow_add(arrows, PEN_FORCE, "F14", pins.D, f->F14x, f->F14y);
    } else {
        arrow_add(arrows, PEN_FORCE, "F34", pins.C, f->F34x, f->F34y);
        arrow_add(arrows, PEN_FORCE, "N", pins.C, 0, f->F14y);
    }
    arrow_add_loads(arrows, a, r, link);
    fourlink_point(&r->state, link, &d->design.link[link].cg, NULL, NULL, &a_G);
    arrow_add(arrows, PEN_RESULT, "-m aG", G, -m * a_G.x, -m * a_G.y);
}

static const char *name_of_link(const deck *d, int link)
{
    int four_bar = d->design.kind == FOURLINK_FOUR_BAR;

    return link == FOURLINK_CRANK     ? "crank"
           : link == FOURLINK_COUPLER ? (four_bar ? "coupler" : "rod")
                                      : (four_bar ? "rocker" : "piston");
}

/* Thin lines from the pins to a point of the link that is off its line. */
static void draw_off(sketch *s, fourlink_vector first, fourlink_vector second, fourlink_vector at)
{
    double along = gsl_hypot(second.x - first.x, second.y - first.y);
    double ways =
        gsl_hypot(at.x - first.x, at.y - first.y) + gsl_hypot(at.x - second.x, at.y - second.y);

    if (ways > along * (1 + 1e-9)) {
        sketch_line(s, PEN_CONSTRUCTION, first, at);
        sketch_line(s, PEN_CONSTRUCTION, second, at);
    }
}

/* The body of a link between its pins, out to where it is loaded, with its centre of mass at G. */
static void draw_body(sketch *s, const analysis *a, const result *r, int link,
                      fourlink_vector first, fourlink_vector second, fourlink_vector G)
{
    static const char *const letters[3][2] = {{"A", "B"}, {"B", "C"}, {"C", "D"}};
    const deck *d = a->d;
    int is_piston = first.x == second.x && first.y == second.y;
    unsigned long i;

    if (is_piston)
        figure_piston(s, first);
    else
        sketch_line(s, (pen)link, first, second);
    for (i = 0; i < a->n_loads; i++)
        if (a->loads[i].link == link)
            draw_off(s, first, second, figure_of_link(d, &r->state, link, &a->loads[i].at));
    if (d->design.link[link].mass > 0) {
        draw_off(s, first, second, G);
        sketch_centre(s, G);
    }
    sketch_pin(s, first);
    figure_letter(s, first, second, second, letters[link - 2][0]);
    if (!is_piston) {
        sketch_pin(s, second);
        figure_letter(s, second, first, first, letters[link - 2][1]);
    }
}

/* Forces and torques on it. */
static void draw_loads(sketch *s, const analysis *a, const result *r, int link,
                       fourlink_vector first, fourlink_vector G, double size)
{
    const deck *d = a->d;
    arrow_list arrows;

    collect(a, r, link, &arrows);
    if (arrow_largest(&arrows) > 0)
        arrow_draw(&arrows, s, d, 0.8 * size / arrow_largest(&arrows));
    arrow_draw_load_torques(s, a, r, link);
    if (link == FOURLINK_CRANK)
        arrow_draw_torque(s, d, PEN_FORCE, "Ts", zero, r->forces.Ts);
    if (r->state.link[link].alpha != 0 && d->design.link[link].inertia > 0)
        arrow_draw_torque(s, d, PEN_RESULT, "-I alpha", G,
                          -d->design.link[link].inertia * r->state.link[link].alpha);
    if (link == FOURLINK_FOLLOWER)
        arrow_draw_torque(s, d, PEN_FORCE, "M14", first, r->forces.M14);
}

/* A link cut free, with all that acts on it. */
static void put_free_body(canvas *on, const analysis *a, const result *r, int link)
{
    const deck *d = a->d;
    figure_pins pins = figure_place(d, &r->state);
    fourlink_vector first = link == FOURLINK_CRANK     ? pins.A
                            : link == FOURLINK_COUPLER ? pins.B
                                                       : pins.C;
    fourlink_vector second = link == FOURLINK_CRANK                ? pins.B
                             : link == FOURLINK_COUPLER            ? pins.C
                             : d->design.kind == FOURLINK_FOUR_BAR ? pins.D
                                                                   : pins.C;
    fourlink_vector G = figure_of_link(d, &r->state, link, &d->design.link[link].cg);
    double size = gsl_hypot(second.x - first.x, second.y - first.y);
    char words[ARROW_WORDS];
    sketch s;

    if (size == 0)
        size = figure_length(d, d->design.link[FOURLINK_CRANK].length);
    sketch_open(&s, on, 1.4 * size);
    s.letter = LETTER;
    draw_body(&s, a, r, link, first, second, G);
    draw_loads(&s, a, r, link, first, G, size);
    flk_text_join(words, sizeof words, "free body of the ", name_of_link(d, link), (char *)NULL);
    sketch_close(&s, words, d->units[QUANTITY_LENGTH].name);
}

/* The same forces one after the other: the polygon closes. */
static void put_force_polygon(canvas *on, const analysis *a, const result *r, int link)
{
    arrow_list arrows;
    fourlink_vector at = zero;
    char words[ARROW_WORDS];
    polygon p;
    int i;

    collect(a, r, link, &arrows);
    open_polygon(&p, on, a->d, QUANTITY_FORCE);
    for (i = 0; i < arrows.n; i++)
        at = put_side(&p, arrows.list[i].p, arrows.list[i].name, at, in_unit(&p, arrows.list[i].F));
    draw_sides(&p);
    flk_text_join(words, sizeof words, "forces on the ", name_of_link(a->d, link), (char *)NULL);
    sketch_close(&p.s, words, a->d->units[QUANTITY_FORCE].name);
}

static void put_mechanism(canvas *on, analysis *a, const result *r)
{
    char title[FIGURE_TITLE];
    sketch s;

    figure_open(&s, on, a, r->branch, 0);
    s.letter = LETTER;
    figure_frame(&s, a->d, &r->state);
    figure_links(&s, a->d, &r->state);
    figure_letters(&s, a->d, &r->state);
    figure_angles(&s, a->d, &r->state);
    figure_slope(&s, a->d);
    sketch_close(&s, figure_title(a->d, r, title), a->d->units[QUANTITY_LENGTH].name);
}

int plot_vectors(canvas *on, analysis *a, const plot_request *request, const char **why)
{
    fourlink_branch branch = a->d->open ? FOURLINK_OPEN : FOURLINK_CROSSED;
    int status, link;
    result r;

    status = plot_position(a, branch, request, &r);
    if (status != FOURLINK_OK) {
        *why = fourlink_status_text(status);
        return 0;
    }
    canvas_begin(on);
    put_mechanism(on, a, &r);
    put_velocities(on, a->d, &r);
    put_accelerations(on, a->d, &r);
    if (a->d->has_forces) {
        for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
            put_free_body(on, a, &r, link);
        for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
            put_force_polygon(on, a, &r, link);
    }
    canvas_end(on);
    return 1;
}
