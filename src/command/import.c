/* SPDX-License-Identifier: GPL-3.0-or-later
**
** import.c - a deck from a link of PMKS+, the page on which linkages are drawn.
**
** The link has what is drawn as texts, in percent-encoding:
**
**    j=    joints, a line each: name, x, y, names of its links with | between them, R (turns) or P (slides), t if
**          it is fixed or f, direction of its slide in rad, coefficient of friction, t if it is the input or f
**    l=    links: name, mass, moment of inertia, centre of mass x and y, names of its joints, ...
**    f=    forces: name, link, tail x and y, tip x and y of the arrow, t if its direction is fixed, true if it is
**          directed as the arrow, x and y components
**    s=    speed in rpm, true if clockwise, true if there is gravity, unit of length
**
** A later release leaves the friction out, says R or P after the name of a link, has one size of a force, and a link
** of its own for what slides.  The four links are the ground, the one with the input, and two that close a loop with
** it; the joints of other links are points.
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
#include "import.h"
#include "system/memory.h"

#define MOST 100     /* joints, links, forces */
#define LONGEST 24   /* of a name */
#define FARTHEST 1e6 /* a number of a link */
#define DECK_SIZE 65536
#define IN_LINE 1e-6 /* sine of an angle */
#define STEP 15.0    /* deg, of the directions that are drawn */
#define ROUNDED 0.03 /* deg, by which a direction in rad with three decimals can be beside one */
#define MOST_FIELDS 20

typedef struct joint {
    text name, links;
    double x, y;
    int slides, is_fixed, is_input;
    text direction; /* of its slide, rad */
    double angle;   /* the same, deg */
} joint;

typedef struct body {
    text name, joints;
    double mass, inertia, x, y;
    int has_mass;
} body;

typedef struct arrow {
    text name, link;
    double x, y, to_x, to_y; /* tail and tip */
    int is_fixed;
    double size; /* negative: against the arrow */
} arrow;

enum { PIN_A, PIN_B, PIN_C, PIN_D, PINS };

typedef struct import {
    const char *file;
    long line; /* of the link in the file */
    joint joints[MOST];
    body bodies[MOST];
    arrow arrows[MOST];
    size_t n_joints, n_bodies, n_arrows;
    int has_bodies, has_positions, has_friction;
    double speed;
    int has_settings, is_clockwise, has_gravity;
    const struct unit_names *unit;
    const joint *pin[PINS]; /* D is null of a slider-crank */
    const joint *slide;     /* null of a four-bar */
    text link[5];           /* by number, from 2 on; empty: what slides has none */
    char deck[DECK_SIZE];
    size_t length;
} import;

/* Its units of length, and those of mass, inertia and force that belong to them; null: not known. */
static const struct unit_names {
    const char *length, *mass, *inertia, *force;
} units[] = {{"cm", "g", "kg cm2", "N"}, {"m", "kg", "kg m2", "N"}, {"mm", NULL, NULL, NULL},
             {"km", NULL, NULL, NULL},   {"in", NULL, NULL, NULL},  {"ft", NULL, NULL, NULL}};

static void tell(const import *m, const char *what, const char *format, va_list values)
{
    char message[MESSAGE_SIZE];

    command_tell(what, m->file, m->line, flk_message_list(message, sizeof message, format, values),
                 NULL);
}

/* Tell a mistake of the link; returns 0. */
static int refuse(const import *m, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    tell(m, "error", format, values);
    va_end(values);
    return 0;
}

static void note(const import *m, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    tell(m, "note", format, values);
    va_end(values);
}

static int is_same(text a, text b)
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

