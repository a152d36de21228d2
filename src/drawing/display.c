/* SPDX-License-Identifier: GPL-3.0-or-later
**
** display.c - the display list of a picture: lines, arrows, curves, areas, discs and texts on panels.
*/
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/text.h"
#include "system/memory.h"
#include "display.h"

/* --------------------------------------------------------------------------------------------- looks */

look display_look(int stroke)
{
    static const look grid = {"grid", "DDDDDD", 0.5, "", LOOK_PALE},
                      axis = {"axis", "000000", 1, "", LOOK_ARROW};
    look x;
    int i;

    if (stroke < PEN_COUNT)
        return look_table[stroke];
    if (stroke == PEN_GRID)
        return grid;
    if (stroke == PEN_AXIS)
        return axis;
    if (stroke >= PEN_CURVE) {
        x = look_curves[(stroke >= PEN_JUMP ? stroke - PEN_JUMP : stroke - PEN_CURVE) %
                        LOOK_CURVE_COUNT];
        if (stroke >= PEN_JUMP) {
            x.width = 1;
            x.dashes = "3,3";
        }
        return x;
    }
    i = stroke - PEN_COUNT + 1;
    x = look_curves[i % LOOK_CURVE_COUNT];
    x.width = look_table[PEN_PATH].width;
    x.dashes = look_curves[(i + i / LOOK_CURVE_COUNT) % LOOK_CURVE_COUNT].dashes;
    return x;
}

const char *display_class(int stroke, char out[20])
{
    if (stroke < PEN_COUNT)
        strcpy(out, stroke ? look_table[stroke].name : "");
    else if (stroke == PEN_GRID || stroke == PEN_AXIS)
        strcpy(out, stroke == PEN_GRID ? "grid" : "axis");
    else if (stroke >= PEN_JUMP)
        sprintf(out, "jump%d", stroke - PEN_JUMP + 1);
    else if (stroke >= PEN_CURVE)
        sprintf(out, "curve%d", stroke - PEN_CURVE + 1);
    else
        sprintf(out, "path%d", stroke - PEN_COUNT + 2);
    return out;
}

/* -------------------------------------------------------------------------------------------- memory */

void display_open(display *d)
{
    memset(d, 0, sizeof *d);
    display_keep(d, "");
}

void display_close(display *d)
{
    free(d->panels);
    free(d->items);
    free(d->places);
    free(d->holds);
    free(d->words);
    memset(d, 0, sizeof *d);
}

void display_clear(display *d)
{
    d->n_panels = d->n_items = d->n_places = d->n_words = 0;
    d->key = d->hold = 0;
    display_keep(d, "");
}

/* A list with room for so many entries more; null if memory fails, then it is as it was. */
static void *grow(void *list, size_t *capacity, size_t n, size_t more, size_t size)
{
    size_t most = *capacity;
    void *new = list;

    if (n + more <= most)
        return list;
    while (most < n + more)
        most = 2 * most + 64;
    new = memory_grow(list, most, size);
    if (new)
        *capacity = most;
    return new;
}

size_t display_keep(display *d, const char *words)
{
    size_t length = strlen(words) + 1, at = d->n_words;
    char *list;

    if (!*words && at)
        return 0;
    list = grow(d->words, &d->words_capacity, at, length, 1);
    if (!list)
        return 0;
    d->words = list;
    memcpy(list + at, words, length);
    d->n_words += length;
    return at;
}

const char *display_words(const display *d, size_t offset)
{
    return offset < d->n_words ? d->words + offset : "";
}

const char *display_text_of(const display *d, const display_item *x, char out[DISPLAY_WORDS])
{
    const char *words = display_words(d, x->words);

    return x->value || x->unit
               ? flk_text_join(out, DISPLAY_WORDS, words, display_words(d, x->value),
                               display_words(d, x->unit), (char *)NULL)
               : words;
}

void display_set_value(display *d, display_item *x, const char *value, const char *unit)
{
    x->value = display_keep(d, value);
    x->unit = display_keep(d, unit);
}

display_item *display_add(display *d, display_sort sort, int stroke, int layer)
{
    display_item *list = grow(d->items, &d->items_capacity, d->n_items, 1, sizeof *d->items);
    display_item *x = &d->none;

    if (list) {
        d->items = list;
        x = &list[d->n_items++];
    }
    memset(x, 0, sizeof *x);
    x->sort = sort;
    x->pen = stroke;
    x->layer = layer;
    x->key = d->key;
    x->first = d->n_places;
    return x;
}

