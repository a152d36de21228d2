/* SPDX-License-Identifier: GPL-3.0-or-later
**
** rules.h - what does not go together on a command line, and what a deck must have for it.
*/
#ifndef FOURLINK_RULES_H
#define FOURLINK_RULES_H

#include "fourlink.h"
#include "options.h"

/* Why the options do not go together, or null. */
const char *rules_of_options(const options *o);

/* Why a deck that has been opened cannot serve them, or null.  `is_design`: a design of a [sweep] was taken
** from it; `has_task`: its linkage was found for a [synthesis]; `has_values`: its columns are values of the
** deck. */
const char *rules_of_deck(const options *o, const fourlink_problem *p, int is_design, int has_task,
                          int has_values);

/* What they need of a deck that has no [sweep]. */
const char *rules_without_sweep(const options *o);

#endif
