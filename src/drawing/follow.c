/* SPDX-License-Identifier: GPL-3.0-or-later
**
** follow.c - the places of a motion in few numbers.
**
** A pin, and the end of an arrow, have tracks of their own; the corners of a block go with its pin, the
** outline of a link with the line between its pins, a coil with the ends of its spring.  Nobody says so:
** whether a place follows another is found from the tracks.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "system/memory.h"
#include "follow.h"

#define NEAR 0.03     /* pixels: so far from where it would be, a place follows another */
#define SHORTEST 25.0 /* pixels, of a line that gives a direction */
#define STRETCHED 0.5 /* pixels: a line that changes by less has one length */
#define FARTHEST 1.6  /* lengths of a line: beyond, its direction is not exact enough */
#define MOST_LINES 64

/* A line that others may follow: its ends, by their numbers. */
typedef struct guide {
    size_t of[2];
} guide;

typedef struct guides {
    guide list[MOST_LINES];
    int n;
} guides;

static fourlink_vector track_at(const follow *f, size_t track, size_t step)
{
    return f->m->tracks[track * f->m->n_steps + step];
}

static int is_there(fourlink_vector p)
{
    return !gsl_isnan(p.x);
}

/* The track of a place, which it has whatever it follows. */
static fourlink_vector place_of(const follow *f, size_t place, size_t step)
{
    return track_at(f, f->list[place].track, step);
}

fourlink_vector follow_at(const follow *f, size_t place, size_t step)
{
    const follow_place *x = &f->list[place];
    fourlink_vector p, q, axis;
    double length;

    if (x->sort == FOLLOW_FIXED)
        return place_at(x->by[0], x->by[1]);
    if (x->sort == FOLLOW_OWN)
        return place_of(f, place, step);
    p = follow_at(f, x->of[0], step);
    if (x->sort == FOLLOW_BESIDE)
        return place_beside(p, x->by[0], x->by[1]);
    q = follow_at(f, x->of[1], step);
    length = place_distance(p, q);
    axis = place_at((q.x - p.x) / length, (q.y - p.y) / length);
    return place_in(p, axis, x->by[0] * length + x->by[1], x->by[2]);
}

/* 1 if a track is at all its steps where a place would be. */
static int fits(const follow *f, size_t place, size_t track)
{
    size_t i;

    for (i = 0; i < f->m->n_steps; i++) {
        fourlink_vector at = track_at(f, track, i);

        if (is_there(at) && !(place_distance(at, follow_at(f, place, i)) < NEAR))
            return 0;
    }
    return 1;
}

/* The first step at which a track is there; the number of steps if there is none. */
static size_t first_step(const follow *f, size_t track)
{
    size_t i;

    for (i = 0; i < f->m->n_steps && !is_there(track_at(f, track, i)); i++)
        ;
    return i;
}

/* Coordinates of a track at a step in the line from p to q: along it, to its left, and the line's length. */
static void find_in_line(const follow *f, const guide *g, size_t track, size_t step, double *along,
                         double *left, double *length)
{
    fourlink_vector p = follow_at(f, g->of[0], step), q = follow_at(f, g->of[1], step);
    fourlink_vector at = track_at(f, track, step);
    double dx = at.x - p.x, dy = at.y - p.y;

    *length = place_distance(p, q);
    *along = (dx * (q.x - p.x) + dy * (q.y - p.y)) / *length;
    *left = (dy * (q.x - p.x) - dx * (q.y - p.y)) / *length;
}

/* Try whether the last place goes with a line:  along = a length + e,  left = c.  The step at which the
** line's length differs most from that of the first gives a and e. */
static int goes_with(follow *f, const guide *g)
{
    follow_place *x = &f->list[f->n];
    size_t first = first_step(f, x->track), far = first, i;
    double along, left, length, s, t, u, most = 0;

    find_in_line(f, g, x->track, first, &along, &left, &length);
    for (i = first + 1; i < f->m->n_steps; i++) {
        if (!is_there(track_at(f, x->track, i)))
            continue;
        find_in_line(f, g, x->track, i, &s, &t, &u);
        if (!(fabs(t - left) < NEAR) || !(gsl_hypot(s, t) < FARTHEST * u))
            return 0;
        if (fabs(u - length) > most) {
            most = fabs(u - length);
            far = i;
        }
    }
    x->by[0] = 0;
    if (most > STRETCHED) {
        find_in_line(f, g, x->track, far, &s, &t, &u);
        x->by[0] = (s - along) / (u - length);
    }
    x->sort = FOLLOW_ALONG;
    x->of[0] = g->of[0];
    x->of[1] = g->of[1];
    x->by[1] = along - x->by[0] * length;
    x->by[2] = left;
    return fits(f, f->n, x->track);
}

