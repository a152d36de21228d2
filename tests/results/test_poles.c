/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_poles.c - the extremes, means and root mean squares of columns that grow without bound, against the rate
** of that growth, which follows from the equations.
**
** With t the distance of the crank from a singular position, a column grows as t^-(n/2).  Its integral is
** infinite for n >= 2, that of its square for n >= 1.
**
** Dead position, e = sqrt(t): theta4 = A + B e + ..., so dtheta4/dtheta2 ~ 1/e and its derivative ~ 1/e^3.
** Velocities have n = 1, tangential accelerations n = 3.  Virtual work: Ts = - sum of force times velocity per
** crank speed, n = 1 for given forces, and 3 + 1 for those of inertia.  The joints transmit Ts along the line
** of the coupler; normal to it a link transmits its own inertia, n = 3.
**
** Change point: the motion is smooth there, and Ts with it.  The links transmit forces from a direction that
** is normal to their line: sin(mu) ~ t, n = 2.  Between them forces have either sign.
**
** Between: the mechanical advantage is 1 / (dtheta4/dtheta2), and a centre is at infinity where its link does
** not turn: n = 2, with either sign.
*/
#include "machines.h"

#define MOST_PLACES 4
#define MOST_TURNS 3
#define BESIDE 1e-5 /* rad: rows there have the sign of a pole */

/* A column, and n of its growth at the singular positions of a kind, and at dead positions that a machine with
** change points has besides. */
typedef struct growth {
    const char *column;
    int n[2];
} growth;

typedef struct machine {
    char text[3000];
    double place[MOST_PLACES]; /* crank angles of singular positions, rad; */
    int is_other[MOST_PLACES]; /* ... which of both n */
    int n_places, can_begin_there;
    int is_dead; /* 1: the singular positions of its kind are dead positions */
    const growth *growths;
    size_t n_growths;
    double from, to; /* deg */
} machine;

static uint64_t seed = 77;

static double chance(double low, double high)
{
    return uniform(&seed, low, high);
}

static double one_of_signs(void)
{
    return chance(-1, 1) < 0 ? -1 : 1;
}

/* ---- decks */

