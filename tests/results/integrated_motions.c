/* SPDX-License-Identifier: GPL-3.0-or-later
**
** integrated_motions.c - motions that are not given, against an independent integration.
**
**    integrated_motions DECK...
**
** The equation of motion is Lagrange's.  Positions, their derivatives, inertia, the work of weights,
** springs and dampers, and the motor's torque are computed here; the values of loads are those of
** fourlink_deck_analyse.  With friction, alpha2 is the one for which its Ts is T_motor - I_f alpha2.
** GSL's rk8pd integrates from corner to corner of the loads: over the angle, near rest over the time,
** and where the crank comes to rest over the speed.
**
** Every row is compared, and so is the end of the motion: where the crank stalls, friction locks it or a
** position is dead; that it does not start; that a steady motion repeats, has its rate and is stable;
** that there is none.
*/
#include <complex.h>
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_interp.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>

#include "fourlink.h"

#define PI 3.14159265358979323846

/* ------------------------------------------------------------------------------------------- machines */

#define CORNERS 400
#define SPRINGS 10
#define LOADS 100
#define POINTS 20

typedef struct machine {
    fourlink_results *results;
    const fourlink_deck *deck;
    fourlink_problem problem;
    fourlink_branch branch;
    double sense;           /* of the range */
    double from;            /* rad, of the first row */
    double inertia;         /* kg m2, of flywheel and rotor on the crank */
    double corner[CORNERS]; /* rad, within a cycle */
    int n_corners;
    fourlink_spring spring[SPRINGS];
    double wound[SPRINGS]; /* rad, of a torsional spring: its angle when it was last asked for */
    double ratio, torque, stall_torque, no_load_speed, power, max_torque; /* of the motor */
    double curve_speed[POINTS], curve_torque[POINTS];
    gsl_interp *curve;
    int n_curve, balances, finds_flywheel;
} machine;

/* ------------------------------------------------------------------------------------------- derivatives */

/* A complex number that depends on the crank angle, with two derivatives. */
typedef struct jet {
    double complex v, d, dd;
} jet;

static jet constant(double complex v)
{
    return (jet){v, 0, 0};
}

static jet plus(jet a, jet b)
{
    return (jet){a.v + b.v, a.d + b.d, a.dd + b.dd};
}

static jet times(jet a, jet b)
{
    return (jet){a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + 2 * a.d * b.d + a.v * b.dd};
}

static jet scaled(double complex k, jet a)
{
    return (jet){k * a.v, k * a.d, k * a.dd};
}

static jet minus(jet a, jet b)
{
    return plus(a, scaled(-1, b));
}

static jet conjugate(jet a)
{
    return (jet){conj(a.v), conj(a.d), conj(a.dd)};
}

static jet over(jet a, jet b)
{
    jet q;

    q.v = a.v / b.v;
    q.d = (a.d - q.v * b.d) / b.v;
    q.dd = (a.dd - 2 * q.d * b.d - q.v * b.dd) / b.v;
    return q;
}

/* The square root of a real jet that is positive. */
static jet root(jet a)
{
    jet r;

    r.v = sqrt(creal(a.v));
    r.d = a.d / (2 * r.v);
    r.dd = (a.dd / 2 - r.d * r.d) / r.v;
    return r;
}

/* ------------------------------------------------------------------------------------------- positions */

#define DEAD 1e-10 /* square of the sine between rod and follower, below which they do not move */

/* Links by number: origin and axis, a complex number of length 1. */
typedef struct linkage {
    jet origin[5], axis[5];
} linkage;

/* C to the left of the line from B to D on the open branch: two circles. */
static int place_four_bar(const fourlink_design *design, double side, linkage *l)
{
    double b = design->link[3].length, c = design->link[4].length;
    jet z = minus(constant(design->link[1].length), l->origin[3]), C;
    jet square = times(z, conjugate(z)), x, y;

    x = scaled(0.5, plus(square, constant(b * b - c * c)));
    y = minus(scaled(b * b, square), times(x, x));
    if (!(creal(y.v) > DEAD * b * b * creal(square.v)))
        return 0;
    C = plus(l->origin[3],
             over(times(z, plus(x, scaled(side * (double complex)I, root(y)))), square));
    l->origin[4] = constant(design->link[1].length);
    l->axis[3] = scaled(1 / b, minus(C, l->origin[3]));
    l->axis[4] = scaled(1 / c, minus(C, l->origin[4]));
    return 1;
}

/* The piston on the +x side of B on the open branch. */
static int place_slider_crank(const fourlink_design *design, double side, linkage *l)
{
    double length = design->link[3].length;
    jet B = l->origin[3], x = scaled(0.5, plus(B, conjugate(B))), y = minus(B, x), square;

    y = plus(y, constant(-(double complex)I * design->offset));
    square = minus(constant(length * length), times(y, conjugate(y)));
    if (!(creal(square.v) > DEAD * length * length))
        return 0;
    l->origin[4] = plus(plus(x, scaled(side, root(square))), constant(I * design->offset));
    l->axis[3] = scaled(1 / length, minus(l->origin[4], B));
    l->axis[4] = constant(1);
    return 1;
}

/* B = D + (s + i h) u, u the axis of the slide, s > 0 on the open branch. */
static int place_inverted(const fourlink_design *design, double side, linkage *l)
{
    double h = design->offset;
    jet z = minus(l->origin[3], constant(design->link[1].length));
    jet square = minus(times(z, conjugate(z)), constant(h * h));

    if (!(creal(square.v) > DEAD * creal(z.v * conj(z.v))))
        return 0;
    l->origin[4] = constant(design->link[1].length);
    l->axis[3] = over(z, plus(scaled(side, root(square)), constant(I * h)));
    l->axis[4] = l->axis[3];
    return 1;
}

/* B = C + s u, with C on the guide: the part of B off the guide is the sum of C's, 0, and of s u's. */
static int place_yoke(const fourlink_design *design, linkage *l)
{
    double complex u = cexp(I * design->angle);
    jet B = l->origin[3], y = scaled(-0.5 * (double complex)I, minus(B, conjugate(B)));

    l->axis[3] = constant(u);
    l->axis[4] = constant(1);
    l->origin[4] = minus(B, scaled(u / cimag(u), minus(y, constant(design->offset))));
    return 1;
}

