/* SPDX-License-Identifier: GPL-3.0-or-later
**
** programs.c - random machines whose crank goes by a random program over time.
**
**    programs [N [FIRST]]
**
** Rows are compared with those of the same deck at one instant, with the angle, speed and acceleration of the crank; the
** speed and acceleration themselves with differences of the angle.  Extremes are compared with the best of thousands of
** rows, refined, means with a sum over them.  Decks that fail are left as programs-NUMBER.deck.
*/
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fourlink.h"
#include "random_parts.h"

#define COLUMNS 300
#define ROWS 4000    /* of the dense search */
#define INSTANTS 4   /* of a deck that are compared */
#define AGREES 1e-10 /* of a column's size: a row */
#define SMOOTH 1e-8  /* ... an extreme */
#define SUMMED 2e-5  /* ... a mean; loads jump */

static fourlink_results *results;
static fourlink_problem problem;
static const fourlink_value *columns;
static unsigned long n_columns, theta2;
static fourlink_branch branch;
static int failed;

static long n_decks, n_failed, n_refused, n_rows, n_values, n_extremes, n_unbounded, n_limits,
    n_means;
static double worst_row, worst_rate, worst_extreme, worst_mean;

/* ------------------------------------------------------------------------------------------ decks */

/* A machine that goes by a program, or has one instant of it. */
static void make(const fourlink_crank *crank)
{
    begin_chance(7, n_decks);
    make_machine(n_decks, SPRINGS | FRICTION, PROGRAM);
    write("[table]\ncolumns = all\n");
    if (!crank)
        return;
    deck_text[length] = '\0';
    length = (size_t)(strstr(deck_text, "[motion]") - deck_text);
    write("[table]\ncolumns = all\n[motion]\nat = %.17g rad\nspeed = %.17g rad/s\n", crank->theta2,
          crank->omega2);
    write("acceleration = %.17g rad/s2\nhold = yes\n", crank->alpha2);
}

static fourlink_results *open_deck(void)
{
    fourlink_source source;
    fourlink_mistake mistake;
    fourlink_results *r = NULL;

    memset(&source, 0, sizeof source);
    source.text = deck_text;
    source.length = length;
    if (fourlink_results_open(&source, 1, &r, &mistake, NULL) == FOURLINK_OK)
        return r;
    if (getenv("WHY"))
        printf("%s\n", mistake.message);
    return NULL;
}

static void fail(const char *what, const char *name, double told, double expected, double error)
{
    if (!failed)
        printf("programs-%ld.deck: %s of %s, branch %d: %.15g, not %.15g (%.2g)\n", n_decks, what,
               name, (int)branch, told, expected, error);
    failed = 1;
}

/* ------------------------------------------------------------------------------------------- rows */

static double rows[ROWS + 1][COLUMNS], times[ROWS + 1], size[COLUMNS];
static int is_whole;

static int row_at(double time, double *values, fourlink_instant *now)
{
    return fourlink_results_along(results, branch, time, values, now, NULL);
}

static void take_rows(void)
{
    double first = problem.over.first, last = problem.over.last;
    fourlink_instant now;
    unsigned long c;
    int i;

    memset(size, 0, sizeof size);
    is_whole = 1;
    for (i = 0; i <= ROWS; i++) {
        times[i] = i == ROWS ? last : first + (last - first) * i / ROWS;
        for (c = 0; c < n_columns; c++)
            rows[i][c] = NAN;
        if (row_at(times[i], rows[i], &now) != FOURLINK_OK)
            is_whole = 0;
        for (c = 0; c < n_columns; c++)
            if (fabs(rows[i][c]) < 1e300)
                size[c] = fmax(size[c], fabs(rows[i][c]));
    }
    for (c = 0; c < n_columns; c++) { /* what is rounding error of its quantity */
        double most = 0;
        unsigned long k;

        for (k = 0; k < n_columns; k++)
            if (strcmp(columns[k].quantity, columns[c].quantity) == 0)
                most = fmax(most, size[k]);
        size[c] = fmax(size[c], fmax(1e-6 * most, 1e-9));
    }
}

