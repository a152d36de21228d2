/* SPDX-License-Identifier: GPL-3.0-or-later
**
** quick_return.c - mechanisms whose output returns faster than it goes, at constant crank speed.
**
** With the time ratio Q >= 1 of the slow stroke to the quick one, the crank turns by 180 deg + alpha and
** 180 deg - alpha:
**
**    alpha = 180 deg (Q - 1) / (Q + 1)
**
** E. Soylemez, Mechanisms (METU), 7.1.4 "The Classical Transmission Angle Problem", 7.2 "Slider Crank
** Mechanisms"; R. P. Podhorodeski, S. B. Nokleby, J. D. Wittchen, "Quick-return mechanism design and analysis
** projects", Int. J. Mech. Eng. Educ. 32/2.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "synthesis.h"

/* The search for the best crank / coupler: from, and a factor for each step. */
#define SMALLEST_CRANK 1e-3
#define FACTOR 1.02
#define TRIALS 348 /* up to almost 1 */

/* rad, 1: the limits found agree with the wanted ones. */
#define AGREED 1e-6

typedef struct quick_return {
    const fourlink_quick_return_task *task;
    double alpha; /* rad; negative if the slow stroke is against the crank */
    double length[5], offset;
} quick_return;

static double square(double x)
{
    return x * x;
}

static int n_given(const quick_return *q)
{
    int i, n = 0;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        n += q->length[i] > 0;
    return n;
}

/* Crank-rocker with the swing psi.  In the limits C1, C2 of the rocker, AC = b + a and b - a; the triangles
** A C1 C2, with alpha at A, and A D C give
**
**    a^2 cos^2(alpha / 2) + b^2 sin^2(alpha / 2) = c^2 sin^2(psi / 2)
**    a^2 cos^2((psi - alpha) / 2) + b^2 sin^2((psi - alpha) / 2) = d^2 sin^2(psi / 2)
**
** Both are linear in the squares: two lengths give the others.  Each row is that of d^2, a^2, b^2, c^2.
*/
static void rows_of_rocker(const quick_return *q, double row[2][5])
{
    double alpha = 0.5 * q->alpha, psi = 0.5 * q->task->swing;

    memset(row, 0, 2 * sizeof row[0]);
    row[0][FOURLINK_CRANK] = square(cos(alpha));
    row[0][FOURLINK_COUPLER] = square(sin(alpha));
    row[0][FOURLINK_FOLLOWER] = -square(sin(psi));
    row[1][FOURLINK_CRANK] = square(cos(psi - alpha));
    row[1][FOURLINK_COUPLER] = square(sin(psi - alpha));
    row[1][FOURLINK_GROUND] = -square(sin(psi));
}

static int rocker_of_two(quick_return *q)
{
    double row[2][5], right[2] = {0, 0}, found[2], size = 0, determinant;
    int unknown[2], n = 0, i, j;

    rows_of_rocker(q, row);
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        if (q->length[i] > 0)
            for (j = 0; j < 2; j++)
                right[j] -= row[j][i] * square(q->length[i]);
        else
            unknown[n++] = i;
        size = GSL_MAX_DBL(size, square(q->length[i]));
    }
    determinant = row[0][unknown[0]] * row[1][unknown[1]] - row[0][unknown[1]] * row[1][unknown[0]];
    if (!(fabs(determinant) > FLK_NOTHING))
        return FOURLINK_DEPENDENT;
    found[0] = (right[0] * row[1][unknown[1]] - right[1] * row[0][unknown[1]]) / determinant;
    found[1] = (row[0][unknown[0]] * right[1] - row[1][unknown[0]] * right[0]) / determinant;
    for (i = 0; i < 2; i++) {
        if (!(found[i] > FLK_NOTHING * size))
            return FOURLINK_NO_LINKAGE;
        q->length[unknown[i]] = sqrt(found[i]);
    }
    return FOURLINK_OK;
}

