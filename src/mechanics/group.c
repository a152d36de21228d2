/* SPDX-License-Identifier: GPL-3.0-or-later
**
** group.c - groups: a rod on a point P of a moving link, and a slider or a rocker on its other pin Q.
**
** A group is a dyad (an Assur group): it has no degree of freedom, and its motion follows from that of P and,
** for a rocker whose pin is on a moving link, of this pin.  To the link that carries it, it is a force -FP at
** P.  So groups move after the four links, each after those on which it hangs, and their forces are found
** before those of the four links, the outermost first.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_linalg.h>

#include "base/trig.h"
#include "body.h"
#include "group.h"

/* A group in a state, with the points between which it hangs. */
typedef struct hanging {
    const fourlink_group *group;
    const fourlink_link_state *on, *to; /* the carrying link; that with the pin, null: the ground */
    fourlink_link_state *rod, *end;
} hanging;

/* What differs between types of groups.
**
** place        axes and origins of both links; returns the square of the sine of its position, negative where it
**              cannot be assembled
** move         k of both, from the derivatives of P (of the rod's origin) and of `pivot`
** accelerate   alpha of both, and the acceleration of a slider's origin
** solve        FQ in closed form, from the free bodies and their moments about their origins
*/
typedef struct type {
    double (*place)(const hanging *h, const fourlink_vector *pivot);
    void (*move)(const hanging *h, const fourlink_vector *pivot);
    void (*accelerate)(const hanging *h, const fourlink_vector *pivot);
    fourlink_vector (*solve)(const fourlink_group *group, const fourlink_link_state *rod,
                             const fourlink_link_state *end, const flk_body body[2]);
} type;

/* J v, v turned left by 90 deg */
static fourlink_vector left_of(const fourlink_vector *v)
{
    fourlink_vector n;

    n.x = 0 - v->y;
    n.y = v->x;
    return n;
}

/* --------------------------------------------------------------------------------------------- slider
**
** With d = P - P0, u the direction of the line through P0, nu = J u, l the rod and e5 its axis,
**
**    c = nu.d / l,   rho = +- sqrt(1 - c^2),   e5 = rho u - c nu,   Q = P + l e5
**    omega5 = -nu.v / (l rho),   alpha5 = (-nu.a + l omega5^2 nu.e5) / (l rho)
**
** v and a being the velocity and the acceleration of P.  It is dead where the rod is square to the line.
*/
static double place_slider(const hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *u = &h->group->direction, *p = &h->rod->origin;
    double l = h->group->rod, c, square, rho;
    fourlink_vector d;

    d.x = p->x - pivot->x;
    d.y = p->y - pivot->y;
    c = FLK_CROSS(*u, d) / l;
    square = (1 - c) * (1 + c);
    if (!(square > FLK_DEAD))
        return square;
    rho = h->group->side * sqrt(square);
    h->rod->axis.x = rho * u->x + c * u->y;
    h->rod->axis.y = rho * u->y - c * u->x;
    h->end->axis = *u;
    h->end->origin.x = p->x + l * h->rod->axis.x;
    h->end->origin.y = p->y + l * h->rod->axis.y;
    return square;
}

static void move_slider(const hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *u = &h->group->direction, *e5 = &h->rod->axis, *v = &h->rod->k_origin;
    double l = h->group->rod, along;

    (void)pivot;
    h->rod->k = -FLK_CROSS(*u, *v) / (l * FLK_DOT(*u, *e5));
    along = FLK_DOT(*u, *v) - l * h->rod->k * FLK_CROSS(*u, *e5);
    h->end->k = 0;
    h->end->k_origin.x = along * u->x;
    h->end->k_origin.y = along * u->y;
}

static void accelerate_slider(const hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *u = &h->group->direction, *e5 = &h->rod->axis;
    const fourlink_vector *a = &h->rod->acceleration;
    double l = h->group->rod, n = l * h->rod->omega * h->rod->omega, along;

    (void)pivot;
    h->rod->alpha = (n * FLK_CROSS(*u, *e5) - FLK_CROSS(*u, *a)) / (l * FLK_DOT(*u, *e5));
    along = FLK_DOT(*u, *a) - l * h->rod->alpha * FLK_CROSS(*u, *e5) - n * FLK_DOT(*u, *e5);
    h->end->alpha = 0;
    h->end->acceleration.x = along * u->x;
    h->end->acceleration.y = along * u->y;
}

