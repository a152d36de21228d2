/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_fact.c - what is said of a deck in single numbers.
*/
#include "machines.h"

TEST(test_facts_of_linkages)
{
    static fact_list list;
    /* crank and coupler in one line, stretched and folded: 86 and 46 mm in the triangle of 80 and 56 mm */
    double stretched = acos((80. * 80 + 86 * 86 - 56 * 56) / (2 * 80 * 86));
    double folded = PI + acos((80. * 80 + 46 * 46 - 56 * 56) / (2 * 80 * 46));
    double ratio = (folded - stretched) / (2 * PI - folded + stretched);
    const fourlink_value *f;

    facts_of(four_bar(0.020, 0.066, 0.056, 0.080, revolution(10.5)), &list);
    f = find_fact(&list, "type", FOURLINK_OPEN);
    assert_non_null(f);
    assert_string_equal(f->words, "crank-rocker");
    check_fact(&list, "K", FOURLINK_OPEN, 2790e-6, 1e-17);
    check_fact(&list, "theta2_from", FOURLINK_OPEN, 0, 0);
    check_fact(&list, "theta2_to", FOURLINK_OPEN, 360, 1e-13);
    check_fact(&list, "theta4_min", FOURLINK_OPEN, 180 - acos(2140. / 8960) / DEG, 1e-12);
    check_fact(&list, "theta4_max", FOURLINK_OPEN, 180 - acos(7420. / 8960) / DEG, 1e-12);
    check_fact(&list, "swing", FOURLINK_CROSSED, (acos(2140. / 8960) - acos(7420. / 8960)) / DEG,
               1e-12);
    check_fact(&list, "mu_min", FOURLINK_CROSSED, acos(3892. / 7392) / DEG, 1e-12);
    f = find_fact(&list, "theta4_min", FOURLINK_OPEN);
    assert_true(f->has_angle);
    assert_near(f->angle, acos(10660. / 13760) / DEG, 1e-12);
    f = find_fact(&list, "theta4_max", FOURLINK_CROSSED);
    assert_near(f->value, -180 + acos(2140. / 8960) / DEG, 1e-12);
    assert_near(f->angle, 360 - acos(10660. / 13760) / DEG, 1e-12);
    check_fact(&list, "time_ratio", FOURLINK_OPEN, ratio, 1e-12);
    check_fact(&list, "time_ratio", FOURLINK_CROSSED, ratio, 1e-12);
    assert_null(find_fact(&list, "stroke", FOURLINK_OPEN));
    assert_null(find_fact(&list, "n", FOURLINK_OPEN));
    assert_null(find_fact(&list, "mean_torque", FOURLINK_OPEN));
}

/* The angle between coupler and rocker, by the law of cosines from the distance BD; mu is its acute form. */
TEST(test_gamma)
{
    static const struct {
        double a, b, c, d, from;                 /* m, deg: a crank angle that can be reached */
    } cases[] = {{0.04, 0.1, 0.08, 0.09, 140},   /* crank-rocker */
                 {0.06, 0.06, 0.06, 0.04, 140},  /* double crank */
                 {0.05, 0.05, 0.05, 0.11, 10},   /* to 180 deg */
                 {0.03, 0.09, 0.04, 0.05, 140},  /* from 0 deg */
                 {0.04, 0.09, 0.04, 0.09, 140}}; /* parallelogram */
    static fact_list list;
    size_t i, k;

    for (i = 0; i < COUNT(cases); i++) {
        double a = cases[i].a, b = cases[i].b, c = cases[i].c, d = cases[i].d;
        double low = (b * b + c * c - (d - a) * (d - a)) / (2 * b * c);
        double high = (b * b + c * c - (d + a) * (d + a)) / (2 * b * c), theta2;
        const char *contents = four_bar(
            a, b, c, d,
            print("[motion]\nfrom = %g deg\nto = %g deg\n", cases[i].from, cases[i].from + 20));
        fourlink_results *r = opened(contents);

        facts_of(contents, &list);
        check_fact(&list, "gamma_min", FOURLINK_OPEN, acos(fmin(low, 1)) / DEG, 2e-6);
        check_fact(&list, "gamma_max", FOURLINK_CROSSED, acos(fmax(high, -1)) / DEG, 2e-6);
        for (theta2 = cases[i].from; theta2 <= cases[i].from + 20; theta2 += 10)
            for (k = 0; k < 2; k++) {
                double square = a * a + d * d - 2 * a * d * cos(theta2 * DEG);
                double gamma = acos((b * b + c * c - square) / (2 * b * c));

                assert_near(si_value(r, "gamma", branches[k], theta2), gamma, 1e-12);
                assert_near(si_value(r, "mu", branches[k], theta2), fmin(gamma, PI - gamma), 1e-12);
            }
        fourlink_results_free(r);
    }
    facts_of(four_bar(0.04, 0.1, 0.08, 0.09, ""), &list);
    check_fact(&list, "gamma_min", FOURLINK_OPEN, 29.6862952314, 1e-9);
    check_fact(&list, "gamma_max", FOURLINK_OPEN, 91.7907846593, 1e-9);
    check_fact(&list, "mu_max", FOURLINK_OPEN, 90, 1e-12);
}

