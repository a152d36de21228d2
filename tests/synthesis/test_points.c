/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_points.c - paths and motions through many positions: sums of squares of the literature, random linkages
** found again from their own points, all solutions by a dense walk of their curves, bad tasks.
*/
#include <complex.h>

#include "designs.h"

#define MOST 60

static int n_random = 2; /* an argument of the program */
static fourlink_solution found[100], again[100];

/* --------------------------------------------------------------------- a linkage, without the library */

/* The coupler point at a crank angle, by the law of cosines; NaN: not reached. */
static double complex walked(const fourlink_solution *s, double theta2)
{
    double r = length_of(s, 2), l = length_of(s, 3), c = length_of(s, 4), theta3;
    double complex B = r * cexp(I * theta2), f = length_of(s, 1) - B;
    int sign = s->branch == FOURLINK_OPEN ? 1 : -1;

    if (s->design.kind == FOURLINK_SLIDER_CRANK) {
        theta3 = asin((s->design.offset - cimag(B)) / l);
        theta3 = sign > 0 ? theta3 : PI - theta3;
    } else {
        theta3 = carg(f) + sign * acos((l * l + cabs(f) * cabs(f) - c * c) / (2 * l * cabs(f)));
    }
    return B + (s->point.x + I * s->point.y) * cexp(I * theta3);
}

/* The transmission angle by the sides of the triangle, or by the rod; NaN: not reached. */
static double walked_mu(const fourlink_solution *s, double theta2)
{
    double l = length_of(s, 3), c = length_of(s, 4);
    double complex B = length_of(s, 2) * cexp(I * theta2);
    double f = cabs(length_of(s, 1) - B);

    if (s->design.kind == FOURLINK_SLIDER_CRANK)
        return PI / 2 - fabs(asin((s->design.offset - cimag(B)) / l));
    return asin(fmin(1, sin(acos((l * l + c * c - f * f) / (2 * l * c)))));
}

static double complex in_frame(const fourlink_solution *s, fourlink_vector wanted)
{
    return (wanted.x - s->origin.x + I * (wanted.y - s->origin.y)) * cexp(-I * s->direction);
}

static int turns_fully(const fourlink_solution *s)
{
    return length_of(s, 1) == 0 || s->type == FOURLINK_CRANK_ROCKER ||
           s->type == FOURLINK_DOUBLE_CRANK;
}

/* Walk the working range: the linkage reaches all of it, passes the points in their order, each where it is
** nearest (without timing), and has the sum, the transmission angle and no other defect than it says. */
static void walk(const fourlink_points_task *t, const fourlink_solution *s)
{
    double sum = 0, largest = 0, mu_min = INFINITY, low = fmin(s->from, s->to), size = size_of(s);
    double high = fmax(s->from, s->to), near = 1e-6 * size;
    double first = INFINITY, last = -INFINITY;
    int steps = 4000, rises = 1, falls = 1, reaches = 1;

    for (int i = 0; i <= steps; i++) {
        double mu = walked_mu(s, low + (high - low) * i / steps);

        reaches &= !isnan(mu);
        mu_min = fmin(mu_min, isnan(mu) ? 0 : mu);
    }
    for (unsigned long j = 0; j < t->n; j++) {
        const fourlink_precision *p = &s->position[j];
        double complex wanted = in_frame(s, t->point[j]), at = walked(s, p->theta2);
        double off = cabs(at - wanted);

        assert_near(p->error, off, near);
        assert_near(cabs(p->point.x + I * p->point.y - wanted), 0, 1e-12 * size * s->ratio);
        sum += (t->weight ? t->weight[j] : 1) * off * off;
        largest = fmax(largest, off);
        if (j > 0) {
            const fourlink_precision *q = p - 1;
            fourlink_vector here = t->point[j], before = t->point[j - 1];
            int either = hypot(here.x - before.x, here.y - before.y) <= p->error + q->error;

            rises &= p->theta2 > q->theta2 || either;
            falls &= p->theta2 < q->theta2 || either;
        }
        first = fmin(first, p->theta2);
        last = fmax(last, p->theta2);
        for (int k = -40; k <= 40 && !t->timing && t->mu_min <= 0;
             k++) /* nothing beside is nearer */
            assert_false(cabs(walked(s, p->theta2 + 1e-4 * k) - wanted) < off - near);
        if (t->timing && j > 0)
            assert_near(remainder(p->theta2 - s->position[0].theta2 - t->timing[j - 1], 2 * PI), 0,
                        t->either_way ? 2 * PI : 1e-9);
    }
    assert_near(s->sum, sum, 1e-6 * sum + near * near);
    assert_near(s->largest, largest, near);
    assert_true(last - first < 2 * PI || !turns_fully(s));
    assert_int_equal(s->is_in_order, rises || falls);
    assert_int_equal(!(s->defects & FOURLINK_DEFECT_ORDER), t->any_order || rises || falls);
    if (!s->defects)
        assert_true(reaches);
    if (!s->defects) { /* the least angle may lie between two steps */
        assert_true(mu_min >= s->mu_min - 1e-6);
        assert_near(mu_min, s->mu_min, 5e-3);
    }
    assert_true(s->mu_min >= t->mu_min);
    if (!t->may_rock)
        assert_true(turns_fully(s));
}