/* Add a place to an item whose places are the last ones. */
static void add_place(display *d, display_item *x, fourlink_vector at)
{
    fourlink_vector *list = grow(d->places, &d->places_capacity, d->n_places, 1, sizeof *d->places);
    unsigned long *holds = grow(d->holds, &d->holds_capacity, d->n_places, 1, sizeof *d->holds);

    d->places = list ? list : d->places;
    d->holds = holds ? holds : d->holds;
    if (!list || !holds)
        return;
    holds[d->n_places] = d->hold;
    list[d->n_places++] = at;
    x->n++;
}

void display_add_place(display *d, fourlink_vector at)
{
    add_place(d, memory_has_failed() || !d->n_items ? &d->none : &d->items[d->n_items - 1], at);
}

fourlink_vector display_seen(const display_item *frame, const fourlink_vector now[2],
                             fourlink_vector at)
{
    fourlink_vector axis = place_at(1, 0), seen;
    double length = frame->n > 1 ? place_distance(now[0], now[1]) : 1;

    if (frame->n > 1 && length > 0)
        axis = place_at((now[1].x - now[0].x) / length, (now[1].y - now[0].y) / length);
    seen = place_seen(now[0], axis, at);
    return place_at(frame->size > 0 && length > 0 ? seen.x / length : seen.x, seen.y);
}

display_item *display_line(display *d, int stroke, int layer, fourlink_vector from,
                           fourlink_vector to)
{
    display_item *x = display_add(d, DISPLAY_LINE, stroke, layer);

    display_add_place(d, from);
    display_add_place(d, to);
    return x;
}

display_item *display_arc(display *d, int stroke, fourlink_vector centre, double from, double span)
{
    display_item *x = display_add(d, DISPLAY_ARC, stroke, DISPLAY_LINES);

    x->from = from;
    x->span = span;
    display_add_place(d, centre);
    return x;
}

display_item *display_text(display *d, int stroke, fourlink_vector at, display_align align,
                           const char *words)
{
    size_t kept = display_keep(d, words);
    display_item *x = display_add(d, DISPLAY_TEXT, stroke, DISPLAY_FRONT);

    x->align = align;
    x->words = kept;
    display_add_place(d, at);
    return x;
}

int display_next_piece(const display *d, const display_item *x, size_t *from, size_t *n)
{
    const fourlink_vector *at = d->places + x->first;

    *from += *n;
    while (*from < x->n && gsl_isnan(at[*from].x))
        ++*from;
    for (*n = 0; *from + *n < x->n && !gsl_isnan(at[*from + *n].x); ++*n)
        ;
    return *n > 0;
}

#define STRAIGHT 0.02 /* pixels: so far from a straight line a curve may leave out its points */

/* 1 if all places between two of a piece are close to the line through these. */
static int is_straight(const fourlink_vector *at, size_t from, size_t to)
{
    double dx = at[to].x - at[from].x, dy = at[to].y - at[from].y, length = gsl_hypot(dx, dy);
    size_t i;

    for (i = from + 1; i < to; i++) {
        double x = at[i].x - at[from].x, y = at[i].y - at[from].y, along = x * dx + y * dy;

        if (along < 0 || along > length * length || fabs(x * dy - y * dx) > STRAIGHT * length)
            return 0;
    }
    return 1;
}

#define FARTHEST 40 /* places */

size_t display_next_bend(const fourlink_vector *at, size_t i, size_t n)
{
    size_t next = i + 1;

    while (next + 1 < n && next - i <= FARTHEST && is_straight(at, i, next + 1))
        next++;
    return next;
}

/* -------------------------------------------------------------------------------------------- panels */

void display_begin_panel(display *d)
{
    display_panel *list = grow(d->panels, &d->panels_capacity, d->n_panels, 1, sizeof *d->panels);

    if (!list)
        return;
    d->panels = list;
    memset(&list[d->n_panels], 0, sizeof *list);
    list[d->n_panels++].first = d->n_items;
}

void display_drop_panel(display *d)
{
    if (d->n_panels)
        d->n_items = d->panels[--d->n_panels].first;
}

#define SAME 1e-6 /* pixels */

