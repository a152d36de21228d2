/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_output.c - the outputs of a deck in the sample calculation: what is given, the motion of P, and
** the order of what is written.
*/
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "sample_motion.h"
#include "sample_output.h"
#include "sample_output_type.h"

/* ---------------------------------------------------------------------- the motion of a point of a link */

static double dot(fourlink_vector u, fourlink_vector v)
{
    return u.x * v.x + u.y * v.y;
}

static fourlink_vector turned(const fourlink_link_state *link, fourlink_vector at)
{
    fourlink_vector r;

    r.x = at.x * link->axis.x - at.y * link->axis.y;
    r.y = at.x * link->axis.y + at.y * link->axis.x;
    return r;
}

/* A point at the arm r from the origin of a link. */
static sample_point move_point(const fourlink_link_state *link, fourlink_vector r)
{
    double normal = link->omega * link->omega;
    sample_point p;

    p.place.x = link->origin.x + r.x;
    p.place.y = link->origin.y + r.y;
    p.velocity.x = link->velocity.x - link->omega * r.y;
    p.velocity.y = link->velocity.y + link->omega * r.x;
    p.acceleration.x = link->acceleration.x - link->alpha * r.y - normal * r.x;
    p.acceleration.y = link->acceleration.y + link->alpha * r.x - normal * r.y;
    return p;
}

/* The symbols of the motion of a link's origin, "" for 0. */
typedef struct origin {
    char place[2][SAMPLE_EQUATION], velocity[2][SAMPLE_EQUATION], acceleration[2][SAMPLE_EQUATION];
} origin;

static void name_origin(const sample_output *owner, origin *names, const char *const names_of[6])
{
    int i;

    for (i = 0; i < 2; i++) {
        sample_output_words(owner, names_of[i], names->place[i]);
        sample_output_words(owner, names_of[2 + i], names->velocity[i]);
        sample_output_words(owner, names_of[4 + i], names->acceleration[i]);
    }
}

static void find_origin(const sample_output *o, int link, origin *names)
{
    static const char *const
        of_A[6] = {"", "", "", "", "", ""},
        *const of_B[6] = {"xB", "yB", "vBx", "vBy", "aBx", "aBy"}, *const of_C[6] = {"xC", "",
                                                                                     "vC", "",
                                                                                     "aC", ""},
        *const of_C_offset[6] = {"xC", "e", "vC", "", "aC", ""}, *const of_D[6] = {"d", "", "",
                                                                                   "",  "", ""},
        *const of_P[6] = {"xP", "yP", "vPx", "vPy", "aPx", "aPy"}, *const of_Q[6] = {"xQ",  "yQ",
                                                                                     "vQx", "vQy",
                                                                                     "aQx", "aQy"},
        *const of_pivot[6] = {"xD6", "yD6", "", "", "", ""},
        *const of_floating[6] = {"xD6", "yD6", "vD6x", "vD6y", "aD6x", "aD6y"};
    const fourlink_design *design = o->r->v.design;
    sample_output owner = *o;

    owner.is_about_pivot = 0;
    if (link == FOURLINK_CRANK) {
        name_origin(&owner, names, of_A);
    } else if (link == FOURLINK_COUPLER) {
        name_origin(&owner, names, of_B);
    } else if (link == FOURLINK_FOLLOWER) {
        name_origin(&owner, names,
                    !o->r->v.kind.guided  ? of_D
                    : design->offset != 0 ? of_C_offset
                                          : of_C);
    } else {
        owner = sample_output_of(o->r, o->m, (link - 5) / 2);
        name_origin(&owner, names,
                    link % 2                                    ? of_P
                    : owner.group->end == FOURLINK_GROUP_SLIDES ? of_Q
                    : sample_output_floats(owner.group)         ? of_floating
                                                                : of_pivot);
    }
}

/* Write one component: that of the origin, whose symbol has no letters of a template, and a template. */
static void let_component(const sample_output *o, const char *name, const char *of_origin,
                          const char *rest, double value)
{
    char equation[2 * SAMPLE_EQUATION], whole[SAMPLE_EQUATION], symbol[SAMPLE_EQUATION];
    const char *between = !*of_origin || !*rest ? "" : *rest == '-' || *rest == '<' ? " " : " + ";

    flk_text_join(equation, sizeof equation, of_origin, between,
                  sample_output_words(o, rest, whole), (char *)NULL);
    math_let(o->m, sample_output_words(o, name, symbol), *equation ? equation : "0", value);
}

