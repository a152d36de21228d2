/* SPDX-License-Identifier: GPL-3.0-or-later
**
** xml.h - reads XML 1.0 for tests into a tree of elements and texts, and refuses what is not well-formed
** (https://www.w3.org/TR/xml/).
**
** Entities are the five of XML and numbers; the document type is that of HTML, and there is no declaration of XML and no
** processing instruction: no picture and no page has more.  A name may have any letter beyond ASCII.
*/
#ifndef TESTS_XML_H
#define TESTS_XML_H

#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define XML_ATTRIBUTES 16

typedef struct xml_node xml_node;
struct xml_node {
    const char *name; /* of an element; "" of a text */
    const char *text; /* of a text; "" of an element */
    const char *attributes[XML_ATTRIBUTES][2];
    int n;
    xml_node *parent, *first, *last, *next;
    xml_node *made_before;
};

typedef struct {
    char *data, *end; /* the bytes, and a 0 */
    char *at;         /* what is read next */
    char *texts;      /* names and texts, one after the other */
    char *free_text;
    xml_node *last_made;
    xml_node *root;
    char wrong[200]; /* why it is not well-formed; "" if it is */
    jmp_buf stop;
} xml_document;

static inline void xml_stop(xml_document *d, const char *why)
{
    const char *c;
    int line = 1;

    for (c = d->data; c < d->at; c++)
        line += *c == '\n';
    snprintf(d->wrong, sizeof d->wrong, "line %d: %s: %.40s", line, why, d->at);
    longjmp(d->stop, 1);
}

static inline int xml_is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/* 1 if these words come next, which are read. */
static inline int xml_take(xml_document *d, const char *words)
{
    if (strncmp(d->at, words, strlen(words)) != 0)
        return 0;
    d->at += strlen(words);
    return 1;
}

static inline void xml_expect(xml_document *d, const char *words, const char *why)
{
    if (!xml_take(d, words))
        xml_stop(d, why);
}

/* 1 if there were any. */
static inline int xml_take_spaces(xml_document *d)
{
    const char *before = d->at;

    while (xml_is_space(*d->at))
        d->at++;
    return d->at > before;
}

/* Go on behind these words; the length of what stood before them. */
static inline size_t xml_go_past(xml_document *d, const char *words)
{
    const char *before = d->at, *found = strstr(d->at, words);

    if (!found)
        xml_stop(d, "it does not end");
    d->at += found - before + (long)strlen(words);
    return (size_t)(found - before);
}

static inline int xml_is_character(unsigned long code)
{
    return (code >= 0x20 || code == '\t' || code == '\n' || code == '\r') &&
           !(code >= 0xd800 && code < 0xe000) && code != 0xfffe && code != 0xffff &&
           code <= 0x10ffff;
}

/* The letter in UTF-8 there.  Returned: how many bytes it has; 0 if it is none (RFC 3629). */
static inline int xml_letter(const char *at, unsigned long *code)
{
    static const unsigned long least[] = {0, 0, 0x80, 0x800, 0x10000}; /* of so many bytes */
    unsigned char first = (unsigned char)*at;
    int n = 1, i;

    if (first >= 0x80)
        n = first < 0xc0 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf8 ? 4 : 0;
    *code = n < 2 ? first : first & (0x7fu >> n);
    for (i = 1; i < n; i++) {
        if ((at[i] & 0xc0) != 0x80)
            return 0;
        *code = *code << 6 | (at[i] & 0x3f);
    }
    return *code < least[n] || *code > 0x10ffff || (*code >= 0xd800 && *code < 0xe000) ? 0 : n;
}

static inline void xml_check_characters(xml_document *d)
{
    unsigned long code;

    for (; d->at < d->end; d->at += xml_letter(d->at, &code)) {
        if (!xml_letter(d->at, &code))
            xml_stop(d, "not UTF-8");
        if (!xml_is_character(code))
            xml_stop(d, "a character that XML does not have");
    }
    d->at = d->data;
}

static inline void xml_put_code(xml_document *d, unsigned long code)
{
    int n = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4, i;

    for (i = n - 1; i > 0; i--, code >>= 6)
        d->free_text[i] = (char)(0x80 | (code & 0x3f));
    d->free_text[0] = (char)(n == 1 ? code : (0xf00u >> n & 0xff) | code);
    d->free_text += n;
}

