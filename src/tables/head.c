/* SPDX-License-Identifier: GPL-3.0-or-later
**
** head.c - the head of a table: what was computed, in four lines.
*/
#include <string.h>

#include "head.h"

void head_put_title(sheet *s)
{
    if (s->problem.title[0])
        line_put(&s->l, "# %s\n", s->problem.title);
}

void head_put_kind(sheet *s)
{
    line_put(&s->l, "# %s\n", fourlink_kind_text((int)s->problem.mechanism.design.kind));
}

/* The kind and its type, as in "four-bar linkage: crank-rocker".  The name of a type may begin with that of the
** kind, which then comes once. */
static void put_type(sheet *s)
{
    const char *kind = fourlink_kind_text((int)s->problem.mechanism.design.kind), *words;
    fourlink_type type = FOURLINK_TYPE_END_;

    fourlink_type_of(&s->problem.mechanism, &type);
    words = fourlink_type_text((int)type);
    if (strncmp(words, kind, strlen(kind)) == 0)
        line_put(&s->l, "# %s\n", words);
    else
        line_put(&s->l, "# %s: %s\n", kind, words);
}

static double in_unit(double si, const fourlink_unit *u)
{
    return si * u->down / u->up;
}

static const int order[] = {FOURLINK_CRANK, FOURLINK_COUPLER, FOURLINK_FOLLOWER, FOURLINK_GROUND};

static void put_lengths(sheet *s)
{
    const fourlink_design *design = &s->problem.mechanism.design;
    fourlink_unit u = sheet_unit(s, "length"), angle = sheet_unit(s, "angle");
    const char *before = "# ";
    int i;

    for (i = 0; i < 4; i++)
        if (design->link[order[i]].length > 0) {
            line_put(&s->l, "%s%s %9g %s", before, fourlink_link_text((int)design->kind, order[i]),
                     in_unit(design->link[order[i]].length, &u), u.name);
            before = ", ";
        }
    if (design->offset != 0)
        line_put(&s->l, ", offset %9g %s", in_unit(design->offset, &u), u.name);
    if (design->angle != 0)
        line_put(&s->l, ", angle %9g %s", in_unit(design->angle, &angle), angle.name);
    line_put(&s->l, "\n");
}

static void put_speed(sheet *s)
{
    const fourlink_motion *motion = &s->problem.motion;
    fourlink_unit u = sheet_unit(s, "angular_speed");

    if (s->problem.mode == FOURLINK_MODE_FREE)
        line_put(&s->l, "# free motion from %6g %s", in_unit(motion->speed, &u), u.name);
    else if (s->problem.mode != FOURLINK_MODE_GIVEN)
        line_put(&s->l, s->problem.mode == FOURLINK_MODE_STEADY ? "# steady motion"
                                                                : "# run-up from rest");
    else if (motion->run_up > 0)
        line_put(&s->l, "# crank from rest");
    else
        line_put(&s->l, "# crank at %6g %s", in_unit(motion->speed, &u), u.name);
    u = sheet_unit(s, "angular_acceleration");
    if (motion->acceleration != 0)
        line_put(&s->l, ", acceleration %6g %s", in_unit(motion->acceleration, &u), u.name);
}

static void put_masses(sheet *s)
{
    const fourlink_design *design = &s->problem.mechanism.design;
    const char *names[3];
    int n = 0, i;

    for (i = 0; i < 3; i++)
        if (design->link[order[i]].mass > 0)
            names[n++] = fourlink_link_text((int)design->kind, order[i]);
    if (n == 3)
        line_put(&s->l, "; masses of all links");
    else if (n == 2)
        line_put(&s->l, "; masses of %s and %s", names[0], names[1]);
    else if (n == 1)
        line_put(&s->l, "; mass of %s", names[0]);
}

#define NAMES 30 /* bytes that the names of loads may take; else there is only their number */

static void put_loads(sheet *s)
{
    const fourlink_deck *deck = fourlink_results_deck(s->results);
    const fourlink_problem *p = &s->problem;
    fourlink_load_info load;
    unsigned long n = 0, i;
    size_t length = 0;
    const char *name = "";

    while (fourlink_deck_load(deck, n, &load) == FOURLINK_OK && load.sort == FOURLINK_LOAD_OWN) {
        name = load.name;
        length += strlen(name) + 2;
        n++;
    }
    if (n == 1 && strcmp(name, "load") == 0)
        line_put(&s->l, "; a load");
    else if (n > 0 && length > NAMES)
        line_put(&s->l, n > 1 ? "; %lu loads" : "; a load", n);
    else
        for (i = 0; i < n && fourlink_deck_load(deck, i, &load) == FOURLINK_OK; i++)
            line_put(&s->l, "%s %s", i ? "," : n > 1 ? "; loads" : "; load", load.name);
    if (p->n_springs)
        line_put(&s->l, p->n_springs > 1 ? "; %lu springs" : "; a spring", p->n_springs);
    if (p->has_friction)
        line_put(&s->l, "; friction");
    if (p->has_gas)
        line_put(&s->l, "; gas");
}

void head_put_all(sheet *s)
{
    head_put_title(s);
    put_type(s);
    put_lengths(s);
    put_speed(s);
    put_masses(s);
    put_loads(s);
    line_put(&s->l, "\n");
}
