/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sheet.h - a sheet of results, and the formats it can be written in.
**
** content.c decides what a sheet shows, once for all formats.  A format is a record of functions that
** write it (table.c, csv.c, json.c, paper.c), and one entry in the table of formats, SHEET_FORMATS.
*/
#ifndef FOURLINK_SHEET_H
#define FOURLINK_SHEET_H

#include "line.h"
#include "view/view.h"

#define SHEET_OUTPUTS 64 /* of a sweep, at most */

/* What a sheet shows. */
typedef enum sheet_content {
    SHEET_ROWS,
    SHEET_SUMMARY,
    SHEET_CHECK,
    SHEET_LIST,
    SHEET_MATRIX,
    SHEET_DESIGNS, /* a line for each design of a sweep */
    SHEET_VALUES,  /* values of decks: a line for each branch */
    SHEET_EXPECT,  /* values for --check */
    SHEET_SCORES,  /* a line for each file of answers */
    SHEET_CONTENT_COUNT
} sheet_content;

struct sheet_format;

/* What the answers of a file are worth. */
typedef struct sheet_mark {
    const char *path;   /* of the file, or the deck */
    char name[256];     /* of the file without its ending */
    double right, of;   /* marks */
    char id[64];        /* of the list of names */
    double late, total; /* days; the marks after the deduction for them */
    char note[1000];
} sheet_mark;

/* A value that is asked for, and the marks that it got. */
typedef struct sheet_question {
    char name[160]; /* "theta4 at 60" */
    double of, got; /* NaN: there is no answer */
} sheet_question;

/* Set it to zero, set the members that content_begin needs, and call that. */
typedef struct sheet {
    line l;
    const struct sheet_format *format;
    sheet_content content;
    int n_decks;         /* if several, each shows its name */
    unsigned long width; /* of the terminal; 0: the table need not fit one */
    int is_coloured;     /* 1: with headings and extremes in colour */
    const char *at;      /* the list of --at, instead of the rows; null: the rows */
    const fourlink_value
        *header;            /* the columns of all decks, of which a deck has some; of designs the */
    unsigned long n_header; /* outputs */

    const sheet_question *questions; /* of SHEET_SCORES */
    unsigned long n_questions;
    int has_roster; /* 1: marks have an id, days late and a total */
    int is_form;    /* 1: of SHEET_EXPECT, the names without the values */

    /* the deck, or design, that is being written */
    const char *deck_name;  /* null: it is the only one */
    int wrong_first;        /* 1: comparisons that differ come before the others */
    const sheet_mark *mark; /* of the answers, where many are to one deck; null: none */
    view v;
    double *values;       /* of a row */
    fourlink_load *loads; /* of a row */
    const fourlink_value *variables;
    unsigned long n_variables;
    const fourlink_value
        *conditions; /* of a [sweep] with a yield, which is then the last of the header */
    unsigned long n_conditions;
    const char *each;        /* what has a line of its own: design, solution; null: design */
    int has_designs;         /* 1: of SHEET_VALUES, some decks have designs */
    int has_sides;           /* 1: rows of some decks are on both sides of their input */
    unsigned long design;    /* of a sweep, from 1; 0: not a sweep */
    const double *varied;    /* the values of its variables */
    void *layout;            /* of the format */
    int page, n_pages;       /* of a table that fits the width, from 0: rows come once for each */
    unsigned long n_written; /* decks or designs */
    const char *list;        /* for the format: the list that is open, or null */
    int side; /* for the format: that of the last row of an input of both sides, or 0 */
    fourlink_results *const
        *listed; /* of SHEET_LIST: whose names stand in it; null: the deck's own */
    size_t n_listed;

    unsigned long failed;    /* rows, or designs, that could not be computed */
    unsigned long checks[5]; /* of this deck, by fourlink_verdict */
    double right, of;        /* marks of this deck, or of the answers */
    /* called for these, at most MOST_MISTAKES times for a deck */
    void (*no_value)(const fourlink_check *check, const char *deck_name);
} sheet;

/* One row: values by the deck's columns. */
typedef struct sheet_row {
    const double *values; /* null: only the status */
    fourlink_branch branch;
    const fourlink_instant *at; /* may be null */
    double last;                /* crank angle of the last row for which this one stands */
    const char *status;         /* in words */
    int is_ordinary;            /* 1: the status is "ok" */
} sheet_row;

/* One output of a design. */
typedef struct sheet_output {
    int has_value;
    int is_other;    /* 1: of values, the deck has it in another unit, or not */
    const char *why; /* why a line of values lacks it; null: it does not, or there is no reason */
    fourlink_value v;
} sheet_output;

