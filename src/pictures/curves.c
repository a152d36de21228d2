/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curves.c - motion and forces over the crank angle.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "graph.h"
#include "room.h"

#define MOST_CURVES 5
#define RINGS 3 /* a number stands beside its extreme */

#define NO_REACH "the linkage cannot be assembled at any angle of the motion"

/* The curves of a panel, and the places of its texts. */
typedef struct panel {
    graph_extent e;
    graph_line line[MOST_CURVES];
    int n;
    room r;
} panel;

/* Mark the deck's one instant in a picture of its cycle. */
static void put_instant(const picture *p, panel *q)
{
    double from = p->problem.motion.from, cycle = p->end - from, angle = p->instant;
    char words[PICTURE_MARK + 10], number[PICTURE_MARK];
    double half, x;

    if (!p->has_instant || cycle == 0)
        return;
    angle -= cycle * floor((angle - from) / cycle);
    flk_text_join(words, sizeof words, "\316\270" SUB_2 " = ",
                  picture_mark(p, p->instant, 4, number), (char *)NULL);
    half = 0.55 * canvas_width_of(words) / q->r.x_scale;
    x = angle + (fabs(cycle) / 2 > fabs(angle - from) ? half : -half);
    canvas_print(&p->on,
                 "set arrow from %.8g,graph 0 to %.8g,graph 1 nohead ls %d\n"
                 "set label %q at %.8g,graph 0 center front boxed offset 0,0.7\n",
                 angle, angle, PEN_CONSTRUCTION, words, x);
    room_take(&q->r, sketch_at(x, q->r.y_min + 0.7 * CANVAS_LINE / q->r.y_scale), words);
}

/* Set the range, with room for the numbers of the extremes.  An empty range is widened here; gnuplot would
** choose its own. */
static void put_range(const picture *p, panel *q)
{
    const graph_extent *e = &q->e;
    int is_cut = graph_is_cut(e), i, k;
    double low = is_cut ? e->sound_low : e->low, high = is_cut ? e->sound_high : e->high;
    double size = GSL_MAX_DBL(fabs(low), fabs(high)), border;
    double part = 1.8 * CANVAS_LINE / p->on.box_height;

    if (low > high)
        return;
    border = (high - low) * part / (1 - 2 * part);
    if (high - low <= 1e-9 * size || size == 0)
        border = size > 0 ? size : 1;
    canvas_print(&p->on, "set yrange [%.8g:%.8g]\n", low - border, high + border);
    if (is_cut)
        fputs("set label 'beyond the frame near a dead position' at graph 0.5, graph 1 center "
              "front boxed offset 0,-0.8\n",
              p->on.out);
    room_open(&q->r, &p->on, p->problem.motion.from, p->end, low - border, high + border);
    q->r.rings = RINGS;
    for (i = 0; i < q->n; i++) {
        room_break(&q->r);
        for (k = 0; k <= GRAPH_STEPS; k++)
            if (gsl_isnan(q->line[i].y[k]))
                room_break(&q->r);
            else
                room_point(&q->r, q->line[i].x[k], q->line[i].y[k]);
    }
    put_instant(p, q);
}

static void begin_panel(picture *p, panel *q)
{
    double from = p->problem.motion.from;

    q->e = graph_nothing;
    q->n = 0;
    fputs("unset label; unset arrow\n", p->on.out);
    canvas_panel(&p->on, 3, 2 * CANVAS_LETTER);
    canvas_key(&p->on);
    canvas_grid(&p->on);
    canvas_print(&p->on, "set xrange [%.8g:%.8g]\nset xtics %.6g\n", from, p->end,
                 graph_angle_step(p, fabs(p->end - from)));
}

/* The value on a curve at an angle that is the same but for whole turns. */
static double on_curve(const graph_line *line, fourlink_value value, double turn)
{
    double nearest = GSL_POSINF, y = value.value;
    int k;

    for (k = 0; k <= GRAPH_STEPS; k++)
        if (fabs(line->x[k] - value.angle) < nearest) {
            nearest = fabs(line->x[k] - value.angle);
            y = line->y[k];
        }
    return turn > 0 ? value.value + turn * floor((y - value.value) / turn + 0.5) : value.value;
}

/* Mark an extreme, with its value above a maximum or below a minimum if there is room. */
static void put_extreme(const picture *p, panel *q, double value, double angle, int is_minimum,
                        int line)
{
    char number[FORMAT_SIZE];
    fourlink_vector middle;

    canvas_print(&p->on, "set label \"\" at %.8g,%.8g point pt 7 ps 0.6 lc rgb 'black' front\n",
                 angle, value);
    format_general(value, 4, number);
    if (room_find(&q->r, sketch_at(angle, value), 0, is_minimum ? -1 : 1, 1, number, &middle))
        canvas_print(&p->on, "set label %q at %.8g,%.8g center front tc lt %d\n", number, middle.x,
                     middle.y, line);
}

/* Put the extremes of a column on a branch that are in the picture; what is rounding compared with the curves
** is 0. */
static void put_extremes(const picture *p, panel *q, int y, int i)
{
    const fourlink_value *column = &p->columns[y];
    int is_cut = graph_is_cut(&q->e), k, is_angle = strcmp(column->quantity, "angle") == 0;
    double turn = is_angle ? picture_value(p, QUANTITY_ANGLE, 2 * M_PI) : 0, value, first = GSL_NAN;
    double size = GSL_MAX_DBL(fabs(q->e.low), fabs(q->e.high));
    fourlink_value found;
    char extreme[80];

    for (k = 0; k < 2; k++) {
        flk_text_join(extreme, sizeof extreme, k ? "min(" : "max(", column->name, ")",
                      (char *)NULL);
        if (fourlink_results_value(p->results, extreme, p->branches[i], 0, &found) != FOURLINK_OK ||
            !gsl_finite(found.value) ||
            (is_cut && (found.value < q->e.sound_low || found.value > q->e.sound_high)))
            continue;
        value = on_curve(&q->line[i], found, turn);
        if (fabs(value) <= 1e-6 * size)
            value = 0;
        if (k == 0 || !(fabs(value - first) <= 1e-9 * size)) /* not a constant's minimum */
            put_extreme(p, q, value, found.angle, k, i + 1);
        first = value;
    }
}

/* Draw a column over the crank angle, for all branches, with its extremes. */
static void put_panel(picture *p, int y)
{
    const char *name = p->columns[y].name;
    panel q;
    int i;

    begin_panel(p, &q);
    for (i = 0; i < p->n_branches; i++)
        graph_put(p, p->branches[i], name, 0, y, &q.e, &q.line[q.n++]);
    canvas_titles(&p->on, "", "theta2", p->columns[0].unit, name, p->columns[y].unit);
    put_range(p, &q);
    for (i = 0; i < p->n_branches; i++)
        if (q.line[i].n_points)
            put_extremes(p, &q, y, i);
    for (i = 0; i < p->n_branches; i++)
        if (q.line[i].n_points) {
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
    panel q;
    int i, y;

    begin_panel(p, &q);
    for (i = 0; names[i]; i++)
        if ((y = graph_column(p, names[i])) > 0) {
            graph_put(p, branch, names[i], 0, y, &q.e, &q.line[q.n++]);
            canvas_titles(&p->on, fourlink_branch_text(branch), "theta2", p->columns[0].unit,
                          names[1] ? "force" : names[i], p->columns[y].unit);
        }
    put_range(p, &q);
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
