/* SPDX-License-Identifier: GPL-3.0-or-later
**
** schema.h - the sections and keys that a deck can have, and the values they take.
*/
#ifndef FOURLINK_SCHEMA_H
#define FOURLINK_SCHEMA_H

#include "fourlink.h"
#include "base/units.h"
#include "mechanics/variable.h"

/* name, 1 if it may repeat, mechanisms, its first key in KEY_LIST, which has the sections in this order */
#define INVERTED FOURLINK_INVERTED_SLIDER_CRANK
#define ANY_KIND FLK_EVERY_KIND
#define SCOTCH_YOKE FOURLINK_SCOTCH_YOKE
#define WITH_GUIDE (FOURLINK_SLIDER_CRANK | INVERTED | SCOTCH_YOKE)
#define WITH_STROKE (FOURLINK_SLIDER_CRANK | SCOTCH_YOKE)
#define WITH_SLOT (INVERTED | SCOTCH_YOKE)
#define WITH_TASKS (FOURLINK_FOUR_BAR | FOURLINK_SLIDER_CRANK | INVERTED)
#define WITH_PIN_C (FOURLINK_FOUR_BAR | FOURLINK_SLIDER_CRANK)
#define WITH_PIN_D (FOURLINK_FOUR_BAR | INVERTED)
#define SECTION_LIST(X)                                             \
    X(TOP, "", 0, ANY_KIND, KEY_TOP_TITLE)                          \
    X(UNITS, "units", 0, ANY_KIND, KEY_UNITS_LENGTH)                \
    X(PINS, "pins", 0, ANY_KIND, KEY_PINS_A)                        \
    X(GROUND, "ground", 0, ANY_KIND, KEY_GROUND_LENGTH)             \
    X(CRANK, "crank", 0, ANY_KIND, KEY_CRANK_LENGTH)                \
    X(COUPLER, "coupler", 0, FOURLINK_FOUR_BAR, KEY_COUPLER_LENGTH) \
    X(ROCKER, "rocker", 0, FOURLINK_FOUR_BAR, KEY_ROCKER_LENGTH)    \
    X(ROD, "rod", 0, FOURLINK_SLIDER_CRANK, KEY_ROD_LENGTH)         \
    X(PISTON, "piston", 0, FOURLINK_SLIDER_CRANK, KEY_PISTON_MASS)  \
    X(SLIDER, "slider", 0, WITH_SLOT, KEY_SLIDER_MASS)              \
    X(LEVER, "lever", 0, INVERTED, KEY_LEVER_OFFSET)                \
    X(YOKE, "yoke", 0, SCOTCH_YOKE, KEY_YOKE_ANGLE)                 \
    X(OUTPUT, "output", 1, ANY_KIND, KEY_OUTPUT_LINK)               \
    X(GAS, "gas", 0, WITH_GUIDE, KEY_GAS_BORE)                      \
    X(MOTION, "motion", 0, ANY_KIND, KEY_MOTION_SPEED)              \
    X(MOTOR, "motor", 0, ANY_KIND, KEY_MOTOR_TORQUE)                \
    X(GRAVITY, "gravity", 0, ANY_KIND, KEY_GRAVITY_ACCELERATION)    \
    X(LOAD, "load", 1, ANY_KIND, KEY_LOAD_LINK)                     \
    X(SPRING, "spring", 1, ANY_KIND, KEY_SPRING_LINK)               \
    X(ACTUATOR, "actuator", 1, ANY_KIND, KEY_ACTUATOR_LINK)         \
    X(FRICTION, "friction", 0, ANY_KIND, KEY_FRICTION_MU)           \
    X(BALANCE, "balance", 0, ANY_KIND, KEY_BALANCE_CRANK)           \
    X(POINT, "point", 1, ANY_KIND, KEY_POINT_LINK)                  \
    X(TABLE, "table", 0, ANY_KIND, KEY_TABLE_BRANCH)                \
    X(FLYWHEEL, "flywheel", 0, ANY_KIND, KEY_FLYWHEEL_FLUCTUATION)  \
    X(SYNTHESIS, "synthesis", 0, WITH_TASKS, KEY_SYNTHESIS_TASK)    \
    X(SWEEP, "sweep", 0, ANY_KIND, KEY_SWEEP_SAMPLES)               \
    X(GRADING, "grading", 0, ANY_KIND, KEY_GRADING_TOLERANCE)       \
    X(EXPECT, "expect", 1, ANY_KIND, KEY_EXPECT_AT)                 \
    X(MISPRINT, "misprint", 1, ANY_KIND, KEY_MISPRINT_AT)

/* The form of a value. */
typedef enum value_form {
    FORM_TEXT,     /* as written, or in double quotes */
    FORM_WORD,     /* one of a list of words */
    FORM_LINK,     /* a link that moves, NAME or NAME.rod of an [output] */
    FORM_BODY,     /* a link that moves, or the ground */
    FORM_UNIT,     /* a unit of the quantity */
    FORM_QUANTITY, /* a number with a unit */
    FORM_VECTOR,   /* 10 N at 30 deg, or (10, 5) N; or a curve of it */
    FORM_POINT,    /* a point of a link: 10 mm at 30 deg, (10, 5) mm, 10 mm, 50 %, mid, ... */
    FORM_PLACE,    /* a place on the page: (41, 37.5) mm, 140 mm at 30 deg */
    FORM_LINE,     /* two places on the page */
    FORM_CRANK,    /* a crank angle, or `drawn`; of an instant also `theta2 = 60 deg` */
    FORM_CURVE,    /* a quantity, or a curve of it over the crank angle */
    FORM_COUNT,    /* a whole number */
    FORM_EITHER    /* a quantity or another one, by its unit; see flk_quantity_of_key */
} value_form;