/* Speed and acceleration by differences over 2e-6 of the motion, unless a point of the program is between. */
static void check_rates(const fourlink_row *row)
{
    double h = 1e-6 * (problem.over.last - problem.over.first), most;
    fourlink_instant low, high;

    if (row_at(row->time - h, NULL, &low) == FOURLINK_NO_SUCH_ANGLE ||
        row_at(row->time + h, NULL, &high) == FOURLINK_NO_SUCH_ANGLE)
        return;
    most = fabs(low.row.crank.alpha2 - high.row.crank.alpha2) > 1e-3 * (1 + fabs(row->crank.alpha2))
               ? 0
               : 1;
    if (most == 0)
        return;
    worst_rate =
        fmax(worst_rate,
             fabs((high.row.crank.theta2 - low.row.crank.theta2) / (2 * h) - row->crank.omega2) /
                 (1 + fabs(row->crank.omega2) + fabs(row->crank.theta2) / h * 1e-9));
    worst_rate =
        fmax(worst_rate,
             fabs((high.row.crank.omega2 - low.row.crank.omega2) / (2 * h) - row->crank.alpha2) /
                 (1 + fabs(row->crank.alpha2) + fabs(row->crank.omega2) / h * 1e-9));
}

/* The same row as one instant of a deck. */
static void check_instant(double time)
{
    fourlink_results *program = results, *r;
    double here[COLUMNS], there;
    fourlink_instant now;
    fourlink_value v;
    unsigned long c;
    int status = row_at(time, here, &now);

    if (status != FOURLINK_OK)
        return;
    if (now.row.crank.omega2 == 0 && problem.has_friction)
        return; /* at rest the way that it is about to turn can be another */
    if (status == FOURLINK_OK)
        check_rates(&now.row);
    make(&now.row.crank);
    r = open_deck();
    if (!r) {
        fail("an instant", "the deck", 0, 0, 1);
        return;
    }
    for (c = 0; c < n_columns && status == FOURLINK_OK; c++) {
        if (strcmp(columns[c].name, "time") == 0 || columns[c].flags & FOURLINK_OF_ROUNDING ||
            fourlink_results_find(r, columns[c].name, &v) != FOURLINK_OK)
            continue;
        if (fourlink_results_value(r, columns[c].name, branch, now.row.crank.theta2 * 180 / PI,
                                   &v) != FOURLINK_OK)
            continue;
        there = fabs(v.value - here[c]);
        if (strcmp(columns[c].quantity, "angle") == 0)
            there = fmin(there, fabs(there - 360));
        if (!(fabs(v.value) < 1e300) || !(fabs(here[c]) < 1e300))
            continue;
        n_values++;
        worst_row = fmax(worst_row, there / size[c]);
        if (there > AGREES * size[c])
            fail("a row", columns[c].name, here[c], v.value, there / size[c]);
    }
    n_rows++;
    fourlink_results_free(r);
    results = program;
}

/* --------------------------------------------------------------------------------------- extremes */

/* The best of the rows, refined by ever closer ones. */
static double best_of(unsigned long c, int sign)
{
    double best = -HUGE_VAL, step, values[COLUMNS], at = 0, middle;
    int i, k;

    for (i = 0; i <= ROWS; i++)
        if (sign * rows[i][c] > best) {
            best = sign * rows[i][c];
            at = times[i];
        }
    for (step = times[1] - times[0], k = 0; k < 12; k++, step /= 4)
        for (i = -4, middle = at; i <= 4; i++) {
            double time = fmin(fmax(middle + i * step / 4, problem.over.first), problem.over.last);

            if (row_at(time, values, NULL) == FOURLINK_OK && sign * values[c] > best) {
                best = sign * values[c];
                at = time;
            }
        }
    return sign * best;
}

/* Columns whose extremes the rows do not tell: angles, which go on over whole turns; rounding error, and shaking forces beside
** a lock, which are the difference of forces without bound, and parts of Ts; lengths of Klein's construction, which jump where the crank
** is square to the line of stroke. */
static int is_left_out(unsigned long c)
{
    const char *name = columns[c].name;

    return (columns[c].flags & (FOURLINK_OF_ROUNDING | FOURLINK_CRANK_ANGLE)) ||
           strcmp(columns[c].quantity, "angle") == 0 || strncmp(name, "klein", 5) == 0 ||
           (problem.has_friction && (strncmp(name, "Fs", 2) == 0 || strcmp(name, "Ms") == 0 ||
                                     strncmp(name, "Ts_", 3) == 0));
}

