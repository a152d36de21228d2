/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck.h - the input deck: from a text to a problem, or to a list of mistakes.
*/
#ifndef FOURLINK_DECK_H
#define FOURLINK_DECK_H

#include "fourlink.h"
#include "base/message.h"
#include "base/units.h"
#include "mechanics/coordinate.h"
#include "mechanics/drive.h"
#include "mechanics/machine.h"
#include "mechanics/program.h"
#include "output_columns.h"

#define DECK_NAME_SIZE 64

/* The unit in which a quantity is printed and its bare numbers are read. */
typedef struct deck_unit {
    char name[DECK_NAME_SIZE];
    unit unit;
    int is_given; /* 1: by the deck or the host; 0: it is SI */
} deck_unit;

/* A list of names in a deck, such as columns, with its place. */
typedef struct deck_names {
    text names;
    text_place place;
} deck_names;

/* [balance]; without it all is 0. */
typedef struct deck_balance {
    int is_there, crank, rocker;
    fourlink_balance moment; /* of the counterweights */
    double radius;           /* m; 0: not given */
    double reciprocating;    /* kg, of a slider-crank */
    double mass[2];          /* kg, at this radius: on crank and rocker */
} deck_balance;

/* The pins of a deck with [pins], as drawn, and what follows from their places.  Without [pins] all is 0. */
typedef struct deck_pins {
    int is_there, has_guide;
    int is_rough;      /* 1: the lengths are given, the places only say how it is drawn */
    fourlink_vector A; /* m, on the page */
    double angle;      /* rad, direction of x of link 1 on the page */
    double length[5];  /* m, by link; 0: does not follow */
    double offset;     /* m, of the line of stroke or guide */
    int has_slide;     /* 1: a lever's length and slide follow */
    double slide;      /* rad, angle of the slide from the line D-C */
    double theta2;     /* rad, the crank as drawn, from x of link 1 */
    double side; /* 1, sine of the angle between the links that meet in line in a dead position */
    int branch;  /* as drawn; 0: not determined */
    fourlink_vector origin[FOURLINK_LINKS],
        axis[FOURLINK_LINKS]; /* m, 1: of the links, as drawn on the page; axis 0 of
                                                                    those of an output that cannot be assembled there */
} deck_pins;

enum { AXES_GROUND = 1, AXES_PAGE = 2 };

/* The axes of directions and places on the ground: those of link 1, or those of the page.  In them link
** 1 has its origin A at a place, and its x axis at an angle, here with cosine and sine. */
typedef struct deck_axes {
    int is_page;
    fourlink_vector A; /* m */
    double angle;      /* rad; of the axes of link 1 all is 0, and the cosine 1 */
    double cosine, sine;
    fourlink_vector gravity; /* m/s2, in these axes */
} deck_axes;

#define DECK_POINT_COLUMNS 8

/* A tracer point. */
typedef struct deck_point {
    const char *name;
    int link;
    fourlink_vector at;                     /* m, in the link's own axes */
    char *column_names[DECK_POINT_COLUMNS]; /* NAME.x ... */
} deck_point;

/* An [output]: the names of its links, of its columns.  Its data are those of the group with its number. */
typedef struct deck_output {
    const char *name[2]; /* NAME.rod, NAME */
    const char *apart;   /* that it cannot be assembled */
    const char *column_names[OUTPUT_COLUMNS];
    const char *fact_names[OUTPUT_FACTS];
} deck_output;

/* A value that a source printed. */
typedef struct deck_expectation {
    text_place place;
    text name, value; /* a column or a fact; the printed value */
    text tolerance;   /* empty: half a unit of the last printed digit */
    text_place tolerance_place;
    int misprint;  /* 1: known to be wrong */
    int is_answer; /* 1: of a file of answers, whose bare numbers have the units of a table */
    int has_at;
    double at;       /* crank angle in the deck's unit; */
    int at_is_place; /* 1: a place of what the rows go over, s, m or rad */
    int has_branch;
    fourlink_branch branch;
    int side; /* at a place of an input of which the rows are on both sides; else 0 */
} deck_expectation;

/* How values are graded, whatever their sections say: tolerances and marks, separated by commas. */
typedef struct deck_rule {
    text name; /* of a column or fact, or NAME at ANGLE; empty: all others */
    text items;
    text_place place;
} deck_rule;

