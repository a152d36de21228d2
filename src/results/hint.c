/* SPDX-License-Identifier: GPL-3.0-or-later
**
** hint.c - why a value may differ from the computed one: a sign, a unit, the branch, the row, values above,
** weights, axes.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/digits.h"
#include "base/message.h"
#include "base/quantity.h"
#include "mechanics/mechanics.h"
#include "carried.h"
#include "expected.h"
#include "fact.h"
#include "hint.h"

#define RPM (2 * M_PI / 60) /* rad/s */
#define DEG (M_PI / 180)    /* rad */

/* computed / expected, and what that suggests; rpm only of what has a time in it */
static const struct {
    double factor;
    int is_of_speed;
    const char *words;
} factor_table[] = {
    {1 / RPM, 1, "the computed value is 60/(2 pi) times this one: rad/s for rpm?"},
    {RPM, 1, "the computed value is 2 pi/60 times this one: rpm for rad/s?"},
    {1 / (RPM * RPM), 1, "the computed value is (60/(2 pi))^2 times this one: rad/s for rpm?"},
    {RPM * RPM, 1, "the computed value is (2 pi/60)^2 times this one: rpm for rad/s?"},
    {1 / DEG, 0, "the computed value is 180/pi times this one: degrees and radians?"},
    {DEG, 0, "the computed value is pi/180 times this one: degrees and radians?"},
    {1e3, 0, "the computed value is 1000 times this one: a unit such as m for mm?"},
    {1e-3, 0, "the computed value is 1/1000 of this one: a unit such as mm for m?"}};

#define FACTORS (sizeof factor_table / sizeof factor_table[0])

/* 1 if the value would agree but for a factor.  What [grading] allows is of the computed value, and as
** much smaller or larger. */
static int agrees_by_factor(const fourlink_check *c, double factor)
{
    fourlink_check scaled = *c;

    if (c->tolerance_from >= FOURLINK_FROM_GRADING)
        scaled.tolerance = c->tolerance / factor;
    return fabs(c->printed) > 2 * scaled.tolerance && /* every small number would agree */
           flk_expected_agrees(&scaled, c->computed / factor, 0);
}

/* The hint of a factor, or null. */
static const char *hint_of_factor(const fourlink_check *c, quantity q)
{
    size_t i;

    for (i = 0; i < FACTORS; i++)
        if ((!factor_table[i].is_of_speed || flk_quantities[q].dim.s) &&
            agrees_by_factor(c, factor_table[i].factor))
            return factor_table[i].words;
    return NULL;
}

/* 1 if a value is the computed one cut off after its last digit, not rounded; half of that is the
** tolerance. */
static int is_cut_off(const fourlink_check *c)
{
    double digit = 2 * c->tolerance, last;

    if (c->tolerance_from != FOURLINK_FROM_DIGIT || !(digit > 0))
        return 0;
    last = c->computed / digit;
    last = (last < 0 ? ceil(last) : floor(last)) * digit;
    return fabs(last - c->printed) < 1e-6 * digit;
}

/* 1 if the value elsewhere would have agreed. */
static int agrees_at(flk_opened *o, const flk_name *n, const fourlink_check *c,
                     fourlink_branch branch, double angle, double turn)
{
    fourlink_value v;

    return flk_name_value(o, n, branch, angle, &v) == FOURLINK_OK && !v.words &&
           flk_expected_agrees(c, v.value, turn);
}

/* The two angles that books call the transmission angle. */
static const char *const angles[][2] = {{"mu", "gamma"},
                                        {"mu_min", "gamma_min"},
                                        {"mu_max", "gamma_max"},
                                        {"max(mu)", "max(gamma)"},
                                        {"min(mu)", "min(gamma)"}};

