/* SPDX-License-Identifier: GPL-3.0-or-later
**
** kind.c - the table of kinds, and what it tells: names, the nine unknowns, and the mechanism as a
** whole.
*/
#include <string.h>

#include "kind.h"

static const flk_kind *const kinds[] = {&flk_four_bar, &flk_slider_crank};

const flk_kind *flk_kind_of(int kind)
{
    size_t i;

    for (i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
        if ((int)kinds[i]->kind == kind)
            return kinds[i];
    return NULL;
}

const char *fourlink_kind_text(int kind)
{
    const flk_kind *found = flk_kind_of(kind);

    return found ? found->words : "unknown kind";
}

static int is_link(int link)
{
    return link >= FOURLINK_GROUND && link <= FOURLINK_FOLLOWER;
}

const char *fourlink_link_text(int kind, int link)
{
    const flk_kind *found = flk_kind_of(kind);

    return found && is_link(link) ? found->link[link] : "unknown link";
}

const char *fourlink_unknown_text(int kind, int i)
{
    const flk_kind *found = flk_kind_of(kind);

    return found && i >= 0 && i < 9 ? found->unknown[i].name : "unknown";
}

int fourlink_unknowns(const fourlink_mechanism *mechanism, const fourlink_forces *forces,
                      double x[9])
{
    const flk_kind *kind;
    int i;

    if (!mechanism || !forces || !x)
        return FOURLINK_NULL;
    kind = flk_kind_of(mechanism->design.kind);
    if (!kind)
        return FOURLINK_BAD_KIND;
    for (i = 0; i < 9; i++)
        x[i] = *FLK_CONST_MEMBER(forces, kind->unknown[i].member);
    return FOURLINK_OK;
}

int fourlink_slides(int kind, int link)
{
    const flk_kind *found = flk_kind_of(kind);
    int i;

    for (i = 0; found && is_link(link) && i < 4; i++)
        if (found->joint[i].slider == link)
            return found->joint[i].from == link ? found->joint[i].on : found->joint[i].from;
    return 0;
}

const char *fourlink_type_text(int type)
{
    switch (type) {
        FOURLINK_TYPE_LIST(FLK_CASE)
    default:
        return "unknown type";
    }
}

int fourlink_type_of(const fourlink_mechanism *mechanism, fourlink_type *type)
{
    const flk_kind *kind;

    if (!mechanism || !type)
        return FOURLINK_NULL;
    kind = flk_kind_of(mechanism->design.kind);
    if (!kind)
        return FOURLINK_BAD_KIND;
    *type = kind->type(mechanism);
    return FOURLINK_OK;
}

int fourlink_reach_of(const fourlink_mechanism *mechanism, fourlink_reach *reach)
{
    const flk_kind *kind;

    if (!mechanism || !reach)
        return FOURLINK_NULL;
    kind = flk_kind_of(mechanism->design.kind);
    if (!kind)
        return FOURLINK_BAD_KIND;
    memset(reach, 0, sizeof *reach);
    kind->ranges(mechanism, reach);
    return FOURLINK_OK;
}

int fourlink_limits_of(const fourlink_mechanism *mechanism, fourlink_branch branch,
                       fourlink_limits *limits)
{
    const flk_kind *kind;

    if (!mechanism || !limits)
        return FOURLINK_NULL;
    if (branch != FOURLINK_OPEN && branch != FOURLINK_CROSSED)
        return FOURLINK_BAD_BRANCH;
    kind = flk_kind_of(mechanism->design.kind);
    if (!kind)
        return FOURLINK_BAD_KIND;
    memset(limits, 0, sizeof *limits);
    kind->limits(mechanism, branch, limits);
    return FOURLINK_OK;
}

void flk_kind_add_range(fourlink_reach *reach, double from, double to)
{
    if (from < to) {
        reach->from[reach->n_ranges] = from;
        reach->to[reach->n_ranges] = to;
        reach->n_ranges++;
    }
}

double flk_kind_clamp(double x)
{
    return x < -1 ? -1 : x > 1 ? 1 : x;
}
