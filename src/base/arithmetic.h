/* SPDX-License-Identifier: GPL-3.0-or-later
**
** arithmetic.h - floating-point arithmetic that the compiler must not relax.  NaN marks an undefined value
** and infinity an unbounded one; without them results would be silently wrong.  A product is rounded before
** it is added, so that all machines have the same digits, whatever the options of the build.
*/
#ifndef FOURLINK_ARITHMETIC_H
#define FOURLINK_ARITHMETIC_H

#ifdef __FAST_MATH__
#error "fourlink needs NaN and infinity: compile without -ffast-math and -Ofast"
#endif

#ifdef __FINITE_MATH_ONLY__
#if __FINITE_MATH_ONLY__ > 0
#error "fourlink needs NaN and infinity: compile without -ffinite-math-only"
#endif
#endif

#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__) && defined(__FP_FAST_FMA)
/* gcc 12 fuses where it vectorizes statements, whatever -ffp-contract says */
#pragma GCC optimize("-ffp-contract=off", "-fno-tree-slp-vectorize")
#endif

#endif
