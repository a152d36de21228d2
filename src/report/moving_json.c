/* SPDX-License-Identifier: GPL-3.0-or-later
**
** moving_json.c - drawings of a motion as JSON, for player.js.
**
** A panel has places, which items name by their numbers:
**
**    [x, y]              fixed, in pixels
**    ["...", "..."]      x and y of each step: see put_track
**    [p, x, y]           x and y from place p
**    [p, q, a, b, c]     from place p, a of the way to q and b further, c to its left
**
** and items:  "as" line, arrow, arc, disc, centre, text, label or path, its class "look", its places "at", and
** its "name"; with "size" a radius or the length of a head, with "radius" those of an arc.  Of an arc the
** second place is where it begins and how far it goes, in hundredths of a radian, of a text the way from
** the place to its middle.  A label stands beside its first place, "size" from it and more, at first away
** from its second.  A text is a list of words, [words, -1] a subscript and [words, 1] a
** superscript.  "gone": steps [from, to, ...] at which the item is not there.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/text.h"
#include "system/memory.h"
#include "drawing/follow.h"
#include "drawing/svg.h"
#include "interactive.h"
#include "view/notation.h"

#define PER_PIXEL 40 /* of numbers of a track */
#define DIGITS 6     /* of a place */

/* ---------------------------------------------------------------------------------------------- places */

static void put_number(line *l, double x)
{
    line_number(l, floor(1000 * x + 0.5) / 1000, DIGITS);
}

static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";

/* One letter from -30 to 31; others as (-45). */
static void put_small(line *l, long n)
{
    if (n >= -30 && n <= 31) {
        line_byte(l, letters[n + 30]);
    } else {
        line_put(l, n < 0 ? "(-" : "(");
        line_put(l, "%lu)", (unsigned long)labs(n));
    }
}

/* Write a coordinate of a track, in fortieths of a pixel: the first, and how each differs from where the
** two before lead to.  Where the track is not there, it stands still. */
static void put_track(line *l, const motion *m, size_t number, int is_y)
{
    long here, last = 0, before = 0;
    size_t i;

    line_byte(l, '"');
    for (i = 0; i < m->n_steps; i++) {
        const fourlink_vector *at = &m->tracks[number * m->n_steps + i];
        double x = is_y ? at->y : at->x;

        here = gsl_isnan(x) ? last : (long)floor(PER_PIXEL * x + 0.5);
        put_small(l, here - (2 * last - before));
        before = i ? last : here;
        last = here;
    }
    line_byte(l, '"');
}

static void put_place(line *l, const follow *f, const follow_place *x)
{
    int n = x->sort == FOLLOW_ALONG ? 3 : 2, i;

    line_put(l, "[");
    if (x->sort == FOLLOW_OWN) {
        put_track(l, f->m, x->track, 0);
        line_put(l, ",");
        put_track(l, f->m, x->track, 1);
    } else {
        if (x->sort != FOLLOW_FIXED)
            line_put(l, "%lu,", (unsigned long)x->of[0]);
        if (x->sort == FOLLOW_ALONG)
            line_put(l, "%lu,", (unsigned long)x->of[1]);
        for (i = 0; i < n; i++) {
            line_put(l, i ? "," : "");
            put_number(l, x->by[i]);
        }
    }
    line_put(l, "]");
}

/* ----------------------------------------------------------------------------------------------- texts */

/* Write a text as a list of words. */
static void put_words(line *l, const char *words)
{
    char own[MESSAGE_SIZE];
    notation_part x = {NULL, 0, 0, 0};
    int n = 0;

    x.words = words;
    line_put(l, "[");
    while (notation_next(words, &x)) {
        size_t length = GSL_MIN(x.n, sizeof own - 1);

        memcpy(own, x.words, length);
        own[length] = '\0';
        line_put(l, n++ ? "," : "");
        interactive_put(l, x.level ? "[%q" : "%q", x.is_minus ? NOTATION_MINUS : own);
        if (x.level)
            line_put(l, x.level < 0 ? ",-1]" : ",1]");
    }
    line_put(l, "]");
}

/* Write the values of an item by step, with | between them, and their units unless they are all the same; an
** empty one is that of the step before. */
static void put_values(line *l, const motion *m, size_t item)
{
    const char *value, *end;
    motion_value last = {MOTION_NONE, MOTION_NONE};
    size_t i;

    line_byte(l, '"');
    for (i = 0; i < m->n_steps; i++) {
        const motion_value *x = motion_value_at(m, item, i);

        line_put(l, i ? "|" : "");
        if (!motion_has(m, item, i))
            continue;
        if (x->value != last.value || x->unit != last.unit) {
            value = display_words(&m->kept, x->value);
            end = m->items[item].unit_varies ? display_words(&m->kept, x->unit) : "";
            line_put(l, *value == '-' ? NOTATION_MINUS : "");
            line_text(l, value + (*value == '-'), strlen(value) - (*value == '-'));
            line_text(l, end, strlen(end));
        }
        last = *x;
    }
    line_byte(l, '"');
}