/* What is to be known of pin B, and of links 3 and 4, unless it is written above. */
static void put_crank_pin(const sample_output *o)
{
    const fourlink_link_state *coupler = &o->r->now.state.link[FOURLINK_COUPLER];
    int is_r = o->r->v.kind.shape[FOURLINK_FOLLOWER] == FOURLINK_SHAPE_BLOCK;

    if (math_has(o->m, "vBx"))
        return;
    page_print(o->m->p, "<h3>Pin B</h3>\n");
    if (!math_has(o->m, "xB")) {
        math_let(o->m, "xB", is_r ? "r * cos theta2" : "a * cos theta2", coupler->origin.x);
        math_let(o->m, "yB", is_r ? "r * sin theta2" : "a * sin theta2", coupler->origin.y);
    }
    math_let(o->m, "vBx", is_r ? "- r * omega2 * sin theta2" : "- a * omega2 * sin theta2",
             coupler->velocity.x);
    math_let(o->m, "vBy", is_r ? "r * omega2 * cos theta2" : "a * omega2 * cos theta2",
             coupler->velocity.y);
    sample_put_acceleration_of_B(o->r, o->m);
}

static void set_links(report *r, math *m)
{
    static const char *const names[5][3] = {{NULL, NULL, NULL},
                                            {NULL, NULL, NULL},
                                            {"theta2", "omega2", "alpha2"},
                                            {"theta3", "omega3", "alpha3"},
                                            {"theta4", "omega4", "alpha4"}};
    int link;

    for (link = FOURLINK_COUPLER; link <= FOURLINK_FOLLOWER; link++) {
        const fourlink_link_state *now = &r->now.state.link[link];
        double values[3];
        int i;

        values[0] = now->theta;
        values[1] = now->omega;
        values[2] = now->alpha;

        for (i = 0; i < 3; i++)
            if (!math_has(m, names[link][i]))
                math_set(m, names[link][i], values[i]);
    }
}

static void put_place(const sample_output *o, fourlink_vector r, const sample_point *P)
{
    origin from;

    find_origin(o, sample_output_link(o), &from);
    sample_output_let(o, "armx", "pP * cos thetak <qP - qP * sin thetak >", r.x);
    sample_output_let(o, "army", "pP * sin thetak <qP + qP * cos thetak >", r.y);
    if (sample_output_link(o) == FOURLINK_CRANK)
        return;
    let_component(o, "xP", from.place[0], "rPx", P->place.x);
    let_component(o, "yP", from.place[1], "rPy", P->place.y);
}

static void put_velocity(const sample_output *o, const sample_point *P)
{
    int does_turn = sample_can_turn(o->r, sample_output_link(o));
    origin from;

    find_origin(o, sample_output_link(o), &from);
    let_component(o, "vPx", from.velocity[0], does_turn ? "- omegak * army" : "", P->velocity.x);
    let_component(o, "vPy", from.velocity[1], does_turn ? "omegak * armx" : "", P->velocity.y);
}

static void put_acceleration(const sample_output *o, const sample_point *P)
{
    int does_turn = sample_can_turn(o->r, sample_output_link(o));
    origin from;

    find_origin(o, sample_output_link(o), &from);
    let_component(o, "aPx", from.acceleration[0],
                  does_turn ? "<alphak - alphak * army > - omegak ^2 * armx" : "",
                  P->acceleration.x);
    let_component(o, "aPy", from.acceleration[1],
                  does_turn ? "<alphak + alphak * armx > - omegak ^2 * army" : "",
                  P->acceleration.y);
}

/* --------------------------------------------------------------------------------------------- outputs */

static sample_hung find_motion(const sample_output *o)
{
    const fourlink_group *g = o->group;
    const fourlink_link_state *link = o->r->now.state.link, *on = &link[g->link];
    const fourlink_vector *e;
    fourlink_vector to_block, v;
    sample_hung now;

    memset(&now, 0, sizeof now);
    now.rod = &link[FOURLINK_ROD_OF(o->i)];
    now.end = now.rod + 1;
    e = &now.rod->axis;
    now.P = move_point(on, turned(on, g->at));
    now.D.place = g->pivot;
    if (sample_output_floats(g))
        now.D = move_point(&link[g->to], turned(&link[g->to], g->pivot));
    if (g->end == FOURLINK_GROUP_SLIDES) {
        to_block.x = now.end->origin.x - g->pivot.x;
        to_block.y = now.end->origin.y - g->pivot.y;
        now.s6 = dot(now.end->axis, to_block);
        now.sdot6 = dot(now.end->axis, now.end->velocity);
        now.sddot6 = dot(now.end->axis, now.end->acceleration);
    }
    if (g->hang == FOURLINK_HANGS_IN_SLOT) {
        to_block.x = now.rod->origin.x - now.P.place.x;
        to_block.y = now.rod->origin.y - now.P.place.y;
        v.x = now.rod->velocity.x - now.P.velocity.x;
        v.y = now.rod->velocity.y - now.P.velocity.y;
    } else {
        to_block.x = now.P.place.x - now.end->origin.x;
        to_block.y = now.P.place.y - now.end->origin.y;
        v.x = now.P.velocity.x - now.end->velocity.x + now.end->omega * to_block.y;
        v.y = now.P.velocity.y - now.end->velocity.y - now.end->omega * to_block.x;
    }
    now.s5 = dot(*e, to_block);
    now.sdot5 = dot(*e, v);
    return now;
}

