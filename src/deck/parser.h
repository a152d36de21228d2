/* SPDX-License-Identifier: GPL-3.0-or-later
**
** parser.h - the settings of a deck, which its passes share: lines to settings (lines.c, settings.c),
** settings to values (values.c), values to a problem (build_*.c), all by reader.c.
**
** A parser has the sections in the order of the text, each with one setting for every key that it can
** have, unset or not; sections of one name are found by first_use, the first of each kind, and by going
** on.  A setting has its text (own) and the text in effect (value), which a change or a design replaces;
** the members that follow from it are read once, after the units.  A design shares the sections of its
** deck and copies one before it changes it (flk_section_unshare): the settings of a deck never change
** after it has been read.
*/
#ifndef FOURLINK_PARSER_H
#define FOURLINK_PARSER_H

#include "base/digits.h"
#include "base/quantity.h"
#include "deck.h"
#include "schema.h"

/* The parts of a force or a point that can be set separately: load F.force.size. */
typedef enum vector_part { PART_X, PART_Y, PART_SIZE, PART_ANGLE, PART_NONE } vector_part;

/* By vector_part. */
extern const char *const flk_part_names[];

/* Where the value of a key or a name comes from. */
typedef enum value_source { GIVEN_BY_TEXT, GIVEN_BY_CHANGE, GIVEN_BY_DESIGN } value_source;

/* The value of a key in the deck. */
typedef struct setting {
    text_place place; /* see IS_SET */
    text own;         /* its value in the deck's text; null: not in the text */
    text value;       /* the value in effect */
    text line; /* that of the text or of a change, or of the first design where there is neither */
    value_source source;
    double number; /* as written */
    unit unit;     /* its unit */
    double si[2];  /* the value in SI units and radians, or the two components */
    int of_length; /* 1: a point given as a fraction of its link's length */
    int of_pins; /* 1 or -1: a point by its distances from both pins of its link, to the left or to
                    the right of the line between them */
    int of_centre;  /* 1: a point given from the centre of mass of its link */
    int is_place;   /* 1: a place on the page, not a point of a link */
    int is_bare;    /* 1: a force or a place without a direction */
    int is_number;  /* 1: `number` and `unit` are set, and not read from `value` */
    int is_read;    /* 1: the members that follow from `value` have been read */
    int is_pending; /* 1: a design of the [sweep] sets it, but none has yet */
    int word;
    struct setting *parts; /* for a vector: parts set separately, by vector_part; or null */
    quantity argument;     /* of a curve */
    struct point *curve;   /* its points, if it is a curve */
    size_t n_points;
} setting;

#define IS_SET(s) ((s)->place.source != NULL)

/* A crank angle: that of the drawing of [pins], or `theta2 = 60 deg` where an angle is a value of the
** input. */
enum { CRANK_DRAWN = 1, CRANK_NAMED };
#define IS_DRAWN(s) ((s)->word == CRANK_DRAWN)
#define IS_CRANK_NAMED(s) ((s)->word == CRANK_NAMED)

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
    const char *start;    /* of its header in the text; null: not in the text */
    int is_mistaken;      /* 1: a mistake in it is reported; mistakes that follow from it are not */
    int is_read;          /* 1: all its settings have been read */
    int is_shared;        /* 1: its settings are those of the deck that this is a design of */
    setting *settings;    /* see flk_setting_of */
    flk_element *element; /* built from it for the current design; null: none */
} section_use;

/* A value in a section that has names as keys: [expect], [misprint], [sweep]. */
typedef struct named_value {
    size_t use; /* number of its section */
    text name;
    text_place place;
    text own, value; /* as in a setting */
    value_source source;
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
    int has_unknown_section, has_noted_weight;
    int not_text; /* 1: the reading ended at a byte that is not text */
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

#define STANDARD_GRAVITY 9.81 /* m/s2, as in the sources */

/* The list for notes on what is allowed but probably not meant; for flk_mistake. */
#define NOTES(p) (&(p)->d->notes)

#endif
