/* SPDX-License-Identifier: GPL-3.0-or-later
**
** friction.c - Coulomb friction in pins and guides, solved together with the pin forces on which it depends.
**
** Friction acts as a load: the friction moment y of a pin acts as -y on one link and +y on the other; the
** friction force y of a guide acts along it at the pin, on the sliding link, and in the opposite direction on
** the other.  Its sign is known; its size follows from the pin force F, or from the normal force N and the
** couple M of the guide:
**
**    pin      y = rho |F|,   rho = mu r, the radius of the friction circle
**    guide    y = mu |N|,   or, for a block of length l whose edges press with N1 + N2 = N and
**             (N2 - N1) l / 2 = M,   y = mu (|N1| + |N2|) = mu max(|N|, 2 |M| / l)
**
** All forces x are linear in the four sizes y: x(y) = x0 + S y, where x0 are the forces without friction
** and column k of S those of a unit load in joint k alone.  The moment at A changes only Ts, so y = phi(x0
** + S y) are at most three equations for B, C and D; where another drive takes the place of Ts, it changes
** all, and they are four.  They are solved by Newton's method, and A follows:
**
**    (I - Phi S) dy = phi(x0 + S y) - y,   Phi = dphi/dx
**
** The friction circle: R. S. Khurmi, J. K. Gupta, "Theory of Machines", chapter 10.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "free_body.h"
#include "friction.h"

#define JOINTS 4
#define COUPLED 4 /* at most: all but A, unless something else than the crank drives */
#define MOST_STEPS 50
#define CONTINUATION_STEPS 20
#define EXACT 1e-13   /* relative to the largest y: Newton's method has converged */
#define ROUNDED 1e-12 /* ... if it does not get closer */
#define NEARLY 1e-8   /* ... no convergence, as where two solutions meet: only rounding is left */
#define SQUARED 1e-7  /* ... where Phi S is small: the error after such a step is its square */
#define STANDSTILL 1e-12 /* relative to unit crank speed: slower joints count as at rest */

/* A joint with friction. */
typedef struct joint {
    int number; /* 0 to 3, in the order A, B, C, D */
    int is_guide;
    double
        factor; /* m, radius of the friction circle; for a guide, coefficient times crank length */
    double couple; /* 1/m, 2 / length of the guide; 0: its couple causes no friction */
    double
        speed; /* 1, joint speed / crank speed (guide: / crank pin speed), in the sense of the motion */
    fourlink_load load[2]; /* for y = 1 N m; for a guide, 1 N m / crank length */
    int n_loads;
} joint;

/* The equations for y; columns of missing joints are 0. */
typedef struct equations {
    joint joint[JOINTS]; /* A is the last */
    int n, n_coupled;
    int order;            /* of the matrix: 3, or 4 with A */
    double x0[JOINTS][2]; /* Fx, Fy of a pin; M, N of a guide: without friction */
    double S[JOINTS][2][COUPLED];
    double y[JOINTS];
    double phi[COUPLED];
    double matrix[COUPLED][COUPLED]; /* Phi S */
} equations;

static void clear_unit_load(fourlink_load *load, int link)
{
    memset(load, 0, sizeof *load);
    load->link = link;
}

/* Add a unit load, unless it is on the ground. */
static fourlink_load *add_unit_load(joint *j, int link)
{
    fourlink_load *load = &j->load[j->n_loads];

    if (link == FOURLINK_GROUND)
        return NULL;
    clear_unit_load(load, link);
    j->n_loads++;
    return load;
}

static void load_pin(const fourlink_joint *pin, joint *j)
{
    double sign = j->speed > 0 ? 1 : -1;
    fourlink_load *on = add_unit_load(j, pin->on), *from;

    on->torque = -sign;
    from = add_unit_load(j, pin->from);
    if (from)
        from->torque = sign;
}

