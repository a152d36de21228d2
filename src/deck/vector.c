/* SPDX-License-Identifier: GPL-3.0-or-later
**
** vector.c - forces and points of links from the text of a deck.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "base/trig.h"
#include "parser.h"
#include "pieces.h"
#include "vector.h"

void flk_vector_direction(double angle, double *x, double *y)
{
    double quarters = angle / M_PI_2, whole = floor(quarters + 0.5);

    flk_sine_cosine(angle, y, x);
    if (fabs(quarters - whole) < 1e-14 && fabs(whole) < 1e6) {
        static const double exact[4] = {1, 0, -1, 0};
        int i = (int)whole % 4;

        i = i < 0 ? i + 4 : i;
        *x = exact[i];
        *y = exact[(i + 3) % 4];
    }
}

static int refuse_components(parser *p, const setting *s, quantity q, text inside)
{
    int has_more = flk_text_count(inside, ',') > 1, has_marks = 0; /* (40,5, 25,2) mm */
    size_t i;

    for (i = 0; i + 1 < inside.length && has_more; i++)
        has_marks |= inside.start[i] == ',' && strchr("0123456789", inside.start[i + 1]);
    return flk_mistake(p->mistakes, s->place, "expected two components, such as %s, not '%t'%s",
                       q == QUANTITY_FORCE ? "(43, 25) N" : "(10, 5) mm", s->value,
                       has_marks ? ": a comma as decimal mark? write a point" : "");
}

/* (10, 5) mm */
static int read_components(parser *p, setting *s, text t, quantity q, point *result)
{
    text rest = flk_text_from(t, 1), inside, x;
    unit u;
    int i;

    flk_text_split(&rest, ')', &inside);
    if (!rest.start || flk_text_count(inside, ',') != 1)
        return refuse_components(p, s, q, inside);
    if (!flk_piece_unit(p, s, rest, q, &u))
        return 0;
    result->has_unit = flk_text_trim(rest).length > 0;
    result->unit_to_si = flk_unit_to_si(1, u);
    for (i = 0; i < 2; i++) {
        double number;

        flk_text_split(&inside, ',', &x);
        if (!flk_piece_number(p, s, &x, q, &number))
            return 0;
        if (flk_text_trim(x).length)
            return refuse_components(p, s, q, inside);
        result->y[i] = flk_unit_to_si(number, u);
        if (!flk_piece_size(p, s, q, result->y[i]))
            return 0;
    }
    return 1;
}

/* A fraction of the link's length: 50 %; 0 if there is no per cent sign. */
static int read_share(parser *p, setting *s, text t, double *share)
{
    t = flk_text_trim(t);
    if (!t.length || t.start[t.length - 1] != '%')
        return 0;
    s->of_length = 1;
    flk_piece_read(p, s, t, QUANTITY_NUMBER, share);
    return 1;
}

/* 10 mm */
static int read_size(parser *p, setting *s, text t, quantity q, point *result, double *size)
{
    if (q == QUANTITY_LENGTH && !s->is_place && read_share(p, s, t, size))
        return 1;
    if (!flk_piece_read(p, s, t, q, size))
        return 0;
    result->has_unit = flk_quantity_unit_text(t).length > 0;
    result->unit_to_si = flk_unit_to_si(1, s->unit);
    return 1;
}

