/* SPDX-License-Identifier: GPL-3.0-or-later
**
** expected.h - the values that a source printed against those computed.
*/
#ifndef FOURLINK_EXPECTED_H
#define FOURLINK_EXPECTED_H

#include "row.h"

typedef enum check_result {
    CHECK_OK,
    CHECK_DIFFERS,
    CHECK_MISPRINT,
    CHECK_NO_MISPRINT,
    CHECK_NO_VALUE /* a mistake of the deck says why */
} check_result;

/* An expectation, compared. */
typedef struct check {
    const deck_expectation *e;
    check_result result;
    double printed, computed, tolerance; /* in `unit`; not for a fact in words */
    const char *unit;
    int at_angle;    /* 1: a column, at e->at */
    char words[100]; /* a fact in words, as computed; "" if it is a number */
} check;

typedef void check_taker(const check *c, void *data);

/* Compare the printed values of a deck, in their order.  1, or 0 and mistakes of the deck where some
** cannot be compared: no such column or fact, another quantity, an angle that is not reached.  -1 out of
** memory. */
int checks_run(deck *d, check_taker *take, void *data);

#endif
