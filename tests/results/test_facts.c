/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_facts.c - extremes of columns, the turning moment and the flywheel, printed values compared.
**
** Extremes are compared with those of formulas of this file, in long double; the turning moment with
** the energies that it must give back, and with areas in closed form.
*/
#include <stdlib.h>

#include <gsl/gsl_errno.h>

#include "check.h"
#include "read.h"
#include "results/expected.h"
#include "results/extreme.h"
#include "results/fact.h"
#include "results/turning.h"

#define PI 3.14159265358979323846
#define PIL 3.14159265358979323846264338327950288L

static const fourlink_branch branches[2] = {FOURLINK_OPEN, FOURLINK_CROSSED};

/* ---------------------------------------------------------------------------------------------
** Decks
** ------------------------------------------------------------------------------------------- */

typedef struct loaded {
    deck d;
    analysis a;
} loaded;

static void load(const char *contents, loaded *l)
{
    if (read_deck(contents, &l->d) != 1)
        fail_msg("%s\n%s", l->d.mistakes.list[0].message, contents);
    assert_true(analysis_open(&l->a, &l->d, analysis_possible(&l->d)));
}

static void unload(loaded *l)
{
    analysis_close(&l->a);
    flk_deck_free(&l->d);
}

static char *print(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* A deck; it is valid until the 64th after it. */
static char *print(const char *format, ...)
{
    static char buffer[64][4000];
    static int i;
    va_list list;
    int n;

    i = (i + 1) % 64;
    va_start(list, format);
    n = vsnprintf(buffer[i], sizeof buffer[i], format, list);
    va_end(list);
    assert_true(n > 0 && n < (int)sizeof buffer[i]);
    return buffer[i];
}

static char *four_bar(double a, double b, double c, double d, const char *more)
{
    return print("mechanism = four-bar\n[crank]\nlength = %.17g m\n[coupler]\nlength = %.17g m\n"
                 "[rocker]\nlength = %.17g m\n[ground]\nlength = %.17g m\n%s",
                 a, b, c, d, more);
}

static char *slider_crank(double r, double l, double e, const char *more)
{
    return print("mechanism = slider-crank\n[crank]\nlength = %.17g m\n[rod]\nlength = %.17g m\n"
                 "[ground]\noffset = %.17g m\n%s",
                 r, l, e, more);
}

/* ---------------------------------------------------------------------------------------------
** The mechanisms once more
** ------------------------------------------------------------------------------------------- */

typedef struct own {
    long double a, b, c, d; /* of a slider-crank r, l, - and e */
    int branch;
    long double start, speed, acceleration; /* of the motion, or of this part of it */
    long double mass, gas;                  /* of a piston; force on it towards the crank */
} own;

typedef long double own_column(const own *o, long double theta2);

static long double own_omega2(const own *o, long double theta2)
{
    long double square = o->speed * o->speed + 2 * o->acceleration * (theta2 - o->start);

    square = square > 0 ? sqrtl(square) : 0;
    return o->speed < 0 || (o->speed == 0 && o->acceleration < 0) ? -square : square;
}

/* Angles, and their first and second derivatives to theta2. */
typedef struct angles {
    long double t3, t4, k3, k4, kk3, kk4;
} angles;

/* The angles from the triangles ABD and BCD, the derivatives from the loop
**
**    a e^(i theta2) + b e^(i theta3) = d + c e^(i theta4)
*/
static angles own_angles(const own *o, long double t)
{
    long double f = sqrtl(o->a * o->a + o->d * o->d - 2 * o->a * o->d * cosl(t));
    long double ADB = atan2l(o->a * sinl(t), o->d - o->a * cosl(t)), x, y, det;
    angles r;

    r.t3 = -ADB + o->branch * acosl((f * f + o->b * o->b - o->c * o->c) / (2 * f * o->b));
    r.t4 = PIL - ADB - o->branch * acosl((f * f + o->c * o->c - o->b * o->b) / (2 * f * o->c));
    /* -b sin(t3) k3 + c sin(t4) k4 = a sin(t), b cos(t3) k3 - c cos(t4) k4 = -a cos(t) */
    det = o->b * o->c * sinl(r.t3 - r.t4);
    x = o->a * sinl(t);
    y = -o->a * cosl(t);
    r.k3 = (-o->c * cosl(r.t4) * x - o->c * sinl(r.t4) * y) / det;
    r.k4 = (-o->b * sinl(r.t3) * y - o->b * cosl(r.t3) * x) / det;
    x = o->a * cosl(t) + o->b * cosl(r.t3) * r.k3 * r.k3 - o->c * cosl(r.t4) * r.k4 * r.k4;
    y = o->a * sinl(t) + o->b * sinl(r.t3) * r.k3 * r.k3 - o->c * sinl(r.t4) * r.k4 * r.k4;
    r.kk3 = (-o->c * cosl(r.t4) * x - o->c * sinl(r.t4) * y) / det;
    r.kk4 = (-o->b * sinl(r.t3) * y - o->b * cosl(r.t3) * x) / det;
    return r;
}

static long double own_theta3(const own *o, long double t)
{
    return own_angles(o, t).t3 * 180 / PIL;
}

static long double own_theta4(const own *o, long double t)
{
    return own_angles(o, t).t4 * 180 / PIL;
}

static long double own_omega3(const own *o, long double t)
{
    return own_angles(o, t).k3 * own_omega2(o, t);
}

static long double own_omega4(const own *o, long double t)
{
    return own_angles(o, t).k4 * own_omega2(o, t);
}

static long double own_alpha3(const own *o, long double t)
{
    angles r = own_angles(o, t);

    return r.kk3 * own_omega2(o, t) * own_omega2(o, t) + r.k3 * o->acceleration;
}

static long double own_alpha4(const own *o, long double t)
{
    angles r = own_angles(o, t);

    return r.kk4 * own_omega2(o, t) * own_omega2(o, t) + r.k4 * o->acceleration;
}

static long double own_mu(const own *o, long double t)
{
    long double f2 = o->a * o->a + o->d * o->d - 2 * o->a * o->d * cosl(t);
    long double mu = acosl((o->b * o->b + o->c * o->c - f2) / (2 * o->b * o->c)) * 180 / PIL;

    return mu > 90 ? 180 - mu : mu;
}

/* The piston's coordinate, and its derivatives to theta2: X^2 - 2 X r cos(theta2) ... solved */
typedef struct piston {
    long double h, W, X, k, kk, k3, kk3;
} piston;

static piston own_piston(const own *o, long double t)
{
    long double dh = o->a * cosl(t), ddh = -o->a * sinl(t), dW;
    piston p;

    p.h = o->a * sinl(t) - o->d;
    p.W = o->branch * sqrtl(o->b * o->b - p.h * p.h);
    dW = -p.h * dh / p.W;
    p.X = o->a * cosl(t) + p.W;
    p.k = -o->a * sinl(t) + dW;
    p.kk = -o->a * cosl(t) - (dh * dh + p.h * ddh + dW * dW) / p.W;
    p.k3 = -dh / p.W;
    p.kk3 = -ddh / p.W + dh * dW / (p.W * p.W);
    return p;
}

static long double own_x(const own *o, long double t)
{
    return sqrtl((o->a + o->b) * (o->a + o->b) - o->d * o->d) - o->branch * own_piston(o, t).X;
}

static long double own_v(const own *o, long double t)
{
    return -o->branch * own_piston(o, t).k * own_omega2(o, t);
}

static long double own_a(const own *o, long double t)
{
    piston p = own_piston(o, t);

    return -o->branch * (p.kk * own_omega2(o, t) * own_omega2(o, t) + p.k * o->acceleration);
}

static long double own_rod_theta3(const own *o, long double t)
{
    long double angle = asinl(own_piston(o, t).h / o->b) * 180 / PIL;

    return o->branch > 0 ? -angle : 180 + angle;
}

static long double own_rod_omega3(const own *o, long double t)
{
    return own_piston(o, t).k3 * own_omega2(o, t);
}

static long double own_rod_alpha3(const own *o, long double t)
{
    piston p = own_piston(o, t);

    return p.kk3 * own_omega2(o, t) * own_omega2(o, t) + p.k3 * o->acceleration;
}

static long double own_phi(const own *o, long double t)
{
    return asinl(own_piston(o, t).h / o->b) * 180 / PIL;
}

static long double own_rod_mu(const own *o, long double t)
{
    return acosl(fabsl(own_piston(o, t).h) / o->b) * 180 / PIL;
}

/* Of a piston with mass and gas, by the power that they take. */
static long double own_Ts(const own *o, long double t)
{
    piston p = own_piston(o, t);
    long double w = own_omega2(o, t);

    return p.k * (o->mass * (p.kk * w * w + p.k * o->acceleration) + o->branch * o->gas);
}

typedef struct own_entry {
    const char *name;
    own_column *f;
} own_entry;

static const own_entry of_four_bar[] = {
    {"theta3", own_theta3}, {"omega3", own_omega3}, {"alpha3", own_alpha3}, {"theta4", own_theta4},
    {"omega4", own_omega4}, {"alpha4", own_alpha4}, {"mu", own_mu},         {NULL, NULL}};

static const own_entry of_slider_crank[] = {{"x", own_x},       {"v", own_v},
                                            {"a", own_a},       {"theta3", own_rod_theta3},
                                            {"phi", own_phi},   {"omega3", own_rod_omega3},
                                            {"mu", own_rod_mu}, {"alpha3", own_rod_alpha3},
                                            {NULL, NULL}};

static const own_entry of_piston_forces[] = {{"Ts", own_Ts}, {NULL, NULL}};

/* ---------------------------------------------------------------------------------------------
** Extremes by dense scan and golden sections
** ------------------------------------------------------------------------------------------- */

#define SAMPLES 360

typedef struct peaks {
    int n;
    long double value, theta2[64]; /* the value, and all angles at which it occurs */
} peaks;

static void flk_keep(peaks *p, int sign, long double value, long double theta2)
{
    long double same = 1e-12L * fabsl(value);

    if (p->n && sign * value < sign * p->value - same)
        return;
    if (p->n && sign * value > sign * p->value + same)
        p->n = 0;
    if (!p->n || sign * value > sign * p->value)
        p->value = value;
    if (p->n < 64)
        p->theta2[p->n++] = theta2;
}

static long double golden(own_column *f, const own *o, int sign, long double low, long double high)
{
    const long double g = (sqrtl(5) - 1) / 2;
    long double x = high - g * (high - low), z = low + g * (high - low);
    long double fx = sign * f(o, x), fz = sign * f(o, z);
    int i;

    for (i = 0; i < 52; i++)
        if (fx > fz) {
            high = z;
            z = x, fz = fx;
            x = high - g * (high - low);
            fx = sign * f(o, x);
        } else {
            low = x;
            x = z, fx = fz;
            z = low + g * (high - low);
            fz = sign * f(o, z);
        }
    return (low + high) / 2;
}

/* Add the extremes of one part of a motion to those of the parts before it. */
static void scan(own_column *f, const own *o, int sign, long double from, long double to, peaks *p)
{
    long double y[SAMPLES + 1], step = (to - from) / SAMPLES, best = -INFINITY, worst = INFINITY;
    int i;

    for (i = 0; i <= SAMPLES; i++) {
        y[i] = sign * f(o, from + i * step);
        best = y[i] > best ? y[i] : best;
        worst = y[i] < worst ? y[i] : worst;
    }
    flk_keep(p, sign, sign * y[0], from);
    flk_keep(p, sign, sign * y[SAMPLES], to);
    for (i = 0; i <= SAMPLES; i++) {
        long double low = i ? from + (i - 1) * step : from,
                    high = i < SAMPLES ? from + (i + 1) * step : to, at;

        if ((i && y[i - 1] > y[i]) || (i < SAMPLES && y[i + 1] > y[i]) ||
            y[i] < best - 0.01L * (best - worst))
            continue;
        at = golden(f, o, sign, low, high);
        flk_keep(p, sign, f(o, at), at);
    }
}

/* A motion in at most two parts. */
typedef struct part {
    own o;
    long double from, to;
} part;

enum { VALUES = 1, ANGLES = 2 };

/* Compare max(COLUMN) and min(COLUMN) of a deck with those of the parts of its motion, given for the
** open branch. */
static void check_extremes(const char *contents, const own_entry *columns, const part *parts,
                           int n_parts, int periodic, int what)
{
    loaded l;
    int k, sign, i;

    load(contents, &l);
    for (; columns->name; columns++)
        for (k = 0; k < 2; k++)
            for (sign = -1; sign <= 1; sign += 2) {
                peaks p = {0};
                double nearest = 1e9, turn = 0;
                extreme e;
                column c;

                assert_true(column_find(&l.d, flk_text_of(columns->name), &c));
                for (i = 0; i < n_parts; i++) {
                    own o = parts[i].o;

                    o.branch = (int)branches[k];
                    scan(columns->f, &o, sign, parts[i].from, parts[i].to, &p);
                }
                assert_true(extreme_find(&l.a, &c, branches[k], sign, &e));
                if (column_quantity(&c) == QUANTITY_ANGLE)
                    turn = 360 * floor((e.value - (double)p.value) / 360 + 0.5);
                for (i = 0; i < p.n; i++) {
                    double d = e.angle - (double)(p.theta2[i] * 180 / PIL);

                    if (periodic)
                        d -= 360 * floor(d / 360 + 0.5);
                    nearest = fabs(d) < nearest ? fabs(d) : nearest;
                }
                if ((what & VALUES) && !(fabs(e.value - turn - (double)p.value) <=
                                         1e-9 * fabs((double)p.value) + 1e-15))
                    fail_msg("%s(%s), %s = %.17g at %.17g deg, expected %.17g at %.17g\n%s",
                             sign > 0 ? "max" : "min", columns->name, branch_name(branches[k]),
                             e.value, e.angle, (double)p.value, (double)(p.theta2[0] * 180 / PIL),
                             contents);
                if ((what & ANGLES) && !(nearest <= 1e-6))
                    fail_msg("%s(%s), %s = %.17g at %.17g deg, expected %.17g at %.17g\n%s",
                             sign > 0 ? "max" : "min", columns->name, branch_name(branches[k]),
                             e.value, e.angle, (double)p.value, (double)(p.theta2[0] * 180 / PIL),
                             contents);
                if (periodic)
                    assert_true(e.angle >= l.d.motion.from - 360 && e.angle <= 720);
            }
    unload(&l);
}

/* One revolution at constant speed. */
static void check_revolution(const char *contents, const own_entry *columns, own o, int what)
{
    part whole = {o, 0, 2 * PIL};

    check_extremes(contents, columns, &whole, 1, 1, what);
}

static const char *revolution(double speed)
{
    return print("[motion]\nspeed = %.17g rad/s\ninterval = 40 deg\n", speed);
}

/* Lengths of a crank-rocker, not near its change points. */
static own random_rocker(uint64_t *seed)
{
    own o = {0};

    do {
        o.a = uniform(seed, 0.1, 0.5);
        o.b = uniform(seed, 0.3, 1);
        o.c = uniform(seed, 0.3, 1);
        o.d = uniform(seed, 0.3, 1);
    } while (o.a > 0.8L * fminl(o.b, fminl(o.c, o.d)) ||
             2 * (o.a + fmaxl(o.b, fmaxl(o.c, o.d))) > 0.9L * (o.a + o.b + o.c + o.d));
    o.speed = uniform(seed, -20, 20);
    return o;
}

static own random_engine(uint64_t *seed, int offset)
{
    own o = {0};

    o.a = uniform(seed, 0.1, 0.5);
    o.d = offset ? o.a * uniform(seed, -0.7, 0.7) : 0;
    o.b = (o.a + fabsl(o.d)) * uniform(seed, 1.3, 4);
    o.speed = uniform(seed, -20, 20);
    return o;
}

static void check_rockers(int what)
{
    own o = {0.020L, 0.066L, 0.056L, 0.080L, 1, 0, 10.5L, 0, 0, 0};
    uint64_t seed = 1;
    int i;

    check_revolution(four_bar(0.020, 0.066, 0.056, 0.080, revolution(10.5)), of_four_bar, o, what);
    for (i = 0; i < 12; i++) {
        o = random_rocker(&seed);
        check_revolution(four_bar((double)o.a, (double)o.b, (double)o.c, (double)o.d,
                                  revolution((double)o.speed)),
                         of_four_bar, o, what);
    }
}

static void check_pistons(int what)
{
    uint64_t seed = 2;
    int i;

    for (i = 0; i < 12; i++) {
        own o = random_engine(&seed, i % 2);

        check_revolution(
            slider_crank((double)o.a, (double)o.b, (double)o.d, revolution((double)o.speed)),
            of_slider_crank, o, what);
    }
}

static void test_extremes_of_rockers(void **unused)
{
    (void)unused;
    check_rockers(VALUES);
}

static void test_angles_of_extremes_of_rockers(void **unused)
{
    (void)unused;
    check_rockers(ANGLES);
}

static void test_extremes_of_pistons(void **unused)
{
    (void)unused;
    check_pistons(VALUES);
}

static void test_angles_of_extremes_of_pistons(void **unused)
{
    (void)unused;
    check_pistons(ANGLES);
}

static void check_forces(int what)
{
    uint64_t seed = 3;
    int i;

    for (i = 0; i < 12; i++) {
        own o = random_engine(&seed, i % 2);
        double bore = uniform(&seed, 0.02, 0.2), p = uniform(&seed, 1e4, 1e6);

        o.mass = uniform(&seed, 1, 50);
        o.gas = PIL / 4 * bore * bore * p;
        check_revolution(slider_crank((double)o.a, (double)o.b, (double)o.d,
                                      print("%s[piston]\nmass = %.17g kg\n[gas]\nbore = %.17g m\n"
                                            "pressure = %.17g Pa\n[gravity]\nacceleration = 0\n",
                                            revolution((double)o.speed), (double)o.mass, bore, p)),
                         of_piston_forces, o, what);
    }
}

static void test_extremes_of_torques(void **unused)
{
    (void)unused;
    check_forces(VALUES);
}

static void test_angles_of_extremes_of_torques(void **unused)
{
    (void)unused;
    check_forces(ANGLES);
}

/* Both cranks turn fully: what does not go on and on. */
static void test_extremes_of_a_drag_link(void **unused)
{
    static const own_entry columns[] = {{"omega3", own_omega3}, {"alpha3", own_alpha3},
                                        {"omega4", own_omega4}, {"alpha4", own_alpha4},
                                        {"mu", own_mu},         {NULL, NULL}};
    own o = {0.50L, 0.45L, 0.60L, 0.20L, 1, 0, 3, 0, 0, 0};

    (void)unused;
    check_revolution(four_bar(0.50, 0.45, 0.60, 0.20, revolution(3)), columns, o, VALUES);
}

/* The extreme of a column, in the deck's unit. */
static extreme extreme_of(const loaded *l, const char *name, fourlink_branch branch, int sign)
{
    analysis a = l->a;
    extreme e = {NAN, NAN};
    column c;

    assert_true(column_find(&l->d, flk_text_of(name), &c));
    assert_int_equal(extreme_find(&a, &c, branch, sign, &e), 1);
    return e;
}

static double turned(double angle, double turn)
{
    return angle - turn * floor(angle / turn + 0.5);
}

static void check_at(double angle, double expected, double turn, int what)
{
    if (what & ANGLES)
        assert_near(turned(angle - expected, turn), 0, 1e-6);
}

/* A rocker that swings to and fro between two dead positions of the crank, through 180 deg: its angle goes
** on through the gap of the revolution, wherever this begins.  On the open branch it is greatest where
** BCD is a line, the crank at -dead, and least where ABC is a line;
** on the crossed branch the mirror image of this. */
static void test_extremes_of_an_angle_over_a_gap(void **unused)
{
    static const double a = 0.040, b = 0.030, c = 0.050, d = 0.075;
    static const char *const motions[] = {"speed = 2 rad/s\n", "speed = -2 rad/s\n",
                                          "speed = 2 rad/s\nfrom = -60 deg\n",
                                          "speed = -2 rad/s\nfrom = 430.5 deg\n"};
    double dead = acos((a * a + d * d - (b + c) * (b + c)) / (2 * a * d));
    double greatest = 360 - atan2(a * sin(dead), a * cos(dead) - d) / DEG;
    double least = 180 - acos((c * c + d * d - (a + b) * (a + b)) / (2 * c * d)) / DEG;
    size_t i;
    loaded l;

    (void)unused;
    for (i = 0; i < sizeof motions / sizeof motions[0]; i++) {
        extreme open, crossed;

        load(four_bar(a, b, c, d, print("[motion]\n%s", motions[i])), &l);
        open = extreme_of(&l, "theta4", FOURLINK_OPEN, 1);
        crossed = extreme_of(&l, "theta4", FOURLINK_CROSSED, -1);
        assert_near(turned(open.value - greatest, 360), 0, 1e-6);
        assert_near(turned(crossed.value + greatest, 360), 0, 1e-6);
        check_at(open.angle, -dead / DEG, 360, ANGLES);
        check_at(crossed.angle, dead / DEG, 360, ANGLES);
        assert_near(open.value - extreme_of(&l, "theta4", FOURLINK_OPEN, -1).value,
                    greatest - least, 1e-6);
        assert_near(extreme_of(&l, "theta4", FOURLINK_CROSSED, 1).value - crossed.value,
                    greatest - least, 1e-6);
        unload(&l);
    }
}

/* Peaks of a motion that ends in a gap, one of them between the last sample and the gap: by dense samples. */
static void test_extremes_of_angles_beside_gaps(void **unused)
{
    static const struct {
        double a, b, c, d;
        const char *motion;
        double least; /* of theta4, open, deg */
    } cases[] = {{0.218389, 0.075088, 0.363783, 0.117999,
                  "speed = -37 rad/s\nfrom = -90 deg\nto = -450 deg\n", -225.538742},
                 {0.284458, 0.14085, 0.369833, 0.0607668, "speed = 6 rad/s\n", 25.94287}};
    size_t i;
    loaded l;

    (void)unused;
    for (i = 0; i < 2; i++) {
        load(four_bar(cases[i].a, cases[i].b, cases[i].c, cases[i].d,
                      print("[motion]\n%s", cases[i].motion)),
             &l);
        assert_near(extreme_of(&l, "theta4", FOURLINK_OPEN, -1).value, cases[i].least, 1e-5);
        unload(&l);
    }
    load(slider_crank(0.256, 0.057, 0, "[motion]\nspeed = 27 rad/s\nto = 160 deg\n"), &l);
    assert_near(extreme_of(&l, "theta3", FOURLINK_CROSSED, -1).value, 180, 1e-6);
    unload(&l);
}

/* A horizontal engine: with s = sin^2(theta2), n = l / r, the speed of the piston is greatest where
** s^3 - n^2 s^2 - n^4 s + n^4 = 0. */
static void check_engine_in_closed_form(int what)
{
    static const double ratios[] = {1.5, 3, 4, 10, 1000};
    int i, k;

    for (i = 0; i < 5; i++) {
        double n = ratios[i], r = 0.15, omega = 12, low = 0, high = 1, s, t, v, mu;
        loaded l;

        for (k = 0; k < 200; k++) {
            s = (low + high) / 2;
            if (((s - n * n) * s - pow(n, 4)) * s + pow(n, 4) > 0)
                low = s;
            else
                high = s;
        }
        s = (low + high) / 2;
        t = asin(sqrt(s));
        v = r * omega * (sin(t) + sin(2 * t) / (2 * sqrt(n * n - s)));
        mu = acos(1 / n) / DEG;
        load(slider_crank(r, n * r, 0, revolution(omega)), &l);
        for (k = 0; k < 2; k++) {
            fourlink_branch b = branches[k];
            double at = k ? 180 : 0; /* the inner dead centre */
            extreme e = extreme_of(&l, "v", b, 1);

            assert_close(e.value, v, 1e-9);
            check_at(e.angle, at + t / DEG, 360, what);
            e = extreme_of(&l, "v", b, -1);
            assert_close(e.value, -v, 1e-9);
            check_at(e.angle, at - t / DEG, 360, what);
            e = extreme_of(&l, "x", b, 1);
            assert_close(e.value, 2 * r, 1e-9);
            check_at(e.angle, at + 180, 360, what);
            e = extreme_of(&l, "x", b, -1);
            assert_near(e.value, 0, 1e-15);
            check_at(e.angle, at, 360, what);
            e = extreme_of(&l, "a", b, 1);
            assert_close(e.value, r * omega * omega * (1 + 1 / n), 1e-9);
            check_at(e.angle, at, 360, what);
            e = extreme_of(&l, "mu", b, -1);
            assert_close(e.value, mu, 1e-9);
            e = extreme_of(&l, "phi", b, 1);
            assert_close(e.value, 90 - mu, 1e-9);
            check_at(e.angle, 90, 360, what);
            e = extreme_of(&l, "phi", b, -1);
            assert_close(e.value, mu - 90, 1e-9);
            check_at(e.angle, 270, 360, what);
            e = extreme_of(&l, "mu", b, 1);
            assert_near(e.value, 90, 9e-8);
            check_at(e.angle, 0, 180, what);
            e = extreme_of(&l, "x_harmonic", b, 1);
            assert_close(e.value, 2 * r, 1e-9);
            e = extreme_of(&l, "v_harmonic", b, 1);
            assert_close(e.value, r * omega, 1e-9);
        }
        unload(&l);
    }
}

static void test_extremes_of_an_engine_in_closed_form(void **unused)
{
    (void)unused;
    check_engine_in_closed_form(VALUES);
}

static void test_angles_of_extremes_of_an_engine_in_closed_form(void **unused)
{
    (void)unused;
    check_engine_in_closed_form(ANGLES);
}

/* The limits of a crank-rocker are the extremes of theta4 and mu. */
static void test_extremes_and_limits_agree(void **unused)
{
    uint64_t seed = 4;
    int i, k;

    (void)unused;
    for (i = 0; i < 10; i++) {
        own o = random_rocker(&seed);
        fourlink_limits limits;
        loaded l;

        load(four_bar((double)o.a, (double)o.b, (double)o.c, (double)o.d, revolution(1)), &l);
        for (k = 0; k < 2; k++) {
            extreme min = extreme_of(&l, "theta4", branches[k], -1),
                    max = extreme_of(&l, "theta4", branches[k], 1);

            assert_int_equal(fourlink_limits_of(&l.d.mechanism, branches[k], &limits), FOURLINK_OK);
            assert_near(min.value, limits.theta4_min / DEG, 1e-9 * 180);
            assert_near(max.value, limits.theta4_max / DEG, 1e-9 * 180);
            min = extreme_of(&l, "mu", branches[k], -1);
            max = extreme_of(&l, "mu", branches[k], 1);
            assert_close(min.value, limits.mu_min / DEG, 1e-9);
            assert_close(max.value, limits.mu_max / DEG, 1e-9);
        }
        unload(&l);
    }
}

/* ---------------------------------------------------------------------------------------------
** Extremes of other motions
** ------------------------------------------------------------------------------------------- */

static void test_extremes_at_the_ends_of_a_range(void **unused)
{
    static const char *const ranges[] = {"from = 10 deg\nto = 50 deg\n",
                                         "from = 50 deg\nto = 10 deg\n"};
    own o = {0.15L, 0.45L, 0, 0, 1, 0, 12, 0, 0, 0};
    int i;

    (void)unused;
    for (i = 0; i < 2; i++) {
        part p = {o, 10 * PIL / 180, 50 * PIL / 180};
        char *contents = slider_crank(
            0.15, 0.45, 0, print("[motion]\nspeed = 12 rad/s\ninterval = 40 deg\n%s", ranges[i]));
        extreme e;
        loaded l;

        check_extremes(contents, of_slider_crank, &p, 1, 0, VALUES | ANGLES);
        load(contents, &l);
        e = extreme_of(&l, "x", FOURLINK_OPEN, 1);
        assert_true(e.angle == 50);
        e = extreme_of(&l, "x", FOURLINK_OPEN, -1);
        assert_true(e.angle == 10);
        unload(&l);
    }
}

/* A minimum of theta4 a little inside the first, or the last, angle of a range. */
static void test_extremes_just_inside_an_end(void **unused)
{
    static const own_entry columns[] = {{"theta4", own_theta4}, {"mu", own_mu}, {NULL, NULL}};
    static const double insets[] = {0.9, 0.3, 0.01, 1e-5, 0};
    own o = {0.020L, 0.066L, 0.056L, 0.080L, 1, 0, 1, 0, 0, 0};
    double at = acos((6400. + 7396 - 3136) / (2 * 80 * 86)) / DEG;
    int i, end;

    (void)unused;
    for (i = 0; i < 5; i++)
        for (end = 0; end < 2; end++) {
            double from = end ? at - 200 : at - insets[i], to = end ? at + insets[i] : at + 200;
            part p = {o, (long double)from * PIL / 180, (long double)to * PIL / 180};

            check_extremes(
                four_bar(0.020, 0.066, 0.056, 0.080,
                         print("[motion]\nspeed = 1 rad/s\nfrom = %.17g deg\nto = %.17g deg\n",
                               from, to)),
                columns, &p, 1, 0, VALUES);
        }
}

/* From rest: 2 alpha s = omega^2 up to an angle, where alpha jumps to 0, then a revolution. */
static void test_extremes_of_a_run_up(void **unused)
{
    static const double angles_[] = {100, 37.5, 200.25};
    uint64_t seed = 5;
    int i, sign;

    (void)unused;
    for (i = 0; i < 6; i++)
        for (sign = -1; sign <= 1; sign += 2) {
            own o = i % 2 ? random_engine(&seed, 1) : random_rocker(&seed), after;
            long double end = sign * (long double)angles_[i / 2] * PIL / 180;
            const char *motion =
                print("[motion]\nrun_up = %.17g deg\nacceleration = %d rad/s2\ninterval = 40 deg\n",
                      angles_[i / 2], sign * 30);
            part p[2];

            o.speed = 0;
            o.acceleration = sign * 30;
            after = o;
            after.speed = sign * sqrtl(2 * o.acceleration * end);
            after.acceleration = 0;
            p[0].o = o;
            p[0].from = sign > 0 ? 0 : end;
            p[0].to = sign > 0 ? end : 0;
            p[1].o = after;
            p[1].from = sign > 0 ? end : end - 2 * PIL;
            p[1].to = sign > 0 ? end + 2 * PIL : end;
            if (i % 2)
                check_extremes(slider_crank((double)o.a, (double)o.b, (double)o.d, motion),
                               of_slider_crank, p, 2, 0, VALUES);
            else
                check_extremes(four_bar((double)o.a, (double)o.b, (double)o.c, (double)o.d, motion),
                               of_four_bar, p, 2, 0, VALUES);
        }
}

static void test_extremes_of_accelerated_motion(void **unused)
{
    uint64_t seed = 6;
    int i;

    (void)unused;
    for (i = 0; i < 6; i++) {
        own o = i % 2 ? random_engine(&seed, 1) : random_rocker(&seed);
        double to =
            i % 3 ? uniform(&seed, 90, 1000) : 380; /* one revolution, whose ends do not meet */
        part p = {o, 20 * PIL / 180, (long double)to * PIL / 180};
        const char *motion;

        /* slowing down, but not to rest */
        p.o.speed = o.speed = 20;
        p.o.acceleration = o.acceleration = i < 3 ? 7 : -7;
        p.o.start = 20 * PIL / 180;
        motion = print("[motion]\nspeed = 20 rad/s\nacceleration = %d rad/s2\nfrom = 20 deg\n"
                       "to = %.17g deg\ninterval = 40 deg\n",
                       i < 3 ? 7 : -7, to);
        if (i % 2)
            check_extremes(slider_crank((double)o.a, (double)o.b, (double)o.d, motion),
                           of_slider_crank, &p, 1, 0, VALUES);
        else
            check_extremes(four_bar((double)o.a, (double)o.b, (double)o.c, (double)o.d, motion),
                           of_four_bar, &p, 1, 0, VALUES);
    }
}

/* 10 rad/s, -20 rad/s2: the crank comes to rest after 2.5 rad = 143.2 deg, whatever the interval. */
static void test_extremes_of_a_crank_that_stops(void **unused)
{
    static const double intervals[] = {0.1, 1, 40, 143};
    own o = {0.020L, 0.066L, 0.056L, 0.080L, 1, 0, 10, -20, 0, 0};
    part p = {o, 0, 2.5L};
    int i;

    (void)unused;
    for (i = 0; i < 4; i++)
        check_extremes(four_bar(0.020, 0.066, 0.056, 0.080,
                                print("[motion]\nspeed = 10 rad/s\nacceleration = -20 rad/s2\n"
                                      "interval = %g deg\n",
                                      intervals[i])),
                       of_four_bar, &p, 1, 0, VALUES);
}

static void test_extremes_do_not_depend_on_the_interval(void **unused)
{
    static const char *const names[] = {"theta3", "omega3", "alpha3", "theta4", "omega4",
                                        "alpha4", "mu",     "Ts",     "F12",    "F14x"};
    static const double intervals[] = {360, 40, 7, 1, 0.25};
    extreme first[2 * 10];
    int i, j;

    (void)unused;
    for (i = 0; i < 5; i++) {
        loaded l;

        load(four_bar(0.020, 0.066, 0.056, 0.080,
                      print("[load]\nlink = rocker\ntorque = 3 N m\n[motion]\nspeed = 10 rad/s\n"
                            "interval = %g deg\n",
                            intervals[i])),
             &l);
        for (j = 0; j < 20; j++) {
            extreme e = extreme_of(&l, names[j / 2], FOURLINK_OPEN, j % 2 ? 1 : -1);

            if (i == 0)
                first[j] = e;
            assert_close(e.value, first[j].value, 1e-9);
            assert_near(turned(e.angle - first[j].angle, 360), 0, 1e-6);
        }
        unload(&l);
    }
}

/* Where the crank does not turn fully, columns that stay finite have their extremes at dead positions,
** which they approach as a square root does. */
static void test_extremes_towards_dead_positions(void **unused)
{
    double end = acos((0.09 + 0.5625 - 0.81) / (2 * 0.3 * 0.75));
    loaded l;
    extreme e;
    int k;

    (void)unused;
    load(four_bar(0.3, 0.4, 0.5, 0.75, revolution(1)), &l);
    for (k = 0; k < 2; k++) {
        e = extreme_of(&l, "mu", branches[k], -1);
        assert_near(e.value, 0, 1e-4);
        assert_near(fabs(turned(e.angle, 360)), end / DEG, 1e-4);
    }
    unload(&l);
}

/* r = 400, l = 200 mm: x is least at the inner dead centre; at the ends X = 400 cos(30 deg). */
static void test_extremes_towards_dead_positions_of_a_piston(void **unused)
{
    loaded l;
    extreme e;

    (void)unused;
    load(
        slider_crank(0.4, 0.2, 0,
                     "[motion]\nspeed = 1 rad/s\nfrom = -100 deg\nto = 80 deg\ninterval = 7 deg\n"),
        &l);
    e = extreme_of(&l, "x", FOURLINK_OPEN, -1);
    assert_near(e.value, 0, 1e-15);
    e = extreme_of(&l, "x", FOURLINK_OPEN, 1);
    assert_near(e.value, 0.6 - 0.4 * cos(PI / 6), 1e-6);
    assert_near(fabs(e.angle), 30, 1e-4);
    unload(&l);
}

/* A pressure that rises and falls within three degrees, of a card that is else flat. */
static void test_extremes_of_a_narrow_card(void **unused)
{
    loaded l;
    extreme e;

    (void)unused;
    load(slider_crank(0.15, 0.45, 0,
                      print("[gas]\nbore = 100 mm\nindicator = 0 deg 1 bar, 12.2 deg 1 bar,\n"
                            "13.7 deg 60 bar, 15.2 deg 1 bar, 200 deg 1 bar\n%s",
                            revolution(10))),
         &l);
    e = extreme_of(&l, "gas_force", FOURLINK_OPEN, 1);
    assert_close(e.value, 60e5 * PI / 4 * 0.01, 1e-9);
    assert_near(e.angle, 13.7, 1e-6);
    e = extreme_of(&l, "gas_force", FOURLINK_OPEN, -1);
    assert_close(e.value, 1e5 * PI / 4 * 0.01, 1e-9);
    unload(&l);
}

static void test_extremes_in_the_units_of_the_deck(void **unused)
{
    loaded l;
    extreme e;

    (void)unused;
    load(slider_crank(0.15, 0.45, 0,
                      "[motion]\nspeed = 12 rad/s\n[units]\nlength = mm\nangle = rad\n"),
         &l);
    e = extreme_of(&l, "x", FOURLINK_OPEN, 1);
    assert_near(e.value, 300, 3e-7);
    assert_near(e.angle, PI, 1e-8);
    e = extreme_of(&l, "phi", FOURLINK_OPEN, 1);
    assert_close(e.value, asin(1. / 3), 1e-9);
    assert_near(e.angle, PI / 2, 1e-8);
    unload(&l);
}

/* One instant is its own maximum and minimum. */
static void test_extremes_of_one_instant(void **unused)
{
    loaded l;
    extreme e;
    int sign;

    (void)unused;
    load(slider_crank(0.15, 0.45, 0, "[motion]\nspeed = 12 rad/s\nat = 60 deg\n"), &l);
    for (sign = -1; sign <= 1; sign += 2) {
        e = extreme_of(&l, "x", FOURLINK_OPEN, sign);
        assert_near(e.value, 0.6 - 0.15 * 0.5 - sqrt(0.2025 - 0.0225 * 0.75), 1e-15);
        assert_true(e.angle == 60);
    }
    unload(&l);
}

/* ---------------------------------------------------------------------------------------------
** Facts
** ------------------------------------------------------------------------------------------- */

typedef struct fact_list {
    int n;
    fact list[200];
} fact_list;

static void take_fact(const fact *f, void *data)
{
    fact_list *list = data;

    assert_true(list->n < 200);
    assert_true(f->words || f->value - f->value == 0); /* finite */
    assert_true(f->meaning && *f->meaning && f->unit);
    list->list[list->n++] = *f;
}

/* The fact of a deck by that name, for both branches or for this one; null if there is none. */
static const fact *find_fact(const fact_list *list, const char *name, fourlink_branch branch)
{
    const fact *found = NULL;
    int i;

    for (i = 0; i < list->n; i++)
        if (strcmp(list->list[i].name, name) == 0 &&
            (list->list[i].branch == 0 || list->list[i].branch == (int)branch)) {
            assert_null(found);
            found = &list->list[i];
        }
    return found;
}

static void facts_of(const char *contents, fact_list *list)
{
    loaded l;

    load(contents, &l);
    list->n = 0;
    facts_tell(&l.a, 0, 1, NULL, take_fact, list);
    unload(&l);
}

/* The value of a fact, which must be there, in the deck's unit. */
static double value_of(const fact_list *list, const char *name, fourlink_branch branch)
{
    const fact *f = find_fact(list, name, branch);

    if (!f || f->words)
        fail_msg("no fact %s", name);
    return f->value;
}

static void check_fact(const fact_list *list, const char *name, fourlink_branch branch,
                       double expected, double tolerance)
{
    double value = value_of(list, name, branch);

    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%s, %s = %.17g, expected %.17g +- %.3g", name, branch_name(branch), value,
                 expected, tolerance);
}

