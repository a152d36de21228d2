/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fit.c - the function generator whose output has the least sum of w error^2, within bounds of its lengths.
**
** The equation of function.c, solved for the output y:
**
**    four-bar        y = m + s u,  R cos(u) = W,  R cos(m) = K1 - cos(theta2),  R sin(m) = -sin(theta2)
**    slider-crank    X = m + s u,  u^2 = m^2 + W,  m = S1/2 cos(theta2)
**
**    W = K2 cos(theta2) - K3,  or  S2 sin(theta2) - S3
**
** s, 1 or -1, is the branch, and u the swing from the line of the dead positions, m: 0 to pi, or at least 0.
**
** The linkage reaches a crank angle if |b - c| <= f <= b + c, f^2 = a^2 + d^2 - 2 a d cos(theta2), or if |r
** sin(theta2) - e| <= l.  So it reaches all points if it reaches two of them, p and q, with the least and
** the largest cosine, or sine.  There it may have any swings: they give W at p and q, and these K2 and K3.
** So K1 and the two swings are coordinates of all linkages that reach all points, with bounds that do not
** depend on each other.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "function.h"

/* The longest link, or the offset, relative to the shortest link: without a bound it may grow for ever.  The
** search aims slightly below. */
#define RATIO 100
#define AIM (RATIO * (1 - 1e-6))

/* The least transmission angle at a point, 0.001 deg, and what rounding of short couplers may take of it: the
** best linkage is often dead at p or q. */
#define MU_LEAST (1.01e-3 * M_PI / 180)
#define SAME 1e-7 /* of a length that repetition no longer changes, */
#define PASSES 30 /* ... or it does not exist */

/* The starts: the step of K1 relative to R, the least R that counts, and so many swings at p and at q. */
#define STEP 0.15
#define NARROW 0.05
#define SWINGS 9

/* A descent: its most steps, and the relative decrease of the sum by its last one: of every start, of those
** whose sum is then below the least one times PROMISING, and of the best fit. */
#define STEPS 100
#define ROUGHLY 1e-3
#define PROMISING 1.1
#define CLOSELY 1e-6
#define FULLY 1e-14

/* sqrt(w) error of all points, then for each pair of links how much their ratio is too large. */
#define PAIRS 16
#define ROWS (FOURLINK_PRECISION_MAX + PAIRS)

/* A linkage: K1, the swings at p and q, the branch; and its sum. */
typedef struct place {
    double x[3], sum;
    int sign;
} place;

typedef struct search {
    const fourlink_function_task *task;
    int is_four_bar;
    double unit, high[3]; /* a length; the bounds of x, -high[0], 0 and 0 below */
    unsigned long p, q;
    const double *along; /* the cosines or sines by which p and q are chosen */
    double cosine[FOURLINK_PRECISION_MAX], sine[FOURLINK_PRECISION_MAX],
        root[FOURLINK_PRECISION_MAX]; /* sqrt(w) */

    double K1, m[FOURLINK_PRECISION_MAX], R[FOURLINK_PRECISION_MAX]; /* m and R of this K1 */

    double most;      /* a fit with this sum exists */
    double stiffness; /* what a ratio beyond the bound counts */
    double sum, K[3]; /* the best fit, */
    fourlink_branch branch;
    int is_at_bound;
    place best; /* ... and its place while the bound counts little */
} search;

/* ------------------------------------------------------------------------- a linkage and its errors */

static double bounded(double x, double low, double high)
{
    return GSL_MAX_DBL(low, GSL_MIN_DBL(x, high));
}

static double distance(const search *s, double K1, unsigned long i)
{
    return sqrt(gsl_pow_2(K1 - s->cosine[i]) + gsl_pow_2(s->sine[i]));
}

static void set_K1(search *s, double K1)
{
    unsigned long i;

    for (i = 0; i < s->task->n && K1 != s->K1; i++) {
        s->R[i] = distance(s, K1, i);
        s->m[i] = s->is_four_bar ? atan2(-s->sine[i], K1 - s->cosine[i]) : 0.5 * K1 * s->cosine[i];
    }
    s->K1 = K1;
}

