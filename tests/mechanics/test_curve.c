/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_curve.c - curves over the crank angle: through their points, periodic, smooth, without
** overshoot.
*/
#include "check.h"
#include "mechanics/curve.h"

#include <stdlib.h>

#define MOST 14

typedef struct sample {
    double x[MOST], y[MOST], period;
    size_t n;
    double largest; /* |y| */
    curve c;
} sample;

static void make(const double *x, const double *y, size_t n, double period, curve *c)
{
    double *memory = calloc(FLK_CURVE_MEMORY(n), sizeof *memory);

    assert_non_null(memory);
    flk_curve_place(memory, n, c);
    memcpy(c->x, x, n * sizeof *x);
    memcpy(c->y, y, n * sizeof *y);
    flk_curve_finish(period, c);
}

static void release(curve *c)
{
    free(c->x);
    memset(c, 0, sizeof *c);
}

/* 2 to 14 points at unequal distances, no two nearer than 1/50 of a mean distance, that start
** anywhere; some of them equal to their neighbours. */
static void draw(uint64_t *seed, int number, sample *s)
{
    double sum = 0, total;
    size_t i;

    memset(s, 0, sizeof *s);
    s->n = 2 + (size_t)number % (MOST - 1);
    s->period = number % 3 == 0 ? 4 * PI : number % 3 == 1 ? 2 * PI : uniform(seed, 0.1, 100);
    for (i = 0; i < s->n; i++) {
        s->x[i] = sum;
        sum += uniform(seed, 0.02, 1.98);
        s->y[i] = i > 0 && uniform(seed, 0, 1) < 0.1 ? s->y[i - 1] : uniform(seed, -50, 50);
        s->largest = fmax(s->largest, fabs(s->y[i]));
    }
    total = uniform(seed, -2, 2);
    for (i = 0; i < s->n; i++)
        s->x[i] = s->period * (s->x[i] / sum + total);
    make(s->x, s->y, s->n, s->period, &s->c);
}

/* Point i, also beyond the first and the last. */
static double x_of(const sample *s, int i)
{
    int n = (int)s->n, turns = (i + 4 * n) / n - 4;

    return s->x[i - turns * n] + turns * s->period;
}

static double y_of(const sample *s, int i)
{
    return s->y[(i + 4 * (int)s->n) % (int)s->n];
}

/* The steepest straight line between neighbours: no curve without overshoot and with Steffen's
** slopes, at most twice the lesser of two neighbours', is more than three times as steep. */
static double steepest(const sample *s)
{
    double result = 0;
    int i;

    for (i = 0; i < (int)s->n; i++)
        result = fmax(result, fabs(y_of(s, i + 1) - y_of(s, i)) / (x_of(s, i + 1) - x_of(s, i)));
    return result;
}

/* The rounding of an angle of this size, through the slope, and that of the value. */
static double rounding(const sample *s, double x)
{
    return 1e-14 * (s->largest + steepest(s) * (fabs(x) + 4 * s->period));
}

TEST(test_points)
{
    uint64_t seed = 1;
    int number, i;

    for (number = 0; number < 1000; number++) {
        sample s;

        draw(&seed, number, &s);
        for (i = 0; i < (int)s.n; i++)
            assert_near(flk_curve_piece(&s.c, s.x[i], s.x[i]), s.y[i], 1e-14 * s.largest);
        release(&s.c);
    }
}

/* The same in every period, before and after the points. */
TEST(test_periodic)
{
    static const int periods[] = {-1000, -20, -3, -2, -1, 1, 2, 3, 20, 1000};
    uint64_t seed = 2;
    int number, k, changing = 0;
    size_t i;

    for (number = 0; number < 600; number++) {
        sample s;

        draw(&seed, number, &s);
        for (k = 0; k < 50; k++) {
            /* halfway round the curve is another one: nothing is constant by mistake */
            double x = uniform(&seed, -1, 2) * s.period, y = flk_curve_piece(&s.c, x, x);

            changing += fabs(flk_curve_piece(&s.c, x + s.period / 2, x + s.period / 2) - y) >
                        1e-3 * s.largest;
            for (i = 0; i < COUNT(periods); i++) {
                double far = x + periods[i] * s.period;

                assert_near(flk_curve_piece(&s.c, far, far), y, rounding(&s, far));
            }
        }
        for (k = 0; k < (int)s.n; k++)
            for (i = 0; i < COUNT(periods); i++) {
                double far = s.x[k] + periods[i] * s.period;

                assert_near(flk_curve_piece(&s.c, far, far), s.y[k], rounding(&s, far));
            }
        release(&s.c);
    }
    assert_true(changing > 25000);
}

