/* SPDX-License-Identifier: GPL-3.0-or-later
**
** output_columns.h - the columns of an [output]: the endings of their names, and what is said of them.
*/
#ifndef FOURLINK_DECK_OUTPUT_COLUMNS_H
#define FOURLINK_DECK_OUTPUT_COLUMNS_H

#include "fourlink.h"

enum {
    OF_SLIDER = 1 << FOURLINK_GROUP_SLIDES,
    OF_ROCKER = 1 << FOURLINK_GROUP_TURNS,
    OF_ANY = OF_SLIDER | OF_ROCKER,
    WITH_ROD = 8, /* not by a slot */
    BY_SLOT = 16  /* not with a rod */
};

/* code, ending, whose, quantity, need, form, 1 if printed when the deck names no columns, meaning */
#define OUTPUT_COLUMN_LIST(X)                                                                      \
    X(ALONG, ".x", OF_SLIDER, LENGTH, 0, VALUE, 1, "place of its pin Q along its line")            \
    X(V, ".v", OF_SLIDER, SPEED, 0, VALUE, 1, "velocity along its line")                           \
    X(A, ".a", OF_SLIDER, ACCELERATION, 0, VALUE, 1, "acceleration along its line")                \
    X(THETA, ".theta", OF_ROCKER, ANGLE, NEED_ANGLES, ANGLE_OF_LINK, 1, "angle of the rocker")     \
    X(OMEGA, ".omega", OF_ROCKER, ANGULAR_SPEED, 0, VALUE, 1, "angular speed of the rocker")       \
    X(ALPHA, ".alpha", OF_ROCKER, ANGULAR_ACCELERATION, 0, VALUE, 1,                               \
      "angular acceleration of the rocker")                                                        \
    X(ROD_THETA, ".rod_theta", OF_ANY | WITH_ROD, ANGLE, NEED_ANGLES, ANGLE_OF_LINK, 0,            \
      "angle of its rod, from P to Q")                                                             \
    X(ROD_OMEGA, ".rod_omega", OF_ANY | WITH_ROD, ANGULAR_SPEED, 0, VALUE, 0,                      \
      "angular speed of its rod")                                                                  \
    X(ROD_ALPHA, ".rod_alpha", OF_ANY | WITH_ROD, ANGULAR_ACCELERATION, 0, VALUE, 0,               \
      "angular acceleration of its rod")                                                           \
    X(SLIDE, ".slide", OF_ANY | BY_SLOT, LENGTH, 0, VALUE, 1, "place of its block along the slot") \
    X(SLIDE_V, ".slide_v", OF_ANY | BY_SLOT, SPEED, 0, VALUE, 0,                                   \
      "velocity of its block along the slot")                                                      \
    X(MU, ".mu", OF_ANY, ANGLE, 0, VALUE, 1, "its transmission angle, acute: 0 to 90 deg")         \
    X(FPX, ".FPx", OF_ANY, FORCE, NEED_FORCES, VECTOR_X, 1,                                        \
      "force of the carrying link on its rod or block, x")                                         \
    X(FPY, ".FPy", OF_ANY, FORCE, NEED_FORCES, VECTOR_Y, 1,                                        \
      "force of the carrying link on its rod or block, y")                                         \
    X(FQX, ".FQx", OF_ANY, FORCE, NEED_FORCES, VECTOR_X, 1,                                        \
      "force of its rod or block on slider or rocker, x")                                          \
    X(FQY, ".FQy", OF_ANY, FORCE, NEED_FORCES, VECTOR_Y, 1,                                        \
      "force of its rod or block on slider or rocker, y")                                          \
    X(N, ".N", OF_SLIDER, FORCE, NEED_FORCES, VALUE, 1,                                            \
      "force of the guide on the slider, to the left of its line")                                 \
    X(M, ".M", OF_SLIDER, TORQUE, NEED_FORCES, VALUE, 0,                                           \
      "couple of the guide on the slider, about Q")                                                \
    X(FDX, ".FDx", OF_ROCKER, FORCE, NEED_FORCES, VECTOR_X, 1,                                     \
      "force of ground, or the link 'to', on the rocker, x")                                       \
    X(FDY, ".FDy", OF_ROCKER, FORCE, NEED_FORCES, VECTOR_Y, 1,                                     \
      "force of ground, or the link 'to', on the rocker, y")                                       \
    X(FP, ".FP", OF_ANY, FORCE, NEED_FORCES, SIZE, 0, "resultant of FPx and FPy")                  \
    X(FP_DIR, ".FP_dir", OF_ANY, ANGLE, NEED_FORCES, DIRECTION, 0, "direction of FP")              \
    X(FQ, ".FQ", OF_ANY, FORCE, NEED_FORCES, SIZE, 0, "resultant of FQx and FQy")                  \
    X(FQ_DIR, ".FQ_dir", OF_ANY, ANGLE, NEED_FORCES, DIRECTION, 0, "direction of FQ")              \
    X(FD, ".FD", OF_ROCKER, FORCE, NEED_FORCES, SIZE, 0, "resultant of FDx and FDy")               \
    X(FD_DIR, ".FD_dir", OF_ROCKER, ANGLE, NEED_FORCES, DIRECTION, 0, "direction of FD")

#define OUTPUT_COLUMN_CODE(code, ending, whose, q, need, form, usual, meaning) OUTPUT_##code,
typedef enum output_column { OUTPUT_COLUMN_LIST(OUTPUT_COLUMN_CODE) OUTPUT_COLUMNS } output_column;

/* Its facts: code, endings of a slider and of a rocker, their quantities, meanings. */
#define OUTPUT_FACT_LIST(X)                                                                        \
    X(LEAST, ".x_min", ".theta_min", LENGTH, ANGLE, "smallest place along its line",               \
      "smallest angle")                                                                            \
    X(MOST, ".x_max", ".theta_max", LENGTH, ANGLE, "largest place along its line",                 \
      "largest angle")                                                                             \
    X(STROKE, ".stroke", ".swing", LENGTH, ANGLE, "distance between these", "angle between these") \
    X(RATIO, ".time_ratio", ".time_ratio", NUMBER, NUMBER, "time ratio, slow stroke to quick one", \
      "time ratio, slow swing to quick one")

#define OUTPUT_FACT_CODE(code, slider, rocker, q, q_rocker, meaning, meaning_rocker) \
    OUTPUT_FACT_##code,
typedef enum output_fact { OUTPUT_FACT_LIST(OUTPUT_FACT_CODE) OUTPUT_FACTS } output_fact;

#endif
