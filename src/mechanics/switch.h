/* SPDX-License-Identifier: GPL-3.0-or-later
**
** switch.h - where a machine is not smooth: a variable of its state crosses one of its levels.
**
** Levels are data: 0 for a sliding speed, the points of a curve, the edges of a range of crank angles.
*/
#ifndef FOURLINK_SWITCH_H
#define FOURLINK_SWITCH_H

#include "machine.h"

struct flk_switch {
    flk_variable of;
    int joint;     /* 1 to 3: not a variable, but the relative speed in joint B, C or D; else 0 */
    double period; /* rad: a cycle for theta2, a turn for theta4; 0: not periodic */
    const flk_element *element; /* not a variable, but the `switching` of this element; else null */
    const double *level;        /* increasing, within one period */
    size_t n;
};

/* List the switches of a machine and return their number; a null list only counts them. */
size_t flk_switch_list(const flk_machine *machine, flk_switch *list);

/* The switch of a curve, at its points; 0 if there is none.  A switch with the single level 0. */
size_t flk_switch_of_curve(const curve *c, flk_variable over, flk_switch *s);
size_t flk_switch_at_zero(flk_variable of, flk_switch *s);
size_t flk_switch_of_element(const flk_element *element, flk_switch *s);

/* 1 if the crank angles at which the levels are crossed do not depend on the speed. */
int flk_switch_is_of_position(const flk_switch *s);

double flk_switch_value(const flk_machine *machine, const flk_switch *s,
                        const fourlink_state *state);

/* The number of levels, which increase, below x. */
size_t flk_switch_below(const double *level, size_t n, double x);

/* How many levels the variable crosses between two values less than half a period apart; the number of the
** first, and 1 or -1, the step to the next.  Levels are counted through all periods. */
size_t flk_switch_passes(const flk_switch *s, double from, double to, double *first, int *step);
double flk_switch_level(const flk_switch *s, double number);

#endif
