/* SPDX-License-Identifier: GPL-3.0-or-later
**
** options.c - the command line.
*/
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "base/number.h"
#include "options.h"
#include "tables/formats.h"

/* @f stands for the formats, @k for the kinds of pictures, a line each. */
static const char *const help[] = {
    "Usage: fourlink [OPTION]... [DECK]...",
    "",
    "Kinematics and forces of four-bar linkages and slider-cranks, as tables over the crank angle.",
    "Reads standard input if no DECK is given, or for -.",
    "",
    "  -f, --format=@f format of the output (default: table)",
    "  -o, --output=FILE                 write to FILE, replaced only when complete",
    "  -b, --branch=open|crossed|both    assembly mode (default: both; with gas: open)",
    "  -i, --interval=QUANTITY           interval of the crank angle, such as '10 deg'",
    "  -c, --columns=NAME,NAME,...|all   columns to print; --list shows their names",
    "      --units=UNIT,UNIT,...         units of results, such as 'mm, kg, rpm'; bare numbers of",
    "                                    the deck keep theirs",
    "  -w, --wide                        on a terminal: all columns side by side",
    "  -s, --set=[SECTION[ NAME].]KEY=VALUE",
    "                                    change the deck: --set 'motion.speed=100 rpm'",
    "  -C, --check[=FILE]                compare with the [expect] values of the deck, or FILE,",
    "                                    or FOLDER/NAME.expect for NAME.deck",
    "      --answers=FOLDER              compare one deck with each file of answers in FOLDER",
    "      --scores                      print a score for each deck or file, not each value",
    "      --tolerance=TOLERANCE,...     how far values may differ, such as '1 %, 0.5 deg'",
    "      --expect                      print the values of the deck as answers for --check=FILE",
    "      --at=ANGLE,COLUMN=VALUE,...   the rows at these crank angles, and where columns have",
    "                                    these values, such as --at='theta4 = 120 deg'",
    "      --allow-files                 let a deck name files outside its folder",
    "  -m, --matrix                      print the nine equations, A x = b, for each row",
    "  -S, --summary                     print facts, extremes, turning moment instead of rows",
    "  -p, --plot=FILE                   draw a picture: .svg .png .pdf .txt .gif, or -; the table",
    "                                    is printed too with --format or --output",
    "      --plot-kind=KIND              what to draw (default: mechanism, for .gif animation):",
    "@k",
    "      --plot-at=ANGLE,ANGLE,...     crank angles to draw, such as '40 deg'",
    "      --plot-x=NAME                 draw columns over this one (default: theta2 or time)",
    "      --plot-script=FILE            write the gnuplot script, to change and run",
    "      --report=FILE                 write a report to hand in: a page .html with deck, facts,",
    "                                    sample calculation, pictures and tables",
    "      --statistics                  print statistics of the designs of the deck's [sweep]",
    "      --best='max|min NAME'         print the best design of the deck's [sweep], refined,",
    "                                    as a deck",
    "  -P, --part=K/N                    compute the K-th of N parts of the deck's [sweep]",
    "      --design=N|all                take design N of the deck's [sweep], from 1, as a deck",
    "      --print-deck                  print the deck as it is computed: with other values, of "
    "one",
    "                                    design; of all: into --output=FOLDER/",
    "      --names=FILE                  names for the files of --design=all, one a line",
    "  -l, --list                        list columns and facts of the deck, with meanings",
    "  -h, --help                        print this text",
    "  -V, --version                     print the version",
    "",
    "Exit status: 0 success; 1 some rows could not be computed, or a check failed;",
    "2 wrong usage or mistakes in a deck; 3 reading, writing, gnuplot or memory failed.",
    NULL};

/* Stand for the letter of options that have none. */
enum {
    PLOT_KIND = 1,
    PLOT_AT,
    PLOT_SCRIPT,
    REPORT,
    PLOT_X,
    EXPECT,
    ANSWERS,
    SCORES,
    TOLERANCE,
    AT,
    STATISTICS,
    BEST,
    ALLOW_FILES,
    DESIGN,
    PRINT_DECK,
    UNITS,
    NAMES,
    LAST_WITHOUT_LETTER = NAMES
};