/* The load acts along the slide, at the origin of the sliding link and at the same point of the other
** link. */
static void load_guide(const fourlink_state *state, const fourlink_joint *guide, double length,
                       joint *j)
{
    const fourlink_link_state *slider = &state->link[guide->slider], *other;
    int number = guide->from == guide->slider ? guide->on : guide->from;
    fourlink_load *load = add_unit_load(j, guide->slider);
    double sign = (j->speed > 0 ? 1 : -1) / length;
    fourlink_vector r;

    load->force.x = -sign * slider->axis.x;
    load->force.y = -sign * slider->axis.y;
    load = add_unit_load(j, number);
    if (!load)
        return;
    other = &state->link[number];
    r.x = slider->origin.x - other->origin.x;
    r.y = slider->origin.y - other->origin.y;
    load->at.x = FLK_DOT(r, other->axis);
    load->at.y = FLK_CROSS(other->axis, r);
    load->force.x = sign * slider->axis.x;
    load->force.y = sign * slider->axis.y;
}

/* The speed of `on` relative to `from`, the sliding link relative to the other, for unit crank speed.  With r
** from the origin of the other link to that of the slider, the velocity of the other link's point there is k
** r turned by 90 deg. */
double flk_friction_speed(const fourlink_mechanism *mechanism, const fourlink_state *state,
                          const fourlink_joint *at)
{
    const fourlink_link_state *slider = &state->link[at->slider], *other;
    int number = at->from == at->slider ? at->on : at->from;
    fourlink_vector v;

    if (!at->slider)
        return state->link[at->on].k - (at->from == FOURLINK_GROUND ? 0 : state->link[at->from].k);
    v = slider->k_origin;
    if (number != FOURLINK_GROUND) {
        other = &state->link[number];
        v.x += other->k * (slider->origin.y - other->origin.y) - other->k_origin.x;
        v.y -= other->k * (slider->origin.x - other->origin.x) + other->k_origin.y;
    }
    return FLK_DOT(v, slider->axis) / mechanism->design.link[FOURLINK_CRANK].length;
}

int flk_friction_sense(double omega2, const fourlink_friction *friction)
{
    return omega2 < 0 || (omega2 == 0 && friction->direction < 0) ? -1 : 1;
}

/* 1 if joint i is the slot of a mechanism that has a guide as well. */
static int is_slot(const flk_kind *kind, int i)
{
    return kind->joint[i].slider == FOURLINK_COUPLER && kind->joint[3].slider;
}

double flk_friction_of(const flk_kind *kind, int i, const fourlink_friction *friction)
{
    return !kind->joint[i].slider ? friction->circle[i]
           : is_slot(kind, i)     ? friction->slot
                                  : friction->guide;
}

/* List the joints that have friction and move, with the senses of `held` if that is given. */
static void list_rubbing_joints(const flk_kind *kind, const fourlink_mechanism *mechanism,
                                const fourlink_state *state, const fourlink_state *held,
                                const fourlink_friction *friction, equations *e)
{
    int sense = flk_friction_sense((held ? held : state)->link[FOURLINK_CRANK].omega, friction);
    double length = mechanism->design.link[FOURLINK_CRANK].length, block;
    int k;

    e->n = e->n_coupled = 0;
    e->order = mechanism->drive ? COUPLED : COUPLED - 1;
    for (k = 1; k <= JOINTS; k++) {
        int i = k % JOINTS;
        const fourlink_joint *at = &kind->joint[i];
        joint *j = &e->joint[e->n];

        j->number = i;
        j->is_guide = at->slider != 0;
        j->factor = flk_friction_of(kind, i, friction) * (j->is_guide ? length : 1);
        block = is_slot(kind, i) ? friction->slot_length : friction->guide_length;
        j->couple = block > 0 ? 2 / block : 0;
        j->speed = flk_friction_speed(mechanism, held ? held : state, at) * sense;
        j->n_loads = 0;
        if (!(j->factor > 0) || fabs(j->speed) <= STANDSTILL)
            continue;
        if (j->is_guide)
            load_guide(state, at, length, j);
        else
            load_pin(at, j);
        e->n_coupled += i != 0 || mechanism->drive;
        e->n++;
    }
}

