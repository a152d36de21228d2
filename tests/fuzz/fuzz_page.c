/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fuzz_page.c - the page's program by its entry points, as worker.js calls them.
**
** Input: a line of calls, with tabs between them, each a letter and what it takes; a deck.  The calls: scene, curve,
** rows, run, label, quantity, or another solution.  Standard output and standard error are to be thrown away.
*/
#include <math.h>

#include "fourlink.h"
#include "input.h"
#include "system.c"

char *web_room(unsigned long length);
const char *web_answer(void);
unsigned long web_answer_length(void);
int web_open(unsigned long name_length, unsigned long length, unsigned long solution, int after);
int web_scene(int branch, double at, int wanted);
int web_curve(void);
const double *web_rows(int branch, unsigned long first, unsigned long n);
const char *web_status_text(int status);
int web_command(int n, unsigned long length);
const char *web_written_name(int k);
const char *web_written(int k);
unsigned long web_written_length(int k);
int web_style(void);
int web_label(void);
double web_quantity(int is_angle);

#define MOST_CALLS 6
#define NAME "x.deck"

static void give(const char *words, size_t length)
{
    char *room = web_room((unsigned long)length);

    MUST(room);
    memcpy(room, words, length);
    room[length] = '\0';
}

/* The answer is JSON, or an SVG, without a byte 0. */
static void take_answer(void)
{
    MUST(web_answer() && web_answer_length() > 1);
    MUST(strlen(web_answer()) == web_answer_length());
}

static int open_deck(part deck, unsigned long solution)
{
    char *both = malloc(sizeof NAME + deck.length);
    int status;

    MUST(both);
    memcpy(both, NAME, sizeof NAME);
    memcpy(both + sizeof NAME, deck.text, deck.length);
    give(both, sizeof NAME + deck.length);
    free(both);
    status = web_open(sizeof NAME, (unsigned long)deck.length, solution, (int)(deck.length % 3));
    if (status != FOURLINK_NO_MEMORY) /* of a large deck; see small.c */
        take_answer();
    return status == FOURLINK_OK;
}

static void ask_rows(int branch)
{
    const double *rows = web_rows(branch, 0, 5);

    MUST(rows);
    MUST(web_status_text(0));
}

/* A new instance of the page's program has no files. */
static void forget_files(void)
{
    while (n_written > 0) {
        free((char *)written[--n_written].name);
        free(written[n_written].text);
        memset(&written[n_written], 0, sizeof written[n_written]);
    }
}

/* fourlink OPTION... NAME, the options with vertical bars between them. */
static void run(char *options, part deck)
{
    size_t used = strlen(options) + 1, total = sizeof "fourlink" + used + sizeof "--" + sizeof NAME;
    char *room = web_room((unsigned long)(total + deck.length)), *at;
    int n = 3, status, k;

    MUST(room);
    memcpy(room, "fourlink", sizeof "fourlink");
    at = room + sizeof "fourlink";
    if (*options) {
        memcpy(at, options, used);
        for (n++; *at; at++)
            if (*at == '|') {
                *at = '\0';
                n++;
            }
        at++;
    }
    memcpy(at, "--", sizeof "--");
    memcpy(at + sizeof "--", NAME, sizeof NAME);
    at += sizeof "--" + sizeof NAME;
    memcpy(at, deck.text, deck.length);
    at[deck.length] = '\0';
    status = web_command(n, (unsigned long)deck.length);
    MUST(status >= 0 && status <= 3);
    for (k = 0; web_written_name(k); k++)
        MUST(web_written(k) || !web_written_length(k));
    forget_files();
}

/* One call, with a branch of the page's numbers where it takes one. */
static void call(char *words, part deck, int *is_open)
{
    const char *arguments = *words ? words + 1 : words;
    int branch = *arguments == 'x' ? -1 : *arguments == 'o' ? 1 : 0;

    switch (*words) {
    case 'r':
        run(words + 1, deck);
        break;
    case 's': /* scene: branch, wanted, angle */
        if (*is_open && web_scene(branch, strtod(branch ? arguments + 1 : arguments, NULL),
                                  (int)(strlen(arguments) % 3)))
            take_answer();
        break;
    case 'c':
        give(arguments, strlen(arguments));
        if (*is_open && web_curve())
            take_answer();
        break;
    case 'n':
        if (*is_open)
            ask_rows(branch ? branch : 1);
        break;
    case 'l':
        give(arguments, strlen(arguments));
        MUST(web_label());
        take_answer();
        break;
    case 'q':
        give(arguments, strlen(arguments));
        MUST(!isinf(web_quantity(0)));
        MUST(!isinf(web_quantity(1)));
        break;
    case 'o':
        *is_open = open_deck(deck, strtoul(arguments, NULL, 10));
        break;
    default:
        MUST(web_style());
        take_answer();
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    part deck = {(const char *)data, size}, line = take_part(&deck, '\n');
    char *calls = copy_part(line), *next = calls, *one;
    int is_open = open_deck(deck, 1), n;

    for (n = 0; next && n < MOST_CALLS; n++) {
        one = next;
        next = strchr(one, '\t');
        if (next)
            *next++ = '\0';
        call(one, deck, &is_open);
    }
    free(calls);
    return 0;
}
