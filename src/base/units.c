/* SPDX-License-Identifier: GPL-3.0-or-later
**
** units.c - the units of the field, and the quantities of a deck.
*/
#include <string.h>

#include <gsl/gsl_const_mksa.h>
#include <gsl/gsl_math.h>

#include "units.h"

#define QUANTITY_INFO(name, key, words, m, kg, s, rad, unit, example) \
    {key, words, {m, kg, s, rad}, unit, example},
const quantity_info flk_quantities[QUANTITY_COUNT] = {QUANTITY_LIST(QUANTITY_INFO)};

quantity flk_quantity_find(const char *name)
{
    int q;

    for (q = 0; q < QUANTITY_COUNT && strcmp(name, flk_quantities[q].name) != 0; q++)
        ;
    return (quantity)q;
}

/* GSL's constants if they are exact by definition; those that it rounds (lbf, psi, hp) are computed from
** these. */
#define INCH GSL_CONST_MKSA_INCH
#define FOOT GSL_CONST_MKSA_FOOT
#define POUND GSL_CONST_MKSA_POUND_MASS
#define OUNCE (POUND / 16)
#define G GSL_CONST_MKSA_GRAV_ACCEL

typedef struct named_unit {
    const char *name;
    double up, down;
    dimension dim;
} named_unit;

static const named_unit units[] = {
    {"m", 1, 1, {1, 0, 0, 0}},
    {"mm", 1, 1e3, {1, 0, 0, 0}},
    {"cm", 1, 1e2, {1, 0, 0, 0}},
    {"km", 1e3, 1, {1, 0, 0, 0}},
    {"in", INCH, 1, {1, 0, 0, 0}},
    {"ft", FOOT, 1, {1, 0, 0, 0}},
    {"kg", 1, 1, {0, 1, 0, 0}},
    {"g", 1, 1e3, {0, 1, 0, 0}},
    {"t", 1e3, 1, {0, 1, 0, 0}},
    {"lb", POUND, 1, {0, 1, 0, 0}},
    {"oz", OUNCE, 1, {0, 1, 0, 0}},
    {"slug", POUND *G, FOOT, {0, 1, 0, 0}}, /* lbf s2/ft */
    {"blob", POUND *G, INCH, {0, 1, 0, 0}}, /* lbf s2/in */
    {"s", 1, 1, {0, 0, 1, 0}},
    {"ms", 1, 1e3, {0, 0, 1, 0}},
    {"min", GSL_CONST_MKSA_MINUTE, 1, {0, 0, 1, 0}},
    {"h", GSL_CONST_MKSA_HOUR, 1, {0, 0, 1, 0}},
    {"rad", 1, 1, {0, 0, 0, 1}},
    {"mrad", 1, 1e3, {0, 0, 0, 1}},
    {"deg", M_PI, 180, {0, 0, 0, 1}},
    {"rev", 2 * M_PI, 1, {0, 0, 0, 1}},
    {"rpm", 2 * M_PI, GSL_CONST_MKSA_MINUTE, {0, 0, -1, 1}},
    {"N", 1, 1, {1, 1, -2, 0}},
    {"kN", 1e3, 1, {1, 1, -2, 0}},
    {"MN", 1e6, 1, {1, 1, -2, 0}},
    {"lbf", POUND *G, 1, {1, 1, -2, 0}},
    {"kgf", G, 1, {1, 1, -2, 0}},
    {"ozf", OUNCE *G, 1, {1, 1, -2, 0}},
    {"kip", 1e3 * POUND *G, 1, {1, 1, -2, 0}},
    {"J", 1, 1, {2, 1, -2, 0}},
    {"kJ", 1e3, 1, {2, 1, -2, 0}},
    {"W", 1, 1, {2, 1, -3, 0}},
    {"kW", 1e3, 1, {2, 1, -3, 0}},
    {"hp", 550 * FOOT *POUND *G, 1, {2, 1, -3, 0}}, /* ft lbf/s */
    {"Pa", 1, 1, {-1, 1, -2, 0}},
    {"kPa", 1e3, 1, {-1, 1, -2, 0}},
    {"MPa", 1e6, 1, {-1, 1, -2, 0}},
    {"GPa", 1e9, 1, {-1, 1, -2, 0}},
    {"bar", GSL_CONST_MKSA_BAR, 1, {-1, 1, -2, 0}},
    {"psi", POUND *G, INCH *INCH, {-1, 1, -2, 0}},
    {"atm", GSL_CONST_MKSA_STD_ATMOSPHERE, 1, {-1, 1, -2, 0}},
    {"Hz", 1, 1, {0, 0, -1, 0}}, /* known, to be refused: it is not an angular speed */
    {"%", 1, 1e2, {0, 0, 0, 0}},
    {"1", 1, 1, {0, 0, 0, 0}},
};

#define UNIT_COUNT (sizeof units / sizeof units[0])

/* Units are case-sensitive: mN and MN are not the same. */
static const named_unit *find(text name)
{
    size_t i;

    for (i = 0; i < UNIT_COUNT; i++)
        if (flk_text_same(name, units[i].name))
            return &units[i];
    return NULL;
}

