/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_results.c - the public interface of results by name: what each function returns, and leaves alone.
*/
#include <limits.h>

#include "machines.h"

#define MOST_COLUMNS 200
#define MOST_LOADS 10

static char *linkage(const char *more)
{
    return four_bar(0.020, 0.066, 0.056, 0.080,
                    print("[load Tl]\nlink = rocker\ntorque = 3 N m\n[motion]\nspeed = 10 rad/s\n"
                          "interval = 40 deg\n%s",
                          more));
}

/* ---------------------------------------------------------------------------------------------
** Opening
** ------------------------------------------------------------------------------------------- */

TEST(test_null_pointers)
{
    fourlink_source source = deck_source(linkage("")), none = source;
    fourlink_results *r = NULL;
    const fourlink_value *list;
    fourlink_mistake mistake;
    fourlink_instant instant;
    fourlink_turning turning;
    fourlink_value value;
    fourlink_check check;
    unsigned long n;
    double x;

    none.text = NULL;
    assert_int_equal(fourlink_results_open(NULL, 1, &r, &mistake, &n), FOURLINK_NULL);
    assert_int_equal(fourlink_results_open(&none, 1, &r, &mistake, &n), FOURLINK_NULL);
    assert_int_equal(fourlink_results_open(&source, 1, NULL, &mistake, &n), FOURLINK_NULL);
    assert_int_equal(fourlink_results_open(&source, 1, &r, NULL, &n), FOURLINK_NULL);
    assert_null(r);
    assert_int_equal(fourlink_results_open(&source, 0, &r, NULL, NULL), FOURLINK_OK);
    assert_int_equal(fourlink_results_design(NULL, 0, 1, &r, &mistake, &n), FOURLINK_NULL);
    assert_int_equal(fourlink_results_design(r, 0, 1, NULL, &mistake, &n), FOURLINK_NULL);
    assert_int_equal(fourlink_results_design(r, 0, 1, &r, NULL, &n), FOURLINK_NULL);
    assert_int_equal(fourlink_results_design(r, 0, 1, &r, &mistake, &n), FOURLINK_BAD_NUMBER);
    assert_int_equal(fourlink_results_variables(NULL, 0, 1, &x, NULL, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_variables(r, 0, 1, NULL, &x, &x), FOURLINK_NULL);
    assert_int_equal(fourlink_results_variables(r, 0, 0, NULL, NULL, NULL), FOURLINK_BAD_NUMBER);
    assert_null(fourlink_results_deck(NULL));
    fourlink_results_free(NULL);
    assert_int_equal(fourlink_results_list(NULL, FOURLINK_COLUMNS, &list, &n), FOURLINK_NULL);
    assert_int_equal(fourlink_results_list(r, FOURLINK_COLUMNS, NULL, &n), FOURLINK_NULL);
    assert_int_equal(fourlink_results_list(r, FOURLINK_COLUMNS, &list, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_row(NULL, FOURLINK_OPEN, 0, &x, NULL, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_motion(NULL, FOURLINK_OPEN, 0, &x, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_motion_along(NULL, FOURLINK_OPEN, 0, &x, NULL),
                     FOURLINK_NULL);
    assert_int_equal(fourlink_results_at(NULL, FOURLINK_OPEN, 0, &x, NULL, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_along(NULL, FOURLINK_OPEN, 0, &x, NULL, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_size(NULL, 0, &instant, &x), FOURLINK_NULL);
    assert_int_equal(fourlink_results_size(r, 0, NULL, &x), FOURLINK_NULL);
    assert_int_equal(fourlink_results_size(r, 0, &instant, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_value(NULL, "mu", FOURLINK_OPEN, 0, &value), FOURLINK_NULL);
    assert_int_equal(fourlink_results_value(r, NULL, FOURLINK_OPEN, 0, &value), FOURLINK_NULL);
    assert_int_equal(fourlink_results_value(r, "mu", FOURLINK_OPEN, 0, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_facts(NULL, 0, 7, &list, &n), FOURLINK_NULL);
    assert_int_equal(fourlink_results_facts(r, 0, 7, NULL, &n), FOURLINK_NULL);
    assert_int_equal(fourlink_results_facts(r, 0, 7, &list, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_turning(NULL, FOURLINK_OPEN, &turning), FOURLINK_NULL);
    assert_int_equal(fourlink_results_turning(r, FOURLINK_OPEN, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_check(NULL, 0, &check), FOURLINK_NULL);
    assert_int_equal(fourlink_results_check(r, 0, NULL), FOURLINK_NULL);
    /* what may be null */
    assert_int_equal(fourlink_results_row(r, FOURLINK_OPEN, 0, NULL, NULL, NULL), FOURLINK_OK);
    assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, 0, NULL, NULL, NULL), FOURLINK_OK);
    fourlink_results_free(r);
}

/* Mistakes of the deck, of the names of its columns, and of its sweep's outputs, in the order of lines. */
TEST(test_mistakes)
{
    static const struct {
        const char *more; /* from line 16 on */
        unsigned long n;
        long line;
        const char *message;
    } cases[] = {
        {"[table]\ncolumns = thta3\n", 1, 17, "unknown column 'thta3'; did you mean 'theta3'?"},
        {"[table]\ncolumns = thta3, x\nbranch = both ways\n", 2, 17,
         "unknown column 'thta3'; did you mean 'theta3'?"},
        {"[sweep]\ncrank.length = 10 mm, 20 mm\noutput = Ts\n", 1, 18,
         "'Ts' has a value in each row: use its max(), min(), mean() or rms()"},
        {"[sweep]\ncrank.length = 10 mm, 20 mm\noutput = max(Tz)\n", 1, 18,
         "'max(Tz)' is neither a fact nor the max(), min(), mean() or rms() of a column of this "
         "deck; did you "
         "mean "
         "'max(Ts)'?"},
        {"[sweep]\ncrank.length = 10 mm, 20 mm\noutput = mu_mim, swing\n", 1, 18,
         "'mu_mim' is neither a fact nor the max(), min(), mean() or rms() of a column of this "
         "deck; did you mean "
         "'mu_min'?"},
        {"[table]\ncolumns = mu_mim\n", 1, 17,
         "'mu_mim' is neither a fact nor the max(), min(), mean() or rms() of a column of this "
         "deck; did you mean 'mu_min'?"},
        {"[sweep]\ncrank.length = 10 mm, 20 mm\noutput = ,\n", 1, 18, "'output' names nothing"},
        {"[coupler]\nmass = 3\n", 1, 16, "[coupler] is given twice; first at line 4"},
    };
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_source source = deck_source(linkage(cases[i].more));
        fourlink_results *r = NULL;
        fourlink_mistake mistakes[2];
        unsigned long n = 99;

        memset(mistakes, 0, sizeof mistakes);
        assert_int_equal(fourlink_results_open(&source, 1, &r, mistakes, &n), FOURLINK_BAD_DECK);
        assert_null(r);
        assert_int_equal(n, cases[i].n);
        assert_string_equal(mistakes[0].message, cases[i].message);
        assert_string_equal(mistakes[0].file, "x.deck");
        assert_int_equal(mistakes[0].line, cases[i].line);
        assert_string_equal(mistakes[1].message, ""); /* there was room for one */
        assert_int_equal(fourlink_results_open(&source, 0, &r, NULL, NULL), FOURLINK_BAD_DECK);
        assert_null(r);
    }
}

/* The text is not needed after the call, and may be one that does not end in a null. */
TEST(test_text_is_not_kept)
{
    char *contents = linkage("[table]\ncolumns = Ts, mu\n[expect]\nat = 40 deg\nmu = 50.0 deg\n");
    fourlink_results *kept = opened(contents), *r;
    fourlink_source source = deck_source(contents);
    const fourlink_value *list;
    double values[2], again[2];
    fourlink_check check;
    unsigned long n;

    contents[source.length] = '?';
    assert_int_equal(fourlink_results_open(&source, 0, &r, NULL, NULL), FOURLINK_OK);
    memset(contents, '?', source.length);
    assert_int_equal(fourlink_results_list(r, FOURLINK_COLUMNS, &list, &n), FOURLINK_OK);
    assert_int_equal(n, 2);
    assert_string_equal(list[0].name, "Ts");
    assert_string_equal(list[1].name, "mu");
    assert_int_equal(fourlink_results_row(r, FOURLINK_OPEN, 3, values, NULL, NULL), FOURLINK_OK);
    assert_int_equal(fourlink_results_row(kept, FOURLINK_OPEN, 3, again, NULL, NULL), FOURLINK_OK);
    assert_memory_equal(values, again, sizeof values);
    assert_int_equal(fourlink_results_check(r, 0, &check), FOURLINK_OK);
    assert_string_equal(check.file, "x.deck");
    assert_string_equal(check.printed_text, "50.0 deg");
    fourlink_results_free(r);
    fourlink_results_free(kept);
}

/* A deck of one crank angle as a cycle, all of it with that angle's speed and acceleration. */
TEST(test_whole_cycle)
{
    static const struct {
        const char *motion;
        double from, to, speed, acceleration; /* the cycle has the instant */
    } cases[] = {{"at = 30 deg\nspeed = 10 rad/s\n", 0, 360, 10, 0},
                 {"at = 30 deg\nspeed = -10 rad/s\nacceleration = 5 rad/s2\n", 360, 0, -10, 5},
                 {"at = 30 deg\nacceleration = -5 rad/s2\n", 360, 0, 0, -5},
                 {"at = -330 deg\nspeed = 10 rad/s\n", -360, 0, 10, 0},
                 {"at = 750 deg\nspeed = -10 rad/s\n", 1080, 720, -10, 0},
                 {"at = 30 deg\nspeed = 10 rad/s\ncycle = 720 deg\n", 0, 720, 10, 0}};
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        char *contents =
            four_bar(0.020, 0.066, 0.056, 0.080,
                     print("[load]\nlink = rocker\ntorque = 3 N m\n[motion]\n%s", cases[i].motion));
        fourlink_results *one = opened(contents), *whole;
        fourlink_source source = deck_source(contents);
        double here[MOST_COLUMNS], there[MOST_COLUMNS];
        const fourlink_value *list;
        fourlink_instant at;
        fourlink_problem p;
        unsigned long n;

        source.whole_cycle = 1;
        assert_int_equal(fourlink_results_open(&source, 0, &whole, NULL, NULL), FOURLINK_OK);
        p = problem_of(one);
        assert_true(p.one_instant && p.n_rows == 1);
        p = problem_of(whole);
        assert_false(p.one_instant);
        assert_int_equal(p.n_rows, 73);
        assert_int_equal(fourlink_results_row(whole, FOURLINK_OPEN, 0, NULL, &at, NULL),
                         FOURLINK_OK);
        assert_close(at.row.angle, cases[i].from, 1e-14);
        assert_int_equal(fourlink_results_row(whole, FOURLINK_OPEN, 72, NULL, &at, NULL),
                         FOURLINK_OK);
        assert_close(at.row.angle, cases[i].to, 1e-14);
        assert_true(at.row.crank.omega2 == cases[i].speed);
        assert_true(at.row.crank.alpha2 == cases[i].acceleration);
        assert_int_equal(fourlink_results_list(one, FOURLINK_COLUMNS, &list, &n), FOURLINK_OK);
        assert_int_equal(fourlink_results_at(one, FOURLINK_OPEN, 30, here, NULL, NULL),
                         FOURLINK_OK);
        assert_int_equal(fourlink_results_at(whole, FOURLINK_OPEN, 30, there, NULL, NULL),
                         FOURLINK_OK);
        while (n-- > 1) /* but for the crank angle, which may be of another turn */
            assert_near(there[n], here[n], 1e-12 * (1 + fabs(here[n])));
        assert_int_equal(fourlink_results_at(one, FOURLINK_OPEN, 31, NULL, NULL, NULL),
                         FOURLINK_NO_SUCH_ANGLE);
        fourlink_results_free(one);
        fourlink_results_free(whole);
    }
}

/* ---------------------------------------------------------------------------------------------
** Sweeps
** ------------------------------------------------------------------------------------------- */

#define SWEEP                                                                              \
    "[sweep]\ncrank.length = -1 mm, 0 mm, 18 mm, 19 mm\nmotion.speed = 100 rpm, 200 rpm\n" \
    "output = max(Ts), mu_min, energy_fluctuation\n[units]\nlength = mm\nangular_speed = rpm\n"

TEST(test_designs)
{
    static const struct {
        unsigned long design, is; /* the first that is in order is the fifth */
        int status;
        double length, speed;
    } cases[] = {{0, 0, FOURLINK_BAD_DECK, -1, 100},
                 {3, 3, FOURLINK_BAD_DECK, 0, 200},
                 {4, 4, FOURLINK_OK, 18, 100},
                 {7, 7, FOURLINK_OK, 19, 200},
                 {FOURLINK_ANY_DESIGN, 4, FOURLINK_OK, 18, 100}};
    fourlink_source source = deck_source(linkage(SWEEP));
    fourlink_results *any = NULL;
    size_t i;

    source.design = FOURLINK_ANY_DESIGN;
    assert_int_equal(fourlink_results_open(&source, 0, &any, NULL, NULL), FOURLINK_OK);
    for (i = 0; i < COUNT(cases); i++) {
        fourlink_results *r = NULL;
        const fourlink_value *list;
        double values[3] = {5, 5, 5};
        fourlink_problem p;
        unsigned long n;

        source.design = cases[i].design;
        assert_int_equal(fourlink_results_open(&source, 0, &r, NULL, NULL), cases[i].status);
        if (cases[i].status == FOURLINK_OK) {
            p = problem_of(r);
            assert_int_equal(p.n_designs, 8);
            assert_int_equal(p.design, cases[i].is);
            assert_true(p.has_outputs);
            assert_close(p.mechanism.design.link[2].length, cases[i].length / 1000, 1e-15);
            assert_int_equal(fourlink_results_list(r, FOURLINK_VARIABLES, &list, &n), FOURLINK_OK);
            assert_int_equal(n, 2);
            assert_string_equal(list[0].name, "crank.length");
            assert_string_equal(list[0].unit, "mm");
            assert_true(list[0].value == cases[i].length);
            assert_string_equal(list[1].name, "motion.speed");
            assert_string_equal(list[1].unit, "rpm");
            assert_true(list[1].value == cases[i].speed);
            assert_int_equal(fourlink_results_list(r, FOURLINK_OUTPUTS, &list, &n), FOURLINK_OK);
            assert_int_equal(n, 3);
            assert_string_equal(list[0].name, "max(Ts)");
            assert_string_equal(list[0].unit, "N.m");
            assert_string_equal(list[1].name, "mu_min");
            assert_string_equal(list[1].unit, "deg");
            assert_string_equal(list[2].name, "energy_fluctuation");
            assert_string_equal(list[2].quantity, "energy");
        }
        fourlink_results_free(r);
        if (cases[i].design == FOURLINK_ANY_DESIGN)
            continue;
        fourlink_results_variables(any, cases[i].design, 1, values, NULL, NULL);
        assert_true(values[0] == cases[i].length && values[1] == 5);
        fourlink_results_variables(any, cases[i].design, 3, values, NULL, NULL);
        assert_true(values[0] == cases[i].length && values[1] == cases[i].speed && values[2] == 5);
    }
    fourlink_results_free(any);
}

/* Of 5001 designs the first 2501 have no length above 0: after a thousand each fifth is tried. */
TEST(test_any_of_many_designs)
{
    fourlink_source source =
        deck_source(linkage("[sweep]\ncrank.length = -100 mm to 100 mm in 5001\n"));
    fourlink_results *r = NULL;

    source.design = FOURLINK_ANY_DESIGN;
    assert_int_equal(fourlink_results_open(&source, 0, &r, NULL, NULL), FOURLINK_OK);
    assert_int_equal(problem_of(r).n_designs, 5001);
    assert_int_equal(problem_of(r).design, 2505);
    fourlink_results_free(r);
}

/* None of the designs is in order: the mistakes are those of the first. */
TEST(test_no_design_in_order)
{
    fourlink_source source = deck_source(linkage("[sweep]\ncrank.length = -1 mm, 0 mm\n"));
    fourlink_mistake of_any, of_first;
    fourlink_results *r = NULL;

    source.design = FOURLINK_ANY_DESIGN;
    assert_int_equal(fourlink_results_open(&source, 1, &r, &of_any, NULL), FOURLINK_BAD_DECK);
    source.design = 0;
    assert_int_equal(fourlink_results_open(&source, 1, &r, &of_first, NULL), FOURLINK_BAD_DECK);
    assert_null(r);
    assert_string_equal(of_any.message, of_first.message);
    assert_int_equal(of_any.line, of_first.line);
}

/* ---------------------------------------------------------------------------------------------
** Lists
** ------------------------------------------------------------------------------------------- */

TEST(test_lists_that_are_not_there)
{
    static const int which[] = {0, -1, FOURLINK_CONDITIONS + 1, 1000};
    fourlink_results *r = opened(linkage(""));
    const fourlink_value *list = NULL;
    unsigned long n = 77;
    size_t i;

    for (i = 0; i < COUNT(which); i++) {
        assert_int_equal(fourlink_results_list(r, which[i], &list, &n), FOURLINK_NO_SUCH_LIST);
        assert_true(!list && n == 77);
    }
    assert_int_equal(fourlink_results_list(r, FOURLINK_OUTPUTS, &list, &n), FOURLINK_OK);
    assert_int_equal(n, 0);
    assert_int_equal(fourlink_results_list(r, FOURLINK_VARIABLES, &list, &n), FOURLINK_OK);
    assert_int_equal(n, 0);
    fourlink_results_free(r);
}

typedef struct input {
    const char *name;
    double value;
    const char *unit, *words;
} input;

/* The deck has these inputs in its units, each with the value that the deck gives it. */
static void check_inputs(const char *deck, const input *inputs, size_t n_inputs)
{
    fourlink_results *r = opened(deck);
    const fourlink_value *list, *again;
    unsigned long n, i;

    assert_int_equal(fourlink_results_list(r, FOURLINK_INPUTS, &list, &n), FOURLINK_OK);
    for (i = 0; i < n && i < n_inputs; i++) {
        assert_string_equal(list[i].name, inputs[i].name);
        assert_string_equal(list[i].unit, inputs[i].unit);
        assert_near(list[i].value, inputs[i].value, 1e-14 * fabs(inputs[i].value));
        assert_int_equal(list[i].words != NULL, inputs[i].words != NULL);
        if (inputs[i].words)
            assert_string_equal(list[i].words, inputs[i].words);
        assert_true(*list[i].meaning && list[i].source);
    }
    assert_int_equal(n, n_inputs);
    assert_int_equal(fourlink_results_list(r, FOURLINK_INPUTS, &again, &n), FOURLINK_OK);
    assert_true(again == list && n == n_inputs); /* once and for all */
    fourlink_results_free(r);
}

TEST(test_inputs)
{
    static const char deck[] =
        "mechanism = slider-crank\n[units]\nlength = mm\nmass = g\nangular_speed = rpm\n"
        "[crank]\nlength = 15 cm\n[rod]\nlength = 450\nmass = 2 kg\ncg = 150\n[piston]\n"
        "mass = 2.5 kg\n[ground]\noffset = -3 mm\n[gas]\nbore = 200 mm\nindicator = 0 deg 2 bar, "
        "90 deg 1 bar\n[load push]\nlink = piston\nforce = (3, 0) N\nfrom = 10 deg\nto = 50 deg\n"
        "[motion]\nspeed = 300\ninterval = 10 deg\n[flywheel]\nfluctuation = 0.02\n";
    static const input inputs[] = {{"ground.offset", -3, "mm", NULL},
                                   {"crank.length", 150, "mm", NULL},
                                   {"rod.length", 450, "mm", NULL},
                                   {"rod.mass", 2000, "g", NULL},
                                   {"rod.cg.x", 150, "mm", NULL},
                                   {"piston.mass", 2500, "g", NULL},
                                   {"gas.bore", 200, "mm", NULL},
                                   {"gas.indicator", 0, "", "a curve"},
                                   {"gas.area", 1e4 * PI, "mm2", NULL},
                                   {"motion.speed", 300, "rpm", NULL},
                                   {"motion.interval", 10, "deg", NULL},
                                   {"motion.from", 0, "deg", NULL},
                                   {"motion.to", 360, "deg", NULL},
                                   {"motion.cycle", 360, "deg", NULL},
                                   {"gravity.x", 0, "mm/s2", NULL},
                                   {"gravity.y", -9810, "mm/s2", NULL},
                                   {"load push.link", 0, "", "piston"},
                                   {"load push.force.x", 3, "N", NULL},
                                   {"load push.from", 10, "deg", NULL},
                                   {"load push.to", 50, "deg", NULL},
                                   {"flywheel.fluctuation", 0.02, "1", NULL}};

    check_inputs(deck, inputs, COUNT(inputs));
}

TEST(test_inputs_of_springs_friction_and_motor)
{
    static const char deck[] =
        "mechanism = four-bar\n[units]\nlength = mm\n[ground]\nlength = 80\n[crank]\nlength = 20\n"
        "[coupler]\nlength = 66\n[rocker]\nlength = 56\n[motion]\nmode = steady\n"
        "[motor]\nstall_torque = 9 N m\nno_load_speed = 90 rad/s\nratio = 5\ninertia = 2 kg m2\n"
        "[load F]\nlink = rocker\ntorque = -2 N m\nover = omega4\nat_speed = 3 rad/s\n"
        "exponent = 2\n"
        "[spring S]\nlink = rocker\nat = (40, 10)\nto = ground\nto_at = (100, 90)\n"
        "stiffness = 2 N/mm\nfree_length = 7 cm\npreload = 3 N\ndamping = 5 N s/m\nonly = pulls\n"
        "[spring T]\nlink = rocker\nto = crank\nstiffness = 1.5 N m/rad\nfree_angle = 100 deg\n"
        "[friction]\nA = 0.75\nradius_A = 15\n";
    static const input inputs[] = {{"ground.length", 80, "mm", NULL},
                                   {"crank.length", 20, "mm", NULL},
                                   {"coupler.length", 66, "mm", NULL},
                                   {"rocker.length", 56, "mm", NULL},
                                   {"motion.mode", 0, "", "steady"},
                                   {"motion.from", 0, "deg", NULL},
                                   {"motion.to", 360, "deg", NULL},
                                   {"motion.interval", 10, "deg", NULL},
                                   {"motion.cycle", 360, "deg", NULL},
                                   {"motor.stall_torque", 9, "N.m", NULL},
                                   {"motor.no_load_speed", 90, "rad/s", NULL},
                                   {"motor.inertia", 2, "kg.m2", NULL},
                                   {"motor.ratio", 5, "1", NULL},
                                   {"gravity.x", 0, "mm/s2", NULL},
                                   {"gravity.y", -9810, "mm/s2", NULL},
                                   {"load F.link", 0, "", "rocker"},
                                   {"load F.torque", -2, "N.m", NULL},
                                   {"load F.over", 0, "", "omega4"},
                                   {"load F.exponent", 2, "1", NULL},
                                   {"load F.at_speed", 3, "rad/s", NULL},
                                   {"spring S.link", 0, "", "rocker"},
                                   {"spring S.at.x", 40, "mm", NULL},
                                   {"spring S.at.y", 10, "mm", NULL},
                                   {"spring S.to", 0, "", "ground"},
                                   {"spring S.to_at.x", 100, "mm", NULL},
                                   {"spring S.to_at.y", 90, "mm", NULL},
                                   {"spring S.stiffness", 2000, "N/m", NULL},
                                   {"spring S.free_length", 70, "mm", NULL},
                                   {"spring S.preload", 3, "N", NULL},
                                   {"spring S.damping", 5, "N.s/m", NULL},
                                   {"spring S.only", 0, "", "pulls"},
                                   {"spring T.link", 0, "", "rocker"},
                                   {"spring T.to", 0, "", "crank"},
                                   {"spring T.stiffness", 1.5, "N.m/rad", NULL},
                                   {"spring T.free_angle", 100, "deg", NULL},
                                   {"friction.A", 0.75, "1", NULL},
                                   {"friction.radius_A", 15, "mm", NULL},
                                   {"friction.circle_A", 11.25, "mm", NULL}};

    check_inputs(deck, inputs, COUNT(inputs));
}

/* A place that the deck gives from the centre of mass is told from the origin of its link. */
TEST(test_input_of_a_centre)
{
    fourlink_results *r = opened(
        "mechanism = four-bar\n[units]\nlength = mm\n[ground]\nlength = 80\n[crank]\nlength = 20\n"
        "[coupler]\nlength = 66\n[rocker]\nlength = 56\nmass = 1 kg\ncg = (20, 3)\ninertia = 0\n"
        "[load H]\nlink = rocker\nforce = (1, 0)\nat = G\n");
    const fourlink_value *list;
    unsigned long i, n;
    int n_found = 0;

    assert_int_equal(fourlink_results_list(r, FOURLINK_INPUTS, &list, &n), FOURLINK_OK);
    for (i = 0; i < n; i++)
        if (strncmp(list[i].name, "load H.at.", 10) == 0) {
            assert_near(list[i].value, list[i].name[10] == 'x' ? 20 : 3, 1e-13);
            n_found++;
        }
    assert_int_equal(n_found, 2);
    fourlink_results_free(r);
}

/* Forty springs with all that a spring can have. */
TEST(test_inputs_of_many_springs)
{
    enum { SPRINGS = 40, OF_EACH = 11 };
    static char deck[SPRINGS * 200 + 400];
    const fourlink_value *list;
    fourlink_results *r;
    unsigned long n, i;

    strcpy(deck, linkage(""));
    for (i = 1; i <= SPRINGS; i++)
        sprintf(deck + strlen(deck),
                "[spring S%lu]\nlink = crank\nat = (1, 2) mm\nto = ground\nto_at = (3, 4) m\n"
                "stiffness = 5 N/m\nfree_length = 6 m\npreload = 7 N\ndamping = %lu N s/m\n"
                "only = pulls\n",
                i, i);
    r = opened(deck);
    assert_int_equal(fourlink_results_list(r, FOURLINK_INPUTS, &list, &n), FOURLINK_OK);
    assert_true(n > SPRINGS * OF_EACH);
    for (i = 0; i < n; i++)
        if (strcmp(list[i].name, "spring S1.link") == 0)
            break;
    assert_int_equal(n - i, SPRINGS * OF_EACH);
    assert_string_equal(list[n - 2].name, "spring S40.damping");
    assert_near(list[n - 2].value, 40, 0);
    fourlink_results_free(r);
}

/* ---------------------------------------------------------------------------------------------
** Rows
** ------------------------------------------------------------------------------------------- */

/* All columns of a deck, in one call, are those of fourlink_results_get, and NaN where there is no row; each
** more than once, so that they are more than are computed together. */
TEST(test_rows_of_any_columns)
{
    enum { TIMES = 3 };
    static int handles[600];
    static double values[10 * 600];
    fourlink_results *r = opened(linkage(""));
    const fourlink_value *list;
    unsigned long n, n_columns, i, j;
    int fact;

    assert_int_equal(fourlink_results_list(r, FOURLINK_ALL_COLUMNS, &list, &n), FOURLINK_OK);
    n_columns = TIMES * n;
    assert_true(n_columns > 64 && n_columns <= COUNT(handles));
    for (i = 0; i < n_columns; i++)
        handles[i] = list[(i * 7) % n].handle;
    assert_int_equal(fourlink_results_rows(r, FOURLINK_CROSSED, 3, 7, n_columns, handles, values),
                     FOURLINK_OK);
    for (i = 0; i < 7; i++)
        for (j = 0; j < n_columns; j++) {
            fourlink_value v;
            int status =
                fourlink_results_get(r, handles[j], FOURLINK_CROSSED, 40.0 * (double)(i + 3), &v);
            double x = values[i * n_columns + j];

            if (status == FOURLINK_OK && !isnan(v.value))
                assert_true(x == v.value || fabs(x - v.value) <= 1e-13 * fabs(x));
            else
                assert_true(isnan(x));
        }
    assert_int_equal(fourlink_results_rows(r, FOURLINK_OPEN, 0, 10, 0, NULL, NULL), FOURLINK_OK);
    assert_int_equal(fourlink_results_rows(r, FOURLINK_OPEN, 10, 1, 1, handles, values),
                     FOURLINK_NO_SUCH_ROW);
    assert_int_equal(fourlink_results_rows(r, FOURLINK_OPEN, 1, ULONG_MAX, 1, handles, values),
                     FOURLINK_NO_SUCH_ROW);
    assert_int_equal(fourlink_results_rows(r, (fourlink_branch)0, 0, 1, 1, handles, values),
                     FOURLINK_BAD_BRANCH);
    assert_int_equal(fourlink_results_rows(NULL, FOURLINK_OPEN, 0, 1, 1, handles, values),
                     FOURLINK_NULL);
    fact = handles[0] + FOURLINK_MAX;
    values[0] = 5;
    assert_int_equal(fourlink_results_rows(r, FOURLINK_OPEN, 0, 1, 1, &fact, values),
                     FOURLINK_NO_SUCH_NAME);
    assert_true(values[0] == 5);
    fourlink_results_free(r);
}

static void soil_stack(void)
{
    volatile unsigned char bytes[20000];
    size_t i;

    for (i = 0; i < sizeof bytes; i++)
        bytes[i] = 0x5a;
}

static int same_numbers(const double *x, const double *y, unsigned long n, double tolerance)
{
    unsigned long i;

    for (i = 0; i < n; i++)
        if (!(isnan(x[i]) ? isnan(y[i]) : fabs(x[i] - y[i]) <= tolerance * (1 + fabs(x[i]))))
            return 0;
    return 1;
}

/* Rows are those of fourlink_analyse, and of fourlink_results_at at their angles, whatever else is asked
** for; those that are not reached say why, and leave nothing but the crank. */
static void check_rows(const char *contents)
{
    fourlink_results *r = opened(contents);
    const fourlink_deck *d = fourlink_results_deck(r);
    fourlink_problem p = problem_of(r);
    const fourlink_value *list;
    unsigned long n, i, j;
    int k;

    assert_int_equal(fourlink_results_list(r, FOURLINK_COLUMNS, &list, &n), FOURLINK_OK);
    assert_true(n <= MOST_COLUMNS && p.n_loads <= MOST_LOADS);
    for (k = 0; k < 2; k++)
        for (i = 0; i < p.n_rows; i++) {
            double values[MOST_COLUMNS], alone[MOST_COLUMNS], there[MOST_COLUMNS];
            fourlink_load loads[MOST_LOADS], own_loads[MOST_LOADS];
            fourlink_instant x, at;
            fourlink_forces forces;
            fourlink_state state;
            double gas_force;
            int status;

            memset(&forces, 0, sizeof forces);
            soil_stack();
            status = fourlink_results_row(r, branches[k], i, values, &x, loads);
            assert_int_equal(status, x.status);
            assert_int_equal(x.branch, branches[k]);
            assert_int_equal(
                fourlink_deck_loads(d, branches[k], x.row.crank.theta2, own_loads, &gas_force),
                FOURLINK_OK);
            for (j = 0; j < p.n_loads; j++) {
                assert_int_equal(loads[j].link, own_loads[j].link);
                assert_true(loads[j].force.x == own_loads[j].force.x &&
                            loads[j].force.y == own_loads[j].force.y &&
                            loads[j].torque == own_loads[j].torque);
            }
            assert_int_equal(fourlink_analyse(&p.mechanism, branches[k], &x.row.crank, own_loads,
                                              p.n_loads, &state, p.has_forces ? &forces : NULL),
                             status);
            assert_int_equal(fourlink_results_row(r, branches[k], i, alone, NULL, NULL), status);
            assert_true(same_numbers(values, alone, n, 0));
            assert_int_equal(fourlink_results_at(r, branches[k], x.row.angle, there, &at, NULL),
                             status);
            assert_true(same_numbers(values, there, n, 1e-12));
            assert_true(at.row.angle == x.row.angle);
            if (status == FOURLINK_OK) {
                assert_memory_equal(&x.forces, &forces, sizeof forces);
                assert_memory_equal(&x.state.link[2], &state.link[2], 3 * sizeof state.link[2]);
                assert_true(x.gas_force == gas_force);
            }
            for (j = 0; j < n; j++)
                if (status != FOURLINK_OK)
                    assert_int_equal(!isnan(values[j]), list[j].flags & FOURLINK_OF_CRANK);
        }
    fourlink_results_free(r);
}

/* A position of a deck is that of its rows, with all loads. */
TEST(test_deck_analyse)
{
    fourlink_results *r =
        opened(linkage("[spring S]\nlink = rocker\nat = 20 mm\nto = ground\nto_at = (50, 90) "
                       "mm\nstiffness = 2 N/mm\n"
                       "damping = 3 N s/m\n[friction]\nA = 0.1\nradius_A = 5 mm\n"));
    const fourlink_deck *d = fourlink_results_deck(r);
    fourlink_load loads[MOST_LOADS], own_loads[MOST_LOADS];
    fourlink_losses losses;
    fourlink_forces forces;
    fourlink_state state;
    fourlink_instant x;
    double gas = 7;

    assert_true(problem_of(r).n_loads <= MOST_LOADS);
    assert_int_equal(fourlink_results_row(r, FOURLINK_OPEN, 3, NULL, &x, loads), FOURLINK_OK);
    assert_int_equal(fourlink_deck_analyse(d, FOURLINK_OPEN, &x.row.crank, 0, own_loads, &state,
                                           &forces, &losses, &gas),
                     FOURLINK_OK);
    assert_close(forces.Ts, x.forces.Ts, 1e-12);
    assert_close(losses.Ts0, x.losses.Ts0, 1e-12);
    assert_true(losses.power > 0 && gas == 0);
    assert_int_equal(fourlink_deck_analyse(d, FOURLINK_OPEN, &x.row.crank, 0, own_loads, &state,
                                           NULL, &losses, &gas),
                     FOURLINK_NULL);
    assert_int_equal(fourlink_deck_analyse(NULL, FOURLINK_OPEN, &x.row.crank, 0, own_loads, &state,
                                           &forces, &losses, &gas),
                     FOURLINK_NULL);
    fourlink_results_free(r);
}

TEST(test_rows)
{
    static const char *const motions[] = {
        "interval = 40 deg\nspeed = 10 rad/s\n", "speed = -5 rad/s\nfrom = 20 deg\nto = -400 deg\n",
        "acceleration = 20 rad/s2\nrun_up = 100 deg\ninterval = 30 deg\n",
        "speed = 10 rad/s\nacceleration = -20 rad/s2\ninterval = 9 deg\n",
        "at = 77 deg\nspeed = 3 rad/s\nacceleration = 1 rad/s2\n"};
    size_t i;

    for (i = 0; i < COUNT(motions); i++) {
        const char *motion = print("[motion]\n%s", motions[i]);
        const char *load = "[load]\nlink = crank\ntorque = 0 deg 3 N m, 50 deg 9 N m\n";

        check_rows(four_bar(0.020, 0.066, 0.056, 0.080, motion));
        check_rows(four_bar(0.020, 0.066, 0.056, 0.080, print("%s%s", load, motion)));
        check_rows(four_bar(0.3, 0.4, 0.5, 0.75, motion));
        check_rows(four_bar(0.3, 0.4, 0.5, 0.75, print("%s%s", load, motion)));
        check_rows(four_bar(0.2, 0.5, 0.2, 0.5, print("%s%s", load, motion)));
        check_rows(slider_crank(0.4, 0.2, 0, motion));
        check_rows(slider_crank(0.1, 0.4, 0.02,
                                print("[gas]\nbore = 50 mm\npressure = 9 bar\n%s", motion)));
    }
}

TEST(test_rows_that_are_not_there)
{
    static const double beyond[] = {9.9,       50.1, 180,   -180, 369.9,  410.1,      INFINITY,
                                    -INFINITY, NAN,  1e300, 1e17, -1e300, 3.14159e60, 1e18};
    static const double reached[] = {10,   50,   30,   370,           410,
                                     -350, -310, 3610, 9.99999999999, 50.00000000001};
    fourlink_results *r = opened(linkage("from = 10 deg\nto = 50 deg\n")),
                     *whole = opened(linkage(""));
    fourlink_instant x, x_before;
    double values[MOST_COLUMNS], before[MOST_COLUMNS];
    fourlink_load load, load_before;
    fourlink_value v, v_before;
    size_t i;

    memset(values, 5, sizeof values);
    memset(&x, 5, sizeof x);
    memset(&load, 5, sizeof load);
    memset(&v, 5, sizeof v);
    memcpy(before, values, sizeof values);
    x_before = x, load_before = load, v_before = v;
    for (i = 0; i < COUNT(beyond); i++) {
        if (fourlink_results_at(r, FOURLINK_OPEN, beyond[i], values, &x, &load) !=
            FOURLINK_NO_SUCH_ANGLE)
            fail_msg("there is a row at %g deg", beyond[i]);
        assert_int_equal(fourlink_results_along(r, FOURLINK_OPEN, beyond[i], values, &x, &load),
                         FOURLINK_NO_SUCH_ANGLE);
        assert_int_equal(fourlink_results_value(r, "mu", FOURLINK_OPEN, beyond[i], &v),
                         FOURLINK_NO_SUCH_ANGLE);
        if (fabs(beyond[i]) < 1e10) /* within a turn; beyond, no turn has such an angle */
            continue;
        assert_int_equal(fourlink_results_value(whole, "mu", FOURLINK_OPEN, beyond[i], &v),
                         FOURLINK_NO_SUCH_ANGLE);
    }
    fourlink_results_free(whole);
    assert_int_equal(fourlink_results_row(r, FOURLINK_OPEN, 2, values, &x, &load),
                     FOURLINK_NO_SUCH_ROW);
    assert_int_equal(fourlink_results_row(r, FOURLINK_OPEN, (unsigned long)-1, values, &x, &load),
                     FOURLINK_NO_SUCH_ROW);
    assert_int_equal(fourlink_results_motion(r, FOURLINK_OPEN, 2, values, &x),
                     FOURLINK_NO_SUCH_ROW);
    for (i = 0; i < 4; i++) {
        static const int wrong[] = {0, 2, -2, 77};
        fourlink_branch branch = (fourlink_branch)wrong[i];

        assert_int_equal(fourlink_results_row(r, branch, 0, values, &x, &load),
                         FOURLINK_BAD_BRANCH);
        assert_int_equal(fourlink_results_motion(r, branch, 0, values, &x), FOURLINK_BAD_BRANCH);
        assert_int_equal(fourlink_results_brief(r, branch, 0, values, &x), FOURLINK_BAD_BRANCH);
        assert_int_equal(fourlink_results_at(r, branch, 20, values, &x, &load),
                         FOURLINK_BAD_BRANCH);
        assert_int_equal(fourlink_results_along(r, branch, 20, values, &x, &load),
                         FOURLINK_BAD_BRANCH);
        assert_int_equal(fourlink_results_motion_along(r, branch, 20, values, &x),
                         FOURLINK_BAD_BRANCH);
        assert_int_equal(fourlink_results_value(r, "mu", branch, 20, &v), FOURLINK_BAD_BRANCH);
    }
    assert_memory_equal(values, before, sizeof values);
    assert_memory_equal(&x, &x_before, sizeof x);
    assert_memory_equal(&load, &load_before, sizeof load);
    assert_memory_equal(&v, &v_before, sizeof v);
    for (i = 0; i < COUNT(reached); i++)
        if (fourlink_results_at(r, FOURLINK_OPEN, reached[i], NULL, NULL, NULL) != FOURLINK_OK)
            fail_msg("there is no row at %g deg", reached[i]);
    fourlink_results_free(r);
}

/* ---------------------------------------------------------------------------------------------
** Values and facts
** ------------------------------------------------------------------------------------------- */

TEST(test_statuses_of_values)
{
    static const struct {
        const char *name;
        int reaching, in_part, engine; /* statuses at 150 deg of three decks */
    } cases[] = {
        {"theta4", FOURLINK_OK, FOURLINK_TOO_FAR, FOURLINK_NO_SUCH_NAME},
        {"theta2", FOURLINK_OK, FOURLINK_OK, FOURLINK_OK},
        {"Ts", FOURLINK_OK, FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME},
        {"max(theta4)", FOURLINK_OK, FOURLINK_OK, FOURLINK_NO_SUCH_NAME},
        {"min( mu )", FOURLINK_OK, FOURLINK_OK, FOURLINK_OK},
        {"max(xyzzy)", FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME},
        {"max()", FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME},
        {"max(mu", FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME},
        {"mid(mu)", FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME},
        {"max(max(mu))", FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME},
        {"", FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME},
        {"xyzzy", FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME, FOURLINK_NO_SUCH_NAME},
        {"type", FOURLINK_OK, FOURLINK_OK, FOURLINK_OK},
        {"K", FOURLINK_OK, FOURLINK_OK, FOURLINK_NO_SUCH_FACT},
        {"mu_min", FOURLINK_OK, FOURLINK_OK, FOURLINK_OK},
        {"swing", FOURLINK_OK, FOURLINK_NO_SUCH_FACT, FOURLINK_NO_SUCH_FACT},
        {"stroke", FOURLINK_NO_SUCH_FACT, FOURLINK_NO_SUCH_FACT, FOURLINK_OK},
        {"mean_torque", FOURLINK_OK, FOURLINK_NO_SUCH_FACT, FOURLINK_NO_SUCH_FACT},
        {"flywheel_inertia", FOURLINK_NO_SUCH_FACT, FOURLINK_NO_SUCH_FACT, FOURLINK_NO_SUCH_FACT},
    };
    fourlink_results *decks[3];
    int k, b;
    size_t i;

    decks[0] = opened(linkage(""));
    decks[1] = opened(four_bar(0.3, 0.4, 0.5, 0.75, revolution(1)));
    decks[2] = opened(slider_crank(0.1, 0.3, 0, revolution(1)));
    for (i = 0; i < COUNT(cases); i++)
        for (k = 0; k < 3; k++)
            for (b = 0; b < 2; b++) {
                int expected = k == 0   ? cases[i].reaching
                               : k == 1 ? cases[i].in_part
                                        : cases[i].engine;
                fourlink_value v, before;
                int status;

                memset(&v, 5, sizeof v);
                before = v;
                status = fourlink_results_value(decks[k], cases[i].name, branches[b], 150, &v);
                if (status != expected)
                    fail_msg("%s of deck %d: %s", cases[i].name, k, fourlink_status_text(status));
                if (status != FOURLINK_OK)
                    assert_memory_equal(&v, &before, sizeof v);
                else if (!v.words)
                    assert_true(isfinite(v.value) && v.to_si > 0 && *v.quantity);
            }
    for (k = 0; k < 3; k++)
        fourlink_results_free(decks[k]);
}

/* The groups of facts are parts of the whole, in the deck's branches or in one; extremes are those that are
** asked for by name. */
TEST(test_groups_of_facts)
{
    static const struct {
        const char *branch;
        int open, crossed;
    } decks[] = {{"both", 1, 1}, {"open", 1, 0}, {"crossed", 0, 1}};
    static const int groups[] = {FOURLINK_FACTS_LIMITS, FOURLINK_FACTS_EXTREMES,
                                 FOURLINK_FACTS_TURNING};
    size_t i, k;

    for (i = 0; i < COUNT(decks); i++) {
        fourlink_results *r = opened(linkage(
            print("[table]\ncolumns = theta2, Ts, mu, omega4\nbranch = %s\n", decks[i].branch)));
        unsigned long n, total = 0, open = 0, crossed = 0, both = 0, j;
        const fourlink_value *list;
        fourlink_value v;

        for (k = 0; k < 3; k++) {
            assert_int_equal(fourlink_results_facts(r, 0, groups[k], &list, &n), FOURLINK_OK);
            total += n;
        }
        assert_int_equal(fourlink_results_facts(r, 0, 7, &list, &n), FOURLINK_OK);
        assert_int_equal(n, total);
        for (j = 0; j < n; j++) {
            open += list[j].branch == FOURLINK_OPEN;
            crossed += list[j].branch == FOURLINK_CROSSED;
            both += list[j].branch == 0;
        }
        assert_int_equal(open > 0, decks[i].open);
        assert_int_equal(crossed > 0, decks[i].crossed);
        assert_int_equal(open + crossed + both, n);
        assert_int_equal(fourlink_results_facts(r, FOURLINK_CROSSED, 7, &list, &n), FOURLINK_OK);
        assert_int_equal(n, both + (open > crossed ? open : crossed));
        assert_int_equal(
            fourlink_results_facts(r, FOURLINK_CROSSED, FOURLINK_FACTS_EXTREMES, &list, &n),
            FOURLINK_OK);
        assert_int_equal(n, 6); /* of the crank angle there are none */
        for (j = 0; j < n; j++) {
            assert_int_equal(fourlink_results_value(r, list[j].name, FOURLINK_CROSSED, 0, &v),
                             FOURLINK_OK);
            assert_true(v.value == list[j].value && v.angle == list[j].angle);
            assert_string_equal(v.unit, list[j].unit);
        }
        assert_int_equal(fourlink_results_facts(r, 0, FOURLINK_FACTS_EXTREMES, &list, &n),
                         FOURLINK_OK);
        for (j = 1; j < n; j++) /* the open branch first */
            assert_true(list[j].branch <= list[j - 1].branch);
        assert_int_equal(fourlink_results_facts(r, 0, 0, &list, &n), FOURLINK_OK);
        assert_int_equal(n, 0);
        n = 77;
        assert_int_equal(fourlink_results_facts(r, 2, 7, &list, &n), FOURLINK_BAD_BRANCH);
        assert_int_equal(n, 77);
        fourlink_results_free(r);
    }
}

TEST(test_statuses_of_turning_moment_and_checks)
{
    fourlink_results *r = opened(linkage("[expect]\nmu_min = 58.2 deg\n"));
    fourlink_turning t, t_before;
    fourlink_check c, c_before;

    memset(&t, 5, sizeof t);
    memset(&c, 5, sizeof c);
    t_before = t, c_before = c;
    assert_int_equal(fourlink_results_turning(r, (fourlink_branch)0, &t), FOURLINK_BAD_BRANCH);
    assert_int_equal(fourlink_results_check(r, 1, &c), FOURLINK_NO_SUCH_ROW);
    assert_memory_equal(&t, &t_before, sizeof t);
    assert_memory_equal(&c, &c_before, sizeof c);
    assert_int_equal(fourlink_results_turning(r, FOURLINK_CROSSED, &t), FOURLINK_OK);
    assert_int_equal(fourlink_results_check(r, 0, &c), FOURLINK_OK);
    assert_int_equal(c.verdict, FOURLINK_AGREES);
    fourlink_results_free(r);
}

/* ---------------------------------------------------------------------------------------------
** What was returned stays, whatever is called before it is read
** ------------------------------------------------------------------------------------------- */

#define MOST_KEPT 3000

/* A value as it was returned, and what its texts were. */
typedef struct kept {
    fourlink_value now, then;
    char texts[6][200];
} kept;

static const char *text_number(const fourlink_value *v, int i)
{
    const char *const texts[6] = {v->name,    v->unit,  v->quantity,
                                  v->meaning, v->words, v->line_unit};

    return texts[i] ? texts[i] : "";
}

static void keep_value(kept *list, unsigned long *n, const fourlink_value *v)
{
    int i;

    assert_true(*n < MOST_KEPT);
    list[*n].now = list[*n].then = *v;
    for (i = 0; i < 6; i++)
        snprintf(list[*n].texts[i], sizeof list[*n].texts[i], "%s", text_number(v, i));
    ++*n;
}

/* Ask for all that has a name, in every way. */
static void ask_by_name(fourlink_results *r, kept *list, unsigned long *n)
{
    static const char *const names[] = {"crank.length",   "motion.speed", "gravity.acceleration",
                                        "load Tl.torque", "crank.mass",   "mu_min",
                                        "max(Ts)",        "mean(omega4)", "theta4",
                                        "type",           "torque",       "ground.length"};
    fourlink_value v;
    unsigned long i;
    int branch;

    for (i = 0; i < sizeof names / sizeof names[0]; i++) {
        fourlink_results_meant(r, names[i]);
        if (fourlink_results_input(r, names[i], &v) == FOURLINK_OK && list)
            keep_value(list, n, &v);
        if (fourlink_results_find(r, names[i], &v) == FOURLINK_OK && list)
            keep_value(list, n, &v);
        for (branch = FOURLINK_OPEN; branch <= FOURLINK_CROSSED; branch++)
            if (fourlink_results_value(r, names[i], (fourlink_branch)branch, 40, &v) ==
                    FOURLINK_OK &&
                list)
                keep_value(list, n, &v);
    }
}

/* All else that does not change the design. */
static void ask_the_rest(fourlink_results *r)
{
    static double values[MOST_COLUMNS], places[50];
    fourlink_mistake mistakes[5];
    fourlink_turning turning;
    fourlink_instant now;
    const fourlink_value *list;
    fourlink_check check;
    unsigned long n;
    int which;

    for (which = FOURLINK_COLUMNS; which <= FOURLINK_CONDITIONS; which++)
        fourlink_results_list(r, which, &list, &n);
    fourlink_results_row(r, FOURLINK_OPEN, 2, values, &now, NULL);
    fourlink_results_at(r, FOURLINK_CROSSED, 70, values, &now, NULL);
    fourlink_results_crossings(r, "theta4", FOURLINK_OPEN, 120, 50, places, &n);
    fourlink_results_turning(r, FOURLINK_OPEN, &turning);
    fourlink_results_end(r, FOURLINK_OPEN, values);
    fourlink_results_check(r, 0, &check);
    fourlink_results_slips(r, 5, mistakes, &n);
    fourlink_results_notes(r, 5, mistakes, &n);
}

static unsigned long changed_texts(const kept *list, unsigned long n)
{
    unsigned long k, changed = 0;
    int i;

    for (k = 0; k < n; k++)
        for (i = 0; i < 6; i++)
            changed += strcmp(text_number(&list[k].now, i), list[k].texts[i]) != 0;
    return changed;
}

TEST(test_what_was_returned_stays)
{
    static kept list[MOST_KEPT];
    fourlink_results *r = opened(linkage("[units]\nlength = mm\nangular_speed = rpm\n"
                                         "[gravity]\nacceleration = 32.2 ft/s2\n"
                                         "[expect]\nmu_min = 58.2 deg\n"));
    const fourlink_value *facts;
    unsigned long n = 0, n_facts, i;
    int which;

    for (which = FOURLINK_COLUMNS; which <= FOURLINK_CONDITIONS; which++) {
        fourlink_results_list(r, which, &facts, &n_facts);
        for (i = 0; i < n_facts; i++)
            keep_value(list, &n, &facts[i]);
    }
    assert_int_equal(fourlink_results_facts(r, 0, FOURLINK_FACTS_LIMITS, &facts, &n_facts),
                     FOURLINK_OK);
    for (i = 0; i < n_facts; i++)
        keep_value(list, &n, &facts[i]);
    i = n - n_facts;
    ask_by_name(r, list, &n);
    ask_by_name(r, NULL, NULL);
    ask_the_rest(r);
    assert_int_equal(changed_texts(list, n), 0);
    while (n_facts--) /* the list itself, too */
        assert_memory_equal(&facts[n_facts], &list[i + n_facts].then, sizeof *facts);
    fourlink_results_free(r);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
