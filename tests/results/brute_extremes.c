/* SPDX-License-Identifier: GPL-3.0-or-later
**
** brute_extremes.c - the extremes of random decks, or of given ones, against brute force.
**
**    brute_extremes DECKS [SEED [FIRST]]     (brute_decks.h)
**    brute_extremes FILE...
**
** Each deck is opened with all columns, on both branches.  Its extremes are compared with the best of
** thousands of rows, refined by parabolas, and with the row at the angle that is told: within 1e-9 of
** the column's size, or 1e-6 near dead positions, change points and where the crank is at rest.  At a
** dead position or a change point itself, where there is no row, the limit is found by halving the
** distance; a column that doubles with each halving is unbounded there.  What the rows cannot tell, as
** their rounding is larger, is counted as undecided.  Random decks that fail are left as
** brute-SEED-NUMBER.deck.
*/
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fourlink.h"
#include "brute_decks.h"

/* -------------------------------------------------------------------------------------------- rows */

#define COLUMNS 300
#define EVEN 720 /* rows of a revolution, evenly spaced */
#define MOST 40000
#define LEFT_OUT 2e-3 /* rad beside change points, where rows are rounding */
#define SMOOTH 1e-9   /* of a column's size: by how much extremes may be off */
#define NEAR 1e-6 /* the same near dead positions, change points and where the crank is at rest */

typedef struct row {
    double passed; /* the angle, rad */
    int status;
    double v[COLUMNS];
} row;

static fourlink_results *results;
static const fourlink_value *columns;
static unsigned long n_columns, mu, omega2; /* columns of these names */
static fourlink_branch branch;
static double from, end, sense, total, angle_unit; /* of the motion: deck's unit, +-1, rad, rad */
static double fastest;                             /* largest omega2 */
static int is_revolution, has_first; /* 1: the linkage can be assembled in the first row */
static double changes[2];            /* rad passed, of change points */
static int n_changes;
static row *rows[MOST];
static size_t n;

/* The angle of a spring counts turns. */
static int counts_turns(unsigned long c)
{
    return strstr(columns[c].name, ".angle") && !(columns[c].flags & FOURLINK_DIRECTION);
}

static int is_angle(unsigned long c)
{
    return strcmp(columns[c].quantity, "angle") == 0 && !counts_turns(c);
}

static double turn_of(unsigned long c)
{
    return 2 * PI / columns[c].to_si;
}

static double angle_of(double p)
{
    return p >= total ? end : from + sense * p / angle_unit;
}

static int is_of_crank(unsigned long c)
{
    return (columns[c].flags & FOURLINK_OF_CRANK) != 0;
}

static int compute(double p, double *v)
{
    unsigned long c;
    int status = fourlink_results_at(results, branch, angle_of(p), v, NULL, NULL);

    for (c = 0; status && c < n_columns; c++)
        if (!is_of_crank(c))
            v[c] = NAN;
    return status;
}

static double leap(double x, double y, double turn)
{
    double d = (y - x) / turn;

    return fabs(d - floor(d + 0.5));
}

/* How far a value is from another one; an angle, but for whole turns. */
static double apart(unsigned long c, double x, double y)
{
    return is_angle(c) ? turn_of(c) * leap(x, y, turn_of(c)) : fabs(x - y);
}

static double beside(unsigned long c, double v, double near)
{
    return is_angle(c) ? v + turn_of(c) * floor((near - v) / turn_of(c) + 0.5) : v;
}

static int is_near_change_point(double p, double distance)
{
    int k;

    for (k = 0; k < n_changes; k++)
        if (fabs(remainder(p - changes[k], 2 * PI)) < distance)
            return 1;
    return 0;
}

/* 1 for a row near a dead position, a change point or the crank at rest: mu and omega2 are 0 there. */
static int is_near(double p, const double *v)
{
    return is_near_change_point(p, 0.05) || !(sin(v[mu] * columns[mu].to_si) > 0.05) ||
           !(fabs(v[omega2]) > 0.05 * fastest);
}

/* 1 if rows close to one another show a column as smooth, but for a tolerance: else it is rounding. */
static int is_smooth(unsigned long c, double p, double tolerance)
{
    double v[3][COLUMNS], h;

    for (h = 1e-9; h < 5e-9; h *= 1.3) {
        if (compute(p - h, v[0]) || compute(p, v[1]) || compute(p + h, v[2]))
            return 0;
        if (!(fabs(beside(c, v[0][c], v[1][c]) - 2 * v[1][c] + beside(c, v[2][c], v[1][c])) <=
              tolerance))
            return 0;
    }
    return 1;
}