/* The force of a pin; the couple and normal force of a guide. */
static void take_unknowns(const joint *j, const fourlink_forces *forces, double x[2])
{
    int i = 2 * j->number, form = j->is_guide ? FLK_SLIDER : FLK_PIN;

    x[0] = *FLK_MEMBER(forces, flk_unknowns[i][form]);
    x[1] = *FLK_MEMBER(forces, flk_unknowns[i + 1][form]);
}

static void apply_load(const fourlink_load *load, const fourlink_state *state, flk_body body[3])
{
    flk_apply_load(load, &state->link[load->link], &body[load->link - FOURLINK_CRANK]);
}

/* x0 and S. */
static void find_columns(const flk_kind *kind, const fourlink_mechanism *mechanism,
                         const fourlink_state *state, const flk_solver *solver,
                         const flk_factors *factors, const fourlink_forces *without, equations *e)
{
    fourlink_forces forces;
    flk_body body[3];
    double x[2];
    int i, k;

    memset(e->S, 0, sizeof e->S);
    memset(e->matrix, 0, sizeof e->matrix);
    memset(e->phi, 0, sizeof e->phi);
    for (k = 0; k < e->n; k++)
        take_unknowns(&e->joint[k], without, e->x0[k]);
    for (k = 0; k < e->n_coupled; k++) {
        memset(body, 0, sizeof body);
        for (i = 0; i < e->joint[k].n_loads; i++)
            apply_load(&e->joint[k].load[i], state, body);
        solver->solve(kind, mechanism, state, factors, body, &forces);
        for (i = 0; i < e->n; i++) {
            take_unknowns(&e->joint[i], &forces, x);
            e->S[i][0][k] = x[0];
            e->S[i][1][k] = x[1];
        }
    }
}

/* x0 + S y of a joint. */
static void add_columns(const equations *e, int i, double x[2])
{
    int k;

    x[0] = e->x0[i][0];
    x[1] = e->x0[i][1];
    for (k = 0; k < e->order; k++) {
        x[0] += e->S[i][0][k] * e->y[k];
        x[1] += e->S[i][1][k] * e->y[k];
    }
}

/* phi(x0 + S y) and Phi S, both times `share`. */
static void evaluate(equations *e, double share)
{
    int i, k;

    for (i = 0; i < e->n_coupled; i++) {
        const joint *j = &e->joint[i];
        double factor = share * j->factor, x[2], d[2], size, slope;

        add_columns(e, i, x);
        if (!j->is_guide) {
            size = sqrt(x[0] * x[0] + x[1] * x[1]);
            slope = size > 0 ? factor / size : 0;
            d[0] = slope * x[0];
            d[1] = slope * x[1];
        } else if (fabs(x[1]) >= j->couple * fabs(x[0])) {
            size = fabs(x[1]);
            d[0] = 0;
            d[1] = factor * GSL_SIGN(x[1]) * (size > 0); /* nothing presses, nothing locks */
        } else {
            size = j->couple * fabs(x[0]);
            d[0] = j->couple * (x[0] < 0 ? -factor : factor);
            d[1] = 0;
        }
        e->phi[i] = factor * size;
        for (k = 0; k < e->order; k++)
            e->matrix[i][k] = d[0] * e->S[i][0][k] + d[1] * e->S[i][1][k];
    }
}

static void swap_rows(double A[COUPLED][COUPLED + 1], int i, int k)
{
    double row[COUPLED + 1];

    memcpy(row, A[i], sizeof row);
    memcpy(A[i], A[k], sizeof row);
    memcpy(A[k], row, sizeof row);
}

