/* SPDX-License-Identifier: GPL-3.0-or-later
**
** corners.c - the crank angles at which columns are not smooth: switches of the machine, dead positions,
** change points, the ends of a working range.
**
** Levels of the crank angle are known.  Other variables are smooth in theta2 on each branch: they are
** sampled twice per degree, and base/solve finds where they cross a level between two samples.  At which
** angle a speed crosses a level depends on the speed of the crank: unless that has one given speed, such
** levels are sought along the motion itself, from corner to corner.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>

#include "base/cycle.h"
#include "base/solve.h"
#include "corners.h"
#include "deck/found.h"
#include "mechanics/drive.h"
#include "mechanics/kind.h"
#include "mechanics/mechanism.h"

#define SAMPLES 720 /* of a turn */
#define PASSES 8    /* of a level in a turn, at most, are kept */

/* Ends closer than this, in rad, count as one. */
#define CLOSEST 1e-9

/* A crossing that is found this close to a change point, where links turn over, is at it. */
#define AT_CHANGE 1e-7 /* rad */

static int index_of(fourlink_branch branch)
{
    return branch == FOURLINK_OPEN ? 0 : 1;
}

/* 1 if the crank has a single, given speed. */
static int has_one_speed(const deck *d)
{
    return d->mode.kind == MODE_GIVEN && !d->program && !d->prescribed &&
           d->motion.acceleration == 0;
}

/* ---------------------------------------------------------------------------------- crossings of levels */

/* A variable minus a level, as a function of theta2. */
typedef struct sought {
    const flk_corners *corners;
    const flk_switch *s;
    fourlink_branch branch;
    double level;
} sought;

/* The state at an angle, at the given speed or, as only signs count then, at any. */
static int move(const flk_corners *c, fourlink_branch branch, double theta2, fourlink_state *state)
{
    const deck *d = c->d;
    fourlink_crank crank = {0, 1, 0};

    crank.theta2 = theta2;
    if (has_one_speed(d) && d->motion.speed != 0)
        crank.omega2 = d->motion.speed;
    return fourlink_analyse_dyad(&d->machine.mechanism, branch, &crank, NULL, 0, state, NULL) ==
           FOURLINK_OK;
}

static double value_at(double theta2, void *data)
{
    const sought *x = data;
    fourlink_state state;
    double value;

    if (!move(x->corners, x->branch, theta2, &state))
        return GSL_NAN;
    value = flk_switch_value(&x->corners->d->machine, x->s, &state) - x->level;
    return x->s->period > 0 ? flk_cycle_beside(value, x->s->period) : value;
}

/* The value within half a period of `near`. */
static double nearest(const flk_switch *s, double value, double near)
{
    return s->period > 0 ? value - s->period * flk_cycle_nearest(value - near, s->period) : value;
}

/* Store where the levels of switch j are crossed between two crank angles. */
static void keep_level(flk_corners *c, fourlink_branch branch, size_t j, double from, double to,
                       double last, double now)
{
    double *kept = c->theta2[index_of(branch)], number;
    size_t *n = &c->n[index_of(branch)], passes;
    flk_bracket b;
    sought x;
    int step;

    x.corners = c;
    x.s = &c->switches[j];
    x.branch = branch;
    now = nearest(x.s, now, last);
    for (passes = flk_switch_passes(x.s, last, now, &number, &step); passes > 0 && *n < c->most;
         passes--, number += step) {
        x.level = flk_switch_level(x.s, number);
        b = flk_bracket_of(from, to, last - x.level, now - x.level);
        kept[(*n)++] = flk_find_zero(value_at, &x, &b, 0);
    }
}

static int is_at_change(const fourlink_mechanism *mechanism, double theta2)
{
    double line = flk_kind_of(mechanism->design.kind)->folded;

    return (mechanism->change_folded &&
            fabs(flk_cycle_beside(theta2 - line, 2 * M_PI)) < AT_CHANGE) ||
           (mechanism->change_stretched &&
            fabs(flk_cycle_beside(theta2 - line - M_PI, 2 * M_PI)) < AT_CHANGE);
}

