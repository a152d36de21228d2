/* SPDX-License-Identifier: GPL-3.0-or-later
**
** check_sample.c REPORT... [NAME=VALUE...] - checks the sample calculations of reports, and those of a synthesis: evaluates
** every equation from the numbers that are printed in it, and compares it with the printed result.
**
** A printed number is right within half a unit of its last digit (6 significant digits; an angle has 4 decimals of
** a degree).  An equation agrees if the difference can come from that.  No number is so small beside those of the
** crank and the largest force that it is rounding error.  With NAME=VALUE, the result NAME has that value, within a
** unit of the last digit.  Prints what is wrong, and how many samples and equations were checked.
*/
#include <math.h>

#include "wrong.h"
#include "xml.h"

#define DEGREE (3.14159265358979323846 / 180)
#define MINUS "\342\210\222"
#define MOST 400 /* numbers of an equation, results of a sample */

static double half_unit(double x)
{
    return x != 0 ? 0.5 * pow(10, floor(log10(fabs(x))) - 5) : 0;
}

typedef struct {
    char name[MOST][60];
    double value[MOST];
    int n;
} results;

static results constants; /* of Freudenstein's equation, which stand below it */
static int is_in_turn;    /* 1: no angle is more than a turn */

/* ---------------------------------------------------------------------------------- an equation as a text */

/* "#2*cos(#3)=#4": numbers are #0, #1 ... */
typedef struct {
    char text[8000];
    double value[MOST], error[MOST];
    int n;
} equation;

static void put(equation *e, const char *words)
{
    if (strlen(e->text) + strlen(words) >= sizeof e->text)
        abort();
    strcat(e->text, words);
}

static void put_number(equation *e, const char *words)
{
    char name[20];
    int is_angle = strstr(words, "\302\260") != NULL;
    double x = strtod(words, NULL);

    if (e->n == MOST)
        abort();
    sprintf(name, "#%d", e->n);
    put(e, name);
    if (is_angle && is_in_turn && fabs(x) > 360)
        wrong("%s is more than a turn", words);
    e->value[e->n] = is_angle ? x * DEGREE : x;
    e->error[e->n++] = is_angle ? 0.5e-4 * DEGREE : half_unit(x);
}

static const char *words_of(const xml_node *x, char words[200])
{
    return x ? xml_words(x, words, 200) : "";
}

static int has_words(const xml_node *x, const char *expected)
{
    char words[200];

    return strcmp(words_of(x, words), expected) == 0;
}

#define APPLIED "\342\201\241" /* the invisible operator between a function and its argument */

static void put_operator(equation *e, const xml_node *x)
{
    static const char *const known[][2] = {
        {"/", "/"}, {MINUS, "-"}, {"+", "+"}, {"\302\267", "*"}, {"(", "("},
        {")", ")"}, {",", ","},   {"=", "="}, {APPLIED, ""},     {"\342\201\242", "*"}};
    size_t i;

    for (i = 0; i < sizeof known / sizeof known[0]; i++)
        if (has_words(x, known[i][0])) {
            put(e, known[i][1]);
            return;
        }
    wrong("an unknown operator");
}

static void put_row(equation *e, const xml_node *x);

static void put_constant(equation *e, const xml_node *x)
{
    char words[200], name[20];
    int i;

    words_of(x, words);
    for (i = 0; i < constants.n && strcmp(constants.name[i], words) != 0; i++)
        ;
    if (i == constants.n) {
        wrong("no value of %s", words);
        return;
    }
    sprintf(name, "#%d", e->n);
    put(e, name);
    e->value[e->n] = constants.value[i];
    e->error[e->n++] = half_unit(constants.value[i]);
}

