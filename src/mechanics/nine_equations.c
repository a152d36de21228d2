/* SPDX-License-Identifier: GPL-3.0-or-later
**
** nine_equations.c - pin forces and driving torque from the Newton-Euler equations of the three
** moving links, as a system of nine equations, solved by GSL.  They are the same for every mechanism.
** closed_form.c has the other solution.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_linalg.h>

#include "free_body.h"

static int check_load(const fourlink_load *load)
{
    if (load->link < FOURLINK_CRANK || load->link > FOURLINK_FOLLOWER)
        return FOURLINK_BAD_LINK;
    if (load->frame != FOURLINK_FRAME_GROUND && load->frame != FOURLINK_FRAME_LINK)
        return FOURLINK_BAD_FRAME;
    if (!FLK_BOTH_WITHIN(load->force, FOURLINK_NUMBER_MAX) ||
        !FLK_BOTH_WITHIN(load->at, FOURLINK_LENGTH_MAX) ||
        !FLK_WITHIN(load->torque, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    return FOURLINK_OK;
}

int flk_check_loads(const fourlink_load *loads, unsigned long n_loads)
{
    unsigned long n;

    if (n_loads && !loads)
        return FOURLINK_NULL;
    for (n = 0; n < n_loads; n++) {
        int status = check_load(&loads[n]);

        if (status != FOURLINK_OK)
            return status;
    }
    return FOURLINK_OK;
}

/* The arm from a link's centre of mass to a joint: that of `body` is G - O. */
static fourlink_vector arm_of(const fourlink_vector *joint, const fourlink_link_state *link,
                              const flk_body *body)
{
    fourlink_vector G = link->origin, rho;

    G.x += body->arm.x;
    G.y += body->arm.y;
    rho.x = joint->x - G.x;
    rho.y = joint->y - G.y;
    return rho;
}

static fourlink_vector place_of(const flk_joint *joint, const fourlink_mechanism *mechanism,
                                const fourlink_state *state)
{
    const fourlink_link_state *link = &state->link[joint->at];
    fourlink_vector P = link->origin;

    if (joint->place == FLK_TIP) {
        P.x += mechanism->design.link[joint->at].length * link->axis.x;
        P.y += mechanism->design.link[joint->at].length * link->axis.y;
    }
    return P;
}

/* The direction of a slide, turned left by 90 deg; along the line of stroke x is 0, not -0. */
static fourlink_vector normal_of(const fourlink_link_state *slider)
{
    fourlink_vector n;

    n.x = 0 - slider->axis.y;
    n.y = slider->axis.x;
    return n;
}

/* The place of an equation and of an unknown in the array that holds the matrix: the coefficient of
** unknown u in equation e is at row[e] + column[u]. */
typedef struct layout {
    int row[9], column[9];
} layout;

/* The nine equations, A x = b, x the two unknowns of each joint, and Ts.  With rho_P = P - G and
** rho x F = rho_x F_y - rho_y F_x, for links 2, 3, 4 where all joints are pins (ME3491 eqs. 3 to 15;
** there with cosines for sines in the moments, and r_g3 for r_g4):
**
**    F12 - F23 = m a_G2 - W2 - sum F        rho_A x F12 - rho_B x F23 + Ts = I alpha2 - sum M
**    F23 - F34 = m a_G3 - W3 - sum F        rho_B x F23 - rho_C x F34      = I alpha3 - sum M
**    F34 + F14 = m a_G4 - W4 - sum F        rho_C x F34 + rho_D x F14      = I alpha4 - sum M
**
** A slider has F_ij = N n, and its couple M_ij in the moments besides, which takes the column before N.
**
** `per_length` multiplies the moment equations of the links, by number, and couples, as unknowns, with
** that of the link on which they act: Ts with the crank's. */
static void assemble(const flk_kind *kind, const fourlink_mechanism *mechanism,
                     const fourlink_state *state, const flk_body body[3],
                     const double per_length[5], const layout *at, double *A, double b[9])
{
    int i, k, side;

    memset(A, 0, 81 * sizeof A[0]);
    for (k = 0; k < 4; k++) {
        const flk_joint *joint = &kind->joint[k];
        int first = at->column[2 * k], second = at->column[2 * k + 1];
        fourlink_vector P = place_of(joint, mechanism, state);

        for (side = joint->from == FOURLINK_GROUND ? 1 : -1; side <= 1; side += 2) {
            int link = side > 0 ? joint->on : joint->from, row = 3 * (link - FOURLINK_CRANK);
            double *x = A + at->row[row], *y = A + at->row[row + 1], *m = A + at->row[row + 2];
            double s = side * per_length[link];
            fourlink_vector rho = arm_of(&P, &state->link[link], &body[link - FOURLINK_CRANK]);

            if (joint->slider) {
                fourlink_vector n = normal_of(&state->link[joint->slider]);

                m[first] = s / per_length[joint->on];
                x[second] = side * n.x;
                y[second] = side * n.y;
                m[second] = s * FLK_CROSS(rho, n);
            } else {
                x[first] = side;
                y[second] = side;
                m[first] = -s * rho.y;
                m[second] = s * rho.x;
            }
        }
    }
    A[at->row[2] + at->column[8]] = 1;
    for (i = 0; i < 3; i++) {
        b[3 * i] = body[i].force.x;
        b[3 * i + 1] = body[i].force.y;
        b[3 * i + 2] = per_length[i + 2] * body[i].moment;
    }
}

