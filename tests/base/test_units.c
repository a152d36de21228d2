/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_units.c - every unit against its published value, and what is no unit.
*/
#include <stdlib.h>

#include "check.h"
#include "base/quantity.h"
#include "base/units.h"

/* Values of NIST SP 811, appendix B; those of the inch-pound system are exact by definition (1 in =
** 25.4 mm, 1 lb = 0.45359237 kg, g = 9.80665 m/s2) and are written with all the digits of a double.
*/
static const struct {
    const char *name;
    double si;
    dimension dim;
} units[] = {
    {"m", 1, {1, 0, 0, 0}},
    {"mm", 0.001, {1, 0, 0, 0}},
    {"cm", 0.01, {1, 0, 0, 0}},
    {"km", 1000, {1, 0, 0, 0}},
    {"in", 0.0254, {1, 0, 0, 0}},
    {"ft", 0.3048, {1, 0, 0, 0}},
    {"kg", 1, {0, 1, 0, 0}},
    {"g", 0.001, {0, 1, 0, 0}},
    {"t", 1000, {0, 1, 0, 0}},
    {"lb", 0.45359237, {0, 1, 0, 0}},
    {"oz", 0.028349523125, {0, 1, 0, 0}},
    {"slug", 14.593902937206364829, {0, 1, 0, 0}},
    {"blob", 175.12683524647637795, {0, 1, 0, 0}},
    {"s", 1, {0, 0, 1, 0}},
    {"ms", 0.001, {0, 0, 1, 0}},
    {"min", 60, {0, 0, 1, 0}},
    {"h", 3600, {0, 0, 1, 0}},
    {"rad", 1, {0, 0, 0, 1}},
    {"mrad", 0.001, {0, 0, 0, 1}},
    {"deg", 0.017453292519943295769, {0, 0, 0, 1}},
    {"rev", 6.2831853071795864769, {0, 0, 0, 1}},
    {"rpm", 0.10471975511965977462, {0, 0, -1, 1}},
    {"N", 1, {1, 1, -2, 0}},
    {"kN", 1e3, {1, 1, -2, 0}},
    {"MN", 1e6, {1, 1, -2, 0}},
    {"lbf", 4.4482216152605, {1, 1, -2, 0}},
    {"kgf", 9.80665, {1, 1, -2, 0}},
    {"ozf", 0.27801385095378125, {1, 1, -2, 0}},
    {"kip", 4448.2216152605, {1, 1, -2, 0}},
    {"J", 1, {2, 1, -2, 0}},
    {"kJ", 1e3, {2, 1, -2, 0}},
    {"W", 1, {2, 1, -3, 0}},
    {"kW", 1e3, {2, 1, -3, 0}},
    {"hp", 745.69987158227022, {2, 1, -3, 0}},
    {"Pa", 1, {-1, 1, -2, 0}},
    {"kPa", 1e3, {-1, 1, -2, 0}},
    {"MPa", 1e6, {-1, 1, -2, 0}},
    {"GPa", 1e9, {-1, 1, -2, 0}},
    {"bar", 1e5, {-1, 1, -2, 0}},
    {"psi", 6894.7572931683613367, {-1, 1, -2, 0}},
    {"atm", 101325, {-1, 1, -2, 0}},
    /* compound */
    {"N/mm2", 1e6, {-1, 1, -2, 0}},
    {"N/mm^2", 1e6, {-1, 1, -2, 0}},
    {"kgf/cm2", 98066.5, {-1, 1, -2, 0}},
    {"lbf/in2", 6894.7572931683613367, {-1, 1, -2, 0}},
    {"kg m2", 1, {2, 1, 0, 0}},
    {"kg.m2", 1, {2, 1, 0, 0}},
    {"kg*m^2", 1, {2, 1, 0, 0}},
    {"kg * m^2", 1, {2, 1, 0, 0}},
    {"kg\tm2", 1, {2, 1, 0, 0}},
    {"kg m m", 1, {2, 1, 0, 0}},
    {"g.mm2", 1e-9, {2, 1, 0, 0}},
    {"lb in2", 2.926396534292e-4, {2, 1, 0, 0}},
    {"lb ft2", 0.04214011009380480, {2, 1, 0, 0}},
    {"slug.ft2", 1.3558179483314004, {2, 1, 0, 0}},
    {"lbf in s2", 0.1129848290276167, {2, 1, 0, 0}},
    {"m/s", 1, {1, 0, -1, 0}},
    {"km/h", 1 / 3.6, {1, 0, -1, 0}},
    {"ft/min", 0.00508, {1, 0, -1, 0}},
    {"m/s^2", 1, {1, 0, -2, 0}},
    {"m/s2", 1, {1, 0, -2, 0}},
    {"m/s/s", 1, {1, 0, -2, 0}},
    {"in/s2", 0.0254, {1, 0, -2, 0}},
    {"rad/s", 1, {0, 0, -1, 1}},
    {"deg/s", 0.017453292519943295769, {0, 0, -1, 1}},
    {"rev/min", 0.10471975511965977462, {0, 0, -1, 1}},
    {"rad/s2", 1, {0, 0, -2, 1}},
    {"rad / s2", 1, {0, 0, -2, 1}},
    {"rpm/s", 0.10471975511965977462, {0, 0, -2, 1}},
    {"N m", 1, {2, 1, -2, 0}},
    {"N.mm", 1e-3, {2, 1, -2, 0}},
    {"kN m", 1e3, {2, 1, -2, 0}},
    {"lbf.in", 0.1129848290276167, {2, 1, -2, 0}},
    {"lbf ft", 1.3558179483314004, {2, 1, -2, 0}},
    {"ozf in", 0.0070615518142260438, {2, 1, -2, 0}},
    {"N m/s", 1, {2, 1, -3, 0}},
    {"ft lbf/s", 1.3558179483314004, {2, 1, -3, 0}},
    {"m4", 1, {4, 0, 0, 0}},
    {"mm^3", 1e-9, {3, 0, 0, 0}},
    {"1/s", 1, {0, 0, -1, 0}},
    {"1", 1, {0, 0, 0, 0}},
    {" N ", 1, {1, 1, -2, 0}},
    {"J/kg s2/m2", 1, {0, 0, 0, 0}}, /* '/' divides by one factor only */
};

