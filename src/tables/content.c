/* SPDX-License-Identifier: GPL-3.0-or-later
**
** content.c - what a sheet of results shows, once for all formats.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/message.h"
#include "system/memory.h"
#include "content.h"
#include "view/results.h"

/* Warn near a dead position: with a transmission angle below 1 deg, errors of the data grow more than 57
** times. */
static void find_status(const sheet *s, sheet_row *row)
{
    int is_near = row->at->status == FOURLINK_OK &&
                  (row->at->state.mu < M_PI / 180 || row->at->state.group_sine < M_PI / 180);

    row->status = is_near ? "near a dead position: the transmission angle is less than 1 deg"
                          : fourlink_deck_status_text(s->v.deck, row->at);
    row->is_ordinary = row->at->status == FOURLINK_OK && !is_near;
}

/* A row that has been computed. */
static void take_row(sheet *s, fourlink_branch branch, const fourlink_instant *at, sheet_row *row)
{
    s->failed += at->status != FOURLINK_OK && !view_goes_to(&s->v, at->status);
    row->values = s->values;
    row->branch = branch;
    row->at = at;
    row->last = view_shown_place(&s->v, &at->row);
    find_status(s, row);
}

/* Compute row k of a branch. */
static void find_row(sheet *s, fourlink_branch branch, unsigned long k, fourlink_instant *at,
                     sheet_row *row)
{
    fourlink_results_motion(s->v.results, branch, k, s->values, at);
    take_row(s, branch, at, row);
}

/* Write all rows of a branch, and why it ends before; where the format is brief, rows without numbers,
** for the same reason, as one. */
static void write_all_rows(sheet *s, fourlink_branch branch)
{
    fourlink_instant at, first;
    sheet_row row, stretch;
    int is_open = 0; /* a stretch, not written yet */
    unsigned long k;

    for (k = 0; k < s->v.problem.n_rows; k++) {
        fourlink_results_brief(s->v.results, branch, k, s->values, &at);
        take_row(s, branch, &at, &row);
        if (sheet_is_over(s, &at))
            break;
        if (is_open && at.status == first.status && at.row.side == first.row.side) {
            stretch.last = row.last;
            continue;
        }
        if (is_open)
            s->format->row(s, &stretch);
        is_open = s->format->is_brief && at.status != FOURLINK_OK;
        if (is_open) {
            first = at;
            stretch = row;
            stretch.at = &first;
        } else {
            s->format->row(s, &row);
        }
    }
    if (is_open)
        s->format->row(s, &stretch);
    sheet_write_stop(s, branch);
}

static void write_row_at(sheet *s, fourlink_branch branch, const view_spot *spot)
{
    fourlink_instant at;
    sheet_row row;

    sheet_find_at(s, branch, spot, &at);
    take_row(s, branch, &at, &row);
    s->format->row(s, &row);
}

/* Write facts; one that is the same on both branches once, where the format is brief. */
static void put_facts(sheet *s, const fourlink_value *facts, unsigned long n,
                      void (*put)(sheet *s, const fourlink_value *fact))
{
    unsigned long i;

    for (i = 0; i < n && put; i++) {
        fourlink_value f = facts[i];

        if (s->format->is_brief && sheet_is_on_both(&f, facts, n)) {
            if (f.branch == FOURLINK_CROSSED)
                continue;
            f.branch = 0;
        }
        put(s, &f);
    }
}

static void write_facts(sheet *s, int groups, void (*put)(sheet *s, const fourlink_value *fact))
{
    const fourlink_value *facts;
    unsigned long n;

    results_facts(s->v.results, 0, groups, &facts, &n);
    put_facts(s, facts, n, put);
}

static void set_words(fourlink_value *f, const char *name, const char *meaning,
                      fourlink_branch branch, const char *words)
{
    memset(f, 0, sizeof *f);
    f->name = name;
    f->unit = f->source = "";
    f->quantity = "number";
    f->meaning = meaning;
    f->branch = (int)branch;
    f->words = words;
}

