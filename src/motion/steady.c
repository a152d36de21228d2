/* SPDX-License-Identifier: GPL-3.0-or-later
**
** steady.c - the motion that repeats after a cycle, and facts of a motion.
**
** From the energy E0 at the first row the crank reaches the energy g(E0) after a cycle, in the time t.  The
** unknowns are the speed v at the first row and, for a motor that balances the loads, its torque T:
**
**    g(E0) - E0 = 0                                for any motor, for v
**    g(E0) - E0 = 0,   mean_speed t - cycle = 0    for a motor that balances, for v and T
**
** The first is solved between speeds at which the machine gains and loses energy in a cycle.  It starts
** from the lowest speed above which the mean torque of a cycle at constant speed is negative: a run-up ends
** there, because below it the machine gains speed.  The motion is stable if g' < 1; the speed is known if
** g' is not 1 but for rounding error.
**
** For the second, two solutions E(theta) of dE/dtheta = T + Q with different T cross in one sense only, and
** with the same T not at all.  So the energy after a cycle grows with T, there is at most one T for each v,
** and motions with larger v are faster at every angle: T is found for each v, and then v.
**
** A first solution is found with coarse steps.  Facts:
**
**    mean speed    cycle / period, the mean over time, as a tachometer shows it
**    textbooks'    (largest + smallest) / 2
**    fluctuation   (largest - smallest) / mean speed
**    rate          exp(integral of d(T_m + Q)/d(omega2) / ((J + I_f) omega2) dtheta2 over a cycle)
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "steady.h"
#include "base/solve.h"
#include "mechanics/mechanics.h"

#define DIFFERENCE 1e-5 /* of the speed, for a derivative */
#define PLACES 18
#define PLACES_OF_ENERGY 180
#define SLOWEST 1e-3 /* of the speed that the torque at rest gives in a radian */
#define SPEEDS 60    /* that are tried */
#define FACTOR 1.4
#define LONGEST_STEP_OF_FLYWHEEL 2.8
#define NO_FLYWHEEL 28   /* -ln(kg m2) */
#define SLOPE 1.0        /* of each function, at first */
#define LONGEST_STEP 0.3 /* of ln v, without a better step */
#define COARSE 1e-6      /* tolerance of the steps of first solutions, and their error */
#define CLOSE 1e-12      /* of the energy, the cycle: solved */
#define ROUNDED 1e-9     /* ... without getting closer: friction corners, last digits */
/* The least part of a difference that a cycle takes away: the speed is known to ROUNDED / HOLDS, mostly
** to a tenth of that. */
#define HOLDS 1e-6

/* ------------------------------------------------------------------------------------------------ facts */

void flk_facts_forget(flk_actual_facts *f)
{
    f->status = f->no_cycle = FOURLINK_OK;
    f->end_angle = f->mean_speed = f->mean_speed_textbook = f->period = f->fluctuation_exact =
        f->steady_rate = f->stall_angle = f->run_up_time = f->motor_torque = f->flywheel =
            f->inertia = FLK_UNDEFINED;
}

static void widen(const flk_node *node, double part, double *least, double *most)
{
    flk_node at;

    flk_node_within(node, part, &at);
    *least = GSL_MIN(*least, at.y[FLK_SPEED]);
    *most = GSL_MAX(*most, at.y[FLK_SPEED]);
}

/* The smallest and the largest speed from a time to the end.  Within a step there may be two peaks, so its
** halves are searched. */
static void find_range(const flk_path *p, double t, double *least, double *most)
{
    const flk_node *node, *end = flk_path_end(p);

    *least = GSL_POSINF;
    *most = 0;
    for (node = p->node; node < end; node++)
        if (node[1].t > t) {
            double from = GSL_MAX(0, (t - node->t) / node->h), to = (node[1].t - node->t) / node->h;
            double middle = 0.5 * (from + to);

            widen(node, from, least, most);
            widen(node, flk_node_peak(node, from, middle), least, most);
            widen(node, flk_node_peak(node, middle, to), least, most);
            widen(node, to, least, most);
        }
}

/* A step and its path. */
typedef struct span {
    const flk_path *p;
    const flk_node *node;
} span;