TEST(test_values)
{
    size_t i;

    for (i = 0; i < COUNT(units); i++) {
        unit u;
        text bad;

        print_message("%s\n", units[i].name);
        assert_true(flk_unit_read(flk_text_of(units[i].name), &u, &bad));
        assert_close(flk_unit_to_si(1, u), units[i].si, 5e-16);
        assert_int_equal(u.dim.m, units[i].dim.m);
        assert_int_equal(u.dim.kg, units[i].dim.kg);
        assert_int_equal(u.dim.s, units[i].dim.s);
        assert_int_equal(u.dim.rad, units[i].dim.rad);
    }
}

/* The unit, its dimension that of a quantity. */
static void check_is(const char *name, quantity q, int expected)
{
    unit u;
    text bad;

    print_message("%s\n", name);
    assert_true(flk_unit_read(flk_text_of(name), &u, &bad));
    assert_int_equal(flk_dimension_equal(u.dim, flk_quantities[q].dim), expected);
}

TEST(test_dimensions)
{
    static const char *const no_speed[] = {"Hz",  "1/s",    "N m/s", "m/s",
                                           "rad", "rad/s2", "min",   "W"};
    size_t i;

    for (i = 0; i < COUNT(no_speed); i++)
        check_is(no_speed[i], QUANTITY_ANGULAR_SPEED, 0);
    check_is("rpm", QUANTITY_ANGULAR_SPEED, 1);
    check_is("mrad/ms", QUANTITY_ANGULAR_SPEED, 1);
    check_is("rad/s2", QUANTITY_ANGULAR_ACCELERATION, 1);
    check_is("1/s2", QUANTITY_ANGULAR_ACCELERATION, 0);
    check_is("N m", QUANTITY_TORQUE, 1);
    check_is("N m/rad", QUANTITY_TORQUE, 0);
    check_is("lbf", QUANTITY_MASS, 0);
    check_is("lb", QUANTITY_MASS, 1);
    check_is("kgf", QUANTITY_FORCE, 1);
    check_is("kg", QUANTITY_FORCE, 0);
    check_is("1", QUANTITY_ANGLE, 0);
    check_is("N/mm2", QUANTITY_PRESSURE, 1);
    check_is("N mm2", QUANTITY_PRESSURE, 0);
    check_is("hp", QUANTITY_POWER, 1);
    check_is("kW h", QUANTITY_ENERGY, 1);
    check_is("slug in2", QUANTITY_INERTIA, 1);
}

TEST(test_quantities)
{
    int q;

    for (q = 0; q < QUANTITY_COUNT; q++) {
        char *end;
        unit u;
        text bad;

        print_message("%s\n", flk_quantities[q].name);
        assert_true(flk_unit_read(flk_text_of(flk_quantities[q].unit), &u, &bad));
        assert_true(flk_dimension_equal(u.dim, flk_quantities[q].dim));
        if (q == QUANTITY_ANGLE)
            assert_close(flk_unit_to_si(180, u), PI, 1e-16);
        else
            assert_true(flk_unit_to_si(1, u) == 1);
        assert_true(strtod(flk_quantities[q].example, &end) >
                    0); /* messages offer it as an example */
        if (q != QUANTITY_NUMBER) {
            assert_true(flk_unit_read(flk_text_of(end), &u, &bad));
            assert_true(flk_dimension_equal(u.dim, flk_quantities[q].dim));
        }
    }
}

