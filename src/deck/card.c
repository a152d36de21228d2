/* SPDX-License-Identifier: GPL-3.0-or-later
**
** card.c - curves from two-column files, crank angle and value, as instruments write them.
**
** The columns are separated by semicolons, or by commas, tabs and blanks.  With semicolons, numbers may have
** decimal commas.  A header names the columns and may give their units: Angle [deg], p (bar), p/bar, bar.
** The units may also be on a separate line below it, or in the deck.  Each row becomes ANGLE UNIT VALUE UNIT,
** as in a list of points.
*/
#include <string.h>

#include "base/number.h"
#include "card.h"
#include "curve_point.h"
#include "lines.h"
#include "parser.h"

#define MOST_FIELDS 4
#define ROW_SIZE 400
#define UNIT_SIZE 64
#define MOST_QUOTED 20 /* bytes of the file in a message: it may be the wrong file */

/* A file being read. */
typedef struct card {
    parser *p;
    text line;   /* the current line */
    setting row; /* the setting, with the start of the line as its value, and the line's place */
    char quote[MOST_QUOTED + 1]; /* the start of the line */
    quantity q[2];
    char unit[2][UNIT_SIZE]; /* unit of bare numbers in each column; empty: that of the deck */
    int unit_in_deck[2];     /* 1: the deck gives the unit after the file name */
    int separator;           /* of the first line: ';', or ' ' for all others; 0 before that line */
    char mark;               /* the first decimal mark in a file with semicolons: '.' or ',' */
    int headers;
} card;

static int is_number_start(text t)
{
    return t.length && strchr("+-.0123456789", t.start[0]) != NULL;
}

/* A row up to its comment.  A semicolon begins a comment at the start of a line, or after a blank if words
** follow the numbers. */
static text without_comment(text line)
{
    text before = line, after;
    int is_row = is_number_start(flk_text_trim(line));
    size_t i;

    for (i = 0; i < line.length; i++) {
        before.length = i;
        if ((line.start[i] != '#' && line.start[i] != ';') ||
            (i > 0 && !flk_text_blank_before(before)))
            continue;
        after = flk_text_trim(flk_text_from(line, i + 1));
        if (line.start[i] == '#' ||
            (line.start[i] == ';' && (i == 0 || is_row) && after.length && !is_number_start(after)))
            break;
    }
    before.length = i;
    return flk_text_trim(before);
}

/* Cut a line at a separator outside quotes.  Returns the number of fields; `fields` has the first ones.
** Empty fields count, except at the end and between tabs. */
static size_t cut(text line, int separator, text fields[MOST_FIELDS])
{
    size_t i, start = 0, n = 0, used = 0;
    int quoted = 0;

    for (i = 0; i <= line.length; i++) {
        text field = flk_text_from(line, start);

        if (i < line.length && line.start[i] == '"')
            quoted = !quoted;
        if (i < line.length && (quoted || line.start[i] != separator))
            continue;
        field.length = i - start;
        field = flk_text_trim(field);
        start = i + 1;
        if (!field.length && separator == '\t')
            continue;
        if (n < MOST_FIELDS)
            fields[n] = flk_text_trim(flk_text_unquoted(field));
        n++;
        used = field.length ? n : used;
    }
    return used;
}

/* Cut a line of numbers at the blank before its second number. */
static size_t cut_at_blank(text line, text fields[MOST_FIELDS])
{
    size_t i = flk_curve_point_value(line);

    fields[0] = line;
    fields[0].length = i;
    fields[0] = flk_text_trim(fields[0]);
    fields[1] = flk_text_trim(flk_text_from(line, i));
    return i < line.length ? 2 : 1;
}

