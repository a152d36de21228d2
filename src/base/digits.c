/* SPDX-License-Identifier: GPL-3.0-or-later
**
** digits.c - numbers to text by exact products.
**
** printf uses integers of any length.  Three words of 64 bits are enough for numbers of common size: a double
** is m 2^e, with m an integer of 64 bits, so
**
**    x 10^k = m 5^k 2^(e + k)
**
** is known exactly for k up to 54, where 5^k is one power of five that fits into a word or the product of
** two; for negative k it is a quotient and a rest.  Its integer part has the wanted digits, and what is
** behind rounds them, halves to even, as glibc does.  Very large and very small numbers, more than 17
** digits, and infinities are left to the caller.
*/
#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "arithmetic.h"
#include "digits.h"

/* 64 bits: unsigned long, or where that has 32, what C90 compilers have besides. */
#if ULONG_MAX > 4294967295UL
typedef unsigned long word;
#elif defined(__GNUC__)
__extension__ typedef unsigned long long word;
#else
typedef unsigned long long word;
#endif

#define WIDE(high, low) ((word)(high) << 32 | (low))
#define BITS 64
#define HALF WIDE(0x80000000, 0)

#define MOST_DIGITS 17
#define DIGITS 18 /* of an integer up to 10^17 */

#define LARGEST_POWER 27
static const word power_of_five[LARGEST_POWER + 1] = {
    WIDE(0x0, 0x00000001),        WIDE(0x0, 0x00000005),       WIDE(0x0, 0x00000019),
    WIDE(0x0, 0x0000007d),        WIDE(0x0, 0x00000271),       WIDE(0x0, 0x00000c35),
    WIDE(0x0, 0x00003d09),        WIDE(0x0, 0x0001312d),       WIDE(0x0, 0x0005f5e1),
    WIDE(0x0, 0x001dcd65),        WIDE(0x0, 0x009502f9),       WIDE(0x0, 0x02e90edd),
    WIDE(0x0, 0x0e8d4a51),        WIDE(0x0, 0x48c27395),       WIDE(0x1, 0x6bcc41e9),
    WIDE(0x7, 0x1afd498d),        WIDE(0x23, 0x86f26fc1),      WIDE(0xb1, 0xa2bc2ec5),
    WIDE(0x378, 0x2dace9d9),      WIDE(0x1158, 0xe460913d),    WIDE(0x56bc, 0x75e2d631),
    WIDE(0x1b1ae, 0x4d6e2ef5),    WIDE(0x87867, 0x8326eac9),   WIDE(0x2a5a05, 0x8fc295ed),
    WIDE(0xd3c21b, 0xcecceda1),   WIDE(0x422ca8b, 0x0a00a425), WIDE(0x14adf4b7, 0x320334b9),
    WIDE(0x6765c793, 0xfa10079d),
};

/* high 2^64 + low */
typedef struct product {
    word high, low;
} product;

static product multiply_words(word x, word y)
{
    word x1 = x >> 32, x0 = x & 0xffffffff, y1 = y >> 32, y0 = y & 0xffffffff;
    word low = x0 * y0, a = x1 * y0 + (low >> 32), b = x0 * y1 + (a & 0xffffffff);
    product p;

    p.high = x1 * y1 + (a >> 32) + (b >> 32);
    p.low = b << 32 | (low & 0xffffffff);
    return p;
}

/* The integer nearest to p / 2^n, n > 0; halves are rounded to even.  With `more`, p is a little more. */
static word shifted(product p, int n, int more)
{
    word whole, rest;

    if (n > BITS) {
        more |= p.low != 0;
        p.low = p.high;
        p.high = 0;
        n -= BITS;
    }
    if (n > BITS)
        return 0;
    whole = n < BITS ? p.high << (BITS - n) | p.low >> n : p.high;
    rest = p.low << (BITS - n);
    return whole + ((rest > HALF) | ((rest == HALF) & (more | (int)(whole & 1))));
}

/* A double without its sign as m 2^e, with the highest bit of m set.  A number too small for that is taken
** for another, whose digits do not matter either. */
typedef struct binary {
    word m;
    int e;
} binary;

static binary binary_of(double x)
{
    word bits;
    binary b;

    memcpy(&bits, &x, sizeof bits);
    b.m = bits << 11 | HALF;
    b.e = (int)(bits >> 52 & 0x7ff) - 1086;
    return b;
}

/* The integer nearest to b 10^k, if that is below 10^18; -27 <= k <= 54. */
static word nearest(binary b, int k)
{
    word divisor, rest;
    int e = b.e + k;
    product p, q;

    if (k >= 0 && k <= LARGEST_POWER)
        return shifted(multiply_words(b.m, power_of_five[k]), -e, 0);
    if (k > 0) {
        p = multiply_words(b.m, power_of_five[LARGEST_POWER]);
        q = multiply_words(p.low, power_of_five[k - LARGEST_POWER]);
        p = multiply_words(p.high, power_of_five[k - LARGEST_POWER]);
        p.low += q.high;
        p.high += p.low < q.high;
        return shifted(p, -e - BITS, q.low != 0);
    }
    divisor = power_of_five[-k];
    p.high = 0;
    p.low = b.m / divisor;
    for (rest = b.m % divisor; e > -1; e--) {
        rest *= 2;
        p.low = 2 * p.low + (rest >= divisor);
        rest -= rest >= divisor ? divisor : 0;
    }
    return shifted(p, -e, rest != 0);
}

