/* SPDX-License-Identifier: GPL-3.0-or-later
**
** follow.c - columns along the motion of a branch, piece by piece, and their limits where there is no row.
*/
#include <float.h>
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/solve.h"
#include "base/trig.h"
#include "follow.h"

/* From an end into the piece, rad for each turn of the cycle: cycle.c rounds by 1e-12 of it. */
#define INSIDE 1e-11
#define ROUNDED 1e-15 /* ... more by this part of the angle passed, whose last digits are rounded */
#define CLOSE 1e-6    /* rad, of the end of a piece and that of a period */
#define MOST_ROWS 4e6 /* of a walk without loads: a second or two */

void flk_follow_all(flk_follower *f)
{
    f->motion.length += f->skipped;
    f->skipped = 0;
}

static void skip_periods(flk_follower *f)
{
    f->motion.period = flk_course_repeats(&f->a->course) ? f->a->course.period : GSL_POSINF;
    if (f->motion.length < 3 * f->motion.period)
        return;
    f->skipped = f->motion.period * (flk_cycle_count(f->motion.length, f->motion.period) - 2);
    f->motion.length -= f->skipped;
}

void flk_follow(flk_follower *f, flk_analysis *a, fourlink_branch branch)
{
    const flk_course *course = &a->course;

    memset(f, 0, sizeof *f);
    f->a = a;
    f->branch = branch;
    a->rows_left = MOST_ROWS;
    f->motion.course = course;
    f->motion.branch = branch;
    f->motion.has_loads = course->actual != NULL;
    course->type->begin(course, &f->motion);
    skip_periods(f);
}

int flk_follow_next(flk_follower *f)
{
    return flk_pieces_next(&f->motion, &f->piece);
}

double flk_follow_skips(const flk_follower *f)
{
    return f->skipped > 0 && fabs(f->piece.to - f->motion.period) < CLOSE
               ? floor(f->skipped / f->motion.period + 0.5)
               : 0;
}

int flk_follow_is_root(flk_piece_end end)
{
    return end == FLK_END_ROOT || end == FLK_END_DEAD || end == FLK_END_LOCK ||
           end == FLK_END_CHANGE_REST;
}

static int is_change(flk_piece_end end)
{
    return end == FLK_END_CHANGE || end == FLK_END_CHANGE_REST;
}

int flk_follow_has_limit(flk_piece_end end)
{
    return end == FLK_END_DEAD || end == FLK_END_POLE || end == FLK_END_LOCK || is_change(end);
}

double flk_follow_corner(const flk_follower *f, double s)
{
    double length = f->piece.to - f->piece.from;

    return s <= 0    ? f->piece.from
           : s >= 1  ? f->piece.to
           : s < 0.5 ? f->piece.from + length * gsl_pow_2(flk_sine(M_PI_2 * s))
                     : f->piece.to - length * gsl_pow_2(flk_sine(M_PI_2 * (1 - s)));
}

double flk_follow_inside(const flk_follower *f, double s)
{
    double turns = f->a->course.period / (2 * M_PI);
    double inside =
        GSL_MIN_DBL(INSIDE * turns + ROUNDED * f->piece.to, (f->piece.to - f->piece.from) / 4);

    return s <= 0   ? f->piece.from + inside
           : s >= 1 ? f->piece.to - inside
                    : flk_follow_corner(f, s);
}

double flk_follow_passed(const flk_follower *f, double s)
{
    int is_end_of_motion =
        (s <= 0 && f->piece.from <= 0) || (s >= 1 && f->piece.to >= f->motion.length);

    return is_end_of_motion ? flk_follow_corner(f, s) : flk_follow_inside(f, s);
}

double flk_follow_rate(const flk_follower *f, double s)
{
    return (f->piece.to - f->piece.from) * M_PI_2 * flk_sine(M_PI * s);
}

/* Places of the second side of an input are beyond those of the first, by this. */
static double beyond(const flk_follower *f)
{
    double width = f->motion.end - f->motion.first;

    return f->motion.one_side > 0 ? (width != 0 ? 2 * width : 1) : 0;
}

