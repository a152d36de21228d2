/* SPDX-License-Identifier: GPL-3.0-or-later
**
** samples.h - Alvi's linkage with masses, and random mechanisms with masses and loads, for the tests of
** forces.
*/
#ifndef FOURLINK_SAMPLES_H
#define FOURLINK_SAMPLES_H

#include "check.h"
#include "fourlink.h"

#define MOST_LOADS 4

typedef struct sample {
    fourlink_design design;
    fourlink_mechanism mechanism;
    fourlink_branch branch;
    fourlink_crank crank;
    fourlink_load load[MOST_LOADS];
    unsigned long n_loads;
    fourlink_state state;
    fourlink_forces forces;
} sample;

/* Either kind in turn; lengths of 0.3 to 3 m, centres of mass off the line and outside the pins; some
** links without mass, some cranks without speed, some rows without loads. */
static inline void draw_design(uint64_t *seed, int n, sample *s)
{
    unsigned long k;
    int i;

    memset(s, 0, sizeof *s);
    s->design.kind = n % 2 ? FOURLINK_SLIDER_CRANK : FOURLINK_FOUR_BAR;
    for (i = 1; i <= 4; i++) {
        fourlink_link *link = &s->design.link[i];

        link->length = uniform(seed, 0.3, 3);
        link->mass = uniform(seed, 0, 1) < 0.1 ? 0 : uniform(seed, 0, 5);
        link->inertia = uniform(seed, 0, 1) < 0.1 ? 0 : uniform(seed, 0, 3);
        link->cg.x = uniform(seed, -1, 3);
        link->cg.y = uniform(seed, -1, 1);
    }
    s->design.offset = n % 2 ? uniform(seed, -1, 1) : 0;
    s->design.gravity.x = uniform(seed, -10, 10);
    s->design.gravity.y = uniform(seed, -10, 10);
    s->branch = uniform(seed, 0, 1) < 0.5 ? FOURLINK_OPEN : FOURLINK_CROSSED;
    s->crank.theta2 = uniform(seed, -3 * PI, 3 * PI);
    s->crank.omega2 = n % 10 < 2 ? 0 : uniform(seed, -5, 5);
    s->crank.alpha2 = uniform(seed, -30, 30);
    s->n_loads = (unsigned long)uniform(seed, 0, MOST_LOADS + 1);
    for (k = 0; k < s->n_loads; k++) {
        fourlink_load *load = &s->load[k];

        load->link = (int)uniform(seed, 2, 5);
        load->frame = uniform(seed, 0, 1) < 0.5 ? FOURLINK_FRAME_GROUND : FOURLINK_FRAME_LINK;
        load->force.x = uniform(seed, -100, 100);
        load->force.y = uniform(seed, -100, 100);
        load->at.x = uniform(seed, -2, 2);
        load->at.y = uniform(seed, -2, 2);
        load->torque = uniform(seed, -100, 100);
    }
}

/* At the ends of the range of numbers. */
static inline void draw_extreme(uint64_t *seed, int n, sample *s)
{
    double large = pow(10, uniform(seed, -15, 14.5)), small = pow(10, uniform(seed, -15, 14.5));
    int i;

    memset(s, 0, sizeof *s);
    s->design.kind = n % 2 ? FOURLINK_SLIDER_CRANK : FOURLINK_FOUR_BAR;
    for (i = 1; i <= 4; i++) {
        fourlink_link *link = &s->design.link[i];

        link->length = ((n >> i) & 1 ? large : small) * uniform(seed, 1, 2);
        link->mass = link->inertia = FOURLINK_NUMBER_MAX;
        link->cg.x = link->length;
        link->cg.y = -link->length / 2;
    }
    s->design.gravity.x = FOURLINK_NUMBER_MAX;
    s->branch = n % 3 ? FOURLINK_OPEN : FOURLINK_CROSSED;
    s->crank.theta2 = uniform(seed, 0, 6.3);
    s->crank.omega2 = s->crank.alpha2 = -FOURLINK_NUMBER_MAX;
    s->load[0].link = 2 + n % 3;
    s->load[0].force.y = s->load[0].torque = FOURLINK_NUMBER_MAX;
    s->load[0].at.x = FOURLINK_LENGTH_MAX;
    s->n_loads = 1;
}

