/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_errata.c - every number of data/ERRATA.md, computed: what the source's formula gives as it is
** printed, and what is right.  The tests bear the numbers of the page.
*/
#include "check.h"
#include "fourlink.h"

#include <gsl/gsl_linalg.h>

/* Alvi's example, sections 4.1 and 5.1: mm, rad/s. */
static const double a = 20, b = 66, c = 56, d = 80, omega = 10.5;

static fourlink_mechanism alvi;

static void set_link(fourlink_link *link, double length, double mass, double k, double r, double at)
{
    link->length = length;
    link->mass = mass;
    link->inertia = mass * k * k;
    link->cg.x = r * cos(at);
    link->cg.y = r * sin(at);
}

/* Alvi's linkage with the masses of data/me3491-matrix.deck. */
static int prepare(void **unused)
{
    fourlink_design design;

    (void)unused;
    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_FOUR_BAR;
    design.link[1].length = 0.080;
    set_link(&design.link[2], 0.020, 0.10, 0.008, 0.010, 0);
    set_link(&design.link[3], 0.066, 0.30, 0.025, 0.030, 10 * DEG);
    set_link(&design.link[4], 0.056, 0.25, 0.020, 0.028, -5 * DEG);
    design.gravity.y = -9.81;
    return fourlink_prepare(&design, &alvi);
}

static fourlink_state row(double degrees, fourlink_branch branch)
{
    const fourlink_crank crank = {degrees * DEG, 10.5, 0};
    fourlink_state state;

    assert_int_equal(fourlink_analyse(&alvi, branch, &crank, NULL, 0, &state, NULL), FOURLINK_OK);
    return state;
}

static void solve(const fourlink_state *state, fourlink_forces *forces)
{
    const fourlink_load Tl = {4, FOURLINK_FRAME_GROUND, {0, 0}, {0, 0}, 0.5};

    assert_int_equal(fourlink_solve(&alvi, state, &Tl, 1, forces), FOURLINK_OK);
}

/* The root of Freudenstein's equation for C, as printed for A, B, C: Alvi eq. 2. */
static double root(double A, double B, double C, int sign)
{
    return 2 * atan((-B + sign * sqrt(B * B - 4 * A * C)) / (2 * A)) / DEG;
}

static const double K = (20. * 20 - 66. * 66 + 56. * 56 + 80. * 80) / 2;

static void A1_twice_K(void **unused)
{
    (void)unused;
    assert_near(2 * K, 5580, 1e-9); /* printed 5588 */
    assert_near(K, 2790, 1e-9);
}

static void A2_output_angles(void **unused)
{
    double th = 40 * DEG, A = K - a * (d - c) * cos(th) - c * d, B = -2 * a * c * sin(th),
           C = K - a * (d + c) * cos(th) + c * d;

    (void)unused;
    assert_near(row(40, FOURLINK_CROSSED).link[4].theta / DEG, -126.30,
                0.005);                                                     /* printed -113.27 */
    assert_near(row(40, FOURLINK_OPEN).link[4].theta / DEG, 103.82, 0.005); /* printed 120 */
    assert_near(root(A, B, C, 1), -126.30, 0.005);
    assert_near(root(A, B, C, -1), 103.82, 0.005);
    /* -1439.84 put in for -B, 2A = -2057.76 for -4115.40, C = 5186.35 for 5186.36 */
    assert_near(-B, 1439.84, 0.005);
    assert_near(2 * A, -4115.40, 0.005);
    assert_near(C, 5186.36, 0.005);
}

static void A3_velocity_of_coupler(void **unused)
{
    fourlink_state s = row(40, FOURLINK_OPEN);
    double th = s.link[2].theta, be = s.link[3].theta, ph = s.link[4].theta;
    double printed = -a * omega * sin(ph - th) / (b * sin(th - be));
    double right = a * omega * sin(ph - th) / (b * sin(be - ph));
    double h = 1e-6, rate;

    (void)unused;
    rate = (row(40 + h / DEG, FOURLINK_OPEN).link[3].theta -
            row(40 - h / DEG, FOURLINK_OPEN).link[3].theta) /
           (2 * h) * omega;
    assert_near(right, rate, 1e-7);
    assert_near(right, -3.1549, 5e-5);
    assert_near(printed, -161.41, 0.005);
}

