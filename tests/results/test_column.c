/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_column.c - columns: which a deck has, their names, units and meanings, and their values against those
** of the functions for one crank position.
*/
#include "machines.h"

#define MOST_COLUMNS 200

#define UNITS                                                                                 \
    "[units]\nlength = mm\nangle = rev\nangular_speed = rpm\nangular_acceleration = deg/s2\n" \
    "force = kN\ntorque = kN mm\nspeed = mm/s\nacceleration = cm/s2\npower = kW\n"

/* A linkage and an engine, with forces, loads and a point. */
static char *linkage(const char *more)
{
    return four_bar(
        0.020, 0.066, 0.056, 0.080,
        print("[load]\nlink = rocker\ntorque = 3 N m\nforce = (5, -2) N\nat = (10, 3) mm\n"
              "[point P]\nlink = coupler\nat = (40, 25) mm\n[motion]\n"
              "speed = 10 rad/s\ninterval = 40 deg\n%s",
              more));
}

static char *gas_engine(const char *more)
{
    return slider_crank(0.15, 0.45, 0,
                        print("[piston]\nmass = 3 kg\n[gas]\nbore = 100 mm\n"
                              "indicator = 0 deg 1 bar, 20 deg 30 bar, 180 deg 1 bar\n[motion]\n"
                              "speed = 30 rad/s\ninterval = 7 deg\n%s",
                              more));
}

static unsigned long list_of(fourlink_results *r, int which, const fourlink_value **list)
{
    unsigned long n;

    assert_int_equal(fourlink_results_list(r, which, list, &n), FOURLINK_OK);
    assert_true(n <= MOST_COLUMNS);
    return n;
}

static const fourlink_value *column_of(fourlink_results *r, const char *name)
{
    const fourlink_value *list;
    unsigned long n = list_of(r, FOURLINK_ALL_COLUMNS, &list), i;

    for (i = 0; i < n; i++)
        if (strcmp(list[i].name, name) == 0)
            return &list[i];
    return NULL;
}

static void check_descriptions(const char *contents, unsigned long at_least)
{
    fourlink_results *r = opened(contents);
    const fourlink_value *list;
    unsigned long n = list_of(r, FOURLINK_ALL_COLUMNS, &list), i, j;

    assert_in_range(n, at_least, MOST_COLUMNS);
    for (i = 0; i < n; i++) {
        const fourlink_value *c = &list[i];
        fourlink_unit u;

        assert_int_equal(fourlink_deck_unit(fourlink_results_deck(r), c->quantity, &u),
                         FOURLINK_OK);
        assert_string_equal(c->unit, u.name);
        assert_close(c->to_si, u.up / u.down, 1e-15);
        assert_true(*c->meaning && c->source && !c->words);
        assert_true(c->value == 0 && !c->has_angle && c->branch == 0);
        for (j = 0; j < i; j++)
            assert_string_not_equal(c->name, list[j].name);
    }
    assert_int_equal(column_of(r, "theta2")->flags,
                     FOURLINK_OF_CRANK | FOURLINK_CRANK_ANGLE | FOURLINK_DIRECTION);
    assert_int_equal(column_of(r, "omega2")->flags, FOURLINK_OF_CRANK);
    assert_int_equal(column_of(r, "theta3")->flags, FOURLINK_DIRECTION);
    if (column_of(r, "residual"))
        assert_int_equal(column_of(r, "residual")->flags,
                         FOURLINK_OF_ROUNDING | FOURLINK_OF_FORCES);
    fourlink_results_free(r);
}

TEST(test_descriptions)
{
    check_descriptions(linkage(""), 70);
    check_descriptions(linkage(UNITS), 70);
    check_descriptions(gas_engine(UNITS), 80);
    check_descriptions(four_bar(0.3, 0.4, 0.5, 0.75, ""), 10);
    check_descriptions(slider_crank(0.4, 0.2, 0.1, ""), 10);
}

