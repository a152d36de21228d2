/* SPDX-License-Identifier: GPL-3.0-or-later
**
** source.h - decks for tests, in strings.
*/
#ifndef FOURLINK_TEST_SOURCE_H
#define FOURLINK_TEST_SOURCE_H

#include <string.h>

#include "fourlink.h"

static inline fourlink_source deck_source(const char *contents)
{
    fourlink_source source;

    memset(&source, 0, sizeof source);
    source.name = "x.deck";
    source.text = contents;
    source.length = (unsigned long)strlen(contents);
    return source;
}

#endif
