/* SPDX-License-Identifier: GPL-3.0-or-later
**
** friction_circle.c - the friction circles of a link's pins, to which the forces of the pins are tangents.
**
** The force F at a pin and the moment M of its friction are together the force F along a line at the distance
** M / |F| from the pin: a tangent to the circle of radius mu r.
**
** Reference: R. S. Khurmi, J. K. Gupta, "Theory of Machines", chapter 10, friction of a pin joint.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "friction_circle.h"

/* A circle is drawn to scale if its radius is at least this fraction of the drawing. */
#define SMALLEST 0.04

/* The moment of a joint's friction on a link: against its turning relative to the other link. */
static double moment_on(const picture *p, const picture_row *r, unsigned long joint, int link)
{
    fourlink_load_info load;
    unsigned long i;

    for (i = 0; fourlink_deck_load(p->v.deck, i, &load) == FOURLINK_OK; i++)
        if (load.sort == FOURLINK_LOAD_FRICTION && load.element == joint && load.link == link)
            return r->loads[i].torque;
    return 0;
}

friction_circle friction_circle_of(const picture *p, const picture_row *r, int joint, int link,
                                   fourlink_vector F)
{
    double size = gsl_hypot(F.x, F.y);
    fourlink_friction friction;
    friction_circle x = {0, 0};

    fourlink_deck_friction(p->v.deck, &friction);
    x.radius = figure_length(p, friction.circle[joint]);
    if (size > 0)
        x.arm = figure_length(p, moment_on(p, r, (unsigned long)joint, link) / size);
    return x;
}

double friction_circle_scale(double size, const friction_circle *x, const friction_circle *y)
{
    double radius = GSL_MAX_DBL(x->radius, y->radius);

    return radius > 0 ? GSL_MAX_DBL(place_round(SMALLEST * size / radius), 1) : 1;
}

/* r x F = arm |F|, r at right angles to F */
fourlink_vector friction_circle_touch(const friction_circle *x, double scale, fourlink_vector pin,
                                      fourlink_vector F)
{
    double size = gsl_hypot(F.x, F.y), part = size > 0 ? scale * x->arm / size : 0;

    return place_beside(pin, part * F.y, -part * F.x);
}

void friction_circle_draw(sketch *s, const friction_circle *x, double scale, fourlink_vector pin)
{
    if (x->radius > 0)
        sketch_arc(s, PEN_OTHER, pin, scale * x->radius, 0, 2 * M_PI);
}

void friction_circle_note(sketch *s, double scale)
{
    char words[80], number[FORMAT_SIZE];

    format_general(scale, 6, number);
    sketch_note(
        s, flk_text_join(words, sizeof words, "friction circles ", number, ":1", (char *)NULL));
}
