/* SPDX-License-Identifier: GPL-3.0-or-later
**
** coordinate.c - the coordinates that can be prescribed in place of the crank angle.
**
** The crank angle that belongs to a value follows in closed form from the kind's record; the rates from the very row
** at unit speed, so that near a dead position of the crank all errors are those of one position.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/solve.h"
#include "base/trig.h"
#include "coordinate.h"
#include "mechanism.h"

#define DEAD 1e-7      /* of the crank's length, or of 1: K below it is 0 */
#define SAMPLES 720    /* of a range of crank angles, denser towards its ends */
#define ON_BRANCH 1e-9 /* of the crank's length, or rad: a value found again */
#define END 1e-13      /* of the length of a stretch: what counts as its end */
#define SAME_END 1e-12 /* of the same: what counts as its end over which pieces go */
#define AT_END 1e-5 /* at an end K below this is 0: it grows with the root of the way from there */
#define INSIDE 1e-6 /* rad: what rounding puts beside a stretch, near its ends */
#define LEAST 1e-12 /* of the same: the length of a stretch */

const flk_coordinate flk_coordinates[FLK_COORDINATES] = {
    {"theta4", "\316\270\342\202\204", "theta4", 1,
     FOURLINK_FOUR_BAR | FOURLINK_INVERTED_SLIDER_CRANK, FLK_OF_FOLLOWER, NULL},
    {"x", "x", "x", 0, FOURLINK_SLIDER_CRANK | FOURLINK_SCOTCH_YOKE, FLK_OF_DISPLACEMENT, NULL},
    {"C.x", "C.x", "C.x", 0, FOURLINK_SLIDER_CRANK | FOURLINK_SCOTCH_YOKE, FLK_OF_PIN, NULL},
    {"slide", "slide", "the slide", 0, FOURLINK_INVERTED_SLIDER_CRANK, FLK_OF_SLIDE, NULL}};

void flk_coordinate_of(const flk_coordinate *q, const fourlink_state *state, flk_prescribed *at)
{
    const fourlink_link_state *follower = &state->link[FOURLINK_FOLLOWER];
    flk_actuator_state length = {0, 0, 0, {0, 0}};

    switch (q->what) {
    case FLK_OF_FOLLOWER:
        at->value = flk_angle(follower->axis.y, follower->axis.x);
        at->rate = follower->omega;
        at->second = follower->alpha;
        break;
    case FLK_OF_PIN:
        at->value = follower->origin.x;
        at->rate = follower->velocity.x;
        at->second = follower->acceleration.x;
        break;
    case FLK_OF_DISPLACEMENT:
        at->value = state->x;
        at->rate = state->v;
        at->second = state->a;
        break;
    case FLK_OF_SLIDE:
        at->value = state->slide;
        at->rate = state->slide_v;
        at->second = state->slide_a;
        break;
    default:
        flk_actuator_at(q->actuator, state, &length);
        at->value = length.length;
        at->rate = length.speed;
        at->second = length.acceleration;
        break;
    }
}

void flk_coordinate_set(const flk_coordinate *q, const flk_prescribed *at, fourlink_state *state)
{
    fourlink_link_state *follower = &state->link[FOURLINK_FOLLOWER];
    double sense =
        -(double)state->branch; /* x rises where the pin goes back, but on a crossed branch */

    switch (q->what) {
    case FLK_OF_FOLLOWER:
        follower->theta = -flk_cycle_place(-at->value, -M_PI, 2 * M_PI); /* -pi < theta <= pi */
        follower->omega = at->rate;
        follower->alpha = at->second;
        break;
    case FLK_OF_PIN:
        follower->origin.x = at->value;
        follower->velocity.x = at->rate;
        follower->acceleration.x = at->second;
        state->v = sense * at->rate;
        state->a = sense * at->second;
        break;
    case FLK_OF_DISPLACEMENT:
        state->x = at->value;
        state->v = at->rate;
        state->a = at->second;
        follower->velocity.x = sense * at->rate;
        follower->acceleration.x = sense * at->second;
        break;
    case FLK_OF_SLIDE:
        state->slide = at->value;
        state->slide_v = at->rate;
        state->slide_a = at->second;
        break;
    default: /* an actuator's length is no part of a state */
        break;
    }
}

