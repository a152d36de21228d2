/* SPDX-License-Identifier: GPL-3.0-or-later
**
** animation.c - the mechanism in motion, from first to last.
*/
#include "figure.h"
#include "moving.h"
#include "plot.h"
#include "wanted.h"

#define FRAMES PLOT_FRAMES

/* Draw a frame. */
static void draw_frame(picture *p, const void *what, int k)
{
    const fourlink_branch *branch = what;
    fourlink_instant now;
    sketch s;

    if (picture_state(p, *branch, k, FRAMES, &now) != FOURLINK_OK)
        return;
    if (p->on.motion->phase == LABELS_DRAW)
        picture_begin_frame(p);
    figure_open(&s, p, *branch);
    figure_paths(&s, p, *branch);
    wanted_draw(&s, p);
    figure_frame(&s, p, &now.state);
    figure_draw(&s, p, &now.state, 0);
    spring_draw(&s, p, &now.state, 0);
    sketch_close(&s, "%s", fourlink_branch_text((int)*branch));
}

const char *picture_animation(picture *p, fourlink_branch branch)
{
    fourlink_instant now;
    place_box range = place_nothing;
    int k, status = FOURLINK_OK;

    for (k = 0; k < FRAMES; k++) {
        status = picture_state(p, branch, k, FRAMES, &now);
        if (status == FOURLINK_OK)
            break;
    }
    if (k == FRAMES)
        return fourlink_status_text(status);
    moving_run(p, &range, FRAMES, draw_frame, &branch);
    return NULL;
}