/* The guide takes what is square to the line: FQ along it is the slider's own; the rest from the moments of
** the rod about P, with M5 its right-hand side,
**
**    FQ = Fu u + Fn nu,   Fu = u.f6,   -l e5 x FQ = M5
*/
static fourlink_vector solve_slider(const fourlink_group *group, const fourlink_link_state *rod,
                                    const fourlink_link_state *end, const flk_body body[2])
{
    const fourlink_vector *u = &group->direction, *e5 = &rod->axis;
    double along = FLK_DOT(*u, body[1].force), across;
    fourlink_vector FQ;

    (void)end;
    across = (-FLK_MOMENT_ABOUT_ORIGIN(&body[0]) / group->rod - FLK_CROSS(*e5, *u) * along) /
             FLK_DOT(*e5, *u);
    FQ.x = along * u->x - across * u->y;
    FQ.y = along * u->y + across * u->x;
    return FQ;
}

/* --------------------------------------------------------------------------------------------- rocker
**
** With x = D - P, f its length, l and r the rod and the rocker, e5 and e6 their axes from P and from D,
**
**    h = (f^2 + l^2 - r^2) / (2 f),   Q = P + h x / f +- sqrt(l^2 - h^2) J x / f
**    sin^2 = ((l + r)^2 - f^2) (f^2 - (l - r)^2) / (2 l r)^2,   sqrt(l^2 - h^2) = l r |sin| / f
**
** and with S = e5 x e6, v and a of P relative to D,
**
**    omega5 = -e6.v / (l S)                                     omega6 = -e5.v / (r S)
**    alpha5 = (-e6.a + l omega5^2 e5.e6 - r omega6^2) / (l S)
**    alpha6 = (-e5.a + l omega5^2 - r omega6^2 e5.e6) / (r S)
**
** It is dead where rod and rocker are in line.
*/
static double place_rocker(const hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *p = &h->rod->origin;
    double l = h->group->rod, r = h->group->length, f, along, across, square;
    fourlink_vector x, n;

    x.x = pivot->x - p->x;
    x.y = pivot->y - p->y;
    f = flk_length(x.x, x.y);
    square = ((l + r - f) / l) * ((l + r + f) / r) * ((f - fabs(l - r)) / l) *
             ((f + fabs(l - r)) / r) / 4;
    if (!(square > FLK_DEAD))
        return square;
    x.x /= f;
    x.y /= f;
    n = left_of(&x);
    along = (f + (l - r) * ((l + r) / f)) / 2;
    across = h->group->side * l * (r / f) * sqrt(square);
    h->rod->axis.x = (along * x.x + across * n.x) / l;
    h->rod->axis.y = (along * x.y + across * n.y) / l;
    h->end->axis.x = ((along - f) * x.x + across * n.x) / r;
    h->end->axis.y = ((along - f) * x.y + across * n.y) / r;
    h->end->origin = *pivot;
    return square;
}

static void move_rocker(const hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *e5 = &h->rod->axis, *e6 = &h->end->axis;
    double sine = FLK_CROSS(*e5, *e6);
    fourlink_vector v;

    v.x = h->rod->k_origin.x - pivot->x;
    v.y = h->rod->k_origin.y - pivot->y;
    h->rod->k = -FLK_DOT(*e6, v) / (h->group->rod * sine);
    h->end->k = -FLK_DOT(*e5, v) / (h->group->length * sine);
    h->end->k_origin = *pivot;
}

