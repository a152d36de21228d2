/* SPDX-License-Identifier: GPL-3.0-or-later
**
** klein.c - Klein's construction for a slider-crank (ME3491, example 2, "Graphical method").
**
** M is where the line of the rod meets the perpendicular to the line of stroke through the crankshaft O.
** The circle about B through M and the circle on the rod as diameter have a common chord; it meets the
** rod in Q, and the parallel to the line of stroke through O in N.  Then, at constant speed,
**
**    v = omega2 OM,   v_CB = omega2 BM,   a = omega2^2 ON,   alpha3 = omega2^2 QN / l
**
** N is the image of C, and g, which divides BN as G does the rod, that of G: gO is its acceleration.  The
** moments about I, the instantaneous centre of the rod, give its crank effort FT; X and Y are the feet of the
** perpendiculars on the lines of its weight W_C and of its inertia force F_C, which is parallel to gO:
**
**    FT IB = F_C IY - W_C IX,   F_C = m omega2^2 gO,   W_C = m g
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "figure.h"

/* Greek letters and the power, in UTF-8. */
#define OMEGA "\317\211"
#define ALPHA "\316\261"
#define SQUARE "\302\262"

typedef struct construction {
    fourlink_vector O, B, C, M, Q, N;
    fourlink_vector K, L;             /* the intersections of the circles */
    int meet;                         /* 0: there are none; the rod is shorter than BM */
    fourlink_vector I, G, g, X, Y, Z; /* Z beside G, on the line of F_C */
    int has_mass, is_near;            /* of the rod; and I is not far beyond the drawing */
} construction;

/* Find the points from the lengths of fourlink_klein_construction.  K and L end the chord, at BQ from B, of
** the circle about B with radius BM. */
static void construct(const picture *p, const fourlink_state *state, const fourlink_klein *lengths,
                      construction *k)
{
    figure_pins pins = figure_place(p, state);
    fourlink_vector u = state->link[FOURLINK_COUPLER].axis;
    double BM = lengths->BM, BQ = lengths->BQ, half;

    k->O = pins.A;
    k->B = pins.B;
    k->C = pins.C;
    k->M = place_in(pins.B, u, BM, 0);
    k->Q = place_in(pins.B, u, BQ, 0);
    k->N = place_in(k->Q, u, 0, -lengths->QN);
    k->meet = fabs(BM) >= BQ;
    half = k->meet ? sqrt(BM * BM - BQ * BQ) : 0;
    k->K = place_in(k->Q, u, 0, half);
    k->L = place_in(k->Q, u, 0, -half);
}

/* The foot of the perpendicular from a point on the line through another in this direction. */
static fourlink_vector foot(fourlink_vector from, fourlink_vector on, fourlink_vector direction)
{
    double square = direction.x * direction.x + direction.y * direction.y;
    double t = ((from.x - on.x) * direction.x + (from.y - on.y) * direction.y) / square;

    return place_in(on, direction, t, 0);
}

/* I, on the line of the crank and above C; IX and IY are not numbers where it is at infinity. */
static void construct_moments(const picture *p, const fourlink_state *state,
                              const fourlink_klein *lengths, construction *k)
{
    const fourlink_link *rod = &p->v.design->link[FOURLINK_COUPLER];
    double IY = lengths->IY * (lengths->BM < 0 ? -1 : 1);
    fourlink_vector BN = place_at(k->N.x - k->B.x, k->N.y - k->B.y), gO;

    k->has_mass = rod->mass > 0;
    k->is_near = 0;
    if (!gsl_finite(lengths->IX) || !gsl_finite(lengths->IY))
        return;
    k->I = place_at(k->C.x, k->C.x * k->B.y / k->B.x);
    k->is_near = gsl_hypot(k->I.x, k->I.y) < 3 * gsl_hypot(k->C.x, k->C.y);
    k->G = geometry_of_link(state, FOURLINK_COUPLER, &rod->cg);
    k->X = foot(k->I, k->G, p->v.design->gravity);
    k->g = place_in(k->B, BN, rod->cg.x / rod->length, rod->cg.y / rod->length);
    gO = place_at(k->O.x - k->g.x, k->O.y - k->g.y);
    k->Y = place_in(k->I, gO, 0, -IY / gsl_hypot(gO.x, gO.y));
    k->Z = foot(k->G, k->Y, gO);
}

