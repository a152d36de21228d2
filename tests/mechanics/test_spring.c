/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_spring.c - springs and dampers: against their energy, and angles that count turns against small steps.
*/
#include "samples.h"

#define MOST_SPRINGS 4

static fourlink_spring spring(const fourlink_mechanism *m, int link, int to, double stiffness,
                              double free_length, double preload, double damping)
{
    fourlink_spring s;

    memset(&s, 0, sizeof s);
    s.link = link;
    s.to = to;
    s.stiffness = stiffness;
    s.free_length = free_length;
    s.preload = preload;
    s.damping = damping;
    assert_int_equal(fourlink_spring_prepare(m, &s), FOURLINK_OK);
    return s;
}

static fourlink_spring torsional(const fourlink_mechanism *m, int link, int to, double stiffness,
                                 double free_angle, double preload, double damping)
{
    fourlink_spring s = spring(m, link, to, stiffness, free_angle, preload, damping);

    s.is_torsional = 1;
    assert_int_equal(fourlink_spring_prepare(m, &s), FOURLINK_OK);
    return s;
}

/* Forces with springs; their energy and power in a sum. */
typedef struct sum {
    fourlink_forces f;
    double energy, power;
    fourlink_vector ground;
    double ground_moment;
} sum;

static sum solve(const sample *s, const fourlink_spring *springs, int n)
{
    fourlink_load load[MOST_LOADS + 2 * MOST_SPRINGS];
    unsigned long n_loads = s->n_loads, k;
    sum all;
    int i;

    memset(&all, 0, sizeof all);
    memcpy(load, s->load, sizeof s->load);
    for (i = 0; i < n; i++) {
        fourlink_spring_state at;

        assert_int_equal(fourlink_spring_at(&s->mechanism, &s->state, &springs[i], &at),
                         FOURLINK_OK);
        for (k = 0; k < at.n_loads; k++)
            load[n_loads++] = at.load[k];
        all.energy += at.energy;
        all.power += at.power;
        all.ground.x += at.ground.x;
        all.ground.y += at.ground.y;
        all.ground_moment += at.ground_moment;
    }
    assert_int_equal(fourlink_solve(&s->mechanism, &s->state, load, n_loads, &all.f), FOURLINK_OK);
    return all;
}

/* The springs of tests/expect/springs.deck. */
static void reference_springs(const fourlink_mechanism *m, fourlink_spring s[4])
{
    s[0] = spring(m, 4, 1, 800, 0.05, 3, 12);
    s[0].at.x = 0.04;
    s[0].at.y = 0.01;
    s[0].to_at.x = 0.1;
    s[0].to_at.y = 0.09;
    s[1] = spring(m, 3, 2, 150, 0.03, 0, 2.5);
    s[1].at.x = 0.05;
    s[1].at.y = 0.02;
    s[1].to_at.x = 0.005;
    s[2] = torsional(m, 4, 1, 1.5, 100 * DEG, 0.1, 0.02);
    s[3] = torsional(m, 4, 3, 0.4, 60 * DEG, 0, 0.005);
}

/* Any machine with springs of all sorts. */
static int draw(uint64_t *seed, int n, sample *s, fourlink_spring springs[3])
{
    int i;

    draw_any(seed, n, s);
    s->n_loads = 0;
    if (move(s) != FOURLINK_OK || fabs(s->state.sine) < 0.2)
        return 0;
    for (i = 0; i < 3; i++) {
        int link = 1 + (int)uniform(seed, 0, 4), to = 1 + (link + (int)uniform(seed, 0, 3)) % 4;

        springs[i] =
            i == 0 ? torsional(&s->mechanism, link, to, uniform(seed, 1, 9), uniform(seed, -3, 3),
                               uniform(seed, -5, 5), uniform(seed, 0, 2))
                   : spring(&s->mechanism, link, to, uniform(seed, 1, 9), uniform(seed, 0, 3),
                            uniform(seed, -5, 5), uniform(seed, 0, 2));
        springs[i].at.x = uniform(seed, -1, 1);
        springs[i].at.y = uniform(seed, -1, 1);
        springs[i].to_at.x = uniform(seed, -1, 1);
        springs[i].to_at.y = uniform(seed, -1, 1);
    }
    return 1;
}

