/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_inertia.c - the machine as one mass, against the torque of the nine equations and differences;
** torques of motors.
*/
#include "check.h"
#include "fourlink.h"

#define MACHINES 200

static void set_link(fourlink_link *link, uint64_t *seed)
{
    link->mass = uniform(seed, 0.1, 3);
    link->inertia = uniform(seed, 0.001, 0.1);
    link->cg.x = uniform(seed, -0.2, 0.3);
    link->cg.y = uniform(seed, -0.1, 0.1);
}

/* A machine of each kind in turn, whose crank turns fully. */
static fourlink_mechanism random_machine(uint64_t *seed, int i)
{
    static const fourlink_kind kinds[] = {FOURLINK_FOUR_BAR, FOURLINK_SLIDER_CRANK,
                                          FOURLINK_INVERTED_SLIDER_CRANK};
    fourlink_mechanism mechanism;
    fourlink_design d;

    memset(&d, 0, sizeof d);
    d.kind = kinds[i % 3];
    d.link[1].length = uniform(seed, 0.75, 0.85);
    d.link[2].length = uniform(seed, 0.1, 0.25);
    d.link[3].length = uniform(seed, 0.6, 0.7);
    d.link[4].length = d.kind == FOURLINK_FOUR_BAR ? uniform(seed, 0.5, 0.6) : 0;
    d.offset = uniform(seed, -0.05, 0.05);
    d.gravity.x = uniform(seed, -5, 5);
    d.gravity.y = uniform(seed, -10, 5);
    set_link(&d.link[2], seed);
    set_link(&d.link[3], seed);
    set_link(&d.link[4], seed);
    assert_int_equal(fourlink_prepare(&d, &mechanism), FOURLINK_OK);
    return mechanism;
}

static double torque(const fourlink_mechanism *m, double theta2, double omega2, double alpha2)
{
    fourlink_crank crank;
    fourlink_state state;
    fourlink_forces forces;

    crank.theta2 = theta2;
    crank.omega2 = omega2;
    crank.alpha2 = alpha2;
    assert_int_equal(fourlink_analyse(m, FOURLINK_OPEN, &crank, NULL, 0, &state, &forces),
                     FOURLINK_OK);
    return forces.Ts;
}

static double inertia_at(const fourlink_mechanism *m, double theta2, double *slope)
{
    fourlink_state state;
    double J = -1;

    assert_int_equal(fourlink_position(m, FOURLINK_OPEN, theta2, &state), FOURLINK_OK);
    assert_int_equal(fourlink_inertia(m, &state, &J, slope), FOURLINK_OK);
    return J;
}

/* Ts is affine in alpha2 and omega2^2; J' is the derivative of J. */
TEST(test_inertia)
{
    uint64_t seed = 18;
    int i;

    for (i = 0; i < MACHINES; i++) {
        fourlink_mechanism m = random_machine(&seed, i), light = m;
        double theta2 = uniform(&seed, 0, 6.28), omega2 = uniform(&seed, -20, 20), h = 1e-5;
        double slope, unused_slope, J = inertia_at(&m, theta2, &slope);
        double size = fabs(slope) + J, at_rest = torque(&m, theta2, 0, 0);

        assert_true(J > 0);
        assert_near(torque(&m, theta2, 0, 1) - at_rest, J, 1e-11 * (J + fabs(at_rest)));
        light.design.gravity.x = light.design.gravity.y = 0;
        assert_near(torque(&light, theta2, omega2, 0), 0.5 * slope * omega2 * omega2,
                    1e-11 * size * omega2 * omega2);
        assert_near((inertia_at(&m, theta2 + h, &unused_slope) -
                     inertia_at(&m, theta2 - h, &unused_slope)) /
                        (2 * h),
                    slope, 1e-7 * size);
    }
}

