/* SPDX-License-Identifier: GPL-3.0-or-later
**
** owners.c - each line of the two tables of fourlink.h, who owns what and which calls may run at once, in strict
** C90 with threads of POSIX.  What the host passes in is overwritten and freed after the call, and what the
** library gives is read up to its end, so that a sanitizer sees what is not so.  Prints how many checks there
** were, and each that fails.
*/
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <fourlink.h>

#define THREADS 4
#define TURNS 40

static const char deck_text[] =
    "title = Owners\nmechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\n"
    "mass = 100 g\nuniform = yes\n[coupler]\nlength = 66 mm\nmass = 300 g\n[rocker]\n"
    "length = 56 mm\n[load T]\nlink = rocker\ntorque = file torque.txt\n[point P]\nlink = coupler\n"
    "at = (30, 10) mm\n[spring S]\nlink = rocker\nat = (40, 10) mm\nto = ground\n"
    "to_at = (100, 90) mm\nstiffness = 80 N/m\nfree_length = 50 mm\n"
    "[motion]\nspeed = 60 rpm\ninterval = 30 deg\n"
    "[expect]\nmu_min = 58 deg\n[sweep]\ncrank.length = 18 mm, 20 mm, 22 mm\noutput = max(Ts)\n";

static unsigned long checks, failures;

static void check(int holds, const char *what)
{
    checks++;
    failures += !holds;
    if (!holds)
        printf("FAILED: %s\n", what);
}

static char *copy_of(const char *words)
{
    return strcpy(malloc(strlen(words) + 1), words);
}

/* Overwrite and free what a call has been given. */
static void forget(char *words)
{
    memset(words, '?', strlen(words));
    free(words);
}

/* ----------------------------------------------------------------------------------- what is passed in */

/* A loader whose text is good until it is called again; the last one is the host's to free. */
static const char *load(void *host, const char *file_name, unsigned long *length)
{
    char **last = host;

    if (*last)
        forget(*last);
    *last = copy_of(strcmp(file_name, "torque.txt") == 0 ? "0 1\n180 2\n360 1\n" : "");
    *length = (unsigned long)strlen(*last);
    return *last;
}

/* Open the deck, or another text, by texts that do not outlive the call. */
static fourlink_results *open_text(const char *text, fourlink_results *like, int *status,
                                   fourlink_mistake *mistake)
{
    char *own = copy_of(text), *name = copy_of("owners.deck"), *last = NULL;
    char *origin = copy_of("host"), *words = copy_of("coupler.mass=200 g"), *units = copy_of("mm");
    fourlink_results *results = NULL;
    fourlink_source source;
    fourlink_change change;

    memset(&source, 0, sizeof source);
    change.origin = origin;
    change.assignment = words;
    source.name = name;
    source.text = own;
    source.length = (unsigned long)strlen(own);
    source.load = load;
    source.host = &last;
    source.changes = &change;
    source.n_changes = 1;
    source.units = units;
    *status = fourlink_results_open_like(&source, like, mistake != NULL, &results, mistake, NULL);
    forget(own);
    forget(name);
    forget(origin);
    forget(words);
    forget(units);
    if (last)
        forget(last);
    memset(&source, '?', sizeof source);
    memset(&change, '?', sizeof change);
    return results;
}

static fourlink_results *open_deck(void)
{
    int status;
    fourlink_results *results = open_text(deck_text, NULL, &status, NULL);

    check(status == FOURLINK_OK, fourlink_status_text(status));
    return results;
}

static double largest(fourlink_results *results)
{
    fourlink_value v;

    return fourlink_results_value(results, "max(Ts)", FOURLINK_OPEN, 0, &v) == FOURLINK_OK ? v.value
                                                                                           : -1;
}

static int is_close(double a, double b)
{
    return a - b < 1e-12 * b && b - a < 1e-12 * b;
}

/* ------------------------------------------------------------------------------------ who owns what */

/* Texts and lists of results, and a copy of the words in them. */
typedef struct belongings {
    const fourlink_value *lists[6], *facts;
    unsigned long n[6], n_facts, length;
    fourlink_value input, column;
    fourlink_check checked;
    const fourlink_deck *deck;
    const char *point, *spring;
    fourlink_load_info load;
    fourlink_unit unit;
    char words[20000];
} belongings;

