/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck.h - the input deck: from a text to a problem to solve, or to mistakes.
*/
#ifndef FOURLINK_DECK_H
#define FOURLINK_DECK_H

#include "curve.h"
#include "fourlink.h"
#include "base/message.h"
#include "base/units.h"

#define DECK_NAME_SIZE 64

/* The unit in which a quantity is printed and its bare numbers are read. */
typedef struct deck_unit {
    char name[DECK_NAME_SIZE];
    unit unit;
} deck_unit;

/* A list of names in a deck, such as columns, and its place. */
typedef struct deck_names {
    text names;
    text_place place;
} deck_names;

/* The gas in the cylinder; area 0: no gas. */
typedef struct deck_gas {
    double area, back_area; /* m2, of the piston on the cover side and on the crank side */
    double pressure;        /* Pa, on the cover side */
    curve indicator;        /* Pa over the crank angle in rad, instead of pressure */
    double back_pressure;   /* Pa, on the crank side */
} deck_gas;

/* What a load follows in place of the crank angle, and its values on the way back. */
typedef struct deck_law {
    int over; /* OVER_THETA2 ... */
    double exponent,
        at_speed; /* 1; rad/s or m/s: value sign(w) (|w| / at_speed)^exponent; 0: a curve */
    int has_back; /* 1: where its argument falls it has these values */
    fourlink_load back;
    curve back_torque, back_force[2];
} deck_law;

#define FLK_DECK_FOLLOWS(law) ((law)->over || (law)->has_back)

/* In addition to a load: its name, and what changes with the crank angle. */
typedef struct deck_load {
    const char *name; /* of [load NAME]; "": it has none */
    curve torque;     /* over the crank angle, if given as a curve */
    curve force[2];   /* likewise, its components: at the same angles */
    deck_law law;
    int is_windowed; /* 1: it acts only between two crank angles, in every cycle */
    double from, to; /* rad */
} deck_load;

#define DECK_SPRING_COLUMNS 4

typedef struct deck_spring {
    const char *name;
    fourlink_spring spring;
    char *column_names[DECK_SPRING_COLUMNS]; /* NAME.length ... */
} deck_spring;

/* [balance]; without it all is 0. */
typedef struct deck_balance {
    int is_there, crank, rocker;
    fourlink_balance moment; /* of the counterweights */
    double radius;           /* m; 0: not given */
    double reciprocating;    /* kg, of a slider-crank */
    double mass[2];          /* kg, with this radius: of crank and rocker */
} deck_balance;

#define DECK_POINT_COLUMNS 8

/* A tracer point. */
typedef struct deck_point {
    const char *name;
    int link;
    fourlink_vector at;                     /* m, in the link's own axes */
    char *column_names[DECK_POINT_COLUMNS]; /* NAME.x ... */
} deck_point;

/* A value that a source printed. */
typedef struct deck_expectation {
    text_place place;
    text name, value; /* a column or a fact; the printed value */
    text tolerance;   /* empty: half of the last printed digit */
    text_place tolerance_place;
    int misprint; /* 1: known to be wrong */
    int has_at;
    double at; /* crank angle in the deck's unit */
    int has_branch;
    fourlink_branch branch;
} deck_expectation;

/* A quantity of the deck that a sweep varies. */
typedef struct deck_variable {
    text name; /* crank.length */
    quantity q;
    double value;     /* in this design, in the deck's unit */
    double low, high; /* of the neighbours in its range; the value itself at an end, or in a list */
} deck_variable;

/* [sweep]; a deck without one has no variables. */
typedef struct deck_sweep {
    deck_variable *variables;
    size_t n_variables;
    unsigned long n_designs;
    unsigned long design; /* which of them this is */
    deck_names output;    /* empty: rows of each design */
    deck_names yield;     /* its conditions */
    int has_statistics;
} deck_sweep;

enum { SOLVER_MATRIX = 1, SOLVER_DYAD = 2 };

/* How the speed of the crank comes about. */
enum {
    DRIVE_GIVEN = FOURLINK_MODE_GIVEN,   /* as d->motion says */
    DRIVE_FREE = FOURLINK_MODE_FREE,     /* from motion.speed, with or without a motor */
    DRIVE_RUN_UP = FOURLINK_MODE_RUN_UP, /* from rest */
    DRIVE_STEADY = FOURLINK_MODE_STEADY  /* the motion that repeats after d->cycle */
};