TEST(test_refused)
{
    /* what is refused, and the part of it that is to blame, if that is one word */
    static const struct {
        const char *text, *bad;
    } refused[] = {
        {"", NULL},
        {"  ", NULL},
        {"mN", "mN"},
        {"Mm", "Mm"},
        {"KG", "KG"},
        {"pa", "pa"},
        {"mpa", "mpa"},
        {"n", "n"},
        {"NM", "NM"},
        {"S", "S"},
        {"m5x", NULL},
        {"m^", NULL},
        {"m^x", NULL},
        {"m5", NULL},
        {"m^5", NULL},
        {"m0", NULL},
        {"m^0", NULL},
        {"m22", NULL},
        {"m^-", NULL},
        {"m^-0", NULL},
        {"m^-5", NULL},
        {"m^--1", NULL},
        {"nM", "nM"},
        {"NmN", "NmN"},
        {"inche", "inche"},
        {"m ^2", NULL},
        {"m^^2", NULL},
        {"N/", NULL},
        {"N*", NULL},
        {"N.", NULL},
        {"N /", NULL},
        {"/s", NULL},
        {"*m", NULL},
        {".m", NULL},
        {"rad//s", NULL},
        {"N**m", NULL},
        {"N..m", NULL},
        {"N./m", NULL},
        {"N,m", NULL},
        {"(N)", NULL},
        {"N -m", NULL},
        {"N- m", NULL},
        {"N-", NULL},
        {"-N", NULL},
        {"N--m", NULL},
        {"m-x", NULL},
        {"m -1", NULL},
        {"m-5", NULL},
        {"m-0", NULL},
        {"m+m", NULL},
        {"2 m", NULL},
        {"2m", NULL},
        {"N furlong", "furlong"},
        {"furlong/s", "furlong"},
        {"N\302\267m", "N\302\267m"},
        {"\302\260", "\302\260"},
        {"\302\265m", "\302\265m"},
        {"m\302\262", "m\302\262"},
        {"%%", "%%"},
        {"% mm", "% mm"},
        {"%2", "%2"},
        {"mm %", "%"},
        {"1/%", "%"},
        {"mm#", NULL},
    };
    size_t i;

    for (i = 0; i < COUNT(refused); i++) {
        unit u;
        text bad;

        print_message("'%s'\n", refused[i].text);
        assert_false(flk_unit_read(flk_text_of(refused[i].text), &u, &bad));
        if (refused[i].bad) {
            assert_int_equal(bad.length, strlen(refused[i].bad));
            assert_memory_equal(bad.start, refused[i].bad, bad.length);
        }
    }
}

/* A text is not ended by a null character: what stands after it does not count. */
TEST(test_stops_at_the_end)
{
    text t = {"mm2 kg", 2}, bad;
    unit u;

    assert_true(flk_unit_read(t, &u, &bad));
    assert_int_equal(u.dim.m, 1);
    assert_int_equal(u.dim.kg, 0);
    t.length = 1;
    assert_true(flk_unit_read(t, &u, &bad));
    assert_true(flk_unit_to_si(1, u) == 1);
}

/* A product of so many factors that its value has no number is no unit; as 0, infinity or NaN it
** would come out in the tables. */
TEST(test_no_overflow)
{
    static const char *const factors[] = {" km4", " mm4", "/km4", "/mm4", " GPa4", "/GPa4"};
    char name[2000];
    size_t i, j;

    for (i = 0; i < COUNT(factors); i++)
        for (j = 0; j < COUNT(factors); j++) {
            unit u;
            text bad;
            int k;

            strcpy(name, "m");
            for (k = 0; k < 100; k++)
                strcat(name, factors[k < 50 ? i : j]);
            print_message("%.30s ...%s\n", name, factors[j]);
            if (flk_unit_read(flk_text_of(name), &u, &bad)) {
                assert_true(flk_unit_to_si(1, u) > 0);
                assert_true(flk_unit_to_si(1, u) <= 1e300);
                assert_true(u.down / u.up > 0);
                assert_true(u.down / u.up <= 1e300);
            }
        }
}

/* A decimal fraction of a metre written in millimetres is the same number. */
TEST(test_rounded_once)
{
    unit mm, cm, deg;
    text bad;
    int k;

    assert_true(flk_unit_read(flk_text_of("mm"), &mm, &bad));
    assert_true(flk_unit_read(flk_text_of("cm"), &cm, &bad));
    assert_true(flk_unit_read(flk_text_of("deg"), &deg, &bad));
    assert_true(flk_unit_to_si(66, mm) == 0.066);
    for (k = 1; k < 20000; k++) {
        char metres[40];

        sprintf(metres, "%d.%03d", k / 1000, k % 1000);
        assert_true(flk_unit_to_si(k, mm) == strtod(metres, NULL));
        sprintf(metres, "%d.%02d", k / 100, k % 100);
        assert_true(flk_unit_to_si(k, cm) == strtod(metres, NULL));
    }
    assert_true(flk_unit_to_si(180, deg) == PI);
    assert_true(flk_unit_to_si(90, deg) == PI / 2);
    assert_true(flk_unit_to_si(360, deg) == 2 * PI);
}