/* 1 if a list with | between its names has this one. */
static int has_name(text list, text name)
{
    text one;

    while (flk_text_split(&list, '|', &one))
        if (is_same(flk_text_trim(one), name))
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
static int read_joint(import *m, text line)
{
    joint *new = &m->joints[m->n_joints];
    text f[MOST_FIELDS];
    size_t n = split(line, f), i;
    double friction = 0, radians = 0;

    if (n != 8 && n != 9)
        return refuse(
            m, "'%t': expected a joint, name,x,y,links,R or P,t or f,angle,friction,t or f", line);
    memset(new, 0, sizeof *new);
    new->name = f[0];
    new->links = f[3];
    new->slides = flk_text_same(f[4], "P");
    if (!is_name(f[0]))
        return refuse(m, "'%t': the name of a joint must be a word of letters and digits", f[0]);
    for (i = 0; i < m->n_joints; i++)
        if (is_same(m->joints[i].name, f[0]))
            return refuse(m, "there are two joints '%t'", f[0]);
    if (!is_number(f[1], &new->x) || !is_number(f[2], &new->y))
        return refuse(m, "joint %t: '%t' and '%t' are not its place", f[0], f[1], f[2]);
    if (!has_names_only(f[3]))
        return refuse(m, "joint %t: '%t' are not names of links", f[0], f[3]);
    if (!new->slides && !flk_text_same(f[4], "R"))
        return refuse(m, "joint %t: expected R or P, not '%t'", f[0], f[4]);
    if (!is_flag(f[5], &new->is_fixed) || !is_flag(f[n - 1], &new->is_input))
        return refuse(m, "joint %t: expected t or f for fixed and input, not '%t' and '%t'", f[0],
                      f[5], f[n - 1]);
    if (new->slides && !is_number(f[6], &radians))
        return refuse(m, "joint %t: '%t' is not the direction of its slide, in radians", f[0],
                      f[6]);
    if (n == 9 && !is_number(f[7], &friction))
        return refuse(m, "joint %t: '%t' is not a coefficient of friction", f[0], f[7]);
    m->has_friction |= n == 9 && friction != 0.1 && friction != 0;
    new->direction = f[6];
    new->angle = radians * 180 / M_PI;
    m->n_joints++;
    return 1;
}

/* name, mass, inertia, x, y, joints, ...; in a later release R or P after the name */
static int read_body(import *m, text line)
{
    body *new = &m->bodies[m->n_bodies];
    text f[MOST_FIELDS];
    size_t n = split(line, f), k, i;

    memset(new, 0, sizeof *new);
    k = n > 1 && (flk_text_same(f[1], "R") || flk_text_same(f[1], "P"));
    if (n < 6 + k)
        return refuse(m, "'%t': expected a link, name,mass,inertia,x,y,joints", line);
    new->name = f[0];
    new->joints = f[5 + k];
    for (i = 0; i < m->n_bodies; i++)
        if (is_same(m->bodies[i].name, f[0]))
            return refuse(m, "there are two links '%t'", f[0]);
    if (k && flk_text_same(f[1], "P")) {
        m->n_bodies++;
        return 1;
    }
    if (!is_number(f[1 + k], &new->mass) || !is_number(f[2 + k], &new->inertia) ||
        !is_number(f[3 + k], &new->x) || !is_number(f[4 + k], &new->y) || new->mass < 0 ||
        new->inertia < 0)
        return refuse(
            m, "link %t: '%t', '%t', '%t', '%t' are not its mass, inertia and centre of mass", f[0],
            f[1 + k], f[2 + k], f[3 + k], f[4 + k]);
    new->has_mass = 1;
    m->n_bodies++;
    return 1;
}

/* name, link, tail x and y, tip x and y, fixed, as the arrow, size or its components */
static int read_arrow(import *m, text line)
{
    arrow *new = &m->arrows[m->n_arrows];
    text f[MOST_FIELDS];
    size_t n = split(line, f);
    double size[2] = {0, 0};
    int as_arrow;

    memset(new, 0, sizeof *new);
    if ((n != 9 && n != 10) || !is_name(f[0]) || !is_name(f[1]) || !is_number(f[2], &new->x) ||
        !is_number(f[3], &new->y) || !is_number(f[4], &new->to_x) || !is_number(f[5], &new->to_y) ||
        !is_flag(f[6], &new->is_fixed) || !is_flag(f[7], &as_arrow) || !is_number(f[8], &size[0]) ||
        (n == 10 && !is_number(f[9], &size[1])))
        return refuse(m, "'%t': expected a force, name,link,x,y,x,y,t or f,true or false,size",
                      line);
    new->name = f[0];
    new->link = f[1];
    new->size = (as_arrow ? 1 : -1) * flk_length(size[0], size[1]);
    m->n_arrows++;
    return 1;
}

/* speed, clockwise, gravity, unit */
static int read_settings(import *m, text line)
{
    text f[MOST_FIELDS];
    size_t n = split(line, f), i;

    if (n != 4 || !is_number(f[0], &m->speed) || !is_flag(f[1], &m->is_clockwise) ||
        !is_flag(f[2], &m->has_gravity))
        return refuse(m, "'%t': expected the settings, speed,clockwise,gravity,unit", line);
    for (i = 0; i < sizeof units / sizeof *units && !m->unit; i++)
        if (flk_text_same(f[3], units[i].length))
            m->unit = &units[i];
    m->has_settings = 1;
    return m->unit || refuse(m, "'%t' is not a unit of length that is known", f[3]);
}

/* Read each line of a part of the link. */
static int read_lines(import *m, text part, int read(import *m, text line), const size_t *n)
{
    text line;

    while (flk_text_split(&part, '\n', &line)) {
        line = flk_text_trim(line);
        if (!line.length)
            continue;
        if (n && *n == MOST)
            return refuse(m, "there are more than %ld joints, links or forces", (long)MOST);
        if (!read(m, line))
            return 0;
    }
    return 1;
}

/* The parts of the link, KEY=TEXT, which are decoded in place. */
static int read_parts(import *m, char *words, size_t length)
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
            return refuse(m, "the link has '%t' twice", one);
        size = value.length;
        if (!decode(words + (value.start - words), &size))
            return refuse(m, "after a %% of the link two digits are missing");
        value.length = size;
        part[i] = value;
    }
    m->has_bodies = part[1].length > 0;
    m->has_positions = part[4].length > 0 || part[5].length > 0;
    return read_lines(m, part[0], read_joint, &m->n_joints) &&
           read_lines(m, part[1], read_body, &m->n_bodies) &&
           read_lines(m, part[2], read_arrow, &m->n_arrows) &&
           read_lines(m, part[3], read_settings, NULL) &&
           (m->n_joints || refuse(m, "the link has no joints")) &&
           (m->has_settings || refuse(m, "the link ends before its settings, s=: it is not whole"));
}

