/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck_lines.h - the text of a deck as sections and lines, and each number in them with what it stands for.
**
** The schema says what a key has; a number with a unit has the unit's dimension.
*/
#ifndef DECK_LINES_H
#define DECK_LINES_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "deck/schema.h"
#include "fourlink.h"

#define LONG_VALUE 2000
#define MOST_BLOCKS 40
#define MOST_LINES 30

typedef struct deck_line {
    char name[64], value[LONG_VALUE];
    section_code section;
    key_code key; /* KEY_COUNT: another name */
} deck_line;

/* A section, and the lines before the first one. */
typedef struct deck_block {
    char header[100]; /* "[load K]"; "" of the first */
    section_code section;
    int n;
    deck_line line[MOST_LINES];
} deck_block;

typedef struct deck_lines {
    int n;
    deck_block block[MOST_BLOCKS];
} deck_lines;

/* ---------------------------------------------------------------------------------- sections and lines */

static inline text bytes_of(const char *begin, size_t n)
{
    text t = flk_text_of(begin);

    t.length = n;
    return t;
}

static inline deck_block *add_block(deck_lines *d, const char *header)
{
    deck_block *b = &d->block[d->n++];
    size_t n = header[0] == '['; /* the bracket */

    if (d->n > MOST_BLOCKS)
        abort();
    snprintf(b->header, sizeof b->header, "%.99s", header);
    b->section = SECTION_TOP;
    if (n)
        b->section = flk_find_section(bytes_of(header + n, strcspn(header + n, " ]")));
    b->n = 0;
    return b;
}

static inline deck_line *add_line(deck_block *b, const char *name, const char *value)
{
    deck_line *line = &b->line[b->n++];

    if (b->n > MOST_LINES)
        abort();
    snprintf(line->name, sizeof line->name, "%.63s", name);
    snprintf(line->value, sizeof line->value, "%s", value);
    line->section = b->section;
    line->key = flk_find_key(b->section, flk_text_of(name));
    return line;
}

/* A deck without comments, each value on one line. */
static inline void read_lines(deck_lines *d, const char *words)
{
    deck_block *b;
    const char *at = words;

    d->n = 0;
    b = add_block(d, "");
    while (*at) {
        char line[LONG_VALUE + 100], *value, *end;
        size_t n = strcspn(at, "\n");

        snprintf(line, sizeof line, "%.*s", (int)n, at);
        at += n + (at[n] == '\n');
        if (line[0] == '[')
            b = add_block(d, line);
        else if ((value = strchr(line, '=')) != NULL) {
            for (end = value; end > line && end[-1] == ' '; end--)
                ;
            *end = '\0';
            add_line(b, line, value + 1 + strspn(value + 1, " "));
        }
    }
}

static inline void write_lines(const deck_lines *d, char *out, size_t size)
{
    size_t used = 0;
    int i, k;

#define PUT(...) used += (size_t)snprintf(out + used, used < size ? size - used : 0, __VA_ARGS__)
    out[0] = '\0';
    for (i = 0; i < d->n; i++) {
        if (d->block[i].header[0])
            PUT("%s\n", d->block[i].header);
        for (k = 0; k < d->block[i].n; k++)
            PUT("%s = %s\n", d->block[i].line[k].name, d->block[i].line[k].value);
    }
#undef PUT
    if (used >= size)
        abort();
}

/* The section; null if there is none. */
static inline deck_block *find_block(deck_lines *d, section_code section)
{
    int i;

    for (i = 0; i < d->n; i++)
        if (d->block[i].section == section)
            return &d->block[i];
    return NULL;
}

static inline deck_line *line_of(deck_block *b, key_code key)
{
    int k;

    for (k = 0; b && k < b->n; k++)
        if (b->line[k].key == key)
            return &b->line[k];
    return NULL;
}

static inline deck_line *find_line(deck_lines *d, key_code key)
{
    return line_of(find_block(d, flk_key_table[key].section), key);
}

