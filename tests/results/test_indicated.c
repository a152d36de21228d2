/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_indicated.c - volume and pressure in a cylinder, displacement, compression ratio, work of the gas in a
** cycle: random engines against formulas of this file and of formulas.h in long double, and against the
** mean torque.
**
** test_indicated CASES tries so many of them, and prints the worst.
*/
#include "chance.h"
#include "machines.h"

#define MOST 12

/* An engine, a yoke with l = 0, and its card. */
typedef struct engine {
    own o;
    long double bore, rod, clearance; /* m, m, m3 */
    double back;                      /* Pa */
    double x[MOST + 1], y[MOST + 1];  /* deg, Pa; the first again a cycle later */
    long double slope[MOST + 1];
    int n, turns, is_rough;
    double speed;
    char text[4000];
} engine;

/* ------------------------------------------------------------------------------------- the engine once more */

static long double area_of(const engine *e)
{
    return PIL / 4 * e->bore * e->bore;
}

static long double displacement_of_pin(const engine *e, long double theta2)
{
    return e->o.b > 0 ? own_x(&e->o, theta2) : e->o.a * (1 - cosl(theta2));
}

static long double stroke_of(const engine *e)
{
    const own *o = &e->o;

    return o->b > 0 ? sqrtl((o->b + o->a) * (o->b + o->a) - o->d * o->d) -
                          sqrtl((o->b - o->a) * (o->b - o->a) - o->d * o->d)
                    : 2 * o->a;
}

/* Steffen's slopes (1990, eq. 11) of a periodic curve. */
static void find_slopes(engine *e)
{
    int i;

    for (i = 0; i < e->n; i++) {
        int k = i > 0 ? i - 1 : e->n - 1;
        long double h = e->x[k + 1] - e->x[k], g = e->x[i + 1] - e->x[i];
        long double s = (e->y[k + 1] - e->y[k]) / h, t = (e->y[i + 1] - e->y[i]) / g;
        long double p = fabsl((s * g + t * h) / (h + g)) / 2;

        e->slope[i] = s * t > 0 ? copysignl(2 * fminl(p, fminl(fabsl(s), fabsl(t))), s) : 0;
    }
    e->slope[e->n] = e->slope[0];
}

/* The pressure in piece i at a part of it, and its slope over the part. */
static long double pressure_in(const engine *e, int i, long double part, long double *slope)
{
    long double h = e->x[i + 1] - e->x[i], dy = e->y[i + 1] - e->y[i];
    long double c = 3 * dy - h * (2 * e->slope[i] + e->slope[i + 1]);
    long double d = h * (e->slope[i] + e->slope[i + 1]) - 2 * dy;

    *slope = h * e->slope[i] + part * (2 * c + part * 3 * d);
    return e->y[i] + part * (h * e->slope[i] + part * (c + part * d));
}

static long double pressure_at(const engine *e, long double degrees)
{
    long double cycle = 360 * e->turns, slope;
    int i = 0;

    degrees -= cycle * floorl((degrees - e->x[0]) / cycle);
    while (i + 1 < e->n && degrees >= e->x[i + 1])
        i++;
    return pressure_in(e, i, (degrees - e->x[i]) / (e->x[i + 1] - e->x[i]), &slope);
}

/* The work in a cycle by parts, - integral of V dp, which asks nothing of the piston's velocity: Gauss's rule of
** four points, in steps of a degree or less. */
static long double work_of(const engine *e)
{
    static const long double node[2] = {0.861136311594052575224L, 0.339981043584856264803L},
                             weight[2] = {0.347854845137453857373L, 0.652145154862546142627L};
    long double sum = 0, slope;
    int i, k, m;

    for (i = 0; i < e->n; i++) {
        int steps = (int)ceil((e->x[i + 1] - e->x[i]) * (e->is_rough ? 16 : 1) + 1);

        for (k = 0; k < steps; k++)
            for (m = 0; m < 4; m++) {
                long double part = (k + (1 + (m % 2 ? 1 : -1) * node[m / 2]) / 2) / steps;
                long double at = (e->x[i] + part * (e->x[i + 1] - e->x[i])) * PIL / 180;

                pressure_in(e, i, part, &slope);
                sum -=
                    weight[m / 2] / (2 * steps) * area_of(e) * displacement_of_pin(e, at) * slope;
            }
    }
    return e->speed < 0 ? -sum : sum;
}

