/* SPDX-License-Identifier: GPL-3.0-or-later
**
** settings.c - the sections of a deck and the settings of their keys, from the deck, from --set, or for a
** design of a sweep.
*/
#include <string.h>

#include "parser.h"
#include "settings.h"

section_use *flk_section_open(parser *p, section_code section, text name, text_place place,
                              const char *start)
{
    section_use *uses = flk_reader_grow(p, p->uses, &p->uses_capacity, p->n_uses, sizeof *uses),
                *use;
    setting *settings = flk_reader_keep(p, flk_section_keys(section) * sizeof *settings);

    if (uses)
        p->uses = uses;
    if (!uses || !settings)
        return NULL;
    use = &uses[p->n_uses++];
    if (!p->first_use[section])
        p->first_use[section] = p->n_uses;
    use->section = section;
    use->name = name;
    use->place = place;
    use->start = start;
    use->settings = settings;
    return use;
}

/* Compare names that users choose; case matters. */
static int same_name(text x, text y)
{
    return x.length == y.length && (!x.length || memcmp(x.start, y.start, x.length) == 0);
}

section_use *flk_section_next(const parser *p, section_code section, const section_use *after)
{
    size_t first = p->first_use[section], i;

    if (!after)
        return first ? &p->uses[first - 1] : NULL;
    for (i = (size_t)(after - p->uses) + 1; i < p->n_uses; i++)
        if (p->uses[i].section == section)
            return &p->uses[i];
    return NULL;
}

section_use *flk_section_find(const parser *p, section_code section, const text *name)
{
    section_use *use = flk_section_next(p, section, NULL);

    while (use && name && !same_name(use->name, *name))
        use = flk_section_next(p, section, use);
    return use;
}

int flk_section_is_mistaken(parser *p, section_code section)
{
    const section_use *use = flk_section_find(p, section, NULL);

    return use && use->is_mistaken;
}

setting *flk_setting_of(const section_use *use, key_code key)
{
    return &use->settings[key - flk_first_key(flk_key_table[key].section)];
}

static const setting unset;

const setting *flk_setting_find(parser *p, key_code key)
{
    const section_use *use = flk_section_find(p, flk_key_table[key].section, NULL);

    return use ? flk_setting_of(use, key) : &unset;
}

const setting *flk_setting_by_name(parser *p, section_code section, const char *key)
{
    key_code i, end = flk_first_key(section + 1);

    for (i = flk_first_key(section); i < end; i++)
        if (flk_key_table[i].name[0] == key[0] && strcmp(flk_key_table[i].name, key) == 0)
            return flk_setting_find(p, i);
    return &unset;
}

double flk_setting_or(parser *p, key_code key, double otherwise)
{
    const setting *s = flk_setting_find(p, key);

    if (!IS_SET(s))
        return otherwise;
    return flk_key_table[key].form == FORM_CRANK ? flk_setting_crank_angle(p, s) : s->si[0];
}

double flk_setting_crank_angle(const parser *p, const setting *s)
{
    return IS_DRAWN(s) ? flk_deck_drawn(p->d) : s->si[0];
}

double flk_setting_in_unit(parser *p, const setting *s, quantity q)
{
    const unit *u = &p->d->units[q].unit;

    if (IS_DRAWN(s))
        return flk_unit_from_si(flk_setting_crank_angle(p, s), *u);
    if (s->unit.up == u->up && s->unit.down == u->down)
        return s->number;
    return flk_unit_from_si(s->si[0], *u);
}

/* 1 if a key has the same value: the text, the numbers that it is read as, the points of a curve. */
static int are_same(const setting *x, const setting *y)
{
    size_t i;

    if (IS_SET(x) != IS_SET(y) || !same_name(x->value, y->value) || x->si[0] != y->si[0] ||
        x->si[1] != y->si[1] || x->word != y->word || x->n_points != y->n_points ||
        !x->parts != !y->parts)
        return 0;
    for (i = 0; i < x->n_points; i++)
        if (x->curve[i].x != y->curve[i].x || x->curve[i].y[0] != y->curve[i].y[0] ||
            x->curve[i].y[1] != y->curve[i].y[1])
            return 0;
    for (i = 0; x->parts && i < PART_NONE; i++)
        if (!are_same(&x->parts[i], &y->parts[i]))
            return 0;
    return 1;
}

/* What has no part in the mechanism and its motion. */
static int is_of_output(section_code section)
{
    return section == SECTION_TABLE || section == SECTION_EXPECT || section == SECTION_MISPRINT ||
           section == SECTION_GRADING;
}

