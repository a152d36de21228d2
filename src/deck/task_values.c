/* SPDX-License-Identifier: GPL-3.0-or-later
**
** task_values.c - the values of [synthesis]: lists, ranges, points, and the lengths that are given.
*/
#include <string.h>

#include "mechanics/kind.h"
#include "curve_point.h"
#include "curve_text.h"
#include "parser.h"
#include "pieces.h"
#include "settings.h"
#include "synthesis.h"
#include "task.h"
#include "vector.h"

setting *flk_task_find(parser *p, key_code key)
{
    return flk_setting_of(flk_section_find(p, SECTION_SYNTHESIS, NULL), key);
}

int flk_task_require(parser *p, key_code key, const char *example)
{
    const deck_synthesis *t = p->d->synthesis;
    const char *name = flk_key_table[key].name;

    return IS_SET(flk_task_find(p, key)) ||
           flk_mistake(p->mistakes, t->place, "task = %s needs '%s', such as %s = %s", t->name,
                       name, name, example);
}

int flk_task_refuse(parser *p, key_code key, const char *expected)
{
    text_place place = flk_task_find(p, key)->place;
    size_t i;

    for (i = 0; i < p->mistakes->count; i++)
        if (p->mistakes->list[i].place.line == place.line)
            return 0;
    return flk_mistake(p->mistakes, place, "expected %s", expected);
}

/* ------------------------------------------------------------------------------ pieces of values */

void flk_task_unit(parser *p, text name)
{
    deck_unit *u = &p->d->synthesis->length;
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

int flk_task_range(parser *p, key_code key, quantity q, double range[2])
{
    setting *s = flk_task_find(p, key);
    text first, last, name;

    if (!flk_text_range(s->value, &first, &last))
        return flk_mistake(p->mistakes, s->place, "expected a range, such as %s, not '%t'",
                           q == QUANTITY_ANGLE    ? "30 deg to 120 deg"
                           : q == QUANTITY_LENGTH ? "100 mm to 30 mm"
                                                  : "1 to 4",
                           s->value);
    name = flk_quantity_unit_text(last);
    flk_task_unit(p, name);
    flk_task_unit(p, flk_quantity_unit_text(first));
    if (!flk_quantity_unit_text(first).length && name.length) /* 30 to 120 deg */
        first = flk_text_of(flk_reader_copy(p, first, flk_reader_copy(p, name, "")));
    if (!flk_piece_read(p, s, last, q, &range[1]) || !flk_piece_read(p, s, first, q, &range[0]))
        return 0;
    return range[0] != range[1] ||
           flk_mistake(p->mistakes, s->place, "the range begins and ends at the same value");
}

unsigned long flk_task_list(parser *p, key_code key, quantity q, unsigned long most, double *list)
{
    setting *s = flk_task_find(p, key);
    text rest = s->value, item;
    unsigned long n = 0;

    while (flk_piece_item(&rest, &item)) {
        if (n == most) {
            flk_mistake(p->mistakes, s->place, "more than %ld values", (long)most);
            return 0;
        }
        if (!flk_piece_read(p, s, item, q, &list[n++]))
            return 0;
    }
    return n;
}

int flk_task_pair(parser *p, setting *s, text t, quantity q, double *angle, double *value)
{
    point pair;

    memset(&pair, 0, sizeof pair);
    s->argument = QUANTITY_ANGLE;
    if (!flk_curve_point_read(p, s, t, q, 0, &pair))
        return 0;
    *angle = pair.x;
    *value = pair.y[0];
    return 1;
}

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

/* ---------------------------------------------------------------------------- the rest of the deck */

static const setting *length_setting(parser *p, int link)
{
    return flk_setting_by_name(p, flk_section_of_link(p->d->machine.mechanism.design.kind, link),
                               "length");
}

int flk_task_lengths(parser *p, double length[5])
{
    int i, n = 0;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        const setting *s = length_setting(p, i);

        length[i] = s->si[0];
        n += IS_SET(s);
        if (IS_SET(s))
            flk_task_unit(p, flk_quantity_unit_text(s->value));
    }
    return n;
}

void flk_task_check_lengths(parser *p, int most, const char *takes)
{
    static const key_code others[] = {KEY_CRANK_STROKE, KEY_LEVER_ANGLE, KEY_GROUND_OFFSET,
                                      KEY_LEVER_OFFSET};
    const deck_synthesis *t = p->d->synthesis;
    int n_others = t->task == TASK_QUICK_RETURN ? 2 : 4, i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER + n_others; i++) {
        int is_link = i <= FOURLINK_FOLLOWER;
        const setting *s =
            is_link ? length_setting(p, i) : flk_setting_find(p, others[i - FOURLINK_FOLLOWER - 1]);

        if (IS_SET(s) && (!is_link || most-- <= 0))
            flk_mistake(p->mistakes, s->place,
                        "task = %s finds this: remove it, or comment it out; the task takes %s",
                        t->name, takes);
    }
}

const section_use *flk_task_coupler_point(const parser *p)
{
    const section_use *use;

    for (use = p->uses; use < p->uses + p->n_uses; use++)
        if (use->section == SECTION_POINT &&
            flk_setting_of(use, KEY_POINT_LINK)->word == FOURLINK_COUPLER)
            return use;
    return NULL;
}
