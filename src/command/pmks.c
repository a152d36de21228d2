/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pmks.c - a link of PMKS+, the page on which linkages are drawn.
**
** The link has what is drawn as texts, in percent-encoding:
**
**    j=    joints, a line each: name, x, y, names of its links with | between them, R (turns) or P
**          (slides), t if it is fixed or f, direction of its slide in rad, coefficient of friction, t if it
**          is the input or f
**    l=    links: name, mass, moment of inertia, centre of mass x and y, names of its joints, ...
**    f=    forces: name, link, tail x and y, tip x and y of the arrow, t if its direction is fixed, true if
**          it is directed as the arrow, x and y components
**    s=    speed in rpm, true if clockwise, true if there is gravity, unit of length
**
** A later release leaves the friction out, says R or P after the name of a link, has one size of a force,
** and a link of its own for what slides.
*/
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/message.h"
#include "base/number.h"
#include "base/trig.h"
#include "command.h"
#include "foreign.h"
#include "pmks.h"
#include "system/memory.h"

#define LONGEST 24   /* of a name */
#define FARTHEST 1e6 /* a number of a link */
#define MOST_FIELDS 20

static const pmks_units units[] = {{"cm", "g", "kg cm2", "N"}, {"m", "kg", "kg m2", "N"},
                                   {"mm", NULL, NULL, NULL},   {"km", NULL, NULL, NULL},
                                   {"in", NULL, NULL, NULL},   {"ft", NULL, NULL, NULL}};

static void tell_of_link(const pmks_link *k, const char *what, const char *format, va_list values)
{
    char message[MESSAGE_SIZE];

    command_tell(what, k->file, k->line, flk_message_list(message, sizeof message, format, values),
                 NULL);
}

int pmks_refuse(const pmks_link *k, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    tell_of_link(k, "error", format, values);
    va_end(values);
    return 0;
}

void pmks_note(const pmks_link *k, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    tell_of_link(k, "note", format, values);
    va_end(values);
}

int pmks_is_same(text a, text b)
{
    return a.length == b.length && memcmp(a.start, b.start, a.length) == 0;
}

/* ---------------------------------------------------------------------------------------- its texts */

/* The first link of a file, and its line; the number of links. */
static size_t take_link(text t, text *first, long *line)
{
    text rest = flk_text_without_mark(t), one;
    size_t n = 0;
    long number = 0;

    while (flk_text_split(&rest, '\n', &one)) {
        number++;
        one = flk_text_trim(one);
        if (foreign_is_link(one) && n++ == 0) {
            *first = one;
            *line = number;
        } else if (n == 1) {
            first->length = (size_t)(one.start + one.length - first->start);
        }
    }
    return n;
}

/* A link without its address. */
static text after_address(text link)
{
    const char *parts = memchr(link.start, '?', link.length);

    return parts ? flk_text_from(link, (size_t)(parts + 1 - link.start)) : link;
}

static int hex_digit(int c)
{
    const char *digits = "0123456789abcdef", *at;

    at = c ? strchr(digits, c >= 'A' && c <= 'F' ? c + 'a' - 'A' : c) : NULL;
    return at ? (int)(at - digits) : -1;
}

/* Decode %0A and the like in place; 0 if a sign is not followed by two digits. */
static int decode(char *from, size_t *length)
{
    size_t i, n = 0;

    for (i = 0; i < *length; i++) {
        int c = (unsigned char)from[i];

        if (c == '%') {
            if (*length - i < 3 || hex_digit(from[i + 1]) < 0 || hex_digit(from[i + 2]) < 0)
                return 0;
            c = 16 * hex_digit(from[i + 1]) + hex_digit(from[i + 2]);
            i += 2;
        }
        from[n++] = (char)c;
    }
    *length = n;
    return 1;
}

int pmks_next_name(text *list, text *name)
{
    if (!list->length || !flk_text_split(list, '|', name))
        return 0;
    *name = flk_text_trim(*name);
    return 1;
}

/* The fields of a line, trimmed; an empty one at its end does not count.  0: there are more. */
static size_t split(text line, text field[MOST_FIELDS])
{
    size_t n = 0;

    while (n < MOST_FIELDS && flk_text_split(&line, ',', &field[n])) {
        field[n] = flk_text_trim(field[n]);
        n++;
    }
    return line.start ? 0 : n && !field[n - 1].length ? n - 1 : n;
}

static int is_name(text t)
{
    size_t i;

    for (i = 0; i < t.length; i++)
        if (!flk_text_is_word(t.start[i]) || (unsigned char)t.start[i] >= 0x80)
            return 0;
    return t.length > 0 && t.length <= LONGEST;
}

static int is_number(text t, double *value)
{
    return flk_number_read(&t, value) == NUMBER_OK && !t.length && fabs(*value) <= FARTHEST;
}

