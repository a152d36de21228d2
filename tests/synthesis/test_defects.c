/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_defects.c - defects of solutions against linkages traced by brute force.
**
** A linkage is closed by circles on a grid of crank angles, with C on the left and on the right of B-D. 
** Neighbours on the grid are joined, and both sides where the reach ends.  The positions that are joined
** are a circuit; the sort of joins says what is passed on the way.
*/
#include "designs.h"
#include "synthesis/synthesis.h"

#define STEPS 3600

typedef struct traced {
    int is_slider;
    double a, b, c, d, e;
    int reached[STEPS];
    int part[2][STEPS]; /* the circuit, for both sides; -1: not reached */
    int arc[2][STEPS];  /* the same without the joins at the ends of the reach */
} traced;

/* How far the second circle is from being cut: > 0 if the linkage closes. */
static double slack_of(const traced *t, double theta2, double complex *B, double *f)
{
    *B = t->a * cexp(I * theta2);
    if (t->is_slider) {
        *f = fabs(t->e - cimag(*B));
        return t->b - *f;
    }
    *f = cabs(t->d - *B);
    return fmin(t->b + t->c - *f, *f - fabs(t->b - t->c));
}

/* theta4 or X on a side: 0 left (a piston: right of B), 1 the other. */
static double close_loop(const traced *t, double theta2, int side)
{
    double complex B, along;
    double f, x, y;

    slack_of(t, theta2, &B, &f);
    if (t->is_slider)
        return creal(B) + (side ? -1 : 1) * sqrt(t->b * t->b - f * f);
    x = (f * f + t->b * t->b - t->c * t->c) / (2 * f);
    y = sqrt(fmax(0, t->b * t->b - x * x));
    along = (t->d - B) / f;
    return carg(B + along * (x + (side ? -y : y) * I) - t->d);
}

static void spread(int (*part)[STEPS], int is_joined, const traced *t)
{
    int next = 0, changed;

    for (int side = 0; side < 2; side++)
        for (int i = 0; i < STEPS; i++)
            part[side][i] = t->reached[i] ? next++ : -1;
    do { /* the smallest number spreads */
        changed = 0;
        for (int pass = 0; pass < 2; pass++)
            for (int side = 0; side < 2; side++)
                for (int k = 0; k < STEPS; k++) {
                    int i = pass ? STEPS - 1 - k : k, j = (i + (pass ? STEPS - 1 : 1)) % STEPS;

                    if (!t->reached[i])
                        continue;
                    if (t->reached[j] && part[side][j] > part[side][i])
                        part[side][j] = part[side][i], changed = 1;
                    if (is_joined && !t->reached[j] && part[!side][i] > part[side][i])
                        part[!side][i] = part[side][i], changed = 1;
                }
    } while (changed);
}

static void trace(traced *t)
{
    for (int i = 0; i < STEPS; i++) {
        double complex B;
        double f;

        t->reached[i] = slack_of(t, 2 * PI * i / STEPS, &B, &f) > 0;
    }
    spread(t->part, 1, t);
    spread(t->arc, 0, t);
}

/* How far along its arc, counter-clockwise from the arc's beginning. */
static int place_on_arc(const traced *t, int i)
{
    int n = 0;

    while (n < STEPS && t->reached[(i - n - 1 + STEPS) % STEPS])
        n++;
    return n;
}

static int is_full(const traced *t)
{
    for (int i = 0; i < STEPS; i++)
        if (!t->reached[i])
            return 0;
    return 1;
}

