/* SPDX-License-Identifier: GPL-3.0-or-later
**
** moving_json.c - drawings of a motion as JSON, for player.js.
**
** A panel has frames and places, by number:
**
**    frames [p]             upright at a place
**           [p, -1, angle]  at a place, turned: of a body
**           [p, q]          at a place, towards another one
**           [p, q, 1]       so, with the way between them as the unit of x
**    places [frame, x, y]   where they are in a frame, from 1 on, or on the sheet, 0
**
** in pixels, to the right and down, and radians: a number, or a text with that of each step, see series.h.
** A place is in a frame before or on the sheet.
**
** Items name their places: "as" line, arrow, arc, disc, centre, text, label or path, its class "look", its
** places "at", and its "name"; with "size" a radius or the length of a head, with "radius" those of an
** arc.  Of an arc the second place is where it begins in the frame of its centre, and how far it goes, in
** hundredths of a radian, of a text the way from the place to its middle.  A label stands beside its first
** place, "size" from it and more, at first away from its second.  A path "d" moves with the frame "in", if
** not with the sheet.  A text is a list of words, [words, -1] a subscript and [words, 1] a superscript.
** "gone": steps [from, to, ...] at which the item is not there.  "values" of an item are decimals, a series
** in units of the last one, and words that follow, one behind the other; -n, "" and words are those of n
** steps.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "base/text.h"
#include "system/memory.h"
#include "drawing/motion.h"
#include "drawing/svg.h"
#include "interactive.h"
#include "series.h"
#include "view/notation.h"

#define PER_PIXEL 40. /* of numbers of a series */
#define PER_RADIAN 20000.
#define NEAR 0.03  /* pixels: so far a place stays where it is */
#define CLOSE 1e-6 /* the same, for lengths along a way */

/* -------------------------------------------------------------------------------------------- places */

/* To the thousandth of a pixel. */
static void put_pixels(line *l, double x)
{
    series_put_rounded(l, x, 1000);
}

/* A number in the frame that holds it. */
typedef struct seen {
    size_t frame;          /* an item; the number of items: the sheet */
    fourlink_vector *at;   /* by step */
    fourlink_vector first; /* of them that is there */
    int stays;             /* 1: it is always there */
} seen;

/* The places and frames that items have named so far, by the numbers of tracks and of items. */
typedef struct places {
    const motion *m;
    seen *tracks;
    fourlink_vector *all; /* room for that of the tracks */
    size_t *list, n, *frames, n_frames;
    double *numbers; /* room for those of a series */
} places;

/* Find where a number is in a frame; returns 0 if it is somewhere when the frame is not, or moves along
** a way. */
static int see(const places *f, size_t number, size_t frame)
{
    const motion *m = f->m;
    seen *x = &f->tracks[number];
    double near = frame < m->n_items && m->items[frame].like.size > 0 ? CLOSE : NEAR;
    size_t i;

    x->frame = frame;
    x->stays = 1;
    x->first = place_at(GSL_NAN, GSL_NAN);
    x->at = f->all + number * m->n_steps;
    for (i = 0; i < m->n_steps; i++) {
        x->at[i] = motion_seen(m, frame, number, i);
        if (gsl_isnan(x->at[i].x) && !gsl_isnan(m->tracks[number * m->n_steps + i].x))
            return 0;
        x->first = gsl_isnan(x->first.x) ? x->at[i] : x->first;
        x->stays &= gsl_isnan(x->at[i].x) ||
                    (fabs(x->at[i].x - x->first.x) < near && fabs(x->at[i].y - x->first.y) < NEAR);
    }
    return x->stays || near == NEAR;
}

/* An angle without jumps, by that before. */
static double unwound(double x, double before, double turn)
{
    return gsl_isnan(before) ? x : x + turn * floor((before - x) / turn + 0.5);
}

