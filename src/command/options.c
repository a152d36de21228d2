/* SPDX-License-Identifier: GPL-3.0-or-later
**
** options.c - the command line.
*/
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "base/number.h"
#include "system/memory.h"
#include "system/system.h"
#include "options.h"
#include "tables/formats.h"
#include "terminal.h"

#define MOST_DESIGNS 4294967295.0
#define MOST_SOLUTIONS 1000
#define MOST_EFFORT 1000
#define LONGEST_KEY 20 /* bytes, with the "=" */

/* Returns 0, for the caller to return. */
static int say(char message[400], const char *a, const char *b, const char *c)
{
    char word[200];

    flk_message(message, 400, "%s%s%s", a, flk_text_copy(flk_text_of(b), word, sizeof word), c);
    return 0;
}

/* The same of a value, which the format quotes. */
static int refuse(char message[400], const char *format, const char *value)
{
    flk_message(message, 400, format, flk_text_of(value));
    return 0;
}

/* The value of an option that was given without one. */
static const char no_value[] = "";

static int set_format(options *o, const char *value, char message[400])
{
    char names[FORMATS_NAMES];

    o->is_html = strcmp(value, "html") == 0;
    if (o->is_html)
        return 1;
    o->format = formats_find(value);
    o->asks_for_table = o->has_format = 1;
    if (o->format)
        return 1;
    flk_message(message, 400, "--format must be %s, not '%t'",
                formats_of(SHEET_ROWS, ", ", " or ", names), flk_text_of(value));
    return 0;
}

/* 1 if a text is a whole number from 1. */
static int is_whole(text words, double most, unsigned long *number)
{
    double n = 0;

    if (flk_number_read(&words, &n) != NUMBER_OK || words.length || n != floor(n) || n < 1 ||
        n > most)
        return 0;
    *number = (unsigned long)n;
    return 1;
}

/* K/N */
static int set_part(options *o, const char *value, char message[400])
{
    text rest = flk_text_of(value), k;

    flk_text_split(&rest, '/', &k);
    if (!rest.start || !is_whole(k, MOST_DESIGNS, &o->part) || !is_whole(rest, 1e6, &o->parts))
        return say(message, "--part must be K/N, such as 1/4, not '", value, "'");
    return o->part <= o->parts || say(message, "--part=", value, ": K must be from 1 to N");
}

static int set_plot_kind(options *o, const char *value, char message[400])
{
    char names[200];
    int i;

    for (i = 0; plot_names[i]; i++)
        if (strcmp(value, plot_names[i]) == 0) {
            o->drawing.kind = (plot_kind)i;
            return 1;
        }
    flk_message(message, 400, "--plot-kind must be %s, not '%t'%h",
                flk_text_list(plot_names, ", ", " or ", names, sizeof names), flk_text_of(value),
                flk_text_nearest(flk_text_of(value), plot_names));
    return 0;
}

static int set_plot(options *o, const char *value, char message[400])
{
    char names[100];

    o->plot = value;
    o->drawing.file = options_is_folder(value) ? PLOT_SVG : plot_file_of(value);
    if (o->drawing.file == PLOT_FILE_COUNT)
        flk_message(message, 400, "--plot needs a file name that ends in %s, or -, not '%t'",
                    flk_text_list(plot_endings, ", ", " or ", names, sizeof names),
                    flk_text_of(value));
    return o->drawing.file != PLOT_FILE_COUNT;
}

int options_is_folder(const char *name)
{
    return name && *name && name[strlen(name) - 1] == '/';
}

static int set_report(options *o, const char *value, char message[400])
{
    o->report = value;
    return options_is_folder(value) || flk_text_ends_in(flk_text_of(value), ".html") ||
           flk_text_ends_in(flk_text_of(value), ".htm") ||
           flk_text_ends_in(flk_text_of(value), ".pdf") ||
           say(message, "--report needs a file name that ends in .html or .pdf, not '", value, "'");
}

static int set_quiz(options *o, const char *value, char message[400])
{
    o->quiz = value;
    return flk_text_ends_in(flk_text_of(value), ".xml") ||
           say(message, "--quiz needs a file name that ends in .xml, not '", value, "'");
}

