/* SPDX-License-Identifier: GPL-3.0-or-later
**
** roster.c - the list of a class: names, ids, days late.
*/
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "base/number.h"
#include "system/memory.h"
#include "command.h"
#include "files.h"
#include "roster.h"
#include "person.h"

enum { NAME, FIRST_NAME, SURNAME, ID, USER, EMAIL, LATE, DESIGN, OTHER, COLUMNS };

/* Headings by which a first line is known: those of lists that people write, and of learning platforms. */
static const struct {
    const char *words;
    int column;
} headings[] = {{"name", NAME},
                {"full name", NAME},
                {"student", NAME},
                {"student name", NAME},
                {"first name", FIRST_NAME},
                {"first name(s)", FIRST_NAME},
                {"firstname", FIRST_NAME},
                {"given name", FIRST_NAME},
                {"given names", FIRST_NAME},
                {"given", FIRST_NAME},
                {"forename", FIRST_NAME},
                {"surname", SURNAME},
                {"last name", SURNAME},
                {"lastname", SURNAME},
                {"family name", SURNAME},
                {"id", ID},
                {"id number", ID},
                {"student id", ID},
                {"late", LATE},
                {"days late", LATE},
                {"design", DESIGN},
                {"email", EMAIL},
                {"email address", EMAIL},
                {"e-mail", EMAIL},
                {"username", USER},
                {"user name", USER},
                {"login id", USER},
                {"sis login id", USER},
                {"orgdefinedid", ID},
                {"sis user id", ID},
                {"student number", ID},
                {"matriculation number", ID},
                {"group", OTHER},
                {"groups", OTHER}};

static int refuse(const char *path, long at, const char *why)
{
    command_tell("error", path, at, why, NULL);
    return EXIT_USAGE;
}

/* Find the columns of a line by its headings, -1 for none; returns how many it has. */
static int find_columns(text row, int separator, int place[COLUMNS])
{
    text field;
    size_t k;
    int i, n = 0;

    for (i = 0; i < COLUMNS; i++)
        place[i] = -1;
    for (i = 0; flk_text_field(&row, separator, &field); i++)
        for (k = 0; k < sizeof headings / sizeof *headings; k++)
            if (flk_text_equal(field, headings[k].words)) {
                place[headings[k].column] = i;
                n++;
            }
    return n;
}

/* Add a part of a name, with a blank after the part before. */
static void add_name(roster_entry *e, text part)
{
    char *end = (char *)e->name.start + e->name.length;

    if (!part.length)
        return;
    if (e->name.length)
        *end++ = ' ';
    memcpy(end, part.start, part.length);
    e->name.length = (size_t)(end - e->name.start) + part.length;
}

static int read_design(text field, unsigned long *design)
{
    double number;

    if (flk_number_read(&field, &number) != NUMBER_OK || field.length || number != floor(number) ||
        number < 1 || number > 4294967295.0)
        return 0;
    *design = (unsigned long)number;
    return 1;
}

/* Read a line; the status. */
static int read_entry(const char *path, text row, int separator, const int *place, roster_entry *e)
{
    text fields[COLUMNS], field;
    int i, k;

    memset(fields, 0, sizeof fields);
    for (i = 0; flk_text_field(&row, separator, &field); i++)
        for (k = 0; k < COLUMNS; k++)
            if (i == place[k])
                fields[k] = field;
    if (fields[NAME].length) {
        add_name(e, fields[NAME]);
    } else {
        add_name(e, fields[FIRST_NAME]);
        add_name(e, fields[SURNAME]);
    }
    e->id = fields[ID];
    e->user = fields[USER];
    e->email = fields[EMAIL];
    field = fields[LATE];
    if (e->name.length && field.length &&
        (flk_number_read(&field, &e->late) != NUMBER_OK || field.length || !(e->late >= 0)))
        return refuse(path, e->line, "late must be a number of days, such as 2");
    if (e->name.length && fields[DESIGN].length && !read_design(fields[DESIGN], &e->design))
        return refuse(path, e->line, "design must be a whole number from 1");
    return 0;
}

static size_t count_fields(text row, int separator)
{
    size_t n = 0;
    text field;

    while (flk_text_field(&row, separator, &field))
        n++;
    return n;
}