/* Solve (I - Phi S) d = phi - y by elimination with pivots; returns the determinant of I - Phi S, 0 if it is
** singular.  Missing joints have d = 0. */
static double newton_step(const equations *e, double d[COUPLED])
{
    double A[COUPLED][COUPLED + 1], inverse[COUPLED], determinant = 1;
    int i, j, k;

    for (i = 0; i < e->order; i++) {
        for (k = 0; k < e->order; k++)
            A[i][k] = -e->matrix[i][k];
        A[i][i] += 1;
        A[i][e->order] = e->phi[i] - e->y[i];
    }
    for (k = 0; k < e->order; k++) {
        int largest = k;

        for (i = k + 1; i < e->order; i++)
            if (fabs(A[i][k]) > fabs(A[largest][k]))
                largest = i;
        if (A[largest][k] == 0)
            return 0;
        if (largest != k) {
            swap_rows(A, largest, k);
            determinant = -determinant;
        }
        determinant *= A[k][k];
        inverse[k] = 1 / A[k][k];
        for (i = k + 1; i < e->order; i++) {
            double share = A[i][k] * inverse[k];

            for (j = k + 1; j <= e->order; j++)
                A[i][j] -= share * A[k][j];
        }
    }
    for (i = e->order - 1; i >= 0; i--) {
        d[i] = A[i][e->order];
        for (k = i + 1; k < e->order; k++)
            d[i] -= A[i][k] * d[k];
        d[i] *= inverse[i];
    }
    return determinant;
}

/* 1 if all row sums of Phi S are below one half. */
static int is_small(const equations *e)
{
    int i, k;

    for (i = 0; i < e->n_coupled; i++) {
        double sum = 0;

        for (k = 0; k < e->n_coupled; k++)
            sum += fabs(e->matrix[i][k]);
        if (!(sum < 0.5))
            return 0;
    }
    return 1;
}

/* Newton's method from the current y, for a share of the friction; 1 if it converges with a positive
** determinant.  `matrix` is then that before the last step. */
static int converge(equations *e, double share)
{
    double d[COUPLED], before = HUGE_VAL, most = 0, largest = 0, determinant = 0;
    int step, i;

    for (step = 0; step < MOST_STEPS; step++) {
        most = largest = 0;
        evaluate(e, share);
        determinant = newton_step(e, d);
        if (determinant == 0)
            return 0;
        for (i = 0; i < e->n_coupled; i++) {
            e->y[i] += d[i];
            most = flk_larger(most, fabs(d[i]));
            largest = flk_larger(largest, fabs(e->y[i]));
        }
        if (!FLK_WITHIN(most, FOURLINK_NUMBER_MAX))
            return 0;
        if (most <= EXACT * largest || (most <= SQUARED * largest && is_small(e)) ||
            (most <= ROUNDED * largest && most >= before))
            return determinant > 0;
        before = most;
    }
    return determinant > 0 && most <= NEARLY * largest;
}

/* 1 if some power of Phi S has a norm below 1: then its spectral radius is below 1. */
static int is_contraction(const equations *e)
{
    double A[COUPLED][COUPLED], square[COUPLED][COUPLED];
    int i, j, k, power;

    memcpy(A, e->matrix, sizeof A);
    for (power = 0; power < 8; power++) {
        double norm = 0;

        for (i = 0; i < e->n_coupled; i++) {
            double sum = 0;

            for (j = 0; j < e->n_coupled; j++)
                sum += fabs(A[i][j]);
            norm = flk_larger(norm, sum);
        }
        if (norm < 1)
            return 1;
        if (!FLK_WITHIN(norm, FOURLINK_NUMBER_MAX))
            return 0;
        for (i = 0; i < e->n_coupled; i++)
            for (j = 0; j < e->n_coupled; j++)
                for (square[i][j] = 0, k = 0; k < e->n_coupled; k++)
                    square[i][j] += A[i][k] * A[k][j];
        memcpy(A, square, sizeof A);
    }
    return 0;
}