static void add(char *words, const char *more)
{
    if (more && strlen(words) + strlen(more) < sizeof((belongings *)0)->words)
        strcat(words, more);
}

static void add_value(char *words, const fourlink_value *v)
{
    add(words, v->name);
    add(words, v->unit);
    add(words, v->meaning);
    add(words, v->words);
    add(words, v->line_unit);
}

/* All texts of belongings, one after the other. */
static void read_all(const belongings *b, char *words)
{
    unsigned long i;
    int k;

    *words = '\0';
    for (k = 0; k < 6; k++)
        for (i = 0; i < b->n[k]; i++)
            add_value(words, &b->lists[k][i]);
    for (i = 0; i < b->n_facts; i++)
        add_value(words, &b->facts[i]);
    add_value(words, &b->input);
    add_value(words, &b->column);
    add(words, b->checked.file);
    add(words, b->checked.unit);
    add(words, b->point);
    add(words, b->spring);
    add(words, b->load.name);
    add(words, b->unit.name);
}

static void take_all(fourlink_results *results, belongings *b)
{
    fourlink_vector at;
    fourlink_spring spring;
    int k, link, status = 0;

    memset(b, 0, sizeof *b);
    for (k = 0; k < 6; k++)
        status |= fourlink_results_list(results, k + 1, &b->lists[k], &b->n[k]);
    status |= fourlink_results_facts(results, 0, 3, &b->facts, &b->n_facts);
    status |= fourlink_results_input(results, "crank.length", &b->input);
    status |= fourlink_results_find(results, "min(P.x)", &b->column);
    status |= fourlink_results_check(results, 0, &b->checked);
    b->deck = fourlink_results_deck(results);
    status |= fourlink_deck_point(b->deck, 0, &b->point, &link, &at);
    status |= fourlink_deck_spring(b->deck, 0, &b->spring, &spring);
    status |= fourlink_deck_load(b->deck, 0, &b->load);
    status |= fourlink_deck_unit(b->deck, "length", &b->unit);
    check(status == FOURLINK_OK, "lists, facts and names of a deck");
    read_all(b, b->words);
}

/* Belongings stay until a number is set or the results are freed, whatever else is asked; not so the list of
** facts. */
static void try_belongings(void)
{
    static belongings b;
    static char words[sizeof b.words], deck[2000];
    fourlink_results *results = open_deck(), *other = open_deck();
    fourlink_mistake mistake;
    fourlink_problem problem;
    fourlink_value v;
    const fourlink_value *list;
    unsigned long n;

    take_all(results, &b);
    check(strlen(b.words) > 2000, "there are texts");
    fourlink_results_set(other, "crank.length", 22, NULL);
    fourlink_results_free(other);
    largest(results);
    fourlink_results_list(results, FOURLINK_INPUTS, &list, &n);
    fourlink_results_value(results, "rocker.length", FOURLINK_OPEN, 0, &v);
    fourlink_deck_write(b.deck, deck, sizeof deck, &n);
    check(fourlink_results_set(results, "ground.length", 800, &mistake) == FOURLINK_BAD_DECK,
          "a number that is no mechanism");
    read_all(&b, words);
    check(strcmp(words, b.words) == 0, "texts stay after other calls, and after a set that fails");
    fourlink_results_facts(results, FOURLINK_OPEN, FOURLINK_FACTS_EXTREMES, &b.facts, &b.n_facts);
    read_all(&b, words);
    check(strcmp(words, b.words) != 0, "facts are those of the last call");
    fourlink_deck_problem(b.deck, &problem);
    fourlink_results_free(results);
    check(strcmp(problem.title, "Owners") == 0 && problem.n_rows == 13,
          "a structure outlives the results");
    check(strstr(mistake.message, "assembled") != NULL, "a mistake outlives the results");
}