static void test_facts_of_linkages(void **unused)
{
    static fact_list list;
    const fact *f;

    (void)unused;
    facts_of(four_bar(0.020, 0.066, 0.056, 0.080, revolution(10.5)), &list);
    f = find_fact(&list, "type", FOURLINK_OPEN);
    assert_non_null(f);
    assert_string_equal(f->words, "crank-rocker");
    check_fact(&list, "K", FOURLINK_OPEN, 2790e-6, 1e-17);
    check_fact(&list, "theta2_from", FOURLINK_OPEN, 0, 0);
    check_fact(&list, "theta2_to", FOURLINK_OPEN, 360, 1e-13);
    check_fact(&list, "theta4_min", FOURLINK_OPEN, 180 - acos(2140. / 8960) / DEG, 1e-12);
    check_fact(&list, "theta4_max", FOURLINK_OPEN, 180 - acos(7420. / 8960) / DEG, 1e-12);
    check_fact(&list, "swing", FOURLINK_CROSSED, (acos(2140. / 8960) - acos(7420. / 8960)) / DEG,
               1e-12);
    check_fact(&list, "mu_min", FOURLINK_CROSSED, acos(3892. / 7392) / DEG, 1e-12);
    f = find_fact(&list, "theta4_min", FOURLINK_OPEN);
    assert_true(f->has_angle);
    assert_near(f->theta2, acos(10660. / 13760) / DEG, 1e-12);
    f = find_fact(&list, "theta4_max", FOURLINK_CROSSED);
    assert_near(f->value, -180 + acos(2140. / 8960) / DEG, 1e-12);
    assert_near(f->theta2, 360 - acos(10660. / 13760) / DEG, 1e-12);
    assert_null(find_fact(&list, "stroke", FOURLINK_OPEN));
    assert_null(find_fact(&list, "n", FOURLINK_OPEN));
    assert_null(find_fact(&list, "mean_torque", FOURLINK_OPEN));
}