static double W_at(const search *s, unsigned long i, double swing)
{
    return s->is_four_bar ? s->R[i] * cos(swing) : gsl_pow_2(swing) - gsl_pow_2(s->m[i]);
}

static double swing_at(const search *s, unsigned long i, double W)
{
    return s->is_four_bar ? acos(bounded(W / s->R[i], -1, 1))
                          : sqrt(GSL_MAX_DBL(W + gsl_pow_2(s->m[i]), 0));
}

/* The swing at p or q for a coordinate, whose bounds are not dead positions but places where mu is MU_LEAST:
**
**    four-bar        b sin(mu) = f sin(u),  f = a R
**    slider-crank    l sin(mu) = u
*/
static double swing_of(const search *s, unsigned long i, double x, const fourlink_design *design)
{
    double side = MU_LEAST * design->link[FOURLINK_COUPLER].length, least;

    if (!s->is_four_bar)
        return side + x;
    least = asin(GSL_MIN_DBL(side / (design->link[FOURLINK_CRANK].length * s->R[i]), 1));
    return least + x * (1 - 2 * least / M_PI);
}

/* The linkage of a place, and its swings at p and q.  They depend a little on its coupler b: repetition. */
static int set_fitted(search *s, const double x[3], fourlink_solution *found, double swing[2])
{
    double K[3], W, b = 0, before = GSL_POSINF;
    int status = FOURLINK_OK, pass;

    set_K1(s, x[0]);
    for (pass = 0; status == FOURLINK_OK && !(fabs(b - before) <= SAME * b); pass++) {
        if (pass == PASSES)
            return FOURLINK_NO_LINKAGE;
        before = b;
        swing[0] = pass == 0 ? x[1] : swing_of(s, s->p, x[1], &found->design);
        swing[1] = pass == 0 ? x[2] : swing_of(s, s->q, x[2], &found->design);
        W = W_at(s, s->p, swing[0]);
        K[0] = s->K1;
        K[1] = (W - W_at(s, s->q, swing[1])) / (s->along[s->p] - s->along[s->q]);
        K[2] = K[1] * s->along[s->p] - W;
        status = flk_set_lengths(s->task, K, found);
        b = found->design.link[FOURLINK_COUPLER].length;
    }
    return status;
}

/* The lengths whose ratios have the bound: the links, and of a slider-crank the offset, which may not be too
** long, and the largest |X|, which is not too short. */
typedef struct lengths {
    double longer[4], shorter[4], ratio;
    int n;
} lengths;

static void measure_lengths(const search *s, const fourlink_design *design, lengths *l)
{
    double longest = 0, shortest = GSL_POSINF;
    int i;

    l->n = 0;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (design->link[i].length > 0)
            l->longer[l->n++] = design->link[i].length;
    memcpy(l->shorter, l->longer, sizeof l->longer);
    if (!s->is_four_bar) {
        l->longer[l->n] = fabs(design->offset);
        l->shorter[l->n++] = s->unit;
    }
    for (i = 0; i < l->n; i++) {
        longest = GSL_MAX_DBL(longest, l->longer[i]);
        shortest = GSL_MIN_DBL(shortest, l->shorter[i]);
    }
    l->ratio = longest / shortest;
}

/* stiffness log(ratio / bound) of each pair whose ratio is beyond the bound.  Returns the sum of squares. */
static double set_excesses(const search *s, const fourlink_design *design, double row[PAIRS])
{
    double sum = 0, ratio;
    lengths l;
    int i, j;

    measure_lengths(s, design, &l);
    for (i = 0; i < PAIRS; i++)
        row[i] = 0;
    for (i = 0; i < l.n && l.ratio > AIM; i++)
        for (j = 0; j < l.n; j++) {
            ratio = l.longer[i] / l.shorter[j];
            if (ratio > AIM)
                row[4 * i + j] = s->stiffness * log(ratio / AIM);
            sum += gsl_pow_2(row[4 * i + j]);
        }
    return sum;
}

