/* SPDX-License-Identifier: GPL-3.0-or-later
**
** doubts.c - notes on values that are allowed but probably not meant.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "reader.h"

/* ------------------------------------------------------------------------------------------- units */

/* 1 if a number has three decimals and at most three digits before them: 1.200 rpm. */
static int is_like_thousands(text t)
{
    size_t digits, decimals;

    if (t.length && strchr("+-", t.start[0]))
        t = flk_text_from(t, 1);
    for (digits = 0; digits < t.length && strchr("0123456789", t.start[digits]); digits++)
        ;
    if (digits < 1 || digits > 3 || digits == t.length || t.start[digits] != '.')
        return 0;
    t = flk_text_from(t, digits + 1);
    for (decimals = 0; decimals < t.length && strchr("0123456789", t.start[decimals]); decimals++)
        ;
    return decimals == 3;
}

#define SLOW 20 /* rpm; a thousand times as much is the speed of a fast machine */

/* Note 1.200 rpm, where a point probably separates thousands. */
static void check_thousands(parser *p, key_code key)
{
    const setting *s = flk_setting_find(p, key);
    double rpm = s->si[0] * 60 / (2 * M_PI);

    if (s->si[0] != 0 && fabs(rpm) < SLOW && fabs(s->number) < SLOW && fabs(s->number) >= 1 &&
        fabs(rpm - s->number) < 1e-9 && is_like_thousands(s->value))
        flk_mistake(NOTES(p), s->place,
                    "'%t' is read as %g rpm, with a decimal point: if thousands are meant, write "
                    "%g rpm",
                    s->value, s->number, 1000 * s->number);
}

void flk_build_doubts(parser *p)
{
    check_thousands(p, KEY_MOTION_SPEED);
    check_thousands(p, KEY_MOTION_MEAN_SPEED);
    check_thousands(p, KEY_MOTOR_NO_LOAD_SPEED);
}
