/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_problem.c - decks for programs that embed the library, and the calls for FORTRAN 77.
*/
#include <stdlib.h>

#include "check.h"
#include "fourlink.h"

#define ENGINE                                           \
    "title = An engine\n"                                \
    "mechanism = slider-crank\n"                         \
    "[crank]\nlength = 100 mm\n"                         \
    "[rod]\nlength = 400 mm\nmass = 3 kg\ncg = 150 mm\n" \
    "[piston]\nmass = 2 kg\n"                            \
    "[motion]\nspeed = 20 rad/s\ncycle = 720 deg\n"      \
    "[load brake]\nlink = crank\ntorque = 5 N m\n"       \
    "from = 10 deg\nto = 30 deg\n"                       \
    "[load cam]\nlink = rod\ntorque = file cam.txt\n"    \
    "[point P]\nlink = rod\nat = 200 mm at 90 deg\n"     \
    "[table]\nbranch = crossed\n"                        \
    "[flywheel]\nfluctuation = 0.02\n"                   \
    "[gas]\nbore = 100 mm\npressure = 2 bar\n"           \
    "back_pressure = 1 bar\npiston_rod = 50 mm\n"

static fourlink_deck *untouched = (fourlink_deck *)&untouched;

static const char *load_cam(void *host, const char *file_name, unsigned long *length)
{
    const char *contents = host;

    assert_string_equal(file_name, "cam.txt");
    *length = contents ? (unsigned long)strlen(contents) : 0;
    return contents;
}

static int read_deck(const char *contents, const char *cam, fourlink_deck **deck,
                     fourlink_mistake *mistakes, unsigned long max, unsigned long *n)
{
    return fourlink_deck_read(contents, (unsigned long)strlen(contents), load_cam, (void *)cam, max,
                              deck, mistakes, n);
}

/* Forgets the length. */
static const char *load_without_length(void *host, const char *file_name, unsigned long *length)
{
    (void)file_name;
    (void)length;
    return host;
}

/* A file whose length its loader does not set is empty; nothing behind its text is read. */
TEST(test_loader_without_length)
{
    char *cam = malloc(1);
    fourlink_mistake mistake;
    fourlink_deck *deck = untouched;

    assert_non_null(cam);
    *cam = '0';
    assert_int_equal(fourlink_deck_read(ENGINE, sizeof ENGINE - 1, load_without_length, cam, 1,
                                        &deck, &mistake, NULL),
                     FOURLINK_BAD_DECK);
    assert_ptr_equal(deck, untouched);
    free(cam);
}

TEST(test_problem)
{
    fourlink_deck *deck = NULL;
    fourlink_problem p;
    const char *name;
    int link;
    fourlink_vector at;

    assert_int_equal(read_deck(ENGINE, "0 1\n90 2\n", &deck, NULL, 0, NULL), FOURLINK_OK);
    memset(&p, 0x55, sizeof p);
    assert_int_equal(fourlink_deck_problem(deck, &p), FOURLINK_OK);
    assert_string_equal(p.title, "An engine");
    assert_int_equal(p.mechanism.design.kind, FOURLINK_SLIDER_CRANK);
    assert_near(p.mechanism.design.link[2].length, 0.1, 0);
    assert_near(p.mechanism.design.link[3].cg.x, 0.15, 0);
    assert_near(p.mechanism.design.gravity.y, -9.81, 0);
    assert_near(p.motion.speed, 20, 0);
    assert_near(p.motion.to, 720, 0);
    assert_near(p.cycle, 4 * M_PI, 1e-14);
    assert_true(p.crossed && !p.open && !p.asks_for_both && p.has_forces);
    assert_true(p.has_gas && !p.has_friction);
    assert_int_equal(p.n_loads, 3);
    assert_int_equal(p.n_points, 1);
    assert_int_equal(p.approximation, FOURLINK_EXACT);
    assert_near(p.flywheel_fluctuation, 0.02, 0);
    assert_near(p.flywheel_inertia, 0, 0);
    assert_int_equal(p.n_rows, 73);
    assert_true(!p.one_instant && !p.one_revolution && !p.has_outputs);
    assert_int_equal(p.digits, 6);
    assert_int_equal(p.n_expected, 0);
    assert_int_equal(p.n_designs, 0);

    assert_int_equal(fourlink_deck_point(deck, 0, &name, &link, &at), FOURLINK_OK);
    assert_string_equal(name, "P");
    assert_int_equal(link, 3);
    assert_near(at.x, 0, 0);
    assert_near(at.y, 0.2, 0);
    link = 77;
    assert_int_equal(fourlink_deck_point(deck, 1, &name, &link, &at), FOURLINK_NO_SUCH_POINT);
    assert_int_equal(link, 77);
    fourlink_deck_free(deck);
    fourlink_deck_free(NULL);
}

