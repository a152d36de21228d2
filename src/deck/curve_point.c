/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve_point.c - a point of a curve: an argument and a value.
*/
#include <string.h>

#include "curve_point.h"
#include "parser.h"
#include "pieces.h"
#include "vector.h"

/* ------------------------------------------------------------------------------------------- a point */

size_t flk_curve_point_value(text t)
{
    size_t i;

    for (i = 1; i < t.length; i++)
        if (strchr(" \t", t.start[i - 1]) && strchr("+-.(0123456789", t.start[i]) &&
            !(t.length - i > 2 && memcmp(t.start + i, "1/m", 3) == 0)) /* 300 1/min */
            break;
    return t.length ? i : 0;
}

/* The value of a point. */
static int read_point_value(parser *p, const setting *s, text t, quantity q, point *result)
{
    quantity_value value;

    if (!flk_piece_quantity(p, s->place, t, s->value, q, &value))
        return 0;
    result->y[0] = value.si;
    result->has_unit = flk_quantity_unit_text(t).length > 0;
    result->unit_to_si = flk_unit_to_si(1, value.unit);
    return 1;
}

const char *flk_curve_point_example(quantity q)
{
    return q == QUANTITY_PRESSURE ? "20 deg 32 bar"
           : q == QUANTITY_FORCE  ? "20 deg (43, 25) N"
           : q == QUANTITY_ANGLE  ? "36 deg 64 deg"
           : q == QUANTITY_LENGTH ? "36 deg 80 mm"
                                  : "20 deg 3 N m";
}

/* The same for another argument. */
static const char *example(quantity argument, quantity q)
{
    if (argument == QUANTITY_ANGLE)
        return flk_curve_point_example(q);
    if (argument == QUANTITY_NUMBER)
        return "1.5 2.25";
    if (argument == QUANTITY_LENGTH)
        return q == QUANTITY_FORCE ? "20 mm (43, 25) N" : "20 mm 3 N m";
    if (argument == QUANTITY_SPEED)
        return q == QUANTITY_FORCE ? "2 m/s (43, 25) N" : "2 m/s 3 N m";
    return q == QUANTITY_FORCE ? "100 rpm (43, 25) N" : "100 rpm 3 N m";
}

int flk_curve_point_read(parser *p, setting *s, text t, quantity q, int is_cut, point *result)
{
    double x;
    unit u;
    text angle;
    size_t i;

    if (!flk_piece_number(p, s, &t, s->argument, &x))
        return 0;
    i = flk_curve_point_value(t);
    if (i >= t.length && is_cut)
        return flk_mistake(p->mistakes, s->place,
                           "'%t': a comma as decimal mark? write a point, and a blank after the "
                           "comma between two points of a curve",
                           s->value);
    if (i >= t.length)
        return flk_mistake(p->mistakes, s->place,
                           s->argument == QUANTITY_ANGLE
                               ? "expected an angle and a value, such as %s, not '%t'"
                               : "expected points of an argument and a value, such as %s, not '%t'",
                           example(s->argument, q), s->value);
    angle = t;
    angle.length = i;
    t = flk_text_from(t, i);
    if (!flk_piece_unit(p, s, angle, s->argument, &u))
        return 0;
    result->x = flk_unit_to_si(x, u);
    result->place = s->place;
    if (!flk_piece_size(p, s, s->argument, result->x))
        return 0;
    return q == QUANTITY_FORCE ? flk_vector_read_piece(p, s, t, q, result)
                               : read_point_value(p, s, t, q, result);
}