/* The limits of link 4 where the crank does not turn fully, with A, B, C in one line: 300 + 400 mm from
** A to C in the triangle of 500 and 750 mm; in a crank-rocker a range above the ground and one below. */
static void test_reach_of_link_4(void **unused)
{
    static fact_list list;
    double half = acos((0.25 + 0.5625 - 0.49) / (2 * 0.5 * 0.75)) / DEG;
    double from[2], to[2], low = 180 - acos(2140. / 8960) / DEG,
                           high = 180 - acos(7420. / 8960) / DEG;
    int i, n_from = 0, n_to = 0, above;

    (void)unused;
    facts_of(four_bar(0.3, 0.4, 0.5, 0.75, ""), &list);
    check_fact(&list, "theta4_from", FOURLINK_OPEN, 180 - half, 1e-12);
    check_fact(&list, "theta4_to", FOURLINK_OPEN, 180 + half, 1e-12);
    check_fact(&list, "theta4_swing", FOURLINK_OPEN, 2 * half, 1e-12);
    facts_of(four_bar(0.020, 0.066, 0.056, 0.080, ""), &list);
    for (i = 0; i < list.n; i++) {
        if (strcmp(list.list[i].name, "theta4_from") == 0 && n_from < 2)
            from[n_from++] = turned(list.list[i].value, 360);
        if (strcmp(list.list[i].name, "theta4_to") == 0 && n_to < 2)
            to[n_to++] = turned(list.list[i].value, 360);
        if (strcmp(list.list[i].name, "theta4_swing") == 0)
            assert_near(list.list[i].value, high - low, 1e-11);
    }
    assert_true(n_from == 2 && n_to == 2);
    above = from[0] > 0 ? 0 : 1;
    assert_near(from[above], low, 1e-11);
    assert_near(to[above], high, 1e-11);
    assert_near(from[1 - above], -high, 1e-11);
    assert_near(to[1 - above], -low, 1e-11);
}

