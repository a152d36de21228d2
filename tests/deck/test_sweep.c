/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_sweep.c - [sweep]: how many designs, in which order, with which values; how tolerances are spread;
** mistakes.
*/
#include <stdlib.h>

#include <gsl/gsl_math.h>

#include "check.h"
#include "elements.h"
#include "read.h"
#include "deck/reader.h"

/* Fifteen lines: [sweep] stands at line 15, what a test adds to it from line 16 on. */
#define DECK                       \
    "mechanism = four-bar\n"       \
    "[ground]\nlength = 80 mm\n"   \
    "[coupler]\nlength = 66 mm\n"  \
    "[rocker]\nlength = 56 mm\n"   \
    "[crank]\nlength = 20 mm\n"    \
    "[load W]\nlink = rocker\n"    \
    "torque = 5 N m\n"             \
    "[motion]\nspeed = 10 rad/s\n" \
    "[sweep]\n"
#define IN_MM "[units]\nlength = mm\n"
#define IN_RPM "[units]\nangular_speed = rpm\n"

static fourlink_source design_source(const char *lines, const char *units, unsigned long design)
{
    static char contents[4096];
    fourlink_source source;

    assert_true(strlen(DECK) + strlen(lines) + strlen(units) + 2 < sizeof contents);
    strcpy(contents, DECK);
    strcat(contents, lines);
    strcat(contents, "\n");
    strcat(contents, units);
    source = deck_source(contents);
    source.design = design;
    return source;
}

static int read_design(const char *lines, const char *units, unsigned long design, deck *d)
{
    fourlink_source source = design_source(lines, units, design);

    return flk_deck_read(&source, d);
}

/* ------------------------------------------------------------------------------- values and order */

typedef struct expected_values {
    const char *lines, *units;
    unsigned long n;
    double values[8]; /* of the first variable, in the deck's unit */
    double tolerance; /* relative; 0: the very numbers */
} expected_values;

static const expected_values all_values[] = {
    {"crank.length = 18 mm to 22 mm step 1 mm", IN_MM, 5, {18, 19, 20, 21, 22}, 0},
    {"crank.length = 0.1 mm to 0.8 mm step 0.1 mm",
     IN_MM,
     8,
     {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8},
     0},
    {"crank.length = 1 mm to 1.7 mm in 8", IN_MM, 8, {1, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7}, 0},
    {"crank.length = 20.01 mm to 20.07 mm step 0.01 mm",
     IN_MM,
     7,
     {20.01, 20.02, 20.03, 20.04, 20.05, 20.06, 20.07},
     0},
    {"load W.torque = -0.3 N m to 0.3 N m step 0.1 N m",
     "",
     7,
     {-0.3, -0.2, -0.1, 0, 0.1, 0.2, 0.3},
     0},
    {"load W.torque = -0.2 N m to 0.1 N m in 4", "", 4, {-0.2, -0.1, 0, 0.1}, 0},
    {"crank.length = 22 mm to 18 mm step -1 mm", IN_MM, 5, {22, 21, 20, 19, 18}, 0},
    {"crank.length = 0.7 mm to 0.1 mm step -0.2 mm", IN_MM, 4, {0.7, 0.5, 0.3, 0.1}, 0},
    {"crank.length = 22 mm to 18 mm in 3", IN_MM, 3, {22, 20, 18}, 0},
    /* a step that does not divide: the last value is before the end */
    {"crank.length = 18 mm to 22 mm step 1.5 mm", IN_MM, 3, {18, 19.5, 21}, 0},
    {"crank.length = 18 mm to 19 mm step 3 mm", IN_MM, 1, {18}, 0},
    {"crank.length = 18 mm to 22 mm in 2", IN_MM, 2, {18, 22}, 0},
    /* units: the values are of the first one's */
    {"crank.length = 18 mm to 2.2 cm step 0.2 cm", IN_MM, 3, {18, 20, 22}, 1e-14},
    {"crank.length = 1 cm to 22 mm step 0.004 m", IN_MM, 4, {10, 14, 18, 22}, 1e-14},
    {"crank.length = 18 mm, 2.1 cm, 0.5 in, 0.02 m", IN_MM, 4, {18, 21, 12.7, 20}, 1e-14},
    {"crank.length = 25.4 mm to 2 in step 12.7 mm", IN_MM, 3, {25.4, 38.1, 50.8}, 1e-14},
    {"crank.length = 0.5 in to 1 in step 0.25 in", IN_MM, 3, {12.7, 19.05, 25.4}, 1e-14},
    {"crank.length = 0.5 in to 1 in in 3", IN_MM, 3, {12.7, 19.05, 25.4}, 1e-14},
    {"crank.length = 10 mm to 1 in in 2", IN_MM, 2, {10, 25.4}, 1e-14},
    {"motion.speed = 10 rad/s, 100 rpm", "", 2, {10, 100 * 2 * PI / 60}, 1e-14},
    {"motion.speed = 10 rad/s, 100 rpm", IN_RPM, 2, {10 * 60 / (2 * PI), 100}, 1e-14},
    {"motion.speed = 100 rpm to 300 rpm step 100 rpm", IN_RPM, 3, {100, 200, 300}, 0},
    {"motion.from = 10 deg to 30 deg step 10 deg", "", 3, {10, 20, 30}, 0},
    {"motion.from = 0.5 rad, 1 rad, 0.25 rev", "", 3, {0.5 / DEG, 1 / DEG, 90}, 1e-14},
    {"motion.from = 0 rad to 90 deg in 3", "", 3, {0, 45, 90}, 1e-13},
    {"motion.from = 0.1 rad to 0.4 rad step 0.1 rad",
     "[units]\nangle = rad\n",
     4,
     {0.1, 0.2, 0.3, 0.4},
     0},
    /* bare numbers: of the deck's units */
    {"crank.length = 18 to 22 step 2", IN_MM, 3, {18, 20, 22}, 0},
    {"crank.length = 0.018, 0.019", "", 2, {0.018, 0.019}, 0},
    {"motion.from = 0.1 to 0.3 step 0.1", "[units]\nangle = rad\n", 3, {0.1, 0.2, 0.3}, 0},
    {"load W.torque = 1 N m, -2 N m, 3e3 N mm", "", 3, {1, -2, 3}, 1e-14},
    {"crank.length = 20 mm", IN_MM, 1, {20}, 0},
    {"crank.length = 18 mm, 20 mm,", IN_MM, 2, {18, 20}, 0},
};