static void A4_label_of_alpha_c(void **unused)
{
    fourlink_state s = row(40, FOURLINK_OPEN);
    double th = s.link[2].theta, be = s.link[3].theta, ph = s.link[4].theta;
    double wb = s.link[3].omega, wc = s.link[4].omega;
    double second = (-a * omega * omega * cos(be - th) - b * wb * wb + c * wc * wc * cos(be - ph)) /
                    (c * sin(be - ph));
    double h = 1e-4, f[3];
    int i;

    (void)unused;
    for (i = -1; i <= 1; i++)
        f[i + 1] = row(40 + i * h / DEG, FOURLINK_OPEN).link[4].theta;
    assert_near((f[0] - 2 * f[1] + f[2]) / (h * h) * omega * omega, second, 1e-4);
    assert_near(second, 56.46, 0.005);               /* alpha_c */
    assert_true(fabs(second - s.link[3].alpha) > 1); /* not alpha_b, 20.96 */
}

static void A5_table_120(void **unused)
{
    (void)unused;
    assert_near(row(120, FOURLINK_CROSSED).link[3].omega, 3.1952, 5e-5); /* printed 3.26 */
}

static void A6_table_160_200(void **unused)
{
    (void)unused;
    assert_near(row(160, FOURLINK_OPEN).link[3].alpha, 23.9325, 5e-5); /* printed 23.99 */
    assert_near(row(200, FOURLINK_CROSSED).link[3].alpha, -23.9325, 5e-5);
}

static void A7_table_280(void **unused)
{
    (void)unused;
    assert_near(row(280, FOURLINK_CROSSED).link[3].alpha, -22.42, 0.005); /* printed +22.42 */
}

static void A8_parentheses(void **unused)
{
    double th = 40 * DEG, A = K - a * (d - c * cos(th)) - c * d, B = -2 * a * c * sin(th),
           C = K - a * d + c * cos(th) + c * d;

    (void)unused;
    assert_near(root(A, B, C, -1), 103.34, 0.005); /* right: 103.82 */
}

static void A9_sign_of_bb(void **unused)
{
    double th = 40 * DEG, A = K - a * (d - c) * cos(th) - c * d, B = 2 * a * c * sin(th),
           C = K - a * (d + c) * cos(th) + c * d;
    double ph = root(A, B, C, 1) * DEG;

    (void)unused;
    assert_near(ph / DEG, -103.82, 0.005); /* the mirrored rocker, with the crank where it was */
    assert_near((c * sin(ph) - a * sin(th)) / b, -1.0187, 5e-5); /* has no arcsine */
}

static void A10_interval_in_integers(void **unused)
{
    int theta = 50, iht = 360 / theta;

    (void)unused;
    assert_near(360.0 / iht, 51.43, 0.005); /* the rows are at 51.43 deg, labelled 50 */
}

/* What ME3491's program computes for one link's centre of mass, and where it goes wrong. */
static void M1_arms(void **unused)
{
    fourlink_state s = row(40, FOURLINK_OPEN);
    double th = 40 * DEG, r = 0.020, rg = 0.010, A[9][9], bb[9];

    (void)unused;
    assert_int_equal(fourlink_system(&alvi, &s, NULL, 0, A, bb), FOURLINK_OK);
    assert_near(r * sin(th) - rg * cos(th), 0.005195, 5e-7); /* eq. 12 as printed */
    assert_near(A[2][2], 0.006428, 5e-7);                    /* right: sin */
    assert_near(A[2][2], r * sin(th) - rg * sin(th), 1e-15);
}

static void M2_row_9_column_6(void **unused)
{
    fourlink_state s = row(40, FOURLINK_OPEN);
    double ph = s.link[4].theta, rg3 = 0.030, rg4 = 0.028, at = -5 * DEG, A[9][9], bb[9];

    (void)unused;
    assert_int_equal(fourlink_system(&alvi, &s, NULL, 0, A, bb), FOURLINK_OK);
    assert_near(0.056 * cos(ph) + rg3 * cos(ph + at), -0.01798, 5e-6); /* as printed */
    assert_near(A[8][5], -0.00908, 5e-6);
    assert_near(A[8][5], 0.056 * cos(ph) - rg4 * cos(ph + at), 1e-15);
}

static void M3_R_in_the_program(void **unused)
{
    double th = 40 * DEG, P = K - a * (d - c) * cos(th) - c * d, Q = -2 * a * c * sin(th);

    (void)unused;
    /* with - cd for + cd in R the program reports "wrong values of the link lengths" */
    assert_near(Q * Q - 4 * P * (K - a * (d + c) * cos(th) - c * d), -28986952, 1);
    assert_near(root(P, Q, K - a * (d + c) * cos(th) + c * d, -1), 103.82, 0.005);
}

