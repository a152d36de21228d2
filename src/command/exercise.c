/* SPDX-License-Identifier: GPL-3.0-or-later
**
** exercise.c - the deck of an exercise: its [expect] says what is asked, its [grading] how it is marked.
**
** The decks of students are graded as the exercise says: each line of its [grading] is a change of theirs.
*/
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "system/memory.h"
#include "command.h"
#include "exercise.h"
#include "handout.h"

#define KEY "grading."

/* 1 if the command line sets what a change sets. */
static int is_set(const options *o, const char *assignment)
{
    size_t n = strcspn(assignment, "=") + 1, i;

    for (i = 0; i < o->n_changes; i++)
        if (strncmp(o->changes[i].assignment, assignment, n) == 0)
            return 1;
    return 0;
}

/* Write KEY=VALUE as a change, after the others; returns where the next goes. */
static char *add_change(exercise *x, text row, char *out)
{
    fourlink_change *change = &x->changes[x->of_answers.n_changes];
    text key, value;

    if (!flk_text_cut(row, "=", &key, &value) || row.start[0] == '#')
        return out;
    change->origin = x->deck.name;
    change->assignment = out;
    memcpy(out, KEY, sizeof KEY - 1);
    out += sizeof KEY - 1;
    memcpy(out, key.start, key.length);
    out += key.length;
    *out++ = '=';
    memcpy(out, value.start, value.length);
    out[value.length] = '\0';
    x->of_answers.n_changes += !is_set(x->deck.o, change->assignment);
    return out + value.length + 1;
}

/* Take the lines of [grading] as changes of the decks of students; 0 if out of memory. */
static int take_grading(exercise *x, const options *o)
{
    unsigned long length = 0;
    char *deck = input_deck_text(x->deck.results, &length), *out;
    int is_grading = 0;
    text rest, row, name;
    size_t n_lines;

    rest.start = deck;
    rest.length = deck ? length : 0;
    n_lines = flk_text_count(rest, '\n') + 1;
    x->text = out = memory_get(length + n_lines * sizeof KEY + 1, 1);
    x->changes = memory_get(o->n_changes + n_lines, sizeof *x->changes);
    if (deck && x->text && x->changes) {
        memcpy(x->changes, o->changes, o->n_changes * sizeof *o->changes);
        x->of_answers.changes = x->changes;
        while (flk_text_split(&rest, '\n', &row)) {
            row = flk_text_trim(row);
            if (handout_section(row, &name))
                is_grading = flk_text_equal(name, "grading");
            else if (is_grading && row.length)
                out = add_change(x, row, out);
        }
    }
    free(deck);
    return deck && x->text && x->changes;
}

int exercise_read(exercise *x, const options *o, const char *path)
{
    int status;

    memset(x, 0, sizeof *x);
    x->of_answers = *o;
    status = input_read_without(&x->deck, o, &x->of_deck, path, NULL);
    if (x->deck.results && !take_grading(x, o))
        status = command_lacks_memory("cannot read", path);
    return status;
}

void exercise_close(exercise *x)
{
    input_close(&x->deck);
    free(x->changes);
    free(x->text);
}
