/* SPDX-License-Identifier: GPL-3.0-or-later
**
** mechanism.c - the mechanism with its loads and pin forces, at one or several positions.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "arrow.h"
#include "mechanism.h"
#include "plot.h"
#include "wanted.h"
#include "view/rounding.h"

#define GHOSTS 12

/* The longest force arrow, as a fraction of the drawing. */
#define LONGEST 0.22

/* The size of an inset, in lengths of its link; and half its side, which has room for arrows at the link's
** end. */
#define INSET 2.6
#define HALF_SIDE (1.1 + LONGEST * INSET)

/* Add the forces of the springs, which have their names and values at the springs. */
static void add_springs(arrow_list *arrows, const picture_row *r)
{
    int i;

    for (i = 0; i < r->drawn.n_forces; i++) {
        const scene_force *f = &r->drawn.forces[i];
        fourlink_vector F = tracks_vector(&r->numbers, f->of);

        if (f->load == FOURLINK_LOAD_SPRING)
            arrow_add(arrows, i, tracks_body(&r->numbers, f->at), PEN_LOAD, "",
                      tracks_vector(&r->numbers, f->at), F.x, F.y);
    }
}

/* Add the forces of the pins, for the ground, or the loads on a link. */
static void add_forces(arrow_list *arrows, const picture_row *r, int link)
{
    int i;

    for (i = 0; i < r->drawn.n_forces; i++) {
        const scene_force *f = &r->drawn.forces[i];

        if (link == FOURLINK_GROUND ? f->sort == SCENE_PIN && f->sign > 0
                                    : f->sort == SCENE_LOAD && f->on == link && !f->is_inner)
            arrow_add_force(arrows, r, i);
    }
}

/* List the forces of a position; returns 1 if springs are among them. */
static int list_forces(arrow_list *arrows, const picture_row *r)
{
    int link, n;

    arrows->n = 0;
    for (link = FOURLINK_GROUND; link <= r->now.state.last; link++)
        add_forces(arrows, r, link);
    n = arrows->n;
    add_springs(arrows, r);
    return arrows->n > n;
}

/* Draw loads, weights and pin forces on the scale of the largest of the motion; of an inset those that act
** in it. */
static void draw_forces(sketch *s, const picture *p, const picture_row *r, double largest)
{
    static const fourlink_vector crankshaft = {0, 0};
    arrow_list arrows;
    double scale;
    int has_springs = list_forces(&arrows, r), link, i;

    arrow_cut(&arrows, s);
    if (arrows.n) {
        largest = arrow_longest(&arrows, largest);
        scale = LONGEST * s->size / largest;
        if (arrow_draw(&arrows, s, p, scale, largest) && !s->is_window)
            arrow_note_missing(s, p, largest);
        arrow_draw_scale(s, p, QUANTITY_FORCE, scale, largest);
    }
    for (link = FOURLINK_CRANK; link <= r->now.state.last; link++)
        arrow_draw_load_torques(s, p, r, link, 0);
    arrow_draw_torque(s, p, 0, FOURLINK_GROUND, PEN_FORCE, "T" SUB_S, crankshaft,
                      view_driving_torque(&p->v, &r->now.forces));
    if (s->is_window)
        return;
    sketch_show(s, SKETCH_MEANING, 0);
    sketch_key(s, PEN_FORCE,
               p->v.design->n_groups ? "pin force, i on j, on an output" : "pin force, i on j");
    for (i = 0; i < arrows.n && arrows.list[i].kind != PEN_LOAD; i++)
        ;
    sketch_show(s, SKETCH_MEANING, has_springs ? 2 : 1);
    if (i < arrows.n)
        sketch_key(s, PEN_LOAD, has_springs ? "load, weight, spring" : "load or weight");
}

/* Draw rows spread over the motion, or over its first turn, in grey. */
static void draw_ghosts(sketch *s, const picture *p, fourlink_branch branch)
{
    double turn = view_value(&p->v, QUANTITY_ANGLE, p->v.problem.cycle);
    double turns = fabs(p->v.end - p->v.problem.motion.from) / turn;
    unsigned long n = p->v.range.n_rows, i, row;
    fourlink_instant now;

    if (turns > 1 && p->v.problem.over.is_crank_angle)
        n = 1 + (unsigned long)((double)(n - 1) / turns);
    for (i = 0; n > 1 && i < GHOSTS; i++) {
        row = (unsigned long)((double)(n - 1) * (double)i / GHOSTS);
        if (fourlink_results_row(p->v.results, branch, row, NULL, &now, NULL) == FOURLINK_OK)
            figure_outline(s, p, &now.state, PEN_GHOST);
    }
}