/* A suggestion makes a unit of the dimension asked for. */
TEST(test_nearest)
{
    static const struct {
        const char *unit, *word;
        quantity q;
        const char *nearest;
    } cases[] = {
        {"rmp", "rmp", QUANTITY_ANGULAR_SPEED, "rpm"},
        {"Mm", "Mm", QUANTITY_LENGTH, "mm"},
        {"mn", "mn", QUANTITY_FORCE, "MN"},
        {"mn", "mn", QUANTITY_LENGTH, "mm"},
        {"mn", "mn", QUANTITY_ANGLE, NULL},
        {"mpa", "mpa", QUANTITY_PRESSURE, "MPa"},
        {"degr", "degr", QUANTITY_ANGLE, "deg"},
        {"psia", "psia", QUANTITY_PRESSURE, "psi"},
        {"kpa", "kpa", QUANTITY_PRESSURE, "kPa"},
        {"nm", "nm", QUANTITY_TORQUE, "N m"},
        {"nm", "nm", QUANTITY_LENGTH, "mm"},
        {"gm", "gm", QUANTITY_MASS, "g"},
        {"kgg m2", "kgg", QUANTITY_INERTIA, "kg"},
        {"kg nm2", "nm", QUANTITY_INERTIA, "mm"},
        {"kg nm2", "nm", QUANTITY_TORQUE, NULL},
        {"furlong", "furlong", QUANTITY_LENGTH, NULL},
        {"", "", QUANTITY_LENGTH, NULL},
    };
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        text t = flk_text_of(cases[i].unit), word = t;
        const char *nearest;

        word.start = strstr(cases[i].unit, cases[i].word);
        word.length = strlen(cases[i].word);
        nearest = flk_unit_nearest(t, word, flk_quantities[cases[i].q].dim);
        print_message("%s: %s\n", cases[i].unit, nearest ? nearest : "none");
        if (cases[i].nearest) {
            assert_non_null(nearest);
            assert_string_equal(nearest, cases[i].nearest);
        } else {
            assert_null(nearest);
        }
    }
}

/* Words and spellings that people use are the units that they mean. */
TEST(test_words)
{
    static const char *const same[][2] = {
        {"Nm", "N m"},          {"kNm", "kN m"},        {"Nmm", "N mm"},       {"kgm2", "kg m2"},
        {"kgmm^2", "kg mm2"},   {"lbft", "lbf ft"},     {"RPM", "rpm"},        {"Deg", "deg"},
        {"degrees", "deg"},     {"DEGREES/s", "deg/s"}, {"inches", "in"},      {"feet", "ft"},
        {"lbs", "lb"},          {"newtons", "N"},       {"rad s^-1", "rad/s"}, {"W/Nm", "W/N/m"},
        {"revs/minute", "rpm"}, {"N m^-2", "Pa"},       {"N-m", "N m"},        {"rad s-1", "rad/s"},
        {"kg-m2", "kg m2"},     {"m-1", "m^-1"},        {"pounds", "lb"},      {"Ounces", "oz"},
        {"blobs", "blob"},      {"kips", "kip"},        {"lbm", "lb"},         {"in-lbf", "lbf in"},
    };
    size_t i;

    for (i = 0; i < COUNT(same); i++) {
        unit u, v;
        text bad;

        print_message("%s\n", same[i][0]);
        assert_true(flk_unit_read(flk_text_of(same[i][0]), &u, &bad));
        assert_true(flk_unit_read(flk_text_of(same[i][1]), &v, &bad));
        assert_true(flk_dimension_equal(u.dim, v.dim));
        assert_true(u.up / u.down == v.up / v.down);
    }
}

/* What courses in the US write, and its value in each quantity that it is a unit of: by definition, 1 in =
** 0.0254 m, 1 lb = 0.45359237 kg, and a force is this mass times 9.80665 m/s2. */
#define IN 0.0254
#define FT 0.3048
#define LB 0.45359237
#define OZ (LB / 16)
#define LBF (LB * 9.80665)
#define OZF (LBF / 16)

