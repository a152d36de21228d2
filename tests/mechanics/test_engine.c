/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_engine.c - what textbooks compute for a slider-crank: the series against the expansion of
** the exact formulas, the two masses of the rod against the conditions they are to meet, the engine
** method against the nine equations, Klein's construction against circles.
*/
#include "samples.h"

static int solve(sample *s)
{
    assert_int_equal(fourlink_prepare(&s->design, &s->mechanism), FOURLINK_OK);
    return fourlink_analyse(&s->mechanism, s->branch, &s->crank, NULL, 0, &s->state, NULL);
}

static void slider_crank(double r, double l, double theta2, double omega2, double alpha2, sample *s)
{
    memset(s, 0, sizeof *s);
    s->design.kind = FOURLINK_SLIDER_CRANK;
    s->design.link[2].length = r;
    s->design.link[3].length = l;
    s->branch = FOURLINK_OPEN;
    s->crank.theta2 = theta2;
    s->crank.omega2 = omega2;
    s->crank.alpha2 = alpha2;
}

static void four_bar(sample *s)
{
    slider_crank(1, 2, 1, 3, 0, s);
    s->design.kind = FOURLINK_FOUR_BAR;
    s->design.link[1].length = s->design.link[4].length = 2;
    assert_int_equal(solve(s), FOURLINK_OK);
}

/* A slider-crank with or without offset, turning either way, and a position of it not nearer to a
** dead one than `smallest_sine`. */
static void draw(uint64_t *seed, int n, int offset, double smallest_sine, sample *s)
{
    do {
        slider_crank(uniform(seed, 0.05, 1), uniform(seed, 0.05, 3), uniform(seed, -10, 10),
                     uniform(seed, -50, 50), uniform(seed, -2000, 2000), s);
        s->design.offset = offset ? uniform(seed, -1, 1) : 0;
        s->branch = n % 2 ? FOURLINK_CROSSED : FOURLINK_OPEN;
    } while (solve(s) != FOURLINK_OK || fabs(s->state.sine) < smallest_sine);
}

/* ---------------------------------------------------------------------------------------------
** The series
** ------------------------------------------------------------------------------------------- */

static fourlink_series series_of(sample *s)
{
    fourlink_series series;

    assert_int_equal(solve(s), FOURLINK_OK);
    assert_int_equal(fourlink_textbook_series(&s->mechanism, &s->state, &series), FOURLINK_OK);
    return series;
}

/* Exact less series, each divided by what makes it a number near 1. */
enum { OF_X, OF_V, OF_A, OF_OMEGA3, OF_ALPHA3, N_ERRORS };

static void series_errors(double r, double n, double theta2, double w, double al,
                          fourlink_branch branch, double error[N_ERRORS])
{
    double rate = w * w + fabs(al);
    fourlink_series series;
    sample s;

    slider_crank(r, n * r, theta2, w, al, &s);
    s.branch = branch;
    series = series_of(&s);
    error[OF_X] = (s.state.x - series.x) / r;
    error[OF_V] = (s.state.v - series.v) / (r * w);
    error[OF_A] = (s.state.a - series.a) / (r * rate);
    error[OF_OMEGA3] = (s.state.link[3].omega - series.omega3) / w;
    error[OF_ALPHA3] = (s.state.link[3].alpha - series.alpha3) / rate;
}

/* Expanded in 1/n, with s and c of the crank angle from the inner dead centre,
**
**    x/r = 1 - c + n - sqrt(n^2 - s^2) = 1 - c + s^2/2n + s^4/8n^3 + O(1/n^5)
**    phi = asin(s/n) = s/n + s^3/6n^3 + O(1/n^5)
**
** and the first terms left out, differentiated, are the errors: of order 3, falling by 8 as n is
** doubled.  The next terms are below 3/n^5 for x and v, 10/n^5 for the rest. */
TEST(test_series_expansion)
{
    uint64_t seed = 1;
    int i, k;

    for (i = 0; i < 2000; i++) {
        double r = uniform(&seed, 0.01, 2), theta2 = uniform(&seed, -10, 10);
        double w = uniform(&seed, 1, 50) * (i % 4 < 2 ? 1 : -1);
        double al = i % 3 ? uniform(&seed, -2000, 2000) : 0, rate = w * w + fabs(al);
        double side = i % 2 ? -1 : 1, s = side * sin(theta2), c = side * cos(theta2);
        fourlink_branch branch = i % 2 ? FOURLINK_CROSSED : FOURLINK_OPEN;
        double n = uniform(&seed, 20, 60), e1[N_ERRORS], e2[N_ERRORS], term[N_ERRORS];

        term[OF_X] = s * s * s * s / 8;
        term[OF_V] = s * s * s * c / 2;
        term[OF_A] =
            (w * w * (3 * s * s * c * c - s * s * s * s) / 2 + al * s * s * s * c / 2) / rate;
        /* the series of the sources keep cos(theta)/n of dphi/dt and its derivative */
        term[OF_OMEGA3] = -s * s * c / 2;
        term[OF_ALPHA3] = -(w * w * (2 * s * c * c - s * s * s) / 2 + al * s * s * c / 2) / rate;
        series_errors(r, n, theta2, w, al, branch, e1);
        series_errors(r, 2 * n, theta2, w, al, branch, e2);
        for (k = 0; k < N_ERRORS; k++) {
            double next = (k <= OF_V ? 3 : 10) / pow(n, 5);

            /* n - sqrt(n^2 - s^2) is found to n times the rounding error */
            assert_near(e1[k], term[k] / (n * n * n), next + 1e-15 * n);
            assert_near(8 * e2[k], e1[k], next + 2e-14 * n);
        }
    }
}

/* Central differences of order h^6, from f(-3h) ... f(3h). */
static double slope(const double f[7], double h)
{
    return (45 * (f[4] - f[2]) - 9 * (f[5] - f[1]) + (f[6] - f[0])) / (60 * h);
}

