/* SPDX-License-Identifier: GPL-3.0-or-later
**
** steady.c - the motion that repeats after a cycle.
**
** From the energy E0 at the first row the crank reaches the energy g(E0) after a cycle, in the time t.  The
** unknowns are the speed v at the first row and, for a motor that balances the loads, its torque T:
**
**    g(E0) - E0 = 0                                for any motor, for v
**    g(E0) - E0 = 0,   mean_speed t - cycle = 0    for a motor that balances, for v and T
**
** The first is solved by Newton's method in E0, with g' = exp(growth) from the path, between speeds at which
** the machine gains and loses energy in a cycle.  It starts from the lowest speed above which the mean torque
** of a cycle at constant speed is negative: a run-up ends there, because below it the machine gains speed.
** The motion is stable if g' < 1.
**
** The second is solved by Broyden's method in ln v and T (C. G. Broyden, Math. Comp. 19, 577, 1965).
**
** For a motor that balances the loads, Broyden's method may fail where the crank nearly comes to rest, with a
** small flywheel.  But two solutions E(theta) of dE/dtheta = T + Q with different T cross in one sense only,
** and with the same T not at all.  So the energy after a cycle grows with T, there is at most one T for each
** v, and motions with larger v are faster at every angle.  Both unknowns can therefore be bracketed: T for
** each v, and v.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "steady.h"
#include "base/solve.h"

#define PLACES 18
#define SPEEDS 60 /* that are tried */
#define FACTOR 1.4
#define STEPS 60
#define HALVINGS 30
#define LONGEST_STEP 0.3 /* of ln v, without a better step */
#define SHORT 3e-2       /* of ln v: the growth hardly changes over this */
#define DOUBLINGS 40
#define COARSE 1e-6 /* tolerance of the steps of first solutions, and their error */
#define NEAR 1e-10  /* of a bracketed unknown and its bracket: the error of the steps is larger */
#define DIFFERENCE 1e-7 /* of an unknown, for a derivative */
#define CLOSE 1e-13     /* of the energy, the cycle: solved */
#define ROUNDED \
    1e-9 /* ... without getting closer: friction corners, periods that depend on last digits */

/* The equations in one or two unknowns. */
typedef struct problem {
    flk_path *p;
    double cycle, mean_speed;
    int has_torque;     /* 1: T is unknown too */
    double torque_unit; /* N m */
} problem;

/* The mean torque of a cycle at a constant speed, in the sense of the motion, N m; 0 if there is no
** position. */
static int mean_torque(const flk_path *p, double cycle, double speed, double *mean)
{
    flk_machine_place place;
    flk_machine_torque torque;
    int i;

    *mean = 0;
    for (i = 0; i < PLACES; i++) {
        double theta2 = p->equation.from + p->equation.sense * cycle * ((double)i + 0.381) / PLACES;

        if (flk_machine_at(&p->equation.machine, p->equation.branch, theta2, &place) !=
                FOURLINK_OK ||
            flk_equation_torque(&p->equation, &place, speed, &torque) != FOURLINK_OK)
            return 0;
        *mean += torque.net / PLACES;
    }
    return 1;
}

/* A speed of the order of the motor's speeds. */
static double size_of_speed(const fourlink_motor *motor, double torque, double total)
{
    double w = 0;

    switch (motor->kind) {
    case FOURLINK_MOTOR_LINEAR:
        w = motor->no_load_speed;
        break;
    case FOURLINK_MOTOR_CURVE:
        w = GSL_MAX(fabs(motor->curve_speed[0]), fabs(motor->curve_speed[motor->n_curve - 1]));
        break;
    case FOURLINK_MOTOR_POWER:
        w = motor->power / motor->max_torque;
        break;
    default:
        return sqrt(fabs(torque) / total);
    }
    return fabs(w / motor->ratio);
}

