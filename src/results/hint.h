/* SPDX-License-Identifier: GPL-3.0-or-later
**
** hint.h - why an expected value may differ from the computed one.
*/
#ifndef FOURLINK_HINT_H
#define FOURLINK_HINT_H

#include "name.h"

/* Set check->hint if the difference is a typical one; `check` holds two numbers of this name that differ. */
void flk_hint_find(flk_opened *o, const flk_name *n, fourlink_check *check);

#endif
