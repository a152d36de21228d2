/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_dormand_prince.c - the order of a step, of its estimated error, and of the values within it.
*/
#include "check.h"
#include "fourlink.h"
#include "mechanics/dormand_prince.h"

/* y1' = y1 y2, y2' = -y1^2, y3' = y3 cos x */
static int derive(void *calls, double x, const double *y, double *dy)
{
    ++*(int *)calls;
    dy[0] = y[1] * y[0];
    dy[1] = -y[0] * y[0];
    dy[2] = y[2] * cos(x);
    return FOURLINK_OK;
}

/* y1 = 1 / cosh x, y2 = -tanh x, y3 = exp(sin x) */
static double exact(int i, double x)
{
    return i == 0 ? 1 / cosh(x) : i == 1 ? -tanh(x) : exp(sin(x));
}

static void begin(flk_step *s, int *calls, double x, double h)
{
    int i;

    s->f = derive;
    s->context = calls;
    s->x = x;
    s->h = h;
    for (i = 0; i < 3; i++)
        s->y[i] = exact(i, x);
    assert_int_equal(derive(calls, x, s->y, s->k[0]), FOURLINK_OK);
}

/* The error of a step, its estimate, and the error at a part of it. */
static void measure(double h, double error[3])
{
    flk_curve_of_step within;
    flk_step s;
    double estimates[3], slope, change;
    int calls = 0, i;

    begin(&s, &calls, 0.3, h);
    assert_int_equal(flk_step_take(&s, estimates), FOURLINK_OK);
    assert_int_equal(flk_step_end(&s), FOURLINK_OK);
    assert_int_equal(flk_step_within(&s, &within), FOURLINK_OK);
    assert_int_equal(calls, 16);
    memset(error, 0, 3 * sizeof *error);
    for (i = 0; i < 3; i++) {
        error[0] = fmax(error[0], fabs(s.next[i] - exact(i, 0.3 + h)));
        error[1] = fmax(error[1], estimates[i]);
        error[2] = fmax(error[2], fabs(s.y[i] + flk_step_change(&within, i, 0.4, &slope) -
                                       exact(i, 0.3 + 0.4 * h)));
        change = flk_step_change(&within, i, 0.4 + 1e-5, &slope) -
                 flk_step_change(&within, i, 0.4 - 1e-5, &slope);
        flk_step_change(&within, i, 0.4, &slope);
        assert_near(slope, change / 2e-5, 1e-9);
        assert_near(s.y[i] + flk_step_change(&within, i, 1, &slope), s.next[i], 1e-15);
        assert_near(slope, h * s.k[FLK_STAGE_AT_END][i], 1e-14);
        assert_near(flk_step_change(&within, i, 0, &slope), 0, 0);
        assert_near(slope, h * s.k[0][i], 1e-14);
    }
}

/* Halving the step divides the error of a step by 2^9, its estimate by 2^8 and the error within it by 2^8. */
TEST(test_order)
{
    double whole[3], half[3];

    measure(0.4, whole);
    measure(0.2, half);
    assert_true(half[0] < whole[0] / 250 && half[1] < whole[1] / 120 && half[2] < whole[2] / 120);
    assert_true(half[0] > 1e-15 && half[2] > 1e-15);
    assert_true(half[1] >= half[0]); /* it is on the safe side */
}

static int refuse(void *context, double x, const double *y, double *dy)
{
    (void)context;
    (void)x;
    dy[0] = dy[1] = dy[2] = y[0];
    return FOURLINK_LOCKED;
}

TEST(test_refused)
{
    double error[3] = {7, 7, 7};
    int calls = 0;
    flk_step s;

    begin(&s, &calls, 0, 0.1);
    s.f = refuse;
    assert_int_equal(flk_step_take(&s, error), FOURLINK_LOCKED);
    assert_near(error[0], 7, 0);
}

int main(void)
{
    return run_all_tests(NULL);
}
