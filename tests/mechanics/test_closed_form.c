/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_closed_form.c - the closed form of the nine equations: against GSL's solution, put into the equations
** themselves, against the balance of power by points of the links, and against statics by hand.
*/
#include "samples.h"

#include <float.h>

static int solve(sample *s)
{
    assert_int_equal(fourlink_prepare(&s->design, &s->mechanism), FOURLINK_OK);
    return fourlink_analyse_dyad(&s->mechanism, s->branch, &s->crank, s->load, s->n_loads,
                                 &s->state, &s->forces);
}

static void draw(uint64_t *seed, int n, sample *s)
{
    do
        draw_design(seed, n, s);
    while (solve(s) != FOURLINK_OK);
}

/* A position close to the end of the crank's reach, where links 3 and 4 are almost in line. */
static void draw_near_dead(uint64_t *seed, int n, sample *s)
{
    fourlink_reach reach;

    do {
        draw_design(seed, n, s);
        assert_int_equal(fourlink_prepare(&s->design, &s->mechanism), FOURLINK_OK);
        assert_int_equal(fourlink_reach_of(&s->mechanism, &reach), FOURLINK_OK);
        if (reach.n_ranges)
            s->crank.theta2 = reach.to[0] - pow(10, uniform(seed, -13, -3));
    } while (!reach.n_ranges || solve(s) != FOURLINK_OK || fabs(s->state.sine) > 0.03);
}

/* ---------------------------------------------------------------------------------------------
** Against the matrix
** ------------------------------------------------------------------------------------------- */

static void assert_agrees(const sample *s, double tolerance)
{
    double arm = s->design.link[2].length, size;
    fourlink_forces by_matrix;

    assert_int_equal(fourlink_solve(&s->mechanism, &s->state, s->load, s->n_loads, &by_matrix),
                     FOURLINK_OK);
    size = largest(&by_matrix, arm);
    tolerance /= fabs(s->state.sine);
    assert_same_forces(&s->forces, &by_matrix, arm, tolerance * size);
    assert_near(s->forces.Ts_work, by_matrix.Ts, tolerance * size * arm);
    assert_near(s->forces.residual, 0, tolerance);
    if (s->design.kind == FOURLINK_FOUR_BAR)
        assert_true(s->forces.M14 == 0);
    else
        assert_true(s->forces.F14x == 0);
}

TEST(test_matrix)
{
    uint64_t seed = 1;
    sample s;
    int n;

    for (n = 0; n < 100000; n++) {
        draw(&seed, n, &s);
        assert_agrees(&s, 1e-12);
    }
}

/* The motion is that of fourlink_analyse, and the forces those of fourlink_solve_dyad, bit by bit. */
TEST(test_same_motion)
{
    uint64_t seed = 2;
    int n, link;

    for (n = 0; n < 2000; n++) {
        fourlink_forces forces;
        fourlink_state state;
        sample s;

        draw(&seed, n, &s);
        assert_int_equal(fourlink_solve_dyad(&s.mechanism, &s.state, s.load, s.n_loads, &forces),
                         FOURLINK_OK);
        assert_memory_equal(&forces, &s.forces, sizeof forces);
        assert_int_equal(
            fourlink_analyse(&s.mechanism, s.branch, &s.crank, s.load, s.n_loads, &state, &forces),
            FOURLINK_OK);
        for (link = 2; link <= 4; link++)
            assert_memory_equal(&state.link[link], &s.state.link[link], sizeof state.link[link]);
        assert_true(state.branch == s.state.branch && state.sine == s.state.sine);
        assert_true(state.mu == s.state.mu && state.phi == s.state.phi);
        assert_true(state.x == s.state.x && state.v == s.state.v && state.a == s.state.a);
        memset(&state, 0, sizeof state);
        assert_int_equal(
            fourlink_analyse_dyad(&s.mechanism, s.branch, &s.crank, NULL, 0, &state, NULL),
            FOURLINK_OK);
        assert_memory_equal(&state.link[2], &s.state.link[2], 3 * sizeof state.link[2]);
        assert_true(state.mu == s.state.mu);
    }
}

