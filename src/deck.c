/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck.c - the input deck: text in, a problem to solve out, or its mistakes.
**
** In three passes: the lines give settings, each a text and its place (read_lines, apply_change);
*the
** texts give values, by the schema's forms and in the deck's units (read_values); the values give
*the
** problem (build_...).  A mistake does not end the reading, so that one run tells all of them.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "deck.h"
#include "number.h"
#include "schema.h"

#define LINE_MAX_LENGTH 65536
#define MOST_SECTIONS 10000
#define WORD_SIZE 64

/* --------------------------------------------------------------------------- the schema's tables
 */

#define SECTION_CODE(code, name, repeats, kinds) SECTION_##code,
typedef enum section_code { SECTION_LIST(SECTION_CODE) SECTION_COUNT } section_code;

#define KEY_CODE(section, code, name, form, quantity, sign, kinds) KEY_##section##_##code,
typedef enum key_code { KEY_LIST(KEY_CODE) KEY_COUNT } key_code;

typedef struct section_info {
    const char *name;
    int repeats, kinds;
} section_info;

#define SECTION_INFO(code, name, repeats, kinds) {name, repeats, kinds},
static const section_info section_table[] = {SECTION_LIST(SECTION_INFO){NULL, 0, 0}};

typedef struct key_info {
    section_code section;
    const char *name;
    value_form form;
    quantity q;
    value_sign sign;
    int kinds;
} key_info;