static int is_step_of_rows(section_code section, size_t key)
{
    return section == SECTION_MOTION && (key == KEY_MOTION_INTERVAL - flk_first_key(section) ||
                                         key == KEY_MOTION_TIME_STEP - flk_first_key(section));
}

/* The next section that has a part in the motion; null: there is none. */
static const section_use *next_of_motion(const parser *p, size_t *i)
{
    while (*i < p->n_uses && is_of_output(p->uses[*i].section))
        ++*i;
    return *i < p->n_uses ? &p->uses[(*i)++] : NULL;
}

static int have_same_settings(const parser *p, const parser *other)
{
    const section_use *x, *y;
    size_t i = 0, j = 0, k;

    for (;;) {
        x = next_of_motion(p, &i);
        y = next_of_motion(other, &j);
        if (!x || !y)
            return !x && !y;
        if (x->section != y->section || !same_name(x->name, y->name))
            return 0;
        for (k = 0; k < flk_section_keys(x->section); k++)
            if (!is_step_of_rows(x->section, k) && !are_same(&x->settings[k], &y->settings[k]))
                return 0;
    }
}

int flk_settings_move_alike(const deck *d, const deck *other)
{
    const fourlink_motion *x = &d->motion, *y = &other->motion;

    if (x->angle_unit != y->angle_unit || x->from != y->from || x->to != y->to ||
        !d->found != !other->found)
        return 0;
    return d->found ? have_same_settings(d->found, other->found)
                    : have_same_settings(d->settings, other->settings);
}

/* Words that people use, and the words they mean. */
static const struct {
    const char *written, *meant;
} synonyms[] = {{"connecting", "rod"}, {"conrod", "rod"},         {"follower", "rocker"},
                {"frame", "ground"},   {"fixed", "ground"},       {"link1", "ground"},
                {"link2", "crank"},    {"link3", "coupler"},      {"link4", "rocker"},
                {"input", "crank"},    {"slider", "piston"},      {"cylinder", "gas"},
                {"force", "load"},     {"omega", "speed"},        {"rpm", "speed"},
                {"velocity", "speed"}, {"alpha", "acceleration"}, {"step", "interval"},
                {"g", "acceleration"}, {"weight", "mass"},        {"k", "gyration"},
                {"radius", "length"},  {"theta2", "crank"},       {"theta4", "rocker"},
                {"output", "rocker"},  {"ratio", "time_ratio"}};

/* The nearest word, by meaning or by spelling, or null. */
static const char *nearest_word(text word, const char *const *known)
{
    size_t i, j;

    for (i = 0; i < sizeof synonyms / sizeof synonyms[0]; i++)
        for (j = 0; flk_text_equal(word, synonyms[i].written) && known[j]; j++)
            if (strcmp(known[j], synonyms[i].meant) == 0)
                return known[j];
    return flk_text_nearest(word, known);
}

int flk_section_unknown(parser *p, text_place place, text name)
{
    const char *known[SECTION_COUNT + MOST_OTHER_LINKS];
    int i;

    p->has_unknown_section = 1;
    if (flk_mistakes_are_full(p->mistakes))
        return flk_mistake(p->mistakes, place, "");
    for (i = 1; i < SECTION_COUNT; i++)
        known[i - 1] = flk_section_table[i].name;
    flk_link_add_others(flk_setting_kind(p), known, SECTION_COUNT - 1);
    return flk_mistake(p->mistakes, place, "unknown section '%t'%h", name,
                       nearest_word(name, known));
}

/* The first section, except the units, that has this key; SECTION_COUNT if none has. */
static section_code section_with(text key)
{
    int i;

    for (i = 0; i < KEY_COUNT; i++)
        if (flk_text_equal(key, flk_key_table[i].name) && flk_key_table[i].section != SECTION_UNITS)
            return flk_key_table[i].section;
    return SECTION_COUNT;
}

static int refuse_key(parser *p, text_place place, section_code section, text key)
{
    const char *known[KEY_COUNT + 1], *nearest;
    char where[MESSAGE_SIZE];
    section_code other;
    key_code first = flk_first_key(section), i;

    if (flk_mistakes_are_full(p->mistakes))
        return flk_mistake(p->mistakes, place, "");
    other = section_with(key);
    for (i = first; i < flk_first_key(section + 1); i++)
        known[i - first] = flk_key_table[i].name;
    known[i - first] = NULL;
    nearest = nearest_word(key, known);
    flk_message(where, sizeof where,
                section == SECTION_TOP ? "unknown key '%t' before the first section"
                                       : "unknown key '%t' in [%s]",
                key, flk_section_table[section].name);
    if (other == SECTION_TOP)
        return flk_mistake(p->mistakes, place, "%s; it belongs before the first section", where);
    if (!nearest && other != SECTION_COUNT)
        return flk_mistake(p->mistakes, place, "%s; it belongs in a section such as [%s]", where,
                           flk_section_table[other].name);
    return flk_mistake(p->mistakes, place, "%s%h", where, nearest);
}

