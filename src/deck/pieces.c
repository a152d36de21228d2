/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pieces.c - pieces of a value: a number, its unit, its size; a quantity.
*/
#include <string.h>

#include "parser.h"
#include "pieces.h"

/* Report why a text is not a quantity; returns 0. */
static int refuse(parser *p, text_place place)
{
    return flk_mistake(p->mistakes, place, "%s", p->why);
}

/* Note the first force in lb or oz, whose names are those of masses; returns 1. */
static int note_weight(parser *p, text_place place, text t, text whole, quantity q)
{
    char note[MESSAGE_SIZE];

    if (q != QUANTITY_FORCE || p->has_noted_weight || p->is_design ||
        !flk_quantity_weight(flk_text_trim(t), whole, note))
        return 1;
    p->has_noted_weight = 1;
    flk_mistake(NOTES(p), place, "%s", note);
    return 1;
}

int flk_piece_number(parser *p, const setting *s, text *rest, quantity q, double *number)
{
    return flk_quantity_number(rest, s->value, q, number, p->why) || refuse(p, s->place);
}

int flk_piece_unit(parser *p, const setting *s, text t, quantity q, unit *u)
{
    return flk_quantity_unit(t, s->value, q, p->d->bare[q].unit, u, p->why)
               ? note_weight(p, s->place, t, s->value, q)
               : refuse(p, s->place);
}

int flk_piece_size(parser *p, const setting *s, quantity q, double si)
{
    return flk_quantity_size(si, s->value, q, p->why) || refuse(p, s->place);
}

int flk_piece_quantity(parser *p, text_place place, text t, text whole, quantity q,
                       quantity_value *value)
{
    return flk_quantity_read(t, whole, q, p->d->bare[q].unit, value, p->why)
               ? note_weight(p, place, flk_quantity_unit_text(t), whole, q)
               : refuse(p, place);
}

int flk_piece_read(parser *p, setting *s, text t, quantity q, double *si)
{
    quantity_value value;
    int is_one;

    if (s->is_number) {
        *si = flk_unit_to_si(s->number, s->unit);
        return flk_piece_size(p, s, q, *si);
    }
    memset(&value, 0, sizeof value);
    is_one = flk_piece_quantity(p, s->place, t, s->value, q, &value);
    s->number = value.number;
    s->unit = value.unit;
    *si = value.si;
    return is_one;
}

int flk_piece_item(text *rest, text *item)
{
    size_t i;
    int depth = 0, is_last;

    if (!rest->start)
        return 0;
    for (i = 0; i < rest->length && (depth || rest->start[i] != ','); i++)
        depth = rest->start[i] == '(' ? 1 : rest->start[i] == ')' ? 0 : depth;
    is_last = i == rest->length;
    *item = *rest;
    item->length = i;
    *item = flk_text_trim(*item);
    *rest = flk_text_from(*rest, i + !is_last);
    if (is_last)
        rest->start = NULL;
    return 1;
}
