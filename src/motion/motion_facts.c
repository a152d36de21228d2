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

#include <gsl/gsl_math.h>

#include "motion_facts.h"
#include "mechanics/mechanics.h"

void flk_facts_forget(flk_actual_facts *f)
{
    f->status = f->no_cycle = FOURLINK_OK;
    f->end_angle = f->mean_speed = f->mean_speed_textbook = f->period = f->fluctuation_exact =
        f->steady_rate = f->stall_angle = f->run_up_time = f->motor_torque = f->flywheel =
            f->inertia = FLK_UNDEFINED;
}

static void widen(const flk_node *node, double part, double *least, double *most)
{
    flk_node at;

    flk_node_within(node, part, &at);
    *least = GSL_MIN(*least, at.y[FLK_SPEED]);
    *most = GSL_MAX(*most, at.y[FLK_SPEED]);
}

/* The smallest and the largest speed from a time to the end.  Within a step there may be two peaks, so its
** halves are searched. */
static void find_range(const flk_path *p, double t, double *least, double *most)
{
    const flk_node *node, *end = flk_path_end(p);

    *least = GSL_POSINF;
    *most = 0;
    for (node = p->node; node < end; node++)
        if (node[1].t > t) {
            double from = GSL_MAX(0, (t - node->t) / node->h), to = (node[1].t - node->t) / node->h;
            double middle = 0.5 * (from + to);

            widen(node, from, least, most);
            widen(node, flk_node_peak(node, from, middle), least, most);
            widen(node, flk_node_peak(node, middle, to), least, most);
            widen(node, to, least, most);
        }
}

void flk_facts_of_cycle(const flk_path *p, double cycle, flk_actual_facts *f)
{
    const flk_node *end = flk_path_end(p);
    double from = GSL_MAX(0, end->y[FLK_PASSED] - cycle), least, most;
    flk_node first;

    if (!(end->y[FLK_PASSED] > 0) || flk_path_node_at(p, from, &first) != FOURLINK_OK)
        return;
    find_range(p, first.t, &least, &most);
    f->period = end->t - first.t;
    f->mean_speed = p->equation.sense * (end->y[FLK_PASSED] - from) / f->period;
    f->mean_speed_textbook = p->equation.sense * 0.5 * (least + most);
    f->fluctuation_exact = (most - least) / fabs(f->mean_speed);
    if (p->is_steady)
        f->steady_rate = exp(flk_path_growth(p));
}

void flk_facts_of_run_up(const flk_path *p, flk_actual_facts *f)
{
    double speed = p->equation.sense * f->mean_speed;
    const flk_node *node;
    flk_node at;

    for (node = p->node; node < flk_path_end(p); node++)
        if (node[1].y[FLK_SPEED] >= speed) {
            double most = (node[1].t - node->t) / node->h;

            flk_node_within(node, flk_node_part(node, FLK_SPEED, speed, most), &at);
            f->run_up_time = at.t;
            return;
        }
}