/* Cut a header of words at the end of its first brackets, Angle [deg] p [bar], or at blanks. */
static size_t cut_words(text line, text fields[MOST_FIELDS])
{
    size_t i;

    for (i = 0; i < line.length && !strchr(")]", line.start[i]); i++)
        ;
    if (i < line.length && strchr("[(", line.start[0]) == NULL) {
        fields[0] = line;
        fields[0].length = i + 1;
        fields[1] = flk_text_trim(flk_text_from(line, i + 1));
        if (flk_text_count(fields[1], '[') + flk_text_count(fields[1], '(') == 1)
            return 2;
    }
    return cut(line, ' ', fields);
}

static size_t cut_card_line(const card *c, text line, text fields[MOST_FIELDS])
{
    if (c->separator == ';')
        return cut(line, ';', fields);
    if (flk_text_count(line, ','))
        return cut(line, ',', fields);
    if (cut(line, '\t', fields) > 1)
        return cut(line, '\t', fields);
    return is_number_start(line) ? cut_at_blank(line, fields) : cut_words(line, fields);
}

static int refuse_columns(card *c, size_t n)
{
    return flk_mistake(c->p->mistakes, c->row.place,
                       "'%t' has %ld column%s; a curve has two, the crank angle and the value",
                       c->row.value, (long)n, n == 1 ? "" : "s");
}

/* 1 if a text is a unit of a quantity. */
static int is_unit_of(text t, quantity q)
{
    unit u;
    text bad;

    return t.length && t.length < UNIT_SIZE &&
           flk_unit_read_as(t, flk_quantities[q].dim, &u, &bad) &&
           flk_dimension_equal(u.dim, flk_quantities[q].dim);
}

/* The unit of a column of a header: Angle [deg], p (bar), p/bar, p bar, bar; empty if there is none. */
static text unit_in_header(text field, quantity q)
{
    size_t open, end = field.length;
    text found = field;

    while (found.length && !is_unit_of(found, q))
        do
            found = flk_text_from(found, 1);
        while (found.length && !strchr("/ _", found.start[-1]));
    if (found.length)
        return found;
    while (end > 0 && !strchr(")]", field.start[end - 1]))
        end--;
    for (open = end; open > 0 && !strchr("([", field.start[open - 1]); open--)
        ;
    field.length = open ? end - 1 : open;
    return flk_text_trim(flk_text_from(field, open));
}

/* Set the unit of a column; 0 and a mistake if it is not a unit, or differs from that of the deck. */
static int keep_unit(card *c, int column, text t)
{
    unit u;

    if (!t.length)
        return 1;
    if (t.length > MOST_QUOTED)
        return flk_mistake(c->p->mistakes, c->row.place, "'%t': this is too long for a unit",
                           c->row.value);
    if (!flk_quantity_unit(t, t, c->q[column], c->p->d->bare[c->q[column]].unit, &u, c->p->why))
        return flk_mistake(c->p->mistakes, c->row.place, "%s", c->p->why);
    if (c->unit_in_deck[column] && !flk_text_same(t, c->unit[column]))
        return flk_mistake(c->p->mistakes, c->row.place,
                           "the header has the unit '%t', the deck '%s'", t, c->unit[column]);
    flk_text_copy(t, c->unit[column], UNIT_SIZE);
    return 1;
}

/* Read the names of the columns, or the units below them. */
static void read_header(card *c)
{
    text fields[MOST_FIELDS];
    size_t n = cut_card_line(c, c->line, fields);
    int i;

    c->headers++;
    if (n != 2) {
        refuse_columns(c, n);
        return;
    }
    for (i = 0; i < 2; i++)
        keep_unit(c, i, unit_in_header(fields[i], c->q[i]));
}

/* 1 if a line is a header: the first line without a number, or a line of units below it. */
static int is_header(const card *c)
{
    text fields[MOST_FIELDS], line = c->line;

    if (is_number_start(flk_text_unquoted(line)) ||
        (line.start[0] == '"' && line.length > 1 && is_number_start(flk_text_from(line, 1))))
        return 0;
    return c->headers == 0 || (c->headers == 1 && cut_card_line(c, line, fields) == 2 &&
                               is_unit_of(fields[0], c->q[0]) && is_unit_of(fields[1], c->q[1]));
}

