/* SPDX-License-Identifier: GPL-3.0-or-later
**
** brute_crossings.c - the crank angles at which columns of random decks, or of given ones, have a value, against bisection.
**
**    brute_crossings DECKS [SEED [FIRST]]    (brute_decks.h)
**    brute_crossings FILE [CHANCE]...
**    brute_crossings inputs DECKS [SEED [FIRST]]    the same decks, moved by another input than the crank
**
** Of each column on both branches, two values are sought: one that it has between two rows chosen by
** chance, and one of its peaks.  The rows are thousands, closer to dead positions and to the ends of the
** motion.  No crossing is false: the row there has the value, to 1e-9 of the largest value of its
** quantity in that row, or of the change to rows beside it.  None is lost: wherever two rows next to
** each other are on different sides of the value, bisection leads to a jump or to a crossing that was
** found, but for touches within 1e-6 and what rounding decides.  Random decks that fail are left as
** crossings-SEED-NUMBER.deck.
*/
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fourlink.h"
#include "brute_decks.h"

#define COLUMNS 300
#define EVEN 1500 /* rows, evenly spaced */
#define MOST 6000
#define CROSSINGS 2000
#define FALSE_BY 1e-9   /* of the row's scale */
#define TOUCHES 1e-6    /* the same */
#define SAME_ANGLE 5e-7 /* rad */
#define NO_ROW 3e-4     /* rad: closer to a place without a row, rows are rounding error */

static fourlink_results *results;
static const fourlink_value *columns;
static unsigned long n_columns, mu; /* the column of this name */
static fourlink_branch branch;
static double from, end, sense, total, angle_unit; /* of the motion: deck's unit, +-1, rad, rad */

static double at[MOST]; /* rad passed */
static int status[MOST];
static double rows[MOST][COLUMNS];
static int n;

static long n_inputs, sought, found, expected, touches, rounded, wrong, missing;
static double worst;

static double angle_of(double p)
{
    return p >= total ? end : from + sense * p / angle_unit;
}

static int compute(double p, double *v)
{
    return fourlink_results_at(results, branch, angle_of(p), v, NULL, NULL);
}

static int is_angle(unsigned long c)
{
    return strcmp(columns[c].quantity, "angle") == 0;
}

/* How far a row is from the value; an angle, to the nearest turn. */
static double off(unsigned long c, const double *v, double value)
{
    double d = v[c] - value, turn = 2 * PI / columns[c].to_si;

    return is_angle(c) ? d - turn * floor(d / turn + 0.5) : d;
}

/* The largest magnitude of a column's quantity in a row, or the value's. */
static double scale_of(unsigned long c, const double *v, double value)
{
    double most = fabs(value);
    unsigned long k;

    for (k = 0; k < n_columns; k++)
        if (strcmp(columns[k].quantity, columns[c].quantity) == 0 && fabs(v[k]) < 1e300)
            most = fmax(most, fabs(v[k]));
    return is_angle(c) ? 2 * PI / columns[c].to_si : most;
}

/* ---------------------------------------------------------------------------------------------- rows */

static void add(double p)
{
    if (n < MOST && p >= 0 && p <= total)
        at[n++] = p;
}

static int by_size(const void *x, const void *y)
{
    double a = *(const double *)x, b = *(const double *)y;

    return (a > b) - (a < b);
}

static void compute_rows(int first)
{
    int i;

    for (i = first; i < n; i++)
        status[i] = compute(at[i], rows[i]);
}

/* Rows ever closer to a place. */
static void add_beside(double p, int side)
{
    double d;

    for (d = 0.02; d > 1e-6; d /= 3)
        add(p + side * d);
}

static void take_rows(void)
{
    static double edges[100];
    int n_edges = 0, i;

    n = 0;
    for (i = 0; i <= EVEN; i++)
        add(total * i / EVEN);
    compute_rows(0);
    for (i = 0; i < EVEN && n_edges < 100; i++) {
        double low = at[i], high = at[i + 1], v[COLUMNS];

        if ((status[i] == 0) == (status[i + 1] == 0))
            continue;
        while (high - low > 1e-14 * (1 + high)) {
            double p = 0.5 * (low + high);

            *((compute(p, v) == 0) == (status[i] == 0) ? &low : &high) = p;
        }
        edges[n_edges++] = low;
    }
    add_beside(0, 1);
    add_beside(total, -1);
    for (i = 0; i < n_edges; i++) {
        add_beside(edges[i], 1);
        add_beside(edges[i], -1);
    }
    qsort(at, (size_t)n, sizeof at[0], by_size);
    compute_rows(0);
}

