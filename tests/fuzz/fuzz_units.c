/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fuzz_units.c - numbers, units and quantities: texts to numbers, and numbers to texts.
**
** Input: a byte that chooses the quantity and the number of digits, then a text, whose first 8 bytes are a
** number too.
*/
#include <math.h>

#include "base/digits.h"
#include "base/number.h"
#include "base/quantity.h"
#include "base/spelling.h"
#include "input.h"

/* Ours is theirs, but 0 has no sign. */
static int is_same(const char *ours, const char *end, const char *theirs)
{
    theirs += theirs[0] == '-' && !strpbrk(theirs, "123456789");
    return (size_t)(end - ours) == strlen(theirs) && !memcmp(ours, theirs, strlen(theirs));
}

/* A number that is written is read back; what the exact products are certain of, the C library writes too. */
static void write_number(double value, int digits)
{
    char ours[DIGITS_SIZE], theirs[400], *end;
    text rest;
    double back;

    if (!isfinite(value))
        return;
    rest = flk_text_of(flk_number_shortest(value, ours));
    MUST(flk_number_read(&rest, &back) == NUMBER_OK && !rest.length);
    MUST(back == value || fabs(value) < 1e-28 || fabs(value) > 1e38);
    end = flk_digits_general(value, digits + 1, ours);
    snprintf(theirs, sizeof theirs, "%.*g", digits + 1, value);
    if (end)
        MUST(is_same(ours, end, theirs));
    end = flk_digits_exponent(value, digits, ours);
    snprintf(theirs, sizeof theirs, "%.*e", digits, value);
    if (end)
        MUST(is_same(ours, end, theirs));
    end = flk_digits_fixed(value, digits, ours);
    snprintf(theirs, sizeof theirs, "%.*f", digits, value);
    if (end)
        MUST(is_same(ours, end, theirs));
    flk_digits_short(value, digits + 1, ours);
}

static void read_number(text t, int digits)
{
    text rest = t;
    double value;

    if (flk_number_read(&rest, &value) != NUMBER_OK)
        return;
    MUST(isfinite(value) && rest.length < t.length);
    write_number(value, digits);
}

static void read_quantity(text t, quantity q)
{
    char message[MESSAGE_SIZE] = "", *plain = malloc(SPELLING_SIZE(t.length));
    quantity_value value;
    unit bare, u;
    text bad, spelt;

    MUST(plain);
    spelt = flk_spelling_plain(t, plain);
    MUST(spelt.length < SPELLING_SIZE(t.length));
    MUST(flk_unit_read(flk_text_of(flk_quantities[q].unit), &bare, &bad));
    if (flk_quantity_read(spelt, t, q, bare, &value, message))
        MUST(isfinite(value.si) && isfinite(value.number) && value.unit.up > 0);
    else
        MUST(message[0] && memchr(message, 0, sizeof message));
    if (flk_unit_read(t, &u, &bad))
        MUST(u.up > 0 && u.down > 0);
    else
        flk_unit_nearest(t, bad, flk_quantities[q].dim);
    free(plain);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    double value;
    int digits;
    text t;

    if (!size)
        return 0;
    digits = *data >> 4;
    t.start = (const char *)data + 1;
    t.length = size - 1;
    read_number(t, digits);
    read_quantity(t, (quantity)(*data % QUANTITY_COUNT));
    if (t.length >= sizeof value) {
        memcpy(&value, t.start, sizeof value);
        write_number(value, digits);
    }
    return 0;
}
