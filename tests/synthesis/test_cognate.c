/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_cognate.c - cognates trace the curve; cognates of cognates are the linkages that theory says.
*/
#include "designs.h"

static fourlink_cognate_task random_task(uint64_t *seed, fourlink_side side)
{
    fourlink_cognate_task task = {.side = side};
    fourlink_mechanism m;
    fourlink_reach reach;

    task.design.kind = FOURLINK_FOUR_BAR;
    for (int i = 1; i <= 4; i++)
        task.design.link[i].length = uniform(seed, 0.2, 2);
    task.branch = uniform(seed, 0, 1) < 0.5 ? FOURLINK_OPEN : FOURLINK_CROSSED;
    task.point.x = uniform(seed, -2, 3);
    task.point.y = uniform(seed, -2, 2);
    assert_int_equal(fourlink_prepare(&task.design, &m), FOURLINK_OK);
    fourlink_reach_of(&m, &reach);
    if (!reach.n_ranges)
        return random_task(seed, side);
    task.from = reach.from[0] + uniform(seed, 0.1, 0.8) * (reach.to[0] - reach.from[0]);
    task.to = task.from + uniform(seed, 0.02, 0.15) * (reach.to[0] - reach.from[0]);
    return task;
}

/* Where the coupler point of a solution is in the designer's axes. */
static double complex traced(const fourlink_solution *s, fourlink_branch branch, double theta2)
{
    fourlink_mechanism m;
    fourlink_state state;
    fourlink_vector at;

    assert_int_equal(fourlink_prepare(&s->design, &m), FOURLINK_OK);
    assert_int_equal(fourlink_position(&m, branch, theta2, &state), FOURLINK_OK);
    assert_int_equal(fourlink_point(&state, FOURLINK_COUPLER, &s->point, &at, NULL, NULL),
                     FOURLINK_OK);
    return s->origin.x + I * s->origin.y + (at.x + I * at.y) * cexp(I * s->direction);
}

static fourlink_cognate_task task_of(const fourlink_solution *s, fourlink_side side)
{
    fourlink_cognate_task task = {.side = side};

    task.design = s->design;
    task.branch = s->branch;
    task.point = s->point;
    task.from = s->from;
    task.to = s->to;
    return task;
}

/* Pivots of a cognate of a cognate, in the axes of the first. */
static void ends_of(const fourlink_solution *first, const fourlink_solution *s,
                    double complex end[2])
{
    double complex turn = first ? cexp(I * first->direction) : 1;
    double complex by = first ? first->origin.x + I * first->origin.y : 0;

    end[0] = by + turn * (s->origin.x + I * s->origin.y);
    end[1] = end[0] + turn * cexp(I * s->direction) * length_of(s, 1);
}

TEST(curves)
{
    uint64_t seed = 51;

    for (int k = 0; k < some_of(2000); k++) {
        fourlink_side side = k % 2 ? FOURLINK_LEFT : FOURLINK_RIGHT;
        fourlink_cognate_task task = random_task(&seed, side);
        fourlink_mechanism m;
        fourlink_solution s;

        assert_int_equal(fourlink_prepare(&task.design, &m), FOURLINK_OK);
        FOUND(cognate, &task, &s);
        assert_true(is_sound(&s));
        assert_false(s.defects & FOURLINK_DEFECT_MISSED);
        for (int j = 0; j < 3; j++) {
            double theta2 = task.from + (2 * j + 1) * (task.to - task.from) / 6;
            fourlink_state state;
            fourlink_vector at;

            assert_int_equal(fourlink_position(&m, task.branch, theta2, &state), FOURLINK_OK);
            if (!s.position[j].branch)
                continue;
            if (side == FOURLINK_RIGHT)
                assert_true(s.position[j].branch == -(int)task.branch || fabs(state.sine) < 1e-6);
            fourlink_point(&state, FOURLINK_COUPLER, &task.point, &at, NULL, NULL);
            assert_near(
                cabs(traced(&s, (fourlink_branch)s.position[j].branch, s.position[j].theta2) -
                     at.x - I * at.y),
                0, 1e-10 / s.mu_positions);
            assert_true(miss_of(&s, j, 5) < 20);
        }
    }
}

/* Without a range, it is a turn, or the middle two thirds of where the crank can be. */
TEST(ranges_of_their_own)
{
    uint64_t seed = 52;
    int n_parts = 0;

    for (int k = 0; k < 200; k++) {
        fourlink_cognate_task task = random_task(&seed, k % 2 ? FOURLINK_LEFT : FOURLINK_RIGHT),
                              part = task;
        fourlink_solution s, same;
        fourlink_mechanism m;
        fourlink_reach reach;
        double length;

        assert_int_equal(fourlink_prepare(&task.design, &m), FOURLINK_OK);
        fourlink_reach_of(&m, &reach);
        length = reach.to[0] - reach.from[0];
        part.from = part.to = 0;
        task.from = reach.from[0] + (length < 2 * PI ? length / 6 : 0);
        task.to = task.from + (length < 2 * PI ? length * 2 / 3 : length);
        n_parts += length < 2 * PI;
        FOUND(cognate, &task, &s);
        FOUND(cognate, &part, &same);
        for (int j = 0; j < 3; j++) {
            assert_near(remainder(same.position[j].theta2 - s.position[j].theta2, 2 * PI), 0, 1e-9);
            assert_near(same.position[j].point.x, s.position[j].point.x, 1e-9);
            assert_near(same.position[j].point.y, s.position[j].point.y, 1e-9);
        }
    }
    assert_true(n_parts > 20);
}

