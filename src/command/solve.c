/* SPDX-License-Identifier: GPL-3.0-or-later
**
** solve.c - questions answered backwards: KEY = LOW .. HIGH where NAME = VALUE, or NAME at ANGLE = VALUE.
**
** The range is walked in equal steps on each branch.  A solution is a zero of NAME - VALUE between two
** steps, or a place where it touches 0; a jump, a pole and the end of what can be assembled are none.  What
** is between two steps and back again is not found.
*/
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/message.h"
#include "base/solve.h"
#include "system/memory.h"
#include "command.h"
#include "solve.h"
#include "tables/content.h"
#include "view/view.h"
#include "view/results.h"

#define STEPS 240
#define HALVINGS 50
#define ROUNDING 1e-11 /* of the value wanted: the same */
#define CLOSE \
    1e-9 /* of the value wanted, or of the nearer one of a step: a zero, no jump and no pole */

/* The question, in the units of the input and of the result. */
typedef struct question {
    input *in;
    view v;
    char key[MESSAGE_SIZE], name[MESSAGE_SIZE];
    char told[SOLVE_NAME]; /* the name, at the angle as it was written */
    char unit[MESSAGE_SIZE],
        result_unit[MESSAGE_SIZE]; /* values set make the texts of lists invalid */
    fourlink_value of, result;     /* what is sought, and what is to have a value */
    double low, high, wanted, angle;
    int is_drawn; /* 1: the angle is that of the drawing, which KEY may change */
    double turn;  /* of a result that is an angle in a row; 0: none */
    fourlink_branch branch;
    double set; /* KEY, as it was set last; NaN: it was not, */
    int status; /* ... and what became of that */
    double steps[2][STEPS +
                    1]; /* the results minus VALUE at the steps of the range, on the branches */
    double least, most; /* of the results found */
    line *l;            /* for people, */
    sheet *s;           /* ... or of values; null: nothing but the first is wanted */
    unsigned long n;
    double first;
    int is_flat;            /* 1: the result is the value wanted in a part of the range */
    const char *gave_up;    /* why it is not known somewhere; null: it is, or there is none */
    char why[MESSAGE_SIZE]; /* why there is no solution */
    int is_silent;          /* 1: nothing is told */
} question;

/* ------------------------------------------------------------------------------------------- reading */

static void tell(const question *q, const char *what, const char *message)
{
    if (!q->is_silent)
        command_tell(what, "--solve", 0, message, q->in->o->n_decks > 1 ? q->in->name : NULL);
}

/* Say why there is no solution; returns 0. */
static int refuse(question *q, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    flk_message_list(q->why, sizeof q->why, format, values);
    va_end(values);
    tell(q, "error", q->why);
    return 0;
}

/* Read a quantity as a value of this kind; 0 and a message if it is none. */
static int read_value(question *q, text words, const fourlink_value *as, double *value)
{
    quantity kind = flk_quantity_find(as->quantity);
    char message[MESSAGE_SIZE];
    double number;

    if (!view_read(&q->v, kind, words, words, &number, message))
        return refuse(q, "%s", message);
    *value = view_si(&q->v, kind, number) / as->to_si;
    return 1;
}

/* Find a name; 0 and a message if the deck has none. */
static int find(question *q, const char *name, fourlink_value *found)
{
    return fourlink_results_find(q->in->results, name, found) == FOURLINK_OK ||
           refuse(q, "'%t' is no column, fact, extreme or input of this deck", flk_text_of(name));
}