/* Linkages of all types at three random positions. */
TEST(traced_linkages)
{
    static traced t;
    uint64_t seed = 31;
    int n_seen[128] = {0}, n_types[FOURLINK_TYPE_END_ + 1] = {0}, n_tried = 0;

    for (int k = 0; k < some_of(6000); k++) {
        fourlink_solution s;
        int at[3], side[3], expected = 0, other = 0;

        t.is_slider = k % 3 == 0;
        t.a = uniform(&seed, 0.2, 2);
        t.b = uniform(&seed, 0.2, 2);
        t.c = uniform(&seed, 0.2, 2);
        t.d = uniform(&seed, 0.2, 2);
        t.e = uniform(&seed, -1, 1);
        trace(&t);
        memset(&s, 0, sizeof s);
        s.design.kind = t.is_slider ? FOURLINK_SLIDER_CRANK : FOURLINK_FOUR_BAR;
        s.design.link[1].length = t.is_slider ? 0 : t.d;
        s.a = s.design.link[2].length = t.a;
        s.design.link[3].length = t.b;
        s.c = s.design.link[4].length = t.is_slider ? 0 : t.c;
        s.design.offset = t.is_slider ? t.e : 0;
        s.n_positions = 3;
        for (int j = 0; j < 3; j++) {
            int tries = 0;

            do
                at[j] = (int)uniform(&seed, 0, STEPS);
            while (!t.reached[at[j]] && tries++ < 10000);
            side[j] = uniform(&seed, 0, 1) < (k % 2 ? 0.5 : 0.1);
            if (!t.reached[at[j]])
                break;
            s.position[j].theta2 = 2 * PI * at[j] / STEPS;
            s.position[j].output = close_loop(&t, s.position[j].theta2, side[j]);
        }
        if (!t.reached[at[0]] || !t.reached[at[1]] || !t.reached[at[2]] || at[0] == at[1] ||
            at[1] == at[2] || at[0] == at[2])
            continue;
        n_tried++;
        assert_int_equal(flk_check_solution(&s, FLK_EITHER_WAY), FOURLINK_OK);
        for (int j = 1; j < 3; j++) {
            if (side[j] != side[0])
                expected |= FOURLINK_DEFECT_BRANCH;
            if (t.part[side[j]][at[j]] != t.part[side[0]][at[0]])
                expected |= FOURLINK_DEFECT_CIRCUIT;
            else if (t.arc[side[j]][at[j]] != t.arc[side[0]][at[0]])
                expected |= FOURLINK_DEFECT_WAY;
            other |= t.arc[0][at[j]] != t.arc[0][at[0]]; /* other ranges of the crank */
        }
        if (!is_full(&t) && !other) {
            int p[3] = {place_on_arc(&t, at[0]), place_on_arc(&t, at[1]), place_on_arc(&t, at[2])};

            if ((p[1] - p[0]) * (p[2] - p[1]) < 0)
                expected |= FOURLINK_DEFECT_ORDER;
        }
        if (expected & FOURLINK_DEFECT_CIRCUIT) { /* taken apart: no way and no order */
            expected &= ~(FOURLINK_DEFECT_WAY | FOURLINK_DEFECT_ORDER | FOURLINK_DEFECT_REACH);
            s.defects &= ~(FOURLINK_DEFECT_WAY | FOURLINK_DEFECT_ORDER | FOURLINK_DEFECT_REACH);
        }
        for (int j = 0; j < 3; j++)
            assert_int_equal(s.position[j].branch, side[j] ? FOURLINK_CROSSED : FOURLINK_OPEN);
        assert_int_equal(s.defects, expected);
        n_seen[s.defects]++;
        n_types[s.type]++;
        if (!s.defects) { /* the crank passes them on its way, and mu on it is not smaller */
            double low = fmin(s.from, s.to), high = fmax(s.from, s.to), least = 10;
            fourlink_mechanism m;

            assert_int_equal(fourlink_prepare(&s.design, &m), FOURLINK_OK);
            assert_true(s.position[1].theta2 > low && s.position[1].theta2 < high &&
                        high - low < 2 * PI);
            for (int i = 0; i <= 2000; i++) {
                fourlink_state state;

                assert_int_equal(
                    fourlink_position(&m, s.branch, low + i / 2000.0 * (high - low), &state),
                    FOURLINK_OK);
                least = fmin(least, state.mu);
            }
            assert_true(s.mu_min <= least + 1e-12);
            assert_true(s.mu_min >= least - 1e-3);
        }
    }
    for (int i = FOURLINK_CRANK_ROCKER; i <= FOURLINK_TRIPLE_ROCKER; i++)
        assert_true(n_types[i] > some_of(100));
    assert_true(n_types[FOURLINK_ENGINE] > some_of(50) &&
                n_types[FOURLINK_SLIDER_ROCKER] > some_of(100));
    assert_true(n_seen[0] > some_of(100) && n_seen[FOURLINK_DEFECT_CIRCUIT] > some_of(50) &&
                n_seen[FOURLINK_DEFECT_CIRCUIT | FOURLINK_DEFECT_BRANCH] > some_of(50) &&
                n_seen[FOURLINK_DEFECT_ORDER] > some_of(50) &&
                n_seen[FOURLINK_DEFECT_WAY | FOURLINK_DEFECT_BRANCH] > some_of(50));
    print_message("%d linkages\n", n_tried);
}

