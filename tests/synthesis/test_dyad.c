/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_dyad.c - motion and path generators: reference values, identities of dyads, random problems, bad ones.
*/
#include "designs.h"

static fourlink_vector at(double complex z)
{
    fourlink_vector v = {creal(z), cimag(z)};

    return v;
}

static double complex plane(fourlink_vector v)
{
    return v.x + I * v.y;
}

static fourlink_dyad dyad(fourlink_choice choice, double complex pivot)
{
    fourlink_dyad d = {choice, at(pivot), {0, 0}};

    return d;
}

static fourlink_dyad turned(double beta2, double beta3)
{
    fourlink_dyad d = {FOURLINK_ROTATIONS, {0, 0}, {beta2, beta3}};

    return d;
}

static fourlink_motion_task reference(void)
{
    fourlink_motion_task task = {.point = {{0, 0}, {1.2, 0.5}, {2.1, 1.6}},
                                 .angle = {0, 18 * DEG, 47 * DEG}};

    task.left = dyad(FOURLINK_FIXED_PIVOT, 0.5 + 3.5 * I);
    task.right = dyad(FOURLINK_FIXED_PIVOT, 0.5 - I);
    return task;
}

TEST(three_positions)
{
    static const double theta2[] = {46.447285, 93.542892, 158.485568};
    fourlink_motion_task task = reference();
    fourlink_solution s;

    FOUND(motion, &task, &s);
    assert_near(length_of(&s, 2), 0.979862065600528, 1e-13);
    assert_near(length_of(&s, 3), 2.03919165213592, 1e-13);
    assert_near(length_of(&s, 4), 4.09711548493373, 1e-13);
    assert_near(length_of(&s, 1), 4.5, 1e-14);
    assert_int_equal(s.branch, FOURLINK_CROSSED);
    for (int i = 0; i < 3; i++)
        assert_near(remainder(s.position[i].theta2 / DEG - theta2[i], 360), 0, 5e-7);
    assert_int_equal(s.defects, 0);
    assert_near(s.origin.x, 0.5, 1e-15);
    assert_near(s.origin.y, 3.5, 1e-15);
    assert_near(s.direction, -PI / 2, 1e-15);
}

/* The pivots of a solution in the designer's axes, in the first position. */
static void pivots_of(const fourlink_solution *s, double complex m[2], double complex k[2])
{
    double complex turn = cexp(I * s->direction), P = plane(s->position[0].point);
    double complex e3 = cexp(I * s->position[0].theta3), B = P - plane(s->point) * e3;

    m[0] = plane(s->origin);
    m[1] = m[0] + length_of(s, 1) * turn;
    k[0] = m[0] + B * turn;
    k[1] = m[0] + (B + length_of(s, 3) * e3) * turn;
}

static fourlink_motion_task random_task(uint64_t *seed, int choice)
{
    fourlink_motion_task task = {0};

    for (int i = 0; i < 3; i++) {
        task.point[i] = at(uniform(seed, -2, 2) + I * uniform(seed, -2, 2));
        task.angle[i] = uniform(seed, -PI, PI);
    }
    for (int i = 0; i < 2; i++) {
        fourlink_dyad *d = i ? &task.right : &task.left;
        int which = choice ? choice : 1 + (int)uniform(seed, 0, 3);

        *d = dyad((fourlink_choice)which, uniform(seed, -3, 3) + I * uniform(seed, -3, 3));
        d->rotation[0] = uniform(seed, -PI, PI);
        d->rotation[1] = uniform(seed, -PI, PI);
    }
    return task;
}

/* The condition of two rows of length 1 is sqrt((1 + |g|) / (1 - |g|)), g their inner product: the squares of their singular
** values are 1 + |g| and 1 - |g|. */
static double condition_of_dyad(const fourlink_motion_task *task, const fourlink_dyad *d)
{
    double complex turn[3], z[3], w[2], y[2];
    double g = 0;

    for (int j = 0; j < 3; j++) {
        turn[j] = cexp(I * (task->angle[j] - task->angle[0]));
        z[j] = d->choice == FOURLINK_FIXED_PIVOT
                   ? (plane(d->pivot) - plane(task->point[j])) / turn[j]
                   : plane(task->point[j]) + turn[j] * (plane(d->pivot) - plane(task->point[0]));
    }
    if (d->choice == FOURLINK_ROTATIONS) {
        for (int j = 0; j < 2; j++) {
            w[j] = cexp(I * d->rotation[j]) - 1;
            y[j] = turn[j + 1] - 1;
        }
        g = cabs(w[0] * conj(w[1]) + y[0] * conj(y[1])) / hypot(cabs(w[0]), cabs(y[0])) /
            hypot(cabs(w[1]), cabs(y[1]));
    } else {
        g = fabs(creal((z[1] - z[0]) * conj(z[2] - z[0]))) / cabs(z[1] - z[0]) / cabs(z[2] - z[0]);
    }
    return sqrt((1 + g) / (1 - g));
}

