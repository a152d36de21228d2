/* SPDX-License-Identifier: GPL-3.0-or-later
**
** picture.c - a picture in the making: its deck, and what all kinds of pictures share.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/quantity.h"
#include "system/memory.h"
#include "picture.h"
#include "view/results.h"

void picture_angle(const picture *p, double angle, int digits, picture_number *out)
{
    const char *name = p->v.units[QUANTITY_ANGLE].name;
    int is_deg = strcmp(name, "deg") == 0;

    if (fabs(angle) < 1e-9)
        angle = 0; /* rounding, and -0 */
    format_general(angle, digits, out->value);
    flk_text_join(out->unit, sizeof out->unit, is_deg ? "\302\260" : " ", is_deg ? "" : name,
                  (char *)NULL);
}

char *picture_mark(const picture *p, double angle, int digits, char out[PICTURE_MARK])
{
    picture_number x;

    picture_angle(p, angle, digits, &x);
    return flk_text_join(out, PICTURE_MARK, x.value, x.unit, (char *)NULL);
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

void picture_value(const picture *p, double si, quantity q, picture_number *out)
{
    char own[NOTATION_SIZE];
    double value = view_value(&p->v, q, si);
    const char *prefix = find_prefix(p->v.units[q].name, &value);

    format_general(value, 5, out->value);
    flk_text_join(out->unit, sizeof out->unit, " ", prefix,
                  canvas_unit(&p->on, p->v.units[q].name, own), (char *)NULL);
}

char *picture_words(const picture *p, const char *name, double si, quantity q,
                    char out[PICTURE_WORDS])
{
    char fitting[PICTURE_WORDS];
    picture_number x;

    picture_value(p, si, q, &x);
    name = canvas_shorten(name, PICTURE_NAME, 0, fitting, sizeof fitting);
    return flk_text_join(out, PICTURE_WORDS, name, name[0] ? " = " : "", x.value, x.unit,
                         (char *)NULL);
}

double picture_speed_of(const picture *p, fourlink_branch branch)
{
    fourlink_value mean;

    return results_value(p->v.results, "mean_speed", branch, 0, &mean) == FOURLINK_OK
               ? mean.value * mean.to_si
               : p->v.problem.motion.speed;
}

const char *picture_no_rows(const picture *p, fourlink_branch branch)
{
    double angle;
    int status = fourlink_results_end(p->v.results, branch, &angle);

    return status == FOURLINK_OK ? "the linkage cannot be assembled at any angle of the motion"
                                 : fourlink_status_text(status);
}

int picture_is_over_angle(const picture *p, int column)
{
    return p->v.problem.over.is_crank_angle &&
           (p->v.columns[column].flags & FOURLINK_CRANK_ANGLE) != 0;
}

/* The row nearest to a step. */
static unsigned long row_of(const picture *p, double k, int steps)
{
    return (unsigned long)(k * (double)(p->v.range.n_rows - 1) / steps + 0.5);
}

/* Of rows by time that of the nearest row. */
double picture_place(const picture *p, double k, int steps)
{
    if (!p->v.problem.over.is_crank_angle)
        return view_place_of_row(&p->v, row_of(p, k, steps));
    return p->from + (p->v.end - p->from) * k / steps;
}

int picture_side(const picture *p, double k, int steps)
{
    return view_side_of_row(&p->v, row_of(p, k, steps));
}

int picture_take_last_turn(picture *p, fourlink_branch branch)
{
    double cycle = view_value(&p->v, QUANTITY_ANGLE, p->v.problem.cycle), end;

    if (p->v.problem.mode == FOURLINK_MODE_GIVEN)
        return 0;
    fourlink_results_end(p->v.results, branch, &end);
    end = fabs(end - p->from) < fabs(p->v.end - p->from) ? end : p->v.end;
    if (fabs(end - p->from) < 1.5 * cycle)
        return 0;
    p->from = end - (end < p->from ? -cycle : cycle);
    p->v.end = end;
    return 1;
}

int picture_sample(const picture *p, fourlink_branch branch, double k, int steps, double *values,
                   fourlink_instant *now, fourlink_load *loads)
{
    return view_find_along(&p->v, branch, picture_side(p, k, steps), picture_place(p, k, steps),
                           values, now, loads);
}

/* A sample of curves.  The forces are those of columns alone, but for a computed motion, where they say what
** rounding error torques have. */
static int sample_curves(const picture *p, fourlink_branch branch, int k, plot_sample *sample)
{
    return p->v.problem.mode == FOURLINK_MODE_GIVEN && !p->v.problem.has_both_sides
               ? fourlink_results_motion_along(p->v.results, branch,
                                               picture_place(p, k, PICTURE_STEPS), sample->values,
                                               &sample->now)
               : picture_sample(p, branch, k, PICTURE_STEPS, sample->values, &sample->now, NULL);
}

static void forget_samples(plot_deck *d)
{
    free(d->samples[0]);
    free(d->samples[1]);
    d->samples[0] = d->samples[1] = NULL;
}

void plot_deck_close(plot_deck *d)
{
    fourlink_results_free(d->results);
    forget_samples(d);
    d->results = NULL;
}

const plot_sample *picture_samples(picture *p, fourlink_branch branch)
{
    plot_deck *kept = p->request->kept;
    plot_deck *d = kept && kept->results == p->v.results ? kept : &p->own;
    int i = branch == FOURLINK_CROSSED, k;
    plot_sample *list = d->samples[i];

    if (list && d->from[i] == p->from && d->end[i] == p->v.end)
        return list;
    if (!list)
        list = d->samples[i] = memory_get(PICTURE_STEPS + 1, sizeof *list);
    if (!list)
        return NULL;
    d->from[i] = p->from;
    d->end[i] = p->v.end;
    for (k = 0; k <= PICTURE_STEPS; k++)
        list[k].status = sample_curves(p, branch, k, &list[k]);
    return list;
}

int picture_state(const picture *p, fourlink_branch branch, double k, int steps,
                  fourlink_instant *now)
{
    if (p->v.problem.has_both_sides)
        return picture_sample(p, branch, k, steps, NULL, now, NULL);
    if (!p->v.problem.over.is_crank_angle)
        return fourlink_results_motion_along(p->v.results, branch, picture_place(p, k, steps), NULL,
                                             now);
    now->branch = branch;
    fourlink_motion_at(&p->v.problem.motion, picture_place(p, k, steps), &now->row);
    return fourlink_analyse(p->v.mechanism, branch, &now->row.crank, NULL, 0, &now->state, NULL);
}

int picture_position(picture *p, fourlink_branch branch, fourlink_instant *now,
                     fourlink_load *loads)
{
    int status = view_find_position(&p->v, branch, p->n_spots ? p->spots : NULL, now, loads);

    p->shown = now->row.angle;
    if (status == FOURLINK_OK && !p->n_spots)
        p->why = view_tell_position(&p->v, now, loads, p->why_words);
    return status;
}

int picture_row_find(picture *p, fourlink_branch branch, picture_row *r)
{
    int status = picture_position(p, branch, &r->now, r->loads);

    if (status == FOURLINK_OK) {
        tracks_find(&r->numbers, &p->v, &r->now, r->loads);
        scene_find(&r->drawn, &p->v);
    }
    return status;
}

int picture_has_outputs(const picture *p)
{
    return p->v.problem.has_outputs && p->v.problem.n_designs && p->request->kind == PLOT_COLUMNS &&
           !p->request->is_figure;
}

void picture_begin_frame(picture *p)
{
    display *d = p->on.d;

    if (p->on.next) {
        d = &p->frames[(*p->n_frames)++];
        display_open(d);
        d->width = p->on.width;
        d->height = p->on.height;
        p->on.d = d;
    }
    p->on.next = 0;
}

void picture_close(picture *p)
{
    plot_deck_close(&p->own);
    free(p->loads);
    p->loads = NULL;
}

static int take_results(picture *p, fourlink_results *results)
{
    forget_samples(&p->own);
    view_take(&p->v, results);
    p->from = p->v.problem.over.first;
    p->size_branch = 0;
    free(p->loads);
    p->loads = memory_get(p->v.problem.n_loads + 1, sizeof *p->loads);
    return p->loads && view_find_motion(&p->v);
}

int picture_open(picture *p, const fourlink_source *source, const plot_request *request)
{
    memset(p, 0, sizeof *p);
    p->request = request;
    p->source = source;
    p->why = "";
    return take_results(p, request->opened);
}

static int has_column(const picture *p, text name)
{
    char copy[40];
    fourlink_value found;

    return fourlink_results_find(p->v.results, flk_text_copy(name, copy, sizeof copy), &found) ==
               FOURLINK_OK &&
           found.has_angle;
}

#define PLOT_VALUES(code, name, columns, rows, width, height, needs, draw, values, shows) values,
const char *const plot_values[] = {PLOT_LIST(PLOT_VALUES) NULL};

/* Add those columns of a list that the deck has. */
static void add_columns(const picture *p, const char *values, char out[PICTURE_NAMES])
{
    text rest = flk_text_of(values), either, name;

    while (flk_text_split(&rest, ',', &either)) {
        while (flk_text_split(&either, '|', &name) && !has_column(p, name))
            ;
        if (has_column(p, name))
            strcat(strncat(out, name.start, name.length), " ");
    }
}

/* The column of an output that is its place (0), velocity or acceleration: NAME.x, NAME.theta ... */
static void name_output(const picture *p, int output, int derivative, char name[40])
{
    static const char *const endings[2][3] = {{".x", ".v", ".a"}, {".theta", ".omega", ".alpha"}};
    int turns = p->v.design->group[output].end == FOURLINK_GROUP_TURNS;

    flk_text_join(name, 40, fourlink_deck_link_text(p->v.deck, FOURLINK_FOLLOWER + 2 + 2 * output),
                  endings[turns][derivative], (char *)NULL);
}

/* Add the motion of the outputs. */
static void add_outputs(const picture *p, char out[PICTURE_NAMES])
{
    char name[40];
    int i;

    for (i = 0; i < 3 * p->v.design->n_groups; i++) {
        name_output(p, i / 3, i % 3, name);
        strcat(strcat(out, name), " ");
    }
}

void picture_choose(const picture *p, char out[PICTURE_NAMES])
{
    int kind;

    flk_text_join(out, PICTURE_NAMES, p->v.problem.over.name, " ", (char *)NULL);
    for (kind = 0; kind < PLOT_COUNT; kind++)
        if (plot_values[kind] && (p->request->kept || kind == (int)p->request->kind))
            add_columns(p, plot_values[kind], out);
    if (p->request->kind == PLOT_MOTION)
        add_outputs(p, out);
}

int picture_draws(const picture *p, const char *column)
{
    text rest = flk_text_of(plot_values[p->request->kind]), either, name;
    char output[40];
    int i;

    while (flk_text_split(&rest, ',', &either))
        while (flk_text_split(&either, '|', &name))
            if (flk_text_same(name, column))
                return 1;
    for (i = 0; i < 3 * p->v.design->n_groups && p->request->kind == PLOT_MOTION; i++) {
        name_output(p, i / 3, i % 3, output);
        if (strcmp(output, column) == 0)
            return 1;
    }
    return 0;
}

static int reopen(picture *p, const char *columns, const char *further, fourlink_mistake *mistake)
{
    char assignment[PICTURE_NAMES + 20];
    const char *assignments[2];
    int n = 0, status;

    if (columns)
        assignments[n++] =
            flk_text_join(assignment, sizeof assignment, "table.columns=", columns, (char *)NULL);
    if (further)
        assignments[n++] = further;
    status = view_reopen(p->source, p->request->opened, p->request->x ? "--plot-x" : "--plot-kind",
                         assignments, n, &p->own.results, mistake);
    return status == FOURLINK_OK && take_results(p, p->own.results);
}

int picture_reopen(picture *p, const char *columns, const char *further, fourlink_mistake *mistake)
{
    plot_deck *kept = p->request->kept;
    char names[PICTURE_NAMES];

    if (kept && kept->results)
        return take_results(p, kept->results);
    if (kept)
        picture_choose(p, names);
    if (!reopen(p, kept ? names : columns, further, mistake))
        return 0;
    if (kept) {
        kept->results = p->own.results;
        p->own.results = NULL;
    }
    return 1;
}

int picture_has_balance(const picture *p)
{
    fourlink_value value;

    return results_value(p->v.results, "balance_mass", p->v.branches[0], 0, &value) ==
               FOURLINK_OK ||
           results_value(p->v.results, "balance_rocker_mass", p->v.branches[0], 0, &value) ==
               FOURLINK_OK;
}

int picture_open_balance(picture *p, const char *apply, picture *other)
{
    fourlink_mistake mistake;
    char names[PICTURE_NAMES];

    *other = *p;
    memset(&other->own, 0, sizeof other->own);
    other->loads = NULL;
    picture_choose(p, names);
    return reopen(other, names, apply, &mistake);
}
