/* SPDX-License-Identifier: GPL-3.0-or-later
**
** picture.c - a picture in the making: its deck, and what all kinds of pictures share.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/quantity.h"
#include "picture.h"

#define LONGEST_NAME 24 /* letters, next to a value */

double picture_value(const picture *p, quantity q, double si)
{
    return si * p->units[q].down / p->units[q].up;
}

double picture_si(const picture *p, quantity q, double value)
{
    return value * p->units[q].up / p->units[q].down;
}

char *picture_mark(const picture *p, double angle, int digits, char out[PICTURE_MARK])
{
    const char *name = p->units[QUANTITY_ANGLE].name;
    int is_deg = strcmp(name, "deg") == 0;
    char number[FORMAT_SIZE];

    if (fabs(angle) < 1e-9)
        angle = 0; /* rounding, and -0 */
    return flk_text_join(out, PICTURE_MARK, format_general(angle, digits, number),
                         is_deg ? "\302\260" : " ", is_deg ? "" : name, (char *)NULL);
}

/* The prefix of a value that is too large or too small to be read without one, divided by it; "" if it has
** none, or if its unit takes none. */
static const char *find_prefix(const char *unit_name, double *value)
{
    static const char *const units[] = {"N", "N.m", "J", "W", "Pa", "m", "m/s", "m/s2", NULL};
    static const char *const prefixes[] = {"n", "\302\265", "m", "", "k", "M", "G", "T"};
    double size = fabs(*value);
    int i, power;

    for (i = 0; units[i] && strcmp(units[i], unit_name) != 0; i++)
        ;
    if (!units[i] || !(size < 1e-3 || size >= 1e5) || !(size >= 1e-9 && size < 1e15))
        return "";
    power = (int)floor(log10(size * (1 + 1e-12)) / 3);
    *value /= pow(1000, power);
    return prefixes[power + 3];
}

char *picture_words(const picture *p, const char *name, double si, quantity q,
                    char out[PICTURE_WORDS])
{
    char number[FORMAT_SIZE], fitting[PICTURE_WORDS];
    double value = picture_value(p, q, si);
    const char *prefix = find_prefix(p->units[q].name, &value);

    name = canvas_shorten(name, LONGEST_NAME, 0, fitting, sizeof fitting);
    return flk_text_join(out, PICTURE_WORDS, name, name[0] ? " = " : "",
                         format_general(value, 5, number), " ", prefix, p->units[q].name,
                         (char *)NULL);
}

double picture_speed_of(const picture *p, fourlink_branch branch)
{
    fourlink_value mean;

    return fourlink_results_value(p->results, "mean_speed", branch, 0, &mean) == FOURLINK_OK
               ? mean.value * mean.to_si
               : p->problem.motion.speed;
}

double picture_torque_rounding(const picture *p, const fourlink_forces *forces)
{
    if (p->problem.mode == FOURLINK_MODE_GIVEN)
        return 0;
    return 1e-12 * p->design->link[FOURLINK_CRANK].length * gsl_hypot(forces->F12x, forces->F12y);
}

double picture_driving_torque(const picture *p, const fourlink_forces *forces)
{
    return fabs(forces->Ts) < picture_torque_rounding(p, forces) ? 0 : forces->Ts;
}

const char *picture_no_rows(const picture *p, fourlink_branch branch)
{
    double angle;
    int status = fourlink_results_end(p->results, branch, &angle);

    return status == FOURLINK_OK ? "the linkage cannot be assembled at any angle of the motion"
                                 : fourlink_status_text(status);
}

const char *picture_over(const picture *p)
{
    return p->problem.by_time ? "time" : "theta2";
}

int picture_is_over_angle(const picture *p, int column)
{
    return !p->problem.by_time && (p->columns[column].flags & FOURLINK_CRANK_ANGLE) != 0;
}

double picture_angle(const picture *p, int k, int steps)
{
    double from = p->problem.motion.from;

    return from + (p->end - from) * k / steps;
}

/* A deck with rows by time is open with PICTURE_STEPS of them. */
int picture_sample(const picture *p, fourlink_branch branch, int k, int steps, double *values,
                   fourlink_instant *now, fourlink_load *loads)
{
    if (p->problem.by_time)
        return fourlink_results_row(p->results, branch, (unsigned long)(k * PICTURE_STEPS / steps),
                                    values, now, loads);
    return fourlink_results_at(p->results, branch, picture_angle(p, k, steps), values, now, loads);
}

int picture_state(const picture *p, fourlink_branch branch, int k, int steps, fourlink_instant *now)
{
    if (p->problem.by_time)
        return picture_sample(p, branch, k, steps, NULL, now, NULL);
    now->branch = branch;
    fourlink_motion_at(&p->problem.motion, picture_angle(p, k, steps), &now->row);
    return fourlink_analyse(p->mechanism, branch, &now->row.crank, NULL, 0, &now->state, NULL);
}

int picture_position(const picture *p, fourlink_branch branch, fourlink_instant *now,
                     fourlink_load *loads)
{
    int first = p->n_angles
                    ? fourlink_results_at(p->results, branch, p->angles[0], NULL, now, loads)
                    : picture_sample(p, branch, 1, 6, NULL, now, loads);
    int status = first;
    unsigned long i;

    for (i = 0; status != FOURLINK_OK && !p->n_angles && i < p->range.n_rows; i++)
        status = fourlink_results_row(p->results, branch, i, NULL, now, loads);
    return status == FOURLINK_OK ? FOURLINK_OK : first;
}

