/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual.c - the actual motion of the machine: crank speed, acceleration and time from torques and inertia.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "actual.h"
#include "steady.h"
#include "base/cycle.h"
#include "mechanics/inertia.h"
#include "mechanics/mechanics.h"

#define TOLERANCE 1.5e-13 /* of a step: 1e-11 over many */
/* Trial steps of a motion; of a run-up, of the steady motion with the search for it.
** Each that is kept takes 240 bytes. */
#define MOST_STEPS 80000
#define MOST_STEPS_OF_SEARCH 160000

/* The motion of one branch. */
typedef struct on_branch {
    flk_path path;
    flk_actual_facts facts;
    int is_found; /* 1: it is integrated; 0: not yet, or memory failed */
    int is_known; /* 1: all facts; 0: those of the cycle, which only other facts need, are missing */
} on_branch;

struct flk_actual {
    const deck *d;
    int winds; /* 1: there is no steady motion */
    on_branch of[2];
    double cycle;  /* rad */
    double length; /* rad, of the rows */
};

/* A run-up, or a free motion. */
static int run_free(flk_path *p, const deck *d, double length)
{
    double speed = d->mode.kind == MODE_FREE ? p->equation.sense * d->motion.speed : 0;

    if (speed < 0) {
        p->n = 0;
        p->status = FOURLINK_DOES_NOT_START;
        return 0;
    }
    return flk_path_run(p, speed, length);
}

/* By time: the sense of the motion is that in which the crank starts. */
static int run_for(flk_path *p, const deck *d)
{
    double speed = d->mode.kind == MODE_FREE ? d->motion.speed : 0;
    flk_actual_row first;
    flk_node node;

    memset(&node, 0, sizeof node);
    p->equation.sense = speed < 0 ? -1 : 1;
    p->n = 0;
    p->status = flk_path_row(p, &node, &first);
    if (p->status == FOURLINK_OK && speed == 0 && first.crank.alpha2 < 0)
        p->equation.sense = -1;
    if (p->status == FOURLINK_OK && d->mode.kind == MODE_RUN_UP && first.crank.alpha2 == 0)
        p->status = FOURLINK_DOES_NOT_START;
    return p->status == FOURLINK_OK && flk_path_run_for(p, speed, d->mode.duration);
}

static int find_steady(const flk_actual *m, flk_path *p, double mean_speed, double fluctuation)
{
    p->status = FOURLINK_NO_STEADY;
    return !m->winds && flk_steady_find(p, m->cycle, mean_speed, fluctuation);
}

static int find_actual(const flk_actual *m, flk_path *p)
{
    const deck *d = p->d;

    if (d->mode.duration > 0)
        return run_for(p, d);
    if (d->mode.kind == MODE_STEADY)
        return find_steady(m, p, p->equation.sense * d->mode.mean_speed, d->mode.fluctuation);
    return run_free(p, d, m->length);
}

/* Angles in the deck's unit. */
static double angle_of(const flk_path *p, double s)
{
    const fourlink_motion *motion = &p->d->motion;

    return motion->from + p->equation.sense * s / motion->angle_unit;
}

/* The number of trial steps: fewer where steps take longer, with friction or many loads. */
static unsigned long budget_of(const flk_machine *machine, int mode)
{
    unsigned long n = machine->n_loads,
                  most = mode == MODE_FREE ? MOST_STEPS : MOST_STEPS_OF_SEARCH,
                  cost = 1 + n / 16 + (machine->has_friction ? 9 + n / 5 : 0);

    return most / cost;
}

static void integrate(flk_actual *m, fourlink_branch branch, on_branch *b)
{
    flk_path *p = &b->path;
    flk_actual_facts *f = &b->facts;
    int found;

    p->equation.branch = branch;
    p->tolerance = TOLERANCE;
    p->budget = budget_of(&p->equation.machine, m->d->mode.kind);
    p->no_memory = 0;
    flk_facts_forget(f);
    found = find_actual(m, p);
    f->flywheel = p->equation.machine.flywheel;
    f->inertia = flk_machine_shaft(&p->equation.machine);
    if (found)
        f->motor_torque = p->equation.machine.motor.ratio * p->equation.machine.motor.torque;
    else {
        f->status = p->status;
        f->end_angle = angle_of(p, p->n ? flk_path_end(p)->y[FLK_PASSED] : 0);
        f->stall_angle = f->status == FOURLINK_STALLS ? f->end_angle : FLK_UNDEFINED;
    }
    b->is_found = !p->no_memory;
    b->is_known = 0;
}

/* Find the facts of the steady motion that a run-up approaches; 0 if memory fails.  Two motions of a
** machine never have the same energy at the same angle.  A motion from rest that completes the first
** cycle has gained energy, so it gains energy in every later cycle too, and settles at the steady
** motion.  It stalls in the first cycle or never; rows that end earlier do not decide this.  A run-up
** that ends never reaches it, unless it merely needs too many steps. */
static int find_approached(const flk_actual *m, const on_branch *b, flk_actual_facts *f)
{
    flk_path p = b->path;
    flk_actual_facts found = *f;

    if (f->status != FOURLINK_OK && f->status != FOURLINK_TOO_LONG) {
        f->no_cycle = f->status;
        return 1;
    }
    p.node = NULL;
    p.n = p.room = 0;
    p.budget = budget_of(&p.equation.machine, MODE_RUN_UP);
    if (find_steady(m, &p, 0, 0))
        flk_facts_of_cycle(&p, m->cycle, &found);
    else
        found.no_cycle = p.status;
    if (found.no_cycle == FOURLINK_OK && m->length < m->cycle && !run_free(&p, p.d, m->cycle) &&
        p.status != FOURLINK_TOO_LONG) {
        found = *f;
        found.no_cycle = p.status;
    }
    free(p.node);
    if (!p.no_memory)
        *f = found;
    return !p.no_memory;
}

