/* SPDX-License-Identifier: GPL-3.0-or-later
**
** catalogue.h - the list of all columns and facts, of any deck: those of decks that have everything.
*/
#ifndef FOURLINK_COMMAND_CATALOGUE_H
#define FOURLINK_COMMAND_CATALOGUE_H

#include <stdio.h>

#include "input.h"

/* Write the columns and facts of any deck. */
int catalogue_write(FILE *out, const options *o);

#endif
