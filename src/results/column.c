/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column.c - the columns of the tables: their names, units and meanings, and their values.
*/
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "column.h"

/* How a column's value is made of the numbers of a row. */
typedef enum column_form {
    VALUE,     /* one of them */
    SIZE,      /* resultant of two components */
    DIRECTION, /* their direction */
    PRODUCT,   /* of two */
    DIFFERENCE /* of two */
} column_form;

enum {
    NOTHING = 0,
    FORCES = NEED_FORCES,
    ENGINE = NEED_ENGINE,
    SERIES = NEED_SERIES,
    KLEIN = NEED_KLEIN,
    DERIVED = NEED_DERIVED,
    SPLIT = NEED_SUPERPOSITION
};

struct flk_column_info {
    const char *name;
    quantity q;
    int kinds; /* mechanisms that have it */
    int need;  /* what it is computed with: the deck has the column if it can give that */
    int usual; /* 1: printed when the deck names no columns */
    column_form form;
    size_t x, y; /* places of the numbers in a row */
    const char *meaning, *source_name;
};

#define FOUR_BAR FOURLINK_FOUR_BAR
#define SLIDER_CRANK FOURLINK_SLIDER_CRANK
#define BOTH (FOURLINK_FOUR_BAR | FOURLINK_SLIDER_CRANK)

#define ROW(member) offsetof(flk_row, at.row.member)
#define STATE(member) offsetof(flk_row, at.state.member)
#define FORCE(member) offsetof(flk_row, at.forces.member)
#define OF_SERIES(member) offsetof(flk_row, series.member)
#define OF_ENGINE(member) offsetof(flk_row, engine.member)
#define OF_KLEIN(member) offsetof(flk_row, klein.member)
#define DERIVED_PART(member) offsetof(flk_row, derived.member)

