/* SPDX-License-Identifier: GPL-3.0-or-later
**
** print.c - what the formats share: branches, reasons, fields, rows, the head of a table.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/digits.h"
#include "base/format.h"
#include "print.h"

int print_branches_of(const deck *d, fourlink_branch branches[2])
{
    int n = 0;

    if (d->open)
        branches[n++] = FOURLINK_OPEN;
    if (d->crossed)
        branches[n++] = FOURLINK_CROSSED;
    return n;
}

const char *print_angle(double angle, char out[FORMAT_SIZE])
{
    return format_general(angle, 12, out);
}

char *print_mark(const deck *d, double angle, char out[PRINT_MARK])
{
    const char *name = d->units[QUANTITY_ANGLE].name;
    int is_deg = strcmp(name, "deg") == 0;
    char number[FORMAT_SIZE];

    return flk_text_join(out, PRINT_MARK, format_general(angle, 4, number),
                         is_deg ? "\302\260" : " ", is_deg ? "" : name, (char *)NULL);
}

const char *print_stop(const analysis *a, char out[FORMAT_SIZE + 80])
{
    char number[FORMAT_SIZE];

    out[0] = '\0';
    if (a->range.stops) {
        strcpy(out, "the crank comes to rest at ");
        strcat(out, print_angle(a->range.stop_angle, number));
        strcat(out, " ");
        strcat(out, a->d->units[QUANTITY_ANGLE].name);
    }
    return out;
}

int print_is_ordinary(const result *r)
{
    return r->status == FOURLINK_OK && !(r->state.mu < M_PI / 180);
}

const char *print_status(const result *r)
{
    if (r->status == FOURLINK_OK && !print_is_ordinary(r))
        return "near a dead position: the transmission angle is less than 1 deg";
    return fourlink_status_text(r->status);
}

void print_right(FILE *out, const char *s, size_t width)
{
    size_t n = strlen(s);

    if (n >= width)
        putc(' ', out); /* wider than foreseen: still a field of its own */
    for (; n < width; n++)
        putc(' ', out);
    fputs(s, out);
}

static void put_length(FILE *out, const deck *d, const char *name, double length)
{
    const deck_unit *u = &d->units[QUANTITY_LENGTH];
    char number[FORMAT_SIZE];

    fprintf(out, "%s %s %s", name, format_general(flk_unit_from_si(length, u->unit), 12, number),
            u->name);
}

void print_head(FILE *out, const deck *d)
{
    const fourlink_design *design = &d->design;

    if (d->title[0])
        fprintf(out, "# %s\n", d->title);
    if (design->kind == FOURLINK_FOUR_BAR) {
        put_length(out, d, "# four-bar linkage: crank", design->link[2].length);
        put_length(out, d, ", coupler", design->link[3].length);
        put_length(out, d, ", rocker", design->link[4].length);
        put_length(out, d, ", ground", design->link[1].length);
    } else {
        put_length(out, d, "# slider-crank: crank", design->link[2].length);
        put_length(out, d, ", rod", design->link[3].length);
        if (design->offset != 0)
            put_length(out, d, ", offset", design->offset);
    }
    putc('\n', out);
}

/* RFC 4180: fields with a comma, a quote or the end of a line in them stand in quotes, and quotes
** in them are doubled. */
static int needs_quotes(const char *s)
{
    return strpbrk(s, ",\"\r\n") != NULL;
}

void print_field(FILE *out, const char *s)
{
    if (!needs_quotes(s)) {
        fputs(s, out);
        return;
    }
    putc('"', out);
    for (; *s; s++) {
        if (*s == '"')
            putc('"', out);
        putc(*s, out);
    }
    putc('"', out);
}

void row_start(row_buffer *row, FILE *out)
{
    row->out = out;
    row->length = 0;
}

void row_end(row_buffer *row)
{
    fwrite(row->bytes, 1, row->length, row->out);
    row->length = 0;
}

/* Make room for so much more; 0 if it is more than the buffer holds. */
static int row_room(row_buffer *row, size_t length)
{
    if (length > sizeof row->bytes - row->length)
        row_end(row);
    return length <= sizeof row->bytes;
}

void row_text(row_buffer *row, const char *s, size_t length)
{
    if (row_room(row, length)) {
        memcpy(row->bytes + row->length, s, length);
        row->length += length;
    } else {
        fwrite(s, 1, length, row->out);
    }
}

void row_right(row_buffer *row, const char *s, size_t length, size_t width)
{
    size_t blanks = length < width ? width - length : 1;

    if (row_room(row, blanks)) {
        memset(row->bytes + row->length, ' ', blanks);
        row->length += blanks;
    } else {
        for (; blanks > 0; blanks--)
            putc(' ', row->out);
    }
    row_text(row, s, length);
}

/* Blanks that are written at once, whether they are all needed or not. */
#define BLANKS 16

int row_fixed(row_buffer *row, double value, int decimals, size_t width)
{
    char *begin;

    if (!row_room(row, width + BLANKS))
        return 0;
    begin = row->bytes + row->length;
    memset(begin, ' ', BLANKS);
    if (width > BLANKS)
        memset(begin + BLANKS, ' ', width - BLANKS);
    if (!flk_digits_fixed_before(value, decimals, begin + width))
        return 0;
    row->length += width;
    return 1;
}

void row_field(row_buffer *row, const char *s)
{
    if (needs_quotes(s)) {
        row_end(row);
        print_field(row->out, s);
    } else {
        row_text(row, s, strlen(s));
    }
}
