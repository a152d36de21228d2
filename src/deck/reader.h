/* SPDX-License-Identifier: GPL-3.0-or-later
**
** reader.h - the common part of the three passes over a deck: lines to settings (lines.c, settings.c),
** settings to values (values.c), values to a problem (build_*.c).
*/
#ifndef FOURLINK_READER_H
#define FOURLINK_READER_H

#include "base/digits.h"
#include "base/quantity.h"
#include "deck.h"
#include "schema.h"

/* The parts of a force or a point that can be set separately: load F.force.size. */
typedef enum vector_part { PART_X, PART_Y, PART_SIZE, PART_ANGLE, PART_NONE } vector_part;

/* By vector_part. */
extern const char *const flk_part_names[];

/* Where the value of a key or a name comes from. */
typedef enum value_giver { GIVEN_BY_TEXT, GIVEN_BY_CHANGE, GIVEN_BY_DESIGN } value_giver;

/* The value of a key in the deck. */
typedef struct setting {
    text_place place; /* see IS_SET */
    text own;         /* its value in the deck's text; null: not in the text */
    text value;       /* the value in effect */
    value_giver giver;
    double number;  /* as written */
    unit unit;      /* its unit */
    double si[2];   /* the value in SI units and radians, or the two components */
    int of_length;  /* 1: a point given as a fraction of its link's length */
    int is_bare;    /* 1: a force without a direction */
    int is_number;  /* 1: `number` and `unit` are set, and not read from `value` */
    int is_read;    /* 1: the members that follow from `value` have been read */
    int is_pending; /* 1: a design of the [sweep] sets it, but none has yet */
    int word;
    struct setting *parts; /* for a vector: parts set separately, by vector_part; or null */
    struct point *curve;   /* its points, if it is a curve */
    size_t n_points;
} setting;

#define IS_SET(s) ((s)->place.source != NULL)

/* A point of a curve. */
typedef struct point {
    double x, y[2];   /* rad, SI units; a value, or two components */
    text_place place; /* place in the text */
    int has_unit;     /* 1: the value has a unit */
    double unit_to_si;
} point;

/* A section of the deck, with one setting for each key that it can have. */
typedef struct section_use {
    section_code section;
    text name;
    text_place place;
    const char *start; /* of its header in the text; null: not in the text */
    int is_mistaken;   /* 1: a mistake in it is reported; mistakes that follow from it are not */
    int is_read;       /* 1: all its settings have been read */
    int is_shared;     /* 1: its settings are those of the deck that this is a design of */
    setting *settings; /* see flk_setting_of */
} section_use;

/* A value in a section that has names as keys: [expect], [misprint], [sweep]. */
typedef struct named_value {
    size_t use; /* number of its section */
    text name;
    text_place place;
    text own, value; /* as in a setting */
    value_giver giver;
} named_value;

/* What a key of a section means: a key of the schema, a part of its vector, or a name. */
typedef struct target {
    size_t use;
    key_code key; /* KEY_COUNT: `name` */
    vector_part part;
    text name;
} target;

struct variation;

/* The content of a text: the settings of a deck, kept as long as the deck, or of its answers. */
typedef struct parser {
    deck *d;                /* that is being read, or built */
    mistakes *mistakes;     /* the deck's */
    char why[MESSAGE_SIZE]; /* why a text is not a quantity, until this is reported */
    const char *name;
    text text;  /* all of it, for fourlink_deck_write */
    char *copy; /* of the text, with blanks between the lines of a value */
    fourlink_loader *load;
    void *host; /* passed to the loader */
    section_use *uses;
    size_t n_uses, uses_capacity;
    size_t first_use[SECTION_COUNT]; /* number of the first of each section + 1; 0: none */
    named_value *named;
    size_t n_named, named_capacity;
    size_t *named_slots; /* hash table of their names: number + 1; 0: free */
    size_t n_slots;
    int has_changed_names;        /* 1: some value is not from the text */
    struct variation *variations; /* of [sweep], in the order of its variables */
    size_t variations_capacity;
    double samples;
    int is_sound; /* 1: no mistakes before a design is set */
    int is_design; /* 1: built from the settings of another deck, whose notes say what is not meant */
    int is_answers; /* 1: [expect] and [misprint] instead of those of the deck */
    int has_unknown_section;
    int not_text;      /* 1: the reading ended at a byte that is not text */
    quantity argument; /* of the curve being read */
    long last_line;
    size_t
        n_characters; /* of the text and the files that it names, without comments and blanks around
                         lines */
    int line_end;
    int out_of_memory;
} parser;

