/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_program.c - the program of a motion in the sample calculation: by the law of the part in which the
** time is, with its shape sigma and the derivatives of that by tau.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/text.h"
#include "mathml.h"
#include "report.h"
#include "sample_program.h"

/* The shape of a law, its derivatives and its integral, and up to which tau.  See mechanics/program.c. */
typedef struct shape {
    const char *law;
    int zone; /* of the law's parts, from 0 */
    const char *value, *rate, *second, *integral;
} shape;

static const shape shapes[] = {
    {"harmonic", 0, "{ 1 - cos ( pi * tau ) | 2 }", "{ pi * sin ( pi * tau ) | 2 }",
     "{ pi ^2 * cos ( pi * tau ) | 2 }", "{ tau | 2 } - { sin ( pi * tau ) | 2 * pi }"},
    {"cycloidal", 0, "tau - { sin ( 2 * pi * tau ) | 2 * pi }", "1 - cos ( 2 * pi * tau )",
     "2 * pi * sin ( 2 * pi * tau )", "{ tau ^2 | 2 } - { 1 - cos ( 2 * pi * tau ) | 4 * pi ^2 }"},
    {"3-4-5", 0, "10 * tau ^3 - 15 * tau ^4 + 6 * tau ^5", "30 * tau ^2 * ( 1 - tau )^2",
     "60 * tau * ( 1 - tau ) * ( 1 - 2 * tau )", "{ 5 * tau ^4 | 2 } - 3 * tau ^5 + tau ^6"},
    {"4-5-6-7", 0, "35 * tau ^4 - 84 * tau ^5 + 70 * tau ^6 - 20 * tau ^7",
     "140 * tau ^3 * ( 1 - tau ) * ( 1 - tau )^2", "420 * tau ^2 * ( 1 - tau )^2 * ( 1 - 2 * tau )",
     "7 * tau ^5 - 14 * tau ^6 + 10 * tau ^7 - { 5 * tau ^8 | 2 }"},
    {"modified-sine", 0, "{ pi * tau - { sin ( 4 * pi * tau ) | 4 } | 4 + pi }",
     "{ pi - pi * cos ( 4 * pi * tau ) | 4 + pi }", "{ 4 * pi ^2 * sin ( 4 * pi * tau ) | 4 + pi }",
     NULL},
    {"modified-sine", 1, "{ 2 + pi * tau - { 9 | 4 } * sin { 4 * pi * tau + pi | 3 } | 4 + pi }",
     "{ pi - 3 * pi * cos { 4 * pi * tau + pi | 3 } | 4 + pi }",
     "{ 4 * pi ^2 * sin { 4 * pi * tau + pi | 3 } | 4 + pi }", NULL},
    {"modified-sine", 2, "{ 4 + pi * tau - { sin ( 4 * pi * tau ) | 4 } | 4 + pi }",
     "{ pi - pi * cos ( 4 * pi * tau ) | 4 + pi }", "{ 4 * pi ^2 * sin ( 4 * pi * tau ) | 4 + pi }",
     NULL},
    {"cubic", 0, "3 * tau ^2 - 2 * tau ^3", "6 * tau * ( 1 - tau )", "6 - 12 * tau",
     "tau ^3 - { tau ^4 | 2 }"},
    {"trapezoid", 0, "{ sigmam * tau ^2 | 2 * taua }", "{ sigmam * tau | taua }",
     "{ sigmam | taua }", "{ sigmam * tau ^3 | 6 * taua }"},
    {"trapezoid", 1, "sigmam * ( tau - { taua | 2 } )", "sigmam", "0",
     "sigmam * ( { taua ^2 | 6 } + { tau * ( tau - taua ) | 2 } )"},
    {"trapezoid", 2, "1 - { sigmam * ( 1 - tau )^2 | 2 * taub }", "{ sigmam * ( 1 - tau ) | taub }",
     "- { sigmam | taub }", NULL},
    {"linear", 0, "tau", "1", "0", "{ tau ^2 | 2 }"}};

#define SHAPES (sizeof shapes / sizeof shapes[0])

/* The symbols of what a program moves: itself, its speed, its acceleration, at its beginning; and its
** rise. */
typedef struct symbols {
    const char *q, *rate, *second, *begin, *rise, *begin_of_speed, *rise_of_speed;
} symbols;