TEST(test_values)
{
    size_t k, failed = 0;
    unsigned long i;
    deck d;

    for (k = 0; k < COUNT(all_values); k++) {
        const expected_values *x = &all_values[k];

        for (i = 0; i < x->n; i++) {
            int status = read_design(x->lines, x->units, i, &d);
            double value = status == 1 ? d.sweep.variables[0].value : 0;

            if (status != 1 || d.sweep.n_designs != x->n || d.sweep.n_variables != 1 ||
                !(fabs(value - x->values[i]) <= x->tolerance * fabs(x->values[i]))) {
                print_error("%s: status %d, %lu designs, the %lu-th %.17g, expected %.17g\n",
                            x->lines, status, d.sweep.n_designs, i + 1, value, x->values[i]);
                if (d.mistakes.count)
                    print_error("    %s\n", d.mistakes.list[0].message);
                failed++;
                i = x->n;
            }
            flk_deck_free(&d);
        }
    }
    assert_int_equal(failed, 0);
}

/* The mechanism has the values; what is not varied has those of the deck. */
TEST(test_mechanism)
{
    deck d;

    assert_int_equal(read_design("crank.length = 18 mm to 22 mm step 1 mm\n"
                                 "load W.torque = 3 N m, 4 N m\n"
                                 "motion.speed = 60 rpm, 1 rad/s\n",
                                 "", 9, &d),
                     1);
    assert_near(d.machine.mechanism.design.link[2].length, 0.020, 1e-17);
    assert_near(d.machine.mechanism.design.link[3].length, 0.066, 0);
    assert_near(d.machine.mechanism.design.link[4].length, 0.056, 0);
    assert_near(given_load(&d, 0)->values.torque, 3, 0);
    assert_near(d.motion.speed, 1, 0);
    flk_deck_free(&d);
}