/* How an option is kept: as a flag or text of its own, or as a change to the deck. */
typedef struct option_info {
    char letter;
    const char *name;
    int takes_value; /* 2: one may follow after '=' */
    const char *key; /* not null: the key of the deck that it sets, and "=" */
} option_info;

static const option_info table[] = {{'f', "--format", 1, NULL},
                                    {'o', "--output", 1, NULL},
                                    {'b', "--branch", 1, "table.branch="},
                                    {'i', "--interval", 1, "motion.interval="},
                                    {'c', "--columns", 1, "table.columns="},
                                    {UNITS, "--units", 1, NULL},
                                    {'w', "--wide", 0, NULL},
                                    {'s', "--set", 1, ""},
                                    {ALLOW_FILES, "--allow-files", 0, NULL},
                                    {'m', "--matrix", 0, NULL},
                                    {'C', "--check", 2, NULL},
                                    {ANSWERS, "--answers", 1, NULL},
                                    {SCORES, "--scores", 0, NULL},
                                    {TOLERANCE, "--tolerance", 1, "grading.tolerance="},
                                    {EXPECT, "--expect", 0, NULL},
                                    {AT, "--at", 1, NULL},
                                    {'S', "--summary", 0, NULL},
                                    {'p', "--plot", 1, NULL},
                                    {PLOT_KIND, "--plot-kind", 1, NULL},
                                    {PLOT_AT, "--plot-at", 1, NULL},
                                    {PLOT_X, "--plot-x", 1, NULL},
                                    {PLOT_SCRIPT, "--plot-script", 1, NULL},
                                    {REPORT, "--report", 1, NULL},
                                    {STATISTICS, "--statistics", 0, NULL},
                                    {BEST, "--best", 1, NULL},
                                    {'P', "--part", 1, NULL},
                                    {DESIGN, "--design", 1, NULL},
                                    {NAMES, "--names", 1, NULL},
                                    {PRINT_DECK, "--print-deck", 0, NULL},
                                    {'l', "--list", 0, NULL},
                                    {'h', "--help", 0, NULL},
                                    {'V', "--version", 0, NULL}};

#define TABLE_COUNT (sizeof table / sizeof table[0])
#define MOST_DESIGNS 4294967295.0
#define LONGEST_KEY 20 /* bytes, with the "=" */

/* Returns 0, for the caller to return. */
static int say(char message[400], const char *a, const char *b, const char *c)
{
    char word[200];

    flk_message(message, 400, "%s%s%s", a, flk_text_copy(flk_text_of(b), word, sizeof word), c);
    return 0;
}

/* The value of an option that was given without one. */
static const char no_value[] = "";

static int set_format(options *o, const char *value, char message[400])
{
    char names[FORMATS_NAMES];

    o->format = formats_find(value);
    o->asks_for_table = 1;
    if (o->format)
        return 1;
    flk_message(message, 400, "--format must be %s, not '%t'",
                formats_of(SHEET_ROWS, ", ", " or ", names), flk_text_of(value));
    return 0;
}

/* By sheet_content. */
static const char *const content_options[] = {"",         "--summary", "--check", "--list",
                                              "--matrix", "",          "--expect"};

static int set_content(options *o, sheet_content content)
{
    o->n_contents += o->content != content;
    o->content = content;
    return 1;
}

/* K/N */
static int set_part(options *o, const char *value, char message[400])
{
    text rest = flk_text_of(value), k;
    double part = 0, parts = 0;

    flk_text_split(&rest, '/', &k);
    if (!rest.start || flk_number_read(&k, &part) != NUMBER_OK || k.length ||
        flk_number_read(&rest, &parts) != NUMBER_OK || rest.length || part != floor(part) ||
        parts != floor(parts) || part < 1 || parts < 1 || parts > 1e6)
        return say(message, "--part must be K/N, such as 1/4, not '", value, "'");
    if (part > parts)
        return say(message, "--part=", value, ": K must be from 1 to N");
    o->part = (unsigned long)part;
    o->parts = (unsigned long)parts;
    return 1;
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
    o->plot = value;
    o->drawing.file = plot_file_of(value);
    if (o->drawing.file == PLOT_FILE_COUNT)
        return say(
            message,
            "--plot needs a file name that ends in .svg, .png, .pdf, .txt or .gif, or -, not '",
            value, "'");
    return 1;
}

