/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sweep.c - pictures of the designs of a sweep: histograms of its outputs, and outputs over the quantity that it
** varies.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include "graph.h"
#include "sketch.h"

#define MOST_DESIGNS 1000000UL
#define MOST_BINS 60
#define NO_VALUES "no design of the [sweep] has a number to draw"

/* The designs of a sweep. */
typedef struct designs {
    const fourlink_value *outputs, *variables;
    unsigned long n_outputs, n_variables, n;
    unsigned long
        axis;       /* the variable on the x axis: a range that changes fastest, if there is one */
    double *x;      /* by design: the value of that variable */
    char *begins;   /* by design: 1: a slower variable has changed, and a new curve begins */
    double *values; /* by design, branch and output; NaN: none */
} designs;

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
    d->x = malloc(n * sizeof *d->x);
    d->begins = calloc(n, 1);
    d->values = malloc((lines * d->n_outputs + 1) * sizeof *d->values);
    for (i = 0; d->values && i < lines * d->n_outputs; i++)
        d->values[i] = GSL_NAN;
    return d->x && d->begins && d->values;
}

static void close_designs(designs *d)
{
    free(d->x);
    free(d->begins);
    free(d->values);
}

/* Keep the variables of design i; `last` are those of the design before it, and `fast` marks those that
** change from the first design to the second. */
static void keep_variables(designs *d, unsigned long i, const double *now, double *last, char *fast)
{
    unsigned long k;

    for (k = 0; k < d->n_variables && i == 1; k++)
        fast[k] = now[k] != last[k];
    for (k = d->n_variables; k-- > 0 && i == 1;)
        if (fast[k])
            d->axis = k;
    for (k = 0; k < d->n_variables && i > 0; k++)
        if (now[k] != last[k] && !fast[k])
            d->begins[i] = 1;
    memcpy(last, now, d->n_variables * sizeof *last);
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
        status = fourlink_results_get(r, d->outputs[k].handle, p->v.branches[branch], from, &v);
        if (status == FOURLINK_OK && !v.words && gsl_finite(v.value))
            values_of(d, p, i, branch)[k] = v.value;
        good = good && (status == FOURLINK_OK || status == FOURLINK_NO_SUCH_FACT);
    }
    return good;
}

/* Compute the outputs of design i; a design with mistakes has none. */
static int compute(picture *p, designs *d, unsigned long i, double *variables)
{
    fourlink_results *r = NULL;
    fourlink_problem problem;
    int status, b;

    p->n_lines += (unsigned long)p->v.n_branches;
    fourlink_results_variables(p->v.results, i, d->n_variables, variables, NULL, NULL);
    status = fourlink_results_design(p->v.results, i, 0, &r, NULL, NULL);
    if (status == FOURLINK_OK) {
        fourlink_deck_problem(fourlink_results_deck(r), &problem);
        for (b = 0; b < p->v.n_branches; b++)
            p->n_missing += !keep_outputs(p, d, i, b, r, problem.motion.from);
    } else {
        p->n_missing += (unsigned long)p->v.n_branches;
    }
    fourlink_results_free(r);
    return status != FOURLINK_NO_MEMORY;
}

/* 1 if a variable goes through a range; a tolerance, and a list, have no steps. */
static int is_range(const picture *p, const designs *d, unsigned long k, double *room)
{
    double *low = room, *high = room + d->n_variables, *values = room + 2 * d->n_variables;

    fourlink_results_variables(p->v.results, 0, d->n_variables, values, low, high);
    return low[k] != high[k];
}

/* The first design at which a variable has another value than at the first. */
static unsigned long first_change(const designs *d, const double *xs, unsigned long k)
{
    unsigned long i;

    for (i = 1; i < d->n && xs[i * d->n_variables + k] == xs[k]; i++)
        ;
    return i;
}

/* A range is on the x axis rather than a tolerance or a list; of several ranges that which changes fastest.
** `room` is for three values of each variable. */
static void find_axis(const picture *p, designs *d, const double *xs, double *room)
{
    unsigned long k, first, least = d->n;

    for (k = 0; k < d->n_variables; k++) {
        first = first_change(d, xs, k);
        if (first < least && is_range(p, d, k, room)) {
            least = first;
            d->axis = k;
        }
    }
}

