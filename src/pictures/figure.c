/* SPDX-License-Identifier: GPL-3.0-or-later
**
** figure.c - a mechanism at one position, drawn to scale.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "figure.h"

#define STEPS 180 /* of a path */
#define HALVINGS 20

#define SLOT_PARTS 32 /* of a drawing, for each slot of a link */

/* Half the length of a block is at most this fraction of its crank. */
#define OF_CRANK 0.35

/* Greek letters, in UTF-8. */
#define OMEGA "\317\211"

char *figure_angle(const picture *p, double angle, int digits, char out[PICTURE_MARK])
{
    return picture_mark(p, view_value(&p->v, QUANTITY_ANGLE, angle), digits, out);
}

void figure_off(sketch *s, fourlink_vector first, fourlink_vector second, fourlink_vector at)
{
    double ways = place_distance(at, first) + place_distance(at, second);

    if (ways > place_distance(first, second) * (1 + 1e-9)) {
        sketch_line(s, PEN_CONSTRUCTION, first, at);
        sketch_line(s, PEN_CONSTRUCTION, second, at);
    } else {
        sketch_skip(s, 2);
    }
}

/* Half the length of a piston or a block. */
static double figure_block(const sketch *s)
{
    return s->block > 0 ? s->block : FIGURE_BLOCK * s->size;
}

figure_pins figure_place(const picture *p, const fourlink_state *state)
{
    figure_pins pins;

    pins.A = state->link[2].origin;
    pins.B = state->link[3].origin;
    pins.D = state->link[4].origin;
    pins.C = p->v.kind.guided ? pins.D : geometry_end(&p->v, state, FOURLINK_COUPLER);
    if (p->v.kind.guided)
        pins.D.y = 0;
    return pins;
}

/* The way of what slides in a guide or slot, with a margin at both ends. */
typedef void way_finder(const view *v, fourlink_branch branch, double *near, double *far);

static void find_way(const picture *p, way_finder *find, fourlink_branch branch, double margin,
                     double *from, double *to)
{
    double near, far;

    find(&p->v, branch, &near, &far);
    *from = GSL_MIN_DBL(near, far) - margin;
    *to = GSL_MAX_DBL(near, far) + margin;
}

/* The place of tracer point i, its name and its link. */
static fourlink_vector tracer(const picture *p, const fourlink_state *state, unsigned long i,
                              const char **name, int *link)
{
    fourlink_vector at = {0, 0};

    fourlink_deck_point(p->v.deck, i, name, link, &at);
    return geometry_of_link(state, *link, &at);
}

/* Make room for one position, and for the guide of a piston. */
static void include_position(sketch *s, const picture *p, const fourlink_state *state,
                             double margin)
{
    figure_pins pins = figure_place(p, state);
    double from, to;
    tracks places;
    int i;

    tracks_find_places(&places, &p->v, state);
    for (i = 0; i < TRACK_COUNT; i++)
        if (tracks_is_outline(&places, i))
            sketch_include(s, places.list[i].v);
    for (i = 0; i < p->v.design->n_groups; i++) {
        geometry_output x = geometry_find_output(&p->v, state, i);

        if (geometry_is_far(&p->v, state, i))
            continue;
        sketch_include(s, place_beside(x.Q, -margin, -margin));
        sketch_include(s, place_beside(x.Q, margin, margin));
        sketch_include(s, x.D);
        if (geometry_has_slot(&p->v, i)) {
            geometry_slot slot = geometry_find_slot(&p->v, state, i);

            sketch_include(s, x.P);
            sketch_include(s, place_in(slot.block, slot.axis, slot.from - margin, 0));
            sketch_include(s, place_in(slot.block, slot.axis, slot.to + margin, 0));
        }
    }
    sketch_include(s, place_beside(pins.C, -margin, 0));
    sketch_include(s, place_beside(pins.C, margin, 0));
    sketch_include(s, pins.D);
    if (p->v.kind.slotted) {
        find_way(p, geometry_find_way, state->branch, margin, &from, &to);
        sketch_include(s, geometry_on_slide(state, from));
        sketch_include(s, geometry_on_slide(state, to));
    }
}

/* Make room for all positions of a branch. */
static void include_all(sketch *s, const picture *p, fourlink_branch branch, double margin)
{
    fourlink_instant now;
    unsigned long i;
    int k;

    for (k = 0; k <= STEPS; k++)
        if (picture_state(p, branch, k, STEPS, &now) == FOURLINK_OK)
            include_position(s, p, &now.state, margin);
    /* of a motion that the samples miss */
    for (i = 0; i < p->v.range.n_rows && place_is_empty(&s->drawn); i++)
        if (fourlink_results_row(p->v.results, branch, i, NULL, &now, NULL) == FOURLINK_OK)
            include_position(s, p, &now.state, margin);
}

