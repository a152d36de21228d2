/* SPDX-License-Identifier: GPL-3.0-or-later
**
** style.c - how the numbers of a table's columns are written, so that they are aligned.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/units.h"
#include "style.h"

#define SAMPLES 200

/* The largest torque, in the deck's unit, of the columns or of their forces on the crank. */
static double largest_torque(const view *v, const double of_quantity[QUANTITY_COUNT])
{
    double moment = view_si(v, QUANTITY_FORCE, of_quantity[QUANTITY_FORCE]) *
                    v->design->link[FOURLINK_CRANK].length;

    return GSL_MAX_DBL(of_quantity[QUANTITY_TORQUE], view_value(v, QUANTITY_TORQUE, moment));
}

void style_find_sizes(const view *v, double sound, int has_all, double *values, style *styles)
{
    unsigned long n_rows = v->problem.n_rows, samples = n_rows < SAMPLES ? n_rows : SAMPLES, k, j;
    double of_quantity[QUANTITY_COUNT] = {0};
    fourlink_instant now;
    int i;

    for (j = 0; j < v->n_columns; j++)
        styles[j].size = 0;
    for (i = 0; i < v->n_branches; i++)
        for (k = 0; k < samples; k++) {
            double share = samples > 1 ? (double)k / (double)(samples - 1) : 0;
            unsigned long row = (unsigned long)(share * (double)(n_rows - 1) + 0.5);

            if (fourlink_results_motion(v->results, v->branches[i], row, values, &now) ==
                    FOURLINK_OK &&
                sound > 0 && now.state.mu < sound)
                continue;
            for (j = 0; j < v->n_columns; j++)
                if (gsl_finite(values[j]))
                    styles[j].size = GSL_MAX_DBL(styles[j].size, fabs(values[j]));
        }
    for (j = 0; j < v->n_columns; j++) {
        double *largest = &of_quantity[flk_quantity_find(v->columns[j].quantity)];

        *largest = GSL_MAX_DBL(*largest, styles[j].size);
    }
    if (has_all)
        of_quantity[QUANTITY_TORQUE] = largest_torque(v, of_quantity);
    for (j = 0; j < v->n_columns; j++) {
        double largest = of_quantity[flk_quantity_find(v->columns[j].quantity)];

        if (format_settled(styles[j].size, largest) == 0)
            styles[j].size = has_all ? largest : 0;
    }
}

/* The number of decimals that writes every crank angle exactly, if it is small. */
static int decimals_of_angle(const view *v, int is_at, int otherwise)
{
    const fourlink_abscissa *over = &v->problem.over;
    double last = v->range.stops ? over->first : over->last, step = 1;
    int decimals;

    if (!over->is_crank_angle || is_at)
        return otherwise;
    for (decimals = 0; decimals < otherwise; decimals++, step *= 10) {
        double x = over->first * step, y = last * step, z = over->step * step;

        if (fabs(x - floor(x + 0.5)) < 1e-9 && fabs(y - floor(y + 0.5)) < 1e-9 &&
            fabs(z - floor(z + 0.5)) < 1e-9)
            return decimals;
    }
    return otherwise;
}

static void find_style(const view *v, int is_at, const fourlink_value *c, style *x)
{
    char number[FORMAT_SIZE];
    size_t width;

    x->exponent = x->size > 0 && (x->size < 1e-6 || x->size >= 1e9);
    x->decimals = v->problem.digits - 1;
    if (c->flags & FOURLINK_OF_ROUNDING) {
        x->exponent = 1;
        x->decimals = 1;
    } else if (!x->exponent && x->size > 0) {
        x->decimals -= (int)floor(log10(x->size));
        if (x->decimals < 0)
            x->decimals = 0;
        if (c->flags & FOURLINK_CRANK_ANGLE)
            x->decimals = decimals_of_angle(v, is_at, x->decimals);
    }
    if (x->exponent)
        width = strlen(format_exponent(-1, x->decimals, number));
    else
        width = strlen(format_fixed(x->size > 0 ? -x->size : -1, x->decimals, number));
    if (strlen(c->name) > width)
        width = strlen(c->name);
    if (strlen(c->unit) > width)
        width = strlen(c->unit);
    x->width = width + 2;
    x->limit = x->exponent ? 0 : pow(10, (double)x->width - x->decimals - 3) - 1;
}

char *style_text(double value, const style *x, char out[FORMAT_SIZE])
{
    return (x->exponent ? format_exponent_end : format_fixed_end)(value, x->decimals, out);
}

void style_put(line *l, double value, const style *x, size_t width)
{
    char number[FORMAT_SIZE];

    line_right(l, number, (size_t)(style_text(value, x, number) - number), width);
}

void style_find(const view *v, int is_at, double *values, style *styles)
{
    unsigned long j;

    style_find_sizes(v, 0, 0, values, styles);
    for (j = 0; j < v->n_columns; j++)
        find_style(v, is_at, &v->columns[j], &styles[j]);
}
