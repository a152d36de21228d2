/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column_point.c - the columns of points: of those that every deck has, of those of [point].
*/
#include <string.h>

#include "base/trig.h"
#include "column.h"
#include "column_list.h"
#include "mechanics/kind.h"

/* The columns of a point. */
#define POINT_COLUMNS(X, P, of)                                  \
    X(P ".x", LENGTH, VALUE, "position of " of ", x")            \
    X(P ".y", LENGTH, VALUE, "position of " of ", y")            \
    X(P ".vx", SPEED, VALUE, "velocity of " of ", x")            \
    X(P ".vy", SPEED, VALUE, "velocity of " of ", y")            \
    X(P ".ax", ACCELERATION, VALUE, "acceleration of " of ", x") \
    X(P ".ay", ACCELERATION, VALUE, "acceleration of " of ", y") \
    X(P ".v", SPEED, SIZE, "speed of " of)                       \
    X(P ".a", ACCELERATION, SIZE, "magnitude of the acceleration of " of)

#define POINT_INFO(name, q, form, meaning) \
    {name, QUANTITY_##q, ALL, 0, 0, NULL, form, 0, 0, meaning, ""},
static const flk_column_info point_table[DECK_POINT_COLUMNS] = {
    POINT_COLUMNS(POINT_INFO, "", "the point")};

/* x and y of position, velocity and acceleration; the sizes of the last two. */
static double value_of_point(const flk_column *c, const flk_row *row)
{
    fourlink_vector u[3];
    int i = c->component;

    fourlink_point(&row->at.state, c->of.point.link, &c->of.point.at, &u[0], &u[1], &u[2]);
    if (c->info->form == SIZE)
        return flk_length(u[i - 5].x, u[i - 5].y);
    flk_column_turn(c->d, &u[i / 2]);
    if (i / 2 == 0) {
        u[0].x += c->d->axes.A.x;
        u[0].y += c->d->axes.A.y;
    }
    return i % 2 == 0 ? u[i / 2].x : u[i / 2].y;
}

static void vector_of_point(const flk_column *c, const flk_row *row, double *x, double *y)
{
    fourlink_vector u[3];

    fourlink_point(&row->at.state, c->of.point.link, &c->of.point.at, &u[0], &u[1], &u[2]);
    *x = u[c->component - 5].x;
    *y = u[c->component - 5].y;
}

/* --------------------------------------------------------------------------------------- of [point] */

static size_t count_points(const deck *d)
{
    return DECK_POINT_COLUMNS * d->n_points;
}

static int make_of_point(const flk_analysis *a, size_t i, flk_column *c)
{
    const deck_point *point = &a->d->points[i / DECK_POINT_COLUMNS];
    int component = (int)(i % DECK_POINT_COLUMNS);

    flk_column_start(a->d, &point_table[component], c);
    c->name = point->column_names[component];
    c->of.point.link = point->link;
    c->of.point.at = point->at;
    c->component = component;
    c->is_usual = component < 2;
    return 1;
}

const flk_column_source flk_point_columns = {
    NULL, 0, count_points, make_of_point, NULL, value_of_point, vector_of_point, NULL, 0};

/* ------------------------------------------------------------------------------- that every deck has */

/* Their names and meanings. */
#define OWN_POINT_LIST(X)                 \
    X(B, "the pin B")                     \
    X(C, "the pin C")                     \
    X(G2, "the centre of mass of link 2") \
    X(G3, "the centre of mass of link 3") \
    X(G4, "the centre of mass of link 4")

#define POINT_CODE(name, meaning) POINT_##name,
typedef enum point_code { OWN_POINT_LIST(POINT_CODE) POINT_COUNT } point_code;

#define POINT_NAME(name, meaning) #name,
static const char *const point_names[] = {OWN_POINT_LIST(POINT_NAME)};

static int is_hidden(const deck *d, point_code code)
{
    size_t i;

    for (i = 0; i < d->n_points; i++)
        if (strcmp(d->points[i].name, point_names[code]) == 0)
            return 1;
    return 0;
}

/* The pin C: the joint of links 3 and 4 or, if these slide on each other, the end of a lever, the origin of a
** yoke. */
static const char *find_C(const deck *d, int *link, fourlink_vector *at)
{
    const fourlink_joint *joint = &flk_kind_of(d->machine.mechanism.design.kind)->joint[2];

    *link = joint->slider ? FOURLINK_FOLLOWER : joint->at;
    if (joint->slider || joint->is_tip)
        at->x = d->machine.mechanism.design.link[*link].length;
    return joint->slider && at->x <= 0 && !joint[1].slider ? "needs a lever with a length" : NULL;
}

/* Returns why a deck does not have this point, or null: then *link is its link and *at its place in the
** link's own axes.  A [point] of the same name hides it. */
static const char *find_own_point(const deck *d, point_code code, int *link, fourlink_vector *at)
{
    at->x = at->y = 0;
    if (is_hidden(d, code))
        return "is hidden by a [point]";
    if (code == POINT_C)
        return find_C(d, link, at);
    *link = FOURLINK_CRANK;
    if (code == POINT_B) {
        at->x = d->machine.mechanism.design.link[*link].length;
        return NULL;
    }
    *link += (int)code - POINT_G2;
    *at = d->machine.mechanism.design.link[*link].cg;
    return d->machine.mechanism.design.link[*link].mass > 0 ? NULL : "needs a mass of that link";
}

/* Their columns. */
#define OWN_POINT(name, of) POINT_COLUMNS(POINT_INFO, #name, of)
static const flk_column_info own_table[] = {OWN_POINT_LIST(OWN_POINT)};

#define OWN_COUNT (sizeof own_table / sizeof own_table[0])

static size_t count_own_points(const deck *d)
{
    (void)d;
    return OWN_COUNT;
}

static int make_of_own_point(const flk_analysis *a, size_t i, flk_column *c)
{
    flk_column_start(a->d, &own_table[i], c);
    c->component = (int)(i % DECK_POINT_COLUMNS);
    return !find_own_point(a->d, (point_code)(i / DECK_POINT_COLUMNS), &c->of.point.link,
                           &c->of.point.at);
}

static const char *why_no_own_point(const deck *d, size_t i, char words[MESSAGE_SIZE])
{
    fourlink_vector at;
    int link;

    (void)words;
    return find_own_point(d, (point_code)(i / DECK_POINT_COLUMNS), &link, &at);
}

int flk_column_same_points(const deck *d, const deck *other)
{
    fourlink_vector at;
    int code, link;

    for (code = 0; code < POINT_COUNT; code++)
        if (!find_own_point(d, (point_code)code, &link, &at) !=
            !find_own_point(other, (point_code)code, &link, &at))
            return 0;
    return 1;
}

const flk_column_source flk_own_point_columns = {own_table,
                                                 OWN_COUNT,
                                                 count_own_points,
                                                 make_of_own_point,
                                                 why_no_own_point,
                                                 value_of_point,
                                                 vector_of_point,
                                                 NULL,
                                                 0};