/* What a deck does not give, it has no column for. */
TEST(test_columns_that_are_not_there)
{
    static const char *const moving = "[motion]\nspeed = 1 rad/s\n";
    const struct {
        const char *contents, *there, *missing;
    } cases[] = {{four_bar(0.3, 0.4, 0.5, 0.75, moving), "theta4", "x"},
                 {four_bar(0.3, 0.4, 0.5, 0.75, moving), "time", "Ts"},
                 {four_bar(0.3, 0.4, 0.5, 0.75, ""), "omega4", "time"},
                 {four_bar(0.3, 0.4, 0.5, 0.75, "[motion]\nacceleration = 1 rad/s2\nhold = yes\n"),
                  "alpha4", "time"},
                 {linkage(""), "P.x", "Q.x"},
                 {linkage(""), "F14x", "N"},
                 {gas_engine(""), "N", "F14x"},
                 {gas_engine(""), "x_series", "theta4"},
                 {gas_engine(""), "T_engine", "P.x"},
                 {slider_crank(0.1, 0.4, 0.01, moving), "klein_OM", "x_series"}};
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_results *r = opened(cases[i].contents);
        fourlink_value v;

        assert_non_null(column_of(r, cases[i].there));
        assert_null(column_of(r, cases[i].missing));
        assert_int_equal(fourlink_results_value(r, cases[i].missing, FOURLINK_OPEN, 0, &v),
                         FOURLINK_NO_SUCH_NAME);
        fourlink_results_free(r);
    }
}

/* The columns that a deck asks for, in its order, each once. */
TEST(test_choice)
{
    static const struct {
        const char *columns;
        const char *names[5];
    } cases[] = {{"Ts, theta4 mu", {"Ts", "theta4", "mu"}},
                 {"mu,mu , Ts\tmu", {"mu", "Ts"}},
                 {"P.y, p.x, MU", {"P.y", "P.x", "mu"}},
                 {"F12_dir,F12,F12x", {"F12_dir", "F12", "F12x"}}};
    const fourlink_value *list, *all;
    fourlink_results *r;
    unsigned long n, i;
    size_t k;

    for (k = 0; k < COUNT(cases); k++) {
        r = opened(linkage(print("[table]\ncolumns = %s\n", cases[k].columns)));
        n = list_of(r, FOURLINK_COLUMNS, &list);
        for (i = 0; i < n; i++)
            assert_string_equal(list[i].name, cases[k].names[i]);
        assert_null(cases[k].names[n]);
        fourlink_results_free(r);
    }
    r = opened(linkage("[table]\ncolumns = Ts, all\n"));
    n = list_of(r, FOURLINK_COLUMNS, &list);
    assert_string_equal(list[0].name, "Ts");
    assert_string_equal(list[1].name, "theta2");
    assert_int_equal(n, list_of(r, FOURLINK_ALL_COLUMNS, &all));
    fourlink_results_free(r);
    r = opened(linkage("[point \302\260\302\262]\nlink = crank\n" /* a degree sign, a raised 2 */
                       "[table]\ncolumns = mu,\302\240\302\260\302\262.x\n")); /* no-break space */
    assert_int_equal(list_of(r, FOURLINK_COLUMNS, &list), 2);
    assert_string_equal(list[1].name, "\302\260\302\262.x");
    fourlink_results_free(r);
}