static void put_element(equation *e, const xml_node *x)
{
    char words[200];

    if (xml_is(x, "mn")) {
        put_number(e, words_of(x, words));
    } else if (xml_is(x, "mo")) {
        put_operator(e, x);
    } else if (xml_is(x, "mrow") || xml_is(x, "msqrt")) {
        put(e, xml_is(x, "mrow") ? "(" : "sqrt(");
        put_row(e, x->first);
        put(e, ")");
    } else if (xml_is(x, "mfrac")) {
        put(e, "(");
        put_element(e, x->first);
        put(e, "/");
        put_element(e, x->last);
        put(e, ")");
    } else if (xml_is(x, "msup") && has_words(x->first, "10") && !has_words(x->last, "2")) {
        int is_negative = strncmp(words_of(x->last, words), MINUS, strlen(MINUS)) == 0;
        char power[60];

        sprintf(power, "1e%s%.20s", is_negative ? "-" : "",
                words + (is_negative ? strlen(MINUS) : 0));
        put(e, power);
    } else if (xml_is(x, "msup")) {
        put_element(e, x->first);
        put(e, "^");
        put(e, words_of(x->last, words));
    } else if (xml_is(x, "msub")) {
        put_constant(e, x);
    } else {
        wrong("unexpected %s", x->name);
    }
}

/* x and what follows it. */
static void put_row(equation *e, const xml_node *x)
{
    static const char *const functions[][2] = {
        {"sin", "sin"}, {"cos", "cos"}, {"arcsin", "asin"}, {"arccos", "acos"}, {"atan2", "atan2"}};

    for (; x; x = x->next) {
        size_t i = 0;

        if (xml_is(x, "mspace") || xml_is(x, "mtext"))
            continue;
        while (xml_is(x, "mi") && i < sizeof functions / sizeof functions[0] &&
               !has_words(x, functions[i][0]))
            i++;
        if (!xml_is(x, "mi") || i == sizeof functions / sizeof functions[0]) {
            put_element(e, x);
            continue;
        }
        put(e, functions[i][1]);
        do /* to its argument */
            x = x->next;
        while (xml_is(x, "mspace") || has_words(x, APPLIED));
        if (xml_is(x, "mo")) {
            put_operator(e, x);
        } else {
            put(e, "(");
            put_element(e, x);
            put(e, ")");
        }
    }
}

/* -------------------------------------------------------------------------------------------- its value */

typedef struct {
    const char *at;
    const double *value;
} reader;

static double sum(reader *r);

static int take(reader *r, const char *words)
{
    if (strncmp(r->at, words, strlen(words)) != 0)
        return 0;
    r->at += strlen(words);
    return 1;
}

/* Of printed numbers, which may be beyond the domain by their rounding. */
static double arc_sine(double x)
{
    return asin(fmax(-1, fmin(1, x)));
}

static double arc_cosine(double x)
{
    return acos(fmax(-1, fmin(1, x)));
}

static double root(double x)
{
    return sqrt(fmax(x, 0));
}

static double itself(double x)
{
    return x;
}

/* A number, a function, or a sum in brackets. */
static double operand(reader *r)
{
    static const struct {
        const char *name;
        double (*f)(double x);
    } functions[] = {{"sin(", sin},         {"cos(", cos},   {"asin(", arc_sine},
                     {"acos(", arc_cosine}, {"sqrt(", root}, {"(", itself}};
    double x = NAN, y;
    char *end;
    size_t i;

    if (take(r, "#")) {
        x = r->value[strtol(r->at, &end, 10)];
        r->at = end;
        return x;
    }
    if (strncmp(r->at, "1e", 2) == 0) {
        x = strtod(r->at, &end);
        r->at = end;
        return x;
    }
    if (take(r, "atan2(")) {
        y = sum(r);
        x = take(r, ",") ? atan2(y, sum(r)) : NAN;
    } else {
        for (i = 0; i < sizeof functions / sizeof functions[0]; i++)
            if (take(r, functions[i].name)) {
                x = functions[i].f(sum(r));
                break;
            }
    }
    if (!take(r, ")")) {
        wrong("this cannot be read: %s", r->at);
        r->at = "";
        return NAN;
    }
    return x;
}

