/* SPDX-License-Identifier: GPL-3.0-or-later
**
** bench.c - speed, as ratios to GSL's LU decomposition of the same matrices in the same run, and of
** printing to the C library's.
**
** Each figure is the median of several rounds in which the candidates take turns, so that a busy
** machine disturbs all of them alike.
*/
#define _XOPEN_SOURCE 600 /* POSIX.1-2001, with mkstemp */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <gsl/gsl_linalg.h>
#include <gsl/gsl_math.h>

#include "base/digits.h"
#include "system/format.h"
#include "fourlink.h"
#include "tables/line.h"

#define DESIGNS 50 /* of a sweep, for its extremes */
#define ANGLES 360
#define COLUMNS 20
#define WIDTH 11
#define ROUNDS 21
#define PASSES 100 /* over all angles, in a round */
#define RUNS 5     /* of the command */

typedef struct system {
    double A[9][9], b[9];
} system_;

static system_ systems[ANGLES];
static double table[ANGLES][COLUMNS];
static volatile double sink; /* keeps the compiler from leaving the work out */

/* Processor time, which other processes disturb less than that of the wall. */
static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void set_link(fourlink_link *link, double length, double mass, double k, double r, double at)
{
    link->length = length;
    link->mass = mass;
    link->inertia = mass * k * k;
    link->cg.x = r * cos(at);
    link->cg.y = r * sin(at);
}

/* data/me3491-matrix.deck */
static void make_four_bar(fourlink_mechanism *m, fourlink_load *load)
{
    fourlink_design d;

    memset(&d, 0, sizeof d);
    d.kind = FOURLINK_FOUR_BAR;
    d.link[1].length = 0.080;
    set_link(&d.link[2], 0.020, 0.10, 0.008, 0.010, 0);
    set_link(&d.link[3], 0.066, 0.30, 0.025, 0.030, 10 * M_PI / 180);
    set_link(&d.link[4], 0.056, 0.25, 0.020, 0.028, -5 * M_PI / 180);
    d.gravity.y = -9.81;
    memset(load, 0, sizeof *load);
    load->link = FOURLINK_FOLLOWER;
    load->torque = 0.5;
    if (fourlink_prepare(&d, m) != FOURLINK_OK)
        exit(EXIT_FAILURE);
}

/* The engine of ME3491, example 1. */
static void make_slider_crank(fourlink_mechanism *m, fourlink_load *load)
{
    fourlink_design d;

    memset(&d, 0, sizeof d);
    d.kind = FOURLINK_SLIDER_CRANK;
    set_link(&d.link[2], 0.150, 0, 0, 0, 0);
    set_link(&d.link[3], 0.450, 2, 0.175, 0.150, 0);
    d.link[4].mass = 2.5;
    d.gravity.y = -9.81;
    memset(load, 0, sizeof *load);
    load->link = FOURLINK_FOLLOWER;
    load->force.x = -20773.8;
    if (fourlink_prepare(&d, m) != FOURLINK_OK)
        exit(EXIT_FAILURE);
}

/* A crank and slotted lever. */
static void make_inverted(fourlink_mechanism *m, fourlink_load *load)
{
    fourlink_design d;

    memset(&d, 0, sizeof d);
    d.kind = FOURLINK_INVERTED_SLIDER_CRANK;
    d.link[1].length = 0.240;
    d.offset = 0.010;
    set_link(&d.link[2], 0.120, 0.8, 0.040, 0.050, 0);
    set_link(&d.link[3], 0, 0.3, 0.020, 0, 0);
    set_link(&d.link[4], 0, 2.5, 0.120, 0.210, 0);
    d.gravity.y = -9.81;
    memset(load, 0, sizeof *load);
    load->link = FOURLINK_FOLLOWER;
    load->at.x = 0.450;
    load->force.x = -150;
    if (fourlink_prepare(&d, m) != FOURLINK_OK)
        exit(EXIT_FAILURE);
}

typedef int analyser(const fourlink_mechanism *, fourlink_branch, const fourlink_crank *,
                     const fourlink_load *, unsigned long, fourlink_state *, fourlink_forces *);