TEST(test_problem_of_a_sweep)
{
    fourlink_deck *deck = NULL;
    fourlink_problem p;

    assert_int_equal(
        read_deck("mechanism = slider-crank\n[crank]\nlength = 0.1\n[rod]\nlength = 0.4\n"
                  "[motion]\nspeed = 1\nat = 30\n[table]\ndigits = 9\n"
                  "[expect]\nx = 1\nv = 2\n"
                  "[sweep]\nrod.length = 0.3, 0.4, 0.5\noutput = x\n",
                  NULL, &deck, NULL, 0, NULL),
        FOURLINK_OK);
    assert_int_equal(fourlink_deck_problem(deck, &p), FOURLINK_OK);
    assert_int_equal(p.n_rows, 1);
    assert_true(p.one_instant && p.has_outputs);
    assert_int_equal(p.digits, 9);
    assert_int_equal(p.n_expected, 2);
    assert_int_equal(p.n_designs, 3);
    assert_near(p.mechanism.design.link[3].length, 0.3, 0);
    fourlink_deck_free(deck);
}

/* Both branches are asked for by their key in [table] alone; without it they are only not excluded. */
TEST(test_branches)
{
    static const struct {
        const char *table;
        int open, crossed, asks_for_both;
    } cases[] = {{"", 1, 1, 0},
                 {"# branch = both\n", 1, 1, 0},
                 {"[table]\nbranch = open\n", 1, 0, 0},
                 {"[table]\nbranch = crossed\n", 0, 1, 0},
                 {"[table]\nbranch = both\n", 1, 1, 1},
                 {"[table]\nbranch = both\n[expect]\nbranch = open\nmu_min = 1 deg\n", 1, 1, 1},
                 {"[gas]\nbore = 100 mm\npressure = 2 bar\n", 1, 0, 0},
                 {"[gas]\nbore = 100 mm\npressure = 2 bar\n[table]\nbranch = both\n", 1, 1, 1}};
    char contents[1000];
    fourlink_deck *deck = NULL;
    fourlink_problem p;
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        sprintf(contents, "mechanism = slider-crank\n[crank]\nlength = 1\n[rod]\nlength = 4\n%s",
                cases[i].table);
        assert_int_equal(read_deck(contents, NULL, &deck, NULL, 0, NULL), FOURLINK_OK);
        assert_int_equal(fourlink_deck_problem(deck, &p), FOURLINK_OK);
        assert_int_equal(p.open, cases[i].open);
        assert_int_equal(p.crossed, cases[i].crossed);
        assert_int_equal(p.asks_for_both, cases[i].asks_for_both);
        fourlink_deck_free(deck);
    }
}

