/* SPDX-License-Identifier: GPL-3.0-or-later
**
** friction.c - Coulomb friction in pins and guides, with the pin forces that it depends on.
**
** Friction is a load like others: the moment y of a pin turns one link by -y and the other by +y, the force y
** of a guide acts along it at the pin, on the link that slides and against it on the other.  Its sign is
** known, its size follows from the force F of the pin, or from the normal force N and the couple M of the
** guide:
**
**    pin      y = rho |F|,   rho = mu r, the radius of the friction circle
**    guide    y = mu |N|,   or, of a block of length l whose edges press with N1 + N2 = N and
**             (N2 - N1) l / 2 = M,   y = mu (|N1| + |N2|) = mu max(|N|, 2 |M| / l)
**
** All forces x are linear in the four sizes y:  x(y) = x0 + S y, x0 without friction, column k of S for the
** unit load of joint k alone.  The moment in A changes Ts alone, so y = phi(x0 + S y) are at most three equations for
** B, C and D, solved by Newton's method, and A follows:
**
**    (I - Phi S) dy = phi(x0 + S y) - y,   Phi = dphi/dx
**
** The friction circle: R. S. Khurmi, J. K. Gupta, "Theory of Machines", chapter 10.
*/
#include <math.h>
#include <string.h>

#include "free_body.h"

#define JOINTS 4
#define COUPLED 3 /* all but A */
#define MOST_STEPS 50
#define CONTINUATION_STEPS 20
#define EXACT 1e-13   /* of the largest y: Newton's method has ended */
#define ROUNDED 1e-12 /* ... if it does not come closer */
#define NEARLY 1e-8   /* ... or does not end, as where two solutions meet: the steps are rounding */
#define SQUARED 1e-7  /* ... a step that leaves an error of its square, where Phi S is small */
#define STANDSTILL 1e-12 /* of a unit crank speed: joints slower than this do not move */

/* A joint with friction. */
typedef struct joint {
    int number; /* 0 to 3, in the order A, B, C, D */
    int is_guide;
    double
        factor; /* m, of the friction circle; of the guide coefficient times length of the crank */
    double couple; /* 1/m, 2 / length of the guide; 0: its couple has no friction */
    double
        speed; /* 1, of the joint over that of the crank (guide: crank pin), in the sense of the motion */
    fourlink_load load[2]; /* for y = 1 N m: of a guide, 1 N m over the length of the crank */
    int n_loads;
} joint;

/* The equations for y; columns of joints that there are not are 0. */
typedef struct equations {
    joint joint[JOINTS]; /* A is the last */
    int n, n_coupled;
    double x0[JOINTS][2]; /* Fx, Fy of a pin; M, N of a guide: without friction */
    double S[JOINTS][2][COUPLED];
    double y[JOINTS];
    double phi[COUPLED];
    double matrix[COUPLED][COUPLED]; /* Phi S */
} equations;

static void clear(fourlink_load *load, int link)
{
    memset(load, 0, sizeof *load);
    load->link = link;
}

/* Add a load of size 1, unless it is on the ground. */
static fourlink_load *add_load(joint *j, int link)
{
    fourlink_load *load = &j->load[j->n_loads];

    if (link == FOURLINK_GROUND)
        return NULL;
    clear(load, link);
    j->n_loads++;
    return load;
}

static void load_pin(const fourlink_joint *pin, joint *j)
{
    double sign = j->speed > 0 ? 1 : -1;
    fourlink_load *on = add_load(j, pin->on), *from;

    on->torque = -sign;
    from = add_load(j, pin->from);
    if (from)
        from->torque = sign;
}

