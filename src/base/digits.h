/* SPDX-License-Identifier: GPL-3.0-or-later
**
** digits.h - numbers to text by exact products, without the C library and its locale.
*/
#ifndef FOURLINK_DIGITS_H
#define FOURLINK_DIGITS_H

#define DIGITS_SIZE 48

/* Write a number with the given number of decimals (as %.*f, %.*e) or of significant digits (as %.*g), but
** without a sign if it prints as 0.  Returns its end, or null if its digits are left to the caller, as of
** very large and very small numbers. */
char *flk_digits_fixed(double value, int decimals, char out[DIGITS_SIZE]);
char *flk_digits_exponent(double value, int decimals, char out[DIGITS_SIZE]);
char *flk_digits_general(double value, int digits, char out[DIGITS_SIZE]);

/* Write a number with `decimals` decimals so that it ends before `end`, without a sign if it prints as 0; at
** most 12 characters.  Returns its beginning, or null, with nothing written, if its digits are not
** certain. */
char *flk_digits_fixed_before(double value, int decimals, char *end);

/* Write any number with at most 17 significant digits and a short exponent (1e6), for messages.  The last
** digits of very large and very small numbers may be wrong. */
char *flk_digits_short(double value, int digits, char out[DIGITS_SIZE]);

#endif