TEST(test_units_and_names_of_loads)
{
    static const fourlink_load_info loads[] = {{"brake", FOURLINK_LOAD_OWN, 0, FOURLINK_CRANK, 1},
                                               {"cam", FOURLINK_LOAD_OWN, 1, FOURLINK_COUPLER, 1},
                                               {"load", FOURLINK_LOAD_OWN, 2, FOURLINK_FOLLOWER, 0},
                                               {"gas", FOURLINK_LOAD_GAS, 0, FOURLINK_FOLLOWER, 0}};
    fourlink_deck *deck = NULL;
    fourlink_unit u;
    fourlink_load_info load;
    unsigned long i;

    assert_int_equal(read_deck(ENGINE "[load]\nlink = piston\nforce = (1, 0) N\n"
                                      "[units]\nlength = mm\n",
                               "0 1\n90 2\n", &deck, NULL, 0, NULL),
                     FOURLINK_OK);
    for (i = 0; i < 4; i++) {
        assert_int_equal(fourlink_deck_load(deck, i, &load), FOURLINK_OK);
        assert_string_equal(load.name, loads[i].name);
        assert_int_equal(load.sort, loads[i].sort);
        assert_int_equal(load.element, loads[i].element);
        assert_int_equal(load.link, loads[i].link);
        assert_int_equal(load.has_torque, loads[i].has_torque);
    }
    assert_int_equal(fourlink_deck_load(deck, 4, &load), FOURLINK_BAD_LINK);
    assert_string_equal(load.name, "gas"); /* untouched */
    assert_int_equal(fourlink_deck_load(NULL, 0, &load), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_load(deck, 0, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_unit(deck, "length", &u), FOURLINK_OK);
    assert_string_equal(u.name, "mm");
    assert_near(u.up / u.down, 0.001, 0);
    assert_int_equal(fourlink_deck_unit(deck, "force", &u), FOURLINK_OK);
    assert_string_equal(u.name, "N");
    assert_int_equal(fourlink_deck_unit(deck, "drawn_length", &u), FOURLINK_NO_SUCH_NAME);
    assert_int_equal(fourlink_deck_unit(deck, "colour", &u), FOURLINK_NO_SUCH_NAME);
    assert_int_equal(fourlink_deck_unit(deck, NULL, &u), FOURLINK_NULL);
    fourlink_deck_free(deck);
}

/* Numbers in words, in the deck's units: as they are written, or by the factors of NIST SP 811. */
TEST(test_quantity)
{
    const struct {
        const char *quantity, *words;
        double value;
    } read[] = {{"length", "0.9 in", 0.9 * 25.4}, {"length", " 20.1mm ", 20.1},
                {"length", "20.1", 20.1},         {"angle", "30.7 deg", 30.7},
                {"angle", "1/3 rev", 120},        {"angle", "pi/6", 30},
                {"angular_speed", "60 rpm", 60},  {"force", "1 lbf", 4.4482216152605}};
    const char *deck_text = "mechanism = four-bar\n[units]\nlength = mm\nangular_speed = rpm\n"
                            "[ground]\nlength = 80\n[crank]\nlength = 20\n[coupler]\n"
                            "length = 66\n[rocker]\nlength = 56\n";
    fourlink_deck *deck;
    fourlink_mistake mistake;
    double value = 7;
    size_t i;

    assert_int_equal(fourlink_deck_read(deck_text, (unsigned long)strlen(deck_text), NULL, NULL, 0,
                                        &deck, NULL, NULL),
                     FOURLINK_OK);
    assert_int_equal(fourlink_deck_quantity(deck, "length", "3 kg", &value, &mistake),
                     FOURLINK_BAD_DECK);
    assert_non_null(strstr(mistake.message, "'3 kg'"));
    assert_int_equal(mistake.line, 0);
    assert_int_equal(fourlink_deck_quantity(deck, "length", "1 2", &value, NULL),
                     FOURLINK_BAD_DECK);
    assert_int_equal(fourlink_deck_quantity(deck, "colour", "1", &value, NULL),
                     FOURLINK_NO_SUCH_NAME);
    assert_int_equal(fourlink_deck_quantity(deck, "length", NULL, &value, NULL), FOURLINK_NULL);
    assert_near(value, 7, 0); /* untouched */
    for (i = 0; i < sizeof read / sizeof *read; i++) {
        assert_int_equal(
            fourlink_deck_quantity(deck, read[i].quantity, read[i].words, &value, NULL),
            FOURLINK_OK);
        assert_near(value, read[i].value, 1e-15 * read[i].value);
    }
    fourlink_deck_free(deck);
}

/* p1 A1 - p2 A2 with A1 = pi/4 D^2, A2 = pi/4 (D^2 - d^2), by hand; it pushes the piston towards the
** crank: along -x on the open branch. */
TEST(test_loads)
{
    static const double gas_force = 3.14159265358979 / 4 * (2e5 * 0.01 - 1e5 * (0.01 - 0.0025));
    fourlink_deck *deck = NULL;
    fourlink_load loads[3];
    double gas = 0;
    int i;

    assert_int_equal(read_deck(ENGINE, "0 1\n90 2\n", &deck, NULL, 0, NULL), FOURLINK_OK);
    for (i = -1; i <= 1; i += 2) {
        memset(loads, 0x55, sizeof loads);
        assert_int_equal(fourlink_deck_loads(deck, (fourlink_branch)i, 20 * DEG, loads, &gas),
                         FOURLINK_OK);
        assert_close(gas, gas_force, 1e-12);
        assert_int_equal(loads[2].link, FOURLINK_FOLLOWER);
        assert_int_equal(loads[2].frame, FOURLINK_FRAME_GROUND);
        assert_near(loads[2].force.x, -i * gas, 0);
        assert_near(loads[2].force.y, 0, 0);
        assert_near(loads[2].at.x, 0, 0);
        assert_near(loads[2].torque, 0, 0);
        assert_int_equal(loads[0].link, FOURLINK_CRANK);
        assert_near(loads[0].torque, 5, 0);
        assert_int_equal(loads[1].link, FOURLINK_COUPLER);
    }
    /* outside the window; a point of the curve, one cycle on */
    assert_int_equal(fourlink_deck_loads(deck, FOURLINK_OPEN, (90 + 720) * DEG, loads, NULL),
                     FOURLINK_OK);
    assert_near(loads[0].torque, 0, 0);
    assert_near(loads[1].torque, 2, 1e-12);
    /* and back in it, one cycle before */
    assert_int_equal(fourlink_deck_loads(deck, FOURLINK_OPEN, (25 - 720) * DEG, loads, NULL),
                     FOURLINK_OK);
    assert_near(loads[0].torque, 5, 0);

    loads[0].torque = 77;
    assert_int_equal(fourlink_deck_loads(deck, (fourlink_branch)0, 0, loads, NULL),
                     FOURLINK_BAD_BRANCH);
    assert_int_equal(fourlink_deck_loads(deck, FOURLINK_OPEN, NAN, loads, NULL),
                     FOURLINK_BAD_NUMBER);
    assert_int_equal(fourlink_deck_loads(deck, FOURLINK_OPEN, 0, NULL, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_loads(NULL, FOURLINK_OPEN, 0, loads, NULL), FOURLINK_NULL);
    assert_near(loads[0].torque, 77, 0);
    fourlink_deck_free(deck);
}

/* A deck gives what the same mechanism, filled in by hand, gives. */
TEST(test_deck_and_hand)
{
    static const char contents[] = "mechanism = four-bar\n[ground]\nlength = 80 mm\n"
                                   "[crank]\nlength = 20 mm\nmass = 100 g\n"
                                   "[coupler]\nlength = 66 mm\nmass = 0.3 kg\ngyration = 25 mm\n"
                                   "[rocker]\nlength = 56 mm\n"
                                   "[motion]\nspeed = 10.5 rad/s\ninterval = 40 deg\n";
    fourlink_deck *deck = NULL;
    fourlink_problem p;
    fourlink_design design;
    fourlink_mechanism mechanism;
    fourlink_range range;
    fourlink_row row;
    fourlink_state s[2];
    fourlink_forces f[2];
    unsigned long i;

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_FOUR_BAR;
    design.link[1].length = 0.08;
    design.link[2].length = 0.02;
    design.link[2].mass = 0.1;
    design.link[3].length = 0.066;
    design.link[3].mass = 0.3;
    design.link[3].inertia = 0.3 * 0.025 * 0.025;
    design.link[4].length = 0.056;
    design.gravity.y = -9.81;
    assert_int_equal(fourlink_prepare(&design, &mechanism), FOURLINK_OK);
    assert_int_equal(read_deck(contents, NULL, &deck, NULL, 0, NULL), FOURLINK_OK);
    assert_int_equal(fourlink_deck_problem(deck, &p), FOURLINK_OK);
    assert_int_equal(p.n_loads, 0);
    assert_int_equal(fourlink_motion_range(&p.motion, &range), FOURLINK_OK);
    assert_int_equal(range.n_rows, 10);
    for (i = 0; i < range.n_rows; i++) {
        fourlink_crank crank = {(double)i * 40 * DEG, 10.5, 0};

        assert_int_equal(fourlink_motion_row(&p.motion, &range, i, &row), FOURLINK_OK);
        assert_int_equal(fourlink_deck_loads(deck, FOURLINK_OPEN, row.crank.theta2, NULL, NULL),
                         FOURLINK_OK);
        assert_int_equal(
            fourlink_analyse(&p.mechanism, FOURLINK_OPEN, &row.crank, NULL, 0, &s[0], &f[0]),
            FOURLINK_OK);
        assert_int_equal(fourlink_analyse(&mechanism, FOURLINK_OPEN, &crank, NULL, 0, &s[1], &f[1]),
                         FOURLINK_OK);
        assert_near(f[0].Ts, f[1].Ts, 1e-15);
        assert_near(f[0].F34x, f[1].F34x, 1e-13);
        assert_near(s[0].link[4].alpha, s[1].link[4].alpha, 1e-12);
    }
    fourlink_deck_free(deck);
}

TEST(test_mistakes)
{
    static const char contents[] = "mechanism = four-bar\n"
                                   "[ground]\nlength = 80 parsec\n"
                                   "[crank]\nlength = -20 mm\n"
                                   "[coupler]\nlength = 66 mm\n"
                                   "[rocker]\nlength = 56 mm\nhue = 3\n";
    static const long lines[] = {3, 5, 10};
    static const char *const words[] = {"parsec", "positive", "hue"};
    fourlink_deck *deck = untouched;
    fourlink_mistake list[5];
    unsigned long n = 0;
    int i;

    memset(list, 0x55, sizeof list);
    assert_int_equal(read_deck(contents, NULL, &deck, list, 5, &n), FOURLINK_BAD_DECK);
    assert_ptr_equal(deck, untouched);
    assert_int_equal(n, 3);
    for (i = 0; i < 3; i++) {
        assert_string_equal(list[i].file, "");
        assert_int_equal(list[i].line, lines[i]);
        assert_non_null(strstr(list[i].message, words[i]));
    }
    assert_int_equal(list[3].file[0], 0x55);
    /* room for one of them, and for none */
    memset(list, 0x55, sizeof list);
    n = 0;
    assert_int_equal(read_deck(contents, NULL, &deck, list, 1, &n), FOURLINK_BAD_DECK);
    assert_int_equal(n, 3);
    assert_int_equal(list[0].line, 3);
    assert_int_equal(list[1].file[0], 0x55);
    assert_int_equal(read_deck(contents, NULL, &deck, NULL, 0, NULL), FOURLINK_BAD_DECK);
}

TEST(test_mistakes_of_files)
{
    fourlink_deck *deck = untouched;
    fourlink_mistake list[2];
    unsigned long n = 0;

    assert_int_equal(read_deck(ENGINE, "0 1\n90 two\n", &deck, list, 2, &n), FOURLINK_BAD_DECK);
    assert_int_equal(n, 1);
    assert_string_equal(list[0].file, "cam.txt");
    assert_int_equal(list[0].line, 2);
    /* there is none; no files at all */
    assert_int_equal(read_deck(ENGINE, NULL, &deck, list, 2, &n), FOURLINK_BAD_DECK);
    assert_non_null(strstr(list[0].message, "cam.txt"));
    assert_int_equal(
        fourlink_deck_read(ENGINE, (unsigned long)strlen(ENGINE), NULL, NULL, 2, &deck, list, &n),
        FOURLINK_BAD_DECK);
    assert_string_equal(list[0].file, "");
    assert_int_equal(list[0].line, 21);
    assert_ptr_equal(deck, untouched);
}

TEST(test_program)
{
    static const char contents[] =
        "mechanism = four-bar\n"
        "[ground]\nlength = 80 mm\n"
        "[crank]\nlength = 20 mm\n"
        "[coupler]\nlength = 66 mm\n"
        "[rocker]\nlength = 56 mm\n"
        "[motion]\nprogram = 0 s 0 rad/s, 0.5 s 6 rad/s, 2 s 0 rad/s\n"
        "program_of = speed\nfrom = 1 rad\nlaw = linear\ntime_step = 0.1 s\n";
    fourlink_program_part part;
    fourlink_deck *deck;

    assert_int_equal(read_deck(contents, NULL, &deck, NULL, 0, NULL), FOURLINK_OK);
    assert_int_equal(fourlink_deck_program(deck, 1.25, &part), FOURLINK_OK);
    assert_string_equal(part.law, "linear");
    assert_near(part.begin, 0.5, 0);
    assert_near(part.end, 2, 0);
    assert_near(part.value, 6, 0);
    assert_near(part.rise, -6, 0);
    assert_near(part.coordinate, 1 + 0.5 * 6 / 2, 1e-15); /* the area of a triangle */
    assert_true(part.is_angle && part.is_of_speed);
    assert_int_equal(fourlink_deck_program(deck, -1, &part), FOURLINK_OK);
    assert_near(part.begin, 0, 0);
    assert_int_equal(fourlink_deck_program(deck, 1, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_program(NULL, 1, &part), FOURLINK_NULL);
    fourlink_deck_free(deck);
}

TEST(test_nulls)
{
    fourlink_deck *deck = untouched;
    fourlink_problem p;
    fourlink_vector at;
    int link;

    assert_int_equal(fourlink_deck_read(NULL, 0, NULL, NULL, 0, &deck, NULL, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_read("", 0, NULL, NULL, 0, NULL, NULL, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_read("", 0, NULL, NULL, 1, &deck, NULL, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_read("", 0, NULL, NULL, 0, &deck, NULL, NULL),
                     FOURLINK_BAD_DECK);
    assert_ptr_equal(deck, untouched);
    assert_int_equal(fourlink_deck_problem(NULL, &p), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_point(NULL, 0, NULL, &link, &at), FOURLINK_NULL);
}

/* The locale and the error handler are the host's. */
TEST(test_error_handler)
{
    gsl_error_handler_t *old = gsl_set_error_handler(fail_in_gsl);

    test_loads(NULL);
    test_mistakes(NULL);
    assert_ptr_equal(gsl_set_error_handler(old), fail_in_gsl);
}

/* FORTRAN 77: the numbers of fourlink_analyse, in the order of the arrays. */
TEST(test_fortran77)
{
    static const double links[20] = {0.08,  0,    0,    0,     0,     /* ground */
                                     0.02,  0.1,  1e-5, 0.01,  0.001, /* crank */
                                     0.066, 0.3,  2e-4, 0.03,  0.005, /* coupler */
                                     0.056, 0.25, 1e-4, 0.028, -0.002};
    static const double gravity[2] = {0.3, -9.81}, crank[3] = {0.7, 10.5, 2}, offset = 0.01;
    static const double numbers[14] = {4, 0, 1, 2, 0.03, 0.01, 0.5, 3, 1, -3, 4, 0.02, 0, 0};
    fourlink_load loads[2] = {{4, FOURLINK_FRAME_GROUND, {1, 2}, {0.03, 0.01}, 0.5},
                              {3, FOURLINK_FRAME_LINK, {-3, 4}, {0.02, 0}, 0}};
    fourlink_crank c = {0.7, 10.5, 2};
    int kind, i, n = 2;

    for (kind = 1; kind <= 2; kind++) {
        int branch = kind == 1 ? -1 : 1, status = 77;
        double state[36], forces[10];
        fourlink_design d;
        fourlink_mechanism m;
        fourlink_state s;
        fourlink_forces f;

        memset(&d, 0, sizeof d);
        d.kind = (fourlink_kind)kind;
        d.offset = kind == 2 ? offset : 0;
        d.gravity.x = gravity[0];
        d.gravity.y = gravity[1];
        for (i = 1; i <= 4; i++) {
            d.link[i].length = links[5 * i - 5];
            d.link[i].mass = links[5 * i - 5 + 1];
            d.link[i].inertia = links[5 * i - 5 + 2];
            d.link[i].cg.x = links[5 * i - 5 + 3];
            d.link[i].cg.y = links[5 * i - 5 + 4];
        }
        assert_int_equal(fourlink_prepare(&d, &m), FOURLINK_OK);
        assert_int_equal(fourlink_analyse(&m, (fourlink_branch)branch, &c, loads, 2, &s, &f),
                         FOURLINK_OK);
        if (kind == 1)
            flfbar_(links, gravity, &branch, crank, &n, numbers, state, forces, &status);
        else
            flslcr_(links, &offset, gravity, &branch, crank, &n, numbers, state, forces, &status);
        assert_int_equal(status, 0);
        for (i = 2; i <= 4; i++) {
            const fourlink_link_state *link = &s.link[i];
            double expected[9] = {link->theta,      link->omega,          link->alpha,
                                  link->origin.x,   link->origin.y,       link->velocity.x,
                                  link->velocity.y, link->acceleration.x, link->acceleration.y};

            assert_memory_equal(&state[9 * i - 9], expected, sizeof expected);
            assert_near(state[i], 0, 0);
        }
        assert_near(forces[0], f.F12x, 0);
        assert_near(forces[3], f.F23y, 0);
        assert_near(forces[4], f.F34x, 0);
        assert_near(forces[7], f.F14y, 0);
        assert_near(forces[8], f.M14, 0);
        assert_near(forces[9], f.Ts, 0);
    }
}

TEST(test_fortran77_refuses)
{
    static const struct {
        int branch, n;
        double link, frame, length;
        int status;
    } cases[] = {{1, 1, 4, 0, 0.056, 0},
                 {0, 1, 4, 0, 0.056, FOURLINK_BAD_BRANCH},
                 {1, -1, 4, 0, 0.056, FOURLINK_TOO_MANY_LOADS},
                 {1, 101, 4, 0, 0.056, FOURLINK_TOO_MANY_LOADS},
                 {1, 1, 4.5, 0, 0.056, FOURLINK_BAD_LINK},
                 {1, 1, 1, 0, 0.056, FOURLINK_BAD_LINK},
                 {1, 1, NAN, 0, 0.056, FOURLINK_BAD_LINK},
                 {1, 1, 4, 0.5, 0.056, FOURLINK_BAD_FRAME},
                 {1, 1, 4, 2, 0.056, FOURLINK_BAD_FRAME},
                 {1, 1, 4, 0, -1, FOURLINK_BAD_LENGTH},
                 {1, 1, 4, 0, NAN, FOURLINK_BAD_NUMBER},
                 {1, 1, 4, 0, 0.2, FOURLINK_TOO_NEAR}};
    static const double gravity[2] = {0, -9.81}, crank[3] = {0.7, 10.5, 2};
    char text[60];
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        double links[20] = {0};
        double numbers[7] = {4, 0, 0, 0, 0, 0, 0.5}, state[36], forces[10];
        int status = 77;

        links[0] = 0.08;
        links[5] = 0.02;
        links[10] = 0.066;
        links[15] = cases[i].length;
        numbers[0] = cases[i].link;
        numbers[1] = cases[i].frame;
        state[9] = forces[9] = 77;
        flfbar_(links, gravity, &cases[i].branch, crank, &cases[i].n, numbers, state, forces,
                &status);
        assert_int_equal(status, cases[i].status);
        assert_true((state[9] == 77) == (status != 0));
        assert_true((forces[9] == 77) == (status != 0));
    }
    memset(text, '*', sizeof text);
    fltext_(&cases[1].status, text, 40);
    assert_memory_equal(text, "the branch is neither open nor crossed  *", 41);
    fltext_(&cases[1].status, text, 10);
    assert_memory_equal(text, "the branchis neither", 10);
    assert_int_equal(text[40], '*');
}

int main(void)
{
    return run_all_tests(NULL);
}