/* d(T_m + Q)/d(omega2) / (J + I_f) at a time, by a difference within the cell; NaN if a torque is not
** known. */
static double growth_at(double t, void *data)
{
    const span *x = data;
    const flk_equation *e = &x->p->equation;
    flk_machine_torque slower, faster;
    flk_machine_place place;
    fourlink_state held;
    double speed, theta2, growth = GSL_NAN;
    flk_node at;

    flk_node_within(x->node, (t - x->node->t) / x->node->h, &at);
    theta2 = flk_equation_theta2(e, at.y[FLK_PASSED]);
    speed = at.y[FLK_SPEED];
    if (flk_machine_at(&e->machine, e->branch, theta2, &place) != FOURLINK_OK)
        return GSL_NAN;
    FLK_COPY_STATE(&e->machine.mechanism, &held, &place.state);
    fourlink_velocity(&e->machine.mechanism, e->sense, &held);
    e->acting->held = &held;
    e->acting->held_speed = e->sense * speed;
    if (flk_equation_torque(e, &place, speed * (1 - DIFFERENCE), &slower) == FOURLINK_OK &&
        flk_equation_torque(e, &place, speed * (1 + DIFFERENCE), &faster) == FOURLINK_OK)
        growth = (faster.net - slower.net) / (2 * DIFFERENCE * speed) / place.total;
    e->acting->held = NULL;
    return growth;
}

/* The growth over the path of the logarithm of a small difference in energy:
** integral of d(T_m + Q)/d(omega2) / (J + I_f) dt; NaN if a torque is not known. */
static double growth_of(const flk_path *p)
{
    double growth = 0;
    span x;

    x.p = p;
    for (x.node = p->node; x.node + 1 < p->node + p->n; x.node++)
        growth += flk_integrate_smooth(growth_at, &x, x.node->t, x.node[1].t);
    return growth;
}

void flk_facts_of_cycle(const flk_path *p, double cycle, flk_actual_facts *f)
{
    const flk_node *end = flk_path_end(p);
    double from = GSL_MAX(0, end->y[FLK_PASSED] - cycle), least, most;
    flk_node first;

    if (!(end->y[FLK_PASSED] > 0) || flk_path_node_at(p, from, &first) != FOURLINK_OK)
        return;
    find_range(p, first.t, &least, &most);
    f->period = end->t - first.t;
    f->mean_speed = p->equation.sense * (end->y[FLK_PASSED] - from) / f->period;
    f->mean_speed_textbook = p->equation.sense * 0.5 * (least + most);
    f->fluctuation_exact = (most - least) / fabs(f->mean_speed);
    if (p->is_steady)
        f->steady_rate = exp(growth_of(p));
}

void flk_facts_of_run_up(const flk_path *p, flk_actual_facts *f)
{
    double speed = p->equation.sense * f->mean_speed;
    const flk_node *node;
    flk_node at;

    for (node = p->node; node < flk_path_end(p); node++)
        if (node[1].y[FLK_SPEED] >= speed) {
            double most = (node[1].t - node->t) / node->h;

            flk_node_within(node, flk_node_part(node, FLK_SPEED, speed, most), &at);
            f->run_up_time = at.t;
            return;
        }
}

/* ------------------------------------------------------------------------------------------- the search */

typedef struct problem {
    flk_path *p;
    double cycle, mean_speed, fluctuation;
    int balances;                       /* 1: T is unknown too */
    double torque_unit;                 /* N m */
    flk_rising speed, torque, flywheel; /* of ln v; of T in that unit; of -ln I */
    int is_solved;                      /* 1: with the last flywheel; 0: start from the guesses */
    flk_rising speed_guess, torque_guess;
    double close, rounded;
} problem;

/* The torques at a constant speed after an angle, rad. */
static int find_torque(const flk_path *p, double passed, double speed, flk_machine_place *place,
                       flk_machine_torque *torque)
{
    const flk_equation *e = &p->equation;
    int status = flk_machine_at(&e->machine, e->branch, flk_equation_theta2(e, passed), place);

    return status == FOURLINK_OK ? flk_equation_torque(e, place, speed, torque) : status;
}