/* Leave out crossings at change points, which end pieces themselves. */
static void drop_at_change(flk_corners *c, fourlink_branch branch)
{
    double *list = c->theta2[index_of(branch)];
    size_t *n = &c->n[index_of(branch)], i, kept = 0;

    for (i = 0; i < *n; i++)
        if (!is_at_change(&c->d->machine.mechanism, list[i]))
            list[kept++] = list[i];
    *n = kept;
}

/* Find where a branch crosses levels. */
static void find_crossings(flk_corners *c, fourlink_branch branch)
{
    size_t n = (size_t)floor(SAMPLES * c->period / (2 * M_PI) + 0.5), i, j;
    double step = c->period / (double)n, now;
    int is_there, was_there = 0;
    fourlink_state state;

    for (i = 0; i <= n && c->n_switches > c->n_over_theta2; i++) {
        double theta2 = step * ((double)i - 0.37);

        is_there = move(c, branch, theta2, &state);
        for (j = c->n_over_theta2; j < c->n_switches && is_there; j++) {
            now = flk_switch_value(&c->d->machine, &c->switches[j], &state);
            if (was_there)
                keep_level(c, branch, j, theta2 - step, theta2, c->work[j], now);
            c->work[j] = now;
        }
        was_there = is_there;
    }
    drop_at_change(c, branch);
    gsl_sort(c->theta2[index_of(branch)], 1, c->n[index_of(branch)]);
    c->is_known[index_of(branch)] = 1;
}

/* ---------------------------------------------------------------------- levels of speeds along a motion */

#define STEP (M_PI / 180) /* rad passed */
#define LEAST_STEPS 12

typedef struct along {
    const flk_corners *corners;
    const flk_moving *m;
    const flk_switch *s;
    double level;
} along;

static double value_along(double passed, void *data)
{
    const along *x = data;
    const flk_machine *machine = &x->corners->d->machine;
    fourlink_crank crank;
    fourlink_state state;

    if (!x->m->at(x->m->data, passed, &crank) ||
        flk_mechanism_move(&machine->mechanism, x->m->branch, &crank, 0, &state) != FOURLINK_OK)
        return GSL_NAN;
    return flk_switch_value(machine, x->s, &state) - x->level;
}

/* The first level that the switch crosses between two values, at `from` and `to`, where it crosses it. */
static double first_level(along *x, double from, double to, double last, double now)
{
    double number;
    flk_bracket b;
    int step;

    if (gsl_isnan(last + now) || !flk_switch_passes(x->s, last, now, &number, &step))
        return GSL_POSINF;
    x->level = flk_switch_level(x->s, number);
    b = flk_bracket_of(from, to, last - x->level, now - x->level);
    return flk_find_zero(value_along, x, &b, 0);
}

/* A place just inside an end, in the sense of 1 or -1 from it: at a change point there is a row farther
** inside only. */
static double place_inside(along *x, double end, double to, int sense)
{
    double close = 2 * FLK_CORNERS_CLOSE(to);

    return end + sense * (gsl_isnan(value_along(end + sense * close, x)) ? 2 * AT_CHANGE : close);
}

double flk_corners_of_speed(const flk_corners *c, const flk_moving *m, double from, double to)
{
    double begin, end, first = GSL_POSINF, step, last, now, found;
    size_t n, i, j;
    along x;

    if (c->n_of_speed == 0)
        return first;
    x.corners = c;
    x.m = m;
    x.s = &c->switches[c->n_switches];
    x.level = 0;
    begin = place_inside(&x, from, to, 1);
    end = place_inside(&x, to, to, -1);
    if (!(begin < end))
        return first;
    n = (size_t)GSL_MAX_DBL(LEAST_STEPS, ceil((end - begin) / STEP));
    step = (end - begin) / (double)n;
    for (j = c->n_switches; j < c->n_switches + c->n_of_speed; j++) {
        x.s = &c->switches[j];
        x.level = 0;
        last = value_along(begin, &x);
        for (i = 1; i <= n && begin + (double)(i - 1) * step < first; i++, last = now) {
            x.level = 0;
            now = value_along(begin + (double)i * step, &x);
            found = first_level(&x, begin + (double)(i - 1) * step, begin + (double)i * step, last,
                                now);
            first = GSL_MIN_DBL(first, found);
        }
    }
    return first;
}

