/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_points.c - builds the task of a path or a motion through many positions from values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "card.h"
#include "curve_text.h"
#include "parser.h"
#include "pieces.h"
#include "settings.h"
#include "synthesis.h"
#include "task.h"

#define MOST FOURLINK_POSITIONS_MAX
#define EXACT 3 /* positions that dyads meet */
#define BOX "within (0, 0) mm to (50, 80) mm"

/* A list of its own, which the task points to. */
typedef struct lists {
    fourlink_vector point[MOST];
    double angle[MOST], timing[MOST], weight[MOST];
    unsigned long n, n_angles;
} lists;

/* 1 if a pivot is to be within a box. */
static int is_boxed(const setting *s)
{
    text word = s->value, rest;

    flk_section_split(&word, &rest);
    return flk_text_equal(word, "within");
}

int flk_task_has_points(parser *p)
{
    const setting *positions = flk_task_find(p, KEY_SYNTHESIS_POSITIONS);
    const setting *timing = flk_task_find(p, KEY_SYNTHESIS_TIMING);
    const setting *left = flk_task_find(p, KEY_SYNTHESIS_LEFT);
    const setting *right = flk_task_find(p, KEY_SYNTHESIS_RIGHT);
    int is_path = p->d->synthesis->task == TASK_PATH;
    text rest = positions->value, item;
    int n = 0;

    while (n <= EXACT && flk_piece_item(&rest, &item))
        n++;
    return n > EXACT || flk_curve_text_file(positions->value, NULL) ||
           IS_SET(flk_task_find(p, KEY_SYNTHESIS_WEIGHTS)) ||
           IS_SET(flk_task_find(p, KEY_SYNTHESIS_CRANK_TURNS)) ||
           IS_SET(flk_task_find(p, KEY_SYNTHESIS_ORDER)) ||
           IS_SET(flk_task_find(p, KEY_SYNTHESIS_LENGTHS)) ||
           IS_SET(flk_task_find(p, KEY_SYNTHESIS_LENGTH_RATIO)) || (!is_path && IS_SET(timing)) ||
           flk_text_equal(timing->value, "equal") || is_boxed(left) || is_boxed(right) ||
           (is_path && IS_SET(positions) && (IS_SET(left) || !IS_SET(right) || !IS_SET(timing)));
}

/* ------------------------------------------------------------------------------------- positions */

/* Points from a file with a column for x and one for y. */
static int read_file(parser *p, const setting *s, text name, lists *l)
{
    setting read = *s;
    text before, last;
    size_t i;

    read.n_points = 0;
    read.argument = QUANTITY_LENGTH;
    if (!flk_card_read(p, &read, QUANTITY_LENGTH, name) || !read.curve)
        return 0;
    if (read.n_points > MOST)
        return flk_mistake(p->mistakes, s->place, "the file has %ld positions; at most %ld count",
                           (long)read.n_points, (long)MOST);
    for (i = 0; i < read.n_points; i++) {
        l->point[i].x = read.curve[i].x;
        l->point[i].y = read.curve[i].y[0];
    }
    l->n = (unsigned long)read.n_points;
    if (flk_text_cut_last(s->value, " ", &before, &last))
        flk_task_unit(p, last); /* file curve.csv mm mm */
    return 1;
}

static int read_list_of_points(parser *p, setting *s, lists *l)
{
    text rest = s->value, item, after;

    while (flk_piece_item(&rest, &item)) {
        if (l->n == MOST)
            return flk_mistake(p->mistakes, s->place, "more than %ld positions", (long)MOST);
        if (!flk_task_point(p, s, item, &l->point[l->n], &after))
            return 0;
        if (after.length && !flk_piece_read(p, s, after, QUANTITY_ANGLE, &l->angle[l->n]))
            return 0;
        l->n_angles += after.length > 0;
        l->n++;
    }
    return 1;
}

