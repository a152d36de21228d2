/* SPDX-License-Identifier: GPL-3.0-or-later
**
** group_forces.c - the forces in groups, and what the groups do to the links that carry them.
*/
#include <string.h>

#include <gsl/gsl_linalg.h>

#include "base/trig.h"
#include "body.h"
#include "group.h"
#include "group_type.h"

int flk_groups_are_singular(const fourlink_mechanism *mechanism, const fourlink_state *state)
{
    int i;

    if (!mechanism->design.n_groups)
        return 0;
    for (i = FOURLINK_ROD_OF(0); i <= FLK_LAST_LINK(mechanism); i++)
        if (!FLK_BOTH_WITHIN(state->link[i].axis, 2))
            return 1;
    return state->last != FLK_LAST_LINK(mechanism) || !(state->group_sine > FLK_SINGULAR);
}

/* The arm of the point of slider or rocker where rod or block acts on it, from its origin: r e6 of a
** rocker with a pin Q, and of a slider 0; to the block in a slot of its own. */
static fourlink_vector arm_of(const fourlink_group *group, const fourlink_link_state *rod,
                              const fourlink_link_state *end)
{
    fourlink_vector arm = {0, 0};

    if (group->hang == FOURLINK_HANGS_BY_OWN_SLOT) {
        arm.x = rod->origin.x - end->origin.x;
        arm.y = rod->origin.y - end->origin.y;
    } else if (group->end == FOURLINK_GROUP_TURNS) {
        arm.x = group->length * end->axis.x;
        arm.y = group->length * end->axis.y;
    }
    return arm;
}

/* In closed form: FQ from the type, then FP = f5 + FQ, FD = f6 - FQ; of a guide, only what is square to
** it, and the couple M6 - rho x FQ. */
static void solve_closed(const fourlink_group *group, const fourlink_link_state *rod,
                         const flk_body body[2], flk_group_forces *f)
{
    const fourlink_link_state *end = rod + 1;

    f->FQ = flk_group_type_of(group)->solve(group, rod, end, body);
    f->FP.x = body[0].force.x + f->FQ.x;
    f->FP.y = body[0].force.y + f->FQ.y;
    f->FD.x = body[1].force.x - f->FQ.x;
    f->FD.y = body[1].force.y - f->FQ.y;
    f->M = 0;
    if (group->end == FOURLINK_GROUP_SLIDES) {
        fourlink_vector n, rho = arm_of(group, rod, end);
        double N;

        FLK_TURN_LEFT(n, end->axis);
        N = FLK_DOT(n, f->FD);
        f->FD.x = N * n.x;
        f->FD.y = N * n.y;
        f->M = FLK_MOMENT_ABOUT_ORIGIN(&body[1]) - FLK_CROSS(rho, f->FQ);
    }
}

/* The six equations of a group, moments about the origins of its links, divided by a length L, that of a rod:
**
**    FP - FQ = f5,   -l e5 x FQ = M5
**    FQ + FD = f6,   rho x FQ (+ M) = M6
**
** FD of a slider is N nu.  Of a block in a slot with the normal n, M5 = 0 and one of its forces is S n,
** with a couple C that acts on slider or rocker, or comes from the carrying link; the other one is that of
** its pin:
**
**    FP - FQ = 0,   C = 0
**
** They are solved apart from the nine of the four links, which they do not contain. GSL's banded
** decomposition, with every diagonal in the band, allocates nothing. */
#define SIX 6
#define BAND (SIX - 1)
#define WIDTH (3 * BAND + 1)
#define AT(A, row, column) (A)[(column)*WIDTH + 2 * BAND + (row) - (column)]