/* Read all lines; the status. */
static int read_lines(roster *r, const char *path, text rest)
{
    int place[COLUMNS], line_end = flk_text_line_end(rest), separator = 0, status = 0;
    char *next = r->names; /* a name is not longer than its line */
    long at = 0;
    text row;

    while (!status && flk_text_split(&rest, line_end, &row)) {
        roster_entry *e = &r->list[r->n];

        if (++at == 1) {
            separator = flk_text_separator(row);
            r->has_header = find_columns(row, separator, place) > 0;
            r->separator = separator;
            r->n_columns = r->has_header ? (int)count_fields(row, separator) : 1;
            r->design_column = r->has_header ? place[DESIGN] : -1;
            if (!r->has_header && count_fields(row, separator) > 2)
                return refuse(path, 1,
                              "expected a line of headings, such as name,id, or first "
                              "name,surname,id number");
            if (r->has_header && place[NAME] < 0 && place[FIRST_NAME] < 0 && place[SURNAME] < 0)
                return refuse(path, 1, "no column has the heading name, or first name and surname");
            if (r->has_header)
                continue;
        }
        memset(e, 0, sizeof *e);
        e->line = at;
        e->name.start = next;
        if (r->has_header)
            status = read_entry(path, row, separator, place, e);
        else
            add_name(e, flk_text_trim(row));
        next += e->name.length;
        *next++ = '\0';
        r->n += e->name.length > 0;
    }
    return status;
}

int roster_read(roster *r, const char *path)
{
    size_t length = 0;
    int status;
    text all;

    memset(r, 0, sizeof *r);
    r->contents = files_read(path, &length);
    if (!r->contents)
        return command_complain("cannot read", path, strerror(errno));
    all.start = r->contents;
    all.length = length;
    r->lines = all = flk_text_without_mark(all);
    r->design_column = -1;
    r->list = memory_get(flk_text_count(all, flk_text_line_end(all)) + 1, sizeof *r->list);
    r->names = memory_get(length + 2, 1);
    if (!r->list || !r->names)
        return command_lacks_memory("cannot read", path);
    status = read_lines(r, path, all);
    return status || r->n ? status : refuse(path, 0, "there is no name in it");
}

/* Write field i of a line as it stands there, and take it off. */
static void copy_field(text *row, int separator, FILE *out)
{
    text whole = *row, field;

    if (!flk_text_field(row, separator, &field))
        return;
    if (row->start)
        whole.length -= row->length + 1;
    fwrite(whole.start, 1, whole.length, out);
}

/* Write a line with this in the column of the design. */
static void write_row(const roster *r, text row, const char *design, FILE *out)
{
    int place = r->design_column < 0 ? r->n_columns : r->design_column, i;
    text unused;

    for (i = 0; i <= place || i < r->n_columns; i++) {
        if (i)
            putc(r->separator, out);
        if (i != place) {
            copy_field(&row, r->separator, out);
            continue;
        }
        fputs(design, out);
        if (r->design_column >= 0)
            flk_text_field(&row, r->separator, &unused);
    }
}

/* Write a name of a list as a field. */
static void write_name(text name, FILE *out)
{
    int is_quoted = memchr(name.start, ',', name.length) || memchr(name.start, '"', name.length);
    size_t i;

    fputs(is_quoted ? "\"" : "", out);
    for (i = 0; i < name.length; i++) {
        fputs(name.start[i] == '"' ? "\"" : "", out);
        putc(name.start[i], out);
    }
    fputs(is_quoted ? "\"" : "", out);
}

void roster_write(const roster *r, FILE *out)
{
    text rest = r->lines, row;
    int line_end = flk_text_line_end(rest);
    const char *end = memchr(rest.start, '\r', rest.length) ? "\r\n" : "\n";
    const roster_entry *e = r->list;
    char design[40];
    long at = 0;

    if (!r->has_header)
        fprintf(out, "name,design%s", end);
    while (flk_text_split(&rest, line_end, &row)) {
        int has_entry;

        at++;
        has_entry = e < r->list + r->n && e->line == at;
        if (!flk_text_trim(row).length)
            continue;
        row.length -= row.start[row.length - 1] == '\r';
        design[0] = '\0';
        if (has_entry && e->design)
            sprintf(design, "%lu", e->design);
        if (r->has_header) {
            write_row(r, row, at == 1 ? "design" : design, out);
        } else {
            write_name(e->name, out);
            fprintf(out, ",%s", design);
        }
        fputs(end, out);
        e += has_entry;
    }
}

void roster_free(roster *r)
{
    free(r->contents);
    free(r->names);
    free(r->list);
}

const roster_entry *roster_find(const roster *r, text name)
{
    size_t i;

    for (i = 0; i < r->n; i++)
        if (person_same(r->list[i].name, name))
            return &r->list[i];
    return NULL;
}