/* The size of the drawing of a branch, which a motion needs many times. */
static double size_of(picture *p, fourlink_branch branch)
{
    sketch all;

    if (p->size_branch != branch) {
        memset(&all, 0, sizeof all);
        all.drawn = place_nothing;
        all.c = &p->on;
        sketch_turn(&all, 1);
        include_all(&all, p, branch, 0);
        if (place_is_empty(&all.drawn)) { /* no position: the crank is drawn */
            double r = p->v.design->link[FOURLINK_CRANK].length;

            sketch_include(&all, place_at(-r, -r));
            sketch_include(&all, place_at(r, r));
        }
        p->size = GSL_MAX_DBL(all.drawn.x_max - all.drawn.x_min, all.drawn.y_max - all.drawn.y_min);
        p->size_branch = branch;
    }
    return p->size;
}

void figure_open(sketch *s, picture *p, fourlink_branch branch)
{
    const labels_motion *m = p->on.motion;

    sketch_open(s, &p->on, &p->v.units[QUANTITY_LENGTH], size_of(p, branch));
    if (p->v.problem.axes_on_page && !p->on.is_bare)
        sketch_place(s, p->v.problem.A);
    if (p->v.kind.slotted)
        s->block = GSL_MIN_DBL(FIGURE_BLOCK * s->size,
                               OF_CRANK * p->v.design->link[FOURLINK_CRANK].length);
    if (m && m->phase == LABELS_MEASURE && place_is_empty(&m->drawn)) /* once is enough */
        include_all(s, p, branch, p->v.kind.guided || p->v.kind.slotted ? 2 * figure_block(s) : 0);
}

/* How many outputs a state has: none, if it is of the four links alone. */
#define OUTPUTS_OF(state) (((state)->last - FOURLINK_FOLLOWER) / 2)

/* 1 if the slider of an output is far outside of a drawing that moves: there it is left out. */
static int is_away(const sketch *s, const picture *p, const fourlink_state *state, int i)
{
    return s->c->motion && geometry_is_far(&p->v, state, i);
}

/* The link on which the origin of another stays: 0 where it slides. */
static int carrier_of(const picture *p, int link)
{
    const fourlink_group *g;

    if (link <= FOURLINK_FOLLOWER)
        return link == FOURLINK_COUPLER ? FOURLINK_CRANK : 0;
    g = &p->v.design->group[(link - FOURLINK_FOLLOWER - 1) / 2];
    if (link % 2)
        return g->hang == FOURLINK_HANGS_IN_SLOT ? 0 : g->link;
    return g->end == FOURLINK_GROUP_TURNS ? g->to : 0;
}

void figure_bodies(sketch *s, const picture *p, const fourlink_state *state)
{
    int link;

    for (link = FOURLINK_CRANK; link <= state->last; link++) {
        sketch_with(s, carrier_of(p, link));
        sketch_body(s, link, state->link[link].origin, state->link[link].axis);
    }
}

/* The fixed pins of outputs, and their lines of stroke beside the sliders. */
static void put_frame_of_outputs(sketch *s, const picture *p, const fourlink_state *state)
{
    double beside = 3 * figure_block(s);
    int i;

    for (i = 0; i < OUTPUTS_OF(state); i++) {
        const fourlink_group *g = &p->v.design->group[i];
        geometry_output x = geometry_find_output(&p->v, state, i);

        sketch_with(s, g->end == FOURLINK_GROUP_SLIDES ? FOURLINK_END_OF(i) : FOURLINK_GROUND);
        if (is_away(s, p, state, i))
            sketch_skip(s, 1);
        else if (g->end == FOURLINK_GROUP_SLIDES)
            sketch_line(s, PEN_CONSTRUCTION, place_in(x.Q, g->direction, -beside, 0),
                        place_in(x.Q, g->direction, beside, 0));
        else if (g->to <= FOURLINK_GROUND)
            sketch_support(s, x.D);
    }
}

void figure_frame(sketch *s, const picture *p, const fourlink_state *state)
{
    figure_pins pins = figure_place(p, state);

    figure_bodies(s, p, state);
    sketch_show(s, SKETCH_FRAME, 0);
    sketch_support(s, pins.A);
    if (!p->v.kind.guided) {
        sketch_support(s, pins.D);
        sketch_line(s, PEN_CONSTRUCTION, pins.A, pins.D);
    } else {
        double h = FIGURE_HIGH * figure_block(s), y = p->v.design->offset, from, to;

        find_way(p, geometry_find_guide, state->branch, 1.5 * figure_block(s), &from, &to);
        sketch_ground(s, from, to, y - h, -1);
        sketch_ground(s, from, to, y + h, 1);
    }
    put_frame_of_outputs(s, p, state);
}

