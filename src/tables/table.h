/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table.h - results to text, a file for each way: table.c, csv.c, paper.c, matrix.c, summary.c,
** grade.c.
*/
#ifndef FOURLINK_TABLE_H
#define FOURLINK_TABLE_H

#include <stdio.h>

#include "results/column.h"
#include "print.h"

typedef enum table_format { FORMAT_TABLE, FORMAT_CSV, FORMAT_PAPER } table_format;

/* Each prints a deck to a stream and adds to `failed` how many of its rows could not be computed;
** whether the stream took it is for the caller to ask.  0 when out of memory. */
int table_print(FILE *out, analysis *a, const column_list *columns, unsigned long *failed);

/* The same; these need no memory, and return how many rows. */
unsigned long paper_print(FILE *out, analysis *a);
unsigned long matrix_print(FILE *out, analysis *a);

/* The facts, in place of the table. */
void summary_print(FILE *out, analysis *a, const column_list *columns);

/* The same in csv; one header for all decks. */
void summary_print_csv_header(FILE *out, int with_deck);
void summary_print_csv(FILE *out, analysis *a, const column_list *columns, const char *deck_name);

/* The printed values against the computed ones, a line each. */
enum { GRADE_OK, GRADE_DIFFERENCES, GRADE_MISTAKES, GRADE_MEMORY };
int grade_print(FILE *out, deck *d, int csv, const char *deck_name);
void grade_print_csv_header(FILE *out, int with_deck);
void grade_print_csv_bad_deck(FILE *out, const char *deck_name);

/* What csv rows begin with: the deck's name, if it is not null; number and quantities of a design, if
** `sweep` is not null. */
typedef struct csv_labels {
    const char *deck_name;
    const deck_sweep *sweep;
    unsigned long design;
} csv_labels;

/* Csv has one header for all decks: the union of their columns.  `d` is for the units of a sweep. */
void csv_print_header(FILE *out, const deck *d, const column_list *header,
                      const csv_labels *labels);
int csv_print(FILE *out, analysis *a, const column_list *columns, const column_list *header,
              const csv_labels *labels, unsigned long *failed);

/* Pieces of it: a column's name and unit, the labels and their names with a comma behind each, a number. */
void csv_heading(row_buffer *row, text name, const char *unit_name);
void csv_put_label_names(row_buffer *row, const deck *d, const csv_labels *labels);
void csv_put_labels(row_buffer *row, const csv_labels *labels);
void csv_put_number(row_buffer *row, double x);

/* A row with nothing but a reason in it. */
void csv_print_reason(FILE *out, const column_list *header, const csv_labels *labels,
                      fourlink_branch branch, const char *why);

/* The columns and facts, and what they mean. */
int list_print(FILE *out, analysis *a);

#endif