/* Put one of the forces FP or FQ, whose unknowns are `first` and the next, into the equations of the
** block and of slider or rocker: its components, or S and C. */
static void put_force(double *A, int first, const fourlink_vector *n, const fourlink_vector *rho,
                      double L)
{
    int sign = first == 0 ? 1 : -1, i;

    for (i = 0; i < 2; i++) {
        if (!n) {
            AT(A, i, first + i) = sign;
            if (first)
                AT(A, 3 + i, first + i) = 1;
        } else {
            AT(A, i, first) = sign * (i ? n->y : n->x);
            if (first)
                AT(A, 3 + i, first) = i ? n->y : n->x;
        }
    }
    if (n)
        AT(A, 2, first + 1) = sign;
    if (first && n) {
        AT(A, 5, first) = FLK_CROSS(*rho, *n) / L;
        AT(A, 5, first + 1) = 1;
    } else if (first) {
        AT(A, 5, first) = -rho->y / L;
        AT(A, 5, first + 1) = rho->x / L;
    }
}

static void put_equations(const fourlink_group *group, const fourlink_link_state *rod, double L,
                          double *A)
{
    const fourlink_link_state *end = rod + 1;
    fourlink_vector n, nu, rho = arm_of(group, rod, end);

    FLK_TURN_LEFT(n, rod->axis);
    FLK_TURN_LEFT(nu, end->axis);
    memset(A, 0, SIX * WIDTH * sizeof A[0]);
    put_force(A, 0, group->hang == FOURLINK_HANGS_IN_SLOT ? &n : NULL, &rho, L);
    put_force(A, 2, group->hang == FOURLINK_HANGS_BY_OWN_SLOT ? &n : NULL, &rho, L);
    if (group->hang == FOURLINK_HANGS_BY_ROD) {
        AT(A, 2, 2) = rod->axis.y * (group->rod / L);
        AT(A, 2, 3) = -rod->axis.x * (group->rod / L);
    }
    if (group->end == FOURLINK_GROUP_SLIDES) {
        AT(A, 3, 4) = nu.x;
        AT(A, 4, 4) = nu.y;
        AT(A, 5, 5) = 1;
    } else {
        AT(A, 3, 4) = 1;
        AT(A, 4, 5) = 1;
    }
}

/* The length by which moments are divided. */
static double length_of(const fourlink_group *group, const fourlink_link_state *rod)
{
    fourlink_vector rho;
    double L;

    if (group->hang == FOURLINK_HANGS_BY_ROD)
        return group->rod;
    rho = arm_of(group, rod, rod + 1);
    L = flk_length(rho.x, rho.y);
    return L > 0 ? L : 1;
}

static void put_right_side(const flk_body body[2], double L, double b[SIX])
{
    int i;

    for (i = 0; i < 2; i++) {
        b[3 * i] = body[i].force.x;
        b[3 * i + 1] = body[i].force.y;
        b[3 * i + 2] = FLK_MOMENT_ABOUT_ORIGIN(&body[i]) / L;
    }
}

/* The solution, whose couples are divided by L. */
static void solve_six(const fourlink_group *group, const fourlink_link_state *rod,
                      const flk_body body[2], double L, double x[SIX])
{
    double A[SIX * WIDTH];
    unsigned int pivot[SIX];
    gsl_matrix_view A_view = gsl_matrix_view_array(A, SIX, WIDTH);
    gsl_vector_uint_view pivot_view = gsl_vector_uint_view_array(pivot, SIX);
    gsl_vector_view x_view = gsl_vector_view_array(x, SIX);

    put_equations(group, rod, L, A);
    put_right_side(body, L, x);
    gsl_linalg_LU_band_decomp(SIX, BAND, BAND, &A_view.matrix, &pivot_view.vector);
    gsl_linalg_LU_band_svx(BAND, BAND, &A_view.matrix, &pivot_view.vector, &x_view.vector);
}

