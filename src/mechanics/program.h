/* SPDX-License-Identifier: GPL-3.0-or-later
**
** program.h - how a coordinate goes over time: points that it passes, and a law between them.
*/
#ifndef FOURLINK_PROGRAM_H
#define FOURLINK_PROGRAM_H

/* From point to point a spline, or a rise from rest to rest; a linear one jumps in speed. */
#define FLK_LAWS(X)                                  \
    X(SPLINE, "spline", spline)                      \
    X(HARMONIC, "harmonic", harmonic)                \
    X(CYCLOIDAL, "cycloidal", cycloidal)             \
    X(POLYNOMIAL_5, "3-4-5", polynomial_5)           \
    X(POLYNOMIAL_7, "4-5-6-7", polynomial_7)         \
    X(MODIFIED_SINE, "modified-sine", modified_sine) \
    X(CUBIC, "cubic", cubic)                         \
    X(TRAPEZOID, "trapezoid", trapezoid)             \
    X(LINEAR, "linear", linear)

#define FLK_LAW(code, name, function) FLK_LAW_##code,
typedef enum flk_law { FLK_LAWS(FLK_LAW) FLK_LAW_COUNT } flk_law;

/* The words of a deck, which end with a null pointer. */
extern const char *const flk_law_names[];

/* How splines end: without curvature; at a speed; as they begin. */
typedef enum flk_program_ends {
    FLK_ENDS_NATURAL,
    FLK_ENDS_SPEEDS,
    FLK_ENDS_PERIODIC
} flk_program_ends;

/* Between two points. */
typedef struct flk_program_segment {
    double begin, length; /* s */
    double value, rise;   /* of the points */
    flk_law law;
    double ramp[2];    /* of a trapezoid: where its speed has risen, and how long it falls, of 1 */
    double bend[2];    /* of a spline: the second derivatives at its ends */
    double coordinate; /* at its beginning, where the points are speeds */
} flk_program_segment;

typedef struct flk_program {
    unsigned long n;              /* segments */
    flk_program_segment *segment; /* in the order of time */
    flk_program_ends ends;
    double speed[2]; /* at the ends of a spline, FLK_ENDS_SPEEDS */
    int is_angle;    /* 1: of an angle, rad, in which whole turns count; 0: of a length, m */
    int is_of_speed; /* 1: the points are speeds; the coordinate is their integral */
    double from;     /* ... from here */
} flk_program;

/* Find the splines, and the coordinate where points are speeds, of a program with segments that have all but
** `bend` and `coordinate`; `room` is for 3 numbers a segment. */
void flk_program_prepare(flk_program *p, double *room);

/* The coordinate, its speed and acceleration at a time.  Where the acceleration jumps it is that of the
** segment that begins, at the end of the program that of the last one. */
void flk_program_at(const flk_program *p, double time, double x[3]);

/* The highest speed, or nearly so. */
double flk_program_highest(const flk_program *p);

double flk_program_end(const flk_program *p);

/* The next time after this one at which a segment, or a part of its law, begins; the end after the last. */
double flk_program_corner(const flk_program *p, double time);

/* The segment that a time is in: the last that begins at or before it, or the first. */
const flk_program_segment *flk_program_segment_at(const flk_program *p, double time);

/* The end of the way on which the coordinate goes one way from a time: a corner, or where it turns back. */
double flk_program_way(const flk_program *p, double from);

/* The first time at which it passes a value; 0 if there is none. */
int flk_program_pass(const flk_program *p, double value, double *time);

/* The lowest and the highest value, and how far it goes to and fro. */
typedef struct flk_program_reach {
    double low, high, travel;
} flk_program_reach;

void flk_program_limits(const flk_program *p, flk_program_reach *reach);

/* 1 if it is at rest at a time t0, without acceleration: where it stays, or a segment begins or ends.  Then
**
**    q - q0 = c (t - t0)^4
**
** gives c: 0 where it stays, or where the first power is a higher one; NaN where that is a lower one. */
int flk_program_from_rest(const flk_program *p, double time, double *c);

#endif
