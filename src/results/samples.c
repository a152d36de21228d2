/* SPDX-License-Identifier: GPL-3.0-or-later
**
** samples.c - samples of columns along the motion of a branch, piece by piece.
*/
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/scale.h"
#include "base/solve.h"
#include "base/trig.h"
#include "mechanics/mechanics.h"
#include "samples.h"

#define STEP (M_PI / 48) /* rad, */
#define MOST_STEPS 1e5   /* ... longer over more than 1000 turns */
#define LEAST_STEPS 12   /* of a piece */
#define SHORT 1e-9       /* rad, of a piece of which one row is computed */
#define HALVINGS 9       /* of the step towards some ends */
#define ARRAYS 3         /* at most, of a column: values, two components of a vector */

int flk_samples_open(flk_samples_room *room, size_t most)
{
    if (!room->columns)
        room->columns = malloc(most * sizeof *room->columns);
    if (!room->near)
        room->near = malloc(sizeof *room->near);
    if (!room->values)
        room->values = malloc(FLK_SAMPLES_MOST * (ARRAYS * most + 2) * sizeof *room->values);
    return room->columns && room->near && room->values;
}

void flk_samples_close(flk_samples_room *room)
{
    free(room->columns);
    free(room->near);
    free(room->values);
}

void flk_samples_begin(flk_samples *x, const flk_samples_room *room, flk_analysis *a,
                       fourlink_branch branch)
{
    memset(x, 0, sizeof *x);
    flk_follow(&x->f, a, branch);
    x->columns = room->columns;
    x->near = room->near;
    x->s = room->values;
    x->force = x->s + FLK_SAMPLES_MOST;
    x->is_whole = 1;
    x->may_lock = a->d->machine.has_friction && a->d->has_forces;
    x->needs = x->may_lock ? NEED_FORCES : 0;
}

void flk_samples_add(flk_samples *x, const flk_column *column)
{
    flk_sampled *c = &x->columns[x->n_columns++];

    memset(c, 0, sizeof *c);
    flk_follow_column(&x->f, &c->of, column);
    c->is_of_crank = (flk_column_flags(column) & FOURLINK_OF_CRANK) && !x->f.a->d->prescribed;
    c->v = x->force + FLK_SAMPLES_MOST * (ARRAYS * x->n_columns - ARRAYS + 1);
    if (flk_column_has_vector(column)) {
        c->vector[0] = c->v + FLK_SAMPLES_MOST;
        c->vector[1] = c->vector[0] + FLK_SAMPLES_MOST;
    }
    x->needs |= flk_column_need(column);
    x->has_noise |= c->of.is_noise;
}

/* --------------------------------------------------------------------------------------------- values */

/* The column by its limit at an end of the piece, if that reaches so far; else NaN. */
static double value_by_limit(const flk_sampled *c, double passed, double near)
{
    double value = flk_limit_value(&c->limit[0], &c->of, passed, near);

    return gsl_isnan(value) ? flk_limit_value(&c->limit[1], &c->of, passed, near) : value;
}

double flk_samples_value(const flk_samples *x, const flk_sampled *c, double s, double near)
{
    double value = value_by_limit(c, flk_follow_corner(&x->f, s), near);

    if (gsl_isnan(value))
        value = flk_followed_value(&x->f, &c->of, s);
    if (!(c->of.turn > 0) || gsl_isnan(near))
        return value;
    return flk_followed_turns_over(&c->of, near, value) ? GSL_NAN
                                                        : flk_followed_nearest(&c->of, value, near);
}

double flk_samples_smooth(const flk_samples *x, const flk_sampled *c, double s)
{
    double passed = flk_follow_corner(&x->f, s);
    double value = flk_limit_rough(&c->limit[0], &c->of, passed);

    if (gsl_isnan(value))
        value = flk_limit_rough(&c->limit[1], &c->of, passed);
    return gsl_isnan(value) ? flk_samples_value(x, c, s, GSL_NAN) : value;
}