static const symbols of_crank = {"theta2", "omega2", "alpha2", "theta0",
                                 "Dtheta", "omega0", "Domega"},
                     of_follower = {"theta4", "omega4", "alpha4", "theta0",
                                    "Dtheta", "omega0", "Domega"},
                     of_pin = {"xC", "vC", "aC", "q0", "Dq", "v0", "Dv"},
                     of_length = {"q", "vq", "aq", "q0", "Dq", "v0", "Dv"};

static const shape *find_shape(const fourlink_program_part *part, double tau)
{
    int zone = 0;
    size_t i;

    if (strcmp(part->law, "modified-sine") == 0)
        zone = tau < 0.125 ? 0 : tau <= 0.875 ? 1 : 2;
    else if (strcmp(part->law, "trapezoid") == 0)
        zone = tau < part->ramp[0] ? 0 : tau < 1 - part->ramp[1] || part->ramp[1] <= 0 ? 1 : 2;
    for (i = 0; i < SHAPES; i++)
        if (strcmp(shapes[i].law, part->law) == 0 && shapes[i].zone == zone)
            return &shapes[i];
    return NULL;
}

/* What the program moves, and where it is now; 0 if there are no symbols for it. */
static int find_moved(const report *r, const symbols **names, double now[3])
{
    const fourlink_state *state = &r->now.state;
    const char *input = view_input(&r->v);

    *names = &of_length;
    if (!input) {
        *names = &of_crank;
        now[0] = r->now.row.crank.theta2;
        now[1] = r->now.row.crank.omega2;
        now[2] = r->now.row.crank.alpha2;
    } else if (strcmp(input, "theta4") == 0) {
        *names = &of_follower;
        now[0] = state->link[4].theta;
        now[1] = state->link[4].omega;
        now[2] = state->link[4].alpha;
    } else if (strcmp(input, "C.x") == 0) {
        *names = &of_pin;
        now[0] = state->link[4].origin.x;
        now[1] = state->link[4].velocity.x;
        now[2] = state->link[4].acceleration.x;
    } else if (strcmp(input, "x") == 0) {
        now[0] = state->x;
        now[1] = state->v;
        now[2] = state->a;
    } else if (strcmp(input, "slide") == 0) {
        now[0] = state->slide;
        now[1] = state->slide_v;
        now[2] = state->slide_a;
    } else {
        return 0;
    }
    return 1;
}

/* About where an angle is, to tell its whole turns. */
static double expected(const fourlink_program_part *part, double tau)
{
    return part->is_of_speed ? part->coordinate + (part->end - part->begin) * tau *
                                                      (part->value + part->rise * tau / 2)
                             : part->value + part->rise * tau;
}

/* Write what is given of the part of the program. */
static void put_given(report *r, math *m, const fourlink_program_part *part, const symbols *x)
{
    page_print(m->p, "<ul class=\"given\">\n");
    math_given(m, "t", r->now.row.time);
    math_given(m, "t0", part->begin);
    math_given(m, "te", part->end);
    if (part->is_of_speed) {
        math_given(m, x->begin, part->coordinate);
        math_given(m, x->begin_of_speed, part->value);
        math_given(m, x->rise_of_speed, part->rise);
    } else {
        math_given(m, x->begin, part->value);
        math_given(m, x->rise, part->rise);
    }
    page_print(m->p, "</ul>\n");
    math_let(m, "tS", "te - t0", part->end - part->begin);
    math_let(m, "tau", "{ t - t0 | tS }",
             (r->now.row.time - part->begin) / (part->end - part->begin));
}

/* Evaluate a shape with the numbers of a part: its derivatives by tau are those of the motion, if it
** rises. */
static void put_shape(math *m, const fourlink_program_part *part, const shape *s, double tau,
                      const double now[3])
{
    double length = part->end - part->begin, a = part->ramp[0], b = part->ramp[1];
    double value = (now[part->is_of_speed] - part->value) / part->rise;

    if (strstr(s->value, "pi") || strstr(s->rate, "pi"))
        math_set(m, "pi", M_PI);
    if (strcmp(s->law, "trapezoid") == 0) {
        page_print(m->p, "<p>The speed rises up to \317\204<sub>a</sub> and falls in "
                         "\317\204<sub>b</sub>; between them it is \317\203<sub>m</sub>:</p>\n<ul "
                         "class=\"given\">\n");
        math_given(m, "taua", a);
        math_given(m, "taub", b);
        page_print(m->p, "</ul>\n");
        math_let(m, "sigmam", "{ 2 | 2 - taua - taub }", 1 / (1 - (a + b) / 2));
    }
    math_let(m, "sigma", s->value, value);
    math_let(m, "sigma1", s->rate, now[1 + part->is_of_speed] * length / part->rise);
    if (!part->is_of_speed)
        math_let(m, "sigma2", s->second, now[2] * length * length / part->rise);
    else
        math_let(m, "Sigma", s->integral,
                 (now[0] - part->coordinate - part->value * length * tau) / (part->rise * length));
}