static double time_rows(analyser *analyse, const fourlink_mechanism *m, const fourlink_load *load)
{
    fourlink_crank crank = {0, 10.5, 0};
    fourlink_state state;
    fourlink_forces forces;
    double start = seconds();
    int pass, i;

    for (pass = 0; pass < PASSES; pass++)
        for (i = 0; i < ANGLES; i++) {
            crank.theta2 = i * (M_PI / 180);
            if (analyse(m, FOURLINK_OPEN, &crank, load, 1, &state, &forces) != FOURLINK_OK)
                exit(EXIT_FAILURE);
            sink = sink + forces.Ts + state.link[3].alpha;
        }
    return (seconds() - start) / (PASSES * ANGLES);
}

/* As fourlink_analyse_dyad, with friction in all joints. */
static int analyse_friction(const fourlink_mechanism *m, fourlink_branch branch,
                            const fourlink_crank *crank, const fourlink_load *load, unsigned long n,
                            fourlink_state *state, fourlink_forces *forces)
{
    static const fourlink_friction friction = {{0.001, 0.0006, 0.0006, 0.001}, 0.1, 0.05, 1};
    fourlink_losses losses;
    int status = fourlink_analyse_dyad(m, branch, crank, load, n, state, NULL);

    return status == FOURLINK_OK
               ? fourlink_solve_friction(m, state, load, n, &friction, 1, forces, &losses)
               : status;
}

/* Extremes.  The six of the forces against 360 rows by dyads of the same deck, and those of a whole
** table, both branches, against writing that as csv. */
#define DECK_SIZE 10000

static double time_extremes(const char *deck, size_t length, int n)
{
    static const char *const names[] = {"max(Ts)",  "min(Ts)",  "max(F12)",
                                        "max(F23)", "max(F34)", "max(F14)"};
    fourlink_results *results;
    fourlink_source source;
    fourlink_value value;
    double start, sum = 0;
    int i, design;

    memset(&source, 0, sizeof source);
    source.text = deck;
    source.length = length;
    for (design = 0; design < DESIGNS; design++) {
        if (fourlink_results_open(&source, 0, &results, NULL, NULL) != FOURLINK_OK)
            exit(EXIT_FAILURE);
        start = seconds();
        for (i = 0; i < n; i++) {
            if (fourlink_results_value(results, names[i], FOURLINK_OPEN, 0, &value) != FOURLINK_OK)
                exit(EXIT_FAILURE);
            sink = sink + value.value;
        }
        sum += seconds() - start;
        fourlink_results_free(results);
    }
    return sum / DESIGNS;
}

/* A steady cycle of a pump with motor, flywheel and fan, 360 rows, from the deck's text. */
static double time_steady(void)
{
    static const char deck[] =
        "mechanism = slider-crank\nsolver = dyad\n[crank]\nlength = 50 mm\nmass = 1.5 kg\n"
        "inertia = 0.002 kg m2\ncg = (12, 3) mm\n[rod]\nlength = 200 mm\nmass = 0.8 kg\n"
        "inertia = 0.0035 kg m2\ncg = 70 mm\n[ground]\noffset = 10 mm\n[piston]\nmass = 1.2 "
        "kg\n[load P]\nlink = piston\nforce = 0 deg -100 N, 60 deg -150 N, 120 deg -150 N, 180 "
        "deg -300 N, 200 deg -900 N, 240 deg -1400 N, 300 deg -1200 N\n[load F]\nlink = crank\n"
        "torque = -0.02 N m\nover = omega2\nat_speed = 1 rad/s\nexponent = 2\n[motor]\n"
        "stall_torque = 120 N m\nno_load_speed = 14 rad/s\n[flywheel]\ninertia = 0.5 kg m2\n"
        "[motion]\nmode = steady\ninterval = 1 deg\n";
    fourlink_results *results;
    fourlink_instant instant;
    fourlink_source source;
    double start = seconds();
    unsigned long i;

    memset(&source, 0, sizeof source);
    source.text = deck;
    source.length = sizeof deck - 1;
    if (fourlink_results_open(&source, 0, &results, NULL, NULL) != FOURLINK_OK)
        exit(EXIT_FAILURE);
    for (i = 0; i < ANGLES; i++) {
        if (fourlink_results_row(results, FOURLINK_OPEN, i, NULL, &instant, NULL) != FOURLINK_OK)
            exit(EXIT_FAILURE);
        sink = sink + instant.forces.Ts;
    }
    fourlink_results_free(results);
    return seconds() - start;
}

