/* SPDX-License-Identifier: GPL-3.0-or-later
**
** answers.c - a file of answers as people write it, in the form of a deck.
**
** One line that is not understood costs one value, not the file.  The lines keep their numbers.
*/
#include <string.h>

#include "base/quantity.h"
#include "answers.h"
#include "lines.h"

/* A file on its way into the form of a deck. */
typedef struct rewriting {
    parser *p;
    int separator;  /* '=' (or ':'), or that of a spreadsheet: ';', a tab, ',' */
    int has_commas; /* 1: decimal marks are commas */
    int has_begun;  /* 1: a line before was not empty */
    int is_lost;    /* 1: the values belong to a place that was not understood */
    char *out;      /* where the next letter goes */
} rewriting;

static int is_digit(int c)
{
    return '0' <= c && c <= '9';
}

/* 1 if a character stands between two digits. */
static int has_between_digits(text t, char c)
{
    size_t i;

    for (i = 1; i + 1 < t.length; i++)
        if (t.start[i] == c && is_digit(t.start[i - 1]) && is_digit(t.start[i + 1]))
            return 1;
    return 0;
}

/* Find the form of a file.  One without = and : is of a spreadsheet. */
static void find_form(rewriting *r, text contents)
{
    int decimal = r->p->d->decimal;

    r->separator = '=';
    if (!memchr(contents.start, '=', contents.length) &&
        !memchr(contents.start, ':', contents.length))
        r->separator = flk_text_separator(contents);
    r->has_commas = decimal == DECIMAL_COMMA ||
                    (decimal != DECIMAL_POINT && r->separator != ',' &&
                     has_between_digits(contents, ',') && !has_between_digits(contents, '.'));
}

/* Cut NAME = VALUE; 0 if a line is not of this form.  Of a spreadsheet the value is that and its unit. */
static int cut_answer(const rewriting *r, text line, text *name, text *value, text *units)
{
    text rest = line;

    *units = flk_text_of("");
    if (r->separator == '=') {
        flk_text_split(&rest, memchr(line.start, '=', line.length) ? '=' : ':', name);
        *name = flk_text_trim(*name);
        *value = rest.start ? flk_text_trim(rest) : rest;
        return rest.start != NULL;
    }
    flk_text_field(&rest, r->separator, name);
    if (!rest.start)
        return 0;
    flk_text_field(&rest, r->separator, value);
    flk_text_field(&rest, r->separator, units);
    return 1;
}

/* Append a text, with points for decimal commas. */
static void put(rewriting *r, text t, int has_commas)
{
    size_t i;

    for (i = 0; i < t.length; i++)
        *r->out++ = has_commas && t.start[i] == ',' && i > 0 && is_digit(t.start[i - 1]) &&
                            i + 1 < t.length && is_digit(t.start[i + 1])
                        ? '.'
                        : t.start[i];
}

/* 1 if a value says where the values below it are: an angle, a time, a length, a branch. */
static int is_place(const deck *d, int is_branch, text value)
{
    static const quantity places[] = {QUANTITY_ANGLE, QUANTITY_TIME, QUANTITY_LENGTH};
    char why[MESSAGE_SIZE];
    quantity_value read;
    size_t i;

    if (is_branch)
        return flk_text_equal(value, "open") || flk_text_equal(value, "crossed");
    for (i = 0; i < sizeof places / sizeof places[0]; i++)
        if ((places[i] != QUANTITY_LENGTH || flk_deck_over(d) == QUANTITY_LENGTH) &&
            flk_quantity_read(value, value, places[i], d->bare[places[i]].unit, &read, why))
            return 1;
    return 0;
}

/* Write a line of answers. */
static void put_answer(rewriting *r, text line, text_place place)
{
    parser *p = r->p;
    char *start = r->out, *begin;
    text name, value, units;
    int is_branch, says_where, is_first = !r->has_begun;

    if (!line.length || line.start[0] == '[') {
        r->is_lost &= !line.length;
        put(r, line, 0);
        return;
    }
    r->has_begun = 1;
    if (!cut_answer(r, line, &name, &value, &units)) {
        flk_mistake(&p->d->slips, place, "expected NAME = VALUE, not '%t'", line);
        return;
    }
    is_branch = flk_text_equal(name, "branch");
    says_where = flk_text_equal(name, "at") || is_branch;
    if (r->separator != '=' && is_first && !says_where && value.length &&
        !strchr("+-.0123456789", value.start[0]))
        return; /* the names of the columns */
    if (says_where)
        r->is_lost &= is_branch; /* another place begins */
    if (r->is_lost)
        return;
    put(r, says_where ? flk_text_of(is_branch ? "branch" : "at") : name, 0);
    put(r, flk_text_of(" = "), 0);
    begin = r->out;
    put(r, value, r->has_commas);
    put(r, flk_text_of(units.length ? " " : ""), 0);
    put(r, units, 0);
    value.start = begin;
    value.length = (size_t)(r->out - begin);
    if (says_where && !is_place(p->d, is_branch, flk_reader_plain(p, value))) {
        flk_mistake(&p->d->slips, place,
                    is_branch ? "'%t' is neither open nor crossed: the values below it do not count"
                              : "'%t' is no angle: the values below it do not count",
                    value);
        r->out = start;
        r->is_lost = 1;
    }
}

/* More than a line can grow: " = " for a separator and a blank before the unit. */
#define GROWTH 8

text flk_answers_plain(parser *p, text contents)
{
    int line_end = flk_text_line_end(contents);
    text rest = flk_text_without_mark(contents), line, plain = flk_text_of("");
    text_place place;
    rewriting r;

    memset(&r, 0, sizeof r);
    r.p = p;
    find_form(&r, contents);
    plain.start = r.out =
        flk_reader_keep(p, contents.length + GROWTH * (flk_text_count(contents, line_end) + 1) + 1);
    if (!r.out)
        return flk_text_of("");
    place.source = p->name;
    place.line = 0;
    while (flk_text_split(&rest, line_end, &line)) {
        place.line++;
        if (memchr(line.start, '\0', line.length)) { /* not text, which the reader tells */
            put(&r, line, 0);
        } else {
            line = flk_text_trim(line);
            if (r.separator == '=' || (line.length && line.start[0] == '#'))
                line = flk_line_without_comment(line);
            put_answer(&r, line, place);
        }
        if (rest.start)
            *r.out++ = (char)line_end;
    }
    plain.length = (size_t)(r.out - plain.start);
    place.line = 1; /* both notes are on the file */
    if (r.has_commas && has_between_digits(contents, ','))
        flk_mistake(&p->d->notes, place, "decimal commas, read as points");
    if (r.separator == '=' && r.has_begun && !memchr(plain.start, '[', plain.length))
        flk_mistake(&p->d->notes, place, "no header [expect], read as if it were there");
    return plain;
}