/* Where the points are given from does not matter: the same points, begun at another one. */
TEST(test_any_first_point)
{
    uint64_t seed = 3;
    int number, k;
    size_t first, i;

    for (number = 0; number < 300; number++) {
        sample s;

        draw(&seed, number, &s);
        for (first = 1; first < s.n; first++) {
            double x[MOST], y[MOST];
            curve c;

            for (i = 0; i < s.n; i++) {
                x[i] = x_of(&s, (int)(first + i));
                y[i] = y_of(&s, (int)(first + i));
            }
            make(x, y, s.n, s.period, &c);
            for (k = 0; k < 20; k++) {
                double at = uniform(&seed, -3, 3) * s.period;

                assert_near(flk_curve_piece(&c, at, at), flk_curve_piece(&s.c, at, at),
                            4 * rounding(&s, at));
            }
            release(&c);
        }
        release(&s.c);
    }
}

/* Between two neighbours the curve rises or falls all the way from the one to the other. */
TEST(test_no_overshoot)
{
    enum { STEPS = 40 };
    uint64_t seed = 4;
    int number, i, k;

    for (number = 0; number < 1000; number++) {
        double tolerance;
        sample s;

        draw(&seed, number, &s);
        tolerance = 1e-14 * s.largest;
        for (i = -(int)s.n; i < 2 * (int)s.n; i++) {
            double from = y_of(&s, i), to = y_of(&s, i + 1), sign = to >= from ? 1 : -1;
            double before = from;

            for (k = 1; k < STEPS; k++) {
                double x = x_of(&s, i) + (x_of(&s, i + 1) - x_of(&s, i)) * k / STEPS;
                double y = flk_curve_piece(&s.c, x, x);

                assert_true(y >= fmin(from, to) - tolerance && y <= fmax(from, to) + tolerance);
                assert_true(sign * (y - before) >= -rounding(&s, x));
                before = y;
            }
            assert_true(sign * (to - before) >= -rounding(&s, x_of(&s, i + 1)));
        }
        release(&s.c);
    }
}

/* The slope at a point from four values on one side of it, exact for a piece of a cubic. */
static double one_sided(const sample *s, int i, int side)
{
    double x = x_of(s, i), h = (x_of(s, i + side) - x) / 3;

    return (-11 * flk_curve_piece(&s->c, x, x) + 18 * flk_curve_piece(&s->c, x + h, x + h) -
            9 * flk_curve_piece(&s->c, x + 2 * h, x + 2 * h) +
            2 * flk_curve_piece(&s->c, x + 3 * h, x + 3 * h)) /
           (6 * h);
}

/* M. Steffen, "A simple method for monotonic interpolation in one dimension", 1990: the slope of
** the parabola through three neighbours, limited so that the curve is monotonic. */
static double steffen(const sample *s, int i)
{
    double h0 = x_of(s, i) - x_of(s, i - 1), h1 = x_of(s, i + 1) - x_of(s, i);
    double s0 = (y_of(s, i) - y_of(s, i - 1)) / h0, s1 = (y_of(s, i + 1) - y_of(s, i)) / h1;
    double p = (s0 * h1 + s1 * h0) / (h0 + h1);

    if (s0 * s1 <= 0)
        return 0;
    return copysign(fmin(fmin(2 * fabs(s0), 2 * fabs(s1)), fabs(p)), s0);
}

/* At every point, and where the periods join, the curve and its slope are the same from both sides;
** and the slope is that of the method. */
TEST(test_continuous)
{
    uint64_t seed = 5;
    int number, i, k, sloping = 0;

    for (number = 0; number < 1000; number++) {
        double steep, tiny, tolerance;
        sample s;

        draw(&seed, number, &s);
        steep = steepest(&s);
        tiny = 1e-9 * s.period;
        for (i = -(int)s.n; i < 2 * (int)s.n; i++) {
            double x = x_of(&s, i), slope = steffen(&s, i);
            double h = fmin(x_of(&s, i + 1) - x, x - x_of(&s, i - 1));

            tolerance = 40 * rounding(&s, x) / h;
            assert_near(flk_curve_piece(&s.c, x + tiny, x + tiny), y_of(&s, i),
                        3 * steep * tiny + rounding(&s, x));
            assert_near(flk_curve_piece(&s.c, x - tiny, x - tiny), y_of(&s, i),
                        3 * steep * tiny + rounding(&s, x));
            assert_near(one_sided(&s, i, 1), slope, tolerance);
            assert_near(one_sided(&s, i, -1), slope, tolerance);
            sloping += fabs(slope) > 100 * tolerance;
        }
        for (k = 0; k < 100; k++) {
            double x = uniform(&seed, -2, 2) * s.period;

            assert_near(flk_curve_piece(&s.c, x + tiny, x + tiny), flk_curve_piece(&s.c, x, x),
                        3 * steep * tiny + rounding(&s, x));
        }
        release(&s.c);
    }
    assert_true(sloping > 5000);
}