/* The rows of a place, and the sum of their squares; or any sum above `most`.  Infinite, without rows: there
** is no linkage. */
static double sum_at(search *s, const double x[3], int sign, double most, double row[ROWS])
{
    unsigned long i, n = s->task->n;
    fourlink_solution found;
    double ends[2], sum;

    if (set_fitted(s, x, &found, ends) != FOURLINK_OK)
        return GSL_POSINF;
    sum = set_excesses(s, &found.design, &row[n]);
    for (i = 0; i < n && sum <= most; i++) {
        double W = found.K[1] * s->along[i] - found.K[2];
        double swing = i == s->p ? ends[0] : i == s->q ? ends[1] : swing_at(s, i, W);
        double error = s->m[i] + sign * swing - s->task->output[i];

        row[i] = s->root[i] * (s->is_four_bar ? flk_reduced(error) : error);
        sum += gsl_pow_2(row[i]);
    }
    return sum;
}

/* ------------------------------------------------------------------------------------- the descent */

/* J of the rows r at a place, by differences. */
static void set_derivatives(search *s, const place *at, const double r[ROWS], double J[3][ROWS])
{
    unsigned long n = s->task->n + PAIRS, i;
    int j;

    for (j = 2; j >= 0; j--) { /* K1 last: until then m and R stay */
        double x[3], h = 1e-7 * (j == 0 ? fabs(at->x[0]) : s->is_four_bar ? 1 : s->unit);

        memcpy(x, at->x, sizeof x);
        x[j] += x[j] + h > s->high[j] ? -h : h;
        if (!(sum_at(s, x, at->sign, GSL_POSINF, J[j]) < GSL_POSINF))
            memcpy(J[j], r, n * sizeof *r);
        for (i = 0; i < n; i++)
            J[j][i] = (J[j][i] - r[i]) / (x[j] - at->x[j]);
    }
}

/* H = J'J and g = -J'r.  A coordinate stays at a bound if the sum is less beyond it. */
static void set_normal_equations(search *s, const place *at, const double r[ROWS], double H[3][3],
                                 double g[3])
{
    unsigned long n = s->task->n + PAIRS, i;
    double J[3][ROWS];
    int j, k;

    set_derivatives(s, at, r, J);
    for (j = 0; j < 3; j++) {
        for (g[j] = 0, i = 0; i < n; i++)
            g[j] -= J[j][i] * r[i];
        for (k = 0; k < 3; k++)
            for (H[j][k] = 0, i = 0; i < n; i++)
                H[j][k] += J[j][i] * J[k][i];
    }
    for (j = 1; j < 3; j++)
        if ((at->x[j] <= 0 && g[j] < 0) || (at->x[j] >= s->high[j] && g[j] > 0)) {
            for (k = 0; k < 3; k++)
                H[j][k] = H[k][j] = 0;
            H[j][j] = 1;
            g[j] = 0;
        }
}

static double determinant(const double a[3], const double b[3], const double c[3])
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* x + step, (H + damping diag(H)) step = g, within the bounds. */
static void step_from(const search *s, double H[3][3], const double g[3], double damping,
                      double x[3])
{
    double A[3][3], D;
    int j;

    memcpy(A, H, sizeof A);
    for (j = 0; j < 3; j++)
        A[j][j] *= 1 + damping;
    D = determinant(A[0], A[1], A[2]);
    x[0] = bounded(x[0] + determinant(g, A[1], A[2]) / D, -s->high[0], s->high[0]);
    x[1] = bounded(x[1] + determinant(A[0], g, A[2]) / D, 0, s->high[1]);
    x[2] = bounded(x[2] + determinant(A[0], A[1], g) / D, 0, s->high[2]);
}

