/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table.c - rows to text: the formats table, csv and paper, and the nine equations.
*/
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "compare.h"
#include "extreme.h"
#include "fact.h"
#include "number.h"
#include "table.h"

/* The branches of a deck in the order of printing. */
static int branches_of(const deck *d, fourlink_branch branches[2])
{
    int n = 0;

    if (d->open)
        branches[n++] = FOURLINK_OPEN;
    if (d->crossed)
        branches[n++] = FOURLINK_CROSSED;
    return n;
}

/* An angle of the motion, with no more decimals than it needs. */
static const char *angle_text(double angle, char out[NUMBER_SIZE])
{
    return number_general(angle, 12, out);
}

/* The reason for which a crank stops, "" if it does not. */
static const char *stop_text(const analysis *a, char out[NUMBER_SIZE + 80])
{
    char number[NUMBER_SIZE];

    out[0] = '\0';
    if (a->range.stops) {
        strcpy(out, "the crank comes to rest at ");
        strcat(out, angle_text(a->range.stop_angle, number));
        strcat(out, " ");
        strcat(out, a->d->units[QUANTITY_ANGLE].name);
    }
    return out;
}

/* -------------------- format table -------------------- */

/* How the numbers of a column are written: all alike, so that they stand under each other. */
typedef struct style {
    int decimals;
    int exponent; /* 1: as 1.2e-16 */
    size_t width;
} style;

#define SAMPLES 200

/* The largest magnitude of each column, over rows spread evenly over the motion; 0 for what is no
** more than the rounding of other columns of the same quantity. */
static void find_sizes(analysis *a, const column_list *columns, double *size)
{
    unsigned long n_rows = a->range.n_rows, samples = n_rows < SAMPLES ? n_rows : SAMPLES, k;
    double of_quantity[QUANTITY_COUNT] = {0};
    fourlink_branch branches[2];
    int n = branches_of(a->d, branches), i;
    result r;
    size_t j;

    for (j = 0; j < columns->count; j++)
        size[j] = 0;
    for (i = 0; i < n; i++)
        for (k = 0; k < samples; k++) {
            double share = samples > 1 ? (double)k / (double)(samples - 1) : 0;

            analysis_row(a, branches[i], (unsigned long)(share * (double)(n_rows - 1) + 0.5), &r);
            for (j = 0; j < columns->count; j++)
                if (r.status == FOURLINK_OK || column_of_crank(&columns->list[j])) {
                    double x = fabs(column_value(&columns->list[j], &r));

                    size[j] = x > size[j] ? x : size[j];
                }
        }
    for (j = 0; j < columns->count; j++) {
        quantity q = column_quantity(&columns->list[j]);

        of_quantity[q] = size[j] > of_quantity[q] ? size[j] : of_quantity[q];
    }
    for (j = 0; j < columns->count; j++)
        if (size[j] <= 1e-12 * of_quantity[column_quantity(&columns->list[j])])
            size[j] = 0;
}

/* The decimals that write a multiple of the interval exactly, if these are few. */
static int decimals_of_angle(const deck *d, int otherwise)
{
    double step = 1;
    int decimals;

    for (decimals = 0; decimals < otherwise; decimals++, step *= 10) {
        double a = d->motion.from * step, b = d->motion.to * step, c = d->motion.interval * step;

        if (fabs(a - floor(a + 0.5)) < 1e-9 && fabs(b - floor(b + 0.5)) < 1e-9 &&
            fabs(c - floor(c + 0.5)) < 1e-9)
            return decimals;
    }
    return otherwise;
}

static void find_style(const deck *d, const column *c, double size, style *s)
{
    char number[NUMBER_SIZE];
    size_t width;

    s->exponent = size > 0 && (size < 1e-6 || size >= 1e9);
    s->decimals = d->digits - 1;
    if (column_of_rounding(c)) {
        s->exponent = 1;
        s->decimals = 1;
    } else if (!s->exponent && size > 0) {
        s->decimals -= (int)floor(log10(size));
        if (s->decimals < 0)
            s->decimals = 0;
        if (column_of_crank(c) && column_quantity(c) == QUANTITY_ANGLE)
            s->decimals = decimals_of_angle(d, s->decimals);
    }
    if (s->exponent)
        width = strlen(number_exponent(-1, s->decimals, number));
    else
        width = strlen(number_fixed(-size, s->decimals, number));
    if (strlen(c->name) > width)
        width = strlen(c->name);
    if (strlen(c->unit) > width)
        width = strlen(c->unit);
    s->width = width + 2;
}

