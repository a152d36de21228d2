/* SPDX-License-Identifier: GPL-3.0-or-later
**
** expected.c - the values that a source printed against those computed.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "column.h"
#include "expected.h"
#include "extreme.h"
#include "fact.h"
#include "base/number.h"

#define MOST_ALIKE 4 /* facts of one name: the ends of several ranges */

/* What is found under a name. */
typedef struct found {
    int is_column; /* 1: it has a value at a crank angle only */
    quantity q;
    double value;      /* in the deck's unit; of a column only at the end */
    const char *words; /* a fact in words; null: a number */
    double values
        [MOST_ALIKE]; /* of several facts of one name: that nearest to the printed one is meant */
    int n_values;
    column c;
    int sign; /* of an extreme, else 0 */
} found;

typedef struct fact_search {
    text name;
    int n;
    fact f;
    double values[MOST_ALIKE];
    char nearest[DECK_NAME_SIZE]; /* a name that is spelt nearly like it */
} fact_search;

static void take_if_named(const fact *f, void *data)
{
    fact_search *s = data;
    const char *known[2];

    if (flk_text_same(s->name, f->name) && s->n < MOST_ALIKE) {
        s->f = *f;
        s->values[s->n++] = f->value;
    }
    known[0] = f->name;
    known[1] = NULL;
    if (!s->nearest[0] && flk_text_nearest(s->name, known))
        strcpy(s->nearest, f->name);
}

static void note_unknown(deck *d, const deck_expectation *e, text name, const char *nearest)
{

    if (nearest && (!*nearest || flk_text_same(name, nearest)))
        nearest = NULL;
    flk_mistake(&d->mistakes, e->place, "'%t' is no column and no fact of this deck%h", name,
                nearest);
}

/* A column, an extreme of one, or a fact. */
static int find_name(analysis *a, deck *d, const deck_expectation *e, found *f)
{
    const char *nearest;
    fact_search s;
    int turning;
    text of;

    memset(f, 0, sizeof *f);
    f->sign = column_extreme_of(e->name, &of);
    if (f->sign && !column_find(d, of, &f->c)) {
        note_unknown(d, e, of, column_nearest(d, of));
        return 0;
    }
    if (f->sign || column_find(d, e->name, &f->c)) {
        f->is_column = !f->sign;
        f->q = column_quantity(&f->c);
        return 1;
    }
    memset(&s, 0, sizeof s);
    s.name = e->name;
    if (!fact_known(e->name, &f->q, &turning))
        turning = 1; /* all names, for the nearest */
    facts_tell(a, (int)e->branch, turning, NULL, take_if_named, &s);
    if (!s.n) {
        nearest = column_nearest(d, e->name);
        note_unknown(d, e, e->name, s.nearest[0] ? s.nearest : nearest);
        return 0;
    }
    f->q = s.f.q;
    f->words = s.f.words;
    f->n_values = s.n;
    memcpy(f->values, s.values, sizeof f->values);
    f->value = f->values[0];
    return 1;
}

/* The value of a column at the expectation's angle; 0 and a mistake if it has none. */
static int value_there(analysis *a, deck *d, const deck_expectation *e, found *f)
{
    double at;
    extreme x;
    result r;

    if (f->sign) {
        extreme_result status = extreme_find(a, &f->c, e->branch, f->sign, &x);

        if (status == EXTREME_FOUND) {
            f->value = x.value;
            return 1;
        }
        flk_mistake(&d->mistakes, e->place, "%s",
                    status == EXTREME_NONE ? "the links reach at no angle of the motion"
                                           : "it grows beyond all bounds");
        return 0;
    }
    if (!e->has_at) {
        flk_mistake(&d->mistakes, e->place,
                    "a column is expected at a crank angle: give the section 'at = ...'");
        return 0;
    }
    if (!analysis_find_angle(a, e->at, &at)) {
        flk_mistake(&d->mistakes, e->place, "the motion does not reach theta2 = %g %s", e->at,
                    d->units[QUANTITY_ANGLE].name);
        return 0;
    }
    fourlink_motion_at(&d->motion, at, &r.row);
    analysis_at(a, e->branch, &r.row.crank, &r);
    if (r.status != FOURLINK_OK && !column_of_crank(&f->c)) {
        flk_mistake(&d->mistakes, e->place, "no value at theta2 = %g %s, %s: %s", e->at,
                    d->units[QUANTITY_ANGLE].name, branch_name(e->branch),
                    fourlink_status_text(r.status));
        return 0;
    }
    f->value = column_value(&f->c, &r);
    return 1;
}

