/* SPDX-License-Identifier: GPL-3.0-or-later
**
** room.c - places for texts among the curves of a panel.
**
** A text is tried on its place or around it, in 16 directions at growing distances, and goes where it costs
** least: it may not leave the panel or cover another text, and should not cover a curve.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "room.h"

#define DIRECTIONS 16
#define RINGS 6
#define GAP 6.0   /* pixels, from a place to its text */
#define RING 12.0 /* pixels, from ring to ring */
#define HALF_LINE (0.5 * CANVAS_LINE)

#define COST_OF_CURVE 100
#define FORBIDDEN 10000

void room_open(room *r, canvas *on, int lines, double right)
{
    r->on = on;
    canvas_begin_panel(on);
    canvas_place_panel(on, lines, right);
    on->has_key_below_title = 1;
}

double room_to_scale(const room *r, place_box *frame, double border)
{
    double width = r->on->box_width, height = r->on->box_height;
    double x = (frame->x_min + frame->x_max) / 2, y = (frame->y_min + frame->y_max) / 2;
    double scale = GSL_MAX_DBL((frame->x_max - frame->x_min) / (width - 2 * border),
                               (frame->y_max - frame->y_min) / (height - 2 * border));

    if (scale == 0)
        scale = 1 / width;
    *frame = place_nothing;
    place_grow(frame, x - scale * width / 2, y - scale * height / 2);
    place_grow(frame, x + scale * width / 2, y + scale * height / 2);
    return scale;
}

void room_set_axes(room *r, place_box frame, double x_step, double y_step)
{
    canvas_set_axes(r->on, frame, x_step, y_step);
    r->frame = frame;
    r->x_scale = r->on->box_width / (frame.x_max - frame.x_min);
    r->y_scale = r->on->box_height / (frame.y_max - frame.y_min);
    r->n_points = r->n_texts = 0;
    r->rings = RINGS;
}

static fourlink_vector pixels(const room *r, fourlink_vector at)
{
    return place_at((at.x - r->frame.x_min) * r->x_scale, (at.y - r->frame.y_min) * r->y_scale);
}

void room_add_curve(room *r, const double *x, const double *y, int n)
{
    int starts = 1, k;

    for (k = 0; k < n && r->n_points < ROOM_POINTS; k++) {
        if (!gsl_isnan(y[k])) {
            r->point[r->n_points] = pixels(r, place_at(x[k], y[k]));
            r->is_start[r->n_points++] = (unsigned char)starts;
        }
        starts = gsl_isnan(y[k]);
    }
}

void room_add_line(room *r, fourlink_vector from, fourlink_vector to)
{
    double x[2], y[2];

    x[0] = from.x;
    y[0] = from.y;
    x[1] = to.x;
    y[1] = to.y;
    room_add_curve(r, x, y, 2);
}

static place_box box_of(fourlink_vector middle, const char *words)
{
    double half = canvas_width_of(words) / 2;
    place_box b;

    b.x_min = middle.x - half;
    b.x_max = middle.x + half;
    b.y_min = middle.y - HALF_LINE;
    b.y_max = middle.y + HALF_LINE;
    return b;
}

void room_take(room *r, fourlink_vector middle, const char *words)
{
    if (r->n_texts < ROOM_TEXTS)
        r->text[r->n_texts++] = box_of(pixels(r, middle), words);
}

static int covers_curve(const room *r, const place_box *b)
{
    int i;

    for (i = 0; i < r->n_points; i++)
        if (place_crosses(b, r->point[r->is_start[i] ? i : i - 1], r->point[i]))
            return 1;
    return 0;
}

static double cost_of(const room *r, const place_box *b)
{
    int i;

    if (b->x_min < 0 || b->y_min < 0 || b->x_max > r->on->box_width || b->y_max > r->on->box_height)
        return FORBIDDEN;
    for (i = 0; i < r->n_texts; i++)
        if (place_overlap(b, &r->text[i]))
            return FORBIDDEN;
    return covers_curve(r, b) ? COST_OF_CURVE : 0;
}

/* Try a place; returns 1 if it is better than those before. */
static int try_place(const room *r, fourlink_vector middle, const char *words, double cost,
                     double *least)
{
    place_box b = box_of(middle, words);

    if (cost < *least)
        cost += cost_of(r, &b);
    if (cost >= *least)
        return 0;
    *least = cost;
    return 1;
}

int room_put(room *r, fourlink_vector at, double dx, double dy, int keeps_clear, const char *words,
             int p, fourlink_vector *middle)
{
    double least = keeps_clear ? COST_OF_CURVE : FORBIDDEN, half = canvas_width_of(words) / 2;
    double wanted = dx == 0 && dy == 0 ? M_PI / 2 : atan2(dy * r->y_scale, dx * r->x_scale);
    fourlink_vector from = pixels(r, at), best = from, next;
    int ring, i, found = dx == 0 && dy == 0 && try_place(r, from, words, 0, &least);

    for (ring = 0; ring < r->rings; ring++)
        for (i = 0; i < DIRECTIONS; i++) {
            double off = 2 * M_PI * i / DIRECTIONS, angle = wanted + off;
            double gap = GAP + RING * ring,
                   cost = 2 * ring + 1.5 * (1 - cos(off)) + (dx == 0 && dy == 0);

            next = place_beside(from, (gap + half) * cos(angle), (gap + HALF_LINE) * sin(angle));
            if (try_place(r, next, words, cost, &least)) {
                best = next;
                found = 1;
            }
        }
    if (!found || r->n_texts == ROOM_TEXTS)
        return 0;
    r->text[r->n_texts++] = box_of(best, words);
    *middle = place_at(r->frame.x_min + best.x / r->x_scale, r->frame.y_min + best.y / r->y_scale);
    display_text(r->on->d, p, *middle, DISPLAY_MIDDLE, words)->is_boxed = 1;
    return 1;
}
