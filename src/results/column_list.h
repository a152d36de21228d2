/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column_list.h - the list of columns: name, quantity, mechanisms, where the value is from, meaning.
*/
#ifndef FOURLINK_COLUMN_LIST_H
#define FOURLINK_COLUMN_LIST_H

#include <stddef.h>

#include "analysis.h"

/* ----------------------------------------------------------------------------- what is said of a column */

/* How a column's value is computed from the numbers of a row. */
typedef enum column_form {
    VALUE,                   /* the first */
    POLAR_SIZE,              /* the first, the size of a vector; the second is its direction */
    POLAR_DIRECTION,         /* the first, the direction of a vector; the second is its size */
    SIZE,                    /* resultant of two components */
    DIRECTION,               /* their direction */
    PRODUCT,                 /* of two */
    DIFFERENCE,              /* of two */
    ON_PAGE,                 /* below: in the axes of the deck; in those of link 1 the first */
    ANGLE_OF_LINK = ON_PAGE, /* an angle from x of link 1 */
    VECTOR_X,                /* a component of a vector; the second is the other one */
    VECTOR_Y,
    PLACE_X, /* of a place */
    PLACE_Y
} column_form;

/* Traits, besides FOURLINK_OF_CRANK, FOURLINK_CRANK_ANGLE, FOURLINK_OF_ROUNDING and FOURLINK_FRICTIONLESS. */
enum {
    OF_MOTION_ALONE = 0x1000, /* loads have no corners in it, though it needs forces */
    HAS_CORNERS = 0x2000,     /* it has corners, though it needs no forces */
    COUNTS_TURNS = 0x4000,    /* an angle to which whole turns add something */
    COLUMN_FLAGS =
        FOURLINK_OF_CRANK | FOURLINK_CRANK_ANGLE | FOURLINK_OF_ROUNDING | FOURLINK_FRICTIONLESS
};

/* The denominator of a column that is infinite where this is 0. */
typedef double flk_denominator(const fourlink_state *state);

struct flk_column_info {
    const char *name;
    quantity q;
    int kinds;  /* mechanisms that have it, and USUAL ...: printed when the deck names no columns */
    int need;   /* NEED_FORCES ...; a deck that cannot give all of these does not have the column */
    int traits; /* FOURLINK_OF_CRANK ..., see above */
    flk_denominator *denominator; /* null: the column is finite */
    column_form form;
    size_t x, y; /* places of the numbers in a row */
    const char *meaning, *source_name;
};

flk_denominator flk_denominator_13, flk_denominator_24, flk_denominator_advantage,
    flk_denominator_klein;

/* --------------------------------------------------------------------------------------------- the list */

#define FOUR_BAR FOURLINK_FOUR_BAR
#define SLIDER_CRANK FOURLINK_SLIDER_CRANK
#define INVERTED FOURLINK_INVERTED_SLIDER_CRANK
#define YOKE FOURLINK_SCOTCH_YOKE
#define PINNED (FOUR_BAR | INVERTED)    /* link 4 turns about D */
#define STROKE (SLIDER_CRANK | YOKE)    /* link 4 slides on the ground */
#define SLOT (INVERTED | YOKE)          /* link 3 slides on link 4 */
#define TURNING (PINNED | SLIDER_CRANK) /* link 3 turns */
#define ALL FLK_EVERY_KIND
#define USUAL 0x100
#define USUAL_ACTUAL 0x200   /* the same, if the motion is computed, or goes by a program */
#define USUAL_CRANK 0x400    /* the same, if the crank drives */
#define OF_CRANK_DRIVE 0x800 /* only if the crank drives */

/* Places of numbers in a row. */
#define ROW(member) offsetof(flk_row, at.row.member)
#define STATE(member) offsetof(flk_row, at.state.member)
#define FORCE(member) offsetof(flk_row, at.forces.member)
#define DERIVED(member) offsetof(flk_row, derived.member)
#define SERIES(member) offsetof(flk_row, series.member)

