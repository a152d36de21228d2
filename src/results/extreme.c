/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme.c - the largest and smallest values of columns over a deck's motion, found together.
**
** The motion is cut into pieces within which columns are smooth (motion/pieces.c).  Each is sampled once for all
** columns, in steps of two degrees or less, over the parameter of extreme_samples.c.
**
** Where samples say that a narrow extreme may hide between them, the steps are halved.  A peak of the samples
** is refined by a polynomial through its neighbours; the row at the peak of the polynomial is computed, and if
** it is not what the polynomial says, there are new samples about it, ever closer.  Where there is no row, at
** dead positions and change points, the limit is that of a polynomial too, or the column is unbounded.  A piece
** in which friction locks the mechanism is cut further, where that begins and ends.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "extreme.h"
#include "extreme_search.h"

#define LEAST_SAMPLES 12 /* of a piece */
#define MOST_STEPS 1e5   /* of all of the motion: over more than 555 turns they are longer */

static void search_samples(flk_search *x)
{
    size_t c;

    flk_search_resolve_leaps(x);
    for (c = 0; c < x->n_columns; c++)
        if (x->columns[c].turn > 0)
            flk_search_follow(x, &x->columns[c], flk_search_row(x, c));
    if (x->low <= 0)
        flk_search_find_limits(x, 0);
    if (x->high >= 1)
        flk_search_find_limits(x, 1);
    for (c = 0; c < x->n_columns; c++) {
        flk_search_offer_samples(x, &x->columns[c], flk_search_row(x, c));
        flk_search_find_poles(x, &x->columns[c], flk_search_row(x, c));
    }
    flk_search_resolve_narrow(x);
    for (c = 0; c < x->n_columns; c++)
        flk_search_refine_peaks(x, &x->columns[c], flk_search_row(x, c));
}

static void reset(flk_tracked *t)
{
    t->lost[0] = t->lost[1] = 0;
    t->has_pole[0] = t->has_pole[1] = 0;
}

/* The even steps of an angle, rad. */
static size_t steps_of(const flk_search *x, double angle)
{
    double step = GSL_MAX_DBL(M_PI / 90, x->motion.length / MOST_STEPS);
    size_t steps = (size_t)ceil(angle / step - 1e-9);

    return GSL_MAX(steps, LEAST_SAMPLES);
}

/* Sample the piece; of one that is too short for more, a row. */
#define SHORT 1e-9 /* rad */

static void sample_part(flk_search *x)
{
    double length = x->piece.to - x->piece.from;
    size_t i, steps = GSL_MIN(steps_of(x, length), FLK_SEARCH_MOST_STEPS);

    for (i = 0; i < x->n_columns; i++)
        reset(&x->columns[i]);
    x->piece.motion_from = x->piece.from;
    x->piece.motion_to = x->piece.to;
    if (length < SHORT)
        x->piece.begin = x->piece.end = FLK_END_PLAIN;
    x->low = length < SHORT && x->piece.from > 0 ? 1 : 0;
    x->high = length < SHORT ? x->low : 1;
    flk_search_sample(x, length < SHORT ? 0 : steps);
}

/* Where there are no rows beyond an end, there are limits; in a locked part there are none. */
static void search_part(flk_search *x, int is_locked)
{
    if (is_locked && flk_search_has_limit(x->piece.begin))
        x->piece.begin = FLK_END_PLAIN;
    if (is_locked && flk_search_has_limit(x->piece.end))
        x->piece.end = FLK_END_PLAIN;
    sample_part(x);
    search_samples(x);
}

/* A stretch in whose samples friction locks the mechanism, in parts that are locked or are not. */
#define MOST_PARTS 100

