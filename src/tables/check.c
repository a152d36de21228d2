/* SPDX-License-Identifier: GPL-3.0-or-later
**
** check.c - printed values against computed ones, to text: --check.
*/
#include <float.h>
#include <string.h>

#include "results/expected.h"
#include "base/format.h"
#include "print.h"
#include "table.h"

static const char *const check_words[] = {"ok", "differs", "misprint confirmed", "not a misprint",
                                          "no value"};

typedef struct grader {
    FILE *out;
    const deck *d;
    const char *deck_name; /* csv: null, no column of that name */
    unsigned long n[5];
} grader;

static void put_check(const check *c, void *data)
{
    grader *p = data;
    char name[DECK_NAME_SIZE], number[FORMAT_SIZE], value[DECK_NAME_SIZE];

    p->n[c->result]++;
    fprintf(p->out, "%-18s %s:%ld: %s = %s", check_words[c->result], c->e->place.source,
            c->e->place.line, flk_text_copy(c->e->name, name, sizeof name),
            flk_text_copy(c->e->value, value, sizeof value));
    if (c->words[0])
        fprintf(p->out, ", computed %s", c->words);
    else if (c->result != CHECK_NO_VALUE)
        fprintf(p->out, ", computed %s%s%s", format_general(c->computed, 12, number),
                strcmp(c->unit, "1") == 0 ? "" : " ", strcmp(c->unit, "1") == 0 ? "" : c->unit);
    if (c->at_angle)
        fprintf(p->out, " at %s %s", format_general(c->e->at, 9, number),
                p->d->units[QUANTITY_ANGLE].name);
    fprintf(p->out, ", %s\n", branch_name(c->e->branch));
}

void grade_print_csv_header(FILE *out, int with_deck)
{
    fprintf(out, "%sfile,line,result,name,theta2,branch,unit,printed,computed,tolerance\r\n",
            with_deck ? "deck," : "");
}

static void put_check_csv(const check *c, void *data)
{
    grader *p = data;
    char name[DECK_NAME_SIZE], number[FORMAT_SIZE], value[DECK_NAME_SIZE];

    p->n[c->result]++;
    if (p->deck_name) {
        print_field(p->out, p->deck_name);
        putc(',', p->out);
    }
    print_field(p->out, c->e->place.source);
    fprintf(p->out, ",%ld,%s,", c->e->place.line, check_words[c->result]);
    print_field(p->out, flk_text_copy(c->e->name, name, sizeof name));
    fprintf(p->out, ",%s,%s,%s,", c->at_angle ? format_general(c->e->at, DBL_DIG + 2, number) : "",
            branch_name(c->e->branch), c->unit);
    print_field(p->out, flk_text_copy(c->e->value, value, sizeof value));
    putc(',', p->out);
    if (c->words[0])
        print_field(p->out, c->words);
    else if (c->result != CHECK_NO_VALUE)
        fputs(format_general(c->computed, DBL_DIG + 2, number), p->out);
    putc(',', p->out);
    if (!c->words[0] && c->result != CHECK_NO_VALUE)
        fputs(format_general(c->tolerance, DBL_DIG + 2, number), p->out);
    fputs("\r\n", p->out);
}

int grade_print(FILE *out, deck *d, int csv, const char *deck_name)
{
    grader p;
    int status;

    memset(&p, 0, sizeof p);
    p.out = out;
    p.d = d;
    p.deck_name = deck_name;
    status = checks_run(d, csv ? put_check_csv : put_check, &p);
    if (status < 0)
        return GRADE_MEMORY;
    if (!csv)
        fprintf(out,
                "# ok: %lu, misprint confirmed: %lu, differs: %lu, not a misprint: %lu, no value: "
                "%lu\n",
                p.n[CHECK_OK], p.n[CHECK_MISPRINT], p.n[CHECK_DIFFERS], p.n[CHECK_NO_MISPRINT],
                p.n[CHECK_NO_VALUE]);
    if (status == 0)
        return GRADE_MISTAKES;
    return p.n[CHECK_DIFFERS] + p.n[CHECK_NO_MISPRINT] ? GRADE_DIFFERENCES : GRADE_OK;
}

void grade_print_csv_bad_deck(FILE *out, const char *deck_name)
{
    print_field(out, deck_name);
    fputs(",,,bad deck,,,,,,,\r\n", out);
}
