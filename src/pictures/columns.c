/* SPDX-License-Identifier: GPL-3.0-or-later
**
** columns.c - columns as curves: any over the crank angle or another column; motion and forces over the
** crank angle or over time; the actual motion.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/message.h"
#include "panel.h"
#include "view/results.h"

/* ------------------------------------------------------------------------------------- any columns */

/* Columns of one quantity share a panel, one for each branch; a column alone has one panel for both. */

/* Of a key: its width, and what an entry needs beside its name. */
#define KEY_WIDTH 480
#define KEY_SAMPLE (7 * CANVAS_LETTER)

/* The columns of a panel. */
typedef struct group {
    int column[PANEL_CURVES], n;
} group;

/* 1 if a name can be that of a column. */
static int is_name(const char *name)
{
    const char *c = name;

    while (flk_text_is_word(*c) || *c == '.')
        c++;
    return *name && !*c && strcmp(name, "all") != 0;
}

/* Check the column of --plot-x.  A name that no column of a deck has is refused when the deck is opened with
** it, as any other. */
static int check_x(const picture *p, const char *name, fourlink_mistake *mistake)
{
    static const char *const words[] = {"status", "branch", "deck", "type", NULL};
    char message[MESSAGE_SIZE];
    fourlink_value found;
    int i;

    for (i = 0; words[i] && strcmp(name, words[i]) != 0; i++)
        ;
    if (words[i])
        flk_message(message, sizeof message, "'%s' is a word, not a number to draw over", name);
    else if (fourlink_results_find(p->v.results, name, &found) == FOURLINK_OK && !found.has_angle)
        flk_message(message, sizeof message, "'%t' is one value, not a column", flk_text_of(name));
    else if (!is_name(name))
        flk_message(message, sizeof message, "expected the name of a column, not '%t'",
                    flk_text_of(name));
    else
        return 1;
    return view_refuse(mistake, "--plot-x", message, "");
}

/* 1 for a measure of rounding beside other columns: its curve says nothing. */
static int is_rounding(const picture *p, unsigned long column)
{
    return p->v.columns[column].flags & FOURLINK_OF_ROUNDING && p->v.n_columns > 1;
}

int picture_choose_columns(const picture *p, char out[PICTURE_NAMES], fourlink_mistake *mistake)
{
    const char *x = p->request->x ? p->request->x : p->v.problem.over.name;
    unsigned long i, drawn = 0;

    if (!check_x(p, x, mistake))
        return 0;
    flk_text_join(out, PICTURE_NAMES, x, (char *)NULL);
    for (i = 0; i < p->v.n_columns; i++)
        if (strcmp(p->v.columns[i].name, x) != 0 && !is_rounding(p, i)) {
            flk_text_join(out + strlen(out), PICTURE_NAMES - strlen(out), " ", p->v.columns[i].name,
                          (char *)NULL);
            drawn++;
        }
    return drawn ||
           view_refuse(mistake, "--plot-kind", "no column to draw; name some with --columns", "");
}

/* 1 if the key has room for one more column. */
static int has_room(const picture *p, const group *g, int column)
{
    int longest = canvas_letters(p->v.columns[column].name), i;

    for (i = 0; i < g->n; i++)
        longest = GSL_MAX_INT(longest, canvas_letters(p->v.columns[g->column[i]].name));
    return g->n < PANEL_CURVES &&
           (g->n + 1) * (KEY_SAMPLE + GSL_MIN_INT(longest, PANEL_LETTERS) * CANVAS_LETTER) <=
               KEY_WIDTH;
}

/* 1 if a column belongs to a group: plain numbers have nothing in common. */
static int belongs(const picture *p, const group *g, int column)
{
    const fourlink_value *c = &p->v.columns[column], *first = &p->v.columns[g->column[0]];

    return strcmp(c->quantity, "number") != 0 && strcmp(c->quantity, first->quantity) == 0 &&
           has_room(p, g, column);
}

/* Group all columns but the first, which is on the x axis; returns how many groups there are. */
static int make_groups(const picture *p, group groups[PICTURE_COLUMNS])
{
    int n = 0, i, k;

    for (i = 1; i < (int)p->v.n_columns; i++) {
        for (k = 0; k < n && !belongs(p, &groups[k], i); k++)
            ;
        if (k == n)
            groups[n++].n = 0;
        groups[k].column[groups[k].n++] = i;
    }
    return n;
}

