/* SPDX-License-Identifier: GPL-3.0-or-later
**
** name.c - what a name means: a column, a statistic of a column, a fact, or a value that the deck gives.
**
** The handle of an input that is not a number of the deck, such as gas.area, holds for one design only, as
** each design leaves out inputs that are 0; others hold for all designs.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "fact.h"
#include "name.h"
#include "deck/numbers.h"

/* Find the input or variable of this name, or with a handle that of this handle. */
static void find_given(flk_opened *o, text name, flk_name *n)
{
    static const int which[] = {FOURLINK_INPUTS, FOURLINK_VARIABLES};
    unsigned long i;
    int k;

    flk_list_inputs(&o->d, &o->lists[FOURLINK_INPUTS]);
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
                       &o->number))
        return;
    n->kind = FLK_NAME_GIVEN;
    n->handle = o->number.handle;
    n->given = &o->number;
}

void flk_name_find(flk_opened *o, text name, flk_name *n)
{
    memset(n, 0, sizeof *n);
    n->of = name;
    n->statistic = flk_column_statistic_of(name, &n->of);
    if (flk_column_find(&o->a, n->of, &n->c)) {
        n->kind = n->statistic ? FLK_NAME_STATISTIC : FLK_NAME_COLUMN;
        n->handle = flk_column_handle(&n->c, n->statistic);
    } else if ((n->handle = flk_fact_find(name)) != 0) {
        n->kind = FLK_NAME_FACT;
    } else {
        find_given(o, name, n);
    }
}

void flk_name_of_handle(flk_opened *o, int handle, flk_name *n)
{
    memset(n, 0, sizeof *n);
    n->handle = handle;
    if (flk_fact_group(handle))
        n->kind = FLK_NAME_FACT;
    else if (flk_column_of_handle(&o->a, handle, &n->c, &n->statistic))
        n->kind = n->statistic ? FLK_NAME_STATISTIC : FLK_NAME_COLUMN;
    else if (handle)
        find_given(o, n->of, n);
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

static int value_of_column(flk_opened *o, const flk_column *c, fourlink_branch branch, double angle,
                           fourlink_value *value)
{
    double at;
    flk_row row;

    if (!flk_crank_motion_find_angle(&o->a.crank_motion, angle, &at))
        return FOURLINK_NO_SUCH_ANGLE;
    flk_analysis_at_angle(&o->a, flk_column_need(c), branch, at, &row);
    return value_in_row(o, c, branch, &row, value);
}

int flk_name_value_at_time(flk_opened *o, const flk_name *n, fourlink_branch branch, double time,
                           fourlink_value *value)
{
    flk_row row;

    if (!(time >= 0 && time <= o->d.drive.duration * (1 + 1e-12)))
        return FOURLINK_NO_SUCH_ANGLE;
    flk_analysis_at_time(&o->a, flk_column_need(&n->c), branch, time, &row);
    return value_in_row(o, &n->c, branch, &row, value);
}

unsigned long flk_name_facts(flk_opened *o, int handle, fourlink_branch branch)
{
    return flk_fact_list(&o->a, NULL, (int)branch, flk_fact_group(handle), handle, NULL, 0,
                         &o->facts);
}

int flk_name_value(flk_opened *o, const flk_name *n, fourlink_branch branch, double angle,
                   fourlink_value *value)
{
    switch (n->kind) {
    case FLK_NAME_COLUMN:
        return value_of_column(o, &n->c, branch, angle, value);
    case FLK_NAME_STATISTIC:
        return flk_fact_of_statistic(&o->a, &o->extremes, &n->c, n->statistic, branch, 0,
                                     o->facts.names, value);
    case FLK_NAME_FACT:
        if (!flk_name_facts(o, n->handle, branch))
            return flk_fact_why_missing(&o->a, n->handle, branch);
        *value = o->facts.list[0];
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
