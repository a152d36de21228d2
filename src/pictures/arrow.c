/* SPDX-License-Identifier: GPL-3.0-or-later
**
** arrow.c - forces as arrows of one scale.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "arrow.h"
#include "base/format.h"
#include "tables/print.h"

/* Below this fraction of the largest an arrow would be a head without a tail. */
#define SMALLEST 0.02

#define LONGEST_NAME 24 /* letters */

char *arrow_words(const deck *d, const char *name, double si, quantity q, char out[ARROW_WORDS])
{
    char number[FORMAT_SIZE], fitting[ARROW_WORDS];

    name = canvas_shorten(name, LONGEST_NAME, 0, fitting, sizeof fitting);
    return flk_text_join(out, ARROW_WORDS, name, name[0] ? " " : "",
                         format_general(flk_unit_from_si(si, d->units[q].unit), 5, number), " ",
                         d->units[q].name, (char *)NULL);
}

void arrow_add(arrow_list *arrows, pen p, const char *name, fourlink_vector at, double x, double y)
{
    arrow *new = &arrows->list[arrows->n];

    if (arrows->n == MOST_ARROWS || (x == 0 && y == 0))
        return;
    new->at = at;
    new->F.x = x;
    new->F.y = y;
    new->p = p;
    flk_text_join(new->name, sizeof new->name, name, (char *)NULL);
    arrows->n++;
}

static const char *name_of_load(const deck *d, unsigned long i)
{
    return i == d->n_loads ? "gas" : d->variations[i].name[0] ? d->variations[i].name : "load";
}

void arrow_add_loads(arrow_list *arrows, const analysis *a, const result *r, int link)
{
    static const char *const weights[5] = {"", "", "W2", "W3", "W4"};
    const deck *d = a->d;
    const fourlink_link_state *l = &r->state.link[link];
    unsigned long i;

    arrow_add(arrows, PEN_LOAD, weights[link],
              figure_of_link(d, &r->state, link, &d->design.link[link].cg),
              d->design.link[link].mass * d->design.gravity.x,
              d->design.link[link].mass * d->design.gravity.y);
    for (i = 0; i < a->n_loads; i++) {
        const fourlink_load *load = &a->loads[i];
        fourlink_vector F = load->force;

        if (load->link != link)
            continue;
        if (load->frame == FOURLINK_FRAME_LINK) {
            F.x = load->force.x * l->axis.x - load->force.y * l->axis.y;
            F.y = load->force.x * l->axis.y + load->force.y * l->axis.x;
        }
        arrow_add(arrows, PEN_LOAD, name_of_load(d, i),
                  figure_of_link(d, &r->state, link, &load->at), F.x, F.y);
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

void arrow_draw(const arrow_list *arrows, sketch *s, const deck *d, double scale)
{
    double largest = arrow_largest(arrows);
    char words[ARROW_WORDS];
    int i;

    for (i = 0; i < arrows->n; i++) {
        const arrow *x = &arrows->list[i];
        double size = gsl_hypot(x->F.x, x->F.y);
        fourlink_vector end;

        sketch_note(s, arrow_words(d, x->name, size, QUANTITY_FORCE, words));
        if (size < SMALLEST * largest)
            continue;
        end.x = x->at.x + scale * x->F.x;
        end.y = x->at.y + scale * x->F.y;
        sketch_arrow(s, x->p, x->at, end);
        sketch_text(s, end, x->F.x, x->F.y, x->name);
    }
}

void arrow_draw_torque(sketch *s, const deck *d, pen p, const char *name, fourlink_vector at,
                       double torque)
{
    char words[ARROW_WORDS];
    double side = p == PEN_FORCE ? -1 : 1, radius = 0.07 * s->size; /* of the letters */
    fourlink_vector below = at;

    if (torque == 0)
        return;
    below.x += 0.86 * radius * side;
    below.y -= 0.5 * radius * side;
    sketch_torque(s, p, at, radius, torque);
    sketch_text(s, below, side, -0.6 * side, name);
    sketch_note(s, arrow_words(d, name, torque, QUANTITY_TORQUE, words));
}

void arrow_draw_load_torques(sketch *s, const analysis *a, const result *r, int link)
{
    unsigned long i;

    for (i = 0; i < a->d->n_loads; i++)
        if (a->loads[i].link == link)
            arrow_draw_torque(s, a->d, PEN_LOAD, name_of_load(a->d, i),
                              figure_point(a->d, r->state.link[link].origin), a->loads[i].torque);
}

void arrow_draw_scale(sketch *s, const deck *d, quantity q, double scale, double largest)
{
    const unit *u = &d->units[q].unit;
    double bar = flk_unit_to_si(sketch_round(flk_unit_from_si(largest, *u) / 2.5), *u);
    fourlink_vector from, to;
    char words[ARROW_WORDS];

    from.x = s->x_min;
    from.y = s->y_min - 0.08 * s->size;
    to = from;
    to.x += scale * bar;
    sketch_arrow(s, PEN_CONSTRUCTION, from, to);
    sketch_text(s, to, 0.7, 0, arrow_words(d, "", bar, q, words));
}
