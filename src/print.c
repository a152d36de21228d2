/* SPDX-License-Identifier: GPL-3.0-or-later
**
** print.c - what the formats share: branches, reasons, fields, the head of a table.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "number.h"
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

const char *print_angle(double angle, char out[NUMBER_SIZE])
{
    return number_general(angle, 12, out);
}

const char *print_stop(const analysis *a, char out[NUMBER_SIZE + 80])
{
    char number[NUMBER_SIZE];

    out[0] = '\0';
    if (a->range.stops) {
        strcpy(out, "the crank comes to rest at ");
        strcat(out, print_angle(a->range.stop_angle, number));
        strcat(out, " ");
        strcat(out, a->d->units[QUANTITY_ANGLE].name);
    }
    return out;
}

const char *print_status(const result *r)
{
    if (r->status == FOURLINK_OK && r->state.mu < M_PI / 180)
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
    char number[NUMBER_SIZE];

    fprintf(out, "%s %s %s", name, number_general(unit_from_si(length, u->unit), 12, number),
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
void print_field(FILE *out, const char *s)
{
    if (!strpbrk(s, ",\"\r\n")) {
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
