/* SPDX-License-Identifier: GPL-3.0-or-later
**
** margin.c - what stands beside a drawing, to the right of its axes: the key, and lines of text with values.
*/
#include <stdarg.h>

#include <gsl/gsl_math.h>

#include "base/message.h"
#include "sketch.h"

#define BEYOND 4 /* letters: half a number at the right end of an axis */

void sketch_value(sketch *s, const char *words, const char *value, const char *unit)
{
    sketch_line_beside *new = &s->notes[s->n_notes];

    if (s->n_notes == SKETCH_NOTES)
        return;
    new->key = s->subject;
    flk_text_join(new->words, sizeof new->words, words, (char *)NULL);
    flk_text_join(new->value, sizeof new->value, value, (char *)NULL);
    flk_text_join(new->unit, sizeof new->unit, unit, (char *)NULL);
    s->n_notes++;
}

void sketch_note(sketch *s, const char *format, ...)
{
    char words[LABELS_WORDS];
    va_list values;

    va_start(values, format);
    sketch_value(s, flk_message_list(words, sizeof words, format, values), "", "");
    va_end(values);
}

void sketch_key(sketch *s, pen p, const char *meaning)
{
    sketch_entry *new = &s->entries[s->n_entries++];

    new->p = p;
    new->key = s->subject;
    flk_text_join(new->title, sizeof new->title, meaning, (char *)NULL);
}

static double width_of_note(const sketch_line_beside *x)
{
    return canvas_width_of(x->words) + canvas_width_of(x->value) + canvas_width_of(x->unit);
}

double sketch_margin_width(const sketch *s)
{
    double narrow = s->c->is_text ? 1 : 0.95;
    double width = (canvas_has_scales(s->c) || s->c->is_text ? 1 : BEYOND) * CANVAS_LETTER;
    int i;

    for (i = 0; i < s->n_notes; i++)
        width = GSL_MAX_DBL(width, narrow * width_of_note(&s->notes[i]) + 3 * CANVAS_LETTER);
    for (i = 0; i < s->n_entries; i++)
        if (s->entries[i].title[0])
            width = GSL_MAX_DBL(width,
                                narrow * canvas_width_of(s->entries[i].title) + 7 * CANVAS_LETTER);
    return width;
}

/* The notes are below the key. */
void sketch_put_margin(const sketch *s)
{
    int in_key = 0, i;

    for (i = 0; i < s->n_entries; i++) {
        s->c->d->key = s->entries[i].key;
        canvas_add_key(s->c, DISPLAY_LINE, (int)s->entries[i].p, s->entries[i].title);
        in_key += s->entries[i].title[0] != '\0';
    }
    for (i = 0; i < s->n_notes; i++) {
        const sketch_line_beside *x = &s->notes[i];

        s->c->d->key = x->key;
        display_set_value(s->c->d, canvas_note(s->c, i + (in_key ? in_key + 1 : 0), "%s", x->words),
                          x->value, x->unit);
    }
}