/* ---------------------------------------------------------------------------- dead centres of the drive */

/* K of the drive as a function of theta2. */
static double drive_at(double theta2, void *data)
{
    const sought *x = data;
    const deck *d = x->corners->d;
    fourlink_crank crank = {0, 1, 0};
    fourlink_state state;
    flk_unit_drive drive;

    crank.theta2 = theta2;
    if (flk_mechanism_move(&d->machine.mechanism, x->branch, &crank, 0, &state) != FOURLINK_OK ||
        flk_drive_unit(d->machine.mechanism.drive, &d->machine.mechanism, &state, &drive) ==
            FOURLINK_NO_DIRECTION)
        return GSL_NAN;
    return drive.K;
}

/* Find where the drive stands still while the crank turns: there is no row, and its effort has a pole or
** a limit. */
static void find_dead(flk_corners *c, fourlink_branch branch)
{
    size_t n = (size_t)floor(SAMPLES * c->period / (2 * M_PI) + 0.5), i;
    double step = c->period / (double)n, last = GSL_NAN, now;
    size_t *found = &c->n_dead[index_of(branch)];
    sought x;

    x.corners = c;
    x.branch = branch;
    for (i = 0; i <= n && *found < FLK_DRIVE_DEAD; i++) {
        double theta2 = step * ((double)i - 0.37);

        now = drive_at(theta2, &x);
        if (last * now < 0) {
            flk_bracket b = flk_bracket_of(theta2 - step, theta2, last, now);

            c->dead[index_of(branch)][(*found)++] = flk_find_zero(drive_at, &x, &b, 0);
        }
        last = now;
    }
    c->knows_dead[index_of(branch)] = 1;
}

/* --------------------------------------------------------------------------------------------- the next */

typedef struct search {
    const flk_direction *p;
    double after; /* rad passed: the next end after this is sought */
    double at;    /* the nearest end so far, and its kind */
    flk_piece_end end;
} search;

static void offer(search *s, double passed, flk_piece_end end)
{
    double closest = FLK_CORNERS_CLOSE(passed);

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

    offer(s, passed + period * ceil((s->after + FLK_CORNERS_CLOSE(s->after) - passed) / period),
          end);
}

/* Of many levels, increasing within a period, only the neighbours can be next. */
static void offer_levels(search *s, const double *level, size_t n, double period)
{
    double here = s->p->from + s->p->sense * s->after;
    size_t low, i, k;

    if (n == 0)
        return;
    here = flk_cycle_place(here, level[0], period);
    low = flk_switch_below(level, n, here);
    for (k = 0; k < n; k++) {
        double away;

        i = s->p->sense > 0 ? (low + k) % n : (low + 2 * n - 1 - k) % n;
        offer_angle(s, level[i], period, FLK_END_PLAIN);
        away = s->p->sense * (level[i] - here);
        if (flk_cycle_place(away, 0, period) > 2 * CLOSEST)
            return;
    }
}

static void offer_drive(search *s)
{
    flk_corners *c = s->p->corners;
    int i = index_of(s->p->branch);
    size_t k;

    if (!c->d->machine.mechanism.drive)
        return;
    if (!c->knows_dead[i])
        find_dead(c, s->p->branch);
    for (k = 0; k < c->n_dead[i]; k++)
        offer_angle(s, c->dead[i][k], c->period, FLK_END_CHANGE);
}

static void offer_loads(search *s)
{
    flk_corners *c = s->p->corners;
    int i = index_of(s->p->branch);
    size_t j;

    if (!c->is_known[i])
        find_crossings(c, s->p->branch);
    for (j = 0; j < c->n_over_theta2; j++)
        offer_levels(s, c->switches[j].level, c->switches[j].n, c->switches[j].period);
    offer_levels(s, c->theta2[i], c->n[i], c->period);
}

/* The ends of the range in which a deck's linkage is to make a function: there a structural error begins and
** ends. */
static void offer_working_range(search *s)
{
    const deck_synthesis *t = s->p->corners->d->synthesis;
    double theta2[2];
    int i;

    for (i = 0; i < 2 && t && t->chosen && flk_synthesis_range(t, theta2); i++)
        offer_angle(s, theta2[i], 2 * M_PI, FLK_END_PLAIN);
}

