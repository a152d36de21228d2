/* SPDX-License-Identifier: GPL-3.0-or-later
**
** without_deck.c - extremes for hosts without a deck.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "mechanics/mechanics.h"
#include "extreme.h"

/* Results are in SI units, crank angles in the unit of the motion. */
static void set_motion(const fourlink_motion *motion, deck *d)
{
    double turn = fabs(motion->to - motion->from) * motion->angle_unit;

    d->motion = *motion;
    d->machine.cycle = 2 * M_PI;
    d->one_revolution = fabs(turn - 2 * M_PI) < 1e-9;
    d->units[QUANTITY_ANGLE].unit.up = motion->angle_unit;
    d->units[QUANTITY_ANGLE].unit.down = 1;
}

/* Returns 0 if out of memory. */
static int set_machine(const fourlink_mechanism *mechanism, const fourlink_load *loads,
                       unsigned long n_loads, deck *d)
{
    flk_machine *machine = &d->machine;
    flk_given_load *given = flk_deck_keep(d, (n_loads + 1) * sizeof *given);
    unsigned long i;

    machine->element = flk_deck_keep(d, (n_loads + 1) * sizeof *machine->element);
    if (!given || !machine->element)
        return 0;
    for (i = 0; i < n_loads; i++) {
        given[i].load = loads[i];
        given[i].values.force = loads[i].force;
        given[i].values.torque = loads[i].torque;
        given[i].load.force.x = given[i].load.force.y = given[i].load.torque = 0;
        flk_element_of_given_load(&given[i], &machine->element[i]);
    }
    d->machine.mechanism.design = mechanism->design;
    d->has_forces = 1;
    machine->mechanism = *mechanism;
    machine->n_elements = n_loads;
    flk_machine_finish(machine);
    return 1;
}

static int find_value(flk_analysis *a, flk_extremes *x, const char *name, fourlink_branch branch,
                      double *value, double *angle)
{
    flk_extreme found;
    flk_column c;
    text of;
    flk_statistic statistic = flk_column_statistic_of(flk_text_of(name), &of);
    int status;

    if ((statistic != FLK_MAX && statistic != FLK_MIN) || !flk_column_find(a, of, &c))
        return FOURLINK_NO_SUCH_NAME;
    status = flk_extremes_find(x, a, &c, branch, statistic, 0, &found);
    if (status != FOURLINK_OK)
        return status;
    *value = flk_column_flags(&c) & FOURLINK_CRANK_ANGLE ? found.value * a->d->motion.angle_unit
                                                         : found.value / c.scale;
    if (angle)
        *angle = gsl_finite(found.value) ? found.angle : GSL_NAN;
    return FOURLINK_OK;
}

int fourlink_extreme(const fourlink_mechanism *mechanism, const fourlink_motion *motion,
                     const fourlink_load *loads, unsigned long n_loads, fourlink_branch branch,
                     const char *name, double *value, double *angle)
{
    fourlink_range range;
    flk_extremes x;
    flk_analysis a;
    int status;
    deck d;

    if (!mechanism || !motion || (!loads && n_loads) || !name || !value)
        return FOURLINK_NULL;
    if (branch != FOURLINK_OPEN && branch != FOURLINK_CROSSED)
        return FOURLINK_BAD_BRANCH;
    if (!flk_kind_of(mechanism->design.kind))
        return FOURLINK_BAD_KIND;
    status = fourlink_motion_range(motion, &range);
    if (status == FOURLINK_OK)
        status = flk_check_loads(mechanism, loads, n_loads);
    if (status != FOURLINK_OK)
        return status;
    memset(&a, 0, sizeof a);
    memset(&x, 0, sizeof x);
    flk_deck_start(&d);
    set_motion(motion, &d);
    status = set_machine(mechanism, loads, n_loads, &d) && flk_analysis_open(&a, &d, NULL) &&
                     flk_extremes_open(&x, flk_column_limit(&d)) && flk_extremes_prepare(&x)
                 ? find_value(&a, &x, name, branch, value, angle)
                 : FOURLINK_NO_MEMORY;
    flk_extremes_close(&x);
    flk_analysis_close(&a);
    flk_deck_free(&d);
    return status;
}