/* Report what no linkage is needed for: two equal positions, a coupler that only turns. */
static int check_positions(parser *p, const setting *s, const lists *l)
{
    int is_motion = p->d->synthesis->task == TASK_MOTION;
    unsigned long i, j, same = 1;

    if (l->n < EXACT)
        return flk_mistake(p->mistakes, s->place,
                           "expected three positions or more, such as (0, 0) mm, (24, 10) mm, "
                           "(40, 5) mm");
    if (is_motion && l->n_angles < l->n)
        return flk_mistake(
            p->mistakes, s->place,
            "each position needs an angle of the coupler, such as (24, 10) mm -30 deg");
    if (!is_motion && l->n_angles)
        return flk_mistake(p->mistakes, s->place,
                           "a path through more than three points has no angles of the coupler: "
                           "write task = motion, or remove them");
    for (i = 0; i < l->n; i++)
        for (j = 0; j < i; j++) {
            int is_same = l->point[i].x == l->point[j].x && l->point[i].y == l->point[j].y;

            same += is_same && j == 0;
            if (is_same && l->angle[i] == l->angle[j])
                return flk_mistake(p->mistakes, s->place, "positions %ld and %ld are the same",
                                   (long)j + 1, (long)i + 1);
        }
    return same < l->n ||
           flk_mistake(p->mistakes, s->place,
                       "the coupler only turns about a point: no four links are needed for that");
}

static int read_point_lists(parser *p, lists *l)
{
    setting *s = flk_task_find(p, KEY_SYNTHESIS_POSITIONS);
    text name;
    int is_read;

    flk_task_check_lengths(p, 0, "no lengths");
    if (!flk_task_require(p, KEY_SYNTHESIS_POSITIONS, "(0, 0) mm, (24, 10) mm, (40, 5) mm"))
        return 0;
    is_read = flk_curve_text_file(s->value, &name) ? read_file(p, s, name, l)
                                                   : read_list_of_points(p, s, l);
    return is_read && check_positions(p, s, l);
}

/* ---------------------------------------------------------------------------- timing and weights */

static int read_timing(parser *p, lists *l, fourlink_points_task *t)
{
    const setting *s = flk_task_find(p, KEY_SYNTHESIS_TIMING);
    unsigned long i, n;
    double before = 0;

    if (!IS_SET(s))
        return 1;
    t->timing = l->timing;
    if (flk_text_equal(s->value, "equal")) {
        t->either_way = 1;
        for (i = 1; i < l->n; i++)
            l->timing[i - 1] = 2 * M_PI * (double)i / (double)l->n;
        return 1;
    }
    n = flk_task_list(p, KEY_SYNTHESIS_TIMING, QUANTITY_ANGLE, MOST - 1, l->timing);
    if (n != l->n - 1)
        return n > 0
                   ? flk_mistake(p->mistakes, s->place,
                                 "expected %ld rotations of the crank, from the first position to "
                                 "each of the others, not %ld; or 'equal'",
                                 (long)l->n - 1, (long)n)
                   : flk_task_refuse(p, KEY_SYNTHESIS_TIMING,
                                     "rotations of the crank, such as 40 deg, 85 deg, or 'equal'");
    for (i = 0; i < n; before = l->timing[i++])
        if (!((l->timing[i] - before) * l->timing[0] > 0))
            return flk_mistake(p->mistakes, s->place,
                               "the rotations must rise or fall from position to position");
    return 1;
}

static int read_weights_of_points(parser *p, lists *l, fourlink_points_task *t)
{
    const setting *s = flk_task_find(p, KEY_SYNTHESIS_WEIGHTS);
    unsigned long i;

    if (!IS_SET(s))
        return 1;
    t->weight = l->weight;
    if (flk_task_list(p, KEY_SYNTHESIS_WEIGHTS, QUANTITY_NUMBER, MOST, l->weight) != l->n)
        return flk_task_refuse(p, KEY_SYNTHESIS_WEIGHTS, "a weight for each of the positions");
    for (i = 0; i < l->n; i++)
        if (!(l->weight[i] > 0))
            return flk_mistake(p->mistakes, s->place, "a weight must be positive");
    return 1;
}

/* ---------------------------------------------------------------------------------------- pivots */

