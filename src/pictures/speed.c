/* SPDX-License-Identifier: GPL-3.0-or-later
**
** speed.c - the actual motion: the speed with its mean, the torques over the speed, and the energy.  The torque of
** the motor lies on its own curve; that on the crank makes the loop of the cycle.
*/
#include <gsl/gsl_math.h>

#include "panel.h"

/* The branch, and the mean if there is one. */
static void put_branch(const picture *p, fourlink_branch branch, double mean, char *title,
                       size_t size)
{
    char words[PICTURE_WORDS] = "";

    if (!gsl_isnan(mean))
        picture_words(p, "mean", view_si(&p->v, QUANTITY_ANGULAR_SPEED, mean),
                      QUANTITY_ANGULAR_SPEED, words);
    flk_text_join(title, size, fourlink_branch_text((int)branch), words[0] ? ": " : "", words,
                  (char *)NULL);
}

/* Draw columns over column x.  `mean`: of the first, in its unit, or NaN. */
static int put_panel(picture *p, fourlink_branch branch, const char *over, const char *const *names,
                     double mean)
{
    const char *drawn[PANEL_CURVES];
    char title[PICTURE_WORDS + 20];
    int x = graph_column(p, over), y, i, n = 0;
    panel q;

    put_branch(p, branch, mean, title, sizeof title);
    panel_begin_over(p, &q, x, 2);
    for (i = 0; names[i]; i++)
        if ((y = graph_column(p, names[i])) > 0) {
            graph_put(p, branch, names[i], x, y, &q.e, &q.line[n]);
            graph_extend_x(&q.x, &q.line[n]);
            canvas_titles(&p->on, title, over, p->v.columns[x].unit, names[1] ? "torque" : names[0],
                          p->v.columns[y].unit);
            drawn[n++] = names[i];
        }
    q.n = n;
    if (!n || !q.line[0].n_points)
        return 0;
    panel_range(p, &q);
    panel_extremes(p, &q, graph_column(p, drawn[0]), branch != p->v.branches[0], 0);
    for (i = 0; i < n; i++) {
        graph_plot(p, branch, drawn[i], i + 1);
        canvas_print(&p->on, "%q", drawn[i]);
    }
    if (!gsl_isnan(mean))
        canvas_print(&p->on, ", %.8g with lines lt 2 title 'mean'", mean);
    canvas_print(&p->on, "\n");
    return 1;
}

const char *picture_speed(picture *p, fourlink_branch branch)
{
    static const char *const speed[] = {"omega2", NULL}, *const energy[] = {"energy", NULL},
                             *const torques[] = {"T_motor", "Ts", NULL};
    fourlink_value mean;
    int status = fourlink_results_value(p->v.results, "mean_speed", branch, 0, &mean);

    if (!put_panel(p, branch, picture_over(p), speed, status == FOURLINK_OK ? mean.value : GSL_NAN))
        return picture_no_rows(p, branch);
    put_panel(p, branch, "omega2", torques, GSL_NAN);
    put_panel(p, branch, picture_over(p), energy, GSL_NAN);
    return NULL;
}
