/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_output_forces.c - the forces in outputs in the sample calculation, as in mechanics/group_rod.c and
** group_slot.c, and what they do to the links that carry them.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "sample_output_forces.h"
#include "sample_sides.h"
#include "sample_template.h"

static double cross(fourlink_vector u, fourlink_vector v)
{
    return u.x * v.y - u.y * v.x;
}

static int is_slider(const sample_output *o)
{
    return o->group->end == FOURLINK_GROUP_SLIDES;
}

/* ---------------------------------------------------------------------------------- centres of mass */

static void put_centre(const sample_output *o, const fourlink_body *b, int link)
{
    static const char *const names[2][4] = {{"rho5x", "rho5y", "aG5x", "aG5y"},
                                            {"rho6x", "rho6y", "aG6x", "aG6y"}},
                             *const of_rod[2] = {"aPx - alpha5 * rho5y - omega5 ^2 * rho5x",
                                                 "aPy + alpha5 * rho5x - omega5 ^2 * rho5y"},
                             *const of_slider[2] = {"sddot6 * cos theta6", "sddot6 * sin theta6"},
                             *const of_rocker[2] = {"- alpha6 * rho6y - omega6 ^2 * rho6x",
                                                    "alpha6 * rho6x - omega6 ^2 * rho6y"},
                             *const of_floating[2] = {"aD6x - alpha6 * rho6y - omega6 ^2 * rho6x",
                                                      "aD6y + alpha6 * rho6x - omega6 ^2 * rho6y"};
    const char *const *name = names[link % 2 == 0];
    const char *const *equation = link % 2                         ? of_rod
                                  : is_slider(o)                   ? of_slider
                                  : o->group->to > FOURLINK_GROUND ? of_floating
                                                                   : of_rocker;

    page_print(o->m->p, "<p>Link %d, <b>%s</b>, from its pin %s:</p>\n<ul class=\"given\">\n", link,
               fourlink_deck_link_text(o->r->v.deck, link),
               link % 2       ? "P"
               : is_slider(o) ? "Q"
                              : "D");
    sample_output_given(o, name[0], b->arm.x);
    sample_output_given(o, name[1], b->arm.y);
    page_print(o->m->p, "</ul>\n");
    sample_output_let(o, name[2], equation[0], b->acceleration.x);
    sample_output_let(o, name[3], equation[1], b->acceleration.y);
}

void sample_put_output_centres(report *r, math *m, const fourlink_body bodies[FOURLINK_LINKS])
{
    int i, k;

    for (i = 0; i < r->v.design->n_groups; i++) {
        sample_output o = sample_output_of(r, m, i);

        for (k = 0; k < 2; k++)
            if (o.group->body[k].mass > 0)
                put_centre(&o, &bodies[FOURLINK_ROD_OF(i) + k], FOURLINK_ROD_OF(i) + k);
    }
}

/* ----------------------------------------------------------------------------- what outputs do to links */

static sample_pins pins_of(const fourlink_group *g, const fourlink_link_state *rod,
                           const double x[6])
{
    fourlink_vector n;
    sample_pins f;

    n.x = -rod->axis.y;
    n.y = rod->axis.x;
    memset(&f, 0, sizeof f);
    f.FP.x = g->hang == FOURLINK_HANGS_IN_SLOT ? x[0] * n.x : x[0];
    f.FP.y = g->hang == FOURLINK_HANGS_IN_SLOT ? x[0] * n.y : x[1];
    f.FQ.x = g->hang == FOURLINK_HANGS_BY_OWN_SLOT ? x[2] * n.x : x[2];
    f.FQ.y = g->hang == FOURLINK_HANGS_BY_OWN_SLOT ? x[2] * n.y : x[3];
    if (g->end == FOURLINK_GROUP_SLIDES) {
        f.N = x[4];
        f.M = x[5];
    } else {
        f.FD.x = x[4];
        f.FD.y = x[5];
    }
    return f;
}