/* Draw a rectangle along an axis, from one distance to another, around the line through a place. */
static void put_rectangle(sketch *s, pen kind, fourlink_vector at, const fourlink_vector *axis,
                          double from, double to, double half)
{
    fourlink_vector corner[5];
    int i;

    for (i = 0; i < 5; i++) {
        double along = i == 1 || i == 2 ? to : from, across = i == 2 || i == 3 ? half : -half;

        corner[i] = place_in(at, *axis, along, across);
    }
    for (i = 0; i < 4; i++)
        sketch_line(s, kind, corner[i], corner[i + 1]);
}

void figure_piston(sketch *s, pen kind, fourlink_vector at, const fourlink_vector *axis)
{
    double half = figure_block(s);

    put_rectangle(s, kind, at, axis, -half, half, FIGURE_HIGH * half);
}

/* Draw the lever on from its arm and its slot to its points, loads and centre of mass. */
static void put_reach(sketch *s, const picture *p, const fourlink_state *state, pen kind,
                      double from, double to)
{
    const fourlink_link_state *lever = &state->link[FOURLINK_FOLLOWER];
    double inner = 0, outer = p->v.design->link[FOURLINK_FOLLOWER].length;

    if (outer == 0 && p->v.design->angle == 0) { /* the slot is on the axis */
        inner = GSL_MIN_DBL(from, 0);
        outer = GSL_MAX_DBL(to, 0);
    }
    if (p->v.lever_high > outer)
        sketch_line(s, kind, place_in(lever->origin, lever->axis, outer, 0),
                    place_in(lever->origin, lever->axis, p->v.lever_high, 0));
    if (p->v.lever_low < inner)
        sketch_line(s, kind, place_in(lever->origin, lever->axis, inner, 0),
                    place_in(lever->origin, lever->axis, p->v.lever_low, 0));
}

void figure_lever(sketch *s, const picture *p, const fourlink_state *state, pen kind)
{
    fourlink_vector D = state->link[FOURLINK_FOLLOWER].origin;
    double root = geometry_root(&p->v), from, to;

    find_way(p, geometry_find_way, state->branch, 1.5 * figure_block(s), &from, &to);
    put_rectangle(s, kind, geometry_on_slide(state, 0), &state->link[FOURLINK_COUPLER].axis, from,
                  to, FIGURE_HIGH * figure_block(s));
    sketch_mark(s, geometry_on_slide(state, from), "S1");
    sketch_mark(s, geometry_on_slide(state, to), "S2");
    sketch_line(s, kind, D, geometry_on_slide(state, root));
    if (root < from || root > to)
        sketch_line(s, kind, geometry_on_slide(state, root),
                    geometry_on_slide(state, root < from ? from : to));
    put_reach(s, p, state, kind, from, to);
}

/* Draw the line of a link from the joint where it begins to its other one: link 2 has joints 0 and 1. */
static void put_bar(sketch *s, const picture *p, const fourlink_state *state, int link, pen kind)
{
    int from = p->v.kind.begins[link], to = 2 * link - 3 - from;

    sketch_line(s, kind, geometry_joint(&p->v, state, from), geometry_joint(&p->v, state, to));
}

/* A slot and what joins it to its link: the line from P, or from the pin of a rocker. */
static void put_slot_itself(sketch *s, const picture *p, const fourlink_state *state, int i,
                            pen kind)
{
    geometry_slot x = geometry_find_slot(&p->v, state, i);
    geometry_output pins = geometry_find_output(&p->v, state, i);
    double half = figure_block(s), margin = 1.5 * half;
    fourlink_vector from = x.link == p->v.design->group[i].link ? pins.P : pins.D, foot;
    double along = x.axis.x * (from.x - x.block.x) + x.axis.y * (from.y - x.block.y);

    foot = place_in(x.block, x.axis, along, 0);
    put_rectangle(s, kind, x.block, &x.axis, x.from - margin, x.to + margin, FIGURE_HIGH * half);
    sketch_line(s, kind, from, foot);
    if (along < x.from - margin || along > x.to + margin)
        sketch_line(s, kind, foot,
                    place_in(x.block, x.axis, along < x.from ? x.from - margin : x.to + margin, 0));
}

