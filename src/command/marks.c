/* SPDX-License-Identifier: GPL-3.0-or-later
**
** marks.c - what is asked of many answers, and what each is worth.
**
** All answers are asked for the same values, those that the [expect] of the exercise names.  Nothing that an
** answer says changes what is asked of it, or of others.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/message.h"
#include "system/memory.h"
#include "command.h"
#include "files.h"
#include "handed.h"
#include "copied.h"
#include "marks.h"
#include "view/results.h"
#include "view/view.h"

#define MOST_QUESTIONS 2000 /* in all answers together: each is compared with all */
#define NO_ANSWER (-1)
#define MOST_COMPARED 100000 /* answers with the decks of others, in all */

/* A value that is asked for. */
typedef struct question {
    fourlink_check value;
    double part; /* of its marks that the answers get, 0 to 1, or NO_ANSWER */
} question;

/* 1 if two crank angles are that of the same row. */
static int is_same_angle(const marks *m, double x, double y)
{
    double apart = m->turn > 0 ? flk_cycle_beside(x - y, m->turn) : x - y;

    return fabs(apart) <= 1e-9 * (1 + fabs(x));
}

static int is_asked(const marks *m, const fourlink_check *q, const fourlink_check *c)
{
    return strcmp(q->name, c->name) == 0 && q->branch == c->branch &&
           q->has_angle == c->has_angle && q->has_place == c->has_place &&
           fabs(q->place - c->place) <= 1e-9 * (1 + fabs(q->place)) &&
           (!q->has_angle || is_same_angle(m, q->angle, c->angle));
}

static question *find(const marks *m, const fourlink_check *c)
{
    unsigned long i;

    for (i = 0; i < m->n; i++)
        if (is_asked(m, &m->list[i].value, c))
            return &m->list[i];
    return NULL;
}

/* Ask for the values of a deck's [expect], and not for those of [misprint]. */
static void ask(marks *m, const input *deck)
{
    fourlink_check c;
    unsigned long i;

    for (i = 0; i < deck->problem.n_expected && m->n < MOST_QUESTIONS; i++) {
        results_check(deck->results, i, &c);
        if (find(m, &c) || c.is_misprint)
            continue;
        m->set_tolerances |=
            c.tolerance_from == FOURLINK_FROM_DIGIT || c.tolerance_from == FOURLINK_FROM_SECTION;
        c.file = c.unit = ""; /* its results may be closed */
        m->list[m->n++].value = c;
    }
}

/* Add words to a note; what does not fit is left out. */
static void put(char *note, size_t size, const char *words)
{
    size_t n = strlen(note);

    strncat(note, words, size - n - 1);
}

/* Begin another part of a note. */
static void put_part(char *note, size_t size, const char *words)
{
    put(note, size, *note ? "; " : "");
    put(note, size, words);
}

/* Add ", Ts (crossed) at 30" to a list that begins with some words. */
static void put_name(char *note, size_t size, const char *title, int *n, const fourlink_check *q)
{
    char words[200], angle[80] = "";

    if (q->has_place)
        flk_message(angle, sizeof angle, " at %g %s", q->place, q->place_unit);
    else if (q->has_angle)
        flk_message(angle, sizeof angle, " at %g", q->angle);
    put(note, size, (*n)++ ? ", " : *note ? "; " : "");
    put(note, size, *n == 1 ? title : "");
    put(note, size,
        flk_message(words, sizeof words, "%s%s%s", q->name,
                    q->branch == FOURLINK_CROSSED ? " (crossed)" : "", angle));
}

/* Give the questions their names, for sheets. */
static void name_questions(marks *m)
{
    unsigned long i;
    int none;

    for (i = 0; i < m->n; i++) {
        none = 0;
        put_name(m->questions[i].name, sizeof m->questions[i].name, "", &none, &m->list[i].value);
        m->questions[i].of = m->list[i].value.marks;
    }
}

