/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_cycle.c - whole cycles and places within one, against exact remainders.
*/
#include <float.h>

#include "check.h"

#include "base/cycle.h"

/* A cycle of some size, of either sign; every fourth is a turn in rad or in degrees. */
static double some_cycle(uint64_t *seed, int i)
{
    double size = i % 4 == 0 ? 2 * PI : i % 4 == 1 ? 360 : pow(10, uniform(seed, -3, 4));

    return uniform(seed, 0, 1) < 0.3 ? -size : size;
}

/* How much of x is left after whole cycles, by fmod, which is exact; from -1/2 to 1/2 of the cycle. */
static double left_of(double x, double cycle)
{
    double left = fmod(x, cycle), size = fabs(cycle);

    return left > size / 2 ? left - size : left < -size / 2 ? left + size : left;
}

TEST(test_places)
{
    uint64_t seed = 12;
    int i;

    for (i = 0; i < 20000; i++) {
        double cycle = some_cycle(&seed, i), from = fabs(cycle) * uniform(&seed, -3, 3);
        double x = from + fabs(cycle) * uniform(&seed, -100, 100);
        double place = flk_cycle_place(x, from, cycle), passed = (place - from) / cycle;
        double count = flk_cycle_count(x - from, cycle);

        assert_true(passed >= 0 && passed < 1);
        assert_true(count == floor(count));
        assert_near(left_of(x - place, cycle), 0, 1e-13 * fabs(cycle));
        assert_near(x - count * cycle, place, 1e-13 * fabs(cycle));
        assert_near(flk_cycle_beside(x, cycle), left_of(x, cycle), 1e-13 * fabs(cycle));
        assert_near(flk_cycle_nearest(x, cycle) * cycle, x - left_of(x, cycle), 1e-13 * fabs(x));
    }
}

/* Whole cycles from the beginning are at the beginning, though rounding puts many of them just before the end
** of a cycle. */
TEST(test_whole_cycles)
{
    uint64_t seed = 13;
    int i, before = 0;

    for (i = 0; i < 20000; i++) {
        double cycle = some_cycle(&seed, i), from = fabs(cycle) * uniform(&seed, -3, 3);
        int n = (int)uniform(&seed, 0, i % 10 ? 10 : 1e6);
        double x = from + n * cycle, place = flk_cycle_place(x, from, cycle);

        before += (x - from) / cycle < n;
        assert_true(flk_cycle_count(x - from, cycle) == n);
        assert_near(place, from, 4 * DBL_EPSILON * (fabs(from) + n * fabs(cycle)));
        assert_true((place - from) / cycle >= 0);
    }
    assert_true(before > 1000); /* so many would be a cycle too low */
    assert_true(isnan(flk_cycle_place(NAN, 0, 1)));
}

int main(void)
{
    return run_all_tests(NULL);
}
