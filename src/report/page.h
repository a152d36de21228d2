/* SPDX-License-Identifier: GPL-3.0-or-later
**
** page.h - a page of HTML, which is XML too.
*/
#ifndef FOURLINK_PAGE_H
#define FOURLINK_PAGE_H

#include <stddef.h>
#include <stdio.h>

typedef struct page {
    FILE *out;
    int n_figures, n_tables, n_equations, n_sections; /* so far: they are numbered */
} page;

/* Write markup, as printf does, with
**
**    %s     a text, harmless in an element and in an attribute in quotes
**    %m     markup, as it is
**    %n     the name of a value, typeset; %u, a unit; %U, the unit of the number before it
**    %d     a whole number, an int; %lu, an unsigned long
**    %.6g   a number with so many significant digits, -0 as 0; %.4f with so many decimals
**    %v     a number and how many digits its deck has; undefined and unbounded ones as signs
**    %%     a per cent sign */
void page_print(page *p, const char *format, ...);

#define PAGE_AT "at \316\270\342\202\202" /* a heading of a column */

/* Begin a table of facts with its number and a caption; one of another class.  `columns` are the headings,
** NAME|NAME.  End it. */
void page_table(page *p, const char *caption, const char *columns);
void page_table_of(page *p, const char *name_of_class, const char *caption, const char *columns);
void page_table_end(page *p);

/* Write a number as a cell of a column whose numbers have their points below each other: `most` is the
** largest number of letters from the point on, of all its numbers. */
int page_behind(double value, int digits);
void page_number_cell(page *p, double value, int digits, int most);

/* Begin the number and the title of a table that is folded on a screen, and open on paper unless it is long;
** a page_table of it has no caption.  End the fold. */
void page_fold(page *p, int is_long, const char *title, unsigned long n_rows);
void page_fold_end(page *p);

/* Write a row of a table, as page_print does: its name and its cells, with | between them. */
void page_row(page *p, const char *format, ...);

/* Write bytes in base64. */
void page_base64(page *p, FILE *bytes);

/* Begin a section with a heading h2 and its number; end it. */
void page_section(page *p, const char *id, const char *heading);
void page_section_end(page *p);

#endif
