/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_corners.c - where columns of loads are not smooth, at angles that are known, and what the ends of
** pieces are.
*/
#include "check.h"
#include "motion/crank_motion.h"
#include "read.h"

#define CRANK                                                                                      \
    "mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 mm\n[piston]\nmass = " \
    "1 kg\n"

#define MOST 20

/* The pieces of the open branch's motion, of loads or of the links alone: their number. */
static size_t list_pieces(const char *contents, int has_loads, flk_piece list[MOST])
{
    flk_crank_motion crank_motion;
    flk_acting acting;
    flk_pieces pieces;
    flk_piece piece;
    size_t n = 0;
    deck d;

    read_deck(contents, &d);
    memset(&acting, 0, sizeof acting);
    acting.load = calloc(d.machine.n_loads + 1, sizeof *acting.load);
    assert_true(flk_crank_motion_open(&crank_motion, &d, &acting, NULL));
    pieces.crank_motion = &crank_motion;
    pieces.branch = FOURLINK_OPEN;
    pieces.has_loads = has_loads;
    pieces.length = flk_crank_motion_length(&crank_motion, FOURLINK_OPEN);
    pieces.period = HUGE_VAL;
    memset(&piece, 0, sizeof piece);
    while (flk_pieces_next(&pieces, &piece)) {
        assert_true(piece.from < piece.to && n < MOST);
        list[n++] = piece;
    }
    flk_crank_motion_close(&crank_motion);
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
