/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_crossing.c - where a column has a value: against a scan in small steps, and against angles that
** are known.
*/
#include "check.h"
#include "fourlink.h"

#define ROCKER                                                                                   \
    "mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\nmass = 1 "         \
    "kg\nuniform = yes\n"                                                                        \
    "[coupler]\nlength = 66 mm\nmass = 0.3 kg\nuniform = yes\n[rocker]\nlength = 56 mm\nmass = " \
    "0.5 kg\n"                                                                                   \
    "uniform = yes\n"
#define SPEED "[motion]\nspeed = 10 rad/s\ninterval = 10 deg\n"
#define MOST 100
#define SCAN 36000

static fourlink_results *opened(const char *deck)
{
    fourlink_results *r = NULL;
    fourlink_mistake mistake;
    fourlink_source source;

    memset(&source, 0, sizeof source);
    source.text = deck;
    source.length = strlen(deck);
    if (fourlink_results_open(&source, 1, &r, &mistake, NULL) != FOURLINK_OK)
        fail_msg("%s", mistake.message);
    return r;
}

static double value_at(fourlink_results *r, const char *column, fourlink_branch branch,
                       double angle)
{
    fourlink_value v;

    return fourlink_results_value(r, column, branch, angle, &v) == FOURLINK_OK ? v.value : NAN;
}

static unsigned long crossings(fourlink_results *r, const char *column, fourlink_branch branch,
                               double value, double angles[MOST])
{
    unsigned long n = 0;

    assert_int_equal(fourlink_results_crossings(r, column, branch, value, MOST, angles, &n),
                     FOURLINK_OK);
    assert_true(n <= MOST);
    return n;
}

/* The same number of them as changes of sign in small steps, each within its step; the column has the
** value there. */
static void check_scan(fourlink_results *r, const char *column, fourlink_branch branch,
                       const double values[SCAN + 1], double share)
{
    double angles[MOST], least = values[0], most = values[0], level, jump;
    unsigned long n, k = 0;
    int i;

    for (i = 0; i < SCAN; i++) {
        least = fmin(least, values[i]);
        most = fmax(most, values[i]);
    }
    level = least + share * (most - least);
    jump = 0.05 * (most - least);
    n = crossings(r, column, branch, level, angles);
    for (i = 1; i <= SCAN; i++) {
        double angle = 360.0 * i / SCAN, last = values[i - 1] - level, now = values[i] - level;

        if ((last < 0) == (now < 0) || fabs(now - last) > jump)
            continue;
        assert_true(k < n);
        assert_true(angles[k] >= angle - 360.0 / SCAN - 1e-9 && angles[k] <= angle + 1e-9);
        assert_near(value_at(r, column, branch, angles[k]), level, 1e-9 * (most - least));
        k++;
    }
    assert_int_equal(k, n);
}

TEST(test_against_scan)
{
    static const double shares[] = {0.03, 0.31, 0.5, 0.62, 0.97};
    enum { COLUMNS = 6 };
    static const char *const columns[COLUMNS] = {"theta4", "omega4", "alpha3", "Ts", "F34", "mu"};
    static const char load[] = ROCKER SPEED
        "[load L]\nlink = rocker\ntorque = 5 N m\nfrom = 100 deg\nto = 200 deg\n"
        "[load D]\nlink = crank\nover = theta2\ntorque = 0 deg 0.1 N m, 90 deg 0.9 N "
        "m, 200 deg -0.4 N m\n[table]\ncolumns = theta4, omega4, alpha3, Ts, F34, mu\n";
    static const fourlink_branch branches[] = {FOURLINK_OPEN, FOURLINK_CROSSED};
    static double values[COLUMNS][SCAN + 1];
    fourlink_results *r = opened(load);
    double row[COLUMNS];
    size_t i, j, b, k;

    for (b = 0; b < 2; b++) {
        for (k = 0; k <= SCAN; k++) {
            assert_int_equal(
                fourlink_results_at(r, branches[b], 360.0 * (double)k / SCAN, row, NULL, NULL),
                FOURLINK_OK);
            for (i = 0; i < COLUMNS; i++)
                values[i][k] = row[i];
        }
        for (i = 0; i < COLUMNS; i++)
            for (j = 0; j < sizeof shares / sizeof *shares; j++)
                check_scan(r, columns[i], branches[b], values[i], shares[j]);
    }
    fourlink_results_free(r);
}