/* Draw the other positions of the request thin, with the angle at the crank pin. */
static void draw_others(sketch *s, const picture *p, fourlink_branch branch)
{
    char letter[PICTURE_MARK];
    fourlink_instant now;
    int k;

    for (k = 1; k < p->n_spots; k++)
        if (view_find_spot(&p->v, branch, &p->spots[k], NULL, &now, NULL) == FOURLINK_OK) {
            figure_pins pins = figure_place(p, &now.state);

            figure_outline(s, p, &now.state, PEN_OTHER);
            figure_letter(s, pins.B, pins.A, pins.A, picture_mark(p, now.row.angle, 4, letter));
        } else {
            sketch_note(s, "%g: no position, see the table", now.row.angle);
        }
}

void mechanism_draw_inset(picture *p, const picture_row *r, int link, double largest)
{
    const fourlink_state *state = &r->now.state;
    figure_pins pins = figure_place(p, state);
    double length = p->v.design->link[link].length;
    sketch s;

    figure_open(&s, p, state->branch);
    s.size = INSET * length;
    sketch_window(&s, link == FOURLINK_CRANK ? pins.A : pins.D, HALF_SIDE * length);
    figure_frame(&s, p, state);
    figure_draw(&s, p, state, 1);
    spring_draw(&s, p, state, 0);
    if (p->v.problem.has_forces)
        draw_forces(&s, p, r, largest);
    s.n_notes = 0; /* they are beside the whole */
    sketch_close(&s, "at the %s, enlarged", p->v.kind.link[link]);
}

const char *picture_mechanism(picture *p, fourlink_branch branch)
{
    picture_row r;
    sketch s;
    int status = picture_row_find(p, branch, &r), i;

    if (status != FOURLINK_OK)
        return fourlink_status_text(status);
    figure_open(&s, p, branch);
    if (p->n_spots == 0 && p->request->file != PLOT_TXT)
        draw_ghosts(&s, p, branch);
    figure_paths(&s, p, branch);
    wanted_draw(&s, p);
    figure_frame(&s, p, &r.now.state);
    draw_others(&s, p, branch);
    figure_draw(&s, p, &r.now.state, 1);
    spring_draw(&s, p, &r.now.state, 1);
    if (p->v.problem.has_forces)
        draw_forces(&s, p, &r, arrow_largest_of_motion(p, branch));
    sketch_note(&s, "1 ground, 2 crank,");
    sketch_note(&s, "3 %s, 4 %s", p->v.kind.link[FOURLINK_COUPLER],
                p->v.kind.link[FOURLINK_FOLLOWER]);
    figure_gravity(&s, p);
    figure_close(&s, p, &r.now, "");
    for (i = 0; i < p->n_insets; i++)
        mechanism_draw_inset(p, &r, p->insets[i], 0);
    return NULL;
}

/* Draw the crank where the linkage cannot be assembled, and why it cannot. */
static void draw_crank(sketch *s, const picture *p, const picture_row *r)
{
    fourlink_vector A = tracks_vector(&r->numbers, TRACK_A),
                    B = tracks_vector(&r->numbers, TRACK_B);
    double length = place_distance(A, B);

    sketch_show(s, SKETCH_FRAME, 0);
    sketch_support(s, A);
    if (!p->v.kind.guided)
        sketch_support(s, place_at(p->v.design->link[FOURLINK_GROUND].length, 0));
    sketch_body(s, FOURLINK_CRANK, A, place_at((B.x - A.x) / length, (B.y - A.y) / length));
    sketch_show(s, SKETCH_LINK, FOURLINK_CRANK);
    sketch_with(s, FOURLINK_CRANK);
    sketch_line(s, PEN_CRANK, A, B);
    sketch_show(s, SKETCH_PIN, 0);
    sketch_pin(s, A, "A");
    sketch_show(s, SKETCH_PIN, 1);
    sketch_with(s, FOURLINK_CRANK);
    sketch_pin(s, B, "B");
    sketch_show(s, SKETCH_MISSING, 1);
    sketch_value(s, "", fourlink_status_text(r->now.status), "");
}

void mechanism_draw(picture *p, const picture_row *r, double largest)
{
    sketch s;
    int link;

    figure_open(&s, p, r->now.branch);
    figure_paths(&s, p, r->now.branch);
    wanted_draw(&s, p);
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++) {
        sketch_show(&s, SKETCH_LINK, (unsigned long)link);
        sketch_key(&s, (pen)link, p->v.kind.link[link]);
    }
    if (r->now.status == FOURLINK_OK) {
        figure_frame(&s, p, &r->now.state);
        figure_draw(&s, p, &r->now.state, 1);
        spring_draw(&s, p, &r->now.state, 1);
        if (p->v.problem.has_forces)
            draw_forces(&s, p, r, largest);
    } else {
        draw_crank(&s, p, r);
    }
    figure_gravity(&s, p);
    sketch_close(&s, "");
}
