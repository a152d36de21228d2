/* SPDX-License-Identifier: GPL-3.0-or-later
**
** reader.c - the reader of decks: from a text to a problem to solve, or to mistakes.
**
** It makes three passes: lines to settings, each a text and its place (lines.c, settings.c); texts to values,
** by the forms of schema.h and in the deck's units (values.c); values to a problem (build_*.c).  A mistake
** does not end the reading, so that one run reports all of them.
*/
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
    p->text.start = flk_reader_copy(p, contents, "");
    p->text.length = length;
    p->copy = contents.start = copy = flk_reader_copy(p, contents, "");
    if (p->text.start && copy)
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
        flk_sweep_read(p);
    if (!p->out_of_memory)
        flk_values_read(p, 0);
    p->is_sound = !flk_reader_mistakes(p);
}

/* Build a design of the deck, from 0; of a deck without [sweep] the only one. */
static void build_design(parser *p, unsigned long design)
{
    if (p->d->sweep.n_designs)
        flk_sweep_assign(p, design);
    if (!p->out_of_memory)
        flk_values_read(p, 0);
    if (!p->out_of_memory && !p->not_text)
        build(p);
}

/* Read the [expect] and [misprint] sections of another text, instead of the deck's. */
static void read_answers(parser *p, const fourlink_source *source)
{
    p->expectations_only = 1;
    read_lines(p, source->answers, source->answers_length);
    if (!p->out_of_memory)
        flk_values_read(p, 0);
}

static void build_answers(parser *p)
{
    p->d->n_expectations = 0;
    if (!p->out_of_memory)
        flk_build_expectations(p);
}

/* A reader of a text of the deck, or one that has the settings of another; null if out of memory. */
static parser *open_reader(deck *d, const parser *from)
{
    parser *p = flk_deck_keep(d, sizeof *p);

    if (!p)
        return NULL;
    if (from)
        *p = *from;
    p->d = d;
    p->mistakes = &d->mistakes;
    return p;
}

static parser *open_text(deck *d, const fourlink_source *source, const char *name)
{
    parser *p = open_reader(d, NULL);

    if (!p)
        return NULL;
    p->load = source->load;
    p->host = source->host;
    p->name = flk_reader_copy(p, flk_text_of(name ? name : ""), "");
    return p;
}

/* What flk_deck_read returns; p is null if out of memory. */
static int status_of(deck *d, const parser *p)
{
    flk_mistakes_sort(&d->mistakes);
    flk_mistakes_sort(&d->notes);
    if (!p || p->out_of_memory || d->mistakes.out_of_memory || d->notes.out_of_memory)
        return -1;
    return d->mistakes.count == 0;
}

int flk_deck_read(const fourlink_source *source, deck *d)
{
    int status;

    flk_deck_start(d);
    d->settings = open_text(d, source, source->name);
    if (d->settings && !d->settings->out_of_memory) {
        read_deck(d->settings, source);
        build_design(d->settings, source->design);
    }
    status = status_of(d, d->settings);
    if (!source->answers || status != 1)
        return status;
    d->answers = open_text(d, source, source->answers_name);
    if (d->answers && !d->answers->out_of_memory) {
        read_answers(d->answers, source);
        build_answers(d->answers);
    }
    return status_of(d, d->answers);
}

/* The sections of a design, whose settings are those of its deck until one is set; 0 if out of memory. */
static int share_sections(parser *p)
{
    const section_use *from = p->uses;
    size_t i;

    p->uses = flk_reader_keep(p, p->n_uses * sizeof *p->uses);
    for (i = 0; i < p->n_uses && p->uses; i++) {
        p->uses[i] = from[i];
        p->uses[i].is_shared = 1;
        p->uses[i].is_mistaken = 0; /* a mistake of another design */
    }
    return p->uses != NULL;
}

int flk_deck_design(const deck *from, unsigned long design, deck *d)
{
    int status;

    memset(d, 0, sizeof *d);
    if (!from->settings->is_sound)
        return 0;
    memcpy(d->units, from->units, sizeof d->units);
    d->sweep = from->sweep;
    d->settings = open_reader(d, from->settings);
    if (d->settings && share_sections(d->settings))
        build_design(d->settings, design);
    status = status_of(d, d->settings);
    if (!from->answers || status != 1)
        return status;
    d->answers = open_reader(d, from->answers);
    if (d->answers)
        build_answers(d->answers);
    return status_of(d, d->answers);
}
