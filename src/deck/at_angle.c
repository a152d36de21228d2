/* SPDX-License-Identifier: GPL-3.0-or-later
**
** at_angle.c - NAME at ANGLE: the value of a column in the row at a crank angle.
*/
#include "base/quantity.h"
#include "at_angle.h"

int flk_at_angle_cut(text name, text *column, text *angle)
{
    return flk_text_cut(name, " at ", column, angle);
}

int flk_at_angle_read(const deck *d, text words, double *angle, char message[MESSAGE_SIZE])
{
    quantity_value value;

    if (flk_text_equal(words, "drawn")) {
        if (!d->pins.is_there)
            return flk_message(message, MESSAGE_SIZE, "'drawn' needs [pins]") == NULL;
        *angle = flk_unit_from_si(flk_deck_drawn(d), d->units[QUANTITY_ANGLE].unit);
        return 1;
    }
    if (!flk_quantity_read(words, words, QUANTITY_ANGLE, d->bare[QUANTITY_ANGLE].unit, &value,
                           message))
        return 0;
    *angle = flk_unit_from_si(value.si, d->units[QUANTITY_ANGLE].unit);
    return 1;
}

/* The blanks and the word at the front of a list. */
static size_t length_of_word(text list)
{
    text rest = list;

    while (flk_text_blank(rest))
        rest = flk_text_from(rest, flk_text_blank(rest));
    while (rest.length && rest.start[0] != ',' && !flk_text_blank(rest))
        rest = flk_text_from(rest, 1);
    return list.length - rest.length;
}

#define ANGLE_WORDS 3 /* at most: 2 pi/3 rad */

size_t flk_at_angle_length(text list)
{
    size_t at = length_of_word(list), n = at, found = at;
    char message[MESSAGE_SIZE];
    quantity_value value;
    text words = list, angle;
    int i;

    words.length = at;
    if (!flk_text_same(flk_text_trim(words), "at"))
        return 0;
    for (i = 0; i < ANGLE_WORDS; i++) {
        n += length_of_word(flk_text_from(list, n));
        words.length = n;
        angle = flk_text_trim(flk_text_from(words, at));
        if (i == 0 || flk_quantity_read(angle, angle, QUANTITY_ANGLE,
                                        flk_unit_of_quantity(QUANTITY_ANGLE), &value, message))
            found = n;
    }
    return found > at ? found : 0;
}