/* All links at a crank angle; 0 if they do not reach it. */
static int place(const machine *m, double theta2, linkage *l)
{
    const fourlink_design *design = &m->problem.mechanism.design;
    double side = m->branch == FOURLINK_OPEN ? 1 : -1;
    double complex e = cexp(I * theta2);

    l->origin[2] = constant(0);
    l->axis[2] = (jet){e, I * e, -e};
    l->origin[3] = scaled(design->link[2].length, l->axis[2]);
    switch (design->kind) {
    case FOURLINK_FOUR_BAR:
        return place_four_bar(design, side, l);
    case FOURLINK_SLIDER_CRANK:
        return place_slider_crank(design, side, l);
    case FOURLINK_SCOTCH_YOKE:
        return place_yoke(design, l);
    default:
        return place_inverted(design, side, l);
    }
}

/* A point in the axes of a link, or of the ground. */
static jet point_of(const linkage *l, int link, fourlink_vector at)
{
    double complex z = at.x + I * at.y;

    return link == 1 ? constant(z) : plus(l->origin[link], scaled(z, l->axis[link]));
}

/* d(angle of a link)/d(theta2) */
static double turning(const linkage *l, int link)
{
    return link == 1 ? 0 : cimag(l->axis[link].d * conj(l->axis[link].v));
}

/* The work of a force along a displacement. */
static double along(double complex force, double complex way)
{
    return creal(conj(force) * way);
}

/* ------------------------------------------------------------------------------------------- torques */

/* J and half of its derivative, from the kinetic energy of the links at unit speed. */
static void find_inertia(const machine *m, const linkage *l, double *J, double *half_slope)
{
    int i;

    *J = *half_slope = 0;
    for (i = 2; i <= 4; i++) {
        const fourlink_link *link = &m->problem.mechanism.design.link[i];
        jet G = point_of(l, i, link->cg), axis = l->axis[i];

        *J += link->mass * along(G.d, G.d) + link->inertia * along(axis.d, axis.d);
        *half_slope += link->mass * along(G.d, G.dd) + link->inertia * along(axis.d, axis.dd);
    }
}

static double work_of_weights(const machine *m, const linkage *l)
{
    const fourlink_design *design = &m->problem.mechanism.design;
    double Q = 0;
    int i;

    for (i = 2; i <= 4; i++)
        Q += design->link[i].mass *
             along(design->gravity.x + I * design->gravity.y, point_of(l, i, design->link[i].cg).d);
    return Q;
}

static double work_of_load(const linkage *l, const fourlink_load *load)
{
    double complex force = load->force.x + I * load->force.y;

    if (load->frame == FOURLINK_FRAME_LINK)
        force *= l->axis[load->link].v;
    return along(force, point_of(l, load->link, load->at).d) +
           load->torque * turning(l, load->link);
}

/* The angle of a torsional spring, beside the one that it had last. */
static double angle_of(machine *m, int i, const linkage *l)
{
    const fourlink_spring *s = &m->spring[i];
    double complex axis = s->link == 1 ? 1 : l->axis[s->link].v,
                   to = s->to == 1 ? 1 : l->axis[s->to].v;

    m->wound[i] += remainder(carg(axis * conj(to)) - m->wound[i], 2 * PI);
    return m->wound[i];
}

static double work_of_spring(machine *m, int i, const linkage *l, double omega2)
{
    const fourlink_spring *s = &m->spring[i];
    double length, rate;

    if (s->is_torsional) {
        length = angle_of(m, i, l);
        rate = turning(l, s->link) - turning(l, s->to);
    } else {
        jet way = minus(point_of(l, s->to, s->to_at), point_of(l, s->link, s->at));

        length = cabs(way.v);
        rate = along(way.v, way.d) / length;
    }
    return -rate *
           (s->preload + s->stiffness * (length - s->free_length) + s->damping * rate * omega2);
}

static double on_curve(const machine *m, double w)
{
    int last = m->n_curve - 1;

    if (w <= m->curve_speed[0] || w >= m->curve_speed[last])
        return m->curve_torque[w <= m->curve_speed[0] ? 0 : last];
    return gsl_interp_eval(m->curve, m->curve_speed, m->curve_torque, w, NULL);
}

/* The torque of the motor on the crank. */
static double motor_at(const machine *m, double omega2)
{
    double w = m->ratio * omega2, T = m->torque;

    if (m->no_load_speed != 0)
        T = m->stall_torque - m->stall_torque * w / m->no_load_speed;
    if (m->n_curve)
        T = on_curve(m, w);
    if (m->max_torque != 0)
        T = w * m->max_torque > m->power ? m->power / w : m->max_torque;
    return m->ratio * T;
}

/* ------------------------------------------------------------------------------------------- acceleration */

/* Of a machine without friction, by Lagrange's equation; a status. */
static int accelerate(machine *m, double theta2, double omega2, double *alpha2)
{
    fourlink_crank crank = {theta2, omega2, 0};
    fourlink_load load[LOADS];
    fourlink_state state;
    fourlink_forces forces;
    fourlink_losses losses;
    fourlink_load_info info;
    unsigned long i;
    double gas, J, half_slope, push;
    linkage l;
    int status;

    if (!place(m, theta2, &l))
        return FOURLINK_DEAD_POSITION;
    status =
        fourlink_deck_analyse(m->deck, m->branch, &crank, 1, load, &state, &forces, &losses, &gas);
    if (status != FOURLINK_OK)
        return status;
    find_inertia(m, &l, &J, &half_slope);
    push = motor_at(m, omega2) + work_of_weights(m, &l);
    for (i = 0; i < m->problem.n_loads; i++)
        if (fourlink_deck_load(m->deck, i, &info) == FOURLINK_OK &&
            info.sort != FOURLINK_LOAD_SPRING)
            push += work_of_load(&l, &load[i]);
    for (i = 0; i < m->problem.n_springs; i++)
        push += work_of_spring(m, (int)i, &l, omega2);
    *alpha2 = (push - half_slope * omega2 * omega2) / (J + m->inertia);
    return FOURLINK_OK;
}

/* A zero of a function that rises, by Brent's method, to a part of it: from a bracket about `at` that
** grows.  NaN if there is none. */
static double zero_of(double (*f)(double, void *), void *context, double at, double width,
                      double close)
{
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    gsl_function function = {f, context};
    double low = at - width, high = at + width, found = NAN;
    int i;

    for (i = 0; i < 60 && f(low, context) > 0; i++)
        low -= width *= 2;
    for (i = 0; i < 60 && f(high, context) < 0; i++)
        high += width *= 2;
    if (gsl_root_fsolver_set(solver, &function, low, high) == GSL_SUCCESS)
        for (i = 0; i < 100 && !(high - low <= close * fabs(found)); i++) {
            gsl_root_fsolver_iterate(solver);
            found = gsl_root_fsolver_root(solver);
            low = gsl_root_fsolver_x_lower(solver);
            high = gsl_root_fsolver_x_upper(solver);
        }
    gsl_root_fsolver_free(solver);
    return found;
}