/* The sizes of friction, or FOURLINK_LOCKED.  A solution counts if it is the continuation of the frictionless
** one: friction grows from 0 while the determinant stays positive.  A contraction has one solution. */
static int find_sizes(equations *e)
{
    int i;

    memset(e->y, 0, sizeof e->y);
    if (converge(e, 1) && is_contraction(e))
        return FOURLINK_OK;
    memset(e->y, 0, sizeof e->y);
    for (i = 1; i <= CONTINUATION_STEPS; i++)
        if (!converge(e, (double)i / CONTINUATION_STEPS))
            return FOURLINK_LOCKED;
    return FOURLINK_OK;
}

/* The moment at A, from those of the other joints. */
static void find_friction_at_A(equations *e)
{
    double x[2];

    if (e->n == e->n_coupled)
        return;
    add_columns(e, e->n_coupled, x);
    e->y[e->n_coupled] = e->joint[e->n_coupled].factor * sqrt(x[0] * x[0] + x[1] * x[1]);
}

/* The part of the power that is not lost: of the power that the crank puts in, or that it takes out.  0 if
** the load would drive the crank without friction, but does not with it; undefined if there is no power. */
static double efficiency_of(double Ts, double Ts0, double direction)
{
    Ts *= direction;
    Ts0 *= direction;
    if (Ts > 0)
        return Ts0 > 0 ? Ts0 / Ts : 0;
    return Ts0 < 0 ? Ts / Ts0 : Ts == Ts0 ? FLK_UNDEFINED : 0;
}

/* Scale the friction loads, and apply them to the free bodies of the links. */
static void apply(const fourlink_state *state, equations *e, flk_body body[3])
{
    int i, k;

    for (k = 0; k < e->n; k++) {
        joint *j = &e->joint[k];

        for (i = 0; i < j->n_loads; i++) {
            fourlink_load *load = &j->load[i];

            load->torque *= e->y[k];
            load->force.x *= e->y[k];
            load->force.y *= e->y[k];
            apply_load(load, state, body);
        }
    }
}

/* The joints of the friction loads: two links at B and at C, the follower at D, the crank at A. */
const int flk_friction_joint[FOURLINK_FRICTION_LOADS] = {1, 1, 2, 2, 3, 0};

/* The first link of a joint is the sliding one, or `on`: see load_pin and load_guide. */
int flk_friction_link(const flk_kind *kind, unsigned long i)
{
    const fourlink_joint *at = &kind->joint[flk_friction_joint[i]];
    int first = at->slider ? at->slider : at->on;
    int second = at->from == first ? at->on : at->from;

    return i > 0 && flk_friction_joint[i - 1] == flk_friction_joint[i] ? second : first;
}

/* List the friction found. */
static void list_losses(const flk_kind *kind, const equations *e, double length, double omega2,
                        fourlink_losses *losses)
{
    int i, k;

    losses->guide = losses->slot = losses->power = 0;
    losses->n_loads = FOURLINK_FRICTION_LOADS;
    for (i = 0; i < JOINTS; i++)
        losses->pin[i] = 0;
    for (i = 0; i < FOURLINK_FRICTION_LOADS; i++)
        clear_unit_load(&losses->load[i], flk_friction_link(kind, (unsigned long)i));
    for (k = 0; k < e->n; k++) {
        const joint *j = &e->joint[k];

        if (j->is_guide)
            *(is_slot(kind, j->number) ? &losses->slot : &losses->guide) = e->y[k] / length;
        else
            losses->pin[j->number] = e->y[k];
        losses->power += e->y[k] * fabs(j->speed * omega2);
        for (i = 0; flk_friction_joint[i] != j->number; i++)
            ;
        memcpy(&losses->load[i], j->load, (size_t)j->n_loads * sizeof j->load[0]);
    }
}

/* Add friction to the force of a guide or slot, besides its normal force: F14 on a piston or yoke, F34 on a
** lever or yoke. */
static void add_guide(const flk_kind *kind, const equations *e, fourlink_forces *forces)
{
    int k;

    for (k = 0; k < e->n_coupled; k++) {
        const joint *j = &e->joint[k];

        if (!j->is_guide)
            continue;
        if (kind->joint[j->number].from == FOURLINK_GROUND) {
            forces->F14x = j->load[0].force.x;
        } else {
            forces->F34x += j->load[1].force.x;
            forces->F34y += j->load[1].force.y;
        }
    }
}

