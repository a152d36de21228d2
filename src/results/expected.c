/* SPDX-License-Identifier: GPL-3.0-or-later
**
** expected.c - the values that a source printed, compared with the computed ones.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/message.h"
#include "expected.h"
#include "base/quantity.h"
#include "fact.h"
#include "deck/at_angle.h"
#include "deck/build_grading.h"

/* Beyond so many values, more than people write, an unknown name is reported without a similar name, so
** that a large file does not take long. */
#define HINTED 1000

#define ALL_FACTS (FOURLINK_FACTS_LIMITS | FOURLINK_FACTS_TURNING | FOURLINK_FACTS_MOTION)

/* Report a name that is neither a column nor a fact. */
static void refuse(fourlink_check *c, text name, const char *nearest)
{
    flk_message(c->message, sizeof c->message,
                "'%t' is neither a column nor a fact of this deck%h%s", name, nearest,
                nearest ? "" : "; see --list");
}

/* The most similar name of the deck's facts and columns. */
static const char *find_nearest(flk_opened *o, const deck_expectation *e, int handle)
{
    const char *known[FLK_FACT_LIMIT + 2], *nearest = flk_column_meant(&o->a, e->name);
    int group = flk_fact_group(handle);
    unsigned long n, i;

    if (nearest)
        return nearest;
    n = flk_fact_list(&o->a, NULL, (int)e->branch, group ? group : ALL_FACTS, 0, NULL, 0,
                      &o->found);
    for (i = 0; i < n; i++)
        known[i] = o->found.list[i].name;
    known[n] = flk_column_nearest(&o->a, e->name);
    known[n + 1] = NULL;
    return flk_text_nearest(e->name, known);
}

/* ------------------------------------------------------------------------- names as people write them */

#define FOLDED 64

/* Letters and raised or lowered digits that people write. */
static const struct {
    const char *written, *meant;
} folded[] = {{"\316\270", "theta"},
              {"\317\211", "omega"},
              {"\316\261", "alpha"},
              {"\316\274", "mu"},
              {"\302\265", "mu"},
              {"\316\263", "gamma"},
              {"\317\206", "phi"},
              {"\342\202\202", "2"},
              {"\342\202\203", "3"},
              {"\342\202\204", "4"},
              {"\342\202\201", "1"},
              {"_", ""},
              {" ", ""}};

/* A name without case, underscores and blanks, in ASCII; cut off where it is too long. */
static void fold(text t, char out[FOLDED])
{
    size_t n = 0, i, k;

    for (i = 0; i < t.length && n + 6 < FOLDED;) {
        char c = t.start[i];

        for (k = 0; k < sizeof folded / sizeof folded[0]; k++)
            if (t.length - i >= strlen(folded[k].written) &&
                memcmp(t.start + i, folded[k].written, strlen(folded[k].written)) == 0)
                break;
        if (k < sizeof folded / sizeof folded[0]) {
            strcpy(out + n, folded[k].meant);
            n += strlen(folded[k].meant);
            i += strlen(folded[k].written);
        } else {
            out[n++] = (char)('A' <= c && c <= 'Z' ? c + ('a' - 'A') : c);
            i++;
        }
    }
    out[n] = '\0';
}

/* The one column or fact that a name means if case, underscores and Greek letters do not count; null if there
** is none, or more than one. */
static const char *find_folded(flk_opened *o, const deck_expectation *e)
{
    char wanted[FOLDED], own[FOLDED];
    const char *found = NULL, *name;
    unsigned long n_facts, i;
    size_t n_columns = flk_column_limit(&o->d);
    flk_column c;

    fold(e->name, wanted);
    n_facts = flk_fact_list(&o->a, NULL, (int)e->branch, ALL_FACTS, 0, NULL, 0, &o->found);
    for (i = 0; i < n_columns + n_facts; i++) {
        if (i < n_columns && !flk_column_number(&o->a, i, &c))
            continue;
        name = i < n_columns ? c.name : o->found.list[i - n_columns].name;
        fold(flk_text_of(name), own);
        if (strcmp(own, wanted) != 0 || (found && strcmp(found, name) == 0))
            continue;
        if (found)
            return NULL;
        found = name;
    }
    return found;
}

