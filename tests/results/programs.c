/* SPDX-License-Identifier: GPL-3.0-or-later
**
** programs.c - random machines whose crank, or another input, goes by a random program over time.
**
**    programs [inputs|rows|searched|searched-rows] [N [FIRST]]
**
** With `inputs` another coordinate than the crank goes by the program; with `rows` too, and only rows are compared.  With
** `searched` and `searched-rows` it is an output, or an actuator between any links.
** Rows are compared with those of the same deck at one instant, with the angle, speed and acceleration of the crank; the
** speed and acceleration themselves with differences of the angle, those of an input with differences of the input too.  Extremes are compared with the best of thousands of
** rows, refined, means with a sum over them.  Decks that fail are left as programs-NUMBER.deck.
*/
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fourlink.h"
#include "input_programs.h"

#define COLUMNS 300
#define ROWS 4000    /* of the dense search */
#define INSTANTS 4   /* of a deck that are compared */
#define AGREES 1e-10 /* of a column's size: a row */
#define SMOOTH 1e-8  /* ... an extreme; */
#define AT_DEAD 1e-6 /* ... of an input that goes to its dead centre */
#define SUMMED 2e-5  /* ... a mean; loads jump */
#define NARROW 1e-3  /* m or rad, of an output: a range too narrow for its rows, or too far away, */
#define FAR 20       /* ... m, on its way beyond all bounds */

static fourlink_results *results;
static fourlink_problem problem;
static const fourlink_value *columns;
static unsigned long n_columns, theta2;
static fourlink_branch branch;
static int failed, is_of_inputs, is_of_rows;

static long n_differences, n_dead;
static double worst_input[2];
static long n_decks, n_failed, n_refused, n_rows, n_values, n_extremes, n_unbounded, n_limits,
    n_means;
static double worst_row, worst_rate, worst_extreme, worst_mean;

/* ------------------------------------------------------------------------------------------ decks */

static void write_crank(const fourlink_crank *crank)
{
    write("at = %.17g rad\nspeed = %.17g rad/s\n", crank->theta2, crank->omega2);
    write("acceleration = %.17g rad/s2\nhold = yes\n", crank->alpha2);
}

static fourlink_results *open_deck(void);

/* The same of an input; 0 if its range is not known. */
static int make_of_input(const fourlink_crank *crank)
{
    fourlink_problem p;
    fourlink_results *r;
    size_t machine_alone;

    begin_chance(11, n_decks);
    make_input_machine(n_decks);
    machine_alone = length;
    if (crank) {
        write_crank(crank);
        return 1;
    }
    for (input_near = NAN;; input_near = input_near == input_near ? input_near + 30 : 15) {
        write_input_range();
        r = open_deck();
        length = machine_alone;
        if (r)
            break;
        if (input_near > 345)
            return 0;
    }
    fourlink_deck_problem(fourlink_results_deck(r), &p);
    input_from = fmin(p.over.first, p.over.last);
    input_to = fmax(p.over.first, p.over.last);
    fourlink_results_free(r);
    if (is_searched && !(input_to - input_from > NARROW && fabs(input_from) + fabs(input_to) < FAR))
        return 0;
    write_input_program();
    return 1;
}

