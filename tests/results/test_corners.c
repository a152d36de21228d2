/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_corners.c - where columns of loads are not smooth, at angles that are known, and what the ends of
** pieces are.
*/
#include "check.h"
#include "motion/course.h"
#include "read.h"

#define CRANK                                                                                      \
    "mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 mm\n[piston]\nmass = " \
    "1 kg\n"

#define MOST 60

/* The pieces of the open branch's motion, of loads or of the links alone: their number. */
static size_t list_pieces(const char *contents, int has_loads, flk_piece list[MOST])
{
    flk_course course;
    flk_acting acting;
    flk_pieces pieces;
    flk_piece piece;
    size_t n = 0;
    deck d;

    read_deck(contents, &d);
    memset(&acting, 0, sizeof acting);
    acting.load = calloc(d.machine.n_loads + 1, sizeof *acting.load);
    assert_true(flk_course_open(&course, &d, &acting, NULL));
    pieces.course = &course;
    pieces.branch = FOURLINK_OPEN;
    pieces.has_loads = has_loads;
    course.type->begin(&course, &pieces);
    pieces.period = HUGE_VAL;
    memset(&piece, 0, sizeof piece);
    while (flk_pieces_next(&pieces, &piece)) {
        assert_true(piece.from < piece.to && n < MOST);
        list[n++] = piece;
    }
    flk_course_close(&course);
    free(acting.load);
    flk_deck_free(&d);
    return n;
}

/* The piece that ends at this crank angle, in degrees; null if there is none. */
static const flk_piece *find_end(const flk_piece *list, size_t n, double angle)
{
    for (; n > 0; n--, list++)
        if (fabs(list->to * 180 / M_PI - angle) < 1e-7)
            return list;
    return NULL;
}

/* 1 if a piece of the motion ends at this crank angle. */
static int has_end(const char *contents, int has_loads, double angle)
{
    flk_piece list[MOST];
    size_t n = list_pieces(contents, has_loads, list);

    return find_end(list, n, angle) != NULL;
}

static void check_end(const char *contents, double angle)
{
    assert_true(has_end(contents, 1, angle));
    assert_false(has_end(contents, 0, angle));
}

#define STEADY "[motion]\nspeed = %g rad/s\ninterval = 10 deg\n"

static const double rest = 0.19525624189766637; /* m, sqrt(l^2 - r^2 sin^2 60 deg) */

/* At 60 deg the piston has the speed r omega2 sin(theta2) (1 + r cos(theta2) / sqrt(l^2 - r^2
** sin^2(theta2))); at another speed of the crank it has that elsewhere. */
TEST(test_one_speed)
{
    double v = 0.5 * sqrt(0.75) * (1 + 0.025 / rest);
    char contents[1000];
    int speed;

    for (speed = 9; speed <= 10; speed++) {
        sprintf(contents,
                CRANK STEADY "[load]\nlink = piston\nover = v\n"
                             "force = %.17g m/s 3 N, 0 m/s 7 N, %.17g m/s 4 N, 0.7 m/s 1 N\n",
                (double)speed, -v, v);
        assert_int_equal(has_end(contents, 1, 60), speed == 10);
        assert_false(has_end(contents, 0, 60));
    }
}

/* At 180 deg the piston turns round, whatever the speed: also of a crank that is at rest at first. */
TEST(test_speed_that_is_zero)
{
    check_end(CRANK
              "[motion]\nspeed = 0 rad/s\nacceleration = 5 rad/s2\ninterval = 10 deg\n[load]\n"
              "link = piston\nforce = -10 N\nover = v\nat_speed = 1 m/s\nexponent = 2\n",
              180);
}

