/* SPDX-License-Identifier: GPL-3.0-or-later
**
** brute_decks.h - the decks of brute_extremes and brute_crossings.
**
**    PROGRAM DECKS [SEED [FIRST]]    random ones, each from its own number; of seeds from 1000, Scotch yokes alone
**    PROGRAM FILE [CHANCE]...        files, each with what chance goes on from after it
**
** Random decks that fail are left as NAME-SEED-NUMBER.deck, and how to try such a file again is printed.
*/
#ifndef BRUTE_DECKS_H
#define BRUTE_DECKS_H

#include "fourlink.h"
#include "random_schema.h"

#define SEED_OF_YOKES 1000

static const char *deck_name;
static int deck_failed;
static long n_decks, n_refused, n_failed_decks;
static double corners[1000]; /* rad; where something happens, in every cycle */
static int n_corners;

static void (*change_deck)(void); /* if not null, makes another deck of deck_text */

static void read_deck(void)
{
    FILE *in = fopen(deck_name, "r");

    length = in ? fread(deck_text, 1, sizeof deck_text - 1, in) : 0;
    if (!in || !feof(in)) {
        fprintf(stderr, "cannot read %s\n", deck_name);
        exit(3);
    }
    fclose(in);
}

/* Quadrants, and the crank angles of loads and of the gas: all angles in their sections. */
static void find_corners(void)
{
    static const struct {
        const char *name;
        double rad;
    } units[] = {{"deg", PI / 180}, {"rad", 1}, {"rev", 2 * PI}};
    int is_there = 0;
    const char *at, *begin;
    size_t i;

    for (n_corners = 0; n_corners < 4; n_corners++)
        corners[n_corners] = n_corners * PI / 2;
    for (at = deck_text; *at; at++) {
        if (at[0] == '\n' && at[1] == '[')
            is_there = strncmp(at, "\n[load", 6) == 0 || strncmp(at, "\n[gas", 5) == 0;
        for (i = 0; is_there && i < 3; i++) {
            if (at[0] != ' ' || strncmp(at + 1, units[i].name, 3) != 0 || at[4] == '/' ||
                n_corners == 1000)
                continue;
            for (begin = at; strchr("0123456789.-+e", begin[-1]); begin--)
                ;
            corners[n_corners++] = strtod(begin, NULL) * units[i].rad;
        }
    }
}

/* 1 if a number grows beyond all bounds in some row: a load with an exponent of hundreds. */
static int overflows(fourlink_results *r, unsigned long n_rows)
{
    static double v[1000];
    unsigned long i;

    for (i = 0; i < 2 * n_rows; i++)
        if (fourlink_results_row(r, i % 2 ? FOURLINK_OPEN : FOURLINK_CROSSED, i / 2, v, NULL,
                                 NULL) == FOURLINK_BAD_NUMBER)
            return 1;
    return 0;
}

/* With all columns; null for a deck with mistakes, one of an instant, or one that overflows. */
static fourlink_results *open_deck(unsigned long most_columns)
{
    static const fourlink_change all = {"all columns", "table.columns=all"};
    const fourlink_value *columns;
    fourlink_results *r = NULL;
    fourlink_mistake mistake;
    fourlink_problem problem;
    fourlink_source source;
    unsigned long n = 0;

    memset(&source, 0, sizeof source);
    source.name = deck_name;
    source.text = deck_text;
    source.length = length;
    source.load = load_card;
    source.changes = &all;
    source.n_changes = 1;
    if (fourlink_results_open(&source, 1, &r, &mistake, NULL) != FOURLINK_OK) {
        if (getenv("BRUTE_VERBOSE"))
            printf("%s: %s\n", deck_name, mistake.message);
        return NULL;
    }
    fourlink_results_list(r, FOURLINK_COLUMNS, &columns, &n);
    fourlink_deck_problem(fourlink_results_deck(r), &problem);
    if (n <= most_columns && problem.n_rows > 1 && !overflows(r, problem.n_rows))
        return r;
    fourlink_results_free(r);
    return NULL;
}

static void try_one(unsigned long most_columns, void (*try)(fourlink_results *))
{
    unsigned long long state = chance_state;
    fourlink_results *r;

    n_decks++;
    deck_failed = 0;
    deck_text[length] = '\0';
    if (change_deck)
        change_deck();
    find_corners();
    r = open_deck(most_columns);
    if (!r) {
        n_refused++;
        return;
    }
    try(r);
    fourlink_results_free(r);
    if (!deck_failed)
        return;
    n_failed_decks++;
    printf("again: %s %llu\n", deck_name, state);
}

static int is_number(const char *word)
{
    return word && *word && word[strspn(word, "0123456789")] == '\0';
}

/* All decks of the command line; 1 if none could be tried, or a file could not. */
static int try_decks(int argc, char **argv, const char *name, unsigned long most_columns,
                     void (*try)(fourlink_results *))
{
    long decks = argc > 1 ? atol(argv[1]) : 100, seed = argc > 2 ? atol(argv[2]) : 1;
    long first = argc > 3 ? atol(argv[3]) : 0, i;
    char left[100];

    if (argc > 1 && !is_number(argv[1])) {
        for (i = 1; i < argc; i++) {
            deck_name = argv[i];
            read_deck();
            begin_chance(1, 0);
            if (is_number(argv[i + 1]))
                chance_state = strtoull(argv[++i], NULL, 10);
            try_one(most_columns, try);
        }
        return n_refused > 0;
    }
    for (i = first; i < first + decks; i++) {
        snprintf(left, sizeof left, "%s-%ld-%ld.deck", name, seed, i);
        deck_name = left;
        begin_chance(seed, i);
        make_wild_deck(seed >= SEED_OF_YOKES ? 4 * i + 3 : i); /* every fourth is a yoke */
        try_one(most_columns, try);
        if (deck_failed)
            leave_deck(left);
    }
    return n_refused == n_decks;
}

#endif
