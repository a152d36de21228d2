/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_friction.c - the friction of the sample calculation: moments of pins, force of the guide.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/text.h"
#include "mathml.h"
#include "report.h"
#include "sample_friction.h"
#include "view/notation.h"

#define PINS 4

/* Of the pins A, B, C and D: radius of the friction circle, moment, pin force. */
static const struct {
    const char *pin, *radius, *moment, *force, *product;
} pins[PINS] = {{"A", "rhoA", "MA", "F12", "rhoA * F12"},
                {"B", "rhoB", "MB", "F23", "rhoB * F23"},
                {"C", "rhoC", "MC", "F34", "rhoC * F34"},
                {"D", "rhoD", "MD", "F14", "rhoD * F14"}};

/* A pin has the moment y = rho |F|, rho = mu r the radius of the friction circle (see
** mechanics/friction.c). */
static void put_pin(const report *r, math *m, const fourlink_friction *friction, int i)
{
    if (!(r->now.losses.pin[i] > 0)) {
        page_print(m->p,
                   "<p>Pin %s has none here: its links do not turn on each other, or it "
                   "has no force.</p>\n",
                   pins[i].pin);
        return;
    }
    math_set(m, pins[i].radius, friction->circle[i]);
    math_let(m, pins[i].moment, pins[i].product, r->now.losses.pin[i]);
}

/* A guide or slot: what its friction is called, and the products it can be. */
typedef struct way {
    const char *name, *force, *length, *N, *M;
    const char *product, *of_edges, *resultant;
} way;

static const way
    on_ground = {"guide", "Fguide", "lguide", "N", "M14", "mu * N", "mu * { 2 * M14 | lguide }",
                 ""},
    on_lever = {"guide",
                "Fguide",
                "lguide",
                "N34",
                "M34",
                "mu * N34",
                "mu * { 2 * M34 | lguide }",
                "[ N34 ^2 + Fguide ^2 ]"},
    in_yoke = {"slot",
               "Fslot",
               "lslot",
               "N34",
               "M34",
               "mu * N34",
               "mu * { 2 * M34 | lslot }",
               "[ N34 ^2 + Fslot ^2 ]"};

/* It has the force y = mu |N|, or of a block of length l, mu max(|N|, 2 |M| / l). N and y are at right
** angles; a slider and its lever or yoke press on each other with both. */
static void put_way(const report *r, math *m, const way *w, double mu, double l, double y)
{
    const fourlink_forces *f = &r->now.forces;
    int is_slot = w != &on_ground;
    double N = is_slot ? f->N34 : f->F14y, M = is_slot ? f->M34 : f->M14;
    int has_edges = l > 0 && 2 * fabs(M) > fabs(N) * l;

    if (!(y > 0)) {
        page_print(m->p, "<p>The %s has none here: nothing moves or presses in it.</p>\n", w->name);
        return;
    }
    math_set(m, "mu", mu);
    math_set(m, w->length, l);
    math_set(m, w->N, fabs(N));
    math_set(m, w->M, fabs(M));
    math_let(m, w->force, has_edges ? w->of_edges : w->product, y);
    if (is_slot)
        math_let(m, "F34", w->resultant, gsl_hypot(f->F34x, f->F34y));
}

static void put_loads_of_joint(report *r, const math *m, unsigned long joint)
{
    fourlink_load_info info;
    unsigned long i;

    for (i = 0; fourlink_deck_load(r->v.deck, i, &info) == FOURLINK_OK; i++) {
        const fourlink_load *load = &r->loads[i];

        if (info.sort != FOURLINK_LOAD_FRICTION || info.element != joint ||
            (load->torque == 0 && load->force.x == 0 && load->force.y == 0))
            continue;
        page_row(&r->page, "%s, on the %s|%.6g|%.6g|%.6g",
                 load->torque != 0                      ? pins[joint].pin
                 : r->v.kind.guided && joint < PINS - 1 ? "slot"
                                                        : "guide",
                 r->v.kind.link[info.link], math_shown(m, load->force.x, MATH_FORCE),
                 math_shown(m, load->force.y, MATH_FORCE),
                 math_shown(m, load->torque, MATH_TORQUE));
    }
}

/* Write friction as loads: on which link, and how much.  The force of a guide acts at the origin of the
** link that slides. */
static void put_loads(report *r, const math *m)
{
    page *p = &r->page;
    char force[NOTATION_SIZE], torque[NOTATION_SIZE], columns[120];
    unsigned long joint;

    notation_unit(m->units.of[MATH_FORCE].name, force);
    notation_unit(m->units.of[MATH_TORQUE].name, torque);
    flk_text_join(columns, sizeof columns, "Load|x (", force, ")|y (", force, ")|moment (", torque,
                  ")", (char *)NULL);
    page_print(p, "<p>These are the loads, on each link against its motion relative to the other");
    if (r->now.losses.slot > 0)
        page_print(p, "; the force of the slot acts at B");
    if (r->now.losses.guide > 0)
        page_print(p, "; the force of the guide acts at %s", r->v.kind.guided ? "C" : "B");
    page_print(p, ":</p>\n");
    page_table_of(p, "facts friction", "Forces and moments of friction", columns);
    for (joint = 0; joint < PINS; joint++)
        put_loads_of_joint(r, m, joint);
    page_table_end(p);
}

void sample_put_friction(report *r, math *m)
{
    fourlink_friction friction;
    int i;

    if (!r->v.problem.has_friction || fourlink_deck_friction(r->v.deck, &friction) != FOURLINK_OK)
        return;
    page_print(m->p,
               "<h3>Friction</h3>\n<p>Friction is among the loads above, and depends on the "
               "forces that they give: both are found together.  A pin has the moment \317\201 F, "
               "where \317\201 = \316\274 r is the radius of its friction circle%s%s.</p>\n",
               friction.slot > 0    ? "; slot and guide have the force \316\274 |N|"
               : friction.guide > 0 ? "; the guide has the force \316\274 |N|"
                                    : "",
               (friction.guide > 0 && friction.guide_length > 0) ||
                       (friction.slot > 0 && friction.slot_length > 0)
                   ? ", or \316\274 2 |M| / l if the couple presses its edges more"
                   : "");
    for (i = 0; i < PINS; i++) /* C and D may be sliders */
        if (friction.circle[i] > 0 && !r->v.kind.joint[i].slider)
            put_pin(r, m, &friction, i);
    if (friction.slot > 0)
        put_way(r, m, &in_yoke, friction.slot, friction.slot_length, r->now.losses.slot);
    if (friction.guide > 0)
        put_way(r, m, r->v.kind.guided ? &on_ground : &on_lever, friction.guide,
                friction.guide_length, r->now.losses.guide);
    put_loads(r, m);
}
