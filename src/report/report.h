/* SPDX-License-Identifier: GPL-3.0-or-later
**
** report.h - the report of a deck: one page of HTML that needs no other file.
**
** report.c has the order of its sections.  Each section is a function of its own file.
*/
#ifndef FOURLINK_REPORT_H
#define FOURLINK_REPORT_H

#include "system/format.h"
#include "page.h"
#include "pictures/plot.h"
#include "view/view.h"

/* What the caller knows beside the deck. */
typedef struct report_request {
    int is_printed; /* 1: as pdf, on A4, or with lengths in inches or feet on Letter; 0: by whoever opens it */
    fourlink_results *opened;       /* of the deck; null: it has mistakes */
    const fourlink_solution *found; /* its linkage; null: it was not found by synthesis */
    const char
        *at; /* the crank angle of the sample calculation, as in --plot-at; null: not given */
} report_request;

enum { REPORT_MISTAKES = 100 };

/* A report in the making. */
typedef struct report {
    page page;
    const fourlink_source *source;
    const report_request *request;
    fourlink_mistake *notes; /* on the deck, or its mistakes */
    unsigned long n_notes;
    plot_deck drawn;                 /* for the figures */
    view v;                          /* its results are null if the deck has mistakes */
    fourlink_load *row_loads;        /* room for the loads of a row */
    int has_rows;                    /* 1: there is a row to draw */
    unsigned long failed, differing; /* rows that could not be computed, expected values */
    int reason;                      /* errno: why its csv is not there, or 0 */

    /* the sample calculation */
    fourlink_instant now; /* its status says why there is none */
    fourlink_load *loads; /* at its crank angle */
    char at[60];          /* its crank angle, with its unit */
    char why[VIEW_WHY];   /* it was chosen; "": it was asked for, or there is none */
    const char *drawn_at; /* --plot-at of the pictures; null: they choose the same angle */
    char exact[FORMAT_SIZE + 40];
} report;

/* What became of a report that was written. */
typedef struct report_outcome {
    int has_failed; /* 1: rows could not be computed */
    int differs;    /* 1: expected values differ */
    int reason;     /* errno: a temporary file failed; 0: none did */
} report_outcome;

/* Write the report of a deck; of one with mistakes, the deck and its mistakes.  Returns 1; 0 and the
** reason why there is none; -1 if out of memory or a temporary file failed.  The caller checks the stream. */
int report_write(FILE *out, const fourlink_source *source, const report_request *request,
                 report_outcome *outcome, fourlink_mistake *mistake);

/* Write the sample calculation alone, as HTML; nothing for a deck that a report does not take.  The same. */
int report_write_sample(FILE *out, const fourlink_source *source, const report_request *request,
                        fourlink_mistake *mistake);

/* The parts that make the drawing interactive, in interactive.c.  The style goes to the head of the page, the
** drawing into a section, the script to the end of the body. */
void report_put_style(page *p);
void report_put_interactive(report *r); /* with the results */
void report_put_script(page *p);

/* The sections. */
void report_put_deck(report *r);
void report_put_mechanism(report *r); /* with the results */
void report_put_results(report *r);
void report_put_synthesis(report *r);
void report_put_facts(report *r);
void report_put_sample(report *r);
void report_put_curves(report *r);
void report_put_tables(report *r);
void report_put_checks(report *r);
void report_put_inputs(report *r);

#endif