/* The arm of the point of a link where an output acts, from the link's origin. */
static fourlink_vector arm_of(const report *r, const sample_output *o)
{
    const fourlink_link_state *link = r->now.state.link, *on = &link[sample_output_link(o)];
    fourlink_vector at = o->is_about_pivot ? o->group->pivot : o->group->at, arm;

    if (!o->is_about_pivot && o->group->hang == FOURLINK_HANGS_IN_SLOT) {
        arm.x = link[FOURLINK_ROD_OF(o->i)].origin.x - on->origin.x;
        arm.y = link[FOURLINK_ROD_OF(o->i)].origin.y - on->origin.y;
    } else {
        arm.x = at.x * on->axis.x - at.y * on->axis.y;
        arm.y = at.x * on->axis.y + at.y * on->axis.x;
    }
    return arm;
}

/* The moment of the force -F on a link, about its centre of mass, or about the origin of one of an output. */
static double moment_of(const sample_output *o, const fourlink_body bodies[FOURLINK_LINKS],
                        fourlink_vector F)
{
    int on = sample_output_link(o);
    fourlink_vector arm = arm_of(o->r, o);

    if (on <= FOURLINK_FOLLOWER) {
        arm.x -= bodies[on].arm.x;
        arm.y -= bodies[on].arm.y;
    }
    return -cross(arm, F);
}

static void carry(sample_carried *found, const sample_output *o,
                  const fourlink_body bodies[FOURLINK_LINKS], fourlink_vector F)
{
    int on = sample_output_link(o);

    found->force[on].x -= F.x;
    found->force[on].y -= F.y;
    found->moment[on] += moment_of(o, bodies, F);
}

void sample_find_carried(report *r, const fourlink_body bodies[FOURLINK_LINKS], int drives,
                         sample_carried *found)
{
    double A[6][6], x[6];
    int i;

    memset(found, 0, sizeof *found);
    for (i = 0; i < r->v.design->n_groups; i++) {
        sample_output o = sample_output_of(r, NULL, i);
        fourlink_instant now = r->now;

        now.forces.drive *= drives && r->v.mechanism->drive;
        if (view_group_system(&r->v, &now, r->loads, i, A, found->b[i], x) != FOURLINK_OK)
            continue;
        found->pins[i] = pins_of(o.group, &r->now.state.link[FOURLINK_ROD_OF(i)], x);
        carry(found, &o, bodies, found->pins[i].FP);
        o.is_about_pivot = 1;
        if (o.group->to > FOURLINK_GROUND)
            carry(found, &o, bodies, found->pins[i].FD);
    }
}

/* ---------------------------------------------------------------------------------------------- forces */

static void let_both(const sample_output *o, const char *x, const char *y, const char *of_x,
                     const char *of_y, fourlink_vector F)
{
    sample_output_let(o, x, of_x, F.x);
    sample_output_let(o, y, of_y, F.y);
}

static void put_words(const sample_output *o, const char *words)
{
    page_print(o->m->p, "<p>%s</p>\n", words);
}

static void put_slider_by_rod(const sample_output *o, const sample_pins *f, const double b[6])
{
    fourlink_vector u = o->r->now.state.link[FOURLINK_END_OF(o->i)].axis, nu;

    nu.x = -u.y;
    nu.y = u.x;
    put_words(
        o,
        "The rod's force F<sub>Q</sub> on the slider: its part along the line (t) is the slider's "
        "own, as the guide has none; its part to the left of the line (n) follows from "
        "the moments of the rod about P:");
    sample_output_let(o, "FQt", "F6x * cos theta6 + F6y * sin theta6", u.x * b[3] + u.y * b[4]);
    sample_output_let(
        o, "FQn", "- { M5 + l5 * FQt * sin ( theta6 - theta5 ) | l5 * cos ( theta6 - theta5 ) }",
        nu.x * f->FQ.x + nu.y * f->FQ.y);
    let_both(o, "FQx", "FQy", "FQt * cos theta6 - FQn * sin theta6",
             "FQt * sin theta6 + FQn * cos theta6", f->FQ);
    put_words(
        o,
        "The force F<sub>P</sub> of the carrying link on the rod, and the force N and the couple M "
        "of the guide on the slider:");
    let_both(o, "FPx", "FPy", "F5x + FQx", "F5y + FQy", f->FP);
    sample_output_let(o, "N16", "F6y * cos theta6 - F6x * sin theta6 - FQn", f->N);
    sample_output_let(o, "M16", "M6", f->M);
}

