/* SPDX-License-Identifier: GPL-3.0-or-later
**
** expected.c - the values that a source printed, compared with the computed ones.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/quantity.h"
#include "expected.h"
#include "fact.h"

/* What a name means. */
typedef struct found {
    flk_column c; /* a column, or that of a statistic */
    int is_column;
    flk_statistic statistic;
    quantity q;
    double value; /* in the deck's unit */
    const fourlink_value *facts;
    unsigned long n_facts; /* with this name, such as the ends of two ranges; 0: a column */
} found;

/* Of more values than people write, an unknown name is reported without a similar one, so that a large file does
** not take long. */
#define HINTED 1000

/* Report a name that is neither a column nor a fact, with the most similar one. */
static int unknown(fourlink_check *c, text name, const char *nearest)
{
    flk_message(c->message, sizeof c->message, "'%t' is neither a column nor a fact of this deck%h",
                name, nearest);
    return 0;
}

/* The first fact with a similar name. */
static const char *nearest_fact(text name, const fourlink_value *facts, unsigned long n)
{
    unsigned long i;

    for (i = 0; i < n; i++) {
        const char *known[2];

        known[0] = facts[i].name;
        known[1] = NULL;
        if (flk_text_nearest(name, known))
            return facts[i].name;
    }
    return NULL;
}

/* Find a column, a statistic of a column, or a fact. */
static int find_name(flk_analysis *a, const deck_expectation *e, fourlink_value *facts,
                     fourlink_check *c, found *f)
{
    int group = flk_fact_group(e->name), is_hinted = e - a->d->expectations < HINTED;
    unsigned long n = 0, i;
    text of;

    memset(f, 0, sizeof *f);
    f->statistic = flk_column_statistic_of(e->name, &of);
    if (f->statistic && !flk_column_find(a, of, &f->c))
        return unknown(c, of, is_hinted ? flk_column_nearest(a, of) : NULL);
    if (f->statistic || flk_column_find(a, e->name, &f->c)) {
        f->is_column = !f->statistic;
        f->q = flk_column_quantity(&f->c);
        return 1;
    }
    if (group || is_hinted)
        n = flk_fact_list(
            a, NULL, (int)e->branch,
            group ? group : FOURLINK_FACTS_LIMITS | FOURLINK_FACTS_TURNING | FOURLINK_FACTS_MOTION,
            NULL, 0, facts, NULL);
    for (i = 0; i < n; i++)
        if (flk_text_same(e->name, facts[i].name))
            facts[f->n_facts++] = facts[i];
    if (!f->n_facts) {
        const char *nearest = is_hinted ? nearest_fact(e->name, facts, n) : NULL;

        return unknown(c, e->name,
                       nearest || !is_hinted ? nearest : flk_column_nearest(a, e->name));
    }
    f->facts = facts;
    f->q = flk_quantity_find(facts[0].quantity);
    f->value = facts[0].value;
    return 1;
}

/* Find the value of a column at the expected angle, or its statistic; 0 and a message if there is none. */
static int value_there(flk_analysis *a, flk_extremes *x, const deck_expectation *e, found *f,
                       fourlink_check *c)
{
    const char *name = a->d->units[QUANTITY_ANGLE].name;
    double at;
    flk_row row;

    if (f->statistic) {
        fourlink_value v;
        int status = flk_fact_of_statistic(a, x, &f->c, "", e->branch, f->statistic, &v);

        if (status != FOURLINK_OK)
            flk_message(c->message, sizeof c->message, "%s", fourlink_status_text(status));
        f->value = v.value;
        return status == FOURLINK_OK;
    }
    if (!e->has_at) {
        flk_message(c->message, sizeof c->message,
                    "a column needs a crank angle: add 'at = ...' to this section");
        return 0;
    }
    if (!flk_course_find_angle(&a->course, e->at, &at)) {
        flk_message(c->message, sizeof c->message, "the motion does not reach theta2 = %g %s",
                    e->at, name);
        return 0;
    }
    flk_analysis_at_angle(a, flk_column_need(&f->c), e->branch, at, &row);
    f->value = flk_column_value(&f->c, &row);
    if (row.at.status == FOURLINK_OK || !gsl_isnan(f->value))
        return 1;
    flk_message(c->message, sizeof c->message, "no value at theta2 = %g %s, %s: %s", e->at, name,
                fourlink_branch_text((int)e->branch), fourlink_status_text(row.at.status));
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
    if (!flk_quantity_read(flk_text_trim(t), t, q, d->units[q].unit, &value, c->message))
        return 0;
    *tolerance = is_percent ? value.si * (fabs(printed->si) / 100) : value.si;
    if (*tolerance >= 0)
        return 1;
    flk_message(c->message, sizeof c->message, "a tolerance must not be negative");
    return 0;
}

