/* SPDX-License-Identifier: GPL-3.0-or-later
**
** dyad.c - motion and path generators: linkages made of two dyads, links from a fixed pivot m to a moving
** pivot k of the coupler, for three positions.  Where the places of k are on a line, the right link is a
** slider.
**
** P_j is the coupler point in position j, alpha_j the coupler's rotation from position 1,
** delta_j = P_j - P_1.  Of a dyad, W = k_1 - m, Z = P_1 - k_1, and beta_j is the rotation of W.  All is
** relative to P_1.
*/
#include <math.h>
#include <stddef.h>
#include <string.h>

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_math.h>

#include "synthesis.h"

/* Steps of a search, rad. */
#define STEP (5 * M_PI / 180)
#define SMALLEST_STEP (0.499 * M_PI / 180)

typedef struct positions {
    gsl_complex delta[3], turn[3]; /* m; 1, e^(i alpha) */
    double size;                   /* m, largest |delta| */
} positions;

/* Pivots relative to P_1; of a slider, the direction of its line in place of the fixed one. */
typedef struct pivots {
    gsl_complex fixed, moving, line;
    double condition;
    int is_on_line;
} pivots;

static int is_zero(gsl_complex z, double size)
{
    return gsl_complex_abs(z) <= FLK_NOTHING * size;
}

/* The condition of two equations whose rows have length 1, from their determinant. */
static double condition_of(double determinant)
{
    double d = GSL_MIN_DBL(fabs(determinant), 1);

    return (1 + sqrt((1 - d) * (1 + d))) / d;
}

/* The centre of the circle through three places z_j:
**
**    2 (z_j - z_1) . (centre - z_1) = |z_j - z_1|^2,   j = 2, 3
**
** A pole of two positions has two equal places; then all points of a line are centres. */
static int find_centre(const gsl_complex z[3], gsl_complex *centre, double *condition)
{
    gsl_complex u = gsl_complex_sub(z[1], z[0]), v = gsl_complex_sub(z[2], z[0]), n;
    double l = gsl_complex_abs(u), m = gsl_complex_abs(v), determinant;
    double size = gsl_complex_abs(z[0]) + l + m;

    if (is_zero(u, size) || is_zero(v, size) || is_zero(gsl_complex_sub(u, v), size))
        return FOURLINK_DEPENDENT;
    determinant = (GSL_REAL(u) / l) * (GSL_IMAG(v) / m) - (GSL_IMAG(u) / l) * (GSL_REAL(v) / m);
    if (!(fabs(determinant) > FLK_NOTHING))
        return FOURLINK_INFINITE_LINK;
    n = gsl_complex_sub(gsl_complex_mul_real(u, m / l), gsl_complex_mul_real(v, l / m));
    *centre = gsl_complex_add(z[0], gsl_complex_mul_imag(n, 0.5 / determinant));
    *condition = condition_of(determinant);
    return FOURLINK_OK;
}

/* Rotations beta_2, beta_3 of the link:
**
**    W (e^(i beta_j) - 1) + Z (e^(i alpha_j) - 1) = delta_j,   j = 2, 3
*/
static int from_rotations(const positions *at, const double beta[2], pivots *p)
{
    gsl_complex w[2], z[2], determinant, W, Z, one = gsl_complex_rect(1, 0);
    double length = 1;
    int j;

    for (j = 0; j < 2; j++) {
        w[j] = gsl_complex_sub(gsl_complex_polar(1, beta[j]), one);
        z[j] = gsl_complex_sub(at->turn[j + 1], one);
        length *= gsl_hypot(gsl_complex_abs(w[j]), gsl_complex_abs(z[j]));
    }
    determinant = gsl_complex_sub(gsl_complex_mul(w[0], z[1]), gsl_complex_mul(w[1], z[0]));
    if (!(gsl_complex_abs(determinant) > FLK_NOTHING * length))
        return FOURLINK_DEPENDENT;
    W = gsl_complex_div(
        gsl_complex_sub(gsl_complex_mul(at->delta[1], z[1]), gsl_complex_mul(at->delta[2], z[0])),
        determinant);
    Z = gsl_complex_div(
        gsl_complex_sub(gsl_complex_mul(w[0], at->delta[2]), gsl_complex_mul(w[1], at->delta[1])),
        determinant);
    p->condition = condition_of(gsl_complex_abs(determinant) / length);
    p->moving = gsl_complex_negative(Z);
    p->fixed = gsl_complex_sub(p->moving, W);
    return FOURLINK_OK;
}

