/* SPDX-License-Identifier: GPL-3.0-or-later
**
** size.c - the room that a drawing needs.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "picture.h"
#include "place.h"
#include "view/geometry.h"

/* Of a panel that its drawing fills, in pixels: what is beside the axes, what is above and below them, and
** its limits; and the steps in which the motion is measured. */
#define BESIDE 330
#define ABOVE_AND_BELOW 110
#define LOWEST 330
#define HIGHEST 600 /* two of them are a page */
#define OUTLINE_STEPS 72

int size_lines_beside(const picture *p, int each_link)
{
    int lines[FOURLINK_FOLLOWER + 1] = {0}, most = 0, sum = 0, link;
    fourlink_load_info load;
    unsigned long i;

    for (i = 0; fourlink_deck_load(p->v.deck, i, &load) == FOURLINK_OK; i++)
        if (load.sort == FOURLINK_LOAD_OWN)
            lines[load.link] += load.has_torque ? 2 : 1;
        else if (load.sort == FOURLINK_LOAD_SPRING && each_link)
            lines[load.link]++;
        else if (load.sort == FOURLINK_LOAD_GAS)
            lines[FOURLINK_FOLLOWER]++;
    if (!each_link)
        lines[FOURLINK_FOLLOWER] += (int)p->v.problem.n_springs;
    if (p->v.problem.has_friction) /* of the guide, and the circles of the pins */
        lines[FOURLINK_FOLLOWER] += 2;
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++) {
        sum += lines[link] + (p->v.design->link[link].mass > 0);
        most = lines[link] > most ? lines[link] : most;
    }
    if (p->v.problem.has_forces)
        sum += 9; /* pin forces, torque, and what the arrows mean */
    return each_link ? 7 + most : 8 + sum + (int)p->v.problem.n_points;
}

static void grow(place_box *b, double turn, int link, const fourlink_vector *at,
                 const fourlink_state *state)
{
    fourlink_vector place = geometry_of_link(state, link, at);

    place_grow(b, cos(turn) * place.x - sin(turn) * place.y,
               sin(turn) * place.x + cos(turn) * place.y);
}

/* The room that the mechanism needs on a branch. */
static place_box box_of_motion(const picture *p, fourlink_branch branch)
{
    fourlink_vector origin = {0, 0}, C = place_at(p->v.design->link[3].length, 0), at;
    place_box b = place_nothing;
    fourlink_instant now;
    fourlink_spring spring;
    double turn = geometry_turn(&p->v);
    const char *name;
    unsigned long i;
    int k, link;

    for (k = 0; k <= OUTLINE_STEPS; k++) {
        if (picture_state(p, branch, k, OUTLINE_STEPS, &now) != FOURLINK_OK)
            continue;
        for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
            grow(&b, turn, link, &origin, &now.state);
        grow(&b, turn, FOURLINK_COUPLER, &C, &now.state);
        for (i = 0; i < p->v.problem.n_points; i++) {
            fourlink_deck_point(p->v.deck, i, &name, &link, &at);
            grow(&b, turn, link, &at, &now.state);
        }
        for (i = 0; i < p->v.problem.n_springs; i++) {
            fourlink_deck_spring(p->v.deck, i, NULL, &spring);
            grow(&b, turn, spring.link, spring.is_torsional ? &origin : &spring.at, &now.state);
            grow(&b, turn, spring.to, spring.is_torsional ? &origin : &spring.to_at, &now.state);
        }
    }
    return b;
}

double size_height(const picture *p, double width)
{
    double highest = LOWEST, x, y, border;
    int i;

    for (i = 0; i < p->v.n_branches; i++) {
        place_box b = box_of_motion(p, p->v.branches[i]);

        x = b.x_max - b.x_min;
        y = b.y_max - b.y_min;
        border = 0.35 * GSL_MAX_DBL(x, y);
        if (x > 0 && y >= 0)
            highest = GSL_MAX_DBL(highest,
                                  (width - BESIDE) * (y + border) / (x + border) + ABOVE_AND_BELOW);
    }
    return GSL_MIN_DBL(highest, HIGHEST);
}
