/* SPDX-License-Identifier: GPL-3.0-or-later
**
** files.c - the files of the command line: reading them, and which are the same.
*/
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "system/memory.h"
#include "system/system.h"
#include "command.h"
#include "files.h"

#define LARGEST_FILE 67108864 /* bytes */

/* Read a whole stream; null with errno set if that fails. */
static char *read_stream(FILE *file, size_t *length)
{
    size_t capacity = 65536, n = 0;
    char *contents = NULL, *more;
    int reason;

    while (capacity <= LARGEST_FILE && (more = memory_grow(contents, capacity, 1)) != NULL) {
        contents = more;
        n += fread(contents + n, 1, capacity - n, file);
        if (n == capacity) {
            capacity *= 2;
            continue;
        }
        if (ferror(file))
            break;
        *length = n;
        more = memory_grow(contents, n + 1, 1);
        return more ? more : contents;
    }
    reason = capacity > LARGEST_FILE ? EFBIG : errno;
    memory_note_reason(reason);
    free(contents);
    errno = reason;
    return NULL;
}

/* The same of a file that has been opened, or null. */
static char *read_opened(FILE *file, size_t *length)
{
    char *contents = file ? read_stream(file, length) : NULL;
    int reason = errno;

    if (file)
        fclose(file);
    else
        memory_note_reason(reason);
    errno = reason;
    return contents;
}

char *files_read_path(const char *path, size_t *length)
{
    return read_opened(system_open(path, "rb"), length);
}

char *files_read_regular(const char *path, size_t *length)
{
    return read_opened(system_open_regular(path), length);
}

char *files_read(const char *path, size_t *length)
{
    return strcmp(path, "-") == 0 ? read_stream(stdin, length) : files_read_path(path, length);
}

/* 1 if a path names a folder above it, or begins at the root. */
static int climbs(const char *path)
{
    const char *at;

    if (system_is_absolute(path))
        return 1;
    for (at = path; *at; at++)
        if (at[0] == '.' && at[1] == '.' && (!at[2] || system_is_separator(at[2])) &&
            (at == path || system_is_separator(at[-1])))
            return 1;
    return 0;
}

int files_is_beside(const char *path, const char *name)
{
    char *folder = files_beside(path, "."), *file = files_beside(path, name);
    int is_beside = 0;

    if (!folder || !file)
        errno = ENOMEM;
    else if (climbs(name))
        errno = 0;
    else
        is_beside = system_is_within(folder, file);
    free(folder);
    free(file);
    return is_beside;
}

int files_is_missing(int reason)
{
    return reason == ENOENT || reason == ENOTDIR;
}

int files_is_folder(const char *path)
{
    return system_kind_of(path) == SYSTEM_FOLDER;
}

int files_make_folder(const char *path)
{
    char *above = files_beside("", path), *end;
    int is_made = above != NULL;

    for (end = above; is_made && *end; end++)
        if (end > above && system_is_separator(*end)) {
            *end = '\0';
            is_made = system_make_folder(above);
            *end = path[end - above];
        }
    is_made = is_made && system_may_write(path);
    free(above);
    if (is_made)
        return 0;
    return memory_has_failed() ? command_lacks_memory("cannot make", path)
                               : command_complain("cannot make", path, strerror(errno));
}

const char *files_name(const char *path)
{
    const char *name = path;

    for (; *path; path++)
        if (system_is_separator(*path))
            name = path + 1;
    return name;
}

text files_stem(const char *path)
{
    text name = flk_text_of(files_name(path));

    if (flk_text_ends_in(name, ".deck"))
        name.length -= strlen(".deck");
    return name;
}

char *files_within(const char *folder, text name, const char *ending)
{
    char *path = memory_get(strlen(folder) + name.length + strlen(ending) + sizeof "/", 1);

    if (path)
        sprintf(path, "%s%s%.*s%s", folder, *files_name(folder) ? "/" : "", (int)name.length,
                name.start, ending);
    return path;
}

char *files_beside(const char *path, const char *name)
{
    size_t folder = system_is_absolute(name) ? 0 : (size_t)(files_name(path) - path);
    char *beside = memory_get(folder + strlen(name) + 1, 1);

    if (beside) {
        memcpy(beside, path, folder);
        strcpy(beside + folder, name);
    }
    return beside;
}

char *files_resolve(const char *path)
{
    char *real = files_beside("", path), *next, target[4096];
    int links;

    for (links = 0; real && links < 40 && system_read_link(real, target, sizeof target); links++) {
        next = files_beside(real, target);
        free(real);
        real = next;
    }
    return real;
}

/* 1 if an output would replace an input, which is "-" for standard input. */
static int replaces(const char *output, const char *input)
{
    return output && system_kind_of(output) == SYSTEM_FILE &&
           (strcmp(input, "-") == 0 ? system_is_open_as(output, stdin)
                                    : system_is_same(output, input));
}

#define OUTPUTS 4

/* The files that will be written; null: none. */
static void list_outputs(const options *o, const char *outputs[OUTPUTS])
{
    outputs[0] = o->output;
    outputs[1] = o->plot;
    outputs[2] = o->report;
    outputs[3] = o->quiz;
}

int files_is_output(const options *o, const char *path)
{
    const char *outputs[OUTPUTS];
    int i, is_one = 0;

    list_outputs(o, outputs);
    for (i = 0; i < OUTPUTS; i++)
        is_one |= replaces(outputs[i], path);
    return is_one;
}

/* 1 if two paths, without links at their ends, name the same file of one folder. */
static int is_same_name(const char *x, const char *y)
{
    char *folder = files_beside(x, "."), *other = files_beside(y, ".");
    int is_one = folder && other && system_is_same(folder, other) &&
                 strcmp(files_name(x), files_name(y)) == 0;

    free(folder);
    free(other);
    return is_one;
}

/* 1 if two paths lead to the same place, even if there is no file yet. */
static int is_same_place(const char *x, const char *y)
{
    char *target, *other;
    int is_one;

    if (!x || !y || strcmp(x, "-") == 0 || strcmp(y, "-") == 0)
        return 0;
    if (system_kind_of(x) != SYSTEM_NOTHING && system_kind_of(y) != SYSTEM_NOTHING)
        return system_kind_of(x) == SYSTEM_FILE && system_is_same(x, y);
    target = files_resolve(x);
    other = files_resolve(y);
    is_one = target && other && is_same_name(target, other);
    free(target);
    free(other);
    return is_one;
}

int files_tell_clash(const options *o)
{
    const char *outputs[OUTPUTS];
    size_t deck;
    int i, k, is_read;

    list_outputs(o, outputs);
    for (i = 0; i < OUTPUTS; i++) {
        is_read = (o->check_file && replaces(outputs[i], o->check_file)) ||
                  (o->names && replaces(outputs[i], o->names)) ||
                  (o->exercise && replaces(outputs[i], o->exercise));
        for (deck = 0; deck < o->n_decks; deck++)
            is_read |= replaces(outputs[i], o->decks[deck]);
        if (is_read)
            return command_complain("cannot write", outputs[i], "it is also read");
    }
    for (i = 1; i < OUTPUTS; i++)
        for (k = 0; k < i; k++)
            if (is_same_place(outputs[k], outputs[i]))
                return command_complain("cannot write", outputs[i], "two outputs have this name");
    return 0;
}