/* Outputs are dead where they cease to be assembled. */
static void offer_ends(search *s)
{
    flk_corners *c = s->p->corners;
    int i = index_of(s->p->branch);
    size_t k;

    if (!c->are_ends_known[i])
        c->n_ends[i] = flk_groups_ends(&c->d->machine.mechanism, s->p->branch, c->period,
                                       c->ends[i], FLK_GROUPS_ENDS);
    c->are_ends_known[i] = 1;
    for (k = 0; k < c->n_ends[i]; k++)
        offer_angle(s, c->ends[i][k], c->period,
                    flk_groups_are_beyond(&c->d->machine.mechanism, s->p->branch, c->ends[i][k])
                        ? FLK_END_POLE
                        : FLK_END_DEAD);
}

/* Dead positions are the ends of the reachable ranges; change points are where a range could end, at 0 and
** 180 deg or at +-90 deg, and positions where the links come close to one line. */
static void offer_positions(search *s)
{
    const fourlink_mechanism *mechanism = &s->p->corners->d->machine.mechanism;
    double line = flk_kind_of(mechanism->design.kind)->folded;
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
    if (mechanism->design.n_groups)
        offer_ends(s);
}

double flk_corners_next(const flk_direction *direction, double after, const double *more, size_t n,
                        flk_piece_end *what)
{
    search s;
    size_t i;

    s.p = direction;
    s.after = after;
    s.at = GSL_POSINF;
    s.end = FLK_END_NOWHERE;
    offer_positions(&s);
    if (direction->has_loads)
        offer_drive(&s);
    offer_working_range(&s);
    for (i = 0; i < n; i++)
        offer(&s, more[i], FLK_END_PLAIN);
    if (direction->has_loads)
        offer_loads(&s);
    *what = s.end;
    return s.at;
}

flk_piece_end flk_corners_first(const flk_direction *direction)
{
    search s;

    s.p = direction;
    s.after = -3 * CLOSEST;
    s.at = 2 * CLOSEST;
    s.end = FLK_END_PLAIN;
    offer_positions(&s);
    if (direction->has_loads)
        offer_drive(&s);
    return s.at > CLOSEST ? FLK_END_PLAIN : s.end;
}

/* ----------------------------------------------------------------------------------------- the switches */

/* Put the switches over the crank angle first, and those whose corners depend on the speed last; count
** the levels of the others. */
static size_t sort(flk_corners *c, size_t n)
{
    size_t i, n_levels = 0;

    for (i = 0; i < n; i++) {
        flk_switch s = c->switches[i];

        if (!s.joint && s.of == FLK_THETA2) {
            c->switches[i] = c->switches[c->n_switches];
            c->switches[c->n_switches++] = c->switches[c->n_over_theta2];
            c->switches[c->n_over_theta2++] = s;
        } else if (flk_switch_is_of_position(&s) || has_one_speed(c->d)) {
            c->switches[i] = c->switches[c->n_switches];
            c->switches[c->n_switches++] = s;
            n_levels += s.n;
        }
    }
    c->n_of_speed = n - c->n_switches;
    return n_levels;
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
        flk_switch_list(&d->machine, c->switches);
        c->most = PASSES * turns * sort(c, n);
    }
    c->work = malloc((2 * c->most + n + 1) * sizeof *c->work);
    if (!c->switches || !c->work) {
        flk_corners_close(c);
        return NULL;
    }
    c->theta2[0] = c->work + n;
    c->theta2[1] = c->theta2[0] + c->most;
    return c;
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
    size_t turns = (size_t)ceil(angle / (2 * M_PI)) + 1, j;
    size_t n = 8 * turns; /* dead positions, in line, ends of a working range */

    if (c->d->machine.mechanism.design.n_groups)
        n += FLK_GROUPS_ENDS * ((size_t)ceil(angle / c->period) + 1);
    for (j = 0; j < c->n_over_theta2; j++)
        n += c->switches[j].n * ((size_t)ceil(angle / c->switches[j].period) + 1);
    return n + c->most * ((size_t)ceil(angle / c->period) + 1);
}
