/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_balance.c - builds [balance], the counterweights, from values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "mechanics/balance.h"
#include "build.h"
#include "build_mechanism.h"
#include "parser.h"
#include "settings.h"

/* ------------------------------------------------------------------------------------------ balance */

static void apply(parser *p, int link, const fourlink_vector *moment, double *mass)
{
    deck_balance *b = &p->d->balance;
    fourlink_link balanced;

    if (fourlink_add_counterweight(&p->d->machine.mechanism.design.link[link], moment, b->radius,
                                   &balanced, mass) == FOURLINK_OK &&
        flk_setting_find(p, KEY_BALANCE_APPLY)->word)
        p->d->machine.mechanism.design.link[link] = balanced;
}

void flk_build_balance(parser *p)
{
    const section_use *use = flk_section_find(p, SECTION_BALANCE, NULL);
    const setting *fraction = flk_setting_find(p, KEY_BALANCE_FRACTION),
                  *radius = flk_setting_find(p, KEY_BALANCE_RADIUS),
                  *add = flk_setting_find(p, KEY_BALANCE_APPLY);
    deck_balance *b = &p->d->balance;

    if (!use)
        return;
    b->is_there = 1;
    b->crank = flk_setting_find(p, KEY_BALANCE_CRANK)->word || IS_SET(fraction);
    b->rocker = flk_setting_find(p, KEY_BALANCE_ROCKER)->word;
    b->radius = radius->si[0];
    if (!b->crank && !b->rocker && !use->is_mistaken)
        flk_mistake(p->mistakes, use->place, "[balance] needs %s",
                    flk_build_has(p, KEY_BALANCE_FRACTION)
                        ? "the fraction of the reciprocating mass to be balanced"
                        : "'crank = yes', 'rocker = yes' or both");
    if (add->word && !IS_SET(radius) && !use->is_mistaken)
        flk_mistake(p->mistakes, add->place,
                    "'apply' needs a radius, at which the counterweights are");
    if (p->mistakes->count ||
        fourlink_balance_of(&p->d->machine.mechanism, fraction->si[0], &b->moment) != FOURLINK_OK)
        return;
    if (flk_build_has(p, KEY_BALANCE_FRACTION))
        b->reciprocating = flk_balance_reciprocating(&p->d->machine.mechanism.design);
    if (b->crank && b->radius > 0)
        apply(p, FOURLINK_CRANK, &b->moment.crank, &b->mass[0]);
    if (b->rocker && b->radius > 0)
        apply(p, FOURLINK_FOLLOWER, &b->moment.rocker, &b->mass[1]);
    fourlink_prepare(&p->d->machine.mechanism.design, &p->d->machine.mechanism);
}