/* The v and a of the series are the derivatives of its x, with one term as with two, the crank
** speeding up or slowing down; so is the rod's alpha that of its omega. */
TEST(test_series_derivatives)
{
    uint64_t seed = 2;
    int i, k;

    for (i = 0; i < 2000; i++) {
        double x[7], v[7], x1[7], v1[7], rod[7], h, scale, r, n;
        fourlink_series middle;
        sample s;

        r = uniform(&seed, 0.05, 1);
        n = uniform(&seed, 1.2, 10);
        slider_crank(r, n * r, uniform(&seed, -10, 10), uniform(&seed, -50, 50),
                     uniform(&seed, -2000, 2000), &s);
        s.branch = i % 2 ? FOURLINK_CROSSED : FOURLINK_OPEN;
        middle = series_of(&s);
        scale = fabs(s.crank.omega2) + sqrt(fabs(s.crank.alpha2));
        h = 0.01 / scale;
        for (k = 0; k < 7; k++) {
            double t = (k - 3) * h;
            fourlink_series near;
            sample moved = s;

            moved.crank.theta2 += (s.crank.omega2 + s.crank.alpha2 * t / 2) * t;
            moved.crank.omega2 += s.crank.alpha2 * t;
            near = series_of(&moved);
            x[k] = near.x;
            v[k] = near.v;
            x1[k] = near.x_harmonic;
            v1[k] = near.v_harmonic;
            rod[k] = near.omega3;
        }
        /* trigonometric functions of at most 2 theta: the error is 2^7 step^6/140, the rounding
        ** 3e-15/step, with that of the angle itself */
        assert_near(middle.v, slope(x, h), 1e-11 * r * scale);
        assert_near(middle.a, slope(v, h), 1e-11 * r * scale * scale);
        assert_near(middle.v_harmonic, slope(x1, h), 1e-11 * r * scale);
        assert_near(middle.a_harmonic, slope(v1, h), 1e-11 * r * scale * scale);
        assert_near(middle.alpha3, slope(rod, h), 1e-11 * scale * scale);
    }
}

/* An endless rod: simple harmonic motion about the middle of the stroke. */
TEST(test_series_harmonic)
{
    uint64_t seed = 3;
    int i;

    for (i = 0; i < 1000; i++) {
        double r = uniform(&seed, 0.01, 2), w = uniform(&seed, -50, 50), n = 1e10, v2;
        fourlink_series endless, ordinary;
        sample s;

        slider_crank(r, n * r, uniform(&seed, -10, 10), w, 0, &s);
        s.branch = i % 2 ? FOURLINK_CROSSED : FOURLINK_OPEN;
        endless = series_of(&s);
        assert_near(endless.x, endless.x_harmonic, r / n);
        assert_near(endless.v, endless.v_harmonic, r * fabs(w) / n);
        assert_near(endless.a, endless.a_harmonic, 2 * r * w * w / n);
        assert_near(endless.omega3, 0, 2 * fabs(w) / n);
        assert_near(endless.alpha3, 0, 2 * w * w / n);
        assert_near(endless.a_harmonic, w * w * (r - endless.x_harmonic), 1e-14 * r * w * w);
        v2 = w * w * (2 * r - endless.x_harmonic) * endless.x_harmonic;
        assert_near(endless.v_harmonic * endless.v_harmonic, v2, 1e-14 * r * r * w * w);
        s.design.link[3].length = uniform(&seed, 1.5, 10) * r;
        ordinary = series_of(&s);
        assert_true(ordinary.x_harmonic == endless.x_harmonic);
        assert_true(ordinary.v_harmonic == endless.v_harmonic);
        assert_true(ordinary.a_harmonic == endless.a_harmonic);
    }
}

/* n = 3, 4, 5, as engines have: the gap of a is largest with the crank upright, where the exact
** value is -1/sqrt(n^2 - 1) and the series' -1/n; 2.0 %, 0.8 % and 0.4 % of r omega^2. */
TEST(test_series_gap)
{
    static const double percent[] = {2.0, 0.8, 0.4};
    int n, degree;

    for (n = 3; n <= 5; n++) {
        double largest[N_ERRORS] = {0}, upright[N_ERRORS];
        int k;

        for (degree = 0; degree < 360; degree++) {
            double error[N_ERRORS];

            series_errors(0.1, n, degree * DEG, 10, 0, FOURLINK_OPEN, error);
            for (k = 0; k < N_ERRORS; k++)
                largest[k] = fmax(largest[k], fabs(error[k]));
        }
        series_errors(0.1, n, 90 * DEG, 10, 0, FOURLINK_OPEN, upright);
        assert_near(upright[OF_A], 1.0 / n - 1 / sqrt(n * n - 1), 1e-14);
        assert_near(largest[OF_A], fabs(upright[OF_A]), 1e-14);
        assert_near(100 * largest[OF_A], percent[n - 3], 0.05);
        assert_near(largest[OF_X], n - sqrt(n * n - 1) - 0.5 / n, 1e-14);
        assert_true(largest[OF_X] > 5e-4 && largest[OF_X] < 0.005);
        assert_true(largest[OF_V] > 5e-4 && largest[OF_V] < 0.008);
    }
}

TEST(test_series_statuses)
{
    fourlink_series series, before;
    sample s;

    memset(&before, 0x5A, sizeof before);
    series = before;
    slider_crank(1, 3, 1, 2, 3, &s);
    s.design.offset = 1e-9;
    assert_int_equal(solve(&s), FOURLINK_OK);
    assert_int_equal(fourlink_textbook_series(&s.mechanism, &s.state, &series), FOURLINK_NO_SERIES);
    assert_int_equal(fourlink_textbook_series(NULL, &s.state, &series), FOURLINK_NULL);
    assert_int_equal(fourlink_textbook_series(&s.mechanism, NULL, &series), FOURLINK_NULL);
    assert_int_equal(fourlink_textbook_series(&s.mechanism, &s.state, NULL), FOURLINK_NULL);
    four_bar(&s);
    assert_int_equal(fourlink_textbook_series(&s.mechanism, &s.state, &series),
                     FOURLINK_NOT_AN_ENGINE);
    assert_memory_equal(&series, &before, sizeof series);
}

/* ---------------------------------------------------------------------------------------------
** The rod as two masses
** ------------------------------------------------------------------------------------------- */

static fourlink_rod masses_of(double l, double mass, double inertia, double crank_pin_to_cg)
{
    fourlink_rod rod;
    sample s;

    slider_crank(0.25, l, 0, 0, 0, &s);
    s.design.link[3].mass = mass;
    s.design.link[3].inertia = inertia;
    s.design.link[3].cg.x = crank_pin_to_cg;
    assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
    assert_int_equal(fourlink_rod_masses(&s.mechanism, &rod), FOURLINK_OK);
    return rod;
}