/* need, traits, denominator, form, x, y */
#define OF_CRANK(member) 0, FOURLINK_OF_CRANK, NULL, VALUE, ROW(member), 0
#define OF_CRANK_ANGLE 0, FOURLINK_OF_CRANK | FOURLINK_CRANK_ANGLE, NULL, VALUE, ROW(angle), 0
#define OF_TIME NEED_TIME, FOURLINK_OF_CRANK, NULL, VALUE, ROW(time), 0
#define OF_STATE(member) 0, 0, NULL, VALUE, STATE(member), 0
#define OF_ANGLE(member) NEED_ANGLES, 0, NULL, VALUE, STATE(member), 0
#define OF_LINK_ANGLE(member) NEED_ANGLES, 0, NULL, ANGLE_OF_LINK, STATE(member), 0
#define X_OF(F) NEED_FORCES, 0, NULL, VECTOR_X, FORCE(F##x), FORCE(F##y)
#define Y_OF(F) NEED_FORCES, 0, NULL, VECTOR_Y, FORCE(F##y), FORCE(F##x)
#define OF_FORCES(member) NEED_FORCES, 0, NULL, VALUE, FORCE(member), 0
#define OF_RESIDUAL NEED_FORCES, FOURLINK_OF_ROUNDING, NULL, VALUE, FORCE(residual), 0
#define SIZE_OF(F) NEED_FORCES, 0, NULL, SIZE, FORCE(F##x), FORCE(F##y)
#define DIRECTION_OF(F) NEED_FORCES, 0, NULL, DIRECTION, FORCE(F##x), FORCE(F##y)
#define POWER_OF_CRANK NEED_FORCES, 0, NULL, PRODUCT, FORCE(at_crank), offsetof(flk_row, speed)
#define OF_MOTION(member) NEED_DERIVED, 0, NULL, VALUE, DERIVED(member), 0
#define OF_POLES(member, denominator) NEED_DERIVED, 0, denominator, VALUE, DERIVED(member), 0
#define X_OF_POLE(I, denominator) NEED_DERIVED, 0, denominator, PLACE_X, DERIVED(I.x), DERIVED(I.y)
#define Y_OF_POLE(I, denominator) NEED_DERIVED, 0, denominator, PLACE_Y, DERIVED(I.y), DERIVED(I.x)
#define OF_SHAKING(form, x, y) \
    NEED_DERIVED | NEED_FORCES, FOURLINK_FRICTIONLESS, NULL, form, DERIVED(x), DERIVED(y)
#define X_OF_SHAKING OF_SHAKING(VECTOR_X, Fsx, Fsy)
#define Y_OF_SHAKING OF_SHAKING(VECTOR_Y, Fsy, Fsx)
#define OF_DERIVED(member) NEED_DERIVED | NEED_FORCES, 0, NULL, VALUE, DERIVED(member), 0
#define MOMENT_OF_SHAKING \
    NEED_DERIVED | NEED_FORCES, FOURLINK_FRICTIONLESS, NULL, VALUE, DERIVED(Ms), 0
#define OF_INERTIA(form, x, y) \
    NEED_DERIVED | NEED_FORCES, OF_MOTION_ALONE, NULL, form, DERIVED(x), DERIVED(y)
#define OF_SPLIT(member, traits) \
    NEED_FORCES | NEED_SUPERPOSITION, traits, NULL, VALUE, DERIVED(member), 0
#define OF_SERIES(member) NEED_SERIES, 0, NULL, VALUE, SERIES(member), 0
#define DIFFERENCE_OF(member, exact) \
    NEED_SERIES | NEED_ANGLES, 0, NULL, DIFFERENCE, SERIES(member), STATE(exact)
#define OF_GAS NEED_GAS, 0, NULL, VALUE, offsetof(flk_row, at.gas_force), 0
#define OF_CYLINDER(member, traits) \
    NEED_CYLINDER, traits, NULL, VALUE, offsetof(flk_row, gas.member), 0