static void test_facts_of_engines(void **unused)
{
    static fact_list list;
    const char *rod = "mechanism = slider-crank\n[units]\nlength = mm\n[crank]\nlength = 150\n"
                      "[rod]\nlength = 450\nmass = 2 kg\ngyration = 175\ncg = 150\n";
    const fact *f;

    (void)unused;
    facts_of(rod, &list);
    f = find_fact(&list, "type", FOURLINK_OPEN);
    assert_string_equal(f->words, "slider-crank, the crank turns fully");
    check_fact(&list, "n", FOURLINK_OPEN, 3, 1e-15);
    check_fact(&list, "k", FOURLINK_OPEN, 175, 1e-12);
    check_fact(&list, "m_a", FOURLINK_OPEN, 4. / 3, 1e-15);
    check_fact(&list, "m_b", FOURLINK_OPEN, 2. / 3, 1e-15);
    check_fact(&list, "L", FOURLINK_OPEN, 300 + 175. * 175 / 300, 1e-12);
    check_fact(&list, "stroke", FOURLINK_CROSSED, 300, 1e-12);
    check_fact(&list, "inner_dead_centre", FOURLINK_OPEN, 0, 0);
    check_fact(&list, "outer_dead_centre", FOURLINK_OPEN, 180, 1e-12);
    check_fact(&list, "inner_dead_centre", FOURLINK_CROSSED, 180, 1e-12);
    check_fact(&list, "mu_min", FOURLINK_OPEN, acos(1. / 3) / DEG, 1e-12);
    assert_null(find_fact(&list, "K", FOURLINK_OPEN));
    assert_null(find_fact(&list, "swing", FOURLINK_OPEN));

    /* in another unit of angle, on one branch */
    facts_of("mechanism = slider-crank\n[units]\nangle = rev\n[crank]\nlength = 0.15\n[rod]\n"
             "length = 0.45\n[table]\nbranch = crossed\n",
             &list);
    check_fact(&list, "theta2_to", FOURLINK_OPEN, 1, 1e-15);
    check_fact(&list, "inner_dead_centre", FOURLINK_CROSSED, 0.5, 1e-15);
    assert_null(find_fact(&list, "inner_dead_centre", FOURLINK_OPEN));
}

/* ---------------------------------------------------------------------------------------------
** The turning moment
** ------------------------------------------------------------------------------------------- */

static const char still[] = "[gravity]\nacceleration = 0\n";

/* A piston alone takes up and gives back its kinetic energy. */
static void test_energy_of_a_piston(void **unused)
{
    static fact_list list;
    uint64_t seed = 7;
    int i, k;

    (void)unused;
    for (i = 0; i < 12; i++) {
        own o = random_engine(&seed, i % 2);
        double m = uniform(&seed, 1, 50), omega = (double)o.speed;

        facts_of(
            slider_crank((double)o.a, (double)o.b, (double)o.d,
                         print("%s%s[piston]\nmass = %.17g kg\n", revolution(omega), still, m)),
            &list);
        for (k = 0; k < 2; k++) {
            peaks fast = {0};
            double v;

            o.branch = (int)branches[k];
            scan(own_v, &o, 1, 0, 2 * PIL, &fast);
            v = (double)fast.value;
            memset(&fast, 0, sizeof fast);
            scan(own_v, &o, -1, 0, 2 * PIL, &fast);
            v = fmax(v, fabs((double)fast.value));
            check_fact(&list, "energy_fluctuation", branches[k], m * v * v / 2, 1e-9 * m * v * v);
            check_fact(&list, "mean_torque", branches[k], 0, 0);
            check_fact(&list, "mean_power", branches[k], 0, 0);
            assert_null(find_fact(&list, "energy_coefficient", branches[k]));
            assert_null(find_fact(&list, "flywheel_inertia", branches[k]));
            assert_null(find_fact(&list, "flywheel_fluctuation", branches[k]));
        }
    }
}

/* pA x less the kinetic energy. */
static long double own_energy(const own *o, long double t)
{
    long double v = own_v(o, t);

    return o->gas * own_x(o, t) - o->mass * v * v / 2;
}

static void test_energy_of_gas_and_piston(void **unused)
{
    static fact_list list;
    uint64_t seed = 8;
    int i, k;

    (void)unused;
    for (i = 0; i < 12; i++) {
        own o = random_engine(&seed, i % 2);
        double bore = uniform(&seed, 0.02, 0.2), p = uniform(&seed, -1e5, 1e6);

        o.mass = i % 3 ? uniform(&seed, 1, 50) : 0;
        o.gas = PIL / 4 * bore * bore * p;
        facts_of(slider_crank((double)o.a, (double)o.b, (double)o.d,
                              print("%s%s[piston]\nmass = %.17g kg\n[gas]\nbore = %.17g m\n"
                                    "pressure = %.17g Pa\n",
                                    revolution((double)o.speed), still, (double)o.mass, bore, p)),
                 &list);
        for (k = 0; k < 2; k++) {
            peaks max = {0}, min = {0};
            double dE;

            o.branch = (int)branches[k];
            scan(own_energy, &o, 1, 0, 2 * PIL, &max);
            scan(own_energy, &o, -1, 0, 2 * PIL, &min);
            dE = (double)(max.value - min.value);
            check_fact(&list, "energy_fluctuation", branches[k], dE, 1e-9 * dE);
            check_fact(&list, "mean_torque", branches[k], 0, 0);
            assert_null(find_fact(&list, "energy_coefficient", branches[k]));
        }
    }
}

/* Weights, with all inertia: conservative, so that the mean is 0 as well. */
static void test_mean_torque_of_conservative_machines(void **unused)
{
    static fact_list list;
    uint64_t seed = 9;
    int i, k;

    (void)unused;
    for (i = 0; i < 8; i++) {
        own o = i % 2 ? random_engine(&seed, 1) : random_rocker(&seed);

        if (i % 2)
            facts_of(print("mechanism = slider-crank\n[crank]\nlength = %.17g m\nmass = 2 kg\n"
                           "cg = 50 mm\n[rod]\nlength = %.17g m\nmass = 3 kg\ninertia = 0.1 kg m2\n"
                           "cg = 100 mm at 20 deg\n[piston]\nmass = 7 kg\n[ground]\n"
                           "offset = %.17g m\nangle = 50 deg\n%s",
                           (double)o.a, (double)o.b, (double)o.d, revolution((double)o.speed)),
                     &list);
        else
            facts_of(
                print("mechanism = four-bar\n[crank]\nlength = %.17g m\nmass = 2 kg\n"
                      "cg = 50 mm\n[coupler]\nlength = %.17g m\nmass = 3 kg\n"
                      "inertia = 0.1 kg m2\ncg = 100 mm at 20 deg\n[rocker]\nlength = %.17g m\n"
                      "mass = 1 kg\ngyration = 90 mm\n[ground]\nlength = %.17g m\n%s",
                      (double)o.a, (double)o.b, (double)o.c, (double)o.d,
                      revolution((double)o.speed)),
                &list);
        for (k = 0; k < 2; k++) {
            check_fact(&list, "mean_torque", branches[k], 0, 0);
            assert_null(find_fact(&list, "energy_coefficient", branches[k]));
            assert_true(value_of(&list, "energy_fluctuation", branches[k]) > 1e-3);
        }
    }
}

/* A constant torque on the rocker of a massless crank-rocker does its work over the swing; a constant
** force on a piston over the stroke. */
static void test_energy_is_force_times_way(void **unused)
{
    static fact_list list;
    uint64_t seed = 10;
    int i, k;

    (void)unused;
    for (i = 0; i < 8; i++) {
        own o = random_rocker(&seed);

        facts_of(four_bar((double)o.a, (double)o.b, (double)o.c, (double)o.d,
                          print("%s[load]\nlink = rocker\ntorque = -7 N m\n",
                                revolution((double)o.speed))),
                 &list);
        for (k = 0; k < 2; k++) {
            double swing = value_of(&list, "swing", branches[k]) * DEG;

            check_fact(&list, "energy_fluctuation", branches[k], 7 * swing, 1e-9 * 7);
            check_fact(&list, "mean_torque", branches[k], 0, 0);
        }
        o = random_engine(&seed, 1);
        facts_of(slider_crank((double)o.a, (double)o.b, (double)o.d,
                              print("%s[load]\nlink = piston\nforce = (300, 70) N\n",
                                    revolution((double)o.speed))),
                 &list);
        for (k = 0; k < 2; k++) {
            double stroke = value_of(&list, "stroke", branches[k]);

            check_fact(&list, "energy_fluctuation", branches[k], 300 * stroke, 1e-9 * 300 * stroke);
            check_fact(&list, "mean_torque", branches[k], 0, 0);
        }
    }
}