static void search_parts(flk_search *x)
{
    flk_piece whole = x->piece, rest = whole;
    int is_locked, k;
    double edge;
    size_t c;

    for (c = 0; c < x->n_columns; c++)
        x->columns[c].last = x->columns[c].before;
    if (x->low > 0) {
        rest.from = flk_search_passed(x, x->low);
        rest.begin = FLK_END_PLAIN;
    }
    if (x->high < 1) {
        rest.to = flk_search_passed(x, x->high);
        rest.end = FLK_END_PLAIN;
    }
    x->is_cut = 1;
    for (k = 0; k < MOST_PARTS; k++) {
        is_locked = flk_search_find_lock(x, &edge);
        if (!(edge < rest.to))
            break;
        x->piece = rest;
        x->piece.to = edge;
        x->piece.end = FLK_END_DEAD;
        search_part(x, is_locked);
        rest.from = GSL_MAX_DBL(edge, rest.from + SHORT / 10); /* a first row can stand alone */
        rest.begin = FLK_END_DEAD;
        x->piece = rest;
        sample_part(x);
    }
    x->piece = rest;
    search_part(x, is_locked);
    x->is_cut = 0;
    x->piece = whole;
}

/* A piece in stretches. */
static void search_piece(flk_search *x, int is_reached)
{
    size_t steps = is_reached ? steps_of(x, x->piece.to - x->piece.from) : LEAST_SAMPLES,
           stretches = (steps + FLK_SEARCH_MOST_STEPS - 1) / FLK_SEARCH_MOST_STEPS, i, c;

    for (c = 0; c < x->n_columns; c++)
        reset(&x->columns[c]);
    for (i = 0; i < stretches && !flk_search_is_over(x); i++) {
        for (c = 0; c < x->n_columns; c++)
            x->columns[c].before = x->columns[c].last;
        x->low = (double)i / (double)stretches;
        x->high = (double)(i + 1) / (double)stretches;
        flk_search_sample(x, (steps + stretches - 1) / stretches);
        if (!x->has_lock)
            search_samples(x);
        if (x->has_lock)
            search_parts(x);
    }
}

/* An angle makes in each skipped period as many turns as in the first. */
static void skip_turns(flk_search *x)
{
    size_t c;

    for (c = 0; c < x->n_columns; c++) {
        flk_tracked *t = &x->columns[c];

        if (t->turn > 0 && !t->restarts && !gsl_isnan(t->first + t->last))
            t->last +=
                flk_search_turns(t, t->first, t->last) * floor(x->skipped / x->motion.period + 0.5);
    }
}

/* Some rows of all pieces of an actual motion, so that no peak is refined that another turn beats: a run-up may have
** thousands.  Of short pieces rows may be rounding; angles are not followed here. */
#define LOOKS 4
#define LONG 0.05 /* rad */

static void look_ahead(flk_search *x)
{
    flk_row row;
    size_t c;
    int i;

    while (!flk_search_is_over(x) && flk_search_next(x))
        for (i = 1; i < LOOKS && x->piece.to - x->piece.from > LONG; i++) {
            flk_search_compute(x, x->needs,
                               x->piece.from + (x->piece.to - x->piece.from) * i / LOOKS, &row);
            for (c = 0; c < x->n_columns && row.at.status == FOURLINK_OK; c++) {
                flk_tracked *t = &x->columns[c];
                double value = flk_column_value(t->c, &row);

                if (t->turn > 0 || t->is_noise || !(fabs(value) < t->bound))
                    continue;
                t->known[0] = GSL_MAX_DBL(t->known[0], value);
                t->known[1] = GSL_MIN_DBL(t->known[1], value);
            }
        }
    memset(&x->piece, 0, sizeof x->piece);
}

static void start(flk_search *x, const flk_extreme_pair *pairs, double *memory)
{
    size_t c;

    x->s = memory;
    x->values = memory + FLK_SEARCH_MOST_SAMPLES;
    x->columns = (flk_tracked *)(void *)(x->values + FLK_SEARCH_MOST_SAMPLES * x->n_columns);
    flk_search_begin(x);
    x->needs = 0;
    x->n = 0;
    x->a->is_fast = 1;
    x->is_cut = 0;
    x->has_noise = 0;
    for (c = 0; c < x->n_columns; c++) {
        flk_tracked *t = &x->columns[c];

        flk_search_track(x, t, &pairs[c].c);
        x->needs |= flk_column_need(t->c);
        x->motion.has_loads |= !flk_column_is_of_motion(t->c);
        x->has_noise |= t->is_noise;
    }
    if (x->a->course.actual)
        look_ahead(x);
}