/* A column that passes through infinity has no value there. Beside a pole its reciprocal is continuous: a
** scan looks for changes of sign of that where the column is large, and of the column elsewhere. */
static int crosses(double last, double now, double level)
{
    if (fmin(fabs(last), fabs(now)) > fabs(level) / 10)
        return (1 / last < 1 / level) != (1 / now < 1 / level);
    return (last < level) != (now < level);
}

TEST(test_poles)
{
    static const char *const columns[] = {"mechanical_advantage", "I13x", "I24x"};
    static const double levels[] = {-12, -3.1, -0.7, 0.05, 0.9, 3, 12};
    fourlink_results *r = opened(ROCKER SPEED);
    static double values[SCAN + 1];
    int i, c, l, poles = 0, found = 0;

    for (c = 0; c < 3; c++) {
        for (i = 0; i <= SCAN; i++)
            values[i] = value_at(r, columns[c], FOURLINK_OPEN, 360.0 * i / SCAN + 0.0005);
        for (l = 0; l < 7; l++) {
            double angles[MOST];
            unsigned long n = crossings(r, columns[c], FOURLINK_OPEN, levels[l], angles), k = 0;

            for (i = 1; i <= SCAN; i++) {
                double last = values[i - 1], now = values[i];

                poles += last * now < 0 && fmin(fabs(last), fabs(now)) > 1;
                if (!crosses(last, now, levels[l]))
                    continue;
                assert_true(k < n);
                assert_near(angles[k], 360.0 * i / SCAN + 0.0005, 360.0 / SCAN + 1e-9);
                k++;
            }
            assert_int_equal(k, n);
            found += (int)n;
        }
    }
    assert_true(poles > 20 && found > 20);
    fourlink_results_free(r);
}

/* The instant centre I13 is where the lines of crank and rocker meet:
**
**    I13 = d sin(theta4) / sin(theta4 - theta2) (cos(theta2), sin(theta2))
**
** so that I13x has a value w where d sin(theta4) cos(theta2) - w sin(theta4 - theta2) changes its sign, which has no poles.
** Crank and rocker are parallel close to 90 deg, where I13x is 0: its samples can have one sign on both sides of the pole.
*/
static double beyond(fourlink_results *r, fourlink_branch branch, double w, double d, double angle)
{
    double theta2 = angle * DEG, theta4 = value_at(r, "theta4", branch, angle) * DEG;

    return d * sin(theta4) * cos(theta2) - w * sin(theta4 - theta2);
}

static int count_beside_poles(fourlink_results *r, fourlink_branch branch, double w, double d)
{
    const double step = 0.2;
    double angles[MOST], last = beyond(r, branch, w, d, 0), now;
    unsigned long n = crossings(r, "I13x", branch, w, angles), k;
    int j, passed = 0;

    for (j = 1; j <= 360 / step; j++, last = now) {
        now = beyond(r, branch, w, d, j * step);
        if (!(last * now < 0))
            continue;
        for (k = 0; k < n && fabs(angles[k] - (j - 0.5) * step) > 0.5 * step + 1e-6; k++)
            ;
        if (k == n)
            fail_msg("I13x = %.12g is not found between %g and %g deg", w, (j - 1) * step,
                     j * step);
        passed++;
    }
    return passed;
}

TEST(test_beside_poles)
{
    uint64_t seed = 12;
    int i, passed = 0;

    for (i = 0; i < some_of(1000); i++) {
        double parallel = (90 + pow(10, uniform(&seed, -5, 0.7)) * (i % 2 ? -1 : 1)) * DEG;
        double a = uniform(&seed, 0.1, 0.4), c = uniform(&seed, 0.6, 1.5), d = 1, b;
        double w = pow(10, uniform(&seed, -3, 2)) * (uniform(&seed, -1, 1) < 0 ? -1 : 1);
        fourlink_results *r;
        char deck[400];

        b = hypot(d + (c - a) * cos(parallel), (c - a) * sin(parallel));
        snprintf(deck, sizeof deck,
                 "mechanism = four-bar\n[ground]\nlength = %.17g m\n[crank]\n"
                 "length = %.17g m\n[coupler]\nlength = %.17g m\n[rocker]\n"
                 "length = %.17g m\n[motion]\nspeed = 1 rad/s\n[units]\nlength = m\n"
                 "[table]\ncolumns = I13x, theta4\n",
                 d, a, b, c);
        r = opened(deck);
        passed += count_beside_poles(r, FOURLINK_OPEN, w, d);
        passed += count_beside_poles(r, FOURLINK_CROSSED, w, d);
        fourlink_results_free(r);
    }
    assert_true(passed > 2 * i);
}

