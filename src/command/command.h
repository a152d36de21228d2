/* SPDX-License-Identifier: GPL-3.0-or-later
**
** command.h - exit status and complaints of the command.
*/
#ifndef FOURLINK_COMMAND_H
#define FOURLINK_COMMAND_H

enum { EXIT_ROWS = 1, EXIT_USAGE = 2, EXIT_FILES = 3 };

/* The worse of two. */
int command_worse(int status, int other);

/* "fourlink: WHAT NAME: WHY"; EXIT_FILES. */
int command_complain(const char *what, const char *name, const char *why);

/* A mistake: FILE:LINE: error: MESSAGE; line 0 is no line.  `deck_name` is not null where several decks
** are worked on: it is told where the mistake stands in none of them. */
void command_tell_mistake(const char *file, long line, const char *message, const char *deck_name);

#endif