static const flk_column_info table[] = {
    {"theta2", QUANTITY_ANGLE, BOTH, NOTHING, 1, VALUE, ROW(angle), 0, "angle of the crank",
     "thet (Alvi), thetaa (ME3491)"},
    {"time", QUANTITY_TIME, BOTH, NOTHING, 0, VALUE, ROW(time), 0, "time since the first row", ""},
    {"omega2", QUANTITY_ANGULAR_SPEED, BOTH, NOTHING, 0, VALUE, ROW(crank.omega2), 0,
     "angular speed of the crank", "vela (Alvi), omegaa (ME3491)"},
    {"alpha2", QUANTITY_ANGULAR_ACCELERATION, BOTH, NOTHING, 0, VALUE, ROW(crank.alpha2), 0,
     "angular acceleration of the crank", "acca (Alvi), alphaa (ME3491)"},
    {"theta3", QUANTITY_ANGLE, BOTH, NOTHING, 1, VALUE, STATE(link[3].theta), 0,
     "angle of the coupler or rod", "beta (Alvi), thetab (ME3491)"},
    {"omega3", QUANTITY_ANGULAR_SPEED, BOTH, NOTHING, 1, VALUE, STATE(link[3].omega), 0,
     "angular speed of the coupler or rod", "velb (Alvi), omegab (ME3491)"},
    {"alpha3", QUANTITY_ANGULAR_ACCELERATION, BOTH, NOTHING, 1, VALUE, STATE(link[3].alpha), 0,
     "angular acceleration of the coupler or rod", "accb (Alvi), alphab (ME3491)"},
    {"theta4", QUANTITY_ANGLE, FOUR_BAR, NOTHING, 1, VALUE, STATE(link[4].theta), 0,
     "angle of the rocker", "phi (Alvi), thetac (ME3491)"},
    {"omega4", QUANTITY_ANGULAR_SPEED, FOUR_BAR, NOTHING, 1, VALUE, STATE(link[4].omega), 0,
     "angular speed of the rocker", "velc (Alvi), omegac (ME3491)"},
    {"alpha4", QUANTITY_ANGULAR_ACCELERATION, FOUR_BAR, NOTHING, 1, VALUE, STATE(link[4].alpha), 0,
     "angular acceleration of the rocker", "accc (Alvi), alphac (ME3491)"},
    {"phi", QUANTITY_ANGLE, SLIDER_CRANK, NOTHING, 0, VALUE, STATE(phi), 0,
     "obliquity of the rod to the line of stroke", "beta (ME3491), phi (DFA)"},
    {"x", QUANTITY_LENGTH, SLIDER_CRANK, NOTHING, 1, VALUE, STATE(x), 0,
     "displacement of the piston from its inner dead centre", "x (ME3491, DFA)"},
    {"v", QUANTITY_SPEED, SLIDER_CRANK, NOTHING, 1, VALUE, STATE(v), 0,
     "velocity of the piston, away from the inner dead centre", "v (ME3491), V_p (DFA)"},
    {"a", QUANTITY_ACCELERATION, SLIDER_CRANK, NOTHING, 1, VALUE, STATE(a), 0,
     "acceleration of the piston, away from the inner dead centre", "a (ME3491), a_p (DFA)"},
    {"mu", QUANTITY_ANGLE, BOTH, NOTHING, 1, VALUE, STATE(mu), 0, "transmission angle", ""},
    {"F12x", QUANTITY_FORCE, BOTH, FORCES, 1, VALUE, FORCE(F12x), 0, "force of ground on crank, x",
     "X(1) (ME3491)"},
    {"F12y", QUANTITY_FORCE, BOTH, FORCES, 1, VALUE, FORCE(F12y), 0, "force of ground on crank, y",
     "X(2) (ME3491)"},
    {"F23x", QUANTITY_FORCE, BOTH, FORCES, 1, VALUE, FORCE(F23x), 0,
     "force of crank on coupler or rod, x", "X(3) (ME3491)"},
    {"F23y", QUANTITY_FORCE, BOTH, FORCES, 1, VALUE, FORCE(F23y), 0,
     "force of crank on coupler or rod, y", "X(4) (ME3491)"},
    {"F34x", QUANTITY_FORCE, BOTH, FORCES, 1, VALUE, FORCE(F34x), 0,
     "force of coupler on rocker, or rod on piston, x", "X(5) (ME3491)"},
    {"F34y", QUANTITY_FORCE, BOTH, FORCES, 1, VALUE, FORCE(F34y), 0,
     "force of coupler on rocker, or rod on piston, y", "X(6) (ME3491)"},
    {"F14x", QUANTITY_FORCE, FOUR_BAR, FORCES, 1, VALUE, FORCE(F14x), 0,
     "force of ground on rocker, x", "X(7) (ME3491)"},
    {"F14y", QUANTITY_FORCE, FOUR_BAR, FORCES, 1, VALUE, FORCE(F14y), 0,
     "force of ground on rocker, y", "X(8) (ME3491)"},
    {"N", QUANTITY_FORCE, SLIDER_CRANK, FORCES, 1, VALUE, FORCE(F14y), 0,
     "force of the guide on the piston, along +y", ""},
    {"M14", QUANTITY_TORQUE, SLIDER_CRANK, FORCES, 0, VALUE, FORCE(M14), 0,
     "couple of the guide on the piston", ""},
    {"Ts", QUANTITY_TORQUE, BOTH, FORCES, 1, VALUE, FORCE(Ts), 0, "driving torque, ground on crank",
     "X(9), Ts (ME3491)"},
    {"F12", QUANTITY_FORCE, BOTH, FORCES, 0, SIZE, FORCE(F12x), FORCE(F12y),
     "resultant of F12x and F12y", "F12 (ME3491)"},
    {"F12_dir", QUANTITY_ANGLE, BOTH, FORCES, 0, DIRECTION, FORCE(F12x), FORCE(F12y),
     "direction of F12", "theta_F12 (ME3491)"},
    {"F23", QUANTITY_FORCE, BOTH, FORCES, 0, SIZE, FORCE(F23x), FORCE(F23y),
     "resultant of F23x and F23y", "F23 (ME3491)"},
    {"F23_dir", QUANTITY_ANGLE, BOTH, FORCES, 0, DIRECTION, FORCE(F23x), FORCE(F23y),
     "direction of F23", "theta_F23 (ME3491)"},
    {"F34", QUANTITY_FORCE, BOTH, FORCES, 0, SIZE, FORCE(F34x), FORCE(F34y),
     "resultant of F34x and F34y", "F34 (ME3491)"},
    {"F34_dir", QUANTITY_ANGLE, BOTH, FORCES, 0, DIRECTION, FORCE(F34x), FORCE(F34y),
     "direction of F34", "theta_F34 (ME3491)"},
    {"F14", QUANTITY_FORCE, FOUR_BAR, FORCES, 0, SIZE, FORCE(F14x), FORCE(F14y),
     "resultant of F14x and F14y", "F14 (ME3491)"},
    {"F14_dir", QUANTITY_ANGLE, FOUR_BAR, FORCES, 0, DIRECTION, FORCE(F14x), FORCE(F14y),
     "direction of F14", "theta_F14 (ME3491)"},
    {"power", QUANTITY_POWER, BOTH, FORCES, 0, PRODUCT, FORCE(Ts), ROW(crank.omega2),
     "power put into the crank", ""},
    {"Fsx", QUANTITY_FORCE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(Fsx), 0,
     "shaking force on the frame, x", ""},
    {"Fsy", QUANTITY_FORCE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(Fsy), 0,
     "shaking force on the frame, y", ""},
    {"Ms", QUANTITY_TORQUE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(Ms), 0,
     "shaking moment on the frame about A", ""},
    {"F12_along", QUANTITY_FORCE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(F12.along), 0,
     "F12 along the line of the crank", ""},
    {"F12_across", QUANTITY_FORCE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(F12.across), 0,
     "F12 normal to the line of the crank, to its left", ""},
    {"F32_along", QUANTITY_FORCE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(F32.along), 0,
     "F32 along the line of the crank", ""},
    {"F32_across", QUANTITY_FORCE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(F32.across), 0,
     "F32 normal to the line of the crank, to its left", ""},
    {"F23_along", QUANTITY_FORCE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(F23.along), 0,
     "F23 along the line of the coupler or rod", ""},
    {"F23_across", QUANTITY_FORCE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(F23.across), 0,
     "F23 normal to the line of the coupler or rod, to its left", ""},
    {"F43_along", QUANTITY_FORCE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(F43.along), 0,
     "F43 along the line of the coupler or rod", ""},
    {"F43_across", QUANTITY_FORCE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(F43.across), 0,
     "F43 normal to the line of the coupler or rod, to its left", ""},
    {"F34_along", QUANTITY_FORCE, FOUR_BAR, DERIVED | FORCES, 0, VALUE, DERIVED_PART(F34.along), 0,
     "F34 along the line of the rocker", ""},
    {"F34_across", QUANTITY_FORCE, FOUR_BAR, DERIVED | FORCES, 0, VALUE, DERIVED_PART(F34.across),
     0, "F34 normal to the line of the rocker, to its left", ""},
    {"F14_along", QUANTITY_FORCE, FOUR_BAR, DERIVED | FORCES, 0, VALUE, DERIVED_PART(F14.along), 0,
     "F14 along the line of the rocker", ""},
    {"F14_across", QUANTITY_FORCE, FOUR_BAR, DERIVED | FORCES, 0, VALUE, DERIVED_PART(F14.across),
     0, "F14 normal to the line of the rocker, to its left", ""},
    {"Fi2", QUANTITY_FORCE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(inertia[2].size), 0,
     "inertia force of link 2", "F_g2 (ME3491)"},
    {"Fi2_dir", QUANTITY_ANGLE, BOTH, DERIVED | FORCES, 0, VALUE,
     DERIVED_PART(inertia[2].direction), 0, "direction of Fi2", ""},
    {"h2", QUANTITY_LENGTH, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(inertia[2].h), 0,
     "its offset from the centre of mass, to its left", "h (ME3491 fig. 2)"},
    {"Fi3", QUANTITY_FORCE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(inertia[3].size), 0,
     "inertia force of link 3", "F_g3 (ME3491)"},
    {"Fi3_dir", QUANTITY_ANGLE, BOTH, DERIVED | FORCES, 0, VALUE,
     DERIVED_PART(inertia[3].direction), 0, "direction of Fi3", ""},
    {"h3", QUANTITY_LENGTH, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(inertia[3].h), 0,
     "its offset from the centre of mass, to its left", "h (ME3491 fig. 2)"},
    {"Fi4", QUANTITY_FORCE, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(inertia[4].size), 0,
     "inertia force of link 4", "F_g4 (ME3491)"},
    {"Fi4_dir", QUANTITY_ANGLE, BOTH, DERIVED | FORCES, 0, VALUE,
     DERIVED_PART(inertia[4].direction), 0, "direction of Fi4", ""},
    {"h4", QUANTITY_LENGTH, BOTH, DERIVED | FORCES, 0, VALUE, DERIVED_PART(inertia[4].h), 0,
     "its offset from the centre of mass, to its left", "h (ME3491 fig. 2)"},
    {"mechanical_advantage", QUANTITY_NUMBER, BOTH, DERIVED, 0, VALUE,
     DERIVED_PART(mechanical_advantage), 0, "omega2 / omega4; slider-crank: r omega2 / v", ""},
    {"condition", QUANTITY_NUMBER, BOTH, DERIVED, 0, VALUE, DERIVED_PART(condition), 0,
     "1 / sin(mu): the factor by which errors of the data grow", ""},
    {"I13x", QUANTITY_LENGTH, BOTH, DERIVED, 0, VALUE, DERIVED_PART(I13.x), 0,
     "instantaneous centre of links 1 and 3, x", ""},
    {"I13y", QUANTITY_LENGTH, BOTH, DERIVED, 0, VALUE, DERIVED_PART(I13.y), 0,
     "instantaneous centre of links 1 and 3, y", ""},
    {"I24x", QUANTITY_LENGTH, BOTH, DERIVED, 0, VALUE, DERIVED_PART(I24.x), 0,
     "instantaneous centre of links 2 and 4, x", ""},
    {"I24y", QUANTITY_LENGTH, BOTH, DERIVED, 0, VALUE, DERIVED_PART(I24.y), 0,
     "instantaneous centre of links 2 and 4, y", ""},
    {"Ts_work", QUANTITY_TORQUE, BOTH, FORCES, 0, VALUE, FORCE(Ts_work), 0,
     "driving torque by virtual work, without the nine equations", ""},
    {"Ts_static", QUANTITY_TORQUE, BOTH, FORCES | SPLIT, 0, VALUE, DERIVED_PART(Ts_static), 0,
     "driving torque of loads and weights alone", ""},
    {"Ts_inertia", QUANTITY_TORQUE, BOTH, FORCES | SPLIT, 0, VALUE, DERIVED_PART(Ts_inertia), 0,
     "driving torque of inertia alone", ""},
    {"superposition", QUANTITY_NUMBER, BOTH, FORCES | SPLIT, 0, VALUE, DERIVED_PART(superposition),
     0, "error of the superposition, relative to the largest force", ""},
    {"residual", QUANTITY_NUMBER, BOTH, FORCES, 1, VALUE, FORCE(residual), 0,
     "power balance, relative to its largest term", ""},
    {"x_series", QUANTITY_LENGTH, SLIDER_CRANK, SERIES, 0, VALUE, OF_SERIES(x), 0,
     "displacement of the piston, two terms of the series", "x (DFA eq. 2)"},
    {"x_diff", QUANTITY_LENGTH, SLIDER_CRANK, SERIES, 0, DIFFERENCE, OF_SERIES(x), STATE(x),
     "x_series - x", ""},
    {"v_series", QUANTITY_SPEED, SLIDER_CRANK, SERIES, 0, VALUE, OF_SERIES(v), 0,
     "velocity of the piston, two terms of the series", "V_p (DFA eq. 3)"},
    {"v_diff", QUANTITY_SPEED, SLIDER_CRANK, SERIES, 0, DIFFERENCE, OF_SERIES(v), STATE(v),
     "v_series - v", ""},
    {"a_series", QUANTITY_ACCELERATION, SLIDER_CRANK, SERIES, 0, VALUE, OF_SERIES(a), 0,
     "acceleration of the piston, two terms of the series", "a_p (DFA eq. 4)"},
    {"a_diff", QUANTITY_ACCELERATION, SLIDER_CRANK, SERIES, 0, DIFFERENCE, OF_SERIES(a), STATE(a),
     "a_series - a", ""},
    {"omega3_series", QUANTITY_ANGULAR_SPEED, SLIDER_CRANK, SERIES, 0, VALUE, OF_SERIES(omega3), 0,
     "angular speed of the rod, two terms of the series", "-omega_c (DFA)"},
    {"omega3_diff", QUANTITY_ANGULAR_SPEED, SLIDER_CRANK, SERIES, 0, DIFFERENCE, OF_SERIES(omega3),
     STATE(link[3].omega), "omega3_series - omega3", ""},
    {"alpha3_series", QUANTITY_ANGULAR_ACCELERATION, SLIDER_CRANK, SERIES, 0, VALUE,
     OF_SERIES(alpha3), 0, "angular acceleration of the rod, two terms of the series",
     "-alpha_c (DFA)"},
    {"alpha3_diff", QUANTITY_ANGULAR_ACCELERATION, SLIDER_CRANK, SERIES, 0, DIFFERENCE,
     OF_SERIES(alpha3), STATE(link[3].alpha), "alpha3_series - alpha3", ""},
    {"x_harmonic", QUANTITY_LENGTH, SLIDER_CRANK, SERIES, 0, VALUE, OF_SERIES(x_harmonic), 0,
     "x with an infinitely long rod: simple harmonic motion", ""},
    {"v_harmonic", QUANTITY_SPEED, SLIDER_CRANK, SERIES, 0, VALUE, OF_SERIES(v_harmonic), 0,
     "v with an infinitely long rod: simple harmonic motion", ""},
    {"a_harmonic", QUANTITY_ACCELERATION, SLIDER_CRANK, SERIES, 0, VALUE, OF_SERIES(a_harmonic), 0,
     "a with an infinitely long rod: simple harmonic motion", ""},
    {"gas_force", QUANTITY_FORCE, SLIDER_CRANK, ENGINE, 0, VALUE, OF_ENGINE(gas_force), 0,
     "force of the gas on the piston, towards the crank", "F_p (ME3491), (P1 - P2) A (DFA)"},
    {"inertia_force", QUANTITY_FORCE, SLIDER_CRANK, ENGINE, 0, VALUE, OF_ENGINE(inertia_force), 0,
     "-(m_p + m_b) a", "-F_b (ME3491)"},
    {"piston_effort", QUANTITY_FORCE, SLIDER_CRANK, ENGINE, 0, VALUE, OF_ENGINE(piston_effort), 0,
     "sum of gas, inertia, weight and loads along the stroke", "F (ME3491), F_p (DFA)"},
    {"rod_force", QUANTITY_FORCE, SLIDER_CRANK, ENGINE, 0, VALUE, OF_ENGINE(rod_force), 0,
     "thrust in the rod", "F_c (ME3491, DFA)"},
    {"side_thrust", QUANTITY_FORCE, SLIDER_CRANK, ENGINE, 0, VALUE, OF_ENGINE(side_thrust), 0,
     "force of the guide on the piston, along +y", ""},
    {"crank_effort", QUANTITY_FORCE, SLIDER_CRANK, ENGINE, 0, VALUE, OF_ENGINE(crank_effort), 0,
     "force at the crank pin, normal to the crank", "F_t (ME3491), F_T (DFA)"},
    {"radial_force", QUANTITY_FORCE, SLIDER_CRANK, ENGINE, 0, VALUE, OF_ENGINE(radial_force), 0,
     "force along the crank, towards the main bearing", "force on crank shaft bearing (DFA)"},
    {"T_piston", QUANTITY_TORQUE, SLIDER_CRANK, ENGINE, 0, VALUE, OF_ENGINE(T_piston), 0,
     "torque of the piston effort", "T (ME3491), T_1 (DFA)"},
    {"correction_couple", QUANTITY_TORQUE, SLIDER_CRANK, ENGINE, 0, VALUE,
     OF_ENGINE(correction_couple), 0, "m b (l - L) phi_dotdot", "dT (ME3491), T_c (DFA)"},
    {"T_correction", QUANTITY_TORQUE, SLIDER_CRANK, ENGINE, 0, VALUE, OF_ENGINE(T_correction), 0,
     "torque of the correction couple", "T_c (ME3491), T_2 (DFA)"},
    {"T_weight_a", QUANTITY_TORQUE, SLIDER_CRANK, ENGINE, 0, VALUE, OF_ENGINE(T_weight_a), 0,
     "torque of the weight of m_a", "T_a (ME3491), T_3 (DFA)"},
    {"T_inertia_a", QUANTITY_TORQUE, SLIDER_CRANK, ENGINE, 0, VALUE, OF_ENGINE(T_inertia_a), 0,
     "torque of the inertia of m_a", ""},
    {"T_engine", QUANTITY_TORQUE, SLIDER_CRANK, ENGINE, 0, VALUE, OF_ENGINE(T_engine), 0,
     "torque delivered to the crankshaft, sum of the four torques", "net torque (ME3491)"},
    {"klein_OM", QUANTITY_LENGTH, SLIDER_CRANK, KLEIN, 0, VALUE, OF_KLEIN(OM), 0,
     "length OM of Klein's construction: v = omega2 OM", ""},
    {"klein_BM", QUANTITY_LENGTH, SLIDER_CRANK, KLEIN, 0, VALUE, OF_KLEIN(BM), 0,
     "length BM of Klein's construction: omega3 = omega2 BM / l", ""},
    {"klein_BQ", QUANTITY_LENGTH, SLIDER_CRANK, KLEIN, 0, VALUE, OF_KLEIN(BQ), 0,
     "length BQ of Klein's construction: a_CB^n = omega2^2 BQ, towards B", ""},
    {"klein_QN", QUANTITY_LENGTH, SLIDER_CRANK, KLEIN, 0, VALUE, OF_KLEIN(QN), 0,
     "length QN of Klein's construction: alpha3 = omega2^2 QN / l", ""},
    {"klein_ON", QUANTITY_LENGTH, SLIDER_CRANK, KLEIN, 0, VALUE, OF_KLEIN(ON), 0,
     "length ON of Klein's construction: a = omega2^2 ON", ""},
};