/* Search, walk all solutions, and see that their order is right.  Returns the first sum. */
static double search(const fourlink_points_task *t)
{
    unsigned long n = 0;

    assert_int_equal(fourlink_synthesis_points(t, COUNT(found), found, &n), FOURLINK_OK);
    assert_true(n > 0 && n <= COUNT(found));
    for (unsigned long i = 0; i < n; i++) {
        assert_true(is_sound(&found[i]));
        walk(t, &found[i]);
        if (i > 0 && !found[i].defects == !found[i - 1].defects && found[i - 1].rms > 1e-9)
            assert_true(found[i].sum >= found[i - 1].sum * (1 - 1e-9));
        if (i > 0)
            assert_false(found[i - 1].defects && !found[i].defects);
    }
    return found[0].defects ? INFINITY : found[0].sum;
}

/* ----------------------------------------------------------------------- benchmarks of the literature */

static const fourlink_vector eighteen[] = {
    {0.5, 1.1},  {0.4, 1.1}, {0.3, 1.1}, {0.2, 1.0},  {0.1, 0.9},  {0.005, 0.75},
    {0.02, 0.6}, {0, 0.5},   {0, 0.4},   {0.03, 0.3}, {0.1, 0.25}, {0.15, 0.2},
    {0.2, 0.3},  {0.3, 0.4}, {0.4, 0.5}, {0.5, 0.7},  {0.6, 0.9},  {0.6, 1.0}};

TEST(six_points_on_a_line)
{
    fourlink_vector at[6];
    fourlink_points_task t = {.kind = FOURLINK_FOUR_BAR, .n = 6, .point = at};

    for (int i = 0; i < 6; i++)
        at[i] = (fourlink_vector){20, 20 + 5 * i};
    assert_true(search(&t) < 1e-22);
}

TEST(five_points_with_timing)
{
    static const fourlink_vector at[] = {
        {3, 3}, {2.759, 3.363}, {2.372, 3.663}, {1.890, 3.862}, {1.355, 3.943}};
    static const double timing[] = {15 * DEG, 30 * DEG, 45 * DEG, 60 * DEG};
    fourlink_points_task t = {.kind = FOURLINK_FOUR_BAR, .n = 5, .point = at, .timing = timing};

    assert_true(search(&t) < 1e-7); /* no crank that turns fully does better than 8.3e-8 */
    t.may_rock = 1;
    assert_true(search(&t) < 1e-22);
}

TEST(eighteen_points_with_timing)
{
    double timing[17];
    fourlink_points_task t = {
        .kind = FOURLINK_FOUR_BAR, .n = 18, .point = eighteen, .timing = timing};

    if (!tries_all()) /* test_many_points.test has one of these */
        return;
    for (int i = 0; i < 17; i++)
        timing[i] = 20 * (i + 1) * DEG;
    assert_true(search(&t) <= 0.009912);
    t.either_way = 1;
    assert_true(search(&t) <= 0.009912);
    t.mu_min = 30 * DEG;
    assert_true(search(&t) <= 0.00995);
}

