/* SPDX-License-Identifier: GPL-3.0-or-later
**
** closed_form.c - the nine equations of nine_equations.c, eliminated by hand: links 3 and 4 are a dyad, whose
** forces do not depend on the crank's, and the crank follows.
*/
#include <math.h>

#include "free_body.h"

/* The moment of each link's equation about the link's origin instead of G: with f the right-hand side
** of its force equations, m that of its moments, and r = G - O,
**
**    M_O = m + r x f
*/
static double moment(const flk_body *body)
{
    return body->moment + FLK_CROSS(body->arm, body->force);
}

/* Moments about B, D and A leave out the force at that pin, and what is left has one arm, the link's
** own.  With e_i the axis of link i,
**
**    four-bar        moments of link 3 about B    b e3 x F34 = -M3
**                    moments of link 4 about D    c e4 x F34 =  M4
**
**                    F34 = -[(M3 / b) e4 + (M4 / c) e3] / sin(theta4 - theta3),   F14 = f4 - F34
**
**    slider-crank    forces on the piston along the stroke   F34x = f4x
**                    moments of the rod about B              F34y = [F34x sin(theta3) - M3 / l]
**                                                                   / cos(theta3)
**                    N = f4y - F34y,   M14 = M4 about C
**
**    both            F23 = f3 + F34,   F12 = f2 + F23,   Ts = M2 + a e2 x F23
*/
void flk_dyad(const fourlink_mechanism *mechanism, const fourlink_state *state,
              const fourlink_load *loads, unsigned long n_loads, fourlink_forces *forces)
{
    const fourlink_link *link = mechanism->design.link;
    const fourlink_vector *e2 = &state->link[2].axis, *e3 = &state->link[3].axis,
                          *e4 = &state->link[4].axis;
    fourlink_vector F34, F23;
    flk_body body[3];
    double M3, M4;

    flk_cut_free(mechanism, state, loads, n_loads, body);
    M3 = moment(&body[1]);
    M4 = moment(&body[2]);
    if (mechanism->design.kind == FOURLINK_FOUR_BAR) {
        double b = link[3].length, c = link[4].length, p = -1 / (b * c * state->sine);

        M3 *= c * p;
        M4 *= b * p;
        F34.x = M3 * e4->x + M4 * e3->x;
        F34.y = M3 * e4->y + M4 * e3->y;
        forces->F14x = body[2].force.x - F34.x;
        forces->M14 = 0;
    } else {
        F34.x = body[2].force.x;
        F34.y = (F34.x * e3->y - M3 / link[3].length) / e3->x;
        forces->F14x = 0;
        forces->M14 = M4;
    }
    F23.x = body[1].force.x + F34.x;
    F23.y = body[1].force.y + F34.y;
    forces->F12x = body[0].force.x + F23.x;
    forces->F12y = body[0].force.y + F23.y;
    forces->F23x = F23.x;
    forces->F23y = F23.y;
    forces->F34x = F34.x;
    forces->F34y = F34.y;
    forces->F14y = body[2].force.y - F34.y;
    forces->Ts = moment(&body[0]) + link[2].length * FLK_CROSS(*e2, F23);
    flk_virtual_work(body, forces);
}

/* No position gives a singular state, or one with axes that are not numbers, but a caller may. */
static int is_singular(const fourlink_state *state)
{
    int i;

    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        if (!FLK_WITHIN(state->link[i].axis.x, 2) || !FLK_WITHIN(state->link[i].axis.y, 2))
            return 1;
    return !(fabs(state->sine) > FLK_SINGULAR);
}

int fourlink_solve_dyad(const fourlink_mechanism *mechanism, const fourlink_state *state,
                        const fourlink_load *loads, unsigned long n_loads, fourlink_forces *forces)
{
    fourlink_forces result;
    int status;

    if (!mechanism || !state || !forces)
        return FOURLINK_NULL;
    status = flk_check_loads(loads, n_loads);
    if (status != FOURLINK_OK)
        return status;
    if (is_singular(state))
        return FOURLINK_SINGULAR;
    flk_dyad(mechanism, state, loads, n_loads, &result);
    if (!flk_is_finite(&result))
        return FOURLINK_BAD_NUMBER;
    *forces = result;
    return FOURLINK_OK;
}
