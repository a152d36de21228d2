/* SPDX-License-Identifier: GPL-3.0-or-later
**
** solutions.c - the solutions of a [synthesis] as a table, a line for each: written as designs of a
** sweep are.
*/
#include <string.h>

#include "system/memory.h"
#include "command.h"
#include "tables/content.h"
#include "terminal.h"
#include "solutions.h"
#include "view/results.h"

#define MOST_SOLUTIONS 100

/* Open solution `number` of the task, from 1. */
static int open_solution(const input *in, unsigned long number, fourlink_results **results,
                         fourlink_mistake *mistake)
{
    fourlink_source source = in->source;

    source.synthesis = number;
    return results_open(&source, mistake != NULL, results, mistake, NULL);
}

/* Write solution k, from 0, of a task that keeps it, or is null; 0 if out of memory. */
static int write_solution(sheet *s, const input *in, const fourlink_results *task, unsigned long k)
{
    fourlink_results *results = NULL;
    fourlink_mistake mistake;
    int status = task ? results_design(task, k, 1, &results, &mistake, NULL)
                      : open_solution(in, k + 1, &results, &mistake);

    if (status != FOURLINK_OK && status != FOURLINK_BAD_DECK)
        return 0;
    content_write_design(s, results, in->results, k, NULL, mistake.message);
    fourlink_results_free(results);
    return !memory_has_failed();
}

int solutions_write(FILE *out, const input *in)
{
    unsigned long n = 0, chosen, k;
    fourlink_results *task = NULL;
    int enough = 1;
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
    open_solution(in, n, &task, NULL); /* it keeps all; null if the last one is no deck */
    for (k = 0; k < n && enough; k++)
        enough = write_solution(&s, in, task, k);
    fourlink_results_free(task);
    return enough ? 0 : command_lacks_memory("cannot analyse", in->name);
}
