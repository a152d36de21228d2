/* SPDX-License-Identifier: GPL-3.0-or-later
**
** lines.c - first pass over a deck: its lines, and assignments from outside it, to settings.
*/
#include <stdlib.h>
#include <string.h>

#include "base/number.h"
#include "reader.h"

#define LINE_MAX_LENGTH 65536
#define MOST_SECTIONS 10000

static void *grow(parser *p, void *list, size_t *capacity, size_t wanted, size_t size)
{
    size_t more = *capacity ? *capacity : 64;
    void *bigger;

    while (more < wanted)
        more *= 2;
    if (more == *capacity)
        return list;
    bigger = realloc(list, more * size);
    if (!bigger)
        p->out_of_memory = 1;
    else
        *capacity = more;
    return bigger;
}

/* Open a section; its settings are all unset.  Null when there is no memory for it. */
static section_use *open_section(parser *p, section_code section, text name, text_place place)
{
    size_t n = (size_t)flk_key_count(section);
    section_use *uses, *use;
    setting *settings;

    uses = grow(p, p->uses, &p->uses_capacity, p->n_uses + 1, sizeof *uses);
    if (!uses)
        return NULL;
    p->uses = uses;
    settings = grow(p, p->settings, &p->settings_capacity, p->n_settings + n, sizeof *settings);
    if (!settings)
        return NULL;
    p->settings = settings;
    memset(settings + p->n_settings, 0, n * sizeof *settings);
    use = &uses[p->n_uses++];
    use->section = section;
    use->name = name;
    use->place = place;
    use->first = p->n_settings;
    p->n_settings += n;
    return use;
}

section_use *flk_find_use(parser *p, section_code section)
{
    size_t i;

    for (i = 0; i < p->n_uses; i++)
        if (p->uses[i].section == section)
            return &p->uses[i];
    return NULL;
}

setting *flk_setting_of(parser *p, const section_use *use, key_code key)
{
    return &p->settings[use->first +
                        (size_t)((int)key - flk_first_key(flk_key_table[key].section))];
}

key_code flk_key_of(parser *p, const setting *s)
{
    size_t place = (size_t)(s - p->settings), i;

    for (i = 1; i < p->n_uses && p->uses[i].first <= place; i++)
        ;
    return (key_code)(flk_first_key(p->uses[i - 1].section) + (int)(place - p->uses[i - 1].first));
}

setting *flk_find(parser *p, key_code key)
{
    section_use *use = flk_find_use(p, flk_key_table[key].section);
    setting *s = use ? flk_setting_of(p, use, key) : NULL;

    return s && s->place.source ? s : NULL;
}

char *flk_word_of(text t, char out[WORD_SIZE])
{
    return flk_text_copy(t, out, WORD_SIZE);
}

/* What people write, and what they mean. */
static const struct {
    const char *written, *meant;
} synonyms[] = {{"connecting", "rod"},     {"conrod", "rod"},    {"follower", "rocker"},
                {"frame", "ground"},       {"fixed", "ground"},  {"link1", "ground"},
                {"link2", "crank"},        {"link3", "coupler"}, {"link4", "rocker"},
                {"input", "crank"},        {"slider", "piston"}, {"cylinder", "gas"},
                {"force", "load"},         {"omega", "speed"},   {"rpm", "speed"},
                {"alpha", "acceleration"}, {"step", "interval"}, {"g", "acceleration"},
                {"weight", "mass"},        {"k", "gyration"},    {"radius", "length"}};

/* The nearest word, by meaning or by spelling; null if none is. */
static const char *nearest_word(text word, const char *const *known)
{
    size_t i, j;

    for (i = 0; i < sizeof synonyms / sizeof synonyms[0]; i++)
        for (j = 0; flk_text_equal(word, synonyms[i].written) && known[j]; j++)
            if (strcmp(known[j], synonyms[i].meant) == 0)
                return known[j];
    return flk_text_nearest(word, known);
}

static void note_unknown(parser *p, text_place place, const char *what, text word,
                         const char *const *known, const char *where)
{
    char copy[WORD_SIZE];
    const char *nearest = nearest_word(word, known);

    flk_mistake_note(&p->d->mistakes, place, "unknown ", what, " '", flk_word_of(word, copy), "'",
                     where, flk_hint(nearest), flk_hint_word(nearest), flk_hint_end(nearest),
                     (char *)NULL);
}

static void note_unknown_section(parser *p, text_place place, text name)
{
    const char *known[SECTION_COUNT];
    int i;

    for (i = 1; i < SECTION_COUNT; i++)
        known[i - 1] = flk_section_table[i].name;
    known[SECTION_COUNT - 1] = NULL;
    note_unknown(p, place, "section", name, known, "");
}

