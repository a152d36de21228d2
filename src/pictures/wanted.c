/* SPDX-License-Identifier: GPL-3.0-or-later
**
** wanted.c - the positions for which a linkage was found: the coupler as a triangle with its point, or
** crank and output at the precision points of a function, and a ring at what is wanted.
*/
#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_math.h>

#include "wanted.h"

#define NUMBERED 9 /* so many positions at most have their numbers */

static void put_ring(sketch *s, fourlink_vector at, int number, int has_number)
{
    char name[FORMAT_SIZE + 8], words[FORMAT_SIZE];

    format_general(number, 5, words);
    sketch_ring(s, at, flk_text_join(name, sizeof name, "wanted ", words, (char *)NULL));
    if (has_number)
        sketch_number(s, at, 1, -1, words);
}

/* From the point back to B, along the coupler to C, and to the point again. */
static fourlink_vector put_coupler(sketch *s, const fourlink_solution *x,
                                   const fourlink_precision *wanted)
{
    fourlink_vector P = wanted->point, B = place_polar(P, -x->point.x, wanted->theta3), C;

    B = place_polar(B, -x->point.y, wanted->theta3 + M_PI / 2);
    C = place_polar(B, x->design.link[FOURLINK_COUPLER].length, wanted->theta3);
    sketch_line(s, PEN_WANTED, P, B);
    sketch_line(s, PEN_WANTED, B, C);
    sketch_line(s, PEN_WANTED, C, P);
    return P;
}

/* The crank at its angle, and the rocker, the lever or the pin of the piston where the function wants it. */
static fourlink_vector put_function(sketch *s, const picture *p, const fourlink_solution *x,
                                    const fourlink_precision *wanted)
{
    const fourlink_link *link = x->design.link;
    double arm = link[FOURLINK_FOLLOWER].length;
    fourlink_vector A = {0, 0}, D = {0, 0}, end;

    sketch_line(s, PEN_WANTED, A, place_polar(A, link[FOURLINK_CRANK].length, wanted->theta2));
    if (p->v.kind.guided)
        return place_at(wanted->output, x->design.offset);
    D.x = link[FOURLINK_GROUND].length;
    end = place_polar(D, arm > 0 ? arm : p->v.lever_high, wanted->output);
    sketch_line(s, PEN_WANTED, D, end);
    return end;
}

void wanted_draw(sketch *s, picture *p)
{
    fourlink_solution *x;
    int i;

    if (!view_find_solution(p->v.deck, &x) || !x)
        return;
    for (i = 0; i < x->n_positions; i++) {
        fourlink_vector at;

        sketch_show(s, SKETCH_WANTED, (unsigned long)i);
        at = x->has_point ? put_coupler(s, x, &x->position[i])
                          : put_function(s, p, x, &x->position[i]);
        put_ring(s, at, i + 1, x->n_positions <= NUMBERED);
    }
    if (x->n_positions > 0)
        sketch_key(s, PEN_WANTED, "wanted positions");
    free(x);
}