/* What counts as 1 of a coordinate or of its rate at unit speed. */
static double scale_of(const flk_coordinate *q, const fourlink_mechanism *mechanism)
{
    return q->is_angle ? 1 : mechanism->design.link[FOURLINK_CRANK].length;
}

/* The state at unit crank speed, and with it the value, K and L of a coordinate. */
static int unit_state(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                      fourlink_branch branch, double theta2, flk_prescribed *unit,
                      fourlink_state *state)
{
    fourlink_crank crank = {0, 1, 0};
    int status;

    crank.theta2 = theta2;
    status = flk_mechanism_move(mechanism, branch, &crank, 0, state);
    if (status == FOURLINK_OK)
        flk_coordinate_of(q, state, unit);
    return status;
}

static int at_unit_speed(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                         fourlink_branch branch, double theta2, flk_prescribed *unit)
{
    fourlink_state state;

    return unit_state(q, mechanism, branch, theta2, unit, &state);
}

/* 1 if two values are the same, to rounding. */
static int is_same(const flk_coordinate *q, const fourlink_mechanism *mechanism, double x, double y)
{
    double apart = q->is_angle ? flk_cycle_beside(x - y, 2 * M_PI) : x - y;

    return fabs(apart) <= ON_BRANCH * scale_of(q, mechanism);
}

/* The crank angle of a piston beyond a change point, where its x is still that of the branch b that the mechanism is on:
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

/* The crank angles of a value on a side of a branch, with links 3 and 4 on the side of it or, beyond a change point, of the
** other one; NaN where there is none.  Of an
** actuator of length n from the ground point G to a point P of the crank, gamma is the angle at A of the triangle APG, and
** of one to link 4 that at D:
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

double flk_coordinate_in_turn(const flk_coordinate *q, const flk_stretch *stretch, double theta2,
                              double value)
{
    double turn = 2 * M_PI, n = floor((theta2 - stretch->theta2_from) / turn);

    if (!q->is_angle || !(fabs(stretch->to - stretch->from) > turn * (1 + LEAST)))
        return value;
    return flk_cycle_place(value, stretch->from + turn * (stretch->side > 0 ? n : -n - 1), turn);
}

/* 1 if a value of a stretch of more than one turn is in the same turn as a crank angle; where a turn begins, both are at
** the same distance from the beginning. */
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

/* The crank at an end of a stretch, where there may be no row. */
static int take_end(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                    fourlink_branch branch, const flk_stretch *stretch, double value,
                    double *theta2, flk_prescribed *unit, fourlink_state *state)
{
    int is_first = fabs(value - stretch->from) < fabs(value - stretch->to), status;

    *theta2 = is_first ? stretch->theta2_from : stretch->theta2_to;
    status = unit_state(q, mechanism, branch, *theta2, unit, state);
    if (status == FOURLINK_OK && fabs(unit->rate) < AT_END * scale_of(q, mechanism))
        unit->rate = 0;
    return status;
}

