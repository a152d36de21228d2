/* SPDX-License-Identifier: GPL-3.0-or-later
**
** foreign.c - files of other tools, which are told apart from a deck with mistakes.
*/
#include <string.h>

#include "base/message.h"
#include "base/number.h"
#include "foreign.h"

/* A text from its first character that is not blank. */
static text from_first(text t)
{
    t = flk_text_without_mark(t);
    while (t.length && strchr(" \t\r\n", *t.start) && *t.start)
        t = flk_text_from(t, 1);
    return t;
}

/* The first line that is not empty. */
static text first_line(text t)
{
    text line;

    t = from_first(t);
    flk_text_split(&t, flk_text_line_end(t), &line);
    return flk_text_trim(line);
}

static int starts_with(text t, const char *start)
{
    return t.length >= strlen(start) && memcmp(t.start, start, strlen(start)) == 0;
}

static int contains(text t, const char *words)
{
    for (; t.length >= strlen(words); t = flk_text_from(t, 1))
        if (starts_with(t, words))
            return 1;
    return 0;
}

int foreign_is_link(text t)
{
    text line = first_line(t);

    return starts_with(line, "j=") ||
           (starts_with(flk_text_unquoted(line), "http") && contains(line, "?j="));
}

/* 1 for { and for [ before an element of a list, which begins no section. */
static int is_json(text t)
{
    t = from_first(t);
    if (starts_with(t, "{"))
        return 1;
    if (!starts_with(t, "["))
        return 0;
    t = from_first(flk_text_from(t, 1));
    return t.length && memchr("{[\"]-0123456789", *t.start, 15) != NULL;
}

/* A joint of PMKS: its links, R or P, its place. */
static int is_joint(text line)
{
    text field;
    double x;
    int n = 0;

    while (flk_text_split(&line, ',', &field) && !flk_text_same(flk_text_trim(field), "R") &&
           !flk_text_same(flk_text_trim(field), "P"))
        n++;
    if (!n || !flk_text_split(&line, ',', &field))
        return 0;
    field = flk_text_trim(field);
    return flk_number_read(&field, &x) == NUMBER_OK && !field.length;
}

const char *foreign_refusal(text t, const char *name, char message[400])
{
    text line = first_line(t);

    if (foreign_is_link(t))
        return flk_message(message, 400, "this is a PMKS+ link: fourlink --import=%s",
                           strcmp(name, "<stdin>") == 0 ? "-" : name);
    if (starts_with(line, "http"))
        return flk_message(message, 400,
                           contains(line, "pmksplus")
                               ? "this is a PMKS+ link whose joints are packed, which is not read: "
                                 "write their places into [pins]"
                               : "this is the address of a page, not a deck");
    if (is_joint(line) || starts_with(line, "id,x,y,") || flk_text_same(line, "joints"))
        return flk_message(message, 400,
                           "this is a PMKS text, not a deck: write the places of its joints into "
                           "[pins]");
    if (starts_with(line, "<"))
        return flk_message(message, 400, "this is an xml or html file, not a deck");
    if (is_json(t))
        return flk_message(message, 400, "this is a json file, not a deck");
    return NULL;
}
