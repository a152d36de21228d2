/* SPDX-License-Identifier: GPL-3.0-or-later
**
** quantity.c - quantities from text: a number with a unit, such as 40 deg.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "fourlink.h"
#include "number.h"
#include "quantity.h"
#include "spelling.h"

/* The name of a quantity of this dimension, or null. */
static const char *words_of(dimension dim)
{
    int q;

    for (q = 0; q < QUANTITY_COUNT; q++)
        if (flk_dimension_equal(dim, flk_quantities[q].dim))
            return flk_quantities[q].words;
    return NULL;
}

/* What a unit is one of, or null if it is of no quantity: of lb-in, a mass moment or a torque. */
static const char *words_of_unit(text t, dimension dim, char out[MESSAGE_SIZE])
{
    const char *words = words_of(dim), *as_force = NULL;
    unit u;

    if (flk_unit_read_forces(t, &u) && !flk_dimension_equal(u.dim, dim))
        as_force = words_of(u.dim);
    return words && as_force ? flk_message(out, MESSAGE_SIZE, "%s or %s", words, as_force)
           : words           ? words
                             : as_force;
}

/* The message for a comma in the number at the front of `rest`: 66,5 or 1,000. */
static void refuse_comma(text rest, text whole, char message[MESSAGE_SIZE])
{
    char point[40], none[40];
    size_t i, n = 0, digits = 0, commas = 0;

    for (i = 0; i < rest.length && i + 1 < sizeof point && strchr("+-.,0123456789", rest.start[i]);
         i++) {
        point[i] = none[n] = rest.start[i];
        digits = rest.start[i] == ',' ? 0 : digits + 1;
        n += rest.start[i] != ',';
        if (rest.start[i] == ',') {
            point[i] = '.';
            commas++;
        }
    }
    point[i] = none[n] = '\0';
    if (commas > 1 || strchr(none, '.'))
        flk_message(message, MESSAGE_SIZE, "'%t': a comma within a number: write it without",
                    whole);
    else if (digits == 3 && none[strspn(none, "+-")] != '0')
        flk_message(message, MESSAGE_SIZE, "'%t': a comma within a number: write %s or %s", whole,
                    none, point);
    else
        flk_message(message, MESSAGE_SIZE, "'%t': a comma as decimal mark: write %s", whole, point);
}

/* The message for a missing number. */
static void refuse_number(text rest, text whole, quantity q, char message[MESSAGE_SIZE])
{
    const quantity_info *info = &flk_quantities[q];
    text after = rest.length ? flk_text_from(rest, 1) : rest;
    int is_signed = rest.length && (rest.start[0] == '-' || rest.start[0] == '+');
    const char *why = "";

    if (is_signed && after.length && (after.start[0] == '-' || after.start[0] == '+'))
        why = ": it has two signs";
    else if (is_signed && flk_text_blank(after))
        why = ": there is a blank after the sign";
    flk_message(message, MESSAGE_SIZE, "expected %s, such as %s, not '%t'%s", info->words,
                info->example, whole, why);
}

/* Take pi off the front of a text, after a number perhaps with a blank or * between; 0 if it is not there. */
static int take_pi(text *rest, int is_after_number)
{
    text t = *rest;

    if (is_after_number) {
        t = flk_text_trim(t);
        if (t.length && t.start[0] == '*')
            t = flk_text_trim(flk_text_from(t, 1));
    }
    if (t.length < 2 || (t.start[0] | 0x20) != 'p' || (t.start[1] | 0x20) != 'i' ||
        (t.length > 2 && flk_text_is_word(t.start[2])))
        return 0;
    *rest = flk_text_from(t, 2);
    return 1;
}

/* What a number is besides a decimal number. */
enum { IS_FRACTION = 1, IS_PI = 2 };

/* Take a number off the front of `rest`: 2.5, 1/3 and, if pi is allowed, pi, -pi/6, 3 pi/4, 1/2 pi.
** `form` says which of these it is. */
static number_status take_number(text *rest, int allows_pi, double *number, int *form)
{
    text t = *rest, after = t;
    number_status status = flk_number_read(&t, number);
    int is_signed = t.length && (t.start[0] == '-' || t.start[0] == '+');
    double divisor;

    *form = 0;
    if (status == NUMBER_NONE && is_signed)
        after = flk_text_from(t, 1);
    if (status == NUMBER_NONE && allows_pi && take_pi(&after, 0)) {
        *number = is_signed && t.start[0] == '-' ? -M_PI : M_PI;
        *form = IS_PI;
        t = after;
    } else if (status != NUMBER_OK) {
        return status;
    } else if (allows_pi && take_pi(&t, 1)) {
        *number *= M_PI;
        *form = IS_PI;
    }
    if (t.length > 1 && t.start[0] == '/' && '0' <= t.start[1] && t.start[1] <= '9') {
        t = flk_text_from(t, 1);
        status = flk_number_read(&t, &divisor);
        if (status != NUMBER_OK || divisor == 0)
            return status != NUMBER_OK ? status : NUMBER_NOT_FINITE;
        *number /= divisor;
        *form |= IS_FRACTION;
        if (allows_pi && !(*form & IS_PI) && take_pi(&t, 1)) {
            *number *= M_PI;
            *form |= IS_PI;
        }
    }
    *rest = t;
    return NUMBER_OK;
}

