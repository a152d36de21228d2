/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_geometry.c - ways of pistons and sliders have room for all positions; lines cut to boxes; round numbers.
*/
#include "check.h"
#include "random_parts.h"
#include "view/geometry.h"

static view shown;
static fourlink_results *results;

static fourlink_vector minus(fourlink_vector p, fourlink_vector q)
{
    return place_beside(p, -q.x, -q.y);
}

static double dot(fourlink_vector p, fourlink_vector q)
{
    return p.x * q.x + p.y * q.y;
}

static double cross(fourlink_vector p, fourlink_vector q)
{
    return p.x * q.y - p.y * q.x;
}

/* ---------------------------------------------------------------------------------------------- ways */

#define SAMPLES 720
#define SAMPLED 2e-5 /* (pi / SAMPLES)^2 */

/* Lengths of any proportion, change points among them; links have no mass. */
static void write_lengths(int number)
{
    length = 0;
    machine = A_SLIDER_CRANK + number % 3;
    is_wild = 1;
    has_bodies = 0;
    write_machine();
    write("[motion]\nspeed = 1 rad/s\n");
}

/* From one end of a way to the other there are all the places, and no more if the crank turns fully. */
static void check_way(const char *what, double near, double far, double low, double high,
                      double size, int is_full)
{
    if (!(fmin(near, far) <= low + 1e-9 * size) || !(fmax(near, far) >= high - 1e-9 * size) ||
        (is_full &&
         (fmin(near, far) < low - SAMPLED * size || fmax(near, far) > high + SAMPLED * size)))
        fail_msg("%s from %.9g to %.9g, places from %.9g to %.9g\n%s", what, near, far, low, high,
                 deck_text);
}

static void check_ways(fourlink_branch branch)
{
    double x_low = HUGE_VAL, x_high = -HUGE_VAL, s_low = HUGE_VAL, s_high = -HUGE_VAL, near, far,
           size;
    fourlink_vector B, C;
    fourlink_state at;
    int k, n = 0;

    size = shown.design->link[2].length + shown.design->link[3].length +
           shown.design->link[1].length + fabs(shown.design->offset);
    for (k = 0; k < SAMPLES; k++) {
        if (fourlink_position(shown.mechanism, branch, 2 * PI * k / SAMPLES, &at) != FOURLINK_OK)
            continue;
        n++;
        B = at.link[3].origin;
        C = at.link[4].origin;
        if (shown.kind.guided) {
            assert_near(C.y, shown.design->offset, 1e-12 * size);
            x_low = fmin(x_low, C.x);
            x_high = fmax(x_high, C.x);
        }
        if (shown.kind.slotted) {
            fourlink_vector u = at.link[3].axis, foot = place_in(B, u, -at.s, 0);

            /* s is from the foot of the perpendicular from D, or from C */
            assert_near(place_distance(foot, geometry_on_slide(&at, 0)), 0, 1e-12 * size);
            assert_near(dot(minus(B, C), u), at.s, 1e-12 * size);
            s_low = fmin(s_low, at.s);
            s_high = fmax(s_high, at.s);
        }
    }
    if (n && shown.kind.guided) {
        geometry_find_guide(&shown, branch, &near, &far);
        check_way("guide", near, far, x_low, x_high,
                  size / fabs(shown.kind.slotted ? shown.mechanism->slot.y : 1), n == SAMPLES);
    }
    if (n && shown.kind.slotted) {
        geometry_find_way(&shown, branch, &near, &far);
        check_way("slide", near, far, s_low, s_high,
                  size / fabs(shown.kind.guided ? shown.mechanism->slot.y : 1), n == SAMPLES);
    }
}

TEST(ways_of_pistons_and_sliders)
{
    fourlink_mistake mistake;
    fourlink_source source;
    int number, i;

    for (number = 0; number < some_of(3000); number++) {
        begin_chance(68, number);
        write_lengths(number);
        memset(&source, 0, sizeof source);
        source.text = deck_text;
        source.length = length;
        if (fourlink_results_open(&source, 1, &results, &mistake, NULL) != FOURLINK_OK)
            continue; /* it cannot be assembled */
        view_take(&shown, results);
        for (i = 0; i < shown.n_branches; i++)
            check_ways(shown.branches[i]);
        fourlink_results_free(results);
    }
}

/* --------------------------------------------------------------------------------------------- boxes */

static fourlink_vector any_place(void)
{
    return place_at(between(-3, 3), between(-3, 3));
}

static int is_in(const place_box *b, fourlink_vector p, double margin)
{
    return p.x > b->x_min - margin && p.x < b->x_max + margin && p.y > b->y_min - margin &&
           p.y < b->y_max + margin;
}

