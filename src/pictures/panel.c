/* SPDX-License-Identifier: GPL-3.0-or-later
**
** panel.c - a panel of curves over the crank angle or another column: ranges, extremes, the deck's instant.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include "base/cycle.h"
#include "panel.h"

#define RINGS 3       /* a number stands beside its extreme */
#define KEY_LINE 3    /* curves named in one line of the key */
#define X_BORDER 0.03 /* of the range, at its ends */
#define X_LETTERS 7   /* between the numbers of the x axis */

/* The frame of an unbounded value has the part of its samples from SMALL to LARGE, and some of that more. */
#define SMALL 0.1
#define LARGE 0.9
#define MORE 0.25

/* The step of the numbers on the x axis of another column. */
static double x_step(const picture *p, const panel *q, double span)
{
    return strcmp(p->v.columns[q->x_column].quantity, "angle") == 0
               ? graph_angle_step(p, span)
               : place_round(X_LETTERS * CANVAS_LETTER * span / p->on.box_width);
}

/* Mark the deck's one instant in a picture of its cycle, over the crank angle. */
static void put_instant(const picture *p, panel *q)
{
    double from = p->v.problem.motion.from, cycle = p->v.end - from, angle;
    char words[PICTURE_MARK + 10], number[PICTURE_MARK];
    display_item *words_at;
    double half, x;

    if (!p->has_instant || cycle == 0)
        return;
    angle = flk_cycle_place(p->instant, from, cycle);
    flk_message(words, sizeof words, "\316\270" SUB_2 " = %s",
                picture_mark(p, p->instant, 4, number));
    half = 0.55 * canvas_width_of(words) / q->r.x_scale;
    x = angle + (fabs(cycle) / 2 > fabs(angle - from) ? half : -half);
    display_line(p->on.d, PEN_CONSTRUCTION, DISPLAY_LINES, place_at(angle, q->r.frame.y_min),
                 place_at(angle, q->r.frame.y_max));
    words_at = display_text(p->on.d, 0, place_at(x, q->r.frame.y_min), DISPLAY_MIDDLE, words);
    words_at->is_boxed = 1;
    words_at->dy = -0.7 * CANVAS_LINE;
    room_take(&q->r, place_at(x, q->r.frame.y_min + 0.7 * CANVAS_LINE / q->r.y_scale), words);
}

/* The same on curves over another column. */
static void put_instants(const picture *p, panel *q)
{
    double from = p->v.problem.motion.from, cycle = p->v.end - from, part;
    int i, k;

    if (!p->has_instant || cycle == 0)
        return;
    part = (flk_cycle_place(p->instant, from, cycle) - from) / cycle;
    k = (int)(PICTURE_STEPS * part + 0.5);
    for (i = 0; i < q->n; i++)
        if (!gsl_isnan(q->line[i].y[k]))
            graph_mark(p, place_at(q->line[i].x[k], q->line[i].y[k]), 5, 1);
}

/* The range of y, with room for the numbers of the extremes.  An empty range is widened. */
static void find_range(const picture *p, const panel *q, int has_zero, double *low, double *high)
{
    double size, border, part = 1.8 * CANVAS_LINE / p->on.box_height;

    graph_range(&q->e, low, high);
    size = GSL_MAX_DBL(fabs(*low), fabs(*high));
    border = (*high - *low) * part / (1 - 2 * part);
    if (*high - *low <= 1e-9 * size || size == 0)
        border = size > 0 ? size : 1;
    *high += border;
    *low = has_zero && *low >= 0 ? 0 : *low - border;
}

/* The crank angles from the first to the last at which a curve has a point, with some room: a part of the
** motion, if the linkage cannot be assembled in the rest. */
static void find_angles(const picture *p, const panel *q, double *from, double *to)
{
    int first = PICTURE_STEPS, last = 0, beside = (int)(X_BORDER * PICTURE_STEPS), i, k;

    for (i = 0; i < q->n; i++)
        for (k = 0; k <= PICTURE_STEPS; k++)
            if (!gsl_isnan(q->line[i].y[k])) {
                first = GSL_MIN_INT(first, k);
                last = GSL_MAX_INT(last, k);
            }
    if (last <= first || (first <= beside && last >= PICTURE_STEPS - beside))
        return;
    *from = picture_place(p, GSL_MAX_INT(first - beside, 0), PICTURE_STEPS);
    *to = picture_place(p, GSL_MIN_INT(last + beside, PICTURE_STEPS), PICTURE_STEPS);
}

/* What the title says of curves that the frame cuts. */
static const char *tell_cut(const picture *p, const panel *q)
{
    if (!graph_is_cut(&q->e) && (picture_is_over_angle(p, q->x_column) || !graph_is_cut(&q->x)))
        return "";
    return q->is_unbounded ? "beyond the frame where a value is unbounded"
                           : "beyond the frame near a dead position";
}