/* The last variable changes fastest, and samples fastest of all. */
TEST(test_order)
{
    double last = 0;
    unsigned long i;
    deck d;

    for (i = 0; i < 2 * 3 * 4; i++) {
        assert_int_equal(
            read_design("crank.length = 18 mm, 22 mm\nground.length = 80 mm +- 1 mm\n"
                        "motion.speed = 1 rad/s to 3 rad/s step 1 rad/s\nsamples = 4\n",
                        IN_MM, i, &d),
            1);
        assert_int_equal(d.sweep.n_designs, 24);
        assert_int_equal(d.sweep.n_variables, 3);
        assert_near(d.sweep.variables[0].value, i < 12 ? 18 : 22, 0);
        assert_near(d.sweep.variables[2].value, 1 + (double)(i / 4 % 3), 0);
        assert_near(d.sweep.variables[1].value, 80, 1);
        assert_true(d.sweep.variables[1].value != last);
        assert_near(d.machine.mechanism.design.link[1].length, d.sweep.variables[1].value / 1000,
                    1e-16);
        last = d.sweep.variables[1].value;
        flk_deck_free(&d);
    }
}

/* ---------------------------------------------------------------------------------- distributions */

#define N 20000

static double sample[6][N], sorted[N];

/* The values of all designs; those of every 97th are those of its deck. */
static void fill(const char *lines, double *a, double *b)
{
    fourlink_source source = design_source(lines, IN_MM, 0);
    fourlink_results *r;
    double values[2];
    unsigned long i;
    deck d;

    assert_int_equal(fourlink_results_open(&source, 0, &r, NULL, NULL), FOURLINK_OK);
    for (i = 0; i < N; i++) {
        assert_int_equal(fourlink_results_variables(r, i, 2, values, NULL, NULL), FOURLINK_OK);
        a[i] = values[0];
        b[i] = values[1];
        if (i % 97)
            continue;
        assert_int_equal(read_design(lines, IN_MM, i, &d), 1);
        assert_true(d.sweep.variables[0].value == a[i] && d.sweep.variables[1].value == b[i]);
        flk_deck_free(&d);
    }
    fourlink_results_free(r);
}

static double mean_of(const double *x)
{
    double sum = 0;
    size_t i;

    for (i = 0; i < N; i++)
        sum += x[i];
    return sum / N;
}

static double moment(const double *x, int power)
{
    double mean = mean_of(x), sum = 0;
    size_t i;

    for (i = 0; i < N; i++)
        sum += gsl_pow_int(x[i] - mean, power);
    return sum / N;
}

/* Of x[i] and y[i + lag]. */
static double correlation(const double *x, const double *y, size_t lag)
{
    double mx = mean_of(x), my = mean_of(y), sum = 0;
    size_t i;

    for (i = 0; i + lag < N; i++)
        sum += (x[i] - mx) * (y[i + lag] - my);
    return sum / (double)(N - lag) / sqrt(moment(x, 2) * moment(y, 2));
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return x < y ? -1 : x > y;
}

static void check_distribution(const double *x, double nominal, double tolerance, double deviation,
                               double kurtosis)
{
    size_t i;

    assert_near(mean_of(x), nominal, 4 * deviation / sqrt(N));
    assert_close(sqrt(moment(x, 2)), deviation, 0.02);
    assert_near(moment(x, 3) / pow(moment(x, 2), 1.5), 0, 0.07);
    assert_near(moment(x, 4) / pow(moment(x, 2), 2), kurtosis, 0.12);
    for (i = 1; i <= 5; i++)
        assert_near(correlation(x, x, i), 0, 4 / sqrt(N));
    memcpy(sorted, x, sizeof sorted);
    qsort(sorted, N, sizeof sorted[0], compare);
    assert_true(sorted[0] >= nominal - tolerance);
    assert_true(sorted[N - 1] <= nominal + tolerance);
    /* most of the tolerance is made use of */
    assert_true(sorted[0] < nominal - 0.95 * tolerance);
    assert_true(sorted[N - 1] > nominal + 0.95 * tolerance);
    for (i = 1; i < N; i++)
        assert_true(sorted[i] != sorted[i - 1]);
}

/* A normal distribution that is cut off at three standard deviations has 0.98658 of its deviation, and
** a kurtosis of 2.834 in place of 3. */
#define CUT_DEVIATION 0.986577
#define CUT_KURTOSIS 2.834

