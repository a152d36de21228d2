/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fact.c - facts of a deck, which are single values: type, limits, masses, extremes, turning moment.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/trig.h"
#include "deck/synthesis.h"
#include "fact.h"
#include "indicated.h"
#include "mean.h"
#include "mechanics/group_limits.h"
#include "mechanics/kind.h"

/* name, quantity, group, meaning */
#define FACT_LIST(X)                                                                               \
    X(TYPE, "type", NUMBER, LIMITS, "type of the linkage, by Grashof")                             \
    X(FREUDENSTEIN, "K", AREA, LIMITS, "Freudenstein's (a^2-b^2+c^2+d^2)/2")                       \
    X(THETA2_FROM, "theta2_from", ANGLE, LIMITS, "first crank angle that can be reached")          \
    X(THETA2_TO, "theta2_to", ANGLE, LIMITS, "last crank angle that can be reached")               \
    X(THETA4_FROM, "theta4_from", ANGLE, LIMITS, "first angle that link 4 can have")               \
    X(THETA4_TO, "theta4_to", ANGLE, LIMITS, "last angle that link 4 can have")                    \
    X(THETA4_SWING, "theta4_swing", ANGLE, LIMITS, "angle between these")                          \
    X(ROD_RATIO, "n", NUMBER, LIMITS, "length of rod / length of crank")                           \
    X(ROD_GYRATION, "k", LENGTH, LIMITS, "radius of gyration of the rod")                          \
    X(PAIR_GYRATION, "k1", LENGTH, LIMITS, "of m_a and m_b: k1^2 = b (l - b)")                     \
    X(M_A, "m_a", MASS, LIMITS, "the rod's mass at the crank pin")                                 \
    X(M_B, "m_b", MASS, LIMITS, "the rod's mass at the gudgeon pin")                               \
    X(ROD_PENDULUM, "L", LENGTH, LIMITS, "b + k^2/b, the equivalent pendulum")                     \
    X(ROD_DISTANCE, "d", LENGTH, LIMITS, "k^2/b, from the centre of mass to m_d")                  \
    X(M_D, "m_d", MASS, LIMITS, "mass of the equivalent pair, at d")                               \
    X(M_G, "m_g", MASS, LIMITS, "mass of that pair at the gudgeon pin")                            \
    X(MU_MIN, "mu_min", ANGLE, LIMITS, "smallest transmission angle, acute")                       \
    X(MU_MAX, "mu_max", ANGLE, LIMITS, "largest transmission angle, acute")                        \
    X(GAMMA_MIN, "gamma_min", ANGLE, LIMITS, "smallest angle between links 3 and 4")               \
    X(GAMMA_MAX, "gamma_max", ANGLE, LIMITS, "largest angle between links 3 and 4")                \
    X(THETA4_MIN, "theta4_min", ANGLE, LIMITS, "smallest theta4")                                  \
    X(THETA4_MAX, "theta4_max", ANGLE, LIMITS, "largest theta4")                                   \
    X(SWING, "swing", ANGLE, LIMITS, "swing of link 4, between these")                             \
    X(TIME_RATIO, "time_ratio", NUMBER, LIMITS, "time ratio, slow swing or stroke to quick one")   \
    X(STROKE, "stroke", LENGTH, LIMITS, "distance between the dead centres")                       \
    X(INNER_DEAD_CENTRE, "inner_dead_centre", ANGLE, LIMITS, "farthest from the crankshaft")       \
    X(OUTER_DEAD_CENTRE, "outer_dead_centre", ANGLE, LIMITS, "nearest to the crankshaft")          \
    X(SLIDE_MIN, "slide_min", LENGTH, LIMITS, "smallest slide: one end of the slot")               \
    X(SLIDE_MAX, "slide_max", LENGTH, LIMITS, "largest slide: the other end")                      \
    X(DISPLACEMENT, "displacement", VOLUME, LIMITS, "swept by the piston in a stroke")             \
    X(COMPRESSION_RATIO, "compression_ratio", NUMBER, LIMITS, "largest volume / smallest")         \
    X(BALANCE_CRANK, "balance_crank", MASS_MOMENT, LIMITS, "mass moment of its counterweight")     \
    X(BALANCE_CRANK_ANGLE, "balance_crank_angle", ANGLE, LIMITS, "its direction, from the crank")  \
    X(BALANCE_MASS, "balance_mass", MASS, LIMITS, "mass of the crank's counterweight")             \
    X(BALANCE_ROCKER, "balance_rocker", MASS_MOMENT, LIMITS, "mass moment of that of link 4")      \
    X(BALANCE_ROCKER_ANGLE, "balance_rocker_angle", ANGLE, LIMITS, "its direction, from link 4")   \
    X(BALANCE_ROCKER_MASS, "balance_rocker_mass", MASS, LIMITS, "mass of that of link 4")          \
    X(GROUND_LENGTH, "ground_length", LENGTH, LIMITS, "of --synthesis: length of the ground")      \
    X(CRANK_LENGTH, "crank_length", LENGTH, LIMITS, "of the crank")                                \
    X(COUPLER_LENGTH, "coupler_length", LENGTH, LIMITS, "of the coupler or rod")                   \
    X(ROCKER_LENGTH, "rocker_length", LENGTH, LIMITS, "of the rocker or lever")                    \
    X(LINE_OFFSET, "line_offset", LENGTH, LIMITS, "offset of the line of stroke or of the lever")  \
    X(MU_RANGE, "mu_range", ANGLE, LIMITS, "smallest transmission angle in the working range")     \
    X(ERROR_ANGLE, "theta4_error", ANGLE, LIMITS, "largest structural error")                      \
    X(ERROR_LENGTH, "x_error", LENGTH, LIMITS, "largest structural error")                         \
    X(PATH_ERROR, "path_error", LENGTH, LIMITS, "of many points: root mean square distance")       \
    X(PATH_ERROR_MAX, "path_error_max", LENGTH, LIMITS, "largest distance")                        \
    X(COUPLER_ERROR, "coupler_error", ANGLE, LIMITS, "largest error of the coupler's angle")       \
    X(DEFECTS, "defects", NUMBER, LIMITS, "of the linkage found; 0: none")                         \
    X(EFFICIENCY_CYCLE, "efficiency_cycle", NUMBER, TURNING, "efficiency over a cycle")            \
    X(MEAN_TORQUE, "mean_torque", TORQUE, TURNING, "mean of the turning moment -Ts")               \
    X(MEAN_POWER, "mean_power", POWER, TURNING, "mean power, mean torque times speed")             \
    X(ENERGY_FLUCTUATION, "energy_fluctuation", ENERGY, TURNING,                                   \
      "fluctuation of energy in a cycle")                                                          \
    X(ENERGY_COEFFICIENT, "energy_coefficient", NUMBER, TURNING,                                   \
      "coefficient of fluctuation of energy")                                                      \
    X(FLYWHEEL_INERTIA, "flywheel_inertia", INERTIA, TURNING, "moment of inertia of the flywheel") \
    X(FLYWHEEL_FLUCTUATION, "flywheel_fluctuation", NUMBER, TURNING,                               \
      "coefficient of fluctuation of speed")                                                       \
    X(INDICATED_WORK, "indicated_work", ENERGY, TURNING,                                           \
      "of the gas in a cycle: area of p over V")                                                   \
    X(INDICATED_POWER, "indicated_power", POWER, TURNING, "indicated_work / duration of a cycle")  \
    X(MEAN_EFFECTIVE, "mep", PRESSURE, TURNING, "indicated_work / displacement")                   \
    X(MEAN_SPEED, "mean_speed", ANGULAR_SPEED, MOTION, "mean over time, of the steady motion")     \
    X(MEAN_SPEED_TEXTBOOK, "mean_speed_textbook", ANGULAR_SPEED, MOTION,                           \
      "steady: (largest + smallest speed) / 2")                                                    \
    X(PERIOD, "period", TIME, MOTION, "duration of its cycle")                                     \
    X(FLUCTUATION_EXACT, "fluctuation_exact", NUMBER, MOTION,                                      \
      "steady: (largest - smallest speed) / mean")                                                 \
    X(STEADY_RATE, "steady_rate", NUMBER, MOTION, "what a cycle leaves of a difference")           \
    X(STALL_ANGLE, "stall_angle", ANGLE, MOTION, "where the machine comes to rest")                \
    X(RUN_UP_TIME, "run_up_time", TIME, MOTION, "until omega2 is the steady mean speed")           \
    X(MOTOR_TORQUE, "motor_torque", TORQUE, MOTION, "of a motor that balances, at the crank")