/* Set the axes, and keep texts away from the curves; mark the instant of a picture of its cycle. */
static void put_axes(const picture *p, panel *q, int has_zero)
{
    int is_over_angle = picture_is_over_angle(p, q->x_column), i;
    place_box frame;

    if (q->e.low > q->e.high)
        return;
    find_range(p, q, has_zero, &frame.y_min, &frame.y_max);
    frame.x_min = p->from;
    frame.x_max = p->v.end;
    if (is_over_angle) {
        find_angles(p, q, &frame.x_min, &frame.x_max);
    } else {
        graph_range(&q->x, &frame.x_min, &frame.x_max);
        graph_widen(&frame.x_min, &frame.x_max, X_BORDER);
    }
    if (q->to_scale)
        room_to_scale(&q->r, &frame, 0);
    room_set_axes(&q->r, frame, x_step(p, q, fabs(frame.x_max - frame.x_min)), 0);
    q->r.rings = RINGS;
    for (i = 0; i < q->n; i++)
        room_add_curve(&q->r, q->line[i].x, q->line[i].y, PICTURE_STEPS + 1);
    if (is_over_angle)
        put_instant(p, q);
    else
        put_instants(p, q);
}

/* The value on a curve at an angle that is the same but for whole turns. */
static double on_curve(const graph_line *line, fourlink_value value, double turn)
{
    double nearest = GSL_POSINF, y = value.value;
    int k;

    for (k = 0; k <= PICTURE_STEPS; k++)
        if (fabs(line->x[k] - value.angle) < nearest) {
            nearest = fabs(line->x[k] - value.angle);
            y = line->y[k];
        }
    return turn > 0 ? value.value + turn * flk_cycle_nearest(y - value.value, turn) : value.value;
}

/* Mark an extreme, with its value above a maximum or below a minimum if there is room. */
static void put_extreme(const picture *p, panel *q, double value, double angle, int is_minimum,
                        int line)
{
    char number[FORMAT_SIZE];
    fourlink_vector middle;

    graph_mark(p, place_at(angle, value), 3, 0);
    room_put(&q->r, place_at(angle, value), 0, is_minimum ? -1 : 1, 1,
             format_general(value, 4, number), PEN_CURVE + line - 1, &middle);
}

/* Over the crank angle, put the extremes of column y on this of the picture's branches, curve i, that are
** in the panel; what is rounding compared with the curves is 0. */
static void put_extremes(const picture *p, panel *q, int y, int branch, int i)
{
    const fourlink_value *column = &p->v.columns[y];
    int is_cut = graph_is_cut(&q->e), k, is_angle = strcmp(column->quantity, "angle") == 0;
    double turn = is_angle ? view_value(&p->v, QUANTITY_ANGLE, 2 * M_PI) : 0, value,
           first = GSL_NAN;
    double size = GSL_MAX_DBL(fabs(q->e.low), fabs(q->e.high));
    const fourlink_value *found;
    view_extremes extremes;

    if (!picture_is_over_angle(p, q->x_column))
        return;
    view_find_extremes(&p->v, p->v.branches[branch], &extremes);
    for (k = 0; k < 2; k++) {
        found = view_extreme(&extremes, column->handle + (k ? FOURLINK_MIN : FOURLINK_MAX));
        if (!found || !gsl_finite(found->value) ||
            (is_cut && (found->value < q->e.sound_low || found->value > q->e.sound_high)))
            continue;
        value = on_curve(&q->line[i], *found, turn);
        if (fabs(value) <= 1e-6 * size)
            value = 0;
        if (k == 0 || !(fabs(value - first) <= 1e-9 * size)) /* not a constant's minimum */
            put_extreme(p, q, value, found->angle, k, i + 1);
        first = value;
    }
}

/* ------------------------------------------------------------------------------------------- panels */

/* 1 for x or y of a point, such as P.x or I13y. */
static int is_coordinate(const fourlink_value *column)
{
    size_t n = strlen(column->name);

    return strcmp(column->quantity, "length") == 0 && n > 2 &&
           (column->name[n - 1] == 'x' || column->name[n - 1] == 'y');
}