/* DFA's three conditions: the same mass, the same centre of mass, the same moment of inertia.  The
** pair at the pins meets two, and has m b (l - L) too much of the third; the pair of ME3491 meets
** all, and L is the length of the simple pendulum that swings with the rod about its gudgeon
** pin. */
TEST(test_rod_masses)
{
    uint64_t seed = 4;
    int i;

    for (i = 0; i < 5000; i++) {
        double l = uniform(&seed, 0.3, 3), m = uniform(&seed, 0.1, 300);
        double I = i % 10 ? m * l * l * uniform(&seed, 0, 0.3) : 0;
        /* also beyond the pins */
        double g = l * uniform(&seed, -0.2, 1.2), b = l - g, tolerance = 1e-14 * m;
        fourlink_rod rod = masses_of(l, m, I, g);

        assert_close(rod.n, l / 0.25, 1e-15);
        assert_near(rod.b, b, 1e-15 * l);
        assert_near(rod.k * rod.k * m, I, 1e-15 * I);

        assert_near(rod.m_a + rod.m_b, m, tolerance);
        assert_near(rod.m_b * b, rod.m_a * (l - b), tolerance * l);
        if (rod.k1 > 0)
            assert_near(rod.m_a * (l - b) * (l - b) + rod.m_b * b * b, m * rod.k1 * rod.k1,
                        2 * tolerance * l * l);
        else
            assert_true(b * (l - b) <= 0);
        assert_near(rod.m_a * (l - b) * (l - b) + rod.m_b * b * b, I + m * b * (l - rod.L),
                    4 * tolerance * l * l + 1e-15 * I);

        if (fabs(b) < 0.01 * l)
            continue; /* d is beyond 100 k there */
        assert_near(rod.L, rod.b + rod.d, 0);
        assert_near(rod.m_g + rod.m_d, m, tolerance);
        assert_near(rod.m_g * b, rod.m_d * rod.d, tolerance * (fabs(b) + fabs(rod.d)));
        assert_near(rod.m_g * b * b + rod.m_d * rod.d * rod.d, I,
                    1e-14 * (I + m * b * b + fabs(rod.m_d) * rod.d * rod.d));
        assert_near(m * fabs(b) * fabs(rod.L), I + m * b * b, 1e-14 * (I + m * b * b));
    }
}

