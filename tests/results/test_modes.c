/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_modes.c - decks with a motor, by name: columns, facts, the end of the motion, the flywheel for a
** fluctuation; against an independent solver.
*/
#include "chance.h"
#include "machines.h"

#define LOADED PUMP FORCE FAN
#define RUN_UP "[motion]\nmode = run-up\nturns = 2\ninterval = 45 deg\n"
#define STEADY "[motion]\nmode = steady\ninterval = 45 deg\n"

static void check_value(fourlink_results *r, const char *name, double angle, double expected)
{
    double computed = value_at(r, name, angle);

    if (!(fabs(computed - expected) <= 1e-9 * fabs(expected)))
        fail_msg("%s at %g: %.13g, expected %.13g", name, angle, computed, expected);
}

static int status_of(fourlink_results *r, const char *name, double angle)
{
    fourlink_value v;

    return fourlink_results_value(r, name, FOURLINK_OPEN, angle, &v);
}

/* One line of values of the independent solver. */
static void check_row(fourlink_results *r, double angle, const double expected[7])
{
    static const char *const names[] = {"time", "omega2", "alpha2", "T_motor",
                                        "Ts",   "F12x",   "F12y"};
    int i;

    for (i = 0; i < 7; i++)
        check_value(r, names[i], angle, expected[i]);
}

TEST(test_run_up)
{
    static const double at_45[] = {0.105222531727,  11.70599690827, 43.49993530184,  19.66288364339,
                                   -2.087084007533, 126.7487020372, -0.2405524127144},
                        at_720[] = {1.168444468909, 11.25138487753, 40.48204147439, 23.55955819263,
                                    3.318537455433, 82.67895717049, 25.27059548348};
    fourlink_results *r = opened(LOADED MOTOR FLYWHEEL RUN_UP);
    double angle;

    check_row(r, 45, at_45);
    check_row(r, 720, at_720);
    assert_int_equal(problem_of(r).mode, FOURLINK_MODE_RUN_UP);
    assert_int_equal(problem_of(r).n_rows, 17);
    assert_int_equal(fourlink_results_end(r, FOURLINK_OPEN, &angle), FOURLINK_OK);
    assert_near(angle, 720, 0);
    /* reached between the rows, at the mean of the steady motion */
    assert_in_range(value_at(r, "run_up_time", 0) * 1e4, 900, 1000);
    assert_true(fabs(value_at(r, "energy_residual", 720)) < 1e-12);
    /* the torque that the shaft brings to the crank */
    assert_close(value_at(r, "Ts", 30),
                 value_at(r, "T_motor", 30) - 0.5 * value_at(r, "alpha2", 30), 1e-11);
    assert_close(value_at(r, "energy", 30),
                 0.5 * (0.5 + value_at(r, "J", 30)) * value_at(r, "omega2", 30) *
                     value_at(r, "omega2", 30),
                 1e-11);
    fourlink_results_free(r);
}

TEST(test_steady)
{
    static const double at_180[] = {0.233819683268,   14.02793279833, -5.890331291283,
                                    -0.2394239856987, 2.705741659943, 319.5615188388,
                                    36.51062537359};
    fourlink_results *r = opened(LOADED MOTOR FLYWHEEL STEADY);
    double max, min;

    check_row(r, 180, at_180);
    check_value(r, "period", 0, 0.5610716958147);
    check_value(r, "mean_speed", 0, 2 * M_PI / 0.5610716958147);
    assert_close(value_at(r, "steady_rate", 0), 4.48615e-05, 1e-6);
    max = value_at(r, "max(omega2)", 0);
    min = value_at(r, "min(omega2)", 0);
    assert_close(value_at(r, "mean_speed_textbook", 0), (max + min) / 2, 1e-9);
    assert_close(value_at(r, "fluctuation_exact", 0), (max - min) / value_at(r, "mean_speed", 0),
                 1e-9);
    /* beside it, the textbooks' from the turning moment at the mean speed */
    assert_close(
        value_at(r, "flywheel_fluctuation", 0),
        value_at(r, "energy_fluctuation", 0) / (0.5 * pow(value_at(r, "mean_speed", 0), 2)), 1e-12);
    assert_int_equal(status_of(r, "run_up_time", 0), FOURLINK_NO_SUCH_FACT);
    assert_int_equal(status_of(r, "stall_angle", 0), FOURLINK_NO_SUCH_FACT);
    fourlink_results_free(r);
}