/* How a format frames a content; each may be null. */
typedef struct sheet_frame {
    void (*begin)(sheet *s);                   /* before all decks */
    void (*open)(sheet *s);                    /* a deck or design begins */
    void (*close)(sheet *s);                   /* it ends */
    void (*refuse)(sheet *s, const char *why); /* instead of a deck or design */
} sheet_frame;

/* How a format writes the parts of a sheet.  `limit`, `fact`, `block` and `end_block` may be null.  The
** others may be null if the format does not write their contents. */
typedef struct sheet_format {
    const char *name;
    const sheet_frame *frame[SHEET_CONTENT_COUNT]; /* by content; null: it cannot write it */
    void (*column)(sheet *s, const fourlink_value *column); /* of SHEET_LIST, */
    void (*listed)(sheet *s, const fourlink_value *fact);   /* ... and the facts after them */
    void (*limit)(sheet *s, const fourlink_value *fact);    /* a fact before the rows */
    void (*fact)(sheet *s, const fourlink_value *fact);     /* of SHEET_SUMMARY */
    void (*block)(sheet *s, fourlink_branch branch);        /* the rows of a branch begin */
    void (*row)(sheet *s, const sheet_row *row);
    void (*end_block)(sheet *s, fourlink_branch branch);
    void (*check)(sheet *s, const fourlink_check *check);
    /* a line of SHEET_DESIGNS, of SHEET_VALUES */
    void (*design)(sheet *s, fourlink_branch branch, const sheet_output *outputs, const char *why);
    void (*values)(sheet *s, fourlink_branch branch, const sheet_output *outputs, const char *why);
    size_t layout_size; /* of s->layout, for each column */
    int is_by_angle;    /* 1: both branches at each crank angle, the crossed one first, and no row
                           at the end of a revolution */
    int is_brief; /* 1: rows without numbers, one after the other for the same reason, are one;
                           in a summary a fact that is the same on both branches is there once */
    void (*mark)(sheet *s, const sheet_mark *m); /* of SHEET_SCORES */
    /* of SHEET_SUMMARY, on both branches for 0; null: each extreme is a fact */
    void (*extremes)(sheet *s, const fourlink_value *column, const fourlink_value *least,
                     const fourlink_value *most, int branch);
    int is_lines; /* 1: one deck is a line with its name, as one of several */
} sheet_format;

/* The formats, each in its own file. */
#define SHEET_FORMATS(X) X(table) X(csv) X(json) X(jsonl) X(paper)

#define SHEET_FORMAT(name) extern const sheet_format name##_format;
SHEET_FORMATS(SHEET_FORMAT)

/* The deck's column, or of values its output, that belongs under column i of the header; -1 if there is
** none. */
long sheet_column_under(const sheet *s, unsigned long i);

/* Take the deck's name, if it is shown. */
void sheet_name_deck(sheet *s, const char *name);

/* Write a line of SHEET_VALUES: these, where the header has their names and units. */
void sheet_write_line(sheet *s, const fourlink_results *results, const char *deck_name,
                      fourlink_branch branch, const fourlink_value *values, unsigned long n);

/* Write the blank lines between decks or designs, and the deck's name. */
void sheet_write_gap(sheet *s);

/* Give the deck's inputs to a function of the format. */
void sheet_write_inputs(sheet *s, void (*put)(sheet *s, const fourlink_value *input));

/* 1 if a fact of a list is the same on the other branch. */
int sheet_is_on_both(const fourlink_value *f, const fourlink_value *facts, unsigned long n);

/* Per cent of a mark, to one decimal; NaN if nothing is asked. */
double sheet_percent(const sheet_mark *m);

/* 1 if the machine does not come to this row, because its actual motion has ended. */
int sheet_is_over(const sheet *s, const fourlink_instant *at);

/* Where the crank comes to rest, or why the machine goes no further, in words; null if it moves through all
** rows. */
#define SHEET_STOP_SIZE (FORMAT_SIZE + 100)
const char *sheet_stop(const sheet *s, fourlink_branch branch, char words[SHEET_STOP_SIZE]);

/* Write where the crank comes to rest, or why the machine goes no further, if so. */
void sheet_write_stop(sheet *s, fourlink_branch branch);

/* Set the values of the row at a crank angle of s->at, 0 for rounding error; returns its status. */
int sheet_find_at(sheet *s, fourlink_branch branch, const view_spot *spot, fourlink_instant *at);

/* Call a function for each crank angle of s->at on a branch; why there is none is a line where the format
** is brief. */
void sheet_for_each_at(sheet *s, fourlink_branch branch,
                       void (*put)(sheet *s, fourlink_branch branch, const view_spot *spot));

/* 1 if a value meets a condition of a yield; NaN meets none. */
int sheet_meets(const fourlink_value *condition, const fourlink_value *v);

/* The results of a comparison in words. */
extern const char *const sheet_verdicts[];

#endif
