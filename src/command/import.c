/* SPDX-License-Identifier: GPL-3.0-or-later
**
** import.c - a deck from a link of PMKS+.
**
** Joints of its links that are no pins of the four links are points.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "base/trig.h"
#include "import.h"
#include "import_links.h"
#include "system/memory.h"

#define DECK_SIZE 65536
#define IN_LINE 1e-6 /* sine of an angle */
#define ZERO 1e-12   /* of a drawing: a coordinate that is rounding */

typedef struct import {
    import_links links;
    char deck[DECK_SIZE];
    size_t length;
} import;

/* ------------------------------------------------------------------------------------------ the deck */

static void add_text(import *m, text t)
{
    if (t.length < DECK_SIZE - m->length)
        memcpy(m->deck + m->length, t.start, t.length);
    m->length += t.length;
}

static void add_words(import *m, const char *words)
{
    add_text(m, flk_text_of(words));
}

static void put_number(import *m, double value)
{
    char digits[DIGITS_SIZE];

    add_words(m, value == 0 ? "0" : flk_number_shortest(value, digits));
}

/* KEY = (x, y) cm */
static void put_place(import *m, const char *key, double x, double y)
{
    add_words(m, key);
    add_words(m, " = (");
    put_number(m, x);
    add_words(m, ", ");
    put_number(m, y);
    add_words(m, ") ");
    add_words(m, m->links.from.units->length);
    add_words(m, "\n");
}

static void put_quantity(import *m, const char *key, double value, const char *unit)
{
    add_words(m, key);
    add_words(m, " = ");
    put_number(m, value);
    add_words(m, " ");
    add_words(m, unit);
    add_words(m, "\n");
}

static void put_words(import *m, const char *key, const char *words)
{
    add_words(m, key);
    add_words(m, " = ");
    add_words(m, words);
    add_words(m, "\n");
}

/* The direction of a slide, which is noted if it is not that of the link. */
static void put_direction(import *m, const pmks_joint *slide)
{
    double drawn = import_direction_of_slide(slide);

    if (drawn == slide->angle && drawn != 0) {
        add_words(m, "angle = ");
        add_text(m, slide->direction);
        add_words(m, " rad\n");
        return;
    }
    if (slide->angle != drawn)
        pmks_note(
            &m->links.from,
            "joint %t slides in the direction %t rad, with three decimals: it is taken as %.4g deg",
            slide->name, slide->direction, drawn);
    put_quantity(m, "angle", drawn, "deg");
}

/* -------------------------------------------------------------------------------------- words of links */

/* The prefix of a name that would be that of a pin, of a link of every deck, or of two things. */
static const char *prefix_of(const import *m, text name, int is_link)
{
    static const char *const taken[] = {"A",      "B",      "C",     "D",       "G2",  "G3",
                                        "G4",     "ground", "crank", "coupler", "rod", "slider",
                                        "rocker", "piston", "lever", "yoke"};
    size_t i;

    for (i = 0; i < sizeof taken / sizeof *taken; i++)
        if (flk_text_equal(name, taken[i]))
            return is_link ? "link_" : "joint_";
    for (i = 0; i < m->links.from.n_joints && is_link; i++)
        if (pmks_is_same(m->links.from.joints[i].name, name))
            return "link_";
    return "";
}

static void put_output_name(import *m, const import_output *o)
{
    text name = o->follower.length ? o->follower : o->rod;

    add_words(m, prefix_of(m, name, 1));
    add_text(m, name);
}

static void add_link(import *m, int number)
{
    static const char *const words[2][3] = {{"crank", "coupler", "rocker"},
                                            {"crank", "rod", "piston"}};
    const import_output *o = import_output_of(&m->links, number);

    if (!o) {
        add_words(m, words[m->links.slide != NULL][number - 2]);
        return;
    }
    put_output_name(m, o);
    add_words(m, import_is_rod(number) ? ".rod" : "");
}

static void put_link(import *m, const char *key, int number)
{
    add_words(m, key);
    add_words(m, " = ");
    add_link(m, number);
    add_words(m, "\n");
}

/* ------------------------------------------------------------------------------------- points of links */

/* A place in the axes of its link. */
static void put_on_link(import *m, const char *key, int number, double x, double y)
{
    const pmks_joint *from, *to;
    double axis = import_axis(&m->links, number) * M_PI / 180, size, along, across;

    import_axis_pins(&m->links, number, &from, &to);
    size = flk_length(x, y) + flk_length(from->x, from->y);
    x -= from->x;
    y -= from->y;
    along = flk_cosine(axis) * x + flk_sine(axis) * y;
    across = flk_cosine(axis) * y - flk_sine(axis) * x;
    put_place(m, key, fabs(along) > ZERO * size ? along : 0,
              fabs(across) > ZERO * size ? across : 0);
}

/* A place of a link: on the four as drawn, on others in the axes of the link. */
static void put_point(import *m, const char *place, const char *at, int number, double x, double y)
{
    if (number < IMPORT_FIRST_OUTPUT)
        put_place(m, place, x, y);
    else
        put_on_link(m, at, number, x, y);
}

