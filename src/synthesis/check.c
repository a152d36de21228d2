/* SPDX-License-Identifier: GPL-3.0-or-later
**
** check.c - the checks of a linkage that synthesis has found.
**
** The equations of synthesis hold on both branches, on both circuits, and in any order of the positions.
** Whether the linkage found can move through them is checked by the analysis: position, reach, type.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "synthesis.h"

/* A position is missed by more than this, relative to the size of the linkage (or in rad): far more than
** rounding makes of a useful linkage, and less than a workshop can see. */
#define MISSED 1e-6

const char *fourlink_defect_text(int defect)
{
    static const char *const names[] = {
        "branch", "circuit", "order", "dead position", "dead position on the way",
        "reach",  "missed"};
    int i;

    for (i = 0; i < (int)(sizeof names / sizeof names[0]); i++)
        if (defect == 1 << i)
            return names[i];
    return "unknown defect";
}

/* 1 if the output is the way of a piston; 0: the angle of link 4. */
static int is_piston(fourlink_kind kind)
{
    return fourlink_slides((int)kind, FOURLINK_FOLLOWER);
}

double flk_output_error(const fourlink_state *state, fourlink_kind kind, double wanted)
{
    return is_piston(kind) ? state->link[4].origin.x - wanted
                           : flk_reduced(state->link[4].theta - wanted);
}

/* `ratio` of the links.  Returns the size of the linkage. */
static double measure_links(fourlink_solution *s)
{
    double longest = 0, shortest = GSL_POSINF;
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (s->design.link[i].length > 0) {
            longest = GSL_MAX_DBL(longest, s->design.link[i].length);
            shortest = GSL_MIN_DBL(shortest, s->design.link[i].length);
        }
    s->ratio = longest / shortest;
    return longest + gsl_hypot(s->point.x, s->point.y);
}

/* Find the branch on which the output is nearer to the wanted one, if it is not known.  Returns defects.
** Least squares have more than three positions and meet none. */
static int place(const fourlink_solution *s, const fourlink_mechanism *mechanism, double size,
                 fourlink_precision *p)
{
    fourlink_state open, crossed, *found = &open;
    fourlink_vector at;
    double off;

    p->branch = 0;
    p->error = p->mu = FLK_UNDEFINED;
    p->status = fourlink_position(mechanism, FOURLINK_OPEN, p->theta2, &open);
    if (p->status == FOURLINK_DEAD_POSITION || p->status == FOURLINK_CHANGE_POINT) {
        p->mu = 0;
        return FOURLINK_DEFECT_DEAD;
    }
    if (p->status != FOURLINK_OK ||
        fourlink_position(mechanism, FOURLINK_CROSSED, p->theta2, &crossed) != FOURLINK_OK)
        return FOURLINK_DEFECT_REACH;
    p->error = flk_output_error(&open, s->design.kind, p->output);
    off = flk_output_error(&crossed, s->design.kind, p->output);
    if (s->branch ? s->branch == FOURLINK_CROSSED : fabs(off) < fabs(p->error)) {
        found = &crossed;
        p->error = off;
    }
    p->branch = found->branch;
    p->mu = found->mu;
    off = fabs(p->error);
    if (is_piston(s->design.kind))
        off /= size;
    if (s->has_point &&
        fourlink_point(found, FOURLINK_COUPLER, &s->point, &at, NULL, NULL) == FOURLINK_OK) {
        p->error = gsl_hypot(at.x - p->point.x, at.y - p->point.y);
        off = GSL_MAX_DBL(off, p->error / size);
    }
    return s->n_positions <= 3 && !(off <= MISSED) ? FOURLINK_DEFECT_MISSED : 0;
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
    double low = GSL_MIN_DBL(from, to), counted = 0;
    int range = range_of(reach, low, &counted);

    return turns_fully(reach) || (reach->n_ranges > 0 && reach->from[range] < counted &&
                                  counted + fabs(to - from) < reach->to[range]);
}

/* 1 if a position and the next are nearer to each other than the linkage comes to them: either may be passed
** first. */
static int is_either_first(const fourlink_precision *p)
{
    return gsl_hypot(p[1].point.x - p->point.x, p[1].point.y - p->point.y) <=
           fabs(p->error) + fabs(p[1].error);
}