/* With friction: what is sought, at a crank angle and speed. */
typedef struct balance {
    machine *m;
    double theta2, omega2;
    double J;    /* kg m2 */
    double size; /* N m, of the largest term */
    int status;
} balance;

/* Ts - T_motor + I_f alpha2, which rises with alpha2; NaN where there are no forces. */
static double miss(double alpha2, void *context)
{
    balance *b = context;
    fourlink_crank crank = {b->theta2, b->omega2, alpha2};
    fourlink_load load[LOADS];
    fourlink_state state;
    fourlink_forces forces;
    fourlink_losses losses;
    double gas, T = motor_at(b->m, b->omega2);

    b->status = fourlink_deck_analyse(b->m->deck, b->m->branch, &crank, 1, load, &state, &forces,
                                      &losses, &gas);
    if (b->status != FOURLINK_OK)
        return NAN;
    b->size = fabs(forces.Ts) + fabs(T) + (b->J + b->m->inertia) * fabs(alpha2);
    return forces.Ts - T + b->m->inertia * alpha2;
}

/* With friction: by secants, and if these do not come to an end by Brent's method. */
static int accelerate_against_friction(machine *m, double theta2, double omega2, double *alpha2)
{
    balance b = {m, theta2, omega2, 0, 0, 0};
    double last = 0, at, value, value_last, half_slope;
    linkage l;
    int i;

    if (!place(m, theta2, &l))
        return FOURLINK_DEAD_POSITION;
    find_inertia(m, &l, &b.J, &half_slope);
    value_last = miss(last, &b);
    at = -value_last / (b.J + m->inertia);
    for (i = 0; i < 8; i++) {
        value = miss(at, &b);
        if (fabs(value) <= 4e-16 * b.size || at == last || value == value_last || isnan(value))
            break;
        *alpha2 = at - value * (at - last) / (value - value_last);
        last = at;
        value_last = value;
        at = *alpha2;
    }
    if (!(fabs(value) <= 1e-14 * b.size)) {
        at = zero_of(miss, &b, at, 1e-3 * fabs(at) + 1e-6 * b.size / (b.J + m->inertia), 1e-15);
        value = miss(at, &b);
    }
    *alpha2 = at;
    return fabs(value) <= 1e-11 * b.size           ? FOURLINK_OK
           : b.status != FOURLINK_OK && !isnan(at) ? b.status
                                                   : FOURLINK_LOCKED;
}

static int alpha_at(machine *m, double theta2, double omega2, double *alpha2)
{
    return m->problem.has_friction ? accelerate_against_friction(m, theta2, omega2, alpha2)
                                   : accelerate(m, theta2, omega2, alpha2);
}

/* ------------------------------------------------------------------------------------------- integration */

#define TOLERANCE 1e-12 /* of a step */
#define COARSE 1e-8
#define NEAR_REST 0.02 /* rad, to where the crank would come to rest */
#define BESIDE 1e-10   /* rad, of corners, where torques may jump */
#define LONGEST 0.05   /* rad, of a step */
#define SHORTEST 1e-13
#define SLOWEST 1e-8 /* of the largest speed: at rest */
#define STEPS 100000 /* of a motion */
#define FEW 600      /* of a cycle in a search */

typedef struct crank_state {
    double theta2, omega2, t;
} crank_state;

enum { REACHES = 0, RESTS = -1, GIVES_UP = -2 }; /* and statuses of the library */

typedef enum variable { ANGLE, TIME, SPEED } variable;

/* An integration; speeds are in units of its own, and times in their reciprocal. */
typedef struct integration {
    machine *m;
    variable over;
    double unit;       /* rad/s */
    double sense;      /* of the rotation; 0: it may swing back */
    double begin, end; /* rad, of the piece between two stops; neither is touched */
    double travel;     /* rad, of all steps */
    double next;       /* rad, the length of the next step over the angle */
    double largest;    /* rad/s */
    double slowest;    /* rad/s, where the crank has been slowed down */
    int status;        /* why there is no acceleration */
    int steps, most;   /* taken, and allowed */
    gsl_odeiv2_step *step;
    gsl_odeiv2_control *control;
    gsl_odeiv2_evolve *evolve;
} integration;

/* The state from the variable and the two unknowns, and back. */
static crank_state unpack(const integration *n, double x, const double y[])
{
    switch (n->over) {
    case ANGLE:
        return (crank_state){x, y[0] * n->unit, y[1] / n->unit};
    case TIME:
        return (crank_state){y[0], y[1] * n->unit, x / n->unit};
    default:
        return (crank_state){y[0], x * n->unit, y[1] / n->unit};
    }
}

static double pack(const integration *n, const crank_state *at, double y[])
{
    y[0] = n->over == ANGLE ? at->omega2 / n->unit : at->theta2;
    y[1] = n->over == TIME ? at->omega2 / n->unit : at->t * n->unit;
    return n->over == ANGLE ? at->theta2 : n->over == TIME ? at->t * n->unit : at->omega2 / n->unit;
}

static int derive(double x, const double y[], double dy[], void *context)
{
    integration *n = context;
    crank_state at = unpack(n, x, y);
    double alpha2 = 0, omega2 = at.omega2, theta2 = at.theta2;

    if (n->sense != 0 && n->sense * (theta2 - n->begin) < BESIDE)
        theta2 = n->begin + n->sense * BESIDE;
    if (n->over == ANGLE && n->sense * (n->end - theta2) < BESIDE)
        theta2 = n->end - n->sense * BESIDE;
    if (n->sense * omega2 < 0)
        omega2 = 0;
    if (n->over == ANGLE && omega2 == 0)
        return GSL_EDOM;
    n->status = alpha_at(n->m, theta2, omega2, &alpha2);
    if (n->status != FOURLINK_OK || !isfinite(alpha2) || (n->over == SPEED && alpha2 == 0))
        return GSL_EDOM;
    alpha2 /= n->unit * n->unit;
    omega2 = at.omega2 / n->unit;
    dy[0] = n->over == ANGLE ? alpha2 / omega2 : n->over == TIME ? omega2 : omega2 / alpha2;
    dy[1] = n->over == ANGLE ? 1 / omega2 : n->over == TIME ? alpha2 : 1 / alpha2;
    return GSL_SUCCESS;
}