static void accelerate_rocker(const hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *e5 = &h->rod->axis, *e6 = &h->end->axis;
    double sine = FLK_CROSS(*e5, *e6), cosine = FLK_DOT(*e5, *e6);
    double n5 = h->group->rod * h->rod->omega * h->rod->omega;
    double n6 = h->group->length * h->end->omega * h->end->omega;
    fourlink_vector a;

    a.x = h->rod->acceleration.x - pivot->x;
    a.y = h->rod->acceleration.y - pivot->y;
    h->rod->alpha = (n5 * cosine - n6 - FLK_DOT(*e6, a)) / (h->group->rod * sine);
    h->end->alpha = (n5 - n6 * cosine - FLK_DOT(*e5, a)) / (h->group->length * sine);
    h->end->acceleration = *pivot;
}

/* Moments of the rod about P and of the rocker about D, with M5 and M6 their right-hand sides:
**
**    -l e5 x FQ = M5,   r e6 x FQ = M6
*/
static fourlink_vector solve_rocker(const fourlink_group *group, const fourlink_link_state *rod,
                                    const fourlink_link_state *end, const flk_body body[2])
{
    const fourlink_vector *e5 = &rod->axis, *e6 = &end->axis;
    double m5 = -FLK_MOMENT_ABOUT_ORIGIN(&body[0]) / group->rod;
    double m6 = FLK_MOMENT_ABOUT_ORIGIN(&body[1]) / group->length, sine = FLK_CROSS(*e5, *e6);
    fourlink_vector FQ;

    FQ.x = (m6 * e5->x - m5 * e6->x) / -sine;
    FQ.y = (m6 * e5->y - m5 * e6->y) / -sine;
    return FQ;
}

/* By fourlink_group_end. */
static const type types[] = {{NULL, NULL, NULL, NULL},
                             {place_slider, move_slider, accelerate_slider, solve_slider},
                             {place_rocker, move_rocker, accelerate_rocker, solve_rocker}};

#define TYPES ((int)(sizeof types / sizeof types[0]))

/* ----------------------------------------------------------------------------------------------- check */

#define UNIT 1e-9 /* by which the length of a unit vector may differ from 1 */

static int check_group(const fourlink_group *g, int first)
{
    int is_slider = g->end == FOURLINK_GROUP_SLIDES, i, status;

    if ((int)g->end < 1 || (int)g->end >= TYPES || (g->side != 1 && g->side != -1) ||
        g->link < FOURLINK_CRANK || g->link >= first || g->to < 0 || g->to >= first ||
        (g->to > FOURLINK_GROUND && (is_slider || g->to == g->link)))
        return FOURLINK_BAD_GROUP;
    status = flk_check_length(g->rod);
    if (status == FOURLINK_OK && !is_slider)
        status = flk_check_length(g->length);
    if (status != FOURLINK_OK)
        return status;
    if (!FLK_BOTH_WITHIN(g->at, FOURLINK_LENGTH_MAX) ||
        !FLK_BOTH_WITHIN(g->pivot, FOURLINK_LENGTH_MAX) ||
        (is_slider && !FLK_WITHIN(FLK_DOT(g->direction, g->direction) - 1, UNIT)))
        return FOURLINK_BAD_NUMBER;
    for (i = 0; i < 2 && status == FOURLINK_OK; i++)
        status = flk_check_link(&g->body[i]);
    return status;
}

int flk_groups_check(const fourlink_design *design)
{
    int i, status = FOURLINK_OK;

    if (design->n_groups < 0 || design->n_groups > FOURLINK_MOST_GROUPS)
        return FOURLINK_BAD_GROUP;
    if (design->n_groups && !design->group)
        return FOURLINK_NULL;
    for (i = 0; i < design->n_groups && status == FOURLINK_OK; i++)
        status = check_group(&design->group[i], FLK_ROD_OF(i));
    return status;
}

/* ---------------------------------------------------------------------------------------------- motion */

static hanging find(const fourlink_mechanism *mechanism, fourlink_state *state, int i)
{
    hanging h;

    h.group = &mechanism->design.group[i];
    h.on = &state->link[h.group->link];
    h.to = h.group->to > FOURLINK_GROUND ? &state->link[h.group->to] : NULL;
    h.rod = &state->link[FLK_ROD_OF(i)];
    h.end = h.rod + 1;
    return h;
}

