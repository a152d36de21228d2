/* SPDX-License-Identifier: GPL-3.0-or-later
**
** lines.c - first pass over a deck: its lines.
*/
#include <string.h>

#include "lines.h"
#include "parser.h"
#include "settings.h"

#define LINE_MAX_LENGTH 65536
#define MOST_LINES 4000000
#define MOST_SECTIONS 10000

/* 1 if this section is allowed here; otherwise 0 and a mistake. */
static int check_section(parser *p, text_place place, section_code section, text name)
{
    const section_info *info = &flk_section_table[section];
    const section_use *use = flk_section_find(p, section, NULL);

    if (p->n_uses >= MOST_SECTIONS)
        return flk_mistake(p->mistakes, place, "too many sections");
    if (p->is_answers && section != SECTION_EXPECT && section != SECTION_MISPRINT)
        return flk_mistake(p->mistakes, place,
                           "expected [expect] or [misprint] in this file, not [%s]", info->name);
    if (name.length && !info->repeats)
        return flk_mistake(p->mistakes, place, "[%s] takes no name: remove '%t'", info->name, name);
    if (use && !info->repeats)
        return flk_mistake(p->mistakes, place, "[%s] is given twice; first at line %ld", info->name,
                           use->place.line);
    if (name.length && flk_section_find(p, section, &name))
        return flk_mistake(p->mistakes, place, "[%s %t] is given twice", info->name, name);
    return 1;
}

/* [section], [section NAME] */
static section_use *read_section(parser *p, text line, text_place place)
{
    text word = flk_text_from(line, 1), name;
    section_code section;

    if (line.start[line.length - 1] != ']') {
        flk_mistake(p->mistakes, place, "expected ']' at the end of the section's name");
        return NULL;
    }
    word.length--;
    word = flk_text_trim(word);
    flk_section_split(&word, &name);
    section = flk_section_meant(p, word);
    if (section == SECTION_COUNT ? !flk_section_unknown(p, place, word)
                                 : !check_section(p, place, section, name))
        return NULL;
    return flk_section_open(p, section, name, place, line.start);
}

text flk_line_without_comment(text line)
{
    size_t i;
    int quoted = 0;

    for (i = 0; i < line.length; i++) {
        text before = line;
        char c = line.start[i];

        before.length = i;

        if (c == '"')
            quoted = !quoted;
        if ((c == '#' || c == ';') && !quoted && (i == 0 || flk_text_blank_before(before)))
            break;
    }
    line.length = i;
    return flk_text_trim(line);
}

/* Refuse a text as a whole, and read no more of it; `code` is for %s. */
static int refuse_text(parser *p, text_place place, const char *why, const char *code)
{
    p->not_text = 1;
    return flk_mistake(&p->d->mistakes, place, why, code);
}

/* 1 if a line is text; otherwise 0 and a mistake. */
static int is_text(parser *p, text line, text_place place)
{
    static const char hex[] = "0123456789abcdef";
    char code[3] = "00";
    size_t i;

    if (line.length > LINE_MAX_LENGTH)
        return refuse_text(p, place, "line longer than 65536 characters: not a deck", "");
    if (place.line > MOST_LINES)
        return refuse_text(p, place, "more than 4,000,000 lines: not a deck", "");
    for (i = 0; i < line.length; i++) {
        unsigned char c = (unsigned char)line.start[i];

        if ((c >= ' ' && c != 0x7f) || c == '\t' || c == '\r')
            continue;
        if (!c && place.line == 1 && i < 2)
            return refuse_text(p, place,
                               "UTF-16 without its mark, or no text: save the file as UTF-8", "");
        code[0] = hex[c / 16];
        code[1] = hex[c % 16];
        return refuse_text(p, place, "control character (0x%s): a deck is plain text", code);
    }
    return 1;
}

int flk_line_take(parser *p, text *rest, int line_end, text_place place, text cut(text line),
                  text *line)
{
    if (p->not_text || !flk_text_split(rest, line_end, line) || !is_text(p, *line, place))
        return 0;
    *line = cut(*line);
    p->n_characters += line->length;
    return p->n_characters <= MOST_CHARACTERS ||
           refuse_text(p, place, "more than 8,000,000 characters: not a deck", "");
}

