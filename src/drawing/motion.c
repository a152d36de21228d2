/* SPDX-License-Identifier: GPL-3.0-or-later
**
** motion.c - display lists of many steps as one.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "system/memory.h"
#include "motion.h"

void motion_open(motion *m, size_t n_steps)
{
    memset(m, 0, sizeof *m);
    m->n_steps = n_steps;
    display_open(&m->kept);
}

void motion_close(motion *m)
{
    free(m->items);
    free(m->tracks);
    free(m->curves);
    free(m->words);
    display_close(&m->kept);
    memset(m, 0, sizeof *m);
}

/* A list with room for n entries, which may be none; null if out of memory, then it is as it was. */
static void *grow(void *list, size_t *capacity, size_t n, size_t size)
{
    size_t most = *capacity;
    void *new;

    if (list && n <= most)
        return list;
    do
        most = 2 * most + 64;
    while (most < n);
    new = memory_grow(list, most, size);
    if (new)
        *capacity = most;
    return new;
}

/* ----------------------------------------------------------------------------------------- the same */

#define EQUALS " = "

const char *motion_value(const char *words)
{
    const char *equals = strstr(words, EQUALS);

    return equals ? equals + strlen(EQUALS) : words;
}

/* 1 if two texts have the same words but for their values. */
static int has_same_name(const char *x, const char *y)
{
    size_t n = (size_t)(motion_value(x) - x);

    return n == (size_t)(motion_value(y) - y) && strncmp(x, y, n) == 0;
}

/* 1 if the words of an item may differ from step to step. */
static int is_note(const display_item *x)
{
    return x->sort == DISPLAY_TEXT && (x->part == DISPLAY_NOTE || x->part == DISPLAY_SCALE);
}

#define SAME 0.01 /* pixels: radii */

static int is_equal(const char *x, const char *y)
{
    return strcmp(x, y) == 0;
}

static int is_same(const motion *m, const display_item *x, const display *d, const display_item *y)
{
    return x->sort == y->sort && x->pen == y->pen && x->layer == y->layer &&
           x->is_open == y->is_open && fabs(x->size - y->size) < SAME &&
           fabs(x->radius[0] - y->radius[0]) < SAME && fabs(x->radius[1] - y->radius[1]) < SAME &&
           x->align == y->align && x->is_boxed == y->is_boxed && x->is_upright == y->is_upright &&
           (x->n == y->n || x->sort == DISPLAY_ARC || x->sort == DISPLAY_CURVE) &&
           strcmp(display_words(&m->kept, x->name), display_words(d, y->name)) == 0 &&
           (is_note(y) ? has_same_name : is_equal)(display_words(&m->kept, x->words),
                                                   display_words(d, y->words));
}

static size_t *words_at(const motion *m, size_t item, size_t step)
{
    return &m->words[m->items[item].row * m->n_steps + step];
}

/* The item that an item of a step continues, one that does not yet have this step: the first behind the
** last one found, or the first of all; the number of items if it is new. */
static size_t find(const motion *m, size_t from, size_t step, const display *d,
                   const display_item *x)
{
    size_t k, i;

    for (k = 0; k < m->n_items; k++) {
        i = (from + k) % m->n_items;
        if (*words_at(m, i, step) == MOTION_NONE && is_same(m, &m->items[i].like, d, x))
            return i;
    }
    return m->n_items;
}

/* ------------------------------------------------------------------------------------------------ new */

/* Of an item that is no curve. */
static size_t tracks_of(const display_item *x)
{
    return x->sort == DISPLAY_ARC || x->sort == DISPLAY_TEXT ? 2 : x->n;
}

static int reserve_tracks(motion *m, size_t n)
{
    size_t from = m->n_tracks * m->n_steps, to = from + n * m->n_steps;
    fourlink_vector *list = grow(m->tracks, &m->tracks_capacity, to, sizeof *m->tracks);

    if (!list)
        return 0;
    m->tracks = list;
    for (; from < to; from++)
        list[from] = place_at(GSL_NAN, GSL_NAN);
    m->n_tracks += n;
    return 1;
}

static int keep_curve(motion *m, const display *d, const display_item *x)
{
    fourlink_vector *list =
        grow(m->curves, &m->curves_capacity, m->n_curves + x->n, sizeof *m->curves);

    if (!list)
        return 0;
    m->curves = list;
    memcpy(list + m->n_curves, d->places + x->first, x->n * sizeof *list);
    m->n_curves += x->n;
    return 1;
}

/* Insert an item like that of a step at a place of the order; 0 without memory. */
static int insert(motion *m, size_t at, const display *d, const display_item *x)
{
    motion_item *items = grow(m->items, &m->items_capacity, m->n_items + 1, sizeof *m->items);
    size_t *words =
        grow(m->words, &m->words_capacity, (m->n_items + 1) * m->n_steps, sizeof *m->words);
    int is_curve = x->sort == DISPLAY_CURVE;
    motion_item new;
    size_t i;

    m->items = items ? items : m->items;
    m->words = words ? words : m->words;
    new.like = *x;
    new.like.words = display_keep(&m->kept, display_words(d, x->words));
    new.like.name = display_keep(&m->kept, display_words(d, x->name));
    new.first = is_curve ? m->n_curves : m->n_tracks;
    new.n = is_curve ? x->n : tracks_of(x);
    new.varies = 0;
    if (!items || !words || memory_has_failed() ||
        !(is_curve ? keep_curve(m, d, x) : reserve_tracks(m, new.n)))
        return 0;
    memmove(items + at + 1, items + at, (m->n_items - at) * sizeof *items);
    new.row = m->n_items++;
    items[at] = new;
    for (i = 0; i < m->n_steps; i++)
        *words_at(m, at, i) = is_curve ? new.like.words : MOTION_NONE;
    return 1;
}

/* ----------------------------------------------------------------------------------------------- steps */

static void put_places(motion *m, const motion_item *to, size_t step, const display *d,
                       const display_item *x)
{
    fourlink_vector *track = m->tracks + to->first * m->n_steps + step;
    const fourlink_vector *at = d->places + x->first;
    size_t i;

    if (x->sort == DISPLAY_ARC) {
        track[0] = x->centre;
        track[m->n_steps] = place_at(100 * x->from, 100 * x->span);
    } else if (x->sort == DISPLAY_TEXT) {
        track[0] = place_beside(*at, -x->dx, -x->dy);
        track[m->n_steps] = place_at(x->dx, x->dy);
    } else {
        for (i = 0; i < x->n; i++)
            track[i * m->n_steps] = at[i];
    }
}

void motion_add(motion *m, size_t step, const display *d)
{
    size_t from = 0, i, at;

    for (i = 0; i < d->n_items && !memory_has_failed(); i++) {
        const display_item *x = &d->items[i];
        motion_item *to;

        at = find(m, from, step, d, x);
        if (at == m->n_items) {
            at = from;
            if (!insert(m, at, d, x))
                return;
        }
        to = &m->items[at];
        if (x->sort != DISPLAY_CURVE) {
            int is_new =
                strcmp(display_words(&m->kept, to->like.words), display_words(d, x->words)) != 0;

            to->varies |= is_new;
            *words_at(m, at, step) =
                is_new ? display_keep(&m->kept, display_words(d, x->words)) : to->like.words;
            put_places(m, to, step, d, x);
        }
        from = at + 1;
    }
}

const char *motion_words(const motion *m, size_t item, size_t step)
{
    size_t at = *words_at(m, item, step);

    return at == MOTION_NONE ? NULL : display_words(&m->kept, at);
}
