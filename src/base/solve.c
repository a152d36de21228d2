/* SPDX-License-Identifier: GPL-3.0-or-later
**
** solve.c - zeros, peaks and integrals of a function of one variable.
**
** Zeros: false position that halves the value at an end that is kept (the Illinois method; M. Dowell, P.
** Jarratt, A modified regula falsi method, BIT 11, 1971, p. 168), and bisection where only the sign of the
** function is known.  The zero of an increasing function is found by the secant method from a guess.
** Peaks: parabolas and golden section, after R. P. Brent, Algorithms for Minimization without Derivatives,
** 1973, ch. 5.
** Integrals: the rule of Gauss and Kronrod with 7 and 15 points (R. Piessens et al., QUADPACK, 1983), and
** Gauss's with 5.
*/
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "solve.h"

#define ITERATIONS 200
#define GOLDEN 0.38196601125010515 /* (3 - sqrt(5)) / 2 */
#define NARROWEST 1e-12 /* part of the interval: of a corner; a smooth peak is found before */

flk_bracket flk_bracket_of(double low, double high, double f_low, double f_high)
{
    flk_bracket b;

    b.low = low;
    b.high = high;
    b.f_low = f_low;
    b.f_high = f_high;
    b.side = 0;
    return b;
}

/* x = a - f(a) (b - a) / (f(b) - f(a)) */
double flk_bracket_next(const flk_bracket *b)
{
    return gsl_finite(b->f_low) && gsl_finite(b->f_high)
               ? b->low - b->f_low * (b->high - b->low) / (b->f_high - b->f_low)
               : 0.5 * (b->low + b->high);
}

void flk_bracket_take(flk_bracket *b, double x, double f, int is_rising)
{
    if ((f < 0) == is_rising) {
        b->low = x;
        b->f_low = f;
        b->f_high *= b->side == -1 ? 0.5 : 1;
        b->side = gsl_finite(f) ? -1 : 0;
    } else {
        b->high = x;
        b->f_high = f;
        b->f_low *= b->side == 1 ? 0.5 : 1;
        b->side = gsl_finite(f) ? 1 : 0;
    }
}

/* A place beside an end, where false position stays at it: the zero is there within rounding, or the function
** is steep. */
static double beside_end(const flk_bracket *b, double next)
{
    double little = DBL_EPSILON * GSL_MAX_DBL(fabs(b->low), fabs(b->high));

    return next > b->low ? b->high - little : b->low + little;
}

double flk_find_zero(flk_function *f, void *data, flk_bracket *b, double close)
{
    double x = fabs(b->f_low) < fabs(b->f_high) ? b->low : b->high, value;
    int is_rising = b->f_low < 0, is_beside = 0, k;

    if (b->f_low == 0 || b->f_high == 0)
        return x;
    for (k = 0; k < ITERATIONS && b->high - b->low > DBL_EPSILON * fabs(b->high); k++) {
        double next = is_beside ? 0.5 * (b->low + b->high) : flk_bracket_next(b);

        is_beside = !(next > b->low && next < b->high);
        if (is_beside)
            next = beside_end(b, next);
        if (!(next > b->low && next < b->high))
            break;
        x = next;
        value = f(x, data);
        if (gsl_isnan(value) || fabs(value) <= close)
            break;
        flk_bracket_take(b, x, value, is_rising);
    }
    return x;
}

int flk_find_rising(flk_function *f, void *data, flk_rising *r, double close, double rounded)
{
    flk_bracket b = flk_bracket_of(r->x, r->x, GSL_POSINF, GSL_NEGINF);
    double last = GSL_NAN, from = r->x, longest = r->longest, step = GSL_POSINF, off;
    int is_near, stuck = 0, k;

    for (k = 0; k < ITERATIONS; k++, longest *= 2) {
        double value = f(r->x, data), before = fabs(step), slope = (value - last) / (r->x - from);

        if (gsl_isnan(value))
            return 0;
        r->slope = slope > 0 && gsl_finite(slope) ? slope : r->slope;
        step = -value / r->slope;
        off = GSL_MAX_DBL(fabs(value), fabs(step));
        is_near = fabs(value) <= close || off <= rounded;
        stuck += is_near && fabs(step) > 0.5 * before;
        if (off <= close || stuck > 2)
            return 1;
        flk_bracket_take(&b, r->x, value, 1);
        last = value;
        from = r->x;
        if (b.f_low < 0 && b.f_high > 0 && b.high - b.low <= close * (1 + fabs(b.high)))
            return is_near ||
                   (fabs(value) <= rounded && gsl_finite(b.f_low) && gsl_finite(b.f_high));
        r->x += GSL_MAX(-longest, GSL_MIN(step, longest));
        if (b.f_low < 0 && b.f_high > 0 && !(b.low < r->x && r->x < b.high))
            r->x = flk_bracket_next(&b);
    }
    return 0;
}

