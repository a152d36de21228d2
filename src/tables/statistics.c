/* SPDX-License-Identifier: GPL-3.0-or-later
**
** statistics.c - statistics of the outputs of a sweep, and its yield.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include "base/text.h"
#include "statistics.h"

static int index_of(fourlink_branch branch)
{
    return branch == FOURLINK_CROSSED;
}

int statistics_open(statistics *x, const fourlink_value *outputs, unsigned long n_outputs,
                    const fourlink_value *conditions, unsigned long n_conditions)
{
    memset(x, 0, sizeof *x);
    x->outputs = outputs;
    x->n_outputs = n_outputs;
    x->conditions = conditions;
    x->n_conditions = n_conditions;
    x->samples = calloc(2 * n_outputs + 1, sizeof *x->samples);
    x->passed = calloc(2 * (n_conditions + 1), sizeof *x->passed);
    return x->samples && x->passed;
}

void statistics_close(statistics *x)
{
    unsigned long i;

    for (i = 0; x->samples && i < 2 * x->n_outputs; i++)
        free(x->samples[i].values);
    free(x->samples);
    free(x->passed);
}

/* Returns 0 if out of memory.  There is room for a power of two. */
static int add_value(statistics_sample *sample, double value)
{
    if ((sample->n & (sample->n - 1)) == 0) {
        double *more = realloc(sample->values, (2 * sample->n + 1) * sizeof *more);

        if (!more)
            return 0;
        sample->values = more;
    }
    sample->values[sample->n++] = value;
    return 1;
}

/* 1 if a design meets a condition of the yield. */
static int is_met(const sheet *s, const fourlink_value *condition, const sheet_output *outputs)
{
    unsigned long i;

    for (i = 0; i < s->n_header; i++)
        if (s->header[i].handle == condition->handle)
            return outputs[i].has_value && !outputs[i].v.words &&
                   statistics_meets(condition, outputs[i].v.value);
    return 0;
}

int statistics_meets(const fourlink_value *condition, double value)
{
    double limit = condition->value;

    return ((condition->flags & FOURLINK_ABOVE) && value > limit) ||
           ((condition->flags & FOURLINK_BELOW) && value < limit) ||
           ((condition->flags & FOURLINK_OR_EQUAL) && value == limit);
}

void statistics_add(sheet *s, fourlink_branch branch, const sheet_output *outputs)
{
    statistics *x = s->statistics;
    int of = index_of(branch), all = outputs != NULL;
    unsigned long *passed = x->passed + (unsigned long)of * (x->n_conditions + 1), i;

    x->designs[of]++;
    for (i = 0; outputs && i < x->n_outputs; i++) {
        statistics_sample *sample = &x->samples[(unsigned long)of * x->n_outputs + i];

        if (!outputs[i].has_value)
            continue;
        if (outputs[i].v.words)
            sample->has_words = 1;
        else if (!gsl_isnan(outputs[i].v.value) && !add_value(sample, outputs[i].v.value))
            s->out_of_memory = 1;
    }
    for (i = 0; outputs && i < x->n_conditions; i++) {
        int meets = is_met(s, &x->conditions[i], outputs);

        passed[i] += (unsigned long)meets;
        all &= meets;
    }
    passed[x->n_conditions] += (unsigned long)all;
}

/* ------------------------------------------------------------------------------------- results */

const char *const sheet_statistic_names[] = {"mean", "std_dev", "min",  "5 %", "25 %",
                                             "50 %", "75 %",    "95 %", "max"};

/* The shares of the last seven. */
static const double shares[] = {0, 0.05, 0.25, 0.5, 0.75, 0.95, 1};

/* By linear interpolation between sorted values, the first being the quantile of 0, the last that of 1.
** GSL's has 0 * inf where the value after it is unbounded. */
static double quantile(const double *sorted, size_t n, double share)
{
    double place = share * (double)(n - 1);

    return place == floor(place) ? sorted[(size_t)place]
                                 : gsl_stats_quantile_from_sorted_data(sorted, 1, n, share);
}