int flk_output_link(const parser *p, text name)
{
    const section_use *use = NULL;
    text rod;
    int i;

    for (i = 0; (use = flk_section_next(p, SECTION_OUTPUT, use)) != NULL; i++) {
        rod = flk_text_from(name, name.length < use->name.length ? name.length : use->name.length);
        if (use->name.length && name.length >= use->name.length &&
            memcmp(name.start, use->name.start, use->name.length) == 0 &&
            i < FOURLINK_MOST_GROUPS && (!rod.length || flk_text_same(rod, ".rod")))
            return FOURLINK_ROD_OF(i) + !rod.length;
    }
    return 0;
}

int flk_output_has_slot(const parser *p, int rod)
{
    const section_use *use = NULL;
    int i;

    for (i = 0; (use = flk_section_next(p, SECTION_OUTPUT, use)) != NULL; i++)
        if (FOURLINK_ROD_OF(i) == rod)
            return IS_SET(flk_setting_of(use, KEY_OUTPUT_SLOT));
    return 0;
}

int flk_setting_kind(const parser *p)
{
    const section_use *top = flk_section_find(p, SECTION_TOP, NULL);
    const setting *s = top ? flk_setting_of(top, KEY_TOP_MECHANISM) : NULL;
    const word_info *word = s && IS_SET(s) ? flk_word_find(KEY_TOP_MECHANISM, 0, s->value) : NULL;

    return word ? word->value : 0;
}

section_code flk_section_meant(const parser *p, text name)
{
    return flk_find_section(flk_link_meant(flk_setting_kind(p), name));
}

void flk_section_split(text *section, text *name)
{
    *name = *section;
    if (flk_link_is_other(*section))
        *name = flk_text_from(*name, name->length);
    while (name->length && flk_text_is_word(name->start[0]) && !flk_text_blank(*name))
        *name = flk_text_from(*name, 1);
    section->length -= name->length;
    *name = flk_text_trim(*name);
}

/* The slot of a name in the hash table, or a free one for it (FNV-1a, G. Fowler, L. C. Noll, K.-P. Vo). */
static size_t *find_slot(parser *p, size_t use, text name)
{
    unsigned long hash = (2166136261UL + (unsigned long)use) & 0xffffffffUL;
    size_t i;

    for (i = 0; i < name.length; i++)
        hash = ((hash ^ (unsigned char)name.start[i]) * 16777619UL) & 0xffffffffUL;
    for (i = (size_t)hash % p->n_slots; p->named_slots[i]; i = (i + 1) % p->n_slots) {
        const named_value *named = &p->named[p->named_slots[i] - 1];

        if (named->use == use && same_name(named->name, name))
            break;
    }
    return &p->named_slots[i];
}

/* Make room for one more name; at least half of the slots stay free. */
static int grow_named(parser *p)
{
    named_value *list =
        flk_reader_grow(p, p->named, &p->named_capacity, p->n_named, sizeof *p->named);
    size_t i;

    if (!list)
        return 0;
    p->named = list;
    if (p->n_slots == 2 * p->named_capacity)
        return 1;
    p->n_slots = 2 * p->named_capacity;
    p->named_slots = flk_reader_keep(p, p->n_slots * sizeof *p->named_slots);
    if (!p->named_slots)
        return 0;
    for (i = 0; i < p->n_named; i++)
        *find_slot(p, p->named[i].use, p->named[i].name) = i + 1;
    return 1;
}

/* Set a name in a section that takes names. */
static void set_named(parser *p, text_place place, const target *t, text value, value_source source)
{
    size_t *slot;
    named_value *named;

    if (p->is_answers && t->name.length && !value.length)
        return; /* a form that is not filled in: the value is missing */
    if (!t->name.length || !value.length) {
        flk_mistake(p->mistakes, place, "expected NAME = VALUE, not '%t'", t->name);
        return;
    }
    if (!grow_named(p))
        return;
    slot = find_slot(p, t->use, t->name);
    if (*slot && p->is_answers) {
        *slot = 0; /* another answer: both have to be right */
    } else if (*slot && source == GIVEN_BY_TEXT) {
        flk_mistake(p->mistakes, place, "'%t' is given twice", t->name);
        return;
    }
    if (!*slot)
        *slot = ++p->n_named;
    named = &p->named[*slot - 1];
    named->use = t->use;
    named->name = t->name;
    named->place = place;
    named->value = flk_reader_plain(p, value);
    named->source = source;
    p->has_changed_names |= source != GIVEN_BY_TEXT;
    if (source == GIVEN_BY_TEXT)
        named->own = value;
}

