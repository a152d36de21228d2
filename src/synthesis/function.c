/* SPDX-License-Identifier: GPL-3.0-or-later
**
** function.c - function generators: a four-bar linkage or a slider-crank whose output is a given function of
** the crank angle, at three points exactly or at more by least squares.
**
** F. Freudenstein, "Approximate Synthesis of Four-Bar Linkages", Trans. ASME 77 (1955) 853-861.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "function.h"

/* Intervals of the search for the largest structural error. */
#define INTERVALS 180

/* The equation of a point, linear in K, or in S1, S2, S3:
**
**    four-bar        K1 cos(theta4) - K2 cos(theta2) + K3 = cos(theta2 - theta4)      Freudenstein 1955
**    slider-crank    S1 X cos(theta2) + S2 sin(theta2) - S3 = X^2
**
** from b^2 = |C - B|^2.  y is the output.
*/
typedef struct equation {
    double row[3], right;
} equation;

static equation equation_at(fourlink_kind kind, double theta2, double y)
{
    equation e;

    if (kind == FOURLINK_FOUR_BAR) {
        e.row[0] = cos(y);
        e.row[1] = -cos(theta2);
        e.row[2] = 1;
        e.right = cos(theta2 - y);
    } else {
        e.row[0] = y * cos(theta2);
        e.row[1] = sin(theta2);
        e.row[2] = -1;
        e.right = y * y;
    }
    return e;
}

/* Three points are met whatever they weigh. */
double flk_weight_of(const fourlink_function_task *task, unsigned long i)
{
    return task->weight && task->n > 3 ? task->weight[i] : 1;
}

/* The K that makes the sum of w F^2 the least, F the left side of the equation minus the right one. */
static int find_K(const fourlink_function_task *task, double K[3], double *condition)
{
    double A[FOURLINK_PRECISION_MAX][3], b[FOURLINK_PRECISION_MAX];
    unsigned long i;
    int j;

    for (i = 0; i < task->n; i++) {
        equation e = equation_at(task->kind, task->theta2[i], task->output[i]);
        double root = sqrt(flk_weight_of(task, i));

        for (j = 0; j < 3; j++)
            A[i][j] = root * e.row[j];
        b[i] = root * e.right;
    }
    return flk_least_squares(task->n, (const double(*)[3])A, b, K, condition);
}

/* The length that the others are compared with, m: the ground, or the largest |X|. */
double flk_length_unit(const fourlink_function_task *task)
{
    double unit = 0;
    unsigned long i;

    if (task->kind == FOURLINK_FOUR_BAR)
        return task->ground;
    for (i = 0; i < task->n; i++)
        unit = GSL_MAX_DBL(unit, fabs(task->output[i]));
    return unit;
}

/* Lengths from K or S.  A negative a or c is that of a link which is turned by 180 deg, so it keeps its
** sign in b^2:
**
**    four-bar        a = d / K1,  c = d / K2,  b^2 = a^2 + c^2 + d^2 - 2 a c K3
**    slider-crank    r = S1 / 2,  e = S2 / S1,  l^2 = r^2 + e^2 - S3
*/
int flk_set_lengths(const fourlink_function_task *task, const double K[3], fourlink_solution *s)
{
    double a, c = 0, d = flk_length_unit(task), square, size;

    memset(&s->design, 0, sizeof s->design);
    if (task->kind == FOURLINK_FOUR_BAR) {
        if (!(fabs(K[0]) > FLK_NOTHING && fabs(K[1]) > FLK_NOTHING))
            return FOURLINK_INFINITE_LINK;
        a = d / K[0];
        c = d / K[1];
        size = a * a + c * c + d * d;
        square = size - 2 * a * c * K[2];
        s->design.link[FOURLINK_GROUND].length = d;
    } else {
        if (!(fabs(K[0]) > FLK_NOTHING * d))
            return FOURLINK_NO_LENGTH;
        a = 0.5 * K[0];
        s->design.offset = K[1] / K[0];
        size = a * a + s->design.offset * s->design.offset;
        square = size - K[2];
    }
    if (!(square > FLK_NOTHING * size))
        return FOURLINK_NO_LINKAGE;
    memcpy(s->K, K, sizeof s->K);
    s->design.kind = task->kind;
    s->design.link[FOURLINK_CRANK].length = fabs(a);
    s->design.link[FOURLINK_COUPLER].length = sqrt(square);
    s->design.link[FOURLINK_FOLLOWER].length = fabs(c);
    s->crank_turn = a < 0 ? M_PI : 0;
    s->rocker_turn = c < 0 ? M_PI : 0;
    return FOURLINK_OK;
}

/* Output of the linkage minus the wanted one. */
int flk_error_at(const fourlink_solution *s, const fourlink_mechanism *mechanism,
                 fourlink_branch branch, double theta2, double wanted, double *error)
{
    fourlink_state state;
    int status = fourlink_position(mechanism, branch, theta2 + s->crank_turn, &state);

    if (status == FOURLINK_OK)
        *error = flk_output_error(&state, s->design.kind, wanted + s->rocker_turn);
    return status;
}

/* The size of the error at a crank angle, for the search of the largest; NaN where the linkage does not
** reach, or nothing is wanted. */
typedef struct error_curve {
    const fourlink_function_task *task;
    const fourlink_solution *solution;
    double error; /* with its sign */
} error_curve;

static double size_of_error(double theta2, void *data)
{
    error_curve *c = data;
    double wanted = c->task->wanted(c->task->host, theta2);
    int status = fourlink_synthesis_error(c->solution, theta2, wanted, &c->error);

    return status == FOURLINK_OK ? fabs(c->error) : FLK_UNDEFINED;
}

