/* SPDX-License-Identifier: GPL-3.0-or-later
**
** group_rod.c - groups that hang by a rod: a slider or a rocker on its other pin Q.
*/
#include <math.h>

#include "base/trig.h"
#include "group_type.h"

/* --------------------------------------------------------------------------------------------- slider
**
** With d = P - P0, u the direction of the line through P0, nu = J u, l the rod and e5 its axis,
**
**    c = nu.d / l,   rho = +- sqrt(1 - c^2),   e5 = rho u - c nu,   Q = P + l e5
**    omega5 = -nu.v / (l rho),   alpha5 = (-nu.a + l omega5^2 nu.e5) / (l rho)
**
** v and a being the velocity and the acceleration of P.  It is dead where the rod is square to the line.
*/
static double place_slider_by_rod(const flk_hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *u = &h->group->direction, *p = &h->rod->origin;
    double l = h->group->rod, c, square, rho;
    fourlink_vector d;

    d.x = p->x - pivot->x;
    d.y = p->y - pivot->y;
    c = FLK_CROSS(*u, d) / l;
    square = (1 - c) * (1 + c);
    rho = h->group->side * FLK_ROOT_OR_0(square);
    h->rod->axis.x = rho * u->x + c * u->y;
    h->rod->axis.y = rho * u->y - c * u->x;
    h->end->axis = *u;
    h->end->origin.x = p->x + l * h->rod->axis.x;
    h->end->origin.y = p->y + l * h->rod->axis.y;
    return square;
}

static void move_slider(const flk_hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *u = &h->group->direction, *e5 = &h->rod->axis, *v = &h->rod->k_origin;
    double l = h->group->rod, along;

    (void)pivot;
    h->rod->k = -FLK_CROSS(*u, *v) / (l * FLK_DOT(*u, *e5));
    along = FLK_DOT(*u, *v) - l * h->rod->k * FLK_CROSS(*u, *e5);
    h->end->k = 0;
    h->end->k_origin.x = along * u->x;
    h->end->k_origin.y = along * u->y;
}

static void accelerate_slider(const flk_hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *u = &h->group->direction, *e5 = &h->rod->axis;
    const fourlink_vector *a = &h->rod->acceleration;
    double l = h->group->rod, n = l * h->rod->omega * h->rod->omega, along;

    (void)pivot;
    h->rod->alpha = (n * FLK_CROSS(*u, *e5) - FLK_CROSS(*u, *a)) / (l * FLK_DOT(*u, *e5));
    along = FLK_DOT(*u, *a) - l * h->rod->alpha * FLK_CROSS(*u, *e5) - n * FLK_DOT(*u, *e5);
    h->end->alpha = 0;
    h->end->acceleration.x = along * u->x;
    h->end->acceleration.y = along * u->y;
}

/* The guide takes what is square to the line: FQ along it is the slider's own; the rest from the moments of
** the rod about P, with M5 its right-hand side,
**
**    FQ = Fu u + Fn nu,   Fu = u.f6,   -l e5 x FQ = M5
*/
static fourlink_vector solve_slider_by_rod(const fourlink_group *group,
                                           const fourlink_link_state *rod,
                                           const fourlink_link_state *end, const flk_body body[2])
{
    const fourlink_vector *u = &group->direction, *e5 = &rod->axis;
    double along = FLK_DOT(*u, body[1].force), across;
    fourlink_vector FQ;

    (void)end;
    across = (-FLK_MOMENT_ABOUT_ORIGIN(&body[0]) / group->rod - FLK_CROSS(*e5, *u) * along) /
             FLK_DOT(*e5, *u);
    FQ.x = along * u->x - across * u->y;
    FQ.y = along * u->y + across * u->x;
    return FQ;
}