/* Solve A x = b.  With the unknowns in the order Ts, F12 ... F14 and the equations in the order
**
**    moment 2, x 2, y 2, x 3, y 3, moment 3, moment 4, x 4, y 4
**
** the matrix is banded, 2 below and 4 above the diagonal, and GSL's decomposition of banded matrices works in
** the caller's arrays: nothing is allocated.  Row j of GSL's storage is column j of the matrix, with BELOW
** places before it for fill-in.  Moments are divided by half their link's length, or, of a link without one,
** that of the link before: so all coefficients are near 1, pivots can be compared with a limit, and most are
** already on the diagonal.
*/
#define BELOW 2
#define ABOVE 4
#define WIDTH (2 * BELOW + ABOVE + 1)
#define COLUMN(j) ((WIDTH - 1) * (j) + BELOW + ABOVE)
#define DIAGONAL(j) (COLUMN(j) + (j))

static const layout banded = {{1, 2, 0, 3, 4, 5, 7, 8, 6},
                              {COLUMN(1), COLUMN(2), COLUMN(3), COLUMN(4), COLUMN(5), COLUMN(6),
                               COLUMN(7), COLUMN(8), COLUMN(0)}};

static int solve(const flk_kind *kind, const fourlink_mechanism *mechanism,
                 const fourlink_state *state, const flk_body body[3], double x[9])
{
    const fourlink_link *link = mechanism->design.link;
    double A[9 * WIDTH], b[9], ordered[9], per_length[5];
    unsigned int pivot[9];
    gsl_matrix_view A_view = gsl_matrix_view_array(A, 9, WIDTH);
    gsl_vector_view x_view = gsl_vector_view_array(ordered, 9);
    gsl_vector_uint_view pivot_view = gsl_vector_uint_view_array(pivot, 9);
    int i;

    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        per_length[i] = kind->has_length[i] == FLK_LENGTH ? 2 / link[i].length : per_length[i - 1];
    assemble(kind, mechanism, state, body, per_length, &banded, A, b);
    for (i = 0; i < 9; i++)
        ordered[banded.row[i]] = b[i];
    gsl_linalg_LU_band_decomp(9, BELOW, ABOVE, &A_view.matrix, &pivot_view.vector);
    for (i = 0; i < 9; i++)
        if (!(fabs(A[DIAGONAL(i)]) > FLK_SINGULAR))
            return FOURLINK_SINGULAR;
    gsl_linalg_LU_band_svx(BELOW, ABOVE, &A_view.matrix, &pivot_view.vector, &x_view.vector);
    for (i = 0; i < 8; i++)
        x[i] = ordered[i + 1];
    for (i = 0; i < 4; i++)
        if (kind->joint[i].slider)
            x[2 * i] /= per_length[kind->joint[i].on];
    x[8] = ordered[0] / per_length[FOURLINK_CRANK];
    return FOURLINK_OK;
}

int fourlink_system(const fourlink_mechanism *mechanism, const fourlink_state *state,
                    const fourlink_load *loads, unsigned long n_loads, double A[9][9], double b[9])
{
    static const layout dense = {{0, 9, 18, 27, 36, 45, 54, 63, 72}, {0, 1, 2, 3, 4, 5, 6, 7, 8}};
    static const double metres[5] = {1, 1, 1, 1, 1};
    const flk_kind *kind;
    flk_body body[3];
    int status;

    status = flk_kind_find(mechanism, A, &kind);
    if (status == FOURLINK_OK)
        status = state && b ? flk_check_loads(loads, n_loads) : FOURLINK_NULL;
    if (status != FOURLINK_OK)
        return status;
    flk_cut_free(mechanism, state, loads, n_loads, body);
    assemble(kind, mechanism, state, body, metres, &dense, A[0], b);
    return FOURLINK_OK;
}

static void list_forces(const flk_kind *kind, const fourlink_state *state, const double x[9],
                        fourlink_forces *forces)
{
    int i;

    memset(forces, 0, sizeof *forces);
    for (i = 0; i < 9; i++)
        *FLK_MEMBER(forces, flk_unknowns[i][FLK_JOINT_OF(kind, i)]) = x[i];
    for (i = 0; i < 8; i += 2)
        if (FLK_JOINT_OF(kind, i) == FLK_SLIDER) {
            fourlink_vector n = normal_of(&state->link[kind->joint[i / 2].slider]);

            *FLK_MEMBER(forces, flk_unknowns[i][FLK_PIN]) = x[i + 1] * n.x + 0.0;
            *FLK_MEMBER(forces, flk_unknowns[i + 1][FLK_PIN]) = x[i + 1] * n.y;
        }
}

int fourlink_solve(const fourlink_mechanism *mechanism, const fourlink_state *state,
                   const fourlink_load *loads, unsigned long n_loads, fourlink_forces *forces)
{
    const flk_kind *kind;
    flk_body body[3];
    fourlink_forces result;
    double x[9];
    int status;

    status = flk_kind_find(mechanism, forces, &kind);
    if (status == FOURLINK_OK)
        status = state ? flk_check_loads(loads, n_loads) : FOURLINK_NULL;
    if (status != FOURLINK_OK)
        return status;
    flk_cut_free(mechanism, state, loads, n_loads, body);
    status = solve(kind, mechanism, state, body, x);
    if (status != FOURLINK_OK)
        return status;
    list_forces(kind, state, x, &result);
    flk_virtual_work(body, &result);
    if (!flk_is_finite(&result))
        return FOURLINK_BAD_NUMBER;
    *forces = result;
    return FOURLINK_OK;
}
