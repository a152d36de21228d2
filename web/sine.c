/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sine.c - sine and cosine, rounded to the nearest number but for one in a million.
**
** Those of Emscripten differ from the GNU C library's in the last digit, now and then, and near a dead position that
** grows.  The linker puts these in their places.  They compute with pairs of numbers, of which the second is the
** rest that the first leaves: T. J. Dekker, "A floating-point technique for extending the available precision",
** Numerische Mathematik 18 (1971), 224-242.
*/
#include <math.h>

double __real_sin(double x);
double __real_cos(double x);
double __wrap_sin(double x);
double __wrap_cos(double x);

typedef struct pair {
    double high, low;
} pair;

/* Dekker, section 4: x + y without an error. */
static pair sum_of(double x, double y)
{
    pair s;
    double z;

    s.high = x + y;
    z = s.high - x;
    s.low = (x - (s.high - z)) + (y - z);
    return s;
}

/* Dekker, eq. (5.12): x y without an error. */
static pair product_of(double x, double y)
{
    const double split = 134217729.0; /* 2^27 + 1 */
    double p = x * split, q = y * split, hx, hy, tx, ty;
    pair s;

    hx = (x - p) + p;
    hy = (y - q) + q;
    tx = x - hx;
    ty = y - hy;
    s.high = x * y;
    s.low = ((hx * hy - s.high) + hx * ty + tx * hy) + tx * ty;
    return s;
}

static pair add(pair x, pair y)
{
    pair s = sum_of(x.high, y.high);

    return sum_of(s.high, s.low + x.low + y.low);
}

static pair multiply(pair x, pair y)
{
    pair s = product_of(x.high, y.high);

    return sum_of(s.high, s.low + (x.high * y.low + x.low * y.high));
}

static pair divide(pair x, double y)
{
    double q = x.high / y;
    pair p = product_of(q, y);

    return sum_of(q, ((x.high - p.high) - p.low + x.low) / y);
}

/* x = n pi/2 + r, |r| <= pi/4 */
static pair reduce(double x, double n)
{
    /* pi/2 in three parts */
    pair r = product_of(-n, 1.5707963267948966), p = product_of(-n, 6.123233995736766e-17);
    pair d = sum_of(x, r.high);

    d.low += -n * -1.4973849048591833e-33;
    return add(add(d, sum_of(r.low, 0)), p);
}

/* sin r = r - r^3/3! + r^5/5! ..., cos r = 1 - r^2/2! + r^4/4! ...; k = 27 or 28, the last power.  Powers above 8 are
** too small for the rest of a pair to matter. */
static pair series(pair r, int k)
{
    pair square = multiply(r, r), sum = {1, 0}, one = {1, 0};

    for (; k > 8; k -= 2)
        sum.high = 1 - square.high * sum.high / ((double)k * (k - 1));
    for (; k > 1; k -= 2) {
        sum = divide(multiply(square, sum), -(double)k * (k - 1));
        sum = add(one, sum);
    }
    return sum;
}

/* Of the angle x + quarters pi/2, by the sine. */
static double sine(double x, int quarters)
{
    double n = floor(x / 1.5707963267948966 + 0.5);
    int quadrant = (int)(n - 4 * floor(n / 4)) + quarters;
    pair r = reduce(x, n), s;

    s = quadrant % 2 ? series(r, 28) : multiply(r, series(r, 27));
    return quadrant / 2 % 2 ? -(s.high + s.low) : s.high + s.low;
}

#define LARGEST 1e8 /* rad; beyond, and for NaN, those of the library */

double __wrap_sin(double x)
{
    return fabs(x) <= LARGEST && x != 0 ? sine(x, 0) : __real_sin(x);
}

double __wrap_cos(double x)
{
    return fabs(x) <= LARGEST ? sine(x, 1) : __real_cos(x);
}
