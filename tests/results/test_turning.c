/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_turning.c - the turning moment and the flywheel: energies that a machine must give back, and areas
** in closed form.
*/
#include "machines.h"

static const char still[] = "[gravity]\nacceleration = 0\n";

/* A piston alone takes up and gives back its kinetic energy. */
TEST(test_energy_of_a_piston)
{
    static fact_list list;
    uint64_t seed = 7;
    int i, k;

    for (i = 0; i < 12; i++) {
        own o = random_engine(&seed, i % 2);
        double m = uniform(&seed, 1, 50), omega = (double)o.speed;

        facts_of(
            slider_crank((double)o.a, (double)o.b, (double)o.d,
                         print("%s%s[piston]\nmass = %.17g kg\n", revolution(omega), still, m)),
            &list);
        for (k = 0; k < 2; k++) {
            peaks fast = {0};
            double v;

            o.branch = (int)branches[k];
            scan(own_v, &o, 1, 0, 2 * PIL, &fast);
            v = (double)fast.value;
            memset(&fast, 0, sizeof fast);
            scan(own_v, &o, -1, 0, 2 * PIL, &fast);
            v = fmax(v, fabs((double)fast.value));
            check_fact(&list, "energy_fluctuation", branches[k], m * v * v / 2, 1e-9 * m * v * v);
            check_fact(&list, "mean_torque", branches[k], 0, 0);
            check_fact(&list, "mean_power", branches[k], 0, 0);
            assert_null(find_fact(&list, "energy_coefficient", branches[k]));
            assert_null(find_fact(&list, "flywheel_inertia", branches[k]));
            assert_null(find_fact(&list, "flywheel_fluctuation", branches[k]));
        }
    }
}

/* pA x less the kinetic energy. */
static long double own_energy(const own *o, long double t)
{
    long double v = own_v(o, t);

    return o->gas * own_x(o, t) - o->mass * v * v / 2;
}

TEST(test_energy_of_gas_and_piston)
{
    static fact_list list;
    uint64_t seed = 8;
    int i, k;

    for (i = 0; i < 12; i++) {
        own o = random_engine(&seed, i % 2);
        double bore = uniform(&seed, 0.02, 0.2), p = uniform(&seed, -1e5, 1e6);

        o.mass = i % 3 ? uniform(&seed, 1, 50) : 0;
        o.gas = PIL / 4 * bore * bore * p;
        facts_of(slider_crank((double)o.a, (double)o.b, (double)o.d,
                              print("%s%s[piston]\nmass = %.17g kg\n[gas]\nbore = %.17g m\n"
                                    "pressure = %.17g Pa\n[table]\nbranch = both\n",
                                    revolution((double)o.speed), still, (double)o.mass, bore, p)),
                 &list);
        for (k = 0; k < 2; k++) {
            peaks max = {0}, min = {0};
            double dE;

            o.branch = (int)branches[k];
            scan(own_energy, &o, 1, 0, 2 * PIL, &max);
            scan(own_energy, &o, -1, 0, 2 * PIL, &min);
            dE = (double)(max.value - min.value);
            check_fact(&list, "energy_fluctuation", branches[k], dE, 1e-9 * dE);
            check_fact(&list, "mean_torque", branches[k], 0, 0);
            assert_null(find_fact(&list, "energy_coefficient", branches[k]));
        }
    }
}

