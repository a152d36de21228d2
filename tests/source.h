/* SPDX-License-Identifier: GPL-3.0-or-later
**
** source.h - decks for tests, in strings.
*/
#ifndef FOURLINK_TEST_SOURCE_H
#define FOURLINK_TEST_SOURCE_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fourlink.h"

/* Keep some of the decks as files in the folder FOURLINK_KEEP_DECKS, if it is set; tests/web.sh tries
** them in the page. */
static inline void keep_deck(const char *contents)
{
    static unsigned long n;
    const char *folder = getenv("FOURLINK_KEEP_DECKS");
    char name[1000];
    FILE *file;

    if (!folder || strlen(folder) > 900 || (++n > 300 && n % 200))
        return;
    sprintf(name, "%s/%p-%lu.deck", folder, (void *)&n, n);
    file = fopen(name, "w");
    if (!file)
        return;
    fputs(contents, file);
    fclose(file);
}

static inline fourlink_source deck_source(const char *contents)
{
    fourlink_source source;

    keep_deck(contents);
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
