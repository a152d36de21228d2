/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_flywheel.c - builds [flywheel] from values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "build.h"
#include "parser.h"
#include "settings.h"

/* ---------------------------------------------------------------------------------------- flywheel */

/* 1 if anything that moves with the crank has inertia. */
static int has_inertia(const deck *d)
{
    const fourlink_link *link = d->machine.mechanism.design.link, *crank = &link[FOURLINK_CRANK];

    return d->machine.flywheel > 0 || d->mode.fluctuation > 0 || d->machine.motor.inertia > 0 ||
           crank->inertia > 0 || (crank->mass > 0 && (crank->cg.x != 0 || crank->cg.y != 0)) ||
           link[3].mass > 0 || link[3].inertia > 0 || link[4].mass > 0 || link[4].inertia > 0;
}

/* The exact fluctuation is defined for the steady motion only. */
static void build_exact(parser *p, const setting *exact, const setting *fluctuation)
{
    int mode = p->d->mode.kind;

    if (exact->word && !IS_SET(fluctuation))
        flk_mistake(p->mistakes, exact->place,
                    "'exact' needs a fluctuation, for which the flywheel is found");
    else if (exact->word && mode != MODE_STEADY)
        flk_mistake(p->mistakes, exact->place,
                    "an exact fluctuation is one of the actual motion: [motion] needs "
                    "mode = steady");
    else if (exact->word)
        p->d->mode.fluctuation = fluctuation->si[0];
    else if (IS_SET(fluctuation) && mode != MODE_GIVEN &&
             !IS_SET(flk_setting_find(p, KEY_FLYWHEEL_INERTIA)))
        flk_mistake(p->mistakes, fluctuation->place,
                    "the actual motion needs the inertia of the flywheel, or exact = yes to find "
                    "it from the fluctuation");
}

void flk_build_flywheel(parser *p)
{
    const setting *inertia = flk_setting_find(p, KEY_FLYWHEEL_INERTIA),
                  *fluctuation = flk_setting_find(p, KEY_FLYWHEEL_FLUCTUATION),
                  *mode = flk_setting_find(p, KEY_MOTION_MODE);

    p->d->flywheel_fluctuation = fluctuation->si[0];
    if (IS_SET(inertia) && IS_SET(fluctuation))
        flk_mistake(p->mistakes, inertia->place,
                    "give either the fluctuation or the inertia: the other follows");
    p->d->machine.flywheel = inertia->si[0];
    build_exact(p, flk_setting_find(p, KEY_FLYWHEEL_EXACT), fluctuation);
    if (p->d->mode.kind != MODE_GIVEN && !has_inertia(p->d) && !p->mistakes->count)
        flk_mistake(p->mistakes, mode->place,
                    "nothing that moves has a mass or a moment of inertia: the actual motion needs "
                    "one");
}