TEST(test_columns_that_cannot_be_chosen)
{
    static const struct {
        const char *columns, *message;
    } cases[] = {
        {"thta4", "unknown column 'thta4'; did you mean 'theta4'?"},
        {"w4", "unknown column 'w4'; did you mean 'omega4'?"},
        {"alpha2, A4", "unknown column 'A4'; did you mean 'alpha4'?"},
        {"t", "unknown column 't'; did you mean 'time'?"},
        {"torque", "unknown column 'torque'; see --list"}, /* no masses */
        {"w", "unknown column 'w'; see --list"},
        {"xyzzy", "unknown column 'xyzzy'; see --list"},
        {"theta4, x", "the column 'x' belongs to the slider-crank and the Scotch yoke"},
        {"friction_guide", "the column 'friction_guide' belongs to the slider-crank, the inverted "
                           "slider-crank and the Scotch yoke"},
        {"friction_D", "the column 'friction_D' needs a [friction] section; the deck has none"},
        {"B.x, G3.vx", "the column 'G3.vx' needs a mass of that link"},
        {"C.x, G5.x", "unknown column 'G5.x'; see --list"},
        {"B.x, B.z", "unknown column 'B.z'; see --list"},
        {"time, F12x", "the column 'F12x' needs masses, loads or gas; the deck has none"},
    };
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_source source = deck_source(four_bar(
            0.020, 0.066, 0.056, 0.080,
            print("[motion]\nspeed = 1 rad/s\n[table]\ncolumns = %s\n", cases[i].columns)));
        fourlink_results *r = NULL;
        fourlink_mistake mistake;
        unsigned long n;

        assert_int_equal(fourlink_results_open(&source, 1, &r, &mistake, &n), FOURLINK_BAD_DECK);
        assert_null(r);
        assert_int_equal(n, 1);
        assert_string_equal(mistake.message, cases[i].message);
        assert_int_equal(mistake.line, 13);
    }
    {
        fourlink_source source = deck_source(
            four_bar(0.020, 0.066, 0.056, 0.080,
                     "[friction]\nA = 0.1\nradius_A = 3 mm\n[table]\ncolumns = friction_A\n"));
        fourlink_results *r;
        fourlink_mistake mistake;

        assert_int_equal(fourlink_results_open(&source, 1, &r, &mistake, NULL), FOURLINK_BAD_DECK);
        assert_string_equal(mistake.message, "the column 'friction_A' needs masses, loads or gas; "
                                             "the deck has none");
    }
}

/* ------------------------------------------------------------------------------------------- values */

/* Where a column's value stands in the answer of fourlink_analyse. */
typedef struct place {
    const char *name;
    size_t offset;
    int of_forces;
} place;

#define OF_STATE(member) offsetof(fourlink_state, member), 0
#define OF_FORCE(member) offsetof(fourlink_forces, member), 1

static const place of_both[] = {{"theta3", OF_STATE(link[3].theta)},
                                {"omega3", OF_STATE(link[3].omega)},
                                {"alpha3", OF_STATE(link[3].alpha)},
                                {"mu", OF_STATE(mu)},
                                {"F12x", OF_FORCE(F12x)},
                                {"F12y", OF_FORCE(F12y)},
                                {"F23x", OF_FORCE(F23x)},
                                {"F23y", OF_FORCE(F23y)},
                                {"F34x", OF_FORCE(F34x)},
                                {"F34y", OF_FORCE(F34y)},
                                {"Ts", OF_FORCE(Ts)},
                                {"Ts_work", OF_FORCE(Ts_work)},
                                {"residual", OF_FORCE(residual)},
                                {NULL, 0, 0}};
static const place of_linkage[] = {{"theta4", OF_STATE(link[4].theta)},
                                   {"omega4", OF_STATE(link[4].omega)},
                                   {"alpha4", OF_STATE(link[4].alpha)},
                                   {"F14x", OF_FORCE(F14x)},
                                   {"F14y", OF_FORCE(F14y)},
                                   {NULL, 0, 0}};
static const place of_engine[] = {
    {"phi", OF_STATE(phi)}, {"x", OF_STATE(x)},     {"v", OF_STATE(v)}, {"a", OF_STATE(a)},
    {"N", OF_FORCE(F14y)},  {"M14", OF_FORCE(M14)}, {NULL, 0, 0}};

static double number(const void *start, size_t offset)
{
    return *(const double *)(const void *)((const char *)start + offset);
}