/* ----------------------------------------------------------------------------------------- one value */

/* The scale of a row by the rows beside it, for a column that is alone of its quantity and sought at 0: the
** smaller distance of two from the value. */
static double scale_beside(unsigned long c, double p, double value)
{
    double most[2] = {0, 0};
    int i = 0, k;

    while (i + 1 < n && at[i] < p)
        i++;
    for (k = 0; k < 3; k++) {
        if (i - 1 - k >= 0 && !status[i - 1 - k])
            most[0] = fmax(most[0], fabs(off(c, rows[i - 1 - k], value)));
        if (i + 1 + k < n && !status[i + 1 + k])
            most[1] = fmax(most[1], fabs(off(c, rows[i + 1 + k], value)));
    }
    return most[0] > 0 && most[1] > 0 ? fmin(most[0], most[1]) : fmax(most[0], most[1]);
}

static void fail(const char *what, unsigned long c, double value, double p, double by)
{
    if (!deck_failed || getenv("BRUTE_VERBOSE"))
        printf("%s: %s: %s = %.17g on the %s branch at %.12g (%.9g rad passed, off by %.2g)\n",
               deck_name, what, columns[c].name, value, fourlink_branch_text((int)branch),
               angle_of(p), p, by);
    deck_failed = 1;
}

/* Bisection between two rows; returns the place, and 1 in *is_jump if the column leaps over the value
** there. */
static double bisect(unsigned long c, double value, double low, double high, double f_low,
                     int *is_jump)
{
    double v[COLUMNS], f_high = -f_low, scale = 0;

    while (high - low > 4 * DBL_EPSILON * (1 + high)) {
        double p = 0.5 * (low + high), f;

        if (compute(p, v) != 0 || isnan(f = off(c, v, value))) {
            *is_jump = 1;
            return p;
        }
        scale = scale_of(c, v, value);
        if ((f < 0) == (f_low < 0)) {
            low = p;
            f_low = f;
        } else {
            high = p;
            f_high = f;
        }
    }
    *is_jump = !(fmax(fabs(f_low), fabs(f_high)) <= 0.1 * FALSE_BY * scale);
    return 0.5 * (low + high);
}

/* 1 if the column stays close to the value on one side of a place at least. */
static int is_touch(unsigned long c, double value, double p)
{
    double v[COLUMNS];
    int side, h;

    for (side = -1; side <= 1; side += 2) {
        double most = 0, scale = 0;

        for (h = 0; h <= 2; h++) {
            if (compute(p + side * h * SAME_ANGLE, v) != 0)
                continue;
            most = fmax(most, fabs(off(c, v, value)));
            scale = fmax(scale, scale_of(c, v, value));
        }
        if (most <= TOUCHES * scale)
            return 1;
    }
    return 0;
}

/* 1 if rounding decides: rows that are as good as one, or at the next angle that there is, differ by
** more than a crossing may, or there is none. */
static int is_rounding_error(unsigned long c, double value, double p)
{
    double v[3][COLUMNS], h, bend, slope;

    for (h = 1e-12; h < 2e-11; h *= 3) {
        int i;

        for (i = 0; i < 3; i++)
            if (compute(p + (i - 1) * h, v[i]) != 0 || isnan(v[i][c]))
                return 1;
        bend = fabs(off(c, v[0], value) - 2 * off(c, v[1], value) + off(c, v[2], value));
        slope = fabs(off(c, v[2], value) - off(c, v[0], value)) / (2 * h);
        if (fmax(4 * bend, slope * DBL_EPSILON * fabs(angle_of(p)) * angle_unit) >
            FALSE_BY * (value != 0 && !is_angle(c) ? fabs(value) : scale_of(c, v[1], value)))
            return 1;
    }
    if (compute(p - NO_ROW, v[0]) != 0 || compute(p + NO_ROW, v[2]) != 0)
        return 1;
    /* beside a pole; or links near to one line, and a column that is 0 there */
    return fmin(scale_of(c, v[0], value), scale_of(c, v[2], value)) <
               0.1 * scale_of(c, v[1], value) ||
           (value == 0 && fabs(sin(v[1][mu] * columns[mu].to_si)) < 0.05);
}

static int is_found(double p, const double *angles, unsigned long k)
{
    unsigned long i;

    for (i = 0; i < k; i++)
        if (fabs((angles[i] - angle_of(p)) * angle_unit) < SAME_ANGLE)
            return 1;
    return 0;
}

