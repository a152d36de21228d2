/* SPDX-License-Identifier: GPL-3.0-or-later
**
** designs.c - the designs of a deck's [sweep], one after the other.
**
** Every design is a deck of its own, built from the same settings.  Its output depends on its number
** alone, so the parts joined are the whole, and memory holds one design.
*/
#include <stdlib.h>
#include <string.h>

#include "system/memory.h"
#include "system/system.h"
#include "command.h"
#include "terminal.h"
#include "tables/content.h"
#include "designs.h"
#include "view/results.h"

/* The end of part k of n: k D / n, rounded down.  n is at most 10^6, so the product is exact. */
static unsigned long end_of_part(unsigned long designs, unsigned long k, unsigned long n)
{
    return designs / n * k + (unsigned long)((double)(designs % n) * (double)k / (double)n);
}

/* Write one design; 0 if out of memory. */
static int write_design(sheet *s, const input *in, unsigned long i, double *varied)
{
    fourlink_results *results = NULL;
    fourlink_mistake mistake;
    int status = results_design(in->results, i, 1, &results, &mistake, NULL);

    if (status != FOURLINK_OK && status != FOURLINK_BAD_DECK)
        return 0;
    fourlink_results_variables(in->results, i, s->n_variables, varied, NULL, NULL);
    content_write_design(s, results, in->results, i, varied, mistake.message);
    fourlink_results_free(results);
    return !memory_has_failed();
}

static int write_all(sheet *s, const input *in, double *varied)
{
    unsigned long n = in->problem.n_designs, parts = in->o->parts ? in->o->parts : 1;
    unsigned long part = in->o->parts ? in->o->part : 1, i;
    unsigned long from = end_of_part(n, part - 1, parts), to = end_of_part(n, part, parts);
    FILE *out = s->l.out;
    progress p;
    int enough = 1;

    progress_begin(&p, out);
    for (i = from; i < to && enough && !system_caught() && !ferror(out); i++) {
        enough = write_design(s, in, i, varied);
        progress_tell(&p, i + 1 - from, to - from);
    }
    progress_end(&p);
    return enough;
}

/* The outputs and, with a yield, whether they meet it; null if out of memory. */
static fourlink_value *header_of(sheet *s, const input *in)
{
    const fourlink_value *list;
    fourlink_value *header;
    unsigned long n;

    fourlink_results_list(
        in->results, s->content == SHEET_DESIGNS ? FOURLINK_OUTPUTS : FOURLINK_COLUMNS, &list, &n);
    header = memory_get(n + 1, sizeof *header);
    if (!header)
        return NULL;
    memcpy(header, list, n * sizeof *header);
    if (s->content == SHEET_DESIGNS)
        fourlink_results_list(in->results, FOURLINK_CONDITIONS, &s->conditions, &s->n_conditions);
    if (s->n_conditions) {
        memset(&header[n], 0, sizeof header[n]);
        header[n].name = "yield";
        header[n].unit = "1";
        header[n].quantity = "number";
        header[n++].meaning = "1: the outputs meet the yield";
    }
    s->n_header = n;
    return header;
}

/* Set up a sheet of designs: of their outputs, or of their rows. */
static void set_up(sheet *s, FILE *out, const input *in)
{
    memset(s, 0, sizeof *s);
    s->format = in->o->format;
    terminal_set_up(s, out, in->o->wide, in->o->colour);
    s->content = in->problem.has_outputs ? SHEET_DESIGNS : SHEET_ROWS;
    s->at = in->o->at;
    view_take(&s->v, in->results);
    fourlink_results_list(in->results, FOURLINK_VARIABLES, &s->variables, &s->n_variables);
}

int designs_write(FILE *out, const input *in)
{
    fourlink_value *header;
    double *varied;
    int enough;
    sheet s;

    set_up(&s, out, in);
    s.header = header = header_of(&s, in);
    varied = memory_get(s.n_variables + 1, sizeof *varied);
    enough = header && varied;
    system_catch(1);
    if (enough) {
        content_begin(&s, out, !in->o->parts || in->o->part == 1);
        enough = write_all(&s, in, varied);
    }
    system_catch(0);
    free(varied);
    free(header);
    if (!enough)
        return command_lacks_memory("cannot analyse", in->name);
    if (system_caught())
        return command_complain("stopped", in->name,
                                in->o->parts ? "interrupted; run this part again" : "interrupted");
    return s.failed ? EXIT_ROWS : 0;
}
