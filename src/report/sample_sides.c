/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_sides.c - what is known of a link's three equations, in the sample calculation.
*/
#include "base/text.h"
#include "sample_sides.h"
#include "view/notation.h"

static double cross(fourlink_vector u, fourlink_vector v)
{
    return u.x * v.y - u.y * v.x;
}

const char *sample_with_units(char out[SAMPLE_HEADING], const char *words, const char *first,
                              const char *second)
{
    char typeset[2][NOTATION_SIZE];

    return flk_text_join(out, SAMPLE_HEADING, words, " (", notation_unit(first, typeset[0]),
                         second ? ", " : "", second ? notation_unit(second, typeset[1]) : "", ")",
                         (char *)NULL);
}

void sample_find_sides(const fourlink_link *data, const fourlink_body *body,
                       const fourlink_link_state *now, int is_about_origin, sample_side side[3])
{
    fourlink_vector a = body->acceleration, arm = {0, 0};

    if (is_about_origin)
        arm = body->arm;
    side[0].inertia = data->mass * a.x;
    side[1].inertia = data->mass * a.y;
    side[2].inertia = data->inertia * now->alpha + data->mass * cross(arm, a);
    side[0].weight = body->weight.x;
    side[1].weight = body->weight.y;
    side[2].weight = cross(arm, body->weight);
    side[0].load = body->force.x;
    side[1].load = body->force.y;
    side[2].load = body->moment + cross(arm, body->force);
}

void sample_begin_sides(report *r, math *m, const char *caption)
{
    char heading[SAMPLE_HEADING];

    page_table_of(
        m->p, "facts sides", caption,
        sample_with_units(heading,
                          r->v.design->n_groups
                              ? "Equation|m a, I \316\261|\342\210\222 weight|\342\210\222 loads|"
                                "\342\210\222 outputs|b"
                              : "Equation|m a, I \316\261|\342\210\222 weight|\342\210\222 loads|b",
                          m->units.of[MATH_FORCE].name, m->units.of[MATH_TORQUE].name));
}

void sample_put_sides(report *r, math *m, const char *link, const sample_side side[3])
{
    static const char *const what[3] = {"x", "y", "moments"};
    int i;

    for (i = 0; i < 3; i++) {
        math_unit of = i < 2 ? MATH_FORCE : MATH_TORQUE;
        double inertia = math_shown(m, side[i].inertia, of), b = math_shown(m, side[i].b, of);
        double weight = math_shown(m, -side[i].weight, of), load = math_shown(m, -side[i].load, of);

        if (r->v.design->n_groups)
            page_row(m->p, "%s, %s|%.6g|%.6g|%.6g|%.6g|%.6g", link, what[i], inertia, weight, load,
                     math_shown(m, -side[i].carried, of), b);
        else
            page_row(m->p, "%s, %s|%.6g|%.6g|%.6g|%.6g", link, what[i], inertia, weight, load, b);
    }
}