/* The block of an output, and its slot. */
static void put_slot(sketch *s, const picture *p, const fourlink_state *state, int i, pen kind)
{
    geometry_slot x = geometry_find_slot(&p->v, state, i);
    double half = figure_block(s);

    sketch_show(s, SKETCH_LINK, (unsigned long)x.link);
    sketch_skip(s, SLOT_PARTS * (1 + (unsigned long)i)); /* behind those of the link itself */
    sketch_with(s, x.link);
    put_slot_itself(s, p, state, i, kind ? kind : FIGURE_PEN(x.link));
    if (is_away(s, p, state, i))
        return;
    sketch_show(s, SKETCH_LINK, (unsigned long)FOURLINK_ROD_OF(i));
    sketch_with(s, FOURLINK_ROD_OF(i));
    put_rectangle(s, kind ? kind : FIGURE_PEN(FOURLINK_FOLLOWER + 1 + 2 * i), x.block, &x.axis,
                  -0.8 * half, 0.8 * half, FIGURE_HIGH * half);
}

void figure_output_link(sketch *s, const picture *p, const fourlink_state *state, int link)
{
    int i = (link - FOURLINK_FOLLOWER - 1) / 2;
    const fourlink_group *g = &p->v.design->group[i];
    geometry_output x = geometry_find_output(&p->v, state, i);

    if (link % 2)
        sketch_line(s, FIGURE_PEN(link), x.P, x.Q);
    else if (g->end == FOURLINK_GROUP_SLIDES)
        figure_piston(s, FIGURE_PEN(link), x.Q, &g->direction);
    else if (g->hang != FOURLINK_HANGS_BY_OWN_SLOT)
        sketch_line(s, FIGURE_PEN(link), x.D, x.Q);
    if (link % 2 == 0 && g->hang == FOURLINK_HANGS_BY_OWN_SLOT)
        put_slot_itself(s, p, state, i, FIGURE_PEN(link));
}

static void put_outputs(sketch *s, const picture *p, const fourlink_state *state, pen kind)
{
    int i;

    for (i = 0; i < OUTPUTS_OF(state); i++) {
        geometry_output x = geometry_find_output(&p->v, state, i);
        int rod = FOURLINK_FOLLOWER + 1 + 2 * i;
        pen of_end = kind ? kind : FIGURE_PEN(rod + 1);

        if (geometry_has_slot(&p->v, i))
            put_slot(s, p, state, i, kind);
        else {
            sketch_show(s, SKETCH_LINK, (unsigned long)rod);
            sketch_with(s, rod);
            sketch_line(s, kind ? kind : FIGURE_PEN(rod), x.P, x.Q);
        }
        sketch_show(s, SKETCH_LINK, (unsigned long)rod + 1);
        sketch_with(s, rod + 1);
        if (is_away(s, p, state, i))
            continue;
        if (p->v.design->group[i].end == FOURLINK_GROUP_SLIDES)
            figure_piston(s, of_end, x.Q, &p->v.design->group[i].direction);
        else if (p->v.design->group[i].hang != FOURLINK_HANGS_BY_OWN_SLOT)
            sketch_line(s, of_end, x.D, x.Q);
    }
}

void figure_outline(sketch *s, const picture *p, const fourlink_state *state, pen kind)
{
    int i;

    for (i = 0; i < 3; i++) {
        int link = p->v.kind.drawn[i];
        const fourlink_link_state *x = &state->link[link];
        pen own = kind ? kind : (pen)link;

        sketch_show(s, SKETCH_LINK, (unsigned long)link);
        sketch_with(s, link);
        if (p->v.kind.shape[link] == FOURLINK_SHAPE_BAR)
            put_bar(s, p, state, link, own);
        if (link == p->v.kind.slotted)
            figure_lever(s, p, state, own);
        if (p->v.kind.slides_on[link])
            figure_piston(s, own, x->origin, &x->axis);
    }
    put_outputs(s, p, state, kind);
}

static void put_pin(sketch *s, unsigned long joint, int link, fourlink_vector at,
                    const char *letter)
{
    sketch_show(s, SKETCH_PIN, joint);
    sketch_with(s, link);
    sketch_pin(s, at, letter);
}