/* t or f, true or false. */
static int is_flag(text t, int *flag)
{
    *flag = flk_text_same(t, "t") || flk_text_same(t, "true");
    return *flag || flk_text_same(t, "f") || flk_text_same(t, "false");
}

int pmks_has_name(text list, text name)
{
    text one;

    while (flk_text_split(&list, '|', &one))
        if (pmks_is_same(flk_text_trim(one), name))
            return 1;
    return 0;
}

static int has_names_only(text list)
{
    text one;

    while (flk_text_split(&list, '|', &one))
        if (!is_name(flk_text_trim(one)))
            return 0;
    return 1;
}

/* name, x, y, links, R or P, fixed, direction, friction, input; without friction in a later release */
static int read_joint(pmks_link *k, text line)
{
    pmks_joint *new = &k->joints[k->n_joints];
    text f[MOST_FIELDS];
    size_t n = split(line, f), i;
    double friction = 0, radians = 0;

    if (n != 8 && n != 9)
        return pmks_refuse(
            k, "'%t': expected a joint, name,x,y,links,R or P,t or f,angle,friction,t or f", line);
    memset(new, 0, sizeof *new);
    new->name = f[0];
    new->links = f[3];
    new->slides = flk_text_same(f[4], "P");
    if (!is_name(f[0]))
        return pmks_refuse(k, "'%t': the name of a joint must be a word of letters and digits",
                           f[0]);
    for (i = 0; i < k->n_joints; i++)
        if (pmks_is_same(k->joints[i].name, f[0]))
            return pmks_refuse(k, "there are two joints '%t'", f[0]);
    if (!is_number(f[1], &new->x) || !is_number(f[2], &new->y))
        return pmks_refuse(k, "joint %t: '%t' and '%t' are not its place", f[0], f[1], f[2]);
    if (!has_names_only(f[3]))
        return pmks_refuse(k, "joint %t: '%t' are not names of links", f[0], f[3]);
    if (!new->slides && !flk_text_same(f[4], "R"))
        return pmks_refuse(k, "joint %t: expected R or P, not '%t'", f[0], f[4]);
    if (!is_flag(f[5], &new->is_fixed) || !is_flag(f[n - 1], &new->is_input))
        return pmks_refuse(k, "joint %t: expected t or f for fixed and input, not '%t' and '%t'",
                           f[0], f[5], f[n - 1]);
    if (new->slides && !is_number(f[6], &radians))
        return pmks_refuse(k, "joint %t: '%t' is not the direction of its slide, in radians", f[0],
                           f[6]);
    if (n == 9 && !is_number(f[7], &friction))
        return pmks_refuse(k, "joint %t: '%t' is not a coefficient of friction", f[0], f[7]);
    k->has_friction |= n == 9 && friction != 0.1 && friction != 0;
    new->direction = f[6];
    new->angle = radians * 180 / M_PI;
    k->n_joints++;
    return 1;
}

/* name, mass, inertia, x, y, joints, ...; in a later release R or P after the name */
static int read_body(pmks_link *k, text line)
{
    pmks_body *new = &k->bodies[k->n_bodies];
    text f[MOST_FIELDS];
    size_t n = split(line, f), first, i;

    memset(new, 0, sizeof *new);
    first = n > 1 && (flk_text_same(f[1], "R") || flk_text_same(f[1], "P"));
    if (n < 6 + first)
        return pmks_refuse(k, "'%t': expected a link, name,mass,inertia,x,y,joints", line);
    new->name = f[0];
    new->joints = f[5 + first];
    for (i = 0; i < k->n_bodies; i++)
        if (pmks_is_same(k->bodies[i].name, f[0]))
            return pmks_refuse(k, "there are two links '%t'", f[0]);
    if (first && flk_text_same(f[1], "P")) {
        k->n_bodies++;
        return 1;
    }
    if (!is_number(f[1 + first], &new->mass) || !is_number(f[2 + first], &new->inertia) ||
        !is_number(f[3 + first], &new->x) || !is_number(f[4 + first], &new->y) || new->mass < 0 ||
        new->inertia < 0)
        return pmks_refuse(
            k, "link %t: '%t', '%t', '%t', '%t' are not its mass, inertia and centre of mass", f[0],
            f[1 + first], f[2 + first], f[3 + first], f[4 + first]);
    new->has_mass = 1;
    k->n_bodies++;
    return 1;
}