/* The same; and it is rounding too if it is so small beside others of its kind, of which it may be the sum. */
static int is_steady(unsigned long c, double p, double tolerance)
{
    double v[COLUMNS];
    unsigned long k;

    if (!is_smooth(c, p, tolerance) || compute(p, v))
        return 0;
    for (k = 0; k < n_columns && !is_angle(c); k++)
        if (fabs(v[k]) * 10 * DBL_EPSILON > tolerance &&
            strcmp(columns[k].quantity, columns[c].quantity) == 0)
            return 0;
    return 1;
}

static void add(double p)
{
    row *r;

    if (n >= MOST || p < 0 || p > total || is_near_change_point(p, LEFT_OUT))
        return;
    if (!rows[n])
        rows[n] = calloc(1, sizeof *rows[n]);
    if (!rows[n])
        exit(2);
    r = rows[n++];
    r->passed = p;
    r->status = compute(p, r->v);
}

static void add_about(double p, double nearest, int side)
{
    double d;

    add(p + side * nearest);
    for (d = 0.03; d > nearest; d /= 2)
        add(p + side * d);
}

static int by_angle(const void *x, const void *y)
{
    double a = (*(row *const *)x)->passed, b = (*(row *const *)y)->passed;

    return (a > b) - (a < b);
}

static void sort_rows(void)
{
    qsort(rows, n, sizeof rows[0], by_angle);
}

static int leaps(const row *x, const row *y)
{
    unsigned long c;

    for (c = 0; c < n_columns; c++)
        if (is_angle(c) && leap(x->v[c], y->v[c], turn_of(c)) > 0.12)
            return 1;
    return 0;
}

/* ------------------------------------------------------------------------------------------- edges */

#define HALVINGS 12
#define NODES 6
#define KNOWN 1e-7 /* of a column's size: how well two limits from unlike distances agree */

typedef enum verdict { BOUNDED, UNBOUNDED, UNDECIDED } verdict;

/* A dead position or a change point. */
typedef struct edge {
    double p;
    int side; /* +1: the rows are behind it */
    int is_change;
    double v[HALVINGS][COLUMNS];
    double rough[HALVINGS][COLUMNS]; /* rounding error: second differences of close rows */
} edge;

static edge edges[100];
static int n_edges;

/* The last digit of the largest value of a column's quantity in a row: the column may be a difference of such. */
static double last_digit(unsigned long c, const double *v)
{
    double most = 0;
    unsigned long k;

    for (k = 0; k < n_columns; k++)
        if (strcmp(columns[k].quantity, columns[c].quantity) == 0 && isfinite(v[k]))
            most = fmax(most, fabs(v[k]));
    return DBL_EPSILON * most;
}

/* The rounding error of columns in a row at some distance from an edge: three rows may agree by chance. */
static void find_rough(double p, double distance, const double *v, double *rough)
{
    double h = fmax(1e-5 * distance, 1e-12 * (1 + p)), before[COLUMNS], behind[COLUMNS];
    int is_there = !compute(p - h, before) && !compute(p + h, behind);
    unsigned long c;

    for (c = 0; c < n_columns; c++)
        rough[c] = is_there ? fmax(last_digit(c, v), fabs(beside(c, before[c], v[c]) - 2 * v[c] +
                                                          beside(c, behind[c], v[c])))
                            : INFINITY;
}

/* 1 if the crank is at rest at an edge, or starts there. */
static int is_slow(double p, int side)
{
    double v[COLUMNS];

    return !compute(p + side * 1e-6, v) && !(fabs(v[omega2]) > 0.01 * fastest);
}

/* At a dead position, and where the crank starts, columns are smooth in the root of the distance. */
static void add_edge(double p, int side, int is_change)
{
    edge *e = &edges[n_edges];
    double s = 0.16;
    int i, is_root = !is_change || is_slow(p, side);

    if (n_edges == 100)
        return;
    e->p = p;
    e->side = side;
    e->is_change = is_change;
    for (i = 0; i < HALVINGS; i++, s /= 2) {
        double distance = is_root ? s * s : s, at = p + side * distance;
        unsigned long c;

        if (at < 0 || at > total || compute(at, e->v[i]))
            for (c = 0; c < n_columns; c++)
                e->v[i][c] = NAN;
        find_rough(at, distance, e->v[i], e->rough[i]);
    }
    n_edges++;
}

static void add_dead_position(double in, double out)
{
    int i, side = in > out ? 1 : -1;
    double v[COLUMNS];

    for (i = 0; i < 70; i++) {
        double middle = 0.5 * (in + out);

        if (compute(middle, v))
            out = middle;
        else
            in = middle;
    }
    add_edge(out, side, 0);
    add_about(out, 1e-6, side);
}

