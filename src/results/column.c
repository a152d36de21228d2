/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column.c - the columns of the tables: which a deck has, which it asks for, and their values.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "deck/at_angle.h"
#include "deck/schema.h"
#include "column.h"
#include "column_list.h"

/* The one place that knows their order: that of possible columns. */
static const flk_column_source *const sources[] = {
    &flk_table_columns, &flk_own_point_columns, &flk_point_columns,   &flk_spring_columns,
    &flk_drive_columns, &flk_output_columns,    &flk_opposite_columns};

#define SOURCES (sizeof sources / sizeof sources[0])

void flk_column_start(const deck *d, const flk_column_info *info, flk_column *c)
{
    const unit *u = &d->units[info->q].unit;

    c->d = d;
    c->info = info;
    c->name = info->name;
    c->scale = u->down / u->up;
    c->is_usual = c->is_number = 0;
}

size_t flk_column_limit(const deck *d)
{
    size_t k, n = 0;

    for (k = 0; k < SOURCES; k++)
        n += sources[k]->count(d);
    return n;
}

int flk_column_number(const flk_analysis *a, size_t i, flk_column *c)
{
    size_t k, n;

    c->number = i;
    for (k = 0; i >= (n = sources[k]->count(a->d)); k++)
        i -= n;
    c->source = sources[k];
    return sources[k]->make(a, i, c);
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

static size_t add_all(const flk_analysis *a, int usual_only, flk_column *list, size_t n)
{
    size_t i, limit = flk_column_limit(a->d), first = n;
    flk_column c;

    for (i = 0; i < limit; i++)
        if (flk_column_number(a, i, &c) && (!usual_only || c.is_usual) && !c.source->is_apart)
            n = add_column(list, n, first, &c);
    return n;
}

static void note_missing(const flk_analysis *a, const deck *d, text name, mistakes *m)
{
    char words[MESSAGE_SIZE];
    const char *nearest;
    size_t k, i;

    for (k = 0; k < SOURCES; k++)
        for (i = 0; i < sources[k]->n_infos; i++)
            if (flk_text_same(name, sources[k]->infos[i].name)) {
                flk_mistake(m, d->columns.place, "the column '%t' %s", name,
                            sources[k]->lacks(d, i, words));
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
    front.length += flk_at_angle_length(*rest);
    *rest = flk_text_from(*name, front.length);
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

int flk_column_handle_of_name(const deck *d, size_t i)
{
    return 1 + HANDLES * (int)flk_column_limit(d) + (int)i;
}

int flk_column_of_handle(const flk_analysis *a, int handle, flk_column *c, flk_statistic *statistic)
{
    size_t place = handle > 0 ? (size_t)handle - 1 : (size_t)-1;

    *statistic = (flk_statistic)(place % HANDLES);
    return place / HANDLES < flk_column_limit(a->d) && flk_column_number(a, place / HANDLES, c);
}

int flk_column_is_direction(const flk_column *c)
{
    return c->info->q == QUANTITY_ANGLE &&
           ((c->info->traits & FOURLINK_CRANK_ANGLE) || c->info->form == POLAR_DIRECTION ||
            c->info->form == DIRECTION || c->info->form == ANGLE_OF_LINK);
}

int flk_column_counts_turns(const flk_column *c)
{
    return (c->info->traits & COUNTS_TURNS) != 0;
}

static int is_known(text name)
{
    text angle;

    flk_at_angle_cut(name, &name, &angle);
    return flk_column_is_known(name) || flk_text_equal(name, "all") ||
           flk_text_equal(name, flk_drive_columns.infos[0].name) ||
           memchr(name.start, '.', name.length) != NULL || flk_column_statistic_of(name, &name);
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
    return a->possible == b->possible &&
           a->d->machine.mechanism.design.kind == b->d->machine.mechanism.design.kind &&
           flk_column_same_points(a->d, b->d);
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

/* ------------------------------------------------------------------- what a column is, and has in a row */

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

int flk_column_is_of_motion(const flk_column *c)
{
    return (c->info->traits & OF_MOTION_ALONE) ||
           (!(c->info->traits & HAS_CORNERS) &&
            !(c->info->need & ~(NEED_DERIVED | NEED_SERIES | NEED_KLEIN | NEED_ANGLES |
                                NEED_WANTED | NEED_TIME | NEED_RUBBING)));
}

int flk_column_is_of_places(const flk_column *c)
{
    return c->source == &flk_table_columns && !(c->info->need & ~(NEED_ANGLES | NEED_TIME)) &&
           ((c->info->traits & FOURLINK_OF_CRANK) || c->info->q == QUANTITY_ANGLE ||
            c->info->q == QUANTITY_LENGTH);
}

int flk_column_has_vector(const flk_column *c)
{
    return c->info->form >= POLAR_SIZE && c->info->form <= DIRECTION;
}

void flk_column_vector(const flk_column *c, const flk_row *row, double *x, double *y)
{
    fourlink_vector u;

    *x = *y = GSL_NAN;
    if (row->at.status != FOURLINK_OK)
        return;
    c->source->vector(c, row, x, y);
    u.x = *x;
    u.y = *y;
    flk_column_turn(c->d, &u);
    *x = u.x;
    *y = u.y;
}

void flk_column_turn(const deck *d, fourlink_vector *u)
{
    const deck_axes *axes = &d->axes;
    double x = u->x;

    if (!axes->is_page)
        return;
    u->x = axes->cosine * x - axes->sine * u->y;
    u->y = axes->sine * x + axes->cosine * u->y;
}

void flk_column_values(const flk_column *list, size_t n, const flk_row *row, double *values)
{
    size_t i;

    for (i = 0; i < n; i++)
        values[i] = row->at.status == FOURLINK_OK && list[i].is_number
                        ? FLK_ROW_NUMBER(row, list[i].info->x) * list[i].scale
                        : flk_column_value(&list[i], row);
}

double flk_column_value(const flk_column *c, const flk_row *row)
{
    if (row->at.status != FOURLINK_OK && !(c->info->traits & FOURLINK_OF_CRANK))
        return GSL_NAN;
    return c->scale * (c->is_number ? FLK_ROW_NUMBER(row, c->info->x) : c->source->value(c, row));
}

int flk_column_flags(const flk_column *c)
{
    return (c->info->traits & COLUMN_FLAGS) |
           (c->info->need & (NEED_FORCES | NEED_ENGINE) ? FOURLINK_OF_FORCES : 0);
}

double flk_column_size(const flk_column *c, const flk_row *row)
{
    return c->source->size ? c->scale * c->source->size(c, row) : GSL_NAN;
}

int flk_column_need(const flk_column *c)
{
    return c->info->need;
}

double flk_column_bound(const flk_column *c)
{
    return c->info->denominator ? 1e9 * c->scale : GSL_POSINF;
}

double flk_column_denominator(const flk_column *c, const flk_row *row)
{
    return c->info->denominator(&row->at.state);
}