/* --------------------------------------------------------------------------------------------- random decks */

static void draw_card(engine *e)
{
    double sum = 0, start = between(-400, 400);
    int i;

    e->n = between_whole(2, MOST + 1);
    for (i = 0; i <= e->n; i++) {
        e->x[i] = sum;
        sum += seldom(0.1) ? power_of_ten(-4, -1) : between(0.1, 2);
        e->y[i] = i && seldom(0.1) ? e->y[i - 1]
                  : seldom(0.1)    ? -power_of_ten(3, 5)
                                   : power_of_ten(4, 7);
    }
    for (i = 0; i <= e->n; i++)
        e->x[i] = start + e->x[i] / (sum = i ? sum : e->x[e->n]) * 360 * e->turns;
    e->x[e->n] = e->x[0] + 360 * e->turns;
    e->y[e->n] = e->y[0];
    find_slopes(e);
}

/* The clearance in one of the three forms; 0: none. */
static int put_clearance(engine *e, char *to)
{
    double share = power_of_ten(-3, 0);

    e->clearance = 0;
    switch (one_of(4)) {
    case 0:
        e->clearance = share * area_of(e) * stroke_of(e);
        return sprintf(to, "clearance = %.17g %%\n", 100 * share);
    case 1:
        e->clearance = share * area_of(e);
        return sprintf(to, "clearance = %.17g mm\n", 1000 * share);
    case 2:
        e->clearance = share * 1e-3L;
        return sprintf(to, "clearance = %.17g %s\n", share * (e->turns > 1 ? 1e3 : 1),
                       e->turns > 1 ? "cc" : "L");
    default:
        return 0;
    }
}

static void draw_engine(long i, engine *e)
{
    char *to = e->text;
    int is_yoke, k;

    memset(e, 0, sizeof *e);
    begin_chance(1, i);
    is_yoke = seldom(0.2);
    e->o.a = power_of_ten(-2, 0);
    e->o.b = is_yoke ? 0 : (double)(e->o.a * (1 + power_of_ten(seldom(0.1) ? -5 : -1, 1)));
    e->o.d = is_yoke || seldom(0.4)
                 ? 0
                 : (double)((e->o.b - e->o.a) * (long double)between(-0.95, 0.95));
    e->o.branch = is_yoke || seldom(0.5) ? 1 : -1;
    e->is_rough = e->o.b > 0 && e->o.b - e->o.a - fabsl(e->o.d) < 0.1L * e->o.a;
    e->bore = (double)e->o.a * between(0.1, 2);
    e->rod = seldom(0.5) ? (double)e->bore * between(0.1, 0.9) : 0;
    e->back = seldom(0.5) ? power_of_ten(3, 6) : 0;
    e->turns = between_whole(1, 4);
    e->speed = seldom(0.1) ? 0 : between(-200, 200);
    draw_card(e);
    to += sprintf(to, "mechanism = %s\n[crank]\nlength = %.17g m\n",
                  is_yoke ? "scotch-yoke" : "slider-crank", (double)e->o.a);
    if (!is_yoke)
        to += sprintf(to, "[rod]\nlength = %.17g m\n[ground]\noffset = %.17g m\n", (double)e->o.b,
                      (double)e->o.d);
    to += sprintf(to, "[motion]\nspeed = %.17g rad/s\ncycle = %d deg\ninterval = 30 deg\n",
                  e->speed, 360 * e->turns);
    to += sprintf(to, "[gas]\nbore = %.17g m\npiston_rod = %.17g m\nback_pressure = %.17g Pa\n",
                  (double)e->bore, (double)e->rod, e->back);
    to += put_clearance(e, to);
    for (k = 0; k < e->n; k++)
        to += sprintf(to, "%s %.17g deg %.17g Pa", k ? "," : "indicator =", e->x[k], e->y[k]);
    strcpy(to, "\n");
}