/* The name of the other transmission angle, if that has the expected value; or null. */
static const char *find_other_angle(flk_opened *o, const fourlink_check *c)
{
    size_t i;
    flk_name other;
    int k;

    for (i = 0; i < sizeof angles / sizeof angles[0]; i++)
        for (k = 0; k < 2; k++)
            if (strcmp(c->name, angles[i][k]) == 0) {
                flk_name_find(o, flk_text_of(angles[i][!k]), &other);
                return agrees_at(o, &other, c, c->branch, c->angle, 0) ? angles[i][!k] : NULL;
            }
    return NULL;
}

/* The value at an angle or, if the motion does not have it, a turn before or after it. */
static int agrees_on_motion(flk_opened *o, const flk_name *n, const fourlink_check *c, double angle,
                            double turn)
{
    double full = flk_unit_from_si(2 * M_PI, o->d.units[QUANTITY_ANGLE].unit);
    int k;

    for (k = -1; k <= 1; k++)
        if (agrees_at(o, n, c, c->branch, angle + k * full, turn))
            return 1;
    return 0;
}

/* The crank angle was read clockwise, or in another unit. */
static void hint_of_angle(flk_opened *o, const flk_name *n, fourlink_check *c, double turn)
{
    unit own = o->d.units[QUANTITY_ANGLE].unit;
    double full = flk_unit_from_si(2 * M_PI, own), rad = flk_unit_from_si(c->angle, own);

    if (agrees_on_motion(o, n, c, -c->angle, turn))
        flk_message(c->hint, sizeof c->hint,
                    "%s is the value at theta2 = %g: angles are counter-clockwise", c->printed_text,
                    -c->angle);
    else if (agrees_on_motion(o, n, c, flk_cycle_place(rad, 0, full), turn)) {
        c->part = 0;
        flk_message(c->hint, sizeof c->hint, "%s is the value at theta2 = %g rad", c->printed_text,
                    c->angle);
    }
}

/* The neighbouring row whose value is the expected one. */
static void hint_of_row(flk_opened *o, const flk_name *n, fourlink_check *c, double turn)
{
    fourlink_problem problem;
    int side;

    fourlink_deck_problem(&o->d, &problem);
    for (side = -1; side <= 1 && !c->hint[0]; side += 2) {
        double angle = c->angle + side * problem.motion.interval;

        if (agrees_at(o, n, c, c->branch, angle, turn)) {
            c->part = 0;
            flk_message(c->hint, sizeof c->hint,
                        "%s is the value of the neighbouring row, theta2 = %g", c->printed_text,
                        angle);
        }
    }
}

/* ------------------------------------------------------------------------------------------------ slips */

/* Lines of a deck as students misread them: the deck is opened with each, once, where it may tell. */
typedef enum slip_kind { OF_WEIGHTS, OF_SPEED, OF_AXES } slip_kind;
static const struct slip {
    slip_kind kind;
    const char *assignment; /* of a speed its beginning */
    double size;            /* gravity, m/s2; what the speed, rad/s, is multiplied by */
    const char *words;      /* after "12.5 N is the value " */
} slip_table[FLK_SLIPS] = {
    {OF_WEIGHTS, "gravity.acceleration=0 m/s2", 0, "without the weights"},
    {OF_WEIGHTS, "gravity.acceleration=9.81 m/s2", 9.81, "with gravity 9.81 m/s2"},
    {OF_WEIGHTS, "gravity.acceleration=9.8 m/s2", 9.8, "with gravity 9.8 m/s2"},
    {OF_WEIGHTS, "gravity.acceleration=10 m/s2", 10, "with gravity 10 m/s2"},
    {OF_WEIGHTS, "gravity.acceleration=32.2 ft/s2", 32.2 * 0.3048, "with gravity 32.2 ft/s2"},
    {OF_SPEED, "motion.speed=", 1 / RPM, "with the speed in rpm read as rad/s"},
    {OF_SPEED, "motion.speed=", RPM, "with the speed in rad/s read as rpm"},
    {OF_AXES, "axes=page", 0, "with angles and directions from the horizontal of the page"},
    {OF_AXES, "axes=ground", 0, "with angles and directions from link 1"}};

