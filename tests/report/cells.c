/* SPDX-License-Identifier: GPL-3.0-or-later
**
** cells.c REPORT - the tables of a report: "table<tab>CLASS<tab>TITLE", then "row<tab>CELL<tab>CELL..." of each row of its body.
** A name that is typeset is printed as the deck has it.
*/
#include "xml.h"

static void put_rows(const xml_node *table)
{
    const xml_node *row, *cell;
    char words[2000];

    for (row = xml_next_named(table, table, "tr"); row; row = xml_next_named(row, table, "tr")) {
        if (!xml_is(row->parent, "tbody"))
            continue;
        printf("row");
        for (cell = row->first; cell; cell = cell->next)
            if (cell->name[0])
                printf("\t%s", xml_get(cell, "data-name") ? xml_get(cell, "data-name")
                                                          : xml_words(cell, words, sizeof words));
        printf("\n");
    }
}

int main(int argc, char **argv)
{
    const xml_node *x, *summary = NULL, *caption;
    xml_document d;
    char title[500];
    int is_good = xml_read(&d, argc > 1 ? argv[1] : "");

    if (!is_good)
        printf("%s\n", d.wrong);
    for (x = d.root; is_good && x; x = xml_next(x, d.root)) {
        if (xml_is(x, "summary"))
            summary = x;
        if (!xml_is(x, "table"))
            continue;
        caption = xml_next_named(x, x, "caption");
        if (!caption)
            caption = summary;
        printf("table\t%s\t%s\n", xml_get(x, "class") ? xml_get(x, "class") : "",
               caption ? xml_words(caption, title, sizeof title) : "");
        put_rows(x);
    }
    xml_free(&d);
    return !is_good;
}
