/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column.c - the columns of the tables: their names, units and meanings.
*/
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "column.h"
#include "column_info.h"
#include "mechanics/mechanics.h"
#include "point.h"

#define FOUR_BAR FOURLINK_FOUR_BAR
#define SLIDER_CRANK FOURLINK_SLIDER_CRANK
#define INVERTED FOURLINK_INVERTED_SLIDER_CRANK
#define PINNED (FOUR_BAR | INVERTED) /* link 4 turns about D */
#define ALL FLK_EVERY_KIND
#define USUAL 0x100
#define USUAL_ACTUAL 0x200 /* the same, if the motion is not given */

#define STATE(member) offsetof(flk_row, at.state.member)
#define SERIES(member) offsetof(flk_row, series.member)

/* need, form, x, y */
#define OF_ROW(member) 0, VALUE, ROW(member), 0
#define OF_STATE(member) 0, VALUE, STATE(member), 0
#define OF_ANGLE(member) NEED_ANGLES, VALUE, STATE(member), 0
#define OF_FORCES(member) NEED_FORCES, VALUE, FORCE(member), 0
#define SIZE_OF(F) NEED_FORCES, SIZE, FORCE(F##x), FORCE(F##y)
#define DIRECTION_OF(F) NEED_FORCES, DIRECTION, FORCE(F##x), FORCE(F##y)
#define POWER_OF_CRANK NEED_FORCES, PRODUCT, FORCE(Ts), ROW(crank.omega2)
#define OF_MOTION(member) NEED_DERIVED, VALUE, DERIVED(member), 0
#define OF_SHAKING(form) NEED_DERIVED | NEED_FORCES, form, DERIVED(Fsx), DERIVED(Fsy)
#define OF_DERIVED(member) NEED_DERIVED | NEED_FORCES, VALUE, DERIVED(member), 0
#define OF_INERTIA(i, form, x, y) \
    NEED_DERIVED | NEED_FORCES, form, DERIVED(inertia[i].x), DERIVED(inertia[i].y)
#define OF_SPLIT(member) NEED_FORCES | NEED_SUPERPOSITION, VALUE, DERIVED(member), 0
#define OF_SERIES(member) NEED_SERIES, VALUE, SERIES(member), 0
#define DIFFERENCE_OF(member, exact) \
    NEED_SERIES | NEED_ANGLES, DIFFERENCE, SERIES(member), STATE(exact)
#define OF_GAS NEED_GAS, VALUE, offsetof(flk_row, at.gas_force), 0
#define OF_ENGINE(member) NEED_ENGINE, VALUE, offsetof(flk_row, engine.member), 0
#define OF_LOSSES(member) NEED_FORCES | NEED_LOSSES, VALUE, offsetof(flk_row, at.losses.member), 0
#define OF_BALANCE(member) NEED_DERIVED | NEED_BALANCE, VALUE, DERIVED(member), 0
#define OF_ACTUAL(member) NEED_ACTUAL, VALUE, offsetof(flk_row, actual.member), 0
#define OF_WANTED NEED_DERIVED | NEED_WANTED, VALUE, DERIVED(structural_error), 0
#define OF_KLEIN(member) NEED_KLEIN, VALUE, offsetof(flk_row, klein.member), 0

