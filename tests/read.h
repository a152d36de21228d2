/* SPDX-License-Identifier: GPL-3.0-or-later
**
** read.h - decks for tests, read from strings.
*/
#ifndef FOURLINK_TEST_READ_H
#define FOURLINK_TEST_READ_H

#include "deck/deck.h"
#include "deck/reader.h"
#include "source.h"

/* As flk_deck_read. */
static inline int read_deck(const char *contents, deck *d)
{
    fourlink_source source = deck_source(contents);

    return flk_deck_read(&source, d);
}

#endif
