/* SPDX-License-Identifier: GPL-3.0-or-later
**
** best.c - the best design of a sweep: of its grid, refined between its neighbours there.
**
** The simplex method of J. A. Nelder and R. Mead (Computer J. 7, 1965) needs no derivatives: extremes have corners.
** Every point is computed from the digits that the deck will have, so that what is printed is what was found.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_multimin.h>

#include "base/message.h"
#include "base/system.h"
#include "best.h"
#include "command.h"
#include "progress.h"
#include "tables/statistics.h"

#define DIGITS 10      /* of a refined value */
#define WORST 1e300    /* of a design that is not allowed; GSL's minimisers take finite numbers */
#define TOLERANCE 1e-8 /* of the simplex, where the neighbours are 1 apart */
#define MOST_STEPS 400

typedef struct search {
    const input *in;
    const char *name; /* of what is sought */
    double sign;      /* 1: the smallest, -1: the largest */
    const fourlink_value *conditions, *variables;
    unsigned long n_conditions, n;
    double *low, *high, *values, *best; /* by variable, in the deck's units */
    unsigned long n_free;               /* variables with neighbours */
    fourlink_source source;   /* the deck without its sweep, with the changes of the command line */
    fourlink_change *changes; /* one for each variable */
    char *texts;              /* of these, ASSIGNMENT bytes each */
    double found;             /* the smallest sign * value so far */
    fourlink_branch branch;   /* on which it is */
    int out_of_memory;
} search;

#define ASSIGNMENT 200

static int is_met(const search *s, fourlink_results *r, fourlink_branch branch, double from)
{
    fourlink_value v;
    unsigned long i;

    for (i = 0; i < s->n_conditions; i++) {
        const fourlink_value *c = &s->conditions[i];

        if (fourlink_results_get(r, c->handle, branch, from, &v) != FOURLINK_OK || v.words ||
            !statistics_meets(c, v.value))
            return 0;
    }
    return 1;
}

/* The smallest sign * value of a design on its branches; WORST if it has none, or does not meet the yield.
** Its results are freed. */
static double value_of(search *s, int status, fourlink_results *r, fourlink_branch *branch)
{
    fourlink_problem problem;
    fourlink_value v;
    double least = WORST;
    int i;

    s->out_of_memory |= status == FOURLINK_NO_MEMORY;
    if (status != FOURLINK_OK)
        return WORST;
    fourlink_deck_problem(fourlink_results_deck(r), &problem);
    for (i = FOURLINK_OPEN; i >= FOURLINK_CROSSED; i -= 2) {
        fourlink_branch b = (fourlink_branch)i;

        if (!(b == FOURLINK_OPEN ? problem.open : problem.crossed) ||
            fourlink_results_value(r, s->name, b, problem.motion.from, &v) != FOURLINK_OK ||
            v.words || !gsl_finite(v.value) || !(s->sign * v.value < least) ||
            !is_met(s, r, b, problem.motion.from))
            continue;
        least = s->sign * v.value;
        *branch = b;
    }
    fourlink_results_free(r);
    return least;
}

/* ---------------------------------------------------------------------------------------- the grid */

/* Find the best design of the grid; 0 if none is allowed. */
static int search_grid(search *s, FILE *out)
{
    fourlink_source source = s->in->source;
    unsigned long best = 0, n = s->in->problem.n_designs, i;
    fourlink_branch branch = FOURLINK_OPEN;
    progress p;

    s->found = WORST;
    progress_begin(&p, out);
    for (i = 0; i < n && !s->out_of_memory && !system_caught(); i++) {
        fourlink_results *r = NULL;
        int status = fourlink_results_design(s->in->results, i, 0, &r, NULL, NULL);
        double value = value_of(s, status, r, &branch);

        progress_tell(&p, i + 1, n);
        if (!(value < s->found))
            continue;
        s->found = value;
        s->branch = branch;
        best = i;
    }
    progress_end(&p);
    source.design = best;
    if (fourlink_source_design(&source, s->n, s->best) != FOURLINK_OK ||
        fourlink_source_neighbours(&source, s->n, s->low, s->high) != FOURLINK_OK)
        s->out_of_memory = 1;
    for (i = 0; i < s->n; i++)
        s->n_free += s->low[i] < s->high[i] || s->high[i] < s->low[i];
    return s->found < WORST && !s->out_of_memory;
}

/* ------------------------------------------------------------------------------- between neighbours */