/* A drag link under a constant torque M on link 4, which turns once with the crank: the mean of the
** turning moment is M, the energy M times the lead of link 4 over the crank. */
static void test_energy_of_a_drag_link(void **unused)
{
    static fact_list list;
    own o = {0.50L, 0.45L, 0.60L, 0.20L, 1, 0, 1, 0, 0, 0};
    int i, k;

    (void)unused;
    facts_of(four_bar(0.50, 0.45, 0.60, 0.20,
                      print("%s[load]\nlink = rocker\ntorque = 5 N m\n", revolution(4))),
             &list);
    for (k = 0; k < 2; k++) {
        long double lead, least = 0, most = 0, before = 0, first = 0;

        o.branch = (int)branches[k];
        for (i = 0; i <= 40000; i++) {
            long double t = 2 * PIL * i / 40000;

            lead = own_angles(&o, t).t4 - t;
            if (i)
                lead -= 2 * PIL * floorl((lead - before) / (2 * PIL) + 0.5L);
            else
                first = least = most = lead;
            before = lead;
            least = lead < least ? lead : least;
            most = lead > most ? lead : most;
        }
        assert_near((double)(before - first), 0, 1e-12);
        check_fact(&list, "mean_torque", branches[k], 5, 5e-10);
        check_fact(&list, "mean_power", branches[k], 20, 2e-9);
        check_fact(&list, "energy_fluctuation", branches[k], 5 * (double)(most - least), 1e-7);
        check_fact(&list, "energy_coefficient", branches[k], (double)(most - least) / (2 * PI),
                   1e-8);
    }
}

/* A torque given as a curve on a massless mechanism is the turning moment. */
static char *with_curve(const char *torque, const char *more)
{
    return four_bar(0.020, 0.066, 0.056, 0.080,
                    print("[load]\nlink = crank\ntorque = %s\n%s", torque, more));
}

/* 100 N m for a quarter, 300 N m for a quarter, and two rises between them: a smooth curve that does not
** overshoot is level on the levels, so that the rises are cubics, 100 + 200 (3 t^2 - 2 t^3), that cross
** the mean of 200 half way.  Above it are 31.25 + 100 + 31.25 N m, times a quarter turn. */
static void test_turning_moment_in_closed_form(void **unused)
{
    static fact_list list;
    double dE = 162.5 * PI / 2;
    int k;

    (void)unused;
    facts_of(with_curve("0 deg 100, 90 deg 100, 180 deg 300, 270 deg 300",
                        "[motion]\nspeed = 20 rad/s\ninterval = 40 deg\n"),
             &list);
    for (k = 0; k < 2; k++) {
        check_fact(&list, "mean_torque", branches[k], 200, 2e-7);
        check_fact(&list, "mean_power", branches[k], 4000, 4e-6);
        check_fact(&list, "energy_fluctuation", branches[k], dE, 1e-9 * dE);
        check_fact(&list, "energy_coefficient", branches[k], dE / (400 * PI), 1e-9);
    }
    /* backwards, against the torque: the same energies, the power taken up */
    facts_of(with_curve("0 deg 100, 90 deg 100, 180 deg 300, 270 deg 300",
                        "[motion]\nspeed = -20 rad/s\n[units]\nenergy = kJ\ntorque = kN m\n"
                        "power = kW\n"),
             &list);
    /* bare numbers are in kN m now */
    for (k = 0; k < 2; k++) {
        check_fact(&list, "mean_torque", branches[k], 200, 2e-7);
        check_fact(&list, "mean_power", branches[k], -4000, 4e-6);
        check_fact(&list, "energy_fluctuation", branches[k], dE, 1e-9 * dE);
        check_fact(&list, "energy_coefficient", branches[k], dE / (400 * PI), 1e-9);
    }
    /* negative: it is a resistance */
    facts_of(with_curve("0 deg -100, 90 deg -100, 180 deg -300, 270 deg -300",
                        "[motion]\nspeed = 20 rad/s\n"),
             &list);
    check_fact(&list, "mean_torque", FOURLINK_OPEN, -200, 2e-7);
    check_fact(&list, "mean_power", FOURLINK_OPEN, -4000, 4e-6);
    check_fact(&list, "energy_fluctuation", FOURLINK_OPEN, dE, 1e-9 * dE);
    check_fact(&list, "energy_coefficient", FOURLINK_OPEN, dE / (400 * PI), 1e-9);
}

/* A four-stroke engine's curve, over 720 deg: the mean, and the energy between the crossings of the
** mean, by Gauss's rule of three points, exact for the cubics between the points. */
static void test_turning_moment_of_four_strokes(void **unused)
{
    static const double angle[] = {0,   20,  60,  110, 170, 200, 270, 340, 380, 395,
                                   420, 480, 540, 560, 600, 640, 660, 690, 705},
                        torque[] = {0,   -30, -80, -60, -20, 10, -150, -420, 100, 900,
                                    700, 300, 40,  0,   -40, 60, 200,  20,   -10};
    enum { POINTS = 19, CUTS = 400 };
    static fact_list list;
    char points[1000] = "", *contents;
    double area = 0, E = 0, least = 0, most = 0, mean, dE;
    int i, j, k, pass;
    loaded l;

    (void)unused;
    for (i = 0; i < POINTS; i++)
        sprintf(points + strlen(points), "%s%g deg %g N m", i ? ", " : "", angle[i], torque[i]);
    contents = with_curve(points, "[motion]\nspeed = 30 rad/s\ncycle = 720 deg\n[flywheel]\n"
                                  "fluctuation = 0.02\n");
    load(contents, &l);
    mean = 0;
    for (pass = 0; pass < 2; pass++) {
        const curve *c = &l.d.variations[0].torque;
        double w = sqrt(0.6);

        for (i = 0; i < POINTS; i++)
            for (j = 0; j < CUTS; j++) {
                double next = i + 1 < POINTS ? angle[i + 1] : 720,
                       h = (next - angle[i]) * DEG / CUTS, x = angle[i] * DEG + (j + 0.5) * h;
                double sum = (5 * flk_curve_value(c, x - w * h / 2) + 8 * flk_curve_value(c, x) +
                              5 * flk_curve_value(c, x + w * h / 2)) /
                             18 * h;
                double left = flk_curve_value(c, x - h / 2) - mean,
                       right = flk_curve_value(c, x + h / 2) - mean;

                if (!pass) {
                    area += sum;
                    continue;
                }
                if (left * right < 0) { /* a straight line will do within so short a piece */
                    double peak = E + left * h * left / (left - right) / 2;

                    least = fmin(least, peak);
                    most = fmax(most, peak);
                }
                E += sum - mean * h;
                least = fmin(least, E);
                most = fmax(most, E);
            }
        mean = area / (4 * PI);
    }
    assert_near(E, 0, 1e-9);
    unload(&l);
    dE = most - least;
    facts_of(contents, &list);
    for (k = 0; k < 2; k++) {
        check_fact(&list, "mean_torque", branches[k], mean, 1e-9 * fabs(mean));
        check_fact(&list, "mean_power", branches[k], 30 * mean, 3e-8 * fabs(mean));
        check_fact(&list, "energy_fluctuation", branches[k], dE, 1e-6 * dE);
        check_fact(&list, "energy_coefficient", branches[k], dE / (4 * PI * mean),
                   1e-6 * dE / mean);
        check_fact(&list, "flywheel_inertia", branches[k], dE / (0.02 * 900), 1e-6 * dE);
    }
}

/* A cycle of two revolutions in which all repeats after one: the same fluctuation, over twice the
** work. */
static void test_cycle_of_two_revolutions(void **unused)
{
    static fact_list once, twice;
    const char *masses = "[load]\nlink = crank\ntorque = 50 N m\n[piston]\nmass = 5 kg\n[motion]\n"
                         "speed = 30 rad/s\n";

    (void)unused;
    facts_of(slider_crank(0.15, 0.45, 0, masses), &once);
    facts_of(slider_crank(0.15, 0.45, 0, print("%scycle = 720 deg\n", masses)), &twice);
    check_fact(&once, "mean_torque", FOURLINK_OPEN, 50, 5e-8);
    check_fact(&twice, "mean_torque", FOURLINK_OPEN, 50, 5e-8);
    check_fact(&twice, "energy_fluctuation", FOURLINK_OPEN,
               value_of(&once, "energy_fluctuation", FOURLINK_OPEN), 1e-7);
    check_fact(&twice, "energy_coefficient", FOURLINK_OPEN,
               value_of(&once, "energy_coefficient", FOURLINK_OPEN) / 2, 1e-10);
}

/* A torque between two crank angles, the oldest exercise: M from .. to gives the mean M w / c, and the
** area above it (M - mean) w. */
static void test_turning_moment_in_steps(void **unused)
{
    static const double windows[][3] = {{0, 90, 360},  {10.3, 100.7, 360}, {350, 370, 360},
                                        {0, 180, 720}, {33.33, 35.9, 360}, {700, 719.5, 720},
                                        {90, 360, 360}};
    static fact_list list;
    int i;

    (void)unused;
    for (i = 0; i < 7; i++) {
        double from = windows[i][0], to = windows[i][1], cycle = windows[i][2],
               w = (to - from) * DEG, mean = 80 * (to - from) / cycle, dE = (80 - mean) * w;

        facts_of(
            four_bar(0.020, 0.066, 0.056, 0.080,
                     print("[load]\nlink = crank\ntorque = 80 N m\nfrom = %g deg\nto = %g deg\n"
                           "[motion]\nspeed = 10 rad/s\ncycle = %g deg\n",
                           from, to, cycle)),
            &list);
        check_fact(&list, "mean_torque", FOURLINK_OPEN, mean, 1e-11 * 80);
        check_fact(&list, "energy_fluctuation", FOURLINK_OPEN, dE, 1e-9 * dE);
        check_fact(&list, "energy_coefficient", FOURLINK_OPEN, 1 - mean / 80, 1e-8);
    }
}

/* A peak of Hermite cubics with level ends, of mean height 1/2. */
static void check_peak(double width)
{
    static fact_list list;
    double mean = 900 * width / 2 / 360;

    facts_of(with_curve(print("0 deg 0, %.17g deg 0, 100.1 deg 900, %.17g deg 0", 100.1 - width / 2,
                              100.1 + width / 2),
                        "[motion]\nspeed = 20 rad/s\n"),
             &list);
    check_fact(&list, "mean_torque", FOURLINK_OPEN, mean, 1e-9 * mean);
}

static void test_turning_moment_of_a_peak(void **unused)
{
    (void)unused;
    check_peak(30);
    check_peak(3);
}

/* What comes and goes within a degree: the mean, and the energy M w of a step. */
static void test_turning_moment_within_a_degree(void **unused)
{
    (void)unused;
    check_peak(0.5);
}

static void test_step_within_a_degree(void **unused)
{
    static fact_list list;
    double w = 0.7 * DEG, mean = 80 * 0.7 / 360;

    (void)unused;
    facts_of(four_bar(0.020, 0.066, 0.056, 0.080,
                      "[load]\nlink = crank\ntorque = 80 N m\nfrom = 0.2 deg\nto = 0.9 deg\n"
                      "[motion]\nspeed = 10 rad/s\n"),
             &list);
    check_fact(&list, "mean_torque", FOURLINK_OPEN, mean, 1e-11 * 80);
    check_fact(&list, "energy_fluctuation", FOURLINK_OPEN, (80 - mean) * w, 1e-9 * 80 * w);
}

/* What the flywheel takes up while the crank passes an area, in time: the power above its mean. */
static void check_areas(const char *contents, int at_least)
{
    enum { STEPS = 20000 };
    turning t;
    loaded l;
    int k, i, b;

    load(contents, &l);
    for (b = 0; b < 2; b++) {
        double end = 0, least = HUGE_VAL;

        assert_int_equal(turning_find(&l.a, branches[b], &t), 1);
        assert_true(t.n_areas >= at_least);
        for (k = 0; k < t.n_areas; k++) {
            double width = t.area[k].to - t.area[k].from, speed = l.d.motion.speed, gain = 0;

            assert_true(t.area[k].from == end && width > 0);
            end = t.area[k].to;
            for (i = 0; i < STEPS; i++) {
                fourlink_crank crank = {0, 0, 0};
                result r;

                crank.theta2 = t.area[k].from + (i + 0.5) / STEPS * width;
                crank.omega2 = speed;
                analysis_at(&l.a, branches[b], &crank, &r);
                assert_int_equal(r.status, FOURLINK_OK);
                gain += (-r.forces.Ts * speed - t.mean_power) * width / STEPS / fabs(speed);
            }
            assert_close(t.area[k].energy, gain, 1e-6 * t.energy_fluctuation);
            least = fmin(least, fabs(gain));
        }
        assert_true(end == l.d.cycle);
        assert_true(least > 1e-3 * t.energy_fluctuation); /* none of them is two */
    }
    unload(&l);
}

static void test_areas_of_the_turning_moment(void **unused)
{
    static const char *const speeds[] = {"10 rad/s", "-10 rad/s"};
    int i;

    (void)unused;
    for (i = 0; i < 2; i++) {
        check_areas(four_bar(0.020, 0.066, 0.056, 0.080,
                             print("[load]\nlink = crank\ntorque = 80 N m\nfrom = 30 deg\n"
                                   "to = 90 deg\n[motion]\nspeed = %s\n",
                                   speeds[i])),
                    3);
        check_areas(slider_crank(0.15, 0.45, 0.02,
                                 print("[load]\nlink = crank\ntorque = 50 N m\n[piston]\n"
                                       "mass = 5 kg\n[motion]\nspeed = %s\n",
                                       speeds[i])),
                    4);
    }
}

