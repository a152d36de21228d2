/* SPDX-License-Identifier: GPL-3.0-or-later
**
** reader.c - the reader of decks: from a text to a problem to solve, or to mistakes.
**
** It makes three passes: lines to settings, each a text and its place (lines.c, settings.c); texts to values,
** by the forms of schema.h and in the deck's units (values.c); values to a problem (build_*.c).  A mistake
** does not end the reading, so that one run reports all of them.
*/
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/spelling.h"
#include "reader.h"

void *flk_reader_keep(parser *p, size_t size)
{
    void *result = flk_deck_keep(p->d, size);

    if (!result)
        p->out_of_memory = 1;
    return result;
}

char *flk_reader_copy(parser *p, text t, const char *ending)
{
    char *copy = flk_reader_keep(p, t.length + strlen(ending) + 1);

    if (!copy)
        return NULL;
    if (t.length)
        memcpy(copy, t.start, t.length);
    return strcpy(copy + t.length, ending) - t.length;
}

static text spell(parser *p, text t, text spelling(text, char *))
{
    char *copy = flk_spelling_is_plain(t) ? NULL : flk_reader_keep(p, SPELLING_SIZE(t.length));

    return copy ? spelling(t, copy) : t;
}

text flk_reader_plain(parser *p, text t)
{
    return spell(p, t, flk_spelling_plain);
}

text flk_reader_blanks(parser *p, text t)
{
    return spell(p, t, flk_spelling_blanks);
}

size_t flk_reader_mistakes(const parser *p)
{
    return p->mistakes->count + p->mistakes->left_out;
}

text_place flk_reader_end(const parser *p)
{
    text_place place;

    place.source = p->name;
    place.line = p->last_line;
    return place;
}

/* [SECTION[ NAME].]KEY=VALUE */
static void change(parser *p, const fourlink_change *c)
{
    const char *assignment = flk_reader_copy(p, flk_text_of(c->assignment), "");
    text key, value;
    text_place place;

    place.source = flk_reader_copy(p, flk_text_of(c->origin), "");
    place.line = 0;
    if (p->out_of_memory)
        return;
    value = flk_text_of(assignment);
    flk_text_split(&value, '=', &key);
    if (value.start)
        flk_setting_assign(p, place, flk_text_trim(key), flk_text_trim(value));
    else
        flk_mistake(p->mistakes, place, "expected [SECTION.]KEY=VALUE, not '%t'",
                    flk_text_of(assignment));
}

static void build(parser *p)
{
    flk_text_copy(flk_setting_find(p, KEY_TOP_TITLE)->value, p->d->title, sizeof p->d->title);
    if (!flk_build_kind(p))
        return;
    p->d->machine.cycle = flk_setting_or(p, KEY_MOTION_CYCLE, 2 * M_PI);
    flk_build_mechanism(p);
    flk_build_loads(p);
    flk_build_balance(p);
    flk_build_springs(p);
    flk_build_gas(p);
    flk_build_friction(p);
    flk_machine_finish(&p->d->machine);
    flk_build_points(p);
    flk_build_series(p);
    flk_build_motor(p);
    flk_build_motion(p);
    flk_build_flywheel(p);
    flk_build_table(p);
    flk_build_curve_ends(p);
    flk_build_expectations(p);
}

/* Read the lines of a copy of the text. */
static void read_lines(parser *p, const char *start, unsigned long length)
{
    text contents;
    char *copy;

    contents.start = start;
    contents.length = length;
    copy = flk_reader_copy(p, contents, "");
    contents.start = copy;
    if (copy)
        flk_lines_read(p, contents, copy);
}

static void read_deck(parser *p, const fourlink_source *source)
{
    unsigned long i;

    read_lines(p, source->text, source->length);
    for (i = 0; i < source->n_changes && !p->out_of_memory; i++)
        change(p, &source->changes[i]);
    if (!p->out_of_memory)
        flk_values_read(p, 1);
    if (!p->out_of_memory && !p->not_text)
        flk_sweep_read(p, source->design);
    if (!p->out_of_memory)
        flk_values_read(p, 0);
    if (!p->out_of_memory && !p->not_text)
        build(p);
}

/* Read the [expect] and [misprint] sections of another text, instead of the deck's. */
static void read_answers(parser *p, const fourlink_source *source)
{
    p->expectations_only = 1;
    p->d->n_expectations = 0;
    read_lines(p, source->answers, source->answers_length);
    if (!p->out_of_memory)
        flk_values_read(p, 0);
    if (!p->out_of_memory)
        flk_build_expectations(p);
}

/* Read one text of a source; 1, or 0 if out of memory. */
static int run(deck *d, const fourlink_source *source, const char *name,
               void read(parser *, const fourlink_source *))
{
    parser p;

    memset(&p, 0, sizeof p);
    p.d = d;
    p.mistakes = &d->mistakes;
    p.load = source->load;
    p.host = source->host;
    p.name = flk_reader_copy(&p, flk_text_of(name ? name : ""), "");
    if (!p.out_of_memory)
        read(&p, source);
    flk_mistakes_sort(p.mistakes);
    flk_mistakes_sort(&d->notes);
    free(p.uses);
    free(p.named);
    free(p.named_slots);
    return !p.out_of_memory && !d->mistakes.out_of_memory && !d->notes.out_of_memory;
}

int flk_deck_read(const fourlink_source *source, deck *d)
{
    int all_read;

    flk_deck_start(d);
    all_read = run(d, source, source->name, read_deck);
    if (source->answers && all_read && !d->mistakes.count)
        all_read = run(d, source, source->answers_name, read_answers);
    return all_read ? d->mistakes.count == 0 : -1;
}
