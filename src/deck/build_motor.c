/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_motor.c - builds [motor] from values.
*/
#include <math.h>

#include "mechanics/inertia.h"
#include "build.h"
#include "build_curve.h"
#include "build_motor.h"
#include "parser.h"
#include "settings.h"

/* Refuse 0, which gives no sense of rotation. */
static void check_not_zero(parser *p, key_code key)
{
    const setting *s = flk_setting_find(p, key);

    if (IS_SET(s) && s->si[0] == 0)
        flk_mistake(p->mistakes, s->place, "the %s must not be 0", flk_key_table[key].name);
}

/* 1 if both of two keys that belong together are set; a mistake if only one is. */
static int has_pair(parser *p, key_code first, key_code second, const char *why)
{
    const setting *a = flk_setting_find(p, first), *b = flk_setting_find(p, second);

    if (IS_SET(a) != IS_SET(b))
        flk_mistake(p->mistakes, (IS_SET(a) ? a : b)->place, "'%s' needs '%s', %s",
                    flk_key_table[IS_SET(a) ? first : second].name,
                    flk_key_table[IS_SET(a) ? second : first].name, why);
    return IS_SET(a) || IS_SET(b);
}

/* T = stall_torque (1 - w / no_load_speed) */
static int has_line(parser *p)
{
    const setting *torque = flk_setting_find(p, KEY_MOTOR_STALL_TORQUE),
                  *speed = flk_setting_find(p, KEY_MOTOR_NO_LOAD_SPEED);

    check_not_zero(p, KEY_MOTOR_STALL_TORQUE);
    check_not_zero(p, KEY_MOTOR_NO_LOAD_SPEED);
    if (torque->si[0] * speed->si[0] < 0)
        flk_mistake(p->mistakes, speed->place,
                    "the no_load_speed must have the sign of the stall_torque");
    return has_pair(p, KEY_MOTOR_STALL_TORQUE, KEY_MOTOR_NO_LOAD_SPEED,
                    "the two ends of the motor's line");
}

static int has_power(parser *p)
{
    check_not_zero(p, KEY_MOTOR_MAX_TORQUE);
    return has_pair(p, KEY_MOTOR_POWER, KEY_MOTOR_MAX_TORQUE,
                    "or the torque would be infinite at rest");
}

static void build_curve(parser *p, const setting *s, fourlink_motor *motor)
{
    size_t n = s->n_points, i;
    double *x;

    if (!s->curve || n < 2) {
        flk_mistake(p->mistakes, s->place,
                    "expected two or more points of speed and torque, such as 0 rpm 5 N m, 1500 "
                    "rpm 0 N m, not '%t'",
                    s->value);
        return;
    }
    x = flk_reader_keep(p, 2 * n * sizeof *x);
    if (!x || !flk_build_is_rising(p, s, 0, "the speeds of the motor's curve do not rise"))
        return;
    for (i = 0; i < n; i++) {
        x[i] = s->curve[i].x;
        x[n + i] = s->curve[i].y[0];
    }
    motor->curve_speed = x;
    motor->curve_torque = x + n;
    motor->n_curve = (unsigned long)n;
}

/* A motor needs a motion that is not given; a motor that balances needs a cycle and its mean speed. */
static void check_mode_of_motor(parser *p, const section_use *use, const fourlink_motor *motor)
{
    int mode = p->d->mode.kind;
    const setting *torque = flk_setting_find(p, KEY_MOTOR_TORQUE),
                  *word = flk_setting_find(p, KEY_MOTION_MODE);

    if (mode == MODE_GIVEN && IS_SET(word) && !flk_text_equal(word->value, "given"))
        return; /* already reported */
    if (mode == MODE_GIVEN)
        flk_mistake(
            p->mistakes, use->place,
            "the motion is given, so that a motor does nothing: [motion] needs mode = free, "
            "run-up or steady");
    else if (motor->kind == FOURLINK_MOTOR_BALANCE && mode != MODE_STEADY)
        flk_mistake(p->mistakes, torque->place,
                    "torque = constant balances the loads over a cycle: it needs mode = steady");
    else if (motor->kind == FOURLINK_MOTOR_BALANCE &&
             !IS_SET(flk_setting_find(p, KEY_MOTION_MEAN_SPEED)))
        flk_mistake(p->mistakes, torque->place,
                    "torque = constant does not determine the speed: [motion] needs a mean_speed");
}

void flk_build_motor(parser *p)
{
    section_use *use = flk_section_find(p, SECTION_MOTOR, NULL);
    const setting *torque = flk_setting_find(p, KEY_MOTOR_TORQUE),
                  *points = flk_setting_find(p, KEY_MOTOR_CURVE);
    fourlink_motor *motor = &p->d->machine.motor;
    size_t before = flk_mistakes_count(p->mistakes);
    int line, power, n;

    if (!use || use->is_mistaken)
        return;
    line = has_line(p);
    power = has_power(p);
    n = line + power + IS_SET(torque) + IS_SET(points);
    if (n == 0)
        flk_mistake(p->mistakes, use->place,
                    "[motor] needs a torque, a stall_torque with no_load_speed, a curve, or a "
                    "power with max_torque");
    if (n > 1)
        flk_mistake(p->mistakes, use->place,
                    "give only one of torque, stall_torque, curve and power");
    check_not_zero(p, KEY_MOTOR_RATIO);
    motor->kind = torque->word     ? FOURLINK_MOTOR_BALANCE
                  : IS_SET(points) ? FOURLINK_MOTOR_CURVE
                  : line           ? FOURLINK_MOTOR_LINEAR
                  : power          ? FOURLINK_MOTOR_POWER
                                   : FOURLINK_MOTOR_TORQUE;
    motor->torque = torque->si[0];
    motor->stall_torque = flk_setting_or(p, KEY_MOTOR_STALL_TORQUE, 0);
    motor->no_load_speed = flk_setting_or(p, KEY_MOTOR_NO_LOAD_SPEED, 0);
    motor->power = flk_setting_or(p, KEY_MOTOR_POWER, 0);
    motor->max_torque = flk_setting_or(p, KEY_MOTOR_MAX_TORQUE, 0);
    motor->inertia = flk_setting_or(p, KEY_MOTOR_INERTIA, 0);
    motor->ratio = flk_setting_or(p, KEY_MOTOR_RATIO, 1);
    if (IS_SET(points))
        build_curve(p, points, motor);
    if (n == 1)
        check_mode_of_motor(p, use, motor);
    use->is_mistaken = flk_mistakes_count(p->mistakes) > before;
}

int flk_build_sense(parser *p)
{
    const fourlink_motor *motor = &p->d->machine.motor;
    double turning = flk_setting_or(p, KEY_MOTION_SPEED, 0);

    if (turning == 0)
        turning = p->d->mode.kind == MODE_GIVEN ? flk_setting_or(p, KEY_MOTION_ACCELERATION, 0)
                                                : flk_setting_or(p, KEY_MOTION_MEAN_SPEED, 0);
    if (turning == 0 && (motor->kind != FOURLINK_MOTOR_CURVE || motor->n_curve))
        turning = flk_motor_torque(motor, 0, 0);
    if (flk_setting_find(p, KEY_MOTION_INPUT)->word &&
        flk_setting_find(p, KEY_MOTION_SIDE)->word == FOURLINK_FALLING)
        turning = -turning;
    return turning < 0 ? -1 : 1;
}
