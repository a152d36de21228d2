/* SPDX-License-Identifier: GPL-3.0-or-later
**
** command.c - exit status and messages of the command.
*/
#include <stdio.h>
#include <string.h>

#include "base/message.h"
#include "command.h"

int command_worse(int status, int other)
{
    return other > status ? other : status;
}

void command_print(const char *words)
{
    text rest = flk_text_of(words), run = rest;

    while (rest.length) {
        size_t n = flk_text_printable(rest);

        rest = flk_text_from(rest, n ? n : 1);
        if (n && rest.length)
            continue;
        /* one call for what is printable: standard error has no buffer */
        fwrite(run.start, 1, run.length - rest.length - !n, stderr);
        if (!n)
            putc('?', stderr);
        run = rest;
    }
}

int command_complain(const char *what, const char *name, const char *why)
{
    fputs("fourlink: ", stderr);
    command_print(what);
    putc(' ', stderr);
    command_print(name);
    fputs(": ", stderr);
    command_print(why);
    putc('\n', stderr);
    return EXIT_FILES;
}

static void tell(const char *what, const char *file, long line, const char *message,
                 const char *deck_name)
{
    if (!line)
        fputs("fourlink: ", stderr);
    command_print(file);
    if (line)
        fprintf(stderr, ":%ld", line);
    fprintf(stderr, ": %s: ", what);
    command_print(message);
    if (deck_name && strcmp(file, deck_name) != 0) {
        fputs(" (", stderr);
        command_print(deck_name);
        putc(')', stderr);
    }
    putc('\n', stderr);
}

void command_tell_mistake(const char *file, long line, const char *message, const char *deck_name)
{
    tell("error", file, line, message, deck_name);
}

void command_tell_more(unsigned long n, const char *what)
{
    if (n > MOST_MISTAKES)
        fprintf(stderr, "fourlink: and %lu more %s%s\n", n - MOST_MISTAKES, what,
                n - MOST_MISTAKES > 1 ? "s" : "");
}

void command_tell_note(const char *file, long line, const char *message, const char *deck_name)
{
    tell("note", file, line, message, deck_name);
}

void command_tell(const char *what, const char *file, long line, const char *message)
{
    tell(what, file, line, message, NULL);
}
