/* SPDX-License-Identifier: GPL-3.0-or-later
**
** units.c - the units used in the field, and the quantities of a deck.
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

/* GSL's constants where they are exact by definition; those that GSL rounds (lbf, psi, hp) are computed from
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
    {"L", 1, 1e3, {3, 0, 0, 0}},
    {"cc", 1, 1e6, {3, 0, 0, 0}},
    {"kg", 1, 1, {0, 1, 0, 0}},
    {"g", 1, 1e3, {0, 1, 0, 0}},
    {"t", 1e3, 1, {0, 1, 0, 0}},
    {"lb", POUND, 1, {0, 1, 0, 0}},
    {"oz", OUNCE, 1, {0, 1, 0, 0}},
    {"lbm", POUND, 1, {0, 1, 0, 0}},
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
    {"mph", 5280 * FOOT, GSL_CONST_MKSA_HOUR, {1, 0, -1, 0}},
    {"fps", FOOT, 1, {1, 0, -1, 0}},
    {"ips", INCH, 1, {1, 0, -1, 0}},
    {"gn", G, 1, {1, 0, -2, 0}},
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
    {"Hz", 1, 1, {0, 0, -1, 0}}, /* known so that it can be refused: it is not an angular speed */
    {"%", 1, 1e2, {0, 0, 0, 0}},
    {"1", 1, 1, {0, 0, 0, 0}},
};

#define UNIT_COUNT (sizeof units / sizeof units[0])

/* Units are case-sensitive: mN and MN are not the same. */
static const named_unit *find_named_unit(text name)
{
    size_t i;

    for (i = 0; i < UNIT_COUNT; i++)
        if (flk_text_same(name, units[i].name))
            return &units[i];
    return NULL;
}

/* Words that people use for units, in upper or lower case. */
static const struct {
    const char *written, *meant;
} words[] = {
    {"rpm", "rpm"},         {"rev", "rev"},       {"revs", "rev"},       {"revolution", "rev"},
    {"revolutions", "rev"}, {"deg", "deg"},       {"degs", "deg"},       {"degca", "deg"},
    {"cad", "deg"},         {"degree", "deg"},    {"degrees", "deg"},    {"rad", "rad"},
    {"rads", "rad"},        {"radian", "rad"},    {"radians", "rad"},    {"inch", "in"},
    {"inches", "in"},       {"foot", "ft"},       {"feet", "ft"},        {"meter", "m"},
    {"meters", "m"},        {"metre", "m"},       {"metres", "m"},       {"millimeter", "mm"},
    {"millimeters", "mm"},  {"millimetre", "mm"}, {"millimetres", "mm"}, {"centimeter", "cm"},
    {"centimeters", "cm"},  {"centimetre", "cm"}, {"centimetres", "cm"}, {"sec", "s"},
    {"secs", "s"},          {"second", "s"},      {"seconds", "s"},      {"mins", "min"},
    {"minute", "min"},      {"minutes", "min"},   {"hour", "h"},         {"hours", "h"},
    {"kilogram", "kg"},     {"kilograms", "kg"},  {"kgs", "kg"},         {"gram", "g"},
    {"grams", "g"},         {"lbs", "lb"},        {"newton", "N"},       {"newtons", "N"},
    {"pascal", "Pa"},       {"joule", "J"},       {"joules", "J"},       {"watt", "W"},
    {"watts", "W"},         {"bar", "bar"},       {"bars", "bar"},       {"psi", "psi"},
    {"slugs", "slug"},      {"pound", "lb"},      {"pounds", "lb"},      {"ounce", "oz"},
    {"ounces", "oz"},       {"blobs", "blob"},    {"kips", "kip"},       {"litre", "L"},
    {"litres", "L"},        {"liter", "L"},       {"liters", "L"}};

/* Two units in one word; an exponent belongs to the second. */
static const struct {
    const char *written, *first, *second;
} pairs[] = {{"Nm", "N", "m"},       {"kNm", "kN", "m"},     {"MNm", "MN", "m"},
             {"Nmm", "N", "mm"},     {"kNmm", "kN", "mm"},   {"Ncm", "N", "cm"},
             {"kgm", "kg", "m"},     {"kgmm", "kg", "mm"},   {"kgcm", "kg", "cm"},
             {"gmm", "g", "mm"},     {"gcm", "g", "cm"},     {"lbft", "lbf", "ft"},
             {"lbin", "lbf", "in"},  {"lbfft", "lbf", "ft"}, {"lbfin", "lbf", "in"},
             {"ftlb", "ft", "lbf"},  {"inlb", "in", "lbf"},  {"ftlbf", "ft", "lbf"},
             {"inlbf", "in", "lbf"}, {"ozin", "ozf", "in"},  {"ozfin", "ozf", "in"}};

