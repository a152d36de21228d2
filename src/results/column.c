/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column.c - the columns of the tables: their names, units and meanings.
*/
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "deck/schema.h"
#include "column.h"
#include "column_list.h"

/* `from` is what the macros of column_list.h call so: need, traits, denominator, form, x, y. */
#define COLUMN_INFO(name, q, kinds, from, meaning, source) \
    {#name, QUANTITY_##q, kinds, from, meaning, source},
static const flk_column_info table[] = {COLUMN_LIST(COLUMN_INFO)};

#define TABLE_COUNT (sizeof table / sizeof table[0])

static int has(const flk_analysis *a, const flk_column_info *info)
{
    return (info->kinds & (int)a->d->machine.mechanism.design.kind) != 0 &&
           (info->need & ~a->possible) == 0;
}

/* The columns of a point. */
#define POINT_COLUMNS(X, P, of)                           \
    X(P ".x", LENGTH, "position of " of ", x")            \
    X(P ".y", LENGTH, "position of " of ", y")            \
    X(P ".vx", SPEED, "velocity of " of ", x")            \
    X(P ".vy", SPEED, "velocity of " of ", y")            \
    X(P ".ax", ACCELERATION, "acceleration of " of ", x") \
    X(P ".ay", ACCELERATION, "acceleration of " of ", y") \
    X(P ".v", SPEED, "speed of " of)                      \
    X(P ".a", ACCELERATION, "magnitude of the acceleration of " of)

#define POINT_INFO(name, q, meaning) \
    {name, QUANTITY_##q, ALL, 0, 0, NULL, VALUE, 0, 0, meaning, ""},
static const flk_column_info point_table[DECK_POINT_COLUMNS] = {
    POINT_COLUMNS(POINT_INFO, "", "the point")};

/* Points that every deck has: names and meanings. */
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

/* The columns of the points that every deck has. */
#define OWN_POINT(name, of) POINT_COLUMNS(POINT_INFO, #name, of)
static const flk_column_info own_table[] = {OWN_POINT_LIST(OWN_POINT)};

#define OWN_COUNT (sizeof own_table / sizeof own_table[0])

/* The columns of springs, and of torsional ones. */
#define SPRING_INFO(q, meaning)                                     \
    {                                                               \
        "", QUANTITY_##q, ALL, 0, 0, NULL, VALUE, 0, 0, meaning, "" \
    }
static const flk_column_info spring_table[2][FLK_ELEMENT_COLUMNS] = {
    {SPRING_INFO(LENGTH, "length of the spring"), SPRING_INFO(FORCE, "tension of the spring"),
     SPRING_INFO(ENERGY, "energy of the spring"),
     SPRING_INFO(POWER, "power that spring and damper put into the links")},
    {SPRING_INFO(ANGLE, "angle of the spring, which counts turns"),
     SPRING_INFO(TORQUE, "torque of the spring, -T on 'link' and T on 'to'"),
     SPRING_INFO(ENERGY, "energy of the spring"),
     SPRING_INFO(POWER, "power that spring and damper put into the links")}};

/* Fill in a column without its number, of the mechanism. */
static void make(const deck *d, const flk_column_info *info, flk_column *c)
{
    const unit *u = &d->units[info->q].unit;

    c->info = info;
    c->name = info->name;
    c->scale = info->traits & FOURLINK_CRANK_ANGLE /* already in the deck's unit, exactly */
                   ? 1
                   : u->down / u->up;
    c->link = 0;
    c->spring = NULL;
    c->is_usual = 0;
}

static int make_of_table(const flk_analysis *a, size_t i, flk_column *c)
{
    int usual = a->possible & NEED_ACTUAL ? USUAL | USUAL_ACTUAL : USUAL;

    make(a->d, &table[i], c);
    c->is_usual = (table[i].kinds & usual) != 0;
    return has(a, &table[i]);
}

/* Column i of the points that every deck has; returns why this deck does not have it, or null. */
static const char *make_of_own_point(const deck *d, size_t i, flk_column *c)
{
    make(d, &own_table[i], c);
    c->component = (int)(i % DECK_POINT_COLUMNS);
    return find_own_point(d, (point_code)(i / DECK_POINT_COLUMNS), &c->link, &c->at);
}

static void make_of_point(const deck *d, size_t i, flk_column *c)
{
    const deck_point *point = &d->points[i / DECK_POINT_COLUMNS];
    int component = (int)(i % DECK_POINT_COLUMNS);

    make(d, &point_table[component], c);
    c->name = point->column_names[component];
    c->link = point->link;
    c->at = point->at;
    c->component = component;
    c->is_usual = component < 2;
}

static void make_of_spring(const deck *d, size_t i, flk_column *c)
{
    const flk_element *e = flk_machine_find(&d->machine, &flk_spring_type, i / FLK_ELEMENT_COLUMNS);
    const fourlink_spring *spring = e->data;
    int component = (int)(i % FLK_ELEMENT_COLUMNS);

    make(d, &spring_table[spring->is_torsional != 0][component], c);
    c->name = e->column_names[component];
    c->mechanism = &d->machine.mechanism;
    c->spring = spring;
    c->component = component;
    c->is_usual = component < 2;
}

size_t flk_column_limit(const deck *d)
{
    return TABLE_COUNT + OWN_COUNT + DECK_POINT_COLUMNS * d->n_points +
           FLK_ELEMENT_COLUMNS * flk_machine_count(&d->machine, &flk_spring_type);
}

/* Possible columns are those of the table, of the points that every deck has, of the deck's own points, of
** its springs: this is the one place that knows their order. */
int flk_column_number(const flk_analysis *a, size_t i, flk_column *c)
{
    size_t n_of_points = DECK_POINT_COLUMNS * a->d->n_points;

    c->number = i;
    if (i < TABLE_COUNT)
        return make_of_table(a, i, c);
    i -= TABLE_COUNT;
    if (i < OWN_COUNT)
        return make_of_own_point(a->d, i, c) == NULL;
    i -= OWN_COUNT;
    if (i < n_of_points)
        make_of_point(a->d, i, c);
    else
        make_of_spring(a->d, i - n_of_points, c);
    return 1;
}

/* Add a column to a list of n, unless it is among the first of them. */
static size_t add_column(flk_column *list, size_t n, size_t first, const flk_column *c)
{
    size_t i;

    for (i = 0; i < first; i++)
        if (list[i].number == c->number)
            return n;
    list[n] = *c;
    return n + 1;
}

static int find_column(const flk_analysis *a, text name, int equal(text, const char *),
                       flk_column *c)
{
    size_t i, n = flk_column_limit(a->d);

    for (i = 0; i < n; i++)
        if (flk_column_number(a, i, c) && equal(name, c->name))
            return 1;
    return 0;
}

int flk_column_find(const flk_analysis *a, text name, flk_column *c)
{
    return find_column(a, name, flk_text_same, c);
}

/* What people call columns, and the names; the digits that follow are the same in both. */
static const struct {
    const char *written, *meant;
} aliases[] = {{"w", "omega"},        {"a", "alpha"},
               {"t", "time"},         {"force", "F"},
               {"torque", "Ts"},      {"driving_torque", "Ts"},
               {"displacement", "x"}, {"velocity", "v"},
               {"acceleration", "a"}, {"transmission_angle", "mu"}};

static int is_digits(const char *s)
{
    return s[strspn(s, "0123456789")] == '\0';
}

const char *flk_column_meant(const flk_analysis *a, text name)
{
    char word[DECK_NAME_SIZE];
    size_t i, k;

    flk_text_copy(name, word, sizeof word);
    for (i = 0; i < sizeof aliases / sizeof aliases[0]; i++) {
        size_t n = strlen(aliases[i].written), m = strlen(aliases[i].meant);
        text front = name;

        front.length = n < name.length ? n : name.length;
        if (!flk_text_equal(front, aliases[i].written) || !is_digits(word + n))
            continue;
        for (k = 0; k < TABLE_COUNT; k++)
            if ((!a || has(a, &table[k])) && strncmp(table[k].name, aliases[i].meant, m) == 0 &&
                strcmp(table[k].name + m, word + n) == 0)
                return table[k].name;
    }
    return NULL;
}

int flk_column_is_known(text name)
{
    size_t i;

    for (i = 0; i < TABLE_COUNT && !flk_text_same(name, table[i].name); i++)
        ;
    return i < TABLE_COUNT;
}

/* If `a` is null, search the columns of any deck. */
const char *flk_column_nearest(const flk_analysis *a, text name)
{
    const char *known[TABLE_COUNT + 1], *meant = flk_column_meant(a, name);
    size_t i, n = 0;

    for (i = 0; i < TABLE_COUNT; i++)
        if (!a || has(a, &table[i]))
            known[n++] = table[i].name;
    known[n] = NULL;
    return meant ? meant : flk_text_nearest(name, known);
}

static size_t add_all(const flk_analysis *a, int usual_only, flk_column *list, size_t n)
{
    size_t i, limit = flk_column_limit(a->d), first = n;
    flk_column c;

    for (i = 0; i < limit; i++)
        if (flk_column_number(a, i, &c) && (!usual_only || c.is_usual))
            n = add_column(list, n, first, &c);
    return n;
}

static const char *why_missing(const deck *d, const flk_column_info *info)
{
    if (info->need & NEED_TIME)
        return "needs a moving crank";
    if (info->need & NEED_SERIES)
        return "needs a line of stroke through the crankshaft; the deck has an offset";
    if ((info->need & (NEED_LOSSES | NEED_RUBBING)) && !d->machine.has_friction)
        return "needs a [friction] section; the deck has none";
    if (info->need & NEED_ACTUAL)
        return "needs [motion] mode = free, run-up or steady; the motion is given";
    if (info->need & NEED_WANTED)
        return "needs --synthesis and a [synthesis] with a function";
    if (info->need & NEED_BALANCE)
        return "needs a [balance] section; the deck has none";
    if (!d->has_forces)
        return "needs masses, loads or gas; the deck has none";
    if (info->need == NEED_GAS)
        return "needs gas; the deck has none";
    return "needs a rod whose centre of mass is on its line";
}

/* The kinds of a set in words. */
static const char *list_kinds(int kinds, char out[MESSAGE_SIZE])
{
    const char *words[9] = {NULL};
    size_t n = 0;
    int kind;

    for (kind = 1; kind < FLK_EVERY_KIND; kind *= 2)
        if ((kinds & kind) && flk_kind_of((fourlink_kind)kind))
            words[n++] = fourlink_kind_text(kind);
    flk_text_list(words, ", the ", " and the ", out, MESSAGE_SIZE);
    return out;
}

static void note_missing(const flk_analysis *a, const deck *d, text name, mistakes *m)
{
    const char *nearest;
    flk_column c;
    size_t i;

    for (i = 0; i < OWN_COUNT; i++)
        if (flk_text_same(name, own_table[i].name)) {
            flk_mistake(m, d->columns.place, "the column '%t' %s", name,
                        make_of_own_point(d, i, &c));
            return;
        }

    for (i = 0; i < TABLE_COUNT; i++)
        if (flk_text_same(name, table[i].name)) {
            char owners[MESSAGE_SIZE];

            if (table[i].kinds & (int)d->machine.mechanism.design.kind)
                flk_mistake(m, d->columns.place, "the column '%t' %s", name,
                            why_missing(d, &table[i]));
            else
                flk_mistake(m, d->columns.place, "the column '%t' belongs to the %s", name,
                            list_kinds(table[i].kinds, owners));
            return;
        }
    nearest = flk_column_nearest(a, name);
    flk_mistake(m, d->columns.place, "unknown column '%t'%h%s", name, nearest,
                nearest ? "" : "; see --list");
}

/* The length of a comma or blank at the front of a text; 0 if there is none. */
static size_t separator(text t)
{
    return t.length && t.start[0] == ',' ? 1 : flk_text_blank(t);
}

/* 1 for the front of a name that goes on behind a blank, `load P` of load P.torque: a section that repeats,
** without a key. */
static int goes_on(text front)
{
    text section = front, name;
    section_code code;

    flk_text_cut(front, " ", &section, &name);
    code = flk_find_section(section);
    return code != SECTION_COUNT && flk_section_table[code].repeats && !flk_text_count(front, '.');
}

int flk_column_next_name(text *rest, text *name)
{
    text front;

    while (separator(*rest))
        *rest = flk_text_from(*rest, separator(*rest));
    *name = *rest;
    do {
        while (rest->length && flk_text_blank(*rest))
            *rest = flk_text_from(*rest, flk_text_blank(*rest));
        while (rest->length && !separator(*rest))
            *rest = flk_text_from(*rest, 1);
        front = *name;
        front.length -= rest->length;
    } while (rest->length && rest->start[0] != ',' && goes_on(front));
    *name = front;
    return name->length > 0;
}

static const char *const statistics[] = {"", "max(", "min(", "mean(", "rms("};

flk_statistic flk_column_statistic_of(text name, text *of)
{
    int i;

    if (!name.length || name.start[name.length - 1] != ')')
        return FLK_NONE;
    for (i = FLK_MAX; i <= FLK_RMS; i++) {
        size_t length = strlen(statistics[i]);

        if (name.length > length + 1 && memcmp(name.start, statistics[i], length) == 0) {
            of->start = name.start + length;
            of->length = name.length - length - 1;
            *of = flk_text_trim(*of);
            return (flk_statistic)i;
        }
    }
    return FLK_NONE;
}

char *flk_column_statistic_text(flk_statistic statistic, const char *column, char *name)
{
    return flk_text_join(name, DECK_NAME_SIZE, statistics[statistic], column, ")", (char *)NULL);
}

char *flk_column_statistic_name(flk_statistic statistic, const flk_column *c, char *names)
{
    size_t place = FLK_STATISTICS * c->number + (size_t)(statistic - FLK_MAX);

    return flk_column_statistic_text(statistic, c->name, names + DECK_NAME_SIZE * place);
}

/* Handles start at 1: a column, then its statistics. */
#define HANDLES (1 + FLK_STATISTICS)

int flk_column_handle(const flk_column *c, flk_statistic statistic)
{
    return 1 + HANDLES * (int)c->number + (int)statistic;
}

int flk_column_of_handle(const flk_analysis *a, int handle, flk_column *c, flk_statistic *statistic)
{
    size_t place = handle > 0 ? (size_t)handle - 1 : (size_t)-1;

    *statistic = (flk_statistic)(place % HANDLES);
    return place / HANDLES < flk_column_limit(a->d) && flk_column_number(a, place / HANDLES, c);
}

static int is_known(text name)
{
    size_t i;

    for (i = 0; i < TABLE_COUNT; i++)
        if (flk_text_equal(name, table[i].name))
            return 1;
    return flk_text_equal(name, "all") || memchr(name.start, '.', name.length) != NULL ||
           flk_column_statistic_of(name, &name);
}

void flk_column_check(deck *d, int is_value(text name))
{
    text rest = d->columns.names, name;

    while (rest.start && flk_column_next_name(&rest, &name))
        if (!is_known(name) && !is_value(name))
            note_missing(NULL, d, name, &d->mistakes);
}

size_t flk_column_choose(const flk_analysis *a, mistakes *m, flk_column *list)
{
    text rest = a->d->columns.names, name;
    size_t n = 0;
    flk_column c;

    if (!rest.start)
        return add_all(a, 1, list, 0);
    while (flk_column_next_name(&rest, &name)) {
        if (flk_text_equal(name, "all"))
            n = add_all(a, 0, list, n);
        else if (find_column(a, name, flk_text_same, &c) ||
                 find_column(a, name, flk_text_equal, &c))
            n = add_column(list, n, n, &c);
        else
            note_missing(a, a->d, name, m);
    }
    if (!n && !m->count)
        flk_mistake(m, a->d->columns.place, "no columns");
    return n;
}

/* 1 if two designs of a deck have the same columns. */
static int have_same(const flk_analysis *a, const flk_analysis *b)
{
    size_t i;
    flk_column c;

    for (i = 0; i < OWN_COUNT; i += DECK_POINT_COLUMNS)
        if (!make_of_own_point(a->d, i, &c) != !make_of_own_point(b->d, i, &c))
            return 0;
    return a->possible == b->possible &&
           a->d->machine.mechanism.design.kind == b->d->machine.mechanism.design.kind;
}

size_t flk_column_copy(const flk_analysis *a, const flk_analysis *of, const flk_column *from,
                       size_t n, flk_column *list)
{
    size_t i;

    if (!have_same(a, of))
        return 0;
    for (i = 0; i < n; i++)
        flk_column_number(a, from[i].number, &list[i]);
    return n;
}

quantity flk_column_quantity(const flk_column *c)
{
    return c->info->q;
}

const char *flk_column_meaning(const flk_column *c)
{
    return c->info->meaning;
}

const char *flk_column_source_name(const flk_column *c)
{
    return c->info->source_name;
}
