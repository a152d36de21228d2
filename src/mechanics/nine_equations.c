/* SPDX-License-Identifier: GPL-3.0-or-later
**
** nine_equations.c - pin forces and driving torque from the Newton-Euler equations of the three
** moving links, as a system of nine equations, solved by GSL.  They are the same for every mechanism.
** The other solution is in closed_form.c.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_linalg.h>

#include "drive.h"
#include "free_body.h"
#include "group.h"

static int check_load(const fourlink_mechanism *mechanism, const fourlink_load *load)
{
    if (load->link < FOURLINK_CRANK || load->link > FLK_LAST_LINK(mechanism) ||
        flk_group_is_block(&mechanism->design, load->link))
        return FOURLINK_BAD_LINK;
    if (load->frame != FOURLINK_FRAME_GROUND && load->frame != FOURLINK_FRAME_LINK)
        return FOURLINK_BAD_FRAME;
    if (!FLK_BOTH_WITHIN(load->force, FOURLINK_NUMBER_MAX) ||
        !FLK_BOTH_WITHIN(load->at, FOURLINK_LENGTH_MAX) ||
        !FLK_WITHIN(load->torque, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    return FOURLINK_OK;
}

int flk_check_loads(const fourlink_mechanism *mechanism, const fourlink_load *loads,
                    unsigned long n_loads)
{
    unsigned long n;

    if (n_loads && !loads)
        return FOURLINK_NULL;
    for (n = 0; n < n_loads; n++) {
        int status = check_load(mechanism, &loads[n]);

        if (status != FOURLINK_OK)
            return status;
    }
    return FOURLINK_OK;
}

/* The arm of a joint from the point about which the moments of a link are taken: `about`, from its origin.
** The pins of a link with a length are at its origin and its tip.  This needs no difference of positions,
** which has few digits for a short link behind a long crank. */
static fourlink_vector joint_arm(const flk_kind *kind, const fourlink_mechanism *mechanism,
                                 const fourlink_state *state, const fourlink_joint *joint, int i,
                                 const fourlink_vector *about)
{
    const fourlink_link_state *link = &state->link[i], *other = &state->link[joint->at];
    int is_tip = joint->at == i ? joint->is_tip : !joint->slider && kind->has_length[i];
    double length = is_tip ? mechanism->design.link[i].length : 0;
    fourlink_vector rho;

    rho.x = length * link->axis.x - about->x;
    rho.y = length * link->axis.y - about->y;
    if (joint->at != i && !is_tip) {
        rho.x += other->origin.x - link->origin.x;
        rho.y += other->origin.y - link->origin.y;
    }
    return rho;
}

/* The direction of a slide, turned left by 90 deg; for the line of stroke, x is 0, not -0. */
static fourlink_vector normal_of(const fourlink_link_state *slider)
{
    fourlink_vector n;

    n.x = 0 - slider->axis.y;
    n.y = slider->axis.x;
    return n;
}

/* The places of equations and unknowns in the array of the matrix: the coefficient of unknown u in equation e
** is at row[e] + column[u]. */
typedef struct layout {
    int row[9], column[9];
} layout;

/* The factors of the equations of the links, by link number. */
typedef struct scaling {
    double force[5], moment[5];
} scaling;

