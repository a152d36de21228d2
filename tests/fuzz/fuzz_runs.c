/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fuzz_runs.c - whole runs of the command, by its own main, without other programs.
**
** Input: a line of arguments, with tabs between them; a deck, which the command finds as x.deck and on
** standard input; after a form feed, a file y, also by the name x.expect, such as answers or names; after others, the
** files of the folder answers.  There is a folder f.  A line that begins with '>' stands for a terminal.  Standard
** output and standard error are to be thrown away, as libFuzzer's -close_fd_mask=3 does.  Lines that the command
** accepts are added to the file ACCEPTED of the environment, if there is one.
*/
#define _XOPEN_SOURCE 700

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command/convert.h"
#include "command/output.h"
#include "command/terminal.h"
#include "fourlink.h"
#include "input.h"
#include "system/memory.h"

int command_main(int argc, char **argv);
int LLVMFuzzerInitialize(int *argc, char ***argv);
/* Functions that the linker replaces: each must be one of the command's. */
extern __typeof__(output_prepare) __wrap_output_prepare;
extern __typeof__(terminal_width) __wrap_terminal_width;
extern __typeof__(convert_svg) __wrap_convert_svg;

#define MOST_ARGUMENTS 40

static char folder[400];
static int is_terminal;

/* The signals belong to libFuzzer. */
void __wrap_output_prepare(void)
{
}

unsigned long __wrap_terminal_width(FILE *out)
{
    (void)out;
    return is_terminal ? 80 : 0;
}

/* The SVG as the picture. */
const char *__wrap_convert_svg(FILE *svg, plot_file file, FILE *out, char reason[CONVERT_REASON])
{
    int c;

    (void)file;
    (void)reason;
    rewind(svg);
    while ((c = getc(svg)) != EOF)
        putc(c, out);
    return NULL;
}

/* Remove what a run has left in the current folder; a file whose name begins with a dot was a temporary one. */
static void empty_folder(void)
{
    DIR *all = opendir(".");
    struct dirent *one;

    MUST(all);
    while ((one = readdir(all)) != NULL) {
        if (strcmp(one->d_name, ".") == 0 || strcmp(one->d_name, "..") == 0)
            continue;
        MUST(strncmp(one->d_name, ".fourlink", 9) != 0);
        if (unlink(one->d_name) == 0)
            continue;
        MUST(chdir(one->d_name) == 0);
        empty_folder();
        MUST(chdir("..") == 0 && rmdir(one->d_name) == 0);
    }
    closedir(all);
}

static void remove_folder(void)
{
    if (chdir("/") == 0)
        rmdir(folder);
}

/* A folder of its own, which is the current one. */
int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    const char *parent = getenv("TMPDIR");

    (void)argc;
    (void)argv;
    snprintf(folder, sizeof folder, "%s/fuzz-runs-XXXXXX", parent ? parent : "/tmp");
    MUST(mkdtemp(folder) && chdir(folder) == 0);
    MUST(atexit(remove_folder) == 0);
    return 0;
}

static void write_file(const char *name, part p)
{
    FILE *file = fopen(name, "wb");

    MUST(file && fwrite(p.text, 1, p.length, file) == p.length);
    MUST(fclose(file) == 0);
}

/* The parts of a text with form feeds between them, as the files of a folder. */
static void write_answers(part rest)
{
    char name[] = "answers/a.txt";

    MUST(mkdir("answers", 0777) == 0);
    for (; rest.length && name[8] <= 'e'; name[8]++)
        write_file(name, take_part(&rest, '\f'));
}

/* 1 if an argument names no file outside the folder: it has '/' or ".." only in the value of an option that takes no
** file, or is one of a few with a folder. */
static int is_harmless(const char *argument)
{
    static const char *const options[] = {
        "--set=",     "--part=",   "--best=",  "--columns=", "--interval=", "--at=",
        "--plot-at=", "--plot-x=", "--solve=", "--units=",   "--tolerance="};
    static const char *const folders[] = {"--feedback=f/", "--output=f/", "--check=answers/",
                                          "--answers=answers/"};
    size_t i;

    if (!strchr(argument, '/') && !strstr(argument, ".."))
        return 1;
    for (i = 0; i < sizeof folders / sizeof folders[0]; i++)
        if (strcmp(argument, folders[i]) == 0)
            return 1;
    for (i = 0; i < sizeof options / sizeof options[0]; i++)
        if (strncmp(argument, options[i], strlen(options[i])) == 0)
            return 1;
    return 0;
}

/* The exit status; 2 for a line that is not harmless. */
static int run(char *line)
{
    char *arguments[MOST_ARGUMENTS + 2] = {"fourlink"}, *next;
    int n = 1, status;

    for (; line && n <= MOST_ARGUMENTS; line = next) {
        next = strchr(line, '\t');
        if (next)
            *next++ = '\0';
        if (!is_harmless(line))
            return 2;
        if (*line)
            arguments[n++] = line;
    }
    arguments[n] = NULL;
    status = command_main(n, arguments);
    MUST(status >= 0 && status <= 3);
    return status;
}

static void note_accepted(part line)
{
    const char *name = getenv("ACCEPTED");
    FILE *file = name ? fopen(name, "ab") : NULL;

    if (!file)
        return;
    fwrite(line.text, 1, line.length, file);
    putc('\n', file);
    fclose(file);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    part rest = {(const char *)data, size}, line = take_part(&rest, '\n');
    part deck = take_part(&rest, '\f'), given;
    char *copy = copy_part(line);
    int input;

    memory_forget_failure();
    is_terminal = *copy == '>';
    write_file("x.deck", deck);
    given = take_part(&rest, '\f');
    write_file("y", given);
    write_file("x.expect", given);
    write_answers(rest);
    MUST(mkdir("f", 0777) == 0);
    input = open("x.deck", O_RDONLY);
    MUST(input >= 0 && dup2(input, STDIN_FILENO) == STDIN_FILENO);
    close(input);
    rewind(stdin);
    if (run(copy + is_terminal) <= 1)
        note_accepted(line);
    clearerr(stdout);
    empty_folder();
    free(copy);
    return 0;
}
