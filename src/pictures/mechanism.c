/* SPDX-License-Identifier: GPL-3.0-or-later
**
** mechanism.c - the mechanism with its loads and pin forces, at one or several positions; and its
** motion from first to last.
*/
#include "arrow.h"
#include "picture.h"
#include "tables/print.h"

#define GHOSTS 12
#define FRAMES 60

/* The longest arrow of a force, as a fraction of the drawing. */
#define LONGEST 0.22

/* Loads, weights and pin forces. */
static void draw_forces(sketch *s, const analysis *a, const result *r)
{
    static const fourlink_vector crankshaft = {0, 0};
    const deck *d = a->d;
    const fourlink_forces *f = &r->forces;
    figure_pins pins = figure_place(d, &r->state);
    arrow_list arrows;
    double scale;
    int link;

    arrows.n = 0;
    arrow_add(&arrows, PEN_FORCE, "F12", pins.A, f->F12x, f->F12y);
    arrow_add(&arrows, PEN_FORCE, "F23", pins.B, f->F23x, f->F23y);
    arrow_add(&arrows, PEN_FORCE, "F34", pins.C, f->F34x, f->F34y);
    if (d->design.kind == FOURLINK_FOUR_BAR)
        arrow_add(&arrows, PEN_FORCE, "F14", pins.D, f->F14x, f->F14y);
    else
        arrow_add(&arrows, PEN_FORCE, "N", pins.C, 0, f->F14y);
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
        arrow_add_loads(&arrows, a, r, link);
    if (arrows.n) {
        scale = LONGEST * s->size / arrow_largest(&arrows);
        arrow_draw(&arrows, s, d, scale);
        arrow_draw_scale(s, d, QUANTITY_FORCE, scale, arrow_largest(&arrows));
    }
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
        arrow_draw_load_torques(s, a, r, link);
    arrow_draw_torque(s, d, PEN_FORCE, "Ts", crankshaft, f->Ts);
}

/* Rows spread over the motion, grey. */
static void draw_ghosts(sketch *s, analysis *a, fourlink_branch branch)
{
    unsigned long n = a->range.n_rows, i;
    result r;

    for (i = 0; n > 1 && i < GHOSTS; i++) {
        analysis_row(a, branch, (unsigned long)((double)(n - 1) * (double)i / GHOSTS), &r);
        if (r.status == FOURLINK_OK)
            figure_outline(s, PEN_GHOST, a->d, &r.state);
    }
}

/* The other positions of the request, thin, each with its angle at the crank pin. */
static void draw_others(sketch *s, analysis *a, fourlink_branch branch, const plot_request *request)
{
    char words[200], number[FORMAT_SIZE], letter[PRINT_MARK];
    result r;
    int k;

    for (k = 1; k < request->n_angles; k++) {
        fourlink_motion_at(&a->d->motion, request->angles[k], &r.row);
        analysis_at(a, branch, &r.row.crank, &r);
        print_angle(r.row.angle, number);
        if (r.status == FOURLINK_OK) {
            figure_pins pins = figure_place(a->d, &r.state);

            figure_outline(s, PEN_OTHER, a->d, &r.state);
            figure_letter(s, pins.B, pins.A, pins.A, print_mark(a->d, r.row.angle, letter));
        } else {
            sketch_note(s, flk_text_join(words, sizeof words, number, ": none, see the table",
                                         (char *)NULL));
        }
    }
}

static void draw(sketch *s, analysis *a, const plot_request *request, result *r)
{
    if (request->n_angles == 0 && request->file != PLOT_TXT)
        draw_ghosts(s, a, r->branch);
    figure_paths(s, a, r->branch, NULL);
    figure_frame(s, a->d, &r->state);
    draw_others(s, a, r->branch, request);
    plot_position(a, r->branch, request, r); /* its loads again */
    figure_links(s, a->d, &r->state);
    figure_letters(s, a->d, &r->state);
    figure_angles(s, a->d, &r->state);
    figure_slope(s, a->d);
    if (a->d->has_forces)
        draw_forces(s, a, r);
}

int plot_mechanism(canvas *on, analysis *a, const plot_request *request, const char **why)
{
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i, drawn = 0;
    char title[FIGURE_TITLE];
    result r;
    sketch s;

    canvas_begin(on);
    for (i = 0; i < n; i++) {
        int status = plot_position(a, branches[i], request, &r);

        if (status != FOURLINK_OK) {
            *why = fourlink_status_text(status);
            continue;
        }
        figure_open(&s, on, a, branches[i], 0);
        draw(&s, a, request, &r);
        sketch_close(&s, figure_title(a->d, &r, title), a->d->units[QUANTITY_LENGTH].name);
        drawn++;
    }
    canvas_end(on);
    return drawn > 0;
}

int plot_animation(canvas *on, analysis *a, const char **why)
{
    fourlink_branch branch = a->d->open ? FOURLINK_OPEN : FOURLINK_CROSSED;
    char title[FIGURE_TITLE];
    int k, drawn = 0;
    result r;
    sketch s;

    for (k = 0; k < FRAMES; k++) {
        analysis_spread(a, k, FRAMES, &r.row);
        analysis_at(a, branch, &r.row.crank, &r);
        if (r.status != FOURLINK_OK) {
            *why = fourlink_status_text(r.status);
            continue;
        }
        figure_open(&s, on, a, branch, 1);
        canvas_heading(on);
        figure_paths(&s, a, branch, &r.row.angle);
        figure_frame(&s, a->d, &r.state);
        figure_links(&s, a->d, &r.state);
        figure_letters(&s, a->d, &r.state);
        figure_slope(&s, a->d);
        sketch_close(&s, figure_title(a->d, &r, title), a->d->units[QUANTITY_LENGTH].name);
        drawn++;
    }
    return drawn > 0;
}
