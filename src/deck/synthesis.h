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
    size_t n_rows;
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
    fourlink_points_task points;
    int has_points; /* 1: motion or path through many positions, by `points` */
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

#endif