#define TABLE_COUNT (sizeof table / sizeof table[0])

/* A crank at rest, or one held at a speed and an acceleration, has no time. */
static int has_time(const fourlink_motion *motion)
{
    return motion->acceleration != 0 ? !motion->hold : motion->speed != 0;
}

static int has(const flk_analysis *a, const flk_column_info *info)
{
    if (info->x == ROW(time) && !has_time(&a->d->motion))
        return 0;
    return (info->kinds & (int)a->d->design.kind) != 0 && (info->need & ~a->possible) == 0;
}

/* The columns of a point. */
#define POINT_COLUMN(q, meaning)                          \
    {                                                     \
        "", q, BOTH, NOTHING, 0, VALUE, 0, 0, meaning, "" \
    }
static const flk_column_info point_table[DECK_POINT_COLUMNS] = {
    POINT_COLUMN(QUANTITY_LENGTH, "position of the point, x"),
    POINT_COLUMN(QUANTITY_LENGTH, "position of the point, y"),
    POINT_COLUMN(QUANTITY_SPEED, "velocity of the point, x"),
    POINT_COLUMN(QUANTITY_SPEED, "velocity of the point, y"),
    POINT_COLUMN(QUANTITY_ACCELERATION, "acceleration of the point, x"),
    POINT_COLUMN(QUANTITY_ACCELERATION, "acceleration of the point, y"),
    POINT_COLUMN(QUANTITY_SPEED, "speed of the point"),
    POINT_COLUMN(QUANTITY_ACCELERATION, "magnitude of the acceleration of the point")};