/* 1 if links and joints name each other. */
static int check_names(const import *m)
{
    size_t i, k;

    for (i = 0; i < m->n_bodies; i++) {
        const body *b = &m->bodies[i];
        size_t n = b->joints.length ? flk_text_count(b->joints, '|') + 1 : 0;

        for (k = 0; k < m->n_joints; k++) {
            int is_on = has_name(b->joints, m->joints[k].name);

            if (is_on != has_name(m->joints[k].links, b->name))
                return refuse(m, "joint %t and link %t do not name each other", m->joints[k].name,
                              b->name);
            n -= (size_t)is_on;
        }
        if (n)
            return refuse(m, "link %t: '%t' are not all joints of the link", b->name, b->joints);
    }
    return 1;
}

/* ------------------------------------------------------------------------------------- the four links */

/* The next of the names of a list. */
static int next_name(text *list, text *name)
{
    if (!list->length || !flk_text_split(list, '|', name))
        return 0;
    *name = flk_text_trim(*name);
    return 1;
}

/* The number of fixed joints of a link, and one of them. */
static int count_fixed(const import *m, text link, const joint **fixed)
{
    size_t i;
    int n = 0;

    for (i = 0; i < m->n_joints; i++)
        if (m->joints[i].is_fixed && has_name(m->joints[i].links, link)) {
            *fixed = &m->joints[i];
            n++;
        }
    return n;
}