static integration started(machine *m, double tolerance, double omega2)
{
    integration n;

    memset(&n, 0, sizeof n);
    n.m = m;
    n.unit = n.slowest = omega2 != 0 ? fabs(omega2) : 1;
    n.sense = !m->problem.over.is_crank_angle ? 0 : m->sense;
    n.begin = m->from;
    n.next = 0.05;
    n.most = tolerance < COARSE ? STEPS : FEW;
    n.step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 2);
    n.control = gsl_odeiv2_control_y_new(0.1 * tolerance, tolerance);
    n.evolve = gsl_odeiv2_evolve_alloc(2);
    return n;
}

static void finish(integration *n)
{
    gsl_odeiv2_evolve_free(n->evolve);
    gsl_odeiv2_control_free(n->control);
    gsl_odeiv2_step_free(n->step);
}

static int why(const integration *n)
{
    return n->status > 0 ? n->status : GIVES_UP;
}

/* One step of at most *h, not beyond `to`, in units of the variable: 1, and the *h for the next; or 0,
** and *h is shorter. */
static int take(integration *n, variable over, double to, double *h, crank_state *at)
{
    gsl_odeiv2_system system = {derive, NULL, 2, n};
    crank_state before = *at;
    double y[2], x;
    int status;

    n->over = over;
    x = pack(n, at, y);
    *h = copysign(*h, to - x);
    gsl_odeiv2_evolve_reset(n->evolve);
    gsl_odeiv2_step_reset(n->step);
    status = gsl_odeiv2_evolve_apply(n->evolve, n->control, n->step, &system, &x, to, h, y);
    *h = fabs(*h);
    if (status != GSL_SUCCESS || !isfinite(y[0]) || !isfinite(y[1])) {
        *h *= 0.2;
        return 0;
    }
    *at = unpack(n, x, y);
    n->steps++;
    n->largest = fmax(n->largest, fabs(at->omega2));
    n->travel += fabs(at->theta2 - before.theta2);
    if (fabs(at->omega2) < fabs(before.omega2))
        n->slowest = fmin(n->slowest, fabs(at->omega2));
    return 1;
}

/* Over the variable to a value, or up to where this is not possible. */
static int take_to(integration *n, variable over, double to, crank_state *at)
{
    double y[2], h, whole;

    n->over = over;
    h = whole = fabs(to - pack(n, at, y));
    while (n->over = over, pack(n, at, y) != to) {
        h = over == ANGLE ? fmin(h, LONGEST) : h;
        if (n->steps > n->most || (!take(n, over, to, &h, at) && h < SHORTEST * whole))
            return why(n);
    }
    return REACHES;
}

/* A step over the time near rest, not beyond an angle: REACHES, RESTS, or a reason. */
static int creep(integration *n, double to, double alpha2, crank_state *at)
{
    double speed = fabs(at->omega2), length = fmin(0.5 * NEAR_REST, fabs(to - at->theta2)), h;
    crank_state before = *at;

    h = 2 * length / (speed + sqrt(speed * speed + 2 * fabs(alpha2) * length)) * n->unit;
    for (;; h *= 0.2) {
        while (!take(n, TIME, HUGE_VAL, &h, at))
            if (h < SHORTEST)
                return why(n);
        if (n->sense * at->omega2 > 0 && n->sense * (at->theta2 - to) <= 0)
            return REACHES;
        h = (at->t - before.t) * n->unit;
        if (n->sense * at->omega2 <= 0 && before.omega2 != 0) {
            *at = before;
            return take_to(n, SPEED, 0, at) == REACHES ? RESTS : why(n);
        }
        *at = before;
        if (before.omega2 != 0)
            return take_to(n, ANGLE, to, at);
        if (h < SHORTEST)
            return GIVES_UP;
    }
}

/* The next corner after an angle, or the goal. */
static double next_stop(const integration *n, double theta2, double goal)
{
    const machine *m = n->m;
    double nearest = fabs(goal - theta2), stop = goal;
    int i;

    for (i = 0; i < m->n_corners; i++) {
        double way = fmod(n->sense * (m->corner[i] - theta2), m->problem.cycle);

        way += way < 0 ? m->problem.cycle : 0;
        if (way > 10 * BESIDE && way < nearest - 10 * BESIDE) {
            nearest = way;
            stop = theta2 + n->sense * nearest;
        }
    }
    return stop;
}

/* A step to an angle or less. */
static int go_on(integration *n, double to, crank_state *at)
{
    double alpha2 = 0;
    double beside = at->theta2 == n->begin ? n->sense * BESIDE : 0;
    int status = alpha_at(n->m, at->theta2 + beside, at->omega2, &alpha2);

    if (status != FOURLINK_OK)
        return status;
    if (at->omega2 != 0 && fabs(at->omega2) < SLOWEST * n->largest && n->sense * alpha2 <= 0)
        return RESTS;
    if (at->omega2 * at->omega2 <= 2 * fabs(alpha2) * NEAR_REST)
        return creep(n, to, alpha2, at);
    n->next = fmin(fmax(n->next, 1e-6), LONGEST);
    while (!take(n, ANGLE, to, &n->next, at))
        if (n->next < SHORTEST)
            return why(n);
    return REACHES;
}

/* To a crank angle: REACHES, RESTS, or a reason. */
static int advance(integration *n, double goal, crank_state *at)
{
    int status = REACHES;

    while (status == REACHES && n->sense * (goal - at->theta2) > 0) {
        n->end = next_stop(n, at->theta2, goal);
        status = n->steps++ > n->most ? GIVES_UP : go_on(n, n->end, at);
        if (at->theta2 == n->end)
            n->begin = n->end;
    }
    return status;
}

/* To a time, of a machine that may swing back. */
static int wait(integration *n, double t, crank_state *at)
{
    double h = 1e-3;

    while (t * n->unit - at->t * n->unit > SHORTEST) {
        h = fmin(h, LONGEST / fmax(fabs(at->omega2) / n->unit, 0.1));
        if (n->steps > n->most || (!take(n, TIME, t * n->unit, &h, at) && h < SHORTEST))
            return why(n);
    }
    return REACHES;
}

/* ------------------------------------------------------------------------------------------- reading */

/* An input in SI units, 0 if the deck does not have it. */
static double input(fourlink_results *r, const char *name)
{
    const fourlink_value *list;
    unsigned long n, i;

    if (fourlink_results_list(r, FOURLINK_INPUTS, &list, &n) == FOURLINK_OK)
        for (i = 0; i < n; i++)
            if (strcmp(list[i].name, name) == 0 && !list[i].words)
                return list[i].value * list[i].to_si;
    return 0;
}

/* A fact in SI units, NaN if there is none. */
static double fact(const machine *m, const char *name)
{
    fourlink_value v;
    int status = fourlink_results_value(m->results, name, m->branch, 0, &v);

    return status == FOURLINK_OK ? v.value * v.to_si : NAN;
}

