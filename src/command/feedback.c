/* SPDX-License-Identifier: GPL-3.0-or-later
**
** feedback.c - a text for each student: what was asked, given, right or wrong, and why.
**
** Computed values are in it only with feedback = answers in [grading].
*/
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "system/memory.h"
#include "command.h"
#include "feedback.h"
#include "files.h"
#include "output.h"
#include "view/results.h"

#define NAME 24
#define GIVEN 20

/* Write the line of a question: the answers of the input to it, or that there is none. */
static void put_question(line *l, const marks *m, const input *in, unsigned long i)
{
    const sheet_question *q = &m->questions[i];
    int n = 0;
    fourlink_check c;
    unsigned long k;

    for (k = 0; in->results && k < in->problem.n_expected; k++) {
        results_check(in->results, k, &c);
        if (marks_question(m, &c) != (long)i)
            continue;
        n++;
        line_left(l, q->name, NAME);
        line_put(l, " ");
        line_left(l, c.printed_text, GIVEN);
        line_put(l, c.verdict == FOURLINK_AGREES ? " right" : " wrong");
        line_put(l, ", %9g of %9g", c.verdict == FOURLINK_AGREES ? q->of : 0, q->of);
        if (in->problem.shows_answers && c.verdict == FOURLINK_DIFFERS && !c.words[0])
            line_put(l, "; computed %9g %s", c.computed, c.unit);
        if (c.verdict == FOURLINK_NO_VALUE)
            line_put(l, ": %s", c.message);
        else if (c.hint[0])
            line_put(l, ": %s", c.hint);
        line_put(l, "\n");
    }
    if (n)
        return;
    line_left(l, q->name, NAME);
    line_put(l, " no answer, 0 of %9g\n", q->of);
}

static void put_text(line *l, const marks *m, const input *in, const sheet_mark *mark)
{
    unsigned long i;

    if (in->results && in->problem.title[0])
        line_put(l, "%s\n", in->problem.title);
    line_put(l, "%s: %9g of %9g marks\n", mark->name, mark->right, mark->of);
    if (!in->results)
        line_put(l, "%s\n", in->refusal);
    else if (in->remarks[0])
        line_put(l, "%s\n", in->remarks);
    line_put(l, "\n");
    for (i = 0; i < m->n; i++)
        put_question(l, m, in, i);
}

int feedback_write(const marks *m, const input *in, const sheet_mark *mark)
{
    const char *folder = m->o->feedback;
    char *path = files_within(folder, flk_text_of(mark->name), ".txt");
    line *l = memory_get(1, sizeof *l);
    output out;
    int status;

    status = path && l ? output_begin(&out, path) : command_lacks_memory("cannot write", folder);
    if (!status) {
        line_start(l, out.file);
        put_text(l, m, in, mark);
        line_end(l);
        status = output_end(&out, path, 1);
    }
    free(l);
    free(path);
    return status;
}