/* Opening a deck whose loads have corners, and a row of its motion, against reading it: the corners cost
** nothing until a load is asked for. */
#define OPENINGS 100

static double time_opening(const char *deck, size_t length, int opens)
{
    fourlink_results *results;
    fourlink_deck *read;
    fourlink_source source;
    double value[12], start = seconds();
    int i;

    memset(&source, 0, sizeof source);
    source.text = deck;
    source.length = length;
    for (i = 0; i < OPENINGS; i++)
        if (opens) {
            if (fourlink_results_open(&source, 0, &results, NULL, NULL) != FOURLINK_OK ||
                fourlink_results_row(results, FOURLINK_OPEN, 1, value, NULL, NULL) != FOURLINK_OK)
                exit(EXIT_FAILURE);
            sink = sink + value[0];
            fourlink_results_free(results);
        } else {
            if (fourlink_deck_read(deck, length, NULL, NULL, 0, &read, NULL, NULL) != FOURLINK_OK)
                exit(EXIT_FAILURE);
            fourlink_deck_free(read);
        }
    return (seconds() - start) / OPENINGS;
}

/* A deck with other columns than its own. */
static size_t read_deck(const char *name, const char *columns, char deck[DECK_SIZE])
{
    FILE *in = fopen(name, "r");
    size_t n;

    if (!in)
        exit(EXIT_FAILURE);
    n = fread(deck, 1, DECK_SIZE - 100, in);
    fclose(in);
    return n + (size_t)sprintf(deck + n, "\n[table]\ncolumns = %s\n", columns);
}

/* The bare loop: decomposition and solution of the same 9x9 systems, the matrix copied because the
** decomposition overwrites it, the permutation allocated once. */
static double time_lu(gsl_permutation *p)
{
    double A[9][9], x[9], start = seconds();
    gsl_matrix_view Av = gsl_matrix_view_array(A[0], 9, 9);
    gsl_vector_view xv = gsl_vector_view_array(x, 9);
    int pass, i, sign;

    for (pass = 0; pass < PASSES; pass++)
        for (i = 0; i < ANGLES; i++) {
            gsl_vector_const_view bv = gsl_vector_const_view_array(systems[i].b, 9);

            memcpy(A, systems[i].A, sizeof A);
            gsl_linalg_LU_decomp(&Av.matrix, p, &sign);
            gsl_linalg_LU_solve(&Av.matrix, p, &bv.vector, &xv.vector);
            sink = sink + x[8];
        }
    return (seconds() - start) / (PASSES * ANGLES);
}

/* Columns of sizes from 10^-3 to 10^4, and their decimals: six digits of the largest. */
static void make_table(void)
{
    int i, j;

    for (i = 0; i < ANGLES; i++)
        for (j = 0; j < COLUMNS; j++)
            table[i][j] = 9 * pow(10, j % 8 - 3) * sin((1 + j) * i * (M_PI / 180) + j);
}

static int decimals(int column)
{
    return 8 - column % 8;
}

static double time_numbers(int by_sprintf)
{
    char number[FORMAT_SIZE];
    double start = seconds();
    int i, j;

    for (i = 0; i < ANGLES; i++)
        for (j = 0; j < COLUMNS; j++) {
            if (by_sprintf)
                sprintf(number, "%.*f", decimals(j), table[i][j]);
            else
                format_fixed(table[i][j], decimals(j), number);
            sink = sink + number[1];
        }
    return (seconds() - start) / (ANGLES * COLUMNS);
}

