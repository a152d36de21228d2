/* SPDX-License-Identifier: GPL-3.0-or-later
**
** coordinate.c - the crank by a coordinate that is prescribed.
**
** The crank angle that belongs to a value follows in closed form from the kind's record, or is searched
** where there is none; the rates from the very row at unit speed, so that near a dead position of the crank
** all errors are those of one position.
*/
#include <math.h>

#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>

#include "base/cycle.h"
#include "base/solve.h"
#include "base/trig.h"
#include "coordinate.h"
#include "group.h"
#include "kind.h"
#include "mechanism.h"

#define DEAD 1e-7      /* of the crank's length, or of 1: K below it is 0 */
#define SAMPLES 720    /* of a range of crank angles, denser towards its ends */
#define ON_BRANCH 1e-9 /* of the crank's length, or rad: a value found again */
#define END 1e-13      /* of the length of a stretch: what counts as its end */
#define SAME_END 1e-12 /* of the same: what counts as its end over which pieces go */
#define AT_END 1e-5 /* at an end K below this is 0: it grows with the root of the way from there */
#define INSIDE 1e-6 /* rad: what rounding puts beside a stretch, near its ends */
#define WHOLE 1e-9  /* of a turn: what a stretch of one may lack */
#define LEAST 1e-12 /* of the same: the length of a stretch */

/* What counts as 1 of a coordinate or of its rate at unit speed. */
static double scale_of(const flk_coordinate *q, const fourlink_mechanism *mechanism)
{
    return q->is_angle ? 1 : mechanism->design.link[FOURLINK_CRANK].length;
}

/* 1 if two values are the same, to rounding. */
static int is_same(const flk_coordinate *q, const fourlink_mechanism *mechanism, double x, double y)
{
    double apart = q->is_angle ? flk_cycle_beside(x - y, 2 * M_PI) : x - y;

    return fabs(apart) <= ON_BRANCH * scale_of(q, mechanism);
}

/* The crank angle of a piston beyond a change point, where its x is still that of the branch b that the
** mechanism is on:
**
**    X = b (x_dc - x)
*/
static double find_beyond(const fourlink_mechanism *mechanism, fourlink_branch branch,
                          fourlink_branch beyond, int side, double x)
{
    return flk_kind_of(mechanism->design.kind)
        ->theta2_of(mechanism, FLK_OF_PIN, beyond, -(int)branch * side,
                    (double)branch * (mechanism->dead_centre - x));
}

/* The crank angles of a value on a side of a branch, with links 3 and 4 on the side of it or, beyond a
** change point, of the other one; NaN where there is none.  Of an actuator of length n from the ground
** point G to a point P of the crank, gamma is the angle at A of the triangle APG, and of one to link 4 that
** at D:
**
**    theta2 = angle of AG - angle of P in the crank's axes +- gamma,   n rises with + gamma
**    theta4 alike about D;                                             it rises with + gamma where theta4 does
*/
static int list_cranks(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                       fourlink_branch branch, fourlink_branch of_links, int side, double value,
                       double theta2[2])
{
    const flk_kind *kind = flk_kind_of(mechanism->design.kind);
    const flk_actuator *x = q->actuator;
    fourlink_vector G, P;
    double p1, p2, gamma, middle;
    int link, k;

    if (!x) {
        theta2[0] = q->what == FLK_OF_DISPLACEMENT && of_links != branch
                        ? find_beyond(mechanism, branch, of_links, side, value)
                        : kind->theta2_of(mechanism, q->what, of_links, side, value);
        return 1;
    }
    link = x->link == FOURLINK_GROUND ? x->to : x->link;
    P = x->link == FOURLINK_GROUND ? x->to_at : x->at;
    G = x->link == FOURLINK_GROUND ? x->at : x->to_at;
    G.x -= link == FOURLINK_CRANK ? 0 : mechanism->design.link[FOURLINK_GROUND].length;
    p1 = flk_length(P.x, P.y);
    p2 = flk_length(G.x, G.y);
    gamma = flk_kind_angle(value, p1, p2, value + p1 - p2);
    middle = flk_angle(G.y, G.x) - flk_angle(P.y, P.x);
    if (link == FOURLINK_CRANK) {
        theta2[0] = middle + side * gamma;
        return 1;
    }
    for (k = 0; k < 2; k++)
        theta2[k] = kind->theta2_of(mechanism, FLK_OF_FOLLOWER, of_links, k ? -side : side,
                                    middle + (k ? -gamma : gamma));
    return 2;
}