/* Beside a change point a force turns by more than half a turn within a tenth of a degree.  The angles
** are those of a scan in steps of 0.001 deg. */
TEST(test_direction_beside_change_point)
{
    fourlink_results *r =
        opened("mechanism = four-bar\n[crank]\nlength = 0.925\nmass = 1 kg\nuniform = yes\n"
               "[coupler]\nlength = 1.029\nmass = 2 kg\nuniform = yes\n[rocker]\nlength = 1.712\n"
               "mass = 1 kg\nuniform = yes\n[ground]\nlength = 1.6142\n" SPEED);
    double at[MOST];

    assert_int_equal(crossings(r, "F12_dir", FOURLINK_OPEN, 144, at), 2);
    assert_near(at[0], 6.8855, 0.0005);
    assert_near(at[1], 329.1995, 0.0005);
    assert_int_equal(crossings(r, "F12_dir", FOURLINK_OPEN, 43.2, at), 2);
    assert_near(at[0], 6.9245, 0.0005);
    assert_near(at[1], 209.7015, 0.0005);
    fourlink_results_free(r);
}

/* theta4 is at its limit where crank and coupler are in one line: a touch, at which omega4 is 0. */
TEST(test_touch)
{
    fourlink_results *r = opened(ROCKER SPEED);
    double at[MOST], still[MOST], limit;
    unsigned long k;

    assert_int_equal(crossings(r, "omega4", FOURLINK_OPEN, 0, still), 2);
    for (k = 0; k < 2; k++) {
        limit = value_at(r, "theta4", FOURLINK_OPEN, still[k]);
        assert_int_equal(crossings(r, "theta4", FOURLINK_OPEN, limit, at), 1);
        assert_near(at[0], still[k], 1e-4);
        assert_int_equal(crossings(r, "theta4", FOURLINK_OPEN, limit + (k ? 1e-4 : -1e-4), at), 0);
        assert_int_equal(crossings(r, "theta4", FOURLINK_OPEN, limit + (k ? -1e-4 : 1e-4), at), 2);
    }
    fourlink_results_free(r);
}

/* A jump is none: of a load within angles, of a force through infinity, of an angle over 180 deg. */
TEST(test_jumps)
{
    fourlink_results *r =
        opened("mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 "
               "mm\n[coupler]\nlength = 66 mm\n"
               "[rocker]\nlength = 56 mm\n" SPEED
               "[load]\nlink = crank\ntorque = -4 N m\nfrom = 90 deg\nto = 270 deg\n");
    double at[MOST];

    assert_int_equal(crossings(r, "Ts", FOURLINK_OPEN, 2, at), 0);
    fourlink_results_free(r);
    r = opened("mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 mm\n" SPEED
               "[load]\nlink = piston\nforce = -10 N\n");
    /* the advantage changes its sign at both dead centres, and not through 0 */
    assert_int_equal(crossings(r, "mechanical_advantage", FOURLINK_OPEN, 0.1, at), 0);
    assert_int_equal(crossings(r, "x", FOURLINK_OPEN, 0, at), 1); /* 360 deg is 0 deg again */
    assert_near(at[0], 0, 1e-9);
    fourlink_results_free(r);
    r = opened(
        "mechanism = four-bar\n[ground]\nlength = 30 mm\n[crank]\nlength = 60 mm\n[coupler]\n"
        "length = 60 mm\n[rocker]\nlength = 60 mm\n" SPEED);
    assert_int_equal(crossings(r, "theta4", FOURLINK_OPEN, 180, at), 1);
    assert_int_equal(crossings(r, "theta4", FOURLINK_OPEN, 0, at), 1);
    fourlink_results_free(r);
}