static double time_printing(FILE *out, int by_fprintf)
{
    digits_cell cells[COLUMNS];
    double start = seconds();
    size_t missed = 0;
    int i, j;

    for (j = 0; j < COLUMNS;
         j++) /* the first one, in a longer line, so that it is written in the same way */
        flk_digits_cell(&cells[j], (size_t)j, decimals(j), 1e9, (size_t)(WIDTH * j + 2 * WIDTH));
    for (i = 0; i < ANGLES; i++) {
        line row;

        line_start(&row, out);
        if (by_fprintf)
            for (j = 0; j < COLUMNS; j++)
                fprintf(out, "%*.*f", WIDTH, decimals(j), table[i][j]);
        else
            missed +=
                flk_digits_put(cells, COLUMNS, table[i], line_blanks(&row, WIDTH * (COLUMNS + 1)));
        line_text(&row, "\n", 1);
        line_end(&row);
    }
    if (missed)
        exit(EXIT_FAILURE); /* a number that is not printed in this way costs nothing */
    return (seconds() - start) / ANGLES;
}

static int by_size(const void *x, const void *y)
{
    double a = *(const double *)x, b = *(const double *)y;

    return (a > b) - (a < b);
}

static double median(double *x, size_t n)
{
    qsort(x, n, sizeof *x, by_size);
    return x[n / 2];
}

static int report(const char *what, double ratio, double bound)
{
    printf("%-62s %5.3f  (at most %.3g)%s\n", what, ratio, bound, ratio <= bound ? "" : "  MISSED");
    return ratio > bound;
}

/* ------------------------------------------------------------------------------- the whole command */

#define CHOSEN                                                                                \
    "theta2,theta3,omega3,alpha3,theta4,omega4,alpha4,mu,F12x,F12y,F23x,F23y,F34x,F34y,F14x," \
    "F14y,Ts,omega2,alpha2,power"

static double cpu_of_children(void)
{
    struct rusage u;

    getrusage(RUSAGE_CHILDREN, &u);
    return (double)u.ru_utime.tv_sec + 1e-6 * (double)u.ru_utime.tv_usec +
           (double)u.ru_stime.tv_sec + 1e-6 * (double)u.ru_stime.tv_usec;
}

/* The largest resident size that one of them had so far, kB. */
static long size_of_children(void)
{
    struct rusage u;

    getrusage(RUSAGE_CHILDREN, &u);
    return u.ru_maxrss;
}

/* Run the command on a deck at an interval of 360 deg / rows, by dyads; processor seconds. */
static double run_command(const char *command, const char *deck_name, double rows,
                          const char *format, const char *output)
{
    char interval[64];
    double start = cpu_of_children();
    pid_t child;
    int status = 1;

    sprintf(interval, "--interval=%.17g deg", 360 / rows);
    child = fork();
    if (child == 0) {
        execl(command, command, "--branch=open", interval, "--columns=" CHOSEN, "--set",
              "solver=dyad", format, "--output", output, deck_name, (char *)NULL);
        _exit(127);
    }
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0) {
        fprintf(stderr, "cannot run %s %s\n", command, deck_name);
        exit(EXIT_FAILURE);
    }
    return cpu_of_children() - start;
}

/* The same rows by fprintf: 360 of them, as the command printed them, again and again. */
typedef struct printed {
    double value[ANGLES][COLUMNS];
    int decimals[COLUMNS], n;
} printed;

static void read_printed(const char *path, printed *p)
{
    char printed_line[1000], *rest;
    FILE *in = fopen(path, "r");
    int j;

    while (in && p->n < ANGLES && fgets(printed_line, sizeof printed_line, in)) {
        if (printed_line[0] == '#')
            continue;
        for (j = 0, rest = printed_line; j < COLUMNS; j++) {
            const char *point;

            p->value[p->n][j] = strtod(rest, &rest);
            for (point = rest; point > printed_line && point[-1] != '.' && point[-1] != ' ';
                 point--)
                ;
            p->decimals[j] = point > printed_line && point[-1] == '.' ? (int)(rest - point) : 0;
        }
        p->n++;
    }
    if (in)
        fclose(in);
    if (p->n != ANGLES)
        exit(EXIT_FAILURE);
}

/* As in a table, or with 17 digits as in csv. */
static double time_fprintf(FILE *out, const printed *p, int passes, int is_csv)
{
    double start = seconds();
    int pass, i, j;

    for (pass = 0; pass < passes; pass++)
        for (i = 0; i < ANGLES; i++) {
            for (j = 0; j < COLUMNS; j++)
                if (is_csv)
                    fprintf(out, "%.17g,", p->value[i][j] * (1 + 1e-9 * j)); /* all digits */
                else
                    fprintf(out, "%*.*f", WIDTH, p->decimals[j], p->value[i][j]);
            putc('\n', out);
        }
    return seconds() - start;
}

