/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve_text.c - curves over the crank angle from the text of a deck, or from a file that it names.
*/
#include <string.h>

#include "base/number.h"
#include "reader.h"

static int is_blank(int c)
{
    return c == ' ' || c == '\t';
}

/* Where a number starts after a blank, as the value in "20 deg 32 bar"; the text's length if there is
** none. */
static size_t second_number(text t)
{
    size_t i;

    for (i = 1; i < t.length; i++)
        if (is_blank(t.start[i - 1]) && strchr("+-.(0123456789", t.start[i]))
            break;
    return t.length ? i : 0;
}

/* 1 if an item follows a digit and a comma, without a blank, as 5 does in 1,5. */
static int follows_comma(text item, text whole)
{
    return item.start - whole.start > 1 && item.start[-1] == ',' &&
           strchr("0123456789", item.start[-2]) != NULL;
}

/* The value of a point. */
static int read_value(parser *p, const setting *s, text t, quantity q, point *result)
{
    unit u;
    double y;

    if (!flk_values_number(p, s, &t, q, &y) || !flk_values_unit(p, s, t, q, &u))
        return 0;
    result->y[0] = flk_unit_to_si(y, u);
    result->has_unit = flk_text_trim(t).length > 0;
    result->unit_to_si = flk_unit_to_si(1, u);
    return flk_values_size(p, s, q, result->y[0]);
}

static const char *example_of(quantity q)
{
    return q == QUANTITY_PRESSURE ? "20 deg 32 bar"
           : q == QUANTITY_FORCE  ? "20 deg (43, 25) N"
                                  : "20 deg 3 N m";
}

/* Read the next item of a curve, ANGLE VALUE: "20 deg 32 bar", or "20 32" in the deck's units. */
static int read_point(parser *p, setting *s, text t, quantity q, point *result)
{
    double x;
    unit u;
    text item = t, angle;
    size_t i;

    if (!flk_values_number(p, s, &t, QUANTITY_ANGLE, &x))
        return 0;
    i = second_number(t);
    if (i >= t.length && follows_comma(item, s->value))
        return flk_mistake(p->mistakes, s->place,
                           "'%t': a comma as decimal mark? write a point, and a blank after the "
                           "comma between two points of a curve",
                           s->value);
    if (i >= t.length)
        return flk_mistake(p->mistakes, s->place,
                           "expected an angle and a value, such as %s, not '%t'", example_of(q),
                           s->value);
    angle = t;
    angle.length = i;
    t = flk_text_from(t, i);
    if (!flk_values_unit(p, s, angle, QUANTITY_ANGLE, &u))
        return 0;
    result->x = flk_unit_to_si(x, u);
    result->place = s->place;
    if (!flk_values_size(p, s, QUANTITY_ANGLE, result->x))
        return 0;
    return q == QUANTITY_FORCE ? flk_vector_read_piece(p, s, t, q, result)
                               : read_value(p, s, t, q, result);
}

/* Read two columns of bare numbers in the deck's units, separated by blanks or a comma. */
static size_t read_curve_file(parser *p, setting *s, quantity q, text name, point *points,
                              text contents)
{
    setting row = *s;
    text line;
    size_t n = 0;

    row.place.source = flk_reader_copy(p, name, "");
    row.place.line = 0;
    contents = flk_text_without_mark(contents);
    while (!p->out_of_memory && flk_text_split(&contents, '\n', &line)) {
        const char *comma;

        row.place.line++;
        row.value = flk_line_without_comment(line);
        if (!row.value.length)
            continue;
        comma = memchr(row.value.start, ',', row.value.length);
        if (comma) {
            char *copy = flk_reader_copy(p, row.value, "");

            if (!copy)
                break;
            copy[comma - row.value.start] = ' ';
            row.value.start = copy;
        }
        n += read_point(p, &row, row.value, q, &points[n]) != 0;
    }
    s->is_bare = row.is_bare;
    return n;
}

int flk_curve_text_file(text value, text *name)
{
    text after = flk_text_from(value, value.length < 4 ? value.length : 4);

    if (memcmp(value.start, "file", value.length - after.length) != 0 || !flk_text_blank(after))
        return 0;
    if (name)
        *name = flk_text_trim(after);
    return 1;
}

/* file NAME */
static int load_curve(parser *p, setting *s, quantity q, text name)
{
    char file[1024];
    size_t before = p->mistakes->count;
    unsigned long length;
    text contents = {NULL, 0};

    name = flk_text_unquoted(name);
    if (p->load && name.length && name.length < sizeof file)
        contents.start = p->load(p->host, flk_text_copy(name, file, sizeof file), &length);
    if (!contents.start)
        return flk_mistake(p->mistakes, s->place, "cannot read the file '%t'", name);
    contents.length = length;
    s->curve = flk_reader_keep(p, (flk_text_count(contents, '\n') + 1) * sizeof *s->curve);
    if (s->curve)
        s->n_points = read_curve_file(p, s, q, name, s->curve, contents);
    if (p->mistakes->count > before)
        s->curve = NULL;
    return 1;
}

/* Take the text up to the next comma outside parentheses off the front of `rest`; 0 if nothing is left. */
static int next_item(text *rest, text *item)
{
    size_t i;
    int depth = 0, is_last;

    if (!rest->start)
        return 0;
    for (i = 0; i < rest->length && (depth || rest->start[i] != ','); i++)
        depth = rest->start[i] == '(' ? 1 : rest->start[i] == ')' ? 0 : depth;
    is_last = i == rest->length;
    *item = *rest;
    item->length = i;
    *item = flk_text_trim(*item);
    *rest = flk_text_from(*rest, i + !is_last);
    if (is_last)
        rest->start = NULL;
    return 1;
}

/* 1 if a value is one for all angles: it has no second number before " at ", and no comma. */
static int is_constant(text value, quantity q)
{
    text rest = value, item, size, angle;

    if (q == QUANTITY_PRESSURE)
        return 0;
    next_item(&rest, &item);
    if (!flk_text_cut(item, " at ", &size, &angle))
        size = item;
    return !rest.start && (size.start[0] == '(' || second_number(size) >= size.length);
}

static int read_constant(parser *p, setting *s, quantity q)
{
    point vector;

    if (q != QUANTITY_FORCE)
        return flk_values_piece(p, s, s->value, q, &s->si[0]);
    if (!flk_vector_read_piece(p, s, s->value, q, &vector))
        return 0;
    s->si[0] = vector.y[0];
    s->si[1] = vector.y[1];
    return 1;
}

int flk_curve_text_read(parser *p, setting *s, quantity q)
{
    text rest = s->value, item = rest;
    double number;
    point *c;

    if (flk_curve_text_file(rest, &item))
        return load_curve(p, s, q, item);
    if (flk_number_read(&item, &number) == NUMBER_COMMA) /* 0,5 N m */
        return flk_values_piece(p, s, rest, q, &number);
    if (is_constant(rest, q))
        return read_constant(p, s, q);
    c = flk_reader_keep(p, (flk_text_count(rest, ',') + 1) * sizeof *c);
    while (c && next_item(&rest, &item)) {
        const point *new = &c[s->n_points];

        if (!item.length && !rest.start)
            break; /* a comma at the very end */
        if (!read_point(p, s, item, q, &c[s->n_points++]))
            return 0;
        if (new->unit_to_si != c->unit_to_si &&new->has_unit != c->has_unit)
            return flk_mistake(p->mistakes, s->place,
                               "either all values of a curve have a unit or none has");
    }
    s->curve = c;
    return 1;
}
