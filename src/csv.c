/* SPDX-License-Identifier: GPL-3.0-or-later
**
** csv.c - rows to text: the format csv, RFC 4180.
*/
#include <float.h>
#include <stdlib.h>

#include "number.h"
#include "print.h"
#include "table.h"

void csv_print_header(FILE *out, const column_list *header, int with_deck)
{
    char field[2 * DECK_NAME_SIZE];
    size_t j;

    if (with_deck)
        fputs("deck,", out);
    fputs("branch", out);
    for (j = 0; j < header->count; j++) {
        sprintf(field, "%.60s (%.60s)", header->list[j].name, header->list[j].unit);
        putc(',', out);
        print_field(out, field);
    }
    fputs(",status\r\n", out);
}

/* For each column of the header, the deck's column that it is; null if it has none. */
static const column **map_columns(const column_list *columns, const column_list *header)
{
    const column **map = malloc((header->count + 1) * sizeof *map);
    size_t i, j;

    for (j = 0; map && j < header->count; j++) {
        map[j] = NULL;
        for (i = 0; i < columns->count; i++)
            if (columns_are_same(&header->list[j], &columns->list[i]))
                map[j] = &columns->list[i];
    }
    return map;
}

/* r null: a line with nothing but a reason in it. */
static void put_csv_row(FILE *out, const column **map, size_t n, const char *deck_name,
                        fourlink_branch branch, const result *r, const char *status)
{
    char number[NUMBER_SIZE];
    size_t j;

    if (deck_name) {
        print_field(out, deck_name);
        putc(',', out);
    }
    fputs(branch_name(branch), out);
    for (j = 0; j < n; j++) {
        putc(',', out);
        if (map[j] && r && (r->status == FOURLINK_OK || column_of_crank(map[j])))
            fputs(number_general(column_value(map[j], r) + 0.0, DBL_DIG + 2, number), out);
    }
    putc(',', out);
    print_field(out, status);
    fputs("\r\n", out);
}

int csv_print(FILE *out, analysis *a, const column_list *columns, const column_list *header,
              const char *deck_name, unsigned long *failed)
{
    const column **map = map_columns(columns, header);
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i, enough;
    unsigned long k;
    char stop[NUMBER_SIZE + 80];
    result r;

    for (i = 0; map && i < n; i++) {
        for (k = 0; k < a->range.n_rows; k++) {
            analysis_row(a, branches[i], k, &r);
            put_csv_row(out, map, header->count, deck_name, branches[i], &r, print_status(&r));
            *failed += r.status != FOURLINK_OK;
        }
        if (a->range.stops) {
            put_csv_row(out, map, header->count, deck_name, branches[i], NULL, print_stop(a, stop));
            ++*failed;
        }
    }
    enough = map != NULL;
    free((void *)map);
    return enough;
}