static int check_friction(const fourlink_friction *friction)
{
    int i, is_negative = friction->guide < 0 || friction->guide_length < 0 || friction->slot < 0 ||
                         friction->slot_length < 0;

    if (!FLK_WITHIN(friction->guide, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(friction->slot, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(friction->guide_length, FOURLINK_LENGTH_MAX) ||
        !FLK_WITHIN(friction->slot_length, FOURLINK_LENGTH_MAX))
        return FOURLINK_BAD_NUMBER;
    for (i = 0; i < JOINTS; i++) {
        if (!FLK_WITHIN(friction->circle[i], FOURLINK_LENGTH_MAX))
            return FOURLINK_BAD_NUMBER;
        is_negative |= friction->circle[i] < 0;
    }
    return is_negative ? FOURLINK_BAD_FRICTION : FOURLINK_OK;
}

/* Solve, with data that have been checked. */
static int solve_all(const flk_kind *kind, const fourlink_mechanism *mechanism,
                     const fourlink_state *state, const fourlink_state *held,
                     const fourlink_load *loads, unsigned long n_loads,
                     const fourlink_friction *friction, const flk_solver *solver,
                     fourlink_forces *forces, fourlink_losses *losses)
{
    double omega2 = state->link[FOURLINK_CRANK].omega;
    double length = mechanism->design.link[FOURLINK_CRANK].length, Ts0;
    fourlink_forces found;
    flk_factors factors;
    flk_body body[3];
    equations e;
    int status = solver->factor(kind, mechanism, state, &factors);

    if (status != FOURLINK_OK)
        return status;
    flk_cut_free(mechanism, state, loads, n_loads, solver == &flk_closed_form, body);
    solver->solve(kind, mechanism, state, &factors, body, &found);
    Ts0 = found.at_crank;
    list_rubbing_joints(kind, mechanism, state, held, friction, &e);
    find_columns(kind, mechanism, state, solver, &factors, &found, &e);
    status = find_sizes(&e);
    if (status != FOURLINK_OK)
        return status;
    find_friction_at_A(&e);
    apply(state, &e, body);
    solver->solve(kind, mechanism, state, &factors, body, &found);
    flk_virtual_work(state, body, &found);
    if (!flk_is_finite(&found))
        return FOURLINK_BAD_NUMBER;
    list_losses(kind, &e, length, omega2, losses);
    losses->Ts0 = Ts0;
    losses->efficiency = efficiency_of(found.at_crank, Ts0, flk_friction_sense(omega2, friction));
    add_guide(kind, &e, &found);
    *forces = found;
    return FOURLINK_OK;
}

int flk_friction_solve(const fourlink_mechanism *mechanism, const fourlink_state *state,
                       const fourlink_state *held, const fourlink_load *loads,
                       unsigned long n_loads, const fourlink_friction *friction, int closed_form,
                       fourlink_forces *forces, fourlink_losses *losses)
{
    const flk_kind *kind;
    int status = flk_kind_find(mechanism, forces, &kind);

    if (status == FOURLINK_OK)
        status = state && friction && losses ? flk_check_loads(mechanism, loads, n_loads)
                                             : FOURLINK_NULL;
    if (status == FOURLINK_OK)
        status = check_friction(friction);
    if (status == FOURLINK_OK)
        status = solve_all(kind, mechanism, state, held, loads, n_loads, friction,
                           closed_form ? &flk_closed_form : &flk_nine_equations, forces, losses);
    return status;
}

int fourlink_solve_friction(const fourlink_mechanism *mechanism, const fourlink_state *state,
                            const fourlink_load *loads, unsigned long n_loads,
                            const fourlink_friction *friction, int closed_form,
                            fourlink_forces *forces, fourlink_losses *losses)
{
    return flk_friction_solve(mechanism, state, NULL, loads, n_loads, friction, closed_form, forces,
                              losses);
}
