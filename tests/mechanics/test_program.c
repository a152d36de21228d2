/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_program.c - laws of motion and splines, against values computed in 40 digits, and random programs against
** differences and a quadrature of their own.
*/
#include <float.h>

#include "check.h"

#include <math.h>
#include <string.h>

#include "mechanics/program.h"

#define MOST 12 /* segments */

typedef struct one {
    flk_program p;
    flk_program_segment g[MOST];
    double room[3 * (MOST + 1)];
} one;

/* A program through n + 1 points. */
static void through(one *x, unsigned long n, const double *t, const double *q, flk_law law)
{
    unsigned long i;

    memset(x, 0, sizeof *x);
    x->p.n = n;
    x->p.segment = x->g;
    for (i = 0; i < n; i++) {
        x->g[i].begin = t[i];
        x->g[i].length = t[i + 1] - t[i];
        x->g[i].value = q[i];
        x->g[i].rise = q[i + 1] - q[i];
        x->g[i].law = law;
        x->g[i].ramp[0] = x->g[i].ramp[1] = 1.0 / 3;
    }
}

static void prepare(one *x)
{
    flk_program_prepare(&x->p, x->room);
}

static void check_at(const one *x, double t, double q, double v, double a)
{
    double found[3];

    flk_program_at(&x->p, t, found);
    assert_near(found[0], q, 1e-11 * fmax(1, fabs(q)));
    assert_near(found[1], v, 1e-11 * fmax(1, fabs(v)));
    assert_near(found[2], a, 1e-11 * fmax(1, fabs(a)));
}

TEST(test_laws)
{
    static const double ends[] = {0, 1};
    static const struct {
        flk_law law;
        double u, s, rate, second;
    } values[] = {{FLK_LAW_HARMONIC, 0.1, 0.0244717418524, 0.485402759681, 4.69327578946},
                  {FLK_LAW_HARMONIC, 0.3, 0.206107373854, 1.27080092308, 2.90060395646},
                  {FLK_LAW_HARMONIC, 0.7, 0.793892626146, 1.27080092308, -2.90060395646},
                  {FLK_LAW_CYCLOIDAL, 0.1, 0.00645107162114, 0.190983005625, 3.69316366098},
                  {FLK_LAW_CYCLOIDAL, 0.3, 0.148634654272, 1.30901699437, 5.97566432948},
                  {FLK_LAW_CYCLOIDAL, 0.7, 0.851365345728, 1.30901699437, -5.97566432948},
                  {FLK_LAW_POLYNOMIAL_5, 0.1, 0.00856, 0.243, 4.32},
                  {FLK_LAW_POLYNOMIAL_5, 0.3, 0.16308, 1.323, 5.04},
                  {FLK_LAW_POLYNOMIAL_5, 0.7, 0.83692, 1.323, -5.04},
                  {FLK_LAW_POLYNOMIAL_7, 0.1, 0.002728, 0.10206, 2.7216},
                  {FLK_LAW_POLYNOMIAL_7, 0.3, 0.126036, 1.29654, 7.4088},
                  {FLK_LAW_POLYNOMIAL_7, 0.7, 0.873964, 1.29654, -7.4088},
                  {FLK_LAW_MODIFIED_SINE, 0.1, 0.0106972127914, 0.303964009084, 5.25739959374},
                  {FLK_LAW_MODIFIED_SINE, 0.3, 0.177887762629, 1.32295420693, 4.10807269244},
                  {FLK_LAW_MODIFIED_SINE, 0.7, 0.822112237371, 1.32295420693, -4.10807269244},
                  {FLK_LAW_CUBIC, 0.25, 0.15625, 1.125, 3},
                  {FLK_LAW_TRAPEZOID, 0.2, 0.09, 0.9, 4.5},
                  {FLK_LAW_TRAPEZOID, 0.5, 0.5, 1.5, 0},
                  {FLK_LAW_TRAPEZOID, 0.9, 0.9775, 0.45, -4.5},
                  {FLK_LAW_LINEAR, 0.3, 0.3, 1, 0}};
    size_t i;
    one x;

    for (i = 0; i < sizeof values / sizeof values[0]; i++) {
        through(&x, 1, ends, ends, values[i].law);
        prepare(&x);
        check_at(&x, values[i].u, values[i].s, values[i].rate, values[i].second);
    }
}