/* A joint of a link, which may be the end of a rod or rocker. */
static void put_joint(import *m, const char *place, const char *at, int number, const pmks_joint *x)
{
    const pmks_joint *from, *to;

    import_axis_pins(&m->links, number, &from, &to);
    if (number >= IMPORT_FIRST_OUTPUT && from != to && to == x)
        put_words(m, at, "end");
    else
        put_point(m, place, at, number, x->x, x->y);
}

/* ----------------------------------------------------------------------------------------- its sections */

/* 1 if the drawing does not tell the branch: links 3 and 4, or the rod and the square to the stroke, are in
** line. */
static int is_in_line(const import_links *m)
{
    const pmks_joint *B = m->pin[PIN_B], *C = m->pin[PIN_C], *D = m->pin[PIN_D];
    double across =
        import_direction(B->x, B->y, C->x, C->y) -
        (D ? import_direction(D->x, D->y, C->x, C->y) : import_direction_of_slide(m->slide) + 90);

    return fabs(sin(across * M_PI / 180)) < IN_LINE;
}

static void put_mechanism(import *m)
{
    static const char *const keys[] = {"A", "B", "C", "D"};
    const pmks_link *from = &m->links.from;
    int i;

    add_words(m, m->links.slide ? "mechanism = slider-crank\n\n[pins]\n"
                                : "mechanism = four-bar\n\n[pins]\n");
    for (i = 0; i < PINS; i++)
        if (m->links.pin[i])
            put_place(m, keys[i], m->links.pin[i]->x, m->links.pin[i]->y);
    if (m->links.slide) {
        add_words(m, "\n[ground]\n");
        put_direction(m, m->links.slide);
    }
    add_words(m, "\n[motion]\n");
    put_quantity(m, "speed", from->is_clockwise ? -from->speed : from->speed, "rpm");
    if (is_in_line(&m->links)) {
        add_words(m, "\n[table]\nbranch = both\n");
        pmks_note(
            from,
            "it is drawn in a dead position, which does not tell the branch: the deck has both");
    }
}

/* The side of Q: a slider's is ahead of P along its line, a rocker's on the left of the line from P to
** its pin. */
static void put_side(import *m, const import_output *o)
{
    double rod = import_direction(o->P->x, o->P->y, o->Q->x, o->Q->y),
           other = o->end->slides ? import_direction_of_slide(o->end) + 90
                                  : import_direction(o->P->x, o->P->y, o->end->x, o->end->y),
           side = sin((o->end->slides ? other - rod : rod - other) * M_PI / 180);

    if (side < 0)
        put_words(m, "side", o->end->slides ? "behind" : "right");
    if (fabs(side) < IN_LINE)
        pmks_note(&m->links.from,
                  "joint %t is drawn in a dead position, which does not tell on which side it "
                  "goes on",
                  o->Q->name);
}

static double distance(const pmks_joint *from, const pmks_joint *to)
{
    return flk_length(to->x - from->x, to->y - from->y);
}

static void put_output(import *m, const import_output *o)
{
    const char *unit = m->links.from.units->length;

    add_words(m, "\n[output ");
    put_output_name(m, o);
    add_words(m, "]\n");
    put_link(m, "link", o->carrier);
    put_joint(m, "place", "at", o->carrier, o->P);
    put_quantity(m, "rod", distance(o->P, o->Q), unit);
    if (o->end->slides) {
        put_place(m, "line", o->Q->x, o->Q->y);
        put_direction(m, o->end);
    } else if (o->to) {
        put_link(m, "to", o->to);
        put_joint(m, "to_place", "to_at", o->to, o->end);
    } else {
        put_place(m, "pivot", o->end->x, o->end->y);
    }
    if (!o->end->slides)
        put_quantity(m, "length", distance(o->end, o->Q), unit);
    put_side(m, o);
}

/* ---------------------------------------------------------------------------------------------- masses */

/* 1 if the masses of the links were set: PMKS+ begins with 1 and 1. */
static int has_own_masses(const import_links *m)
{
    size_t i;

    for (i = 0; i < m->from.n_bodies; i++)
        if (m->from.bodies[i].has_mass && import_number_of(m, m->from.bodies[i].name) &&
            (m->from.bodies[i].mass != 1 || m->from.bodies[i].inertia != 1))
            return 1;
    return 0;
}

static int are_masses_known(const import *m)
{
    const pmks_link *from = &m->links.from;

    if (!from->n_bodies)
        return 0;
    if (from->units->mass && has_own_masses(&m->links))
        return 1;
    pmks_note(from, from->units->mass
                        ? "the links have the masses and inertias that PMKS+ gives them, 1 and 1: "
                          "they are left out"
                        : "the units of masses and inertias are not known: they are left out");
    return 0;
}