TEST(eighteen_points)
{
    fourlink_points_task t = {.kind = FOURLINK_FOUR_BAR, .n = 18, .point = eighteen};

    if (!tries_all()) /* test_many_points.test has one of these */
        return;
    assert_true(search(&t) <= 0.0034);
    t.may_rock = 1;
    assert_true(search(&t) <= 0.00301);
    t.may_rock = 0;
    t.mu_min = 40 * DEG;
    assert_true(search(&t) <= 0.00343);
}

/* A closed curve may be listed from any of its points, and either way round; other starts may find a better linkage. */
TEST(any_point_is_the_first)
{
    fourlink_vector at[18];
    fourlink_points_task t = {.kind = FOURLINK_FOUR_BAR, .n = 18, .point = at};

    for (int k = 0; k < (tries_all() ? 18 : 0); k += 5) {
        for (int j = 0; j < 18; j++)
            at[j] = eighteen[(k % 2 ? 18 - j + k : j + k) % 18];
        assert_true(search(&t) <= 0.0026926);
    }
}

/* ---------------------------------------------------------------------------- linkages found again */

/* A random linkage whose crank turns fully, and n of its points in axes of the designer's. */
static void draw(uint64_t *state, int n, double noise, fourlink_solution *s, fourlink_vector *at,
                 double *timing)
{
    double from = uniform(state, 0, 2 * PI), turn = uniform(state, -1, 1) < 0 ? -1 : 1, size = 0;
    double complex axes = cexp(I * uniform(state, 0, 2 * PI)), centre = 0, z[MOST];
    fourlink_mechanism m;

    turn *= 2 * PI * (uniform(state, 0, 1) < 0.5 ? (n - 1.0) / n : uniform(state, 0.15, 0.95));
    memset(s, 0, sizeof *s);
    s->design.kind = FOURLINK_FOUR_BAR;
    do {
        for (int i = 1; i <= 4; i++)
            s->design.link[i].length = uniform(state, 0.2, 2.2);
        fourlink_prepare(&s->design, &m);
        fourlink_type_of(&m, &s->type);
    } while (s->type != FOURLINK_CRANK_ROCKER && s->type != FOURLINK_DOUBLE_CRANK);
    s->branch = uniform(state, -1, 1) < 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;
    s->point.x = uniform(state, -0.5, 1.5) * length_of(s, 3);
    s->point.y = uniform(state, -1.5, 1.5) * length_of(s, 3);
    for (int j = 0; j < n; j++) {
        z[j] = walked(s, from + turn * j / (n - 1));
        centre += z[j] / n;
    }
    for (int j = 0; j < n; j++)
        size += cabs(z[j] - centre) * cabs(z[j] - centre) / n;
    s->rms = sqrt(size);
    s->n_positions = n;
    s->origin = (fourlink_vector){3, -2};
    s->direction = carg(axes);
    for (int j = 0; j < n; j++) {
        s->position[j].theta2 = from + turn * j / (n - 1);
        z[j] += noise * s->rms * (uniform(state, -1, 1) + I * uniform(state, -1, 1));
        z[j] = 3 - 2 * I + axes * z[j];
        at[j] = (fourlink_vector){creal(z[j]), cimag(z[j])};
        if (j > 0)
            timing[j - 1] = turn * j / (n - 1);
    }
}

/* With and without timing, exact points and points with 1 % of noise: the fit is as close as the linkage that
** the points are of. */
TEST(random_linkages_are_found_again)
{
    uint64_t state = 76;
    int n_found = 0;

    for (int k = 0; k < n_random; k++) {
        int n = (int)uniform(&state, 5, MOST + 1), is_noisy = k % 4 > 1;
        fourlink_vector at[MOST];
        double timing[MOST], worst;
        fourlink_solution *s = &again[0];
        fourlink_points_task t = {.kind = FOURLINK_FOUR_BAR, .n = (unsigned long)n, .point = at};

        draw(&state, n, is_noisy ? 0.01 : 0, s, at, timing);
        t.timing = k % 2 ? timing : NULL;
        worst = s->rms * (is_noisy ? 0.01 * sqrt(2.0 / 3) * 1.1 : 1e-6);
        search(&t);
        if (!found[0].defects && found[0].rms <= worst)
            n_found++;
        else
            print_message("case %d: %d points%s%s, rms %.2g of their size, defects %d\n", k, n,
                          t.timing ? ", timing" : "", is_noisy ? ", noise" : "",
                          found[0].rms / s->rms, found[0].defects);
    }
    print_message("%d of %d linkages found again\n", n_found, n_random);
    assert_true(n_found >= n_random - n_random / 50);
}

