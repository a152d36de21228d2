/* SPDX-License-Identifier: GPL-3.0-or-later
**
** notation.c - names and units as they are printed in a book.
*/
#include <string.h>

#include "base/text.h"
#include "notation.h"

/* Symbols with their plain names; those without a number have no subscript. */
static const struct {
    const char *plain, *symbol;
} symbols[] = {{"theta", "\316\270"},
               {"omega", "\317\211"},
               {"alpha", "\316\261"},
               {"gamma", "\316\263"},
               {"phi", "\317\206"},
               {"mu", "\316\274"},
               {"Fi", "Fi"},
               {"Ci", "Ci"},
               {"F", "F"},
               {"M", "M"},
               {"T", "T"},
               {"N", "N"},
               {"G", "G"},
               {"I", "I"},
               {"h", "h"}};

/* Subscripts that UTF-8 has. */
static const struct {
    char plain;
    const char *raised, *lowered;
} scripts[] = {{'0', "\342\201\260", "\342\202\200"}, {'1', "\302\271", "\342\202\201"},
               {'2', "\302\262", "\342\202\202"},     {'3', "\302\263", "\342\202\203"},
               {'4', "\342\201\264", "\342\202\204"}, {'s', "\313\242", "\342\202\233"},
               {'x', "\313\243", "\342\202\223"},     {'y', "\312\270", "\341\265\247"}};

static const char *script_of(char c, int is_raised)
{
    size_t i;

    for (i = 0; i < sizeof scripts / sizeof scripts[0]; i++)
        if (scripts[i].plain == c)
            return is_raised ? scripts[i].raised : scripts[i].lowered;
    return NULL;
}

static int is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* The length of a subscript: s, 12, 12x, sx, s0. */
static size_t length_of_sub(const char *c)
{
    size_t n = 0;

    if (*c == 's')
        n++;
    while (is_digit(c[n]))
        n++;
    if (n && (c[n] == 'x' || c[n] == 'y'))
        n++;
    return n;
}

int notation_mark(const char *words)
{
    return strncmp(words, NOTATION_SUB, NOTATION_MARK) == 0     ? -1
           : strncmp(words, NOTATION_SUPER, NOTATION_MARK) == 0 ? 1
                                                                : 0;
}

int notation_split(const char *name, notation *n)
{
    size_t i, plain, sub;
    const char *end;

    for (i = 0; i < sizeof symbols / sizeof symbols[0]; i++) {
        plain = strlen(symbols[i].plain);
        if (strncmp(name, symbols[i].plain, plain) != 0)
            continue;
        sub = length_of_sub(name + plain);
        end = name + plain + sub;
        if (sub >= sizeof n->sub || (*end && *end != '_' && !(*end == '.' && *name == 'G')))
            continue;
        if (sub == 0 && *end != '_' && strcmp(symbols[i].plain, symbols[i].symbol) == 0)
            continue; /* N alone */
        strcpy(n->symbol, symbols[i].symbol);
        memcpy(n->sub, name + plain, sub);
        n->sub[sub] = '\0';
        n->rest = *end == '_' ? end + 1 : end;
        return 1;
    }
    flk_text_join(n->symbol, sizeof n->symbol, name, (char *)NULL);
    n->sub[0] = '\0';
    n->rest = "";
    return 0;
}

/* 1 for a hyphen that stands for a minus: before a number or a name, not within one. */
static int is_minus(const char *all, const char *c)
{
    return *c == '-' && (c == all || strchr(" (,", c[-1])) && c[1] && c[1] != ' ';
}

int notation_next(const char *all, notation_part *x)
{
    x->words += x->n;
    if (notation_mark(x->words)) {
        x->level = notation_mark(x->words);
        x->words += NOTATION_MARK;
    } else if (*x->words == ' ') {
        x->level = 0;
    }
    x->is_minus = is_minus(all, x->words);
    for (x->n = (size_t)x->is_minus; !x->is_minus && x->words[x->n]; x->n++)
        if (notation_mark(x->words + x->n) || (x->level && x->words[x->n] == ' ') ||
            is_minus(all, x->words + x->n))
            break;
    return x->n > 0 || notation_mark(x->words) != 0;
}

char *notation_below(const notation *n, char out[NOTATION_SIZE])
{
    return flk_text_join(out, NOTATION_SIZE, n->sub, *n->sub && *n->rest ? " " : "", n->rest,
                         (char *)NULL);
}

static void put_scripts(const char *plain, int is_raised, char out[NOTATION_SIZE])
{
    for (; *plain; plain++) {
        const char *script = script_of(*plain, is_raised);
        char own[2] = {0, 0};

        own[0] = *plain;
        flk_text_join(out + strlen(out), NOTATION_SIZE - strlen(out), script ? script : own,
                      (char *)NULL);
    }
}

/* The words of a fact's name, but for a subscript: time ratio, m_a.  The names of a deck, S.force, stay. */
static void put_words(const char *name, char out[NOTATION_SIZE])
{
    char *c;

    flk_text_join(out, NOTATION_SIZE, name, (char *)NULL);
    for (c = out; *c && !strchr(name, '.'); c++)
        if (*c == '_' && c[1] && c[2])
            *c = ' ';
}

char *notation_name(const char *name, char out[NOTATION_SIZE])
{
    const char *open = strchr(name, '(');
    char inner[NOTATION_SIZE], plain[NOTATION_SIZE];
    notation n;

    if (open && strlen(name) < sizeof plain && name[strlen(name) - 1] == ')') {
        strcpy(plain, name);
        plain[strlen(name) - 1] = '\0';
        notation_name(plain + (open + 1 - name), inner);
        plain[open - name] = '\0';
        return flk_text_join(out, NOTATION_SIZE, plain, "(", inner, ")", (char *)NULL);
    }
    if (!notation_split(name, &n)) {
        put_words(name, out);
        return out;
    }
    flk_text_join(out, NOTATION_SIZE, n.symbol, (char *)NULL);
    put_scripts(n.sub, 0, out);
    flk_text_join(out + strlen(out), NOTATION_SIZE - strlen(out),
                  *n.rest && *n.rest != '.' ? " " : "", n.rest, (char *)NULL);
    return out;
}

/* A digit behind a letter, or behind ^, is its power. */
char *notation_unit(const char *unit, char out[NOTATION_SIZE])
{
    char own[2] = {0, 0};
    const char *c;

    out[0] = '\0';
    for (c = unit; *c; c++) {
        own[0] = *c;
        if (strncmp(c, "deg", 3) == 0) {
            flk_text_join(out + strlen(out), NOTATION_SIZE - strlen(out), "\302\260", (char *)NULL);
            c += 2;
        } else if (c > unit && is_digit(*c)) {
            put_scripts(own, 1, out);
        } else if (*c != '^') {
            flk_text_join(out + strlen(out), NOTATION_SIZE - strlen(out),
                          *c == '.' ? "\302\267" : own, (char *)NULL);
        }
    }
    return out;
}