static void try_handles(void)
{
    fourlink_results *results = open_deck(), *design = NULL;
    fourlink_value found, v, w;

    fourlink_results_find(results, "max(Ts)", &found);
    fourlink_results_set(results, "crank.length", 22, NULL);
    check(fourlink_results_get(results, found.handle, FOURLINK_OPEN, 0, &v) == FOURLINK_OK &&
              is_close(v.value, largest(results)),
          "a handle is valid after a number is set");
    fourlink_results_design(results, 2, 0, &design, NULL, NULL);
    check(fourlink_results_get(design, found.handle, FOURLINK_OPEN, 0, &w) == FOURLINK_OK &&
              is_close(w.value, v.value),
          "a handle is valid in another design");
    fourlink_results_free(design);
    fourlink_results_free(results);
}

/* Designs and decks opened like another are freed before it; a number set there is not set in a design. */
static void try_origins(void)
{
    fourlink_results *results = open_deck(), *design = NULL, *like;
    fourlink_value v;
    double first;
    int status;

    first = largest(results);
    like = open_text(deck_text, results, &status, NULL);
    check(status == FOURLINK_OK && is_close(largest(like), first), "a deck like another");
    fourlink_results_free(like);
    fourlink_results_set(results, "rocker.length", 58, NULL);
    fourlink_results_design(results, 0, 0, &design, NULL, NULL);
    check(fourlink_results_value(design, "rocker.length", FOURLINK_OPEN, 0, &v) == FOURLINK_OK &&
              is_close(v.value, 56),
          "a number set is not set in a design");
    fourlink_results_set(results, "rocker.length", 57, NULL);
    check(is_close(largest(design), first), "a design does not follow what is set");
    fourlink_results_set(design, "rocker.length", 57, NULL);
    fourlink_results_free(design);
    fourlink_results_free(results);
    fourlink_results_free(NULL);
}

/* Outputs are untouched on errors; a deck with mistakes leaves nothing to free. */
static void try_mistakes(void)
{
    fourlink_mistake mistake;
    fourlink_results *results;
    int status;

    results =
        open_text("mechanism = four-bar\n[coupler]\nlength = 1 parsec\n", NULL, &status, &mistake);
    check(status == FOURLINK_BAD_DECK && !results && mistake.line == 3, "a deck with mistakes");
    check(strcmp(fourlink_status_text(FOURLINK_NULL), "a null pointer was passed") == 0 &&
              strcmp(fourlink_branch_text(FOURLINK_OPEN), "open") == 0 &&
              strcmp(fourlink_version(), FOURLINK_VERSION) == 0,
          "constants");
}

static void try_deck(void)
{
    char *text = copy_of(deck_text), *last = NULL;
    fourlink_deck *deck = NULL;
    const char *name;
    fourlink_vector at;
    int link;

    check(fourlink_deck_read(text, (unsigned long)strlen(text), load, &last, 0, &deck, NULL,
                             NULL) == FOURLINK_OK,
          "a deck");
    forget(text);
    forget(last);
    fourlink_deck_point(deck, 0, &name, &link, &at);
    check(strcmp(name, "P") == 0, "the name of a point belongs to the deck");
    fourlink_deck_free(deck);
    fourlink_deck_free(NULL);
}

/* -------------------------------------------------------------------------------- what may run at once */

/* What threads share, and what each found. */
typedef struct job {
    const fourlink_results *shared;
    const fourlink_deck *deck;
    const fourlink_mechanism *mechanism;
    fourlink_results *own; /* a design of `shared`, opened before */
    int number, good;
} job;

/* Run a function in all threads; the sum of what they found to be good. */
static int run(void *(*work)(void *job), job *jobs)
{
    pthread_t threads[THREADS];
    int i, good = 0;

    for (i = 0; i < THREADS; i++) {
        jobs[i].number = i;
        jobs[i].good = 0;
        pthread_create(&threads[i], NULL, work, &jobs[i]);
    }
    for (i = 0; i < THREADS; i++) {
        pthread_join(threads[i], NULL);
        good += jobs[i].good;
    }
    return good;
}

