/* SPDX-License-Identifier: GPL-3.0-or-later
**
** solutions.c - the solutions of a [synthesis] as a table, a line for each: written as designs of a sweep are.
*/
#include <string.h>

#include "command.h"
#include "tables/content.h"
#include "terminal.h"
#include "writers.h"

#define MOST_SOLUTIONS 100
#define MOST_COLUMNS 12

/* The facts of a solution that it has; returns their number. */
static unsigned long find_columns(fourlink_results *r, fourlink_branch branch, fourlink_value *list)
{
    static const char *const names[MOST_COLUMNS] = {
        "ground_length", "crank_length", "coupler_length", "rocker_length", "line_offset",
        "type",          "mu_range",     "theta4_error",   "x_error",       "defects"};
    fourlink_value value;
    unsigned long n = 0;
    int i;

    for (i = 0; i < MOST_COLUMNS && names[i]; i++)
        if (fourlink_results_value(r, names[i], branch, 0, &value) == FOURLINK_OK)
            list[n++] = value;
    return n;
}

/* Write solution k of n; 0 if out of memory. */
static int write_solution(sheet *s, const input *in, unsigned long k)
{
    fourlink_source source = in->source;
    fourlink_results *results = NULL;
    fourlink_mistake mistake;
    int status;

    source.synthesis = k;
    status = fourlink_results_open(&source, 1, &results, &mistake, NULL);
    if (status != FOURLINK_OK && status != FOURLINK_BAD_DECK)
        return 0;
    content_write_design(s, results, in->results, k - 1, NULL, mistake.message);
    fourlink_results_free(results);
    return !s->out_of_memory;
}

int solutions_write(FILE *out, const input *in)
{
    fourlink_value columns[MOST_COLUMNS];
    unsigned long n = 0, chosen, k;
    int enough = 1;
    sheet s;

    memset(&s, 0, sizeof s);
    s.format = in->o->format;
    s.width = in->o->wide ? 0 : terminal_width(out);
    s.content = SHEET_DESIGNS;
    s.each = "solution";
    view_take(&s.v, in->results);
    s.header = columns;
    s.n_header = find_columns(in->results, s.v.branches[0], columns);
    fourlink_deck_solutions(fourlink_results_deck(in->results), 0, NULL, &chosen, &n);
    content_begin(&s, out, 1);
    for (k = 1; k <= n && k <= MOST_SOLUTIONS && enough; k++)
        enough = write_solution(&s, in, k);
    return enough ? 0 : command_complain("cannot analyse", in->name, "not enough memory");
}