static void make(const deck *d, const flk_column_info *info, flk_column *c)
{
    const unit *u = &d->units[info->q].unit;

    c->info = info;
    c->name = info->name;
    c->scale = u->down / u->up;
    c->point = NULL;
    if (info->form == VALUE && info->x == ROW(angle))
        c->scale = 1; /* already in the deck's unit, exactly */
}

static void make_of_point(const deck *d, const deck_point *point, int i, flk_column *c)
{
    make(d, &point_table[i], c);
    c->name = point->column_names[i];
    c->point = point;
    c->component = i;
}

size_t flk_column_limit(const deck *d)
{
    return TABLE_COUNT + DECK_POINT_COLUMNS * d->n_points;
}

int flk_column_number(const flk_analysis *a, size_t i, flk_column *c)
{
    size_t of_points = i - TABLE_COUNT;

    if (i < TABLE_COUNT && has(a, &table[i]))
        make(a->d, &table[i], c);
    else if (i >= TABLE_COUNT)
        make_of_point(a->d, &a->d->points[of_points / DECK_POINT_COLUMNS],
                      (int)(of_points % DECK_POINT_COLUMNS), c);
    else
        return 0;
    return 1;
}

/* Add a column that the list does not have yet. */
static size_t add(flk_column *list, size_t n, const flk_column *c)
{
    size_t i;

    for (i = 0; i < n; i++)
        if (list[i].info == c->info && list[i].point == c->point)
            return n;
    list[n] = *c;
    return n + 1;
}