/* ------------------------------------------------------------------------------- from one linkage */

static double sum_beside(const fourlink_points_task *t, const fourlink_solution *s,
                         const fourlink_solution *angles);
static double attitude(const fourlink_solution *s, double theta2);

/* A point of a linkage is pulled away in steps: from the linkage of each step the next is found, which is the same where
** nothing has moved, and fits better than the one before it does where it has: nearly so where that is as good as dead. */
TEST(a_point_is_pulled)
{
    uint64_t state = 86;
    int n_lost = 0, n_steps = 0, tries = 10 * n_random;

    for (int k = 0; k < tries; k++) {
        int n = (int)uniform(&state, 5, 31), moved = (int)uniform(&state, 0, n);
        fourlink_vector at[MOST], way = {uniform(&state, -1, 1), uniform(&state, -1, 1)};
        double timing[MOST], angle[MOST], before;
        fourlink_solution *near = &again[0];
        fourlink_points_task t = {
            .kind = FOURLINK_FOUR_BAR, .n = (unsigned long)n, .point = at, .near = near};
        unsigned long found_n;

        draw(&state, n, 0, near, at, timing);
        t.timing = k % 2 ? timing : NULL;
        t.angle = k % 3 == 2 ? angle : NULL;
        for (int j = 0; j < n; j++) {
            near->position[j].theta3 = attitude(near, near->position[j].theta2);
            angle[j] = near->position[j].theta3 + near->direction;
        }
        for (int step = 0; step < 6; step++) {
            int status = fourlink_synthesis_points(&t, 1, found, &found_n);

            if (status != FOURLINK_OK) { /* beyond a change point, or as good as dead */
                assert_int_equal(status, FOURLINK_NONE_FOUND);
                n_lost++;
                break;
            }
            assert_true(found_n == 1 && found[0].starts == 1);
            if (!t.angle)
                walk(&t, &found[0]);
            if (step == 0)
                for (int i = 1; i <= 4; i++)
                    assert_near(length_of(&found[0], i), length_of(near, i), 1e-5 * size_of(near));
            before = sum_beside(&t, near, near);
            if (!t.timing && !t.angle)
                assert_true(found[0].sum <=
                            before * (1 + (near->mu_min < DEG ? 0.01 : 1e-6)) + 1e-18);
            n_steps++;
            *near = found[0];
            at[moved].x += 0.01 * way.x * size_of(near);
            at[moved].y += 0.01 * way.y * size_of(near);
        }
    }
    print_message("%d points pulled, %d steps, %d lost\n", tries, n_steps, n_lost);
    assert_true(n_lost <= tries / 5);
}

/* ------------------------------------------------------------------------------- bounds of lengths */

/* 1 if all lengths, and their ratio, are within the bounds of the task. */
static int keeps_bounds(const fourlink_points_task *t, const fourlink_solution *s)
{
    double least = INFINITY, most = 0;

    for (int i = 1; i <= 4; i++)
        if (length_of(s, i) > 0) {
            least = fmin(least, length_of(s, i));
            most = fmax(most, length_of(s, i));
        }
    return least >= t->shortest && (t->longest == 0 || most <= t->longest) &&
           (t->length_ratio == 0 || most <= t->length_ratio * least);
}

/* 1 if its crank turns fully, without a dead position. */
static int still_turns(fourlink_solution *s)
{
    fourlink_mechanism m;

    return fourlink_prepare(&s->design, &m) == FOURLINK_OK &&
           fourlink_type_of(&m, &s->type) == FOURLINK_OK && turns_fully(s);
}

