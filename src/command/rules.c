/* SPDX-License-Identifier: GPL-3.0-or-later
**
** rules.c - what does not go together on a command line, and what a deck must have for it: a table.
*/
#include <string.h>

#include "rules.h"

/* What is asked for. */
enum {
    CHECK = 1 << 0,
    SUMMARY = 1 << 1,
    MATRIX = 1 << 2,
    LIST = 1 << 3,
    EXPECT = 1 << 4,
    ONE_OF = 1 << 5, /* several of these five */
    AT = 1 << 6,
    ANSWERS = 1 << 7,
    BEST = 1 << 8,
    SOLVE = 1 << 9,
    PRINT = 1 << 10,     /* --print-deck */
    PRINT_ONE = 1 << 11, /* the same, not of all designs */
    PART = 1 << 12,
    DESIGN = 1 << 13, /* one design */
    ALL = 1 << 14,    /* all of them, a file each */
    NAMES = 1 << 15,
    SYNTHESIS = 1 << 16,
    SOLUTION = 1 << 17,
    PLOT = 1 << 18,
    AT_OF_PLOT = 1 << 19,
    X_OF_PLOT = 1 << 20,
    KIND_OF_PLOT = 1 << 21,
    REPORT = 1 << 22,
    REPORTS = 1 << 23, /* to a folder */
    FILES = 1 << 24,   /* one file for each design can be written */
    BOTH = 1 << 25,    /* answers and reports for all designs */
    PIPE = 1 << 26,    /* the deck is standard input */
    SEVERAL = 1 << 27, /* decks */
    CSV = 1 << 28,
    JSON = 1 << 29,
    PAPER = 1 << 30
};

/* What a deck has. */
enum {
    FORCES = 1 << 0,
    SLIDE = 1 << 1, /* two links slide on each other */
    SWEEP = 1 << 2,
    TAKEN = 1 << 3,         /* a design of a [sweep] was taken from it */
    ROWS_OF_SWEEP = 1 << 6, /* that are no values */
    TASK = 1 << 4,          /* its linkage was found for a [synthesis] */
    VALUES = 1 << 5         /* columns that are values of the deck, and are printed */
};

#define CONTENT (CHECK | SUMMARY | MATRIX | LIST | EXPECT)
#define PICTURE (PLOT | REPORT)
#define FORMAT (CSV | JSON | PAPER)

/* Any of `what` together with any of `with`, or without any of `needs`, is a mistake. */
typedef struct rule {
    long what, with, needs;
    const char *why;
} rule;

/* The first that applies is told.  `with` and `needs` are asked for too. */
static const rule of_options[] = {
    {ONE_OF, ONE_OF, 0, "use only one of --check, --expect, --summary, --matrix and --list"},
    {AT, CHECK | SUMMARY | MATRIX | LIST | PICTURE | PAPER, 0,
     "--at chooses rows of a table, csv, json or --expect"},
    {ANSWERS, SEVERAL, 0,
     "--answers takes one deck; for a deck of each student give --check=FOLDER"},
    {ANSWERS, PICTURE, 0, "--answers prints scores: it takes no picture and no report"},
    {EXPECT, SEVERAL, 0, "--expect takes one deck, not several"},
    {PART, SEVERAL, 0, "--part takes one deck, not several"},
    {BEST, CONTENT | PART | PICTURE | SEVERAL | FORMAT, 0,
     "--best prints a deck: it takes one deck and no other output"},
    {SOLVE, CONTENT | PART | PICTURE | SEVERAL | BEST | AT | JSON | PAPER, 0,
     "--solve prints a table or csv of one deck, and no other output"},
    {PRINT, CONTENT | PART | PICTURE | SEVERAL | FORMAT | BEST | AT, 0,
     "--print-deck prints a deck: it takes one deck and no other output"},
    {ALL, 0, FILES,
     "--design=all needs --print-deck or --expect with --output=FOLDER/, or --report=FOLDER/: it "
     "writes one file each"},
    {BOTH, BOTH, 0, "--design=all writes answers or reports, one of them at a time"},
    {ALL, PIPE, 0, "--design=all reads the deck for each design: it needs a file"},
    {REPORTS, 0, ALL, "--report=FOLDER/ needs --design=all"},
    {NAMES, 0, ALL, "--names needs --design=all or --scores"},
    {DESIGN, PART | BEST, 0, "--design takes one design, not the whole [sweep]"},
    {SOLUTION, 0, SYNTHESIS, "--solution needs --synthesis"},
    {SYNTHESIS, SEVERAL, 0, "--synthesis takes one deck, not several"},
    {AT_OF_PLOT, 0, PICTURE, "--plot-at needs --plot or --report"},
    {X_OF_PLOT, 0, PLOT, "--plot-x needs --plot"},
    {KIND_OF_PLOT, 0, PLOT, "--plot-kind needs --plot"},
    {REPORT, SEVERAL, 0, "--report takes one deck, not several"},
    {PLOT, SEVERAL, 0, "--plot takes one deck, not several"}};

