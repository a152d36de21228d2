/* SPDX-License-Identifier: GPL-3.0-or-later
**
** format.h - numbers to text, the same in every locale.
*/
#ifndef FOURLINK_FORMAT_H
#define FOURLINK_FORMAT_H

#define FORMAT_SIZE 400

/* Write a number with so many decimals (as %.*f, %.*e) or so many significant digits (as %.*g);
** without a sign if it prints as 0. */
char *format_fixed(double value, int decimals, char out[FORMAT_SIZE]);
char *format_exponent(double value, int decimals, char out[FORMAT_SIZE]);
char *format_general(double value, int digits, char out[FORMAT_SIZE]);

/* The same, but returning the end of the number. */
char *format_fixed_end(double value, int decimals, char out[FORMAT_SIZE]);
char *format_exponent_end(double value, int decimals, char out[FORMAT_SIZE]);
char *format_general_end(double value, int digits, char out[FORMAT_SIZE]);

/* The same with the fewest digits, 15 at least, that read back as the same number. */
char *format_shortest_end(double value, char out[FORMAT_SIZE]);

/* What is rounding error: a value of at most this fraction of those that it is compared with. */
#define FORMAT_ROUNDING 1e-12

/* A value beside others of this size: 0 if it is rounding error. */
double format_settled(double value, double size);

#endif