/* Where the friction of a yoke's slot and guide reverses: the crank is across the guide, or across the slot.
** */
static void add_reversals(machine *m)
{
    double beta = m->problem.mechanism.design.angle;
    int i;

    for (i = -1; i <= 1 && m->n_corners + 2 <= CORNERS; i += 2) {
        m->corner[m->n_corners++] = i * PI / 2;
        m->corner[m->n_corners++] = beta + i * PI / 2;
    }
}

/* Crank angles of loads and of the gas: all numbers of degrees in their sections. */
static void read_corners(const char *deck, machine *m)
{
    int is_there = 0;
    const char *at, *begin;

    for (at = deck; *at; at++) {
        if (*at == '[')
            is_there = strncmp(at, "[load", 5) == 0 || strncmp(at, "[gas", 4) == 0;
        if (!is_there || strncmp(at, " deg", 4) != 0 || m->n_corners == CORNERS)
            continue;
        for (begin = at; begin > deck && strchr("0123456789.-", begin[-1]); begin--)
            ;
        m->corner[m->n_corners++] = strtod(begin, NULL) * PI / 180;
    }
}

#define CURVE "[motor]\ncurve = "

/* "curve = 0 rad/s 5 N m, 30 rad/s 7 N m" of the motor */
static void read_curve(const char *deck, machine *m)
{
    const char *at = strstr(deck, CURVE);

    at = at ? at + strlen(CURVE) : NULL;
    for (m->n_curve = 0; at && m->n_curve < POINTS; m->n_curve++) {
        if (sscanf(at, "%lf rad/s %lf N m", &m->curve_speed[m->n_curve],
                   &m->curve_torque[m->n_curve]) != 2)
            break;
        at += strcspn(at, ",\n");
        at += *at == ',' ? 2 : 0;
    }
    if (m->n_curve > 1) {
        m->curve = gsl_interp_alloc(m->n_curve > 2 ? gsl_interp_steffen : gsl_interp_linear,
                                    (size_t)m->n_curve);
        gsl_interp_init(m->curve, m->curve_speed, m->curve_torque, (size_t)m->n_curve);
    }
}

static void read_motor(const char *deck, machine *m)
{
    fourlink_results *r = m->results;

    m->ratio = input(r, "motor.ratio") != 0 ? input(r, "motor.ratio") : 1;
    m->torque = input(r, "motor.torque");
    m->balances = strstr(deck, "torque = constant") != NULL;
    if (m->balances)
        m->torque = fact(m, "motor_torque") / m->ratio;
    m->stall_torque = input(r, "motor.stall_torque");
    m->no_load_speed = input(r, "motor.no_load_speed");
    m->power = input(r, "motor.power");
    m->max_torque = input(r, "motor.max_torque");
    read_curve(deck, m);
    m->finds_flywheel = strstr(deck, "exact = yes") != NULL;
    m->inertia = m->finds_flywheel ? fact(m, "flywheel_inertia") : input(r, "flywheel.inertia");
    m->inertia += m->ratio * m->ratio * input(r, "motor.inertia");
}

/* Follow the angles of torsional springs from the first crank angle >= 0 that the links reach to another
** one. */
static void wind(machine *m, double theta2)
{
    double first = 0, step;
    unsigned long i;
    linkage l;
    long k, n;

    while (first < 2 * PI && !place(m, first, &l))
        first += 1e-3;
    n = (long)(fabs(theta2 - first) / 0.02) + 1;
    step = (theta2 - first) / (double)n;
    for (i = 0; i < m->problem.n_springs; i++)
        m->wound[i] = m->spring[i].free_length;
    for (k = 0; k <= n; k++)
        for (i = 0; i < m->problem.n_springs && place(m, first + (double)k * step, &l); i++)
            if (m->spring[i].is_torsional)
                angle_of(m, (int)i, &l);
}

static char text[100000];

static int read_text(const char *name)
{
    FILE *file = fopen(name, "rb");
    size_t n = file ? fread(text, 1, sizeof text - 1, file) : 0;

    if (file)
        fclose(file);
    text[n] = '\0';
    return n > 0;
}

static int open_machine(const char *name, machine *m)
{
    fourlink_change change = {"trial", "table.columns = T_motor, J, energy_residual"};
    fourlink_source source;
    fourlink_mistake mistake;
    unsigned long i;

    memset(m, 0, sizeof *m);
    memset(&source, 0, sizeof source);
    if (!read_text(name))
        return 0;
    source.name = name;
    source.text = text;
    source.length = strlen(text);
    source.changes = &change;
    source.n_changes = 1;
    if (fourlink_results_open(&source, 1, &m->results, &mistake, NULL) != FOURLINK_OK)
        return 0;
    m->deck = fourlink_results_deck(m->results);
    fourlink_deck_problem(m->deck, &m->problem);
    m->branch = m->problem.open ? FOURLINK_OPEN : FOURLINK_CROSSED;
    m->sense = m->problem.motion.to < m->problem.motion.from ? -1 : 1;
    m->from = m->problem.motion.from * m->problem.motion.angle_unit;
    for (i = 0; i < m->problem.n_springs && i < SPRINGS; i++)
        fourlink_deck_spring(m->deck, i, NULL, &m->spring[i]);
    read_corners(text, m);
    if (m->problem.has_friction && m->problem.mechanism.design.kind == FOURLINK_SCOTCH_YOKE)
        add_reversals(m);
    read_motor(text, m);
    return 1;
}

/* ------------------------------------------------------------------------------------------- rows */

#define ROWS 1e-8     /* of the largest speed, of the time; by time for each turn */
#define BEFORE 1e-3   /* rad, before the crank is locked: nearer, rows are not compared */
#define EQUATION 1e-9 /* of the largest acceleration, at the speed of the row */
#define SHAFT 1e-11   /* of the torques on the shaft */
#define WORK 1e-11    /* energy_residual */
#define END 1e-5      /* rad */

static const char *name_of_deck;
static int is_failed;

static int fail(const char *format, ...)
{
    va_list arguments;

    printf("%s: ", name_of_deck);
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    printf("\n");
    is_failed = 1;
    return 0;
}

static int fail_at_end(const char *what, double told, const crank_state *at, int how)
{
    return fail("%s at %.10g deg, but the integration ends at %.10g deg: %s", what, told,
                at->theta2 * 180 / PI,
                how == REACHES    ? "the goal"
                : how == RESTS    ? "at rest"
                : how == GIVES_UP ? "too many steps"
                                  : fourlink_status_text(how));
}