/* Refuse to give marks where nothing says what is asked; returns the exit status. */
static int refuse_unasked(const marks *m, const input *asks)
{
    command_tell("error", asks ? asks->name : m->o->check_file, 0,
                 asks
                     ? "no [expect] says what is asked: add one to this deck, with lines such as "
                       "'at = 40 deg' and 'theta4 = 0 deg', whose values do not matter"
                     : "no exercise says what is asked: add --exercise=DECK, a deck whose [expect] "
                       "names the questions",
                 NULL);
    return EXIT_USAGE;
}

int marks_begin(marks *m, const options *o, const input *deck, const roster *names)
{
    const input *asks = deck;
    const char *name;
    view v;
    int is_class = o->check_file && files_is_folder(o->check_file), status = 0;

    memset(m, 0, sizeof *m);
    m->o = o;
    m->deck = deck;
    m->names = names;
    name = o->exercise                                         ? o->exercise
           : !deck && o->n_decks == 1 && o->scores && is_class ? o->decks[0]
                                                               : NULL;
    if (name && strcmp(name, "-") != 0) {
        status = exercise_read(&m->exercise, o, name);
        asks = &m->exercise.deck;
    }
    if (status || !(asks || (o->scores && is_class)))
        return status;
    m->list = memory_get(MOST_QUESTIONS, sizeof *m->list);
    m->questions = memory_get(MOST_QUESTIONS, sizeof *m->questions);
    if (!m->list || !m->questions)
        return command_lacks_memory("cannot start", "");
    if (asks) {
        view_take(&v, asks->results);
        flk_text_copy(flk_text_of(v.units[QUANTITY_ANGLE].name), m->unit_of_angle,
                      sizeof m->unit_of_angle);
        if (view_repeats(&v))
            m->turn = 2 * M_PI / v.problem.motion.angle_unit;
        ask(m, asks);
    }
    if (!m->n && o->scores)
        return refuse_unasked(m, asks);
    if (!m->n) {
        free(m->list);
        m->list = NULL;
    }
    name_questions(m);
    if (m->set_tolerances && is_class)
        command_tell("note", asks->name, 0,
                     "answers set their own tolerance, by 'tolerance' or their last digit; "
                     "--tolerance='1 %' or a [grading] section sets it for all",
                     NULL);
    return 0;
}

/* Find which questions an input answers, and what part of the marks the worst of its answers to one gets. */
static void find_answers(marks *m, const input *in)
{
    fourlink_check c;
    unsigned long i;
    question *q;
    double part;

    for (i = 0; i < m->n; i++)
        m->list[i].part = NO_ANSWER;
    for (i = 0; i < in->problem.n_expected; i++) {
        results_check(in->results, i, &c);
        q = find(m, &c);
        part = c.verdict == FOURLINK_MISPRINT ? 0 : c.part;
        if (q)
            q->part = q->part == NO_ANSWER ? part : GSL_MIN(q->part, part);
    }
}

/* The name of a file without its endings, which is that of a student. */
static text name_of(const char *path)
{
    text name = flk_text_of(files_name(path));

    if (flk_text_ends_in(name, ".deck")) {
        name.length -= strlen(".deck");
        return name;
    }
    return handed_stem(path);
}

/* 1 if a note has no room for more. */
static int is_full(const sheet_mark *mark)
{
    return strlen(mark->note) + 100 > sizeof mark->note;
}

/* 1 if an earlier value of the same name is wrong for the same reason. */
static int is_told(const input *in, unsigned long i, const fourlink_check *c)
{
    fourlink_check other;
    unsigned long k;

    for (k = 0; k < i; k++) {
        results_check(in->results, k, &other);
        if (other.verdict == FOURLINK_DIFFERS && strcmp(other.name, c->name) == 0 &&
            strcmp(other.hint, c->hint) == 0)
            return 1;
    }
    return 0;
}