/* Read where the result is taken, if it is a column. */
static int read_angle(question *q, text at)
{
    char message[MESSAGE_SIZE];

    q->angle = q->v.problem.motion.from;
    if (!q->result.has_angle && !at.start)
        return 1;
    if (!q->result.has_angle || !at.start)
        return refuse(q,
                      q->result.has_angle
                          ? "'%t' has a value in each row: ask for it at a crank angle, "
                            "'%t at 60 deg', or for its max() or min()"
                          : "'%t' is one value of the deck: it has none at an angle",
                      flk_text_of(q->name), flk_text_of(q->name));
    if (strcmp(q->result.quantity, "angle") == 0)
        q->turn = 2 * M_PI / q->result.to_si;
    q->is_drawn = flk_text_equal(at, "drawn");
    return view_read_crank(&q->v, at, at, &q->angle, message) || refuse(q, "%s", message);
}

/* Refuse a KEY that cannot be set, and say why. */
static int check_key(question *q)
{
    fourlink_mistake mistake;

    if (q->of.line_unit)
        return 1;
    if (results_set(q->in->results, q->key, q->low, &mistake) == FOURLINK_BAD_DECK)
        return refuse(q, "%s", mistake.message);
    return refuse(q, "'%t' follows from other values of the deck: it cannot be set",
                  flk_text_of(q->key));
}

#define FORM                                                                       \
    "expected 'KEY = LOW .. HIGH where NAME = VALUE', such as 'crank.length = 15 " \
    "mm .. 25 mm where swing = 50 deg'"

/* Read the question; 0 if it is none. */
static int read_question(question *q)
{
    text left, right, key, range, low, high, name, value, at;

    if (!flk_text_cut(flk_text_of(q->in->o->solve), " where ", &left, &right) ||
        !flk_text_cut(left, "=", &key, &range) || !flk_text_range(range, &low, &high) ||
        !flk_text_cut_last(right, "=", &name, &value))
        return refuse(q, FORM);
    at.start = NULL;
    flk_text_cut(name, " at ", &name, &at);
    flk_text_copy(key, q->key, sizeof q->key);
    flk_text_copy(name, q->name, sizeof q->name);
    if (!find(q, q->key, &q->of) || !find(q, q->name, &q->result) ||
        !read_value(q, low, &q->of, &q->low) || !read_value(q, high, &q->of, &q->high) ||
        !check_key(q) || !read_angle(q, at) || !read_value(q, value, &q->result, &q->wanted))
        return 0;
    flk_text_copy(flk_text_of(q->result.name), q->name, sizeof q->name);
    flk_message(q->told, sizeof q->told, at.start ? "%s at %t" : "%s", q->name, at);
    flk_text_copy(flk_text_of(q->of.unit), q->unit, sizeof q->unit);
    flk_text_copy(flk_text_of(q->result.unit), q->result_unit, sizeof q->result_unit);
    return q->low < q->high || refuse(q, "the range has to rise: LOW .. HIGH");
}

/* Begin a question; 0 if it is none. */
static int begin(question *q, input *in, int is_silent)
{
    memset(q, 0, sizeof *q);
    q->in = in;
    q->is_silent = is_silent;
    q->set = GSL_NAN;
    q->least = GSL_POSINF;
    q->most = GSL_NEGINF;
    view_take(&q->v, in->results);
    return read_question(q);
}

/* KEY and NAME; the texts of lists are no longer valid when a value has been set. */
static void take_columns(const question *q, fourlink_value columns[SOLVE_COLUMNS])
{
    columns[0] = q->of;
    columns[0].name = q->key;
    columns[0].unit = q->unit;
    columns[1] = q->result;
    columns[1].name = q->told;
    columns[1].unit = q->result_unit;
}

/* ------------------------------------------------------------------------------------------- solving */

/* Set KEY to x, which is in the unit of results, unless it has this value. */
static int set_key(question *q, double x)
{
    fourlink_results *r = q->in->results;

    if (x != q->set)
        q->status = results_set(r, q->key, input_in_line_unit(r, q->key, q->of.to_si, x), NULL);
    q->set = x;
    return q->status;
}

static double angle_of(const question *q)
{
    fourlink_problem problem;

    if (!q->is_drawn)
        return q->angle;
    fourlink_deck_problem(fourlink_results_deck(q->in->results), &problem);
    return problem.drawn;
}