typedef enum value_sign { SIGN_ANY, SIGN_NOT_NEGATIVE, SIGN_POSITIVE } value_sign;

#define LINK_KEYS(X, S)                                                    \
    X(S, LENGTH, "length", QUANTITY, LENGTH, POSITIVE, ANY_KIND, "length") \
    MASS_KEYS(X, S)                                                        \
    X(S, UNIFORM, "uniform", WORD, NUMBER, ANY, ANY_KIND, "a uniform bar")

#define MASS_KEYS(X, S)                                                                            \
    X(S, MASS, "mass", QUANTITY, MASS, NOT_NEGATIVE, ANY_KIND, "mass")                             \
    X(S, GYRATION, "gyration", QUANTITY, LENGTH, NOT_NEGATIVE, ANY_KIND,                           \
      "gyration about the centre of mass")                                                         \
    X(S, INERTIA, "inertia", QUANTITY, INERTIA, NOT_NEGATIVE, ANY_KIND,                            \
      "inertia about the centre of mass")                                                          \
    X(S, CG, "cg", POINT, LENGTH, ANY, ANY_KIND, "centre of mass: x along, y to the left")         \
    X(S, CG_PLACE, "cg_place", PLACE, LENGTH, ANY, ANY_KIND, "centre of mass as drawn")            \
    X(S, SWING_PERIOD, "swing_period", QUANTITY, TIME, POSITIVE, ANY_KIND, "period as a pendulum") \
    X(S, SWING_PIN, "swing_pin", POINT, LENGTH, ANY, ANY_KIND, "where it hangs as a pendulum")

