/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fuzz_runs.c - whole runs of the command, by its own main, without other programs.
**
** Input: a line of arguments, with tabs between them; a deck, which the command finds as x.deck and on
** standard input; after a form feed, a file y, such as answers.  A line that begins with '>' stands for a
** terminal.  Standard output and standard error are to be thrown away, as libFuzzer's -close_fd_mask=3 does.
*/
#define _XOPEN_SOURCE 700

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include "command/convert.h"
#include "command/output.h"
#include "command/terminal.h"
#include "fourlink.h"
#include "input.h"

int command_main(int argc, char **argv);
int LLVMFuzzerInitialize(int *argc, char ***argv);
/* Functions that the linker replaces: each must be one of the command's. */
extern __typeof__(output_prepare) __wrap_output_prepare;
extern __typeof__(terminal_width) __wrap_terminal_width;
extern __typeof__(convert_svg) __wrap_convert_svg;
extern __typeof__(fourlink_results_open) __wrap_fourlink_results_open;
extern __typeof__(fourlink_results_open) __real_fourlink_results_open;

#define MOST_ROWS 100
#define MOST_DESIGNS 10
#define MOST_COLUMNS 20
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

/* Long and wide tables and sweeps take as long as they are asked to: here they are as if memory ran out. */
int __wrap_fourlink_results_open(const fourlink_source *source, unsigned long max_mistakes,
                                 fourlink_results **results, fourlink_mistake *mistakes,
                                 unsigned long *n_mistakes)
{
    int status = __real_fourlink_results_open(source, max_mistakes, results, mistakes, n_mistakes);
    const fourlink_value *columns;
    unsigned long n_columns;
    fourlink_problem p;

    if (status != FOURLINK_OK)
        return status;
    fourlink_deck_problem(fourlink_results_deck(*results), &p);
    fourlink_results_list(*results, FOURLINK_COLUMNS, &columns, &n_columns);
    if (p.n_rows <= (n_columns > MOST_COLUMNS ? 4 : MOST_ROWS) && p.n_designs <= MOST_DESIGNS)
        return status;
    fourlink_results_free(*results);
    *results = NULL;
    return FOURLINK_NO_MEMORY;
}

/* Remove what a run has left; a file whose name begins with a dot was a temporary one. */
static void empty_folder(void)
{
    DIR *all = opendir(".");
    struct dirent *one;

    MUST(all);
    while ((one = readdir(all)) != NULL)
        if (strcmp(one->d_name, ".") != 0 && strcmp(one->d_name, "..") != 0) {
            MUST(strncmp(one->d_name, ".fourlink", 9) != 0);
            MUST(unlink(one->d_name) == 0);
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

/* 1 if an argument names no file outside the folder.  Other arguments may have a '/' only in the value of an
** option that takes no file. */
static int is_harmless(const char *argument)
{
    static const char *const options[] = {"--set=",      "--part=", "--best=",    "--columns=",
                                          "--interval=", "--at=",   "--plot-at=", "--plot-x="};
    size_t i;

    if (!strchr(argument, '/'))
        return strcmp(argument, "..") != 0;
    for (i = 0; i < sizeof options / sizeof options[0]; i++)
        if (strncmp(argument, options[i], strlen(options[i])) == 0)
            return 1;
    return 0;
}

static void run(char *line)
{
    char *arguments[MOST_ARGUMENTS + 2] = {"fourlink"}, *next;
    int n = 1, status;

    for (; line && n <= MOST_ARGUMENTS; line = next) {
        next = strchr(line, '\t');
        if (next)
            *next++ = '\0';
        if (!is_harmless(line))
            return;
        if (*line)
            arguments[n++] = line;
    }
    arguments[n] = NULL;
    status = command_main(n, arguments);
    MUST(status >= 0 && status <= 3);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    part rest = {(const char *)data, size}, line = take_part(&rest, '\n');
    part deck = take_part(&rest, '\f');
    char *copy = copy_part(line);
    int input;

    is_terminal = *copy == '>';
    write_file("x.deck", deck);
    write_file("y", rest);
    input = open("x.deck", O_RDONLY);
    MUST(input >= 0 && dup2(input, STDIN_FILENO) == STDIN_FILENO);
    close(input);
    rewind(stdin);
    run(copy + is_terminal);
    clearerr(stdout);
    empty_folder();
    free(copy);
    return 0;
}
