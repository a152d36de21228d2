/* SPDX-License-Identifier: GPL-3.0-or-later
**
** figure.c - a mechanism at one position, drawn to scale in the deck's unit of length.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "figure.h"
#include "base/format.h"
#include "tables/print.h"

#define STEPS 180 /* of a path */

/* Half of the piston's sides, as fractions of the drawing. */
#define PISTON_X 0.055
#define PISTON_Y 0.035

double figure_length(const deck *d, double si)
{
    return flk_unit_from_si(si, d->units[QUANTITY_LENGTH].unit);
}

fourlink_vector figure_point(const deck *d, fourlink_vector si)
{
    si.x = figure_length(d, si.x);
    si.y = figure_length(d, si.y);
    return si;
}

fourlink_vector figure_of_link(const deck *d, const fourlink_state *state, int link,
                               const fourlink_vector *at)
{
    fourlink_vector place = {0, 0};

    fourlink_point(state, link, at, &place, NULL, NULL);
    return figure_point(d, place);
}

/* A link's second pin. */
static fourlink_vector end_of(const deck *d, const fourlink_state *state, int link)
{
    fourlink_vector at = {0, 0};

    at.x = d->design.link[link].length;
    return figure_of_link(d, state, link, &at);
}

figure_pins figure_place(const deck *d, const fourlink_state *state)
{
    figure_pins pins;

    pins.A = figure_point(d, state->link[2].origin);
    pins.B = figure_point(d, state->link[3].origin);
    pins.C = end_of(d, state, 3);
    pins.D = figure_point(d, state->link[4].origin);
    if (d->design.kind == FOURLINK_SLIDER_CRANK)
        pins.D.y = 0;
    return pins;
}

/* Row k of STEPS + 1 spread over the motion; 0 where the links do not reach. */
static int sample(analysis *a, fourlink_branch branch, int k, result *r)
{
    analysis_spread(a, k, STEPS, &r->row);
    r->branch = branch;
    return fourlink_analyse(&a->d->mechanism, branch, &r->row.crank, NULL, 0, &r->state, NULL) ==
           FOURLINK_OK;
}

static fourlink_vector tracer(const deck *d, const fourlink_state *state, const deck_point *point)
{
    return figure_of_link(d, state, point->link, &point->at);
}

/* One position; of a piston with room for its guide. */
static void include_position(sketch *s, const deck *d, const fourlink_state *state, double margin)
{
    figure_pins pins = figure_place(d, state);
    fourlink_vector near = pins.C, far = pins.C;
    size_t i;

    near.x -= margin;
    far.x += margin;
    sketch_include(s, pins.A);
    sketch_include(s, pins.B);
    sketch_include(s, near);
    sketch_include(s, far);
    sketch_include(s, pins.D);
    for (i = 0; i < d->n_points; i++)
        sketch_include(s, tracer(d, state, &d->points[i]));
}

/* All positions of a branch. */
static void include_all(sketch *s, analysis *a, fourlink_branch branch, double margin)
{
    unsigned long i;
    int k;
    result r;

    for (k = 0; k <= STEPS; k++)
        if (sample(a, branch, k, &r))
            include_position(s, a->d, &r.state, margin);
    /* that of a motion which the samples miss */
    for (i = 0; i < a->range.n_rows && s->x_max < s->x_min; i++) {
        analysis_row(a, branch, i, &r);
        if (r.status == FOURLINK_OK)
            include_position(s, a->d, &r.state, margin);
    }
}

void figure_open(sketch *s, canvas *c, analysis *a, fourlink_branch branch, int all_of_it)
{
    sketch_open(s, c, 1);
    include_all(s, a, branch, 0);
    s->size = GSL_MAX_DBL(s->x_max - s->x_min, s->y_max - s->y_min);
    if (all_of_it) {
        if (a->d->design.kind == FOURLINK_SLIDER_CRANK)
            include_all(s, a, branch, 2 * PISTON_X * s->size);
        s->is_fixed = 1;
    } else {
        s->x_min = s->y_min = GSL_POSINF;
        s->x_max = s->y_max = GSL_NEGINF;
    }
}