/* Write the words of an item, or of one whose value changes, the words before it and its unit. */
static void put_all_words(line *l, const motion *m, size_t item)
{
    const motion_item *x = &m->items[item];
    char all[DISPLAY_WORDS];

    line_put(l, "\"words\":");
    if (!x->varies && !x->unit_varies) {
        put_words(l, display_text_of(&m->kept, &x->like, all));
        return;
    }
    put_words(l, display_words(&m->kept, x->like.words));
    line_put(l, ",\"values\":");
    put_values(l, m, item);
    line_put(l, ",\"unit\":");
    put_words(l, x->unit_varies ? "" : display_words(&m->kept, x->like.unit));
}

/* ----------------------------------------------------------------------------------------------- items */

/* The steps at which an item is not there: [from, to, ...], the last of each not among them. */
static void put_gone(line *l, const motion *m, size_t item)
{
    size_t i;
    int is_gone = 0, n = 0;

    for (i = 0; i <= m->n_steps; i++) {
        int here = i < m->n_steps && !motion_has(m, item, i);

        if (here != is_gone) {
            line_put(l, n++ ? ",%lu" : ",\"gone\":[%lu", (unsigned long)i);
            is_gone = here;
        }
    }
    line_put(l, n ? "]" : "");
}

/* 1 for a line that stands still: it is a part of a path. */
static int is_still(const follow *f, size_t item)
{
    const motion_item *x = &f->m->items[item];
    size_t i;

    for (i = 0; i < x->n; i++)
        if (x->like.sort != DISPLAY_LINE || f->list[f->number[x->first + i]].sort != FOLLOW_FIXED)
            return 0;
    for (i = 0; i < f->m->n_steps; i++)
        if (!motion_has(f->m, item, i))
            return 0;
    return 1;
}

static void put_point(line *l, char before, fourlink_vector at)
{
    line_byte(l, before);
    put_number(l, at.x);
    line_byte(l, ',');
    put_number(l, at.y);
}

static void put_curve(line *l, const motion *m, const motion_item *x)
{
    const fourlink_vector *at = m->curves + x->first;
    size_t from, n, i;

    for (from = 0; from < x->n; from += n + 1) {
        for (n = 0; from + n < x->n && !gsl_isnan(at[from + n].x); n++)
            ;
        for (i = 0; i < n; i = display_next_bend(at + from, i, n))
            put_point(l, i ? 'L' : 'M', at[from + i]);
    }
}

/* Write a curve, or lines that stand still as one path, as far as they follow each other with one look;
** returns the last of them. */
static size_t put_path(line *l, const follow *f, size_t item)
{
    const motion_item *x = &f->m->items[item], *y = x;
    size_t i;

    line_put(l, ",\"d\":\"");
    if (x->like.sort == DISPLAY_CURVE)
        put_curve(l, f->m, x);
    for (; x->like.sort != DISPLAY_CURVE && item < f->m->n_items; item++) {
        y = &f->m->items[item];
        if (y->like.pen != x->like.pen || y->like.layer != x->like.layer || !is_still(f, item))
            break;
        for (i = 0; i < y->n; i++)
            put_point(l, i ? 'L' : 'M', follow_at(f, f->number[y->first + i], 0));
    }
    line_put(l, "\"");
    return x->like.sort == DISPLAY_CURVE ? item : item - 1;
}

static void put_places(line *l, const follow *f, const motion_item *x)
{
    size_t i;

    line_put(l, ",\"at\":[");
    for (i = 0; i < x->n; i++) {
        line_put(l, i ? "," : "");
        line_put(l, "%lu", (unsigned long)f->number[x->first + i]);
    }
    line_put(l, "]");
}

static void put_size(line *l, double size)
{
    if (size > 0) {
        line_put(l, ",\"size\":");
        put_number(l, size);
    }
}