static const char pairs[] = "00010203040506070809101112131415161718192021222324"
                            "25262728293031323334353637383940414243444546474849"
                            "50515253545556575859606162636465666768697071727374"
                            "75767778798081828384858687888990919293949596979899";

static void put_pair(unsigned int n, char *to)
{
    memcpy(to, pairs + 2 * n, 2);
}

static void put_four(unsigned int n, char *to)
{
    put_pair(n / 100, to);
    put_pair(n % 100, to + 2);
}

static void put_eight(word n, char *to)
{
    put_four((unsigned int)n / 10000, to);
    put_four((unsigned int)n % 10000, to + 4);
}

/* All digits of an integer, leading zeros too. */
static void put_integer(word n, char to[DIGITS])
{
    word high = n / 100000000;

    put_pair((unsigned int)(high / 100000000), to);
    put_eight(high % 100000000, to + 2);
    put_eight(n % 100000000, to + 10);
}

/* Its last digits; returns their end.  There is room for one more before them. */
static char *put_last(word n, int count, char *to)
{
    put_integer(n, to - 1);
    if (count < MOST_DIGITS)
        memmove(to, to - 1 + DIGITS - count, (size_t)count);
    return to + count;
}

/* The power of ten of the first digit, or rarely one less: log10(2) is little more than 1233 / 4096, and
** log2(m) at least 62 + m / 2^63.  The sum is positive. */
static int least_power(binary b)
{
    int log2_by_64 = 64 * (b.e + 63) + (int)(b.m >> 57 & 63);

    return ((1000 << 18) + 1233 * log2_by_64) / (1 << 18) - 1000;
}

/* Digits, and the power of ten of the first. */
typedef struct decimal {
    word digits;
    int power;
} decimal;

#define UNKNOWN 10000 /* power */

/* The first n digits of |x|. */
static decimal significant(double x, int n)
{
    static const decimal zero = {0, 0}, unknown = {0, UNKNOWN};
    binary b = binary_of(x);
    decimal d;

    if (n < 1 || n > MOST_DIGITS || !(fabs(x) < 1e40))
        return unknown;
    if (x == 0)
        return zero;
    for (d.power = least_power(b);; d.power++) {
        int k = n - 1 - d.power;

        if (k < -LARGEST_POWER || k > 2 * LARGEST_POWER)
            return unknown;
        d.digits = nearest(b, k);
        if (d.digits < power_of_five[n] << n)
            return d;
    }
}

static char *put_sign(double value, char *to)
{
    *to = '-';
    return to + (value < 0);
}

/* An exponent as in printf, e+06, or without plus sign and leading zeros: e6, e-12, e100. */
static char *put_power(int power, int is_short, char *to)
{
    int size = power < 0 ? -power : power;

    *to++ = 'e';
    if (power < 0 || !is_short)
        *to++ = power < 0 ? '-' : '+';
    if (size >= 100)
        *to++ = (char)('0' + size / 100);
    if (size >= 10 || !is_short)
        *to++ = (char)('0' + size / 10 % 10);
    *to++ = (char)('0' + size % 10);
    return to;
}

static const double power_of_ten[DIGITS] = {1e0, 1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,
                                            1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17};

/* The eight digits of an integer below 10^8 as bytes of a word, the first one lowest: halves, pairs and
** digits are split off in all places at once by products that stand for quotients. */
static word eight_digits(unsigned int n)
{
    word high = n / 10000, w = high | (word)(n - (unsigned int)high * 10000) << 32, t;

    t = (w * 10486 >> 20) & WIDE(0x7f, 0x7f); /* x / 100 for x < 10^4 */
    w = t | (w - 100 * t) << 16;
    t = (w * 103 >> 10) & WIDE(0xf000f, 0xf000f); /* x / 10 for x < 100 */
    return t | (w - 10 * t) << 8;
}

/* Put the bytes of a word into memory, the lowest first; compilers make one store of them. */
static void put_word(word w, char *to)
{
    to[0] = (char)w;
    to[1] = (char)(w >> 8);
    to[2] = (char)(w >> 16);
    to[3] = (char)(w >> 24);
    to[4] = (char)(w >> 32);
    to[5] = (char)(w >> 40);
    to[6] = (char)(w >> 48);
    to[7] = (char)(w >> 56);
}

#define EACH_BYTE WIDE(0x01010101, 0x01010101)