TEST(test_rod_masses_limits)
{
    fourlink_rod rod, before;
    sample s;

    /* the centre of mass at the gudgeon pin: all of the rod is there */
    rod = masses_of(0.7, 3, 0.12, 0.7);
    assert_true(rod.b == 0 && rod.d == 0 && rod.L == 0 && rod.m_d == 0 && rod.m_g == 0);
    assert_true(rod.m_a == 0 && rod.m_b == 3);
    assert_close(rod.k, 0.2, 1e-15);
    /* at the crank pin */
    rod = masses_of(0.7, 3, 0.12, 0);
    assert_close(rod.m_a, 3.0, 1e-15);
    assert_near(rod.m_b, 0, 1e-15);
    /* a point mass: the true pair is that point alone */
    rod = masses_of(0.7, 3, 0, 0.2);
    assert_true(rod.d == 0 && rod.m_g == 0);
    assert_close(rod.m_d, 3.0, 1e-15);
    /* all at the gudgeon pin, but for the rounding error of its place */
    rod = masses_of(0.7, 2, 0, 0.7 * (1 - 1e-15));
    assert_true(rod.b == 0 && rod.d == 0 && rod.L == 0 && rod.m_d == 0 && rod.m_g == 0);
    /* no mass */
    rod = masses_of(0.7, 0, 0, 0.2);
    assert_true(rod.m_a == 0 && rod.m_b == 0 && rod.m_d == 0 && rod.m_g == 0 && rod.k == 0);

    memset(&before, 0x5A, sizeof before);
    rod = before;
    slider_crank(0.25, 0.7, 0, 0, 0, &s);
    s.design.link[3].cg.x = 0.3;
    /* nearly no mass, but an inertia: the radius of gyration is out of range */
    s.design.link[3].mass = 1e-300;
    s.design.link[3].inertia = 1e10;
    assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
    assert_int_equal(fourlink_rod_masses(&s.mechanism, &rod), FOURLINK_BAD_NUMBER);
    assert_memory_equal(&rod, &before, sizeof rod);
    s.design.link[3].inertia = 1e-300;
    assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
    assert_int_equal(fourlink_rod_masses(&s.mechanism, &rod), FOURLINK_OK);
    assert_close(rod.k, 1.0, 1e-15);
    rod = before;
    s.design.link[3].mass = s.design.link[3].inertia = 0;
    s.design.link[3].cg.y = 1e-7;
    assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
    assert_int_equal(fourlink_rod_masses(&s.mechanism, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_rod_masses(NULL, &rod), FOURLINK_NULL);
    s.design.link[3].mass = 1;
    assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
    assert_int_equal(fourlink_rod_masses(&s.mechanism, &rod), FOURLINK_ROD_OFF_LINE);
    s.design.link[3].cg.y = -1e-7;
    assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
    assert_int_equal(fourlink_rod_masses(&s.mechanism, &rod), FOURLINK_ROD_OFF_LINE);
    four_bar(&s);
    assert_int_equal(fourlink_rod_masses(&s.mechanism, &rod), FOURLINK_NOT_AN_ENGINE);
    assert_memory_equal(&rod, &before, sizeof rod);
    /* without mass it has no centre of mass to be off the line */
    s.design.kind = FOURLINK_SLIDER_CRANK;
    s.design.link[3].mass = 0;
    s.design.link[3].cg.y = 1;
    assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
    assert_int_equal(fourlink_rod_masses(&s.mechanism, &rod), FOURLINK_OK);
}

/* ---------------------------------------------------------------------------------------------
** The engine method: against the nine equations
** ------------------------------------------------------------------------------------------- */

static void set_rod(sample *s, double mass, double k, double crank_pin_to_cg)
{
    s->design.link[3].mass = mass;
    s->design.link[3].inertia = mass * k * k;
    s->design.link[3].cg.x = crank_pin_to_cg;
}

static fourlink_engine engine_of(sample *s, double gas, fourlink_approximation approximation)
{
    fourlink_engine engine;

    assert_int_equal(solve(s), FOURLINK_OK);
    assert_int_equal(
        fourlink_engine_method(&s->mechanism, &s->state, gas, NULL, 0, approximation, &engine),
        FOURLINK_OK);
    return engine;
}

static fourlink_klein klein_of(const sample *s)
{
    fourlink_klein klein;

    assert_int_equal(fourlink_klein_construction(&s->mechanism, &s->state, &klein), FOURLINK_OK);
    return klein;
}

typedef struct engine_sample {
    sample s;
    double gas;
    fourlink_load load[MOST_LOADS + 1]; /* the last is the gas */
    unsigned long n_loads;              /* without it */
    fourlink_forces forces;
    fourlink_engine engine;
} engine_sample;

/* An engine with a massless crank, gravity in any direction, loads on the piston alone. */
static void draw_engine(uint64_t *seed, int n, int massless_rod, double smallest_sine,
                        engine_sample *e)
{
    fourlink_load *gas = NULL;
    double gravity, direction;
    unsigned long i;
    sample *s = &e->s;

    memset(e, 0, sizeof *e);
    draw(seed, n, n % 3, smallest_sine, s);
    if (!massless_rod)
        set_rod(s, uniform(seed, 0, 10), uniform(seed, 0, 1),
                s->design.link[3].length * uniform(seed, -0.2, 1.2));
    s->design.link[4].mass = n % 7 ? uniform(seed, 0, 10) : 0;
    s->design.link[4].inertia = uniform(seed, 0, 1);
    s->design.link[4].cg.x = uniform(seed, -1, 1);
    s->design.link[4].cg.y = uniform(seed, -1, 1);
    gravity = n % 5 ? uniform(seed, 0, 30) : 0;
    direction = uniform(seed, -PI, PI);
    s->design.gravity.x = gravity * cos(direction);
    s->design.gravity.y = gravity * sin(direction);
    e->gas = n % 4 ? uniform(seed, -1e4, 1e4) : 0;
    e->n_loads = (unsigned long)uniform(seed, 0, MOST_LOADS + 1);
    for (i = 0; i < e->n_loads; i++) {
        fourlink_load *load = &e->load[i];

        load->link = FOURLINK_FOLLOWER;
        load->frame = i % 2 ? FOURLINK_FRAME_GROUND : FOURLINK_FRAME_LINK;
        load->force.x = uniform(seed, -5e3, 5e3);
        load->force.y = uniform(seed, -5e3, 5e3);
        load->at.x = uniform(seed, -1, 1);
        load->at.y = uniform(seed, -1, 1);
        load->torque = uniform(seed, -1e3, 1e3);
    }
    gas = &e->load[e->n_loads];
    gas->link = FOURLINK_FOLLOWER;
    gas->force.x = s->branch == FOURLINK_OPEN ? -e->gas : e->gas;
    assert_int_equal(solve(s), FOURLINK_OK);
    assert_int_equal(fourlink_solve(&s->mechanism, &s->state, e->load, e->n_loads + 1, &e->forces),
                     FOURLINK_OK);
    assert_int_equal(fourlink_engine_method(&s->mechanism, &s->state, e->gas, e->load, e->n_loads,
                                            FOURLINK_EXACT, &e->engine),
                     FOURLINK_OK);
}

/* The largest force on the piston or on the rod, inertia included, as it bears on the crank. */
static double largest_force(const engine_sample *e)
{
    const fourlink_design *d = &e->s.design;
    const fourlink_state *state = &e->s.state;
    double g = hypot(d->gravity.x, d->gravity.y), m = d->link[3].mass, largest = 1e-3;
    double I = d->link[3].inertia + m * d->link[3].length * d->link[3].length;
    unsigned long i;

    for (i = 0; i <= e->n_loads; i++)
        largest = fmax(largest, hypot(e->load[i].force.x, e->load[i].force.y));
    largest = fmax(largest, (d->link[4].mass + 1.2 * m) * (fabs(state->a) + g));
    largest = fmax(largest, I * fabs(state->link[3].alpha) / d->link[3].length);
    largest =
        fmax(largest, m * hypot(state->link[3].acceleration.x, state->link[3].acceleration.y));
    return largest / fabs(state->sine);
}

TEST(test_nine_equations)
{
    uint64_t seed = 5;
    int n;

    for (n = 0; n < 30000; n++) {
        engine_sample e;

        draw_engine(&seed, n, 0, 0.05, &e);
        assert_near(e.engine.T_engine, -e.forces.Ts,
                    1e-12 * e.s.design.link[2].length * largest_force(&e));
        assert_near(e.engine.T_engine,
                    e.engine.T_piston + e.engine.T_correction + e.engine.T_weight_a +
                        e.engine.T_inertia_a,
                    1e-15 * e.s.design.link[2].length * largest_force(&e));
    }
}

/* The parts of the piston effort's torque, and the correction couple as a pair of forces. */
TEST(test_parts)
{
    uint64_t seed = 25;
    int n;

    for (n = 0; n < 10000; n++) {
        double r, along, F, towards_crank, scale;
        engine_sample e;
        unsigned long i;

        draw_engine(&seed, n, n % 11 == 0, 0.05, &e);
        r = e.s.design.link[2].length;
        towards_crank = e.s.branch == FOURLINK_OPEN ? -1 : 1;
        along = towards_crank * e.s.state.link[4].k_origin.x;
        F = e.engine.gas_force + e.engine.inertia_force +
            towards_crank * e.s.design.link[4].mass * e.s.design.gravity.x;
        for (i = 0; i < e.n_loads; i++)
            F += towards_crank * e.load[i].force.x;
        scale = (r + fabs(along)) * largest_force(&e);
        assert_near(F * along + e.engine.T_weight_b, e.engine.T_piston, 1e-13 * scale);
        assert_near(e.engine.correction_force * r * cos(e.s.crank.theta2), e.engine.T_correction,
                    1e-13 * scale);
        assert_near(e.engine.correction_force * e.s.design.link[3].length *
                        e.s.state.link[3].axis.x,
                    e.engine.correction_couple, 1e-13 * scale);
    }
}

/* Rod and crank of one length: the piston passes over the crankshaft and is on the other side for half a
** revolution, while the branch keeps its name, and the gas its direction. */
TEST(test_nine_equations_behind_a_change_point)
{
    uint64_t seed = 55;
    int n, behind = 0;

    for (n = 0; n < 5000; n++) {
        engine_sample e;

        draw_engine(&seed, n, 0, 0.05, &e);
        e.s.design.offset = 0;
        e.s.design.link[3].length = e.s.design.link[2].length;
        e.s.crank.theta2 = uniform(&seed, -4 * PI, 4 * PI);
        if (solve(&e.s) != FOURLINK_OK || fabs(e.s.state.sine) < 0.05)
            continue;
        assert_int_equal(
            fourlink_solve(&e.s.mechanism, &e.s.state, e.load, e.n_loads + 1, &e.forces),
            FOURLINK_OK);
        assert_int_equal(fourlink_engine_method(&e.s.mechanism, &e.s.state, e.gas, e.load,
                                                e.n_loads, FOURLINK_EXACT, &e.engine),
                         FOURLINK_OK);
        behind += e.s.state.sine * (double)e.s.state.branch < 0;
        assert_near(e.engine.T_engine, -e.forces.Ts,
                    1e-11 * e.s.design.link[2].length * largest_force(&e));
    }
    assert_true(behind > 2000);
}

/* A massless rod is a strut: the side thrust is the guide's force on the piston, less what acts on
** the piston across the stroke; the forces on crank pin and piston pin are the thrust in the rod,
** along it; crank effort and radial force are the components of the force on the crank pin. */
TEST(test_strut)
{
    uint64_t seed = 6;
    int n;

    for (n = 0; n < 20000; n++) {
        double tolerance, across, theta3, theta2;
        const fourlink_forces *f;
        engine_sample e;
        unsigned long i;

        draw_engine(&seed, n, 1, 0.05, &e);
        f = &e.forces;
        tolerance = 1e-12 * largest_force(&e);
        across = e.s.design.link[4].mass * e.s.design.gravity.y;
        for (i = 0; i < e.n_loads; i++)
            across += e.load[i].force.y;
        theta2 = e.s.crank.theta2;
        theta3 = e.s.state.link[3].theta;
        assert_near(e.engine.side_thrust, f->F14y + across, tolerance);
        assert_near(f->F34x, e.engine.rod_force * cos(theta3), tolerance);
        assert_near(f->F34y, e.engine.rod_force * sin(theta3), tolerance);
        assert_near(f->F23x, f->F34x, tolerance);
        assert_near(f->F23y, f->F34y, tolerance);
        /* the triangle of forces at the piston pin */
        assert_near(hypot(e.engine.piston_effort, e.engine.side_thrust), fabs(e.engine.rod_force),
                    tolerance);
        assert_near(e.engine.crank_effort, f->F23x * sin(theta2) - f->F23y * cos(theta2),
                    tolerance);
        assert_near(e.engine.radial_force, f->F23x * cos(theta2) + f->F23y * sin(theta2),
                    tolerance);
        assert_near(e.engine.T_engine, e.engine.T_piston, 0);
        assert_near(e.engine.T_piston, e.engine.crank_effort * e.s.design.link[2].length,
                    tolerance * e.s.design.link[2].length);
    }
}

/* ---------------------------------------------------------------------------------------------
** The engine method: the classical formulas
** ------------------------------------------------------------------------------------------- */

/* theory.md section 4 as it stands: e = 0, constant speed, horizontal or vertical engine. */
TEST(test_classical_formulas)
{
    uint64_t seed = 7;
    int i;

    for (i = 0; i < 6000; i++) {
        double r = uniform(&seed, 0.05, 1), n = uniform(&seed, 1.1, 8), l = n * r, g = 9.81;
        double theta = uniform(&seed, -PI, PI), w = uniform(&seed, -100, 100);
        double m = uniform(&seed, 0.1, 10), b = uniform(&seed, 0.05, 1) * l;
        double k = uniform(&seed, 0, 0.6) * l, m_p = uniform(&seed, 0, 10), s = sin(theta);
        double c = cos(theta), root = sqrt(n * n - s * s), phi = asin(s / n), lever, tolerance,
               of_couple;
        double m_a = m * b / l, m_b = m * (l - b) / l, L = b + k * k / b;
        double p1A1 = uniform(&seed, 0, 1e4), p2A2 = uniform(&seed, 0, 1e4), a, F, ddphi, T_c;
        int vertical = i % 2;
        fourlink_engine engine;
        sample e;

        a = r * w * w * (c + (n * n * cos(2 * theta) + s * s * s * s) / (root * root * root));
        ddphi = -w * w * s * (n * n - 1) / (root * root * root);
        lever = r * (s + sin(2 * theta) / (2 * root));
        F = p1A1 - p2A2 - (m_p + m_b) * a + (vertical ? (m_p + m_b) * g : 0);
        T_c = m * b * (l - L) * ddphi * c / root;
        slider_crank(r, l, theta, w, 0, &e);
        set_rod(&e, m, k, l - b);
        e.design.link[4].mass = m_p;
        if (vertical)
            e.design.gravity.x = -g;
        else
            e.design.gravity.y = -g;
        engine = engine_of(&e, p1A1 - p2A2, FOURLINK_EXACT);
        /* rounding of the angle grows by (n/root)^2 */
        tolerance = 1e-14 * (p1A1 + p2A2 + (m_p + m) * (g + 10 * r * w * w)) * n / root * n / root;
        of_couple = 1e-14 * m * (b * l + b * b + k * k) * w * w * pow(n / root, 4) / root;
        assert_true(engine.gas_force == p1A1 - p2A2);
        assert_near(engine.inertia_force, -(m_p + m_b) * a, tolerance);
        assert_near(engine.piston_effort, F, tolerance);
        assert_near(engine.rod_force, F / cos(phi), tolerance * n / root);
        assert_near(engine.side_thrust, F * tan(phi), tolerance * n / root);
        assert_near(engine.crank_effort, F * sin(theta + phi) / cos(phi), tolerance * n / root);
        assert_near(engine.radial_force, F * cos(theta + phi) / cos(phi), tolerance * n / root);
        assert_near(engine.correction_couple, m * b * (l - L) * ddphi, of_couple);
        assert_near(engine.T_piston, F * lever, tolerance * r * n / root);
        assert_near(engine.T_correction, T_c, of_couple / root);
        /* against the crank while the part rises, with it while it sinks */
        assert_near(engine.T_weight_a, vertical ? m_a * g * r * s : -m_a * g * r * c,
                    1e-14 * m_a * g * r);
        assert_true(engine.T_inertia_a == 0);
        assert_near(engine.T_engine,
                    F * lever + T_c + (vertical ? m_a * g * r * s : -m_a * g * r * c),
                    tolerance * l * n / root);
    }
}

/* What the series replace, and what not. */
TEST(test_approximations)
{
    uint64_t seed = 8;
    int i;

    for (i = 0; i < 2000; i++) {
        fourlink_engine exact, piston, all;
        fourlink_series series;
        fourlink_rod rod;
        double reciprocating, scale;
        sample s;

        draw(&seed, i, 0, 0.2, &s);
        set_rod(&s, uniform(&seed, 1, 10), uniform(&seed, 0, 0.1),
                s.design.link[3].length * uniform(&seed, 0.1, 0.9));
        s.design.link[4].mass = uniform(&seed, 0, 10);
        s.design.gravity.x = uniform(&seed, -10, 10);
        exact = engine_of(&s, 1000, FOURLINK_EXACT);
        piston = engine_of(&s, 1000, FOURLINK_SERIES_PISTON);
        all = engine_of(&s, 1000, FOURLINK_SERIES_ALL);
        series = series_of(&s);
        assert_int_equal(fourlink_rod_masses(&s.mechanism, &rod), FOURLINK_OK);
        reciprocating = s.design.link[4].mass + rod.m_b;
        scale = 1000 + reciprocating * (10 + fabs(s.state.a) + fabs(series.a));
        assert_near(exact.inertia_force, -reciprocating * s.state.a, 1e-14 * scale);
        assert_near(piston.inertia_force, -reciprocating * series.a, 1e-14 * scale);
        assert_near(all.inertia_force, piston.inertia_force, 0);
        assert_near(piston.piston_effort - exact.piston_effort,
                    reciprocating * (s.state.a - series.a), 1e-14 * scale);
        assert_near(piston.correction_couple, exact.correction_couple, 0);
        assert_near(all.correction_couple * s.state.link[3].alpha,
                    exact.correction_couple * series.alpha3,
                    1e-14 * fabs(all.correction_couple * s.state.link[3].alpha));
        assert_near(all.T_piston, piston.T_piston, 0);
        assert_near(all.T_weight_a, exact.T_weight_a, 0);
        assert_near(all.T_inertia_a, exact.T_inertia_a, 0);
        assert_near(exact.T_inertia_a,
                    -rod.m_a * s.design.link[2].length * s.design.link[2].length * s.crank.alpha2,
                    1e-12 * scale);
    }
}

/* ---------------------------------------------------------------------------------------------
** The engine method: the same engine seen from elsewhere
** ------------------------------------------------------------------------------------------- */

enum { N_QUANTITIES = 13 };

static void quantities(const fourlink_engine *e, double value[N_QUANTITIES])
{
    value[0] = e->gas_force;
    value[1] = e->inertia_force;
    value[2] = e->piston_effort;
    value[3] = e->rod_force;
    value[4] = e->radial_force;
    value[5] = e->side_thrust;
    value[6] = e->crank_effort;
    value[7] = e->correction_couple;
    value[8] = e->T_piston;
    value[9] = e->T_correction;
    value[10] = e->T_weight_a;
    value[11] = e->T_inertia_a;
    value[12] = e->T_engine;
}

static void assert_same_engine(const engine_sample *e, double half_turn, double mirror)
{
    double scale = largest_force(e) * (1 + e->s.design.link[3].length), a[N_QUANTITIES];
    double b[N_QUANTITIES];
    fourlink_load load[MOST_LOADS];
    fourlink_engine engine;
    sample s = e->s;
    unsigned long i;
    int k;

    if (half_turn < 0) {
        s.branch = s.branch == FOURLINK_OPEN ? FOURLINK_CROSSED : FOURLINK_OPEN;
        s.crank.theta2 += PI;
    }
    s.crank.theta2 *= mirror;
    s.crank.omega2 *= mirror;
    s.crank.alpha2 *= mirror;
    s.design.offset *= half_turn * mirror;
    s.design.gravity.x *= half_turn;
    s.design.gravity.y *= half_turn * mirror;
    memcpy(load, e->load, sizeof load);
    for (i = 0; i < e->n_loads; i++)
        load[i].force.x *= half_turn;
    assert_int_equal(solve(&s), FOURLINK_OK);
    assert_int_equal(fourlink_engine_method(&s.mechanism, &s.state, e->gas, load, e->n_loads,
                                            FOURLINK_EXACT, &engine),
                     FOURLINK_OK);
    quantities(&e->engine, a);
    quantities(&engine, b);
    /* torques and what points along y change sign in a mirror, what points along y in a half
    ** turn */
    for (k = 0; k < N_QUANTITIES; k++)
        assert_near(b[k], (k >= 5 ? mirror : 1) * (k == 5 ? half_turn : 1) * a[k], 2e-12 * scale);
}

TEST(test_half_turn_and_mirror)
{
    uint64_t seed = 9;
    int n;

    for (n = 0; n < 5000; n++) {
        engine_sample e;

        draw_engine(&seed, n, 0, 0.1, &e);
        assert_same_engine(&e, -1, 1);
        assert_same_engine(&e, 1, -1);
        assert_same_engine(&e, -1, -1);
    }
}

/* Loads on crank and rod, and the mass of the crank, are outside the method. */
TEST(test_passed_over)
{
    uint64_t seed = 10;
    int n;

    for (n = 0; n < 1000; n++) {
        fourlink_load loads[MOST_LOADS + 2];
        fourlink_engine engine;
        engine_sample e;

        draw_engine(&seed, n, 0, 0.1, &e);
        memset(loads, 0, sizeof loads);
        loads[0].link = FOURLINK_CRANK;
        loads[1].link = FOURLINK_COUPLER;
        loads[0].force.x = loads[1].force.x = loads[0].torque = loads[1].torque = 1e3;
        memcpy(loads + 2, e.load, e.n_loads * sizeof loads[0]);
        e.s.design.link[2].mass = e.s.design.link[2].inertia = 3;
        e.s.design.link[2].cg.x = 0.1;
        assert_int_equal(solve(&e.s), FOURLINK_OK);
        memset(&engine, 0, sizeof engine);
        assert_int_equal(fourlink_engine_method(&e.s.mechanism, &e.s.state, e.gas, loads,
                                                e.n_loads + 2, FOURLINK_EXACT, &engine),
                         FOURLINK_OK);
        assert_memory_equal(&engine, &e.engine, sizeof engine);
    }
}

static void refuse(const sample *s, double gas, const fourlink_load *loads, unsigned long n_loads,
                   fourlink_approximation approximation, int status)
{
    fourlink_engine engine, before;

    memset(&before, 0x5A, sizeof before);
    engine = before;
    assert_int_equal(fourlink_engine_method(&s->mechanism, &s->state, gas, loads, n_loads,
                                            approximation, &engine),
                     status);
    assert_memory_equal(&engine, &before, sizeof engine);
}

TEST(test_engine_statuses)
{
    static const fourlink_approximation any[] = {FOURLINK_EXACT, FOURLINK_SERIES_PISTON,
                                                 FOURLINK_SERIES_ALL};
    fourlink_engine engine;
    size_t i;
    sample s;

    slider_crank(1, 3, 1, 2, 3, &s);
    set_rod(&s, 1, 1, 1);
    assert_int_equal(solve(&s), FOURLINK_OK);
    assert_int_equal(fourlink_engine_method(NULL, &s.state, 0, NULL, 0, FOURLINK_EXACT, &engine),
                     FOURLINK_NULL);
    assert_int_equal(
        fourlink_engine_method(&s.mechanism, NULL, 0, NULL, 0, FOURLINK_EXACT, &engine),
        FOURLINK_NULL);
    assert_int_equal(
        fourlink_engine_method(&s.mechanism, &s.state, 0, NULL, 0, FOURLINK_EXACT, NULL),
        FOURLINK_NULL);
    refuse(&s, 0, NULL, 1, FOURLINK_EXACT, FOURLINK_NULL);
    refuse(&s, NAN, NULL, 0, FOURLINK_EXACT, FOURLINK_BAD_NUMBER);
    refuse(&s, INFINITY, NULL, 0, FOURLINK_EXACT, FOURLINK_BAD_NUMBER);
    refuse(&s, -1.1e30, NULL, 0, FOURLINK_EXACT, FOURLINK_BAD_NUMBER);
    assert_int_equal(
        fourlink_engine_method(&s.mechanism, &s.state, -1e30, NULL, 0, FOURLINK_EXACT, &engine),
        FOURLINK_OK);

    s.design.offset = 0.5;
    assert_int_equal(solve(&s), FOURLINK_OK);
    refuse(&s, 0, NULL, 0, FOURLINK_SERIES_PISTON, FOURLINK_NO_SERIES);
    refuse(&s, 0, NULL, 0, FOURLINK_SERIES_ALL, FOURLINK_NO_SERIES);
    assert_int_equal(
        fourlink_engine_method(&s.mechanism, &s.state, 0, NULL, 0, FOURLINK_EXACT, &engine),
        FOURLINK_OK);

    s.design.offset = 0;
    s.design.link[3].cg.y = 1e-3;
    assert_int_equal(solve(&s), FOURLINK_OK);
    for (i = 0; i < COUNT(any); i++)
        refuse(&s, 0, NULL, 0, any[i], FOURLINK_ROD_OFF_LINE);
    four_bar(&s);
    for (i = 0; i < COUNT(any); i++)
        refuse(&s, 0, NULL, 0, any[i], FOURLINK_NOT_AN_ENGINE);
}

/* "What is outside is refused with FOURLINK_BAD_NUMBER, NaN included": loads are no exception. */
TEST(test_bad_loads)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY, 1.1e30};
    size_t i;
    sample s;

    slider_crank(1, 3, 1, 2, 3, &s);
    assert_int_equal(solve(&s), FOURLINK_OK);
    for (i = 0; i < COUNT(bad); i++) {
        fourlink_load loads[2];

        memset(loads, 0, sizeof loads);
        loads[0].link = loads[1].link = FOURLINK_FOLLOWER;
        loads[1].force.x = bad[i];
        refuse(&s, 0, loads, 2, FOURLINK_EXACT, FOURLINK_BAD_NUMBER);
    }
}