/* The sum of squares of a linkage near the crank angles of another, by a dense search. */
static double sum_beside(const fourlink_points_task *t, const fourlink_solution *s,
                         const fourlink_solution *angles)
{
    double sum = 0;

    for (unsigned long j = 0; j < t->n; j++) {
        double complex wanted = in_frame(s, t->point[j]);
        double least = INFINITY;

        for (int k = -200; k <= 200; k++)
            least = fmin(least, cabs(walked(s, angles->position[j].theta2 + 2e-4 * k) - wanted));
        sum += least * least;
    }
    return sum;
}

/* No linkage beside it that keeps the bounds is closer. */
static void see_least(uint64_t *state, const fourlink_points_task *t, const fourlink_solution *s)
{
    double step = 2e-3 * size_of(s);

    for (int k = 0; k < 200; k++) {
        fourlink_solution beside = *s;

        for (int i = 1; i <= 4; i++)
            if (length_of(s, i) > 0)
                beside.design.link[i].length += step * uniform(state, -1, 1);
        beside.design.offset += s->design.offset != 0 ? step * uniform(state, -1, 1) : 0;
        beside.origin.x += step * uniform(state, -1, 1);
        beside.origin.y += step * uniform(state, -1, 1);
        beside.direction += 2e-3 * uniform(state, -1, 1);
        beside.point.x += step * uniform(state, -1, 1);
        beside.point.y += step * uniform(state, -1, 1);
        if (keeps_bounds(t, &beside) && still_turns(&beside))
            assert_true(sum_beside(t, &beside, s) >= s->sum * (1 - 1e-4));
    }
}

/* Points of a random linkage: with bounds that it keeps they are met again; with others all solutions keep them, and the
** closest is a least one, if it is not near a change point, where a descent goes along a narrow valley. */
TEST(lengths_within_bounds)
{
    uint64_t state = 77;
    int n_met = 0, n_bounded = 0, n_least = 0, n = tries_all() ? n_random + 4 : 1;

    for (int k = 0; k < n; k++) {
        fourlink_vector at[MOST];
        double timing[MOST], least = INFINITY, most = 0;
        fourlink_solution *s = &again[0];
        fourlink_points_task t = {
            .kind = FOURLINK_FOUR_BAR, .n = 8 + 4 * (unsigned long)(k % 3), .point = at};
        unsigned long found_n = 0;
        int status;

        draw(&state, (int)t.n, 0, s, at, timing);
        for (int i = 1; i <= 4; i++) {
            least = fmin(least, length_of(s, i));
            most = fmax(most, length_of(s, i));
        }
        t.shortest = 0.99 * least;
        t.longest = 1.01 * most;
        t.length_ratio = 1.01 * most / least;
        search(&t);
        if (!found[0].defects && found[0].rms <= 1e-6 * s->rms)
            n_met++;
        else
            print_message("case %d: %lu points, rms %.2g of their size, defects %d\n", k, t.n,
                          found[0].rms / s->rms, found[0].defects);
        t.shortest = k % 2 ? 0 : (least + 0.25 * (most - least)) / 1.001;
        t.longest = k % 2 ? 0 : 0.9 * most;
        t.length_ratio = k % 2 ? 0.7 * most / least + 0.35 : 0;
        status = fourlink_synthesis_points(&t, COUNT(found), found, &found_n);
        if (status == FOURLINK_NONE_FOUND)
            continue;
        assert_int_equal(status, FOURLINK_OK);
        for (unsigned long i = 0; i < found_n; i++) {
            assert_true(is_sound(&found[i]) && keeps_bounds(&t, &found[i]));
            walk(&t, &found[i]);
        }
        n_bounded++;
        if (found[0].sum > 1e-10 * s->rms * s->rms && found[0].mu_min > 0.1) {
            see_least(&state, &t, &found[0]);
            n_least++;
        }
    }
    print_message(
        "%d of %d linkages met again within bounds, %d bounded, %d of them seen to be least\n",
        n_met, n, n_bounded, n_least);
    assert_true(n_met >= n - n / 50 - 1 && n_bounded >= n / 2);
}

/* --------------------------------------------------------------------------------------- choices */