/* Find the values of a name that has been looked up; the first of o->found are those of this name, such as
** the ends of two ranges.  Returns 0 and a message if the deck has none. */
static int find_values(flk_opened *o, const deck_expectation *e, int is_hinted, fourlink_check *c,
                       flk_name *n, unsigned long *n_facts)
{
    double angle;

    *n_facts = 0;
    if (n->kind == FLK_NAME_FACT)
        *n_facts = flk_name_facts(o, n->handle, e->branch);
    if (n->kind == FLK_NAME_COLUMN || n->kind == FLK_NAME_STATISTIC || *n_facts)
        return 1;
    if (n->at.start && !flk_at_angle_read(&o->d, n->at, &angle, c->message))
        return 0;
    refuse(c, n->of,
           !is_hinted     ? NULL
           : n->statistic ? flk_column_nearest(&o->a, n->of)
                          : find_nearest(o, e, n->handle));
    return 0;
}

/* Find the value of a column at the expected angle, or its statistic; 0 and a message if there is none. */
static int value_there(flk_opened *o, const deck_expectation *e, const flk_name *n,
                       fourlink_check *c, fourlink_value *v)
{
    const char *name = o->d.units[QUANTITY_ANGLE].name;
    static const deck_unit seconds = {"s", {1, 1, {0, 0, 1, 0}}, 1};
    const deck_unit *place =
        DECK_GOES_OVER_INPUT(&o->d) ? &o->d.units[flk_deck_over(&o->d)] : &seconds;
    int is_column = n->kind == FLK_NAME_COLUMN, status;

    if (is_column && !e->has_at) {
        flk_message(c->message, sizeof c->message,
                    "%s has no 'at' above it: a column needs a crank angle", c->name);
        return 0;
    }
    if (!is_column || !e->at_is_place)
        status = flk_name_value(o, n, e->branch, e->at, v);
    else
        status = o->d.over->is_crank_angle
                     ? FOURLINK_NO_SUCH_ANGLE
                     : flk_name_value_along(o, n, e->branch, e->side, e->at, v);
    if (status == FOURLINK_OK)
        return 1;
    if (!is_column)
        flk_message(c->message, sizeof c->message, "%s", fourlink_status_text(status));
    else if (e->at_is_place)
        flk_message(c->message, sizeof c->message, "no value at %g %s, %s: %s",
                    flk_unit_from_si(e->at, place->unit), place->name,
                    fourlink_branch_text((int)e->branch),
                    o->d.over->is_crank_angle          ? "the rows are by angle"
                    : status == FOURLINK_NO_SUCH_ANGLE ? "the motion ends before"
                                                       : fourlink_status_text(status));
    else if (status == FOURLINK_NO_SUCH_ANGLE)
        flk_message(c->message, sizeof c->message, "the motion does not reach theta2 = %g %s",
                    e->at, name);
    else
        flk_message(c->message, sizeof c->message, "no value at theta2 = %g %s, %s: %s", e->at,
                    name, fourlink_branch_text((int)e->branch), fourlink_status_text(status));
    return 0;
}

/* The tolerance in SI units: half the last printed digit, a quantity, or per cent of the value. */
static int read_tolerance(const deck *d, const deck_expectation *e, quantity q,
                          const quantity_value *printed, double *tolerance, fourlink_check *c)
{
    text t = e->tolerance;
    int is_percent = t.length && t.start[t.length - 1] == '%';
    quantity_value value;

    *tolerance = printed->digit / 2;
    if (!t.length)
        return 1;
    c->message_line = e->tolerance_place.line;
    if (is_percent) {
        t.length--;
        q = QUANTITY_NUMBER;
    }
    if (!flk_quantity_read(flk_text_trim(t), t, q, (e->is_answer ? d->shown : d->bare)[q].unit,
                           &value, c->message))
        return 0;
    *tolerance = is_percent ? value.si * (fabs(printed->si) / 100) : value.si;
    if (*tolerance >= 0)
        return 1;
    flk_message(c->message, sizeof c->message, "a tolerance must not be negative");
    return 0;
}

/* A bare rounding error agrees with 0, whatever its per cent: this much in SI units. */
#define ROUNDING 1e-9

/* What [grading] says of a value.  `percent` and `tolerance`, in SI units, are below 0 if it says nothing. */
typedef struct grading {
    double percent, tolerance;
} grading;

/* Read the items of a rule. */
static void apply(const deck *d, const deck_rule *rule, quantity q, fourlink_check *c, grading *g)
{
    text rest = rule->items, item;
    int is_percent;
    double x;

    while (flk_text_split(&rest, ',', &item)) {
        item = flk_text_trim(item);
        if (flk_rule_tolerance(d, item, q, &is_percent, &x)) {
            *(is_percent ? &g->percent : &g->tolerance) = x;
            c->tolerance_from = rule->place.line ? FOURLINK_FROM_GRADING : FOURLINK_FROM_CHANGE;
        } else {
            flk_rule_marks(item, &c->marks);
        }
    }
}

