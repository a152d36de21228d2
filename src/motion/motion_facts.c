/* SPDX-License-Identifier: GPL-3.0-or-later
**
** motion_facts.c - facts of the actual motion: mean speed, fluctuation, rate, time of a run-up.
**
**    mean speed    cycle / period, the mean over time, as a tachometer shows it
**    textbooks'    (largest + smallest) / 2
**    fluctuation   (largest - smallest) / mean speed
**    rate          exp(integral of d(T_m + Q)/d(omega2) / ((J + I_f) omega2) dtheta2 over a cycle)
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "motion_facts.h"
#include "base/solve.h"
#include "mechanics/mechanics.h"

void flk_facts_forget(flk_actual_facts *f)
{
    f->status = f->no_cycle = FOURLINK_OK;
    f->end_angle = f->mean_speed = f->mean_speed_textbook = f->period = f->fluctuation_exact =
        f->steady_rate = f->stall_angle = f->run_up_time = f->motor_torque = f->flywheel =
            f->inertia = FLK_UNDEFINED;
}

/* Speed and acceleration in the sense of the motion. */
typedef struct sample {
    double s, speed, alpha, time;
} sample;

/* The sample at s, also at a change point, where there is no row. */
static int take_sample(const flk_path *p, double s, sample *at)
{
    flk_equation e = p->equation;
    double dy[FLK_UNKNOWNS];
    flk_node node;

    if (flk_path_node_at(p, s, &node) != FOURLINK_OK ||
        flk_equation_derive(&e, node.t, node.y, dy) != FOURLINK_OK)
        return 0;
    at->s = s;
    at->speed = node.y[FLK_SPEED];
    at->alpha = dy[FLK_SPEED];
    at->time = node.t;
    return 1;
}

/* The function whose zero is sought: the acceleration, or the speed minus a value. */
typedef struct goal {
    const flk_path *p;
    int of_speed;
    double speed;
    sample at; /* the sample last taken */
} goal;

static double value_of(const goal *g, const sample *at)
{
    return g->of_speed ? at->speed - g->speed : at->alpha;
}

static double value_at(double s, void *data)
{
    goal *g = data;

    return take_sample(g->p, s, &g->at) ? value_of(g, &g->at) : GSL_NAN;
}

/* A zero between two samples whose values differ in sign. */
static void find_sample(goal *g, const sample *low, const sample *high, sample *at)
{
    flk_bracket b = flk_bracket_of(low->s, high->s, value_of(g, low), value_of(g, high));

    g->at = *low;
    flk_find_zero(value_at, g, &b,
                  g->of_speed ? 1e-15 * g->speed : 1e-9 * GSL_MAX(fabs(b.f_low), fabs(b.f_high)));
    *at = g->at;
}

static void widen(const sample *at, double *least, double *most)
{
    *least = GSL_MIN(*least, at->speed);
    *most = GSL_MAX(*most, at->speed);
}

/* The smallest and the largest speed from s to the end: at the ends of steps, or where the acceleration is 0
** between them.  Within a step it may be 0 twice, so the middle is checked too. */
static int find_range(const flk_path *p, double s, double *least, double *most)
{
    goal extreme;
    sample last, now, between;
    size_t k;
    int half;

    memset(&extreme, 0, sizeof extreme);
    extreme.p = p;
    if (!take_sample(p, s, &last))
        return 0;
    *least = *most = last.speed;
    for (k = 0; k + 1 < p->n; k++)
        for (half = 1; half <= 2; half++) {
            double from = p->node[k].y[FLK_PASSED], to = p->node[k + 1].y[FLK_PASSED];

            if (half == 1 ? 0.5 * (from + to) <= s : to <= s)
                continue;
            if (!take_sample(p, half == 1 ? 0.5 * (from + to) : to, &now))
                return 0;
            widen(&now, least, most);
            if ((last.alpha < 0) != (now.alpha < 0)) {
                find_sample(&extreme, &last, &now, &between);
                widen(&between, least, most);
            }
            last = now;
        }
    return 1;
}

void flk_facts_of_cycle(const flk_path *p, double cycle, flk_actual_facts *f)
{
    const flk_node *end = flk_path_end(p);
    double from = GSL_MAX(0, end->y[FLK_PASSED] - cycle), least, most;
    sample first;

    if (!(end->y[FLK_PASSED] > 0) || !take_sample(p, from, &first) ||
        !find_range(p, from, &least, &most))
        return;
    f->period = end->t - first.time;
    f->mean_speed = p->equation.sense * (end->y[FLK_PASSED] - from) / f->period;
    f->mean_speed_textbook = p->equation.sense * 0.5 * (least + most);
    f->fluctuation_exact = (most - least) / fabs(f->mean_speed);
    if (p->is_steady)
        f->steady_rate = exp(flk_path_growth(p));
}

void flk_facts_of_run_up(const flk_path *p, flk_actual_facts *f)
{
    goal reached;
    sample last, now;
    size_t k;

    reached.p = p;
    reached.of_speed = 1;
    reached.speed = p->equation.sense * f->mean_speed;
    for (k = 0; k < p->n && take_sample(p, p->node[k].y[FLK_PASSED], &now); k++) {
        if (k > 0 && now.speed >= reached.speed) {
            find_sample(&reached, &last, &now, &now);
            f->run_up_time = now.time;
            return;
        }
        last = now;
    }
}