/* With unbounded values the mean is unbounded too. */
static void summarise(statistics_sample *sample, sheet_statistic *to)
{
    double *x = sample->values;
    size_t n = sample->n, i;

    to->count = (unsigned long)n;
    for (i = 0; i < SHEET_STATISTICS_COUNT; i++)
        to->values[i] = GSL_NAN;
    if (!n)
        return;
    gsl_sort(x, 1, n);
    for (i = 2; i < SHEET_STATISTICS_COUNT; i++)
        to->values[i] = quantile(x, n, shares[i - 2]);
    if (!gsl_finite(x[0]) || !gsl_finite(x[n - 1])) {
        to->values[0] = x[0] + x[n - 1];
        return;
    }
    to->values[0] = gsl_stats_mean(x, 1, n);
    if (n > 1)
        to->values[1] = gsl_stats_sd_m(x, 1, n, to->values[0]);
}

/* The interval that holds the true share of successes with 95 per cent probability:
** (p + z^2/2n +- z sqrt(p (1 - p)/n + z^2/4n^2)) / (1 + z^2/n) (E. B. Wilson, J. Am. Stat. Assoc. 22,
** 1927). */
static void find_interval(unsigned long passed, unsigned long n, double *low, double *high)
{
    static const double z = 1.959963984540054; /* 97.5 per cent of the normal distribution */
    double size = (double)n, p = (double)passed / size, scale = 1 + z * z / size;
    double middle = (p + z * z / (2 * size)) / scale;
    double half = z * sqrt(p * (1 - p) / size + z * z / (4 * size * size)) / scale;

    *low = passed == 0 ? 0 : middle - half;
    *high = passed == n ? 1 : middle + half;
}

static void write_yield(sheet *s, const statistics *x, fourlink_branch branch,
                        const char *condition, unsigned long passed)
{
    sheet_yield y;

    y.condition = condition;
    y.branch = branch;
    y.designs = x->designs[index_of(branch)];
    y.passed = passed;
    y.percent = 100 * (double)passed / (double)y.designs;
    find_interval(passed, y.designs, &y.low, &y.high);
    y.low *= 100;
    y.high *= 100;
    s->format->yield(s, &y);
}

static void write_branch(sheet *s, statistics *x, fourlink_branch branch)
{
    unsigned long of = (unsigned long)index_of(branch), i;
    sheet_statistic to;

    if (!x->designs[of])
        return;
    for (i = 0; i < x->n_outputs; i++) {
        statistics_sample *sample = &x->samples[of * x->n_outputs + i];

        if (sample->has_words && !sample->n)
            continue;
        to.output = &x->outputs[i];
        to.branch = branch;
        summarise(sample, &to);
        s->format->statistic(s, &to);
    }
}

static void write_yields(sheet *s, const statistics *x, fourlink_branch branch)
{
    unsigned long of = (unsigned long)index_of(branch), i;
    const unsigned long *passed = x->passed + of * (x->n_conditions + 1);

    if (!x->designs[of])
        return;
    for (i = 0; i < x->n_conditions; i++)
        write_yield(s, x, branch, x->conditions[i].meaning, passed[i]);
    if (x->n_conditions > 1)
        write_yield(s, x, branch, "all conditions", passed[i]);
}

void statistics_write(sheet *s, fourlink_results *results, statistics *x)
{
    s->content = SHEET_STATISTICS;
    s->statistics = x;
    view_take(&s->v, results);
    s->design = 0;
    s->n_written = 0;
    s->list = NULL;
    s->format->open(s);
    write_branch(s, x, FOURLINK_OPEN);
    write_branch(s, x, FOURLINK_CROSSED);
    write_yields(s, x, FOURLINK_OPEN);
    write_yields(s, x, FOURLINK_CROSSED);
    if (s->format->close)
        s->format->close(s);
    line_end(&s->l);
}