/* A number that is 0 to the decimals printed carries no sign. */
static const char *cell_text(double x, const style *s, char out[NUMBER_SIZE])
{
    if (s->exponent)
        number_exponent(x + 0.0, s->decimals, out); /* -0 + 0 is 0 */
    else
        number_fixed(x, s->decimals, out);
    return out[0] == '-' && strspn(out, "-0.") == strlen(out) ? out + 1 : out;
}

/* A dead position is flagged before it is reached: within a degree of it, errors of the data grow more
** than 57 times. */
static const char near_dead_text[] =
    "near a dead position: the transmission angle is less than 1 deg";

static int near_dead_position(const result *r)
{
    return r->status == FOURLINK_OK && r->state.mu < M_PI / 180;
}

static void put_right(FILE *out, const char *s, size_t width)
{
    size_t n = strlen(s);

    if (n >= width)
        putc(' ', out); /* wider than foreseen: still a field of its own */
    for (; n < width; n++)
        putc(' ', out);
    fputs(s, out);
}

static void put_length(FILE *out, const deck *d, const char *name, double length)
{
    const deck_unit *u = &d->units[QUANTITY_LENGTH];
    char number[NUMBER_SIZE];

    fprintf(out, "%s %s %s", name, number_general(length * u->unit.down / u->unit.up, 12, number),
            u->name);
}

static void put_head(FILE *out, const deck *d)
{
    const fourlink_design *design = &d->design;

    if (d->title[0])
        fprintf(out, "# %s\n", d->title);
    if (design->kind == FOURLINK_FOUR_BAR) {
        put_length(out, d, "# four-bar linkage: crank", design->link[2].length);
        put_length(out, d, ", coupler", design->link[3].length);
        put_length(out, d, ", rocker", design->link[4].length);
        put_length(out, d, ", ground", design->link[1].length);
    } else {
        put_length(out, d, "# slider-crank: crank", design->link[2].length);
        put_length(out, d, ", rod", design->link[3].length);
        if (design->offset != 0)
            put_length(out, d, ", offset", design->offset);
    }
    putc('\n', out);
}

/* Names or units of the columns, as a comment above them. */
static void put_names(FILE *out, const column_list *columns, const style *styles, int units)
{
    size_t j;

    putc('#', out);
    for (j = 0; j < columns->count; j++)
        put_right(out, units ? columns->list[j].unit : columns->list[j].name,
                  styles[j].width - (j == 0));
    putc('\n', out);
}

/* A fact in the head of the table. */
static void put_fact(const fact *f, void *data)
{
    FILE *out = data;
    char number[NUMBER_SIZE];

    fprintf(out, "# %s", f->name);
    if (f->branch)
        fprintf(out, " (%s)", branch_name((fourlink_branch)f->branch));
    if (f->words)
        fprintf(out, ": %s\n", f->words);
    else
        fprintf(out, ": %s%s%s", number_general(f->value, 9, number),
                strcmp(f->unit, "1") ? " " : "", strcmp(f->unit, "1") ? f->unit : "");
    if (!f->words && f->has_angle)
        fprintf(out, " at theta2 = %s", number_general(f->theta2, 9, number));
    if (!f->words)
        putc('\n', out);
}

/* The extremes of the columns and where they are, as comments above the rows. */
static void put_extremes(FILE *out, analysis *a, const column_list *columns, const style *styles,
                         fourlink_branch branch)
{
    static const style angle = {3, 0, 0};
    char number[NUMBER_SIZE];
    int line;
    size_t j;

    for (line = 0; line < 4; line++) {
        putc('#', out);
        for (j = 0; j < columns->count; j++) {
            const char *cell = "";
            extreme e;

            if (!column_of_crank(&columns->list[j]) &&
                extreme_find(a, &columns->list[j], branch, line < 2 ? 1 : -1, &e))
                cell = line % 2 == 0 ? cell_text(e.value, &styles[j], number)
                                     : cell_text(e.angle, &angle, number);
            put_right(out, cell, styles[j].width - (j == 0));
        }
        fprintf(out, "  %s\n", line % 2 ? "at theta2" : line == 0 ? "max" : "min");
    }
}