/* Compute all designs; returns 0 if out of memory. */
static int compute_all(picture *p, designs *d)
{
    double *now = malloc(3 * (d->n_variables + 1) * sizeof *now);
    char *fast = calloc(d->n_variables + 1, 1);
    double *xs = malloc((d->n_variables + 1) * d->n * sizeof *xs);
    int enough = now && fast && xs;
    unsigned long i;

    for (i = 0; enough && i < d->n; i++) {
        double *variables = xs + i * d->n_variables;

        enough = compute(p, d, i, variables);
        if (enough)
            keep_variables(d, i, variables, now, fast);
    }
    if (enough)
        find_axis(p, d, xs, now);
    for (i = 0; enough && i < d->n; i++)
        d->x[i] = xs[i * d->n_variables + d->axis];
    free(now);
    free(fast);
    free(xs);
    return enough;
}

/* The range of an output over all designs and branches; 0 if it has no number. */
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

/* Set the range of an axis, with room on both sides. */
static void put_range(const canvas *on, char axis, double low, double high, double part)
{
    graph_widen(&low, &high, part);
    canvas_print(on, axis == 'x' ? "set xrange [%.8g:%.8g]\n" : "set yrange [%.8g:%.8g]\n", low,
                 high);
    if (axis == 'x')
        canvas_print(on, "set xtics %.6g\n",
                     place_round(10 * CANVAS_LETTER * (high - low) / on->box_width));
}

static void begin_panel(picture *p)
{
    canvas_panel(&p->on, 3, 2 * CANVAS_LETTER);
    canvas_key(&p->on);
    canvas_grid(&p->on);
}

static void plot(picture *p, unsigned long output, int branch, const char *style, int line)
{
    canvas_print(&p->on, "%s $o%d_%s using 1:2 with %s lt %d title '%s'",
                 p->on.curves++ ? "," : "plot", (int)output,
                 fourlink_branch_text((int)p->v.branches[branch]), style, line,
                 fourlink_branch_text((int)p->v.branches[branch]));
}

/* ------------------------------------------------------------------------------------- histograms */

/* The number of bins, by D. Freedman and P. Diaconis (1981): their width is 2 IQR n^(-1/3). */
static int count_bins(const double *sorted, size_t n)
{
    double iqr = gsl_stats_quantile_from_sorted_data(sorted, 1, n, 0.75) -
                 gsl_stats_quantile_from_sorted_data(sorted, 1, n, 0.25);
    double range = sorted[n - 1] - sorted[0],
           bins = iqr > 0 ? range * pow((double)n, 1. / 3) / (2 * iqr) : 5;

    return range <= 0 ? 1 : bins > MOST_BINS ? MOST_BINS : bins < 5 ? 5 : (int)ceil(bins);
}

/* Write the bins of an output on a branch; returns the largest count. */
static unsigned long put_bins(const picture *p, const designs *d, unsigned long output, int branch,
                              int bins, double low, double width)
{
    unsigned long counts[MOST_BINS] = {0}, most = 0, i;
    int k;

    for (i = 0; i < d->n; i++) {
        double value = values_of(d, p, i, branch)[output];

        if (gsl_isnan(value))
            continue;
        k = (int)floor((value - low) / width);
        k = k < 0 ? 0 : k >= bins ? bins - 1 : k;
        if (++counts[k] > most)
            most = counts[k];
    }
    canvas_print(&p->on, "$o%d_%s << EOD\n", (int)output,
                 fourlink_branch_text((int)p->v.branches[branch]));
    for (k = 0; k < bins; k++)
        canvas_print(&p->on, "%.12g %.12g\n", low + (k + 0.5) * width, (double)counts[k]);
    canvas_print(&p->on, "EOD\n");
    return most;
}