/* ---------------------------------------------------------------------------------------------
** Without the matrix's solution
** ------------------------------------------------------------------------------------------- */

/* What is left of each equation is rounding beside its largest term, whatever the condition. */
static double worst_row(const sample *s)
{
    double A[9][9], b[9], x[N_FORCES], worst = 0;
    int i, j;

    assert_int_equal(fourlink_system(&s->mechanism, &s->state, s->load, s->n_loads, A, b),
                     FOURLINK_OK);
    list(&s->forces, 1, x);
    if (s->design.kind == FOURLINK_SLIDER_CRANK)
        x[6] = s->forces.M14;
    x[8] = s->forces.Ts;
    for (i = 0; i < 9; i++) {
        double sum = -b[i], largest = fabs(b[i]);

        for (j = 0; j < 9; j++) {
            sum += A[i][j] * x[j];
            largest = fmax(largest, fabs(A[i][j] * x[j]));
        }
        if (!(fabs(sum) <= worst * largest))
            worst = fabs(sum) / largest;
    }
    return worst;
}

TEST(test_equations)
{
    uint64_t seed = 3;
    sample s;
    int n;

    for (n = 0; n < 20000; n++) {
        draw(&seed, n, &s);
        assert_near(worst_row(&s), 0, 2e-13);
    }
    s.forces.F34y *= 1 + 1e-9; /* such a difference shows */
    assert_true(worst_row(&s) > 1e-12);
}

TEST(test_near_dead)
{
    uint64_t seed = 4;
    double least = 1;
    int n;

    for (n = 0; n < 20000; n++) {
        sample s;

        draw_near_dead(&seed, n, &s);
        least = fmin(least, fabs(s.state.sine));
        /* where coupler and rocker fold, BD is small beside them, and so less exact */
        assert_near(worst_row(&s), 0, 1e-12);
        assert_agrees(&s, 1e-12);
    }
    assert_true(least < 2e-7);
}

/* Ts omega2 and the power of loads and weights are what the links take up, by the velocities and
** accelerations of their points. */
TEST(test_power)
{
    uint64_t seed = 5;
    int n, link;

    for (n = 0; n < 20000; n++) {
        double power, largest;
        unsigned long k;
        sample s;

        draw(&seed, n, &s);
        power = s.forces.Ts * s.crank.omega2;
        largest = fabs(power);
        for (link = 2; link <= 4; link++) {
            const fourlink_link *data = &s.design.link[link];
            const fourlink_link_state *is = &s.state.link[link];
            fourlink_vector v, a, g = s.design.gravity;

            fourlink_point(&s.state, link, &data->cg, NULL, &v, &a);
            power += data->mass * ((g.x - a.x) * v.x + (g.y - a.y) * v.y) -
                     data->inertia * is->alpha * is->omega;
            largest += data->mass * (hypot(g.x, g.y) + hypot(a.x, a.y)) * hypot(v.x, v.y) +
                       data->inertia * fabs(is->alpha * is->omega);
        }
        for (k = 0; k < s.n_loads; k++) {
            const fourlink_load *load = &s.load[k];
            const fourlink_link_state *is = &s.state.link[load->link];
            double turn = load->frame == FOURLINK_FRAME_LINK ? is->theta : 0;
            double x = load->force.x * cos(turn) - load->force.y * sin(turn);
            double y = load->force.x * sin(turn) + load->force.y * cos(turn);
            fourlink_vector v;

            fourlink_point(&s.state, load->link, &load->at, NULL, &v, NULL);
            power += x * v.x + y * v.y + load->torque * is->omega;
            largest += hypot(x, y) * hypot(v.x, v.y) + fabs(load->torque * is->omega);
        }
        assert_near(power, 0, 1e-13 / fabs(s.state.sine) * largest);
    }
}