/* ---------------------------------------------------------------------------------------------- comparisons */

/* The worst of all, each relative to its scale. */
enum { VOLUME, PRESSURE, SWEPT, RATIO, WORK, ROUGH_WORK, TORQUE, QUANTITIES };
static const char *const names[QUANTITIES] = {"volume", "pressure",   "displacement", "ratio",
                                              "work",   "rough work", "mean torque"};
static const double most[QUANTITIES] = {1e-14, 1e-11, 1e-12, 1e-12, 1e-12, 1e-11, 1e-12};

typedef struct worst {
    double of[QUANTITIES];
    long torques;
} worst;

static void compare(const engine *e, worst *w, int what, double value, long double expected,
                    long double scale)
{
    double off = (double)(fabsl(value - expected) / scale);

    if (!(off <= w->of[what]))
        w->of[what] = off;
    if (!(off <= most[what]))
        fail_msg("%s = %.17g, expected %.17Lg, off by %.3g\n%s", names[what], value, expected, off,
                 e->text);
}

static long double largest_of(const engine *e)
{
    long double largest = 0;
    int k;

    for (k = 0; k < e->n; k++)
        largest = fmaxl(largest, fabsl(e->y[k]));
    return largest;
}

static void compare_rows(const engine *e, fourlink_results *r, worst *w)
{
    long double A = area_of(e), largest = largest_of(e);
    int k;

    for (k = 0; k < 8; k++) {
        double at = k < 2 ? e->x[one_of(e->n)] : between(-800, 800);
        long double x = displacement_of_pin(e, at * PIL / 180);
        double pressure = si_value(r, "pressure", (fourlink_branch)e->o.branch, at);
        long double back = e->back * PIL / 4 * (e->bore * e->bore - e->rod * e->rod);

        compare(e, w, VOLUME, si_value(r, "volume", (fourlink_branch)e->o.branch, at),
                e->clearance + A * x, e->clearance + A * (2 * e->o.a + e->o.b));
        compare(e, w, PRESSURE, pressure, pressure_at(e, at), largest);
        compare(e, w, PRESSURE, si_value(r, "gas_force", (fourlink_branch)e->o.branch, at),
                A * pressure - back, A * largest + back);
    }
}

/* A torque near a change point has a peak that is seen only by chance, or none. */
static void compare_facts(const engine *e, fourlink_results *r, worst *w)
{
    fourlink_branch branch = (fourlink_branch)e->o.branch;
    long double swept = area_of(e) * stroke_of(e), work = work_of(e), size = swept * largest_of(e);
    double found = si_value(r, "indicated_work", branch, 0), cycle = 2 * PI * e->turns;
    fourlink_value v;

    compare(e, w, SWEPT, si_value(r, "displacement", branch, 0), swept,
            area_of(e) * (e->o.a + e->o.b));
    if (e->clearance > 0)
        compare(e, w, RATIO, si_value(r, "compression_ratio", branch, 0),
                (e->clearance + swept) / e->clearance,
                1 + area_of(e) * (e->o.a + e->o.b) / e->clearance);
    else
        assert_int_equal(fourlink_results_value(r, "compression_ratio", branch, 0, &v),
                         FOURLINK_NO_SUCH_FACT);
    compare(e, w, e->is_rough ? ROUGH_WORK : WORK, found, work, size);
    compare(e, w, SWEPT, si_value(r, "mep", branch, 0) * (double)swept, found, size);
    if (e->speed == 0)
        return;
    compare(e, w, SWEPT, si_value(r, "indicated_power", branch, 0) * cycle / fabs(e->speed), found,
            size);
    if (fourlink_results_value(r, "mean_torque", branch, 0, &v) != FOURLINK_OK)
        return;
    w->torques++;
    compare(e, w, TORQUE, v.value * v.to_si * cycle * (e->speed < 0 ? -1 : 1), found, size);
}