/* Neville's scheme at s = 0, for values at s halved again and again. */
static double neville(const double *y)
{
    double t[NODES];
    int i, j;

    memcpy(t, y, sizeof t);
    for (j = 1; j < NODES; j++)
        for (i = NODES - 1; i >= j; i--)
            t[i] += (t[i] - t[i - 1]) / (pow(2, j) - 1);
    return t[NODES - 1];
}

/* 1 if a column at least doubles, nearly, with each of the last halvings, steadily. */
static int doubles(const double *y)
{
    double growth[3];
    int i;

    for (i = 0; i < 3; i++)
        growth[i] = log2(y[HALVINGS - 3 + i] / y[HALVINGS - 4 + i]);
    return growth[0] > 0.8 && fabs(growth[1] - growth[0]) < 0.3 &&
           fabs(growth[2] - growth[0]) < 0.3;
}

/* 1 if the rows of a window are exact enough to know a limit by them: others can agree by chance. */
static int is_exact(const edge *e, unsigned long c, int window, double size)
{
    double rough = 0;
    int i;

    for (i = window; i < window + NODES; i++)
        rough = fmax(rough, e->rough[i][c]);
    return rough <= KNOWN * size;
}

/* What a column has at an edge, by the two windows of distances that agree best. */
static verdict limit_of(const edge *e, unsigned long c, double near, double size, double *limit)
{
    double y[HALVINGS], by = INFINITY, before, value = NAN, least = INFINITY;
    int i;

    *limit = NAN;
    for (i = 0; i < HALVINGS; i++) {
        y[i] = beside(c, e->v[i][c], near);
        least = fmin(least, y[i]);
        if (i > 0 && is_angle(c) && leap(y[i - 1], y[i], turn_of(c)) > 0.4)
            return UNDECIDED; /* a force passes through zero nearer than some of these rows */
    }
    if (!is_angle(c) && doubles(y)) {
        for (i = HALVINGS - 4; i < HALVINGS; i++)
            if (e->rough[i][c] > 0.1 * fabs(y[i]))
                return UNDECIDED; /* rounding error grows too */
        *limit = y[HALVINGS - 1] > 0 ? INFINITY : -INFINITY;
        return UNBOUNDED;
    }
    for (i = 0; i + NODES <= HALVINGS; i++) {
        before = value;
        value = neville(y + i);
        if (fabs(value - before) < by && is_exact(e, c, i, fmax(size, fabs(value)))) {
            by = fabs(value - before);
            *limit = value;
        }
    }
    if (least >= 0)
        *limit = fabs(*limit); /* a size, beyond its zero */
    return by <= KNOWN * fmax(size, fabs(*limit)) ? BOUNDED : UNDECIDED;
}

static void take_rows(void)
{
    size_t i, m = (size_t)(EVEN * total / (2 * PI)) + 50;
    int k, side, pass;
    double v[COLUMNS], p;

    n = 0;
    n_edges = 0;
    has_first = !compute(0, v) && !is_near_change_point(0, LEFT_OUT);
    m = m < 3000 ? m : 3000;
    for (i = 0; i < m; i++)
        add(total * (double)i / (double)m);
    add(total);
    add_about(0, 1e-8, 1);
    add_about(total, 1e-8, -1);
    for (k = 0; k < n_corners; k++)
        for (p = fmod(fmod(sense * (corners[k] - from * angle_unit), 2 * PI) + 2 * PI, 2 * PI);
             p <= total; p += 2 * PI) {
            add(p);
            add_about(p, 2e-11, 1);
            add_about(p, 2e-11, -1);
        }
    sort_rows();
    fastest = 0;
    for (i = 0; i < n; i++)
        fastest = fmax(fastest, fabs(rows[i]->v[omega2]));
    m = n;
    for (i = 0; i + 1 < m; i++)
        if (!rows[i]->status != !rows[i + 1]->status) {
            k = rows[i]->status != 0;
            add_dead_position(rows[i + (size_t)k]->passed, rows[i + (size_t)!k]->passed);
        }
    for (k = 0; k < n_changes; k++)
        for (p = fmod(fmod(changes[k], 2 * PI) + 2 * PI, 2 * PI); p <= total + 1e-9; p += 2 * PI)
            for (side = -1; side <= 1; side += 2)
                if (p + side * 1e-3 > 0 && p + side * 1e-3 < total)
                    add_edge(p, side, 1);
    sort_rows();
    for (pass = 0; pass < 60; pass++) {
        m = n;
        for (i = 0; i + 1 < m; i++)
            if (rows[i + 1]->passed - rows[i]->passed > 1e-12 * (1 + total) &&
                leaps(rows[i], rows[i + 1]))
                add(0.5 * (rows[i]->passed + rows[i + 1]->passed));
        if (n == m)
            break;
        sort_rows();
    }
}