/* Replace a decimal comma by a point; 0 if the file has the other mark elsewhere. */
static int write_mark(card *c, char *field)
{
    char *comma = strchr(field, ','), *dot = strchr(field, '.');
    char mark = comma ? ',' : '.';

    if ((!comma && !dot) || (comma && dot) || (comma && strchr(comma + 1, ',')))
        return 1; /* if it is not a number, it is refused later */
    if (c->mark && c->mark != mark)
        return 0;
    c->mark = mark;
    if (comma)
        *comma = '.';
    return 1;
}

/* Add a field to the text of a point, with the unit of its column if it has none. */
static int add_field(card *c, int column, text field, char *out)
{
    char *end = out + strlen(out);
    size_t room = ROW_SIZE - strlen(out), n = strlen(c->unit[column]);
    text after;
    double number;

    if (field.length + n + 3 > room)
        return flk_mistake(c->p->mistakes, c->row.place, "'%t' is too long", c->row.value);
    flk_text_copy(field, end, room);
    if (c->separator == ';' && !write_mark(c, end))
        return flk_mistake(c->p->mistakes, c->row.place,
                           "'%t': decimal commas and decimal points in one file", c->row.value);
    after = flk_text_of(end);
    if (n && flk_number_read(&after, &number) == NUMBER_OK && !flk_text_trim(after).length) {
        strcat(end, " ");
        strcat(end, c->unit[column]);
    }
    strcat(end, " ");
    return 1;
}

/* Check the columns of a row; 0 and a mistake if there are not two of them, separated as in other rows. */
static int check_columns(card *c, const text *fields, size_t n)
{
    int is_mixed = (c->separator == ';') != (flk_text_count(c->line, ';') > 0);
    size_t i;

    for (i = 0; i < n && i < MOST_FIELDS && flk_text_count(c->line, ','); i++)
        is_mixed |= flk_curve_point_value(fields[i]) < fields[i].length;
    if (is_mixed)
        return flk_mistake(c->p->mistakes, c->row.place,
                           "'%t': mixed separators; numbers with decimal commas are separated by ;",
                           c->row.value);
    return n <= 2 || refuse_columns(c, n);
}

/* Read the text of a point.  A message may quote any part of it, so that of a long text is replaced. */
static int read_point(card *c, text t, int is_long, point *result)
{
    mistakes *m = c->p->mistakes;
    size_t before = m->count;

    if (flk_curve_point_read(c->p, &c->row, t, c->q[1], 0, result))
        return 1;
    if (is_long && m->count > before) {
        m->count = before;
        flk_mistake(m, c->row.place, "expected an angle and a value, such as %s, not '%t'",
                    flk_curve_point_example(c->q[1]), c->row.value);
    }
    return 0;
}

/* Read a row; 0 and a mistake if it is not one. */
static int read_row(card *c, point *result)
{
    text fields[MOST_FIELDS];
    size_t n = cut_card_line(c, c->line, fields), i;
    char out[ROW_SIZE] = "";
    int is_long = 0;

    if (!check_columns(c, fields, n))
        return 0;
    for (i = 0; i < n; i++) {
        is_long |= fields[i].length > MOST_QUOTED;
        if (!add_field(c, (int)i, fields[i], out))
            return 0;
    }
    return read_point(c, flk_text_trim(flk_text_of(out)), is_long, result);
}