/* name, link, tail x and y, tip x and y, fixed, as the arrow, size or its components */
static int read_force(pmks_link *k, text line)
{
    pmks_force *new = &k->forces[k->n_forces];
    text f[MOST_FIELDS];
    size_t n = split(line, f);
    double size[2] = {0, 0};
    int as_arrow;

    memset(new, 0, sizeof *new);
    if ((n != 9 && n != 10) || !is_name(f[0]) || !is_name(f[1]) || !is_number(f[2], &new->x) ||
        !is_number(f[3], &new->y) || !is_number(f[4], &new->to_x) || !is_number(f[5], &new->to_y) ||
        !is_flag(f[6], &new->is_fixed) || !is_flag(f[7], &as_arrow) || !is_number(f[8], &size[0]) ||
        (n == 10 && !is_number(f[9], &size[1])))
        return pmks_refuse(k, "'%t': expected a force, name,link,x,y,x,y,t or f,true or false,size",
                           line);
    new->name = f[0];
    new->link = f[1];
    new->size = (as_arrow ? 1 : -1) * flk_length(size[0], size[1]);
    k->n_forces++;
    return 1;
}

/* speed, clockwise, gravity, unit */
static int read_settings(pmks_link *k, text line)
{
    text f[MOST_FIELDS];
    size_t n = split(line, f), i;

    if (n != 4 || !is_number(f[0], &k->speed) || !is_flag(f[1], &k->is_clockwise) ||
        !is_flag(f[2], &k->has_gravity))
        return pmks_refuse(k, "'%t': expected the settings, speed,clockwise,gravity,unit", line);
    for (i = 0; i < sizeof units / sizeof *units && !k->units; i++)
        if (flk_text_same(f[3], units[i].length))
            k->units = &units[i];
    return k->units || pmks_refuse(k, "'%t' is not a unit of length that is known", f[3]);
}

/* Read each line of a part of the link. */
static int read_lines(pmks_link *k, text part, int read(pmks_link *k, text line), const size_t *n)
{
    text line;

    while (flk_text_split(&part, '\n', &line)) {
        line = flk_text_trim(line);
        if (!line.length)
            continue;
        if (n && *n == PMKS_MOST)
            return pmks_refuse(k, "there are more than %ld joints, links or forces",
                               (long)PMKS_MOST);
        if (!read(k, line))
            return 0;
    }
    return 1;
}

/* The parts of the link, KEY=TEXT, which are decoded in place. */
static int read_parts(pmks_link *k, char *words, size_t length)
{
    static const char *const keys[] = {"j", "l", "f", "s", "pp", "tp"};
    text part[6], rest, one, key, value;
    size_t i, size;

    memset(part, 0, sizeof part);
    rest.start = words;
    rest.length = length;
    while (flk_text_split(&rest, '&', &one)) {
        value = one;
        if (!flk_text_split(&value, '=', &key) || !value.start)
            continue;
        for (i = 0; i < 6 && !flk_text_same(key, keys[i]); i++)
            ;
        if (i == 6)
            continue;
        if (part[i].start)
            return pmks_refuse(k, "the link has '%t' twice", one);
        size = value.length;
        if (!decode(words + (value.start - words), &size))
            return pmks_refuse(k, "after a %% of the link two digits are missing");
        value.length = size;
        part[i] = value;
    }
    k->has_positions = part[4].length > 0 || part[5].length > 0;
    return read_lines(k, part[0], read_joint, &k->n_joints) &&
           read_lines(k, part[1], read_body, &k->n_bodies) &&
           read_lines(k, part[2], read_force, &k->n_forces) &&
           read_lines(k, part[3], read_settings, NULL) &&
           (k->n_joints || pmks_refuse(k, "the link has no joints")) &&
           (k->units || pmks_refuse(k, "the link ends before its settings, s=: it is not whole"));
}

/* 1 if links and joints name each other. */
static int check_names(const pmks_link *k)
{
    size_t i, j;

    for (i = 0; i < k->n_bodies; i++) {
        const pmks_body *b = &k->bodies[i];
        size_t n = b->joints.length ? flk_text_count(b->joints, '|') + 1 : 0;

        for (j = 0; j < k->n_joints; j++) {
            int is_on = pmks_has_name(b->joints, k->joints[j].name);

            if (is_on != pmks_has_name(k->joints[j].links, b->name))
                return pmks_refuse(k, "joint %t and link %t do not name each other",
                                   k->joints[j].name, b->name);
            n -= (size_t)is_on;
        }
        if (n)
            return pmks_refuse(k, "link %t: '%t' are not all joints of the link", b->name,
                               b->joints);
    }
    return 1;
}

int pmks_read(pmks_link *k, text t)
{
    text link = t;
    size_t n;

    k->line = 1;
    n = take_link(t, &link, &k->line);
    if (!n)
        return pmks_refuse(k, "expected a link of PMKS+, with j= before its joints");
    link = after_address(flk_text_unquoted(link));
    k->words = memory_get(link.length + 1, 1);
    if (!k->words)
        return 0;
    memcpy(k->words, link.start, link.length);
    if (!read_parts(k, k->words, link.length) || !check_names(k))
        return 0;
    if (n > 1)
        pmks_note(k, "the file has %ld links: this one is read", (long)n);
    return 1;
}

void pmks_free(pmks_link *k)
{
    free(k->words);
}