TEST(pivots_are_where_they_are_wanted)
{
    fourlink_points_task t = {.kind = FOURLINK_FOUR_BAR, .n = 18, .point = eighteen};
    fourlink_vector low = {-0.5, -0.3}, high = {0.9, 0.4}, A = {0.2, 0.4}, D = {1.2, 0.1};
    unsigned long n = 0;

    if (!tries_all()) /* test_many_points.test has one of these */
        return;
    t.left = (fourlink_ground){1, low, high};
    search(&t);
    assert_true(found[0].origin.x >= low.x - 1e-9 && found[0].origin.x <= high.x + 1e-9);
    assert_true(found[0].origin.y >= low.y - 1e-9 && found[0].origin.y <= high.y + 1e-9);
    t.left = (fourlink_ground){1, A, A};
    t.right = (fourlink_ground){1, D, D};
    assert_int_equal(fourlink_synthesis_points(&t, COUNT(found), found, &n), FOURLINK_OK);
    for (unsigned long i = 0; i < n && i < COUNT(found); i++) {
        fourlink_vector at = found[i].is_swapped ? D : A;

        assert_near(found[i].origin.x, at.x, 1e-12);
        assert_near(found[i].origin.y, at.y, 1e-12);
        assert_near(length_of(&found[i], 1), hypot(1, 0.3), 1e-12);
    }
}

TEST(slider_crank)
{
    fourlink_vector at[20];
    fourlink_solution s = {.branch = FOURLINK_OPEN, .point = {0.8, 0.5}};
    fourlink_points_task t = {.kind = FOURLINK_SLIDER_CRANK, .n = 20, .point = at};

    s.design.kind = FOURLINK_SLIDER_CRANK;
    s.design.link[2].length = 0.5;
    s.design.link[3].length = 1.6;
    s.design.offset = 0.3;
    for (int j = 0; j < 20; j++) {
        double complex z = walked(&s, 0.3 + j * 0.31) * cexp(0.7 * I);

        at[j] = (fourlink_vector){creal(z) + 4, cimag(z)};
    }
    assert_true(search(&t) < 1e-20);
    assert_near(length_of(&found[0], 2), 0.5, 1e-7);
    assert_near(length_of(&found[0], 3), 1.6, 1e-7);
    assert_near(fabs(found[0].design.offset), 0.3, 1e-7);
    again[0] = found[0];
    t.near = &again[0];
    at[7].x += 0.05; /* pulled away, and back */
    assert_true(search(&t) <= 0.05 * 0.05);
    assert_int_equal(found[0].starts, 1);
    assert_true(fabs(length_of(&found[0], 3) - 1.6) > 1e-4);
    again[0] = found[0];
    at[7].x -= 0.05;
    assert_true(search(&t) < 1e-20);
    assert_near(length_of(&found[0], 3), 1.6, 1e-7);
}

/* The angle of the coupler in the linkage's frame, from two of its points. */
static double attitude(const fourlink_solution *s, double theta2)
{
    fourlink_solution pin = *s;

    pin.point = (fourlink_vector){length_of(s, 3), 0};
    return carg(walked(&pin, theta2) - length_of(s, 2) * cexp(I * theta2));
}

/* Points of a known linkage that are listed in another order than it passes them: it is found again, but only where any
** order is wanted it has no defect; there nothing that has one is better. */
TEST(points_in_another_order)
{
    enum { N = 9 };
    fourlink_solution s = {.branch = FOURLINK_OPEN, .point = {30, 25}};
    fourlink_vector at[N];
    fourlink_points_task t = {.kind = FOURLINK_FOUR_BAR, .n = N, .point = at};
    static const double lengths[] = {0, 60, 25, 70, 55};

    s.design.kind = FOURLINK_FOUR_BAR;
    for (int i = 1; i <= 4; i++)
        s.design.link[i].length = lengths[i];
    for (int j = 0; j < N; j++) {
        double complex z = walked(&s, 0.3 + 2 * PI * (j * 4 % N) / N);

        at[j] = (fourlink_vector){creal(z), cimag(z)};
    }
    assert_true(search(&t) > 1e-3);
    t.any_order = 1;
    assert_true(search(&t) < 1e-16);
    assert_false(found[0].is_in_order);
}