static int is_at_end(const flk_stretch *stretch, double value)
{
    double close = END * fabs(stretch->to - stretch->from);

    return fabs(value - stretch->from) <= close || fabs(value - stretch->to) <= close;
}

int flk_coordinate_turns(const flk_coordinate *q, const flk_stretch *stretch)
{
    return q->is_angle &&
           (q->is_searched ? stretch->is_whole
                           : fabs(stretch->to - stretch->from) >= 2 * M_PI * (1 - WHOLE));
}

double flk_coordinate_in_turn(const flk_coordinate *q, const flk_stretch *stretch, double theta2,
                              double value)
{
    double turn = 2 * M_PI, n = floor((theta2 - stretch->theta2_from) / turn);

    if (q->is_searched)
        return q->is_angle ? flk_search_in_turn(stretch, theta2, value) : value;
    if (!q->is_angle || !(fabs(stretch->to - stretch->from) > turn * (1 + LEAST)))
        return value;
    return flk_cycle_place(value, stretch->from + turn * (stretch->side > 0 ? n : -n - 1), turn);
}

/* 1 if a value of a stretch of more than one turn is in the same turn as a crank angle; where a turn
** begins, both are at the same distance from the beginning. */
static int is_in_turn(const flk_coordinate *q, const flk_stretch *stretch, double theta2,
                      double value)
{
    double way = theta2 - stretch->theta2_from;

    if (fabs(flk_cycle_beside(way, 2 * M_PI)) <= INSIDE)
        return !q->is_angle || fabs(stretch->to - stretch->from) <= 2 * M_PI * (1 + LEAST) ||
               fabs(way - fabs(value - stretch->from)) < M_PI;
    return fabs(value - flk_coordinate_in_turn(q, stretch, theta2, value)) < M_PI;
}

/* Move a crank angle by whole periods to where a stretch has it; 0 if that does not. */
static int move_into(const flk_stretch *stretch, double period, double *theta2)
{
    *theta2 = flk_cycle_place(*theta2, stretch->theta2_from - INSIDE, period);
    return *theta2 <= stretch->theta2_to + INSIDE;
}

/* 1 if the groups that move a coordinate have no position at an end of a stretch: they are in a dead
** one, beside which rounding may not assemble them. */
static int is_where_reduced_ends(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                                 fourlink_branch branch, double theta2)
{
    fourlink_mechanism reduced;
    flk_prescribed unit;
    fourlink_state state;

    flk_search_reduce(q, mechanism, &reduced);
    return flk_coordinate_unit_state(q, &reduced, branch, theta2, &unit, &state) != FOURLINK_OK;
}

/* The crank at an end of a stretch, where there may be no row. */
static int take_end(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                    fourlink_branch branch, const flk_stretch *stretch, double value,
                    double *theta2, flk_prescribed *unit, fourlink_state *state)
{
    int is_first = fabs(value - stretch->from) < fabs(value - stretch->to), status;

    *theta2 = is_first ? stretch->theta2_from : stretch->theta2_to;
    status = flk_coordinate_unit_state(q, mechanism, branch, *theta2, unit, state);
    if (status == FOURLINK_OK && fabs(unit->rate) < AT_END * scale_of(q, mechanism))
        unit->rate = 0;
    return status == FOURLINK_GROUP_APART && is_where_reduced_ends(q, mechanism, branch, *theta2)
               ? FOURLINK_DEAD_POSITION
               : status;
}

