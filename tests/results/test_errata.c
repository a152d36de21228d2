/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_errata.c - every number of data/ERRATA.md, computed: what the source's formula gives as it is
** printed, and what is right.  The tests bear the numbers of the page.  What goes in is the data of the
** source, or a number that it printed.
*/
#include <gsl/gsl_linalg.h>

#include "samples.h"

/* Alvi's example, sections 4.1 and 5.1: mm, rad/s. */
static const double a = 20, b = 66, c = 56, d = 80, omega = 10.5;

static fourlink_mechanism alvi;

/* Alvi's linkage with the masses of data/me3491-matrix.deck. */
static int prepare(void **unused)
{
    sample s = rocker(0);

    (void)unused;
    return fourlink_prepare(&s.design, &alvi);
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

TEST(A1_twice_K)
{
    assert_near(2 * K, 5580, 1e-9); /* printed 5588 */
    assert_near(K, 2790, 1e-9);
}

TEST(A2_output_angles)
{
    double th = 40 * DEG, A = K - a * (d - c) * cos(th) - c * d, B = -2 * a * c * sin(th),
           C = K - a * (d + c) * cos(th) + c * d, substituted;

    /* printed -113.27 and 120 */
    assert_near(row(40, FOURLINK_CROSSED).link[4].theta / DEG, -126.30, 0.005);
    assert_near(row(40, FOURLINK_OPEN).link[4].theta / DEG, 103.82, 0.005);
    assert_near(root(A, B, C, 1), -126.30, 0.005);
    assert_near(root(A, B, C, -1), 103.82, 0.005);
    assert_near(-B, 1439.84, 0.005); /* printed -1439.84 */
    assert_near(A, -2057.70, 0.005); /* so printed at first, then -2057.76 */
    assert_near(C, 5186.36, 0.005);  /* printed 5186.35 */
    /* the printed numbers give the mirror image, not the printed angles */
    substituted = sqrt(1439.84 * 1439.84 - 4 * -2057.70 * 5186.35);
    assert_near(2 * atan((-1439.84 + substituted) / (2 * -2057.76)) / DEG, -103.82, 0.005);
    assert_near(2 * atan((-1439.84 - substituted) / (2 * -2057.76)) / DEG, 126.30, 0.005);
    /* the table: 103.821 */
    assert_near(row(40, FOURLINK_OPEN).link[4].theta / DEG, 103.8208, 5e-5);
}

TEST(A3_velocity_of_coupler)
{
    fourlink_state s = row(40, FOURLINK_OPEN);
    double th = s.link[2].theta, be = s.link[3].theta, ph = s.link[4].theta;
    double printed = -a * omega * sin(ph - th) / (b * sin(th - be));
    double right = a * omega * sin(ph - th) / (b * sin(be - ph));
    double h = 1e-6, rate;

    rate = (row(40 + h / DEG, FOURLINK_OPEN).link[3].theta -
            row(40 - h / DEG, FOURLINK_OPEN).link[3].theta) /
           (2 * h) * omega;
    assert_near(right, rate, 1e-7);
    assert_near(right, -3.1549, 5e-5);
    assert_near(printed, -161.41, 0.005);
}

TEST(A4_label_of_alpha_c)
{
    fourlink_state s = row(40, FOURLINK_OPEN);
    double th = s.link[2].theta, be = s.link[3].theta, ph = s.link[4].theta;
    double wb = s.link[3].omega, wc = s.link[4].omega;
    double second = (-a * omega * omega * cos(be - th) - b * wb * wb + c * wc * wc * cos(be - ph)) /
                    (c * sin(be - ph));
    double h = 1e-4, f[3];
    int i;

    for (i = -1; i <= 1; i++)
        f[i + 1] = row(40 + i * h / DEG, FOURLINK_OPEN).link[4].theta;
    assert_near((f[0] - 2 * f[1] + f[2]) / (h * h) * omega * omega, second, 1e-4);
    assert_near(second, 56.46, 0.005); /* alpha_c */
    assert_near(s.link[3].alpha, 20.96, 0.005);
}

TEST(A5_table_120)
{
    assert_near(row(120, FOURLINK_CROSSED).link[3].omega, 3.1952, 5e-5); /* printed 3.26 */
}

TEST(A6_table_160_200)
{
    assert_near(row(160, FOURLINK_OPEN).link[3].alpha, 23.9325, 5e-5); /* printed 23.99 */
    assert_near(row(200, FOURLINK_CROSSED).link[3].alpha, -23.9325, 5e-5);
}

TEST(A7_table_280)
{
    assert_near(row(280, FOURLINK_CROSSED).link[3].alpha, -22.42, 0.005); /* printed +22.42 */
}

TEST(A8_parentheses)
{
    double th = 40 * DEG, A = K - a * (d - c * cos(th)) - c * d, B = -2 * a * c * sin(th),
           C = K - a * d + c * cos(th) + c * d;

    assert_near(root(A, B, C, -1), 103.34, 0.005); /* right: 103.82 */
}

TEST(A9_sign_of_bb)
{
    double th = 40 * DEG, A = K - a * (d - c) * cos(th) - c * d, B = 2 * a * c * sin(th),
           C = K - a * (d + c) * cos(th) + c * d;
    double ph = root(A, B, C, 1) * DEG;

    assert_near(ph / DEG, -103.82, 0.005); /* the mirrored rocker, with the crank where it was */
    assert_near((c * sin(ph) - a * sin(th)) / b, -1.0187, 5e-5); /* has no arcsine */
}

TEST(A10_interval_in_integers)
{
    int theta = 50, iht = 360 / theta;

    assert_near(360.0 / iht, 51.43, 0.005); /* the rows are at 51.43 deg, labelled 50 */
}

TEST(A11_arcsine)
{
    const double ground = 20, crank = 50, coupler = 45, rocker = 60, th = 60 * DEG;
    const fourlink_crank at = {60 * DEG, 1, 0};
    fourlink_design design;
    fourlink_mechanism linkage;
    fourlink_state s;
    double ph, be, wrong, rest;

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_FOUR_BAR;
    design.link[1].length = ground;
    design.link[2].length = crank;
    design.link[3].length = coupler;
    design.link[4].length = rocker;
    assert_int_equal(fourlink_prepare(&design, &linkage), FOURLINK_OK);
    assert_int_equal(fourlink_analyse(&linkage, FOURLINK_CROSSED, &at, NULL, 0, &s, NULL),
                     FOURLINK_OK);
    ph = s.link[4].theta;
    be = s.link[3].theta;
    wrong = asin((rocker * sin(ph) - crank * sin(th)) / coupler);
    assert_near(ph / DEG, 131.78, 0.005);
    assert_near(wrong / DEG, 1.835, 5e-4);
    assert_near(be / DEG, 178.165, 5e-4);
    /* both fulfil eq. 3, the loop's y; only one closes it along x */
    assert_near(crank * sin(th) + coupler * sin(wrong) - rocker * sin(ph), 0, 1e-12);
    rest = crank * cos(th) - ground - rocker * cos(ph);
    assert_near(rest + coupler * cos(be), 0, 1e-12);
    assert_near(rest + coupler * cos(wrong), 89.95, 0.005);
    /* the coupler turns the wrong way, the rocker too slowly */
    assert_near(crank * sin(ph - th) / (coupler * sin(wrong - ph)), -1.377, 5e-4);
    assert_near(crank * sin(ph - th) / (coupler * sin(be - ph)), 1.458, 5e-4);
    assert_near(s.link[3].omega, 1.458, 5e-4);
    assert_near(crank * sin(wrong - th) / (rocker * sin(wrong - ph)), 0.923, 5e-4);
    assert_near(crank * sin(be - th) / (rocker * sin(be - ph)), 1.015, 5e-4);
    assert_near(s.link[4].omega, 1.015, 5e-4);
}

TEST(A12_row_at_360)
{
    int iht = 360 / 40;

    /* the loop is for j < iht + 1 */
    assert_near(40 * iht, 360, 1e-9);
    assert_near(40 * (iht - 1), 320, 1e-9); /* where the table ends */
    assert_near(row(360, FOURLINK_CROSSED).link[4].theta / DEG, -110.74, 0.005);
    assert_near(row(360, FOURLINK_OPEN).link[4].theta / DEG, 110.74, 0.005);
}

/* What ME3491's program computes for one link's centre of mass, and where it goes wrong. */
TEST(M1_arms)
{
    fourlink_state s = row(40, FOURLINK_OPEN);
    double th = 40 * DEG, r = 0.020, rg = 0.010, A[9][9], bb[9];

    assert_int_equal(fourlink_system(&alvi, &s, NULL, 0, A, bb), FOURLINK_OK);
    assert_near(r * sin(th) - rg * cos(th), 0.005195, 5e-7); /* eq. 12 as printed */
    assert_near(A[2][2], 0.006428, 5e-7);                    /* right: sin */
    assert_near(A[2][2], r * sin(th) - rg * sin(th), 1e-15);
}

TEST(M2_row_9_column_6)
{
    fourlink_state s = row(40, FOURLINK_OPEN);
    double ph = s.link[4].theta, rg3 = 0.030, rg4 = 0.028, at = -5 * DEG, A[9][9], bb[9];

    assert_int_equal(fourlink_system(&alvi, &s, NULL, 0, A, bb), FOURLINK_OK);
    assert_near(0.056 * cos(ph) + rg3 * cos(ph + at), -0.01798, 5e-6); /* as printed */
    assert_near(A[8][5], -0.00908, 5e-6);
    assert_near(A[8][5], 0.056 * cos(ph) - rg4 * cos(ph + at), 1e-15);
}

TEST(M3_R_in_the_program)
{
    double th = 40 * DEG, P = K - a * (d - c) * cos(th) - c * d, Q = -2 * a * c * sin(th);

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

TEST(M4_acceleration_of_coupler)
{
    fourlink_state s = row(40, FOURLINK_OPEN), wrong = s;
    double angle = s.link[3].theta + 10 * DEG, w = s.link[3].omega, al = s.link[3].alpha;
    double printed_x = 0.030 * (-al * sin(angle) - w * w * cos(angle));
    double printed_y = 0.030 * (al * cos(angle) - w * w * sin(angle));
    fourlink_forces f, g;

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

TEST(M5_sign_of_b)
{
    fourlink_state s = row(40, FOURLINK_OPEN);
    const fourlink_load Tl = {4, FOURLINK_FRAME_GROUND, {0, 0}, {0, 0}, 0.5};
    double A[9][9], bb[9], x[9], F_g[9];
    int i, sign;
    gsl_matrix_view Av = gsl_matrix_view_array(A[0], 9, 9);
    gsl_vector_view bv = gsl_vector_view_array(F_g, 9), xv = gsl_vector_view_array(x, 9);
    gsl_permutation *p = gsl_permutation_alloc(9);

    /* b = +F_g as printed is minus m a_G: the inertia and load enter with the wrong sign */
    assert_int_equal(fourlink_system(&alvi, &s, &Tl, 1, A, bb), FOURLINK_OK);
    for (i = 0; i < 9; i++)
        F_g[i] = -bb[i];
    gsl_linalg_LU_decomp(&Av.matrix, p, &sign);
    gsl_linalg_LU_solve(&Av.matrix, p, &bv.vector, &xv.vector);
    gsl_permutation_free(p);
    assert_near(x[8], -0.03138, 5e-6);
}

TEST(M6_angles_raised_by_pi)
{
    double ph = row(40, FOURLINK_CROSSED).link[4].theta + 3.1415926;
    double be = asin((c * sin(ph) - a * sin(40 * DEG)) / b), gap;

    assert_near(ph / DEG, 53.70, 0.005); /* right: -126.30 */
    gap = a * cos(40 * DEG) + b * cos(be) - d - c * cos(ph);
    assert_near(gap, -40.26, 0.005); /* mm: the loop does not close */
}

/* The engines.  Exact values by the nine equations, the text's by its own formulas. */
typedef struct engine {
    double r, l, m, b, k2, m_p, gas, omega, theta;
    int vertical;
} engine;

/* A length of a pendulum from its period, over g: (T / 2 pi)^2. */
#define SWING(t) ((t) / (2 * PI) * (t) / (2 * PI))

static const engine ME3491_1 = {
    0.300 / 2, 0.450, 2, 0.300, 0.175 * 0.175, 2.5, 2e6 * PI / 4 * 0.115 * 0.115, 1000, 40, 0};
static const engine ME3491_2 = {
    0.400, 2, 300, 2 - 0.825, (2 - 0.825) * (9.81 * SWING(25. / 10) - (2 - 0.825)),
    0,     0, 200, 45,        1};
static const engine DFA_1 = {0.300 / 2, 0.625, 0, 0, 0, 15, 840e3 * PI / 4 * 0.200 * 0.200,
                             250,       30,    0};
static const engine DFA_2 = {0.200 / 2, 0.400, 100, 0.400 - 0.160, 0.120 * 0.120, 125, 0,
                             750,       30,    0};

static double rpm(double n)
{
    return n * 2 * PI / 60;
}

/* The exact motion, and the torque delivered, with the crank pin rising (sense 1) or sinking (-1). */
static double exact(const engine *e, int sense, fourlink_state *state)
{
    fourlink_design design;
    fourlink_mechanism mechanism;
    fourlink_forces forces;
    fourlink_crank crank = {0, 0, 0};
    fourlink_load gas = {4, FOURLINK_FRAME_GROUND, {0, 0}, {0, 0}, 0};

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_SLIDER_CRANK;
    design.link[2].length = e->r;
    design.link[3].length = e->l;
    design.link[3].mass = e->m;
    design.link[3].inertia = e->m * e->k2;
    design.link[3].cg.x = e->l - e->b;
    design.link[4].mass = e->m_p;
    design.gravity.x = e->vertical ? -9.81 : 0;
    design.gravity.y = e->vertical ? 0 : -9.81 * sense;
    gas.force.x = -e->gas;
    crank.theta2 = e->theta * DEG;
    crank.omega2 = rpm(e->omega);
    assert_int_equal(fourlink_prepare(&design, &mechanism), FOURLINK_OK);
    assert_int_equal(fourlink_analyse(&mechanism, FOURLINK_OPEN, &crank, &gas, 1, state, &forces),
                     FOURLINK_OK);
    return -forces.Ts;
}

static double exact_torque(const engine *e, int sense)
{
    fourlink_state state;

    return exact(e, sense, &state);
}

static double ratio(const engine *e)
{
    return e->l / e->r;
}

/* sqrt(n^2 - sin^2) */
static double root_n(const engine *e)
{
    double s = sin(e->theta * DEG);

    return sqrt(ratio(e) * ratio(e) - s * s);
}

/* The rod as two masses: m_a at the crank pin, m_b at the gudgeon pin. */
static double m_a(const engine *e)
{
    return e->m * e->b / e->l;
}

static double m_b(const engine *e)
{
    return e->m * (e->l - e->b) / e->l;
}

/* F r [sin + sin 2theta / 2 sqrt(n^2 - sin^2)] */
static double arm(const engine *e)
{
    double th = e->theta * DEG;

    return e->r * (sin(th) + sin(2 * th) / (2 * root_n(e)));
}

/* r omega^2 (cos + cos 2theta / n), for any omega */
static double a_at(const engine *e, double w)
{
    double th = e->theta * DEG;

    return e->r * w * w * (cos(th) + cos(2 * th) / ratio(e));
}

static double a_series(const engine *e)
{
    return a_at(e, rpm(e->omega));
}

/* -omega^2 sin (n^2 - 1) / (n^2 - sin^2)^(3/2), for any omega */
static double alpha_at(const engine *e, double w)
{
    return -w * w * sin(e->theta * DEG) * (ratio(e) * ratio(e) - 1) / pow(root_n(e), 3);
}

static double alpha_c(const engine *e)
{
    return alpha_at(e, rpm(e->omega));
}

/* m b alpha_c (l - L) */
static double couple(const engine *e, double alpha)
{
    return e->m * e->b * alpha * (e->l - (e->b + e->k2 / e->b));
}

/* and its torque at the crankshaft */
static double T_c(const engine *e)
{
    return couple(e, alpha_c(e)) * cos(e->theta * DEG) / root_n(e);
}

TEST(E1_brackets)
{
    const engine *e = &ME3491_1;
    double th = e->theta * DEG, n = ratio(e), w = rpm(e->omega), m = e->m_p + m_b(e);

    assert_near(e->r * w * sin(th) + sin(2 * th) / (2 * root_n(e)) * w, 27.69, 0.005);
    assert_near(w * arm(e), 12.74, 0.005);
    assert_near(e->r * w * w * cos(th) + cos(2 * th) / n * w * w, 1894.8, 0.05);
    assert_near(a_series(e), 1355.3, 0.05);
    assert_near(m * e->r * w * w * cos(th) + cos(2 * th) / n, 3990, 0.5);
    assert_near(m * e->r * w * w * (cos(th) + cos(2 * th)) / n, 1632, 0.5); /* in the examples */
    assert_near(m * a_series(e), 4291.8, 0.05);
}

TEST(E2_outer_dead_centre)
{
    engine e = ME3491_1;
    double rw2 = e.r * rpm(e.omega) * rpm(e.omega), n = ratio(&e);
    fourlink_state s;

    e.theta = 180;
    exact(&e, 1, &s);
    assert_near(rw2 * (1 + 1 / n), 2193.25, 0.005); /* printed first */
    assert_near(rw2 * (1 - 1 / n), 1096.62, 0.005); /* printed next: without its sign */
    /* x counts from the inner dead centre towards the crankshaft, so that a < 0 points away from it;
       +x of the program's frame does so, too */
    assert_near(a_series(&e), -1096.62, 0.005);
    assert_near(s.a, -1096.62, 0.005);
    assert_near(s.link[4].acceleration.x, 1096.62, 0.005);
    assert_true(s.link[4].origin.x > 0);
}

TEST(E3_second_term)
{
    /* sin(2 theta)/2n beside sin(theta) at 40 deg: negligible for large n, not for small */
    assert_near(sin(80 * DEG) / (2 * 3) / sin(40 * DEG), 0.26, 0.005);
    assert_near(sin(80 * DEG) / (2 * 100) / sin(40 * DEG), 0.0077, 0.00005);
}

TEST(E4_example_1)
{
    const engine *e = &ME3491_1;
    double th = e->theta * DEG, m = e->m_p + m_b(e), w = 104.7;
    double T = (e->gas - m * a_series(e)) * arm(e), T_a = m_a(e) * 9.81 * e->r * cos(th);

    assert_near(rpm(e->omega), 104.72, 0.005);
    assert_near(m * a_series(e), 4291.8, 0.05);
    assert_near(alpha_c(e), -2241.1, 0.05);
    /* with omega = 104.7, and 0.824 for cos + cos 2theta / n, as printed */
    assert_near(cos(th) + cos(2 * th) / ratio(e), 0.82393, 5e-6);
    assert_near(m * e->r * w * w * 0.824, 4290.6, 0.05);
    assert_near(alpha_at(e, w), -2240.3, 0.05);
    assert_near(T, 2004.6, 0.05); /* printed 2004.7 */
    assert_near(T_c(e), -16.84, 0.005);
    assert_near(T_a, 1.503, 0.0005);
    assert_near(2004.7 + 16.84 + 1.503, 2023.0, 0.05); /* the printed sum: 2021.1 */
    assert_near(T + T_c(e) - T_a, 1986.25, 0.005);
    assert_near(exact_torque(e, 1), 1979.28, 0.005);
    assert_near(exact_torque(e, -1), 1982.28, 0.005);
}

TEST(E5_example_2)
{
    const engine *e = &ME3491_2;
    double th = e->theta * DEG, n = ratio(e), T = m_b(e) * a_series(e) * arm(e);
    double T_a = m_a(e) * 9.81 * e->r * sin(th), T_b = m_b(e) * 9.81 * arm(e);
    double slip = sin(th) + sin(2 * th) / (2 * sqrt(n * n - sin(2 * th) * sin(2 * th)));

    assert_near(m_a(e), 176.25, 1e-9);          /* printed 176.35 */
    assert_near(e->m * e->b * e->l, 705, 1e-9); /* kg m2, by the printed formula */
    assert_near(sqrt(e->k2), 0.6665, 5e-5);
    assert_near(T, 4963.0, 0.05);
    assert_near(m_b(e) * a_at(e, 20.94) * e->r * slip, 4967.6, 0.05); /* as printed */
    assert_near(4967.6 + 1381.2 - 489 - 392, 5467.8, 0.05);           /* the printed sum: 5466.7 */
    assert_near(T - T_c(e) - T_a - T_b, 5463.1, 0.05);
    assert_near(-exact_torque(e, 1), 5477.58, 0.005);
}

TEST(E6_torque)
{
    const engine *e = &ME3491_1;
    double th = e->theta * DEG, be = asin(sin(th) / ratio(e));

    assert_near((sin(th) + cos(th) * sin(be)) / cos(be), 0.826, 5e-4);
    assert_near((sin(th) * cos(be) + cos(th) * sin(be)) / cos(be), 0.811, 5e-4);
    assert_near(arm(e) / e->r, 0.811, 5e-4);
}

TEST(E7_graphical_torque)
{
    const engine *e = &ME3491_2;
    double F_C = 300 * 20.94 * 20.94 * 0.3282; /* the lengths of the text's figure, in m */
    double F_T = (F_C * 1.0318 - 300 * 9.81 * 2.0952) / 2.7977;
    double th = e->theta * DEG, w = rpm(e->omega), OP, IC, IX, IY, moment;
    fourlink_vector I, C, G, a_G, at = {0, 0};
    fourlink_state s;

    assert_near(F_C, 43173.1, 0.05);
    assert_near(F_T, 13718, 0.5); /* printed 13714, and 13705 in the next line */
    assert_near(F_T * e->r, 5487, 0.5);
    assert_near(13714 * e->r, 5485.6, 0.05);
    assert_near(13705 * e->r, 5482.0, 0.05);

    /* the figure computed: I is where the crank's line meets the normal to the stroke in P */
    exact(e, 1, &s);
    OP = s.link[4].origin.x;
    IC = OP / cos(th) - e->r;
    assert_near(IC, 2.8, 0.0005); /* m; printed in mm */
    at.x = e->l - e->b;
    assert_int_equal(fourlink_point(&s, 3, &at, &G, NULL, &a_G), FOURLINK_OK);
    I.x = OP;
    I.y = OP * tan(th);
    C.x = e->r * cos(th);
    C.y = e->r * sin(th);
    assert_near(hypot(I.x - C.x, I.y - C.y), IC, 1e-12);
    IX = I.y - G.y;
    moment = -e->m * ((G.x - I.x) * a_G.y - (G.y - I.y) * a_G.x) - e->m * e->k2 * s.link[3].alpha;
    IY = fabs(moment) / (e->m * hypot(a_G.x, a_G.y));
    assert_near(hypot(a_G.x, a_G.y) / (w * w), 0.3283, 5e-5); /* gO */
    assert_near(IX, 2.0966, 5e-5);
    assert_near(IY, 1.0302, 5e-5); /* printed 1.0318 */
    F_T = (fabs(moment) - e->m * 9.81 * IX) / IC;
    assert_near(F_T, 13694, 0.5);
    assert_near(F_T * e->r, 5477.58, 0.005);
}

TEST(E8_speed_rounded)
{
    const engine *e = &ME3491_2;
    double w = rpm(e->omega), L = 1.553;

    assert_near(w, 20.944, 5e-4);
    assert_near(m_b(e) * a_at(e, 20.94), 15348, 0.5);
    assert_near(m_b(e) * a_series(e), 15353.5, 0.05);
    assert_near(alpha_at(e, 20.94), -61.36, 0.005);
    assert_near(alpha_c(e), -61.39, 0.005);
    /* with L = 1.553 m, as printed */
    assert_near(e->m * e->b * alpha_at(e, 20.94) * (e->l - L) * cos(e->theta * DEG) / root_n(e),
                -1381.2, 0.05);
    assert_near(T_c(e), -1381.6, 0.05);
    assert_near(300 * 20.94 * 20.94 * 0.3282, 43173.1, 0.05);
    assert_near(300 * w * w * 0.3282, 43189.4, 0.05);
}

TEST(E9_parts_not_equivalent)
{
    const engine *one = &ME3491_1, *two = &ME3491_2;

    /* the two parts about the centre of mass, and the rod */
    assert_near(m_a(one) * pow(one->l - one->b, 2) + m_b(one) * one->b * one->b, 0.09, 1e-9);
    assert_near(one->m * one->k2, 0.06125, 1e-9);
    assert_near(m_a(two) * pow(two->l - two->b, 2) + m_b(two) * two->b * two->b, 290.8, 0.05);
    assert_near(two->m * two->k2, 133.3, 0.05);
}

TEST(E10_chain_of_T_c)
{
    const engine *e = &ME3491_1;
    double th = e->theta * DEG, be = asin(sin(th) / ratio(e)), c1 = couple(e, alpha_c(e));

    assert_near(c1 / cos(be) * e->r * cos(th), -7.58, 0.005);              /* N m2, l is lost */
    assert_near(c1 * cos(th) / (ratio(e) * 1 / root_n(e)), -48.21, 0.005); /* n 1/sqrt */
    assert_near(c1 * cos(th) / (ratio(e) * cos(be)), -16.84, 0.005);
    assert_near(T_c(e), -16.84, 0.005);
}

TEST(D1_example_1)
{
    const engine *e = &DFA_1;
    double F = e->gas - e->m_p * a_series(e), th = e->theta * DEG, ph = asin(sin(th) / ratio(e));

    assert_near(rpm(250), 26.18, 0.005);
    assert_near(F, 24869, 0.5); /* printed 26870 */
    assert_near(F * arm(e), 2255.6, 0.05);
    assert_near(26870 * arm(e), 2437, 0.5); /* what the printed force would give */
    assert_near(F * cos(th + ph) / cos(ph), 20034, 0.5);
}

TEST(D2_example_2)
{
    const engine *e = &DFA_2;
    double th = e->theta * DEG, w = rpm(e->omega), n = ratio(e);
    double F = (e->m_p + m_b(e)) * a_series(e), T_1 = F * arm(e);
    double couple_1 = couple(e, -w * w * sin(th) / n), T_2 = couple_1 * cos(th) / root_n(e);
    double T_3 = m_a(e) * 9.81 * e->r * cos(th);

    assert_near(F, 100867, 0.5);       /* printed 6144.8 N, which is the torque */
    assert_near(T_1, 6143.9, 0.05);    /* printed 6145 */
    assert_near(couple_1, -1851, 0.5); /* the couple on the rod, added as a torque on the crank */
    assert_near(T_2, -403.8, 0.05);
    assert_near(T_3, 51.0, 0.05);
    assert_near(6145 + 1851 + 51, 8047, 0.5);
    assert_near(T_1 - T_2 + T_3, 6598.7, 0.05);
    assert_near(-exact_torque(e, 1), 6607.22, 0.005);
}

TEST(D3_torque_of_the_couple)
{
    const engine *e = &DFA_2;
    double th = e->theta * DEG, ph = asin(sin(th) / ratio(e)), w = rpm(e->omega);
    double couple_1 = couple(e, -w * w * sin(th) / ratio(e));

    assert_near(couple_1 * cos(ph) * e->r * cos(th), -159.0, 0.05); /* N m2, l is lost */
    assert_near(couple_1 / (e->l * cos(ph)) * e->r * cos(th), -403.8, 0.05);
    /* -1851 x 0.1 x cos 30 / 0.4 x cos 7.18, read as it is written and as it is meant */
    assert_near(-1851 * 0.1 * cos(30 * DEG) / 0.4 * cos(7.18 * DEG), -397.6, 0.05);
    assert_near(-1851 * 0.1 * cos(30 * DEG) / (0.4 * cos(7.18 * DEG)), -404, 0.5);
}

int main(void)
{
    return run_all_tests(prepare);
}
