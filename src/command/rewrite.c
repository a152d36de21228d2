/* SPDX-License-Identifier: GPL-3.0-or-later
**
** rewrite.c - the text of a deck with other values.
*/
#include <stdlib.h>
#include <string.h>

#include "rewrite.h"

/* A line of a deck. */
typedef struct deck_line {
    text whole;      /* without its end */
    text content;    /* without comment and blanks */
    text key, value; /* of an assignment; value.start null: it is none */
    int is_section;
    int goes_on; /* 1: it ends in a comma */
} deck_line;

/* Where the walk through a deck is. */
typedef struct walk {
    text rest;
    int line_end;
    text section, name; /* of the section */
    int is_value;       /* 1: the line continues the value of the line before it */
    int went_on;
} walk;

int rewrite_same(text x, text y)
{
    size_t i;

    for (i = 0; i < x.length && i < y.length; i++) {
        int a = x.start[i], b = y.start[i];

        a += 'A' <= a && a <= 'Z' ? 'a' - 'A' : 0;
        b += 'A' <= b && b <= 'Z' ? 'a' - 'A' : 0;
        if (a != b)
            return 0;
    }
    return x.length == y.length;
}

/* Cut a comment off: # or ; at the start of a line or after a blank, outside quotes. */
static text without_comment(text t)
{
    int is_quoted = 0;
    size_t i;

    for (i = 0; i < t.length; i++) {
        text before = t;
        char c = t.start[i];

        before.length = i;
        is_quoted ^= c == '"';
        if ((c == '#' || c == ';') && !is_quoted && (i == 0 || flk_text_blank_before(before)))
            break;
    }
    t.length = i;
    return flk_text_trim(t);
}

static void split_section(text t, text *section, text *name)
{
    *section = *name = t;
    while (name->length && !flk_text_blank(*name))
        *name = flk_text_from(*name, 1);
    section->length -= name->length;
    *name = flk_text_trim(*name);
}

/* The next line; 0 at the end. */
static int next_line(walk *w, deck_line *l)
{
    if (!w->rest.start || !w->rest.length || !flk_text_split(&w->rest, w->line_end, &l->whole))
        return 0;
    if (l->whole.length && l->whole.start[l->whole.length - 1] == '\r')
        l->whole.length--;
    l->content = without_comment(l->whole);
    l->is_section = l->content.length && l->content.start[0] == '[';
    l->value = l->content;
    flk_text_split(&l->value, '=', &l->key);
    l->key = flk_text_trim(l->key);
    if (l->is_section)
        l->value.start = NULL;
    w->is_value = w->went_on && !l->is_section && !l->value.start;
    if (l->content.length)
        w->went_on = l->content.start[l->content.length - 1] == ',';
    if (l->is_section) {
        text inside = flk_text_from(l->content, 1);

        inside.length -= inside.length > 0;
        split_section(flk_text_trim(inside), &w->section, &w->name);
    }
    return 1;
}

static void begin(walk *w, text deck)
{
    memset(w, 0, sizeof *w);
    w->rest = flk_text_without_mark(deck);
    w->line_end = flk_text_line_end(w->rest);
    w->section = w->name = flk_text_of("");
}

static int is_here(const walk *w, const rewrite *r)
{
    return rewrite_same(w->section, r->section) &&
           (!r->name.length || rewrite_same(w->name, r->name));
}

static int is_in_sweep(const walk *w)
{
    return flk_text_equal(w->section, "sweep");
}

/* The value that replaces that of a line, or null. */
static const rewrite *find(const walk *w, const deck_line *l, const rewrite *list, size_t n)
{
    size_t i;

    for (i = n; l->value.start && i-- > 0;) /* the last one counts */
        if (is_here(w, &list[i]) && rewrite_same(l->key, list[i].key))
            return &list[i];
    return NULL;
}

static void put(FILE *out, text t)
{
    fwrite(t.start, 1, t.length, out);
}

/* Write a line with another value; its name and its comment stay. */
static void put_replaced(FILE *out, const deck_line *l, const rewrite *r)
{
    const char *end = l->whole.start + l->whole.length,
               *last = l->content.start + l->content.length;
    text before;

    before.start = l->whole.start;
    before.length = (size_t)(l->value.start - l->whole.start);
    put(out, before);
    fprintf(out, " %s%.*s\n", r->value, (int)(end - last), last);
}

/* Write the values that the deck does not have, in this section, or in sections of their own. */
static void put_added(FILE *out, const walk *w, const rewrite *list, size_t n)
{
    size_t i, k;

    for (i = 0; i < n; i++) {
        const rewrite *r = &list[i];

        for (k = i + 1; k < n; k++) /* the last one counts */
            if (rewrite_same(r->section, list[k].section) && rewrite_same(r->name, list[k].name) &&
                rewrite_same(r->key, list[k].key))
                break;
        if (r->is_there || k < n || (w && !is_here(w, r)))
            continue;
        if (!w) {
            fprintf(out, "\n[%.*s%s%.*s]\n", (int)r->section.length, r->section.start,
                    r->name.length ? " " : "", (int)r->name.length, r->name.start);
        }
        fprintf(out, "%.*s = %s\n", (int)r->key.length, r->key.start, r->value);
    }
}

/* Find which values the deck has, and whether it has their sections. */
static void look(text deck, rewrite *list, size_t n)
{
    deck_line l;
    size_t i;
    walk w;

    for (begin(&w, deck); next_line(&w, &l);)
        for (i = 0; i < n; i++)
            if (l.value.start && is_here(&w, &list[i]) && rewrite_same(l.key, list[i].key))
                list[i].is_there = 1;
}

/* Mark the values that have just been added. */
static void mark_added(const walk *w, rewrite *list, size_t n)
{
    size_t i;

    for (i = 0; i < n; i++)
        list[i].is_there |= is_here(w, &list[i]);
}

void rewrite_split(text whole, rewrite *r)
{
    text section;

    memset(r, 0, sizeof *r);
    r->section = r->name = flk_text_of("");
    r->key = whole;
    if (flk_text_cut_last(whole, ".", &section, &r->key))
        split_section(section, &r->section, &r->name);
}

void rewrite_deck(FILE *out, text deck, rewrite *list, size_t n)
{
    const rewrite *replaced = NULL, *r;
    deck_line l;
    walk w;

    look(deck, list, n);
    begin(&w, deck);
    put_added(out, &w, list, n); /* keys before the first section */
    mark_added(&w, list, n);
    while (next_line(&w, &l)) {
        if (is_in_sweep(&w) || (w.is_value && replaced))
            continue;
        replaced = r = find(&w, &l, list, n);
        if (r) {
            put_replaced(out, &l, r);
            continue;
        }
        put(out, l.whole);
        putc('\n', out);
        if (l.is_section) {
            put_added(out, &w, list, n);
            mark_added(&w, list, n);
        }
    }
    put_added(out, NULL, list, n);
}

char *rewrite_without_sweep(text deck, size_t *length)
{
    char *copy = malloc(deck.length + 2);
    deck_line l;
    walk w;

    *length = 0;
    for (begin(&w, deck); copy && next_line(&w, &l);) {
        if (is_in_sweep(&w))
            continue;
        memcpy(copy + *length, l.whole.start, l.whole.length);
        *length += l.whole.length;
        copy[(*length)++] = '\n';
    }
    return copy;
}
