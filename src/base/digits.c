/* SPDX-License-Identifier: GPL-3.0-or-later
**
** digits.c - numbers to text by exact products.
**
** printf uses integers of any length.  For numbers of common size a few operations in double are enough.  A
** product of two doubles is exactly high + low, where high is the rounded product and low its rounding error;
** Dekker's method finds low with doubles alone (T. J. Dekker, A floating-point technique for extending the
** available precision, Numer. Math. 18, 224, 1971, 5.1 and 5.2).  The powers of ten up to 10^22 are doubles,
** so x 10^k is known exactly for k up to 22; its integer part has the wanted digits, and its fraction,
** compared with 1/2, rounds them, halves to even, as glibc does.  Two steps, or a division, cover a wider
** range with a relative error below 2^-102; there a fraction near 1/2 is left to the caller, as are very
** large and very small numbers, more than 17 digits, and infinities.
**
** This requires IEEE double arithmetic that rounds to nearest.  The compiler may fuse products with sums:
** where that would matter, the product is exact, or is stored first.
*/
#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "digits.h"

/* Only if the compiler evaluates doubles as doubles, no wider (FLT_EVAL_METHOD 0, or 1: floats as doubles
** too). */
#if FLT_RADIX == 2 && DBL_MANT_DIG == 53 && DBL_MAX_EXP == 1024 && !defined(__FAST_MATH__) && \
    !defined(__ASSOCIATIVE_MATH__) &&                                                         \
    ((defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ | 1) == 1) ||                      \
     (defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD | 1) == 1))
#define EXACT_ARITHMETIC 1
#else
#define EXACT_ARITHMETIC 0
#endif

#define LARGEST_POWER 22
#define MOST_DIGITS 17
#define LOW_DIGITS 8
#define DIGITS 18 /* of an integer up to 10^17 */