static int is_unbounded(const picture *p, int column, int i)
{
    int handle = p->v.columns[column].handle;
    const fourlink_value *most, *least;
    view_extremes extremes;

    view_find_extremes(&p->v, p->v.branches[i], &extremes);
    most = view_extreme(&extremes, handle + FOURLINK_MAX);
    least = view_extreme(&extremes, handle + FOURLINK_MIN);
    return (most && gsl_isinf(most->value)) || (least && gsl_isinf(least->value));
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

static const char *short_name(const picture *p, int column, char out[200])
{
    char symbol[NOTATION_SIZE];

    return canvas_shorten(canvas_symbol(&p->on, p->v.columns[column].name, symbol), PANEL_LETTERS,
                          0, out, 200);
}

/* Draw a curve, with breaks at its jumps; one that is averaged with its points. */
static void put_curve(const picture *p, const panel *q, const panel_plan *plan, int i)
{
    int branch = plan->branch[i], stroke = PEN_CURVE + (plan->line[i] ? plan->line[i] - 1 : i), k;
    int is_averaged = q->is_averaged && i == plan->by_turn - 1;
    double x_low, x_high, low, high;
    char title[240], words[200];
    graph_jumps jumps;

    graph_range(&q->x, &x_low, &x_high);
    graph_range(&q->e, &low, &high);
    graph_begin(p, stroke, p->v.columns[plan->column[i]].name,
                fourlink_branch_text((int)p->v.branches[branch]));
    graph_draw(p, p->v.branches[branch], plan->x, plan->column[i], &q->line[i],
               place_at(x_high - x_low, high - low), plan->is_free ? &jumps : NULL);
    for (k = 0; is_averaged && k < q->line[i].n_points; k++)
        graph_mark(p, place_at(q->line[i].x[k], q->line[i].y[k]), 2.5, 0);
    flk_text_join(title, sizeof title,
                  plan->by_branch ? fourlink_branch_text((int)p->v.branches[branch])
                                  : short_name(p, plan->column[i], words),
                  is_averaged ? " per turn" : "", (char *)NULL);
    if (!plan->by_branch || p->v.n_branches > 1 || p->on.next == 1) /* of one branch once */
        canvas_add_key(q->r.on, DISPLAY_LINE, stroke, title);
}

/* Draw the line of a mean. */
static void put_mean(const picture *p, const panel *q, double mean, const char *name)
{
    display *d = q->r.on->d;

    graph_begin(p, PEN_CURVE + 1, "mean", "line");
    display_add_place(d, place_at(q->r.frame.x_min, mean));
    display_add_place(d, place_at(q->r.frame.x_max, mean));
    canvas_add_key(q->r.on, DISPLAY_LINE, PEN_CURVE + 1, name);
}

/* Sample the curves and find their frame. */
static void sample(picture *p, panel *q, const panel_plan *plan)
{
    int unbounded = 0, x_unbounded = 0, i;

    q->to_scale = plan->is_free && is_coordinate(&p->v.columns[plan->x]);
    for (i = 0; i < plan->n; i++) {
        int branch = plan->branch[i], column = plan->column[i];

        if (i != plan->by_turn - 1 ||
            !graph_average(p, p->v.branches[branch], plan->x, column, &q->line[i]))
            graph_follow(p, p->v.branches[branch], plan->x, column, &q->line[i]);
        else
            q->is_averaged = 1;
        unbounded = unbounded || (plan->is_free && is_unbounded(p, column, branch));
        x_unbounded = x_unbounded || (plan->is_free && is_unbounded(p, plan->x, branch));
        q->to_scale = q->to_scale && is_coordinate(&p->v.columns[column]);
    }
    q->n = plan->n;
    q->e = graph_extent_of(q->line, q->n, 0);
    q->x = graph_extent_of(q->line, q->n, 1);
    if (unbounded)
        cut(q, &q->e, 0);
    if (x_unbounded)
        cut(q, &q->x, 1);
}

void panel_plan_begin(panel_plan *plan, int x)
{
    memset(plan, 0, sizeof *plan);
    plan->x = x;
    plan->n_key = 1;
    plan->title = "";
    plan->mean = GSL_NAN;
}

int panel_draw(picture *p, const panel_plan *plan)
{
    char x[200], words[200];
    const char *cut_words;
    int i, drawn = 0;
    panel q;

    memset(&q, 0, sizeof q);
    q.x_column = plan->x;
    room_open(&q.r, &p->on, plan->n_key > KEY_LINE ? 4 : 3, 2 * CANVAS_LETTER);
    if (plan->n == 0) {
        canvas_drop_panel(&p->on);
        return 0;
    }
    sample(p, &q, plan);
    cut_words = tell_cut(p, &q);
    canvas_titles(&p->on, short_name(p, plan->x, x), p->v.columns[plan->x].unit,
                  plan->y ? plan->y : short_name(p, plan->column[0], words),
                  p->v.columns[plan->column[0]].unit, "%s%s%s", plan->title,
                  plan->title[0] && cut_words[0] ? ": " : "", cut_words);
    put_axes(p, &q, plan->has_zero);
    for (i = 0; i < plan->n; i++)
        if (q.line[i].n_points) {
            put_curve(p, &q, plan, i);
            drawn++;
        }
    for (i = 0; i < plan->n_extremes; i++)
        if (q.line[i].n_points)
            put_extremes(p, &q, plan->column[i], plan->branch[i], i);
    if (!gsl_isnan(plan->mean))
        put_mean(p, &q, plan->mean, plan->mean_name);
    if (drawn)
        canvas_end_panel(&p->on);
    else
        canvas_drop_panel(&p->on);
    return drawn > 0;
}