/* The crank angle of a value in a stretch of a branch.  Beyond a change point links 3 and 4 are on the
** side of the other branch, for half a turn or for a whole one.  A place without a row has the status of
** one of the angles that come into question. */
static int find_crank(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                      fourlink_branch branch, const flk_stretch *stretch, double value,
                      double *theta2, flk_prescribed *unit, fourlink_state *state)
{
    int can_change = mechanism->change_stretched || mechanism->change_folded;
    int turns = mechanism->change_stretched != mechanism->change_folded ? 2 : 1, i, k, n;
    int status = FOURLINK_NO_SUCH_ANGLE, tried;
    double list[2], without = GSL_NAN;

    if (q->is_searched)
        return is_at_end(stretch, value)
                   ? take_end(q, mechanism, branch, stretch, value, theta2, unit, state)
                   : flk_search_crank(q, mechanism, branch, stretch, value, theta2, unit, state);
    for (i = 0; i < (can_change ? 2 * turns : 1); i++) {
        n = list_cranks(q, mechanism, branch, (fourlink_branch)(i % 2 ? -(int)branch : (int)branch),
                        stretch->side, value, list);
        for (k = 0; k < n; k++) {
            *theta2 = list[k] + (i / 2) * 2 * M_PI;
            if (gsl_isnan(*theta2) || !move_into(stretch, turns * 2 * M_PI, theta2))
                continue;
            tried = flk_coordinate_unit_state(q, mechanism, branch, *theta2, unit, state);
            if (tried != FOURLINK_OK) {
                status = tried;
                without = *theta2;
            } else if (is_same(q, mechanism, unit->value, value) &&
                       is_in_turn(q, stretch, *theta2, value)) {
                if (is_at_end(stretch, value) && fabs(unit->rate) < AT_END * scale_of(q, mechanism))
                    unit->rate = 0;
                return FOURLINK_OK;
            }
        }
    }
    if (is_at_end(stretch, value))
        return take_end(q, mechanism, branch, stretch, value, theta2, unit, state);
    *theta2 = gsl_isnan(without) ? *theta2 : without;
    return status;
}

/* The crank's speed and acceleration,
**
**    omega2 = (dq/dt) / K,   alpha2 = (d2q/dt2 - L omega2^2) / K
*/
static int set_rates(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                     const flk_prescribed *unit, const flk_prescribed *at, fourlink_crank *crank)
{
    crank->omega2 = crank->alpha2 = 0;
    if (at->rate == 0 && at->second == 0)
        return FOURLINK_OK;
    if (fabs(unit->rate) < DEAD * scale_of(q, mechanism))
        return FOURLINK_INPUT_DEAD_CENTRE;
    crank->omega2 = at->rate / unit->rate;
    crank->alpha2 = (at->second - unit->second * crank->omega2 * crank->omega2) / unit->rate;
    return FOURLINK_OK;
}

/* With K3 and L3 those of a unit of omega3,
**
**    omega3 = (dq/dt) / K3,   alpha3 = (d2q/dt2 - L3 omega3^2) / K3
*/
int flk_coordinate_swing(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                         fourlink_branch branch, const flk_prescribed *at, double theta2,
                         int angles, fourlink_state *state)
{
    fourlink_crank crank = {0, 0, 0};
    flk_prescribed unit;
    double omega3;
    int status;

    crank.theta2 = theta2;
    if (flk_mechanism_stand(mechanism, branch, &crank, state) != FOURLINK_DEAD_POSITION)
        return FOURLINK_DEAD_POSITION; /* that of an output */
    status = flk_mechanism_swing(mechanism, branch, theta2, 1, 0, 0, state);
    if (status != FOURLINK_OK)
        return status;
    flk_coordinate_of(q, state, &unit);
    if (!(fabs(unit.rate) > DEAD * scale_of(q, mechanism)))
        return FOURLINK_DEAD_POSITION;
    omega3 = at->rate / unit.rate;
    return flk_mechanism_swing(mechanism, branch, theta2, omega3,
                               (at->second - unit.second * omega3 * omega3) / unit.rate, angles,
                               state);
}

/* The crank at a dead position, which it enters or leaves. */
static int take_dead(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                     fourlink_branch branch, const flk_prescribed *at, fourlink_crank *crank,
                     fourlink_state *state)
{
    int status = flk_coordinate_swing(q, mechanism, branch, at, crank->theta2, 0, state);

    crank->omega2 = 0;
    crank->alpha2 = status == FOURLINK_OK ? state->link[FOURLINK_CRANK].alpha : 0;
    return status;
}

