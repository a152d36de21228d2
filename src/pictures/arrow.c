/* SPDX-License-Identifier: GPL-3.0-or-later
**
** arrow.c - forces as arrows on one scale.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "arrow.h"
#include "system/format.h"

/* An arrow shorter than this fraction of the largest would have a head and no tail. */
#define SMALLEST 0.02

/* As fractions of the drawing: the radius of a torque, and of that of a spring around its coil. */
#define TORQUE 0.07
#define AROUND_COIL 0.08

void arrow_put(arrow_list *arrows, int number, pen kind, const char *name, fourlink_vector at,
               fourlink_vector F)
{
    arrow *new = &arrows->list[arrows->n];

    if (arrows->n == MOST_ARROWS)
        return;
    new->at = at;
    new->F = F;
    new->kind = kind;
    new->number = number;
    new->body = 0;
    flk_text_join(new->name, sizeof new->name, name, (char *)NULL);
    arrows->n++;
}

void arrow_add(arrow_list *arrows, int number, int body, pen kind, const char *name,
               fourlink_vector at, double x, double y)
{
    if (x == 0 && y == 0)
        return;
    arrow_put(arrows, number, kind, name, at, place_at(x, y));
    arrows->list[arrows->n - 1].body = body;
}

void arrow_add_force(arrow_list *arrows, const picture_row *r, int number)
{
    static const pen pens[] = {PEN_FORCE, PEN_LOAD, PEN_RESULT};
    const scene_force *f = &r->drawn.forces[number];
    fourlink_vector F = tracks_vector(&r->numbers, f->of);
    char words[40];

    arrow_add(arrows, number, tracks_body(&r->numbers, f->at), pens[f->sort],
              scene_words(f, words, sizeof words), tracks_vector(&r->numbers, f->at), f->sign * F.x,
              f->sign * F.y);
}

void arrow_cut(arrow_list *arrows, const sketch *s)
{
    int n = 0, i;

    for (i = 0; i < arrows->n; i++)
        if (sketch_shows(s, arrows->list[i].at))
            arrows->list[n++] = arrows->list[i];
    arrows->n = n;
}

double arrow_largest(const arrow_list *arrows)
{
    double largest = 0;
    int i;

    for (i = 0; i < arrows->n; i++) {
        double size = gsl_hypot(arrows->list[i].F.x, arrows->list[i].F.y);

        largest = size > largest ? size : largest;
    }
    return largest;
}

#define POSITIONS 72

double arrow_largest_of_motion(picture *p, fourlink_branch branch)
{
    fourlink_instant now;
    double largest = 0;
    tracks numbers;
    int k, i;

    for (k = 0; k < POSITIONS && p->v.range.n_rows > 1; k++) {
        if (picture_sample(p, branch, k, POSITIONS, NULL, &now, p->loads) != FOURLINK_OK ||
            now.state.mu < VIEW_NEAR)
            continue;
        tracks_find(&numbers, &p->v, &now, p->loads);
        for (i = 0; i < TRACK_COUNT; i++)
            if (numbers.list[i].is_there && numbers.list[i].q == QUANTITY_FORCE)
                largest = GSL_MAX_DBL(largest, gsl_hypot(numbers.list[i].v.x, numbers.list[i].v.y));
    }
    return largest;
}

double arrow_longest(const arrow_list *arrows, double largest_of_motion)
{
    double largest = arrow_largest(arrows);

    return largest < SMALLEST * largest_of_motion ? largest
                                                  : GSL_MAX_DBL(largest, largest_of_motion);
}

int arrow_draw(const arrow_list *arrows, sketch *s, const picture *p, double scale, double largest)
{
    int left_out = 0, i;

    for (i = 0; i < arrows->n; i++) {
        const arrow *x = &arrows->list[i];
        double size = gsl_hypot(x->F.x, x->F.y);

        if (size <= FORMAT_ROUNDING * largest)
            continue; /* it is rounding */
        sketch_show(s, SKETCH_FORCE, (unsigned long)x->number);
        if (x->name[0])
            figure_note(s, p, x->name, size, QUANTITY_FORCE);
        if (size < SMALLEST * largest) {
            left_out++;
            continue;
        }
        sketch_with(s, x->body);
        sketch_vector(s, x->kind, x->at, x->F, scale, x->name);
    }
    return left_out;
}

void arrow_note_missing(sketch *s, const picture *p, double largest)
{
    picture_number x;

    picture_value(p, SMALLEST * largest, QUANTITY_FORCE, &x);
    sketch_show(s, SKETCH_MISSING, 0);
    sketch_value(s, "no arrow below ", x.value, x.unit);
}

void arrow_draw_torque(sketch *s, const picture *p, int number, int body, pen kind,
                       const char *name, fourlink_vector at, double torque)
{
    double side = kind == PEN_FORCE ? -1 : 1, radius = TORQUE * s->size;
    fourlink_vector below = place_beside(at, 0.86 * radius * side, -0.5 * radius * side);

    if (torque == 0)
        return;
    sketch_show(s, SKETCH_TORQUE, (unsigned long)number);
    sketch_with(s, body);
    sketch_upright(s, at);
    sketch_torque(s, kind, at, name[0] ? radius : AROUND_COIL * s->size, torque);
    if (!name[0])
        return;
    sketch_text(s, below, side, -0.6 * side, name);
    figure_note(s, p, name, torque, QUANTITY_TORQUE);
}

void arrow_draw_load_torques(sketch *s, const picture *p, const picture_row *r, int link,
                             int is_free)
{
    int i;

    for (i = 0; i < r->drawn.n_torques; i++) {
        const scene_force *f = &r->drawn.torques[i];
        int slides = f->at == TRACK_B && link == p->v.kind.slotted;

        if (f->on == link && f->load && f->load != FOURLINK_LOAD_FRICTION)
            arrow_draw_torque(s, p, i, is_free && !slides ? link : tracks_body(&r->numbers, f->at),
                              PEN_LOAD, is_free || !f->is_inner ? f->name : "",
                              tracks_vector(&r->numbers, f->at),
                              tracks_vector(&r->numbers, f->of).x);
    }
}

void arrow_draw_scale(sketch *s, const picture *p, quantity q, double scale, double largest)
{
    double bar = view_si(&p->v, q, place_round(view_value(&p->v, q, largest) / 2.5));
    picture_number x;

    picture_value(p, bar, q, &x);
    sketch_show(s, SKETCH_OTHER, 0);
    sketch_scale(s, PEN_CONSTRUCTION, scale * bar, x.value, x.unit);
}
