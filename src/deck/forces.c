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

#define STANDSTILL 1e-12 /* of a unit crank speed: what is slower turns round */

int flk_deck_needs_motion(const deck *d)
{
    return d->n_springs || d->has_friction || d->has_law;
}

double flk_deck_argument(const fourlink_state *state, int over)
{
    switch (over) {
    case OVER_THETA2:
        return state->link[FOURLINK_CRANK].theta;
    case OVER_THETA4:
        return state->link[FOURLINK_FOLLOWER].theta;
    case OVER_X:
        return state->x;
    case OVER_SLIDE:
        return state->slide;
    case OVER_OMEGA2:
        return state->link[FOURLINK_CRANK].omega;
    case OVER_OMEGA4:
        return state->link[FOURLINK_FOLLOWER].omega;
    case OVER_V:
        return state->v;
    default:
        return state->slide_v;
    }
}

/* 1 if the argument of a load falls; of a crank at rest, if it would in the sense in which that is about to turn.  Where
** it turns round it does not fall. */
static int falls(const deck *d, const fourlink_state *state, int over)
{
    double r = over == OVER_X || over == OVER_SLIDE ? d->design.link[FOURLINK_CRANK].length : 1;
    fourlink_state moved = *state;
    int rate = over + (OVER_OMEGA2 - OVER_THETA2);

    if (state->link[FOURLINK_CRANK].omega == 0)
        fourlink_velocity(&d->mechanism, d->friction.direction < 0 ? -1 : 1, &moved);
    return flk_deck_argument(&moved, rate) <
           -STANDSTILL * r * fabs(moved.link[FOURLINK_CRANK].omega);
}

/* A value over a speed: value sign(w) (|w| / at_speed)^exponent. */
static void follow_speed(const deck_law *law, double w, fourlink_load *load)
{
    double factor = w == 0 ? 0 : pow(fabs(w) / law->at_speed, law->exponent);

    factor = w < 0 ? -factor : factor;
    load->torque *= factor;
    load->force.x *= factor;
    load->force.y *= factor;
}

/* A load at its argument. */
static void follow(const deck *d, unsigned long i, const fourlink_state *state, fourlink_load *load)
{
    const deck_load *variation = &d->variations[i];
    const deck_law *law = &variation->law;
    const curve *torque = &variation->torque, *force = variation->force;
    double x = flk_deck_argument(state, law->over);

    load->torque = d->loads[i].torque;
    load->force = d->loads[i].force;
    if (law->at_speed > 0) {
        follow_speed(law, x, load);
        return;
    }
    if (law->has_back && falls(d, state, law->over)) {
        load->torque = law->back.torque;
        load->force = law->back.force;
        torque = &law->back_torque;
        force = law->back_force;
    }
    if (torque->n)
        load->torque = flk_curve_value(torque, x);
    if (force[0].n) {
        load->force.x = flk_curve_value(&force[0], x);
        load->force.y = flk_curve_value(&force[1], x);
    }
}

/* Set those loads that need the motion. */
static int set_loads_of_motion(const deck *d, const fourlink_state *state, fourlink_load *loads)
{
    fourlink_load *next = loads + d->n_loads;
    fourlink_spring_state at;
    unsigned long i, k;

    for (i = 0; i < d->n_loads; i++)
        if (FLK_DECK_FOLLOWS(&d->variations[i].law))
            follow(d, i, state, &loads[i]);
    for (i = 0; i < d->n_springs; i++) {
        int status = fourlink_spring_at(&d->mechanism, state, &d->springs[i].spring, &at);

        if (status != FOURLINK_OK)
            return status;
        for (k = 0; k < at.n_loads; k++)
            *next++ = at.load[k];
    }
    return FOURLINK_OK;
}

int flk_deck_set_moving_loads(const deck *d, const fourlink_state *state, fourlink_load *loads,
                              double *gas)
{
    flk_deck_set_loads(d, state->branch, state->link[FOURLINK_CRANK].theta, loads, gas);
    return set_loads_of_motion(d, state, loads);
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
    status = flk_deck_set_moving_loads(d, &motion, loads, &force);
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
