/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_actual.c - the actual motion of machines: energy, a second integration by GSL, limits,
** symmetries, machines that swing back, and values of an independent solver.
*/
#include <stdlib.h>

#include <gsl/gsl_math.h>
#include <gsl/gsl_odeiv2.h>

#include "machines.h"
#include "motion/path.h"
#include "results/analysis.h"
#include "deck/reader.h"

#define FRICTION                                                                            \
    "[friction]\nguide = 0.1\nguide_length = 60 mm\nA = 0.05\nradius_A = 20 mm\nB = 0.05\n" \
    "radius_B = 20 mm\nC = 0.08\nradius_C = 10 mm\n"

/* The results of a deck on the open branch: the motion on the other one is not integrated. */
static fourlink_results *opened_open(const char *contents)
{
    return opened(print("%s[table]\nbranch = open\n", contents));
}

static fourlink_instant row_of(fourlink_results *r, unsigned long i)
{
    fourlink_instant at;

    assert_int_equal(fourlink_results_row(r, FOURLINK_OPEN, i, NULL, &at, NULL), FOURLINK_OK);
    return at;
}

/* Kinetic energy and that of the weights. */
static double energy_of(fourlink_results *r, const fourlink_instant *at)
{
    fourlink_problem problem = problem_of(r);
    const fourlink_design *d = &problem.mechanism.design;
    double J, omega2 = at->row.crank.omega2, energy;
    fourlink_vector G;
    int i;

    assert_int_equal(fourlink_inertia(&problem.mechanism, &at->state, &J, NULL), FOURLINK_OK);
    energy = 0.5 * J * omega2 * omega2;
    for (i = 2; i <= 4; i++) {
        fourlink_point(&at->state, i, &d->link[i].cg, &G, NULL, NULL);
        energy -= d->link[i].mass * (G.x * d->gravity.x + G.y * d->gravity.y);
    }
    return energy;
}

/* A free machine keeps its energy over 100 turns, though its speed changes by more than half. */
TEST(test_energy)
{
    fourlink_results *r = opened_open(
        ROCKER "[motion]\nmode = free\nspeed = 40 rad/s\nturns = 100\ninterval = 37 deg\n");
    fourlink_instant at = row_of(r, 0);
    double first = energy_of(r, &at), kinetic = value_at(r, "energy", 0), worst = 0;
    double least = 1e9, most = 0;
    unsigned long i;

    for (i = 1; i < problem_of(r).n_rows; i++) {
        at = row_of(r, i);
        worst = fmax(worst, fabs(energy_of(r, &at) - first));
        least = fmin(least, at.row.crank.omega2);
        most = fmax(most, at.row.crank.omega2);
    }
    assert_true(most > 1.8 * least);
    assert_near(worst, 0, 1e-11 * kinetic);
    fourlink_results_free(r);
}

/* The kinetostatic torque is that of the shaft in each row; the energy is the work put in. */
static void check_rows(fourlink_results *r, double inertia)
{
    unsigned long i;

    for (i = 0; i < problem_of(r).n_rows; i++) {
        fourlink_instant at = row_of(r, i);
        double angle = at.row.angle, Ts = at.forces.Ts;
        double shaft = value_at(r, "T_motor", angle) - inertia * at.row.crank.alpha2;

        assert_near(Ts, shaft, 1e-11 * (fabs(Ts) + inertia * fabs(at.row.crank.alpha2)));
        assert_near(value_at(r, "energy_residual", angle), 0, 1e-11);
        assert_near(value_at(r, "omega2", angle), at.row.crank.omega2, 0);
    }
}

TEST(test_shaft)
{
    static const char *const motions[] = {"mode = run-up", "mode = free\nspeed = 9 rad/s",
                                          "mode = steady"};
    static const char *const friction[] = {"", FRICTION};
    size_t i, j;

    for (i = 0; i < 3; i++)
        for (j = 0; j < 2; j++) {
            fourlink_results *r =
                opened_open(print("%s[motion]\n%s\nturns = 2\ninterval = 7 deg\n%s",
                                  PUMP FORCE FAN MOTOR FLYWHEEL, motions[i], friction[j]));

            check_rows(r, 0.5);
            fourlink_results_free(r);
        }
}

static int n_machines = 3; /* or the argument */

