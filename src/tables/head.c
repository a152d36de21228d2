/* SPDX-License-Identifier: GPL-3.0-or-later
**
** head.c - the head of a table: what was computed, in four lines.
*/
#include <string.h>

#include "sheet.h"
#include "head.h"

void head_put_title(sheet *s)
{
    if (s->v.problem.title[0])
        line_put(&s->l, "# %s\n", s->v.problem.title);
}

/* Whether axes are those of the page or of link 1, and how these lie there. */
static void put_axes(sheet *s)
{
    const fourlink_problem *p = &s->v.problem;

    if (p->axes_on_page || p->has_drawn)
        line_put(&s->l, "# axes of %s at %9g %s%s\n",
                 p->axes_on_page ? "the page, with x of link 1" : "link 1, with x",
                 view_value(&s->v, QUANTITY_ANGLE, p->axes_on_page ? p->x_angle : p->drawn_x),
                 s->v.units[QUANTITY_ANGLE].name, p->axes_on_page ? "" : " on the page");
}

void head_put_kind(sheet *s)
{
    line_put(&s->l, "# %s\n", s->v.kind.words);
    put_axes(s);
}

/* The kind and its type, as in "four-bar linkage: crank-rocker".  The name of a type may begin with that
** of the kind, which then comes once. */
static void put_type(sheet *s)
{
    const char *kind = s->v.kind.words, *words;
    fourlink_type type = FOURLINK_TYPE_END_;

    fourlink_type_of(s->v.mechanism, &type);
    words = fourlink_type_text((int)type);
    if (strncmp(words, kind, strlen(kind)) == 0)
        line_put(&s->l, "# %s", words);
    else
        line_put(&s->l, "# %s: %s", kind, words);
    line_put(&s->l, "\n");
}

/* Put a value and its unit: the format has %9g %s, or fewer digits. */
static void put_value(sheet *s, const char *format, double si, quantity q)
{
    line_put(&s->l, format, view_value(&s->v, q, si), s->v.units[q].name);
}

static const int order[] = {FOURLINK_CRANK, FOURLINK_COUPLER, FOURLINK_FOLLOWER, FOURLINK_GROUND};

static void put_lengths(sheet *s)
{
    const fourlink_design *design = s->v.design;
    int i, n = 0;

    for (i = 0; i < 4; i++)
        if (design->link[order[i]].length > 0) {
            line_put(&s->l, "%s%s", n++ ? ", " : "# ", s->v.kind.link[order[i]]);
            put_value(s, " %9g %s", design->link[order[i]].length, QUANTITY_LENGTH);
        }
    if (design->offset != 0)
        put_value(s, ", offset %9g %s", design->offset, QUANTITY_LENGTH);
    if (design->angle != 0)
        put_value(s, ", angle %9g %s", design->angle, QUANTITY_ANGLE);
    line_put(&s->l, "\n");
}

/* The motion of a prescribed coordinate. */
static void put_prescribed(sheet *s)
{
    const fourlink_motion *motion = &s->v.problem.prescribed;
    quantity q = s->v.over;

    line_put(&s->l, "# %s", s->v.problem.over.words);
    put_value(s, " at %6g %s", motion->speed,
              q == QUANTITY_ANGLE ? QUANTITY_ANGULAR_SPEED : QUANTITY_SPEED);
    if (motion->acceleration != 0)
        put_value(s, ", acceleration %6g %s", motion->acceleration,
                  q == QUANTITY_ANGLE ? QUANTITY_ANGULAR_ACCELERATION : QUANTITY_ACCELERATION);
}

static void put_speed(sheet *s)
{
    const fourlink_motion *motion = &s->v.problem.motion;
    const char *input = view_input(&s->v);
    int mode = s->v.problem.mode;

    if (mode == FOURLINK_MODE_FREE)
        put_value(s, "# free motion from %6g %s", motion->speed, QUANTITY_ANGULAR_SPEED);
    else if (mode != FOURLINK_MODE_GIVEN)
        line_put(&s->l, mode == FOURLINK_MODE_STEADY ? "# steady motion" : "# run-up from rest");
    else if (!s->v.problem.over.is_crank_angle)
        line_put(&s->l, "# %s by a program", input ? input : "crank");
    else if (motion->run_up > 0)
        line_put(&s->l, "# crank from rest");
    else
        put_value(s, "# crank at %6g %s", motion->speed, QUANTITY_ANGULAR_SPEED);
    if (motion->acceleration != 0)
        put_value(s, ", acceleration %6g %s", motion->acceleration, QUANTITY_ANGULAR_ACCELERATION);
}

static void put_masses(sheet *s)
{
    const char *names[3];
    int n = 0, i;

    for (i = 0; i < 3; i++)
        if (s->v.design->link[order[i]].mass > 0)
            names[n++] = s->v.kind.link[order[i]];
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
    const fourlink_problem *p = &s->v.problem;
    fourlink_load_info load;
    unsigned long n = 0, i;
    size_t length = 0;
    const char *name = "";

    while (fourlink_deck_load(s->v.deck, n, &load) == FOURLINK_OK &&
           load.sort == FOURLINK_LOAD_OWN) {
        name = load.name;
        length += strlen(name) + 2;
        n++;
    }
    if (n == 1 && strcmp(name, "load") == 0)
        line_put(&s->l, "; a load");
    else if (n > 0 && length > NAMES)
        line_put(&s->l, n > 1 ? "; %lu loads" : "; a load", n);
    else
        for (i = 0; i < n && fourlink_deck_load(s->v.deck, i, &load) == FOURLINK_OK; i++)
            line_put(&s->l, "%s %s", i ? "," : n > 1 ? "; loads" : "; load", load.name);
    if (p->n_springs)
        line_put(&s->l, p->n_springs > 1 ? "; %lu springs" : "; a spring", p->n_springs);
    if (p->has_friction)
        line_put(&s->l, "; friction");
    if (p->has_gas)
        line_put(&s->l, "; gas");
}

void head_put_properties(sheet *s)
{
    head_put_title(s);
    put_type(s);
    put_lengths(s);
    if (s->v.problem.is_prescribed)
        put_prescribed(s);
    else
        put_speed(s);
    put_masses(s);
    put_loads(s);
    line_put(&s->l, "\n");
    put_axes(s);
}
