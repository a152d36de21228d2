/* SPDX-License-Identifier: GPL-3.0-or-later
**
** group_limits.c - the stroke or swing of a group, over a turn of the crank.
**
** There is no closed form: its rate by theta2 is sampled, and between two samples of other signs base/solve
** finds its zero, where the group turns back.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/solve.h"
#include "base/trig.h"
#include "group.h"
#include "group_limits.h"
#include "mechanism.h"

#define SAMPLES 720 /* of a turn */
#define START 0.1   /* rad: not a dead centre of a symmetric mechanism */

typedef struct search {
    const fourlink_mechanism *mechanism;
    fourlink_branch branch;
    int group;
    double last;   /* the value before, to which an angle goes on */
    int n_returns; /* places where the rate changes its sign */
} search;

/* The place of the slider along its line, or the angle of the rocker, and its rate by theta2; NaN where
** the mechanism cannot be assembled. */
static double value_at(const search *x, double theta2, double *rate)
{
    const fourlink_group *g = &x->mechanism->design.group[x->group];
    fourlink_crank crank = {0, 1, 0};
    const fourlink_link_state *end;
    fourlink_vector r;
    fourlink_state state;

    *rate = GSL_NAN;
    crank.theta2 = theta2;
    if (flk_mechanism_move(x->mechanism, x->branch, &crank, 1, &state) != FOURLINK_OK)
        return GSL_NAN;
    end = &state.link[FOURLINK_END_OF(x->group)];
    if (g->end == FOURLINK_GROUP_TURNS) {
        *rate = end->omega;
        return end->theta;
    }
    r.x = end->origin.x - g->pivot.x;
    r.y = end->origin.y - g->pivot.y;
    *rate = FLK_DOT(g->direction, end->velocity);
    return FLK_DOT(g->direction, r);
}

static double output_rate_at(double theta2, void *data)
{
    double rate;

    value_at(data, theta2, &rate);
    return rate;
}

#define AT_START 1e-13 /* rad: beside 0, which is a dead centre of many */

/* Take a place where the group turns back. */
static void take(search *x, double theta2, double value, flk_group_limits *limits)
{
    theta2 = flk_cycle_place(theta2, 0, 2 * M_PI);
    if (theta2 < AT_START || theta2 > 2 * M_PI - AT_START)
        theta2 = 0;
    x->n_returns++;
    if (value < limits->least) {
        limits->least = value;
        limits->least_at = theta2;
    }
    if (value > limits->most) {
        limits->most = value;
        limits->most_at = theta2;
    }
}

/* A value that goes on from the one before. */
static double go_on(search *x, double value)
{
    if (x->mechanism->design.group[x->group].end == FOURLINK_GROUP_TURNS)
        value = x->last + flk_cycle_beside(value - x->last, 2 * M_PI);
    return x->last = value;
}

int flk_group_limits_find(const fourlink_mechanism *mechanism, fourlink_branch branch, int group,
                          flk_group_limits *limits)
{
    double first, before, rate, zero, turn;
    int is_rocker, i;
    search x;

    x.mechanism = mechanism;
    x.branch = branch;
    x.group = group;
    x.n_returns = 0;
    limits->least = GSL_POSINF;
    limits->most = GSL_NEGINF;
    first = x.last = value_at(&x, START, &before);
    for (i = 1; i <= SAMPLES; i++) {
        double theta2 = START + 2 * M_PI * i / SAMPLES, value = value_at(&x, theta2, &rate), unused;

        if (before * rate < 0 || (rate == 0 && before != 0)) {
            flk_bracket b = flk_bracket_of(theta2 - 2 * M_PI / SAMPLES, theta2, before, rate);

            zero = rate == 0 ? theta2 : flk_find_zero(output_rate_at, &x, &b, 0);
            take(&x, zero, go_on(&x, value_at(&x, zero, &unused)), limits);
        }
        go_on(&x, value);
        before = rate != 0 ? rate : -before; /* a zero at a sample has been taken */
    }
    is_rocker = mechanism->design.group[group].end == FOURLINK_GROUP_TURNS;
    if (x.n_returns < 2 || (is_rocker && fabs(x.last - first) > M_PI))
        return 0;
    turn = fabs(limits->most_at - limits->least_at);
    turn = GSL_MAX_DBL(turn, 2 * M_PI - turn);
    limits->time_ratio = x.n_returns == 2 ? turn / (2 * M_PI - turn) : 0;
    if (is_rocker) {
        turn = flk_cycle_beside(limits->least, 2 * M_PI) - limits->least;
        limits->least += turn;
        limits->most += turn;
    }
    return 1;
}