static double most_of(unsigned long c)
{
    double most = 0;
    int i;

    for (i = 0; i < n; i++)
        most = fmax(most, fabs(rows[i][c]) < 1e300 ? fabs(rows[i][c]) : 0);
    return most;
}

/* How much the column changes over the rounding of crank angles, 1e-12 of a turn: at an end of the motion a crossing so
** little beyond it counts. */
#define ROUNDED (2e-12 * PI)
#define BESIDE 1e-9 /* rad */

static double change_by_rounding(unsigned long c, double p, double value)
{
    double here[COLUMNS], beside[COLUMNS];

    if (compute(p, here) || compute(p < 0.5 * total ? p + BESIDE : p - BESIDE, beside))
        return 0;
    return fabs(off(c, beside, value) - off(c, here, value)) * ROUNDED / BESIDE;
}

static void try_value(unsigned long c, double value)
{
    static double angles[CROSSINGS];
    unsigned long k = 0, j;
    double v[COLUMNS];
    int i, is_jump;

    if (!(fabs(value) < 1e15) || (value != 0 && fabs(value) < 1e-12 * most_of(c)) ||
        fourlink_results_crossings(results, columns[c].name, branch, value, CROSSINGS, angles,
                                   &k) != FOURLINK_OK)
        return;
    sought++;
    found += (long)k;
    for (j = 0; j < k && j < CROSSINGS; j++) {
        double p = fabs(angles[j] - from) * angle_unit, by;

        if (fourlink_results_at(results, branch, angles[j], v, NULL, NULL) != FOURLINK_OK)
            continue; /* the limit at a dead position */
        by = fabs(off(c, v, value)) / fmax(scale_of(c, v, value), scale_beside(c, p, value));
        worst = fmax(worst, by <= 1 ? by : 0);
        if (by <= FALSE_BY || off(c, v, value) == 0)
            continue;
        if (fmin(p, total - p) < ROUNDED &&
            fabs(off(c, v, value)) < change_by_rounding(c, p, value))
            continue;
        wrong++;
        fail("false", c, value, p, by);
    }
    for (i = 0; i + 1 < n; i++) {
        double a = off(c, rows[i], value), b = off(c, rows[i + 1], value), p;

        if (status[i] || status[i + 1] || isnan(a) || isnan(b) || (a < 0) == (b < 0) ||
            (is_angle(c) && fabs(a - b) > 1 / columns[c].to_si))
            continue;
        is_jump = 0;
        p = bisect(c, value, at[i], at[i + 1], a, &is_jump);
        if (is_jump)
            continue;
        expected++;
        if (is_found(p, angles, k))
            continue;
        if (is_touch(c, value, p)) {
            touches++;
        } else if (is_rounding_error(c, value, p)) {
            rounded++;
        } else {
            missing++;
            fail("lost", c, value, p, NAN);
        }
    }
}

static double peak_of(unsigned long c)
{
    int i, tries;

    for (tries = 0; tries < 20; tries++) {
        i = 1 + one_of(n - 2);
        while (i + 1 < n && !((rows[i][c] - rows[i - 1][c]) * (rows[i][c] - rows[i + 1][c]) > 0))
            i++;
        if (i + 1 < n && !status[i - 1] && !status[i] && !status[i + 1]) {
            /* the top of the parabola */
            double x = at[i - 1] - at[i], y = at[i + 1] - at[i], f = rows[i - 1][c] - rows[i][c],
                   g = rows[i + 1][c] - rows[i][c], q = (f / x - g / y) / (x - y),
                   s = f / x - q * x;

            return rows[i][c] - s * s / (4 * q);
        }
    }
    return NAN;
}

/* 1 if the column is rounding error about zero: its slope changes its sign in every third step. */
static int is_rounding(unsigned long c)
{
    double most = 0;
    unsigned long k;
    int turns = 0, i;

    for (k = 0; k < n_columns; k++)
        if (strcmp(columns[k].quantity, columns[c].quantity) == 0)
            most = fmax(most, most_of(k));
    if (most_of(c) < 1e-12 * fmax(most, 1))
        return 1;
    for (i = 1; i + 1 < n; i++)
        turns += (rows[i][c] - rows[i - 1][c]) * (rows[i + 1][c] - rows[i][c]) < 0;
    return turns > n / 3 || (columns[c].flags & FOURLINK_OF_ROUNDING);
}

static void try_column(unsigned long c)
{
    int i = one_of(n - 1);

    if (is_rounding(c))
        return;
    if (!status[i] && !status[i + 1])
        try_value(c, rows[i][c] + chance() * (rows[i + 1][c] - rows[i][c]));
    try_value(c, seldom(0.3) ? 0 : peak_of(c));
}