void figure_frame(sketch *s, const deck *d, const fourlink_state *state)
{
    figure_pins pins = figure_place(d, state);

    sketch_support(s, pins.A);
    if (d->design.kind == FOURLINK_FOUR_BAR) {
        sketch_support(s, pins.D);
        sketch_line(s, PEN_CONSTRUCTION, pins.A, pins.D);
    } else {
        double r = figure_length(d, d->design.link[2].length);
        double side = state->branch == FOURLINK_OPEN ? 1 : -1;
        double reach = figure_length(d, d->mechanism.dead_centre);
        double near = reach - 2 * r - 1.5 * PISTON_X * s->size,
               far = reach + 1.5 * PISTON_X * s->size;
        double y = figure_length(d, d->design.offset), h = PISTON_Y * s->size;

        sketch_ground(s, side > 0 ? near : -far, side > 0 ? far : -near, y - h, -1);
        sketch_ground(s, side > 0 ? near : -far, side > 0 ? far : -near, y + h, 1);
    }
}

static void put_rectangle(sketch *s, pen p, fourlink_vector c, double x, double y)
{
    fourlink_vector corner[5];
    int i;

    for (i = 0; i < 5; i++) {
        corner[i].x = c.x + (i == 1 || i == 2 ? x : -x);
        corner[i].y = c.y + (i == 2 || i == 3 ? y : -y);
    }
    for (i = 0; i < 4; i++)
        sketch_line(s, p, corner[i], corner[i + 1]);
}

void figure_piston(sketch *s, fourlink_vector at)
{
    put_rectangle(s, PEN_FOLLOWER, at, PISTON_X * s->size, PISTON_Y * s->size);
}

void figure_outline(sketch *s, pen p, const deck *d, const fourlink_state *state)
{
    figure_pins pins = figure_place(d, state);

    sketch_line(s, p, pins.A, pins.B);
    sketch_line(s, p, pins.B, pins.C);
    if (d->design.kind == FOURLINK_FOUR_BAR)
        sketch_line(s, p, pins.D, pins.C);
    else
        put_rectangle(s, p, pins.C, PISTON_X * s->size, PISTON_Y * s->size);
}

void figure_links(sketch *s, const deck *d, const fourlink_state *state)
{
    figure_pins pins = figure_place(d, state);
    size_t i;
    int link;

    for (i = 0; i < d->n_points; i++) {
        const deck_point *point = &d->points[i];
        fourlink_vector p = tracer(d, state, point);

        sketch_line(s, (pen)point->link, figure_point(d, state->link[point->link].origin), p);
        if (point->link != FOURLINK_FOLLOWER || d->design.kind == FOURLINK_FOUR_BAR)
            sketch_line(s, (pen)point->link, end_of(d, state, point->link), p);
        sketch_text(s, p, 0.8, 0.8, point->name);
    }
    sketch_line(s, PEN_CRANK, pins.A, pins.B);
    sketch_line(s, PEN_COUPLER, pins.B, pins.C);
    if (d->design.kind == FOURLINK_FOUR_BAR) {
        sketch_line(s, PEN_FOLLOWER, pins.D, pins.C);
        sketch_pin(s, pins.D);
    } else {
        figure_piston(s, pins.C);
    }
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
        if (d->design.link[link].mass > 0)
            sketch_centre(s, figure_of_link(d, state, link, &d->design.link[link].cg));
    sketch_pin(s, pins.A);
    sketch_pin(s, pins.B);
    sketch_pin(s, pins.C);
}

static double direction(double from_x, double from_y, double *y)
{
    double length = gsl_hypot(from_x, from_y);

    *y = length > 0 ? from_y / length : 0;
    return length > 0 ? from_x / length : 0;
}

void figure_letter(sketch *s, fourlink_vector pin, fourlink_vector x, fourlink_vector y,
                   const char *letter)
{
    double up_x, up_y, dx, dy;

    dx = direction(pin.x - x.x, pin.y - x.y, &up_x);
    dx += direction(pin.x - y.x, pin.y - y.y, &up_y);
    dy = up_x + up_y;
    sketch_text(s, pin, dx, fabs(dx) + fabs(dy) > 1e-9 ? dy : 1, letter);
}

void figure_letters(sketch *s, const deck *d, const fourlink_state *state)
{
    figure_pins pins = figure_place(d, state);

    figure_letter(s, pins.A, pins.B, pins.B, "A");
    figure_letter(s, pins.B, pins.A, pins.C, "B");
    if (d->design.kind == FOURLINK_FOUR_BAR) {
        figure_letter(s, pins.C, pins.B, pins.D, "C");
        figure_letter(s, pins.D, pins.C, pins.C, "D");
    } else {
        figure_letter(s, pins.C, pins.B, pins.B, "C");
    }
}