int flk_sampled_is_rounded(const flk_sampled *c, double passed)
{
    return fabs(passed - c->limit[0].edge) < c->limit[0].rounded ||
           fabs(passed - c->limit[1].edge) < c->limit[1].rounded;
}

int flk_samples_is_at_limit(const flk_samples *x, double s)
{
    return (s <= 0 && flk_follow_has_limit(x->f.piece.begin)) ||
           (s >= 1 && flk_follow_has_limit(x->f.piece.end));
}

static double value_of(const flk_samples *x, const flk_sampled *c, double s, double passed,
                       const flk_row *row)
{
    double value = flk_column_value(c->of.c, row), by_limit;

    if (!x->has_limit && !c->of.is_noise) /* nearly all samples */
        return fabs(value) <= DBL_MAX ? value : GSL_NAN;
    if (c->is_of_crank)
        return flk_samples_is_at_limit(x, s) || !flk_sampled_is_rounded(c, passed) ? value
                                                                                   : GSL_NAN;
    by_limit = c->limit[0].reach < 0 && c->limit[1].reach < 0 ? GSL_NAN
                                                              : value_by_limit(c, passed, GSL_NAN);
    if (!gsl_isnan(by_limit) || flk_samples_is_at_limit(x, s))
        value = by_limit;
    else if (flk_sampled_is_rounded(c, passed) || (c->of.is_noise && x->f.a->is_fast))
        value = GSL_NAN;
    return fabs(value) <= DBL_MAX ? value : GSL_NAN;
}

/* A crank angle closer than this to an end without a row is given as that of the end. */
#define AT_LIMIT 2e-6 /* rad */

double flk_samples_place(const flk_samples *x, const flk_sampled *c, double s)
{
    int is_inside = (s <= 0 && c->is_inside[0]) || (s >= 1 && c->is_inside[1]), end;
    double passed = is_inside ? flk_follow_passed(&x->f, s) : flk_follow_corner(&x->f, s);

    for (end = 0; end < 2; end++)
        if (c->limit[end].reach >= 0 && fabs(passed - c->limit[end].edge) < AT_LIMIT)
            passed = c->limit[end].edge;
    return flk_follow_place(&x->f, passed);
}

/* -------------------------------------------------------------------------------------------- samples */

/* The sample at an end of the piece is the row there or, where a load jumps, the row just inside.  There the
** column changes by more than as far again into the piece, and by more than rounding. */
#define FASTER 4
#define AGREES 1e-10 /* of the column's size */

static int jumps_at_end(const flk_sampled *c, double here, double there, double farther)
{
    double step = fabs(flk_followed_nearest(&c->of, here, there) - there);
    double next = fabs(flk_followed_nearest(&c->of, farther, there) - there);

    return step > AGREES * GSL_MAX_DBL(c->size, fabs(there)) && !(step <= FASTER * next);
}

/* The value just inside an end, where an angle goes on from the end's value, or starts anew. */
static double inside_of(const flk_sampled *c, double inside, double end)
{
    return c->of.turn > 0 && flk_followed_turns_over(&c->of, end, inside)
               ? inside
               : flk_followed_nearest(&c->of, inside, end);
}

/* Set the components of vectors in sample i. */
static void take_vectors(const flk_samples *x, size_t i, const flk_row *row)
{
    size_t k;

    for (k = 0; k < x->n_columns; k++) {
        const flk_sampled *c = &x->columns[k];

        if (!c->vector[0])
            continue;
        c->vector[0][i] = c->vector[1][i] = GSL_NAN;
        if (row->at.status == FOURLINK_OK)
            flk_column_vector(c->of.c, row, &c->vector[0][i], &c->vector[1][i]);
    }
}

