/* SPDX-License-Identifier: GPL-3.0-or-later
**
** columns.c - any columns as curves over the crank angle or another column.  Columns of one quantity share a
** panel, one for each branch; a column alone has one panel for both.
*/
#include <string.h>

#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include "base/message.h"
#include "panel.h"

#define LONGEST_NAME 24 /* letters, in a key or beside an axis */

/* Of a key: its width, and what an entry needs beside its name. */
#define KEY_WIDTH 480
#define KEY_SAMPLE (7 * CANVAS_LETTER)

/* The frame of an unbounded value has the part of its samples from SMALL to LARGE, and some of that more. */
#define SMALL 0.1
#define LARGE 0.9
#define MORE 0.25

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
    const char *x = p->request->x ? p->request->x : picture_over(p);
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
           (g->n + 1) * (KEY_SAMPLE + GSL_MIN_INT(longest, LONGEST_NAME) * CANVAS_LETTER) <=
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

/* 1 for x or y of a point, such as P.x or I13y. */
static int is_coordinate(const fourlink_value *column)
{
    size_t n = strlen(column->name);

    return strcmp(column->quantity, "length") == 0 && n > 2 &&
           (column->name[n - 1] == 'x' || column->name[n - 1] == 'y');
}

static int is_unbounded(const picture *p, int column, int i)
{
    fourlink_value found;
    int which;

    for (which = FOURLINK_MAX; which <= FOURLINK_MIN; which++)
        if (fourlink_results_get(p->v.results, p->v.columns[column].handle + which,
                                 p->v.branches[i], 0, &found) == FOURLINK_OK &&
            gsl_isinf(found.value))
            return 1;
    return 0;
}

/* Cut an axis where its values are unbounded. */
static void cut(panel *q, graph_extent *e, int of_x)
{
    double values[PANEL_CURVES * (PICTURE_STEPS + 1)], low, high;
    size_t n = 0;
    int i, k;

    for (i = 0; i < q->n; i++)
        for (k = 0; k <= PICTURE_STEPS; k++)
            if (!gsl_isnan(q->line[i].y[k]))
                values[n++] = of_x ? q->line[i].x[k] : q->line[i].y[k];
    if (n == 0 || graph_is_cut(e))
        return;
    gsl_sort(values, 1, n);
    low = gsl_stats_quantile_from_sorted_data(values, 1, n, SMALL);
    high = gsl_stats_quantile_from_sorted_data(values, 1, n, LARGE);
    graph_cut(e, low - MORE * (high - low), high + MORE * (high - low));
    q->is_unbounded = 1;
}

/* Write a curve, with breaks at its jumps. */
static void put_curve(const picture *p, const panel *q, int i, fourlink_branch branch, int column)
{
    const graph_line *line = &q->line[i];
    fourlink_vector size = place_at(graph_span(&q->x), graph_span(&q->e)), from, to;
    int k;

    canvas_print(&p->on, "$c%d_%s << EOD\n", column, fourlink_branch_text((int)branch));
    for (k = 0; k <= PICTURE_STEPS; k++) {
        if (gsl_isnan(line->y[k])) {
            canvas_print(&p->on, "\n");
            continue;
        }
        to = place_at(line->x[k], line->y[k]);
        if (k > 0 && !gsl_isnan(line->y[k - 1])) {
            from = place_at(line->x[k - 1], line->y[k - 1]);
            if (graph_find_jump(p, branch, 0, column, size, picture_angle(p, k - 1, PICTURE_STEPS),
                                picture_angle(p, k, PICTURE_STEPS), &from, &to))
                canvas_print(&p->on, "%.8g %.8g\n\n%.8g %.8g\n", from.x, from.y, to.x, to.y);
        }
        canvas_print(&p->on, "%.8g %.8g\n", line->x[k], line->y[k]);
    }
    canvas_print(&p->on, "EOD\n");
}

/* Sample curve i of a panel. */
static void sample(picture *p, panel *q, int i, int branch, int column)
{
    graph_follow(p, p->v.branches[branch], 0, column, &q->e, &q->line[i]);
    graph_extend_x(&q->x, &q->line[i]);
    q->n = i + 1;
}

static const char *short_name(const picture *p, int column, char out[200])
{
    return canvas_shorten(p->v.columns[column].name, LONGEST_NAME, 0, out, 200);
}

/* Put the names of the axes; of a panel of several columns, their quantity and the branch. */
static void put_titles(const picture *p, const group *g, int branch)
{
    const fourlink_value *c = &p->v.columns[g->column[0]];
    char words[200], x[200], *bar;

    if (g->n == 1) {
        short_name(p, g->column[0], words);
    } else {
        flk_text_join(words, sizeof words, c->quantity, (char *)NULL);
        while ((bar = strchr(words, '_')) != NULL)
            *bar = ' ';
    }
    canvas_titles(&p->on, g->n == 1 ? "" : fourlink_branch_text((int)p->v.branches[branch]),
                  short_name(p, 0, x), p->v.columns[0].unit, words, c->unit);
}

/* The curves of a panel: the column and the branch of each. */
typedef struct curves {
    int n, column[PANEL_CURVES], branch[PANEL_CURVES];
} curves;

/* Several columns on a branch, or one on all. */
static void choose(const picture *p, const group *g, int branch, curves *c)
{
    int several = g->n > 1, i;

    c->n = several ? g->n : p->v.n_branches;
    for (i = 0; i < c->n; i++) {
        c->column[i] = g->column[several ? i : 0];
        c->branch[i] = several ? branch : i;
    }
}

/* Sample the curves and find their frame. */
static void sample_all(picture *p, panel *q, const curves *c)
{
    int unbounded = 0, x_unbounded = 0, i;

    q->to_scale = is_coordinate(&p->v.columns[0]);
    for (i = 0; i < c->n; i++) {
        sample(p, q, i, c->branch[i], c->column[i]);
        unbounded = unbounded || is_unbounded(p, c->column[i], c->branch[i]);
        x_unbounded = x_unbounded || is_unbounded(p, 0, c->branch[i]);
        q->to_scale = q->to_scale && is_coordinate(&p->v.columns[c->column[i]]);
    }
    if (unbounded)
        cut(q, &q->e, 0);
    if (x_unbounded)
        cut(q, &q->x, 1);
}

/* Draw a panel; returns 0 if it has nothing to draw. */
static int put_panel(picture *p, const group *g, int branch)
{
    const char *branch_name;
    char words[200];
    curves c;
    panel q;
    int i;

    choose(p, g, branch, &c);
    panel_begin(p, &q, c.n);
    sample_all(p, &q, &c);
    for (i = 0; i < c.n; i++)
        put_curve(p, &q, i, p->v.branches[c.branch[i]], c.column[i]);
    put_titles(p, g, branch);
    panel_range(p, &q);
    for (i = 0; i < c.n; i++)
        if (q.line[i].n_points && g->n == 1)
            panel_extremes(p, &q, c.column[i], i, i);
    for (i = 0; i < c.n; i++) {
        branch_name = fourlink_branch_text((int)p->v.branches[c.branch[i]]);
        if (q.line[i].n_points)
            canvas_print(&p->on, "%s $c%d_%s using 1:2 with lines lt %d title %q",
                         p->on.curves++ ? "," : "plot", c.column[i], branch_name, i + 1,
                         g->n > 1 ? short_name(p, c.column[i], words) : branch_name);
    }
    canvas_print(&p->on, "\n");
    return p->on.curves > 0;
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
