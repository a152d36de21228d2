/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fuzz_decks.c - decks, with all that a host can ask of them.
**
** Input: a deck; after a form feed, a file that it names; after another, answers; after another, a change.
*/
#include <math.h>

#include "fourlink.h"
#include "input.h"

/* Work is in proportion to these, so a deck with more is only read. */
#define MOST_ROWS 400
#define MOST_COLUMNS 12
#define MOST_DESIGNS 100000
#define MOST_MISTAKES 8

static const fourlink_branch branches[] = {FOURLINK_OPEN, FOURLINK_CROSSED};

static const char *load(void *host, const char *file_name, unsigned long *length)
{
    const part *card = host;

    (void)file_name;
    *length = (unsigned long)card->length;
    return card->text;
}

static void ask_rows(fourlink_results *r, const fourlink_problem *p, double *values,
                     fourlink_load *loads)
{
    fourlink_instant now;
    unsigned long i;
    int b, status;

    for (b = 0; b < 2; b++)
        for (i = 0; i <= p->n_rows; i++) {
            status = fourlink_results_row(r, branches[b], i, values, &now, loads);
            MUST((i == p->n_rows) == (status == FOURLINK_NO_SUCH_ROW));
            MUST(status < 20 || status == FOURLINK_INPUT_DEAD_CENTRE ||
                 status == FOURLINK_NO_SUCH_ROW ||
                 (p->is_prescribed && status == FOURLINK_NO_SUCH_ANGLE));
            if (status != FOURLINK_OK)
                continue;
            MUST(isfinite(now.state.sine) && isfinite(now.row.time));
            MUST(isfinite(now.forces.F12x) && isfinite(now.forces.F12y));
            MUST(isfinite(now.forces.F34x) && isfinite(now.forces.Ts));
            status = fourlink_results_along(r, branches[b], now.row.place, values, &now, loads);
            MUST(status == FOURLINK_OK);
            status = fourlink_results_at(r, branches[b], now.row.angle, values, &now, loads);
            MUST(status < 20 || status == FOURLINK_INPUT_DEAD_CENTRE ||
                 status == FOURLINK_NO_SUCH_ANGLE);
        }
}

static void ask_lists(fourlink_results *r)
{
    const fourlink_value *list;
    fourlink_value value;
    unsigned long n, i;
    char name[200];
    int which;

    for (which = FOURLINK_COLUMNS; which <= FOURLINK_CONDITIONS; which++) {
        MUST(fourlink_results_list(r, which, &list, &n) == FOURLINK_OK);
        for (i = 0; i < n; i++)
            MUST(list[i].name && list[i].unit && list[i].meaning && strlen(list[i].name) < 4096);
        if (which == FOURLINK_OUTPUTS)
            for (i = 0; i < n && i < 10; i++)
                fourlink_results_value(r, list[i].name, FOURLINK_OPEN, 0, &value);
        if (which == FOURLINK_COLUMNS)
            for (i = 0; i < n && i < 3; i++) {
                snprintf(name, sizeof name, i == 1 ? "rms(%s)" : "mean(%s)", list[i].name);
                fourlink_results_value(r, name, FOURLINK_CROSSED, 0, &value);
                MUST(fourlink_results_find(r, name, &value) == FOURLINK_OK);
                MUST(value.handle == list[i].handle + (i == 1 ? FOURLINK_RMS : FOURLINK_MEAN));
            }
    }
}

static void ask_facts(fourlink_results *r)
{
    const fourlink_value *facts;
    fourlink_turning turning;
    unsigned long n, i;
    int b;

    MUST(fourlink_results_facts(r, 0, 7, &facts, &n) == FOURLINK_OK);
    for (i = 0; i < n; i++) {
        MUST(facts[i].name && facts[i].unit && facts[i].meaning);
        MUST(facts[i].words || !isnan(facts[i].value));
    }
    for (b = 0; b < 2; b++)
        if (fourlink_results_turning(r, branches[b], &turning) == FOURLINK_OK)
            MUST(isfinite(turning.mean_torque) && isfinite(turning.energy_fluctuation));
}

static void ask_checks(fourlink_results *r, const fourlink_problem *p)
{
    fourlink_check check;
    unsigned long i;

    for (i = 0; i < p->n_expected && i < 20; i++) {
        MUST(fourlink_results_check(r, i, &check) == FOURLINK_OK);
        MUST(check.verdict >= FOURLINK_AGREES && check.verdict <= FOURLINK_NO_VALUE);
        MUST(memchr(check.name, 0, sizeof check.name));
        MUST((check.verdict == FOURLINK_NO_VALUE) == (check.message[0] != '\0'));
    }
}