static void put_row(FILE *out, const deck *d, const column_list *columns, const style *styles,
                    const result *r)
{
    char number[NUMBER_SIZE];
    size_t j;

    if (r->status != FOURLINK_OK) {
        fprintf(out, "# theta2 = %s %s: %s\n", angle_text(r->row.angle, number),
                d->units[QUANTITY_ANGLE].name, fourlink_status_text(r->status));
        return;
    }
    for (j = 0; j < columns->count; j++)
        put_right(out, cell_text(column_value(&columns->list[j], r), &styles[j], number),
                  styles[j].width);
    putc('\n', out);
    if (near_dead_position(r))
        fprintf(out, "# theta2 = %s %s: %s\n", angle_text(r->row.angle, number),
                d->units[QUANTITY_ANGLE].name, near_dead_text);
}

static unsigned long print_branch(FILE *out, analysis *a, const column_list *columns,
                                  const style *styles, fourlink_branch branch)
{
    unsigned long k, failed = 0;
    char stop[NUMBER_SIZE + 80];
    result r;

    fprintf(out, "# branch: %s\n", branch_name(branch));
    put_names(out, columns, styles, 0);
    put_names(out, columns, styles, 1);
    if (a->range.n_rows > 1)
        put_extremes(out, a, columns, styles, branch);
    for (k = 0; k < a->range.n_rows; k++) {
        analysis_row(a, branch, k, &r);
        put_row(out, a->d, columns, styles, &r);
        failed += r.status != FOURLINK_OK;
    }
    if (a->range.stops) {
        fprintf(out, "# %s\n", stop_text(a, stop));
        failed++;
    }
    return failed;
}

int table_print(FILE *out, analysis *a, const column_list *columns, unsigned long *failed)
{
    style *styles = malloc(columns->count * sizeof *styles);
    double *size = malloc(columns->count * sizeof *size);
    fourlink_branch branches[2];
    int n = branches_of(a->d, branches), i;
    size_t j;

    if (styles && size) {
        find_sizes(a, columns, size);
        for (j = 0; j < columns->count; j++)
            find_style(a->d, &columns->list[j], size[j], &styles[j]);
        put_head(out, a->d);
        facts_tell(a, 0, NULL, put_fact, out);
        for (i = 0; i < n; i++) {
            if (i > 0)
                fputs("\n\n", out);
            *failed += print_branch(out, a, columns, styles, branches[i]);
        }
    }
    free(styles);
    free(size);
    return styles && size;
}

/* -------------------- format csv -------------------- */

/* RFC 4180: fields with a comma, a quote or the end of a line in them stand in quotes, and quotes
** in them are doubled. */
static void put_field(FILE *out, const char *s)
{
    if (!strpbrk(s, ",\"\r\n")) {
        fputs(s, out);
        return;
    }
    putc('"', out);
    for (; *s; s++) {
        if (*s == '"')
            putc('"', out);
        putc(*s, out);
    }
    putc('"', out);
}

void csv_print_header(FILE *out, const column_list *header, int with_deck)
{
    char field[2 * DECK_NAME_SIZE];
    size_t j;

    if (with_deck)
        fputs("deck,", out);
    fputs("branch", out);
    for (j = 0; j < header->count; j++) {
        sprintf(field, "%.60s (%.60s)", header->list[j].name, header->list[j].unit);
        putc(',', out);
        put_field(out, field);
    }
    fputs(",status\r\n", out);
}

/* For each column of the header, the deck's column that it is; null if it has none. */
static const column **map_columns(const column_list *columns, const column_list *header)
{
    const column **map = malloc((header->count + 1) * sizeof *map);
    size_t i, j;

    for (j = 0; map && j < header->count; j++) {
        map[j] = NULL;
        for (i = 0; i < columns->count; i++)
            if (columns_are_same(&header->list[j], &columns->list[i]))
                map[j] = &columns->list[i];
    }
    return map;
}

