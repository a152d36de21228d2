/* SPDX-License-Identifier: GPL-3.0-or-later
**
** copied.c - answers that belong to the deck of another: each other deck is compared with them.
*/
#include <string.h>

#include "command.h"
#include "copied.h"
#include "view/results.h"

#define FEWEST 3 /* values that agree: fewer may agree by chance */

static unsigned long count_agreeing(const input *in)
{
    unsigned long n = 0, i;
    fourlink_check c;

    for (i = 0; i < in->problem.n_expected; i++) {
        results_check(in->results, i, &c);
        n += c.verdict == FOURLINK_AGREES;
    }
    return n;
}

const char *copied_from(const input *in, unsigned long *n_agree)
{
    unsigned long best = count_agreeing(in), least = (2 * in->problem.n_expected + 2) / 3, n;
    const char *found = NULL;
    grade_answers answers;
    input other;
    size_t j;

    memset(&answers, 0, sizeof answers);
    answers.text = (char *)in->source.answers;
    answers.length = (size_t)in->source.answers_length;
    command_be_silent(1);
    for (j = 0; j < in->o->n_decks; j++) {
        if (strcmp(in->o->decks[j], in->name) == 0 || strcmp(in->o->decks[j], "-") == 0)
            continue;
        memset(&other, 0, sizeof other);
        input_read(&other, in->o->decks[j], in->o, &answers, NULL);
        n = other.results ? count_agreeing(&other) : 0;
        if (n > best && n >= least && n >= FEWEST) {
            best = *n_agree = n;
            found = in->o->decks[j];
        }
        input_close(&other);
    }
    command_be_silent(0);
    return found;
}
