/* SPDX-License-Identifier: GPL-3.0-or-later
**
** labels.c - the places of the texts of a drawing.
**
** Each text in turn is tried around its place, in 16 directions at three distances, and stays where it costs
** least: covering earlier texts and thick lines costs most, the requested direction costs nothing.  The scale
** depends on both drawing and texts; as texts keep their size in pixels, it takes a few rounds.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "labels.h"

#define DIRECTIONS 16
#define RINGS 3
#define ROUNDS 5
#define GAP 10.0   /* pixels, from a place to its text */
#define BORDER 8.0 /* pixels, from what is drawn to the axes */

#define HALF_LINE (0.45 * CANVAS_LINE)

/* The box of a text in pixels, with half a letter at either end. */
static place_box box_of(const sketch *s, const sketch_label *label)
{
    double w = label->half + CANVAS_LETTER / 2;
    double x = label->at.x / s->scale + label->middle.x,
           y = label->at.y / s->scale + label->middle.y;
    place_box b = place_nothing;

    place_grow(&b, x - w, y - HALF_LINE);
    place_grow(&b, x + w, y + HALF_LINE);
    return b;
}

/* The box of the drawing in pixels, without texts. */
static place_box drawn(const sketch *s)
{
    place_box b = place_nothing;

    place_grow(&b, s->drawn.x_min / s->scale, s->drawn.y_min / s->scale);
    place_grow(&b, s->drawn.x_max / s->scale, s->drawn.y_max / s->scale);
    return b;
}

static int covers(const sketch *s, const place_box *b, const sketch_obstacle *o)
{
    return place_crosses(b, place_at(o->from.x / s->scale, o->from.y / s->scale),
                         place_at(o->to.x / s->scale, o->to.y / s->scale));
}

static int leaves(const sketch *s, const place_box *b)
{
    place_box all = drawn(s);

    return b->x_min < all.x_min - BORDER || b->x_max > all.x_max + BORDER ||
           b->y_min < all.y_min - BORDER || b->y_max > all.y_max + BORDER;
}

/* The cost of label k at its present place. */
static double cost_of(const sketch *s, int k)
{
    place_box b = box_of(s, &s->labels[k]);
    double cost = 0;
    int i;

    for (i = 0; i < k; i++) {
        place_box other = box_of(s, &s->labels[i]);

        cost += place_overlap(&b, &other) ? 100 : 0;
    }
    for (i = 0; i < s->n_obstacles; i++)
        cost += covers(s, &b, &s->obstacles[i]) ? s->obstacles[i].weight : 0;
    return cost + (s->is_fixed && leaves(s, &b) ? 20 : 0);
}

static void place(sketch *s, int k)
{
    sketch_label *label = &s->labels[k];
    double wanted = atan2(label->dy, label->dx), least = GSL_POSINF;
    double w = label->half;
    fourlink_vector best = label->middle;
    int ring, i;

    for (ring = 0; ring < RINGS; ring++)
        for (i = 0; i < DIRECTIONS; i++) {
            double off = 2 * M_PI * i / DIRECTIONS, cost = 2 * ring + 1.5 * (1 - cos(off));
            double gap = GAP * (1 + 1.5 * ring);

            if (cost >= least)
                continue;
            label->middle.x = (gap + w) * cos(wanted + off);
            label->middle.y = (gap + HALF_LINE) * sin(wanted + off);
            cost += cost_of(s, k);
            if (cost < least) {
                least = cost;
                best = label->middle;
            }
        }
    label->middle = best;
}

static double scale_for(const sketch *s, const place_box *b, double width, double height,
                        double border)
{
    return s->scale * GSL_MAX_DBL((b->x_max - b->x_min) / (width - 2 * border),
                                  (b->y_max - b->y_min) / (height - 2 * border));
}

void labels_place(sketch *s, double width, double height)
{
    double first, scale;
    place_box b, own;
    int round, i;

    s->scale = 1;
    b = drawn(s);
    first = scale_for(s, &b, width, height, 3 * CANVAS_LETTER);
    s->scale = first = first > 0 ? first : s->size / width;
    for (round = 0; round < ROUNDS; round++) {
        for (i = 0; i < s->n_labels; i++)
            place(s, i);
        if (s->is_fixed)
            return;
        b = drawn(s);
        for (i = 0; i < s->n_labels; i++) {
            own = box_of(s, &s->labels[i]);
            place_grow(&b, own.x_min, own.y_min);
            place_grow(&b, own.x_max, own.y_max);
        }
        scale = scale_for(s, &b, width, height, BORDER);
        if (round < ROUNDS - 1)
            s->scale = GSL_MIN_DBL(scale, 3 * first);
    }
    s->drawn = place_nothing;
    place_grow(&s->drawn, b.x_min * s->scale, b.y_min * s->scale);
    place_grow(&s->drawn, b.x_max * s->scale, b.y_max * s->scale);
    /* if the texts still move */
    s->scale = GSL_MAX_DBL(s->scale, GSL_MIN_DBL(scale, 3 * first));
}
