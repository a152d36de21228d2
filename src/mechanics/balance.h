/* SPDX-License-Identifier: GPL-3.0-or-later
**
** balance.h - counterweights that balance the shaking force.
*/
#ifndef FOURLINK_MECHANICS_BALANCE_H
#define FOURLINK_MECHANICS_BALANCE_H

#include "kind.h"

/* The reciprocating mass of a slider-crank, kg: piston and its part of the rod (balance.c). */
double flk_balance_reciprocating(const fourlink_design *design);

#endif