static const double power_of_ten[LARGEST_POWER + 1] = {
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/* The sum of two doubles, the second much smaller than the first. */
typedef struct pair {
    double high, low;
} pair;

/* The upper 26 bits of x; x - upper_half(x) has at most 26 too. */
static double upper_half(double x)
{
    double c = 134217728 * x + x; /* 2^27 + 1 */

    return c - (c - x);
}

/* x y, exactly; y is an integer here, so nothing underflows. */
static pair product(double x, double y)
{
    volatile double rounded = x * y; /* stored, so that it is not fused with the differences */
    double x1 = upper_half(x), x2 = x - x1, y1 = upper_half(y), y2 = y - y1;
    pair p;

    p.high = rounded;
    p.low = x2 * y2 - (((p.high - x1 * y1) - x2 * y1) - x1 * y2);
    return p;
}

/* x 10^k, -22 <= k <= 44, and a margin: 0 for k from 0 to 22, where the product is exact; otherwise a bound
** on its error for products below 10^17. */
static pair scaled(double x, int k, double *margin)
{
    pair p, q;

    *margin = k >= 0 && k <= LARGEST_POWER ? 0 : 1e-9;
    if (k < 0) {
        double divisor = power_of_ten[-k];

        p.high = x / divisor;
        q = product(p.high, divisor);
        p.low = ((x - q.high) - q.low) / divisor;
    } else if (k <= LARGEST_POWER) {
        p = product(x, power_of_ten[k]);
    } else {
        q = product(x, power_of_ten[LARGEST_POWER]);
        p = product(q.high, power_of_ten[k - LARGEST_POWER]);
        p.low += q.low * power_of_ten[k - LARGEST_POWER];
    }
    return p;
}

/* 32 bits are enough here, and faster to divide than 64. */
#if UINT_MAX >= 4294967295UL
typedef unsigned int word;
#else
typedef unsigned long word;
#endif

static const char pairs[] = "00010203040506070809101112131415161718192021222324"
                            "25262728293031323334353637383940414243444546474849"
                            "50515253545556575859606162636465666768697071727374"
                            "75767778798081828384858687888990919293949596979899";

/* Write an integer with `count` digits.  Like the functions below, it returns the end of what it wrote. */
static char *put_integer(word n, int count, char *to)
{
    char *end = to + count;
    word quotient, rest;

    /* four digits at a time: few divisions depend on each other */
    for (to = end; count >= 4; count -= 4, n = quotient) {
        quotient = n / 10000;
        rest = n - 10000 * quotient;
        memcpy(to -= 2, pairs + 2 * (rest % 100), 2);
        memcpy(to -= 2, pairs + 2 * (rest / 100), 2);
    }
    if (count >= 2)
        memcpy(to -= 2, pairs + 2 * (n % 100), 2);
    if (count % 2 == 1)
        to[-1] = (char)('0' + (count == 3 ? n / 100 : n));
    return end;
}

/* An integer up to 10^17 as top 10^8 + bottom, each within 32 bits. */
typedef struct integer {
    long top, bottom;
} integer;

static char *put_long_integer(integer n, int count, char *to)
{
    if (count > LOW_DIGITS) {
        to = put_integer((word)n.top, count - LOW_DIGITS, to);
        count = LOW_DIGITS;
    }
    return put_integer((word)n.bottom, count, to);
}

/* The integer nearest to p, 0 <= p <= 10^17.  0 if p is within the margin of a half; with a margin of 0,
** halves are rounded to even.  All operations but the last sum are exact, because the numbers are multiples
** of the last bit of p.high, or of 1/2, and have at most 53 bits.  Rounding does not change the sign of the
** last sum. */
static int nearest(pair p, double margin, integer *n)
{
    double rest, above_half;

    n->top = (long)(p.high * 1e-8);
    rest = p.high - (double)n->top * 1e8;
    if (rest + p.low < 0) {
        n->top--;
        rest += 1e8;
    }
    n->bottom = (long)(rest + p.low);
    above_half = rest - (double)n->bottom - 0.5 + p.low;
    if (fabs(above_half) < margin)
        return 0;
    n->bottom += (above_half > 0) | ((above_half == 0) & (n->bottom % 2 == 1));
    if (n->bottom >= 100000000) {
        n->bottom -= 100000000;
        n->top++;
    }
    return 1;
}

/* The first n digits of x >= 0, and the power of ten of the first; 0 if they are not certain.  With `either`,
** either of two neighbours is accepted, and 0 means out of range. */
static int significant(double x, int n, int either, integer *digits, int *power)
{
    int binary;
    double fraction = frexp(x, &binary), margin;
    pair p;

    if (!EXACT_ARITHMETIC || n < 1 || n > MOST_DIGITS || !(x < 1e40))
        return 0;
    if (x == 0) {
        digits->top = digits->bottom = *power = 0;
        return 1;
    }
    /* log2 of the fraction is at least 2 (fraction - 1), so the power is this or, rarely, one more. */
    *power = (int)((binary + 2 * (fraction - 1)) * 0.30103 - 1e-5 + 1000) - 1000;
    for (;; ++*power) {
        int k = n - 1 - *power;

        if (k < -LARGEST_POWER || k > 2 * LARGEST_POWER)
            return 0;
        p = scaled(x, k, &margin);
        if (p.high < power_of_ten[n] || (p.high == power_of_ten[n] && p.low < 0))
            break;
    }
    if (!nearest(p, either ? 0 : margin, digits))
        return 0;
    if (n < LOW_DIGITS ? digits->bottom == (long)power_of_ten[n]
                       : digits->top == (long)power_of_ten[n - LOW_DIGITS]) {
        ++*power; /* rounded up to 10^n */
        digits->top = n > LOW_DIGITS ? (long)power_of_ten[n - LOW_DIGITS - 1] : 0;
        digits->bottom = n > LOW_DIGITS ? 0 : (long)power_of_ten[n - 1];
    }
    return 1;
}

static char *put_sign(double value, char *to)
{
    static const double zero = 0;

    *to = '-';
    return to + ((value < 0) | (value == 0 && memcmp(&value, &zero, sizeof value) != 0));
}

static char *put_power(int power, char *to)
{
    *to++ = 'e';
    *to++ = power < 0 ? '-' : '+';
    power = power < 0 ? -power : power;
    *to++ = (char)('0' + power / 10);
    *to++ = (char)('0' + power % 10);
    return to;
}

/* An exponent without plus sign or leading zeros: e6, e-12, e100 */
static char *put_short_power(int power, char *to)
{
    int size = power < 0 ? -power : power;

    *to++ = 'e';
    if (power < 0)
        *to++ = '-';
    return put_integer((word)size, size < 10 ? 1 : size < 100 ? 2 : 3, to);
}

/* Write two digits before `to`; returns their beginning. */
static char *put_pair(word n, char *to)
{
    to -= 2;
    memcpy(to, pairs + 2 * n, 2);
    return to;
}

/* The rounded product x 10^k is good enough if it is not too near a half: below 4 10^9, which fits into 32
** bits, its error is less than 5 10^-7. */
char *flk_digits_fixed_before(double value, int decimals, char *end)
{
    double x = fabs(value), fraction;
    word n;
    int is_zero;

    if (!EXACT_ARITHMETIC || decimals < 0 || decimals > 9)
        return NULL;
    x *= power_of_ten[decimals];
    if (!(x < 4e9))
        return NULL;
    n = (word)x;
    fraction = x - (double)n - 0.5;
    if (fabs(fraction) < 1e-6)
        return NULL;
    n += fraction > 0;
    is_zero = n == 0;
    if (decimals > 0) {
        if (decimals % 2 == 1) {
            *--end = (char)('0' + n % 10);
            n /= 10;
        }
        for (; decimals > 1; decimals -= 2, n /= 100)
            end = put_pair(n % 100, end);
        *--end = '.';
    }
    for (; n >= 100; n /= 100)
        end = put_pair(n % 100, end);
    if (n >= 10)
        end = put_pair(n, end);
    else
        *--end = (char)('0' + n);
    if (value < 0 && !is_zero)
        *--end = '-';
    return end;
}

/* The same by the exact product. */
static char *put_fixed(double x, int decimals, char *to)
{
    char digits[DIGITS];
    double margin;
    integer n;
    int first = 0, whole = DIGITS - decimals;

    if (!EXACT_ARITHMETIC || decimals < 0 || decimals > MOST_DIGITS ||
        !(x * power_of_ten[decimals] < 1e17))
        return NULL;
    nearest(scaled(x, decimals, &margin), 0, &n);
    put_long_integer(n, DIGITS, digits);
    while (first < whole - 1 && digits[first] == '0')
        first++;
    while (first < whole)
        *to++ = digits[first++];
    if (decimals > 0) {
        *to++ = '.';
        memcpy(to, digits + whole, (size_t)decimals);
    }
    return to + decimals;
}

char *flk_digits_fixed(double value, int decimals, char out[DIGITS_SIZE])
{
    char common[24], *start = put_sign(value, out), *end = common + sizeof common, *first;

    first = flk_digits_fixed_before(fabs(value), decimals, end);
    if (first) {
        memcpy(start, first, (size_t)(end - first));
        end = start + (end - first);
    } else {
        end = put_fixed(fabs(value), decimals, start);
    }
    if (end)
        *end = '\0';
    return end;
}

char *flk_digits_exponent(double value, int decimals, char out[DIGITS_SIZE])
{
    char *start = put_sign(value, out), *end;
    integer digits;
    int power;

    if (!significant(fabs(value), decimals + 1, 0, &digits, &power))
        return NULL;
    end = put_long_integer(digits, decimals + 1, start + 1);
    start[0] = start[1]; /* the first digit, to make room for the point */
    start[1] = '.';
    end = put_power(power, decimals > 0 ? end : start + 1);
    *end = '\0';
    return end;
}

/* The n digits of a number without trailing zeros, as in printf's %g. */
static char *put_general(integer digits, int n, int power, char *(*put_exponent)(int, char *),
                         char *start)
{
    char *first = start + 1, *end;
    int i;

    if (power < 0 && power >= -4)
        first = start + 1 - power;
    end = put_long_integer(digits, n, first);
    while (end > first + 1 && end[-1] == '0')
        end--;
    if (power < -4 || power >= n) {
        start[0] = start[1];
        start[1] = '.';
        end = put_exponent(power, end > first + 1 ? end : start + 1);
    } else if (power < 0) {
        memcpy(start, "0.000", (size_t)(1 - power));
    } else {
        for (i = 0; i <= power; i++) /* the whole part, likewise */
            start[i] = start[i + 1];
        start[i] = '.';
        if (end <= start + i + 1)
            end = start + i;
    }
    *end = '\0';
    return end;
}

char *flk_digits_general(double value, int n, char out[DIGITS_SIZE])
{
    integer digits;
    int power;

    if (!significant(fabs(value), n, 0, &digits, &power))
        return NULL;
    return put_general(digits, n, power, put_power, put_sign(value, out));
}

/* Like `significant`, for any number, but the last digits may be wrong. */
static void approximate(double x, int n, integer *digits, int *power)
{
    double whole;
    int k, half;

    *power = (int)floor(log10(x));
    k = n - 1 - *power;
    half = k / 2; /* 10^k may be too large */
    whole = floor(x * pow(10, half) * pow(10, k - half) + 0.5);
    if (whole >= pow(10, n)) {
        whole = floor(whole / 10);
        ++*power;
    }
    digits->top = (long)floor(whole / 1e8);
    digits->bottom = (long)(whole - (double)digits->top * 1e8);
    if (digits->bottom < 0) {
        digits->top--;
        digits->bottom += 100000000;
    }
}

char *flk_digits_short(double value, int n, char out[DIGITS_SIZE])
{
    double x = fabs(value);
    integer digits;
    int power;

    if (!(x <= DBL_MAX))
        return strcpy(out, "inf");
    if (!significant(x, n, 1, &digits, &power)) {
        if (x < DBL_MIN)
            return strcpy(out, "0");
        approximate(x, n, &digits, &power);
    }
    put_general(digits, n, power, put_short_power, value < 0 ? put_sign(value, out) : out);
    return out;
}
