/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curves.c - motion and forces over the crank angle or over time; the actual motion: the speed with its mean,
** the torques over the speed, and the energy.  There the torque of the motor lies on its own curve; that on
** the crank makes the loop of the cycle, or for a motion of several turns is averaged over each.
*/
#include <gsl/gsl_math.h>

#include "panel.h"

/* Draw a column, for all branches, with its extremes. */
static int put_column(picture *p, int column)
{
    panel_plan plan;
    int i;

    panel_plan_begin(&plan, 0);
    plan.by_branch = 1;
    plan.n = plan.n_extremes = p->v.n_branches;
    for (i = 0; i < plan.n; i++) {
        plan.column[i] = column;
        plan.branch[i] = i;
    }
    return panel_draw(p, &plan);
}

const char *picture_motion(picture *p, fourlink_branch branch)
{
    int i, drawn = 0;

    (void)branch;
    for (i = 1; i < (int)p->v.n_columns; i++)
        if (picture_draws(p, p->v.columns[i].name))
            drawn += put_column(p, i);
    return drawn ? NULL : picture_no_rows(p, p->v.branches[0]);
}

/* Put those columns on a branch into a plan that the deck has. */
static void plan_columns(const picture *p, panel_plan *plan, const char *over,
                         fourlink_branch branch, const char *const *names)
{
    int i, column;

    panel_plan_begin(plan, graph_column(p, over));
    plan->title = fourlink_branch_text(branch);
    for (i = 0; names[i]; i++)
        if ((column = graph_column(p, names[i])) > 0) {
            plan->line[plan->n] = i + 1;
            plan->branch[plan->n] = branch != p->v.branches[0];
            plan->column[plan->n++] = column;
        }
}

/* Draw the branches that can be assembled somewhere on the motion. */
const char *picture_forces(picture *p, fourlink_branch branch)
{
    static const char *const pins[] = {"F12", "F23", "F34", "F14", "N", NULL};
    static const char *const torque[] = {"Ts", NULL};
    panel_plan plan;

    plan_columns(p, &plan, picture_over(p), branch, pins);
    plan.y = "force";
    if (!panel_draw(p, &plan))
        return picture_no_rows(p, branch);
    plan_columns(p, &plan, picture_over(p), branch, torque);
    panel_draw(p, &plan);
    return NULL;
}

const char *picture_speed(picture *p, fourlink_branch branch)
{
    static const char *const speed[] = {"omega2", NULL}, *const energy[] = {"energy", NULL},
                             *const torques[] = {"T_motor", "Ts", NULL};
    const char *branch_name = fourlink_branch_text((int)branch);
    int is_later =
        p->v.problem.mode != FOURLINK_MODE_STEADY; /* the mean is that of a steady motion */
    char words[PICTURE_WORDS], title[PICTURE_WORDS + 20];
    fourlink_value mean;
    panel_plan plan;

    plan_columns(p, &plan, picture_over(p), branch, speed);
    plan.n_key = 2;
    plan.n_extremes = 1;
    if (fourlink_results_value(p->v.results, "mean_speed", branch, 0, &mean) == FOURLINK_OK) {
        plan.mean = mean.value;
        plan.mean_name = is_later ? "later mean" : "mean";
        picture_words(p, plan.mean_name, view_si(&p->v, QUANTITY_ANGULAR_SPEED, mean.value),
                      QUANTITY_ANGULAR_SPEED, words);
        plan.title = flk_text_join(title, sizeof title, branch_name, ": ", words, (char *)NULL);
    }
    if (!panel_draw(p, &plan))
        return picture_no_rows(p, branch);
    plan_columns(p, &plan, "omega2", branch, torques);
    plan.y = "torque";
    plan.n_key = 2;
    plan.by_turn = is_later && plan.n > 1 ? 2 : 0;
    panel_draw(p, &plan);
    plan_columns(p, &plan, picture_over(p), branch, energy);
    plan.n_key = 2;
    plan.n_extremes = 1;
    panel_draw(p, &plan);
    return NULL;
}