/* A revolution of a motion that repeats ends with its first row, which counts once; one that slows down
** does not. */
TEST(test_first_row)
{
#define MACHINE                                                                                \
    ROCKER                                                                                     \
    "[motor]\nstall_torque = 9 N m\nno_load_speed = 14 rad/s\n[flywheel]\ninertia = 1 kg m2\n" \
    "[load]\nlink = crank\ntorque = -2 N m\n[motion]\nmode = "
    static const char *const decks[] = {ROCKER SPEED, MACHINE "steady\n",
                                        MACHINE "free\nspeed = 9 rad/s\nturns = 1\n"};
    double at[MOST];
    int i;

    for (i = 0; i < 3; i++) {
        fourlink_results *r = opened(decks[i]);
        double first = value_at(r, "theta4", FOURLINK_OPEN, 0);

        assert_int_equal(crossings(r, "theta4", FOURLINK_OPEN, first, at), i < 2 ? 2 : 3);
        assert_near(at[0], 0, 1e-9);
        assert_true(at[1] > 10 && at[1] < 350);
        fourlink_results_free(r);
    }
#undef MACHINE
}

/* Each turn has its own. */
TEST(test_turns)
{
    fourlink_results *r = opened(
        ROCKER "[motion]\nspeed = 10 rad/s\nfrom = -90 deg\nto = 1710 deg\ninterval = 10 deg\n");
    double at[MOST];
    unsigned long n = crossings(r, "theta4", FOURLINK_OPEN, 120, at), k;

    assert_int_equal(n, 10);
    for (k = 2; k < n; k++)
        assert_near(at[k] - at[k - 2], 360, 1e-9);
    fourlink_results_free(r);
}

/* Where a column that is alone of its quantity passes 0 just before or behind the place at which each turn begins,
** it does so in all turns. */
TEST(test_beside_turns)
{
    const char *format =
        ROCKER "[gravity]\nacceleration = 0\n[motion]\nspeed = 10 rad/s\nfrom = %.17g deg\n"
               "to = %.17g deg\n[table]\ncolumns = Ts\n";
    double zeros[MOST], at[MOST], beside, from;
    char deck[1000];
    fourlink_results *r;
    unsigned long n, i, k;

    snprintf(deck, sizeof deck, format, 0.0, 360.0);
    r = opened(deck);
    n = crossings(r, "Ts", FOURLINK_OPEN, 0, zeros);
    fourlink_results_free(r);
    assert_int_equal(n, 4);
    for (i = 0; i < 2 * n; i++)
        for (beside = 1e-5; beside < 1; beside *= 10) {
            from = zeros[i / 2] + (i % 2 ? beside : -beside);
            snprintf(deck, sizeof deck, format, from, from + 7225);
            r = opened(deck);
            k = crossings(r, "Ts", FOURLINK_OPEN, 0, at);
            if (k != 20 * n + 1 - i % 2)
                fail_msg("from %.17g: %lu crossings of 0", from, k);
            fourlink_results_free(r);
        }
}

/* Of a parallelogram the coupler does not turn and the rocker turns with the crank, through both change points, where
** rows are rounding error. */
TEST(test_constant)
{
    static const char *const zeros[] = {"omega3", "alpha3", "alpha4"};
    uint64_t seed = 91;
    double at[1];
    unsigned long n;
    int i, k;

    for (i = 0; i < some_of(300); i++) {
        double a = floor(uniform(&seed, 1, 16)) / 16, d = a + floor(uniform(&seed, 1, 16)) / 16;
        double speed = uniform(&seed, -40, 40), from = uniform(&seed, -200, 200);
        char text[600];
        fourlink_results *r;

        sprintf(text,
                "mechanism = four-bar\n[ground]\nlength = %.17g m\n[crank]\nlength = %.17g m\n"
                "[coupler]\nlength = %.17g m\n[rocker]\nlength = %.17g m\n[motion]\nspeed = %.17g "
                "rad/s\nfrom = %.17g deg\nto = %.17g deg\n",
                d, a, d, a, speed, from, from + (speed < 0 ? -1 : 1) * uniform(&seed, 60, 1000));
        r = opened(text);
        for (k = 0; k < 4; k++) {
            const char *name = k < 3 ? zeros[k] : "omega4";
            int status =
                fourlink_results_crossings(r, name, FOURLINK_OPEN, k < 3 ? 0 : speed, 1, at, &n);

            if (status != FOURLINK_CONSTANT)
                fail_msg("%s: %s\n%s", name, fourlink_status_text(status), text);
        }
        fourlink_results_free(r);
    }
}

