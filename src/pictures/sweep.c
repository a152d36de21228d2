/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sweep.c - pictures of the designs of a sweep: its outputs over the quantity that it varies.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>
#include <gsl/gsl_statistics_double.h>

#include "base/text.h"
#include "system/memory.h"
#include "graph.h"
#include "sketch.h"
#include "spread.h"
#include "view/results.h"

#define MOST_DESIGNS 1000000UL
#define MANY_DESIGNS 400 /* more are lines, or their spread */
#define MANY_CURVES 12
#define NO_VALUES "no design of the [sweep] has a number to draw"

/* The designs of a sweep. */
typedef struct designs {
    const fourlink_value *outputs, *variables;
    unsigned long n_outputs, n_variables, n;
    unsigned long axis; /* the variable on the x axis */
    double *inputs;     /* by design and variable */
    double *values;     /* by design, branch and output; NaN: none */
} designs;

static double *inputs_of(const designs *d, unsigned long i)
{
    return d->inputs + i * d->n_variables;
}

static double *values_of(const designs *d, const picture *p, unsigned long i, int branch)
{
    return d->values + (i * (unsigned long)p->v.n_branches + (unsigned long)branch) * d->n_outputs;
}

static int open_designs(picture *p, designs *d)
{
    size_t n = p->v.problem.n_designs, lines = n * (size_t)p->v.n_branches, i;

    memset(d, 0, sizeof *d);
    d->n = p->v.problem.n_designs;
    fourlink_results_list(p->v.results, FOURLINK_OUTPUTS, &d->outputs, &d->n_outputs);
    fourlink_results_list(p->v.results, FOURLINK_VARIABLES, &d->variables, &d->n_variables);
    d->inputs = memory_get((n + 3) * d->n_variables, sizeof *d->inputs);
    d->values = memory_get(lines * d->n_outputs + 1, sizeof *d->values);
    for (i = 0; d->values && i < lines * d->n_outputs; i++)
        d->values[i] = GSL_NAN;
    return d->inputs && d->values;
}

static void close_designs(designs *d)
{
    free(d->inputs);
    free(d->values);
}

/* Keep the outputs of design i on a branch; 0 if one could not be computed.  A fact that the design does not
** have is no failure. */
static int keep_outputs(const picture *p, designs *d, unsigned long i, int branch,
                        fourlink_results *r, double from)
{
    fourlink_value v;
    unsigned long k;
    int status, good = 1;

    for (k = 0; k < d->n_outputs; k++) {
        status = results_get(r, d->outputs[k].handle, p->v.branches[branch], from, &v);
        if (status == FOURLINK_OK && !v.words && gsl_finite(v.value))
            values_of(d, p, i, branch)[k] = v.value;
        good = good && (status == FOURLINK_OK || status == FOURLINK_NO_SUCH_FACT);
    }
    return good;
}

/* Compute the outputs of design i; a design with mistakes has none.  0: out of memory. */
static int compute(picture *p, designs *d, unsigned long i)
{
    fourlink_results *r = NULL;
    fourlink_problem problem;
    int status, b;

    p->n_lines += (unsigned long)p->v.n_branches;
    fourlink_results_variables(p->v.results, i, d->n_variables, inputs_of(d, i), NULL, NULL);
    status = results_design(p->v.results, i, 0, &r, NULL, NULL);
    if (status == FOURLINK_OK) {
        fourlink_deck_problem(fourlink_results_deck(r), &problem);
        for (b = 0; b < p->v.n_branches; b++)
            p->n_missing += !keep_outputs(p, d, i, b, r, problem.motion.from);
    } else {
        p->n_missing += (unsigned long)p->v.n_branches;
    }
    fourlink_results_free(r);
    return !memory_has_failed();
}

/* The first design at which a variable has another value than at the first. */
static unsigned long first_change(const designs *d, unsigned long k)
{
    unsigned long i;

    for (i = 1; i < d->n && inputs_of(d, i)[k] == inputs_of(d, 0)[k]; i++)
        ;
    return i;
}