/* The speed at which the mean torque turns negative; 0: there is none. */
static double guess_speed(const flk_path *p, double cycle)
{
    double mean, last = 0, speed, largest;
    flk_machine_place place;
    int i;

    if (flk_machine_at(&p->equation.machine, p->equation.branch, p->equation.from, &place) !=
            FOURLINK_OK ||
        !mean_torque(p, cycle, 0, &mean))
        return 0;
    largest = size_of_speed(&p->equation.machine.motor, mean, place.total);
    speed = largest / 1000;
    for (i = 0; i < SPEEDS && mean_torque(p, cycle, speed, &mean); i++, speed *= FACTOR) {
        if (last > 0 && mean <= 0)
            return speed / FACTOR * pow(FACTOR, last / (last - mean));
        last = mean;
    }
    return 0;
}

/* Find the residuals at x = ln v, T; 0 if the crank stalls. */
static int find_residuals(const problem *q, const double *x, double *r)
{
    const flk_node *end;

    if (q->has_torque)
        q->p->equation.machine.motor.torque =
            q->p->equation.sense * x[1] * q->torque_unit / q->p->equation.machine.motor.ratio;
    if (!flk_path_run(q->p, exp(x[0]), q->cycle))
        return 0;
    end = flk_path_end(q->p);
    r[0] = log(end->y[FLK_ENERGY] / q->p->node[0].y[FLK_ENERGY]);
    r[1] = q->mean_speed * end->t / q->cycle - 1;
    return 1;
}

static double size(const double *r)
{
    return gsl_hypot(r[0], r[1]);
}

/* B dx = -r */
static int solve(double B[2][2], const double *r, double *dx)
{
    double det = B[0][0] * B[1][1] - B[0][1] * B[1][0];

    dx[0] = (-r[0] * B[1][1] + r[1] * B[0][1]) / det;
    dx[1] = (-r[1] * B[0][0] + r[0] * B[1][0]) / det;
    return fabs(dx[0]) <= 1e30 && fabs(dx[1]) <= 1e30;
}

/* B += (dr - B dx) dx / dx.dx */
static void update(double B[2][2], const double *dx, const double *dr)
{
    double square = dx[0] * dx[0] + dx[1] * dx[1];
    int i, j;

    for (i = 0; i < 2; i++) {
        double left = dr[i] - B[i][0] * dx[0] - B[i][1] * dx[1];

        for (j = 0; j < 2; j++)
            B[i][j] += left * dx[j] / square;
    }
}

/* A step from x, shorter while the crank stalls or the residuals grow; 0 if no step is short enough. */
static int step(const problem *q, double *x, double *r, const double *dx, double B[2][2])
{
    double next[2], at[2], moved[2], change[2], part = 1;
    int i, k;

    for (k = 0; k < 2; k++)
        part = GSL_MIN(part, fabs(dx[k]) > 1 ? 1 / fabs(dx[k]) : 1);
    for (i = 0; i < HALVINGS; i++, part *= 0.5) {
        for (k = 0; k < 2; k++) {
            moved[k] = part * dx[k];
            at[k] = x[k] + moved[k];
        }
        if (!find_residuals(q, at, next) || size(next) > 2 * size(r))
            continue;
        for (k = 0; k < 2; k++) {
            change[k] = next[k] - r[k];
            x[k] = at[k];
            r[k] = next[k];
        }
        update(B, moved, change);
        return 1;
    }
    return 0;
}

/* Iterate from x until the residuals are close to 0, or as close as rounding allows. */
static int broyden(const problem *q, double *x, double B[2][2], double close, double rounded)
{
    double r[2], dx[2], last;
    int i, is_there = 0;

    for (i = 0; i < HALVINGS && !(is_there = find_residuals(q, x, r)); i++)
        x[0] += 0.3;
    for (i = 0; is_there && i < STEPS && size(r) > close; i++) {
        last = size(r);
        if (!solve(B, r, dx) || !step(q, x, r, dx, B))
            break;
        if (last <= rounded && size(r) > 0.9 * last)
            break;
    }
    if (is_there && size(r) <= rounded)
        return 1;
    if (is_there)
        find_residuals(q, x, r);
    return 0;
}

