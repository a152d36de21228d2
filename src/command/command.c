/* SPDX-License-Identifier: GPL-3.0-or-later
**
** command.c - exit status and messages of the command.
*/
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/message.h"
#include "system/memory.h"
#include "command.h"

static int silent, withheld, coloured, told_of_memory;

int command_be_silent(int is_silent)
{
    int had = withheld;

    silent = is_silent;
    withheld = 0;
    return had;
}

void command_be_coloured(int is_coloured)
{
    coloured = is_coloured;
}

int command_worse(int status, int other)
{
    return other > status ? other : status;
}

/* Print words; what is not printable becomes a question mark, so that no name can command the terminal or
** pretend to be another line. */
static void print(const char *words)
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

void command_say(const char *first, ...)
{
    const char *words;
    va_list more;

    withheld |= silent;
    if (silent)
        return;
    va_start(more, first);
    for (words = first; words; words = va_arg(more, const char *))
        print(words);
    va_end(more);
    putc('\n', stderr);
}

int command_complain(const char *what, const char *name, const char *why)
{
    command_say("fourlink: ", what, *name ? " " : "", name, ": ", why, (char *)NULL);
    return EXIT_FILES;
}

int command_lacks_memory(const char *what, const char *name)
{
    told_of_memory |= !silent;
    return command_complain(what, name, "not enough memory");
}

int command_end(int status)
{
    if (!memory_has_failed())
        return status;
    if (!told_of_memory)
        command_lacks_memory("stopped", "");
    told_of_memory = 0;
    return EXIT_FILES;
}

#define RED "\033[1;31m"
#define YELLOW "\033[33m"
#define PLAIN "\033[0m"

void command_tell(const char *what, const char *file, long line, const char *message,
                  const char *deck_name)
{
    int is_elsewhere = deck_name && strcmp(file, deck_name) != 0;
    char where[40] = "";

    withheld |= silent;
    if (silent)
        return;
    if (line)
        flk_message(where, sizeof where, ":%ld", line);
    print(line ? "" : "fourlink: ");
    print(file);
    print(where);
    print(": ");
    if (coloured)
        fputs(strcmp(what, "error") == 0 ? RED : YELLOW, stderr);
    print(what);
    if (coloured)
        fputs(PLAIN, stderr);
    command_say(": ", message, is_elsewhere ? " (" : "", is_elsewhere ? deck_name : "",
                is_elsewhere ? ")" : "", (char *)NULL);
}

#define MOST_TOLD 64

void command_tell_once(const char *what, const char *option, const char *message,
                       const char *deck_name)
{
    static char told[MOST_TOLD][MESSAGE_SIZE];
    static int n_told;
    int i;

    for (i = 0; i < n_told; i++)
        if (strcmp(told[i], message) == 0)
            return;
    if (n_told < MOST_TOLD && !silent)
        flk_message(told[n_told++], MESSAGE_SIZE, "%s", message);
    command_tell(what, option, 0, message, deck_name);
}

void command_tell_more(unsigned long n, const char *what)
{
    char number[40];

    if (n > MOST_MISTAKES)
        command_say("fourlink: and ",
                    flk_message(number, sizeof number, "%ld", (long)n - MOST_MISTAKES), " more ",
                    what, n - MOST_MISTAKES > 1 ? "s" : "", (char *)NULL);
}
