/* SPDX-License-Identifier: GPL-3.0-or-later
**
** graph.c - columns of a deck as curves over its motion, and their axes.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "graph.h"
#include "view/place.h"
#include "view/rounding.h"
#include "sketch.h"

/* rad: with a larger transmission angle a dead position is far.  If a curve is so many times higher near one,
** the picture cuts the curve. */
#define SOUND 0.6
#define HIGHER 3

/* A step larger than this fraction of the curve may be a jump: it is halved so many times, and is one if
** more than this fraction of it remains. */
#define LARGE 0.02
#define HALVINGS 20
#define REMAINS 0.5

#define FEWEST_TURNS 3 /* that are averaged */

graph_extent graph_extent_of(const graph_line *lines, int n, int of_x)
{
    graph_extent e = {GSL_POSINF, GSL_NEGINF, GSL_POSINF, GSL_NEGINF, GSL_POSINF};
    int i, k;

    for (i = 0; i < n; i++)
        for (k = 0; k <= PICTURE_STEPS; k++) {
            double value = of_x ? lines[i].x[k] : lines[i].y[k], mu = lines[i].mu[k];

            if (gsl_isnan(value))
                continue;
            e.low = GSL_MIN_DBL(e.low, value);
            e.high = GSL_MAX_DBL(e.high, value);
            e.mu = GSL_MIN_DBL(e.mu, mu);
            if (mu > SOUND) {
                e.sound_low = GSL_MIN_DBL(e.sound_low, value);
                e.sound_high = GSL_MAX_DBL(e.sound_high, value);
            }
        }
    return e;
}

int graph_is_cut(const graph_extent *e)
{
    return e->mu < VIEW_NEAR && e->sound_high > e->sound_low &&
           e->high - e->low > HIGHER * (e->sound_high - e->sound_low);
}

void graph_cut(graph_extent *e, double low, double high)
{
    e->sound_low = GSL_MAX_DBL(low, e->low);
    e->sound_high = GSL_MIN_DBL(high, e->high);
    e->mu = 0;
}

void graph_range(const graph_extent *e, double *low, double *high)
{
    int is_cut = graph_is_cut(e);

    *low = is_cut ? e->sound_low : e->low;
    *high = is_cut ? e->sound_high : e->high;
}

int graph_column(const picture *p, const char *name)
{
    unsigned long i;

    for (i = 0; i < p->v.n_columns; i++)
        if (strcmp(p->v.columns[i].name, name) == 0)
            return (int)i;
    return -1;
}

/* 1 if there is a point of a curve of columns x and y. */
static int has_point(const plot_sample *s, int x, int y)
{
    return s->status == FOURLINK_OK && !(s->now.state.mu < 1e-3) && gsl_finite(s->values[x]) &&
           gsl_finite(s->values[y]);
}

/* Continue an angle from the one before it, past half a turn. */
static double go_on(double value, double last, double turn)
{
    return turn > 0 && !gsl_isnan(last) ? value + turn * flk_cycle_nearest(last - value, turn)
                                        : value;
}

/* 1 if the motion is one revolution that ends with the position and speed of its beginning. */
static int is_periodic(const picture *p)
{
    const fourlink_motion *motion = &p->v.problem.motion;

    return p->v.problem.one_revolution &&
           (p->v.problem.mode == FOURLINK_MODE_GIVEN ||
            p->v.problem.mode == FOURLINK_MODE_STEADY) &&
           motion->run_up <= 0 && !p->v.range.stops &&
           (motion->acceleration == 0 || motion->hold) &&
           p->v.mechanism->change_stretched == p->v.mechanism->change_folded;
}

/* Shift what is behind the last gap of a revolution by whole turns of an angle, so that both ends agree; one
** sample that is missing, as at a change point, is no gap. */
static void join_ends(const picture *p, double turn, double values[PICTURE_STEPS + 1])
{
    double shift = turn * flk_cycle_nearest(values[0] - values[PICTURE_STEPS], turn);
    int k = PICTURE_STEPS;

    if (!(turn > 0) || !is_periodic(p) || gsl_isnan(shift))
        return;
    while (k > 0 && !(gsl_isnan(values[k]) && gsl_isnan(values[k - 1])))
        k--;
    for (; k > 0 && k <= PICTURE_STEPS; k++)
        values[k] += shift;
}

/* N m, the largest rounding of a torque. */
static double rounding_of_torques(const picture *p, const plot_sample *samples)
{
    double largest = 0;
    int k;

    for (k = 0; k <= PICTURE_STEPS && p->v.problem.mode != FOURLINK_MODE_GIVEN; k++)
        if (samples[k].status == FOURLINK_OK)
            largest = GSL_MAX_DBL(largest, view_torque_rounding(&p->v, &samples[k].now.forces));
    return largest;
}

