/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fact.c - what can be said of a deck in single numbers: type, limits, masses, extremes, turning moment.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "extreme.h"
#include "fact.h"
#include "turning.h"

typedef struct teller {
    const deck *d;
    fact_taker *take;
    void *data;
    int branch;
} teller;

static void begin(const teller *t, fact *f, const char *name, const char *meaning)
{
    memset(f, 0, sizeof *f);
    text_copy(text_of(name), f->name, sizeof f->name);
    f->meaning = meaning;
    f->unit = "";
    f->q = QUANTITY_NUMBER;
    f->branch = t->branch;
}

static double in_unit(const teller *t, double si, quantity q)
{
    return unit_from_si(si, t->d->units[q].unit);
}

static void tell(const teller *t, const char *name, double si, quantity q, const char *meaning)
{
    fact f;

    begin(t, &f, name, meaning);
    f.value = in_unit(t, si, q);
    f.q = q;
    f.unit = t->d->units[q].name;
    t->take(&f, t->data);
}

/* A fact with the crank angle at which it occurs. */
static void tell_at(const teller *t, const char *name, double si, quantity q, double theta2,
                    const char *meaning)
{
    fact f;

    begin(t, &f, name, meaning);
    f.value = in_unit(t, si, q);
    f.q = q;
    f.unit = t->d->units[q].name;
    f.has_angle = 1;
    f.theta2 = in_unit(t, theta2, QUANTITY_ANGLE);
    t->take(&f, t->data);
}

static void tell_type(const teller *t)
{
    fourlink_type type = FOURLINK_TYPE_END_;
    fact f;

    fourlink_type_of(&t->d->mechanism, &type);
    begin(t, &f, "type", "by the Grashof condition");
    f.words = fourlink_type_text((int)type);
    t->take(&f, t->data);
}

/* K = (a^2 - b^2 + c^2 + d^2) / 2 (Alvi section 3.1) */
static void tell_freudenstein(const teller *t)
{
    const fourlink_link *link = t->d->design.link;
    double a = link[2].length, b = link[3].length, c = link[4].length, d = link[1].length;

    tell(t, "K", (a * a - b * b + c * c + d * d) / 2, QUANTITY_AREA,
         "(a^2 - b^2 + c^2 + d^2) / 2 of Freudenstein's equation");
}

static void tell_reach(const teller *t)
{
    fourlink_reach reach;
    int i;

    fourlink_reach_of(&t->d->mechanism, &reach);
    for (i = 0; i < reach.n_ranges; i++) {
        tell(t, "theta2_from", reach.from[i], QUANTITY_ANGLE,
             "the links reach from this crank angle");
        tell(t, "theta2_to", reach.to[i], QUANTITY_ANGLE, "the links reach to this crank angle");
    }
}

/* The angles that link 4 can have: by symmetry those of a crank in the linkage read from D to A, with
** the angle 180 deg - theta4. */
static void tell_reach_of_rocker(const teller *t)
{
    fourlink_design mirrored = t->d->design;
    fourlink_mechanism mechanism;
    fourlink_reach reach;
    int i;

    mirrored.link[FOURLINK_CRANK].length = t->d->design.link[FOURLINK_FOLLOWER].length;
    mirrored.link[FOURLINK_FOLLOWER].length = t->d->design.link[FOURLINK_CRANK].length;
    if (fourlink_prepare(&mirrored, &mechanism) != FOURLINK_OK)
        return;
    fourlink_reach_of(&mechanism, &reach);
    for (i = 0; i < reach.n_ranges; i++) {
        tell(t, "theta4_from", M_PI - reach.to[i], QUANTITY_ANGLE, "link 4 can be at this angle");
        tell(t, "theta4_to", M_PI - reach.from[i], QUANTITY_ANGLE, "to this one");
        tell(t, "theta4_swing", reach.to[i] - reach.from[i], QUANTITY_ANGLE, "between them");
    }
}

static void tell_rod(const teller *t)
{
    fourlink_rod rod;

    if (t->d->design.kind != FOURLINK_SLIDER_CRANK ||
        fourlink_rod_masses(&t->d->mechanism, &rod) != FOURLINK_OK)
        return;
    tell(t, "n", rod.n, QUANTITY_NUMBER, "length of the rod / length of the crank");
    if (t->d->design.link[FOURLINK_COUPLER].mass <= 0)
        return;
    tell(t, "k", rod.k, QUANTITY_LENGTH, "radius of gyration of the rod");
    tell(t, "m_a", rod.m_a, QUANTITY_MASS, "part of the rod's mass at the crank pin");
    tell(t, "m_b", rod.m_b, QUANTITY_MASS, "part of the rod's mass at the gudgeon pin");
    if (rod.L == 0)
        return;
    tell(t, "L", rod.L, QUANTITY_LENGTH, "b + k^2/b, equivalent pendulum about the gudgeon pin");
    tell(t, "d", rod.d, QUANTITY_LENGTH, "k^2/b, from the centre of mass to m_d");
    tell(t, "m_d", rod.m_d, QUANTITY_MASS, "of the dynamically true pair, at distance d");
    tell(t, "m_g", rod.m_g, QUANTITY_MASS, "of the dynamically true pair, at the gudgeon pin");
}