void flk_digits_cell(digits_cell *cell, size_t value, int decimals, double limit, size_t end)
{
    cell->value = value;
    cell->end = end;
    cell->decimals = decimals;
    cell->scale = cell->limit = 0;
    if (decimals < 0 || decimals > 8 || end < DIGITS_BEFORE)
        return;
    cell->scale = power_of_ten[decimals];
    cell->limit = limit < 99999999 / cell->scale ? limit : 99999999 / cell->scale;
}

/* The rounded product x 10^k is good enough if it is not too near a half: below 10^8 its error is less than 2
** 10^-8. The decimals are the last digits; the digits of the whole part go a place further left, where bytes
** without a digit become blanks. */
size_t flk_digits_put(const digits_cell *cells, size_t n, const double *values, char *line)
{
    for (; n > 0; n--) {
        const digits_cell *cell = &cells[n - 1];
        double value = values[cell->value], x = fabs(value);
        char *end = line + cell->end;
        word digits, shown;
        int integer;

        if (!(x < cell->limit))
            break;
        x *= cell->scale;
        integer = (int)(x + 0.5);
        if (fabs(x - integer) > 0.5 - 1e-6)
            break;
        digits = eight_digits((unsigned int)integer);
        if (cell->decimals > 0) {
            put_word(digits | '0' * EACH_BYTE, end - 8);
            end -= cell->decimals + 1;
            *end = '.';
            digits = digits << 8 * (cell->decimals - 1) << 8;
        }
        /* the bit that makes a digit of a blank: in the last byte, and from the first digit that is not 0 */
        shown = (digits | (0 - digits) | WIDE(0x10000000, 0)) & 0x10 * EACH_BYTE;
        put_word(digits | shown | ' ' * EACH_BYTE, end - 8);
        if (value < 0 && integer)
            end[-1 - (int)((shown >> 4) * EACH_BYTE >> 56)] = '-';
    }
    return n;
}

/* The same by the exact product. */
static char *put_fixed(double value, int decimals, char *to)
{
    char digits[DIGITS];
    word n;
    int first = 0, whole = DIGITS - decimals;

    if (decimals < 0 || decimals > MOST_DIGITS || !(fabs(value) * power_of_ten[decimals] < 1e17))
        return NULL;
    n = nearest(binary_of(value), decimals);
    put_integer(n, digits);
    to = n ? put_sign(value, to) : to;
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
    char common[DIGITS_BEFORE], *first = common + sizeof common, *end;
    digits_cell cell;

    memset(common, ' ', sizeof common);
    flk_digits_cell(&cell, 0, decimals, DBL_MAX, sizeof common);
    if (flk_digits_put(&cell, 1, &value, common) == 0) {
        while (first[-1] != ' ')
            first--;
        end = out + (common + sizeof common - first);
        memcpy(out, first, (size_t)(end - out));
    } else {
        end = put_fixed(value, decimals, out);
    }
    if (end)
        *end = '\0';
    return end;
}

char *flk_digits_exponent(double value, int decimals, char out[DIGITS_SIZE])
{
    char *start = put_sign(value, out), *end;
    decimal d = significant(value, decimals + 1);

    if (d.power == UNKNOWN)
        return NULL;
    end = put_last(d.digits, decimals + 1, start + 1);
    start[0] = start[1]; /* the first digit, to make room for the point */
    start[1] = '.';
    end = put_power(d.power, 0, decimals > 0 ? end : start + 1);
    *end = '\0';
    return end;
}

/* The n digits of a number without trailing zeros, as in printf's %g. */
static char *put_general(decimal d, int n, int is_short, char *start)
{
    char *first = start + 1, *end;
    int power = d.power, i;

    if (power < 0 && power >= -4)
        first = start + 1 - power;
    end = put_last(d.digits, n, first);
    while (end > first + 1 && end[-1] == '0')
        end--;
    if (power < -4 || power >= n) {
        start[0] = start[1];
        start[1] = '.';
        end = put_power(power, is_short, end > first + 1 ? end : start + 1);
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
    decimal d = significant(value, n);

    return d.power == UNKNOWN ? NULL : put_general(d, n, 0, put_sign(value, out));
}

/* Like `significant`, for any number, but the last digits may be wrong. */
static decimal approximate(double x, int n)
{
    decimal d;
    double whole;
    int k, half;

    d.power = (int)floor(log10(x));
    k = n - 1 - d.power;
    half = k / 2; /* 10^k may be too large */
    whole = floor(x * pow(10, half) * pow(10, k - half) + 0.5);
    if (whole >= pow(10, n)) {
        whole = floor(whole / 10);
        d.power++;
    }
    d.digits = (word)whole;
    return d;
}

char *flk_digits_short(double value, int n, char out[DIGITS_SIZE])
{
    double x = fabs(value);
    decimal d = significant(x, n);

    if (!(x <= DBL_MAX))
        return strcpy(out, "inf");
    if (d.power == UNKNOWN && x < DBL_MIN)
        return strcpy(out, "0");
    if (d.power == UNKNOWN)
        d = approximate(x, n);
    put_general(d, n, 1, put_sign(value, out));
    return out;
}
