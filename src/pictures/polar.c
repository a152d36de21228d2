/* SPDX-License-Identifier: GPL-3.0-or-later
**
** polar.c - pin forces as curves in the axes of their links, as in bearing-load diagrams, which show where a
** bearing wears.  Marks show the crank angle.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "graph.h"
#include "sketch.h"

#define MARKS 12
#define LETTERED 3 /* every third mark has its angle beside it */
#define MOST_LETTERED (2 * MARKS / LETTERED)

/* A pin force: the columns of its components. */
typedef struct bearing {
    char name[8];
    int x, y;
} bearing;

/* A drawing with equal scales on both axes, and its texts. */
typedef struct frame {
    sketch_box box;
    double scale; /* of a pixel */
    double x[MOST_LETTERED], y[MOST_LETTERED];
    int n;
} frame;

/* Find the room for the curves, and for the origin, where the force is 0. */
static void find_frame(const picture *p, const bearing *b, frame *f)
{
    graph_extent ex = graph_nothing, ey = graph_nothing;
    double values[PICTURE_COLUMNS];
    fourlink_instant now;
    int i, k, cut;

    for (i = 0; i < p->n_branches; i++)
        for (k = 0; k <= GRAPH_STEPS; k++)
            if (graph_sample(p, p->branches[i], k, values, &now)) {
                graph_extend(&ex, values[b->x], now.state.mu);
                graph_extend(&ey, values[b->y], now.state.mu);
            }
    cut = graph_is_cut(&ex) || graph_is_cut(&ey);
    memset(f, 0, sizeof *f);
    sketch_grow(&f->box, cut ? ex.sound_low : ex.low, cut ? ey.sound_low : ey.low);
    sketch_grow(&f->box, cut ? ex.sound_high : ex.high, cut ? ey.sound_high : ey.high);
}

static void put_frame(const canvas *on, frame *f)
{
    const sketch_box *b = &f->box;
    double border = 6 * CANVAS_LETTER, width, height; /* for the angles */

    f->scale = GSL_MAX_DBL((b->x_max - b->x_min) / (on->box_width - 2 * border),
                           (b->y_max - b->y_min) / (on->box_height - 2 * border));
    if (f->scale == 0)
        f->scale = 1 / on->box_width;
    width = f->scale * on->box_width;
    height = f->scale * on->box_height;
    canvas_print(on, "set xrange [%.6g:%.6g]\nset yrange [%.6g:%.6g]\nset tics %.6g\n",
                 (b->x_min + b->x_max - width) / 2, (b->x_min + b->x_max + width) / 2,
                 (b->y_min + b->y_max - height) / 2, (b->y_min + b->y_max + height) / 2,
                 sketch_round(8 * CANVAS_LETTER * f->scale));
}

/* Put a crank angle beside the curve, in its colour, unless another is there. */
static void put_angle(const picture *p, frame *f, double x, double y, double angle, int line)
{
    const sketch_box *b = &f->box;
    int side = x > (b->x_min + b->x_max) / 2 ? 1 : -1, i;
    char mark[PICTURE_MARK];

    if (x < b->x_min || x > b->x_max || y < b->y_min || y > b->y_max)
        return;
    for (i = 0; i < f->n; i++)
        if (fabs(x - f->x[i]) < 5 * CANVAS_LETTER * f->scale &&
            fabs(y - f->y[i]) < CANVAS_LINE * f->scale)
            return;
    f->x[f->n] = x;
    f->y[f->n++] = y;
    canvas_print(&p->on, "set label %q at %.8g,%.8g %s front tc lt %d offset %d,%s\n",
                 picture_mark(p, angle, 4, mark), x, y, canvas_side(side), line, side,
                 y > (b->y_min + b->y_max) / 2 ? "0.4" : "-0.4");
}

