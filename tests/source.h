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

/* Open a deck with a file of expected values. */
static inline int open_with_answers(const char *contents, const char *answers, fourlink_results **r,
                                    fourlink_mistake *mistake)
{
    fourlink_source source = deck_source(contents);

    source.answers_name = "y.expect";
    source.answers = answers;
    source.answers_length = (unsigned long)strlen(answers);
    return fourlink_results_open(&source, 1, r, mistake, NULL);
}

#endif
