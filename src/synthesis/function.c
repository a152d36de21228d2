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

#include "synthesis.h"

/* Intervals of the search for the largest structural error. */
#define INTERVALS 180

/* Steps of the fit of the output, the shortest part of a step, and how long its links may be (growth_of):
** beyond it they grow without bound. */
#define STEPS 100
#define SHORTEST 1e-12
#define FEW_STEPS 6 /* of each start; the best ones go on */
#define SHORT 0.02
#define GROWTH_MOST 100
#define SETTLED 1e-13 /* of the sum: a smaller decrease is the last */

/* The equation of a point, linear in K, or in S1, S2, S3:
**
**    four-bar        K1 cos(theta4) - K2 cos(theta2) + K3 = cos(theta2 - theta4)      Freudenstein 1955
**    slider-crank    S1 X cos(theta2) + S2 sin(theta2) - S3 = X^2
**
** from b^2 = |C - B|^2.  F is the left side minus the right side, y the output.
*/
typedef struct equation {
    double row[3], F, dF_dy;
} equation;

static equation equation_at(fourlink_kind kind, const double K[3], double theta2, double y)
{
    equation e;

    if (kind == FOURLINK_FOUR_BAR) {
        e.row[0] = cos(y);
        e.row[1] = -cos(theta2);
        e.row[2] = 1;
        e.F = -cos(theta2 - y);
        e.dF_dy = -K[0] * sin(y) - sin(theta2 - y);
    } else {
        e.row[0] = y * cos(theta2);
        e.row[1] = sin(theta2);
        e.row[2] = -1;
        e.F = -y * y;
        e.dF_dy = K[0] * cos(theta2) - 2 * y;
    }
    e.F += K[0] * e.row[0] + K[1] * e.row[1] + K[2] * e.row[2];
    return e;
}

/* Three points are met whatever they weigh. */
static double weight_of(const fourlink_function_task *task, unsigned long i)
{
    return task->weight && task->n > 3 ? task->weight[i] : 1;
}

/* The change of K that makes the sum of w F^2 the least or, to first order, that of w error^2 if errors
** are given. At the output of the linkage F is 0, so that
**
**    d error / dK = -(dF/dK) / (dF/dy),   dF/dK = row
*/
static int find_step(const fourlink_function_task *task, const double K[3], const double *error,
                     double step[3], double *condition)
{
    double A[FOURLINK_PRECISION_MAX][3], b[FOURLINK_PRECISION_MAX];
    unsigned long i;
    int j;

    for (i = 0; i < task->n; i++) {
        double y = task->output[i] + (error ? error[i] : 0), root = sqrt(weight_of(task, i));
        equation e = equation_at(task->kind, K, task->theta2[i], y);

        for (j = 0; j < 3; j++)
            A[i][j] = root * e.row[j] / (error ? -e.dF_dy : 1);
        b[i] = -root * (error ? error[i] : e.F);
    }
    return flk_least_squares(task->n, (const double(*)[3])A, b, step, condition);
}