/* The free length of a rope that is taut beyond 60 deg; the edges of a range, for either sense. */
TEST(test_positions)
{
    char contents[1000];

    sprintf(contents,
            CRANK STEADY
            "[spring S]\nlink = piston\nto = ground\nto_at = (0, 0) mm\nstiffness = 100 N/m\n"
            "only = pulls\nfree_length = %.17g m\n",
            10.0, 0.025 + rest);
    check_end(contents, 60);
    sprintf(contents,
            CRANK STEADY "[load]\nlink = piston\nforce = 3 N\nfrom = 33 deg\nto = 77 deg\n", 10.0);
    check_end(contents, 33);
    check_end(contents, 77);
    sprintf(contents,
            CRANK STEADY "[load]\nlink = piston\nforce = 3 N\nfrom = 33 deg\nto = 77 deg\n", -10.0);
    check_end(contents, 360 - 77); /* rad passed, clockwise */
}

#define SAMPLES 2880 /* of two turns, or three */

/* By how much a variable of the open branch is beyond a level. */
typedef double variable(const deck *d, double theta2, double level);

/* theta4, in (-pi, pi]; NaN where there is no position. */
static double beyond(const deck *d, double theta2, double level)
{
    fourlink_state state;

    if (fourlink_position(&d->machine.mechanism, FOURLINK_OPEN, theta2, &state) != FOURLINK_OK)
        return NAN;
    return remainder(state.link[FOURLINK_FOLLOWER].theta - level, 2 * PI);
}

/* The angle of the first spring, which counts turns. */
static double wound(const deck *d, double theta2, double level)
{
    const flk_element *spring = flk_machine_find(&d->machine, &flk_spring_type, 0);
    const fourlink_mechanism *m = &d->machine.mechanism;
    fourlink_spring_state at;
    fourlink_state state;

    assert_int_equal(fourlink_position(m, FOURLINK_OPEN, theta2, &state), FOURLINK_OK);
    assert_int_equal(fourlink_spring_at(m, &state, spring->data, &at), FOURLINK_OK);
    return at.length - level;
}

/* Each place at which it passes a level, by bisection between samples of a motion that turns the crank by `way`, is the
** end of a piece.  Returns how many there are. */
static int check_passes(variable *f, const deck *d, double level, double from, int turn, double way,
                        const char *contents)
{
    int n_found = 0, j, k;
    flk_piece list[MOST];
    size_t n = list_pieces(contents, 1, list);

    for (k = 0; k + 1 < SAMPLES; k++) {
        double low = way * (k + 0.31) / SAMPLES, high = low + way / SAMPLES;
        double before = f(d, from + turn * low, level), behind = f(d, from + turn * high, level);

        if (!(before * behind < 0) || fabs(before - behind) > 1)
            continue;
        for (j = 0; j < 60; j++) {
            double middle = (low + high) / 2;

            if (before * f(d, from + turn * middle, level) > 0)
                low = middle;
            else
                high = middle;
        }
        n_found++;
        if (!find_end(list, n, low / DEG))
            fail_msg("no piece ends at %.12g deg\n%s", low / DEG, contents);
    }
    return n_found;
}

/* theta4 passes points of a curve, in either sense, over two turns, which differ where there is one change point. */
TEST(test_positions_by_samples)
{
    static const double levels[] = {100, 120, 155, 99.97, 120.03}; /* of two loads */
    static const char second[] =
        "[load L]\nlink = crank\nover = theta4\ntorque = 99.97 deg 1 N m, 120.03 deg 2 N m\n";
    uint64_t seed = 8;
    int number, turn, n_found = 0;
    size_t i, n_levels;

    for (number = 0; number < 60; number++) {
        double crank = 20 + 5 * (number % 3), coupler = uniform(&seed, 60, 90),
               ground = uniform(&seed, 70, 100), rocker;
        double from = uniform(&seed, -200, 200) * DEG;
        char contents[1000];
        deck d;

        /* crank + ground = coupler + rocker: a change point at 180 deg */
        rocker = number % 2 ? crank + ground - coupler
                            : uniform(&seed, crank + fabs(ground - coupler) + 1, 90);
        if (rocker < crank + 5)
            continue;
        turn = number % 4 < 2 ? 1 : -1;
        n_levels = number % 3 ? COUNT(levels) : 3;
        sprintf(contents,
                "mechanism = four-bar\n[ground]\nlength = %.17g mm\n[crank]\nlength = %.17g "
                "mm\n[coupler]\nlength = %.17g mm\n"
                "[rocker]\nlength = %.17g mm\n[load K]\nlink = rocker\nover = theta4\ntorque = 100 "
                "deg 3 N m, 120 deg 7 N m, 155 deg -4 N m\n%s[motion]\nspeed = %d rad/s\nfrom = "
                "%.17g deg\nto = "
                "%.17g deg\n",
                ground, crank, coupler, rocker, n_levels > 3 ? second : "", turn, from / DEG,
                from / DEG + turn * 719);
        read_deck(contents, &d);
        for (i = 0; i < n_levels; i++)
            n_found += check_passes(beyond, &d, levels[i] * DEG, from, turn, 719 * DEG, contents);
        flk_deck_free(&d);
    }
    assert_true(n_found > 200);
}