/* dE = I Cs omega^2 */
static void test_flywheel(void **unused)
{
    static fact_list list;
    const char *torque = "0 deg 100, 90 deg 100, 180 deg 300, 270 deg 300";
    double dE = 162.5 * PI / 2, I, omega = 120 * 2 * PI / 60;

    (void)unused;
    facts_of(with_curve(torque, "[motion]\nspeed = 120 rpm\n[flywheel]\nfluctuation = 0.04\n"),
             &list);
    I = dE / (0.04 * omega * omega);
    check_fact(&list, "flywheel_inertia", FOURLINK_OPEN, I, 1e-9 * I);
    check_fact(&list, "flywheel_fluctuation", FOURLINK_OPEN, 0.04, 0);
    I = value_of(&list, "flywheel_inertia", FOURLINK_OPEN);
    facts_of(with_curve(torque,
                        print("[motion]\nspeed = 120 rpm\n[flywheel]\ninertia = %.17g kg m2\n", I)),
             &list);
    check_fact(&list, "flywheel_fluctuation", FOURLINK_OPEN, 0.04, 1e-14);
    check_fact(&list, "flywheel_inertia", FOURLINK_OPEN, I, 1e-14 * I);
    /* half the speed, four times the fluctuation */
    facts_of(with_curve(torque, print("[motion]\nspeed = -60 rpm\n[units]\ninertia = kg cm2\n"
                                      "[flywheel]\ninertia = %.17g kg m2\n",
                                      I)),
             &list);
    check_fact(&list, "flywheel_fluctuation", FOURLINK_OPEN, 0.16, 1e-14);
    check_fact(&list, "flywheel_inertia", FOURLINK_OPEN, I * 1e4, 1e-10 * I);
    facts_of(with_curve(torque, "[motion]\nspeed = 120 rpm\n"), &list);
    assert_null(find_fact(&list, "flywheel_inertia", FOURLINK_OPEN));
    assert_null(find_fact(&list, "flywheel_fluctuation", FOURLINK_OPEN));
}

/* The interval and range of the table do not matter to the turning moment, nor does one instant. */
static void test_turning_moment_of_any_range(void **unused)
{
    static const char *const motions[] = {"interval = 40 deg\n", "at = 30 deg\n",
                                          "from = 20 deg\nto = 50 deg\n", "hold = yes\n"};
    static fact_list list;
    int i;

    (void)unused;
    for (i = 0; i < 4; i++) {
        facts_of(with_curve("0 deg 100, 90 deg 100, 180 deg 300, 270 deg 300",
                            print("[motion]\nspeed = 20 rad/s\n%s", motions[i])),
                 &list);
        check_fact(&list, "mean_torque", FOURLINK_OPEN, 200, 2e-7);
        check_fact(&list, "energy_fluctuation", FOURLINK_OPEN, 162.5 * PI / 2, 1e-6);
    }
}

static void check_no_turning_moment(const char *contents)
{
    static const char *const names[] = {"mean_torque",        "mean_power",
                                        "energy_fluctuation", "energy_coefficient",
                                        "flywheel_inertia",   "flywheel_fluctuation"};
    static fact_list list;
    int i, k;

    facts_of(contents, &list);
    assert_true(list.n > 3);
    for (i = 0; i < 6; i++)
        for (k = 0; k < 2; k++)
            if (find_fact(&list, names[i], branches[k]))
                fail_msg("there is a fact %s of\n%s", names[i], contents);
}

static void test_no_turning_moment(void **unused)
{
    const char *load_ = "[load]\nlink = crank\ntorque = 5 N m\n[flywheel]\nfluctuation = 0.02\n";
    static fact_list list;
    char *good = print("%s[motion]\nspeed = 10 rad/s\n", load_);

    (void)unused;
    facts_of(four_bar(0.020, 0.066, 0.056, 0.080, good), &list);
    check_fact(&list, "mean_torque", FOURLINK_OPEN, 5, 5e-9);
    /* a constant torque does not fluctuate */
    check_fact(&list, "energy_fluctuation", FOURLINK_OPEN, 0, 1e-12);
    /* accelerated, run up, at rest, without forces */
    check_no_turning_moment(
        four_bar(0.020, 0.066, 0.056, 0.080, print("%sacceleration = 1 rad/s2\n", good)));
    check_no_turning_moment(four_bar(0.020, 0.066, 0.056, 0.080,
                                     print("%sacceleration = 1 rad/s2\nhold = yes\n", good)));
    check_no_turning_moment(
        four_bar(0.020, 0.066, 0.056, 0.080,
                 print("%s[motion]\nacceleration = 1 rad/s2\nrun_up = 90 deg\n", load_)));
    check_no_turning_moment(four_bar(0.020, 0.066, 0.056, 0.080, load_));
    check_no_turning_moment(four_bar(0.020, 0.066, 0.056, 0.080, "[motion]\nspeed = 10 rad/s\n"));
    /* cranks that do not turn fully; the last but for a hundredth of a degree */
    check_no_turning_moment(four_bar(0.3, 0.4, 0.5, 0.75, good));
    check_no_turning_moment(four_bar(0.75, 0.4, 0.5, 0.35, good));
    check_no_turning_moment(slider_crank(0.4, 0.2, 0, good));
    check_no_turning_moment(slider_crank(0.4, 0.5, 0.2, good));
    check_no_turning_moment(four_bar(0.3, 0.4, 0.5, 0.6 * (1 + 1e-9), good));
}

/* ---------------------------------------------------------------------------------------------
** Printed values compared
** ------------------------------------------------------------------------------------------- */

typedef struct taken {
    int n;
    check list[40];
} taken;

static void take_check(const check *c, void *data)
{
    taken *t = data;

    assert_true(t->n < 40);
    t->list[t->n++] = *c;
}

/* Run the checks of a deck that has a single expectation, which can be compared. */
static check one_check(const char *contents)
{
    static char unit_name[DECK_NAME_SIZE];
    taken t = {0};
    check c;
    deck d;

    if (read_deck(contents, &d) != 1)
        fail_msg("%s\n%s", d.mistakes.list[0].message, contents);
    if (checks_run(&d, take_check, &t) != 1)
        fail_msg("%s\n%s", d.mistakes.list[0].message, contents);
    assert_int_equal(t.n, 1);
    c = t.list[0];
    c.unit = strcpy(unit_name, c.unit); /* it is the deck's */
    c.e = NULL;
    flk_deck_free(&d);
    return c;
}

/* An engine of n = l / r, in millimetres; 8 lines. */
static char *engine(double rod, const char *expectations)
{
    return print("mechanism = slider-crank\n[units]\nlength = mm\n[crank]\nlength = 100\n[rod]\n"
                 "length = %.17g\n\n%s",
                 rod, expectations);
}

static void check_printed(double rod, const char *printed, double tolerance, check_result expected)
{
    check c = one_check(engine(rod, print("[expect]\nn = %s\n", printed)));

    if (c.result != expected)
        fail_msg("n = %s with a rod of %g mm: result %d, expected %d", printed, rod, (int)c.result,
                 (int)expected);
    assert_close(c.tolerance, tolerance, 1e-12);
    assert_close(c.computed, rod / 100, 1e-15);
    assert_false(c.at_angle);
    assert_string_equal(c.words, "");
}

static void test_half_of_the_last_digit(void **unused)
{
    (void)unused;
    check_printed(250.4, "2.50", 0.005, CHECK_OK);
    check_printed(250.6, "2.50", 0.005, CHECK_DIFFERS);
    check_printed(249.6, "2.50", 0.005, CHECK_OK);
    check_printed(249.4, "2.50", 0.005, CHECK_DIFFERS);
    check_printed(250.6, "2.5", 0.05, CHECK_OK);
    check_printed(255.1, "2.5", 0.05, CHECK_DIFFERS);
    check_printed(254.9, "25e-1", 0.05, CHECK_OK);
    check_printed(255.1, "25e-1", 0.05, CHECK_DIFFERS);
    check_printed(250.4, "250e-2", 0.005, CHECK_OK);
    check_printed(250.6, "250e-2", 0.005, CHECK_DIFFERS);
    check_printed(254.9, "0.25e1", 0.05, CHECK_OK);
    check_printed(255.1, "0.25E+1", 0.05, CHECK_DIFFERS);
    check_printed(250.4, "0.250e1", 0.005, CHECK_OK);
    check_printed(250.6, "0.250e1", 0.005, CHECK_DIFFERS);
    check_printed(349.9, "3", 0.5, CHECK_OK);
    check_printed(250.4, "3", 0.5, CHECK_OK);
    check_printed(350.1, "3", 0.5, CHECK_DIFFERS);
    check_printed(350.1, "3.", 0.5, CHECK_DIFFERS);
    check_printed(250.4, "2", 0.5, CHECK_DIFFERS);
    check_printed(250.4, "+2.504", 0.0005, CHECK_OK);
    check_printed(1204, "12.0", 0.05, CHECK_OK);
    check_printed(1254, "12", 0.5, CHECK_DIFFERS);
    check_printed(1249, "1.2e1", 0.5, CHECK_OK);
    check_printed(1251, "1.2e1", 0.5, CHECK_DIFFERS);
    check_printed(1499, "1e1", 5, CHECK_OK);
    check_printed(1501, "1e1", 5, CHECK_DIFFERS);
    check_printed(12400, "1.2e2", 5, CHECK_OK);
    check_printed(12400, "120", 0.5, CHECK_DIFFERS);
    check_printed(250.4, "2.5040000000000", 5e-14, CHECK_OK);
    check_printed(250.4000001, "2.5040000000000", 5e-14, CHECK_DIFFERS);
    /* halfway between two digits: printed either way */
    check_printed(250.5, "2.50", 0.005, CHECK_OK);
    check_printed(250.5, "2.51", 0.005, CHECK_OK);
    check_printed(250.5, "2.52", 0.005, CHECK_DIFFERS);
    check_printed(250.5, "2.49", 0.005, CHECK_DIFFERS);
    check_printed(250, "-2.50", 0.005, CHECK_DIFFERS);
}

/* In the unit that was printed, whatever that of the deck. */
static void test_printed_units(void **unused)
{
    static const struct {
        const char *printed;
        double value, tolerance;
        check_result result;
    } table[] = {{"200 mm", 200, 0.5, CHECK_OK},
                 {"200.4 mm", 200.4, 0.05, CHECK_DIFFERS},
                 {"0.200 m", 200, 0.5, CHECK_OK},
                 {"0.2 m", 200, 50, CHECK_OK},
                 {"0.201 m", 201, 0.5, CHECK_DIFFERS},
                 {"20.0 cm", 200, 0.5, CHECK_OK},
                 {"7.874 in", 7.874 * 25.4, 0.0127, CHECK_OK},
                 {"7.875 in", 7.875 * 25.4, 0.0127, CHECK_DIFFERS},
                 {"2e2", 200, 50, CHECK_OK},
                 {"200.0", 200, 0.05, CHECK_OK},
                 {"249", 249, 0.5, CHECK_DIFFERS}};
    int i;

    (void)unused;
    for (i = 0; i < (int)(sizeof table / sizeof table[0]); i++) {
        check c = one_check(engine(300, print("[expect]\nstroke = %s\n", table[i].printed)));

        if (c.result != table[i].result)
            fail_msg("stroke = %s: %d", table[i].printed, (int)c.result);
        assert_close(c.printed, table[i].value, 1e-14);
        assert_close(c.tolerance, table[i].tolerance, 1e-12);
        assert_near(c.computed, 200, 1e-12);
        assert_string_equal(c.unit, "mm");
    }
}

static void check_tolerance(const char *tolerance, double printed, check_result expected)
{
    check c = one_check(
        engine(300, print("[expect]\ntolerance = %s\nstroke = %.10g mm\n", tolerance, printed)));

    if (c.result != expected)
        fail_msg("stroke = %g mm, tolerance = %s: result %d", printed, tolerance, (int)c.result);
}

static void test_tolerances(void **unused)
{
    (void)unused;
    check_tolerance("3 mm", 202.9, CHECK_OK);
    check_tolerance("3 mm", 203.1, CHECK_DIFFERS);
    check_tolerance("3 mm", 197.1, CHECK_OK);
    check_tolerance("3 mm", 196.9, CHECK_DIFFERS);
    check_tolerance("3", 202.9, CHECK_OK); /* in the deck's unit */
    check_tolerance("3", 203.1, CHECK_DIFFERS);
    check_tolerance("0.3 cm", 202.9, CHECK_OK);
    check_tolerance("0.3 cm", 203.1, CHECK_DIFFERS);
    check_tolerance("0.1 mm", 200.09, CHECK_OK);
    check_tolerance("0.1 mm", 200.11, CHECK_DIFFERS);
    check_tolerance("0 mm", 200, CHECK_OK);
    check_tolerance("0 mm", 200.001, CHECK_DIFFERS);
    /* of the printed value */
    check_tolerance("2 %", 204, CHECK_OK);
    check_tolerance("2 %", 204.2, CHECK_DIFFERS);
    check_tolerance("2%", 196.1, CHECK_OK);
    check_tolerance("2%", 196, CHECK_DIFFERS);
    check_tolerance("0.01 %", 200.02, CHECK_OK);
    check_tolerance("0.01 %", 200.03, CHECK_DIFFERS);
    check_tolerance("0.05", 200.04, CHECK_OK);
}