/* The actual motion of the machine.  With a mode other than DRIVE_GIVEN, motion.from, to and interval are the
** rows by angle, speed is that of the first row (free; otherwise 0), and acceleration, run_up and hold are 0. */
typedef struct deck_drive {
    int mode;
    fourlink_motor motor; /* FOURLINK_NO_MOTOR: none */
    double flywheel;      /* kg m2, on the shaft outside the crank; 0: none, or wanted (below) */
    double mean_speed;    /* rad/s, steady, with a torque that balances; 0: not given */
    double turns;         /* 1; 0: not given.  motion.to is set from it */
    int by_time;          /* 1: rows by time */
    double time_step, duration; /* s, of rows by time */
    double fluctuation;         /* 1, exact: the flywheel that has it is wanted; 0: not */
} deck_drive;

/* A deck; to hosts of the library it is fourlink_deck, without members. */
typedef struct fourlink_deck deck;

struct fourlink_deck {
    char title[256];
    fourlink_design design;
    fourlink_mechanism mechanism; /* the design, prepared */
    fourlink_motion motion;       /* angles in the deck's unit of angle */
    int one_instant;              /* 1: motion.at */
    int one_revolution;           /* 1: from the first row to the last */
    double cycle;                 /* rad, the period of curves and of the turning moment */
    fourlink_load *loads;
    deck_load *variations; /* for each load */
    unsigned long n_loads;
    deck_spring *springs;
    unsigned long n_springs;
    int has_friction, has_law;
    fourlink_friction friction;
    deck_balance balance;
    deck_point *points;
    size_t n_points;
    deck_gas gas;
    int has_forces; /* 1: the deck has masses, loads or gas */
    fourlink_approximation approximation;
    deck_expectation *expectations;
    size_t n_expectations;
    double flywheel_fluctuation, flywheel_inertia; /* 1, kg m2: 0 if not given */
    deck_drive drive;
    deck_sweep sweep;
    int solver; /* SOLVER_MATRIX, SOLVER_DYAD; 0 if not given */
    int open, crossed;
    int asks_for_both; /* 1: branch = both is given; 0: one, or none */
    deck_names columns;
    int digits;
    deck_unit units[QUANTITY_COUNT];

    mistakes mistakes;    /* none: the deck is valid */
    mistakes notes;       /* what is allowed, but probably not meant */
    struct kept *storage; /* texts that names and places point to */
};

/* Read a deck.
**
** Given:
**    source      its text, and changes to it; not needed after the call
** Returned:
**    d           the deck, for flk_deck_free, even if it has mistakes
** Returned (function value):
**    1 the deck is valid, 0 see d->mistakes, -1 out of memory
** Note:
**    Answers are read only if the deck itself has no mistakes.
*/
int flk_deck_read(const fourlink_source *source, deck *d);

/* Copy the first `max` mistakes or notes of a deck for a host, and their number. */
void flk_deck_give_mistakes(const mistakes *m, unsigned long max, fourlink_mistake *list,
                            unsigned long *n_mistakes);

/* Set up a deck with nothing but the default units; free its memory. */
void flk_deck_start(deck *d);
void flk_deck_free(deck *d);

/* 1 if loads depend on speeds, on springs or on the pin forces: they need the motion. */
int flk_deck_needs_motion(const deck *d);

/* What loads are over: OVER_THETA2 ... */
double flk_deck_argument(const fourlink_state *state, int over);

/* The rows of its motion, as from fourlink_motion_range; of rows by time only their number.  The time of such a row, s. */
int flk_deck_range(const deck *d, fourlink_range *range);
double flk_deck_time(const deck *d, unsigned long row);

/* How many of its loads are springs, behind its own; friction is behind these. */
unsigned long flk_deck_spring_loads(const deck *d);

/* The number of all loads, with the gas. */
unsigned long flk_deck_all_loads(const deck *d);

/* The loads that do not depend on speeds or forces: places for springs and friction are 0 (deck.c). */
void flk_deck_set_loads(const deck *d, fourlink_branch branch, double theta2, fourlink_load *loads,
                        double *gas_force);

/* The same with those that depend on speeds, and springs; places for friction are 0 (forces.c): FOURLINK_OK,
** FOURLINK_NO_DIRECTION. */
int flk_deck_set_moving_loads(const deck *d, const fourlink_state *state, fourlink_load *loads,
                              double *gas_force);

/* How many of its loads are the gas: one on the piston; two on the rod and on the cylinder. */
unsigned long flk_deck_gas_loads(const deck *d);

/* Memory set to 0 that lasts as long as the deck; null if there is none. */
void *flk_deck_keep(deck *d, size_t size);

#endif
