/* SPDX-License-Identifier: GPL-3.0-or-later
**
** reader.h - what the three passes over a deck share: lines to settings (deck_lines.c), settings to
** values (deck_values.c), values to a problem (deck.c).
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
    deck_loader *load;
    section_use *uses;
    size_t n_uses, uses_capacity;
    setting *settings;
    size_t n_settings, settings_capacity;
    named_value *named;
    size_t n_named, named_capacity;
    int expectations_only;
    int not_text; /* 1: the reading ended at what is no text */
    long last_line;
    int out_of_memory;
} parser;

#define WORD_SIZE 64

/* A copy for a message. */
char *word_of(text t, char out[WORD_SIZE]);

/* A section of the deck, null if it has none of that kind. */
section_use *find_use(parser *p, section_code section);

/* The setting of a key in a section that has it. */
setting *setting_of(parser *p, const section_use *use, key_code key);

/* The setting of a key of a section that does not repeat; null if the deck does not set it. */
setting *find(parser *p, key_code key);

/* A line up to its comment, which starts with # or ; at the start of the line or after a blank, but
** not within quotes. */
text without_comment(text line);

/* First pass: the lines of the deck, all in `copy`, and an assignment from outside it. */
void read_lines(parser *p, text rest, char *copy);
void apply_change(parser *p, const char *option, text assignment);

/* Second pass. */
void read_values(parser *p);

/* A quantity in SI units, with its sign and size checked; 0 and a mistake if it is none. */
int read_quantity(parser *p, setting *s, text t, quantity q, double *si);

/* Memory that lasts as long as the deck; null when there is none. */
void *keep(parser *p, size_t size);

/* Sine and cosine, exact for whole quarters of a turn. */
void direction_of(double angle, double *x, double *y);

#endif
