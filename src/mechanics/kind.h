/* SPDX-License-Identifier: GPL-3.0-or-later
**
** kind.h - the table of kinds: what each kind of mechanism adds to the common part.
**
** A kind is one file, and one line in the table of kind.c.
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
    double largest;        /* N m, its largest term, counting components separately */
} flk_body;

/* One of the nine unknowns (two per joint, and Ts): its name and member of fourlink_forces, if the joint is a
** pin, and if it is a slider. */
typedef struct flk_unknown {
    const char *name;
    size_t member;
} flk_unknown;

enum { FLK_PIN, FLK_SLIDER };

extern const flk_unknown flk_unknowns[9][2];

/* Which of the two applies to an unknown. */
#define FLK_JOINT_OF(kind, i) ((i) < 8 && (kind)->joint[(i) / 2].slider ? FLK_SLIDER : FLK_PIN)

#define FLK_MEMBER(forces, unknown) ((double *)((char *)(forces) + (unknown).member))

/* Whether a link has a length, which must be positive or may be 0. */
enum { FLK_NO_LENGTH, FLK_LENGTH, FLK_LENGTH_OR_NONE };

/* The functions are called in this order.  The crank and its pin B are placed before `position`,
** moved before `velocity`, accelerated before `acceleration`.
**
** prepare       sets the constants of the mechanism, from its lengths; a status
** reach         whether links 3 and 4 meet, given sine and cosine of half the crank angle; `sine` is that
**               of the open branch, smooth through change points
** position, velocity, acceleration
**               axis and origin; k, omega and the origin's k and velocity; alpha and the origin's
**               acceleration, of link 3 (except its origin) and of link 4; a kind's own members of
**               fourlink_state are set to 0 before
** angles        the rest of the position, from theta of links 3 and 4: mu, phi.  They come last because
**               nothing else depends on them
** forces        closed form: F34, and the unknowns of sliders, which are 0 before, from the links cut
**               free, and the moments of links 3 and 4 about their origins
** type, ranges, limits
**               of the mechanism as a whole; ranges and limits are set to 0 before
** turns         the angle of link 3 or 4, continuous in theta2 (turns.c)
** balance       the counterweights; `fraction` of a reciprocating mass (balance.c)
** swing         the motion of a dead position, from omega and alpha of link 3, which is placed and turns
**               about B, where the crank stands still: alpha of the crank, and of link 4 as `velocity` and
**               `acceleration`, with k for a unit of omega3; null where there is no dead position
** theta2_of     the crank angle, rad, less whole turns, at which a coordinate (coordinate.h) has a value, with links 3
**               and 4 on the side of this branch, where it rises (1) or falls (-1); NaN if there is none
*/
typedef struct flk_kind {
    fourlink_kind kind;
    const char *name;    /* as in a deck */
    const char *words;   /* in a sentence */
    const char *link[5]; /* names of the links, by number */
    int has_length[5];   /* FLK_NO_LENGTH ... */
    int has_one_branch;  /* 1: there is one assembly mode, the open branch */
    fourlink_type first_type, last_type;
    double folded; /* rad, theta2 of the folded change point; half a turn from the stretched one */
    fourlink_joint joint[4]; /* in the order of the unknowns */
    fourlink_shape shape[5]; /* of the moving links */
    int drawn[3];            /* the moving links, each in front of those before */
    int (*prepare)(fourlink_mechanism *mechanism);
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
    double (*turns)(const fourlink_mechanism *mechanism, const fourlink_state *state, int link);
    void (*balance)(const fourlink_mechanism *mechanism, double fraction,
                    fourlink_balance *balance);
    void (*swing)(const fourlink_mechanism *mechanism, fourlink_state *state);
    double (*theta2_of)(const fourlink_mechanism *mechanism, int coordinate, fourlink_branch branch,
                        int side, double value);
} flk_kind;

/* The angle, rad, opposite the first of three sides of a triangle; `slack` is the sum of the first two
** less the third.  NaN if they do not close. */
double flk_kind_angle(double opposite, double p, double q, double slack);

