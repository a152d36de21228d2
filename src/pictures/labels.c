/* SPDX-License-Identifier: GPL-3.0-or-later
**
** labels.c - the places of the texts of a drawing.
**
** Each text in turn is tried around its place, in 16 directions at three distances, and stays where it costs
** least: covering earlier texts and thick lines costs most, the requested direction costs nothing.  The scale
** depends on both drawing and texts; as texts keep their size in pixels, it takes a few rounds.
**
** In a drawing that moves a text keeps its direction: the one where it covers least at 18 positions together.
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

/* A box of pixels in the unit of length, a thousandth of a pixel larger: more than rounding. */
static place_box box_in_unit(const labels *l, const place_box *b)
{
    place_box out = place_nothing;

    place_grow(&out, (b->x_min - 0.001) * l->scale, (b->y_min - 0.001) * l->scale);
    place_grow(&out, (b->x_max + 0.001) * l->scale, (b->y_max + 0.001) * l->scale);
    return out;
}

/* 1 if both ends of an obstacle are on the same side of a box, as most are. */
static int is_far(const place_box *b, const obstacle *o)
{
    return (o->from.x < b->x_min && o->to.x < b->x_min) ||
           (o->from.x > b->x_max && o->to.x > b->x_max) ||
           (o->from.y < b->y_min && o->to.y < b->y_min) ||
           (o->from.y > b->y_max && o->to.y > b->y_max);
}

static int covers(const labels *l, const place_box *b, const obstacle *o)
{
    return place_crosses(b, place_at(o->from.x / l->scale, o->from.y / l->scale),
                         place_at(o->to.x / l->scale, o->to.y / l->scale));
}

static int leaves(const labels *l, const place_box *b)
{
    place_box all = box_of_drawing(l);

    return b->x_min < all.x_min - l->border || b->x_max > all.x_max + l->border ||
           b->y_min < all.y_min - l->border || b->y_max > all.y_max + l->border;
}

/* The cost of label k at its present place. */
static double cost_of(const labels *l, int k)
{
    place_box b = box_of(l, &l->list[k]), near = box_in_unit(l, &b);
    double cost = 0;
    int i;

    for (i = 0; i < k; i++) {
        place_box other = box_of(l, &l->list[i]);

        cost += !l->list[i].is_hidden && place_overlap(&b, &other) ? 100 : 0;
    }
    for (i = 0; i < l->n_obstacles; i++) {
        const obstacle *o = &l->obstacles[i];

        cost += !is_far(&near, o) && covers(l, &b, o) ? o->weight : 0;
    }
    return cost + (l->is_fixed && leaves(l, &b) ? 20 : 0);
}

/* Put a text at one of its candidates, which are numbered ring by ring; returns the cost of being far from
** its place and away from the requested direction. */
static double put_at(label *text, int candidate)
{
    int ring = candidate / DIRECTIONS;
    double off = 2 * M_PI * (candidate % DIRECTIONS) / DIRECTIONS, gap = GAP * (1 + 1.5 * ring);
    double angle = atan2(text->dy, text->dx) + off;

    text->middle.x = (gap + text->half) * cos(angle);
    text->middle.y = (gap + HALF_LINE) * sin(angle);
    return 2 * ring + 1.5 * (1 - cos(off));
}

static int candidates_of(const label *text)
{
    return text->is_close ? DIRECTIONS : RINGS * DIRECTIONS;
}

static void place(labels *l, int k)
{
    label *text = &l->list[k];
    double least = GSL_POSINF;
    int n = candidates_of(text), best = 0, i;

    for (i = 0; i < n; i++) {
        double cost = put_at(text, i);

        if (cost < least)
            cost += cost_of(l, k);
        if (cost < least) {
            least = cost;
            best = i;
        }
    }
    put_at(text, best);
    text->is_hidden = text->is_close && least > HIDDEN;
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
    l->border = BORDER;
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

/* ------------------------------------------------------------------------------------------- motion */

#define AROUND 32.0  /* pixels, from what is drawn to the edge of a drawing that moves */
#define MOST_RINGS 2 /* its texts are nearer to their places */

/* The side of a text; that of a new one if there is none. */
static int side_of(const labels_motion *m, const label *text)
{
    int i;

    for (i = 0; i < m->n_sides && m->sides[i].key != text->key; i++)
        ;
    return i;
}

static void take_scale(labels *l, const labels_motion *m, double size, double width, double height)
{
    place_box b;

    l->drawn = m->drawn;
    l->border = AROUND;
    l->is_fixed = 1;
    l->scale = 1;
    b = box_of_drawing(l);
    l->scale = scale_for(l, &b, width, height, AROUND);
    l->scale = l->scale > 0 ? l->scale : size / width;
}

/* Places become pixels, which are compared many times. */
static void turn_into_pixels(labels *l)
{
    fourlink_vector zero = {0, 0};
    double k = 1 / l->scale;
    int i;

    for (i = 0; i < l->n; i++)
        l->list[i].at = place_in(zero, l->list[i].at, k, 0);
    for (i = 0; i < l->n_obstacles; i++) {
        l->obstacles[i].from = place_in(zero, l->obstacles[i].from, k, 0);
        l->obstacles[i].to = place_in(zero, l->obstacles[i].to, k, 0);
    }
    l->drawn = box_of_drawing(l);
    l->scale = 1;
}

void labels_keep(labels_motion *m, labels *l, double size, double width, double height)
{
    int k;

    if (m->n_kept == LABELS_KEPT)
        return;
    take_scale(l, m, size, width, height);
    for (k = 0; k < l->n; k++) {
        label *text = &l->list[k];

        text->side = side_of(m, text);
        put_at(text, 0);
        if (text->side < m->n_sides || text->side == LABELS_MOST)
            continue;
        m->sides[m->n_sides++].key = text->key;
    }
    m->kept[m->n_kept] = *l;
    turn_into_pixels(&m->kept[m->n_kept++]);
}

/* The number of a text with this side at a position; that of texts if there is none. */
static int text_of(const labels *l, int side)
{
    int k;

    for (k = 0; k < l->n && l->list[k].side != side; k++)
        ;
    return k;
}

/* The cost of a candidate at all positions, as far as it is below the least so far; the texts stay there. */
static double cost_of_all(labels_motion *m, int side, int candidate, double least)
{
    double cost = 0;
    int i;

    for (i = 0; i < m->n_kept && cost < least; i++) {
        labels *l = &m->kept[i];
        int k = text_of(l, side);

        if (k < l->n && candidate < candidates_of(&l->list[k])) {
            cost += put_at(&l->list[k], candidate);
            cost += cost < least ? cost_of(l, k) : 0;
        } else if (k < l->n) {
            return GSL_POSINF;
        }
    }
    return cost;
}

void labels_choose_sides(labels_motion *m)
{
    int side, i;

    for (side = 0; side < m->n_sides; side++) {
        double least = GSL_POSINF, cost;

        for (i = 0; i < MOST_RINGS * DIRECTIONS; i++) {
            cost = cost_of_all(m, side, i, least);
            if (cost < least) {
                least = cost;
                m->sides[side].candidate = i;
            }
        }
        cost_of_all(m, side, m->sides[side].candidate, GSL_POSINF);
    }
}

void labels_take_sides(labels *l, const labels_motion *m, double size, double width, double height)
{
    int k;

    take_scale(l, m, size, width, height);
    for (k = 0; k < l->n; k++) {
        int side = side_of(m, &l->list[k]);

        put_at(&l->list[k], side < m->n_sides ? m->sides[side].candidate : 0);
    }
}