/* A run-up ends in the steady motion, with flywheels of all sizes: one cycle leaves from hardly any to
** nearly all of a difference. */
TEST(test_ends_of_run_ups)
{
    uint64_t seed = 18;
    int i, compared = 0;

    for (i = 0; i < n_machines; i++) {
        double w = uniform(&seed, 10, 50), T = uniform(&seed, 20, 200);
        char machine[2000];
        fourlink_results *up, *steady;
        double last, before;

        sprintf(machine,
                PUMP FORCE "[load F]\nlink = crank\ntorque = %g\nover = omega2\nat_speed = %g\n"
                           "[motor]\ncurve = 0 rad/s %g, %g rad/s %g, %g rad/s 0\n"
                           "[flywheel]\ninertia = %g\n[motion]\ninterval = 360 deg\nmode = ",
                -T * uniform(&seed, 0, 0.5), w, T, 0.7 * w, T * uniform(&seed, 0.5, 1.3), w,
                T / w * pow(10, uniform(&seed, -1.5, 0.8)));
        up = opened_open(print("%srun-up\nturns = 100\n", machine));
        steady = opened_open(print("%ssteady\n", machine));
        if (problem_of(up).n_rows == 101 &&
            fourlink_results_end(up, FOURLINK_OPEN, &last) == FOURLINK_OK) {
            before = value_at(up, "omega2", 99 * 360);
            last = value_at(up, "omega2", 100 * 360);
            if (fabs(last - before) < 1e-9 * last) {
                assert_close(value_at(steady, "omega2", 0), last, 1e-7);
                assert_close(value_at(steady, "omega2", 360), value_at(steady, "omega2", 0), 1e-12);
                compared++;
            }
        }
        fourlink_results_free(up);
        fourlink_results_free(steady);
    }
    assert_true(compared > n_machines / 3);
}

/* Friction has corners where a force of a joint is zero, at angles that depend on the speed: the energy
** after a cycle is known to some 1e-10, but the steady motion is found, and closes within 1e-9. */
TEST(test_friction_of_motors)
{
    double torque, last = 0;

    for (torque = 100.6; torque < 104; torque += tries_all() ? 0.3 : 1.2) {
        fourlink_results *r = opened_open(
            print("%s[motor]\nstall_torque = %g\nno_load_speed = 14\n%s[motion]\nmode = "
                  "steady\ninterval = 90 deg\n",
                  PUMP FORCE FAN FLYWHEEL, torque, FRICTION));
        double first = value_at(r, "omega2", 0), mean = value_at(r, "mean_speed", 0);

        assert_close(value_at(r, "omega2", 360), first, 1e-9);
        assert_true(mean > last);
        last = mean;
        fourlink_results_free(r);
    }
}

/* ------------------------------------------------------------------------------------ by GSL */

/* d(omega2^2 / 2)/dtheta2 and dt/dtheta2 from the public functions. */
static int equations(double theta2, const double y[], double dy[], void *of_deck)
{
    fourlink_motor motor;
    fourlink_problem problem;
    fourlink_crank crank = {theta2, sqrt(2 * y[0]), 0};
    fourlink_load loads[20];
    fourlink_state state;
    fourlink_forces forces;
    fourlink_losses losses;
    double gas, J, slope, Q, T;

    memset(&motor, 0, sizeof motor);
    motor.kind = FOURLINK_MOTOR_LINEAR;
    motor.stall_torque = 120;
    motor.no_load_speed = 14;
    motor.ratio = 1;
    fourlink_deck_problem(of_deck, &problem);
    if (fourlink_deck_analyse(of_deck, FOURLINK_OPEN, &crank, 1, loads, &state, &forces, &losses,
                              &gas) != FOURLINK_OK)
        return GSL_EFAILED;
    fourlink_inertia(&problem.mechanism, &state, &J, &slope);
    fourlink_generalised_force(&problem.mechanism, &state, loads, problem.n_loads, &Q);
    fourlink_motor_torque(&motor, crank.omega2, &T);
    dy[0] = (T + Q - slope * y[0]) / (J + 0.5);
    dy[1] = 1 / crank.omega2;
    return GSL_SUCCESS;
}

/* A second opinion: GSL's rk8pd, from one point of the curve to the next. */
TEST(test_second_opinion)
{
    static const double corners[] = {0,   60,  120, 180, 200, 240, 300, 360,
                                     420, 480, 540, 560, 600, 660, 720};
    fourlink_results *r = opened_open(PUMP FORCE FAN MOTOR FLYWHEEL
                                      "[motion]\nmode = free\nspeed = 5 rad/s\nturns = 2\n");
    gsl_odeiv2_system system = {equations, NULL, 2, (void *)fourlink_results_deck(r)};
    gsl_odeiv2_driver *driver =
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, 0, 1e-13);
    double theta2 = 0, y[2] = {12.5, 0};
    size_t i;

    for (i = 1; i < COUNT(corners); i++) {
        gsl_odeiv2_driver_reset(driver);
        assert_int_equal(gsl_odeiv2_driver_apply(driver, &theta2, corners[i] * DEG, y),
                         GSL_SUCCESS);
        assert_close(value_at(r, "omega2", corners[i]), sqrt(2 * y[0]), 1e-11);
        assert_close(value_at(r, "time", corners[i]), y[1], 1e-11);
    }
    gsl_odeiv2_driver_free(driver);
    fourlink_results_free(r);
}

/* ------------------------------------------------------------------------------------ tolerance */

static void read_deck(const char *contents, deck *d)
{
    fourlink_source source = deck_source(contents);

    if (flk_deck_read(&source, d) != 1)
        fail_msg("%s\n%s", d->mistakes.list[0].message, contents);
}