/* At rest, without weight: Ts = dU/dtheta2, by differences of sixth order. */
TEST(test_energy)
{
    uint64_t seed = 5;
    int n = 0, tried = 0;

    while (n < 300) {
        static const double weight[6] = {-1, 9, -45, 45, -9, 1}, step[6] = {-3, -2, -1, 1, 2, 3};
        fourlink_spring springs[3];
        double slope = 0, h = 1e-3, largest = 0;
        sample s;
        int i;

        if (!draw(&seed, tried++, &s, springs))
            continue;
        s.design.gravity.x = s.design.gravity.y = 0;
        s.crank.omega2 = s.crank.alpha2 = 0;
        for (i = 0; i < 6; i++) {
            sample beside = s;
            sum all;

            beside.crank.theta2 += step[i] * h;
            if (move(&beside) != FOURLINK_OK)
                break;
            all = solve(&beside, springs, 3);
            slope += weight[i] * all.energy / (60 * h);
            largest = fmax(largest, fabs(all.energy));
        }
        if (i < 6)
            continue;
        assert_int_equal(move(&s), FOURLINK_OK);
        assert_near(solve(&s, springs, 3).f.Ts, slope, 1e-7 * (largest + 1));
        n++;
    }
}

/* Over a cycle at constant speed the crank puts in what the dampers take: masses, weights and springs
** give back all. */
TEST(test_work_of_dampers)
{
    double work = 0, lost = 0;
    fourlink_spring springs[4];
    int i;

    for (i = 0; i < 360; i++) {
        sample s = rocker(i);
        sum all;

        assert_int_equal(move(&s), FOURLINK_OK);
        reference_springs(&s.mechanism, springs);
        all = solve(&s, springs, 4);
        work += all.f.Ts * s.crank.omega2;
        lost -= all.power;
    }
    assert_true(lost > 0);
    assert_close(work, lost, 1e-12);
}

/* ---------------------------------------------------------------------------------------------
** Turns
** ------------------------------------------------------------------------------------------- */

/* A torsional spring from position to position. */
typedef struct follower {
    int link, to;
    fourlink_spring spring;
    double free_angle, before, previous; /* its angle, and that of the links */
} follower;

static double turned(const sample *s, int link)
{
    return link == 1 ? 0 : s->state.link[link].theta;
}

/* The angle of a torsional spring against steps that are added up, through every position that is reached. */
static void follow(const sample *s, follower *f, int has_previous, int is_first)
{
    double angle = turned(s, f->link) - turned(s, f->to);
    fourlink_spring_state at;

    assert_int_equal(fourlink_spring_at(&s->mechanism, &s->state, &f->spring, &at), FOURLINK_OK);
    assert_near(remainder(at.length - angle, 2 * PI), 0, 1e-6);
    if (has_previous)
        assert_near(at.length - f->before, remainder(angle - f->previous, 2 * PI), 1e-6);
    else if (is_first)
        assert_true(fabs(at.length - f->free_angle) <= PI + 0.2);
    f->previous = angle;
    f->before = at.length;
}

/* Springs between all links, on a branch: each position is computed once. */
static void follow_springs(sample *s)
{
    static const double free_angles[] = {
        -0.7, 2.9}; /* reached from the first position one way and the other */
    follower all[24];
    int i, k, link, to, n = 0, has_previous = 0, steps = 0;

    assert_int_equal(fourlink_prepare(&s->design, &s->mechanism), FOURLINK_OK);
    for (link = 1; link <= 4; link++)
        for (to = 1; to <= 4; to++)
            for (k = 0; k < 2 && link != to; k++) {
                all[n].link = link;
                all[n].to = to;
                all[n].free_angle = free_angles[k];
                all[n++].spring = torsional(&s->mechanism, link, to, 1, free_angles[k], 0, 0);
            }
    for (i = 1; i < 4 * 7200; i += tries_all() ? 2 : 14) {
        s->crank.theta2 = i * PI / 7200;
        if (fourlink_analyse(&s->mechanism, s->branch, &s->crank, NULL, 0, &s->state, NULL) !=
            FOURLINK_OK) {
            has_previous = 0;
            continue;
        }
        for (k = 0; k < n; k++)
            follow(s, &all[k], has_previous, steps == 0);
        steps += has_previous;
        has_previous = 1;
    }
    assert_true(steps > 0);
}

static void follow_all(int kind, double a, double b, double c, double d, double offset)
{
    int branch;
    sample s;

    for (branch = -1; branch <= 1; branch += 2) {
        memset(&s, 0, sizeof s);
        s.design.kind = (fourlink_kind)kind;
        s.design.link[1].length = d;
        s.design.link[2].length = a;
        s.design.link[3].length = b;
        s.design.link[4].length = c;
        s.design.offset = offset;
        s.branch = (fourlink_branch)branch;
        follow_springs(&s);
    }
}