/* The crank angles of the motion of the branch, from `from` to `end`; 0 if it has none.  Of another input the rows at its
** ends have them, also at its dead centres. */
static int find_motion(const fourlink_problem *problem)
{
    fourlink_instant first, last;

    from = problem->motion.from;
    if (problem->is_prescribed && !(branch == FOURLINK_OPEN ? problem->open : problem->crossed))
        return 0; /* it reaches another range */
    if (!problem->is_prescribed)
        return fourlink_results_end(results, branch, &end) == FOURLINK_OK && end != from;
    fourlink_results_row(results, branch, 0, NULL, &first, NULL);
    fourlink_results_row(results, branch, problem->n_rows - 1, NULL, &last, NULL);
    from = first.row.angle;
    end = last.row.angle;
    n_inputs++;
    return fabs(end - from) > 0; /* no NaN */
}

static void try_deck(fourlink_results *r)
{
    fourlink_problem problem;
    unsigned long c;

    results = r;
    fourlink_deck_problem(fourlink_results_deck(results), &problem);
    fourlink_results_list(results, FOURLINK_COLUMNS, &columns, &n_columns);
    for (mu = 0; mu + 1 < n_columns && strcmp(columns[mu].name, "mu") != 0; mu++)
        ;
    angle_unit = problem.motion.angle_unit;
    for (branch = FOURLINK_OPEN;; branch = FOURLINK_CROSSED) {
        if (find_motion(&problem)) {
            sense = end < from ? -1 : 1;
            total = fabs(end - from) * angle_unit;
            take_rows();
            for (c = 0; c < n_columns; c++)
                try_column(c);
        }
        if (branch == FOURLINK_CROSSED)
            break;
    }
}

/* Name the place or the angle of the deck's first output; 0 if it has none, and for some that have. */
static int name_output(char *name, size_t most)
{
    const char *header = strstr(deck_text, "\n[output "), *next, *line;

    if (!header || seldom(0.3))
        return 0;
    header += strlen("\n[output ");
    next = strstr(header, "\n[");
    line = strstr(header, "\nline");
    snprintf(name, most, "%.*s.%s", (int)strcspn(header, "]"), header,
             line && (!next || line < next) ? "x" : "theta");
    return 1;
}

/* The same deck, moved by another input, over all that it reaches on a side. */
static void prescribe(void)
{
    static const char *const four_bar[] = {"theta4"}, *const guided[] = {"x", "C.x"},
                             *const inverted[] = {"theta4", "slide"};
    const char *input = strstr(deck_text, "four-bar")   ? four_bar[0]
                        : strstr(deck_text, "inverted") ? inverted[one_of(2)]
                                                        : guided[one_of(2)];
    char named[60];
    int is_named = name_output(named, sizeof named);
    char *motion = strstr(deck_text, "\n[motion]"), *after;

    if (motion) {
        after = strstr(motion + 1, "\n[");
        memmove(motion, after ? after : motion + strlen(motion),
                strlen(after ? after : motion + strlen(motion)) + 1);
    }
    if (is_named)
        input = named;
    length = strlen(deck_text);
    length += (size_t)snprintf(deck_text + length, sizeof deck_text - length,
                               "\n[motion]\ninput = %s\nside = %s\nspeed = %s%.17g %s\n", input,
                               seldom(0.5) ? "falling" : "rising", seldom(0.5) ? "-" : "",
                               power_of_ten(-1, 1), strstr(input, "theta") ? "rad/s" : "m/s");
    if (is_named)
        length += (size_t)snprintf(deck_text + length, sizeof deck_text - length,
                                   "near = %.17g deg\n", between(0, 360));
}

int main(int argc, char **argv)
{
    int of_inputs = argc > 1 && strcmp(argv[1], "inputs") == 0, none;

    change_deck = of_inputs ? prescribe : NULL;
    none = try_decks(argc - of_inputs, argv + of_inputs,
                     of_inputs ? "crossings-of-inputs" : "crossings", COLUMNS, try_deck);

    printf("%ld decks, %ld refused: %ld values sought, %ld crossings found, the worst off by %.2g; "
           "%ld by bisection, of them not found %ld touches and %ld that rounding decides\n",
           n_decks, n_refused, sought, found, worst, expected, touches, rounded);
    printf("%ld of the motions by another input; %ld false, %ld lost, in %ld decks\n", n_inputs,
           wrong, missing, n_failed_decks);
    return wrong + missing > 0 || none;
}