static void note_unknown_key(parser *p, text_place place, section_code section, text name)
{
    const char *known[KEY_COUNT + 1];
    char where[WORD_SIZE], word[WORD_SIZE];
    int first = flk_first_key(section), n = flk_key_count(section), i;

    for (i = 0; i < n; i++)
        known[i] = flk_key_table[first + i].name;
    known[n] = NULL;
    if (section != SECTION_TOP) {
        strcpy(where, " in [");
        strcat(where, flk_section_table[section].name);
        strcat(where, "]");
    } else {
        strcpy(where, " before the first section");
    }
    for (i = flk_first_key(SECTION_TOP);
         i < flk_first_key(SECTION_TOP) + flk_key_count(SECTION_TOP); i++)
        if (flk_text_equal(name, flk_key_table[i].name)) {
            flk_mistake_note(&p->d->mistakes, place, "unknown key '", flk_word_of(name, word), "'",
                             where, "; it belongs before the first section", (char *)NULL);
            return;
        }
    if (!nearest_word(name, known))
        for (i = 0; i < KEY_COUNT; i++)
            if (flk_text_equal(name, flk_key_table[i].name) &&
                flk_key_table[i].section != SECTION_UNITS &&
                flk_key_table[i].section != SECTION_TOP) {
                flk_mistake_note(&p->d->mistakes, place, "unknown key '", flk_word_of(name, word),
                                 "'", where, "; it belongs to a section such as [",
                                 flk_section_table[flk_key_table[i].section].name, "]",
                                 (char *)NULL);
                return;
            }
    note_unknown(p, place, "key", name, known, where);
}

/* The names that users give: case matters where two differ in it. */
static int same_name(text x, text y)
{
    return x.length == y.length && memcmp(x.start, y.start, x.length) == 0;
}

static section_use *find_named(const parser *p, section_code section, text name)
{
    size_t i;

    for (i = 0; i < p->n_uses; i++)
        if (p->uses[i].section == section && same_name(p->uses[i].name, name))
            return &p->uses[i];
    return NULL;
}

/* Parts "section NAME"; the name may be empty. */
static void split_name(text *section, text *name)
{
    *name = *section;
    while (name->length && flk_text_is_word(name->start[0])) {
        name->start++;
        name->length--;
    }
    section->length -= name->length;
    *name = flk_text_trim(*name);
}

/* [section], [section NAME] */
static section_use *read_section(parser *p, text line, text_place place)
{
    text word = line, name;
    section_code section;
    section_use *use;
    char copy[WORD_SIZE];

    if (line.start[line.length - 1] != ']') {
        flk_mistake_note(&p->d->mistakes, place, "expected ']' at the end of the section's name",
                         (char *)NULL);
        return NULL;
    }
    word.start++;
    word.length -= 2;
    word = flk_text_trim(word);
    split_name(&word, &name);
    section = flk_find_section(word);
    if (section == SECTION_COUNT) {
        note_unknown_section(p, place, word);
        return NULL;
    }
    if (p->expectations_only && section != SECTION_EXPECT && section != SECTION_MISPRINT) {
        flk_mistake_note(&p->d->mistakes, place,
                         "expected [expect] or [misprint] in this file, not [",
                         flk_section_table[section].name, "]", (char *)NULL);
        return NULL;
    }
    if (name.length && !flk_section_table[section].repeats) {
        flk_mistake_note(&p->d->mistakes, place, "[", flk_section_table[section].name,
                         "] takes no name, but has '", flk_word_of(name, copy), "'", (char *)NULL);
        return NULL;
    }
    use = flk_find_use(p, section);
    if (use && !flk_section_table[section].repeats) {
        char number[NUMBER_SIZE];

        flk_mistake_note(&p->d->mistakes, place, "a second [", flk_section_table[section].name,
                         "]; the first is at line ",
                         flk_number_write((double)use->place.line, 9, number), (char *)NULL);
        return NULL;
    }
    if (name.length && find_named(p, section, name)) {
        flk_mistake_note(&p->d->mistakes, place, "a second [", flk_section_table[section].name, " ",
                         flk_word_of(name, copy), "]", (char *)NULL);
        return NULL;
    }
    if (p->n_uses >= MOST_SECTIONS) {
        flk_mistake_note(&p->d->mistakes, place, "too many sections", (char *)NULL);
        return NULL;
    }
    return open_section(p, section, name, place);
}