TEST(test_ends)
{
    fourlink_results *r =
        opened(LOADED "[motor]\nstall_torque = 60 N m\nno_load_speed = 14 rad/s\n" FLYWHEEL RUN_UP);
    double angle = 0, values[64];
    fourlink_instant at;

    assert_int_equal(fourlink_results_end(r, FOURLINK_OPEN, &angle), FOURLINK_STALLS);
    assert_close(value_at(r, "stall_angle", 0), angle, 1e-15);
    assert_in_range(angle * 10, 2905, 2906);
    assert_int_equal(status_of(r, "omega2", 280), FOURLINK_OK);
    assert_int_equal(fourlink_results_row(r, FOURLINK_OPEN, 7, values, &at, NULL), FOURLINK_STALLS);
    assert_near(values[0], 315, 0);
    assert_true(isnan(at.row.crank.omega2) && isnan(at.row.time));
    assert_int_equal(fourlink_results_end(NULL, FOURLINK_OPEN, &angle), FOURLINK_NULL);
    assert_int_equal(fourlink_results_end(r, FOURLINK_OPEN, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_end(r, (fourlink_branch)0, &angle), FOURLINK_BAD_BRANCH);
    fourlink_results_free(r);

    r = opened(LOADED "[motor]\ntorque = -20 N m\n" FLYWHEEL
                      "[motion]\nmode = run-up\nto = 90 deg\n");
    assert_int_equal(fourlink_results_end(r, FOURLINK_OPEN, &angle), FOURLINK_DOES_NOT_START);
    assert_int_equal(status_of(r, "omega2", 45), FOURLINK_DOES_NOT_START);
    fourlink_results_free(r);

    r = opened(LOADED "[motor]\nstall_torque = 20 N m\nno_load_speed = 14 rad/s\n" FLYWHEEL STEADY);
    assert_int_equal(fourlink_results_end(r, FOURLINK_OPEN, &angle), FOURLINK_NO_STEADY);
    assert_int_equal(status_of(r, "mean_speed", 0), FOURLINK_NO_STEADY);
    assert_int_equal(status_of(r, "mean_torque", 0), FOURLINK_NO_STEADY);
    assert_int_equal(status_of(r, "max(omega2)", 0), FOURLINK_NO_STEADY);
    assert_int_equal(status_of(r, "mean(Ts)", 0), FOURLINK_NO_STEADY);
    assert_int_equal(status_of(r, "run_up_time", 0), FOURLINK_NO_SUCH_FACT);
    assert_int_equal(status_of(r, "K", 0), FOURLINK_NO_SUCH_FACT);
    fourlink_results_free(r);
}

/* A run-up that stalls below its steady motion has no facts of it, also where the rows end before it
** stalls; the steady motion is there by itself. */
TEST(test_steady_motion_that_is_not_reached)
{
    static const char *const names[] = {"mean_speed",        "mean_speed_textbook", "period",
                                        "fluctuation_exact", "steady_rate",         "run_up_time"};
    static const struct {
        double stall_torque;
        const char *motion;
        int ends; /* why it has no facts */
    } cases[] = {{65, "run-up\nfrom = 150 deg\nto = 870 deg", FOURLINK_STALLS},
                 {65, "run-up\nfrom = 150 deg\nto = 180 deg", FOURLINK_STALLS},
                 {65, "run-up\nfrom = 268 deg\nto = 270 deg", FOURLINK_DOES_NOT_START},
                 {70, "run-up\nfrom = 150 deg\nto = 870 deg", FOURLINK_OK},
                 {65, "run-up\nfrom = 100 deg\nto = 180 deg", FOURLINK_OK},
                 {65, "steady\nfrom = 150 deg\nto = 510 deg", FOURLINK_OK}};
    char deck[2000];
    size_t i, k;

    for (i = 0; i < COUNT(cases); i++) {
        int is_steady = cases[i].motion[0] == 's';
        fourlink_results *r;
        fourlink_value v;

        sprintf(deck,
                "%s[motor]\nstall_torque = %g N m\nno_load_speed = 14 rad/s\n" FLYWHEEL
                "[motion]\nmode = %s\ninterval = 45 deg\n",
                LOADED, cases[i].stall_torque, cases[i].motion);
        r = opened(deck);
        for (k = 0; k < COUNT(names) - (size_t)is_steady; k++) {
            v.value = 7;
            if (fourlink_results_value(r, names[k], FOURLINK_OPEN, 0, &v) != cases[i].ends)
                fail_msg("case %d: %s = %g", (int)i, names[k], v.value);
            assert_true((v.value == 7) == (cases[i].ends != FOURLINK_OK));
        }
        fourlink_results_free(r);
    }
}

/* The flywheel that is found gives the fluctuation, whatever its size. */
TEST(test_wanted_flywheel)
{
    static const double wanted[] = {1e-4, 0.01, 0.1, 0.5, 0.75};
    char deck[2000];
    size_t i;

    for (i = 0; i < COUNT(wanted); i++) {
        fourlink_results *r;
        double inertia;

        sprintf(deck, "%s[flywheel]\nfluctuation = %.17g\nexact = yes\n%s", LOADED MOTOR, wanted[i],
                STEADY);
        r = opened(deck);
        assert_close(value_at(r, "fluctuation_exact", 0), wanted[i], 1e-9);
        inertia = value_at(r, "flywheel_inertia", 0);
        fourlink_results_free(r);
        sprintf(deck, "%s[flywheel]\ninertia = %.17g kg m2\n%s", LOADED MOTOR, inertia, STEADY);
        r = opened(deck);
        assert_close(value_at(r, "fluctuation_exact", 0), wanted[i], 1e-8);
        fourlink_results_free(r);
    }
    /* without a flywheel it fluctuates less */
    sprintf(deck, "%s[flywheel]\nfluctuation = 2\nexact = yes\n%s", LOADED MOTOR, STEADY);
    {
        fourlink_results *r = opened(deck);

        assert_true(value_at(r, "fluctuation_exact", 0) < 1);
        assert_near(value_at(r, "flywheel_inertia", 0), 0, 0);
        fourlink_results_free(r);
    }
}

/* The rotor of the motor is there besides: the flywheel that is found gives the fluctuation, in a deck
** that has both, and a large rotor needs none. */
TEST(test_wanted_flywheel_beside_a_rotor)
{
    static const double ratios[] = {1, -5};
    const double rotor = 0.01;
    fourlink_results *r;
    fourlink_turning t;
    char deck[2000];
    double inertia, omega;
    size_t i;

    for (i = 0; i < COUNT(ratios); i++) {
        const double at_crank = ratios[i] * ratios[i] * rotor;
        char motor[200];

        sprintf(motor,
                "[motor]\nstall_torque = %.17g N m\nno_load_speed = %.17g rad/s\n"
                "inertia = %.17g kg m2\nratio = %.17g\n",
                120 / ratios[i], 14 * ratios[i], rotor, ratios[i]);
        sprintf(deck, "%s%s[flywheel]\nfluctuation = 0.1\nexact = yes\n%s", LOADED, motor, STEADY);
        r = opened(deck);
        assert_close(value_at(r, "fluctuation_exact", 0), 0.1, 1e-9);
        inertia = value_at(r, "flywheel_inertia", 0);
        omega = value_at(r, "mean_speed", 0);
        assert_true(omega > 0);
        assert_int_equal(fourlink_results_turning(r, FOURLINK_OPEN, &t), FOURLINK_OK);
        assert_near(t.inertia, inertia, 0);
        assert_close(t.fluctuation, t.energy_fluctuation / ((inertia + at_crank) * omega * omega),
                     1e-12);
        assert_near(value_at(r, "flywheel_fluctuation", 0), t.fluctuation, 0);
        /* what the shaft outside the crank takes of the motor's torque */
        assert_close(value_at(r, "T_motor", 30) - value_at(r, "Ts", 30),
                     (inertia + at_crank) * value_at(r, "alpha2", 30), 1e-9);
        fourlink_results_free(r);
        sprintf(deck, "%s%s[flywheel]\ninertia = %.17g kg m2\n%s", LOADED, motor, inertia, STEADY);
        r = opened(deck);
        assert_close(value_at(r, "fluctuation_exact", 0), 0.1, 1e-8);
        assert_near(value_at(r, "flywheel_inertia", 0), inertia, 0);
        fourlink_results_free(r);
        /* a rotor that has the inertia of both */
        sprintf(deck,
                "%s[motor]\nstall_torque = 120 N m\nno_load_speed = 14 rad/s\n"
                "inertia = %.17g kg m2\n[flywheel]\nfluctuation = 0.11\nexact = yes\n%s",
                LOADED, inertia + at_crank, STEADY);
        r = opened(deck);
        assert_near(value_at(r, "flywheel_inertia", 0), 0, 0);
        assert_close(value_at(r, "fluctuation_exact", 0), 0.1, 1e-8);
        assert_int_equal(fourlink_results_turning(r, FOURLINK_OPEN, &t), FOURLINK_OK);
        assert_true(t.inertia == 0 && t.fluctuation > 0.09);
        fourlink_results_free(r);
        /* a rotor, and no [flywheel] */
        sprintf(deck, "%s%s%s", LOADED, motor, STEADY);
        r = opened(deck);
        assert_int_equal(status_of(r, "flywheel_inertia", 0), FOURLINK_NO_SUCH_FACT);
        assert_true(value_at(r, "flywheel_fluctuation", 0) > 0);
        fourlink_results_free(r);
    }
}

/* A constant torque that balances the loads, at any mean speed; the exact fluctuation is not the
** textbooks'. */
TEST(test_balancing_motor)
{
    fourlink_results *r =
        opened(LOADED "[motor]\ntorque = constant\n[flywheel]\ninertia = 20 kg m2\n"
                      "[motion]\nmode = steady\nmean_speed = 12 rad/s\n");
    double exact, textbook;

    check_value(r, "mean_speed", 0, 12);
    assert_close(value_at(r, "period", 0), 2 * M_PI / 12, 1e-9);
    assert_close(value_at(r, "motor_torque", 0), value_at(r, "T_motor", 100), 1e-12);
    exact = value_at(r, "fluctuation_exact", 0);
    textbook = value_at(r, "flywheel_fluctuation", 0);
    assert_in_range(1e6 * fabs(exact / textbook - 1), 10, 30000);
    fourlink_results_free(r);
}

/* In FORTRAN 77 by the same names. */
TEST(test_fortran)
{
    const char deck[] = LOADED MOTOR FLYWHEEL STEADY;
    fourlink_results *handle = NULL;
    double value = 0, angle = 180;
    char message[80];
    int status, open = 1;

    flopen_(deck, &handle, &status, message, sizeof deck - 1, sizeof message);
    assert_int_equal(status, FOURLINK_OK);
    flval_(&handle, "omega2", &open, &angle, &value, &status, 6);
    assert_int_equal(status, FOURLINK_OK);
    assert_close(value, 14.02793279833, 1e-9);
    flval_(&handle, "period", &open, &angle, &value, &status, 6);
    assert_close(value, 0.5610716958147, 1e-9);
    flshut_(&handle);
}

/* Columns and facts of the actual motion are not those of a given one. */
/* A pump by a motor whose torque falls along a line, of which a third point may be given. */
static fourlink_results *open_with_points(const char *load, double torque, double no_load,
                                          double speed)
{
    char curve[200], contents[2000];

    snprintf(curve, sizeof curve, "%.17g rad/s %.17g N m, ", speed, torque * (1 - speed / no_load));
    snprintf(contents, sizeof contents,
             PUMP "%s[motor]\ncurve = 0 rad/s %.17g N m, %s%.17g rad/s 0 N m\n" FLYWHEEL STEADY,
             load, torque, speed > 0 ? curve : "", no_load);
    return opened(contents);
}

/* A point on a straight line changes nothing, though the speed turns back exactly there. */
TEST(test_speed_with_its_peak_at_a_point_of_the_curve)
{
    static const char *const names[] = {"mean_speed", "fluctuation_exact", "period"};
    double worst = 0;
    int compared = 0, i, j, k;

    for (i = 0; i < 40; i++) {
        const char *load;
        double torque, no_load;
        fourlink_results *line;

        begin_chance(66, i);
        torque = 80 + 200 * chance();
        no_load = 10 + 40 * chance();
        load = seldom(0.5) ? FORCE FAN : FORCE;
        line = open_with_points(load, torque, no_load, 0);
        for (j = 0; j < 16; j++) {
            double speed = value_at(line, j % 2 ? "max(omega2)" : "min(omega2)", 0);
            fourlink_results *points;

            if (!(speed < 0.999 * no_load))
                continue; /* the loads drive it */
            points = open_with_points(load, torque, no_load, speed * (1 + (j / 2 - 4) * 1e-16));

            for (k = 0; k < 3; k++, compared++)
                worst = fmax(worst,
                             fabs(value_at(points, names[k], 0) / value_at(line, names[k], 0) - 1));
            fourlink_results_free(points);
        }
        fourlink_results_free(line);
    }
    assert_true(compared > 1000);
    if (!(worst < 1e-9))
        fail_msg("differs by %g", worst);
}

/* Joints with a coefficient of 0 change nothing, also where the acceleration passes 0: there all of the torque is rounding
** error, which is no lock. */
TEST(test_friction_that_is_zero)
{
    double worst = 0, most = 0;
    int i, j;

    for (i = 0; i < 100; i++) {
        fourlink_results *r[2];
        double end[2], far, rod, speed;

        begin_chance(67, i);
        far = pow(10, 1 + 2 * chance());
        rod = 120 + 200 * chance();
        speed = 5 + 50 * chance();
        for (j = 0; j < 2; j++) {
            static char contents[2000];

            snprintf(
                contents, sizeof contents,
                "mechanism = slider-crank\n[crank]\nlength = 50 mm\nmass = 1 kg\ncg = (1, %.6g) m\n"
                "[rod]\nlength = %.6g mm\nmass = 1 kg\n[piston]\nmass = 1 kg\n"
                "%s[motion]\nmode = free\nspeed = %.6g rad/s\nturns = 20\n",
                far, rod, j ? "[friction]\nmu = 0\nradius = 5 mm\n" : "", speed);
            r[j] = opened(contents);
            assert_int_equal(fourlink_results_end(r[j], FOURLINK_OPEN, &end[j]), FOURLINK_OK);
        }
        for (j = 0; j <= 7200; j += 240) {
            speed = value_at(r[0], "omega2", j);
            worst = fmax(worst, fabs(value_at(r[1], "omega2", j) / speed - 1));
            most = fmax(most, speed);
        }
        fourlink_results_free(r[0]);
        fourlink_results_free(r[1]);
    }
    assert_true(most > 50);
    if (!(worst < 1e-9))
        fail_msg("differs by %g", worst);
}

TEST(test_given)
{
    static const char *const names[] = {"T_motor", "J", "energy", "energy_residual"};
    fourlink_results *r = opened(LOADED "[motion]\nspeed = 12 rad/s\n");
    double angle;
    size_t i;

    for (i = 0; i < 4; i++)
        assert_int_equal(status_of(r, names[i], 0), FOURLINK_NO_SUCH_NAME);
    assert_int_equal(status_of(r, "mean_speed", 0), FOURLINK_NO_SUCH_FACT);
    assert_int_equal(problem_of(r).mode, FOURLINK_MODE_GIVEN);
    assert_int_equal(fourlink_results_end(r, FOURLINK_OPEN, &angle), FOURLINK_OK);
    assert_near(angle, 360, 0);
    fourlink_results_free(r);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