/* A tolerance that is a tenth changes none of ten digits; one that is a thousand times larger would. */
TEST(test_tolerance)
{
    static const double tolerance[] = {1e-12, 1e-13, 1e-9};
    double speed[3], time[3];
    flk_analysis a;
    flk_path p;
    deck d;
    int i;

    read_deck(PUMP FORCE FAN MOTOR FLYWHEEL "[motion]\nmode = run-up\nturns = 3\n", &d);
    assert_true(flk_analysis_open(&a, &d, NULL));
    memset(&p, 0, sizeof p);
    p.d = &d;
    p.corners = a.course.corners;
    p.equation.sense = 1;
    p.equation.machine = d.machine;
    p.equation.acting = &a.acting;
    p.equation.branch = FOURLINK_OPEN;
    for (i = 0; i < 3; i++) {
        flk_actual_row row;

        p.tolerance = tolerance[i];
        p.budget = 10000;
        assert_true(flk_path_run(&p, 0, 6 * M_PI));
        assert_int_equal(flk_path_at(&p, 5.5 * M_PI, &row), FOURLINK_OK);
        speed[i] = row.crank.omega2;
        time[i] = row.time;
    }
    assert_close(speed[0], speed[1], 1e-11);
    assert_close(time[0], time[1], 1e-11);
    assert_true(fabs(speed[2] - speed[1]) > fabs(speed[0] - speed[1]));
    free(p.node);
    flk_analysis_close(&a);
    flk_deck_free(&d);
}

/* ------------------------------------------------------------------------------------ limits */

/* With a large flywheel the torque tends to that at constant speed, at first order. */
TEST(test_large_flywheel)
{
    fourlink_results *given =
        opened_open(PUMP FORCE "[motion]\nspeed = 12 rad/s\ninterval = 15 deg\n");
    double off[2] = {0, 0}, angle;
    int i;

    for (i = 0; i < 2; i++) {
        fourlink_results *r =
            opened_open(print("%s[motor]\ntorque = constant\n[flywheel]\ninertia = "
                              "%s kg m2\n[motion]\nmode = steady\nmean_speed = 12 "
                              "rad/s\ninterval = 15 deg\n",
                              PUMP FORCE, i ? "20000" : "2000"));

        for (angle = 0; angle < 360; angle += 15)
            off[i] = fmax(off[i], fabs(value_at(r, "Ts", angle) - value_at(given, "Ts", angle)));
        fourlink_results_free(r);
    }
    assert_close(off[0] / off[1], 10.0, 0.01);
    assert_true(off[1] < 1e-3);
    fourlink_results_free(given);
}

/* Values of the theory of flywheels: 12 rad/s in the mean over time is 12.089 over the angle, and the
** textbooks' coefficient of fluctuation, 0.25825, is not the true one. */
TEST(test_fluctuation)
{
    fourlink_results *r =
        opened_open(PUMP FORCE "[motor]\ntorque = constant\n[flywheel]\ninertia = 2 "
                               "kg m2\n[motion]\nmode = steady\nmean_speed = 12 rad/s\n");

    assert_close(value_at(r, "mean_speed", 0), 12.0, 1e-10);
    assert_near(value_at(r, "mean(omega2)", 0), 12.089, 5e-4);
    assert_near(value_at(r, "fluctuation_exact", 0), 0.25712, 6e-6);
    assert_near(value_at(r, "flywheel_fluctuation", 0), 0.25825, 2e-5);
    assert_close(value_at(r, "steady_rate", 0), 1.0, 1e-9);
    assert_close((value_at(r, "max(omega2)", 0) - value_at(r, "min(omega2)", 0)) / 12,
                 value_at(r, "fluctuation_exact", 0), 1e-8);
    assert_close((value_at(r, "max(omega2)", 0) + value_at(r, "min(omega2)", 0)) / 2,
                 value_at(r, "mean_speed_textbook", 0), 1e-8);
    fourlink_results_free(r);
}

/* The facts of the last cycle of a motion that slows down are those of one cycle from its speed there. */
TEST(test_last_cycle)
{
    static const char *const names[] = {"mean_speed", "mean_speed_textbook", "fluctuation_exact",
                                        "period"};
    static const char motion[] = "%s[motion]\nmode = free\nspeed = %.17g rad/s\nturns = %d\n";
    fourlink_results *r = opened_open(print(motion, PUMP FAN FLYWHEEL, 30.0, 4)),
                     *last = opened_open(
                         print(motion, PUMP FAN FLYWHEEL, value_at(r, "omega2", 1080), 1));
    size_t i;

    assert_true(value_at(r, "omega2", 1080) < 20);
    for (i = 0; i < COUNT(names); i++)
        assert_close(value_at(r, names[i], 0), value_at(last, names[i], 0), 1e-9);
    assert_close(value_at(r, "period", 0), value_at(r, "time", 1440) - value_at(r, "time", 1080),
                 1e-10);
    fourlink_results_free(r);
    fourlink_results_free(last);
}