TEST(test_distributions)
{
    static const size_t pairs[][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 3}, {2, 3}, {4, 5}, {1, 5}};
    size_t i, lag;

    fill("coupler.length = 66 mm +- 0.1 mm\nrocker.length = 56 mm ± 0.3 mm normal\nsamples = 20000",
         sample[0], sample[1]);
    fill("coupler.length = 66 mm +/- 0.1 mm uniform\nrocker.length = 56 mm +- 0.3 mm normal\n"
         "samples = 20000\nseed = 2",
         sample[2], sample[3]);
    fill("coupler.length = 66 mm +- 0.1 mm normal\nrocker.length = 56 mm +- 0.1 mm normal\n"
         "samples = 20000\nseed = 3",
         sample[4], sample[5]);
    check_distribution(sample[0], 66, 0.1, 0.1 / sqrt(3), 1.8);
    check_distribution(sample[2], 66, 0.1, 0.1 / sqrt(3), 1.8);
    check_distribution(sample[1], 56, 0.3, 0.1 * CUT_DEVIATION, CUT_KURTOSIS);
    check_distribution(sample[3], 56, 0.3, 0.1 * CUT_DEVIATION, CUT_KURTOSIS);
    check_distribution(sample[4], 66, 0.1, 0.1 / 3 * CUT_DEVIATION, CUT_KURTOSIS);
    check_distribution(sample[5], 56, 0.1, 0.1 / 3 * CUT_DEVIATION, CUT_KURTOSIS);
    for (i = 0; i < COUNT(pairs); i++)
        for (lag = 0; lag < 3; lag++) {
            assert_near(correlation(sample[pairs[i][0]], sample[pairs[i][1]], lag), 0, 4 / sqrt(N));
            assert_near(correlation(sample[pairs[i][1]], sample[pairs[i][0]], lag), 0, 4 / sqrt(N));
        }
}

/* The same seed gives the same values, 1 is the default, others give others. */
TEST(test_seeds)
{
    static const char *const seeds[] = {"",         "seed = 1", "seed = 2",
                                        "seed = 0", "seed = 3", "seed = 4294967295"};
    double values[6];
    char lines[200];
    size_t i, k;
    deck d;

    for (i = 0; i < 6; i++) {
        strcpy(lines, "coupler.length = 66 mm +- 0.1 mm\nsamples = 3\n");
        strcat(lines, seeds[i]);
        assert_int_equal(read_design(lines, IN_MM, 2, &d), 1);
        values[i] = d.sweep.variables[0].value;
        flk_deck_free(&d);
    }
    assert_true(values[0] == values[1]);
    for (i = 1; i < 6; i++)
        for (k = 1; k < i; k++)
            if (values[i] == values[k])
                fail_msg("'%s' and '%s' give the same value", seeds[i], seeds[k]);
}

/* A tolerance in per cent, or in another unit, is that in the unit of the value. */
TEST(test_tolerances)
{
    static const char *const same[][2] = {
        {"coupler.length = 66 mm +- 0.33 mm", "coupler.length = 66 mm +- 0.5 %"},
        {"coupler.length = 66 mm +- 0.33 mm", "coupler.length = 66 mm ± 0.5%"},
        {"coupler.length = 66 mm +- 0.33 mm normal", "coupler.length = 66 mm +/- 0.5 % normal"},
        {"coupler.length = 66 mm +- 0.33 mm", "coupler.length = 66 mm ±0.033 cm uniform"},
        {"coupler.length = 66 mm +- 0.33 mm", "coupler.length = 66 +- 0.33"},
        {"coupler.length = 66 mm +- 0.33 mm", "coupler.length = 0.066 m +- 0.00033 m"},
        {"coupler.length = 66 mm +- 0.254 mm", "coupler.length = 66 mm +- 0.01 in"},
        {"motion.speed = 100 rpm +- 2 rpm", "motion.speed = 100 rpm +- 2 %"},
        {"motion.speed = -100 rpm +- 2 rpm", "motion.speed = -100 rpm +- 2 %"},
        {"motion.speed = 100 rpm +- 2 rpm", "motion.speed = 100 rpm +- 12 deg/s"},
        {"load W.torque = -2 N m +- 0.1 N m", "load W.torque = -2 N m +- 5 %"},
        {"load W.torque = 2 N m +- 3 N m", "load W.torque = 2 N m +- 3000 N mm"},
    };
    size_t i, k, failed = 0;
    char lines[200];

    for (i = 0; i < COUNT(same); i++) {
        double value[2];

        for (k = 0; k < 2; k++) {
            deck d;

            strcpy(lines, same[i][k]);
            strcat(lines, "\nsamples = 3");
            value[k] = read_design(lines, IN_MM, 1, &d) == 1 ? d.sweep.variables[0].value : 0;
            if (d.mistakes.count)
                print_error("%s: %s\n", same[i][k], d.mistakes.list[0].message);
            flk_deck_free(&d);
        }
        if (value[0] == 0 || !(fabs(value[0] - value[1]) <= 1e-13 * fabs(value[0]))) {
            print_error("%s: %.17g, %s: %.17g\n", same[i][0], value[0], same[i][1], value[1]);
            failed++;
        }
    }
    assert_int_equal(failed, 0);
}