/* The mean torque of a cycle at a constant speed, in the sense of the motion, N m; 0 if there is no
** position. */
static int mean_torque(const flk_path *p, double cycle, double speed, double *mean)
{
    flk_machine_place place;
    flk_machine_torque torque;
    int i;

    *mean = 0;
    for (i = 0; i < PLACES; i++) {
        if (find_torque(p, cycle * ((double)i + 0.381) / PLACES, speed, &place, &torque) !=
            FOURLINK_OK)
            return 0;
        *mean += torque.net / PLACES;
    }
    return 1;
}

/* The speed at which the mean torque turns negative; 0: there is none. */
static double guess_speed(const flk_path *p, double cycle)
{
    double mean, last = 0, speed;
    flk_machine_place place;
    int i;

    if (flk_machine_at(&p->equation.machine, p->equation.branch, p->equation.from, &place) !=
            FOURLINK_OK ||
        !mean_torque(p, cycle, 0, &mean))
        return 0;
    speed = SLOWEST * sqrt(fabs(mean) / place.total);
    for (i = 0; i < SPEEDS && mean_torque(p, cycle, speed, &mean); i++, speed *= FACTOR) {
        if (last > 0 && mean <= 0)
            return speed / FACTOR * pow(FACTOR, last / (last - mean));
        last = mean;
    }
    return 0;
}

/* A guess of the flywheel, kg m2: the textbooks', for a crank at a constant speed,
**
**    I = (max E - min E) / (fluctuation omega2^2),   dE/dtheta2 = T_m + Q - mean - J' omega2^2 / 2
**
** and half as much again, since with too small a flywheel a machine may stall.  1 if that is not known. */
static double guess_flywheel(const flk_path *p, double cycle, double speed, double mean,
                             double fluctuation)
{
    double energy = 0, least = 0, greatest = 0, step = cycle / PLACES_OF_ENERGY;
    flk_machine_place place;
    flk_machine_torque torque;
    int i;

    for (i = 0; i < PLACES_OF_ENERGY; i++) {
        if (find_torque(p, step * (i + 0.5), speed, &place, &torque) != FOURLINK_OK)
            return 1;
        energy += step * (torque.net - mean - place.half_slope * speed * speed);
        least = GSL_MIN(least, energy);
        greatest = GSL_MAX(greatest, energy);
    }
    return greatest > least ? 1.5 * (greatest - least) / (fluctuation * speed * speed) : 1;
}

/* 1 if the path shows no more than that these guesses are wrong. */
static int is_lost(const flk_path *p)
{
    return p->status == FOURLINK_OK || p->status == FOURLINK_STALLS ||
           p->status == FOURLINK_TOO_LONG || p->status == FOURLINK_OVERFLOW;
}

/* ln(g(E0) / E0); -infinity if the crank stalls, NaN if the search has failed. */
static double gain(problem *q)
{
    flk_path *p = q->p;

    if (p->budget == 0)
        return GSL_NAN;
    if (!flk_path_run(p, exp(q->speed.x), q->cycle))
        return is_lost(p) ? GSL_NEGINF : GSL_NAN;
    return log(flk_path_end(p)->y[FLK_ENERGY] / p->node[0].y[FLK_ENERGY]);
}

static double gain_of_torque(double x, void *data)
{
    problem *q = data;
    const flk_equation *e = &q->p->equation;

    q->p->equation.machine.motor.torque = e->sense * x * q->torque_unit / e->machine.motor.ratio;
    return gain(q);
}

/* What must vanish, as a function of ln v: the loss of a cycle; for a motor that balances, the excess mean
** speed of the cycle with its torque. */
static double excess(double x, void *data)
{
    problem *q = data;

    (void)x;
    if (!q->balances) {
        double gained = gain(q);

        return gsl_isinf(gained) ? GSL_NEGINF : -gained;
    }
    if (flk_find_rising(gain_of_torque, q, &q->torque, q->close, q->rounded))
        return -log(q->mean_speed * flk_path_end(q->p)->t / q->cycle);
    return is_lost(q->p) ? GSL_NEGINF : GSL_NAN;
}