/* F12x, F12y; the numbers of the unknowns are ME3491's */
#define COMPONENTS(X, F, kinds, words, nx, ny)                                         \
    X(F##x, FORCE, kinds | USUAL, OF_FORCES(F##x), words ", x", "X(" #nx ") (ME3491)") \
    X(F##y, FORCE, kinds | USUAL, OF_FORCES(F##y), words ", y", "X(" #ny ") (ME3491)")

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
#define INERTIA_FORCE(X, i)                                                                       \
    X(Fi##i, FORCE, ALL, OF_INERTIA(i, POLAR_SIZE, size, direction), "inertia force of link " #i, \
      "F_g" #i " (ME3491)")                                                                       \
    X(Fi##i##_dir, ANGLE, ALL, OF_INERTIA(i, POLAR_DIRECTION, direction, size),                   \
      "direction of Fi" #i, "")                                                                   \
    X(h##i, LENGTH, ALL, OF_DERIVED(inertia[i].h),                                                \
      "offset of Fi" #i " from G, to the left looking along Fi" #i, "h (ME3491 fig. 2)")          \
    X(Ci##i, TORQUE, ALL, OF_DERIVED(inertia[i].couple),                                          \
      "inertia couple of link " #i ", -I alpha" #i, "T_g" #i " (ME3491)")

/* friction_A */
#define PIN_FRICTION(X, P, i, kinds) \
    X(friction_##P, TORQUE, kinds, OF_LOSSES(pin[i]), "moment of friction in the pin " #P, "")

/* I13x, I13y */
#define CENTRE(X, I, links)                                                                \
    X(I##x, LENGTH, ALL, OF_MOTION(I.x), "instantaneous centre of links " links ", x", "") \
    X(I##y, LENGTH, ALL, OF_MOTION(I.y), "instantaneous centre of links " links ", y", "")

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
    X(theta2, ANGLE, ALL | USUAL, OF_ROW(angle), "angle of the crank",                             \
      "thet (Alvi), thetaa (ME3491)")                                                              \
    X(time, TIME, ALL | USUAL_ACTUAL, OF_ROW(time), "time since the first row", "")                \
    X(omega2, ANGULAR_SPEED, ALL | USUAL_ACTUAL, OF_ROW(crank.omega2),                             \
      "angular speed of the crank", "vela (Alvi), omegaa (ME3491)")                                \
    X(alpha2, ANGULAR_ACCELERATION, ALL | USUAL_ACTUAL, OF_ROW(crank.alpha2),                      \
      "angular acceleration of the crank", "acca (Alvi), alphaa (ME3491)")                         \
    X(theta3, ANGLE, ALL | USUAL, OF_ANGLE(link[3].theta), "angle of the coupler, rod or slide",   \
      "beta (Alvi), thetab (ME3491)")                                                              \
    X(omega3, ANGULAR_SPEED, ALL | USUAL, OF_STATE(link[3].omega),                                 \
      "angular speed of the coupler, rod or slide", "velb (Alvi), omegab (ME3491)")                \
    X(alpha3, ANGULAR_ACCELERATION, ALL | USUAL, OF_STATE(link[3].alpha),                          \
      "angular acceleration of the coupler, rod or slide", "accb (Alvi), alphab (ME3491)")         \
    X(theta4, ANGLE, PINNED | USUAL, OF_ANGLE(link[4].theta), "angle of the rocker or lever",      \
      "phi (Alvi), thetac (ME3491)")                                                               \
    X(omega4, ANGULAR_SPEED, PINNED | USUAL, OF_STATE(link[4].omega),                              \
      "angular speed of the rocker or lever", "velc (Alvi), omegac (ME3491)")                      \
    X(alpha4, ANGULAR_ACCELERATION, PINNED | USUAL, OF_STATE(link[4].alpha),                       \
      "angular acceleration of the rocker or lever", "accc (Alvi), alphac (ME3491)")               \
    X(phi, ANGLE, SLIDER_CRANK, OF_ANGLE(phi), "obliquity of the rod to the line of stroke",       \
      "beta (ME3491), phi (DFA)")                                                                  \
    X(x, LENGTH, SLIDER_CRANK | USUAL, OF_STATE(x),                                                \
      "displacement of the piston from its inner dead centre", "x (ME3491, DFA)")                  \
    X(v, SPEED, SLIDER_CRANK | USUAL, OF_STATE(v),                                                 \
      "velocity of the piston, away from the inner dead centre", "v (ME3491), V_p (DFA)")          \
    X(a, ACCELERATION, SLIDER_CRANK | USUAL, OF_STATE(a),                                          \
      "acceleration of the piston, away from the inner dead centre", "a (ME3491), a_p (DFA)")      \
    X(slide, LENGTH, INVERTED | USUAL, OF_STATE(slide),                                            \
      "coordinate of the crank pin B along the slide", "")                                         \
    X(slide_v, SPEED, INVERTED | USUAL, OF_STATE(slide_v),                                         \
      "velocity of B relative to the lever, along the slide", "")                                  \
    X(slide_a, ACCELERATION, INVERTED | USUAL, OF_STATE(slide_a),                                  \
      "acceleration of B relative to the lever, along the slide", "")                              \
    X(coriolis, ACCELERATION, INVERTED, OF_STATE(coriolis),                                        \
      "Coriolis acceleration 2 omega4 slide_v, to the left of the slide", "")                      \
    X(mu, ANGLE, ALL | USUAL, OF_ANGLE(mu), "transmission angle, acute: 0 to 90 deg", "")          \
    X(gamma, ANGLE, FOUR_BAR, OF_MOTION(gamma), "angle between coupler and rocker, 0 to 180 deg",  \
      "")                                                                                          \
    COMPONENTS(X, F12, ALL, "force of ground on crank", 1, 2)                                      \
    COMPONENTS(X, F23, ALL, "force of crank on coupler, rod or slider", 3, 4)                      \
    COMPONENTS(X, F34, ALL, "force of coupler, rod or slider on link 4", 5, 6)                     \
    X(N34, FORCE, INVERTED | USUAL, OF_FORCES(N34),                                                \
      "force of slider on lever at B, to the left of the slide", "")                               \
    X(M34, TORQUE, INVERTED, OF_FORCES(M34), "couple of slider on lever", "")                      \
    COMPONENTS(X, F14, PINNED, "force of ground on rocker or lever", 7, 8)                         \
    X(N, FORCE, SLIDER_CRANK | USUAL, OF_FORCES(F14y),                                             \
      "guide on piston, along +y; exact, unlike side_thrust", "")                                  \
    X(M14, TORQUE, SLIDER_CRANK, OF_FORCES(M14), "couple of the guide on the piston", "")          \
    X(Ts, TORQUE, ALL | USUAL, OF_FORCES(Ts), "driving torque, ground on crank",                   \
      "X(9), Ts (ME3491)")                                                                         \
    RESULTANT(X, F12, ALL)                                                                         \
    RESULTANT(X, F23, ALL)                                                                         \
    RESULTANT(X, F34, ALL)                                                                         \
    RESULTANT(X, F14, PINNED)                                                                      \
    X(power, POWER, ALL, POWER_OF_CRANK, "power put into the crank", "")                           \
    X(Fsx, FORCE, ALL, OF_DERIVED(Fsx),                                                            \
      "shaking force on the frame (pins, guide, gas on the head), x", "")                          \
    X(Fsy, FORCE, ALL, OF_DERIVED(Fsy),                                                            \
      "shaking force on the frame (pins, guide, gas on the head), y", "")                          \
    X(Ms, TORQUE, ALL, OF_DERIVED(Ms), "shaking moment on the frame about A", "")                  \
    X(Fs, FORCE, ALL, OF_SHAKING(SIZE), "resultant of Fsx and Fsy", "")                            \
    X(Fs_dir, ANGLE, ALL, OF_SHAKING(DIRECTION), "direction of Fs", "")                            \
    AXIAL(X, F12, ALL, "crank")                                                                    \
    AXIAL(X, F32, ALL, "crank")                                                                    \
    AXIAL(X, F23, ALL, "coupler, rod or slide")                                                    \
    AXIAL(X, F43, ALL, "coupler, rod or slide")                                                    \
    AXIAL(X, F34, PINNED, "rocker or lever")                                                       \
    AXIAL(X, F14, PINNED, "rocker or lever")                                                       \
    INERTIA_FORCE(X, 2)                                                                            \
    INERTIA_FORCE(X, 3)                                                                            \
    INERTIA_FORCE(X, 4)                                                                            \
    X(mechanical_advantage, NUMBER, ALL, OF_MOTION(mechanical_advantage),                          \
      "omega2 / omega4; slider-crank: r omega2 / v", "")                                           \
    X(freudenstein_A, AREA, FOUR_BAR, OF_MOTION(A), "K - a (d - c) cos(theta2) - c d",             \
      "A (Alvi), P (ME3491)")                                                                      \
    X(freudenstein_B, AREA, FOUR_BAR, OF_MOTION(B), "-2 a c sin(theta2)", "B (Alvi), Q (ME3491)")  \
    X(freudenstein_C, AREA, FOUR_BAR, OF_MOTION(C), "K - a (d + c) cos(theta2) + c d",             \
      "C (Alvi), R (ME3491)")                                                                      \
    X(condition, NUMBER, ALL, OF_MOTION(condition),                                                \
      "1 / sin(mu): the factor by which errors of the data grow", "")                              \
    X(structural_error, ANGLE, FOUR_BAR, OF_WANTED, "theta4 - wanted theta4, of --synthesis", "")  \
    X(structural_error, LENGTH, SLIDER_CRANK, OF_WANTED, "C.x - wanted C.x, of --synthesis", "")   \
    CENTRE(X, I13, "1 and 3")                                                                      \
    CENTRE(X, I24, "2 and 4")                                                                      \
    X(Ts_work, TORQUE, ALL, OF_FORCES(Ts_work),                                                    \
      "driving torque by virtual work, without the nine equations", "")                            \
    X(Ts_static, TORQUE, ALL, OF_SPLIT(Ts_static), "driving torque of loads and weights alone",    \
      "")                                                                                          \
    X(Ts_inertia, TORQUE, ALL, OF_SPLIT(Ts_inertia), "driving torque of inertia alone", "")        \
    X(superposition, NUMBER, ALL, OF_SPLIT(superposition),                                         \
      "error of the superposition, relative to the largest force", "")                             \
    X(Ts0, TORQUE, ALL | USUAL, OF_LOSSES(Ts0), "driving torque without friction", "")             \
    X(power_friction, POWER, ALL | USUAL, OF_LOSSES(power), "power lost by friction", "")          \
    X(efficiency, NUMBER, ALL | USUAL, OF_LOSSES(efficiency),                                      \
      "Ts0 / Ts if the crank drives, Ts / Ts0 if it is driven; 0: the load cannot drive", "")      \
    PIN_FRICTION(X, A, 0, ALL)                                                                     \
    PIN_FRICTION(X, B, 1, ALL)                                                                     \
    PIN_FRICTION(X, C, 2, FOUR_BAR | SLIDER_CRANK)                                                 \
    PIN_FRICTION(X, D, 3, PINNED)                                                                  \
    X(friction_guide, FORCE, SLIDER_CRANK | INVERTED, OF_LOSSES(guide),                            \
      "force of friction in the guide", "")                                                        \
    X(Fs_primary, FORCE, SLIDER_CRANK, OF_BALANCE(primary),                                        \
      "primary shaking force m_rec r omega2^2 cos(theta2), along +x", "")                          \
    X(Fs_secondary, FORCE, SLIDER_CRANK, OF_BALANCE(secondary),                                    \
      "secondary shaking force m_rec r omega2^2 cos(2 theta2) / n, along +x", "")                  \
    X(T_motor, TORQUE, ALL | USUAL, OF_ACTUAL(T_motor), "torque of the motor, at the crank", "")   \
    X(J, INERTIA, ALL, OF_ACTUAL(J),                                                               \
      "generalised inertia of the links: kinetic energy J omega2^2 / 2", "")                       \
    X(energy, ENERGY, ALL, OF_ACTUAL(energy), "kinetic energy of links, flywheel and rotor", "")   \
    X(energy_residual, NUMBER, ALL, OF_ACTUAL(energy_residual),                                    \
      "energy less the work done, relative to the largest energy", "")                             \
    X(residual, NUMBER, ALL | USUAL, OF_FORCES(residual),                                          \
      "power balance, relative to its largest term", "")                                           \
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
    X(gas_force, FORCE, SLIDER_CRANK | INVERTED, OF_GAS,                                           \
      "gas on piston, towards the crank; on a rod, along the slide",                               \
      "F_p (ME3491), (P1 - P2) A (DFA)")                                                           \
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
    X(klein_IX, LENGTH, SLIDER_CRANK, OF_KLEIN(IX),                                                \
      "arm of the rod's weight W_C about its centre I13", "IX (ME3491)")                           \
    X(klein_IY, LENGTH, SLIDER_CRANK, OF_KLEIN(IY),                                                \
      "arm of the rod's inertia force F_C about its centre I13", "IY (ME3491)")                    \
    X(klein_FT, FORCE, SLIDER_CRANK, OF_KLEIN(FT),                                                 \
      "of the rod, normal to the crank: FT IB = F_C IY - W_C IX", "F_T (ME3491)")

#define COLUMN_INFO(name, q, kinds, from, meaning, source) \
    {#name, QUANTITY_##q, kinds, from, meaning, source},
static const flk_column_info table[] = {COLUMN_LIST(COLUMN_INFO)};

#define TABLE_COUNT (sizeof table / sizeof table[0])

/* There is no time for a crank at rest, or for one held at a speed and an acceleration. */
static int has_time(const deck *d)
{
    const fourlink_motion *motion = &d->motion;

    if (d->drive.mode != DRIVE_GIVEN)
        return 1;
    return motion->acceleration != 0 ? !motion->hold : motion->speed != 0;
}

static int has(const flk_analysis *a, const flk_column_info *info)
{
    if (info->x == ROW(time) && !has_time(a->d))
        return 0;
    return (info->kinds & (int)a->d->design.kind) != 0 && (info->need & ~a->possible) == 0;
}

/* The columns of a point. */
#define POINT_COLUMNS(X, P, of)                           \
    X(P ".x", LENGTH, "position of " of ", x")            \
    X(P ".y", LENGTH, "position of " of ", y")            \
    X(P ".vx", SPEED, "velocity of " of ", x")            \
    X(P ".vy", SPEED, "velocity of " of ", y")            \
    X(P ".ax", ACCELERATION, "acceleration of " of ", x") \
    X(P ".ay", ACCELERATION, "acceleration of " of ", y") \
    X(P ".v", SPEED, "speed of " of)                      \
    X(P ".a", ACCELERATION, "magnitude of the acceleration of " of)

#define POINT_INFO(name, q, meaning) {name, QUANTITY_##q, ALL, 0, VALUE, 0, 0, meaning, ""},
static const flk_column_info point_table[DECK_POINT_COLUMNS] = {
    POINT_COLUMNS(POINT_INFO, "", "the point")};

/* The columns of the points that every deck has. */
#define OWN_POINT(name, of) POINT_COLUMNS(POINT_INFO, #name, of)
static const flk_column_info own_table[] = {FLK_POINT_LIST(OWN_POINT)};

#define OWN_COUNT (sizeof own_table / sizeof own_table[0])

/* The columns of springs, and of torsional ones. */
#define SPRING_INFO(q, meaning)                            \
    {                                                      \
        "", QUANTITY_##q, ALL, 0, VALUE, 0, 0, meaning, "" \
    }
static const flk_column_info spring_table[2][FLK_ELEMENT_COLUMNS] = {
    {SPRING_INFO(LENGTH, "length of the spring"), SPRING_INFO(FORCE, "tension of the spring"),
     SPRING_INFO(ENERGY, "energy of the spring"),
     SPRING_INFO(POWER, "power that spring and damper put into the links")},
    {SPRING_INFO(ANGLE, "angle of the spring, which counts turns"),
     SPRING_INFO(TORQUE, "torque of the spring, -T on 'link' and T on 'to'"),
     SPRING_INFO(ENERGY, "energy of the spring"),
     SPRING_INFO(POWER, "power that spring and damper put into the links")}};

static void make(const deck *d, const flk_column_info *info, flk_column *c)
{
    const unit *u = &d->units[info->q].unit;

    c->info = info;
    c->name = info->name;
    c->scale = u->down / u->up;
    c->link = 0;
    c->spring = NULL;
    if (info->form == VALUE && info->x == ROW(angle))
        c->scale = 1; /* already in the deck's unit, exactly */
}

static void make_of_point(const deck *d, const deck_point *point, int i, flk_column *c)
{
    make(d, &point_table[i], c);
    c->name = point->column_names[i];
    c->link = point->link;
    c->at = point->at;
    c->component = i;
}

static void make_of_spring(const deck *d, size_t i, flk_column *c)
{
    const flk_element *e = flk_machine_find(&d->machine, &flk_spring_sort, i / FLK_ELEMENT_COLUMNS);
    const fourlink_spring *spring = e->data;

    c->component = (int)(i % FLK_ELEMENT_COLUMNS);
    make(d, &spring_table[spring->is_torsional != 0][c->component], c);
    c->name = e->column_names[c->component];
    c->mechanism = &d->machine.mechanism;
    c->spring = spring;
}

/* Column i of the points that every deck has; returns why this deck does not have it, or null. */
static const char *make_of_own_point(const deck *d, size_t i, flk_column *c)
{
    make(d, &own_table[i], c);
    c->component = (int)(i % DECK_POINT_COLUMNS);
    return flk_point_find(d, (flk_point_code)(i / DECK_POINT_COLUMNS), &c->link, &c->at);
}

/* Possible columns, in this order: those of the table, of the points that every deck has, of the deck's
** own points, of its springs. */
#define FIXED_COUNT (TABLE_COUNT + OWN_COUNT)

size_t flk_column_limit(const deck *d)
{
    return FIXED_COUNT + DECK_POINT_COLUMNS * d->n_points +
           FLK_ELEMENT_COLUMNS * flk_machine_count(&d->machine, &flk_spring_sort);
}

int flk_column_number(const flk_analysis *a, size_t i, flk_column *c)
{
    size_t of_points = i - FIXED_COUNT, n_of_points = DECK_POINT_COLUMNS * a->d->n_points;

    c->number = i;
    if (i >= FIXED_COUNT + n_of_points)
        make_of_spring(a->d, of_points - n_of_points, c);
    else if (i >= FIXED_COUNT)
        make_of_point(a->d, &a->d->points[of_points / DECK_POINT_COLUMNS],
                      (int)(of_points % DECK_POINT_COLUMNS), c);
    else if (i >= TABLE_COUNT)
        return make_of_own_point(a->d, i - TABLE_COUNT, c) == NULL;
    else if (has(a, &table[i]))
        make(a->d, &table[i], c);
    else
        return 0;
    return 1;
}

/* Add a column to a list of n, unless it is among the first of them. */
static size_t add(flk_column *list, size_t n, size_t first, const flk_column *c)
{
    size_t i;

    for (i = 0; i < first; i++)
        if (list[i].number == c->number)
            return n;
    list[n] = *c;
    return n + 1;
}

/* The name of possible column i. */
static const char *name_of(const flk_analysis *a, size_t i)
{
    size_t of_points = i - FIXED_COUNT, n_of_points = DECK_POINT_COLUMNS * a->d->n_points;
    size_t of_springs = of_points - n_of_points;

    if (i >= FIXED_COUNT + n_of_points)
        return flk_machine_find(&a->d->machine, &flk_spring_sort, of_springs / FLK_ELEMENT_COLUMNS)
            ->column_names[of_springs % FLK_ELEMENT_COLUMNS];
    return i < TABLE_COUNT   ? table[i].name
           : i < FIXED_COUNT ? own_table[i - TABLE_COUNT].name
                             : a->d->points[of_points / DECK_POINT_COLUMNS]
                                   .column_names[of_points % DECK_POINT_COLUMNS];
}

static int find(const flk_analysis *a, text name, int equal(text, const char *), flk_column *c)
{
    size_t i, n = flk_column_limit(a->d);

    for (i = 0; i < n; i++)
        if (equal(name, name_of(a, i)) && flk_column_number(a, i, c))
            return 1;
    return 0;
}

int flk_column_find(const flk_analysis *a, text name, flk_column *c)
{
    return find(a, name, flk_text_same, c);
}

/* What people call columns, and the names; the digits that follow are the same in both. */
static const struct {
    const char *written, *meant;
} aliases[] = {{"w", "omega"},        {"a", "alpha"},
               {"t", "time"},         {"force", "F"},
               {"torque", "Ts"},      {"driving_torque", "Ts"},
               {"displacement", "x"}, {"velocity", "v"},
               {"acceleration", "a"}, {"transmission_angle", "mu"}};

static int is_digits(const char *s)
{
    return s[strspn(s, "0123456789")] == '\0';
}

const char *flk_column_meant(const flk_analysis *a, text name)
{
    char word[DECK_NAME_SIZE];
    size_t i, k;

    flk_text_copy(name, word, sizeof word);
    for (i = 0; i < sizeof aliases / sizeof aliases[0]; i++) {
        size_t n = strlen(aliases[i].written), m = strlen(aliases[i].meant);
        text front = name;

        front.length = n < name.length ? n : name.length;
        if (!flk_text_equal(front, aliases[i].written) || !is_digits(word + n))
            continue;
        for (k = 0; k < TABLE_COUNT; k++)
            if ((!a || has(a, &table[k])) && strncmp(table[k].name, aliases[i].meant, m) == 0 &&
                strcmp(table[k].name + m, word + n) == 0)
                return table[k].name;
    }
    return NULL;
}

/* If `a` is null, search the columns of any deck. */
const char *flk_column_nearest(const flk_analysis *a, text name)
{
    const char *known[TABLE_COUNT + 1], *meant = flk_column_meant(a, name);
    size_t i, n = 0;

    for (i = 0; i < TABLE_COUNT; i++)
        if (!a || has(a, &table[i]))
            known[n++] = table[i].name;
    known[n] = NULL;
    return meant ? meant : flk_text_nearest(name, known);
}

/* 1 if possible column i is printed if the deck names none; of a point or a spring only the first two. */
static int is_usual(const flk_analysis *a, size_t i)
{
    int usual = a->possible & NEED_ACTUAL ? USUAL | USUAL_ACTUAL : USUAL;
    size_t of_points = i - FIXED_COUNT, n_of_points = DECK_POINT_COLUMNS * a->d->n_points;

    if (i < FIXED_COUNT)
        return i < TABLE_COUNT && (table[i].kinds & usual);
    return of_points < n_of_points ? of_points % DECK_POINT_COLUMNS < 2
                                   : (of_points - n_of_points) % FLK_ELEMENT_COLUMNS < 2;
}

static size_t add_all(const flk_analysis *a, int usual_only, flk_column *list, size_t n)
{
    size_t i, limit = flk_column_limit(a->d), first = n;
    flk_column c;

    for (i = 0; i < limit; i++)
        if ((!usual_only || is_usual(a, i)) && flk_column_number(a, i, &c))
            n = add(list, n, first, &c);
    return n;
}

static const char *why_missing(const deck *d, const flk_column_info *info)
{
    if (info->x == ROW(time))
        return "needs a moving crank";
    if (info->need & NEED_SERIES)
        return "needs a line of stroke through the crankshaft; the deck has an offset";
    if ((info->need & NEED_LOSSES) && !d->machine.has_friction)
        return "needs a [friction] section; the deck has none";
    if (info->need & NEED_ACTUAL)
        return "needs [motion] mode = free, run-up or steady; the motion is given";
    if (info->need & NEED_WANTED)
        return "needs --synthesis and a [synthesis] with a function";
    if (info->need & NEED_BALANCE)
        return "needs a [balance] section; the deck has none";
    if (!d->has_forces)
        return "needs masses, loads or gas; the deck has none";
    if (info->need == NEED_GAS)
        return "needs gas; the deck has none";
    return "needs a rod whose centre of mass is on its line";
}

static void note_missing(const flk_analysis *a, const deck *d, text name, mistakes *m)
{
    const char *nearest;
    flk_column c;
    size_t i;

    for (i = 0; i < OWN_COUNT; i++)
        if (flk_text_same(name, own_table[i].name)) {
            flk_mistake(m, d->columns.place, "the column '%t' %s", name,
                        make_of_own_point(d, i, &c));
            return;
        }

    for (i = 0; i < TABLE_COUNT; i++)
        if (flk_text_same(name, table[i].name)) {
            int kinds = table[i].kinds & ALL, first = kinds & -kinds, second = kinds & ~first;

            if (kinds & (int)d->design.kind)
                flk_mistake(m, d->columns.place, "the column '%t' %s", name,
                            why_missing(d, &table[i]));
            else /* at most two of the three kinds */
                flk_mistake(m, d->columns.place, "the column '%t' belongs to the %s%s%s", name,
                            fourlink_kind_text(first), second ? " and the " : "",
                            second ? fourlink_kind_text(second) : "");
            return;
        }
    nearest = flk_column_nearest(a, name);
    flk_mistake(m, d->columns.place, "unknown column '%t'%h%s", name, nearest,
                nearest ? "" : "; see --list");
}

int flk_column_next_name(text *rest, text *name)
{
    while (rest->length && strchr(", \t", rest->start[0]))
        *rest = flk_text_from(*rest, 1);
    *name = *rest;
    while (rest->length && !strchr(", \t", rest->start[0]))
        *rest = flk_text_from(*rest, 1);
    name->length -= rest->length;
    return name->length > 0;
}

static const char *const statistics[] = {"", "max(", "min(", "mean(", "rms("};

flk_statistic flk_column_statistic_of(text name, text *of)
{
    int i;

    if (!name.length || name.start[name.length - 1] != ')')
        return FLK_NONE;
    for (i = FLK_MAX; i <= FLK_RMS; i++) {
        size_t length = strlen(statistics[i]);

        if (name.length > length + 1 && memcmp(name.start, statistics[i], length) == 0) {
            of->start = name.start + length;
            of->length = name.length - length - 1;
            *of = flk_text_trim(*of);
            return (flk_statistic)i;
        }
    }
    return FLK_NONE;
}

char *flk_column_statistic_text(flk_statistic statistic, const char *column, char *name)
{
    return flk_text_join(name, DECK_NAME_SIZE, statistics[statistic], column, ")", (char *)NULL);
}

char *flk_column_statistic_name(flk_statistic statistic, const flk_column *c, char *names)
{
    size_t place = FLK_STATISTICS * c->number + (size_t)(statistic - FLK_MAX);

    return flk_column_statistic_text(statistic, c->name, names + DECK_NAME_SIZE * place);
}

/* Handles start at 1: a column, then its statistics. */
#define HANDLES (1 + FLK_STATISTICS)

int flk_column_handle(const flk_column *c, flk_statistic statistic)
{
    return 1 + HANDLES * (int)c->number + (int)statistic;
}

int flk_column_of_handle(const flk_analysis *a, int handle, flk_column *c, flk_statistic *statistic)
{
    size_t place = handle > 0 ? (size_t)handle - 1 : (size_t)-1;

    *statistic = (flk_statistic)(place % HANDLES);
    return place / HANDLES < flk_column_limit(a->d) && flk_column_number(a, place / HANDLES, c);
}

static int is_known(text name)
{
    size_t i;

    for (i = 0; i < TABLE_COUNT; i++)
        if (flk_text_equal(name, table[i].name))
            return 1;
    return flk_text_equal(name, "all") || memchr(name.start, '.', name.length) != NULL;
}

void flk_column_check(deck *d)
{
    text rest = d->columns.names, name;

    while (rest.start && flk_column_next_name(&rest, &name))
        if (!is_known(name))
            note_missing(NULL, d, name, &d->mistakes);
}

size_t flk_column_choose(const flk_analysis *a, mistakes *m, flk_column *list)
{
    text rest = a->d->columns.names, name;
    size_t n = 0;
    flk_column c;

    if (!rest.start)
        return add_all(a, 1, list, 0);
    while (flk_column_next_name(&rest, &name)) {
        if (flk_text_equal(name, "all"))
            n = add_all(a, 0, list, n);
        else if (find(a, name, flk_text_same, &c) || find(a, name, flk_text_equal, &c))
            n = add(list, n, n, &c);
        else
            note_missing(a, a->d, name, m);
    }
    if (!n && !m->count)
        flk_mistake(m, a->d->columns.place, "no columns");
    return n;
}

/* 1 if two designs of a deck have the same columns. */
static int have_same(const flk_analysis *a, const flk_analysis *b)
{
    size_t i;
    flk_column c;

    for (i = 0; i < OWN_COUNT; i += DECK_POINT_COLUMNS)
        if (!make_of_own_point(a->d, i, &c) != !make_of_own_point(b->d, i, &c))
            return 0;
    return a->possible == b->possible && a->d->design.kind == b->d->design.kind &&
           has_time(a->d) == has_time(b->d);
}

size_t flk_column_take(const flk_analysis *a, const flk_analysis *of, const flk_column *from,
                       size_t n, flk_column *list)
{
    size_t i;

    if (!have_same(a, of))
        return 0;
    for (i = 0; i < n; i++)
        flk_column_number(a, from[i].number, &list[i]);
    return n;
}

quantity flk_column_quantity(const flk_column *c)
{
    return c->info->q;
}

const char *flk_column_meaning(const flk_column *c)
{
    return c->info->meaning;
}

const char *flk_column_source_name(const flk_column *c)
{
    return c->info->source_name;
}