/* Weights, with all inertia: conservative, so that the mean is 0 as well. */
TEST(test_mean_torque_of_conservative_machines)
{
    static fact_list list;
    uint64_t seed = 9;
    int i, k;

    for (i = 0; i < 8; i++) {
        own o = i % 2 ? random_engine(&seed, 1) : random_rocker(&seed);

        if (i % 2)
            facts_of(print("mechanism = slider-crank\n[crank]\nlength = %.17g m\nmass = 2 kg\n"
                           "cg = 50 mm\n[rod]\nlength = %.17g m\nmass = 3 kg\ninertia = 0.1 kg m2\n"
                           "cg = 100 mm at 20 deg\n[piston]\nmass = 7 kg\n[ground]\n"
                           "offset = %.17g m\nangle = 50 deg\n%s",
                           (double)o.a, (double)o.b, (double)o.d, revolution((double)o.speed)),
                     &list);
        else
            facts_of(
                print("mechanism = four-bar\n[crank]\nlength = %.17g m\nmass = 2 kg\n"
                      "cg = 50 mm\n[coupler]\nlength = %.17g m\nmass = 3 kg\n"
                      "inertia = 0.1 kg m2\ncg = 100 mm at 20 deg\n[rocker]\nlength = %.17g m\n"
                      "mass = 1 kg\ngyration = 90 mm\n[ground]\nlength = %.17g m\n%s",
                      (double)o.a, (double)o.b, (double)o.c, (double)o.d,
                      revolution((double)o.speed)),
                &list);
        for (k = 0; k < 2; k++) {
            check_fact(&list, "mean_torque", branches[k], 0, 0);
            assert_null(find_fact(&list, "energy_coefficient", branches[k]));
            assert_true(value_of(&list, "energy_fluctuation", branches[k]) > 1e-3);
        }
    }
}

/* A constant torque on the rocker of a massless crank-rocker does its work over the swing; a constant
** force on a piston over the stroke. */
TEST(test_energy_is_force_times_way)
{
    static fact_list list;
    uint64_t seed = 10;
    int i, k;

    for (i = 0; i < 8; i++) {
        own o = random_rocker(&seed);

        facts_of(four_bar((double)o.a, (double)o.b, (double)o.c, (double)o.d,
                          print("%s[load]\nlink = rocker\ntorque = -7 N m\n",
                                revolution((double)o.speed))),
                 &list);
        for (k = 0; k < 2; k++) {
            double swing = value_of(&list, "swing", branches[k]) * DEG;

            check_fact(&list, "energy_fluctuation", branches[k], 7 * swing, 1e-9 * 7);
            check_fact(&list, "mean_torque", branches[k], 0, 0);
        }
        o = random_engine(&seed, 1);
        facts_of(slider_crank((double)o.a, (double)o.b, (double)o.d,
                              print("%s[load]\nlink = piston\nforce = (300, 70) N\n",
                                    revolution((double)o.speed))),
                 &list);
        for (k = 0; k < 2; k++) {
            double stroke = value_of(&list, "stroke", branches[k]);

            check_fact(&list, "energy_fluctuation", branches[k], 300 * stroke, 1e-9 * 300 * stroke);
            check_fact(&list, "mean_torque", branches[k], 0, 0);
        }
    }
}

/* A drag link under a constant torque M on link 4, which turns once with the crank: the mean of the
** turning moment is M, the energy M times the lead of link 4 over the crank. */
TEST(test_energy_of_a_drag_link)
{
    static fact_list list;
    own o = {0.50L, 0.45L, 0.60L, 0.20L, 1, 0, 1, 0, 0, 0};
    int i, k;

    facts_of(four_bar(0.50, 0.45, 0.60, 0.20,
                      print("%s[load]\nlink = rocker\ntorque = 5 N m\n", revolution(4))),
             &list);
    for (k = 0; k < 2; k++) {
        long double lead, least = 0, most = 0, before = 0, first = 0;

        o.branch = (int)branches[k];
        for (i = 0; i <= 40000; i++) {
            long double t = 2 * PIL * i / 40000;

            lead = own_angles(&o, t).t4 - t;
            if (i)
                lead -= 2 * PIL * floorl((lead - before) / (2 * PIL) + 0.5L);
            else
                first = least = most = lead;
            before = lead;
            least = lead < least ? lead : least;
            most = lead > most ? lead : most;
        }
        assert_near((double)(before - first), 0, 1e-12);
        check_fact(&list, "mean_torque", branches[k], 5, 5e-10);
        check_fact(&list, "mean_power", branches[k], 20, 2e-9);
        check_fact(&list, "energy_fluctuation", branches[k], 5 * (double)(most - least), 1e-7);
        check_fact(&list, "energy_coefficient", branches[k], (double)(most - least) / (2 * PI),
                   1e-8);
    }
}