/* Note right answers without a unit that are in another one than the table's. */
static void note_units(const marks *m, const input *in, sheet_mark *mark)
{
    char words[MESSAGE_SIZE];
    fourlink_check c;
    unsigned long i;
    int n;

    for (i = 0; i < in->problem.n_expected && !is_full(mark); i++) {
        results_check(in->results, i, &c);
        if (c.verdict != FOURLINK_AGREES || !c.hint[0] || (m->list && !find(m, &c)))
            continue;
        n = 0;
        put_name(mark->note, sizeof mark->note, "", &n, &c);
        put(mark->note, sizeof mark->note, flk_message(words, sizeof words, " (%s)", c.hint));
    }
}

/* Note what is wrong, names with the same reason together: "wrong: Ts at 60, 200 (the sign is the
** opposite)". */
static void note_wrong(const marks *m, const input *in, sheet_mark *mark)
{
    size_t size = sizeof mark->note;
    char words[MESSAGE_SIZE];
    fourlink_check c, other;
    unsigned long i, k;
    long n_short = 0;
    int n = 0;

    for (i = 0; i < in->problem.n_expected && !is_full(mark); i++) {
        results_check(in->results, i, &c);
        if (m->list && !find(m, &c))
            continue;
        n_short += c.is_short;
        if (c.verdict != FOURLINK_DIFFERS || c.is_short || is_told(in, i, &c))
            continue;
        put(mark->note, size, n++ ? ", " : *mark->note ? "; wrong: " : "wrong: ");
        put(mark->note, size, c.name);
        for (k = i; k < in->problem.n_expected && c.has_angle && !is_full(mark); k++) {
            results_check(in->results, k, &other);
            if (other.verdict == FOURLINK_DIFFERS && strcmp(other.name, c.name) == 0 &&
                strcmp(other.hint, c.hint) == 0)
                put(mark->note, size,
                    flk_message(words, sizeof words, k == i ? " at %g" : ", %g",
                                other.has_place ? other.place : other.angle));
        }
        if (c.hint[0])
            put(mark->note, size, flk_message(words, sizeof words, " (%s)", c.hint));
    }
    note_units(m, in, mark);
    if (n_short)
        put_part(mark->note, size,
                 flk_message(words, sizeof words,
                             n_short > 1 ? "%ld values have fewer digits than asked for"
                                         : "%ld value has fewer digits than asked for",
                             n_short));
}

/* Note the deck of another with which the answers agree. */
static void note_copied(marks *m, const input *in, sheet_mark *mark)
{
    char words[MESSAGE_SIZE];
    unsigned long n = 0;
    const char *deck = NULL;

    m->n_compared += in->o->n_decks;
    if (m->n_compared <= MOST_COMPARED)
        deck = copied_from(in, &n);
    if (deck)
        put_part(mark->note, sizeof mark->note,
                 flk_message(words, sizeof words,
                             "agrees with the variant of %t: %ld of %ld values", name_of(deck),
                             (long)n, (long)in->problem.n_expected));
}

/* Note the rows that a column without a place may be meant for: those at which its name is asked. */
static void note_row(const marks *m, const fourlink_check *c, sheet_mark *mark)
{
    size_t size = sizeof mark->note;
    char words[MESSAGE_SIZE];
    const fourlink_check *q;
    unsigned long i;
    int n = 0;

    for (i = 0; i < m->n; i++) {
        q = &m->list[i].value;
        if (c->has_angle || !q->has_angle || strcmp(q->name, c->name) != 0 ||
            q->branch != c->branch)
            continue;
        put(mark->note, size, n++ ? " or " : "; read as the row at ");
        put(mark->note, size,
            flk_message(words, sizeof words, "%g %s", q->has_place ? q->place : q->angle,
                        q->has_place ? q->place_unit : m->unit_of_angle));
    }
    put(mark->note, size, n ? "?" : "");
}

