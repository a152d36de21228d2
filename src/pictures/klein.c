/* SPDX-License-Identifier: GPL-3.0-or-later
**
** klein.c - Klein's construction for a slider-crank (ME3491, example 2, "Graphical method").
**
** M is where the line of the rod meets the perpendicular to the line of stroke through the crankshaft O.
** The circle about B through M and the circle on the rod as diameter have a common chord; it meets the
** rod in Q, and the parallel to the line of stroke through O in N.  Then, at constant speed,
**
**    v = omega2 OM,   v_CB = omega2 BM,   a = omega2^2 ON,   alpha3 = omega2^2 QN / l
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "figure.h"

typedef struct construction {
    fourlink_vector O, B, C, M, Q, N;
    fourlink_vector K, L; /* the intersections of the circles */
    int meet;             /* 0: there are none; the rod is shorter than BM */
} construction;

/* Find the points from the lengths of fourlink_klein_construction.  K and L end the chord, at BQ from B, of
** the circle about B with radius BM. */
static void construct(const picture *p, const fourlink_state *state, const fourlink_klein *lengths,
                      construction *k)
{
    figure_pins pins = figure_place(p, state);
    fourlink_vector u = state->link[FOURLINK_COUPLER].axis;
    double BM = figure_length(p, lengths->BM), BQ = figure_length(p, lengths->BQ);
    double QN = figure_length(p, lengths->QN), half;

    k->O = pins.A;
    k->B = pins.B;
    k->C = pins.C;
    k->M = sketch_beside(pins.B, BM * u.x, BM * u.y);
    k->Q = sketch_beside(pins.B, BQ * u.x, BQ * u.y);
    k->N = sketch_beside(k->Q, QN * u.y, -QN * u.x);
    k->meet = fabs(BM) >= BQ;
    half = k->meet ? sqrt(BM * BM - BQ * BQ) : 0;
    k->K = sketch_beside(k->Q, -half * u.y, half * u.x);
    k->L = sketch_beside(k->Q, half * u.y, -half * u.x);
}

/* Note a length of the drawing; rounding, compared with the rod's length, is 0. */
static void put_length(sketch *s, const picture *p, const char *name, double length)
{
    int is_rounding = fabs(length) < 1e-12 * p->design->link[FOURLINK_COUPLER].length;

    figure_note(s, p, name, is_rounding ? 0 : length, QUANTITY_LENGTH);
}

/* Draw the lines, and put each letter on the side away from the middle of the rod. */
static void draw_lines(sketch *s, const construction *k, double rod)
{
    fourlink_vector middle = sketch_at((k->B.x + k->C.x) / 2, (k->B.y + k->C.y) / 2);

    sketch_arc(s, PEN_CONSTRUCTION, k->B, gsl_hypot(k->M.x - k->B.x, k->M.y - k->B.y), 0, 2 * M_PI);
    sketch_arc(s, PEN_CONSTRUCTION, middle, rod / 2, 0, 2 * M_PI);
    if (k->meet)
        sketch_line(s, PEN_CONSTRUCTION, k->K, k->L);
    sketch_line(s, PEN_CONSTRUCTION, k->O, k->N);
    sketch_line(s, PEN_CONSTRUCTION, k->B, k->M);
    sketch_line(s, PEN_CRANK, k->O, k->B);
    sketch_line(s, PEN_COUPLER, k->B, k->C);
    sketch_line(s, PEN_RESULT, k->O, k->M);
    sketch_line(s, PEN_RESULT, k->B, k->Q);
    sketch_line(s, PEN_RESULT, k->Q, k->N);
    sketch_line(s, PEN_FOLLOWER, k->N, k->O);
    sketch_pin(s, k->O);
    sketch_pin(s, k->B);
    sketch_pin(s, k->C);
    figure_letter(s, k->O, middle, k->B, "O");
    figure_letter(s, k->B, middle, k->O, "B");
    figure_letter(s, k->C, middle, middle, "C");
    figure_letter(s, k->M, middle, k->O, "M");
    figure_letter(s, k->Q, k->N, k->C, "Q");
    figure_letter(s, k->N, k->Q, k->Q, "N");
    if (k->meet) {
        figure_letter(s, k->K, k->L, k->L, "K");
        figure_letter(s, k->L, k->K, k->K, "L");
    }
}

static void put_values(sketch *s, const picture *p, const fourlink_klein *lengths)
{
    put_length(s, p, "OM =", lengths->OM);
    put_length(s, p, "BM =", lengths->BM);
    put_length(s, p, "BQ =", lengths->BQ);
    put_length(s, p, "QN =", lengths->QN);
    put_length(s, p, "ON =", lengths->ON);
    sketch_note(s, "v = omega2 OM");
    sketch_note(s, "omega3 = omega2 BM / BC");
    sketch_note(s, "alpha2 = 0: a = omega2^2 ON");
    sketch_note(s, "alpha3 = omega2^2 QN / BC");
    sketch_note(s, "v and a are positive away");
    sketch_note(s, "from the inner dead centre");
    figure_slope(s, p);
}

const char *picture_klein(picture *p, fourlink_branch branch)
{
    fourlink_klein lengths;
    fourlink_instant now;
    construction k;
    sketch s;
    int status = picture_position(p, branch, &now, NULL);

    if (status == FOURLINK_OK)
        status = fourlink_klein_construction(p->mechanism, &now.state, &lengths);
    if (status != FOURLINK_OK)
        return fourlink_status_text(status);
    construct(p, &now.state, &lengths, &k);
    figure_open(&s, p, branch, 0);
    draw_lines(&s, &k, figure_length(p, p->design->link[FOURLINK_COUPLER].length));
    put_values(&s, p, &lengths);
    figure_close(&s, p, &now, "Klein's construction, ");
    return NULL;
}
