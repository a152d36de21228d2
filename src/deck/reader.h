/* SPDX-License-Identifier: GPL-3.0-or-later
**
** reader.h - what the three passes over a deck share: lines to settings (lines.c), settings to
** values (values.c), values to a problem (deck.c).
*/
#ifndef FOURLINK_READER_H
#define FOURLINK_READER_H

#include "deck.h"
#include "schema.h"

/* What the deck sets a key to. */
typedef struct setting {
    text_place place; /* source null: not set */
    text value;
    double number; /* as written */
    unit unit;     /* its unit */
    int is_given;  /* 1: number and unit are those of a sweep, not of the text */
    int is_void;   /* 1: not to be read, for there is a mistake about it already */
    double si[2];  /* the value in SI units and radians, or the two components */
    int word;
    struct point *curve; /* its points, if it is a curve */
    size_t n_points;
} setting;

/* A point of a curve. */
typedef struct point {
    double x, y;      /* rad, SI units */
    text_place place; /* where it is written */
    int has_unit;     /* 1: its value has one */
    double unit_to_si;
} point;

/* A section as it stands in the deck, with one setting for each key of the schema that it can have;
** they are found at first + key - (first key of the section). */
typedef struct section_use {
    section_code section;
    text name;
    text_place place;
    size_t first;
} section_use;

/* A value of a section that takes names of its own: [expect], [misprint]. */
typedef struct named_value {
    size_t use; /* number of its section */
    text name;
    setting s;
} named_value;

typedef struct parser {
    deck *d;
    const char *name;
    fourlink_loader *load;
    void *host; /* for it */
    section_use *uses;
    size_t n_uses, uses_capacity;
    setting *settings;
    size_t n_settings, settings_capacity;
    named_value *named;
    size_t n_named, named_capacity;
    setting *parts; /* for each variable of a sweep: its value, if it is a part of a vector */
    int expectations_only;
    int not_text; /* 1: the reading ended at what is no text */
    long last_line;
    int out_of_memory;
} parser;

#define WORD_SIZE 64

/* A copy for a message. */
char *flk_word_of(text t, char out[WORD_SIZE]);

/* The value of a setting for a message, as it is written, or as a sweep gives it. */
char *flk_value_of(const setting *s, char out[WORD_SIZE]);

/* A section of the deck, null if it has none of that kind. */
section_use *flk_find_use(parser *p, section_code section);

/* The key that a setting belongs to. */
key_code flk_key_of(parser *p, const setting *s);

/* The setting of a key in a section that has it. */
setting *flk_setting_of(parser *p, const section_use *use, key_code key);

/* The setting of a key of a section that does not repeat; null if the deck does not set it. */
setting *flk_find(parser *p, key_code key);

/* A line up to its comment, which starts with # or ; at the start of the line or after a blank, but
** not within quotes. */
text flk_without_comment(text line);

/* First pass: the lines of the deck, all in `copy`, and an assignment from outside it. */
void flk_read_lines(parser *p, text rest, char *copy);
void flk_apply_change(parser *p, const char *option, text assignment);

/* Set a key from elsewhere than its section: [SECTION[ NAME].]KEY.  Null, and mostly a mistake, if it has
** no setting in the schema.  A value that is null leaves it as it is. */
setting *flk_set_key(parser *p, text_place place, text key, text value);

/* The parts of a force or a point that a sweep can vary: load F.force.size. */
typedef enum vector_part { PART_NONE, PART_X, PART_Y, PART_SIZE, PART_ANGLE } vector_part;

/* Second pass: the units, which decide how bare numbers are read; the values that [sweep] has for a
** design; the values. */
void flk_read_section(parser *p, const section_use *use);
void flk_read_units(parser *p);
void flk_read_sweep(parser *p, unsigned long design);
void flk_read_values(parser *p);

/* After it: put the parts that vary into their vectors; tell what the quantities of the sweep are in this
** design. */
void flk_set_parts(parser *p);
void flk_build_sweep(parser *p);

/* A quantity in SI units, with its size checked; 0 and a mistake if it is none.  As it is written, or with
** the number and unit that a sweep gives. */
int flk_read_quantity(parser *p, setting *s, text t, quantity q, double *si);
int flk_read_given(parser *p, setting *s, quantity q);

/* A quantity in the deck's unit of it, without rounding if it is written in that. */
double flk_in_deck_unit(parser *p, const setting *s, quantity q);

/* Memory that lasts as long as the deck; null when there is none. */
void *flk_keep(parser *p, size_t size);

/* Sine and cosine, exact for whole quarters of a turn. */
void flk_direction_of(double angle, double *x, double *y);

#endif