static inline void xml_read_entity(xml_document *d)
{
    static const char *const known[] = {"&lt;", "<",      "&gt;", ">",      "&amp;",
                                        "&",    "&quot;", "\"",   "&apos;", "'"};
    char *before = d->at, *end = d->at;
    unsigned long code;
    size_t i;

    for (i = 0; i < sizeof known / sizeof known[0]; i += 2)
        if (xml_take(d, known[i])) {
            *d->free_text++ = *known[i + 1];
            return;
        }
    if (!xml_take(d, "&#"))
        xml_stop(d, "an & that begins no entity");
    if (xml_take(d, "x"))
        code = strspn(d->at, "0123456789abcdefABCDEF") ? strtoul(d->at, &end, 16) : 0;
    else
        code = strspn(d->at, "0123456789") ? strtoul(d->at, &end, 10) : 0;
    if (!xml_is_character(code) || *end != ';') {
        d->at = before;
        xml_stop(d, "no character");
    }
    d->at = end + 1;
    xml_put_code(d, code);
}

static inline const char *xml_read_name(xml_document *d)
{
    static const char others[] = "-.0123456789";
    static const char letters[] = ":_ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    const char *name = d->free_text;

    if (*d->at == '\0' || strchr(others, *d->at))
        xml_stop(d, "a name is missing");
    while (*d->at &&
           (strchr(letters, *d->at) || strchr(others, *d->at) || (unsigned char)*d->at >= 0x80))
        *d->free_text++ = *d->at++;
    if (d->free_text == name)
        xml_stop(d, "a name is missing");
    *d->free_text++ = '\0';
    return name;
}

/* A text up to the next tag, or an attribute up to its quotation mark. */
static inline const char *xml_read_text(xml_document *d, char end)
{
    const char *text = d->free_text;
    int is_attribute = end != '<';

    while (*d->at != end) {
        if (*d->at == '\0' || (is_attribute && *d->at == '<'))
            xml_stop(d, "this does not end");
        if (!is_attribute && xml_take(d, "]]>"))
            xml_stop(d, "]]> stands before this");
        if (*d->at == '&') {
            xml_read_entity(d);
        } else {
            char c = *d->at++;

            if (c == '\r')
                xml_take(d, "\n");
            *d->free_text++ = (char)(c == '\r' ? '\n' : c);
            if (is_attribute && xml_is_space(c))
                d->free_text[-1] = ' ';
        }
    }
    *d->free_text++ = '\0';
    return text;
}

static inline xml_node *xml_add(xml_document *d, xml_node *parent, const char *name,
                                const char *text)
{
    xml_node *x = (xml_node *)calloc(1, sizeof *x);

    if (!x)
        abort();
    x->name = name;
    x->text = text;
    x->parent = parent;
    x->made_before = d->last_made;
    d->last_made = x;
    if (parent) {
        *(parent->last ? &parent->last->next : &parent->first) = x;
        parent->last = x;
    }
    return x;
}

/* The value of an attribute; NULL if there is none. */
static inline const char *xml_get(const xml_node *x, const char *name)
{
    int i;

    for (i = 0; i < x->n; i++)
        if (strcmp(x->attributes[i][0], name) == 0)
            return x->attributes[i][1];
    return NULL;
}

static inline void xml_read_attributes(xml_document *d, xml_node *x)
{
    while (xml_take_spaces(d) && *d->at != '>' && *d->at != '/') {
        const char *name = xml_read_name(d);
        char quote;

        if (xml_get(x, name) || x->n == XML_ATTRIBUTES)
            xml_stop(d, "an attribute comes twice, or there are too many");
        xml_take_spaces(d);
        xml_expect(d, "=", "= is missing");
        xml_take_spaces(d);
        quote = *d->at;
        if (quote != '"' && quote != '\'')
            xml_stop(d, "no quotation mark");
        d->at++;
        x->attributes[x->n][0] = name;
        x->attributes[x->n++][1] = xml_read_text(d, quote);
        d->at++;
    }
}

/* Comments and, within an element, character data. */
static inline int xml_take_marked(xml_document *d, xml_node *parent)
{
    if (xml_take(d, "<!--")) {
        xml_go_past(d, "--");
        xml_expect(d, ">", "-- in a comment");
        return 1;
    }
    if (parent && xml_take(d, "<![CDATA[")) {
        const char *from = d->at;
        size_t n = xml_go_past(d, "]]>");

        xml_add(d, parent, "", d->free_text);
        memcpy(d->free_text, from, n);
        d->free_text += n;
        *d->free_text++ = '\0';
        return 1;
    }
    return 0;
}

