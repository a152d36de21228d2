/* SPDX-License-Identifier: GPL-3.0-or-later
**
** closed_form.h - the nine equations of nine_equations.c, solved by hand.  Links 3 and 4 are a dyad: their
** forces do not depend on those of the crank, which follows.
*/
#ifndef FOURLINK_MECHANICS_CLOSED_FORM_H
#define FOURLINK_MECHANICS_CLOSED_FORM_H

#include "kind.h"

/* The forces of a position that is not singular, with valid loads (closed_form.c). */
int flk_dyad(const flk_kind *kind, const fourlink_mechanism *mechanism, const fourlink_state *state,
             const fourlink_load *loads, unsigned long n_loads, fourlink_forces *forces);

#endif
