/* SPDX-License-Identifier: GPL-3.0-or-later
**
** reader.c - the deck reader: from a text to a problem, or to a list of mistakes.
**
** It makes three passes: lines to settings, each a text and its place (lines.c, settings.c); texts to values,
** by the forms of schema.h and in the deck's units (values.c); values to a problem (build_*.c).  A mistake
** does not stop the reader, so that one run reports all of them.
**
** A deck keeps the parser of its text as long as it lives.  The last pass reads settings and writes only to
** the deck; a design of a [sweep], or a deck with numbers set, runs it again over settings that it shares
** with the first, of which it copies a section before it changes it.  Out of memory ends the reader between
** two passes.
*/
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/spelling.h"
#include "base/utf16.h"
#include "answers.h"
#include "build.h"
#include "build_synthesis.h"
#include "found.h"
#include "lines.h"
#include "numbers.h"
#include "parser.h"
#include "reader.h"
#include "settings.h"
#include "sweep.h"
#include "values.h"

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

/* Share the settings of another deck, for each section until one of its settings is changed.  Null if out of
** memory. */
static parser *share(deck *d, const parser *from)
{
    parser *p = flk_deck_keep(d, sizeof *p);
    section_use *uses = flk_deck_keep(d, from->n_uses * sizeof *uses);
    size_t i;

    if (!p || !uses)
        return NULL;
    *p = *from;
    p->d = d;
    p->is_design = 1;
    p->mistakes = p->is_answers ? &d->slips : &d->mistakes;
    p->uses = uses;
    p->uses_capacity = p->n_uses;
    for (i = 0; i < p->n_uses; i++) {
        uses[i] = from->uses[i];
        uses[i].is_shared = 1;
        uses[i].is_mistaken = 0; /* a mistake in the design of that deck */
    }
    return p;
}

/* Find the linkage of a task; returns the settings with its lengths, or null. */
static parser *find_linkage(parser *p)
{
    parser *found;

    if (flk_mistakes_count(p->mistakes) || !flk_synthesis_read(p) || !flk_synthesis_run(p))
        return NULL;
    p->d->found = found = share(p->d, p);
    if (!found) {
        p->out_of_memory = 1;
        return NULL;
    }
    found->is_design = p->is_design;
    flk_synthesis_assign(found);
    p->out_of_memory |= found->out_of_memory;
    return p->out_of_memory ? NULL : found;
}

#define BUILD(name) flk_build_##name(p);

/* Build the deck that the settings are of. */
static void build_all(parser *p)
{
    p->d->machine.cycle = flk_setting_or(p, KEY_MOTION_CYCLE, 2 * M_PI);
    p->d->mode.kind = flk_setting_find(p, KEY_MOTION_MODE)->word;
    BUILD_LIST(BUILD)
    flk_build_drive(p);
    flk_machine_finish(&p->d->machine);
    flk_build_points(p);
    flk_build_series(p);
    flk_build_flywheel(p);
    flk_build_table(p);
    flk_build_prescribed(p);
    flk_build_curve_ends(p);
    if (!p->is_design)
        flk_build_notes(p);
    flk_build_expectations(p);
    flk_build_grading(p);
}

/* Build what a text describes, or the linkage that its [synthesis] finds. */
static void build(parser *p)
{
    const section_use *pins;
    parser *found;

    flk_text_copy(flk_setting_find(p, KEY_TOP_TITLE)->value, p->d->title, sizeof p->d->title);
    if (!flk_build_kind(p))
        return;
    if (!flk_section_find(p, SECTION_SYNTHESIS, NULL)) {
        build_all(p);
        return;
    }
    pins = flk_section_find(p, SECTION_PINS, NULL);
    if (pins)
        flk_mistake(p->mistakes, pins->place,
                    "either [pins] or [synthesis] gives the lengths, not both");
    found = find_linkage(p);
    if (found) {
        build_all(found);
        p->out_of_memory |= found->out_of_memory;
    }
}

/* Let units that are not given follow others: those of a table, and those of results. */
static void set_units(parser *p, int deck_units)
{
    deck *d = p->d;
    deck_unit given[QUANTITY_COUNT];

    memcpy(given, d->units, sizeof given);
    flk_values_follow_units(p, 1);
    memcpy(d->shown, d->units, sizeof d->shown);
    if (deck_units)
        return;
    memcpy(d->units, given, sizeof given);
    flk_values_follow_units(p, 0);
}