/* The nine equations, A x = b, where x are the two unknowns of each joint, and Ts.  With rho_P = P - G and
** rho x F = rho_x F_y - rho_y F_x, for links 2, 3, 4 where all joints are pins (ME3491 eqs. 3 to 15; which
** has cosines in place of sines in the moments, and r_g3 in place of r_g4):
**
**    F12 - F23 = m a_G2 - W2 - sum F        rho_A x F12 - rho_B x F23 + Ts = I alpha2 - sum M
**    F23 - F34 = m a_G3 - W3 - sum F        rho_B x F23 - rho_C x F34      = I alpha3 - sum M
**    F34 + F14 = m a_G4 - W4 - sum F        rho_C x F34 + rho_D x F14      = I alpha4 - sum M
**
** A slider has F_ij = N n, and also its couple M_ij in the moment equations, in the column before N.
**
** `about` has the points about which moments are taken, from the origins of the links 2, 3, 4.  The equations
** are multiplied by `scale`.  The unknown couples are scaled like the moments of the link on which they act:
** Ts like those of the crank.  The array has `size` places. */
static void put_joints(const flk_kind *kind, const fourlink_mechanism *mechanism,
                       const fourlink_state *state, const fourlink_vector about[3],
                       const scaling *scale, const layout *at, size_t size, double *A)
{
    int k, side;

    memset(A, 0, size * sizeof A[0]);
    for (k = 0; k < 4; k++) {
        const fourlink_joint *joint = &kind->joint[k];
        int first = at->column[2 * k], second = at->column[2 * k + 1];

        for (side = joint->from == FOURLINK_GROUND ? 1 : -1; side <= 1; side += 2) {
            int link = side > 0 ? joint->on : joint->from, row = 3 * (link - FOURLINK_CRANK);
            double *x = A + at->row[row], *y = A + at->row[row + 1], *m = A + at->row[row + 2];
            double f = side * scale->force[link], s = side * scale->moment[link];
            fourlink_vector rho =
                joint_arm(kind, mechanism, state, joint, link, &about[link - FOURLINK_CRANK]);

            if (joint->slider) {
                fourlink_vector n = normal_of(&state->link[joint->slider]);

                m[first] = s / scale->moment[joint->on];
                x[second] = f * n.x;
                y[second] = f * n.y;
                m[second] = s * FLK_CROSS(rho, n);
            } else {
                x[first] = f;
                y[second] = f;
                m[first] = -s * rho.y;
                m[second] = s * rho.x;
            }
        }
    }
    A[at->row[2] + at->column[8]] = 1;
}

/* With a drive that is not the crank the ninth unknown is its effort: the column has its loads for the
** effort 1, on the side of the unknowns.  It is divided by its largest coefficient, which is returned. */
static double put_drive(const flk_unit_drive *drive, const fourlink_mechanism *mechanism,
                        const fourlink_state *state, const fourlink_vector about[3],
                        const scaling *scale, const layout *at, double *A)
{
    flk_body body[3];
    double column[9], largest = 0;
    int i;

    memset(body, 0, sizeof body);
    for (i = 0; i < 3; i++)
        body[i].arm = about[i];
    flk_groups_pass(mechanism, state, drive->load, drive->n_loads, 0, body);
    for (i = 0; i < 3; i++) {
        column[3 * i] = -scale->force[i + 2] * body[i].force.x;
        column[3 * i + 1] = -scale->force[i + 2] * body[i].force.y;
        column[3 * i + 2] = -scale->moment[i + 2] * body[i].moment;
    }
    for (i = 0; i < 9; i++)
        largest = flk_larger(largest, fabs(column[i]));
    for (i = 0; i < 9; i++)
        A[at->row[i] + at->column[8]] = column[i] / largest;
    return largest;
}

/* Solve A x = b.  With the unknowns in the order F14, F34, F23, Ts, F12 and the equations in the order
**
**    x 4, y 4, moment 4, moment 3, x 3, y 3, moment 2, x 2, y 2
**
** the matrix is banded, 3 below and 2 above the diagonal, and GSL's banded decomposition works in the
** caller's arrays: nothing is allocated.  Row j of GSL's storage is column j of the matrix, with BELOW places
** before it for fill-in.
**
** The order is that of the closed form.  So a large force that does no work, such as that of the guide under
** a heavy piston, causes no rounding errors in the others.  For this, moments are taken about the origin of
** each link, where one of its pins has no arm, and the equations of later forces are scaled down, so that
** they are not chosen as pivots too early.  Moments are divided by the length of the link or, if it has none,
** of the link before it.  Then coefficients are at most 1, and pivots can be compared with a limit.
*/
#define LATER (1.0 / 32)
#define COLUMN(j) ((FLK_BAND - 1) * (j) + FLK_BELOW + FLK_ABOVE)

/* Moments are divided by lengths besides. */
static const scaling banded_scale = {{0, 0, LATER *LATER, LATER, 1}, {0, 0, LATER *LATER, 1, 1}};

#define PLACES(X, x34, y34)                                      \
    {                                                            \
        X(7), X(8), X(4), X(5), X(x34), X(y34), X(0), X(1), X(6) \
    }