/* Poses of a known linkage, in axes of the designer's: it is found again, at given crank angles too.  Four and five
** poses have others. */
static void find_poses(int n, double from, double turn, int is_timed)
{
    static const double lengths[] = {0, 60, 25, 70, 55};
    fourlink_vector at[25];
    double angle[25], timing[25];
    fourlink_solution s = {.branch = FOURLINK_OPEN, .point = {30, 25}};
    fourlink_points_task t = {
        .kind = FOURLINK_FOUR_BAR, .n = (unsigned long)n, .point = at, .angle = angle};
    unsigned long found_n = 0;
    int is_found = 0;

    s.design.kind = FOURLINK_FOUR_BAR;
    for (int i = 1; i <= 4; i++)
        s.design.link[i].length = lengths[i];
    for (int j = 0; j < n; j++) {
        double theta2 = from + turn * j / (n - 1);
        double complex z = walked(&s, theta2) * cexp(0.4 * I) + 7;

        at[j] = (fourlink_vector){creal(z), cimag(z)};
        angle[j] = attitude(&s, theta2) + 0.4 + 1.1;
        if (j > 0)
            timing[j - 1] = turn * j / (n - 1);
    }
    t.timing = is_timed ? timing : NULL;
    assert_int_equal(fourlink_synthesis_points(&t, COUNT(found), found, &found_n), FOURLINK_OK);
    for (unsigned long k = 0; k < found_n; k++) {
        const fourlink_solution *f = &found[k];
        int is_it = 1;

        for (int j = 0; j < n; j++) {
            const fourlink_precision *p = &f->position[j];

            assert_near(cabs(walked(f, p->theta2) - in_frame(f, at[j])), p->error,
                        1e-6 * size_of(f));
            assert_near(remainder(attitude(f, p->theta2) - p->theta3 - p->residual, 2 * PI), 0,
                        1e-6 * f->ratio);
        }
        for (int i = 1; i <= 4; i++)
            is_it &= fabs(length_of(f, i) / lengths[i] - 1) < 1e-6;
        if (is_it && !f->defects && f->sum < 1e-16)
            is_found++;
    }
    assert_int_equal(is_found, 1);
}

TEST(poses_of_a_linkage)
{
    find_poses(25, 0.4, 6, 0);
    find_poses(8, 0.4, -3, 1);
    if (tries_all()) {
        find_poses(5, 0.4, 2, 0);
        find_poses(25, 2, -2, 0);
        find_poses(5, 1, 5, 0);
        find_poses(25, 2, -2, 1);
        find_poses(5, 1, 5, 1);
    }
}

TEST(the_same_on_each_run)
{
    fourlink_points_task t = {.kind = FOURLINK_FOUR_BAR, .n = 8, .point = eighteen};
    unsigned long n = 0, m = 0;

    if (!tries_all()) /* test_many_points.test has one of these */
        return;
    memset(found, 0, sizeof found);
    memset(again, 0, sizeof again);
    fourlink_synthesis_points(&t, COUNT(found), found, &n);
    fourlink_synthesis_points(&t, COUNT(again), again, &m);
    assert_int_equal(n, m);
    assert_memory_equal(found, again, sizeof found);
}

