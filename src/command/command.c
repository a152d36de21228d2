/* SPDX-License-Identifier: GPL-3.0-or-later
**
** command.c - exit status and messages of the command.
*/
#include <stdio.h>
#include <string.h>

#include "command.h"

int command_worse(int status, int other)
{
    return other > status ? other : status;
}

int command_complain(const char *what, const char *name, const char *why)
{
    fprintf(stderr, "fourlink: %s %s: %s\n", what, name, why);
    return EXIT_FILES;
}

static void tell(const char *what, const char *file, long line, const char *message,
                 const char *deck_name)
{
    if (!line)
        fprintf(stderr, "fourlink: %s: %s: %s", file, what, message);
    else
        fprintf(stderr, "%s:%ld: %s: %s", file, line, what, message);
    if (deck_name && strcmp(file, deck_name) != 0)
        fprintf(stderr, " (%s)", deck_name);
    putc('\n', stderr);
}

void command_tell_mistake(const char *file, long line, const char *message, const char *deck_name)
{
    tell("error", file, line, message, deck_name);
}

void command_tell_note(const char *file, long line, const char *message, const char *deck_name)
{
    tell("note", file, line, message, deck_name);
}