/* Give a key a value; the section is added where there is none. */
static inline void set_line(deck_lines *d, key_code key, const char *value)
{
    const section_code section = flk_key_table[key].section;
    deck_line *line = find_line(d, key);
    char header[100];

    if (line) {
        snprintf(line->value, sizeof line->value, "%s", value);
        return;
    }
    snprintf(header, sizeof header, "[%s]", flk_section_table[section].name);
    add_line(find_block(d, section) ? find_block(d, section) : add_block(d, header),
             flk_key_table[key].name, value);
}

/* Give a key a value unless it has one. */
static inline void set_default(deck_lines *d, key_code key, const char *value)
{
    if (!find_line(d, key))
        set_line(d, key, value);
}

static inline void drop_key(deck_block *b, key_code key)
{
    deck_line *line = line_of(b, key);

    if (line) {
        memmove(line, line + 1, (size_t)(&b->line[b->n] - (line + 1)) * sizeof *line);
        b->n--;
    }
}

static inline void drop_sections(deck_lines *d, section_code section)
{
    int i, kept = 0;

    for (i = 0; i < d->n; i++)
        if (d->block[i].section != section)
            d->block[kept++] = d->block[i];
    d->n = kept;
}

/* ----------------------------------------------------------------------------------- numbers in values */

/* What a number is in its value: alone, a component of (x, y), size or angle of "10 N at 30 deg", or the
** argument of a curve. */
typedef enum number_part { WHOLE, COMPONENT_X, COMPONENT_Y, SIZE, POLAR, ARGUMENT } number_part;

typedef struct deck_number {
    double value;
    char unit_name[64]; /* "": a bare number */
    dimension dim;      /* of its unit; of a bare number that of the key */
    number_part part;
} deck_number;

typedef void change_number(deck_number *number, const deck_line *line, const void *how);

/* Read a unit as one of the key's quantity or else of any: lb is a force or a mass. */
static inline int read_unit_of_key(text t, key_code key, unit *u)
{
    text bad;
    int q;

    if (!flk_unit_read(t, u, &bad))
        return 0;
    if (key < KEY_COUNT && flk_unit_read_as(t, flk_quantities[flk_key_table[key].q].dim, u, &bad) &&
        flk_dimension_equal(u->dim, flk_quantities[flk_key_table[key].q].dim))
        return 1;
    for (q = 0; q < QUANTITY_COUNT; q++)
        if (flk_unit_read_as(t, flk_quantities[q].dim, u, &bad) &&
            flk_dimension_equal(u->dim, flk_quantities[q].dim))
            break;
    return 1;
}

/* The unit at the begin of a text, without blanks at its end: as many words as are one.  Returns its
** length. */
static inline size_t unit_length(const char *at, key_code key, unit *u)
{
    size_t n = strspn(at, " "), found = 0;

    while (at[n] && (isalpha((unsigned char)at[n]) || at[n] == '%')) {
        n += strcspn(at + n, " ,;)&");
        if (!read_unit_of_key(bytes_of(at + strspn(at, " "), n - strspn(at, " ")), key, u))
            break;
        found = n;
        n += strspn(at + n, " ");
    }
    if (found)
        read_unit_of_key(bytes_of(at + strspn(at, " "), found - strspn(at, " ")), key, u);
    return found;
}

static inline int begins_number(const char *at)
{
    at += *at == '-' || *at == '+';
    at += *at == '.';
    return isdigit((unsigned char)*at);
}

