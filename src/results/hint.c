/* SPDX-License-Identifier: GPL-3.0-or-later
**
** hint.c - why an expected value may differ from the computed one: its sign, a unit, the branch, the row.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/message.h"
#include "expected.h"

#define RPM (2 * M_PI / 60) /* rad/s */
#define DEG (M_PI / 180)    /* rad */

/* computed / expected, and what that suggests */
static const struct {
    double factor;
    const char *words;
} factor_table[] = {
    {1 / RPM, "the computed value is 60/(2 pi) times the expected one: rad/s for rpm?"},
    {RPM, "the computed value is 2 pi/60 times the expected one: rpm for rad/s?"},
    {1 / (RPM * RPM), "the computed value is (60/(2 pi))^2 times the expected one: rad/s for rpm?"},
    {RPM * RPM, "the computed value is (2 pi/60)^2 times the expected one: rpm for rad/s?"},
    {1 / DEG, "the computed value is 180/pi times the expected one: degrees and radians?"},
    {DEG, "the computed value is pi/180 times the expected one: degrees and radians?"},
    {1e3, "the computed value is 1000 times the expected one: a unit such as m for mm?"},
    {1e-3, "the computed value is 1/1000 of the expected one: a unit such as mm for m?"}};

#define FACTORS (sizeof factor_table / sizeof factor_table[0])

/* The hint of a factor, or null. */
static const char *hint_of_factor(const fourlink_check *c)
{
    size_t i;

    if (fabs(c->printed) <= 2 * c->tolerance)
        return NULL; /* every small number would agree */
    for (i = 0; i < FACTORS; i++)
        if (flk_expected_agrees(c, c->computed / factor_table[i].factor, 0))
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
    else if (agrees_on_motion(o, n, c, rad - full * floor(rad / full), turn))
        flk_message(c->hint, sizeof c->hint, "%s is the value at theta2 = %g rad", c->printed_text,
                    c->angle);
}

/* The neighbouring row whose value is the expected one. */
static void hint_of_row(flk_opened *o, const flk_name *n, fourlink_check *c, double turn)
{
    fourlink_problem problem;
    int side;

    fourlink_deck_problem(&o->d, &problem);
    for (side = -1; side <= 1 && !c->hint[0]; side += 2) {
        double angle = c->angle + side * problem.motion.interval;

        if (agrees_at(o, n, c, c->branch, angle, turn))
            flk_message(c->hint, sizeof c->hint,
                        "%s is the value of the neighbouring row, theta2 = %g", c->printed_text,
                        angle);
    }
}

void flk_hint_find(flk_opened *o, const flk_name *n, fourlink_check *c)
{
    fourlink_branch other = c->branch == FOURLINK_OPEN ? FOURLINK_CROSSED : FOURLINK_OPEN;
    fourlink_value here;
    const char *words, *angle;
    double turn;
    int is_opposite, is_other;

    if (c->hint[0] || c->has_time ||
        flk_name_value(o, n, c->branch, c->angle, &here) != FOURLINK_OK)
        return;
    turn = strcmp(here.quantity, "angle") == 0 ? 2 * M_PI / here.to_si : 0;
    is_opposite = flk_expected_agrees(c, -c->computed, turn);
    is_other = agrees_at(o, n, c, other, c->angle, turn);
    angle = find_other_angle(o, c);
    words = hint_of_factor(c);
    if (angle)
        flk_message(c->hint, sizeof c->hint,
                    "%s is %s: mu is acute, gamma is the angle from 0 to 180 deg", c->printed_text,
                    angle);
    else if (is_opposite && !is_other)
        flk_message(c->hint, sizeof c->hint, "the sign is the opposite");
    else if (is_other)
        flk_message(c->hint, sizeof c->hint, "%s%s is the %s branch's value",
                    is_opposite ? "the sign is the opposite, and " : "", c->printed_text,
                    fourlink_branch_text((int)other));
    else if (words)
        flk_message(c->hint, sizeof c->hint, "%s", words);
    else if (is_cut_off(c))
        flk_message(c->hint, sizeof c->hint, "the computed value is cut off there, not rounded");
    else if (c->has_angle)
        hint_of_row(o, n, c, turn);
    if (!c->hint[0] && c->has_angle && c->angle != 0)
        hint_of_angle(o, n, c, turn);
}
