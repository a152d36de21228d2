/* SPDX-License-Identifier: GPL-3.0-or-later
**
** quick_return.c - mechanisms whose output returns faster than it goes, at constant crank speed.
**
** With the time ratio Q >= 1 the crank turns by 180 deg + alpha and 180 deg - alpha in the two strokes:
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

#include "synthesis.h"

/* The search for the best crank / coupler, e^x / (1 + e^x): x from -FARTHEST to FARTHEST, 0.001 to 0.999. */
#define FARTHEST 7.0
#define TRIALS 560

/* rad, 1: the limits of the mechanism agree with the wanted ones. */
#define AGREED 1e-6

typedef struct quick_return {
    const fourlink_quick_return_task *task;
    double alpha; /* rad; negative if the slow stroke is against the crank */
    double length[5], offset;
} quick_return;

/* The root of a square that may be 0 or negative by the data: then 0. */
static double root(double square, double size)
{
    return square > FLK_NOTHING * size ? sqrt(square) : 0;
}

/* Crank-rocker with the swing psi.  In the limits C1, C2 of the rocker, AC = b + a and b - a.  The triangles
** A C1 C2, with alpha at A, and A D C give
**
**    a^2 cos^2(alpha / 2) + b^2 sin^2(alpha / 2) = c^2 sin^2(psi / 2)
**    a^2 cos^2((psi - alpha) / 2) + b^2 sin^2((psi - alpha) / 2) = d^2 sin^2(psi / 2)
**
** Both are linear in the squares: two lengths give the others, which are 0 before.
*/
static int find_rocker(quick_return *q)
{
    double alpha = 0.5 * q->alpha, psi = 0.5 * q->task->swing, right[2] = {0, 0}, size = 0;
    double row[2][5] = {{0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}, determinant;
    int unknown[2], n = 0, i, j;

    row[0][FOURLINK_CRANK] = gsl_pow_2(cos(alpha));
    row[0][FOURLINK_COUPLER] = gsl_pow_2(sin(alpha));
    row[0][FOURLINK_FOLLOWER] = -gsl_pow_2(sin(psi));
    row[1][FOURLINK_CRANK] = gsl_pow_2(cos(psi - alpha));
    row[1][FOURLINK_COUPLER] = gsl_pow_2(sin(psi - alpha));
    row[1][FOURLINK_GROUND] = -gsl_pow_2(sin(psi));
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        if (q->length[i] == 0)
            unknown[n++] = i;
        for (j = 0; j < 2; j++)
            right[j] -= row[j][i] * gsl_pow_2(q->length[i]);
        size = GSL_MAX_DBL(size, gsl_pow_2(q->length[i]));
    }
    i = unknown[0];
    j = unknown[1];
    determinant = row[0][i] * row[1][j] - row[0][j] * row[1][i];
    if (!(fabs(determinant) > FLK_NOTHING))
        return FOURLINK_DEPENDENT;
    q->length[i] = root((right[0] * row[1][j] - right[1] * row[0][j]) / determinant, size);
    q->length[j] = root((row[0][i] * right[1] - row[1][i] * right[0]) / determinant, size);
    return q->length[i] > 0 && q->length[j] > 0 ? FOURLINK_OK : FOURLINK_NO_LINKAGE;
}

/* Slider-crank with the stroke s.  In its dead centres AC = l + r and l - r, with alpha between:
**
**    r^2 cos^2(alpha / 2) + l^2 sin^2(alpha / 2) = s^2 / 4,   (l^2 - r^2) sin(alpha) = e s
**
** so that one of r, l, e gives the others.  e > 0: the piston goes out quickly, for a crank that turns
** counter-clockwise.
*/
static int find_slider(quick_return *q)
{
    double *r = &q->length[FOURLINK_CRANK], *l = &q->length[FOURLINK_COUPLER], s = q->task->stroke;
    double cosine2 = gsl_pow_2(cos(0.5 * q->alpha)), sine2 = gsl_pow_2(sin(0.5 * q->alpha));
    double quarter = 0.25 * s * s;

    if (sine2 == 0 && *l == 0)
        return FOURLINK_DEPENDENT;
    if (q->offset != 0)
        *r = root(quarter - 0.5 * s * fabs(q->offset * tan(0.5 * q->alpha)), quarter);
    if (*r > 0)
        *l = root((quarter - *r * *r * cosine2) / sine2, quarter);
    else
        *r = root((quarter - *l * *l * sine2) / cosine2, quarter);
    q->offset = q->offset != 0 ? GSL_SIGN(q->alpha) * fabs(q->offset)
                               : (*l - *r) * (*l + *r) * sin(q->alpha) / s;
    return *r > 0 && *l > 0 ? FOURLINK_OK : FOURLINK_NO_LINKAGE;
}