static int is_second(const flk_follower *f, double place)
{
    const flk_pieces *x = &f->motion;

    return x->one_side > 0 && fabs(place - x->first) > 1.5 * fabs(x->end - x->first) &&
           place != x->first;
}

/* 1 if what has been passed is on the second side; where that begins, the piece tells. */
static int is_behind(const flk_follower *f, double passed)
{
    double one = f->motion.one_side;

    return one > 0 && f->piece.from >= one && passed >= one;
}

/* The place of the course on the second side of an input. */
static double place_behind(const flk_follower *f, double passed)
{
    const flk_pieces *x = &f->motion;

    return passed >= x->length ? x->end : x->first + x->rate * (passed - x->one_side);
}

double flk_follow_place(const flk_follower *f, double passed)
{
    if (is_behind(f, passed))
        return place_behind(f, passed) + beyond(f);
    if (passed >= (f->motion.one_side > 0 ? f->motion.one_side : f->motion.length))
        return f->motion.end;
    return f->motion.first +
           f->motion.rate * (passed > f->motion.period ? passed + f->skipped : passed);
}

double flk_follow_crank(const flk_follower *f, double place)
{
    const flk_course *c = &f->a->course;
    int second = is_second(f, place);
    flk_actual_row actual;
    fourlink_row row;

    c->type->at(c, f->branch, second ? FOURLINK_FALLING : flk_course_first_side(c),
                second ? place - beyond(f) : place, &row, &actual);
    return row.angle;
}

void flk_follow_ends(const flk_follower *f, double place, double *least, double *most)
{
    double more = is_second(f, place) ? beyond(f) : 0;

    *least = GSL_MIN(f->motion.first, f->motion.end) + more;
    *most = GSL_MAX(f->motion.first, f->motion.end) + more;
}

/* What a row costs, in rows without loads. */
static double cost_of_row(const flk_analysis *a)
{
    return 1 + (double)a->d->machine.n_loads / 15 + (a->d->machine.has_friction ? 20 : 0);
}

int flk_follow_is_over(const flk_follower *f)
{
    return f->a->rows_left <= 0;
}

void flk_follow_row(const flk_follower *f, int needs, double passed, flk_row *row)
{
    if (flk_follow_is_over(f)) {
        memset(row, 0, sizeof *row);
        row->at.status = FOURLINK_LONG_SEARCH;
        return;
    }
    f->a->rows_left -= cost_of_row(f->a);
    if (is_behind(f, passed))
        flk_analysis_along(f->a, needs, f->branch, FOURLINK_FALLING, place_behind(f, passed), row);
    else
        flk_analysis_along(f->a, needs, f->branch, flk_course_first_side(&f->a->course),
                           flk_follow_place(f, passed), row);
}

int flk_follow_is_reached(const flk_follower *f)
{
    flk_row row;

    flk_follow_row(f, 0, 0.5 * (f->piece.from + f->piece.to), &row);
    return row.at.status == FOURLINK_OK;
}

/* ------------------------------------------------------------------------------------------- a column */

void flk_follow_column(flk_follower *f, flk_followed *t, const flk_column *c)
{
    memset(t, 0, sizeof *t);
    t->c = c;
    if (flk_column_quantity(c) == QUANTITY_ANGLE)
        t->turn = flk_unit_from_si(2 * M_PI, f->a->d->units[QUANTITY_ANGLE].unit);
    t->last = t->first = GSL_NAN;
    t->bound = flk_column_bound(c);
    t->is_noise = (flk_column_flags(c) & FOURLINK_OF_ROUNDING) != 0;
    f->motion.has_loads |= !flk_column_is_of_motion(c);
}

double flk_followed_value(const flk_follower *f, const flk_followed *t, double s)
{
    flk_row row;

    flk_follow_row(f, flk_column_need(t->c), flk_follow_passed(f, s), &row);
    return flk_column_value(t->c, &row);
}

/* The whole turns of an angle from one value to another, in its unit. */
static double whole_turns(const flk_followed *t, double from, double to)
{
    return t->turn * flk_cycle_nearest(to - from, t->turn);
}

