/* SPDX-License-Identifier: GPL-3.0-or-later
**
** print.h - what the formats share: branches, reasons, fields, the head of a table.
*/
#ifndef FOURLINK_PRINT_H
#define FOURLINK_PRINT_H

#include <stdio.h>

#include "analysis.h"
#include "number.h"

/* The branches of a deck in the order of printing; how many. */
int print_branches_of(const deck *d, fourlink_branch branches[2]);

/* An angle of the motion, with no more decimals than it needs. */
const char *print_angle(double angle, char out[NUMBER_SIZE]);

/* The reason for which a crank stops, "" if it does not. */
const char *print_stop(const analysis *a, char out[NUMBER_SIZE + 80]);

/* The status of a row in words: "ok", or the reason why it has no numbers.  A dead position is flagged
** before it is reached: within a degree of it, errors of the data grow more than 57 times. */
const char *print_status(const result *r);

/* A field, with blanks before it. */
void print_right(FILE *out, const char *s, size_t width);

/* A field of csv, in quotes if it needs them (RFC 4180). */
void print_field(FILE *out, const char *s);

/* Title and mechanism, as comments. */
void print_head(FILE *out, const deck *d);

#endif