/* All calls on results of its own. */
static void *work_apart(void *data)
{
    job *j = data;
    int i, status;

    for (i = 0; i < TURNS / 4; i++) {
        fourlink_results *results = open_text(deck_text, NULL, &status, NULL);
        const fourlink_value *facts;
        unsigned long n;
        double before = largest(results);

        fourlink_results_set(results, "crank.length", 18 + j->number, NULL);
        fourlink_results_facts(results, 0, 7, &facts, &n);
        fourlink_results_set(results, "crank.length", 18, NULL);
        j->good += is_close(largest(results), before);
        fourlink_results_free(results);
    }
    return NULL;
}

/* What takes the same results or deck as const. */
static void *work_on_const(void *data)
{
    static const char *const quantities[] = {"length", "force", "torque", "angle"};
    job *j = data;
    int i;

    for (i = 0; i < TURNS; i++) {
        fourlink_results *design = NULL;
        double values[1], number;
        unsigned long n;
        fourlink_problem problem;
        fourlink_unit unit;
        char text[2000];
        int status = fourlink_results_design(j->shared, (unsigned long)(j->number + i) % 3, 0,
                                             &design, NULL, NULL);

        status |= fourlink_results_variables(j->shared, 1, 1, values, NULL, NULL);
        status |= fourlink_results_notes(j->shared, 0, NULL, &n);
        status |= fourlink_results_slips(j->shared, 0, NULL, &n);
        status |= fourlink_deck_problem(j->deck, &problem);
        status |= fourlink_deck_write(j->deck, text, sizeof text, &n);
        status |= fourlink_deck_unit(j->deck, quantities[i % 4], &unit);
        status |= fourlink_deck_quantity(j->deck, "length", "1 in", &number, NULL);
        status |= fourlink_results_deck(j->shared) != j->deck;
        j->good += status == FOURLINK_OK && fourlink_results_meant(j->shared, "torque") &&
                   largest(design) > 0 && values[0] == 20 && is_close(number, 25.4);
        fourlink_results_free(design);
    }
    return NULL;
}

/* All calls on designs of the same results, while numbers of these are set. */
static void *work_on_designs(void *data)
{
    job *j = data;
    int i;

    for (i = 0; i < TURNS; i++) {
        double length = 18 + 2 * (i % 3);

        j->good += fourlink_results_set(j->own, "crank.length", length, NULL) == FOURLINK_OK &&
                   largest(j->own) > 0;
    }
    return NULL;
}

static void *work_on_structures(void *data)
{
    job *j = data;
    int i;

    for (i = 0; i < TURNS; i++) {
        fourlink_crank crank = {0.7, 10.5, 0};
        fourlink_state state;
        fourlink_forces forces;

        j->good += fourlink_analyse(j->mechanism, FOURLINK_OPEN, &crank, NULL, 0, &state,
                                    &forces) == FOURLINK_OK;
    }
    return NULL;
}

static void try_threads(void)
{
    fourlink_results *results = open_deck();
    fourlink_problem problem;
    job jobs[THREADS];
    int i;

    memset(jobs, 0, sizeof jobs);
    fourlink_deck_problem(fourlink_results_deck(results), &problem);
    for (i = 0; i < THREADS; i++) {
        jobs[i].shared = results;
        jobs[i].deck = fourlink_results_deck(results);
        jobs[i].mechanism = &problem.mechanism;
    }
    check(run(work_apart, jobs) == THREADS * (TURNS / 4), "all calls on different results");
    check(run(work_on_const, jobs) == THREADS * TURNS, "const calls on the same results");
    check(run(work_on_structures, jobs) == THREADS * TURNS, "const structures");
    jobs[0].own = results;
    for (i = 1; i < THREADS; i++)
        fourlink_results_design(results, (unsigned long)i - 1, 0, &jobs[i].own, NULL, NULL);
    check(run(work_on_designs, jobs) == THREADS * TURNS,
          "all calls on designs of the same results");
    for (i = 1; i < THREADS; i++)
        fourlink_results_free(jobs[i].own);
    fourlink_results_free(results);
}

int main(void)
{
    try_belongings();
    try_handles();
    try_origins();
    try_mistakes();
    try_deck();
    try_threads();
    printf("%lu checks, %lu failed\n", checks, failures);
    return failures > 0;
}