/* Note what is odd in an answer: values that are not asked for, without a value, or known to be wrong. */
static void note_checks(const marks *m, const input *in, sheet_mark *mark)
{
    size_t size = sizeof mark->note;
    char words[MESSAGE_SIZE + 40];
    int n_extra = 0, has_misprint = 0, sets_tolerance = 0, has_grading = 0;
    const question *q;
    fourlink_check c;
    unsigned long i;

    for (i = 0; i < in->problem.n_expected; i++) {
        results_check(in->results, i, &c);
        has_misprint |= c.verdict == FOURLINK_MISPRINT || c.verdict == FOURLINK_NO_MISPRINT;
        sets_tolerance |= c.tolerance_from == FOURLINK_FROM_SECTION;
        q = m->list ? find(m, &c) : NULL;
        has_grading |= m->exercise.deck.results && c.tolerance_from == FOURLINK_FROM_GRADING;
        if (c.verdict == FOURLINK_NO_VALUE && !is_full(mark)) {
            put_part(mark->note, size,
                     flk_message(words, sizeof words, "line %ld: %s", c.message_line, c.message));
            if (m->list && !q)
                note_row(m, &c, mark);
        } else if (c.verdict != FOURLINK_NO_VALUE && m->list && !q) {
            put_name(mark->note, size, "not asked: ", &n_extra, &c);
        }
    }
    if (has_misprint && m->list)
        put_part(mark->note, size, "a value of [misprint] is no answer");
    if (sets_tolerance && m->list)
        put_part(mark->note, size, "sets its own tolerance");
    if (has_grading) /* which the exercise does not set: a student's own */
        put_part(mark->note, size, "by the [grading] of its deck");
    note_wrong(m, in, mark);
    if (in->remarks[0])
        put_part(mark->note, size, in->remarks);
}

/* The id and the days late of the list of names, and the marks after the deduction of [grading]. */
static void take_entry(const marks *m, const input *in, sheet_mark *mark)
{
    const fourlink_problem *p = m->exercise.deck.results ? &m->exercise.deck.problem
                                : m->deck                ? &m->deck->problem
                                                         : &in->problem;
    const roster_entry *e =
        in->student ? in->student->entry : roster_find(m->names, flk_text_of(mark->name));

    mark->total = mark->right;
    if (!e)
        return;
    flk_text_copy(e->id, mark->id, sizeof mark->id);
    mark->late = e->late;
    mark->total *= GSL_MAX_DBL(0, 1 - e->late * p->late);
}

static void give(marks *m, const input *in, sheet_mark *mark)
{
    const char *path = in->deck ? in->source.answers_name : in->name;
    int n_missing = 0;
    fourlink_check c;
    unsigned long i;

    memset(mark, 0, sizeof *mark);
    mark->path = path ? path : in->student ? in->student->name.start : "";
    flk_text_copy(in->deck && in->student ? in->student->name : name_of(mark->path), mark->name,
                  sizeof mark->name);
    for (i = 0; i < m->n; i++) {
        mark->of += m->list[i].value.marks;
        m->questions[i].got = GSL_NAN;
    }
    if (!in->results) {
        put(mark->note, sizeof mark->note, in->refusal);
        return;
    }
    find_answers(m, in);
    for (i = 0; i < m->n; i++) {
        if (m->list[i].part == NO_ANSWER) {
            put_name(mark->note, sizeof mark->note, "missing: ", &n_missing, &m->list[i].value);
            continue;
        }
        m->questions[i].got = m->list[i].part * m->list[i].value.marks;
        mark->right += m->questions[i].got;
    }
    for (i = 0; i < in->problem.n_expected && !m->list; i++) {
        results_check(in->results, i, &c);
        mark->right += c.part * c.marks;
        mark->of += c.marks;
    }
    if (2 * mark->right < mark->of && !in->deck && m->list)
        note_copied(m, in, mark);
    note_checks(m, in, mark);
}

long marks_question(const marks *m, const fourlink_check *c)
{
    const question *q = find(m, c);

    return q ? (long)(q - m->list) : -1;
}

const fourlink_check *marks_asked(const marks *m, unsigned long i)
{
    return &m->list[i].value;
}

void marks_give(marks *m, const input *in, sheet_mark *mark)
{
    give(m, in, mark);
    take_entry(m, in, mark);
}

void marks_free(marks *m)
{
    free(m->questions);
    exercise_close(&m->exercise);
    free(m->list);
}