/* ---------------------------------------------------------------------------------------------
** Klein's construction
** ------------------------------------------------------------------------------------------- */

/* What is read from the drawing is the motion at constant speed. */
TEST(test_klein_motion)
{
    uint64_t seed = 11;
    int n;

    for (n = 0; n < 10000; n++) {
        double w, l, size, sine;
        fourlink_klein klein;
        sample s;

        draw(&seed, n, n % 3, 0.05, &s);
        klein = klein_of(&s); /* it does not look at the acceleration of the crank */
        s.crank.alpha2 = 0;
        assert_int_equal(solve(&s), FOURLINK_OK);
        w = s.crank.omega2;
        l = s.design.link[3].length;
        sine = fabs(s.state.sine);
        /* BM^2/l is at most size^2/l/sine^2, and divided by sine once more in QN and ON */
        size = s.design.link[2].length + l;
        assert_near(w * klein.OM, s.state.v, 1e-14 * size * fabs(w) / (sine * sine));
        assert_near(w * klein.BM / l, s.state.link[3].omega, 1e-14 * size / l * fabs(w) / sine);
        size += size * size / l;
        assert_near(w * w * klein.BQ / l, s.state.link[3].omega * s.state.link[3].omega,
                    1e-14 * size / l * w * w / (sine * sine));
        assert_near(w * w * klein.ON, s.state.a, 1e-14 * size * w * w / (sine * sine * sine));
        assert_near(w * w * klein.QN / l, s.state.link[3].alpha,
                    1e-14 * size / l * w * w / (sine * sine * sine));
    }
}