double flk_followed_nearest(const flk_followed *t, double value, double near)
{
    return t->turn > 0 && !gsl_isnan(near) ? value + whole_turns(t, value, near) : value;
}

double flk_followed_per_period(const flk_followed *t)
{
    return t->turn > 0 && !t->restarts && !gsl_isnan(t->first + t->last)
               ? whole_turns(t, t->first, t->last)
               : 0;
}

double flk_followed_behind_gap(const flk_followed *t, const flk_follower *f)
{
    return t->turn > 0 && !flk_column_counts_turns(t->c) && flk_course_is_periodic(&f->a->course) &&
                   !gsl_isnan(t->first + t->last)
               ? whole_turns(t, t->last, t->first)
               : 0;
}

double flk_followed_change(const flk_followed *t, double from, double to)
{
    return fabs(flk_cycle_beside((to - from) / t->turn, 1));
}

/* Where a force passes through zero its direction jumps by half a turn. */
#define HALF_TURN (0.5 - 1e-6)

int flk_followed_turns_over(const flk_followed *t, double from, double to)
{
    return flk_followed_change(t, from, to) > HALF_TURN;
}

/* ----------------------------------------------------------------------------------------------- limits */

/* Columns at dead positions and change points, where there is no row.
**
** With x the distance from such an end, or at a dead position its root, a column is
**
**    y(x) = P(x) / x^m,   P(x) = p0 + p1 x + p2 x^2 + ...
**
** where m > 0 and p0 != 0 it has a pole; else its limit is p0.  P is the polynomial through rows on one of
** several scales: on small ones it is more exact, but rows so close to the end may be rounding.
*/

#define NODES FLK_LIMIT_NODES
#define SCALES FLK_LIMIT_SCALES

#define EXACT 1e-9 /* error of a limit, of the column's size: its polynomial replaces the column; */
#define KNOWN 1e-6 /* ... the limit is used; */
#define FINITE 1e-3      /* ... the column is known to have one */
#define NEAR_CHANGE 1e-4 /* rad from a change point: rows are rounding error; */
#define LOST_DEAD 1e-4   /* ... from a dead position, for a column without an exact limit; */
#define LOST 1e-2        /* ... from a change point, for such a column */

/* So much of the piece has rows for a limit.  Where all of its rows are rounding error, since a load has
** a corner beside a change point, those beyond the corner know the limits of columns without loads. */
static double half_of(const flk_follower *f, int at_end)
{
    const flk_piece *p = &f->piece;
    double half = 0.5 * (p->to - p->from), rest = at_end ? p->from : f->motion.length - p->to;

    if (is_change(at_end ? p->end : p->begin) && (at_end ? p->begin : p->end) == FLK_END_PLAIN &&
        half < NEAR_CHANGE && rest > 10 * NEAR_CHANGE)
        half = 5 * NEAR_CHANGE;
    return half;
}

/* The largest scale is at most half of the piece.  No two are the same, or rounding would look like a
** pole. */
void flk_limit_rows_near(const flk_follower *f, int needs, int at_end, flk_limit_rows *e)
{
    static const double scales[2][SCALES] = {{0.001, 0.002, 0.008, 0.02, 0.05, 0.1, 0.15, 0.2},
                                             {0.001, 0.004, 0.016, 0.04, 0.08, 0.12, 0.2, 0.3}};
    flk_piece_end end = at_end ? f->piece.end : f->piece.begin;
    double half = half_of(f, at_end);
    int scale, k;

    e->at_end = at_end;
    e->is_root = flk_follow_is_root(end);
    e->is_change = is_change(end);
    e->is_lock = end == FLK_END_LOCK;
    e->least_order =
        end == FLK_END_LOCK ? 2 : 1; /* there forces grow as the inverse of the distance */
    e->greatest_order = end == FLK_END_CHANGE_REST || end == FLK_END_POLE ? 6
                        : end == FLK_END_LOCK                             ? 2
                                                                          : 4;
    e->edge = at_end ? f->piece.to : f->piece.from;
    e->half = half;
    for (scale = 0; scale < SCALES; scale++)
        for (k = 0; k < NODES; k++) {
            double most = (e->is_root ? sqrt(half) : half) * (scale + 1) / SCALES, x;

            x = e->x[scale][k] = GSL_MIN_DBL(most, scales[e->is_root][scale]) * (k + 1) / NODES;
            x = e->is_root ? x * x : x;
            flk_follow_row(f, needs, at_end ? e->edge - x : e->edge + x, &e->row[scale][k]);
        }
}

