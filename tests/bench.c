/* SPDX-License-Identifier: GPL-3.0-or-later
**
** bench.c - speed, as ratios to GSL's LU decomposition of the same matrices in the same run.
**
** Each figure is the median of several rounds in which the candidates take turns, so that a busy
** machine disturbs all of them alike.
*/
#define _POSIX_C_SOURCE 200112L

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <gsl/gsl_linalg.h>
#include <gsl/gsl_math.h>

#include "fourlink.h"

#define ANGLES 360
#define ROUNDS 21
#define PASSES 100 /* over all angles, in a round */

typedef struct system {
    double A[9][9], b[9];
} system_;

static system_ systems[ANGLES];
static volatile double sink; /* keeps the compiler from leaving the work out */

static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void set_link(fourlink_link *link, double length, double mass, double k, double r, double at)
{
    link->length = length;
    link->mass = mass;
    link->inertia = mass * k * k;
    link->cg.x = r * cos(at);
    link->cg.y = r * sin(at);
}

/* data/me3491-matrix.deck */
static void make_four_bar(fourlink_mechanism *m, fourlink_load *load)
{
    fourlink_design d;

    memset(&d, 0, sizeof d);
    d.kind = FOURLINK_FOUR_BAR;
    d.link[1].length = 0.080;
    set_link(&d.link[2], 0.020, 0.10, 0.008, 0.010, 0);
    set_link(&d.link[3], 0.066, 0.30, 0.025, 0.030, 10 * M_PI / 180);
    set_link(&d.link[4], 0.056, 0.25, 0.020, 0.028, -5 * M_PI / 180);
    d.gravity.y = -9.81;
    memset(load, 0, sizeof *load);
    load->link = FOURLINK_FOLLOWER;
    load->torque = 0.5;
    if (fourlink_prepare(&d, m) != FOURLINK_OK)
        exit(EXIT_FAILURE);
}

/* The engine of ME3491, example 1. */
static void make_slider_crank(fourlink_mechanism *m, fourlink_load *load)
{
    fourlink_design d;

    memset(&d, 0, sizeof d);
    d.kind = FOURLINK_SLIDER_CRANK;
    set_link(&d.link[2], 0.150, 0, 0, 0, 0);
    set_link(&d.link[3], 0.450, 2, 0.175, 0.150, 0);
    d.link[4].mass = 2.5;
    d.gravity.y = -9.81;
    memset(load, 0, sizeof *load);
    load->link = FOURLINK_FOLLOWER;
    load->force.x = -20773.8;
    if (fourlink_prepare(&d, m) != FOURLINK_OK)
        exit(EXIT_FAILURE);
}

static double time_rows(const fourlink_mechanism *m, const fourlink_load *load)
{
    fourlink_crank crank = {0, 10.5, 0};
    fourlink_state state;
    fourlink_forces forces;
    double start = seconds();
    int pass, i;

    for (pass = 0; pass < PASSES; pass++)
        for (i = 0; i < ANGLES; i++) {
            crank.theta2 = i * (M_PI / 180);
            if (fourlink_analyse(m, FOURLINK_OPEN, &crank, load, 1, &state, &forces) != FOURLINK_OK)
                exit(EXIT_FAILURE);
            sink = sink + forces.Ts + state.link[3].alpha;
        }
    return (seconds() - start) / (PASSES * ANGLES);
}

/* The bare loop: decomposition and solution of the same 9x9 systems, the matrix copied because the
** decomposition overwrites it, the permutation allocated once. */
static double time_lu(gsl_permutation *p)
{
    double A[9][9], x[9], start = seconds();
    gsl_matrix_view Av = gsl_matrix_view_array(A[0], 9, 9);
    gsl_vector_view xv = gsl_vector_view_array(x, 9);
    int pass, i, sign;

    for (pass = 0; pass < PASSES; pass++)
        for (i = 0; i < ANGLES; i++) {
            gsl_vector_const_view bv = gsl_vector_const_view_array(systems[i].b, 9);

            memcpy(A, systems[i].A, sizeof A);
            gsl_linalg_LU_decomp(&Av.matrix, p, &sign);
            gsl_linalg_LU_solve(&Av.matrix, p, &bv.vector, &xv.vector);
            sink = sink + x[8];
        }
    return (seconds() - start) / (PASSES * ANGLES);
}

static int by_size(const void *x, const void *y)
{
    double a = *(const double *)x, b = *(const double *)y;

    return (a > b) - (a < b);
}

static double median(double *x)
{
    qsort(x, ROUNDS, sizeof *x, by_size);
    return x[ROUNDS / 2];
}

static int report(const char *what, double ratio, double bound)
{
    printf("%-62s %5.2f  (at most %.2f)%s\n", what, ratio, bound, ratio <= bound ? "" : "  MISSED");
    return ratio > bound;
}

int main(void)
{
    fourlink_mechanism four_bar, slider_crank;
    fourlink_load torque, gas;
    gsl_permutation *p = gsl_permutation_alloc(9);
    double lu[ROUNDS], a[ROUNDS], b[ROUNDS];
    int i, missed = 0;

    make_four_bar(&four_bar, &torque);
    make_slider_crank(&slider_crank, &gas);
    for (i = 0; i < ANGLES; i++) {
        fourlink_crank crank = {i * (M_PI / 180), 10.5, 0};
        fourlink_state state;

        if (fourlink_analyse(&four_bar, FOURLINK_OPEN, &crank, &torque, 1, &state, NULL) ||
            fourlink_system(&four_bar, &state, &torque, 1, systems[i].A, systems[i].b))
            return EXIT_FAILURE;
    }
    for (i = 0; i < ROUNDS; i++) {
        lu[i] = time_lu(p);
        a[i] = time_rows(&four_bar, &torque);
        b[i] = time_rows(&slider_crank, &gas);
    }
    printf("gsl_linalg_LU_decomp + LU_solve, 9x9: %.0f ns\n", 1e9 * median(lu));
    missed += report("four-bar row, 22 results / bare LU loop", median(a) / median(lu), 1.0);
    missed += report("slider-crank row / four-bar row", median(b) / median(a), 1.15);
    gsl_permutation_free(p);
    return missed ? EXIT_FAILURE : EXIT_SUCCESS;
}
