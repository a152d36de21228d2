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

/* How a file separates a name from its value. */
typedef struct form {
    int separator;  /* '=' (or ':'), or that of a spreadsheet: ';', a tab, ',' */
    int has_commas; /* 1: decimal marks are commas */
} form;

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

/* The form of a file.  One without = and : is of a spreadsheet. */
static form form_of(const deck *d, text contents)
{
    form f = {'=', 0};

    if (!memchr(contents.start, '=', contents.length) &&
        !memchr(contents.start, ':', contents.length))
        f.separator = memchr(contents.start, ';', contents.length)    ? ';'
                      : memchr(contents.start, '\t', contents.length) ? '\t'
                                                                      : ',';
    f.has_commas = d->decimal == DECIMAL_COMMA ||
                   (d->decimal != DECIMAL_POINT && f.separator != ',' &&
                    has_between_digits(contents, ',') && !has_between_digits(contents, '.'));
    return f;
}

/* Cut NAME = VALUE; 0 if a line is not of this form.  Of a spreadsheet the value is that and its unit. */
static int cut_line(const form *f, text line, text *name, text *value, text *units)
{
    text rest = line;

    units->length = 0;
    units->start = line.start;
    if (f->separator == '=') {
        int by = memchr(line.start, '=', line.length) ? '=' : ':';

        *value = line;
        return flk_text_split(value, by, name) && value->start != NULL;
    }
    if (!flk_text_split(&rest, f->separator, name) || !rest.start)
        return 0;
    flk_text_split(&rest, f->separator, value);
    if (rest.start)
        flk_text_split(&rest, f->separator, units);
    *name = flk_text_unquoted(flk_text_trim(*name));
    *value = flk_text_unquoted(flk_text_trim(*value));
    *units = flk_text_unquoted(flk_text_trim(*units));
    return 1;
}

/* Append a text, with points for decimal commas. */
static void put(char **out, text t, int has_commas)
{
    size_t i;

    for (i = 0; i < t.length; i++)
        *(*out)++ = has_commas && t.start[i] == ',' && i > 0 && is_digit(t.start[i - 1]) &&
                            i + 1 < t.length && is_digit(t.start[i + 1])
                        ? '.'
                        : t.start[i];
}

/* 1 if a value says where the values below it are: an angle, a time, a branch. */
static int is_place(const deck *d, int is_branch, text value)
{
    char why[MESSAGE_SIZE];
    quantity_value read;

    if (is_branch)
        return flk_text_equal(value, "open") || flk_text_equal(value, "crossed");
    return flk_quantity_read(value, value, QUANTITY_ANGLE, d->bare[QUANTITY_ANGLE].unit, &read,
                             why) ||
           flk_quantity_read(value, value, QUANTITY_TIME, d->bare[QUANTITY_TIME].unit, &read, why);
}

/* Write a line of answers.  `is_lost`: the values belong to a place that was not understood. */
static void put_line(parser *p, const form *f, text line, text_place place, char **out,
                     int *is_lost)
{
    text name, value, units;
    int is_branch, says_where;
    char *begin;

    if (!line.length || line.start[0] == '[') {
        *is_lost &= !line.length;
        put(out, line, 0);
        return;
    }
    if (!cut_line(f, line, &name, &value, &units)) {
        flk_mistake(&p->d->slips, place, "expected NAME = VALUE, not '%t'", line);
        return;
    }
    name = flk_text_trim(name);
    value = flk_text_trim(value);
    is_branch = flk_text_equal(name, "branch");
    says_where = flk_text_equal(name, "at") || is_branch;
    if (f->separator != '=' && place.line == 1 && !says_where && value.length &&
        !strchr("+-.0123456789", value.start[0]))
        return; /* the names of the columns */
    if (says_where)
        *is_lost &= is_branch; /* another place begins */
    if (*is_lost)
        return;
    put(out, says_where ? flk_text_of(is_branch ? "branch" : "at") : name, 0);
    put(out, flk_text_of(" = "), 0);
    begin = *out;
    put(out, value, f->has_commas);
    if (units.length) {
        *(*out)++ = ' ';
        put(out, units, 0);
    }
    value.start = begin;
    value.length = (size_t)(*out - begin);
    if (says_where && !is_place(p->d, is_branch, flk_reader_plain(p, value))) {
        flk_mistake(&p->d->slips, place,
                    is_branch ? "'%t' is neither open nor crossed: the values below it do not count"
                              : "'%t' is no angle: the values below it do not count",
                    value);
        *out -= value.length + strlen(is_branch ? "branch = " : "at = ");
        *is_lost = 1;
    }
}

/* More than a line can grow: " = " for a separator and a blank before the unit. */
#define GROWTH 8

text flk_answers_plain(parser *p, text contents)
{
    int line_end = flk_text_line_end(contents), is_lost = 0, has_header = 0;
    text rest = flk_text_without_mark(contents), line, plain, name, value, units;
    form f = form_of(p->d, contents);
    text_place place;
    char *begin, *out;

    plain.start = "";
    plain.length = 0;
    begin = out =
        flk_reader_keep(p, contents.length + GROWTH * (flk_text_count(contents, line_end) + 1) + 1);
    if (!begin)
        return plain;
    place.source = p->name;
    place.line = 0;
    while (flk_text_split(&rest, line_end, &line)) {
        place.line++;
        if (memchr(line.start, '\0', line.length)) { /* not text, which the reader tells */
            memcpy(out, line.start, line.length);
            out += line.length;
        } else {
            line = flk_text_trim(line);
            if (f.separator == '=' || (line.length && line.start[0] == '#'))
                line = flk_line_without_comment(line);
            has_header |= line.length > 0 && line.start[0] == '[';
            if (!has_header && f.separator == '=' && cut_line(&f, line, &name, &value, &units)) {
                has_header = 1;
                flk_mistake(&p->d->notes, place, "no header [expect], read as if it were there");
            }
            put_line(p, &f, line, place, &out, &is_lost);
        }
        if (rest.start)
            *out++ = (char)line_end;
    }
    if (f.has_commas && has_between_digits(contents, ','))
        flk_mistake(&p->d->notes, place, "decimal commas, read as points");
    plain.start = begin;
    plain.length = (size_t)(out - begin);
    return plain;
}
