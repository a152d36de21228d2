/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curves.c - motion and forces over the crank angle or over time.
*/
#include "panel.h"

static void put_line(picture *p, panel *q, fourlink_branch branch, int y)
{
    graph_put(p, branch, p->v.columns[y].name, 0, y, &q->e, &q->line[q->n]);
    graph_extend_x(&q->x, &q->line[q->n++]);
}

/* Draw a column, for all branches, with its extremes. */
static void put_panel(picture *p, int y)
{
    const char *name = p->v.columns[y].name;
    panel q;
    int i;

    panel_begin(p, &q, 1);
    for (i = 0; i < p->v.n_branches; i++)
        put_line(p, &q, p->v.branches[i], y);
    canvas_titles(&p->on, "", p->v.columns[0].name, p->v.columns[0].unit, name,
                  p->v.columns[y].unit);
    panel_range(p, &q);
    for (i = 0; i < p->v.n_branches; i++)
        if (q.line[i].n_points)
            panel_extremes(p, &q, y, i, i);
    for (i = 0; i < p->v.n_branches; i++)
        if (q.line[i].n_points) {
            graph_plot(p, p->v.branches[i], name, i + 1);
            fprintf(p->on.out, "'%s'", fourlink_branch_text(p->v.branches[i]));
        }
    putc('\n', p->on.out);
}

const char *picture_motion(picture *p, fourlink_branch branch)
{
    int i, drawn = 0;

    (void)branch;
    for (i = 1; i < (int)p->v.n_columns; i++) {
        if (!picture_draws(p, p->v.columns[i].name))
            continue;
        put_panel(p, i);
        drawn += p->on.curves;
    }
    return drawn ? NULL : picture_no_rows(p, p->v.branches[0]);
}

/* Draw columns of one unit in one panel. */
static void put_columns(picture *p, fourlink_branch branch, const char *const *names)
{
    panel q;
    int i, y;

    panel_begin(p, &q, 1);
    for (i = 0; names[i]; i++)
        if ((y = graph_column(p, names[i])) > 0) {
            put_line(p, &q, branch, y);
            canvas_titles(&p->on, fourlink_branch_text(branch), p->v.columns[0].name,
                          p->v.columns[0].unit, names[1] ? "force" : names[i],
                          p->v.columns[y].unit);
        }
    panel_range(p, &q);
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

    for (k = 0; k <= PICTURE_STEPS; k++)
        if (graph_sample(p, branch, k, values, &now)) {
            put_columns(p, branch, pins);
            put_columns(p, branch, torque);
            return NULL;
        }
    return picture_no_rows(p, branch);
}