/* Write the crank angles along the curve of branch i, as $NAME_BRANCH_marks. */
static void put_marks(const picture *p, int i, const bearing *b, frame *f)
{
    const int step = GRAPH_STEPS / MARKS;
    double values[PICTURE_COLUMNS];
    fourlink_instant now;
    int k;

    fprintf(p->on.out, "$%s_%s_marks << EOD\n", b->name, fourlink_branch_text(p->branches[i]));
    for (k = 0; k < MARKS; k++)
        if (graph_sample(p, p->branches[i], k * step, values, &now))
            canvas_print(&p->on, "%.8g %.8g\n", values[b->x], values[b->y]);
    fputs("EOD\n", p->on.out);
    for (k = 0; k < MARKS; k += LETTERED)
        if (graph_sample(p, p->branches[i], k * step, values, &now))
            put_angle(p, f, values[b->x], values[b->y], now.row.angle, i + 1);
}

static int put_polar(picture *p, const bearing *b, const char *title)
{
    int i, points[2];
    graph_extent e = graph_nothing;
    frame f;

    fputs("unset label; unset arrow\n", p->on.out);
    canvas_panel(&p->on, 3, 4 * CANVAS_LETTER);
    canvas_key(&p->on);
    canvas_titles(&p->on, title, p->columns[b->x].name, p->columns[b->x].unit,
                  p->columns[b->y].name, p->columns[b->y].unit);
    find_frame(p, b, &f);
    put_frame(&p->on, &f);
    for (i = 0; i < p->n_branches; i++)
        if ((points[i] = graph_put(p, p->branches[i], b->name, b->x, b->y, &e)) > 0)
            put_marks(p, i, b, &f);
    for (i = 0; i < p->n_branches; i++)
        if (points[i]) {
            const char *branch = fourlink_branch_text(p->branches[i]);

            graph_plot(p, p->branches[i], b->name, i + 1);
            fprintf(p->on.out,
                    "'%s', $%s_%s_marks using 1:2 with points pt 7 ps 0.5 lc rgb 'black'", branch,
                    b->name, branch);
        }
    putc('\n', p->on.out);
    return p->on.curves;
}

/* The index of a component's column; -1 if there is none. */
static int component(const picture *p, const bearing *b, const char *end)
{
    char name[20];

    return graph_column(p, flk_text_join(name, sizeof name, b->name, end, (char *)NULL));
}

/* Draw the force of a link on another, in the axes of the latter, which are x and y for a link that
** slides. */
static int put_bearing(picture *p, int by, int on)
{
    int slides = fourlink_slides(p->kind, on) == FOURLINK_GROUND;
    const char *link = fourlink_link_text(p->kind, on);
    char title[120];
    bearing b;

    if (fourlink_slides(p->kind, on) == by || fourlink_slides(p->kind, by) == on)
        return 0; /* always across the slide */
    sprintf(b.name, "F%d%d", by, on);
    b.x = component(p, &b, slides ? "x" : "_along");
    b.y = component(p, &b, slides ? "y" : "_across");
    if (b.x < 0 || b.y < 0)
        return 0;
    flk_text_join(title, sizeof title, b.name, ", ", fourlink_link_text(p->kind, by), " on ", link,
                  ", in the ", link, "'s axes", (char *)NULL);
    return put_polar(p, &b, title);
}

const char *picture_polar(picture *p, fourlink_branch branch)
{
    static const int joints[][2] = {{1, 2}, {3, 2}, {2, 3}, {4, 3}, {3, 4}, {1, 4}};
    int drawn = 0;
    size_t i;

    (void)branch;
    canvas_grid(&p->on);
    fprintf(p->on.out,
            "set format '%%g'; set size ratio -1\n"
            "set zeroaxis lt %d lw 1 lc rgb 'black'\n",
            p->on.is_text ? -1 : 1);
    for (i = 0; i < sizeof joints / sizeof joints[0]; i++)
        drawn += put_bearing(p, joints[i][0], joints[i][1]);
    return drawn ? NULL : "the linkage cannot be assembled at any angle of the motion";
}
