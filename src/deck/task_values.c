/* SPDX-License-Identifier: GPL-3.0-or-later
**
** task_values.c - the values of [synthesis]: lists, ranges, points, and the lengths that are given.
*/
#include <string.h>

#include "mechanics/kind.h"
#include "task.h"

setting *flk_task_find(parser *p, key_code key)
{
    return flk_setting_of(flk_section_find(p, SECTION_SYNTHESIS, NULL), key);
}

deck_synthesis *flk_task_of(const parser *p)
{
    return p->d->synthesis;
}

const char *const flk_task_names[] = {"", "function", "motion", "path", "quick-return", "cognate"};

/* 1 if a key is given; otherwise 0 and a mistake. */
int flk_task_require(parser *p, key_code key, const char *example)
{
    return IS_SET(flk_task_find(p, key)) ||
           flk_mistake(p->mistakes, flk_task_of(p)->place, "task = %s needs '%s', such as %s = %s",
                       flk_task_names[flk_task_of(p)->task], flk_key_table[key].name,
                       flk_key_table[key].name, example);
}

/* The first unit of length that is written is that of the lengths found. */
void flk_task_unit(parser *p, text name)
{
    deck_unit *u = &flk_task_of(p)->length;
    unit read;
    text bad;

    name = flk_text_trim(name);
    if (u->name[0] || !name.length || name.length >= DECK_NAME_SIZE ||
        !flk_unit_read(name, &read, &bad) ||
        !flk_dimension_equal(read.dim, flk_quantities[QUANTITY_LENGTH].dim))
        return;
    flk_text_copy(name, u->name, sizeof u->name);
    u->unit = read;
}

/* Report a mistake in a list unless one of its items has been reported; returns 0. */
int flk_task_refuse(parser *p, key_code key, const char *expected)
{
    return flk_mistakes_count(p->mistakes) == 0 &&
           flk_mistake(p->mistakes, flk_task_find(p, key)->place, "expected %s", expected);
}

/* ------------------------------------------------------------------------------ pieces of values */

/* A quantity, or a range of it: 30 deg to 120 deg, 100 to 30 mm. */
static int read_quantity(parser *p, setting *s, text t, quantity q, double *si)
{
    if (q == QUANTITY_LENGTH)
        flk_task_unit(p, flk_quantity_unit_text(t));
    return flk_values_piece(p, s, t, q, si);
}

int flk_task_range(parser *p, key_code key, quantity q, double range[2])
{
    setting *s = flk_task_find(p, key);
    text first, last;
    double number;
    unit u;

    if (!flk_text_cut(s->value, " to ", &first, &last))
        return flk_mistake(p->mistakes, s->place, "expected a range, such as %s, not '%t'",
                           q == QUANTITY_ANGLE    ? "30 deg to 120 deg"
                           : q == QUANTITY_LENGTH ? "100 mm to 30 mm"
                                                  : "1 to 4",
                           s->value);
    if (!read_quantity(p, s, last, q, &range[1]))
        return 0;
    u = s->unit;
    if (flk_quantity_unit_text(first).length || !flk_quantity_unit_text(last).length) {
        if (!read_quantity(p, s, first, q, &range[0]))
            return 0;
    } else {
        text rest = first;

        if (!flk_values_number(p, s, &rest, q, &number))
            return 0;
        range[0] = flk_unit_to_si(number, u);
    }
    return range[0] != range[1] ||
           flk_mistake(p->mistakes, s->place, "the range begins and ends at the same value");
}

/* A list of numbers, at most `most`; returns how many, 0 after a mistake. */
unsigned long flk_task_list(parser *p, key_code key, quantity q, unsigned long most, double *list)
{
    setting *s = flk_task_find(p, key);
    text rest = s->value, item;
    unsigned long n = 0;

    while (flk_curve_text_item(&rest, &item)) {
        if (n == most) {
            flk_mistake(p->mistakes, s->place, "more than %ld values", (long)most);
            return 0;
        }
        if (!read_quantity(p, s, item, q, &list[n++]))
            return 0;
    }
    return n;
}

/* (24, 10) mm -30 deg: a point, and the text after its unit. */
int flk_task_point(parser *p, setting *s, text t, fourlink_vector *at, text *rest)
{
    text after = t, numbers;
    point result;
    size_t i;

    memset(&result, 0, sizeof result);
    if (!t.length || t.start[0] != '(' || !flk_text_split(&after, ')', &numbers) || !after.start)
        return flk_mistake(p->mistakes, s->place, "expected a point, such as (24, 10) mm, not '%t'",
                           t);
    i = flk_curve_point_value(after);
    *rest = flk_text_trim(flk_text_from(after, i));
    after.length = i;
    flk_task_unit(p, after);
    t.length = (size_t)(after.start + i - t.start);
    if (!flk_vector_read_piece(p, s, flk_text_trim(t), QUANTITY_LENGTH, &result))
        return 0;
    at->x = result.y[0];
    at->y = result.y[1];
    return 1;
}

/* --------------------------------------------------------------------------------------- lengths */

static const setting *length_of(parser *p, int link)
{
    const flk_kind *kind = flk_kind_of(p->d->design.kind);

    return flk_setting_by_name(p, flk_find_section(flk_text_of(kind->link[link])), "length");
}

/* The lengths that are given, by link number; returns their number. */
int flk_task_lengths(parser *p, double length[5])
{
    int i, n = 0;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        const setting *s = length_of(p, i);

        length[i] = s->si[0];
        n += IS_SET(s);
        if (IS_SET(s))
            flk_task_unit(p, flk_quantity_unit_text(s->value));
    }
    return n;
}

/* Refuse lengths beside those that a task takes: they would not be those of the linkage found. */
void flk_task_refuse_lengths(parser *p, int most, const char *takes)
{
    static const key_code others[] = {KEY_CRANK_STROKE, KEY_LEVER_ANGLE, KEY_GROUND_OFFSET,
                                      KEY_LEVER_OFFSET};
    int n_others = flk_task_of(p)->task == TASK_QUICK_RETURN ? 2 : 4, i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER + n_others; i++) {
        const setting *s = i <= FOURLINK_FOLLOWER
                               ? length_of(p, i)
                               : flk_setting_find(p, others[i - FOURLINK_FOLLOWER - 1]);

        if (!IS_SET(s) || (i <= FOURLINK_FOLLOWER && most-- > 0))
            continue;
        flk_mistake(p->mistakes, s->place,
                    "task = %s finds this: remove it, or comment it out; the task takes %s",
                    flk_task_names[flk_task_of(p)->task], takes);
    }
}
