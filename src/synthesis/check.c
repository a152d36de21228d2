/* SPDX-License-Identifier: GPL-3.0-or-later
**
** check.c - the checks of a linkage that synthesis has found.
**
** The equations of synthesis hold on both branches, on both circuits, and in any order of the positions.
** Whether the linkage found can move through them is asked of the analysis: position, reach, type.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_math.h>

#include "synthesis.h"

/* What rounding adds to a length, relative to the largest. */
#define ROUNDED 1e-11

/* A position of this branch, and how far it is from the wanted one. */
typedef struct meeting {
    int status;
    fourlink_state state;
    double off; /* rad, m: output minus wanted */
} meeting;

static double output_of(const fourlink_mechanism *mechanism, const fourlink_state *state)
{
    return mechanism->design.kind == FOURLINK_SLIDER_CRANK ? state->link[4].origin.x
                                                           : state->link[4].theta;
}

static void meet(const fourlink_mechanism *mechanism, fourlink_branch branch,
                 const fourlink_precision *wanted, meeting *m)
{
    m->status = fourlink_position(mechanism, branch, wanted->theta2, &m->state);
    if (m->status != FOURLINK_OK)
        return;
    m->off = output_of(mechanism, &m->state) - wanted->output;
    if (mechanism->design.kind != FOURLINK_SLIDER_CRANK)
        m->off = flk_reduced(m->off);
}

/* By the cosine rule, an error of the lengths moves C across the rocker by
**
**    (sum of a da) / (b sin(theta4 - theta3)),
**
** and a point of the coupler by as much as it is farther from B than C is. */
static double rounding_at(const fourlink_solution *s, const fourlink_state *state, double size)
{
    double b = s->design.kind == FOURLINK_INVERTED_SLIDER_CRANK ? s->design.link[1].length
                                                                : s->design.link[3].length;
    double reach = 1 + gsl_hypot(s->point.x, s->point.y) / b;

    return ROUNDED * size * (size / b) * reach / fabs(state->sine);
}

/* Find the branch on which the output is nearer to the wanted one.  Returns defects. */
static int place(fourlink_solution *s, const fourlink_mechanism *mechanism,
                 const flk_request *request, double size, fourlink_precision *p)
{
    static const fourlink_branch branches[2] = {FOURLINK_OPEN, FOURLINK_CROSSED};
    meeting m[2];
    const meeting *found;
    double tolerance, missed;
    int i;

    for (i = 0; i < 2; i++)
        meet(mechanism, branches[i], p, &m[i]);
    p->branch = 0;
    p->error = p->mu = FLK_UNDEFINED;
    p->status = m[0].status;
    if (m[0].status == FOURLINK_DEAD_POSITION || m[0].status == FOURLINK_CHANGE_POINT) {
        p->mu = 0;
        return FOURLINK_DEFECT_DEAD;
    }
    if (m[0].status != FOURLINK_OK)
        return FOURLINK_DEFECT_REACH;
    i = fabs(m[1].off) < fabs(m[0].off);
    found = &m[i];
    p->branch = branches[i];
    p->mu = found->state.mu;
    p->error = found->off;
    tolerance = rounding_at(s, &found->state, size);
    missed = fabs(found->off);
    if (s->design.kind != FOURLINK_SLIDER_CRANK)
        missed *= s->design.kind == FOURLINK_FOUR_BAR ? fabs(s->c) : size;
    if (request->is_traced) {
        fourlink_vector at;

        if (fourlink_point(&found->state, FOURLINK_COUPLER, &s->point, &at, NULL, NULL) !=
            FOURLINK_OK)
            return FOURLINK_DEFECT_MISSED;
        p->error = gsl_hypot(at.x - p->point.x, at.y - p->point.y);
        missed = GSL_MAX_DBL(fabs(missed), p->error);
    }
    return request->is_exact && !(fabs(missed) <= tolerance) ? FOURLINK_DEFECT_MISSED : 0;
}