/* The crank-rocker with c = 1 and a given crank / coupler: both equations then give squares above 0. */
static void rocker_of_ratio(quick_return *q, double ratio)
{
    double row[2][5];

    rows_of_rocker(q, row);
    q->length[FOURLINK_FOLLOWER] = 1;
    q->length[FOURLINK_COUPLER] =
        sqrt(-row[0][FOURLINK_FOLLOWER] /
             (row[0][FOURLINK_CRANK] * ratio * ratio + row[0][FOURLINK_COUPLER]));
    q->length[FOURLINK_CRANK] = ratio * q->length[FOURLINK_COUPLER];
    q->length[FOURLINK_GROUND] =
        q->length[FOURLINK_COUPLER] *
        sqrt((row[1][FOURLINK_CRANK] * ratio * ratio + row[1][FOURLINK_COUPLER]) /
             -row[1][FOURLINK_GROUND]);
}

/* Slider-crank with the stroke s.  In its dead centres AC = l + r and l - r, with alpha between:
**
**    r^2 cos^2(alpha / 2) + l^2 sin^2(alpha / 2) = s^2 / 4,   e = (l^2 - r^2) sin(alpha) / s
**
** e > 0: the piston goes out quickly, for a crank that turns counter-clockwise.
*/
static void set_offset(quick_return *q)
{
    double r = q->length[FOURLINK_CRANK], l = q->length[FOURLINK_COUPLER];

    q->offset = (l - r) * (l + r) * sin(q->alpha) / q->task->stroke;
}

static void slider_of_ratio(quick_return *q, double ratio)
{
    double cosine = cos(0.5 * q->alpha), sine = sin(0.5 * q->alpha);

    q->length[FOURLINK_COUPLER] =
        0.5 * q->task->stroke / sqrt(square(ratio * cosine) + square(sine));
    q->length[FOURLINK_CRANK] = ratio * q->length[FOURLINK_COUPLER];
    set_offset(q);
}

/* One of r, l, e is given; for e, with D = l^2 - r^2 = e s / sin(alpha):
**
**    r^2 = s^2 / 4 - D sin^2(alpha / 2)
*/
static int slider_of_one(quick_return *q)
{
    double *r = &q->length[FOURLINK_CRANK], *l = &q->length[FOURLINK_COUPLER], e = fabs(q->offset);
    double cosine2 = square(cos(0.5 * q->alpha)), sine2 = square(sin(0.5 * q->alpha));
    double s = q->task->stroke, found;

    if (*l == 0 && !(fabs(sin(q->alpha)) > FLK_NOTHING))
        return FOURLINK_DEPENDENT;
    if (*r > 0)
        found = (0.25 * s * s - *r * *r * cosine2) / sine2;
    else if (*l > 0)
        found = (0.25 * s * s - *l * *l * sine2) / cosine2;
    else
        found = 0.25 * s * s - e * s / fabs(sin(q->alpha)) * sine2;
    if (!(found > FLK_NOTHING * s * s))
        return FOURLINK_NO_LINKAGE;
    if (*r > 0) {
        *l = sqrt(found);
    } else {
        *r = sqrt(found);
        if (*l == 0)
            *l = sqrt(found + e * s / fabs(sin(q->alpha)));
    }
    set_offset(q);
    return FOURLINK_OK;
}

/* Slotted lever: the crank is at right angles to the slide in both limits, and the swing is alpha.  With the
** slide at the distance h from D,
**
**    asin((a + h) / d) + asin((a - h) / d) = alpha;   h = 0: a = d sin(alpha / 2)
*/
static double swing_of_lever(double crank, void *data)
{
    const quick_return *q = data;
    double h = q->offset / q->length[FOURLINK_GROUND];

    return asin(GSL_MIN_DBL(1, crank + h)) + asin(GSL_MAX_DBL(-1, crank - h)) - q->alpha;
}