/* A million rows against fprintf of the same, and the memory that a thousand and a million take. */
static int report_command(const char *command, const char *deck_name, FILE *nowhere)
{
    static printed rows;
    char path[] = "/tmp/fourlink-bench-XXXXXX";
    int file = mkstemp(path), i, missed;
    double whole[RUNS], alone[RUNS], csv[RUNS], csv_alone[RUNS];
    long small, large;

    if (file < 0)
        return 1;
    close(file);
    run_command(command, deck_name, ANGLES, "--format=table", path);
    read_printed(path, &rows);
    remove(path);
    run_command(command, deck_name, 1e3, "--format=table", "/dev/null");
    small = size_of_children();
    for (i = 0; i < RUNS; i++) {
        whole[i] = run_command(command, deck_name, 1e6, "--format=table", "/dev/null") / 1e6;
        alone[i] = time_fprintf(nowhere, &rows, 100, 0) / (100 * ANGLES);
        csv[i] = run_command(command, deck_name, 3e5, "--format=csv", "/dev/null") / 3e5;
        csv_alone[i] = time_fprintf(nowhere, &rows, 30, 1) / (30 * ANGLES);
    }
    large = size_of_children();
    missed = report("a row of 20 columns, computed and printed / fprintf alone",
                    median(whole, RUNS) / median(alone, RUNS), 0.125);
    printf("that is %.2f million rows a second, and %.2f by fprintf\n", 1e-6 / median(whole, RUNS),
           1e-6 / median(alone, RUNS));
    missed += report("csv of 20 columns with 17 digits / fprintf of the same",
                     median(csv, RUNS) / median(csv_alone, RUNS), 0.15);
    printf("peak resident size: %ld kB for 1e3 rows, %ld kB for 1e6\n", small, large);
    return missed;
}

/* Processor seconds of a command, its output thrown away. */
static double time_command(const char *const *arguments)
{
    double start = cpu_of_children();
    pid_t child = fork();
    int status = 1;

    if (child == 0) {
        execv(arguments[0], (char *const *)arguments);
        _exit(127);
    }
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0)
        exit(EXIT_FAILURE);
    return cpu_of_children() - start;
}

static double time_table(const char *command, const char *format, const char *deck_name)
{
    const char *arguments[8];

    arguments[0] = command;
    arguments[1] = format;
    arguments[2] = "--branch=both";
    arguments[3] = "--interval=1 deg";
    arguments[4] = "--output";
    arguments[5] = "/dev/null";
    arguments[6] = deck_name;
    arguments[7] = NULL;
    return time_command(arguments);
}

/* A design of a sweep with two facts, both branches, by the command; one that a host sets, with max(Ts). */
#define SWEPT "20000"

static double time_sweep(const char *command, const char *deck_name)
{
    const char *arguments[9];

    arguments[0] = command;
    arguments[1] = "--set";
    arguments[2] = "sweep.crank.length=18 mm to 22 mm in " SWEPT;
    arguments[3] = "--set";
    arguments[4] = "sweep.output=mu_min, swing";
    arguments[5] = "--output";
    arguments[6] = "/dev/null";
    arguments[7] = deck_name;
    arguments[8] = NULL;
    return time_command(arguments) / strtod(SWEPT, NULL);
}

static double time_set(const char *deck, size_t length, int n)
{
    fourlink_results *results;
    fourlink_source source;
    fourlink_value crank, torque;
    double start, value;
    int i;

    memset(&source, 0, sizeof source);
    source.text = deck;
    source.length = length;
    if (fourlink_results_open(&source, 0, &results, NULL, NULL) != FOURLINK_OK ||
        fourlink_results_find(results, "crank.length", &crank) != FOURLINK_OK ||
        fourlink_results_find(results, "max(Ts)", &torque) != FOURLINK_OK)
        exit(EXIT_FAILURE);
    start = seconds();
    for (i = 0; i < n; i++) {
        value = 18 + 4.0 * i / n; /* mm */
        if (fourlink_results_put(results, 1, &crank.handle, &value, NULL) != FOURLINK_OK ||
            fourlink_results_get(results, torque.handle, FOURLINK_OPEN, 0, &torque) != FOURLINK_OK)
            exit(EXIT_FAILURE);
        sink = sink + torque.value;
    }
    start = seconds() - start;
    fourlink_results_free(results);
    return start / n;
}