/* Change a key of the deck: the assignment is both texts. */
static int set_change(options *o, const char *origin, const char *key, const char *value)
{
    fourlink_change *change = &o->changes[o->n_changes++];

    change->origin = origin;
    change->assignment = o->next;
    o->next += sprintf(o->next, "%s%s", key, value) + 1;
    return 1;
}

/* max NAME, min NAME, where NAME can be NAME at ANGLE */
static int set_best(options *o, const char *value, char message[400])
{
    text which, name, first, angle;
    int is_name = flk_text_cut(flk_text_of(value), " ", &which, &name) && name.length > 0;

    first = name;
    if (is_name)
        flk_text_cut(name, " at ", &first, &angle);
    if (!is_name || strchr(name.start, ',') || flk_text_cut(first, " ", &first, &angle) ||
        (!flk_text_equal(which, "max") && !flk_text_equal(which, "min")))
        return say(message, "--best must be 'max NAME' or 'min NAME', such as 'max mu_min', not '",
                   value, "'");
    o->best = name.start;
    o->best_is_largest = flk_text_equal(which, "max");
    return set_change(o, "--best", "sweep.output=", name.start);
}

/* N or all */
static int set_design(options *o, const char *value, char message[400])
{
    o->all_designs = strcmp(value, "all") == 0;
    o->design = 0;
    return o->all_designs || is_whole(flk_text_of(value), MOST_DESIGNS, &o->design) ||
           refuse(message, "--design must be a number from 1, or all, not '%t'", value);
}

static int set_effort(options *o, const char *value, char message[400])
{
    return is_whole(flk_text_of(value), MOST_EFFORT, &o->effort) ||
           refuse(message, "--effort must be a number from 1 to 1000, not '%t'", value);
}

static int set_solution(options *o, const char *value, char message[400])
{
    return is_whole(flk_text_of(value), MOST_SOLUTIONS, &o->solution) ||
           refuse(message, "--solution must be a number from 1 to 1000, not '%t'", value);
}

static int set_colour(options *o, const char *value, char message[400])
{
    o->colour = value;
    return strcmp(value, "always") == 0 || strcmp(value, "never") == 0 ||
           say(message, "--color must be always or never, not '", value, "'");
}

static int set_output(options *o, const char *value, char message[400])
{
    (void)message;
    o->output = strcmp(value, "-") == 0 ? NULL : value;
    return o->asks_for_table = 1;
}

static int set_check(options *o, const char *value, char message[400])
{
    if (!*value && value != no_value)
        return say(message, "--check= needs a file name", "", "");
    o->check_file = *value ? value : NULL;
    return 1;
}

static int set_feedback(options *o, const char *value, char message[400])
{
    o->feedback = value;
    o->scores = 1;
    return options_is_folder(value) ||
           say(message, "--feedback needs a folder, such as feedback/, not '", value, "'");
}

static int set_answers(options *o, const char *value, char message[400])
{
    o->answers = value;
    return *value || say(message, "--answers= needs a folder", "", "");
}

static int set_import(options *o, const char *value, char message[400])
{
    o->import = value;
    o->print_deck = 1;
    return *value || say(message, "--import= needs a file name", "", "");
}

/* An option sets what its entry names: a key of the deck, the content, a member of the options (a text,
** or a flag if it takes no value), and what its function does. */
typedef struct option_info {
    char letter; /* 0: it has none */
    const char *name;
    const char *value; /* its name; null: it takes none; [=FILE]: one may follow after '=' */
    const char *key;   /* of the deck, and "=" */
    int (*set)(options *o, const char *value, char message[400]);
    sheet_content content; /* SHEET_ROWS: any */
    size_t member;         /* 0: none */
    const char *words;     /* of the help */
    const char *group;     /* of which it is the first; null: it is not the first */
} option_info;

#define KEY(key) key, NULL, SHEET_ROWS, 0
#define OWN(function) NULL, function, SHEET_ROWS, 0
#define CONTENT(content) NULL, NULL, content, 0
#define MEMBER(member) NULL, NULL, SHEET_ROWS, offsetof(options, member)

