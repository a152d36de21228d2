/* SPDX-License-Identifier: GPL-3.0-or-later
**
** command.h - exit status and messages of the command.
*/
#ifndef FOURLINK_COMMAND_H
#define FOURLINK_COMMAND_H

enum { EXIT_ROWS = 1, EXIT_USAGE = 2, EXIT_FILES = 3 };

/* The worse of two exit statuses. */
int command_worse(int status, int other);

/* Print strings, up to a null pointer, as a line of messages. */
void command_say(const char *first, ...);

/* Print no messages (1), or print them again (0): those of what is read twice.  Returns 1 if some were
** not printed. */
int command_be_silent(int is_silent);

/* Print what a message is, such as error, in colour. */
void command_be_coloured(int is_coloured);

/* Print "fourlink: WHAT NAME: WHY"; returns EXIT_FILES. */
int command_complain(const char *what, const char *name, const char *why);

/* The same where memory has failed. */
int command_lacks_memory(const char *what, const char *name);

/* The exit status of the run: where memory has failed, that of a failure, with a message if there was
** none. */
int command_end(int status);

/* Print a message about a file, FILE:LINE: error: MESSAGE, or another word for "error"; without the
** line if it is 0.  `deck_name` is null if there is only one deck; otherwise it is added if the message
** is about another file. */
void command_tell(const char *what, const char *file, long line, const char *message,
                  const char *deck_name);

/* The same of an option, of many decks, which is told for the first of them alone. */
void command_tell_once(const char *what, const char *option, const char *message,
                       const char *deck_name);

/* After the first MOST_MISTAKES of `n` mistakes or notes, print how many more there are. */
void command_tell_more(unsigned long n, const char *what);

#endif
