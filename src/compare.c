/* SPDX-License-Identifier: GPL-3.0-or-later
**
** compare.c - the values that a source printed against those computed.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "column.h"
#include "compare.h"
#include "extreme.h"
#include "fact.h"
#include "number.h"

/* What is found under a name. */
typedef struct found {
    int is_column; /* 1: it has a value at a crank angle only */
    quantity q;
    double value;      /* in the deck's unit; of a column only at the end */
    const char *words; /* a fact in words; null: a number */
    column c;
    int sign; /* of an extreme, else 0 */
} found;

/* max(COLUMN) or min(COLUMN): its sign, and the column's name; 0 if it is neither. */
static int extreme_of(text name, text *of)
{
    int sign;

    if (name.length < 6 || name.start[name.length - 1] != ')')
        return 0;
    sign = memcmp(name.start, "max(", 4) == 0 ? 1 : memcmp(name.start, "min(", 4) == 0 ? -1 : 0;
    of->start = name.start + 4;
    of->length = name.length - 5;
    *of = text_trim(*of);
    return sign;
}

typedef struct fact_search {
    text name;
    fourlink_branch branch;
    int n;
    fact f;
} fact_search;

static void take_if_named(const fact *f, void *data)
{
    fact_search *s = data;

    if (text_same(s->name, f->name) && (f->branch == 0 || f->branch == (int)s->branch) && !s->n++)
        s->f = *f;
}

static void note_unknown(deck *d, const deck_expectation *e, text name)
{
    const char *nearest = column_nearest(d, name);
    char word[DECK_NAME_SIZE];

    mistake_note(&d->mistakes, e->place, "'", text_copy(name, word, sizeof word),
                 "' is no column and no fact of this deck", nearest ? "; did you mean '" : "",
                 nearest ? nearest : "", nearest ? "'?" : "", (char *)NULL);
}

/* A column, an extreme of one, or a fact. */
static int find_name(analysis *a, deck *d, const deck_expectation *e, found *f)
{
    fact_search s;
    text of;

    memset(f, 0, sizeof *f);
    f->sign = extreme_of(e->name, &of);
    if (f->sign && !column_find(d, of, &f->c)) {
        note_unknown(d, e, of);
        return 0;
    }
    if (f->sign || column_find(d, e->name, &f->c)) {
        f->is_column = !f->sign;
        f->q = column_quantity(&f->c);
        return 1;
    }
    memset(&s, 0, sizeof s);
    s.name = e->name;
    s.branch = e->branch;
    facts_tell(a, 1, NULL, take_if_named, &s);
    if (!s.n) {
        note_unknown(d, e, e->name);
        return 0;
    }
    f->q = s.f.q;
    f->value = s.f.value;
    f->words = s.f.words;
    return 1;
}

/* The value of a column at the expectation's angle; 0 and a mistake if it has none. */
static int value_there(analysis *a, deck *d, const deck_expectation *e, found *f)
{
    char number[NUMBER_SIZE];
    extreme x;
    result r;

    if (f->sign) {
        if (extreme_find(a, &f->c, e->branch, f->sign, &x)) {
            f->value = x.value;
            return 1;
        }
        mistake_note(&d->mistakes, e->place, "the links reach at no angle of the motion",
                     (char *)NULL);
        return 0;
    }
    if (!e->has_at) {
        mistake_note(&d->mistakes, e->place,
                     "a column is expected at a crank angle: give the section 'at = ...'",
                     (char *)NULL);
        return 0;
    }
    fourlink_motion_at(&d->motion, e->at, &r.row);
    analysis_at(a, e->branch, &r.row.crank, &r);
    if (r.status != FOURLINK_OK && !column_of_crank(&f->c)) {
        mistake_note(&d->mistakes, e->place,
                     "no value at theta2 = ", number_general(e->at, 9, number), " ",
                     d->units[QUANTITY_ANGLE].name, ", ", branch_name(e->branch), ": ",
                     fourlink_status_text(r.status), (char *)NULL);
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
    text_place place = e->place;
    double ignored;

    if (!t.length) {
        *tolerance = digit / 2;
        return 1;
    }
    if (t.start[t.length - 1] == '%') {
        t.length--;
        if (!deck_read_quantity(d, place, text_trim(t), QUANTITY_NUMBER, tolerance, &ignored))
            return 0;
        *tolerance *= fabs(si) / 100;
        return 1;
    }
    if (!deck_read_quantity(d, place, t, q, tolerance, &ignored))
        return 0;
    *tolerance = fabs(*tolerance);
    return 1;
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
    int agrees;
    found f;

    memset(c, 0, sizeof *c);
    c->e = e;
    if (!find_name(a, d, e, &f))
        return 0;
    u = &d->units[f.q];
    c->unit = f.words ? "" : u->name;
    c->at_angle = f.is_column;
    if (f.words) {
        text_copy(text_of(f.words), c->words, sizeof c->words);
        agrees = text_equal(e->value, f.words);
    } else {
        if (!deck_read_quantity(d, e->place, e->value, f.q, &si, &digit) ||
            !read_tolerance(d, e, f.q, si, digit, &tolerance) ||
            ((f.is_column || f.sign) && !value_there(a, d, e, &f)))
            return 0;
        turn = 2 * M_PI * u->unit.down / u->unit.up;
        c->printed = si * u->unit.down / u->unit.up;
        c->tolerance = tolerance * u->unit.down / u->unit.up;
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
    size_t i;

    if (!list)
        return -1;
    if (!analysis_open(&a, d, analysis_possible(d))) {
        free(list);
        return -1;
    }
    for (i = 0; i < d->n_expectations; i++)
        compare(&a, d, &d->expectations[i], &list[i]);
    for (i = 0; i < d->n_expectations && !d->mistakes.count; i++)
        take(&list[i], data);
    mistakes_sort(&d->mistakes);
    analysis_close(&a);
    free(list);
    return d->mistakes.count == 0;
}