/* A torque given as a curve on a massless mechanism is the turning moment. */
static char *with_curve(const char *torque, const char *more)
{
    return four_bar(0.020, 0.066, 0.056, 0.080,
                    print("[load]\nlink = crank\ntorque = %s\n%s", torque, more));
}

/* 100 N m for a quarter, 300 N m for a quarter, and two rises between them: a smooth curve that does not
** overshoot is level on the levels, so that the rises are cubics, 100 + 200 (3 t^2 - 2 t^3), that cross
** the mean of 200 half way.  Above it are 31.25 + 100 + 31.25 N m, times a quarter turn. */
TEST(test_turning_moment_in_closed_form)
{
    static fact_list list;
    double dE = 162.5 * PI / 2;
    int k;

    facts_of(with_curve("0 deg 100, 90 deg 100, 180 deg 300, 270 deg 300",
                        "[motion]\nspeed = 20 rad/s\ninterval = 40 deg\n"),
             &list);
    for (k = 0; k < 2; k++) {
        check_fact(&list, "mean_torque", branches[k], 200, 2e-7);
        check_fact(&list, "mean_power", branches[k], 4000, 4e-6);
        check_fact(&list, "energy_fluctuation", branches[k], dE, 1e-9 * dE);
        check_fact(&list, "energy_coefficient", branches[k], dE / (400 * PI), 1e-9);
    }
    /* backwards, against the torque: the same energies, the power taken up */
    facts_of(with_curve("0 deg 100, 90 deg 100, 180 deg 300, 270 deg 300",
                        "[motion]\nspeed = -20 rad/s\n[units]\nenergy = kJ\ntorque = kN m\n"
                        "power = kW\n"),
             &list);
    /* bare numbers are in kN m now */
    for (k = 0; k < 2; k++) {
        check_fact(&list, "mean_torque", branches[k], 200, 2e-7);
        check_fact(&list, "mean_power", branches[k], -4000, 4e-6);
        check_fact(&list, "energy_fluctuation", branches[k], dE, 1e-9 * dE);
        check_fact(&list, "energy_coefficient", branches[k], dE / (400 * PI), 1e-9);
    }
    /* negative: it is a resistance */
    facts_of(with_curve("0 deg -100, 90 deg -100, 180 deg -300, 270 deg -300",
                        "[motion]\nspeed = 20 rad/s\n"),
             &list);
    check_fact(&list, "mean_torque", FOURLINK_OPEN, -200, 2e-7);
    check_fact(&list, "mean_power", FOURLINK_OPEN, -4000, 4e-6);
    check_fact(&list, "energy_fluctuation", FOURLINK_OPEN, dE, 1e-9 * dE);
    check_fact(&list, "energy_coefficient", FOURLINK_OPEN, dE / (400 * PI), 1e-9);
}

static double torque_at(const fourlink_results *r, double theta2)
{
    fourlink_load load;

    assert_int_equal(
        fourlink_deck_loads(fourlink_results_deck(r), FOURLINK_OPEN, theta2, &load, NULL),
        FOURLINK_OK);
    return load.torque;
}