/* At the distance t from the best place the parabola through the three points is f + s t - c t^2.  Its top is
** at s / (2 c), higher by s^2 / (4 c).  If it is not higher, or parabolas converge slowly, the longer side is
** divided by golden section or, if it is much longer, closer to the best place. */
flk_sample flk_find_peak(flk_function *f, void *data, const flk_sample p[3], double close)
{
    flk_sample low = p[0], best = p[1], high = p[2], next;
    double length = high.x - low.x, narrowest = NARROWEST * length, before = GSL_POSINF;
    int is_top = 0, was_top, equal = 0, k;

    for (k = 0; k < ITERATIONS && length > narrowest && best.value < GSL_POSINF; k++) {
        double a = best.x - low.x, b = high.x - best.x;
        double rise = (best.value - low.value) / a, fall = (best.value - high.value) / b;
        double c = (rise + fall) / length, s = rise - c * a, step = s / (2 * c);

        was_top = is_top;
        is_top = s * step / 2 <= close;
        if ((is_top && was_top) || equal > 1)
            break;
        if (is_top || length > 0.5 * before || !(-a < step && step < b))
            step = (b > a ? GOLDEN : -GOLDEN) *
                   sqrt(GSL_MAX_DBL(a, narrowest) * GSL_MAX_DBL(b, narrowest));
        next.x = best.x + step;
        next.value = f(next.x, data);
        equal += fabs(next.value - best.value) <= close;
        if (next.value > best.value) {
            *(step > 0 ? &low : &high) = best;
            best = next;
        } else {
            *(step > 0 ? &high : &low) = next;
        }
        before = length;
        length = high.x - low.x;
    }
    return best;
}

double flk_integrate_smooth(flk_function *f, void *data, double from, double to)
{
    static const double nodes[5][2] = {{-0.90617984593866399280, 0.23692688505618908751},
                                       {-0.53846931010568309104, 0.47862867049936646804},
                                       {0, 0.56888888888888888889},
                                       {0.53846931010568309104, 0.47862867049936646804},
                                       {0.90617984593866399280, 0.23692688505618908751}};
    double middle = 0.5 * (from + to), half = 0.5 * (to - from), value = 0;
    int k;

    for (k = 0; k < 5; k++)
        value += half * nodes[k][1] * f(middle + half * nodes[k][0], data);
    return value;
}

/* Nodes x >= 0, the weights of Kronrod's rule and those of Gauss's.  The difference of these rules is 0 for a
** polynomial of degree 13 and, by chance, for a corner at some places.  So is the last rule, odd in x, but at
** others: its weights are
**
**    u_k ~ 1 / (x_k product of (x_k^2 - x_m^2) over m != k)
**
** with the same sum of squares as the difference has.  (Berntsen and Espelid, Error estimation in automatic
** quadrature routines, ACM TOMS 17, 1991: null rules.) */
#define NODES 8

static const double rule[NODES][4] = {
    {0, 0.20948214108472782801, 0.41795918367346938776, 0},
    {0.2077849550078984676, 0.20443294007529889241, 0, 0.08496897797496098113},
    {0.40584515137739716691, 0.19035057806478540991, 0.38183005050511894495,
     -0.15544544677694771727},
    {0.58608723546769113029, 0.16900472663926790283, 0, 0.19813287215599927714},
    {0.74153118559939443986, 0.14065325971552591875, 0.2797053914892766679,
     -0.20625405374029580944},
    {0.86486442335976907279, 0.10479001032225018384, 0, 0.18128561200539535322},
    {0.94910791234275852453, 0.063092092629978553291, 0.12948496616886969327,
     -0.12604699052602075645},
    {0.99145537112081263921, 0.022935322010529224964, 0, 0.04548554819351267003},
};

void flk_integrate(flk_functions *f, void *data, int n, double from, double to, flk_integral *of)
{
    double middle = 0.5 * (from + to), half = 0.5 * (to - from), y[FLK_INTEGRALS];
    double odd[FLK_INTEGRALS] = {0, 0, 0};
    int i, k;

    memset(of, 0, (size_t)n * sizeof *of);
    for (k = 1 - NODES; k < NODES; k++) {
        const double *at = rule[abs(k)];

        f(k < 0 ? middle - half * at[0] : middle + half * at[0], data, y);
        for (i = 0; i < n; i++) {
            of[i].value += half * at[1] * y[i];
            of[i].size += fabs(half * at[1] * y[i]);
            of[i].error += half * (at[1] - at[2]) * y[i];
            odd[i] += half * (k < 0 ? -at[3] : at[3]) * y[i];
        }
    }
    for (i = 0; i < n; i++)
        of[i].error = fabs(of[i].error) + fabs(odd[i]);
}

/* Wynn's epsilon algorithm (On a device for computing the e_m(S_n) transformation, MTAC 10, 1956):
**
**    e_(k+1)(i) = e_(k-1)(i+1) + 1 / (e_k(i+1) - e_k(i)),   e_-1 = 0, e_0 the sequence
**
** of which those with k even are limits.  Number m of the sequence adds e_(m-i)(i) for i = m ... 0, in
** the place of e_(m-1-i)(i). */
double flk_limit_of_sequence(double *of, int n)
{
    double before, here, difference;
    int m, i;

    for (m = 1; m < n; m++)
        for (before = 0, i = m - 1; i >= 0; i--) {
            difference = of[i + 1] - of[i];
            if (difference == 0)
                return of[(m - i) % 2 ? i + 1 : i + 2];
            here = of[i];
            of[i] = before + 1 / difference;
            before = here;
        }
    return of[0];
}