/* Find what [grading] says of a value: by its name, then by that and its angle, or else for all values of its
** quantity. */
static void find_grading(const deck *d, const deck_expectation *e, quantity q, fourlink_check *c,
                         grading *g)
{
    const deck_rule *general = NULL;
    int of_angle;
    text name, angle;
    size_t i;

    g->percent = g->tolerance = -1;
    for (of_angle = 0; of_angle <= 1; of_angle++)
        for (i = 0; i < d->n_rules; i++)
            if (!d->rules[i].name.length)
                general = &d->rules[i];
            else if (flk_at_angle_cut(d->rules[i].name, &name, &angle) == of_angle &&
                     flk_rule_is_for(d, &d->rules[i], e))
                apply(d, &d->rules[i], q, c, g);
    if (general && g->percent < 0 && g->tolerance < 0)
        apply(d, general, q, c, g);
}

/* The significant digits of a value as it is written. */
static int digits_of(text value)
{
    int n = 0;
    size_t i;

    for (i = 0; i < value.length && strchr("+-.0123456789", value.start[i]); i++)
        n += value.start[i] >= (n ? '0' : '1') && value.start[i] <= '9';
    return n;
}

/* 1 if a value has fewer digits than [grading] asks for.  Exact values, such as 3 of 3, need no more. */
static int is_short(const deck *d, const deck_expectation *e, const fourlink_check *c)
{
    return digits_of(e->value) < d->fewest_digits &&
           fabs(c->printed - c->computed) > 1e-9 * fabs(c->computed) + 1e-12;
}

double flk_expected_apart(const fourlink_check *check, double value, double turn)
{
    double d = value - check->printed;

    return turn > 0 ? flk_cycle_beside(d, turn) : d;
}

int flk_expected_agrees(const fourlink_check *check, double value, double turn)
{
    if (!gsl_finite(check->printed))
        return value == check->printed;
    /* a value half-way between two digits may be rounded either way */
    return fabs(flk_expected_apart(check, value, turn)) <=
           check->tolerance * (1 + 1e-9) + 1e-12 * fabs(check->printed);
}

/* The sign of inf or -inf, with a unit or without; 0 for another text. */
static int infinite_sign(text value, quantity q, unit usual)
{
    int sign = value.length > 0 && value.start[0] == '-' ? -1 : 1;
    char one[40], message[MESSAGE_SIZE];
    quantity_value v;

    if (sign < 0) {
        value.start++;
        value.length--;
    }
    if (value.length < 3 || memcmp(value.start, "inf", 3) != 0 || value.length > 30 ||
        (value.length > 3 && value.start[3] != ' '))
        return 0;
    one[0] = '1';
    memcpy(one + 1, value.start + 3, value.length - 3);
    one[value.length - 2] = '\0';
    value = flk_text_of(one);
    return flk_quantity_read(value, value, q, usual, &v, message) ? sign : 0;
}

#define WORDS_SIZE sizeof(((fourlink_check *)0)->words)

/* Copy words with blanks for hyphens. */
static const char *without_hyphens(text t, char *copy)
{
    char *c;

    flk_text_copy(t, copy, WORDS_SIZE);
    for (c = copy; *c; c++)
        if (*c == '-' || *c == '_')
            *c = ' ';
    return copy;
}

/* 1 if a value is these words, with hyphens or blanks: crank-rocker, Crank rocker.  Their end in parentheses
** may be missing. */
static int are_words(text value, const char *words)
{
    text all = flk_text_of(words), front, rest, given;
    char copy[WORDS_SIZE], meant[WORDS_SIZE];

    given = flk_text_of(without_hyphens(value, copy));
    return flk_text_equal(given, without_hyphens(all, meant)) ||
           (flk_text_cut(all, " (", &front, &rest) &&
            flk_text_equal(given, without_hyphens(front, meant)));
}

/* Units of an angle over time as people write them in answers, where no other than radians can be meant. */
static const struct {
    quantity q;
    const char *written, *meant;
} without_radians[] = {{QUANTITY_ANGULAR_SPEED, "1/s", " rad/s"},
                       {QUANTITY_ANGULAR_SPEED, "s^-1", " rad/s"},
                       {QUANTITY_ANGULAR_SPEED, "s-1", " rad/s"},
                       {QUANTITY_ANGULAR_ACCELERATION, "1/s2", " rad/s2"},
                       {QUANTITY_ANGULAR_ACCELERATION, "1/s^2", " rad/s2"},
                       {QUANTITY_ANGULAR_ACCELERATION, "s^-2", " rad/s2"},
                       {QUANTITY_ANGULAR_ACCELERATION, "s-2", " rad/s2"}};

