/* SPDX-License-Identifier: GPL-3.0-or-later
**
** print.h - what the formats share: branches, reasons, fields, rows, the head of a table.
*/
#ifndef FOURLINK_PRINT_H
#define FOURLINK_PRINT_H

#include <stdio.h>

#include "results/row.h"
#include "base/format.h"

/* The branches of a deck in the order of printing; how many. */
int print_branches_of(const deck *d, fourlink_branch branches[2]);

/* An angle of the motion, with no more decimals than it needs. */
const char *print_angle(double angle, char out[FORMAT_SIZE]);

/* A crank angle, in the deck's unit, for a picture: 60Â°, or 1.047 rad. */
#define PRINT_MARK (FORMAT_SIZE + DECK_NAME_SIZE)
char *print_mark(const deck *d, double angle, char out[PRINT_MARK]);

/* The reason for which a crank stops, "" if it does not. */
const char *print_stop(const analysis *a, char out[FORMAT_SIZE + 80]);

/* The status of a row in words: "ok", or the reason why it has no numbers.  A dead position is flagged
** before it is reached: within a degree of it, errors of the data grow more than 57 times. */
const char *print_status(const result *r);

/* 1 if that is "ok". */
int print_is_ordinary(const result *r);

/* A field, with blanks before it. */
void print_right(FILE *out, const char *s, size_t width);

/* A field of csv, in quotes if it needs them (RFC 4180). */
void print_field(FILE *out, const char *s);

/* Rows on their way to a stream, which is not to be written to otherwise before row_end. */
typedef struct row_buffer {
    FILE *out;
    size_t length;
    char bytes[8192]; /* more than this goes to the stream in parts */
} row_buffer;

void row_start(row_buffer *row, FILE *out);
void row_end(row_buffer *row);

/* Some text; a field as by print_right; one as by print_field. */
void row_text(row_buffer *row, const char *s, size_t length);
void row_right(row_buffer *row, const char *s, size_t length, size_t width);

/* A number at the end of so many characters, of which it must leave at least one blank: its magnitude
** is for the caller to look at.  0, and nothing is written, if it is left to row_right. */
int row_fixed(row_buffer *row, double value, int decimals, size_t width);
void row_field(row_buffer *row, const char *s);

/* Title and mechanism, as comments. */
void print_head(FILE *out, const deck *d);

#endif
