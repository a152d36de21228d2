/* SPDX-License-Identifier: GPL-3.0-or-later
**
** trig.c - sine, cosine, arc tangent and what follows from them, with the same bits on every machine.
**
** The polynomials are the best ones of their degree for the relative error of the result, found by Remez's
** exchange with 300 bits; the coefficients are rounded to doubles.
*/
#include <float.h>
#include <math.h>

#include "arithmetic.h"
#include "trig.h"

/* Squares and products of numbers between these neither overflow nor lose bits. */
#define SMALL 1e-140
#define LARGE 1e140

/* The rounding error of a sum s = x + y, exactly (Knuth, The Art of Computer Programming, vol. 2, 4.2.2). */
static double lost_in_sum(double x, double y, double s)
{
    double y_part = s - x, x_part = s - y_part;

    return (x - x_part) + (y - y_part);
}

/* The rounding error of a product p = x y, exactly: of halves that have 26 bits each, all products are exact
** (Dekker, A floating-point technique for extending the available precision, 1971). */
static double lost_in_product(double x, double y, double p)
{
    double c = 134217729 * x, d = 134217729 * y, x_high = c - (c - x), y_high = d - (d - y);
    double x_low = x - x_high, y_low = y - y_high;

    return ((x_high * y_high - p) + x_high * y_low + x_low * y_high) + x_low * y_low;
}

/* ------------------------------------------------------------------------------------ sine and cosine */

#define LARGEST 1e9
#define TURN 6.2831853071795862            /* 2 pi, rounded */
#define BEYOND_TURN 2.4492935982947064e-16 /* 2 pi - TURN */
#define TWO_OVER_PI 0.63661977236758138

/* pi / 2 in parts. The first four have 23 bits, so that their products with an integer below 2^30 are exact;
** what all five leave is less than 2^-147. */
static const double half_pi[5] = {1.5707962512969971, 7.5497894158615964e-08,
                                  5.3903025299577648e-15, 3.2820031633724233e-22,
                                  3.7950107727212251e-29};

/* x = n pi / 2 + r + rest, with |r| at most a little more than pi / 4 and a rest that is much smaller. The
** first two differences are exact: both sides are multiples of the last bit of x or of a part, and the
** difference has no more than 53 bits of these. */
static double reduce(double x, int *n, double *rest)
{
    double k, y, s, r;

    *n = (int)(x * TWO_OVER_PI + (x < 0 ? -0.5 : 0.5));
    k = *n;
    y = (x - k * half_pi[0]) - k * half_pi[1];
    s = y - k * half_pi[2];
    r = s - k * half_pi[3];
    *rest =
        (lost_in_sum(y, -k * half_pi[2], s) + lost_in_sum(s, -k * half_pi[3], r)) - k * half_pi[4];
    return r;
}

/* A larger angle without its turns.  The rest of x / TURN is exact; what the turns are longer than TURN
** is subtracted as often as there are turns, and may be large itself.  The error, below 1e-15 + 3e-32
** |x|, is far below the distance of doubles beside x. */
static double without_turns(double x)
{
    double r;

    while (fabs(x) > LARGEST) {
        r = fmod(x, TURN);
        x = r - (x - r) / TURN * BEYOND_TURN;
    }
    return x;
}

/* With z = r^2,
**
**    sin(r + rest) = r + [r z P(z) + rest (1 - z / 2)]
**    cos(r + rest) = 1 - z / 2 + [z^2 Q(z) - r rest]
**
** and the rounding error of 1 - z / 2 added to the bracket. */
void flk_sine_cosine(double x, double *sine, double *cosine)
{
    double r, rest, z, z2, half, near_one, s, c;
    int n;

    if (!(fabs(x) <= DBL_MAX)) {
        *sine = *cosine = x - x; /* NaN */
        return;
    }
    r = reduce(without_turns(x), &n, &rest);
    z = r * r;
    z2 = z * z;
    half = 0.5 * z;
    near_one = 1 - half;
    s = (-0.16666666666666632 + z * 0.0083333333333224131) +
        z2 * ((-0.00019841269829807819 + z * 2.7557313691921887e-06) +
              z2 * (-2.5050758115840255e-08 + z * 1.589679568451575e-10));
    c = (0.041666666666666602 + z * -0.0013888888888874125) +
        z2 * ((2.4801587289482184e-05 + z * -2.7557314352332913e-07) +
              z2 * (2.0875723273266597e-09 + z * -1.135964780614387e-11));
    s = r + (r * z * s + rest * near_one);
    c = near_one + (((1 - near_one) - half) + (z2 * c - r * rest));
    *sine = n & 1 ? c : s;
    *cosine = n & 1 ? s : c;
    *sine = n & 2 ? -*sine : *sine;
    *cosine = (n + 1) & 2 ? -*cosine : *cosine;
}