/* r null: a line with nothing but a reason in it. */
static void put_csv_row(FILE *out, const column **map, size_t n, const char *deck_name,
                        fourlink_branch branch, const result *r, const char *status)
{
    char number[NUMBER_SIZE];
    size_t j;

    if (deck_name) {
        put_field(out, deck_name);
        putc(',', out);
    }
    fputs(branch_name(branch), out);
    for (j = 0; j < n; j++) {
        putc(',', out);
        if (map[j] && r && (r->status == FOURLINK_OK || column_of_crank(map[j])))
            fputs(number_general(column_value(map[j], r) + 0.0, DBL_DIG + 2, number), out);
    }
    putc(',', out);
    put_field(out, status);
    fputs("\r\n", out);
}

int csv_print(FILE *out, analysis *a, const column_list *columns, const column_list *header,
              const char *deck_name, unsigned long *failed)
{
    const column **map = map_columns(columns, header);
    fourlink_branch branches[2];
    int n = branches_of(a->d, branches), i;
    unsigned long k;
    char stop[NUMBER_SIZE + 80];
    result r;

    for (i = 0; map && i < n; i++) {
        for (k = 0; k < a->range.n_rows; k++) {
            analysis_row(a, branches[i], k, &r);
            put_csv_row(out, map, header->count, deck_name, branches[i], &r,
                        near_dead_position(&r) ? near_dead_text : fourlink_status_text(r.status));
            *failed += r.status != FOURLINK_OK;
        }
        if (a->range.stops) {
            put_csv_row(out, map, header->count, deck_name, branches[i], NULL, stop_text(a, stop));
            ++*failed;
        }
    }
    free((void *)map);
    return map != NULL;
}

/* -------------------- format paper -------------------- */

/* -0.00 is printed as 0.00 */
static double no_minus_zero(double x)
{
    return fabs(x) < 0.005 ? 0 : x;
}

/* The printout of Alvi, section 5.1: the crossed branch first at every angle, without the closing
** 360 deg.  Its numbers have two decimals; the crank's angle and speed no more than they need. */
static void put_paper_row(FILE *out, const result *r)
{
    const fourlink_state *s = &r->state;
    double degrees = r->row.crank.theta2 * 180 / M_PI, whole = floor(degrees + 0.5);

    if (fabs(degrees - whole) < 1e-9)
        fprintf(out, "%02.0f", whole);
    else
        fprintf(out, "%.2f", degrees);
    fprintf(out, "\t%.4g\t%.2f\t%.2f\t%.2f\t%.2f\t%.2f\t%.2f\t%.2f\n", r->row.crank.omega2,
            no_minus_zero(r->row.crank.alpha2), no_minus_zero(s->link[4].theta * 180 / M_PI),
            no_minus_zero(s->link[3].theta * 180 / M_PI), no_minus_zero(s->link[4].omega),
            no_minus_zero(s->link[3].omega), no_minus_zero(s->link[4].alpha),
            no_minus_zero(s->link[3].alpha));
}

unsigned long table_print_paper(FILE *out, analysis *a)
{
    const deck *d = a->d;
    unsigned long k, n_rows = a->range.n_rows, failed = 0;
    char number[NUMBER_SIZE + 80];
    result r;
    int i;

    if (d->one_revolution && !a->range.stops && n_rows > 1)
        n_rows--;
    fputs("thet\tVela\tacca\tphi\tbeta\tvelc\tvelb\tAccc\tAccb\n", out);
    for (k = 0; k < n_rows; k++)
        for (i = 0; i < 2; i++) {
            fourlink_branch branch = i == 0 ? FOURLINK_CROSSED : FOURLINK_OPEN;

            if (branch == FOURLINK_OPEN ? !d->open : !d->crossed)
                continue;
            analysis_row(a, branch, k, &r);
            if (r.status == FOURLINK_OK)
                put_paper_row(out, &r);
            else
                fprintf(out, "# %s %s, %s: %s\n", angle_text(r.row.angle, number),
                        d->units[QUANTITY_ANGLE].name, branch_name(branch),
                        fourlink_status_text(r.status));
            failed += r.status != FOURLINK_OK;
        }
    if (a->range.stops) {
        fprintf(out, "# %s\n", stop_text(a, number));
        failed++;
    }
    return failed;
}

/* -------------------- the nine equations -------------------- */

