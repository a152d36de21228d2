/* SPDX-License-Identifier: GPL-3.0-or-later
**
** corners.c - the crank angles at which columns are not smooth: switches of the machine, dead positions,
** change points.
**
** Levels of the crank angle are known.  Other variables are smooth in theta2 on each branch: they are sampled
** twice per degree, and base/solve finds where they cross a level between two samples.  Only for variables
** that are speeds does this place depend on the speed.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>

#include "base/solve.h"
#include "corners.h"
#include "mechanics/kind.h"

#define SAMPLES 720 /* of a turn */
#define PASSES 8    /* of a level in a turn, at most, are kept */

/* Ends closer than this, in rad, count as one. */
#define CLOSEST 1e-9

static int index_of(fourlink_branch branch)
{
    return branch == FOURLINK_OPEN ? 0 : 1;
}

static int is_over_theta2(const flk_switch *s)
{
    return !s->joint && s->of == FLK_THETA2;
}

/* 1 if the crank has a single, given speed. */
static int has_one_speed(const deck *d)
{
    return d->drive.mode == DRIVE_GIVEN && d->motion.acceleration == 0;
}

/* 1 if the levels of a switch are crossed at the same angles in every period. */
static int is_periodic(const deck *d, const flk_switch *s)
{
    return flk_switch_is_of_position(s) || has_one_speed(d);
}

/* ------------------------------------------------------------------------------------ crossings of levels */

/* A variable minus a level, as a function of theta2. */
typedef struct sought {
    const flk_corners *corners;
    const flk_passage *passage; /* null: at the given speed */
    const flk_switch *s;
    fourlink_branch branch;
    double level;
} sought;

static int move(const flk_corners *c, fourlink_branch branch, double theta2, double speed,
                fourlink_state *state)
{
    fourlink_crank crank = {0, 0, 0};

    crank.theta2 = theta2;
    crank.omega2 = speed;
    return fourlink_analyse_dyad(&c->d->machine.mechanism, branch, &crank, NULL, 0, state, NULL) ==
           FOURLINK_OK;
}

/* The speed used for a motion that gives none. */
static double given_speed(const deck *d)
{
    return has_one_speed(d) && d->motion.speed != 0 ? d->motion.speed : 1;
}

static double value_at(double theta2, void *data)
{
    const sought *x = data;
    const flk_passage *p = x->passage;
    double speed =
        p ? p->speed(p->host, p->sense * (theta2 - p->from)) : given_speed(x->corners->d);
    fourlink_state state;
    double value;

    if (gsl_isnan(speed) || !move(x->corners, x->branch, theta2, speed, &state))
        return GSL_NAN;
    value = flk_switch_value(&x->corners->d->machine, x->s, &state) - x->level;
    return x->s->period > 0 ? value - x->s->period * floor(value / x->s->period + 0.5) : value;
}

/* The crank angle between `from` and `to` at which the variable, which goes from `last` to `now`, crosses a
** level. */
static double find_pass(sought *x, double from, double to, double last, double now, double number)
{
    flk_bracket b;

    x->level = flk_switch_level(x->s, number);
    b = from < to ? flk_bracket_of(from, to, last - x->level, now - x->level)
                  : flk_bracket_of(to, from, now - x->level, last - x->level);
    return flk_find_zero(value_at, x, &b, 0);
}

/* The value within half a period of `near`. */
static double nearest(const flk_switch *s, double value, double near)
{
    return s->period > 0 ? value - s->period * floor((value - near) / s->period + 0.5) : value;
}

/* Store where the levels of switch j are crossed between two crank angles. */
static void keep(flk_corners *c, fourlink_branch branch, size_t j, double from, double to,
                 double last, double now)
{
    double *kept = c->theta2[index_of(branch)], number;
    size_t *n = &c->n[index_of(branch)], passes;
    sought x;
    int step;

    x.corners = c;
    x.passage = NULL;
    x.s = &c->switches[j];
    x.branch = branch;
    now = nearest(x.s, now, last);
    for (passes = flk_switch_passes(x.s, last, now, &number, &step); passes > 0 && *n < c->most;
         passes--, number += step)
        kept[(*n)++] = find_pass(&x, from, to, last, now, number);
}

