/* SPDX-License-Identifier: GPL-3.0-or-later
**
** copied.h - answers that belong to the deck of another.
*/
#ifndef FOURLINK_COPIED_H
#define FOURLINK_COPIED_H

#include "input.h"

/* The deck of the command line, not the input's own, with which its answers agree better than with their
** own, in most values; null if there is none.  How many of them agree. */
const char *copied_from(const input *in, unsigned long *n_agree);

#endif
