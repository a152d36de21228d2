/* SPDX-License-Identifier: GPL-3.0-or-later
**
** rules.c - what goes together on a command line, and what a deck must have for it: a table.
**
** An option that would do nothing beside the others is refused; the message names both.
*/
#include <string.h>

#include "base/message.h"
#include "rules.h"

/* Each of the options `of`, or other words, needs one of `needs`, and does not go with any of `never`.
** These are lists as they stand in a message, "--plot, --report or a table of rows", of
**
**    --NAME         an option
**    --NAME=value   the option with this value; --NAME=FILE.txt: with a value that ends in .txt
**    other words    what is known of all options or of the deck: find_facts
**
** `why` ends the message, null: nothing does; where `of` is no option, it is the message. */
typedef struct rule {
    const char *of, *needs, *never, *why;
} rule;

#define CHECKS "--check, --answers, --scores, --feedback"
#define FORMS "--expect, --form"
#define TEXTS "--summary, --matrix, --list, " CHECKS ", " FORMS
#define PICTURES "--plot, --report"
#define A_SWEEP "a [sweep]"
#define OF_ONE_DESIGN "take one design with --design=N"
#define NO_TABLE "it prints a deck and nothing else"

static const rule table[] = {
    /* what is printed: one of these */
    {"--summary", NULL, "--matrix, --list, " CHECKS ", " FORMS, "use only one of them"},
    {"--matrix", NULL, "--list, " CHECKS ", " FORMS, "use only one of them"},
    {"--list", NULL, CHECKS ", " FORMS, "use only one of them"},
    {CHECKS, NULL, FORMS, "use only one of them"},
    {"--expect", NULL, "--form", "use only one of them"},
    {"--answers", NULL, "--check=FILE", "both name answers"},
    {"--answers", NULL, "several decks", "for a deck of each student give --check=FOLDER"},
    {"--answers", NULL, PICTURES, "it prints scores"},
    {PICTURES, NULL, "--check=FOLDER of a class", "it prints scores"},
    {"--import", NULL, "several decks", "its file is the deck"},
    {"--import", NULL, "--print-deck, --solve, --synthesis, --design", NO_TABLE},
    {"--quiz", NULL,
     TEXTS ", --print-deck, --import, --solve, --best, --synthesis, --design, --part, " PICTURES
           ", --format, --output, --at, several decks",
     "it writes a quiz and nothing else"},
    {"--print-deck, --import", NULL,
     TEXTS ", --part, " PICTURES ", --format, --at, --best, several decks", NO_TABLE},
    {"--best", NULL, TEXTS ", --part, --design, " PICTURES ", --format=paper, --at",
     "it prints the best design, as a deck or a line"},
    {"--solve", NULL, TEXTS ", --part, " PICTURES ", --best, --at, --format=paper",
     "it prints lines of its solutions"},
    {"--expect, --form, --synthesis, --plot, --report, --part", NULL, "several decks",
     "it takes one deck"},

    /* a file for each design */
    {"--design=all", "--output=FOLDER/, --report=FOLDER/ or --plot=FOLDER/", NULL, NULL},
    {"--output=FOLDER/", "--print-deck, --expect or --form", NULL, NULL},
    {"--output=FOLDER/, --report=FOLDER/, --plot=FOLDER/", "--design=all", NULL, NULL},
    {"--design=all", NULL, "--report=FILE.html, --report=FILE.htm, --report=FILE.pdf",
     "it needs --report=FOLDER/"},
    {"--design=all", NULL,
     "--plot=FILE.svg, --plot=FILE.png, --plot=FILE.pdf, --plot=FILE.txt, --plot=-",
     "it needs --plot=FOLDER/"},
    {"--plot=FOLDER/, --report=FOLDER/", NULL, "--output, " FORMS,
     "one file is written for each design"},
    {"--plot=FOLDER/", NULL, "--report", "one file is written for each design"},
    {"--design=all", NULL, "--summary, --matrix, --list, " CHECKS ", --solve, --format",
     "it writes one file for each design"},
    {"--design=all", NULL, "standard input", "it reads the deck for each design"},
    {"--names", "--design=all, --answers, --scores or --feedback", NULL, NULL},
    {"--exercise", "--scores or --feedback", NULL, NULL},
    {"--format=html", "--feedback", NULL, NULL},

    /* what changes it */
    {"--at", "a table of rows, --expect or a form without [expect]", "--format=paper, " PICTURES,
     "it chooses rows; pictures and reports have --plot-at"},
    {"--interval",
     "a table of rows, a printed deck, --summary, --matrix, --expect, a form without [expect] or "
     "--report",
     "--at, a deck of one instant", NULL},
    {"--columns",
     "a table of columns, a printed deck, --summary, --expect, a form without [expect], --report "
     "or a picture of columns",
     NULL, NULL},
    {"--tolerance", CHECKS ", --expect, --quiz, a printed deck or a report with [expect]", NULL,
     NULL},
    {"--branch", NULL, "--list alone", "it has both branches"},
    {"--branch", NULL, "--synthesis", "each solution has its branch"},
    {"--units", NULL, "--print-deck, --import, --synthesis alone",
     "a deck keeps the units of its lines"},
    {"--units", NULL, "--format=paper alone", "it has units of its own"},
    {"--plot-kind", "--plot", NULL, NULL},
    {"--plot-at", "--plot, --report or --pins", NULL, NULL},
    {"--pins", "--print-deck", "--solve", "print the deck that it finds first"},
    {"--plot-x", "--plot-kind=columns", NULL, NULL},
    {"--ascii", "--plot=FILE.txt or --plot=-", NULL, NULL},
    {"--solution", "--synthesis", "a list of solutions alone", NULL},
    {"--effort", "--synthesis", NULL, NULL},
    {"--effort", "a search from many starts", NULL, NULL},
    {"--part", NULL, "--design, --list", "it is a part of the [sweep]"},

    /* what the deck must have */
    {"--part, --design", A_SWEEP, NULL, NULL},
    {"--quiz", "an [expect]", NULL, NULL},
    {"--synthesis", "a [synthesis]", NULL, NULL},
    {"--matrix", "masses or loads", NULL, NULL},
    {"--format=paper", NULL, "links that slide", "it is for a four-bar"},
    {"--columns of values", NULL, "--expect, --form, --summary, --report, a picture of columns",
     "it takes columns of rows, not values of the deck"},
    {"--format=paper", NULL, "a whole [sweep], values of the deck",
     "these are printed as table, csv or json"},
    {"--solve", NULL, "a whole [sweep]", OF_ONE_DESIGN},
    {"--print-deck, " FORMS, NULL, "a whole [sweep]",
     OF_ONE_DESIGN ", or all of them with --design=all"},
    {"several decks", NULL, "rows of a [sweep]",
     "of several decks a [sweep] has to have values, by output or --columns='max(Ts), "
     "crank.length'"},
    {"--summary, --matrix, " CHECKS, NULL, "a whole [sweep]", OF_ONE_DESIGN}};