/* The same; the deck has `with` or `needs`. */
static const rule of_deck[] = {
    {MATRIX, 0, FORCES, "--matrix needs masses or loads; the deck has none"},
    {PAPER, SLIDE, 0, "--format=paper works for a four-bar only"},
    {PART, 0, SWEEP, "--part needs a [sweep]; the deck has none"},
    {DESIGN | ALL, 0, SWEEP | TAKEN, "--design needs a [sweep]; the deck has none"},
    {SYNTHESIS, 0, TASK | TAKEN, "--synthesis needs a [synthesis]; the deck has none"},
    {SOLVE, SWEEP, 0, "--solve works for one design of a [sweep], with --design=N"},
    {PRINT_ONE, SWEEP, 0,
     "--print-deck prints one design of a [sweep], with --design=N, or all, with --design=all"},
    {SEVERAL, ROWS_OF_SWEEP, 0,
     "of several decks a [sweep] has to have values, by output or --columns='max(Ts), "
     "crank.length'"},
    {CHECK | SUMMARY | MATRIX | EXPECT, SWEEP, 0,
     "--check, --expect, --matrix and --summary work for one design of a [sweep], with --design=N"},
    {PAPER, SWEEP, 0, "a [sweep] can be printed as table, csv or json only"},
    {PAPER, VALUES, 0, "values of the deck can be printed as table, csv or json only"},
    {AT, VALUES, 0, "--at shows rows; the columns are values of the deck"}};

static long bit(int is_set, long value)
{
    return is_set ? value : 0;
}

static long asked(const options *o)
{
    static const long contents[SHEET_CONTENT_COUNT] = {0, SUMMARY, CHECK,  LIST, MATRIX,
                                                       0, 0,       EXPECT, CHECK};
    int is_files = options_is_folder(o->output) && (o->print_deck || o->content == SHEET_EXPECT);
    int is_reports = options_is_folder(o->report);

    return contents[o->content] | bit(o->n_contents > 1, ONE_OF) | bit(o->at != NULL, AT) |
           bit(o->answers != NULL, ANSWERS) | bit(o->best != NULL, BEST) |
           bit(o->solve != NULL, SOLVE) | bit(o->print_deck, PRINT) |
           bit(o->print_deck && !o->all_designs, PRINT_ONE) | bit(o->parts > 0, PART) |
           bit(o->design > 0, DESIGN) | bit(o->all_designs, ALL) |
           bit(o->names != NULL && !o->scores, NAMES) | bit(o->synthesis, SYNTHESIS) |
           bit(o->solution > 0, SOLUTION) | bit(o->plot != NULL, PLOT) |
           bit(o->drawing.at != NULL, AT_OF_PLOT) | bit(o->drawing.x != NULL, X_OF_PLOT) |
           bit(o->drawing.kind != PLOT_COUNT, KIND_OF_PLOT) | bit(o->report != NULL, REPORT) |
           bit(is_reports, REPORTS) | bit(is_files || (is_reports && !o->output), FILES) |
           bit(o->all_designs && o->content == SHEET_EXPECT && o->report, BOTH) |
           bit(o->n_decks > 0 && strcmp(o->decks[0], "-") == 0, PIPE) |
           bit(o->n_decks > 1, SEVERAL) | bit(o->format == &csv_format, CSV) |
           bit(o->format == &json_format, JSON) | bit(o->format == &paper_format, PAPER);
}

static const char *find(const rule *rules, size_t n, long what, long has)
{
    size_t i;

    for (i = 0; i < n; i++)
        if ((what & rules[i].what) &&
            ((has & rules[i].with) || (rules[i].needs && !(has & rules[i].needs))))
            return rules[i].why;
    return NULL;
}

const char *rules_of_options(const options *o)
{
    long what = asked(o);

    return find(of_options, sizeof of_options / sizeof *of_options, what, what);
}

const char *rules_of_deck(const options *o, const fourlink_problem *p, int is_design, int has_task,
                          int has_values)
{
    int kind = (int)p->mechanism.design.kind;
    int has_slide =
        fourlink_slides(kind, FOURLINK_COUPLER) || fourlink_slides(kind, FOURLINK_FOLLOWER);
    long has = bit(p->has_forces, FORCES) | bit(has_slide, SLIDE) | bit(p->n_designs > 0, SWEEP) |
               bit(is_design, TAKEN) | bit(has_task, TASK) | bit(has_values, VALUES) |
               bit(p->n_designs > 0 && !has_values, ROWS_OF_SWEEP);

    return find(of_deck, sizeof of_deck / sizeof *of_deck, asked(o), has);
}

const char *rules_without_sweep(const options *o)
{
    return find(of_deck, sizeof of_deck / sizeof *of_deck, asked(o) & (PART | DESIGN | ALL), 0);
}