/* 1 if the row at some passing of the crank angle that is told has the value that is told. */
static int is_there(unsigned long c, const fourlink_value *told)
{
    double low, high, middle, values[COLUMNS];
    fourlink_instant now;
    int i, k;

    for (i = 0; i < n_program_times; i++) /* and just before and behind, where the law is another */
        for (k = -1; k <= 1; k++)
            if (row_at(program_times[i] + k * 1e-13 * (times[ROWS] - times[0]), values, NULL) ==
                    FOURLINK_OK &&
                fabs(values[c] - told->value) <= SMOOTH * size[c])
                return 1;
    for (i = 0; i < ROWS; i++) {
        if ((rows[i][theta2] - told->angle) * (rows[i + 1][theta2] - told->angle) > 0)
            continue;
        low = times[i];
        high = times[i + 1];
        for (k = 0; k < 60; k++) {
            middle = (low + high) / 2;
            row_at(middle, values, &now);
            if ((now.row.angle - told->angle) * (rows[i][theta2] - told->angle) > 0)
                low = middle;
            else
                high = middle;
        }
        for (k = -1; k <= 1; k++) /* at a corner of a law, just inside */
            if (row_at(low + k * 1e-13 * (times[ROWS] - times[0]), values, NULL) == FOURLINK_OK &&
                fabs(values[c] - told->value) <= SMOOTH * size[c])
                return 1;
    }
    return 0;
}

static void check_extremes(void)
{
    char name[100];
    fourlink_value v;
    unsigned long c;
    int sign;

    for (c = 0; c < n_columns; c++)
        for (sign = -1; sign <= 1; sign += 2) {
            double best, error;

            if (is_left_out(c))
                continue;
            snprintf(name, sizeof name, "%s(%s)", sign > 0 ? "max" : "min", columns[c].name);
            if (fourlink_results_value(results, name, branch, 0, &v) != FOURLINK_OK)
                continue;
            if (fabs(v.value) > 1e300) {
                n_unbounded++;
                continue;
            }
            best = best_of(c, sign);
            error = sign * (best - v.value) / size[c];
            n_extremes++;
            if (error < 0 && is_there(c, &v))
                continue; /* the dense search has missed it */
            if (error < 0 && !is_whole) {
                n_limits++; /* beside a range without rows */
                continue;
            }
            worst_extreme = fmax(worst_extreme, fabs(error));
            if (fabs(error) > SMOOTH)
                fail(sign > 0 ? "the largest" : "the smallest", columns[c].name, v.value, best,
                     error);
        }
}

static void check_means(void)
{
    char name[100];
    fourlink_value v;
    unsigned long c;
    int i;

    for (c = 0; c < n_columns && is_whole; c++) {
        double sum = 0;

        if (is_left_out(c))
            continue;
        snprintf(name, sizeof name, "mean(%s)", columns[c].name);
        if (fourlink_results_value(results, name, branch, 0, &v) != FOURLINK_OK ||
            !(fabs(v.value) < 1e300))
            continue;
        for (i = 0; i < ROWS; i++)
            sum += (rows[i][c] + rows[i + 1][c]) / 2;
        sum = fabs(sum / ROWS - v.value) / size[c];
        n_means++;
        worst_mean = fmax(worst_mean, sum);
        if (sum > 100 * SUMMED)
            fail("the mean", columns[c].name, v.value, 0, sum);
    }
}

int main(int argc, char **argv)
{
    long n = argc > 1 ? atol(argv[1]) : 4, first = argc > 2 ? atol(argv[2]) : 0;
    char name[100];
    int i, k;

    for (n_decks = first; n_decks < first + n; n_decks++) {
        failed = 0;
        make(NULL);
        results = open_deck();
        if (!results) {
            n_refused++;
            continue;
        }
        fourlink_deck_problem(fourlink_results_deck(results), &problem);
        fourlink_results_list(results, FOURLINK_COLUMNS, &columns, &n_columns);
        for (theta2 = 0; theta2 + 1 < n_columns && strcmp(columns[theta2].name, "theta2") != 0;
             theta2++)
            ;
        for (i = 0; i < 2 && n_columns <= COLUMNS; i++) {
            branch = i ? FOURLINK_CROSSED : FOURLINK_OPEN;
            take_rows();
            check_extremes();
            check_means();
            for (k = 0; k < INSTANTS; k++)
                check_instant(times[(ROWS * (2 * k + 1)) / (2 * INSTANTS)]);
        }
        fourlink_results_free(results);
        if (failed) {
            n_failed++;
            snprintf(name, sizeof name, "programs-%ld.deck", n_decks);
            make(NULL);
            leave_deck(name);
        }
    }
    printf("%ld decks, %ld refused: %ld rows, %ld values within %.2g of their size, speeds by "
           "differences within %.2g\n",
           n, n_refused, n_rows, n_values, worst_row, worst_rate);
    printf("%ld extremes, %ld more without bound, %ld limits, within %.2g; %ld means within %.2g\n",
           n_extremes, n_unbounded, n_limits, worst_extreme, n_means, worst_mean);
    printf("%ld decks wrong\n", n_failed);
    return n_failed > 0 || n_refused == n;
}