/* Rows by handles are those by number; where a column has the value of a row it has it at the row's angle too. */
static void ask_columns(fourlink_results *r, const fourlink_problem *p)
{
    const fourlink_value *columns;
    unsigned long n, found;
    double values[2 * MOST_COLUMNS], angles[4], angle;
    int handles[MOST_COLUMNS], b, status;

    fourlink_results_list(r, FOURLINK_COLUMNS, &columns, &n);
    for (found = 0; found < n; found++) {
        handles[found] = columns[found].handle;
        fourlink_results_meant(r, columns[found].name);
    }
    for (b = 0; b < 2; b++) {
        status = fourlink_results_rows(r, branches[b], 0, 2, n, handles, values);
        MUST((status == FOURLINK_NO_SUCH_ROW) == (p->n_rows < 2));
        if (n && status == FOURLINK_OK && isfinite(values[n]) && p->mode == FOURLINK_MODE_GIVEN)
            fourlink_results_crossings(r, columns[0].name, branches[b], values[n], 4, angles,
                                       &found);
        status = fourlink_results_end(r, branches[b], &angle);
        MUST(status < 20 && isfinite(angle));
    }
}

/* Set numbers: their own values, and others, with which the deck may have a mistake. */
static void ask_set(fourlink_results *r, const char *assignment)
{
    fourlink_mistake mistake;
    const fourlink_value *list;
    fourlink_value input;
    unsigned long n, i;
    double value;
    char name[200];
    int status;

    fourlink_results_list(r, FOURLINK_INPUTS, &list, &n);
    for (i = 0; i < n && i < 3; i++) {
        snprintf(name, sizeof name, "%s", list[i].name);
        status = fourlink_results_input(r, name, &input);
        if (status != FOURLINK_OK || isnan(input.value))
            continue;
        value = input.value;
        MUST(fourlink_results_put(r, 1, &input.handle, &value, &mistake) == FOURLINK_OK);
        status = fourlink_results_set(r, name, value * 1.25, &mistake);
        MUST(status == FOURLINK_OK || mistake.message[0]);
        fourlink_results_list(r, FOURLINK_INPUTS, &list, &n);
    }
    if (*assignment)
        fourlink_results_set_text(r, assignment, &mistake);
}

/* Names and units of the deck. */
static void ask_deck(const fourlink_deck *deck, const fourlink_problem *p)
{
    static const char *const quantities[] = {"length", "pressure", "number", "inertia", "?"};
    fourlink_vector at;
    fourlink_unit unit;
    fourlink_load_info load;
    fourlink_program_part part;
    const char *name;
    unsigned long i;
    int link;

    for (i = 0; i < p->n_points; i++)
        MUST(fourlink_deck_point(deck, i, &name, &link, &at) == FOURLINK_OK && *name);
    MUST(fourlink_deck_point(deck, i, &name, &link, &at) == FOURLINK_NO_SUCH_POINT);
    MUST(fourlink_deck_program(deck, 1, &part) == FOURLINK_NO_SUCH_POINT ||
         (part.end > part.begin && *part.law));
    for (i = 0; i < p->n_loads; i++)
        MUST(fourlink_deck_load(deck, i, &load) == FOURLINK_OK && *load.name && load.link >= 2 &&
             load.link <= 4 + 2 * p->mechanism.design.n_groups);
    MUST(fourlink_deck_load(deck, i, &load) == FOURLINK_BAD_LINK);
    for (i = 0; i < 5; i++)
        MUST((fourlink_deck_unit(deck, quantities[i], &unit) == FOURLINK_OK) == (i < 4));
}

/* A text by its pins has them, or says what the drawing lacks. */
static void ask_pins(const fourlink_deck *deck, part *card)
{
    fourlink_mistake mistakes[MOST_MISTAKES];
    unsigned long length = 0, n = 0;
    fourlink_problem again;
    fourlink_deck *other;
    char *words;

    if (fourlink_deck_write_pins(deck, 1, NULL, 0, &length) != FOURLINK_OK)
        return;
    words = malloc(length + 1);
    MUST(words && fourlink_deck_write_pins(deck, 1, words, length + 1, &length) == FOURLINK_OK);
    if (fourlink_deck_read(words, length, load, card, MOST_MISTAKES, &other, mistakes, &n) ==
        FOURLINK_OK) {
        fourlink_deck_problem(other, &again);
        MUST(again.has_drawn);
        fourlink_deck_free(other);
    } else {
        MUST(n);
    }
    free(words);
}

/* Its text is that of a deck again, with as many rows. */
static void ask_text(const fourlink_deck *deck, const fourlink_problem *p, part *card)
{
    fourlink_mistake mistakes[MOST_MISTAKES];
    fourlink_problem again;
    fourlink_deck *other;
    fourlink_spring spring;
    fourlink_friction friction;
    const char *name;
    unsigned long length, n;
    char *words;

    MUST(fourlink_deck_write(deck, NULL, 0, &length) == FOURLINK_OK);
    words = malloc(length + 1);
    MUST(words && fourlink_deck_write(deck, words, length + 1, &length) == FOURLINK_OK);
    MUST(fourlink_deck_read(words, length, load, card, MOST_MISTAKES, &other, mistakes, &n) ==
         FOURLINK_OK);
    fourlink_deck_problem(other, &again);
    MUST(again.n_rows == p->n_rows && again.n_loads == p->n_loads);
    for (n = 0; n < p->n_springs; n++)
        MUST(fourlink_deck_spring(other, n, &name, &spring) == FOURLINK_OK && *name);
    MUST(fourlink_deck_friction(other, &friction) == FOURLINK_OK);
    fourlink_deck_free(other);
    free(words);
    ask_pins(deck, card);
    MUST(fourlink_deck_defects(deck, MOST_MISTAKES, mistakes, &n) == FOURLINK_OK);
}

