/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_balance.c - counterweights: the shaking force of balanced machines in any motion, and what is
** left of it in an engine that is balanced in part.
*/
#include "samples.h"

/* The shaking force, and the largest of its parts. */
static double shaking(const sample *s, double *largest)
{
    const fourlink_forces *f = &s->forces;

    *largest = fmax(fmax(fabs(f->F12x), fabs(f->F12y)), fmax(fabs(f->F14x), fabs(f->F14y)));
    return hypot(f->F12x + f->F14x, f->F12y + f->F14y);
}

static void balance(sample *s)
{
    fourlink_link *link = s->design.link;
    fourlink_balance u;

    assert_int_equal(fourlink_prepare(&s->design, &s->mechanism), FOURLINK_OK);
    assert_int_equal(fourlink_balance_of(&s->mechanism, 0, &u), FOURLINK_OK);
    assert_int_equal(fourlink_add_counterweight(&link[2], &u.crank, 0.7, &link[2], NULL),
                     FOURLINK_OK);
    assert_int_equal(fourlink_add_counterweight(&link[4], &u.rocker, 0.9, &link[4], NULL),
                     FOURLINK_OK);
}

/* With inertia alone the pin forces add up to nothing, in any motion. */
TEST(test_balanced)
{
    uint64_t seed = 17;
    int n = 0, tried = 0, inverted = 0;

    while (n < 1000) {
        double largest, before, after;
        sample s;

        draw_any(&seed, tried++, &s);
        if (s.design.kind == FOURLINK_SLIDER_CRANK)
            continue;
        s.n_loads = 0;
        s.design.gravity.x = s.design.gravity.y = 0;
        if (move(&s) != FOURLINK_OK || fabs(s.state.sine) < 0.2)
            continue;
        before = shaking(&s, &largest);
        balance(&s);
        assert_int_equal(move(&s), FOURLINK_OK);
        after = shaking(&s, &largest);
        assert_true(after <= 1e-13 * largest / fabs(s.state.sine));
        assert_true(before >= after);
        inverted += s.design.kind == FOURLINK_INVERTED_SLIDER_CRANK;
        n++;
    }
    assert_true(inverted > 100);
    {
        sample s = rocker(75);
        double largest;

        s.design.gravity.y = 0;
        s.crank.alpha2 = 40;
        balance(&s);
        assert_int_equal(move(&s), FOURLINK_OK);
        assert_true(shaking(&s, &largest) < 1e-13 * largest);
    }
}

/* A rod so long that the piston moves in simple harmonic motion: m_rec r w^2 sqrt((1 - c)^2 cos^2 + c^2
** sin^2) is left. */
TEST(test_engine)
{
    double c, largest;
    int i;

    for (i = 0; i < 12; i++) {
        double t = 0.3 + i, r = 0.1, l = 1e5, m_rec = 4 + 0.4 * 3, w = 50, left;
        fourlink_balance u;
        sample s;

        c = i / 11.0;
        memset(&s, 0, sizeof s);
        s.design.kind = FOURLINK_SLIDER_CRANK;
        s.design.link[2].length = r;
        s.design.link[2].mass = 2;
        s.design.link[2].cg.x = 0.03;
        s.design.link[2].cg.y = 0.01;
        s.design.link[3].length = l;
        s.design.link[3].mass = 3;
        s.design.link[3].cg.x = 0.4 * l;
        s.design.link[4].mass = 4;
        s.branch = FOURLINK_OPEN;
        s.crank.theta2 = t;
        s.crank.omega2 = w;
        assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
        assert_int_equal(fourlink_balance_of(&s.mechanism, c, &u), FOURLINK_OK);
        assert_true(u.rocker.x == 0 && u.rocker.y == 0);
        assert_close(u.crank.x, -(2 * 0.03 + 3 * 0.6 * r + c * m_rec * r), 1e-14);
        assert_close(u.crank.y, -2 * 0.01, 1e-14);
        assert_int_equal(
            fourlink_add_counterweight(&s.design.link[2], &u.crank, 0.2, &s.design.link[2], NULL),
            FOURLINK_OK);
        assert_int_equal(move(&s), FOURLINK_OK);
        left = m_rec * r * w * w * hypot((1 - c) * cos(t), c * sin(t));
        assert_close(shaking(&s, &largest), left, 1e-5);
    }
}

TEST(test_counterweight)
{
    fourlink_link link = {1, 3, 0.5, {0.2, -0.1}}, sum;
    fourlink_vector u = {-0.6, 0.8};
    double mass;

    assert_int_equal(fourlink_add_counterweight(&link, &u, 0.5, &sum, &mass), FOURLINK_OK);
    assert_close(mass, 2.0, 1e-15); /* at (-0.3, 0.4) */
    assert_close(sum.mass, 5.0, 1e-15);
    assert_near(sum.cg.x, 0, 1e-15);
    assert_close(sum.cg.y, 0.1, 1e-14);
    /* about the origin: 0.5 + 3 0.05 + 2 0.25 */
    assert_close(sum.inertia + 5 * 0.01, 0.5 + 0.15 + 0.5, 1e-14);
    assert_true(sum.length == 1);
    u.x = u.y = 0;
    assert_int_equal(fourlink_add_counterweight(&link, &u, 0.5, &sum, NULL), FOURLINK_OK);
    assert_memory_equal(&sum, &link, sizeof sum);
    assert_int_equal(fourlink_add_counterweight(&link, &u, 0, &sum, NULL), FOURLINK_BAD_BALANCE);
    assert_int_equal(fourlink_add_counterweight(&link, &u, -1, &sum, NULL), FOURLINK_BAD_BALANCE);
    assert_int_equal(fourlink_add_counterweight(&link, &u, NAN, &sum, NULL), FOURLINK_BAD_NUMBER);
    u.x = 1; /* of a counterweight whose mass no double can hold */
    assert_int_equal(fourlink_add_counterweight(&link, &u, 1e-310, &sum, NULL),
                     FOURLINK_BAD_NUMBER);
    u.x = INFINITY;
    assert_int_equal(fourlink_add_counterweight(&link, &u, 1, &sum, NULL), FOURLINK_BAD_NUMBER);
    assert_int_equal(fourlink_add_counterweight(NULL, &u, 1, &sum, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_add_counterweight(&link, NULL, 1, &sum, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_add_counterweight(&link, &u, 1, NULL, NULL), FOURLINK_NULL);
}

TEST(test_bad)
{
    fourlink_balance u;
    sample s = rocker(0);

    assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
    assert_int_equal(fourlink_balance_of(NULL, 0, &u), FOURLINK_NULL);
    assert_int_equal(fourlink_balance_of(&s.mechanism, 0, NULL), FOURLINK_NULL);
    s.design.kind = FOURLINK_SLIDER_CRANK;
    assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
    assert_int_equal(fourlink_balance_of(&s.mechanism, NAN, &u), FOURLINK_BAD_NUMBER);
}

int main(void)
{
    return run_all_tests(NULL);
}