double flk_sine(double x)
{
    double sine, cosine;

    flk_sine_cosine(x, &sine, &cosine);
    return sine;
}

double flk_cosine(double x)
{
    double sine, cosine;

    flk_sine_cosine(x, &sine, &cosine);
    return cosine;
}

/* ------------------------------------------------------------------------------------------ arc tangent */

/* An angle in two parts, of which the second has the bits that the first has no room for. */
typedef struct angle {
    double high, low;
} angle;

/* The angle of (x, y) for 0 <= y <= x, x > 0, as atan(c) + atan(t), with c = 0, 1/2 or 1 so that |t| <= 1/4:
**
**    t = (y - c x) / (x + c y),   atan(t) = t + t^3 P(t^2)
**
** The numerator is exact, since y and c x differ by a factor of at most 2; the rounding errors of denominator
** and quotient are known, and give t a second part. */
static angle of_first_octant(double y, double x)
{
    static const angle of_c[3] = {{0, 0},
                                  {0.46364760900080609, 2.2698777452961687e-17},
                                  {0.78539816339744828, 3.0616169978683831e-17}};
    int i = (y > 0.25 * x) + (y > 0.72 * x);
    double c = 0.5 * i, cy = c * y, n = y - c * x, d = x + cy, inverse = 1 / d, t = n * inverse,
           p = t * d, z = t * t;
    double rest = (n - p) - lost_in_product(t, d, p) - t * ((x - d) + cy), curve;
    angle a;

    curve = (-0.33333333333332543 + z * 0.19999999999586682) +
            z * z *
                ((-0.14285714211987599 + z * 0.11111104741957636) +
                 z * z *
                     ((-0.09090603911057113 + z * 0.076837459309104725) +
                      z * z * (-0.065259675964982097 + z * 0.046084362919831652)));
    a.high = of_c[i].high + t;
    a.low = ((of_c[i].high - a.high) + t) + (of_c[i].low + t * z * curve + rest * inverse);
    return a;
}

/* From the first octant to all, with a the angle there:
**
**    a    pi/2 - a beyond the diagonal    pi - a on the left    pi/2 + a in both cases
*/
double flk_angle(double y, double x)
{
    static const angle start[3] = {{0, 0},
                                   {1.5707963267948966, 6.123233995736766e-17},
                                   {3.1415926535897931, 1.2246467991473532e-16}};
    double up = fabs(y), along = fabs(x), sum, result;
    int is_steep = up > along, is_left = x < 0;
    const angle *from = &start[is_steep ? 1 : 2 * is_left];
    angle a;

    if (!(up >= SMALL && up <= LARGE && along <= LARGE))
        return atan2(y, x);
    a = of_first_octant(is_steep ? along : up, is_steep ? up : along);
    if (is_steep != is_left) {
        a.high = -a.high;
        a.low = -a.low;
    }
    sum = from->high + a.high;
    result = sum + (((from->high - sum) + a.high) + (from->low + a.low));
    return y < 0 ? -result : result;
}

double flk_arc_sine(double x)
{
    return flk_angle(x, sqrt((1 - x) * (1 + x)));
}

double flk_arc_cosine(double x)
{
    return flk_angle(sqrt((1 - x) * (1 + x)), x);
}

/* ----------------------------------------------------------------------------------------------- length */

double flk_length(double x, double y)
{
    double longer = fabs(x), shorter = fabs(y), swap;

    if (!(longer >= shorter)) {
        swap = longer;
        longer = shorter;
        shorter = swap;
    }
    if (longer >= SMALL && longer <= LARGE)
        return sqrt(longer * longer + shorter * shorter);
    if (longer == 0 || !(longer <= DBL_MAX))
        return longer + shorter;
    shorter /= longer;
    return longer * sqrt(1 + shorter * shorter);
}