void figure_slope(sketch *s, const deck *d)
{
    const deck_unit *u = &d->units[QUANTITY_ANGLE];
    fourlink_vector g = d->design.gravity;
    double slope = atan2(-g.x, -g.y);
    char words[120], number[FORMAT_SIZE];

    if (fabs(slope) < 1e-9 || (g.x == 0 && g.y == 0))
        return;
    sketch_note(s, flk_text_join(words, sizeof words, "x rises at ",
                                 format_general(flk_unit_from_si(slope, u->unit), 5, number), " ",
                                 u->name, (char *)NULL));
}

/* An angle: a ray along x, an arc, and the angle in the deck's unit. */
static void put_angle(sketch *s, const deck *d, fourlink_vector at, double angle, double radius,
                      const char *name)
{
    const deck_unit *u = &d->units[QUANTITY_ANGLE];
    char words[PRINT_MARK + 20], number[PRINT_MARK];
    fourlink_vector ray = at;
    double half = angle / 2;

    ray.x += 1.5 * radius * s->size;
    sketch_line(s, PEN_CONSTRUCTION, at, ray);
    if (angle >= 0)
        sketch_arc(s, PEN_CONSTRUCTION, at, radius * s->size, 0, angle);
    else
        sketch_arc(s, PEN_CONSTRUCTION, at, radius * s->size, angle, 0);
    flk_text_join(words, sizeof words, name, " = ",
                  print_mark(d, flk_unit_from_si(angle, u->unit), number), (char *)NULL);
    at.x += radius * s->size * cos(half);
    at.y += radius * s->size * sin(half);
    sketch_note(s, words);
    sketch_text(s, at, 0.5, sin(half) >= 0 ? 0.4 : -0.4, name);
}

#define THETA "\316\270" /* the Greek letter, and subscripts, in UTF-8 */

void figure_angles(sketch *s, const deck *d, const fourlink_state *state)
{
    figure_pins pins = figure_place(d, state);

    put_angle(s, d, pins.A, fmod(state->link[2].theta, 2 * M_PI), 0.09, THETA "\342\202\202");
    put_angle(s, d, pins.B, state->link[3].theta, 0.13, THETA "\342\202\203");
    if (d->design.kind == FOURLINK_FOUR_BAR)
        put_angle(s, d, pins.D, state->link[4].theta, 0.09, THETA "\342\202\204");
}

/* A curve of one point over the motion; `point` null: of C. */
static void put_path(sketch *s, analysis *a, fourlink_branch branch, const deck_point *point,
                     const double *until)
{
    char title[80];
    int k, drawn = 0;
    result r;

    flk_text_join(title, sizeof title, "path of ", point ? point->name : "C", (char *)NULL);
    sketch_curve(s, point ? PEN_PATH : PEN_CONSTRUCTION, title);
    for (k = 0; k <= STEPS; k++) {
        if (sample(a, branch, k, &r)) {
            if (until && fabs(r.row.angle - a->d->motion.from) >
                             fabs(*until - a->d->motion.from) * (1 + 1e-12))
                break;
            sketch_point(s, point ? tracer(a->d, &r.state, point) : figure_place(a->d, &r.state).C);
            drawn = 1;
        } else if (drawn) {
            sketch_break(s);
            drawn = 0;
        }
    }
    sketch_end(s);
}

void figure_paths(sketch *s, analysis *a, fourlink_branch branch, const double *until)
{
    size_t i;

    if (a->range.n_rows < 2)
        return;
    put_path(s, a, branch, NULL, until);
    for (i = 0; i < a->d->n_points; i++)
        put_path(s, a, branch, &a->d->points[i], until);
}

char *figure_title(const deck *d, const result *r, char out[FIGURE_TITLE])
{
    char number[FORMAT_SIZE];

    flk_text_join(out, FIGURE_TITLE, branch_name(r->branch),
                  ", theta2 = ", format_general(r->row.angle, 7, number), " ",
                  d->units[QUANTITY_ANGLE].name, (char *)NULL);
    return out;
}
