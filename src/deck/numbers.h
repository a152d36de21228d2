/* SPDX-License-Identifier: GPL-3.0-or-later
**
** numbers.h - the numbers of a deck that a sweep or a host can set: crank.length, load L.force.size.
*/
#ifndef FOURLINK_DECK_NUMBERS_H
#define FOURLINK_DECK_NUMBERS_H

#include "parser.h"

/* A number and its unit as text. */
text flk_setting_text(parser *p, double number, text unit_name);

/* Write the number that in a unit gives exactly the SI value, or the nearest one; 0 if it is not exact. */
int flk_number_in_unit(double si, const unit *u, char number[DIGITS_SIZE]);

/* A number in another unit: to 15 digits if that is within the rounding of the conversion and, read and
** converted back, is the number to 15 digits: 2.5 in is 63.5 mm.  The same for the number that a line of
** the deck has in its own unit for an SI value. */
double flk_number_converted(double number, unit from, unit to);
double flk_number_written(double si, unit own, unit wanted);

/* 1 if a target is a quantity, or a part of one, whatever it has been given. */
int flk_target_is_number(const target *t);

/* Its number, as from flk_number_find. */
unsigned long flk_target_number(const target *t);

/* The quantity of a target that is a number. */
quantity flk_target_quantity(const parser *p, const target *t);

/* Set the numbers of a host. */
void flk_numbers_assign(parser *p, const deck_number *set, size_t n);

/* The number of a deck with this name, crank.length or load L.force.size: the same for all its designs; 0 if
** there is no such key, or no such section in the deck. */
unsigned long flk_number_find(const deck *d, text name);

/* The quantity and the last word of the name of a number; its value in SI units, NaN if it is not given.
** 0 if it is not a number: words, a list, a curve. */
int flk_number_describe(const deck *d, unsigned long id, quantity *q, const char **key, double *si);

/* 1 if it follows from the places of pins, so that it cannot be set. */
int flk_number_follows(const deck *d, unsigned long id);

/* The unit of the line that gives a number; of a bare one, and of one that the deck does not give, the
** deck's.  0 if it is not a number. */
int flk_number_unit(const deck *d, unsigned long id, deck_unit *u);

/* Read NAME = NUMBER UNIT, with the unit of its line if there is none; FOURLINK_OK, FOURLINK_NO_SUCH_NAME,
** FOURLINK_NOT_A_NUMBER or FOURLINK_BAD_NUMBER, with why in `message`. */
int flk_number_read_text(const deck *d, text whole, deck_number *number,
                         char message[MESSAGE_SIZE]);

#endif
