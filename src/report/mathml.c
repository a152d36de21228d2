/* SPDX-License-Identifier: GPL-3.0-or-later
**
** mathml.c - equations in MathML.
*/
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "system/format.h"
#include "base/text.h"
#include "system/xml.h"
#include "mathml.h"

#define FUNCTION(name)                                                                           \
    "<mspace width=\"0.17em\"/><mi>" name "</mi><mo lspace=\"0\" rspace=\"0\">\342\201\241</mo>" \
    "<mspace width=\"0.17em\"/>"
#define INFIX(sign) "<mo form=\"infix\">" sign "</mo>"
#define LEFT "<mo stretchy=\"false\">(</mo>"
#define RIGHT "<mo stretchy=\"false\">)</mo>"
#define MINUS "\342\210\222"
#define DEGREE "\302\260"
/* Without width: they keep a numerator and a denominator clear of their rule, and of the lines above and
** below. */
#define ABOVE_RULE "<mspace height=\"0.95em\" depth=\"0.32em\"/>"
#define BELOW_RULE "<mspace height=\"0.88em\" depth=\"0.32em\"/>"
#define LONG_EQUATION 90 /* bytes: the result has a line of its own, fractions have none */
#define NAMESPACE "http://www.w3.org/1998/Math/MathML"

void math_open(page *p, const char *name_of_class)
{
    page_print(p, "<math xmlns=\"" NAMESPACE "\" display=\"block\" class=\"%m\"><mrow>",
               name_of_class);
}

void math_close(page *p)
{
    page_print(p, "</mrow></math>\n");
}

/* A line of an equation, which may go on below between its pieces, each a <math>. */
static void open_line(page *p, const char *name_of_class)
{
    page_print(p, "<div class=\"%m\"><math xmlns=\"" NAMESPACE "\"><mrow>", name_of_class);
}

static void begin_piece(page *p)
{
    page_print(p, "</mrow></math><wbr/><math xmlns=\"" NAMESPACE "\"><mrow>");
}

static void close_line(page *p)
{
    page_print(p, "</mrow></math></div>\n");
}

void math_block(page *p, const char *name_of_class)
{
    p->n_equations++;
    page_print(p, "<div class=\"%m\" id=\"equation-%d\">\n<span class=\"its-number\">(%d)</span>\n",
               name_of_class, p->n_equations, p->n_equations);
}

/* ------------------------------------------------------------------------------ symbols and numbers */

/* Symbols that are no Latin letters, or no lengths, by the beginning of their names. */
static const struct {
    const char *name, *letter;
    math_unit unit;
} letters[] = {{"OM", "OM", MATH_LENGTH},
               {"BM", "BM", MATH_LENGTH},
               {"BQ", "BQ", MATH_LENGTH},
               {"QN", "QN", MATH_LENGTH},
               {"ON", "ON", MATH_LENGTH},
               {"DE", "\316\224E", MATH_ENERGY},
               {"E", "E", MATH_ENERGY},
               {"Cs", "C", MATH_ONE},
               {"Ce", "C", MATH_ONE},
               {"theta", "\316\270", MATH_ANGLE},
               {"beta", "\316\262", MATH_ANGLE},
               {"gamma", "\316\263", MATH_ANGLE},
               {"psi", "\317\210", MATH_ANGLE},
               {"pi", "\317\200", MATH_ONE},
               {"tau", "\317\204", MATH_ONE},
               {"sigma1", "\317\203\342\200\262", MATH_ONE},
               {"sigma2", "\317\203\342\200\263", MATH_ONE},
               {"sigma", "\317\203", MATH_ONE},
               {"Sigma", "\316\243", MATH_ONE},
               {"t", "t", MATH_TIME},
               {"Dtheta", "\316\224\316\270", MATH_ANGLE},
               {"Domega", "\316\224\317\211", MATH_ANGULAR_SPEED},
               {"Dv", "\316\224v", MATH_SPEED},
               {"Dq", "\316\224q", MATH_LENGTH},
               {"aq", "a", MATH_ACCELERATION},
               {"delta", "\316\264", MATH_ANGLE},
               {"omega", "\317\211", MATH_ANGULAR_SPEED},
               {"alpha", "\316\261", MATH_ANGULAR_ACCELERATION},
               {"rho", "\317\201", MATH_LENGTH},
               {"mu", "\316\274", MATH_ONE},
               {"m", "m", MATH_MASS},
               {"I", "I", MATH_INERTIA},
               {"gx", "g", MATH_ACCELERATION},
               {"gy", "g", MATH_ACCELERATION},
               {"sdot", "\341\271\241", MATH_SPEED},
               {"sddot", "s\314\210", MATH_ACCELERATION},
               {"v", "v", MATH_SPEED},
               {"aB", "a", MATH_ACCELERATION},
               {"aC", "a", MATH_ACCELERATION},
               {"aD", "a", MATH_ACCELERATION},
               {"aP", "a", MATH_ACCELERATION},
               {"aQ", "a", MATH_ACCELERATION},
               {"n", "n", MATH_ONE},
               {"aG", "a", MATH_ACCELERATION},
               {"acor", "a", MATH_ACCELERATION},
               {"F", "F", MATH_FORCE},
               {"N", "N", MATH_FORCE},
               {"M", "M", MATH_TORQUE},
               {"T", "T", MATH_TORQUE},
               {"P", "P", MATH_POWER},
               {"KC", "K", MATH_LENGTH},
               {"Ks", "K", MATH_LENGTH},
               {"K", "K", MATH_ONE},
               {"L3", "L", MATH_ONE},
               {"L4", "L", MATH_ONE},
               {"Q", "Q", MATH_ONE},
               {"S2", "S", MATH_AREA},
               {"S3", "S", MATH_AREA}};

