/* SPDX-License-Identifier: GPL-3.0-or-later
**
** import.c - a deck from a link of PMKS+.
**
** The four links are the ground, the one with the input, and two that close a loop with it; the joints of other links on
** them are points.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "import.h"
#include "pmks.h"
#include "system/memory.h"

#define DECK_SIZE 65536
#define IN_LINE 1e-6 /* sine of an angle */
#define STEP 15.0    /* deg, of the directions that are drawn */
#define ROUNDED 0.03 /* deg, by which a direction in rad with three decimals can be beside one */

enum { PIN_A, PIN_B, PIN_C, PIN_D, PINS };

typedef struct import {
    pmks_link from;
    const pmks_joint *pin[PINS]; /* D is null of a slider-crank */
    const pmks_joint *slide;     /* null of a four-bar */
    text link[5];                /* by number, from 2 on; empty: what slides has none */
    char deck[DECK_SIZE];
    size_t length;
} import;

/* ------------------------------------------------------------------------------------- the four links */

/* The number of fixed joints of a link, and one of them. */
static int count_fixed(const import *m, text link, const pmks_joint **fixed)
{
    size_t i;
    int n = 0;

    for (i = 0; i < m->from.n_joints; i++)
        if (m->from.joints[i].is_fixed && pmks_has_name(m->from.joints[i].links, link)) {
            *fixed = &m->from.joints[i];
            n++;
        }
    return n;
}

/* Take the crank: the only link of the fixed pin that is the input. */
static int take_crank(import *m)
{
    const pmks_joint *A = NULL, *other;
    size_t i;

    for (i = 0; i < m->from.n_joints; i++)
        if (m->from.joints[i].is_input && A)
            return pmks_refuse(&m->from, "there are two inputs, %t and %t: a deck has one crank",
                               A->name, m->from.joints[i].name);
        else if (m->from.joints[i].is_input)
            A = &m->from.joints[i];
    if (!A)
        return pmks_refuse(&m->from, "no joint is the input, which turns the crank");
    if (A->slides || !A->is_fixed)
        return pmks_refuse(&m->from, "the input %t is not a fixed pin, on which a crank turns",
                           A->name);
    if (!A->links.length || flk_text_count(A->links, '|'))
        return pmks_refuse(&m->from, "the input %t must be the pin of one link, not of '%t'",
                           A->name, A->links);
    if (count_fixed(m, A->links, &other) > 1)
        return pmks_refuse(&m->from, "link %t of the input has two fixed joints: it cannot turn",
                           A->links);
    m->pin[PIN_A] = A;
    m->link[2] = A->links;
    return 1;
}