/* The rate of the map of the energy over a cycle is that by which a run-up comes to the steady speed. */
TEST(test_rate)
{
    fourlink_results *r =
        opened_open(PUMP FORCE FAN "[motor]\nstall_torque = 120 N m\nno_load_speed "
                                   "= 14 rad/s\n[flywheel]\ninertia = 8 kg m2\n"
                                   "[motion]\nmode = run-up\nturns = 6\n");
    fourlink_results *steady =
        opened_open(PUMP FORCE FAN "[motor]\nstall_torque = 120 N m\n"
                                   "no_load_speed = 14 rad/s\n[flywheel]\n"
                                   "inertia = 8 kg m2\n[motion]\nmode = steady\n");
    double E = value_at(steady, "energy", 0), rate = value_at(steady, "steady_rate", 0);
    double before = value_at(r, "energy", 5 * 360) - E, after = value_at(r, "energy", 6 * 360) - E;

    assert_in_range(rate * 1000, 100, 900);
    assert_close(value_at(r, "steady_rate", 0), rate, 1e-9);
    assert_close(after / before, rate, 5e-3);
    assert_close(value_at(r, "mean_speed", 0), value_at(steady, "mean_speed", 0), 1e-9);
    /* it reaches that mean after the time of the fact */
    assert_true(value_at(r, "run_up_time", 0) > 0.3);
    fourlink_results_free(r);
    fourlink_results_free(steady);
}

/* ------------------------------------------------------------------------------------ small flywheels */

#define BALANCED "[motor]\ntorque = constant\n"
#define TEN "[motion]\nmode = steady\nmean_speed = 10 rad/s\ninterval = 45 deg\n"

/* A motor of constant power P and a torque -c omega2 have a steady speed of (P / c)^(1/2), from which a difference shrinks in
** a cycle by exp(-4 pi c / (J omega2)).  Where that is 1 but for rounding error nothing holds the speed. */
TEST(test_what_holds_a_speed)
{
    uint64_t seed = 13;
    int i, held = 0;

    for (i = 0; i < some_of(1000); i++) {
        double c = pow(10, uniform(&seed, -6, 1)), P = pow(10, uniform(&seed, 0, 4));
        double speed = sqrt(P / c), growth = pow(10, uniform(&seed, -10, 0.5));
        double J = 4 * PI * c / (growth * speed), error;
        fourlink_results *r;
        fourlink_value found;
        int status;

        r = opened_open(
            print("mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 "
                  "mm\n[gravity]\nacceleration = 0\n[flywheel]\ninertia = %.17g kg m2\n"
                  "[motor]\npower = %.17g W\nmax_torque = %.17g N m\n[load c]\nlink = crank\n"
                  "over = omega2\ntorque = %.17g N m\nat_speed = 1 rad/s\nexponent = 1\n"
                  "[motion]\nmode = steady\n",
                  J, P, 10 * P / speed, -c));
        status = fourlink_results_value(r, "mean_speed", FOURLINK_OPEN, 0, &found);
        if (growth > 1.01e-6) {
            if (status != FOURLINK_OK)
                fail_msg("case %d: a motion of rate exp(-%g): %s", i, growth,
                         fourlink_status_text(status));
            error = fabs(found.value * found.to_si / speed - 1);
            if (!(error <= 1e-9 + 3e-10 / growth))
                fail_msg("case %d: %.12g rad/s, not %.12g: %g, growth %g", i,
                         found.value * found.to_si, speed, error, growth);
            held++;
        } else if (growth < 0.99e-6 && status == FOURLINK_OK) {
            fail_msg("case %d: a motion of rate exp(-%g) at %g rad/s", i, growth, found.value);
        }
        fourlink_results_free(r);
    }
    assert_true(held > i / 4 && held < 0.9 * i);
}

/* A motor that balances the loads has a steady motion with any flywheel, though the crank nearly comes
** to rest; two values are those of an independent integration, by Runge and Kutta's method in 4000
** steps. */
TEST(test_small_flywheels)
{
    static const struct {
        double inertia, fluctuation, torque;
    } sample[] = {{0.3, 0, 0},
                  {0.2, 2.61882932, 23.3633563},
                  {0.17, 2.8559265, 24.6997309},
                  {0.15, 0, 0},
                  {0.1, 0, 0}};
    double last = 0, fluctuation;
    size_t i;

    for (i = 0; i < COUNT(sample); i++) {
        fourlink_results *r = opened_open(print("%s[flywheel]\ninertia = %g kg m2\n%s",
                                                PUMP FORCE FAN BALANCED, sample[i].inertia, TEN));

        assert_close(value_at(r, "omega2", 0), value_at(r, "omega2", 360), 1e-9);
        assert_close(2 * M_PI / value_at(r, "time", 360), 10.0, 1e-9);
        assert_close(value_at(r, "mean_speed", 0), 10.0, 1e-9);
        check_rows(r, sample[i].inertia);
        fluctuation = value_at(r, "fluctuation_exact", 0);
        assert_true(fluctuation > last);
        last = fluctuation;
        if (sample[i].torque > 0) {
            assert_close(fluctuation, sample[i].fluctuation, 1e-8);
            assert_close(value_at(r, "motor_torque", 0), sample[i].torque, 1e-8);
        }
        fourlink_results_free(r);
    }
}