/* NAME - VALUE with KEY set to x; NaN where it has no value or an unbounded one, or is not known. */
static double excess(double x, void *data)
{
    question *q = data;
    fourlink_value v;
    double f;
    int status = memory_has_failed() ? FOURLINK_NO_MEMORY : set_key(q, x);

    if (status == FOURLINK_OK)
        status = results_value(q->in->results, q->name, q->branch, angle_of(q), &v);
    if (results_gave_up(status))
        q->gave_up = fourlink_status_text(status);
    if (status != FOURLINK_OK || v.words || !gsl_finite(v.value))
        return GSL_NAN;
    q->least = GSL_MIN_DBL(q->least, v.value);
    q->most = GSL_MAX_DBL(q->most, v.value);
    f = v.value - q->wanted;
    if (q->turn > 0)
        f = flk_cycle_beside(f, q->turn);
    return f;
}

static double nearness(double x, void *data)
{
    return -fabs(excess(x, data));
}

/* Write a solution. */
static void put(question *q, double x)
{
    double value = excess(x, q) + q->wanted;
    fourlink_value columns[SOLVE_COLUMNS];

    if (!q->n++)
        q->first = x;
    if (q->s) {
        take_columns(q, columns);
        columns[0].value = x;
        columns[1].value = value;
        columns[0].words = columns[1].words = NULL;
        sheet_write_line(q->s, q->in->results, q->in->name, q->branch, columns, SOLVE_COLUMNS);
    } else if (q->l) {
        line_put(q->l, "%-9s %12g %s, %s = %12g %s\n", fourlink_branch_text((int)q->branch), x,
                 q->unit, q->told, value, q->result_unit);
    }
}

/* The last place where there is a value, between one that has it and one that has not. */
static flk_sample end_of_values(question *q, flk_sample has, double has_not)
{
    int i;

    for (i = 0; i < HALVINGS; i++) {
        flk_sample middle;

        middle.x = (has.x + has_not) / 2;
        middle.value = excess(middle.x, q);
        if (gsl_isnan(middle.value))
            has_not = middle.x;
        else
            has = middle;
    }
    return has;
}

/* 1 if the result has its value at a step, but for rounding. */
static int is_wanted(const question *q, double f)
{
    return fabs(f) <= ROUNDING * fabs(q->wanted);
}

/* Find a zero between two places with values of opposite signs. */
static void try_between(question *q, flk_sample from, flk_sample to)
{
    flk_bracket b = flk_bracket_of(from.x, to.x, from.value, to.value);
    double size = fabs(q->wanted) + GSL_MIN_DBL(fabs(from.value), fabs(to.value)), x;

    if (!(from.value * to.value < 0) || is_wanted(q, from.value))
        return;
    x = flk_find_zero(excess, q, &b, 0);
    if (fabs(excess(x, q)) <= CLOSE * size)
        put(q, x);
}

/* Find where three values of one sign touch 0 at the middle one. */
static void try_touching(question *q, const flk_sample p[3])
{
    flk_sample sides[3], best;
    double size = fabs(p[0].value) + fabs(p[2].value);
    int i;

    if (!(p[0].value * p[1].value > 0 && p[1].value * p[2].value > 0) ||
        fabs(p[1].value) > fabs(p[0].value) || fabs(p[1].value) > fabs(p[2].value))
        return;
    for (i = 0; i < 3; i++) {
        sides[i].x = p[i].x;
        sides[i].value = -fabs(p[i].value);
    }
    best = flk_find_peak(nearness, q, sides, 0);
    if (-best.value <= CLOSE * size)
        put(q, best.x);
}

