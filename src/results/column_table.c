/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column_table.c - the columns of column_list.h and their opposites: values, names, and why a deck lacks one.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "column.h"
#include "column_list.h"
#include "mechanics/kind.h"
#include "mechanics/mechanics.h"

/* `from` is what the macros of column_list.h call so: need, traits, denominator, form, x, y. */
#define COLUMN_INFO(name, q, kinds, from, meaning, source) \
    {#name, QUANTITY_##q, kinds, from, meaning, source},
static const flk_column_info table[] = {COLUMN_LIST(COLUMN_INFO)};

static const flk_column_info opposites[] = {OPPOSITE_LIST(COLUMN_INFO)};

#define TABLE_COUNT (sizeof table / sizeof table[0])
#define OPPOSITE_COUNT (sizeof opposites / sizeof opposites[0])

static int has(const flk_analysis *a, const flk_column_info *info)
{
    return (info->kinds & (int)a->d->machine.mechanism.design.kind) != 0 &&
           (info->need & ~a->possible) == 0 &&
           !(info->kinds & OF_CRANK_DRIVE && a->d->machine.mechanism.drive);
}

static size_t count_table(const deck *d)
{
    (void)d;
    return TABLE_COUNT;
}

static size_t count_opposites(const deck *d)
{
    (void)d;
    return OPPOSITE_COUNT;
}

/* 1 if the value of a column is the first of its numbers in a row. */
static int is_first_number(const flk_column_info *info, const deck_axes *axes)
{
    return info->form <= POLAR_SIZE ||
           (!axes->is_page && (info->form <= POLAR_DIRECTION || info->form >= ON_PAGE));
}

/* 1 for the slide, its speed and acceleration, which are a boom's cylinder. */
static int is_slide(const flk_column_info *info)
{
    return info->kinds & SLOT && strncmp(info->name, "slide", 5) == 0;
}

static int make_of_table(const flk_analysis *a, size_t i, flk_column *c)
{
    int usual = USUAL | (a->possible & NEED_ACTUAL || a->d->program ? USUAL_ACTUAL : 0) |
                (a->d->machine.mechanism.drive ? 0 : USUAL_CRANK);

    flk_column_start(a->d, &table[i], c);
    if (table[i].traits & FOURLINK_CRANK_ANGLE)
        c->scale = 1; /* already in the deck's unit, exactly */
    c->is_number = is_first_number(&table[i], &a->d->axes);
    c->is_usual = (table[i].kinds & usual) != 0 && !(a->d->has_cylinder && is_slide(&table[i]));
    return has(a, &table[i]);
}

static int make_opposite(const flk_analysis *a, size_t i, flk_column *c)
{
    flk_column_start(a->d, &opposites[i], c);
    return has(a, &opposites[i]);
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
    if (info->need & NEED_CYLINDER)
        return "needs gas; the deck has none";
    if (!d->has_forces)
        return "needs masses, loads or gas; the deck has none";
    if (info->need == NEED_GAS)
        return "needs gas; the deck has none";
    if (info->kinds & OF_CRANK_DRIVE && d->machine.mechanism.drive)
        return "needs a crank that drives; see the column drive";
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

static const char *why_lacks(const deck *d, const flk_column_info *info, char words[MESSAGE_SIZE])
{
    char owners[MESSAGE_SIZE];

    if (info->kinds & (int)d->machine.mechanism.design.kind)
        return why_missing(d, info);
    return flk_message(words, MESSAGE_SIZE, "belongs to the %s", list_kinds(info->kinds, owners));
}

static const char *why_table_lacks(const deck *d, size_t i, char words[MESSAGE_SIZE])
{
    return why_lacks(d, &table[i], words);
}

static const char *why_no_opposite(const deck *d, size_t i, char words[MESSAGE_SIZE])
{
    return why_lacks(d, &opposites[i], words);
}

/* ----------------------------------------------------------------------------------------------- values */

/* A zero vector has no direction. */
static double direction_of(double x, double y)
{
    return x == 0 && y == 0 ? FLK_UNDEFINED : flk_angle(y, x);
}

/* The value that follows from its two numbers. */
static double value_of_numbers(const flk_column *c, double x, double y)
{
    const deck_axes *axes = &c->d->axes;

    if (is_first_number(c->info, axes))
        return x;
    switch (c->info->form) {
    case SIZE:
        return flk_length(x, y);
    case PRODUCT:
        return x * y;
    case DIFFERENCE:
        return x - y;
    case DIRECTION:
        return axes->is_page ? flk_deck_direction(c->d, direction_of(x, y)) : direction_of(x, y);
    case POLAR_DIRECTION:
    case ANGLE_OF_LINK:
        return flk_deck_direction(c->d, x);
    case VECTOR_X:
    case PLACE_X:
        return axes->cosine * x - axes->sine * y + (c->info->form == PLACE_X ? axes->A.x : 0);
    default:
        return axes->cosine * x + axes->sine * y + (c->info->form == PLACE_Y ? axes->A.y : 0);
    }
}

static double value_of_table(const flk_column *c, const flk_row *row)
{
    return value_of_numbers(c, FLK_ROW_NUMBER(row, c->info->x), FLK_ROW_NUMBER(row, c->info->y));
}

/* Of the opposite force; taken from 0, so that there is no -0. */
static double value_of_opposite(const flk_column *c, const flk_row *row)
{
    return value_of_numbers(c, 0 - FLK_ROW_NUMBER(row, c->info->x),
                            0 - FLK_ROW_NUMBER(row, c->info->y));
}

static void vector_of_table(const flk_column *c, const flk_row *row, double *x, double *y)
{
    double size, direction;

    *x = FLK_ROW_NUMBER(row, c->info->x);
    *y = FLK_ROW_NUMBER(row, c->info->y);
    if (c->info->form > POLAR_DIRECTION)
        return;
    size = c->info->form == POLAR_SIZE ? *x : *y;
    direction = c->info->form == POLAR_SIZE ? *y : *x;
    *x = size == 0 ? 0 : size * flk_cosine(direction);
    *y = size == 0 ? 0 : size * flk_sine(direction);
}

static void vector_of_opposite(const flk_column *c, const flk_row *row, double *x, double *y)
{
    *x = 0 - FLK_ROW_NUMBER(row, c->info->x);
    *y = 0 - FLK_ROW_NUMBER(row, c->info->y);
}

const flk_column_source flk_table_columns = {table,
                                             TABLE_COUNT,
                                             count_table,
                                             make_of_table,
                                             why_table_lacks,
                                             value_of_table,
                                             vector_of_table,
                                             NULL,
                                             0};

const flk_column_source flk_opposite_columns = {opposites,
                                                OPPOSITE_COUNT,
                                                count_opposites,
                                                make_opposite,
                                                why_no_opposite,
                                                value_of_opposite,
                                                vector_of_opposite,
                                                NULL,
                                                1};

double flk_denominator_13(const fourlink_state *state)
{
    return state->link[3].k;
}

double flk_denominator_24(const fourlink_state *state)
{
    return 1 - state->link[4].k;
}

/* The velocity of link 4. */
double flk_denominator_advantage(const fourlink_state *state)
{
    return state->link[4].k != 0 ? state->link[4].k : state->link[4].k_origin.x;
}

double flk_denominator_klein(const fourlink_state *state)
{
    return state->link[2].axis.x;
}

/* ------------------------------------------------------------------------------------------------ names */

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

    for (i = 0; i < TABLE_COUNT; i++)
        if (flk_text_equal(name, table[i].name))
            return 1;
    for (i = 0; i < OPPOSITE_COUNT; i++)
        if (flk_text_equal(name, opposites[i].name))
            return 1;
    return 0;
}

/* If `a` is null, search the columns of any deck. */
const char *flk_column_nearest(const flk_analysis *a, text name)
{
    const char *known[TABLE_COUNT + OPPOSITE_COUNT + 1], *meant = flk_column_meant(a, name);
    size_t i, n = 0;

    for (i = 0; i < TABLE_COUNT; i++)
        if (!a || has(a, &table[i]))
            known[n++] = table[i].name;
    for (i = 0; i < OPPOSITE_COUNT; i++)
        if (!a || has(a, &opposites[i]))
            known[n++] = opposites[i].name;
    known[n] = NULL;
    return meant ? meant : flk_text_nearest(name, known);
}