/* A machine that goes by a program, or has one instant of it. */
static int make(const fourlink_crank *crank)
{
    if (is_of_inputs)
        return make_of_input(crank);
    begin_chance(7, n_decks);
    make_machine(n_decks, SPRINGS | FRICTION, PROGRAM);
    write("[table]\ncolumns = all\n");
    if (!crank)
        return 1;
    deck_text[length] = '\0';
    length = (size_t)(strstr(deck_text, "[motion]") - deck_text);
    write("[table]\ncolumns = all\n[motion]\n");
    write_crank(crank);
    return 1;
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

static unsigned long column_of(const char *name)
{
    unsigned long c = 0;

    while (c + 1 < n_columns && strcmp(columns[c].name, name) != 0)
        c++;
    return c;
}

/* How many times as far from what it is the crank may be than the input, of its length or of a rad. */
static double doubt_of(const double *here, double omega2)
{
    double rate = here[column_of(input->rate)], value = here[column_of(input->value)];
    double scale = input->unit[0] == 'm' ? problem.mechanism.design.link[2].length : 1, near;

    if (omega2 != 0)
        near = fabs(scale * omega2 / rate);
    else if (input->value != input->name)
        near = 1e3; /* at rest it is not known */
    else
        near =
            sqrt((input_to - input_from) / fmin(fabs(value - input_from), fabs(value - input_to)));
    return near < 1e4 ? 20 * fmax(1, near * near) : HUGE_VAL;
}

#define NEAR 2e6 /* of doubt: nearer to a dead centre of the input a row is noise */

/* A row of the dense search. */
static int dense_at(double time, double *values)
{
    fourlink_instant now;
    int status = row_at(time, values, &now);
    unsigned long c;

    if (status != FOURLINK_OK || !is_of_inputs || !(doubt_of(values, now.row.crank.omega2) > NEAR))
        return status;
    for (c = 0; c < n_columns; c++)
        values[c] = NAN;
    return FOURLINK_INPUT_DEAD_CENTRE;
}

static void take_rows(void)
{
    double first = problem.over.first, last = problem.over.last;
    unsigned long c;
    int i;

    memset(size, 0, sizeof size);
    is_whole = 1;
    for (i = 0; i <= ROWS; i++) {
        times[i] = i == ROWS ? last : first + (last - first) * i / ROWS;
        for (c = 0; c < n_columns; c++)
            rows[i][c] = NAN;
        if (dense_at(times[i], rows[i]) != FOURLINK_OK)
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

/* Speed and acceleration of the input by differences of itself. */
static void check_input_rates(double time, const double *here)
{
    double h = 1e-6 * (problem.over.last - problem.over.first), low[COLUMNS], high[COLUMNS], error;
    unsigned long q[3];
    int i;

    q[0] = column_of(input->value);
    q[1] = column_of(input->rate);
    q[2] = column_of(input->second);
    if (row_at(time - h, low, NULL) != FOURLINK_OK || row_at(time + h, high, NULL) != FOURLINK_OK)
        return;
    for (i = 0; i < 2; i++) {
        double way = high[q[i]] - low[q[i]], degrees = PI / 180;

        if (strcmp(columns[q[i]].quantity, "angle") == 0)
            way = (way - 360 * floor(way / 360 + 0.5)) * degrees;
        if (fabs(high[q[2]] - low[q[2]]) > 1e-3 * size[q[2]])
            continue; /* a point of the program is between */
        error = fabs(way / (2 * h) - here[q[i + 1]]) / size[q[i + 1]];
        n_differences++;
        worst_input[i] = fmax(worst_input[i], error);
        if (error > 1e-5)
            fail(i ? "the acceleration" : "the speed", input->name, here[q[i + 1]], way / (2 * h),
                 error);
    }
}

/* 1 for the direction of a force that is rounding error, and where the acceleration of the input is 0, which is rounding error
** in the other deck, for what has no direction or place then. */
static int is_rounded(unsigned long c, const double *here)
{
    const char *name = columns[c].name;
    char force[100];
    size_t n = strlen(name);
    unsigned long of;

    if (strncmp(name, "klein", 5) == 0 || (name[0] == 'h' && here[column_of(input->second)] == 0))
        return 1;
    if (is_searched && strcmp(name, "h4") == 0 &&
        fabs(here[column_of("alpha4")]) < 1e-9 * size[column_of("alpha4")])
        return 1; /* of a rocker that stands still */
    if (n < 5 || n > sizeof force || strcmp(name + n - 4, "_dir") != 0)
        return 0;
    memcpy(force, name, n - 4);
    force[n - 4] = '\0';
    of = column_of(force);
    return fabs(here[of]) < 1e-9 * size[of];
}

/* The same row as one instant of a deck. */
static void check_instant(double time)
{
    fourlink_results *program = results, *r;
    double here[COLUMNS], there, doubt = 1;
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
    if (is_of_inputs) {
        check_input_rates(time, here);
        doubt = doubt_of(here, now.row.crank.omega2);
        if (is_searched && now.state.last > FOURLINK_FOLLOWER) /* beside its dead positions */
            doubt /= now.state.group_sine * now.state.group_sine;
        n_dead += doubt > 1e9;
        if (doubt > 1e9)
            return;
    }
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
        if (is_of_inputs && is_rounded(c, here))
            continue;
        n_values++;
        if (is_of_inputs && strstr(columns[c].quantity, "acceleration"))
            there -= 1e-12 * (1 + pow(now.row.crank.omega2,
                                      2)); /* one that is 0 here is rounding error there */
        worst_row = fmax(worst_row, there / size[c] / doubt);
        if (there > AGREES * doubt * size[c])
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

            if (dense_at(time, values) == FOURLINK_OK && sign * values[c] > best) {
                best = sign * values[c];
                at = time;
            }
        }
    return sign * best;
}

/* Columns whose extremes the rows do not tell: angles, which go on over whole turns; rounding error; parts of Ts beside a
** lock, which are the difference of torques without bound; lengths of Klein's construction, which jump where the crank is
** square to the line of stroke. */
static int is_left_out(unsigned long c)
{
    const char *name = columns[c].name;

    return (columns[c].flags & (FOURLINK_OF_ROUNDING | FOURLINK_CRANK_ANGLE)) ||
           strcmp(columns[c].quantity, "angle") == 0 || strncmp(name, "klein", 5) == 0 ||
           (problem.has_friction && strncmp(name, "Ts_", 3) == 0);
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

    if (is_of_inputs && input_is_whole && problem.has_friction)
        return; /* at a dead centre friction bounds the force of the drive, at a limit that is not known so well */
    for (c = 0; c < n_columns; c++)
        for (sign = -1; sign <= 1; sign += 2) {
            double best, error;

            if (is_left_out(c) || (is_of_inputs && columns[c].name[0] == 'h'))
                continue; /* the place of a force is a quotient that loses digits where the input hardly accelerates */
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
            if (fabs(error) > (is_of_inputs && input_is_whole ? AT_DEAD : SMOOTH))
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
    long n, first;
    char name[100];
    int i, k;

    is_searched = argc > 1 && strncmp(argv[1], "searched", 8) == 0;
    is_of_rows = argc > 1 && strstr(argv[1], "rows");
    is_of_inputs = is_searched || is_of_rows || (argc > 1 && strcmp(argv[1], "inputs") == 0);
    argc -= is_of_inputs;
    argv += is_of_inputs;
    n = argc > 1 ? atol(argv[1]) : 4;
    first = argc > 2 ? atol(argv[2]) : 0;

    for (n_decks = first; n_decks < first + n; n_decks++) {
        failed = 0;
        results = make(NULL) ? open_deck() : NULL;
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
            if (!(i ? problem.crossed : problem.open))
                continue;
            take_rows();
            if (!is_of_rows) {
                check_extremes();
                check_means();
            }
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
    if (!is_of_rows)
        printf("%ld extremes, %ld more without bound, %ld limits, within %.2g; %ld means within "
               "%.2g\n",
               n_extremes, n_unbounded, n_limits, worst_extreme, n_means, worst_mean);
    if (is_of_inputs)
        printf("%ld differences of inputs: speeds within %.2g of their size, accelerations within "
               "%.2g; %ld rows too near to a "
               "dead centre\n",
               n_differences, worst_input[0], worst_input[1], n_dead);
    printf("%ld decks wrong\n", n_failed);
    return n_failed > 0 || n_refused == n;
}
