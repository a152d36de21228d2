/* SPDX-License-Identifier: GPL-3.0-or-later
**
** digits.h - numbers to text by exact products, without the C library and its locale.
*/
#ifndef FOURLINK_DIGITS_H
#define FOURLINK_DIGITS_H

#include <stddef.h>

#define DIGITS_SIZE 48

/* Write a number with the given number of decimals (as %.*f, %.*e) or of significant digits (as %.*g), but
** without a sign if it prints as 0.  Returns its end, or null if its digits are left to the caller, as of
** very large and very small numbers. */
char *flk_digits_fixed(double value, int decimals, char out[DIGITS_SIZE]);
char *flk_digits_exponent(double value, int decimals, char out[DIGITS_SIZE]);
char *flk_digits_general(double value, int digits, char out[DIGITS_SIZE]);

/* The place of a number in a line of blanks. */
typedef struct digits_cell {
    size_t value; /* which of the values */
    size_t end;   /* of its digits in the line */
    int decimals;
    double scale, limit; /* 10^decimals; smaller numbers are written */
} digits_cell;

/* Set a cell for numbers below `limit`. All of DIGITS_BEFORE bytes before its end may become blanks; where
** the line has fewer, no number is written. */
#define DIGITS_BEFORE 20
void flk_digits_cell(digits_cell *cell, size_t value, int decimals, double limit, size_t end);

/* Write the numbers of n cells, as flk_digits_fixed, from right to left since they blank what is on their
** left. Returns 0, or the number of cells that are left where the last of them has a number whose digits are
** not certain or that is too large: the caller writes it. */
size_t flk_digits_put(const digits_cell *cells, size_t n, const double *values, char *line);

/* Write any number with at most 17 significant digits and a short exponent (1e6), for messages.  The last
** digits of very large and very small numbers may be wrong. */
char *flk_digits_short(double value, int digits, char out[DIGITS_SIZE]);

#endif