static double factor(reader *r)
{
    double x;

    if (take(r, "-"))
        return -factor(r);
    take(r, "+");
    for (x = operand(r); take(r, "^"); r->at++)
        x = pow(x, *r->at - '0');
    return x;
}

static double product(reader *r)
{
    double x = factor(r);

    for (;;)
        if (take(r, "*"))
            x *= factor(r);
        else if (take(r, "/"))
            x /= factor(r);
        else
            return x;
}

static double sum(reader *r)
{
    double x = product(r);

    for (;;)
        if (take(r, "+"))
            x += product(r);
        else if (take(r, "-"))
            x -= product(r);
        else
            return x;
}

static double evaluate(const char *side, const double *value)
{
    reader r;
    double x;

    r.at = side;
    r.value = value;
    x = sum(&r);
    if (*r.at)
        wrong("this cannot be read: %s", r.at);
    return x;
}

/* How far a side may be from that of exact numbers. */
static double bound(const equation *e, const char *side)
{
    double value[MOST], at = evaluate(side, e->value), most = fabs(at), total = 0;
    int i, sign;

    memcpy(value, e->value, sizeof value);
    for (i = 0; i < e->n; i++) {
        double worst = 0;

        most = fmax(most, fabs(value[i]));
        for (sign = -1; sign <= 1; sign += 2) {
            value[i] = e->value[i] + sign * e->error[i];
            worst = fmax(worst, fabs(evaluate(side, value) - at));
        }
        value[i] = e->value[i];
        total += worst;
    }
    return total + 1e-12 * most;
}

/* ---------------------------------------------------------------------------------------------- a sample */

/* The first element of a formula, without the row that holds it. */
static const xml_node *content(const xml_node *math)
{
    const xml_node *x = math->first;

    return xml_is(x, "mrow") && !x->next ? x->first : x;
}

/* "θ" is "theta". */
static void keep_result(results *r, const xml_node *first, double value)
{
    static const char *const greek[][2] = {
        {"\316\270", "theta"}, {"\317\211", "omega"}, {"\316\261", "alpha"}};
    char words[200];
    int k = 0;

    words_of(first, words);
    while (k < 3 && strncmp(words, greek[k][0], 2) != 0)
        k++;
    if (r->n == MOST)
        abort();
    snprintf(r->name[r->n], sizeof r->name[0], "%s%.40s", k < 3 ? greek[k][1] : "",
             words + (k < 3 ? 2 : 0));
    r->value[r->n++] = value;
}

static void check_equation(const xml_node *div, results *found)
{
    static equation e;
    const xml_node *line, *math, *last = NULL;
    char *left, *right, *tables, words[1000], last_words[200];
    double difference;

    memset(&e, 0, sizeof e);
    for (line = div->first; line; line = line->next)
        if (xml_has(line, "class", "numbers"))
            for (math = xml_next_named(line, line, "math"); math;
                 math = xml_next_named(math, line, "math")) {
                put_row(&e, content(math));
                last = math;
            }
    if (!last)
        return;
    left = strtok(e.text, "=");
    right = left ? strtok(NULL, "=") : NULL;
    if (!right) {
        wrong("no equation: %s", xml_words(div, words, sizeof words));
        return;
    }
    tables = strtok(NULL, "="); /* the same in their unit */
    keep_result(found, content(xml_next_named(div, div, "math")),
                evaluate(tables ? tables : right, e.value));
    difference = evaluate(left, e.value) - evaluate(right, e.value);
    if (strstr(words_of(last, last_words), "\302\260"))
        difference = remainder(difference, 360 * DEGREE);
    /* each side has its own numbers, so that both bounds add up */
    if (!(fabs(difference) <= 1.01 * (bound(&e, left) + bound(&e, right))))
        wrong("%s: %.9g, but %.9g is printed", xml_words(div, words, sizeof words),
              evaluate(left, e.value), evaluate(right, e.value));
}