static void put_given(const sample_output *o, const sample_hung *now)
{
    const fourlink_group *g = o->group;
    sample_output pivot = *o;

    pivot.is_about_pivot = 1;
    page_print(o->m->p, "<p>P in the axes of link %d, at p along it and q to its left:</p>\n",
               g->link);
    page_print(o->m->p, "<ul class=\"given\">\n");
    sample_output_given(o, "pP", g->at.x);
    sample_output_given(o, "qP", g->at.y);
    if (g->hang == FOURLINK_HANGS_BY_ROD)
        sample_output_given(o, "l5", g->rod);
    else if (g->hang == FOURLINK_HANGS_IN_SLOT || g->end == FOURLINK_GROUP_SLIDES)
        sample_output_given(o, "beta5", atan2(g->slot.y, g->slot.x));
    if (g->end == FOURLINK_GROUP_SLIDES) {
        sample_output_given(o, "x0", g->pivot.x);
        sample_output_given(o, "y0", g->pivot.y);
        sample_output_given(o, "theta6", now->end->theta);
    } else {
        if (g->hang == FOURLINK_HANGS_BY_OWN_SLOT)
            sample_output_given(o, "h6", g->offset);
        else
            sample_output_given(o, "r6", g->length);
        sample_output_given(&pivot, sample_output_floats(g) ? "pP" : "xP", g->pivot.x);
        sample_output_given(&pivot, sample_output_floats(g) ? "qP" : "yP", g->pivot.y);
    }
    page_print(o->m->p, "</ul>\n");
}

/* 1 if something hangs on a link of an output, which needs the motion of its origin. */
static int is_carrying(const report *r, int link)
{
    const fourlink_design *design = r->v.design;
    int i;

    for (i = 0; i < design->n_groups; i++)
        if (design->group[i].link == link || design->group[i].to == link)
            return 1;
    return 0;
}

static void put_output(const sample_output *o)
{
    const fourlink_group *g = o->group;
    const fourlink_link_state *link = o->r->now.state.link;
    const sample_output_type *type = sample_output_type_of(g);
    sample_hung now = find_motion(o);
    sample_output pivot = *o;
    int loop,
        slides_on = g->end == FOURLINK_GROUP_SLIDES && is_carrying(o->r, FOURLINK_END_OF(o->i));

    pivot.is_about_pivot = 1;
    sample_output_heading(o, "position");
    page_print(o->m->p, "<p>");
    page_print(o->m->p, type->words, fourlink_deck_link_text(o->r->v.deck, g->link));
    page_print(o->m->p,
               g->hang == FOURLINK_HANGS_BY_ROD
                   ? " The rod is link %d, the %s link %d.</p>\n"
                   : " The block on the pin is link %d, without mass; the %s is link %d.</p>\n",
               FOURLINK_ROD_OF(o->i), g->end == FOURLINK_GROUP_SLIDES ? "slider" : "rocker",
               FOURLINK_END_OF(o->i));
    if (o->r->v.design->n_groups > 1)
        page_print(o->m->p, "<p>In the equations its pins have the number %d.</p>\n", o->i + 1);
    put_given(o, &now);
    put_place(o, turned(&link[g->link], g->at), &now.P);
    if (sample_output_floats(g)) {
        page_print(o->m->p, "<p>The pin D of the rocker, on the %s, link %d:</p>\n",
                   fourlink_deck_link_text(o->r->v.deck, g->to), g->to);
        put_place(&pivot, turned(&link[g->to], g->pivot), &now.D);
    }
    type->place(o, &now);
    loop = o->m->p->n_equations;
    if (slides_on) {
        sample_output_let(o, "xQ", "x0 + s6 * cos theta6", now.end->origin.x);
        sample_output_let(o, "yQ", "y0 + s6 * sin theta6", now.end->origin.y);
    }
    sample_output_heading(o, "velocity");
    put_velocity(o, &now.P);
    if (sample_output_floats(g))
        put_velocity(&pivot, &now.D);
    sample_put_derived(o->m, loop, "differentiated by time, and solved:");
    type->move(o, &now);
    if (slides_on) {
        sample_output_let(o, "vQx", "sdot6 * cos theta6", now.end->velocity.x);
        sample_output_let(o, "vQy", "sdot6 * sin theta6", now.end->velocity.y);
    }
    sample_output_heading(o, "acceleration");
    put_acceleration(o, &now.P);
    if (sample_output_floats(g))
        put_acceleration(&pivot, &now.D);
    sample_put_derived(o->m, loop, "differentiated once more, and solved:");
    type->accelerate(o, &now);
    if (slides_on) {
        sample_output_let(o, "aQx", "sddot6 * cos theta6", now.end->acceleration.x);
        sample_output_let(o, "aQy", "sddot6 * sin theta6", now.end->acceleration.y);
    }
}

void sample_put_outputs(report *r, math *m)
{
    int i;

    set_links(r, m);
    for (i = 0; i < r->v.design->n_groups; i++) {
        sample_output o = sample_output_of(r, m, i);

        if (o.group->link == FOURLINK_COUPLER || o.group->to == FOURLINK_COUPLER)
            put_crank_pin(&o);
        put_output(&o);
    }
}