/* In a summary, why it has no extremes, and why a motion that is not given goes no further. */
static void write_reasons(sheet *s)
{
    fourlink_value missing[2], ends[2];
    unsigned long n_missing = 0, n_ends = 0;
    char words[2][SHEET_STOP_SIZE];
    view_extremes extremes;
    const char *stop;
    double angle;
    int i;

    for (i = 0; i < s->v.n_branches; i++) {
        fourlink_branch branch = s->v.branches[i];

        if (view_find_extremes(&s->v, branch, &extremes) == FOURLINK_LONG_SEARCH)
            set_words(&missing[n_missing++], "extremes", "why there are none", branch,
                      fourlink_status_text(FOURLINK_LONG_SEARCH));
        if (s->v.problem.mode == FOURLINK_MODE_GIVEN)
            continue;
        stop = sheet_stop(s, branch, words[i]);
        s->failed += fourlink_results_end(s->v.results, branch, &angle) == FOURLINK_TOO_LONG;
        if (stop)
            set_words(&ends[n_ends++], "end", "why the machine goes no further", branch, stop);
    }
    s->failed += n_missing;
    put_facts(s, missing, n_missing, s->format->fact);
    put_facts(s, ends, n_ends, s->format->fact);
}

/* Find an extreme, mostly that after the one that was found before. */
static const fourlink_value *find_extreme(const fourlink_value *facts, unsigned long n, int branch,
                                          int handle, unsigned long *next)
{
    unsigned long i, k;

    for (k = 0; k < n; k++) {
        i = (*next + k) % n;
        if (facts[i].handle == handle && facts[i].branch == branch) {
            *next = i + 1;
            return &facts[i];
        }
    }
    return NULL;
}

/* Write the extremes of each column together, once if they are the same on both branches. */
static void write_extremes(sheet *s)
{
    const fourlink_value *facts, *c, *least, *most;
    unsigned long n, j, next = 0;
    int i, are_same;

    results_facts(s->v.results, 0, FOURLINK_FACTS_EXTREMES, &facts, &n);
    for (i = 0; i < s->v.n_branches; i++)
        for (j = 0; j < s->v.n_columns; j++) {
            int branch = (int)s->v.branches[i];

            c = &s->v.columns[j];
            most = find_extreme(facts, n, branch, c->handle + FOURLINK_MAX, &next);
            least = find_extreme(facts, n, branch, c->handle + FOURLINK_MIN, &next);
            if (!least || !most)
                continue;
            are_same = sheet_is_on_both(least, facts, n) && sheet_is_on_both(most, facts, n);
            if (i == 0 || !are_same)
                s->format->extremes(s, c, least, most, are_same ? 0 : branch);
        }
}

/* Write the rows of a branch, once for each page. */
static void write_block(sheet *s, fourlink_branch branch)
{
    unsigned long failed = s->failed;

    for (s->page = 0; s->page < s->n_pages; s->page++) {
        s->failed = failed;
        if (s->format->block)
            s->format->block(s, branch);
        if (s->at)
            sheet_for_each_at(s, branch, write_row_at);
        else
            write_all_rows(s, branch);
        if (s->format->end_block)
            s->format->end_block(s, branch);
    }
}

static void write_by_angle(sheet *s)
{
    unsigned long n_rows = s->v.problem.n_rows, k;
    fourlink_instant at;
    sheet_row row;
    int i;

    if (s->v.problem.one_revolution && s->v.problem.mode == FOURLINK_MODE_GIVEN &&
        !s->v.range.stops && n_rows > 1)
        n_rows--;
    for (k = 0; k < n_rows; k++)
        for (i = s->v.n_branches - 1; i >= 0; i--) {
            find_row(s, s->v.branches[i], k, &at, &row);
            if (!sheet_is_over(s, &at))
                s->format->row(s, &row);
        }
    for (i = 0; i < s->v.n_branches && (i == 0 || s->v.problem.mode != FOURLINK_MODE_GIVEN); i++)
        sheet_write_stop(s, s->v.branches[i]);
}

static void write_rows(sheet *s)
{
    int i;

    write_facts(s, FOURLINK_FACTS_LIMITS, s->format->limit);
    if (s->format->is_by_angle)
        write_by_angle(s);
    for (i = 0; i < s->v.n_branches && !s->format->is_by_angle; i++)
        write_block(s, s->v.branches[i]);
}

/* Write all comparisons, or those whose value is right, or the others. */
static void write_checks_that_are(sheet *s, int right, int all)
{
    fourlink_check check;
    unsigned long i;
    int is_right;

    for (i = 0; i < s->v.problem.n_expected; i++) {
        if (!results_check(s->v.results, i, &check))
            return;
        is_right = check.verdict == FOURLINK_AGREES || check.verdict == FOURLINK_MISPRINT;
        if (!all && right != is_right)
            continue;
        s->right += check.part * check.marks;
        s->of += check.marks;
        s->checks[check.verdict]++;
        s->format->check(s, &check);
        if (check.verdict == FOURLINK_NO_VALUE && s->no_value &&
            s->checks[FOURLINK_NO_VALUE] <= MOST_MISTAKES)
            s->no_value(&check, s->deck_name);
    }
}

