/* SPDX-License-Identifier: GPL-3.0-or-later
**
** solutions.c - the solutions of a [synthesis] as a table, a line for each: written as designs of a
** sweep are.
*/
#include <string.h>

#include "command.h"
#include "tables/content.h"
#include "terminal.h"
#include "solutions.h"

#define MOST_SOLUTIONS 100

/* The task with so many of its solutions; null without memory. */
static fourlink_results *open_task(const input *in, unsigned long n)
{
    fourlink_source source = in->source;
    fourlink_results *results = NULL;

    source.synthesis = n;
    fourlink_results_open(&source, 0, &results, NULL, NULL);
    return results;
}

/* Write solution k, from 0; 0 if out of memory. */
static int write_solution(sheet *s, const input *in, const fourlink_results *task, unsigned long k)
{
    fourlink_results *results = NULL;
    fourlink_mistake mistake;
    int status = fourlink_results_design(task, k, 1, &results, &mistake, NULL);

    if (status != FOURLINK_OK && status != FOURLINK_BAD_DECK)
        return 0;
    content_write_design(s, results, in->results, k, NULL, mistake.message);
    fourlink_results_free(results);
    return !s->out_of_memory;
}

int solutions_write(FILE *out, const input *in)
{
    unsigned long n = 0, chosen, k;
    fourlink_results *task;
    int enough;
    sheet s;

    memset(&s, 0, sizeof s);
    s.format = in->o->format;
    terminal_set_up(&s, out, in->o->wide, in->o->colour);
    s.content = SHEET_DESIGNS;
    s.each = "solution";
    view_take(&s.v, in->results);
    fourlink_results_list(in->results, FOURLINK_OUTPUTS, &s.header, &s.n_header);
    fourlink_deck_solutions(fourlink_results_deck(in->results), 0, NULL, &chosen, &n);
    n = n < MOST_SOLUTIONS ? n : MOST_SOLUTIONS;
    content_begin(&s, out, 1);
    task = open_task(in, n);
    enough = task != NULL;
    for (k = 0; k < n && enough; k++)
        enough = write_solution(&s, in, task, k);
    fourlink_results_free(task);
    return enough ? 0 : command_complain("cannot analyse", in->name, "not enough memory");
}
