/* SPDX-License-Identifier: GPL-3.0-or-later
**
** name.c - what names and handles mean in an opened deck, and their values.
**
** The handle of an input that is not a number of the deck, such as gas.area, holds for one design only, as
** each design leaves out inputs that are 0; others hold for all designs.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "deck/at_angle.h"
#include "deck/numbers.h"
#include "fact.h"
#include "opened.h"

/* Find the input or variable of this name, or with a handle that of this handle. */
static void find_given(flk_opened *o, text name, flk_name *n)
{
    static const int which[] = {FOURLINK_INPUTS, FOURLINK_VARIABLES};
    unsigned long i;
    int k;

    flk_list_inputs(&o->d, &o->line_units, &o->lists[FOURLINK_INPUTS]);
    for (k = 0; k < 2; k++) {
        const flk_list *list = &o->lists[which[k]];

        for (i = 0; i < list->n && !n->kind; i++)
            if (n->handle ? list->list[i].handle == n->handle
                          : flk_text_same(name, list->list[i].name)) {
                n->kind = FLK_NAME_GIVEN;
                n->handle = list->list[i].handle;
                n->given = &list->list[i];
            }
    }
    if (n->kind || !flk_list_number_value(
                       &o->d, n->handle ? flk_list_number(n->handle) : flk_number_find(&o->d, name),
                       &o->line_units, &o->number))
        return;
    n->kind = FLK_NAME_GIVEN;
    n->handle = o->number.handle;
    n->given = &o->number;
}

/* The handle of a NAME at ANGLE; 0 if it has none. */
static int find_at_name(const flk_opened *o, text name)
{
    size_t i;

    for (i = 0; i < o->n_at_names; i++)
        if (flk_text_same(name, o->at_names + DECK_NAME_SIZE * i))
            return flk_column_handle_of_name(&o->d, i);
    return 0;
}

int flk_name_keep(flk_opened *o, text name, flk_name *n)
{
    if (n->kind != FLK_NAME_AT || n->handle)
        return 1;
    if (name.length >= DECK_NAME_SIZE || o->n_at_names == FLK_AT_NAMES)
        return 0;
    flk_text_copy(name, o->at_names + DECK_NAME_SIZE * o->n_at_names, DECK_NAME_SIZE);
    n->handle = flk_column_handle_of_name(&o->d, o->n_at_names++);
    return 1;
}

void flk_names_take(flk_opened *o, const flk_opened *from)
{
    memcpy(o->at_names, from->at_names, from->n_at_names * DECK_NAME_SIZE);
    o->n_at_names = from->n_at_names;
}

/* Find NAME at ANGLE. */
static void find_at(flk_opened *o, text name, flk_name *n)
{
    char message[MESSAGE_SIZE];

    if (!flk_column_find(&o->a, n->of, &n->c) ||
        !flk_at_angle_read(&o->d, n->at, &n->angle, message))
        return;
    n->kind = FLK_NAME_AT;
    n->handle = find_at_name(o, name);
}

void flk_name_find(flk_opened *o, text name, flk_name *n)
{
    memset(n, 0, sizeof *n);
    n->of = name;
    n->statistic = flk_column_statistic_of(name, &n->of);
    if (flk_column_find(&o->a, n->of, &n->c)) {
        n->kind = n->statistic ? FLK_NAME_STATISTIC : FLK_NAME_COLUMN;
        n->handle = flk_column_handle(&n->c, n->statistic);
    } else if ((n->handle = flk_fact_find(&o->d, name)) != 0) {
        n->kind = FLK_NAME_FACT;
    } else if (flk_at_angle_cut(name, &n->of, &n->at)) {
        find_at(o, name, n);
    } else {
        find_given(o, name, n);
    }
}

void flk_name_of_handle(flk_opened *o, int handle, flk_name *n)
{
    size_t i = (size_t)(handle - flk_column_handle_of_name(&o->d, 0));

    if (handle > 0 && i < o->n_at_names) {
        flk_name_find(o, flk_text_of(o->at_names + DECK_NAME_SIZE * i), n);
        return;
    }
    memset(n, 0, sizeof *n);
    n->handle = handle;
    if (flk_fact_group(handle) && flk_fact_is_there(&o->d, handle))
        n->kind = FLK_NAME_FACT;
    else if (flk_column_of_handle(&o->a, handle, &n->c, &n->statistic))
        n->kind = n->statistic ? FLK_NAME_STATISTIC : FLK_NAME_COLUMN;
    else if (handle)
        find_given(o, n->of, n);
}

/* Put the name and the handle of a NAME at ANGLE in place of those of its column, if it has one. */
static void put_at_name(const flk_opened *o, int handle, fourlink_value *v)
{
    if (!handle)
        return;
    v->name = o->at_names + DECK_NAME_SIZE * (handle - flk_column_handle_of_name(&o->d, 0));
    v->handle = handle;
}

void flk_name_describe(const flk_opened *o, const flk_name *n, fourlink_value *v)
{
    memset(v, 0, sizeof *v);
    if (n->kind == FLK_NAME_GIVEN)
        *v = *n->given;
    else if (n->kind == FLK_NAME_FACT)
        flk_fact_describe(&o->d, n->handle, v);
    else if (n->kind)
        flk_list_column(&o->d, &n->c, v);
    v->has_angle = n->kind == FLK_NAME_COLUMN;
    if (n->kind == FLK_NAME_STATISTIC) {
        v->name = flk_column_statistic_name(n->statistic, &n->c, o->facts.names);
        v->handle = n->handle;
    }
    if (n->kind == FLK_NAME_AT) {
        v->angle = n->angle;
        put_at_name(o, n->handle, v);
    }
}