/* Note a length of the drawing that is finite; rounding error, compared with the rod's length, is 0. */
static void put_length(sketch *s, const picture *p, const char *name, double length)
{
    double rod = p->v.design->link[FOURLINK_COUPLER].length;

    if (gsl_finite(length))
        figure_note(s, p, name, format_settled(length, rod), QUANTITY_LENGTH);
}

/* Draw the lines at the crank, and put each letter on the side away from the middle of the rod. */
static void draw_crank(sketch *s, const construction *k, double rod)
{
    fourlink_vector middle = place_middle(k->B, k->C);
    double BM = place_distance(k->B, k->M);
    double of_K = atan2(k->K.y - middle.y, k->K.x - middle.x);
    double of_B = atan2(k->B.y - middle.y, k->B.x - middle.x), side = 0;

    sketch_arc(s, PEN_CONSTRUCTION, k->B, BM, 0, 2 * M_PI);
    if (k->meet)
        side = fabs(flk_cycle_beside(of_K - of_B, 2 * M_PI)) * 1.2;
    sketch_arc(s, PEN_CONSTRUCTION, middle, rod / 2, of_B - side, of_B + side);
    if (k->meet)
        sketch_line(s, PEN_CONSTRUCTION, k->K, k->L);
    sketch_line(s, PEN_CONSTRUCTION, k->O, k->N);
    sketch_line(s, PEN_CONSTRUCTION, k->B, k->M);
    sketch_line(s, PEN_CRANK, k->O, k->B);
    sketch_line(s, PEN_RESULT, k->O, k->M);
    sketch_line(s, PEN_RESULT, k->B, k->Q);
    sketch_line(s, PEN_RESULT, k->Q, k->N);
    sketch_line(s, PEN_FOLLOWER, k->N, k->O);
    sketch_pin(s, k->O, "O");
    sketch_pin(s, k->B, "B");
    figure_letter(s, k->O, middle, k->B, "O");
    figure_letter(s, k->B, middle, k->O, "B");
    figure_letter(s, k->M, middle, k->O, "M");
    figure_letter(s, k->Q, k->N, k->C, "Q");
    figure_letter(s, k->N, k->Q, k->Q, "N");
    if (k->meet) {
        figure_letter(s, k->K, k->L, k->L, "K");
        figure_letter(s, k->L, k->K, k->K, "L");
    }
}

/* Draw the whole: the rod with its circle, the slider on its line of stroke, the ground. */
static void draw_whole(sketch *s, const picture *p, const fourlink_state *state,
                       const construction *k, double rod)
{
    fourlink_vector middle = place_middle(k->B, k->C);
    double overhang = 0.12 * s->size * (k->C.x < 0 ? -1 : 1);

    figure_frame(s, p, state);
    sketch_line(s, PEN_CONSTRUCTION, place_at(-overhang, k->C.y),
                place_at(k->C.x + overhang, k->C.y));
    sketch_arc(s, PEN_CONSTRUCTION, middle, rod / 2, 0, 2 * M_PI);
    sketch_line(s, PEN_COUPLER, k->B, k->C);
    draw_crank(s, k, rod);
    figure_sense(s, state, k->O);
    figure_piston(s, PEN_FOLLOWER, k->C, &state->link[FOURLINK_FOLLOWER].axis);
    sketch_pin(s, k->C, "C");
    figure_letter(s, k->C, middle, middle, "C");
}

/* Draw the crank enlarged, with the beginning of the rod. */
static void put_inset(picture *p, const construction *k, double rod)
{
    double crank = p->v.design->link[FOURLINK_CRANK].length;
    sketch s;

    sketch_open(&s, &p->on, &p->v.units[QUANTITY_LENGTH], 2 * crank);
    sketch_line(
        &s, PEN_COUPLER, k->B,
        place_in(k->B, place_at((k->C.x - k->B.x) / rod, (k->C.y - k->B.y) / rod), 0.8 * crank, 0));
    draw_crank(&s, k, rod);
    if (k->is_near) {
        sketch_line(&s, PEN_CONSTRUCTION, k->B, k->N);
        sketch_line(&s, PEN_FORCE, k->g, k->O);
        figure_letter(&s, k->g, k->O, k->B, "g");
    }
    sketch_close(&s, "at the crank, enlarged");
}

