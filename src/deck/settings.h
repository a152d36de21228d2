/* SPDX-License-Identifier: GPL-3.0-or-later
**
** settings.h - the sections of a deck and the settings of their keys, from the deck, from --set, or for a
** design of a sweep.
*/
#ifndef FOURLINK_DECK_SETTINGS_H
#define FOURLINK_DECK_SETTINGS_H

#include "parser.h"

/* The section of the deck with this name (case matters), or the first if `name` is null; the next after a
** section, or the first if that is null.  Null if there is none. */
section_use *flk_section_find(const parser *p, section_code section, const text *name);
section_use *flk_section_next(const parser *p, section_code section, const section_use *after);

/* The number of the link that NAME or NAME.rod of an [output] is; 0 if there is none. */
int flk_output_link(const parser *p, text name);

/* 1 if this is the number of the rod of an [output] that hangs by a slot. */
int flk_output_has_slot(const parser *p, int rod);

/* The kind of mechanism that the deck has; 0 if it is not known. */
int flk_setting_kind(const parser *p);

/* The section that a name means in a deck of this kind, such as [slider] the piston; SECTION_COUNT if
** none. */
section_code flk_section_meant(const parser *p, text name);

/* Split "section NAME"; the name may be empty. */
void flk_section_split(text *section, text *name);

/* Open a section without settings; null if out of memory.  `start` is as in section_use. */
section_use *flk_section_open(parser *p, section_code section, text name, text_place place,
                              const char *start);

/* Report that there is no section of this name; returns 0. */
int flk_section_unknown(parser *p, text_place place, text name);

/* 1 if the deck has such a section with a mistake. */
int flk_section_is_mistaken(parser *p, section_code section);

/* Copy the settings of a section that belong to another deck before one of them changes; 0 if out of
** memory. */
int flk_section_unshare(parser *p, section_use *use);

/* The setting of a key in a section that has the key. */
setting *flk_setting_of(const section_use *use, key_code key);

/* The setting of a key in a section that does not repeat; an unset one, all 0, if the deck has no such
** section. */
const setting *flk_setting_find(parser *p, key_code key);

/* The same for the key with this name; also unset if the section has no such key. */
const setting *flk_setting_by_name(parser *p, section_code section, const char *key);

/* The value of a key in SI units, or `otherwise` if it is not set; the same in the deck's unit, without
** rounding if it is written in that unit. */
double flk_setting_or(parser *p, key_code key, double otherwise);
double flk_setting_in_unit(parser *p, const setting *s, quantity q);

/* The crank angle of a setting of such a key, rad, in the axes of the deck. */
double flk_setting_crank_angle(const parser *p, const setting *s);

/* Set a key in a section, once. */
void flk_setting_read(parser *p, text_place place, const section_use *use, text key, text value);

/* Find the target of [SECTION[ NAME].]KEY[.PART]; 0, and usually a mistake, if there is none.  Opens the
** section if the deck does not have it. */
int flk_setting_target(parser *p, text_place place, text key, target *t);

/* The same without mistakes and for the sections that the deck has. */
int flk_setting_look(const parser *p, text key, target *t);

/* 1 if two decks have the same mechanism, loads and motion by their settings and the files that these
** name.  What is shown or asked may differ, the steps from row to row, and the units of results but that
** of angles. */
int flk_settings_move_alike(const deck *d, const deck *other);

/* Set a target from outside its section: a number, with its text, by a design of a sweep or by a host; or
** by a change of the source. */
void flk_setting_vary(parser *p, text_place place, const target *t, const quantity_value *number,
                      text value);
void flk_setting_assign(parser *p, text_place place, text key, text value);

#endif
