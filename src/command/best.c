/* SPDX-License-Identifier: GPL-3.0-or-later
**
** best.c - the best design of a sweep: of its grid, refined between its neighbours there.
**
** The simplex method of J. A. Nelder and R. Mead (Computer J. 7, 1965) needs no derivatives: extremes
** have corners. Every point is computed from the digits that the deck will have, so that what is
** printed is what was found.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_multimin.h>

#include "base/message.h"
#include "base/number.h"
#include "system/memory.h"
#include "system/system.h"
#include "command.h"
#include "terminal.h"
#include "best.h"
#include "tables/content.h"
#include "view/results.h"

#define DIGITS 10      /* of a refined value */
#define WORST 1e300    /* of a design that is not allowed; GSL's minimisers take finite numbers */
#define TOLERANCE 1e-8 /* of the simplex, where the neighbours are 1 apart */
#define MOST_STEPS 400
#define ROUNDING 1e-9 /* of the value, as a fraction of it, by these digits */

typedef struct search {
    const input *in;
    const char *name; /* of what is sought */
    double sign;      /* 1: the smallest, -1: the largest */
    const fourlink_value *conditions, *variables;
    unsigned long n_conditions, n;
    double *best, *low, *high; /* of the grid, with its neighbours; then of the free ones, in the
                                      units of their lines */
    int is_words;              /* what is sought has no number */
    const char *gave_up;       /* why a value is not known; null: it is, or there is none */
    fourlink_results *trial;   /* the best design, in which values between these are set */
    int *handles;              /* of the variables that have neighbours: the free ones */
    unsigned long n_free;
    double *values, *refined; /* of the free ones, tried and best so far */
    double *tried;            /* points that are known: the free ones, sign * value, branch */
    size_t n_tried, room;
    double found;           /* the smallest sign * value so far */
    fourlink_branch branch; /* on which it is */
} search;

/* 1 if there is a value; why it is not known is kept. */
static int is_found(search *s, int status)
{
    if (results_gave_up(status))
        s->gave_up = fourlink_status_text(status);
    return status == FOURLINK_OK;
}

static int is_met(search *s, fourlink_results *r, fourlink_branch branch, double from)
{
    fourlink_value v;
    unsigned long i;

    for (i = 0; i < s->n_conditions; i++) {
        const fourlink_value *c = &s->conditions[i];

        if (!is_found(s, results_get(r, c->handle, branch, from, &v)) || !sheet_meets(c, &v))
            return 0;
    }
    return 1;
}

/* The smallest sign * value of a design on its branches; WORST if it has none, or does not meet the yield. */
static double value_of(search *s, fourlink_results *r, fourlink_branch *branch)
{
    fourlink_problem problem;
    fourlink_value v;
    double least = WORST;
    int i;

    fourlink_deck_problem(fourlink_results_deck(r), &problem);
    for (i = FOURLINK_OPEN; i >= FOURLINK_CROSSED; i -= 2) {
        fourlink_branch b = (fourlink_branch)i;

        if (!(b == FOURLINK_OPEN ? problem.open : problem.crossed) ||
            !is_found(s, results_value(r, s->name, b, problem.motion.from, &v)))
            continue;
        s->is_words |= v.words != NULL;
        if (v.words || !gsl_finite(v.value) || !(s->sign * v.value < least) ||
            !is_met(s, r, b, problem.motion.from))
            continue;
        least = s->sign * v.value;
        *branch = b;
    }
    return least;
}

/* ---------------------------------------------------------------------------------------- the grid */

static double in_line_unit(const search *s, unsigned long i, double value)
{
    return input_in_line_unit(s->in->results, s->variables[i].name, s->variables[i].to_si, value);
}