TEST(conditions)
{
    static const fourlink_choice choices[] = {FOURLINK_ROTATIONS, FOURLINK_FIXED_PIVOT,
                                              FOURLINK_MOVING_PIVOT};
    uint64_t seed = 25;

    for (int k = 0; k < 300; k++) {
        fourlink_motion_task task = random_task(&seed, (int)choices[k % 3]);
        double left = condition_of_dyad(&task, &task.left),
               right = condition_of_dyad(&task, &task.right);
        fourlink_solution s;

        FOUND(motion, &task, &s);
        assert_close(s.condition, fmax(left, right), 1e-9 * s.condition);
    }
}

/* All positions are met, on the branch that a drawing shows. */
TEST(random_motions)
{
    uint64_t seed = 21;
    int n_clean = 0;

    for (int k = 0; k < some_of(2000); k++) {
        fourlink_motion_task task = random_task(&seed, 0);
        fourlink_solution s;
        double complex m[2], k1[2];

        FOUND(motion, &task, &s);
        assert_true(is_sound(&s));
        n_clean += !s.defects;
        pivots_of(&s, m, k1);
        for (int j = 0; j < 3; j++) {
            double complex turn = cexp(I * (task.angle[j] - task.angle[0]));
            double complex B = plane(task.point[j]) + turn * (k1[0] - plane(task.point[0]));
            double complex C = plane(task.point[j]) + turn * (k1[1] - plane(task.point[0]));
            double side = cimag(conj(m[1] - B) * (C - B)),
                   size = size_of(&s) + cabs(m[0]) + cabs(m[1]);

            assert_near(cabs(B - m[0]), length_of(&s, 2), 1e-12 * size * s.condition);
            assert_near(cabs(C - m[1]), length_of(&s, 4), 1e-12 * size * s.condition);
            if (!s.position[j].branch || s.ratio > 1e3)
                continue;
            assert_int_equal(s.position[j].branch, side > 0 ? FOURLINK_OPEN : FOURLINK_CROSSED);
            assert_true(miss_of(&s, j, size) < 1);
        }
        if (s.ratio < 1e3 && s.mu_positions > 1e-3)
            assert_false(s.defects & FOURLINK_DEFECT_MISSED);
    }
    print_message("%d of 2000 without a defect\n", n_clean);
}

/* How far rounding moves a pivot, over rounding itself.  It is the centre of a circle through three places
** of the other one, seen from the ground or from the coupler: besides the condition, which is that of the
** directions of the chords, the error is larger by size / shortest chord. */
static double amplified(const fourlink_solution *s)
{
    double shortest = size_of(s);

    for (int j = 0; j < 3; j++) {
        const fourlink_precision *p = &s->position[j], *q = &s->position[(j + 1) % 3];
        double turned = q->theta3 - p->theta3;
        double beta[] = {q->theta2 - p->theta2, q->output - p->output};

        for (int i = 0; i < 2; i++) {
            double least = fmin(fabs(sin(beta[i] / 2)), fabs(sin((beta[i] - turned) / 2)));

            shortest = fmin(shortest, 2 * length_of(s, i ? 4 : 2) * least);
        }
    }
    return s->condition * (1 + size_of(s)) / shortest;
}

/* A slider on a line in a given direction: the positions are met, and the moving pivot stays on the line. */
TEST(sliders)
{
    uint64_t seed = 26;

    for (int k = 0; k < some_of(2000); k++) {
        fourlink_motion_task task = random_task(&seed, 0);
        double complex turn, line, A, on_line[3];
        fourlink_solution s;

        task.right.choice = FOURLINK_SLIDER;
        FOUND(motion, &task, &s);
        assert_true(is_sound(&s));
        assert_int_equal(s.design.kind, FOURLINK_SLIDER_CRANK);
        turn = cexp(I * s.direction);
        line = cexp(I * task.right.rotation[0]);
        A = plane(s.origin);
        assert_near(fabs(creal(turn / line)), 1, 1e-12);
        assert_true(s.position[0].branch != FOURLINK_CROSSED);
        for (int j = 0; j < 3; j++) {
            const fourlink_precision *p = &s.position[j];

            assert_near(cabs(A + turn * plane(p->point) - plane(task.point[j])), 0,
                        1e-12 * (1 + cabs(A)) * s.condition);
            on_line[j] =
                plane(p->point) + (length_of(&s, 3) - plane(s.point)) * cexp(I * p->theta3);
            assert_near(cimag(on_line[j]), s.design.offset, 1e-12 * size_of(&s) * s.condition);
            if (p->branch && s.ratio < 1e3)
                assert_true(miss_of(&s, j, size_of(&s) + cabs(A)) < 1);
        }
    }
}