/* The values of the free variables at a point whose coordinates go from 0 to 1 between the neighbours. */
static void set_values(search *s, const gsl_vector *x)
{
    unsigned long i;
    size_t k = 0;

    for (i = 0; i < s->n; i++) {
        double share;

        s->values[i] = s->best[i];
        if (s->low[i] == s->high[i])
            continue;
        share = gsl_vector_get(x, k++);
        share = share < 0 ? 0 : share > 1 ? 1 : share;
        s->values[i] = s->low[i] + share * (s->high[i] - s->low[i]);
    }
}

/* VALUE UNIT with the digits of the deck. */
static char *value_text(double value, int digits, const char *unit_name, char *out, size_t size)
{
    char number[FORMAT_SIZE];
    int is_plain = strcmp(unit_name, "1") == 0;

    return flk_text_join(out, size, format_general(value, digits, number), is_plain ? "" : " ",
                         is_plain ? "" : unit_name, (char *)NULL);
}

/* A value of the grid keeps its digits. */
static int digits_of(const search *s, unsigned long i)
{
    return s->low[i] == s->high[i] ? 15 : DIGITS;
}

/* Make the changes that set the variables. */
static void set_changes(search *s)
{
    char value[ASSIGNMENT];
    unsigned long i;

    for (i = 0; i < s->n; i++)
        flk_text_join(
            s->texts + ASSIGNMENT * i, ASSIGNMENT, s->variables[i].name, "=",
            value_text(s->values[i], digits_of(s, i), s->variables[i].unit, value, sizeof value),
            (char *)NULL);
}

static double value_at(const gsl_vector *x, void *data)
{
    search *s = data;
    fourlink_results *r = NULL;
    fourlink_branch branch;
    double value;
    int status;

    set_values(s, x);
    set_changes(s);
    status = fourlink_results_open(&s->source, 0, &r, NULL, NULL);
    value = value_of(s, status, r, &branch);
    if (value < s->found) {
        s->found = value;
        s->branch = branch;
        memcpy(s->low + 2 * s->n, s->values, s->n * sizeof *s->values);
    }
    return value;
}

/* Let a simplex of this size go down from the best point, with memory for it and for its first point and steps. */
static void iterate(search *s, double size, gsl_multimin_fminimizer *m, gsl_vector *x,
                    gsl_vector *steps)
{
    gsl_multimin_function f;
    const double *best = s->low + 2 * s->n;
    unsigned long i;
    size_t k = 0;
    int step;

    for (i = 0; i < s->n; i++) {
        double share;

        if (s->low[i] == s->high[i])
            continue;
        share = (best[i] - s->low[i]) / (s->high[i] - s->low[i]);
        gsl_vector_set(x, k, share);
        gsl_vector_set(steps, k++, share > 0.5 ? -size : size);
    }
    f.n = s->n_free;
    f.f = value_at;
    f.params = s;
    gsl_multimin_fminimizer_set(m, &f, x, steps);
    for (step = 0; step < MOST_STEPS && !s->out_of_memory && !system_caught(); step++)
        if (gsl_multimin_fminimizer_iterate(m) != GSL_SUCCESS ||
            gsl_multimin_fminimizer_size(m) < TOLERANCE)
            break;
}

/* GSL's own error handler would abort where there is no memory. */
static void go_down(search *s, double size)
{
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    gsl_multimin_fminimizer *m =
        gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, s->n_free);
    gsl_vector *x = gsl_vector_alloc(s->n_free), *steps = gsl_vector_alloc(s->n_free);

    if (m && x && steps)
        iterate(s, size, m, x, steps);
    else
        s->out_of_memory = 1;
    gsl_multimin_fminimizer_free(m);
    gsl_vector_free(x);
    gsl_vector_free(steps);
    gsl_set_error_handler(handler);
}

/* A second simplex goes on where the first has become flat. */
static void refine(search *s)
{
    double *best = s->low + 2 * s->n;

    memcpy(best, s->best, s->n * sizeof *best);
    if (s->n_free) {
        go_down(s, 0.3);
        go_down(s, 0.05);
    }
    memcpy(s->best, best, s->n * sizeof *best);
    memcpy(s->values, best, s->n * sizeof *best);
    set_changes(s);
}

/* ------------------------------------------------------------------------------------------ the deck */

