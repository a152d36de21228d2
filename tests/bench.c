/* SPDX-License-Identifier: GPL-3.0-or-later
**
** bench.c - speed, as ratios to GSL's LU decomposition of the same matrices in the same run, and of
** printing to the C library's.
**
**    bench_rows FOURLINK DECK [NAME]
**
** prints the table of all ratios, with a mark where one is above its bound, or only the ratio NAME: then the
** exit status is 1 if that is above its bound, and 77 if the machine has too much else to do.
** Both numbers of a ratio are the medians of several rounds in which they take turns, so that a busy
** machine disturbs both alike.
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

/* The machines that rows are of. */
enum { FOUR_BAR, SLIDER_CRANK, INVERTED, MACHINES };

static struct machine {
    fourlink_mechanism mechanism;
    fourlink_load load;
} machines[MACHINES];

static void make_machines(void)
{
    make_four_bar(&machines[FOUR_BAR].mechanism, &machines[FOUR_BAR].load);
    make_slider_crank(&machines[SLIDER_CRANK].mechanism, &machines[SLIDER_CRANK].load);
    make_inverted(&machines[INVERTED].mechanism, &machines[INVERTED].load);
}

typedef int analyser(const fourlink_mechanism *, fourlink_branch, const fourlink_crank *,
                     const fourlink_load *, unsigned long, fourlink_state *, fourlink_forces *);

static double time_rows(analyser *analyse, int machine)
{
    const fourlink_mechanism *m = &machines[machine].mechanism;
    const fourlink_load *load = &machines[machine].load;
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
    static const fourlink_friction friction = {{0.001, 0.0006, 0.0006, 0.001}, 0.1, 0.05, 1, 0, 0};
    fourlink_losses losses;
    int status = fourlink_analyse_dyad(m, branch, crank, load, n, state, NULL);

    return status == FOURLINK_OK
               ? fourlink_solve_friction(m, state, load, n, &friction, 1, forces, &losses)
               : status;
}

/* A row of the nine equations, by dyads, or with friction. */
static double by_matrix(int machine)
{
    return time_rows(fourlink_analyse, machine);
}

static double by_dyads(int machine)
{
    return time_rows(fourlink_analyse_dyad, machine);
}

static double rows_by_dyads(int machine)
{
    return ANGLES * by_dyads(machine);
}

static double with_friction(int machine)
{
    return time_rows(analyse_friction, machine);
}

/* Extremes of a deck. */
#define DECK_SIZE 10000

static const char *deck_name, *command;

/* The deck with other columns than its own. */
static fourlink_source source_of(const char *columns)
{
    static char deck[DECK_SIZE];
    FILE *in = fopen(deck_name, "r");
    fourlink_source source;
    size_t n;

    if (!in)
        exit(EXIT_FAILURE);
    n = fread(deck, 1, DECK_SIZE - 400, in);
    fclose(in);
    memset(&source, 0, sizeof source);
    source.text = deck;
    source.length = n + (size_t)sprintf(deck + n, "\n[table]\ncolumns = %s\n", columns);
    return source;
}

static double time_extremes(const char *columns, const char *const *names, int n)
{
    fourlink_source source = source_of(columns);
    fourlink_results *results;
    fourlink_value value;
    double start, sum = 0;
    int i, design;

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

static const char *const extremes[] = {"max(Ts)",  "min(Ts)",  "max(F12)",
                                       "max(F23)", "max(F34)", "max(F14)"};

static double extremes_of_forces(int n)
{
    return time_extremes("Ts, F12, F23, F34, F14", extremes, n);
}

static double extremes_of_all(int n)
{
    return time_extremes("all", extremes, n);
}

/* A row of a steady cycle of 360, of a pump with motor, flywheel and fan, from the deck's text. */
static double steady(int unused)
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
    (void)unused;
    return (seconds() - start) / ANGLES;
}

/* Opening a deck whose loads have corners, and a row of its motion, against reading it: the corners cost
** nothing until a load is asked for. */
#define OPENINGS 100

enum { FRICTION, CURVE };

static const char *text_of(int deck)
{
    static const char head[] =
        "mechanism = slider-crank\n[table]\ncolumns = x, v\n[crank]\nlength = 50 mm\n"
        "mass = 1 kg\n[rod]\nlength = 200 mm\n[motion]\nspeed = 10 rad/s\n"
        "interval = 10 deg\n";
    static char text[DECK_SIZE];
    int n = sprintf(text, "%s", head), i;

    if (deck == FRICTION) {
        sprintf(text + n, "[friction]\nA = 0.1\nB = 0.1\nC = 0.1\nguide = 0.1\n"
                          "radius_A = 5 mm\nradius_B = 5 mm\nradius_C = 5 mm\n");
        return text;
    }
    n += sprintf(text + n, "[load]\nlink = piston\nover = x\nforce = ");
    for (i = 0; i < 200; i++)
        n += sprintf(text + n, "%s%.1f mm %d N", i ? ", " : "", 150 + 0.5 * i, i * i % 17);
    sprintf(text + n, "\n");
    return text;
}