/* value * to_si of the columns is what fourlink_analyse gives, to the last bits. */
static void check_places(fourlink_results *r, fourlink_branch branch, double angle,
                         const place *places)
{
    const fourlink_deck *d = fourlink_results_deck(r);
    fourlink_problem p = problem_of(r);
    fourlink_forces forces;
    fourlink_load loads[2];
    fourlink_state state;
    fourlink_row row;

    assert_int_equal(fourlink_motion_at(&p.motion, angle, &row), FOURLINK_OK);
    assert_int_equal(fourlink_deck_loads(d, branch, row.crank.theta2, loads, NULL), FOURLINK_OK);
    assert_int_equal(
        fourlink_analyse(&p.mechanism, branch, &row.crank, loads, p.n_loads, &state, &forces),
        FOURLINK_OK);
    for (; places->name; places++) {
        double expected =
            places->of_forces ? number(&forces, places->offset) : number(&state, places->offset);
        fourlink_value v;

        assert_int_equal(fourlink_results_value(r, places->name, branch, angle, &v), FOURLINK_OK);
        assert_string_equal(v.name, places->name);
        assert_int_equal(v.branch, (int)branch);
        assert_true(v.has_angle && v.angle == angle);
        assert_close(v.value * v.to_si, expected, 1e-15);
    }
}

static void check_values(const char *contents, const place *own_places)
{
    fourlink_results *r = opened(contents);
    double turn = 2 * PI / problem_of(r).motion.angle_unit;
    int k, i;

    for (k = 0; k < 2; k++)
        for (i = 0; i < 20; i++) {
            check_places(r, branches[k], turn * i / 21, of_both);
            check_places(r, branches[k], turn * i / 21, own_places);
        }
    fourlink_results_free(r);
}

TEST(test_values)
{
    check_values(linkage(""), of_linkage);
    check_values(linkage(UNITS), of_linkage);
    check_values(gas_engine(""), of_engine);
    check_values(gas_engine(UNITS), of_engine);
}

static double at_70(fourlink_results *r, const char *name)
{
    return si_value(r, name, FOURLINK_OPEN, 70);
}

/* Columns made of two numbers, and those of a point. */
TEST(test_composed_values)
{
    fourlink_results *r = opened(linkage("[units]\nforce = kN\nlength = mm\npower = kW\n"));
    double x = at_70(r, "F12x"), y = at_70(r, "F12y");
    fourlink_vector at = {0.040, 0.025}, p, v, a;
    fourlink_instant instant;

    assert_close(at_70(r, "F12"), hypot(x, y), 1e-14);
    assert_close(at_70(r, "F12_dir"), atan2(y, x), 1e-14);
    assert_close(at_70(r, "power"), 10 * at_70(r, "Ts"), 1e-14);
    assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, 70, NULL, &instant, NULL), FOURLINK_OK);
    assert_int_equal(fourlink_point(&instant.state, 3, &at, &p, &v, &a), FOURLINK_OK);
    assert_close(at_70(r, "P.x"), p.x, 1e-14);
    assert_close(at_70(r, "P.y"), p.y, 1e-14);
    assert_close(at_70(r, "P.vx"), v.x, 1e-14);
    assert_close(at_70(r, "P.vy"), v.y, 1e-14);
    assert_close(at_70(r, "P.ax"), a.x, 1e-14);
    assert_close(at_70(r, "P.ay"), a.y, 1e-14);
    assert_close(at_70(r, "P.v"), hypot(v.x, v.y), 1e-14);
    assert_close(at_70(r, "P.a"), hypot(a.x, a.y), 1e-14);
    fourlink_results_free(r);
    r = opened(gas_engine(""));
    assert_near(at_70(r, "x_diff"), at_70(r, "x_series") - at_70(r, "x"), 1e-16);
    assert_near(at_70(r, "v_diff"), at_70(r, "v_series") - at_70(r, "v"), 1e-14);
    fourlink_results_free(r);
}

