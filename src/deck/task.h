/* SPDX-License-Identifier: GPL-3.0-or-later
**
** task.h - the values of [synthesis] as its tasks take them.  What returns an int returns 0 after a mistake.
*/
#ifndef FOURLINK_DECK_TASK_H
#define FOURLINK_DECK_TASK_H

#include "parser.h"
#include "synthesis.h"

/* A key of [synthesis]; 1 if it is given. */
setting *flk_task_find(parser *p, key_code key);
int flk_task_require(parser *p, key_code key, const char *example);

/* Report what was expected of a key, unless one of its items has been reported; returns 0. */
int flk_task_refuse(parser *p, key_code key, const char *expected);

/* The first unit of length that is written is that of the lengths found. */
void flk_task_unit(parser *p, text name);

/* A range, 30 deg to 120 deg; a list of at most `most` numbers, which returns how many. */
int flk_task_range(parser *p, key_code key, quantity q, double range[2]);
unsigned long flk_task_list(parser *p, key_code key, quantity q, unsigned long most, double *list);

/* An angle and a value: 36 deg 64 deg. */
int flk_task_pair(parser *p, setting *s, text t, quantity q, double *angle, double *value);

/* (24, 10) mm -30 deg: a point, and the text after its unit. */
int flk_task_point(parser *p, setting *s, text t, fourlink_vector *at, text *rest);

/* The lengths that are given, by link number; returns their number. */
int flk_task_lengths(parser *p, double length[5]);

/* Report lengths that a task finds, if more than `most` links have theirs; what it takes, in words. */
void flk_task_check_lengths(parser *p, int most, const char *takes);

/* The first point of the coupler; null if there is none. */
const section_use *flk_task_coupler_point(const parser *p);

/* Build the task of a function generator. */
int flk_task_function(parser *p);

/* Whether a motion or a path is one that is searched for from many starts: it has more than three positions,
** or leaves open what three need. */
int flk_task_has_points(parser *p);

/* Build such a task. */
int flk_task_points(parser *p);

#endif
