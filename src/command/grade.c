/* SPDX-License-Identifier: GPL-3.0-or-later
**
** grade.c - the answers that decks are checked against: a file, or one of a folder for each deck.
*/
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "command.h"
#include "files.h"
#include "grade.h"

int grade_open(grade_answers *a, const options *o)
{
    memset(a, 0, sizeof *a);
    if (!o->check_file)
        return 0;
    a->is_folder = files_is_folder(o->check_file);
    if (a->is_folder)
        return 0;
    a->text = files_read(o->check_file, &a->length);
    return a->text ? 0 : command_complain("cannot read", o->check_file, strerror(errno));
}

/* FOLDER/NAME.expect: memory to free, or null. */
static char *path_of(const char *folder, const char *deck)
{
    const char *name = files_name(deck);
    size_t length = strlen(name), room = strlen(folder) + length + sizeof "/.expect";
    char *path = malloc(room);

    if (!path)
        return NULL;
    strcpy(path, folder);
    if (*files_name(folder))
        strcat(path, "/");
    if (length > 5 && strcmp(name + length - 5, ".deck") == 0)
        length -= 5;
    return strcat(strncat(path, name, length), ".expect");
}

int grade_read(grade_answers *a, const options *o, const char *deck, char why[400])
{
    int reason;

    memset(a, 0, sizeof *a);
    if (strcmp(deck, "-") == 0) {
        flk_message(why, 400, "standard input has no name: --check needs a file, not a folder");
        command_tell_mistake("<stdin>", 0, why, NULL);
        return EXIT_USAGE;
    }
    a->path = path_of(o->check_file, deck);
    if (a->path && files_is_output(o, a->path))
        return command_complain("cannot write", a->path, "it is also read");
    a->text = a->path ? files_read_path(a->path, &a->length) : NULL;
    if (a->text)
        return 0;
    reason = a->path ? errno : ENOMEM;
    if (files_is_missing(reason))
        flk_message(why, 400, "cannot read %s: %s", a->path, strerror(reason));
    return command_complain("cannot read", a->path ? a->path : deck, strerror(reason));
}

void grade_close(grade_answers *a)
{
    free(a->path);
    free(a->text);
}