static double opening(int deck)
{
    fourlink_results *results;
    fourlink_source source;
    double value[12], start;
    int i;

    memset(&source, 0, sizeof source);
    source.text = text_of(deck);
    source.length = strlen(source.text);
    start = seconds();
    for (i = 0; i < OPENINGS; i++) {
        if (fourlink_results_open(&source, 0, &results, NULL, NULL) != FOURLINK_OK ||
            fourlink_results_row(results, FOURLINK_OPEN, 1, value, NULL, NULL) != FOURLINK_OK)
            exit(EXIT_FAILURE);
        sink = sink + value[0];
        fourlink_results_free(results);
    }
    return (seconds() - start) / OPENINGS;
}

static double reading(int deck)
{
    const char *text = text_of(deck);
    size_t length = strlen(text);
    fourlink_deck *read;
    double start = seconds();
    int i;

    for (i = 0; i < OPENINGS; i++) {
        if (fourlink_deck_read(text, length, NULL, NULL, 0, &read, NULL, NULL) != FOURLINK_OK)
            exit(EXIT_FAILURE);
        fourlink_deck_free(read);
    }
    return (seconds() - start) / OPENINGS;
}

/* The bare loop: decomposition and solution of the same 9x9 systems, the matrix copied because the
** decomposition overwrites it, the permutation allocated once. */
static void make_systems(void)
{
    int i;

    for (i = 0; i < ANGLES; i++) {
        fourlink_crank crank = {i * (M_PI / 180), 10.5, 0};
        const struct machine *m = &machines[FOUR_BAR];
        fourlink_state state;

        if (fourlink_analyse(&m->mechanism, FOURLINK_OPEN, &crank, &m->load, 1, &state, NULL) ||
            fourlink_system(&m->mechanism, &state, &m->load, 1, systems[i].A, systems[i].b))
            exit(EXIT_FAILURE);
    }
}

static double by_lu(int unused)
{
    gsl_permutation *p = gsl_permutation_alloc(9);
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
    gsl_permutation_free(p);
    (void)unused;
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

enum { OWN, BY_LIBRARY };

static double numbers(int by_library)
{
    char number[FORMAT_SIZE];
    double start = seconds();
    int i, j;

    for (i = 0; i < ANGLES; i++)
        for (j = 0; j < COLUMNS; j++) {
            if (by_library)
                sprintf(number, "%.*f", decimals(j), table[i][j]);
            else
                format_fixed(table[i][j], decimals(j), number);
            sink = sink + number[1];
        }
    return (seconds() - start) / (ANGLES * COLUMNS);
}

static FILE *nowhere;

static double printing(int by_library)
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

        line_start(&row, nowhere);
        if (by_library)
            for (j = 0; j < COLUMNS; j++)
                fprintf(nowhere, "%*.*f", WIDTH, decimals(j), table[i][j]);
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

/* Processor seconds of the command with these arguments, then the deck; a null pointer ends them. */
static double run(const char *const *arguments, const char *output)
{
    const char *all[12];
    double start = cpu_of_children();
    pid_t child;
    int status = 1, n = 0;

    for (all[n++] = command; *arguments; arguments++)
        all[n++] = *arguments;
    all[n++] = "--output";
    all[n++] = output;
    all[n++] = deck_name;
    all[n] = NULL;
    child = fork();
    if (child == 0) {
        execv(command, (char *const *)all);
        _exit(127);
    }
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0) {
        fprintf(stderr, "cannot run %s %s\n", command, deck_name);
        exit(EXIT_FAILURE);
    }
    return cpu_of_children() - start;
}

/* A row of the deck by dyads, at an interval of 360 deg / rows. */
static double run_rows(double rows, const char *format, const char *output)
{
    char interval[64];
    const char *arguments[7];

    sprintf(interval, "--interval=%.17g deg", 360 / rows);
    arguments[0] = "--branch=open";
    arguments[1] = interval;
    arguments[2] = "--columns=" CHOSEN;
    arguments[3] = "--set";
    arguments[4] = "solver=dyad";
    arguments[5] = format;
    arguments[6] = NULL;
    return run(arguments, output) / rows;
}

