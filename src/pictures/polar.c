/* SPDX-License-Identifier: GPL-3.0-or-later
**
** polar.c - pin forces as curves in the axes of their links, as in bearing-load diagrams, which show where a
** bearing wears; and the shaking force of a deck with [balance], without the counterweights and with
** them.  Dots show the crank angle, an arrow the direction, dashes the jumps of loads.
*/
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "graph.h"
#include "room.h"

#define MOST_DOTS 26
#define RINGS 4                    /* an angle stands beside its dot */
#define LETTERED 3                 /* every third dot has its angle beside it */
#define BORDER (5 * CANVAS_LETTER) /* around the curve, for the angles */

/* A curve of a panel: of which deck, on which branch, and its title. */
typedef struct source {
    picture *p;
    fourlink_branch branch;
    const char *title;
} source;

/* A force: the columns of its components, and its curves. */
typedef struct bearing {
    const picture *p;
    char name[8];
    int x, y;
    source of[2];
    graph_line line[2];
    graph_jumps jumps[2];
    int n;
    place_box box; /* of the curves */
    double scale;  /* of a pixel */
    room r;
} bearing;

/* Follow the curves, and find their room, with that of the origin, where the force is 0. */
static void follow(bearing *b)
{
    graph_extent ex, ey;
    int cut, i;

    for (i = 0; i < b->n; i++)
        graph_follow(b->of[i].p, b->of[i].branch, b->x, b->y, &b->line[i]);
    ex = graph_extent_of(b->line, b->n, 1);
    ey = graph_extent_of(b->line, b->n, 0);
    cut = graph_is_cut(&ex) || graph_is_cut(&ey);
    b->box = place_nothing;
    place_grow(&b->box, 0, 0);
    place_grow(&b->box, cut ? ex.sound_low : ex.low, cut ? ey.sound_low : ey.low);
    place_grow(&b->box, cut ? ex.sound_high : ex.high, cut ? ey.sound_high : ey.high);
}

/* Set axes with equal scales, and mark the origin. */
static void put_axes(bearing *b)
{
    place_box frame = b->box;

    b->scale = room_to_scale(&b->r, &frame, BORDER);
    room_set_axes(&b->r, frame, place_round(8 * CANVAS_LETTER * b->scale),
                  place_round(8 * CANVAS_LETTER * b->scale));
    graph_mark(b->p, place_at(0, 0), 5, 1);
    b->r.rings = RINGS;
    room_add_line(&b->r, place_at(frame.x_min, 0), place_at(frame.x_max, 0));
    room_add_line(&b->r, place_at(0, frame.y_min), place_at(0, frame.y_max));
}

/* Draw curve i, with breaks at its jumps, and these as dashes. */
static void put_curve(bearing *b, int i)
{
    double size = GSL_MAX_DBL(b->box.x_max - b->box.x_min, b->box.y_max - b->box.y_min);
    graph_jumps *jumps = &b->jumps[i];
    display *d = b->p->on.d;
    int k;

    graph_begin(b->p, PEN_CURVE + i, b->name, b->of[i].title);
    graph_draw(b->of[i].p, b->of[i].branch, b->x, b->y, &b->line[i], place_at(size, size), jumps);
    room_add_curve(&b->r, b->line[i].x, b->line[i].y, PICTURE_STEPS + 1);
    if (jumps->n)
        graph_begin(b->p, PEN_JUMP + i, b->name, "jumps");
    for (k = 0; k < jumps->n; k++) {
        display_add_place(d, jumps->from[k]);
        display_add_place(d, jumps->to[k]);
        display_add_place(d, place_at(GSL_NAN, GSL_NAN));
    }
}

/* 1 if a place is within the axes, where curves are cut, but arrows not. */
static int is_drawn(const bearing *b, fourlink_vector F)
{
    const place_box *frame = &b->r.frame;

    return frame->x_min < F.x && F.x < frame->x_max && frame->y_min < F.y && F.y < frame->y_max;
}