/* The name of column i of those that there can be. */
static const char *name_of(const flk_analysis *a, size_t i)
{
    size_t of_points = i - TABLE_COUNT;

    return i < TABLE_COUNT ? table[i].name
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

/* `a` null: among the columns of any deck. */
const char *flk_column_nearest(const flk_analysis *a, text name)
{
    const char *known[TABLE_COUNT + 1];
    size_t i, n = 0;

    for (i = 0; i < TABLE_COUNT; i++)
        if (!a || has(a, &table[i]))
            known[n++] = table[i].name;
    known[n] = NULL;
    return flk_text_nearest(name, known);
}

/* 1: printed when the deck names no columns; of a point its place. */
static int is_usual(const flk_column *c)
{
    return c->point ? c->component < 2 : c->info->usual;
}

static size_t add_all(const flk_analysis *a, int usual_only, flk_column *list, size_t n)
{
    flk_column c;
    size_t i;

    for (i = 0; i < flk_column_limit(a->d); i++)
        if (flk_column_number(a, i, &c) && (!usual_only || is_usual(&c)))
            n = add(list, n, &c);
    return n;
}

static const char *why_missing(const deck *d, const flk_column_info *info)
{
    if (info->x == ROW(time))
        return "needs a moving crank";
    if (info->need == SERIES)
        return "needs a line of stroke through the crankshaft; the deck has an offset";
    if (!d->has_forces)
        return "needs masses, loads or gas; the deck has none";
    return "needs a rod whose centre of mass is on its line";
}

static void note_missing(const flk_analysis *a, const deck *d, text name, mistakes *m)
{
    size_t i;

    for (i = 0; i < TABLE_COUNT; i++)
        if (flk_text_same(name, table[i].name)) {
            int is_other = !(table[i].kinds & (int)d->design.kind);

            flk_mistake(m, d->columns.place, "the column '%t' %s%s", name,
                        is_other ? "belongs to the " : why_missing(d, &table[i]),
                        is_other ? fourlink_kind_text(table[i].kinds) : "");
            return;
        }
    flk_mistake(m, d->columns.place, "unknown column '%t'%h", name, flk_column_nearest(a, name));
}

int flk_column_next_name(text *rest, text *name)
{
    while (rest->length && strchr(", \t", rest->start[0])) {
        rest->start++;
        rest->length--;
    }
    *name = *rest;
    while (rest->length && !strchr(", \t", rest->start[0])) {
        rest->start++;
        rest->length--;
    }
    name->length -= rest->length;
    return name->length > 0;
}

int flk_column_extreme_of(text name, text *of)
{
    int sign;

    if (name.length < 6 || name.start[name.length - 1] != ')')
        return 0;
    sign = memcmp(name.start, "max(", 4) == 0 ? 1 : memcmp(name.start, "min(", 4) == 0 ? -1 : 0;
    if (sign) {
        of->start = name.start + 4;
        of->length = name.length - 5;
        *of = flk_text_trim(*of);
    }
    return sign;
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
            n = add(list, n, &c);
        else
            note_missing(a, a->d, name, m);
    }
    if (!n && !m->count)
        flk_mistake(m, a->d->columns.place, "no columns");
    return n;
}

