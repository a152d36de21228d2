/* SPDX-License-Identifier: GPL-3.0-or-later
**
** exercise.c - the figure of an exercise: what is given, and symbols for what is asked.
**
** Nothing that is computed is told: the links stand as they do at the first crank angle that is asked for,
** without the values of the axes.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/quantity.h"
#include "figure.h"
#include "plot.h"
#include "view/results.h"
#include "view/rounding.h"

#define LONGEST 0.16 /* the longest arrow of a load, as a fraction of the drawing */
#define TORQUE 0.07

/* 1 if an input is told: sizes, masses, the speed, the loads. */
static int is_told(const fourlink_value *x)
{
    static const char *const endings[] = {".length", ".offset", ".stroke", ".mass"};
    size_t i;

    if (strcmp(x->quantity, "number") == 0)
        return 0;
    if (strncmp(x->name, "load ", 5) == 0 || strcmp(x->name, "motion.speed") == 0)
        return 1;
    for (i = 0; i < sizeof endings / sizeof *endings; i++)
        if (flk_text_ends_in(flk_text_of(x->name), endings[i]))
            return 1;
    return 0;
}

/* Put what is given beside the drawing: "crank = 20 mm", "coupler mass = 0.3 kg". */
static void put_given(sketch *s, const picture *p, const fourlink_instant *now)
{
    const fourlink_value *list;
    fourlink_value x;
    char name[80], mark[PICTURE_MARK], number[FORMAT_SIZE];
    unsigned long n, i;
    char *dot;

    sketch_show(s, SKETCH_OTHER, 1);
    sketch_note(s, "given:");
    fourlink_results_list(p->v.results, FOURLINK_INPUTS, &list, &n);
    for (i = 0; i < n; i++) {
        if (!is_told(&list[i]) ||
            fourlink_results_input(p->v.results, list[i].name, &x) != FOURLINK_OK ||
            gsl_isnan(x.value))
            continue;
        flk_text_copy(flk_text_of(list[i].name), name, sizeof name);
        dot = strrchr(name, '.');
        if (strcmp(name, "motion.speed") == 0)
            strcpy(name, "speed");
        else if (dot && strcmp(dot, ".length") == 0)
            *dot = '\0';
        else if (dot)
            *dot = ' ';
        sketch_note(s, "%s = %s %s", name, format_general(x.value, 6, number), x.unit);
    }
    sketch_note(s, FIGURE_THETA SUB_2 " = %s", picture_mark(p, now->row.angle, 7, mark));
}

/* Put the names of what is asked beside the drawing, each once; has_angle: the links whose angles are
** among them. */
static void put_asked(sketch *s, const picture *p, int has_angle[5])
{
    char names[600] = " ", name[80];
    fourlink_check c;
    unsigned long i;

    memset(has_angle, 0, 5 * sizeof *has_angle);
    sketch_show(s, SKETCH_OTHER, 2);
    for (i = 0; i < p->v.problem.n_expected && results_check(p->v.results, i, &c); i++) {
        has_angle[3] |= strcmp(c.name, "theta3") == 0;
        has_angle[4] |= strcmp(c.name, "theta4") == 0;
        sprintf(name, " %s ", c.name);
        if (strstr(names, name) || strlen(names) + strlen(name) >= sizeof names)
            continue;
        sketch_note(s, names[1] ? "%s" : "asked: %s", c.name);
        strcat(names, name + 1);
    }
}

/* Draw the loads of the deck, with their names alone. */
static void draw_loads(sketch *s, const picture_row *r)
{
    double largest = 0;
    int i;

    for (i = 0; i < r->drawn.n_forces; i++)
        if (r->drawn.forces[i].load == FOURLINK_LOAD_OWN) {
            fourlink_vector F = tracks_vector(&r->numbers, r->drawn.forces[i].of);

            largest = GSL_MAX_DBL(largest, gsl_hypot(F.x, F.y));
        }
    for (i = 0; i < r->drawn.n_forces && largest > 0; i++) {
        const scene_force *f = &r->drawn.forces[i];
        fourlink_vector at = tracks_vector(&r->numbers, f->at),
                        F = tracks_vector(&r->numbers, f->of), end;

        if (f->load != FOURLINK_LOAD_OWN || f->is_inner || gsl_hypot(F.x, F.y) == 0)
            continue;
        end = place_in(at, F, LONGEST * s->size / largest, 0);
        sketch_show(s, SKETCH_FORCE, (unsigned long)i);
        sketch_arrow(s, PEN_LOAD, at, end);
        sketch_text(s, end, F.x, F.y, f->name);
    }
    for (i = 0; i < r->drawn.n_torques; i++) {
        const scene_force *f = &r->drawn.torques[i];
        fourlink_vector at = tracks_vector(&r->numbers, f->at);
        double torque = tracks_vector(&r->numbers, f->of).x;

        if (f->load != FOURLINK_LOAD_OWN || torque == 0)
            continue;
        sketch_show(s, SKETCH_TORQUE, (unsigned long)i);
        sketch_torque(s, PEN_LOAD, at, TORQUE * s->size, torque);
        sketch_text(s, place_beside(at, TORQUE * s->size, 0), 1, 0, f->name);
    }
}

/* Show the first crank angle that is asked for, unless another one is. */
static void choose_position(picture *p)
{
    fourlink_check c;
    unsigned long i;

    for (i = 0; i < p->v.problem.n_expected && !p->n_spots; i++)
        if (results_check(p->v.results, i, &c) && c.has_angle && !c.has_place) {
            memset(&p->spots[0], 0, sizeof p->spots[0]);
            p->spots[0].at = c.angle;
            p->n_spots = 1;
        }
}

const char *picture_exercise(picture *p, fourlink_branch branch)
{
    int has_angle[5], status;
    picture_row r;
    sketch s;

    choose_position(p);
    p->on.has_no_scale = 1;
    status = picture_row_find(p, branch, &r);
    if (status != FOURLINK_OK)
        return fourlink_status_text(status);
    figure_open(&s, p, branch);
    figure_frame(&s, p, &r.now.state);
    figure_draw(&s, p, &r.now.state, 0);
    put_given(&s, p, &r.now);
    put_asked(&s, p, has_angle);
    figure_arc(&s, p, &r.now.state, FOURLINK_CRANK);
    if (has_angle[3])
        figure_arc(&s, p, &r.now.state, FOURLINK_COUPLER);
    if (has_angle[4])
        figure_arc(&s, p, &r.now.state, FOURLINK_FOLLOWER);
    draw_loads(&s, &r);
    figure_gravity(&s, p);
    sketch_close(&s, "%s", fourlink_branch_text((int)branch));
    return NULL;
}