static void put_rocker_by_rod(const sample_output *o, const sample_pins *f, const double b[6])
{
    (void)b;
    put_words(o, "The rod's force F<sub>Q</sub> on the rocker, from the moments of the rod about P "
                 "and of the "
                 "rocker about D:");
    let_both(
        o, "FQx", "FQy",
        "- { l5 * M6 * cos theta5 + r6 * M5 * cos theta6 | l5 * r6 * sin ( theta6 - theta5 ) }",
        "- { l5 * M6 * sin theta5 + r6 * M5 * sin theta6 | l5 * r6 * sin ( theta6 - theta5 ) }",
        f->FQ);
    put_words(o, "The force F<sub>P</sub> of the carrying link on the rod, and the force "
                 "F<sub>D</sub> on the rocker at "
                 "its pin D:");
    let_both(o, "FPx", "FPy", "F5x + FQx", "F5y + FQy", f->FP);
    let_both(o, "FD6x", "FD6y", "F6x - FQx", "F6y - FQy", f->FD);
}

static double along_normal(const sample_output *o, fourlink_vector F)
{
    const fourlink_vector *e = &o->r->now.state.link[FOURLINK_ROD_OF(o->i)].axis;

    return cross(*e, F);
}

static void put_slider_by_slot(const sample_output *o, const sample_pins *f, const double b[6])
{
    int is_own = o->group->hang == FOURLINK_HANGS_BY_OWN_SLOT;

    (void)b;
    put_words(
        o,
        "The block passes a force F<sub>S</sub> to the left of the slot. It is all that drives the "
        "slider along its line:");
    sample_output_let(o, "FS5", "{ F6x * cos theta6 + F6y * sin theta6 | sin ( theta6 - theta5 ) }",
                      along_normal(o, f->FP));
    put_words(
        o,
        "Its components are the force F<sub>P</sub> of the carrying link on the output; then the "
        "force N and the couple M of the guide on the slider:");
    let_both(o, "FPx", "FPy", "- FS5 * sin theta5", "FS5 * cos theta5", f->FP);
    sample_output_let(o, "N16",
                      "F6y * cos theta6 - F6x * sin theta6 - FS5 * cos ( theta6 - theta5 )", f->N);
    sample_output_let(o, "M16", is_own ? "M6 - s5 * FS5" : "M6", f->M);
}

static void put_rocker_by_slot(const sample_output *o, const sample_pins *f, const double b[6])
{
    int is_own = o->group->hang == FOURLINK_HANGS_BY_OWN_SLOT;

    (void)b;
    put_words(
        o,
        "The block passes a force F<sub>S</sub> to the left of the slot, from the moments of the "
        "rocker about D:");
    sample_output_let(o, "FS5", is_own ? "{ M6 | s5 }" : "{ M6 | r6 * cos ( theta6 - theta5 ) }",
                      along_normal(o, f->FP));
    put_words(
        o,
        "Its components are the force F<sub>P</sub> of the carrying link on the output; then the "
        "force F<sub>D</sub> on the rocker at its pin D:");
    let_both(o, "FPx", "FPy", is_own ? "- FS5 * sin theta6" : "- FS5 * sin theta5",
             is_own ? "FS5 * cos theta6" : "FS5 * cos theta5", f->FP);
    let_both(o, "FD6x", "FD6y", "F6x - FPx", "F6y - FPy", f->FD);
}

