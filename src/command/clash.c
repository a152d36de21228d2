/* SPDX-License-Identifier: GPL-3.0-or-later
**
** clash.c - whether what is to be written is something else already.
*/
#define _POSIX_C_SOURCE 200112L

#include <stddef.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "clash.h"

/* 1 if an input, "-" for standard input, is the file of this status. */
static int is_file(const char *input, const struct stat *file)
{
    struct stat in;
    int status = strcmp(input, "-") == 0 ? fstat(STDIN_FILENO, &in) : stat(input, &in);

    return status == 0 && in.st_dev == file->st_dev && in.st_ino == file->st_ino;
}

int clash_is_output(const options *o, const char *path)
{
    const char *outputs[3];
    struct stat out;
    int i;

    outputs[0] = o->output;
    outputs[1] = o->plot;
    outputs[2] = o->plot_script;
    for (i = 0; i < 3; i++)
        if (outputs[i] && stat(outputs[i], &out) == 0 && S_ISREG(out.st_mode) &&
            is_file(path, &out))
            return 1;
    return 0;
}

/* 1 if the output file is one of the decks, or the file of answers, which it would replace. */
static int is_input(const char *path, const options *o)
{
    struct stat out;
    size_t i;

    if (stat(path, &out) != 0 || !S_ISREG(out.st_mode))
        return 0;
    if (o->check_file && is_file(o->check_file, &out))
        return 1;
    for (i = 0; i < o->n_decks; i++)
        if (is_file(o->decks[i], &out))
            return 1;
    return 0;
}

/* 1 if two paths lead to the same place, whether there is a file yet or not. */
static int is_same_place(const char *x, const char *y)
{
    const char *a, *b;
    char folder[2][4096];
    struct stat in[2];
    int i;

    if (!x || !y || strcmp(x, "-") == 0 || strcmp(y, "-") == 0)
        return 0;
    if (stat(x, &in[0]) == 0 && stat(y, &in[1]) == 0)
        return S_ISREG(in[0].st_mode) && in[0].st_dev == in[1].st_dev &&
               in[0].st_ino == in[1].st_ino;
    for (i = 0; i < 2; i++) {
        const char *path = i ? y : x, *slash = strrchr(path, '/');
        size_t n = slash ? (size_t)(slash - path) + 1 : 0;

        if (n + 2 > sizeof folder[i])
            return 0;
        memcpy(folder[i], path, n);
        strcpy(folder[i] + n, ".");
        if (stat(folder[i], &in[i]) != 0)
            return 0;
    }
    a = strrchr(x, '/');
    b = strrchr(y, '/');
    return in[0].st_dev == in[1].st_dev && in[0].st_ino == in[1].st_ino &&
           strcmp(a ? a + 1 : x, b ? b + 1 : y) == 0;
}

const char *clash_output_given_twice(const options *o)
{
    return is_same_place(o->output, o->plot) || is_same_place(o->plot, o->plot_script) ? o->plot
           : is_same_place(o->output, o->plot_script) ? o->plot_script
                                                      : NULL;
}

const char *clash_input_among_outputs(const options *o)
{
    return o->output && is_input(o->output, o)             ? o->output
           : o->plot && is_input(o->plot, o)               ? o->plot
           : o->plot_script && is_input(o->plot_script, o) ? o->plot_script
                                                           : NULL;
}