static void tell_limits(const teller *t)
{
    fourlink_limits limits;

    fourlink_limits_of(&t->d->mechanism, (fourlink_branch)t->branch, &limits);
    tell(t, "mu_min", limits.mu_min, QUANTITY_ANGLE, "least transmission angle");
    tell(t, "mu_max", limits.mu_max, QUANTITY_ANGLE, "greatest transmission angle");
    if (limits.has_swing) {
        tell_at(t, "theta4_min", limits.theta4_min, QUANTITY_ANGLE, limits.theta2_min,
                "limit of the rocker");
        tell_at(t, "theta4_max", limits.theta4_max, QUANTITY_ANGLE, limits.theta2_max,
                "limit of the rocker");
        tell(t, "swing", limits.theta4_max - limits.theta4_min, QUANTITY_ANGLE,
             "between the limits of the rocker");
        tell(t, "time_ratio", limits.time_ratio, QUANTITY_NUMBER, "of the slow to the quick swing");
    }
    if (limits.has_stroke) {
        tell(t, "stroke", limits.stroke, QUANTITY_LENGTH, "between the dead centres");
        tell(t, "inner_dead_centre", limits.inner, QUANTITY_ANGLE,
             "crank angle with the piston farthest from the crankshaft");
        tell(t, "outer_dead_centre", limits.outer, QUANTITY_ANGLE,
             "crank angle with the piston nearest to the crankshaft");
    }
}

static void tell_extreme(const teller *t, analysis *a, const column *c, int sign)
{
    extreme e;
    fact f;
    extreme_result status = extreme_find(a, c, (fourlink_branch)t->branch, sign, &e);

    if (status == EXTREME_NONE)
        return;
    begin(t, &f, sign > 0 ? "max(" : "min(", sign > 0 ? "greatest value" : "least value");
    strcat(f.name, c->name);
    strcat(f.name, ")");
    f.value = e.value;
    f.q = column_quantity(c);
    f.unit = c->unit;
    f.has_angle = status == EXTREME_FOUND;
    f.theta2 = e.angle;
    if (status == EXTREME_UNBOUNDED)
        f.words = "none: it grows beyond all bounds";
    t->take(&f, t->data);
}

static void tell_turning(const teller *t, analysis *a)
{
    turning m;

    if (!(a->needs & NEED_FORCES) || !turning_find(a, (fourlink_branch)t->branch, &m))
        return;
    tell(t, "mean_torque", m.mean_torque, QUANTITY_TORQUE, "mean of the turning moment -Ts");
    tell(t, "mean_power", m.mean_power, QUANTITY_POWER, "mean torque times speed");
    tell(t, "energy_fluctuation", m.energy_fluctuation, QUANTITY_ENERGY,
         "greatest less least energy of the flywheel in a cycle");
    if (m.has_coefficient)
        tell(t, "energy_coefficient", m.energy_coefficient, QUANTITY_NUMBER,
             "coefficient of fluctuation of energy");
    if (m.inertia > 0) {
        tell(t, "flywheel_inertia", m.inertia, QUANTITY_INERTIA,
             "moment of inertia of the flywheel");
        tell(t, "flywheel_fluctuation", m.fluctuation, QUANTITY_NUMBER,
             "coefficient of fluctuation of speed");
    }
}

void facts_tell(analysis *a, int both_branches, int with_turning, const column_list *columns,
                fact_taker *take, void *data)
{
    teller t;
    int i;
    size_t j;

    t.d = a->d;
    t.take = take;
    t.data = data;
    t.branch = 0;
    tell_type(&t);
    if (t.d->design.kind == FOURLINK_FOUR_BAR)
        tell_freudenstein(&t);
    tell_reach(&t);
    if (t.d->design.kind == FOURLINK_FOUR_BAR)
        tell_reach_of_rocker(&t);
    tell_rod(&t);
    for (i = 0; i < 2; i++) {
        t.branch = i == 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;
        if (!both_branches && (t.branch == FOURLINK_OPEN ? !t.d->open : !t.d->crossed))
            continue;
        tell_limits(&t);
        for (j = 0; columns && j < columns->count; j++)
            if (!column_is_angle_of_crank(&columns->list[j])) {
                tell_extreme(&t, a, &columns->list[j], 1);
                tell_extreme(&t, a, &columns->list[j], -1);
            }
        if (with_turning)
            tell_turning(&t, a);
    }
}
