/* SPDX-License-Identifier: GPL-3.0-or-later
**
** csv.c - rows to text: the format csv, RFC 4180.
*/
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "base/format.h"
#include "print.h"
#include "table.h"

void csv_heading(row_buffer *row, text name, const char *unit_name)
{
    char whole[400], field[500];

    row_field(row, flk_text_join(field, sizeof field, flk_text_copy(name, whole, sizeof whole),
                                 " (", unit_name, ")", (char *)NULL));
}

void csv_put_label_names(row_buffer *row, const deck *d, const csv_labels *labels)
{
    size_t j;

    if (labels->deck_name)
        row_text(row, "deck,", 5);
    if (labels->sweep)
        row_text(row, "design,", 7);
    for (j = 0; labels->sweep && j < labels->sweep->n_variables; j++) {
        const deck_variable *v = &labels->sweep->variables[j];

        csv_heading(row, v->name, d->units[v->q].name);
        row_text(row, ",", 1);
    }
}

void csv_print_header(FILE *out, const deck *d, const column_list *header, const csv_labels *labels)
{
    row_buffer row;
    size_t j;

    row_start(&row, out);
    csv_put_label_names(&row, d, labels);
    row_text(&row, "branch", 6);
    for (j = 0; j < header->count; j++) {
        row_text(&row, ",", 1);
        csv_heading(&row, flk_text_of(header->list[j].name), header->list[j].unit);
    }
    row_text(&row, ",status\r\n", 9);
    row_end(&row);
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

void csv_put_number(row_buffer *row, double x)
{
    char number[FORMAT_SIZE];

    row_text(row, number, (size_t)(format_general_end(x + 0.0, DBL_DIG + 2, number) - number));
}

void csv_put_labels(row_buffer *row, const csv_labels *labels)
{
    size_t j;

    if (labels->deck_name) {
        row_field(row, labels->deck_name);
        row_text(row, ",", 1);
    }
    if (!labels->sweep)
        return;
    csv_put_number(row, (double)labels->design + 1);
    row_text(row, ",", 1);
    for (j = 0; j < labels->sweep->n_variables; j++) {
        csv_put_number(row, labels->sweep->variables[j].value);
        row_text(row, ",", 1);
    }
}

/* r null: a line with nothing but a reason in it. */
static void put_csv_row(FILE *out, const column **map, size_t n, const csv_labels *labels,
                        fourlink_branch branch, const result *r, const char *status)
{
    row_buffer row;
    size_t j;

    row_start(&row, out);
    csv_put_labels(&row, labels);
    row_field(&row, branch_name(branch));
    for (j = 0; j < n; j++) {
        row_text(&row, ",", 1);
        if (r && map[j] && (r->status == FOURLINK_OK || column_of_crank(map[j])))
            csv_put_number(&row, column_value(map[j], r));
    }
    row_text(&row, ",", 1);
    row_field(&row, status);
    row_text(&row, "\r\n", 2);
    row_end(&row);
}

void csv_print_reason(FILE *out, const column_list *header, const csv_labels *labels,
                      fourlink_branch branch, const char *why)
{
    put_csv_row(out, NULL, header->count, labels, branch, NULL, why);
}

int csv_print(FILE *out, analysis *a, const column_list *columns, const column_list *header,
              const csv_labels *labels, unsigned long *failed)
{
    const column **map = map_columns(columns, header);
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i, enough;
    unsigned long k;
    char stop[FORMAT_SIZE + 80];
    result r;

    for (i = 0; map && i < n; i++) {
        for (k = 0; k < a->range.n_rows; k++) {
            analysis_row(a, branches[i], k, &r);
            put_csv_row(out, map, header->count, labels, branches[i], &r, print_status(&r));
            *failed += r.status != FOURLINK_OK;
        }
        if (a->range.stops) {
            put_csv_row(out, map, header->count, labels, branches[i], NULL, print_stop(a, stop));
            ++*failed;
        }
    }
    enough = map != NULL;
    free((void *)map);
    return enough;
}
