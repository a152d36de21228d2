/* SPDX-License-Identifier: GPL-3.0-or-later
**
** random_decks.c - writes random decks into a folder, each from its own number, but for `any`; the same of each compiler.
**
**    random_decks SORT N FOLDER [FIRST]
**    random_decks options
**
** SORT is `given`, wild machines whose motions are given, `machines`, of all kinds, `outputs`, machines with outputs by
** rods, `slots`, with outputs most of which hang by slots, `motors`, whose motion follows from what drives them, or `any`, with keys of every section of the schema
** (random_schema.h).  The decks
** are FOLDER/SORT-FIRST.deck and on.  Those of `any` depend on those before them in the run, so that all keys are drawn
** as often: FIRST and N give them again.  Beside a deck of the sort `any` stand options for it, one a line, in .options, and the
** card that decks name; what was tried how often is printed.  `options` prints the options that it knows.
*/
#include "random_outputs.h"
#include "random_schema.h"

static FILE *open_file(const char *folder, const char *sort, long i, const char *ending)
{
    char name[1000];
    FILE *out;

    snprintf(name, sizeof name, "%s/%s-%ld.%s", folder, sort, i, ending);
    out = fopen(name, "w");
    if (!out) {
        fprintf(stderr, "random_decks: cannot write %s\n", name);
        exit(3);
    }
    return out;
}

static void close_file(FILE *out)
{
    if (ferror(out) || fclose(out) != 0) {
        fprintf(stderr, "random_decks: cannot write\n");
        exit(3);
    }
}

/* The card that decks name, beside them. */
static void write_card(const char *folder)
{
    char name[1000];
    unsigned long size;
    const char *card = load_card(NULL, "card.csv", &size);
    FILE *out;

    snprintf(name, sizeof name, "%s/card.csv", folder);
    out = fopen(name, "w");
    if (out)
        fwrite(card, 1, size, out);
    if (!out || fclose(out) != 0)
        fprintf(stderr, "random_decks: cannot write %s\n", name);
}

int main(int argc, char **argv)
{
    long n, first, i;
    int o, is_any;
    FILE *out;

    has_other_words = 1;
    if (argc == 2 && strcmp(argv[1], "options") == 0) {
        for (o = 0; o < N_OPTIONS; o++)
            printf("%s\n", known_options[o].name);
        return 0;
    }

    if (argc < 4) {
        fprintf(stderr,
                "usage: random_decks given|machines|outputs|slots|motors|any N FOLDER [FIRST]\n");
        return 2;
    }
    n = atol(argv[2]);
    first = argc > 4 ? atol(argv[4]) : 0;
    is_any = strcmp(argv[1], "any") == 0;
    for (i = first; i < first + n; i++) {
        begin_chance(1, i);
        if (strcmp(argv[1], "given") == 0)
            make_wild_deck(i);
        else if (strcmp(argv[1], "machines") == 0)
            make_machine(i, LAWS | SPRINGS | FRICTION, seldom(0.25) ? DRIVEN : GIVEN);
        else if (strcmp(argv[1], "outputs") == 0)
            make_machine_with_outputs(i, 0);
        else if (strcmp(argv[1], "slots") == 0)
            make_machine_with_outputs(i, 1);
        else if (strcmp(argv[1], "motors") == 0)
            make_machine(i, LAWS | SPRINGS | FRICTION | GAS, DRIVEN);
        else if (is_any)
            make_schema_deck(i, 12 + one_of(30));
        else {
            fprintf(stderr, "random_decks: no decks of the sort '%s'\n", argv[1]);
            return 2;
        }
        out = open_file(argv[3], argv[1], i, "deck");
        fwrite(deck_text, 1, length, out);
        close_file(out);
        if (is_any) {
            out = open_file(argv[3], argv[1], i, "options");
            write_options(out);
            close_file(out);
        }
    }
    if (is_any) {
        write_card(argv[3]);
        tell_evenness();
    }
    return 0;
}