/* ln(fluctuation / the required one), as a function of -ln(flywheel / 1 kg m2); infinite if there is no
** steady motion, 0 if no flywheel is needed. */
static double excess_fluctuation(double x, void *data)
{
    problem *q = data;
    flk_actual_facts f;
    double value;

    flk_facts_forget(&f);
    q->p->equation.machine.flywheel = x < NO_FLYWHEEL ? exp(-x) : 0;
    if (!q->is_solved) {
        q->speed = q->speed_guess;
        q->torque = q->torque_guess;
    }
    q->is_solved = flk_find_rising(excess, q, &q->speed, q->close, q->rounded);
    if (!q->is_solved)
        return q->p->budget > 0 && is_lost(q->p) ? GSL_POSINF : GSL_NAN;
    flk_facts_of_cycle(q->p, q->cycle, &f);
    value = log(f.fluctuation_exact / q->fluctuation);
    return x >= NO_FLYWHEEL && value < 0 ? 0 : value;
}

/* Solve coarsely, then finely. */
static int solve(problem *q, double tolerance, double close, double rounded)
{
    q->p->tolerance = tolerance;
    q->close = close;
    q->rounded = rounded;
    return q->fluctuation > 0
               ? flk_find_rising(excess_fluctuation, q, &q->flywheel, 10 * close, rounded)
               : flk_find_rising(excess, q, &q->speed, q->close, q->rounded);
}

/* 1 if a cycle takes differences of the speed away.  Where it takes less than rounding error makes,
** nothing holds the speed: without losses a motor of constant power is as good as none at a speed of
** thousands of rad/s. */
static int holds(const problem *q)
{
    double growth = growth_of(q->p); /* NaN: not known */

    return (q->speed.slope != SLOPE || growth < 0) && !(growth > -HOLDS);
}

int flk_steady_find(flk_path *p, double cycle, double mean_speed, double fluctuation)
{
    const flk_rising guess = {0, SLOPE, LONGEST_STEP};
    double speed = mean_speed, mean = 0, tolerance = p->tolerance;
    flk_machine *machine = &p->equation.machine;
    flk_machine_place place;
    problem q;

    q.p = p;
    q.cycle = cycle;
    q.mean_speed = mean_speed;
    q.fluctuation = fluctuation;
    q.balances = machine->motor.kind == FOURLINK_MOTOR_BALANCE;
    q.is_solved = 0;
    q.speed = q.torque = q.flywheel = guess;
    q.flywheel.longest = LONGEST_STEP_OF_FLYWHEEL;
    machine->motor.torque = q.balances ? 0 : machine->motor.torque;
    machine->flywheel = fluctuation > 0 ? 1 : machine->flywheel;
    p->n = 0;
    p->is_steady = 0;
    p->status = flk_machine_at(machine, p->equation.branch, p->equation.from, &place);
    if (p->status != FOURLINK_OK)
        return 0;
    if (!q.balances)
        speed = guess_speed(p, cycle);
    p->status = FOURLINK_NO_STEADY;
    if (!(speed > 0) || (q.balances && !mean_torque(p, cycle, speed, &mean)))
        return 0;
    if (fluctuation > 0) {
        machine->flywheel = guess_flywheel(p, cycle, speed, mean, fluctuation);
        q.flywheel.x = -log(machine->flywheel);
        flk_machine_at(machine, p->equation.branch, p->equation.from, &place);
    }
    q.torque_unit = 0.5 * place.total * speed * speed / cycle;
    q.speed.x = log(speed);
    q.torque.x = -mean / q.torque_unit;
    q.speed_guess = q.speed;
    q.torque_guess = q.torque;
    solve(&q, COARSE, COARSE, 0.01);
    p->is_steady = solve(&q, tolerance, CLOSE, ROUNDED) && (q.balances || holds(&q));
    p->tolerance = tolerance;
    if (p->is_steady)
        return 1;
    if (p->budget == 0)
        p->status = FOURLINK_TOO_LONG;
    else if (is_lost(p))
        p->status = FOURLINK_NO_STEADY;
    return 0;
}