/* A force that is there in a part of each turn: where it is not, the ends of that part are found, and no angle within
** it, whatever rounding error there is. */
TEST(test_stretches)
{
    uint64_t seed = 92;
    double at[MOST];
    int i;

    for (i = 0; i < some_of(300); i++) {
        double from = uniform(&seed, 20, 70), to = uniform(&seed, 110, 160);
        unsigned long n, k;
        char text[700];
        fourlink_results *r;

        /* a parallelogram, whose rocker has a force across it from `from` to `to` */
        sprintf(
            text,
            "mechanism = four-bar\n[ground]\nlength = 1 m\n[crank]\nlength = 0.375 m\n[coupler]\n"
            "length = 1 m\nmass = 1 kg\n[rocker]\nlength = 0.375 m\n[load P]\nlink = rocker\n"
            "torque = %.17g N m\nfrom = %.17g deg\nto = %.17g deg\n[motion]\nspeed = %.17g "
            "rad/s\nto = 720 deg\n",
            uniform(&seed, 1, 20), from, to, uniform(&seed, 1, 20));
        r = opened(text);
        n = crossings(r, "F34_across", FOURLINK_OPEN, 0, at);
        if (n > 6)
            fail_msg("%lu crossings\n%s", n, text);
        for (k = 0; k < n; k++)
            if (fmin(fmin(fabs(remainder(at[k], 180)), fabs(remainder(at[k] - from, 360))),
                     fabs(remainder(at[k] - to, 360))) > 1e-4)
                fail_msg("crossing at %.12g\n%s", at[k], text);
        assert_true(n >= 2);
        fourlink_results_free(r);
    }
}

TEST(test_statuses)
{
    fourlink_results *r = opened(ROCKER SPEED),
                     *s = opened(ROCKER "[motion]\nmode = free\nspeed = 5 rad/s\nrows = time\n"
                                        "time_step = 1 ms\nduration = 10 ms\n");
    double at[1];
    unsigned long n = 7;

    assert_int_equal(fourlink_results_crossings(r, "omega2", FOURLINK_OPEN, 10, 1, at, &n),
                     FOURLINK_CONSTANT);
    assert_int_equal(fourlink_results_crossings(r, "nothing", FOURLINK_OPEN, 10, 1, at, &n),
                     FOURLINK_NO_SUCH_NAME);
    assert_int_equal(fourlink_results_crossings(s, "theta4", FOURLINK_OPEN, 120, 1, at, &n),
                     FOURLINK_NO_SUCH_ANGLE);
    assert_int_equal(fourlink_results_crossings(r, "theta4", 0, 120, 1, at, &n),
                     FOURLINK_BAD_BRANCH);
    assert_int_equal(fourlink_results_crossings(r, "theta4", FOURLINK_OPEN, NAN, 1, at, &n),
                     FOURLINK_BAD_NUMBER);
    assert_int_equal(fourlink_results_crossings(NULL, "theta4", FOURLINK_OPEN, 120, 1, at, &n),
                     FOURLINK_NULL);
    assert_int_equal(fourlink_results_crossings(r, NULL, FOURLINK_OPEN, 120, 1, at, &n),
                     FOURLINK_NULL);
    assert_int_equal(fourlink_results_crossings(r, "theta4", FOURLINK_OPEN, 120, 1, NULL, &n),
                     FOURLINK_NULL);
    assert_int_equal(fourlink_results_crossings(r, "theta4", FOURLINK_OPEN, 120, 1, at, NULL),
                     FOURLINK_NULL);
    assert_int_equal(n, 7);
    /* how many there are, beyond the room */
    assert_int_equal(fourlink_results_crossings(r, "theta4", FOURLINK_OPEN, 120, 0, NULL, &n),
                     FOURLINK_OK);
    assert_int_equal(n, 2);
    fourlink_results_free(r);
    fourlink_results_free(s);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