/* The tolerance in SI units: half of the last printed digit, a quantity, or per cent of the value. */
static int read_tolerance(deck *d, const deck_expectation *e, quantity q, double si, double digit,
                          double *tolerance)
{
    text t = e->tolerance;
    text_place place = e->tolerance_place;
    double ignored;

    if (!t.length) {
        *tolerance = digit / 2;
        return 1;
    }
    if (t.start[t.length - 1] == '%') {
        t.length--;
        if (!flk_deck_read_quantity(d, place, flk_text_trim(t), QUANTITY_NUMBER, tolerance,
                                    &ignored))
            return 0;
        *tolerance *= fabs(si) / 100;
    } else if (!flk_deck_read_quantity(d, place, t, q, tolerance, &ignored)) {
        return 0;
    }
    if (*tolerance >= 0)
        return 1;
    flk_mistake(&d->mistakes, place, "a tolerance must not be negative");
    return 0;
}

/* The difference of two angles is one of less than half a turn. */
static double difference(double x, double y, quantity q, double turn)
{
    double d = x - y;

    return q == QUANTITY_ANGLE ? d - turn * floor(d / turn + 0.5) : d;
}

static int compare(analysis *a, deck *d, const deck_expectation *e, check *c)
{
    const deck_unit *u;
    double si = 0, digit, tolerance, turn;
    int agrees, i;
    found f;

    memset(c, 0, sizeof *c);
    c->e = e;
    c->unit = "";
    if (!find_name(a, d, e, &f))
        return 0;
    u = &d->units[f.q];
    c->unit = f.words ? "" : u->name;
    c->at_angle = f.is_column;
    if (f.words) {
        flk_text_copy(flk_text_of(f.words), c->words, sizeof c->words);
        agrees = flk_text_equal(e->value, f.words);
    } else {
        if (!flk_deck_read_quantity(d, e->place, e->value, f.q, &si, &digit) ||
            !read_tolerance(d, e, f.q, si, digit, &tolerance) ||
            ((f.is_column || f.sign) && !value_there(a, d, e, &f)))
            return 0;
        turn = flk_unit_from_si(2 * M_PI, u->unit);
        c->printed = flk_unit_from_si(si, u->unit);
        for (i = 1; i < f.n_values; i++)
            if (fabs(difference(f.values[i], c->printed, f.q, turn)) <
                fabs(difference(f.value, c->printed, f.q, turn)))
                f.value = f.values[i];
        c->tolerance = flk_unit_from_si(tolerance, u->unit);
        c->computed = f.value;
        /* a value in the middle between two digits may be printed either way */
        agrees = fabs(difference(c->computed, c->printed, f.q, turn)) <=
                 c->tolerance * (1 + 1e-9) + 1e-12 * fabs(c->printed);
    }
    c->result = e->misprint ? (agrees ? CHECK_NO_MISPRINT : CHECK_MISPRINT)
                            : (agrees ? CHECK_OK : CHECK_DIFFERS);
    return 1;
}

int checks_run(deck *d, check_taker *take, void *data)
{
    analysis a;
    check *list = malloc((d->n_expectations + 1) * sizeof *list);
    int out_of_memory;
    size_t i;

    if (!list)
        return -1;
    if (!analysis_open(&a, d, analysis_possible(d))) {
        free(list);
        return -1;
    }
    for (i = 0; i < d->n_expectations; i++)
        if (!compare(&a, d, &d->expectations[i], &list[i]))
            list[i].result = CHECK_NO_VALUE;
    for (i = 0; i < d->n_expectations; i++)
        take(&list[i], data);
    flk_mistakes_sort(&d->mistakes);
    out_of_memory = a.out_of_memory || d->mistakes.out_of_memory;
    analysis_close(&a);
    free(list);
    if (out_of_memory)
        return -1;
    return d->mistakes.count == 0;
}