/* A key that the schema does not have, in a section that takes names of its own. */
static void assign_named(parser *p, const section_use *use, text key, text value, text_place place,
                         int replace)
{
    named_value *list, *new;
    size_t i;
    char word[WORD_SIZE];

    if (!key.length || !value.length) {
        flk_mistake_note(&p->d->mistakes, place, "expected NAME = VALUE, not '",
                         flk_word_of(key, word), "'", (char *)NULL);
        return;
    }
    for (i = 0; i < p->n_named; i++)
        if (p->named[i].use == (size_t)(use - p->uses) && same_name(p->named[i].name, key)) {
            if (replace) {
                p->named[i].s.place = place;
                p->named[i].s.value = value;
            } else {
                flk_mistake_note(&p->d->mistakes, place, "'", flk_word_of(key, word),
                                 "' a second time", (char *)NULL);
            }
            return;
        }
    list = grow(p, p->named, &p->named_capacity, p->n_named + 1, sizeof *list);
    if (!list)
        return;
    p->named = list;
    new = &list[p->n_named++];
    memset(new, 0, sizeof *new);
    new->use = (size_t)(use - p->uses);
    new->name = key;
    new->s.place = place;
    new->s.value = value;
}

/* key = value, in a section; the setting, null if the schema has none for it */
static setting *assign(parser *p, const section_use *use, text key, text value, text_place place,
                       int replace)
{
    int first = flk_first_key(use->section), n = flk_key_count(use->section), i;
    char word[WORD_SIZE], number[NUMBER_SIZE];
    setting *s;

    for (i = 0; i < n; i++)
        if (flk_text_equal(key, flk_key_table[first + i].name))
            break;
    if (i == n && TAKES_NAMES(use->section)) {
        assign_named(p, use, key, value, place, replace);
        return NULL;
    }
    if (i == n) {
        note_unknown_key(p, place, use->section, key);
        return NULL;
    }
    s = flk_setting_of(p, use, (key_code)(first + i));
    if (!value.start)
        return s;
    if (s->place.source && !replace) {
        flk_mistake_note(&p->d->mistakes, place, "'", flk_word_of(key, word),
                         "' a second time; the first is at line ",
                         flk_number_write((double)s->place.line, 9, number), (char *)NULL);
        return NULL;
    }
    if (!value.length) {
        flk_mistake_note(&p->d->mistakes, place, "expected a value after '", flk_word_of(key, word),
                         " ='", (char *)NULL);
        return NULL;
    }
    memset(s, 0, sizeof *s);
    s->place = place;
    s->value = value;
    return s;
}

text flk_without_comment(text line)
{
    size_t i;
    int quoted = 0;

    for (i = 0; i < line.length; i++) {
        char c = line.start[i];

        if (c == '"')
            quoted = !quoted;
        if ((c == '#' || c == ';') && !quoted &&
            (i == 0 || line.start[i - 1] == ' ' || line.start[i - 1] == '\t'))
            break;
    }
    line.length = i;
    return flk_text_trim(line);
}

static int is_text(parser *p, text line, text_place place)
{
    static const char hex[] = "0123456789abcdef";
    char code[3] = "00";
    size_t i;

    if (line.length > LINE_MAX_LENGTH) {
        p->not_text = 1;
        flk_mistake_note(&p->d->mistakes, place, "a line of more than 65536 characters: not a deck",
                         (char *)NULL);
        return 0;
    }
    for (i = 0; i < line.length; i++) {
        unsigned char c = (unsigned char)line.start[i];

        if ((c < ' ' && c != '\t' && c != '\r') || c == 0x7f) {
            p->not_text = 1;
            code[0] = hex[c / 16];
            code[1] = hex[c % 16];
            flk_mistake_note(&p->d->mistakes, place, "a control character (0x", code,
                             "): decks are plain text", (char *)NULL);
            return 0;
        }
    }
    return 1;
}

/* The next line without its comment; 0 at the end of the deck, or where it is no text. */
static int next_line(parser *p, text *rest, text *line)
{
    text_place place;

    if (p->last_line > 0 && !rest->length)
        return 0; /* nothing after the last end of line */
    if (!flk_text_split(rest, '\n', line))
        return 0;
    p->last_line++;
    place.source = p->name;
    place.line = p->last_line;
    if (!is_text(p, *line, place)) {
        rest->start = NULL;
        return 0;
    }
    *line = flk_without_comment(*line);
    return 1;
}

