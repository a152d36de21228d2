/* SPDX-License-Identifier: GPL-3.0-or-later
**
** import.h - a deck from the link of another tool.
*/
#ifndef FOURLINK_IMPORT_H
#define FOURLINK_IMPORT_H

#include "base/text.h"

/* The deck of a PMKS+ link: memory to free; what has no place in it is told.  Null after a mistake,
** which is told, or if memory has failed. */
char *import_deck(text t, const char *file, size_t *length);

#endif