/* Show the direction of a curve at its longest step that is no jump. */
static void put_arrow(const bearing *b, int i)
{
    const graph_line *line = &b->line[i];
    fourlink_vector from, to, tail = {0, 0}, head = {0, 0};
    int next_jump = 0, k;

    for (k = 1; k <= PICTURE_STEPS; k++) {
        from = place_at(line->x[k - 1], line->y[k - 1]);
        to = place_at(line->x[k], line->y[k]);
        if (next_jump < b->jumps[i].n && b->jumps[i].sample[next_jump] == k)
            next_jump++;
        else if (is_drawn(b, from) && is_drawn(b, to) &&
                 place_distance(from, to) > place_distance(tail, head)) {
            tail = from;
            head = to;
        }
    }
    if (place_distance(tail, head) > 0) {
        display_item *arrow = display_line(b->p->on.d, PEN_CURVE + i, DISPLAY_FRONT, tail, head);

        arrow->sort = DISPLAY_ARROW;
        arrow->size = 0.05;
        arrow->is_open = 1; /* its head has this length, however short it is */
    }
}

/* The steps of the dots, in degrees. */
static int step_of_dots(const picture *p)
{
    double span = fabs(p->v.end - p->from) / view_value(&p->v, QUANTITY_ANGLE, M_PI / 180);

    return span > 90.0001 ? 30 : span > 30.0001 ? 10 : 2;
}

/* Put a crank angle beside the curve, on the side away from the middle. */
static void put_angle(bearing *b, double angle, fourlink_vector F, int line)
{
    fourlink_vector middle;
    char mark[PICTURE_MARK];

    room_put(&b->r, F, F.x - (b->box.x_min + b->box.x_max) / 2,
             F.y - (b->box.y_min + b->box.y_max) / 2, 1, picture_mark(b->p, angle, 4, mark),
             PEN_CURVE + line - 1, &middle);
}

/* The force at a crank angle; 0 if the linkage cannot be assembled there. */
static int force_at(const bearing *b, int i, double angle, fourlink_vector *F)
{
    double values[PICTURE_COLUMNS];
    fourlink_instant now;

    if (fourlink_results_at(b->of[i].p->v.results, b->of[i].branch, angle, values, &now, NULL) !=
            FOURLINK_OK ||
        now.state.mu < 1e-3)
        return 0;
    *F = place_at(values[b->x], values[b->y]);
    return 1;
}

/* Put the dots, with their angles. */
static void put_dots(bearing *b, int i)
{
    const picture *p = b->p;
    double from = p->from, sense = p->v.end < from ? -1 : 1;
    double step = sense * view_value(&p->v, QUANTITY_ANGLE, step_of_dots(p) * M_PI / 180);
    double first = step * ceil(from / step - 1e-9), angles[MOST_DOTS];
    fourlink_vector F[MOST_DOTS];
    int k, n = 0, n_dots = 0;

    for (k = 0; k < MOST_DOTS && (first + k * step - p->v.end) * sense < 1e-9 * fabs(step); k++)
        if (force_at(b, i, first + k * step, &F[n_dots])) {
            graph_mark(p, F[n_dots], 2.5, 0);
            angles[n_dots++] = first + k * step;
        }
    for (; n < n_dots; n++)
        if (n % LETTERED == 0 && !(n && place_distance(F[n], F[0]) < 1e-6 * b->scale))
            put_angle(b, angles[n], F[n], i + 1);
}

/* Add a curve to the key; the last one with what is the same for all. */
static void put_key(const bearing *b, int i, int is_last)
{
    char words[40];

    canvas_add_key(b->r.on, DISPLAY_LINE, PEN_CURVE + i, b->of[i].title);
    if (!is_last)
        return;
    if (b->jumps[i].n)
        canvas_add_key(b->r.on, DISPLAY_LINE, PEN_JUMP + i, "jump");
    sprintf(words, "%d\302\260 apart", step_of_dots(b->p));
    canvas_add_key(b->r.on, DISPLAY_MARK, 0, words);
}