/* Central difference of the coupler's centre of mass, from positions alone. */
static double a_G3(double degrees, int y)
{
    const double h = 1e-4;
    double f[3];
    int i;

    for (i = -1; i <= 1; i++) {
        fourlink_state s = row(degrees + i * h / DEG, FOURLINK_OPEN);
        double angle = s.link[3].theta + 10 * DEG, th = degrees * DEG + i * h;

        f[i + 1] = y ? 0.020 * sin(th) + 0.030 * sin(angle) : 0.020 * cos(th) + 0.030 * cos(angle);
    }
    return (f[0] - 2 * f[1] + f[2]) / (h * h) * omega * omega;
}

static void M4_acceleration_of_coupler(void **unused)
{
    fourlink_state s = row(40, FOURLINK_OPEN), wrong = s;
    double angle = s.link[3].theta + 10 * DEG, w = s.link[3].omega, al = s.link[3].alpha;
    double printed_x = 0.030 * (-al * sin(angle) - w * w * cos(angle));
    double printed_y = 0.030 * (al * cos(angle) - w * w * sin(angle));
    fourlink_forces f, g;

    (void)unused;
    assert_near(printed_x, -0.6703, 5e-5);
    assert_near(printed_y, 0.1873, 5e-5);
    assert_near(a_G3(40, 0), -2.3595, 5e-5);
    assert_near(a_G3(40, 1), -1.2301, 5e-5);
    wrong.link[3].acceleration.x = wrong.link[3].acceleration.y = 0;
    solve(&s, &f);
    solve(&wrong, &g);
    assert_near(f.Ts, 0.03138, 5e-6);
    assert_near(g.Ts, 0.03231, 5e-6); /* the torque without the acceleration of B */
}

static void M5_sign_of_b(void **unused)
{
    fourlink_state s = row(40, FOURLINK_OPEN);
    const fourlink_load Tl = {4, FOURLINK_FRAME_GROUND, {0, 0}, {0, 0}, 0.5};
    double A[9][9], bb[9], x[9], F_g[9];
    int i, sign;
    gsl_matrix_view Av = gsl_matrix_view_array(A[0], 9, 9);
    gsl_vector_view bv = gsl_vector_view_array(F_g, 9), xv = gsl_vector_view_array(x, 9);
    gsl_permutation *p = gsl_permutation_alloc(9);

    (void)unused;
    /* b = +F_g as printed is minus m a_G: the inertia and load enter with the wrong sign */
    assert_int_equal(fourlink_system(&alvi, &s, &Tl, 1, A, bb), FOURLINK_OK);
    for (i = 0; i < 9; i++)
        F_g[i] = -bb[i];
    gsl_linalg_LU_decomp(&Av.matrix, p, &sign);
    gsl_linalg_LU_solve(&Av.matrix, p, &bv.vector, &xv.vector);
    gsl_permutation_free(p);
    assert_near(x[8], -0.03138, 5e-6);
}

static void M6_angles_raised_by_pi(void **unused)
{
    double ph = row(40, FOURLINK_CROSSED).link[4].theta + 3.1415926;
    double be = asin((c * sin(ph) - a * sin(40 * DEG)) / b), gap;

    (void)unused;
    assert_near(ph / DEG, 53.70, 0.005); /* right: -126.30 */
    gap = a * cos(40 * DEG) + b * cos(be) - d - c * cos(ph);
    assert_near(gap, -40.26, 0.005); /* mm: the loop does not close */
}

/* The engines.  Exact values by the nine equations, the text's by its own formulas. */
typedef struct engine {
    double r, l, m, b, k2, m_p, gas, omega, theta;
    int vertical;
} engine;

static const engine ME3491_1 = {0.15, 0.45, 2, 0.3, 0.175 * 0.175, 2.5, 20773.8, 1000, 40, 0};
static const engine ME3491_2 = {0.4, 2, 300, 1.175, 0, 0, 0, 200, 45, 1};
static const engine DFA_1 = {0.15, 0.625, 0, 0, 0, 15, 26389.378, 250, 30, 0};
static const engine DFA_2 = {0.1, 0.4, 100, 0.24, 0.0144, 125, 0, 750, 30, 0};

static double rpm(double n)
{
    return n * 2 * 180 * DEG / 60;
}

