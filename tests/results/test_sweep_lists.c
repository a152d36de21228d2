/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_sweep_lists.c - what a host sees of a sweep: neighbours of a design, conditions of the yield.
*/
#include "machines.h"

static char *linkage(const char *more)
{
    return four_bar(0.020, 0.066, 0.056, 0.080,
                    print("[load Tl]\nlink = rocker\ntorque = 3 N m\n[motion]\nspeed = 10 rad/s\n"
                          "interval = 40 deg\n%s",
                          more));
}

/* The neighbours on the grid: none beyond the ends of a range, in a list, or of a tolerance. */
TEST(test_neighbours)
{
    static const double expected[][3][2] = {{{18, 19}, {100, 100}, {56, 56}},
                                            {{18, 19}, {200, 200}, {56, 56}},
                                            {{18, 20}, {100, 100}, {56, 56}},
                                            {{18, 20}, {200, 200}, {56, 56}},
                                            {{19, 20}, {100, 100}, {56, 56}}};
    fourlink_source source =
        deck_source(linkage("[sweep]\ncrank.length = 18 mm to 20 mm step 1 mm\n"
                            "motion.speed = 100 rpm, 200 rpm\nrocker.length = 56 mm +- 1 mm\n"
                            "samples = 1\n[units]\nlength = mm\nangular_speed = rpm\n"));
    double low[3], high[3], values[3];
    size_t i, k;

    for (i = 0; i < COUNT(expected); i++) {
        source.design = (unsigned long)i;
        assert_int_equal(fourlink_source_neighbours(&source, 3, low, high), FOURLINK_OK);
        assert_int_equal(fourlink_source_design(&source, 3, values), FOURLINK_OK);
        for (k = 0; k < 2; k++)
            assert_true(low[k] == expected[i][k][0] && high[k] == expected[i][k][1]);
        assert_true(low[2] == values[2] && high[2] == values[2]);
    }
    high[1] = 5;
    assert_int_equal(fourlink_source_neighbours(&source, 1, low, high), FOURLINK_OK);
    assert_true(high[1] == 5);
}

/* The conditions of a yield: outputs with limits, in the deck's units. */
TEST(test_conditions)
{
    fourlink_results *r = opened(linkage("[sweep]\ncrank.length = 18 mm, 19 mm\noutput = swing\n"
                                         "yield = mu_min > 0.5 rad, swing <= 40\n"));
    const fourlink_value *list;
    unsigned long n;

    assert_true(problem_of(r).has_outputs && problem_of(r).has_statistics);
    assert_int_equal(fourlink_results_list(r, FOURLINK_OUTPUTS, &list, &n), FOURLINK_OK);
    assert_int_equal(n, 2);
    assert_string_equal(list[1].name, "mu_min");
    assert_int_equal(fourlink_results_list(r, FOURLINK_CONDITIONS, &list, &n), FOURLINK_OK);
    assert_int_equal(n, 2);
    assert_string_equal(list[0].name, "mu_min");
    assert_string_equal(list[0].unit, "deg");
    assert_string_equal(list[0].meaning, "mu_min > 0.5 rad");
    assert_close(list[0].value, 28.64788975654116, 1e-14);
    assert_int_equal(list[0].flags, FOURLINK_ABOVE);
    assert_string_equal(list[1].name, "swing");
    assert_true(list[1].value == 40);
    assert_int_equal(list[1].flags, FOURLINK_BELOW | FOURLINK_OR_EQUAL);
    fourlink_results_free(r);
}

int main(void)
{
    return run_all_tests(NULL);
}
