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
#define NO_ERROR 1e-9

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

/* By how much errors are drawn enlarged: 1, 2 or 5 times a power of ten, so that the largest is a tenth
** of the size of the positions at most. */
static double enlargement(const fourlink_solution *x)
{
    double size = 0, factor = 1, steps[] = {2, 2.5, 2};
    int i;

    for (i = 1; i < x->n_positions; i++)
        size = GSL_MAX(size, gsl_hypot(x->position[i].point.x - x->position[0].point.x,
                                       x->position[i].point.y - x->position[0].point.y));
    for (i = 0; x->largest > NO_ERROR * size && x->largest * factor * steps[i % 3] <= 0.1 * size;
         i++)
        factor *= steps[i % 3];
    return factor;
}

/* From a wanted place to where the coupler point is, enlarged. */
static fourlink_vector put_error(sketch *s, const fourlink_solution *x,
                                 const fourlink_precision *wanted, double factor)
{
    double theta3 = wanted->theta3 + wanted->residual;
    fourlink_vector at = {0, 0};

    at = place_polar(at, x->design.link[FOURLINK_CRANK].length, wanted->theta2);
    at = place_polar(at, x->point.x, theta3);
    at = place_polar(at, x->point.y, theta3 + M_PI / 2);
    at.x = wanted->point.x + factor * (at.x - wanted->point.x);
    at.y = wanted->point.y + factor * (at.y - wanted->point.y);
    if (wanted->error > 0)
        sketch_line(s, PEN_WANTED, wanted->point, at);
    return wanted->point;
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
    char words[FORMAT_SIZE], key[FORMAT_SIZE + 40];
    fourlink_solution *x;
    double factor;
    int i;

    if (!view_find_solution(p->v.deck, &x) || !x)
        return;
    factor = enlargement(x);
    for (i = 0; i < x->n_positions; i++) {
        fourlink_vector at;

        sketch_show(s, SKETCH_WANTED, (unsigned long)i);
        at = x->starts > 0  ? put_error(s, x, &x->position[i], factor)
             : x->has_point ? put_coupler(s, x, &x->position[i])
                            : put_function(s, p, x, &x->position[i]);
        put_ring(s, at, i + 1, x->n_positions <= NUMBERED);
    }
    format_general(factor, 3, words);
    flk_text_join(key, sizeof key, "wanted positions", factor > 1 ? ", errors times " : "",
                  factor > 1 ? words : "", (char *)NULL);
    if (x->n_positions > 0)
        sketch_key(s, PEN_WANTED, key);
    free(x);
}
