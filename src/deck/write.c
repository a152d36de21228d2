/* SPDX-License-Identifier: GPL-3.0-or-later
**
** write.c - writes a deck with the values that changes, the design and the synthesis have set.
**
** The rest is the user's text, without its [sweep] and [synthesis].
*/
#include <string.h>

#include "base/number.h"
#include "lines.h"
#include "numbers.h"
#include "parser.h"
#include "synthesis.h"
#include "values.h"
#include "write_pins.h"

/* The destination of a deck; text beyond its size is cut off. */
typedef struct writer {
    parser *p;
    const deck *d;
    const char *pins; /* lines of [pins], from which lengths follow; null: none */
    char *out;
    size_t size, length;
    const char *line_end;
    int is_within_line;
    int ends_blank; /* 1: the last line is empty */
    const char *at; /* the text before this place has been written or left out */
} writer;

/* A key or a name of a section whose value differs from the text. */
typedef struct changed {
    text name, own, value;
    key_code key; /* of a setting */
    const setting *s;
    int is_dropped; /* 1: it follows from the pins */
} changed;

static void put_text(writer *w, text t)
{
    size_t room = w->size > w->length ? w->size - w->length : 0;

    if (t.length && room)
        memcpy(w->out + w->length, t.start, t.length < room ? t.length : room);
    w->length += t.length;
    if (t.length) {
        int ends_line = t.start[t.length - 1] == w->p->line_end;
        const char *before = t.start + t.length - 1; /* the end of the line, with its CR */

        while (before > t.start && strchr("\r\n", before[-1]) && before[-1] != w->p->line_end)
            before--;
        w->ends_blank =
            ends_line && (before > t.start ? before[-1] == w->p->line_end : !w->is_within_line);
        w->is_within_line = !ends_line;
    }
}

static void put_string(writer *w, const char *string)
{
    put_text(w, flk_text_of(string));
}

/* ------------------------------------------------------------------------------------------ values */

/* Write a value of a design in the unit of the deck's own value, if that has a different unit. */
static void put_varied(writer *w, const section_use *use, const changed *c)
{
    quantity q = flk_quantity_of_key(use, c->key);
    char number[DIGITS_SIZE];
    text own, given;
    unit u, other;

    if (!c->own.start || !flk_unit_of_value(w->p->d, c->value, q, &given, &other) ||
        !flk_unit_of_value(w->p->d, c->own, q, &own, &u) || !own.length ||
        !flk_dimension_equal(u.dim, other.dim) || (u.up == other.up && u.down == other.down) ||
        !flk_number_in_unit(c->s->si[0], &u, number)) {
        put_text(w, c->value);
        return;
    }
    put_string(w, strcat(number, " "));
    put_text(w, own);
}

/* Write a vector with parts set separately: both components, in the unit of the vector, or of a part that a
** change has set. */
static void put_vector(writer *w, const setting *s, quantity q)
{
    char x[DIGITS_SIZE], y[DIGITS_SIZE], both[2 * DIGITS_SIZE];
    const deck *d = w->p->d;
    text name, other;
    unit u, of_part;
    int i;

    if (!flk_unit_of_value(d, s->value, q, &name, &u)) { /* origin, mid */
        name.length = 0;
        u = d->bare[q].unit;
    }
    for (i = 0; i < PART_ANGLE; i++)
        if (IS_SET(&s->parts[i]) && (s->parts[i].source == GIVEN_BY_CHANGE || !name.length) &&
            flk_unit_of_value(d, s->parts[i].value, q, &other, &of_part) && other.length) {
            name = other;
            u = of_part;
        }
    if (!name.length)
        name = flk_text_of(d->bare[q].name);
    if (!flk_number_in_unit(s->si[0], &u, x) || !flk_number_in_unit(s->si[1], &u, y)) {
        name = flk_text_of(flk_quantities[q].unit);
        u.up = u.down = 1;
        flk_number_in_unit(s->si[0], &u, x);
        flk_number_in_unit(s->si[1], &u, y);
    }
    put_string(w, flk_text_join(both, sizeof both, "(", x, ", ", y, ") ", (char *)NULL));
    put_text(w, name);
}

static void put_value(writer *w, const section_use *use, const changed *c)
{
    int is_quoted = c->s && flk_key_table[c->key].form == FORM_TEXT &&
                    flk_line_without_comment(c->value).length < c->value.length;

    if (c->s && c->s->parts) {
        put_vector(w, c->s, flk_key_table[c->key].q);
    } else if (c->s && c->s->source == GIVEN_BY_DESIGN) {
        put_varied(w, use, c);
    } else {
        put_string(w, is_quoted ? "\"" : "");
        put_text(w, c->value);
        put_string(w, is_quoted ? "\"" : "");
    }
}

/* ------------------------------------------------------------------------------------------ sections */