static double place_group(const hanging *h)
{
    fourlink_vector r, pivot = h->group->pivot;

    FLK_TURN(r, h->on, h->group->at);
    h->rod->origin.x = h->on->origin.x + r.x;
    h->rod->origin.y = h->on->origin.y + r.y;
    if (h->to) {
        FLK_TURN(r, h->to, h->group->pivot);
        pivot.x = h->to->origin.x + r.x;
        pivot.y = h->to->origin.y + r.y;
    }
    return types[h->group->end].place(h, &pivot);
}

int flk_groups_place(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    double square, smallest = 1;
    int i;

    for (i = 0; i < mechanism->design.n_groups; i++) {
        hanging h = find(mechanism, state, i);

        square = place_group(&h);
        if (!(square > FLK_DEAD))
            return square < -FLK_DEAD ? FOURLINK_GROUP_APART : FOURLINK_DEAD_POSITION;
        smallest = square < smallest ? square : smallest;
    }
    state->group_sine = sqrt(smallest);
    return FOURLINK_OK;
}

double flk_groups_margin(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    double margin = 1, square[FOURLINK_LINKS];
    int i;

    for (i = 0; i < FLK_ROD_OF(0); i++)
        square[i] = 1;
    for (i = 0; i < mechanism->design.n_groups; i++) {
        hanging h = find(mechanism, state, i);
        int is_there = square[h.group->link] > FLK_DEAD && square[h.group->to] > FLK_DEAD;

        square[FLK_ROD_OF(i)] = square[FLK_ROD_OF(i) + 1] = is_there ? place_group(&h) : -1;
        if (is_there && square[FLK_ROD_OF(i)] < margin)
            margin = square[FLK_ROD_OF(i)];
    }
    return margin;
}

static void scale_velocity(fourlink_link_state *link, double omega2)
{
    link->omega = link->k * omega2;
    link->velocity.x = link->k_origin.x * omega2;
    link->velocity.y = link->k_origin.y * omega2;
}

void flk_groups_move(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    double omega2 = state->link[FOURLINK_CRANK].omega;
    int i;

    for (i = 0; i < mechanism->design.n_groups; i++) {
        hanging h = find(mechanism, state, i);
        fourlink_vector r, pivot = {0, 0};

        FLK_TURN(r, h.on, h.group->at);
        FLK_UNIT_VELOCITY(h.rod->k_origin, h.on, r);
        if (h.to) {
            FLK_TURN(r, h.to, h.group->pivot);
            FLK_UNIT_VELOCITY(pivot, h.to, r);
        }
        types[h.group->end].move(&h, &pivot);
        scale_velocity(h.rod, omega2);
        scale_velocity(h.end, omega2);
    }
}

void flk_groups_accelerate(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    int i;

    for (i = 0; i < mechanism->design.n_groups; i++) {
        hanging h = find(mechanism, state, i);
        fourlink_vector r, pivot = {0, 0};

        FLK_TURN(r, h.on, h.group->at);
        FLK_ACCELERATION(h.rod->acceleration, h.on, r);
        if (h.to) {
            FLK_TURN(r, h.to, h.group->pivot);
            FLK_ACCELERATION(pivot, h.to, r);
        }
        types[h.group->end].accelerate(&h, &pivot);
    }
}

void flk_groups_angles(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    int i;

    for (i = FLK_ROD_OF(0); i <= FLK_LAST_LINK(mechanism); i++)
        state->link[i].theta = flk_angle_of_axis(&state->link[i].axis);
}

int flk_groups_follow(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    int status = flk_groups_place(mechanism, state);

    if (status != FOURLINK_OK)
        return status;
    flk_groups_move(mechanism, state);
    flk_groups_accelerate(mechanism, state);
    return FOURLINK_OK;
}

/* ---------------------------------------------------------------------------------------------- forces */

int flk_groups_are_singular(const fourlink_mechanism *mechanism, const fourlink_state *state)
{
    int i;

    if (!mechanism->design.n_groups)
        return 0;
    for (i = FLK_ROD_OF(0); i <= FLK_LAST_LINK(mechanism); i++)
        if (!FLK_BOTH_WITHIN(state->link[i].axis, 2))
            return 1;
    return state->last != FLK_LAST_LINK(mechanism) || !(state->group_sine > FLK_SINGULAR);
}

