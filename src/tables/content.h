/* SPDX-License-Identifier: GPL-3.0-or-later
**
** content.h - what a sheet of results shows, once for all formats.
*/
#ifndef FOURLINK_CONTENT_H
#define FOURLINK_CONTENT_H

#include "sheet.h"

/* Begin a sheet.  The caller has set format, content, n_decks and header, and for a sweep its problem and
** variables.  `has_head` is 0 for a part that continues another. */
void content_begin(sheet *s, FILE *out, int has_head);

/* Write a deck; null results mean a deck with mistakes, of which `why` is the first. */
void content_write(sheet *s, fourlink_results *results, const char *deck_name, const char *why);

/* Write the names of several results, at most CONTENT_LISTED, as one list. */
#define CONTENT_LISTED 16
void content_write_list(sheet *s, fourlink_results *const *results, size_t n);

/* Write the line of a deck, or of a file of answers, in a sheet of scores. */
void content_write_mark(sheet *s, const sheet_mark *mark);

/* Write design i of a sweep, from 0: its rows or, with SHEET_DESIGNS, a line for each branch.  `varied` are
** the values of its variables.  If results are null, write the reason on the branches of `first`. */
void content_write_design(sheet *s, fourlink_results *results, fourlink_results *first,
                          unsigned long i, const double *varied, const char *why);

/* Contents with files of their own: the nine equations for each row; the deck's values as [expect] sections,
** for each row, or for the crank angles of s->at. */
void matrix_write(sheet *s);
void expect_write(sheet *s);

#endif