/* The flywheel for a fluctuation that only a small one has. */
TEST(test_wanted_fluctuation)
{
    fourlink_results *r =
        opened_open(PUMP FORCE FAN BALANCED "[flywheel]\nfluctuation = 240 %\nexact = yes\n" TEN);
    double inertia = value_at(r, "flywheel_inertia", 0);

    fourlink_results_free(r);
    r = opened_open(
        print("%s[flywheel]\ninertia = %.17g kg m2\n%s", PUMP FORCE FAN BALANCED, inertia, TEN));
    assert_near(value_at(r, "fluctuation_exact", 0), 2.4, 1e-6);
    fourlink_results_free(r);
}

/* With a flywheel so small that the crank stands still, but for rounding, none is found, and no torque
** is told. */
TEST(test_no_flywheel)
{
    fourlink_results *r =
        opened_open(PUMP FORCE FAN BALANCED "[flywheel]\ninertia = 0.001 kg m2\n" TEN);
    fourlink_value v;
    double angle;

    assert_int_equal(fourlink_results_end(r, FOURLINK_OPEN, &angle), FOURLINK_NO_STEADY);
    assert_int_not_equal(fourlink_results_value(r, "motor_torque", FOURLINK_OPEN, 0, &v),
                         FOURLINK_OK);
    fourlink_results_free(r);
}

/* ------------------------------------------------------------------------------------ symmetries */

/* A machine seen from behind: the mirror image turns clockwise. */
TEST(test_mirror)
{
    static const char motor[] = "[motor]\nstall_torque = %s60 N m\nno_load_speed = %s14 rad/s\n"
                                "inertia = 0.01 kg m2\nratio = 3\n";
    static const char links[] =
        "mechanism = slider-crank\n[crank]\nlength = 50 mm\nmass = 1.5 kg\ninertia = 0.002 kg "
        "m2\ncg = (12, %s3) mm\n[rod]\nlength = 200 mm\nmass = 0.8 kg\ninertia = 0.0035 kg m2\n"
        "cg = 70 mm\n[ground]\noffset = %s10 mm\n[piston]\nmass = 1.2 kg\n%s"
        "[gravity]\ndirection = %s90 deg\n";
    char left[2000], right[2000];
    fourlink_results *r, *s;
    const char *rubs = tries_all() ? FRICTION : "";
    double angle;

    sprintf(left, links, "", "", rubs, "-");
    sprintf(left + strlen(left), motor, "", "");
    sprintf(right, links, "-", "-", rubs, "");
    sprintf(right + strlen(right), motor, "-", "-");
    r = opened_open(print("%s[motion]\nmode = run-up\nto = 400 deg\n", left));
    s = opened_open(print("%s[motion]\nmode = run-up\nto = -400 deg\n", right));
    for (angle = 0; angle <= 400; angle += 10) {
        assert_near(value_at(r, "omega2", angle), -value_at(s, "omega2", -angle), 1e-10);
        assert_near(value_at(r, "alpha2", angle), -value_at(s, "alpha2", -angle), 1e-8);
        assert_near(value_at(r, "T_motor", angle), -value_at(s, "T_motor", -angle), 1e-8);
        assert_near(value_at(r, "time", angle), value_at(s, "time", -angle), 1e-11);
    }
    fourlink_results_free(r);
    fourlink_results_free(s);
}

/* Rows do not depend on the interval, nor on the rows before them. */
TEST(test_any_angle)
{
    fourlink_results *fine =
                         opened_open(PUMP FORCE FAN MOTOR FLYWHEEL
                                     "[motion]\nmode = run-up\nturns = 1\ninterval = 0.1 deg\n"),
                     *coarse =
                         opened_open(PUMP FORCE FAN MOTOR FLYWHEEL
                                     "[motion]\nmode = run-up\nturns = 1\ninterval = 90 deg\n");
    double angle;

    for (angle = 360; angle >= 0; angle -= 0.7) {
        assert_near(value_at(fine, "omega2", angle), value_at(coarse, "omega2", angle), 0);
        assert_near(value_at(fine, "time", angle), value_at(coarse, "time", angle), 0);
    }
    fourlink_results_free(fine);
    fourlink_results_free(coarse);
}

