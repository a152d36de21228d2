/* SPDX-License-Identifier: GPL-3.0-or-later
**
** outcome.h - what becomes of a deck: its values, its only mistake, its notes.
*/
#ifndef FOURLINK_TEST_OUTCOME_H
#define FOURLINK_TEST_OUTCOME_H

#include "check.h"
#include "read.h"
#include "deck/reader.h"

/* The file that a deck names, whatever its name: the host's text. */
static inline const char *load_text(void *host, const char *file_name, unsigned long *length)
{
    (void)file_name;
    *length = host ? (unsigned long)strlen(host) : 0;
    return host;
}

/* Read a deck that may name a file with this text; 1 if it is in order. */
static inline int read_outcome(const char *contents, const char *file, deck *d)
{
    fourlink_source source = deck_source(contents);
    size_t i;
    int status;

    source.load = load_text;
    source.host = (void *)file;
    status = flk_deck_read(&source, d);
    for (i = 0; i < d->mistakes.count; i++)
        print_message("%s:%ld: error: %s\n", d->mistakes.list[i].place.source,
                      d->mistakes.list[i].place.line, d->mistakes.list[i].message);
    for (i = 0; i < d->notes.count; i++)
        print_message("%s:%ld: note: %s\n", d->notes.list[i].place.source,
                      d->notes.list[i].place.line, d->notes.list[i].message);
    return status;
}

/* Read a deck that is in order. */
static inline void read_accepted(const char *contents, const char *file, deck *d)
{
    if (read_outcome(contents, file, d) != 1)
        fail_msg("mistakes in\n%s", contents);
}

/* The deck has this mistake and no other. */
static inline void check_mistake(const char *contents, const char *file, long line,
                                 const char *message)
{
    deck d;

    read_outcome(contents, file, &d);
    if (d.mistakes.count != 1 || d.mistakes.list[0].place.line != line ||
        strcmp(d.mistakes.list[0].message, message) != 0)
        fail_msg("expected %ld: %s\nand nothing else of\n%s", line, message, contents);
    flk_deck_free(&d);
}

/* The deck is in order, with this note and no other; without one if the message is null. */
static inline void check_note(const char *contents, const char *file, long line,
                              const char *message)
{
    deck d;

    read_accepted(contents, file, &d);
    if (!message && d.notes.count)
        fail_msg("a note on\n%s", contents);
    if (message && (d.notes.count != 1 || d.notes.list[0].place.line != line ||
                    strcmp(d.notes.list[0].message, message) != 0))
        fail_msg("expected %ld: %s\nand nothing else on\n%s", line, message, contents);
    flk_deck_free(&d);
}

#endif