/* A column, or a component of its vector, in the rows. */
typedef double values[SCALES][NODES];

/* Returns the value at 0 of the polynomial through points.  *error is how much the last point changes
** that, or a part of what the one before does: of a column with other powers of x the last change may be
** small by chance. */
#define CHANCE 1e-3

static double value_at_end(const double *x, const double *y, flk_polynomial *p, double *error)
{
    double value[NODES];
    int k;

    for (p->n = 0, k = 0; k < NODES; k++) {
        flk_polynomial_add(p, x[k], y[k]);
        value[k] = flk_polynomial_value(p, 0);
    }
    *error = GSL_MAX_DBL(fabs(value[NODES - 1] - value[NODES - 2]),
                         CHANCE * fabs(value[NODES - 2] - value[NODES - 3]));
    return value[NODES - 1];
}

/* The same of x^order y on a scale. */
static double extrapolate(const flk_limit_rows *e, values y, int order, int scale,
                          flk_polynomial *p, double *error)
{
    double times[NODES];
    int k;

    for (k = 0; k < NODES; k++)
        times[k] = gsl_pow_int(e->x[scale][k], order) * y[scale][k];
    return value_at_end(e->x[scale], times, p, error);
}

/* The scale on which the limit of x^order y is most exact, the same for both components of a vector. */
typedef struct best {
    double value[2], error, size;
    double reach;
} best;

/* The size of a vector, or of a number with 0. */
static double size_on(const flk_limit_rows *e, values y[2], int n, int order, int scale)
{
    double v = n == 2 ? y[1][scale][NODES - 1] : 0;

    return gsl_pow_int(e->x[scale][NODES - 1], order) * flk_length(y[0][scale][NODES - 1], v);
}

static best best_of(const flk_limit_rows *e, values y[2], int n, int order, flk_polynomial p[2])
{
    flk_polynomial here[2];
    double value[2] = {0, 0}, error[2] = {0, 0}, both;
    int scale, k;
    best b;

    b.value[0] = GSL_NAN;
    b.value[1] = b.size = b.reach = 0;
    b.error = GSL_POSINF;
    for (scale = 0; scale < SCALES; scale++) {
        for (k = 0; k < n; k++)
            value[k] = extrapolate(e, y[k], order, scale, &here[k], &error[k]);
        both = flk_length(error[0], error[1]);
        if (both < b.error) {
            memcpy(b.value, value, sizeof value);
            memcpy(p, here, (size_t)n * sizeof *here);
            b.error = both;
            b.reach = e->x[scale][NODES - 1];
            b.size = size_on(e, y, n, order, scale);
        }
    }
    b.size = GSL_MAX_DBL(b.size, size_on(e, y, n, order, SCALES - 1));
    return b;
}

/* ------------------------------------------------------------------------------------------------ poles */

/* 1 if the rows closest to the end show a finite limit.  Rows farther away may still look like a pole,
** which lies beyond a narrow locked range. */
static int is_finite(const flk_limit_rows *e, values y)
{
    flk_polynomial p;
    double error;

    extrapolate(e, y, 0, 0, &p, &error);
    return e->is_root && error <= FINITE * fabs(y[0][NODES - 1]);
}

/* A pole is the same on two scales, and far greater than the error: on the smallest scales that shows a
** weak one beside a narrow peak.  On one scale it may be known less well if it is not weak. */
#define POLE_SCALE 1
#define WEAK 1e-3 /* of the column there, times x^order */

static int agree(double strength, double error, double other, double error_of_other, double part)
{
    return error < part * fabs(strength) && error_of_other < part * fabs(other) &&
           fabs(strength - other) < GSL_MAX_DBL(part, 0.01) * fabs(strength);
}