/* ------------------------------------------------------------------------------------------- facts */

#define UNKNOWN 2 /* until the deck has been read */
#define MOST_FACTS 32

typedef struct fact {
    const char *words;
    int holds;
} fact;

/* What is known. */
typedef struct known {
    const options *o;
    const rules_deck *deck; /* null: not read yet */
    fact facts[MOST_FACTS];
    int n;
} known;

static void add(known *k, const char *words, int holds)
{
    k->facts[k->n].words = words;
    k->facts[k->n++].holds = holds;
}

/* Add a fact that needs something of the options and something of the deck. */
static void add_of_deck(known *k, const char *words, int of_options, int of_deck)
{
    add(k, words, !of_options ? 0 : k->deck ? of_deck : UNKNOWN);
}

/* Find all facts; `d` is of zeros if the deck has not been read. */
static void find_facts(known *k, const rules_deck *d)
{
    const options *o = k->o;
    const fourlink_problem *p = &d->problem;
    int kind = (int)p->mechanism.design.kind, is_sweep = p->n_designs > 0;
    int is_plain = o->content == SHEET_ROWS && options_want_table(o);
    int is_sheet = is_plain && !o->print_deck && !o->best && !o->solve && !o->quiz;
    int finds = is_sheet && o->synthesis && !o->at; /* a linkage, or a list of them */
    int columns = is_sheet && !finds;
    int has_outputs = is_sweep && p->has_outputs;
    int is_paper = o->format == &paper_format, has_picture = o->plot || o->report;

    add(k, "several decks", o->n_decks > 1);
    add(k, "--check=FOLDER of a class", o->is_class);
    add(k, "standard input", strcmp(o->decks[0], "-") == 0);
    add(k, "--list alone", o->content == SHEET_LIST && !has_picture);
    add(k, "--format=paper alone", is_paper && !has_picture);
    add_of_deck(k, "--synthesis alone", finds && !o->has_format && !has_picture, !is_sweep);
    add_of_deck(k, "a list of solutions alone", finds && !has_picture, o->has_format || is_sweep);
    if (o->print_deck || (o->best && !o->has_format && o->n_decks < 2))
        add(k, "a printed deck", 1);
    else
        add_of_deck(k, "a printed deck", finds && !o->has_format, !is_sweep);
    add_of_deck(k, "a table of columns", columns && !is_paper, p->has_values || !has_outputs);
    add_of_deck(k, "a table of rows", columns, !has_outputs && !d->has_values);
    add_of_deck(k, "a picture of columns", o->plot && o->drawing.kind == PLOT_COLUMNS,
                p->has_values || !has_outputs);
    add_of_deck(k, "--columns of values", options_given(o, flk_text_of("--columns")) != NULL,
                p->has_values && !is_sweep);
    add_of_deck(k, "a form without [expect]", o->form, !p->n_expected);
    add_of_deck(k, "an [expect]", 1, p->n_expected > 0);
    add_of_deck(k, "a report with [expect]", o->report != NULL, p->n_expected > 0);
    add_of_deck(k, "a deck of one instant", 1, p->one_instant);
    add_of_deck(k, A_SWEEP, 1, d->has_sweep);
    add_of_deck(k, "a whole [sweep]", !o->all_designs, is_sweep);
    add_of_deck(k, "rows of a [sweep]", 1, is_sweep && !d->has_values);
    add_of_deck(k, "a [synthesis]", 1, d->has_task);
    add_of_deck(k, "a search from many starts", 1, d->has_starts);
    add_of_deck(k, "masses", 1, p->has_forces);
    add_of_deck(k, "loads", 1, p->has_forces);
    add_of_deck(k, "links that slide", 1,
                fourlink_slides(kind, FOURLINK_COUPLER) ||
                    fourlink_slides(kind, FOURLINK_FOLLOWER));
    add_of_deck(k, "values of the deck", 1, d->has_values);
}