/* A quantity of the deck that a sweep varies. */
typedef struct deck_variable {
    text name; /* crank.length */
    quantity q;
    double value;         /* in the deck's unit */
    unsigned long number; /* as from flk_number_find */
} deck_variable;

/* A number of the deck that a host sets. */
typedef struct deck_number {
    unsigned long id; /* from flk_number_find */
    double value;     /* in this unit */
    deck_unit unit;
} deck_number;

/* [sweep]; a deck without one has no variables. */
typedef struct deck_sweep {
    deck_variable *variables;
    size_t n_variables;
    unsigned long n_designs;
    unsigned long design; /* the number of this design */
    deck_names output;    /* empty: rows of each design */
    deck_names yield;     /* the conditions of the yield */
} deck_sweep;

/* The decimal mark of answers. */
enum { DECIMAL_POINT = 1, DECIMAL_COMMA = 2 };

enum { SOLVER_MATRIX = 1, SOLVER_DYAD = 2 };

enum {
    MODE_GIVEN = FOURLINK_MODE_GIVEN,   /* as d->motion says */
    MODE_FREE = FOURLINK_MODE_FREE,     /* from motion.speed, with or without a motor */
    MODE_RUN_UP = FOURLINK_MODE_RUN_UP, /* from rest */
    MODE_STEADY = FOURLINK_MODE_STEADY  /* the motion that repeats after d->machine.cycle */
};

/* How the speed of the crank is found.  With a kind other than MODE_GIVEN, motion.from, to and interval
** describe the rows by angle, speed is that of the first row (free; otherwise 0), and acceleration, run_up
** and hold are 0. */
typedef struct deck_mode {
    int kind;
    double mean_speed;          /* rad/s, steady motion with a torque that balances; 0: not given */
    double turns;               /* 1; 0: not given.  motion.to is set from it */
    double time_step, duration; /* s, of rows by time; 0 of others */
    double fluctuation;         /* 1, exact: find the flywheel with this fluctuation; 0: none */
} deck_mode;

/* What is prescribed in place of the crank angle: [motion] input. */
typedef struct deck_prescribed {
    const flk_coordinate *q;
    int side;               /* FOURLINK_RISING, FOURLINK_FALLING; of the first rows */
    int has_both;           /* 1: as many rows again are on the falling side */
    fourlink_motion motion; /* of the coordinate, rad or m, in the deck's axes */
    int is_at_crank;        /* 1: one instant at a crank angle, */
    double theta2;          /* rad */
    flk_stretch
        stretch[2][2]; /* over which the rows go, on the open and on the crossed branch, by side */
    const flk_program
        *program; /* of the coordinate, over whose time the rows go; null: over the coordinate */
} deck_prescribed;

/* The stretch of a branch and a side. */
#define DECK_STRETCH(prescribed, branch, side) \
    (&(prescribed)->stretch[(branch) == FOURLINK_CROSSED][(side) == FOURLINK_FALLING])

/* 1 if the rows of a deck go over what is prescribed in place of the crank angle. */
#define DECK_GOES_OVER_INPUT(d) ((d)->prescribed && !(d)->program)

/* 1 if they do so twice: on its rising side, then on its falling one. */
#define DECK_HAS_BOTH_SIDES(d) (DECK_GOES_OVER_INPUT(d) && (d)->prescribed->has_both)

/* A deck; programs that use the library see an opaque fourlink_deck. */
typedef struct fourlink_deck deck;