static void try_engines(long n, worst *w)
{
    engine e;
    long i;

    memset(w, 0, sizeof *w);
    for (i = 0; i < n; i++) {
        fourlink_results *r;

        draw_engine(i, &e);
        r = opened(e.text);
        compare_rows(&e, r, w);
        compare_facts(&e, r, w);
        fourlink_results_free(r);
    }
}

TEST(test_random_engines)
{
    worst w;

    try_engines(150, &w);
    assert_true(w.torques > 100);
}

/* A Scotch yoke with a linear card, whose work has a closed form: p = p1 for the stroke out and p2 for that in
** but for a step of 0.002 deg at each end, and between them p1 - p2 over the displacement. */
TEST(test_rectangle)
{
    fourlink_results *r = opened(
        "mechanism = scotch-yoke\n[crank]\nlength = 50 mm\n[motion]\nspeed = 60 rpm\n[gas]\nbore = "
        "100 mm\nclearance = 5 %\nindicator = 0.001 deg 5 bar, 179.999 deg 5 bar, 180.001 deg 2 "
        "bar, 359.999 deg 2 bar\n");
    double swept = PI / 4 * 0.1 * 0.1 * 0.1;

    assert_close(si_value(r, "displacement", FOURLINK_OPEN, 0), swept, 1e-14);
    assert_close(si_value(r, "compression_ratio", FOURLINK_OPEN, 0), 21.0, 1e-14);
    assert_close(si_value(r, "indicated_work", FOURLINK_OPEN, 0), 3e5 * swept, 1e-9);
    assert_close(si_value(r, "indicated_power", FOURLINK_OPEN, 0), 3e5 * swept, 1e-9);
    assert_close(si_value(r, "mep", FOURLINK_OPEN, 0), 3e5, 1e-9);
    assert_close(si_value(r, "max(volume)", FOURLINK_OPEN, 0), 1.05 * swept, 1e-14);
    assert_close(si_value(r, "min(volume)", FOURLINK_OPEN, 0), 0.05 * swept, 1e-14);
    assert_close(si_value(r, "max(pressure)", FOURLINK_OPEN, 0), 5e5, 1e-14);
    fourlink_results_free(r);
}

#define PISTON "mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 mm\n"
#define CARD "[gas]\nbore = 80 mm\nindicator = 0 deg 5 bar, 90 deg 2 bar, 180 deg 1 bar\n"

