/* SPDX-License-Identifier: GPL-3.0-or-later
**
** words.c - writes the dictionary of the fuzzers: the words of decks, from the schema and from the library's
** lists, and the command's options, from its help.
*/
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "command/options.h"
#include "deck/schema.h"

static void put(const char *before, const char *word, int length, const char *after)
{
    if (length)
        printf("\"%s%.*s%s\"\n", before, length, word, after);
}

static void put_word(const char *word)
{
    put("", word, (int)strlen(word), "");
}

static void put_schema(void)
{
    const char *words[MOST_WORDS];
    int i, k;

    for (i = 0; i < SECTION_COUNT; i++) {
        const char *name = flk_section_table[i].name;

        put(flk_section_table[i].repeats ? "\\x0a[" : "\\x0a[", name, (int)strlen(name),
            flk_section_table[i].repeats ? " a]\\x0a" : "]\\x0a");
    }
    for (i = 0; i < KEY_COUNT; i++) {
        put("\\x0a", flk_key_table[i].name, (int)strlen(flk_key_table[i].name), " = ");
        flk_key_words((key_code)i, NULL, words);
        for (k = 0; words[k]; k++)
            put_word(words[k]);
    }
    for (i = 0; i < QUANTITY_COUNT; i++) {
        put_word(flk_quantities[i].example);
        put(" ", flk_quantities[i].unit, (int)strlen(flk_quantities[i].unit), "");
    }
}

/* The columns and facts of a mechanism of each kind. */
static void put_names(const char *deck)
{
    const fourlink_value *list;
    fourlink_results *r;
    fourlink_source source;
    unsigned long n, i;

    memset(&source, 0, sizeof source);
    source.text = deck;
    source.length = (unsigned long)strlen(deck);
    if (fourlink_results_open(&source, 0, &r, NULL, NULL) != FOURLINK_OK)
        return;
    fourlink_results_list(r, FOURLINK_ALL_COLUMNS, &list, &n);
    for (i = 0; i < n; i++) {
        put_word(list[i].name);
        put("max(", list[i].name, (int)strlen(list[i].name), ")");
    }
    fourlink_results_facts(
        r, 0, FOURLINK_FACTS_LIMITS | FOURLINK_FACTS_TURNING | FOURLINK_FACTS_MOTION, &list, &n);
    for (i = 0; i < n; i++)
        put_word(list[i].name);
    fourlink_results_free(r);
}

/* What begins with "-" in the help, and the words after "=" there. */
static void put_options(void)
{
    FILE *help = tmpfile();
    char line[200];
    const char *at;
    int n;

    if (!help)
        return;
    options_put_help(help);
    rewind(help);
    while (fgets(line, sizeof line, help))
        for (at = strstr(line, "--"); at; at = strstr(at + n, "--")) {
            for (n = 2; islower((unsigned char)at[n]) || at[n] == '-'; n++)
                ;
            put("\\x09", at, n, at[n] == '=' ? "=" : "\\x09");
        }
    fclose(help);
}

int main(void)
{
    static const char *const others[] = {
        "..",   ",",      " at ",    " deg",   "mm",    "N/mm2", "rpm",  "%",   "inf",    "nan",
        "1e30", "1e-300", "uniform", "normal", "\\x0c", "360",   "file", "mid", "(1, 2)", "+-"};
    size_t i;

    put_schema();
    put_names("mechanism = four-bar\n[ground]\nlength = 3\n[crank]\nlength = 1\nmass = 1\n"
              "[coupler]\nlength = 3\n[rocker]\nlength = 3\n[motion]\nspeed = 1\n");
    put_names("mechanism = slider-crank\n[crank]\nlength = 1\n[rod]\nlength = 3\nmass = 1\n"
              "[motion]\nspeed = 1\n[gas]\nbore = 1\npressure = 1\n");
    put_names("mechanism = inverted-slider-crank\n[ground]\nlength = 3\n[crank]\nlength = 1\n"
              "[slider]\nmass = 1\n[motion]\nspeed = 1\n");
    put_names("mechanism = four-bar\n[ground]\nlength = 3\n[crank]\nlength = 1\nmass = 1\n"
              "cg = 1\n[coupler]\nlength = 3\n[rocker]\nlength = 3\n[motion]\nmode = run-up\n"
              "[motor]\nstall_torque = 9\nno_load_speed = 9\n[load]\nlink = rocker\n"
              "torque = -1\nover = omega4\nat_speed = 1\n");
    put_options();
    for (i = 0; i < sizeof others / sizeof others[0]; i++)
        put_word(others[i]);
    return 0;
}