/* The crank effort of the rod alone, by moments about I: at constant speed it is what the nine equations
** say of an engine with nothing else.  The arms are those of the drawing. */
TEST(test_klein_crank_effort)
{
    uint64_t seed = 26;
    int n;

    for (n = 0; n < 10000; n++) {
        double r, l, scale, k3, sine, FC, WC;
        const fourlink_vector *g;
        fourlink_vector B, C, I, G, a;
        fourlink_forces forces;
        fourlink_klein klein;
        sample s;

        draw(&seed, n, n % 3, 0.05, &s);
        r = s.design.link[2].length;
        l = s.design.link[3].length;
        s.crank.alpha2 = 0;
        set_rod(&s, uniform(&seed, 0.1, 10), uniform(&seed, 0, 1), l * uniform(&seed, -0.2, 1.2));
        s.design.link[3].cg.y = l * uniform(&seed, -0.5, 0.5);
        s.design.gravity.x = uniform(&seed, -30, 30);
        s.design.gravity.y = uniform(&seed, -30, 30);
        g = &s.design.gravity;
        assert_int_equal(solve(&s), FOURLINK_OK);
        assert_int_equal(fourlink_solve(&s.mechanism, &s.state, NULL, 0, &forces), FOURLINK_OK);
        klein = klein_of(&s);
        fourlink_point(&s.state, 3, &s.design.link[3].cg, &G, NULL, &a);
        sine = fabs(s.state.sine);
        FC = s.design.link[3].mass * hypot(a.x, a.y);
        WC = s.design.link[3].mass * hypot(g->x, g->y);
        scale =
            (1 + 1 / l) * (FC + WC + s.design.link[3].inertia * fabs(s.state.link[3].alpha)) / sine;
        assert_near(klein.FT * r, forces.Ts, 1e-12 * (r + l) * scale);

        k3 = s.state.link[3].k;
        if (fabs(k3) < 1e-3)
            continue;
        B = s.state.link[3].origin;
        C = s.state.link[4].origin;
        I.x = C.x;
        I.y = C.x * B.y / B.x;
        assert_near(fabs(klein.IX),
                    fabs((G.x - I.x) * g->y - (G.y - I.y) * g->x) / hypot(g->x, g->y),
                    1e-9 * (r + l) / fabs(k3) / sine);
        assert_close(klein.FT * hypot(I.x - B.x, I.y - B.y) + 1e6,
                     FC * klein.IY - WC * klein.IX + 1e6, 1e-9 * (1 + scale));
    }
    {
        sample s;

        slider_crank(1, 3, 90 * DEG, 2, 0, &s); /* I is at infinity */
        set_rod(&s, 1, 1, 1);
        s.design.gravity.y = -9.81;
        assert_int_equal(solve(&s), FOURLINK_OK);
        assert_true(isnan(klein_of(&s).IX) && isnan(klein_of(&s).IY) && isfinite(klein_of(&s).FT));
        slider_crank(1, 3, 1, 2, 0, &s); /* a rod without mass */
        assert_int_equal(solve(&s), FOURLINK_OK);
        assert_true(isnan(klein_of(&s).IX) && isnan(klein_of(&s).IY) && klein_of(&s).FT == 0);
    }
}

