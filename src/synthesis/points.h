/* SPDX-License-Identifier: GPL-3.0-or-later
**
** points.h - a linkage whose coupler point passes many points: its unknowns, and their descent.
*/
#ifndef FOURLINK_POINTS_H
#define FOURLINK_POINTS_H

#include "synthesis.h"

/* The unknowns of a linkage in the units of flk_points, and then one crank angle for each position.
**
** AX to DY are the pivots; of a slider-crank, D is A plus the rod turned into the direction of stroke.
** QX and QY are the coupler point in the coupler's axes, relative to AD.  SHAPE are three numbers for
** the ratios of the links, see trace.c.  START is the crank angle of the first position, with timing;
** ATTITUDE is the angle of the coupler at which the wanted angle is 0. */
enum {
    FLK_AX,
    FLK_AY,
    FLK_DX,
    FLK_DY,
    FLK_QX,
    FLK_QY,
    FLK_SHAPE,
    FLK_START = FLK_SHAPE + 3,
    FLK_ATTITUDE,
    FLK_UNKNOWNS
};

/* What is wanted, with its centre at 0 and a root mean square distance of 1 from there. */
typedef struct flk_points {
    fourlink_kind kind;
    unsigned long n;
    int has_timing, has_angle;
    fourlink_vector point[FOURLINK_POSITIONS_MAX];
    double angle[FOURLINK_POSITIONS_MAX];  /* rad, of the coupler */
    double timing[FOURLINK_POSITIONS_MAX]; /* rad, rotation of the crank from the first position */
    double root[FOURLINK_POSITIONS_MAX];   /* root of the weight */
    double low[FLK_UNKNOWNS], high[FLK_UNKNOWNS];
    double most_cosine;       /* largest |cos(mu)| in the working range; 1: any */
    double shortest, longest; /* bounds of the links' lengths */
    double length_ratio;      /* of the longest to the shortest */
    int is_bounded;         /* 1: there are such bounds, of lengths or of the transmission angle */
    double stiffness;       /* what a cosine or a length beyond counts */
    fourlink_vector centre; /* m */
    double size;            /* m */
} flk_points;

/* A linkage, and its sum of squares; infinite: it does not reach all positions. */
typedef struct flk_trial {
    double x[FLK_UNKNOWNS], theta2[FOURLINK_POSITIONS_MAX], sum;
    int sign;        /* 1: open, -1: crossed */
    int sense;       /* 1, or -1: the crank turns against the timing */
    int turns_fully; /* 1: the shape is that of a crank that turns fully */
} flk_trial;

/* The ratios of the links, with their derivatives: crank, coupler and rocker to the ground; or crank and
** offset to the rod. */
typedef struct flk_shape {
    double ratio[3], by[3][3]; /* by[i][k] = d ratio[i] / d x[FLK_SHAPE + k] */
    int is_slider, sign;
} flk_shape;

/* Directions of crank and coupler where D is at (1, 0), and how the coupler turns with the three numbers of
** the shape and with the crank. */
typedef struct flk_pose {
    fourlink_vector crank, coupler;
    double turn[4];
} flk_pose;

/* Number i of Halton's of a base, between 0 and 1 (points.c). */
double flk_halton(unsigned long i, unsigned long base);

/* The links that hold the coupler in five poses: where each is pinned, wx and wy in the coupler's axes,
** from its point, turned by its angle, and mx and my on the ground.  Returns how many there are
** (burmester.c). */
#define FLK_POSES 5
#define FLK_LINKS 4
int flk_burmester(const flk_points *p, double links[FLK_LINKS][4]);

/* The linkage of two of them, the first of which is the crank; its branch stays 0. */
void flk_burmester_linkage(const flk_points *p, const double crank[4], const double rocker[4],
                           fourlink_solution *found);

/* The shape of a trial (trace.c). */
void flk_shape_of(const flk_points *p, const flk_trial *at, flk_shape *shape);

/* The shape and the linkage of a trial, from a solution for the same number of points (trace.c). */
void flk_trial_from(const flk_points *p, const fourlink_solution *from, flk_trial *at);

/* The pose at a crank angle; 0 if the linkage does not reach it (trace.c). */
int flk_pose_at(const flk_shape *shape, double theta2, flk_pose *pose);

/* cos(mu) of the transmission angle at a crank angle, and its derivatives by the three numbers of the
** shape and by the angle (trace.c). */
double flk_transmission(const flk_shape *shape, double theta2, double by[4]);

/* Solve H x = g, H symmetric and positive definite, which is overwritten; 0 if it is not (descent.c). */
int flk_solve_normal(int n, double H[][FLK_UNKNOWNS], const double *g, double *x);

/* The pivots that are free and the coupler point with the least sum of squares for given ratios and crank
** angles, a linear problem; 0 if there is none (descent.c). */
int flk_fit_pivots(const flk_points *p, flk_trial *at);

/* Descend to a least sum of squares, by at most `steps` steps, until a step lessens it by less than
** `last_decrease` of it (descent.c). */
void flk_descend(const flk_points *p, flk_trial *at, int steps, double last_decrease);

/* Without timing, turn the crank at each position to where the linkage is nearest to it (descent.c). */
void flk_settle(const flk_points *p, flk_trial *at);

#endif
