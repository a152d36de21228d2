/* SPDX-License-Identifier: GPL-3.0-or-later
**
** trig.h - sine, cosine, arc tangent and what follows from them, with the same bits on every machine.
**
** Libraries of C differ in the last digits, also from processor to processor. These functions need nothing
** but +, -, *, /, the square root and the exact fmod, which IEEE 754 rounds in one way. Sine, cosine and
** arc tangent are within 1 ulp, arc sine and arc cosine within 3 (tests/base/trig_trial.c); angles are in
** rad.
*/
#ifndef FOURLINK_TRIG_H
#define FOURLINK_TRIG_H

/* Sine and cosine of one angle together; beyond 10^9, of an angle that differs from x by less than
** 1e-15 + 3e-32 |x|. */
void flk_sine_cosine(double x, double *sine, double *cosine);
double flk_sine(double x);
double flk_cosine(double x);

/* The angle of the vector (x, y), in [-pi, pi]; signs of zeros count, as with atan2. */
double flk_angle(double y, double x);

/* As asin and acos; NaN beyond -1 ... 1. */
double flk_arc_sine(double x);
double flk_arc_cosine(double x);

/* The length of a vector, without overflow in between. */
double flk_length(double x, double y);

#endif
