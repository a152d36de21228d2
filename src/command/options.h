/* SPDX-License-Identifier: GPL-3.0-or-later
**
** options.h - the command line.
*/
#ifndef FOURLINK_OPTIONS_H
#define FOURLINK_OPTIONS_H

#include "pictures/plot.h"
#include "tables/at.h"
#include "tables/sheet.h"

#define OPTIONS_MOST 48

typedef struct options {
    const char
        *given[OPTIONS_MOST]; /* by the table of options: the value, "" where there is none; null:
                                     ** it was not given */
    const sheet_format *format;
    sheet_content content;
    int help, version;
    int asks_for_table;     /* 1: --format or --output was given */
    int allow_files;        /* 1: decks may name files of other folders */
    int wide;               /* 1: a table need not fit the terminal */
    const char *colour;     /* always or never; null: on a terminal */
    const char *check_file; /* null: the deck's own expectations */
    const char *answers;    /* the folder of --answers, which check_file is then too */
    int is_class;           /* 1: all files of the folder of --check are answers to the deck */
    const char *exercise;   /* the deck that says what is asked; null: the deck itself */
    int is_exercise; /* 1: of a design only what students get, without [expect] and [grading] */
    int form;        /* 1: of --expect, the names without the values */
    int is_html;     /* 1: --format=html, of the texts of --feedback */
    const char *feedback; /* the folder of --feedback; null: none */
    int scores;           /* 1: a line for each deck, or file of answers, instead of each value */
    const char *at;       /* the crank angles of --expect; null: the rows */
    const char *output;   /* null: standard output */
    const char *units;    /* of results; null: those of the deck */
    const char *best;     /* the name that --best asks for; null: it was not given */
    int best_is_largest;
    const char *solve;         /* what --solve asks for; null: it was not given */
    unsigned long part, parts; /* --part=K/N; parts 0: not given */
    unsigned long design;      /* --design=N, from 1; 0: not given */
    int all_designs;           /* 1: --design=all */
    const char *names;         /* the list of names for its files; null: numbers */
    int is_again;              /* 1: the notes on this deck have been told */
    const char *variant;       /* the file of the one design of all that is computed; null: none */
    int lists_all;             /* 1: --list without a deck */
    int print_deck;            /* 1: print the deck instead of rows */
    int pins;                  /* 1: by the places of its pins */
    const char *import;        /* the file of another tool that is the deck; null: none */
    int synthesis;             /* 1: find the linkage of the deck's [synthesis] */
    unsigned long effort;      /* --effort=K; 0: not given */
    unsigned long solution;    /* --solution=K, from 1; 0: not given */
    int has_format;            /* 1: --format was given */
    int no_kind;               /* 1: --plot without --plot-kind */
    const char *plot;          /* the picture's file; null: none */
    int ascii;                 /* 1: a text picture without Braille */
    const char *report;        /* the report's file; null: none */
    const char *quiz;          /* the file of the quiz; null: none */
    plot_request drawing;      /* PLOT_COUNT: no kind is given */
    fourlink_change *changes;  /* --set, and options that set a key of the deck */
    unsigned long n_changes;
    const char **decks; /* "-": standard input */
    size_t n_decks;
    char *storage, *next; /* the texts of the assignments, and where the next goes */
} options;

/* Read the command line.  Returns 1; 0 and the reason in `message`; -1 if out of memory. */
int options_read(int argc, char **argv, options *o, char message[400]);
void options_free(options *o);

/* The value of an option that was given, "" where there is none; null: it was not.  A picture without
** --plot-kind has the default kind. */
const char *options_given(const options *o, text name);

/* 1 if a table, or another text, is printed: a picture or a report comes alone unless one is asked for
** too. */
int options_want_table(const options *o);

/* 1 if a name says that it is a folder's: it ends in a slash. */
int options_is_folder(const char *name);

/* Write what --help prints. */
void options_put_help(FILE *out);

#endif