static int slotted_lever(quick_return *q)
{
    double *d = &q->length[FOURLINK_GROUND], *a = &q->length[FOURLINK_CRANK], h = fabs(q->offset);
    double sine = sin(0.5 * q->alpha), most, least;
    flk_bracket b;

    if (!(sine > FLK_NOTHING))
        return FOURLINK_NO_LENGTH;
    q->offset = h;
    if (h == 0) {
        if (*d > 0)
            *a = *d * sine;
        else
            *d = *a / sine;
    } else if (*d == 0) {
        return FOURLINK_BAD_CHOICE;
    } else {
        most = 1 - h / *d;
        if (!(most > 0) || !(swing_of_lever(most, q) > 0))
            return FOURLINK_NO_FULL_TURN;
        least = swing_of_lever(0, q);
        b = flk_bracket_of(0, most, least, swing_of_lever(most, q));
        *a = *d * flk_find_zero(swing_of_lever, q, &b, 0);
    }
    if (q->task->stroke > 0)
        q->length[FOURLINK_FOLLOWER] = 0.5 * q->task->stroke / sine;
    q->offset = q->task->offset;
    return FOURLINK_OK;
}

/* Whitworth: the tool reverses where the lever is at right angles to AD, and the quick stroke takes
**
**    sigma = 360 deg / (Q + 1) of the crank,   cos(sigma / 2) = d / a
*/
static int whitworth(quick_return *q)
{
    double *d = &q->length[FOURLINK_GROUND], *a = &q->length[FOURLINK_CRANK];
    double ratio = sin(0.5 * q->alpha);

    if (!(ratio > FLK_NOTHING))
        return FOURLINK_NO_LENGTH;
    if (*d > 0)
        *a = *d / ratio;
    else
        *d = *a * ratio;
    return FOURLINK_OK;
}

static fourlink_kind kind_of(const fourlink_quick_return_task *task)
{
    return task->type == FOURLINK_CRANK_ROCKER ? FOURLINK_FOUR_BAR
           : task->type == FOURLINK_ENGINE     ? FOURLINK_SLIDER_CRANK
                                               : FOURLINK_INVERTED_SLIDER_CRANK;
}

/* Set the crank angles and outputs at the limits of the output, on the open branch.  Whitworth's lever has none: its
** tool reverses where the lever is at right angles to AD. */
static void set_positions(const fourlink_mechanism *mechanism, const fourlink_limits *limits,
                          fourlink_precision p[2])
{
    if (limits->has_stroke) {
        fourlink_state state;

        p[0].theta2 = limits->inner;
        p[1].theta2 = limits->outer;
        if (fourlink_position(mechanism, FOURLINK_OPEN, limits->inner, &state) == FOURLINK_OK)
            p[0].output = state.link[4].origin.x;
        p[1].output = p[0].output - limits->stroke;
    } else if (limits->has_swing) {
        p[0].theta2 = limits->theta2_min;
        p[1].theta2 = limits->theta2_max;
        p[0].output = limits->theta4_min;
        p[1].output = limits->theta4_max;
    } else {
        p[0].theta2 = M_PI / (limits->time_ratio + 1);
        p[1].theta2 = 2 * M_PI - p[0].theta2;
        p[0].output = M_PI_2;
        p[1].output = -M_PI_2;
    }
    if (p[1].theta2 < p[0].theta2)
        p[1].theta2 += 2 * M_PI;
}