/* Take the crank: the only link of the fixed pin that is the input. */
static int take_crank(import *m)
{
    const joint *A = NULL, *other;
    size_t i;

    for (i = 0; i < m->n_joints; i++)
        if (m->joints[i].is_input && A)
            return refuse(m, "there are two inputs, %t and %t: a deck has one crank", A->name,
                          m->joints[i].name);
        else if (m->joints[i].is_input)
            A = &m->joints[i];
    if (!A)
        return refuse(m, "no joint is the input, which turns the crank");
    if (A->slides || !A->is_fixed)
        return refuse(m, "the input %t is not a fixed pin, on which a crank turns", A->name);
    if (!A->links.length || flk_text_count(A->links, '|'))
        return refuse(m, "the input %t must be the pin of one link, not of '%t'", A->name,
                      A->links);
    if (count_fixed(m, A->links, &other) > 1)
        return refuse(m, "link %t of the input has two fixed joints: it cannot turn", A->links);
    m->pin[PIN_A] = A;
    m->link[2] = A->links;
    return 1;
}

/* Take a link with one fixed joint as link 4, at pin C of the coupler. */
static int take_follower(import *m, const joint *C)
{
    text links = C->links, name;
    const joint *fixed = NULL;

    while (next_name(&links, &name)) {
        if (is_same(name, m->link[3]) || count_fixed(m, name, &fixed) != 1)
            continue;
        m->pin[PIN_C] = C;
        m->link[4] = name;
        *(fixed->slides ? &m->slide : &m->pin[PIN_D]) = fixed;
        return 1;
    }
    return 0;
}

/* Take links 3 and 4, and their pins: a coupler whose own joint slides on the ground, or one with a link that
** turns or slides there. */
static int take_coupler(import *m, const joint *B)
{
    text links = B->links;
    const joint *fixed = NULL;
    size_t i;
    int n;

    while (next_name(&links, &m->link[3])) {
        if (is_same(m->link[3], m->link[2]))
            continue;
        n = count_fixed(m, m->link[3], &fixed);
        if (n == 1 && fixed->slides) {
            m->pin[PIN_C] = m->slide = fixed;
            return 1;
        }
        for (i = 0; i < m->n_joints && !n; i++) {
            const joint *C = &m->joints[i];

            if (!C->slides && !C->is_fixed && has_name(C->links, m->link[3]) &&
                !has_name(C->links, m->link[2]) && take_follower(m, C))
                return 1;
        }
    }
    return 0;
}

static int take_links(import *m)
{
    size_t i;

    if (!take_crank(m))
        return 0;
    for (i = 0; i < m->n_joints; i++) {
        const joint *B = &m->joints[i];

        if (B->is_fixed || B->slides || !has_name(B->links, m->link[2]))
            continue;
        m->pin[PIN_B] = B;
        if (take_coupler(m, B))
            return 1;
    }
    return refuse(m,
                  "no loop of four links has link %t of the input: a deck has the ground, a crank "
                  "and two links that join it to a fixed pin or slide",
                  m->link[2]);
}

/* The number of a link; 0 if it is none of the four. */
static int number_of(const import *m, text link)
{
    int i;

    for (i = 2; i <= 4; i++)
        if (is_same(m->link[i], link))
            return i;
    return 0;
}

static const char *word_of(const import *m, int number)
{
    static const char *const words[2][3] = {{"crank", "coupler", "rocker"},
                                            {"crank", "rod", "piston"}};

    return words[m->slide != NULL][number - 2];
}

static int is_pin(const import *m, const joint *x)
{
    int i;

    for (i = 0; i < PINS; i++)
        if (m->pin[i] == x)
            return 1;
    return m->slide == x;
}

/* ------------------------------------------------------------------------------------------ the deck */

static void put_text(import *m, text t)
{
    if (t.length < DECK_SIZE - m->length)
        memcpy(m->deck + m->length, t.start, t.length);
    m->length += t.length;
}

static void put(import *m, const char *words)
{
    put_text(m, flk_text_of(words));
}

static void put_number(import *m, double value)
{
    char digits[DIGITS_SIZE];

    put(m, value == 0 ? "0" : flk_number_shortest(value, digits));
}

/* KEY = (x, y) cm */
static void put_place(import *m, const char *key, double x, double y)
{
    put(m, key);
    put(m, " = (");
    put_number(m, x);
    put(m, ", ");
    put_number(m, y);
    put(m, ") ");
    put(m, m->unit->length);
    put(m, "\n");
}

