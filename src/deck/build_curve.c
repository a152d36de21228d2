/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_curve.c - builds curves, of loads, gas and motors, from points.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "mechanics/kind.h"
#include "build_curve.h"
#include "parser.h"

const deck_axes flk_ground_axes = {0, {0, 0}, 0, 1, 0, {0, 0}};

/* rad; angles closer than this are equal */
#define LEAST_STEP 1e-9

/* 1 if a point repeats another, in all components. */
static int repeats(const point *c, const point *first)
{
    return flk_length(c->y[0] - first->y[0], c->y[1] - first->y[1]) <=
           1e-9 * flk_length(first->y[0], first->y[1]);
}

/* The period of a curve: the cycle for theta2, a turn for theta4; 0 for other arguments, which are not
** periodic. */
static double period_of(const parser *p, int over)
{
    return over == FLK_THETA2 ? p->d->machine.cycle : over == FLK_THETA4 ? 2 * M_PI : 0;
}

int flk_build_is_rising(parser *p, const setting *s, double least, const char *message)
{
    size_t i;

    for (i = 1; i < s->n_points; i++)
        if (!(s->curve[i].x > s->curve[i - 1].x) || s->curve[i].x - s->curve[i - 1].x < least)
            return flk_mistake(p->mistakes, s->curve[i].place, message);
    return 1;
}

/* Check the points of a curve.  Its arguments must increase; angles cover at most one period.  A last point
** at the end of the period must repeat the first.  Returns the number of points without that one; 0 if they
** do not form a curve. */
static size_t check_curve(parser *p, const setting *s, int over, double period)
{
    const point *c = s->curve;
    size_t n = s->n_points;

    if (!c || !(p->d->machine.cycle > 0))
        return 0;
    if (!flk_build_is_rising(p, s, period > 0 ? LEAST_STEP : 0,
                             period > 0 ? "the angles of a curve must increase"
                                        : "the arguments of a curve must increase"))
        return 0;
    if (period > 0 && n > 1 && fabs(c[n - 1].x - c[0].x - period) < LEAST_STEP) {
        n--;
        if (!repeats(&c[n], &c[0])) {
            flk_mistake(p->mistakes, c[n].place,
                        "the curve is not periodic: one %s after its first point it has another "
                        "value",
                        over == FLK_THETA2 ? "cycle" : "turn");
            return 0;
        }
    }
    if (n < 2)
        flk_mistake(p->mistakes, s->place, "a curve needs at least two points");
    else if (period > 0 && c[n - 1].x - c[0].x > period - LEAST_STEP)
        flk_mistake(p->mistakes, c[n - 1].place,
                    over == FLK_THETA2
                        ? "the curve is longer than the cycle; give [motion] a cycle of 720 deg if "
                          "it is one of four strokes"
                        : "the curve is longer than a turn of theta4, 360 deg");
    else
        return n;
    return 0;
}

void flk_build_curves(parser *p, const setting *s, int n_components, int over,
                      const deck_axes *axes, curve *results)
{
    double period = period_of(p, over), *memory;
    double shift = period > 0 ? axes->angle : 0;
    size_t n = check_curve(p, s, over, period), i;
    int k;

    for (k = 0; n && k < n_components; k++) {
        memory = flk_reader_keep(p, FLK_CURVE_MEMORY(n) * sizeof *memory);
        if (!memory)
            return;
        flk_curve_place(memory, n, &results[k]);
        for (i = 0; i < n; i++) {
            const double *y = s->curve[i].y;

            results[k].x[i] = s->curve[i].x - shift;
            results[k].y[i] = n_components < 2 ? y[0]
                              : k == 0         ? axes->cosine * y[0] + axes->sine * y[1]
                                               : axes->cosine * y[1] - axes->sine * y[0];
        }
        flk_curve_finish(period, &results[k]);
    }
}
