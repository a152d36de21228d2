/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curves.c - motion and forces over the crank angle.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "graph.h"
#include "sketch.h"

#define NO_REACH "the linkage cannot be assembled at any angle of the motion"

/* Set the range, with room for the numbers of the extremes.  An empty range is widened here; gnuplot would
** choose its own. */
static void put_range(const canvas *on, const graph_extent *e)
{
    int is_cut = graph_is_cut(e);
    double low = is_cut ? e->sound_low : e->low, high = is_cut ? e->sound_high : e->high;
    double size = GSL_MAX_DBL(fabs(low), fabs(high)), room;
    double part = 1.8 * CANVAS_LINE / on->box_height;

    if (low > high)
        return;
    room = (high - low) * part / (1 - 2 * part);
    if (high - low <= 1e-9 * size || size == 0)
        room = size > 0 ? size : 1;
    canvas_print(on, "set yrange [%.8g:%.8g]\n", low - room, high + room);
    if (is_cut)
        fputs("set label 'beyond the frame near a dead position' at graph 0.5, graph 1 center "
              "front boxed offset 0,-0.8\n",
              on->out);
}

static void begin_panel(picture *p)
{
    double from = p->problem.motion.from;

    fputs("unset label; unset arrow\n", p->on.out);
    canvas_panel(&p->on, 3, 2 * CANVAS_LETTER);
    canvas_key(&p->on);
    canvas_grid(&p->on);
    canvas_print(&p->on, "set xrange [%.8g:%.8g]\nset xtics %.6g\n", from, p->end,
                 graph_angle_step(p, fabs(p->end - from)));
}

/* The marked extremes of a panel. */
typedef struct marks {
    double x[4], y[4]; /* fractions of the panel */
    int n;
} marks;

/* Put the value of an extreme above a maximum or below a minimum, unless it would cover another. */
static void put_extreme(const picture *p, double value, double angle, int is_minimum, double height,
                        marks *m)
{
    double from = p->problem.motion.from, x = (angle - from) / (p->end - from), y = value / height;
    int i, side = x < 0.1 ? 1 : x > 0.9 ? -1 : 0;

    for (i = 0; i < m->n; i++)
        if (fabs(x - m->x[i]) < 0.15 && fabs(y - m->y[i]) < 0.1)
            return;
    m->x[m->n] = x;
    m->y[m->n++] = y;
    canvas_print(&p->on,
                 "set label \"%.4g\" at %.8g,%.8g %s front boxed point pt 7 ps 0.6 lc rgb 'black' "
                 "offset %d,%d\n",
                 value, angle, value, canvas_side(side), side, is_minimum ? -1 : 1);
}

/* Put the extremes of a column on a branch that are in the picture; an extreme that is rounding compared with
** the other is 0. */
static void put_extremes(const picture *p, fourlink_branch branch, const char *name,
                         const graph_extent *e, marks *m)
{
    int there[2], is_cut = graph_is_cut(e), i;
    fourlink_value found[2];
    char extreme[80];

    for (i = 0; i < 2; i++) {
        flk_text_join(extreme, sizeof extreme, i ? "min(" : "max(", name, ")", (char *)NULL);
        there[i] =
            fourlink_results_value(p->results, extreme, branch, 0, &found[i]) == FOURLINK_OK &&
            gsl_finite(found[i].value);
    }
    for (i = 0; i < 2; i++) {
        if (!there[i] ||
            (is_cut && (found[i].value < e->sound_low || found[i].value > e->sound_high)))
            continue;
        if (there[1 - i] && fabs(found[i].value) < 1e-12 * fabs(found[1 - i].value))
            found[i].value = 0;
        put_extreme(p, found[i].value, found[i].angle, i,
                    is_cut ? e->sound_high - e->sound_low : e->high - e->low, m);
    }
}

/* Draw a column over the crank angle, for all branches, with its extremes. */
static void put_panel(picture *p, int y)
{
    const char *name = p->columns[y].name;
    graph_extent e = graph_nothing;
    int i, points[2];
    marks m;

    begin_panel(p);
    m.n = 0;
    for (i = 0; i < p->n_branches; i++)
        points[i] = graph_put(p, p->branches[i], name, 0, y, &e);
    for (i = 0; i < p->n_branches; i++)
        if (points[i])
            put_extremes(p, p->branches[i], name, &e, &m);
    canvas_titles(&p->on, "", "theta2", p->columns[0].unit, name, p->columns[y].unit);
    put_range(&p->on, &e);
    for (i = 0; i < p->n_branches; i++)
        if (points[i]) {
            graph_plot(p, p->branches[i], name, i + 1);
            fprintf(p->on.out, "'%s'", fourlink_branch_text(p->branches[i]));
        }
    putc('\n', p->on.out);
}

const char *picture_motion(picture *p, fourlink_branch branch)
{
    int i, drawn = 0;

    (void)branch;
    for (i = 1; i < (int)p->n_columns; i++) {
        put_panel(p, i);
        drawn += p->on.curves;
    }
    return drawn ? NULL : NO_REACH;
}

/* Draw columns of one unit in one panel. */
static void put_columns(picture *p, fourlink_branch branch, const char *const *names)
{
    graph_extent e = graph_nothing;
    int i, y;

    begin_panel(p);
    for (i = 0; names[i]; i++)
        if ((y = graph_column(p, names[i])) > 0) {
            graph_put(p, branch, names[i], 0, y, &e);
            canvas_titles(&p->on, fourlink_branch_text(branch), "theta2", p->columns[0].unit,
                          names[1] ? "force" : names[i], p->columns[y].unit);
        }
    put_range(&p->on, &e);
    for (i = 0; names[i]; i++)
        if (graph_column(p, names[i]) > 0) {
            graph_plot(p, branch, names[i], i + 1);
            canvas_print(&p->on, "%q", names[i]);
        }
    putc('\n', p->on.out);
}

/* Draw the branches that can be assembled somewhere on the motion. */
const char *picture_forces(picture *p, fourlink_branch branch)
{
    static const char *const pins[] = {"F12", "F23", "F34", "F14", "N", NULL};
    static const char *const torque[] = {"Ts", NULL};
    double values[PICTURE_COLUMNS];
    fourlink_instant now;
    int k;

    for (k = 0; k <= GRAPH_STEPS; k++)
        if (graph_sample(p, branch, k, values, &now)) {
            put_columns(p, branch, pins);
            put_columns(p, branch, torque);
            return NULL;
        }
    return NO_REACH;
}