/* Units of mass, and of their weights under standard gravity; lb and oz are written for either. */
static const struct {
    const char *mass, *force;
    int is_either;
} weights[] = {{"lb", "lbf", 1}, {"oz", "ozf", 1}, {"lbm", "lbf", 0}, {"kg", "kgf", 0}};

#define WEIGHT_COUNT (sizeof weights / sizeof weights[0])

/* The unit of force that has the name of one of mass; the unit itself if there is none. */
static const named_unit *as_force(const named_unit *known)
{
    size_t i;

    for (i = 0; known && i < WEIGHT_COUNT; i++)
        if (weights[i].is_either && strcmp(known->name, weights[i].mass) == 0)
            return find_named_unit(flk_text_of(weights[i].force));
    return known;
}

/* The unit that a word names, or the second of two; null if there is none. */
static const named_unit *find_word(text word, const named_unit **first)
{
    size_t i;

    for (i = 0; i < sizeof pairs / sizeof pairs[0]; i++)
        if (flk_text_same(word, pairs[i].written)) {
            *first = find_named_unit(flk_text_of(pairs[i].first));
            return find_named_unit(flk_text_of(pairs[i].second));
        }
    *first = NULL;
    for (i = 0; i < sizeof words / sizeof words[0]; i++)
        if (flk_text_equal(word, words[i].written))
            return find_named_unit(flk_text_of(words[i].meant));
    return NULL;
}

/* What stands on motors for rpm, as a whole; 1/min is no other quantity's unit. */
static const char *const rpm[] = {"r.p.m.", "r.p.m", "r/min", "U/min", "1/min", "min^-1", "min-1"};

static text as_rpm(text t)
{
    size_t i;

    for (i = 0; i < sizeof rpm / sizeof rpm[0]; i++)
        if (i < 2 ? flk_text_equal(t, rpm[i]) : flk_text_same(t, rpm[i]))
            return flk_text_of("rpm");
    return t;
}

#define MOST_FACTORS 8

static int is_digit_at(text t, size_t i)
{
    return i < t.length && '0' <= t.start[i] && t.start[i] <= '9';
}

/* Read an exponent, with or without ^, which may be negative; 1 if there is none.  Returns 0 if no unit has
** such an exponent. */
static int read_unit_exponent(text *t)
{
    int marked = t->length && t->start[0] == '^', exponent, sign = 1;

    if (marked)
        *t = flk_text_from(*t, 1);
    if (t->length && t->start[0] == '-' && (marked || is_digit_at(*t, 1))) {
        *t = flk_text_from(*t, 1);
        sign = -1;
    }
    if (!is_digit_at(*t, 0))
        return marked ? 0 : 1;
    exponent = t->start[0] - '0';
    *t = flk_text_from(*t, 1);
    return exponent > 4 || (t->length && flk_text_is_word(t->start[0])) ? 0 : sign * exponent;
}

/* Multiply by a unit to a power, positive or negative. */
static void multiply_unit(unit *u, const named_unit *by, int exponent)
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

static text up_to_blank(text t)
{
    text word = t;

    for (word.length = 0; word.length < t.length; word.length++)
        if (flk_text_blank(flk_text_from(t, word.length)))
            break;
    return word;
}

/* Take the sign between two factors off the front of `t`; a hyphen is one between words: lb-in.  Returns 1;
** -1 if the second divides; 0 if there is none but blanks. */
static int take_sign(text *t)
{
    text rest = flk_text_trim(*t);
    int is_hyphen = t->length > 1 && t->start[0] == '-' && flk_text_is_word(t->start[1]);
    int c = rest.length ? rest.start[0] : 0;

    *t = rest;
    if (c != '.' && c != '*' && c != '/' && !is_hyphen)
        return 0;
    *t = flk_text_trim(flk_text_from(rest, 1));
    return c == '/' ? -1 : 1;
}

