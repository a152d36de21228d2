/* SPDX-License-Identifier: GPL-3.0-or-later
**
** forces.c - a crank position of a deck whose loads depend on the motion, or on the pin forces: springs and dampers, loads
** over a speed, friction.
*/
#include <math.h>
#include <string.h>

#include "deck.h"
#include "mechanics/mechanics.h"
#include "schema.h"

int flk_deck_needs_motion(const deck *d)
{
    return d->n_springs || d->has_friction || d->has_power_law;
}

static double speed_of(const fourlink_state *state, int over)
{
    return over == OVER_OMEGA2   ? state->link[FOURLINK_CRANK].omega
           : over == OVER_OMEGA4 ? state->link[FOURLINK_FOLLOWER].omega
           : over == OVER_V      ? state->v
                                 : state->slide_v;
}

/* value sign(w) (|w| / at_speed)^exponent */
static void follow_speed(const deck_power_law *law, const fourlink_state *state,
                         fourlink_load *load)
{
    double w = speed_of(state, law->over);
    double factor = w == 0 ? 0 : pow(fabs(w) / law->at_speed, law->exponent);

    factor = w < 0 ? -factor : factor;
    load->torque *= factor;
    load->force.x *= factor;
    load->force.y *= factor;
}

/* Set those loads that need the motion. */
static int set_loads_of_motion(const deck *d, const fourlink_state *state, fourlink_load *loads)
{
    fourlink_load *next = loads + d->n_loads;
    fourlink_spring_state at;
    unsigned long i, k;

    for (i = 0; i < d->n_loads; i++)
        if (d->variations[i].law.over)
            follow_speed(&d->variations[i].law, state, &loads[i]);
    for (i = 0; i < d->n_springs; i++) {
        int status = fourlink_spring_at(&d->mechanism, state, &d->springs[i].spring, &at);

        if (status != FOURLINK_OK)
            return status;
        for (k = 0; k < at.n_loads; k++)
            *next++ = at.load[k];
    }
    return FOURLINK_OK;
}

static int solve(const deck *d, int closed_form, const fourlink_state *state, fourlink_load *loads,
                 fourlink_forces *forces, fourlink_losses *losses)
{
    unsigned long n = flk_deck_all_loads(d);
    unsigned long first = d->n_loads + flk_deck_spring_loads(d);
    int status;

    if (d->has_friction) {
        status = fourlink_solve_friction(&d->mechanism, state, loads, n, &d->friction, closed_form,
                                         forces, losses);
        if (status == FOURLINK_OK)
            memcpy(loads + first, losses->load, losses->n_loads * sizeof *loads);
        return status;
    }
    status = closed_form ? fourlink_solve_dyad(&d->mechanism, state, loads, n, forces)
                         : fourlink_solve(&d->mechanism, state, loads, n, forces);
    memset(losses, 0, sizeof *losses);
    losses->Ts0 = forces->Ts;
    losses->efficiency = 1;
    return status;
}

int fourlink_deck_analyse(const fourlink_deck *d, fourlink_branch branch,
                          const fourlink_crank *crank, int closed_form, fourlink_load *loads,
                          fourlink_state *state, fourlink_forces *forces, fourlink_losses *losses,
                          double *gas)
{
    fourlink_state motion;
    fourlink_forces found;
    fourlink_losses lost;
    double force;
    int status;

    if (!d || !crank || !loads || !state || !forces || !losses || !gas)
        return FOURLINK_NULL;
    status = fourlink_analyse(&d->mechanism, branch, crank, NULL, 0, &motion, NULL);
    if (status != FOURLINK_OK)
        return status;
    flk_deck_set_loads(d, branch, crank->theta2, loads, &force);
    status = set_loads_of_motion(d, &motion, loads);
    if (status == FOURLINK_OK)
        status = solve(d, closed_form, &motion, loads, &found, &lost);
    if (status != FOURLINK_OK)
        return status;
    *state = motion;
    *forces = found;
    *losses = lost;
    *gas = force;
    return FOURLINK_OK;
}
