/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table.h - results to text, a file for each way: table.c, csv.c, paper.c, matrix.c, summary.c,
** grade.c.
*/
#ifndef FOURLINK_TABLE_H
#define FOURLINK_TABLE_H

#include <stdio.h>

#include "column.h"

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

/* Csv has one header for all decks: the union of their columns.  `deck_name` null: no column of that
** name. */
void csv_print_header(FILE *out, const column_list *header, int with_deck);
int csv_print(FILE *out, analysis *a, const column_list *columns, const column_list *header,
              const char *deck_name, unsigned long *failed);

/* The columns and facts, and what they mean. */
int list_print(FILE *out, analysis *a);

#endif