/* The length that the others are compared with, m: the ground, or the largest |X|. */
static double length_unit(const fourlink_function_task *task)
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
static int set_lengths(const fourlink_function_task *task, const double K[3], fourlink_solution *s)
{
    double a, c = 0, d = length_unit(task), square, size;

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
static int error_at(const fourlink_solution *s, const fourlink_mechanism *mechanism,
                    fourlink_branch branch, double theta2, double wanted, double *error)
{
    fourlink_state state;
    int status = fourlink_position(mechanism, branch, theta2 + s->crank_turn, &state);

    if (status == FOURLINK_OK)
        *error = flk_output_error(&state, s->design.kind, wanted + s->rocker_turn);
    return status;
}

/* How long the links are, or the offset: the longest relative to the shortest or, for a slider-crank, to
** the largest |X| if that is shorter. */
static double growth_of(const fourlink_function_task *task, const fourlink_design *design)
{
    double longest = fabs(design->offset), shortest = length_unit(task);
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (design->link[i].length > 0) {
            longest = GSL_MAX_DBL(longest, design->link[i].length);
            shortest = GSL_MIN_DBL(shortest, design->link[i].length);
        }
    return longest / shortest;
}

/* The errors of all points on a branch, and the sum of w error^2: infinite if there is no linkage or it does
** not reach a point.  *growth is that of its links. */
static double errors_of(const fourlink_function_task *task, const double K[3],
                        fourlink_branch branch, double *error, double *growth)
{
    fourlink_mechanism mechanism;
    fourlink_solution s;
    double sum = 0;
    unsigned long i;

    memset(&s.design, 0, sizeof s.design);
    if (set_lengths(task, K, &s) != FOURLINK_OK ||
        fourlink_prepare(&s.design, &mechanism) != FOURLINK_OK)
        return GSL_POSINF;
    *growth = growth_of(task, &s.design);
    for (i = 0; i < task->n; i++) {
        if (error_at(&s, &mechanism, branch, task->theta2[i], task->output[i], &error[i]) !=
            FOURLINK_OK)
            return GSL_POSINF;
        sum += weight_of(task, i) * error[i] * error[i];
    }
    return sum;
}

/* A fit: K on a branch. */
typedef struct fit {
    double K[3], sum;
    fourlink_branch branch;
    int is_at_bound; /* 1: longer links would fit better */
} fit;

/* The best fits of a few steps each, the best one first. */
#define FITS 8

typedef struct best_fits {
    fit list[FITS];
    int n;
} best_fits;

/* Make the errors of the output small, by Gauss's method with shortened steps, at most so many.  Steps
** that make the links grow beyond the bound are shortened.  0 if the linkage does not reach all points. */
static int improve(const fourlink_function_task *task, fit *f, int steps, double shortest)
{
    double error[FOURLINK_PRECISION_MAX], step[3], trial[3], condition, part, next, growth = 0;
    int is_settled = 0, j;

    f->sum = errors_of(task, f->K, f->branch, error, &growth);
    if (!(f->sum < GSL_POSINF) || growth > GROWTH_MOST)
        return 0;
    for (f->is_at_bound = 0; steps > 0 && f->sum > 0 && !is_settled; steps--) {
        if (find_step(task, f->K, error, step, &condition) != FOURLINK_OK)
            break;
        next = GSL_POSINF;
        f->is_at_bound = 0;
        for (part = 1; part > shortest && !(next < f->sum); part *= 0.5) {
            for (j = 0; j < 3; j++)
                trial[j] = f->K[j] + part * step[j];
            next = errors_of(task, trial, f->branch, error, &growth);
            if (next < f->sum && growth > GROWTH_MOST) {
                f->is_at_bound = 1;
                next = GSL_POSINF;
            }
        }
        if (!(next < f->sum))
            break;
        memcpy(f->K, trial, sizeof trial);
        is_settled = next > f->sum * (1 - SETTLED);
        f->sum = next;
    }
    return 1;
}

/* Try a start on both branches, by a few steps. */
static void try_start(const fourlink_function_task *task, const double start[3], best_fits *best)
{
    static const fourlink_branch branches[] = {FOURLINK_OPEN, FOURLINK_CROSSED};
    fit f;
    int b, i;

    for (b = 0; b < 2; b++) {
        memcpy(f.K, start, sizeof f.K);
        f.branch = branches[b];
        if (!improve(task, &f, FEW_STEPS, SHORT))
            continue;
        for (i = best->n < FITS ? best->n++ : FITS; i > 0 && f.sum < best->list[i - 1].sum; i--)
            if (i < FITS)
                best->list[i] = best->list[i - 1];
        if (i < FITS)
            best->list[i] = f;
    }
}

/* Fit from the linkages through three of at most seven points, the ends and those between. */
#define SPREAD 7

static void fit_through_points(const fourlink_function_task *task, best_fits *best)
{
    const double none[3] = {0, 0, 0};
    double start[3], theta2[3], output[3], condition;
    fourlink_function_task three = *task;
    unsigned long m = GSL_MIN(task->n, SPREAD), i[3], k;

    three.n = 3;
    three.theta2 = theta2;
    three.output = output;
    for (i[0] = 0; i[0] < m; i[0]++)
        for (i[1] = i[0] + 1; i[1] < m; i[1]++)
            for (i[2] = i[1] + 1; i[2] < m; i[2]++) {
                for (k = 0; k < 3; k++) {
                    theta2[k] = task->theta2[i[k] * (task->n - 1) / (m - 1)];
                    output[k] = task->output[i[k] * (task->n - 1) / (m - 1)];
                }
                if (find_step(&three, none, NULL, start, &condition) == FOURLINK_OK)
                    try_start(task, start, best);
            }
}

/* Fit from linkages of common proportions, turned by 180 deg or not: lengths in parts of length_unit. */
static void fit_proportions(const fourlink_function_task *task, best_fits *best)
{
    static const double parts[] = {-1.5, -0.7, -0.3, 0.3, 0.7, 1.5}, others[] = {0.5, 1, 2};
    double start[3], d = length_unit(task);
    int i, j, k;

    for (i = 0; i < 6; i++)
        for (j = 0; j < 6; j++)
            for (k = 0; k < 3; k++) {
                double a = parts[i] * d, c = parts[j] * d, b = others[k] * d;

                if (task->kind == FOURLINK_FOUR_BAR) {
                    start[0] = d / a;
                    start[1] = d / c;
                    start[2] = (a * a + c * c + d * d - b * b) / (2 * a * c);
                } else { /* c is the offset */
                    start[0] = 2 * a;
                    start[1] = 2 * a * c;
                    start[2] = a * a + c * c - b * b;
                }
                try_start(task, start, best);
            }
}

/* Gauss's method stops at a minimum that need not be the least, and often the linkage of the equation
** does not reach all points: so it starts from many linkages, on both branches.  If none has a fit, K is
** left as it is.  Returns 1 if longer links would fit better. */
static int fit_output(const fourlink_function_task *task, double K[3])
{
    double least = GSL_POSINF;
    int is_at_bound = 0, i;
    best_fits best;

    best.n = 0;
    try_start(task, K, &best);
    fit_through_points(task, &best);
    fit_proportions(task, &best);
    for (i = 0; i < best.n; i++)
        if (improve(task, &best.list[i], STEPS, SHORTEST) && best.list[i].sum < least) {
            least = best.list[i].sum;
            is_at_bound = best.list[i].is_at_bound;
            memcpy(K, best.list[i].K, sizeof best.list[i].K);
        }
    return is_at_bound;
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
    double unit = is_slider ? length_unit(task) : 1;

    s->n_positions = (int)task->n;
    for (i = 0; i < s->n_positions; i++) {
        double y = task->output[i];

        s->position[i].theta2 = task->theta2[i] + s->crank_turn;
        s->position[i].output = is_slider ? y : flk_reduced(y + s->rocker_turn);
        s->position[i].residual =
            equation_at(task->kind, s->K, task->theta2[i], y).F / (unit * unit);
    }
    s->from = task->from + s->crank_turn;
    s->to = task->to + s->crank_turn;
}

static int find_function(const void *data, fourlink_solution *s)
{
    const fourlink_function_task *task = data;
    double K[3], start[3] = {0, 0, 0};
    int status = check_function(task);

    if (status != FOURLINK_OK)
        return status;
    if (!(length_unit(task) >= FOURLINK_LENGTH_MIN))
        return FOURLINK_DEPENDENT;
    status = find_step(task, start, NULL, K, &s->condition);
    if (status == FOURLINK_OK && task->n > 3 && task->fit == FOURLINK_FIT_ANGLE)
        s->is_better_longer = fit_output(task, K);
    if (status == FOURLINK_OK)
        status = set_lengths(task, K, s);
    if (status != FOURLINK_OK)
        return status;
    set_points(task, s);
    status = flk_check_solution(s, 0);
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
        status = error_at(solution, &mechanism, solution->branch, theta2, wanted, error);
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
