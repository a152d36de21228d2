/* SPDX-License-Identifier: GPL-3.0-or-later
**
** summary.c - facts to text: --summary, and the columns that a deck has: --list.
*/
#include <float.h>
#include <string.h>

#include "results/fact.h"
#include "base/format.h"
#include "print.h"
#include "table.h"

static void put_summary_line(const fact *f, void *data)
{
    FILE *out = data;
    char value[FORMAT_SIZE], angle[FORMAT_SIZE];

    value[0] = angle[0] = '\0';
    if (!f->words)
        format_general(f->value, 12, value);
    if (f->has_angle)
        format_general(f->theta2, 10, angle);
    fprintf(out, "%-22s %20s %-8s %14s %-8s %s\n", f->name, f->words ? "" : value, f->unit, angle,
            f->branch ? branch_name((fourlink_branch)f->branch) : "",
            f->words ? f->words : f->meaning);
}

void summary_print(FILE *out, analysis *a, const column_list *columns)
{
    print_head(out, a->d);
    fprintf(out, "# %-20s %20s %-8s %10s %-3s %-8s %s\n", "name", "value", "unit", "theta2",
            a->d->units[QUANTITY_ANGLE].name, "branch", "meaning");
    facts_tell(a, 0, 1, columns, put_summary_line, out);
}

void summary_print_csv_header(FILE *out, int with_deck)
{
    fprintf(out, "%sname,value,unit,theta2,branch\r\n", with_deck ? "deck," : "");
}

typedef struct summary_csv {
    FILE *out;
    const char *deck_name;
} summary_csv;

static void put_summary_csv(const fact *f, void *data)
{
    const summary_csv *s = data;
    char number[FORMAT_SIZE];

    if (s->deck_name) {
        print_field(s->out, s->deck_name);
        putc(',', s->out);
    }
    fprintf(s->out, "%s,", f->name);
    print_field(s->out, f->words ? f->words : format_general(f->value + 0.0, DBL_DIG + 2, number));
    fprintf(s->out, ",%s,", f->unit);
    if (f->has_angle)
        fputs(format_general(f->theta2 + 0.0, DBL_DIG + 2, number), s->out);
    fprintf(s->out, ",%s\r\n", f->branch ? branch_name((fourlink_branch)f->branch) : "");
}

void summary_print_csv(FILE *out, analysis *a, const column_list *columns, const char *deck_name)
{
    summary_csv s;

    s.out = out;
    s.deck_name = deck_name;
    facts_tell(a, 0, 1, columns, put_summary_csv, &s);
}

#define LISTED_SIZE 2000

typedef struct lister {
    FILE *out;
    char *listed; /* the names told so far: a fact is listed once for both branches */
} lister;

static void put_listed(const fact *f, void *data)
{
    lister *l = data;
    char name[DECK_NAME_SIZE + 2];

    sprintf(name, " %s ", f->name);
    if (strstr(l->listed, name) || strlen(l->listed) + strlen(name) >= LISTED_SIZE)
        return;
    strcat(l->listed, name);
    fprintf(l->out, "%-18s %-8s %s\n", f->name, f->unit, f->meaning);
}

int list_print(FILE *out, analysis *a)
{
    char listed[LISTED_SIZE];
    const deck *d = a->d;
    column_list all;
    lister l;
    size_t j;

    l.out = out;
    l.listed = listed;
    memset(&all, 0, sizeof all);
    if (!columns_all(d, &all)) {
        columns_free(&all);
        return 0;
    }
    fprintf(out, "%-18s %-8s %-60s %s\n", "column", "unit", "meaning", "in the sources");
    for (j = 0; j < all.count; j++) {
        const column *c = &all.list[j];
        const char *source = column_source_name(c);

        fprintf(out, "%-18s %-8s %-*s%s%s\n", c->name, c->unit, *source ? 60 : 0, column_meaning(c),
                *source ? " " : "", source);
    }
    columns_free(&all);
    fprintf(out, "\n%-18s %-8s %s\n", "fact", "unit", "meaning");
    listed[0] = '\0';
    facts_tell(a, FOURLINK_OPEN, 1, NULL, put_listed, &l);
    fprintf(out, "%-18s %-8s %s\n%-18s %-8s %s\n", "max(COLUMN)", "",
            "greatest value of any column", "min(COLUMN)", "", "least value of any column");
    return 1;
}