TEST(lines_cut_to_boxes)
{
    int number, k, inside, n_inside = 0;

    for (number = 0; number < 2000; number++) {
        place_box b = place_nothing;
        fourlink_vector p, q, from, to, at;

        begin_chance(69, number);
        assert_true(place_is_empty(&b));
        for (k = 0; k < 3; k++) {
            at = any_place();
            place_grow(&b, at.x, at.y);
            assert_true(is_in(&b, at, 1e-12) && !place_is_empty(&b));
        }
        p = from = any_place();
        q = to = any_place();
        if (seldom(0.1))
            q.x = to.x = p.x;
        if (seldom(0.1))
            q.y = to.y = p.y;
        for (k = inside = 0; k <= 1000; k++)
            inside +=
                is_in(&b, place_at(p.x + (q.x - p.x) * k / 1000, p.y + (q.y - p.y) * k / 1000), 0);
        if (inside > 1)
            assert_true(place_crosses(&b, p, q));
        if (!place_clip(&b, &from, &to)) {
            assert_true(inside <= 1);
            assert_true(from.x == p.x && from.y == p.y && to.x == q.x && to.y == q.y);
            assert_false(place_crosses(&b, p, q));
            continue;
        }
        n_inside++;
        /* what is left is in the box, on the line, as long as what was inside, and begins where it did */
        assert_true(place_crosses(&b, p, q));
        assert_true(is_in(&b, from, 1e-9) && is_in(&b, to, 1e-9));
        assert_near(cross(minus(from, p), minus(q, p)), 0, 1e-9);
        assert_near(cross(minus(to, p), minus(q, p)), 0, 1e-9);
        assert_near(place_distance(from, to), place_distance(p, q) * inside / 1001,
                    3e-3 * place_distance(p, q));
        assert_true(dot(minus(to, from), minus(q, p)) >= 0);
    }
    assert_true(n_inside > 500 && n_inside < 1500);
}

TEST(boxes_that_overlap)
{
    int number;

    for (number = 0; number < 2000; number++) {
        place_box x = place_nothing, y = place_nothing;
        fourlink_vector at[4];
        int k;

        begin_chance(70, number);
        for (k = 0; k < 4; k++) {
            at[k] = any_place();
            place_grow(k < 2 ? &x : &y, at[k].x, at[k].y);
        }
        /* middles are nearer than half of both sides */
        assert_int_equal(place_overlap(&x, &y),
                         fabs(at[0].x + at[1].x - at[2].x - at[3].x) <
                                 fabs(at[0].x - at[1].x) + fabs(at[2].x - at[3].x) &&
                             fabs(at[0].y + at[1].y - at[2].y - at[3].y) <
                                 fabs(at[0].y - at[1].y) + fabs(at[2].y - at[3].y));
    }
}

TEST(round_numbers)
{
    static const double round_ones[] = {1, 2, 5, 10};
    int number, k;

    for (number = 0; number < 2000; number++) {
        double x, power, expected = 0;

        begin_chance(71, number);
        power = pow(10, between_whole(-9, 10));
        x = between(1, 10) * power;
        if (seldom(0.2)) {
            x = round_ones[one_of(4)] * power;
            assert_close(place_round(x), x, 1e-12);
            continue;
        }
        for (k = 3; k >= 0; k--)
            expected = round_ones[k] * power >= x ? round_ones[k] * power : expected;
        assert_close(place_round(x), expected, 1e-12);
    }
}

/* --------------------------------------------------------------------------------------------- turned */

static int same(fourlink_vector p, fourlink_vector q)
{
    return fabs(p.x - q.x) <= 1e-12 && fabs(p.y - q.y) <= 1e-12;
}

static fourlink_vector towards(double angle)
{
    return place_at(cos(angle), sin(angle));
}

/* Gravity points down in a drawing, unless it is on a page; without it nothing is turned.  On the page a direction turns as
** places do. */
TEST(drawings_that_are_turned)
{
    fourlink_design design = {0};
    view v = {0};
    int i;

    chance_state = 4;
    v.design = &design;
    for (i = 0; i < 1000; i++) {
        double down = between(-PI, PI), angle = between(-PI, PI), size = power_of_ten(-6, 6);
        fourlink_vector g = towards(down);

        v.problem.axes_on_page = 0;
        design.gravity = place_at(size * g.x, i % 9 ? size * g.y : 0);
        down = i % 9 ? down : g.x > 0 ? 0 : PI;
        assert_true(same(towards(down + geometry_turn(&v)), place_at(0, -1)));
        assert_true(view_direction(&v, angle) == angle);
        assert_true(same(view_place(&v, g), g));
        v.problem.axes_on_page = 1;
        v.problem.x_angle = between(-PI, PI);
        v.problem.A = place_at(between(-1, 1), between(-1, 1));
        assert_true(geometry_turn(&v) == v.problem.x_angle);
        g = minus(view_place(&v, towards(angle)), view_place(&v, place_at(0, 0)));
        assert_true(same(towards(view_direction(&v, angle)), g));
        assert_true(fabs(view_direction(&v, angle)) <= PI + 1e-12);
    }
    v.problem.axes_on_page = 0;
    design.gravity = place_at(0, 0);
    assert_true(geometry_turn(&v) == 0);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