/* Find a key of a section; 0 and a mistake if the section cannot have it. */
static int find_key(parser *p, text_place place, const section_use *use, text key, target *t)
{
    t->use = (size_t)(use - p->uses);
    t->key = flk_find_key(use->section, key);
    if (t->key == KEY_COUNT && !TAKES_NAMES(use->section)) {
        p->uses[t->use].is_mistaken = 1;
        return refuse_key(p, place, use->section, key);
    }
    t->part = PART_NONE;
    t->name = key;
    return 1;
}

static void set_value(text_place place, setting *s, text value, value_source source)
{
    text own = source == GIVEN_BY_TEXT && !IS_SET(s) ? value : s->own;
    text line = source == GIVEN_BY_DESIGN && IS_SET(s) ? s->line : value;

    memset(s, 0, sizeof *s);
    s->place = place;
    s->own = own;
    s->value = value;
    s->line = line;
    s->source = source;
}

int flk_section_unshare(parser *p, section_use *use)
{
    size_t size = flk_section_keys(use->section) * sizeof *use->settings;
    setting *copy;

    if (!use->is_shared)
        return 1;
    copy = flk_reader_keep(p, size);
    if (!copy)
        return 0;
    use->settings = memcpy(copy, use->settings, size);
    use->is_shared = 0;
    return 1;
}

/* x and y, or size and angle */
static setting *set_part(parser *p, text_place place, const target *t, setting *s, text value,
                         value_source source)
{
    vector_part other = t->part < PART_SIZE ? PART_SIZE : PART_X;
    setting *parts = flk_reader_keep(p, PART_NONE * sizeof *s->parts);

    if (!parts)
        return NULL;
    if (!IS_SET(s))
        set_value(place, s, flk_text_of("(0, 0)"), GIVEN_BY_CHANGE);
    if (s->parts) /* may belong to the deck that this is a design of */
        memcpy(parts, s->parts, PART_NONE * sizeof *parts);
    set_value(s->place, s, s->value, s->source); /* discards what was read from the old value */
    s->parts = parts;
    if (IS_SET(&parts[other]) || IS_SET(&parts[other + 1])) {
        flk_mistake(p->mistakes, place,
                    "'%t' and another part of it: set x and y, or size and angle", t->name);
        return NULL;
    }
    set_value(place, &parts[t->part], value, source);
    return &parts[t->part];
}

/* key = value; `t->name` has the text of the key.  Returns the setting of a key or a part, null for a name
** and after a mistake. */
static setting *set_target(parser *p, text_place place, const target *t, text value,
                           value_source source)
{
    section_use *use = &p->uses[t->use];
    setting *s;

    if (t->key == KEY_COUNT)
        set_named(p, place, t, value, source);
    if (t->key == KEY_COUNT || !flk_section_unshare(p, use))
        return NULL;
    use->is_read = 0;
    s = flk_setting_of(use, t->key);
    if (IS_SET(s) && source == GIVEN_BY_TEXT)
        flk_mistake(p->mistakes, place, "'%t' is given twice; first at line %ld", t->name,
                    s->place.line);
    else if (!value.length)
        flk_mistake(p->mistakes, place, "expected a value after '%t ='", t->name);
    else if (t->part != PART_NONE)
        return set_part(p, place, t, s, value, source);
    else {
        set_value(place, s, value, source);
        return s;
    }
    return NULL;
}

void flk_setting_read(parser *p, text_place place, const section_use *use, text key, text value)
{
    target t;

    if (find_key(p, place, use, key, &t))
        set_target(p, place, &t, value, GIVEN_BY_TEXT);
}

const char *const flk_part_names[] = {"x", "y", "size", "angle"};

/* The pieces of [SECTION[ NAME].]KEY[.PART]. */
typedef struct path {
    text section, name, key;
    text whole;        /* without the part */
    section_code code; /* SECTION_COUNT: there is no such section */
    vector_part part;
} path;