enum { LETTERS = sizeof letters / sizeof letters[0] };

/* The entry of a name; LETTERS if it has none. */
static int letter_of(const char *name)
{
    int i;

    for (i = 0; i < LETTERS && strncmp(name, letters[i].name, strlen(letters[i].name)) != 0; i++)
        ;
    return i;
}

static math_unit unit_of(const char *name)
{
    int i = letter_of(name);

    return i < LETTERS ? letters[i].unit : MATH_LENGTH;
}

void math_symbol(page *p, const char *name)
{
    int i = letter_of(name), is_latin = i == LETTERS || strlen(letters[i].letter) == 1;
    size_t length = is_latin ? 1 : strlen(letters[i].name);
    char letter[2];

    letter[0] = name[0];
    letter[1] = '\0';
    page_print(p, name[length] ? "<msub><mi>%s</mi><mtext>%s</mtext></msub>" : "<mi>%s</mi>",
               is_latin ? letter : letters[i].letter, name + length);
}

/* The digits of a number without its sign; a power of ten has its own element. */
static void put_digits(page *p, double value, int is_angle)
{
    char number[FORMAT_SIZE], *e, *end;

    if (is_angle) {
        end = format_fixed_end(fabs(value) * (180 / 3.14159265358979323846), 4, number);
        while (end[-1] == '0')
            end--;
        *(end[-1] == '.' ? end - 1 : end) = '\0';
        page_print(p, "<mn>%s" DEGREE "</mn>", number);
        return;
    }
    format_general(fabs(value), MATH_DIGITS, number);
    e = strchr(number, 'e');
    if (!e) {
        page_print(p, "<mn>%s</mn>", number);
        return;
    }
    *e++ = '\0';
    page_print(p, "<mrow><mn>%s</mn><mo>\302\267</mo><msup><mn>10</mn><mn>%s", number,
               *e == '-' ? MINUS : "");
    while (*e == '+' || *e == '-' || *e == '0')
        e++;
    page_print(p, "%s</mn></msup></mrow>", e);
}

static void put_number(page *p, double value, int is_angle)
{
    if (value < 0)
        page_print(p, "<mrow><mo>" MINUS "</mo>");
    put_digits(p, value, is_angle);
    if (value < 0)
        page_print(p, "</mrow>");
}

void math_number(page *p, double value)
{
    put_number(p, value, 0);
}

static int find(const math *m, text name)
{
    int i;

    for (i = 0; i < m->n && !flk_text_same(name, m->symbol[i].name); i++)
        ;
    return i;
}

void math_begin(math *m, page *p, const fourlink_unit *units)
{
    memset(m, 0, sizeof *m);
    m->p = p;
    math_units_take(&m->units, units);
}

double math_settled(const math *m, double value, math_unit unit)
{
    return format_settled(value, m->size[unit]);
}

double math_shown(const math *m, double value, math_unit unit)
{
    return math_units_value(&m->units, math_settled(m, value, unit), unit);
}

int math_has(const math *m, const char *name)
{
    return find(m, flk_text_of(name)) < m->n;
}

void math_set(math *m, const char *name, double value)
{
    int i = find(m, flk_text_of(name));

    if (i == MATH_SYMBOLS)
        return;
    flk_text_join(m->symbol[i].name, MATH_NAME, name, (char *)NULL);
    m->symbol[i].value = math_settled(m, value, unit_of(name));
    m->n += i == m->n;
}

/* ------------------------------------------------------------------------------ equations */

/* An equation on its way to the page. */
typedef struct writer {
    math *m;
    int has_numbers; /* 1: symbols are replaced by their values */
    int is_long;     /* 1: fractions are written in a line, which can end between terms */
    int is_first;    /* 1: nothing stands before, in this bracket or fraction */
    int depth;       /* of brackets, fractions and roots */
    text rest;
} writer;