/* The residual shows velocities that do not belong to the position. */
TEST(test_residual_notices)
{
    uint64_t seed = 6;
    int n, noticed = 0;

    for (n = 0; n < 200; n++) {
        fourlink_forces forces;
        sample s;

        draw(&seed, n, &s);
        s.state.link[3].k *= 1.01;
        assert_int_equal(fourlink_solve_dyad(&s.mechanism, &s.state, s.load, s.n_loads, &forces),
                         FOURLINK_OK);
        noticed += fabs(forces.residual) > 1e-6;
    }
    assert_true(noticed > 180);
}

/* Crank upright, coupler level, rocker as 3 : 4 : 5; at rest. */
TEST(test_four_bar_by_hand)
{
    sample s;

    memset(&s, 0, sizeof s);
    s.design.kind = FOURLINK_FOUR_BAR;
    s.design.link[1].length = s.design.link[4].length = 1.25;
    s.design.link[2].length = 1;
    s.design.link[3].length = 2;
    s.branch = FOURLINK_OPEN;
    s.crank.theta2 = PI / 2;
    s.n_loads = 1;
    s.load[0].link = FOURLINK_FOLLOWER;
    s.load[0].torque = 10;
    assert_int_equal(solve(&s), FOURLINK_OK);
    assert_near(s.state.sine, 0.8, 1e-15);
    assert_near(s.forces.F34x, 10, 1e-13); /* the coupler is a strut */
    assert_near(s.forces.F34y, 0, 1e-13);
    assert_near(s.forces.F14x, -10, 1e-13);
    assert_near(s.forces.F12x, 10, 1e-13);
    assert_near(s.forces.Ts, -10, 1e-13);
    assert_near(s.forces.Ts_work, -10, 1e-13);

    s.design.link[3].mass = 4; /* half of whose weight is at each end */
    s.design.link[3].cg.x = 1;
    s.design.gravity.y = -10;
    assert_int_equal(solve(&s), FOURLINK_OK);
    assert_near(s.forces.F34x, -5, 1e-13);
    assert_near(s.forces.F34y, -20, 1e-13);
    assert_near(s.forces.F23x, -5, 1e-13);
    assert_near(s.forces.F23y, 20, 1e-13);
    assert_near(s.forces.F12x, -5, 1e-13);
    assert_near(s.forces.F12y, 20, 1e-13);
    assert_near(s.forces.F14x, 5, 1e-13);
    assert_near(s.forces.F14y, 20, 1e-13);
    assert_near(s.forces.Ts, 5, 1e-13);
    assert_near(s.forces.Ts_work, 5, 1e-13);
}

/* Crank 3, rod 5, the piston at 4 from the crankshaft; on the crossed branch at -4. */
TEST(test_slider_crank_by_hand)
{
    sample s;
    int side;

    for (side = -1; side <= 1; side += 2) {
        memset(&s, 0, sizeof s);
        s.design.kind = FOURLINK_SLIDER_CRANK;
        s.design.link[2].length = 3;
        s.design.link[3].length = 5;
        s.branch = side > 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;
        s.crank.theta2 = PI / 2;
        s.n_loads = 1;
        s.load[0].link = FOURLINK_FOLLOWER;
        s.load[0].force.x = -80 * side;
        s.load[0].at.y = 0.5;
        assert_int_equal(solve(&s), FOURLINK_OK);
        assert_near(s.state.sine, 0.8 * side, 1e-15);
        assert_near(s.forces.F34x, 80 * side, 1e-12);
        assert_near(s.forces.F34y, -60, 1e-12);
        assert_near(s.forces.F14y, 60, 1e-12);
        assert_near(s.forces.M14, -40 * side, 1e-12);
        assert_near(s.forces.F12x, 80 * side, 1e-12);
        assert_near(s.forces.F12y, -60, 1e-12);
        assert_near(s.forces.Ts, -240 * side, 1e-12);
        assert_near(s.forces.Ts_work, -240 * side, 1e-12);
    }
}