/* A parallelogram runs through its change points, and a linkage with dead positions up to the first. */
TEST(test_positions)
{
    fourlink_results *r = opened_open(
        "mechanism = four-bar\n[ground]\nlength = 1 m\n[crank]\nlength = 0.3 m\nmass = 1 kg\n"
        "cg = 0.15 m\n[coupler]\nlength = 1 m\nmass = 2 kg\ncg = 0.5 m\n[rocker]\nlength = 0.3 m\n"
        "mass = 1 kg\ncg = 0.15 m\n[motion]\nmode = free\nspeed = 20 rad/s\nfrom = 30 deg\nto = "
        "1110 deg\ninterval = 20 deg\n");
    double angle, h, J, t;
    fourlink_instant at;

    /* all of it turns as one mass, J = sum m r^2, under its weight */
    J = 2 * (1 * 0.15 * 0.15) + 2 * 0.3 * 0.3;
    for (angle = 30; angle <= 1110; angle += 40) {
        h = (1 * 0.15 * 2 + 2 * 0.3) * (sin(angle * DEG) - sin(30 * DEG));
        assert_close(value_at(r, "omega2", angle), sqrt(400 - 2 * 9.81 * h / J), 1e-9);
    }
    fourlink_results_free(r);

    r = opened_open(
        "mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 60 mm\nmass = 1 "
        "kg\ncg = 20 mm\n[coupler]\nlength = 50 mm\nmass = 1 kg\ncg = 20 mm\n[rocker]\n"
        "length = 40 mm\nmass = 1 kg\ncg = 10 mm\n[motion]\nmode = free\nspeed = 30 rad/s\n"
        "from = 50 deg\nto = 120 deg\ninterval = 1 deg\n[flywheel]\ninertia = 1 kg m2\n");
    at = row_of(r, 0);
    J = energy_of(r, &at) + 0.5 * 900;
    for (angle = 50; fourlink_results_at(r, FOURLINK_OPEN, angle, NULL, &at, NULL) == FOURLINK_OK;
         angle += 1)
        assert_near(energy_of(r, &at) + 0.5 * gsl_pow_2(at.row.crank.omega2), J, 1e-9 * J);
    assert_in_range(angle, 60, 110);
    assert_int_not_equal(fourlink_results_end(r, FOURLINK_OPEN, &t), FOURLINK_OK);
    fourlink_results_free(r);
}

/* Linkages with one change point, at 0 or at 180 deg, and engines with one at 90 or at -90 deg keep
** their energy. */
TEST(test_one_change_point)
{
    static const char motion[] =
        "[motion]\nmode = free\nspeed = 40 rad/s\nfrom = 31 deg\nto = 1111 deg\ninterval = "
        "20 deg\n";
    static const char linkage[] = "mechanism = four-bar\n[ground]\nlength = 1 m\n[crank]\nlength = "
                                  "0.3 m\n[coupler]\nlength = %g m\n"
                                  "[rocker]\nlength = %g m\nmass = 1 kg\ncg = 0.1 m\n";
    const char *decks[4];
    unsigned long i, k;

    decks[0] = print(linkage, 1.2, 0.5);
    decks[1] = print(linkage, 0.6, 0.7);
    decks[2] = slider_crank(0.3, 0.4, 0.1, "[piston]\nmass = 1 kg\n");
    decks[3] = slider_crank(0.3, 0.4, -0.1, "[piston]\nmass = 1 kg\n");
    for (i = 0; i < 4; i++) {
        fourlink_results *r =
            opened_open(print("%s[flywheel]\ninertia = 0.3 kg m2\n%s", decks[i], motion));
        fourlink_instant at = row_of(r, 0);
        double first = energy_of(r, &at) + 0.15 * 1600;

        for (k = 1; k < problem_of(r).n_rows; k++) {
            at = row_of(r, k);
            assert_close(energy_of(r, &at) + 0.15 * gsl_pow_2(at.row.crank.omega2), first, 1e-10);
        }
        fourlink_results_free(r);
    }
}

/* ------------------------------------------------------------------------------------ by time */

/* Rows by time are those by angle at the same time. */
TEST(test_time_and_angle)
{
    fourlink_results *r = opened_open(PUMP FORCE FAN MOTOR FLYWHEEL
                                      "[motion]\nmode = run-up\nrows = time\ntime_step = 10 ms\n"
                                      "duration = 0.555 s\n"),
                     *s = opened_open(PUMP FORCE FAN MOTOR FLYWHEEL
                                      "[motion]\nmode = run-up\nturns = 1\n");
    unsigned long i, n = problem_of(r).n_rows;

    assert_int_equal(n, 57);
    for (i = 0; i < n; i++) {
        fourlink_instant at = row_of(r, i);

        assert_near(at.row.time, i < n - 1 ? 0.01 * (double)i : 0.555, 1e-15);
        assert_near(value_at(s, "time", at.row.angle), at.row.time, 1e-10);
        assert_near(value_at(s, "omega2", at.row.angle), at.row.crank.omega2, 1e-9);
        assert_near(value_at(r, "omega2", at.row.angle), at.row.crank.omega2, 1e-9);
    }
    fourlink_results_free(r);
    fourlink_results_free(s);
}

