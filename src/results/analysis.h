/* SPDX-License-Identifier: GPL-3.0-or-later
**
** analysis.h - a row: all results of a deck at one crank position on one branch.
*/
#ifndef FOURLINK_ANALYSIS_H
#define FOURLINK_ANALYSIS_H

#include "mechanics/element.h"
#include "mechanics/group.h"
#include "motion/course.h"
#include "deck/deck.h"

/* ---------------------------------------------------------------------------------------------- derived */

/* A force in a link's own axes: along its line, and normal to it, to the left. */
typedef struct flk_axial {
    double along, across; /* N */
} flk_axial;

/* Offset inertia force of a link (ME3491, fig. 2). */
typedef struct flk_offset_force {
    double size, direction; /* N, rad: -m a_G */
    double couple;          /* N m, -I alpha */
    double h;               /* m, offset from G to the left of the force; NaN if there is none */
} flk_offset_force;

typedef struct flk_derived {
    double Fsx, Fsy, Ms;          /* N, N m about A: of the machine on its frame */
    double primary, secondary;    /* N, along +x: of the reciprocating mass of an engine */
    flk_axial F12, F32;           /* N, on the crank */
    flk_axial F23, F43;           /* N, on coupler or rod */
    flk_axial F34, F14;           /* N, on link 4 */
    flk_offset_force inertia[5];  /* by link number */
    double mechanical_advantage;  /* 1 */
    double condition;             /* 1 */
    double rubbing[4];            /* m/s, at pins A to D */
    double gamma;                 /* rad, 0 to pi: angle between coupler and rocker; four-bar */
    fourlink_vector I13, I24;     /* m, instantaneous centres; NaN at infinity */
    double A, B, C;               /* m2, coefficients of Freudenstein's equation; four-bar */
    double structural_error;      /* rad or m, of a linkage found for a function */
    double Ts_static, Ts_inertia; /* N m, without inertia, and what inertia adds */
    double superposition; /* 1, largest difference, of all nine unknowns, between the sum of both
                             and the whole, relative to the largest force */
} flk_derived;

/* K = (a^2 - b^2 + c^2 + d^2) / 2 of a four-bar, m2 (Alvi section 3.1) */
double flk_derive_freudenstein(const fourlink_design *design);

/* The part that follows from the motion alone. */
void flk_derive_from_motion(const fourlink_mechanism *mechanism, const fourlink_state *state,
                            flk_derived *e);

/* The part that follows from the forces, and from the loads of the elements. */
void flk_derive_from_forces(const flk_machine *machine, const fourlink_state *state,
                            const fourlink_forces *forces, const flk_acting *acting,
                            flk_derived *e);

/* Speeds of rubbing at pins A to D, of these radii, m. */
void flk_derive_rubbing(const fourlink_mechanism *mechanism, const fourlink_state *state,
                        const double radius[4], flk_derived *e);

/* Primary and secondary shaking force of a slider-crank. */
void flk_derive_primary(const fourlink_mechanism *mechanism, const fourlink_state *state,
                        double reciprocating, flk_derived *e);

/* Solve for loads and inertia separately; returns a status.  With friction, not null, the last
** FOURLINK_FRICTION_LOADS of the loads are those of friction. */
int flk_derive_superposition(const fourlink_mechanism *mechanism, const fourlink_state *state,
                             const fourlink_load *loads, unsigned long n_loads,
                             const fourlink_friction *friction, const fourlink_forces *forces,
                             flk_derived *e);

/* ------------------------------------------------------------------------------------------------ a row */

/* What is computed in addition to the motion of the links. */
enum {
    NEED_FORCES = 1,
    NEED_ENGINE = 2,
    NEED_SERIES = 4,
    NEED_KLEIN = 8,
    NEED_DERIVED = 16,
    NEED_SUPERPOSITION = 32,
    NEED_GAS = 64,
    NEED_LOSSES = 128,     /* columns of friction */
    NEED_BALANCE = 256,    /* of an engine with [balance] */
    NEED_ACTUAL = 512,     /* columns of the actual motion */
    NEED_ANGLES = 1024,    /* theta3, theta4, mu, phi */
    NEED_WANTED = 2048,    /* of a linkage found for a function */
    NEED_TIME = 4096,      /* of a crank that moves */
    NEED_RUBBING = 8192,   /* of pins that have a radius */
    NEED_CYLINDER = 16384, /* of gas on a piston or yoke */
    PLACES_ALONE = 32768   /* no velocity and no acceleration, of a mechanism without outputs */
};

/* One row. */
typedef struct flk_row {
    fourlink_instant at;
    double
        speed; /* rad/s, with which the k of the state are multiplied: omega2, in a dead position omega3 */
    fourlink_engine engine; /* computed only if needed */
    fourlink_series series;
    fourlink_klein klein;
    flk_derived derived;   /* from the motion, and from the forces if needed */
    flk_actual_row actual; /* of a deck whose motion is not given */
    flk_gas_state gas;
    flk_group_forces group[FOURLINK_MOST_GROUPS]; /* of outputs, with the forces */
} flk_row;

/* Mean and root mean square of a column on a branch, in this order, computed once. */
typedef struct flk_mean {
    int is_known, status[2];
    double value[2];
} flk_mean;

/* The turning moment of a branch, computed once. */
typedef struct flk_turning {
    int is_known, is_there;
    fourlink_turning t;
    double efficiency; /* 1, of the cycle, with friction */
} flk_turning;

/* A deck with the memory that its analysis needs. */
typedef struct flk_analysis {
    const deck *d;
    int possible; /* which of the above the deck can give */
    flk_course course;
    flk_acting acting;      /* the loads of the present row */
    int is_fast;            /* 1: compute rows in closed form, whatever the deck says */
    double *turning_memory; /* from flk_turning_open; null: the deck has no turning moment */
    flk_turning turning[2]; /* open, crossed */
    flk_mean *means;        /* from flk_means_open: of column 0, open, crossed; of column 1 ... */
    double
        rows_left; /* that a search may still compute; a row with loads counts as more than one */
} flk_analysis;

/* Set up an analysis; 0 if out of memory.  `like` is null, or an analysis of the same machine and motion (see
** flk_settings_move_alike), which has done part of the work and must live longer. */
int flk_analysis_open(flk_analysis *a, const deck *d, const flk_analysis *like);
void flk_analysis_close(flk_analysis *a);

/* omega2, rad/s, or the mean of a motion that is computed; NaN if it has none. */
double flk_analysis_mean_speed(const flk_analysis *a, fourlink_branch branch);

/* Compute any crank position; the caller fills row->at.row.  `needs` says what to compute. */
void flk_analysis_at(flk_analysis *a, int needs, fourlink_branch branch,
                     const fourlink_crank *crank, flk_row *row);

/* Row i of the deck; the row at a place of its course; where the crank first passes an angle, in the deck's
** unit, or 0 if the motion has no such angle. */
void flk_analysis_row(flk_analysis *a, int needs, fourlink_branch branch, unsigned long i,
                      flk_row *row);
void flk_analysis_along(flk_analysis *a, int needs, fourlink_branch branch, int side, double place,
                        flk_row *row);
int flk_analysis_at_angle(flk_analysis *a, int needs, fourlink_branch branch, double angle,
                          flk_row *row);

#endif