/* Where an arc begins, in the frame of its centre. */
static void see_turns(const places *f, size_t number)
{
    seen *x = &f->tracks[number];
    fourlink_vector *at = x->at;
    double before = GSL_NAN;
    size_t i;

    x->stays = 0;
    x->first.x = GSL_NAN;
    for (i = 0; i < f->m->n_steps; i++) {
        at[i].x += 100 * motion_angle(f->m, f->tracks[number - 1].frame, i);
        at[i].x = unwound(at[i].x, before, 200 * M_PI);
        before = gsl_isnan(at[i].x) ? before : at[i].x;
        x->first = gsl_isnan(x->first.x) ? at[i] : x->first;
    }
}

static void places_close(places *f)
{
    free(f->tracks);
    free(f->all);
    free(f->list);
    free(f->frames);
    free(f->numbers);
}

/* Close it whatever came of it. */
static void places_open(places *f, const motion *m)
{
    size_t i, k;

    memset(f, 0, sizeof *f);
    f->m = m;
    f->tracks = memory_get(m->n_tracks + 1, sizeof *f->tracks);
    f->all = memory_get(m->n_tracks * m->n_steps + 1, sizeof *f->all);
    f->list = memory_get(m->n_tracks + 1, sizeof *f->list);
    f->frames = memory_get(m->n_items + 1, sizeof *f->frames);
    f->numbers = memory_get(m->n_steps, sizeof *f->numbers);
    for (i = 0; i < m->n_items && !memory_has_failed(); i++) {
        const motion_item *x = &m->items[i];
        int is_arc = x->like.sort == DISPLAY_ARC;

        for (k = x->first; x->like.sort != DISPLAY_CURVE && k < x->first + x->n; k++)
            if ((is_arc && k > x->first) || !see(f, k, motion_frame_of(m, k)))
                see(f, k, m->n_items);
        if (is_arc)
            see_turns(f, x->first + 1);
    }
}

static int is_near(fourlink_vector p, fourlink_vector q)
{
    return gsl_isnan(p.x) ? gsl_isnan(q.x) : fabs(p.x - q.x) < CLOSE && fabs(p.y - q.y) < CLOSE;
}

/* 1 if two tracks are one place. */
static int is_one(const places *f, const seen *x, const seen *y)
{
    size_t i;

    if (x->frame != y->frame || x->stays != y->stays || !is_near(x->first, y->first))
        return 0;
    for (i = 0; i < f->m->n_steps && !x->stays; i++)
        if (!is_near(x->at[i], y->at[i]))
            return 0;
    return 1;
}

static size_t number_of_frame(places *f, size_t frame);

/* The number of a place, which may be new. */
static size_t number_of(places *f, size_t number)
{
    size_t k;

    for (k = 0; k < f->n; k++)
        if (is_one(f, &f->tracks[f->list[k]], &f->tracks[number]))
            return k;
    number_of_frame(f, f->tracks[number].frame);
    f->list[f->n] = number;
    return f->n++;
}

/* 1 for the frame of a body, which has its second place itself. */
static int is_body(const places *f, size_t frame)
{
    const motion_item *x = &f->m->items[frame];

    return x->n > 1 && f->m->holds[x->first + 1] == x->like.key;
}

/* The number of a frame, behind those of its places. */
static size_t number_of_frame(places *f, size_t frame)
{
    const motion_item *x = &f->m->items[frame];
    size_t k;

    if (frame == f->m->n_items)
        return 0;
    for (k = 0; k < f->n_frames; k++)
        if (f->frames[k] == frame)
            return k + 1;
    number_of(f, x->first);
    if (x->n > 1 && !is_body(f, frame))
        number_of(f, x->first + 1);
    f->frames[f->n_frames] = frame;
    return ++f->n_frames;
}