/* Take a link with one fixed joint as link 4, at pin C of the coupler. */
static int take_follower(import *m, const pmks_joint *C)
{
    text links = C->links, name;
    const pmks_joint *fixed = NULL;

    while (pmks_next_name(&links, &name)) {
        if (pmks_is_same(name, m->link[3]) || count_fixed(m, name, &fixed) != 1)
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
static int take_coupler(import *m, const pmks_joint *B)
{
    text links = B->links;
    const pmks_joint *fixed = NULL;
    size_t i;
    int n;

    while (pmks_next_name(&links, &m->link[3])) {
        if (pmks_is_same(m->link[3], m->link[2]))
            continue;
        n = count_fixed(m, m->link[3], &fixed);
        if (n == 1 && fixed->slides) {
            m->pin[PIN_C] = m->slide = fixed;
            return 1;
        }
        for (i = 0; i < m->from.n_joints && !n; i++) {
            const pmks_joint *C = &m->from.joints[i];

            if (!C->slides && !C->is_fixed && pmks_has_name(C->links, m->link[3]) &&
                !pmks_has_name(C->links, m->link[2]) && take_follower(m, C))
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
    for (i = 0; i < m->from.n_joints; i++) {
        const pmks_joint *B = &m->from.joints[i];

        if (B->is_fixed || B->slides || !pmks_has_name(B->links, m->link[2]))
            continue;
        m->pin[PIN_B] = B;
        if (take_coupler(m, B))
            return 1;
    }
    return pmks_refuse(
        &m->from,
        "no loop of four links has link %t of the input: a deck has the ground, a crank "
        "and two links that join it to a fixed pin or slide",
        m->link[2]);
}

/* The number of a link; 0 if it is none of the four. */
static int number_of(const import *m, text link)
{
    int i;

    for (i = 2; i <= 4; i++)
        if (pmks_is_same(m->link[i], link))
            return i;
    return 0;
}

static const char *word_of(const import *m, int number)
{
    static const char *const words[2][3] = {{"crank", "coupler", "rocker"},
                                            {"crank", "rod", "piston"}};

    return words[m->slide != NULL][number - 2];
}

/* 1 for a piston, which does not turn. */
static int is_piston(const import *m, int number)
{
    return number == 4 && m->slide;
}

static int is_pin(const import *m, const pmks_joint *x)
{
    int i;

    for (i = 0; i < PINS; i++)
        if (m->pin[i] == x)
            return 1;
    return m->slide == x;
}

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
    add_words(m, m->from.units->length);
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

/* The direction from a place to another, deg. */
static double direction(double x, double y, double to_x, double to_y)
{
    return atan2(to_y - y, to_x - x) * 180 / M_PI;
}

/* The direction of the slide: a multiple of 15 deg as that, of which the link has three decimals in rad. */
static double put_guide(import *m)
{
    double angle = m->slide->angle, drawn = STEP * floor(angle / STEP + 0.5);

    add_words(m, "\n[ground]\n");
    if (fabs(angle - drawn) > ROUNDED) {
        add_words(m, "angle = ");
        add_text(m, m->slide->direction);
        add_words(m, " rad\n");
        return angle;
    }
    if (angle != drawn)
        pmks_note(
            &m->from,
            "joint %t slides in the direction %t rad, with three decimals: it is taken as %.4g deg",
            m->slide->name, m->slide->direction, drawn);
    put_quantity(m, "angle", drawn, "deg");
    return drawn;
}

/* 1 if the drawing does not tell the branch: links 3 and 4, or the rod and the square to the stroke, are in
** line. */
static int is_in_line(const import *m, double along)
{
    const pmks_joint *B = m->pin[PIN_B], *C = m->pin[PIN_C], *D = m->pin[PIN_D];
    double across =
        direction(B->x, B->y, C->x, C->y) - (D ? direction(D->x, D->y, C->x, C->y) : along + 90);

    return fabs(sin(across * M_PI / 180)) < IN_LINE;
}

static void put_mechanism(import *m)
{
    static const char *const keys[] = {"A", "B", "C", "D"};
    double along = 0;
    int i;

    add_words(m, m->slide ? "mechanism = slider-crank\n\n[pins]\n"
                          : "mechanism = four-bar\n\n[pins]\n");
    for (i = 0; i < PINS; i++)
        if (m->pin[i])
            put_place(m, keys[i], m->pin[i]->x, m->pin[i]->y);
    if (m->slide)
        along = put_guide(m);
    add_words(m, "\n[motion]\n");
    put_quantity(m, "speed", m->from.is_clockwise ? -m->from.speed : m->from.speed, "rpm");
    if (is_in_line(m, along)) {
        add_words(m, "\n[table]\nbranch = both\n");
        pmks_note(
            &m->from,
            "it is drawn in a dead position, which does not tell the branch: the deck has both");
    }
}

/* 1 if the masses of the links were set: PMKS+ begins with 1 and 1. */
static int has_own_masses(const import *m)
{
    size_t i;

    for (i = 0; i < m->from.n_bodies; i++)
        if (m->from.bodies[i].has_mass && number_of(m, m->from.bodies[i].name) &&
            (m->from.bodies[i].mass != 1 || m->from.bodies[i].inertia != 1))
            return 1;
    return 0;
}

static void put_masses(import *m)
{
    size_t i;

    if (!m->from.n_bodies)
        return;
    if (!m->from.units->mass || !has_own_masses(m)) {
        pmks_note(&m->from,
                  m->from.units->mass
                      ? "the links have the masses and inertias that PMKS+ gives them, 1 and 1: "
                        "they are left out"
                      : "the units of masses and inertias are not known: they are left out");
        return;
    }
    for (i = 0; i < m->from.n_bodies; i++) {
        const pmks_body *b = &m->from.bodies[i];
        int number = number_of(m, b->name);

        if (!number || !b->has_mass)
            continue;
        add_words(m, "\n[");
        add_words(m, word_of(m, number));
        add_words(m, "]\n");
        put_quantity(m, "mass", b->mass, m->from.units->mass);
        if (!is_piston(m, number))
            put_quantity(m, "inertia", b->inertia, m->from.units->inertia);
        put_place(m, "cg_place", b->x, b->y);
    }
    if (!m->from.has_gravity)
        add_words(m, "\n[gravity]\nacceleration = 0 m/s2\n");
}

/* The joints of the four links that are no pins. */
static void put_points(import *m)
{
    size_t i;

    for (i = 0; i < m->from.n_joints; i++) {
        const pmks_joint *x = &m->from.joints[i];
        text links = x->links, name;
        int number = 0;

        while (!number && pmks_next_name(&links, &name))
            number = number_of(m, name);
        if (!number || is_pin(m, x))
            continue;
        add_words(m, "\n[point ");
        add_words(m, x->name.length == 1 && strchr("ABCD", *x->name.start) ? "joint_" : "");
        add_text(m, x->name);
        add_words(m, "]\nlink = ");
        add_words(m, word_of(m, number));
        add_words(m, "\n");
        put_place(m, "place", x->x, x->y);
    }
}

/* The direction of the x axis of a link as drawn, deg. */
static double axis_of(const import *m, int number)
{
    const pmks_joint *from = number == 2   ? m->pin[PIN_A]
                             : number == 3 ? m->pin[PIN_B]
                                           : m->pin[PIN_D],
                     *to = number == 2 ? m->pin[PIN_B] : m->pin[PIN_C];

    return direction(from->x, from->y, to->x, to->y);
}

static void put_loads(import *m)
{
    size_t i;

    for (i = 0; i < m->from.n_forces; i++) {
        const pmks_force *a = &m->from.forces[i];
        double along = direction(a->x, a->y, a->to_x, a->to_y);
        int number = number_of(m, a->link), is_fixed = a->is_fixed || is_piston(m, number);

        if (!number || !m->from.units->force || (a->x == a->to_x && a->y == a->to_y)) {
            pmks_note(&m->from, "force %t is left out: %s", a->name,
                      !m->from.units->force ? "its unit is not known"
                      : number              ? "it has no direction"
                                            : "its link is none of the four");
            continue;
        }
        if (!is_fixed)
            along -= axis_of(m, number);
        add_words(m, "\n[load ");
        add_text(m, a->name);
        add_words(m, "]\nlink = ");
        add_words(m, word_of(m, number));
        add_words(m, "\n");
        put_place(m, "place", a->x, a->y);
        add_words(m, "force = ");
        put_number(m, a->size);
        add_words(m, " ");
        add_words(m, m->from.units->force);
        add_words(m, " at ");
        put_number(m, along);
        add_words(m, is_fixed ? " deg\n" : " deg\nframe = link\n");
    }
}

/* ---------------------------------------------------------------------------------------- what is told */

/* 1 if joints before this one have the link too. */
static int is_told_of(const import *m, size_t i, text link)
{
    while (i--)
        if (pmks_has_name(m->from.joints[i].links, link))
            return 1;
    return 0;
}

static void note_joints(const import *m)
{
    static const char *const names[] = {"A", "B", "C", "D"};
    size_t i;

    for (i = 0; i < PINS; i++)
        if (m->pin[i] && !flk_text_same(m->pin[i]->name, names[i]))
            pmks_note(&m->from, "joint %t is pin %s of the deck", m->pin[i]->name, names[i]);
    for (i = 0; i < m->from.n_joints; i++) {
        text links = m->from.joints[i].links, link;

        while (pmks_next_name(&links, &link))
            if (!number_of(m, link) && !is_told_of(m, i, link))
                pmks_note(
                    &m->from,
                    "link %t is left out: a deck has four links, and its joints on them are points",
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
    m->from.file = file;
    if (pmks_read(&m->from, t) && take_links(m)) {
        put_mechanism(m);
        note_joints(m);
        put_masses(m);
        put_points(m);
        put_loads(m);
        if (m->length < DECK_SIZE)
            deck = memory_get(m->length + 1, 1);
        else
            pmks_refuse(&m->from, "the deck would be too large");
    }
    if (deck) {
        memcpy(deck, m->deck, m->length);
        *length = m->length;
    }
    pmks_free(&m->from);
    free(m);
    return deck;
}