/* ------------------------------------------------------------------------------------ one column */

static double curve[MOST]; /* of the column, angles going on */

#define NEAR_HALF 1e-5 /* of a turn */

/* 1 if the rows say how the angle goes on. */
static int follow(unsigned long c)
{
    double turn = turn_of(c), last = NAN, first = rows[0]->v[c];
    size_t i, start = 0;
    int has_gap = 0;

    for (i = 0; i < n; i++) {
        double v = rows[i]->v[c], by;
        int status = rows[i]->status;

        curve[i] = v;
        if (status && status != FOURLINK_CHANGE_POINT && status != FOURLINK_DEAD_POSITION &&
            !is_of_crank(c)) {
            last = NAN;
            start = i;
            has_gap = 1;
        }
        if (isnan(v))
            continue;
        if (isnan(last) && i > 0 && 0.5 - leap(0, v, turn) < NEAR_HALF)
            return 0; /* it begins at an edge, with 180 or -180 deg: that is rounding */
        by = leap(last, v, turn);
        if (by > 0.5 - 1e-3 && by <= 0.5 - 1e-10)
            return 0;
        if (by > 0.5 - 1e-6)
            start = i;
        else if (!isnan(last))
            curve[i] = beside(c, v, last);
        last = curve[i];
    }
    if (has_gap && is_revolution && leap(first, rows[n - 1]->v[c], turn) < 1e-9) {
        double shift = turn * floor((first - curve[n - 1]) / turn + 0.5);

        for (i = start; i < n; i++)
            curve[i] += shift;
    }
    return 1;
}

/* A direction where there is no force is noise; at a change point it can turn over, nearer than the rows
** go. */
static int is_noise(unsigned long c)
{
    size_t length_of_force = strlen(columns[c].name) - 4, i, zeros = 0;
    double most = 0, force = 0;
    unsigned long f, k;

    if (!strstr(columns[c].name, "_dir"))
        return 0;
    for (i = 0; i < (size_t)n_edges; i++)
        if (edges[i].is_change)
            return 1;
    for (f = 0; f < n_columns; f++)
        if (strlen(columns[f].name) == length_of_force &&
            memcmp(columns[f].name, columns[c].name, length_of_force) == 0)
            break;
    for (i = 0; i < n && f < n_columns; i++) {
        for (k = 0; k < n_columns; k++)
            if (strcmp(columns[k].quantity, "force") == 0)
                force = fmax(force, fabs(rows[i]->v[k]));
        most = fmax(most, rows[i]->v[f]);
    }
    for (i = 0; i < n && f < n_columns; i++)
        zeros += rows[i]->v[f] <= 1e-7 * most;
    return f == n_columns || most < 1e-9 * force || zeros > 40;
}

/* 1 for a column that is 0 but for rounding, by ten of its rows. */
static int is_rounding(unsigned long c)
{
    size_t i, next = 0;
    int rough = 0, used = 0;

    for (i = 0; i < n && used < 10; i++)
        if (i >= next && !rows[i]->status && fabs(rows[i]->v[c]) > 0) {
            rough += !is_steady(c, rows[i]->passed, 1e-3 * fabs(rows[i]->v[c]));
            used++;
            next = i + n / 20;
        }
    return 2 * rough > used;
}

/* The best of a column: of rows far from all edges, of those near one that are no rounding, and of limits. */
enum { FAR_ROWS, NEAR_ROWS, LIMITS };

typedef struct best {
    double value[3], at[3];
    int is_infinite, is_open; /* there is a pole; the rows cannot tell */
} best;

/* The value of a column in its row next to an edge. */
static double row_beside(const edge *e)
{
    double nearest = INFINITY, value = NAN;
    size_t i;

    for (i = 0; i < n; i++) {
        double away = e->side * (rows[i]->passed - e->p);

        if (!isnan(curve[i]) && away > 0 && away < nearest) {
            nearest = away;
            value = curve[i];
        }
    }
    return value;
}

static void offer(best *b, int kind, int sign, double value, double at)
{
    if (isfinite(value) && !(sign * value <= sign * b->value[kind])) {
        b->value[kind] = value;
        b->at[kind] = at;
    }
}