static int is_pole(const flk_limit_rows *e, values y, int scale, int order, double *strength)
{
    double size = fabs(gsl_pow_int(e->x[scale][NODES - 1], order) * y[scale][NODES - 1]);
    double error, other, error_of_other;
    flk_polynomial p;

    *strength = extrapolate(e, y, order, scale, &p, &error);
    other = extrapolate(e, y, order, scale + 1, &p, &error_of_other);
    return agree(*strength, error, other, error_of_other, 1e-3) ||
           (scale == POLE_SCALE && fabs(*strength) > WEAK * size &&
            agree(*strength, error, other, error_of_other, 0.1));
}

/* Returns the order of a pole, 0 if there is none; *strength is p0. */
static int find_pole(const flk_limit_rows *e, values y, double *strength)
{
    int scale, order;

    for (scale = 0; scale + 1 < SCALES && !is_finite(e, y); scale++)
        for (order = e->greatest_order; order >= e->least_order; order--)
            if (is_pole(e, y, scale, order, strength))
                return order;
    *strength = 0;
    return 0;
}

/* A number with the sign of a pole, if the rows close to the end grow towards it, and its order by the two
** closest; else 0.  Beside a narrow locked range, or a change point that the links nearly reach, a pole has
** one order close to it and another farther away. */
#define LEAST_ORDER 0.7

static double find_growth(const flk_limit_rows *e, values y, int *order)
{
    const double *x = e->x[0], *near = y[0];
    int k;

    for (k = 0; k + 1 < NODES; k++)
        if (!(near[k] / near[k + 1] > pow(x[k + 1] / x[k], LEAST_ORDER)))
            return 0;
    *order = (int)floor(log(near[0] / near[1]) / log(x[1] / x[0]) + 0.5);
    return x[0] * near[0];
}

/* The same where a number is added, which may be larger, and the order is none of the usual ones, as 3/2
** of a load with an exponent: the differences of the rows close to the end grow as those of a pole do. */
static double find_growth_of_steps(const flk_limit_rows *e, values y, int *order)
{
    double power[NODES], step = 0, last, first = y[0][0] - y[0][1], ratio;
    int k;

    for (k = 0; k < NODES; k++)
        power[k] = pow(e->x[0][k], -LEAST_ORDER);
    for (k = NODES - 2; k >= 0; k--) {
        last = step;
        step = y[0][k] - y[0][k + 1];
        ratio = k + 2 < NODES ? (power[k] - power[k + 1]) / (power[k + 1] - power[k + 2]) : 0;
        if (k + 2 < NODES && !(step / last > ratio))
            return 0;
    }
    last = y[0][1] - y[0][2];
    *order = (int)floor(log(first / last) / log(5.0 / 3) - 0.75);
    return fabs(first) > FINITE * fabs(y[0][NODES - 1]) ? e->x[0][0] * first : 0;
}

/* The order q of a pole, which a load with an exponent makes any number.  Of
**
**    y(x) = S x^-q + ... ,   steps y(x) - y(2x), y(2x) - y(4x), ...
**
** have a ratio that tends to 2^q, by powers of x.  NaN if it is not known. */
#define HALVES 7
#define SURE_OF_ORDER 0.01

static int rows_by_halves(const flk_limit_rows *e, values y, double of[HALVES + 1])
{
    int n = 0, scale, k;

    for (scale = 0; scale < SCALES; scale++)
        for (k = 0; k < NODES && n <= HALVES; k++)
            if (fabs(e->x[scale][k] / ldexp(e->x[0][0], n) - 1) < 1e-6)
                of[n++] = y[scale][k];
    return n > HALVES;
}

static double order_of_ratios(const double *y)
{
    double ratio[HALVES - 2];
    int k;

    for (k = 0; k < HALVES - 2; k++)
        ratio[HALVES - 3 - k] = (y[k] - y[k + 1]) / (y[k + 1] - y[k + 2]);
    return log(flk_limit_of_sequence(ratio, HALVES - 2)) / M_LN2;
}