/* --------------------------------------------------------------------------------------- mistakes */

#define GOOD "crank.length = 18 mm to 22 mm step 1 mm\n"
#define NOT_A_STEP "the step does not lead to the last value of the range"
#define NOT_A_COUNT "the number of values of a range must be a whole number, at least 2"
#define NO_STEP                                                                                \
    "a range needs its step, '20 mm to 30 mm step 2 mm', or the number of its values, '20 mm " \
    "to 30 mm in 6'"

static const struct {
    const char *lines;
    long line;
    const char *message;
} mistaken[] = {
    {"crank.lenght = 1 mm", 16, "unknown key 'lenght' in [crank]; did you mean 'length'?"},
    {"crnk.length = 1 mm", 16, "unknown section 'crnk'; did you mean 'crank'?"},
    {"xyzzy.length = 1 mm", 16, "unknown section 'xyzzy'"},
    {"point Q.at = 1 mm", 16, "there is no [point Q] in the deck"},
    {"load X.torque = 1 N m", 16, "there is no [load X] in the deck"},
    {"title = x", 16,
     "unknown key 'title' in [sweep]; a quantity is named with its section, such as crank.length"},
    {"mechanism = four-bar", 16,
     "unknown key 'mechanism' in [sweep]; a quantity is named with its section, such as "
     "crank.length"},
    {"crank.cg = 1 mm, 2 mm", 16, "'crank.cg' has parts: vary its .x, .y, .size or .angle"},
    {"crank.length = 20 mm +- 1 mm\nsamples = 0.5", 17, "expected a whole number, not '0.5'"},
    {"table.columns = mu", 16, "'table.columns' is not a quantity that can be varied"},
    {"sweep.samples = 1, 2", 16, "'sweep.samples' is not a quantity that can be varied"},
    {"expect.mu = 1, 2", 16, "'expect.mu' is not a quantity that can be varied"},
    {"units.length = mm, m", 16, "'units.length' is not a quantity that can be varied"},
    {"table.branch = open", 16, "'table.branch' is not a quantity that can be varied"},
    {"crank.length = 1 kg, 2 kg", 16, "'1 kg' is a mass; expected a length, such as 80 mm"},
    {"crank.length = 1 mm, 2 kg", 16, "'2 kg' is a mass; expected a length, such as 80 mm"},
    {"crank.length = 18 mm, , 20 mm", 16, "expected a length, such as 80 mm, not ''"},
    {"crank.length = 18 mm,,", 16, "expected a length, such as 80 mm, not ''"},
    {"crank.length = 18 mm to 22 mm", 16, NO_STEP},
    {"crank.length = 18 mm to 22 mm step 0 mm", 16, NOT_A_STEP},
    {"crank.length = 18 mm to 22 mm step -1 mm", 16, NOT_A_STEP},
    {"crank.length = 22 mm to 18 mm step 1 mm", 16, NOT_A_STEP},
    {"crank.length = 18 mm to 22 mm step 1 kg", 16,
     "'1 kg' is a mass; expected a length, such as 80 mm"},
    {"crank.length = 18 mm to 22 mm in 1", 16, NOT_A_COUNT},
    {"crank.length = 18 mm to 22 mm in 2.5", 16, NOT_A_COUNT},
    {"crank.length = 18 mm to 22 mm in -3", 16, NOT_A_COUNT},
    {"crank.length = 18 mm to 22 mm in 3 mm", 16, NOT_A_COUNT},
    {"crank.length = 20 mm +- 20 mm\nsamples = 3", 16,
     "the tolerance, 20 mm, is not smaller than the length, 20 mm"},
    {"crank.length = 20 mm +- 3 cm\nsamples = 3", 16,
     "the tolerance, 3 cm, is not smaller than the length, 20 mm"},
    {"crank.length = 20 mm +- 100 %\nsamples = 3", 16,
     "the tolerance, 100 %, is not smaller than the length, 20 mm"},
    {"crank.length = 20 mm +- 0 mm\nsamples = 3", 16, "the tolerance must be positive, not 0 mm"},
    {"crank.length = 20 mm +- -1 mm\nsamples = 3", 16, "the tolerance must be positive, not -1 mm"},
    {"crank.length = 20 mm +- 0 %\nsamples = 3", 16, "the tolerance must be positive, not 0 %"},
    {"crank.length = 20 mm +- 1 mm", 15, "a tolerance needs 'samples = NUMBER' in [sweep]"},
    {GOOD "samples = 3", 17, "'samples' needs a tolerance, such as 66 mm +- 0.1 mm"},
    {"crank.length = 20 mm +- 1 mm\nsamples = 0", 17, "the samples must be positive, not 0"},
    {"crank.length = 20 mm +- 1 mm\nsamples = -1", 17, "the samples must be positive, not -1"},
    {"crank.length = 20 mm +- 1 mm\nsamples = 1.5", 17, "expected a whole number, not '1.5'"},
    {"crank.length = 20 mm +- 1 mm\nsamples = 3\nseed = -1", 18,
     "the seed must not be negative: -1"},
    {"crank.length = 20 mm +- 1 mm\nsamples = 3\nseed = 4294967296", 18,
     "the seed must be less than 4294967296"},
    {"crank.length = 20 mm +- 1 mm\nsamples = 3\nseed = 1.5", 18,
     "expected a whole number, not '1.5'"},
    {GOOD "[sweep]\n" GOOD, 17, "[sweep] is given twice; first at line 15"},
    {"", 15,
     "[sweep] varies nothing: add a line such as 'crank.length = 20 mm to 30 mm step 2 mm'"},
    {GOOD GOOD, 17, "'crank.length' is given twice"},
    {"crank.length = 18 mm to 22 mm in 100000\nrocker.length = 50 mm to 60 mm in 100000", 15,
     "more than 4e9 designs"},
    {"crank.length = 20 mm +- 1 mm\nsamples = 5e9", 15, "more than 4e9 designs"},
};