/* A range is on the x axis rather than a tolerance or a list, which have no steps; of several that which
** changes fastest. */
static void find_axis(const picture *p, designs *d)
{
    double *values = inputs_of(d, d->n), *low = values + d->n_variables,
           *high = low + d->n_variables;
    unsigned long k, rank, least = 2 * d->n + 1;

    fourlink_results_variables(p->v.results, 0, d->n_variables, values, low, high);
    for (k = 0; k < d->n_variables; k++) {
        rank = first_change(d, k) + (low[k] != high[k] ? 0 : d->n);
        if (rank < least) {
            least = rank;
            d->axis = k;
        }
    }
}

/* 1 if a new curve begins with design i: a variable has changed that does not from the first design to the
** second. */
static int begins(const designs *d, unsigned long i)
{
    unsigned long k;

    for (k = 0; k < d->n_variables && i > 0; k++)
        if (inputs_of(d, i)[k] != inputs_of(d, i - 1)[k] &&
            inputs_of(d, 1)[k] == inputs_of(d, 0)[k])
            return 1;
    return 0;
}

/* The range of an output on all branches; 0 if it has no number. */
static int find_range(const picture *p, const designs *d, unsigned long output, double *low,
                      double *high)
{
    unsigned long i;
    int b;

    *low = GSL_POSINF;
    *high = GSL_NEGINF;
    for (i = 0; i < d->n; i++)
        for (b = 0; b < p->v.n_branches; b++) {
            double value = values_of(d, p, i, b)[output];

            if (gsl_isnan(value))
                continue;
            *low = GSL_MIN_DBL(*low, value);
            *high = GSL_MAX_DBL(*high, value);
        }
    return *low <= *high;
}

/* Set the axes, with some room around the values. */
static void set_axes(canvas *on, double x_low, double x_high, double y_low, double y_high)
{
    place_box axes;

    graph_widen(&x_low, &x_high, 0.02);
    graph_widen(&y_low, &y_high, 0.08);
    axes.x_min = x_low;
    axes.x_max = x_high;
    axes.y_min = y_low;
    axes.y_max = y_high;
    canvas_set_axes(on, axes, place_round(10 * CANVAS_LETTER * (x_high - x_low) / on->box_width),
                    0);
}

/* Begin the next panel, of an output. */
static void begin_panel(picture *p, const char *x, const char *x_unit, const char *y,
                        const char *y_unit)
{
    canvas_begin_panel(&p->on);
    canvas_place_panel(&p->on, 3, 2 * CANVAS_LETTER);
    p->on.has_key_below_title = 1;
    canvas_titles(&p->on, x, x_unit, y, y_unit, "");
}

/* ------------------------------------------------------------------------------------------ curves */

/* 1 if the curves run in one direction, so that lines can join their points. */
static int is_monotonic(const designs *d)
{
    unsigned long i;
    double way = 0, step;

    for (i = 1; i < d->n; i++) {
        step = begins(d, i) ? 0 : inputs_of(d, i)[d->axis] - inputs_of(d, i - 1)[d->axis];
        if (!begins(d, i) && (step == 0 || step * way < 0))
            return 0;
        way = step;
    }
    return 1;
}

/* Draw an output on a branch, with lines between its points or without. */
static void put_branch(picture *p, const designs *d, unsigned long output, int branch,
                       int has_lines)
{
    int stroke = PEN_CURVE + branch;
    double value;
    unsigned long i;

    if (has_lines) {
        graph_begin(p, stroke, d->outputs[output].name,
                    fourlink_branch_text((int)p->v.branches[branch]));
        for (i = 0; i < d->n; i++) {
            value = values_of(d, p, i, branch)[output];
            if (begins(d, i) || gsl_isnan(value))
                display_add_place(p->on.d, place_at(GSL_NAN, GSL_NAN));
            if (!gsl_isnan(value))
                display_add_place(p->on.d, place_at(inputs_of(d, i)[d->axis], value));
        }
    }
    for (i = 0; i < d->n && !(has_lines && d->n > MANY_DESIGNS); i++) {
        value = values_of(d, p, i, branch)[output];
        if (gsl_isnan(value))
            continue;
        display_add(p->on.d, DISPLAY_MARK, stroke, DISPLAY_CURVES)->size = 2.5;
        display_add_place(p->on.d, place_at(inputs_of(d, i)[d->axis], value));
    }
    canvas_add_key(&p->on, has_lines ? DISPLAY_LINE : DISPLAY_MARK, stroke,
                   fourlink_branch_text((int)p->v.branches[branch]));
}