/* Find the best design of the grid; 0 if none is allowed. */
static int search_grid(search *s, FILE *out)
{
    unsigned long best = 0, n = s->in->problem.n_designs, i;
    fourlink_branch branch = FOURLINK_OPEN;
    progress p;

    s->found = WORST;
    progress_begin(&p, out);
    for (i = 0; i < n && !memory_has_failed() && !system_caught(); i++) {
        fourlink_results *r = NULL;
        int status = results_design(s->in->results, i, 0, &r, NULL, NULL);
        double value = status == FOURLINK_OK ? value_of(s, r, &branch) : WORST;

        fourlink_results_free(r);
        progress_tell(&p, i + 1, n);
        if (!(value < s->found))
            continue;
        s->found = value;
        s->branch = branch;
        best = i;
    }
    progress_end(&p);
    if (!(s->found < WORST) || memory_has_failed())
        return 0;
    fourlink_results_variables(s->in->results, best, s->n, s->best, s->low, s->high);
    results_design(s->in->results, best, 0, &s->trial, NULL, NULL);
    for (i = 0; i < s->n; i++) {
        if (s->low[i] == s->high[i])
            continue;
        s->handles[s->n_free] = s->variables[i].handle;
        s->low[s->n_free] = in_line_unit(s, i, s->low[i]);
        s->high[s->n_free] = in_line_unit(s, i, s->high[i]);
        s->best[s->n_free] = in_line_unit(s, i, s->best[i]);
        s->refined[s->n_free] = s->best[s->n_free];
        s->n_free++;
    }
    return s->trial != NULL;
}

/* ------------------------------------------------------------------------------- between neighbours */

/* A number with the digits that the deck will have. */
static double rounded(double x)
{
    char digits[FORMAT_SIZE];
    text t = flk_text_of(format_general(x, DIGITS, digits));

    flk_number_read(&t, &x);
    return x;
}

/* Set the free variables of the trial; 0 if these values are no design. */
static int set_values(search *s, const double *values)
{
    return results_put(s->trial, s->n_free, s->handles, values) == FOURLINK_OK;
}

#define MORE 64 /* points for which memory is taken at once */

/* The smallest sign * value with these values of the free variables, and its branch.  A simplex that has
** met the end of a range, or become smaller than the digits, comes back to the same points again and
** again. */
static double value_with(search *s, const double *values, fourlink_branch *branch)
{
    size_t width = s->n_free + 2, size = s->n_free * sizeof *values, i;
    double *point, value;

    for (i = 0; i < s->n_tried; i++) {
        point = s->tried + i * width;
        if (memcmp(point, values, size) == 0) {
            *branch = (fourlink_branch)(int)point[width - 1];
            return point[width - 2];
        }
    }
    *branch = FOURLINK_OPEN;
    value = set_values(s, values) ? value_of(s, s->trial, branch) : WORST;
    if (s->n_tried == s->room) {
        point = memory_grow(s->tried, (s->room + MORE) * width, sizeof *s->tried);
        if (!point)
            return value;
        s->tried = point;
        s->room += MORE;
    }
    point = s->tried + s->n_tried++ * width;
    memcpy(point, values, size);
    point[width - 2] = value;
    point[width - 1] = (double)*branch;
    return value;
}

/* The value at a point whose coordinates go from 0 to 1 between the neighbours. */
static double value_at(const gsl_vector *x, void *data)
{
    search *s = data;
    fourlink_branch branch;
    size_t k;
    double value;

    for (k = 0; k < s->n_free; k++) {
        double share = GSL_MAX_DBL(0, GSL_MIN_DBL(1, gsl_vector_get(x, k)));

        s->values[k] = rounded(s->low[k] + share * (s->high[k] - s->low[k]));
    }
    value = value_with(s, s->values, &branch);
    if (value < s->found) {
        s->found = value;
        s->branch = branch;
        memcpy(s->refined, s->values, s->n_free * sizeof *s->values);
    }
    return value;
}

/* Let a simplex of this size go down from the best point.  GSL's own error handler would abort where there
** is no memory. */
static void go_down(search *s, double size)
{
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    gsl_multimin_fminimizer *m =
        gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, s->n_free);
    gsl_vector *x = gsl_vector_alloc(s->n_free), *steps = gsl_vector_alloc(s->n_free);
    gsl_multimin_function f;
    size_t k;
    int step = 0;

    if (!m || !x || !steps)
        memory_note_failure();
    for (k = 0; k < s->n_free && !memory_has_failed(); k++) {
        double share = (s->refined[k] - s->low[k]) / (s->high[k] - s->low[k]);

        gsl_vector_set(x, k, share);
        gsl_vector_set(steps, k, share > 0.5 ? -size : size);
    }
    f.n = s->n_free;
    f.f = value_at;
    f.params = s;
    if (!memory_has_failed())
        gsl_multimin_fminimizer_set(m, &f, x, steps);
    while (step++ < MOST_STEPS && !memory_has_failed() && !system_caught() &&
           gsl_multimin_fminimizer_iterate(m) == GSL_SUCCESS &&
           gsl_multimin_fminimizer_size(m) >= TOLERANCE)
        ;
    gsl_multimin_fminimizer_free(m);
    gsl_vector_free(x);
    gsl_vector_free(steps);
    gsl_set_error_handler(handler);
}