/* What is smaller is rounding: a motion of the crank alone is the measure, and of torques the forces on
** it. */
static double rounding_of(const picture *p, fourlink_branch branch, const plot_sample *samples,
                          int y)
{
    const char *of = p->v.columns[y].quantity;

    if (strcmp(of, "torque") == 0)
        return view_value(&p->v, QUANTITY_TORQUE, rounding_of_torques(p, samples));
    return view_rounding(&p->v, of, picture_speed_of(p, branch));
}

/* A full turn of an angle that is followed, in its unit; 0 for another column. */
static double turn_of(const picture *p, int column)
{
    const fourlink_value *c = &p->v.columns[column];

    return strcmp(c->quantity, "angle") == 0 && !(c->flags & FOURLINK_CRANK_ANGLE)
               ? view_value(&p->v, QUANTITY_ANGLE, 2 * M_PI)
               : 0;
}

/* The next value of a column: an angle goes on without steps, and rounding is 0. */
static double follow(double value, double last, double turn, double rounding)
{
    value = go_on(value, last, turn);
    return fabs(value) < rounding ? 0 : value;
}

/* No point at all. */
static void clear(graph_line *line)
{
    int k;

    line->n_points = 0;
    for (k = 0; k <= PICTURE_STEPS; k++)
        line->x[k] = line->y[k] = GSL_NAN;
}

void graph_follow(picture *p, fourlink_branch branch, int x, int y, graph_line *line)
{
    double x_turn = turn_of(p, x), y_turn = turn_of(p, y), last_x = GSL_NAN, last_y = GSL_NAN;
    const plot_sample *samples = picture_samples(p, branch), *s;
    double x_rounding, y_rounding;
    int k, gap = 0;

    clear(line);
    if (!samples)
        return;
    x_rounding = rounding_of(p, branch, samples, x);
    y_rounding = rounding_of(p, branch, samples, y);
    for (k = 0; k <= PICTURE_STEPS; k++) {
        s = &samples[k];
        if (!has_point(s, x, y)) {
            if (++gap > 1) /* of a change point alone an angle goes on */
                last_x = last_y = GSL_NAN;
            continue;
        }
        if (k > 0 && s->now.row.side != s[-1].now.row.side)
            last_x = last_y = GSL_NAN;
        gap = 0;
        line->x[k] = last_x = follow(s->values[x], last_x, x_turn, x_rounding);
        line->y[k] = last_y = follow(s->values[y], last_y, y_turn, y_rounding);
        line->mu[k] = s->now.state.mu;
        line->n_points++;
    }
    join_ends(p, x_turn, line->x);
    join_ends(p, y_turn, line->y);
}

/* Sums over the crank angle in a turn: of the angle, and of two columns. */
typedef struct turn_sums {
    double angle, x, y;
} turn_sums;

/* Add a step, in which the columns are linear; where a turn ends in it, put its means and begin the next. */
static int add_step(turn_sums *sums, double turn, double step, const double *last,
                    const double *next, fourlink_vector *mean)
{
    double rest = turn - sums->angle, part = step > rest ? rest / step : 1;
    double x = last[0] + part * (next[0] - last[0]), y = last[1] + part * (next[1] - last[1]);
    int ends = step >= rest * (1 - 1e-9);

    sums->angle += part * step;
    sums->x += part * step * (last[0] + x) / 2;
    sums->y += part * step * (last[1] + y) / 2;
    if (!ends)
        return 0;
    *mean = place_at(sums->x / sums->angle, sums->y / sums->angle);
    sums->angle = (1 - part) * step;
    sums->x = sums->angle * (x + next[0]) / 2;
    sums->y = sums->angle * (y + next[1]) / 2;
    return 1;
}

int graph_average(picture *p, fourlink_branch branch, int x, int y, graph_line *line)
{
    double turn = view_value(&p->v, QUANTITY_ANGLE, p->v.problem.cycle), last[2] = {0, 0}, next[2];
    const plot_sample *samples = picture_samples(p, branch);
    double before = 0;
    turn_sums sums = {0, 0, 0};
    fourlink_vector mean;
    int k, n = 0;

    clear(line);
    for (k = 0; samples && k <= PICTURE_STEPS && samples[k].status == FOURLINK_OK; k++) {
        const fourlink_instant *now = &samples[k].now;

        next[0] = samples[k].values[x];
        next[1] = samples[k].values[y];
        if (k > 0 && add_step(&sums, turn, fabs(now->row.angle - before), last, next, &mean)) {
            line->x[n] = mean.x;
            line->y[n] = mean.y;
            line->mu[n++] = now->state.mu;
        }
        before = now->row.angle;
        last[0] = next[0];
        last[1] = next[1];
    }
    line->n_points = n;
    return n >= FEWEST_TURNS;
}