/* The pins of outputs, with their names at Q. */
static void put_pins_of_outputs(sketch *s, const picture *p, const fourlink_state *state)
{
    char fitting[LABELS_WORDS];
    int i;

    for (i = 0; i < p->v.design->n_groups; i++) {
        geometry_output x = geometry_find_output(&p->v, state, i);
        int end = FOURLINK_FOLLOWER + 2 + 2 * i, first = FOURLINK_FOLLOWER + 3 * i;

        if (is_away(s, p, state, i))
            continue;
        if (p->v.design->group[i].hang != FOURLINK_HANGS_IN_SLOT)
            put_pin(s, (unsigned long)first, p->v.design->group[i].link, x.P, "");
        if (p->v.design->group[i].hang != FOURLINK_HANGS_BY_OWN_SLOT)
            put_pin(s, (unsigned long)first + 1, end, x.Q, "");
        if (p->v.design->group[i].end == FOURLINK_GROUP_TURNS)
            put_pin(s, (unsigned long)first + 2, end, x.D, "");
        sketch_with(s, p->v.design->group[i].hang == FOURLINK_HANGS_BY_OWN_SLOT &&
                               p->v.design->group[i].end == FOURLINK_GROUP_TURNS
                           ? p->v.design->group[i].link
                           : end);
        sketch_upright(s, x.Q);
        sketch_name(s, x.Q, 0.8, 0.8,
                    canvas_shorten(fourlink_deck_link_text(p->v.deck, end), FIGURE_NAME, 0, fitting,
                                   sizeof fitting));
    }
}

/* Let the next text stand outward of the middle of a link, if a script places it. */
static void go_outward(sketch *s, const picture *p, const fourlink_state *state, int link)
{
    sketch_with(s, link == p->v.kind.slotted ? 0 : link);
    sketch_away(s, link > FOURLINK_FOLLOWER
                       ? state->link[link].origin
                       : place_middle(geometry_joint(&p->v, state, link - FOURLINK_CRANK),
                                      geometry_joint(&p->v, state, link - FOURLINK_CRANK + 1)));
}

static void put_links(sketch *s, const picture *p, const fourlink_state *state)
{
    figure_pins pins = figure_place(p, state);
    char fitting[LABELS_WORDS], own[TRACKS_NAME];
    unsigned long i;
    const char *name;
    int link;

    for (link = FOURLINK_CRANK; link <= state->last; link++)
        hull_draw(s, p, state, link);
    figure_outline(s, p, state, PEN_OF_LINK);
    for (i = 0; i < p->v.problem.n_points; i++) {
        fourlink_vector at = tracer(p, state, i, &name, &link);

        sketch_show(s, SKETCH_POINT, i);
        go_outward(s, p, state, link);
        sketch_with(s, link);
        sketch_dot(s, at, tracks_name("P", i, own));
        sketch_name(s, at, 0.8, 0.8, canvas_shorten(name, FIGURE_NAME, 0, fitting, sizeof fitting));
    }
    if (!p->v.kind.guided)
        put_pin(s, 3, FOURLINK_GROUND, pins.D, "D");
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
        if (p->v.design->link[link].mass > 0) {
            sketch_show(s, SKETCH_CENTRE, (unsigned long)link);
            sketch_with(s, link);
            sketch_centre(s, geometry_of_link(state, link, &p->v.design->link[link].cg),
                          tracks_name("G", (unsigned long)link, own));
        }
    put_pins_of_outputs(s, p, state);
    put_pin(s, 0, FOURLINK_GROUND, pins.A, "A");
    put_pin(s, 1, FOURLINK_CRANK, pins.B, "B");
    sketch_with(s, FOURLINK_FOLLOWER);
    if (!p->v.kind.slotted) /* C is B */
        put_pin(s, 2, FOURLINK_FOLLOWER, pins.C, "C");
    else if (p->v.kind.guided)
        sketch_mark(s, pins.C, "C");
}

/* The unit vector from one place to another; 0 if they are the same. */
static fourlink_vector direction(fourlink_vector from, fourlink_vector to)
{
    double x = to.x - from.x, y = to.y - from.y, length = gsl_hypot(x, y);

    return length > 0 ? place_at(x / length, y / length) : place_at(0, 0);
}

void figure_letter(sketch *s, fourlink_vector pin, fourlink_vector x, fourlink_vector y,
                   const char *letter)
{
    fourlink_vector from_x = direction(x, pin), from_y = direction(y, pin);
    double dx = from_x.x + from_y.x, dy = from_x.y + from_y.y;

    sketch_letter(s, pin, dx, fabs(dx) + fabs(dy) > 1e-9 ? dy : 1, letter);
}

void figure_beyond_block(sketch *s)
{
    sketch_beyond(s, FIGURE_HIGH * figure_block(s));
}

/* Letters that do not jump from position to position: beside the supports, outward of crank and rocker. */
#define BESIDE \
    0.03 /* of the drawing, from a pin to the edge of its support, unless a script finds room */

