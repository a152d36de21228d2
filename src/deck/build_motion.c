/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_motion.c - builds [motion] from values.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "build.h"
#include "build_motor.h"
#include "build_prescribed.h"
#include "build_program.h"
#include "parser.h"
#include "settings.h"

static double angle_or(parser *p, key_code key, double otherwise)
{
    const setting *s = flk_setting_find(p, key);

    return IS_SET(s) ? flk_setting_in_unit(p, s, QUANTITY_ANGLE) : otherwise;
}

/* One instant has no range, but `at` from the command line replaces the deck's range. */
static void check_alone(parser *p, const setting *at)
{
    static const key_code others[] = {KEY_MOTION_FROM, KEY_MOTION_TO, KEY_MOTION_TURNS,
                                      KEY_MOTION_RUN_UP};
    size_t i;

    for (i = 0; i < sizeof others / sizeof others[0]; i++) {
        const setting *s = flk_setting_find(p, others[i]);

        if (IS_SET(s) && (s->place.line == 0) == (at->place.line == 0))
            flk_mistake(p->mistakes, s->place,
                        "'%s' cannot be used with 'at', which is one instant",
                        flk_key_table[others[i]].name);
    }
}

/* 360 rather than 360.00000000000006 */
static double whole(double x)
{
    double nearest = floor(x + 0.5);

    return fabs(x - nearest) < 1e-12 * x ? nearest : x;
}

/* Start from rest through an angle, then one revolution (Alvi's program, vela = 0). */
static void build_run_up(parser *p, const setting *run_up)
{
    const setting *speed = flk_setting_find(p, KEY_MOTION_SPEED),
                  *to = flk_setting_find(p, KEY_MOTION_TO),
                  *turns = flk_setting_find(p, KEY_MOTION_TURNS);

    p->d->motion.run_up = angle_or(p, KEY_MOTION_RUN_UP, 0);
    p->d->one_revolution = 1;
    if (speed->si[0] != 0)
        flk_mistake(p->mistakes, speed->place,
                    "a run-up starts from rest: give an acceleration, not a speed");
    if (IS_SET(to) || IS_SET(turns))
        flk_mistake(p->mistakes, (IS_SET(to) ? to : turns)->place,
                    "a run-up ends one revolution after its angle: '%s' is not allowed",
                    IS_SET(to) ? "to" : "turns");
    if (p->d->motion.hold)
        flk_mistake(p->mistakes, run_up->place, "'hold' cannot be used with a run-up");
}

/* A cycle is at least one interval long; otherwise curves and windows would repeat within a row. */
static void check_cycle(parser *p, double cycle)
{
    const setting *s = flk_setting_find(p, KEY_MOTION_CYCLE);

    if (IS_SET(s) && cycle > 0 && cycle < p->d->motion.interval)
        flk_mistake(p->mistakes, s->place, "the cycle is shorter than the interval of the rows");
}

/* Refuse keys of the given motion in another mode, and the reverse. */
static void check_mode_of_motion(parser *p, int mode)
{
    static const key_code of_given[] = {KEY_MOTION_ACCELERATION, KEY_MOTION_RUN_UP, KEY_MOTION_HOLD,
                                        KEY_MOTION_AT};
    const setting *speed = flk_setting_find(p, KEY_MOTION_SPEED),
                  *mean = flk_setting_find(p, KEY_MOTION_MEAN_SPEED);
    size_t i;

    for (i = 0; mode != MODE_GIVEN && i < sizeof of_given / sizeof of_given[0]; i++) {
        const setting *s = flk_setting_find(p, of_given[i]);

        if (IS_SET(s))
            flk_mistake(p->mistakes, s->place, "'%s' is for a given motion: mode = %t computes it",
                        flk_key_table[of_given[i]].name,
                        flk_setting_find(p, KEY_MOTION_MODE)->value);
    }
    if (mode == MODE_RUN_UP && speed->si[0] != 0)
        flk_mistake(p->mistakes, speed->place,
                    "a run-up starts from rest: for a motion from this speed, mode = free");
    if (mode == MODE_STEADY && IS_SET(speed))
        flk_mistake(p->mistakes, speed->place,
                    "the speed of the steady motion is computed: give a mean_speed with [motor] "
                    "torque = constant, or a motor that has a speed");
    if (IS_SET(mean) && p->d->machine.motor.kind != FOURLINK_MOTOR_BALANCE &&
        !flk_section_is_mistaken(p, SECTION_MOTOR))
        flk_mistake(p->mistakes, mean->place,
                    "a mean_speed needs [motor] torque = constant, which balances the loads at any "
                    "speed");
    else if (IS_SET(mean) && mean->si[0] == 0 && !flk_section_is_mistaken(p, SECTION_MOTION))
        flk_mistake(p->mistakes, mean->place, "the mean_speed must not be 0");
}