static void draw_moments(sketch *s, const construction *k)
{
    sketch_line(s, PEN_CONSTRUCTION, k->B, k->N);
    sketch_line(s, PEN_CONSTRUCTION, k->B, k->I);
    sketch_line(s, PEN_CONSTRUCTION, k->C, k->I);
    sketch_line(s, PEN_CONSTRUCTION, k->G, k->X);
    sketch_line(s, PEN_CONSTRUCTION, k->Z, k->Y);
    sketch_line(s, PEN_FORCE, k->g, k->O);
    sketch_line(s, PEN_FORCE, k->I, k->Y);
    sketch_line(s, PEN_LOAD, k->I, k->X);
    sketch_centre(s, k->G, "G");
    figure_letter(s, k->I, k->X, k->C, "I");
    figure_letter(s, k->X, k->I, k->G, "X");
    figure_letter(s, k->Y, k->I, k->Z, "Y");
    figure_letter(s, k->g, k->O, k->B, "g");
    figure_letter(s, k->G, k->X, k->B, "G");
}

/* Put what is read from the lengths. */
static void put_readings(sketch *s, const picture *p, const fourlink_state *state,
                         const fourlink_klein *lengths)
{
    double omega = state->link[FOURLINK_CRANK].omega, square = omega * omega;
    double rod = p->v.design->link[FOURLINK_COUPLER].length;

    figure_note(s, p, "v = " OMEGA SUB_2 " OM", omega * format_settled(lengths->OM, rod),
                QUANTITY_SPEED);
    figure_note(s, p, OMEGA SUB_3 " = " OMEGA SUB_2 " BM / BC",
                omega * format_settled(lengths->BM / rod, 1), QUANTITY_ANGULAR_SPEED);
    figure_note(s, p, "a = " OMEGA SUB_2 SQUARE " ON", square * format_settled(lengths->ON, rod),
                QUANTITY_ACCELERATION);
    figure_note(s, p, ALPHA SUB_3 " = " OMEGA SUB_2 SQUARE " QN / BC",
                square * format_settled(lengths->QN / rod, 1), QUANTITY_ANGULAR_ACCELERATION);
    if (state->link[FOURLINK_CRANK].alpha != 0)
        sketch_note(s, "a and " ALPHA SUB_3 " for " ALPHA SUB_2 " = 0");
    sketch_note(s, "v and a are positive away");
    sketch_note(s, "from the inner dead centre");
}

static void put_values(sketch *s, const picture *p, const fourlink_state *state,
                       const fourlink_klein *lengths, int has_mass)
{
    put_length(s, p, "OM", lengths->OM);
    put_length(s, p, "BM", lengths->BM);
    put_length(s, p, "BQ", lengths->BQ);
    put_length(s, p, "QN", lengths->QN);
    put_length(s, p, "ON", lengths->ON);
    put_readings(s, p, state, lengths);
    put_length(s, p, "IX", lengths->IX);
    put_length(s, p, "IY", lengths->IY);
    if (has_mass) {
        figure_note(s, p, "FT", lengths->FT, QUANTITY_FORCE);
        sketch_note(s, "FT IB = m " OMEGA SUB_2 SQUARE " gO IY - m g IX");
    }
    figure_slope(s, p);
}

const char *picture_klein(picture *p, fourlink_branch branch)
{
    fourlink_klein lengths;
    fourlink_instant now;
    construction k;
    sketch s;
    double rod = p->v.design->link[FOURLINK_COUPLER].length;
    int status = picture_position(p, branch, &now, p->loads);

    if (status == FOURLINK_OK)
        status = fourlink_klein_construction(p->v.mechanism, &now.state, &lengths);
    if (status != FOURLINK_OK)
        return fourlink_status_text(status);
    construct(p, &now.state, &lengths, &k);
    construct_moments(p, &now.state, &lengths, &k);
    figure_open(&s, p, branch);
    draw_whole(&s, p, &now.state, &k, rod);
    if (k.is_near)
        draw_moments(&s, &k);
    put_values(&s, p, &now.state, &lengths, k.has_mass);
    figure_close(&s, p, &now, "Klein's construction, ");
    if (p->has_inset)
        put_inset(p, &k, rod);
    return NULL;
}
