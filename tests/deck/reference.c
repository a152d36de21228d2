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

/* The unit of a bare number; what else a value is, where its meaning does not say so. */
static const char *kind_of(const key_info *k)
{
    switch (k->form) {
    case FORM_TEXT:
    case FORM_WORD:
    case FORM_LINK:
    case FORM_BODY:
        return "";
    case FORM_POINT:
        return "point";
    case FORM_VECTOR:
        return "vector";
    case FORM_PLACE:
        return "place";
    case FORM_LINE:
        return "line";
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

/* Lines of names. */
static size_t put_name(size_t column, const char *name)
{
    if (column + strlen(name) > WIDTH)
        column = (size_t)printf("\n") - 1;
    return column + (size_t)printf(column ? " %s" : "  %s", name);
}

static void put_units(void)
{
    size_t column = 0;
    key_code k;

    for (k = flk_first_key(SECTION_UNITS); k < flk_first_key(SECTION_UNITS + 1); k++)
        column = put_name(column, flk_key_table[k].name);
    printf("\n");
}

/* What a section does not have of its model, or if that is shorter, what it has. */
static void put_difference(section_code section, section_code model, char *text)
{
    char lacks[200] = "", has[200] = "";
    key_code k;

    for (k = flk_first_key(model); k < flk_first_key(model + 1); k++) {
        key_code own = flk_find_key(section, flk_text_of(flk_key_table[k].name));
        char *list = own != KEY_COUNT && has_same(model, &flk_key_table[own]) ? has : lacks;

        strcat(strcat(list, " "), flk_key_table[k].name);
    }
    if (!lacks[0])
        strcpy(text, "");
    else
        sprintf(text, "%s%s", strlen(has) < strlen(lacks) ? ", only" : " but",
                strlen(has) < strlen(lacks) ? has : lacks);
}

/* 1 if two keys are the same of two pins: their names and meanings end in letters of their own. */
static int are_of_pins(const key_info *a, const key_info *b)
{
    size_t n = strlen(a->meaning) - 1, m = strlen(a->name) - 1;

    return strlen(b->meaning) == n + 1 && strlen(b->name) == m + 1 &&
           strncmp(a->meaning, b->meaning, n) == 0 && strncmp(a->name, b->name, m) == 0 &&
           a->meaning[n] == a->name[m] && b->meaning[n] == b->name[m];
}

static void put_key(key_code k, key_code end)
{
    const key_info *key = &flk_key_table[k];
    char names[100];
    int length = (int)strlen(key->meaning);

    strcpy(names, key->name);
    for (; k + 1 < end && are_of_pins(key, &flk_key_table[k + 1]); k++) {
        strcat(strcat(names, " "), flk_key_table[k + 1].name);
        length = (int)strlen(key->meaning) - 2;
    }
    printf("  %-13s %-8s %.*s", names, kind_of(key), length, key->meaning);
    put_more(k);
    printf("\n");
}

static void put_section(section_code section, section_code last)
{
    section_code model = model_of(section);
    char difference[400] = "", before[400] = "";
    int is_same, has_name = section == SECTION_OUTPUT || section == SECTION_LOAD ||
                            section == SECTION_SPRING || section == SECTION_POINT;
    key_code k, end = flk_first_key(section + 1);

    if (model != SECTION_COUNT) {
        put_difference(section, model, difference);
        if (model_of(last) == model)
            put_difference(last, model, before);
    }
    is_same = model != SECTION_COUNT && strcmp(before, difference) == 0;
    if (section != SECTION_TOP)
        printf("%s[%s%s]", is_same ? "" : "\n", flk_section_table[section].name,
               has_name ? " NAME" : "");
    if (is_same)
        printf(" the same");
    else if (model != SECTION_COUNT)
        printf(" as [%s]%s", flk_section_table[model].name, difference);
    if (section != SECTION_TOP)
        printf("\n");
    if (section == SECTION_UNITS)
        put_units();
    for (k = flk_first_key(section); section != SECTION_UNITS && k < end; k++)
        if (model == SECTION_COUNT || !has_same(model, &flk_key_table[k]))
            if (k == flk_first_key(section) ||
                !are_of_pins(&flk_key_table[k - 1], &flk_key_table[k]))
                put_key(k, end);
}

int main(void)
{
    int section, last = SECTION_COUNT;

    for (section = SECTION_TOP; section < SECTION_COUNT; last = section++)
        put_section((section_code)section, (section_code)last);
    return 0;
}