/* Find where a branch crosses levels, at all speeds or at the given one. */
static void find(flk_corners *c, fourlink_branch branch)
{
    const flk_machine *machine = &c->d->machine;
    size_t n = (size_t)floor(SAMPLES * c->period / (2 * M_PI) + 0.5), i, j;
    double step = c->period / (double)n, speed = given_speed(c->d), now;
    int is_there, was_there = 0;
    fourlink_state state;

    for (i = 0; i <= n && c->n_switches > c->n_over_theta2; i++) {
        double theta2 = step * ((double)i - 0.37);

        is_there = move(c, branch, theta2, speed, &state);
        for (j = c->n_over_theta2; j < c->n_switches && is_there; j++) {
            if (!is_periodic(c->d, &c->switches[j]))
                continue;
            now = flk_switch_value(machine, &c->switches[j], &state);
            if (was_there)
                keep(c, branch, j, theta2 - step, theta2, c->work[j], now);
            c->work[j] = now;
        }
        was_there = is_there;
    }
    gsl_sort(c->theta2[index_of(branch)], 1, c->n[index_of(branch)]);
    c->is_known[index_of(branch)] = 1;
}

/* ----------------------------------------------------------------------------------------------- the next */

typedef struct search {
    const flk_passage *p;
    double after; /* rad passed: the next end after this is sought */
    double at;    /* the nearest end so far, and its kind */
    flk_piece_end end;
} search;

static void offer(search *s, double passed, flk_piece_end end)
{
    double closest = CLOSEST + 1e-14 * passed;

    if (passed <= s->after + closest)
        return;
    if (passed < s->at - closest)
        s->at = passed;
    else if (passed > s->at + closest || end < s->end)
        return;
    s->end = end;
}

/* Offer the end at this crank angle and at all angles whole periods away. */
static void offer_angle(search *s, double theta2, double period, flk_piece_end end)
{
    double passed = s->p->sense * (theta2 - s->p->from);

    offer(s, passed + period * ceil((s->after + CLOSEST + 1e-14 * s->after - passed) / period),
          end);
}

/* Of many levels, increasing within a period, only the neighbours can be next. */
static void offer_levels(search *s, const double *level, size_t n, double period)
{
    double here = s->p->from + s->p->sense * s->after;
    size_t low, i, k;

    if (n == 0)
        return;
    here -= period * floor((here - level[0]) / period);
    low = flk_switch_below(level, n, here);
    for (k = 0; k < n; k++) {
        double away;

        i = s->p->sense > 0 ? (low + k) % n : (low + 2 * n - 1 - k) % n;
        offer_angle(s, level[i], period, FLK_END_PLAIN);
        away = s->p->sense * (level[i] - here);
        if (away - period * floor(away / period) > 2 * CLOSEST)
            return;
    }
}

/* The first level of a speed that is crossed before an end, at the speed of the motion. */
static void offer_speed(search *s, const flk_switch *of, double end)
{
    const flk_passage *p = s->p;
    double step = 2 * M_PI / SAMPLES, at = s->after + 2 * CLOSEST, next, last, now, number;
    sought x;
    int sense;

    x.corners = p->corners;
    x.passage = p;
    x.s = of;
    x.branch = p->branch;
    x.level = 0;
    for (last = value_at(p->from + p->sense * at, &x); at < end; at = next, last = now) {
        next = GSL_MIN(at + step, end);
        now = value_at(p->from + p->sense * next, &x);
        if (gsl_isnan(last) || gsl_isnan(now) || !flk_switch_passes(of, last, now, &number, &sense))
            continue;
        at = find_pass(&x, p->from + p->sense * at, p->from + p->sense * next, last, now, number);
        offer(s, p->sense * (at - p->from), FLK_END_PLAIN);
        return;
    }
}

/* Levels of speeds that are crossed before the next end, at the speed of the motion. */
static void offer_speeds(search *s, double end)
{
    const flk_passage *p = s->p;
    const flk_corners *c = p->corners;
    size_t j;

    for (j = c->n_over_theta2; j < c->n_switches && p->speed; j++)
        if (!is_periodic(c->d, &c->switches[j]))
            offer_speed(s, &c->switches[j], GSL_MIN(end, s->at));
}

static void offer_loads(search *s, double end)
{
    flk_corners *c = s->p->corners;
    int i = index_of(s->p->branch);
    size_t j;

    if (!c->is_known[i])
        find(c, s->p->branch);
    for (j = 0; j < c->n_over_theta2; j++)
        offer_levels(s, c->switches[j].level, c->switches[j].n, c->switches[j].period);
    offer_levels(s, c->theta2[i], c->n[i], c->period);
    offer_speeds(s, end);
}