static void put_steady_letters(sketch *s, const picture *p, const fourlink_state *state)
{
    figure_pins pins = figure_place(p, state);
    fourlink_vector below = place_beside(pins.C, 0, -1), from = p->v.kind.guided ? below : pins.D;
    double beside = s->c->is_bare ? 0 : BESIDE * s->size;
    const int *slides_on = p->v.kind.slides_on;

    sketch_letter(s, place_beside(pins.A, -beside, -beside), -1, 0, "A");
    sketch_with(s, FOURLINK_CRANK);
    if (slides_on[FOURLINK_COUPLER])
        figure_beyond_block(s);
    figure_letter(s, pins.B, pins.A, pins.A, "B");
    if (slides_on[FOURLINK_FOLLOWER])
        figure_beyond_block(s);
    sketch_with(s, FOURLINK_FOLLOWER);
    if (p->v.kind.shape[FOURLINK_FOLLOWER] != FOURLINK_SHAPE_LEVER)
        figure_letter(s, pins.C, from, from, "C");
    sketch_with(s, FOURLINK_GROUND);
    if (!p->v.kind.guided)
        sketch_letter(s, place_beside(pins.D, beside, -beside), 1, 0, "D");
}

static void put_letters(sketch *s, const picture *p, const fourlink_state *state)
{
    figure_pins pins = figure_place(p, state);
    fourlink_shape shape = p->v.kind.shape[FOURLINK_FOLLOWER];
    fourlink_vector C = p->v.kind.slotted ? geometry_on_slide(state, geometry_root(&p->v)) : pins.C;

    figure_letter(s, pins.A, pins.B, pins.B, "A");
    figure_letter(s, pins.B, pins.A, pins.C, "B");
    if (shape != FOURLINK_SHAPE_LEVER || p->v.design->link[FOURLINK_FOLLOWER].length > 0)
        figure_letter(s, C, pins.B, shape == FOURLINK_SHAPE_BLOCK ? pins.B : pins.D, "C");
    if (!p->v.kind.guided)
        figure_letter(s, pins.D, pins.C, pins.C, "D");
}

/* Where the angle of a link stands, and its radius as a fraction of the drawing. */
typedef struct link_angle {
    fourlink_vector at;
    double angle, radius;
    const char *name;
} link_angle;

static link_angle angle_of(const picture *p, const fourlink_state *state, int link)
{
    static const char *const names[] = {"", "", FIGURE_THETA SUB_2, FIGURE_THETA SUB_3,
                                        FIGURE_THETA SUB_4};
    static const double radii[] = {0, 0, 0.09, 0.13, 0.09};
    figure_pins pins = figure_place(p, state);
    link_angle x;

    x.at = link == FOURLINK_CRANK                  ? pins.A
           : link == FOURLINK_FOLLOWER             ? pins.D
           : p->v.kind.guided && p->v.kind.slotted ? pins.C
                                                   : pins.B;
    x.angle = state->link[link].theta;
    if (link == FOURLINK_CRANK)
        x.angle = fmod(x.angle, 2 * M_PI);
    x.angle = view_direction(&p->v, x.angle);
    x.radius = radii[link];
    x.name = names[link];
    return x;
}

/* Draw a ray along x, and an arc, with a symbol. */
static void put_arc(sketch *s, const picture *p, const link_angle *x)
{
    double from = p->v.problem.axes_on_page ? -p->v.problem.x_angle : 0, half = from + x->angle / 2;
    double radius = x->radius * s->size;

    sketch_line(s, PEN_CONSTRUCTION, x->at, place_polar(x->at, 1.5 * radius, from));
    sketch_arc(s, PEN_CONSTRUCTION, x->at, radius, from + GSL_MIN_DBL(x->angle, 0),
               from + GSL_MAX_DBL(x->angle, 0));
    if (s->c->motion)
        sketch_text_around(s, x->at, radius, half, x->name);
    else
        sketch_text(s, place_polar(x->at, radius, half), 0.5, sin(half) >= 0 ? 0.4 : -0.4, x->name);
}

void figure_arc(sketch *s, const picture *p, const fourlink_state *state, int link)
{
    link_angle x = angle_of(p, state, link);

    sketch_show(s, SKETCH_ANGLE, (unsigned long)link);
    put_arc(s, p, &x);
}

