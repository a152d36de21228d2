/* SPDX-License-Identifier: GPL-3.0-or-later
**
** motor.c - the torque of a motor as a function of its speed.
**
** The crank turns at omega2, the motor at ratio omega2, and its torque on the crank is ratio T:
**
**    constant   T = torque
**    linear     T = stall_torque (1 - w / no_load_speed); brakes above the no-load speed
**    curve      Steffen's interpolation; constant beyond the ends
**    power      T = power / w, at most max_torque, in the sense of max_torque
*/
#include <float.h>
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/steffen.h"
#include "inertia.h"

/* The speed above which the power limits the torque. */
static double knee_of(const fourlink_motor *motor)
{
    return motor->power / motor->max_torque;
}

static double of_power(const fourlink_motor *motor, double w, double within)
{
    double turning = motor->max_torque < 0 ? -within : within;

    return turning * fabs(motor->max_torque) > motor->power ? motor->power / w : motor->max_torque;
}

/* 1 if the numbers that this kind of motor uses are in range. */
static int has_numbers(const fourlink_motor *motor)
{
    unsigned long i;

    if (motor->kind != FOURLINK_NO_MOTOR && !FLK_WITHIN(motor->ratio, FOURLINK_NUMBER_MAX))
        return 0;
    switch (motor->kind) {
    case FOURLINK_MOTOR_TORQUE:
    case FOURLINK_MOTOR_BALANCE:
        return FLK_WITHIN(motor->torque, FOURLINK_NUMBER_MAX);
    case FOURLINK_MOTOR_LINEAR:
        return FLK_WITHIN(motor->stall_torque, FOURLINK_NUMBER_MAX) &&
               FLK_WITHIN(motor->no_load_speed, FOURLINK_NUMBER_MAX);
    case FOURLINK_MOTOR_POWER:
        return FLK_WITHIN(motor->power, FOURLINK_NUMBER_MAX) &&
               FLK_WITHIN(motor->max_torque, FOURLINK_NUMBER_MAX);
    case FOURLINK_MOTOR_CURVE:
        for (i = 0; i < motor->n_curve && motor->curve_speed && motor->curve_torque; i++)
            if (!FLK_WITHIN(motor->curve_speed[i], FOURLINK_NUMBER_MAX) ||
                !FLK_WITHIN(motor->curve_torque[i], FOURLINK_NUMBER_MAX))
                return 0;
        return 1;
    default:
        return 1;
    }
}

static int is_valid(const fourlink_motor *motor)
{
    unsigned long i;

    if (motor->kind == FOURLINK_NO_MOTOR)
        return 1;
    if (motor->ratio == 0 || (motor->kind == FOURLINK_MOTOR_LINEAR && motor->no_load_speed == 0) ||
        (motor->kind == FOURLINK_MOTOR_POWER && motor->power <= 0))
        return 0;
    if (motor->kind == FOURLINK_MOTOR_CURVE) {
        for (i = 1; i < motor->n_curve && motor->curve_speed && motor->curve_torque; i++)
            if (!(motor->curve_speed[i - 1] < motor->curve_speed[i]))
                return 0;
        return i == motor->n_curve && i > 1;
    }
    return motor->kind > FOURLINK_NO_MOTOR && motor->kind <= FOURLINK_MOTOR_BALANCE;
}

double flk_motor_torque(const fourlink_motor *motor, double omega2, double within)
{
    double w = motor->ratio * omega2;

    switch (motor->kind) {
    case FOURLINK_MOTOR_TORQUE:
    case FOURLINK_MOTOR_BALANCE:
        return motor->ratio * motor->torque;
    case FOURLINK_MOTOR_LINEAR:
        return motor->ratio * motor->stall_torque * (1 - w / motor->no_load_speed);
    case FOURLINK_MOTOR_CURVE:
        return motor->ratio * flk_steffen_on(motor->curve_speed, motor->curve_torque,
                                             motor->n_curve, w, motor->ratio * within);
    case FOURLINK_MOTOR_POWER:
        return motor->ratio * of_power(motor, w, motor->ratio * within);
    default:
        return 0;
    }
}

void flk_motor_piece(const fourlink_motor *motor, double within, double *low, double *high)
{
    double knee = motor->kind == FOURLINK_MOTOR_POWER ? knee_of(motor) : 0, level;
    const double *levels = motor->kind == FOURLINK_MOTOR_CURVE ? motor->curve_speed : &knee;
    unsigned long n = motor->kind == FOURLINK_MOTOR_CURVE   ? motor->n_curve
                      : motor->kind == FOURLINK_MOTOR_POWER ? 1
                                                            : 0,
                  i;

    *low = GSL_NEGINF;
    *high = GSL_POSINF;
    for (i = 0; i < n; i++) {
        level = levels[i] / motor->ratio;
        if (level <= within)
            *low = GSL_MAX(*low, level);
        else
            *high = GSL_MIN(*high, level);
    }
}

int fourlink_motor_torque(const fourlink_motor *motor, double omega2, double *torque)
{
    double found;

    if (!motor || !torque)
        return FOURLINK_NULL;
    if (!FLK_WITHIN(omega2, FOURLINK_NUMBER_MAX) || !has_numbers(motor))
        return FOURLINK_BAD_NUMBER;
    if (!is_valid(motor))
        return FOURLINK_BAD_MOTOR;
    found = flk_motor_torque(motor, omega2, omega2);
    if (!FLK_WITHIN(found, DBL_MAX))
        return FOURLINK_BAD_NUMBER;
    *torque = found;
    return FOURLINK_OK;
}