static int put_polar(picture *p, bearing *b, const char *title)
{
    char x[NOTATION_SIZE], y[NOTATION_SIZE];
    int drawn = 0, i;

    room_open(&b->r, &p->on, 4, 4 * CANVAS_LETTER); /* a key of two lines */
    canvas_titles(&p->on, canvas_symbol(&p->on, p->v.columns[b->x].name, x),
                  p->v.columns[b->x].unit, canvas_symbol(&p->on, p->v.columns[b->y].name, y),
                  p->v.columns[b->y].unit, "%s", title);
    b->p = p;
    follow(b);
    put_axes(b);
    for (i = 0; i < b->n; i++) {
        put_curve(b, i);
        put_arrow(b, i);
    }
    for (i = 0; i < b->n; i++)
        if (b->line[i].n_points) {
            put_dots(b, i);
            put_key(b, i, i == b->n - 1 || !b->line[1].n_points);
            drawn++;
        }
    canvas_end_panel(&p->on);
    return drawn;
}

/* The index of a component's column; -1 if there is none. */
static int component(const picture *p, const bearing *b, const char *end)
{
    char name[20];

    return graph_column(p, flk_text_join(name, sizeof name, b->name, end, (char *)NULL));
}

static void set_source(source *x, picture *p, fourlink_branch branch, const char *title)
{
    x->p = p;
    x->branch = branch;
    x->title = title;
}

/* Draw the force of a link on another, in the axes of the latter, which are x and y for a link that
** slides. */
static int put_bearing(picture *p, int by, int on)
{
    int is_piston = p->v.kind.slides_on[on] == FOURLINK_GROUND;
    char title[200], symbol[NOTATION_SIZE];
    bearing b;
    int i;

    if (p->v.kind.slides_on[on] == by || p->v.kind.slides_on[by] == on)
        return 0; /* always across the slide */
    sprintf(b.name, "F%d%d", by, on);
    b.x = component(p, &b, is_piston ? "x" : "_along");
    b.y = component(p, &b, is_piston ? "y" : "_across");
    if (b.x < 0 || b.y < 0)
        return 0;
    b.n = p->v.n_branches;
    for (i = 0; i < b.n; i++)
        set_source(&b.of[i], p, p->v.branches[i], fourlink_branch_text(p->v.branches[i]));
    flk_message(title, sizeof title, "%s on the %s, in its axes",
                canvas_symbol(&p->on, b.name, symbol), p->v.kind.link[on]);
    return put_polar(p, &b, title);
}

/* Draw the shaking force of a branch, without counterweights and with them. */
static int put_shaking(picture *p, picture *before, picture *after, fourlink_branch branch)
{
    char title[120];
    bearing b;

    strcpy(b.name, "Fs");
    b.x = component(p, &b, "x");
    b.y = component(p, &b, "y");
    b.n = 2;
    set_source(&b.of[0], before, branch, "before");
    set_source(&b.of[1], after, branch, "after");
    flk_message(title, sizeof title, "shaking force, %s", fourlink_branch_text(branch));
    return put_polar(p, &b, title);
}

static int put_balance(picture *p)
{
    picture before, after;
    int drawn = 0, i, is_open = picture_open_balance(p, "balance.apply=no", &before);

    is_open = picture_open_balance(p, "balance.apply=yes", &after) && is_open;
    for (i = 0; i < p->v.n_branches && is_open; i++)
        drawn += put_shaking(p, &before, &after, p->v.branches[i]);
    picture_close(&before);
    picture_close(&after);
    return drawn;
}

const char *picture_polar(picture *p, fourlink_branch branch)
{
    static const int joints[][2] = {{1, 2}, {3, 2}, {2, 3}, {4, 3}, {3, 4}, {1, 4}};
    int drawn = 0;
    size_t i;

    (void)branch;
    if (!p->v.problem.asks_for_both)
        p->v.n_branches = 1;
    p->on.has_zero_axes = 1;
    for (i = 0; i < sizeof joints / sizeof joints[0]; i++)
        drawn += put_bearing(p, joints[i][0], joints[i][1]);
    if (picture_has_balance(p))
        drawn += put_balance(p);
    return drawn ? NULL : picture_no_rows(p, p->v.branches[0]);
}