static const option_info table[] = {
    {'s', "--set", "[SECTION[ NAME].]KEY=VALUE", KEY(""),
     "change the deck: --set 'motion.speed=100 rpm'", "Deck:"},
    {'b', "--branch", "open|crossed|both", KEY("table.branch="),
     "assembly mode (default: both; with gas: open)", NULL},
    {'i', "--interval", "QUANTITY", KEY("motion.interval="),
     "interval of the crank angle, such as '10 deg'", NULL},
    {0, "--allow-files", NULL, MEMBER(allow_files), "let a deck name files outside its folder",
     NULL},
    {0, "--print-deck", NULL, MEMBER(print_deck),
     "print the deck as it is computed: with other values, of one design; of all: into "
     "--output=FOLDER/",
     NULL},
    {0, "--pins", NULL, MEMBER(pins),
     "print it by the places of its pins, as drawn at --plot-at, else at its first row", NULL},
    {0, "--import", "FILE", OWN(set_import),
     "print the deck of a PMKS+ link in FILE, by the places of its pins", NULL},
    {'c', "--columns", "NAME,NAME,...|all", KEY("table.columns="),
     "columns to print, or values such as 'max(Ts), Ts at 30 deg', one line for each deck; --list "
     "shows "
     "their names",
     "Output:"},
    {0, "--at", "ANGLE,COLUMN=VALUE,...", MEMBER(at),
     "the rows at these crank angles, and where columns have these values, such as "
     "--at='theta4 = 120 deg'",
     NULL},
    {'S', "--summary", NULL, CONTENT(SHEET_SUMMARY),
     "print facts, turning moment, extremes instead of rows", NULL},
    {'m', "--matrix", NULL, CONTENT(SHEET_MATRIX),
     "print the nine equations, A x = b, for each row", NULL},
    {'l', "--list", NULL, CONTENT(SHEET_LIST),
     "list columns and facts, with meanings: of the deck or, without a deck, all", NULL},
    {'f', "--format", "", OWN(set_format), "format of the output (default: table)", NULL},
    {'o', "--output", "FILE", OWN(set_output), "write to FILE, replaced only when complete", NULL},
    {0, "--units", "UNIT,UNIT,...", MEMBER(units),
     "units of results, such as 'mm, kg, rpm' or SI; bare numbers of the deck keep theirs", NULL},
    {'w', "--wide", NULL, MEMBER(wide), "on a terminal: all columns side by side", NULL},
    {0, "--color", "always|never", OWN(set_colour),
     "headings, extremes and mistakes in colour (default: on a terminal, unless NO_COLOR is set)",
     NULL},
    {'C', "--check", "[=FILE]", NULL, set_check, SHEET_CHECK, 0,
     "compare with the [expect] values of the deck, or FILE, or FOLDER/NAME.expect for NAME.deck",
     "Checks and classes:"},
    {0, "--answers", "FOLDER", NULL, set_answers, SHEET_CHECK, 0,
     "compare one deck with each file of answers in FOLDER", NULL},
    {0, "--scores", NULL, NULL, NULL, SHEET_CHECK, offsetof(options, scores),
     "print a score for each deck or file, not each value", NULL},
    {0, "--feedback", "FOLDER/", NULL, set_feedback, SHEET_CHECK, 0,
     "print scores, and write a text for each student, or with --format=html a page, into FOLDER/: "
     "what was right or wrong, and why",
     NULL},
    {0, "--exercise", "DECK", MEMBER(exercise),
     "ask for what the [expect] of this deck names, and grade by its [grading]: with a deck for "
     "each student",
     NULL},
    {0, "--quiz", "FILE", OWN(set_quiz),
     "write what the [expect] of the deck asks as a quiz, in Moodle XML: a question for the deck, "
     "or for each design of its [sweep]",
     NULL},
    {0, "--tolerance", "TOLERANCE,...", KEY("grading.tolerance="),
     "how far values may differ, such as '1 %, 0.5 deg'", NULL},
    {0, "--expect", NULL, CONTENT(SHEET_EXPECT),
     "print the values of the deck as answers for --check=FILE", NULL},
    {0, "--form", NULL, NULL, NULL, SHEET_EXPECT, offsetof(options, form),
     "the same without values, or what the [expect] of the deck asks: a form to fill in", NULL},
    {'p', "--plot", "FILE", OWN(set_plot),
     "draw a picture: %s, or -; the table is printed too with --format or "
     "--output",
     "Pictures and reports:"},
    {0, "--plot-kind", "KIND", OWN(set_plot_kind), "what to draw (default: mechanism):", NULL},
    {0, "--plot-at", "ANGLE,ANGLE,...", MEMBER(drawing.at),
     "crank angles to draw, such as '40 deg'", NULL},
    {0, "--plot-x", "NAME", MEMBER(drawing.x),
     "draw columns over this one (default: theta2 or time)", NULL},
    {0, "--ascii", NULL, MEMBER(ascii), "draw text pictures without Braille characters", NULL},
    {0, "--report", "FILE", OWN(set_report),
     "write a report to hand in: a page .html, or by Chromium a .pdf, with deck, facts, sample "
     "calculation, pictures and "
     "tables",
     NULL},
    {'P', "--part", "K/N", OWN(set_part), "compute the K-th of N parts of the deck's [sweep]",
     "Designs:"},
    {0, "--design", "N|all", OWN(set_design),
     "take design N of the deck's [sweep], from 1, as a deck", NULL},
    {0, "--names", "FILE", MEMBER(names),
     "the class, for the files of --design=all and for marks: names, one a line, or a csv with "
     "headings name (or first name, surname), id, late, design",
     NULL},
    {0, "--best", "'max|min NAME'", OWN(set_best),
     "print the best design of the deck's [sweep], refined, as a deck; with --format, or of "
     "several "
     "decks, as a line",
     NULL},
    {0, "--solve", "'KEY = LOW .. HIGH where NAME = VALUE'", MEMBER(solve),
     "the values of an input at which a fact, an extreme, or a column at an angle (NAME at ANGLE) "
     "has a value",
     NULL},
    {0, "--synthesis", NULL, MEMBER(synthesis),
     "find the linkage of the deck's [synthesis] and print its deck; with --format, a list of all "
     "solutions",
     "Synthesis:"},
    {0, "--solution", "K", OWN(set_solution), "take solution K, from 1", NULL},
    {0, "--effort", "K", OWN(set_effort),
     "search from K times as many starts, for positions that are met as closely as possible", NULL},
    {'h', "--help", NULL, MEMBER(help), "print this text", "Help:"},
    {'V', "--version", NULL, MEMBER(version), "print the version", NULL}};

