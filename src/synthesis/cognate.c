/* SPDX-License-Identifier: GPL-3.0-or-later
**
** cognate.c - cognates, by Roberts and Chebyshev: three four-bar linkages trace each coupler curve.
**
** sigma = (P - B) / (C - B) is a constant of the coupler, E = A + sigma (D - A) the third fixed pivot.
**
**             A'  D'  a'            b'            c'            d'            theta2' theta3' theta4'
**    left     A   E   |sigma| b     |sigma| a     |sigma| c     |sigma| d     theta3, theta2, theta4
**    right    E   D   |1-sigma| a   |1-sigma| c   |1-sigma| b   |1-sigma| d   theta2, theta4 + 180 deg,
**                                                                             theta3 + 180 deg
**
** in frames turned by arg sigma and arg(1 - sigma); sigma' = 1 / sigma and sigma / (sigma - 1).
*/
#include <math.h>
#include <stddef.h>

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_math.h>

#include "synthesis.h"

/* Place of the links of a cognate in those of the given linkage. */
static const int source_of[2][5] = {{0, 1, 3, 2, 4}, {0, 1, 2, 4, 3}};

/* The positions of the cognate, from those of the given linkage.  The working range is that of the task, or a
** turn, or the middle of the first range that the given crank reaches. */
static int set_cognate_positions(const fourlink_cognate_task *task,
                                 const fourlink_mechanism *mechanism, fourlink_solution *s)
{
    double from = task->from, to = task->to, margin;
    fourlink_reach reach;
    fourlink_state state;
    fourlink_vector at;
    int j;

    if (from == to) {
        fourlink_reach_of(mechanism, &reach);
        if (!reach.n_ranges)
            return FOURLINK_NOT_REACHED;
        margin = reach.to[0] - reach.from[0] < 2 * M_PI ? (reach.to[0] - reach.from[0]) / 6 : 0;
        from = reach.from[0] + margin;
        to = reach.to[0] - margin;
    }
    s->n_positions = 3;
    for (j = 0; j < 3; j++) {
        fourlink_precision *p = &s->position[j];
        double theta2 = from + (2 * j + 1) * (to - from) / 6;
        int status = fourlink_position(mechanism, task->branch, theta2, &state);

        if (status != FOURLINK_OK)
            return status;
        fourlink_point(&state, FOURLINK_COUPLER, &task->point, &at, NULL, NULL);
        p->point =
            flk_vector_of(gsl_complex_mul(gsl_complex_sub(flk_plane(&at), flk_plane(&s->origin)),
                                          gsl_complex_polar(1, -s->direction)));
        if (task->side == FOURLINK_LEFT) {
            p->theta2 = state.link[3].theta;
            p->theta3 = flk_reduced(theta2);
            p->output = state.link[4].theta;
        } else {
            p->theta2 = theta2;
            p->theta3 = flk_reduced(state.link[4].theta + M_PI);
            p->output = flk_reduced(state.link[3].theta + M_PI);
        }
    }
    if (task->side == FOURLINK_RIGHT) {
        s->from = from;
        s->to = to;
    }
    return FOURLINK_OK;
}

static int check_cognate(const fourlink_cognate_task *task)
{
    if (task->design.kind != FOURLINK_FOUR_BAR)
        return FOURLINK_BAD_KIND;
    if (task->branch != FOURLINK_OPEN && task->branch != FOURLINK_CROSSED)
        return FOURLINK_BAD_BRANCH;
    if (task->side != FOURLINK_LEFT && task->side != FOURLINK_RIGHT)
        return FOURLINK_BAD_CHOICE;
    if (!flk_points_within(&task->point, 1) || !FLK_WITHIN(task->from, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(task->to, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    return FOURLINK_OK;
}

/* The cognate's lengths, place and coupler point. */
static int set_cognate(const fourlink_cognate_task *task, fourlink_solution *s)
{
    const fourlink_link *link = task->design.link;
    gsl_complex one = gsl_complex_rect(1, 0);
    gsl_complex sigma =
        gsl_complex_div_real(flk_plane(&task->point), link[FOURLINK_COUPLER].length);
    gsl_complex rest = gsl_complex_sub(one, sigma);
    int i, is_right = task->side == FOURLINK_RIGHT;
    gsl_complex scale = is_right ? rest : sigma;
    double size = 1 + gsl_complex_abs(sigma);

    if (!(gsl_complex_abs(sigma) > FLK_NOTHING * size) ||
        !(gsl_complex_abs(rest) > FLK_NOTHING * size))
        return FOURLINK_NO_LENGTH;
    s->design.kind = FOURLINK_FOUR_BAR;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        s->design.link[i].length = gsl_complex_abs(scale) * link[source_of[is_right][i]].length;
    s->direction = gsl_complex_arg(scale);
    if (is_right)
        s->origin = flk_vector_of(gsl_complex_mul_real(sigma, link[FOURLINK_GROUND].length));
    s->has_point = 1;
    s->point = flk_vector_of(gsl_complex_mul_real(
        is_right ? gsl_complex_negative(gsl_complex_div(sigma, rest)) : gsl_complex_inverse(sigma),
        s->design.link[FOURLINK_COUPLER].length));
    return FOURLINK_OK;
}

static int find_cognate(const void *data, fourlink_solution *s)
{
    const fourlink_cognate_task *task = data;
    fourlink_mechanism mechanism;
    int status = check_cognate(task);

    if (status == FOURLINK_OK)
        status = fourlink_prepare(&task->design, &mechanism);
    if (status == FOURLINK_OK)
        status = set_cognate(task, s);
    if (status == FOURLINK_OK)
        status = set_cognate_positions(task, &mechanism, s);
    if (status != FOURLINK_OK)
        return status;
    return flk_check_solution(s, task->side == FOURLINK_LEFT ? FLK_EITHER_WAY : FLK_AS_GIVEN);
}

int fourlink_synthesis_cognate(const fourlink_cognate_task *task, unsigned long max,
                               fourlink_solution *solutions, unsigned long *n)
{
    return flk_find_one(find_cognate, task, max, solutions, n);
}