/* The torque delivered, with the crank pin rising or sinking. */
static double exact_torque(const engine *e, double k2, int sense)
{
    fourlink_design design;
    fourlink_mechanism mechanism;
    fourlink_state state;
    fourlink_forces forces;
    fourlink_crank crank = {0, 0, 0};
    fourlink_load gas = {4, FOURLINK_FRAME_GROUND, {0, 0}, {0, 0}, 0};

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_SLIDER_CRANK;
    design.link[2].length = e->r;
    design.link[3].length = e->l;
    design.link[3].mass = e->m;
    design.link[3].inertia = e->m * k2;
    design.link[3].cg.x = e->l - e->b;
    design.link[4].mass = e->m_p;
    design.gravity.x = e->vertical ? -9.81 : 0;
    design.gravity.y = e->vertical ? 0 : -9.81 * sense;
    gas.force.x = -e->gas;
    crank.theta2 = e->theta * DEG;
    crank.omega2 = rpm(e->omega);
    assert_int_equal(fourlink_prepare(&design, &mechanism), FOURLINK_OK);
    assert_int_equal(fourlink_analyse(&mechanism, FOURLINK_OPEN, &crank, &gas, 1, &state, &forces),
                     FOURLINK_OK);
    return -forces.Ts;
}

/* F r [sin + sin 2theta / 2 sqrt(n^2 - sin^2)] */
static double arm(const engine *e)
{
    double th = e->theta * DEG, n = e->l / e->r;

    return e->r * (sin(th) + sin(2 * th) / (2 * sqrt(n * n - sin(th) * sin(th))));
}

/* r omega^2 (cos + cos 2theta / n) */
static double a_series(const engine *e)
{
    double th = e->theta * DEG, w = rpm(e->omega);

    return e->r * w * w * (cos(th) + cos(2 * th) * e->r / e->l);
}

/* -omega^2 sin (n^2 - 1) / (n^2 - sin^2)^(3/2) */
static double alpha_c(const engine *e)
{
    double s = sin(e->theta * DEG), n = e->l / e->r, w = rpm(e->omega);

    return -w * w * s * (n * n - 1) / pow(n * n - s * s, 1.5);
}

static void E1_brackets(void **unused)
{
    const engine *e = &ME3491_1;
    double th = e->theta * DEG, n = 3, w = rpm(1000), root = sqrt(n * n - sin(th) * sin(th));

    (void)unused;
    assert_near(e->r * w * sin(th) + sin(2 * th) / (2 * root) * w, 27.69, 0.005); /* as printed */
    assert_near(w * arm(e), 12.74, 0.005);
    assert_near(3.16667 * e->r * w * w * cos(th) + cos(2 * th) / n, 3990, 0.5); /* F_b as printed */
    assert_near(3.16667 * a_series(e), 4291.8, 0.05);
}

static void E2_outer_dead_centre(void **unused)
{
    engine e = ME3491_1;
    double rw2 = e.r * rpm(1000) * rpm(1000);

    (void)unused;
    e.theta = 180;
    assert_near(fabs(a_series(&e)) / rw2, 1 - 1. / 3, 1e-9); /* printed 1 + 1/n */
}

static void E3_second_term(void **unused)
{
    (void)unused;
    /* sin(2 theta)/2n beside sin(theta) at 40 deg: negligible for large n, not for small */
    assert_near(sin(80 * DEG) / (2 * 3) / sin(40 * DEG), 0.26, 0.005);
    assert_near(sin(80 * DEG) / (2 * 100) / sin(40 * DEG), 0.0077, 0.00005);
}

static void E4_example_1(void **unused)
{
    const engine *e = &ME3491_1;
    double m_b = 2. / 3, th = e->theta * DEG, root = sqrt(9 - sin(th) * sin(th));
    double T = (e->gas - (2.5 + m_b) * a_series(e)) * arm(e);
    double T_c = 2 * 0.3 * alpha_c(e) * (0.45 - (0.3 + e->k2 / 0.3)) * cos(th) / root;
    double T_a = 4. / 3 * 9.81 * 0.15 * cos(th);

    (void)unused;
    assert_near((2.5 + m_b) * a_series(e), 4291.8, 0.05); /* printed 4290.6 */
    assert_near(alpha_c(e), -2241.1, 0.05);               /* printed -2240.3 */
    assert_near(T, 2004.6, 0.05);                         /* printed 2004.7 */
    assert_near(T_c, -16.84, 0.005);
    assert_near(T_a, 1.503, 0.0005);
    assert_near(2004.7 + 16.84 + 1.503, 2023.0, 0.05); /* the printed sum: 2021.1 */
    assert_near(T + T_c - T_a, 1986.25, 0.005);
    assert_near(exact_torque(e, e->k2, 1), 1979.28, 0.005);
    assert_near(exact_torque(e, e->k2, -1), 1982.28, 0.005);
}