/* The number of a cell: "−3.2·10−5". */
static double cell(const xml_node *x)
{
    char words[200], plain[200], *minus, *power;

    for (strcpy(plain, words_of(x, words)); (minus = strstr(plain, MINUS)) != NULL;) {
        *minus = '-';
        memmove(minus + 1, minus + 3, strlen(minus + 3) + 1);
    }
    power = strstr(plain, "\302\26710");
    return strtod(plain, NULL) * (power ? pow(10, atoi(power + 4)) : 1);
}

static int read_cells(const xml_node *row, double *cells, int most)
{
    const xml_node *x;
    int n = 0;

    for (x = row->first; x; x = x->next)
        if ((xml_is(x, "td") || xml_is(x, "mtd")) && n < most)
            cells[n++] = cell(x);
    return n;
}

/* A row of the nine equations: A times the solution is b. */
static void check_matrix(const xml_node *section, const double solution[9])
{
    const xml_node *row;
    int i, n = 0;

    for (row = xml_next_named(section, section, "mtr"); row;
         row = xml_next_named(row, section, "mtr"), n++) {
        double a[12], left = 0, error, size = 0;

        if (read_cells(row, a, 12) != 12) {
            wrong("a row of the nine equations has other cells");
            return;
        }
        error = half_unit(a[11]);
        for (i = 0; i < 9; i++) {
            left += a[i] * solution[i];
            error += fabs(a[i]) * half_unit(solution[i]) + fabs(solution[i]) * half_unit(a[i]);
            size = fmax(size, fabs(solution[i]));
        }
        if (!(fabs(left - a[11]) <= 1.01 * error + 1e-12 * size))
            wrong("a row of the nine equations: %.9g, but b = %.9g", left, a[11]);
    }
    if (n != 9)
        wrong("%d rows of the nine equations", n);
}

/* `most` is the largest number of the table, beside which a 0 may have been rounding error. */
static void check_sum(const char *what, const double *terms, int n, int step, double total,
                      double most)
{
    double all = 0, error = half_unit(total) + 1e-12 * most;
    int i;

    for (i = 0; i < n; i++) {
        double x = terms[i * step];

        all += x;
        error += x != 0 ? half_unit(x) : 1e-11 * most;
    }
    if (!(fabs(all - total) <= 1.01 * error))
        wrong("%s: %g is not the sum %.9g of its %d terms", what, total, all, n);
}

/* The last row of the table of works is the sum of the others; the last number of what is known, that of those before. */
static void check_sums(const xml_node *section)
{
    const xml_node *table, *row;

    for (table = xml_next_named(section, section, "table"); table;
         table = xml_next_named(table, section, "table")) {
        int is_works = xml_has(table, "class", "facts works"), n = 0, width = 0, i;
        double cells[60][5], most = 0;

        if (!is_works && !xml_has(table, "class", "facts sides"))
            continue;
        for (row = xml_next_named(table, table, "tr"); row && n < 60;
             row = xml_next_named(row, table, "tr"))
            if (xml_is(row->parent, "tbody"))
                width = read_cells(row, cells[n++], 5);
        for (i = 0; i < n * width; i++)
            most = fmax(most, fabs(cells[i / width][i % width]));
        for (i = 0; is_works && i < width; i++)
            check_sum("works", &cells[0][i], n - 1, 5, cells[n - 1][i], most);
        for (i = 0; !is_works && i < n; i++)
            check_sum("sides", cells[i], width - 1, 1, cells[i][width - 1], most);
        if (n < 3 || width < 3)
            wrong("a table of sums of %d rows", n);
    }
}

/* ----------------------------------------------------------------------------------------------- units */

/* The number in front of its unit. */
static double number_of(const xml_node *unit)
{
    static equation e;
    const xml_node *x = unit->parent->first;

    while (x->next != unit)
        x = x->next;
    memset(&e, 0, sizeof e);
    put_element(&e, x);
    return evaluate(e.text, e.value);
}