/* The difference of two values; for angles, whose turn is above 0, it is at most half a turn. */
static double difference(double x, double y, double turn)
{
    double d = x - y;

    return turn > 0 ? d - turn * floor(d / turn + 0.5) : d;
}

int flk_expected_agrees(const fourlink_check *check, double value, double turn)
{
    if (!gsl_finite(check->printed))
        return value == check->printed;
    /* a value half-way between two digits may be rounded either way */
    return fabs(difference(value, check->printed, turn)) <=
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

/* 1 if they agree; -1 and a message if there is nothing to compare. */
static int compare(flk_analysis *a, flk_extremes *x, const deck_expectation *e,
                   fourlink_value *facts, fourlink_check *c)
{
    quantity_value printed;
    const deck_unit *u;
    double tolerance, turn;
    unsigned long i;
    int infinite;
    found f;

    if (!find_name(a, e, facts, c, &f))
        return -1;
    c->has_angle = f.is_column;
    if (f.n_facts && f.facts[0].words) {
        flk_text_copy(flk_text_of(f.facts[0].words), c->words, sizeof c->words);
        return flk_text_equal(e->value, f.facts[0].words);
    }
    u = &a->d->units[f.q];
    c->unit = u->name;
    infinite = f.is_column || f.statistic ? infinite_sign(e->value, f.q, u->unit) : 0;
    if (infinite) {
        c->printed = infinite > 0 ? GSL_POSINF : GSL_NEGINF;
        c->computed = value_there(a, x, e, &f, c) ? f.value : 0;
        return c->message[0] ? -1 : flk_expected_agrees(c, c->computed, 0);
    }
    if (!flk_quantity_read(e->value, e->value, f.q, u->unit, &printed, c->message) ||
        !read_tolerance(a->d, e, f.q, &printed, &tolerance, c))
        return -1;
    c->message_line = e->place.line;
    if (!f.n_facts && !value_there(a, x, e, &f, c))
        return -1;
    turn = f.q == QUANTITY_ANGLE ? flk_unit_from_si(2 * M_PI, u->unit) : 0;
    c->printed = flk_unit_from_si(printed.si, u->unit);
    for (i = 1; i < f.n_facts; i++) /* the nearest to the printed value is meant */
        if (fabs(difference(f.facts[i].value, c->printed, turn)) <
            fabs(difference(f.value, c->printed, turn)))
            f.value = f.facts[i].value;
    c->tolerance = flk_unit_from_si(tolerance, u->unit);
    c->computed = f.value;
    return flk_expected_agrees(c, c->computed, turn);
}

void flk_expected_compare(flk_analysis *a, flk_extremes *x, const deck_expectation *e,
                          fourlink_value *facts, fourlink_check *c)
{
    int agrees;

    memset(c, 0, sizeof *c);
    c->file = e->place.source;
    c->line = c->message_line = e->place.line;
    flk_text_copy(e->name, c->name, sizeof c->name);
    flk_text_copy(e->value, c->printed_text, sizeof c->printed_text);
    c->unit = "";
    c->angle = e->at;
    c->branch = e->branch;
    agrees = compare(a, x, e, facts, c);
    if (agrees < 0)
        c->verdict = FOURLINK_NO_VALUE;
    else if (e->misprint)
        c->verdict = agrees ? FOURLINK_NO_MISPRINT : FOURLINK_MISPRINT;
    else
        c->verdict = agrees ? FOURLINK_AGREES : FOURLINK_DIFFERS;
}