/* 1 if a deck with this slip may have another value of this name. */
static int may_slip(const flk_opened *o, const flk_name *n, const fourlink_check *c,
                    const struct slip *slip)
{
    const fourlink_vector *g = &o->d.machine.mechanism.design.gravity;
    int is_column = n->kind == FLK_NAME_COLUMN || n->kind == FLK_NAME_STATISTIC;
    int of_forces = is_column ? flk_column_need(&n->c) & NEED_FORCES
                              : flk_fact_group(n->handle) == FOURLINK_FACTS_TURNING;

    if (o->d.mode.kind != MODE_GIVEN ||
        o->d.synthesis) /* motion or linkage would be sought again */
        return 0;
    if (slip->kind == OF_WEIGHTS)
        return of_forces && fabs(sqrt(FLK_DOT(*g, *g)) - slip->size) > 1e-9;
    if (slip->kind == OF_SPEED)
        return is_column && o->d.motion.speed != 0 && !o->d.program && !o->d.prescribed;
    return is_column && c->has_angle;
}

/* Open the deck with a slip; `o->slips` stays null if that has mistakes.  FOURLINK_OK, FOURLINK_NO_MEMORY. */
static int open_slip(flk_opened *o, size_t i)
{
    const struct slip *slip = &slip_table[i];
    char words[40 + DIGITS_SIZE], number[DIGITS_SIZE] = "";
    fourlink_change change;
    flk_mistake_list none;
    unsigned long n;
    int status;

    if (o->is_slip_tried[i])
        return FOURLINK_OK;
    if (slip->kind == OF_SPEED)
        flk_digits_short(o->d.motion.speed * slip->size, 17, number);
    flk_text_join(words, sizeof words, slip->assignment, number, *number ? " rad/s" : "",
                  (char *)NULL);
    memset(&change, 0, sizeof change);
    memset(&none, 0, sizeof none);
    none.n = &n;
    change.origin = "";
    change.assignment = words;
    status = flk_opened_changed(o, &change, &none, &o->slips[i]);
    if (status == FOURLINK_OK)
        status = flk_opened_keep_rows(o->slips[i]);
    o->is_slip_tried[i] = status != FOURLINK_NO_MEMORY;
    return status == FOURLINK_NO_MEMORY ? status : FOURLINK_OK;
}

/* 1 if the deck with a slip has a value that agrees, which is so far apart.  In other axes also where
** the crank has the same angle on the page: only what is asked may have been measured from them. */
static int agrees_in_slip(flk_opened *slip, const flk_name *n, const flk_opened *o, slip_kind kind,
                          const fourlink_check *c, double turn, double *apart)
{
    double shift = slip->d.axes.angle - o->d.axes.angle;
    fourlink_value v;
    int k;

    for (k = 0; k < 1 + (kind == OF_AXES); k++) {
        double angle = c->angle + k * flk_unit_from_si(shift, o->d.units[QUANTITY_ANGLE].unit);

        if (flk_name_value(slip, n, c->branch, angle, &v) == FOURLINK_OK && !v.words &&
            flk_expected_agrees(c, v.value, turn)) {
            *apart = fabs(flk_expected_apart(c, v.value, turn));
            return 1;
        }
    }
    return 0;
}

/* The slip with the value nearest to that which is printed, of those that agree. */
static int hint_of_slip(flk_opened *o, const flk_name *n, fourlink_check *c, double turn)
{
    double nearest = GSL_POSINF, apart = 0;
    flk_name same;
    size_t i;
    int status;

    for (i = 0; i < FLK_SLIPS; i++) {
        if (!may_slip(o, n, c, &slip_table[i]))
            continue;
        status = open_slip(o, i);
        if (status == FOURLINK_OK && o->slips[i]) {
            flk_name_find(o->slips[i], flk_text_of(c->name), &same);
            status = flk_name_prepare(o->slips[i], &same, c->branch);
        }
        if (status != FOURLINK_OK)
            return status;
        if (!o->slips[i] ||
            !agrees_in_slip(o->slips[i], &same, o, slip_table[i].kind, c, turn, &apart) ||
            !(apart < nearest))
            continue;
        nearest = apart;
        flk_message(c->hint, sizeof c->hint, "%s is the value %s", c->printed_text,
                    slip_table[i].words);
    }
    return FOURLINK_OK;
}