static double find_order(const flk_limit_rows *e, values y)
{
    double of[HALVES + 1], near, far;

    if (!rows_by_halves(e, y, of))
        return GSL_NAN;
    near = order_of_ratios(of);
    far = order_of_ratios(of + 1);
    if (!(near > 0 && fabs(near - far) < SURE_OF_ORDER))
        return GSL_NAN;
    return fabs(near - floor(near + 0.5)) < SURE_OF_ORDER ? floor(near + 0.5) : near;
}

/* A weak one is seen by that order alone. */
#define LEAST_STEP 1e-6 /* of the column */
#define LEAST_FOUND 0.3

static double find_growth_of_ratios(const flk_limit_rows *e, values y, int *order)
{
    double first = y[0][0] - y[0][1], q = find_order(e, y);

    if (!(q > LEAST_FOUND && fabs(first) > LEAST_STEP * fabs(y[0][0])))
        return 0;
    *order = (int)floor(q + 0.5);
    return e->x[0][0] * first;
}

/* A pole of a component: a number with its sign, else 0; its order in x by the rows close to the end;
** and the order `of_scale` on the scale on which it was found, 0 if on none.  Where rows of a finite
** column are differences of unbounded forces, their rounding error grows as these do: steps no larger
** than that are none of a pole. */
static double find_pole_of(const flk_limit_rows *e, values y, int has_direction, double rounding,
                           int *order, int *of_scale)
{
    int may_grow = !has_direction && e->is_root && fabs(y[0][0] - y[0][1]) > rounding;
    double strength, growth;

    *order = *of_scale = find_pole(e, y, &strength);
    growth = has_direction ? 0 : find_growth(e, y, order);
    if (growth == 0 && strength == 0 && may_grow)
        growth = find_growth_of_steps(e, y, order);
    if (growth == 0 && strength == 0 && may_grow)
        growth = find_growth_of_ratios(e, y, order);
    return growth != 0 ? growth : strength;
}

/* ----------------------------------------------------------------------------------------- their values */

/* A column that is zero within rounding can seem to have a pole, such as alpha3 of a crank and a rod of
** the same length where alpha2 is 0. */
#define LEAST_POLE 1e-11 /* of the column's size elsewhere, at 1 rad: less is rounding error, */
#define SURELY \
    2 /* ... unless the row closest to the end is so many times that size, and rows grow as a pole's do */

static int is_surely_pole(const flk_limit_rows *e, values y, int order, double size)
{
    int of_steps;

    return order > 0 && size > 0 && fabs(y[0][0]) > SURELY * size &&
           find_growth_of_steps(e, y, &of_steps) != 0 && of_steps == order;
}

/* The values in the rows, in the column's unit; the components of a direction in SI. */
static void take_column(const flk_limit_rows *e, const flk_followed *t, int is_vector, values y[2])
{
    double factor = t->turn > 0 ? 1 : t->c->scale, last = GSL_NAN;
    int scale, k;

    for (scale = 0; scale < SCALES; scale++)
        for (k = 0; k < NODES; k++)
            if (is_vector) {
                flk_column_vector(t->c, &e->row[scale][k], &y[0][scale][k], &y[1][scale][k]);
                y[0][scale][k] *= factor;
                y[1][scale][k] *= factor;
            } else {
                y[0][scale][k] =
                    flk_followed_nearest(t, flk_column_value(t->c, &e->row[scale][k]), last);
                last = y[0][scale][k];
            }
}

/* The column at x, by its own polynomial or those of its vector's components. */
static double join(const flk_limit *l, const flk_followed *t, double x, double near)
{
    double u = flk_polynomial_value(&l->of[0], x), v;

    if (l->n == 1)
        return u / gsl_pow_int(x, l->order);
    v = flk_polynomial_value(&l->of[1], x);
    return t->turn > 0 ? flk_followed_nearest(t, flk_angle(v, u) * t->c->scale, near)
                       : flk_length(u, v) / gsl_pow_int(x, l->order);
}

#define VANISHES \
    1e-6 /* of a vector's size: a smaller one has no direction; it is taken at this part */
#define BESIDE 1e-3 /* ... of the reach */

