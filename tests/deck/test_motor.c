/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_motor.c - motors, flywheels and the modes of motion in decks: what they mean, and each mistake
** with its message and line.
*/
#include "outcome.h"

/* Seven lines; [motion] is open. */
#define PUMP                     \
    "mechanism = slider-crank\n" \
    "[crank]\n"                  \
    "length = 50 mm\n"           \
    "inertia = 0.002 kg m2\n"    \
    "[rod]\n"                    \
    "length = 200 mm\n"          \
    "[motion]\n"

#define RUN_UP PUMP "mode = run-up\n"
#define STEADY PUMP "mode = steady\n"
#define LINE "[motor]\nstall_torque = 120 N m\nno_load_speed = 14 rad/s\n"
#define FLYWHEEL "[flywheel]\ninertia = 0.5 kg m2\n"

static const double turn = 2 * M_PI / 60;

TEST(test_modes)
{
    deck d;

    read_accepted(PUMP "speed = 3\n", NULL, &d);
    assert_int_equal(d.mode.kind, MODE_GIVEN);
    assert_int_equal(d.machine.motor.kind, FOURLINK_NO_MOTOR);
    flk_deck_free(&d);
    read_accepted(PUMP "mode = given\nturns = 2\nspeed = 3 rad/s\n", NULL, &d);
    assert_near(d.motion.to, 720, 0);
    flk_deck_free(&d);
    read_accepted(PUMP "mode = free\nspeed = -3 rad/s\n", NULL, &d);
    assert_int_equal(d.mode.kind, MODE_FREE);
    assert_near(d.motion.speed, -3, 0);
    assert_near(d.motion.to, -360, 0);
    flk_deck_free(&d);
    read_accepted(RUN_UP "from = 10 deg\nturns = 2.5\n" LINE FLYWHEEL, NULL, &d);
    assert_int_equal(d.mode.kind, MODE_RUN_UP);
    assert_near(d.motion.to, 910, 0);
    assert_near(d.mode.turns, 2.5, 0);
    assert_near(d.machine.flywheel, 0.5, 0);
    flk_deck_free(&d);
    read_accepted(PUMP "mode = run-up\nrows = time\ntime_step = 10 ms\nduration = 2 s\n" LINE, NULL,
                  &d);
    assert_string_equal(d.over->name, "time");
    assert_near(d.mode.time_step, 0.01, 1e-18);
    assert_near(d.mode.duration, 2, 0);
    flk_deck_free(&d);
    read_accepted(STEADY "mean_speed = -60 rpm\n[motor]\ntorque = constant\n", NULL, &d);
    assert_int_equal(d.machine.motor.kind, FOURLINK_MOTOR_BALANCE);
    assert_close(d.mode.mean_speed, -60 * turn, 1e-15);
    assert_near(d.motion.to, -360, 0);
    flk_deck_free(&d);
}