/* In closed form: FQ from the type, then FP = f5 + FQ, FD = f6 - FQ; of a guide, only what is square to it. */
static void solve_closed(const fourlink_group *group, const fourlink_link_state *rod,
                         const flk_body body[2], flk_group_forces *f)
{
    const fourlink_link_state *end = rod + 1;

    f->FQ = types[group->end].solve(group, rod, end, body);
    f->FP.x = body[0].force.x + f->FQ.x;
    f->FP.y = body[0].force.y + f->FQ.y;
    f->FD.x = body[1].force.x - f->FQ.x;
    f->FD.y = body[1].force.y - f->FQ.y;
    f->M = 0;
    if (group->end == FOURLINK_GROUP_SLIDES) {
        fourlink_vector n = left_of(&end->axis);
        double N = FLK_DOT(n, f->FD);

        f->FD.x = N * n.x;
        f->FD.y = N * n.y;
        f->M = FLK_MOMENT_ABOUT_ORIGIN(&body[1]);
    }
}

/* The six equations of a group, moments about the origins of its links, divided by the length of the rod:
**
**    FP - FQ = f5,   -l e5 x FQ = M5
**    FQ + FD = f6,   rho x FQ (+ M) = M6
**
** rho is the arm of Q, r e6 of a rocker, 0 of a slider, whose FD is N nu.  They are solved apart from the nine
** of the four links, which they do not contain. GSL's banded decomposition, with every diagonal in the band,
** allocates nothing. */
#define SIX 6
#define BAND (SIX - 1)
#define WIDTH (3 * BAND + 1)
#define AT(A, row, column) (A)[(column)*WIDTH + 2 * BAND + (row) - (column)]

static void put_equations(const fourlink_group *group, const fourlink_link_state *rod, double *A)
{
    const fourlink_link_state *end = rod + 1;
    fourlink_vector n = left_of(&end->axis);
    double r = group->length / group->rod;
    int i;

    memset(A, 0, SIX * WIDTH * sizeof A[0]);
    for (i = 0; i < 2; i++) {
        AT(A, i, i) = 1;
        AT(A, i, 2 + i) = -1;
        AT(A, 3 + i, 2 + i) = 1;
    }
    AT(A, 2, 2) = rod->axis.y;
    AT(A, 2, 3) = -rod->axis.x;
    if (group->end == FOURLINK_GROUP_SLIDES) {
        AT(A, 3, 4) = n.x;
        AT(A, 4, 4) = n.y;
        AT(A, 5, 5) = 1;
    } else {
        AT(A, 3, 4) = 1;
        AT(A, 4, 5) = 1;
        AT(A, 5, 2) = -r * end->axis.y;
        AT(A, 5, 3) = r * end->axis.x;
    }
}

static void solve_equations(const fourlink_group *group, const fourlink_link_state *rod,
                            const flk_body body[2], flk_group_forces *f)
{
    double A[SIX * WIDTH], x[SIX];
    unsigned int pivot[SIX];
    gsl_matrix_view A_view = gsl_matrix_view_array(A, SIX, WIDTH);
    gsl_vector_uint_view pivot_view = gsl_vector_uint_view_array(pivot, SIX);
    gsl_vector_view x_view = gsl_vector_view_array(x, SIX);
    fourlink_vector n = left_of(&rod[1].axis);
    int i;

    put_equations(group, rod, A);
    for (i = 0; i < 2; i++) {
        x[3 * i] = body[i].force.x;
        x[3 * i + 1] = body[i].force.y;
        x[3 * i + 2] = FLK_MOMENT_ABOUT_ORIGIN(&body[i]) / group->rod;
    }
    gsl_linalg_LU_band_decomp(SIX, BAND, BAND, &A_view.matrix, &pivot_view.vector);
    gsl_linalg_LU_band_svx(BAND, BAND, &A_view.matrix, &pivot_view.vector, &x_view.vector);
    f->FP.x = x[0];
    f->FP.y = x[1];
    f->FQ.x = x[2];
    f->FQ.y = x[3];
    f->FD.x = x[4];
    f->FD.y = x[5];
    f->M = 0;
    if (group->end == FOURLINK_GROUP_SLIDES) {
        f->FD.x = x[4] * n.x;
        f->FD.y = x[4] * n.y;
        f->M = x[5] * group->rod;
    }
}