/* The limit of a column without a pole, or of the direction of a vector that may have one.  Its polynomial
** replaces rows that can be rounding error; in a short piece directions turn closer to the end. */
static void find_finite(const flk_limit_rows *e, const flk_followed *t, values y[2], const best *b,
                        double size, flk_limit *l)
{
    int is_direction = t->turn > 0;
    double lost = e->is_change ? LOST : LOST_DEAD * (is_direction ? GSL_MIN_DBL(e->half, 1) : 1);
    double least;
    double reach = GSL_MIN_DBL(b->reach, e->is_root ? sqrt(lost) : lost);

    size = GSL_MAX_DBL(b->size, is_direction ? 0 : size);
    least = GSL_MAX_DBL(4 * b->error, EXACT * size);
    if (!is_direction)
        l->rough = reach;
    if (b->error <= ((e->is_change || e->is_lock) && !is_direction ? KNOWN : EXACT) * size) {
        l->reach = reach;
        lost = e->is_root ? gsl_pow_2(reach) : reach;
    }
    if (b->error > EXACT * size && (e->is_change || !is_finite(e, y[0])))
        l->rounded = lost;
    if (l->n == 2 && is_direction) {
        double length = flk_length(b->value[0], b->value[1]);

        if (b->error <= KNOWN * size)
            l->value = join(l, t, length > VANISHES * b->size ? 0 : BESIDE * b->reach, GSL_NAN);
        return;
    }
    if (b->error <= KNOWN * size)
        l->value = l->n == 2 ? flk_length(b->value[0], b->value[1]) : b->value[0];
    if (fabs(l->value) <= least)
        l->value = 0; /* such as the transmission angle at a dead position */
}

/* A load over a speed with an exponent such as 3/2 gives a column that has powers of the root of x.  Its
** value at the end by a polynomial in that. */
static double extrapolate_in_root(const double *x, const double *y, double *error)
{
    double root[NODES];
    flk_polynomial p;
    int k;

    for (k = 0; k < NODES; k++)
        root[k] = sqrt(x[k]);
    return value_at_end(root, y, &p, error);
}

/* A direction, of a vector whose components are P(root of x) / x^(k / 2): where k is the order of the
** vector's pole, the values of both P at the end are not 0, and have it.  Unlike those of the unit
** vector their polynomials are as exact where the direction turns over close to the end.  1 if it is
** known with an error below `least`, rad. */
static int direction_in_root(const flk_limit_rows *e, values y[2], double least, double *angle)
{
    double value[2], error[2], times[2][NODES], length, doubt;
    int scale, order, i, k, is_known = 0;

    for (order = 2 * e->greatest_order; order >= 0 && !is_known; order--)
        for (scale = 0; scale < SCALES; scale++) {
            for (i = 0; i < 2; i++) {
                for (k = 0; k < NODES; k++)
                    times[i][k] = gsl_pow_int(sqrt(e->x[scale][k]), order) * y[i][scale][k];
                value[i] = extrapolate_in_root(e->x[scale], times[i], &error[i]);
            }
            length = flk_length(value[0], value[1]);
            doubt = (fabs(value[0]) * error[1] + fabs(value[1]) * error[0]) / gsl_pow_2(length);
            if (!(doubt <= least && flk_length(error[0], error[1]) <= FINITE * length))
                continue;
            least = doubt;
            is_known = 1;
            *angle = flk_angle(value[1], value[0]);
        }
    return is_known;
}

/* Take such a limit if it is known with an error below `least`.  Then rows beside the end are exact. */
static void take_limit_in_root(const flk_limit_rows *e, const flk_followed *t, values y[2],
                               double size, double least, flk_limit *l)
{
    double value[2] = {0, 0}, error[2] = {0, 0}, of;
    int scale;

    if (l->n == 2 && t->turn > 0) {
        if (direction_in_root(e, y, least, &l->value)) {
            l->value *= t->c->scale;
            l->rounded = 0;
        }
        return;
    }
    for (scale = 0; scale < SCALES; scale++) {
        value[0] = extrapolate_in_root(e->x[scale], y[0][scale], &error[0]);
        if (l->n == 2)
            value[1] = extrapolate_in_root(e->x[scale], y[1][scale], &error[1]);
        of = GSL_MAX_DBL(size, flk_length(value[0], value[1]));
        if (!(flk_length(error[0], error[1]) <= least * of))
            continue;
        least = flk_length(error[0], error[1]) / of;
        l->rounded = 0;
        l->value = l->n == 2 ? flk_length(value[0], value[1]) : value[0];
    }
}

