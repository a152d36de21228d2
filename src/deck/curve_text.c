/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve_text.c - curves over the crank angle, or over another argument, from the text of a deck, or from a
** file that it names.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "base/trig.h"
#include "card.h"
#include "curve_point.h"
#include "curve_text.h"
#include "parser.h"
#include "pieces.h"
#include "vector.h"

/* 1 if an item follows a digit and a comma, without a blank, as 5 does in 1,5. */
static int follows_comma(text item, text whole)
{
    return item.start - whole.start > 1 && item.start[-1] == ',' &&
           strchr("0123456789", item.start[-2]) != NULL;
}

int flk_curve_text_file(text value, text *name)
{
    text after = flk_text_from(value, value.length < 4 ? value.length : 4);

    if (!value.length || memcmp(value.start, "file", value.length - after.length) != 0 ||
        !flk_text_blank(after))
        return 0;
    if (name)
        *name = flk_text_trim(after);
    return 1;
}

/* 1 if a value is the same at all angles: it has no second number before " at ", and no comma. */
static int is_constant(text value, quantity q)
{
    text rest = value, item, size, angle;

    if (q == QUANTITY_PRESSURE)
        return 0;
    flk_piece_item(&rest, &item);
    if (!flk_text_cut(item, " at ", &size, &angle))
        size = item;
    if (size.length > 1 && strchr("+-", size.start[0]) && flk_text_blank(flk_text_from(size, 1)))
        size = flk_text_trim(flk_text_from(size, 1)); /* - 2 N m */
    return !rest.start && (size.start[0] == '(' || flk_curve_point_value(size) >= size.length);
}

/* 1 if a text looks like the name of a file: words, a point and a short ending. */
static int is_file_name(text t)
{
    text name, ending;
    size_t i;

    if (!t.length || strchr("+-.(0123456789", t.start[0]) ||
        !flk_text_cut_last(t, ".", &name, &ending) || !ending.length || ending.length > 4)
        return 0;
    for (i = 0; i < ending.length; i++)
        if (!flk_text_is_word(ending.start[i]))
            return 0;
    return 1;
}

/* Note values without units, unless the deck gives the unit of bare numbers.  Returns 1. */
static int note_unit(parser *p, const setting *s, quantity q)
{
    const char *name = p->d->bare[q].name;
    double largest = 0;
    size_t i;

    if (p->d->bare[q].is_given)
        return 1;
    for (i = 0; s->curve && i < s->n_points; i++) {
        if (s->curve[i].has_unit)
            return 1;
        largest = GSL_MAX(largest, flk_length(s->curve[i].y[0], s->curve[i].y[1]));
    }
    if (largest > 0)
        flk_mistake(NOTES(p), s->place,
                    "the values of this curve are read as %s, the largest as %g %s: give their "
                    "unit, such as '%s'",
                    name, flk_unit_from_si(largest, p->d->bare[q].unit), name,
                    !flk_curve_text_file(s->value, NULL) ? flk_curve_point_example(q)
                    : q == QUANTITY_ANGLE                ? "file points.csv deg deg"
                    : q == QUANTITY_LENGTH               ? "file points.csv deg mm"
                    : q == QUANTITY_PRESSURE             ? "file card.csv deg bar"
                    : q == QUANTITY_FORCE                ? "file card.csv deg N"
                                                         : "file card.csv deg N m");
    return 1;
}

int flk_curve_text_read(parser *p, setting *s, quantity q)
{
    text rest = s->value, item = rest;
    double number;
    point *c;

    if (s->is_number)
        return flk_piece_read(p, s, rest, q, &s->si[0]);
    if (flk_curve_text_file(rest, &item))
        return flk_card_read(p, s, q, item) && note_unit(p, s, q);
    if (is_file_name(flk_text_unquoted(rest)))
        return flk_mistake(p->mistakes, s->place,
                           "expected %s or a curve, not '%t'; did you mean 'file %t'?",
                           flk_quantities[q].words, rest, rest);
    if (flk_number_read(&item, &number) == NUMBER_COMMA) /* 0,5 N m */
        return flk_piece_read(p, s, rest, q, &number);
    if (is_constant(rest, q))
        return q == QUANTITY_FORCE ? flk_vector_read(p, s, q)
                                   : flk_piece_read(p, s, rest, q, &s->si[0]);
    c = flk_reader_keep(p, (flk_text_count(rest, ',') + 1) * sizeof *c);
    while (c && flk_piece_item(&rest, &item)) {
        const point *new = &c[s->n_points];

        if (!item.length && !rest.start)
            break; /* a comma at the very end */
        if (!flk_curve_point_read(p, s, item, q, follows_comma(item, s->value), &c[s->n_points++]))
            return 0;
        if (new->unit_to_si != c->unit_to_si &&new->has_unit != c->has_unit)
            return flk_mistake(p->mistakes, s->place,
                               "either all values of a curve have a unit or none has");
    }
    if (s->n_points > MOST_POINTS)
        return flk_mistake(p->mistakes, s->place, "more than 100,000 points: not a curve");
    s->curve = c;
    return note_unit(p, s, q);
}