/* The word that a key must have with [pins]; null: it may stay as it is. */
static const char *new_word(const writer *w, key_code key)
{
    return w->pins && (key == KEY_TOP_AXES || key == KEY_TABLE_BRANCH)
               ? flk_write_word(w->p, w->d, key)
               : NULL;
}

/* Entry i of a section, keys first; 0 if it is unchanged. */
static int find_changed(const writer *w, const section_use *use, size_t i, changed *c)
{
    size_t n = flk_section_keys(use->section);
    const parser *p = w->p;
    const named_value *named;
    const char *word;

    memset(c, 0, sizeof *c);
    if (i < n) {
        c->s = &use->settings[i];
        c->key = (key_code)(flk_first_key(use->section) + (key_code)i);
        c->name = flk_text_of(flk_key_table[c->key].name);
        c->own = c->s->own;
        c->value = c->s->value;
        c->is_dropped = w->pins && IS_SET(c->s) && flk_write_drops(w->d, c->key);
        if (c->is_dropped)
            return 1;
        word = new_word(w, c->key);
        if (word) {
            c->value = flk_text_of(word);
            c->s = NULL;
            return 1;
        }
        if (c->key == KEY_TOP_SOLVER && !IS_SET(c->s) && p->d->sweep.n_variables) {
            c->value = flk_text_of("dyad"); /* the default of a [sweep] */
            c->s = NULL;
            return 1;
        }
        return IS_SET(c->s) && (c->s->parts || c->s->source != GIVEN_BY_TEXT);
    }
    named = &p->named[i - n];
    c->name = named->name;
    c->own = named->own;
    c->value = named->value;
    return named->source != GIVEN_BY_TEXT && &p->uses[named->use] == use;
}

static size_t count_entries(const parser *p, const section_use *use)
{
    return flk_section_keys(use->section) + (p->has_changed_names ? p->n_named : 0);
}

/* The place in the text of a character of its copy; the end of the text for null. */
static const char *in_text(const parser *p, const char *in_copy)
{
    return p->text.start + (in_copy ? (size_t)(in_copy - p->copy) : p->text.length);
}

static const char *line_after(const parser *p, const char *from)
{
    const char *end = in_text(p, NULL), *last = memchr(from, p->line_end, (size_t)(end - from));

    return last ? last + 1 : end;
}

/* Write the text up to a place. */
static void copy_to(writer *w, const char *to)
{
    text t;

    t.start = w->at;
    t.length = (size_t)(to - w->at);
    put_text(w, t);
    w->at = to;
}

/* The start of a line. */
static const char *line_of(const parser *p, const char *at)
{
    while (at > p->text.start && at[-1] != p->line_end)
        at--;
    return at;
}

/* Write the new value.  If the old one continues on other lines, only the comment of the first line is
** kept. */
static void replace(writer *w, const section_use *use, const changed *c)
{
    const char *start = in_text(w->p, c->own.start), *end = start + c->own.length;
    const char *next = line_after(w->p, start);
    text first;

    if (c->is_dropped) {
        copy_to(w, line_of(w->p, start));
        w->at = line_after(w->p, end);
        return;
    }
    copy_to(w, start);
    put_value(w, use, c);
    w->at = end;
    if (end <= next)
        return;
    first.start = start;
    first.length = (size_t)(next - start);
    w->at = start + flk_line_without_comment(first).length;
    copy_to(w, next);
    w->at = line_after(w->p, end);
}

/* Write the values that are not in the text, each on its own line. */
static void add_new_values(writer *w, const section_use *use)
{
    size_t n = count_entries(w->p, use), i;
    int has_header = use->start != NULL;
    changed c;

    for (i = 0; i < n; i++) {
        if (!find_changed(w, use, i, &c) || c.own.start || c.is_dropped)
            continue;
        put_string(w, w->is_within_line ? w->line_end : "");
        if (!has_header) {
            put_string(w, w->line_end);
            put_string(w, "[");
            put_string(w, flk_section_table[use->section].name);
            put_string(w, use->name.length ? " " : "");
            put_text(w, use->name);
            put_string(w, "]");
            put_string(w, w->line_end);
            has_header = 1;
        }
        put_text(w, c.name);
        put_string(w, " = ");
        put_value(w, use, &c);
        put_string(w, w->line_end);
    }
}

/* The next changed value of a section, in text order; 0 if there is none. */
static int find_next(const writer *w, const section_use *use, changed *next)
{
    size_t n = count_entries(w->p, use), i;
    changed c;

    next->own.start = NULL;
    for (i = 0; i < n; i++)
        if (find_changed(w, use, i, &c) && c.own.start && in_text(w->p, c.own.start) >= w->at &&
            (!next->own.start || c.own.start < next->own.start))
            *next = c;
    return next->own.start != NULL;
}