/* The masses of the links of an [output]: of slider or rocker, of the rod. */
#define OUTPUT_MASS_KEYS(X, CODE, name, of)                                               \
    X(OUTPUT, CODE##MASS, name "mass", QUANTITY, MASS, NOT_NEGATIVE, ANY_KIND, "mass" of) \
    X(OUTPUT, CODE##GYRATION, name "gyration", QUANTITY, LENGTH, NOT_NEGATIVE, ANY_KIND,  \
      "gyration about the centre of mass" of)                                             \
    X(OUTPUT, CODE##INERTIA, name "inertia", QUANTITY, INERTIA, NOT_NEGATIVE, ANY_KIND,   \
      "inertia about the centre of mass" of)                                              \
    X(OUTPUT, CODE##CG, name "cg", POINT, LENGTH, ANY, ANY_KIND, "centre of mass" of)     \
    X(OUTPUT, CODE##UNIFORM, name "uniform", WORD, NUMBER, ANY, ANY_KIND, "a uniform bar" of)

/* Sections that accept names in addition to their keys: columns and facts, or keys of the deck. */
#define TAKES_NAMES(section)                                                                       \
    ((section) == SECTION_EXPECT || (section) == SECTION_MISPRINT || (section) == SECTION_SWEEP || \
     (section) == SECTION_GRADING)

/* In addition to these, any column or fact. */
#define EXPECT_KEYS(X, S)                                                         \
    X(S, AT, "at", CRANK, ANGLE, ANY, ANY_KIND, "crank angle or time of the row") \
    X(S, BRANCH, "branch", WORD, NUMBER, ANY, ANY_KIND, "the assembly mode")      \
    X(S, SIDE, "side", WORD, NUMBER, ANY, ANY_KIND, "the side of the input")      \
    X(S, TOLERANCE, "tolerance", TEXT, NUMBER, ANY, ANY_KIND, "tolerance of its values")

#define A_UNIT "unit of results and of bare numbers"

/* section, key, its name, form, quantity, sign, mechanisms, meaning */
#define KEY_LIST(X)                                                                                \
    X(TOP, TITLE, "title", TEXT, NUMBER, ANY, ANY_KIND, "title of tables, pictures and reports")   \
    X(TOP, MECHANISM, "mechanism", WORD, NUMBER, ANY, ANY_KIND, "the kind of mechanism")           \
    X(TOP, SERIES, "series", WORD, NUMBER, ANY, FOURLINK_SLIDER_CRANK,                             \
      "the approximation of the piston")                                                           \
    X(TOP, SOLVER, "solver", WORD, NUMBER, ANY, ANY_KIND, "how the forces are computed")           \
    X(TOP, AXES, "axes", WORD, NUMBER, ANY, ANY_KIND, "the axes of directions and places")         \
    X(UNITS, LENGTH, "length", UNIT, LENGTH, ANY, ANY_KIND, A_UNIT)                                \
    X(UNITS, ANGLE, "angle", UNIT, ANGLE, ANY, ANY_KIND, A_UNIT)                                   \
    X(UNITS, MASS, "mass", UNIT, MASS, ANY, ANY_KIND, A_UNIT)                                      \
    X(UNITS, TIME, "time", UNIT, TIME, ANY, ANY_KIND, A_UNIT)                                      \
    X(UNITS, SPEED, "speed", UNIT, SPEED, ANY, ANY_KIND, A_UNIT)                                   \
    X(UNITS, ACCELERATION, "acceleration", UNIT, ACCELERATION, ANY, ANY_KIND, A_UNIT)              \
    X(UNITS, ANGULAR_SPEED, "angular_speed", UNIT, ANGULAR_SPEED, ANY, ANY_KIND, A_UNIT)           \
    X(UNITS, ANGULAR_ACCELERATION, "angular_acceleration", UNIT, ANGULAR_ACCELERATION, ANY,        \
      ANY_KIND, A_UNIT)                                                                            \
    X(UNITS, INERTIA, "inertia", UNIT, INERTIA, ANY, ANY_KIND, A_UNIT)                             \
    X(UNITS, FORCE, "force", UNIT, FORCE, ANY, ANY_KIND, A_UNIT)                                   \
    X(UNITS, TORQUE, "torque", UNIT, TORQUE, ANY, ANY_KIND, A_UNIT)                                \
    X(UNITS, PRESSURE, "pressure", UNIT, PRESSURE, ANY, ANY_KIND, A_UNIT)                          \
    X(UNITS, POWER, "power", UNIT, POWER, ANY, ANY_KIND, A_UNIT)                                   \
    X(UNITS, ENERGY, "energy", UNIT, ENERGY, ANY, ANY_KIND, A_UNIT)                                \
    X(UNITS, STIFFNESS, "stiffness", UNIT, STIFFNESS, ANY, ANY_KIND, A_UNIT)                       \
    X(UNITS, DAMPING, "damping", UNIT, DAMPING, ANY, ANY_KIND, A_UNIT)                             \
    X(UNITS, TORSIONAL_STIFFNESS, "torsional_stiffness", UNIT, TORSIONAL_STIFFNESS, ANY, ANY_KIND, \
      A_UNIT)                                                                                      \
    X(UNITS, TORSIONAL_DAMPING, "torsional_damping", UNIT, TORSIONAL_DAMPING, ANY, ANY_KIND,       \
      A_UNIT)                                                                                      \
    X(UNITS, MASS_MOMENT, "mass_moment", UNIT, MASS_MOMENT, ANY, ANY_KIND, A_UNIT)                 \
    X(UNITS, VOLUME, "volume", UNIT, VOLUME, ANY, ANY_KIND, A_UNIT)                                \
    X(PINS, A, "A", PLACE, LENGTH, ANY, ANY_KIND, "place of pin A")                                \
    X(PINS, B, "B", PLACE, LENGTH, ANY, ANY_KIND, "place of pin B")                                \
    X(PINS, C, "C", PLACE, LENGTH, ANY, WITH_TASKS, "place of pin C")                              \
    X(PINS, D, "D", PLACE, LENGTH, ANY, WITH_PIN_D, "place of pin D")                              \
    X(PINS, GUIDE, "guide", LINE, LENGTH, ANY, WITH_STROKE,                                        \
      "two points of the line of stroke or guide")                                                 \
    X(PINS, ROUGH, "rough", WORD, NUMBER, ANY, ANY_KIND, "the lengths hold, not the places")       \
    X(GROUND, LENGTH, "length", QUANTITY, LENGTH, POSITIVE, WITH_PIN_D, "length")                  \
    X(GROUND, OFFSET, "offset", QUANTITY, LENGTH, ANY, WITH_STROKE,                                \
      "offset of the line of stroke or guide")                                                     \
    X(GROUND, TO, "to", PLACE, LENGTH, ANY, WITH_PIN_D, "D, seen from A")                          \
    X(GROUND, ANGLE, "angle", QUANTITY, ANGLE, ANY, ANY_KIND, "direction of the ground link")      \
    LINK_KEYS(X, CRANK)                                                                            \
    X(CRANK, STROKE, "stroke", QUANTITY, LENGTH, POSITIVE, WITH_STROKE,                            \
      "stroke of the piston or yoke")                                                              \
    LINK_KEYS(X, COUPLER)                                                                          \
    LINK_KEYS(X, ROCKER)                                                                           \
    LINK_KEYS(X, ROD)                                                                              \
    X(PISTON, MASS, "mass", QUANTITY, MASS, NOT_NEGATIVE, ANY_KIND, "mass")                        \
    X(PISTON, CG, "cg", POINT, LENGTH, ANY, ANY_KIND, "centre of mass: x along, y to the left")    \
    X(PISTON, CG_PLACE, "cg_place", PLACE, LENGTH, ANY, ANY_KIND, "centre of mass as drawn")       \
    MASS_KEYS(X, SLIDER)                                                                           \
    X(LEVER, OFFSET, "offset", QUANTITY, LENGTH, ANY, ANY_KIND,                                    \
      "distance at which the slide passes D")                                                      \
    X(LEVER, ANGLE, "angle", QUANTITY, ANGLE, ANY, ANY_KIND,                                       \
      "angle of the slide from the line D-C")                                                      \
    LINK_KEYS(X, LEVER)                                                                            \
    X(YOKE, ANGLE, "angle", QUANTITY, ANGLE, ANY, ANY_KIND, "angle of the slot from the guide")    \
    MASS_KEYS(X, YOKE)                                                                             \
    X(OUTPUT, LINK, "link", LINK, NUMBER, ANY, ANY_KIND, "the link that carries it")               \
    X(OUTPUT, AT, "at", POINT, LENGTH, ANY, ANY_KIND, "the point P of that link")                  \
    X(OUTPUT, PLACE, "place", PLACE, LENGTH, ANY, ANY_KIND, "P as drawn")                          \
    X(OUTPUT, ROD, "rod", QUANTITY, LENGTH, POSITIVE, ANY_KIND, "length of its rod, from P to Q")  \
    X(OUTPUT, LINE, "line", PLACE, LENGTH, ANY, ANY_KIND, "slider: a point of its line of stroke") \
    X(OUTPUT, ANGLE, "angle", QUANTITY, ANGLE, ANY, ANY_KIND, "slider: direction of that line")    \
    X(OUTPUT, PIVOT, "pivot", PLACE, LENGTH, ANY, ANY_KIND, "rocker: its fixed pin")               \
    X(OUTPUT, TO, "to", LINK, NUMBER, ANY, ANY_KIND, "rocker: the link that its pin is on")        \
    X(OUTPUT, TO_AT, "to_at", POINT, LENGTH, ANY, ANY_KIND, "rocker: its pin on that link")        \
    X(OUTPUT, TO_PLACE, "to_place", PLACE, LENGTH, ANY, ANY_KIND, "its pin there as drawn")        \
    X(OUTPUT, LENGTH, "length", QUANTITY, LENGTH, POSITIVE, ANY_KIND, "rocker: length")            \
    X(OUTPUT, SIDE, "side", WORD, NUMBER, ANY, ANY_KIND, "the assembly mode")                      \
    OUTPUT_MASS_KEYS(X, END_, "", "")                                                              \
    OUTPUT_MASS_KEYS(X, ROD_, "rod_", ", of the rod")                                              \
    X(OUTPUT, SLOT, "slot", WORD, NUMBER, ANY, ANY_KIND, "what has the slot, instead of a rod")    \
    X(OUTPUT, SLOT_ANGLE, "slot_angle", QUANTITY, ANGLE, ANY, ANY_KIND,                            \
      "direction of the slot, from the line or in the link")                                       \
    X(OUTPUT, OFFSET, "offset", QUANTITY, LENGTH, ANY, ANY_KIND,                                   \
      "rocker with a slot: distance at which this passes its pin")                                 \
    X(OUTPUT, END_CG_PLACE, "cg_place", PLACE, LENGTH, ANY, ANY_KIND, "centre of mass as drawn")   \
    X(OUTPUT, ROD_CG_PLACE, "rod_cg_place", PLACE, LENGTH, ANY, ANY_KIND,                          \
      "centre of mass of the rod as drawn")                                                        \
    X(GAS, BORE, "bore", QUANTITY, LENGTH, POSITIVE, ANY_KIND, "diameter of the cylinder")         \
    X(GAS, PRESSURE, "pressure", QUANTITY, PRESSURE, ANY, ANY_KIND, "pressure on the cover side")  \
    X(GAS, INDICATOR, "indicator", CURVE, PRESSURE, ANY, ANY_KIND, "pressure on the cover side")   \
    X(GAS, BACK_PRESSURE, "back_pressure", QUANTITY, PRESSURE, ANY, ANY_KIND,                      \
      "pressure on the crank side")                                                                \
    X(GAS, PISTON_ROD, "piston_rod", QUANTITY, LENGTH, NOT_NEGATIVE, ANY_KIND,                     \
      "diameter of the piston rod")                                                                \
    X(GAS, CLEARANCE, "clearance", EITHER, LENGTH, POSITIVE, WITH_STROKE,                          \
      "clearance at the inner dead centre")                                                        \
    X(MOTION, SPEED, "speed", QUANTITY, ANGULAR_SPEED, ANY, ANY_KIND, "speed of the crank")        \
    X(MOTION, ACCELERATION, "acceleration", QUANTITY, ANGULAR_ACCELERATION, ANY, ANY_KIND,         \
      "acceleration of the crank")                                                                 \
    X(MOTION, FROM, "from", CRANK, ANGLE, ANY, ANY_KIND, "first crank angle")                      \
    X(MOTION, TO, "to", CRANK, ANGLE, ANY, ANY_KIND, "last crank angle")                           \
    X(MOTION, INTERVAL, "interval", QUANTITY, ANGLE, POSITIVE, ANY_KIND,                           \
      "interval of the crank angle")                                                               \
    X(MOTION, CYCLE, "cycle", QUANTITY, ANGLE, POSITIVE, ANY_KIND, "period of curves and loads")   \
    X(MOTION, AT, "at", CRANK, ANGLE, ANY, ANY_KIND, "crank angle")                                \
    X(MOTION, RUN_UP, "run_up", QUANTITY, ANGLE, POSITIVE, ANY_KIND,                               \
      "angle of the run-up from rest")                                                             \
    X(MOTION, HOLD, "hold", WORD, NUMBER, ANY, ANY_KIND, "this speed and acceleration throughout") \
    X(MOTION, INPUT, "input", WORD, NUMBER, ANY, ANY_KIND, "what is prescribed")                   \
    X(MOTION, DRIVE, "drive", TEXT, NUMBER, ANY, ANY_KIND, "what drives")                          \
    X(MOTION, SIDE, "side", WORD, NUMBER, ANY, ANY_KIND,                                           \
      "whether the input rises or falls as the crank turns counter-clockwise")                     \
    X(MOTION, NEAR, "near", CRANK, ANGLE, ANY, ANY_KIND, "a crank angle of the stretch meant")     \
    X(MOTION, MODE, "mode", WORD, NUMBER, ANY, ANY_KIND, "how the crank's speed is determined")    \
    X(MOTION, PROGRAM, "program", TEXT, NUMBER, ANY, ANY_KIND,                                     \
      "the crank angle or the input, over time")                                                   \
    X(MOTION, LAW, "law", TEXT, NUMBER, ANY, ANY_KIND, "the law between the points of a program")  \
    X(MOTION, ENDS, "ends", TEXT, NUMBER, ANY, ANY_KIND, "how the spline of a program ends")       \
    X(MOTION, PROGRAM_OF, "program_of", WORD, NUMBER, ANY, ANY_KIND,                               \
      "what the points of a program are")                                                          \
    X(MOTION, MEAN_SPEED, "mean_speed", QUANTITY, ANGULAR_SPEED, ANY, ANY_KIND, "mean over time")  \
    X(MOTION, TURNS, "turns", QUANTITY, NUMBER, ANY, ANY_KIND, "turns of the crank")               \
    X(MOTION, ROWS, "rows", WORD, NUMBER, ANY, ANY_KIND, "rows by angle or by time")               \
    X(MOTION, TIME_STEP, "time_step", QUANTITY, TIME, POSITIVE, ANY_KIND,                          \
      "interval of rows by time")                                                                  \
    X(MOTION, DURATION, "duration", QUANTITY, TIME, POSITIVE, ANY_KIND, "time of the last row")    \
    X(MOTOR, TORQUE, "torque", QUANTITY, TORQUE, ANY, ANY_KIND, "torque of the motor")             \
    X(MOTOR, STALL_TORQUE, "stall_torque", QUANTITY, TORQUE, ANY, ANY_KIND, "torque at rest")      \
    X(MOTOR, NO_LOAD_SPEED, "no_load_speed", QUANTITY, ANGULAR_SPEED, ANY, ANY_KIND,               \
      "speed without torque")                                                                      \
    X(MOTOR, CURVE, "curve", CURVE, TORQUE, ANY, ANY_KIND, "torque over the motor's speed")        \
    X(MOTOR, POWER, "power", QUANTITY, POWER, POSITIVE, ANY_KIND, "power of the motor")            \
    X(MOTOR, MAX_TORQUE, "max_torque", QUANTITY, TORQUE, ANY, ANY_KIND, "largest torque")          \
    X(MOTOR, INERTIA, "inertia", QUANTITY, INERTIA, NOT_NEGATIVE, ANY_KIND,                        \
      "moment of inertia of the rotor")                                                            \
    X(MOTOR, RATIO, "ratio", QUANTITY, NUMBER, ANY, ANY_KIND,                                      \
      "speed of the motor / speed of the crank")                                                   \
    X(GRAVITY, ACCELERATION, "acceleration", QUANTITY, ACCELERATION, NOT_NEGATIVE, ANY_KIND,       \
      "acceleration of free fall")                                                                 \
    X(GRAVITY, DIRECTION, "direction", QUANTITY, ANGLE, ANY, ANY_KIND, "direction of free fall")   \
    X(LOAD, LINK, "link", LINK, NUMBER, ANY, ANY_KIND, "the link it acts on")                      \
    X(LOAD, FORCE, "force", VECTOR, FORCE, ANY, ANY_KIND, "force")                                 \
    X(LOAD, AT, "at", POINT, LENGTH, ANY, ANY_KIND, "where it acts")                               \
    X(LOAD, PLACE, "place", PLACE, LENGTH, ANY, ANY_KIND, "where it acts as drawn")                \
    X(LOAD, TORQUE, "torque", CURVE, TORQUE, ANY, ANY_KIND, "torque, counter-clockwise positive")  \
    X(LOAD, FRAME, "frame", WORD, NUMBER, ANY, ANY_KIND, "what the force turns with")              \
    X(LOAD, FROM, "from", CRANK, ANGLE, ANY, ANY_KIND, "first crank angle at which it acts")       \
    X(LOAD, TO, "to", CRANK, ANGLE, ANY, ANY_KIND, "last crank angle at which it acts")            \
    X(LOAD, OVER, "over", WORD, NUMBER, ANY, ANY_KIND, "what the load follows")                    \
    X(LOAD, BACK, "back", CURVE, TORQUE, ANY, ANY_KIND, "its values where that falls")             \
    X(LOAD, EXPONENT, "exponent", QUANTITY, NUMBER, POSITIVE, ANY_KIND, "of the speed")            \
    X(LOAD, AT_SPEED, "at_speed", QUANTITY, SPEED, POSITIVE, ANY_KIND,                             \
      "the speed at which it has its value")                                                       \
    X(SPRING, LINK, "link", BODY, NUMBER, ANY, ANY_KIND, "the link it acts on")                    \
    X(SPRING, AT, "at", POINT, LENGTH, ANY, ANY_KIND, "its end there")                             \
    X(SPRING, PLACE, "place", PLACE, LENGTH, ANY, ANY_KIND, "its end there as drawn")              \
    X(SPRING, TO, "to", BODY, NUMBER, ANY, ANY_KIND, "the other link, or the ground")              \
    X(SPRING, TO_AT, "to_at", POINT, LENGTH, ANY, ANY_KIND, "its end there")                       \
    X(SPRING, TO_PLACE, "to_place", PLACE, LENGTH, ANY, ANY_KIND, "its end there as drawn")        \
    X(SPRING, STIFFNESS, "stiffness", EITHER, STIFFNESS, ANY, ANY_KIND, "stiffness")               \
    X(SPRING, FREE_LENGTH, "free_length", QUANTITY, LENGTH, NOT_NEGATIVE, ANY_KIND,                \
      "length without load")                                                                       \
    X(SPRING, FREE_ANGLE, "free_angle", QUANTITY, ANGLE, ANY, ANY_KIND, "angle without load")      \
    X(SPRING, PRELOAD, "preload", EITHER, FORCE, ANY, ANY_KIND,                                    \
      "load at the free length or angle")                                                          \
    X(SPRING, DAMPING, "damping", EITHER, DAMPING, NOT_NEGATIVE, ANY_KIND, "damping")              \
    X(SPRING, ONLY, "only", WORD, NUMBER, ANY, ANY_KIND,                                           \
      "when it acts: below its free length or angle, or above it")                                 \
    X(ACTUATOR, LINK, "link", BODY, NUMBER, ANY, ANY_KIND, "the link of one end")                  \
    X(ACTUATOR, AT, "at", POINT, LENGTH, ANY, ANY_KIND, "its end there")                           \
    X(ACTUATOR, PLACE, "place", PLACE, LENGTH, ANY, ANY_KIND, "its end there as drawn")            \
    X(ACTUATOR, TO, "to", BODY, NUMBER, ANY, ANY_KIND, "the other link, or the ground")            \
    X(ACTUATOR, TO_AT, "to_at", POINT, LENGTH, ANY, ANY_KIND, "its end there")                     \
    X(ACTUATOR, TO_PLACE, "to_place", PLACE, LENGTH, ANY, ANY_KIND, "its end there as drawn")      \
    X(ACTUATOR, BORE, "bore", QUANTITY, LENGTH, POSITIVE, ANY_KIND, "diameter of its piston")      \
    X(ACTUATOR, ROD_DIAMETER, "rod_diameter", QUANTITY, LENGTH, POSITIVE, ANY_KIND,                \
      "diameter of its rod")                                                                       \
    X(FRICTION, MU, "mu", QUANTITY, NUMBER, NOT_NEGATIVE, ANY_KIND,                                \
      "coefficient of friction of all pins")                                                       \
    X(FRICTION, RADIUS, "radius", QUANTITY, LENGTH, POSITIVE, ANY_KIND, "radius of all pins")      \
    X(FRICTION, A, "A", QUANTITY, NUMBER, NOT_NEGATIVE, ANY_KIND,                                  \
      "coefficient of friction of pin A")                                                          \
    X(FRICTION, B, "B", QUANTITY, NUMBER, NOT_NEGATIVE, ANY_KIND,                                  \
      "coefficient of friction of pin B")                                                          \
    X(FRICTION, C, "C", QUANTITY, NUMBER, NOT_NEGATIVE, WITH_PIN_C,                                \
      "coefficient of friction of pin C")                                                          \
    X(FRICTION, D, "D", QUANTITY, NUMBER, NOT_NEGATIVE, WITH_PIN_D,                                \
      "coefficient of friction of pin D")                                                          \
    X(FRICTION, RADIUS_A, "radius_A", QUANTITY, LENGTH, POSITIVE, ANY_KIND, "radius of pin A")     \
    X(FRICTION, RADIUS_B, "radius_B", QUANTITY, LENGTH, POSITIVE, ANY_KIND, "radius of pin B")     \
    X(FRICTION, RADIUS_C, "radius_C", QUANTITY, LENGTH, POSITIVE, WITH_PIN_C, "radius of pin C")   \
    X(FRICTION, RADIUS_D, "radius_D", QUANTITY, LENGTH, POSITIVE, WITH_PIN_D, "radius of pin D")   \
    X(FRICTION, GUIDE, "guide", QUANTITY, NUMBER, NOT_NEGATIVE, WITH_GUIDE,                        \
      "coefficient of friction of the guide")                                                      \
    X(FRICTION, GUIDE_LENGTH, "guide_length", QUANTITY, LENGTH, POSITIVE, WITH_GUIDE,              \
      "length of the guided block")                                                                \
    X(FRICTION, SLOT, "slot", QUANTITY, NUMBER, NOT_NEGATIVE, SCOTCH_YOKE,                         \
      "coefficient of friction of the slot")                                                       \
    X(FRICTION, SLOT_LENGTH, "slot_length", QUANTITY, LENGTH, POSITIVE, SCOTCH_YOKE,               \
      "length of the block in the slot")                                                           \
    X(FRICTION, DIRECTION, "direction", WORD, NUMBER, ANY, ANY_KIND,                               \
      "which way it moves at a row of speed 0")                                                    \
    X(BALANCE, CRANK, "crank", WORD, NUMBER, ANY, ANY_KIND, "a counterweight on the crank")        \
    X(BALANCE, ROCKER, "rocker", WORD, NUMBER, ANY, WITH_PIN_D,                                    \
      "a counterweight on the rocker or lever")                                                    \
    X(BALANCE, FRACTION, "fraction", QUANTITY, NUMBER, NOT_NEGATIVE, WITH_STROKE,                  \
      "balanced share of reciprocating mass")                                                      \
    X(BALANCE, RADIUS, "radius", QUANTITY, LENGTH, POSITIVE, ANY_KIND,                             \
      "radius of the counterweights")                                                              \
    X(BALANCE, APPLY, "apply", WORD, NUMBER, ANY, ANY_KIND,                                        \
      "the counterweights are in the results")                                                     \
    X(POINT, LINK, "link", LINK, NUMBER, ANY, ANY_KIND, "the link it is on")                       \
    X(POINT, AT, "at", POINT, LENGTH, ANY, ANY_KIND, "its place")                                  \
    X(POINT, PLACE, "place", PLACE, LENGTH, ANY, ANY_KIND, "its place as drawn")                   \
    X(TABLE, BRANCH, "branch", WORD, NUMBER, ANY, ANY_KIND, "the assembly modes")                  \
    X(TABLE, COLUMNS, "columns", TEXT, NUMBER, ANY, ANY_KIND, "the columns")                       \
    X(TABLE, DIGITS, "digits", COUNT, NUMBER, POSITIVE, ANY_KIND, "significant digits")            \
    X(FLYWHEEL, FLUCTUATION, "fluctuation", QUANTITY, NUMBER, POSITIVE, ANY_KIND,                  \
      "coefficient of fluctuation of speed")                                                       \
    X(FLYWHEEL, INERTIA, "inertia", QUANTITY, INERTIA, POSITIVE, ANY_KIND,                         \
      "moment of inertia of the flywheel")                                                         \
    X(FLYWHEEL, EXACT, "exact", WORD, NUMBER, ANY, ANY_KIND,                                       \
      "this fluctuation in the actual motion")                                                     \
    X(SYNTHESIS, TASK, "task", WORD, NUMBER, ANY, ANY_KIND, "what is wanted")                      \
    X(SYNTHESIS, POINTS, "points", TEXT, NUMBER, ANY, WITH_PIN_C, "precision points")              \
    X(SYNTHESIS, WEIGHTS, "weights", TEXT, NUMBER, ANY, WITH_PIN_C, "weights of the points")       \
    X(SYNTHESIS, FIT, "fit", WORD, NUMBER, ANY, WITH_PIN_C, "what a fit makes smallest")           \
    X(SYNTHESIS, FUNCTION, "function", TEXT, NUMBER, ANY, WITH_PIN_C, "the function")              \
    X(SYNTHESIS, ARGUMENT, "x", TEXT, NUMBER, ANY, WITH_PIN_C, "range of its argument")            \
    X(SYNTHESIS, CRANK, "crank", TEXT, ANGLE, ANY, WITH_PIN_C, "range of the crank angle")         \
    X(SYNTHESIS, ROCKER, "rocker", TEXT, ANGLE, ANY, FOURLINK_FOUR_BAR,                            \
      "range of the rocker angle")                                                                 \
    X(SYNTHESIS, PISTON, "piston", TEXT, LENGTH, ANY, FOURLINK_SLIDER_CRANK,                       \
      "range of the piston's place")                                                               \
    X(SYNTHESIS, PRECISION, "precision", COUNT, NUMBER, POSITIVE, WITH_PIN_C,                      \
      "number of precision points")                                                                \
    X(SYNTHESIS, POSITIONS, "positions", TEXT, LENGTH, ANY, WITH_PIN_C, "wanted positions")        \
    X(SYNTHESIS, TIMING, "timing", TEXT, ANGLE, ANY, WITH_PIN_C, "crank angles of the positions")  \
    X(SYNTHESIS, LEFT, "left", TEXT, LENGTH, ANY, WITH_PIN_C, "the left fixed pin")                \
    X(SYNTHESIS, RIGHT, "right", TEXT, LENGTH, ANY, WITH_PIN_C, "the right fixed pin")             \
    X(SYNTHESIS, CRANK_TURNS, "crank_turns", WORD, NUMBER, ANY, WITH_PIN_C,                        \
      "whether the crank must turn fully")                                                         \
    X(SYNTHESIS, TIME_RATIO, "time_ratio", QUANTITY, NUMBER, POSITIVE, ANY_KIND, "time ratio")     \
    X(SYNTHESIS, SWING, "swing", QUANTITY, ANGLE, POSITIVE, WITH_PIN_D,                            \
      "swing of the rocker or lever")                                                              \
    X(SYNTHESIS, STROKE, "stroke", QUANTITY, LENGTH, POSITIVE, WITH_TASKS, "stroke")               \
    X(SYNTHESIS, SLOW, "slow", WORD, NUMBER, ANY, WITH_PIN_C,                                      \
      "the slow stroke: with or against the crank")                                                \
    X(SYNTHESIS, TYPE, "type", WORD, NUMBER, ANY, INVERTED, "the type of quick return")            \
    X(SYNTHESIS, CHOOSE, "choose", WORD, NUMBER, ANY, WITH_PIN_C, "the best of the solutions")     \
    X(SYNTHESIS, WHICH, "which", WORD, NUMBER, ANY, FOURLINK_FOUR_BAR, "which cognate")            \
    X(SYNTHESIS, MU_MIN, "mu_min", QUANTITY, ANGLE, POSITIVE, ANY_KIND,                            \
      "smallest transmission angle")                                                               \
    X(SYNTHESIS, ORDER, "order", WORD, NUMBER, ANY, WITH_PIN_C, "the order of the positions")      \
    X(SYNTHESIS, LENGTHS, "lengths", TEXT, LENGTH, ANY, WITH_PIN_C,                                \
      "bounds of the links' lengths")                                                              \
    X(SYNTHESIS, LENGTH_RATIO, "length_ratio", QUANTITY, NUMBER, POSITIVE, WITH_PIN_C,             \
      "largest ratio of two lengths")                                                              \
    X(SWEEP, SAMPLES, "samples", COUNT, NUMBER, POSITIVE, ANY_KIND, "number of random designs")    \
    X(SWEEP, SEED, "seed", COUNT, NUMBER, NOT_NEGATIVE, ANY_KIND, "start of the random numbers")   \
    X(SWEEP, OUTPUT, "output", TEXT, NUMBER, ANY, ANY_KIND, "what is listed for each design")      \
    X(SWEEP, YIELD, "yield", TEXT, NUMBER, ANY, ANY_KIND, "conditions that a good design meets")   \
    X(GRADING, TOLERANCE, "tolerance", TEXT, NUMBER, ANY, ANY_KIND, "tolerance of all values")     \
    X(GRADING, DIGITS, "digits", COUNT, NUMBER, POSITIVE, ANY_KIND, "fewest digits of a value")    \
    X(GRADING, UNITS, "units", WORD, NUMBER, ANY, ANY_KIND, "bare answers in another unit")        \
    X(GRADING, DECIMAL, "decimal", WORD, NUMBER, ANY, ANY_KIND, "decimal mark of answers")         \
    X(GRADING, LATE, "late", QUANTITY, NUMBER, NOT_NEGATIVE, ANY_KIND, "deduction for a day late") \
    X(GRADING, FEEDBACK, "feedback", WORD, NUMBER, ANY, ANY_KIND, "what feedback shows")           \
    X(GRADING, HINT, "hint", WORD, NUMBER, ANY, ANY_KIND, "marks of a slip that is known")         \
    X(GRADING, TEXT, "text", TEXT, NUMBER, ANY, ANY_KIND, "the words of the exercise in a quiz")   \
    EXPECT_KEYS(X, EXPECT)                                                                         \
    EXPECT_KEYS(X, MISPRINT)

#define SECTION_CODE(code, name, repeats, kinds, first) SECTION_##code,
typedef enum section_code { SECTION_LIST(SECTION_CODE) SECTION_COUNT } section_code;

#define KEY_CODE(section, code, name, form, quantity, sign, kinds, meaning) KEY_##section##_##code,
typedef enum key_code { KEY_LIST(KEY_CODE) KEY_COUNT } key_code;

typedef struct section_info {
    const char *name;
    int repeats, kinds;
    key_code first;
} section_info;

/* By section_code, with a null name at the end. */
extern const section_info flk_section_table[];

typedef struct key_info {
    section_code section;
    const char *name;
    value_form form;
    quantity q;
    value_sign sign;
    int kinds;
    const char *meaning; /* of a value, as the list of inputs has it */
} key_info;

/* By key_code. */
extern const key_info flk_key_table[];

enum { SIDE_AHEAD = 1, SIDE_BEHIND, SIDE_LEFT, SIDE_RIGHT }; /* of an [output] */

#define SIDE_BOTH 2 /* of [motion], beside FOURLINK_RISING and FOURLINK_FALLING */
enum { BRANCH_OPEN = 1, BRANCH_CROSSED = 2, BRANCH_BOTH = 3 };

/* The tasks of [synthesis]. */
typedef enum deck_task {
    TASK_FUNCTION = 1,
    TASK_MOTION,
    TASK_PATH,
    TASK_QUICK_RETURN,
    TASK_COGNATE
} deck_task;

/* A word that a key takes, and its value. */
typedef struct word_info {
    key_code key;
    const char *word;
    int value;
} word_info;

/* The first key of a section; the last is just before the first key of the next section. */
key_code flk_first_key(section_code section);
size_t flk_section_keys(section_code section); /* their number */

/* The word of a key that a text is, whatever its case and whether blanks, - or _ join its parts, or
** means, such as 4-bar, or slider for the piston of a kind of mechanism; null if the key does not accept
** it. */
const word_info *flk_word_find(key_code key, int kind, text t);

/* What to write in place of a word that a key does not accept; null if nothing is known. */
const char *flk_word_advice(key_code key, text t);

/* 1 if a word for an inverted slider-crank, such as boom, is that of a crank on a cylinder. */
int flk_word_has_cylinder(text mechanism);

/* The name of a link, and of its section, that another name means for a kind of mechanism, or this name. */
text flk_link_meant(int kind, text name);

/* 1 if a text is such another name, which may have a blank: dump body. */
int flk_link_is_other(text name);

/* Put such names of a kind of mechanism behind n words, with a null pointer at the end. */
#define MOST_OTHER_LINKS 8
void flk_link_add_others(int kind, const char **words, size_t n);

/* The word most similar to a text, of those that a key accepts or else of their other names; null if
** there is none. */
const char *flk_word_nearest(key_code key, int kind, text t);

/* The words that a key accepts, with a null pointer at the end.  `links`, unless null, has names by number:
** other links are left out. */
#define MOST_WORDS 16
void flk_key_words(key_code key, const char *const *links, const char *words[MOST_WORDS]);

/* The key of a section with this name; KEY_COUNT if there is none. */
key_code flk_find_key(section_code section, text name);

/* The section with this name; SECTION_COUNT if there is none. */
section_code flk_find_section(text name);

/* The section of a link, 1 to 4, of a kind of mechanism: the one with its name. */
section_code flk_section_of_link(fourlink_kind kind, int link);

#endif