/* The eight columns of a point against fourlink_point. */
static void check_point(fourlink_results *r, const char *name, int link, double x, double y)
{
    static const char *const endings[8] = {".x", ".y", ".vx", ".vy", ".ax", ".ay", ".v", ".a"};
    fourlink_vector at = {x, y}, p, v, a;
    fourlink_instant instant;
    double expected[8];
    int i;

    assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, 70, NULL, &instant, NULL), FOURLINK_OK);
    assert_int_equal(fourlink_point(&instant.state, link, &at, &p, &v, &a), FOURLINK_OK);
    expected[0] = p.x;
    expected[1] = p.y;
    expected[2] = v.x;
    expected[3] = v.y;
    expected[4] = a.x;
    expected[5] = a.y;
    expected[6] = hypot(v.x, v.y);
    expected[7] = hypot(a.x, a.y);
    for (i = 0; i < 8; i++)
        assert_near(at_70(r, print("%s%s", name, endings[i])), expected[i],
                    1e-13 * (1 + fabs(expected[i])));
}

static char *lever(const char *length)
{
    return print("mechanism = inverted-slider-crank\n[crank]\nlength = 50 mm\nmass = 0.1 kg\n"
                 "[ground]\nlength = 300 mm\n[slider]\nmass = 0.2 kg\n[lever]\nmass = 2 kg\n"
                 "cg = (100, 10) mm\ninertia = 1 kg m2\n%s[motion]\nspeed = 10 rad/s\n"
                 "interval = 7 deg\n",
                 length);
}

/* Pins and centres of mass have columns without a [point]. */
TEST(test_points_of_every_deck)
{
    fourlink_results *r =
        opened("mechanism = four-bar\n[ground]\nlength = 80 mm\n[coupler]\nlength = 66 mm\n"
               "[crank]\nlength = 20 mm\nmass = 0.1 kg\ncg = 4 mm\n[rocker]\nlength = 56 mm\n"
               "mass = 1 kg\ncg = (20, -5) mm\n[motion]\nspeed = 10 rad/s\n[units]\n"
               "length = mm\nspeed = km/h\n");

    check_point(r, "B", 2, 0.020, 0);
    check_point(r, "C", 3, 0.066, 0);
    check_point(r, "C", 4, 0.056, 0);
    check_point(r, "G2", 2, 0.004, 0);
    check_point(r, "G4", 4, 0.020, -0.005);
    assert_null(column_of(r, "G3.x"));
    assert_string_equal(column_of(r, "G4.vx")->unit, "km/h");
    fourlink_results_free(r);
    r = opened(gas_engine(""));
    check_point(r, "B", 2, 0.15, 0);
    check_point(r, "C", 4, 0, 0);
    check_point(r, "C", 3, 0.45, 0);
    check_point(r, "G4", 4, 0, 0);
    assert_near(at_70(r, "C.vx"), -at_70(r, "v"), 1e-14);
    fourlink_results_free(r);
    r = opened(lever(""));
    check_point(r, "B", 3, 0, 0);
    check_point(r, "G4", 4, 0.1, 0.01);
    check_point(r, "G3", 3, 0, 0);
    assert_null(column_of(r, "C.x"));
    fourlink_results_free(r);
    r = opened(lever("length = 400 mm\nangle = 20 deg\n"));
    check_point(r, "C", 4, 0.4, 0);
    fourlink_results_free(r);
}

/* A [point] of the same name hides them; they are not among the usual columns. */
TEST(test_hidden_points)
{
    fourlink_results *r = opened(linkage("[point C]\nlink = rocker\nat = 10 mm\n"));
    const fourlink_value *list;
    unsigned long n = list_of(r, FOURLINK_ALL_COLUMNS, &list), i, found = 0;
    fourlink_value v;

    check_point(r, "C", 4, 0.010, 0);
    check_point(r, "B", 2, 0.020, 0);
    for (i = 0; i < n; i++)
        found += strncmp(list[i].name, "C.", 2) == 0;
    assert_int_equal(found, 8);
    n = list_of(r, FOURLINK_COLUMNS, &list);
    for (i = found = 0; i < n; i++)
        found += strchr(list[i].name, '.') != NULL;
    assert_int_equal(found, 4); /* P.x P.y C.x C.y */
    assert_int_equal(fourlink_results_value(r, "max(B.x)", FOURLINK_OPEN, 0, &v), FOURLINK_OK);
    assert_near(v.value, 0.020, 1e-12);
    fourlink_results_free(r);
}