static text next_token(writer *w)
{
    text token;

    token.start = NULL;
    token.length = 0;
    while (flk_text_split(&w->rest, ' ', &token) && !token.length)
        ;
    return token;
}

/* Put a symbol, or its value, which is in brackets if it is negative and something stands before it. */
static void put_named(writer *w, text token)
{
    page *p = w->m->p;
    int i = find(w->m, token), in_brackets;
    math_unit unit;
    char name[24];

    if (!w->has_numbers || i == w->m->n) {
        math_symbol(p, flk_text_copy(token, name, sizeof name));
        return;
    }
    in_brackets = w->m->symbol[i].value < 0 && !w->is_first;
    page_print(p, in_brackets ? "<mrow>" LEFT : "");
    unit = unit_of(w->m->symbol[i].name);
    put_number(p, math_units_value(&w->m->units, w->m->symbol[i].value, unit), unit == MATH_ANGLE);
    page_print(p, in_brackets ? RIGHT "</mrow>" : "");
}

/* 1 for a length between two points: OM. */
static int is_of_two_letters(text token)
{
    return token.length == 2 && isupper((unsigned char)token.start[0]) &&
           isupper((unsigned char)token.start[1]);
}

static void put_atom(writer *w, text token)
{
    char power =
        w->rest.start && w->rest.length >= 2 && w->rest.start[0] == '^' ? w->rest.start[1] : '\0';
    page *p = w->m->p;

    if (is_of_two_letters(token) && !w->has_numbers && !w->is_first)
        page_print(p, "<mspace width=\"0.17em\"/>");
    if (power) {
        next_token(w);
        page_print(p, "<msup>");
        w->is_first = 0; /* a negative number has brackets in any case */
    }
    if (token.length > 3 && strncmp(token.start + token.length - 3, "deg", 3) == 0) {
        page_print(p, "<mn>");
        xml_put(p->out, token.start, token.length - 3);
        page_print(p, DEGREE "</mn>");
    } else if (strchr("0123456789", token.start[0])) {
        page_print(p, "<mn>");
        xml_put(p->out, token.start, token.length);
        page_print(p, "</mn>");
    } else {
        put_named(w, token);
    }
    if (power)
        page_print(p, "<mn>%d</mn></msup>", power - '0');
}

/* Leave out the group of <NAME ... > if the symbol is 0. */
static void begin_group(writer *w, text token)
{
    int i = find(w->m, flk_text_from(token, 1));

    if (i == w->m->n || w->m->symbol[i].value != 0)
        return;
    while (token.length && !flk_text_same(token, ">"))
        token = next_token(w);
}

/* The markup of tokens that are no symbols: in symbols, with numbers, and with many of them, where a
** fraction is written in a line; whether nothing stands before the next token; by how much it is deeper. */
static const struct {
    const char *token, *markup, *with_numbers, *when_long;
    int is_before, deeper;
} signs[] = {{"{", "<mfrac><mrow>" ABOVE_RULE, NULL, LEFT, 1, 1},
             {"|", "</mrow><mrow>" BELOW_RULE, NULL, RIGHT INFIX("/") LEFT, 1, 0},
             {"}", "</mrow></mfrac>", NULL, RIGHT, 0, -1},
             {"[", "<msqrt><mrow>", NULL, NULL, 1, 1},
             {"]", "</mrow></msqrt>", NULL, NULL, 0, -1},
             {"(", LEFT, NULL, NULL, 1, 1},
             {")", RIGHT, NULL, NULL, 0, -1},
             {")^2", "<msup>" RIGHT "<mn>2</mn></msup>", NULL, NULL, 0, -1},
             {",", "<mo>,</mo>", NULL, NULL, 1, 0},
             {"=", INFIX("="), NULL, NULL, 1, 0},
             {"+", INFIX("+"), NULL, NULL, 0, 0},
             {"-", "<mo>" MINUS "</mo>", NULL, NULL, 0, 0},
             {"*", "<mo>\342\201\242</mo>", INFIX("\302\267"), NULL, 0, 0},
             {"sin", FUNCTION("sin"), NULL, NULL, 0, 0},
             {"cos", FUNCTION("cos"), NULL, NULL, 0, 0},
             {"asin", FUNCTION("arcsin"), NULL, NULL, 0, 0},
             {"acos", FUNCTION("arccos"), NULL, NULL, 0, 0},
             {"atan2", FUNCTION("atan2"), NULL, NULL, 0, 0}};

#define SIGNS (sizeof signs / sizeof signs[0])

/* 1 for a sign before which a line may end: between terms, and between factors that are numbers. */
static int begins_piece(const writer *w, text token)
{
    return !w->is_first && w->depth == 0 && token.length == 1 &&
           strchr(w->has_numbers ? "=+-*" : "=+-", token.start[0]) != NULL;
}