static const struct {
    const char *name;
    struct {
        quantity q;
        double si;
    } is[2];
} customary[] = {
    {"lb-in", {{QUANTITY_TORQUE, LBF *IN}, {QUANTITY_MASS_MOMENT, LB *IN}}},
    {"in-lb", {{QUANTITY_TORQUE, LBF *IN}, {QUANTITY_MASS_MOMENT, LB *IN}}},
    {"lb.in", {{QUANTITY_TORQUE, LBF *IN}, {QUANTITY_MASS_MOMENT, LB *IN}}},
    {"lb in", {{QUANTITY_TORQUE, LBF *IN}, {QUANTITY_MASS_MOMENT, LB *IN}}},
    {"lbs-in", {{QUANTITY_TORQUE, LBF *IN}, {QUANTITY_MASS_MOMENT, LB *IN}}},
    {"lb-ft", {{QUANTITY_TORQUE, LBF *FT}, {QUANTITY_MASS_MOMENT, LB *FT}}},
    {"ft-lb", {{QUANTITY_TORQUE, LBF *FT}, {QUANTITY_MASS_MOMENT, LB *FT}}},
    {"ft-lbs", {{QUANTITY_TORQUE, LBF *FT}, {QUANTITY_MASS_MOMENT, LB *FT}}},
    {"oz-in", {{QUANTITY_TORQUE, OZF *IN}, {QUANTITY_MASS_MOMENT, OZ *IN}}},
    {"in-oz", {{QUANTITY_TORQUE, OZF *IN}, {QUANTITY_MASS_MOMENT, OZ *IN}}},
    {"lbf-in", {{QUANTITY_TORQUE, LBF *IN}, {QUANTITY_ENERGY, LBF *IN}}},
    {"ft-lbf", {{QUANTITY_TORQUE, LBF *FT}, {QUANTITY_ENERGY, LBF *FT}}},
    {"lbf\302\267ft", {{QUANTITY_TORQUE, LBF *FT}, {QUANTITY_ENERGY, LBF *FT}}},
    {"lbf*ft", {{QUANTITY_TORQUE, LBF *FT}, {QUANTITY_ENERGY, LBF *FT}}},
    {"inlb", {{QUANTITY_TORQUE, LBF *IN}, {QUANTITY_ENERGY, LBF *IN}}},
    {"ftlb", {{QUANTITY_TORQUE, LBF *FT}, {QUANTITY_ENERGY, LBF *FT}}},
    {"ftlbf", {{QUANTITY_TORQUE, LBF *FT}, {QUANTITY_ENERGY, LBF *FT}}},
    {"inlbf", {{QUANTITY_TORQUE, LBF *IN}, {QUANTITY_ENERGY, LBF *IN}}},
    {"ozin", {{QUANTITY_TORQUE, OZF *IN}, {QUANTITY_ENERGY, OZF *IN}}},
    {"ozfin", {{QUANTITY_TORQUE, OZF *IN}, {QUANTITY_ENERGY, OZF *IN}}},
    {"lbm-in", {{QUANTITY_MASS_MOMENT, LB *IN}, {QUANTITY_COUNT, 0}}},
    {"ft-lb/s", {{QUANTITY_POWER, LBF *FT}, {QUANTITY_COUNT, 0}}},
    {"ft-lbf/s", {{QUANTITY_POWER, LBF *FT}, {QUANTITY_COUNT, 0}}},
    {"in-lb/sec", {{QUANTITY_POWER, LBF *IN}, {QUANTITY_COUNT, 0}}},
    {"lb/in", {{QUANTITY_STIFFNESS, LBF / IN}, {QUANTITY_COUNT, 0}}},
    {"lb/ft", {{QUANTITY_STIFFNESS, LBF / FT}, {QUANTITY_COUNT, 0}}},
    {"lb in-1", {{QUANTITY_STIFFNESS, LBF / IN}, {QUANTITY_COUNT, 0}}},
    {"lb-in/rad", {{QUANTITY_TORSIONAL_STIFFNESS, LBF *IN}, {QUANTITY_COUNT, 0}}},
    {"lb-in/deg", {{QUANTITY_TORSIONAL_STIFFNESS, LBF *IN * 180 / PI}, {QUANTITY_COUNT, 0}}},
    {"lb-in-s/rad", {{QUANTITY_TORSIONAL_DAMPING, LBF *IN}, {QUANTITY_COUNT, 0}}},
    {"lb-s/in", {{QUANTITY_DAMPING, LBF / IN}, {QUANTITY_COUNT, 0}}},
    {"lb-sec/in", {{QUANTITY_DAMPING, LBF / IN}, {QUANTITY_COUNT, 0}}},
    {"lb/in2", {{QUANTITY_PRESSURE, LBF / IN / IN}, {QUANTITY_COUNT, 0}}},
    {"lb/ft^2", {{QUANTITY_PRESSURE, LBF / FT / FT}, {QUANTITY_COUNT, 0}}},
    {"psi", {{QUANTITY_PRESSURE, LBF / IN / IN}, {QUANTITY_COUNT, 0}}},
    {"slug-ft^2", {{QUANTITY_INERTIA, LBF *FT}, {QUANTITY_COUNT, 0}}},
    {"slug-ft2", {{QUANTITY_INERTIA, LBF *FT}, {QUANTITY_COUNT, 0}}},
    {"blob-in2", {{QUANTITY_INERTIA, LBF *IN}, {QUANTITY_COUNT, 0}}},
    {"lb-in2", {{QUANTITY_INERTIA, LB *IN *IN}, {QUANTITY_COUNT, 0}}},
    {"lbm-in2", {{QUANTITY_INERTIA, LB *IN *IN}, {QUANTITY_COUNT, 0}}},
    {"lb-ft2", {{QUANTITY_INERTIA, LB *FT *FT}, {QUANTITY_COUNT, 0}}},
    {"oz-in2", {{QUANTITY_INERTIA, OZ *IN *IN}, {QUANTITY_COUNT, 0}}},
    {"oz-in-s2", {{QUANTITY_INERTIA, OZF *IN}, {QUANTITY_COUNT, 0}}},
    {"lb-in-s^2", {{QUANTITY_INERTIA, LBF *IN}, {QUANTITY_COUNT, 0}}},
    {"lb-in-sec2", {{QUANTITY_INERTIA, LBF *IN}, {QUANTITY_COUNT, 0}}},
    {"lb-ft-s2", {{QUANTITY_INERTIA, LBF *FT}, {QUANTITY_COUNT, 0}}},
    {"lbf s2/in", {{QUANTITY_MASS, LBF / IN}, {QUANTITY_COUNT, 0}}},
    {"lb-s2/in", {{QUANTITY_MASS, LBF / IN}, {QUANTITY_COUNT, 0}}},
    {"lb-s^2/ft", {{QUANTITY_MASS, LBF / FT}, {QUANTITY_COUNT, 0}}},
    {"lb", {{QUANTITY_MASS, LB}, {QUANTITY_FORCE, LBF}}},
    {"lbs", {{QUANTITY_MASS, LB}, {QUANTITY_FORCE, LBF}}},
    {"pounds", {{QUANTITY_MASS, LB}, {QUANTITY_FORCE, LBF}}},
    {"pound", {{QUANTITY_MASS, LB}, {QUANTITY_FORCE, LBF}}},
    {"oz", {{QUANTITY_MASS, OZ}, {QUANTITY_FORCE, OZF}}},
    {"ounces", {{QUANTITY_MASS, OZ}, {QUANTITY_FORCE, OZF}}},
    {"lbm", {{QUANTITY_MASS, LB}, {QUANTITY_COUNT, 0}}},
    {"slug", {{QUANTITY_MASS, LBF / FT}, {QUANTITY_COUNT, 0}}},
    {"slugs", {{QUANTITY_MASS, LBF / FT}, {QUANTITY_COUNT, 0}}},
    {"blob", {{QUANTITY_MASS, LBF / IN}, {QUANTITY_COUNT, 0}}},
    {"blobs", {{QUANTITY_MASS, LBF / IN}, {QUANTITY_COUNT, 0}}},
    {"lbf", {{QUANTITY_FORCE, LBF}, {QUANTITY_COUNT, 0}}},
    {"ozf", {{QUANTITY_FORCE, OZF}, {QUANTITY_COUNT, 0}}},
    {"kip", {{QUANTITY_FORCE, 1000 * LBF}, {QUANTITY_COUNT, 0}}},
    {"kips", {{QUANTITY_FORCE, 1000 * LBF}, {QUANTITY_COUNT, 0}}},
    {"kip-ft", {{QUANTITY_TORQUE, 1000 * LBF *FT}, {QUANTITY_ENERGY, 1000 * LBF *FT}}},
    {"hp", {{QUANTITY_POWER, 550 * LBF *FT}, {QUANTITY_COUNT, 0}}},
    {"in/sec", {{QUANTITY_SPEED, IN}, {QUANTITY_COUNT, 0}}},
    {"ips", {{QUANTITY_SPEED, IN}, {QUANTITY_COUNT, 0}}},
    {"fps", {{QUANTITY_SPEED, FT}, {QUANTITY_COUNT, 0}}},
    {"ft/min", {{QUANTITY_SPEED, FT / 60}, {QUANTITY_COUNT, 0}}},
    {"mph", {{QUANTITY_SPEED, 5280 * FT / 3600}, {QUANTITY_COUNT, 0}}},
    {"km/h", {{QUANTITY_SPEED, 1 / 3.6}, {QUANTITY_COUNT, 0}}},
    {"in/sec2", {{QUANTITY_ACCELERATION, IN}, {QUANTITY_COUNT, 0}}},
    {"gn", {{QUANTITY_ACCELERATION, 9.80665}, {QUANTITY_COUNT, 0}}},
    {"sec", {{QUANTITY_TIME, 1}, {QUANTITY_COUNT, 0}}},
    {"RPM", {{QUANTITY_ANGULAR_SPEED, PI / 30}, {QUANTITY_COUNT, 0}}},
    {"rad/sec2", {{QUANTITY_ANGULAR_ACCELERATION, 1}, {QUANTITY_COUNT, 0}}},
    {"in", {{QUANTITY_LENGTH, IN}, {QUANTITY_COUNT, 0}}},
    {"ft", {{QUANTITY_LENGTH, FT}, {QUANTITY_COUNT, 0}}},
    {"in2", {{QUANTITY_AREA, IN *IN}, {QUANTITY_COUNT, 0}}},
    {"in3", {{QUANTITY_VOLUME, IN *IN *IN}, {QUANTITY_COUNT, 0}}},
    {"L", {{QUANTITY_VOLUME, 1e-3}, {QUANTITY_COUNT, 0}}},
    {"litres", {{QUANTITY_VOLUME, 1e-3}, {QUANTITY_COUNT, 0}}},
    {"cc", {{QUANTITY_VOLUME, 1e-6}, {QUANTITY_COUNT, 0}}},
};

