/* SPDX-License-Identifier: GPL-3.0-or-later
**
** brute_extremes.c - the extremes of random decks against brute force.
**
**    brute_extremes DECKS [SEED [FIRST]]
**
** Each deck is opened with all columns, on both branches.  Its extremes are compared with those of thousands of
** rows, denser towards all places where something happens, the best of them refined on rows.  An extreme is right
** if no row is better and the row at its angle has its value, both within 1e-9 of the column's size; those within
** 1e-8 are counted.  At the edges of reach and at change points, where there is no row, limits are found by halving
** the distance.  What the rows cannot decide, as their rounding is larger, is counted as undecided.  Decks that
** fail are left as brute-SEED-NUMBER.deck.
*/
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fourlink.h"

#define PI 3.14159265358979323846
#define EVEN 720 /* rows of a revolution, evenly spaced */
#define MOST 40000
#define TOLERANCE 1e-9
#define DOUBT 100 /* times the error that a limit says it has */

/* ------------------------------------------------------------------------------------------- chance */

static unsigned long long state;

static double chance(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) / 9007199254740992.0;
}

static double between(double low, double high)
{
    return low + (high - low) * chance();
}

static int one_of(int n)
{
    return (int)(n * chance());
}

static int seldom(double share)
{
    return chance() < share;
}

/* ------------------------------------------------------------------------------------------- decks */

static char text[20000];
static size_t length;
static double corners[200]; /* rad; where something happens, in every cycle */
static int n_corners;

static void write(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    length += (size_t)vsnprintf(text + length, sizeof text - length, format, arguments);
    va_end(arguments);
}

static void write_mass(double link)
{
    if (seldom(0.15))
        return;
    write("mass = %.17g kg\ninertia = %.17g kg m2\n", between(0.1, 5), between(0.001, 0.2) * link);
    if (seldom(0.8))
        write("cg = (%.17g, %.17g) m\n", between(-0.1, 1) * link,
              seldom(0.5) ? 0 : between(-0.3, 0.3) * link);
}

/* Lengths that make a change point, as sums of sixteenths, which are exact. */
static void set_change_point(double *d)
{
    double x = (1 + one_of(15)) / 16.0, y = (1 + one_of(15)) / 16.0, z = (1 + one_of(15)) / 16.0;

    switch (one_of(4)) {
    case 0: /* parallelogram */
        d[0] = d[2] = x;
        d[1] = d[3] = y;
        break;
    case 1: /* deltoid */
        d[0] = d[1] = x;
        d[2] = d[3] = y;
        break;
    case 2:
        d[0] = x;
        d[1] = y;
        d[2] = z;
        d[3] = fabs(x + y - z);
        break;
    default:
        d[0] = x;
        d[1] = fabs(x + y - z);
        d[2] = z;
        d[3] = y;
        break;
    }
}

static int can_be_assembled(const double *d)
{
    double sum = d[0] + d[1] + d[2] + d[3];
    int i;

    for (i = 0; i < 4; i++)
        if (!(d[i] > 1e-3) || 2 * d[i] > sum * (1 - 1e-4))
            return 0;
    return 1;
}

static void write_four_bar(double unit)
{
    static const char *const names[] = {"ground", "crank", "coupler", "rocker"};
    double d[4]; /* ground, crank, coupler, rocker */
    int i, how = one_of(10);

    do {
        for (i = 0; i < 4; i++)
            d[i] = between(0.1, 1);
        if (how < 3)
            d[1] = between(0.05, 0.3); /* most of them crank-rockers */
        if (how >= 7)
            set_change_point(d);
        if (how == 9)
            d[one_of(4)] *= 1 + (seldom(0.5) ? -1 : 1) * pow(10, between(-3, -2));
    } while (!can_be_assembled(d));
    write("mechanism = four-bar\n");
    for (i = 0; i < 4; i++) {
        write("[%s]\nlength = %.17g m\n", names[i], d[i] * unit);
        if (i > 0)
            write_mass(d[i] * unit);
        else if (seldom(0.3))
            write("angle = %.17g deg\n", between(-180, 180));
    }
}

static void write_curve(const char *name, double low, double high, const char *unit, double cycle)
{
    int n = 3 + one_of(9), i;

    write("%s = ", name);
    for (i = 0; i < n; i++) {
        double at = floor(cycle * (i + between(0.1, 0.9)) / n);

        corners[n_corners++] = at * PI / 180;
        write("%s%g deg %.17g %s", i ? ", " : "", at, between(low, high), unit);
    }
    write("\n");
}

static void write_slider_crank(double unit, double cycle)
{
    double r = between(0.1, 1), l = r * between(1.2, 4),
           e = seldom(0.5) ? 0 : between(-0.3, 0.3) * r;
    int how = one_of(10);

    if (how < 2)
        l = r * between(0.4, 1.2);
    if (how >= 8) {
        r = (2 + one_of(14)) / 16.0;
        e = seldom(0.5) ? 0 : r / 2 * (seldom(0.5) ? 1 : -1);
        l = r + e;
    }
    if (how == 9)
        l *= 1 + (seldom(0.5) ? -1 : 1) * pow(10, between(-3, -2));
    write("mechanism = slider-crank\n[ground]\noffset = %.17g m\n", e * unit);
    if (seldom(0.3))
        write("angle = %.17g deg\n", between(-180, 180));
    write("[crank]\nlength = %.17g m\n", r * unit);
    write_mass(r * unit);
    write("[rod]\nlength = %.17g m\n", l * unit);
    write_mass(l * unit);
    write("[piston]\n");
    if (seldom(0.8))
        write("mass = %.17g kg\n", between(0.1, 5));
    if (seldom(0.5)) {
        write("[gas]\nbore = %.17g m\n", between(0.1, 0.5) * r * unit);
        if (seldom(0.4))
            write("pressure = %.17g Pa\n", between(0, 2e6));
        else
            write_curve("indicator", 2e4, 3e6, "Pa", cycle);
    }
}