/* Write an item; returns the last one that has been written. */
static size_t put_item(line *l, const follow *f, size_t item)
{
    static const char *const sorts[] = {"line", "arrow", "arc",    "path", "path",
                                        "path", "disc",  "centre", "disc", "text"};
    const motion_item *x = &f->m->items[item];
    int is_path = x->like.sort == DISPLAY_CURVE || is_still(f, item);
    char class_name[30];

    interactive_put(l, "{\"as\":%q,\"look\":%q",
                    is_path              ? "path"
                    : motion_is_label(x) ? "label"
                                         : sorts[x->like.sort],
                    svg_class(&x->like, class_name));
    if (x->like.name)
        interactive_put(l, ",\"name\":%q", display_words(&f->m->kept, x->like.name));
    if (is_path) {
        item = put_path(l, f, item);
        line_put(l, "}");
        return item;
    }
    put_places(l, f, x);
    if (x->like.sort == DISPLAY_ARC) {
        line_put(l, ",\"radius\":[");
        put_number(l, x->like.radius[0]);
        line_put(l, ",");
        put_number(l, x->like.radius[1]);
        line_put(l, "]");
    } else if (x->like.sort == DISPLAY_TEXT) {
        put_size(l, x->like.size);
        line_put(l, ",");
        if (x->like.align != DISPLAY_MIDDLE)
            line_put(l, "\"anchor\":\"%s\",", x->like.align == DISPLAY_LEFT ? "start" : "end");
        put_all_words(l, f->m, item);
    } else {
        put_size(l, x->like.size);
    }
    put_gone(l, f->m, item);
    line_put(l, "}");
    return item;
}

static void put_items(line *l, const follow *f)
{
    size_t i;
    int layer, n = 0;

    line_put(l, "\"items\":[");
    for (layer = 0; layer < DISPLAY_LAYERS; layer++)
        for (i = 0; i < f->m->n_items; i++)
            if (f->m->items[i].like.layer == layer && f->m->items[i].like.part != DISPLAY_KEY &&
                f->m->items[i].like.part != DISPLAY_NOTE) {
                interactive_put_comma(l, &n);
                i = put_item(l, f, i);
            }
    line_put(l, "],\n");
}

/* The key: a look and its words.  A sample stands before its words. */
static void put_key(line *l, const motion *m)
{
    char own[30];
    const char *class_name = "";
    size_t i;
    int n = 0;

    line_put(l, "\"key\":[");
    for (i = 0; i < m->n_items; i++) {
        const motion_item *x = &m->items[i];

        if (x->like.part != DISPLAY_KEY)
            continue;
        if (x->like.sort != DISPLAY_TEXT) {
            class_name = svg_class(&x->like, own);
            continue;
        }
        interactive_put_comma(l, &n);
        interactive_put(l, "{\"look\":%q,", class_name);
        put_all_words(l, m, i);
        line_put(l, "}");
    }
    line_put(l, "],\n");
}

static void put_notes(line *l, const motion *m)
{
    size_t i;
    int n = 0;

    line_put(l, "\"notes\":[");
    for (i = 0; i < m->n_items; i++)
        if (m->items[i].like.part == DISPLAY_NOTE) {
            interactive_put_comma(l, &n);
            line_put(l, "{");
            put_all_words(l, m, i);
            put_gone(l, m, i);
            line_put(l, "}");
        }
    line_put(l, "]");
}

/* ----------------------------------------------------------------------------------------------- panels */

static void put_box(line *l, const char *name, double left, double top, double width, double height)
{
    double all[4];
    int i;

    all[0] = left;
    all[1] = top;
    all[2] = width;
    all[3] = height;
    interactive_put(l, "%q:[", name);
    for (i = 0; i < 4; i++) {
        line_put(l, i ? "," : "");
        line_number(l, all[i], 12);
    }
    line_put(l, "],");
}

int moving_json_put(line *l, const moving_panel *p)
{
    static const char *const sizes[] = {"whole", "half", "third"};
    const place_box *box = &p->box, *axes = &p->axes;
    follow f;
    size_t i;

    follow_open(&f, &p->list);
    if (!memory_has_failed()) {
        interactive_put(l, "{\"title\":%q,\"size\":%q,", p->title, sizes[p->size]);
        put_box(l, "sheet", 0, 0, p->width, p->height);
        put_box(l, "box", box->x_min, box->y_min, box->x_max - box->x_min, box->y_max - box->y_min);
        put_box(l, "axes", axes->x_min, axes->x_max, axes->y_min, axes->y_max);
        line_put(l, "\n\"places\":[");
        for (i = 0; i < f.n; i++) {
            line_put(l, i ? ",\n" : "\n");
            put_place(l, &f, &f.list[i]);
        }
        line_put(l, "],\n");
        put_items(l, &f);
        put_key(l, &p->list);
        put_notes(l, &p->list);
        line_put(l, "}");
    }
    follow_close(&f);
    return !memory_has_failed();
}
