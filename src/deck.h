/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck.h - the input deck: text in, a problem to solve out, or its mistakes.
*/
#ifndef FOURLINK_DECK_H
#define FOURLINK_DECK_H

#include "curve.h"
#include "fourlink.h"
#include "units.h"

#define DECK_NAME_SIZE 64

/* A unit in which a quantity is printed, and in which bare numbers of it are read. */
typedef struct deck_unit {
    char name[DECK_NAME_SIZE];
    unit unit;
} deck_unit;

/* A list of names in a deck, such as columns, and where it stands. */
typedef struct deck_names {
    text names;
    text_place place;
} deck_names;

/* The gas in the cylinder; area 0: there is none. */
typedef struct deck_gas {
    double area, back_area; /* m2, of the piston on the cover side and on the crank side */
    double pressure;        /* Pa, on the cover side */
    curve indicator;        /* Pa over the crank angle in rad, in place of pressure */
    double back_pressure;   /* Pa, on the crank side */
} deck_gas;

/* Beside a load: what changes with the crank angle. */
typedef struct deck_load {
    curve torque;    /* over the crank angle, if it has such a curve */
    int is_windowed; /* 1: it acts between two crank angles only, in every cycle */
    double from, to; /* rad */
} deck_load;

#define DECK_POINT_COLUMNS 8

/* A tracer point. */
typedef struct deck_point {
    text name;
    int link;
    fourlink_vector at;                     /* m, in the link's own axes */
    char *column_names[DECK_POINT_COLUMNS]; /* NAME.x ... */
} deck_point;

/* A value that a source printed. */
typedef struct deck_expectation {
    text_place place;
    text name, value; /* a column or a fact; what was printed */
    text tolerance;   /* empty: half of the last printed digit */
    text_place tolerance_place;
    int misprint; /* 1: known to be wrong */
    int has_at;
    double at; /* crank angle in the deck's unit */
    fourlink_branch branch;
} deck_expectation;

typedef struct deck {
    char title[256];
    fourlink_design design;
    fourlink_mechanism mechanism; /* the design, prepared */
    fourlink_motion motion;       /* angles in the deck's unit of angle */
    int one_instant;              /* 1: motion.at */
    int one_revolution;           /* 1: the last row repeats the first */
    double cycle;                 /* rad, the period of curves and of the turning moment */
    fourlink_load *loads;
    deck_load *variations; /* for each load */
    unsigned long n_loads;
    deck_point *points;
    size_t n_points;
    deck_gas gas;
    int has_forces; /* 1: the deck has masses, loads or gas */
    fourlink_approximation approximation;
    deck_expectation *expectations;
    size_t n_expectations;
    double flywheel_fluctuation, flywheel_inertia; /* 1, kg m2: 0 if the deck does not say */
    int open, crossed;
    deck_names columns;
    int digits;
    deck_unit units[QUANTITY_COUNT];

    mistakes mistakes;    /* none: the deck is in order */
    struct kept *storage; /* the texts that names and places point to */
} deck;

/* A change to a deck from outside it: [SECTION[ NAME].]KEY=VALUE. */
typedef struct deck_change {
    const char *option; /* for messages, such as "--set" */
    const char *assignment;
} deck_change;

/* How a deck gets at the files that it names: all of the file in memory from malloc, null if it
** cannot be read.  `deck_name` is the name given to deck_read. */
typedef char *deck_loader(const char *deck_name, const char *file_name, size_t *length);

/* Read a deck.
**
** Given:
**    name        for messages: the file's name
**    contents    the deck's text
**    load        for files that the deck names; null: it may name none
**    changes     assignments that replace or add to those of the deck
** Returned:
**    d           the deck; to be given to deck_free also where it is full of mistakes
** Returned (function value):
**    1 the deck is in order, 0 see d->mistakes, -1 out of memory
*/
int deck_read(const char *name, text contents, deck_loader *load, const deck_change *changes,
              size_t n_changes, deck *d);

/* Add the [expect] and [misprint] sections of another text to a deck.  As deck_read. */
int deck_add_expectations(const char *name, text contents, deck *d);

/* Read a value with a unit, in SI units; `digit` is that of its last digit.  0 and a mistake of the
** deck if it is none of that quantity. */
int deck_read_quantity(deck *d, text_place place, text value, quantity q, double *si,
                       double *digit);

void deck_free(deck *d);

#endif