/* Draw the histogram of an output; 0 if it has no number, -1 if out of memory. */
static int put_histogram(picture *p, const designs *d, unsigned long output)
{
    double *sorted = malloc(d->n * (size_t)p->v.n_branches * sizeof *sorted), low, high, width;
    unsigned long i, most = 0, here;
    char symbol[NOTATION_SIZE];
    size_t n = 0;
    int b, bins;

    if (!sorted || !find_range(p, d, output, &low, &high)) {
        free(sorted);
        return sorted ? 0 : -1;
    }
    for (i = 0; i < d->n; i++)
        for (b = 0; b < p->v.n_branches; b++)
            if (!gsl_isnan(values_of(d, p, i, b)[output]))
                sorted[n++] = values_of(d, p, i, b)[output];
    gsl_sort(sorted, 1, n);
    bins = count_bins(sorted, n);
    free(sorted);
    width = bins > 1 ? (high - low) / bins : low != 0 ? 0.01 * fabs(low) : 1;
    low -= bins > 1 ? 0 : 0.5 * width;
    begin_panel(p);
    canvas_titles(&p->on, "", canvas_symbol(&p->on, d->outputs[output].name, symbol),
                  d->outputs[output].unit, "designs", "number");
    for (b = 0; b < p->v.n_branches; b++) {
        here = put_bins(p, d, output, b, bins, low, width);
        most = here > most ? here : most;
    }
    put_range(&p->on, 'x', low, low + bins * width, 0.02);
    canvas_print(&p->on, "set yrange [0:%.8g]\nset boxwidth %.12g\nset style fill solid 0.4\n",
                 1.1 * (double)most, width);
    for (b = 0; b < p->v.n_branches; b++)
        plot(p, output, b, b ? "histeps" : "boxes", b + 1);
    canvas_print(&p->on, "\n");
    return 1;
}

/* ------------------------------------------------------------------------------------------ curves */

/* 1 if the curves run in one direction, so that lines can join their points. */
static int is_monotonic(const designs *d)
{
    unsigned long i;
    int way = 0;

    for (i = 1; i < d->n; i++) {
        int step = d->x[i] > d->x[i - 1] ? 1 : -1;

        if (d->begins[i] || d->x[i] == d->x[i - 1])
            way = d->begins[i] ? 0 : 2;
        else if (way && step != way)
            return 0;
        else
            way = step;
        if (way == 2)
            return 0;
    }
    return 1;
}

/* Draw an output over the varied quantity; 0 if it has no number. */
static int put_curve(picture *p, const designs *d, unsigned long output, const char *style)
{
    const fourlink_value *x = &d->variables[d->axis];
    char symbol[NOTATION_SIZE];
    double low, high;
    unsigned long i;
    int b;

    if (!find_range(p, d, output, &low, &high))
        return 0;
    begin_panel(p);
    canvas_titles(&p->on, "", x->name, x->unit,
                  canvas_symbol(&p->on, d->outputs[output].name, symbol), d->outputs[output].unit);
    for (b = 0; b < p->v.n_branches; b++) {
        canvas_print(&p->on, "$o%d_%s << EOD\n", (int)output,
                     fourlink_branch_text((int)p->v.branches[b]));
        for (i = 0; i < d->n; i++) {
            double value = values_of(d, p, i, b)[output];

            if (d->begins[i] || gsl_isnan(value))
                canvas_print(&p->on, "\n");
            if (!gsl_isnan(value))
                canvas_print(&p->on, "%.12g %.12g\n", d->x[i], value);
        }
        canvas_print(&p->on, "EOD\n");
    }
    put_range(&p->on, 'y', low, high, 0.08);
    gsl_stats_minmax(&low, &high, d->x, 1, d->n);
    put_range(&p->on, 'x', low, high, 0.02);
    for (b = 0; b < p->v.n_branches; b++)
        plot(p, output, b, style, b + 1);
    canvas_print(&p->on, "\n");
    return 1;
}

/* -------------------------------------------------------------------------------------------- kinds */

/* Compute the designs and draw each output. */
static const char *draw_outputs(picture *p, int is_histogram)
{
    const char *style;
    unsigned long k;
    int drawn = 0, status = 0;
    designs d;

    if (p->v.problem.n_designs > MOST_DESIGNS)
        return "a picture shows at most 1000000 designs";
    if (!open_designs(p, &d) || !compute_all(p, &d))
        status = -1;
    style = status == 0 && is_monotonic(&d) ? "linespoints" : "points";
    for (k = 0; status >= 0 && k < d.n_outputs; k++) {
        status = is_histogram ? put_histogram(p, &d, k) : put_curve(p, &d, k, style);
        drawn += status > 0;
    }
    p->out_of_memory = status < 0;
    close_designs(&d);
    return drawn ? NULL : NO_VALUES;
}

const char *picture_histogram(picture *p, fourlink_branch branch)
{
    (void)branch;
    return draw_outputs(p, 1);
}

const char *picture_outputs(picture *p)
{
    return p->v.problem.n_designs < 2 ? "the [sweep] has a single design" : draw_outputs(p, 0);
}