/* Per cent of a negative value; a tolerance holds for all values of its section alone. */
static void test_tolerances_of_sections(void **unused)
{
    static const check_result expected[] = {CHECK_OK, CHECK_DIFFERS, CHECK_OK, CHECK_DIFFERS,
                                            CHECK_DIFFERS};
    taken t = {0};
    deck d;
    int i;

    (void)unused;
    assert_int_equal(read_deck(four_bar(0.020, 0.066, 0.056, 0.080,
                                        "[motion]\nspeed = 10.5 rad/s\n[expect]\n"
                                        "at = 40 deg\ntolerance = 1 %\n"
                                        "omega3 = -3.18 rad/s\n[expect]\nat = 40 deg\n"
                                        "tolerance = 1 %\nomega3 = -3.19 rad/s\n"
                                        "theta4 = 104.5\n[expect]\nat = 40 deg\n"
                                        "tolerance = 1 %\ntheta4 = 105.0\n"
                                        "[expect]\nat = 40 deg\nomega3 = -3.18 rad/s\n"),
                               &d),
                     1);
    assert_int_equal(checks_run(&d, take_check, &t), 1);
    assert_int_equal(t.n, 5);
    for (i = 0; i < 5; i++)
        assert_int_equal(t.list[i].result, expected[i]);
    assert_true(t.list[0].at_angle);
    assert_int_equal(t.list[0].e->place.line, 15);
    assert_true(t.list[0].tolerance > 0);
    flk_deck_free(&d);
}

/* A tolerance below 0 means the same in both forms, or is a mistake in both. */
static void test_negative_tolerances(void **unused)
{
    static const char *const forms[] = {"-3 mm", "-2 %"};
    int outcome[2], i;

    (void)unused;
    for (i = 0; i < 2; i++) {
        taken t = {0};
        deck d;

        outcome[i] = read_deck(
            engine(300, print("[expect]\ntolerance = %s\nstroke = 201 mm\n", forms[i])), &d);
        if (outcome[i] == 1)
            outcome[i] = checks_run(&d, take_check, &t);
        if (outcome[i] == 1)
            outcome[i] = 10 + (int)t.list[0].result;
        flk_deck_free(&d);
    }
    assert_int_equal(outcome[0], outcome[1]);
}

static void test_misprints(void **unused)
{
    check c = one_check(engine(300, "[expect]\nstroke = 200 mm\n"));

    (void)unused;
    assert_int_equal(c.result, CHECK_OK);
    c = one_check(engine(300, "[expect]\nstroke = 210 mm\n"));
    assert_int_equal(c.result, CHECK_DIFFERS);
    c = one_check(engine(300, "[misprint]\nstroke = 210 mm\n"));
    assert_int_equal(c.result, CHECK_MISPRINT);
    c = one_check(engine(300, "[misprint]\nstroke = 200 mm\n"));
    assert_int_equal(c.result, CHECK_NO_MISPRINT);
    /* a misprint is outside its tolerance */
    c = one_check(engine(300, "[misprint]\ntolerance = 11 mm\nstroke = 210 mm\n"));
    assert_int_equal(c.result, CHECK_NO_MISPRINT);
    c = one_check(engine(300, "[misprint]\ntolerance = 4 %\nstroke = 210 mm\n"));
    assert_int_equal(c.result, CHECK_MISPRINT);
    c = one_check(engine(300, "[misprint]\ntype = double rocker\n"));
    assert_int_equal(c.result, CHECK_MISPRINT);
    c = one_check(engine(300, "[misprint]\ntype = slider-crank, the crank turns fully\n"));
    assert_int_equal(c.result, CHECK_NO_MISPRINT);
}

static check alvi_check(const char *expectations)
{
    return one_check(four_bar(0.020, 0.066, 0.056, 0.080,
                              print("[motion]\nspeed = 10.5 rad/s\n%s", expectations)));
}

static void test_angles_modulo_a_turn(void **unused)
{
    static const char *const right[] = {"103.820765 deg",  "463.820765 deg",  "-256.179235 deg",
                                        "3703.820765 deg", "1.812014178 rad", "0.28839101 rev",
                                        "-0.71160899 rev"};
    static const char *const wrong[] = {"103.820775 deg", "463.820775 deg",  "-256.179225 deg",
                                        "283.820765 deg", "-103.820765 deg", "1.28839104 rev"};
    check c;
    int i;

    (void)unused;
    for (i = 0; i < 7; i++) {
        c = alvi_check(print("[expect]\nat = 40 deg\ntheta4 = %s\n", right[i]));
        if (c.result != CHECK_OK)
            fail_msg("theta4 = %s: %d", right[i], (int)c.result);
        assert_near(c.computed, 103.82076481271876, 1e-9);
    }
    for (i = 0; i < 6; i++) {
        c = alvi_check(print("[expect]\nat = 40 deg\ntheta4 = %s\n", wrong[i]));
        if (c.result != CHECK_DIFFERS)
            fail_msg("theta4 = %s: %d", wrong[i], (int)c.result);
    }
    /* on either side of the turn, in a unit whose turn is not 360 */
    c = alvi_check("[expect]\ntheta2_from = 360 deg\n");
    assert_int_equal(c.result, CHECK_OK);
    c = alvi_check("[expect]\ntheta2_from = 359.9 deg\n");
    assert_int_equal(c.result, CHECK_DIFFERS);
    c = alvi_check("[expect]\ntolerance = 0.2 deg\ntheta2_from = 359.9 deg\n");
    assert_int_equal(c.result, CHECK_OK);
    c = alvi_check("[units]\nangle = rev\n[expect]\nat = 40 deg\ntheta4 = 1.288391\n");
    assert_int_equal(c.result, CHECK_OK);
    c = alvi_check("[units]\nangle = rev\n[expect]\nat = 40 deg\ntheta4 = 1.288393\n");
    assert_int_equal(c.result, CHECK_DIFFERS);
    /* what is no angle does not come round */
    c = alvi_check("[expect]\nat = 40 deg\nomega3 = 356.845 rad/s\n");
    assert_int_equal(c.result, CHECK_DIFFERS);
    /* `at` counts on past a turn */
    c = alvi_check("[expect]\nat = 400 deg\ntheta4 = 103.820765 deg\n");
    assert_int_equal(c.result, CHECK_OK);
    c = alvi_check("[expect]\nat = 0.69813170 rad\ntheta4 = 103.82076 deg\n");
    assert_int_equal(c.result, CHECK_OK);
}

static void test_facts_in_words(void **unused)
{
    check c = alvi_check("[expect]\ntype = crank-rocker\n");

    (void)unused;
    assert_int_equal(c.result, CHECK_OK);
    assert_string_equal(c.words, "crank-rocker");
    assert_string_equal(c.unit, "");
    c = alvi_check("[expect]\ntype = Crank-Rocker\n");
    assert_int_equal(c.result, CHECK_OK);
    c = alvi_check("[expect]\ntype = rocker-crank\n");
    assert_int_equal(c.result, CHECK_DIFFERS);
    assert_string_equal(c.words, "crank-rocker");
    c = alvi_check("[expect]\ntype = crank\n");
    assert_int_equal(c.result, CHECK_DIFFERS);
    c = alvi_check("[expect]\ntype = 5 mm\n");
    assert_int_equal(c.result, CHECK_DIFFERS);
}

static void test_branches_of_expectations(void **unused)
{
    check c = alvi_check("[expect]\nat = 40 deg\ntheta4 = 103.820765 deg\n");

    (void)unused;
    assert_int_equal(c.result, CHECK_OK); /* open where it does not say */
    c = alvi_check("[expect]\nat = 40 deg\nbranch = crossed\ntheta4 = -126.30 deg\n");
    assert_int_equal(c.result, CHECK_OK);
    c = alvi_check("[expect]\nat = 40 deg\nbranch = open\ntheta4 = -126.30 deg\n");
    assert_int_equal(c.result, CHECK_DIFFERS);
    c = alvi_check("[expect]\nbranch = crossed\ntheta4_max = -103.818044198 deg\n");
    assert_int_equal(c.result, CHECK_OK);
    c = alvi_check("[table]\nbranch = crossed\n[expect]\nat = 40 deg\ntheta4 = -126.30 deg\n");
    assert_int_equal(c.result, CHECK_OK);
    c = alvi_check("[table]\nbranch = open\n[expect]\nat = 40 deg\nbranch = crossed\n"
                   "theta4 = -126.30 deg\n");
    assert_int_equal(c.result, CHECK_OK);
}

/* The branches of the table are a matter of what is printed, for facts as for columns. */
static void test_fact_of_a_branch_not_printed(void **unused)
{
    check c = alvi_check("[table]\nbranch = open\n[expect]\nbranch = crossed\n"
                         "theta4_max = -103.818044198 deg\n");

    (void)unused;
    assert_int_equal(c.result, CHECK_OK);
}

static void test_extremes_expected(void **unused)
{
    check c = alvi_check("[expect]\nmax(theta4) = 145.906609 deg\n");

    (void)unused;
    assert_int_equal(c.result, CHECK_OK);
    assert_false(c.at_angle);
    c = alvi_check("[expect]\nmin( theta4 ) = 103.818044 deg\n");
    assert_int_equal(c.result, CHECK_OK);
    c = alvi_check("[expect]\nmin(theta4) = 145.906609 deg\n");
    assert_int_equal(c.result, CHECK_DIFFERS);
    c = alvi_check("[expect]\nbranch = crossed\nmax(theta4) = -103.818044 deg\n");
    assert_int_equal(c.result, CHECK_OK);
    c = one_check(engine(300, "[motion]\nspeed = 1 rad/s\n[expect]\nmax(x) = 200.0 mm\n"));
    assert_int_equal(c.result, CHECK_OK);
}

/* Each of two ranges of the crank has facts by the same names. */
static void test_expectations_of_the_second_range(void **unused)
{
    check c = one_check(slider_crank(0.4, 0.2, 0, "[expect]\ntheta2_to = 30.0 deg\n"));

    (void)unused;
    assert_int_equal(c.result, CHECK_OK);
    c = one_check(slider_crank(0.4, 0.2, 0, "[expect]\ntheta2_to = 210.0 deg\n"));
    assert_int_equal(c.result, CHECK_OK);
    c = one_check(slider_crank(0.4, 0.2, 0, "[expect]\ntheta2_to = 40.0 deg\n"));
    assert_int_equal(c.result, CHECK_DIFFERS);
}

static void test_expectations_at_one_instant(void **unused)
{
    check c = one_check(four_bar(0.020, 0.066, 0.056, 0.080,
                                 "[motion]\nspeed = 100 rpm\nat = 40 deg\n[expect]\n"
                                 "theta4 = 103.820765 deg\n"));

    (void)unused;
    assert_int_equal(c.result, CHECK_OK);
    assert_true(c.at_angle);
    c = one_check(four_bar(0.020, 0.066, 0.056, 0.080,
                           "[motion]\nspeed = 100 rpm\nat = 40 deg\n[expect]\n"
                           "omega2 = 10.472 rad/s\n"));
    assert_int_equal(c.result, CHECK_OK);
    c = one_check(four_bar(0.020, 0.066, 0.056, 0.080,
                           "[motion]\nspeed = 100 rpm\nat = 40 deg\n[expect]\n"
                           "omega2 = 100 rpm\nat = 400 deg\n"));
    assert_int_equal(c.result, CHECK_OK);
}

/* ------------------------------------------------------------------------------- mistakes */

/* The checks of a deck end with this one mistake: the value is told to be none. */
static void check_mistake(const char *contents, long line, const char *message)
{
    taken t = {0};
    deck d;
    int status = read_deck(contents, &d), read = status;

    if (read == 1)
        status = checks_run(&d, take_check, &t);
    if (status != 0 || d.mistakes.count != 1)
        fail_msg("status %d, %d mistakes in\n%s", status, (int)d.mistakes.count, contents);
    assert_int_equal(t.n > 0, read == 1);
    if (t.n)
        assert_int_equal(t.list[t.n - 1].result, CHECK_NO_VALUE);
    if (strcmp(d.mistakes.list[0].message, message) != 0 || d.mistakes.list[0].place.line != line)
        fail_msg("x.deck:%ld: %s\nexpected at %ld: %s", d.mistakes.list[0].place.line,
                 d.mistakes.list[0].message, line, message);
    assert_string_equal(d.mistakes.list[0].place.source, "x.deck");
    flk_deck_free(&d);
}

static void test_mistakes_of_names(void **unused)
{
    (void)unused;
    check_mistake(engine(300, "[expect]\nn = 3\nstrok = 200 mm\n"), 11,
                  "'strok' is no column and no fact of this deck; did you mean 'stroke'?");
}

