/* SPDX-License-Identifier: GPL-3.0-or-later
**
** switch.h - where a machine is not smooth: a variable of its state passes one of some levels.
**
** Levels are data: 0 of a sliding speed, the points of a curve, the edges of a range of crank angles.
*/
#ifndef FOURLINK_SWITCH_H
#define FOURLINK_SWITCH_H

#include "machine.h"

struct flk_switch {
    flk_variable of;
    int joint; /* 1 to 3: of no variable, but of the relative speed in joint B, C or D; else 0 */
    double period;              /* rad: of theta2 the cycle, of theta4 a turn; 0: it has none */
    const flk_element *element; /* of none, but of this element's `switching`; else null */
    const double *level;        /* rising, within one period */
    size_t n;
};

/* List the switches of a machine; with a null list only return their number. */
size_t flk_switch_list(const flk_machine *machine, flk_switch *list);

/* The switch of a curve, the points; 0 if there is none.  That of the only level 0. */
size_t flk_switch_of_curve(const curve *c, flk_variable over, flk_switch *s);
size_t flk_switch_at_zero(flk_variable of, flk_switch *s);
size_t flk_switch_of_element(const flk_element *element, flk_switch *s);

/* 1 if the levels are passed at the same crank angles whatever the speed. */
int flk_switch_is_of_position(const flk_switch *s);

double flk_switch_value(const flk_machine *machine, const flk_switch *s,
                        const fourlink_state *state);

/* The number of rising levels below x. */
size_t flk_switch_below(const double *level, size_t n, double x);

/* How many levels the variable passes as it goes from one value to another, both less than half a period apart; the number
** of the first, and 1 or -1, the step to the next.  Levels are counted on through the periods. */
size_t flk_switch_passes(const flk_switch *s, double from, double to, double *first, int *step);
double flk_switch_level(const flk_switch *s, double number);

#endif
