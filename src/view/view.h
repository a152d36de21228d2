/* SPDX-License-Identifier: GPL-3.0-or-later
**
** view.h - what of a deck is to be shown: its branches, columns, units, and what its kind of mechanism has.
**
** Tables, pictures, report and page take a deck's results once, as a view.
*/
#ifndef FOURLINK_VIEW_H
#define FOURLINK_VIEW_H

#include "base/quantity.h"
#include "system/format.h"
#include "fourlink.h"

/* Not to be copied: it points into itself. */
typedef struct view {
    fourlink_results *results;
    const fourlink_deck *deck;
    fourlink_problem problem;
    const fourlink_mechanism *mechanism; /* of the problem */
    const fourlink_design *design;
    fourlink_kind_facts kind;
    fourlink_branch branches[2]; /* that the deck asks for */
    int n_branches;
    fourlink_range range; /* by time, with the number of its rows */
    double
        end; /* the last place of the motion; by angle, of a machine that stalls on all branches, just
                   before that once its motion is found */
    fourlink_unit units[QUANTITY_COUNT];
    quantity over;                 /* of problem.over */
    double lever_low, lever_high;  /* m, how far a slotted lever reaches along its axis from D */
    const fourlink_value *columns; /* of its table */
    unsigned long n_columns;
} view;

/* Take the results of a deck, which stay the caller's. */
void view_take(view *v, fourlink_results *results);

/* Take another design of the same deck, which has the same units. */
void view_take_design(view *v, fourlink_results *results);

/* Find the motion of the branches, which of a machine is integrated: this is called before anything else
** that follows from the motion, such as rows, is asked.  0 if memory fails, which is noted. */
int view_find_motion(view *v);

/* The linkage that a synthesis has found, for the caller to free; null of another deck.  0: out of memory. */
int view_find_solution(const fourlink_deck *deck, fourlink_solution **found);

/* What a deck prescribes in place of the crank angle, by its name; null: nothing. */
const char *view_input(const view *v);

/* The extremes of the columns of the deck's table on a branch; valid until facts are asked for again. */
typedef struct view_extremes {
    const fourlink_value *list;
    unsigned long n;
} view_extremes;

/* Find them all in one search: FOURLINK_OK, or why there are none. */
int view_find_extremes(const view *v, fourlink_branch branch, view_extremes *found);

/* One of them, by the column's handle + FOURLINK_MAX or FOURLINK_MIN; null if the column has none. */
const fourlink_value *view_extreme(const view_extremes *x, int handle);

/* Open the deck of a source with so many further assignments, at most 2, and with one instant as a whole
** cycle; `origin` is named in messages, `opened` has the deck without them, or is null.  A status, as from
** fourlink_results_open_like, and the first mistake. */
int view_reopen(const fourlink_source *source, fourlink_results *opened, const char *origin,
                const char *const *further, int n, fourlink_results **results,
                fourlink_mistake *mistake);

/* Read a value in the unit that follows it, or else in the unit that [units] or --units gives for its
** quantity, or else in SI; the number is in the unit of results.  0 and a message, which is about `words`. */
int view_read(const view *v, quantity q, text value, text words, double *number,
              char message[MESSAGE_SIZE]);

/* A direction and a place in the axes of link 1 in those of the deck, rad, m; what a range of such
** directions is turned by. */
double view_direction(const view *v, double angle);
fourlink_vector view_place(const view *v, fourlink_vector place);
double view_turn_of_range(const view *v, double from, double to);

/* Read a crank angle, which may be `drawn`. */
int view_read_crank(const view *v, text value, text words, double *angle,
                    char message[MESSAGE_SIZE]);

/* Where --at and --plot-at point to: a crank angle in the deck's unit, where the motion first passes it, or
** with `is_place` a place of what the rows go over, if that is another. */
typedef struct view_spot {
    double at;
    int is_place;
    int side; /* of a place of an input of which the rows are on both sides; 0: the first */
} view_spot;

/* Read a spot, "60 deg", "theta2 = 60 deg" or "C.x = 700 mm"; 0 and a message if it is none. */
int view_read_spot(const view *v, text words, view_spot *spot, char message[MESSAGE_SIZE]);

/* Its value without the name. */
text view_value_of_spot(text words);

/* The results at a place, on a side of an input unless that is 0, as from fourlink_results_along. */
int view_find_along(const view *v, fourlink_branch branch, int side, double place, double *values,
                    fourlink_instant *now, fourlink_load *loads);

/* The row there, as from fourlink_results_at. */
int view_find_spot(const view *v, fourlink_branch branch, const view_spot *spot, double *values,
                   fourlink_instant *now, fourlink_load *loads);

/* The position to show on a branch: at a spot; if that is null, that of the drawing of [pins], unless
** the deck is one instant; or a sixth of the way through the motion, or at the row with the most acting
** loads, if they are more there or a dead position is near: of these rows the one nearest to a sixth of
** the way.  If there is no such row, the first at which the linkage can be assembled.  Returns a status. */
int view_find_position(const view *v, fourlink_branch branch, const view_spot *spot,
                       fourlink_instant *now, fourlink_load *loads);

#define VIEW_LOADS 128 /* a deck has fewer */

/* rad: where the transmission angle is smaller, a dead position is near, whose forces set no scale. */
#define VIEW_NEAR 0.2

/* The six equations of output i and their solution, as from fourlink_group_system: with the loads of an
** instant, and of what drives, if that is not the crank. */
int view_group_system(const view *v, const fourlink_instant *now, const fourlink_load *loads, int i,
                      double A[6][6], double b[6], double x[6]);

/* Why it is shown, if no crank angle was asked for: "as drawn", "where press acts"; "" for a sixth of
** the way. */
#define VIEW_WHY 120
const char *view_tell_position(const view *v, const fourlink_instant *now,
                               const fourlink_load *loads, char out[VIEW_WHY]);

/* Where a row is, in the deck's unit: the crank angle, or the value of what is prescribed. */
double view_shown_place(const view *v, const fourlink_row *row);

/* 1 for a row at an end of the range, which goes to a dead centre of what is prescribed: nothing is
** missing there. */
int view_goes_to(const view *v, int status);

/* The number of rows that cannot be computed, and why, "" for none; of how many on the branches. */
unsigned long view_count_missing(const view *v, unsigned long *of, const char **why);

/* The name of a file behind its folders, as titles have it. */
const char *view_file_of(const char *path);

/* Refuse a request, such as an option: returns 0, for the caller to return, and the reason. */
int view_refuse(fourlink_mistake *mistake, const char *place, const char *why, const char *word);

/* A value in the deck's unit of its quantity, and in SI units. */
double view_value(const view *v, quantity q, double si);
double view_si(const view *v, quantity q, double value);

/* Places, of problem.over: that of a row, and the side of an input there if the rows are on both, else
** 0; in the unit of results. */
double view_place_of_row(const view *v, unsigned long row);
int view_side_of_row(const view *v, unsigned long row);
double view_over(const view *v, double place);

/* The assignment that sets the step of the rows: "motion.interval=5 deg". */
#define VIEW_STEP (FORMAT_SIZE + 80)
const char *view_set_step(const view *v, double step, char out[VIEW_STEP]);

/* 1 if the deck gives the crank no speed and no acceleration: all velocities are 0. */
int view_is_still(const view *v);

/* 1 for one turn at constant speed: rows a turn apart are the same. */
int view_repeats(const view *v);

#endif