/* Beside rest a speed goes as a power of the distance d, to its digits: by its sign friction acts. */
TEST(test_laws_beside_rest)
{
    static const double ends[] = {0, 1}, k = 1 / (4 + PI);
    static const struct {
        flk_law law;
        double factor;
        int power;
    } laws[] = {{FLK_LAW_HARMONIC, PI * PI / 2, 1},
                {FLK_LAW_CYCLOIDAL, 2 * PI * PI, 2},
                {FLK_LAW_POLYNOMIAL_5, 30, 2},
                {FLK_LAW_POLYNOMIAL_7, 140, 3},
                {FLK_LAW_MODIFIED_SINE, 8 * PI * PI * PI * k, 2},
                {FLK_LAW_CUBIC, 6, 1},
                {FLK_LAW_TRAPEZOID, 4.5, 1}};
    double found[3];
    size_t i;
    one x;
    int n, end;

    for (i = 0; i < sizeof laws / sizeof laws[0]; i++) {
        through(&x, 1, ends, ends, laws[i].law);
        prepare(&x);
        for (n = 8; n <= 40; n++)
            for (end = 0; end < 2; end++) {
                double d = ldexp(1, -n);

                flk_program_at(&x.p, end ? 1 - d : d, found);
                assert_near(found[1] / (laws[i].factor * pow(d, laws[i].power)), 1,
                            40 * d + 1e-15 / d);
            }
    }
}

TEST(test_splines)
{
    static const double t[] = {0, 0.2, 0.5, 0.7, 1}, q[] = {0, 0.5, 1.6, 1.4, 0};
    static const double turn_t[] = {0, 0.2, 0.5, 0.8, 1}, turn[] = {0, 60, 200, 300, 360};
    static const double three_t[] = {0, 0.4, 1}, three[] = {0, 200, 360};
    one x;

    through(&x, 4, t, q, FLK_LAW_SPLINE);
    prepare(&x);
    check_at(&x, 0, 0, 1.97126436782, 0);
    check_at(&x, 0.1, 0.210344827586, 2.36781609195, 7.93103448276);
    check_at(&x, 0.35, 1.12693965517, 4.2341954023, -6.83908045977);
    check_at(&x, 0.7, 1.4, -3.05747126437, -16.091954023);
    check_at(&x, 0.9, 0.538186462324, -5.2030651341, -5.36398467433);
    through(&x, 4, t, q, FLK_LAW_SPLINE);
    x.p.ends = FLK_ENDS_SPEEDS;
    prepare(&x);
    check_at(&x, 0, 0, 0, 33.9942528736);
    check_at(&x, 0.1, 0.147485632184, 2.72485632184, 20.5028735632);
    check_at(&x, 0.35, 1.13825431034, 4.03807471264, -7.84482758621);
    check_at(&x, 0.7, 1.4, -4.22413793103, -37.0114942529);
    check_at(&x, 0.9, 0.269093231162, -4.81417624521, 31.1111111111);
    through(&x, 4, t, q, FLK_LAW_SPLINE);
    x.p.ends = FLK_ENDS_PERIODIC;
    prepare(&x);
    check_at(&x, 0, 0, -1.09595959596, 52.3232323232);
    check_at(&x, 0.1, 0.111111111111, 2.90909090909, 27.7777777778);
    check_at(&x, 0.35, 1.15738636364, 3.98611111111, -9.54545454545);
    check_at(&x, 0.7, 1.4, -3.9595959596, -33.2323232323);
    check_at(&x, 0.9, 0.323681257015, -4.90235690236, 23.8047138047);
    through(&x, 4, turn_t, turn, FLK_LAW_SPLINE);
    x.p.ends = FLK_ENDS_PERIODIC;
    prepare(&x);
    check_at(&x, 0, 0, 280, -400);
    check_at(&x, 0.1, 27.5, 285, 500);
    check_at(&x, 0.35, 128.125, 497.5, 166.666666667);
    check_at(&x, 0.9, 330.5, 305, -100);
    through(&x, 2, three_t, three, FLK_LAW_SPLINE);
    x.p.ends = FLK_ENDS_PERIODIC;
    prepare(&x);
    check_at(&x, 0, 0, 406.0 + 2.0 / 3, 1400); /* 766.7 and -133.3 by a spline of the differences */
    check_at(&x, 1, 360, 406.0 + 2.0 / 3, 1400);
}

/* ------------------------------------------------------------------------------------------ random programs */

static unsigned long long seed = 88172645463325252ULL;

static double chance(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (double)(seed >> 11) / 9007199254740992.0;
}

static void make_random(one *x)
{
    double t[MOST + 1], q[MOST + 1], a;
    unsigned long n = 1 + (unsigned long)(chance() * (MOST - 1)), i;
    flk_law law = (flk_law)(chance() * FLK_LAW_COUNT);
    int is_mixed = chance() < 0.4;

    t[0] = chance() < 0.5 ? 0 : chance() - 0.5;
    q[0] = 10 * chance() - 5;
    for (i = 0; i < n; i++) {
        t[i + 1] = t[i] + pow(10, 2 * chance() - 1.5);
        q[i + 1] = chance() < 0.2 ? q[i] : 10 * chance() - 5;
    }
    through(x, n, t, q, law);
    for (i = 0; i < n; i++) {
        if (is_mixed)
            x->g[i].law = (flk_law)(chance() * FLK_LAW_COUNT);
        a = chance() < 0.2 ? 0 : chance();
        x->g[i].ramp[0] = a;
        x->g[i].ramp[1] = chance() < 0.2 ? 0 : (1 - a) * chance();
    }
    x->p.ends = (flk_program_ends)(3 * chance());
    x->p.speed[0] = 4 * chance() - 2;
    x->p.speed[1] = 4 * chance() - 2;
    x->p.is_of_speed = chance() < 0.4;
    x->p.from = 4 * chance();
    prepare(x);
}