static inline void xml_read_element(xml_document *d)
{
    xml_node *x = NULL;

    do {
        if (x && *d->at != '<') {
            const char *text = xml_read_text(d, '<');

            xml_add(d, x, "", text);
        } else if (xml_take_marked(d, x)) {
            continue;
        } else if (x && xml_take(d, "</")) {
            if (strcmp(xml_read_name(d), x->name) != 0)
                xml_stop(d, "another element ends than began");
            xml_take_spaces(d);
            xml_expect(d, ">", "> is missing");
            x = x->parent;
        } else {
            xml_expect(d, "<", "no element");
            x = xml_add(d, x, xml_read_name(d), "");
            if (!d->root)
                d->root = x;
            xml_read_attributes(d, x);
            if (xml_take(d, "/>"))
                x = x->parent;
            else
                xml_expect(d, ">", "> is missing");
        }
    } while (x || !d->root);
}

/* Given: n bytes.  Returned: 1 if they are well-formed XML; 0 if not, `wrong` says why.  Free it in either case. */
static inline int xml_parse(xml_document *d, const char *bytes, size_t n)
{
    memset(d, 0, sizeof *d);
    d->data = (char *)malloc(n + 1);
    d->texts = (char *)malloc(
        n + 1); /* none is longer than what stands for it, with the mark at its end */
    if (!d->data || !d->texts)
        abort();
    memcpy(d->data, bytes, n);
    d->data[n] = '\0';
    d->at = d->data;
    d->end = d->data + n;
    d->free_text = d->texts;
    if (setjmp(d->stop))
        return 0;
    xml_check_characters(d);
    xml_take(d, "<!DOCTYPE html>");
    while (xml_take_spaces(d) || xml_take_marked(d, NULL))
        ;
    xml_read_element(d);
    while (xml_take_spaces(d) || xml_take_marked(d, NULL))
        ;
    if (d->at < d->end)
        xml_stop(d, "this stands behind the last element");
    return 1;
}

/* Returned: the bytes of a file and a 0, to be freed; NULL if it cannot be read. */
static inline char *xml_read_file(const char *name, size_t *n)
{
    FILE *file = fopen(name, "rb");
    char *bytes = NULL;
    long size;

    if (!file)
        return NULL;
    if (fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) >= 0 &&
        fseek(file, 0, SEEK_SET) == 0 && (bytes = (char *)calloc((size_t)size + 1, 1)) != NULL)
        *n = fread(bytes, 1, (size_t)size, file);
    fclose(file);
    return bytes;
}

/* As xml_parse, of a file. */
static inline int xml_read(xml_document *d, const char *name)
{
    size_t n = 0;
    char *bytes = xml_read_file(name, &n);
    int is_good = xml_parse(d, bytes ? bytes : "", n);

    if (!bytes)
        sprintf(d->wrong, "it cannot be read");
    free(bytes);
    return is_good;
}

static inline void xml_free(xml_document *d)
{
    while (d->last_made) {
        xml_node *x = d->last_made;

        d->last_made = x->made_before;
        free(x);
    }
    free(d->data);
    free(d->texts);
}

/* Returned: 1 if x is an element of this name. */
static inline int xml_is(const xml_node *x, const char *name)
{
    return x && strcmp(x->name, name) == 0;
}

/* The node after x in the order of the document, of the tree below `top`; NULL at its end. */
static inline xml_node *xml_next(const xml_node *x, const xml_node *top)
{
    if (x->first)
        return x->first;
    while (x != top && !x->next)
        x = x->parent;
    return x == top ? NULL : x->next;
}

/* As xml_next, the next element of this name. */
static inline xml_node *xml_next_named(const xml_node *x, const xml_node *top, const char *name)
{
    xml_node *found = xml_next(x, top);

    while (found && !xml_is(found, name))
        found = xml_next(found, top);
    return found;
}

/* Returned: 1 if an attribute has this value. */
static inline int xml_has(const xml_node *x, const char *attribute, const char *value)
{
    const char *own = xml_get(x, attribute);

    return own && strcmp(own, value) == 0;
}

/* All texts of a node one after the other, as many as `size` bytes hold. */
static inline const char *xml_words(const xml_node *x, char *words, size_t size)
{
    const xml_node *text;
    size_t n = 0;

    words[0] = '\0';
    for (text = x; text; text = xml_next(text, x))
        n += (size_t)snprintf(words + (n < size ? n : size - 1), n < size ? size - n : 1, "%s",
                              text->text);
    return words;
}

#endif