#define TABLE_COUNT (sizeof table / sizeof table[0])

typedef char options_fit[TABLE_COUNT <= OPTIONS_MOST ? 1 : -1];

/* 1 if an option takes the next word, where none follows after '='. */
static int takes_next(const option_info *info)
{
    return info->value && strncmp(info->value, "[=", 2) != 0;
}

/* 1; 0 and the reason in `message`. */
static int set(options *o, const option_info *info, const char *value, char message[400])
{
    void *member = (char *)o + info->member;

    if (info->key)
        set_change(o, info->name, info->key, value);
    if (info->member && info->value)
        *(const char **)member = value;
    else if (info->member)
        *(int *)member = 1;
    if (info->content != SHEET_ROWS)
        o->content = info->content;
    o->given[info - table] = value;
    return !info->set || info->set(o, value, message);
}

/* The place of an option in the table; TABLE_COUNT for another word. */
static size_t find_option(text name)
{
    size_t i;

    for (i = 0; i < TABLE_COUNT; i++)
        if (flk_text_same(name, table[i].name))
            break;
    return i;
}

const char *options_given(const options *o, text name)
{
    size_t i = find_option(name);

    return i < TABLE_COUNT ? o->given[i] : NULL;
}

/* Say that no option has this name, and which is the nearest; returns 0. */
static int refuse_name(text name, char message[400])
{
    const char *known[TABLE_COUNT + 1] = {NULL}, *nearest;
    char copy[100];
    size_t i;

    for (i = 0; i < TABLE_COUNT; i++)
        known[i] = table[i].name;
    nearest = flk_text_nearest(name, known);
    flk_message(message, 400,
                nearest ? "unknown option '%s'; did you mean '%s'?" : "unknown option '%s'",
                flk_text_copy(name, copy, sizeof copy), nearest);
    return 0;
}

