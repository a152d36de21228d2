/* SPDX-License-Identifier: GPL-3.0-or-later
**
** read.h - decks for tests, read from strings.
*/
#ifndef FOURLINK_TEST_READ_H
#define FOURLINK_TEST_READ_H

#include <string.h>

#include "deck/deck.h"

static inline fourlink_source deck_source(const char *contents)
{
    fourlink_source source;

    memset(&source, 0, sizeof source);
    source.name = "x.deck";
    source.text = contents;
    source.length = (unsigned long)strlen(contents);
    return source;
}

/* As flk_deck_read. */
static inline int read_deck(const char *contents, deck *d)
{
    fourlink_source source = deck_source(contents);

    return flk_deck_read(&source, d);
}

#endif