/* Give the angle of a corner in place of one just inside it, unless a load jumps there. */
static void settle(const flk_search *x, flk_tracked *t, int which)
{
    flk_found *f = &t->best[which];
    double value, close = 1e-10 * fabs(f->value);
    flk_row row;

    if (!f->is_there || f->corner == f->angle || !gsl_finite(f->value))
        return;
    flk_search_row_at(x, flk_column_need(t->c), f->corner, &row);
    value = flk_column_value(t->c, &row);
    if (t->turn > 0)
        value = flk_search_nearest(t, value, f->value);
    if (fabs(value) >= t->bound)
        value = f->value > 0 ? GSL_POSINF : GSL_NEGINF;
    if (flk_search_signed(which, value) < flk_search_signed(which, f->value) - close)
        return;
    f->angle = f->corner;
    if (!gsl_isnan(value))
        f->value = value;
}

#define NOISE 1e-10 /* of a column's size: what a constant one varies by near a change point */

/* A column that is constant but for rounding has its extremes at the first row. */
static void settle_constant(const flk_search *x, flk_tracked *t)
{
    flk_found *max = &t->best[0], *min = &t->best[1];
    double first = x->from, value;
    flk_row row;

    if (!max->is_there || !min->is_there || !gsl_finite(max->value) ||
        !(max->value - min->value <= NOISE * fabs(max->value)))
        return;
    flk_search_row_at(x, flk_column_need(t->c), first, &row);
    value = flk_column_value(t->c, &row);
    if (t->turn > 0)
        value = flk_search_nearest(t, value, max->value);
    if (row.at.status == FOURLINK_CHANGE_POINT ||
        fabs(value - max->value) <= NOISE * fabs(max->value))
        max->angle = min->angle = first;
}

/* The displacement of a piston is the difference of two lengths: its least value is 0 but for rounding. */
static void settle_zero(const flk_search *x, flk_tracked *t, int which)
{
    double length = x->a->d->machine.mechanism.dead_centre * t->c->scale;

    if (strcmp(t->c->name, "x") == 0 && fabs(t->best[which].value) < 4 * GSL_DBL_EPSILON * length)
        t->best[which].value = 0;
}

static void give(const flk_search *x, const flk_found *f, flk_extreme *extreme)
{
    extreme->is_there = f->is_there;
    extreme->value = f->value;
    extreme->angle = flk_search_crank(x, f->angle);
}

/* They are not known: the search took too many rows, or the motion too many steps. */
static void give_up(flk_search *x, int status, flk_extreme_pair *pairs)
{
    size_t c;

    for (c = 0; c < x->n_columns; c++) {
        pairs[c].max.is_there = pairs[c].min.is_there = 0;
        pairs[c].status = status;
    }
    x->a->is_fast = 0;
}

/* The last row of a revolution is its first: after a gap angles are moved by whole turns to agree with it. */
static void finish(flk_search *x, int has_gap, flk_extreme_pair *pairs)
{
    size_t c;

    for (c = 0; c < x->n_columns; c++) {
        flk_tracked *t = &x->columns[c];
        double shift = 0;
        int which;

        if (has_gap && t->turn > 0 && flk_course_is_periodic(&x->a->course) &&
            !gsl_isnan(t->first + t->last))
            shift = flk_search_turns(t, t->last, t->first);
        flk_search_commit(t, shift);
        for (which = 0; which < 2; which++) {
            settle(x, t, which);
            if (fabs(t->best[which].value) >= t->bound)
                t->best[which].value = t->best[which].value > 0 ? GSL_POSINF : GSL_NEGINF;
            settle_zero(x, t, which);
        }
        settle_constant(x, t);
        pairs[c].status = FOURLINK_OK;
        give(x, &t->best[0], &pairs[c].max);
        give(x, &t->best[1], &pairs[c].min);
    }
    x->a->is_fast = 0;
}