static void put_equation(FILE *out, const double A[9], double x, double b)
{
    char number[NUMBER_SIZE];
    int j;

    for (j = 0; j < 9; j++)
        put_right(out, number_general(A[j] + 0.0, 6, number), 13);
    put_right(out, number_general(x, 9, number), 17);
    put_right(out, number_general(b, 9, number), 17);
    putc('\n', out);
}

static void put_system(FILE *out, const analysis *a, const result *r)
{
    const deck *d = a->d;
    const fourlink_forces *f = &r->forces;
    int slider_crank = d->design.kind == FOURLINK_SLIDER_CRANK, i;
    double A[9][9], b[9], x[9];
    char number[NUMBER_SIZE];

    fourlink_system(&d->mechanism, &r->state, a->loads, a->n_loads, A, b);
    x[0] = f->F12x;
    x[1] = f->F12y;
    x[2] = f->F23x;
    x[3] = f->F23y;
    x[4] = f->F34x;
    x[5] = f->F34y;
    x[6] = slider_crank ? f->M14 : f->F14x;
    x[7] = f->F14y;
    x[8] = f->Ts;
    fprintf(out, "# theta2 = %s %s, branch: %s\n", angle_text(r->row.angle, number),
            d->units[QUANTITY_ANGLE].name, branch_name(r->branch));
    fprintf(out, "# %11s%13s%13s%13s%13s%13s%13s%13s%13s%17s%17s\n", "F12x", "F12y", "F23x", "F23y",
            "F34x", "F34y", slider_crank ? "M14" : "F14x", slider_crank ? "N" : "F14y", "Ts", "x",
            "b");
    for (i = 0; i < 9; i++)
        put_equation(out, A[i], x[i], b[i]);
}

unsigned long table_print_matrix(FILE *out, analysis *a)
{
    const deck *d = a->d;
    fourlink_branch branches[2];
    int n = branches_of(d, branches), i, blocks = 0;
    unsigned long k, failed = 0;
    char stop[NUMBER_SIZE + 80], number[NUMBER_SIZE];
    result r;

    put_head(out, d);
    fputs("# A x = b in SI units: the columns of A under their unknowns, the solution x, the right "
          "side "
          "b.\n# Rows: forces along x, along y, moments about the centre of mass, of links 2, 3, "
          "4.\n",
          out);
    for (i = 0; i < n; i++) {
        for (k = 0; k < a->range.n_rows; k++) {
            analysis_row(a, branches[i], k, &r);
            if (blocks++)
                fputs("\n\n", out);
            if (r.status == FOURLINK_OK) {
                put_system(out, a, &r);
                continue;
            }
            failed++;
            fprintf(out, "# theta2 = %s %s, branch: %s: %s\n", angle_text(r.row.angle, number),
                    d->units[QUANTITY_ANGLE].name, branch_name(branches[i]),
                    fourlink_status_text(r.status));
        }
        if (a->range.stops) {
            fprintf(out, "# %s\n", stop_text(a, stop));
            failed++;
        }
    }
    return failed;
}

/* -------------------- --summary -------------------- */

static void put_summary_line(const fact *f, void *data)
{
    FILE *out = data;
    char value[NUMBER_SIZE], angle[NUMBER_SIZE];

    value[0] = angle[0] = '\0';
    if (!f->words)
        number_general(f->value, 12, value);
    if (f->has_angle)
        number_general(f->theta2, 10, angle);
    fprintf(out, "%-22s %20s %-8s %14s %-8s %s\n", f->name, f->words ? "" : value, f->unit, angle,
            f->branch ? branch_name((fourlink_branch)f->branch) : "",
            f->words ? f->words : f->meaning);
}

void summary_print(FILE *out, analysis *a, const column_list *columns)
{
    put_head(out, a->d);
    fprintf(out, "# %-20s %20s %-8s %10s %-3s %-8s %s\n", "name", "value", "unit", "theta2",
            a->d->units[QUANTITY_ANGLE].name, "branch", "meaning");
    facts_tell(a, 1, columns, put_summary_line, out);
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
    char number[NUMBER_SIZE];

    if (s->deck_name) {
        put_field(s->out, s->deck_name);
        putc(',', s->out);
    }
    fprintf(s->out, "%s,", f->name);
    put_field(s->out, f->words ? f->words : number_general(f->value + 0.0, DBL_DIG + 2, number));
    fprintf(s->out, ",%s,", f->unit);
    if (f->has_angle)
        fputs(number_general(f->theta2 + 0.0, DBL_DIG + 2, number), s->out);
    fprintf(s->out, ",%s\r\n", f->branch ? branch_name((fourlink_branch)f->branch) : "");
}