/* A slider on a line in direction u: the moving pivot k, with
**
**    Im((delta_j + (k - P_1) (e^(i alpha_j) - 1)) / u) = 0,   j = 2, 3
*/
static int from_line(const positions *at, double direction, pivots *p)
{
    gsl_complex c[2];
    double b[2], length = 1, determinant;
    int j;

    p->is_on_line = 1;
    p->line = gsl_complex_polar(1, direction);
    for (j = 0; j < 2; j++) {
        c[j] = gsl_complex_sub(at->turn[j + 1], gsl_complex_rect(1, 0));
        c[j] = gsl_complex_div(c[j], p->line);
        b[j] = -flk_vector_of(gsl_complex_div(at->delta[j + 1], p->line)).y;
        length *= gsl_complex_abs(c[j]);
    }
    determinant = GSL_IMAG(c[0]) * GSL_REAL(c[1]) - GSL_REAL(c[0]) * GSL_IMAG(c[1]);
    if (!(fabs(determinant) > FLK_NOTHING * length))
        return FOURLINK_DEPENDENT;
    p->condition = condition_of(determinant / length);
    p->moving = gsl_complex_rect((b[0] * GSL_REAL(c[1]) - b[1] * GSL_REAL(c[0])) / determinant,
                                 (b[1] * GSL_IMAG(c[0]) - b[0] * GSL_IMAG(c[1])) / determinant);
    p->fixed = p->moving;
    return FOURLINK_OK;
}