static void put_motion(math *m, const fourlink_program_part *part, const symbols *x,
                       const double now[3])
{
    char equation[MATH_EQUATION];

    if (part->is_of_speed) {
        flk_text_join(equation, sizeof equation, x->begin, " + tS * ( ", x->begin_of_speed,
                      " * tau + ", x->rise_of_speed, " * Sigma )", (char *)NULL);
        math_let(m, x->q, equation, now[0]);
        flk_text_join(equation, sizeof equation, x->begin_of_speed, " + ", x->rise_of_speed,
                      " * sigma", (char *)NULL);
        math_let(m, x->rate, equation, now[1]);
        flk_text_join(equation, sizeof equation, "{ ", x->rise_of_speed, " * sigma1 | tS }",
                      (char *)NULL);
        math_let(m, x->second, equation, now[2]);
        return;
    }
    flk_text_join(equation, sizeof equation, x->begin, " + ", x->rise, " * sigma", (char *)NULL);
    math_let(m, x->q, equation, now[0]);
    flk_text_join(equation, sizeof equation, "{ ", x->rise, " * sigma1 | tS }", (char *)NULL);
    math_let(m, x->rate, equation, now[1]);
    flk_text_join(equation, sizeof equation, "{ ", x->rise, " * sigma2 | tS ^2 }", (char *)NULL);
    math_let(m, x->second, equation, now[2]);
}

/* A spline of positions by the second derivatives at the ends of its part. */
static void put_spline(math *m, const fourlink_program_part *part, const symbols *x, double tau,
                       const double now[3])
{
    const char *first = part->is_angle ? "alpha0" : "aq0",
               *last = part->is_angle ? "alphae" : "aqe";
    char equation[2 * MATH_EQUATION];

    page_print(m->p, "<p>A spline, with its second derivatives at both ends:</p>\n<ul "
                     "class=\"given\">\n");
    math_given(m, first, part->bend[0]);
    math_given(m, last, part->bend[1]);
    page_print(m->p, "</ul>\n");
    math_let(m, "tau1", "1 - tau", 1 - tau);
    flk_text_join(equation, sizeof equation, x->begin, " + ", x->rise,
                  " * tau + { tS ^2 | 6 } * ( ", first, " * ( tau1 ^3 - tau1 ) + ", last,
                  " * ( tau ^3 - tau ) )", (char *)NULL);
    math_let(m, x->q, equation, now[0]);
    flk_text_join(equation, sizeof equation, "{ ", x->rise, " | tS } + { tS | 6 } * ( ", last,
                  " * ( 3 * tau ^2 - 1 ) - ", first, " * ( 3 * tau1 ^2 - 1 ) )", (char *)NULL);
    math_let(m, x->rate, equation, now[1]);
    flk_text_join(equation, sizeof equation, first, " * tau1 + ", last, " * tau", (char *)NULL);
    math_let(m, x->second, equation, now[2]);
}

void sample_put_program(report *r, math *m)
{
    fourlink_program_part part;
    const symbols *names;
    const shape *s = NULL;
    double now[3], tau;
    int is_spline;

    if (fourlink_deck_program(r->v.deck, r->now.row.time, &part) != FOURLINK_OK ||
        !find_moved(r, &names, now))
        return;
    tau = (r->now.row.time - part.begin) / (part.end - part.begin);
    if (part.is_angle)
        now[0] -= 2 * M_PI * flk_cycle_nearest(now[0] - expected(&part, tau), 2 * M_PI);
    is_spline = strcmp(part.law, "spline") == 0;
    if (!is_spline)
        s = find_shape(&part, tau);
    if ((is_spline && part.is_of_speed) || (!is_spline && (!s || part.rise == 0)) ||
        (s && part.is_of_speed && !s->integral))
        return;
    page_print(m->p,
               "<h3>Program</h3>\n<p>The time is in the part of the program from t<sub>0</sub> "
               "to t<sub>e</sub>, by the law <b>%s</b>%s:</p>\n",
               part.law, names == &of_length ? "; q is what moves by it" : "");
    put_given(r, m, &part, names);
    if (is_spline) {
        put_spline(m, &part, names, tau, now);
        return;
    }
    put_shape(m, &part, s, tau, now);
    put_motion(m, &part, names, now);
}