/* At rest the torque holds loads and weights. */
TEST(test_generalised_force)
{
    uint64_t seed = 81;
    int i, k;

    for (i = 0; i < MACHINES; i++) {
        fourlink_mechanism m = random_machine(&seed, i);
        fourlink_crank crank = {0, 0, 0};
        fourlink_load load[3];
        fourlink_forces forces;
        fourlink_state state;
        double Q;

        crank.theta2 = uniform(&seed, 0, 6.28);
        for (k = 0; k < 3; k++) {
            load[k].link = 2 + k;
            load[k].frame = k == 1 ? FOURLINK_FRAME_LINK : FOURLINK_FRAME_GROUND;
            load[k].force.x = uniform(&seed, -50, 50);
            load[k].force.y = uniform(&seed, -50, 50);
            load[k].at.x = uniform(&seed, -0.3, 0.3);
            load[k].at.y = uniform(&seed, -0.3, 0.3);
            load[k].torque = uniform(&seed, -5, 5);
        }
        assert_int_equal(fourlink_analyse(&m, FOURLINK_OPEN, &crank, load, 3, &state, &forces),
                         FOURLINK_OK);
        assert_int_equal(fourlink_generalised_force(&m, &state, load, 3, &Q), FOURLINK_OK);
        assert_near(Q, -forces.Ts_work, 1e-12 * (fabs(Q) + 100));
        load[1].link = 1;
        assert_int_equal(fourlink_generalised_force(&m, &state, load, 3, &Q), FOURLINK_BAD_LINK);
    }
}