/* Both pivots of a dyad.  A moving pivot k is at P_j + e^(i alpha_j) (k_1 - P_1); m is the centre of these
** places.  Seen from the coupler, a fixed pivot m is at e^(-i alpha_j) (m - P_j), and k_1 is the centre. */
static int find_pivots(const fourlink_dyad *given, const positions *at,
                       const fourlink_vector *first, pivots *p)
{
    gsl_complex pivot = gsl_complex_sub(flk_plane(&given->pivot), flk_plane(first)), place[3];
    int j, status, is_fixed = given->choice == FOURLINK_FIXED_PIVOT;

    p->is_on_line = 0;
    if (!flk_points_within(&given->pivot, 1) ||
        !flk_are_within(given->rotation, 2, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    if (given->choice == FOURLINK_ROTATIONS)
        return from_rotations(at, given->rotation, p);
    if (given->choice == FOURLINK_SLIDER)
        return from_line(at, given->rotation[0], p);
    if (!is_fixed && given->choice != FOURLINK_MOVING_PIVOT)
        return FOURLINK_BAD_CHOICE;
    for (j = 0; j < 3; j++)
        place[j] = is_fixed ? gsl_complex_div(gsl_complex_sub(pivot, at->delta[j]), at->turn[j])
                            : gsl_complex_add(at->delta[j], gsl_complex_mul(at->turn[j], pivot));
    p->fixed = p->moving = pivot;
    status = find_centre(place, is_fixed ? &p->moving : &p->fixed, &p->condition);
    if (status != FOURLINK_INFINITE_LINK || is_fixed)
        return status;
    p->is_on_line = 1;
    p->line = gsl_complex_sub(place[2], place[1]);
    for (j = 1; j < 3; j++)
        if (gsl_complex_abs(gsl_complex_sub(place[j], place[0])) > gsl_complex_abs(p->line))
            p->line = gsl_complex_sub(place[j], place[0]);
    p->condition = 1;
    return FOURLINK_OK;
}

/* Positions relative to the first.  FOURLINK_DEPENDENT if two are equal. */
static int set_relative_positions(const fourlink_vector point[3], const double alpha[3],
                                  positions *at)
{
    int i, j;

    if (!flk_points_within(point, 3) || !flk_are_within(alpha, 3, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    at->size = 0;
    for (j = 0; j < 3; j++) {
        at->delta[j] = gsl_complex_sub(flk_plane(&point[j]), flk_plane(&point[0]));
        at->turn[j] = gsl_complex_polar(1, alpha[j] - alpha[0]);
        at->size = GSL_MAX_DBL(at->size, gsl_complex_abs(at->delta[j]));
    }
    for (i = 0; i < 3; i++)
        for (j = 0; j < i; j++)
            if (is_zero(gsl_complex_sub(at->delta[i], at->delta[j]), at->size) &&
                is_zero(gsl_complex_sub(at->turn[i], at->turn[j]), 1))
                return FOURLINK_DEPENDENT;
    return FOURLINK_OK;
}

/* The linkage of two dyads: A = m, B = k_1 of the left one, D, C of the right one.  With u the direction of
** A->D, or that of a slider's line in which the first position is on the open branch,
**
**    theta2j = arg((B_j - A) / u),   coupler point p = (P_1 - B_1) b / (C_1 - B_1)
**    X_j + i e = (C_j - A) / u                                                          of a slider
*/
static int join(const positions *at, const fourlink_vector *first, const pivots *left,
                const pivots *right, fourlink_solution *s)
{
    gsl_complex ground = gsl_complex_sub(right->fixed, left->fixed);
    gsl_complex crank = gsl_complex_sub(left->moving, left->fixed);
    gsl_complex coupler = gsl_complex_sub(right->moving, left->moving);
    gsl_complex rocker = gsl_complex_sub(right->moving, right->fixed), u, axis, X;
    double size = at->size + gsl_complex_abs(left->fixed) + gsl_complex_abs(left->moving) +
                  gsl_complex_abs(right->fixed) + gsl_complex_abs(right->moving);
    fourlink_link *link = s->design.link;
    int j, slides = right->is_on_line;

    if (left->is_on_line)
        return FOURLINK_INFINITE_LINK;
    if (is_zero(crank, size) || is_zero(coupler, size) ||
        (!slides && (is_zero(ground, size) || is_zero(rocker, size))))
        return FOURLINK_NO_LENGTH;
    s->design.kind = slides ? FOURLINK_SLIDER_CRANK : FOURLINK_FOUR_BAR;
    link[FOURLINK_CRANK].length = gsl_complex_abs(crank);
    link[FOURLINK_COUPLER].length = gsl_complex_abs(coupler);
    s->condition = GSL_MAX_DBL(left->condition, right->condition);
    s->origin = flk_vector_of(gsl_complex_add(left->fixed, flk_plane(first)));
    u = slides ? right->line : ground;
    if (slides && flk_vector_of(gsl_complex_div(coupler, u)).x < 0)
        u = gsl_complex_negative(u);
    s->direction = gsl_complex_arg(u);
    u = gsl_complex_polar(1, s->direction);
    if (slides) {
        X = gsl_complex_div(gsl_complex_sub(right->moving, left->fixed), u);
        s->design.offset = GSL_IMAG(X);
    } else {
        link[FOURLINK_GROUND].length = gsl_complex_abs(ground);
        link[FOURLINK_FOLLOWER].length = gsl_complex_abs(rocker);
    }
    axis = gsl_complex_div_real(coupler, link[FOURLINK_COUPLER].length);
    s->has_point = 1;
    s->point = flk_vector_of(gsl_complex_div(gsl_complex_negative(left->moving), axis));
    s->n_positions = 3;
    for (j = 0; j < 3; j++) {
        fourlink_precision *p = &s->position[j];
        gsl_complex B = gsl_complex_add(at->delta[j], gsl_complex_mul(at->turn[j], left->moving));
        gsl_complex C = gsl_complex_add(at->delta[j], gsl_complex_mul(at->turn[j], right->moving));

        p->theta2 = gsl_complex_arg(gsl_complex_div(gsl_complex_sub(B, left->fixed), u));
        p->theta3 = gsl_complex_arg(gsl_complex_div(gsl_complex_sub(C, B), u));
        X = gsl_complex_div(gsl_complex_sub(C, slides ? left->fixed : right->fixed), u);
        p->output = slides ? GSL_REAL(X) : gsl_complex_arg(X);
        p->point = flk_vector_of(gsl_complex_div(gsl_complex_sub(at->delta[j], left->fixed), u));
    }
    return FOURLINK_OK;
}

/* The linkage for the given positions and dyads.  `timing`: the crank's rotations, which the crank
** follows; or null. */
static int design_linkage(const fourlink_vector point[3], const double alpha[3],
                          const fourlink_dyad *left, const fourlink_dyad *right,
                          const double *timing, fourlink_solution *s)
{
    pivots first, second;
    positions at;
    int status = set_relative_positions(point, alpha, &at);

    memset(s, 0, offsetof(fourlink_solution, position)); /* a search makes thousands */
    memset(s->position, 0, 3 * sizeof *s->position);
    if (status == FOURLINK_OK)
        status = find_pivots(left, &at, &point[0], &first);
    if (status == FOURLINK_OK)
        status = find_pivots(right, &at, &point[0], &second);
    if (status == FOURLINK_OK)
        status = join(&at, &point[0], &first, &second, s);
    if (status != FOURLINK_OK)
        return status;
    if (timing) {
        s->position[1].theta2 = s->position[0].theta2 + timing[0];
        s->position[2].theta2 = s->position[0].theta2 + timing[1];
    }
    return flk_check_solution(s, timing ? FLK_AS_GIVEN : FLK_EITHER_WAY);
}

static int find_motion(const void *data, fourlink_solution *s)
{
    const fourlink_motion_task *task = data;

    return design_linkage(task->point, task->angle, &task->left, &task->right, NULL, s);
}

int fourlink_synthesis_motion(const fourlink_motion_task *task, unsigned long max,
                              fourlink_solution *solutions, unsigned long *n)
{
    return flk_find_one(find_motion, task, max, solutions, n);
}

static int design_path(const fourlink_path_task *task, double alpha2, double alpha3,
                       fourlink_solution *s)
{
    fourlink_dyad left = {FOURLINK_ROTATIONS, {0, 0}, {0, 0}};
    double alpha[3] = {0, 0, 0};

    memcpy(left.rotation, task->timing, sizeof left.rotation);
    alpha[1] = alpha2;
    alpha[2] = alpha3;
    return design_linkage(task->point, alpha, &left, &task->right, task->timing, s);
}

static int find_path(const void *data, fourlink_solution *s)
{
    const fourlink_path_task *task = data;

    return design_path(task, task->rotation[0], task->rotation[1], s);
}

/* How good a linkage of a search is: mu_min, with the cranks that turn fully before others.  0: it has a
** defect. */
static double grade(const fourlink_solution *s)
{
    if (s->defects)
        return 0;
    return s->mu_min + (s->type == FOURLINK_CRANK_ROCKER || s->type == FOURLINK_DOUBLE_CRANK ||
                                s->type == FOURLINK_ENGINE
                            ? M_PI
                            : 0);
}

/* Put a solution among the best, which are in order. */
static void rank(const fourlink_solution *s, unsigned long max, fourlink_solution *solutions,
                 unsigned long *n)
{
    unsigned long i = *n < max ? *n : max;

    for (; i > 0 && grade(&solutions[i - 1]) < grade(s); i--)
        if (i < max)
            solutions[i] = solutions[i - 1];
    if (i < max)
        solutions[i] = *s;
    (*n)++;
}

/* Of a grid of the coupler's rotations, over a turn each. */
static double grade_at(const fourlink_path_task *task, double step, int i, int j,
                       fourlink_solution *s)
{
    return design_path(task, i * step, j * step, s) == FOURLINK_OK ? grade(s) : 0;
}

/* The linkages of the grid that none of their eight neighbours surpasses. */
static int search(const fourlink_path_task *task, int steps, unsigned long max,
                  fourlink_solution *solutions, unsigned long *n)
{
    fourlink_solution s, beside;
    double step = 2 * M_PI / steps;
    unsigned long found = 0;
    int i, j, k;

    for (i = 0; i < steps; i++)
        for (j = 0; j < steps; j++) {
            double value = grade_at(task, step, i, j, &s);

            for (k = 0; value > 0 && k < 9; k++)
                if (grade_at(task, step, i + k / 3 - 1, j + k % 3 - 1, &beside) > value)
                    value = 0;
            if (value > 0)
                rank(&s, max, solutions, &found);
        }
    if (!found)
        return FOURLINK_NONE_FOUND;
    *n = found;
    return FOURLINK_OK;
}

int fourlink_synthesis_path(const fourlink_path_task *task, unsigned long max,
                            fourlink_solution *solutions, unsigned long *n)
{
    double step = task && task->step != 0 ? task->step : STEP;
    fourlink_solution first;
    int status;

    if (!task || !n || (max && !solutions))
        return FOURLINK_NULL;
    if (!task->search)
        return flk_find_one(find_path, task, max, solutions, n);
    status = find_path(task, &first);
    if (status == FOURLINK_BAD_NUMBER || status == FOURLINK_BAD_CHOICE)
        return status;
    return step >= SMALLEST_STEP && step <= M_PI_2
               ? search(task, (int)floor(2 * M_PI / step + 0.5), max, solutions, n)
               : FOURLINK_BAD_NUMBER;
}