extern const flk_kind flk_four_bar, flk_slider_crank, flk_inverted, flk_scotch_yoke;

/* The crank of an engine with a stroke; half the stroke for one that this rod (0: a yoke, which has
** none) and offset do not allow. */
double flk_slider_crank_of_stroke(double stroke, double rod, double offset);

/* The record of a kind; null if the kind does not exist. */
const flk_kind *flk_kind_of(fourlink_kind kind);

/* 1 if two links of this kind slide on each other; 0: all joints are pins. */
int flk_kind_has_slide(fourlink_kind kind);

/* 1 if it can be assembled on this branch. */
int flk_kind_has_branch(const flk_kind *kind, fourlink_branch branch);

/* The record of a prepared mechanism, for a function with this output: FOURLINK_OK, FOURLINK_NULL,
** FOURLINK_BAD_KIND. */
int flk_kind_find(const fourlink_mechanism *mechanism, const void *output, const flk_kind **kind);

/* Set the ranges of crank angles between two limits, either of which may be missing, for a symmetric
** mechanism: theta2 and `mirror` - theta2 are equivalent. */
void flk_kind_set_ranges(fourlink_reach *reach, int is_low, double lowest, int is_high,
                         double highest, double mirror);

/* Limit x to -1 ... 1, for acos and asin: it may be outside by rounding, or if the linkage cannot be
** assembled. */
double flk_kind_clamp(double x);

/* A position whose forces are to be found, for any loads.  The nine equations have their matrix,
** factored (nine_equations.c): banded, and with a drive that is not the crank with a wider band.  The
** closed form has the forces of such a drive with the effort 1. */
#define FLK_BELOW 3 /* the band of the matrix, beside its diagonal */
#define FLK_ABOVE 2
#define FLK_BAND (2 * FLK_BELOW + FLK_ABOVE + 1)
#define FLK_WIDE 4 /* below and above */
#define FLK_WIDE_BAND (2 * FLK_WIDE + FLK_WIDE + 1)

typedef struct flk_drive flk_drive;

typedef struct flk_factors {
    double A[9 * FLK_WIDE_BAND];
    unsigned int pivot[9];
    double moment[5]; /* factors of the moment equations, by link number */
    double K,
        scale; /* of a drive: its power at unit crank speed; its effort, for an unknown of 1 */
    fourlink_forces unit; /* of a drive with the effort 1 */
} flk_factors;

/* Apply the loads to the free bodies of links 2 to 4, with the forces of the groups on them, and the groups'
** virtual work (group.c). */
void flk_groups_cut(const fourlink_mechanism *mechanism, const fourlink_state *state,
                    const fourlink_load *loads, unsigned long n_loads, int closed_form,
                    flk_body body[3]);

/* Apply loads on any links to free bodies of links 2 to 4, on which groups without mass pass them. */
void flk_groups_pass(const fourlink_mechanism *mechanism, const fourlink_state *state,
                     const fourlink_load *loads, int n_loads, int closed_form, flk_body body[3]);

/* How the nine unknowns are found from the free bodies, without checking them.
**
** factor    FOURLINK_OK, FOURLINK_SINGULAR; of a drive FOURLINK_INPUT_DEAD_CENTRE, FOURLINK_NO_DIRECTION
** solve     for the bodies of this position, as often as there are loads
*/
typedef struct flk_solver {
    int (*factor)(const flk_kind *kind, const fourlink_mechanism *mechanism,
                  const fourlink_state *state, flk_factors *factors);
    void (*solve)(const flk_kind *kind, const fourlink_mechanism *mechanism,
                  const fourlink_state *state, const flk_factors *factors, const flk_body body[3],
                  fourlink_forces *forces);
} flk_solver;

extern const flk_solver flk_closed_form, flk_nine_equations;

/* The joint of load i of fourlink_losses, 0 to 3 for A, B, C, D; the link on which it acts (friction.c). */
extern const int flk_friction_joint[FOURLINK_FRICTION_LOADS];
int flk_friction_link(const flk_kind *kind, unsigned long i);

#endif
