/* SPDX-License-Identifier: GPL-3.0-or-later
**
** values.h - second pass over a deck: the texts of its settings to values in SI units.
*/
#ifndef FOURLINK_DECK_VALUES_H
#define FOURLINK_DECK_VALUES_H

#include "parser.h"

/* Second pass: the units, which bare numbers need; the values not yet read. */
void flk_values_read_section(parser *p, section_use *use);
void flk_values_read(parser *p, int units_only);

/* The units of results that follow from others: those of speeds from that of lengths, all from in or ft; if
** it is not given and the results are in the units of the deck, all from that of the crank's length. */
void flk_values_follow_units(parser *p, int deck_units);

/* The unit in which the crank's length is written, or another length or pin; 0 if it is bare. */
int flk_values_written_length(parser *p, text *name, unit *u);

/* Quantity i of those that are printed in customary units because the deck has its lengths in in or ft; 0 if
** there are none, or no more. */
int flk_values_are_customary(const deck *d, size_t i, quantity *q);

/* The units of results that a host asks for, such as "mm, kg, rpm" or "SI", in place of the deck's. */
void flk_values_result_units(parser *p, const char *list);

/* The name of a unit for tables, as one word: kgf.m for "kgf m". */
void flk_value_name_unit(text t, char name[DECK_NAME_SIZE]);

/* Read the unit of a quantity or a vector, and find its name, which is empty if it is the deck's; 0 if it
** cannot be read. */
int flk_unit_of_value(const deck *d, text value, quantity q, text *name, unit *u);

/* The quantity of the argument of a load: FLK_THETA2 ... */
quantity flk_values_quantity_over(int over);

/* 1 if what [motion] input names is an angle. */
int flk_input_is_angle(const setting *input);

/* The quantity of a place of the motion that has been read: of an angle if it has no unit. */
quantity flk_values_quantity_at(const setting *at);

/* The quantity of a key in a section: that of the schema or, for a torsional spring, its twin; a place of a
** motion has that of its unit, and a prescribed coordinate its own. */
quantity flk_quantity_of_key(const section_use *use, key_code key);

/* 1 if a spring is torsional: its stiffness or its damping has a unit with rad. */
int flk_spring_is_torsional(const section_use *use);

#endif