/* The largest differences: of a machine, and of all that agree, without friction and with. */
typedef struct worst {
    long rows, machines;
    double omega2, alpha2, time, angle, shaft, work;
} worst;

static worst of_machine, of_all[2];

static void widen(double *most, double difference)
{
    if (!(difference <= *most))
        *most = difference;
}

static void keep_worst(const machine *m)
{
    worst *all = &of_all[m->problem.has_friction != 0];

    all->machines++;
    all->rows += of_machine.rows;
    widen(&all->omega2, of_machine.omega2);
    widen(&all->alpha2, of_machine.alpha2);
    widen(&all->time, of_machine.time);
    widen(&all->angle, of_machine.angle);
    widen(&all->shaft, of_machine.shaft);
    widen(&all->work, of_machine.work);
}

/* Take note of a difference; a mistake if it is larger than allowed. */
static void check(double *most, double difference, double allowed, const char *what, double angle)
{
    if (!(difference <= allowed) && !is_failed)
        fail("at %.10g deg %s is off by %.3g", angle, what, difference);
    widen(most, difference);
}

typedef struct row {
    fourlink_instant at;
    double T_motor, J, work; /* columns */
} row;

static int row_of(const machine *m, unsigned long i, row *r)
{
    double values[3] = {0, 0, 0};
    int status = fourlink_results_row(m->results, m->branch, i, values, &r->at, NULL);

    r->T_motor = values[0];
    r->J = values[1];
    r->work = values[2];
    return status;
}

/* The largest values of all rows. */
typedef struct sizes {
    double omega2, alpha2, time;
} sizes;

static sizes sizes_of(const machine *m)
{
    sizes s = {0, 0, 0};
    unsigned long i;
    row r;

    for (i = 0; i < m->problem.n_rows && row_of(m, i, &r) == FOURLINK_OK; i++) {
        s.omega2 = fmax(s.omega2, fabs(r.at.row.crank.omega2));
        s.alpha2 = fmax(s.alpha2, fabs(r.at.row.crank.alpha2));
        s.time = fmax(s.time, fabs(r.at.row.time));
    }
    return s;
}

static double share(double x, double of)
{
    return x == 0 ? 0 : fabs(x) / of;
}

/* Of the points of its curve, or of its line: the sizes of what its torque is the difference of. */
static double most_torque(const machine *m)
{
    double most = fabs(m->stall_torque);
    int i;

    for (i = 0; i < m->n_curve; i++)
        most = fmax(most, fabs(m->curve_torque[i]));
    return 10 * fabs(m->ratio) * most;
}

/* A row against the integration: motion, equation of motion, torque of the shaft by the pin forces,
** energy.  Where the crank has nearly stopped, at a speed w, an error of the energy is one of the time
** (largest speed / w)^2 times as large. */
static void compare_row(machine *m, const row *r, const crank_state *at, const integration *n,
                        const sizes *s)
{
    worst *w = &of_machine;
    const fourlink_crank *crank = &r->at.row.crank;
    double angle = r->at.row.angle, alpha2 = NAN, T = motor_at(m, crank->omega2);
    double slow = fmax(1, s->omega2 / (100 * n->slowest));
    double rows = !m->problem.over.is_crank_angle ? ROWS * (1 + n->travel / (2 * PI)) : ROWS;

    alpha_at(m, crank->theta2, crank->omega2, &alpha2);
    check(&w->omega2, share(crank->omega2 - at->omega2, s->omega2), rows, "omega2", angle);
    check(&w->alpha2, share(crank->alpha2 - alpha2, s->alpha2), EQUATION, "alpha2", angle);
    if (!m->problem.over.is_crank_angle)
        check(&w->angle, fabs(crank->theta2 - at->theta2), rows, "theta2", angle);
    else
        check(&w->time, share(r->at.row.time - at->t, s->time) / (slow * slow), ROWS, "time",
              angle);
    check(&w->shaft,
          share(r->at.forces.Ts - T + m->inertia * crank->alpha2,
                fabs(T) + (r->J + m->inertia) * s->alpha2),
          SHAFT, "Ts", angle);
    check(&w->shaft, share(r->T_motor - T, fabs(T) + most_torque(m)), SHAFT, "T_motor", angle);
    check(&w->work, fabs(r->work), WORK, "energy_residual", angle);
    w->rows++;
}

/* Where friction locks it, rad, or infinite. */
static double lock_of(const machine *m)
{
    double angle;

    return fourlink_results_end(m->results, m->branch, &angle) == FOURLINK_LOCKED
               ? angle * m->problem.motion.angle_unit
               : INFINITY;
}

/* A row is that at its place. */
static void check_place(machine *m, unsigned long i, const row *r)
{
    const fourlink_abscissa *over = &m->problem.over;
    double sense = over->last < over->first ? -1 : 1;
    double place =
        i + 1 < m->problem.n_rows ? over->first + sense * ((double)i * over->step) : over->last;
    fourlink_instant at;

    if (i + 1 == m->problem.n_rows && fabs(r->at.row.place - place) <= 1e-15 * fabs(place))
        place = r->at.row.place; /* the last row is a whole number of steps from the first */
    if (fourlink_results_along(m->results, m->branch, place, NULL, &at, NULL) != FOURLINK_OK ||
        memcmp(&at.row, &r->at.row, offsetof(fourlink_row, side)) != 0 || at.row.place != place)
        fail("row %lu is not at %.17g %s", i, place, over->unit);
}

/* All rows up to the first without a motion. */
static void compare_rows(machine *m, integration *n, const sizes *s, crank_state *at)
{
    double locked = lock_of(m);
    unsigned long i;
    row r;

    for (i = 0; i < m->problem.n_rows && row_of(m, i, &r) == FOURLINK_OK; i++) {
        int status = !m->problem.over.is_crank_angle ? wait(n, r.at.row.time, at)
                                                     : advance(n, r.at.row.crank.theta2, at);

        if (status != REACHES) {
            fail_at_end("a row is", r.at.row.angle, at, status);
            return;
        }
        check_place(m, i, &r);
        if (!(fabs(locked - at->theta2) < BEFORE))
            compare_row(m, &r, at, n, s);
    }
}

/* ----------------------------------------------------------------------------------- steady motions */

/* Of a cycle that begins at a speed: 1 if it is passed, with the state after it. */
static int pass_cycle(machine *m, double omega2, double tolerance, crank_state *after)
{
    integration n = started(m, tolerance, omega2);
    int status;

    *after = (crank_state){m->from, omega2, 0};
    wind(m, m->from);
    status = advance(&n, m->from + m->sense * 2 * PI, after);
    finish(&n);
    return status == REACHES;
}