/* The point of the circle about B with radius R that is on the circle on BC as diameter, on one
** side of BC: bisection over the angle from BC, with which the distance from its middle grows. */
static fourlink_vector common_point(fourlink_vector B, fourlink_vector C, double R, double side)
{
    double l = hypot(C.x - B.x, C.y - B.y), direction = atan2(C.y - B.y, C.x - B.x);
    double low = 0, high = PI;
    fourlink_vector P = B;
    int i;

    for (i = 0; i < 60; i++) {
        double angle = (low + high) / 2;

        P.x = B.x + R * cos(direction + side * angle);
        P.y = B.y + R * sin(direction + side * angle);
        if (hypot(P.x - (B.x + C.x) / 2, P.y - (B.y + C.y) / 2) < l / 2)
            low = angle;
        else
            high = angle;
    }
    return P;
}

/* The drawing: M where the rod's line cuts the perpendicular to the stroke through O, two circles,
** their common chord, Q where it cuts the rod, N where it cuts the parallel to the stroke through
** O.  Lengths from the points, signs from the motion. */
TEST(test_klein_drawing)
{
    uint64_t seed = 12;
    int n, drawn = 0;

    for (n = 0; n < 20000; n++) {
        fourlink_vector B, C, M, P1, P2, Q, N;
        double r, l, e, X, R, along, tolerance, theta2;
        fourlink_klein klein;
        sample s;

        draw(&seed, n, n % 3, 0.2, &s);
        r = s.design.link[2].length;
        l = s.design.link[3].length;
        e = s.design.offset;
        theta2 = s.crank.theta2;
        B.x = r * cos(theta2);
        B.y = r * sin(theta2);
        X = sqrt(l * l - (B.y - e) * (B.y - e));
        C.x = B.x + (s.branch == FOURLINK_OPEN ? X : -X);
        C.y = e;
        M.x = 0;
        M.y = B.y - B.x * (C.y - B.y) / (C.x - B.x);
        R = hypot(M.x - B.x, M.y - B.y);
        /* the circles must meet, at points far enough apart to draw a line through */
        if (R > 0.9 * l || R < 0.05 * l)
            continue;
        drawn++;
        klein = klein_of(&s);
        P1 = common_point(B, C, R, 1);
        P2 = common_point(B, C, R, -1);
        along = P1.y / (P1.y - P2.y);
        N.x = P1.x + along * (P2.x - P1.x);
        N.y = 0;
        along = ((P1.x - B.x) * (C.x - B.x) + (P1.y - B.y) * (C.y - B.y)) / (l * l);
        Q.x = B.x + along * (C.x - B.x);
        Q.y = B.y + along * (C.y - B.y);
        /* Q is on the line through the two points as well */
        assert_near((Q.x - P1.x) * (P2.y - P1.y) - (Q.y - P1.y) * (P2.x - P1.x), 0, 1e-13 * l * l);
        tolerance = 1e-12 * (r + l + fabs(e));
        assert_near(fabs(klein.OM), hypot(M.x, M.y), tolerance);
        assert_near(fabs(klein.BM), R, tolerance);
        assert_near(klein.BQ, hypot(Q.x - B.x, Q.y - B.y), tolerance);
        assert_near(fabs(klein.QN), hypot(N.x - Q.x, N.y - Q.y), tolerance);
        assert_near(fabs(klein.ON), hypot(N.x, N.y), tolerance);
        s.crank.omega2 = 1;
        s.crank.alpha2 = 0;
        assert_int_equal(solve(&s), FOURLINK_OK);
        assert_true(klein.OM * s.state.v >= -tolerance);
        assert_true(klein.BM * s.state.link[3].omega >= -tolerance);
        assert_true(klein.QN * s.state.link[3].alpha >= -tolerance);
        assert_true(klein.ON * s.state.a >= -tolerance);
    }
    assert_true(drawn > 8000);
}

TEST(test_klein_statuses)
{
    fourlink_klein klein, before;
    sample s;

    memset(&before, 0x5A, sizeof before);
    klein = before;
    slider_crank(1, 3, 1, 2, 3, &s);
    assert_int_equal(solve(&s), FOURLINK_OK);
    assert_int_equal(fourlink_klein_construction(NULL, &s.state, &klein), FOURLINK_NULL);
    assert_int_equal(fourlink_klein_construction(&s.mechanism, NULL, &klein), FOURLINK_NULL);
    assert_int_equal(fourlink_klein_construction(&s.mechanism, &s.state, NULL), FOURLINK_NULL);
    four_bar(&s);
    assert_int_equal(fourlink_klein_construction(&s.mechanism, &s.state, &klein),
                     FOURLINK_NOT_AN_ENGINE);
    assert_memory_equal(&klein, &before, sizeof klein);
}

int main(void)
{
    return run_all_tests(NULL);
}
