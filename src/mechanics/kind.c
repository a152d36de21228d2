/* SPDX-License-Identifier: GPL-3.0-or-later
**
** kind.c - the table of kinds: names, the nine unknowns, properties of the mechanism as a whole.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "kind.h"

#define CLOSES 1e-13 /* of the square of a sine: rounding of a triangle that is a line */

static const flk_kind *const kinds[] = {&flk_four_bar, &flk_slider_crank, &flk_inverted,
                                        &flk_scotch_yoke};

/* clang-format off */
#define UNKNOWN(member) {#member, offsetof(fourlink_forces, member)}
/* clang-format on */

const flk_unknown flk_unknowns[9][2] = {
    {UNKNOWN(F12x)},
    {UNKNOWN(F12y)},
    {UNKNOWN(F23x)},
    {UNKNOWN(F23y)},
    {UNKNOWN(F34x), UNKNOWN(M34)},
    {UNKNOWN(F34y), UNKNOWN(N34)},
    {UNKNOWN(F14x), UNKNOWN(M14)},
    {UNKNOWN(F14y), {"N", offsetof(fourlink_forces, F14y)}},
    {UNKNOWN(Ts)},
};

const flk_kind *flk_kind_of(fourlink_kind kind)
{
    size_t i;

    for (i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
        if (kinds[i]->kind == kind)
            return kinds[i];
    return NULL;
}

int flk_kind_find(const fourlink_mechanism *mechanism, const void *output, const flk_kind **kind)
{
    if (!mechanism || !output)
        return FOURLINK_NULL;
    *kind = flk_kind_of(mechanism->design.kind);
    return *kind ? FOURLINK_OK : FOURLINK_BAD_KIND;
}

const char *fourlink_kind_text(int kind)
{
    const flk_kind *found = flk_kind_of((fourlink_kind)kind);

    return found ? found->words : "unknown kind";
}

const char *fourlink_link_text(int kind, int link)
{
    const flk_kind *found = flk_kind_of((fourlink_kind)kind);

    return found && link >= FOURLINK_GROUND && link <= FOURLINK_FOLLOWER ? found->link[link]
                                                                         : "unknown link";
}

int flk_kind_has_slide(fourlink_kind kind)
{
    return fourlink_slides((int)kind, FOURLINK_COUPLER) ||
           fourlink_slides((int)kind, FOURLINK_FOLLOWER);
}

int flk_kind_has_branch(const flk_kind *kind, fourlink_branch branch)
{
    return branch == FOURLINK_OPEN || (branch == FOURLINK_CROSSED && !kind->has_one_branch);
}

int fourlink_slides(int kind, int link)
{
    const flk_kind *found = flk_kind_of((fourlink_kind)kind);
    int i;

    for (i = 0; found && link && i < 4; i++)
        if (found->joint[i].slider == link)
            return found->joint[i].from == link ? found->joint[i].on : found->joint[i].from;
    return 0;
}

/* The joint at the origin of a moving link. */
static int joint_of_origin(const flk_kind *kind, int link)
{
    int i = 0;

    while (kind->joint[i].at != link || kind->joint[i].is_tip)
        i++;
    return i;
}

int fourlink_kind_of(int kind, fourlink_kind_facts *facts)
{
    const flk_kind *found = flk_kind_of((fourlink_kind)kind);
    int link;

    if (!facts)
        return FOURLINK_NULL;
    if (!found)
        return FOURLINK_BAD_KIND;
    facts->kind = found->kind;
    facts->name = found->name;
    facts->words = found->words;
    for (link = 0; link < 5; link++) {
        facts->link[link] = link ? found->link[link] : "";
        facts->slides_on[link] = fourlink_slides(kind, link);
        facts->shape[link] = found->shape[link];
        facts->begins[link] = link < FOURLINK_CRANK ? 0 : joint_of_origin(found, link);
    }
    facts->has_one_branch = found->has_one_branch;
    memcpy(facts->joint, found->joint, sizeof facts->joint);
    memcpy(facts->drawn, found->drawn, sizeof facts->drawn);
    facts->guided = facts->slides_on[FOURLINK_FOLLOWER] == FOURLINK_GROUND ? FOURLINK_FOLLOWER : 0;
    facts->slotted = facts->slides_on[FOURLINK_COUPLER];
    return FOURLINK_OK;
}

const char *fourlink_unknown_text(int kind, int i)
{
    const flk_kind *found = flk_kind_of((fourlink_kind)kind);

    return found && i >= 0 && i < 9 ? flk_unknowns[i][FLK_JOINT_OF(found, i)].name : "unknown";
}

int fourlink_unknowns(const fourlink_mechanism *mechanism, const fourlink_forces *forces,
                      double x[9])
{
    const flk_kind *kind;
    int i, status = flk_kind_find(mechanism, x, &kind);

    if (status != FOURLINK_OK)
        return status;
    if (!forces)
        return FOURLINK_NULL;
    for (i = 0; i < 9; i++)
        x[i] = *FLK_MEMBER(forces, flk_unknowns[i][FLK_JOINT_OF(kind, i)]);
    if (mechanism->drive)
        x[8] = forces->drive;
    return FOURLINK_OK;
}

void flk_list_forces(const fourlink_forces *forces, double list[FLK_FORCES])
{
    int i;

    for (i = 0; i < 8; i++)
        list[i] = *FLK_MEMBER(forces, flk_unknowns[i][FLK_PIN]);
    list[8] = forces->M14;
    list[9] = forces->M34;
    list[10] = forces->drive;
}

const char *fourlink_type_text(int type)
{
    switch (type) {
        FOURLINK_TYPE_LIST(FLK_CASE)
    default:
        return "unknown type";
    }
}

int fourlink_has_type(int kind, int type)
{
    const flk_kind *found = flk_kind_of((fourlink_kind)kind);

    return found && (int)found->first_type <= type && type <= (int)found->last_type;
}

int fourlink_type_of(const fourlink_mechanism *mechanism, fourlink_type *type)
{
    const flk_kind *kind;
    int status = flk_kind_find(mechanism, type, &kind);

    if (status == FOURLINK_OK)
        *type = kind->type(mechanism);
    return status;
}

int fourlink_reach_of(const fourlink_mechanism *mechanism, fourlink_reach *reach)
{
    const flk_kind *kind;
    int status = flk_kind_find(mechanism, reach, &kind);

    if (status != FOURLINK_OK)
        return status;
    memset(reach, 0, sizeof *reach);
    kind->ranges(mechanism, reach);
    return FOURLINK_OK;
}

int fourlink_limits_of(const fourlink_mechanism *mechanism, fourlink_branch branch,
                       fourlink_limits *limits)
{
    const flk_kind *kind;
    int status = flk_kind_find(mechanism, limits, &kind);

    if (status != FOURLINK_OK)
        return status;
    if (!flk_kind_has_branch(kind, branch))
        return FOURLINK_BAD_BRANCH;
    memset(limits, 0, sizeof *limits);
    kind->limits(mechanism, branch, limits);
    return FOURLINK_OK;
}

/* Add a range, if it is not empty. */
static void add_range(fourlink_reach *reach, double from, double to)
{
    if (from < to) {
        reach->from[reach->n_ranges] = from;
        reach->to[reach->n_ranges] = to;
        reach->n_ranges++;
    }
}

void flk_kind_set_ranges(fourlink_reach *reach, int is_low, double lowest, int is_high,
                         double highest, double mirror)
{
    if (!is_low && !is_high) {
        add_range(reach, 0, 2 * M_PI);
    } else if (!is_low) {
        add_range(reach, mirror - 2 * M_PI - highest, highest);
    } else if (!is_high) {
        add_range(reach, lowest, mirror - lowest);
    } else {
        add_range(reach, lowest, highest);
        add_range(reach, mirror - highest, mirror - lowest);
    }
}

/* Half angles keep the digits where the triangle is nearly a line: with sides l opposite to the angle, a
** and f,
**
**    sin^2(gamma/2) = (l - f + a) (l + f - a) / (4 a f)
**    cos^2(gamma/2) = (f + a - l) (f + a + l) / (4 a f)
*/
double flk_kind_angle(double l, double a, double f, double slack)
{
    double sine2 = slack * (l + f - a) / (4 * a * f),
           cosine2 = (f + a - l) * (f + a + l) / (4 * a * f);

    if (!(sine2 >= -CLOSES && cosine2 >= -CLOSES))
        return FLK_UNDEFINED;
    return 2 * flk_angle(sqrt(GSL_MAX(sine2, 0)), sqrt(GSL_MAX(cosine2, 0)));
}

double flk_kind_clamp(double x)
{
    return x < -1 ? -1 : x > 1 ? 1 : x;
}