void summary_print_csv(FILE *out, analysis *a, const column_list *columns, const char *deck_name)
{
    summary_csv s;

    s.out = out;
    s.deck_name = deck_name;
    facts_tell(a, 1, columns, put_summary_csv, &s);
}

/* -------------------- --check -------------------- */

static const char *const check_words[] = {"ok", "differs", "misprint confirmed", "not a misprint"};

typedef struct check_printer {
    FILE *out;
    const deck *d;
    const char *deck_name; /* csv: null, no column of that name */
    unsigned long n[4];
} check_printer;

static void put_check(const check *c, void *data)
{
    check_printer *p = data;
    char name[DECK_NAME_SIZE], number[NUMBER_SIZE], value[DECK_NAME_SIZE];

    p->n[c->result]++;
    fprintf(p->out, "%-18s %s:%ld: %s = %s", check_words[c->result], c->e->place.source,
            c->e->place.line, text_copy(c->e->name, name, sizeof name),
            text_copy(c->e->value, value, sizeof value));
    if (c->words[0])
        fprintf(p->out, ", computed %s", c->words);
    else
        fprintf(p->out, ", computed %s %s", number_general(c->computed, 9, number), c->unit);
    if (c->at_angle)
        fprintf(p->out, " at %s %s", number_general(c->e->at, 9, number),
                p->d->units[QUANTITY_ANGLE].name);
    fprintf(p->out, ", %s\n", branch_name(c->e->branch));
}

void check_print_csv_header(FILE *out, int with_deck)
{
    fprintf(out, "%sfile,line,result,name,theta2,branch,unit,printed,computed,tolerance\r\n",
            with_deck ? "deck," : "");
}

static void put_check_csv(const check *c, void *data)
{
    check_printer *p = data;
    char name[DECK_NAME_SIZE], number[NUMBER_SIZE], value[DECK_NAME_SIZE];

    p->n[c->result]++;
    if (p->deck_name) {
        put_field(p->out, p->deck_name);
        putc(',', p->out);
    }
    put_field(p->out, c->e->place.source);
    fprintf(p->out, ",%ld,%s,", c->e->place.line, check_words[c->result]);
    put_field(p->out, text_copy(c->e->name, name, sizeof name));
    fprintf(p->out, ",%s,%s,%s,", c->at_angle ? number_general(c->e->at, DBL_DIG + 2, number) : "",
            branch_name(c->e->branch), c->unit);
    put_field(p->out, text_copy(c->e->value, value, sizeof value));
    putc(',', p->out);
    put_field(p->out, c->words[0] ? c->words : number_general(c->computed, DBL_DIG + 2, number));
    fprintf(p->out, ",%s\r\n",
            c->words[0] ? "" : number_general(c->tolerance, DBL_DIG + 2, number));
}

int check_print(FILE *out, deck *d, int csv, const char *deck_name)
{
    check_printer p;
    int status;

    memset(&p, 0, sizeof p);
    p.out = out;
    p.d = d;
    p.deck_name = deck_name;
    status = checks_run(d, csv ? put_check_csv : put_check, &p);
    if (status != 1)
        return status == 0 ? CHECK_PRINT_MISTAKES : CHECK_PRINT_MEMORY;
    if (!csv)
        fprintf(out, "# ok: %lu, misprint confirmed: %lu, differs: %lu, not a misprint: %lu\n",
                p.n[CHECK_OK], p.n[CHECK_MISPRINT], p.n[CHECK_DIFFERS], p.n[CHECK_NO_MISPRINT]);
    return p.n[CHECK_DIFFERS] + p.n[CHECK_NO_MISPRINT] ? CHECK_PRINT_DIFFERENCES : CHECK_PRINT_OK;
}

/* -------------------- --list -------------------- */

int table_print_list(FILE *out, const deck *d)
{
    column_list all;
    size_t j;

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
    return 1;
}
