/* SPDX-License-Identifier: GPL-3.0-or-later
**
** reference.c - prints the sections and keys of doc/reference.md as the schema has them; test_reference.sh compares.
*/
#include <stdio.h>
#include <string.h>

#include "deck/schema.h"

#define WIDTH 100

/* 1 if a section has the key of another, with the same meaning. */
static int has_same(section_code section, const key_info *k)
{
    key_code same = flk_find_key(section, flk_text_of(k->name));

    return same != KEY_COUNT && strcmp(flk_key_table[same].meaning, k->meaning) == 0;
}

/* The section, if any, whose keys another repeats: of links the crank, of misprints what is expected. */
static section_code model_of(section_code section)
{
    switch (section) {
    case SECTION_COUPLER:
    case SECTION_ROCKER:
    case SECTION_ROD:
    case SECTION_PISTON:
    case SECTION_SLIDER:
    case SECTION_LEVER:
    case SECTION_YOKE:
        return SECTION_CRANK;
    case SECTION_MISPRINT:
        return SECTION_EXPECT;
    default:
        return SECTION_COUNT;
    }
}

/* What a value is: the unit of a bare number, or a word. */
static const char *kind_of(const key_info *k)
{
    switch (k->form) {
    case FORM_TEXT:
        return "text";
    case FORM_WORD:
        return "word";
    case FORM_LINK:
    case FORM_BODY:
        return "link";
    case FORM_POINT:
        return "point";
    case FORM_VECTOR:
        return "vector";
    case FORM_COUNT:
        return "count";
    default:
        return k->q == QUANTITY_NUMBER ? "number" : flk_quantities[k->q].unit;
    }
}

/* The words that a key takes; a curve. */
static void put_more(key_code key)
{
    const char *words[MOST_WORDS], **w;

    if (flk_key_table[key].form == FORM_CURVE)
        printf(", or a curve");
    if (flk_key_table[key].form != FORM_WORD)
        return;
    flk_key_words(key, NULL, words);
    for (w = words; *w; w++)
        printf("%s%s", w == words ? ": " : "|", *w);
}

/* The names of all keys of [units], or of those that a section has from its model, in lines. */
static void put_names(section_code section, section_code model)
{
    size_t column = 0;
    key_code k;

    for (k = flk_first_key(section); k < flk_first_key(section + 1); k++) {
        const key_info *key = &flk_key_table[k];

        if (model != SECTION_COUNT && !has_same(model, key))
            continue;
        if (column + strlen(key->name) > WIDTH)
            column = (size_t)printf("\n") - 1;
        column += (size_t)printf(column ? " %s" : "  %s", key->name);
    }
    printf("\n");
}

static void put_section(section_code section)
{
    section_code model = model_of(section);
    key_code k;

    if (section != SECTION_TOP)
        printf("\n[%s%s]%s\n", flk_section_table[section].name,
               section == SECTION_LOAD || section == SECTION_SPRING || section == SECTION_POINT
                   ? " NAME"
                   : "",
               model == SECTION_COUNT   ? ""
               : model == SECTION_CRANK ? " as [crank]:"
                                        : " as [expect]:");
    if (section == SECTION_UNITS || model != SECTION_COUNT)
        put_names(section, model);
    for (k = flk_first_key(section); section != SECTION_UNITS && k < flk_first_key(section + 1);
         k++) {
        const key_info *key = &flk_key_table[k];

        if (model != SECTION_COUNT && has_same(model, key))
            continue;
        printf("  %-13s %-8s %s", key->name, kind_of(key), key->meaning);
        put_more(k);
        printf("\n");
    }
}

int main(void)
{
    int section;

    for (section = SECTION_TOP; section < SECTION_COUNT; section++)
        put_section((section_code)section);
    return 0;
}