/* The unit of a number: "W" of "\302\240W"; null for another text. */
static const char *unit_of(const xml_node *x, char words[200])
{
    if (!xml_is(x, "mtext") || x == x->parent->first ||
        strncmp(words_of(x, words), "\302\240", 2) != 0)
        return NULL;
    return words + 2;
}

typedef enum {
    LENGTH,
    AREA,
    MASS,
    FORCE,
    ENERGY,
    POWER,
    TIME,
    TIME_SQUARED,
    ANGLE,
    SPEED
} part_kind;

typedef struct {
    const char *name;
    part_kind kind;
    double si;
} part;

/* A part of a unit, of so many bytes. */
static part part_of(const char *words, size_t length)
{
    static const part known[] = {{"m", LENGTH, 1},
                                 {"mm", LENGTH, 1e-3},
                                 {"cm", LENGTH, 1e-2},
                                 {"in", LENGTH, 0.0254},
                                 {"ft", LENGTH, 0.3048},
                                 {"mm\302\262", AREA, 1e-6},
                                 {"m\302\262", AREA, 1},
                                 {"cm\302\262", AREA, 1e-4},
                                 {"in\302\262", AREA, 0.0254 * 0.0254},
                                 {"ft\302\262", AREA, 0.3048 * 0.3048},
                                 {"kg", MASS, 1},
                                 {"g", MASS, 1e-3},
                                 {"lb", MASS, 0.45359237},
                                 {"slug", MASS, 4.4482216152605 / 0.3048},
                                 {"N", FORCE, 1},
                                 {"kN", FORCE, 1e3},
                                 {"lbf", FORCE, 4.4482216152605},
                                 {"kgf", FORCE, 9.80665},
                                 {"J", ENERGY, 1},
                                 {"kJ", ENERGY, 1e3},
                                 {"W", POWER, 1},
                                 {"kW", POWER, 1e3},
                                 {"hp", POWER, 550 * 0.3048 * 4.4482216152605},
                                 {"s", TIME, 1},
                                 {"s\302\262", TIME_SQUARED, 1},
                                 {"ms", TIME, 1e-3},
                                 {"rad", ANGLE, 1},
                                 {"deg", ANGLE, DEGREE},
                                 {"\302\260", ANGLE, DEGREE},
                                 {"rev", ANGLE, 360 * DEGREE},
                                 {"rpm", SPEED, 6 * DEGREE}};
    static const part none = {"", ANGLE, NAN};
    size_t i;

    for (i = 0; i < sizeof known / sizeof known[0]; i++)
        if (strlen(known[i].name) == length && strncmp(known[i].name, words, length) == 0)
            return known[i];
    wrong("an unknown unit: %.*s", (int)length, words);
    return none;
}

/* How large the quantities of the crank are: m, N, rad/s, rad/s2. */
typedef struct {
    double length, force, speed, acceleration;
    double table; /* of numbers in tables, in their units */
} sizes;

static double size_of_part(const sizes *s, part_kind kind)
{
    switch (kind) {
    case LENGTH:
        return s->length;
    case AREA:
        return s->length * s->length;
    case MASS:
        return 0; /* it is given */
    case FORCE:
        return s->force;
    case ENERGY:
        return s->force * s->length;
    case POWER:
        return s->force * s->length * s->speed;
    case TIME:
        return 1 / s->speed;
    case TIME_SQUARED:
        return 1 / s->acceleration;
    case SPEED:
        return s->speed;
    default:
        return 1;
    }
}

/* A unit in SI; with sizes, how large what is in it is. */
static double measure(const char *unit, const sizes *s)
{
    double all = 1;
    int is_below = 0;

    while (*unit) {
        const char *slash = strchr(unit, '/'), *dot = strstr(unit, "\302\267");
        const char *end = slash && (!dot || slash < dot) ? slash : dot;
        part one = part_of(unit, end ? (size_t)(end - unit) : strlen(unit));
        double x = s ? size_of_part(s, one.kind) : one.si;

        all = is_below ? all / x : all * x;
        is_below = end && end == slash;
        unit = !end ? "" : end + (end == slash ? 1 : 2);
    }
    return all;
}