/* Where the links do not reach, the crank's columns have values and no others. */
TEST(test_values_out_of_reach)
{
    fourlink_results *r =
        opened(four_bar(0.3, 0.4, 0.5, 0.75,
                        "[motion]\nspeed = 2 rad/s\n[load]\nlink = rocker\ntorque = 1 N m\n"
                        "[table]\ncolumns = all\n"));
    double values[MOST_COLUMNS];
    const fourlink_value *list;
    unsigned long n, i;
    fourlink_value v;

    n = list_of(r, FOURLINK_COLUMNS, &list);
    assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, 150, values, NULL, NULL),
                     FOURLINK_TOO_FAR);
    for (i = 0; i < n; i++) {
        int of_crank = (list[i].flags & FOURLINK_OF_CRANK) != 0;
        int status = fourlink_results_value(r, list[i].name, FOURLINK_OPEN, 150, &v);

        assert_int_equal(isfinite(values[i]) != 0, of_crank);
        assert_int_equal(status, of_crank ? FOURLINK_OK : FOURLINK_TOO_FAR);
        if (of_crank)
            assert_true(v.value == values[i]);
    }
    assert_true(values[0] == 150);
    fourlink_results_free(r);
}

/* Columns without friction in them are those of the same machine without friction: Ts0 is its Ts, and the friction
** between links and frame cancels in what shakes the frame. */
TEST(test_frictionless_columns)
{
    static const char *const names[][2] = {
        {"Ts0", "Ts"}, {"Fsx", "Fsx"}, {"Fsy", "Fsy"}, {"Fs", "Fs"}, {"Ms", "Ms"}};
    uint64_t seed = 61;
    int i, tried = 0;
    size_t k;

    for (i = 0; i < some_of(2000); i++) {
        int is_pump = i % 2;
        const char *deck = print("%s[motion]\nspeed = %.17g rad/s\n%s", is_pump ? PUMP : ROCKER,
                                 uniform(&seed, 1, 100),
                                 is_pump ? FORCE : "[load]\nlink = rocker\ntorque = 3 N m\n");
        fourlink_results *without = opened(deck);
        fourlink_results *with = opened(print(
            "%s[friction]\nA = %.17g\nradius_A = 5 mm\nB = %.17g\nradius_B = 4 mm\nC = %.17g\n"
            "radius_C = 6 mm\n%s = %.17g\n%s",
            deck, uniform(&seed, 0, 0.3), uniform(&seed, 0, 0.3), uniform(&seed, 0, 0.3),
            is_pump ? "guide" : "D", uniform(&seed, 0, 0.3), is_pump ? "" : "radius_D = 5 mm\n"));
        double angle = uniform(&seed, 0, 360), size = value_at(without, "F12", angle);
        fourlink_value v;

        for (k = 0; k < COUNT(names); k++)
            if (fourlink_results_value(with, names[k][0], FOURLINK_OPEN, angle, &v) ==
                FOURLINK_OK) { /* else it locks */
                double right = value_at(without, names[k][1], angle);

                assert_true(v.flags & FOURLINK_FRICTIONLESS);
                if (!(fabs(v.value - right) <= 1e-9 * (fabs(right) + size)))
                    fail_msg("case %d: %s is %.17g, not %.17g", i, names[k][0], v.value, right);
                tried++;
            }
        fourlink_results_free(without);
        fourlink_results_free(with);
    }
    assert_true(tried > 4 * i);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