/* A four-stroke engine's curve, over 720 deg: the mean, and the energy between the crossings of the
** mean, by Gauss's rule of three points, exact for the cubics between the points. */
TEST(test_turning_moment_of_four_strokes)
{
    static const double angle[] = {0,   20,  60,  110, 170, 200, 270, 340, 380, 395,
                                   420, 480, 540, 560, 600, 640, 660, 690, 705},
                        torque[] = {0,   -30, -80, -60, -20, 10, -150, -420, 100, 900,
                                    700, 300, 40,  0,   -40, 60, 200,  20,   -10};
    enum { POINTS = 19, CUTS = 400 };
    static fact_list list;
    char points[1000] = "", *contents;
    double area = 0, E = 0, least = 0, most = 0, mean, dE;
    int i, j, k, pass;
    fourlink_results *r;

    for (i = 0; i < POINTS; i++)
        sprintf(points + strlen(points), "%s%g deg %g N m", i ? ", " : "", angle[i], torque[i]);
    contents = with_curve(points, "[motion]\nspeed = 30 rad/s\ncycle = 720 deg\n[flywheel]\n"
                                  "fluctuation = 0.02\n");
    r = opened(contents);
    mean = 0;
    for (pass = 0; pass < 2; pass++) {
        double w = sqrt(0.6);

        for (i = 0; i < POINTS; i++)
            for (j = 0; j < CUTS; j++) {
                double next = i + 1 < POINTS ? angle[i + 1] : 720,
                       h = (next - angle[i]) * DEG / CUTS, x = angle[i] * DEG + (j + 0.5) * h;
                double sum = (5 * torque_at(r, x - w * h / 2) + 8 * torque_at(r, x) +
                              5 * torque_at(r, x + w * h / 2)) /
                             18 * h;
                double left = torque_at(r, x - h / 2) - mean,
                       right = torque_at(r, x + h / 2) - mean;

                if (!pass) {
                    area += sum;
                    continue;
                }
                if (left * right < 0) { /* a straight line will do within so short a piece */
                    double peak = E + left * h * left / (left - right) / 2;

                    least = fmin(least, peak);
                    most = fmax(most, peak);
                }
                E += sum - mean * h;
                least = fmin(least, E);
                most = fmax(most, E);
            }
        mean = area / (4 * PI);
    }
    assert_near(E, 0, 1e-9);
    fourlink_results_free(r);
    dE = most - least;
    facts_of(contents, &list);
    for (k = 0; k < 2; k++) {
        check_fact(&list, "mean_torque", branches[k], mean, 1e-9 * fabs(mean));
        check_fact(&list, "mean_power", branches[k], 30 * mean, 3e-8 * fabs(mean));
        check_fact(&list, "energy_fluctuation", branches[k], dE, 1e-6 * dE);
        check_fact(&list, "energy_coefficient", branches[k], dE / (4 * PI * mean),
                   1e-6 * dE / mean);
        check_fact(&list, "flywheel_inertia", branches[k], dE / (0.02 * 900), 1e-6 * dE);
    }
}

/* A cycle of two revolutions in which all repeats after one: the same fluctuation, over twice the
** work. */
TEST(test_cycle_of_two_revolutions)
{
    static fact_list once, twice;
    const char *masses = "[load]\nlink = crank\ntorque = 50 N m\n[piston]\nmass = 5 kg\n[motion]\n"
                         "speed = 30 rad/s\n";

    facts_of(slider_crank(0.15, 0.45, 0, masses), &once);
    facts_of(slider_crank(0.15, 0.45, 0, print("%scycle = 720 deg\n", masses)), &twice);
    check_fact(&once, "mean_torque", FOURLINK_OPEN, 50, 5e-8);
    check_fact(&twice, "mean_torque", FOURLINK_OPEN, 50, 5e-8);
    check_fact(&twice, "energy_fluctuation", FOURLINK_OPEN,
               value_of(&once, "energy_fluctuation", FOURLINK_OPEN), 1e-7);
    check_fact(&twice, "energy_coefficient", FOURLINK_OPEN,
               value_of(&once, "energy_coefficient", FOURLINK_OPEN) / 2, 1e-10);
}

/* A torque between two crank angles, the oldest exercise: M from .. to gives the mean M w / c, and the
** area above it (M - mean) w. */
TEST(test_turning_moment_in_steps)
{
    static const double windows[][3] = {{0, 90, 360},  {10.3, 100.7, 360}, {350, 370, 360},
                                        {0, 180, 720}, {33.33, 35.9, 360}, {700, 719.5, 720},
                                        {90, 360, 360}};
    static fact_list list;
    int i;

    for (i = 0; i < 7; i++) {
        double from = windows[i][0], to = windows[i][1], cycle = windows[i][2],
               w = (to - from) * DEG, mean = 80 * (to - from) / cycle, dE = (80 - mean) * w;

        facts_of(
            four_bar(0.020, 0.066, 0.056, 0.080,
                     print("[load]\nlink = crank\ntorque = 80 N m\nfrom = %g deg\nto = %g deg\n"
                           "[motion]\nspeed = 10 rad/s\ncycle = %g deg\n",
                           from, to, cycle)),
            &list);
        check_fact(&list, "mean_torque", FOURLINK_OPEN, mean, 1e-11 * 80);
        check_fact(&list, "energy_fluctuation", FOURLINK_OPEN, dE, 1e-9 * dE);
        check_fact(&list, "energy_coefficient", FOURLINK_OPEN, 1 - mean / 80, 1e-8);
    }
}