/* Within the range of numbers, nothing overflows. */
TEST(test_extreme_numbers)
{
    uint64_t seed = 7;
    int n, solved = 0;

    for (n = 0; n < 20000; n++) {
        sample s;

        draw_extreme(&seed, n, &s);
        if (solve(&s) != FOURLINK_OK)
            continue;
        solved++;
        assert_finite(&s.forces);
    }
    assert_true(solved > 2000);
}

/* ---------------------------------------------------------------------------------------------
** Wrong calls
** ------------------------------------------------------------------------------------------- */

/* Both functions have the status of their counterparts, which is not 0, and write nothing. */
static void assert_refused(const sample *s, const fourlink_load *loads, unsigned long n_loads,
                           int status)
{
    struct {
        fourlink_state state;
        fourlink_forces forces;
    } out, pattern;
    fourlink_state state;
    fourlink_forces forces;

    memset(&out, 0xa5, sizeof out);
    memset(&pattern, 0xa5, sizeof pattern);
    assert_int_equal(fourlink_solve(&s->mechanism, &s->state, loads, n_loads, &forces), status);
    assert_int_equal(fourlink_solve_dyad(&s->mechanism, &s->state, loads, n_loads, &out.forces),
                     status);
    assert_int_equal(
        fourlink_analyse(&s->mechanism, s->branch, &s->crank, loads, n_loads, &state, &forces),
        status);
    assert_int_equal(fourlink_analyse_dyad(&s->mechanism, s->branch, &s->crank, loads, n_loads,
                                           &out.state, &out.forces),
                     status);
    assert_memory_equal(&out, &pattern, sizeof out);
}

TEST(test_bad_loads)
{
    fourlink_load loads[2];
    uint64_t seed = 8;
    sample s;
    int n;

    for (n = 0; n < 2; n++) {
        draw(&seed, n, &s);
        try_bad_loads(&s, loads, assert_refused);
        /* what lies beyond n_loads, or is not asked for, is not looked at */
        loads[1].link = 0;
        assert_int_equal(fourlink_solve_dyad(&s.mechanism, &s.state, loads, 1, &s.forces),
                         FOURLINK_OK);
        assert_int_equal(
            fourlink_analyse_dyad(&s.mechanism, s.branch, &s.crank, loads, 2, &s.state, NULL),
            FOURLINK_OK);
    }
}