#define PLACE(j) (j)
#define ROWS                      \
    {                             \
        7, 8, 6, 4, 5, 3, 0, 1, 2 \
    }

/* For a slider between links 3 and 4, the normal force, which is in the first equations, comes before the
** couple. */
static const layout banded[2] = {{ROWS, PLACES(COLUMN, 2, 3)}, {ROWS, PLACES(COLUMN, 3, 2)}};
static const int places[2][9] = {PLACES(PLACE, 2, 3), PLACES(PLACE, 3, 2)};

/* With the effort of a drive between F34 and F23, whose loads can be on any link, the band is 4 below
** and 4 above. */
#define WIDE_COLUMN(j) ((FLK_WIDE_BAND - 1) * (j) + FLK_WIDE + FLK_WIDE)
#define WIDE_PLACES(X, x34, y34)                                 \
    {                                                            \
        X(7), X(8), X(5), X(6), X(x34), X(y34), X(0), X(1), X(4) \
    }
static const layout wide[2] = {{ROWS, WIDE_PLACES(WIDE_COLUMN, 2, 3)},
                               {ROWS, WIDE_PLACES(WIDE_COLUMN, 3, 2)}};
static const int wide_places[2][9] = {WIDE_PLACES(PLACE, 2, 3), WIDE_PLACES(PLACE, 3, 2)};

/* The band of the matrix: crank-driven or with another drive. */
typedef struct band {
    size_t below, above, size;
    const layout *layouts;
    const int (*places)[9];
} band;

static const band bands[2] = {{FLK_BELOW, FLK_ABOVE, FLK_BAND, banded, places},
                              {FLK_WIDE, FLK_WIDE, FLK_WIDE_BAND, wide, wide_places}};

static int factor_matrix(const flk_kind *kind, const fourlink_mechanism *mechanism,
                         const fourlink_state *state, flk_factors *factors)
{
    static const fourlink_vector origins[3] = {{0, 0}, {0, 0}, {0, 0}};
    const fourlink_link *link = mechanism->design.link;
    double length = 0;
    const band *b = &bands[mechanism->drive != NULL];
    const layout *at = &b->layouts[kind->joint[2].slider != 0];
    scaling scale = banded_scale;
    gsl_matrix_view A_view = gsl_matrix_view_array(factors->A, 9, b->size);
    gsl_vector_uint_view pivot_view = gsl_vector_uint_view_array(factors->pivot, 9);
    flk_unit_drive drive;
    size_t k;
    int i, status;

    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++) {
        length = kind->has_length[i] == FLK_LENGTH ? link[i].length : length;
        scale.moment[i] /= length;
    }
    memcpy(factors->moment, scale.moment, sizeof factors->moment);
    put_joints(kind, mechanism, state, origins, &scale, at, 9 * b->size, factors->A);
    if (flk_groups_are_singular(mechanism, state))
        return FOURLINK_SINGULAR;
    if (mechanism->drive) {
        status = flk_drive_unit(mechanism->drive, mechanism, state, &drive);
        if (status != FOURLINK_OK)
            return status;
        factors->K = drive.K;
        factors->scale = put_drive(&drive, mechanism, state, origins, &scale, at, factors->A);
    }
    gsl_linalg_LU_band_decomp(9, b->below, b->above, &A_view.matrix, &pivot_view.vector);
    for (k = 0; k < 9; k++)
        if (!(fabs(factors->A[(b->size - 1) * k + b->below + b->above + k]) > FLK_SINGULAR))
            return FOURLINK_SINGULAR;
    return FOURLINK_OK;
}