/* Slotted lever: the crank is at right angles to the slide in both limits, and the swing is alpha.  With the
** slide at the distance h from D, and sums of sines as products,
**
**    asin((a + h) / d) + asin((a - h) / d) = alpha
**    d^2 = (a / sin(alpha / 2))^2 + (h / cos(alpha / 2))^2
**
** A tool at the distance L on the lever has the stroke 2 L sin(alpha / 2).
**
** Whitworth: the tool reverses where the lever is at right angles to AD; the quick stroke takes
** sigma = 360 deg / (Q + 1) = 180 deg - alpha of the crank, and cos(sigma / 2) = d / a = sin(alpha / 2). */
static int find_lever(quick_return *q)
{
    int is_whitworth = q->task->type == FOURLINK_WHITWORTH;
    double *longer = &q->length[is_whitworth ? FOURLINK_CRANK : FOURLINK_GROUND];
    double *shorter = &q->length[is_whitworth ? FOURLINK_GROUND : FOURLINK_CRANK];
    double sine = sin(0.5 * q->alpha), h = q->offset / cos(0.5 * q->alpha);

    if (!(q->alpha > FLK_NOTHING))
        return FOURLINK_NO_LENGTH;
    if (*longer > 0)
        *shorter = sine * root((*longer - h) * (*longer + h), *longer * *longer);
    else
        *longer = gsl_hypot(*shorter / sine, h);
    if (q->task->stroke > 0)
        q->length[FOURLINK_FOLLOWER] = 0.5 * q->task->stroke / sine;
    return *shorter > 0 ? FOURLINK_OK : FOURLINK_NO_FULL_TURN;
}

/* The mechanism of the lengths found.  Its positions are the limits of the output, on the open branch.
** Whitworth's lever has none: its tool reverses where the lever is at right angles to AD.
** FOURLINK_NO_FULL_TURN if the mechanism is of another type or moves otherwise: the equations hold also where
** C1 or C2 is reached on the other branch only. */
static int prepare(const quick_return *q, fourlink_solution *s)
{
    fourlink_kind kind = q->task->type == FOURLINK_CRANK_ROCKER ? FOURLINK_FOUR_BAR
                         : q->task->type == FOURLINK_ENGINE     ? FOURLINK_SLIDER_CRANK
                                                                : FOURLINK_INVERTED_SLIDER_CRANK;
    double unit = kind == FOURLINK_SLIDER_CRANK ? q->task->stroke : 1;
    double extent = kind == FOURLINK_FOUR_BAR                 ? q->task->swing
                    : kind == FOURLINK_SLIDER_CRANK           ? -unit
                    : q->task->type == FOURLINK_SLOTTED_LEVER ? q->alpha
                                                              : M_PI;
    fourlink_precision *p = s->position;
    fourlink_mechanism mechanism;
    fourlink_state first, last;
    fourlink_limits limits;
    int i;

    s->design.kind = kind;
    s->design.offset = q->offset;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        s->design.link[i].length = q->length[i];
    if (fourlink_prepare(&s->design, &mechanism) != FOURLINK_OK)
        return FOURLINK_INFINITE_LINK;
    fourlink_type_of(&mechanism, &s->type);
    fourlink_limits_of(&mechanism, FOURLINK_OPEN, &limits);
    s->mu_min = limits.mu_min;
    p[0].theta2 = limits.stroke > 0  ? limits.inner
                  : limits.has_swing ? limits.theta2_min
                                     : M_PI / (limits.time_ratio + 1);
    p[1].theta2 = p[0].theta2 + M_PI + q->alpha;
    if (s->type != q->task->type ||
        fourlink_position(&mechanism, FOURLINK_OPEN, p[0].theta2, &first) != FOURLINK_OK ||
        fourlink_position(&mechanism, FOURLINK_OPEN, p[1].theta2, &last) != FOURLINK_OK)
        return FOURLINK_NO_FULL_TURN;
    p[0].output = flk_output_error(&first, kind, 0);
    p[1].output = p[0].output + extent;
    if (kind != FOURLINK_SLIDER_CRANK)
        p[1].output = flk_reduced(p[1].output);
    return fabs(flk_output_error(&last, kind, p[1].output)) < AGREED * unit ? FOURLINK_OK
                                                                            : FOURLINK_NO_FULL_TURN;
}

/* The smallest transmission angle for crank / coupler = e^x / (1 + e^x); below 0 if there is no such
** mechanism. */
static double transmission_of(double x, void *data)
{
    quick_return *q = data;
    double ratio = 1 / (1 + exp(-x));
    fourlink_solution s;
    int status;

    memset(&s.design, 0, sizeof s.design);
    memset(q->length, 0, sizeof q->length);
    q->offset = 0;
    if (q->task->type == FOURLINK_CRANK_ROCKER) {
        q->length[FOURLINK_CRANK] = ratio;
        q->length[FOURLINK_COUPLER] = 1;
        status = find_rocker(q);
    } else {
        q->length[FOURLINK_COUPLER] =
            0.5 * q->task->stroke / gsl_hypot(ratio * cos(0.5 * q->alpha), sin(0.5 * q->alpha));
        status = find_slider(q);
    }
    return status == FOURLINK_OK && prepare(q, &s) == FOURLINK_OK ? s.mu_min : -1;
}