/* Memory set to 0, valid as long as the deck; null if out of memory. */
void *flk_reader_keep(parser *p, size_t size);

/* Such memory with a list of n entries and room for one more; null if out of memory. */
void *flk_reader_grow(parser *p, void *list, size_t *capacity, size_t n, size_t size);

/* A null-terminated copy of a text with an ending, valid as long. */
char *flk_reader_copy(parser *p, text t, const char *ending);

/* A value in plain characters (see base/spelling.h), valid as long. */
text flk_reader_plain(parser *p, text t);

/* A file's text in UTF-8, if it is in UTF-16; valid as long. */
text flk_reader_utf8(parser *p, text t);

#define MOST_POINTS 100000      /* of a curve */
#define MOST_CHARACTERS 8000000 /* of a text, besides comments */

/* The last line read: the end of the deck, for a mistake about something missing. */
text_place flk_reader_end(const parser *p);

/* The section of the deck with this name (case matters), or the first if `name` is null; the next after a
** section, or the first if that is null.  Null if there is none. */
section_use *flk_section_find(const parser *p, section_code section, const text *name);
section_use *flk_section_next(const parser *p, section_code section, const section_use *after);

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

/* Set a key in a section, once. */
void flk_setting_read(parser *p, text_place place, const section_use *use, text key, text value);

/* Find the target of [SECTION[ NAME].]KEY[.PART]; 0, and usually a mistake, if there is none.  Opens the
** section if the deck does not have it. */
int flk_setting_target(parser *p, text_place place, text key, target *t);

/* The same without mistakes and for the sections that the deck has. */
int flk_setting_look(const parser *p, text key, target *t);

/* Set a target from outside its section: a number, with its text, by a design of a sweep or by a host; or
** by a change of the source. */
void flk_setting_vary(parser *p, text_place place, const target *t, const quantity_value *number,
                      text value);
void flk_setting_assign(parser *p, text_place place, text key, text value);

/* A number and its unit as text. */
text flk_setting_text(parser *p, double number, text unit_name);

/* Write the number that in a unit gives exactly the SI value, or the nearest one; 0 if it is not exact. */
int flk_number_in_unit(double si, const unit *u, char number[DIGITS_SIZE]);

/* 1 if a target is a quantity, or a part of one, whatever it has been given. */
int flk_target_is_number(const target *t);

/* Its number, as from flk_number_find. */
unsigned long flk_target_number(const target *t);

/* The quantity of a target that is a number. */
quantity flk_target_quantity(const parser *p, const target *t);

/* Set the numbers of a host. */
void flk_numbers_assign(parser *p, const deck_number *set, size_t n);

/* A line up to its comment, which starts with # or ; at the start of the line or after a blank, outside
** quotes. */
text flk_line_without_comment(text line);

/* Take the next line off a text and cut off its comment.  0 at the end of the text; 0 and a mistake if the
** line is not text, or the text is too large, and reading stops. */
int flk_line_take(parser *p, text *rest, int line_end, text_place place, text cut(text line),
                  text *line);

/* First pass: the lines of the text. */
void flk_lines_read(parser *p);

/* Second pass: the units, which bare numbers need; the values not yet read. */
void flk_values_read_section(parser *p, section_use *use);
void flk_values_read(parser *p, int units_only);

/* The unit of lengths in pictures, and in all results if these are drawn: that in which the crank is written,
** unless the deck or the host gives a unit of results. */
void flk_values_drawn_unit(parser *p, const fourlink_source *source);

/* The units of results that a host asks for, such as "mm, kg, rpm", in place of the deck's. */
void flk_values_result_units(parser *p, const char *list);

/* The quantity of the argument of a load: FLK_THETA2 ... */
quantity flk_values_quantity_over(int over);

/* The quantities of [sweep]; the values of one of its designs. */
void flk_sweep_read(parser *p);
void flk_sweep_assign(parser *p, unsigned long design);

/* The quantity of a key in a section: that of the schema or, for a torsional spring, its twin. */
quantity flk_quantity_of_key(const section_use *use, key_code key);

/* 1 if the values of an [expect] or [misprint] are at a time, not at a crank angle. */
int flk_expects_at_time(const section_use *use);