static void take_end(const flk_samples *x, double s, size_t i)
{
    flk_piece_end end = s <= 0 ? x->f.piece.begin : x->f.piece.end;
    double corner = flk_follow_corner(&x->f, s), inside = flk_follow_inside(&x->f, s);
    flk_row at, beside, beyond;
    size_t k;

    flk_follow_row(&x->f, x->needs, corner, &at);
    flk_follow_row(&x->f, x->needs, inside, &beside);
    flk_follow_row(&x->f, x->needs, inside + (inside - corner), &beyond);
    for (k = 0; k < x->n_columns; k++) {
        flk_sampled *c = &x->columns[k];
        double here = value_of(x, c, s, corner, &at), there = value_of(x, c, s, corner, &beside);
        int jumps = !flk_follow_is_root(end) &&
                    jumps_at_end(c, here, there, value_of(x, c, s, corner, &beyond));

        c->is_inside[s >= 1] = (jumps || gsl_isnan(here)) && !gsl_finite(c->of.bound);
        c->v[i] = c->is_inside[s >= 1] ? inside_of(c, there, here) : here;
        c->corner[s >= 1] = c->is_inside[s >= 1] ? here : there;
    }
    take_vectors(x, i, &beside);
}

static double *make_room(double *list, size_t n, size_t i)
{
    memmove(list + i + 1, list + i, (n - i) * sizeof *list);
    return list + i;
}

static double largest_force(const flk_row *row)
{
    const fourlink_forces *f = &row->at.forces;

    if (row->at.status != FOURLINK_OK)
        return GSL_NAN;
    return GSL_MAX_DBL(GSL_MAX_DBL(flk_length(f->F12x, f->F12y), flk_length(f->F23x, f->F23y)),
                       GSL_MAX_DBL(flk_length(f->F34x, f->F34y), flk_length(f->F14x, f->F14y)));
}

static void make_room_of_column(const flk_sampled *c, size_t n, size_t i)
{
    make_room(c->v, n, i);
    if (c->vector[0]) {
        make_room(c->vector[0], n, i);
        make_room(c->vector[1], n, i);
    }
}

/* Insert a sample before number i. */
static void insert_sample(flk_samples *x, size_t i, double s)
{
    double passed = flk_follow_corner(&x->f, s);
    flk_row row;
    size_t k;

    *make_room(x->s, x->n, i) = s;
    *make_room(x->force, x->n, i) = GSL_NAN;
    for (k = 0; k < x->n_columns; k++)
        make_room_of_column(&x->columns[k], x->n, i);
    if (s <= 0 || s >= 1) {
        take_end(x, s, i);
    } else {
        flk_follow_row(&x->f, x->needs, passed, &row);
        x->has_lock |= row.at.status == FOURLINK_LOCKED;
        if (x->may_lock)
            x->force[i] = largest_force(&row);
        for (k = 0; k < x->n_columns; k++)
            x->columns[k].v[i] = value_of(x, &x->columns[k], s, passed, &row);
        take_vectors(x, i, &row);
    }
    x->f.a->rows_left -= (double)x->n_columns / 16;
    x->n++;
}

/* Make an angle in an inserted sample go on from the last one with a value or, half a turn from that or
** without any, towards the next. */
static void continue_inserted(const flk_samples *x, const flk_sampled *c, size_t i)
{
    double *v = c->v;
    size_t last = i, next = i + 1;

    while (last > 0 && gsl_isnan(v[--last]))
        ;
    while (next + 1 < x->n && gsl_isnan(v[next]))
        next++;
    v[i] = flk_followed_nearest(
        &c->of, v[i],
        gsl_isnan(v[last]) || flk_followed_turns_over(&c->of, v[last], v[i]) ? v[next] : v[last]);
}

int flk_samples_insert(flk_samples *x, size_t i, double s)
{
    size_t k;

    if (x->n == FLK_SAMPLES_MOST)
        return 0;
    insert_sample(x, i, s);
    for (k = 0; k < x->n_columns; k++)
        if (x->columns[k].of.turn > 0)
            continue_inserted(x, &x->columns[k], i);
    return 1;
}

