/* SPDX-License-Identifier: GPL-3.0-or-later
**
** group_ends.c - the crank angles at which the groups of a mechanism begin or cease to be assembled.
**
** There is no closed form: the margin of the groups is sampled over the ranges in which the four links can
** be assembled, more closely towards their ends, where it can change as the root of the distance.  Between
** two samples of other signs base/solve finds its zero.  Where three samples of one sign show a peak
** towards 0, the peak is found first, as two zeros may be beside it.  A slot of a link turns through the
** line of a slider: there the margin only touches 0, and the sine itself changes its sign.
*/
#include <math.h>

#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>

#include "base/cycle.h"
#include "base/solve.h"
#include "group.h"

#define SAMPLES 720 /* of a turn */
#define NEAR 0.5    /* of a sample: a peak that may pass it towards 0 */

typedef struct search {
    fourlink_mechanism bare; /* without groups */
    const fourlink_mechanism *mechanism;
    fourlink_branch branch;
    int group;   /* whose sine is searched */
    double sign; /* of the margin about a peak */
    double period, *list;
    size_t n, most;
} search;

static double margin_at(double theta2, void *data)
{
    search *x = data;
    fourlink_crank crank = {0, 0, 0};
    fourlink_state state;

    crank.theta2 = theta2;
    if (fourlink_analyse_dyad(&x->bare, x->branch, &crank, NULL, 0, &state, NULL) != FOURLINK_OK)
        return GSL_NAN;
    return flk_groups_margin(x->mechanism, &state);
}

/* Its negative distance from 0, which has a peak where the margin comes near to 0. */
static double nearness_at(double theta2, void *data)
{
    search *x = data;

    return -x->sign * margin_at(theta2, x);
}

static void take_zero(search *x, const flk_sample *a, const flk_sample *b)
{
    flk_bracket bracket = flk_bracket_of(a->x, b->x, a->value, b->value);

    if (x->n < x->most && a->value * b->value <= 0 && a->value != b->value)
        x->list[x->n++] = flk_cycle_place(flk_find_zero(margin_at, x, &bracket, 0), 0, x->period);
}

/* The zeros beside a peak towards 0 between three samples of one sign. */
static void take_peak(search *x, const flk_sample p[3])
{
    flk_sample turned[3], top;
    double bend = p[0].value - 2 * p[1].value + p[2].value, slope = p[2].value - p[0].value;
    int i;

    x->sign = p[1].value > 0 ? 1 : -1;
    if (!(x->sign * bend > 0) || !(x->sign * p[1].value <= x->sign * p[0].value) ||
        !(x->sign * p[1].value <= x->sign * p[2].value) ||
        !(slope * slope / (8 * fabs(bend)) > NEAR * fabs(p[1].value)))
        return;
    for (i = 0; i < 3; i++) {
        turned[i].x = p[i].x;
        turned[i].value = -x->sign * p[i].value;
    }
    top = flk_find_peak(nearness_at, x, turned, 0);
    top.value *= -x->sign;
    take_zero(x, &p[0], &top);
    take_zero(x, &top, &p[2]);
}

/* The sine of a slider in a slot of the carrying link, of the slot to its line. */
static double sine_at(double theta2, void *data)
{
    search *x = data;
    const fourlink_group *g = &x->mechanism->design.group[x->group];
    fourlink_mechanism before = *x->mechanism;
    fourlink_crank crank = {0, 0, 0};
    fourlink_state state;
    fourlink_vector e;

    crank.theta2 = theta2;
    before.design.n_groups = x->group;
    if (fourlink_analyse_dyad(&before, x->branch, &crank, NULL, 0, &state, NULL) != FOURLINK_OK)
        return GSL_NAN;
    FLK_TURN(e, &state.link[g->link], g->slot);
    return FLK_CROSS(g->direction, e);
}

#define IS_IN_SLOT(g) ((g)->hang == FOURLINK_HANGS_IN_SLOT && (g)->end == FOURLINK_GROUP_SLIDES)

/* Take where slots turn through the line of their slider.  At a dead position itself there is no row. */
#define INSIDE 1e-10 /* rad */

static void search_sines(search *x, double from, double to)
{
    int n = (int)ceil(SAMPLES * (to - from) / (2 * M_PI)) + 8, i;

    for (x->group = 0; x->group < x->mechanism->design.n_groups; x->group++) {
        const fourlink_group *g = &x->mechanism->design.group[x->group];
        double before = GSL_NAN, last = from;

        for (i = 0; i <= n && IS_IN_SLOT(g); i++) {
            double at = GSL_MAX(from + INSIDE, GSL_MIN(from + (to - from) * i / n, to - INSIDE));
            double sine = sine_at(at, x);

            if (before * sine < 0 && x->n < x->most) {
                flk_bracket bracket = flk_bracket_of(last, at, before, sine);

                x->list[x->n++] =
                    flk_cycle_place(flk_find_zero(sine_at, x, &bracket, 0), 0, x->period);
            }
            if (sine != 0) { /* a zero at a sample is found between its neighbours */
                before = sine;
                last = at;
            }
        }
    }
}

/* A whole turn has one more sample, for the peaks about its first and last angle. */
static void search_range(search *x, double from, double to, int is_whole)
{
    int n = (int)ceil(SAMPLES * (to - from) / (2 * M_PI)) + 8, i;
    flk_sample p[3];

    p[0].value = p[1].value = GSL_NAN;
    p[0].x = p[1].x = from;
    for (i = 0; i <= n + is_whole; i++) {
        double part = (double)i / n;

        p[2].x = from + (to - from) * (is_whole ? part : (1 - cos(M_PI * part)) / 2);
        p[2].value = margin_at(p[2].x, x);
        if (i <= n && p[1].value * p[2].value < 0)
            take_zero(x, &p[1], &p[2]);
        else if (p[0].value * p[1].value > 0)
            take_peak(x, p);
        p[0] = p[1];
        p[1] = p[2];
    }
}