/* The method of Levenberg and Marquardt. */
static void descend(search *s, place *at, double last_decrease)
{
    double r[ROWS], next[ROWS], H[3][3], g[3], damping = 1e-3;
    int steps, is_settled;

    at->sum = sum_at(s, at->x, at->sign, GSL_POSINF, r);
    is_settled = !(at->sum > 0 && at->sum < GSL_POSINF);
    for (steps = 0; steps < STEPS && !is_settled; steps++) {
        place trial = *at;

        set_normal_equations(s, at, r, H, g);
        do {
            memcpy(trial.x, at->x, sizeof trial.x);
            step_from(s, H, g, damping, trial.x);
            trial.sum = sum_at(s, trial.x, at->sign, at->sum, next);
            damping *= 10;
        } while (!(trial.sum < at->sum) && damping < 1e9);
        if (!(trial.sum < at->sum))
            return;
        is_settled = trial.sum >= at->sum * (1 - last_decrease);
        *at = trial;
        memcpy(r, next, sizeof r);
        damping = GSL_MAX_DBL(0.01 * damping, 1e-12);
    }
}

/* -------------------------------------------------------------------------------------- the search */

/* The sum by fourlink_position; infinite if the linkage does not reach all points, or is dead there. */
static double sum_on(const search *s, const fourlink_solution *found, fourlink_branch branch)
{
    const fourlink_function_task *task = s->task;
    fourlink_mechanism mechanism;
    double sum = 0, error;
    unsigned long i;

    if (fourlink_prepare(&found->design, &mechanism) != FOURLINK_OK)
        return GSL_POSINF;
    for (i = 0; i < task->n; i++) {
        if (flk_error_at(found, &mechanism, branch, task->theta2[i], task->output[i], &error) !=
            FOURLINK_OK)
            return GSL_POSINF;
        sum += gsl_pow_2(s->root[i] * error);
    }
    return sum;
}

/* Descend; then make the bound of the ratios stiffer until it holds.  Keep the best fit. */
static void take(search *s, const place *start, double last_decrease)
{
    static const fourlink_branch branches[] = {FOURLINK_OPEN, FOURLINK_CROSSED};
    double stiffness = s->stiffness, swing[2], sum;
    place at = *start, first;
    fourlink_solution found;
    lengths l;
    int k;

    descend(s, &at, last_decrease);
    first = at;
    l.ratio = GSL_POSINF;
    for (k = 0; k < 8 && set_fitted(s, at.x, &found, swing) == FOURLINK_OK; k++) {
        measure_lengths(s, &found.design, &l);
        if (l.ratio <= RATIO)
            break;
        s->stiffness *= 10;
        descend(s, &at, last_decrease);
    }
    s->stiffness = stiffness;
    for (k = 0; k < 2 && l.ratio <= RATIO; k++) {
        sum = sum_on(s, &found, branches[k]);
        if (sum < s->sum) {
            s->sum = sum;
            memcpy(s->K, found.K, sizeof s->K);
            s->branch = branches[k];
            s->is_at_bound = l.ratio > RATIO * (1 - 1e-3);
            s->best = first;
        }
    }
}

/* The swing at a point with a part, -1 to 1, of the error that alone makes the sum `most`. */
static double swing_for(const search *s, unsigned long i, int sign, double part)
{
    double error = part * sqrt(s->most) / s->root[i];
    double swing = sign * (s->task->output[i] + error - s->m[i]);

    if (s->is_four_bar)
        swing = flk_reduced(swing);
    return s->is_four_bar && swing < -M_PI_2 ? M_PI : GSL_MAX_DBL(swing, 0);
}

static int is_near_best(const search *s, const place *at)
{
    double unit = s->is_four_bar ? 1 : s->unit;

    return s->sum < GSL_POSINF && at->sign == s->best.sign &&
           fabs(at->x[0] - s->best.x[0]) <= 0.01 * fabs(at->x[0]) &&
           fabs(at->x[1] - s->best.x[1]) <= 0.01 * unit &&
           fabs(at->x[2] - s->best.x[2]) <= 0.01 * unit;
}