/* The keys of rows by time, which have their own end of the range. */
static void build_rows_by_time(parser *p)
{
    static const key_code of_angle[] = {KEY_MOTION_TO, KEY_MOTION_TURNS, KEY_MOTION_INTERVAL};
    const setting *rows = flk_setting_find(p, KEY_MOTION_ROWS),
                  *step = flk_setting_find(p, KEY_MOTION_TIME_STEP),
                  *duration = flk_setting_find(p, KEY_MOTION_DURATION);
    deck_mode *mode = &p->d->mode;
    size_t i;

    p->d->over = &flk_abscissas[rows->word];
    mode->time_step = step->si[0];
    mode->duration = duration->si[0];
    if (!rows->word) {
        if (IS_SET(step) || IS_SET(duration))
            flk_mistake(p->mistakes, (IS_SET(step) ? step : duration)->place,
                        "'%s' is for rows by time: rows = time",
                        IS_SET(step) ? "time_step" : "duration");
        return;
    }
    if (mode->kind != MODE_FREE && mode->kind != MODE_RUN_UP)
        flk_mistake(p->mistakes, rows->place, "rows by time need mode = free or run-up");
    if ((!IS_SET(step) || !IS_SET(duration)) && !flk_section_is_mistaken(p, SECTION_MOTION))
        flk_mistake(p->mistakes, rows->place, "rows by time need '%s'",
                    IS_SET(step) ? "duration" : "time_step");
    for (i = 0; i < sizeof of_angle / sizeof of_angle[0]; i++) {
        const setting *s = flk_setting_find(p, of_angle[i]);

        if (IS_SET(s))
            flk_mistake(p->mistakes, s->place,
                        "'%s' is for rows by angle; rows by time have time_step and duration",
                        flk_key_table[of_angle[i]].name);
    }
    if (flk_section_find(p, SECTION_FRICTION, NULL))
        flk_mistake(p->mistakes, rows->place,
                    "rows by time allow the machine to swing back, which friction does not: rows "
                    "by angle, or no [friction]");
    if (step->si[0] > 0 && duration->si[0] / step->si[0] > MOST_TIMES)
        flk_mistake(p->mistakes, duration->place,
                    "more than 1,000,000 rows by time (%.6g): give a larger time_step or a shorter "
                    "duration",
                    duration->si[0] / step->si[0]);
}

/* The last crank angle, in the deck's unit. */
static double last_angle(parser *p, double cycle)
{
    const setting *to = flk_setting_find(p, KEY_MOTION_TO),
                  *turns = flk_setting_find(p, KEY_MOTION_TURNS);
    double from = p->d->motion.from, sense = flk_build_sense(p);

    p->d->mode.turns = turns->si[0];
    if (IS_SET(turns) && IS_SET(to))
        flk_mistake(p->mistakes, turns->place, "give either 'to' or 'turns', not both");
    else if (IS_SET(turns) && turns->si[0] == 0 && !flk_section_is_mistaken(p, SECTION_MOTION))
        flk_mistake(p->mistakes, turns->place, "the turns must not be 0");
    if (IS_SET(to))
        return angle_or(p, KEY_MOTION_TO, 0);
    if (IS_SET(turns))
        return from +
               turns->si[0] * whole(flk_unit_from_si(2 * M_PI, p->d->units[QUANTITY_ANGLE].unit));
    return from + sense * cycle;
}

/* The first place at which the end of the range is given. */
static text_place place_of_end(parser *p)
{
    const setting *to = flk_setting_find(p, KEY_MOTION_TO),
                  *turns = flk_setting_find(p, KEY_MOTION_TURNS);

    return IS_SET(to) ? to->place : IS_SET(turns) ? turns->place : flk_reader_end(p);
}

/* The place that determines the number of rows: the interval if given, otherwise the range. */
static text_place place_of_rows(parser *p)
{
    static const key_code keys[] = {KEY_MOTION_INTERVAL, KEY_MOTION_TO, KEY_MOTION_TURNS,
                                    KEY_MOTION_RUN_UP, KEY_MOTION_CYCLE};
    size_t i;

    for (i = 0; i < sizeof keys / sizeof keys[0]; i++) {
        const setting *s = flk_setting_find(p, keys[i]);

        if (IS_SET(s))
            return s->place;
    }
    return flk_reader_end(p);
}

