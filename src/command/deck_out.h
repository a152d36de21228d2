/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck_out.h - a deck as output: its text with the values that are computed.
*/
#ifndef FOURLINK_DECK_OUT_H
#define FOURLINK_DECK_OUT_H

#include "input.h"

/* Print the deck into --output; returns the exit status. */
int deck_out_print(const input *in);

#endif