/* within (0, 0) mm to (50, 80) mm: a box; a unit may stand at its end alone. */
static int read_box(parser *p, setting *s, text box, fourlink_ground *ground)
{
    text first, last, after;

    if (!flk_text_range(box, &first, &last))
        return flk_mistake(p->mistakes, s->place, "expected a box, such as " BOX ", not '%t'",
                           s->value);
    if (!flk_task_point(p, s, last, &ground->high, &after))
        return 0;
    if (first.length && first.start[first.length - 1] == ')') {
        text end = last, corner;

        if (flk_text_split(&end, ')', &corner) && end.start)
            first = flk_text_of(flk_reader_copy(p, first, flk_reader_copy(p, end, "")));
    }
    if (!first.start || !flk_task_point(p, s, first, &ground->low, &after))
        return 0;
    return (ground->low.x <= ground->high.x && ground->low.y <= ground->high.y) ||
           flk_mistake(
               p->mistakes, s->place,
               "the box is empty: expected its lower left corner, then the upper right one, "
               "such as " BOX);
}

static int read_pivot(parser *p, key_code key, fourlink_ground *ground)
{
    setting *s = flk_task_find(p, key);
    text word = s->value, rest, after;

    if (!IS_SET(s))
        return 1;
    if (key == KEY_SYNTHESIS_RIGHT && p->d->machine.mechanism.design.kind == FOURLINK_SLIDER_CRANK)
        return flk_mistake(p->mistakes, s->place,
                           "the line of stroke is found by a search from many starts: remove it");
    flk_section_split(&word, &rest);
    ground->is_given = 1;
    if (flk_text_equal(word, "within"))
        return read_box(p, s, rest, ground);
    if (!flk_text_equal(word, "fixed"))
        return flk_mistake(p->mistakes, s->place,
                           "expected fixed (x, y) mm or " BOX ", not '%t': other choices are those "
                           "of three positions without order, weights and crank_turns",
                           s->value);
    if (!flk_task_point(p, s, rest, &ground->low, &after))
        return 0;
    ground->high = ground->low;
    return !after.length || flk_mistake(p->mistakes, s->place,
                                        "expected one point, such as (24, 10) mm, not '%t'", rest);
}

/* 20 mm to 200 mm, and 5: the longest link to the shortest. */
static int read_bounds(parser *p, fourlink_points_task *task)
{
    const setting *lengths = flk_task_find(p, KEY_SYNTHESIS_LENGTHS),
                  *ratio = flk_task_find(p, KEY_SYNTHESIS_LENGTH_RATIO);
    double range[2];

    if (IS_SET(lengths)) {
        if (!flk_task_range(p, KEY_SYNTHESIS_LENGTHS, QUANTITY_LENGTH, range))
            return 0;
        if (!(range[0] > 0 && range[0] < range[1]))
            return flk_mistake(p->mistakes, lengths->place,
                               "expected the shortest and the longest length, such as "
                               "20 mm to 200 mm, not '%t'",
                               lengths->value);
        task->shortest = range[0];
        task->longest = range[1];
    }
    task->length_ratio = ratio->si[0];
    return !IS_SET(ratio) || ratio->si[0] > 1 ||
           flk_mistake(p->mistakes, ratio->place,
                       "the longest link is longer than the shortest: expected a ratio above 1, "
                       "such as 5");
}

int flk_task_points(parser *p)
{
    deck_synthesis *t = p->d->synthesis;
    fourlink_points_task *task = &t->points;
    const setting *mu_min = flk_task_find(p, KEY_SYNTHESIS_MU_MIN);
    lists *l = flk_reader_keep(p, sizeof *l);

    if (!l)
        return 0;
    memset(l, 0, sizeof *l);
    t->has_points = 1;
    if (!read_point_lists(p, l))
        return 0;
    task->kind = p->d->machine.mechanism.design.kind;
    task->n = l->n;
    task->point = l->point;
    task->angle = t->task == TASK_MOTION ? l->angle : NULL;
    task->may_rock = flk_task_find(p, KEY_SYNTHESIS_CRANK_TURNS)->word;
    task->any_order = flk_task_find(p, KEY_SYNTHESIS_ORDER)->word;
    task->mu_min = IS_SET(mu_min) ? t->mu_min : 0;
    task->effort = p->d->effort;
    task->near = p->d->near;
    if (task->mu_min >= M_PI_2)
        return flk_mistake(p->mistakes, mu_min->place,
                           "a transmission angle is at most 90 deg: expected less, such as 40 deg");
    return read_timing(p, l, task) & read_weights_of_points(p, l, task) & read_bounds(p, task) &
           read_pivot(p, KEY_SYNTHESIS_LEFT, &task->left) &
           read_pivot(p, KEY_SYNTHESIS_RIGHT, &task->right);
}
