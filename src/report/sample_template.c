/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_template.c - equations of an output in the sample calculation, as templates.
*/
#include <ctype.h>
#include <string.h>

#include "base/text.h"
#include "sample_template.h"

sample_output sample_output_of(report *r, math *m, int i)
{
    sample_output o;

    o.r = r;
    o.m = m;
    o.group = &r->v.design->group[i];
    o.i = i;
    o.is_about_pivot = 0;
    return o;
}

int sample_output_floats(const fourlink_group *g)
{
    return g->end == FOURLINK_GROUP_TURNS && g->to > FOURLINK_GROUND;
}

int sample_output_link(const sample_output *o)
{
    return o->is_about_pivot ? o->group->to : o->group->link;
}

/* Write what a letter of a symbol stands for: a number of a link, or a pin with its number. */
static void put_letter(const sample_output *o, char letter, char out[MATH_NAME])
{
    int several = o->r->v.design->n_groups > 1;

    out[0] = letter;
    out[1] = '\0';
    if (letter == 'P' && o->is_about_pivot)
        sprintf(out, "D%d", FOURLINK_END_OF(o->i));
    else if (letter == 'k')
        sprintf(out, "%d", sample_output_link(o));
    else if (letter == '5' || letter == '6')
        sprintf(out, "%d", letter - '0' + 2 * o->i);
    else if (letter == 'E')
        sprintf(out, several ? "P%s%d" : "P%s", sample_output_floats(o->group) ? "D" : "",
                o->i + 1);
    else if (strchr("PQ0", letter) && several)
        sprintf(out, "%c%d", letter, o->i + 1);
}

/* A symbol in full. */
static void put_symbol(const sample_output *o, const char *symbol, char out[MATH_NAME])
{
    static const char *const arms[2][2] = {{"rPx", "rPy"}, {"xP", "yP"}};
    char letter[MATH_NAME];
    size_t i, length = 0;

    if (strcmp(symbol, "armx") == 0 || strcmp(symbol, "army") == 0)
        symbol = arms[sample_output_link(o) == FOURLINK_CRANK][symbol[3] == 'y'];
    *out = '\0';
    for (i = 0; symbol[i]; i++) {
        put_letter(o, symbol[i], letter);
        flk_text_join(out + length, MATH_NAME - length, letter, (char *)NULL);
        length += strlen(out + length);
    }
}

const char *sample_output_words(const sample_output *o, const char *words,
                                char out[SAMPLE_EQUATION])
{
    text rest = flk_text_of(words), token;
    char symbol[MATH_NAME], whole[MATH_NAME];
    size_t length = 0;

    *out = '\0';
    while (flk_text_split(&rest, ' ', &token)) {
        flk_text_copy(token, symbol, sizeof symbol);
        if (!isdigit((unsigned char)symbol[0])) {
            put_symbol(o, symbol, whole);
            flk_text_copy(flk_text_of(whole), symbol, sizeof symbol);
        }
        flk_text_join(out + length, SAMPLE_EQUATION - length, length ? " " : "", symbol,
                      (char *)NULL);
        length += strlen(out + length);
    }
    return out;
}

void sample_output_let(const sample_output *o, const char *name, const char *equation, double value)
{
    char whole[SAMPLE_EQUATION], symbol[SAMPLE_EQUATION];

    math_let(o->m, sample_output_words(o, name, symbol), sample_output_words(o, equation, whole),
             value);
}

void sample_output_given(const sample_output *o, const char *name, double value)
{
    char symbol[SAMPLE_EQUATION];

    math_given(o->m, sample_output_words(o, name, symbol), value);
}

void sample_output_set(const sample_output *o, const char *name, double value)
{
    char symbol[SAMPLE_EQUATION];

    math_set(o->m, sample_output_words(o, name, symbol), value);
}

int sample_can_turn(const report *r, int link)
{
    if (link > FOURLINK_FOLLOWER)
        return link % 2 || r->v.design->group[(link - 6) / 2].end == FOURLINK_GROUP_TURNS;
    return link == FOURLINK_CRANK ||
           !(link == r->v.kind.guided || (link == FOURLINK_COUPLER && r->v.kind.has_one_branch));
}

void sample_output_heading(const sample_output *o, const char *part)
{
    page_print(o->m->p, "<h3>Output <b>%s</b>",
               fourlink_deck_link_text(o->r->v.deck, FOURLINK_END_OF(o->i)));
    if (o->r->v.design->n_groups > 1)
        page_print(o->m->p, ", number %d", o->i + 1);
    page_print(o->m->p, ": %s</h3>\n", part);
}