/* The factor of a customary unit in a quantity; 0 if it is none of its units. */
static double customary_factor(size_t i, quantity q)
{
    int k;

    for (k = 0; k < 2; k++)
        if (customary[i].is[k].q != QUANTITY_COUNT &&
            flk_dimension_equal(flk_quantities[customary[i].is[k].q].dim, flk_quantities[q].dim))
            return customary[i].is[k].si;
    return 0;
}

/* A message that refuses a unit has what was written and, unless it explains a weight, what this is in each
** reading and what is wanted. */
static void assert_refused(size_t i, quantity q, const char *message)
{
    char words[100];
    int k;

    sprintf(words, "'2.5 %s' ",
            strcmp(customary[i].name, "lbf\302\267ft") ? customary[i].name : "lbf*ft");
    assert_ptr_equal(strstr(message, words), message);
    if (strstr(message, "weight"))
        return;
    assert_non_null(strstr(message, flk_quantities[q].words));
    for (k = 0; k < 2; k++)
        if (customary[i].is[k].q != QUANTITY_COUNT && customary[i].is[k].q != QUANTITY_ENERGY)
            assert_non_null(strstr(message, flk_quantities[customary[i].is[k].q].words));
}

/* In each of the quantities a quantity of this unit is read with this value, or refused with a reason. */
TEST(test_customary)
{
    size_t i;
    int q;

    for (i = 0; i < COUNT(customary); i++)
        for (q = 0; q < QUANTITY_COUNT; q++) {
            char words[100], message[MESSAGE_SIZE] = "";
            unit bare = flk_unit_of_quantity((quantity)q);
            double si = customary_factor(i, (quantity)q);
            quantity_value value;
            text t;

            sprintf(words, "2.5 %s", customary[i].name);
            print_message("%s as %s\n", words, flk_quantities[q].words);
            t = flk_text_of(words);
            assert_int_equal(flk_quantity_read(t, t, (quantity)q, bare, &value, message), si > 0);
            if (si > 0)
                assert_close(value.si, 2.5 * si, 1e-15);
            else
                assert_refused(i, (quantity)q, message);
        }
}

