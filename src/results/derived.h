/* SPDX-License-Identifier: GPL-3.0-or-later
**
** derived.h - what textbooks derive from the nine unknowns and the motion.
*/
#ifndef FOURLINK_DERIVED_H
#define FOURLINK_DERIVED_H

#include "mechanics/element.h"

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
    double Ts_static, Ts_inertia; /* N m, of loads and weights alone, and of inertia alone */
    double superposition; /* 1, largest difference, of all nine unknowns, between the sum of both
                             and the whole, relative to the largest force */
} flk_derived;

/* K = (a^2 - b^2 + c^2 + d^2) / 2 of a four-bar, m2 (Alvi section 3.1) */
double flk_derive_freudenstein(const fourlink_design *design);

/* The part that follows from the motion alone. */
void flk_derive_from_motion(const fourlink_mechanism *mechanism, const fourlink_state *state,
                            flk_derived *e);

/* The part that follows from the forces, and from those of the elements on the frame. */
void flk_derive_from_forces(const fourlink_mechanism *mechanism, const fourlink_state *state,
                            const fourlink_forces *forces, const flk_acting *acting,
                            flk_derived *e);

/* Speeds of rubbing at pins A to D, of these radii, m. */
void flk_derive_rubbing(const fourlink_mechanism *mechanism, const fourlink_state *state,
                        const double radius[4], flk_derived *e);

/* Primary and secondary shaking force of a slider-crank. */
void flk_derive_primary(const fourlink_mechanism *mechanism, const fourlink_state *state,
                        double reciprocating, flk_derived *e);

/* Solve for loads and inertia separately; returns a status. */
int flk_derive_superposition(const fourlink_mechanism *mechanism, const fourlink_state *state,
                             const fourlink_load *loads, unsigned long n_loads,
                             const fourlink_forces *forces, flk_derived *e);

#endif