/* By time as by angle, a linkage moves up to its dead position, and its energy is the same up to there. */
TEST(test_time_to_a_dead_position)
{
    fourlink_results *r = opened_open(
        "mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 60 mm\nmass = 1 kg\ncg "
        "= 20 mm\n"
        "[coupler]\nlength = 50 mm\n[rocker]\nlength = 40 mm\nmass = 1 kg\ncg = 10 "
        "mm\n[motion]\nmode = free\n"
        "speed = 30 rad/s\nfrom = 50 deg\nrows = time\ntime_step = 1 ms\nduration = 0.1 s\n");
    fourlink_instant at = row_of(r, 0);
    double first = energy_of(r, &at);
    unsigned long i;

    for (i = 0; fourlink_results_row(r, FOURLINK_OPEN, i, NULL, &at, NULL) == FOURLINK_OK; i++) {
        assert_near(at.row.time, 1e-3 * (double)i, 1e-15);
        assert_close(energy_of(r, &at), first, 1e-9);
    }
    assert_in_range(i, 10, 99);
    for (; i < 101; i++)
        assert_int_equal(fourlink_results_row(r, FOURLINK_OPEN, i, NULL, &at, NULL),
                         FOURLINK_DEAD_POSITION);
    fourlink_results_free(r);
}

/* The places of rows are those of their abscissa, in the deck's unit of angle or in s, and a row between two
** others is a row of a deck with half the step. */
static void check_places(const char *motion, const char *key, const char *in, double first,
                         double step, double last)
{
    fourlink_results *r = opened_open(
        print(PUMP "[units]\ntime = ms\n[motion]\n%s%s = %g %s\n", motion, key, step, in));
    fourlink_results *half = opened_open(
        print(PUMP "[units]\ntime = ms\n[motion]\n%s%s = %g %s\n", motion, key, step / 2, in));
    fourlink_problem p = problem_of(r);
    fourlink_instant row, here, between;
    unsigned long i;

    assert_string_equal(p.over.step_key, key);
    assert_string_equal(p.over.unit, in);
    assert_true(p.over.first == first && p.over.last == last);
    assert_near(p.over.step, step, 1e-15 * step);
    for (i = 0; i < p.n_rows; i++) {
        row = row_of(r, i);
        assert_near(row.row.place, first + (double)i * step, 1e-14 * last);
        assert_true(row.row.place == (p.over.is_crank_angle ? row.row.angle : row.row.time));
        assert_int_equal(fourlink_results_along(r, FOURLINK_OPEN, row.row.place, NULL, &here, NULL),
                         FOURLINK_OK);
        assert_memory_equal(&here.row, &row.row, offsetof(fourlink_row, side));
        between = row_of(half, 2 * i + (i + 1 < p.n_rows));
        assert_int_equal(
            fourlink_results_along(r, FOURLINK_OPEN, between.row.place, NULL, &here, NULL),
            FOURLINK_OK);
        assert_memory_equal(&here.row, &between.row, offsetof(fourlink_row, side));
    }
    fourlink_results_free(r);
    fourlink_results_free(half);
}

TEST(test_places)
{
    static const double beyond[] = {-1e-9, 0.1 + 1e-9, 20, -20, 1e300, INFINITY, -INFINITY, NAN};
    fourlink_results *r;
    size_t i;

    check_places("speed = 8 rad/s\nmode = free\nrows = time\nduration = 0.1 s\n", "time_step", "s",
                 0, 0.005, 0.1);
    check_places("speed = 80 rad/s\nmode = free\nfrom = 20 deg\nto = 60 deg\n", "interval", "deg",
                 20, 2.5, 60);
    check_places("speed = 8 rad/s\nfrom = 20 deg\nto = 60 deg\n", "interval", "deg", 20, 2.5, 60);
    r = opened_open(PUMP "[motion]\nspeed = 8 rad/s\nmode = free\nrows = time\nduration = 0.1 s\n"
                         "time_step = 5 ms\n");
    for (i = 0; i < sizeof beyond / sizeof beyond[0]; i++)
        assert_int_equal(fourlink_results_along(r, FOURLINK_OPEN, beyond[i], NULL, NULL, NULL),
                         FOURLINK_NO_SUCH_ANGLE);
    fourlink_results_free(r);
}

