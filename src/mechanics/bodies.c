/* SPDX-License-Identifier: GPL-3.0-or-later
**
** bodies.c - the moving links as bodies, each cut free of the others, for callers.
*/
#include "kind.h"

int fourlink_bodies(const fourlink_mechanism *mechanism, const fourlink_state *state,
                    const fourlink_load *loads, unsigned long n_loads,
                    fourlink_body body[FOURLINK_LINKS])
{
    const flk_kind *kind;
    unsigned long n;
    int i, status = flk_kind_find(mechanism, body, &kind);

    if (status == FOURLINK_OK)
        status = state ? flk_check_loads(mechanism, loads, n_loads) : FOURLINK_NULL;
    if (status != FOURLINK_OK)
        return status;
    for (i = FOURLINK_CRANK; i <= FLK_LAST_LINK(mechanism); i++) {
        const fourlink_link *data = FLK_LINK(mechanism, i);
        const fourlink_link_state *link = &state->link[i];
        fourlink_body *b = &body[i];

        FLK_PLACE_MASS(data, link, b->arm, b->k, b->acceleration);
        b->weight.x = data->mass * mechanism->design.gravity.x;
        b->weight.y = data->mass * mechanism->design.gravity.y;
        b->force.x = b->force.y = b->moment = b->work = 0;
    }
    for (n = 0; n < n_loads; n++) {
        const fourlink_load *load = &loads[n];
        const fourlink_link_state *link = &state->link[load->link];
        fourlink_body *b = &body[load->link];
        fourlink_vector r, F, k;

        FLK_PLACE_LOAD(load, link, r, F, k);
        b->work += FLK_DOT(F, k) + load->torque * link->k;
        r.x -= b->arm.x;
        r.y -= b->arm.y;
        b->force.x += F.x;
        b->force.y += F.y;
        b->moment += load->torque + FLK_CROSS(r, F);
    }
    return FOURLINK_OK;
}
