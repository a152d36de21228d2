/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_synthesis.h - builds the task of [synthesis] from values.
*/
#ifndef FOURLINK_DECK_BUILD_SYNTHESIS_H
#define FOURLINK_DECK_BUILD_SYNTHESIS_H

#include "synthesis.h"

/* Read the task; 0 after a mistake. */
int flk_synthesis_read(struct parser *p);

#endif
