/* SPDX-License-Identifier: GPL-3.0-or-later
**
** hint.h - why a value may differ from the computed one: the slips that people make.
*/
#ifndef FOURLINK_HINT_H
#define FOURLINK_HINT_H

#include "opened.h"

/* Set check->hint of an expected value if two numbers of this name differ in a typical way, and in
** check->part what the slip is worth where hint = half: FOURLINK_OK, FOURLINK_NO_MEMORY. */
int flk_hint_find(flk_opened *o, const deck_expectation *e, const flk_name *n,
                  fourlink_check *check);

#endif
