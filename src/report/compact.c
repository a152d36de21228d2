/* SPDX-License-Identifier: GPL-3.0-or-later
**
** compact.c - gnuplot's drawings, made shorter.
*/
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "compact.h"

static int begins(const char *s, const char *with)
{
    return strncmp(s, with, strlen(with)) == 0;
}

static const char *skip_blanks(const char *s)
{
    while (isspace((unsigned char)*s))
        s++;
    return s;
}

/* Returns what comes after an empty group; null if there is none here. */
static const char *skip_empty_group(const char *s)
{
    const char *end = begins(s, "<g ") ? strchr(s, '>') : NULL;

    end = end ? skip_blanks(end + 1) : NULL;
    return end && begins(end, "</g>") ? end + 4 : NULL;
}

#define FARTHEST 1e6

/* Read a coordinate, in pixels; returns what comes after it, or null if there is none. */
static const char *read_coordinate(const char *s, const char *end, double *value)
{
    text rest;

    rest.start = s = *s == ',' ? s + 1 : skip_blanks(s);
    for (rest.length = 0; s + rest.length < end && strchr("-.0123456789", s[rest.length]);
         rest.length++)
        ;
    return flk_number_read(&rest, value) == NUMBER_OK && fabs(*value) < FARTHEST ? rest.start
                                                                                 : NULL;
}

typedef struct place {
    double x, y;
} place;

/* A path on its way out. */
typedef struct path {
    FILE *out;
    long x, y;  /* where it is, in tenths of a pixel */
    char last;  /* the letter of the last command */
    place from; /* the last point that was written */
    place step; /* from there to the next point */
    place held; /* the last point, not written yet */
    int has_held;
} path;

static void put_tenths(FILE *out, long tenths)
{
    const char *sign = tenths < 0 ? "-" : "";

    tenths = labs(tenths);
    if (tenths % 10)
        fprintf(out, "%s%ld.%ld", sign, tenths / 10, tenths % 10);
    else
        fprintf(out, "%s%ld", sign, tenths / 10);
}

/* Write a point: absolute after M, otherwise relative to the one before. */
static void put_point(path *p, char letter, place to)
{
    long x = (long)floor(10 * to.x + 0.5), y = (long)floor(10 * to.y + 0.5);

    putc(letter == 'M' ? 'M' : p->last == 'l' ? ' ' : 'l', p->out);
    put_tenths(p->out, letter == 'M' ? x : x - p->x);
    putc(',', p->out);
    put_tenths(p->out, letter == 'M' ? y : y - p->y);
    p->x = x;
    p->y = y;
    p->from = to;
    p->last = letter;
}

static void put_held(path *p)
{
    if (p->has_held)
        put_point(p, 'l', p->held);
    p->has_held = 0;
}

/* 1 if a point goes on from the held one in a straight line, within a tenth of a pixel. */
static int goes_on(const path *p, place to)
{
    double x = to.x - p->from.x, y = to.y - p->from.y;
    double along = x * p->step.x + y * p->step.y, across = x * p->step.y - y * p->step.x;
    double before = (p->held.x - p->from.x) * p->step.x + (p->held.y - p->from.y) * p->step.y;

    return p->has_held && along > before && fabs(across) <= 0.1 * gsl_hypot(p->step.x, p->step.y);
}

static void add_point(path *p, place to)
{
    if (!goes_on(p, to)) {
        put_held(p);
        p->step.x = to.x - p->from.x;
        p->step.y = to.y - p->from.y;
    }
    p->held = to;
    p->has_held = 1;
}

/* Write the points of a path, or of a polygon, which has no letters. */
static void put_points(const char *s, const char *end, FILE *out)
{
    char letter = 'M';
    place to;
    path p;

    memset(&p, 0, sizeof p);
    p.out = out;
    while ((s = skip_blanks(s)) < end) {
        if (strchr("MLZ", *s))
            letter = *s++;
        if (letter == 'Z') {
            put_held(&p);
            p.last = 'z';
            letter = 'M';
            putc('z', out);
            continue;
        }
        s = read_coordinate(s, end, &to.x);
        s = s ? read_coordinate(s, end, &to.y) : NULL;
        if (!s)
            break;
        if (letter == 'M') {
            put_held(&p);
            put_point(&p, 'M', to);
            letter = 'L';
        } else {
            add_point(&p, to);
        }
    }
    put_held(&p);
}

/* Write the attribute d of a path, or the points of a polygon as that, from the first point on.  Returns what
** comes after it. */
static const char *put_path(const char *s, int is_polygon, FILE *out)
{
    const char *end = strchr(s, '\''), *c;
    int has_lines = end != NULL;

    for (c = s; has_lines && c < end; c++)
        has_lines = strchr("MLZ-., 0123456789\n\t", *c) != NULL;
    fputs(" d='", out);
    if (!has_lines)
        return s;
    put_points(s, end, out);
    if (is_polygon)
        putc('z', out);
    return end;
}

/* Write the end of a tag and the words after it; blanks alone are left out.  gnuplot leaves ]]> in them,
** which XML does not allow.  Returns the next tag. */
static const char *put_words(const char *s, FILE *out)
{
    putc('>', out);
    if (*skip_blanks(s) == '<')
        return skip_blanks(s);
    for (; *s && *s != '<'; s++)
        if (begins(s, "]]>")) {
            fputs("]]&gt;", out);
            s += 2;
        } else {
            putc(*s, out);
        }
    return s;
}

/* What all groups of gnuplot's say is said once, around them; what SVG takes anyway, never. */
#define COMMON " fill=\"none\" color=\"black\" stroke=\"currentColor\""
#define USUAL " stroke-linecap=\"butt\" stroke-linejoin=\"miter\""
#define BODY "</defs"
#define END "</svg>"

static void shorten(const char *s, FILE *out)
{
    const char *body = strstr(s, BODY), *after;

    while (*s) {
        if ((after = skip_empty_group(s)) != NULL) {
            s = after;
        } else if (s == body) {
            fputs(BODY "><g" COMMON, out);
            s += strlen(BODY);
        } else if (s > body && begins(s, COMMON)) {
            s += strlen(COMMON);
        } else if (begins(s, USUAL)) {
            s += strlen(USUAL);
        } else if (body && begins(s, END)) {
            fputs("</g>" END, out);
            s += strlen(END);
        } else if (s > body && begins(s, " d='")) {
            s = put_path(s + 4, 0, out);
        } else if (begins(s, "<polygon ")) {
            fputs("<path ", out);
            s += 9;
        } else if (begins(s, " points = '")) {
            s = put_path(s + 11, 1, out);
        } else if (*s == '>') {
            s = put_words(s + 1, out);
        } else {
            putc(*s++, out);
        }
    }
}

int compact_svg(FILE *drawing, FILE *out)
{
    long length = fseek(drawing, 0, SEEK_END) == 0 ? ftell(drawing) : -1;
    char *bytes = length >= 0 ? malloc((size_t)length + 1) : NULL;

    if (!bytes)
        return 0;
    rewind(drawing);
    bytes[fread(bytes, 1, (size_t)length, drawing)] = '\0';
    shorten(bytes, out);
    free(bytes);
    return 1;
}