/* One step to a place, or a force. */
static int read_step(parser *p, setting *s, text t, quantity q, point *result)
{
    static const char *const places[] = {"origin", "mid", "end"};
    text size_text = t, angle_text, before;
    double size = 0, angle = 0, x, y;
    int has_angle, i, is_of_link = q == QUANTITY_LENGTH && !s->is_place;

    if (is_of_link && flk_text_same(t, "G")) {
        s->of_centre = 1;
        result->y[0] = result->y[1] = 0;
        return 1;
    }
    if (t.length && t.start[0] == '(')
        return read_components(p, s, t, q, result);
    for (i = 0; i < 3 && is_of_link; i++)
        if (flk_text_equal(t, places[i])) {
            s->of_length = i > 0;
            result->y[0] = 0.5 * i;
            result->y[1] = 0;
            return 1;
        }
    if (flk_text_cut_last(t, " ", &before, &angle_text) && flk_text_same(angle_text, "at"))
        return flk_mistake(p->mistakes, s->place, "expected an angle after 'at', not '%t'",
                           s->value);
    has_angle = flk_text_cut(t, " at ", &size_text, &angle_text);
    if (has_angle && !flk_piece_read(p, s, angle_text, QUANTITY_ANGLE, &angle))
        return 0;
    if (!read_size(p, s, size_text, q, result, &size))
        return 0;
    s->is_bare |= !has_angle; /* only a force that has been read can lack a direction */
    flk_vector_direction(angle, &x, &y);
    result->y[0] = size * x;
    result->y[1] = size * y;
    return 1;
}

int flk_vector_read_piece(parser *p, setting *s, text t, quantity q, point *result)
{
    text step, rest;
    point next;
    int of_length;

    if (q != QUANTITY_LENGTH || !flk_text_cut(t, " + ", &step, &rest))
        return read_step(p, s, t, q, result);
    memset(&next, 0, sizeof next);
    if (!read_step(p, s, step, q, result))
        return 0;
    of_length = s->of_length;
    s->of_length = 0;
    if (!flk_vector_read_piece(p, s, rest, q, &next))
        return 0;
    if (of_length != s->of_length)
        return flk_mistake(p->mistakes, s->place,
                           "the steps of '%t' are all of the link's length, or none is", s->value);
    result->y[0] += next.y[0];
    result->y[1] += next.y[1];
    return 1;
}

/* 1 if there is a comma outside parentheses, in place of (10, 5) mm. */
static int has_outer_comma(text t)
{
    size_t i;
    int depth = 0;

    if (t.start[0] == '(') /* its components are counted where they are read */
        return 0;
    for (i = 0; i < t.length; i++) {
        depth += (t.start[i] == '(') - (t.start[i] == ')');
        if (t.start[i] == ',' && !depth)
            return 1;
    }
    return 0;
}

/* 2 in, 6 in, left: a point by its distances from both pins of its link; 0 if it is another form. */
static int read_distances(parser *p, setting *s, text rest)
{
    text first, second, side, more;
    int is_left;

    if (s->is_place || s->is_number || !flk_piece_item(&rest, &first) ||
        !flk_piece_item(&rest, &second) || !flk_piece_item(&rest, &side) ||
        flk_piece_item(&rest, &more))
        return 0;
    is_left = flk_text_equal(side, "left");
    if (!is_left && !flk_text_equal(side, "right"))
        return 0;
    if (flk_piece_read(p, s, first, QUANTITY_LENGTH, &s->si[0]) &&
        flk_piece_read(p, s, second, QUANTITY_LENGTH, &s->si[1]))
        s->of_pins = is_left ? 1 : -1;
    return 1;
}

int flk_vector_by_distances(double from_origin, double from_end, double length, int side, double *x,
                            double *y)
{
    double r = from_origin / length, q = from_end / length;

    *x = length * (1 + (r - q) * (r + q)) / 2;
    *y = (from_origin - *x) * (from_origin + *x);
    if (*y < 0 && *y > -1e-12 * length * length)
        *y = 0;
    *y = *y >= 0 ? side * sqrt(*y) : GSL_NAN;
    return *y == *y;
}

int flk_vector_read(parser *p, setting *s, quantity q)
{
    text t = s->value;
    point vector;
    double size;

    if (q == QUANTITY_LENGTH && read_distances(p, s, t))
        return s->of_pins != 0;
    if (has_outer_comma(t) && flk_number_read(&t, &size) != NUMBER_COMMA) /* 0,5 mm */
        return flk_mistake(p->mistakes, s->place,
                           "expected a point, such as 10 mm at 5 deg or (10, 5) mm, not '%t'",
                           s->value);
    if (!flk_vector_read_piece(p, s, s->value, q, &vector))
        return 0;
    s->si[0] = vector.y[0];
    s->si[1] = vector.y[1];
    if (s->is_place && s->is_bare && !s->parts)
        return flk_mistake(p->mistakes, s->place,
                           "expected a place, such as (41, 37.5) mm or 140 mm at 30 deg, not '%t'",
                           s->value);
    return 1;
}