/* The limits of link 4 where the crank does not turn fully, with A, B, C in one line: 300 + 400 mm from
** A to C in the triangle of 500 and 750 mm; in a crank-rocker a range above the ground and one below. */
TEST(test_reach_of_link_4)
{
    static fact_list list;
    double half = acos((0.25 + 0.5625 - 0.49) / (2 * 0.5 * 0.75)) / DEG;
    double from[2], to[2], low = 180 - acos(2140. / 8960) / DEG,
                           high = 180 - acos(7420. / 8960) / DEG;
    int n_from = 0, k, above;
    unsigned long i;

    facts_of(four_bar(0.3, 0.4, 0.5, 0.75, ""), &list);
    check_fact(&list, "theta4_from", FOURLINK_OPEN, 180 - half, 1e-12);
    check_fact(&list, "theta4_to", FOURLINK_OPEN, 180 + half, 1e-12);
    check_fact(&list, "theta4_swing", FOURLINK_OPEN, 2 * half, 1e-12);
    facts_of(four_bar(0.020, 0.066, 0.056, 0.080, ""), &list);
    for (k = 0; k < 2; k++) { /* they are not listed beside theta4_min and theta4_max, but known */
        assert_null(find_fact(&list, "theta4_from", branches[k]));
        from[k] = turned(si_value(list.results, "theta4_from", branches[k], 0) / DEG, 360);
        to[k] = turned(si_value(list.results, "theta4_to", branches[k], 0) / DEG, 360);
        assert_near(si_value(list.results, "theta4_swing", branches[k], 0) / DEG, high - low,
                    1e-11);
        /* a branch has its own range only */
        assert_near(from[k], turned(value_of(&list, "theta4_min", branches[k]), 360), 1e-11);
        assert_near(to[k], turned(value_of(&list, "theta4_max", branches[k]), 360), 1e-11);
    }
    above = from[0] > 0 ? 0 : 1;
    assert_near(from[above], low, 1e-11);
    assert_near(to[above], high, 1e-11);
    assert_near(from[1 - above], -high, 1e-11);
    assert_near(to[1 - above], -low, 1e-11);
    /* of a double rocker none does */
    facts_of(four_bar(0.066, 0.020, 0.056, 0.080, ""), &list);
    n_from = 0;
    for (i = 0; i < list.n; i++)
        if (strcmp(list.list[i].name, "theta4_from") == 0) {
            assert_int_equal(list.list[i].branch, 0);
            n_from++;
        }
    assert_int_equal(n_from, 2);
    assert_null(find_fact(&list, "time_ratio", FOURLINK_OPEN));
}

TEST(test_facts_of_engines)
{
    static fact_list list;
    const char *rod = "mechanism = slider-crank\n[units]\nlength = mm\n[crank]\nlength = 150\n"
                      "[rod]\nlength = 450\nmass = 2 kg\ngyration = 175\ncg = 150\n";
    double distance =
        175. * 175 / 300; /* k^2 / b, with b from the centre of mass to the gudgeon pin */
    const fourlink_value *f;

    facts_of(rod, &list);
    f = find_fact(&list, "type", FOURLINK_OPEN);
    assert_string_equal(f->words, "slider-crank, the crank turns fully");
    check_fact(&list, "n", FOURLINK_OPEN, 3, 1e-15);
    check_fact(&list, "k", FOURLINK_OPEN, 175, 1e-12);
    check_fact(&list, "m_a", FOURLINK_OPEN, 4. / 3, 1e-15);
    check_fact(&list, "m_b", FOURLINK_OPEN, 2. / 3, 1e-15);
    check_fact(&list, "k1", FOURLINK_OPEN, sqrt(300. * 150), 1e-12);
    check_fact(&list, "d", FOURLINK_OPEN, distance, 1e-12);
    check_fact(&list, "L", FOURLINK_OPEN, 300 + distance, 1e-12);
    check_fact(&list, "m_d", FOURLINK_OPEN, 2 * 300 / (300 + distance), 1e-14);
    check_fact(&list, "m_g", FOURLINK_OPEN, 2 * distance / (300 + distance), 1e-14);
    check_fact(&list, "stroke", FOURLINK_CROSSED, 300, 1e-12);
    check_fact(&list, "inner_dead_centre", FOURLINK_OPEN, 0, 0);
    check_fact(&list, "outer_dead_centre", FOURLINK_OPEN, 180, 1e-12);
    check_fact(&list, "inner_dead_centre", FOURLINK_CROSSED, 180, 1e-12);
    check_fact(&list, "mu_min", FOURLINK_OPEN, acos(1. / 3) / DEG, 1e-12);
    assert_null(find_fact(&list, "K", FOURLINK_OPEN));
    assert_null(find_fact(&list, "swing", FOURLINK_OPEN));

    /* in another unit of angle, on one branch */
    facts_of("mechanism = slider-crank\n[units]\nangle = rev\n[crank]\nlength = 0.15\n[rod]\n"
             "length = 0.45\n[table]\nbranch = crossed\n",
             &list);
    check_fact(&list, "theta2_to", FOURLINK_OPEN, 1, 1e-15);
    check_fact(&list, "inner_dead_centre", FOURLINK_CROSSED, 0.5, 1e-15);
    assert_null(find_fact(&list, "inner_dead_centre", FOURLINK_OPEN));
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