/* The value of an answer, with radians for 1/s; `room` is for the text. */
static text with_radians(const deck_expectation *e, quantity q, char room[WORDS_SIZE])
{
    text written = flk_quantity_unit_text(e->value), number = e->value;
    size_t i;

    if (!e->is_answer || !written.length || number.length + 8 > WORDS_SIZE)
        return e->value;
    number.length = (size_t)(written.start - number.start);
    for (i = 0; i < sizeof without_radians / sizeof *without_radians; i++)
        if (without_radians[i].q == q && flk_text_same(written, without_radians[i].written)) {
            flk_text_copy(number, room, WORDS_SIZE);
            strcat(room, without_radians[i].meant);
            return flk_text_of(room);
        }
    return e->value;
}

/* Units in which people write numbers without saying so. */
static const char *const common_units[] = {
    "m",      "mm",    "cm",   "in",   "ft",   "rad",    "deg",    "rad/s", "rpm",
    "deg/s",  "m/s",   "mm/s", "in/s", "ft/s", "rad/s2", "deg/s2", "m/s2",  "mm/s2",
    "in/s2",  "ft/s2", "N",    "kN",   "lbf",  "N.m",    "N.mm",   "kN.m",  "lbf.in",
    "lbf.ft", "W",     "kW",   "hp",   "J",    "kJ",     "kg",     "g",     "lb"};

/* The unit in which a bare answer would agree, and its value in the unit of results in `printed`; null
** if there is none. */
static const char *find_other_unit(const fourlink_check *c, double number, quantity q, unit own,
                                   double turn, double *printed)
{
    fourlink_check other = *c;
    size_t i;
    text bad;
    unit u;

    if (fabs(c->computed) <= 2 * c->tolerance)
        return NULL; /* every small number would agree */
    for (i = 0; i < sizeof common_units / sizeof *common_units; i++) {
        if (!flk_unit_read_as(flk_text_of(common_units[i]), flk_quantities[q].dim, &u, &bad) ||
            !flk_dimension_equal(u.dim, flk_quantities[q].dim))
            continue;
        *printed = other.printed = flk_unit_from_si(flk_unit_to_si(number, u), own);
        if (c->tolerance_from == FOURLINK_FROM_DIGIT) /* in the digits that were written */
            other.tolerance = c->tolerance * fabs(other.printed / c->printed);
        if (flk_expected_agrees(&other, c->computed, turn))
            return common_units[i];
    }
    return NULL;
}

/* 1 if a bare answer agrees in another unit, and counts so; the hint says which. */
static int agrees_in_other_unit(const deck *d, const deck_expectation *e, quantity q, double number,
                                double turn, fourlink_check *c)
{
    const char *name;
    double printed;

    if (!e->is_answer || flk_quantity_unit_text(e->value).length || c->printed == 0)
        return 0;
    name = find_other_unit(c, number, q, d->units[q].unit, turn, &printed);
    if (!name)
        return 0;
    flk_message(c->hint, sizeof c->hint, "right in %s", name);
    if (d->is_strict)
        return 0;
    c->printed = printed;
    return 1;
}

