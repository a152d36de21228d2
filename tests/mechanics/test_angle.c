/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_angle.c - the angle of a unit vector, against the C library's.
*/
#include "check.h"
#include "mechanics/mechanics.h"

#define PI 3.14159265358979323846

static double angle_of(double x, double y)
{
    fourlink_vector u;

    u.x = x;
    u.y = y;
    return flk_angle(&u);
}

/* All round, and close to the axes on either side. */
static void test_unit_vectors(void **unused)
{
    uint64_t seed = 1;
    int n;

    (void)unused;
    for (n = 0; n < 1000000; n++) {
        double t = uniform(&seed, -PI, PI), x, y;

        if (n % 3 == 1)
            t = pow(10, uniform(&seed, -15, 0)) + PI / 2 * (n % 4);
        if (n % 3 == 2)
            t = -pow(10, uniform(&seed, -15, 0)) + PI / 2 * (n % 4);
        x = cos(t);
        y = sin(t);
        if (fabs(y) >= 4e-16) {
            assert_near(angle_of(x, y), atan2(y, x), 8e-16);
            if (x > 0)
                assert_close(angle_of(x, y), atan2(y, x), 8e-16);
        }
    }
}

/* On both sides of every step of the table. */
static void test_steps(void **unused)
{
    int k, i;

    (void)unused;
    for (k = 1; k < 24; k++)
        for (i = -50; i <= 50; i++) {
            double s = k / 32.0 + i * 1e-16, c = sqrt((1 - s) * (1 + s));

            assert_near(angle_of(c, s), atan2(s, c), 6e-16);
            assert_near(angle_of(-s, c), atan2(c, -s), 8e-16);
        }
}

static void test_axes(void **unused)
{
    (void)unused;
    assert_true(angle_of(1, 0) == 0 && angle_of(1, -0.0) == 0);
    assert_true(angle_of(-1, 0) == PI && angle_of(-1, -0.0) == PI);
    assert_true(angle_of(0, 1) == PI / 2 && angle_of(0, -1) == -PI / 2);
    /* 180 deg but for rounding is 180 deg */
    assert_true(angle_of(-1, -3e-16) == PI && angle_of(-1, 3e-16) == PI);
    assert_near(angle_of(-1, -5e-16), -PI, 1e-15);
}

/* A vector whose length is not 1 keeps its direction; what is no number has none. */
static void test_other_vectors(void **unused)
{
    uint64_t seed = 2;
    int n;

    (void)unused;
    for (n = 0; n < 10000; n++) {
        double t = uniform(&seed, -3, 3), r = pow(10, uniform(&seed, -10, 10));

        if (n % 2)
            r = 1 + pow(10, uniform(&seed, -16, -1));
        assert_near(angle_of(r * cos(t), r * sin(t)), t, 1e-15 + 4e-16 / r);
    }
    assert_true(isnan(angle_of(NAN, 0.5)) && isnan(angle_of(0.5, NAN)));
    assert_near(angle_of(INFINITY, 1), 0, 0);
    assert_near(angle_of(1, -INFINITY), -PI / 2, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_unit_vectors),
        cmocka_unit_test(test_steps),
        cmocka_unit_test(test_axes),
        cmocka_unit_test(test_other_vectors),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
