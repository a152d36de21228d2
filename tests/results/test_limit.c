/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_limit.c - limits and poles of a column at a dead position, against the formula that is put into the rows
** beside it; and means of a torque with a pole of any order, against the integral over another variable.
*/
#include <gsl/gsl_integration.h>

#include "machines.h"
#include "deck/reader.h"
#include "results/column.h"
#include "results/follow.h"

static uint64_t seed = 66;

static double chance(double low, double high)
{
    return uniform(&seed, low, high);
}

static double sign_by_chance(void)
{
    return chance(-1, 1) < 0 ? -1 : 1;
}

static double power_of_ten(double low, double high)
{
    return pow(10, chance(low, high));
}

/* ---- rows beside a dead position */

/* Coupler and rocker come into one line. */
#define DOUBLE_ROCKER                                                              \
    "mechanism = four-bar\n[ground]\nlength = 100 mm\n[crank]\nlength = 60 mm\n"   \
    "[coupler]\nlength = 30 mm\n[rocker]\nlength = 40 mm\nmass = 1 kg\n[motion]\n" \
    "speed = 1 rad/s\n"

typedef struct place {
    deck d;
    flk_analysis a;
    flk_follower f;
    flk_limit_rows rows;
    flk_column torque, size, direction;
} place;

static flk_column column_of(const flk_analysis *a, const char *name)
{
    flk_column c;
    size_t i;

    for (i = 0; i < flk_column_limit(a->d); i++)
        if (flk_column_number(a, i, &c) && strcmp(c.name, name) == 0)
            return c;
    fail_msg("no column %s", name);
    return c;
}

static void go_to_dead_position(place *p)
{
    fourlink_source source = deck_source(DOUBLE_ROCKER);

    assert_int_equal(flk_deck_read(&source, &p->d), 1);
    assert_true(flk_analysis_open(&p->a, &p->d, NULL));
    p->torque = column_of(&p->a, "Ts");
    p->size = column_of(&p->a, "F12");
    p->direction = column_of(&p->a, "F12_dir");
    flk_follow(&p->f, &p->a, FOURLINK_OPEN);
    do
        assert_true(flk_follow_next(&p->f));
    while (p->f.piece.end != FLK_END_DEAD || !flk_follow_is_reached(&p->f));
    flk_limit_rows_near(&p->f, flk_column_need(&p->torque) | flk_column_need(&p->size), 1,
                        &p->rows);
    assert_true(p->rows.is_root);
}

static void leave(place *p)
{
    flk_analysis_close(&p->a);
    flk_deck_free(&p->d);
}

/* ---- formulas */

#define TERMS 12

/* y(x) = S x^-q + a0 + a1 x^p + a2 x^2p + ..., p 1 or 1/2, x the root of the distance */
typedef struct formula {
    double S, q, p, a[TERMS];
    double magnitude; /* of all a */
} formula;

static formula some_formula(double p, double magnitude)
{
    double radius = power_of_ten(0, 1);
    formula f = {.p = p, .magnitude = magnitude};
    int k;

    for (k = 0; k < TERMS; k++)
        f.a[k] = f.magnitude * chance(-1, 1) * pow(radius, -k * p);
    if (chance(0, 1) < 0.2)
        f.a[0] = 0;
    else if (chance(0, 1) < 0.2)
        f.a[0] *= power_of_ten(-9, 0);
    return f;
}

static double pole_at(const formula *f, double x)
{
    return f->S == 0 ? 0 : f->S * pow(x, -f->q);
}

static double formula_at(const formula *f, double x)
{
    double y = 0;
    int k;

    for (k = TERMS - 1; k >= 0; k--)
        y = y * pow(x, f->p) + f->a[k];
    return y + pole_at(f, x);
}

/* The limit that the program finds, in SI units; of a vector with components u and v if `v` is not null. */
static flk_limit limit_of(place *p, const flk_column *c, const formula *u, const formula *v)
{
    double far = sqrt(p->rows.half), size = formula_at(u, far);
    flk_followed t;
    flk_limit l;
    int scale, k;

    for (scale = 0; scale < FLK_LIMIT_SCALES; scale++)
        for (k = 0; k < FLK_LIMIT_NODES; k++) {
            fourlink_forces *forces = &p->rows.row[scale][k].at.forces;

            forces->Ts = forces->F12x = formula_at(u, p->rows.x[scale][k]);
            forces->F12y = v ? formula_at(v, p->rows.x[scale][k]) : 0;
        }
    flk_follow_column(&p->f, &t, c);
    size = v ? hypot(size, formula_at(v, far)) : fabs(size);
    flk_limit_find(&p->rows, &t, size * c->scale, size * c->scale, &l);
    l.value /= c->scale;
    return l;
}

