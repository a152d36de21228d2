/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sheet.c - what the contents and the formats of a sheet of results share.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "at.h"
#include "base/message.h"
#include "sheet.h"
#include "system/memory.h"
#include "view/rounding.h"

const char *const sheet_verdicts[] = {"ok", "differs", "misprint confirmed", "not a misprint",
                                      "no value"};

long sheet_column_under(const sheet *s, unsigned long i)
{
    const fourlink_value *list = s->v.columns;
    unsigned long n = s->v.n_columns, j, k;

    if (s->content == SHEET_VALUES)
        fourlink_results_list(s->v.results, FOURLINK_OUTPUTS, &list, &n);
    for (k = 0; k < n; k++) {
        j = (i + k) % n; /* that of the first deck stands there */
        if (strcmp(s->header[i].name, list[j].name) == 0 &&
            strcmp(s->header[i].unit, list[j].unit) == 0)
            return (long)j;
    }
    return -1;
}

void sheet_name_deck(sheet *s, const char *name)
{
    s->deck_name = s->n_decks > 1 || s->format->is_lines ? name : NULL;
}

void sheet_write_line(sheet *s, const fourlink_results *results, const char *deck_name,
                      fourlink_branch branch, const fourlink_value *values, unsigned long n)
{
    sheet_output *outputs = memory_get(s->n_header, sizeof *outputs);
    unsigned long i, k;

    sheet_name_deck(s, deck_name);
    fourlink_deck_problem(fourlink_results_deck(results), &s->v.problem);
    for (k = 0; outputs && k < s->n_header; k++) {
        outputs[k].is_other = 1;
        outputs[k].why = NULL;
        for (i = 0; i < n && outputs[k].is_other; i++) {
            outputs[k].v = values[i];
            outputs[k].has_value = strcmp(s->header[k].name, values[i].name) == 0 &&
                                   strcmp(s->header[k].unit, values[i].unit) == 0;
            outputs[k].is_other = !outputs[k].has_value;
        }
    }
    if (outputs)
        s->format->values(s, branch, outputs, NULL);
    free(outputs);
    line_end(&s->l);
}

void sheet_write_gap(sheet *s)
{
    char name[1024];

    if (s->design ? s->design > 1 : s->n_written > 0)
        line_put(&s->l, "\n\n");
    if (s->deck_name)
        line_put(&s->l, "# deck: %s\n",
                 flk_text_copy(flk_text_of(s->deck_name), name, sizeof name));
    if (s->mark)
        line_put(&s->l, s->has_roster ? "# answers: %s, of %s\n" : "# answers: %s\n",
                 flk_text_copy(flk_text_of(s->mark->path), name, sizeof name), s->mark->name);
}

int sheet_is_over(const sheet *s, const fourlink_instant *at)
{
    double angle;

    return s->v.problem.mode != FOURLINK_MODE_GIVEN && at->status != FOURLINK_OK &&
           at->status == fourlink_results_end(s->v.results, at->branch, &angle);
}

/* Say in a line why an item of --at has no row. */
static void write_missing(sheet *s, fourlink_branch branch, const at_item *item, int status)
{
    char words[400];
    sheet_row row;

    memset(&row, 0, sizeof row);
    row.branch = branch;
    row.status = flk_message(words, sizeof words, "%t: %s", item->words,
                             status == FOURLINK_OK ? "at no crank angle of this branch"
                                                   : fourlink_status_text(status));
    s->failed += status != FOURLINK_OK;
    if (status != FOURLINK_OK || s->format->is_brief)
        s->format->row(s, &row);
}

int sheet_find_at(sheet *s, fourlink_branch branch, const view_spot *spot, fourlink_instant *at)
{
    int status = view_find_spot(&s->v, branch, spot, s->values, at, s->loads);

    if (status == FOURLINK_OK)
        view_settle_row(&s->v, at, s->loads, s->values);
    return status;
}