#define KEY_INFO(section, code, name, form, quantity, sign, kinds) \
    {SECTION_##section, name, FORM_##form, QUANTITY_##quantity, SIGN_##sign, kinds},
static const key_info key_table[] = {KEY_LIST(KEY_INFO)};

/* The words that keys of FORM_WORD take, with their values. */
typedef struct word_info {
    key_code key;
    const char *word;
    int value;
} word_info;

enum { BRANCH_OPEN = 1, BRANCH_CROSSED = 2, BRANCH_BOTH = 3 };

static const word_info word_table[] = {{KEY_TOP_MECHANISM, "four-bar", FOURLINK_FOUR_BAR},
                                       {KEY_TOP_MECHANISM, "slider-crank", FOURLINK_SLIDER_CRANK},
                                       {KEY_MOTION_HOLD, "no", 0},
                                       {KEY_MOTION_HOLD, "yes", 1},
                                       {KEY_LOAD_LINK, "crank", FOURLINK_CRANK},
                                       {KEY_LOAD_LINK, "coupler", FOURLINK_COUPLER},
                                       {KEY_LOAD_LINK, "rod", FOURLINK_COUPLER},
                                       {KEY_LOAD_LINK, "rocker", FOURLINK_FOLLOWER},
                                       {KEY_LOAD_LINK, "piston", FOURLINK_FOLLOWER},
                                       {KEY_TABLE_BRANCH, "open", BRANCH_OPEN},
                                       {KEY_TABLE_BRANCH, "crossed", BRANCH_CROSSED},
                                       {KEY_TABLE_BRANCH, "both", BRANCH_BOTH}};

#define WORD_COUNT (sizeof word_table / sizeof word_table[0])

static const char *kind_words(fourlink_kind kind)
{
    return kind == FOURLINK_FOUR_BAR ? "four-bar linkage" : "slider-crank";
}

/* ------------------------------------------------------------------------------------ the parser
 */

/* What the deck sets a key to. */
typedef struct setting {
    text_place place; /* source null: not set */
    text value;
    double number; /* as written */
    unit unit;     /* its unit */
    double si[2];  /* the value in SI units and radians, or the two components */
    int word;
} setting;

/* A section as it stands in the deck, with one setting for each key of the schema that it can have;
** they are found at first + key - (first key of the section). */
typedef struct section_use {
    section_code section;
    text name;
    text_place place;
    size_t first;
} section_use;

typedef struct parser {
    deck *d;
    const char *name;
    section_use *uses;
    size_t n_uses, uses_capacity;
    setting *settings;
    size_t n_settings, settings_capacity;
    long last_line;
    int out_of_memory;
} parser;

static int first_key(section_code section)
{
    int k = 0;

    while (k < KEY_COUNT && key_table[k].section != section)
        k++;
    return k;
}

static int key_count(section_code section)
{
    int k = first_key(section), n = 0;

    while (k + n < KEY_COUNT && key_table[k + n].section == section)
        n++;
    return n;
}

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
    size_t n = (size_t)key_count(section);
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

static section_use *find_use(parser *p, section_code section)
{
    size_t i;

    for (i = 0; i < p->n_uses; i++)
        if (p->uses[i].section == section)
            return &p->uses[i];
    return NULL;
}

static setting *setting_of(parser *p, const section_use *use, key_code key)
{
    return &p->settings[use->first + (size_t)((int)key - first_key(key_table[key].section))];
}

/* The setting of a key of a section that does not repeat; null if the deck does not set it. */
static setting *find(parser *p, key_code key)
{
    section_use *use = find_use(p, key_table[key].section);
    setting *s = use ? setting_of(p, use, key) : NULL;

    return s && s->place.source ? s : NULL;
}

static char *word_of(text t, char out[WORD_SIZE])
{
    return text_copy(t, out, WORD_SIZE);
}

/* "; did you mean 'NEAREST'?" in two strings, both empty if there is none. */
static const char *hint(const char *nearest)
{
    return nearest ? "; did you mean '" : "";
}

static const char *hint_end(const char *nearest)
{
    return nearest ? "'?" : "";
}

static void note_unknown(parser *p, text_place place, const char *what, text word,
                         const char *const *known, const char *where)
{
    char copy[WORD_SIZE];
    const char *nearest = text_nearest(word, known);

    mistake_note(&p->d->mistakes, place, "unknown ", what, " '", word_of(word, copy), "'", where,
                 hint(nearest), nearest ? nearest : "", hint_end(nearest), (char *)NULL);
}

static section_code find_section(text name)
{
    int i;

    for (i = 1; i < SECTION_COUNT; i++)
        if (text_equal(name, section_table[i].name))
            return (section_code)i;
    return SECTION_COUNT;
}

static void note_unknown_section(parser *p, text_place place, text name)
{
    const char *known[SECTION_COUNT];
    int i;

    for (i = 1; i < SECTION_COUNT; i++)
        known[i - 1] = section_table[i].name;
    known[SECTION_COUNT - 1] = NULL;
    note_unknown(p, place, "section", name, known, "");
}

static void note_unknown_key(parser *p, text_place place, section_code section, text name)
{
    const char *known[KEY_COUNT + 1];
    char where[WORD_SIZE], word[WORD_SIZE];
    int first = first_key(section), n = key_count(section), i;

    for (i = 0; i < n; i++)
        known[i] = key_table[first + i].name;
    known[n] = NULL;
    if (section != SECTION_TOP) {
        strcpy(where, " in [");
        strcat(where, section_table[section].name);
        strcat(where, "]");
    } else {
        strcpy(where, " before the first section");
    }
    if (!text_nearest(name, known))
        for (i = 0; i < KEY_COUNT; i++)
            if (text_equal(name, key_table[i].name) && key_table[i].section != SECTION_UNITS &&
                key_table[i].section != SECTION_TOP) {
                mistake_note(&p->d->mistakes, place, "unknown key '", word_of(name, word), "'",
                             where, "; it belongs to a section such as [",
                             section_table[key_table[i].section].name, "]", (char *)NULL);
                return;
            }
    note_unknown(p, place, "key", name, known, where);
}

/* ------------------------------------------------------------------------- first pass: the lines
 */

/* [section], [section NAME] */
static section_use *read_section(parser *p, text line, text_place place)
{
    text word = line, name;
    section_code section;
    section_use *use;
    char copy[WORD_SIZE];

    if (line.start[line.length - 1] != ']') {
        mistake_note(&p->d->mistakes, place, "expected ']' at the end of the section's name",
                     (char *)NULL);
        return NULL;
    }
    word.start++;
    word.length -= 2;
    word = text_trim(word);
    name = word;
    while (name.length && text_is_word(name.start[0])) {
        name.start++;
        name.length--;
    }
    word.length -= name.length;
    name = text_trim(name);
    section = find_section(word);
    if (section == SECTION_COUNT) {
        note_unknown_section(p, place, word);
        return NULL;
    }
    if (name.length && !section_table[section].repeats) {
        mistake_note(&p->d->mistakes, place, "[", section_table[section].name,
                     "] takes no name, but has '", word_of(name, copy), "'", (char *)NULL);
        return NULL;
    }
    use = find_use(p, section);
    if (use && !section_table[section].repeats) {
        char number[NUMBER_SIZE];

        mistake_note(&p->d->mistakes, place, "a second [", section_table[section].name,
                     "]; the first is at line ", number_fixed((double)use->place.line, 0, number),
                     (char *)NULL);
        return NULL;
    }
    if (p->n_uses >= MOST_SECTIONS) {
        mistake_note(&p->d->mistakes, place, "too many sections", (char *)NULL);
        p->out_of_memory = p->n_uses > MOST_SECTIONS;
        return NULL;
    }
    return open_section(p, section, name, place);
}

/* key = value, in a section */
static void assign(parser *p, const section_use *use, text key, text value, text_place place,
                   int replace)
{
    int first = first_key(use->section), n = key_count(use->section), i;
    char word[WORD_SIZE], number[NUMBER_SIZE];
    setting *s;

    for (i = 0; i < n; i++)
        if (text_equal(key, key_table[first + i].name))
            break;
    if (i == n) {
        note_unknown_key(p, place, use->section, key);
        return;
    }
    s = setting_of(p, use, (key_code)(first + i));
    if (s->place.source && !replace) {
        mistake_note(&p->d->mistakes, place, "'", word_of(key, word),
                     "' a second time; the first is at line ",
                     number_fixed((double)s->place.line, 0, number), (char *)NULL);
        return;
    }
    if (!value.length) {
        mistake_note(&p->d->mistakes, place, "expected a value after '", word_of(key, word), " ='",
                     (char *)NULL);
        return;
    }
    memset(s, 0, sizeof *s);
    s->place = place;
    s->value = value;
}

/* A comment starts with # or ; at the start of a line or after a blank, but not within quotes. */
static text without_comment(text line)
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
    return text_trim(line);
}