static double largest(const one *x)
{
    double at[3], most = 1;
    int i;

    for (i = 0; i <= 200; i++) {
        flk_program_at(&x->p, x->g[0].begin + i / 200.0 * (flk_program_end(&x->p) - x->g[0].begin),
                       at);
        most = fmax(most, fmax(fabs(at[0]), fmax(fabs(at[1]), fabs(at[2]))));
    }
    return most;
}

/* Between two corners: speed and acceleration are those of differences, and the coordinate rises by the integral of the
** speed, by the rule of Gauss with five points on each of eight parts. */
static void check_part(const one *x, double from, double to, double size, double worst[3])
{
    static const double node[] = {0, 0.5384693101056831, 0.9061798459386640},
                        weight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    double at[3], low[3], high[3], step = (to - from) / 64, h = step / 50, sum = 0;
    int i, k;

    for (i = 1; i < 64; i += 9) {
        double t = from + i * step;

        flk_program_at(&x->p, t - h, low);
        flk_program_at(&x->p, t, at);
        flk_program_at(&x->p, t + h, high);
        worst[0] = fmax(worst[0], fabs((high[0] - low[0]) / (2 * h) - at[1]) / (size / h));
        worst[1] = fmax(worst[1], fabs((high[1] - low[1]) / (2 * h) - at[2]) / (size / h));
    }
    for (i = 0; i < 8; i++)
        for (k = -2; k <= 2; k++) {
            flk_program_at(&x->p,
                           from + (to - from) / 8 * (i + 0.5 + node[abs(k)] * (k < 0 ? -1 : 1) / 2),
                           at);
            sum += weight[abs(k)] / 2 * (to - from) / 8 * at[1];
        }
    flk_program_at(&x->p, from, low);
    flk_program_at(&x->p, to, high);
    worst[2] = fmax(worst[2], fabs(high[0] - low[0] - sum) / size);
}

/* At the inner points splines are smooth, and each program passes them. */
static void check_points(const one *x, double size)
{
    double at[3], before[3];
    unsigned long i;

    for (i = 0; i < x->p.n; i++) {
        flk_program_at(&x->p, x->g[i].begin, at);
        assert_near(at[x->p.is_of_speed], x->g[i].value, 1e-12 * size);
        if (i > 0 && x->g[i - 1].law == FLK_LAW_SPLINE && x->g[i].law == FLK_LAW_SPLINE) {
            flk_program_at(&x->p, x->g[i].begin * (1 - 1e-15) - 1e-15, before);
            assert_near(at[1], before[1], 1e-9 * size);
            assert_near(at[2], before[2], 1e-9 * size / x->g[i].length);
        }
    }
}

TEST(test_random_programs)
{
    double worst[3] = {0, 0, 0}, from, to, end, size;
    int i;
    one x;

    for (i = 0; i < 3000; i++) {
        make_random(&x);
        size = largest(&x);
        check_points(&x, size);
        end = flk_program_end(&x.p);
        for (from = x.g[0].begin; from < end; from = to) {
            to = flk_program_corner(&x.p, from);
            assert_true(to > from && to <= end);
            check_part(&x, from, to, size, worst);
        }
    }
    print_message("speed %.1e, acceleration %.1e, integral %.1e\n", worst[0], worst[1], worst[2]);
    assert_true(worst[0] < 1e-6 && worst[1] < 1e-6 && worst[2] < 1e-9);
}

/* A row's time is rounded: a few of its last digits before or behind a corner, there are the speed and acceleration
** behind it. */
TEST(test_rows_at_corners)
{
    double at, behind[3], x[3], size, end, T;
    int i, digits;
    one o;

    for (i = 0; i < 3000; i++) {
        make_random(&o);
        size = largest(&o);
        end = flk_program_end(&o.p);
        for (at = o.g[0].begin; at < end; at = flk_program_corner(&o.p, at)) {
            T = flk_program_segment_at(&o.p, at)->length;
            flk_program_at(&o.p, at + 1e-12 * T, behind);
            for (digits = -3; digits <= 3; digits++) {
                flk_program_at(&o.p, at + digits * DBL_EPSILON * fabs(at), x);
                assert_near(x[0], behind[0], 1e-10 * size);
                assert_near(x[1], behind[1], 1e-8 * fmax(fabs(behind[1]), size / T));
                assert_near(x[2], behind[2], 1e-5 * fmax(fabs(behind[2]), size / (T * T)));
            }
        }
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