int flk_groups_apart(const fourlink_mechanism *mechanism, fourlink_branch branch, double theta2)
{
    fourlink_mechanism some = *mechanism;
    fourlink_crank crank = {0, 0, 0};
    fourlink_state state;

    crank.theta2 = theta2;
    for (some.design.n_groups = 0; some.design.n_groups < mechanism->design.n_groups;) {
        some.design.n_groups++;
        if (fourlink_analyse_dyad(&some, branch, &crank, NULL, 0, &state, NULL) != FOURLINK_OK)
            return some.design.n_groups - 1;
    }
    return -1;
}

static void set_up(search *x, const fourlink_mechanism *mechanism, fourlink_branch branch,
                   double period, double *list, size_t most)
{
    x->bare = *mechanism;
    x->bare.design.n_groups = 0;
    x->mechanism = mechanism;
    x->branch = branch;
    x->period = period;
    x->list = list;
    x->n = 0;
    x->most = most;
}

#define BEYOND 1e-9 /* a sine */

int flk_groups_are_beyond(const fourlink_mechanism *mechanism, fourlink_branch branch,
                          double theta2)
{
    search x;

    set_up(&x, mechanism, branch, 2 * M_PI, NULL, 0);
    for (x.group = 0; x.group < mechanism->design.n_groups; x.group++)
        if (IS_IN_SLOT(&mechanism->design.group[x.group]) && fabs(sine_at(theta2, &x)) < BEYOND)
            return 1;
    return 0;
}

#define IS_TURN(reach, i) ((reach).to[i] - (reach).from[i] >= 2 * M_PI * (1 - 1e-15))

/* A margin that touches 0 is found there, too, up to its rounding error: then an end stands twice. */
#define SAME 1e-7 /* rad */

static size_t drop_repeated(double *list, size_t n)
{
    size_t kept = 0, i;

    for (i = 0; i < n; i++)
        if (kept == 0 || list[i] - list[kept - 1] > SAME)
            list[kept++] = list[i];
    return kept;
}

size_t flk_groups_ends(const fourlink_mechanism *mechanism, fourlink_branch branch, double period,
                       double *list, size_t most)
{
    fourlink_reach reach;
    search x;
    int i;

    set_up(&x, mechanism, branch, period, list, most);
    if (!mechanism->design.n_groups || fourlink_reach_of(mechanism, &reach) != FOURLINK_OK)
        return 0;
    for (i = 0; i < reach.n_ranges; i++) {
        double from = IS_TURN(reach, i) ? 1e-3 : reach.from[i];
        double to = IS_TURN(reach, i) ? period + 1e-3 : reach.to[i];

        search_range(&x, from, to, IS_TURN(reach, i));
        search_sines(&x, from, to);
    }
    gsl_sort(list, 1, x.n);
    return drop_repeated(list, x.n);
}

int flk_groups_come_back(const fourlink_mechanism *mechanism, fourlink_branch branch)
{
    fourlink_reach reach;
    double end;
    search x;

    if (mechanism->change_folded || mechanism->change_stretched ||
        fourlink_reach_of(mechanism, &reach) != FOURLINK_OK || reach.n_ranges != 1 ||
        !IS_TURN(reach, 0) || flk_groups_ends(mechanism, branch, 2 * M_PI, &end, 1))
        return 0;
    set_up(&x, mechanism, branch, 2 * M_PI, NULL, 0);
    return margin_at(M_PI, &x) > 0;
}

/* Add the ranges between `from` and `to` in which all is assembled, cut at the ends that are there. */
static size_t add_ranges(search *x, const double *ends, size_t n_ends, double from, double to,
                         flk_range *list, size_t n, size_t most)
{
    double begin = from, end;
    size_t i;

    for (i = 0; i <= n_ends; i++) {
        end = to;
        if (i < n_ends) {
            end = flk_cycle_place(ends[i], from, 2 * M_PI);
            if (!(end > begin && end < to))
                continue;
        }
        if (n < most && margin_at(0.5 * (begin + end), x) > 0) {
            double turn = end > 2 * M_PI * (1 + 1e-15) ? 2 * M_PI : 0;

            list[n].from = begin - turn;
            list[n++].to = end - turn;
        }
        begin = end;
    }
    return n;
}

size_t flk_groups_ranges(const fourlink_mechanism *mechanism, fourlink_branch branch,
                         flk_range *list, size_t most)
{
    double ends[FLK_GROUPS_ENDS], inside[FLK_GROUPS_ENDS];
    size_t n_ends = flk_groups_ends(mechanism, branch, 2 * M_PI, ends, FLK_GROUPS_ENDS), n = 0, k;
    fourlink_reach reach;
    search x;
    int i;

    set_up(&x, mechanism, branch, 2 * M_PI, NULL, 0);
    if (fourlink_reach_of(mechanism, &reach) != FOURLINK_OK)
        return 0;
    for (i = 0; i < reach.n_ranges; i++) {
        double from = IS_TURN(reach, i) && n_ends ? ends[0] : reach.from[i];
        double to = IS_TURN(reach, i) ? from + 2 * M_PI : reach.to[i];

        for (k = 0; k < n_ends; k++)
            inside[k] = flk_cycle_place(ends[k], from, 2 * M_PI);
        gsl_sort(inside, 1, n_ends);
        n = add_ranges(&x, inside, n_ends, from, to, list, n, most);
    }
    return n;
}