static void ask_design(fourlink_results *r)
{
    fourlink_results *other;
    const fourlink_value *list;
    fourlink_problem p;
    double *low, *high, *values;
    unsigned long n, chosen, found;
    int status;

    fourlink_deck_problem(fourlink_results_deck(r), &p);
    if (fourlink_deck_solutions(fourlink_results_deck(r), 0, NULL, &chosen, &found) != FOURLINK_OK)
        found = 0;
    status = fourlink_results_design(r, p.n_designs / 2, 0, &other, NULL, NULL);
    MUST((status == FOURLINK_BAD_NUMBER) == (!p.n_designs && !found));
    if (status == FOURLINK_OK)
        fourlink_results_free(other);
    fourlink_results_list(r, FOURLINK_VARIABLES, &list, &n);
    low = calloc(n + 1, sizeof *low);
    high = calloc(n + 1, sizeof *high);
    MUST(low && high);
    values = calloc(n + 1, sizeof *values);
    MUST(low && high && values);
    MUST((fourlink_results_variables(r, p.n_designs / 2, n, values, low, high) == FOURLINK_OK) ==
         (p.n_designs > 0));
    free(low);
    free(high);
    free(values);
}

static void ask_all(fourlink_results *r, part *card, const char *assignment)
{
    const fourlink_deck *deck = fourlink_results_deck(r);
    fourlink_mistake notes[MOST_MISTAKES];
    const fourlink_value *columns;
    unsigned long n_notes, n;
    fourlink_problem p;
    fourlink_load *loads;
    double *values;

    MUST(fourlink_deck_problem(deck, &p) == FOURLINK_OK);
    MUST(memchr(p.title, 0, sizeof p.title));
    MUST(fourlink_results_notes(r, MOST_MISTAKES, notes, &n_notes) == FOURLINK_OK);
    MUST(fourlink_results_slips(r, MOST_MISTAKES, notes, &n_notes) == FOURLINK_OK);
    ask_lists(r);
    ask_deck(deck, &p);
    ask_text(deck, &p, card);
    fourlink_results_list(r, FOURLINK_COLUMNS, &columns, &n);
    if (p.n_rows > MOST_ROWS || p.n_designs > MOST_DESIGNS || n > MOST_COLUMNS)
        return;
    values = calloc(n + 1, sizeof *values);
    loads = calloc(p.n_loads + 1, sizeof *loads);
    MUST(values && loads);
    ask_rows(r, &p, values, loads);
    ask_facts(r);
    ask_checks(r, &p);
    ask_columns(r, &p);
    if (p.mode == FOURLINK_MODE_GIVEN) /* another motion takes its time */
        ask_set(r, assignment);
    free(values);
    free(loads);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    part rest = {(const char *)data, size}, deck = take_part(&rest, '\f');
    part card = take_part(&rest, '\f'), answers = take_part(&rest, '\f');
    char *assignment = copy_part(rest);
    fourlink_mistake mistakes[MOST_MISTAKES];
    fourlink_change change = {"--set", assignment};
    fourlink_source source;
    fourlink_results *r = NULL;
    unsigned long n = 0, i;
    int status;

    memset(&source, 0, sizeof source);
    source.synthesis = 1;
    source.name = "x.deck";
    source.text = deck.text;
    source.length = (unsigned long)deck.length;
    source.load = load;
    source.host = &card;
    source.changes = &change;
    source.n_changes = rest.length ? 1 : 0;
    source.answers_name = "x.expect";
    source.answers = answers.length ? answers.text : NULL;
    source.answers_length = (unsigned long)answers.length;
    status = fourlink_results_open(&source, MOST_MISTAKES, &r, mistakes, &n);
    MUST(status == FOURLINK_OK || status == FOURLINK_BAD_DECK ||
         (status >= FOURLINK_DEPENDENT && status <= FOURLINK_NONE_FOUND));
    if (status != FOURLINK_OK)
        MUST(n > 0);
    for (i = 0; status && i < n && i < MOST_MISTAKES; i++) {
        MUST(memchr(mistakes[i].message, 0, sizeof mistakes[i].message));
        MUST(mistakes[i].message[0] && mistakes[i].line >= 0);
    }
    if (status == FOURLINK_OK) {
        ask_design(r);
        ask_all(r, &card, assignment);
    }
    fourlink_results_free(r);
    free(assignment);
    return 0;
}
