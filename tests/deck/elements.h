/* SPDX-License-Identifier: GPL-3.0-or-later
**
** elements.h - the loads and the gas of a deck.
*/
#ifndef ELEMENTS_H
#define ELEMENTS_H

#include "deck/deck.h"

static inline size_t given_loads(const deck *d)
{
    return flk_machine_count(&d->machine, &flk_given_load_type);
}

/* Load i of a deck; one of zeros if there is none. */
static inline const flk_given_load *given_load(const deck *d, size_t i)
{
    static const flk_given_load none;
    const flk_element *e = flk_machine_find(&d->machine, &flk_given_load_type, i);

    return e ? e->data : &none;
}

static inline const flk_gas *gas_of(const deck *d)
{
    static const flk_gas none;
    const flk_element *e = flk_machine_find(&d->machine, &flk_gas_type, 0);

    return e ? e->data : &none;
}

#endif