/* A place of a line, in the unit of the last if it has none. */
static int read_end(parser *p, setting *s, text t, text last, quantity q, point *end)
{
    text unit_name = flk_text_from(last, last.length), rest = last, inside;
    char ending[DECK_NAME_SIZE];
    const char *copy;

    if (last.length && last.start[0] == '(' && flk_text_split(&rest, ')', &inside) && rest.start)
        unit_name = rest;
    if (t.length && t.start[0] == '(' && t.start[t.length - 1] == ')') {
        flk_text_copy(unit_name, ending, sizeof ending);
        copy = flk_reader_copy(p, t, ending);
        if (!copy)
            return 0;
        t = flk_text_of(copy);
    }
    return flk_vector_read_piece(p, s, t, q, end);
}

int flk_vector_read_line(parser *p, setting *s, quantity q)
{
    text rest = s->value, first, last, more;
    point *ends = flk_reader_keep(p, 2 * sizeof *ends);

    s->is_place = 1;
    if (!ends)
        return 0;
    if (!flk_piece_item(&rest, &first) || !flk_piece_item(&rest, &last) ||
        flk_piece_item(&rest, &more) || s->is_number)
        return flk_mistake(p->mistakes, s->place,
                           "expected two points, such as (0, 10) mm, (200, 10) mm, not '%t'",
                           s->value);
    if (!read_end(p, s, first, last, q, &ends[0]) || !read_end(p, s, last, last, q, &ends[1]))
        return 0;
    s->curve = ends;
    s->n_points = 2;
    return 1;
}

/* Parts that are not set separately come from the whole vector. */
void flk_vector_read_parts(parser *p, setting *s, quantity q)
{
    double part[PART_NONE], x, y;
    int i, is_polar = 0;

    part[PART_X] = s->si[0];
    part[PART_Y] = s->si[1];
    part[PART_SIZE] = flk_length(s->si[0], s->si[1]);
    part[PART_ANGLE] = flk_angle(s->si[1], s->si[0]);
    for (i = 0; i < PART_NONE; i++) {
        setting *own = &s->parts[i];

        if (!IS_SET(own))
            continue;
        own->value = flk_reader_plain(p, own->value);
        s->is_bare = 0;
        if (s->curve)
            flk_mistake(p->mistakes, own->place, "a curve has no parts that can be varied");
        if (s->word && i != PART_ANGLE)
            flk_mistake(p->mistakes, own->place,
                        "the size of the force is unknown: only its .angle can be given");
        if (s->of_centre)
            flk_mistake(p->mistakes, own->place,
                        "'%t' is from the centre of mass: give the point from the origin of the "
                        "link before you vary a part of it",
                        s->value);
        if (s->of_pins)
            flk_mistake(p->mistakes, own->place,
                        "'%t' is by distances from pins: give the point along the link and to its "
                        "left before you vary a part of it",
                        s->value);
        if (s->of_length)
            flk_mistake(p->mistakes, own->place,
                        "'%t' is a part of the length of the link: give the point in a unit of "
                        "length before you vary a part of it",
                        s->value);
        flk_piece_read(p, own, own->value, i == PART_ANGLE ? QUANTITY_ANGLE : q, &own->si[0]);
        part[i] = own->si[0];
        is_polar = i >= PART_SIZE;
    }
    flk_vector_direction(part[PART_ANGLE], &x, &y);
    s->si[0] = is_polar ? part[PART_SIZE] * x : part[PART_X];
    s->si[1] = is_polar ? part[PART_SIZE] * y : part[PART_Y];
}