static double si_of(const char *unit)
{
    return measure(unit, NULL);
}

/* A result in two units is the same in both: "800 mm/s = 0.8 m/s". */
static void check_units(const xml_node *section)
{
    const xml_node *x, *before = NULL;
    char words[200], other[200];

    for (x = section; x; x = xml_next(x, section)) {
        const char *unit = unit_of(x, words), *first;

        if (xml_is(x, "div") || xml_is(x, "li"))
            before = NULL;
        if (!unit)
            continue;
        if (before && (first = unit_of(before, other)) != NULL) {
            double a = number_of(before), b = number_of(x), in_first = si_of(unit) / si_of(first);

            if (!(fabs(a - b * in_first) <= half_unit(a) + half_unit(b) * in_first))
                wrong("%.6g %s is not %.6g %s", a, first, b, unit);
        }
        before = x;
    }
}

/* ------------------------------------------------------------------------------------------ rounding error */

#define ROUNDING 1e-13 /* of the size of a quantity */

/* The units of length and force: "in mm, N and s". */
static void find_units(const xml_node *section, char length[40], char force[40])
{
    const xml_node *x;
    char words[1000], *at = NULL;

    *length = *force = '\0';
    for (x = section; x && !at; x = xml_next_named(x, section, "p"))
        at = xml_is(x, "p") ? strstr(xml_words(x, words, sizeof words), " branch, in") : NULL;
    if (!at || sscanf(at, " branch, in\302\240%39[^,],\302\240%39s and s", length, force) != 2)
        wrong("no units of the sample");
}

/* The length, the speed and the acceleration of the crank are the first of their units. */
static sizes find_sizes(const xml_node *section)
{
    sizes s = {0, 0, 0, 0, 0};
    const xml_node *x;
    char words[200], length[40], force[40];

    find_units(section, length, force);
    for (x = section; x; x = xml_next(x, section)) {
        const char *unit = unit_of(x, words);
        double size = unit ? fabs(number_of(x)) : 0;

        if (!unit)
            continue;
        if (strcmp(unit, length) == 0 && s.length == 0)
            s.length = size * si_of(unit);
        if (strcmp(unit, "rad/s") == 0 && s.speed == 0)
            s.speed = size;
        if (strcmp(unit, "rad/s\302\262") == 0 && s.acceleration == 0)
            s.acceleration = fmax(size, s.speed * s.speed);
        if (strcmp(unit, force) == 0)
            s.force = fmax(s.force, size * si_of(unit));
    }
    s.table = s.force / si_of(force) * fmin(s.length / si_of(length), 1);
    return s;
}

static void check_rounding(const xml_node *section)
{
    sizes s = find_sizes(section);
    const xml_node *x;
    char words[200];

    for (x = section; x; x = xml_next(x, section)) {
        const char *unit = unit_of(x, words);
        double value = 0, size = 0;

        if (unit) {
            value = number_of(x) * si_of(unit);
            size = measure(unit, &s);
        } else if (xml_is(x, "td") && xml_is(x->parent->parent, "tbody")) {
            value = cell(x);
            size = s.table; /* forces or torques */
        }
        if (value != 0 && fabs(value) < ROUNDING * size)
            wrong("%g %s is rounding error", value, unit ? unit : "in a table");
    }
}

/* ---------------------------------------------------------------------------------------------- a report */

static void check_expected(const results *found, const char *pair)
{
    const char *value = strchr(pair, '=') + 1;
    double expected = strtod(value, NULL);
    int i;

    for (i = found->n - 1; i >= 0; i--)
        if (strncmp(found->name[i], pair, strlen(found->name[i])) == 0 &&
            pair[strlen(found->name[i])] == '=')
            break;
    if (i < 0)
        wrong("no result %s", pair);
    else if (!(fabs(found->value[i] - expected) <= 2 * fmax(half_unit(expected), 1e-9)))
        wrong("%.9g, expected %s", found->value[i], pair);
}