static double after_cycle(machine *m, double omega2)
{
    crank_state after;

    return pass_cycle(m, omega2, TOLERANCE, &after) ? after.omega2 : NAN;
}

static struct {
    long repeat, rates, reached, stall;
} steady;

#define CYCLES 30

/* A run-up comes to the steady motion, or does not pass its first cycle. */
static void check_run_up(machine *m, double omega2)
{
    integration n = started(m, COARSE, omega2);
    crank_state at = {m->from, 0, 0};
    int i, status = REACHES;

    n.most = STEPS;
    wind(m, m->from);
    for (i = 0; i < CYCLES && status == REACHES && fabs(at.omega2 - omega2) > 1e-5 * fabs(omega2);
         i++)
        status = advance(&n, m->from + m->sense * 2 * PI * (i + 1), &at);
    finish(&n);
    if (status == REACHES && i == CYCLES)
        fail("a run-up comes to %.10g rad/s, not to %.10g rad/s", at.omega2, omega2);
    steady.reached += status == REACHES;
    steady.stall += status != REACHES;
}

#define DIFFERENCE 1e-5 /* of the largest energy, for a derivative */

/* By which a small difference of speed has grown after a cycle; of the energy it is DIFFERENCE. */
static double rate_of(machine *m, double omega2, double largest)
{
    double h = fmin(DIFFERENCE * largest * largest / fabs(omega2), 0.01 * fabs(omega2));

    return (after_cycle(m, omega2 + h) - after_cycle(m, omega2 - h)) / (2 * h);
}

/* A steady motion repeats, with the rate that is told, and is stable; of several it is that of a run-up.
** Where the crank nearly stops, a slower one stalls. */
static void check_steady(machine *m, double first, double last, const integration *n)
{
    double told = fact(m, "steady_rate"), wanted = input(m->results, "motion.mean_speed"), rate;

    steady.repeat++;
    if (!(fabs(last - first) <= ROWS * n->largest))
        fail("after a cycle omega2 is %.15g, not %.15g", last, first);
    if (wanted != 0 && !(fabs(fact(m, "mean_speed") / wanted - 1) <= ROWS))
        fail("mean_speed is %.10g, not %.10g", fact(m, "mean_speed"), wanted);
    if (m->balances && n->slowest < 0.02 * n->largest)
        return;
    rate = rate_of(m, first, n->largest);
    steady.rates++;
    if (!(fabs(rate - told) <= 1e-4))
        fail("steady_rate is %.10g, expected %.10g", told, rate);
    if (!m->balances && !(told <= 1))
        fail("the steady motion is not stable: %.10g", told);
    if (!m->balances && rate < 0.4 && !m->problem.has_friction)
        check_run_up(m, first);
}

/* 1 if a spring has another angle after a cycle. */
static int is_wound(machine *m)
{
    double angle[SPRINGS];
    unsigned long i;
    int is_other = 0;

    wind(m, m->from);
    memcpy(angle, m->wound, sizeof angle);
    wind(m, m->from + m->sense * 2 * PI);
    for (i = 0; i < m->problem.n_springs; i++)
        is_other |= m->spring[i].is_torsional && m->spring[i].stiffness != 0 &&
                    fabs(angle[i] - m->wound[i]) > 1;
    return is_other;
}

/* Of a motor that balances the loads: what a cycle from a speed gains with a torque on the crank, in the
** sense of the motion. */
typedef struct gain {
    machine *m;
    double omega2;
    crank_state after;
} gain;

static double gain_with(double torque, void *context)
{
    gain *g = context;

    g->m->torque = g->m->sense * torque / g->m->ratio;
    return pass_cycle(g->m, g->omega2, COARSE, &g->after) ? fabs(g->after.omega2 / g->omega2) - 1
                                                          : -1;
}

/* The mean speed of the motion that repeats itself from a speed; 0 if there is none. */
static double mean_speed_from(machine *m, double omega2)
{
    gain g = {m, omega2, {0, 0, 0}};
    double torque = zero_of(gain_with, &g, 0, 1, 1e-3);

    return fabs(gain_with(torque, &g)) < 0.1 ? 2 * PI / g.after.t : 0;
}

/* What is sought at a first speed: LOW, it is at a higher one; HIGH, at a lower one; NOWHERE: the crank
** does not pass a cycle. */
typedef enum side { NOWHERE, LOW, HIGH } side;

#define GAINS 1e-6 /* of the speed, in a cycle */

static side side_of(machine *m, double omega2)
{
    double wanted = fabs(input(m->results, "motion.mean_speed")), mean, gained;
    crank_state after;

    if (m->balances) {
        mean = mean_speed_from(m, omega2);
        return mean == 0 ? NOWHERE : mean < wanted ? LOW : HIGH;
    }
    if (!pass_cycle(m, omega2, COARSE, &after))
        return NOWHERE;
    gained = after.omega2 / omega2 - 1;
    return gained > GAINS ? LOW : gained < -GAINS ? HIGH : NOWHERE;
}

#define HALVINGS 4

/* 1 if there is a speed with LOW between one with NOWHERE and a HIGH one. */
static int is_low_between(machine *m, double low, double high)
{
    int i;

    for (i = 0; i < HALVINGS; i++) {
        double middle = m->sense * sqrt(low * high);
        side at = side_of(m, middle);

        if (at == LOW)
            return 1;
        if (at == NOWHERE)
            low = middle;
        else
            high = middle;
    }
    return 0;
}

/* No steady motion: there are no two speeds at the lower of which a cycle gains energy and at the higher
** loses it; with a motor that balances the loads, at the lower of which the mean speed is too low and at
** the higher too high. */
static int confirm_no_steady(machine *m)
{
    double factor = m->balances ? 2 : 1.8;
    double omega2 =
        m->sense * (m->balances ? 0.2 * fabs(input(m->results, "motion.mean_speed")) : 0.3);
    side last = NOWHERE, now;
    int k;

    if (is_wound(m))
        return 1;
    if (m->finds_flywheel)
        return 0;
    for (k = 0; k < (m->balances ? 7 : 20); k++, last = now, omega2 *= factor) {
        now = side_of(m, omega2);
        if (now == HIGH && (last == LOW || (k > 0 && last == NOWHERE &&
                                            is_low_between(m, omega2 / factor, omega2))))
            return fail("no steady motion was found, but one is below %g rad/s", omega2);
        if (now == HIGH)
            break;
    }
    return 1;
}

/* ------------------------------------------------------------------------------------------- ends */

#define STATUSES 20

static struct {
    long n, confirmed;
} ends[STATUSES];