/* Positions without a rotation: all points of the coupler move as P does, so that a moving pivot is a
** slider. */
TEST(moving_pivot_on_a_line)
{
    fourlink_motion_task task = {.point = {{0, 0}, {3, 1}, {6, 2}}};
    fourlink_solution s;

    task.left = dyad(FOURLINK_MOVING_PIVOT, 1 + 2 * I);
    task.right = dyad(FOURLINK_MOVING_PIVOT, 4 + I);
    REFUSED(motion, &task, FOURLINK_INFINITE_LINK); /* the left one too */
    task.angle[1] = 0.3; /* the right pivot has P_j: its places are still on a line */
    task.angle[2] = 0.5;
    task.right = dyad(FOURLINK_MOVING_PIVOT, 0);
    FOUND(motion, &task, &s);
    assert_int_equal(s.design.kind, FOURLINK_SLIDER_CRANK);
    assert_near(remainder(s.direction - atan2(1, 3), PI), 0, 1e-12);
    for (int j = 0; j < 3; j++)
        assert_true(miss_of(&s, j, 10) < 1);
}

/* Fixed pivots, then the moving pivots that they gave, then the fixed ones: the same linkage.  The
** rotations that it has, given as such: the same. */
TEST(fixed_and_moving)
{
    uint64_t seed = 22;

    for (int k = 0; k < some_of(1000); k++) {
        fourlink_motion_task task = random_task(&seed, FOURLINK_FIXED_PIVOT), other = task;
        fourlink_solution s, again;
        double complex m[2], k1[2], m2[2], k2[2];
        double tolerance;

        FOUND(motion, &task, &s);
        pivots_of(&s, m, k1);
        other.left = dyad(FOURLINK_MOVING_PIVOT, k1[0]);
        other.right = dyad(FOURLINK_MOVING_PIVOT, k1[1]);
        FOUND(motion, &other, &again);
        pivots_of(&again, m2, k2);
        tolerance = 1e-14 * (1 + size_of(&s)) * amplified(&s) * again.condition;
        for (int i = 0; i < 2; i++) {
            assert_near(cabs(m2[i] - m[i]), 0, tolerance);
            assert_near(cabs(k2[i] - k1[i]), 0, tolerance);
        }
        other.left = turned(s.position[1].theta2 - s.position[0].theta2,
                            s.position[2].theta2 - s.position[0].theta2);
        other.right = turned(s.position[1].output - s.position[0].output,
                             s.position[2].output - s.position[0].output);
        FOUND(motion, &other, &again);
        pivots_of(&again, m2, k2);
        tolerance = 1e-14 * (1 + size_of(&s)) * amplified(&s) * again.condition;
        for (int i = 0; i < 2; i++) {
            assert_near(cabs(m2[i] - m[i]), 0, tolerance);
            assert_near(cabs(k2[i] - k1[i]), 0, tolerance);
        }
    }
}

/* A problem that is turned, moved and scaled has the linkage scaled, at its place. */
TEST(moved_problems)
{
    uint64_t seed = 23;

    for (int k = 0; k < some_of(500); k++) {
        fourlink_motion_task task = random_task(&seed, 0), other = task;
        double turn = uniform(&seed, -PI, PI), scale = uniform(&seed, 0.1, 10);
        double complex by = uniform(&seed, -5, 5) + I * uniform(&seed, -5, 5),
                       z = scale * cexp(I * turn);
        fourlink_solution s, moved;
        double tolerance;

        for (int j = 0; j < 3; j++) {
            other.point[j] = at(z * plane(task.point[j]) + by);
            other.angle[j] += turn;
        }
        other.left.pivot = at(z * plane(task.left.pivot) + by);
        other.right.pivot = at(z * plane(task.right.pivot) + by);
        FOUND(motion, &task, &s);
        FOUND(motion, &other, &moved);
        tolerance =
            1e-11 * s.condition * (size_of(&moved) + cabs(by) + scale * cabs(plane(s.origin)));
        for (int i = 1; i <= 4; i++)
            assert_near(length_of(&moved, i), scale * length_of(&s, i), tolerance);
        assert_near(cabs(plane(moved.origin) - z * plane(s.origin) - by), 0, tolerance);
        assert_near(remainder(moved.direction - s.direction - turn, 2 * PI), 0,
                    tolerance / scale / length_of(&s, 1));
        if (s.mu_positions > 1e-3 && s.ratio < 1000)
            assert_int_equal(moved.defects, s.defects);
    }
}