/* Read a unit; `forces`: lb and oz are forces. */
static int read_unit(text t, int forces, unit *result, text *bad)
{
    unit u = {1, 1, {0, 0, 0, 0}};
    int sign = 1, factors = 0, exponent;

    t = as_rpm(flk_text_trim(t));
    *bad = t;
    while (t.length) {
        const named_unit *known, *first = NULL;
        text from = t, name = take_name(&t);

        *bad = name.length ? name : t;
        if (!name.length ||
            ((known = find_named_unit(name)) == NULL && (known = find_word(name, &first)) == NULL))
            return 0;
        known = forces ? as_force(known) : known;
        factors++;
        if (flk_text_same(name, "1") && (factors > 1 || (t.length && t.start[0] != '/')))
            return 0; /* 1/s, but not 1 mm */
        if (flk_text_same(name, "%") && (factors > 1 || t.length)) {
            bad->length += t.length;
            return 0; /* a unit of its own */
        }
        exponent = read_unit_exponent(&t);
        if (!exponent) {
            *bad = up_to_blank(from);
            return 0;
        }
        if (first)
            multiply_unit(&u, first, sign);
        multiply_unit(&u, known, sign * exponent);
        if (factors > MOST_FACTORS || !(u.up < 1e30 && u.down < 1e30))
            return 0;
        *bad = flk_text_trim(t);
        sign = take_sign(&t);
        if (sign && !t.length)
            return 0; /* nothing after the sign */
        sign = sign ? sign : 1;
    }
    if (!factors)
        return 0;
    *result = u;
    return 1;
}

int flk_unit_read(text t, unit *result, text *bad)
{
    return read_unit(t, 0, result, bad);
}

int flk_unit_read_forces(text t, unit *result)
{
    text bad;

    return read_unit(t, 1, result, &bad);
}

int flk_unit_read_as(text t, dimension dim, unit *result, text *bad)
{
    unit u;

    if (!read_unit(t, 0, result, bad))
        return 0;
    if (!flk_dimension_equal(result->dim, dim) && read_unit(t, 1, &u, bad) &&
        flk_dimension_equal(u.dim, dim))
        *result = u;
    return 1;
}

/* Words that are not units, and the units that may be meant. */
static const struct {
    const char *written, *meant;
} hints[] = {{"gm", "g"},      {"gms", "g"},    {"gr", "g"},     {"mtr", "m"},
             {"nm", "N m"},    {"n", "N"},      {"ton", "t"},    {"tonne", "t"},
             {"rps", "rev/s"}, {"psig", "psi"}, {"bara", "bar"}, {"kilo", "kg"}};

/* 1 if a unit has the dimension after a word in it is replaced. */
static int fits(text t, text word, const char *replacement, dimension dim)
{
    char trial[200];
    size_t before = (size_t)(word.start - t.start), n = strlen(replacement);
    text after = flk_text_from(t, before + word.length), bad;
    unit u;

    if (before + n + after.length > sizeof trial)
        return 0;
    memcpy(trial, t.start, before);
    memcpy(trial + before, replacement, n);
    memcpy(trial + before + n, after.start, after.length);
    t.start = trial;
    t.length = before + n + after.length;
    return flk_unit_read_as(t, dim, &u, &bad) && flk_dimension_equal(u.dim, dim);
}

const char *flk_unit_nearest(text t, text word, dimension dim)
{
    const char *names[UNIT_COUNT + 1], *nearest;
    size_t i, n = 0;

    for (i = 0; i < UNIT_COUNT; i++)
        if (fits(t, word, units[i].name, dim))
            names[n++] = units[i].name;
    names[n] = NULL;
    nearest = flk_text_nearest(word, names);
    for (i = 0; i < sizeof hints / sizeof hints[0]; i++)
        if (flk_text_equal(word, hints[i].written) && fits(t, word, hints[i].meant, dim))
            return hints[i].meant;
    return nearest;
}

int flk_unit_weight(text t, dimension dim, text *word, const char **other)
{
    const named_unit *known, *first = NULL;
    text rest = t;
    size_t i;

    while (rest.length) {
        *word = take_name(&rest);
        first = NULL;
        if (!word->length) {
            rest = flk_text_from(rest, 1);
            continue;
        }
        known = find_named_unit(*word);
        known = known ? known : find_word(*word, &first);
        for (i = 0; known && !first && i < 2 * WEIGHT_COUNT; i++) {
            const char *mass = weights[i / 2].mass, *force = weights[i / 2].force;

            *other = i % 2 ? mass : force;
            if (strcmp(known->name, i % 2 ? force : mass) == 0 && fits(t, *word, *other, dim))
                return 1;
        }
    }
    return 0;
}

int flk_unit_is_weight(text t)
{
    const named_unit *known, *first = NULL;

    t = flk_text_trim(t);
    known = find_named_unit(t);
    known = known ? known : find_word(t, &first);
    return known && !first && as_force(known) != known;
}

unit flk_unit_of_quantity(quantity q)
{
    unit own = {1, 1, {0, 0, 0, 0}};
    text bad;

    flk_unit_read(flk_text_of(flk_quantities[q].unit), &own, &bad);
    return own;
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

double flk_unit_in(double number, unit from, unit to)
{
    return from.up == to.up && from.down == to.down
               ? number
               : flk_unit_from_si(flk_unit_to_si(number, from), to);
}
