/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column_drive.c - the columns of what drives, if not the crank, and of actuators.
*/
#include <gsl/gsl_math.h>

#include "column_list.h"
#include "column_source.h"
#include "mechanics/drive.h"
#include "motion/course.h"

#define INFO(name, q, need, meaning)                                     \
    {                                                                    \
        name, QUANTITY_##q, ALL, need, 0, NULL, VALUE, 0, 0, meaning, "" \
    }

/* The effort, a force or a torque, and the slide of a boom by the name of its cylinder. */
enum { FORCE_OF_DRIVE, CYLINDER_LENGTH, CYLINDER_SPEED, CYLINDER_ACCELERATION, CYLINDER_FORCE };
#define NAMED 5 /* these */
static const flk_column_info named[NAMED] = {
    INFO("drive", FORCE, NEED_FORCES, "force of what drives"),
    INFO("cylinder.length", LENGTH, 0, "slide: length of the cylinder"),
    INFO("cylinder.speed", SPEED, 0, "slide_v: speed at which the cylinder grows"),
    INFO("cylinder.acceleration", ACCELERATION, 0, "slide_a: acceleration of its length"),
    INFO("cylinder.force", FORCE, NEED_FORCES, "push of the cylinder, negative where it pulls")};
static const flk_column_info torque =
    INFO("drive", TORQUE, NEED_FORCES, "torque of what drives, counter-clockwise positive");

/* Those of an actuator; the last three if it drives, the last if it has a bore. */
enum { LENGTH_OF, SPEED_OF, ACCELERATION_OF, FORCE_OF, POWER_OF, PRESSURE_OF };
static const flk_column_info of_actuator[FLK_ACTUATOR_COLUMNS] = {
    INFO("", LENGTH, 0, "length of the actuator"),
    INFO("", SPEED, 0, "speed at which the actuator grows"),
    INFO("", ACCELERATION, 0, "acceleration of its length"),
    INFO("", FORCE, NEED_FORCES, "push of the actuator, negative where it pulls"),
    INFO("", POWER, NEED_FORCES, "power of the actuator"),
    INFO("", PRESSURE, NEED_FORCES, "pressure on the side of its piston that works")};

static size_t count_drives(const deck *d)
{
    return (d->machine.mechanism.drive != NULL) + (d->has_cylinder ? (size_t)CYLINDER_FORCE : 0) +
           FLK_ACTUATOR_COLUMNS * d->n_actuators;
}

/* One of `named`; where a cylinder drives, drive and slide are there by these names only. */
static int make_named(const flk_analysis *a, int i, flk_column *c)
{
    const flk_drive *drive = a->d->machine.mechanism.drive;
    int drives = drive && drive->sort == FLK_DRIVE_SLIDE, is_cylinder = a->d->has_cylinder;
    int is_torque = i == FORCE_OF_DRIVE && drive && flk_drive_is_torque(drive);

    flk_column_start(a->d, is_torque ? &torque : &named[i], c);
    c->of.actuator = NULL;
    c->component = i;
    c->is_usual = i != FORCE_OF_DRIVE || !(is_cylinder && drives);
    return i != CYLINDER_FORCE || drives;
}

static int make_of_drive(const flk_analysis *a, size_t i, flk_column *c)
{
    const flk_drive *drive = a->d->machine.mechanism.drive;
    const flk_actuator *actuator;
    int component;

    if (drive && i-- == 0)
        return make_named(a, FORCE_OF_DRIVE, c);
    if (a->d->has_cylinder && i < CYLINDER_FORCE)
        return make_named(a, CYLINDER_LENGTH + (int)i, c);
    i -= a->d->has_cylinder ? (size_t)CYLINDER_FORCE : 0;
    actuator = &a->d->actuators[i / FLK_ACTUATOR_COLUMNS];
    component = (int)(i % FLK_ACTUATOR_COLUMNS);
    flk_column_start(a->d, &of_actuator[component], c);
    c->name = actuator->column_names[component];
    c->of.actuator = actuator;
    c->component = component;
    c->is_usual = component < FORCE_OF;
    return component < FORCE_OF || (drive && drive->actuator == actuator &&
                                    (component != PRESSURE_OF || actuator->bore > 0));
}

/* Where the actuator pushes, its whole piston works, where it pulls, that less its rod. */
static double pressure_of(const flk_actuator *actuator, double force)
{
    double rod = force < 0 ? actuator->rod_diameter : 0;

    return fabs(force) / (M_PI_4 * (actuator->bore * actuator->bore - rod * rod));
}

/* On the crossed branch, where the slide is negative, the cylinder is on the other side of D. */
static double value_of_named(const flk_column *c, const flk_row *row)
{
    const fourlink_state *state = &row->at.state;
    double sense = (double)state->branch;

    switch (c->component) {
    case CYLINDER_LENGTH:
        return sense * state->slide;
    case CYLINDER_SPEED:
        return sense * state->slide_v;
    case CYLINDER_ACCELERATION:
        return sense * state->slide_a;
    case CYLINDER_FORCE:
        return sense * row->at.forces.drive;
    default:
        return row->at.forces.drive;
    }
}

static double value_of_drive(const flk_column *c, const flk_row *row)
{
    double force = row->at.forces.drive;
    const deck_prescribed *prescribed = c->d->prescribed;
    flk_prescribed given;
    flk_actuator_state at;
    fourlink_row of;

    if (!c->of.actuator)
        return value_of_named(c, row);
    if (c->component == FORCE_OF)
        return force;
    if (c->component == POWER_OF)
        return row->at.forces.at_crank * row->speed;
    if (c->component == PRESSURE_OF)
        return pressure_of(c->of.actuator, force);
    if (prescribed && prescribed->q->actuator == c->of.actuator) {
        flk_course_prescribed_at(prescribed, row->at.row.place, &given, &of);
        at.length = given.value;
        at.speed = given.rate;
        at.acceleration = given.second;
    } else if (flk_actuator_at(c->of.actuator, &row->at.state, &at) != FOURLINK_OK) {
        return GSL_NAN;
    }
    return c->component == LENGTH_OF  ? at.length
           : c->component == SPEED_OF ? at.speed
                                      : at.acceleration;
}

static const char *drive_lacks(const deck *d, size_t i, char words[MESSAGE_SIZE])
{
    (void)words;
    if (i == FORCE_OF_DRIVE)
        return "needs an [actuator], or [motion] input or drive; the crank drives";
    if (i == CYLINDER_FORCE && d->has_cylinder)
        return "needs [motion] drive = slide: the cylinder does not drive";
    return "needs mechanism = boom, or an [actuator cylinder]";
}

const flk_column_source flk_drive_columns = {
    named, NAMED, count_drives, make_of_drive, drive_lacks, value_of_drive, NULL, NULL, 0};
