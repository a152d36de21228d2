/* SPDX-License-Identifier: GPL-3.0-or-later
**
** quantity.h - quantities from text: a number with a unit, such as 40 deg.
*/
#ifndef FOURLINK_QUANTITY_H
#define FOURLINK_QUANTITY_H

#include "message.h"
#include "units.h"

typedef struct quantity_value {
    double number; /* as it is written */
    unit unit;
    double si;    /* in SI units and radians */
    double digit; /* likewise, one of the last digit: 0.01 m for 2.50 m */
} quantity_value;

/* Read a quantity.
**
** Given:
**    t          the text
**    whole      for messages: what it is a piece of
**    q          the quantity
**    bare       the unit of a bare number
** Returned:
**    value      only if it is one
**    message    only if it is none: why
** Returned (function value):
**    1 if it is one, 0 if not
*/
int flk_quantity_read(text t, text whole, quantity q, unit bare, quantity_value *value,
                      char message[MESSAGE_SIZE]);

/* Its parts: the number at the front of `rest`, which is taken off; the unit that is all of `t`; and whether
** the program computes with values of this size. */
int flk_quantity_number(text *rest, text whole, quantity q, double *number,
                        char message[MESSAGE_SIZE]);
int flk_quantity_unit(text t, text whole, quantity q, unit bare, unit *u,
                      char message[MESSAGE_SIZE]);
int flk_quantity_size(double si, text whole, quantity q, char message[MESSAGE_SIZE]);

#endif