static double distance(fourlink_vector p, fourlink_vector q, fourlink_vector size)
{
    return gsl_hypot(size.x > 0 ? (q.x - p.x) / size.x : 0, size.y > 0 ? (q.y - p.y) / size.y : 0);
}

/* Look for a jump of column y over column x between two crank angles, where they are at `from` and `to`; 1 if
** there is one, with its ends. */
static int find_jump(const picture *p, fourlink_branch branch, int x, int y, fourlink_vector size,
                     double low, double high, fourlink_vector *from, fourlink_vector *to)
{
    double step = distance(*from, *to, size), values[PICTURE_COLUMNS], middle;
    double x_turn = turn_of(p, x), y_turn = turn_of(p, y);
    fourlink_instant now;
    fourlink_vector at;
    int k;

    if (!p->v.problem.over.is_crank_angle || step < LARGE)
        return 0;
    for (k = 0; k < HALVINGS; k++) {
        middle = (low + high) / 2;
        if (fourlink_results_at(p->v.results, branch, middle, values, &now, NULL) != FOURLINK_OK ||
            now.state.mu < 1e-3)
            return 0;
        at.x = go_on(values[x], from->x, x_turn);
        at.y = go_on(values[y], from->y, y_turn);
        if (!gsl_finite(at.x) || !gsl_finite(at.y))
            return 0;
        if (distance(*from, at, size) > distance(at, *to, size)) {
            high = middle;
            *to = at;
        } else {
            low = middle;
            *from = at;
        }
    }
    return distance(*from, *to, size) > REMAINS * step;
}

static void add_jump(graph_jumps *jumps, int sample, fourlink_vector from, fourlink_vector to)
{
    if (jumps->n == GRAPH_JUMPS)
        return;
    jumps->sample[jumps->n] = sample;
    jumps->from[jumps->n] = from;
    jumps->to[jumps->n++] = to;
}

display_item *graph_begin(const picture *p, int stroke, const char *name, const char *of)
{
    char both[300];
    size_t kept =
        display_keep(p->on.d, flk_text_join(both, sizeof both, name, "_", of, (char *)NULL));

    display_item *curve = display_add(p->on.d, DISPLAY_CURVE, stroke, DISPLAY_CURVES);

    curve->name = kept;
    return curve;
}

void graph_draw(const picture *p, fourlink_branch branch, int x, int y, const graph_line *line,
                fourlink_vector size, graph_jumps *jumps)
{
    fourlink_vector gap = place_at(GSL_NAN, GSL_NAN), from, to;
    display *d = p->on.d;
    int was_there = 0, is_there, k;

    if (jumps)
        jumps->n = 0;
    for (k = 0; k <= PICTURE_STEPS; k++, was_there = is_there) {
        is_there = !gsl_isnan(line->y[k]);
        if (!is_there) {
            display_add_place(d, gap);
            continue;
        }
        to = place_at(line->x[k], line->y[k]);
        if (k > 0 && picture_side(p, k, PICTURE_STEPS) != picture_side(p, k - 1, PICTURE_STEPS)) {
            display_add_place(d, gap);
            was_there = 0;
        }
        if (was_there && jumps) {
            from = place_at(line->x[k - 1], line->y[k - 1]);
            if (find_jump(p, branch, x, y, size, picture_place(p, k - 1, PICTURE_STEPS),
                          picture_place(p, k, PICTURE_STEPS), &from, &to)) {
                display_add_place(d, from);
                display_add_place(d, gap);
                display_add_place(d, to);
                add_jump(jumps, k, from, to);
            }
        }
        display_add_place(d, place_at(line->x[k], line->y[k]));
    }
}

void graph_mark(const picture *p, fourlink_vector at, double radius, int is_open)
{
    display_item *mark = display_add(p->on.d, DISPLAY_MARK, 0, DISPLAY_FRONT);

    mark->size = radius;
    mark->is_open = is_open;
    display_add_place(p->on.d, at);
}

void graph_widen(double *low, double *high, double part)
{
    double size = GSL_MAX_DBL(fabs(*low), fabs(*high)), room = part * (*high - *low);

    if (*high - *low <= 1e-9 * size || size == 0)
        room = size > 0 ? 0.1 * size : 1;
    *low -= room;
    *high += room;
}

/* In degrees the steps are parts of a turn. */
double graph_angle_step(const picture *p, double span)
{
    static const double parts[] = {5, 10, 15, 30, 45, 60, 90, 180, 360, 720};
    double least = 6 * CANVAS_LETTER * span / p->on.box_width;
    size_t i;

    if (strcmp(p->v.units[QUANTITY_ANGLE].name, "deg") == 0)
        for (i = 0; i < sizeof parts / sizeof parts[0]; i++)
            if (parts[i] >= least)
                return least < 2 ? place_round(least) : parts[i];
    return place_round(least);
}