/* 1 if this ends the search, not the motion. */
static int is_lost(int status)
{
    return status == FOURLINK_OK || status == FOURLINK_STALLS || status == FOURLINK_TOO_LONG ||
           status == FOURLINK_OVERFLOW;
}

/* The change of ln v that gives E0 = g(E0), by Newton's method:
**
**    dE0 / E0 = (g(E0) / E0 - 1) / (1 - g')
**
** If g' >= 1, a long step towards larger or smaller speeds. */
static double newton(double r, double growth)
{
    double relative = growth < 0 ? -gsl_expm1(r) / gsl_expm1(growth) : 0;

    if (growth < 0 && relative > -0.5)
        return GSL_MIN_DBL(0.5 * log(1 + relative), LONGEST_STEP);
    return r > 0 ? LONGEST_STEP : -LONGEST_STEP;
}

/* Solve for ln v of the stable motion that repeats.  A cycle from `low` gains energy, or the crank stalls;
** one from `high` loses energy.  In the end, steps are as small as rounding, or the corners of friction, make
** them.  The growth, 0 if unknown, is found again after each step that is not short. */
static int solve_speed(const problem *q, double *x, double *growth, double close, double rounded)
{
    double low = GSL_NEGINF, high = GSL_POSINF, r[2], dx, last = GSL_POSINF;
    int i, is_near = *growth < 0;

    for (i = 0; i < STEPS && q->p->budget > 0; i++, *x += dx) {
        if (!find_residuals(q, x, r)) {
            if (!is_lost(q->p->status))
                return 0;
            r[0] = GSL_POSINF;
            *growth = 0;
        } else if (!is_near && gsl_isnan(*growth = flk_path_growth(q->p))) {
            return 0;
        }
        dx = newton(r[0], *growth);
        if (*growth < 0 && (fabs(dx) <= close || (fabs(dx) <= rounded &&
                                                  (fabs(r[0]) <= close || fabs(dx) > 0.5 * last))))
            return 1;
        last = fabs(dx);
        if (r[0] > 0)
            low = *x;
        else
            high = *x;
        if (!(low < *x + dx && *x + dx < high))
            dx = 0.5 * (low + high) - *x;
        is_near = *growth < 0 && fabs(dx) < SHORT;
    }
    return 0;
}

/* Solve coarsely, then finely.  B starts as if torques did not depend on the speed, g' = 1. */
static int solve_problem(const problem *q, double *x)
{
    double tolerance = q->p->tolerance, B[2][2], growth = 0;
    int is_there;

    B[0][0] = 0;
    B[0][1] = 1;
    B[1][0] = -1;
    B[1][1] = -0.25;
    q->p->tolerance = COARSE;
    is_there = q->has_torque ? broyden(q, x, B, COARSE, 10 * COARSE)
                             : solve_speed(q, x, &growth, COARSE, 0.01);
    q->p->tolerance = tolerance;
    return is_there && (q->has_torque ? broyden(q, x, B, CLOSE, ROUNDED)
                                      : solve_speed(q, x, &growth, CLOSE, COARSE));
}

/* A quantity that increases with an unknown; -infinity if the crank stalls. */
typedef double rising(const problem *q, double *x);

/* The energy gained in a cycle, as a function of the torque. */
static double gain(const problem *q, double *x)
{
    double r[2];

    return find_residuals(q, x, r) ? r[0] : GSL_NEGINF;
}

/* 1 if the gain jumps over 0 at a torque at which the crank stalls: a torque adds its work to the energy of a
** cycle, and little more. */
static int is_jump(const problem *q, double range, double f_low, double f_high)
{
    return !gsl_finite(f_low) &&
           f_high * q->p->node[0].y[FLK_ENERGY] > 10 * q->torque_unit * q->cycle * range;
}