/* A pendulum swings between the angles at which its energy is that of its weight, as often as it should. */
TEST(test_pendulum)
{
    fourlink_results *r = opened_open(PUMP "[motion]\nmode = free\nspeed = 8 rad/s\nrows = time\n"
                                           "time_step = 5 ms\nduration = 3 s\n"),
                     *s = opened_open(PUMP "[motion]\nmode = free\nspeed = 8 rad/s\nturns = 1\n");
    fourlink_instant at = row_of(r, 0);
    double first = energy_of(r, &at), size = value_at(r, "max(energy)", 0), stall, value;
    unsigned long i, n = problem_of(r).n_rows, turns = 0;
    int forward = 1;

    assert_int_equal(fourlink_results_end(s, FOURLINK_OPEN, &stall), FOURLINK_STALLS);
    for (i = 1; i < n; i++) {
        at = row_of(r, i);
        assert_near(energy_of(r, &at), first, 1e-10 * size);
        assert_near(at.forces.Ts, 0, 1e-11);
        assert_true(at.row.angle <= stall + 1e-9);
        turns += (at.row.crank.omega2 > 0) != forward;
        forward = at.row.crank.omega2 > 0;
    }
    assert_in_range(turns, 5, 40);
    /* extremes over the time, with the crank angles where they are */
    assert_close(value_at(r, "max(omega2)", 0), -value_at(r, "min(omega2)", 0), 1e-8);
    {
        fourlink_value v;

        assert_int_equal(fourlink_results_value(r, "max(J)", FOURLINK_OPEN, 0, &v), FOURLINK_OK);
        assert_int_equal(fourlink_results_value(r, "J", FOURLINK_OPEN, v.angle, &v), FOURLINK_OK);
        value = v.value;
    }
    assert_close(value, value_at(r, "max(J)", 0), 1e-9);
    fourlink_results_free(r);
    fourlink_results_free(s);
}

/* A parallelogram that swings about the position in which it is flat is a simple pendulum of the crank's length, whose energy
** and small swings are known. */
TEST(test_pendulum_at_a_change_point)
{
    static const double starts[][2] = {{180.2, 0.01}, {180.2, -0.0001}, {179.9, -0.02}, {181, 0}};
    const double k = sqrt(9.81 / 0.03);
    unsigned long i, n;
    size_t j;

    for (j = 0; j < sizeof starts / sizeof starts[0]; j++) {
        fourlink_results *r = opened_open(
            print("mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 30 mm\n"
                  "mass = 1 kg\ncg = 30 mm\n[coupler]\nlength = 80 mm\nmass = 1 kg\ncg = 40 mm\n"
                  "[rocker]\nlength = 30 mm\n[gravity]\nacceleration = 9.81 m/s2\n"
                  "direction = 180 deg\n[motion]\nmode = free\nspeed = %g rad/s\n"
                  "from = %g deg\nduration = 2 s\nrows = time\ntime_step = 10 ms\n",
                  starts[j][1], starts[j][0]));
        double first = (starts[j][0] - 180) * DEG, speed = starts[j][1];
        double size = hypot(first, speed / k), half = sin(first / 2);
        double energy = speed * speed + 4 * k * k * half * half;

        for (i = 0, n = problem_of(r).n_rows; i < n; i++) {
            fourlink_instant at = row_of(r, i);
            double away = (at.row.angle - 180) * DEG, w = at.row.crank.omega2;
            double phase = k * at.row.time;

            assert_near(w * w + 4 * k * k * sin(away / 2) * sin(away / 2), energy, 1e-10 * energy);
            assert_near(away, first * cos(phase) + speed / k * sin(phase),
                        size * size * size * (1 + phase) / 16 + 1e-10 * size);
        }
        assert_int_equal(n, 201);
        fourlink_results_free(r);
    }
}

/* A load that opposes the rocker in both directions, as dry friction does, takes T |dtheta4| of the
** energy: the crank stops where it is spent, and stays there. */
TEST(test_rest_between_two_loads)
{
    fourlink_results *r = opened_open(
        "mechanism = four-bar\n[gravity]\nacceleration = 0\n[ground]\nlength = 80 mm\n"
        "[crank]\nlength = 20 mm\nmass = 0.1 kg\nuniform = yes\n[coupler]\nlength = 66 mm\n"
        "mass = 0.3 kg\nuniform = yes\n[rocker]\nlength = 56 mm\nmass = 0.2 kg\nuniform = yes\n"
        "[load K]\nlink = rocker\nover = theta4\ntorque = -2 N m\nback = 2 N m\n[motion]\n"
        "mode = free\nspeed = 60 rad/s\nfrom = 60 deg\nrows = time\nduration = 0.05 s\n"
        "time_step = 0.001 s\n");
    fourlink_instant first = row_of(r, 0), at = first;
    double spent = 0, before = first.state.link[4].theta;
    unsigned long i;

    for (i = 1; i < problem_of(r).n_rows; i++) {
        at = row_of(r, i);
        spent += 2 * fabs(at.state.link[4].theta - before);
        before = at.state.link[4].theta;
        assert_near(energy_of(r, &at), energy_of(r, &first) - spent, 1e-9 * energy_of(r, &first));
        assert_near(named(r, "energy_residual", FOURLINK_OPEN, at.row.angle).value, 0, 1e-11);
    }
    assert_true(at.row.crank.omega2 == 0 && at.row.crank.alpha2 == 0);
    assert_near(spent, energy_of(r, &first), 1e-9 * spent);
    fourlink_results_free(r);
}

int main(int argc, char **argv)
{
    n_machines = argc > 1 ? atoi(argv[1]) : n_machines;
    return run_all_tests(watch_gsl);
}