/* 1 if there are more curves, or points, than the eye tells apart. */
static int are_many(const designs *d, int has_lines)
{
    unsigned long n_curves = 0, i;

    for (i = 0; i < d->n; i++)
        n_curves += i == 0 || begins(d, i);
    return d->n > MANY_DESIGNS && !(has_lines && n_curves <= MANY_CURVES);
}

/* Draw the spread of an output on a branch; nothing if memory fails, which is noted. */
static void put_spread(picture *p, const designs *d, unsigned long output, int branch)
{
    static const char *const sizes[] = {"least", "lower", "median", "upper", "greatest"};
    const char *its = fourlink_branch_text((int)p->v.branches[branch]);
    spread_point *points = memory_get(d->n, sizeof *points);
    spread_group groups[SPREAD_MOST];
    size_t n = 0, n_groups, k;
    char of[40], words[80];
    unsigned long i;
    int size;

    if (!points)
        return;
    for (i = 0; i < d->n; i++) {
        points[n].x = inputs_of(d, i)[d->axis];
        points[n].y = values_of(d, p, i, branch)[output];
        n += !gsl_isnan(points[n].y);
    }
    n_groups = spread_find(points, n, groups);
    for (size = 0; size < SPREAD_SIZES; size++) {
        flk_text_join(of, sizeof of, its, "_", sizes[size], (char *)NULL);
        graph_begin(p, (size == SPREAD_MEDIAN ? PEN_CURVE : PEN_JUMP) + branch,
                    d->outputs[output].name, of);
        for (k = 0; k < n_groups; k++)
            display_add_place(p->on.d, place_at(groups[k].x, groups[k].y[size]));
    }
    canvas_add_key(&p->on, DISPLAY_LINE, PEN_CURVE + branch,
                   flk_text_join(words, sizeof words, its, ", median", (char *)NULL));
    canvas_add_key(&p->on, DISPLAY_LINE, PEN_JUMP + branch, "quartiles, extremes");
    free(points);
}

/* Draw an output over the varied quantity; 0 if it has no number. */
static int put_output(picture *p, designs *d, unsigned long output, int has_lines, int is_spread)
{
    const fourlink_value *x = &d->variables[d->axis];
    double low, high, x_low, x_high;
    char symbol[NOTATION_SIZE];
    int b;

    if (!find_range(p, d, output, &low, &high))
        return 0;
    begin_panel(p, x->name, x->unit, canvas_symbol(&p->on, d->outputs[output].name, symbol),
                d->outputs[output].unit);
    gsl_stats_minmax(&x_low, &x_high, d->inputs + d->axis, d->n_variables, d->n);
    set_axes(&p->on, x_low, x_high, low, high);
    for (b = 0; b < p->v.n_branches; b++)
        if (is_spread)
            put_spread(p, d, output, b);
        else
            put_branch(p, d, output, b, has_lines);
    canvas_end_panel(&p->on);
    return 1;
}

const char *picture_outputs(picture *p)
{
    unsigned long i, k;
    int drawn = 0, enough, has_lines, is_spread;
    designs d;

    if (p->v.problem.n_designs < 2)
        return "the [sweep] has a single design";
    if (p->v.problem.n_designs > MOST_DESIGNS)
        return "a picture shows at most 1000000 designs";
    enough = open_designs(p, &d);
    for (i = 0; enough && i < d.n; i++)
        enough = compute(p, &d, i);
    if (enough) {
        find_axis(p, &d);
        has_lines = is_monotonic(&d);
        is_spread = are_many(&d, has_lines);
        for (k = 0; k < d.n_outputs; k++)
            drawn += put_output(p, &d, k, has_lines, is_spread);
    }
    close_designs(&d);
    return drawn ? NULL : NO_VALUES;
}