/* The text of a deck with its values as they are, without [sweep]: memory to free, or null. */
static char *text_of(const fourlink_results *r, unsigned long *length)
{
    const fourlink_deck *deck = fourlink_results_deck(r);
    char *contents;

    fourlink_deck_write(deck, NULL, 0, length);
    contents = malloc(*length + 1);
    if (contents)
        fourlink_deck_write(deck, contents, *length + 1, length);
    return contents;
}

/* Write a deck in lines that end in LF. */
static void write_deck(FILE *out, const char *contents, unsigned long length)
{
    text deck, one;
    int end;

    deck.start = contents;
    deck.length = length;
    deck = flk_text_without_mark(deck);
    end = flk_text_line_end(deck);
    while (deck.length && flk_text_split(&deck, end, &one)) {
        one.length -= one.length && one.start[one.length - 1] == '\r';
        fwrite(one.start, 1, one.length, out);
        putc('\n', out);
    }
}

static int write_result(FILE *out, const search *s)
{
    fourlink_results *r = NULL;
    fourlink_mistake mistake;
    fourlink_value v;
    char value[ASSIGNMENT], *deck = NULL;
    unsigned long length;

    if (fourlink_results_open(&s->source, 1, &r, &mistake, NULL) != FOURLINK_OK ||
        fourlink_results_value(r, s->name, s->branch, 0, &v) != FOURLINK_OK ||
        (deck = text_of(r, &length)) == NULL) {
        fourlink_results_free(r);
        return command_complain("cannot analyse", s->in->name, "not enough memory");
    }
    fprintf(out, "# The best design of %s: %s %s = %s, %s branch.\n", s->in->name,
            s->sign > 0 ? "min" : "max", s->name,
            value_text(v.value, 6, v.unit, value, sizeof value),
            fourlink_branch_text((int)s->branch));
    write_deck(out, deck, length);
    free(deck);
    fourlink_results_free(r);
    return 0;
}

/* --------------------------------------------------------------------------------------------- all */

/* Returns 0 if out of memory. */
static int open_search(search *s, const input *in)
{
    unsigned long i;

    memset(s, 0, sizeof *s);
    s->in = in;
    s->sign = in->o->best_is_largest ? -1 : 1;
    s->name = in->o->best;
    fourlink_results_list(in->results, FOURLINK_CONDITIONS, &s->conditions, &s->n_conditions);
    fourlink_results_list(in->results, FOURLINK_VARIABLES, &s->variables, &s->n);
    s->low = calloc(5 * s->n, sizeof *s->low); /* low, high, best of all, values, best */
    s->changes = calloc(s->n, sizeof *s->changes);
    s->texts = calloc(s->n, ASSIGNMENT);
    s->source = in->source;
    s->source.text = text_of(in->results, &s->source.length);
    if (!s->low || !s->changes || !s->texts || !s->source.text)
        return 0;
    s->high = s->low + s->n;
    s->values = s->low + 3 * s->n;
    s->best = s->low + 4 * s->n;
    for (i = 0; i < s->n; i++) {
        s->changes[i].origin = "--best";
        s->changes[i].assignment = s->texts + ASSIGNMENT * i;
    }
    s->source.changes = s->changes;
    s->source.n_changes = s->n;
    s->source.design = 0;
    return 1;
}

static void close_search(search *s)
{
    free(s->low);
    free(s->changes);
    free(s->texts);
    free((void *)s->source.text);
}

/* Search, and write the design that was found; returns the exit status. */
static int find_best(FILE *out, search *s)
{
    char message[MESSAGE_SIZE];
    int is_found = search_grid(s, out);

    if (is_found && !system_caught())
        refine(s);
    if (system_caught())
        return command_complain("stopped", s->in->name, "interrupted");
    if (s->out_of_memory)
        return command_complain("cannot analyse", s->in->name, "not enough memory");
    if (is_found)
        return write_result(out, s);
    flk_message(message, sizeof message,
                s->n_conditions ? "no design has a value of %s and meets the yield"
                                : "no design has a value of %s",
                s->name);
    command_tell_mistake("--best", 0, message, NULL);
    return EXIT_ROWS;
}

int best_write(FILE *out, const input *in, int *signal_number)
{
    search s;
    int status;

    system_catch(1);
    status = open_search(&s, in)
                 ? find_best(out, &s)
                 : command_complain("cannot analyse", in->name, "not enough memory");
    system_catch(0);
    *signal_number = system_caught();
    close_search(&s);
    return status;
}