/* 1 if an option has a value as in a list: itself, or FILE.txt, whose capitals stand for anything. */
static int is_like(const char *value, text pattern)
{
    size_t n = 0;

    while (n < pattern.length && pattern.start[n] >= 'A' && pattern.start[n] <= 'Z')
        n++;
    if (!n)
        return flk_text_same(pattern, value);
    pattern = flk_text_from(pattern, n);
    return strlen(value) > pattern.length &&
           memcmp(value + strlen(value) - pattern.length, pattern.start, pattern.length) == 0;
}

/* Whether an option of a list was given, or whether a fact holds: 1, 0 or UNKNOWN. */
static int holds(const known *k, text words)
{
    text name = words, value;
    const char *given;
    int i;

    value.start = NULL;
    for (i = 0; i < k->n; i++)
        if (flk_text_same(words, k->facts[i].words))
            return k->facts[i].holds;
    flk_text_cut(words, "=", &name, &value);
    given = options_given(k->o, name);
    return given && (!value.start || is_like(given, value));
}

/* ------------------------------------------------------------------------------------------- lists */

/* Take the next words off a list; 0 if nothing is left. */
static int next(text *list, text *words)
{
    *words = *list;
    if (!list->length)
        return 0;
    if (!flk_text_cut(*words, ", ", words, list) && !flk_text_cut(*words, " or ", words, list))
        list->length = 0;
    return 1;
}

