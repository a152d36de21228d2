/* SPDX-License-Identifier: GPL-3.0-or-later
**
** geometry.c - where the parts of a mechanism are at a position.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "geometry.h"

#define SLOT_STEPS 72 /* of a turn, to find how long a slot is */
#define FAR 0.1       /* sine of a slot to the line of its slider */

fourlink_vector geometry_of_link(const fourlink_state *state, int link, const fourlink_vector *at)
{
    fourlink_vector place = *at;

    if (link != FOURLINK_GROUND)
        fourlink_point(state, link, at, &place, NULL, NULL);
    return place;
}

fourlink_vector geometry_end(const view *v, const fourlink_state *state, int link)
{
    fourlink_vector at = place_at(v->design->link[link].length, 0);

    return geometry_of_link(state, link, &at);
}

geometry_output geometry_find_output(const view *v, const fourlink_state *state, int i)
{
    const fourlink_link_state *rod = &state->link[FOURLINK_FOLLOWER + 1 + 2 * i];
    const fourlink_group *g = &v->design->group[i];
    geometry_output x;

    x.P = rod->origin;
    x.Q = place_in(rod->origin, rod->axis, g->rod, 0);
    x.D = rod[1].origin;
    if (g->hang == FOURLINK_HANGS_IN_SLOT)
        x.P = geometry_of_link(state, g->link, &g->at);
    else if (g->hang == FOURLINK_HANGS_BY_OWN_SLOT && g->end == FOURLINK_GROUP_SLIDES)
        x.Q = x.D;
    return x;
}

int geometry_has_slot(const view *v, int i)
{
    return v->design->group[i].hang != FOURLINK_HANGS_BY_ROD;
}

int geometry_is_far(const view *v, const fourlink_state *state, int i)
{
    const fourlink_group *g = &v->design->group[i];
    const fourlink_vector *e = &state->link[FOURLINK_FOLLOWER + 1 + 2 * i].axis;

    return g->hang == FOURLINK_HANGS_IN_SLOT && g->end == FOURLINK_GROUP_SLIDES &&
           fabs(g->direction.x * e->y - g->direction.y * e->x) < FAR;
}

/* How far the block is along its slot, from P of the carrying link, or from slider or rocker. */
static double slide_of(const view *v, const fourlink_state *state, int i)
{
    const fourlink_link_state *block = &state->link[FOURLINK_FOLLOWER + 1 + 2 * i];
    geometry_output x = geometry_find_output(v, state, i);
    fourlink_vector from = v->design->group[i].hang == FOURLINK_HANGS_IN_SLOT ? x.P : x.D;

    return block->axis.x * (block->origin.x - from.x) + block->axis.y * (block->origin.y - from.y);
}

geometry_slot geometry_find_slot(const view *v, const fourlink_state *state, int i)
{
    const fourlink_link_state *block = &state->link[FOURLINK_FOLLOWER + 1 + 2 * i];
    double here = slide_of(v, state, i), slide;
    fourlink_state other;
    geometry_slot x;
    int is_far = geometry_is_far(v, state, i), n = 0, k;

    x.block = block->origin;
    x.axis = block->axis;
    x.from = x.to = 0;
    x.link = v->design->group[i].hang == FOURLINK_HANGS_IN_SLOT ? v->design->group[i].link
                                                                : FOURLINK_FOLLOWER + 2 + 2 * i;
    for (k = 0; k < SLOT_STEPS; k++)
        if (fourlink_position(v->mechanism, state->branch, 2 * M_PI * k / SLOT_STEPS, &other) ==
                FOURLINK_OK &&
            !geometry_is_far(v, &other, i)) {
            slide = slide_of(v, &other, i) - here;
            x.from = is_far && n == 0 ? slide : GSL_MIN_DBL(x.from, slide);
            x.to = is_far && n == 0 ? slide : GSL_MAX_DBL(x.to, slide);
            n++;
        }
    return x;
}

fourlink_vector geometry_joint(const view *v, const fourlink_state *state, int joint)
{
    const fourlink_joint *j = &v->kind.joint[joint];

    return j->is_tip ? geometry_end(v, state, j->at) : state->link[j->at].origin;
}

/* Rod and crank are in one line,  x^2 + e^2 = (l - r)^2;  of a crank that does not turn fully the rod is
** across the stroke,  x^2 + (l - |e|)^2 = r^2.  At a change point the piston goes on to the other side. */
static double outer_end(const fourlink_mechanism *m)
{
    double r = m->design.link[FOURLINK_CRANK].length, l = m->design.link[FOURLINK_COUPLER].length;
    double e = fabs(m->design.offset);

    if (m->change_stretched || m->change_folded)
        return -m->dead_centre;
    return l - r > e ? sqrt((l - r - e) * (l - r + e)) : -sqrt((r - l + e) * (r + l - e));
}

void geometry_find_guide(const view *v, fourlink_branch branch, double *near, double *far)
{
    const fourlink_mechanism *m = v->mechanism;
    double sign = (double)branch, stroke = 2 * v->design->link[FOURLINK_CRANK].length;

    *near = v->kind.slotted ? m->dead_centre - stroke / fabs(m->slot.y) : sign * outer_end(m);
    *far = sign * m->dead_centre;
}

/* A slider is at its ends with the crank at 0 and at 180 deg, that of a yoke at +-90 deg. */
void geometry_find_way(const view *v, fourlink_branch branch, double *near, double *far)
{
    const fourlink_mechanism *m = v->mechanism;
    double a = v->design->link[FOURLINK_CRANK].length, e = v->design->offset;
    double sum = a + v->design->link[FOURLINK_GROUND].length;
    double sign = (double)branch;

    if (v->kind.guided) {
        *near = (-a - e) / m->slot.y;
        *far = (a - e) / m->slot.y;
        return;
    }
    *far = sign * sqrt(fabs((sum - m->h) * (sum + m->h)));
    *near = m->change_folded ? -*far : m->folded > 0 ? sign * sqrt(m->folded) : 0;
}

fourlink_vector geometry_on_slide(const fourlink_state *state, double along)
{
    const fourlink_vector *u = &state->link[FOURLINK_COUPLER].axis,
                          *B = &state->link[FOURLINK_COUPLER].origin;

    return place_in(*B, *u, along - state->s, 0);
}

double geometry_root(const view *v)
{
    return v->design->link[FOURLINK_FOLLOWER].length * v->mechanism->lever.x;
}

fourlink_vector geometry_force(const fourlink_load *load, const fourlink_state *state)
{
    const fourlink_vector none = {0, 0}, *F = &load->force;

    return load->frame == FOURLINK_FRAME_GROUND
               ? *F
               : place_in(none, state->link[load->link].axis, F->x, F->y);
}

double geometry_turn(const view *v)
{
    const fourlink_vector *g = &v->design->gravity;
    double turn = v->problem.axes_on_page  ? v->problem.x_angle
                  : g->x != 0 || g->y != 0 ? atan2(-g->x, -g->y)
                                           : 0;

    return fabs(turn) < 1e-9 ? 0 : turn;
}

int geometry_has_weight(const view *v)
{
    const fourlink_design *d = v->design;

    return (d->gravity.x != 0 || d->gravity.y != 0) &&
           (d->link[2].mass > 0 || d->link[3].mass > 0 || d->link[4].mass > 0);
}