/* Give a variable on which the value does not depend, but for rounding, its value of the grid again. */
static void put_back(search *s)
{
    unsigned long i;

    for (i = 0; i < s->n_free; i++) {
        double refined = s->refined[i], value;
        fourlink_branch branch;

        s->refined[i] = s->best[i];
        value = value_with(s, s->refined, &branch);
        if (value <= s->found + ROUNDING * fabs(s->found))
            s->branch = branch;
        else
            s->refined[i] = refined;
    }
}

/* Refine the free variables; a second simplex goes on where the first has become flat. */
static void refine(search *s)
{
    double on_grid = s->found;

    if (!s->n_free)
        return;
    go_down(s, 0.3);
    go_down(s, 0.05);
    if (s->found < on_grid)
        put_back(s);
    set_values(s, s->refined);
}

/* ------------------------------------------------------------------------------------------ the deck */

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

#define AT_END 1e-6 /* of the way between two values of the grid */

/* The deck's name for messages; null if it is the only one. */
static const char *deck_name(const search *s)
{
    return s->in->o->n_decks > 1 ? s->in->name : NULL;
}

/* Say which values stand at the end of their range, where better ones may be beyond: in lines of the deck, or
** for null in notes. */
static void put_ends(line *l, const search *s)
{
    char message[MESSAGE_SIZE];
    unsigned long i, k;

    for (k = 0; k < s->n_free; k++) {
        double near = AT_END * (s->high[k] - s->low[k]);

        if (!(s->best[k] == s->low[k] && s->refined[k] - s->low[k] <= near) &&
            !(s->best[k] == s->high[k] && s->high[k] - s->refined[k] <= near))
            continue;
        for (i = 0; s->variables[i].handle != s->handles[k]; i++)
            ;
        if (l)
            line_put(l, "# %s = %12g %s is at the end of its range.\n", s->variables[i].name,
                     s->refined[k], s->variables[i].line_unit);
        else
            command_tell("note", "--best", 0,
                         flk_message(message, sizeof message, "%s is at the end of its range",
                                     s->variables[i].name),
                         deck_name(s));
    }
}

static int write_result(FILE *out, const search *s)
{
    fourlink_value v;
    char *deck = NULL;
    line l;
    unsigned long length;

    if (results_value(s->trial, s->name, s->branch, 0, &v) != FOURLINK_OK ||
        (deck = input_deck_text(s->trial, &length)) == NULL)
        return command_lacks_memory("cannot analyse", s->in->name);
    line_start(&l, out);
    line_put(&l, "# The best design of %s: %s %s = %6g%s%s, %s branch.\n", s->in->name,
             s->sign > 0 ? "min" : "max", s->name, v.value, strcmp(v.unit, "1") ? " " : "",
             strcmp(v.unit, "1") ? v.unit : "", fourlink_branch_text((int)s->branch));
    if (s->gave_up)
        line_put(&l, "# Designs of which it is not known are left out: %s.\n", s->gave_up);
    put_ends(&l, s);
    line_end(&l);
    write_deck(out, deck, length);
    free(deck);
    return 0;
}

/* --------------------------------------------------------------------------------------------- all */