/* Find the zero in x[i]: by doubling steps, then between values of opposite signs, by bisection while the
** crank stalls at the lower value.  0 if there is none. */
static int find_zero(const problem *q, double *x, int i, rising *of, double close)
{
    double f = of(q, x), h = GSL_MIN(2 * fabs(f), 0.2);
    flk_bracket b = flk_bracket_of(x[i], x[i], GSL_POSINF, GSL_NEGINF);
    int k;

    for (k = 0; k < DOUBLINGS + STEPS && fabs(f) > close && q->p->budget > 0; k++) {
        flk_bracket_take(&b, x[i], f, 1);
        if (!(b.f_low < 0))
            x[i] = b.high - h;
        else if (!(b.f_high > 0))
            x[i] = b.low + h;
        else if (b.high - b.low <= NEAR * (1 + fabs(b.high)) ||
                 (of == gain && is_jump(q, b.high - b.low, b.f_low, b.f_high)))
            return gsl_finite(b.f_low);
        else
            x[i] = flk_bracket_next(&b);
        h *= 2;
        f = of(q, x);
    }
    return fabs(f) <= close;
}

/* The excess mean speed of the motion that repeats, as a function of the speed at the first row. */
static double speed_excess(const problem *q, double *x)
{
    return find_zero(q, x, 1, gain, NEAR) ? -log(q->mean_speed * flk_path_end(q->p)->t / q->cycle)
                                          : GSL_NEGINF;
}

/* Solve for both unknowns, coarsely by brackets, then by Broyden's method, which starts with differences. */
static int solve_in_brackets(const problem *q, double *x)
{
    double tolerance = q->p->tolerance, B[2][2], r[2], next[2], at[2];
    int i, j, is_there;

    q->p->tolerance = COARSE;
    is_there = find_zero(q, x, 0, speed_excess, COARSE);
    q->p->tolerance = tolerance;
    for (j = 0; j < 2 && is_there; j++) {
        double h = DIFFERENCE * (1 + fabs(x[j]));

        at[0] = x[0];
        at[1] = x[1];
        at[j] += h;
        is_there = find_residuals(q, x, r) && find_residuals(q, at, next);
        for (i = 0; i < 2 && is_there; i++)
            B[i][j] = (next[i] - r[i]) / h;
    }
    return is_there && broyden(q, x, B, CLOSE, ROUNDED);
}

int flk_steady_find(flk_path *p, double cycle, double mean_speed)
{
    int balances = p->equation.machine.motor.kind == FOURLINK_MOTOR_BALANCE;
    double x[2], start[2], speed, mean = 0;
    flk_machine_place place;
    problem q;

    q.p = p;
    q.cycle = cycle;
    q.mean_speed = balances ? mean_speed : 0;
    q.has_torque = balances;
    p->n = 0;
    p->equation.machine.motor.torque = balances ? 0 : p->equation.machine.motor.torque;
    p->status = flk_machine_at(&p->equation.machine, p->equation.branch, p->equation.from, &place);
    if (p->status != FOURLINK_OK)
        return 0;
    speed = balances ? mean_speed : guess_speed(p, cycle);
    p->status = FOURLINK_NO_STEADY;
    if (!(speed > 0) || (balances && !mean_torque(p, cycle, speed, &mean)))
        return 0;
    q.torque_unit = 0.5 * place.total * speed * speed / cycle;
    start[0] = x[0] = log(speed);
    start[1] = x[1] = -mean / q.torque_unit;
    p->is_steady =
        solve_problem(&q, x) || (balances && is_lost(p->status) && solve_in_brackets(&q, start));
    if (p->is_steady)
        return 1;
    if (p->budget == 0)
        p->status = FOURLINK_TOO_LONG;
    else if (p->status == FOURLINK_OK || p->status == FOURLINK_STALLS ||
             (balances && is_lost(p->status)))
        p->status = FOURLINK_NO_STEADY;
    return 0;
}