/* The first line from a place that is neither empty nor only a comment. */
static const char *first_content(const parser *p, const char *from)
{
    const char *next;
    text line;

    for (; from < in_text(p, NULL); from = next) {
        next = line_after(p, from);
        line.start = from;
        line.length = (size_t)(next - from);
        while (line.length && strchr("\r\n", line.start[line.length - 1]))
            line.length--;
        if (flk_text_trim(flk_line_without_comment(line)).length)
            break;
    }
    return from;
}

/* Write lines that end in LF. */
static void put_lines(writer *w, const char *lines)
{
    text rest = flk_text_of(lines), one;

    while (rest.length && flk_text_split(&rest, '\n', &one)) {
        put_text(w, one);
        put_string(w, w->line_end);
    }
}

/* 1 if nothing of a section is left. */
static int is_emptied(const writer *w, const section_use *use)
{
    size_t n = flk_section_keys(use->section), i;
    int has_dropped = 0;

    for (i = 0; i < n && w->pins; i++)
        if (IS_SET(&use->settings[i])) {
            if (!flk_write_drops(w->d, (key_code)(flk_first_key(use->section) + (key_code)i)))
                return 0;
            has_dropped = 1;
        }
    return has_dropped;
}

/* The end of the keys of a section, or where the writer is. */
static const char *end_of_keys(const writer *w, const section_use *use)
{
    size_t n = flk_section_keys(use->section), i;
    const char *last = w->at;

    for (i = 0; i < n; i++) {
        const text *own = &use->settings[i].own;
        const char *end =
            own->start ? line_after(w->p, in_text(w->p, own->start) + own->length) : last;

        last = end > last ? end : last;
    }
    return last;
}

static void write_section(writer *w, const section_use *use)
{
    const char *start = in_text(w->p, use->start), *next;
    changed c;

    if (is_emptied(w, use)) { /* its comments are left */
        copy_to(w, start);
        w->at = line_after(w->p, start);
        while (find_next(w, use, &c))
            replace(w, use, &c);
        for (next = w->at; w->ends_blank && next < in_text(w->p, NULL) && strchr("\r\n", *next);
             next++)
            w->at = next + 1;
        return;
    }
    copy_to(w, !use->start                   ? start
               : use->section == SECTION_TOP ? first_content(w->p, start)
                                             : line_after(w->p, start));
    w->is_within_line &= use->section != SECTION_TOP; /* it may follow a byte order mark */
    add_new_values(w, use);
    while (find_next(w, use, &c))
        replace(w, use, &c);
    if (w->pins && use->section == SECTION_TOP) {
        copy_to(w, end_of_keys(w, use));
        put_string(w, w->is_within_line ? w->line_end : "");
        put_lines(w, w->pins);
    }
}

/* Write a deck, with these lines of [pins] unless they are null. */
static void write_deck(const deck *d, const char *pins, char *out, unsigned long size,
                       unsigned long *length)
{
    const section_use *use, *end;
    const char *first;
    writer w;

    memset(&w, 0, sizeof w);
    w.p = d->found ? d->found : d->settings;
    w.d = d;
    w.pins = pins;
    w.out = out;
    w.size = size;
    w.at = w.p->text.start;
    first = line_after(w.p, w.at);
    w.line_end = w.p->line_end == '\r'                   ? "\r"
                 : first - w.at > 1 && first[-2] == '\r' ? "\r\n"
                                                         : "\n";
    if (d->found) {
        copy_to(&w, in_text(w.p, w.p->uses->start));
        put_lines(&w, d->synthesis->head);
    }
    end = w.p->uses + w.p->n_uses;
    for (use = w.p->uses; use < end; use++)
        if (use->section != SECTION_SWEEP && use->section != SECTION_SYNTHESIS) {
            write_section(&w, use);
        } else if (use->start) {
            copy_to(&w, in_text(w.p, use->start));
            w.at = in_text(w.p, use + 1 < end ? use[1].start : NULL);
        }
    copy_to(&w, in_text(w.p, NULL));
    if (d->found) {
        put_string(&w, w.is_within_line ? w.line_end : "");
        put_lines(&w, d->synthesis->tail);
    }
    if (size)
        out[w.length < size ? w.length : size - 1] = '\0';
    *length = (unsigned long)w.length;
}

int fourlink_deck_write(const fourlink_deck *d, char *out, unsigned long size,
                        unsigned long *length)
{
    if (!d || (!out && size) || !length)
        return FOURLINK_NULL;
    write_deck(d, NULL, out, size, length);
    return FOURLINK_OK;
}

int fourlink_deck_write_pins(const fourlink_deck *d, double theta2, char *out, unsigned long size,
                             unsigned long *length)
{
    char pins[PINS_SIZE];
    int status;

    if (!d || (!out && size) || !length)
        return FOURLINK_NULL;
    if (d->pins.is_there)
        return fourlink_deck_write(d, out, size, length);
    status = flk_write_pins(d->found ? d->found : d->settings, d, theta2, pins);
    if (status == FOURLINK_OK)
        write_deck(d, pins, out, size, length);
    return status;
}
