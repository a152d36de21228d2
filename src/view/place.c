/* SPDX-License-Identifier: GPL-3.0-or-later
**
** place.c - places of a drawing, and boxes around them.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "place.h"

fourlink_vector place_at(double x, double y)
{
    fourlink_vector at;

    at.x = x;
    at.y = y;
    return at;
}

fourlink_vector place_beside(fourlink_vector p, double dx, double dy)
{
    p.x += dx;
    p.y += dy;
    return p;
}

fourlink_vector place_polar(fourlink_vector p, double distance, double angle)
{
    return place_beside(p, distance * cos(angle), distance * sin(angle));
}

fourlink_vector place_in(fourlink_vector p, fourlink_vector axis, double along, double left)
{
    return place_beside(p, along * axis.x - left * axis.y, along * axis.y + left * axis.x);
}

fourlink_vector place_seen(fourlink_vector p, fourlink_vector axis, fourlink_vector at)
{
    double x = at.x - p.x, y = at.y - p.y;

    return place_at(x * axis.x + y * axis.y, y * axis.x - x * axis.y);
}

fourlink_vector place_middle(fourlink_vector p, fourlink_vector q)
{
    return place_at((p.x + q.x) / 2, (p.y + q.y) / 2);
}

double place_distance(fourlink_vector p, fourlink_vector q)
{
    return gsl_hypot(q.x - p.x, q.y - p.y);
}

const place_box place_nothing = {GSL_POSINF, GSL_NEGINF, GSL_POSINF, GSL_NEGINF};

int place_is_empty(const place_box *b)
{
    return !(b->x_min <= b->x_max);
}

void place_grow(place_box *b, double x, double y)
{
    b->x_min = x < b->x_min ? x : b->x_min;
    b->x_max = x > b->x_max ? x : b->x_max;
    b->y_min = y < b->y_min ? y : b->y_min;
    b->y_max = y > b->y_max ? y : b->y_max;
}

int place_overlap(const place_box *x, const place_box *y)
{
    return x->x_min < y->x_max && y->x_min < x->x_max && x->y_min < y->y_max && y->y_min < x->y_max;
}

/* Cut off the part of a line p + s d, s from *from to *to, that is outside one pair of sides. */
static int clip(double p, double d, double low, double high, double *from, double *to)
{
    double first, last;

    if (d == 0)
        return p > low && p < high;
    first = ((d > 0 ? low : high) - p) / d;
    last = ((d > 0 ? high : low) - p) / d;
    *from = GSL_MAX_DBL(*from, first);
    *to = GSL_MIN_DBL(*to, last);
    return *from < *to;
}

int place_crosses(const place_box *b, fourlink_vector p, fourlink_vector q)
{
    double from = 0, to = 1;

    return clip(p.x, q.x - p.x, b->x_min, b->x_max, &from, &to) &&
           clip(p.y, q.y - p.y, b->y_min, b->y_max, &from, &to);
}

int place_clip(const place_box *b, fourlink_vector *p, fourlink_vector *q)
{
    double from = 0, to = 1, dx = q->x - p->x, dy = q->y - p->y;
    fourlink_vector first = *p;

    if (!clip(p->x, dx, b->x_min, b->x_max, &from, &to) ||
        !clip(p->y, dy, b->y_min, b->y_max, &from, &to))
        return 0;
    *p = place_beside(first, from * dx, from * dy);
    *q = place_beside(first, to * dx, to * dy);
    return 1;
}

double place_round(double x)
{
    double power = x > 0 ? pow(10, floor(log10(x))) : 1;

    return (x <= power ? 1 : x <= 2 * power ? 2 : x <= 5 * power ? 5 : 10) * power;
}