/* The same as flk_quantity_number, with the form of the number. */
static int read_number(text *rest, text whole, quantity q, int allows_pi, double *number, int *form,
                       char message[MESSAGE_SIZE])
{
    number_status status;

    *rest = flk_text_trim(*rest);
    status = take_number(rest, allows_pi, number, form);
    if (status == NUMBER_NONE)
        refuse_number(*rest, whole, q, message);
    else if (status == NUMBER_COMMA)
        refuse_comma(*rest, whole, message);
    else if (status != NUMBER_OK)
        flk_message(message, MESSAGE_SIZE,
                    status == NUMBER_NOT_FINITE ? "'%t' is not a finite number"
                    : status == NUMBER_HEX      ? "'%t' is not a decimal number"
                                                : "'%t' has too many digits",
                    whole);
    return status == NUMBER_OK;
}

int flk_quantity_number(text *rest, text whole, quantity q, double *number,
                        char message[MESSAGE_SIZE])
{
    int form;

    return read_number(rest, whole, q, 0, number, &form, message);
}

static int is_direction(text t)
{
    return flk_text_equal(t, "clockwise") || flk_text_equal(t, "cw") ||
           flk_text_equal(t, "counterclockwise") || flk_text_equal(t, "ccw");
}

/* 1 if a text begins with an apostrophe, ' or the typographic one, and a digit. */
static int is_apostrophe(text t)
{
    size_t n = t.length && t.start[0] == '\'' ? 1 : 3;

    return t.length > n && (n == 1 || memcmp(t.start, "\342\200\231", 3) == 0) &&
           '0' <= t.start[n] && t.start[n] <= '9';
}

/* The message for text that cannot follow a number; null if it can. */
static const char *why_trailing_text(text t)
{
    int c = t.length ? t.start[0] : 0;

    if ('0' <= c && c <= '9')
        return "'%t': two numbers in place of one; a blank does not separate thousands";
    if (is_apostrophe(t))
        return "'%t': an apostrophe within a number: write it without";
    if (t.length > 1 && c == '.' && '0' <= t.start[1] && t.start[1] <= '9')
        return "'%t': a number with two points";
    if (t.length > 1 && c == '/' && '0' <= t.start[1] && t.start[1] <= '9')
        return "'%t': a fraction: write it as a decimal number";
    return NULL;
}

/* The message if `t` is not a unit; `bad` is its unknown part. */
static void refuse_unit(text t, text bad, text whole, quantity q, char message[MESSAGE_SIZE])
{
    const char *why = t.start != whole.start ? why_trailing_text(t) : NULL;
    const char *nearest = why ? NULL : flk_unit_nearest(t, bad, flk_quantities[q].dim);

    if (nearest && flk_text_same(bad, nearest))
        nearest = NULL;
    if (why)
        flk_message(message, MESSAGE_SIZE, why, whole);
    else if (is_direction(bad))
        flk_message(message, MESSAGE_SIZE,
                    "unknown unit '%t': counter-clockwise is positive, clockwise negative", bad);
    else if (memchr(bad.start, '#', bad.length) || memchr(bad.start, ';', bad.length))
        flk_message(message, MESSAGE_SIZE, "unknown unit '%t': a comment needs a blank before it",
                    bad);
    else
        flk_message(message, MESSAGE_SIZE, "unknown unit '%t' in '%t'%h", bad.length ? bad : t,
                    whole, nearest);
}

/* Write a text with another unit in place of a word of it. */
static text with_unit(text whole, text word, const char *other, char out[MESSAGE_SIZE])
{
    text before = whole, after = flk_text_from(whole, (size_t)(word.start - whole.start));

    before.length -= after.length;
    flk_message(out, MESSAGE_SIZE, "%t%s%t", before, other, flk_text_from(after, word.length));
    return flk_text_of(out);
}

/* 1, and a message, if a mass is given for a force or the other way round. */
static int explain_weight(text t, text whole, quantity q, char message[MESSAGE_SIZE])
{
    char other_text[MESSAGE_SIZE];
    const char *other;
    text word;

    if (!flk_unit_weight(t, flk_quantities[q].dim, &word, &other) || word.start < whole.start ||
        word.start >= whole.start + whole.length)
        return 0;
    if (q != QUANTITY_MASS && q != QUANTITY_FORCE)
        flk_message(message, MESSAGE_SIZE, "'%t' is not %s: if %t is a weight, write %t", whole,
                    flk_quantities[q].words, word, with_unit(whole, word, other, other_text));
    else
        flk_message(message, MESSAGE_SIZE,
                    q == QUANTITY_MASS ? "'%t' is a force: if it is a weight, the mass is %t"
                                       : "'%t' is a mass: its weight is %t",
                    whole, with_unit(whole, word, other, other_text));
    return 1;
}

