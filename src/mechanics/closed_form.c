/* SPDX-License-Identifier: GPL-3.0-or-later
**
** closed_form.c - the nine equations of nine_equations.c, solved by hand.  Links 3 and 4 are a dyad: their
** forces do not depend on those of the crank, which follows.
*/
#include <math.h>
#include <string.h>

#include "free_body.h"
#include "closed_form.h"
#include "drive.h"
#include "group.h"

/* F34 comes from the kind.  With e2 the axis of the crank,
**
**    F14 = f4 - F34,   F23 = f3 + F34,   F12 = f2 + F23,   Ts = M2 + a e2 x F23
*/
static void solve_crank_driven(const flk_kind *kind, const fourlink_mechanism *mechanism,
                               const fourlink_state *state, const flk_body body[3],
                               fourlink_forces *forces)
{
    const fourlink_vector *e2 = &state->link[2].axis;
    fourlink_vector F34, F23;

    forces->M14 = forces->N34 = forces->M34 = 0;
    kind->forces(mechanism, state, body, FLK_MOMENT_ABOUT_ORIGIN(&body[1]),
                 FLK_MOMENT_ABOUT_ORIGIN(&body[2]), &F34, forces);
    F23.x = body[1].force.x + F34.x;
    F23.y = body[1].force.y + F34.y;
    forces->F12x = body[0].force.x + F23.x;
    forces->F12y = body[0].force.y + F23.y;
    forces->F23x = F23.x;
    forces->F23y = F23.y;
    forces->F34x = F34.x;
    forces->F34y = F34.y;
    forces->F14x = body[2].force.x - F34.x;
    forces->F14y = body[2].force.y - F34.y;
    forces->Ts =
        FLK_MOMENT_ABOUT_ORIGIN(&body[0]) + mechanism->design.link[2].length * FLK_CROSS(*e2, F23);
    forces->drive = forces->at_crank = forces->Ts;
}

/* The forces of a drive with the effort 1, and the crank driven by it: Ts is -K. */
static int drive_with_one(const flk_kind *kind, const fourlink_mechanism *mechanism,
                          const fourlink_state *state, flk_factors *factors)
{
    flk_unit_drive drive;
    flk_body body[3];
    int status = flk_drive_unit(mechanism->drive, mechanism, state, &drive);

    if (status != FOURLINK_OK)
        return status;
    memset(body, 0, sizeof body);
    flk_groups_pass(mechanism, state, drive.load, drive.n_loads, 1, body);
    solve_crank_driven(kind, mechanism, state, body, &factors->unit);
    factors->K = drive.K;
    return FOURLINK_OK;
}

/* Forces are linear in the loads: those with the crank driving, and those of the drive with the effort Q
** = Ts / K. */
static void replace_crank(const flk_factors *factors, fourlink_forces *forces)
{
    const fourlink_forces *unit = &factors->unit;
    double Q = forces->Ts / factors->K;

    forces->F12x += Q * unit->F12x;
    forces->F12y += Q * unit->F12y;
    forces->F23x += Q * unit->F23x;
    forces->F23y += Q * unit->F23y;
    forces->F34x += Q * unit->F34x;
    forces->F34y += Q * unit->F34y;
    forces->F14x += Q * unit->F14x;
    forces->F14y += Q * unit->F14y;
    forces->M14 += Q * unit->M14;
    forces->N34 += Q * unit->N34;
    forces->M34 += Q * unit->M34;
    forces->drive = Q;
    forces->Ts = 0;
}

static void solve_dyad(const flk_kind *kind, const fourlink_mechanism *mechanism,
                       const fourlink_state *state, const flk_factors *factors,
                       const flk_body body[3], fourlink_forces *forces)
{
    solve_crank_driven(kind, mechanism, state, body, forces);
    if (mechanism->drive)
        replace_crank(factors, forces);
}

int flk_dyad(const flk_kind *kind, const fourlink_mechanism *mechanism, const fourlink_state *state,
             const fourlink_load *loads, unsigned long n_loads, fourlink_forces *forces)
{
    flk_factors factors;
    flk_body body[3];
    int status = mechanism->drive ? drive_with_one(kind, mechanism, state, &factors) : FOURLINK_OK;

    if (status != FOURLINK_OK)
        return status;
    flk_cut_free(mechanism, state, loads, n_loads, 1, body);
    solve_dyad(kind, mechanism, state, &factors, body, forces);
    flk_virtual_work(state, body, forces);
    return FOURLINK_OK;
}

/* The position functions never give a singular state, or axes that are NaN, but a caller may. */
static int is_singular(const fourlink_state *state)
{
    int i;

    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        if (!FLK_BOTH_WITHIN(state->link[i].axis, 2))
            return 1;
    return !(fabs(state->sine) > FLK_SINGULAR);
}

int fourlink_solve_dyad(const fourlink_mechanism *mechanism, const fourlink_state *state,
                        const fourlink_load *loads, unsigned long n_loads, fourlink_forces *forces)
{
    const flk_kind *kind;
    fourlink_forces result;
    int status = flk_kind_find(mechanism, forces, &kind);

    if (status == FOURLINK_OK)
        status = state ? flk_check_loads(mechanism, loads, n_loads) : FOURLINK_NULL;
    if (status != FOURLINK_OK)
        return status;
    if (is_singular(state) || flk_groups_are_singular(mechanism, state))
        return FOURLINK_SINGULAR;
    status = flk_dyad(kind, mechanism, state, loads, n_loads, &result);
    if (status != FOURLINK_OK)
        return status;
    if (!flk_is_finite(&result))
        return FOURLINK_BAD_NUMBER;
    *forces = result;
    return FOURLINK_OK;
}

/* ---- for friction, which solves a position several times */

static int check_dyad(const flk_kind *kind, const fourlink_mechanism *mechanism,
                      const fourlink_state *state, flk_factors *factors)
{
    if (is_singular(state) || flk_groups_are_singular(mechanism, state))
        return FOURLINK_SINGULAR;
    return mechanism->drive ? drive_with_one(kind, mechanism, state, factors) : FOURLINK_OK;
}

static void solve_dyad_again(const flk_kind *kind, const fourlink_mechanism *mechanism,
                             const fourlink_state *state, const flk_factors *factors,
                             const flk_body body[3], fourlink_forces *forces)
{
    solve_dyad(kind, mechanism, state, factors, body, forces);
}

const flk_solver flk_closed_form = {check_dyad, solve_dyad_again};