TEST(test_turns)
{
    follow_all(FOURLINK_FOUR_BAR, 1, 3, 3, 4, 0);     /* crank-rocker */
    follow_all(FOURLINK_FOUR_BAR, 3, 3, 3.5, 1, 0);   /* double crank */
    follow_all(FOURLINK_FOUR_BAR, 3, 1, 2.5, 3, 0);   /* double rocker */
    follow_all(FOURLINK_FOUR_BAR, 3, 3, 1, 4, 0);     /* rocker-crank */
    follow_all(FOURLINK_FOUR_BAR, 4, 3, 1, 3, 0);     /* the same, a > d */
    follow_all(FOURLINK_FOUR_BAR, 3, 3.1, 3, 4.5, 0); /* triple rocker */
    follow_all(FOURLINK_FOUR_BAR, 1, 3, 1, 3, 0);     /* parallelogram */
    follow_all(FOURLINK_FOUR_BAR, 3, 1, 3, 1, 0);     /* the same, long cranks */
    follow_all(FOURLINK_FOUR_BAR, 1, 1, 3, 3, 0);     /* deltoids */
    follow_all(FOURLINK_FOUR_BAR, 3, 3, 1, 1, 0);
    follow_all(FOURLINK_FOUR_BAR, 1, 3, 3, 1, 0);
    follow_all(FOURLINK_FOUR_BAR, 3, 1.7, 1.7, 3, 0);
    follow_all(FOURLINK_FOUR_BAR, 1, 1, 1, 1, 0); /* rhombus */
    follow_all(FOURLINK_FOUR_BAR, 1, 3, 4, 2, 0); /* change point at 0, c > b */
    follow_all(FOURLINK_FOUR_BAR, 1, 4, 3, 2, 0); /* b > c */
    follow_all(FOURLINK_FOUR_BAR, 2, 3, 4, 1, 0); /* a > d */
    follow_all(FOURLINK_FOUR_BAR, 1, 2, 3, 4, 0); /* change point at 180 deg */
    follow_all(FOURLINK_FOUR_BAR, 4, 3, 2, 1, 0);
    follow_all(FOURLINK_SLIDER_CRANK, 1, 3, 0, 0, 0.3);
    follow_all(FOURLINK_SLIDER_CRANK, 3, 2, 0, 0, 0.3);
    follow_all(FOURLINK_SLIDER_CRANK, 1, 0.3, 0, 0, 0.5); /* two ranges, one of them below 0 */
    follow_all(FOURLINK_SLIDER_CRANK, 1, 0.3, 0, 0, -0.5);
    follow_all(FOURLINK_SLIDER_CRANK, 1, 1, 0, 0, 0);
    follow_all(FOURLINK_SLIDER_CRANK, 1, 1.5, 0, 0, 0.5);  /* change point at -90 deg */
    follow_all(FOURLINK_SLIDER_CRANK, 1, 1.5, 0, 0, -0.5); /* at 90 deg */
    follow_all(FOURLINK_INVERTED_SLIDER_CRANK, 1, 0, 0, 2, 0.1);
    follow_all(FOURLINK_INVERTED_SLIDER_CRANK, 2, 0, 0, 1, 0.1);
    follow_all(FOURLINK_INVERTED_SLIDER_CRANK, 2, 0, 0, 1, -0.1);
    follow_all(FOURLINK_INVERTED_SLIDER_CRANK, 1, 0, 0, 2, 1.5);
    follow_all(FOURLINK_INVERTED_SLIDER_CRANK, 1, 0, 0, 1, 0);
    follow_all(FOURLINK_INVERTED_SLIDER_CRANK, 1, 0, 0, 2, 1); /* change point */
    follow_all(FOURLINK_INVERTED_SLIDER_CRANK, 1, 0, 0, 2, -1);
    follow_all(FOURLINK_INVERTED_SLIDER_CRANK, 2, 0, 0, 1, 1);
}

TEST(test_no_direction)
{
    sample s = rocker(40);
    fourlink_spring_state at, before;
    fourlink_spring k;

    assert_int_equal(move(&s), FOURLINK_OK);
    k = spring(&s.mechanism, 4, 1, 100, 0, 0, 0);
    k.to_at.x = 0.08; /* D */
    assert_int_equal(fourlink_spring_at(&s.mechanism, &s.state, &k, &at), FOURLINK_OK);
    assert_true(at.length == 0 && at.force == 0 && at.load[0].force.x == 0);
    before = at;
    k.preload = 1;
    assert_int_equal(fourlink_spring_at(&s.mechanism, &s.state, &k, &at), FOURLINK_NO_DIRECTION);
    k.preload = 0;
    k.damping = 1;
    assert_int_equal(fourlink_spring_at(&s.mechanism, &s.state, &k, &at), FOURLINK_NO_DIRECTION);
    k.damping = 0;
    k.free_length = 1;
    assert_int_equal(fourlink_spring_at(&s.mechanism, &s.state, &k, &at), FOURLINK_NO_DIRECTION);
    assert_memory_equal(&at, &before, sizeof at);
}