/* 1 if columns can change fast beside an end. */
static int is_fast_beside(const flk_samples *x, double s, flk_piece_end end)
{
    flk_row row;

    if (flk_follow_has_limit(end))
        return 1;
    flk_follow_row(&x->f, 0, flk_follow_corner(&x->f, s), &row);
    return row.at.status == FOURLINK_OK && FLK_SINE(&row.at.state) < FLK_SAMPLES_NEAR_LINE;
}

static size_t sample_steps(const flk_samples *x)
{
    double length = x->f.piece.to - x->f.piece.from;
    double steps = ceil(length / GSL_MAX_DBL(STEP, x->f.motion.length / MOST_STEPS) - 1e-9);

    return length < SHORT ? 0
           : x->is_reached
               ? (size_t)GSL_MAX_DBL(LEAST_STEPS, GSL_MIN_DBL(steps, FLK_SAMPLES_MOST / 4))
               : LEAST_STEPS;
}

/* 1 if a sample of each column lies on the polynomial through three neighbours on each side, `step` apart. */
#define SMOOTH 1e-4 /* of a column's largest sample */

static int is_smooth(const flk_samples *x, size_t i, double step)
{
    size_t k;

    if (i < 3 || i + 3 >= x->n || x->s[i + 3] - x->s[i - 3] < 5.9 * step)
        return 0;
    for (k = 0; k < x->n_columns; k++) {
        const double *v = x->columns[k].v + i;
        double expected = (v[-3] + v[3] - 6 * (v[-2] + v[2]) + 15 * (v[-1] + v[1])) / 20;

        if (!(fabs(v[0] - expected) <= SMOOTH * x->columns[k].largest))
            return 0;
    }
    return 1;
}

/* Halve the steps beside samples at which some column is not smooth. */
static void halve_steps(flk_samples *x, double step)
{
    char smooth[FLK_SAMPLES_MOST];
    size_t i, k;

    for (k = 0; k < x->n_columns; k++)
        for (x->columns[k].largest = 0, i = 0; i < x->n; i++)
            flk_scale_take(&x->columns[k].largest, x->columns[k].v[i]);
    for (i = 0; i < x->n; i++)
        smooth[i] = (char)is_smooth(x, i, step);
    for (i = x->n - 1; i-- > 0;)
        if (x->s[i + 1] - x->s[i] > 0.9 * step && !(smooth[i] && smooth[i + 1]))
            insert_sample(x, i + 1, 0.5 * (x->s[i] + x->s[i + 1]));
}

/* More samples beside peaks of the pin forces until one is found in which friction locks the mechanism:
** beside it forces grow as the inverse of the distance.  A peak is more than PEAK times as large as the
** samples beside it. */
#define LOCK_HALVINGS 6
#define PEAK 1.5

static int is_peak(const double *force)
{
    return force[0] > PEAK * force[-1] && force[0] > PEAK * force[1];
}

static void resolve_locks(flk_samples *x, double step)
{
    double closest = step * gsl_pow_int(0.5, LOCK_HALVINGS);
    size_t i;

    for (i = 1; i + 1 < x->n && x->n + 2 < FLK_SAMPLES_MOST && !x->has_lock; i++) {
        if (x->s[i + 1] - x->s[i - 1] < closest || !is_peak(x->force + i))
            continue;
        insert_sample(x, i + 1, 0.5 * (x->s[i] + x->s[i + 1]));
        insert_sample(x, i, 0.5 * (x->s[i - 1] + x->s[i]));
        i = i > 2 ? i - 2 : 0;
    }
}

