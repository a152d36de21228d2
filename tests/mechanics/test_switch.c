/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_switch.c - levels that a variable passes: against counting them one by one.
*/
#include "check.h"
#include "mechanics/switch.h"
#include "read.h"

/* All levels that lie between two values, of an angle those of many periods, by trying each. */
static size_t count(const flk_switch *s, double from, double to, double *nearest)
{
    size_t n = 0, i;
    int turn;

    *nearest = NAN;
    for (turn = -6; turn <= 6; turn++)
        for (i = 0; i < s->n; i++) {
            double level = s->level[i] + (s->period > 0 ? turn * s->period : 0);

            if (s->period <= 0 && turn != 0)
                continue;
            if ((from < level) == (to < level))
                continue;
            n++;
            if (!(fabs(level - from) >= fabs(*nearest - from)))
                *nearest = level;
        }
    return n;
}

static void check_switch(double period, const double *level, size_t n)
{
    uint64_t seed = 3;
    flk_switch s;
    int k;

    memset(&s, 0, sizeof s);
    s.of = FLK_THETA4;
    s.period = period;
    s.level = level;
    s.n = n;
    for (k = 0; k < 2000; k++) {
        double from = uniform(&seed, -20, 20), to = from + uniform(&seed, -3, 3), nearest,
               first = 0;
        int step = 0;
        size_t passes = flk_switch_passes(&s, from, to, &first, &step), i;

        assert_int_equal(passes, count(&s, from, to, &nearest));
        assert_int_equal(passes > 0 ? step : 1, passes > 0 ? (to > from ? 1 : -1) : 1);
        for (i = 0; i < passes; i++, first += step) {
            double value = flk_switch_level(&s, first);

            assert_true((from < value) != (to < value));
            if (i == 0)
                assert_near(value, nearest, 1e-12);
        }
    }
}

TEST(test_passes)
{
    static const double few[] = {-1.2, 0.3, 4.1}, one[] = {0.25},
                        open[] = {-9, -3, -2.5, 0, 1, 6.5};

    check_switch(2 * M_PI, few, 3);
    check_switch(4 * M_PI, few, 3);
    check_switch(2 * M_PI, one, 1);
    check_switch(0, open, 6);
    check_switch(0, one, 1);
}

/* A speed is zero at the same crank angles whatever that of the crank; it has another value elsewhere. */
TEST(test_of_position)
{
    static const double some = 0.3, two[] = {0, 1};
    flk_switch s;

    flk_switch_at_zero(FLK_OMEGA4, &s);
    assert_true(flk_switch_is_of_position(&s));
    s.level = &some;
    assert_false(flk_switch_is_of_position(&s));
    s.of = FLK_SLIDE;
    assert_true(flk_switch_is_of_position(&s));
    flk_switch_at_zero(FLK_V, &s);
    s.level = two;
    s.n = 2;
    assert_false(flk_switch_is_of_position(&s));
    s.joint = 2;
    assert_true(flk_switch_is_of_position(&s));
}

/* The joints whose friction changes its sense: the pin A turns with the crank, and the guide is D. */
TEST(test_joints)
{
    static const char *const pins[] = {"A = 0.1\nradius_A = 9 mm\n", "B = 0.1\nradius_B = 9 mm\n",
                                       "C = 0.1\nradius_C = 9 mm\n", "guide = 0.1\n"};
    int joint, i;

    for (joint = 0; joint < 4; joint++) {
        char contents[1000];
        flk_switch list[4];
        size_t n;
        deck d;

        sprintf(contents,
                "mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 "
                "mm\n[friction]\n%s",
                pins[joint]);
        read_deck(contents, &d);
        n = flk_switch_list(&d.machine, NULL);
        assert_int_equal(n, joint > 0);
        assert_int_equal(flk_switch_list(&d.machine, list), n);
        for (i = 0; i < (int)n; i++) {
            assert_int_equal(list[i].joint, joint);
            assert_near(list[i].level[0], 0, 0);
        }
        flk_deck_free(&d);
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
