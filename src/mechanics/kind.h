/* SPDX-License-Identifier: GPL-3.0-or-later
**
** kind.h - the table of kinds: what one kind of mechanism adds to what all have in common.
**
** A kind is one file, with everything of it, and one line in the table of kind.c.
*/
#ifndef FOURLINK_KIND_H
#define FOURLINK_KIND_H

#include <stddef.h>

#include "mechanics.h"

/* One moving link, cut free. */
typedef struct flk_body {
    fourlink_vector arm;   /* m, from the link's origin to its centre of mass G */
    fourlink_vector force; /* N, m a_G - W - (sum of forces) */
    double moment;         /* N m, I alpha - (sum of moments about G) */
    double work;           /* N m, power of loads, weight and inertia, unit crank speed */
    double largest;        /* N m, the largest term of it, components taken apart */
} flk_body;

/* A joint of links `from` and `on`: two of the nine unknowns, what `from` exerts on `on`.
**
** pin      the force F_ij, along x and y
** slider   a couple, and a normal force N n that acts at the joint, n the direction of the slide
**          turned left by 90 deg
**
** The joint is at the origin of a link, or at its tip, the other end of its length.  That of a slider
** is at the origin of the link that slides, which does so along its own x axis. */
typedef enum flk_place { FLK_ORIGIN, FLK_TIP } flk_place;

typedef struct flk_joint {
    int from, on;    /* links */
    flk_place place; /* of link `at` */
    int at;
    int slider; /* 0: a pin; else the link that slides */
} flk_joint;

/* One of the nine unknowns, two of each joint and Ts: its name, and the member of fourlink_forces that
** has it; if the joint is a pin, and if it is a slider. */
typedef struct flk_unknown {
    const char *name;
    size_t member;
} flk_unknown;

enum { FLK_PIN, FLK_SLIDER };

extern const flk_unknown flk_unknowns[9][2];

/* Which of the two an unknown is. */
#define FLK_JOINT_OF(kind, i) ((i) < 8 && (kind)->joint[(i) / 2].slider ? FLK_SLIDER : FLK_PIN)

#define FLK_MEMBER(forces, unknown) ((double *)((char *)(forces) + (unknown).member))

/* Whether a link has a length: one that must be positive, or one that may be 0. */
enum { FLK_NO_LENGTH, FLK_LENGTH, FLK_LENGTH_OR_NONE };

/* The functions are called in this order.  The crank and its pin B are placed before `position`,
** moved before `velocity`, accelerated before `acceleration`.
**
** prepare       the constants of the mechanism, from its lengths
** reach         whether links 3 and 4 meet with the crank at the angle whose half has this sine and
**               cosine; `sine` is that of the open branch, change points passed smoothly
** position, velocity, acceleration
**               axis and origin; k, omega and the origin's k and velocity; alpha and the origin's
**               acceleration, of link 3 (but for its origin) and of link 4; what is a kind's own in
**               fourlink_state is zeroed before
** angles        what is left of the position, from theta of links 3 and 4: mu, phi.  Nothing else is
**               computed from these, and so they come last
** forces        closed form: F34, and the unknowns of sliders, zeroed before, from the links cut free, and the moments
**               of links 3 and 4 about their origins
** type, ranges, limits
**               of the mechanism as a whole; ranges and limits are zeroed before
*/
typedef struct flk_kind {
    fourlink_kind kind;
    const char *name;    /* as in a deck */
    const char *words;   /* in a sentence */
    const char *link[5]; /* names of the links, by number */
    int has_length[5];   /* FLK_NO_LENGTH ... */
    flk_joint joint[4];  /* in the order of the unknowns */
    void (*prepare)(fourlink_mechanism *mechanism);
    int (*reach)(const fourlink_mechanism *mechanism, double half_sine, double half_cosine,
                 double *sine);
    void (*position)(const fourlink_mechanism *mechanism, fourlink_state *state);
    void (*velocity)(const fourlink_mechanism *mechanism, fourlink_state *state);
    void (*acceleration)(const fourlink_mechanism *mechanism, fourlink_state *state);
    void (*angles)(const fourlink_mechanism *mechanism, fourlink_state *state);
    void (*forces)(const fourlink_mechanism *mechanism, const fourlink_state *state,
                   const flk_body body[3], double M3, double M4, fourlink_vector *F34,
                   fourlink_forces *forces);
    fourlink_type (*type)(const fourlink_mechanism *mechanism);
    void (*ranges)(const fourlink_mechanism *mechanism, fourlink_reach *reach);
    void (*limits)(const fourlink_mechanism *mechanism, fourlink_branch branch,
                   fourlink_limits *limits);
} flk_kind;

extern const flk_kind flk_four_bar, flk_slider_crank, flk_inverted;

/* The record of a kind; null if there is no such kind. */
const flk_kind *flk_kind_of(fourlink_kind kind);

/* The record of a prepared mechanism, for a function with this output: FOURLINK_OK, FOURLINK_NULL,
** FOURLINK_BAD_KIND. */
int flk_kind_find(const fourlink_mechanism *mechanism, const void *output, const flk_kind **kind);

/* The ranges of crank angles between two limits, either of which may be missing, where the mechanism is
** symmetric: what holds of theta2 holds of `mirror` - theta2. */
void flk_kind_set_ranges(fourlink_reach *reach, int is_low, double lowest, int is_high,
                         double highest, double mirror);

/* For acos and asin, of what rounding, or a mechanism that never reaches, may have taken past 1. */
double flk_kind_clamp(double x);

/* The forces of a position that is not singular, with loads that are in order (closed_form.c). */
void flk_dyad(const flk_kind *kind, const fourlink_mechanism *mechanism,
              const fourlink_state *state, const fourlink_load *loads, unsigned long n_loads,
              fourlink_forces *forces);

#endif