/* 1 if the angles rise throughout, or fall, but for positions of which either may be passed first. */
static int is_monotone(const fourlink_solution *s, flk_freedom freedom)
{
    int i, rises = 1, falls = 1;

    for (i = 0; i + 1 < s->n_positions; i++) {
        const fourlink_precision *p = &s->position[i];
        int is_either = freedom == FLK_ABOUT && is_either_first(p);

        rises &= p[1].theta2 > p->theta2 || is_either;
        falls &= p[1].theta2 < p->theta2 || is_either;
    }
    return rises || falls;
}

/* The range of the angles. */
static void measure_angles(const fourlink_solution *s, double *low, double *high)
{
    int i;

    *low = GSL_POSINF;
    *high = GSL_NEGINF;
    for (i = 0; i < s->n_positions; i++) {
        *low = GSL_MIN_DBL(*low, s->position[i].theta2);
        *high = GSL_MAX_DBL(*high, s->position[i].theta2);
    }
}

/* Continue the angles from the first on: counter-clockwise (1), clockwise (-1), or the shorter way (0). */
static void continue_angles(fourlink_solution *s, int sense, flk_freedom freedom)
{
    int i;

    for (i = 0; i + 1 < s->n_positions; i++) {
        fourlink_precision *p = &s->position[i];
        double shorter = flk_cycle_beside(p[1].theta2 - p->theta2, 2 * M_PI);
        int is_shorter = sense * shorter >= 0 || (freedom == FLK_ABOUT && is_either_first(p));

        p[1].theta2 = is_shorter ? p->theta2 + shorter
                                 : flk_cycle_place(p[1].theta2, p->theta2, sense * 2 * M_PI);
    }
}

/* Continue the angles of a crank that turns fully and may run either way: it passes the positions within
** a turn, or their order is another one. */
static void continue_turn(fourlink_solution *s, flk_freedom freedom)
{
    double low, high;
    int i, sense;

    for (sense = 1; sense >= -1; sense -= 2) {
        continue_angles(s, sense, freedom);
        measure_angles(s, &low, &high);
        if (high - low < 2 * M_PI)
            return;
    }
    for (i = 1; i < s->n_positions; i++)
        s->position[i].theta2 =
            flk_cycle_place(s->position[i].theta2, s->position[0].theta2, 2 * M_PI);
}

/* Crank angles along the motion.  A crank that does not turn fully has a single way within its range.  Given
** angles that do not rise or fall may be counted from 0 again after a turn. */
static void find_order(fourlink_solution *s, const fourlink_reach *reach, flk_freedom freedom)
{
    int i;

    if (!freedom && !is_monotone(s, freedom)) {
        continue_angles(s, 0, freedom);
    } else if (freedom && turns_fully(reach)) {
        continue_turn(s, freedom);
    } else if (freedom) {
        for (i = 0; i < s->n_positions; i++)
            range_of(reach, s->position[i].theta2, &s->position[i].theta2);
    }
    s->is_in_order = is_monotone(s, freedom);
    if (!s->is_in_order)
        s->defects |= FOURLINK_DEFECT_ORDER;
}

/* Whether the crank can go from one position to the others.
**
** Circuits: if the crank turns fully, each branch is one; if it has two ranges, each range is one, with both
** branches; if it has one range, there is one circuit.  So the sine at a joint that is not on the shortest
** link keeps its sign on a circuit. */
static int find_way(const fourlink_solution *s, const fourlink_reach *reach)
{
    double low = GSL_POSINF, high = GSL_NEGINF, counted;
    int i, range, first = -1, defects = 0;

    for (i = 0; i < s->n_positions; i++) {
        const fourlink_precision *p = &s->position[i];

        if (!p->branch)
            continue;
        range = range_of(reach, p->theta2, &counted);
        first = first < 0 ? range : first;
        if (range != first)
            defects |= FOURLINK_DEFECT_CIRCUIT;
        if (p->branch != (int)s->branch)
            defects |= FOURLINK_DEFECT_BRANCH |
                       (turns_fully(reach) ? FOURLINK_DEFECT_CIRCUIT : FOURLINK_DEFECT_WAY);
        low = GSL_MIN_DBL(low, p->theta2);
        high = GSL_MAX_DBL(high, p->theta2);
    }
    if (low < high && !has_way(reach, low, high))
        defects |= FOURLINK_DEFECT_WAY;
    return has_way(reach, s->from, s->to) ? defects : defects | FOURLINK_DEFECT_REACH;
}

/* The transmission angle has its extremes over a turn at multiples of 90 deg, for all kinds; in a range it is
** smallest there or at an end.  Angles of a full turn are counted from 0. */
#define ROUNDING 1e-12 /* smaller differences are none */

