/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_without_deck.c - extremes for hosts with structures only, against rows of fourlink_analyse and
** against decks.
*/
#include "machines.h"

#define DENSE 20000

static fourlink_motion one_turn(double speed)
{
    fourlink_motion motion = {0};

    motion.angle_unit = PI / 180;
    motion.to = 360;
    motion.interval = 360;
    motion.speed = speed;
    return motion;
}

/* The design of each kind, with masses from fourlink_uniform_bar, and a load on its follower. */
static fourlink_design design_of(int kind, fourlink_load *load)
{
    fourlink_design d = {0};

    memset(load, 0, sizeof *load);
    d.kind = (fourlink_kind)kind;
    d.gravity.y = -9.81;
    load->link = FOURLINK_FOLLOWER;
    assert_int_equal(fourlink_uniform_bar(0.1, 0.5, &d.link[2]), FOURLINK_OK);
    if (kind == FOURLINK_FOUR_BAR) {
        d.link[1].length = 0.4;
        assert_int_equal(fourlink_uniform_bar(0.35, 1.2, &d.link[3]), FOURLINK_OK);
        assert_int_equal(fourlink_uniform_bar(0.3, 1, &d.link[4]), FOURLINK_OK);
        load->torque = 4;
    } else if (kind == FOURLINK_SLIDER_CRANK) {
        assert_int_equal(fourlink_uniform_bar(0.35, 1.2, &d.link[3]), FOURLINK_OK);
        d.offset = 0.02;
        d.link[4].mass = 2;
        load->force.x = -50;
    } else {
        d.link[1].length = 0.25;
        d.link[3].mass = 0.3;
        d.link[4].mass = 2;
        d.link[4].inertia = 0.05;
        d.link[4].cg.x = 0.2;
        load->at.x = 0.4;
        load->force.x = -30;
    }
    return d;
}

static double quantity_of(const fourlink_state *s, const fourlink_forces *f, int which)
{
    return which == 0   ? f->Ts
           : which == 1 ? s->link[4].alpha
           : which == 2 ? hypot(f->F12x, f->F12y)
                        : s->link[3].omega;
}

/* The value is that of the row at its angle, and no row of a fine scan exceeds it. */
static void check_extreme(const fourlink_mechanism *m, fourlink_branch branch,
                          const fourlink_load *load, int which, int least, double best)
{
    static const char *const names[][4] = {{"max(Ts)", "max(alpha4)", "max(F12)", "max(omega3)"},
                                           {"min(Ts)", "min(alpha4)", "min(F12)", "min(omega3)"}};
    fourlink_motion motion = one_turn(12);
    fourlink_crank crank = {0, 12, 0};
    fourlink_state state;
    fourlink_forces forces;
    double value, angle, sign = least ? -1 : 1;

    assert_int_equal(
        fourlink_extreme(m, &motion, load, 1, branch, names[least][which], &value, &angle),
        FOURLINK_OK);
    assert_true(sign * value >= sign * best - 1e-12 * fabs(best));
    assert_true(sign * value <= sign * best + 1e-5 * fabs(best));
    crank.theta2 = angle * PI / 180;
    fourlink_analyse(m, branch, &crank, load, 1, &state, &forces);
    assert_close(quantity_of(&state, &forces, which), value, 1e-9);
}

TEST(test_against_rows)
{
    static const int kinds[] = {FOURLINK_FOUR_BAR, FOURLINK_SLIDER_CRANK,
                                FOURLINK_INVERTED_SLIDER_CRANK};
    size_t k, b;
    int which, i;

    for (k = 0; k < COUNT(kinds); k++)
        for (b = 0; b < 2; b++) {
            fourlink_mechanism m;
            fourlink_load load;
            fourlink_design d = design_of(kinds[k], &load);
            fourlink_crank crank = {0, 12, 0};
            double low[4] = {INFINITY, INFINITY, INFINITY, INFINITY};
            double high[4] = {-INFINITY, -INFINITY, -INFINITY, -INFINITY};

            assert_int_equal(fourlink_prepare(&d, &m), FOURLINK_OK);
            for (i = 0; i < DENSE; i++) {
                fourlink_state state;
                fourlink_forces forces;

                crank.theta2 = 2 * PI * i / DENSE;
                assert_int_equal(
                    fourlink_analyse(&m, branches[b], &crank, &load, 1, &state, &forces),
                    FOURLINK_OK);
                for (which = 0; which < 4; which++) {
                    low[which] = fmin(low[which], quantity_of(&state, &forces, which));
                    high[which] = fmax(high[which], quantity_of(&state, &forces, which));
                }
            }
            for (which = 0; which < 4; which++) {
                if (kinds[k] == FOURLINK_SLIDER_CRANK && which == 1)
                    continue; /* its piston does not turn */
                check_extreme(&m, branches[b], &load, which, 0, high[which]);
                check_extreme(&m, branches[b], &load, which, 1, low[which]);
            }
        }
}

