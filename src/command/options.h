/* SPDX-License-Identifier: GPL-3.0-or-later
**
** options.h - the command line.
*/
#ifndef FOURLINK_OPTIONS_H
#define FOURLINK_OPTIONS_H

#include "pictures/picture.h"
#include "tables/sheet.h"

typedef struct options {
    const sheet_format *format;
    sheet_content content;
    int n_contents; /* how often one was asked for */
    int help, version;
    const char *check_file;    /* null: the deck's own expectations */
    const char *output;        /* null: standard output */
    unsigned long part, parts; /* --part=K/N; parts 0: not given */
    const char *plot;          /* the picture's file; null: none */
    const char *plot_script;   /* the script's file; null: none */
    plot_request drawing;      /* PLOT_COUNT: no kind is given */
    fourlink_change *changes;  /* --set, and the options that are a key of the deck */
    unsigned long n_changes;
    const char **decks; /* "-": standard input */
    size_t n_decks;
    char *storage, *next; /* room for the assignments of them, and for the one to come */
} options;

/* Read the command line: 1 if it is in order; 0 if not, then `message` says why; -1 when out of
** memory. */
int options_read(int argc, char **argv, options *o, char message[400]);
void options_free(options *o);

/* The lines of --help, ended by a null pointer. */
extern const char *const options_help[];

#endif