/* The mechanism of the lengths found, and its limits.  FOURLINK_NO_FULL_TURN if it is of another type or moves
** otherwise: the equations hold also where C1 or C2 can only be reached on the other branch. */
static int prepare(const quick_return *q, fourlink_solution *s, fourlink_limits *limits)
{
    const fourlink_quick_return_task *task = q->task;
    int i, is_piston = task->type == FOURLINK_ENGINE;
    double unit = is_piston ? task->stroke : 1, extent;
    fourlink_precision *p = s->position;
    fourlink_mechanism mechanism;

    s->design.kind = kind_of(task);
    s->design.offset = q->offset;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        s->design.link[i].length = q->length[i];
    if (fourlink_prepare(&s->design, &mechanism) != FOURLINK_OK)
        return FOURLINK_INFINITE_LINK;
    fourlink_type_of(&mechanism, &s->type);
    if (s->type != task->type)
        return FOURLINK_NO_FULL_TURN;
    fourlink_limits_of(&mechanism, FOURLINK_OPEN, limits);
    set_positions(&mechanism, limits, p);
    extent = is_piston                              ? -task->stroke
             : task->type == FOURLINK_CRANK_ROCKER  ? task->swing
             : task->type == FOURLINK_SLOTTED_LEVER ? q->alpha
                                                    : -M_PI;
    if (!(fabs(p[1].theta2 - p[0].theta2 - M_PI - q->alpha) < AGREED) ||
        !(fabs(p[1].output - p[0].output - extent) < AGREED * unit))
        return FOURLINK_NO_FULL_TURN;
    p[1].output = p[0].output + extent;
    for (i = 0; i < 2 && !is_piston; i++)
        p[i].output = flk_reduced(p[i].output);
    return FOURLINK_OK;
}

/* The smallest transmission angle for crank / coupler = e^x; below 0 if the crank does not turn fully. */
static double transmission_of(double x, void *data)
{
    quick_return q = *(const quick_return *)data;
    fourlink_limits limits;
    fourlink_solution s;

    if (q.task->type == FOURLINK_CRANK_ROCKER)
        rocker_of_ratio(&q, exp(x));
    else
        slider_of_ratio(&q, exp(x));
    memset(&s.design, 0, sizeof s.design);
    return prepare(&q, &s, &limits) == FOURLINK_OK ? limits.mu_min : -1;
}

/* The largest of these: the best of many, then the peak beside it.  If one length of the crank-rocker is given,
** all are scaled to it. */
static int find_best(quick_return *q)
{
    double best = 0, given = 0, factor;
    flk_sample p[3];
    int i, at = -1, which = 0;

    for (i = 0; i < TRIALS; i++) {
        double value = transmission_of(log(SMALLEST_CRANK) + i * log(FACTOR), q);

        if (value > best) {
            best = value;
            at = i;
        }
    }
    if (at < 0)
        return FOURLINK_NO_FULL_TURN;
    if (at == 0)
        return FOURLINK_INFINITE_LINK;
    for (i = 0; i < 3; i++) {
        p[i].x = log(SMALLEST_CRANK) + (at + i - 1) * log(FACTOR);
        p[i].value = transmission_of(p[i].x, q);
    }
    p[1] = flk_find_peak(transmission_of, q, p, 1e-16);
    if (q->task->type == FOURLINK_ENGINE) {
        slider_of_ratio(q, exp(p[1].x));
        return FOURLINK_OK;
    }
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (q->length[i] > 0) {
            given = q->length[i];
            which = i;
        }
    rocker_of_ratio(q, exp(p[1].x));
    factor = given / q->length[which];
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        q->length[i] *= factor;
    return FOURLINK_OK;
}

/* What each type needs, from what is given. */
static int find_lengths(quick_return *q)
{
    const fourlink_quick_return_task *task = q->task;
    int n = n_given(q), n_base = (q->length[FOURLINK_GROUND] > 0) + (q->length[FOURLINK_CRANK] > 0);

    switch (task->type) {
    case FOURLINK_CRANK_ROCKER:
        if (!(task->swing > 0 && task->swing < M_PI))
            return FOURLINK_BAD_NUMBER;
        if (n < 1 || n > 2 || q->offset != 0 || task->stroke != 0)
            return FOURLINK_BAD_CHOICE;
        return n == 1 ? find_best(q) : rocker_of_two(q);
    case FOURLINK_ENGINE:
        n += q->offset != 0;
        if (task->stroke < FOURLINK_LENGTH_MIN)
            return FOURLINK_BAD_LENGTH;
        if (n > 1 || q->length[FOURLINK_GROUND] > 0 || q->length[FOURLINK_FOLLOWER] > 0 ||
            task->swing != 0)
            return FOURLINK_BAD_CHOICE;
        return n == 0 ? find_best(q) : slider_of_one(q);
    default:
        if (n_base != 1 || q->length[FOURLINK_COUPLER] > 0 ||
            (task->stroke > 0 && q->length[FOURLINK_FOLLOWER] > 0))
            return FOURLINK_BAD_CHOICE;
        if (task->type == FOURLINK_SLOTTED_LEVER)
            return slotted_lever(q);
        return q->offset != 0 || task->stroke != 0 || task->swing != 0 ? FOURLINK_BAD_CHOICE
                                                                       : whitworth(q);
    }
}