TEST(test_null)
{
    uint64_t seed = 9;
    sample s;

    draw(&seed, 0, &s);
    assert_int_equal(fourlink_solve_dyad(NULL, &s.state, NULL, 0, &s.forces), FOURLINK_NULL);
    assert_int_equal(fourlink_solve_dyad(&s.mechanism, NULL, NULL, 0, &s.forces), FOURLINK_NULL);
    assert_int_equal(fourlink_solve_dyad(&s.mechanism, &s.state, NULL, 0, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_analyse_dyad(NULL, s.branch, &s.crank, NULL, 0, &s.state, &s.forces),
                     FOURLINK_NULL);
    assert_int_equal(
        fourlink_analyse_dyad(&s.mechanism, s.branch, NULL, NULL, 0, &s.state, &s.forces),
        FOURLINK_NULL);
    assert_int_equal(
        fourlink_analyse_dyad(&s.mechanism, s.branch, &s.crank, NULL, 0, NULL, &s.forces),
        FOURLINK_NULL);
}

/* Crank positions that there are not, and cranks that are no numbers: the status of fourlink_analyse,
** whichever of several faults it names. */
TEST(test_bad_cranks)
{
    int n, met[FOURLINK_STATUS_END_] = {0};
    uint64_t seed = 10;

    for (n = 0; n < 20000; n++) {
        struct {
            fourlink_state state;
            fourlink_forces forces;
        } out, pattern;
        fourlink_state state;
        fourlink_forces forces;
        int status;
        sample s;

        draw_design(&seed, n, &s);
        assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
        if (uniform(&seed, 0, 1) < 0.1)
            s.crank.omega2 = NAN;
        if (uniform(&seed, 0, 1) < 0.1)
            s.crank.alpha2 = -1e31;
        if (uniform(&seed, 0, 1) < 0.1)
            s.crank.theta2 = INFINITY;
        if (uniform(&seed, 0, 1) < 0.1)
            s.branch = (fourlink_branch)0;
        if (uniform(&seed, 0, 1) < 0.1)
            s.load[0].link = 1;
        memset(&out, 0xa5, sizeof out);
        memset(&pattern, 0xa5, sizeof pattern);
        status =
            fourlink_analyse(&s.mechanism, s.branch, &s.crank, s.load, s.n_loads, &state, &forces);
        assert_int_equal(fourlink_analyse_dyad(&s.mechanism, s.branch, &s.crank, s.load, s.n_loads,
                                               &out.state, &out.forces),
                         status);
        met[status]++;
        if (status != FOURLINK_OK)
            assert_memory_equal(&out, &pattern, sizeof out);
    }
    assert_true(met[FOURLINK_OK] > 100 && met[FOURLINK_TOO_FAR] > 100);
    assert_true(met[FOURLINK_TOO_NEAR] > 100 && met[FOURLINK_ROD_TOO_SHORT] > 100);
    assert_true(met[FOURLINK_BAD_NUMBER] > 100 && met[FOURLINK_BAD_BRANCH] > 100);
    assert_true(met[FOURLINK_BAD_LINK] > 100);
}

/* States that no position gives, but a caller may: links in one line, and no numbers. */
TEST(test_singular)
{
    static const double in_line[] = {0, 1e-14, -1e-14, NAN};
    gsl_error_handler_t *old = gsl_set_error_handler(count_in_gsl);
    fourlink_forces forces, pattern;
    uint64_t seed = 11;
    int n, link;
    size_t i;

    memset(&forces, 0xa5, sizeof forces);
    memset(&pattern, 0xa5, sizeof pattern);
    for (n = 0; n < 2; n++) {
        sample s, bad;

        draw(&seed, n, &s);
        for (i = 0; i < COUNT(in_line); i++) {
            bad = s;
            bad.state.sine = in_line[i];
            assert_int_equal(fourlink_solve_dyad(&bad.mechanism, &bad.state, NULL, 0, &forces),
                             FOURLINK_SINGULAR);
        }
        for (link = 2; link <= 4; link++) {
            bad = s;
            bad.state.link[link].axis.x = NAN;
            assert_int_equal(fourlink_solve_dyad(&bad.mechanism, &bad.state, NULL, 0, &forces),
                             FOURLINK_SINGULAR);
            bad = s;
            bad.state.link[link].axis.y = INFINITY;
            assert_int_equal(fourlink_solve_dyad(&bad.mechanism, &bad.state, NULL, 0, &forces),
                             FOURLINK_SINGULAR);
        }
        assert_memory_equal(&forces, &pattern, sizeof forces);
        bad = s;
        memset(&bad.state, 0, sizeof bad.state);
        assert_refused(&bad, NULL, 1, FOURLINK_NULL); /* which goes before */
        assert_int_equal(fourlink_solve_dyad(&bad.mechanism, &bad.state, NULL, 0, &forces),
                         FOURLINK_SINGULAR);
    }
    assert_int_equal(handled, 0);
    gsl_error("does the handler count?", __FILE__, __LINE__, GSL_EFAILED);
    assert_int_equal(handled, 1);
    gsl_set_error_handler(old);
}

int main(void)
{
    return run_all_tests(NULL);
}