static void put_frame(line *l, places *f, size_t frame)
{
    const motion_item *x = &f->m->items[frame];
    double before = GSL_NAN;
    size_t i;

    line_put(l, "[%lu", (unsigned long)number_of(f, x->first));
    if (is_body(f, frame)) {
        for (i = 0; i < f->m->n_steps; i++) {
            f->numbers[i] = unwound(motion_angle(f->m, frame, i), before, 2 * M_PI);
            before = gsl_isnan(f->numbers[i]) ? before : f->numbers[i];
        }
        line_put(l, ",-1,");
        series_put_or_one(l, f->numbers, f->m->n_steps, PER_RADIAN, 0.5 / PER_RADIAN);
    } else if (x->n > 1) {
        line_put(l, ",%lu", (unsigned long)number_of(f, x->first + 1));
        line_put(l, x->like.size > 0 ? ",1" : "");
    }
    line_put(l, "]");
}

static void put_place(line *l, places *f, size_t number)
{
    const seen *x = &f->tracks[number];
    size_t i;
    int k;

    line_put(l, "[%lu", (unsigned long)number_of_frame(f, x->frame));
    for (k = 0; k < 2; k++) {
        for (i = 0; i < f->m->n_steps; i++)
            f->numbers[i] = k ? x->at[i].y : x->at[i].x;
        line_put(l, ",");
        series_put_or_one(l, f->numbers, f->m->n_steps, PER_PIXEL, NEAR);
    }
    line_put(l, "]");
}