/* Try whether it goes with another place that has a track of its own. */
static int is_beside(follow *f, size_t other)
{
    follow_place *x = &f->list[f->n];
    size_t first = first_step(f, x->track);
    fourlink_vector at = track_at(f, x->track, first), from = place_of(f, other, first);

    x->sort = FOLLOW_BESIDE;
    x->of[0] = other;
    x->by[0] = at.x - from.x;
    x->by[1] = at.y - from.y;
    return f->list[other].sort == FOLLOW_OWN && fits(f, f->n, x->track);
}

/* Find what a new place follows; of numbers that are no places (`is_place` 0), whether they are fixed. */
static void find_sort(follow *f, const guides *lines, int is_place)
{
    follow_place *x = &f->list[f->n];
    fourlink_vector at = track_at(f, x->track, first_step(f, x->track));
    size_t k;
    int i;

    x->sort = FOLLOW_FIXED;
    x->by[0] = at.x;
    x->by[1] = at.y;
    if (fits(f, f->n, x->track))
        return;
    for (k = 0; k < f->n && is_place; k++)
        if (is_beside(f, k))
            return;
    for (i = 0; i < lines->n && is_place; i++)
        if (goes_with(f, &lines->list[i]))
            return;
    x->sort = FOLLOW_OWN;
}

static size_t number_of(follow *f, const guides *lines, size_t track, int is_place)
{
    size_t k;

    for (k = 0; k < f->n; k++)
        if (fits(f, k, track))
            return k;
    f->list[f->n].track = track;
    find_sort(f, lines, is_place);
    return f->n++;
}

/* Keep a line for others to follow, unless it stands still or becomes too short. */
static void keep_line(const follow *f, guides *lines, size_t p, size_t q)
{
    guide *new = &lines->list[lines->n];
    size_t i;

    if (lines->n == MOST_LINES ||
        (f->list[p].sort == FOLLOW_FIXED && f->list[q].sort == FOLLOW_FIXED))
        return;
    for (i = 0; i < f->m->n_steps; i++)
        if (is_there(track_at(f, f->list[p].track, i)) &&
            !(place_distance(follow_at(f, p, i), follow_at(f, q, i)) > SHORTEST))
            return;
    new->of[0] = p;
    new->of[1] = q;
    lines->n++;
}

/* Discs first, which are pins; then straight lines; then all that may follow them. */
static int round_of(const display_item *x, size_t n)
{
    return x->sort == DISPLAY_DISC                                           ? 0
           : (x->sort == DISPLAY_LINE || x->sort == DISPLAY_ARROW) && n == 2 ? 1
                                                                             : 2;
}

void follow_open(follow *f, const motion *m)
{
    guides lines;
    size_t i, k;
    int round;

    memset(f, 0, sizeof *f);
    lines.n = 0;
    f->m = m;
    f->list = memory_get(m->n_tracks + 1, sizeof *f->list);
    f->number = memory_get(m->n_tracks + 1, sizeof *f->number);
    for (round = 0; round < 3 && f->list && f->number; round++)
        for (i = 0; i < m->n_items; i++) {
            const motion_item *x = &m->items[i];

            if (x->like.sort == DISPLAY_CURVE || x->like.part == DISPLAY_KEY ||
                x->like.part == DISPLAY_NOTE || round_of(&x->like, x->n) != round)
                continue;
            for (k = 0; k < x->n; k++)
                f->number[x->first + k] =
                    number_of(f, &lines, x->first + k,
                              k == 0 || motion_is_label(x) ||
                                  (x->like.sort != DISPLAY_TEXT && x->like.sort != DISPLAY_ARC));
            if (round == 1)
                keep_line(f, &lines, f->number[x->first], f->number[x->first + 1]);
        }
}

void follow_close(follow *f)
{
    free(f->list);
    free(f->number);
}