/* Along the slide, at the origin of the link that slides; the same point of the other link. */
static void load_guide(const fourlink_state *state, const fourlink_joint *guide, double length,
                       joint *j)
{
    const fourlink_link_state *slider = &state->link[guide->slider], *other;
    int number = guide->from == guide->slider ? guide->on : guide->from;
    fourlink_load *load = add_load(j, guide->slider);
    double sign = (j->speed > 0 ? 1 : -1) / length;
    fourlink_vector r;

    load->force.x = -sign * slider->axis.x;
    load->force.y = -sign * slider->axis.y;
    load = add_load(j, number);
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

/* Speed of `on` against `from`, of the link that slides along the other, for a unit crank speed.  With r from the
** origin of the other link to that of the slider, the velocity of its point there is k r turned by 90 deg. */
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

/* The joints that have friction and move; in the senses of `held`, if that is given. */
static void list_joints(const flk_kind *kind, const fourlink_mechanism *mechanism,
                        const fourlink_state *state, const fourlink_state *held,
                        const fourlink_friction *friction, equations *e)
{
    int sense = flk_friction_sense((held ? held : state)->link[FOURLINK_CRANK].omega, friction);
    double length = mechanism->design.link[FOURLINK_CRANK].length;
    int k;

    e->n = e->n_coupled = 0;
    for (k = 1; k <= JOINTS; k++) {
        int i = k % JOINTS;
        const fourlink_joint *at = &kind->joint[i];
        joint *j = &e->joint[e->n];

        j->number = i;
        j->is_guide = at->slider != 0;
        j->factor = j->is_guide ? friction->guide * length : friction->circle[i];
        j->couple = friction->guide_length > 0 ? 2 / friction->guide_length : 0;
        j->speed = flk_friction_speed(mechanism, held ? held : state, at) * sense;
        j->n_loads = 0;
        if (!(j->factor > 0) || fabs(j->speed) <= STANDSTILL)
            continue;
        if (j->is_guide)
            load_guide(state, at, length, j);
        else
            load_pin(at, j);
        e->n_coupled += i != 0;
        e->n++;
    }
}

/* Force of a pin, couple and normal force of a guide. */
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

/* x0 and S; a status. */
static int find_columns(const flk_kind *kind, const fourlink_mechanism *mechanism,
                        const fourlink_state *state, flk_solution *solve,
                        const fourlink_forces *without, equations *e)
{
    fourlink_forces forces;
    flk_body body[3];
    double x[2];
    int i, k, status = FOURLINK_OK;

    memset(e->S, 0, sizeof e->S);
    memset(e->matrix, 0, sizeof e->matrix);
    memset(e->phi, 0, sizeof e->phi);
    for (k = 0; k < e->n; k++)
        take_unknowns(&e->joint[k], without, e->x0[k]);
    for (k = 0; k < e->n_coupled && status == FOURLINK_OK; k++) {
        memset(body, 0, sizeof body);
        for (i = 0; i < e->joint[k].n_loads; i++)
            apply_load(&e->joint[k].load[i], state, body);
        status = solve(kind, mechanism, state, body, &forces);
        for (i = 0; i < e->n; i++) {
            take_unknowns(&e->joint[i], &forces, x);
            e->S[i][0][k] = x[0];
            e->S[i][1][k] = x[1];
        }
    }
    return status;
}

/* x0 + S y of a joint. */
static void add_columns(const equations *e, int i, double x[2])
{
    int k;

    x[0] = e->x0[i][0];
    x[1] = e->x0[i][1];
    for (k = 0; k < COUPLED; k++) {
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
            d[1] = x[1] < 0 ? -factor : factor;
        } else {
            size = j->couple * fabs(x[0]);
            d[0] = j->couple * (x[0] < 0 ? -factor : factor);
            d[1] = 0;
        }
        e->phi[i] = factor * size;
        for (k = 0; k < COUPLED; k++)
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
** singular.  Joints that there are not have d = 0. */
static double newton_step(const equations *e, double d[COUPLED])
{
    double A[COUPLED][COUPLED + 1], inverse[COUPLED], determinant = 1;
    int i, j, k;

    for (i = 0; i < COUPLED; i++) {
        for (k = 0; k < COUPLED; k++)
            A[i][k] = -e->matrix[i][k];
        A[i][i] += 1;
        A[i][COUPLED] = e->phi[i] - e->y[i];
    }
    for (k = 0; k < COUPLED; k++) {
        int largest = k;

        for (i = k + 1; i < COUPLED; i++)
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
        for (i = k + 1; i < COUPLED; i++) {
            double share = A[i][k] * inverse[k];

            for (j = k + 1; j <= COUPLED; j++)
                A[i][j] -= share * A[k][j];
        }
    }
    for (i = COUPLED - 1; i >= 0; i--) {
        d[i] = A[i][COUPLED];
        for (k = i + 1; k < COUPLED; k++)
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

/* Newton's method from the present y, for a share of the friction; 1 if it converges with a positive
** determinant.  `matrix` is then that of the solution but for the last step. */
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

/* 1 if the spectral radius of Phi S is below 1, as it is if a power of it has a norm below 1. */
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

/* The moment in A, from those of the others. */
static void follow_in_A(equations *e)
{
    double x[2];

    if (e->n == e->n_coupled)
        return;
    add_columns(e, e->n_coupled, x);
    e->y[e->n_coupled] = e->joint[e->n_coupled].factor * sqrt(x[0] * x[0] + x[1] * x[1]);
}

/* The part of the power that is not lost: of what the crank puts in, or of what it takes out; 0 if without friction
** the load would drive the crank, and with it does not. */
static double efficiency_of(double Ts, double Ts0, double direction)
{
    Ts *= direction;
    Ts0 *= direction;
    if (Ts > 0)
        return Ts0 > 0 ? Ts0 / Ts : 0;
    return Ts0 < 0 ? Ts / Ts0 : Ts == Ts0;
}

/* Give the loads of friction their sizes, and apply them to the links cut free. */
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

/* The joints of the loads: on the two links of B and of C, on the follower at D, on the crank at A. */
const int flk_friction_joint[FOURLINK_FRICTION_LOADS] = {1, 1, 2, 2, 3, 0};

/* Of two links of a joint the first is the one that slides, or `on`: see load_pin and load_guide. */
int flk_friction_link(const flk_kind *kind, unsigned long i)
{
    const fourlink_joint *at = &kind->joint[flk_friction_joint[i]];
    int first = at->slider ? at->slider : at->on;
    int second = at->from == first ? at->on : at->from;

    return i > 0 && flk_friction_joint[i - 1] == flk_friction_joint[i] ? second : first;
}

/* The friction that was found. */
static void list_losses(const flk_kind *kind, const equations *e, double length, double omega2,
                        fourlink_losses *losses)
{
    int i, k;

    losses->guide = losses->power = 0;
    losses->n_loads = FOURLINK_FRICTION_LOADS;
    for (i = 0; i < JOINTS; i++)
        losses->pin[i] = 0;
    for (i = 0; i < FOURLINK_FRICTION_LOADS; i++)
        clear(&losses->load[i], flk_friction_link(kind, (unsigned long)i));
    for (k = 0; k < e->n; k++) {
        const joint *j = &e->joint[k];

        if (j->is_guide)
            losses->guide = e->y[k] / length;
        else
            losses->pin[j->number] = e->y[k];
        losses->power += e->y[k] * fabs(j->speed * omega2);
        for (i = 0; flk_friction_joint[i] != j->number; i++)
            ;
        memcpy(&losses->load[i], j->load, (size_t)j->n_loads * sizeof j->load[0]);
    }
}

/* What a guide exerts has its friction besides the normal force: on a piston F14, on a lever F34. */
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
    int i, is_negative = friction->guide < 0 || friction->guide_length < 0;

    if (!FLK_WITHIN(friction->guide, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(friction->guide_length, FOURLINK_LENGTH_MAX))
        return FOURLINK_BAD_NUMBER;
    for (i = 0; i < JOINTS; i++) {
        if (!FLK_WITHIN(friction->circle[i], FOURLINK_LENGTH_MAX))
            return FOURLINK_BAD_NUMBER;
        is_negative |= friction->circle[i] < 0;
    }
    return is_negative ? FOURLINK_BAD_FRICTION : FOURLINK_OK;
}

/* Solve with checked data. */
static int solve_all(const flk_kind *kind, const fourlink_mechanism *mechanism,
                     const fourlink_state *state, const fourlink_state *held,
                     const fourlink_load *loads, unsigned long n_loads,
                     const fourlink_friction *friction, flk_solution *solve,
                     fourlink_forces *forces, fourlink_losses *losses)
{
    double omega2 = state->link[FOURLINK_CRANK].omega;
    double length = mechanism->design.link[FOURLINK_CRANK].length, Ts0;
    fourlink_forces found;
    flk_body body[3];
    equations e;
    int status;

    flk_cut_free(mechanism, state, loads, n_loads, body);
    status = solve(kind, mechanism, state, body, &found);
    if (status != FOURLINK_OK)
        return status;
    Ts0 = found.Ts;
    list_joints(kind, mechanism, state, held, friction, &e);
    status = find_columns(kind, mechanism, state, solve, &found, &e);
    if (status == FOURLINK_OK)
        status = find_sizes(&e);
    if (status != FOURLINK_OK)
        return status;
    follow_in_A(&e);
    apply(state, &e, body);
    status = solve(kind, mechanism, state, body, &found);
    flk_virtual_work(state, body, &found);
    if (status != FOURLINK_OK || !flk_is_finite(&found))
        return status != FOURLINK_OK ? status : FOURLINK_BAD_NUMBER;
    list_losses(kind, &e, length, omega2, losses);
    losses->Ts0 = Ts0;
    losses->efficiency = efficiency_of(found.Ts, Ts0, flk_friction_sense(omega2, friction));
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
        status = state && friction && losses ? flk_check_loads(loads, n_loads) : FOURLINK_NULL;
    if (status == FOURLINK_OK)
        status = check_friction(friction);
    if (status == FOURLINK_OK && closed_form && flk_dyad_is_singular(state))
        status = FOURLINK_SINGULAR;
    if (status == FOURLINK_OK)
        status = solve_all(kind, mechanism, state, held, loads, n_loads, friction,
                           closed_form ? flk_dyad_of_bodies : flk_matrix_of_bodies, forces, losses);
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