/* The name of the setting that turns a steady motion against its range; null: none. */
static const char *against_range(parser *p)
{
    const deck_mode *mode = &p->d->mode;

    if (mode->kind != MODE_STEADY ||
        (p->d->motion.to - p->d->motion.from) * flk_build_sense(p) >= 0)
        return NULL;
    if (mode->mean_speed != 0)
        return "mean_speed";
    return p->d->machine.motor.kind == FOURLINK_MOTOR_LINEAR ? "motor" : NULL;
}

static void check_range(parser *p)
{
    const fourlink_motion *motion = &p->d->motion;
    const setting *s = flk_setting_find(p, KEY_MOTION_INTERVAL);
    fourlink_range range;
    char count[40] = "";
    int status = fourlink_motion_range(motion, &range);
    int has_too_many =
        status == FOURLINK_TOO_MANY_ROWS ||
        (status == FOURLINK_OK && range.n_rows > MOST_ROWS && p->d->over->is_crank_angle);

    if (has_too_many && flk_motion_intervals(motion) < FLK_MOTION_MOST)
        flk_message(count, sizeof count, " (%g)", flk_motion_intervals(motion) + 1);
    if (status == FOURLINK_BAD_RANGE)
        flk_mistake(p->mistakes, place_of_end(p),
                    "the range runs against the rotation of an accelerated crank: swap 'from' and "
                    "'to', or set 'hold = yes'");
    else if (status == FOURLINK_NO_RUN_UP)
        flk_mistake(p->mistakes, flk_setting_find(p, KEY_MOTION_RUN_UP)->place,
                    "a run-up from rest needs an acceleration");
    else if (has_too_many)
        flk_mistake(
            p->mistakes, place_of_rows(p),
            "more than 10,000,000 rows by angle%s: give a larger interval or a shorter range",
            count);
    else if (status != FOURLINK_OK)
        flk_mistake(p->mistakes, IS_SET(s) ? s->place : flk_reader_end(p), "%s",
                    fourlink_status_text(status));
    else if (p->d->mode.kind == MODE_FREE && (motion->to - motion->from) * motion->speed < 0)
        flk_mistake(p->mistakes, place_of_end(p),
                    "the range runs against the speed at its beginning: swap 'from' and 'to'");
    else if (against_range(p))
        flk_mistake(p->mistakes, place_of_end(p),
                    "the range runs against the %s: change the sign of one of them",
                    against_range(p));
}

void flk_build_motion(parser *p)
{
    fourlink_motion *motion = &p->d->motion;
    const unit *u = &p->d->units[QUANTITY_ANGLE].unit;
    const setting *run_up = flk_setting_find(p, KEY_MOTION_RUN_UP),
                  *at = flk_setting_find(p, KEY_MOTION_AT);
    size_t before = flk_mistakes_count(p->mistakes);
    double cycle;
    int is_prescribed;

    p->d->mode.mean_speed = flk_setting_or(p, KEY_MOTION_MEAN_SPEED, 0);
    motion->angle_unit = u->up / u->down;
    motion->x_at = p->d->axes.angle;
    motion->interval = whole(flk_unit_from_si(M_PI / 18, *u));
    is_prescribed = flk_build_is_prescribed(p);
    if (flk_build_program(p) || is_prescribed)
        return;
    check_mode_of_motion(p, p->d->mode.kind);
    build_rows_by_time(p);
    motion->speed = flk_setting_or(p, KEY_MOTION_SPEED, 0);
    motion->acceleration = flk_setting_or(p, KEY_MOTION_ACCELERATION, 0);
    motion->hold = flk_setting_find(p, KEY_MOTION_HOLD)->word;
    motion->interval = angle_or(p, KEY_MOTION_INTERVAL, motion->interval);
    if (IS_SET(at)) {
        check_alone(p, at);
        motion->from = angle_or(p, KEY_MOTION_AT, 0);
        motion->to = motion->from;
        motion->interval = 1; /* any value */
        p->d->one_instant = 1;
        return;
    }
    cycle = angle_or(p, KEY_MOTION_CYCLE, whole(flk_unit_from_si(2 * M_PI, *u)));
    check_cycle(p, cycle);
    motion->from = angle_or(p, KEY_MOTION_FROM, 0);
    motion->to = last_angle(p, cycle);
    p->d->one_revolution =
        fabs(fabs(motion->to - motion->from) * motion->angle_unit - 2 * M_PI) < 1e-9;
    if (IS_SET(run_up))
        build_run_up(p, run_up);
    if (!flk_section_is_mistaken(p, SECTION_MOTION) && flk_mistakes_count(p->mistakes) == before)
        check_range(p);
}
