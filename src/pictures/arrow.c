/* SPDX-License-Identifier: GPL-3.0-or-later
**
** arrow.c - forces as arrows on one scale.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "arrow.h"

/* An arrow shorter than this fraction of the largest would have a head and no tail. */
#define SMALLEST 0.02

void arrow_put(arrow_list *arrows, pen kind, const char *name, fourlink_vector at,
               fourlink_vector F)
{
    arrow *new = &arrows->list[arrows->n];

    if (arrows->n == MOST_ARROWS)
        return;
    new->at = at;
    new->F = F;
    new->kind = kind;
    flk_text_join(new->name, sizeof new->name, name, (char *)NULL);
    arrows->n++;
}

void arrow_add(arrow_list *arrows, pen kind, const char *name, fourlink_vector at, double x,
               double y)
{
    if (x != 0 || y != 0)
        arrow_put(arrows, kind, name, at, place_at(x, y));
}

void arrow_add_joint(arrow_list *arrows, const picture *p, const picture_row *r, int by, int on)
{
    const fourlink_forces *f = &r->now.forces;
    figure_pins pins = figure_place(p, &r->now.state);

    if (by == FOURLINK_GROUND && on == FOURLINK_CRANK)
        arrow_add(arrows, PEN_FORCE, "F" SUB_1 SUB_2, pins.A, f->F12x, f->F12y);
    else if (by == FOURLINK_CRANK)
        arrow_add(arrows, PEN_FORCE, "F" SUB_2 SUB_3, pins.B, f->F23x, f->F23y);
    else if (by == FOURLINK_COUPLER && on == FOURLINK_CRANK)
        arrow_add(arrows, PEN_FORCE, "F" SUB_3 SUB_2, pins.B, -f->F23x, -f->F23y);
    else if (by == FOURLINK_COUPLER)
        arrow_add(arrows, PEN_FORCE, "F" SUB_3 SUB_4, pins.C, f->F34x, f->F34y);
    else if (by == FOURLINK_FOLLOWER)
        arrow_add(arrows, PEN_FORCE, "F" SUB_4 SUB_3, pins.C, -f->F34x, -f->F34y);
    else if (p->v.kind.has_stroke) /* F14x is the friction, a load */
        arrow_add(arrows, PEN_FORCE, "N", pins.C, 0, f->F14y);
    else
        arrow_add(arrows, PEN_FORCE, "F" SUB_1 SUB_4, pins.D, f->F14x, f->F14y);
}

/* F34 has the friction of a slider on its lever; N is without that of a piston. */
static int is_drawn(const picture *p, const fourlink_load_info *load, int is_free)
{
    if (load->sort == FOURLINK_LOAD_FRICTION)
        return p->v.kind.has_stroke;
    return is_free || load->sort != FOURLINK_LOAD_SPRING;
}

void arrow_add_loads(arrow_list *arrows, const picture *p, const picture_row *r, int link,
                     int is_free)
{
    static const char *const weights[5] = {"", "", "W" SUB_2, "W" SUB_3, "W" SUB_4};
    const fourlink_link *body = &p->v.design->link[link];
    const fourlink_state *state = &r->now.state;
    fourlink_load_info info;
    unsigned long i;

    arrow_add(arrows, PEN_LOAD, weights[link], figure_of_link(p, state, link, &body->cg),
              body->mass * p->v.design->gravity.x, body->mass * p->v.design->gravity.y);
    for (i = 0; fourlink_deck_load(p->v.deck, i, &info) == FOURLINK_OK; i++) {
        const fourlink_load *load = &r->loads[i];
        fourlink_vector F = geometry_force(load, state);

        if (info.link != link || !is_drawn(p, &info, is_free))
            continue;
        arrow_add(arrows, PEN_LOAD, info.name, figure_of_link(p, state, link, &load->at), F.x, F.y);
    }
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

void arrow_draw(const arrow_list *arrows, sketch *s, const picture *p, double scale)
{
    double largest = arrow_largest(arrows);
    int i;

    for (i = 0; i < arrows->n; i++) {
        const arrow *x = &arrows->list[i];
        double size = gsl_hypot(x->F.x, x->F.y);
        fourlink_vector end = place_beside(x->at, scale * x->F.x, scale * x->F.y);

        figure_note(s, p, x->name, size, QUANTITY_FORCE);
        if (size < SMALLEST * largest)
            continue;
        sketch_arrow(s, x->kind, x->at, end);
        sketch_text(s, end, x->F.x, x->F.y, x->name);
    }
}

void arrow_draw_torque(sketch *s, const picture *p, pen kind, const char *name, fourlink_vector at,
                       double torque)
{
    double side = kind == PEN_FORCE ? -1 : 1, radius = 0.07 * s->size; /* of the letters */
    fourlink_vector below = place_beside(at, 0.86 * radius * side, -0.5 * radius * side);

    if (torque == 0)
        return;
    sketch_torque(s, kind, at, radius, torque);
    sketch_text(s, below, side, -0.6 * side, name);
    figure_note(s, p, name, torque, QUANTITY_TORQUE);
}

void arrow_draw_load_torques(sketch *s, const picture *p, const picture_row *r, int link,
                             int is_free)
{
    fourlink_vector at = figure_point(p, r->now.state.link[link].origin);
    fourlink_load_info load;
    unsigned long i;

    for (i = 0; fourlink_deck_load(p->v.deck, i, &load) == FOURLINK_OK; i++)
        if (load.link == link && is_drawn(p, &load, is_free) && load.sort != FOURLINK_LOAD_FRICTION)
            arrow_draw_torque(s, p, PEN_LOAD, load.name, at, r->loads[i].torque);
}

void arrow_draw_scale(sketch *s, const picture *p, quantity q, double scale, double largest)
{
    double bar = view_si(&p->v, q, place_round(view_value(&p->v, q, largest) / 2.5));
    fourlink_vector from = place_at(s->drawn.x_min, s->drawn.y_min - 0.16 * s->size);
    fourlink_vector to = place_beside(from, scale * bar, 0);
    char words[PICTURE_WORDS];

    sketch_turn(s, 0);
    sketch_arrow(s, PEN_CONSTRUCTION, from, to);
    sketch_text(s, to, 0.7, 0, picture_words(p, "", bar, q, words));
    sketch_turn(s, 1);
}