/* Six extremes against rows, and all those of a table against the table. */
static int report_extremes(const char *command, const char *deck_name, const fourlink_mechanism *m,
                           const fourlink_load *load)
{
    static char deck[DECK_SIZE], wide[DECK_SIZE];
    double extremes[ROUNDS], one[ROUNDS], rows[ROUNDS], summary[ROUNDS], csv[ROUNDS];
    size_t length = read_deck(deck_name, "Ts, F12, F23, F34, F14", deck);
    size_t length_of_wide = read_deck(deck_name, "all", wide);
    int i, missed;

    for (i = 0; i < ROUNDS; i++) {
        extremes[i] = time_extremes(deck, length, 6);
        one[i] = time_extremes(wide, length_of_wide, 1);
        rows[i] = ANGLES * time_rows(fourlink_analyse_dyad, m, load);
        summary[i] = time_table(command, "--format=table", deck_name);
        csv[i] = time_table(command, "--format=csv", deck_name);
    }
    missed = report("six extremes of forces / 360 rows by dyads",
                    median(extremes, ROUNDS) / median(rows, ROUNDS), 2.5);
    missed += report("max(Ts) of a deck with all columns / 360 rows by dyads",
                     median(one, ROUNDS) / median(rows, ROUNDS), 2);
    return missed + report("a table at 1 deg with all its extremes, both branches / csv",
                           median(summary, ROUNDS) / median(csv, ROUNDS), 3);
}

static int report_designs(const char *command, const char *deck_name, const fourlink_mechanism *m,
                          const fourlink_load *load)
{
    static char deck[DECK_SIZE];
    size_t length = read_deck(deck_name, CHOSEN, deck);
    double swept[RUNS], set[RUNS], row[RUNS];
    int i, missed;

    for (i = 0; i < RUNS; i++) {
        swept[i] = time_sweep(command, deck_name);
        set[i] = time_set(deck, length, 2000);
        row[i] = time_rows(fourlink_analyse_dyad, m, load);
    }
    missed = report("design of a sweep with two facts, printed / four-bar row by dyads",
                    median(swept, RUNS) / median(row, RUNS), 60);
    return missed + report("set and max(Ts) / four-bar row by dyads",
                           median(set, RUNS) / median(row, RUNS), 200);
}

static int report_openings(void)
{
    static const char head[] =
        "mechanism = slider-crank\n[table]\ncolumns = x, v\n[crank]\nlength = 50 mm\n"
        "mass = 1 kg\n[rod]\nlength = 200 mm\n[motion]\nspeed = 10 rad/s\n"
        "interval = 10 deg\n";
    char friction[1000], curve[10000];
    const char *decks[2];
    double reading[ROUNDS], opening[ROUNDS];
    int i, k, n, missed = 0;

    sprintf(friction,
            "%s[friction]\nA = 0.1\nB = 0.1\nC = 0.1\nguide = 0.1\n"
            "radius_A = 5 mm\nradius_B = 5 mm\nradius_C = 5 mm\n",
            head);
    n = sprintf(curve, "%s[load]\nlink = piston\nover = x\nforce = ", head);
    for (i = 0; i < 200; i++)
        n += sprintf(curve + n, "%s%.1f mm %d N", i ? ", " : "", 150 + 0.5 * i, i * i % 17);
    sprintf(curve + n, "\n");
    decks[0] = friction;
    decks[1] = curve;
    for (k = 0; k < 2; k++) {
        for (i = 0; i < ROUNDS; i++) {
            reading[i] = time_opening(decks[k], strlen(decks[k]), 0);
            opening[i] = time_opening(decks[k], strlen(decks[k]), 1);
        }
        missed +=
            report(k ? "opening with a curve of 200 points over x, rows of the motion / reading"
                     : "opening with friction, rows of the motion / reading",
                   median(opening, ROUNDS) / median(reading, ROUNDS), 1.5);
    }
    return missed;
}