/* The largest error: of the points, or, if more is known, in the range. */
static void find_largest_error(const fourlink_function_task *task, fourlink_solution *s)
{
    double from = GSL_MIN_DBL(s->from, s->to) - s->crank_turn;
    flk_sample largest;
    error_curve c;
    int i;

    for (i = 0; i < s->n_positions; i++)
        if (fabs(s->position[i].error) > fabs(s->max_error)) {
            s->max_error = s->position[i].error;
            s->max_error_at = s->position[i].theta2;
        }
    if (!task->wanted)
        return;
    c.task = task;
    c.solution = s;
    largest =
        flk_find_largest(size_of_error, &c, from, fabs(s->to - s->from) / INTERVALS, INTERVALS);
    if (largest.value >= 0) {
        size_of_error(largest.x, &c);
        s->max_error = c.error;
        s->max_error_at = largest.x + s->crank_turn;
    }
}

static int check_function(const fourlink_function_task *task)
{
    int is_four_bar = task->kind == FOURLINK_FOUR_BAR;
    unsigned long i;

    if (!is_four_bar && task->kind != FOURLINK_SLIDER_CRANK)
        return FOURLINK_BAD_KIND;
    if (task->fit != FOURLINK_FIT_EQUATION && task->fit != FOURLINK_FIT_ANGLE)
        return FOURLINK_BAD_CHOICE;
    if (task->n < 3 || task->n > FOURLINK_PRECISION_MAX)
        return FOURLINK_BAD_POINTS;
    if (!task->theta2 || !task->output)
        return FOURLINK_NULL;
    if (!FLK_WITHIN(task->from, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(task->to, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(task->ground, FOURLINK_LENGTH_MAX) ||
        !flk_are_within(task->theta2, task->n, FOURLINK_NUMBER_MAX) ||
        !flk_are_within(task->output, task->n,
                        is_four_bar ? FOURLINK_NUMBER_MAX : FOURLINK_LENGTH_MAX))
        return FOURLINK_BAD_NUMBER;
    for (i = 0; task->weight && i < task->n; i++)
        if (!(task->weight[i] > 0 && task->weight[i] <= FOURLINK_NUMBER_MAX))
            return FOURLINK_BAD_NUMBER;
    return is_four_bar && task->ground < FOURLINK_LENGTH_MIN ? FOURLINK_BAD_LENGTH : FOURLINK_OK;
}

/* The positions are the points; a residual of a slider-crank is relative to the largest X^2. */
static void set_points(const fourlink_function_task *task, fourlink_solution *s)
{
    int i, is_slider = task->kind == FOURLINK_SLIDER_CRANK;
    double unit = is_slider ? flk_length_unit(task) : 1;

    s->n_positions = (int)task->n;
    for (i = 0; i < s->n_positions; i++) {
        double y = task->output[i];
        equation e = equation_at(task->kind, task->theta2[i], y);

        s->position[i].theta2 = task->theta2[i] + s->crank_turn;
        s->position[i].output = is_slider ? y : flk_reduced(y + s->rocker_turn);
        s->position[i].residual =
            (s->K[0] * e.row[0] + s->K[1] * e.row[1] + s->K[2] * e.row[2] - e.right) /
            (unit * unit);
    }
    s->from = task->from + s->crank_turn;
    s->to = task->to + s->crank_turn;
}

static int find_function(const void *data, fourlink_solution *s)
{
    const fourlink_function_task *task = data;
    double K[3];
    int status = check_function(task);

    if (status != FOURLINK_OK)
        return status;
    if (!(flk_length_unit(task) >= FOURLINK_LENGTH_MIN))
        return FOURLINK_DEPENDENT;
    status = find_K(task, K, &s->condition);
    if (status == FOURLINK_OK && task->n > 3 && task->fit == FOURLINK_FIT_ANGLE)
        flk_fit_output(task, K, s);
    if (status == FOURLINK_OK)
        status = flk_set_lengths(task, K, s);
    if (status != FOURLINK_OK)
        return status;
    set_points(task, s);
    status = flk_check_solution(s, FLK_AS_GIVEN);
    if (status == FOURLINK_OK)
        find_largest_error(task, s);
    return status;
}

int fourlink_synthesis_function(const fourlink_function_task *task, unsigned long max,
                                fourlink_solution *solutions, unsigned long *n)
{
    return flk_find_one(find_function, task, max, solutions, n);
}

int fourlink_synthesis_error(const fourlink_solution *solution, double theta2, double wanted,
                             double *error)
{
    fourlink_mechanism mechanism;
    int status;

    if (!solution || !error)
        return FOURLINK_NULL;
    if (!FLK_WITHIN(wanted, FOURLINK_NUMBER_MAX) || !FLK_WITHIN(theta2, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    status = fourlink_prepare(&solution->design, &mechanism);
    if (status == FOURLINK_OK)
        status = flk_error_at(solution, &mechanism, solution->branch, theta2, wanted, error);
    return status;
}

/* x_j = (x0 + xf) / 2 - (xf - x0) / 2 cos((2 j - 1) pi / 2 n),  j = 1 ... n
**
** the zeros of Chebyshev's polynomial (Freudenstein 1955). */
int fourlink_chebyshev(double from, double to, unsigned long n, double *x)
{
    unsigned long j;

    if (!x)
        return FOURLINK_NULL;
    if (n < 1 || n > FOURLINK_PRECISION_MAX)
        return FOURLINK_BAD_POINTS;
    if (!FLK_WITHIN(from, FOURLINK_NUMBER_MAX) || !FLK_WITHIN(to, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    for (j = 0; j < n; j++)
        x[j] = 0.5 * (from + to) -
               0.5 * (to - from) * cos((double)(2 * j + 1) * M_PI / (double)(2 * n));
    return FOURLINK_OK;
}