/* The next line without its comment; 0 at the end of the deck, or if the line is not text. */
static int next_deck_line(parser *p, text *rest, text *line)
{
    if ((p->last_line > 0 && !rest->length) || !rest->start)
        return 0; /* nothing after the last line end */
    p->last_line++;
    return flk_line_take(p, rest, p->line_end, flk_reader_end(p), flk_line_without_comment, line);
}

/* A line that ends in a comma continues in the next, unless that is an assignment or a section.  In the
** deck's copy, the comment and the line end between them become blanks. */
static void join_lines(parser *p, text *rest, text *line)
{
    while (line->length && line->start[line->length - 1] == ',' && rest->start) {
        text ahead = *rest, next;
        char *gap;

        if (!flk_text_split(&ahead, p->line_end, &next))
            return;
        next = flk_line_without_comment(next);
        if (next.length && (next.start[0] == '[' || memchr(next.start, '=', next.length)))
            return;
        if (!next_deck_line(p, rest, &next))
            return;
        if (!next.length)
            continue;
        gap = p->copy + (line->start + line->length - p->copy);
        memset(gap, ' ', (size_t)(next.start - gap));
        line->length = (size_t)(next.start - line->start) + next.length;
    }
}

/* 1 if a word is a key of a section, or may be a name in it, before a number. */
static int is_key(const section_use *use, text word, text value)
{
    return flk_find_key(use->section, word) != KEY_COUNT ||
           (TAKES_NAMES(use->section) && strchr("+-.0123456789", value.start[0]) != NULL);
}

/* Refuse a line without an =, and show what it probably was meant to be: key value, key: value, or
** section. */
static void refuse_line(parser *p, section_use *use, text line, text_place place)
{
    char meant[MESSAGE_SIZE] = "";
    text word = line, rest;

    flk_section_split(&word, &rest);
    if (rest.length && rest.start[0] == ':')
        rest = flk_text_trim(flk_text_from(rest, 1));
    if (use && word.length && rest.length && is_key(use, word, rest)) {
        use->is_mistaken = 1; /* the value is there */
        flk_message(meant, sizeof meant, "%t = %t", word, rest);
    } else if (flk_section_meant(p, word) != SECTION_COUNT) {
        flk_message(meant, sizeof meant, "[%t%s%t]", word, rest.length ? " " : "", rest);
    }
    flk_mistake(p->mistakes, place, "expected 'key = value' or '[section]', not '%t'%h", line,
                *meant ? meant : NULL);
}

/* 1 if a section has values with names, which are the last that were read. */
static int has_values(const parser *p, const section_use *use)
{
    return p->n_named > 0 && p->named[p->n_named - 1].use == (size_t)(use - p->uses);
}

/* 1 if answers go on in a new [expect] without its header: before the first, and at another `at`.
** Without headers an `at` is for the values below it, not for those above. */
static int begins_answers(const parser *p, section_use *use, text key, int has_header)
{
    if (!use || use->section == SECTION_TOP)
        return use != NULL;
    return use->section == SECTION_EXPECT && flk_text_equal(key, "at") &&
           (IS_SET(flk_setting_of(use, KEY_EXPECT_AT)) || (!has_header && has_values(p, use)));
}

void flk_lines_read(parser *p)
{
    text rest = p->text;
    section_use *use;
    text line;
    text_place place;
    int has_header = 0;

    place = flk_reader_end(p);
    place.line = 1;
    rest.start = p->copy;
    rest = flk_text_without_mark(rest);
    use = flk_section_open(p, SECTION_TOP, flk_text_of(""), place, rest.start);
    p->line_end = flk_text_line_end(rest);
    while (!p->out_of_memory && next_deck_line(p, &rest, &line)) {
        text key, value;

        place.line = p->last_line;
        if (!line.length)
            continue;
        if (line.start[0] == '[') {
            use = read_section(p, line, place);
            has_header = 1;
            continue;
        }
        join_lines(p, &rest, &line);
        value = line;
        flk_text_split(&value, '=', &key);
        if (!value.start) {
            refuse_line(p, use, line, place);
            continue;
        }
        if (p->is_answers && begins_answers(p, use, flk_text_trim(key), has_header)) {
            use = flk_section_open(p, SECTION_EXPECT, flk_text_of(""), place, line.start);
            has_header = 0;
        }
        if (use) /* keys of an unknown section are not checked */
            flk_setting_read(p, place, use, flk_text_trim(key), flk_text_trim(value));
    }
}