static path path_of(const parser *p, text whole)
{
    static const path top = {{"", 0}, {"", 0}, {"", 0}, {"", 0}, SECTION_TOP, PART_NONE};
    path a = top;
    text before, last;
    int i;

    a.key = a.whole = whole;
    if (flk_text_cut(whole, ".", &a.section, &a.key) && flk_text_equal(a.section, "sweep")) {
        a.code = SECTION_SWEEP; /* the rest is a name */
        return a;
    }
    if (flk_text_cut_last(whole, ".", &before, &last) && flk_text_count(before, '.'))
        for (i = 0; i < PART_NONE; i++)
            if (flk_text_equal(last, flk_part_names[i])) {
                a.part = (vector_part)i;
                a.whole = before;
            }
    if (flk_text_cut_last(a.whole, ".", &a.section, &a.key)) {
        flk_section_split(&a.section, &a.name);
        a.code = flk_section_meant(p, a.section);
    }
    return a;
}

/* The section that "section NAME" in an assignment refers to, or the only section; null and a mistake if
** there are several, or none with this name. */
static section_use *find_section(parser *p, text_place place, section_code code, text name)
{
    section_use *use = name.length ? flk_section_find(p, code, &name) : NULL, *other = NULL;
    char word[DECK_NAME_SIZE];
    size_t found = 0;

    if (use)
        return use;
    while ((other = flk_section_next(p, code, other)) != NULL)
        if (!name.length || flk_text_equal(name, flk_text_copy(other->name, word, sizeof word))) {
            use = other;
            found++;
        }
    if (found > 1)
        flk_mistake(p->mistakes, place, "there are several [%s] sections: name one of them",
                    flk_section_table[code].name);
    else if (!found && name.length)
        flk_mistake(p->mistakes, place, "there is no [%s %t] in the deck",
                    flk_section_table[code].name, name);
    else
        return use ? use : flk_section_open(p, code, name, place, NULL);
    return NULL;
}

/* 1 if a key takes a force or a point. */
static int is_vector(key_code key)
{
    return key != KEY_COUNT &&
           (flk_key_table[key].form == FORM_POINT || flk_key_table[key].form == FORM_VECTOR ||
            flk_key_table[key].form == FORM_PLACE);
}

/* 1 if the target is a vector whose parts can be set.  A force must be in the deck; a point defaults to the
** origin of the link. */
static int has_parts(parser *p, text_place place, const target *t, text key)
{
    setting *s = is_vector(t->key) ? flk_setting_of(&p->uses[t->use], t->key) : NULL;

    if (s && (IS_SET(s) || flk_key_table[t->key].form == FORM_POINT))
        return 1;
    return flk_mistake(p->mistakes, place,
                       s ? "'%t' is not in the deck: give it before you vary a part of it"
                         : "'%t' has no parts that can be varied",
                       key);
}

int flk_setting_target(parser *p, text_place place, text whole, target *t)
{
    path a = path_of(p, whole);
    section_use *use;

    if (a.code == SECTION_COUNT)
        return flk_section_unknown(p, place, a.section);
    use = find_section(p, place, a.code, a.name);
    if (!use || !find_key(p, place, use, a.key, t))
        return 0;
    t->part = a.part;
    return a.part == PART_NONE || has_parts(p, place, t, a.whole);
}

int flk_setting_look(const parser *p, text whole, target *t)
{
    path a = path_of(p, whole);
    const section_use *use;

    if (a.code == SECTION_COUNT || a.code == SECTION_TOP)
        return 0;
    use = flk_section_find(p, a.code, &a.name);
    if (!use && !a.name.length) {
        use = flk_section_next(p, a.code, NULL);
        use = use && !flk_section_next(p, a.code, use) ? use : NULL; /* the only one */
    }
    if (!use)
        return 0;
    t->use = (size_t)(use - p->uses);
    t->part = a.part;
    t->name = a.key;
    t->key = flk_find_key(a.code, a.key);
    return t->key != KEY_COUNT && (a.part == PART_NONE || is_vector(t->key));
}

void flk_setting_vary(parser *p, text_place place, const target *t, const quantity_value *number,
                      text value)
{
    setting *s = set_target(p, place, t, value, GIVEN_BY_DESIGN);

    if (!s)
        return;
    s->number = number->number;
    s->unit = number->unit;
    s->is_number = 1;
}

void flk_setting_assign(parser *p, text_place place, text key, text value)
{
    target t;

    if (flk_setting_target(p, place, key, &t))
        set_target(p, place, &t, value, GIVEN_BY_CHANGE);
}