/* Words that people use, and the units they mean. */
static const struct {
    const char *written, *meant;
} synonyms[] = {{"Nm", "N m"},      {"N\302\267m", "N m"}, {"kgm2", "kg m2"}, {"inch", "in"},
                {"inches", "in"},   {"feet", "ft"},        {"foot", "ft"},    {"meter", "m"},
                {"metre", "m"},     {"meters", "m"},       {"metres", "m"},   {"degree", "deg"},
                {"degrees", "deg"}, {"\302\260", "deg"},   {"radian", "rad"}, {"radians", "rad"},
                {"sec", "s"},       {"second", "s"},       {"seconds", "s"},  {"minute", "min"},
                {"hour", "h"},      {"lbs", "lb"},         {"pound", "lb"},   {"kilogram", "kg"},
                {"gram", "g"},      {"newton", "N"},       {"pascal", "Pa"},  {"rps", "rev/s"},
                {"lbft", "lbf.ft"}, {"lbin", "lbf.in"}};

/* The nearest unit of a dimension, or of all. */
static const char *nearest_of(text word, const dimension *dim)
{
    const char *names[UNIT_COUNT + 1];
    size_t i, n = 0;

    for (i = 0; i < UNIT_COUNT; i++)
        if (!dim || flk_dimension_equal(units[i].dim, *dim))
            names[n++] = units[i].name;
    names[n] = NULL;
    return flk_text_nearest(word, names);
}

const char *flk_unit_nearest(text word, const dimension *dim)
{
    const char *nearest = dim ? nearest_of(word, dim) : NULL;
    unit meant;
    text bad;
    size_t i;

    for (i = 0; i < sizeof synonyms / sizeof synonyms[0]; i++)
        if (flk_text_equal(word, synonyms[i].written) &&
            (!nearest || (flk_unit_read(flk_text_of(synonyms[i].meant), &meant, &bad) &&
                          flk_dimension_equal(meant.dim, *dim))))
            return synonyms[i].meant;
    return nearest ? nearest : nearest_of(word, NULL);
}

#define MOST_FACTORS 8

/* Read an exponent, with or without ^; 1 if there is none.  Returns 0 if units do not have it. */
static int read_exponent(text *t)
{
    int marked = t->length && t->start[0] == '^', exponent;

    if (marked)
        *t = flk_text_from(*t, 1);
    if (!t->length || t->start[0] < '0' || t->start[0] > '9')
        return marked ? 0 : 1;
    exponent = t->start[0] - '0';
    *t = flk_text_from(*t, 1);
    return exponent > 4 || (t->length && flk_text_is_word(t->start[0])) ? 0 : exponent;
}

/* Multiply by a unit to a power, positive or negative. */
static void multiply(unit *u, const named_unit *by, int exponent)
{
    int i, n = exponent < 0 ? -exponent : exponent;

    for (i = 0; i < n; i++) {
        u->up *= exponent > 0 ? by->up : by->down;
        u->down *= exponent > 0 ? by->down : by->up;
    }
    u->dim.m += exponent * by->dim.m;
    u->dim.kg += exponent * by->dim.kg;
    u->dim.s += exponent * by->dim.s;
    u->dim.rad += exponent * by->dim.rad;
}

/* Take the name off the start of `t`; empty if there is none. */
static text take_name(text *t)
{
    text name = *t;

    if (t->length && t->start[0] == '%') {
        *t = flk_text_from(*t, 1);
        name.length = 1;
        return name;
    }
    while (t->length && flk_text_is_word(t->start[0]) &&
           (t->start == name.start || t->start[0] < '0' || t->start[0] > '9'))
        *t = flk_text_from(*t, 1);
    name.length -= t->length;
    return name;
}

int flk_unit_read(text t, unit *result, text *bad)
{
    unit u = {1, 1, {0, 0, 0, 0}};
    int sign = 1, factors = 0, exponent;

    t = flk_text_trim(t);
    *bad = t;
    while (t.length) {
        const named_unit *known;
        text name = take_name(&t);

        *bad = name.length ? name : t;
        if (!name.length || (known = find(name)) == NULL)
            return 0;
        factors++;
        if (flk_text_same(name, "1") && (factors > 1 || (t.length && t.start[0] != '/')))
            return 0; /* 1/s, but not 1 mm */
        if (flk_text_same(name, "%") && (factors > 1 || t.length)) {
            bad->length += t.length;
            return 0; /* a unit of its own */
        }
        exponent = read_exponent(&t);
        if (!exponent)
            return 0;
        multiply(&u, known, sign * exponent);
        if (factors > MOST_FACTORS || !(u.up < 1e30 && u.down < 1e30))
            return 0;
        sign = 1;
        t = flk_text_trim(t);
        if (!t.length)
            break;
        *bad = t;
        if (t.start[0] == '.' || t.start[0] == '*' || t.start[0] == '/') {
            sign = t.start[0] == '/' ? -1 : 1;
            t = flk_text_trim(flk_text_from(t, 1));
            if (!t.length)
                return 0; /* nothing after the sign */
        }
    }
    if (!factors)
        return 0;
    *result = u;
    return 1;
}

int flk_dimension_equal(dimension x, dimension y)
{
    return x.m == y.m && x.kg == y.kg && x.s == y.s && x.rad == y.rad;
}

double flk_unit_to_si(double number, unit u)
{
    return number * u.up / u.down;
}

double flk_unit_from_si(double si, unit u)
{
    return si * u.down / u.up;
}
