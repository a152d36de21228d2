/* SPDX-License-Identifier: GPL-3.0-or-later
**
** quiz_file.c - the file of --quiz: a question for each design of a deck, or for the deck.
*/
#include <string.h>

#include "system/system.h"
#include "command.h"
#include "files.h"
#include "input.h"
#include "output.h"
#include "quiz_file.h"
#include "report/quiz.h"
#include "view/results.h"

/* Print why there is no question; returns the exit status. */
static int refuse(const input *in, const fourlink_mistake *why, int status)
{
    command_tell("error", why->file[0] ? why->file : in->name, why->line, why->message, NULL);
    return status;
}

/* Write the question of a design, from 1, or with 0 of the deck, which is open; returns the exit status. */
static int write_question(FILE *out, const input *in, const char *title, unsigned long design)
{
    fourlink_source source = in->source;
    fourlink_results *own = NULL;
    fourlink_mistake why;
    int status = FOURLINK_OK;

    if (design) {
        source.design = design - 1;
        status = results_design(in->results, source.design, 1, &own, &why, NULL);
    }
    if (status != FOURLINK_OK)
        return status == FOURLINK_NO_MEMORY ? command_lacks_memory("cannot write", in->o->quiz)
                                            : refuse(in, &why, EXIT_USAGE);
    status = quiz_put_question(out, title, &source, own ? own : in->results, design, &why);
    fourlink_results_free(own);
    return status > 0   ? 0
           : status < 0 ? command_lacks_memory("cannot write", in->o->quiz)
                        : refuse(in, &why, EXIT_ROWS);
}

static int write_questions(FILE *out, const input *in)
{
    const char *title = in->problem.title[0] ? in->problem.title : files_name(in->name);
    unsigned long n = in->problem.n_designs, i;
    int status = 0;

    quiz_begin(out, title);
    for (i = n > 0; i <= n && !status && !system_caught(); i++)
        status = write_question(out, in, title, i);
    quiz_end(out);
    return status;
}

int quiz_file_write(const options *o)
{
    static const grade_answers none;
    output out;
    input in;
    int status;

    memset(&in, 0, sizeof in);
    status = input_read(&in, o->decks[0], o, &none, NULL);
    if (in.results) {
        status = output_begin(&out, o->quiz);
        if (!status) {
            status = write_questions(out.file, &in);
            status =
                command_worse(status, output_end(&out, o->quiz, status == 0 && !system_caught()));
        }
    }
    input_close(&in);
    return status;
}