/* ---- trials */

/* Powers of x and of its root: 6e-10 of the column's size is the worst of 40,000. */
TEST(test_limits_in_powers)
{
    int n = some_of(40000), i;
    place p;

    go_to_dead_position(&p);
    for (i = 0; i < n; i++) {
        formula f = some_formula(i % 2 ? 1 : 0.5, power_of_ten(-3, 3));
        flk_limit l = limit_of(&p, &p.torque, &f, NULL);

        assert_near(l.value, f.a[0], 1e-8 * fmax(f.magnitude, fabs(formula_at(&f, 0.6))));
    }
    leave(&p);
}

/* Size and direction of a vector whose components have such powers, the direction also where both have a
** pole of the same order. */
TEST(test_limits_of_vectors)
{
    int n = some_of(20000), undecided = 0, i;
    place p;

    go_to_dead_position(&p);
    for (i = 0; i < n; i++) {
        formula u = some_formula(i % 2 ? 1 : 0.5, power_of_ten(-3, 3)),
                v = some_formula(u.p, u.magnitude);
        double direction;
        flk_limit l;

        u.a[0] = u.magnitude * sign_by_chance() * chance(0.1, 1);
        v.a[0] = u.magnitude * chance(-1, 1);
        l = limit_of(&p, &p.size, &u, &v);
        assert_near(l.value, hypot(u.a[0], v.a[0]),
                    1e-6 * hypot(formula_at(&u, 0.6), formula_at(&v, 0.6)) + 1e-6 * u.magnitude);
        l = limit_of(&p, &p.direction, &u, &v);
        direction = atan2(v.a[0], u.a[0]);
        undecided += isnan(l.value) != 0;
        if (!isnan(l.value))
            assert_near(remainder(l.value - direction, 2 * PI), 0, 1e-5);
    }
    leave(&p);
    assert_in_range(undecided, 0, n / 1000);
}

/* A pole of any order, such as those of loads with an exponent: wherever it is a tenth of the other terms in
** the row closest to the end, no limit is told; where it is the largest, its order is known. */
#define SEEN 0.1

TEST(test_poles_of_any_order)
{
    static const double orders[] = {1, 2, 3, 4, 2.6, 3.4, 1.5, 2.5, 3.5};
    int n = some_of(40000), seen = 0, undecided = 0, ordered = 0, unordered = 0, i;
    place p;

    go_to_dead_position(&p);
    for (i = 0; i < n; i++) {
        formula f = some_formula(i % 2 ? 1 : 0.5, power_of_ten(-3, 3));
        double part;
        flk_limit l;

        f.q = i % 3 ? chance(0.6, 4) : orders[(size_t)(i / 3) % COUNT(orders)];
        f.S = sign_by_chance() * power_of_ten(-6, 6);
        part = fabs(pole_at(&f, p.rows.x[0][0])) / f.magnitude;
        if (part < SEEN)
            continue;
        seen++;
        l = limit_of(&p, &p.torque, &f, NULL);
        if (isnan(l.value)) {
            undecided++;
            continue;
        }
        if (!(isinf(l.value) && l.value * f.S > 0))
            fail_msg("%g for %g x^-%g, %g of the other terms", l.value, f.S, f.q, part);
        if (part < 1)
            continue;
        ordered++;
        unordered += !(fabs(2 * l.growth - f.q) < 0.011);
    }
    leave(&p);
    assert_in_range(seen, n / 2, n);
    if (undecided > seen / 100 || unordered > ordered / 50)
        fail_msg("%d of %d undecided; orders of %d of %d", undecided, seen, unordered, ordered);
}

/* ---- means */

/* A torque on the rocker that grows with its speed, T |omega4|^n, with no mass: by virtual work
**
**    Ts = T |k|^(n + 1) omega2^n,   k = dtheta4/dtheta2 = a sin(theta2 - theta3) / (c sin(theta4 - theta3))
**
** At a dead position e = 0, where pi - e is the angle between coupler and rocker.  With f the distance of B from D
**
**    f^2 = a^2 + d^2 - 2 a d cos(theta2) = b^2 + c^2 + 2 b c cos(e),   -a d sin(theta2) dtheta2 = b c sin(e) de
**
** the integral over e has the weight e^-n and a smooth factor: gsl_integration_qaws.  It is finite for n < 1; that of
** Ts^2, for no n > 0. */
typedef struct rocker {
    double a, b, c, d, n; /* m */
    int branch, side;     /* of theta2: 1, -1 */
} rocker;