/* The range of the reach that an angle is in, and the angle as the range counts it. */
static int range_of(const fourlink_reach *reach, double theta2, double *counted)
{
    double nearest = GSL_POSINF;
    int i, range = 0;

    for (i = 0; i < reach->n_ranges; i++) {
        double middle = 0.5 * (reach->from[i] + reach->to[i]);
        double off = flk_reduced(theta2 - middle);

        if (fabs(off) < nearest) {
            nearest = fabs(off);
            range = i;
            *counted = middle + off;
        }
    }
    return range;
}

static int turns_fully(const fourlink_reach *reach)
{
    return reach->n_ranges == 1 && reach->to[0] - reach->from[0] >= 2 * M_PI;
}

/* 1 if the crank can go from one angle to the other. */
static int has_way(const fourlink_reach *reach, double from, double to)
{
    double low = GSL_MIN_DBL(from, to), high = GSL_MAX_DBL(from, to), counted = 0;
    int range;

    if (turns_fully(reach))
        return 1;
    if (!reach->n_ranges || !(high - low < 2 * M_PI))
        return 0;
    range = range_of(reach, 0.5 * (low + high), &counted);
    return reach->from[range] < counted - 0.5 * (high - low) &&
           counted + 0.5 * (high - low) < reach->to[range];
}

/* 1 if the angles rise throughout, or fall. */
static int is_monotone(const fourlink_solution *s)
{
    int i, rises = 1, falls = 1;

    for (i = 1; i < s->n_positions; i++) {
        rises &= s->position[i].theta2 > s->position[i - 1].theta2;
        falls &= s->position[i].theta2 < s->position[i - 1].theta2;
    }
    return rises || falls;
}

/* Continue the angles from the first on: counter-clockwise (1), clockwise (-1), or the shorter way (0). */
static void continue_angles(fourlink_solution *s, int sense)
{
    int i;

    for (i = 1; i < s->n_positions; i++) {
        double from = s->position[i - 1].theta2, step = flk_reduced(s->position[i].theta2 - from);

        if (sense * step < 0)
            step += sense * 2 * M_PI;
        s->position[i].theta2 = from + step;
    }
}

/* Crank angles along the motion.  A crank that turns fully and may run either way passes three positions in
** one sense within a turn.  One that does not has a single way within its range. */
static int find_order(fourlink_solution *s, const fourlink_reach *reach, int is_free)
{
    fourlink_precision *p = s->position;
    int i, last = s->n_positions - 1;

    if (is_free && turns_fully(reach)) {
        continue_angles(s, 1);
        if (!(p[last].theta2 - p[0].theta2 < 2 * M_PI))
            continue_angles(s, -1);
    } else if (is_free && reach->n_ranges) {
        for (i = 0; i <= last; i++)
            range_of(reach, p[i].theta2, &p[i].theta2);
    } else if (!is_monotone(s)) {
        double given[FOURLINK_PRECISION_MAX];

        for (i = 0; i <= last; i++)
            given[i] = p[i].theta2;
        continue_angles(s, 0);
        for (i = 0; !is_monotone(s) && i <= last; i++)
            p[i].theta2 = given[i];
    }
    return is_monotone(s) ? 0 : FOURLINK_DEFECT_ORDER;
}

/* Circuits: if the crank turns fully, each branch is one; if it has two ranges, each range is one, with both
** branches; if it has one range, there is one circuit.  This is the rule that the sine at a joint which is not
** on the shortest link keeps its sign. */
static int find_circuits(const fourlink_solution *s, const fourlink_reach *reach)
{
    int i, first = -1, defects = 0;
    double counted;

    for (i = 0; i < s->n_positions; i++) {
        const fourlink_precision *p = &s->position[i];

        if (!p->branch)
            continue;
        if (first < 0)
            first = i;
        if (p->branch != s->position[first].branch)
            defects |= FOURLINK_DEFECT_BRANCH |
                       (turns_fully(reach) ? FOURLINK_DEFECT_CIRCUIT : FOURLINK_DEFECT_WAY);
        if (range_of(reach, p->theta2, &counted) !=
            range_of(reach, s->position[first].theta2, &counted))
            defects |= FOURLINK_DEFECT_CIRCUIT;
    }
    return defects;
}