/* The pole of two positions: the coupler turns about it. */
static double complex pole(const fourlink_motion_task *task, int i, int j)
{
    double complex r = cexp(I * (task->angle[j] - task->angle[i]));

    return (plane(task->point[j]) - r * plane(task->point[i])) / (1 - r);
}

TEST(degenerate_positions)
{
    fourlink_motion_task task = reference(), good = task;
    double complex k2;

    for (int i = 0; i < 3; i++) { /* a pivot at a pole: the other one may be anywhere on a line */
        task.left = dyad(FOURLINK_FIXED_PIVOT, pole(&task, i, (i + 1) % 3));
        REFUSED(motion, &task, FOURLINK_DEPENDENT);
    }
    task.left = dyad(FOURLINK_MOVING_PIVOT, pole(&task, 0, 1));
    REFUSED(motion, &task, FOURLINK_DEPENDENT);
    task.left = turned(18 * DEG, 47 * DEG); /* the link turns with the coupler */
    REFUSED(motion, &task, FOURLINK_DEPENDENT);
    task = good;
    task.right = task.left;
    REFUSED(motion, &task, FOURLINK_NO_LENGTH);
    task = good;
    task.point[1] = task.point[0];
    task.angle[1] = task.angle[0] + 2 * PI;
    REFUSED(motion, &task, FOURLINK_DEPENDENT);
    task = good; /* the places of the moving pivot on a line */
    k2 = 1.2 + 0.5 * I;
    task.angle[1] = task.angle[2] = 0;
    task.point[2] = at(2 * k2);
    task.left = dyad(FOURLINK_MOVING_PIVOT, 1 + I);
    REFUSED(motion, &task, FOURLINK_INFINITE_LINK);
    task.left.choice = FOURLINK_SLIDER;
    REFUSED(motion, &task,
            FOURLINK_DEPENDENT); /* without a rotation all points move along a line */
    task = good;
    task.left.choice = FOURLINK_SLIDER;
    REFUSED(motion, &task, FOURLINK_INFINITE_LINK);
    task = good;
    task.left.choice = (fourlink_choice)5;
    REFUSED(motion, &task, FOURLINK_BAD_CHOICE);
    task = good;
    task.point[2].x = NAN;
    REFUSED(motion, &task, FOURLINK_BAD_NUMBER);
    task = good;
    task.angle[1] = INFINITY;
    REFUSED(motion, &task, FOURLINK_BAD_NUMBER);
    task = good;
    task.left.pivot.y = NAN;
    REFUSED(motion, &task, FOURLINK_BAD_NUMBER);
    task = good;
    task.right.rotation[1] = -INFINITY;
    REFUSED(motion, &task, FOURLINK_BAD_NUMBER);
    REFUSED(motion, NULL, FOURLINK_NULL);
}

/* With m at the pole P12 any moving pivot on a line is as far from m in all positions: no length is 0. */
TEST(dyads_at_a_pole)
{
    fourlink_motion_task task = reference();
    double complex m = pole(&task, 0, 1), g[3], k, u;

    for (int j = 0; j < 3; j++)
        g[j] = cexp(-I * task.angle[j]) * (plane(task.point[j]) - m);
    u = g[2] - g[0];
    for (int i = -2; i <= 2; i++) {
        k = -0.5 * (g[0] + g[2]) + (double)i * I * u; /* relative to P_1: |g_1 + k| = |g_3 + k| */
        assert_near(cabs(g[1] + k), cabs(g[0] + k), 1e-14);
        assert_near(cabs(g[2] + k), cabs(g[0] + k), 1e-14);
        assert_true(cabs(g[0] + k) > 0.1);
    }
}

static fourlink_path_task random_path(uint64_t *seed)
{
    fourlink_path_task task = {0};

    for (int i = 0; i < 3; i++)
        task.point[i] = at(uniform(seed, -2, 2) + I * uniform(seed, -2, 2));
    task.timing[0] = uniform(seed, 0.2, 1.5);
    task.timing[1] = task.timing[0] + uniform(seed, 0.2, 1.5);
    task.rotation[0] = uniform(seed, -PI, PI);
    task.rotation[1] = uniform(seed, -PI, PI);
    task.right = dyad(FOURLINK_FIXED_PIVOT, uniform(seed, -3, 3) + I * uniform(seed, -3, 3));
    return task;
}