/* The crank angle of a value in a stretch of a branch.  Beyond a change point links 3 and 4 are on the side of the other
** branch, for half a turn or for a whole one.  A place without a row has the status of one of the angles that come into
** question. */
static int find_crank(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                      fourlink_branch branch, const flk_stretch *stretch, double value,
                      double *theta2, flk_prescribed *unit, fourlink_state *state)
{
    int can_change = mechanism->change_stretched || mechanism->change_folded;
    int turns = mechanism->change_stretched != mechanism->change_folded ? 2 : 1, i, k, n;
    int status = FOURLINK_NO_SUCH_ANGLE, tried;
    double list[2], without = GSL_NAN;

    for (i = 0; i < (can_change ? 2 * turns : 1); i++) {
        n = list_cranks(q, mechanism, branch, (fourlink_branch)(i % 2 ? -(int)branch : (int)branch),
                        stretch->side, value, list);
        for (k = 0; k < n; k++) {
            *theta2 = list[k] + (i / 2) * 2 * M_PI;
            if (gsl_isnan(*theta2) || !move_into(stretch, turns * 2 * M_PI, theta2))
                continue;
            tried = unit_state(q, mechanism, branch, *theta2, unit, state);
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

int flk_coordinate_crank_in(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                            fourlink_branch branch, const flk_stretch *stretch,
                            const flk_prescribed *at, fourlink_crank *crank, fourlink_state *state)
{
    flk_prescribed unit;
    int status = find_crank(q, mechanism, branch, stretch, at->value, &crank->theta2, &unit, state);

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
    flk_prescribed unit;
    fourlink_state state;
    int status = find_crank(q, mechanism, branch, stretch, value, &crank->theta2, &unit, &state);
    int is_first = fabs(value - stretch->from) < fabs(value - stretch->to);

    crank->omega2 = crank->alpha2 = 0;
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
    int status = at_unit_speed(q, mechanism, branch, crank->theta2, &unit);

    if (status != FOURLINK_OK)
        return status;
    at->value = unit.value;
    return set_rates(q, mechanism, &unit, at, crank);
}

double flk_coordinate_value(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                            fourlink_branch branch, double theta2)
{
    fourlink_state state;
    flk_prescribed at;

    flk_mechanism_place(mechanism, branch, theta2, &state);
    state.link[FOURLINK_FOLLOWER].omega = state.link[FOURLINK_FOLLOWER].alpha = 0;
    memset(&state.link[FOURLINK_FOLLOWER].velocity, 0, sizeof(fourlink_vector));
    memset(&state.link[FOURLINK_FOLLOWER].acceleration, 0, sizeof(fourlink_vector));
    state.v = state.a = state.slide_v = state.slide_a = 0;
    flk_coordinate_of(q, &state, &at);
    return at.value;
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
        at = q->is_angle ? flk_cycle_place(at, low, 2 * M_PI) : at;
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

/* ------------------------------------------------------------------------------------------------- stretches */

/* K as a function of theta2. */
typedef struct rate_search {
    const flk_coordinate *q;
    const fourlink_mechanism *mechanism;
    fourlink_branch branch;
} rate_search;

static double rate_at(double theta2, void *data)
{
    const rate_search *s = data;
    flk_prescribed unit;

    return at_unit_speed(s->q, s->mechanism, s->branch, theta2, &unit) == FOURLINK_OK ? unit.rate
                                                                                      : GSL_NAN;
}

/* Add a stretch that goes a way, which tells the whole turns of an angle, if it has a length. */
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
    if (s->q->is_angle)
        x->to += 2 * M_PI * flk_cycle_nearest(way - (x->to - x->from), 2 * M_PI);
    return fabs(x->to - x->from) > LEAST * scale_of(s->q, s->mechanism) ? n + 1 : n;
}

/* The stretches of a range of crank angles, sampled where cosines of equal steps are. */
static int add_crank_range(const rate_search *s, double from, double to, flk_stretch *list, int n)
{
    double begin = from, last = 0, before = from, way = 0, x, rate;
    int i;

    for (i = 0; i < SAMPLES; i++) {
        x = from + 0.5 * (to - from) * (1 - flk_cosine(M_PI * (i + 0.5) / SAMPLES));
        rate = rate_at(x, (void *)s);
        if (gsl_isnan(rate))
            continue;
        if (last * rate < 0) {
            flk_bracket b = flk_bracket_of(before, x, last, rate);
            double zero = flk_find_zero(rate_at, (void *)s, &b, 0);

            n = add_stretch(s, begin, zero, way, list, n);
            begin = zero;
            way = 0;
        }
        way += rate * (x - before);
        last = rate == 0 ? last : rate;
        before = x;
    }
    return add_stretch(s, begin, to, way, list, n);
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

int flk_coordinate_stretches(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                             fourlink_branch branch, flk_stretch list[FLK_STRETCHES])
{
    double turn = mechanism->change_stretched != mechanism->change_folded ? 4 * M_PI : 2 * M_PI;
    fourlink_mechanism four = *mechanism;
    fourlink_reach reach;
    rate_search s;
    int i, n = 0;

    four.design.n_groups = 0; /* rows where an output cannot be assembled are told, as of a crank */
    s.q = q;
    s.mechanism = &four;
    s.branch = branch;
    if (fourlink_reach_of(mechanism, &reach) != FOURLINK_OK)
        return 0;
    for (i = 0; i < reach.n_ranges; i++) {
        int is_full = reach.to[i] - reach.from[i] >= 2 * M_PI * (1 - 1e-15);

        n = add_crank_range(&s, reach.from[i], is_full ? reach.from[i] + turn : reach.to[i], list,
                            n);
        if (is_full)
            n = join_ends(q, turn, list, n);
    }
    return n;
}