/* A crank angle of one branch may be none of the other's, unless the rows go over it. */
static int is_reached(const sheet *s, fourlink_branch branch, const view_spot *spot)
{
    return s->v.problem.over.is_crank_angle ||
           view_find_spot(&s->v, branch, spot, NULL, NULL, NULL) != FOURLINK_NO_SUCH_ANGLE;
}

void sheet_for_each_at(sheet *s, fourlink_branch branch,
                       void (*put)(sheet *s, fourlink_branch branch, const view_spot *spot))
{
    const char *list = s->at;
    char message[400];
    unsigned long n, i;
    view_spot *spots;
    at_item item;
    int status;

    while (at_next(&s->v, &list, &item, message) == 1) {
        status = at_find(s->v.results, &item, branch, &spots, &n);
        if (status == FOURLINK_NO_MEMORY)
            return;
        if (status != FOURLINK_OK || n == 0)
            write_missing(s, branch, &item, status);
        for (i = 0; status == FOURLINK_OK && i < n; i++)
            if (is_reached(s, branch, &spots[i]))
                put(s, branch, &spots[i]);
            else
                write_missing(s, branch, &item, FOURLINK_NO_SUCH_ANGLE);
        free(spots);
    }
}

const char *sheet_stop(const sheet *s, fourlink_branch branch, char words[SHEET_STOP_SIZE])
{
    int is_given = s->v.problem.mode == FOURLINK_MODE_GIVEN, status = FOURLINK_OK;
    double angle = s->v.range.stop_angle;
    char number[FORMAT_SIZE];

    if (!is_given)
        status = fourlink_results_end(s->v.results, branch, &angle);
    if (is_given ? !s->v.range.stops : status == FOURLINK_OK)
        return NULL;
    if (!is_given && status != FOURLINK_STALLS)
        return fourlink_status_text(status);
    if (s->v.problem.is_prescribed)
        return flk_text_join(words, SHEET_STOP_SIZE, s->v.problem.over.words, " comes to rest at ",
                             format_general(view_over(&s->v, angle), 12, number), " ",
                             s->v.units[s->v.over].name, (char *)NULL);
    return flk_text_join(words, SHEET_STOP_SIZE,
                         is_given ? "the crank comes to rest at " : "stalls at ",
                         format_general(angle, is_given ? 12 : 6, number), " ",
                         s->v.units[QUANTITY_ANGLE].name, (char *)NULL);
}

void sheet_write_stop(sheet *s, fourlink_branch branch)
{
    char words[SHEET_STOP_SIZE];
    sheet_row row;

    memset(&row, 0, sizeof row);
    row.branch = branch;
    row.status = sheet_stop(s, branch, words);
    if (!row.status)
        return;
    s->failed++;
    s->format->row(s, &row);
}

void sheet_write_inputs(sheet *s, void (*put)(sheet *s, const fourlink_value *input))
{
    const fourlink_value *inputs;
    unsigned long n, i;

    fourlink_results_list(s->v.results, FOURLINK_INPUTS, &inputs, &n);
    for (i = 0; i < n; i++)
        put(s, &inputs[i]);
}

static int is_near(double x, double y)
{
    return x == y || fabs(x - y) <= 1e-7 * GSL_MAX_DBL(fabs(x), fabs(y));
}

int sheet_is_on_both(const fourlink_value *f, const fourlink_value *facts, unsigned long n)
{
    unsigned long i;

    for (i = 0; i < n; i++)
        if (f->branch && facts[i].branch == -f->branch && strcmp(f->name, facts[i].name) == 0)
            return f->words
                       ? facts[i].words && strcmp(f->words, facts[i].words) == 0
                       : is_near(f->value, facts[i].value) && f->has_angle == facts[i].has_angle &&
                             is_near(f->angle, facts[i].angle);
    return 0;
}

double sheet_percent(const sheet_mark *m)
{
    return m->of > 0 ? floor(1000 * m->right / m->of + 0.5) / 10 : GSL_NAN;
}