TEST(random_paths)
{
    uint64_t seed = 24;

    for (int k = 0; k < some_of(1500); k++) {
        fourlink_path_task task = random_path(&seed);
        fourlink_solution s;

        FOUND(path, &task, &s);
        assert_true(is_sound(&s));
        for (int j = 0; j < 3; j++) {
            double complex P = plane(s.origin) + plane(s.position[j].point) * cexp(I * s.direction);
            double size = size_of(&s) + cabs(plane(s.origin));

            assert_near(cabs(P - plane(task.point[j])), 0, 1e-13 * size * s.condition);
            assert_near(s.position[j].theta2 - s.position[0].theta2, j ? task.timing[j - 1] : 0,
                        1e-14);
            if (s.position[j].branch && s.ratio < 1e3)
                assert_true(miss_of(&s, j, size) < 1);
        }
    }
}

/* A search gives linkages without defects, the best first; those of a finer grid are not worse. */
TEST(searches)
{
    uint64_t seed = 25;
    int n_found = 0;

    for (int k = 0; k < some_of(12); k++) {
        fourlink_path_task task = random_path(&seed);
        fourlink_solution s[5], fine;
        unsigned long n, n_fine;
        int status;

        task.search = 1;
        task.step = 10 * DEG;
        status = fourlink_synthesis_path(&task, 5, s, &n);
        if (status != FOURLINK_OK) {
            assert_int_equal(status, FOURLINK_NONE_FOUND);
            continue;
        }
        n_found++;
        assert_true(n > 0);
        for (unsigned long i = 0; i < n && i < 5; i++) {
            int turns = s[i].type == FOURLINK_CRANK_ROCKER || s[i].type == FOURLINK_DOUBLE_CRANK;
            int turned_before = i == 0 || s[i - 1].type == FOURLINK_CRANK_ROCKER ||
                                s[i - 1].type == FOURLINK_DOUBLE_CRANK;

            assert_int_equal(s[i].defects, 0);
            assert_true(turned_before >= turns);
            if (i > 0 && turned_before == turns)
                assert_true(s[i - 1].mu_min >= s[i].mu_min);
            for (int j = 0; j < 3; j++)
                assert_true(miss_of(&s[i], j, 10) < 1);
        }
        task.step = 5 * DEG;
        assert_int_equal(fourlink_synthesis_path(&task, 1, &fine, &n_fine), FOURLINK_OK);
        assert_true(fine.mu_min >= s[0].mu_min - 1e-12 || fine.type != s[0].type);
    }
    assert_true(n_found > some_of(3));
    print_message("%d of %d searches found linkages\n", n_found, some_of(12));
}

TEST(bad_problems)
{
    uint64_t seed = 26;

    for (int k = 0; k < some_of(10000); k++) {
        fourlink_motion_task task = random_task(&seed, 0);
        fourlink_path_task path = random_path(&seed);
        fourlink_solution s;
        double *number[] = {&task.point[0].x,        &task.point[1].y,
                            &task.point[2].x,        &task.angle[0],
                            &task.angle[1],          &task.angle[2],
                            &task.left.pivot.x,      &task.left.pivot.y,
                            &task.left.rotation[0],  &task.left.rotation[1],
                            &task.right.pivot.x,     &task.right.pivot.y,
                            &task.right.rotation[0], &path.point[0].x,
                            &path.point[1].y,        &path.point[2].x,
                            &path.timing[0],         &path.timing[1],
                            &path.rotation[0],       &path.rotation[1],
                            &path.right.pivot.x,     &path.step};
        unsigned long n;
        int status;

        for (unsigned i = 0; i < COUNT(number); i++)
            if (uniform(&seed, 0, 1) < 0.3)
                *number[i] = odd_number(&seed);
        if (k % 4 == 0)
            task.point[1] = task.point[0];
        if (k % 6 == 0)
            task.right = task.left;
        status = fourlink_synthesis_motion(&task, 1, &s, &n);
        assert_true(status == FOURLINK_OK ? is_sound(&s) : status >= 20);
        path.search = k % 1000 == 0;
        status = fourlink_synthesis_path(&path, 1, &s, &n);
        assert_true(status == FOURLINK_OK ? is_sound(&s) : status >= 20);
    }
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
