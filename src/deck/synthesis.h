/* SPDX-License-Identifier: GPL-3.0-or-later
**
** synthesis.h - [synthesis]: a task, and the linkage found for it, which the deck then has.
*/
#ifndef FOURLINK_DECK_SYNTHESIS_H
#define FOURLINK_DECK_SYNTHESIS_H

#include "deck.h"
#include "schema.h"

struct parser;

/* What a kind of mechanism has in its tasks. */
typedef struct deck_task_kind {
    fourlink_kind kind;

    /* a function generator: its output; K of its equations, and what follows from them */
    quantity output;
    key_code range;
    const char *column, *example; /* its name; a range */
    const char *constants;

    /* a quick return: its type; how many lengths are given for the best one; what is given, in words */
    fourlink_type type;
    int n_best;
    const char *quick_return;

    key_code besides;       /* what is found besides lengths: offset or angle; or KEY_COUNT */
    const char *outputs[2]; /* of a [sweep]; of one with a function, or the stroke of a lever */
} deck_task_kind;

/* The wanted function y = f(x): crank angle and output are linear in x and y.  Two numbers are those at both
** ends of the range. */
typedef struct deck_wanted {
    int f; /* which function */
    double exponent;
    const double *table_x, *table_y; /* of a table */
    unsigned long n_rows;
    double x[2], y[2];
    double crank[2], output[2]; /* rad, rad or m */
} deck_wanted;

typedef struct deck_synthesis {
    deck_task task;
    const char *name; /* of the task */
    const deck_task_kind *kind;
    text_place place;
    fourlink_function_task function;
    fourlink_motion_task motion;
    fourlink_path_task path;
    fourlink_quick_return_task quick_return;
    fourlink_cognate_task cognate;
    deck_wanted wanted;
    double mu_min; /* rad, below which there is a note */
    double theta2[FOURLINK_PRECISION_MAX], output[FOURLINK_PRECISION_MAX],
        weight[FOURLINK_PRECISION_MAX];
    int scaled_link;      /* function: the link that is given in place of the ground; or 0 */
    double scaled_length; /* m */
    deck_unit length;     /* in which the lengths found are written */
    fourlink_solution *solutions;    /* those kept */
    unsigned long n_kept, n;         /* how many are kept, and how many there are */
    const fourlink_solution *chosen; /* null: there is none */
    int status;                      /* FOURLINK_OK, or why there is no linkage */
    char defects[80];                /* of the chosen one: branch, order; none */
    const char *head, *tail;         /* what the text of the deck found begins and ends with */
} deck_synthesis;

/* 1 for a status that says why a task has no linkage. */
#define FLK_IS_NO_LINKAGE(status) \
    ((status) >= FOURLINK_DEPENDENT && (status) <= FOURLINK_NONE_FOUND)

#define FLK_DEGREES(angle) ((angle) * (180 / M_PI))

#define MOST_LISTED 10 /* solutions of a search */

/* Read the task; find the linkage.  They return 0 after a mistake, or if there is no linkage. */
int flk_synthesis_read(struct parser *p);
int flk_synthesis_run(struct parser *p);

/* Set the lengths of the linkage found, its working range, branch and coupler point, and write its text. */
void flk_synthesis_assign(struct parser *p);

/* The structural error at a crank angle of the linkage found, rad or m; NaN where the wanted function is not
** defined, or the linkage does not reach. */
double flk_synthesis_error(const deck_synthesis *t, double theta2);

/* A quantity, or a point, with its unit, so that it is read again as the same number; valid as long as the
** deck. */
const char *flk_found_value(struct parser *p, double si, quantity q);
const char *flk_found_point(struct parser *p, fourlink_vector at);

/* Write what the text of the deck begins and ends with; the coupler point has this name. */
void flk_found_write(struct parser *p, const char *point_name);

/* Tell the defects of the linkage found: their names in `defects`, sentences in those of the deck. */
void flk_synthesis_tell_defects(struct parser *p);

#endif
