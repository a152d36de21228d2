/* SPDX-License-Identifier: GPL-3.0-or-later
**
** size.c - the room that a drawing needs.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "picture.h"
#include "view/geometry.h"

/* Of a panel that its drawing fills, in pixels: what is beside the axes, what is above and below them, and
** its limits; and the steps in which the motion is measured. */
#define BESIDE 330
#define ABOVE_AND_BELOW 110
#define LOWEST 330
#define HIGHEST 840
#define HIGHEST_FIGURE 520.0 /* with all its panels: two figures are a page */
#define OUTLINE_STEPS 72
#define PAD 0.4 /* of the larger side: room for arrows and texts around a motion */

int size_lines_beside(const picture *p, int each_link)
{
    int lines[FOURLINK_LINKS] = {0}, most = 0, sum = 0, last, link, g;
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
    for (g = 0; g < p->v.design->n_groups && p->v.problem.has_forces; g++) {
        const fourlink_group *group = &p->v.design->group[g];

        lines[group->link]++; /* -FP, or FP */
        lines[group->to]++;
        sum += 1 + (group->to <= FOURLINK_GROUND);
    }
    last = FOURLINK_LAST_LINK(p->v.design);
    for (link = FOURLINK_CRANK; link <= last; link++) {
        sum += lines[link] + (tracks_link(&p->v, link)->mass > 0);
        most = lines[link] > most ? lines[link] : most;
    }
    if (p->v.problem.has_forces)
        sum += 8; /* pin forces, torque, what the arrows mean, and which are left out */
    if (p->request->file == PLOT_TXT)
        sum += 3; /* the links in the key */
    return each_link ? 8 + most : 10 + sum + (int)p->v.problem.n_points;
}

/* The room that the mechanism needs on a branch. */
static place_box box_of_motion(const picture *p, fourlink_branch branch)
{
    double c = cos(geometry_turn(&p->v)), s = sin(geometry_turn(&p->v));
    place_box b = place_nothing;
    fourlink_instant now;
    tracks places;
    int k, i;

    for (k = 0; k <= OUTLINE_STEPS; k++) {
        if (picture_state(p, branch, k, OUTLINE_STEPS, &now) != FOURLINK_OK)
            continue;
        tracks_find_places(&places, &p->v, &now.state);
        for (i = 0; i < TRACK_COUNT; i++) {
            const fourlink_vector *at = &places.list[i].v;

            if (tracks_is_outline(&places, i))
                place_grow(&b, c * at->x - s * at->y, s * at->x + c * at->y);
        }
        for (i = 0; i < p->v.design->n_groups; i++) {
            geometry_output x = geometry_find_output(&p->v, &now.state, i);

            if (!geometry_is_far(&p->v, &now.state, i))
                place_grow(&b, c * x.Q.x - s * x.Q.y, s * x.Q.x + c * x.Q.y);
            if (p->v.design->group[i].end == FOURLINK_GROUP_TURNS)
                place_grow(&b, c * x.D.x - s * x.D.y, s * x.D.x + c * x.D.y);
        }
    }
    return b;
}

double size_of_motion(const picture *p)
{
    double size = 0;
    int i;

    for (i = 0; i < p->v.n_branches; i++) {
        place_box b = box_of_motion(p, p->v.branches[i]);

        size = GSL_MAX_DBL(size, GSL_MAX_DBL(b.x_max - b.x_min, b.y_max - b.y_min));
    }
    return size;
}

double size_aspect(const picture *p)
{
    double x, y, pad;
    place_box all = place_nothing, b;
    int i;

    for (i = 0; i < p->v.n_branches; i++) {
        b = box_of_motion(p, p->v.branches[i]);
        if (!place_is_empty(&b)) {
            place_grow(&all, b.x_min, b.y_min);
            place_grow(&all, b.x_max, b.y_max);
        }
    }
    x = all.x_max - all.x_min;
    y = all.y_max - all.y_min;
    pad = PAD * GSL_MAX_DBL(x, y);
    return x >= 0 && pad > 0 ? (x + pad) / (y + pad) : 1;
}

#define SMALL_LINK 0.08 /* of the drawing */

void size_find_insets(picture *p)
{
    double size = SMALL_LINK * size_of_motion(p);

    p->n_insets = 0;
    if (p->v.design->link[FOURLINK_CRANK].length < size)
        p->insets[p->n_insets++] = FOURLINK_CRANK;
    if (p->v.kind.shape[FOURLINK_FOLLOWER] == FOURLINK_SHAPE_BAR &&
        p->v.design->link[FOURLINK_FOLLOWER].length < size)
        p->insets[p->n_insets++] = FOURLINK_FOLLOWER;
}

double size_height(const picture *p, double width)
{
    double highest = LOWEST, x, y, border, of_figure;
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
    of_figure = GSL_MAX_DBL(HIGHEST_FIGURE / (p->v.n_branches * (1 + p->n_insets)), LOWEST);
    return GSL_MIN_DBL(highest, p->request->is_figure ? of_figure : HIGHEST);
}