/* Crank and slotted lever, Whitworth's quick return, oscillating cylinder; some with a change point. */
static void write_inverted(double unit, double cycle)
{
    double d = between(0.2, 1), a = d * between(0.2, 2.5),
           h = seldom(0.5) ? 0 : between(-0.5, 0.5) * a;

    if (seldom(0.2)) {
        d = (1 + one_of(15)) / 16.0;
        a = (1 + one_of(15)) / 16.0;
        h = a - d;
    }
    write("mechanism = inverted-slider-crank\n[ground]\nlength = %.17g m\n", d * unit);
    if (seldom(0.3))
        write("angle = %.17g deg\n", between(-180, 180));
    write("[crank]\nlength = %.17g m\n", a * unit);
    write_mass(a * unit);
    write("[slider]\n");
    write_mass(0.3 * unit);
    write("[lever]\noffset = %.17g m\n", h * unit);
    write_mass(d * unit);
    if (seldom(0.3)) {
        write("[gas]\nbore = %.17g m\n", between(0.1, 0.3) * a * unit);
        if (seldom(0.4))
            write("pressure = %.17g Pa\n", between(0, 2e6));
        else
            write_curve("indicator", 2e4, 3e6, "Pa", cycle);
    }
}

static void write_loads(int slides, double unit, double cycle)
{
    static const char *const links[3][3] = {
        {"crank", "coupler", "rocker"}, {"crank", "rod", "piston"}, {"crank", "slider", "lever"}};
    int n = one_of(3), i;

    for (i = 0; i < n; i++) {
        int link = one_of(3), turns = !(slides == 1 && link == 2),
            has_torque = turns && seldom(0.6);

        write("[load L%d]\nlink = %s\n", i, links[slides][link]);
        if (!has_torque || seldom(0.4)) {
            write("force = (%.17g, %.17g) N\n", between(-200, 200), between(-200, 200));
            if (turns)
                write("at = (%.17g, %.17g) m\nframe = %s\n", between(-0.5, 1) * unit,
                      between(-0.5, 0.5) * unit, seldom(0.5) ? "link" : "ground");
        }
        if (has_torque && seldom(0.5))
            write_curve("torque", -50, 50, "N m", cycle);
        else if (has_torque)
            write("torque = %.17g N m\n", between(-50, 50));
        if (seldom(0.4)) {
            double from = between(-180, 500), to = from + between(1, 0.9 * cycle);

            write("from = %.17g deg\nto = %.17g deg\n", from, to);
            corners[n_corners++] = from * PI / 180;
            corners[n_corners++] = to * PI / 180;
        }
    }
}

static void write_motion(double cycle)
{
    double speed = pow(10, between(0, 2.5)) * (seldom(0.5) ? -1 : 1);
    double turn = speed > 0 ? 1 : -1, from = seldom(0.5) ? 0 : between(-360, 360);
    double interval = (double)(1 + one_of(30)), range;

    write("[motion]\ninterval = %g deg\ncycle = %g deg\n", interval, cycle);
    switch (one_of(8)) {
    case 0: /* from rest */
        write("run_up = %.17g deg\nacceleration = %.17g rad/s2\n", between(5, 400),
              turn * between(1, 100));
        return;
    case 1: /* faster, or slower until it stops */
        write("acceleration = %.17g rad/s2\n", between(-0.1, 0.1) * speed * speed);
        range = between(30, 500);
        break;
    case 2:
        write("hold = yes\nacceleration = %.17g rad/s2\n", between(-1, 1) * speed * speed);
        range = cycle;
        break;
    case 3:
        range = between(30, 360);
        break;
    case 4:
        range = between(360, 1500);
        break;
    default:
        range = cycle;
        break;
    }
    write("speed = %.17g rad/s\n", speed);
    if (from != 0 || range != cycle)
        write("from = %.17g deg\nto = %.17g deg\n", from, from + turn * range);
}

static void make_deck(void)
{
    double cycle = seldom(0.2) ? 720 : 360, unit = pow(10, between(-1.5, 0.5));
    static const char *const carriers[] = {"coupler", "rod", "slider"};
    int slides = seldom(0.35) ? 1 : seldom(0.25) ? 2 : 0, n = one_of(3), i;

    length = 0;
    n_corners = 0;
    if (seldom(0.9))
        write("solver = dyad\n");
    if (slides == 1)
        write_slider_crank(unit, cycle);
    else if (slides == 2)
        write_inverted(unit, cycle);
    else
        write_four_bar(unit);
    write_loads(slides, unit, cycle);
    if (seldom(0.5))
        write("[gravity]\nacceleration = %s m/s2\ndirection = %.17g deg\n",
              seldom(0.5) ? "0" : "9.81", between(-180, 180));
    write_motion(cycle);
    for (i = 0; i < n; i++)
        write("[point P%d]\nlink = %s\nat = (%.17g, %.17g) m\n", i,
              seldom(0.7) ? carriers[slides] : "crank", between(-1, 1) * unit,
              between(-1, 1) * unit);
    write("[table]\ncolumns = all\n");
    for (i = 0; i < 4; i++)
        corners[n_corners++] = i * PI / 2;
}

/* -------------------------------------------------------------------------------------------- rows */

#define COLUMNS 300

typedef struct row {
    double passed; /* the angle, rad */
    int status;
    double v[COLUMNS];
    double *
        noise; /* by how much rounding changes each column here; null: unknown, far from all edges */
} row;

static fourlink_results *results;
static const fourlink_value *columns;
static unsigned long n_columns;
static fourlink_branch branch;
static double from, end, sense, total, unit; /* of the motion: deck's unit, +-1, rad in all, rad */
static int is_revolution, has_first;         /* 1: the linkage can be assembled in the first row */
static double singular[8]; /* rad passed, of dead positions and change points in one turn */
static int n_singular;
static double changes[2]; /* rad passed, of change points */
static int n_changes;
static row *rows[MOST];
static size_t n;

static int is_turning[COLUMNS];         /* 1: an angle */
static unsigned long quantity[COLUMNS]; /* the first column with the same */

static int is_angle(unsigned long c)
{
    return is_turning[c];
}

static void list_quantities(void)
{
    unsigned long c;

    for (c = 0; c < n_columns; c++) {
        is_turning[c] = strcmp(columns[c].quantity, "angle") == 0;
        for (quantity[c] = 0; strcmp(columns[quantity[c]].quantity, columns[c].quantity);)
            quantity[c]++;
    }
}