/* The largest of these.  All lengths of a crank-rocker are scaled to the one that is given. */
static int find_best(quick_return *q)
{
    flk_sample best =
        flk_find_largest(transmission_of, q, -FARTHEST, 2 * FARTHEST / TRIALS, TRIALS);
    double factor = 1;
    int i;

    if (!(best.value > 0))
        return FOURLINK_NO_FULL_TURN;
    if (best.x == -FARTHEST)
        return FOURLINK_INFINITE_LINK;
    transmission_of(best.x, q);
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (q->task->length[i] > 0)
            factor = q->task->length[i] / q->length[i];
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        q->length[i] = q->task->length[i] > 0 ? q->task->length[i] : factor * q->length[i];
    return FOURLINK_OK;
}

/* The lengths, from what each type needs. */
static int find_lengths(quick_return *q)
{
    const fourlink_quick_return_task *task = q->task;
    int ground = task->length[1] > 0, crank = task->length[2] > 0, coupler = task->length[3] > 0;
    int rocker = task->length[4] > 0, offset = task->offset != 0, stroke = task->stroke > 0;
    int is_lever = task->type == FOURLINK_SLOTTED_LEVER, swing = task->swing > 0;
    int n = ground + crank + coupler + rocker, is_allowed;

    if (task->type == FOURLINK_CRANK_ROCKER)
        is_allowed = (n == 1 || n == 2) && swing && !offset && !stroke;
    else if (task->type == FOURLINK_ENGINE)
        is_allowed = crank + coupler + offset <= 1 && stroke && !ground && !rocker && !swing;
    else
        is_allowed = ground + crank == 1 && !coupler && task->slow != FOURLINK_SLOW_AGAINST &&
                     (is_lever ? rocker + stroke <= 1 && swing + (task->time_ratio > 0) == 1
                               : !offset && !stroke && !swing);
    if (!is_allowed)
        return FOURLINK_BAD_CHOICE;
    if (task->type == FOURLINK_CRANK_ROCKER)
        return n == 1 ? find_best(q) : find_rocker(q);
    if (task->type == FOURLINK_ENGINE)
        return crank + coupler + offset ? find_slider(q) : find_best(q);
    return find_lever(q);
}

static int check_quick_return(const fourlink_quick_return_task *task)
{
    int i;

    if (task->type != FOURLINK_CRANK_ROCKER && task->type != FOURLINK_ENGINE &&
        task->type != FOURLINK_SLOTTED_LEVER && task->type != FOURLINK_WHITWORTH)
        return FOURLINK_BAD_KIND;
    if (task->slow < FOURLINK_SLOW_AGAINST || task->slow > FOURLINK_SLOW_WITH)
        return FOURLINK_BAD_CHOICE;
    if (!flk_are_within(task->length + 1, 4, FOURLINK_LENGTH_MAX) ||
        !FLK_WITHIN(task->stroke, FOURLINK_LENGTH_MAX) ||
        !FLK_WITHIN(task->offset, FOURLINK_LENGTH_MAX) ||
        !FLK_WITHIN(task->time_ratio, FOURLINK_NUMBER_MAX) ||
        !(task->swing >= 0 && task->swing < M_PI))
        return FOURLINK_BAD_NUMBER;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (task->length[i] < 0 || task->stroke < 0)
            return FOURLINK_BAD_LENGTH;
    if (task->time_ratio < 1 && !(task->type == FOURLINK_SLOTTED_LEVER && task->time_ratio == 0))
        return FOURLINK_BAD_TIME_RATIO;
    return FOURLINK_OK;
}

static int find_quick_return(const void *data, fourlink_solution *s)
{
    const fourlink_quick_return_task *task = data;
    quick_return q;
    int status = check_quick_return(task);

    if (status != FOURLINK_OK)
        return status;
    q.task = task;
    q.offset = task->offset;
    q.alpha =
        task->time_ratio > 0 ? M_PI * (task->time_ratio - 1) / (task->time_ratio + 1) : task->swing;
    if (task->slow == FOURLINK_SLOW_AGAINST)
        q.alpha = -q.alpha;
    memcpy(q.length, task->length, sizeof q.length);
    status = find_lengths(&q);
    if (status == FOURLINK_OK)
        status = prepare(&q, s);
    if (status != FOURLINK_OK)
        return status;
    s->n_positions = 2;
    s->from = s->position[0].theta2;
    s->to = s->from + 2 * M_PI;
    return flk_check_solution(s, FLK_AS_GIVEN);
}

int fourlink_synthesis_quick_return(const fourlink_quick_return_task *task, unsigned long max,
                                    fourlink_solution *solutions, unsigned long *n)
{
    return flk_find_one(find_quick_return, task, max, solutions, n);
}