/* 1 if they agree; -1 and a message if there is nothing to compare. */
static int compare(flk_opened *o, const deck_expectation *e, int is_hinted, flk_name *n,
                   fourlink_check *c)
{
    const fourlink_value *facts = o->found.list;
    quantity_value printed;
    fourlink_value found;
    unsigned long n_facts, i;
    const deck_unit *u;
    double tolerance = 0, turn;
    char room[WORDS_SIZE];
    int infinite;
    text value;
    unit bare;
    quantity q;
    grading g;

    if (!find_values(o, e, is_hinted, c, n, &n_facts))
        return -1;
    c->has_angle = n->kind == FLK_NAME_COLUMN && e->has_at;
    c->has_place = c->has_angle && e->at_is_place;
    c->place_unit = DECK_GOES_OVER_INPUT(&o->d) ? o->d.units[flk_deck_over(&o->d)].name : "s";
    c->place = !c->has_place ? 0
               : DECK_GOES_OVER_INPUT(&o->d)
                   ? flk_unit_from_si(e->at, o->d.units[flk_deck_over(&o->d)].unit)
                   : e->at;
    if (n_facts && facts[0].words) {
        flk_text_copy(flk_text_of(facts[0].words), c->words, sizeof c->words);
        return are_words(e->value, facts[0].words);
    }
    q = n_facts ? flk_quantity_find(facts[0].quantity) : flk_column_quantity(&n->c);
    u = &o->d.units[q];
    c->unit = u->name;
    find_grading(&o->d, e, q, c, &g);
    if (g.percent < 0 && g.tolerance < 0)
        c->tolerance_from = e->tolerance.length ? FOURLINK_FROM_SECTION : FOURLINK_FROM_DIGIT;
    bare = e->is_answer ? o->d.shown[q].unit : o->d.bare[q].unit;
    infinite = n_facts ? 0 : infinite_sign(e->value, q, bare);
    if (infinite) {
        c->printed = infinite > 0 ? GSL_POSINF : GSL_NEGINF;
        if (!value_there(o, e, n, c, &found))
            return -1;
        c->computed = found.value;
        return flk_expected_agrees(c, c->computed, 0);
    }
    value = with_radians(e, q, room);
    if (!flk_quantity_read(value, e->value, q, bare, &printed, c->message) ||
        (g.percent < 0 && g.tolerance < 0 && !read_tolerance(&o->d, e, q, &printed, &tolerance, c)))
        return -1;
    c->message_line = e->place.line;
    if (n_facts)
        found = facts[0];
    else if (!value_there(o, e, n, c, &found))
        return -1;
    turn = flk_name_turn(o, n);
    c->printed = flk_unit_from_si(printed.si, u->unit);
    for (i = 1; i < n_facts; i++) /* the nearest to the printed value is meant */
        if (fabs(flk_expected_apart(c, facts[i].value, turn)) <
            fabs(flk_expected_apart(c, found.value, turn)))
            found = facts[i];
    c->computed = found.value;
    if (c->has_place)
        c->angle = found.angle;
    if (g.tolerance >= 0)
        tolerance = g.tolerance;
    else if (g.percent >= 0)
        tolerance = fabs(flk_unit_to_si(found.value, u->unit)) * (g.percent / 100) + ROUNDING;
    c->tolerance = flk_unit_from_si(tolerance, u->unit);
    if (is_short(&o->d, e, c)) {
        c->is_short = 1;
        flk_message(c->hint, sizeof c->hint, "it has fewer than %g digits", o->d.fewest_digits);
        return 0;
    }
    return flk_expected_agrees(c, c->computed, turn) ||
           agrees_in_other_unit(&o->d, e, q, printed.number, turn, c);
}

int flk_expected_compare(flk_opened *o, const deck_expectation *e, flk_name *n, fourlink_check *c)
{
    deck_expectation plain = *e;
    char written[FOLDED];
    const char *name;
    int agrees, is_hinted = e - o->d.expectations < HINTED, status;

    flk_name_find(o, e->name, n);
    status = n->kind == FLK_NAME_UNKNOWN || n->kind == FLK_NAME_GIVEN /* similar facts are sought */
                 ? flk_opened_prepare(o, (int)e->branch, ALL_FACTS)
                 : flk_name_prepare(o, n, e->branch);
    if (status != FOURLINK_OK)
        return status;
    if (n->kind == FLK_NAME_UNKNOWN && !n->statistic && is_hinted &&
        (name = find_folded(o, e)) != NULL) {
        plain.name = flk_text_of(flk_text_copy(flk_text_of(name), written, sizeof written));
        flk_name_find(o, plain.name, n);
    }
    memset(c, 0, sizeof *c);
    c->file = e->place.source;
    c->line = c->message_line = e->place.line;
    flk_text_copy(plain.name, c->name, sizeof c->name);
    flk_text_copy(e->value, c->printed_text, sizeof c->printed_text);
    c->unit = "";
    c->is_misprint = e->misprint;
    c->marks = 1;
    c->angle = e->at;
    c->branch = e->branch;
    c->side = e->side;
    agrees = compare(o, &plain, is_hinted, n, c);
    if (agrees < 0)
        c->verdict = FOURLINK_NO_VALUE;
    else if (e->misprint)
        c->verdict = agrees ? FOURLINK_NO_MISPRINT : FOURLINK_MISPRINT;
    else
        c->verdict = agrees ? FOURLINK_AGREES : FOURLINK_DIFFERS;
    return FOURLINK_OK;
}