static void solve_equations(const fourlink_group *group, const fourlink_link_state *rod,
                            const flk_body body[2], flk_group_forces *f)
{
    double x[SIX], L = length_of(group, rod);
    fourlink_vector n, nu;

    FLK_TURN_LEFT(n, rod->axis);
    FLK_TURN_LEFT(nu, rod[1].axis);
    solve_six(group, rod, body, L, x);
    f->FP.x = group->hang == FOURLINK_HANGS_IN_SLOT ? x[0] * n.x : x[0];
    f->FP.y = group->hang == FOURLINK_HANGS_IN_SLOT ? x[0] * n.y : x[1];
    f->FQ.x = group->hang == FOURLINK_HANGS_BY_OWN_SLOT ? x[2] * n.x : x[2];
    f->FQ.y = group->hang == FOURLINK_HANGS_BY_OWN_SLOT ? x[2] * n.y : x[3];
    f->FD.x = x[4];
    f->FD.y = x[5];
    f->M = 0;
    if (group->end == FOURLINK_GROUP_SLIDES) {
        f->FD.x = x[4] * nu.x;
        f->FD.y = x[4] * nu.y;
        f->M = x[5] * L;
    }
}

/* Take from a link the force F of it on a group, at an arm from its origin. */
static void take_force(fourlink_vector r, const fourlink_vector *F, flk_body *body)
{
    r.x -= body->arm.x;
    r.y -= body->arm.y;
    body->force.x += F->x;
    body->force.y += F->y;
    body->moment += FLK_CROSS(r, *F);
}

/* The forces of the groups, unless the list is null, the last one first: each adds to the free bodies of
** the links that carry it.  What its bodies do in virtual work is added to that of the crank: -FP must
** not be counted besides. */
static void pass_on(const fourlink_mechanism *mechanism, const fourlink_state *state,
                    int closed_form, flk_body *body, flk_group_forces *list)
{
    int i;

    for (i = mechanism->design.n_groups - 1; i >= 0; i--) {
        const fourlink_group *g = &mechanism->design.group[i];
        const fourlink_link_state *rod = &state->link[FOURLINK_ROD_OF(i)];
        const flk_body *own = &body[FOURLINK_ROD_OF(i) - 2];
        const fourlink_link_state *on = &state->link[g->link], *to = &state->link[g->to];
        flk_group_forces f;
        fourlink_vector r;

        if (closed_form)
            solve_closed(g, rod, own, &f);
        else
            solve_equations(g, rod, own, &f);
        flk_group_arm(g, on, rod, &r);
        take_force(r, &f.FP, &body[g->link - 2]);
        if (g->to > FOURLINK_GROUND) {
            FLK_TURN(r, to, g->pivot);
            take_force(r, &f.FD, &body[g->to - 2]);
        }
        body[0].work += own[0].work + own[1].work;
        body[0].largest = flk_larger(body[0].largest, flk_larger(own[0].largest, own[1].largest));
        if (list)
            list[i] = f;
    }
}

/* The bodies of all links, by number - 2, the first three of them cut free but without their loads; the
** forces of the groups, unless null. */
static void cut_all(const fourlink_mechanism *mechanism, const fourlink_state *state,
                    const fourlink_load *loads, unsigned long n_loads, double effort,
                    int closed_form, flk_body *body, flk_group_forces *list)
{
    fourlink_load drive[2];
    unsigned long n;
    int i, n_drive = 0;

    for (i = FOURLINK_ROD_OF(0); i <= FLK_LAST_LINK(mechanism); i++)
        flk_cut_link(FLK_LINK(mechanism, i), &state->link[i], &mechanism->design.gravity,
                     &body[i - 2]);
    for (n = 0; n < n_loads; n++)
        flk_apply_load(&loads[n], &state->link[loads[n].link], &body[loads[n].link - 2]);
    if (effort != 0)
        fourlink_drive_loads(mechanism, state, effort, drive, &n_drive);
    for (i = 0; i < n_drive; i++)
        flk_apply_load(&drive[i], &state->link[drive[i].link], &body[drive[i].link - 2]);
    pass_on(mechanism, state, closed_form, body, list);
}

void flk_groups_pass(const fourlink_mechanism *mechanism, const fourlink_state *state,
                     const fourlink_load *loads, int n_loads, int closed_form, flk_body body[3])
{
    flk_body all[FOURLINK_LINKS - 2];
    int i;

    memset(all, 0, sizeof all);
    memcpy(all, body, 3 * sizeof *body);
    for (i = 0; i < n_loads; i++)
        flk_apply_load(&loads[i], &state->link[loads[i].link], &all[loads[i].link - 2]);
    pass_on(mechanism, state, closed_form, all, NULL);
    memcpy(body, all, 3 * sizeof *body);
}

