/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck_out.h - decks as output: the text of a deck with the values that are computed.
*/
#ifndef FOURLINK_DECK_OUT_H
#define FOURLINK_DECK_OUT_H

#include "input.h"

/* Print the deck, or write each design of its [sweep] into the folder of --output as NAME-N.deck; returns
** the exit status. */
int deck_out_print(const input *in);

#endif