static void put_quantity(import *m, const char *key, double value, const char *unit)
{
    put(m, key);
    put(m, " = ");
    put_number(m, value);
    put(m, " ");
    put(m, unit);
    put(m, "\n");
}

/* The direction from a place to another, deg. */
static double direction(double x, double y, double to_x, double to_y)
{
    return atan2(to_y - y, to_x - x) * 180 / M_PI;
}

/* The direction of the slide: a multiple of 15 deg as that, of which the link has three decimals in rad. */
static double put_guide(import *m)
{
    double angle = m->slide->angle, drawn = STEP * floor(angle / STEP + 0.5);

    put(m, "\n[ground]\n");
    if (fabs(angle - drawn) > ROUNDED) {
        put(m, "angle = ");
        put_text(m, m->slide->direction);
        put(m, " rad\n");
        return angle;
    }
    if (angle != drawn)
        note(
            m,
            "joint %t slides in the direction %t rad, with three decimals: it is taken as %.4g deg",
            m->slide->name, m->slide->direction, drawn);
    put_quantity(m, "angle", drawn, "deg");
    return drawn;
}

/* 1 if the drawing does not tell the branch: links 3 and 4, or the rod and the square to the stroke, are in
** line. */
static int is_in_line(const import *m, double along)
{
    const joint *B = m->pin[PIN_B], *C = m->pin[PIN_C], *D = m->pin[PIN_D];
    double across =
        direction(B->x, B->y, C->x, C->y) - (D ? direction(D->x, D->y, C->x, C->y) : along + 90);

    return fabs(sin(across * M_PI / 180)) < IN_LINE;
}

static void put_mechanism(import *m)
{
    static const char *const keys[] = {"A", "B", "C", "D"};
    double along = 0;
    int i;

    put(m, m->slide ? "mechanism = slider-crank\n\n[pins]\n" : "mechanism = four-bar\n\n[pins]\n");
    for (i = 0; i < PINS; i++)
        if (m->pin[i])
            put_place(m, keys[i], m->pin[i]->x, m->pin[i]->y);
    if (m->slide)
        along = put_guide(m);
    put(m, "\n[motion]\n");
    put_quantity(m, "speed", m->is_clockwise ? -m->speed : m->speed, "rpm");
    if (is_in_line(m, along)) {
        put(m, "\n[table]\nbranch = both\n");
        note(m,
             "it is drawn in a dead position, which does not tell the branch: the deck has both");
    }
}

/* 1 if the masses of the links were set: PMKS+ begins with 1 and 1. */
static int has_own_masses(const import *m)
{
    size_t i;

    for (i = 0; i < m->n_bodies; i++)
        if (m->bodies[i].has_mass && number_of(m, m->bodies[i].name) &&
            (m->bodies[i].mass != 1 || m->bodies[i].inertia != 1))
            return 1;
    return 0;
}

static void put_masses(import *m)
{
    size_t i;

    if (!m->has_bodies)
        return;
    if (!m->unit->mass || !has_own_masses(m)) {
        note(m, m->unit->mass
                    ? "the links have the masses and inertias that PMKS+ gives them, 1 and 1: "
                      "they are left out"
                    : "the units of masses and inertias are not known: they are left out");
        return;
    }
    for (i = 0; i < m->n_bodies; i++) {
        const body *b = &m->bodies[i];
        int number = number_of(m, b->name);

        if (!number || !b->has_mass)
            continue;
        put(m, "\n[");
        put(m, word_of(m, number));
        put(m, "]\n");
        put_quantity(m, "mass", b->mass, m->unit->mass);
        put_quantity(m, "inertia", b->inertia, m->unit->inertia);
        put_place(m, "cg_place", b->x, b->y);
    }
    if (!m->has_gravity)
        put(m, "\n[gravity]\nacceleration = 0 m/s2\n");
}

/* The joints of the four links that are no pins. */
static void put_points(import *m)
{
    size_t i;

    for (i = 0; i < m->n_joints; i++) {
        const joint *x = &m->joints[i];
        text links = x->links, name;
        int number = 0;

        while (!number && next_name(&links, &name))
            number = number_of(m, name);
        if (!number || is_pin(m, x))
            continue;
        put(m, "\n[point ");
        put(m, x->name.length == 1 && strchr("ABCD", *x->name.start) ? "joint_" : "");
        put_text(m, x->name);
        put(m, "]\nlink = ");
        put(m, word_of(m, number));
        put(m, "\n");
        put_place(m, "place", x->x, x->y);
    }
}