static int find_way(const fourlink_solution *s, const fourlink_reach *reach)
{
    double low = GSL_POSINF, high = GSL_NEGINF;
    int i, defects = 0;

    for (i = 0; i < s->n_positions; i++)
        if (s->position[i].branch) {
            low = GSL_MIN_DBL(low, s->position[i].theta2);
            high = GSL_MAX_DBL(high, s->position[i].theta2);
        }
    if (low < high && !has_way(reach, low, high))
        defects |= FOURLINK_DEFECT_WAY;
    if (!has_way(reach, s->from, s->to))
        defects |= FOURLINK_DEFECT_REACH;
    return defects;
}

/* The transmission angle has its extremes over a turn at multiples of 90 deg, for all kinds.  In a range it is
** smallest there or at an end. */
static void find_transmission(fourlink_solution *s, const fourlink_mechanism *mechanism)
{
    double low = GSL_MIN_DBL(s->from, s->to), high = GSL_MAX_DBL(s->from, s->to), next;
    fourlink_state state;
    int i, n = 0;

    s->mu_positions = FLK_UNDEFINED;
    for (i = 0; i < s->n_positions; i++)
        if (!(s->position[i].mu >= s->mu_positions))
            s->mu_positions = s->position[i].mu;
    s->mu_min = GSL_POSINF;
    next = low;
    while (s->mu_min > 0 && n++ < 7) {
        double mu =
            fourlink_position(mechanism, s->branch, next, &state) == FOURLINK_OK ? state.mu : 0;

        if (mu < s->mu_min) {
            s->mu_min = mu;
            s->mu_min_at = next;
        }
        if (next >= high)
            break;
        next = M_PI_2 * (floor(next / M_PI_2 + 1e-9) + 1);
        next = GSL_MIN_DBL(next, high);
    }
}

static double largest_length(const fourlink_solution *s)
{
    double largest = GSL_MAX_DBL(fabs(s->design.offset), gsl_hypot(s->point.x, s->point.y));
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        largest = GSL_MAX_DBL(largest, s->design.link[i].length);
    return largest;
}

static double ratio_of(const fourlink_design *design)
{
    double longest = 0, shortest = GSL_POSINF;
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (design->link[i].length > 0) {
            longest = GSL_MAX_DBL(longest, design->link[i].length);
            shortest = GSL_MIN_DBL(shortest, design->link[i].length);
        }
    return longest / shortest;
}

int flk_check_solution(fourlink_solution *s, const flk_request *request)
{
    fourlink_mechanism mechanism;
    fourlink_reach reach;
    double size = GSL_MAX_DBL(request->size, largest_length(s));
    int i, has_range = s->from != s->to, status = fourlink_prepare(&s->design, &mechanism);

    if (!(size <= FOURLINK_LENGTH_MAX))
        return FOURLINK_INFINITE_LINK;
    if (status != FOURLINK_OK)
        return FOURLINK_NO_LENGTH;
    fourlink_type_of(&mechanism, &s->type);
    fourlink_reach_of(&mechanism, &reach);
    s->ratio = ratio_of(&s->design);
    s->defects = 0;
    s->branch = FOURLINK_OPEN;
    for (i = s->n_positions - 1; i >= 0; i--) {
        s->defects |= place(s, &mechanism, request, size, &s->position[i]);
        if (s->position[i].branch)
            s->branch = (fourlink_branch)s->position[i].branch;
    }
    s->defects |= find_order(s, &reach, request->is_free);
    if (!has_range) {
        s->from = s->position[0].theta2;
        s->to = s->position[s->n_positions - 1].theta2;
    }
    s->defects |= find_circuits(s, &reach) | find_way(s, &reach);
    find_transmission(s, &mechanism);
    return FOURLINK_OK;
}

int flk_return_solution(const fourlink_solution *s, unsigned long max, fourlink_solution *solutions,
                        unsigned long *n)
{
    if (max > 0)
        solutions[0] = *s;
    *n = 1;
    return FOURLINK_OK;
}