static void assert_same(const fourlink_solution *s, const fourlink_cognate_task *task)
{
    for (int i = 1; i <= 4; i++)
        assert_close(length_of(s, i), task->design.link[i].length, 1e-12);
    assert_near(s->point.x, task->point.x, 1e-12 * (1 + size_of(s)));
    assert_near(s->point.y, task->point.y, 1e-12 * (1 + size_of(s)));
}

/* Left twice, right twice: the linkage itself, at its place.  Left of right has the pivots of left,
** exchanged. */
TEST(cognates_of_cognates)
{
    uint64_t seed = 52;
    int n = 0;

    while (n < 500) {
        fourlink_cognate_task task = random_task(&seed, FOURLINK_LEFT), next;
        fourlink_solution left, right, again;
        double complex end[2], other[2];
        double d = task.design.link[1].length;

        FOUND(cognate, &task, &left);
        task.side = FOURLINK_RIGHT;
        FOUND(cognate, &task, &right);
        if (left.defects || right.defects)
            continue;
        n++;
        next = task_of(&left, FOURLINK_LEFT);
        FOUND(cognate, &next, &again);
        assert_same(&again, &task);
        ends_of(&left, &again, end);
        assert_near(cabs(end[0]) + cabs(end[1] - d), 0, 1e-12 * (1 + d));
        next = task_of(&right, FOURLINK_RIGHT);
        FOUND(cognate, &next, &again);
        assert_same(&again, &task);
        ends_of(&right, &again, end);
        assert_near(cabs(end[0]) + cabs(end[1] - d), 0, 1e-12 * (1 + length_of(&right, 1)));
        next = task_of(&right, FOURLINK_LEFT);
        FOUND(cognate, &next, &again);
        ends_of(&right, &again, end);
        ends_of(NULL, &left, other);
        assert_near(cabs(end[0] - other[1]) + cabs(end[1] - other[0]), 0,
                    1e-12 * (1 + size_of(&right)));
        assert_close(length_of(&again, 2), length_of(&left, 4), 1e-11);
        assert_close(length_of(&again, 4), length_of(&left, 2), 1e-11);
    }
}

/* The left one of a crank-rocker is a double rocker whose label changes on the way. */
TEST(left_of_a_crank_rocker)
{
    fourlink_cognate_task task = {.side = FOURLINK_LEFT, .branch = FOURLINK_OPEN};
    fourlink_solution s;
    double length[] = {0, 4, 1, 3.5, 3};

    task.design.kind = FOURLINK_FOUR_BAR;
    for (int i = 1; i <= 4; i++)
        task.design.link[i].length = length[i];
    task.point.x = 1;
    task.point.y = 1;
    FOUND(cognate, &task, &s);
    assert_int_equal(s.type, FOURLINK_DOUBLE_ROCKER);
    assert_true(s.defects & FOURLINK_DEFECT_WAY);
    assert_false(s.defects & FOURLINK_DEFECT_CIRCUIT);
    task.side = FOURLINK_RIGHT;
    FOUND(cognate, &task, &s);
    assert_int_equal(s.type, FOURLINK_CRANK_ROCKER);
    assert_int_equal(s.defects, 0);
    assert_int_equal(s.branch, FOURLINK_CROSSED);
    assert_near(s.to - s.from, 2 * PI, 1e-15);
}

TEST(refused)
{
    uint64_t seed = 53;
    fourlink_cognate_task task = random_task(&seed, FOURLINK_LEFT), good = task;

    task.point.x = task.point.y = 0;
    REFUSED(cognate, &task, FOURLINK_NO_LENGTH);
    task.point.x = task.design.link[3].length;
    REFUSED(cognate, &task, FOURLINK_NO_LENGTH);
    task = good;
    task.side = (fourlink_side)3;
    REFUSED(cognate, &task, FOURLINK_BAD_CHOICE);
    task = good;
    task.branch = (fourlink_branch)0;
    REFUSED(cognate, &task, FOURLINK_BAD_BRANCH);
    task = good;
    task.design.kind = FOURLINK_SLIDER_CRANK;
    REFUSED(cognate, &task, FOURLINK_BAD_KIND);
    task = good;
    task.design.link[2].length = 0;
    REFUSED(cognate, &task, FOURLINK_BAD_LENGTH);
    task.design.link[2].length = 100; /* too long to be closed */
    task.from = task.to = 0;
    REFUSED(cognate, &task, FOURLINK_NOT_REACHED);
    REFUSED(cognate, NULL, FOURLINK_NULL);
}

TEST(bad_problems)
{
    uint64_t seed = 54;

    for (int k = 0; k < some_of(10000); k++) {
        fourlink_cognate_task task = random_task(&seed, k % 2 ? FOURLINK_LEFT : FOURLINK_RIGHT);
        double *number[] = {&task.point.x,
                            &task.point.y,
                            &task.from,
                            &task.to,
                            &task.design.link[1].length,
                            &task.design.link[2].length,
                            &task.design.link[3].length,
                            &task.design.link[4].length};
        fourlink_solution s;
        unsigned long n;
        int status;

        for (unsigned i = 0; i < COUNT(number); i++)
            if (uniform(&seed, 0, 1) < 0.2)
                *number[i] = odd_number(&seed);
        status = fourlink_synthesis_cognate(&task, 1, &s, &n);
        assert_true(status == FOURLINK_OK ? is_sound(&s) : status > 0);
    }
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
