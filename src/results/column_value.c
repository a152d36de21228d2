/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column_value.c - the value of a column in a row, and what the search for extremes must know about it.
*/
#include <math.h>
#include <stddef.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "column.h"
#include "column_list.h"
#include "mechanics/mechanics.h"

static double number_at(const flk_row *row, size_t place)
{
    return *(const double *)(const void *)((const char *)row + place);
}

/* Columns of a point: x and y of position, velocity and acceleration; the sizes of the last two. */
#define IS_SIZE_OF_POINT(c) ((c)->link && (c)->component >= 6)

static double point_value(const flk_column *c, const flk_row *row)
{
    fourlink_vector u[3];
    int i = c->component;

    fourlink_point(&row->at.state, c->link, &c->at, &u[0], &u[1], &u[2]);
    if (IS_SIZE_OF_POINT(c))
        return flk_length(u[i - 5].x, u[i - 5].y) * c->scale;
    return (i % 2 == 0 ? u[i / 2].x : u[i / 2].y) * c->scale;
}

static double spring_value(const flk_column *c, const fourlink_state *state)
{
    fourlink_spring_state at;

    if (fourlink_spring_at(c->mechanism, state, c->spring, &at) != FOURLINK_OK)
        return GSL_NAN;
    return c->component == 0   ? at.length
           : c->component == 1 ? at.force
           : c->component == 2 ? at.energy
                               : at.power;
}

int flk_column_is_of_motion(const flk_column *c)
{
    return (c->info->traits & OF_MOTION_ALONE) ||
           (!c->spring &&
            !(c->info->need & ~(NEED_DERIVED | NEED_SERIES | NEED_KLEIN | NEED_ANGLES |
                                NEED_WANTED | NEED_TIME | NEED_RUBBING)));
}

int flk_column_has_vector(const flk_column *c)
{
    return c->link ? IS_SIZE_OF_POINT(c)
                   : !c->spring && c->info->form >= POLAR_SIZE && c->info->form <= DIRECTION;
}

void flk_column_vector(const flk_column *c, const flk_row *row, double *x, double *y)
{
    fourlink_vector u[3];
    double size, direction;

    *x = *y = GSL_NAN;
    if (row->at.status != FOURLINK_OK)
        return;
    if (c->link) {
        fourlink_point(&row->at.state, c->link, &c->at, &u[0], &u[1], &u[2]);
        *x = u[c->component - 5].x;
        *y = u[c->component - 5].y;
        return;
    }
    *x = number_at(row, c->info->x);
    *y = number_at(row, c->info->y);
    if (c->info->form > POLAR_DIRECTION)
        return;
    size = c->info->form == POLAR_SIZE ? *x : *y;
    direction = c->info->form == POLAR_SIZE ? *y : *x;
    *x = size == 0 ? 0 : size * flk_cosine(direction);
    *y = size == 0 ? 0 : size * flk_sine(direction);
}

/* A zero vector has no direction. */
static double direction_of(double x, double y)
{
    return x == 0 && y == 0 ? FLK_UNDEFINED : flk_angle(y, x);
}

/* 1 for nearly all columns: a number of the row. */
static int is_number(const flk_column *c)
{
    return !c->link && !c->spring && c->info->form <= POLAR_DIRECTION;
}

void flk_column_values(const flk_column *list, size_t n, const flk_row *row, double *values)
{
    size_t i;

    for (i = 0; i < n; i++)
        values[i] = row->at.status == FOURLINK_OK && is_number(&list[i])
                        ? number_at(row, list[i].info->x) * list[i].scale
                        : flk_column_value(&list[i], row);
}

double flk_column_value(const flk_column *c, const flk_row *row)
{
    double x, y;

    if (row->at.status != FOURLINK_OK && !(c->info->traits & FOURLINK_OF_CRANK))
        return GSL_NAN;
    if (c->link)
        return point_value(c, row);
    if (c->spring)
        return c->scale * spring_value(c, &row->at.state);
    x = number_at(row, c->info->x);
    if (is_number(c))
        return x * c->scale;
    y = number_at(row, c->info->y);
    x = c->info->form == SIZE        ? flk_length(x, y)
        : c->info->form == DIRECTION ? direction_of(x, y)
        : c->info->form == PRODUCT   ? x * y
                                     : x - y;
    return x * c->scale;
}

int flk_column_flags(const flk_column *c)
{
    return (c->info->traits & COLUMN_FLAGS) |
           (c->info->need & (NEED_FORCES | NEED_ENGINE) ? FOURLINK_OF_FORCES : 0);
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