/* What it puts on a link that carries it: -F at P, at the block in its slot, or at the pin of a rocker. */
static void put_moment(const sample_output *o, const fourlink_body bodies[FOURLINK_LINKS],
                       fourlink_vector F)
{
    int on = sample_output_link(o);
    int is_of_four = on <= FOURLINK_FOLLOWER;
    int is_in_slot = !o->is_about_pivot && o->group->hang == FOURLINK_HANGS_IN_SLOT;
    fourlink_vector arm = arm_of(o->r, o);
    char symbol[SAMPLE_EQUATION];

    page_print(o->m->p,
               "<p>On the %s, link %d, acts \342\210\222F<sub>%s</sub> at %s; its moment about the "
               "%s:</p>\n",
               fourlink_deck_link_text(o->r->v.deck, on), on, o->is_about_pivot ? "D" : "P",
               o->is_about_pivot ? "D"
               : is_in_slot      ? "Q"
                                 : "P",
               is_of_four ? "link's centre of mass" : "link's own pin");
    if (is_of_four && !math_has(o->m, sample_output_words(o, "rhokx", symbol))) {
        sample_output_set(o, "rhokx", bodies[on].arm.x);
        sample_output_set(o, "rhoky", bodies[on].arm.y);
    }
    if (is_in_slot) {
        sample_output_let(o, "rQx", "armx + s5 * cos theta5", arm.x);
        sample_output_let(o, "rQy", "army + s5 * sin theta5", arm.y);
    }
    sample_output_let(o, "MP,k",
                      is_in_slot ? (is_of_four ? "( rQy <rhoky - rhoky > ) * FPx - ( rQx <rhokx - "
                                                 "rhokx > ) * FPy"
                                               : "rQy * FPx - rQx * FPy")
                      : is_of_four
                          ? "( army <rhoky - rhoky > ) * FPx - ( armx <rhokx - rhokx > ) * FPy"
                          : "army * FPx - armx * FPy",
                      moment_of(o, bodies, F));
}

static void put_sides(const sample_output *o, const fourlink_body bodies[FOURLINK_LINKS],
                      const sample_carried *carried)
{
    static const char *const names[6] = {"F5x", "F5y", "M5", "F6x", "F6y", "M6"};
    const double *b = carried->b[o->i];
    int by_rod = o->group->hang == FOURLINK_HANGS_BY_ROD, k, j;

    page_print(o->m->p,
               by_rod
                   ? "<p>What is known of both links, with moments of the rod about P and of the "
                     "%s about %s. The sums b are F and M of link %d and of link %d:</p>\n"
                   : "<p>What is known of the %s, with moments about %s. The sums b are F and M "
                     "of link %d:</p>\n",
               is_slider(o) ? "slider" : "rocker", is_slider(o) ? "Q" : "D",
               by_rod ? FOURLINK_ROD_OF(o->i) : FOURLINK_END_OF(o->i), FOURLINK_END_OF(o->i));
    sample_begin_sides(o->r, o->m, "What is known of an output");
    for (k = !by_rod; k < 2; k++) {
        int link = FOURLINK_ROD_OF(o->i) + k;
        sample_side side[3];

        for (j = 0; j < 3; j++)
            side[j].b = b[3 * k + j];
        sample_find_sides(&o->group->body[k], &bodies[link], &o->r->now.state.link[link], 1, side);
        side[0].carried = carried->force[link].x;
        side[1].carried = carried->force[link].y;
        side[2].carried = carried->moment[link];
        sample_put_sides(o->r, o->m, fourlink_deck_link_text(o->r->v.deck, link), side);
    }
    page_table_end(o->m->p);
    for (j = by_rod ? 0 : 3; j < 6; j++)
        sample_output_set(o, names[j], b[j]);
}

void sample_put_output_forces(report *r, math *m, const fourlink_body bodies[FOURLINK_LINKS],
                              const sample_carried *carried)
{
    int i;

    for (i = r->v.design->n_groups - 1; i >= 0; i--) {
        sample_output o = sample_output_of(r, m, i);
        const sample_pins *f = &carried->pins[i];
        int by_rod = o.group->hang == FOURLINK_HANGS_BY_ROD;

        sample_output_heading(&o, "forces");
        put_sides(&o, bodies, carried);
        if (is_slider(&o))
            (by_rod ? put_slider_by_rod : put_slider_by_slot)(&o, f, carried->b[i]);
        else
            (by_rod ? put_rocker_by_rod : put_rocker_by_slot)(&o, f, carried->b[i]);
        sample_output_let(&o, "FP", "[ FPx ^2 + FPy ^2 ]", gsl_hypot(f->FP.x, f->FP.y));
        if (by_rod)
            sample_output_let(&o, "FQ", "[ FQx ^2 + FQy ^2 ]", gsl_hypot(f->FQ.x, f->FQ.y));
        if (!is_slider(&o))
            sample_output_let(&o, "FD6", "[ FD6x ^2 + FD6y ^2 ]", gsl_hypot(f->FD.x, f->FD.y));
        put_moment(&o, bodies, f->FP);
        o.is_about_pivot = 1;
        if (o.group->to > FOURLINK_GROUND)
            put_moment(&o, bodies, f->FD);
    }
}