/* 1 if a name says that it is a folder's: it ends in a slash. */
static int is_folder(const char *name)
{
    return name && *name && name[strlen(name) - 1] == '/';
}

static int set_report(options *o, const char *value, char message[400])
{
    o->report = value;
    return is_folder(value) || flk_text_ends_in(flk_text_of(value), ".html") ||
           flk_text_ends_in(flk_text_of(value), ".htm") ||
           say(message, "--report needs a file name that ends in .html, not '", value, "'");
}

/* Change a key of the deck: `key` ends in "=". */
static int set_change(options *o, const char *origin, const char *key, const char *value)
{
    fourlink_change *change = &o->changes[o->n_changes++];

    change->origin = origin;
    change->assignment = o->next;
    o->next += sprintf(o->next, "%s%s", key, value) + 1;
    return 1;
}

/* max NAME, min NAME */
static int set_best(options *o, const char *value, char message[400])
{
    text which, name;

    if (!flk_text_cut(flk_text_of(value), " ", &which, &name) || !name.length ||
        strpbrk(name.start, ", \t") ||
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
    text rest = flk_text_of(value);
    double n = 0;

    o->all_designs = strcmp(value, "all") == 0;
    o->design = 0;
    if (o->all_designs)
        return 1;
    if (flk_number_read(&rest, &n) != NUMBER_OK || rest.length || n != floor(n) || n < 1 ||
        n > MOST_DESIGNS)
        return say(message, "--design must be a number from 1, or all, not '", value, "'");
    o->design = (unsigned long)n;
    return 1;
}

/* 1; 0 and the reason in `message`. */
static int set(options *o, const option_info *info, const char *value, char message[400])
{
    if (info->key)
        return set_change(o, info->name, info->key, value);
    switch (info->letter) {
    case 'f':
        return set_format(o, value, message);
    case 'o':
        o->output = strcmp(value, "-") == 0 ? NULL : value;
        return o->asks_for_table = 1;
    case 'P':
        return set_part(o, value, message);
    case 'p':
        return set_plot(o, value, message);
    case DESIGN:
        return set_design(o, value, message);
    case PRINT_DECK:
        return o->print_deck = 1;
    case NAMES:
        o->names = value;
        return 1;
    case PLOT_KIND:
        return set_plot_kind(o, value, message);
    case PLOT_AT:
        o->drawing.at = value;
        return 1;
    case PLOT_X:
        o->drawing.x = value;
        return 1;
    case PLOT_SCRIPT:
        o->plot_script = value;
        return 1;
    case REPORT:
        return set_report(o, value, message);
    case 'C':
        if (value[0] == '\0' && value != no_value)
            return say(message, "--check= needs a file name", "", "");
        o->check_file = *value ? value : NULL;
        return set_content(o, SHEET_CHECK);
    case ANSWERS:
        if (!*value)
            return say(message, "--answers= needs a folder", "", "");
        o->answers = value;
        return set_content(o, SHEET_CHECK);
    case SCORES:
        o->scores = 1;
        return set_content(o, SHEET_CHECK);
    case BEST:
        return set_best(o, value, message);
    case STATISTICS:
        o->n_statistics++;
        return set_change(o, "--statistics", "sweep.statistics=", "yes");
    case EXPECT:
        return set_content(o, SHEET_EXPECT);
    case ALLOW_FILES:
        return o->allow_files = 1;
    case AT:
        o->at = value;
        return 1;
    case UNITS:
        o->units = value;
        return 1;
    case 'm':
        return set_content(o, SHEET_MATRIX);
    case 'S':
        return set_content(o, SHEET_SUMMARY);
    case 'l':
        return set_content(o, SHEET_LIST);
    case 'w':
        return o->wide = 1;
    case 'h':
        return o->help = 1;
    case 'V':
    default:
        return o->version = 1;
    }
}

/* --name, --name=value, --name value */
static int read_long(options *o, const char *word, const char *next, int *used_next,
                     char message[400])
{
    const char *equals = strchr(word, '='), *known[TABLE_COUNT + 1] = {NULL}, *nearest;
    size_t length = equals ? (size_t)(equals - word) : strlen(word), i;
    text name = flk_text_of(word + 2);
    char copy[100];

    name.length = length - 2;
    for (i = 0; i < TABLE_COUNT; i++) {
        const char *value = equals ? equals + 1 : table[i].takes_value == 1 ? next : no_value;

        known[i] = table[i].name + 2;
        if (!flk_text_same(name, known[i]))
            continue;
        if (!table[i].takes_value && equals)
            return say(message, table[i].name, " takes no value", "");
        if (!value)
            return say(message, table[i].name, " needs a value", "");
        *used_next = value == next;
        return set(o, &table[i], value, message);
    }
    nearest = flk_text_nearest(name, known);
    flk_message(message, 400,
                nearest ? "unknown option '--%s'; did you mean '--%s'?" : "unknown option '--%s'",
                flk_text_copy(name, copy, sizeof copy), nearest);
    return 0;
}

/* -x, -xy, -ovalue, -o value */
static int read_short(options *o, const char *word, const char *next, int *used_next,
                      char message[400])
{
    char letter[3] = "-?";
    size_t i;

    while (*++word) {
        for (i = 0; i < TABLE_COUNT; i++)
            if (table[i].letter == *word && *word > LAST_WITHOUT_LETTER)
                break;
        letter[1] = *word;
        if (i == TABLE_COUNT)
            return say(message, "unknown option '", letter, "'");
        if (table[i].takes_value == 1) {
            if (!word[1] && !next)
                return say(message, letter, " needs a value", "");
            *used_next = !word[1];
            return set(o, &table[i], word[1] ? word + 1 : next, message);
        }
        set(o, &table[i], no_value, message);
    }
    return 1;
}

/* Check the options that belong to --plot. */
static int check_plot(options *o, char message[400])
{
    int wanted = o->plot || o->plot_script;

    if (!wanted && o->drawing.at && !o->report)
        return say(message, "--plot-at needs --plot, --plot-script or --report", "", "");
    if (!wanted && (o->drawing.x || o->drawing.kind != PLOT_COUNT))
        return say(message, o->drawing.x ? "--plot-x" : "--plot-kind",
                   " needs --plot or --plot-script", "");
    if (o->report && o->n_decks > 1)
        return say(message, "--report takes one deck, not several", "", "");
    if (!wanted)
        return 1;
    if (o->n_decks > 1)
        return say(message, "--plot takes one deck, not several", "", "");
    if (!o->plot)
        o->drawing.file = PLOT_SVG;
    if (o->drawing.kind == PLOT_COUNT)
        o->drawing.kind = o->drawing.file == PLOT_GIF ? PLOT_ANIMATION : PLOT_MECHANISM;
    if (o->drawing.at && o->drawing.kind != PLOT_MECHANISM && o->drawing.kind != PLOT_VECTORS &&
        o->drawing.kind != PLOT_LIMITS && o->drawing.kind != PLOT_KLEIN)
        return say(message,
                   "--plot-at works with the kinds mechanism, vectors, limits and klein, not with ",
                   plot_names[o->drawing.kind], "");
    if (o->drawing.x && o->drawing.kind != PLOT_COLUMNS)
        return say(message, "--plot-x works with --plot-kind=columns, not with ",
                   plot_names[o->drawing.kind], "");
    if (o->drawing.kind == PLOT_ANIMATION && o->plot && o->drawing.file != PLOT_GIF)
        return say(message, "an animation needs a file name that ends in .gif, not '", o->plot,
                   "'");
    if (o->drawing.kind == PLOT_ANIMATION)
        o->drawing.file = PLOT_GIF;
    if (o->plot_script && o->plot && strcmp(o->plot, "-") != 0)
        o->drawing.picture = o->plot;
    return 1;
}

void options_put_help(FILE *out)
{
    char names[FORMATS_NAMES];
    const char *const *next, *at;
    int i;

    for (next = help; *next; next++) {
        at = strchr(*next, '@');
        if (!at)
            fprintf(out, "%s\n", *next);
        else if (at[1] == 'f')
            fprintf(out, "%.*s%s%s\n", (int)(at - *next), *next,
                    formats_of(SHEET_ROWS, "|", "|", names), at + 2);
        else
            for (i = 0; i < PLOT_COUNT; i++)
                fprintf(out, "          %-16s%s\n", plot_names[i], plot_shows[i]);
    }
}

/* Check what does not go with decks that are printed, or with one design. */
static int check_designs(const options *o, char message[400])
{
    int is_output = is_folder(o->output);

    if (o->print_deck &&
        (o->content != SHEET_ROWS || o->parts || o->best || o->n_statistics || o->plot ||
         o->plot_script || o->report || o->at || o->n_decks > 1 || o->format != &table_format))
        return say(message, "--print-deck prints a deck: it takes one deck and no other output", "",
                   "");
    if (o->all_designs && !((o->print_deck || o->content == SHEET_EXPECT) && is_output) &&
        !(is_folder(o->report) && !o->output))
        return say(message,
                   "--design=all needs --print-deck or --expect with --output=FOLDER/, or "
                   "--report=FOLDER/: it writes one file each",
                   "", "");
    if (o->all_designs && o->content == SHEET_EXPECT && o->report)
        return say(message, "--design=all writes answers or reports, one of them at a time", "",
                   "");
    if (o->all_designs && !o->print_deck && strcmp(o->decks[0], "-") == 0)
        return say(message, "--design=all reads the deck for each design: it needs a file", "", "");
    if (!o->all_designs && is_folder(o->report))
        return say(message, "--report=FOLDER/ needs --design=all", "", "");
    if (o->names && !o->all_designs)
        return say(message, "--names needs --design=all", "", "");
    if (o->design && (o->parts || o->best || o->n_statistics))
        return say(message, "--design takes one design, not the whole [sweep]", "", "");
    return 1;
}

int options_read(int argc, char **argv, options *o, char message[400])
{
    int i, done = 0;
    size_t room = (size_t)argc + 1, length = 1;

    memset(o, 0, sizeof *o);
    o->format = &table_format;
    o->drawing.kind = PLOT_COUNT;
    o->changes = malloc(room * sizeof *o->changes);
    o->decks = malloc(room * sizeof *o->decks);
    for (i = 1; i < argc; i++)
        length += strlen(argv[i]) + LONGEST_KEY;
    o->storage = o->next = malloc(length);
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
    if (o->n_contents > 1)
        return say(message, "use only one of --check, --expect, --summary, --matrix and --list", "",
                   "");
    if (o->at && ((o->content != SHEET_EXPECT && o->content != SHEET_ROWS) || o->report ||
                  o->plot || o->plot_script || o->format == &paper_format))
        return say(message, "--at chooses rows of a table, csv, json or --expect", "", "");
    if (o->answers && o->n_decks > 1)
        return say(message,
                   "--answers takes one deck; for a deck of each student give --check=FOLDER", "",
                   "");
    if (o->answers && (o->plot || o->plot_script || o->report))
        return say(message, "--answers prints scores: it takes no picture and no report", "", "");
    if (o->answers)
        o->check_file = o->answers;
    if (o->content == SHEET_EXPECT && o->n_decks > 1)
        return say(message, "--expect takes one deck, not several", "", "");
    if (o->content == SHEET_LIST && !(o->format->writes & 1 << SHEET_LIST))
        o->format = &table_format;
    if (!(o->format->writes & 1 << o->content)) {
        char names[FORMATS_NAMES];

        flk_message(message, 400, "%s can be printed as %s only", content_options[o->content],
                    formats_of(o->content, ", ", " or ", names));
        return 0;
    }
    if (o->best && (o->content != SHEET_ROWS || o->parts || o->n_statistics || o->plot ||
                    o->plot_script || o->report || o->n_decks > 1 || o->format != &table_format))
        return say(message, "--best prints a deck: it takes one deck and no other output", "", "");
    if (o->n_statistics && o->parts)
        return say(message, "--statistics needs all designs, not a --part", "", "");
    if (!o->n_decks)
        o->decks[o->n_decks++] = "-";
    if (!check_designs(o, message))
        return 0;
    return check_plot(o, message);
}

int options_want_table(const options *o)
{
    int comes_alone = o->plot || o->plot_script || o->report;

    return !comes_alone || o->asks_for_table || o->content != SHEET_ROWS || o->n_statistics ||
           o->parts;
}

void options_free(options *o)
{
    free(o->storage);
    free(o->changes);
    free((void *)o->decks);
}