/* Take the next place with a value; `p` are the last three, n of them in this piece. */
static void take(question *q, flk_sample p[3], int *n, flk_sample next)
{
    p[0] = p[1];
    p[1] = p[2];
    p[2] = next;
    ++*n;
    if (is_wanted(q, next.value)) {
        q->is_flat |= *n >= 2 && is_wanted(q, p[1].value);
        if (!(*n >= 2 && is_wanted(q, p[1].value)))
            put(q, next.x);
        return;
    }
    if (*n >= 2)
        try_between(q, p[1], p[2]);
    if (*n >= 3)
        try_touching(q, p);
}

static double step_at(const question *q, int k)
{
    return q->low + (q->high - q->low) * k / STEPS;
}

/* Find the results at all steps: a design serves both branches. */
static void find_steps(question *q)
{
    int i, k;

    for (k = 0; k <= STEPS; k++)
        for (i = 0; i < q->v.n_branches; i++) {
            q->branch = q->v.branches[i];
            q->steps[i][k] = excess(step_at(q, k), q);
        }
}

/* Walk through the range on branch i. */
static void walk(question *q, int i)
{
    flk_sample p[3], next;
    double before = q->low;
    int n = 0, k;

    q->branch = q->v.branches[i];
    for (k = 0; k <= STEPS; k++) {
        next.x = step_at(q, k);
        next.value = q->steps[i][k];
        if (gsl_isnan(next.value)) {
            if (n)
                take(q, p, &n, end_of_values(q, p[2], next.x));
            n = 0;
        } else {
            if (!n && k)
                take(q, p, &n, end_of_values(q, next, before));
            take(q, p, &n, next);
        }
        before = next.x;
    }
}

static void find_solutions(question *q)
{
    int i;

    find_steps(q);
    for (i = 0; i < q->v.n_branches; i++)
        walk(q, i);
}

/* Say what else is to be known of the solutions; returns the exit status. */
static int end(question *q)
{
    char message[MESSAGE_SIZE];

    if (q->is_flat)
        tell(q, "note", "the result has this value in a part of the range, or in all of it");
    if (q->gave_up) {
        flk_message(message, sizeof message, "in a part of the range %s is not known: %s", q->told,
                    q->gave_up);
        tell(q, "error", message);
    }
    if (q->n)
        return q->gave_up ? EXIT_ROWS : 0;
    if (q->least > q->most && q->gave_up)
        flk_message(q->why, sizeof q->why, "%s", q->gave_up); /* which is told */
    else if (q->least > q->most)
        refuse(q, "%s has no value in this range of %s", q->told, q->key);
    else
        refuse(q, "%s is not %.6g %s in this range of %s: it goes from %.6g to %.6g", q->told,
               q->wanted, q->result_unit, q->key, q->least, q->most);
    return EXIT_ROWS;
}

int solve_write(FILE *out, input *in)
{
    question q;
    line l;

    if (!begin(&q, in, 0))
        return EXIT_USAGE;
    line_start(&l, out);
    q.l = in->o->print_deck ? NULL : &l;
    find_solutions(&q);
    line_end(&l);
    if (q.n && in->o->print_deck)
        set_key(&q, q.first);
    if (memory_has_failed())
        return command_lacks_memory("cannot analyse", in->name);
    if (q.n && in->o->print_deck && !input_write_deck(in, out))
        return command_lacks_memory("cannot write", in->name);
    return end(&q);
}

unsigned long solve_columns(input *in, fourlink_value columns[SOLVE_COLUMNS], char name[SOLVE_NAME])
{
    question q;

    if (!begin(&q, in, 1))
        return 0;
    columns[0] = q.of;
    columns[1] = q.result;
    columns[1].name = strcpy(name, q.told);
    return SOLVE_COLUMNS;
}

int solve_put(sheet *s, input *in)
{
    question q;
    int status = EXIT_USAGE;

    if (begin(&q, in, 0)) {
        q.s = s;
        find_solutions(&q);
        status = end(&q);
    }
    if (memory_has_failed())
        return command_lacks_memory("cannot analyse", in->name);
    if (!q.n)
        content_write(s, NULL, in->name, q.why);
    return status;
}