static void write_checks(sheet *s)
{
    write_checks_that_are(s, 0, !s->wrong_first);
    if (s->wrong_first)
        write_checks_that_are(s, 1, 0);
    if (s->mark) {
        s->right = s->mark->right;
        s->of = s->mark->of;
    }
}

/* Columns or facts of some results. */
typedef struct name_list {
    const fourlink_value *list;
    unsigned long n;
} name_list;

/* 1 if name i of the last of these results stands nowhere before.  Of a deck only facts, whose handles
** are negative, can have one name, such as the ends of two ranges. */
static int is_new(const name_list *all, size_t last, unsigned long i)
{
    unsigned long k, own = all[last].list[i].handle < 0 ? i : 0;
    size_t r;

    for (r = 0; r <= last; r++)
        for (k = 0; k < (r < last ? all[r].n : own); k++)
            if (strcmp(all[r].list[k].name, all[last].list[i].name) == 0)
                return 0;
    return 1;
}

static void put_names(sheet *s, const name_list *all, size_t n_results,
                      void (*put)(sheet *s, const fourlink_value *v))
{
    unsigned long i;
    size_t r;

    for (r = 0; r < n_results; r++)
        for (i = 0; i < all[r].n; i++)
            if (is_new(all, r, i))
                put(s, &all[r].list[i]);
}

/* One line for the forces opposite to those that are listed. */
static void put_opposites(sheet *s, fourlink_results *const *results, size_t n_results)
{
    fourlink_value opposite;
    size_t i;

    for (i = 0; i < n_results; i++)
        if (fourlink_results_find(results[i], "F32x", &opposite) == FOURLINK_OK) {
            opposite.meaning = "opposite to F23x; also F21, F43, F41, N43, M43, M41, by name only";
            s->format->listed(s, &opposite);
            return;
        }
}

/* List all names of some results, each once. */
static void write_list(sheet *s, fourlink_results *const *results, size_t n_results)
{
    static const char *const of_columns[][2] = {
        {"max(COLUMN)", "largest value of any column"},
        {"min(COLUMN)", "smallest value of any column"},
        {"mean(COLUMN)", "mean over the crank angle"},
        {"rms(COLUMN)", "root mean square over the crank angle"},
        {"COLUMN at ANGLE", "value in the row at this crank angle"}};
    name_list all[CONTENT_LISTED] = {{NULL, 0}};
    fourlink_value statistic;
    size_t i;

    for (i = 0; i < n_results; i++)
        fourlink_results_list(results[i], FOURLINK_ALL_COLUMNS, &all[i].list, &all[i].n);
    put_names(s, all, n_results, s->format->column);
    results_facts(results[0], FOURLINK_OPEN,
                  s->listed
                      ? FOURLINK_FACTS_NAMES
                      : FOURLINK_FACTS_LIMITS | FOURLINK_FACTS_TURNING | FOURLINK_FACTS_MOTION,
                  &all[0].list, &all[0].n);
    put_names(s, all, 1, s->format->listed);
    memset(&statistic, 0, sizeof statistic);
    statistic.unit = "";
    for (i = 0; i < sizeof of_columns / sizeof of_columns[0]; i++) {
        statistic.name = of_columns[i][0];
        statistic.meaning = of_columns[i][1];
        s->format->listed(s, &statistic);
    }
    put_opposites(s, results, n_results);
}

/* ------------------------------------------------------------------------------------ decks, designs */

static const sheet_frame *frame_of(const sheet *s)
{
    return s->format->frame[s->content];
}

static void tell(sheet *s, void (*part)(sheet *s))
{
    if (part)
        part(s);
}

void content_begin(sheet *s, FILE *out, int has_head)
{
    line_start(&s->l, out);
    s->l.is_coloured = s->is_coloured;
    if (has_head)
        tell(s, frame_of(s)->begin);
    line_end(&s->l);
}

/* Take the results of a deck or design; 0 if memory fails. */
static int open_results(sheet *s, fourlink_results *results)
{
    const fourlink_value *list;
    unsigned long n;

    if (s->design)
        view_take_design(&s->v, results);
    else
        view_take(&s->v, results);
    if (!s->design && fourlink_results_list(results, FOURLINK_VARIABLES, &list, &n) == FOURLINK_OK)
        s->variables = list;
    s->values = memory_get(s->v.n_columns + 1, sizeof *s->values);
    s->loads = memory_get(s->v.problem.n_loads + 1, sizeof *s->loads);
    s->layout = memory_get((s->v.n_columns + s->n_header + 1) * (s->format->layout_size + 1), 1);
    s->list = NULL;
    s->n_pages = 1;
    memset(s->checks, 0, sizeof s->checks);
    s->right = s->of = 0;
    return s->values && s->loads && s->layout;
}