/* Dead positions are the ends of the reachable ranges; change points are where a range could end, at 0 and
** 180 deg or at +-90 deg, and positions where the links come close to one line. */
static void offer_positions(search *s)
{
    const fourlink_mechanism *mechanism = &s->p->corners->d->machine.mechanism;
    double line = fourlink_slides((int)mechanism->design.kind, FOURLINK_FOLLOWER) ? -M_PI_2 : 0;
    fourlink_reach reach;
    int i;

    fourlink_reach_of(mechanism, &reach);
    for (i = 0; i < reach.n_ranges; i++)
        if (reach.to[i] - reach.from[i] < 2 * M_PI * (1 - 1e-15)) {
            offer_angle(s, reach.from[i], 2 * M_PI, FLK_END_DEAD);
            offer_angle(s, reach.to[i], 2 * M_PI, FLK_END_DEAD);
        }
    offer_angle(s, line, 2 * M_PI, mechanism->change_folded ? FLK_END_CHANGE : FLK_END_PLAIN);
    offer_angle(s, line + M_PI, 2 * M_PI,
                mechanism->change_stretched ? FLK_END_CHANGE : FLK_END_PLAIN);
}

double flk_corners_next(const flk_passage *passage, double after, double end, const double *more,
                        size_t n, flk_piece_end *what)
{
    search s;
    size_t i;

    s.p = passage;
    s.after = after;
    s.at = GSL_POSINF;
    s.end = FLK_END_NOWHERE;
    offer_positions(&s);
    for (i = 0; i < n; i++)
        offer(&s, more[i], FLK_END_PLAIN);
    if (passage->has_loads)
        offer_loads(&s, end);
    *what = s.end;
    return s.at;
}

flk_piece_end flk_corners_first(const flk_passage *passage)
{
    search s;

    s.p = passage;
    s.after = -3 * CLOSEST;
    s.at = 2 * CLOSEST;
    s.end = FLK_END_PLAIN;
    offer_positions(&s);
    return s.at > CLOSEST ? FLK_END_PLAIN : s.end;
}

/* ------------------------------------------------------------------------------------------- the switches */

/* Sort switches over the crank angle to the front. */
static size_t sort(flk_switch *list, size_t n)
{
    size_t first = 0, i;

    for (i = 0; i < n; i++)
        if (is_over_theta2(&list[i])) {
            flk_switch s = list[first];

            list[first++] = list[i];
            list[i] = s;
        }
    return first;
}

static size_t count_levels(const flk_switch *list, size_t from, size_t to)
{
    size_t n = 0;

    for (; from < to; from++)
        n += list[from].n;
    return n;
}

flk_corners *flk_corners_open(const deck *d)
{
    flk_corners *c = calloc(1, sizeof *c);
    size_t n = flk_switch_list(&d->machine, NULL), turns;

    if (!c)
        return NULL;
    c->d = d;
    turns = d->machine.mechanism.change_stretched != d->machine.mechanism.change_folded ? 2 : 1;
    c->period = 2 * M_PI * (double)turns;
    c->switches = malloc((n + 1) * sizeof *c->switches);
    if (c->switches) {
        c->n_switches = flk_switch_list(&d->machine, c->switches);
        c->n_over_theta2 = sort(c->switches, n);
        c->most = PASSES * turns * count_levels(c->switches, c->n_over_theta2, n);
    }
    c->work = malloc((2 * c->most + n + 1) * sizeof *c->work);
    c->theta2[0] = c->work + n;
    c->theta2[1] = c->theta2[0] + c->most;
    if (c->switches && c->work)
        return c;
    flk_corners_close(c);
    return NULL;
}

void flk_corners_close(flk_corners *c)
{
    if (c) {
        free(c->switches);
        free(c->work);
    }
    free(c);
}

size_t flk_corners_most(const flk_corners *c, double angle)
{
    size_t n = 8, j; /* positions: dead, in line */

    for (j = 0; j < c->n_over_theta2; j++)
        n += c->switches[j].n * ((size_t)ceil(angle / c->switches[j].period) + 1);
    return n + c->most * ((size_t)ceil(angle / c->period) + 1);
}
