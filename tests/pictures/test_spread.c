/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_spread.c - extremes, quartiles and medians of groups of designs, against counting.
*/
#include <math.h>

#include "chance.h"
#include "check.h"
#include "pictures/spread.h"

#define MOST 3000

static spread_point designs[MOST];
static double xs[MOST], ys[MOST];

/* Of n values from `from` in the order of x, no more than that part may be below the size, or above it. */
static void check_group(const spread_group *g, size_t n, double low, double high)
{
    size_t i, k, in = 0;

    for (i = 0; i < n; i++)
        in += xs[i] >= low && xs[i] <= high;
    for (k = 0; k < SPREAD_SIZES; k++) {
        double part = (double)k / (SPREAD_SIZES - 1);
        size_t below = 0, above = 0;

        for (i = 0; i < n; i++)
            if (xs[i] >= low && xs[i] <= high) {
                below += ys[i] < g->y[k] - 1e-12;
                above += ys[i] > g->y[k] + 1e-12;
            }
        assert_true((double)below <= part * (double)(in - 1) + 1);
        assert_true((double)above <= (1 - part) * (double)(in - 1) + 1);
    }
}

static void draw(size_t n, size_t places)
{
    size_t i;

    for (i = 0; i < n; i++) {
        xs[i] = designs[i].x = places ? (double)one_of((int)places) : between(0, 1);
        ys[i] = designs[i].y = between(-5, 5);
    }
}

TEST(test_same_places)
{
    spread_group groups[SPREAD_MOST];
    size_t n, i;
    int k;

    for (k = 0; k < 200; k++) {
        begin_chance(1, k);
        draw(n = (size_t)(401 + one_of(MOST - 401)), seldom(0.1) ? 1 : 1 + (size_t)one_of(100));
        i = spread_find(designs, n, groups);
        assert_true(i >= 1 && i <= 100);
        while (i-- > 0)
            check_group(&groups[i], n, groups[i].x, groups[i].x);
    }
}

TEST(test_neighbours)
{
    spread_group groups[SPREAD_MOST];
    size_t n, i, k;

    for (k = 0; k < 50; k++) {
        begin_chance(2, (long)k);
        draw(n = (size_t)(401 + one_of(MOST - 401)), 0);
        assert_int_equal(spread_find(designs, n, groups), 40);
        for (i = 0; i < 40; i++) {
            size_t first = n * i / 40, last = n * (i + 1) / 40 - 1;
            double low = 1, high = 0;
            size_t j;

            for (j = first; j <= last; j++) { /* sorted by y within the group */
                low = fmin(low, designs[j].x);
                high = fmax(high, designs[j].x);
            }
            assert_true(groups[i].x >= low && groups[i].x <= high);
            assert_true(i == 0 || groups[i].x > groups[i - 1].x);
            check_group(&groups[i], n, low, high);
        }
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