/* ": that of F32" where a name is that of the pin force F23 or of a part of it: the force of the other
** link; else "". */
static const char *opposite_force(const char *name, char words[40])
{
    static const char that[] = ": that of F";
    size_t n = sizeof that - 1;

    words[0] = '\0';
    if (name[0] == 'F' && '1' <= name[1] && name[1] <= '4' && '1' <= name[2] && name[2] <= '4' &&
        (!name[3] || strcmp(name + 3, "x") == 0 || strcmp(name + 3, "y") == 0 ||
         strcmp(name + 3, "_dir") == 0)) {
        memcpy(words, that, n);
        words[n] = name[2];
        words[n + 1] = name[1];
        words[n + 2] = '\0';
    }
    return words;
}

/* What follows from the values above it as they were written. */
static int hint_of_carried(flk_opened *o, const deck_expectation *e, const flk_name *n,
                           fourlink_check *c, double turn)
{
    char words[FLK_CARRIED_WORDS];
    double value;
    int status = flk_carried_value(o, e, n, &value, words);

    if (status == FOURLINK_OK && flk_expected_agrees(c, value, turn))
        flk_message(c->hint, sizeof c->hint, "it follows from %s as written", words);
    return status == FOURLINK_NO_MEMORY ? status : FOURLINK_OK;
}

int flk_hint_find(flk_opened *o, const deck_expectation *e, const flk_name *n, fourlink_check *c)
{
    fourlink_branch other = c->branch == FOURLINK_OPEN ? FOURLINK_CROSSED : FOURLINK_OPEN;
    fourlink_value here;
    const char *words, *angle;
    double turn;
    char force[40];
    int is_opposite, is_other, status;

    c->part = 0.5;
    if (c->hint[0] || c->has_place ||
        flk_name_value(o, n, c->branch, c->angle, &here) != FOURLINK_OK)
        return FOURLINK_OK;
    status = flk_opened_keep_rows(o);
    if (status == FOURLINK_OK)
        status = flk_name_prepare(o, n, other);
    if (status != FOURLINK_OK)
        return status;
    turn = flk_name_turn(o, n);
    opposite_force(c->name, force);
    is_opposite = turn > 0 && force[0] ? flk_expected_agrees(c, c->computed + turn / 2, turn)
                                       : flk_expected_agrees(c, -c->computed, turn);
    is_other = agrees_at(o, n, c, other, c->angle, turn);
    angle = find_other_angle(o, c);
    words = hint_of_factor(c, flk_quantity_find(here.quantity));
    if (angle)
        flk_message(c->hint, sizeof c->hint,
                    "%s is %s: mu is acute, gamma is the angle from 0 to 180 deg", c->printed_text,
                    angle);
    else if (is_opposite && !is_other)
        flk_message(c->hint, sizeof c->hint, "the %s is the opposite%s",
                    turn > 0 && force[0] ? "direction" : "sign", force);
    else if (is_other)
        flk_message(c->hint, sizeof c->hint, "%s%s is the %s branch's value",
                    is_opposite ? "the sign is the opposite, and " : "", c->printed_text,
                    fourlink_branch_text((int)other));
    else if (words)
        flk_message(c->hint, sizeof c->hint, "%s", words);
    else if (is_cut_off(c)) {
        c->part = 0;
        flk_message(c->hint, sizeof c->hint, "the computed value is cut off there, not rounded");
    } else if (c->has_angle)
        hint_of_row(o, n, c, turn);
    if (!c->hint[0] && c->has_angle && c->angle != 0)
        hint_of_angle(o, n, c, turn);
    status = c->hint[0] ? FOURLINK_OK : hint_of_carried(o, e, n, c, turn);
    return c->hint[0] || status != FOURLINK_OK ? status : hint_of_slip(o, n, c, turn);
}