int picture_column_panels(const picture *p)
{
    group groups[PICTURE_COLUMNS];
    int n = make_groups(p, groups), panels = 0, i;

    for (i = 0; i < n; i++)
        panels += groups[i].n > 1 ? p->v.n_branches : 1;
    return panels;
}

/* Draw a panel; returns 0 if it has nothing to draw. */
static int put_panel(picture *p, const group *g, int branch)
{
    int several = g->n > 1, i;
    char quantity_words[200], *bar;
    panel_plan plan;

    panel_plan_begin(&plan, 0);
    plan.is_free = 1;
    plan.by_branch = !several;
    plan.n = plan.n_key = several ? g->n : p->v.n_branches;
    for (i = 0; i < plan.n; i++) {
        plan.column[i] = g->column[several ? i : 0];
        plan.branch[i] = several ? branch : i;
    }
    if (several) {
        flk_text_join(quantity_words, sizeof quantity_words, p->v.columns[g->column[0]].quantity,
                      (char *)NULL);
        while ((bar = strchr(quantity_words, '_')) != NULL)
            *bar = ' ';
        plan.title = fourlink_branch_text((int)p->v.branches[branch]);
        plan.y = quantity_words;
    } else {
        plan.n_extremes = plan.n;
    }
    return panel_draw(p, &plan);
}

/* Draw the groups of several columns, then the others: so the two branches of a group stand side by side. */
static int put_groups(picture *p, const group *groups, int n)
{
    int drawn = 0, several, i, b;

    for (several = 1; several >= 0; several--)
        for (i = 0; i < n; i++)
            for (b = 0; (groups[i].n > 1) == several && b < (several ? p->v.n_branches : 1); b++)
                drawn += put_panel(p, &groups[i], b);
    return drawn;
}

const char *picture_columns(picture *p, fourlink_branch branch)
{
    group groups[PICTURE_COLUMNS];

    (void)branch;
    if (picture_has_outputs(p))
        return picture_outputs(p);
    return put_groups(p, groups, make_groups(p, groups)) ? NULL
                                                         : picture_no_rows(p, p->v.branches[0]);
}

/* ------------------------------------------------------------------- motion, forces, the actual motion */

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

/* 1 for a velocity or an acceleration of a crank that stands still. */
static int is_zero(const picture *p, int column)
{
    const char *of = p->v.columns[column].quantity;

    return view_is_still(&p->v) && strcmp(of, "angle") != 0 && strcmp(of, "length") != 0;
}

/* 0 for an angle or a place, 1 for a velocity, 2 for an acceleration. */
static int derivative_of(const picture *p, int column)
{
    const char *of = p->v.columns[column].quantity;

    return strstr(of, "acceleration") ? 2 : strstr(of, "speed") ? 1 : 0;
}

/* A line for each derivative; behind those of the links are those of the outputs. */
const char *picture_motion(picture *p, fourlink_branch branch)
{
    int derivative, i, drawn = 0;

    (void)branch;
    for (derivative = 0; derivative < 3; derivative++)
        for (i = 1; i < (int)p->v.n_columns; i++)
            if (derivative_of(p, i) == derivative && picture_draws(p, p->v.columns[i].name) &&
                !is_zero(p, i))
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
    static const char *const torque[] = {"Ts", NULL}, *const drive[] = {"drive", NULL};
    panel_plan plan;

    plan_columns(p, &plan, p->v.problem.over.name, branch, pins);
    plan.y = "force";
    plan.has_zero = 1;
    plan.n_extremes = plan.n;
    if (!panel_draw(p, &plan))
        return picture_no_rows(p, branch);
    plan_columns(p, &plan, p->v.problem.over.name, branch,
                 p->v.problem.mechanism.drive ? drive : torque);
    plan.n_extremes = plan.n;
    panel_draw(p, &plan);
    return NULL;
}

/* The speed with its mean, the torques over the speed, and the energy.  There the torque of the motor lies on
** its own curve; that on the crank makes the loop of the cycle, or for a motion of several turns is averaged
** over each. */
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

    plan_columns(p, &plan, p->v.problem.over.name, branch, speed);
    plan.n_key = 2;
    plan.n_extremes = 1;
    if (results_value(p->v.results, "mean_speed", branch, 0, &mean) == FOURLINK_OK) {
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
    plan_columns(p, &plan, p->v.problem.over.name, branch, energy);
    plan.n_key = 2;
    plan.n_extremes = 1;
    panel_draw(p, &plan);
    return NULL;
}
