/* SPDX-License-Identifier: GPL-3.0-or-later
**
** number.h - numbers from the text of a deck, the same in every locale.
*/
#ifndef FOURLINK_NUMBER_H
#define FOURLINK_NUMBER_H

#include "digits.h"
#include "text.h"

typedef enum number_status {
    NUMBER_OK,
    NUMBER_NONE,       /* no number here */
    NUMBER_NOT_FINITE, /* inf, nan, or too large to hold */
    NUMBER_HEX,        /* 0x1p3 and the like */
    NUMBER_COMMA,      /* 1,5: a decimal comma */
    NUMBER_TOO_LONG
} number_status;

/* Take a decimal number off the front of `rest`; a failure leaves `rest` unchanged. */
number_status flk_number_read(text *rest, double *value);

/* Write a number from 1e-28 to 1e38 with the fewest digits, at least 15, that read back as the same number.
** For other numbers the last digits may be wrong. */
char *flk_number_shortest(double value, char out[DIGITS_SIZE]);

#endif