static void close_results(sheet *s)
{
    free(s->values);
    free(s->loads);
    free(s->layout);
    s->n_written++;
    line_end(&s->l);
}

/* Find the value of an output; returns the reason why it has none, or null.  A fact that this design does not
** have needs no reason. */
static const char *find_output(sheet *s, fourlink_branch branch, int handle, sheet_output *output)
{
    int status = results_get(s->v.results, handle, branch, s->v.problem.motion.from, &output->v);

    output->has_value = status == FOURLINK_OK;
    output->is_other = 0;
    return status == FOURLINK_OK || status == FOURLINK_NO_SUCH_FACT ? NULL
           : status == FOURLINK_NO_SUCH_NAME ? "this design lacks a column of the first"
                                             : fourlink_status_text(status);
}

/* Why an output is not a finite value, though it could be computed; null: it is one. */
static const char *why_incomplete(const sheet_output *x)
{
    return !x->has_value           ? fourlink_status_text(FOURLINK_NO_SUCH_FACT)
           : gsl_isinf(x->v.value) ? "a value is unbounded"
                                   : NULL;
}

/* Write the values of a deck, a line for each branch. */
static void write_values(sheet *s)
{
    sheet_output *outputs = memory_get(s->n_header, sizeof *outputs);
    const fourlink_value *own;
    unsigned long n, k;
    int i;

    fourlink_results_list(s->v.results, FOURLINK_OUTPUTS, &own, &n);
    for (i = 0; outputs && i < s->v.n_branches; i++) {
        const char *why = NULL, *reason;

        for (k = 0; k < s->n_header; k++) {
            long at = sheet_column_under(s, k);

            outputs[k].has_value = 0;
            outputs[k].why = NULL;
            outputs[k].is_other = at < 0;
            if (at < 0)
                continue;
            reason = find_output(s, s->v.branches[i], own[at].handle, &outputs[k]);
            outputs[k].why = reason;
            reason = reason ? reason : why_incomplete(&outputs[k]);
            why = why ? why : reason;
        }
        s->failed += why != NULL;
        s->format->values(s, s->v.branches[i], outputs, why);
    }
    free(outputs);
}

static void write_content(sheet *s)
{
    if (s->content == SHEET_VALUES) {
        write_values(s);
        return;
    }
    if (s->content != SHEET_CHECK && s->content != SHEET_LIST && !view_find_motion(&s->v))
        return;
    if (!s->is_form)
        tell(s, frame_of(s)->open);
    switch (s->content) {
    case SHEET_SUMMARY:
        write_facts(s,
                    FOURLINK_FACTS_LIMITS | FOURLINK_FACTS_TURNING | FOURLINK_FACTS_MOTION |
                        (s->format->extremes ? 0 : FOURLINK_FACTS_EXTREMES),
                    s->format->fact);
        write_reasons(s);
        if (s->format->extremes)
            write_extremes(s);
        break;
    case SHEET_CHECK:
        write_checks(s);
        break;
    case SHEET_LIST:
        write_list(s, s->listed ? s->listed : &s->v.results, s->listed ? s->n_listed : 1);
        break;
    case SHEET_MATRIX:
        matrix_write(s);
        break;
    case SHEET_EXPECT:
        expect_write(s);
        break;
    case SHEET_ROWS:
    default:
        write_rows(s);
    }
    if (!memory_has_failed())
        tell(s, frame_of(s)->close);
}

void content_write(sheet *s, fourlink_results *results, const char *deck_name, const char *why)
{
    sheet_name_deck(s, deck_name);
    if (!results) {
        if (s->content == SHEET_VALUES || (s->content == SHEET_CHECK && (s->deck_name || s->mark)))
            frame_of(s)->refuse(s, why);
        line_end(&s->l);
        return;
    }
    if (open_results(s, results))
        write_content(s);
    close_results(s);
}

void content_write_list(sheet *s, fourlink_results *const *results, size_t n)
{
    s->listed = results;
    s->n_listed = n;
    content_write(s, results[0], NULL, NULL);
}

void content_write_mark(sheet *s, const sheet_mark *mark)
{
    s->format->mark(s, mark);
    line_end(&s->l);
}

