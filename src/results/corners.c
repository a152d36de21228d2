/* SPDX-License-Identifier: GPL-3.0-or-later
**
** corners.c - the crank angles at which columns are not smooth: corners of loads, dead positions, change points, jumps of
** friction.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "corners.h"

/* Ends that are closer, in rad, are one. */
#define CLOSEST 1e-9

typedef struct search {
    const flk_corners *c;
    double after; /* rad passed: the next end behind this is wanted */
    double at;    /* the nearest so far, and what it is */
    flk_piece_end end;
} search;

static void offer(search *s, double passed, flk_piece_end end)
{
    double closest = CLOSEST + 1e-14 * passed;

    if (passed <= s->after + closest)
        return;
    if (passed < s->at - closest)
        s->at = passed;
    else if (passed > s->at + closest || end < s->end)
        return;
    s->end = end;
}

/* An end at this crank angle and all that are whole periods away. */
static void offer_angle(search *s, double theta2, double period, flk_piece_end end)
{
    double from = s->c->d->motion.from * s->c->d->motion.angle_unit;
    double passed = s->c->sense * (theta2 - from);

    offer(s, passed + period * ceil((s->after + CLOSEST + 1e-14 * s->after - passed) / period),
          end);
}

static void offer_curve(search *s, const curve *c)
{
    size_t i;

    for (i = 0; i < c->n; i++)
        offer_angle(s, c->x[i], s->c->d->machine.cycle, FLK_END_PLAIN);
}

static void offer_values(search *s, const flk_load_values *values)
{
    offer_curve(s, &values->torque_curve);
    offer_curve(s, &values->force_curve[0]);
}

static void offer_loads(search *s)
{
    const flk_machine *machine = &s->c->d->machine;
    const flk_element *e = flk_machine_find(machine, &flk_gas_sort, 0);
    size_t i;

    if (e)
        offer_curve(s, &((const flk_gas *)e->data)->indicator);
    for (i = 0; (e = flk_machine_find(machine, &flk_own_sort, i)) != NULL; i++) {
        const flk_own_load *own = e->data;

        if (own->over)
            continue; /* jumps.c */
        offer_values(s, &own->back);
        offer_values(s, &own->values);
        if (own->is_windowed) {
            offer_angle(s, own->from, machine->cycle, FLK_END_PLAIN);
            offer_angle(s, own->to, machine->cycle, FLK_END_PLAIN);
        }
    }
}

/* Dead positions are the ends of the reachable ranges; change points are where a range could end, at 0 and
** 180 deg or at +-90 deg, as are the positions that come near to one line. */
static void offer_positions(search *s)
{
    const fourlink_mechanism *mechanism = &s->c->d->machine.mechanism;
    double line = fourlink_slides((int)mechanism->design.kind, FOURLINK_FOLLOWER) ? -M_PI_2 : 0;
    fourlink_reach reach;
    int i;

    fourlink_reach_of(mechanism, &reach);
    for (i = 0; i < reach.n_ranges; i++)
        if (reach.to[i] - reach.from[i] < 2 * M_PI * (1 - 1e-15)) {
            offer_angle(s, reach.from[i], 2 * M_PI, FLK_END_DEAD);
            offer_angle(s, reach.to[i], 2 * M_PI, FLK_END_DEAD);
        }
    offer_angle(s, line, 2 * M_PI, mechanism->change_folded ? FLK_END_CHANGE : FLK_END_PLAIN);
    offer_angle(s, line + M_PI, 2 * M_PI,
                mechanism->change_stretched ? FLK_END_CHANGE : FLK_END_PLAIN);
}

double flk_corners_next(const flk_corners *c, double after, const double *more, size_t n,
                        flk_piece_end *end)
{
    search s;
    size_t i;

    s.c = c;
    s.after = after;
    s.at = GSL_POSINF;
    s.end = FLK_END_NOWHERE;
    if (c->has_loads)
        offer_loads(&s);
    offer_positions(&s);
    for (i = 0; c->has_loads && i < c->jumps->n; i++)
        offer_angle(&s, c->jumps->theta2[i], c->jumps->period, FLK_END_PLAIN);
    for (i = 0; i < n; i++)
        offer(&s, more[i], FLK_END_PLAIN);
    *end = s.end;
    return s.at;
}

flk_piece_end flk_corners_first(const flk_corners *c)
{
    search s;

    s.c = c;
    s.after = -3 * CLOSEST;
    s.at = 2 * CLOSEST;
    s.end = FLK_END_PLAIN;
    offer_positions(&s);
    return s.at > CLOSEST ? FLK_END_PLAIN : s.end;
}
