/* SPDX-License-Identifier: GPL-3.0-or-later
**
** rules.h - what does not go together on a command line, and what a deck must have for it.
*/
#ifndef FOURLINK_RULES_H
#define FOURLINK_RULES_H

#include "input.h"
#include "options.h"

/* Why the options do not go together, or null. */
const char *rules_of_options(const options *o);

/* Why a deck that has been opened cannot serve them, or null; what they can need of a [sweep], seen before. */
const char *rules_of_deck(const input *in);
const char *rules_without_sweep(const options *o);

#endif