/* What is said where a mass is given for a force, or the other way round, and of a bare lb as a force. */
TEST(test_weights)
{
    static const struct {
        const char *words;
        quantity q;
        const char *message;
    } refused[] = {
        {"12 lbf", QUANTITY_MASS, "'12 lbf' is a force: if it is a weight, the mass is 12 lb"},
        {"12 kgf", QUANTITY_MASS, "'12 kgf' is a force: if it is a weight, the mass is 12 kg"},
        {"8 ozf", QUANTITY_MASS, "'8 ozf' is a force: if it is a weight, the mass is 8 oz"},
        {"57 kg", QUANTITY_FORCE, "'57 kg' is a mass: its weight is 57 kgf"},
        {"57 kilograms", QUANTITY_FORCE, "'57 kilograms' is a mass: its weight is 57 kgf"},
        {"3 lbm", QUANTITY_FORCE, "'3 lbm' is a mass: its weight is 3 lbf"},
        {"5 kg cm", QUANTITY_TORQUE,
         "'5 kg cm' is not a torque: if kg is a weight, write 5 kgf cm"},
        {"5 kg/cm2", QUANTITY_PRESSURE,
         "'5 kg/cm2' is not a pressure: if kg is a weight, write 5 kgf/cm2"},
        {"12 N", QUANTITY_MASS, "'12 N' is a force; expected a mass, such as 0.3 kg"},
        {"12 lb", QUANTITY_LENGTH,
         "'12 lb' is a mass or a force; expected a length, such as 80 mm"},
    };
    static const struct {
        const char *words, *unit, *message;
    } noted[] = {
        {"12 lb", "lb", "'12 lb' is read as a force, 12 lbf"},
        {"12 pounds", "pounds", "'12 pounds' is read as a force, 12 lbf"},
        {"(3, 4) oz", "oz", "'(3, 4) oz' is read as a force, (3, 4) ozf"},
        {"12 lbf", "lbf", ""},
        {"12 kg", "kg", ""},
        {"12 kgm", "kgm", ""},
        {"12 lb ft", "lb ft", ""},
        {"12", "", ""},
    };
    char message[MESSAGE_SIZE];
    size_t i;

    for (i = 0; i < COUNT(refused); i++) {
        text t = flk_text_of(refused[i].words);
        quantity_value value;

        assert_false(flk_quantity_read(t, t, refused[i].q, flk_unit_of_quantity(refused[i].q),
                                       &value, message));
        assert_string_equal(message, refused[i].message);
    }
    for (i = 0; i < COUNT(noted); i++) {
        text t = flk_text_of(noted[i].words), name = t;

        name.length = strlen(noted[i].unit);
        name.start += t.length - name.length;
        message[0] = '\0';
        assert_int_equal(flk_quantity_weight(name, t, message), noted[i].message[0] != '\0');
        assert_string_equal(message, noted[i].message);
    }
}