/* The value of a column in a row, which has been computed. */
static int value_in_row(const flk_opened *o, const flk_column *c, fourlink_branch branch,
                        const flk_row *row, fourlink_value *value)
{
    fourlink_value v;

    flk_list_column(&o->d, c, &v);
    v.value = flk_column_value(c, row);
    v.has_angle = 1;
    v.angle = row->at.row.angle;
    v.branch = (int)branch;
    if (row->at.status != FOURLINK_OK && (!(v.flags & FOURLINK_OF_CRANK) || gsl_isnan(v.value)))
        return row->at.status;
    *value = v;
    return FOURLINK_OK;
}

/* A row that is kept; null if the motion does not have the angle. */
static const flk_row *find_row(flk_opened *o, int needs, fourlink_branch branch, double angle)
{
    flk_kept_row *kept;
    size_t i;

    for (i = 0; i < GSL_MIN(o->n_rows, FLK_ROWS_KEPT); i++) {
        kept = &o->rows[i];
        if (kept->needs == needs && kept->branch == branch && kept->angle == angle)
            return &kept->row;
    }
    kept = &o->rows[o->n_rows % FLK_ROWS_KEPT];
    kept->angle = GSL_NAN; /* until the row is known */
    if (!flk_analysis_at_angle(&o->a, needs, branch, angle, &kept->row))
        return NULL;
    kept->needs = needs;
    kept->branch = branch;
    kept->angle = angle;
    o->n_rows++;
    return &kept->row;
}

static int value_of_column(flk_opened *o, const flk_column *c, int needs, fourlink_branch branch,
                           double angle, fourlink_value *value)
{
    flk_row row;

    needs |= flk_column_need(c);
    if (o->rows) {
        const flk_row *kept = find_row(o, needs, branch, angle);

        return kept ? value_in_row(o, c, branch, kept, value) : FOURLINK_NO_SUCH_ANGLE;
    }
    if (!flk_analysis_at_angle(&o->a, needs, branch, angle, &row))
        return FOURLINK_NO_SUCH_ANGLE;
    return value_in_row(o, c, branch, &row, value);
}

/* What a row needs so that it is known whether friction locks the machine there. */
static int needs_of_lock(const flk_opened *o)
{
    return o->d.machine.has_friction ? o->a.possible & NEED_FORCES : 0;
}

int flk_name_prepare(flk_opened *o, const flk_name *n, fourlink_branch branch)
{
    int groups = n->kind == FLK_NAME_FACT        ? flk_fact_group(n->handle)
                 : n->kind == FLK_NAME_STATISTIC ? FLK_SEARCHES
                 : n->kind == FLK_NAME_UNKNOWN || n->kind == FLK_NAME_GIVEN ? 0
                                                                            : FLK_ROWS;

    return flk_opened_prepare(o, (int)branch, groups);
}

int flk_name_value_along(flk_opened *o, const flk_name *n, fourlink_branch branch, int side,
                         double place, fourlink_value *value)
{
    flk_row row;

    if (!o->a.course.type->find(&o->a.course, place, &place))
        return FOURLINK_NO_SUCH_ANGLE;
    flk_analysis_along(&o->a, flk_column_need(&n->c), branch,
                       side ? side : flk_course_first_side(&o->a.course), place, &row);
    return value_in_row(o, &n->c, branch, &row, value);
}

unsigned long flk_name_facts(flk_opened *o, int handle, fourlink_branch branch)
{
    return flk_fact_list(&o->a, NULL, (int)branch, flk_fact_group(handle), handle, NULL, 0,
                         &o->found);
}

int flk_name_value(flk_opened *o, const flk_name *n, fourlink_branch branch, double angle,
                   fourlink_value *value)
{
    int status = flk_name_prepare(o, n, branch);

    if (status != FOURLINK_OK)
        return status;
    switch (n->kind) {
    case FLK_NAME_COLUMN:
        return value_of_column(o, &n->c, 0, branch, angle, value);
    case FLK_NAME_AT:
        status = value_of_column(o, &n->c, needs_of_lock(o), branch, n->angle, value);
        if (status == FOURLINK_OK)
            put_at_name(o, n->handle, value);
        return status;
    case FLK_NAME_STATISTIC:
        return flk_fact_of_statistic(&o->a, &o->extremes, &n->c, n->statistic, branch, 0,
                                     o->facts.names, value);
    case FLK_NAME_FACT:
        if (!flk_name_facts(o, n->handle, branch))
            return flk_fact_why_missing(&o->a, n->handle, branch);
        *value = o->found.list[0];
        return FOURLINK_OK;
    case FLK_NAME_GIVEN:
        if (gsl_isnan(n->given->value))
            return FOURLINK_NO_SUCH_NAME;
        *value = *n->given;
        return FOURLINK_OK;
    case FLK_NAME_UNKNOWN:
    default:
        return FOURLINK_NO_SUCH_NAME;
    }
}

double flk_name_turn(const flk_opened *o, const flk_name *n)
{
    int is_direction = n->kind == FLK_NAME_FACT ? flk_fact_is_direction(&o->d, n->handle)
                                                : flk_column_is_direction(&n->c);

    return is_direction ? flk_unit_from_si(2 * M_PI, o->d.units[QUANTITY_ANGLE].unit) : 0;
}