/* The direction of the x axis of a link as drawn, deg. */
static double axis_of(const import *m, int number)
{
    const joint *from = number == 2   ? m->pin[PIN_A]
                        : number == 3 ? m->pin[PIN_B]
                                      : m->pin[PIN_D],
                *to = number == 2 ? m->pin[PIN_B] : m->pin[PIN_C];

    return direction(from->x, from->y, to->x, to->y);
}

static void put_loads(import *m)
{
    size_t i;

    for (i = 0; i < m->n_arrows; i++) {
        const arrow *a = &m->arrows[i];
        double along = direction(a->x, a->y, a->to_x, a->to_y);
        int number = number_of(m, a->link);

        if (!number || (number == 4 && m->slide) || !m->unit->force ||
            (a->x == a->to_x && a->y == a->to_y)) {
            note(m, "force %t is left out: %s", a->name,
                 !m->unit->force                        ? "its unit is not known"
                 : number && !(number == 4 && m->slide) ? "it has no direction"
                                                        : "its link is none of the four");
            continue;
        }
        if (!a->is_fixed)
            along -= axis_of(m, number);
        put(m, "\n[load ");
        put_text(m, a->name);
        put(m, "]\nlink = ");
        put(m, word_of(m, number));
        put(m, "\n");
        put_place(m, "place", a->x, a->y);
        put(m, "force = ");
        put_number(m, a->size);
        put(m, " ");
        put(m, m->unit->force);
        put(m, " at ");
        put_number(m, along);
        put(m, a->is_fixed ? " deg\n" : " deg\nframe = link\n");
    }
}

/* ---------------------------------------------------------------------------------------- what is told */

/* 1 if joints before this one have the link too. */
static int is_told(const import *m, size_t i, text link)
{
    while (i--)
        if (has_name(m->joints[i].links, link))
            return 1;
    return 0;
}

static void note_joints(const import *m)
{
    static const char *const names[] = {"A", "B", "C", "D"};
    size_t i;

    for (i = 0; i < PINS; i++)
        if (m->pin[i] && !flk_text_same(m->pin[i]->name, names[i]))
            note(m, "joint %t is pin %s of the deck", m->pin[i]->name, names[i]);
    for (i = 0; i < m->n_joints; i++) {
        text links = m->joints[i].links, link;

        while (next_name(&links, &link))
            if (!number_of(m, link) && !is_told(m, i, link))
                note(
                    m,
                    "link %t is left out: a deck has four links, and its joints on them are points",
                    link);
    }
    if (m->has_friction)
        note(m, "coefficients of friction are left out");
    if (m->has_positions)
        note(m, "points of a path and wanted positions are left out");
}

char *import_deck(text t, const char *file, size_t *length)
{
    import *m = memory_get(1, sizeof *m);
    char *deck = NULL, *words = NULL;
    size_t n;
    text link;

    if (!m)
        return NULL;
    m->file = file;
    m->line = 1;
    link = t;
    n = take_link(t, &link, &m->line);
    link = after_address(flk_text_unquoted(link));
    if (n)
        words = memory_get(link.length + 1, 1);
    if (!n)
        refuse(m, "expected a link of PMKS+, with j= before its joints");
    if (words) {
        memcpy(words, link.start, link.length);
        if (read_parts(m, words, link.length) && check_names(m) && take_links(m)) {
            if (n > 1)
                note(m, "the file has %ld links: this one is read", (long)n);
            put_mechanism(m);
            note_joints(m);
            put_masses(m);
            put_points(m);
            put_loads(m);
            if (m->length < DECK_SIZE)
                deck = memory_get(m->length + 1, 1);
            else
                refuse(m, "the deck would be too large");
        }
    }
    if (deck) {
        memcpy(deck, m->deck, m->length);
        *length = m->length;
    }
    free(words);
    free(m);
    return deck;
}