/* Samples of the piece in even steps, which are doubled where all columns are smooth, and closer beside
** some ends. */
static void sample(flk_samples *x)
{
    size_t n = sample_steps(x), i;
    int at_begin = n && x->is_reached && is_fast_beside(x, 0, x->f.piece.begin),
        at_end = n && x->is_reached && is_fast_beside(x, 1, x->f.piece.end), k;
    double step = 1 / (double)GSL_MAX(n, 1);

    x->n = 0;
    x->has_lock = 0;
    x->f.a->is_fast = !x->has_noise;
    if (n || x->f.piece.from <= 0)
        insert_sample(x, x->n, 0);
    for (k = HALVINGS; at_begin && k > 0; k--)
        insert_sample(x, x->n, step * gsl_pow_int(0.5, k));
    for (i = 1; i < n; i++)
        if (i % 2 == 0 || i == 1 || i + 1 == n)
            insert_sample(x, x->n, step * (double)i);
    for (k = 1; at_end && k <= HALVINGS; k++)
        insert_sample(x, x->n, 1 - step * gsl_pow_int(0.5, k));
    if (n || x->f.piece.from > 0)
        insert_sample(x, x->n, 1);
    if (n)
        halve_steps(x, 2 * step);
    if (n && x->is_reached && x->may_lock)
        resolve_locks(x, step);
    x->f.a->is_fast = 1;
}

/* More samples until no angle jumps by more than a sixth of a turn, or they are too close. */
#define JUMP (1.0 / 6)
#define CLOSEST_SAMPLES 1e-9

static int angle_jumps(const flk_samples *x, size_t i)
{
    size_t k;

    for (k = 0; k < x->n_columns; k++) {
        const flk_sampled *c = &x->columns[k];

        if (c->of.turn > 0 && flk_followed_change(&c->of, c->v[i], c->v[i + 1]) > JUMP)
            return 1;
    }
    return 0;
}

/* 1 if a direction may make a whole turn between samples i and i + 1, whose difference does not show it:
** its vector goes around the origin.  Then that is on one side of the chord and on the other of the
** curve, which is as far from the chord as its bend says. */
#define BEND 0.5 /* times the bend of the samples: an arc is 1/8 of it away */

/* The part of the bend of samples i - 1, i, i + 1 in a step of length h. */
static double bend_at(const flk_samples *x, const double *v, size_t i, double h)
{
    const double *s = x->s + i;
    double bend = ((v[i + 1] - v[i]) / (s[1] - s[0]) - (v[i] - v[i - 1]) / (s[0] - s[-1])) /
                  (0.5 * (s[1] - s[-1]));

    return gsl_isnan(bend) ? 0 : bend * h * h;
}

static double bend_of_vector(const flk_samples *x, const flk_sampled *c, size_t i)
{
    double h = x->s[i + 1] - x->s[i], before = 0, behind = 0;

    if (i > 0)
        before = flk_length(bend_at(x, c->vector[0], i, h), bend_at(x, c->vector[1], i, h));
    if (i + 2 < x->n)
        behind = flk_length(bend_at(x, c->vector[0], i + 1, h), bend_at(x, c->vector[1], i + 1, h));
    return GSL_MAX_DBL(before, behind);
}

/* The part of the chord between two samples of a vector at which it is closest to the origin, and how
** far it is from that. */
static double part_of_chord(const flk_sampled *c, size_t i)
{
    const double *u = c->vector[0] + i, *v = c->vector[1] + i;
    double du = u[1] - u[0], dv = v[1] - v[0], along = -(u[0] * du + v[0] * dv);
    double part = along / (du * du + dv * dv);

    return part > 0 ? GSL_MIN_DBL(part, 1) : 0;
}

static double distance_of_chord(const flk_sampled *c, size_t i)
{
    const double *u = c->vector[0] + i, *v = c->vector[1] + i;
    double part = part_of_chord(c, i);

    return flk_length(u[0] + part * (u[1] - u[0]), v[0] + part * (v[1] - v[0]));
}

static int may_go_around(const flk_samples *x, size_t i)
{
    size_t k;

    for (k = 0; k < x->n_columns; k++) {
        const flk_sampled *c = &x->columns[k];

        if (c->vector[0] && c->of.turn > 0 && !gsl_isnan(c->v[i] + c->v[i + 1]) &&
            distance_of_chord(c, i) < BEND * bend_of_vector(x, c, i))
            return 1;
    }
    return 0;
}