/* Returns 0 if out of memory. */
static int open_search(search *s, const input *in)
{
    memset(s, 0, sizeof *s);
    s->in = in;
    s->sign = in->o->best_is_largest ? -1 : 1;
    s->name = in->o->best;
    fourlink_results_list(in->results, FOURLINK_CONDITIONS, &s->conditions, &s->n_conditions);
    fourlink_results_list(in->results, FOURLINK_VARIABLES, &s->variables, &s->n);
    s->best = memory_get(5 * s->n, sizeof *s->best);
    s->handles = memory_get(s->n, sizeof *s->handles);
    if (!s->best || !s->handles)
        return 0;
    s->low = s->best + s->n;
    s->high = s->low + s->n;
    s->values = s->high + s->n;
    s->refined = s->values + s->n;
    return 1;
}

static void close_search(search *s)
{
    fourlink_results_free(s->trial);
    free(s->best);
    free(s->tried);
    free(s->handles);
}

/* Write the design that was found as a line; returns the exit status. */
static int put_result(sheet *out, const search *s)
{
    unsigned long n = 0, i;
    fourlink_value *values = best_columns(s->in, &n), found;

    for (i = 0; i < n; i++) {
        if (results_value(s->trial, values[i].name, s->branch, 0, &found) != FOURLINK_OK)
            break;
        values[i].value = found.value;
        values[i].words = NULL;
    }
    if (n && i == n)
        sheet_write_line(out, s->trial, s->in->name, s->branch, values, n);
    free(values);
    put_ends(NULL, s);
    return n && i == n ? 0 : command_lacks_memory("cannot analyse", s->in->name);
}

/* 1 if what is sought is one name, the first output of the sweep. */
static int is_one_name(const search *s)
{
    const fourlink_value *outputs;
    unsigned long n;

    fourlink_results_list(s->in->results, FOURLINK_OUTPUTS, &outputs, &n);
    return strcmp(outputs[0].name, s->name) == 0;
}

/* Search, and write the design that was found as a deck or, for null, as a line; returns the exit status. */
static int find_best(FILE *out, sheet *lines, search *s)
{
    char message[MESSAGE_SIZE];
    int has_best;

    if (!is_one_name(s)) {
        flk_message(message, sizeof message, "expected one name, not '%s'", s->name);
        command_tell("error", "--best", 0, message, NULL);
        return EXIT_USAGE;
    }
    has_best = search_grid(s, lines ? lines->l.out : out);
    if (has_best && !system_caught())
        refine(s);
    if (system_caught())
        return command_complain("stopped", s->in->name, "interrupted");
    if (memory_has_failed())
        return command_lacks_memory("cannot analyse", s->in->name);
    if (s->gave_up)
        command_tell("error", "--best", 0,
                     flk_message(message, sizeof message, "%s of some designs is not known: %s",
                                 s->name, s->gave_up),
                     deck_name(s));
    if (has_best)
        return command_worse(lines ? put_result(lines, s) : write_result(out, s),
                             s->gave_up ? EXIT_ROWS : 0);
    flk_message(message, sizeof message,
                s->is_words       ? "%s is in words: it has no largest or smallest value"
                : s->n_conditions ? "no design has a value of %s and meets the yield"
                                  : "no design has a value of %s",
                s->name);
    command_tell("error", "--best", 0, message, deck_name(s));
    if (lines)
        content_write(lines, NULL, s->in->name, message);
    return EXIT_ROWS;
}

static int answer(FILE *out, sheet *lines, const input *in)
{
    search s;
    int status;

    system_catch(1);
    status = open_search(&s, in) ? find_best(out, lines, &s)
                                 : command_lacks_memory("cannot analyse", in->name);
    system_catch(0);
    close_search(&s);
    return status;
}

int best_write(FILE *out, const input *in)
{
    return answer(out, NULL, in);
}

int best_put(sheet *s, const input *in)
{
    return answer(NULL, s, in);
}

fourlink_value *best_columns(const input *in, unsigned long *n)
{
    const fourlink_value *variables;
    fourlink_value *columns;
    unsigned long n_variables;

    fourlink_results_list(in->results, FOURLINK_VARIABLES, &variables, &n_variables);
    columns = memory_get(n_variables + 1, sizeof *columns);
    if (!columns)
        return NULL;
    memcpy(columns, variables, n_variables * sizeof *columns);
    *n = n_variables;
    if (fourlink_results_find(in->results, in->o->best, &columns[*n]) == FOURLINK_OK)
        ++*n;
    return columns;
}