int flk_coordinate_crank_in(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                            fourlink_branch branch, const flk_stretch *stretch,
                            const flk_prescribed *at, fourlink_crank *crank, fourlink_state *state)
{
    flk_prescribed unit;
    int status = find_crank(q, mechanism, branch, stretch, at->value, &crank->theta2, &unit, state);

    if (status == FOURLINK_DEAD_POSITION)
        return take_dead(q, mechanism, branch, at, crank, state);
    return status == FOURLINK_OK ? set_rates(q, mechanism, &unit, at, crank) : status;
}

int flk_coordinate_crank(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                         fourlink_branch branch, const flk_stretch *stretch,
                         const flk_prescribed *at, fourlink_crank *crank)
{
    fourlink_state state;

    return flk_coordinate_crank_in(q, mechanism, branch, stretch, at, crank, &state);
}

int flk_coordinate_crank_from_rest(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                                   fourlink_branch branch, const flk_stretch *stretch, double value,
                                   double c, fourlink_crank *crank)
{
    static const flk_prescribed still = {0, 0, 0};
    flk_prescribed unit;
    fourlink_state state;
    int status = find_crank(q, mechanism, branch, stretch, value, &crank->theta2, &unit, &state);
    int is_first = fabs(value - stretch->from) < fabs(value - stretch->to);

    crank->omega2 = crank->alpha2 = 0;
    if (status == FOURLINK_DEAD_POSITION)
        return take_dead(q, mechanism, branch, &still, crank, &state);
    if (status != FOURLINK_OK || fabs(unit.rate) >= DEAD * scale_of(q, mechanism) || c == 0)
        return status;
    if (!(c / unit.second > 0))
        return FOURLINK_INPUT_DEAD_CENTRE;
    crank->alpha2 = (is_first ? 2 : -2) * sqrt(2 * c / unit.second);
    return FOURLINK_OK;
}

int flk_coordinate_crank_at(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                            fourlink_branch branch, flk_prescribed *at, fourlink_crank *crank)
{
    flk_prescribed unit;
    fourlink_state state;
    int status = flk_coordinate_unit_state(q, mechanism, branch, crank->theta2, &unit, &state);

    if (status == FOURLINK_DEAD_POSITION) {
        at->value = flk_coordinate_value(q, mechanism, branch, crank->theta2);
        return take_dead(q, mechanism, branch, at, crank, &state);
    }
    if (status != FOURLINK_OK)
        return status;
    at->value = unit.value;
    return set_rates(q, mechanism, &unit, at, crank);
}

double flk_coordinate_between(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                              fourlink_branch branch, const flk_stretch *stretch, double value)
{
    double from = stretch->theta2_from, to = stretch->theta2_to, middle, at;
    double low = GSL_MIN(stretch->from, stretch->to) - INSIDE;

    for (;;) {
        middle = 0.5 * (from + to);
        if (middle <= from || middle >= to)
            return middle;
        at = flk_coordinate_value(q, mechanism, branch, middle);
        at = q->is_angle && !q->is_searched ? flk_cycle_place(at, low, 2 * M_PI) : at;
        at = flk_coordinate_in_turn(q, stretch, middle, at);
        if ((at < value) == (stretch->side > 0))
            from = middle;
        else
            to = middle;
    }
}

double flk_coordinate_theta2(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                             fourlink_branch branch, const flk_stretch *stretch, double value)
{
    double close = SAME_END * fabs(stretch->to - stretch->from);
    flk_prescribed at = {0, 0, 0};
    fourlink_crank crank;

    at.value = value;
    if (fabs(value - stretch->from) <= close)
        return stretch->theta2_from;
    if (fabs(value - stretch->to) <= close)
        return stretch->theta2_to;
    if (flk_coordinate_crank(q, mechanism, branch, stretch, &at, &crank) != FOURLINK_OK)
        return flk_coordinate_between(q, mechanism, branch, stretch, value);
    return crank.theta2;
}