/* Take from a link the force F of it on a group, at a point in its own axes. */
static void take_force(const fourlink_link_state *link, const fourlink_vector *at,
                       const fourlink_vector *F, flk_body *body)
{
    fourlink_vector r;

    FLK_TURN(r, link, *at);
    r.x -= body->arm.x;
    r.y -= body->arm.y;
    body->force.x += F->x;
    body->force.y += F->y;
    body->moment += FLK_CROSS(r, *F);
}

/* The bodies of all links, by number - 2, the first three of them cut free but without their loads; the forces
** of the groups, unless null.  What the groups' bodies do in virtual work is added to that of the crank: -FP
** must not be counted besides. */
static void cut_all(const fourlink_mechanism *mechanism, const fourlink_state *state,
                    const fourlink_load *loads, unsigned long n_loads, int closed_form,
                    flk_body *body, flk_group_forces *list)
{
    unsigned long n;
    int i;

    for (i = FLK_ROD_OF(0); i <= FLK_LAST_LINK(mechanism); i++)
        flk_cut_link(FLK_LINK(mechanism, i), &state->link[i], &mechanism->design.gravity,
                     &body[i - 2]);
    for (n = 0; n < n_loads; n++)
        flk_apply_load(&loads[n], &state->link[loads[n].link], &body[loads[n].link - 2]);
    for (i = mechanism->design.n_groups - 1; i >= 0; i--) {
        const fourlink_group *g = &mechanism->design.group[i];
        const fourlink_link_state *rod = &state->link[FLK_ROD_OF(i)];
        const flk_body *own = &body[FLK_ROD_OF(i) - 2];
        flk_group_forces f;

        if (closed_form)
            solve_closed(g, rod, own, &f);
        else
            solve_equations(g, rod, own, &f);
        take_force(&state->link[g->link], &g->at, &f.FP, &body[g->link - 2]);
        if (g->to > FOURLINK_GROUND)
            take_force(&state->link[g->to], &g->pivot, &f.FD, &body[g->to - 2]);
        body[0].work += own[0].work + own[1].work;
        body[0].largest = flk_larger(body[0].largest, flk_larger(own[0].largest, own[1].largest));
        if (list)
            list[i] = f;
    }
}

void flk_groups_cut(const fourlink_mechanism *mechanism, const fourlink_state *state,
                    const fourlink_load *loads, unsigned long n_loads, int closed_form,
                    flk_body body[3])
{
    flk_body all[FOURLINK_LINKS - 2];

    memcpy(all, body, 3 * sizeof *body);
    cut_all(mechanism, state, loads, n_loads, closed_form, all, NULL);
    memcpy(body, all, 3 * sizeof *body);
}

void flk_groups_forces(const fourlink_mechanism *mechanism, const fourlink_state *state,
                       const fourlink_load *loads, unsigned long n_loads, int closed_form,
                       flk_group_forces *list)
{
    flk_body all[FOURLINK_LINKS - 2];
    int i;

    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        flk_cut_link(FLK_LINK(mechanism, i), &state->link[i], &mechanism->design.gravity,
                     &all[i - 2]);
    cut_all(mechanism, state, loads, n_loads, closed_form, all, list);
}

void flk_groups_shake(const fourlink_mechanism *mechanism, const fourlink_state *state,
                      const flk_group_forces *list, fourlink_vector *force, double *moment)
{
    int i;

    for (i = 0; i < mechanism->design.n_groups; i++) {
        const fourlink_vector *at = &state->link[FLK_ROD_OF(i) + 1].origin;

        if (mechanism->design.group[i].to > FOURLINK_GROUND)
            continue;
        force->x -= list[i].FD.x;
        force->y -= list[i].FD.y;
        *moment -= list[i].M + FLK_CROSS(*at, list[i].FD);
    }
}