/* A peak of Hermite cubics with level ends, of mean height 1/2. */
static void check_peak(double width)
{
    static fact_list list;
    double mean = 900 * width / 2 / 360;

    facts_of(with_curve(print("0 deg 0, %.17g deg 0, 100.1 deg 900, %.17g deg 0", 100.1 - width / 2,
                              100.1 + width / 2),
                        "[motion]\nspeed = 20 rad/s\n"),
             &list);
    check_fact(&list, "mean_torque", FOURLINK_OPEN, mean, 1e-9 * mean);
}

TEST(test_turning_moment_of_a_peak)
{
    check_peak(30);
    check_peak(3);
}

/* What comes and goes within a degree: the mean, and the energy M w of a step. */
TEST(test_turning_moment_within_a_degree)
{
    check_peak(0.5);
}

TEST(test_step_within_a_degree)
{
    static fact_list list;
    double w = 0.7 * DEG, mean = 80 * 0.7 / 360;

    facts_of(four_bar(0.020, 0.066, 0.056, 0.080,
                      "[load]\nlink = crank\ntorque = 80 N m\nfrom = 0.2 deg\nto = 0.9 deg\n"
                      "[motion]\nspeed = 10 rad/s\n"),
             &list);
    check_fact(&list, "mean_torque", FOURLINK_OPEN, mean, 1e-11 * 80);
    check_fact(&list, "energy_fluctuation", FOURLINK_OPEN, (80 - mean) * w, 1e-9 * 80 * w);
}

/* What the flywheel takes up while the crank passes an area, in time: the power above its mean. */
static void check_areas(const char *contents, int at_least)
{
    const int steps = tries_all() ? 20000 : 4000;
    fourlink_results *r = opened(contents);
    fourlink_problem p = problem_of(r);
    fourlink_turning t;
    int k, i, b;

    for (b = 0; b < 2; b++) {
        double end = 0, least = HUGE_VAL;

        assert_int_equal(fourlink_results_turning(r, branches[b], &t), FOURLINK_OK);
        assert_true(t.n_areas >= at_least);
        for (k = 0; k < t.n_areas; k++) {
            double width = t.area[k].to - t.area[k].from, speed = p.motion.speed, gain = 0;

            assert_true(t.area[k].from == end && width > 0);
            end = t.area[k].to;
            for (i = 0; i < steps; i++) {
                fourlink_crank crank = {t.area[k].from + (i + 0.5) / steps * width, speed, 0};
                fourlink_forces forces;
                fourlink_state state;
                fourlink_load load;

                assert_int_equal(fourlink_deck_loads(fourlink_results_deck(r), branches[b],
                                                     crank.theta2, &load, NULL),
                                 FOURLINK_OK);
                assert_int_equal(
                    fourlink_analyse(&p.mechanism, branches[b], &crank, &load, 1, &state, &forces),
                    FOURLINK_OK);
                gain += (-forces.Ts * speed - t.mean_power) * width / steps / fabs(speed);
            }
            assert_close(t.area[k].energy, gain, 1e-6 * t.energy_fluctuation);
            least = fmin(least, fabs(gain));
        }
        assert_true(end == p.cycle);
        assert_true(least > 1e-3 * t.energy_fluctuation); /* none of them is two */
    }
    fourlink_results_free(r);
}

TEST(test_areas_of_the_turning_moment)
{
    static const char *const speeds[] = {"10 rad/s", "-10 rad/s"};
    int i;

    for (i = 0; i < 2; i++) {
        check_areas(four_bar(0.020, 0.066, 0.056, 0.080,
                             print("[load]\nlink = crank\ntorque = 80 N m\nfrom = 30 deg\n"
                                   "to = 90 deg\n[motion]\nspeed = %s\n",
                                   speeds[i])),
                    3);
        check_areas(slider_crank(0.15, 0.45, 0.02,
                                 print("[load]\nlink = crank\ntorque = 50 N m\n[piston]\n"
                                       "mass = 5 kg\n[motion]\nspeed = %s\n",
                                       speeds[i])),
                    4);
    }
}