static int check_task(const fourlink_quick_return_task *task)
{
    int i, is_lever = task->type == FOURLINK_SLOTTED_LEVER || task->type == FOURLINK_WHITWORTH;

    if (!is_lever && task->type != FOURLINK_CRANK_ROCKER && task->type != FOURLINK_ENGINE)
        return FOURLINK_BAD_KIND;
    if (!FLK_WITHIN(task->time_ratio, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(task->swing, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(task->stroke, FOURLINK_LENGTH_MAX) ||
        !FLK_WITHIN(task->offset, FOURLINK_LENGTH_MAX))
        return FOURLINK_BAD_NUMBER;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (!FLK_WITHIN(task->length[i], FOURLINK_LENGTH_MAX))
            return FOURLINK_BAD_NUMBER;
        else if (task->length[i] < 0)
            return FOURLINK_BAD_LENGTH;
    if (task->stroke < 0)
        return FOURLINK_BAD_LENGTH;
    if (task->type == FOURLINK_SLOTTED_LEVER && task->time_ratio == 0) {
        if (!(task->swing > 0 && task->swing < M_PI))
            return FOURLINK_BAD_NUMBER;
    } else if (task->time_ratio < 1) {
        return FOURLINK_BAD_TIME_RATIO;
    } else if (task->type == FOURLINK_SLOTTED_LEVER && task->swing != 0) {
        return FOURLINK_BAD_CHOICE;
    }
    if (task->slow != 0 && task->slow != FOURLINK_SLOW_WITH &&
        (is_lever || task->slow != FOURLINK_SLOW_AGAINST))
        return FOURLINK_BAD_CHOICE;
    return FOURLINK_OK;
}

int fourlink_synthesis_quick_return(const fourlink_quick_return_task *task, unsigned long max,
                                    fourlink_solution *solutions, unsigned long *n)
{
    flk_request request = {0, 0, 1, 0};
    fourlink_limits limits;
    fourlink_solution s;
    quick_return q;
    int status;

    if (!task || !n || (max && !solutions))
        return FOURLINK_NULL;
    status = check_task(task);
    if (status != FOURLINK_OK)
        return status;
    q.task = task;
    q.offset = task->offset;
    q.alpha =
        task->time_ratio > 0 ? M_PI * (task->time_ratio - 1) / (task->time_ratio + 1) : task->swing;
    if (task->slow == FOURLINK_SLOW_AGAINST)
        q.alpha = -q.alpha;
    memcpy(q.length, task->length, sizeof q.length);
    memset(&s, 0, sizeof s);
    status = find_lengths(&q);
    if (status == FOURLINK_OK)
        status = prepare(&q, &s, &limits);
    if (status != FOURLINK_OK)
        return status;
    s.condition = 1;
    s.a = q.length[FOURLINK_CRANK];
    s.c = q.length[FOURLINK_FOLLOWER];
    s.n_positions = 2;
    s.from = s.position[0].theta2;
    s.to = s.from + 2 * M_PI;
    status = flk_check_solution(&s, &request);
    return status == FOURLINK_OK ? flk_return_solution(&s, max, solutions, n) : status;
}