static double turn_of(unsigned long c)
{
    return 2 * PI / columns[c].to_si;
}

static double angle_of(double p)
{
    return p >= total ? end : from + sense * p / unit;
}

static int compute(double p, double *v)
{
    unsigned long c;
    int status = fourlink_results_at(results, branch, angle_of(p), v, NULL, NULL);

    for (c = 0; status && c < n_columns; c++)
        if (!(columns[c].flags & FOURLINK_OF_CRANK))
            v[c] = NAN;
    return status;
}

static double leap(double x, double y, double turn)
{
    double d = (y - x) / turn;

    return fabs(d - floor(d + 0.5));
}

static double edge_distance(double p)
{
    double away = PI;
    int k;

    for (k = 0; k < n_singular; k++)
        away = fmin(away, fabs(remainder(p - singular[k], 2 * PI)));
    return away;
}

/* 1 where rows may be rounding: near dead positions and change points. */
static int is_near_edge(double p)
{
    return edge_distance(p) < 0.05;
}

/* By how much the columns of a row change with its angle's last digits, how far they are from a smooth curve beside
** it, and the rounding of the largest of their kind, of which they may be a sum: what rows cannot tell.  Within 1e-5 rad
** of an edge rounding is in steps that are wider than that. */
static void measure_noise(double p, const double *v, double *noise)
{
    double beside[COLUMNS], ulp = DBL_EPSILON * (fabs(from) * unit + total);
    double largest[COLUMNS];
    unsigned long c;
    double before[COLUMNS], away = edge_distance(p), h = (away < 1e-5 ? 1.0 / 64 : 1e-6) * away;
    int k;

    memset(largest, 0, sizeof largest);
    for (c = 0; c < n_columns; c++)
        if (isfinite(v[c]))
            largest[quantity[c]] = fmax(largest[quantity[c]], fabs(v[c]));
    for (c = 0; c < n_columns; c++)
        noise[c] = is_turning[c] ? 0 : largest[quantity[c]] * DBL_EPSILON;
    for (k = 4; k < n_singular; k++)
        for (c = 0; c < n_columns && fabs(remainder(p - singular[k], 2 * PI)) < 1e-12; c++)
            noise[c] = INFINITY;
    for (k = -3; k <= 3; k++) {
        if (compute(p + k * ulp, beside)) {
            for (c = 0; c < n_columns; c++) /* the very edge */
                noise[c] = INFINITY;
            continue;
        }
        for (c = 0; c < n_columns; c++) {
            double by = is_angle(c) ? turn_of(c) * leap(v[c], beside[c], turn_of(c))
                                    : fabs(beside[c] - v[c]);

            noise[c] = by > noise[c] ? by : noise[c];
        }
    }
    for (k = 1; k <= 3; k++) {
        if (compute(p - k * h, before) || compute(p + k * h, beside))
            continue;
        for (c = 0; c < n_columns; c++) {
            double turn = turn_of(c);
            double by = fabs(before[c] - 2 * v[c] + beside[c]);

            if (is_angle(c))
                by = fabs(remainder(before[c] - v[c], turn) + remainder(beside[c] - v[c], turn));
            noise[c] = by > noise[c] ? by : noise[c];
        }
    }
}

static void add(double p)
{
    row *r;

    if (n >= MOST || p < 0 || p > total)
        return;
    if (!rows[n])
        rows[n] = calloc(1, sizeof *rows[n]);
    if (!rows[n])
        exit(2);
    r = rows[n++];
    r->passed = p;
    r->status = compute(p, r->v);
    free(r->noise);
    r->noise = NULL;
    if (r->status || !is_near_edge(p))
        return;
    r->noise = malloc(COLUMNS * sizeof *r->noise);
    if (!r->noise)
        exit(2);
    measure_noise(p, r->v, r->noise);
}

static double noise_of(const row *r, unsigned long c)
{
    return r->noise ? 10 * r->noise[c] : 0;
}

static double noise_at(unsigned long c, double p)
{
    double v[COLUMNS], noise[COLUMNS];

    if (!is_near_edge(p) || compute(p, v))
        return 0;
    measure_noise(p, v, noise);
    return 10 * noise[c];
}