/* dE = I Cs omega^2 */
TEST(test_flywheel)
{
    static fact_list list;
    const char *torque = "0 deg 100, 90 deg 100, 180 deg 300, 270 deg 300";
    double dE = 162.5 * PI / 2, I, omega = 120 * 2 * PI / 60;

    facts_of(with_curve(torque, "[motion]\nspeed = 120 rpm\n[flywheel]\nfluctuation = 0.04\n"),
             &list);
    I = dE / (0.04 * omega * omega);
    check_fact(&list, "flywheel_inertia", FOURLINK_OPEN, I, 1e-9 * I);
    check_fact(&list, "flywheel_fluctuation", FOURLINK_OPEN, 0.04, 0);
    I = value_of(&list, "flywheel_inertia", FOURLINK_OPEN);
    facts_of(with_curve(torque,
                        print("[motion]\nspeed = 120 rpm\n[flywheel]\ninertia = %.17g kg m2\n", I)),
             &list);
    check_fact(&list, "flywheel_fluctuation", FOURLINK_OPEN, 0.04, 1e-14);
    check_fact(&list, "flywheel_inertia", FOURLINK_OPEN, I, 1e-14 * I);
    /* half the speed, four times the fluctuation */
    facts_of(with_curve(torque, print("[motion]\nspeed = -60 rpm\n[units]\ninertia = kg cm2\n"
                                      "[flywheel]\ninertia = %.17g kg m2\n",
                                      I)),
             &list);
    check_fact(&list, "flywheel_fluctuation", FOURLINK_OPEN, 0.16, 1e-14);
    check_fact(&list, "flywheel_inertia", FOURLINK_OPEN, I * 1e4, 1e-10 * I);
    facts_of(with_curve(torque, "[motion]\nspeed = 120 rpm\n"), &list);
    assert_null(find_fact(&list, "flywheel_inertia", FOURLINK_OPEN));
    assert_null(find_fact(&list, "flywheel_fluctuation", FOURLINK_OPEN));
    /* nothing fluctuates: no flywheel is needed */
    facts_of(with_curve("0 N m", "[motion]\nspeed = 120 rpm\n[flywheel]\nfluctuation = 0.04\n"),
             &list);
    check_fact(&list, "flywheel_inertia", FOURLINK_OPEN, 0, 0);
    assert_null(find_fact(&list, "flywheel_fluctuation", FOURLINK_OPEN));
}

/* The interval and range of the table do not matter to the turning moment, nor does one instant. */
TEST(test_turning_moment_of_any_range)
{
    static const char *const motions[] = {"interval = 40 deg\n", "at = 30 deg\n",
                                          "from = 20 deg\nto = 50 deg\n", "hold = yes\n"};
    static fact_list list;
    int i;

    for (i = 0; i < 4; i++) {
        facts_of(with_curve("0 deg 100, 90 deg 100, 180 deg 300, 270 deg 300",
                            print("[motion]\nspeed = 20 rad/s\n%s", motions[i])),
                 &list);
        check_fact(&list, "mean_torque", FOURLINK_OPEN, 200, 2e-7);
        check_fact(&list, "energy_fluctuation", FOURLINK_OPEN, 162.5 * PI / 2, 1e-6);
    }
}

static void check_no_turning_moment(const char *contents)
{
    static const char *const names[] = {"mean_torque",        "mean_power",
                                        "energy_fluctuation", "energy_coefficient",
                                        "flywheel_inertia",   "flywheel_fluctuation"};
    fourlink_turning t, before;
    static fact_list list;
    fourlink_value value;
    int i, k;

    facts_of(contents, &list);
    assert_true(list.n > 3);
    for (k = 0; k < 2; k++) {
        for (i = 0; i < 6; i++) {
            if (find_fact(&list, names[i], branches[k]))
                fail_msg("there is a fact %s of\n%s", names[i], contents);
            assert_int_equal(fourlink_results_value(list.results, names[i], branches[k], 0, &value),
                             FOURLINK_NO_SUCH_FACT);
        }
        memset(&t, 7, sizeof t);
        before = t;
        assert_int_equal(fourlink_results_turning(list.results, branches[k], &t),
                         FOURLINK_NO_TURNING_MOMENT);
        assert_memory_equal(&t, &before, sizeof t);
    }
}

