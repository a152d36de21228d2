/* SPDX-License-Identifier: GPL-3.0-or-later
**
** check_page.c REPORT [DECK [CSV]] - checks a report: one line for each thing that is wrong, nothing if all is well.
**
** It is XML, needs no other file, its headings are in order, its figures are numbered and have alternative
** texts, its ids are unique; it holds the deck as it is, and the rows as in the csv file.
*/
#include "wrong.h"
#include "xml.h"

#define REPLACEMENT "\357\277\275" /* U+FFFD */

static void *need(size_t n)
{
    void *p = calloc(n, 1);

    if (!p)
        abort();
    return p;
}

static int begins(const char *words, const char *with)
{
    return strncmp(words, with, strlen(with)) == 0;
}

/* -------------------------------------------------------------------------------------------- structure */

static void check_headings(const xml_node *root)
{
    const xml_node *x;
    int level = 0, n_first = 0, n_second = 0;
    char words[300];

    for (x = root; x; x = xml_next(x, root)) {
        int own = x->name[0] == 'h' && x->name[1] >= '1' && x->name[1] <= '6' && !x->name[2]
                      ? x->name[1] - '0'
                      : 0;

        if (own > level + 1)
            wrong("a heading h%d under h%d", own, level);
        n_first += own == 1;
        if (own == 2 && atoi(xml_words(x, words, sizeof words)) != ++n_second)
            wrong("section %d has the heading %s", n_second, words);
        level = own ? own : level;
    }
    if (n_first != 1)
        wrong("%d headings h1", n_first);
}

static int count_id(const xml_node *root, const char *id)
{
    const xml_node *x;
    int n = 0;

    for (x = root; x; x = xml_next(x, root))
        n += xml_has(x, "id", id);
    return n;
}

static void check_links(const xml_node *root)
{
    static const char *const names[] = {"src", "href"};
    const xml_node *x;
    int i;

    for (x = root; x; x = xml_next(x, root)) {
        const char *id = xml_get(x, "id"),
                   *saved = xml_is(x, "button") ? xml_get(x, "data-from") : NULL;

        if (id && count_id(root, id) != 1)
            wrong("the id %s comes %d times", id, count_id(root, id));
        if (saved && !count_id(root, saved))
            wrong("a button that saves nothing: %s", saved);
        for (i = 0; i < 2; i++) {
            const char *to = xml_get(x, names[i]);

            if (to && to[0] != '#' && !begins(to, "data:image/svg+xml;base64,"))
                wrong("a reference to another file: %.80s", to);
            if (to && to[0] == '#' && to[1] && !count_id(root, to + 1))
                wrong("a link to nothing: %s", to);
        }
    }
}

/* Cells of a row, as wide as they are. */
static int width_of(const xml_node *row)
{
    const xml_node *cell;
    int n = 0;

    for (cell = row->first; cell; cell = cell->next)
        if (cell->name[0])
            n += xml_get(cell, "colspan") ? atoi(xml_get(cell, "colspan")) : 1;
    return n;
}

static void check_tables(const xml_node *root)
{
    const xml_node *x, *row;
    char words[300];

    for (x = xml_next_named(root, root, "th"); x; x = xml_next_named(x, root, "th"))
        if (!xml_has(x, "scope", "col") && !xml_has(x, "scope", "row"))
            wrong("a heading of a table without scope: %s", xml_words(x, words, sizeof words));
    for (x = xml_next_named(root, root, "table"); x; x = xml_next_named(x, root, "table")) {
        int width = 0;

        for (row = xml_next_named(x, x, "tr"); row; row = xml_next_named(row, x, "tr")) {
            if (width && width_of(row) != width)
                wrong("rows of a table with %d and %d cells", width, width_of(row));
            width = width_of(row);
        }
    }
}

/* --------------------------------------------------------------------------------------------- figures */

/* Read base64 (RFC 4648); how many bytes, or -1. */
static long decode(const char *words, char *to)
{
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    size_t n = strlen(words), i, found = 0;
    unsigned bits = 0;

    while (n && words[n - 1] == '=')
        n--;
    if (strlen(words) % 4 || strlen(words) - n > 2)
        return -1;
    for (i = 0; i < n; i++) {
        const char *letter = strchr(letters, words[i]);

        if (!letter)
            return -1;
        bits = (bits << 6 | (unsigned)(letter - letters)) & 0xffffff;
        if (i % 4)
            to[found++] = (char)(bits >> (6 - 2 * (i % 4)));
    }
    return (long)found;
}