static void test_mistakes_of_columns(void **unused)
{
    (void)unused;
    check_mistake(engine(300, "[expect]\nat = 40 deg\nomga3 = 3 rad/s\n"), 11,
                  "'omga3' is no column and no fact of this deck; did you mean 'omega3'?");
    check_mistake(engine(300, "[expect]\nxyzzy = 3 rad/s\n"), 10,
                  "'xyzzy' is no column and no fact of this deck");
    check_mistake(engine(300, "[expect]\nmax(omga3) = 3 rad/s\n"), 10,
                  "'omga3' is no column and no fact of this deck; did you mean 'omega3'?");
    check_mistake(engine(300, "[misprint]\nn = 2\nxyzzy = 3\n"), 11,
                  "'xyzzy' is no column and no fact of this deck");
    /* of the other mechanism, or of a deck with forces */
    check_mistake(engine(300, "[expect]\nswing = 30 deg\n"), 10,
                  "'swing' is no column and no fact of this deck");
    check_mistake(engine(300, "[expect]\nmean_torque = 30 N m\n"), 10,
                  "'mean_torque' is no column and no fact of this deck");
    check_mistake(engine(300, "[expect]\nat = 40 deg\nx = 30 mm\nv = 1\nspeed = 1 rpm\n"), 13,
                  "'speed' is no column and no fact of this deck");
}

static void test_mistakes_of_units(void **unused)
{
    (void)unused;
    check_mistake(engine(300, "[expect]\nstroke = 200 deg\n"), 10,
                  "'200 deg' is an angle; expected a length, such as 80 mm");
    check_mistake(engine(300, "[expect]\nn = 3 mm\n"), 10,
                  "'3 mm' is a length; expected a number, such as 0.02");
    check_mistake(engine(300, "[expect]\nat = 40 deg\nv = 3 mm\n"), 11,
                  "'3 mm' is a length; expected a speed, such as 2 m/s");
    check_mistake(engine(300, "[expect]\nmax(x) = 3 s\n"), 10,
                  "'3 s' is a time; expected a length, such as 80 mm");
    check_mistake(engine(300, "[expect]\nstroke = 200 xyzzy\n"), 10,
                  "unknown unit 'xyzzy' in '200 xyzzy'");
    check_mistake(engine(300, "[expect]\nstroke = long\n"), 10,
                  "expected a length, such as 80 mm, not 'long'");
    check_mistake(engine(300, "[expect]\nstroke = 0,2 m\n"), 10,
                  "'0,2 m': the decimal mark is a point, not a comma");
    check_mistake(engine(300, "[expect]\nstroke = nan mm\n"), 10,
                  "'nan mm' is not a finite number");
}

static void test_mistakes_of_tolerances(void **unused)
{
    (void)unused;
    check_mistake(engine(300, "[expect]\ntolerance = 1 kg\nstroke = 200 mm\n"), 10,
                  "'1 kg' is a mass; expected a length, such as 80 mm");
    check_mistake(engine(300, "[expect]\ntolerance = 1 mm\nn = 3\n"), 10,
                  "'1 mm' is a length; expected a number, such as 0.02");
    check_mistake(engine(300, "[expect]\ntolerance = none\nn = 3\n"), 10,
                  "expected a number, such as 0.02, not 'none'");
}

static void test_mistakes_of_places(void **unused)
{
    (void)unused;
    check_mistake(engine(300, "[expect]\nx = 20 mm\n"), 10,
                  "a column is expected at a crank angle: give the section 'at = ...'");
    check_mistake(engine(300, "[expect]\nn = 3\nat = 40 mm\n"), 11,
                  "'40 mm' is a length; expected an angle, such as 40 deg");
    check_mistake(four_bar(0.3, 0.4, 0.5, 0.75,
                           "[expect]\nat = 120 deg\nbranch = crossed\ntheta4 = 100 deg\n"),
                  13,
                  "no value at theta2 = 120 deg, crossed: the links do not reach: B and D are too "
                  "far apart");
    check_mistake(slider_crank(0.4, 0.2, 0, "[expect]\nat = 90 deg\nx = 0.1 m\n"), 10,
                  "no value at theta2 = 90 deg, open: the rod does not reach the line of stroke");
    check_mistake(four_bar(0.3, 0.4, 0.5, 0.75,
                           "[motion]\nspeed = 1 rad/s\nfrom = 120 deg\nto = 200 deg\n[expect]\n"
                           "max(theta4) = 100 deg\n"),
                  15, "the links reach at no angle of the motion");
}

/* The rocker of a drag link goes on and on: theta4 has no greatest value, but the links reach. */
static void test_mistake_of_an_angle_without_extremes(void **unused)
{
    taken t = {0};
    deck d;

    (void)unused;
    assert_int_equal(read_deck(four_bar(0.50, 0.45, 0.60, 0.20,
                                        "[motion]\nspeed = 1 rad/s\n[expect]\n"
                                        "max(theta4) = 180 deg\n"),
                               &d),
                     1);
    if (checks_run(&d, take_check, &t) == 0) {
        assert_int_equal(d.mistakes.list[0].place.line, 13);
        assert_string_not_equal(d.mistakes.list[0].message,
                                "the links reach at no angle of the motion");
    }
    flk_deck_free(&d);
}

/* The crank comes to rest after 143.2 deg: at 150 deg there is nothing to compare with. */
static void test_mistake_beyond_the_end_of_a_motion(void **unused)
{
    taken t = {0};
    deck d;

    (void)unused;
    assert_int_equal(read_deck(four_bar(0.020, 0.066, 0.056, 0.080,
                                        "[motion]\nspeed = 10 rad/s\n"
                                        "acceleration = -20 rad/s2\n[expect]\n"
                                        "at = 150 deg\nomega4 = 0 rad/s\n"),
                               &d),
                     1);
    assert_int_equal(checks_run(&d, take_check, &t), 0);
    assert_int_equal(d.mistakes.count, 1);
    assert_int_equal(d.mistakes.list[0].place.line, 15);
    flk_deck_free(&d);
}

/* All mistakes of a run, in the order of their lines, and no comparison told. */
static void test_all_mistakes_in_one_run(void **unused)
{
    static const long lines[] = {11, 12, 14, 17};
    taken t = {0};
    deck d;
    int i;

    (void)unused;
    assert_int_equal(read_deck(engine(300, "[expect]\nn = 3\nxyzzy = 1\nstroke = 1 kg\n"
                                           "[expect]\nx = 20 mm\n[expect]\nat = 0\nv = 1 mm\n"),
                               &d),
                     1);
    assert_int_equal(checks_run(&d, take_check, &t), 0);
    assert_int_equal(t.n, 5); /* the first is in order, the others have no value */
    assert_int_equal(t.list[0].result, CHECK_OK);
    assert_int_equal(t.list[4].result, CHECK_NO_VALUE);
    assert_int_equal(d.mistakes.count, 4);
    for (i = 0; i < 4; i++)
        assert_int_equal(d.mistakes.list[i].place.line, lines[i]);
    flk_deck_free(&d);
}

static int read_answers(const char *contents, const char *answers, deck *d)
{
    fourlink_source source = deck_source(contents);

    source.answers_name = "y.expect";
    source.answers = answers;
    source.answers_length = (unsigned long)strlen(answers);
    return flk_deck_read(&source, d);
}

/* A file of its own takes the place of the deck's expectations; its mistakes have its name and lines. */
static void test_expectations_of_another_file(void **unused)
{
    taken t = {0};
    deck d;

    (void)unused;
    assert_int_equal(read_answers(engine(300, "[expect]\nn = 3\n"),
                                  "[misprint]\nn = 4\n[expect]\nstroke = 20 cm\n", &d),
                     1);
    assert_int_equal(checks_run(&d, take_check, &t), 1);
    assert_int_equal(t.n, 2);
    assert_int_equal(t.list[0].result, CHECK_MISPRINT);
    assert_string_equal(t.list[0].e->place.source, "y.expect");
    assert_int_equal(t.list[0].e->place.line, 2);
    assert_int_equal(t.list[1].result, CHECK_OK);
    flk_deck_free(&d);

    assert_int_equal(read_answers(engine(300, ""), "[expect]\n\nxyzzy = 4\n", &d), 1);
    assert_int_equal(checks_run(&d, take_check, &t), 0);
    assert_string_equal(d.mistakes.list[0].place.source, "y.expect");
    assert_int_equal(d.mistakes.list[0].place.line, 3);
    flk_deck_free(&d);

    assert_int_equal(read_answers(engine(300, ""), "[expect]\n[ground]\n", &d), 0);
    assert_string_equal(d.mistakes.list[0].place.source, "y.expect");
    assert_int_equal(d.mistakes.list[0].place.line, 2);
    flk_deck_free(&d);
}

static void test_nothing_expected(void **unused)
{
    taken t = {0};
    deck d;

    (void)unused;
    assert_int_equal(read_deck(engine(300, ""), &d), 1);
    assert_int_equal(checks_run(&d, take_check, &t), 1);
    assert_int_equal(t.n, 0);
    flk_deck_free(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_extremes_of_rockers),
        cmocka_unit_test(test_angles_of_extremes_of_rockers),
        cmocka_unit_test(test_extremes_of_pistons),
        cmocka_unit_test(test_angles_of_extremes_of_pistons),
        cmocka_unit_test(test_extremes_of_torques),
        cmocka_unit_test(test_angles_of_extremes_of_torques),
        cmocka_unit_test(test_extremes_of_a_drag_link),
        cmocka_unit_test(test_extremes_of_an_angle_over_a_gap),
        cmocka_unit_test(test_extremes_of_angles_beside_gaps),
        cmocka_unit_test(test_extremes_of_an_engine_in_closed_form),
        cmocka_unit_test(test_angles_of_extremes_of_an_engine_in_closed_form),
        cmocka_unit_test(test_extremes_and_limits_agree),
        cmocka_unit_test(test_extremes_at_the_ends_of_a_range),
        cmocka_unit_test(test_extremes_just_inside_an_end),
        cmocka_unit_test(test_extremes_of_a_run_up),
        cmocka_unit_test(test_extremes_of_accelerated_motion),
        cmocka_unit_test(test_extremes_of_a_crank_that_stops),
        cmocka_unit_test(test_extremes_do_not_depend_on_the_interval),
        cmocka_unit_test(test_extremes_towards_dead_positions),
        cmocka_unit_test(test_extremes_towards_dead_positions_of_a_piston),
        cmocka_unit_test(test_extremes_of_a_narrow_card),
        cmocka_unit_test(test_extremes_in_the_units_of_the_deck),
        cmocka_unit_test(test_extremes_of_one_instant),
        cmocka_unit_test(test_facts_of_linkages),
        cmocka_unit_test(test_reach_of_link_4),
        cmocka_unit_test(test_facts_of_engines),
        cmocka_unit_test(test_energy_of_a_piston),
        cmocka_unit_test(test_energy_of_gas_and_piston),
        cmocka_unit_test(test_mean_torque_of_conservative_machines),
        cmocka_unit_test(test_energy_is_force_times_way),
        cmocka_unit_test(test_energy_of_a_drag_link),
        cmocka_unit_test(test_turning_moment_in_closed_form),
        cmocka_unit_test(test_turning_moment_of_four_strokes),
        cmocka_unit_test(test_cycle_of_two_revolutions),
        cmocka_unit_test(test_turning_moment_in_steps),
        cmocka_unit_test(test_turning_moment_of_a_peak),
        cmocka_unit_test(test_turning_moment_within_a_degree),
        cmocka_unit_test(test_step_within_a_degree),
        cmocka_unit_test(test_areas_of_the_turning_moment),
        cmocka_unit_test(test_flywheel),
        cmocka_unit_test(test_turning_moment_of_any_range),
        cmocka_unit_test(test_no_turning_moment),
        cmocka_unit_test(test_half_of_the_last_digit),
        cmocka_unit_test(test_printed_units),
        cmocka_unit_test(test_tolerances),
        cmocka_unit_test(test_tolerances_of_sections),
        cmocka_unit_test(test_negative_tolerances),
        cmocka_unit_test(test_misprints),
        cmocka_unit_test(test_angles_modulo_a_turn),
        cmocka_unit_test(test_facts_in_words),
        cmocka_unit_test(test_branches_of_expectations),
        cmocka_unit_test(test_fact_of_a_branch_not_printed),
        cmocka_unit_test(test_extremes_expected),
        cmocka_unit_test(test_expectations_of_the_second_range),
        cmocka_unit_test(test_expectations_at_one_instant),
        cmocka_unit_test(test_mistakes_of_names),
        cmocka_unit_test(test_mistakes_of_columns),
        cmocka_unit_test(test_mistakes_of_units),
        cmocka_unit_test(test_mistakes_of_tolerances),
        cmocka_unit_test(test_mistakes_of_places),
        cmocka_unit_test(test_mistake_of_an_angle_without_extremes),
        cmocka_unit_test(test_mistake_beyond_the_end_of_a_motion),
        cmocka_unit_test(test_all_mistakes_in_one_run),
        cmocka_unit_test(test_expectations_of_another_file),
        cmocka_unit_test(test_nothing_expected),
    };

    gsl_set_error_handler_off(); /* as the command does */
    return cmocka_run_group_tests(tests, NULL, NULL);
}