TEST(test_mistakes)
{
    size_t i, k, failed = 0;

    for (i = 0; i < COUNT(mistaken); i++) {
        deck d;

        if (read_design(mistaken[i].lines, "", 0, &d) != 0 || d.mistakes.count != 1 ||
            strcmp(d.mistakes.list[0].message, mistaken[i].message) != 0 ||
            d.mistakes.list[0].place.line != mistaken[i].line ||
            strcmp(d.mistakes.list[0].place.source, "x.deck") != 0) {
            print_error("%s\n    expected at line %ld: %s, and nothing else, not\n",
                        mistaken[i].lines, mistaken[i].line, mistaken[i].message);
            for (k = 0; k < d.mistakes.count; k++)
                print_error("    at line %ld: %s\n", d.mistakes.list[k].place.line,
                            d.mistakes.list[k].message);
            failed++;
        }
        flk_deck_free(&d);
    }
    assert_int_equal(failed, 0);
}

/* A quantity whose values are mistaken is not missed as well. */
TEST(test_mistaken_values_of_a_length)
{
    deck d;

    assert_int_equal(read_deck("mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\n"
                               "length = 20 mm\n[rocker]\nlength = 56 mm\n[coupler]\nmass = 1 kg\n"
                               "[sweep]\ncoupler.length = 66 kg, 67 kg\n",
                               &d),
                     0);
    assert_int_equal(d.mistakes.count, 1);
    assert_int_equal(d.mistakes.list[0].place.line, 11);
    assert_string_equal(d.mistakes.list[0].message,
                        "'66 kg' is a mass; expected a length, such as 80 mm");
    flk_deck_free(&d);
}

/* The same quantity under two names. */
TEST(test_twice)
{
    static const char *const again[] = {GOOD "Crank.Length = 1 mm, 2 mm",
                                        GOOD "crank . length = 1 mm, 2 mm",
                                        "load W.torque = 1 N m, 2 N m\nload.torque = 3 N m, 4 N m"};
    size_t i, failed = 0;

    for (i = 0; i < COUNT(again); i++) {
        deck d;

        if (read_design(again[i], "", 0, &d) != 0) {
            print_error("the same quantity twice:\n%s\n", again[i]);
            failed++;
        }
        flk_deck_free(&d);
    }
    assert_int_equal(failed, 0);
}

