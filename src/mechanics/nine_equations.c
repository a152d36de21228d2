/* SPDX-License-Identifier: GPL-3.0-or-later
**
** nine_equations.c - pin forces and driving torque from the Newton-Euler equations of the three
** moving links, as a system of nine: the equations are those of any mechanism, and so is GSL's solution
** of them.  closed_form.c has the other one.
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
    if (!FLK_WITHIN(load->force.x, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(load->force.y, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(load->at.x, FOURLINK_LENGTH_MAX) ||
        !FLK_WITHIN(load->at.y, FOURLINK_LENGTH_MAX) ||
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

/* One moving link: arms from its centre of mass to the pin towards the crankshaft (A, B, C for links
** 2, 3, 4), and to the other one (B, C, D; of the piston, C again). */
typedef struct pins {
    fourlink_vector first, second; /* m */
} pins;

static void place_pins(const fourlink_mechanism *mechanism, const fourlink_state *state,
                       const flk_body body[3], pins arms[3])
{
    fourlink_vector pin[4]; /* A, B, C, D; of a slider-crank D is C */
    int i;

    pin[0] = state->link[2].origin;
    pin[1] = state->link[3].origin;
    pin[2].x = pin[1].x + mechanism->design.link[3].length * state->link[3].axis.x;
    pin[2].y = pin[1].y + mechanism->design.link[3].length * state->link[3].axis.y;
    pin[3] = state->link[4].origin;
    if (mechanism->design.kind == FOURLINK_SLIDER_CRANK)
        pin[2] = pin[3];
    for (i = 0; i < 3; i++) {
        fourlink_vector G = state->link[i + 2].origin;

        G.x += body[i].arm.x;
        G.y += body[i].arm.y;
        arms[i].first.x = pin[i].x - G.x;
        arms[i].first.y = pin[i].y - G.y;
        arms[i].second.x = pin[i + 1].x - G.x;
        arms[i].second.y = pin[i + 1].y - G.y;
    }
}

/* The place of an equation and of an unknown in the array that holds the matrix: the coefficient of
** unknown u in equation e is at row[e] + column[u]. */
typedef struct layout {
    int row[9], column[9];
} layout;

/* The nine equations, A x = b, x = (F12x F12y F23x F23y F34x F34y F14x F14y Ts).  With
** rho_P = P - G and rho x F = rho_x F_y - rho_y F_x, for links 2, 3, 4 (ME3491 eqs. 3 to 15; theirs
** have cosines for sines in the moments, and r_g3 for r_g4):
**
**    F12 - F23 = m a_G2 - W2 - sum F        rho_A x F12 - rho_B x F23 + Ts = I alpha2 - sum M
**    F23 - F34 = m a_G3 - W3 - sum F        rho_B x F23 - rho_C x F34      = I alpha3 - sum M
**    F34 + F14 = m a_G4 - W4 - sum F        rho_C x F34 + rho_D x F14      = I alpha4 - sum M
**
** A piston does not turn, and its guide gives a normal force N and a couple: F14y is N, which acts
** at the pin C, and the column of F14x is that of the couple M14.
**
** `per_length` multiplies the moment equations of the three links. */
static void assemble(const fourlink_mechanism *mechanism, const fourlink_state *state,
                     const flk_body body[3], const double per_length[3], const layout *at,
                     double *A, double b[9])
{
    pins arms[3];
    int i;

    place_pins(mechanism, state, body, arms);
    memset(A, 0, 81 * sizeof A[0]);
    for (i = 0; i < 3; i++) {
        double *x = A + at->row[3 * i], *y = A + at->row[3 * i + 1], *m = A + at->row[3 * i + 2];
        const int *first = at->column + 2 * i, *second = first + 2;
        double sign = i == 2 ? 1 : -1, s = per_length[i];

        x[first[0]] = 1;
        x[second[0]] = sign;
        y[first[1]] = 1;
        y[second[1]] = sign;
        m[first[0]] = -s * arms[i].first.y;
        m[first[1]] = s * arms[i].first.x;
        m[second[0]] = -sign * s * arms[i].second.y;
        m[second[1]] = sign * s * arms[i].second.x;
        b[3 * i] = body[i].force.x;
        b[3 * i + 1] = body[i].force.y;
        b[3 * i + 2] = s * body[i].moment;
    }
    A[at->row[2] + at->column[8]] = per_length[0];
    if (mechanism->design.kind == FOURLINK_SLIDER_CRANK) {
        A[at->row[6] + at->column[6]] = 0;
        A[at->row[8] + at->column[6]] = per_length[2];
    }
}