/* A line that ends in a comma goes on in the next, unless that is an assignment or a section.  What
** is between the two, a comment and the end of the line, becomes blanks in the deck's copy. */
static void join_lines(parser *p, char *copy, text *rest, text *line)
{
    while (line->length && line->start[line->length - 1] == ',' && rest->start) {
        text ahead = *rest, next;
        char *gap;

        if (!flk_text_split(&ahead, '\n', &next))
            return;
        next = flk_without_comment(next);
        if (next.length && (next.start[0] == '[' || memchr(next.start, '=', next.length)))
            return;
        if (!next_line(p, rest, &next))
            return;
        if (!next.length)
            continue;
        gap = copy + (line->start + line->length - copy);
        memset(gap, ' ', (size_t)(next.start - gap));
        line->length = (size_t)(next.start - line->start) + next.length;
    }
}

void flk_read_lines(parser *p, text rest, char *copy)
{
    section_use *use;
    text line;
    text_place place;

    place.source = p->name;
    place.line = 1;
    use = open_section(p, SECTION_TOP, flk_text_of(""), place);
    rest = flk_text_without_mark(rest);
    while (!p->out_of_memory && next_line(p, &rest, &line)) {
        text key, value;

        place.line = p->last_line;
        if (!line.length)
            continue;
        if (line.start[0] == '[') {
            use = read_section(p, line, place);
            continue;
        }
        join_lines(p, copy, &rest, &line);
        value = line;
        flk_text_split(&value, '=', &key);
        if (!value.start) {
            char word[WORD_SIZE];

            flk_mistake_note(&p->d->mistakes, place, "expected 'key = value' or '[section]', not '",
                             flk_word_of(line, word), "'", (char *)NULL);
        } else if (use) { /* the keys of an unknown section are not judged */
            assign(p, use, flk_text_trim(key), flk_text_trim(value), place, 0);
        }
    }
}

setting *flk_set_key(parser *p, text_place place, text key, text value)
{
    text section = key, name;
    section_use *use, *other = NULL;
    section_code code = SECTION_TOP;
    size_t i, found = 0;
    char word[WORD_SIZE];

    for (i = key.length; i > 0 && key.start[i - 1] != '.'; i--)
        ;
    section.length = i ? i - 1 : 0;
    key.start += i;
    key.length -= i;
    split_name(&section, &name);
    if (i) {
        code = flk_find_section(section);
        if (code == SECTION_COUNT) {
            note_unknown_section(p, place, section);
            return NULL;
        }
    }
    use = name.length ? find_named(p, code, name) : NULL;
    for (i = 0; i < p->n_uses && !use; i++)
        if (p->uses[i].section == code &&
            (!name.length ||
             flk_text_equal(name, flk_text_copy(p->uses[i].name, word, sizeof word)))) {
            other = &p->uses[i];
            found++;
        }
    use = use ? use : other;
    if (found > 1) {
        flk_mistake_note(&p->d->mistakes, place, "there are several [",
                         flk_section_table[code].name, "] sections: name one of them",
                         (char *)NULL);
        return NULL;
    }
    if (!use && name.length) {
        flk_mistake_note(&p->d->mistakes, place, "there is no [", flk_section_table[code].name, " ",
                         flk_word_of(name, word), "] in the deck", (char *)NULL);
        return NULL;
    }
    if (!use)
        use = open_section(p, code, name, place);
    return use ? assign(p, use, flk_text_trim(key), flk_text_trim(value), place, 1) : NULL;
}

/* sweep.crank.length: the key is all that follows the section. */
static void change_sweep(parser *p, text_place place, text key, text value)
{
    section_use *use = flk_find_use(p, SECTION_SWEEP);

    key.start += 6;
    key.length -= 6;
    if (!use)
        use = open_section(p, SECTION_SWEEP, flk_text_of(""), place);
    if (use)
        assign(p, use, flk_text_trim(key), flk_text_trim(value), place, 1);
}

/* [SECTION[ NAME].]KEY=VALUE from the command line */
void flk_apply_change(parser *p, const char *option, text assignment)
{
    text key, start, value = assignment;
    text_place place;
    char word[WORD_SIZE];

    place.source = option;
    place.line = 0;
    flk_text_split(&value, '=', &key);
    key = flk_text_trim(key);
    start.start = key.start;
    start.length = key.length < 6 ? key.length : 6;
    if (!value.start)
        flk_mistake_note(&p->d->mistakes, place, "expected [SECTION.]KEY=VALUE, not '",
                         flk_word_of(assignment, word), "'", (char *)NULL);
    else if (flk_text_equal(start, "sweep."))
        change_sweep(p, place, key, value);
    else
        flk_set_key(p, place, key, value);
}