struct fourlink_deck {
    char title[256];
    deck_pins pins;
    deck_axes axes;
    double inclination;     /* rad, of link 1 on the page */
    flk_machine machine;    /* the mechanism with its design, elements, friction, motor */
    fourlink_motion motion; /* angles in the deck's unit of angle */
    int one_instant;        /* 1: motion.at */
    int one_revolution;     /* 1: from the first row to the last */
    deck_balance balance;
    deck_output *outputs; /* as many as the mechanism has groups */
    fourlink_group *groups;
    deck_point *points;
    size_t n_points;
    flk_actuator *actuators;
    size_t n_actuators;
    int has_forces; /* 1: the deck has masses, loads or gas, or a drive that is not the crank */
    fourlink_approximation approximation;
    deck_expectation *expectations;
    size_t n_expectations;
    deck_rule *rules; /* of [grading] */
    size_t n_rules;
    double fewest_digits;        /* of a value; 0: any */
    double pin_radius[4];        /* m, of A to D; 0: not given */
    double late;                 /* deduction for a day, of 1 */
    int shows_answers;           /* 1: feedback has the computed values */
    int is_strict;               /* 1: a bare answer in another unit is wrong */
    int is_half_for_hint;        /* 1: a wrong answer with a hint gets half of its marks */
    char task[1000];             /* the words of the exercise */
    int decimal;                 /* DECIMAL_POINT ...; 0: as a file of answers has it */
    double flywheel_fluctuation; /* 0 if not given */
    deck_mode mode;
    int has_cylinder; /* 1: the slide is a cylinder by name, as that of a boom */
    const flk_program
        *program; /* of the crank or the input over time; null: the motion is another */
    deck_prescribed *prescribed;   /* in place of the crank angle; null: it is the crank angle */
    const fourlink_abscissa *over; /* what its rows go over, but for the numbers */
    deck_sweep sweep;
    unsigned long solution; /* the solution of [synthesis] that is asked for, from 1; 0: none */
    unsigned long effort;   /* how many times the usual starts a search has; 0: once */
    const struct fourlink_solution *near; /* its only start, while the deck is read; or null */
    struct deck_synthesis *synthesis;     /* its task, and what was found; null: there is none */
    const struct deck_synthesis *solved;  /* the same task, solved before; null: it was not */
    int solver;                           /* SOLVER_MATRIX, SOLVER_DYAD; 0 if not given */
    int open, crossed;
    int asks_for_both; /* 1: branch = both is given; 0: one, or none */
    deck_names columns;
    int has_values; /* 1: they were values of the deck, which are its outputs */
    int digits;
    deck_unit units[QUANTITY_COUNT]; /* of results */
    deck_unit bare[QUANTITY_COUNT];  /* of bare numbers in the text */
    deck_unit shown[QUANTITY_COUNT]; /* of results in a table, and of bare numbers in answers */

    mistakes mistakes;                 /* none: the deck is valid */
    mistakes defects;                  /* of the linkage found by synthesis */
    mistakes slips;                    /* lines of the answers that are not read */
    mistakes notes;                    /* on what is allowed but probably not meant */
    struct parser *settings, *answers; /* the content of its texts; null: not read */
    struct parser *found; /* the settings with the linkage found; null: there is none */
    struct kept *storage; /* texts that names and places point to */
};

/* Copy the first `max` mistakes or notes of a deck, and their number, for the caller. */
void flk_deck_give_mistakes(const mistakes *m, unsigned long max, fourlink_mistake *list,
                            unsigned long *n_mistakes);

/* Set the units of all quantities to SI, and degrees, as of a deck that gives none. */
void flk_deck_set_si(deck_unit *units);

/* Set up a deck with nothing but these units; free its memory. */
void flk_deck_start(deck *d);
void flk_deck_free(deck *d);

/* What rows can go over: by the word of [motion] rows; by that of `input`, after these. */
#define DECK_OVER_INPUT 1 /* added to the word */
extern const fourlink_abscissa flk_abscissas[2 + FLK_COORDINATES];

/* The rows of a deck: the crank angles of its motion, as from fourlink_motion_range, with the number of the
** rows; what they go over. */
int flk_deck_rows(const deck *d, fourlink_range *range, fourlink_abscissa *over);

/* The number of the output, of the actuator of this name, from 0; -1: there is none. */
int flk_deck_output(const deck *d, text name);
int flk_deck_actuator(const deck *d, text name);

/* The quantity of what the rows go over. */
quantity flk_deck_over(const deck *d);

/* The crank angle as drawn, rad, in the axes of the deck: (-pi, pi]. */
double flk_deck_drawn(const deck *d);

/* A direction in the axes of link 1 in those of the deck, rad: (-pi, pi]. */
double flk_deck_direction(const deck *d, double angle);

/* Memory set to 0, valid as long as the deck; null if out of memory. */
void *flk_deck_keep(deck *d, size_t size);

#endif
