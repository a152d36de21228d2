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
    free(m->holds);
    free(m->curves);
    free(m->values);
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

#define SAME 0.01 /* pixels: radii */

static int is_same(const display_item *x, const display_item *y)
{
    return x->key == y->key && x->part == y->part && x->sort == y->sort && x->pen == y->pen &&
           x->layer == y->layer && x->is_open == y->is_open && fabs(x->size - y->size) < SAME &&
           fabs(x->radius[0] - y->radius[0]) < SAME && fabs(x->radius[1] - y->radius[1]) < SAME &&
           x->align == y->align && x->is_boxed == y->is_boxed && x->is_upright == y->is_upright &&
           (x->n == y->n || x->sort == DISPLAY_ARC || x->sort == DISPLAY_CURVE);
}

motion_value *motion_value_at(const motion *m, size_t item, size_t step)
{
    return &m->values[m->items[item].row * m->n_steps + step];
}

int motion_has(const motion *m, size_t item, size_t step)
{
    return motion_value_at(m, item, step)->value != MOTION_NONE;
}

/* The item that an item of a step continues, one that does not yet have this step: the first behind the
** last one found, or the first of all; the number of items if it is new. */
static size_t find(const motion *m, size_t from, size_t step, const display_item *x)
{
    size_t k, i;

    for (k = 0; k < m->n_items; k++) {
        i = (from + k) % m->n_items;
        if (!motion_has(m, i, step) && is_same(&m->items[i].like, x))
            return i;
    }
    return m->n_items;
}

int motion_is_label(const motion_item *x)
{
    return x->like.sort == DISPLAY_TEXT && x->like.n == 2;
}

/* ------------------------------------------------------------------------------------------------ new */

/* Of an item that is no curve. */
static size_t tracks_of(const display_item *x)
{
    return x->sort == DISPLAY_ARC || x->sort == DISPLAY_TEXT ? 2 : x->n;
}

static int reserve_tracks(motion *m, size_t n, const display *d, const display_item *x)
{
    size_t from = m->n_tracks * m->n_steps, to = from + n * m->n_steps;
    fourlink_vector *list = grow(m->tracks, &m->tracks_capacity, to, sizeof *m->tracks);
    unsigned long *holds = grow(m->holds, &m->holds_capacity, m->n_tracks + n, sizeof *m->holds);
    size_t i;

    m->tracks = list ? list : m->tracks;
    m->holds = holds ? holds : m->holds;
    if (!list || !holds)
        return 0;
    for (i = 0; i < n; i++)
        holds[m->n_tracks + i] = i < x->n ? d->holds[x->first + i] : 0;
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
    motion_value *values =
        grow(m->values, &m->values_capacity, (m->n_items + 1) * m->n_steps, sizeof *m->values);
    int is_curve = x->sort == DISPLAY_CURVE;
    motion_item new;
    size_t i;

    m->items = items ? items : m->items;
    m->values = values ? values : m->values;
    new.like = *x;
    new.like.words = display_keep(&m->kept, display_words(d, x->words));
    new.like.value = display_keep(&m->kept, display_words(d, x->value));
    new.like.unit = display_keep(&m->kept, display_words(d, x->unit));
    new.like.name = display_keep(&m->kept, display_words(d, x->name));
    new.first = is_curve ? m->n_curves : m->n_tracks;
    new.n = is_curve ? x->n : tracks_of(x);
    new.varies = new.unit_varies = 0;
    if (!items || !values || memory_has_failed() ||
        !(is_curve ? keep_curve(m, d, x) : reserve_tracks(m, new.n, d, x)))
        return 0;
    memmove(items + at + 1, items + at, (m->n_items - at) * sizeof *items);
    new.row = m->n_items++;
    items[at] = new;
    for (i = 0; i < m->n_steps; i++)
        motion_value_at(m, at, i)->value = motion_value_at(m, at, i)->unit =
            is_curve ? 0 : MOTION_NONE;
    return 1;
}

/* ---------------------------------------------------------------------------------------------- frames */

size_t motion_frame_of(const motion *m, size_t track)
{
    size_t i;

    for (i = 0; i < m->n_items && m->holds[track]; i++)
        if (m->items[i].like.sort == DISPLAY_FRAME && m->items[i].like.key == m->holds[track])
            return i;
    return m->n_items;
}

fourlink_vector motion_seen(const motion *m, size_t frame, size_t track, size_t step)
{
    const motion_item *x = &m->items[frame];
    fourlink_vector now[2];

    if (frame == m->n_items)
        return m->tracks[track * m->n_steps + step];
    now[0] = m->tracks[x->first * m->n_steps + step];
    now[1] = m->tracks[(x->first + x->n - 1) * m->n_steps + step];
    return display_seen(&x->like, now, m->tracks[track * m->n_steps + step]);
}

double motion_angle(const motion *m, size_t frame, size_t step)
{
    const motion_item *x = &m->items[frame];
    fourlink_vector from, to;

    if (frame == m->n_items || x->n < 2)
        return 0;
    from = m->tracks[x->first * m->n_steps + step];
    to = m->tracks[(x->first + 1) * m->n_steps + step];
    return atan2(to.y - from.y, to.x - from.x);
}

/* ----------------------------------------------------------------------------------------------- steps */

static void put_places(motion *m, const motion_item *to, size_t step, const display *d,
                       const display_item *x)
{
    fourlink_vector *track = m->tracks + to->first * m->n_steps + step;
    const fourlink_vector *at = d->places + x->first;
    size_t i;

    for (i = 0; i < x->n && i < to->n; i++)
        if (m->holds[to->first + i] != d->holds[x->first + i])
            m->holds[to->first + i] = 0; /* it changes from one to another */
    if (x->sort == DISPLAY_ARC) {
        track[0] = x->centre;
        track[m->n_steps] = place_at(100 * x->from, 100 * x->span);
    } else if (x->sort == DISPLAY_TEXT && !motion_is_label(to)) {
        track[0] = place_beside(*at, -x->dx, -x->dy);
        track[m->n_steps] = place_at(x->dx, x->dy);
    } else {
        for (i = 0; i < x->n; i++)
            track[i * m->n_steps] = at[i];
    }
}

/* Keep a text of a step, which may be the one that the item had before. */
static size_t keep(motion *m, size_t before, const display *d, size_t words)
{
    const char *now = display_words(d, words);

    return strcmp(now, display_words(&m->kept, before)) == 0 ? before : display_keep(&m->kept, now);
}

static void put_value(motion *m, motion_item *to, size_t step, const display *d,
                      const display_item *x)
{
    motion_value *all = &m->values[to->row * m->n_steps], *new = &all[step];
    int has_last = step > 0 && all[step - 1].value != MOTION_NONE;

    new->value = keep(m, has_last ? all[step - 1].value : to->like.value, d, x->value);
    new->unit = keep(m, to->like.unit, d, x->unit);
    to->varies |= new->value != to->like.value;
    to->unit_varies |= new->unit != to->like.unit;
}

void motion_add(motion *m, size_t step, const display *d)
{
    size_t from = 0, i, at;

    for (i = 0; i < d->n_items && !memory_has_failed(); i++) {
        const display_item *x = &d->items[i];

        at = find(m, from, step, x);
        if (at == m->n_items) {
            at = from;
            if (!insert(m, at, d, x))
                return;
        }
        if (x->sort != DISPLAY_CURVE) {
            put_value(m, &m->items[at], step, d, x);
            put_places(m, &m->items[at], step, d, x);
        }
        from = at + 1;
    }
}