/* The sine at a joint that is not on the shortest link keeps its sign: the same circuits, for four-bar
** linkages. */
static int side_of_joint(const fourlink_state *s, fourlink_type type)
{
    const fourlink_vector *crank = &s->link[2].axis, *rocker = &s->link[4].axis;

    (void)rocker;
    switch (type) {
    case FOURLINK_CRANK_ROCKER: /* C, D; B, C of the double crank */
    case FOURLINK_DOUBLE_CRANK:
        return s->sine > 0;
    default: /* A, D or A, B */
        return crank->y > 0;
    }
}

TEST(sines_at_joints)
{
    uint64_t seed = 32;

    for (int k = 0; k < 4000; k++) {
        fourlink_mechanism m;
        fourlink_solution s;
        int sign[2] = {0, 0}, j;

        memset(&s, 0, sizeof s);
        s.design.kind = FOURLINK_FOUR_BAR;
        for (int i = 1; i <= 4; i++)
            s.design.link[i].length = uniform(&seed, 0.2, 2);
        s.a = s.design.link[2].length;
        s.c = s.design.link[4].length;
        assert_int_equal(fourlink_prepare(&s.design, &m), FOURLINK_OK);
        assert_int_equal(fourlink_type_of(&m, &s.type), FOURLINK_OK);
        if (s.type == FOURLINK_TRIPLE_ROCKER)
            continue;
        s.n_positions = 2;
        for (j = 0; j < 2; j++) {
            fourlink_branch branch = uniform(&seed, 0, 1) < 0.5 ? FOURLINK_OPEN : FOURLINK_CROSSED;
            fourlink_state at;

            s.position[j].theta2 = uniform(&seed, -PI, PI);
            if (fourlink_position(&m, branch, s.position[j].theta2, &at) != FOURLINK_OK)
                break;
            s.position[j].output = at.link[4].theta;
            sign[j] = side_of_joint(&at, s.type);
        }
        if (j < 2)
            continue;
        assert_int_equal(flk_check_solution(&s, FLK_EITHER_WAY), FOURLINK_OK);
        assert_int_equal((s.defects & FOURLINK_DEFECT_CIRCUIT) != 0, sign[0] != sign[1]);
    }
}

/* A dead position at a point, a range beyond the reach, a position that is missed. */
TEST(single_defects)
{
    fourlink_mechanism m;
    fourlink_reach reach;
    fourlink_solution s;
    fourlink_state at;

    memset(&s, 0, sizeof s);
    s.design.kind = FOURLINK_FOUR_BAR;
    s.design.link[1].length = 1;
    s.a = s.design.link[2].length = 0.9;
    s.design.link[3].length = 0.5;
    s.c = s.design.link[4].length = 0.8;
    assert_int_equal(fourlink_prepare(&s.design, &m), FOURLINK_OK);
    fourlink_reach_of(&m, &reach);
    s.n_positions = 3;
    for (int j = 0; j < 3; j++) {
        s.position[j].theta2 = reach.to[0] - 0.1 * j;
        if (j) {
            assert_int_equal(fourlink_position(&m, FOURLINK_OPEN, s.position[j].theta2, &at),
                             FOURLINK_OK);
            s.position[j].output = at.link[4].theta;
        }
    }
    assert_int_equal(flk_check_solution(&s, FLK_AS_GIVEN), FOURLINK_OK);
    assert_int_equal(s.defects & ~FOURLINK_DEFECT_REACH, FOURLINK_DEFECT_DEAD);
    assert_int_equal(s.position[0].status, FOURLINK_DEAD_POSITION);
    assert_near(s.mu_positions, 0, 0);
    s.from = s.to = 0;
    s.position[0] = s.position[1];
    s.position[0].theta2 = reach.to[0] + 0.1;
    assert_int_equal(flk_check_solution(&s, FLK_AS_GIVEN), FOURLINK_OK);
    assert_int_equal(s.defects, FOURLINK_DEFECT_REACH);
    assert_near(s.mu_min, 0, 0);
    s.position[0].theta2 = reach.to[0] - 0.05;
    s.from = s.to = 0;
    assert_int_equal(flk_check_solution(&s, FLK_AS_GIVEN), FOURLINK_OK);
    assert_int_equal(s.defects, FOURLINK_DEFECT_MISSED);
    s.from = s.position[0].theta2;
    s.to = reach.from[0] - 0.01;
    assert_int_equal(fourlink_position(&m, FOURLINK_OPEN, s.position[0].theta2, &at), FOURLINK_OK);
    s.position[0].output = at.link[4].theta;
    assert_int_equal(flk_check_solution(&s, FLK_AS_GIVEN), FOURLINK_OK);
    assert_int_equal(s.defects, FOURLINK_DEFECT_REACH);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