/* Beyond the last row: how the integration ends. */
static int end_of(integration *n, double beyond, crank_state *at)
{
    const machine *m = n->m;

    return !m->problem.over.is_crank_angle ? wait(n, m->problem.over.last, at)
                                           : advance(n, beyond, at);
}

/* How the motion ends: 1 if the integration does so too, 0 if that is not known. */
static int confirm_end(machine *m, integration *n, crank_state *at, int status, double angle)
{
    double alpha2 = 0, end = angle * m->problem.motion.angle_unit;
    int how, is_steady = m->problem.mode == FOURLINK_MODE_STEADY;
    linkage l;

    if (status == FOURLINK_NO_STEADY)
        return confirm_no_steady(m);
    if (!place(m, m->from, &l))
        return status < FOURLINK_SINGULAR;
    if (status == FOURLINK_DOES_NOT_START) {
        how = alpha_at(m, m->from + m->sense * BESIDE, 0, &alpha2);
        return how != FOURLINK_OK || m->sense * alpha2 <= 0 ||
               fail("does not start, but alpha2 is %g", alpha2);
    }
    how = end_of(n, end + m->sense * 2 * PI, at);
    switch (status) {
    case FOURLINK_STALLS:
    case FOURLINK_LOCKED:
        if ((status == FOURLINK_STALLS ? how != RESTS : how != FOURLINK_LOCKED) ||
            (!is_steady && fabs(at->theta2 - end) > END))
            return fail_at_end(fourlink_status_text(status), angle, at, how);
        return 1;
    case FOURLINK_DEAD_POSITION:
        if (how == REACHES || (!is_steady && fabs(at->theta2 - end) > 1e-3))
            return fail_at_end("dead", angle, at, how);
        return 1;
    default:
        return 0;
    }
}

/* The speed at the first row. */
static double first_speed(const machine *m, int end)
{
    row first;

    if (m->problem.mode == FOURLINK_MODE_FREE)
        return input(m->results, "motion.speed");
    return m->problem.mode == FOURLINK_MODE_STEADY && end == FOURLINK_OK &&
                   row_of(m, 0, &first) == FOURLINK_OK
               ? first.at.row.crank.omega2
               : 0;
}

static void compare(machine *m)
{
    double angle;
    int end = fourlink_results_end(m->results, m->branch, &angle);
    sizes s = sizes_of(m);
    crank_state at = {m->from, first_speed(m, end), 0};
    integration n = started(m, TOLERANCE, s.omega2);

    wind(m, m->from);
    n.largest = fabs(at.omega2);
    compare_rows(m, &n, &s, &at);
    ends[end].n++;
    if (!is_failed && end == FOURLINK_OK && m->problem.mode == FOURLINK_MODE_STEADY)
        check_steady(m, first_speed(m, end), at.omega2, &n);
    if (!is_failed && (end == FOURLINK_OK || confirm_end(m, &n, &at, end, angle)) && !is_failed)
        ends[end].confirmed++;
    finish(&n);
}

enum { KINDS, MODES, MOTORS, PARTS, GROUPS, MOST = 8 };

static const char *const names[GROUPS][MOST] = {
    {"four-bar linkages", "slider-cranks", "inverted slider-cranks", "Scotch yokes"},
    {"free", "run-up", "steady", "by time"},
    {"no motor", "constant torque", "balance", "line", "curve", "power"},
    {"friction", "springs", "gas", "loads over a speed or a position", "flywheel found"}};

static struct {
    long tried, agree;
} category[GROUPS][MOST];

static void count(int group, int i)
{
    category[group][i].tried++;
    category[group][i].agree += !is_failed;
}

static void count_categories(const machine *m)
{
    int kind = (int)m->problem.mechanism.design.kind;

    count(KINDS, kind == FOURLINK_FOUR_BAR                ? 0
                 : kind == FOURLINK_SLIDER_CRANK          ? 1
                 : kind == FOURLINK_INVERTED_SLIDER_CRANK ? 2
                                                          : 3);
    count(MODES, !m->problem.over.is_crank_angle ? 3 : m->problem.mode - FOURLINK_MODE_FREE);
    count(MOTORS, m->balances            ? 2
                  : m->stall_torque != 0 ? 3
                  : m->n_curve           ? 4
                  : m->max_torque != 0   ? 5
                  : m->torque != 0       ? 1
                                         : 0);
    if (m->problem.has_friction)
        count(PARTS, 0);
    if (m->problem.n_springs)
        count(PARTS, 1);
    if (m->problem.has_gas)
        count(PARTS, 2);
    if (strstr(text, "\nover = "))
        count(PARTS, 3);
    if (m->finds_flywheel)
        count(PARTS, 4);
}

static void print_categories(void)
{
    int group, i;

    for (group = 0; group < GROUPS; group++)
        for (i = 0; i < MOST && names[group][i]; i++)
            printf("%ld tried, %ld agree: %s\n", category[group][i].tried, category[group][i].agree,
                   names[group][i]);
}

static void print_differences(void)
{
    int i;

    for (i = 0; i < 2; i++) {
        const worst *w = &of_all[i];

        printf("%ld rows of %ld machines that agree, %s friction: omega2 within %.2g, alpha2 %.2g, "
               "time %.2g, ",
               w->rows, w->machines, i ? "with" : "without", w->omega2, w->alpha2, w->time);
        printf("theta2 by time %.2g, torques of the shaft %.2g; energy_residual %.2g\n", w->angle,
               w->shaft, w->work);
    }
}

static void print_ends(void)
{
    int i;

    for (i = 0; i < STATUSES; i++)
        if (ends[i].n)
            printf("%ld tried, %ld confirmed: %s\n", ends[i].n, ends[i].confirmed,
                   fourlink_status_text(i));
    printf("%ld steady motions repeat, %ld have the rate that is told; ", steady.repeat,
           steady.rates);
    printf("%ld are reached by a run-up, %ld run-ups stall\n", steady.reached, steady.stall);
}

int main(int argc, char *argv[])
{
    int i, failed = 0;

    gsl_set_error_handler_off();
    for (i = 1; i < argc; i++) {
        machine m;

        name_of_deck = argv[i];
        is_failed = 0;
        memset(&of_machine, 0, sizeof of_machine);
        if (open_machine(argv[i], &m)) {
            compare(&m);
            count_categories(&m);
            if (!is_failed)
                keep_worst(&m);
        } else {
            fail("cannot be read");
        }
        gsl_interp_free(m.curve);
        fourlink_results_free(m.results);
        failed += is_failed;
    }
    print_categories();
    print_differences();
    print_ends();
    printf("%d passed, %d failed\n", argc - 1 - failed, failed);
    return failed > 0;
}