static void add_about(double p, double nearest, int side)
{
    double d;

    for (d = 0.03; d > nearest; d /= 2) {
        if (side <= 0)
            add(p - d);
        if (side >= 0)
            add(p + d);
    }
    if (side <= 0)
        add(p - nearest);
    if (side >= 0)
        add(p + nearest);
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

/* Where there is no row beyond. */
typedef struct edge {
    double p;
    int side;        /* +1: the rows are behind it */
    int is_isolated; /* a change point, which the motion passes */
    int is_noise;    /* one where the crank is at rest: the rows are too few */
    double v[HALVINGS][COLUMNS], noise[HALVINGS][COLUMNS];
} edge;

static edge edges[100];
static int n_edges;

/* Change points are among the corners. */
static double corner_beside(double p)
{
    double nearest = p, d = 1e-6;
    int k;

    for (k = n_corners - 4; k < n_corners; k++) {
        double by = remainder(sense * (corners[k] - from * unit) - p, 2 * PI);

        if (fabs(by) < d) {
            d = fabs(by);
            nearest = p + by;
        }
    }
    return nearest;
}

/* The end of reach, which rows know to the root of the rounding only. */
static double edge_beside(double p)
{
    int k;

    for (k = 4; k < n_singular; k++)
        if (fabs(remainder(singular[k] - p, 2 * PI)) < 1e-9)
            return p + remainder(singular[k] - p, 2 * PI);
    return p;
}

static double speed_at(double p)
{
    fourlink_instant instant;

    memset(&instant, 0, sizeof instant);
    fourlink_results_at(results, branch, angle_of(p), NULL, &instant, NULL);
    return instant.row.crank.omega2;
}

/* At a dead position, and where the crank is at rest, columns are smooth in the root of the distance. */
static void add_edge(const row *with, const row *without)
{
    double in = with->passed, out = without->passed, middle, v[COLUMNS], s = 0.16;
    edge *e = &edges[n_edges];
    int i, is_change = without->status == FOURLINK_CHANGE_POINT, is_root;

    if (n_edges == 100)
        return;
    e->side = in > out ? 1 : -1;
    e->is_isolated = is_change;
    for (i = 0; i < 70 && !is_change; i++) {
        middle = 0.5 * (in + out);
        if (compute(middle, v))
            out = middle;
        else
            in = middle;
    }
    e->p = is_change ? corner_beside(out) : edge_beside(out);
    is_root = !is_change;
    e->is_noise = is_change && fabs(speed_at(e->p)) < 1e-9;
    for (i = 0; i < HALVINGS; i++, s /= 2) {
        double p = e->p + e->side * (is_root ? s * s : s);

        if (p < 0 || p > total || compute(p, e->v[i]))
            for (unsigned long c = 0; c < n_columns; c++)
                e->v[i][c] = NAN;
        else
            measure_noise(p, e->v[i], e->noise[i]);
    }
    n_edges++;
}

/* The motion passes a change point, whatever a row says that is there but for rounding. */
static void add_change_point(double theta)
{
    double p = fmod(theta, 2 * PI);
    row in, out;
    int k, known;

    memset(&in, 0, sizeof in);
    memset(&out, 0, sizeof out);
    out.status = FOURLINK_CHANGE_POINT;
    for (p = p < 0 ? p + 2 * PI : p; p <= total + 1e-9; p += 2 * PI) {
        for (k = known = 0; k < n_edges; k++)
            known |= fabs(edges[k].p - p) < 1e-5;
        if (known)
            continue;
        out.passed = p;
        for (k = -1; k <= 1; k += 2) {
            in.passed = p + k * 1e-3;
            if (in.passed > 0 && in.passed < total)
                add_edge(&in, &out);
        }
    }
}

typedef enum verdict { BOUNDED, UNBOUNDED, UNDECIDED } verdict;

/* Neville's scheme at s = 0, for seven values at s halved again and again from number k on. */
static double neville(const double *y, double *error)
{
    double t[7], before = 0;
    int i, j;

    for (i = 0; i < 7; i++)
        t[i] = y[i];
    for (j = 1; j < 7; j++) {
        before = t[6];
        for (i = 6; i >= j; i--)
            t[i] += (t[i] - t[i - 1]) / (pow(2, j) - 1);
    }
    *error = fabs(t[6] - before);
    return t[6];
}

/* The sign of a pole of any order, however weak, that is more than rounding; 0 if there is none. */
static int weak_pole(const edge *e, unsigned long c, const double *y)
{
    double scaled[HALVINGS], noise[HALVINGS], most, strength, error, rounding;
    int order, i, k;

    for (order = 4; order > 0; order--) {
        most = 0;
        for (i = 0; i < HALVINGS; i++) {
            double power = pow(0.16 * pow(0.5, i), order);

            scaled[i] = y[i] * power;
            noise[i] = e->noise[i][c] * power;
            most = fmax(most, fabs(scaled[i]));
        }
        for (k = 0; k + 7 <= HALVINGS; k++) {
            strength = neville(scaled + k, &error);
            rounding = 0;
            for (i = k; i < k + 7; i++)
                rounding = fmax(rounding, 10 * noise[i]);
            if (fabs(strength) > fmax(1e4 * error, rounding) && fabs(strength) > 1e-8 * most)
                return strength > 0 ? 1 : -1;
        }
    }
    return 0;
}

/* Neville's scheme at s = 0, for s halved again and again, on the window of distances where it is surest. */
/* 1 if the nearest rows of a column are larger than what rounding makes of them. */
static int is_above_noise(const edge *e, unsigned long c)
{
    int i;

    for (i = HALVINGS - 3; i < HALVINGS; i++)
        if (!(fabs(e->v[i][c]) > e->noise[i][c]))
            return 0;
    return 1;
}

static verdict limit_of_one(const edge *e, unsigned long c, double near, double *limit,
                            double *error)
{
    double y[HALVINGS], growth[3], turn = turn_of(c);
    int i, k, grows, sign;

    *limit = *error = NAN;
    if (e->is_noise)
        return UNDECIDED;
    for (i = 0; i < HALVINGS; i++) {
        y[i] = e->v[i][c];
        if (is_angle(c))
            y[i] += turn * floor((near - y[i]) / turn + 0.5);
    }
    for (i = 0; i < HALVINGS && fabs(y[i]) <= 20 * e->noise[i][c]; i++)
        ;
    if (i == HALVINGS) {
        *limit = *error = 0;
        return BOUNDED;
    }
    for (i = 0; i < 3; i++) {
        growth[i] = log2(fabs(y[HALVINGS - 3 + i] / y[HALVINGS - 4 + i]));
        if (y[HALVINGS - 3 + i] * y[HALVINGS - 4 + i] < 0)
            growth[i] = 0.5;
    }
    grows = !is_angle(c) && growth[0] > 0.8 && growth[1] > 0.8 && growth[2] > 0.8;
    sign = is_angle(c) ? 0 : weak_pole(e, c, y);
    if (grows && (is_above_noise(e, c) || sign * y[HALVINGS - 1] > 0)) {
        *limit = y[HALVINGS - 1] > 0 ? INFINITY : -INFINITY;
        return UNBOUNDED;
    }
    if (sign) {
        *limit = sign > 0 ? INFINITY : -INFINITY;
        return UNDECIDED;
    }
    *error = INFINITY;
    for (k = 0; k + 7 <= HALVINGS; k++) {
        double rounding = 0, doubt, value = neville(y + k, &doubt);

        for (i = 0; i < 7; i++)
            rounding = fmax(rounding, e->noise[k + i][c]);
        doubt += 10 * rounding;
        if (doubt < *error) {
            *error = doubt;
            *limit = value;
        }
    }
    if (is_angle(c) && fabs(y[HALVINGS - 1] - *limit) > 1e-3 * turn)
        return UNDECIDED;
    if (grows) /* but the nearest rows are rounding */
        return isfinite(*error) ? BOUNDED : UNDECIDED;
    return isfinite(*error) && !(growth[2] > 0.15 && fabs(y[HALVINGS - 1]) > 2 * fabs(*limit))
               ? BOUNDED
               : UNDECIDED;
}

/* The same; what has components is no surer than they are: near a weak pole it is smooth only where that prevails. */
static verdict limit_of(const edge *e, unsigned long c, double near, double *limit, double *error)
{
    size_t size = strlen(columns[c].name);
    verdict of_component;
    unsigned long i;

    for (i = 0; i < n_columns; i++) {
        const char *name = columns[i].name;

        if (strlen(name) != size + 1 || memcmp(name, columns[c].name, size) != 0 ||
            (name[size] != 'x' && name[size] != 'y'))
            continue;
        of_component = limit_of_one(e, i, near, limit, error);
        *limit = INFINITY;
        if (of_component != BOUNDED)
            return of_component;
    }
    return limit_of_one(e, c, near, limit, error);
}

/* Close to a change point rows are rounding; the limit stands for them. */
static void leave_out_change_points(void)
{
    size_t i;
    int k;

    for (i = 0; i < n; i++)
        for (k = 0; k < n_edges; k++)
            if (edges[k].is_isolated && fabs(rows[i]->passed - edges[k].p) < 2e-3) {
                row *r = rows[i];

                rows[i--] = rows[--n];
                rows[n] = r;
                break;
            }
}

static void take_rows(void)
{
    size_t i, m;
    int k, pass;

    double v[COLUMNS];

    n = 0;
    n_edges = 0;
    has_first = !compute(0, v);
    m = (size_t)(EVEN * total / (2 * PI)) + 50;
    for (i = 0; i <= (m < 3000 ? m : 3000); i++)
        add(total * (double)i / (double)(m < 3000 ? m : 3000));
    add(total);
    add_about(0, 1e-8, 1);
    add_about(total, 1e-8, -1);
    for (k = 0; k < n_corners; k++) {
        double p = fmod(sense * (corners[k] - from * unit), 2 * PI);

        for (p = p < 0 ? p + 2 * PI : p; p <= total; p += 2 * PI) {
            add(p);
            add_about(p, 2e-11, 0);
        }
    }
    sort_rows();
    m = n;
    for (i = 0; i + 1 < m; i++)
        if (!rows[i]->status != !rows[i + 1]->status) {
            add_edge(rows[rows[i]->status ? i + 1 : i], rows[rows[i]->status ? i : i + 1]);
            if (n_edges < 100 && !edges[n_edges - 1].is_isolated)
                add_about(edges[n_edges - 1].p, 1e-6, edges[n_edges - 1].side);
        }
    for (k = 0; k < n_changes; k++)
        add_change_point(changes[k]);
    leave_out_change_points();
    sort_rows();
    for (pass = 0; pass < 60; pass++) {
        m = n;
        for (i = 0; i + 1 < m; i++)
            if (rows[i + 1]->passed - rows[i]->passed > 1e-12 * (1 + total) &&
                leaps(rows[i], rows[i + 1]))
                add(0.5 * (rows[i]->passed + rows[i + 1]->passed));
        if (n == m)
            break;
        leave_out_change_points();
        sort_rows();
    }
}

/* ------------------------------------------------------------------------------------ one column */

/* The best of a column by brute force. */
typedef struct best {
    verdict verdict;
    double value, error, at;
} best;

static double curve[MOST]; /* of the column, angles going on */

static int is_gap(const row *r)
{
    return r->status && r->status != FOURLINK_CHANGE_POINT && r->status != FOURLINK_DEAD_POSITION;
}

#define NEAR_HALF 1e-5 /* of a turn */

/* 1 if the rows say how the angle goes on. */
static int follow(unsigned long c)
{
    double turn = turn_of(c), last = NAN, first = rows[0]->v[c];
    size_t i, start = 0;
    int has_gap = 0;

    for (i = 0; i < n; i++) {
        double v = rows[i]->v[c], by;

        curve[i] = v;
        if (is_gap(rows[i]) && !(columns[c].flags & FOURLINK_OF_CRANK)) {
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
            curve[i] = v + turn * floor((last - v) / turn + 0.5);
        last = curve[i];
    }
    if (has_gap && is_revolution && leap(first, rows[n - 1]->v[c], turn) < 1e-9) {
        double shift = turn * floor((first - curve[n - 1]) / turn + 0.5);

        for (i = start; i < n; i++)
            curve[i] += shift;
    }
    return 1;
}

/* A direction where there is no force is noise. */
static int is_noise(unsigned long c)
{
    const char *dir = strstr(columns[c].name, "_dir");
    double most = 0, force = 0;
    unsigned long f, k;
    size_t i, zeros = 0;

    if (!dir)
        return 0;
    for (f = 0; f < n_columns; f++)
        if (strlen(columns[f].name) + 4 == strlen(columns[c].name) &&
            memcmp(columns[f].name, columns[c].name, strlen(columns[f].name)) == 0)
            break;
    for (i = 0; i < n; i++)
        for (k = 0; k < n_columns && !rows[i]->status; k++) {
            if (strcmp(columns[k].quantity, "force") == 0 && fabs(rows[i]->v[k]) > force)
                force = fabs(rows[i]->v[k]);
            if (k == f && rows[i]->v[k] > most)
                most = rows[i]->v[k];
        }
    for (i = 0; i < n; i++)
        zeros += rows[i]->v[f] <= 1e-7 * most;
    return f == n_columns || most < 1e-9 * force || zeros > 40;
}

static double value_near(unsigned long c, double p, double near)
{
    double v[COLUMNS];
    int k;

    for (k = 0; k < n_edges; k++)
        if (edges[k].is_isolated && fabs(p - edges[k].p) < 2e-3)
            return NAN;
    if (compute(p, v) || isnan(v[c]))
        return NAN;
    return is_angle(c) ? v[c] + turn_of(c) * floor((near - v[c]) / turn_of(c) + 0.5) : v[c];
}

/* Parabolas through three rows, ever closer about the top. */
static void refine(unsigned long c, int sign, size_t i, best *b)
{
    double x = rows[i]->passed, y = curve[i], low = rows[i - 1]->passed, high = rows[i + 1]->passed;
    double left = curve[i - 1], right = curve[i + 1], h;
    int k;

    for (k = 0; k < 6; k++) {
        double d0 = x - low, d1 = high - x, s0 = (y - left) / d0, s1 = (right - y) / d1;
        double curvature = 2 * (s1 - s0) / (d0 + d1), slope = (s0 * d1 + s1 * d0) / (d0 + d1);
        double top = x - slope / curvature, v;

        if (!isfinite(top))
            break;
        top = top < low ? low : top > high ? high : top;
        v = value_near(c, top, y);
        if (sign * v > sign * y) {
            x = top;
            y = v;
        }
        h = (high - low) / 16;
        if (h < 1e-6)
            break;
        low = x - h;
        high = x + h;
        left = value_near(c, low, y);
        right = value_near(c, high, y);
    }
    y -= sign * noise_at(c, x);
    if (sign * y > sign * b->value) {
        b->value = y;
        b->at = x;
    }
}

static best find(unsigned long c, int sign)
{
    best b = {BOUNDED, NAN, 0, 0};
    size_t i;
    int k, peaks = 0;

    for (i = 0; i < n; i++) {
        double surely = curve[i] - sign * noise_of(rows[i], c);

        if (isfinite(surely) && !(sign * surely <= sign * b.value)) {
            b.value = surely;
            b.at = rows[i]->passed;
        }
    }
    for (i = 1; i + 1 < n && peaks < 20; i++)
        if (fabs(curve[i - 1] - 2 * curve[i] + curve[i + 1]) > 1e-12 * fabs(curve[i]) &&
            sign * curve[i] >= sign * curve[i - 1] && sign * curve[i] >= sign * curve[i + 1] &&
            sign * curve[i] + 2 * fabs(curve[i - 1] - 2 * curve[i] + curve[i + 1]) >=
                sign * b.value)
            refine(c, sign, i, &b), peaks++;
    for (k = 0; k < n_edges && !(columns[c].flags & FOURLINK_OF_CRANK); k++) {
        double limit, error, nearest = INFINITY, near = NAN;
        verdict v;

        for (i = 0; i < n; i++)
            if (!isnan(curve[i]) && edges[k].side * (rows[i]->passed - edges[k].p) > 0 &&
                fabs(rows[i]->passed - edges[k].p) < nearest) {
                nearest = fabs(rows[i]->passed - edges[k].p);
                near = curve[i];
            }
        v = limit_of(&edges[k], c, near, &limit, &error);
        if (v == UNDECIDED && b.verdict != UNBOUNDED)
            b.verdict = UNDECIDED;
        if (v == UNBOUNDED && sign * limit > 0) {
            b.verdict = UNBOUNDED;
            b.value = limit;
            b.at = edges[k].p;
        }
        if (v == BOUNDED && sign * limit > sign * b.value) {
            b.value = limit;
            b.error = error;
            b.at = edges[k].p;
        }
    }
    return b;
}

/* 1 for the columns that are unbounded beyond 1e9, which pass through infinity between rows. */
static int has_bound(unsigned long c)
{
    const char *name = columns[c].name;

    return !strcmp(name, "mechanical_advantage") || !strcmp(name, "I13x") ||
           !strcmp(name, "I13y") || !strcmp(name, "I24x") || !strcmp(name, "klein_IX") ||
           !strcmp(name, "klein_IY");
}

static int has_pole(unsigned long c)
{
    double v[COLUMNS];
    size_t i, next;
    int k;

    for (i = 0; i + 1 < n; i = next) {
        double low = rows[i]->passed, high, at_low = curve[i], middle, most = 0;

        for (next = i + 1; next + 1 < n && isnan(curve[next]) && !rows[next]->status; next++)
            ;
        high = rows[next]->passed;
        if (!(curve[i] * curve[next] < 0))
            continue;
        for (k = 0; k < 60; k++) {
            middle = 0.5 * (low + high);
            if (compute(middle, v))
                break;
            most = fabs(v[c]) > most ? fabs(v[c]) : most;
            if (isnan(v[c])) {
                compute(0.75 * low + 0.25 * high, v);
                most =
                    most > 1e3 * fabs(at_low) || fabs(v[c]) > 1.5 * fabs(at_low) ? INFINITY : most;
                break;
            }
            if ((v[c] > 0) == (at_low > 0))
                low = middle;
            else
                high = middle;
        }
        if (most * columns[c].to_si >= 1e9)
            return 1;
    }
    return 0;
}

/* ------------------------------------------------------------------------------------- comparison */

typedef struct kind {
    char name[40];
    long tried, undecided;
    double missed, attained; /* worst errors, by size */
} kind;

static kind kinds[50];
static int n_kinds;
static long near_misses, tried, undecided, better, failed, unbounded, limits;
static const char *deck_name;
static int deck_failed;

static kind *kind_of(unsigned long c)
{
    int i;

    for (i = 0; i < n_kinds; i++)
        if (!strcmp(kinds[i].name, columns[c].quantity))
            return &kinds[i];
    snprintf(kinds[n_kinds].name, sizeof kinds[0].name, "%s", columns[c].quantity);
    return &kinds[n_kinds++];
}

static void fail(const fourlink_value *f, const best *b, const char *what, double error)
{
    if (error <= 10 * TOLERANCE) { /* a few of a million, near change points */
        near_misses++;
        return;
    }
    printf("%s %s %-22s %s: told %.15g at %.15g, rows %.15g at %.15g (error %.2g)\n", deck_name,
           branch == FOURLINK_OPEN ? "open   " : "crossed", f->name, what, f->value, f->angle,
           b->value, angle_of(b->at), error);
    failed++;
    deck_failed = 1;
}

static int by_value(const void *x, const void *y)
{
    double a = *(const double *)x, b = *(const double *)y;

    return (a > b) - (a < b);
}

/* Largest magnitude; of what is unbounded the median. */
static double size_of(unsigned long c, int is_unbounded)
{
    static double sorted[MOST];
    size_t i, m = 0;

    for (i = 0; i < n; i++)
        if (!isnan(curve[i]) && !(noise_of(rows[i], c) > 1e-10 * fabs(curve[i])))
            sorted[m++] = fabs(curve[i]);
    if (!m)
        return 0;
    qsort(sorted, m, sizeof sorted[0], by_value);
    return sorted[is_unbounded ? m / 2 : m - 1];
}

/* How far the row at the angle that is told, or the limit there, is from the value: the nearer of them, as extremes
** can be closer to an edge than a row's place is known. */
static double distance(unsigned long c, const fourlink_value *f, double size)
{
    double p = sense * (f->angle - from) * unit, v[COLUMNS], d = INFINITY;
    int k;

    for (k = 0; k < n_edges; k++) {
        double limit, error, far;

        if (fabs(edges[k].p - p) > 1e-9 || (columns[c].flags & FOURLINK_OF_CRANK))
            continue;
        if (limit_of(&edges[k], c, f->value, &limit, &error) != BOUNDED)
            return 0; /* the comparison of the values says more */
        far = fabs(is_angle(c) ? turn_of(c) * leap(limit, f->value, turn_of(c)) : limit - f->value);
        far = far > DOUBT * error + 1e-12 * size ? far : 0;
        d = far < d ? far : d;
    }
    if (!fourlink_results_at(results, branch, f->angle, v, NULL, NULL) ||
        (columns[c].flags & FOURLINK_OF_CRANK)) {
        double far = is_angle(c) ? turn_of(c) * leap(v[c], f->value, turn_of(c)) : v[c] - f->value;

        d = fmin(d, fmax(fabs(far) - noise_at(c, p), 0));
    }
    return d;
}

/* 1 if a column grows without end on one side of an angle, to that sign: tenfold with each tenth of the distance. */
static int grows(unsigned long c, double p, int side, double sign)
{
    double v[COLUMNS], before = INFINITY, away;

    for (away = 1e-6; away > 0.5e-8; away /= 10) {
        if (compute(p + side * away, v) || !(fabs(v[c]) > 5 * before || isinf(before)))
            return 0;
        before = fabs(v[c]);
    }
    return v[c] * sign > 0;
}

/* 1 for a pole that is narrower than the rows. */
static int is_narrow_pole(unsigned long c, const fourlink_value *f)
{
    double p = sense * (f->angle - from) * unit;

    return isinf(f->value) && has_bound(c) &&
           (grows(c, p, 1, f->value) || grows(c, p, -1, f->value));
}

static void compare(unsigned long c, const fourlink_value *f, const best *b, double size)
{
    kind *k = kind_of(c);
    int sign = f->name[1] == 'a' ? 1 : -1;
    double by = sign * (b->value - f->value) / size, far;

    tried++;
    k->tried++;
    if (b->verdict == UNDECIDED) {
        k->undecided++;
        undecided++;
        return;
    }
    if (isinf(f->value) || isinf(b->value)) {
        unbounded++;
        if (f->value != b->value && !is_narrow_pole(c, f))
            fail(f, b, "unbounded", INFINITY);
        return;
    }
    if (size == 0)
        return;
    if (is_angle(c) && !has_first)
        by -= turn_of(c) / size * floor(by * size / turn_of(c) + 0.5);
    far = distance(c, f, size) / size;
    if (b->error > 1e-10 * size) { /* the limit is not exact enough */
        by = fabs(by) <= DOUBT * b->error / size ? 0 : by;
        far = far <= DOUBT * b->error / size ? 0 : far;
    }
    if (b->error > 0)
        limits++;
    k->missed = by > k->missed ? by : k->missed;
    k->attained = far > k->attained ? far : k->attained;
    if (by > TOLERANCE)
        fail(f, b, "missed", by);
    else if (far > TOLERANCE)
        fail(f, b, "not the row's", far);
    else if (by < -TOLERANCE && is_angle(c) && -by * size > 0.4 * turn_of(c))
        fail(f, b, "turns", by);
    else if (by < -TOLERANCE)
        better++;
}

/* 1 for a column that is 0, or at infinity, but for rounding: by ten of the rows, or by the few that have a value. */
static int is_rounding(unsigned long c)
{
    double v[COLUMNS], noise[COLUMNS];
    size_t i, step;
    int rounding = 0, used = 0;

    for (step = n / 10 + 1; step > 0 && !used; step = step > 1 ? 1 : 0)
        for (i = step / 2; i < n; i += step) {
            memcpy(v, rows[i]->v, sizeof v);
            if (rows[i]->status || !(fabs(v[c]) > 0))
                continue;
            measure_noise(rows[i]->passed, v, noise);
            rounding += fabs(v[c]) <= 100 * noise[c];
            used++;
        }
    return used > 0 && 2 * rounding > used;
}

/* 1 for the direction of a force that can have a weak pole at a change point, nearer than the rows go: there it
** turns over. */
static int turns_at_change_point(unsigned long c)
{
    int k;

    for (k = 0; k < n_edges; k++)
        if (edges[k].is_isolated && strstr(columns[c].name, "_dir"))
            return 1;
    return 0;
}

/* 1 for a column that is infinite in all rows: the advantage of a piston at rest. */
static int is_infinite(unsigned long c)
{
    size_t i;

    for (i = 0; i < n; i++)
        if (isfinite(rows[i]->v[c]))
            return 0;
    return n > 0 && isinf(rows[n / 2]->v[c]);
}

static void compare_columns(const fourlink_value *facts, unsigned long n_facts)
{
    double scale[COLUMNS], size[COLUMNS];
    unsigned long c, i;
    size_t r;

    for (c = 0; c < n_columns; c++)
        scale[c] = size[c] = 0;
    for (c = 0; c < n_columns; c++)
        for (r = 0; r < n; r++)
            if (fabs(rows[r]->v[c]) - noise_of(rows[r], c) > size[c])
                size[c] = fabs(rows[r]->v[c]) - noise_of(rows[r], c);
    for (c = 0; c < n_columns; c++)
        for (i = 0; i < n_columns; i++)
            if (quantity[i] == quantity[c] && size[i] > scale[c])
                scale[c] = size[i];
    for (c = 0; c < n_columns; c++) {
        const fourlink_value *told[2] = {NULL, NULL};
        best found[2];
        int ok = 1, infinite, which;

        if (columns[c].flags & (FOURLINK_CRANK_ANGLE | FOURLINK_OF_ROUNDING))
            continue;
        for (i = 0; i < n_facts; i++)
            if (strlen(facts[i].name) == strlen(columns[c].name) + 5 &&
                !memcmp(facts[i].name + 4, columns[c].name, strlen(columns[c].name)))
                told[facts[i].name[1] == 'a' ? 0 : 1] = &facts[i];
        if (is_angle(c))
            ok = follow(c) && !is_noise(c);
        else
            for (r = 0; r < n; r++)
                curve[r] = isinf(rows[r]->v[c]) ? NAN : rows[r]->v[c]; /* has_pole sees it */
        if (size[c] < 1e-11 * scale[c])
            ok = ok && size[c] == 0;
        if (is_rounding(c) || turns_at_change_point(c))
            ok = 0;
        for (which = 0; which < 2; which++)
            found[which] = find(c, which == 0 ? 1 : -1);
        if (is_infinite(c))
            continue;
        if (!ok && !told[0])
            continue; /* a direction that only rounding has */
        if (isnan(found[0].value) != !told[0] || isnan(found[1].value) != !told[1]) {
            printf("%s %s: found %g and %g, told %d and %d\n", deck_name, columns[c].name,
                   found[0].value, found[1].value, told[0] != NULL, told[1] != NULL);
            failed++;
            deck_failed = 1;
            continue;
        }
        if (!told[0])
            continue;
        if (has_bound(c) && has_pole(c)) {
            found[0].verdict = found[1].verdict = UNBOUNDED;
            found[0].value = INFINITY;
            found[1].value = -INFINITY;
        }
        infinite = found[0].verdict == UNBOUNDED || found[1].verdict == UNBOUNDED;
        for (which = 0; which < 2; which++) {
            double s = size_of(c, infinite);

            if (has_bound(c) && fabs(found[which].value) * columns[c].to_si >= 1e9)
                found[which].value = which == 0 ? INFINITY : -INFINITY;
            if (!ok)
                found[which].verdict = UNDECIDED;
            if (isfinite(found[which].value) && fabs(found[which].value) > s)
                s = fabs(found[which].value);
            compare(c, told[which], &found[which], s);
        }
    }
}

/* ------------------------------------------------------------------------------------------ a deck */

static void list_singular(void)
{
    fourlink_problem problem;
    fourlink_reach reach;
    int i;

    double line;

    n_singular = n_changes = 0;
    fourlink_deck_problem(fourlink_results_deck(results), &problem);
    line = problem.mechanism.design.kind == FOURLINK_SLIDER_CRANK ? -PI / 2 : 0;
    if (problem.mechanism.change_folded)
        changes[n_changes++] = sense * (line - from * unit);
    if (problem.mechanism.change_stretched)
        changes[n_changes++] = sense * (line + PI - from * unit);
    fourlink_reach_of(&problem.mechanism, &reach);
    for (i = 0; i < 4; i++)
        singular[n_singular++] = sense * (i * PI / 2 - from * unit);
    for (i = 0; i < reach.n_ranges; i++) {
        singular[n_singular++] = sense * (reach.from[i] - from * unit);
        singular[n_singular++] = sense * (reach.to[i] - from * unit);
    }
}

static int open_deck(void)
{
    fourlink_mistake mistakes[3];
    fourlink_problem problem;
    fourlink_source source;
    fourlink_range range;
    unsigned long n_mistakes = 0;

    memset(&source, 0, sizeof source);
    source.name = deck_name;
    source.text = text;
    source.length = length;
    if (fourlink_results_open(&source, 3, &results, mistakes, &n_mistakes) != FOURLINK_OK) {
        if (getenv("BRUTE_VERBOSE") && n_mistakes)
            printf("%s: %s\n", deck_name, mistakes[0].message);
        return 0;
    }
    fourlink_deck_problem(fourlink_results_deck(results), &problem);
    fourlink_motion_range(&problem.motion, &range);
    fourlink_results_list(results, FOURLINK_COLUMNS, &columns, &n_columns);
    unit = problem.motion.angle_unit;
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
    total = fabs(end - from) * unit;
    is_revolution = problem.one_revolution && problem.motion.run_up <= 0 && !range.stops &&
                    (problem.motion.acceleration == 0 || problem.motion.hold);
    return n_columns <= COLUMNS;
}

static void keep_deck(void)
{
    FILE *out = fopen(deck_name, "w");

    if (out) {
        fwrite(text, 1, length, out);
        fclose(out);
    }
}

static void try_deck(void)
{
    const fourlink_value *facts;
    unsigned long n_facts;
    int k;

    list_singular();
    list_quantities();
    for (k = 0; k < 2; k++) {
        branch = k == 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;
        fourlink_results_facts(results, (int)branch, FOURLINK_FACTS_EXTREMES, &facts, &n_facts);
        take_rows();
        compare_columns(facts, n_facts);
    }
}

int main(int argc, char **argv)
{
    long decks = argc > 1 ? atol(argv[1]) : 300, seed = argc > 2 ? atol(argv[2]) : 1;
    long first = argc > 3 ? atol(argv[3]) : 0, i, refused = 0, bad = 0;
    char name[100];
    int k;

    for (i = first; i < first + decks; i++) {
        state = 0x9E3779B97F4A7C15ULL * (unsigned long long)(seed * 1000003 + i + 1);
        for (k = 0; k < 10; k++)
            chance();
        snprintf(name, sizeof name, "brute-%ld-%ld.deck", seed, i);
        deck_name = name;
        make_deck();
        deck_failed = 0;
        if (!open_deck()) {
            refused++;
            continue;
        }
        try_deck();
        fourlink_results_free(results);
        bad += deck_failed;
        if (deck_failed)
            keep_deck();
    }
    printf("%ld decks, %ld refused: %ld extremes, %ld unbounded, %ld limits, %ld undecided, %ld "
           "narrower than "
           "the rows\n",
           decks, refused, tried, unbounded, limits, undecided, better);
    printf("%-22s %9s %9s %12s %12s\n", "quantity", "extremes", "undecided", "missed by",
           "off the row");
    for (k = 0; k < n_kinds; k++)
        printf("%-22s %9ld %9ld %12.2g %12.2g\n", kinds[k].name, kinds[k].tried, kinds[k].undecided,
               kinds[k].missed, kinds[k].attained);
    printf("%ld extremes of %ld decks wrong; %ld others between 1e-9 and 1e-8 off\n", failed, bad,
           near_misses);
    return failed > 0 || refused == decks;
}