/* Alvi's linkage with the masses of the matrix example. */
static inline sample rocker(double degrees)
{
    static const double length[5] = {0, 0.080, 0.020, 0.066, 0.056};
    static const double mass[5] = {0, 0, 0.1, 0.3, 0.25}, k[5] = {0, 0, 0.008, 0.025, 0.020};
    sample s;
    int i;

    memset(&s, 0, sizeof s);
    s.design.kind = FOURLINK_FOUR_BAR;
    for (i = 1; i <= 4; i++) {
        s.design.link[i].length = length[i];
        s.design.link[i].mass = mass[i];
        s.design.link[i].inertia = mass[i] * k[i] * k[i];
    }
    s.design.link[2].cg.x = 0.010;
    s.design.link[3].cg.x = 0.030 * cos(10 * DEG);
    s.design.link[3].cg.y = 0.030 * sin(10 * DEG);
    s.design.link[4].cg.x = 0.028 * cos(5 * DEG);
    s.design.link[4].cg.y = -0.028 * sin(5 * DEG);
    s.design.gravity.y = -9.81;
    s.branch = FOURLINK_OPEN;
    s.crank.theta2 = degrees * DEG;
    s.crank.omega2 = 10.5;
    return s;
}

/* As draw_design, and every third an inverted slider-crank. */
static inline void draw_any(uint64_t *seed, int n, sample *s)
{
    draw_design(seed, n, s);
    if (n % 3 != 2)
        return;
    s->design.kind = FOURLINK_INVERTED_SLIDER_CRANK;
    if (n % 2)
        s->design.link[4].length = 0;
    s->design.offset = uniform(seed, -0.3, 0.3);
    s->design.angle = n % 2 ? 0 : uniform(seed, -3, 3);
}

/* Its motion; a status. */
static inline int move(sample *s)
{
    assert_int_equal(fourlink_prepare(&s->design, &s->mechanism), FOURLINK_OK);
    return fourlink_analyse(&s->mechanism, s->branch, &s->crank, s->load, s->n_loads, &s->state,
                            &s->forces);
}

#define N_FORCES 10

/* All forces of one answer, for comparison: moments divided by the crank's length. */
static inline void list(const fourlink_forces *f, double arm, double value[N_FORCES])
{
    value[0] = f->F12x;
    value[1] = f->F12y;
    value[2] = f->F23x;
    value[3] = f->F23y;
    value[4] = f->F34x;
    value[5] = f->F34y;
    value[6] = f->F14x;
    value[7] = f->F14y;
    value[8] = f->M14 / arm;
    value[9] = f->Ts / arm;
}

static inline double largest(const fourlink_forces *f, double arm)
{
    double value[N_FORCES], max = 0;
    int i;

    list(f, arm, value);
    for (i = 0; i < N_FORCES; i++)
        max = fmax(max, fabs(value[i]));
    return max;
}

static inline void assert_same_forces(const fourlink_forces *actual,
                                      const fourlink_forces *expected, double arm, double tolerance)
{
    double a[N_FORCES], e[N_FORCES];
    int i;

    list(actual, arm, a);
    list(expected, arm, e);
    for (i = 0; i < N_FORCES; i++)
        assert_near(a[i], e[i], tolerance);
}

static inline void assert_finite(const fourlink_forces *f)
{
    double value[N_FORCES];
    int i;

    list(f, 1, value);
    for (i = 0; i < N_FORCES; i++)
        assert_true(isfinite(value[i]));
    assert_true(isfinite(f->Ts_work) && isfinite(f->residual));
}

/* Hand each kind of bad load to a function, with the status that must refuse it.  `loads` are two good ones
** afterwards. */
static inline void try_bad_loads(const sample *s, fourlink_load loads[2],
                                 void assert_refused(const sample *s, const fourlink_load *loads,
                                                     unsigned long n_loads, int status))
{
    static const double no_numbers[] = {NAN, INFINITY, -INFINITY, 1.1e30, -1e31};
    static const int no_links[] = {-1, 0, 1, 5};
    double *numbers[5];
    size_t i;
    int field;

    memset(loads, 0, 2 * sizeof loads[0]);
    loads[0].link = loads[1].link = FOURLINK_FOLLOWER;
    assert_refused(s, NULL, 1, FOURLINK_NULL);
    for (i = 0; i < COUNT(no_links); i++) {
        loads[1].link = no_links[i];
        assert_refused(s, loads, 2, FOURLINK_BAD_LINK);
    }
    loads[1].link = FOURLINK_CRANK;
    loads[1].frame = (fourlink_frame)2;
    assert_refused(s, loads, 2, FOURLINK_BAD_FRAME);
    loads[1].frame = FOURLINK_FRAME_LINK;
    numbers[0] = &loads[1].force.x;
    numbers[1] = &loads[1].force.y;
    numbers[2] = &loads[1].at.x;
    numbers[3] = &loads[1].at.y;
    numbers[4] = &loads[1].torque;
    for (field = 0; field < 5; field++)
        for (i = 0; i < COUNT(no_numbers); i++) {
            *numbers[field] = no_numbers[i];
            assert_refused(s, loads, 2, FOURLINK_BAD_NUMBER);
            *numbers[field] = 0;
        }
}

/* A handler of GSL's errors that counts them. */
static int handled;

static inline void count_in_gsl(const char *reason, const char *file, int line, int error)
{
    (void)reason, (void)file, (void)line, (void)error;
    handled++;
}

#endif