static void add_text(machine *m, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void add_text(machine *m, const char *format, ...)
{
    size_t used = strlen(m->text);
    va_list list;

    va_start(list, format);
    assert_in_range(vsnprintf(m->text + used, sizeof m->text - used, format, list), 0,
                    sizeof m->text - used - 1);
    va_end(list);
}

static void add_place(machine *m, double theta2)
{
    m->is_other[m->n_places] = 0;
    m->place[m->n_places++] = theta2;
}

/* Where the distance of B from D is `reach`: a^2 + d^2 - 2 a d cos(theta2) = reach^2. */
static void add_places_of_reach(machine *m, double a, double d, double reach, int is_other)
{
    double cosine = (a * a + d * d - reach * reach) / (2 * a * d);
    int sign;

    for (sign = -1; sign <= 1 && fabs(cosine) < 1 - 1e-9; sign += 2) {
        add_place(m, sign * acos(cosine));
        m->is_other[m->n_places - 1] = is_other;
    }
}

/* 1 if no two singular positions are close to one another. */
static int is_clear(const machine *m)
{
    int i, k;

    for (i = 0; i < m->n_places; i++)
        for (k = 0; k < i; k++)
            if (fabs(turned(m->place[i] - m->place[k], 2 * PI)) < 0.1)
                return 0;
    return 1;
}

static void add_link(machine *m, const char *name, double length, int has_mass)
{
    add_text(m, "[%s]\n", name);
    if (length > 0)
        add_text(m, "length = %.17g m\n", length);
    if (has_mass)
        add_text(m, "mass = %.17g kg\ninertia = %.17g kg m2\ncg = (%.17g, %.17g) m\n", chance(1, 3),
                 chance(0.01, 0.1), chance(0.05, 0.3), chance(-0.2, 0.2));
}

static void add_torque(machine *m, const char *link)
{
    add_text(m, "[load T]\nlink = %s\ntorque = %.17g N m\n", link, one_of_signs() * chance(5, 20));
}

static void add_force(machine *m, const char *link)
{
    add_text(m, "[load P]\nlink = %s\nforce = (%.17g, %.17g) N\n", link,
             one_of_signs() * chance(50, 200), one_of_signs() * chance(50, 200));
}

/* A revolution, a part or some turns, to either side, at one speed or accelerated. */
static void add_motion(machine *m)
{
    double turn = one_of_signs(), speed = turn * chance(2, 20), length = 360, nearest;
    size_t i;
    int k, how = (int)chance(0, 4);

    if (how == 1)
        length = chance(60, 350);
    if (how == 2)
        length = 360 * floor(chance(1.5, MOST_TURNS));
    do {
        m->from = how == 3 ? 0 : chance(-180, 180);
        m->to = m->from + turn * length;
        for (nearest = INFINITY, k = 0; k < m->n_places; k++) {
            nearest = fmin(nearest, fabs(turned(m->from - m->place[k] / DEG, 360)));
            nearest = fmin(nearest, fabs(turned(m->to - m->place[k] / DEG, 360)));
        }
        how = 0;
    } while (nearest < 1);
    add_text(m, "[motion]\nspeed = %.17g rad/s\nfrom = %.17g deg\nto = %.17g deg\n", speed, m->from,
             m->to);
    if (chance(0, 1) < 0.3)
        add_text(m, "acceleration = %.17g rad/s2\n", turn * chance(0, 10));
    add_text(m, "[table]\ncolumns = ");
    for (i = 0; i < m->n_growths; i++)
        add_text(m, "%s%s", i ? ", " : "", m->growths[i].column);
    add_text(m, "\n");
}

#define GROWTHS(m, list) ((m)->growths = (list), (m)->n_growths = COUNT(list))

/* ---- kinds of singular positions */

/* Coupler and rocker in one line: B is b + c or |b - c| from D. */
static void dead_four_bar(machine *m, int has_mass)
{
    static const growth of_loads[] = {
        {"omega3", {1, 0}},    {"omega4", {1, 0}}, {"alpha3", {3, 0}},    {"alpha4", {3, 0}},
        {"condition", {1, 0}}, {"Ts", {1, 0}},     {"Ts_work", {1, 0}},   {"power", {1, 0}},
        {"F12", {1, 0}},       {"F14", {1, 0}},    {"F34_along", {1, 0}}, {"P.x", {0, 0}},
        {"P.vx", {1, 0}},      {"P.v", {1, 0}},    {"P.ax", {3, 0}},      {"P.a", {3, 0}},
        {"gamma", {0, 0}}};
    static const growth of_inertia[] = {
        {"omega4", {1, 0}},     {"alpha4", {3, 0}},     {"Ts", {4, 0}},  {"Ts_static", {1, 0}},
        {"Ts_inertia", {4, 0}}, {"power", {4, 0}},      {"F12", {4, 0}}, {"F14", {4, 0}},
        {"F34_along", {4, 0}},  {"F34_across", {3, 0}}, {"Fi3", {3, 0}}, {"Fi4", {3, 0}},
        {"Ci3", {3, 0}},        {"Ci4", {3, 0}},        {"Fs", {3, 0}},  {"Fsx", {3, 0}},
        {"Ms", {3, 0}}};
    double a, b, c, d;

    do {
        a = chance(0.2, 1);
        b = chance(0.2, 1);
        c = chance(0.2, 1);
        d = chance(0.2, 1);
        m->n_places = 0;
        add_places_of_reach(m, a, d, b + c, 0);
        add_places_of_reach(m, a, d, fabs(b - c), 0);
    } while (m->n_places == 0 || !is_clear(m));
    add_text(m, "mechanism = four-bar\n[ground]\nlength = %.17g m\nangle = %.17g deg\n", d,
             chance(-180, 180));
    add_link(m, "crank", a, has_mass);
    add_link(m, "coupler", b, has_mass);
    add_link(m, "rocker", c, has_mass);
    add_torque(m, "rocker");
    add_force(m, "coupler");
    add_text(m, "at = (%.17g, %.17g) m\n[point P]\nlink = coupler\nat = (%.17g, %.17g) m\n",
             chance(0, 0.3), chance(0, 0.3), chance(0.1, 0.5), chance(0.1, 0.5));
    if (has_mass)
        GROWTHS(m, of_inertia);
    else
        GROWTHS(m, of_loads);
}

/* The rod at right angles to the stroke: r sin(theta2) - e = +-l. */
static void dead_slider_crank(machine *m, int has_mass)
{
    static const growth of_loads[] = {{"x", {0, 0}},      {"v", {1, 0}},         {"a", {3, 0}},
                                      {"omega3", {1, 0}}, {"alpha3", {3, 0}},    {"N", {1, 0}},
                                      {"Ts", {1, 0}},     {"F23", {1, 0}},       {"F12", {1, 0}},
                                      {"power", {1, 0}},  {"condition", {1, 0}}, {"phi", {0, 0}}};
    static const growth of_inertia[] = {{"N", {4, 0}},   {"Ts", {4, 0}},   {"F12", {4, 0}},
                                        {"Fi4", {3, 0}}, {"Fi3", {3, 0}},  {"v", {1, 0}},
                                        {"a", {3, 0}},   {"power", {4, 0}}};
    double r, l, e;
    int sign;

    do {
        r = chance(0.3, 1);
        l = r * chance(0.3, 0.9);
        e = one_of_signs() * (chance(0, 1) < 0.3 ? 0 : chance(0.1, 0.9) * l);
        for (m->n_places = 0, sign = -1; sign <= 1; sign += 2)
            if (fabs(e + sign * l) < r) {
                add_place(m, asin((e + sign * l) / r));
                add_place(m, PI - asin((e + sign * l) / r));
            }
    } while (!is_clear(m));
    add_text(m, "mechanism = slider-crank\n[ground]\noffset = %.17g m\nangle = %.17g deg\n", e,
             chance(-180, 180));
    add_link(m, "crank", r, has_mass);
    add_link(m, "rod", l, has_mass);
    add_text(m, "[piston]\n%s", has_mass ? "mass = 1.7 kg\n" : "");
    add_force(m, "piston");
    if (has_mass)
        GROWTHS(m, of_inertia);
    else
        GROWTHS(m, of_loads);
}

/* The slide touches the circle of its offset: a^2 + d^2 - 2 a d cos(theta2) = h^2. */
static void dead_inverted(machine *m, int has_mass)
{
    static const growth of_loads[] = {
        {"slide", {0, 0}},  {"slide_v", {1, 0}},   {"slide_a", {3, 0}}, {"omega4", {1, 0}},
        {"alpha4", {3, 0}}, {"coriolis", {2, 0}},  {"N34", {1, 0}},     {"Ts", {1, 0}},
        {"power", {1, 0}},  {"condition", {1, 0}}, {"F12", {1, 0}}};
    static const growth of_inertia[] = {{"N34", {4, 0}}, {"Ts", {4, 0}},  {"F12", {4, 0}},
                                        {"F14", {4, 0}}, {"Ci4", {3, 0}}, {"slide_v", {1, 0}}};
    double d, a, h;

    do {
        d = chance(0.4, 1);
        a = d * chance(0.5, 1.8);
        h = one_of_signs() * chance(0.1, 2);
        m->n_places = 0;
        add_places_of_reach(m, a, d, h, 0);
    } while (m->n_places == 0 || !is_clear(m));
    add_text(m,
             "mechanism = inverted-slider-crank\n[ground]\nlength = %.17g m\nangle = %.17g deg\n",
             d, chance(-180, 180));
    add_link(m, "crank", a, has_mass);
    add_link(m, "slider", 0, has_mass);
    add_text(m, "[lever]\noffset = %.17g m\n", h);
    if (has_mass)
        add_text(m, "mass = 2 kg\ninertia = 0.3 kg m2\ncg = (0.2, 0.1) m\n");
    add_torque(m, "lever");
    if (has_mass)
        GROWTHS(m, of_inertia);
    else
        GROWTHS(m, of_loads);
}

/* All links in one line, with lengths that are exact: parallelograms, kites, others. */
static void change_four_bar(machine *m, int has_mass)
{
    static const growth of_loads[] = {
        {"omega4", {0, 1}}, {"alpha4", {0, 3}},     {"Ts", {0, 1}},        {"Fs", {0, 0}},
        {"Ms", {0, 0}},     {"F34_across", {0, 0}}, {"F12", {2, 1}},       {"F14", {2, 1}},
        {"F34", {2, 1}},    {"F12x", {2, 1}},       {"F34_along", {2, 1}}, {"condition", {2, 1}}};
    static const growth of_inertia[] = {
        {"omega4", {0, 1}}, {"alpha4", {0, 3}},     {"Ts", {0, 4}},        {"Fs", {0, 3}},
        {"Ms", {0, 3}},     {"F34_across", {0, 3}}, {"F12", {2, 4}},       {"F14", {2, 4}},
        {"F34", {2, 4}},    {"F12x", {2, 4}},       {"F34_along", {2, 4}}, {"condition", {2, 1}}};
    double a, b, c, d;
    int how, k;

    do {
        a = floor(chance(2, 16)) / 16;
        b = floor(chance(2, 16)) / 16;
        d = floor(chance(2, 16)) / 16;
        how = (int)chance(0, 5);
        b = how == 0 ? d : how == 1 ? a : b;
        if (how == 2)
            d = a;
        c = how == 0 ? a : how == 1 ? d : how == 2 ? b : how == 3 ? fabs(a + d - b) : a + b - d;
        m->n_places = 0;
        for (k = 0; k < 2; k++) {
            double reach = k ? a + d : fabs(a - d);

            if (reach == fabs(b - c) || reach == b + c)
                add_place(m, k * PI);
        }
        add_places_of_reach(m, a, d, b + c, 1);
        add_places_of_reach(m, a, d, fabs(b - c), 1);
    } while (!(c > 0.1) || (how > 2 && (a == d || b == c)) || a == c ||
             fmax(fabs(a - d), fabs(b - c)) >= fmin(a + d, b + c) || !is_clear(m));
    add_text(m, "mechanism = four-bar\n[ground]\nlength = %.17g m\n", d);
    add_link(m, "crank", a, has_mass);
    add_link(m, "coupler", b, has_mass);
    add_link(m, "rocker", c, has_mass);
    add_torque(m, "rocker");
    if (has_mass)
        GROWTHS(m, of_inertia);
    else
        GROWTHS(m, of_loads);
}

/* The piston in the centre of the crank. */
static void change_slider_crank(machine *m, int has_mass)
{
    static const growth list[] = {{"N", {2, 0}},  {"F23", {2, 0}},       {"F12", {2, 0}},
                                  {"Ts", {0, 0}}, {"v", {0, 0}},         {"a", {0, 0}},
                                  {"x", {0, 0}},  {"condition", {2, 0}}, {"F12_along", {2, 0}}};
    double r = floor(chance(2, 16)) / 16;

    add_text(m, "mechanism = slider-crank\n");
    add_link(m, "crank", r, has_mass);
    add_link(m, "rod", r, has_mass);
    add_text(m, "[piston]\n%s", has_mass ? "mass = 1.7 kg\n" : "");
    add_force(m, "piston");
    add_place(m, PI / 2);
    add_place(m, -PI / 2);
    GROWTHS(m, list);
}

/* |h| = |a - d|: the block passes the foot of the lever's offset. */
static void change_inverted(machine *m, int has_mass)
{
    static const growth list[] = {{"N34", {2, 0}},     {"F12", {2, 0}},   {"Ts", {0, 0}},
                                  {"omega4", {0, 0}},  {"F14", {2, 0}},   {"slide", {0, 0}},
                                  {"slide_v", {0, 0}}, {"alpha4", {0, 0}}};
    double d = floor(chance(2, 16)) / 16, a = floor(chance(2, 16)) / 16;

    add_text(m, "mechanism = inverted-slider-crank\n[ground]\nlength = %.17g m\n", d);
    add_link(m, "crank", a, has_mass);
    add_link(m, "slider", 0, has_mass);
    add_text(m, "[lever]\noffset = %.17g m\n", one_of_signs() * (a - d));
    add_torque(m, "lever");
    add_place(m, 0);
    GROWTHS(m, list);
}

/* Poles between: link 4 or link 3 is at rest. */
static void between_rests(machine *m, int kind)
{
    static const growth of_slider[] = {{"mechanical_advantage", {2, 0}},
                                       {"I13x", {0, 0}},
                                       {"I13y", {0, 2}},
                                       {"klein_IX", {0, 0}},
                                       {"klein_IY", {0, 2}}};
    static const growth of_others[] = {{"mechanical_advantage", {2, 0}}};
    double r = chance(0.2, 1), d = r * chance(1.2, 3);
    int k;

    m->can_begin_there = 1;
    if (kind == 0) {
        add_text(m, "mechanism = slider-crank\n");
        add_link(m, "crank", r, 0);
        add_link(m, "rod", d, 1);
        add_text(m, "[piston]\n");
        for (k = 0; k < 4; k++) {
            add_place(m, k * PI / 2);
            m->is_other[k] = k % 2;
        }
        GROWTHS(m, of_slider);
        return;
    }
    if (kind == 1) {
        add_text(m, "mechanism = scotch-yoke\n");
        add_link(m, "crank", r, 0);
        add_place(m, 0);
        add_place(m, PI);
    } else { /* the crank at right angles to the lever */
        add_text(m, "mechanism = inverted-slider-crank\n[ground]\nlength = %.17g m\n", d);
        add_link(m, "crank", r, 0);
        add_place(m, acos(r / d));
        add_place(m, -acos(r / d));
    }
    GROWTHS(m, of_others);
}

/* ---- what is found */

static fourlink_results *results;
static long tried, infinite, undefined_ones, skipped;
static double worst; /* of finite means, by their scale */

typedef struct side {
    double angle; /* deg, of the singular position */
    double away;  /* deg, to a row beside it: with a sign */
    int is_other;
} side;

/* The sides of singular positions on the motion on which there are rows; returns their number. */
static int find_sides(const machine *m, fourlink_branch branch, side *list)
{
    double low = fmin(m->from, m->to), high = fmax(m->from, m->to), values[40], angle;
    int n = 0, k, sign;

    for (k = 0; k < m->n_places; k++) {
        angle = m->place[k] / DEG;
        angle += 360 * ceil((low - 1e-9 - angle) / 360);
        for (; angle < high + 1e-9; angle += 360)
            for (sign = -1; sign <= 1; sign += 2) {
                double beside = angle + sign * BESIDE / DEG;

                if (beside < low || beside > high ||
                    fourlink_results_at(results, branch, beside, values, NULL, NULL) != FOURLINK_OK)
                    continue;
                list[n].angle = angle;
                list[n].away = sign * BESIDE / DEG;
                list[n++].is_other = m->is_other[k];
            }
    }
    return n;
}

static double column_at(fourlink_branch branch, double angle, size_t column)
{
    double values[40];

    return fourlink_results_at(results, branch, angle, values, NULL, NULL) == FOURLINK_OK
               ? values[column]
               : NAN;
}

/* The integrals of 1, y, y^2 over the motion by Gauss's rule with 5 points, in many parts of u: from one singular
** position, or end of the motion, to the next it runs from 0 to 1, and as the root of the distance from a dead
** position. */
#define PARTS 60

typedef struct stop {
    double angle; /* deg */
    int is_dead;
} stop;

static int by_angle(const void *x, const void *y)
{
    const stop *a = x, *b = y;

    return a->angle < b->angle ? -1 : a->angle > b->angle;
}

static int list_stops(const machine *m, stop *list)
{
    double low = fmin(m->from, m->to), high = fmax(m->from, m->to), place;
    int n = 0, k;

    memset(list, 0, 2 * sizeof *list);
    list[n++].angle = low;
    list[n++].angle = high;
    for (k = 0; k < m->n_places; k++)
        for (place = m->place[k] / DEG, place += 360 * ceil((low - place) / 360); place < high;
             place += 360) {
            list[n].angle = place;
            list[n++].is_dead = m->is_dead || m->is_other[k];
        }
    qsort(list, (size_t)n, sizeof *list, by_angle);
    return n;
}

/* The part of the way, and its derivative. */
static double way(const stop *from, const stop *to, double u, double *rate)
{
    if (from->is_dead && to->is_dead) {
        *rate = PI / 2 * sin(PI * u);
        return (1 - cos(PI * u)) / 2;
    }
    *rate = from->is_dead ? 2 * u : to->is_dead ? 2 * (1 - u) : 1;
    return from->is_dead ? u * u : to->is_dead ? 1 - (1 - u) * (1 - u) : u;
}

static void integrate(const machine *m, fourlink_branch branch, int parts, double integrals[40][3])
{
    static const double nodes[5][2] = {{-0.90617984593866399280, 0.23692688505618908751},
                                       {-0.53846931010568309104, 0.47862867049936646804},
                                       {0, 0.56888888888888888889},
                                       {0.53846931010568309104, 0.47862867049936646804},
                                       {0.90617984593866399280, 0.23692688505618908751}};
    stop list[MOST_PLACES * (MOST_TURNS + 1) + 2];
    double values[40], rate;
    int n = list_stops(m, list), i, part, node, k;
    size_t c;

    memset(integrals, 0, 40 * sizeof *integrals);
    for (i = 0; i + 1 < n; i++)
        for (part = 0; part < parts; part++)
            for (node = 0; node < 5; node++) {
                double u = (part + 0.5 * (1 + nodes[node][0])) / parts;
                double length = list[i + 1].angle - list[i].angle;
                double angle = list[i].angle + length * way(&list[i], &list[i + 1], u, &rate);

                if (fourlink_results_at(results, branch, angle, values, NULL, NULL) == FOURLINK_OK)
                    for (c = 0; c < m->n_growths; c++)
                        for (k = 0; k < 3; k++)
                            integrals[c][k] += nodes[node][1] * length * rate * pow(values[c], k);
            }
}

/* 1 if the factor of the growth is too small beside other terms for rows to have its sign. */
static int is_weak(fourlink_branch branch, const side *s, size_t column, int n)
{
    double near = fabs(column_at(branch, s->angle + s->away, column));
    double far = fabs(column_at(branch, s->angle + 16 * s->away, column));

    return !(fabs(log(near / far) / log(16) - n / 2.0) < 0.1);
}

#define CLOSE 1e-7 /* of the rms, */
#define ROUGH 4    /* ... or of the difference between half and all parts */

/* NaN is expected for what is finite. */
static void check(const machine *m, const char *name, fourlink_branch branch, const char *statistic,
                  int status, double expected, double scale)
{
    fourlink_value v = {0};
    int found = fourlink_results_value(results, print("%s(%s)", statistic, name), branch, 0, &v);

    tried++;
    if (found != status || (status == FOURLINK_OK && isinf(expected) && v.value != expected) ||
        (status == FOURLINK_OK && isnan(expected) && !isfinite(v.value)) ||
        (status == FOURLINK_OK && isfinite(expected) &&
         !(fabs(v.value - expected) <= CLOSE * scale)))
        fail_msg("%s(%s), %s: %s, %.12g; expected %s, %.12g\n%s", statistic, name,
                 fourlink_branch_text((int)branch), fourlink_status_text(found), v.value,
                 fourlink_status_text(status), expected, m->text);
    if (status == FOURLINK_OK && isfinite(expected) && scale > 0)
        worst = fmax(worst, fabs(v.value - expected) / scale);
    infinite += isinf(expected) != 0;
    undefined_ones += status != FOURLINK_OK;
}

static void check_column(const machine *m, size_t column, fourlink_branch branch, const side *list,
                         int n_sides, double integrals[2][40][3])
{
    const growth *g = &m->growths[column];
    double mean[2], rms[2], scale, rough;
    int up = 0, down = 0, mean_up = 0, mean_down = 0, i;

    for (i = 0; i < n_sides; i++) {
        int n = g->n[list[i].is_other], is_up;

        if (n == 0)
            continue;
        if (is_weak(branch, &list[i], column, n)) {
            skipped++;
            return;
        }
        is_up = column_at(branch, list[i].angle + list[i].away, column) > 0;
        up |= is_up;
        down |= !is_up;
        mean_up |= n >= 2 && is_up;
        mean_down |= n >= 2 && !is_up;
    }
    for (i = 0; i < 2; i++) {
        mean[i] = integrals[i][column][1] / integrals[i][column][0];
        rms[i] = sqrt(integrals[i][column][2] / integrals[i][column][0]);
    }
    scale = rms[1] + 1e-3; /* a rocker can be at rest, but for rounding */
    rough = ROUGH * (fabs(mean[1] - mean[0]) + (up || down ? 0 : fabs(rms[1] - rms[0]))) / CLOSE;
    check(m, g->column, branch, "max", FOURLINK_OK, up ? INFINITY : NAN, 0);
    check(m, g->column, branch, "min", FOURLINK_OK, down ? -INFINITY : NAN, 0);
    check(m, g->column, branch, "rms", FOURLINK_OK, up || down ? INFINITY : rms[1], scale + rough);
    check(m, g->column, branch, "mean", mean_up && mean_down ? FOURLINK_NO_MEAN : FOURLINK_OK,
          mean_up     ? INFINITY
          : mean_down ? -INFINITY
                      : mean[1],
          scale + rough);
}

/* 1 if the linkage can be assembled somewhere in the motion. */
static int is_reached(const machine *m, fourlink_branch branch)
{
    double values[40];
    int i;

    for (i = 0; i <= 200; i++)
        if (fourlink_results_at(results, branch, m->from + (m->to - m->from) * i / 200, values,
                                NULL, NULL) == FOURLINK_OK)
            return 1;
    return 0;
}

static void check_machine(const machine *m)
{
    static side list[2 * MOST_PLACES * (MOST_TURNS + 2)];
    size_t column;
    static double integrals[2][40][3];
    int k, n;

    results = opened(m->text);
    for (k = 0; k < 2; k++) {
        if (!is_reached(m, branches[k]))
            continue;
        n = find_sides(m, branches[k], list);
        integrate(m, branches[k], PARTS / 2, integrals[0]);
        integrate(m, branches[k], PARTS, integrals[1]);
        for (column = 0; column < m->n_growths; column++)
            check_column(m, column, branches[k], list, n, integrals);
    }
    fourlink_results_free(results);
}

typedef void make_machine(machine *m, int how);

static void check_machines(make_machine *make, int is_dead, int hows, int n)
{
    int i;

    for (i = 0; i < (tries_all() ? n : n / 20); i++) {
        machine m;

        memset(&m, 0, sizeof m);
        m.is_dead = is_dead;
        make(&m, i % hows);
        add_motion(&m);
        check_machine(&m);
    }
    print_message(
        "%ld found, %ld infinite, %ld undefined, %ld columns skipped; finite means off by "
        "%.2g\n",
        tried, infinite, undefined_ones, skipped, worst);
}

TEST(test_dead_four_bars)
{
    check_machines(dead_four_bar, 1, 2, 400);
}

TEST(test_dead_slider_cranks)
{
    check_machines(dead_slider_crank, 1, 2, 300);
}

TEST(test_dead_inverted)
{
    check_machines(dead_inverted, 1, 2, 300);
}

TEST(test_change_four_bars)
{
    check_machines(change_four_bar, 0, 2, 400);
}

TEST(test_change_slider_cranks)
{
    check_machines(change_slider_crank, 0, 2, 200);
}

TEST(test_change_inverted)
{
    check_machines(change_inverted, 0, 2, 200);
}

TEST(test_between_rests)
{
    check_machines(between_rests, 0, 3, 200);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