/* Numbers that are fractions, and of angles multiples of pi. */
TEST(test_fractions)
{
    static const struct {
        const char *words;
        quantity q;
        double si;
    } read[] = {
        {"1/3 rev", QUANTITY_ANGLE, 2 * PI / 3},
        {"pi/6", QUANTITY_ANGLE, PI / 6},
        {"pi", QUANTITY_ANGLE, PI},
        {"Pi rad", QUANTITY_ANGLE, PI},
        {"-pi/4", QUANTITY_ANGLE, -PI / 4},
        {"+pi", QUANTITY_ANGLE, PI},
        {"2pi/3", QUANTITY_ANGLE, 2 * PI / 3},
        {"2 pi/3 rad", QUANTITY_ANGLE, 2 * PI / 3},
        {"2*pi", QUANTITY_ANGLE, 2 * PI},
        {"5/18 pi", QUANTITY_ANGLE, 5 * PI / 18},
        {"-\317\200/2", QUANTITY_ANGLE, -PI / 2},
        {"pi deg", QUANTITY_ANGLE, PI * PI / 180},
        {"-30", QUANTITY_ANGLE, -PI / 6},
        {"30 deg", QUANTITY_ANGLE, PI / 6},
        {"2 pi", QUANTITY_ANGULAR_SPEED, 2 * PI},
        {"2 pi rad/s", QUANTITY_ANGULAR_SPEED, 2 * PI},
        {"100/3 rpm", QUANTITY_ANGULAR_SPEED, 10 * PI / 9},
        {"3/8 in", QUANTITY_LENGTH, 0.375 * 0.0254},
        {"-1.5/4", QUANTITY_NUMBER, -0.375},
    };
    static const struct {
        const char *words;
        quantity q;
    } refused[] = {
        {"1/0 rev", QUANTITY_ANGLE},  {"pi/0", QUANTITY_ANGLE},     {"1/2/3 rev", QUANTITY_ANGLE},
        {"pint", QUANTITY_ANGLE},     {"pi pi", QUANTITY_ANGLE},    {"pi/", QUANTITY_ANGLE},
        {"1 /3 rev", QUANTITY_ANGLE}, {"1/ 3 rev", QUANTITY_ANGLE}, {"3 1/2 in", QUANTITY_LENGTH},
        {"pi mm", QUANTITY_LENGTH},   {"2 pi", QUANTITY_NUMBER},    {"1/x", QUANTITY_NUMBER},
        {"--pi", QUANTITY_ANGLE},     {"1/-3", QUANTITY_NUMBER},    {"pi/6 mm", QUANTITY_ANGLE},
    };
    size_t i;

    for (i = 0; i < COUNT(read); i++) {
        char message[MESSAGE_SIZE];
        text t = flk_text_of(read[i].words);
        quantity_value value;

        print_message("%s\n", read[i].words);
        assert_true(
            flk_quantity_read(t, t, read[i].q, flk_unit_of_quantity(read[i].q), &value, message));
        assert_close(value.si, read[i].si, 1e-15);
    }
    for (i = 0; i < COUNT(refused); i++) {
        char message[MESSAGE_SIZE] = "";
        text t = flk_text_of(refused[i].words);
        quantity_value value;

        print_message("%s\n", refused[i].words);
        assert_false(flk_quantity_read(t, t, refused[i].q, flk_unit_of_quantity(refused[i].q),
                                       &value, message));
        assert_true(message[0] != '\0');
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
