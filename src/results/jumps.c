/* SPDX-License-Identifier: GPL-3.0-or-later
**
** jumps.c - the crank angles at which a joint with friction stands still, so that its friction changes its sense: dead
** centres, limits of a rocker, positions in which two links turn alike; and those at which a load is at a point of a curve
** over another argument than the crank angle.
**
** Relative speeds and arguments are smooth in theta2 on each branch, at the speed with which the motion begins.  They are
** sampled twice a degree over a period, and base/solve finds the zero where the sign changes.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "deck/schema.h"
#include "jumps.h"
#include "mechanics/kind.h"

#define SAMPLES 720 /* of a turn */

/* A function of the crank angle whose zeros are wanted. */
typedef struct zero {
    int joint; /* 0 to 3: the relative speed in it; -1: an argument less a point of a curve */
    flk_variable over;
    double at; /* of the argument, in SI units */
} zero;

typedef struct search {
    const deck *d;
    fourlink_branch branch;
    double speed; /* rad/s, of the crank */
    zero *zeros;
    size_t n;
    double *last, *now;
} search;

static double value_of(const search *s, const zero *z, const fourlink_state *state)
{
    double x;

    if (z->joint >= 0)
        return flk_friction_speed(&s->d->machine.mechanism, state,
                                  &flk_kind_of(s->d->design.kind)->joint[z->joint]);
    x = flk_variable_value(state, z->over) - z->at;
    return z->over == FLK_THETA4 ? x - 2 * M_PI * floor(x / (2 * M_PI) + 0.5) : x;
}

/* 0 if there is no position. */
static int move(const search *s, double theta2, fourlink_state *state)
{
    fourlink_crank crank = {0, 0, 0};

    crank.theta2 = theta2;
    crank.omega2 = s->speed;
    return fourlink_analyse_dyad(&s->d->machine.mechanism, s->branch, &crank, NULL, 0, state,
                                 NULL) == FOURLINK_OK;
}

/* A function whose zero is sought. */
typedef struct sought {
    const search *s;
    const zero *z;
} sought;

static double value_at(double theta2, void *data)
{
    const sought *x = data;
    fourlink_state state;

    return move(x->s, theta2, &state) ? value_of(x->s, x->z, &state) : GSL_NAN;
}

/* The zero of function j between a sample and the one before it. */
static double find_angle(const search *s, size_t j, double before, double theta2)
{
    flk_bracket b = flk_bracket_of(before, theta2, s->last[j], s->now[j]);
    sought x;

    x.s = s;
    x.z = &s->zeros[j];
    return flk_find_zero(value_at, &x, &b, 0);
}

/* 1 if there is a zero between two values; an angle that goes over 180 deg has none. */
static int has_zero(const zero *z, double last, double now)
{
    return (last < 0) != (now < 0) &&
           !(z->joint < 0 && z->over == FLK_THETA4 && fabs(last - now) > M_PI);
}

/* Keep an angle; 0 when out of memory.  */
static int keep(flk_jumps *jumps, double theta2)
{
    if (jumps->n % 64 == 0) {
        double *more = realloc(jumps->theta2, (jumps->n + 64) * sizeof *more);

        if (!more)
            return 0;
        jumps->theta2 = more;
    }
    jumps->theta2[jumps->n++] = theta2;
    return 1;
}

static int search_branch(flk_jumps *jumps, search *s)
{
    size_t n = (size_t)floor(SAMPLES * jumps->period / (2 * M_PI) + 0.5), i, j;
    double step = jumps->period / (double)n;
    fourlink_state state;
    int was_there = 0;

    for (i = 0; i <= n; i++) {
        double theta2 = step * ((double)i - 0.37);
        int is_there = move(s, theta2, &state);

        for (j = 0; j < s->n && is_there; j++) {
            s->now[j] = value_of(s, &s->zeros[j], &state);
            if (was_there && has_zero(&s->zeros[j], s->last[j], s->now[j]) &&
                !keep(jumps, find_angle(s, j, theta2 - step, theta2)))
                return 0;
            s->last[j] = s->now[j];
        }
        was_there = is_there;
    }
    return 1;
}

static void add_curve(search *s, const curve *c, flk_variable over)
{
    size_t i;

    for (i = 0; i < c->n && over; i++, s->n++)
        if (s->zeros) {
            s->zeros[s->n].joint = -1;
            s->zeros[s->n].over = over;
            s->zeros[s->n].at = c->x[i];
        }
}

/* 1 if a load follows another variable than the crank angle, or has other values on the way back. */
static int has_law(const flk_machine *machine)
{
    const flk_element *e;
    size_t i;

    for (i = 0; (e = flk_machine_find(machine, &flk_own_sort, i)) != NULL; i++)
        if (e->needs_motion)
            return 1;
    return 0;
}

/* List the functions; without memory only their number.  A power of a speed has a corner where the speed is 0, and a
** load jumps there if it has other values on the way back. */
static void list_zeros(search *s)
{
    const deck *d = s->d;
    const flk_kind *kind = flk_kind_of(d->design.kind);
    const flk_element *e;
    size_t i;
    int joint;

    s->n = 0;
    for (joint = 1; joint < 4; joint++) {
        double friction = kind->joint[joint].slider ? d->machine.friction.guide
                                                    : d->machine.friction.circle[joint];

        if (!(friction > 0) && !(has_law(&d->machine) && joint >= 2))
            continue;
        if (s->zeros)
            s->zeros[s->n].joint = joint;
        s->n++;
    }
    for (i = 0; (e = flk_machine_find(&d->machine, &flk_own_sort, i)) != NULL; i++) {
        const flk_own_load *own = e->data;

        add_curve(s, &own->values.torque_curve, own->over);
        add_curve(s, &own->values.force_curve[0], own->over);
        add_curve(s, &own->back.torque_curve, own->over);
        add_curve(s, &own->back.force_curve[0], own->over);
    }
}

int flk_jumps_find(const deck *d, flk_jumps *jumps)
{
    int found;
    search s;

    if (!d->machine.has_friction && !has_law(&d->machine))
        return 1;
    memset(&s, 0, sizeof s);
    s.d = d;
    s.speed = d->motion.speed != 0 ? d->motion.speed : 1;
    jumps->period =
        2 * M_PI *
        (s.d->machine.mechanism.change_stretched != s.d->machine.mechanism.change_folded ? 2 : 1);
    list_zeros(&s);
    s.last = malloc((2 * s.n + 1) * sizeof *s.last);
    s.now = s.last + s.n;
    s.zeros = malloc((s.n + 1) * sizeof *s.zeros);
    if (s.zeros)
        list_zeros(&s);
    s.branch = FOURLINK_OPEN;
    found = s.zeros && s.last && search_branch(jumps, &s);
    s.branch = FOURLINK_CROSSED;
    found = found && search_branch(jumps, &s);
    free(s.zeros);
    free(s.last);
    return found;
}
