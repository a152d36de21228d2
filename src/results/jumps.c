/* SPDX-License-Identifier: GPL-3.0-or-later
**
** jumps.c - the crank angles at which a joint with friction stands still, so that its friction changes its sense: dead
** centres, limits of a rocker, positions in which two links turn alike; and those at which a speed is 0 that a load
** follows.
**
** The relative speeds for a unit crank speed are smooth in theta2 on each branch.  They are sampled twice a degree over a
** period, and a change of sign is halved down to rounding.
*/
#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_math.h>

#include "jumps.h"
#include "mechanics/kind.h"

#define SAMPLES 720 /* of a turn */
#define MOST 128
#define HALVINGS 60

/* Speeds of the joints A to D for a unit crank speed; 0 if there is no position. */
static int find_speeds(const deck *d, fourlink_branch branch, double theta2, double speed[4])
{
    const flk_kind *kind = flk_kind_of(d->design.kind);
    fourlink_crank crank = {0, 1, 0};
    fourlink_state state;
    int i;

    crank.theta2 = theta2;
    if (fourlink_analyse_dyad(&d->mechanism, branch, &crank, NULL, 0, &state, NULL) != FOURLINK_OK)
        return 0;
    speed[0] = 1;
    speed[1] = state.link[3].k - 1;
    speed[2] = state.link[4].k - state.link[3].k;
    speed[3] = state.link[4].k;
    for (i = 0; i < 4; i++)
        if (kind->joint[i].slider)
            speed[i] = i == 2 ? state.slide_v : state.v;
    return 1;
}

/* The zero of a speed between two angles at which it differs in sign. */
static double halve(const deck *d, fourlink_branch branch, int joint, double low, double high,
                    int is_negative)
{
    double speed[4];
    int i;

    for (i = 0; i < HALVINGS; i++) {
        double middle = 0.5 * (low + high);

        if (!find_speeds(d, branch, middle, speed))
            break;
        if ((speed[joint] < 0) == is_negative)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

static void search_branch(flk_analysis *a, fourlink_branch branch, const int wanted[4])
{
    double last[4] = {0, 0, 0, 0}, speed[4];
    size_t n = (size_t)floor(SAMPLES * a->jump_period / (2 * M_PI) + 0.5), i;
    int was_there = 0, j;

    for (i = 0; i <= n; i++) {
        double theta2 = a->jump_period * ((double)i - 0.37) / (double)n;
        int is_there = find_speeds(a->d, branch, theta2, speed);

        for (j = 0; j < 4 && is_there; j++) {
            if (was_there && wanted[j] && (speed[j] < 0) != (last[j] < 0) && a->n_jumps < MOST)
                a->jumps[a->n_jumps++] = halve(a->d, branch, j, theta2 - a->jump_period / (double)n,
                                               theta2, last[j] < 0);
            last[j] = speed[j];
        }
        was_there = is_there;
    }
}

int flk_jumps_find(flk_analysis *a)
{
    const deck *d = a->d;
    const flk_kind *kind = flk_kind_of(d->design.kind);
    int wanted[4], any = 0, i;

    a->jump_period =
        2 * M_PI * (d->mechanism.change_stretched != d->mechanism.change_folded ? 2 : 1);
    for (i = 0; i < 4; i++) {
        wanted[i] = d->has_friction &&
                    (kind->joint[i].slider ? d->friction.guide : d->friction.circle[i]) > 0;
        wanted[i] |= d->has_power_law && i >= 2; /* omega4, v, slide_v */
        any |= wanted[i];
    }
    if (!any)
        return 1;
    a->jumps = malloc(MOST * sizeof *a->jumps);
    if (!a->jumps)
        return 0;
    search_branch(a, FOURLINK_OPEN, wanted);
    search_branch(a, FOURLINK_CROSSED, wanted);
    return 1;
}