/* No deck that is cut short, or has bytes changed, upsets the reader. */
TEST(test_mutations)
{
    static const char lines[] = "crank.length = 18 mm to 22 mm step 1 mm\n"
                                "motion.speed = 10 rad/s, 100 rpm\n"
                                "rocker.length = 56 mm ± 0.5 % normal\nsamples = 3\nseed = 2\n"
                                "output = max(mu), type\n";
    static const char bytes[] = " \n,.=+-/%0190etoins[]()#\302\261\t";
    char copy[sizeof lines];
    uint64_t state = 1;
    size_t i, k;

    for (i = 0; i < 5000; i++) {
        deck d;
        int status;

        memcpy(copy, lines, sizeof lines);
        for (k = 0; k < 1 + i % 4; k++)
            copy[(size_t)uniform(&state, 0, sizeof lines - 1)] =
                bytes[(size_t)uniform(&state, 0, sizeof bytes - 1)];
        if (i < sizeof lines)
            copy[i] = '\0';
        status = read_design(copy, IN_MM, i % 30, &d);
        assert_int_equal(status, d.mistakes.count == 0);
        flk_deck_free(&d);
    }
}

/* A design is the deck with assignments of the values of its variables. */
TEST(test_design_is_assignments)
{
    static const char lines[] = "load V.force.size = 1 N to 2 N in 3\n"
                                "load V.force.angle = 0 deg, 1 rad\n"
                                "rocker.cg.x = 2 mm +- 1 mm\nmotion.speed = 3 rpm +- 20 %\n"
                                "crank.length = 18 mm to 22 mm in 4\nsamples = 2\n";
    static const char load[] = "[load V]\nlink = rocker\nforce = (0, 1) N\nat = 5 mm\n";
    static const char *const units[] = {"N", "deg", "m", "rad/s", "m"};
    char without[1024];
    unsigned long design, k;

    strcpy(without, DECK);
    strcpy(strstr(without, "[sweep]"), load);
    for (design = 0; design < 48; design++) {
        char assignments[5][100];
        fourlink_change changes[5];
        fourlink_source source;
        deck swept, set;

        assert_int_equal(read_design(lines, load, design, &swept), 1);
        assert_int_equal(swept.sweep.n_designs, 48);
        for (k = 0; k < 5; k++) {
            const deck_variable *v = &swept.sweep.variables[k];

            snprintf(assignments[k], sizeof assignments[k], "%.*s = %.17g %s", (int)v->name.length,
                     v->name.start, v->value, units[k]);
            changes[k].origin = "--set";
            changes[k].assignment = assignments[k];
        }
        source = deck_source(without);
        source.changes = changes;
        source.n_changes = 5;
        assert_int_equal(flk_deck_read(&source, &set), 1);
        assert_close(given_load(&set, 1)->values.force.x, given_load(&swept, 1)->values.force.x,
                     1e-14);
        assert_close(given_load(&set, 1)->values.force.y, given_load(&swept, 1)->values.force.y,
                     1e-14);
        assert_close(set.machine.mechanism.design.link[4].cg.x,
                     swept.machine.mechanism.design.link[4].cg.x, 1e-14);
        assert_close(set.motion.speed, swept.motion.speed, 1e-14);
        assert_close(set.machine.mechanism.design.link[2].length,
                     swept.machine.mechanism.design.link[2].length, 1e-14);
        flk_deck_free(&swept);
        flk_deck_free(&set);
    }
}

/* A list is judged as a whole, with whichever design is read. */
TEST(test_mistakes_of_lists)
{
    static const char lines[] = "crank.length = 18 mm, 19 mm, nonsense, 21 mm\n";
    unsigned long design;

    for (design = 0; design < 4; design++) {
        deck d;

        assert_int_equal(read_design(lines, "", design, &d), 0);
        assert_int_equal(d.mistakes.count, 1);
        assert_string_equal(d.mistakes.list[0].message,
                            "expected a length, such as 80 mm, not 'nonsense'");
        flk_deck_free(&d);
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