static void resolve_jumps(flk_samples *x)
{
    size_t i;

    for (i = 0; i + 1 < x->n; i++)
        while (x->n < FLK_SAMPLES_MOST && x->s[i + 1] - x->s[i] > CLOSEST_SAMPLES &&
               (angle_jumps(x, i) || may_go_around(x, i)))
            insert_sample(x, i + 1, 0.5 * (x->s[i] + x->s[i + 1]));
}

/* Make an angle continuous through the samples of the piece. */
static void continue_angle(const flk_samples *x, flk_sampled *c)
{
    double *last = &c->of.last;
    size_t i;

    c->starts_anew = 0;
    for (i = 0; i < x->n; i++) {
        if (x->f.piece.from <= 0 && i == 0)
            c->of.first = c->v[i];
        if (gsl_isnan(c->v[i]))
            continue;
        if (!gsl_isnan(*last) && flk_followed_turns_over(&c->of, *last, c->v[i])) {
            c->starts_anew = c->of.restarts = 1;
        } else {
            c->v[i] = flk_followed_nearest(&c->of, c->v[i], *last);
        }
        *last = c->v[i];
    }
}

/* --------------------------------------------------------------------------------------------- pieces */

/* The inertia forces of the links and their weights, for columns that need no forces in the pins. */
static void take_inertia_forces(const fourlink_design *design, flk_scale *scale)
{
    double g = flk_length(design->gravity.x, design->gravity.y);
    int i;

    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++) {
        const fourlink_link *link = &design->link[i];

        flk_scale_take(&scale->force, link->mass * (scale->length * scale->acceleration + g));
        flk_scale_take(&scale->force, link->inertia * scale->acceleration / scale->length);
    }
}

double flk_samples_scale(const flk_samples *x, const flk_sampled *c, const flk_row *row)
{
    const fourlink_design *design = &x->f.a->d->machine.mechanism.design;
    const fourlink_forces *f = &row->at.forces;
    flk_scale scale = {0, 0, 0, 0};
    double own = flk_column_size(c->of.c, row);
    int i;

    if (c->of.turn > 0 || !gsl_isnan(own))
        return c->of.turn > 0 ? c->of.turn : own;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        flk_scale_take(&scale.length, design->link[i].length);
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++) {
        const fourlink_link_state *link = &row->at.state.link[i];

        flk_scale_take(&scale.speed, link->omega);
        flk_scale_take(&scale.acceleration, link->omega * link->omega);
        flk_scale_take(&scale.acceleration, link->alpha);
    }
    if (flk_column_need(c->of.c) & NEED_FORCES) {
        flk_scale_take(&scale.force, gsl_hypot(f->F12x, f->F12y));
        flk_scale_take(&scale.force, gsl_hypot(f->F23x, f->F23y));
        flk_scale_take(&scale.force, gsl_hypot(f->F34x, f->F34y));
        flk_scale_take(&scale.force, gsl_hypot(f->F14x, f->F14y));
    } else {
        take_inertia_forces(design, &scale);
    }
    return c->of.c->scale * flk_scale_of(&scale, flk_column_quantity(c->of.c));
}

/* The size of columns, in the middle of the piece. */
static void find_sizes(flk_samples *x)
{
    const flk_piece *p = &x->f.piece;
    flk_row row;
    size_t k;

    flk_follow_row(&x->f, x->needs, 0.5 * (p->from + p->to), &row);
    for (k = 0; k < x->n_columns; k++) {
        flk_sampled *c = &x->columns[k];
        double size = fabs(flk_column_value(c->of.c, &row));

        c->scale = row.at.status == FOURLINK_OK ? flk_samples_scale(x, c, &row) : 0;
        if (size < c->of.bound) /* elsewhere there is no row, or a pole */
            c->size = GSL_MAX_DBL(c->size, size);
    }
}

#define ROUNDED 1e-7 /* rad */