/* A parallelogram starts at its change point, or stops at it: there is no row, and beside it the rocker, as fast as the
** crank, passes a speed at which a load has a corner, at omega^2 / (2 alpha) from it. */
TEST(test_speeds_beside_a_change_point)
{
    uint64_t seed = 17;
    int i, starts, sense;

    for (i = 0; i < 400; i++) {
        double alpha = pow(10, uniform(&seed, -1, 3)), angle = pow(10, uniform(&seed, -4, -1.5));
        double level, way = uniform(&seed, 20, 170) * DEG;
        char contents[1000], motion[300];

        starts = i % 2;
        sense = i % 4 < 2 ? 1 : -1;
        level = sense * sqrt(2 * alpha * angle);
        if (starts)
            sprintf(motion, "acceleration = %.17g rad/s2\nto = %.17g deg\n", sense * alpha,
                    sense * way / DEG);
        else
            sprintf(motion,
                    "speed = %.17g rad/s\nacceleration = %.17g rad/s2\nfrom = %.17g deg\nto = 0 "
                    "deg\n",
                    sense * sqrt(2 * alpha * way), -sense * alpha, -sense * way / DEG);
        sprintf(contents,
                "mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 30 mm\n"
                "[coupler]\nlength = 80 mm\n[rocker]\nlength = 30 mm\n[load K]\nlink = "
                "rocker\nover = omega4\ntorque = %.17g rad/s -3 N m, %.17g rad/s 5 N m\n"
                "[motion]\n%s",
                sense > 0 ? level : 2 * level, sense > 0 ? 2 * level : level, motion);
        if (!has_end(contents, 1, (starts ? angle : way - angle) / DEG))
            fail_msg("case %d: no piece ends %g rad beside the change point\n%s", i, angle,
                     contents);
    }
}

/* A torsional rope or buffer that winds up by a turn in each of the lever's begins or ceases to act in one of three turns
** of the crank: there a piece ends, and the motion does not repeat. */
TEST(test_winding_by_samples)
{
    static const char *const links[] = {"crank", "lever", "slider"};
    uint64_t seed = 11;
    int number, n_found = 0;

    for (number = 0; number < 200; number++) {
        int turn = number % 2 ? 1 : -1;
        double from = uniform(&seed, -900, 900) * DEG;
        const fourlink_spring *spring;
        char contents[1000];
        flk_course course;
        flk_acting acting;
        deck d;

        sprintf(contents,
                "mechanism = inverted-slider-crank\n[ground]\nlength = %.17g mm\n[crank]\n"
                "length = 90 mm\n[lever]\noffset = %.17g mm\n[spring S]\nlink = %s\nto = "
                "ground\nonly = %s\nfree_angle = %.17g deg\ndamping = 1 N m s/rad\n[motion]\n"
                "speed = %d rad/s\nfrom = %.17g deg\nto = %.17g deg\n",
                uniform(&seed, 10, 40), uniform(&seed, -40, 40), links[number % 3],
                number % 4 < 2 ? "pulls" : "pushes", uniform(&seed, -400, 400), turn, from / DEG,
                from / DEG + turn * 1079);
        read_deck(contents, &d);
        spring = flk_machine_find(&d.machine, &flk_spring_type, 0)->data;
        n_found += check_passes(wound, &d, spring->free_length, from, turn, 1079 * DEG, contents);
        memset(&acting, 0, sizeof acting);
        assert_true(flk_course_open(&course, &d, &acting, NULL));
        assert_false(flk_course_repeats(&course));
        flk_course_close(&course);
        flk_deck_free(&d);
    }
    assert_true(n_found > 60);
}