#define OF_ENGINE(member) NEED_ENGINE, 0, NULL, VALUE, offsetof(flk_row, engine.member), 0
#define OF_LOSSES(member, traits) \
    NEED_FORCES | NEED_LOSSES, traits, NULL, VALUE, offsetof(flk_row, at.losses.member), 0
#define OF_BALANCE(member) NEED_DERIVED | NEED_BALANCE, 0, NULL, VALUE, DERIVED(member), 0
#define OF_ACTUAL(member, traits) \
    NEED_ACTUAL, traits, NULL, VALUE, offsetof(flk_row, actual.member), 0
#define OF_RUBBING(i) NEED_DERIVED | NEED_RUBBING, 0, NULL, VALUE, DERIVED(rubbing[i]), 0
#define OF_WANTED NEED_DERIVED | NEED_WANTED, 0, NULL, VALUE, DERIVED(structural_error), 0
#define OF_KLEIN(member) NEED_KLEIN, 0, NULL, VALUE, offsetof(flk_row, klein.member), 0
#define OF_ARM(member) \
    NEED_KLEIN, 0, flk_denominator_klein, VALUE, offsetof(flk_row, klein.member), 0

/* F12x, F12y; the numbers of the unknowns are ME3491's */
#define COMPONENTS(X, F, kinds, words, nx, ny)                                 \
    X(F##x, FORCE, kinds | USUAL, X_OF(F), words ", x", "X(" #nx ") (ME3491)") \
    X(F##y, FORCE, kinds | USUAL, Y_OF(F), words ", y", "X(" #ny ") (ME3491)")

/* F12, F12_dir */
#define RESULTANT(X, F, kinds)                                                         \
    X(F, FORCE, kinds, SIZE_OF(F), "resultant of " #F "x and " #F "y", #F " (ME3491)") \
    X(F##_dir, ANGLE, kinds, DIRECTION_OF(F), "direction of " #F, "theta_" #F " (ME3491)")

/* F12_along, F12_across */
#define AXIAL(X, F, kinds, link)                                                           \
    X(F##_along, FORCE, kinds, OF_DERIVED(F.along), #F " along the line of the " link, "") \
    X(F##_across, FORCE, kinds, OF_DERIVED(F.across),                                      \
      #F " normal to the line of the " link ", to its left", "")

/* Fi2, Fi2_dir, h2, Ci2 */
#define INERTIA_FORCE(X, i)                                                                        \
    X(Fi##i, FORCE, ALL, OF_INERTIA(POLAR_SIZE, inertia[i].size, inertia[i].direction),            \
      "inertia force of link " #i, "F_g" #i " (ME3491)")                                           \
    X(Fi##i##_dir, ANGLE, ALL, OF_INERTIA(POLAR_DIRECTION, inertia[i].direction, inertia[i].size), \
      "direction of Fi" #i, "")                                                                    \
    X(h##i, LENGTH, ALL, OF_INERTIA(VALUE, inertia[i].h, inertia[i].h),                            \
      "offset of Fi" #i " from G, to the left looking along Fi" #i, "h (ME3491 fig. 2)")           \
    X(Ci##i, TORQUE, ALL, OF_INERTIA(VALUE, inertia[i].couple, inertia[i].couple),                 \
      "inertia couple of link " #i ", -I alpha" #i, "T_g" #i " (ME3491)")

/* rubbing_A */
#define RUBBING(X, pin, i, kinds)                 \
    X(rubbing_##pin, SPEED, kinds, OF_RUBBING(i), \
      "rubbing speed of pin " #pin ": its radius times the relative angular speed", "")

/* friction_A */
#define PIN_FRICTION(X, P, i, kinds) \
    X(friction_##P, TORQUE, kinds, OF_LOSSES(pin[i], 0), "moment of friction in the pin " #P, "")

/* x_series, x_diff; x_harmonic */
#define TERMS(X, x, q, exact, words, source)                                     \
    X(x##_series, q, SLIDER_CRANK, OF_SERIES(x), words " of the series", source) \
    X(x##_diff, q, SLIDER_CRANK, DIFFERENCE_OF(x, exact), #x "_series - " #x, "")
#define HARMONIC(X, x, q)                                     \
    X(x##_harmonic, q, SLIDER_CRANK, OF_SERIES(x##_harmonic), \
      #x " with an infinitely long rod: simple harmonic motion", "")

#define ENGINE(X, name, q, words, source) X(name, q, SLIDER_CRANK, OF_ENGINE(name), words, source)
#define KLEIN(X, length, words)                               \
    X(klein_##length, LENGTH, SLIDER_CRANK, OF_KLEIN(length), \
      "length " #length " of Klein's construction: " words, "")

/* name, quantity, mechanisms, where its value is from, meaning, name in the sources */
#define COLUMN_LIST(X)                                                                             \
    X(theta2, ANGLE, ALL | USUAL, OF_CRANK_ANGLE, "angle of the crank",                            \
      "thet (Alvi), thetaa (ME3491)")                                                              \
    X(time, TIME, ALL | USUAL_ACTUAL, OF_TIME, "time since the first row", "")                     \
    X(omega2, ANGULAR_SPEED, ALL | USUAL_ACTUAL, OF_CRANK(crank.omega2),                           \
      "angular speed of the crank", "vela (Alvi), omegaa (ME3491)")                                \
    X(alpha2, ANGULAR_ACCELERATION, ALL | USUAL_ACTUAL, OF_CRANK(crank.alpha2),                    \
      "angular acceleration of the crank", "acca (Alvi), alphaa (ME3491)")                         \
    X(theta3, ANGLE, TURNING | USUAL, OF_LINK_ANGLE(link[3].theta),                                \
      "angle of the coupler, rod or slide", "beta (Alvi), thetab (ME3491)")                        \
    X(omega3, ANGULAR_SPEED, TURNING | USUAL, OF_STATE(link[3].omega),                             \
      "angular speed of the coupler, rod or slide", "velb (Alvi), omegab (ME3491)")                \
    X(alpha3, ANGULAR_ACCELERATION, TURNING | USUAL, OF_STATE(link[3].alpha),                      \
      "angular acceleration of the coupler, rod or slide", "accb (Alvi), alphab (ME3491)")         \
    X(theta3, ANGLE, YOKE, OF_LINK_ANGLE(link[3].theta), "angle of the slot", "")                  \
    X(omega3, ANGULAR_SPEED, YOKE, OF_STATE(link[3].omega), "0: the block does not turn", "")      \
    X(alpha3, ANGULAR_ACCELERATION, YOKE, OF_STATE(link[3].alpha), "0: the block does not turn",   \
      "")                                                                                          \
    X(theta4, ANGLE, PINNED | USUAL, OF_LINK_ANGLE(link[4].theta), "angle of the rocker or lever", \
      "phi (Alvi), thetac (ME3491)")                                                               \
    X(omega4, ANGULAR_SPEED, PINNED | USUAL, OF_STATE(link[4].omega),                              \
      "angular speed of the rocker or lever", "velc (Alvi), omegac (ME3491)")                      \
    X(alpha4, ANGULAR_ACCELERATION, PINNED | USUAL, OF_STATE(link[4].alpha),                       \
      "angular acceleration of the rocker or lever", "accc (Alvi), alphac (ME3491)")               \
    X(phi, ANGLE, SLIDER_CRANK, OF_ANGLE(phi), "obliquity of the rod to the line of stroke",       \
      "beta (ME3491), phi (DFA)")                                                                  \
    X(x, LENGTH, STROKE | USUAL, OF_STATE(x),                                                      \
      "displacement of piston or yoke from its inner dead centre", "x (ME3491, DFA)")              \
    X(v, SPEED, STROKE | USUAL, OF_STATE(v),                                                       \
      "velocity of piston or yoke, away from the inner dead centre", "v (ME3491), V_p (DFA)")      \
    X(a, ACCELERATION, STROKE | USUAL, OF_STATE(a),                                                \
      "acceleration of piston or yoke, away from inner dead centre", "a (ME3491), a_p (DFA)")      \
    X(slide, LENGTH, SLOT | USUAL, OF_STATE(slide),                                                \
      "coordinate of the crank pin B along the slide", "")                                         \
    X(slide_v, SPEED, SLOT | USUAL, OF_STATE(slide_v),                                             \
      "velocity of B relative to link 4, along the slide", "")                                     \
    X(slide_a, ACCELERATION, SLOT | USUAL, OF_STATE(slide_a),                                      \
      "acceleration of B relative to link 4, along the slide", "")                                 \
    X(coriolis, ACCELERATION, INVERTED, OF_STATE(coriolis),                                        \
      "Coriolis acceleration 2 omega4 slide_v, to the left of the slide", "")                      \
    X(mu, ANGLE, TURNING | USUAL, OF_ANGLE(mu), "transmission angle, acute: 0 to 90 deg", "")      \
    X(mu, ANGLE, YOKE, OF_ANGLE(mu), "transmission angle, acute: that of slot and guide", "")      \
    X(gamma, ANGLE, FOUR_BAR, OF_MOTION(gamma), "angle between coupler and rocker, 0 to 180 deg",  \
      "")                                                                                          \
    COMPONENTS(X, F12, ALL, "force of ground on crank", 1, 2)                                      \
    COMPONENTS(X, F23, ALL, "force of crank on coupler, rod or slider", 3, 4)                      \
    COMPONENTS(X, F34, ALL, "force of coupler, rod or slider on link 4", 5, 6)                     \
    X(N34, FORCE, SLOT | USUAL, OF_FORCES(N34),                                                    \
      "force of slider on link 4 at B, to the left of the slide", "")                              \
    X(M34, TORQUE, SLOT, OF_FORCES(M34), "couple of slider on link 4", "")                         \
    COMPONENTS(X, F14, PINNED, "force of ground on rocker or lever", 7, 8)                         \
    X(N, FORCE, STROKE | USUAL, OF_FORCES(F14y),                                                   \
      "guide on piston or yoke, along +y; unlike side_thrust exact", "")                           \
    X(M14, TORQUE, SLIDER_CRANK, OF_FORCES(M14), "couple of the guide on the piston", "")          \
    X(M14, TORQUE, YOKE | USUAL, OF_FORCES(M14), "couple of the guide on the yoke", "")            \
    X(Ts, TORQUE, ALL | USUAL_CRANK, OF_FORCES(Ts), "driving torque, ground on crank",             \
      "X(9), Ts (ME3491)")                                                                         \
    RESULTANT(X, F12, ALL)                                                                         \
    RESULTANT(X, F23, ALL)                                                                         \
    RESULTANT(X, F34, ALL)                                                                         \
    RESULTANT(X, F14, PINNED)                                                                      \
    X(power, POWER, ALL, POWER_OF_CRANK, "power put into the crank", "")                           \
    X(Fsx, FORCE, ALL, X_OF_SHAKING,                                                               \
      "shaking force on the frame (pins, guide, gas on the head), x", "")                          \
    X(Fsy, FORCE, ALL, Y_OF_SHAKING,                                                               \
      "shaking force on the frame (pins, guide, gas on the head), y", "")                          \
    X(Ms, TORQUE, ALL, MOMENT_OF_SHAKING, "shaking moment on the frame about A", "")               \
    X(Fs, FORCE, ALL, OF_SHAKING(SIZE, Fsx, Fsy), "resultant of Fsx and Fsy", "")                  \
    X(Fs_dir, ANGLE, ALL, OF_SHAKING(DIRECTION, Fsx, Fsy), "direction of Fs", "")                  \
    AXIAL(X, F12, ALL, "crank")                                                                    \
    AXIAL(X, F32, ALL, "crank")                                                                    \
    AXIAL(X, F23, ALL, "coupler, rod or slide")                                                    \
    AXIAL(X, F43, ALL, "coupler, rod or slide")                                                    \
    AXIAL(X, F34, PINNED, "rocker or lever")                                                       \
    AXIAL(X, F14, PINNED, "rocker or lever")                                                       \
    INERTIA_FORCE(X, 2)                                                                            \
    INERTIA_FORCE(X, 3)                                                                            \
    INERTIA_FORCE(X, 4)                                                                            \
    X(mechanical_advantage, NUMBER, ALL,                                                           \
      OF_POLES(mechanical_advantage, flk_denominator_advantage),                                   \
      "omega2 / omega4; of a piston or yoke: r omega2 / v", "")                                    \
    X(freudenstein_A, AREA, FOUR_BAR, OF_MOTION(A), "K - a (d - c) cos(theta2) - c d",             \
      "A (Alvi), P (ME3491)")                                                                      \
    X(freudenstein_B, AREA, FOUR_BAR, OF_MOTION(B), "-2 a c sin(theta2)", "B (Alvi), Q (ME3491)")  \
    X(freudenstein_C, AREA, FOUR_BAR, OF_MOTION(C), "K - a (d + c) cos(theta2) + c d",             \
      "C (Alvi), R (ME3491)")                                                                      \
    X(condition, NUMBER, ALL, OF_MOTION(condition),                                                \
      "1 / sin(mu): the factor by which errors of the data grow", "")                              \
    X(structural_error, ANGLE, FOUR_BAR, OF_WANTED, "theta4 - wanted theta4, of --synthesis", "")  \
    X(structural_error, LENGTH, SLIDER_CRANK, OF_WANTED, "C.x - wanted C.x, of --synthesis", "")   \
    X(I13x, LENGTH, TURNING, X_OF_POLE(I13, flk_denominator_13),                                   \
      "instantaneous centre of links 1 and 3, x", "")                                              \
    X(I13y, LENGTH, TURNING, Y_OF_POLE(I13, flk_denominator_13),                                   \
      "instantaneous centre of links 1 and 3, y", "")                                              \
    X(I24x, LENGTH, ALL, X_OF_POLE(I24, flk_denominator_24),                                       \
      "instantaneous centre of links 2 and 4, x", "")                                              \
    X(I24y, LENGTH, ALL, Y_OF_POLE(I24, flk_denominator_24),                                       \
      "instantaneous centre of links 2 and 4, y", "")                                              \
    X(Ts_work, TORQUE, ALL, OF_FORCES(Ts_work),                                                    \
      "driving torque by virtual work, without the nine equations", "")                            \
    X(Ts_static, TORQUE, ALL | OF_CRANK_DRIVE, OF_SPLIT(Ts_static, FOURLINK_FRICTIONLESS),         \
      "driving torque without inertia: of loads, weights and the friction that these cause", "")   \
    X(Ts_inertia, TORQUE, ALL | OF_CRANK_DRIVE, OF_SPLIT(Ts_inertia, 0),                           \
      "driving torque that inertia adds, friction included: Ts - Ts_static", "")                   \
    X(superposition, NUMBER, ALL, OF_SPLIT(superposition, FOURLINK_OF_ROUNDING),                   \
      "error of the sum of both parts, relative to the largest force", "")                         \
    X(Ts0, TORQUE, ALL | USUAL, OF_LOSSES(Ts0, FOURLINK_FRICTIONLESS),                             \
      "driving torque without friction", "")                                                       \
    X(power_friction, POWER, ALL | USUAL, OF_LOSSES(power, 0), "power lost by friction", "")       \
    X(efficiency, NUMBER, ALL | USUAL, OF_LOSSES(efficiency, 0),                                   \
      "Ts0 / Ts if the crank drives, Ts / Ts0 if it is driven; 0: the load cannot drive", "")      \
    PIN_FRICTION(X, A, 0, ALL)                                                                     \
    PIN_FRICTION(X, B, 1, ALL)                                                                     \
    PIN_FRICTION(X, C, 2, FOUR_BAR | SLIDER_CRANK)                                                 \
    PIN_FRICTION(X, D, 3, PINNED)                                                                  \
    RUBBING(X, A, 0, ALL)                                                                          \
    RUBBING(X, B, 1, ALL)                                                                          \
    RUBBING(X, C, 2, FOUR_BAR | SLIDER_CRANK)                                                      \
    RUBBING(X, D, 3, PINNED)                                                                       \
    X(friction_guide, FORCE, STROKE | INVERTED, OF_LOSSES(guide, 0),                               \
      "force of friction in the guide", "")                                                        \
    X(friction_slot, FORCE, YOKE, OF_LOSSES(slot, 0), "force of friction in the slot", "")         \
    X(Fs_primary, FORCE, SLIDER_CRANK, OF_BALANCE(primary),                                        \
      "primary shaking force m_rec r omega2^2 cos(theta2), along +x", "")                          \
    X(Fs_secondary, FORCE, SLIDER_CRANK, OF_BALANCE(secondary),                                    \
      "secondary shaking force m_rec r omega2^2 cos(2 theta2) / n, along +x", "")                  \
    X(T_motor, TORQUE, ALL | USUAL, OF_ACTUAL(T_motor, 0), "torque of the motor, at the crank",    \
      "")                                                                                          \
    X(J, INERTIA, ALL, OF_ACTUAL(J, 0),                                                            \
      "generalised inertia of the links: kinetic energy J omega2^2 / 2", "")                       \
    X(energy, ENERGY, ALL, OF_ACTUAL(energy, 0), "kinetic energy of links, flywheel and rotor",    \
      "")                                                                                          \
    X(energy_residual, NUMBER, ALL, OF_ACTUAL(energy_residual, FOURLINK_OF_ROUNDING),              \
      "energy less the work done, relative to the largest energy", "")                             \
    X(residual, NUMBER, ALL, OF_RESIDUAL, "power balance, relative to its largest term", "")       \
    TERMS(X, x, LENGTH, x, "displacement of the piston, two terms", "x (DFA eq. 2)")               \
    TERMS(X, v, SPEED, v, "velocity of the piston, two terms", "V_p (DFA eq. 3)")                  \
    TERMS(X, a, ACCELERATION, a, "acceleration of the piston, two terms", "a_p (DFA eq. 4)")       \
    TERMS(X, omega3, ANGULAR_SPEED, link[3].omega, "angular speed of the rod, one term",           \
          "-omega_c (DFA)")                                                                        \
    TERMS(X, alpha3, ANGULAR_ACCELERATION, link[3].alpha,                                          \
          "angular acceleration of the rod, one term", "-alpha_c (DFA)")                           \
    HARMONIC(X, x, LENGTH)                                                                         \
    HARMONIC(X, v, SPEED)                                                                          \
    HARMONIC(X, a, ACCELERATION)                                                                   \
    X(gas_force, FORCE, STROKE | INVERTED, OF_GAS,                                                 \
      "gas on piston, towards the crank; on a rod, along the slide",                               \
      "F_p (ME3491), (P1 - P2) A (DFA)")                                                           \
    X(volume, VOLUME, STROKE, OF_CYLINDER(volume, OF_MOTION_ALONE),                                \
      "volume of the gas on the cover side; without a clearance that swept", "V")                  \
    X(pressure, PRESSURE, STROKE, OF_CYLINDER(pressure, 0),                                        \
      "pressure of the gas on the cover side", "P1 (DFA)")                                         \
    ENGINE(X, inertia_force, FORCE, "-(m_p + m_b) a", "-F_b (ME3491)")                             \
    ENGINE(X, piston_effort, FORCE, "sum of gas, inertia, weight and loads along the stroke",      \
           "F (ME3491), F_p (DFA)")                                                                \
    ENGINE(X, rod_force, FORCE, "thrust in the rod", "F_c (ME3491, DFA)")                          \
    ENGINE(X, side_thrust, FORCE, "guide on piston, along +y, the rod as two masses; exact: N",    \
           "")                                                                                     \
    ENGINE(X, crank_effort, FORCE, "force at the crank pin, normal to the crank",                  \
           "F_t (ME3491), F_T (DFA)")                                                              \
    ENGINE(X, radial_force, FORCE, "force along the crank, towards the main bearing",              \
           "force on crank shaft bearing (DFA)")                                                   \
    ENGINE(X, T_piston, TORQUE, "torque of the piston effort", "T (ME3491), T_1 (DFA)")            \
    ENGINE(X, correction_couple, TORQUE, "m b (l - L) phi_dotdot", "dT (ME3491), T_c (DFA)")       \
    ENGINE(X, correction_force, FORCE,                                                             \
           "force of the correction couple at the crank pin, along +y", "F_y (ME3491)")            \
    ENGINE(X, T_correction, TORQUE, "torque of the correction couple", "T_c (ME3491), T_2 (DFA)")  \
    ENGINE(X, T_weight_a, TORQUE, "torque of the weight of m_a", "T_a (ME3491), T_3 (DFA)")        \
    ENGINE(X, T_weight_b, TORQUE, "torque of the weight of m_b, part of T_piston", "T_b (ME3491)") \
    ENGINE(X, T_inertia_a, TORQUE, "torque of the inertia of m_a", "")                             \
    ENGINE(X, T_engine, TORQUE, "torque delivered to the crankshaft, sum of the four torques",     \
           "net torque (ME3491)")                                                                  \
    KLEIN(X, OM, "v = omega2 OM")                                                                  \
    KLEIN(X, BM, "omega3 = omega2 BM / l")                                                         \
    KLEIN(X, BQ, "a_CB^n = omega2^2 BQ, towards B")                                                \
    KLEIN(X, QN, "alpha3 = omega2^2 QN / l")                                                       \
    KLEIN(X, ON, "a = omega2^2 ON")                                                                \
    X(klein_IX, LENGTH, SLIDER_CRANK, OF_ARM(IX),                                                  \
      "arm of the rod's weight W_C about its centre I13", "IX (ME3491)")                           \
    X(klein_IY, LENGTH, SLIDER_CRANK, OF_ARM(IY),                                                  \
      "arm of the rod's inertia force F_C about its centre I13", "IY (ME3491)")                    \
    X(klein_FT, FORCE, SLIDER_CRANK, OF_KLEIN(FT),                                                 \
      "of the rod, normal to the crank: FT IB = F_C IY - W_C IX", "F_T (ME3491)")

/* F32x, F32y, F32, F32_dir: the force opposite to another */
#define OPPOSITE(X, F, of, kinds, words)                                          \
    X(F##x, FORCE, kinds, X_OF(of), words ", x: -" #of "x", "")                   \
    X(F##y, FORCE, kinds, Y_OF(of), words ", y: -" #of "y", "")                   \
    X(F, FORCE, kinds, SIZE_OF(of), "resultant of " #F "x and " #F "y: " #of, "") \
    X(F##_dir, ANGLE, kinds, DIRECTION_OF(of), "direction of " #F, "")

/* The same, with where the value is from that of what is opposite. */
#define OPPOSITE_LIST(X)                                                            \
    OPPOSITE(X, F21, F12, ALL, "force of crank on ground")                          \
    OPPOSITE(X, F32, F23, ALL, "force of coupler, rod or slider on crank")          \
    OPPOSITE(X, F43, F34, ALL, "force of link 4 on coupler, rod or slider")         \
    OPPOSITE(X, F41, F14, PINNED, "force of rocker or lever on ground")             \
    X(N43, FORCE, SLOT, OF_FORCES(N34), "force of link 4 on slider at B: -N34", "") \
    X(M43, TORQUE, SLOT, OF_FORCES(M34), "couple of link 4 on slider: -M34", "")    \
    X(M41, TORQUE, STROKE, OF_FORCES(M14), "couple of piston or yoke on guide: -M14", "")

#endif