/* 1 for a stretch at whose end friction begins or ceases to lock, so short that rounding error has made
** it: there rows are differences of forces that are as good as unbounded. */
static int is_of_rounding(const flk_piece *p)
{
    return p->to - p->from < ROUNDED && (p->begin == FLK_END_LOCK || p->end == FLK_END_LOCK);
}

static double scale_beside(const flk_samples *x, const flk_sampled *c)
{
    const flk_row *row = &x->near->row[0][0];

    return row->at.status == FOURLINK_OK ? flk_samples_scale(x, c, row) : 0;
}

static void find_limits(flk_samples *x, int at_end)
{
    flk_piece_end end = at_end ? x->f.piece.end : x->f.piece.begin;
    int has_limit = flk_follow_has_limit(end) && !is_of_rounding(&x->f.piece);
    size_t k;

    if (has_limit)
        flk_limit_rows_near(&x->f, x->needs, at_end, x->near);
    for (k = 0; k < x->n_columns; k++) {
        flk_sampled *c = &x->columns[k];
        flk_limit *l = &c->limit[at_end];

        flk_limit_none(l);
        if (!has_limit)
            continue;
        if (c->is_of_crank || c->of.is_noise)
            flk_limit_of_crank(x->near, l);
        else
            flk_limit_find(x->near, &c->of, c->size, scale_beside(x, c), l);
    }
}

/* Negative where friction locks the mechanism. */
static double lock_at(double passed, void *data)
{
    const flk_samples *x = data;
    flk_row row;

    flk_follow_row(&x->f, x->needs, passed, &row);
    return row.at.status == FOURLINK_LOCKED ? GSL_NEGINF : GSL_POSINF;
}

/* 1 so close to a place at which a slider goes beyond all bounds that rounding error decides whether
** friction locks. */
static int is_beside_pole(const flk_piece *p, double passed)
{
    return (passed - p->from < ROUNDED && p->begin == FLK_END_POLE) ||
           (p->to - passed < ROUNDED && p->end == FLK_END_POLE);
}

/* The first angle passed at which friction begins to lock the mechanism (or ceases to, if *lock < 0), on
** the side with rows; infinite if there is none.  No formula gives it. */
static double find_edge(flk_samples *x, double *lock)
{
    double low = flk_follow_passed(&x->f, x->s[0]), high;
    flk_bracket b;
    size_t i;

    *lock = lock_at(low, x);
    for (i = 1; i < x->n && x->has_lock; i++, low = high) {
        high = flk_follow_passed(&x->f, x->s[i]);
        if (lock_at(high, x) == *lock)
            continue;
        b = flk_bracket_of(low, high, *lock, -*lock);
        flk_find_zero(lock_at, x, &b, 0);
        if (!is_beside_pole(&x->f.piece, b.low))
            return *lock < 0 ? b.high : b.low;
        *lock = -*lock;
    }
    return GSL_POSINF;
}

/* Sample the piece, or its part up to an edge at which friction begins or ceases to lock the mechanism.
** Towards such an edge friction grows as the inverse of the distance or, where two solutions meet, ends as
** its root. */
#define MOST_PARTS 100

static void sample_part(flk_samples *x)
{
    flk_piece *part = &x->f.piece;
    double edge, lock = 0;

    x->has_limit = flk_follow_has_limit(part->begin) || flk_follow_has_limit(part->end);
    find_limits(x, 0);
    find_limits(x, 1);
    sample(x);
    edge = x->has_lock && x->n_parts < MOST_PARTS ? find_edge(x, &lock) : GSL_POSINF;
    x->is_whole = !(edge < part->to);
    if (x->is_whole)
        return;
    x->rest = *part;
    x->rest.from = GSL_MAX_DBL(edge, part->from + SHORT / 10); /* a first row can stand alone */
    x->rest.begin = FLK_END_LOCK;
    x->n_parts++;
    part->to = edge;
    part->end = FLK_END_LOCK;
    x->has_limit = 1;
    find_limits(x, 1);
    sample(x);
}