static int is_text(parser *p, text line, text_place place)
{
    static const char hex[] = "0123456789abcdef";
    char code[3] = "00";
    size_t i;

    if (line.length > LINE_MAX_LENGTH) {
        mistake_note(&p->d->mistakes, place, "a line of more than 65536 characters: not a deck",
                     (char *)NULL);
        return 0;
    }
    for (i = 0; i < line.length; i++) {
        unsigned char c = (unsigned char)line.start[i];

        if ((c < ' ' && c != '\t' && c != '\r') || c == 0x7f) {
            code[0] = hex[c / 16];
            code[1] = hex[c % 16];
            mistake_note(&p->d->mistakes, place, "a control character (0x", code,
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
    if (!text_split(rest, '\n', line))
        return 0;
    p->last_line++;
    place.source = p->name;
    place.line = p->last_line;
    if (!is_text(p, *line, place)) {
        rest->start = NULL;
        return 0;
    }
    *line = without_comment(*line);
    return 1;
}

/* A line that ends in a comma goes on in the next, unless that is an assignment or a section.  What
** is between the two, a comment and the end of the line, becomes blanks in the deck's copy. */
static void join_lines(parser *p, text *rest, text *line)
{
    while (line->length && line->start[line->length - 1] == ',' && rest->start) {
        text ahead = *rest, next;
        char *gap;

        if (!text_split(&ahead, '\n', &next))
            return;
        next = without_comment(next);
        if (next.length && (next.start[0] == '[' || memchr(next.start, '=', next.length)))
            return;
        if (!next_line(p, rest, &next))
            return;
        if (!next.length)
            continue;
        gap = p->d->storage + (line->start + line->length - p->d->storage);
        memset(gap, ' ', (size_t)(next.start - gap));
        line->length = (size_t)(next.start - line->start) + next.length;
    }
}

static void read_lines(parser *p, text rest)
{
    section_use *use;
    text line;
    text_place place;

    place.source = p->name;
    place.line = 1;
    use = open_section(p, SECTION_TOP, text_of(""), place);
    if (rest.length >= 3 && memcmp(rest.start, "\357\273\277", 3) == 0) {
        rest.start += 3; /* the byte order mark of UTF-8 */
        rest.length -= 3;
    }
    while (!p->out_of_memory && next_line(p, &rest, &line)) {
        text key, value;

        place.line = p->last_line;
        if (!line.length)
            continue;
        if (line.start[0] == '[') {
            use = read_section(p, line, place);
            continue;
        }
        join_lines(p, &rest, &line);
        value = line;
        text_split(&value, '=', &key);
        if (!value.start) {
            mistake_note(&p->d->mistakes, place, "expected 'key = value' or '[section]'",
                         (char *)NULL);
        } else if (use) { /* the keys of an unknown section are not judged */
            assign(p, use, text_trim(key), text_trim(value), place, 0);
        }
    }
}

/* [SECTION[ NAME].]KEY=VALUE from the command line */
static void apply_change(parser *p, const char *option, text assignment)
{
    text key, section, value = assignment, name;
    text_place place;
    section_use *use = NULL;
    section_code code = SECTION_TOP;
    size_t i, found = 0;
    char word[WORD_SIZE];

    place.source = option;
    place.line = 0;
    text_split(&value, '=', &key);
    if (!value.start) {
        mistake_note(&p->d->mistakes, place, "expected [SECTION.]KEY=VALUE, not '",
                     word_of(assignment, word), "'", (char *)NULL);
        return;
    }
    key = text_trim(key);
    section = key;
    for (i = key.length; i > 0 && key.start[i - 1] != '.'; i--)
        ;
    section.length = i ? i - 1 : 0;
    key.start += i;
    key.length -= i;
    name = section;
    if (i) {
        while (name.length && text_is_word(name.start[0])) {
            name.start++;
            name.length--;
        }
        section.length -= name.length;
        name = text_trim(name);
        code = find_section(section);
        if (code == SECTION_COUNT) {
            note_unknown_section(p, place, section);
            return;
        }
    }
    for (i = 0; i < p->n_uses; i++)
        if (p->uses[i].section == code &&
            (!name.length || text_equal(name, text_copy(p->uses[i].name, word, sizeof word)))) {
            use = &p->uses[i];
            found++;
        }
    if (found > 1) {
        mistake_note(&p->d->mistakes, place, "there are several [", section_table[code].name,
                     "] sections: name one of them", (char *)NULL);
        return;
    }
    if (!use && name.length) {
        mistake_note(&p->d->mistakes, place, "there is no [", section_table[code].name, " ",
                     word_of(name, word), "] in the deck", (char *)NULL);
        return;
    }
    if (!use)
        use = open_section(p, code, name, place);
    if (use)
        assign(p, use, text_trim(key), text_trim(value), place, 1);
}

/* ------------------------------------------------------------------------ second pass: the values
 */

static void note_expected(parser *p, const setting *s, const char *expected, const char *example)
{
    char word[WORD_SIZE];

    mistake_note(&p->d->mistakes, s->place, "expected ", expected, example ? ", such as " : "",
                 example ? example : "", ", not '", word_of(s->value, word), "'", (char *)NULL);
}

/* The name of a quantity of this dimension, or null. */
static const char *words_of(dimension dim)
{
    int q;

    for (q = 0; q < QUANTITY_COUNT; q++)
        if (dimension_equal(dim, quantities[q].dim))
            return quantities[q].words;
    return NULL;
}

/* The number at the front of `rest`; 0 and a mistake if there is none. */
static int read_number(parser *p, const setting *s, text *rest, quantity q, double *number)
{
    char word[WORD_SIZE];

    word_of(s->value, word);
    *rest = text_trim(*rest);
    switch (number_read(rest, number)) {
    case NUMBER_OK:
        return 1;
    case NUMBER_NOT_FINITE:
        mistake_note(&p->d->mistakes, s->place, "'", word, "' is not a finite number",
                     (char *)NULL);
        return 0;
    case NUMBER_HEX:
        mistake_note(&p->d->mistakes, s->place, "'", word, "': numbers are decimal", (char *)NULL);
        return 0;
    case NUMBER_COMMA:
        mistake_note(&p->d->mistakes, s->place, "'", word,
                     "': the decimal mark is a point, not a comma", (char *)NULL);
        return 0;
    case NUMBER_TOO_LONG:
        mistake_note(&p->d->mistakes, s->place, "'", word, "': a number of too many digits",
                     (char *)NULL);
        return 0;
    case NUMBER_NONE:
    default:
        note_expected(p, s, quantities[q].words, quantities[q].example);
        return 0;
    }
}

/* The unit that is all of `t`, or where t is empty that of the deck. */
static int read_unit(parser *p, const setting *s, text t, quantity q, unit *u)
{
    char word[WORD_SIZE], value[WORD_SIZE];
    const char *nearest, *words;
    text bad;

    t = text_trim(t);
    if (!t.length) {
        *u = p->d->units[q].unit;
        return 1;
    }
    word_of(s->value, value);
    if (!unit_read(t, u, &bad)) {
        nearest = unit_nearest(bad);
        mistake_note(&p->d->mistakes, s->place, "unknown unit '",
                     word_of(bad.length ? bad : t, word), "' in '", value, "'", hint(nearest),
                     nearest ? nearest : "", hint_end(nearest), (char *)NULL);
        return 0;
    }
    if (!dimension_equal(u->dim, quantities[q].dim)) {
        words = words_of(u->dim);
        if (words)
            mistake_note(&p->d->mistakes, s->place, "'", value, "' is ", words, "; expected ",
                         quantities[q].words, ", such as ", quantities[q].example, (char *)NULL);
        else
            mistake_note(&p->d->mistakes, s->place, "'", value, "' is not ", quantities[q].words,
                         ", such as ", quantities[q].example, (char *)NULL);
        return 0;
    }
    return 1;
}

static int check_size(parser *p, const setting *s, double si)
{
    char word[WORD_SIZE];

    if (-FOURLINK_NUMBER_MAX <= si && si <= FOURLINK_NUMBER_MAX)
        return 1;
    mistake_note(&p->d->mistakes, s->place, "'", word_of(s->value, word),
                 "' is beyond what the program computes with", (char *)NULL);
    return 0;
}

/* A number with a unit, in SI units. */
static int read_quantity(parser *p, setting *s, text t, quantity q, double *si)
{
    double number;
    unit u;

    if (!read_number(p, s, &t, q, &number) || !read_unit(p, s, t, q, &u))
        return 0;
    s->number = number;
    s->unit = u;
    *si = unit_to_si(number, u);
    return check_size(p, s, *si);
}

/* Sine and cosine, exact for whole quarters of a turn. */
static void direction_of(double angle, double *x, double *y)
{
    double quarters = angle / M_PI_2, whole = floor(quarters + 0.5);

    *x = cos(angle);
    *y = sin(angle);
    if (fabs(quarters - whole) < 1e-14 && fabs(whole) < 1e6) {
        static const double exact[4] = {1, 0, -1, 0};
        int i = (int)whole % 4;

        i = i < 0 ? i + 4 : i;
        *x = exact[i];
        *y = exact[(i + 3) % 4];
    }
}

/* 10 mm at 30 deg, or (10, 5) mm; where `angle` is not needed also 10 mm. */
static void read_vector(parser *p, setting *s, quantity q, int needs_angle)
{
    text t = s->value, part;
    double size, angle = 0, x, y;
    unit u;
    size_t i;

    if (t.length && t.start[0] == '(') {
        t.start++;
        t.length--;
        if (!read_number(p, s, &t, q, &x))
            return;
        t = text_trim(t);
        if (t.length && t.start[0] == ',') {
            t.start++;
            t.length--;
            if (!read_number(p, s, &t, q, &y))
                return;
            t = text_trim(t);
            if (t.length && t.start[0] == ')') {
                t.start++;
                t.length--;
                if (read_unit(p, s, t, q, &u)) {
                    s->si[0] = unit_to_si(x, u);
                    s->si[1] = unit_to_si(y, u);
                    if (check_size(p, s, s->si[0]))
                        check_size(p, s, s->si[1]);
                }
                return;
            }
        }
        note_expected(p, s, "two components", q == QUANTITY_FORCE ? "(43, 25) N" : "(10, 5) mm");
        return;
    }
    part = t;
    for (i = 1; i + 3 < t.length; i++)
        if (t.start[i - 1] == ' ' && t.start[i] == 'a' && t.start[i + 1] == 't' &&
            t.start[i + 2] == ' ')
            break;
    if (i + 3 < t.length) {
        part.length = i - 1;
        t.start += i + 3;
        t.length -= i + 3;
        if (!read_quantity(p, s, t, QUANTITY_ANGLE, &angle))
            return;
    } else if (needs_angle) {
        note_expected(p, s, "a force with its direction", "50 N at 30 deg or (43, 25) N");
        return;
    }
    if (!read_quantity(p, s, part, q, &size))
        return;
    direction_of(angle, &x, &y);
    s->si[0] = size * x;
    s->si[1] = size * y;
}

static void read_word(parser *p, key_code key, setting *s)
{
    const char *known[WORD_COUNT + 1];
    char list[200] = "", word[WORD_SIZE];
    size_t i, n = 0;
    const char *nearest;

    for (i = 0; i < WORD_COUNT; i++)
        if (strcmp(key_table[word_table[i].key].name, key_table[key].name) == 0 &&
            key_table[word_table[i].key].section == key_table[key].section) {
            if (text_equal(s->value, word_table[i].word)) {
                s->word = word_table[i].value;
                return;
            }
            known[n++] = word_table[i].word;
        }
    known[n] = NULL;
    for (i = 0; i < n; i++) {
        strcat(list, i == 0 ? "" : i + 1 < n ? ", " : " or ");
        strcat(list, known[i]);
    }
    nearest = text_nearest(s->value, known);
    mistake_note(&p->d->mistakes, s->place, "expected ", list, ", not '", word_of(s->value, word),
                 "'", hint(nearest), nearest ? nearest : "", hint_end(nearest), (char *)NULL);
}

static void check_sign(parser *p, const key_info *key, const setting *s)
{
    char word[WORD_SIZE];

    if (key->sign == SIGN_POSITIVE && !(s->si[0] > 0))
        mistake_note(&p->d->mistakes, s->place, "the ", key->name, " must be positive, not ",
                     word_of(s->value, word), (char *)NULL);
    else if (key->sign == SIGN_NOT_NEGATIVE && s->si[0] < 0)
        mistake_note(&p->d->mistakes, s->place, "the ", key->name, " must not be negative, not ",
                     word_of(s->value, word), (char *)NULL);
    else if (key->q == QUANTITY_LENGTH && key->sign == SIGN_POSITIVE &&
             (s->si[0] < FOURLINK_LENGTH_MIN || s->si[0] > FOURLINK_LENGTH_MAX))
        mistake_note(&p->d->mistakes, s->place, "'", word_of(s->value, word),
                     "' is beyond what the program computes with", (char *)NULL);
}

static void read_value(parser *p, key_code code, setting *s)
{
    const key_info *key = &key_table[code];
    size_t before = p->d->mistakes.count;
    text t = s->value;

    switch (key->form) {
    case FORM_TEXT:
        if (t.length >= 2 && t.start[0] == '"' && t.start[t.length - 1] == '"') {
            s->value.start++;
            s->value.length -= 2;
        }
        return;
    case FORM_WORD:
        read_word(p, code, s);
        return;
    case FORM_UNIT:
        if (read_unit(p, s, t, key->q, &s->unit)) {
            text_copy(t, p->d->units[key->q].name, DECK_NAME_SIZE);
            p->d->units[key->q].unit = s->unit;
        }
        return;
    case FORM_QUANTITY:
        read_quantity(p, s, t, key->q, &s->si[0]);
        break;
    case FORM_VECTOR:
        read_vector(p, s, key->q, 1);
        return;
    case FORM_POINT:
        read_vector(p, s, key->q, 0);
        return;
    case FORM_COUNT:
        if (!read_number(p, s, &t, key->q, &s->si[0]))
            return;
        if (t.length || s->si[0] != floor(s->si[0]))
            note_expected(p, s, "a whole number", NULL);
        break;
    case FORM_NAMES:
    default:
        return;
    }
    if (p->d->mistakes.count == before)
        check_sign(p, key, s);
}

/* Units first: they decide how bare numbers are read. */
static void read_values(parser *p)
{
    int pass, k;
    size_t i;

    for (pass = 0; pass < 2; pass++)
        for (i = 0; i < p->n_uses; i++) {
            const section_use *use = &p->uses[i];
            int first = first_key(use->section), n = key_count(use->section);

            if ((use->section == SECTION_UNITS) != (pass == 0))
                continue;
            for (k = first; k < first + n; k++) {
                setting *s = setting_of(p, use, (key_code)k);

                if (s->place.source)
                    read_value(p, (key_code)k, s);
            }
        }
}

/* ------------------------------------------------------------------------ third pass: the problem
 */

/* A value in SI units, or what it is when the deck does not set it. */
static double value_or(parser *p, key_code key, double otherwise)
{
    const setting *s = find(p, key);

    return s ? s->si[0] : otherwise;
}

/* An angle in the deck's unit of angle, without rounding if it is written in that. */
static double angle_or(parser *p, key_code key, double otherwise)
{
    const setting *s = find(p, key);
    const unit *u = &p->d->units[QUANTITY_ANGLE].unit;

    if (!s)
        return otherwise;
    if (s->unit.up == u->up && s->unit.down == u->down)
        return s->number;
    return s->si[0] * u->down / u->up;
}

static text_place end_of_deck(parser *p)
{
    text_place place;

    place.source = p->name;
    place.line = p->last_line;
    return place;
}

/* The length a mechanism cannot do without. */
static void require(parser *p, key_code key)
{
    const key_info *k = &key_table[key];
    const section_use *use = find_use(p, k->section);

    if (find(p, key))
        return;
    if (use)
        mistake_note(&p->d->mistakes, use->place, "[", section_table[k->section].name, "] has no ",
                     k->name, (char *)NULL);
    else
        mistake_note(&p->d->mistakes, end_of_deck(p), "there is no [",
                     section_table[k->section].name, "] with a ", k->name, " in it", (char *)NULL);
}

static void build_link(parser *p, key_code length, int number)
{
    fourlink_link *link = &p->d->design.link[number];
    key_code mass = length + 1, gyration = length + 2, inertia = length + 3, cg = length + 4;
    const setting *s;

    require(p, length);
    link->length = value_or(p, length, 0);
    link->mass = value_or(p, mass, 0);
    link->inertia = value_or(p, inertia, 0);
    if ((s = find(p, gyration)) != NULL) {
        if (find(p, inertia))
            mistake_note(&p->d->mistakes, s->place,
                         "give either the gyration or the inertia, not both", (char *)NULL);
        if (!find(p, mass))
            mistake_note(&p->d->mistakes, s->place, "a radius of gyration needs a mass",
                         (char *)NULL);
        link->inertia = link->mass * s->si[0] * s->si[0]; /* I = m k^2 */
    }
    if ((s = find(p, cg)) != NULL) {
        link->cg.x = s->si[0];
        link->cg.y = s->si[1];
    }
}

/* The mechanism's kind, and that each section and key is one that it has. */
static int build_kind(parser *p)
{
    const setting *s = find(p, KEY_TOP_MECHANISM);
    size_t i;
    fourlink_kind kind;
    int k;

    if (!s) {
        text_place place = end_of_deck(p);

        place.line = 1;
        mistake_note(&p->d->mistakes, place, "expected 'mechanism = four-bar' or 'mechanism = ",
                     "slider-crank' before the first section", (char *)NULL);
        return 0;
    }
    if (!s->word)
        return 0;
    kind = (fourlink_kind)s->word;
    p->d->design.kind = kind;
    for (i = 0; i < p->n_uses; i++) {
        const section_use *use = &p->uses[i];
        int first = first_key(use->section), n = key_count(use->section);

        if (!(section_table[use->section].kinds & (int)kind)) {
            mistake_note(&p->d->mistakes, use->place, "a ", kind_words(kind), " has no [",
                         section_table[use->section].name, "]",
                         use->section == SECTION_COUPLER ? "; its link 3 is the [rod]"
                         : use->section == SECTION_ROD   ? "; its link 3 is the [coupler]"
                                                         : "",
                         (char *)NULL);
            continue;
        }
        for (k = first; k < first + n; k++) {
            s = setting_of(p, use, (key_code)k);
            if (s->place.source && !(key_table[k].kinds & (int)kind))
                mistake_note(&p->d->mistakes, s->place, "the ", section_table[use->section].name,
                             " of a ", kind_words(kind), " has no ", key_table[k].name,
                             (char *)NULL);
        }
    }
    return 1;
}

/* The links reach at some angle if no link is longer than the other three together; of a
** slider-crank, if crank and rod together reach the line of stroke. */
static void check_reach(parser *p)
{
    static const key_code keys[4] = {KEY_GROUND_LENGTH, KEY_CRANK_LENGTH, KEY_COUPLER_LENGTH,
                                     KEY_ROCKER_LENGTH};
    const fourlink_design *design = &p->d->design;
    const unit *u = &p->d->units[QUANTITY_LENGTH].unit;
    char rest[NUMBER_SIZE], word[WORD_SIZE];
    int i, longest = 0;
    double sum = 0;

    if (design->kind == FOURLINK_SLIDER_CRANK) {
        const setting *s = find(p, KEY_GROUND_OFFSET);

        sum = design->link[2].length + design->link[3].length;
        if (s && fabs(design->offset) > sum)
            mistake_note(&p->d->mistakes, s->place, "the offset, ", word_of(s->value, word),
                         ", is more than crank and rod together, ",
                         number_general(sum * u->down / u->up, 6, rest), " ",
                         p->d->units[QUANTITY_LENGTH].name, ": the rod never reaches",
                         (char *)NULL);
        return;
    }
    for (i = 0; i < 4; i++) {
        sum += design->link[i + 1].length;
        if (design->link[i + 1].length > design->link[longest + 1].length)
            longest = i;
    }
    sum -= design->link[longest + 1].length;
    if (design->link[longest + 1].length > sum * (1 + 1e-14)) {
        const setting *s = find(p, keys[longest]);

        mistake_note(&p->d->mistakes, s->place, "the ",
                     section_table[key_table[keys[longest]].section].name, ", ",
                     word_of(s->value, word), ", is longer than the other three together, ",
                     number_general(sum * u->down / u->up, 6, rest), " ",
                     p->d->units[QUANTITY_LENGTH].name, ": they cannot be assembled", (char *)NULL);
    }
}

static void build_mechanism(parser *p)
{
    fourlink_design *design = &p->d->design;
    double direction, g;
    const setting *s;
    int i;

    if (design->kind == FOURLINK_FOUR_BAR) {
        require(p, KEY_GROUND_LENGTH);
        design->link[FOURLINK_GROUND].length = value_or(p, KEY_GROUND_LENGTH, 0);
        build_link(p, KEY_CRANK_LENGTH, FOURLINK_CRANK);
        build_link(p, KEY_COUPLER_LENGTH, FOURLINK_COUPLER);
        build_link(p, KEY_ROCKER_LENGTH, FOURLINK_FOLLOWER);
    } else {
        design->offset = value_or(p, KEY_GROUND_OFFSET, 0);
        build_link(p, KEY_CRANK_LENGTH, FOURLINK_CRANK);
        build_link(p, KEY_ROD_LENGTH, FOURLINK_COUPLER);
        design->link[FOURLINK_FOLLOWER].mass = value_or(p, KEY_PISTON_MASS, 0);
    }
    g = value_or(p, KEY_GRAVITY_ACCELERATION, 9.81);
    direction = value_or(p, KEY_GRAVITY_DIRECTION, -M_PI_2) - value_or(p, KEY_GROUND_ANGLE, 0);
    direction_of(direction, &design->gravity.x, &design->gravity.y);
    design->gravity.x *= g;
    design->gravity.y *= g;
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        if (design->link[i].mass > 0 || design->link[i].inertia > 0)
            p->d->has_forces = 1;
    if (p->d->mistakes.count)
        return;
    check_reach(p);
    i = fourlink_prepare(design, &p->d->mechanism);
    s = find(p, KEY_CRANK_LENGTH);
    if (i != FOURLINK_OK)
        mistake_note(&p->d->mistakes, s->place, fourlink_status_text(i), (char *)NULL);
}

static void build_load(parser *p, const section_use *use, fourlink_load *load)
{
    const setting *link = setting_of(p, use, KEY_LOAD_LINK);
    const setting *force = setting_of(p, use, KEY_LOAD_FORCE),
                  *at = setting_of(p, use, KEY_LOAD_AT);
    const setting *torque = setting_of(p, use, KEY_LOAD_TORQUE);
    char word[WORD_SIZE];
    int four_bar = p->d->design.kind == FOURLINK_FOUR_BAR;

    if (!link->place.source) {
        mistake_note(&p->d->mistakes, use->place, "[load] has no link: ",
                     four_bar ? "crank, coupler or rocker" : "crank, rod or piston", (char *)NULL);
    } else if (four_bar ? text_equal(link->value, "rod") || text_equal(link->value, "piston")
                        : text_equal(link->value, "coupler") || text_equal(link->value, "rocker")) {
        mistake_note(&p->d->mistakes, link->place, "a ", kind_words(p->d->design.kind), " has no ",
                     word_of(link->value, word), ": its links are ",
                     four_bar ? "crank, coupler and rocker" : "crank, rod and piston",
                     (char *)NULL);
    }
    if (!force->place.source && !torque->place.source)
        mistake_note(&p->d->mistakes, use->place, "[load] has neither a force nor a torque",
                     (char *)NULL);
    if (at->place.source && !force->place.source)
        mistake_note(&p->d->mistakes, at->place, "'at' is for a force", (char *)NULL);
    load->link = link->word;
    load->frame = FOURLINK_FRAME_GROUND;
    load->force.x = force->si[0];
    load->force.y = force->si[1];
    load->at.x = at->si[0];
    load->at.y = at->si[1];
    load->torque = torque->si[0];
}

static void build_loads(parser *p)
{
    size_t i, n = 0;

    for (i = 0; i < p->n_uses; i++)
        n += p->uses[i].section == SECTION_LOAD;
    if (!n)
        return;
    p->d->loads = calloc(n, sizeof *p->d->loads);
    if (!p->d->loads) {
        p->out_of_memory = 1;
        return;
    }
    for (i = 0; i < p->n_uses; i++)
        if (p->uses[i].section == SECTION_LOAD)
            build_load(p, &p->uses[i], &p->d->loads[p->d->n_loads++]);
    p->d->has_forces = 1;
}

static void build_motion(parser *p)
{
    fourlink_motion *motion = &p->d->motion;
    const unit *u = &p->d->units[QUANTITY_ANGLE].unit;
    const setting *run_up = find(p, KEY_MOTION_RUN_UP), *s;
    double cycle, turning;
    fourlink_range range;
    int status;

    motion->angle_unit = u->up / u->down;
    motion->speed = value_or(p, KEY_MOTION_SPEED, 0);
    motion->acceleration = value_or(p, KEY_MOTION_ACCELERATION, 0);
    s = find(p, KEY_MOTION_HOLD);
    motion->hold = s ? s->word : 0;
    motion->interval = angle_or(p, KEY_MOTION_INTERVAL, 10 * (M_PI / 180) / motion->angle_unit);
    if (u->up == M_PI && u->down == 180)
        motion->interval = angle_or(p, KEY_MOTION_INTERVAL, 10);
    if ((s = find(p, KEY_MOTION_AT)) != NULL) {
        motion->from = angle_or(p, KEY_MOTION_AT, 0);
        motion->to = motion->from;
        p->d->one_instant = 1;
        return;
    }
    cycle = angle_or(p, KEY_MOTION_CYCLE, floor(2 * M_PI * u->down / u->up * 1e9 + 0.5) / 1e9);
    turning = motion->speed != 0 ? motion->speed : motion->acceleration;
    motion->from = angle_or(p, KEY_MOTION_FROM, 0);
    motion->to = angle_or(p, KEY_MOTION_TO, motion->from + (turning < 0 ? -cycle : cycle));
    p->d->one_revolution =
        fabs(fabs(motion->to - motion->from) * motion->angle_unit - 2 * M_PI) < 1e-9;
    if (run_up) {
        motion->run_up = angle_or(p, KEY_MOTION_RUN_UP, 0);
        p->d->one_revolution = 1;
        if ((s = find(p, KEY_MOTION_SPEED)) != NULL && s->si[0] != 0)
            mistake_note(&p->d->mistakes, s->place,
                         "a run-up starts from rest: it takes an acceleration and no speed",
                         (char *)NULL);
        if ((s = find(p, KEY_MOTION_TO)) != NULL)
            mistake_note(&p->d->mistakes, s->place,
                         "a run-up ends one revolution after its angle: it takes no 'to'",
                         (char *)NULL);
        if (motion->hold)
            mistake_note(&p->d->mistakes, run_up->place, "a run-up cannot hold its speed",
                         (char *)NULL);
    }
    if (p->d->mistakes.count)
        return;
    status = fourlink_motion_range(motion, &range);
    if (status == FOURLINK_BAD_RANGE) {
        s = find(p, KEY_MOTION_TO);
        mistake_note(&p->d->mistakes, s ? s->place : end_of_deck(p),
                     "the range runs against the rotation of the accelerated crank; turn it round, "
                     "or give 'hold = yes'",
                     (char *)NULL);
    } else if (status == FOURLINK_NO_RUN_UP) {
        mistake_note(&p->d->mistakes, run_up->place, "a run-up from rest needs an acceleration",
                     (char *)NULL);
    } else if (status != FOURLINK_OK) {
        s = find(p, KEY_MOTION_INTERVAL);
        mistake_note(&p->d->mistakes, s ? s->place : end_of_deck(p), fourlink_status_text(status),
                     (char *)NULL);
    }
}

static void build_table(parser *p)
{
    const setting *s = find(p, KEY_TABLE_BRANCH);
    int branches = s ? s->word : BRANCH_BOTH;
    char word[WORD_SIZE];

    p->d->open = (branches & BRANCH_OPEN) != 0;
    p->d->crossed = (branches & BRANCH_CROSSED) != 0;
    if ((s = find(p, KEY_TABLE_COLUMNS)) != NULL) {
        p->d->columns.names = s->value;
        p->d->columns.place = s->place;
    }
    p->d->digits = 6;
    if ((s = find(p, KEY_TABLE_DIGITS)) != NULL) {
        if (s->si[0] > 17)
            mistake_note(&p->d->mistakes, s->place, "digits must be 1 to 17, not ",
                         word_of(s->value, word), (char *)NULL);
        else
            p->d->digits = (int)s->si[0];
    }
}

static void build(parser *p)
{
    const setting *title = find(p, KEY_TOP_TITLE);

    if (title)
        text_copy(title->value, p->d->title, sizeof p->d->title);
    if (!build_kind(p))
        return;
    build_mechanism(p);
    build_loads(p);
    build_motion(p);
    build_table(p);
}

/* --------------------------------------------------------------------------------- the entrances
 */

static void set_default_units(deck *d)
{
    text bad;
    int q;

    for (q = 0; q < QUANTITY_COUNT; q++) {
        strcpy(d->units[q].name, quantities[q].unit);
        unit_read(text_of(quantities[q].unit), &d->units[q].unit, &bad);
    }
}

/* One copy of the deck and of the changes: values are pieces of it. */
static int store(deck *d, text contents, const deck_change *changes, size_t n_changes)
{
    size_t size = contents.length + 1, i;
    char *end;

    for (i = 0; i < n_changes; i++)
        size += strlen(changes[i].assignment) + 1;
    d->storage = malloc(size);
    if (!d->storage)
        return 0;
    if (contents.length)
        memcpy(d->storage, contents.start, contents.length);
    end = d->storage + contents.length;
    *end++ = '\0';
    for (i = 0; i < n_changes; i++) {
        strcpy(end, changes[i].assignment);
        end += strlen(end) + 1;
    }
    return 1;
}

int deck_read(const char *name, text contents, const deck_change *changes, size_t n_changes,
              deck *d)
{
    parser p;
    char *change;
    size_t i;

    memset(d, 0, sizeof *d);
    memset(&p, 0, sizeof p);
    p.d = d;
    p.name = name;
    set_default_units(d);
    if (!store(d, contents, changes, n_changes))
        return -1;
    contents.start = d->storage;
    read_lines(&p, contents);
    change = d->storage + contents.length + 1;
    for (i = 0; i < n_changes && !p.out_of_memory; i++) {
        apply_change(&p, changes[i].option, text_of(change));
        change += strlen(change) + 1;
    }
    if (!p.out_of_memory)
        read_values(&p);
    if (!p.out_of_memory)
        build(&p);
    mistakes_sort(&d->mistakes);
    free(p.uses);
    free(p.settings);
    if (p.out_of_memory)
        return -1;
    return d->mistakes.count == 0;
}

void deck_free(deck *d)
{
    mistakes_free(&d->mistakes);
    free(d->loads);
    free(d->storage);
    memset(d, 0, sizeof *d);
}