static void find_limits(unsigned long c, int sign, double size, best *b)
{
    double limit;
    int k;

    for (k = 0; k < n_edges && !is_of_crank(c); k++)
        switch (limit_of(&edges[k], c, row_beside(&edges[k]), size, &limit)) {
        case UNBOUNDED:
            b->is_infinite |= sign * limit > 0;
            break;
        case BOUNDED:
            offer(b, LIMITS, sign, limit, edges[k].p);
            break;
        default:
            b->is_open = 1;
        }
}

/* Parabolas through three rows, ever closer about the top. */
static void refine(unsigned long c, int sign, size_t i, best *b)
{
    double x = rows[i]->passed, y = curve[i], low = rows[i - 1]->passed, high = rows[i + 1]->passed;
    double left = curve[i - 1], right = curve[i + 1], v[COLUMNS], h;

    for (h = (high - low) / 16; h >= 1e-7; h /= 8) {
        double d0 = x - low, d1 = high - x, s0 = (y - left) / d0, s1 = (right - y) / d1;
        double top = x - (s0 * d1 + s1 * d0) / (2 * (s1 - s0));

        if (!isfinite(top))
            break;
        top = fmin(fmax(top, low), high);
        if (!is_near_change_point(top, LEFT_OUT) && !compute(top, v) &&
            sign * beside(c, v[c], y) > sign * y) {
            x = top;
            y = beside(c, v[c], y);
        }
        low = x - h;
        high = x + h;
        left = compute(low, v) ? NAN : beside(c, v[c], y);
        right = compute(high, v) ? NAN : beside(c, v[c], y);
    }
    offer(b, FAR_ROWS, sign, y, x);
}

static best find(unsigned long c, int sign, double size)
{
    best b = {{NAN, NAN, NAN}, {0, 0, 0}, 0, 0};
    int peaks = 0, near;
    size_t i;

    for (i = 0; i < n; i++) {
        near = is_near(rows[i]->passed, rows[i]->v);
        if (!near || (!(sign * curve[i] <= sign * b.value[NEAR_ROWS]) &&
                      is_steady(c, rows[i]->passed, 0.1 * NEAR * size)))
            offer(&b, near, sign, curve[i], rows[i]->passed);
    }
    for (i = 1; i + 1 < n && peaks < 20; i++) {
        double bend = fabs(curve[i - 1] - 2 * curve[i] + curve[i + 1]);

        if (!is_near(rows[i]->passed, rows[i]->v) && bend > 1e-12 * fabs(curve[i]) &&
            sign * curve[i] >= fmax(sign * curve[i - 1], sign * curve[i + 1]) &&
            sign * curve[i] + 2 * bend >= sign * b.value[FAR_ROWS]) {
            refine(c, sign, i, &b);
            peaks++;
        }
    }
    find_limits(c, sign, size, &b);
    return b;
}

/* 1 for the columns that are unbounded beyond 1e9, which pass through infinity between rows. */
static int has_bound(unsigned long c)
{
    static const char *const names[] = {
        "mechanical_advantage", "I13x", "I13y", "I24x", "klein_IX", "klein_IY", NULL};
    int i;

    for (i = 0; names[i] && strcmp(columns[c].name, names[i]); i++)
        ;
    return names[i] != NULL;
}

/* 1 if a column changes sign at a pole between rows.  The parts are uneven, as a row at a pole has no
** value. */
static int has_pole(unsigned long c)
{
    double v[COLUMNS];
    size_t i, next;
    int k;

    for (i = 0; i + 1 < n; i = next) {
        double low = rows[i]->passed, high, middle, most = 0;

        for (next = i + 1; next + 1 < n && isnan(curve[next]) && !rows[next]->status; next++)
            ;
        high = rows[next]->passed;
        for (k = 0; k < 60 && curve[i] * curve[next] < 0; k++) {
            middle = low + 0.47 * (high - low);
            if (compute(middle, v))
                break;
            most = fmax(most, fabs(v[c]));
            if ((v[c] > 0) == (curve[i] > 0))
                low = middle;
            else
                high = middle;
        }
        if (most * columns[c].to_si >= 1e9)
            return 1;
    }
    return 0;
}

/* 1 if a column grows to infinity on one side of the angle that is told: a pole narrower than the rows.  At distances
** that are each a tenth of the one before, a number that is added does not matter to the steps between rows. */
static int grows_from(unsigned long c, const fourlink_value *f, double p, double h)
{
    double v[3][COLUMNS];

    return !compute(p + h, v[0]) && !compute(p + h / 10, v[1]) && !compute(p + h / 100, v[2]) &&
           (v[2][c] - v[1][c]) * f->value > 0 &&
           fabs(v[2][c] - v[1][c]) > 5 * fabs(v[1][c] - v[0][c]);
}