/* The motion of a branch, integrated if necessary. */
static on_branch *on(flk_actual *m, fourlink_branch branch)
{
    on_branch *b = &m->of[branch == FOURLINK_OPEN ? 0 : 1];

    if (!b->is_found)
        integrate(m, branch, b);
    return b;
}

/* Complete the facts of a motion that is found; 0 if memory fails. */
static int find_facts(const flk_actual *m, on_branch *b)
{
    const deck *d = m->d;
    flk_actual_facts *f = &b->facts;

    if (d->mode.duration > 0)
        return 1;
    if (d->mode.kind == MODE_RUN_UP && !find_approached(m, b, f))
        return 0;
    if (f->status != FOURLINK_OK)
        return 1;
    if (d->mode.kind == MODE_RUN_UP)
        flk_facts_of_run_up(&b->path, f);
    else if (d->mode.kind == MODE_STEADY || m->length >= m->cycle * (1 - 1e-12))
        flk_facts_of_cycle(&b->path, m->cycle, f);
    return 1;
}

int flk_actual_prepare(flk_actual *m, fourlink_branch branch, int has_facts)
{
    on_branch *b = m ? on(m, branch) : NULL;

    if (b && b->is_found && has_facts && !b->is_known)
        b->is_known = find_facts(m, b);
    return !b || (b->is_found && (b->is_known || !has_facts)) ? FOURLINK_OK : FOURLINK_NO_MEMORY;
}

flk_actual *flk_actual_open(const deck *d, flk_corners *corners, flk_acting *acting, double end,
                            double period, int winds)
{
    const fourlink_motion *motion = &d->motion;
    flk_actual *m = calloc(1, sizeof *m);
    int i;

    if (!m)
        return NULL;
    m->d = d;
    m->winds = winds;
    m->cycle = period;
    m->length = fabs(end - motion->from) * motion->angle_unit;
    for (i = 0; i < 2; i++) {
        flk_path *p = &m->of[i].path;

        p->d = d;
        p->corners = corners;
        p->equation.machine = d->machine;
        p->equation.acting = acting;
        p->equation.from = flk_motion_theta2(motion, motion->from);
        p->equation.sense = end < motion->from ? -1 : 1;
    }
    return m;
}

void flk_actual_free(flk_actual *m)
{
    if (m) {
        free(m->of[0].path.node);
        free(m->of[1].path.node);
    }
    free(m);
}

double flk_actual_length(flk_actual *m, fourlink_branch branch)
{
    const on_branch *b = on(m, branch);

    return b->facts.status != FOURLINK_OK && b->path.n > 1 && m->d->mode.kind != MODE_STEADY
               ? flk_path_end(&b->path)->y[FLK_PASSED]
               : m->length;
}

double flk_actual_travel(flk_actual *m, fourlink_branch branch)
{
    return flk_path_travel(&on(m, branch)->path);
}

double flk_actual_time(flk_actual *m, fourlink_branch branch)
{
    const flk_path *p = &on(m, branch)->path;

    return p->n ? flk_path_end(p)->t : 0;
}

int flk_actual_from_rest(const deck *d)
{
    return d->mode.kind == MODE_RUN_UP || (d->mode.kind == MODE_FREE && d->motion.speed == 0);
}

int flk_actual_at(flk_actual *m, fourlink_branch branch, double angle, flk_actual_row *row)
{
    const flk_path *p = &on(m, branch)->path;
    const fourlink_motion *motion = &m->d->motion;
    double s = p->equation.sense * (angle - motion->from) * motion->angle_unit, turns = 0;
    int status = on(m, branch)->facts.status;

    memset(row, 0, sizeof *row);
    row->angle = angle;
    row->crank.theta2 = flk_motion_theta2(motion, angle);
    if (p->swings)
        return flk_path_at(p, s, row);
    if (m->d->mode.kind == MODE_STEADY && status == FOURLINK_OK) {
        turns = flk_cycle_count(s, m->cycle);
        s = flk_cycle_place(s, 0, m->cycle);
    } else if (status != FOURLINK_OK && (m->d->mode.kind == MODE_STEADY || p->n == 0 ||
                                         s > flk_path_end(p)->y[FLK_PASSED] * (1 + 1e-14))) {
        return status;
    }
    status = flk_path_at(p, s, row);
    row->time += turns != 0 ? turns * flk_path_end(p)->t : 0;
    row->crank.theta2 = flk_motion_theta2(motion, angle);
    return status;
}

int flk_actual_at_time(flk_actual *m, fourlink_branch branch, double time, flk_actual_row *row)
{
    const flk_path *p = &on(m, branch)->path;
    double end = flk_actual_time(m, branch);
    int status = p->n ? FOURLINK_OK : p->status;

    memset(row, 0, sizeof *row);
    row->angle = GSL_NAN; /* where the crank is then is not known */
    row->time = time;
    if (status == FOURLINK_OK && time > end * (1 + 1e-14))
        status = p->status;
    if (status == FOURLINK_OK)
        status = flk_path_at_time(p, time, row);
    if (status == FOURLINK_OK)
        row->angle = (row->crank.theta2 + m->d->motion.x_at) / m->d->motion.angle_unit;
    return status;
}

const flk_actual_facts *flk_actual_facts_of(flk_actual *m, fourlink_branch branch)
{
    return m ? &on(m, branch)->facts : NULL;
}