void flk_limit_none(flk_limit *l)
{
    memset(l, 0, sizeof *l);
    l->reach = l->rough = -1;
    l->value = GSL_NAN;
}

void flk_limit_of_crank(const flk_limit_rows *e, flk_limit *l)
{
    flk_limit_none(l);
    l->edge = e->edge;
    l->is_root = e->is_root;
    l->rounded = e->is_change ? NEAR_CHANGE : 0;
}

/* ... as distance^-growth, of a pole with this order, as nearly as that is known. */
static double growth_of(const flk_limit_rows *e, values y, int order)
{
    double q = e->least_order < e->greatest_order ? find_order(e, y) : GSL_NAN;

    if (gsl_isnan(q))
        q = GSL_MAX_INT(order, e->least_order);
    return e->is_root ? q / 2 : q;
}

#define ROUNDING (4 * DBL_EPSILON) /* of a row, times the size of its forces */

/* Where friction locks, what has no friction in it grows by rounding error only. */
static int may_have_pole(const flk_limit_rows *e, const flk_followed *t)
{
    int flags = flk_column_flags(t->c);

    return !e->is_lock || (flags & FOURLINK_OF_FORCES && !(flags & FOURLINK_FRICTIONLESS));
}

void flk_limit_find(const flk_limit_rows *e, const flk_followed *t, double size, double scale,
                    flk_limit *l)
{
    int is_vector = flk_column_has_vector(t->c), has_pole = 0, k, order, of_scale;
    double strength;
    values y[2];
    best b;

    take_column(e, t, is_vector, y);
    flk_limit_of_crank(e, l);
    l->n = is_vector ? 2 : 1;
    l->reach = 0;
    for (k = 0; k < l->n && (is_vector || !(t->turn > 0)) && may_have_pole(e, t); k++) {
        strength = find_pole_of(e, y[k], t->turn > 0, ROUNDING * scale, &order, &of_scale);
        if (t->turn <= 0 && fabs(strength) <= LEAST_POLE * size &&
            !is_surely_pole(e, y[k], of_scale, size))
            continue;
        has_pole |= strength != 0;
        l->order = GSL_MAX_INT(l->order, of_scale);
        l->growth = GSL_MAX_DBL(l->growth, growth_of(e, y[k], order));
        if (t->turn <= 0)
            l->value = strength > 0 || is_vector ? GSL_POSINF : GSL_NEGINF;
    }
    b = best_of(e, y, l->n, l->order, l->of);
    if (!has_pole || (is_vector && t->turn > 0))
        find_finite(e, t, y, &b, size, l);
    else if (is_vector && l->order > 0 && b.error <= EXACT * b.size)
        l->reach = b.reach;
    if (e->is_root && (t->turn > 0 ? is_vector && !e->is_change : 1) &&
        (gsl_isnan(l->value) || (gsl_finite(l->value) && !(b.error <= EXACT * b.size))))
        take_limit_in_root(e, t, y, size, gsl_isnan(l->value) ? KNOWN : b.error / b.size, l);
    if (gsl_isnan(l->value) && !has_pole && !is_vector && is_finite(e, y[0]) &&
        !(find_order(e, y[0]) > 0))
        l->value = y[0][0][0];
}

static double value_within(double reach, const flk_limit *l, const flk_followed *t, double passed,
                           double near)
{
    double x = fabs(passed - l->edge);

    x = l->is_root ? sqrt(x) : x;
    if (!(x <= reach))
        return GSL_NAN;
    return x > 0 ? join(l, t, x, near) : l->value;
}

double flk_limit_value(const flk_limit *l, const flk_followed *t, double passed, double near)
{
    return value_within(l->reach, l, t, passed, near);
}

double flk_limit_rough(const flk_limit *l, const flk_followed *t, double passed)
{
    return value_within(l->rough, l, t, passed, GSL_NAN);
}