/* Read a text of the source; null if out of memory. */
static parser *read_text(deck *d, const fourlink_source *source, int is_answers)
{
    const char *name = is_answers ? source->answers_name : source->name;
    parser *p = flk_deck_keep(d, sizeof *p);
    unsigned long i;
    text contents;

    if (!p)
        return NULL;
    p->d = d;
    p->mistakes = is_answers ? &d->slips : &d->mistakes;
    p->load = source->load;
    p->host = source->host;
    p->is_answers = is_answers;
    p->name = flk_reader_copy(p, flk_text_of(name ? name : ""), "");
    contents.start = is_answers ? source->answers : source->text;
    contents.length = is_answers ? source->answers_length : source->length;
    contents = flk_reader_utf8(p, contents);
    if (is_answers)
        contents = flk_answers_plain(p, contents);
    p->text = contents;
    p->text.start = flk_reader_copy(p, contents, "");
    p->copy = flk_reader_copy(p, contents, "");
    if (!p->out_of_memory)
        flk_lines_read(p);
    for (i = 0; i < source->n_changes && !is_answers && !p->out_of_memory; i++)
        change(p, &source->changes[i]);
    if (!p->out_of_memory)
        flk_values_read(p, 1);
    if (source->units && !is_answers)
        flk_values_result_units(p, source->units);
    if (!p->out_of_memory && !p->not_text)
        flk_sweep_read(p);
    if (!p->out_of_memory)
        flk_values_read(p, 0);
    if (!p->out_of_memory && !p->not_text && !is_answers)
        set_units(p, source->deck_units);
    p->is_sound = !flk_mistakes_count(p->mistakes);
    return p->out_of_memory ? NULL : p;
}

/* Build what settings describe.  Returns the same as flk_deck_read. */
static int build_settings(deck *d, parser *p)
{
    if (!p->out_of_memory)
        flk_values_read(p, 0);
    if (!p->out_of_memory && p->is_answers)
        flk_build_expectations(p);
    else if (!p->out_of_memory && !p->not_text)
        build(p);
    flk_mistakes_sort(&d->mistakes);
    flk_mistakes_sort(&d->notes);
    flk_mistakes_sort(&d->slips);
    if (p->out_of_memory || d->mistakes.out_of_memory || d->defects.out_of_memory ||
        d->notes.out_of_memory || d->slips.out_of_memory)
        return -1;
    return d->mistakes.count == 0;
}

/* Build what a text describes; for a deck with [sweep], one of its designs, with numbers set. */
static int build_from(deck *d, parser *p, unsigned long design, const deck_number *set,
                      size_t n_set)
{
    if (!p)
        return -1;
    if (d->sweep.n_designs && !p->is_answers)
        flk_sweep_assign(p, design);
    flk_numbers_assign(p, set, n_set);
    return build_settings(d, p);
}

int flk_deck_read(const fourlink_source *source, deck *d)
{
    int status;

    flk_deck_start(d);
    d->solution = source->synthesis;
    d->effort = source->effort;
    d->near = source->near;
    d->settings = read_text(d, source, 0);
    status = build_from(d, d->settings, source->design, NULL, 0);
    d->near = NULL;
    if (!source->answers || status != 1)
        return status;
    d->answers = read_text(d, source, 1);
    return build_from(d, d->answers, 0, NULL, 0);
}

/* Let a deck have the units, the sweep and the settings of another. */
static void take_settings(deck *d, const deck *from)
{
    memcpy(d->units, from->units, sizeof d->units);
    memcpy(d->bare, from->bare, sizeof d->bare);
    memcpy(d->shown, from->shown, sizeof d->shown);
    d->over = &flk_abscissas[0];
    d->sweep = from->sweep;
    d->settings = share(d, from->settings);
}

/* Build a deck from the settings of another. */
static int build_again(const deck *from, unsigned long design, const deck_number *set, size_t n_set,
                       deck *d)
{
    int status;

    if (!from->settings->is_sound)
        return 0;
    take_settings(d, from);
    status = build_from(d, d->settings, design, set, n_set);
    if (!from->answers || status != 1)
        return status;
    d->answers = share(d, from->answers);
    return build_from(d, d->answers, 0, NULL, 0);
}

int flk_deck_design(const deck *from, unsigned long design, const deck_number *set, size_t n_set,
                    deck *d)
{
    memset(d, 0, sizeof *d);
    d->solution = from->solution;
    d->effort = from->effort;
    return build_again(from, design, set, n_set, d);
}

int flk_deck_solution(const deck *from, unsigned long number, deck *d)
{
    memset(d, 0, sizeof *d);
    d->solution = number + 1;
    d->solved = from->synthesis;
    return build_again(from, 0, NULL, 0, d);
}

int flk_deck_changed(const deck *from, const fourlink_change *c, deck *d)
{
    memset(d, 0, sizeof *d);
    d->solution = from->solution;
    d->effort = from->effort;
    take_settings(d, from);
    if (!d->settings)
        return -1;
    change(d->settings, c);
    return build_settings(d, d->settings);
}

int fourlink_deck_read(const char *contents, unsigned long length, fourlink_loader *load,
                       void *host, unsigned long max_mistakes, fourlink_deck **result,
                       fourlink_mistake *list, unsigned long *n_mistakes)
{
    fourlink_source source;
    deck *d;
    int status;

    if (!contents || !result || (!list && max_mistakes))
        return FOURLINK_NULL;
    d = malloc(sizeof *d);
    if (!d)
        return FOURLINK_NO_MEMORY;
    memset(&source, 0, sizeof source);
    source.text = contents;
    source.length = length;
    source.load = load;
    source.host = host;
    status = flk_deck_read(&source, d);
    if (status > 0) {
        *result = d;
        return FOURLINK_OK;
    }
    if (status == 0)
        flk_deck_give_mistakes(&d->mistakes, max_mistakes, list, n_mistakes);
    fourlink_deck_free(d);
    return status == 0 ? FOURLINK_BAD_DECK : FOURLINK_NO_MEMORY;
}