/* What each deck has. */
TEST(test_who_has_it)
{
    static const struct {
        const char *deck;
        int has_column, has_displacement, has_work, has_power;
    } decks[] = {
        {PISTON CARD "[motion]\nspeed = 10 rad/s\n", 1, 1, 1, 1},
        {PISTON CARD "[motion]\nspeed = 10 rad/s\nacceleration = 3 rad/s2\n", 1, 1, 1, 0},
        {PISTON CARD "[motion]\nspeed = 0 rad/s\n", 1, 1, 1, 0},
        {PISTON CARD "[motion]\nspeed = 10 rad/s\ncycle = 200 deg\n", 1, 1, 0, 0},
        {PISTON CARD "[motion]\nprogram = 0 s 0 deg, 1 s 360 deg\n", 1, 1, 1, 0},
        {PISTON "[gas]\nbore = 80 mm\npressure = 5 bar\n[motion]\nspeed = 1 rad/s\n", 1, 1, 0, 0},
        {PISTON "[piston]\nmass = 1 kg\n[motion]\nspeed = 10 rad/s\n", 0, 0, 0, 0},
        {"mechanism = slider-crank\n[crank]\nlength = 200 mm\n[rod]\nlength = 50 mm\n" CARD
         "clearance = 3 mm\n[motion]\nspeed = 10 rad/s\nfrom = -5 deg\nto = 5 deg\n",
         1, 0, 0, 0},
        {"mechanism = inverted-slider-crank\n[crank]\nlength = 50 mm\n[ground]\nlength = 200 "
         "mm\n" CARD "[motion]\nspeed = 10 rad/s\n",
         0, 0, 0, 0}};
    fourlink_value v;
    size_t i;

    for (i = 0; i < COUNT(decks); i++) {
        fourlink_results *r = opened(decks[i].deck);

        print_message("%s", decks[i].deck);
        assert_int_equal(fourlink_results_value(r, "volume", FOURLINK_OPEN, 3, &v) == FOURLINK_OK,
                         decks[i].has_column);
        assert_int_equal(fourlink_results_value(r, "pressure", FOURLINK_OPEN, 3, &v) == FOURLINK_OK,
                         decks[i].has_column);
        assert_int_equal(fourlink_results_value(r, "displacement", FOURLINK_OPEN, 0, &v) ==
                             FOURLINK_OK,
                         decks[i].has_displacement);
        assert_int_equal(fourlink_results_value(r, "indicated_work", FOURLINK_OPEN, 0, &v) ==
                             FOURLINK_OK,
                         decks[i].has_work);
        assert_int_equal(fourlink_results_value(r, "mep", FOURLINK_OPEN, 0, &v) == FOURLINK_OK,
                         decks[i].has_work);
        assert_int_equal(fourlink_results_value(r, "indicated_power", FOURLINK_OPEN, 0, &v) ==
                             FOURLINK_OK,
                         decks[i].has_power);
        fourlink_results_free(r);
    }
}

/* A clearance that is none is refused with its reason. */
TEST(test_refused)
{
    static const struct {
        const char *clearance, *message;
    } refused[] = {
        {"8", "the clearance needs a unit: a length such as 5 mm, a volume such as 40 cm3, or a "
              "share of the displacement such as 8 %"},
        {"0 %", "the clearance must be positive, not 0 %"},
        {"-3 mm", "the clearance must be positive, not -3 mm"},
        {"5 kg", "'5 kg' is a mass; expected a length, such as 80 mm"}};
    fourlink_results *r;
    fourlink_mistake mistake;
    fourlink_source source;
    size_t i;

    for (i = 0; i < COUNT(refused); i++) {
        source = deck_source(print(PISTON CARD "clearance = %s\n", refused[i].clearance));
        assert_int_equal(fourlink_results_open(&source, 1, &r, &mistake, NULL), FOURLINK_BAD_DECK);
        assert_string_equal(mistake.message, refused[i].message);
    }
    source = deck_source("mechanism = slider-crank\n[crank]\nlength = 200 mm\n[rod]\nlength = 50 "
                         "mm\n" CARD "clearance = 8 %\n");
    assert_int_equal(fourlink_results_open(&source, 1, &r, &mistake, NULL), FOURLINK_BAD_DECK);
    assert_string_equal(mistake.message,
                        "a clearance of 8 % is a share of the displacement, which needs a crank "
                        "that turns fully: give a length or a volume");
}

int main(int argc, char **argv)
{
    if (argc > 1) {
        long n = atol(argv[1]);
        worst w;
        int k;

        try_engines(n, &w);
        printf("%ld engines, %ld with a mean torque, worst", n, w.torques);
        for (k = 0; k < QUANTITIES; k++)
            printf("%s %s %.2g", k ? "," : "", names[k], w.of[k]);
        printf("\n");
        return 0;
    }
    return run_all_tests(watch_gsl);
}
