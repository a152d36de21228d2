/* SPDX-License-Identifier: GPL-3.0-or-later
**
** at.h - where --at points to: '30 deg, theta4 = 120 deg'.
*/
#ifndef FOURLINK_AT_H
#define FOURLINK_AT_H

#include "view/view.h"

/* One item of the list: a crank angle, or a value of a column. */
typedef struct at_item {
    text words;         /* as it is in the list */
    const char *column; /* null: a spot */
    double value;       /* of the column, in the unit of the deck */
    view_spot spot;
} at_item;

/* Take the next item off a list separated by commas: 1; 0 at the end; -1 and a message if it is none, or
** if the motion does not reach it. */
int at_next(const view *v, const char **list, at_item *item, char message[400]);

/* Find where it is on a branch, to be freed: a status. */
int at_find(fourlink_results *results, const at_item *item, fourlink_branch branch,
            view_spot **spots, unsigned long *n);

#endif