/* Points that no linkage passes well: of any size, far from their axes, on a line, in two places, with weights of
** any size.  Whatever is found is what it says. */
TEST(wild_points)
{
    uint64_t state = 7;

    for (int k = 0; k < (tries_all() ? (n_random + 1) / 2 + 4 : 2); k++) {
        fourlink_vector at[12];
        double weight[12], size = pow(10, uniform(&state, -6, 6));
        double far = k % 3 ? 0 : size * pow(10, uniform(&state, 0, 4));
        int n = (int)uniform(&state, 3, 13);
        fourlink_points_task t = {.kind = k % 5 == 4 ? FOURLINK_SLIDER_CRANK : FOURLINK_FOUR_BAR,
                                  .n = (unsigned long)n,
                                  .point = at,
                                  .weight = k % 2 ? weight : NULL,
                                  .may_rock = k % 4 == 3};
        unsigned long found_n = 0;
        int status;

        for (int j = 0; j < n; j++) {
            at[j].x = far + size * uniform(&state, -1, 1);
            at[j].y = far + size *
                                (k % 7 == 5            ? 0
                                 : k % 7 == 6 && j % 2 ? 1e-3
                                                       : 1) *
                                uniform(&state, -1, 1);
            weight[j] = pow(10, uniform(&state, -4, 4));
        }
        status = fourlink_synthesis_points(&t, COUNT(found), found, &found_n);
        assert_true(status == FOURLINK_OK || status == FOURLINK_NONE_FOUND);
        for (unsigned long i = 0; status == FOURLINK_OK && i < found_n; i++) {
            assert_true(is_sound(&found[i]));
            assert_true(found[i].ratio <= 100);
            for (int j = 0; j < n && found[i].mu_min > 0.01; j++) {
                const fourlink_precision *p = &found[i].position[j];

                assert_near(cabs(walked(&found[i], p->theta2) - in_frame(&found[i], at[j])),
                            p->error, 1e-6 * size_of(&found[i]));
            }
        }
    }
}

/* A start that is no linkage leads to none. */
TEST(wild_starts)
{
    static const double wild[] = {0, NAN, -1, 1e300, INFINITY, 1e-300};
    fourlink_solution *near = &again[0];
    fourlink_points_task t = {.kind = FOURLINK_FOUR_BAR, .n = 18, .point = eighteen, .near = near};
    unsigned long n;

    for (int k = 0; k < (int)COUNT(wild) * 4; k++) {
        int status;

        memset(near, 0, sizeof *near);
        near->n_positions = 18;
        near->design.kind = FOURLINK_FOUR_BAR;
        for (int i = 1; i <= 4; i++)
            near->design.link[i].length = i == 1 + k % 4 ? wild[k / 4] : 1;
        near->origin.x = near->position[3].theta2 = wild[k / 4];
        status = fourlink_synthesis_points(&t, COUNT(found), found, &n);
        assert_true(status == FOURLINK_NONE_FOUND ||
                    (status == FOURLINK_OK && is_sound(&found[0])));
    }
}

TEST(bad_tasks)
{
    static const fourlink_vector same[] = {{0, 0}, {1, 0}, {1, 1}, {1, 0}};
    static const double bad[17] = {0, NAN};
    fourlink_points_task good = {.kind = FOURLINK_FOUR_BAR, .n = 18, .point = eighteen}, t = good;

    REFUSED(points, NULL, FOURLINK_NULL);
    t.kind = FOURLINK_SCOTCH_YOKE;
    REFUSED(points, &t, FOURLINK_BAD_KIND);
    t = good;
    t.n = 2;
    REFUSED(points, &t, FOURLINK_BAD_POINTS);
    t.n = FOURLINK_POSITIONS_MAX + 1;
    REFUSED(points, &t, FOURLINK_BAD_POINTS);
    t = good;
    t.timing = bad;
    REFUSED(points, &t, FOURLINK_BAD_NUMBER);
    t = good;
    t.weight = bad;
    REFUSED(points, &t, FOURLINK_BAD_NUMBER);
    t = good;
    t.mu_min = 2;
    REFUSED(points, &t, FOURLINK_BAD_NUMBER);
    t = good;
    t.shortest = 2;
    t.longest = 1;
    REFUSED(points, &t, FOURLINK_BAD_CHOICE);
    t = good;
    t.length_ratio = 1;
    REFUSED(points, &t, FOURLINK_BAD_CHOICE);
    t = good;
    t.longest = NAN;
    REFUSED(points, &t, FOURLINK_BAD_NUMBER);
    t = good;
    t.right = (fourlink_ground){1, {1, 1}, {0, 2}};
    REFUSED(points, &t, FOURLINK_BAD_CHOICE);
    t = good;
    t.point = same;
    t.n = 4;
    REFUSED(points, &t, FOURLINK_DEPENDENT);
}

int main(int argc, char **argv)
{
    n_random = argc > 1 ? atoi(argv[1]) : n_random;
    return run_all_tests(watch_gsl);
}