/* A motion that begins at a change point, and not a little beside it. */
TEST(test_begin_at_a_change_point)
{
    static const char linkage[] =
        "mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\n[coupler]\n"
        "length = 66 mm\n[rocker]\nlength = 34 mm\n[motion]\n";
    static const struct {
        const char *motion;
        flk_piece_end begin;
    } cases[] = {{"speed = 9 rad/s\nfrom = 180 deg\nto = 400 deg\n", FLK_END_CHANGE},
                 {"speed = -9 rad/s\nfrom = 180 deg\nto = -400 deg\n", FLK_END_CHANGE},
                 {"speed = 9 rad/s\nfrom = -180 deg\nto = 400 deg\n", FLK_END_CHANGE},
                 {"speed = 9 rad/s\nfrom = 122.7 deg\nto = 400 deg\n", FLK_END_PLAIN},
                 {"speed = -9 rad/s\nfrom = 237.3 deg\nto = -400 deg\n", FLK_END_PLAIN}};
    flk_piece list[MOST];
    char contents[600];
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        sprintf(contents, "%s%s", linkage, cases[i].motion);
        assert_true(list_pieces(contents, 0, list) > 1);
        assert_int_equal(list[0].begin, cases[i].begin);
    }
}

/* This engine has a change point at -90 deg. */
TEST(test_kinds_of_ends)
{
    static const struct {
        const char *motion;
        double passed; /* deg, to an end */
        flk_piece_end begin, end;
    } cases[] = {
        {"speed = 9 rad/s\nfrom = 0 deg\nto = 330 deg\n", 270, FLK_END_PLAIN, FLK_END_CHANGE},
        {"speed = 9 rad/s\nfrom = -90 deg\nto = 50 deg\n", 140, FLK_END_CHANGE, FLK_END_PLAIN},
        {"speed = 0\nacceleration = 5 rad/s2\nfrom = -90 deg\nto = 50 deg\n", 140,
         FLK_END_CHANGE_REST, FLK_END_PLAIN},
        {"speed = 0\nacceleration = 5 rad/s2\nfrom = -80 deg\nto = 50 deg\n", 130, FLK_END_ROOT,
         FLK_END_PLAIN},
        {"speed = 5 rad/s\nacceleration = -5 rad/s2\nfrom = -80 deg\nto = 180 deg\n",
         2.5 * 180 / M_PI, FLK_END_PLAIN, FLK_END_ROOT},
        {"mode = free\nspeed = 2 rad/s\nfrom = -80 deg\nto = 180 deg\n[load]\nlink = crank\ntorque "
         "= -1 N m\n[flywheel]\ninertia = 1 kg m2\n",
         2 * 180 / M_PI, FLK_END_PLAIN, FLK_END_ROOT},
        {"mode = run-up\nfrom = -80 deg\nto = 50 deg\n[motor]\ntorque = 9 N m\n[flywheel]\ninertia "
         "= 1 kg m2\n",
         130, FLK_END_ROOT, FLK_END_PLAIN},
    };
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        const flk_piece *last;
        char contents[1000];
        flk_piece list[MOST];
        size_t n;

        sprintf(contents,
                "mechanism = slider-crank\n[crank]\nlength = 30 mm\n[rod]\nlength = 40 "
                "mm\n[ground]\noffset = 10 mm\n[motion]\n%s",
                cases[i].motion);
        n = list_pieces(contents, 0, list);
        last = find_end(list, n, cases[i].passed);
        assert_non_null(last);
        assert_int_equal(list[0].begin, cases[i].begin);
        assert_int_equal(last->end, cases[i].end);
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