enum { TABLE, CSV };

static double command_row(int is_csv)
{
    return is_csv ? run_rows(3e5, "--format=csv", "/dev/null")
                  : run_rows(1e6, "--format=table", "/dev/null");
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

static const printed *printed_rows(void)
{
    static printed rows;
    char path[] = "/tmp/fourlink-bench-XXXXXX";
    int file;

    if (rows.n > 0)
        return &rows;
    file = mkstemp(path);
    if (file < 0)
        exit(EXIT_FAILURE);
    close(file);
    run_rows(ANGLES, "--format=table", path);
    read_printed(path, &rows);
    remove(path);
    return &rows;
}

/* A row as in a table, or with 17 digits as in csv. */
static double library_row(int is_csv)
{
    const printed *p = printed_rows();
    double start = seconds();
    int passes = is_csv ? 30 : 100, pass, i, j;

    for (pass = 0; pass < passes; pass++)
        for (i = 0; i < ANGLES; i++) {
            for (j = 0; j < COLUMNS; j++)
                if (is_csv)
                    fprintf(nowhere, "%.17g,", p->value[i][j] * (1 + 1e-9 * j)); /* all digits */
                else
                    fprintf(nowhere, "%*.*f", WIDTH, p->decimals[j], p->value[i][j]);
            putc('\n', nowhere);
        }
    return (seconds() - start) / (passes * ANGLES);
}

/* The deck with its own columns and, in a table, their extremes. */
static double command_deck(int is_csv)
{
    static const char *const table_of[] = {"--format=table", "--branch=both", "--interval=1 deg",
                                           NULL};
    static const char *const csv_of[] = {"--format=csv", "--branch=both", "--interval=1 deg", NULL};

    return run(is_csv ? csv_of : table_of, "/dev/null");
}

/* A design of a sweep with two facts, both branches, by the command; one that a host sets, with max(Ts). */
#define SWEPT "20000"

static double sweep(int unused)
{
    static const char *const arguments[] = {"--set", "sweep.crank.length=18 mm to 22 mm in " SWEPT,
                                            "--set", "sweep.output=mu_min, swing", NULL};

    (void)unused;
    return run(arguments, "/dev/null") / strtod(SWEPT, NULL);
}

static double set(int designs)
{
    fourlink_source source = source_of(CHOSEN);
    fourlink_results *results;
    fourlink_value crank, torque;
    double start, value;
    int i;

    if (fourlink_results_open(&source, 0, &results, NULL, NULL) != FOURLINK_OK ||
        fourlink_results_find(results, "crank.length", &crank) != FOURLINK_OK ||
        fourlink_results_find(results, "max(Ts)", &torque) != FOURLINK_OK)
        exit(EXIT_FAILURE);
    start = seconds();
    for (i = 0; i < designs; i++) {
        value = 18 + 4.0 * i / designs; /* mm */
        if (fourlink_results_put(results, 1, &crank.handle, &value, NULL) != FOURLINK_OK ||
            fourlink_results_get(results, torque.handle, FOURLINK_OPEN, 0, &torque) != FOURLINK_OK)
            exit(EXIT_FAILURE);
        sink = sink + torque.value;
    }
    start = seconds() - start;
    fourlink_results_free(results);
    return start / designs;
}

/* ---------------------------------------------------------------------------------------- the ratios */

/* Processor seconds of something, of the sort that a number tells. */
typedef double timer(int sort);

/* What takes a part of the time of something else, in so many rounds, and at most which part.  Each name is
** that of a test in CMakeLists.txt. */
static const struct ratio {
    const char *name, *what;
    timer *part;
    int part_sort;
    timer *whole;
    int whole_sort, rounds;
    double bound;
} ratios[] = {
    {"row", "four-bar row, 22 results / GSL's LU, 9x9", by_matrix, FOUR_BAR, by_lu, 0, ROUNDS, 1},
    {"friction", "four-bar row with friction in all joints / without, by dyads", with_friction,
     FOUR_BAR, by_dyads, FOUR_BAR, ROUNDS, 6},
    {"slider_crank", "slider-crank row / four-bar row", by_matrix, SLIDER_CRANK, by_matrix,
     FOUR_BAR, ROUNDS, 1.15},
    {"inverted", "inverted slider-crank row / four-bar row", by_matrix, INVERTED, by_matrix,
     FOUR_BAR, ROUNDS, 1.15},
    {"inverted_dyads", "inverted slider-crank row / four-bar row, by dyads", by_dyads, INVERTED,
     by_dyads, FOUR_BAR, ROUNDS, 1.15},
    {"dyads", "four-bar row by dyads / GSL's LU, 9x9", by_dyads, FOUR_BAR, by_lu, 0, ROUNDS, 0.12},
    {"slider_crank_dyads", "slider-crank row by dyads / GSL's LU, 9x9", by_dyads, SLIDER_CRANK,
     by_lu, 0, ROUNDS, 0.12},
    {"steady", "row of a steady cycle to 1e-11 / slider-crank row by dyads", steady, 0, by_dyads,
     SLIDER_CRANK, ROUNDS, 80},
    {"number", "format_fixed / sprintf, 6 significant digits", numbers, OWN, numbers, BY_LIBRARY,
     ROUNDS, 0.12},
    {"printed_row", "row of 20 columns, printed / fprintf", printing, OWN, printing, BY_LIBRARY,
     ROUNDS, 0.125},
    {"open_friction", "opening with friction, a row of the motion / reading", opening, FRICTION,
     reading, FRICTION, ROUNDS, 1.5},
    {"open_curve", "opening with 200 points over x, a row of the motion / reading", opening, CURVE,
     reading, CURVE, ROUNDS, 1.5},
    {"sweep", "design of a sweep with two facts, printed / row by dyads", sweep, 0, by_dyads,
     FOUR_BAR, RUNS, 60},
    {"set", "set and max(Ts) / four-bar row by dyads", set, 2000, by_dyads, FOUR_BAR, RUNS, 200},
    {"six_extremes", "six extremes of forces / 360 rows by dyads", extremes_of_forces, 6,
     rows_by_dyads, FOUR_BAR, ROUNDS, 2.5},
    {"extreme", "max(Ts) of a deck with all columns / 360 rows by dyads", extremes_of_all, 1,
     rows_by_dyads, FOUR_BAR, ROUNDS, 2},
    {"all_extremes", "table at 1 deg with all extremes, both branches / csv", command_deck, TABLE,
     command_deck, CSV, ROUNDS, 3},
    {"table", "row of 20 columns, computed and printed / fprintf alone", command_row, TABLE,
     library_row, TABLE, RUNS, 0.125},
    {"csv", "the same as csv with 17 digits / fprintf of the same", command_row, CSV, library_row,
     CSV, RUNS, 0.15}};

static int by_size(const void *x, const void *y)
{
    double a = *(const double *)x, b = *(const double *)y;

    return (a > b) - (a < b);
}

static double median(double *x, int n)
{
    qsort(x, (size_t)n, sizeof *x, by_size);
    return x[n / 2];
}

/* 1 if the ratio is above its bound. */
static int report(const struct ratio *r)
{
    double part[ROUNDS], whole[ROUNDS], time, ratio;
    int i;

    for (i = 0; i < r->rounds; i++) {
        part[i] = r->part(r->part_sort);
        whole[i] = r->whole(r->whole_sort);
    }
    time = median(part, r->rounds);
    ratio = time / median(whole, r->rounds);
    printf("%-18s  %-61s %9.3f us %7.3f  (at most %.3g)%s\n", r->name, r->what, 1e6 * time, ratio,
           r->bound, ratio > r->bound ? "  MISSED" : "");
    fflush(stdout);
    return ratio > r->bound;
}

static double of_the_clock(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Other processes have taken some of the time. */
#define BUSY 0.9
#define SKIPPED 77

int main(int argc, char **argv)
{
    const int n = sizeof ratios / sizeof ratios[0];
    double start = of_the_clock(), used;
    int i, tried = 0, missed = 0;

    nowhere = fopen("/dev/null", "w");
    if (!nowhere || argc < 3 || argc > 4) {
        fprintf(stderr, "usage: bench_rows FOURLINK DECK [NAME]\n");
        return 2;
    }
    command = argv[1];
    deck_name = argv[2];
    make_machines();
    make_systems();
    make_table();
    for (i = 0; i < n; i++)
        if (argc == 3 || !strcmp(argv[3], ratios[i].name)) {
            tried++;
            missed += report(&ratios[i]);
        }
    fclose(nowhere);
    if (!tried) {
        fprintf(stderr, "bench_rows: there is no ratio '%s'\n", argv[3]);
        return 2;
    }
    if (argc == 3) {
        printf("%d of %d above their bounds\n", missed, n);
        return EXIT_SUCCESS;
    }
    used = seconds() + cpu_of_children();
    if (missed && used < BUSY * (of_the_clock() - start)) {
        printf("skipped: the machine has too much else to do\n");
        return SKIPPED;
    }
    return missed ? EXIT_FAILURE : EXIT_SUCCESS;
}