/* The same numbers as the deck that says the same, a run-up and a part of a revolution in radians too; of a drag link, whose
** angles go beyond a turn, as well. */
TEST(test_against_a_deck)
{
    static const char *const motions[] = {"speed = 12 rad/s\n",
                                          "acceleration = 9 rad/s2\nrun_up = 300 deg\n",
                                          "speed = -5 rad/s\nfrom = 0.5 rad\nto = -2.5 rad\n"};
    static const double lengths[][4] = {{0.1, 0.35, 0.3, 0.4}, {0.3, 0.35, 0.4, 0.1}};
    size_t i, k;
    unsigned long n;
    int statistic;

    for (i = 0; i < 2 * COUNT(motions); i++) {
        const double *l = lengths[i % 2];
        fourlink_results *r =
            opened(four_bar(l[0], l[1], l[2], l[3],
                            print("[load]\nlink = rocker\ntorque = 4 N m\n[units]\nangle = %s\n"
                                  "[motion]\n%sinterval = 0.1 rad\n[table]\ncolumns = all\n",
                                  i % 3 ? "rad" : "deg", motions[i / 2])));
        fourlink_problem p = problem_of(r);
        fourlink_load load = {0};
        const fourlink_value *list;

        load.link = FOURLINK_FOLLOWER;
        load.torque = 4;
        fourlink_results_list(r, FOURLINK_COLUMNS, &list, &n);
        for (k = 0; k < n; k++)
            for (statistic = FOURLINK_MAX; statistic <= FOURLINK_MIN; statistic++) {
                const char *name =
                    print("%s(%s)", statistic == FOURLINK_MAX ? "max" : "min", list[k].name);
                double value = 0, angle = 0;
                fourlink_value v;
                int of_deck = fourlink_results_value(r, name, FOURLINK_OPEN, 0, &v);
                int of_structures = fourlink_extreme(&p.mechanism, &p.motion, &load, 1,
                                                     FOURLINK_OPEN, name, &value, &angle);

                assert_int_equal(of_deck, of_structures);
                if (of_deck != FOURLINK_OK)
                    continue;
                if (isinf(v.value))
                    assert_true(value == v.value && isnan(angle));
                else
                    assert_near(value, v.value * v.to_si, 1e-12 * fabs(v.value * v.to_si) + 1e-15);
            }
        fourlink_results_free(r);
    }
}

TEST(test_what_is_refused)
{
    fourlink_motion motion = one_turn(12), backwards = one_turn(12);
    fourlink_load load;
    fourlink_design d = design_of(FOURLINK_FOUR_BAR, &load);
    fourlink_mechanism m, far;
    fourlink_link link = {0}, before = link;
    double value = 7, angle = 7;

    backwards.interval = -1;
    assert_int_equal(fourlink_prepare(&d, &m), FOURLINK_OK);
    d.link[1].length = 5;
    assert_int_equal(fourlink_prepare(&d, &far), FOURLINK_OK);
#define EXTREME(m, motion, load, n, branch, name, value, status) \
    assert_int_equal(fourlink_extreme(m, motion, load, n, branch, name, value, &angle), status)
    EXTREME(NULL, &motion, &load, 1, FOURLINK_OPEN, "max(Ts)", &value, FOURLINK_NULL);
    EXTREME(&m, NULL, &load, 1, FOURLINK_OPEN, "max(Ts)", &value, FOURLINK_NULL);
    EXTREME(&m, &motion, NULL, 1, FOURLINK_OPEN, "max(Ts)", &value, FOURLINK_NULL);
    EXTREME(&m, &motion, &load, 1, FOURLINK_OPEN, NULL, &value, FOURLINK_NULL);
    EXTREME(&m, &motion, &load, 1, FOURLINK_OPEN, "max(Ts)", NULL, FOURLINK_NULL);
    EXTREME(&m, &motion, &load, 1, (fourlink_branch)0, "max(Ts)", &value, FOURLINK_BAD_BRANCH);
    EXTREME(&m, &backwards, &load, 1, FOURLINK_OPEN, "max(Ts)", &value, FOURLINK_BAD_INTERVAL);
    EXTREME(&m, &motion, &load, 1, FOURLINK_OPEN, "Ts", &value, FOURLINK_NO_SUCH_NAME);
    EXTREME(&m, &motion, &load, 1, FOURLINK_OPEN, "mean(Ts)", &value, FOURLINK_NO_SUCH_NAME);
    EXTREME(&m, &motion, &load, 1, FOURLINK_OPEN, "max(x)", &value, FOURLINK_NO_SUCH_NAME);
    EXTREME(&far, &motion, &load, 1, FOURLINK_OPEN, "max(Ts)", &value, FOURLINK_NOT_REACHED);
    assert_true(value == 7 && angle == 7);
    EXTREME(&m, &motion, NULL, 0, FOURLINK_OPEN, "max(Ts)", &value, FOURLINK_OK);
    assert_int_equal(fourlink_uniform_bar(0.1, 1, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_uniform_bar(0, 1, &link), FOURLINK_BAD_LENGTH);
    assert_int_equal(fourlink_uniform_bar(0.1, -1, &link), FOURLINK_BAD_MASS);
    assert_int_equal(fourlink_uniform_bar(NAN, 1, &link), FOURLINK_BAD_NUMBER);
    assert_memory_equal(&link, &before, sizeof link);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