TEST(test_motors)
{
    deck d;

    read_accepted(RUN_UP LINE "inertia = 3 kg cm2\nratio = 20\n", NULL, &d);
    assert_int_equal(d.machine.motor.kind, FOURLINK_MOTOR_LINEAR);
    assert_near(d.machine.motor.stall_torque, 120, 0);
    assert_near(d.machine.motor.no_load_speed, 14, 0);
    assert_close(d.machine.motor.inertia, 3e-4, 1e-15);
    assert_near(d.machine.motor.ratio, 20, 0);
    flk_deck_free(&d);
    read_accepted(RUN_UP "[motor]\ntorque = -5 N m\n", NULL, &d);
    assert_int_equal(d.machine.motor.kind, FOURLINK_MOTOR_TORQUE);
    assert_near(d.machine.motor.torque, -5, 0);
    assert_near(d.machine.motor.ratio, 1, 0);
    assert_near(d.motion.to, -360, 0); /* where the motor turns it */
    flk_deck_free(&d);
    read_accepted(RUN_UP "[motor]\nratio = -2\npower = 2 kW\nmax_torque = 30 N m\n", NULL, &d);
    assert_int_equal(d.machine.motor.kind, FOURLINK_MOTOR_POWER);
    assert_near(d.machine.motor.power, 2000, 0);
    assert_near(d.machine.motor.max_torque, 30, 0);
    assert_near(d.motion.to, -360, 0);
    flk_deck_free(&d);
    read_accepted(RUN_UP "[motor]\ncurve = 0 rpm 5 N m, 1000 rpm 6 N m, 1500 rpm 0 N m\n", NULL,
                  &d);
    assert_int_equal(d.machine.motor.kind, FOURLINK_MOTOR_CURVE);
    assert_int_equal(d.machine.motor.n_curve, 3);
    assert_close(d.machine.motor.curve_speed[1], 1000 * turn, 1e-15);
    assert_near(d.machine.motor.curve_torque[1], 6, 0);
    assert_near(d.motion.to, 360, 0);
    flk_deck_free(&d);
    read_accepted(RUN_UP "[motor]\ncurve = 0 rpm 6 N m, 1500 rpm -6 N m\n", NULL, &d);
    assert_near(d.motion.to, 360, 0); /* of two torques as large, the first */
    flk_deck_free(&d);
    read_accepted(RUN_UP "[motor]\ncurve = file motor.csv rpm N m\n", "0 5\n1500 0\n", &d);
    assert_int_equal(d.machine.motor.n_curve, 2);
    flk_deck_free(&d);
    read_accepted(RUN_UP "[motor]\ncurve = file motor.csv 1/min N m\n", "0 5\n1500 0\n", &d);
    assert_near(d.machine.motor.curve_speed[1], 50 * PI, 1e-12);
    flk_deck_free(&d);
    read_accepted(RUN_UP "[motor]\ncurve = file motor.csv\n", "n [1/min];T [N m]\n0;5\n1500;0\n",
                  &d);
    assert_near(d.machine.motor.curve_speed[1], 50 * PI, 1e-12);
    flk_deck_free(&d);
}

/* Any part that moves with the crank gives the machine its inertia. */
TEST(test_parts_with_inertia)
{
    static const struct {
        int link; /* 0: none */
        const char *part;
    } parts[] = {{2, "inertia = 1 kg m2\n"},
                 {2, "mass = 1 kg\ncg = 1 mm\n"},
                 {2, "mass = 1 kg\ncg = (0, 1) mm\n"},
                 {3, "mass = 1 kg\n"},
                 {3, "inertia = 1 kg m2\n"},
                 {4, "mass = 1 kg\n"},
                 {4, "inertia = 1 kg m2\n"},
                 {0, "[motor]\ntorque = 1 N m\ninertia = 1 kg m2\n"},
                 {0, FLYWHEEL}};
    char contents[400];
    size_t i;
    deck d;

    for (i = 0; i < COUNT(parts); i++) {
        const char *part[5] = {"", "", "", "", ""};

        part[parts[i].link] = parts[i].part;
        sprintf(contents,
                "mechanism = four-bar\n[motion]\nmode = free\nspeed = 3 rad/s\n[ground]\n"
                "length = 80 mm\n[crank]\nlength = 20 mm\n%s[coupler]\nlength = 66 mm\n%s"
                "[rocker]\nlength = 56 mm\n%s%s",
                part[2], part[3], part[4], part[0]);
        read_accepted(contents, NULL, &d);
        flk_deck_free(&d);
    }
}

TEST(test_exact_flywheel)
{
    deck d;

    read_accepted(STEADY LINE "[flywheel]\nfluctuation = 2 %\nexact = yes\n", NULL, &d);
    assert_near(d.mode.fluctuation, 0.02, 0);
    assert_near(d.machine.flywheel, 0, 0);
    flk_deck_free(&d);
    read_accepted(PUMP "speed = 3 rad/s\n[flywheel]\nfluctuation = 2 %\n", NULL, &d);
    assert_near(d.mode.fluctuation, 0, 0);
    flk_deck_free(&d);
}

#define AGAINST(what) "the range runs against the " what ": change the sign of one of them"
#define NOT_GIVEN(key, mode) "'" key "' is for a given motion: mode = " mode " computes it"