static void find_unknowns(const flk_kind *kind, const fourlink_mechanism *mechanism,
                          const flk_factors *factors, const flk_body body[3], double x[9])
{
    double ordered[9];
    const band *b = &bands[mechanism->drive != NULL];
    const layout *at = &b->layouts[kind->joint[2].slider != 0];
    const int *place = b->places[kind->joint[2].slider != 0];
    gsl_matrix_const_view A_view = gsl_matrix_const_view_array(factors->A, 9, b->size);
    gsl_vector_uint_const_view pivot_view = gsl_vector_uint_const_view_array(factors->pivot, 9);
    gsl_vector_view x_view = gsl_vector_view_array(ordered, 9);
    int i;

    for (i = 0; i < 3; i++) {
        double scale = banded_scale.force[i + 2];

        ordered[at->row[3 * i]] = scale * body[i].force.x;
        ordered[at->row[3 * i + 1]] = scale * body[i].force.y;
        ordered[at->row[3 * i + 2]] = factors->moment[i + 2] * FLK_MOMENT_ABOUT_ORIGIN(&body[i]);
    }
    gsl_linalg_LU_band_svx(b->below, b->above, &A_view.matrix, &pivot_view.vector, &x_view.vector);
    for (i = 0; i < 9; i++)
        x[i] = ordered[place[i]];
    for (i = 0; i < 4; i++)
        if (kind->joint[i].slider)
            x[2 * i] /= factors->moment[kind->joint[i].on];
    x[8] /= mechanism->drive ? factors->scale : factors->moment[FOURLINK_CRANK];
}

int fourlink_system(const fourlink_mechanism *mechanism, const fourlink_state *state,
                    const fourlink_load *loads, unsigned long n_loads, double A[9][9], double b[9])
{
    static const layout dense = {{0, 9, 18, 27, 36, 45, 54, 63, 72}, {0, 1, 2, 3, 4, 5, 6, 7, 8}};
    static const scaling none = {{1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}};
    const flk_kind *kind;
    flk_body body[3];
    fourlink_vector centre[3];
    flk_unit_drive drive;
    double largest;
    int i, status;

    status = flk_kind_find(mechanism, A, &kind);
    if (status == FOURLINK_OK)
        status = state && b ? flk_check_loads(mechanism, loads, n_loads) : FOURLINK_NULL;
    if (status != FOURLINK_OK)
        return status;
    flk_cut_free(mechanism, state, loads, n_loads, 0, body);
    for (i = 0; i < 3; i++) {
        centre[i] = body[i].arm;
        b[3 * i] = body[i].force.x;
        b[3 * i + 1] = body[i].force.y;
        b[3 * i + 2] = body[i].moment;
    }
    put_joints(kind, mechanism, state, centre, &none, &dense, 81, A[0]);
    if (mechanism->drive) {
        status = flk_drive_unit(mechanism->drive, mechanism, state, &drive);
        if (status != FOURLINK_OK)
            return status;
        largest = put_drive(&drive, mechanism, state, centre, &none, &dense, A[0]);
        for (i = 0; i < 9; i++)
            A[i][8] *= largest;
    }
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

static void solve_matrix(const flk_kind *kind, const fourlink_mechanism *mechanism,
                         const fourlink_state *state, const flk_factors *factors,
                         const flk_body body[3], fourlink_forces *forces)
{
    double x[9];

    (void)mechanism;
    find_unknowns(kind, mechanism, factors, body, x);
    list_forces(kind, state, x, forces);
    forces->drive = forces->at_crank = x[8];
    if (mechanism->drive) {
        forces->Ts = 0;
        forces->at_crank *= factors->K;
    }
}

const flk_solver flk_nine_equations = {factor_matrix, solve_matrix};

int fourlink_solve(const fourlink_mechanism *mechanism, const fourlink_state *state,
                   const fourlink_load *loads, unsigned long n_loads, fourlink_forces *forces)
{
    const flk_kind *kind;
    flk_factors factors;
    flk_body body[3];
    fourlink_forces result;
    int status;

    status = flk_kind_find(mechanism, forces, &kind);
    if (status == FOURLINK_OK)
        status = state ? flk_check_loads(mechanism, loads, n_loads) : FOURLINK_NULL;
    if (status != FOURLINK_OK)
        return status;
    status = factor_matrix(kind, mechanism, state, &factors);
    if (status != FOURLINK_OK)
        return status;
    flk_cut_free(mechanism, state, loads, n_loads, 0, body);
    solve_matrix(kind, mechanism, state, &factors, body, &result);
    flk_virtual_work(state, body, &result);
    if (!flk_is_finite(&result))
        return FOURLINK_BAD_NUMBER;
    *forces = result;
    return FOURLINK_OK;
}