/* Go on to the next piece; a motion without length has one. */
static int go_on(flk_samples *x)
{
    x->n_parts = 0;
    if (flk_follow_is_over(&x->f) || (!flk_follow_next(&x->f) && (x->n || x->f.motion.length > 0)))
        return 0;
    x->is_reached = x->f.motion.length <= 0 || flk_follow_is_reached(&x->f);
    find_sizes(x);
    return 1;
}

int flk_samples_next(flk_samples *x)
{
    size_t i;

    if (!x->is_whole)
        x->f.piece = x->rest;
    else if (!go_on(x))
        return 0;
    sample_part(x);
    resolve_jumps(x);
    for (i = 0; i < x->n_columns; i++)
        if (x->columns[i].of.turn > 0)
            continue_angle(x, &x->columns[i]);
    return 1;
}

/* ------------------------------------------------------------------------------------------ least size */

/* The bend of a component before a step and behind it; at an end of the piece both are the same. */
static void bends_of(const flk_samples *x, const double *v, size_t i, double bend[2])
{
    double h = x->s[i + 1] - x->s[i];

    bend[0] = i > 0 ? bend_at(x, v, i, h) : 0;
    bend[1] = i + 2 < x->n ? bend_at(x, v, i + 1, h) : bend[0];
    bend[0] = i > 0 ? bend[0] : bend[1];
}

/* Where the chord is closest to the origin, the curve is beside it by its bend, which is known to within
** its change over the step.  It is no farther from the chord than that is long: where the bend says so,
** it is rounding error. */
double flk_samples_least_size(const flk_samples *x, const flk_sampled *c, size_t i)
{
    double part = part_of_chord(c, i), arc = part * (1 - part) / 2, F[2], off[2], d[2], bend[2];
    int k;

    for (k = 0; k < 2; k++) {
        const double *v = c->vector[k] + i;

        d[k] = v[1] - v[0];
        bends_of(x, c->vector[k], i, bend);
        F[k] = v[0] + part * d[k] - arc * (bend[0] + part * (bend[1] - bend[0]));
        off[k] = arc * (bend[1] - bend[0]);
    }
    return c->of.c->scale * GSL_MAX_DBL(flk_length(F[0], F[1]) - flk_length(off[0], off[1]),
                                        distance_of_chord(c, i) - flk_length(d[0], d[1]));
}

typedef struct turning {
    const flk_samples *x;
    const flk_column *c;
    double along[2]; /* F(s2) - F(s1) */
} turning;

static double along_change(double s, void *data)
{
    const turning *t = data;
    double u, v;
    flk_row row;

    flk_follow_row(&t->x->f, flk_column_need(t->c), flk_follow_corner(&t->x->f, s), &row);
    flk_column_vector(t->c, &row, &u, &v);
    return u * t->along[0] + v * t->along[1];
}

/* The size of a vector is small where it is at right angles to its change: F(s) . (F(s2) - F(s1)) = 0. */
#define NEARLY 1e-12 /* of the product at the nearer sample */

int flk_samples_find_least_size(const flk_samples *x, const flk_sampled *c, size_t i, double *s)
{
    const double *u = c->vector[0] + i, *v = c->vector[1] + i;
    double before, behind;
    flk_bracket b;
    turning t;

    t.along[0] = u[1] - u[0];
    t.along[1] = v[1] - v[0];
    before = u[0] * t.along[0] + v[0] * t.along[1];
    behind = u[1] * t.along[0] + v[1] * t.along[1];
    if (!(before < 0 && behind > 0) || x->s[i + 1] - x->s[i] <= CLOSEST_SAMPLES)
        return 0;
    t.x = x;
    t.c = c->of.c;
    b = flk_bracket_of(x->s[i], x->s[i + 1], before, behind);
    *s = flk_find_zero(along_change, &t, &b, NEARLY * GSL_MIN_DBL(-before, behind));
    return *s > x->s[i] && *s < x->s[i + 1];
}
