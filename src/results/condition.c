/* SPDX-License-Identifier: GPL-3.0-or-later
**
** condition.c - the conditions of [sweep] that count for the yield.
*/
#include "condition.h"
#include "fourlink.h"

static const struct {
    const char *sign;
    int flags;
} sign_table[] = {{">=", FOURLINK_ABOVE | FOURLINK_OR_EQUAL},
                  {"<=", FOURLINK_BELOW | FOURLINK_OR_EQUAL},
                  {">", FOURLINK_ABOVE},
                  {"<", FOURLINK_BELOW}};

#define SIGNS (sizeof sign_table / sizeof sign_table[0])

int flk_condition_next(text *rest, flk_condition *c)
{
    size_t i;

    if (!flk_text_split(rest, ',', &c->whole))
        return 0;
    c->whole = flk_text_trim(c->whole);
    if (!c->whole.length && !rest->start)
        return 0; /* a comma at the very end */
    for (i = 0; i < SIGNS; i++)
        if (flk_text_cut(c->whole, sign_table[i].sign, &c->name, &c->limit))
            break;
    if (i == SIGNS || !c->name.length || !c->limit.length)
        return -1;
    c->flags = sign_table[i].flags;
    return 1;
}