/* The option that asked for the content. */
static const char *content_option(const options *o)
{
    size_t i;

    for (i = 0; i < TABLE_COUNT && !(o->given[i] && table[i].content == o->content); i++)
        ;
    return i < TABLE_COUNT ? table[i].name : "";
}

/* --name, --name=value, --name value */
static int read_long(options *o, const char *word, const char *next, int *used_next,
                     char message[400])
{
    const char *equals = strchr(word, '='), *value;
    text name = flk_text_of(word);
    size_t i;

    if (equals)
        name.length = (size_t)(equals - word);
    i = find_option(name);
    if (i == TABLE_COUNT)
        return refuse_name(name, message);
    value = equals ? equals + 1 : takes_next(&table[i]) ? next : no_value;
    if (!table[i].value && equals)
        return say(message, table[i].name, " takes no value", "");
    if (!value)
        return say(message, table[i].name, " needs a value", "");
    *used_next = value == next;
    return set(o, &table[i], value, message);
}

/* -x, -xy, -ovalue, -o value */
static int read_short(options *o, const char *word, const char *next, int *used_next,
                      char message[400])
{
    char letter[3] = "-?";
    size_t i;

    while (*++word) {
        for (i = 0; i < TABLE_COUNT; i++)
            if (table[i].letter == *word)
                break;
        letter[1] = *word;
        if (i == TABLE_COUNT)
            return say(message, "unknown option '", letter, "'");
        if (takes_next(&table[i])) {
            if (!word[1] && !next)
                return say(message, letter, " needs a value", "");
            *used_next = !word[1];
            return set(o, &table[i], word[1] ? word + 1 : next, message);
        }
        set(o, &table[i], no_value, message);
    }
    return 1;
}

#define HELP_WIDTH 80 /* where it is not a terminal */
#define LARGEST_WIDTH 100
#define WORDS 36       /* the column where the words begin */
#define WORDS_BELOW 10 /* the same on a narrow terminal, in a line of their own */

/* Write words from this column on, behind a name or below it. */
static void put_words(line *l, const char *name, const char *words, size_t column, size_t width)
{
    size_t start = line_here(l);

    if (strlen(name) >= column && *name) {
        line_put(l, "%s\n", name);
        start = line_here(l);
        name = "";
    }
    line_left(l, name, column);
    line_put(l, "%s", words);
    line_finish(l, start, width, column);
}

static void put_option(line *l, const option_info *info, size_t column, size_t width)
{
    char names[FORMATS_NAMES], letter[] = "  -x, ", option[200], words[MESSAGE_SIZE];
    const char *value = info->value ? info->value : "";
    int i;

    if (info->set == set_format)
        value = formats_of(SHEET_ROWS, "|", "|", names);
    letter[3] = info->letter;
    flk_text_join(option, sizeof option, info->letter ? letter : "      ", info->name,
                  takes_next(info) ? "=" : "", value, (char *)NULL);
    flk_text_list(plot_endings, " ", " ", names, sizeof names);
    put_words(l, option,
              info->set == set_plot ? flk_message(words, sizeof words, info->words, names)
                                    : info->words,
              column, width);
    for (i = 0; i < PLOT_COUNT && info->set == set_plot_kind; i++) {
        flk_text_join(option, sizeof option, "          ", plot_names[i], (char *)NULL);
        put_words(l, option, plot_shows[i], 26, width);
    }
}

void options_put_help(FILE *out)
{
    size_t width = terminal_width(out), i;
    line l;

    width = !width ? HELP_WIDTH : width > LARGEST_WIDTH ? LARGEST_WIDTH : width;
    line_start(&l, out);
    line_put(&l, "Usage: fourlink [OPTION]... [DECK]...\n\n");
    put_words(&l, "",
              "Kinematics and forces of four-bar linkages and slider-cranks, as tables over the "
              "crank angle. Reads standard input if no DECK is given, or for -.",
              0, width);
    line_put(&l, "\n");
    for (i = 0; i < TABLE_COUNT; i++) {
        if (table[i].group)
            line_put(&l, i ? "\n%s\n" : "%s\n", table[i].group);
        put_option(&l, &table[i], width < 2 * WORDS ? WORDS_BELOW : WORDS, width);
    }
    line_put(&l, "\n");
    put_words(
        &l, "",
        "Exit status: 0 success; 1 some rows or values could not be computed, or a check failed; "
        "2 wrong usage or mistakes in a deck; 3 reading, writing, rsvg-convert, Chromium or memory "
        "failed.",
        0, width);
    line_end(&l);
}