/* Next to a place far away rows have no value. */
static int grows(unsigned long c, const fourlink_value *f)
{
    double p = sense * (f->angle - from) * angle_unit, h;

    for (h = 1e-7; h < 2e-5; h *= 10)
        if (grows_from(c, f, p, h) || grows_from(c, f, p, -h))
            return 1;
    return 0;
}

/* ------------------------------------------------------------------------------------- comparison */

typedef struct kind {
    char name[40];
    long tried, undecided;
    double missed, attained; /* worst errors far from all edges, by size */
} kind;

static kind kinds[50];
static int n_kinds;
static long tried, undecided, failed, unbounded, limits;

static kind *kind_of(unsigned long c)
{
    int i;

    for (i = 0; i < n_kinds; i++)
        if (!strcmp(kinds[i].name, columns[c].quantity))
            return &kinds[i];
    snprintf(kinds[n_kinds].name, sizeof kinds[0].name, "%s", columns[c].quantity);
    return &kinds[n_kinds++];
}

static void fail(const fourlink_value *f, const char *what, double value, double p, double error)
{
    printf("%s %s %-22s %s: told %.15g at %.15g, rows %.15g at %.15g (error %.2g)\n", deck_name,
           branch == FOURLINK_OPEN ? "open   " : "crossed", f->name, what, f->value, f->angle,
           value, angle_of(p), error);
    failed++;
    deck_failed = 1;
}

/* How far a value is from what the column has just before or behind a place, where it may jump. */
static double apart_beside(unsigned long c, double p, double value)
{
    double v[2][COLUMNS], h = 1e-8, least = INFINITY;
    int side;

    for (side = -1; side <= 1; side += 2)
        if (!compute(p + side * h, v[0]) && !compute(p + 2 * side * h, v[1]))
            least = fmin(least, apart(c, v[0][c] - (beside(c, v[1][c], v[0][c]) - v[0][c]), value));
    return least;
}

/* How far a value is from the rows within TOLD of an angle, by their slope there, on the better side: a column may
** jump at the angle. */
#define TOLD (1e-5 * PI / 180) /* rad, to which the angle of an extreme is told */

static double apart_about(unsigned long c, double p, double value)
{
    double at[COLUMNS], v[COLUMNS], least = INFINITY;
    int i;

    for (i = 0; i < 4; i++) {
        int side = i % 2 ? 1 : -1;

        if (!compute(p + (i < 2 ? 0 : side * 1e-8), at) && !compute(p + side * TOLD, v))
            least = fmin(least, apart(c, at[c], value) - apart(c, v[c], at[c]));
    }
    return fmax(least, 0);
}

/* 1 if a finite extreme is the value of the row at its angle, or a limit there; sets *is_open where the
** rows cannot tell.  A row may have no value, between others. */
static int is_attained(unsigned long c, const fourlink_value *f, double size, int *is_open)
{
    double p = sense * (f->angle - from) * angle_unit, v[COLUMNS], limit, far = INFINITY;
    int near = 1, k;

    if (!compute(p, v) || is_of_crank(c)) {
        near = is_near(p, v);
        if (isnan(v[c]))
            near = !compute(p + (p < total / 2 ? 1e-7 : -1e-7), v);
        far = apart(c, v[c], f->value);
        far = !is_angle(c) && far <= 4 * last_digit(c, v) ? 0 : far / size;
        if (far > SMOOTH)
            far = fmin(far, fmin(apart_beside(c, p, f->value), apart_about(c, p, f->value)) / size);
    }
    if (!near)
        kind_of(c)->attained = fmax(kind_of(c)->attained, far);
    for (k = 0; k < n_edges && !(far <= NEAR); k++)
        if (fabs(edges[k].p - p) < 1e-6) {
            if (limit_of(&edges[k], c, f->value, size, &limit) == BOUNDED)
                far = apart(c, limit, f->value) / size;
            else
                *is_open = 1;
        }
    if (near && isfinite(far) && far > NEAR && !is_steady(c, p, 0.1 * NEAR * size))
        *is_open = 1;
    return *is_open || far <= (near ? NEAR : SMOOTH);
}

/* The rounding error of a row. */
static double rounding_at(unsigned long c, double p)
{
    double v[COLUMNS];

    return compute(p, v) ? 0 : 4 * last_digit(c, v);
}