static void check_picture(const xml_node *picture, int n)
{
    const char *source = xml_get(picture, "src"), *alternative = xml_get(picture, "alt"),
               *data = source ? strchr(source, ',') : NULL;
    char *svg;
    long size;
    xml_document d;

    if (!alternative || strlen(alternative) < 10)
        wrong("figure %d has no alternative text", n);
    if (!data) {
        wrong("figure %d has no picture", n);
        return;
    }
    svg = (char *)need(strlen(data) + 1);
    size = decode(data + 1, svg);
    if (size < 0) {
        wrong("figure %d is not in base64", n);
    } else {
        if (!xml_parse(&d, svg, (size_t)size))
            wrong("figure %d: %s", n, d.wrong);
        else if (!xml_is(d.root, "svg") || xml_next_named(d.root, d.root, "script"))
            wrong("figure %d is no picture, or has a script", n);
        xml_free(&d);
    }
    free(svg);
}

static void check_figures(const xml_node *root)
{
    const xml_node *figure, *x;
    int n = 0;
    char words[300], caption[40];

    for (figure = xml_next_named(root, root, "figure"); figure;
         figure = xml_next_named(figure, root, "figure")) {
        const xml_node *picture = NULL;

        strcpy(words, "");
        for (x = figure->first; x; x = x->next) {
            if (xml_is(x, "img"))
                picture = x;
            if (xml_is(x, "figcaption"))
                xml_words(x, words, sizeof words);
        }
        if (!picture)
            continue;
        sprintf(caption, "Figure %d. ", ++n);
        if (!begins(words, caption))
            wrong("figure %d has the caption %s", n, words);
        check_picture(picture, n);
    }
}

/* ---------------------------------------------------------------------------------- what the page has of files */

/* 1 if a page has it: no control character, not U+FFFE or U+FFFF. */
static int is_printable(unsigned long code)
{
    return xml_is_character(code) && code != '\r' && !(code >= 0x7f && code < 0xa0);
}

/* What a page shows of a file. */
static char *read_printable(const char *name)
{
    size_t n = 0;
    char *bytes = xml_read_file(name, &n), *shown = (char *)need(3 * n + 1), *to = shown;
    const char *c;

    if (!bytes)
        wrong("%s cannot be read", name);
    for (c = bytes; c && c < bytes + n;) {
        unsigned long code;
        int length = xml_letter(c, &code), is_shown = length && is_printable(code);

        if (c[0] == '\r' && c[1] == '\n') {
            c++;
            continue;
        }
        memcpy(to, is_shown ? c : REPLACEMENT, is_shown ? (size_t)length : 3);
        to += is_shown ? length : 3;
        c += length ? length : 1;
    }
    free(bytes);
    return shown;
}

/* The one text that is marked so has what the file shows; the deck may end in lines that are empty. */
static void check_file(const xml_node *root, const char *attribute, const char *value,
                       const char *name, int trims)
{
    char *wanted = read_printable(name), *shown = (char *)need(4000000);
    const xml_node *x;
    int n = 0;

    for (x = xml_next_named(root, root, "pre"); x; x = xml_next_named(x, root, "pre"))
        if (xml_has(x, attribute, value)) {
            xml_words(x, shown, 4000000);
            n++;
        }
    while (trims && *wanted && wanted[strlen(wanted) - 1] == '\n')
        wanted[strlen(wanted) - 1] = '\0';
    while (trims && *shown && shown[strlen(shown) - 1] == '\n')
        shown[strlen(shown) - 1] = '\0';
    if (n != 1 || strcmp(shown, wanted) != 0)
        wrong("%s is not there as it is", name);
    free(wanted);
    free(shown);
}

static void check_size(const char *bytes, size_t n)
{
    if (!begins(bytes, "<!DOCTYPE html>\n"))
        wrong("no document type");
    if (n > 1000000)
        wrong("%lu bytes", (unsigned long)n);
}

int main(int argc, char **argv)
{
    xml_document d;
    size_t n = 0;
    char *bytes;

    report = argc > 1 ? argv[1] : "";
    bytes = xml_read_file(report, &n);
    check_size(bytes ? bytes : "", n);
    if (!xml_parse(&d, bytes ? bytes : "", n)) {
        wrong("%s", d.wrong);
    } else {
        check_headings(d.root);
        check_links(d.root);
        check_tables(d.root);
        check_figures(d.root);
        if (argc > 2)
            check_file(d.root, "class", "deck", argv[2], 1);
        if (argc > 3)
            check_file(d.root, "id", "csv-rows", argv[3], 0);
    }
    xml_free(&d);
    free(bytes);
    return n_wrong > 0;
}
