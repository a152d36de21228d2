/* SPDX-License-Identifier: GPL-3.0-or-later
**
** convert.c - runs rsvg-convert and Chromium, without a shell.
*/
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "system/memory.h"
#include "system/system.h"
#include "convert.h"
#include "files.h"

/* Why a program that was found has made nothing, in its own words; null if it has. */
static const char *reason_of(const system_outcome *o, const char *program, FILE *complaints,
                             char reason[CONVERT_REASON])
{
    char words[CONVERT_REASON / 2] = "";

    if (o->status == 0 && o->copied > 0)
        return NULL;
    rewind(complaints);
    if (fgets(words, sizeof words, complaints))
        words[strcspn(words, "\n")] = '\0';
    return flk_text_join(reason, CONVERT_REASON, program, " failed", words[0] ? ": " : "", words,
                         (char *)NULL);
}

const char *convert_svg(FILE *svg, plot_file file, FILE *out, char reason[CONVERT_REASON])
{
    static const char *const png[] = {"rsvg-convert", "--format=png", "--zoom=2", NULL},
                             *const pdf[] = {"rsvg-convert", "--format=pdf", NULL};
    FILE *complaints = system_scratch();
    system_outcome outcome;
    const char *why;

    if (!complaints)
        return strerror(errno);
    if (!system_run(file == PLOT_PNG ? png : pdf, svg, out, complaints, &outcome))
        why = strerror(errno);
    else if (!outcome.is_found)
        why = "rsvg-convert, which makes png and pdf, is not installed; its package is "
              "librsvg2-bin (Debian, Ubuntu); .svg needs no other program";
    else
        why = reason_of(&outcome, "rsvg-convert", complaints, reason);
    fclose(complaints);
    return why;
}

/* ---------------------------------------------------------------------------------------- pages of HTML */

/* Chromium prints to the pipe that is its standard output; as root it wants to be told that there is no
** sandbox. */
#define TO_PIPE "--print-to-pdf=/dev/stdout"
#define NO_SANDBOX "--no-sandbox"

/* Run a browser on a file; it does not read its input.  1; 0 with errno set. */
static int run_browser(const char *program, const char *name, FILE *out, FILE *complaints,
                       system_outcome *outcome)
{
    const char *arguments[] = {
        NULL, "--headless", "--disable-gpu", "--no-pdf-header-footer", TO_PIPE, NULL, NULL, NULL};
    char words[CONVERT_REASON];
    int asks = 0;

    arguments[0] = program;
    arguments[5] = name;
    if (!system_run(arguments, complaints, out, complaints, outcome))
        return 0;
    rewind(complaints);
    while (outcome->is_found && outcome->status != 0 && fgets(words, sizeof words, complaints))
        asks = asks || strstr(words, NO_SANDBOX);
    if (!asks)
        return 1;
    arguments[5] = NO_SANDBOX;
    arguments[6] = name;
    return system_run(arguments, complaints, out, complaints, outcome);
}

/* Print a file of HTML with the first browser that is there. */
static const char *print_page(const char *name, FILE *out, char reason[CONVERT_REASON])
{
    static const char *const browsers[] = {"chromium", "chromium-browser", "google-chrome", NULL};
    const char *const *browser = browsers, *why;
    FILE *complaints = system_scratch();
    system_outcome outcome;
    int is_run = complaints != NULL;

    memset(&outcome, 0, sizeof outcome);
    for (; is_run && *browser && !outcome.is_found; browser++)
        is_run = run_browser(*browser, name, out, complaints, &outcome);
    if (!is_run)
        why = strerror(errno);
    else if (!outcome.is_found)
        why = "Chromium, which makes pdf of a report, is not installed; its package is chromium "
              "(Debian, Ubuntu); .html needs no other program";
    else
        why = reason_of(&outcome, browser[-1], complaints, reason);
    if (complaints)
        fclose(complaints);
    return why;
}

int convert_copy(FILE *from, FILE *to)
{
    char part[8192];
    size_t n;

    rewind(from);
    while ((n = fread(part, 1, sizeof part, from)) > 0)
        if (fwrite(part, 1, n, to) != n)
            return 0;
    return !ferror(from) && fflush(to) == 0;
}

/* Make a file of a page, with a name of its own; both are memory of the caller.  1; 0 with errno set. */
static int make_file(FILE *page, char *work, char *name, const char *like)
{
    FILE *file = system_create(work, like);
    int is_made = file && convert_copy(page, file), reason;

    if (file && fclose(file) != 0)
        is_made = 0;
    strcpy(name, work);
    strcat(name, ".html");
    if (is_made && system_rename(work, name)) {
        system_watch(name);
        return 1;
    }
    reason = errno;
    if (file)
        system_remove(work);
    errno = reason;
    return 0;
}

const char *convert_page(FILE *page, const char *path, FILE *out, char reason[CONVERT_REASON])
{
    char *work = files_beside(path, "fourlinkXXXXXX");
    char *name = work ? memory_get(1, strlen(work) + sizeof ".html") : NULL;
    const char *why;

    if (!name) {
        why = "not enough memory";
    } else if (!make_file(page, work, name, path)) {
        why = strerror(errno);
    } else {
        why = print_page(name, out, reason);
        system_remove(name);
    }
    free(name);
    free(work);
    return why;
}