static void compare(unsigned long c, const fourlink_value *f, best *b, double size)
{
    int sign = f->name[1] == 'a' ? 1 : -1, k;
    double most = NAN, by;

    if (isinf(f->value)) {
        unbounded++;
        if (sign * f->value < 0 || !(b->is_infinite || b->is_open || grows(c, f)))
            fail(f, "unbounded", b->value[FAR_ROWS], b->at[FAR_ROWS], INFINITY);
        return;
    }
    if (b->is_infinite) {
        fail(f, "bounded", NAN, 0, INFINITY);
        return;
    }
    for (k = FAR_ROWS; k <= LIMITS; k++)
        most = sign * fmax(sign * most, sign * b->value[k]);
    limits += most == b->value[LIMITS];
    for (k = FAR_ROWS; k <= LIMITS; k++) {
        by = b->value[k] - f->value;
        if (is_angle(c) && !has_first)
            by += beside(c, most, f->value) - most;
        if (!is_angle(c) && by * sign <= rounding_at(c, b->at[k]))
            continue;
        by *= sign /
              fmax(size,
                   fabs(f->value)); /* a finite one may be far above an unbounded column's median */
        if (k == FAR_ROWS)
            kind_of(c)->missed = fmax(kind_of(c)->missed, by);
        if (by > (k == FAR_ROWS ? SMOOTH : NEAR)) {
            if (k == FAR_ROWS && !is_smooth(c, b->at[k], 0.1 * SMOOTH * size)) {
                b->is_open = 1;
                continue;
            }
            fail(f, k == LIMITS ? "limit" : "missed", b->value[k], b->at[k], by);
            return;
        }
    }
    if (size > 0 && !is_attained(c, f, size, &b->is_open))
        fail(f, "not the row's", NAN, 0, INFINITY);
}

static int by_value(const void *x, const void *y)
{
    double a = *(const double *)x, b = *(const double *)y;

    return (a > b) - (a < b);
}

/* Largest magnitude far from all edges; the median of what is unbounded, or has rows near them only. */
static double size_of_column(int is_unbounded)
{
    static double sorted[MOST];
    double most = 0;
    size_t i, m = 0;

    for (i = 0; i < n; i++)
        if (isfinite(curve[i])) {
            sorted[m++] = fabs(curve[i]);
            if (!is_near(rows[i]->passed, rows[i]->v))
                most = fmax(most, fabs(curve[i]));
        }
    if (!m || (most > 0 && !is_unbounded))
        return most;
    qsort(sorted, m, sizeof sorted[0], by_value);
    return sorted[m / 2];
}

static void compare_column(unsigned long c, const fourlink_value *const told[2])
{
    int ok = 1, is_pole, which;
    double size;
    size_t i;

    if (is_angle(c))
        ok = follow(c) && !is_noise(c);
    else
        for (i = 0; i < n; i++)
            curve[i] = isinf(rows[i]->v[c]) ? NAN : rows[i]->v[c]; /* has_pole sees it */
    ok = ok && !is_rounding(c);
    if (!ok && !told[0])
        return; /* a direction that only rounding has */
    is_pole = has_bound(c) && has_pole(c);
    size = size_of_column(is_pole || (told[0] && isinf(told[0]->value)) ||
                          (told[1] && isinf(told[1]->value)));
    for (which = 0; which < 2; which++) {
        best b = find(c, which == 0 ? 1 : -1, size);

        if (isnan(b.value[FAR_ROWS]) && isnan(b.value[NEAR_ROWS]) &&
            (!told[which] || isinf(rows[n / 2]->v[c])))
            continue; /* the advantage of a piston at rest is infinite in all rows */
        if (!told[which]) {
            printf("%s %s: found %g, told nothing\n", deck_name, columns[c].name, b.value[0]);
            failed++;
            deck_failed = 1;
            continue;
        }
        b.is_infinite |= is_pole;
        b.is_open |= !ok;
        if (ok)
            compare(c, told[which], &b, size);
        tried++;
        kind_of(c)->tried++;
        undecided += b.is_open;
        kind_of(c)->undecided += b.is_open;
    }
}

static void compare_columns(const fourlink_value *facts, unsigned long n_facts)
{
    unsigned long c, i;

    for (c = 0; c < n_columns; c++) {
        const fourlink_value *told[2] = {NULL, NULL};

        if (columns[c].flags & (FOURLINK_CRANK_ANGLE | FOURLINK_OF_ROUNDING))
            continue;
        for (i = 0; i < n_facts; i++)
            if (strlen(facts[i].name) == strlen(columns[c].name) + 5 &&
                !memcmp(facts[i].name + 4, columns[c].name, strlen(columns[c].name)))
                told[facts[i].name[1] == 'a' ? 0 : 1] = &facts[i];
        compare_column(c, told);
    }
}