/* Two points are a high and a low: level at both, a cubic between them. */
TEST(test_two_points)
{
    uint64_t seed = 6;
    int number, k;

    for (number = 0; number < 1000; number++) {
        double x[2], y[2], period = number % 2 ? 4 * PI : 2 * PI;
        curve c;

        x[0] = uniform(&seed, -10, 10);
        x[1] = x[0] + uniform(&seed, 0.05, 0.95) * period;
        y[0] = uniform(&seed, -1, 1);
        y[1] = uniform(&seed, -1, 1);
        make(x, y, 2, period, &c);
        for (k = 0; k < 20; k++) {
            double t = uniform(&seed, 0, 1), u = t * t * (3 - 2 * t);

            assert_near(flk_curve_piece(&c, x[0] + t * (x[1] - x[0]), x[0] + t * (x[1] - x[0])),
                        y[0] + u * (y[1] - y[0]), 1e-12);
            assert_near(flk_curve_piece(&c, x[1] + t * (x[0] + period - x[1]) - 3 * period,
                                        x[1] + t * (x[0] + period - x[1]) - 3 * period),
                        y[1] + u * (y[0] - y[1]), 1e-12);
        }
        release(&c);
    }
}

/* A constant stays the same number; and a straight part of a curve is straight. */
TEST(test_constant_and_straight)
{
    static const double saw_x[] = {0, 0.5, 1.1, 2, 2.2, 3, 5, 6},
                        saw_y[] = {1, 2, 3.2, 5, 5.4, 7, 11, -3};
    static const double constants[] = {0, 0.1, -1e5 / 3, 1e30};
    uint64_t seed = 7;
    size_t i, n;
    int k;
    curve c;

    for (i = 0; i < COUNT(constants); i++)
        for (n = 2; n <= 8; n++) {
            double y[8];
            size_t j;

            for (j = 0; j < n; j++)
                y[j] = constants[i];
            make(saw_x, y, n, 2 * PI, &c);
            for (k = 0; k < 100; k++)
                assert_true(flk_curve_piece(&c, uniform(&seed, -100, 100),
                                            uniform(&seed, -100, 100)) == constants[i]);
            release(&c);
        }
    make(saw_x, saw_y, 8, 4 * PI, &c);
    for (k = 0; k < 1000; k++) {
        double x = uniform(&seed, 0.5, 3);

        assert_near(flk_curve_piece(&c, x, x), 1 + 2 * x, 1e-14);
        assert_near(flk_curve_piece(&c, x - 4 * PI, x - 4 * PI), 1 + 2 * x, 1e-13);
    }
    release(&c);
}

/* An indicator card over the two turns of a four-stroke engine: the second turn is not the
** first. */
TEST(test_two_turns)
{
    static const double degrees[] = {0, 10, 30, 90, 180, 360, 540, 700},
                        bar[] = {20, 40, 15, 4, 1, 1, 1, 15};
    double x[8];
    size_t i;
    int turn;
    curve c;

    for (i = 0; i < 8; i++)
        x[i] = degrees[i] * DEG;
    make(x, bar, 8, 720 * DEG, &c);
    for (turn = -4; turn <= 4; turn++) {
        double level = flk_curve_piece(&c, (10 + 360 * turn) * DEG, (10 + 360 * turn) * DEG);

        assert_near(level, turn % 2 ? 1 : 40, 1e-12);
        assert_near(flk_curve_piece(&c, (450 + 720 * turn) * DEG, (450 + 720 * turn) * DEG), 1,
                    1e-12);
        assert_near(flk_curve_piece(&c, (-20 + 720 * turn) * DEG, (-20 + 720 * turn) * DEG), 15,
                    1e-11);
    }
    release(&c);
}

TEST(test_release)
{
    static const double x[] = {0, 1, 2}, y[] = {1, 2, 3};
    curve c;

    make(x, y, 3, 2 * PI, &c);
    assert_true(c.n > 0 && c.x && c.y);
    release(&c);
    assert_true(c.n == 0 && !c.x && !c.y);
    release(&c);
}

/* Far out an angle has no digits left of its place in the period; the value is one of the curve's. */
TEST(test_far_angles)
{
    static const double x[3] = {0.1, 1, 4}, y[3] = {1, 10, 3};
    uint64_t seed = 5;
    curve c;
    int i;

    make(x, y, 3, 2 * M_PI, &c);
    for (i = 0; i < 100000; i++) {
        double angle = uniform(&seed, -1, 1) * pow(10, uniform(&seed, 10, 30));
        double value = flk_curve_piece(&c, angle, angle);

        assert_true(0.999 <= value && value <= 10.001);
    }
    release(&c);
}

int main(void)
{
    return run_all_tests(NULL);
}