/* With a K1 and a branch, start from the best of many swings with each sign of K2: a linkage does not pass
** from one to the other, as c = d / K2.  A better fit than the one that is known has no greater errors at p
** and q than these. */
static void try_swings(search *s, double K1, int sign)
{
    double row[ROWS];
    place at, start[2];
    int i, j, k;

    start[0].sum = start[1].sum = GSL_POSINF;
    set_K1(s, K1);
    at.x[0] = K1;
    at.sign = sign;
    for (i = 0; i < SWINGS; i++)
        for (j = 0; j < SWINGS; j++) {
            at.x[1] = swing_for(s, s->p, sign, 2.0 * i / (SWINGS - 1) - 1);
            at.x[2] = swing_for(s, s->q, sign, 2.0 * j / (SWINGS - 1) - 1);
            k = W_at(s, s->p, at.x[1]) > W_at(s, s->q, at.x[2]);
            at.sum = sum_at(s, at.x, sign, start[k].sum, row);
            if (at.sum < start[k].sum)
                start[k] = at;
        }
    for (k = 0; k < 2; k++) {
        if (!(start[k].sum < GSL_POSINF))
            continue;
        descend(s, &start[k], ROUGHLY);
        if (start[k].sum < PROMISING * s->sum && !is_near_best(s, &start[k]))
            take(s, &start[k], CLOSELY);
    }
    s->most = GSL_MIN_DBL(s->most, s->sum);
    s->stiffness = sqrt(100 * s->most);
}

/* How far the next K1 is: m and log(R) change by at most dK1 / R. */
static double step_at(const search *s, double K1)
{
    double size = fabs(K1), R = GSL_POSINF;
    unsigned long i;

    if (!s->is_four_bar)
        return STEP * size;
    for (i = 0; i < s->task->n; i++)
        R = GSL_MIN_DBL(R, distance(s, K1, i));
    return STEP * GSL_MAX_DBL(R, NARROW * GSL_MIN_DBL(size, 1));
}

/* The sum of w (y - mean of y)^2, and somewhat more: a linkage whose output hardly moves. */
static double sum_at_rest(const search *s)
{
    double weights = 0, mean = 0, sum = 0, w;
    unsigned long i;

    for (i = 0; i < s->task->n; i++) {
        w = gsl_pow_2(s->root[i]);
        weights += w;
        mean += w * (s->task->output[i] - mean) / weights;
    }
    for (i = 0; i < s->task->n; i++)
        sum += gsl_pow_2(s->root[i] * (s->task->output[i] - mean));
    return sum + weights * gsl_pow_2(0.02 * (s->is_four_bar ? 1 : s->unit));
}

static void begin(search *s, const fourlink_function_task *task)
{
    unsigned long i;

    s->task = task;
    s->is_four_bar = task->kind == FOURLINK_FOUR_BAR;
    s->unit = flk_length_unit(task);
    s->along = s->is_four_bar ? s->cosine : s->sine;
    s->p = s->q = 0;
    for (i = 0; i < task->n; i++) {
        s->root[i] = sqrt(flk_weight_of(task, i));
        s->cosine[i] = cos(task->theta2[i]);
        s->sine[i] = sin(task->theta2[i]);
        s->p = s->along[i] < s->along[s->p] ? i : s->p;
        s->q = s->along[i] > s->along[s->q] ? i : s->q;
    }
    s->high[0] = 2 * RATIO * (s->is_four_bar ? 1 : 2 * s->unit);
    s->high[1] = s->high[2] = s->is_four_bar ? M_PI : 2 * RATIO * s->unit;
    s->K1 = FLK_UNDEFINED;
    s->most = sum_at_rest(s);
    s->stiffness = sqrt(100 * s->most);
    s->sum = GSL_POSINF;
}

void flk_fit_output(const fourlink_function_task *task, double K[3], fourlink_solution *solution)
{
    double size, least, most;
    search s;

    begin(&s, task);
    most = 0.5 * s.high[0];
    least = most / gsl_pow_2(RATIO);
    for (size = least; size < most; size += step_at(&s, size)) {
        try_swings(&s, size, 1);
        try_swings(&s, size, -1);
    }
    for (size = least; size < most; size += step_at(&s, -size)) {
        try_swings(&s, -size, 1);
        try_swings(&s, -size, -1);
    }
    if (!(s.sum < GSL_POSINF))
        return;
    take(&s, &s.best, FULLY);
    memcpy(K, s.K, sizeof s.K);
    solution->branch = s.branch;
    solution->is_better_longer = s.is_at_bound;
}