/* --------------------------------------------------------------------------------------------- rocker
**
** With x = D - P, f its length, l and r the rod and the rocker, e5 and e6 their axes from P and from D,
**
**    h = (f^2 + l^2 - r^2) / (2 f),   Q = P + h x / f +- sqrt(l^2 - h^2) J x / f
**    sin^2 = ((l + r)^2 - f^2) (f^2 - (l - r)^2) / (2 l r)^2,   sqrt(l^2 - h^2) = l r |sin| / f
**
** and with S = e5 x e6, v and a of P relative to D,
**
**    omega5 = -e6.v / (l S)                                     omega6 = -e5.v / (r S)
**    alpha5 = (-e6.a + l omega5^2 e5.e6 - r omega6^2) / (l S)
**    alpha6 = (-e5.a + l omega5^2 - r omega6^2 e5.e6) / (r S)
**
** It is dead where rod and rocker are in line.
*/
static double place_rocker(const flk_hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *p = &h->rod->origin;
    double l = h->group->rod, r = h->group->length, f, along, across, square;
    fourlink_vector x, n;

    x.x = pivot->x - p->x;
    x.y = pivot->y - p->y;
    f = flk_length(x.x, x.y);
    square = ((l + r - f) / l) * ((l + r + f) / r) * ((f - fabs(l - r)) / l) *
             ((f + fabs(l - r)) / r) / 4;
    x.x /= f;
    x.y /= f;
    FLK_TURN_LEFT(n, x);
    along = (f + (l - r) * ((l + r) / f)) / 2;
    across = h->group->side * l * (r / f) * FLK_ROOT_OR_0(square);
    h->rod->axis.x = (along * x.x + across * n.x) / l;
    h->rod->axis.y = (along * x.y + across * n.y) / l;
    h->end->axis.x = ((along - f) * x.x + across * n.x) / r;
    h->end->axis.y = ((along - f) * x.y + across * n.y) / r;
    h->end->origin = *pivot;
    return square;
}

static void move_rocker(const flk_hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *e5 = &h->rod->axis, *e6 = &h->end->axis;
    double sine = FLK_CROSS(*e5, *e6);
    fourlink_vector v;

    v.x = h->rod->k_origin.x - pivot->x;
    v.y = h->rod->k_origin.y - pivot->y;
    h->rod->k = -FLK_DOT(*e6, v) / (h->group->rod * sine);
    h->end->k = -FLK_DOT(*e5, v) / (h->group->length * sine);
    h->end->k_origin = *pivot;
}

static void accelerate_rocker(const flk_hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *e5 = &h->rod->axis, *e6 = &h->end->axis;
    double sine = FLK_CROSS(*e5, *e6), cosine = FLK_DOT(*e5, *e6);
    double n5 = h->group->rod * h->rod->omega * h->rod->omega;
    double n6 = h->group->length * h->end->omega * h->end->omega;
    fourlink_vector a;

    a.x = h->rod->acceleration.x - pivot->x;
    a.y = h->rod->acceleration.y - pivot->y;
    h->rod->alpha = (n5 * cosine - n6 - FLK_DOT(*e6, a)) / (h->group->rod * sine);
    h->end->alpha = (n5 - n6 * cosine - FLK_DOT(*e5, a)) / (h->group->length * sine);
    h->end->acceleration = *pivot;
}

/* Moments of the rod about P and of the rocker about D, with M5 and M6 their right-hand sides:
**
**    -l e5 x FQ = M5,   r e6 x FQ = M6
*/
static fourlink_vector solve_rocker_by_rod(const fourlink_group *group,
                                           const fourlink_link_state *rod,
                                           const fourlink_link_state *end, const flk_body body[2])
{
    const fourlink_vector *e5 = &rod->axis, *e6 = &end->axis;
    double m5 = -FLK_MOMENT_ABOUT_ORIGIN(&body[0]) / group->rod;
    double m6 = FLK_MOMENT_ABOUT_ORIGIN(&body[1]) / group->length, sine = FLK_CROSS(*e5, *e6);
    fourlink_vector FQ;

    FQ.x = (m6 * e5->x - m5 * e6->x) / -sine;
    FQ.y = (m6 * e5->y - m5 * e6->y) / -sine;
    return FQ;
}

const flk_group_type flk_slider_by_rod = {place_slider_by_rod, move_slider, accelerate_slider,
                                          solve_slider_by_rod};
const flk_group_type flk_rocker_by_rod = {place_rocker, move_rocker, accelerate_rocker,
                                          solve_rocker_by_rod};
