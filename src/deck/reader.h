/* SPDX-License-Identifier: GPL-3.0-or-later
**
** reader.h - the deck reader: from a text to a problem, or to a list of mistakes.
*/
#ifndef FOURLINK_DECK_READER_H
#define FOURLINK_DECK_READER_H

#include "deck.h"

/* Read a deck.
**
** Given:
**    source      the text, and changes to it; not needed after the call
** Returned:
**    d           the deck, for flk_deck_free, even if it has mistakes
** Returned (function value):
**    1 the deck is valid, 0 see d->mistakes, -1 out of memory
** Note:
**    Answers are read only if the deck itself has no mistakes.
*/
int flk_deck_read(const fourlink_source *source, deck *d);

/* Build another design of a deck from its settings, without its text.
**
** Given:
**    from        from flk_deck_read or flk_deck_design; must outlive `d`
**    design      below from->sweep.n_designs; 0 for a deck without [sweep]
**    set         numbers that differ from those of this design
**    n_set       how many
** Returned:
**    d           the deck, for flk_deck_free, even if it has mistakes; its notes are only those on what is
**                built
** Returned (function value):
**    as from flk_deck_read; 0 if the text itself has mistakes
*/
int flk_deck_design(const deck *from, unsigned long design, const deck_number *set, size_t n_set,
                    deck *d);

/* The same with another of the solutions that are kept of its task, from 0; the task is not solved again. */
int flk_deck_solution(const deck *from, unsigned long number, deck *d);

/* The same design of a deck without mistakes, with a change, which may be of a line that the deck does
** not have; the units stay, and answers are not read.  The linkage of a task is sought again. */
int flk_deck_changed(const deck *from, const fourlink_change *change, deck *d);

#endif