static void E5_example_2(void **unused)
{
    const engine *e = &ME3491_2;
    double L = 9.81 * pow(2.5 / (360 * DEG), 2), k2 = 1.175 * (L - 1.175), m_b = 123.75;
    double th = e->theta * DEG, T = m_b * a_series(e) * arm(e);
    double T_c = 300 * 1.175 * alpha_c(e) * (2 - L) * cos(th) / sqrt(25 - sin(th) * sin(th));
    double T_a = 176.25 * 9.81 * 0.4 * sin(th), T_b = m_b * 9.81 * arm(e);

    (void)unused;
    assert_near(300 * 1.175 / 2, 176.25, 1e-9); /* printed 176.35 */
    assert_near(sqrt(k2), 0.6665, 5e-5);
    assert_near(T, 4963.0, 0.05);                           /* printed 4967.6 */
    assert_near(4967.6 + 1381.2 - 489 - 392, 5467.8, 0.05); /* the printed sum: 5466.7 */
    assert_near(T - T_c - T_a - T_b, 5463.1, 0.05);         /* the text's approximations */
    assert_near(-exact_torque(e, k2, 1), 5477.58, 0.005);   /* exact */
    assert_near(13714 * 0.4, 5485.6, 0.05);                 /* graphical: printed 5487 */
    assert_near(13705 * 0.4, 5482.0, 0.05);
}

static void D1_example_1(void **unused)
{
    const engine *e = &DFA_1;
    double F = e->gas - 15 * a_series(e), th = 30 * DEG, ph = asin(sin(th) / (625. / 150));

    (void)unused;
    assert_near(rpm(250), 26.18, 0.005);
    assert_near(F, 24869, 0.5); /* printed 26870 */
    assert_near(F * arm(e), 2255.6, 0.05);
    assert_near(26870 * arm(e), 2437, 0.5); /* what the printed force would give */
    assert_near(F * cos(th + ph) / cos(ph), 20034, 0.5);
}

static void D2_example_2(void **unused)
{
    const engine *e = &DFA_2;
    double th = 30 * DEG, w = rpm(750), n = 4, F = 165 * a_series(e), T_1 = F * arm(e);
    double couple = 100 * (0.24 * 0.16 - 0.0144) * (-w * w * sin(th) / n);
    double T_2 = couple * cos(th) / sqrt(n * n - sin(th) * sin(th));
    double T_3 = 60 * 9.81 * 0.1 * cos(th);

    (void)unused;
    assert_near(F, 100867, 0.5);     /* printed 6144.8 N, which is the torque */
    assert_near(T_1, 6143.9, 0.05);  /* printed 6145 */
    assert_near(couple, -1851, 0.5); /* the couple on the rod, added as a torque on the crank */
    assert_near(T_2, -404, 0.5);
    assert_near(T_3, 51, 0.05);
    assert_near(6145 + 1851 + 51, 8047, 0.5);
    assert_near(T_1 - T_2 + T_3, 6598.7, 0.05);
    assert_near(-exact_torque(e, e->k2, 1), 6607.22, 0.005);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(A1_twice_K),
        cmocka_unit_test(A2_output_angles),
        cmocka_unit_test(A3_velocity_of_coupler),
        cmocka_unit_test(A4_label_of_alpha_c),
        cmocka_unit_test(A5_table_120),
        cmocka_unit_test(A6_table_160_200),
        cmocka_unit_test(A7_table_280),
        cmocka_unit_test(A8_parentheses),
        cmocka_unit_test(A9_sign_of_bb),
        cmocka_unit_test(A10_interval_in_integers),
        cmocka_unit_test(M1_arms),
        cmocka_unit_test(M2_row_9_column_6),
        cmocka_unit_test(M3_R_in_the_program),
        cmocka_unit_test(M4_acceleration_of_coupler),
        cmocka_unit_test(M5_sign_of_b),
        cmocka_unit_test(M6_angles_raised_by_pi),
        cmocka_unit_test(E1_brackets),
        cmocka_unit_test(E2_outer_dead_centre),
        cmocka_unit_test(E3_second_term),
        cmocka_unit_test(E4_example_1),
        cmocka_unit_test(E5_example_2),
        cmocka_unit_test(D1_example_1),
        cmocka_unit_test(D2_example_2),
    };

    return cmocka_run_group_tests(tests, prepare, NULL);
}