static void find_transmission(fourlink_solution *s, const fourlink_mechanism *mechanism)
{
    double low = GSL_MIN_DBL(s->from, s->to), high = GSL_MAX_DBL(s->from, s->to);
    fourlink_state state;
    int i;

    s->mu_min = GSL_POSINF;
    for (i = 0; i < s->n_positions; i++)
        if (s->position[i].mu < s->mu_min) { /* it may be NaN */
            s->mu_min = s->position[i].mu;
            s->mu_min_at = s->position[i].theta2;
        }
    s->mu_positions = gsl_finite(s->mu_min) ? s->mu_min : FLK_UNDEFINED;
    for (i = 0; i < 7; i++) { /* the ends, and the multiples in a turn */
        double quarter = M_PI_2 * (floor(low / M_PI_2) + i), mu = 0;
        double theta2 = i == 6 ? high : GSL_MAX_DBL(low, GSL_MIN_DBL(quarter, high));

        if (fourlink_position(mechanism, s->branch, theta2, &state) == FOURLINK_OK)
            mu = state.mu;
        if (mu < s->mu_min * (1 - ROUNDING)) {
            s->mu_min = mu;
            s->mu_min_at = theta2;
        }
    }
    if (high - low >= 2 * M_PI * (1 - ROUNDING))
        s->mu_min_at = flk_cycle_place(s->mu_min_at, 0, 2 * M_PI);
}

/* The working range: the smallest that has all positions and the range that is given, in its sense. */
static void set_range(fourlink_solution *s)
{
    const fourlink_precision *p = s->position;
    int has_range = s->from != s->to;
    double first = has_range ? s->from : p[0].theta2;
    double last = has_range ? s->to : p[s->n_positions - 1].theta2;
    double low, high;

    measure_angles(s, &low, &high);
    low = GSL_MIN_DBL(low, GSL_MIN_DBL(first, last));
    high = GSL_MAX_DBL(high, GSL_MAX_DBL(first, last));
    s->from = first <= last ? low : high;
    s->to = first <= last ? high : low;
}

int flk_check_solution(fourlink_solution *s, flk_freedom freedom)
{
    fourlink_mechanism mechanism;
    fourlink_reach reach;
    double size = measure_links(s);
    int i, first = FOURLINK_OPEN, status = fourlink_prepare(&s->design, &mechanism);

    if (!(size <= FOURLINK_LENGTH_MAX))
        return FOURLINK_INFINITE_LINK;
    if (status != FOURLINK_OK)
        return FOURLINK_NO_LENGTH;
    s->a = s->design.link[FOURLINK_CRANK].length * (s->crank_turn > 0 ? -1 : 1);
    s->c = s->design.link[FOURLINK_FOLLOWER].length * (s->rocker_turn > 0 ? -1 : 1);
    s->condition = GSL_MAX_DBL(s->condition, 1);
    fourlink_type_of(&mechanism, &s->type);
    fourlink_reach_of(&mechanism, &reach);
    s->defects = 0;
    for (i = s->n_positions - 1; i >= 0; i--) {
        s->defects |= place(s, &mechanism, size, &s->position[i]);
        first = s->position[i].branch ? s->position[i].branch : first;
    }
    if (!s->branch)
        s->branch = (fourlink_branch)first;
    find_order(s, &reach, freedom);
    set_range(s);
    s->defects |= find_way(s, &reach);
    find_transmission(s, &mechanism);
    return FOURLINK_OK;
}

flk_sample flk_find_largest(flk_function *f, void *data, double from, double step, int n)
{
    flk_sample p[3], largest = {0, -1};
    int i, at = 0;

    for (i = 0; i <= n; i++) {
        double value = f(from + i * step, data);

        if (value > largest.value) {
            largest.x = from + i * step;
            largest.value = value;
            at = i;
        }
    }
    for (i = 0; i < 3; i++) {
        p[i].x = largest.x + (i - 1) * step;
        p[i].value = f(p[i].x, data);
    }
    return largest.value > 0 && at > 0 && at < n ? flk_find_peak(f, data, p, 1e-16 * largest.value)
                                                 : largest;
}

int flk_find_one(flk_finder *find, const void *task, unsigned long max,
                 fourlink_solution *solutions, unsigned long *n)
{
    fourlink_solution s;
    int status;

    if (!task || !n || (max && !solutions))
        return FOURLINK_NULL;
    memset(&s, 0, sizeof s);
    status = find(task, &s);
    if (status != FOURLINK_OK)
        return status;
    if (max > 0)
        solutions[0] = s;
    *n = 1;
    return FOURLINK_OK;
}