static double number_at(const flk_row *row, size_t place)
{
    return *(const double *)(const void *)((const char *)row + place);
}

static double point_value(const flk_column *c, const flk_row *row)
{
    fourlink_vector p, v, a;

    fourlink_point(&row->at.state, c->point->link, &c->point->at, &p, &v, &a);
    switch (c->component) {
    case 0:
        return p.x * c->scale;
    case 1:
        return p.y * c->scale;
    case 2:
        return v.x * c->scale;
    case 3:
        return v.y * c->scale;
    case 4:
        return a.x * c->scale;
    case 5:
        return a.y * c->scale;
    case 6:
        return gsl_hypot(v.x, v.y) * c->scale;
    default:
        return gsl_hypot(a.x, a.y) * c->scale;
    }
}

static int is_of_crank(const flk_column *c)
{
    return !c->point && c->info->form == VALUE && c->info->x < offsetof(flk_row, at.branch);
}

double flk_column_value(const flk_column *c, const flk_row *row)
{
    double x;

    if (row->at.status != FOURLINK_OK && !is_of_crank(c))
        return GSL_NAN;
    if (c->point)
        return point_value(c, row);
    x = number_at(row, c->info->x);
    if (c->info->form == VALUE)
        return x * c->scale; /* nearly all of them */
    switch (c->info->form) {
    case SIZE:
        x = gsl_hypot(x, number_at(row, c->info->y));
        break;
    case DIRECTION:
        x = atan2(number_at(row, c->info->y), x);
        break;
    case PRODUCT:
        x *= number_at(row, c->info->y);
        break;
    case DIFFERENCE:
        x -= number_at(row, c->info->y);
        break;
    case VALUE:
    default:
        break;
    }
    return x * c->scale;
}

int flk_column_flags(const flk_column *c)
{
    size_t x = c->info->x;

    if (c->point)
        return 0;
    return (is_of_crank(c) ? FOURLINK_OF_CRANK : 0) |
           (is_of_crank(c) && x == ROW(angle) ? FOURLINK_CRANK_ANGLE : 0) |
           (x == FORCE(residual) || x == DERIVED_PART(superposition) ? FOURLINK_OF_ROUNDING : 0);
}

int flk_column_need(const flk_column *c)
{
    return c->info->need;
}

double flk_column_bound(const flk_column *c)
{
    size_t x = c->info->x;

    if (!c->point && (x == DERIVED_PART(mechanical_advantage) || x == DERIVED_PART(I13.x) ||
                      x == DERIVED_PART(I13.y) || x == DERIVED_PART(I24.x)))
        return 1e9 * c->scale;
    return GSL_POSINF;
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