TEST(test_no_turning_moment)
{
    const char *load_ = "[load]\nlink = crank\ntorque = 5 N m\n[flywheel]\nfluctuation = 0.02\n";
    static fact_list list;
    char *good = print("%s[motion]\nspeed = 10 rad/s\n", load_);

    facts_of(four_bar(0.020, 0.066, 0.056, 0.080, good), &list);
    check_fact(&list, "mean_torque", FOURLINK_OPEN, 5, 5e-9);
    /* a constant torque does not fluctuate */
    check_fact(&list, "energy_fluctuation", FOURLINK_OPEN, 0, 1e-12);
    /* accelerated, run up, at rest, without forces */
    check_no_turning_moment(
        four_bar(0.020, 0.066, 0.056, 0.080, print("%sacceleration = 1 rad/s2\n", good)));
    check_no_turning_moment(four_bar(0.020, 0.066, 0.056, 0.080,
                                     print("%sacceleration = 1 rad/s2\nhold = yes\n", good)));
    check_no_turning_moment(
        four_bar(0.020, 0.066, 0.056, 0.080,
                 print("%s[motion]\nacceleration = 1 rad/s2\nrun_up = 90 deg\n", load_)));
    check_no_turning_moment(four_bar(0.020, 0.066, 0.056, 0.080, load_));
    check_no_turning_moment(four_bar(0.020, 0.066, 0.056, 0.080, "[motion]\nspeed = 10 rad/s\n"));
    /* cranks that do not turn fully; the last but for a hundredth of a degree */
    check_no_turning_moment(four_bar(0.3, 0.4, 0.5, 0.75, good));
    check_no_turning_moment(four_bar(0.75, 0.4, 0.5, 0.35, good));
    check_no_turning_moment(slider_crank(0.4, 0.2, 0, good));
    check_no_turning_moment(slider_crank(0.4, 0.5, 0.2, good));
    check_no_turning_moment(four_bar(0.3, 0.4, 0.5, 0.6 * (1 + 1e-9), good));
}

/* Just beside a change point at 0 deg the moment has a peak of some tenths of a degree.  Without weights the
** energy that fluctuates is the kinetic energy of coupler and rocker, two uniform bars. */
TEST(test_energy_beside_change_point)
{
    static fact_list list;
    double least = INFINITY, most = 0, angle;

    facts_of(print("mechanism = four-bar\n[ground]\nlength = 0.70001 m\n[crank]\nlength = 0.3 m\n"
                   "[coupler]\nlength = 1 m\nmass = 2 kg\nuniform = yes\n[rocker]\n"
                   "length = 0.6 m\nmass = 1 kg\nuniform = yes\n%s%s",
                   still, revolution(10)),
             &list);
    for (angle = -180; angle <= 180; angle += fabs(angle) < 2 ? 0.001 : 0.1) {
        double v3 = value_at(list.results, "G3.v", angle),
               v4 = value_at(list.results, "G4.v", angle);
        double w3 = value_at(list.results, "omega3", angle),
               w4 = value_at(list.results, "omega4", angle);
        double E = v3 * v3 + w3 * w3 / 12 + v4 * v4 / 2 + 0.36 * w4 * w4 / 24;

        least = fmin(least, E);
        most = fmax(most, E);
    }
    check_fact(&list, "mean_torque", FOURLINK_OPEN, 0, 0);
    check_fact(&list, "energy_fluctuation", FOURLINK_OPEN, most - least, 1e-4 * most);
}