/* -------------------------------------------------------------------------------------------- stretches */

/* K as a function of theta2. */
typedef struct rate_search {
    const flk_coordinate *q;
    const fourlink_mechanism *mechanism;
    fourlink_branch branch;
    double sign; /* of K beside a dip towards 0 */
} rate_search;

static double rate_at(double theta2, void *data)
{
    const rate_search *s = data;
    fourlink_state state;
    flk_prescribed unit;

    return flk_coordinate_unit_state(s->q, s->mechanism, s->branch, theta2, &unit, &state) ==
                   FOURLINK_OK
               ? unit.rate
               : GSL_NAN;
}

/* Add a stretch that goes a way, which tells the whole turns of an angle, if it has a length; one that
** is searched may have no value at an end. */
static int add_stretch(const rate_search *s, double from, double to, double way, flk_stretch *list,
                       int n)
{
    flk_stretch *x = &list[n];

    if (n == FLK_STRETCHES || !(to > from) || way == 0)
        return n;
    x->theta2_from = from;
    x->theta2_to = to;
    x->side = way > 0 ? FOURLINK_RISING : FOURLINK_FALLING;
    x->from = flk_coordinate_value(s->q, s->mechanism, s->branch, from);
    x->to = flk_coordinate_value(s->q, s->mechanism, s->branch, to);
    x->is_whole = 0;
    if (s->q->is_angle)
        x->to += 2 * M_PI * flk_cycle_nearest(way - (x->to - x->from), 2 * M_PI);
    if (s->q->is_searched && !gsl_finite(x->to - x->from))
        return n + 1;
    return fabs(x->to - x->from) > LEAST * scale_of(s->q, s->mechanism) ? n + 1 : n;
}

/* The stretches of a range as far as it is sampled. */
typedef struct stretches {
    rate_search of;
    flk_stretch *list;
    int n;
    double begin, way; /* of the last one, which goes on */
    flk_sample last;   /* of K, not 0 */
} stretches;

/* Take the next sample of K: between it and the last one a stretch may end. */
static void take_sample(stretches *t, const flk_sample *p)
{
    if (t->last.value * p->value < 0) {
        flk_bracket b = flk_bracket_of(t->last.x, p->x, t->last.value, p->value);
        double zero = flk_find_zero(rate_at, &t->of, &b, 0);

        t->n = add_stretch(&t->of, t->begin, zero, t->way, t->list, t->n);
        t->begin = zero;
        t->way = 0;
    }
    t->way += p->value * (p->x - t->last.x);
    if (p->value != 0)
        t->last.value = p->value;
    t->last.x = p->x;
}

static double nearness_of_rate(double theta2, void *data)
{
    const rate_search *s = data;

    return -s->sign * rate_at(theta2, data);
}

#define NEAR 0.5 /* of a sample: a dip that may pass 0 beside it */

/* Where three samples of K of one sign dip towards 0, the lowest place; it may be beyond 0, between two
** dead centres. */
static int find_dip(stretches *t, const flk_sample p[3], flk_sample *lowest)
{
    double bend = p[0].value - 2 * p[1].value + p[2].value, slope = p[2].value - p[0].value;
    flk_sample turned[3];
    int i;

    t->of.sign = p[1].value > 0 ? 1 : -1;
    if (!(p[0].value * p[1].value > 0 && p[1].value * p[2].value > 0) || !(t->of.sign * bend > 0) ||
        fabs(p[1].value) > fabs(p[0].value) || fabs(p[1].value) > fabs(p[2].value) ||
        !(slope * slope / (8 * fabs(bend)) > NEAR * fabs(p[1].value)))
        return 0;
    for (i = 0; i < 3; i++) {
        turned[i].x = p[i].x;
        turned[i].value = -t->of.sign * p[i].value;
    }
    *lowest = flk_find_peak(nearness_of_rate, &t->of, turned, 0);
    lowest->value *= -t->of.sign;
    return t->of.sign * lowest->value < 0;
}

