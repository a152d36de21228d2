/* SPDX-License-Identifier: GPL-3.0-or-later
**
** quantity.h - quantities from text: a number with a unit, such as 40 deg.
*/
#ifndef FOURLINK_QUANTITY_H
#define FOURLINK_QUANTITY_H

#include "message.h"
#include "units.h"

typedef struct quantity_value {
    double number; /* as written */
    unit unit;
    double si;    /* in SI units and radians */
    double digit; /* also in SI, one unit of the last digit: 0.01 m for 2.50 m */
} quantity_value;

/* Read a quantity.  Its number may be a fraction, 1/3; that of an angle or its rates also a multiple of pi,
** which without a unit is in radians: pi/6, 2 pi/3.
**
** Given:
**    t          the text
**    whole      the text that contains it, for messages
**    q          the quantity
**    bare       the unit of a bare number
** Returned:
**    value      only if it is a quantity
**    message    the reason, only if it is not
** Returned (function value):
**    1 if it is a quantity, 0 if not */
int flk_quantity_read(text t, text whole, quantity q, unit bare, quantity_value *value,
                      char message[MESSAGE_SIZE]);

/* Its steps: take the number off the front of `rest`; read the unit `t`; check that the value is in range. */
int flk_quantity_number(text *rest, text whole, quantity q, double *number,
                        char message[MESSAGE_SIZE]);
int flk_quantity_unit(text t, text whole, quantity q, unit bare, unit *u,
                      char message[MESSAGE_SIZE]);
int flk_quantity_size(double si, text whole, quantity q, char message[MESSAGE_SIZE]);

/* 1, and a note, if the unit `t` of a force is a bare lb or oz; `whole` as above. */
int flk_quantity_weight(text t, text whole, char message[MESSAGE_SIZE]);

/* The text after the number of a quantity; empty if the number is bare.  The same with the blanks before the
** unit. */
text flk_quantity_unit_text(text t);
text flk_quantity_after_number(text t);

#endif
