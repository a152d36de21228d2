/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fortran77.c - results by name for programs in FORTRAN 77, see fourlink.h.
*/
#include <string.h>

#include "base/message.h"
#include "opened.h"

#define MOST_WORDS (3 * DECK_NAME_SIZE) /* of SECTION NAME.KEY = NUMBER UNIT */

/* The length of a FORTRAN text without its trailing blanks. */
static unsigned long without_blanks(const char *words, unsigned long length)
{
    while (length > 0 && words[length - 1] == ' ')
        length--;
    return length;
}

static void put_text(const char *words, char *out, unsigned long length)
{
    unsigned long n = (unsigned long)strlen(words);

    memset(out, ' ', length);
    memcpy(out, words, n < length ? n : length);
}

/* The text of a status; of a deck with a mistake, that as LINE: MESSAGE. */
static void put_message(int status, const fourlink_mistake *mistake, char *msg,
                        unsigned long length)
{
    char words[sizeof mistake->message + 40];

    if (status == FOURLINK_BAD_DECK)
        flk_message(words, sizeof words, "%ld: %s", mistake->line, mistake->message);
    else
        flk_message(words, sizeof words, "%s", status ? fourlink_status_text(status) : "");
    put_text(words, msg, length);
}

void flopen_(const char *deck_text, fourlink_results **handle, int *istat, char *msg,
             unsigned long deck_length, unsigned long msg_length)
{
    fourlink_source source;
    fourlink_mistake mistake;

    memset(&source, 0, sizeof source);
    source.text = deck_text;
    source.length = without_blanks(deck_text, deck_length);
    source.synthesis = 1;
    *handle = NULL;
    *istat = fourlink_results_open(&source, 1, handle, &mistake, NULL);
    put_message(*istat, &mistake, msg, msg_length);
}

void flshut_(fourlink_results **handle)
{
    fourlink_results_free(*handle);
    *handle = NULL;
}

void flnrow_(fourlink_results *const *handle, int *nrows, int *ncols)
{
    *nrows = *handle ? (int)(*handle)->now->a.course.range.n_rows : 0;
    *ncols = *handle ? (int)(*handle)->now->n_columns : 0;
}

void flname_(fourlink_results *const *handle, const int *i, char *name, char *in_unit, int *istat,
             unsigned long name_length, unsigned long unit_length)
{
    const fourlink_value *list;
    unsigned long n;

    *istat = fourlink_results_list(*handle, FOURLINK_COLUMNS, &list, &n);
    if (*istat == FOURLINK_OK && (*i < 1 || (unsigned long)*i > n))
        *istat = FOURLINK_NO_SUCH_NAME;
    if (*istat != FOURLINK_OK)
        return;
    put_text(list[*i - 1].name, name, name_length);
    put_text(list[*i - 1].unit, in_unit, unit_length);
}

/* A FORTRAN text as one of C; 0 if it is longer than names and units can be. */
static int copy_words(const char *words, unsigned long length, char copy[MOST_WORDS])
{
    length = without_blanks(words, length);
    if (length >= MOST_WORDS)
        return 0;
    memcpy(copy, words, length);
    copy[length] = '\0';
    return 1;
}

void flfind_(fourlink_results *const *handle, const char *name, int *id, int *istat,
             unsigned long name_length)
{
    char words[MOST_WORDS];
    fourlink_value found;

    *istat = copy_words(name, name_length, words) ? fourlink_results_find(*handle, words, &found)
                                                  : FOURLINK_NO_SUCH_NAME;
    if (*istat == FOURLINK_OK)
        *id = found.handle;
}

void flget_(fourlink_results *const *handle, const int *id, const int *ibrnch, const double *angle,
            double *value, int *istat)
{
    fourlink_value v;

    *istat = fourlink_results_get(*handle, *id, (fourlink_branch)*ibrnch, *angle, &v);
    if (*istat == FOURLINK_OK && v.words)
        *istat = FOURLINK_NO_SUCH_FACT;
    if (*istat == FOURLINK_OK)
        *value = v.value;
}

void flval_(fourlink_results *const *handle, const char *name, const int *ibrnch,
            const double *angle, double *value, int *istat, unsigned long name_length)
{
    int id;

    flfind_(handle, name, &id, istat, name_length);
    if (*istat == FOURLINK_OK)
        flget_(handle, &id, ibrnch, angle, value, istat);
}

void flput_(fourlink_results *const *handle, const int *n, const int *ids, const double *values,
            int *istat, char *msg, unsigned long msg_length)
{
    fourlink_mistake mistake;

    *istat = *n < 0 ? FOURLINK_BAD_NUMBER
                    : fourlink_results_put(*handle, (unsigned long)*n, ids, values, &mistake);
    put_message(*istat, &mistake, msg, msg_length);
}

void flset_(fourlink_results *const *handle, const char *name, const double *value, int *istat,
            char *msg, unsigned long name_length, unsigned long msg_length)
{
    const int one = 1;
    int id = 0;

    flfind_(handle, name, &id, istat, name_length);
    if (*istat == FOURLINK_OK)
        flput_(handle, &one, &id, value, istat, msg, msg_length);
    else
        put_message(*istat, NULL, msg, msg_length);
}

void flsett_(fourlink_results *const *handle, const char *words, int *istat, char *msg,
             unsigned long words_length, unsigned long msg_length)
{
    char copy[MOST_WORDS];
    fourlink_mistake mistake;

    mistake.message[0] = '\0';
    *istat = copy_words(words, words_length, copy)
                 ? fourlink_results_set_text(*handle, copy, &mistake)
                 : FOURLINK_NO_SUCH_NAME;
    if (mistake.message[0] && *istat != FOURLINK_BAD_DECK)
        put_text(mistake.message, msg, msg_length);
    else
        put_message(*istat, &mistake, msg, msg_length);
}

void flunit_(fourlink_results *const *handle, const char *name, char *in_unit, int *istat,
             unsigned long name_length, unsigned long unit_length)
{
    char words[MOST_WORDS];
    fourlink_value input;

    *istat = copy_words(name, name_length, words) ? fourlink_results_input(*handle, words, &input)
                                                  : FOURLINK_NO_SUCH_NAME;
    if (*istat == FOURLINK_OK)
        put_text(input.unit, in_unit, unit_length);
}

void flrow_(fourlink_results *const *handle, const int *ibrnch, const int *i, const int *n,
            double *values, int *istat)
{
    fourlink_branch branch = (fourlink_branch)*ibrnch;
    unsigned long row = (unsigned long)*i - 1;
    flk_opened *o = *handle ? (*handle)->now : NULL;
    int is_short = o && (*n < 0 || (size_t)*n < o->n_columns); /* no room for all columns */
    flk_row here;
    size_t k;

    *istat = *i < 1     ? FOURLINK_NO_SUCH_ROW
             : is_short ? fourlink_results_row(*handle, branch, row, NULL, NULL, NULL)
                        : fourlink_results_row(*handle, branch, row, values, NULL, NULL);
    if (!is_short || *istat >= FOURLINK_NULL)
        return;
    flk_analysis_row(&o->a, o->needs, branch, row, &here);
    for (k = 0; (long)k < *n; k++)
        values[k] = flk_column_value(&o->columns[k], &here);
    *istat = here.at.status;
}