/* The stretches of a range of crank angles, sampled where cosines of equal steps are. */
static int add_crank_range(const rate_search *s, double from, double to, flk_stretch *list, int n)
{
    flk_sample p[3], lowest;
    stretches t;
    int i;

    t.of = *s;
    t.list = list;
    t.n = n;
    t.begin = t.last.x = from;
    t.way = t.last.value = 0;
    p[0].value = p[1].value = 0;
    for (i = 0; i < SAMPLES; i++) {
        p[2].x = from + 0.5 * (to - from) * (1 - flk_cosine(M_PI * (i + 0.5) / SAMPLES));
        p[2].value = rate_at(p[2].x, &t.of);
        if (gsl_isnan(p[2].value))
            continue;
        if (find_dip(&t, p, &lowest)) {
            t.last = p[0];
            take_sample(&t, &lowest);
        }
        take_sample(&t, &p[2]);
        p[0] = p[1];
        p[1] = p[2];
    }
    return add_stretch(&t.of, t.begin, to, t.way, list, t.n);
}

/* Join the last stretch of a turn to the first, which it continues. */
static int join_ends(const flk_coordinate *q, double turn, flk_stretch *list, int n)
{
    flk_stretch *first = &list[0], *last = &list[n - 1];

    if (n < 2 || first->side != last->side)
        return n;
    first->theta2_from = last->theta2_from - turn;
    if (first->theta2_from + first->theta2_to < 0) { /* its middle is in the first turn */
        first->theta2_from += turn;
        first->theta2_to += turn;
    }
    first->from = q->is_angle ? first->to - first->side * (fabs(first->to - first->from) +
                                                           fabs(last->to - last->from))
                              : last->from;
    return n - 1;
}

/* The stretches of a range of crank angles, which groups that move the coordinate may end and begin again. */
static int add_reach_range(const rate_search *s, double from, double to, int is_turn,
                           flk_stretch *list, int n)
{
    double ends[FLK_GROUPS_ENDS], turn = to - from, begin;
    size_t n_ends = 0, i;
    int first = n;

    if (s->mechanism->design.n_groups)
        n_ends = flk_groups_ends(s->mechanism, s->branch, is_turn ? turn : 2 * M_PI, ends,
                                 FLK_GROUPS_ENDS);
    if (is_turn && n_ends) {
        to = ends[0] + turn;
        from = ends[0];
    }
    for (i = 0; i < n_ends; i++)
        ends[i] = flk_cycle_place(ends[i], from, is_turn ? turn : 2 * M_PI);
    gsl_sort(ends, 1, n_ends);
    for (i = 0, begin = from; i <= n_ends; i++) {
        double end = i < n_ends ? ends[i] : to;

        if (end > begin && end <= to) {
            n = add_crank_range(s, begin, end, list, n);
            begin = end;
        }
    }
    if (is_turn && !n_ends) {
        n = first + join_ends(s->q, turn, list + first, n - first);
        if (n == first + 1)
            list[first].is_whole =
                list[first].theta2_to - list[first].theta2_from >= turn * (1 - WHOLE);
    }
    return n;
}

int flk_coordinate_stretches(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                             fourlink_branch branch, flk_stretch list[FLK_STRETCHES])
{
    double turn = mechanism->change_stretched != mechanism->change_folded ? 4 * M_PI : 2 * M_PI;
    fourlink_mechanism reduced;
    fourlink_reach reach;
    rate_search s;
    int i, n = 0;

    flk_search_reduce(q, mechanism, &reduced); /* rows where another output cannot be assembled are
                                                  told, as of a crank */
    s.q = q;
    s.mechanism = &reduced;
    s.branch = branch;
    if (fourlink_reach_of(mechanism, &reach) != FOURLINK_OK)
        return 0;
    for (i = 0; i < reach.n_ranges; i++) {
        int is_turn = reach.to[i] - reach.from[i] >= 2 * M_PI * (1 - 1e-15);

        n = add_reach_range(&s, reach.from[i], is_turn ? reach.from[i] + turn : reach.to[i],
                            is_turn, list, n);
    }
    for (i = 0; i < n && q->is_searched; i++)
        flk_search_prepare(q, &reduced, branch, &list[i]);
    return n;
}