/* Put the angle of a link beside the drawing, in the deck's unit, and draw it; in a motion that of the
** crank alone. */
static void put_angle(sketch *s, const picture *p, const fourlink_state *state, int link)
{
    link_angle x = angle_of(p, state, link);
    picture_number value;
    char words[40];

    picture_angle(p, view_value(&p->v, QUANTITY_ANGLE, x.angle), 4, &value);
    sketch_show(s, SKETCH_ANGLE, (unsigned long)link);
    sketch_value(s, flk_text_join(words, sizeof words, x.name, " = ", (char *)NULL), value.value,
                 value.unit);
    if (!s->c->motion || link == FOURLINK_CRANK)
        put_arc(s, p, &x);
}

static void put_angles(sketch *s, const picture *p, const fourlink_state *state)
{
    put_angle(s, p, state, FOURLINK_CRANK);
    if (!p->v.kind.slotted || p->v.design->angle != 0)
        put_angle(s, p, state, FOURLINK_COUPLER);
    if (!p->v.kind.guided)
        put_angle(s, p, state, FOURLINK_FOLLOWER);
}

/* Put the numbers of the links beside their middles; that of the ground below A. */
static void put_numbers(sketch *s, const picture *p, const fourlink_state *state)
{
    static const char *const numbers[] = {"", "", "2", "3", "4"};
    figure_pins pins = figure_place(p, state);
    fourlink_vector from[5], to[5];
    int link;

    sketch_show(s, SKETCH_NUMBERS, 0);
    from[2] = pins.A;
    to[2] = from[3] = pins.B;
    to[3] = to[4] = pins.C;
    from[4] = pins.D;
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++) {
        const fourlink_vector *axis = &state->link[link].axis;
        double half = figure_block(s);
        fourlink_vector at = p->v.kind.slides_on[link]
                                 ? place_in(to[link], *axis, half, FIGURE_HIGH * half)
                                 : place_middle(from[link], to[link]);

        sketch_with(s, p->v.kind.guided && p->v.kind.slotted && link == FOURLINK_COUPLER
                           ? FOURLINK_FOLLOWER
                           : link);
        if (p->v.kind.shape[link] == FOURLINK_SHAPE_LEVER) { /* on which B slides */
            sketch_along(s, from[link], FOURLINK_CRANK, to[link], 1);
            sketch_away(s, place_in(at, direction(from[link], to[link]), 0, -half));
        }
        sketch_number(s, at, -axis->y, axis->x, numbers[link]);
    }
    sketch_with(s, FOURLINK_GROUND);
    sketch_number(s, place_beside(pins.A, 0, -0.05 * s->size), 0, -1, "1");
}

/* The sense of rotation: an arc ahead of the crank, as fractions of the drawing and in rad. */
#define SENSE 0.125
#define AHEAD 0.35
#define LONG 0.8

void figure_sense(sketch *s, const fourlink_state *state, fourlink_vector A)
{
    double omega = state->link[FOURLINK_CRANK].omega, sign = omega < 0 ? -1 : 1;
    double from = state->link[FOURLINK_CRANK].theta + sign * AHEAD, radius = SENSE * s->size;
    double middle = from + sign * LONG / 2;

    if (omega == 0)
        return;
    sketch_show(s, SKETCH_SENSE, omega < 0);
    sketch_with(s, FOURLINK_CRANK);
    sketch_turn_arrow(s, PEN_SENSE, A, radius, from, from + sign * LONG);
    sketch_text_around(s, A, radius, middle, OMEGA SUB_2);
}

void figure_note(sketch *s, const picture *p, const char *name, double si, quantity q)
{
    char words[PICTURE_WORDS], fitting[PICTURE_WORDS];
    picture_number x;

    picture_value(p, si, q, &x);
    name = canvas_shorten(name, PICTURE_NAME, 0, fitting, sizeof fitting);
    sketch_value(s, flk_text_join(words, sizeof words, name, " = ", (char *)NULL), x.value, x.unit);
}

void figure_slope(sketch *s, const picture *p)
{
    char mark[PICTURE_MARK];

    sketch_show(s, SKETCH_SLOPE, 0);
    if (p->on.turn != 0 && !p->v.problem.axes_on_page)
        sketch_note(s, "x rises at %s", figure_angle(p, p->on.turn, 4, mark));
}