/* The unit of some numbers, read at a place; returns the place behind it. */
static inline const char *read_unit(const char *at, const deck_line *line, deck_number *numbers,
                                    int n)
{
    unit u;
    size_t size = unit_length(at, line->key, &u), blanks = strspn(at, " ");
    int k;

    for (k = 0; k < n; k++) {
        numbers[k].unit_name[0] = '\0';
        if (size) {
            numbers[k].dim = u.dim;
            snprintf(numbers[k].unit_name, sizeof numbers[k].unit_name, "%.*s",
                     (int)(size - blanks), at + blanks);
        } else if (line->key < KEY_COUNT)
            numbers[k].dim = flk_quantities[flk_key_table[line->key].q].dim;
        else
            memset(&numbers[k].dim, 0, sizeof numbers[k].dim);
    }
    return at + size;
}

/* Change each number of a line. */
static inline void change_line(deck_line *line, change_number *change, const void *how)
{
    char in[LONG_VALUE];
    const char *at = in;
    size_t used = 0;

#define PUT(...) \
    used += (size_t)snprintf(line->value + used, sizeof line->value - used, __VA_ARGS__)
#define UNIT_OF(number) (number).unit_name[0] ? " " : "", (number).unit_name
    snprintf(in, sizeof in, "%s", line->value);
    line->value[0] = '\0';
    while (*at) {
        deck_number number[2];
        int size = 0,
            is_word = at > in && (isalnum((unsigned char)at[-1]) || strchr("^._\"", at[-1]));

        if (*at == '(' &&
            sscanf(at, "(%lf ,%lf )%n", &number[0].value, &number[1].value, &size) == 2 && size) {
            at = read_unit(at + size, line, number, 2);
            number[0].part = COMPONENT_X;
            number[1].part = COMPONENT_Y;
            change(&number[0], line, how);
            change(&number[1], line, how);
            PUT("(%.17g, %.17g)%s%s", number[0].value, number[1].value, UNIT_OF(number[0]));
        } else if (begins_number(at) && !is_word) {
            const char *before = at;
            char *end;

            number[0].value = strtod(at, &end);
            at = read_unit(end, line, number, 1);
            size = (int)strspn(at, " ");
            number[0].part = size && (begins_number(at + size) || at[size] == '(')   ? ARGUMENT
                             : size && strncmp(at + size, "at ", 3) == 0             ? SIZE
                             : before - in >= 3 && memcmp(before - 3, "at ", 3) == 0 ? POLAR
                                                                                     : WHOLE;
            change(&number[0], line, how);
            PUT("%.17g%s%s", number[0].value, UNIT_OF(number[0]));
        } else
            PUT("%c", *at++);
    }
#undef UNIT_OF
#undef PUT
}

/* 1 if a line has numbers with what they stand for: it is no text, word, count or unit. */
static inline int has_numbers(const deck_line *line)
{
    if (line->key == KEY_TOP_TITLE || line->key == KEY_TABLE_COLUMNS)
        return 0;
    if (line->key == KEY_COUNT)
        return 1;
    switch (flk_key_table[line->key].form) {
    case FORM_WORD:
    case FORM_LINK:
    case FORM_BODY:
    case FORM_UNIT:
    case FORM_COUNT:
        return 0;
    default:
        return 1;
    }
}

static inline void change_numbers(deck_lines *d, change_number *change, const void *how)
{
    int i, k;

    for (i = 0; i < d->n; i++)
        for (k = 0; k < d->block[i].n; k++)
            if (has_numbers(&d->block[i].line[k]))
                change_line(&d->block[i].line[k], change, how);
}

/* Put the points of a curve in the opposite order. */
static inline void reverse_list(char *value)
{
    char in[LONG_VALUE];
    const char *end = in + snprintf(in, sizeof in, "%s", value), *at;
    size_t used = 0;
    int depth = 0;

    for (at = end; at >= in; at--) {
        depth += (*at == ')') - (*at == '(');
        if (at == in || (*at == ',' && depth == 0)) {
            const char *begin = at == in ? in : at + 1;

            begin += strspn(begin, " ");
            used += (size_t)snprintf(value + used, LONG_VALUE - used, "%s%.*s", used ? ", " : "",
                                     (int)(end - begin), begin);
            end = at;
        }
    }
}

#endif