static void read_lines(card *c, text contents, setting *s)
{
    int end = flk_text_line_end(contents);

    contents = flk_text_without_mark(contents);
    for (c->row.place.line = 1;
         !c->p->out_of_memory &&
         flk_line_take(c->p, &contents, end, c->row.place, flk_text_trim, &c->line);
         c->row.place.line++) {
        c->line = without_comment(flk_reader_plain(c->p, c->line));
        if (!c->line.length)
            continue;
        c->row.value = flk_text_of(flk_text_quote(c->line, c->quote, sizeof c->quote));
        if (s->n_points == MOST_POINTS) {
            flk_mistake(c->p->mistakes, c->row.place, "more than 100,000 points: not a curve");
            return;
        }
        if (!c->separator)
            c->separator = flk_text_count(c->line, ';') ? ';' : ' ';
        if (!s->n_points && is_header(c))
            read_header(c);
        else
            s->n_points += read_row(c, &s->curve[s->n_points]) != 0;
    }
}

/* Cut UNIT or ANGLE_UNIT UNIT, either of which may be empty; 0 if they are not units of the columns. */
static int cut_units(text t, const quantity q[2], text units[2])
{
    units[0].length = 0;
    units[1] = t;
    return !t.length || is_unit_of(t, q[1]) ||
           (flk_text_cut(t, " ", &units[0], &units[1]) && is_unit_of(units[0], q[0]) &&
            is_unit_of(units[1], q[1]));
}

/* Load a file; null if it does not exist. */
static const char *load(parser *p, text name, unsigned long *length)
{
    char file[1024];

    *length = 0; /* for a loader that does not set it */
    name = flk_text_unquoted(name);
    return p->load && name.length && name.length < sizeof file
               ? p->load(p->host, flk_text_copy(name, file, sizeof file), length)
               : NULL;
}

/* Cut NAME, NAME UNIT or NAME ANGLE_UNIT UNIT at its first blank after which there are units or, `by_file`,
** that ends the name of an existing file; 0 if there is no such file. */
static int cut_name(const card *c, text whole, int by_file, text *name, text units[2])
{
    unsigned long length;
    size_t i;

    *name = whole;
    for (i = 1; i <= whole.length; i++) {
        text after = flk_text_from(whole, i);

        if (after.length && (!flk_text_blank(after) ||
                             (whole.start[0] == '"' && (i == 1 || whole.start[i - 1] != '"'))))
            continue;
        name->length = i;
        if (cut_units(flk_reader_plain(c->p, flk_text_trim(after)), c->q, units) && !by_file)
            return 1;
        if (by_file && load(c->p, *name, &length))
            return 1;
    }
    return 0;
}

int flk_card_read(parser *p, setting *s, quantity q, text whole)
{
    size_t before = p->mistakes->count, rows;
    unsigned long length;
    text name, other, contents, units[2];
    card c;
    int i;

    memset(&c, 0, sizeof c);
    c.p = p;
    c.row = *s;
    c.q[0] = s->argument;
    c.q[1] = q;
    cut_name(&c, whole, 0, &name, units);
    contents.start = load(p, name, &length);
    if (!contents.start && cut_name(&c, whole, 1, &other, units))
        contents.start = load(p, name = other, &length);
    if (!contents.start)
        return flk_mistake(p->mistakes, s->place, "cannot read the file '%t'%s",
                           flk_text_unquoted(name),
                           flk_text_count(name, ' ') && name.start[0] != '"'
                               ? "; units after its name are written as in deg bar"
                               : "");
    for (i = 0; i < 2; i++) {
        if (!keep_unit(&c, i, units[i]))
            return 0;
        c.unit_in_deck[i] = units[i].length > 0;
    }
    contents.length = length;
    contents = flk_reader_utf8(p, contents);
    c.row.place.source = flk_reader_copy(p, flk_text_unquoted(name), "");
    c.row.place.line = 0;
    rows = flk_text_count(contents, flk_text_line_end(contents)) + 1;
    if (rows > MOST_POINTS)
        rows = MOST_POINTS;
    s->curve = flk_reader_keep(p, rows * sizeof *s->curve);
    if (s->curve)
        read_lines(&c, contents, s);
    s->is_bare = c.row.is_bare;
    if (p->mistakes->count > before)
        s->curve = NULL;
    return 1;
}