TEST(test_bad_calls)
{
    uint64_t seed = 8;
    fourlink_mechanism m = random_machine(&seed, 0), raw;
    fourlink_state state;
    double J = 7;

    memset(&raw, 0, sizeof raw);
    assert_int_equal(fourlink_position(&m, FOURLINK_OPEN, 1, &state), FOURLINK_OK);
    assert_int_equal(fourlink_inertia(NULL, &state, &J, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_inertia(&m, NULL, &J, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_inertia(&m, &state, NULL, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_inertia(&raw, &state, &J, NULL), FOURLINK_BAD_KIND);
    assert_int_equal(fourlink_generalised_force(&m, NULL, NULL, 0, &J), FOURLINK_NULL);
    assert_int_equal(fourlink_generalised_force(&m, &state, NULL, 1, &J), FOURLINK_NULL);
    assert_near(J, 7, 0);
}

static double of_motor(const fourlink_motor *motor, double omega2)
{
    double T = -1e9;

    assert_int_equal(fourlink_motor_torque(motor, omega2, &T), FOURLINK_OK);
    return T;
}

TEST(test_motors)
{
    static const double speed[] = {0, 10, 12, 14.5}, at[] = {60, 80, 120, 0};
    fourlink_motor m;

    memset(&m, 0, sizeof m);
    assert_near(of_motor(&m, 3), 0, 0);
    m.ratio = 2;
    m.kind = FOURLINK_MOTOR_TORQUE;
    m.torque = -3;
    assert_near(of_motor(&m, 3), -6, 0);
    m.kind = FOURLINK_MOTOR_LINEAR;
    m.stall_torque = 120;
    m.no_load_speed = 14;
    assert_near(of_motor(&m, 0), 240, 0);
    assert_near(of_motor(&m, 7), 0, 0);
    assert_near(of_motor(&m, 10.5), -120, 1e-12); /* it brakes */
    m.kind = FOURLINK_MOTOR_POWER;
    m.power = 600;
    m.max_torque = 80;
    assert_near(of_motor(&m, -1), 160, 0);
    assert_near(of_motor(&m, 3.75), 160, 1e-12);
    assert_near(of_motor(&m, 7.5), 80, 1e-12);
    m.max_torque = 0.5;
    assert_near(of_motor(&m, 7.5), 1, 0);
    assert_near(of_motor(&m, 1200), 0.5, 1e-12);
    m.max_torque = -80;
    assert_near(of_motor(&m, -7.5), -80, 1e-12);
    assert_near(of_motor(&m, 7.5), -160, 0);
    m.kind = FOURLINK_MOTOR_CURVE;
    m.curve_speed = speed;
    m.curve_torque = at;
    m.n_curve = 4;
    assert_near(of_motor(&m, -2), 120, 0);
    assert_near(of_motor(&m, 5), 160, 1e-12);
    assert_near(of_motor(&m, 6), 240, 1e-12);
    assert_near(of_motor(&m, 20), 0, 0);
    /* Steffen's: no higher than the points */
    assert_true(of_motor(&m, 5.9) < 240 && of_motor(&m, 6.1) < 240 && of_motor(&m, 6.1) > 230);
    assert_near(of_motor(&m, 5 - 1e-9), of_motor(&m, 5 + 1e-9), 1e-6);
}

TEST(test_bad_motors)
{
    static const double falling[] = {0, 2, 2}, at[] = {1, 2, 3};
    fourlink_motor m;
    double T = 7;

    memset(&m, 0, sizeof m);
    assert_int_equal(fourlink_motor_torque(NULL, 1, &T), FOURLINK_NULL);
    assert_int_equal(fourlink_motor_torque(&m, 1, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_motor_torque(&m, NAN, &T), FOURLINK_BAD_NUMBER);
    m.kind = FOURLINK_MOTOR_TORQUE;
    assert_int_equal(fourlink_motor_torque(&m, 1, &T), FOURLINK_BAD_MOTOR); /* no ratio */
    m.ratio = 1;
    m.kind = FOURLINK_MOTOR_LINEAR;
    assert_int_equal(fourlink_motor_torque(&m, 1, &T), FOURLINK_BAD_MOTOR);
    m.kind = (fourlink_motor_kind)9;
    assert_int_equal(fourlink_motor_torque(&m, 1, &T), FOURLINK_BAD_MOTOR);
    m.kind = FOURLINK_MOTOR_CURVE;
    assert_int_equal(fourlink_motor_torque(&m, 1, &T), FOURLINK_BAD_MOTOR);
    m.curve_speed = falling;
    m.curve_torque = at;
    m.n_curve = 3;
    assert_int_equal(fourlink_motor_torque(&m, 1, &T), FOURLINK_BAD_MOTOR);
    m.n_curve = 1;
    assert_int_equal(fourlink_motor_torque(&m, 1, &T), FOURLINK_BAD_MOTOR);
    m.kind = FOURLINK_MOTOR_POWER;
    m.max_torque = 1;
    m.power = -1;
    assert_int_equal(fourlink_motor_torque(&m, 1, &T), FOURLINK_BAD_MOTOR);
    assert_near(T, 7, 0);
}

/* Numbers that are not finite, or make a torque that is not, give a status, and no torque. */
TEST(test_motors_out_of_range)
{
    static const double wrong[] = {NAN, INFINITY, -INFINITY, 2e30};
    static const fourlink_motor_kind kinds[] = {FOURLINK_MOTOR_TORQUE, FOURLINK_MOTOR_LINEAR,
                                                FOURLINK_MOTOR_CURVE, FOURLINK_MOTOR_POWER,
                                                FOURLINK_MOTOR_BALANCE};
    double speed[] = {0, 10, 12}, at[] = {60, 80, 120}, T = 7;
    fourlink_motor good, m;
    size_t i, k, n;

    memset(&good, 0, sizeof good);
    good.torque = 3;
    good.stall_torque = 120;
    good.no_load_speed = 14;
    good.power = 600;
    good.max_torque = 80;
    good.curve_speed = speed;
    good.curve_torque = at;
    good.n_curve = 3;
    good.ratio = 2;
    for (i = 0; i < 5; i++)
        for (k = 0; k < COUNT(wrong); k++) {
            double *const numbers[] = {&m.ratio, &m.torque,     &m.stall_torque, &m.no_load_speed,
                                       &m.power, &m.max_torque, &speed[2],       &at[0]};
            static const char *const kinds_of[] = {"01234", "04", "1", "1", "3", "3", "2", "2"};

            for (n = 0; n < COUNT(numbers); n++) {
                int is_used = strchr(kinds_of[n], '0' + (int)i) != NULL;

                m = good;
                m.kind = kinds[i];
                *numbers[n] = wrong[k];
                T = 7;
                assert_int_equal(fourlink_motor_torque(&m, 1, &T),
                                 is_used ? FOURLINK_BAD_NUMBER : FOURLINK_OK);
                assert_true(isfinite(T) && (T == 7) == is_used);
                speed[2] = 12;
                at[0] = 60;
            }
        }
    m = good;
    m.kind = FOURLINK_MOTOR_LINEAR;
    m.no_load_speed = 1e-300;
    T = 7;
    assert_int_equal(fourlink_motor_torque(&m, 1e30, &T), FOURLINK_BAD_NUMBER);
    m.kind = FOURLINK_NO_MOTOR;
    m.ratio = NAN;
    assert_near(T, 7, 0);
    assert_near(of_motor(&m, 1), 0, 0);
}

int main(void)
{
    return run_all_tests(NULL);
}
