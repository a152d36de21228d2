/* SPDX-License-Identifier: GPL-3.0-or-later
**
** random_decks.c - writes random decks into a folder, each from its own number; the same of each compiler.
**
**    random_decks SORT N FOLDER [FIRST]
**
** SORT is `given`, motions that are given (random_deck.h), `machines`, of all kinds, or `motors`, whose motion follows
** from what drives them (random_machine.h).  The decks are FOLDER/SORT-FIRST.deck and on.
*/
#include "random_machine.h"

int main(int argc, char **argv)
{
    long n, first, i;
    char name[1000];
    FILE *out;

    if (argc < 4) {
        fprintf(stderr, "usage: random_decks given|machines|motors N FOLDER [FIRST]\n");
        return 2;
    }
    n = atol(argv[2]);
    first = argc > 4 ? atol(argv[4]) : 0;
    for (i = first; i < first + n; i++) {
        begin_chance(1, i);
        if (strcmp(argv[1], "given") == 0)
            make_deck();
        else if (strcmp(argv[1], "machines") == 0)
            make_any_machine(i);
        else if (strcmp(argv[1], "motors") == 0)
            make_driven_machine(i);
        else {
            fprintf(stderr, "random_decks: no decks of the sort '%s'\n", argv[1]);
            return 2;
        }
        snprintf(name, sizeof name, "%s/%s-%ld.deck", argv[3], argv[1], i);
        out = fopen(name, "w");
        if (!out || fwrite(text, 1, length, out) != length || fclose(out) != 0) {
            fprintf(stderr, "random_decks: cannot write %s\n", name);
            return 3;
        }
    }
    return 0;
}
