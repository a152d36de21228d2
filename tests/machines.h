/* SPDX-License-Identifier: GPL-3.0-or-later
**
** machines.h - linkages and engines for the tests of results: their decks, values by name, and the facts
** of a deck.
*/
#ifndef FOURLINK_MACHINES_H
#define FOURLINK_MACHINES_H

#include "formulas.h"
#include "source.h"

static const fourlink_branch branches[2] = {FOURLINK_OPEN, FOURLINK_CROSSED};

/* ---------------------------------------------------------------------------------------------
** Decks
** ------------------------------------------------------------------------------------------- */

/* Alvi's linkage with the masses of data/me3491-matrix.deck; the pump of doc/motor-pump.deck, and what
** it has besides. */
#define ROCKER                                                                           \
    "mechanism = four-bar\n[ground]\nlength = 80 mm\n"                                   \
    "[crank]\nlength = 20 mm\nmass = 0.1 kg\ngyration = 8 mm\ncg = 10 mm\n"              \
    "[coupler]\nlength = 66 mm\nmass = 0.3 kg\ngyration = 25 mm\ncg = 30 mm at 10 deg\n" \
    "[rocker]\nlength = 56 mm\nmass = 0.25 kg\ngyration = 20 mm\ncg = 28 mm at -5 deg\n"
#define PUMP                                                                                    \
    "mechanism = slider-crank\n[crank]\nlength = 50 mm\nmass = 1.5 kg\ninertia = 0.002 kg m2\n" \
    "cg = (12, 3) mm\n[rod]\nlength = 200 mm\nmass = 0.8 kg\ninertia = 0.0035 kg m2\n"          \
    "cg = 70 mm\n[ground]\noffset = 10 mm\n[piston]\nmass = 1.2 kg\n"
#define FORCE                                                                                \
    "[load P]\nlink = piston\nforce = 0 deg -100 N, 60 deg -150 N, 120 deg -150 N, 180 deg " \
    "-300 N, 200 deg -900 N,\n240 deg -1400 N, 300 deg -1200 N\n"
#define FAN                                                                                   \
    "[load F]\nlink = crank\ntorque = -0.02 N m\nover = omega2\nat_speed = 1 rad/s\nexponent" \
    " = 2\n"
#define MOTOR "[motor]\nstall_torque = 120 N m\nno_load_speed = 14 rad/s\n"
#define FLYWHEEL "[flywheel]\ninertia = 0.5 kg m2\n"

/* A deck that is in order, opened for results. */
static inline fourlink_results *opened(const char *contents)
{
    fourlink_source source = deck_source(contents);
    fourlink_results *results = NULL;
    fourlink_mistake mistake;

    if (fourlink_results_open(&source, 1, &results, &mistake, NULL) != FOURLINK_OK)
        fail_msg("%s\n%s", mistake.message, contents);
    return results;
}

/* What has this name: a column at a crank angle, a fact, an extreme or a mean. */
static inline fourlink_value named(fourlink_results *r, const char *name, fourlink_branch branch,
                                   double angle)
{
    fourlink_value v;
    int status = fourlink_results_value(r, name, branch, angle, &v);

    if (status != FOURLINK_OK)
        fail_msg("%s at %g: %s", name, angle, fourlink_status_text(status));
    return v;
}

/* Its value on the open branch, in the deck's unit. */
static inline double value_at(fourlink_results *r, const char *name, double angle)
{
    return named(r, name, FOURLINK_OPEN, angle).value;
}

static inline double si_value(fourlink_results *r, const char *name, fourlink_branch branch,
                              double angle)
{
    fourlink_value v = named(r, name, branch, angle);

    return v.value * v.to_si;
}

static inline fourlink_problem problem_of(const fourlink_results *results)
{
    fourlink_problem problem;

    assert_int_equal(fourlink_deck_problem(fourlink_results_deck(results), &problem), FOURLINK_OK);
    return problem;
}

static inline char *print(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* A deck; it is valid until the 64th after it. */
static inline char *print(const char *format, ...)
{
    static char buffer[64][4000];
    static int i;
    va_list list;
    int n;

    i = (i + 1) % 64;
    va_start(list, format);
    n = vsnprintf(buffer[i], sizeof buffer[i], format, list);
    va_end(list);
    assert_true(n > 0 && n < (int)sizeof buffer[i]);
    return buffer[i];
}

static inline char *four_bar(double a, double b, double c, double d, const char *more)
{
    return print("mechanism = four-bar\n[crank]\nlength = %.17g m\n[coupler]\nlength = %.17g m\n"
                 "[rocker]\nlength = %.17g m\n[ground]\nlength = %.17g m\n%s",
                 a, b, c, d, more);
}

static inline char *slider_crank(double r, double l, double e, const char *more)
{
    return print("mechanism = slider-crank\n[crank]\nlength = %.17g m\n[rod]\nlength = %.17g m\n"
                 "[ground]\noffset = %.17g m\n%s",
                 r, l, e, more);
}

static inline const char *revolution(double speed)
{
    return print("[motion]\nspeed = %.17g rad/s\ninterval = 40 deg\n", speed);
}

static inline double turned(double angle, double turn)
{
    return angle - turn * floor(angle / turn + 0.5);
}

/* ---------------------------------------------------------------------------------------------
** Facts
** ------------------------------------------------------------------------------------------- */

/* The facts of a deck, which are there until the next deck's take their place. */
typedef struct fact_list {
    fourlink_results *results;
    const fourlink_value *list;
    unsigned long n;
} fact_list;

static inline void facts_of(const char *contents, fact_list *list)
{
    unsigned long i;

    fourlink_results_free(list->results);
    list->results = opened(contents);
    assert_int_equal(fourlink_results_facts(list->results, 0,
                                            FOURLINK_FACTS_LIMITS | FOURLINK_FACTS_TURNING,
                                            &list->list, &list->n),
                     FOURLINK_OK);
    for (i = 0; i < list->n; i++) {
        const fourlink_value *f = &list->list[i];

        assert_true(f->words || isfinite(f->value));
        assert_true(f->meaning && *f->meaning && f->unit);
    }
}

/* The fact of a deck by that name, for both branches or for this one; null if there is none. */
static inline const fourlink_value *find_fact(const fact_list *list, const char *name,
                                              fourlink_branch branch)
{
    const fourlink_value *found = NULL;
    unsigned long i;

    for (i = 0; i < list->n; i++)
        if (strcmp(list->list[i].name, name) == 0 &&
            (list->list[i].branch == 0 || list->list[i].branch == (int)branch)) {
            assert_null(found);
            found = &list->list[i];
        }
    return found;
}

/* The value of a fact, which must be there, in the deck's unit. */
static inline double value_of(const fact_list *list, const char *name, fourlink_branch branch)
{
    const fourlink_value *f = find_fact(list, name, branch);

    if (!f || f->words)
        fail_msg("no fact %s", name);
    return f->value;
}

static inline void check_fact(const fact_list *list, const char *name, fourlink_branch branch,
                              double expected, double tolerance)
{
    double value = value_of(list, name, branch);

    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%s, %s = %.17g, expected %.17g +- %.3g", name, fourlink_branch_text((int)branch),
                 value, expected, tolerance);
}

#endif