/* Section `id` of a report; null if it has none. */
static const xml_node *find_section(const xml_document *d, const char *id)
{
    const xml_node *x;

    for (x = d->root; x && !(xml_is(x, "section") && xml_has(x, "id", id));)
        x = xml_next(x, d->root);
    return x;
}

/* The value of an entry "F12x = 3 N" of a list, the first one of "Ts = 3000 N mm = 3 N m". */
static double entry(const xml_node *x)
{
    static equation e;
    const xml_node *math = xml_next_named(x, x, "math");

    memset(&e, 0, sizeof e);
    put_row(&e, content(math)->next->next);
    return evaluate(strtok(e.text, "="), e.value);
}

/* 1 if a name stands for a number in an equation. */
static int has_constants(const xml_node *div)
{
    const xml_node *line;

    for (line = div->first; line; line = line->next)
        if (xml_has(line, "class", "numbers") && xml_next_named(line, line, "msub"))
            return 1;
    return 0;
}

/* The equations of a synthesis, with the constants that are met exactly; returns how many. */
static int check_synthesis(const xml_node *section)
{
    static results found;
    const xml_node *x;
    char words[200];
    int n = 0, is_least = 0;

    found.n = constants.n = 0;
    is_in_turn = 1;
    for (x = section; x; x = xml_next(x, section)) {
        is_least |= xml_is(x, "p") && strstr(words_of(x, words), "with the least errors") != NULL;
        if (xml_is(x, "li") && xml_has(x->parent, "class", "given") && constants.n < 3) {
            snprintf(constants.name[constants.n], sizeof constants.name[0], "%.50s",
                     words_of(content(xml_next_named(x, x, "math")), words));
            constants.value[constants.n++] = entry(x);
        }
    }
    for (x = section; x; x = xml_next(x, section))
        if (xml_is(x, "div") && xml_has(x, "class", "equation") &&
            !(is_least && has_constants(x))) {
            check_equation(x, &found);
            n++;
        }
    is_in_turn = 0;
    return n;
}

/* Returns the number of its equations. */
static int check_report(int argc, char **argv)
{
    static results found;
    const xml_node *section, *x;
    xml_document d;
    double solution[9];
    int n = 0, n_equations = 0, i;

    if (!xml_read(&d, report)) {
        wrong("%s", d.wrong);
        xml_free(&d);
        return 0;
    }
    found.n = 0;
    section = find_section(&d, "synthesis");
    if (section && !check_synthesis(section))
        wrong("no equations of the synthesis");
    section = find_section(&d, "sample");
    for (x = section; x; x = xml_next(x, section))
        if (xml_is(x, "div") && xml_has(x, "class", "equation")) {
            check_equation(x, &found);
            n_equations++;
        } else if (xml_is(x, "li") && xml_has(x->parent, "class", "given solution") && n < 9) {
            solution[n++] = entry(x);
        }
    if (n == 9)
        check_matrix(section, solution);
    else if (n)
        wrong("a solution of %d numbers", n);
    if (n)
        check_sums(section);
    check_rounding(section);
    check_units(section);
    for (i = 1; i < argc; i++)
        if (strchr(argv[i], '='))
            check_expected(&found, argv[i]);
    if (!n_equations)
        wrong("no equations");
    xml_free(&d);
    return n_equations;
}

int main(int argc, char **argv)
{
    int i, n = 0, n_equations = 0;

    for (i = 1; i < argc; i++)
        if (!strchr(argv[i], '=')) {
            report = argv[i];
            n++;
            n_equations += check_report(argc, argv);
        }
    printf("%d samples, %d equations\n", n, n_equations);
    return n_wrong > 0;
}