void figure_gravity(sketch *s, const picture *p)
{
    double left = s->drawn.x_min - (s->c->motion ? 0 : 0.1 * s->size), top = s->drawn.y_max;
    fourlink_vector to = place_at(left, top - 0.12 * s->size), axis;

    if (s->c->motion && s->c->motion->phase == LABELS_MEASURE) /* the range is not yet known */
        return;

    sketch_show(s, SKETCH_GRAVITY, 0);
    sketch_turn(s, 0);
    if (geometry_has_weight(&p->v)) {
        sketch_arrow(s, PEN_LOAD, place_at(left, top), to);
        if (s->c->motion)
            sketch_text(s, place_beside(to, 0, 0.06 * s->size), 1, 0, "g");
        else
            sketch_text(s, to, -1, 0.5, "g");
    }
    sketch_turn(s, 1);
    if (p->on.turn == 0)
        return;
    axis = place_polar(place_at(0, 0), 0.2 * s->size, p->v.problem.axes_on_page ? -p->on.turn : 0);
    sketch_arrow(s, PEN_CONSTRUCTION, place_at(0, 0), axis);
    sketch_text(s, axis, 1, 0, "x");
}

void figure_draw(sketch *s, const picture *p, const fourlink_state *state, int has_angles)
{
    put_links(s, p, state);
    sketch_show(s, SKETCH_LETTER, 0);
    (s->c->motion ? put_steady_letters : put_letters)(s, p, state);
    figure_sense(s, state, figure_place(p, state).A);
    if (has_angles)
        put_angles(s, p, state);
    put_numbers(s, p, state);
    figure_slope(s, p);
}

/* Where tracer point i, or behind the last of them C, is after k of STEPS; not a number where it is not. */
static fourlink_vector on_path(const picture *p, fourlink_branch branch, unsigned long i, double k)
{
    fourlink_instant now;
    const char *name;
    int link;

    if (picture_state(p, branch, k, STEPS, &now) != FOURLINK_OK)
        return place_at(GSL_NAN, GSL_NAN);
    return i < p->v.problem.n_points ? tracer(p, &now.state, i, &name, &link)
                                     : figure_place(p, &now.state).C;
}

/* Its last place between a step that the linkage reaches and one that it does not: near a dead position
** it goes far in one step. */
static fourlink_vector end_of_path(const picture *p, fourlink_branch branch, unsigned long i,
                                   double reached, double beyond)
{
    fourlink_vector last = on_path(p, branch, i, reached), at;
    int n;

    for (n = 0; n < HALVINGS; n++) {
        double k = (reached + beyond) / 2;

        at = on_path(p, branch, i, k);
        if (gsl_isnan(at.x)) {
            beyond = k;
        } else {
            reached = k;
            last = at;
        }
    }
    return last;
}

static void put_path(sketch *s, const picture *p, fourlink_branch branch, unsigned long i)
{
    fourlink_vector points[2 * STEPS + 2], next;
    int is_tracer = i < p->v.problem.n_points, pen_of = PEN_CONSTRUCTION, link, n = 0, k;
    const char *name = "C";
    fourlink_vector at;
    char title[80];

    if (is_tracer) {
        fourlink_deck_point(p->v.deck, i, &name, &link, &at);
        pen_of = i == 0 ? PEN_PATH : PEN_COUNT - 1 + (int)i;
    }
    for (k = 0; k <= STEPS; k++) {
        next = on_path(p, branch, i, k);
        if (n && gsl_isnan(next.x) != gsl_isnan(points[n - 1].x)) {
            points[n] = gsl_isnan(next.x) ? end_of_path(p, branch, i, k - 1, k)
                                          : end_of_path(p, branch, i, k, k - 1);
            n++;
        }
        points[n++] = next;
    }
    sketch_show(s, SKETCH_PATH, i);
    sketch_curve(s, (pen)pen_of, flk_text_join(title, sizeof title, "path of ", name, (char *)NULL),
                 points, n);
}

void figure_paths(sketch *s, const picture *p, fourlink_branch branch)
{
    unsigned long i;

    if (p->v.range.n_rows < 2)
        return;
    if (p->on.is_bare && !p->on.motion->is_first)
        return;
    if (!p->v.kind.slotted && p->request->file != PLOT_TXT) /* in letters it hides the links */
        put_path(s, p, branch, p->v.problem.n_points);
    for (i = 0; i < p->v.problem.n_points; i++)
        put_path(s, p, branch, i);
}

void figure_close(sketch *s, const picture *p, const fourlink_instant *now, const char *before)
{
    const fourlink_abscissa *over = &p->v.problem.over;
    char mark[PICTURE_MARK], place[PICTURE_WORDS] = "";

    if (!over->is_crank_angle)
        picture_words(p, over->symbol, now->row.place, p->v.over, place);
    sketch_close(s, "%s%s, " FIGURE_THETA SUB_2 " = %s%s%s%s%s", before,
                 fourlink_branch_text(now->branch), picture_mark(p, now->row.angle, 7, mark),
                 place[0] ? ", " : "", place, p->why[0] ? ", " : "", p->why);
}