#define FACT_CODE(code, name, q, group, meaning) FACT_##code,
typedef enum fact_code { FACT_LIST(FACT_CODE) FACT_COUNT } fact_code;

#define FACT_INFO(code, name, q, group, meaning) \
    {name, QUANTITY_##q, FOURLINK_FACTS_##group, meaning},
static const struct {
    const char *name;
    quantity q;
    int group; /* FOURLINK_FACTS_LIMITS ... */
    const char *meaning;
} fact_table[] = {FACT_LIST(FACT_INFO)};

/* The meanings in a free motion, which need not be steady. */
static const struct {
    fact_code code;
    const char *meaning;
} meanings_if_free[] = {
    {FACT_MEAN_SPEED, "mean over time, of the last cycle"},
    {FACT_MEAN_SPEED_TEXTBOOK, "(largest + smallest speed) / 2"},
    {FACT_PERIOD, "duration of that cycle"},
    {FACT_FLUCTUATION_EXACT, "(max - min speed) / mean_speed"},
};

static const char *meaning_of(const deck *d, fact_code code)
{
    size_t i;

    for (i = 0; i < sizeof meanings_if_free / sizeof meanings_if_free[0]; i++)
        if (d->mode.kind == MODE_FREE && meanings_if_free[i].code == code)
            return meanings_if_free[i].meaning;
    return fact_table[code].meaning;
}

/* The handle of a fact, or the fact of a handle. */
#define OTHER(i) (-1 - (int)(i))

/* Facts of outputs stand behind those of the table: fact k of output i. */
#define OF_OUTPUT(i, k) (FACT_COUNT + OUTPUT_FACTS * (i) + (k))
#define MOST_FACTS OF_OUTPUT(FOURLINK_MOST_GROUPS, 0)
#define OUTPUT_OF(code) (((code)-FACT_COUNT) / OUTPUT_FACTS)
#define FACT_OF_OUTPUT(code) (((code)-FACT_COUNT) % OUTPUT_FACTS)

#define OUTPUT_FACT_INFO(code, slider, rocker, q, q_rocker, meaning, meaning_rocker) \
    {{QUANTITY_##q, QUANTITY_##q_rocker}, {meaning, meaning_rocker}},
static const struct {
    quantity q[2]; /* of a slider, of a rocker */
    const char *meaning[2];
} output_facts[] = {OUTPUT_FACT_LIST(OUTPUT_FACT_INFO)};

int flk_fact_find(const deck *d, text name)
{
    int i, k;

    for (i = 0; i < FACT_COUNT; i++)
        if (flk_text_same(name, fact_table[i].name))
            return OTHER(i);
    for (i = 0; d && i < d->machine.mechanism.design.n_groups; i++)
        for (k = 0; k < OUTPUT_FACTS; k++)
            if (flk_text_same(name, d->outputs[i].fact_names[k]))
                return OTHER(OF_OUTPUT(i, k));
    return 0;
}

int flk_fact_is_there(const deck *d, int handle)
{
    return OTHER(handle) < OF_OUTPUT(d->machine.mechanism.design.n_groups, 0);
}

int flk_fact_group(int handle)
{
    return handle >= 0 || handle < -MOST_FACTS ? 0
           : handle >= -FACT_COUNT             ? fact_table[OTHER(handle)].group
                                               : FOURLINK_FACTS_LIMITS;
}

const char *flk_fact_nearest(const deck *d, text name)
{
    const char *known[MOST_FACTS + 1];
    int i, n = OF_OUTPUT(d->machine.mechanism.design.n_groups, 0);

    for (i = 0; i < n; i++)
        known[i] = i < FACT_COUNT ? fact_table[i].name
                                  : d->outputs[OUTPUT_OF(i)].fact_names[FACT_OF_OUTPUT(i)];
    known[n] = NULL;
    return flk_text_nearest(name, known);
}

/* 1 if a fact of an output is that of a rocker, 0: of a slider. */
static int is_of_rocker(const deck *d, int code)
{
    return d->groups[OUTPUT_OF(code)].end == FOURLINK_GROUP_TURNS;
}

static quantity quantity_of(const deck *d, int code)
{
    return code < FACT_COUNT ? fact_table[code].q
                             : output_facts[FACT_OF_OUTPUT(code)].q[is_of_rocker(d, code)];
}

void flk_fact_describe(const deck *d, int handle, fourlink_value *f)
{
    int code = OTHER(handle), i = OUTPUT_OF(code), k = FACT_OF_OUTPUT(code);

    if (code < FACT_COUNT) {
        flk_list_describe(d, quantity_of(d, code), meaning_of(d, (fact_code)code), f);
        f->name = fact_table[code].name;
    } else {
        flk_list_describe(d, quantity_of(d, code), output_facts[k].meaning[is_of_rocker(d, code)],
                          f);
        f->name = d->outputs[i].fact_names[k];
    }
    f->handle = handle;
}

/* The facts listed so far. */
typedef struct listing {
    const deck *d;
    int branch;
    int only; /* the handle of the facts to list; 0: all */
    fourlink_value *list;
    unsigned long n;
} listing;

static double in_unit(const listing *t, double si, quantity q)
{
    return flk_unit_from_si(si, t->d->units[q].unit);
}

static int is_any_wanted(const listing *t, int first, int last)
{
    return !t->only || (t->only <= OTHER(first) && t->only >= OTHER(last));
}

/* Returns the slot to fill; it is reused if the fact is not listed. */
static fourlink_value *add_fact(listing *t, int code, double si)
{
    fourlink_value *f = &t->list[t->n];

    if (!is_any_wanted(t, code, code))
        return f;
    t->n++;
    flk_fact_describe(t->d, OTHER(code), f);
    f->value = in_unit(t, si, quantity_of(t->d, code));
    f->branch = t->branch;
    return f;
}

/* An angle from x of link 1, in the axes of the deck, from 0 to a turn. */
static double on_page(const listing *t, double angle)
{
    return t->d->axes.is_page ? flk_cycle_place(angle + t->d->axes.angle, 0, 2 * M_PI) : angle;
}

/* What a range of such angles is turned by; 0 for a whole turn. */
static double turn_of_range(const listing *t, double from, double to)
{
    return t->d->axes.is_page && to - from < 2 * M_PI - 1e-9
               ? flk_deck_direction(t->d, flk_cycle_beside(from, 2 * M_PI)) - from
               : 0;
}

/* A fact with the crank angle at which it occurs. */
static void add_at(listing *t, int code, double si, double theta2)
{
    fourlink_value *f = add_fact(t, code, si);

    f->has_angle = 1;
    f->angle = in_unit(t, on_page(t, theta2), QUANTITY_ANGLE);
}

static void add_type(listing *t)
{
    fourlink_type type = FOURLINK_TYPE_END_;
    fourlink_value *f;

    fourlink_type_of(&t->d->machine.mechanism, &type);
    f = add_fact(t, FACT_TYPE, (double)type);
    f->words = fourlink_type_text((int)type);
    f->unit = "";
}

static void add_reach(listing *t)
{
    fourlink_reach reach;
    double turn;
    int i;

    fourlink_reach_of(&t->d->machine.mechanism, &reach);
    for (i = 0; i < reach.n_ranges; i++) {
        turn = turn_of_range(t, reach.from[i], reach.to[i]);
        add_fact(t, FACT_THETA2_FROM, reach.from[i] + turn);
        add_fact(t, FACT_THETA2_TO, reach.to[i] + turn);
    }
}

/* 1 if flk_fact_list, asked for the branch `called`, lists this one; each 0 for both. */
static int is_asked(const deck *d, int branch, int called)
{
    if (branch == 0)
        return 1;
    return called ? branch == called : branch == FOURLINK_OPEN ? d->open : d->crossed;
}

/* The ranges that outputs leave of those of the four links, on each branch that is asked for. */
static void add_reach_with_outputs(listing *t, int branch)
{
    flk_range ranges[FLK_GROUPS_ENDS];
    size_t n, k;
    double turn;
    int i;

    for (i = 0; i < 2 && is_any_wanted(t, FACT_THETA2_FROM, FACT_THETA2_TO); i++) {
        t->branch = i == 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;
        if (!is_asked(t->d, t->branch, branch) ||
            !flk_kind_has_branch(flk_kind_of(t->d->machine.mechanism.design.kind),
                                 (fourlink_branch)t->branch))
            continue;
        n = flk_groups_ranges(&t->d->machine.mechanism, (fourlink_branch)t->branch, ranges,
                              FLK_FACT_RANGES);
        for (k = 0; k < n; k++) {
            turn = turn_of_range(t, ranges[k].from, ranges[k].to);
            add_fact(t, FACT_THETA2_FROM, ranges[k].from + turn);
            add_fact(t, FACT_THETA2_TO, ranges[k].to + turn);
        }
    }
    t->branch = 0;
}

/* The branch of one of two ranges of link 4; 0 if both have it.  The rocker of a crank-rocker never comes
** into the line of the ground: on the open branch it is above that line. */
static int branch_of_range(const fourlink_mechanism *mechanism, double theta4)
{
    fourlink_type type = FOURLINK_TYPE_END_;

    fourlink_type_of(mechanism, &type);
    if (type != FOURLINK_CRANK_ROCKER)
        return 0;
    return flk_sine(theta4) > 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;
}

/* The angles that link 4 can have if all joints are pins.  Read from D to A, the linkage has link 4 as its
** crank, at the angle 180 deg - theta4. */
static void add_reach_of_rocker(listing *t, int branch)
{
    fourlink_design mirrored = t->d->machine.mechanism.design;
    fourlink_mechanism mechanism;
    fourlink_reach reach;
    double turn;
    int i;

    mirrored.link[FOURLINK_CRANK].length =
        t->d->machine.mechanism.design.link[FOURLINK_FOLLOWER].length;
    mirrored.link[FOURLINK_FOLLOWER].length =
        t->d->machine.mechanism.design.link[FOURLINK_CRANK].length;
    if (fourlink_prepare(&mirrored, &mechanism) != FOURLINK_OK)
        return;
    fourlink_reach_of(&mechanism, &reach);
    for (i = 0; i < reach.n_ranges; i++) {
        if (reach.n_ranges == 2)
            t->branch = branch_of_range(&t->d->machine.mechanism,
                                        M_PI - 0.5 * (reach.from[i] + reach.to[i]));
        if (!is_asked(t->d, t->branch, branch))
            continue;
        turn = turn_of_range(t, M_PI - reach.to[i], M_PI - reach.from[i]);
        add_fact(t, FACT_THETA4_FROM, M_PI - reach.to[i] + turn);
        add_fact(t, FACT_THETA4_TO, M_PI - reach.from[i] + turn);
        add_fact(t, FACT_THETA4_SWING, reach.to[i] - reach.from[i]);
    }
    t->branch = 0;
}

static void add_rod(listing *t)
{
    fourlink_rod rod;

    if (fourlink_rod_masses(&t->d->machine.mechanism, &rod) != FOURLINK_OK)
        return;
    add_fact(t, FACT_ROD_RATIO, rod.n);
    if (t->d->machine.mechanism.design.link[FOURLINK_COUPLER].mass <= 0)
        return;
    add_fact(t, FACT_ROD_GYRATION, rod.k);
    if (rod.k1 > 0)
        add_fact(t, FACT_PAIR_GYRATION, rod.k1);
    add_fact(t, FACT_M_A, rod.m_a);
    add_fact(t, FACT_M_B, rod.m_b);
    if (rod.L == 0)
        return;
    add_fact(t, FACT_ROD_PENDULUM, rod.L);
    add_fact(t, FACT_ROD_DISTANCE, rod.d);
    add_fact(t, FACT_M_D, rod.m_d);
    add_fact(t, FACT_M_G, rod.m_g);
}

/* A linkage found by synthesis. */
static void add_found(listing *t)
{
    const deck_synthesis *found = t->d->synthesis;
    const fourlink_solution *s = found->chosen;
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (s->design.link[i].length > 0)
            add_fact(t, (int)FACT_GROUND_LENGTH + i - FOURLINK_GROUND, s->design.link[i].length);
    if (s->design.offset != 0)
        add_fact(t, FACT_LINE_OFFSET, s->design.offset);
    add_at(t, FACT_MU_RANGE, s->mu_min, s->mu_min_at);
    if (found->task == TASK_FUNCTION)
        add_at(t, found->kind->output == QUANTITY_ANGLE ? FACT_ERROR_ANGLE : FACT_ERROR_LENGTH,
               s->max_error, s->max_error_at);
    if (found->has_points) {
        add_fact(t, FACT_PATH_ERROR, s->rms);
        add_fact(t, FACT_PATH_ERROR_MAX, s->largest);
        if (found->task == TASK_MOTION)
            add_at(t, FACT_COUPLER_ERROR, fabs(s->max_error), s->max_error_at);
    }
    add_fact(t, FACT_DEFECTS, (double)s->defects)->words = found->defects;
}

typedef struct counterweight_facts {
    int moment, angle, mass;
} counterweight_facts;

static void add_counterweight(listing *t, const counterweight_facts *code,
                              const fourlink_vector *moment, double mass)
{
    add_fact(t, code->moment, flk_length(moment->x, moment->y));
    if (moment->x != 0 || moment->y != 0)
        add_fact(t, code->angle, flk_angle(moment->y, moment->x));
    if (t->d->balance.radius > 0)
        add_fact(t, code->mass, mass);
}

static void add_balance(listing *t)
{
    static const counterweight_facts of_crank = {FACT_BALANCE_CRANK, FACT_BALANCE_CRANK_ANGLE,
                                                 FACT_BALANCE_MASS},
                                     of_rocker = {FACT_BALANCE_ROCKER, FACT_BALANCE_ROCKER_ANGLE,
                                                  FACT_BALANCE_ROCKER_MASS};
    const deck_balance *b = &t->d->balance;

    if (b->crank)
        add_counterweight(t, &of_crank, &b->moment.crank, b->mass[0]);
    if (b->rocker)
        add_counterweight(t, &of_rocker, &b->moment.rocker, b->mass[1]);
}

/* The compression ratio is (V_c + V_s) / V_c, with V_c the clearance and V_s the displacement. */
static void add_displacement(listing *t, double stroke)
{
    const flk_gas *gas = flk_gas_on_piston(&t->d->machine);

    if (!gas)
        return;
    add_fact(t, FACT_DISPLACEMENT, gas->area * stroke);
    if (gas->clearance > 0)
        add_fact(t, FACT_COMPRESSION_RATIO, 1 + gas->area * stroke / gas->clearance);
}

static void add_limits(listing *t)
{
    fourlink_limits limits;
    double turn;

    fourlink_limits_of(&t->d->machine.mechanism, (fourlink_branch)t->branch, &limits);
    add_fact(t, FACT_MU_MIN, limits.mu_min);
    add_fact(t, FACT_MU_MAX, limits.mu_max);
    if (!flk_kind_has_slide(t->d->machine.mechanism.design.kind)) {
        add_fact(t, FACT_GAMMA_MIN, limits.gamma_min);
        add_fact(t, FACT_GAMMA_MAX, limits.gamma_max);
    }
    if (limits.has_swing) {
        turn = turn_of_range(t, limits.theta4_min, limits.theta4_max);
        add_at(t, FACT_THETA4_MIN, limits.theta4_min + turn, limits.theta2_min);
        add_at(t, FACT_THETA4_MAX, limits.theta4_max + turn, limits.theta2_max);
        add_fact(t, FACT_SWING, limits.theta4_max - limits.theta4_min);
    }
    if (limits.time_ratio > 0)
        add_fact(t, FACT_TIME_RATIO, limits.time_ratio);
    if (limits.has_slide) {
        add_fact(t, FACT_SLIDE_MIN, limits.slide_min);
        add_fact(t, FACT_SLIDE_MAX, limits.slide_max);
    }
    if (limits.stroke > 0) {
        add_fact(t, FACT_STROKE, limits.stroke);
        add_fact(t, FACT_INNER_DEAD_CENTRE, on_page(t, limits.inner));
        add_fact(t, FACT_OUTER_DEAD_CENTRE, on_page(t, limits.outer));
        add_displacement(t, limits.stroke);
    }
}

int flk_fact_is_direction(const deck *d, int handle)
{
    static const fact_code directions[] = {
        FACT_THETA2_FROM,         FACT_THETA2_TO,   FACT_THETA4_FROM,         FACT_THETA4_TO,
        FACT_INNER_DEAD_CENTRE,   FACT_THETA4_MIN,  FACT_OUTER_DEAD_CENTRE,   FACT_THETA4_MAX,
        FACT_BALANCE_CRANK_ANGLE, FACT_STALL_ANGLE, FACT_BALANCE_ROCKER_ANGLE};
    int code = OTHER(handle), of_output = FACT_OF_OUTPUT(code);
    size_t i;

    if (code >= FACT_COUNT)
        return is_of_rocker(d, code) &&
               (of_output == OUTPUT_FACT_LEAST || of_output == OUTPUT_FACT_MOST);
    for (i = 0; i < sizeof directions / sizeof *directions; i++)
        if (code == (int)directions[i])
            return 1;
    return 0;
}

/* The stroke or swing of each output, where the crank turns fully. */
static void add_limits_of_outputs(listing *t)
{
    const fourlink_mechanism *mechanism = &t->d->machine.mechanism;
    flk_group_limits limits;
    double turn;
    int i, n = mechanism->design.n_groups;

    if (!n || !is_any_wanted(t, OF_OUTPUT(0, 0), OF_OUTPUT(n, -1)) ||
        !flk_groups_come_back(mechanism, (fourlink_branch)t->branch))
        return;
    for (i = 0; i < n; i++) {
        if (!is_any_wanted(t, OF_OUTPUT(i, 0), OF_OUTPUT(i, OUTPUT_FACTS - 1)) ||
            !flk_group_limits_find(mechanism, (fourlink_branch)t->branch, i, &limits))
            continue;
        turn = t->d->groups[i].end == FOURLINK_GROUP_TURNS
                   ? flk_deck_direction(t->d, limits.least) - limits.least
                   : 0;
        add_at(t, OF_OUTPUT(i, OUTPUT_FACT_LEAST), limits.least + turn, limits.least_at);
        add_at(t, OF_OUTPUT(i, OUTPUT_FACT_MOST), limits.most + turn, limits.most_at);
        add_fact(t, OF_OUTPUT(i, OUTPUT_FACT_STROKE), limits.most - limits.least);
        if (limits.time_ratio > 0)
            add_fact(t, OF_OUTPUT(i, OUTPUT_FACT_RATIO), limits.time_ratio);
    }
}

/* Why the actual motion ends early, or FOURLINK_OK. */
static int end_of_motion(flk_analysis *a, fourlink_branch branch)
{
    const flk_actual_facts *f = flk_actual_facts_of(a->course.actual, branch);

    return f ? f->status : FOURLINK_OK;
}

/* 1 if the kind of motion that a deck asks for can have a fact. */
static int is_of_motion(const deck *d, int i)
{
    switch (i) {
    case FACT_RUN_UP_TIME:
        return d->mode.kind == MODE_RUN_UP;
    case FACT_STEADY_RATE:
        return d->mode.kind != MODE_FREE;
    case FACT_MOTOR_TORQUE:
        return d->machine.motor.kind == FOURLINK_MOTOR_BALANCE;
    case FACT_EFFICIENCY_CYCLE:
        return d->machine.has_friction;
    default:
        return flk_fact_group(OTHER(i)) != FOURLINK_FACTS_LIMITS;
    }
}

int flk_fact_why_missing(flk_analysis *a, int handle, fourlink_branch branch)
{
    const flk_actual_facts *f;
    int i = OTHER(handle), status;

    if (!a->course.actual || !is_of_motion(a->d, i))
        return FOURLINK_NO_SUCH_FACT;
    f = flk_actual_facts_of(a->course.actual, branch);
    status = f->status == FOURLINK_OK && i != FACT_STALL_ANGLE ? f->no_cycle : f->status;
    return status == FOURLINK_OK ? FOURLINK_NO_SUCH_FACT : status;
}

static int find_extreme(flk_analysis *a, flk_extremes *x, const flk_column *c,
                        fourlink_branch branch, flk_statistic statistic, int all, fourlink_value *f)
{
    flk_extreme found;
    int status = flk_extremes_find(x, a, c, branch, statistic, all, &found);

    if (status != FOURLINK_OK)
        return status;
    f->value = found.value;
    f->has_angle = gsl_finite(found.value) && !(flk_column_flags(c) & FOURLINK_OF_ROUNDING);
    f->angle = found.angle;
    return FOURLINK_OK;
}

int flk_fact_of_statistic(flk_analysis *a, flk_extremes *x, const flk_column *c,
                          flk_statistic statistic, fourlink_branch branch, int all, char *names,
                          fourlink_value *f)
{
    static const char *const meanings[] = {"", "largest value", "smallest value",
                                           "mean over the crank angle",
                                           "root mean square over the crank angle"};
    fourlink_value v;
    int status;

    flk_list_describe(a->d, flk_column_quantity(c), meanings[statistic], &v);
    v.name = flk_column_statistic_name(statistic, c, names);
    v.handle = flk_column_handle(c, statistic);
    v.branch = (int)branch;
    v.flags = flk_column_flags(c);
    status = statistic == FLK_MAX || statistic == FLK_MIN
                 ? find_extreme(a, x, c, branch, statistic, all, &v)
                 : flk_mean_find(a, &x->room, c, branch, statistic, &v.value);
    if (status == FOURLINK_NOT_REACHED && end_of_motion(a, branch) != FOURLINK_OK)
        status = end_of_motion(a, branch);
    if (status == FOURLINK_OK)
        *f = v;
    return status;
}

static void add_extremes(listing *t, flk_analysis *a, flk_extremes *x, const flk_column *c,
                         char *names)
{
    flk_statistic statistic;

    if (flk_column_flags(c) & FOURLINK_CRANK_ANGLE)
        return;
    for (statistic = FLK_MAX; statistic <= FLK_MIN; statistic++)
        t->n += flk_fact_of_statistic(a, x, c, statistic, (fourlink_branch)t->branch, 1, names,
                                      &t->list[t->n]) == FOURLINK_OK;
}

static void add_indicated(listing *t, flk_analysis *a)
{
    flk_indicated found;

    if (!is_any_wanted(t, FACT_INDICATED_WORK, FACT_MEAN_EFFECTIVE) ||
        !flk_indicated_find(a, (fourlink_branch)t->branch, &found))
        return;
    add_fact(t, FACT_INDICATED_WORK, found.work);
    if (!gsl_isnan(found.power))
        add_fact(t, FACT_INDICATED_POWER, found.power);
    add_fact(t, FACT_MEAN_EFFECTIVE, found.mean_effective);
}

static void add_turning(listing *t, flk_analysis *a)
{
    const fourlink_turning *m = flk_turning_find(a, (fourlink_branch)t->branch);
    const flk_actual_facts *actual =
        flk_actual_facts_of(a->course.actual, (fourlink_branch)t->branch);
    double efficiency;

    if (!m)
        return;
    efficiency = a->turning[t->branch == FOURLINK_OPEN ? 0 : 1].efficiency;
    if (t->d->machine.has_friction && !gsl_isnan(efficiency))
        add_fact(t, FACT_EFFICIENCY_CYCLE, efficiency);
    add_fact(t, FACT_MEAN_TORQUE, m->mean_torque);
    add_fact(t, FACT_MEAN_POWER, m->mean_power);
    add_fact(t, FACT_ENERGY_FLUCTUATION, m->energy_fluctuation);
    if (m->has_coefficient)
        add_fact(t, FACT_ENERGY_COEFFICIENT, m->energy_coefficient);
    if (m->inertia > 0 || t->d->flywheel_fluctuation > 0) /* 0: no flywheel is needed */
        add_fact(t, FACT_FLYWHEEL_INERTIA, m->inertia);
    if ((actual ? actual->inertia : m->inertia) > 0)
        add_fact(t, FACT_FLYWHEEL_FLUCTUATION, m->fluctuation);
}

/* Add a fact if it is defined for this motion. */
static void add_fact_if_defined(listing *t, int code, double si)
{
    if (gsl_finite(si))
        add_fact(t, code, si);
}

static void add_actual(listing *t, flk_analysis *a)
{
    const flk_actual_facts *f = flk_actual_facts_of(a->course.actual, (fourlink_branch)t->branch);

    if (!f)
        return;
    add_fact_if_defined(t, FACT_MEAN_SPEED, f->mean_speed);
    add_fact_if_defined(t, FACT_MEAN_SPEED_TEXTBOOK, f->mean_speed_textbook);
    add_fact_if_defined(t, FACT_PERIOD, f->period);
    add_fact_if_defined(t, FACT_FLUCTUATION_EXACT, f->fluctuation_exact);
    add_fact_if_defined(t, FACT_STEADY_RATE, f->steady_rate);
    add_fact_if_defined(t, FACT_STALL_ANGLE, f->stall_angle * t->d->motion.angle_unit);
    add_fact_if_defined(t, FACT_RUN_UP_TIME, f->run_up_time);
    if (t->d->machine.motor.kind == FOURLINK_MOTOR_BALANCE)
        add_fact_if_defined(t, FACT_MOTOR_TORQUE, f->motor_torque);
}

/* 1 if theta4_min, theta4_max and swing say what theta4_from, theta4_to and theta4_swing would say. */
static int has_swing(const fourlink_mechanism *mechanism)
{
    fourlink_limits limits;

    return fourlink_limits_of(mechanism, FOURLINK_OPEN, &limits) == FOURLINK_OK && limits.has_swing;
}

/* List all facts by name. */
static unsigned long list_names(listing *t)
{
    int code, n = OF_OUTPUT(t->d->machine.mechanism.design.n_groups, 0);

    add_type(t);
    for (code = FACT_TYPE + 1; code < n; code++)
        add_fact(t, code, GSL_NAN);
    return t->n;
}

unsigned long flk_fact_list(flk_analysis *a, flk_extremes *x, int branch, int groups, int handle,
                            const flk_column *columns, size_t n_columns, flk_list *list)
{
    listing t;
    size_t j;
    int i;

    t.d = a->d;
    t.list = list->list;
    t.n = 0;
    t.only = handle;
    t.branch = 0;
    if (groups == FOURLINK_FACTS_NAMES)
        return list_names(&t);
    if (groups & FOURLINK_FACTS_LIMITS) {
        int has_slide = flk_kind_has_slide(t.d->machine.mechanism.design.kind);

        add_type(&t);
        if (!has_slide)
            add_fact(&t, FACT_FREUDENSTEIN,
                     flk_derive_freudenstein(&t.d->machine.mechanism.design));
        if (t.d->machine.mechanism.design.n_groups)
            add_reach_with_outputs(&t, branch);
        else
            add_reach(&t);
        if (!has_slide && is_any_wanted(&t, FACT_THETA4_FROM, FACT_THETA4_SWING) &&
            (handle || !has_swing(&t.d->machine.mechanism)))
            add_reach_of_rocker(&t, branch);
        add_rod(&t);
        add_balance(&t);
        if (t.d->synthesis)
            add_found(&t);
    }
    for (i = 0; i < 2; i++) {
        t.branch = i == 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;
        if (!is_asked(t.d, t.branch, branch))
            continue;
        if (groups & FOURLINK_FACTS_LIMITS) {
            add_limits(&t);
            add_limits_of_outputs(&t);
        }
        for (j = 0; j < n_columns && (groups & FOURLINK_FACTS_EXTREMES); j++)
            add_extremes(&t, a, x, &columns[j], list->names);
        if (groups & FOURLINK_FACTS_TURNING) {
            add_turning(&t, a);
            add_indicated(&t, a);
        }
        if (groups & FOURLINK_FACTS_MOTION)
            add_actual(&t, a);
    }
    return t.n;
}