void flk_groups_cut(const fourlink_mechanism *mechanism, const fourlink_state *state,
                    const fourlink_load *loads, unsigned long n_loads, int closed_form,
                    flk_body body[3])
{
    flk_body all[FOURLINK_LINKS - 2];

    memcpy(all, body, 3 * sizeof *body);
    cut_all(mechanism, state, loads, n_loads, 0, closed_form, all, NULL);
    memcpy(body, all, 3 * sizeof *body);
}

/* Cut links 2 to 4, without their loads. */
static void cut_four(const fourlink_mechanism *mechanism, const fourlink_state *state,
                     flk_body *body)
{
    int i;

    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        flk_cut_link(FLK_LINK(mechanism, i), &state->link[i], &mechanism->design.gravity,
                     &body[i - 2]);
}

void flk_groups_forces(const fourlink_mechanism *mechanism, const fourlink_state *state,
                       const fourlink_load *loads, unsigned long n_loads, double effort,
                       int closed_form, flk_group_forces *list)
{
    flk_body all[FOURLINK_LINKS - 2];

    cut_four(mechanism, state, all);
    cut_all(mechanism, state, loads, n_loads, effort, closed_form, all, list);
}

/* ------------------------------------------------------------------------------------------- equations */

const char *fourlink_group_unknown_text(const fourlink_group *group, int i)
{
    static const char *const pins[SIX] = {"FPx", "FPy", "FQx", "FQy", "FDx", "FDy"};
    static const char *const slot[2] = {"S", "C"}, *const guide[2] = {"N", "M"};

    if (!group || i < 0 || i >= SIX)
        return "unknown";
    if (i < 2)
        return group->hang == FOURLINK_HANGS_IN_SLOT ? slot[i] : pins[i];
    if (i < 4)
        return group->hang == FOURLINK_HANGS_BY_OWN_SLOT ? slot[i - 2] : pins[i];
    return group->end == FOURLINK_GROUP_SLIDES ? guide[i - 4] : pins[i];
}

/* Moments are not divided: L is 1. */
int fourlink_group_system(const fourlink_mechanism *mechanism, const fourlink_state *state,
                          const fourlink_load *loads, unsigned long n_loads, int group,
                          double A[6][6], double b[6], double x[6])
{
    const flk_kind *kind;
    flk_group_forces list[FOURLINK_MOST_GROUPS];
    flk_body all[FOURLINK_LINKS - 2];
    double banded[SIX * WIDTH];
    const fourlink_link_state *rod;
    int status = flk_kind_find(mechanism, A, &kind), i, j;

    if (status == FOURLINK_OK)
        status = state && b && x ? flk_check_loads(mechanism, loads, n_loads) : FOURLINK_NULL;
    if (status == FOURLINK_OK && (group < 0 || group >= mechanism->design.n_groups))
        status = FOURLINK_BAD_GROUP;
    if (status == FOURLINK_OK && flk_groups_are_singular(mechanism, state))
        status = FOURLINK_SINGULAR;
    if (status != FOURLINK_OK)
        return status;
    rod = &state->link[FOURLINK_ROD_OF(group)];
    cut_four(mechanism, state, all);
    cut_all(mechanism, state, loads, n_loads, 0, 0, all, list);
    put_equations(&mechanism->design.group[group], rod, 1, banded);
    for (i = 0; i < SIX; i++)
        for (j = 0; j < SIX; j++)
            A[i][j] = AT(banded, i, j);
    put_right_side(&all[FOURLINK_ROD_OF(group) - 2], 1, b);
    solve_six(&mechanism->design.group[group], rod, &all[FOURLINK_ROD_OF(group) - 2], 1, x);
    return FOURLINK_OK;
}