int sheet_meets(const fourlink_value *condition, const fourlink_value *v)
{
    double limit = condition->value;

    return !v->words && (((condition->flags & FOURLINK_ABOVE) && v->value > limit) ||
                         ((condition->flags & FOURLINK_BELOW) && v->value < limit) ||
                         ((condition->flags & FOURLINK_OR_EQUAL) && v->value == limit));
}

/* The last output, 1 if the others meet all conditions. */
static void find_yield(const sheet *s, sheet_output *outputs)
{
    sheet_output *yield = &outputs[s->n_header - 1];
    unsigned long i, k;

    memset(yield, 0, sizeof *yield);
    yield->has_value = 1;
    yield->v.value = 1;
    for (i = 0; i < s->n_conditions; i++)
        for (k = 0; k + 1 < s->n_header; k++)
            if (s->header[k].handle == s->conditions[i].handle &&
                !(outputs[k].has_value && sheet_meets(&s->conditions[i], &outputs[k].v)))
                yield->v.value = 0;
}

#define CLOSE 1e-9 /* rad */

/* 1 if crank angles from `from` to `to`, in rad, are within a range, or whole turns from it. */
static int is_within(double from, double to, double low, double high)
{
    double turns = 2 * M_PI * flk_cycle_count(from + CLOSE - low, 2 * M_PI);

    return high - low > 2 * M_PI - CLOSE || to - turns <= high + CLOSE;
}

/* Why a design has no positions at some crank angles of its motion: the angles at which it has; null if
** it has all. */
static const char *find_gap(const sheet *s, char words[200])
{
    const fourlink_motion *motion = &s->v.problem.motion;
    double to_si = motion->angle_unit;
    double from = GSL_MIN(motion->from, motion->to) * to_si - motion->x_at;
    double to = GSL_MAX(motion->from, motion->to) * to_si - motion->x_at, turn;
    fourlink_reach reach;
    int i;

    fourlink_reach_of(&s->v.problem.mechanism, &reach);
    for (i = 0; i < reach.n_ranges; i++)
        if (is_within(from, to, reach.from[i], reach.to[i]))
            return NULL;
    if (!reach.n_ranges)
        return fourlink_status_text(FOURLINK_NOT_REACHED);
    strcpy(words, "assembled only ");
    for (i = 0; i < reach.n_ranges; i++) {
        turn = view_turn_of_range(&s->v, reach.from[i], reach.to[i]);
        flk_message(words + strlen(words), 200 - strlen(words), "%sfrom %.4g to %.4g %s",
                    i ? " and " : "", (reach.from[i] + turn) / to_si, (reach.to[i] + turn) / to_si,
                    s->v.units[QUANTITY_ANGLE].name);
    }
    return words;
}

/* Write the lines of a design, one for each branch. */
static void write_lines(sheet *s)
{
    sheet_output outputs[SHEET_OUTPUTS + 1];
    int i;
    unsigned long k;
    char words[200];
    const char *gap = find_gap(s, words);

    for (i = 0; i < s->v.n_branches; i++) {
        const char *why = NULL, *incomplete = NULL;

        for (k = 0; k < s->n_header - (s->n_conditions > 0); k++) {
            const char *reason = find_output(s, s->v.branches[i], s->header[k].handle, &outputs[k]);

            why = why ? why : reason;
            incomplete = incomplete ? incomplete : why_incomplete(&outputs[k]);
        }
        if (s->n_conditions)
            find_yield(s, outputs);
        s->failed += why || incomplete;
        s->format->design(s, s->v.branches[i], outputs, why ? why : gap ? gap : incomplete);
    }
}

/* Write the lines of a design that cannot be computed, which does not meet the yield. */
static void refuse_yield(sheet *s, const char *why)
{
    sheet_output outputs[SHEET_OUTPUTS + 1];
    int i;

    memset(outputs, 0, sizeof outputs);
    outputs[s->n_header - 1].has_value = 1;
    for (i = 0; i < s->v.n_branches; i++)
        s->format->design(s, s->v.branches[i], outputs, why);
}

void content_write_design(sheet *s, fourlink_results *results, fourlink_results *first,
                          unsigned long i, const double *varied, const char *why)
{
    s->design = i + 1;
    s->varied = varied;
    if (open_results(s, results ? results : first)) {
        if (!results && s->n_conditions && !s->format->is_brief)
            refuse_yield(s, why);
        else if (!results)
            frame_of(s)->refuse(s, why);
        else if (s->content == SHEET_DESIGNS)
            write_lines(s);
        else
            write_content(s);
    }
    s->failed += !results;
    close_results(s);
}