/* Find the extremes of n columns on a branch. */
static void find(flk_analysis *a, fourlink_branch branch, flk_extreme_pair *pairs, size_t n,
                 double *memory)
{
    int has_gap = 0;
    flk_search x;
    size_t c;

    x.a = a;
    x.branch = branch;
    x.n_columns = n;
    if (flk_course_stops(&a->course, branch)) {
        give_up(&x, FOURLINK_TOO_LONG, pairs);
        return;
    }
    start(&x, pairs, memory);
    if (x.motion.length <= 0) {
        x.low = x.high = 0;
        flk_search_sample(&x, 0);
        search_samples(&x);
    }
    while (!flk_search_is_over(&x) && flk_search_next(&x)) {
        int reached = flk_search_is_reached(&x);

        search_piece(&x, reached);
        for (c = 0; c < n; c++)
            if (!reached && x.columns[c].turn > 0 &&
                !(flk_column_flags(x.columns[c].c) & FOURLINK_OF_CRANK)) {
                flk_search_commit(&x.columns[c], 0);
                x.columns[c].last = GSL_NAN;
                x.columns[c].restarts = 1;
            } else if (a->course.actual) {
                flk_search_commit(&x.columns[c], 0);
            }
        has_gap |= !reached;
        if (x.skipped > 0 && fabs(x.piece.to - x.motion.period) < 1e-6)
            skip_turns(&x);
    }
    if (!flk_search_is_over(&x))
        finish(&x, has_gap, pairs);
    if (flk_search_is_over(&x))
        give_up(&x, FOURLINK_LONG_SEARCH, pairs);
}

/* ------------------------------------------------------------------------------------- the asked for */

int flk_extremes_open(flk_extremes *x, size_t most)
{
    size_t numbers =
        FLK_SEARCH_MOST_SAMPLES * (most + 1) + most * (sizeof(flk_tracked) / sizeof(double) + 1);

    x->pairs[0] = malloc(2 * (most + 1) * sizeof *x->pairs[0]);
    x->memory = malloc(numbers * sizeof *x->memory);
    if (!x->pairs[0] || !x->memory)
        return 0;
    x->pairs[1] = x->pairs[0] + most + 1;
    return 1;
}

void flk_extremes_close(flk_extremes *x)
{
    free(x->pairs[0]);
    free(x->memory);
}

static int is_same(const flk_column *x, const flk_column *y)
{
    if (x->info != y->info || x->link != y->link || x->spring != y->spring)
        return 0;
    return !x->link || (x->component == y->component && x->at.x == y->at.x && x->at.y == y->at.y);
}

void flk_extremes_ask(flk_extremes *x, const flk_column *c)
{
    size_t i;

    for (i = 0; i < x->n; i++)
        if (is_same(&x->pairs[0][i].c, c))
            return;
    x->pairs[0][x->n].c = x->pairs[1][x->n].c = *c;
    x->n++;
}

const flk_extreme_pair *flk_extremes_of(flk_extremes *x, flk_analysis *a, const flk_column *c,
                                        fourlink_branch branch)
{
    int k = branch == FOURLINK_OPEN ? 0 : 1;
    flk_extreme_pair *pairs = x->pairs[k];
    size_t i;

    for (i = 0; i < x->n && !is_same(&pairs[i].c, c); i++)
        ;
    if (i == x->n) {
        pairs[i].c = *c;
        find(a, branch, &pairs[i], 1, x->memory);
    } else if (!x->is_known[k]) {
        find(a, branch, pairs, x->n, x->memory);
        x->is_known[k] = 1;
    }
    return &pairs[i];
}
