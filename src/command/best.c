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
#include "rewrite.h"
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
    fourlink_source source;             /* the deck without its sweep */
    fourlink_change *changes;           /* those of the command line, and one for each variable */
    char *texts;                        /* of the latter, ASSIGNMENT bytes each */
    unsigned long n_kept;               /* changes of the command line */
    double found;                       /* the smallest sign * value so far */
    fourlink_branch branch;             /* on which it is */
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

/* The smallest sign * value of a design on its branches; WORST if it has none, or does not meet the yield. */
static double value_of(search *s, const fourlink_source *source, fourlink_branch *branch)
{
    fourlink_results *r = NULL;
    fourlink_problem problem;
    fourlink_mistake mistake;
    fourlink_value v;
    double least = WORST;
    int status = fourlink_results_open(source, 1, &r, &mistake, NULL), i;

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
        double value;

        source.design = i;
        value = value_of(s, &source, &branch);
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
    fourlink_branch branch;
    double value;

    set_values(s, x);
    set_changes(s);
    value = value_of(s, &s->source, &branch);
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

/* 1 if an input is SECTION.KEY.PART; a section without a name means the only one. */
static int is_input(const char *name, text section, text key, const char *part)
{
    text vector, end, head, last;

    return flk_text_cut_last(flk_text_of(name), ".", &vector, &end) && flk_text_same(end, part) &&
           flk_text_cut_last(vector, ".", &head, &last) && rewrite_same(last, key) &&
           (rewrite_same(head, section) ||
            (head.length > section.length && head.start[section.length] == ' ' &&
             (head.length = section.length, rewrite_same(head, section))));
}

/* A component of a vector of the deck; 0 if there is no such input. */
static double input_of(fourlink_results *r, text section, text key, const char *part,
                       const char **unit_name)
{
    const fourlink_value *list;
    unsigned long n, i;

    fourlink_results_list(r, FOURLINK_INPUTS, &list, &n);
    for (i = 0; i < n; i++)
        if (is_input(list[i].name, section, key, part)) {
            *unit_name = list[i].unit;
            return list[i].value;
        }
    return 0;
}

/* The place of a tracer point, in the deck's unit; 0 if the section is none. */
static int place_of_point(fourlink_results *r, const rewrite *w, double place[2],
                          const char **unit_name)
{
    const fourlink_deck *deck = fourlink_results_deck(r);
    fourlink_vector at;
    fourlink_unit u;
    unsigned long i;
    const char *name;
    int link;

    if (!flk_text_equal(w->section, "point"))
        return 0;
    for (i = 0; fourlink_deck_point(deck, i, &name, &link, &at) == FOURLINK_OK; i++)
        if (!w->name.length || flk_text_equal(w->name, name))
            break;
    fourlink_deck_unit(deck, "length", &u);
    place[0] = at.x * u.down / u.up;
    place[1] = at.y * u.down / u.up;
    *unit_name = u.name;
    return 1;
}

/* A part of a vector, SECTION.KEY.PART, is written as the whole vector, of which `r` has the components. */
static void write_vector(fourlink_results *r, text whole, rewrite *w)
{
    char x[FORMAT_SIZE], y[FORMAT_SIZE];
    const char *unit_name = "";
    text section, vector, part, key;
    double place[2];

    flk_text_cut_last(whole, ".", &vector, &part);
    flk_text_cut_last(vector, ".", &section, &key);
    rewrite_split(vector, w);
    if (!place_of_point(r, w, place, &unit_name)) {
        place[0] = input_of(r, section, key, "x", &unit_name);
        place[1] = input_of(r, section, key, "y", &unit_name);
    }
    format_general(place[0], 15, x);
    format_general(place[1], 15, y);
    flk_text_join(w->value, sizeof w->value, "(", x, ", ", y, ") ", unit_name, (char *)NULL);
}

static int is_part(text whole)
{
    static const char *const parts[] = {"x", "y", "size", "angle"};
    text vector, part, section, key;
    size_t i;

    if (!flk_text_cut_last(whole, ".", &vector, &part) ||
        !flk_text_cut_last(vector, ".", &section, &key))
        return 0;
    for (i = 0; i < 4; i++)
        if (flk_text_equal(part, parts[i]))
            return 1;
    return 0;
}

/* Write the deck with all changes. */
static void write_deck(FILE *out, const search *s, fourlink_results *r, rewrite *list)
{
    text deck;
    unsigned long i;

    for (i = 0; i < s->source.n_changes; i++) {
        text value = flk_text_of(s->changes[i].assignment), whole;

        flk_text_split(&value, '=', &whole);
        whole = flk_text_trim(whole);
        if (is_part(whole)) {
            write_vector(r, whole, &list[i]);
            continue;
        }
        rewrite_split(whole, &list[i]);
        flk_text_copy(flk_text_trim(value), list[i].value, sizeof list[i].value);
    }
    deck.start = s->in->source.text;
    deck.length = s->in->source.length;
    rewrite_deck(out, deck, list, s->source.n_changes);
}

static int write_result(FILE *out, const search *s)
{
    fourlink_results *r = NULL;
    fourlink_mistake mistake;
    fourlink_value v;
    rewrite *list = calloc(s->source.n_changes + 1, sizeof *list);
    char value[ASSIGNMENT];

    if (!list || fourlink_results_open(&s->source, 1, &r, &mistake, NULL) != FOURLINK_OK ||
        fourlink_results_value(r, s->name, s->branch, 0, &v) != FOURLINK_OK) {
        free(list);
        fourlink_results_free(r);
        return command_complain("cannot analyse", s->in->name, "not enough memory");
    }
    fprintf(out, "# The best design of %s: %s %s = %s, %s branch.\n", s->in->name,
            s->sign > 0 ? "min" : "max", s->name,
            value_text(v.value, 6, v.unit, value, sizeof value),
            fourlink_branch_text((int)s->branch));
    write_deck(out, s, r, list);
    free(list);
    fourlink_results_free(r);
    return 0;
}

/* --------------------------------------------------------------------------------------------- all */

/* The changes of the command line but for those of the sweep, then those of the variables. */
static void keep_changes(search *s)
{
    const options *o = s->in->o;
    unsigned long i;

    for (i = 0; i < o->n_changes; i++) {
        text section = flk_text_of(o->changes[i].assignment), before, after;

        if (flk_text_cut(section, ".", &before, &after) && flk_text_equal(before, "sweep"))
            continue;
        s->changes[s->n_kept++] = o->changes[i];
    }
    for (i = 0; i < s->n; i++) {
        s->changes[s->n_kept + i].origin = "--best";
        s->changes[s->n_kept + i].assignment = s->texts + ASSIGNMENT * i;
    }
}

/* Returns 0 if out of memory. */
static int open_search(search *s, const input *in)
{
    text deck;
    size_t length;

    memset(s, 0, sizeof *s);
    s->in = in;
    s->sign = in->o->best_is_largest ? -1 : 1;
    s->name = in->o->best;
    fourlink_results_list(in->results, FOURLINK_CONDITIONS, &s->conditions, &s->n_conditions);
    fourlink_results_list(in->results, FOURLINK_VARIABLES, &s->variables, &s->n);
    s->low = calloc(5 * s->n, sizeof *s->low); /* low, high, best of all, values, best */
    s->changes = calloc(in->o->n_changes + s->n, sizeof *s->changes);
    s->texts = calloc(s->n, ASSIGNMENT);
    deck.start = in->source.text;
    deck.length = in->source.length;
    s->source = in->source;
    s->source.text = rewrite_without_sweep(deck, &length);
    s->source.length = (unsigned long)length;
    if (!s->low || !s->changes || !s->texts || !s->source.text)
        return 0;
    s->high = s->low + s->n;
    s->values = s->low + 3 * s->n;
    s->best = s->low + 4 * s->n;
    keep_changes(s);
    s->source.changes = s->changes;
    s->source.n_changes = s->n_kept + s->n;
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