/* The masses of a link, in a section of its own or in that of its output. */
static void put_masses(import *m, int number)
{
    int is_rod = import_is_rod(number);
    const pmks_link *from = &m->links.from;
    size_t i;

    for (i = 0; i < from->n_bodies; i++) {
        const pmks_body *b = &from->bodies[i];

        if (!b->has_mass || import_number_of(&m->links, b->name) != number)
            continue;
        if (number < IMPORT_FIRST_OUTPUT) {
            add_words(m, "\n[");
            add_link(m, number);
            add_words(m, "]\n");
        }
        put_quantity(m, is_rod ? "rod_mass" : "mass", b->mass, from->units->mass);
        if (!import_slides(&m->links, number))
            put_quantity(m, is_rod ? "rod_inertia" : "inertia", b->inertia, from->units->inertia);
        put_point(m, "cg_place", is_rod ? "rod_cg" : "cg", number, b->x, b->y);
    }
}

/* The outputs, and the masses of all links. */
static void put_bodies(import *m)
{
    int has_masses = are_masses_known(m), i;

    for (i = 2; i <= 4 && has_masses; i++)
        put_masses(m, i);
    for (i = 0; i < m->links.n_outputs; i++) {
        put_output(m, &m->links.output[i]);
        if (has_masses) {
            put_masses(m, IMPORT_FIRST_OUTPUT + 2 * i);
            put_masses(m, IMPORT_FIRST_OUTPUT + 2 * i + 1);
        }
    }
    if (has_masses && !m->links.from.has_gravity)
        add_words(m, "\n[gravity]\nacceleration = 0 m/s2\n");
}

/* The joints of links that are no pins of the four. */
static void put_points(import *m)
{
    size_t i;

    for (i = 0; i < m->links.from.n_joints; i++) {
        const pmks_joint *x = &m->links.from.joints[i];
        int number = import_carrier_of(&m->links, x);

        if (!number || import_is_pin(&m->links, x) ||
            (number >= IMPORT_FIRST_OUTPUT && x->is_fixed && !import_is_rod(number)))
            continue;
        add_words(m, "\n[point ");
        add_words(m, prefix_of(m, x->name, 0));
        add_text(m, x->name);
        add_words(m, "]\n");
        put_link(m, "link", number);
        put_joint(m, "place", "at", number, x);
    }
}

static void put_loads(import *m)
{
    const pmks_link *from = &m->links.from;
    size_t i;

    for (i = 0; i < from->n_forces; i++) {
        const pmks_force *a = &from->forces[i];
        double along = import_direction(a->x, a->y, a->to_x, a->to_y);
        int number = import_number_of(&m->links, a->link),
            is_fixed = a->is_fixed || import_slides(&m->links, number);

        if (!number || !from->units->force || (a->x == a->to_x && a->y == a->to_y)) {
            pmks_note(from, "force %t is left out: %s", a->name,
                      !from->units->force ? "its unit is not known"
                      : number            ? "it has no direction"
                                          : "its link is left out, or the ground");
            continue;
        }
        if (!is_fixed)
            along -= import_axis(&m->links, number);
        add_words(m, "\n[load ");
        add_text(m, a->name);
        add_words(m, "]\n");
        put_link(m, "link", number);
        put_point(m, "place", "at", number, a->x, a->y);
        add_words(m, "force = ");
        put_number(m, a->size);
        add_words(m, " ");
        add_words(m, from->units->force);
        add_words(m, " at ");
        put_number(m, along);
        add_words(m, is_fixed ? " deg\n" : " deg\nframe = link\n");
    }
}

/* ---------------------------------------------------------------------------------------- what is told */

/* 1 if joints before this one have the link too. */
static int is_told_of(const pmks_link *from, size_t i, text link)
{
    while (i--)
        if (pmks_has_name(from->joints[i].links, link))
            return 1;
    return 0;
}

static void note_joints(const import_links *m)
{
    static const char *const names[] = {"A", "B", "C", "D"};
    size_t i;

    for (i = 0; i < PINS; i++)
        if (m->pin[i] && !flk_text_same(m->pin[i]->name, names[i]))
            pmks_note(&m->from, "joint %t is pin %s of the deck", m->pin[i]->name, names[i]);
    for (i = 0; i < m->from.n_joints; i++) {
        text links = m->from.joints[i].links, link;

        while (pmks_next_name(&links, &link))
            if (!import_number_of(m, link) && !is_told_of(&m->from, i, link))
                pmks_note(
                    &m->from,
                    "link %t is left out: it is neither one of the four links nor of two that "
                    "hang on them as an output",
                    link);
    }
    if (m->from.has_friction)
        pmks_note(&m->from, "coefficients of friction are left out");
    if (m->from.has_positions)
        pmks_note(&m->from, "points of a path and wanted positions are left out");
}

char *import_deck(text t, const char *file, size_t *length)
{
    import *m = memory_get(1, sizeof *m);
    char *deck = NULL;

    if (!m)
        return NULL;
    m->links.from.file = file;
    if (pmks_read(&m->links.from, t) && import_find_links(&m->links)) {
        put_mechanism(m);
        note_joints(&m->links);
        put_bodies(m);
        put_points(m);
        put_loads(m);
        if (m->length < DECK_SIZE)
            deck = memory_get(m->length + 1, 1);
        else
            pmks_refuse(&m->links.from, "the deck would be too large");
    }
    if (deck) {
        memcpy(deck, m->deck, m->length);
        *length = m->length;
    }
    pmks_free(&m->links.from);
    free(m);
    return deck;
}