/* Cut a curve to a box: pieces with gaps between them, behind all other places. */
static void cut_curve(display *d, display_item *x, const place_box *box)
{
    fourlink_vector gap = place_at(GSL_NAN, GSL_NAN), from, to, last = gap;
    size_t first = x->first, n = x->n, k;

    x->first = d->n_places;
    x->n = 0;
    for (k = 0; k + 1 < n; k++) {
        from = d->places[first + k];
        to = d->places[first + k + 1];
        if (gsl_isnan(from.x) || gsl_isnan(to.x) || !place_clip(box, &from, &to))
            continue;
        if (!(place_distance(from, last) < SAME)) {
            if (x->n)
                add_place(d, x, gap);
            add_place(d, x, from);
        }
        add_place(d, x, to);
        last = to;
    }
}

/* Make an area the polygon between its curve, where that is on its side of the level, and the level; pixels
** run downwards. */
static void close_area(display *d, display_item *x, double level)
{
    int is_above = x->sort == DISPLAY_ABOVE;
    size_t first = x->first, n = x->n, k;
    fourlink_vector last = place_at(0, level), at;

    x->first = d->n_places;
    x->n = 0;
    for (k = 0; k < n; k++) {
        at = d->places[first + k];
        if (gsl_isnan(at.x))
            continue;
        if (!x->n)
            add_place(d, x, place_at(at.x, level));
        else if ((at.y - level) * (last.y - level) < 0)
            add_place(
                d, x,
                place_at(last.x + (at.x - last.x) * (level - last.y) / (at.y - last.y), level));
        add_place(d, x,
                  place_at(at.x, is_above ? GSL_MIN_DBL(at.y, level) : GSL_MAX_DBL(at.y, level)));
        last = at;
    }
    if (n)
        add_place(d, x, place_at(last.x, level));
}

/* Make an arc, whose place is in pixels, a polyline. */
static void bend(display *d, display_item *x, double scale)
{
    int n = 8 + (int)(fabs(x->span) / DISPLAY_ARC_STEP), i;

    x->centre = d->places[x->first];
    x->radius[0] *= scale;
    x->radius[1] *= scale;
    d->hold = d->holds[x->first];
    x->first = d->n_places;
    x->n = 0;
    for (i = 0; i <= n; i++) {
        double part = (double)i / n, radius = x->radius[0] + part * (x->radius[1] - x->radius[0]);

        add_place(d, x, place_polar(x->centre, radius, -x->from - part * x->span));
    }
}

/* Turn the places of an item of a panel into pixels. */
static void place_item(display *d, display_item *x, const place_box *box, const place_box *axes)
{
    double width = box->x_max - box->x_min, height = box->y_max - box->y_min;
    double x_scale = width / (axes->x_max - axes->x_min),
           y_scale = height / (axes->y_max - axes->y_min);
    size_t k;

    for (k = 0; k < x->n; k++) {
        fourlink_vector *at = &d->places[x->first + k];

        if (x->in_box)
            *at = place_at(box->x_min + at->x * width, box->y_max - at->y * height);
        else
            *at = place_at(box->x_min + (at->x - axes->x_min) * x_scale,
                           box->y_max - (at->y - axes->y_min) * y_scale);
        at->x += x->dx;
        at->y += x->dy;
    }
    if (x->sort == DISPLAY_DISC || x->sort == DISPLAY_CENTRE || x->sort == DISPLAY_TEXT)
        x->size *= x_scale;
    else if (x->sort == DISPLAY_ARC)
        bend(d, x, x_scale);
    else if (x->sort == DISPLAY_ARROW)
        x->size = (x->size > 0 ? x->size : DISPLAY_HEAD) * width;
    else if (x->sort == DISPLAY_CURVE)
        cut_curve(d, x, box);
    else if ((x->sort == DISPLAY_ABOVE || x->sort == DISPLAY_BELOW) && !x->is_open)
        close_area(d, x, box->y_max - (x->level - axes->y_min) * y_scale);
}

void display_end_panel(display *d, place_box box, place_box axes)
{
    display_panel *p;
    size_t i;

    if (memory_has_failed() || !d->n_panels)
        return;
    p = &d->panels[d->n_panels - 1];
    p->left = box.x_min;
    p->top = box.y_min;
    p->width = box.x_max - box.x_min;
    p->height = box.y_max - box.y_min;
    p->axes = axes;
    p->n = d->n_items - p->first;
    for (i = p->first; i < d->n_items; i++)
        place_item(d, &d->items[i], &box, &axes);
}