/* The first of a list that holds, from the words that were taken on; 0 if none does. */
static int find(const known *k, text *list, text *found)
{
    while (next(list, found))
        if (holds(k, *found) == 1)
            return 1;
    return 0;
}

/* 1 if something of a list holds, or may hold. */
static int has_one(const known *k, const char *list)
{
    text rest = flk_text_of(list), words;

    while (next(&rest, &words))
        if (holds(k, words))
            return 1;
    return 0;
}

/* ---------------------------------------------------------------------------------------- messages */

/* What is printed or drawn, for a message. */
#define OUTPUTS \
    "--format=paper, " TEXTS ", --quiz, --print-deck, --best, --solve, --synthesis, " PICTURES

/* Why nothing of a list holds that would but for the deck. */
static const char *why_not(const known *k)
{
    const fourlink_problem *p = k->deck ? &k->deck->problem : NULL;

    return !p                                ? ""
           : k->o->form && p->n_expected     ? "; --form has what the [expect] asks"
           : k->deck->has_values             ? "; the columns are values of the deck"
           : p->n_designs && k->o->synthesis ? "; each design is a line"
           : p->n_designs && p->has_outputs
               ? "; the [sweep] prints its outputs: without 'output', or "
                 "with --design=N, it prints rows"
               : "; the deck has none";
}

/* 1 if an option, or one with a value, has this name. */
static int is_named(text option, text name)
{
    return option.length >= name.length && memcmp(option.start, name.start, name.length) == 0 &&
           (option.length == name.length || option.start[name.length] == '=');
}

/* Say that an option lacks something. */
static const char *tell_lack(const known *k, text of, const char *needs, char message[400])
{
    text outputs = flk_text_of(OUTPUTS), with;
    char option[80], other[80];

    flk_text_copy(of, option, sizeof option);
    if (!k->deck && find(k, &outputs, &with) && !is_named(of, with))
        return flk_message(message, 400, "%s does nothing with %s: it needs %s", option,
                           flk_text_copy(with, other, sizeof other), needs);
    return flk_message(message, 400, "%s needs %s%s", option, needs, why_not(k));
}

static const char *tell_clash(text of, text with, const char *why, char message[400])
{
    char option[80], other[80];

    if (of.start[0] != '-')
        return flk_message(message, 400, "%s", why);
    return flk_message(message, 400, why ? "%s does not go with %s: %s" : "%s does not go with %s",
                       flk_text_copy(of, option, sizeof option),
                       flk_text_copy(with, other, sizeof other), why);
}

/* Why a rule is broken by one of its options; null: it is not. */
static const char *broken(const known *k, const rule *r, char message[400])
{
    text rest = flk_text_of(r->of), of, with;

    while (find(k, &rest, &of)) {
        text never = flk_text_of(r->never ? r->never : "");

        if (find(k, &never, &with))
            return tell_clash(of, with, r->why, message);
        if (r->needs && !has_one(k, r->needs))
            return tell_lack(k, of, r->needs, message);
    }
    return NULL;
}

/* The first rule that is broken, of those with these needs, or for null of all. */
static const char *find_broken(const options *o, const rules_deck *deck, const char *needs,
                               char message[400])
{
    rules_deck none;
    const char *why = NULL;
    known k;
    size_t i;

    memset(&none, 0, sizeof none);
    memset(&k, 0, sizeof k);
    k.o = o;
    k.deck = deck;
    find_facts(&k, deck ? deck : &none);
    for (i = 0; i < sizeof table / sizeof *table && !why; i++)
        if (!needs || (table[i].needs && strcmp(table[i].needs, needs) == 0))
            why = broken(&k, &table[i], message);
    return why;
}

const char *rules_broken(const options *o, const rules_deck *deck, char message[400])
{
    return find_broken(o, deck, NULL, message);
}

const char *rules_without_sweep(const options *o, char message[400])
{
    rules_deck without;

    memset(&without, 0, sizeof without);
    return find_broken(o, &without, A_SWEEP, message);
}