int picture_has_outputs(const picture *p)
{
    return p->problem.has_outputs && p->problem.n_designs &&
           (p->request->kind == PLOT_HISTOGRAM || p->request->kind == PLOT_COLUMNS);
}

/* Returns 0, for the caller to return. */
static int run_out_of_memory(picture *p)
{
    p->out_of_memory = 1;
    return 0;
}

int picture_refuse(fourlink_mistake *mistake, const char *place, const char *why, const char *word)
{
    memset(mistake, 0, sizeof *mistake);
    flk_text_join(mistake->file, sizeof mistake->file, place, (char *)NULL);
    flk_text_join(mistake->message, sizeof mistake->message, why, word, (char *)NULL);
    return 0;
}

void picture_close(picture *p)
{
    if (p->results != p->request->opened)
        fourlink_results_free(p->results);
    free(p->loads);
    p->results = NULL;
    p->loads = NULL;
}

static int open_results(picture *p, const fourlink_source *source, fourlink_mistake *mistake)
{
    int status = fourlink_results_open(source, 1, &p->results, mistake, NULL);

    return status == FOURLINK_OK || (status != FOURLINK_BAD_DECK && run_out_of_memory(p));
}

/* Take what the picture needs from the results. */
static int take_results(picture *p)
{
    int q;

    p->deck = fourlink_results_deck(p->results);
    fourlink_deck_problem(p->deck, &p->problem);
    p->mechanism = &p->problem.mechanism;
    p->design = &p->mechanism->design;
    fourlink_kind_of((int)p->design->kind, &p->kind);
    for (q = 0; q < QUANTITY_COUNT; q++)
        fourlink_deck_unit(p->deck, flk_quantities[q].name, &p->units[q]);
    p->n_branches = 0;
    if (p->problem.open)
        p->branches[p->n_branches++] = FOURLINK_OPEN;
    if (p->problem.crossed)
        p->branches[p->n_branches++] = FOURLINK_CROSSED;
    fourlink_motion_range(&p->problem.motion, &p->range);
    p->range.n_rows = p->problem.n_rows;
    p->end = picture_end(&p->problem.motion);
    fourlink_results_list(p->results, FOURLINK_COLUMNS, &p->columns, &p->n_columns);
    p->loads = malloc((p->problem.n_loads + 1) * sizeof *p->loads);
    return p->loads || run_out_of_memory(p);
}

int picture_open(picture *p, const fourlink_source *source, const plot_request *request,
                 const char *values, fourlink_mistake *mistake)
{
    memset(p, 0, sizeof *p);
    p->request = request;
    p->source = source;
    p->values = values;
    p->results = request->opened;
    return (p->results || open_results(p, source, mistake)) && take_results(p);
}

static int has_column(const picture *p, text name)
{
    char copy[40];
    fourlink_value found;

    return fourlink_results_find(p->results, flk_text_copy(name, copy, sizeof copy), &found) ==
               FOURLINK_OK &&
           found.has_angle;
}

void picture_choose(const picture *p, char out[PICTURE_NAMES])
{
    text rest = flk_text_of(p->values), either, name;

    flk_text_join(out, PICTURE_NAMES, picture_over(p), " ", (char *)NULL);
    while (flk_text_split(&rest, ',', &either)) {
        while (flk_text_split(&either, '|', &name) && !has_column(p, name))
            ;
        if (has_column(p, name))
            strcat(strncat(out, name.start, name.length), " ");
    }
}

int picture_reopen(picture *p, const char *columns, const char *further, fourlink_mistake *mistake)
{
    const fourlink_source *source = p->source;
    fourlink_change *changes = malloc((source->n_changes + 2) * sizeof *changes);
    fourlink_source other = *source;
    char assignment[PICTURE_NAMES + 20];
    const char *assignments[2];
    int opened, i;

    if (!changes)
        return run_out_of_memory(p);
    flk_text_join(assignment, sizeof assignment, "table.columns=", columns ? columns : "",
                  (char *)NULL);
    assignments[0] = columns ? assignment : NULL;
    assignments[1] = further;
    if (source->n_changes)
        memcpy(changes, source->changes, source->n_changes * sizeof *changes);
    for (i = 0; i < 2; i++) {
        if (!assignments[i])
            continue;
        changes[other.n_changes].origin = p->request->x ? "--plot-x" : "--plot-kind";
        changes[other.n_changes++].assignment = assignments[i];
    }
    other.changes = changes;
    other.whole_cycle = 1;
    picture_close(p);
    opened = open_results(p, &other, mistake) && take_results(p);
    free(changes);
    return opened;
}

int picture_has_balance(const picture *p)
{
    fourlink_value value;

    return fourlink_results_value(p->results, "balance_mass", p->branches[0], 0, &value) ==
               FOURLINK_OK ||
           fourlink_results_value(p->results, "balance_rocker_mass", p->branches[0], 0, &value) ==
               FOURLINK_OK;
}

int picture_open_balance(picture *p, const char *apply, picture *other)
{
    fourlink_mistake mistake;
    char names[PICTURE_NAMES];
    int opened;

    *other = *p;
    other->results = NULL;
    other->loads = NULL;
    picture_choose(p, names);
    opened = picture_reopen(other, names, apply, &mistake);
    p->out_of_memory |= other->out_of_memory;
    return opened;
}
