/* SPDX-License-Identifier: GPL-3.0-or-later
**
** point.c - points that every deck has by name: the pins B and C, the centres of mass G2, G3 and G4.
*/
#include <string.h>

#include "mechanics/kind.h"
#include "point.h"

#define POINT_NAME(name, meaning) #name,
static const char *const names[] = {FLK_POINT_LIST(POINT_NAME)};

static int is_hidden(const deck *d, flk_point_code code)
{
    size_t i;

    for (i = 0; i < d->n_points; i++)
        if (strcmp(d->points[i].name, names[code]) == 0)
            return 1;
    return 0;
}

/* The pin C: the joint of links 3 and 4 or, if these slide on each other, the end of link 4. */
static const char *find_C(const deck *d, int *link, fourlink_vector *at)
{
    const fourlink_joint *joint = &flk_kind_of(d->design.kind)->joint[2];

    *link = joint->slider ? FOURLINK_FOLLOWER : joint->at;
    if (joint->slider || joint->is_tip)
        at->x = d->design.link[*link].length;
    return joint->slider && at->x <= 0 ? "needs a lever with a length" : NULL;
}

const char *flk_point_find(const deck *d, flk_point_code code, int *link, fourlink_vector *at)
{
    at->x = at->y = 0;
    if (is_hidden(d, code))
        return "is hidden by a [point]";
    if (code == FLK_POINT_C)
        return find_C(d, link, at);
    *link = FOURLINK_CRANK;
    if (code == FLK_POINT_B) {
        at->x = d->design.link[*link].length;
        return NULL;
    }
    *link += (int)code - FLK_POINT_G2;
    *at = d->design.link[*link].cg;
    return d->design.link[*link].mass > 0 ? NULL : "needs a mass of that link";
}
