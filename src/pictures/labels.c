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
#define HIDDEN 12  /* the cost above which a close text is left out */
#define GAP 10.0   /* pixels, from a place to its text */
#define BORDER 8.0 /* pixels, from what is drawn to the axes */

#define HALF_LINE (0.45 * CANVAS_LINE)

/* The box of a text in pixels, with half a letter at either end. */
static place_box box_of(const labels *l, const label *text)
{
    double w = text->half + CANVAS_LETTER / 2;
    double x = text->at.x / l->scale + text->middle.x, y = text->at.y / l->scale + text->middle.y;
    place_box b = place_nothing;

    place_grow(&b, x - w, y - HALF_LINE);
    place_grow(&b, x + w, y + HALF_LINE);
    return b;
}

/* The box of the drawing in pixels, without texts. */
static place_box box_of_drawing(const labels *l)
{
    place_box b = place_nothing;

    place_grow(&b, l->drawn.x_min / l->scale, l->drawn.y_min / l->scale);
    place_grow(&b, l->drawn.x_max / l->scale, l->drawn.y_max / l->scale);
    return b;
}

static int covers(const labels *l, const place_box *b, const obstacle *o)
{
    return place_crosses(b, place_at(o->from.x / l->scale, o->from.y / l->scale),
                         place_at(o->to.x / l->scale, o->to.y / l->scale));
}

static int leaves(const labels *l, const place_box *b)
{
    place_box all = box_of_drawing(l);

    return b->x_min < all.x_min - BORDER || b->x_max > all.x_max + BORDER ||
           b->y_min < all.y_min - BORDER || b->y_max > all.y_max + BORDER;
}

/* The cost of label k at its present place. */
static double cost_of(const labels *l, int k)
{
    place_box b = box_of(l, &l->list[k]);
    double cost = 0;
    int i;

    for (i = 0; i < k; i++) {
        place_box other = box_of(l, &l->list[i]);

        cost += !l->list[i].is_hidden && place_overlap(&b, &other) ? 100 : 0;
    }
    for (i = 0; i < l->n_obstacles; i++)
        cost += covers(l, &b, &l->obstacles[i]) ? l->obstacles[i].weight : 0;
    return cost + (l->is_fixed && leaves(l, &b) ? 20 : 0);
}

static void place(labels *l, int k)
{
    label *text = &l->list[k];
    double wanted = atan2(text->dy, text->dx), least = GSL_POSINF;
    double w = text->half;
    fourlink_vector best = text->middle;
    int rings = text->is_close || l->is_steady ? 1 : RINGS, ring, i;

    for (ring = 0; ring < rings; ring++)
        for (i = 0; i < (l->is_steady ? 1 : DIRECTIONS); i++) {
            double off = 2 * M_PI * i / DIRECTIONS, cost = 2 * ring + 1.5 * (1 - cos(off));
            double gap = GAP * (1 + 1.5 * ring);

            if (cost >= least)
                continue;
            text->middle.x = (gap + w) * cos(wanted + off);
            text->middle.y = (gap + HALF_LINE) * sin(wanted + off);
            cost += cost_of(l, k);
            if (cost < least) {
                least = cost;
                best = text->middle;
            }
        }
    text->middle = best;
    text->is_hidden = text->is_close && least > HIDDEN && !l->is_steady;
}

static double scale_for(const labels *l, const place_box *b, double width, double height,
                        double border)
{
    return l->scale * GSL_MAX_DBL((b->x_max - b->x_min) / (width - 2 * border),
                                  (b->y_max - b->y_min) / (height - 2 * border));
}

/* A frame with this half side that has no room for all texts is moved so that the drawing is in it. */
static void keep_within(double *low, double *high, double drawn_low, double drawn_high, double half)
{
    double middle = (*low + *high) / 2;

    if (*high - *low <= 2 * half || drawn_high - drawn_low > 2 * half)
        return;
    middle = GSL_MIN_DBL(GSL_MAX_DBL(middle, drawn_high - half), drawn_low + half);
    *low = middle - half;
    *high = middle + half;
}

void labels_place(labels *l, place_box drawn, int is_fixed, double size, double width,
                  double height)
{
    double first, scale;
    place_box b, own;
    int round, i;

    l->drawn = drawn;
    l->is_fixed = is_fixed;
    l->scale = 1;
    b = box_of_drawing(l);
    first = scale_for(l, &b, width, height, 3 * CANVAS_LETTER);
    l->scale = first = first > 0 ? first : size / width;
    for (round = 0; round < ROUNDS; round++) {
        for (i = 0; i < l->n; i++)
            place(l, i);
        if (l->is_fixed)
            return;
        b = box_of_drawing(l);
        for (i = 0; i < l->n; i++) {
            if (l->list[i].is_hidden)
                continue;
            own = box_of(l, &l->list[i]);
            place_grow(&b, own.x_min, own.y_min);
            place_grow(&b, own.x_max, own.y_max);
        }
        scale = scale_for(l, &b, width, height, BORDER);
        if (round < ROUNDS - 1)
            l->scale = GSL_MIN_DBL(scale, 3 * first);
    }
    l->drawn = place_nothing;
    place_grow(&l->drawn, b.x_min * l->scale, b.y_min * l->scale);
    place_grow(&l->drawn, b.x_max * l->scale, b.y_max * l->scale);
    /* if the texts still move */
    l->scale = GSL_MAX_DBL(l->scale, GSL_MIN_DBL(scale, 3 * first));
    keep_within(&l->drawn.x_min, &l->drawn.x_max, drawn.x_min, drawn.x_max, l->scale * width / 2);
    keep_within(&l->drawn.y_min, &l->drawn.y_max, drawn.y_min, drawn.y_max, l->scale * height / 2);
}
