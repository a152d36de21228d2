/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_coordinate.c - the crank by a coordinate that is prescribed, against the position of the crank from which it is.
*/
#include "samples.h"

#include "mechanics/coordinate.h"

static void draw(uint64_t *seed, int n, sample *s)
{
    draw_any(seed, n, s);
    if (n % 4 != 3)
        return;
    s->design.kind = FOURLINK_SCOTCH_YOKE;
    s->design.link[1].length = s->design.link[3].length = s->design.link[4].length = 0;
    s->design.offset = uniform(seed, -1, 1);
    s->design.angle = uniform(seed, -PI, PI);
}

/* The stretch in which a crank angle is, less whole turns; null if it is too near an end. */
static const flk_stretch *stretch_at(const flk_stretch *list, int n, double *theta2)
{
    int i, turn;

    for (i = 0; i < n; i++)
        for (turn = -3; turn <= 3; turn++) {
            double at = *theta2 + turn * 2 * PI;

            if (list[i].theta2_from + 0.02 < at && at < list[i].theta2_to - 0.02) {
                *theta2 = at;
                return &list[i];
            }
        }
    return NULL;
}

/* The value at a crank angle leads back to that angle, with the speed and acceleration of the crank. */
TEST(test_back)
{
    unsigned long tried[FLK_COORDINATES] = {0};
    uint64_t seed = 21;
    int n, i, k;

    for (n = 0; n < 2000; n++) {
        flk_stretch list[FLK_STRETCHES];
        sample s;

        draw(&seed, n, &s);
        s.n_loads = 0;
        s.crank.theta2 = uniform(&seed, 0, 2 * PI);
        s.crank.omega2 = uniform(&seed, 1, 5);
        if (fourlink_prepare(&s.design, &s.mechanism) != FOURLINK_OK || move(&s) != FOURLINK_OK)
            continue;
        for (i = 0; i < FLK_COORDINATES; i++) {
            const flk_coordinate *q = &flk_coordinates[i];
            const flk_stretch *stretch;
            flk_prescribed at;
            fourlink_crank found;
            double theta2 = s.crank.theta2;

            if (!(q->kinds & (int)s.design.kind))
                continue;
            k = flk_coordinate_stretches(q, &s.mechanism, s.branch, list);
            stretch = stretch_at(list, k, &theta2);
            flk_coordinate_of(q, &s.state, &at);
            if (!stretch ||
                fabs(at.rate) < 0.05 * s.crank.omega2 * (q->is_angle ? 1 : s.design.link[2].length))
                continue;
            assert_true((at.rate > 0) == (stretch->side > 0));
            at.value = flk_coordinate_in_turn(q, stretch, theta2, at.value);
            assert_int_equal(flk_coordinate_crank(q, &s.mechanism, s.branch, stretch, &at, &found),
                             FOURLINK_OK);
            assert_near(remainder(found.theta2 - theta2, 2 * PI), 0, 1e-9);
            assert_close(found.omega2, s.crank.omega2, 1e-9);
            assert_near(found.alpha2, s.crank.alpha2, 1e-6 * (1 + fabs(s.crank.alpha2)));
            tried[i]++;
        }
    }
    for (i = 0; i < FLK_COORDINATES; i++)
        assert_true(tried[i] > 200);
}

int main(void)
{
    return run_all_tests(NULL);
}