int flk_quantity_weight(text t, text whole, char message[MESSAGE_SIZE])
{
    char other_text[MESSAGE_SIZE];
    const char *other;
    text word;

    if (!flk_unit_is_weight(t) ||
        !flk_unit_weight(t, flk_quantities[QUANTITY_FORCE].dim, &word, &other) ||
        t.start <= whole.start || t.start + t.length > whole.start + whole.length)
        return 0;
    flk_message(message, MESSAGE_SIZE, "'%t' is read as a force, %t", whole,
                with_unit(whole, word, other, other_text));
    return 1;
}

int flk_quantity_unit(text t, text whole, quantity q, unit bare, unit *u,
                      char message[MESSAGE_SIZE])
{
    const quantity_info *info = &flk_quantities[q];
    char both[MESSAGE_SIZE];
    const char *words;
    text bad;

    t = flk_text_trim(t);
    *u = bare;
    if (!t.length)
        return 1;
    if (flk_text_same(t, "%") && q != QUANTITY_NUMBER) {
        flk_message(message, MESSAGE_SIZE, "'%t': per cent of what? expected %s, such as %s", whole,
                    info->words, info->example);
        return 0;
    }
    if (flk_text_same(t, "1") || !flk_unit_read_as(t, info->dim, u, &bad)) {
        refuse_unit(t, flk_text_same(t, "1") ? t : bad, whole, q, message);
        return 0;
    }
    if (flk_dimension_equal(u->dim, info->dim))
        return 1;
    words = words_of_unit(t, u->dim, both);
    if (explain_weight(t, whole, q, message))
        return 0;
    if (words)
        flk_message(message, MESSAGE_SIZE, "'%t' is %s; expected %s, such as %s", whole, words,
                    info->words, info->example);
    else
        flk_message(message, MESSAGE_SIZE, "'%t' is not %s, such as %s", whole, info->words,
                    info->example);
    return 0;
}

text flk_quantity_after_number(text t)
{
    double number;
    int form;

    t = flk_text_trim(t);
    take_number(&t, 1, &number, &form);
    return t;
}

text flk_quantity_unit_text(text t)
{
    return flk_text_trim(flk_quantity_after_number(t));
}

/* Above 1e9 rad an angle has too few digits left after its revolutions. */
#define ANGLE_MAX 1e9

int flk_quantity_size(double si, text whole, quantity q, char message[MESSAGE_SIZE])
{
    double max = q == QUANTITY_ANGLE    ? ANGLE_MAX
                 : q == QUANTITY_LENGTH ? FOURLINK_LENGTH_MAX
                                        : FOURLINK_NUMBER_MAX;

    if (-max <= si && si <= max)
        return 1;
    flk_message(message, MESSAGE_SIZE, "'%t' is out of range", whole);
    return 0;
}

/* The value of one unit of the last digit: 0.01 for 2.50, 10 for 1.2e2. */
static double last_digit(text t)
{
    double digit = 1, value = 0;
    int decimals = 0, after = 0, exponent = 0;
    size_t i;

    for (i = 0; i < t.length; i++) {
        char c = t.start[i];

        if (c == '.')
            after = 1;
        else if ('0' <= c && c <= '9')
            decimals += after;
        else if ((c == 'e' || c == 'E') && i + 1 < t.length) {
            text rest = flk_text_from(t, i + 1);

            if (flk_number_read(&rest, &value) == NUMBER_OK)
                exponent = value < -400 ? -400 : value > 400 ? 400 : (int)value;
            break;
        } else if (i > 0 || (c != '+' && c != '-')) {
            break;
        }
    }
    for (exponent -= decimals; exponent < 0; exponent++)
        digit /= 10;
    for (; exponent > 0; exponent--)
        digit *= 10;
    return digit;
}

/* Of a fraction or a multiple of pi: its last digit. */
#define EXACT 1e-9

/* A longer text is not a quantity. */
#define LONGEST 200

int flk_quantity_read(text t, text whole, quantity q, unit bare, quantity_value *value,
                      char message[MESSAGE_SIZE])
{
    char plain[SPELLING_SIZE(LONGEST)];
    int is_whole = t.start == whole.start, form;
    text rest;

    if (t.length <= LONGEST && !flk_spelling_is_plain(t)) {
        t = flk_spelling_plain(t, plain);
        whole = is_whole ? t : whole;
    }
    rest = t;
    if (!read_number(&rest, whole, q, flk_quantities[q].dim.rad > 0, &value->number, &form,
                     message))
        return 0;
    if (form & IS_PI)
        bare.up = bare.down = 1;
    if (!flk_quantity_unit(rest, whole, q, bare, &value->unit, message))
        return 0;
    value->si = flk_unit_to_si(value->number, value->unit);
    value->digit =
        form ? EXACT * fabs(value->si) : flk_unit_to_si(last_digit(flk_text_trim(t)), value->unit);
    return flk_quantity_size(value->si, whole, q, message);
}