/* Solve A x = b.  With the unknowns in the order Ts, F12 ... F14 and the equations in the order
**
**    moment 2, x 2, y 2, x 3, y 3, moment 3, moment 4, x 4, y 4
**
** the matrix is banded, 2 below and 4 above the diagonal, and GSL's decomposition of banded
** matrices works in the arrays given to it: nothing is allocated.  Row j of GSL's storage is column j of the
** matrix, with BELOW places before it for fill-in.  Moments are divided by half their link's
** length: so all coefficients are near 1, pivots can be judged, and most already stand on the diagonal.
*/
#define BELOW 2
#define ABOVE 4
#define WIDTH (2 * BELOW + ABOVE + 1)
#define COLUMN(j) ((WIDTH - 1) * (j) + BELOW + ABOVE)
#define DIAGONAL(j) (COLUMN(j) + (j))

static const layout banded = {{1, 2, 0, 3, 4, 5, 7, 8, 6},
                              {COLUMN(1), COLUMN(2), COLUMN(3), COLUMN(4), COLUMN(5), COLUMN(6),
                               COLUMN(7), COLUMN(8), COLUMN(0)}};

static int solve(const fourlink_mechanism *mechanism, const fourlink_state *state,
                 const flk_body body[3], double x[9])
{
    const fourlink_link *link = mechanism->design.link;
    double A[9 * WIDTH], b[9], ordered[9], per_length[3];
    unsigned int pivot[9];
    gsl_matrix_view A_view = gsl_matrix_view_array(A, 9, WIDTH);
    gsl_vector_view x_view = gsl_vector_view_array(ordered, 9);
    gsl_vector_uint_view pivot_view = gsl_vector_uint_view_array(pivot, 9);
    int i;

    per_length[0] = 2 / link[2].length;
    per_length[1] = 2 / link[3].length;
    per_length[2] =
        mechanism->design.kind == FOURLINK_FOUR_BAR ? 2 / link[4].length : per_length[1];
    assemble(mechanism, state, body, per_length, &banded, A, b);
    A[DIAGONAL(0)] = 1; /* the first unknown is Ts per_length[0], a force; M14 likewise */
    if (mechanism->design.kind == FOURLINK_SLIDER_CRANK)
        A[banded.row[8] + banded.column[6]] = 1;
    for (i = 0; i < 9; i++)
        ordered[banded.row[i]] = b[i];
    gsl_linalg_LU_band_decomp(9, BELOW, ABOVE, &A_view.matrix, &pivot_view.vector);
    for (i = 0; i < 9; i++)
        if (!(fabs(A[DIAGONAL(i)]) > FLK_SINGULAR))
            return FOURLINK_SINGULAR;
    gsl_linalg_LU_band_svx(BELOW, ABOVE, &A_view.matrix, &pivot_view.vector, &x_view.vector);
    for (i = 0; i < 8; i++)
        x[i] = ordered[i + 1];
    if (mechanism->design.kind == FOURLINK_SLIDER_CRANK)
        x[6] /= per_length[2];
    x[8] = ordered[0] / per_length[0];
    return FOURLINK_OK;
}

int fourlink_system(const fourlink_mechanism *mechanism, const fourlink_state *state,
                    const fourlink_load *loads, unsigned long n_loads, double A[9][9], double b[9])
{
    static const layout dense = {{0, 9, 18, 27, 36, 45, 54, 63, 72}, {0, 1, 2, 3, 4, 5, 6, 7, 8}};
    static const double metres[3] = {1, 1, 1};
    flk_body body[3];
    int status;

    if (!mechanism || !state || !A || !b)
        return FOURLINK_NULL;
    status = flk_check_loads(loads, n_loads);
    if (status != FOURLINK_OK)
        return status;
    flk_cut_free(mechanism, state, loads, n_loads, body);
    assemble(mechanism, state, body, metres, &dense, A[0], b);
    return FOURLINK_OK;
}

int fourlink_solve(const fourlink_mechanism *mechanism, const fourlink_state *state,
                   const fourlink_load *loads, unsigned long n_loads, fourlink_forces *forces)
{
    flk_body body[3];
    fourlink_forces result;
    double x[9];
    int status;

    if (!mechanism || !state || !forces)
        return FOURLINK_NULL;
    status = flk_check_loads(loads, n_loads);
    if (status != FOURLINK_OK)
        return status;
    flk_cut_free(mechanism, state, loads, n_loads, body);
    status = solve(mechanism, state, body, x);
    if (status != FOURLINK_OK)
        return status;
    result.F12x = x[0];
    result.F12y = x[1];
    result.F23x = x[2];
    result.F23y = x[3];
    result.F34x = x[4];
    result.F34y = x[5];
    result.F14x = x[6];
    result.F14y = x[7];
    result.M14 = 0;
    result.Ts = x[8];
    if (mechanism->design.kind == FOURLINK_SLIDER_CRANK) {
        result.F14x = 0;
        result.M14 = x[6];
    }
    flk_virtual_work(body, &result);
    if (!flk_is_finite(&result))
        return FOURLINK_BAD_NUMBER;
    *forces = result;
    return FOURLINK_OK;
}
