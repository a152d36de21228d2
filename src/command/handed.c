/* SPDX-License-Identifier: GPL-3.0-or-later
**
** handed.c - what the names of files that were handed in say: whose they are, and when.
*/
#include <string.h>

#include "files.h"
#include "handed.h"

#define MOST_ENDINGS 3 /* such as .expect.txt */

text handed_stem(const char *path)
{
    text stem = flk_text_of(files_name(path));
    size_t i;
    int k;

    for (k = 0; k < MOST_ENDINGS; k++) {
        for (i = stem.length; i > 1 && stem.start[i - 1] != '.' && stem.length - i < 7; i--)
            if (!flk_text_is_word(stem.start[i - 1]))
                return stem; /* Dr. A. Bek: no ending */
        if (i <= 1 || stem.start[i - 1] != '.')
            break;
        stem.length = i - 1;
    }
    return stem;
}

static int is_digit(int c)
{
    return '0' <= c && c <= '9';
}

/* ------------------------------------------------------------------------------------------ whose it is */

/* The number of digits at the front of a text. */
static size_t count_digits(text t)
{
    size_t n = 0;

    while (n < t.length && is_digit(t.start[n]))
        n++;
    return n;
}

/* 123456-78901 - WHO - DATE */
static int take_numbered(text stem, text *who)
{
    text rest = stem, date;
    size_t n = count_digits(stem);

    if (!n || n == stem.length || stem.start[n] != '-')
        return 0;
    rest = flk_text_from(stem, n + 1);
    n = count_digits(rest);
    rest = flk_text_from(rest, n);
    if (!n || rest.length < 3 || memcmp(rest.start, " - ", 3) != 0)
        return 0;
    rest = flk_text_from(rest, 3);
    if (!flk_text_cut(rest, " - ", who, &date))
        *who = flk_text_trim(rest);
    return who->length > 0;
}

/* WHO_123456_assignsubmission..., WHO_1234_5678_..., WHO_LATE_1234_5678_... */
static int take_underlined(text stem, text *who)
{
    static const char late[] = "_LATE", submission[] = "assignsubmission";
    text rest;
    size_t i, n;

    for (i = 1; i < stem.length; i++) {
        rest = flk_text_from(stem, i);
        if (rest.start[0] != '_')
            continue;
        rest = flk_text_from(rest, 1);
        n = count_digits(rest);
        rest = flk_text_from(rest, n);
        if (!n || !rest.length || rest.start[0] != '_')
            continue;
        rest = flk_text_from(rest, 1);
        n = count_digits(rest);
        if ((n && n < rest.length && rest.start[n] == '_') ||
            (rest.length >= sizeof submission - 1 &&
             memcmp(rest.start, submission, sizeof submission - 1) == 0))
            break;
    }
    *who = stem;
    who->length = i < stem.length ? i : 0;
    n = sizeof late - 1;
    if (who->length > n && memcmp(who->start + who->length - n, late, n) == 0)
        who->length -= n;
    return who->length > 0;
}

text handed_who(text stem)
{
    text who;

    return take_numbered(stem, &who) || take_underlined(stem, &who) ? who : stem;
}

/* --------------------------------------------------------------------------------------- when it was */

/* Take a number of at most `most` digits off the front; -1 if there is none. */
static double take_number(text *t, size_t most)
{
    double number = 0;
    size_t n = 0;

    for (; n < most && n < t->length && is_digit(t->start[n]); n++)
        number = 10 * number + (t->start[n] - '0');
    *t = flk_text_from(*t, n);
    return n ? number : -1;
}

/* Pass one of these characters; 0 if there is none. */
static int pass(text *t, const char *characters)
{
    int is_there = t->length && strchr(characters, t->start[0]);

    if (is_there)
        *t = flk_text_from(*t, 1);
    return is_there;
}

/* Minutes of a clock, 1030, 10:30 or 10-30-59, AM or PM; 0 if there is none. */
static double take_minutes(text t)
{
    double hours, minutes = 0, seconds = 0;
    size_t n;

    n = count_digits(t);
    hours = take_number(&t, n > 2 ? n - 2 : 2);
    if (hours < 0 || n > 4)
        return 0;
    if (n > 2 || pass(&t, ":-_."))
        minutes = take_number(&t, 2);
    if (pass(&t, ":-_."))
        seconds = take_number(&t, 2);
    pass(&t, " ");
    if (t.length >= 2 && (t.start[1] == 'M' || t.start[1] == 'm') && strchr("AaPp", t.start[0])) {
        hours = hours == 12 ? 0 : hours;
        hours += strchr("Pp", t.start[0]) ? 12 : 0;
    }
    return 60 * hours + (minutes > 0 ? minutes : 0) + (seconds > 0 ? seconds / 60 : 0);
}

static double date_of(double year, double month, double day, text clock)
{
    if (year < 1990 || year > 2200 || month < 1 || month > 12 || day < 1 || day > 31)
        return 0;
    return ((year * 12 + month) * 31 + day) * 1440 + take_minutes(clock);
}

/* 2026-11-26, 2026-11-26-10-30 */
static double date_by_numbers(text t)
{
    double year = take_number(&t, 4), month, day;

    if (!pass(&t, "-_."))
        return 0;
    month = take_number(&t, 2);
    if (!pass(&t, "-_."))
        return 0;
    day = take_number(&t, 2);
    pass(&t, "-_ T");
    return date_of(year, month, day, t);
}

/* Nov 26, 2026 1030 AM */
static double date_by_month(text t)
{
    static const char months[] = "JanFebMarAprMayJunJulAugSepOctNovDec";
    double day, year;
    int month;

    for (month = 1; month <= 12; month++)
        if (t.length > 3 && memcmp(t.start, months + 3 * (month - 1), 3) == 0)
            break;
    if (month > 12)
        return 0;
    t = flk_text_from(t, 3);
    if (!pass(&t, " "))
        return 0;
    day = take_number(&t, 2);
    pass(&t, ",");
    if (!pass(&t, " "))
        return 0;
    year = take_number(&t, 4);
    pass(&t, ",");
    pass(&t, " ");
    return date_of(year, month, day, t);
}

double handed_date(text stem)
{
    double date = 0;
    size_t i;

    for (i = 0; i < stem.length && date == 0; i++)
        if (i == 0 || !flk_text_is_word(stem.start[i - 1]) || stem.start[i - 1] == '_') {
            text rest = flk_text_from(stem, i);

            date = is_digit(rest.start[0]) ? date_by_numbers(rest) : date_by_month(rest);
        }
    return date;
}