/* A cycle has at least a degree, rounded, and at most 100,000. */
TEST(test_cycles_without_turning_moment)
{
    const char *load_ = "[load]\nlink = crank\ntorque = 5 N m\n[motion]\nspeed = 10 rad/s\n";
    static fact_list list;

    check_no_turning_moment(four_bar(0.020, 0.066, 0.056, 0.080,
                                     print("%sinterval = 0.1 deg\ncycle = 0.4 deg\n", load_)));
    check_no_turning_moment(
        four_bar(0.020, 0.066, 0.056, 0.080, print("%scycle = 100080 deg\n", load_)));
    facts_of(four_bar(0.020, 0.066, 0.056, 0.080,
                      print("%sinterval = 0.1 deg\ncycle = 0.6 deg\n", load_)),
             &list);
    check_fact(&list, "mean_torque", FOURLINK_OPEN, 5, 5e-9);
}

/* A torque of 1 N m drives the crank; friction in A, with at least the crank's weight on it, takes more. */
TEST(test_load_that_cannot_drive)
{
    static fact_list list;
    double turns;

    for (turns = 1; turns >= -1; turns -= 2) {
        facts_of(print("mechanism = slider-crank\n[crank]\nlength = 50 mm\nmass = 100 kg\n"
                       "cg = 0 mm\n[rod]\nlength = 200 mm\n[load]\nlink = crank\n"
                       "torque = %g N m\n[friction]\nA = 0.1\nradius_A = 20 mm\n"
                       "[motion]\nspeed = %g rad/s\n",
                       turns, 3 * turns),
                 &list);
        /* 981 N on a friction circle of 2 mm */
        check_fact(&list, "mean_torque", FOURLINK_OPEN, turns * (1 - 1.962), 1e-6);
        check_fact(&list, "efficiency_cycle", FOURLINK_OPEN, 0, 0);
    }
}

/* The areas of a cycle add up to nothing, and the greatest sum of some that follow each other is the
** fluctuation; the deck's facts are those of the turning moment. */
TEST(test_areas_add_up_to_the_fluctuation)
{
    static fact_list list;
    const char *torque = "0 deg 100, 90 deg 100, 180 deg 300, 270 deg 300";
    const char *decks[4];
    int i, j, k;

    decks[0] = with_curve(torque, "[motion]\nspeed = 20 rad/s\n[flywheel]\ninertia = 2 kg m2\n");
    decks[1] = with_curve(torque, "[motion]\nspeed = -20 rad/s\ncycle = 720 deg\n");
    decks[2] = slider_crank(0.15, 0.45, 0.02,
                            "[load]\nlink = crank\ntorque = 50 N m\n[piston]\nmass = 5 kg\n"
                            "[motion]\nspeed = 30 rad/s\n[flywheel]\nfluctuation = 0.02\n");
    decks[3] = with_curve("80 N m", "from = 30 deg\nto = 90 deg\n[motion]\nspeed = -10 rad/s\n");
    for (i = 0; i < 4; i++) {
        facts_of(decks[i], &list);
        for (k = 0; k < 2; k++) {
            double E = 0, least = 0, greatest = 0;
            fourlink_turning t;

            assert_int_equal(fourlink_results_turning(list.results, branches[k], &t), FOURLINK_OK);
            assert_in_range(t.n_areas, 2, FOURLINK_AREAS);
            for (j = 0; j < t.n_areas; j++) {
                E += t.area[j].energy;
                least = fmin(least, E);
                greatest = fmax(greatest, E);
            }
            assert_near(E, 0, 1e-9 * t.energy_fluctuation);
            assert_close(greatest - least, t.energy_fluctuation, 1e-9);
            check_fact(&list, "mean_torque", branches[k], t.mean_torque, 0);
            check_fact(&list, "mean_power", branches[k], t.mean_power, 0);
            check_fact(&list, "energy_fluctuation", branches[k], t.energy_fluctuation, 0);
            assert_true(t.has_coefficient);
            check_fact(&list, "energy_coefficient", branches[k], t.energy_coefficient, 0);
            if (i == 0 || i == 2)
                check_fact(&list, "flywheel_inertia", branches[k], t.inertia, 0);
            else
                assert_true(t.inertia == 0 && t.fluctuation == 0);
        }
    }
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
