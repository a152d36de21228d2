/* SPDX-License-Identifier: GPL-3.0-or-later
**
** rows.c - the steps of the moving drawing.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "system/format.h"
#include "base/text.h"
#include "system/memory.h"
#include "rows.h"

#define MOST_ROWS 361
#define FEWEST_STEPS 120 /* in a revolution */

/* ------------------------------------------------------------------------------------------- the steps */

/* In how many parts so many intervals of the deck are divided, to have so many steps as wanted. */
static unsigned long parts_of(unsigned long intervals, double wanted)
{
    static const unsigned long parts[] = {1, 2, 5, 10, 20, 50, 100, 200, 360};
    unsigned long i;

    if (intervals == 0)
        return 1;
    for (i = 0; i < 8; i++)
        if ((double)(intervals * parts[i]) >= wanted || intervals * parts[i + 1] >= MOST_ROWS)
            break;
    return parts[i];
}

/* Insert a crank angle in its place. */
static void insert(rows *t, double at)
{
    double turn = 2 * M_PI / t->v.problem.motion.angle_unit;
    double sign = t->steps[t->n - 1] < t->steps[0] ? -1 : 1;
    unsigned long i;

    for (i = 0; i < t->n; i++)
        if (fabs(t->steps[i] - at) < 1e-9 * turn)
            return;
    for (i = 0; i < t->n && sign * t->steps[i] < sign * at; i++)
        ;
    if (i == 0 || i == t->n)
        return;
    memmove(t->steps + i + 1, t->steps + i, (t->n - i) * sizeof *t->steps);
    t->steps[i] = at;
    t->n++;
}

/* The step from row to row of the deck that is drawn: every row, or every so many of them. */
static unsigned long stride_of(unsigned long n_rows)
{
    unsigned long stride = (n_rows - 1 + MOST_ROWS - 2) / (MOST_ROWS - 1);

    return stride ? stride : 1;
}

static void choose_steps(rows *t, double at)
{
    const fourlink_motion *motion = &t->v.problem.motion;
    unsigned long stride, parts, row, k;
    fourlink_range range;
    fourlink_row here, next;
    double turns;

    for (row = 0; !t->v.problem.over.is_crank_angle && row < t->v.problem.n_rows; row++)
        t->steps[t->n++] = view_place_of_row(&t->v, row);
    if (t->n)
        return;
    fourlink_motion_range(motion, &range);
    stride = stride_of(range.n_rows);
    turns = (double)(range.n_rows - 1) * motion->interval * motion->angle_unit / (2 * M_PI);
    parts = stride > 1 ? 1 : parts_of(range.n_rows - 1, FEWEST_STEPS * GSL_MAX_DBL(turns, 1));
    for (row = 0; row + 1 < range.n_rows; row += stride) {
        fourlink_motion_row(motion, &range, row, &here);
        fourlink_motion_row(motion, &range, row + 1, &next);
        for (k = 0; k < parts; k++)
            t->steps[t->n++] = here.angle + (next.angle - here.angle) * (double)k / (double)parts;
    }
    fourlink_motion_row(motion, &range, range.n_rows - 1, &here);
    t->steps[t->n++] = here.angle;
    if (!gsl_isnan(at))
        insert(t, at);
}

/* The time step of the drawing, with which its deck is opened. */
static double time_step_of(const fourlink_problem *p)
{
    unsigned long stride = stride_of(p->n_rows);

    return stride > 1 ? p->over.step * (double)stride
                      : p->over.step / (double)parts_of(p->n_rows - 1, MOST_ROWS);
}

/* ------------------------------------------------------------------------------------------ all of them */

static int draws_all(const rows *t)
{
    return t->v.problem.n_points <= TRACKS_POINTS && t->v.problem.n_loads <= TRACKS_LOADS &&
           t->v.problem.n_springs <= TRACKS_SPRINGS;
}

/* Open the deck, and with a further assignment unless it is null; 0 without memory or if it has mistakes. */
static int open_deck(rows *t, const fourlink_source *source, fourlink_results *opened,
                     const char *further)
{
    fourlink_mistake mistake;
    int status;

    fourlink_results_free(t->own);
    t->own = NULL;
    status = view_reopen(source, opened, "--report", &further, further != NULL, &t->own, &mistake);
    if (status != FOURLINK_OK)
        return 0;
    view_take(&t->v, t->own);
    return 1;
}

int rows_open(rows *t, const fourlink_source *source, fourlink_results *opened, double at)
{
    char step[VIEW_STEP];

    memset(t, 0, sizeof *t);
    t->source = source;
    if (opened)
        view_take(&t->v, opened);
    if ((!opened || t->v.problem.one_instant) && !open_deck(t, source, opened, NULL))
        return 0;
    if (!draws_all(t))
        return 0;
    if (!t->v.problem.over.is_crank_angle &&
        !open_deck(t, source, opened, view_set_step(&t->v, time_step_of(&t->v.problem), step)))
        return 0;
    if (!view_find_motion(&t->v))
        return 0;
    t->steps = memory_get(MOST_ROWS * 2 + 2, sizeof *t->steps);
    if (t->steps)
        choose_steps(t, at);
    t->status = memory_get(t->n + 1, sizeof *t->status);
    t->table = memory_get(t->n * t->v.n_columns + 1, sizeof *t->table);
    return t->steps && t->status && t->table;
}

void rows_close(rows *t)
{
    fourlink_results_free(t->own);
    free(t->steps);
    free(t->status);
    free(t->table);
}

void rows_thin(rows *t, unsigned long stride, double kept)
{
    unsigned long i, n = 0;

    if (!t->v.problem.over.is_crank_angle)
        return;
    for (i = 0; i < t->n; i++)
        if (i % stride == 0 || t->steps[i] == kept)
            t->steps[n++] = t->steps[i];
    t->n = n;
}

void rows_compute(rows *t, fourlink_branch branch)
{
    unsigned long i;
    double *values;

    t->branch = branch;
    for (i = 0; i < t->n; i++) {
        values = t->table + i * t->v.n_columns;
        t->status[i] = view_find_along(&t->v, branch, view_side_of_row(&t->v, i), t->steps[i],
                                       values, NULL, NULL);
    }
}