static void put_places_and_frames(line *l, places *f)
{
    size_t k;

    line_put(l, "\"frames\":[");
    for (k = 0; k < f->n_frames; k++) {
        line_put(l, k ? ",\n" : "\n");
        put_frame(l, f, f->frames[k]);
    }
    line_put(l, "],\n\"places\":[");
    for (k = 0; k < f->n; k++) {
        line_put(l, k ? ",\n" : "\n");
        put_place(l, f, f->list[k]);
    }
    line_put(l, "],\n");
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

/* What an item shows at a step: a number with so many decimals, 0 if it is none, and what stands behind
** it, its exponent and unit. */
typedef struct shown {
    int is_there, is_number, decimals;
    double x;
    char end[DISPLAY_WORDS];
} shown;

static void take_value(const motion *m, size_t item, size_t step, shown *v)
{
    const motion_value *at = motion_value_at(m, item, step);
    const char *words = display_words(&m->kept, at->value);
    text rest = flk_text_of(words);
    size_t point = strcspn(words, "."), n = strcspn(words, "e");

    v->is_there = motion_has(m, item, step);
    v->x = GSL_NAN;
    v->decimals = 0;
    v->end[0] = '\0';
    if (!v->is_there)
        return;
    rest.length = n;
    v->is_number = flk_number_read(&rest, &v->x) == NUMBER_OK && rest.length == 0 &&
                   !(v->x == 0 && *words == '-');
    v->decimals = v->is_number && point < n ? (int)(n - point) - 1 : 0;
    flk_text_join(v->end, sizeof v->end, v->is_number ? words + n : words,
                  display_words(&m->kept, at->unit), (char *)NULL);
}

#define LARGEST 2e5 /* in units of the last decimal: 5 digits, and some more */

/* Take values of steps behind each other that one number of decimals and one end serve; returns their
** number, and what they have in common in `all`. */
static size_t take_values(const places *f, size_t item, size_t from, shown *all)
{
    double most = 0, size;
    shown next;
    size_t n;

    take_value(f->m, item, from, all);
    for (n = 0; from + n < f->m->n_steps; n++) {
        take_value(f->m, item, from + n, &next);
        f->numbers[n] = next.x;
        if (!next.is_there)
            continue;
        if (!all->is_there)
            *all = next;
        size = next.is_number ? GSL_MAX_DBL(most, fabs(next.x)) : 0;
        next.decimals = GSL_MAX(next.decimals, all->decimals);
        if (next.is_number != all->is_number || strcmp(next.end, all->end) != 0 ||
            (n && size * gsl_pow_int(10, next.decimals) >= LARGEST))
            break;
        most = size;
        all->decimals = next.decimals;
    }
    return n;
}

/* Write the values of an item by step. */
static void put_values(line *l, const places *f, size_t item)
{
    size_t from, n;
    shown all;

    line_put(l, "[");
    for (from = 0; from < f->m->n_steps; from += n) {
        n = take_values(f, item, from, &all);
        line_put(l, from ? "," : "");
        if (all.is_there && !all.is_number) {
            line_put(l, "-%lu,\"\",", (unsigned long)n);
        } else {
            line_put(l, "%lu,", (unsigned long)all.decimals);
            series_put(l, f->numbers, n, gsl_pow_int(10, all.decimals));
            line_put(l, ",");
        }
        put_words(l, all.end);
    }
    line_put(l, "]");
}

/* Write the words of an item, or of one whose value changes, the words before it. */
static void put_all_words(line *l, const places *f, size_t item)
{
    const motion *m = f->m;
    const motion_item *x = &m->items[item];
    char all[DISPLAY_WORDS];
    int varies = x->varies || x->unit_varies;

    line_put(l, "\"words\":");
    put_words(l, varies ? display_words(&m->kept, x->like.words)
                        : display_text_of(&m->kept, &x->like, all));
    if (varies) {
        line_put(l, ",\"values\":");
        put_values(l, f, item);
    }
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

/* 1 for a line that stays in its frame: it is a part of a path. */
static int is_still(const places *f, const motion_item *x)
{
    const seen *at = &f->tracks[x->first];

    return x->like.sort == DISPLAY_LINE && at[0].stays && at[1].stays && at[0].frame == at[1].frame;
}

/* 1 if two items are there at the same steps. */
static int are_together(const motion *m, size_t item, size_t other)
{
    size_t i = 0;

    while (i < m->n_steps && motion_has(m, item, i) == motion_has(m, other, i))
        i++;
    return i == m->n_steps;
}

static void put_point(line *l, char before, fourlink_vector at, double parts)
{
    line_byte(l, before);
    series_put_rounded(l, at.x, parts);
    line_byte(l, ',');
    series_put_rounded(l, at.y, parts);
}

static void put_curve(line *l, const motion *m, const motion_item *x)
{
    const fourlink_vector *at = m->curves + x->first;
    size_t from, n, i;

    for (from = 0; from < x->n; from += n + 1) {
        for (n = 0; from + n < x->n && !gsl_isnan(at[from + n].x); n++)
            ;
        for (i = 0; i < n; i = display_next_bend(at + from, i, n))
            put_point(l, i ? 'L' : 'M', at[from + i], 100);
    }
}

/* Write a curve, or lines that stay in one frame as one path, as far as they follow each other with one
** look; returns the last of them. */
static size_t put_path(line *l, places *f, size_t item)
{
    const motion_item *x = &f->m->items[item], *y = x;
    size_t frame = f->m->n_items, last = item, i;
    int is_way;

    if (x->like.sort != DISPLAY_CURVE)
        frame = f->tracks[x->first].frame;
    is_way = frame < f->m->n_items && f->m->items[frame].like.size > 0;
    line_put(l, ",\"d\":\"");
    if (x->like.sort == DISPLAY_CURVE)
        put_curve(l, f->m, x);
    for (; x->like.sort != DISPLAY_CURVE && item < f->m->n_items; item++) {
        y = &f->m->items[item];
        if (y->like.layer != x->like.layer || y->like.sort == DISPLAY_FRAME)
            continue;
        if (y->like.pen != x->like.pen || !is_still(f, y) || y->like.name != x->like.name ||
            f->tracks[y->first].frame != frame || !are_together(f->m, last, item))
            break;
        last = item;
        for (i = 0; i < y->n; i++)
            put_point(l, i ? 'L' : 'M', f->tracks[y->first + i].first, is_way ? 1 / CLOSE : 1000);
    }
    line_put(l, "\"");
    if (frame < f->m->n_items)
        line_put(l, ",\"in\":%lu", (unsigned long)number_of_frame(f, frame));
    return last;
}

static void put_places(line *l, places *f, const motion_item *x)
{
    size_t i;

    line_put(l, ",\"at\":[");
    for (i = 0; i < x->n; i++) {
        line_put(l, i ? "," : "");
        line_put(l, "%lu", (unsigned long)number_of(f, x->first + i));
    }
    line_put(l, "]");
}

static void put_size(line *l, double size)
{
    if (size > 0) {
        line_put(l, ",\"size\":");
        put_pixels(l, size);
    }
}

/* Write an item; returns the last one that has been written. */
static size_t put_item(line *l, places *f, size_t item)
{
    static const char *const sorts[] = {"line", "arrow", "arc",    "path", "path",
                                        "path", "disc",  "centre", "disc", "text"};
    const motion_item *x = &f->m->items[item];
    int is_path = x->like.sort == DISPLAY_CURVE || is_still(f, x);
    char class_name[30];

    interactive_put(l, "{\"as\":%q,\"look\":%q",
                    is_path              ? "path"
                    : motion_is_label(x) ? "label"
                                         : sorts[x->like.sort],
                    svg_class(&x->like, class_name));
    if (x->like.name)
        interactive_put(l, ",\"name\":%q", display_words(&f->m->kept, x->like.name));
    if (is_path) {
        put_gone(l, f->m, item);
        item = put_path(l, f, item);
        line_put(l, "}");
        return item;
    }
    put_places(l, f, x);
    if (x->like.sort == DISPLAY_ARC) {
        line_put(l, ",\"radius\":[");
        put_pixels(l, x->like.radius[0]);
        line_put(l, ",");
        put_pixels(l, x->like.radius[1]);
        line_put(l, "]");
    } else if (x->like.sort == DISPLAY_TEXT) {
        put_size(l, x->like.size);
        line_put(l, ",");
        if (x->like.align != DISPLAY_MIDDLE)
            line_put(l, "\"anchor\":\"%s\",", x->like.align == DISPLAY_LEFT ? "start" : "end");
        put_all_words(l, f, item);
    } else {
        put_size(l, x->like.size);
    }
    put_gone(l, f->m, item);
    line_put(l, "}");
    return item;
}

static void put_items(line *l, places *f)
{
    size_t i;
    int layer, n = 0;

    line_put(l, "\"items\":[");
    for (layer = 0; layer < DISPLAY_LAYERS; layer++)
        for (i = 0; i < f->m->n_items; i++)
            if (f->m->items[i].like.layer == layer && f->m->items[i].like.part != DISPLAY_KEY &&
                f->m->items[i].like.part != DISPLAY_NOTE &&
                f->m->items[i].like.sort != DISPLAY_FRAME) {
                interactive_put_comma(l, &n);
                i = put_item(l, f, i);
            }
    line_put(l, "],\n");
}

/* The key: a look and its words.  A sample stands before its words. */
static void put_key(line *l, places *f)
{
    const motion *m = f->m;
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
        put_all_words(l, f, i);
        line_put(l, "}");
    }
    line_put(l, "],\n");
}

static void put_notes(line *l, places *f)
{
    const motion *m = f->m;
    size_t i;
    int n = 0;

    line_put(l, "\"notes\":[");
    for (i = 0; i < m->n_items; i++)
        if (m->items[i].like.part == DISPLAY_NOTE) {
            interactive_put_comma(l, &n);
            line_put(l, "{");
            put_all_words(l, f, i);
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
    places f;

    places_open(&f, &p->list);
    if (!memory_has_failed()) {
        interactive_put(l, "{\"title\":%q,\"size\":%q,", p->title, sizes[p->size]);
        put_box(l, "sheet", 0, 0, p->width, p->height);
        put_box(l, "box", box->x_min, box->y_min, box->x_max - box->x_min, box->y_max - box->y_min);
        put_box(l, "axes", axes->x_min, axes->x_max, axes->y_min, axes->y_max);
        line_put(l, "\n");
        put_items(l, &f);
        put_places_and_frames(l, &f);
        put_key(l, &f);
        put_notes(l, &f);
        line_put(l, "}");
    }
    places_close(&f);
    return !memory_has_failed();
}