static const struct {
    const char *contents;
    long line;
    const char *message;
} mistaken[] = {
    {PUMP LINE, 8,
     "the motion is given, so that a motor does nothing: [motion] needs mode = free, run-up or "
     "steady"},
    {PUMP "mode = stedy\n" LINE, 8,
     "expected given, free, run-up or steady, not 'stedy'; did you mean 'steady'?"},
    {RUN_UP "[motor]\nratio = 3\n", 9,
     "[motor] needs a torque, a stall_torque with no_load_speed, a curve, or a power with "
     "max_torque"},
    {RUN_UP LINE "torque = 3 N m\n", 9, "give only one of torque, stall_torque, curve and power"},
    {RUN_UP LINE "torque = constant\n", 9,
     "give only one of torque, stall_torque, curve and power"},
    {RUN_UP "[motor]\nstall_torque = 120 N m\n", 10,
     "'stall_torque' needs 'no_load_speed', the two ends of the motor's line"},
    {RUN_UP "[motor]\nno_load_speed = 100 rpm\n", 10,
     "'no_load_speed' needs 'stall_torque', the two ends of the motor's line"},
    {RUN_UP "[motor]\nstall_torque = 0 N m\nno_load_speed = 100 rpm\n", 10,
     "the stall_torque must not be 0"},
    {RUN_UP "[motor]\nstall_torque = 3 N m\nno_load_speed = -100 rpm\n", 11,
     "the no_load_speed must have the sign of the stall_torque"},
    {RUN_UP "[motor]\npower = 3 kW\n", 10,
     "'power' needs 'max_torque', or the torque would be infinite at rest"},
    {RUN_UP "[motor]\npower = -3 kW\nmax_torque = 3 N m\n", 10,
     "the power must be positive, not -3 kW"},
    {RUN_UP "[motor]\npower = 3 kW\nmax_torque = 0 N m\n", 11, "the max_torque must not be 0"},
    {RUN_UP LINE "ratio = 0\n", 12, "the ratio must not be 0"},
    {RUN_UP LINE "inertia = -1 kg m2\n", 12, "the inertia must not be negative: -1 kg m2"},
    {RUN_UP "[motor]\ntorque = 3 N\n", 10, "'3 N' is a force; expected a torque, such as 0.5 N m"},
    {RUN_UP "[motor]\ntorque = steady\n", 10, "expected a torque, such as 0.5 N m, not 'steady'"},
    {RUN_UP "[motor]\nstall_torque = 3 N m\nno_load_speed = 100 m/s\n", 11,
     "'100 m/s' is a speed; expected an angular speed, such as 1000 rpm"},
    {RUN_UP "[motor]\ncurve = 5 N m\n", 10,
     "expected two or more points of speed and torque, such as 0 rpm 5 N m, 1500 rpm 0 N m, not "
     "'5 N m'"},
    {RUN_UP "[motor]\ncurve = 0 rpm 5 N m, 100 rpm 4 N m, 100 rpm 3 N m\n", 10,
     "the speeds of the motor's curve do not rise"},
    {RUN_UP "[motor]\ncurve = 0 rpm 5 N m, 100 rpm 4 N m, 50 rpm 3 N m\n", 10,
     "the speeds of the motor's curve do not rise"},
    {RUN_UP "[motor]\ncurve = 0 deg 5 N m, 100 deg 4 N m\n", 10,
     "'0 deg 5 N m, 100 deg 4 N m' is an angle; expected an angular speed, such as 1000 rpm"},
    {RUN_UP "[motor]\ntorque = constant\n", 10,
     "torque = constant balances the loads over a cycle: it needs mode = steady"},
    {STEADY "[motor]\ntorque = constant\n", 10,
     "torque = constant does not determine the speed: [motion] needs a mean_speed"},
    {STEADY "mean_speed = 100 rpm\n" LINE, 9,
     "a mean_speed needs [motor] torque = constant, which balances the loads at any speed"},
    {PUMP "mean_speed = 100 rpm\n", 8,
     "a mean_speed needs [motor] torque = constant, which balances the loads at any speed"},
    {STEADY "mean_speed = 0 rpm\n[motor]\ntorque = constant\n", 9, "the mean_speed must not be 0"},
    {STEADY "speed = 3 rad/s\n" LINE, 9,
     "the speed of the steady motion is computed: give a mean_speed with [motor] torque = "
     "constant, or a motor that has a speed"},
    {RUN_UP "speed = 3 rad/s\n" LINE, 9,
     "a run-up starts from rest: for a motion from this speed, mode = free"},
    {RUN_UP "acceleration = 3 rad/s2\n" LINE, 9, NOT_GIVEN("acceleration", "run-up")},
    {PUMP "mode = free\nrun_up = 30 deg\n" LINE, 9, NOT_GIVEN("run_up", "free")},
    {STEADY "hold = yes\n" LINE, 9, NOT_GIVEN("hold", "steady")},
    {STEADY "at = 30 deg\n" LINE, 9, NOT_GIVEN("at", "steady")},
    {RUN_UP "turns = 0\n" LINE, 9, "the turns must not be 0"},
    {RUN_UP "turns = 2\nto = 90 deg\n" LINE, 9, "give either 'to' or 'turns', not both"},
    {PUMP "mode = free\nspeed = 3 rad/s\nturns = -2\n", 10,
     "the range runs against the speed at its beginning: swap 'from' and 'to'"},
    {STEADY "to = 360 deg\n[motor]\nstall_torque = -120 N m\nno_load_speed = -14 rad/s\n", 9,
     AGAINST("motor")},
    {STEADY "turns = -1\n" LINE, 9, AGAINST("motor")},
    {STEADY "turns = 1\n" LINE "ratio = -2\n", 9, AGAINST("motor")},
    {STEADY "mean_speed = 3 rad/s\nturns = -1\n[motor]\ntorque = constant\n", 10,
     AGAINST("mean_speed")},
    {PUMP "speed = 3 rad/s\nrows = time\ntime_step = 1 s\nduration = 3 s\n", 9,
     "rows by time need mode = free or run-up"},
    {STEADY "rows = time\ntime_step = 1 s\nduration = 3 s\n" LINE, 9,
     "rows by time need mode = free or run-up"},
    {RUN_UP "rows = time\nduration = 3 s\n" LINE, 9, "rows by time need 'time_step'"},
    {RUN_UP "rows = time\ntime_step = 3 s\n" LINE, 9, "rows by time need 'duration'"},
    {RUN_UP "rows = time\ntime_step = 1 mm\nduration = 3 s\n" LINE, 10,
     "'1 mm' is a length; expected a time, such as 2.5 s"},
    {RUN_UP "rows = time\ntime_step = 0 s\nduration = 3 s\n" LINE, 10,
     "the time_step must be positive, not 0 s"},
    {RUN_UP "rows = time\ntime_step = 1e-6 s\nduration = 3 s\n" LINE, 11,
     "more than 1,000,000 rows by time (3e6): give a larger time_step or a shorter duration"},
    {RUN_UP "time_step = 1 s\n" LINE, 9, "'time_step' is for rows by time: rows = time"},
    {RUN_UP "duration = 1 s\n" LINE, 9, "'duration' is for rows by time: rows = time"},
    {RUN_UP "rows = time\ntime_step = 1 s\nduration = 3 s\ninterval = 5 deg\n" LINE, 12,
     "'interval' is for rows by angle; rows by time have time_step and duration"},
    {RUN_UP "rows = time\ntime_step = 1 s\nduration = 3 s\n" LINE "[friction]\nguide = 0.1\n", 9,
     "rows by time allow the machine to swing back, which friction does not: rows by angle, or no "
     "[friction]"},
    {RUN_UP LINE "[flywheel]\nfluctuation = 2 %\n", 13,
     "the actual motion needs the inertia of the flywheel, or exact = yes to find it from the "
     "fluctuation"},
    {RUN_UP LINE FLYWHEEL "fluctuation = 2 %\n", 13,
     "give either the fluctuation or the inertia: the other follows"},
    {RUN_UP LINE "[flywheel]\nfluctuation = 2 %\nexact = yes\n", 14,
     "an exact fluctuation is one of the actual motion: [motion] needs mode = steady"},
    {STEADY LINE FLYWHEEL "exact = yes\n", 14,
     "'exact' needs a fluctuation, for which the flywheel is found"},
    {"mechanism = slider-crank\n[crank]\nlength = 50 mm\nmass = 3 kg\n[rod]\nlength = 200 mm\n"
     "[motion]\nmode = free\nspeed = 3 rad/s\n",
     8, "nothing that moves has a mass or a moment of inertia: the actual motion needs one"},
};

TEST(test_mistakes)
{
    size_t i;

    for (i = 0; i < COUNT(mistaken); i++)
        check_mistake(mistaken[i].contents, NULL, mistaken[i].line, mistaken[i].message);
}

int main(void)
{
    return run_all_tests(NULL);
}