TEST(test_bad)
{
    sample s = rocker(40);
    fourlink_spring good, k;
    fourlink_spring_state at;
    double *numbers[8];
    int i;

    assert_int_equal(move(&s), FOURLINK_OK);
    good = spring(&s.mechanism, 4, 1, 100, 0, 0, 0);
    k = good;
    k.to = 4;
    assert_int_equal(fourlink_spring_prepare(&s.mechanism, &k), FOURLINK_BAD_SPRING);
    k.to = 5;
    assert_int_equal(fourlink_spring_prepare(&s.mechanism, &k), FOURLINK_BAD_LINK);
    k = good;
    k.link = 0;
    assert_int_equal(fourlink_spring_prepare(&s.mechanism, &k), FOURLINK_BAD_LINK);
    k = good;
    k.only = 3;
    assert_int_equal(fourlink_spring_prepare(&s.mechanism, &k), FOURLINK_BAD_SPRING);
    k = good;
    k.damping = -1;
    assert_int_equal(fourlink_spring_prepare(&s.mechanism, &k), FOURLINK_BAD_SPRING);
    numbers[0] = &k.at.x;
    numbers[1] = &k.at.y;
    numbers[2] = &k.to_at.x;
    numbers[3] = &k.to_at.y;
    numbers[4] = &k.stiffness;
    numbers[5] = &k.free_length;
    numbers[6] = &k.preload;
    numbers[7] = &k.damping;
    for (i = 0; i < 8; i++) {
        k = good;
        *numbers[i] = NAN;
        assert_int_equal(fourlink_spring_prepare(&s.mechanism, &k), FOURLINK_BAD_NUMBER);
        *numbers[i] = -1e31;
        assert_int_equal(fourlink_spring_prepare(&s.mechanism, &k), FOURLINK_BAD_NUMBER);
    }
    assert_int_equal(fourlink_spring_prepare(NULL, &k), FOURLINK_NULL);
    assert_int_equal(fourlink_spring_prepare(&s.mechanism, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_spring_at(NULL, &s.state, &good, &at), FOURLINK_NULL);
    assert_int_equal(fourlink_spring_at(&s.mechanism, NULL, &good, &at), FOURLINK_NULL);
    assert_int_equal(fourlink_spring_at(&s.mechanism, &s.state, NULL, &at), FOURLINK_NULL);
    assert_int_equal(fourlink_spring_at(&s.mechanism, &s.state, &good, NULL), FOURLINK_NULL);
}

/* Of a buffer and a rope that are otherwise a spring one acts, with all that the spring does, on its
** side of the free length. */
TEST(test_buffer_and_rope)
{
    uint64_t seed = 11;
    int n[2] = {0, 0}, tried = 0, i, k;

    while (n[0] < 100 || n[1] < 100) {
        fourlink_spring springs[3];
        sample s;

        if (!draw(&seed, tried++, &s, springs))
            continue;
        for (i = 0; i < 3; i++) {
            fourlink_spring_state all, one[2];

            if (fourlink_spring_at(&s.mechanism, &s.state, &springs[i], &all) != FOURLINK_OK)
                continue;
            for (k = 0; k < 2; k++) {
                fourlink_spring single = springs[i];

                single.only = k ? FOURLINK_PULLS : FOURLINK_PUSHES;
                assert_int_equal(fourlink_spring_at(&s.mechanism, &s.state, &single, &one[k]),
                                 FOURLINK_OK);
                assert_true(one[k].length == all.length && one[k].rate == all.rate);
                assert_true(one[k].n_loads == all.n_loads);
            }
            k = all.length > springs[i].free_length;
            n[k]++;
            assert_memory_equal(&one[k], &all, sizeof all);
            assert_true(one[!k].force == 0 && one[!k].energy == 0 && one[!k].power == 0);
            assert_true(one[!k].ground.x == 0 && one[!k].ground_moment == 0);
            assert_true(one[!k].load[0].torque == 0 && one[!k].load[0].force.x == 0);
        }
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