/* ------------------------------------------------------------------------------------------ a deck */

static void list_change_points(void)
{
    fourlink_problem problem;
    double line;

    n_changes = 0;
    fourlink_deck_problem(fourlink_results_deck(results), &problem);
    line = problem.mechanism.design.kind == FOURLINK_SLIDER_CRANK ? -PI / 2 : 0;
    if (problem.mechanism.change_folded)
        changes[n_changes++] = sense * (line - from * angle_unit);
    if (problem.mechanism.change_stretched)
        changes[n_changes++] = sense * (line + PI - from * angle_unit);
}

static unsigned long column_named(const char *name)
{
    unsigned long c;

    for (c = 0; c + 1 < n_columns && strcmp(columns[c].name, name); c++)
        ;
    return c;
}

/* 1 if the load of the spring whose angle column c is depends on its turns. */
static int feels_turns(unsigned long c)
{
    size_t size = (size_t)(strstr(columns[c].name, ".angle") - columns[c].name);
    fourlink_spring spring;
    const char *name;
    unsigned long i;

    for (i = 0;
         fourlink_deck_spring(fourlink_results_deck(results), i, &name, &spring) == FOURLINK_OK;
         i++)
        if (strlen(name) == size && !strncmp(name, columns[c].name, size))
            return spring.stiffness != 0 || spring.only;
    return 0;
}

/* 1 if a torsional spring is wound up by the motion: nothing repeats. */
static int is_wound(void)
{
    static const fourlink_branch branches[] = {FOURLINK_OPEN, FOURLINK_CROSSED};
    double first[COLUMNS], last[COLUMNS];
    unsigned long c;
    int i, winds = 0;

    for (i = 0; i < 2; i++)
        if (fourlink_results_at(results, branches[i], from, first, NULL, NULL) == FOURLINK_OK &&
            fourlink_results_at(results, branches[i], end, last, NULL, NULL) == FOURLINK_OK)
            for (c = 0; c < n_columns; c++)
                winds |= counts_turns(c) && feels_turns(c) &&
                         fabs(last[c] - first[c]) * columns[c].to_si > 1;
    return winds;
}

/* Take the motion of a deck from its results. */
static void take_motion(fourlink_results *r)
{
    fourlink_problem problem;
    fourlink_range range;

    results = r;
    fourlink_deck_problem(fourlink_results_deck(results), &problem);
    fourlink_motion_range(&problem.motion, &range);
    fourlink_results_list(results, FOURLINK_COLUMNS, &columns, &n_columns);
    angle_unit = problem.motion.angle_unit;
    from = problem.motion.from;
    if (range.stops) {
        end = range.stop_angle;
    } else {
        double *v = malloc(n_columns * sizeof *v);

        fourlink_results_row(results, FOURLINK_OPEN, range.n_rows - 1, v, NULL, NULL);
        end = v[0]; /* theta2 */
        free(v);
    }
    sense = end < from ? -1 : 1;
    total = fabs(end - from) * angle_unit;
    is_revolution = problem.one_revolution && problem.motion.run_up <= 0 && !range.stops &&
                    (problem.motion.acceleration == 0 || problem.motion.hold) && !is_wound();
}

static void try_deck(fourlink_results *r)
{
    const fourlink_value *facts;
    unsigned long n_facts;
    int k;

    take_motion(r);
    list_change_points();
    mu = column_named("mu");
    omega2 = column_named("omega2");
    for (k = 0; k < 2; k++) {
        branch = k == 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;
        if (fourlink_results_facts(results, (int)branch, FOURLINK_FACTS_EXTREMES, &facts,
                                   &n_facts) == FOURLINK_BAD_BRANCH)
            break; /* a Scotch yoke has one */
        take_rows();
        compare_columns(facts, n_facts);
    }
}

int main(int argc, char **argv)
{
    int none = try_decks(argc, argv, "brute", COLUMNS, try_deck), k;

    printf("%ld decks, %ld refused: %ld extremes, %ld unbounded, %ld limits, %ld undecided\n",
           n_decks, n_refused, tried, unbounded, limits, undecided);
    printf("%-22s %9s %9s %12s %12s\n", "quantity", "extremes", "undecided", "missed by",
           "off the row");
    for (k = 0; k < n_kinds; k++)
        printf("%-22s %9ld %9ld %12.2g %12.2g\n", kinds[k].name, kinds[k].tried, kinds[k].undecided,
               kinds[k].missed, kinds[k].attained);
    printf("%ld extremes of %ld decks wrong\n", failed, n_failed_decks);
    return failed > 0 || none;
}