int main(int argc, char **argv)
{
    fourlink_mechanism four_bar, slider_crank, inverted;
    fourlink_load torque, gas, cut;
    gsl_permutation *p = gsl_permutation_alloc(9);
    double lu[ROUNDS], a[ROUNDS], b[ROUNDS], c[ROUNDS], d[ROUNDS], e[ROUNDS], f[ROUNDS], g[ROUNDS],
        h[ROUNDS], numbers[2][ROUNDS], rows[2][ROUNDS];
    FILE *nowhere = fopen("/dev/null", "w");
    int i, how, missed = 0;

    if (!nowhere)
        return EXIT_FAILURE;
    make_table();
    make_four_bar(&four_bar, &torque);
    make_slider_crank(&slider_crank, &gas);
    make_inverted(&inverted, &cut);
    for (i = 0; i < ANGLES; i++) {
        fourlink_crank crank = {i * (M_PI / 180), 10.5, 0};
        fourlink_state state;

        if (fourlink_analyse(&four_bar, FOURLINK_OPEN, &crank, &torque, 1, &state, NULL) ||
            fourlink_system(&four_bar, &state, &torque, 1, systems[i].A, systems[i].b))
            return EXIT_FAILURE;
    }
    for (i = 0; i < ROUNDS; i++) {
        lu[i] = time_lu(p);
        a[i] = time_rows(fourlink_analyse, &four_bar, &torque);
        b[i] = time_rows(fourlink_analyse, &slider_crank, &gas);
        c[i] = time_rows(fourlink_analyse_dyad, &four_bar, &torque);
        d[i] = time_rows(fourlink_analyse_dyad, &slider_crank, &gas);
        e[i] = time_rows(fourlink_analyse, &inverted, &cut);
        f[i] = time_rows(fourlink_analyse_dyad, &inverted, &cut);
        g[i] = time_rows(analyse_friction, &four_bar, &torque);
        h[i] = time_steady() / ANGLES;
        for (how = 0; how < 2; how++) {
            numbers[how][i] = time_numbers(how);
            rows[how][i] = time_printing(nowhere, how);
        }
    }
    printf("gsl_linalg_LU_decomp + LU_solve, 9x9: %.0f ns\n", 1e9 * median(lu, ROUNDS));
    missed += report("four-bar row, 22 results / bare LU loop",
                     median(a, ROUNDS) / median(lu, ROUNDS), 1.0);
    missed += report("four-bar row with friction in all joints / without, by dyads",
                     median(g, ROUNDS) / median(c, ROUNDS), 6.0);
    missed +=
        report("slider-crank row / four-bar row", median(b, ROUNDS) / median(a, ROUNDS), 1.15);
    missed += report("inverted slider-crank row / four-bar row",
                     median(e, ROUNDS) / median(a, ROUNDS), 1.15);
    missed += report("inverted slider-crank row / four-bar row, both by dyads",
                     median(f, ROUNDS) / median(c, ROUNDS), 1.15);
    missed += report("four-bar row by dyads / bare LU loop", median(c, ROUNDS) / median(lu, ROUNDS),
                     0.12);
    missed += report("slider-crank row by dyads / bare LU loop",
                     median(d, ROUNDS) / median(lu, ROUNDS), 0.12);
    missed += report("a row of a steady cycle, found to 1e-11 / slider-crank row by dyads",
                     median(h, ROUNDS) / median(d, ROUNDS), 80);
    missed += report("format_fixed / sprintf, 6 significant digits",
                     median(numbers[0], ROUNDS) / median(numbers[1], ROUNDS), 0.12);
    missed += report("row of 20 columns: table printing / fprintf of the same",
                     median(rows[0], ROUNDS) / median(rows[1], ROUNDS), 0.125);
    missed += report_openings();
    if (argc == 3)
        missed += report_designs(argv[1], argv[2], &four_bar, &torque) +
                  report_extremes(argv[1], argv[2], &four_bar, &torque) +
                  report_command(argv[1], argv[2], nowhere);
    fclose(nowhere);
    gsl_permutation_free(p);
    return missed ? EXIT_FAILURE : EXIT_SUCCESS;
}