static double slope_at(const rocker *r, double theta2, double e)
{
    double phi = atan2(r->a * sin(theta2), r->a * cos(theta2) - r->d);
    double theta4 = phi - r->branch * atan2(r->b * sin(e), r->c + r->b * cos(e));
    double Bx = r->a * cos(theta2), By = r->a * sin(theta2);
    double theta3 = atan2(r->c * sin(theta4) - By, r->d + r->c * cos(theta4) - Bx);

    return r->a * sin(theta2 - theta3) / (r->c * r->branch * sin(e));
}

static double between_sides(double a, double d, double f)
{
    return acos((a * a + d * d - f * f) / (2 * a * d));
}

static double distance_of_B(double a, double d, double angle)
{
    return sqrt(a * a + d * d - 2 * a * d * cos(angle));
}

static double over_e(double e, void *data)
{
    const rocker *r = data;
    double theta2 = r->side * between_sides(r->a, r->d, distance_of_B(r->b, r->c, PI - e));

    e = fmax(e, 1e-100); /* the rule has a node at 0 */
    return pow(fabs(slope_at(r, theta2, e)), r->n + 1) * r->b * r->c * sin(e) /
           (r->a * r->d * fabs(sin(theta2))) * pow(e, r->n);
}

static double over_theta2(double theta2, void *data)
{
    const rocker *r = data;
    double e = PI - between_sides(r->b, r->c, distance_of_B(r->a, r->d, theta2));

    return pow(fabs(slope_at(r, theta2, e)), r->n + 1);
}

/* Over theta2 = -dead ... dead: with e where it is below that of dead / 2. */
static double mean_of_integrals(rocker *r, double dead)
{
    gsl_integration_workspace *room = gsl_integration_workspace_alloc(1000);
    gsl_integration_qaws_table *weight = gsl_integration_qaws_table_alloc(-r->n, 0, 0, 0);
    double half = 0.5 * dead, part, error, sum = 0;
    double e = PI - between_sides(r->b, r->c, distance_of_B(r->a, r->d, half));
    gsl_function f;

    f.params = r;
    for (r->side = -1; r->side <= 1; r->side += 2) {
        f.function = over_e;
        gsl_integration_qaws(&f, 0, e, weight, 0, 1e-9, 1000, room, &part, &error);
        sum += part;
        f.function = over_theta2;
        gsl_integration_qags(&f, fmin(r->side * half, 0), fmax(r->side * half, 0), 0, 1e-9, 1000,
                             room, &part, &error);
        sum += part;
    }
    gsl_integration_qaws_table_free(weight);
    gsl_integration_workspace_free(room);
    return sum / (2 * dead);
}

TEST(test_means_beside_poles_of_any_order)
{
    int n = some_of(400), i, branch;

    gsl_set_error_handler_off();
    for (i = 0; i < n;) {
        double a = chance(0.5, 2), b = chance(0.2, 1), c = chance(0.2, 1), d = chance(0.5, 2), dead;
        double exponent = i % 5 ? chance(0.05, 0.9) : chance(1.02, 3);
        rocker r = {a, b, c, d, exponent, 1, 1};
        fourlink_results *results;
        char deck_text[1000];

        /* it cannot be stretched to the whole turn, and is never folded */
        if (a + d < 1.05 * (b + c) || fabs(a - d) > 0.9 * (b + c) ||
            fabs(a - d) < 1.1 * fabs(b - c) + 0.05)
            continue;
        i++;
        dead = between_sides(a, d, b + c);
        snprintf(
            deck_text, sizeof deck_text,
            "mechanism = four-bar\n[ground]\nlength = %.17g m\n[crank]\nlength = %.17g m\n"
            "[coupler]\nlength = %.17g m\n[rocker]\nlength = %.17g m\n[load T]\nlink = rocker\n"
            "torque = -1 N m\nover = omega4\nat_speed = 1 rad/s\nexponent = %.17g\n[motion]\n"
            "speed = 1 rad/s\n",
            d, a, b, c, exponent);
        results = opened(deck_text);
        for (branch = 0; branch < 2; branch++) {
            double off, mean = named(results, "mean(Ts)", branches[branch], 0).value;

            assert_true(isinf(named(results, "rms(Ts)", branches[branch], 0).value));
            if (exponent > 1) {
                assert_true(isinf(mean) && mean > 0);
                continue;
            }
            r.branch = branches[branch] == FOURLINK_OPEN ? 1 : -1;
            off = fabs(mean / mean_of_integrals(&r, dead) - 1);
            if (!(off < 2e-5)) /* 6e-6 is the worst of 1,600 */
                fail_msg("mean(Ts) = %.17g, expected %.17g, of\n%s", mean,
                         mean_of_integrals(&r, dead), deck_text);
        }
        fourlink_results_free(results);
    }
    gsl_set_error_handler(fail_in_gsl);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
