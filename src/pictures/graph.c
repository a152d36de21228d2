/* SPDX-License-Identifier: GPL-3.0-or-later
**
** graph.c - columns of a deck as curves over its motion, and their axes.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "graph.h"
#include "sketch.h"

const graph_extent graph_nothing = {GSL_POSINF, GSL_NEGINF, GSL_POSINF, GSL_NEGINF, GSL_POSINF};

/* rad, transmission angles: below the first a dead position is near, and above the second it is far. If a
** curve is so many times higher near it, the picture cuts the curve. */
#define NEAR 0.2
#define SOUND 0.6
#define HIGHER 3

void graph_extend(graph_extent *e, double value, double mu)
{
    e->low = GSL_MIN_DBL(e->low, value);
    e->high = GSL_MAX_DBL(e->high, value);
    e->mu = GSL_MIN_DBL(e->mu, mu);
    if (mu > SOUND) {
        e->sound_low = GSL_MIN_DBL(e->sound_low, value);
        e->sound_high = GSL_MAX_DBL(e->sound_high, value);
    }
}

int graph_is_cut(const graph_extent *e)
{
    return e->mu < NEAR && e->sound_high > e->sound_low &&
           e->high - e->low > HIGHER * (e->sound_high - e->sound_low);
}

int graph_column(const picture *p, const char *name)
{
    unsigned long i;

    for (i = 0; i < p->n_columns; i++)
        if (strcmp(p->columns[i].name, name) == 0)
            return (int)i;
    return -1;
}

int graph_sample(const picture *p, fourlink_branch branch, int k, double values[PICTURE_COLUMNS],
                 fourlink_instant *now)
{
    return fourlink_results_at(p->results, branch, picture_angle(p, k, GRAPH_STEPS), values, now,
                               NULL) == FOURLINK_OK;
}

/* The same if a curve can be drawn there. */
static int sound_sample(const picture *p, fourlink_branch branch, int k,
                        double values[PICTURE_COLUMNS], fourlink_instant *now)
{
    return graph_sample(p, branch, k, values, now) && !(now->state.mu < 1e-3);
}

/* Continue an angle from the one before it, past half a turn. */
static double go_on(double value, double last, double turn)
{
    return turn > 0 && !gsl_isnan(last) ? value + turn * floor((last - value) / turn + 0.5) : value;
}

/* 1 if the motion is one revolution that ends with the position and speed of its beginning. */
static int is_periodic(const picture *p)
{
    const fourlink_motion *motion = &p->problem.motion;

    return p->problem.one_revolution && motion->run_up <= 0 && !p->range.stops &&
           (motion->acceleration == 0 || motion->hold) &&
           p->mechanism->change_stretched == p->mechanism->change_folded;
}

/* The sample after the last gap of a revolution, and the value from which an angle continues there, so that
** both ends agree; -1 if there is no gap. */
static int behind_gap(const picture *p, fourlink_branch branch, int y, double turn, double *last)
{
    double values[PICTURE_COLUMNS];
    fourlink_instant now;
    int k, gap = 0;

    if (!(turn > 0) || !is_periodic(p) || !sound_sample(p, branch, 0, values, &now))
        return -1;
    *last = values[y];
    for (k = GRAPH_STEPS; k >= 0; k--) {
        if (!sound_sample(p, branch, k, values, &now)) {
            if (++gap > 1)
                return k + 2;
            continue;
        }
        gap = 0;
        *last = go_on(values[y], *last, turn);
    }
    return -1;
}

/* What is smaller is rounding: a motion of the crank alone is the measure. */
static double rounding_of(const picture *p, int y)
{
    double length = p->design->link[FOURLINK_CRANK].length, omega = p->problem.motion.speed;
    const char *of = p->columns[y].quantity;
    double size;

    if (strcmp(of, "angular_speed") == 0)
        size = picture_value(p, QUANTITY_ANGULAR_SPEED, omega);
    else if (strcmp(of, "angular_acceleration") == 0)
        size = picture_value(p, QUANTITY_ANGULAR_ACCELERATION, omega * omega);
    else if (strcmp(of, "speed") == 0)
        size = picture_value(p, QUANTITY_SPEED, omega * length);
    else if (strcmp(of, "acceleration") == 0)
        size = picture_value(p, QUANTITY_ACCELERATION, omega * omega * length);
    else
        return 0;
    return 1e-12 * fabs(size);
}

void graph_put(const picture *p, fourlink_branch branch, const char *name, int x, int y,
               graph_extent *e, graph_line *line)
{
    int is_angle = strcmp(p->columns[y].quantity, "angle") == 0;
    double turn = is_angle ? picture_value(p, QUANTITY_ANGLE, 2 * M_PI) : 0;
    double last = GSL_NAN, behind = GSL_NAN, values[PICTURE_COLUMNS], rounding = rounding_of(p, y);
    int k, gap = 0, from = behind_gap(p, branch, y, turn, &behind);
    fourlink_instant now;

    fprintf(p->on.out, "$%s_%s << EOD\n", name, fourlink_branch_text(branch));
    line->n_points = 0;
    for (k = 0; k <= GRAPH_STEPS; k++) {
        line->x[k] = line->y[k] = GSL_NAN;
        if (!sound_sample(p, branch, k, values, &now)) {
            putc('\n', p->on.out);
            if (++gap > 1) /* of a change point alone an angle goes on */
                last = GSL_NAN;
            continue;
        }
        last = go_on(values[y], k == from ? behind : last, turn);
        gap = 0;
        if (fabs(last) < rounding)
            last = 0;
        line->x[k] = values[x];
        line->y[k] = last;
        graph_extend(e, last, now.state.mu);
        canvas_print(&p->on, "%.8g %.8g\n", values[x], last);
        line->n_points++;
    }
    fputs("EOD\n", p->on.out);
}

/* In degrees the steps are parts of a turn. */
double graph_angle_step(const picture *p, double span)
{
    static const double parts[] = {5, 10, 15, 30, 45, 60, 90, 180, 360, 720};
    double least = 6 * CANVAS_LETTER * span / p->on.box_width;
    size_t i;

    if (strcmp(p->units[QUANTITY_ANGLE].name, "deg") == 0)
        for (i = 0; i < sizeof parts / sizeof parts[0]; i++)
            if (parts[i] >= least)
                return least < 2 ? sketch_round(least) : parts[i];
    return sketch_round(least);
}

void graph_plot(picture *p, fourlink_branch branch, const char *name, int line)
{
    fprintf(p->on.out, "%s $%s_%s using 1:2 with lines lt %d title ", p->on.curves++ ? "," : "plot",
            name, fourlink_branch_text(branch), line);
}