/* 1 if a picture or a report is asked for. */
static int has_picture(const options *o)
{
    return o->plot || o->report;
}

/* Refuse crank angles for a kind of picture; returns 0. */
static int refuse_at(const char *kind, char message[400])
{
    const char *known[PLOT_COUNT + 1];
    char names[PLOT_COUNT * 16];
    int i, n = 0;

    for (i = 0; i < PLOT_COUNT; i++)
        if (plot_is_of_position((plot_kind)i))
            known[n++] = plot_names[i];
    known[n] = NULL;
    flk_text_list(known, ", ", " and ", names, sizeof names);
    flk_text_join(message, 400, "--plot-at works with the kinds ", names,
                  ", not with --plot-kind=", kind, (char *)NULL);
    return 0;
}

/* Complete what is asked of a picture; 1, or 0 and the reason why it cannot be. */
static int complete_plot(options *o, char message[400])
{
    plot_request *d = &o->drawing;

    if (!o->plot)
        return 1;
    o->no_kind = d->kind == PLOT_COUNT;
    if (o->no_kind) {
        d->kind = PLOT_MECHANISM;
        o->given[find_option(flk_text_of("--plot-kind"))] = plot_names[d->kind];
    }
    if (d->at && !plot_is_of_position(d->kind))
        return refuse_at(plot_names[d->kind], message);
    if (d->kind == PLOT_ANIMATION && d->file != PLOT_SVG)
        return say(message, "an animation needs a file name that ends in .svg, not '", o->plot,
                   "'");
    return 1;
}

/* 1 if no deck comes from standard input: it is a terminal, or empty. */
static int has_no_input(void)
{
    int first = system_is_terminal(stdin) ? EOF : getc(stdin);

    return first == EOF || ungetc(first, stdin) == EOF;
}

int options_read(int argc, char **argv, options *o, char message[400])
{
    int i, done = 0;
    size_t room = (size_t)argc + 1, length = 1;
    char names[FORMATS_NAMES];

    memset(o, 0, sizeof *o);
    o->format = &table_format;
    o->drawing.kind = PLOT_COUNT;
    o->changes = memory_get(room, sizeof *o->changes);
    o->decks = memory_get(room, sizeof *o->decks);
    for (i = 1; i < argc; i++)
        length += strlen(argv[i]) + LONGEST_KEY;
    o->storage = o->next = memory_get(length, 1);
    if (!o->changes || !o->decks || !o->storage)
        return -1;
    for (i = 1; i < argc; i++) {
        const char *word = argv[i], *next = i + 1 < argc ? argv[i + 1] : NULL;

        if (done || word[0] != '-' || !word[1]) {
            o->decks[o->n_decks++] = word;
        } else if (strcmp(word, "--") == 0) {
            done = 1;
        } else {
            int is_long = word[1] == '-', used_next = 0;

            if (!(is_long ? read_long : read_short)(o, word, next, &used_next, message))
                return 0;
            i += used_next;
        }
    }
    if (o->import)
        o->decks[o->n_decks++] = o->import;
    o->lists_all = !o->n_decks && o->content == SHEET_LIST && !o->n_changes && has_no_input();
    if (!o->n_decks)
        o->decks[o->n_decks++] = "-";
    if (o->answers)
        o->check_file = o->answers;
    if (!o->format->frame[o->content]) {
        flk_message(message, 400, "%s does not go with --format=%s: it can be printed as %s only",
                    content_option(o), o->format->name,
                    formats_of(o->content, ", ", " or ", names));
        return 0;
    }
    return complete_plot(o, message);
}

int options_want_table(const options *o)
{
    return !has_picture(o) || o->asks_for_table || o->content != SHEET_ROWS || o->parts;
}

void options_free(options *o)
{
    free(o->storage);
    free(o->changes);
    free((void *)o->decks);
}