/* 1 if a spring is torsional: its stiffness or its damping has a unit with rad. */
int flk_spring_is_torsional(const section_use *use);

/* Read a quantity; 0 and a mistake if it is not one.  `whole` is the text that contains it. */
int flk_values_quantity(parser *p, text_place place, text t, text whole, quantity q,
                        quantity_value *value);

/* Pieces of a setting's value: take the number off the front of `rest`; read the unit `t` (the deck's if
** empty); check the size; read a quantity. */
int flk_values_number(parser *p, const setting *s, text *rest, quantity q, double *number);
int flk_values_unit(parser *p, const setting *s, text t, quantity q, unit *u);
int flk_values_size(parser *p, const setting *s, quantity q, double si);
int flk_values_piece(parser *p, setting *s, text t, quantity q, double *si);

/* Read a force (10 N at 30 deg, (10, 5) N, or 10 N along +x), or a point of a link (also mid, 50 %), from a
** piece of the setting's value. */
int flk_vector_read_piece(parser *p, setting *s, text t, quantity q, point *result);

/* Read a point of a link; the parts that are set separately. */
int flk_vector_read(parser *p, setting *s, quantity q);
void flk_vector_read_parts(parser *p, setting *s, quantity q);

/* Sine and cosine, exact for whole quarters of a turn. */
void flk_vector_direction(double angle, double *x, double *y);

/* Where a number starts after a blank, such as the value in "20 deg 32 bar"; the length of the text if there
** is none. */
size_t flk_curve_point_value(text t);

/* Read a point of a curve, ANGLE VALUE: "20 deg 32 bar", or "20 32" in the deck's units.  `is_cut`: it may be
** the rest after a decimal comma. */
int flk_curve_point_read(parser *p, setting *s, text t, quantity q, int is_cut, point *result);
const char *flk_curve_point_example(quantity q);

/* Read a curve from a file: NAME, or NAME with the units of its columns; see card.c. */
int flk_card_read(parser *p, setting *s, quantity q, text name);

/* Take the text up to the next comma outside parentheses off the front of `rest`; 0 if nothing is left. */
int flk_curve_text_item(text *rest, text *item);

/* 1 if a curve is `file NAME`; `name` may be null. */
int flk_curve_text_file(text value, text *name);

/* Read a value, or a force; or a curve: 0 deg 1 bar, 20 deg 32 bar, ... or file NAME. */
int flk_curve_text_read(parser *p, setting *s, quantity q);

/* Third pass. */
int flk_build_kind(parser *p);
void flk_build_mechanism(parser *p);
/* The next element of the machine's list, for a load, a spring or gas; null if out of memory. */
flk_element *flk_build_element(parser *p);

void flk_build_gas(parser *p);
void flk_build_loads(parser *p);
void flk_build_springs(parser *p);
void flk_build_friction(parser *p);
void flk_build_balance(parser *p);
void flk_build_points(parser *p);
void flk_build_series(parser *p);
void flk_build_motion(parser *p);

/* Last: note the curves over positions and speeds whose ends the motion exceeds. */
void flk_build_curve_ends(parser *p);
void flk_build_flywheel(parser *p);
void flk_build_motor(parser *p);
void flk_build_table(parser *p);
void flk_build_expectations(parser *p);
void flk_build_grading(parser *p);

/* Note values that are allowed but probably not meant. */
void flk_build_doubts(parser *p);

/* The sense in which a speed or a motor turns the crank: -1 clockwise; otherwise 1. */
int flk_build_sense(parser *p);

/* 1 if the kind of the mechanism has this key. */
int flk_build_has(const parser *p, key_code key);

/* Check the link of a load or a point (0 and a mistake if the mechanism has no such link); check that a
** name for columns is one word and not too long. */
int flk_build_check_link(parser *p, const section_use *use, const setting *link);
void flk_build_check_name(parser *p, const section_use *use, const char *columns);

/* 1 if the arguments of a curve rise, by this step at least; otherwise 0 and this mistake. */
int flk_build_is_rising(parser *p, const setting *s, double least, const char *message);

/* A point of a link, in m. */
void flk_build_place(parser *p, const setting *s, int link, fourlink_vector *at);

#define STANDARD_GRAVITY 9.81 /* m/s2, as in the sources */

/* The list for notes on what is allowed but probably not meant; for flk_mistake. */
#define NOTES(p) (&(p)->d->notes)

#endif