/* The markup of signs[i]. */
static const char *markup_of(const writer *w, size_t i, int is_piece)
{
    if (signs[i].token[0] == '-' && (is_piece || w->is_first))
        return is_piece ? INFIX(MINUS) : "<mo form=\"prefix\">" MINUS "</mo>";
    return w->is_long && signs[i].when_long          ? signs[i].when_long
           : w->has_numbers && signs[i].with_numbers ? signs[i].with_numbers
                                                     : signs[i].markup;
}

static void put_token(writer *w, text token)
{
    int is_piece = begins_piece(w, token);
    size_t i;

    if (token.start[0] == '<') {
        begin_group(w, token);
        return;
    }
    if (flk_text_same(token, ">") || (w->is_first && flk_text_same(token, "+")))
        return;
    for (i = 0; i < SIGNS && !flk_text_same(token, signs[i].token); i++)
        ;
    if (is_piece)
        begin_piece(w->m->p);
    if (i == SIGNS)
        put_atom(w, token);
    else
        page_print(w->m->p, "%m", markup_of(w, i, is_piece));
    w->is_first = i < SIGNS && signs[i].is_before;
    if (i < SIGNS && !(w->is_long && signs[i].when_long))
        w->depth += signs[i].deeper;
}

static int is_long(const char *equation)
{
    return strlen(equation) > LONG_EQUATION;
}

static void put_equation(math *m, const char *equation, int has_numbers)
{
    writer w;
    text token;

    w.m = m;
    w.has_numbers = has_numbers;
    w.is_long = has_numbers && is_long(equation);
    w.is_first = 1;
    w.depth = 0;
    w.rest = flk_text_of(equation);
    while ((token = next_token(&w)).length)
        put_token(&w, token);
}

/* Write = VALUE UNIT, and the same in the unit of the tables. */
static void put_value(math *m, double value, math_unit unit)
{
    const math_units *u = &m->units;

    page_print(m->p, INFIX("="));
    put_number(m->p, math_units_value(u, value, unit), unit == MATH_ANGLE);
    if (*u->of[unit].name)
        page_print(m->p, "<mtext>%U</mtext>", u->of[unit].name);
    if (!u->of[unit].tables.name || value == 0)
        return;
    begin_piece(m->p);
    page_print(m->p, INFIX("="));
    put_number(m->p, math_units_in_tables(u, value, unit), 0);
    page_print(m->p, "<mtext>%U</mtext>", u->of[unit].tables.name);
}

/* Begin the block of an equation: what it is for, or null, and the equation in symbols. */
static void put_symbols(math *m, const char *name, const char *equation, const char *end)
{
    math_block(m->p, "equation");
    open_line(m->p, "symbols");
    if (name) {
        math_symbol(m->p, name);
        page_print(m->p, INFIX("="));
    }
    put_equation(m, equation, 0);
    page_print(m->p, "%m", end);
    close_line(m->p);
}

static void end_block(math *m)
{
    close_line(m->p);
    page_print(m->p, "</div>\n");
}

void math_let(math *m, const char *name, const char *equation, double value)
{
    math_unit unit = unit_of(name);

    put_symbols(m, name, equation, "");
    open_line(m->p, "numbers");
    page_print(m->p, INFIX("="));
    put_equation(m, equation, 1);
    if (is_long(equation)) {
        close_line(m->p);
        open_line(m->p, "numbers");
    } else {
        begin_piece(m->p);
    }
    put_value(m, math_settled(m, value, unit), unit);
    end_block(m);
    math_set(m, name, value);
}

void math_zero(math *m, const char *equation, double value, double size, math_unit unit)
{
    put_symbols(m, NULL, equation, "<mo>=</mo><mn>0</mn><mtext>:</mtext>");
    open_line(m->p, "numbers");
    put_equation(m, equation, 1);
    begin_piece(m->p);
    put_value(m, fabs(value) < 1e-6 * size ? 0 : value, unit);
    end_block(m);
}

void math_show(math *m, const char *equation)
{
    put_symbols(m, NULL, equation, "");
    page_print(m->p, "</div>\n");
}

void math_show_numbers(math *m, const char *equation)
{
    math_block(m->p, "equation");
    open_line(m->p, "numbers");
    put_equation(m, equation, 1);
    end_block(m);
}

void math_given(math *m, const char *name, double value)
{
    math_unit unit = unit_of(name);

    math_set(m, name, value);
    page_print(m->p, "<li><math xmlns=\"" NAMESPACE "\"><mrow>");
    math_symbol(m->p, name);
    put_value(m, math_settled(m, value, unit), unit);
    page_print(m->p, "</mrow></math></li>\n");
}
