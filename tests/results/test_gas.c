/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_gas.c - the gas in an oscillating cylinder: the column gas_force against pressures and areas by hand,
** its torque against the power of a force along a line that grows and shrinks.
*/
#include "machines.h"

#define BAR 1e5

/* At these crank angles the card of the tests has a point, so that its value is exact. */
static const struct {
    int theta2;
    double bar;
} card[] = {{10, 1}, {30, 31}, {95, 8.5}, {180, 2}, {250, 0.5}, {315, 1.25}};

#define CARD "10 deg 1 bar, 30 31 bar, 95 8.5 bar, 180 2 bar, 250 0.5 bar, 315 1.25 bar"

/* A cylinder with its slide at the distance h from D: by an offset, or by an angle. */
typedef struct cylinder {
    double a, d, h;
    const char *slide;
} cylinder;

static const cylinder cylinders[] = {
    {0.05, 0.3, 0, ""},
    {0.05, 0.3, 0.02, "offset = 20 mm\n"},
    {0.05, 0.3, -0.02, "offset = -20 mm\n"},
    {0.05, 0.3, -0.04 * 0.5, "length = 40 mm\nangle = 30 deg\n"},
    {0.25, 0.1, 0.03 * 0.5, "length = 30 mm\nangle = -150 deg\n"}, /* turns fully */
};

#define LINKS_WITHOUT_MASS "[slider]\n"
#define LINKS                                               \
    "mass = 3 kg\ncg = (30, -5) mm\ninertia = 0.02 kg m2\n" \
    "[slider]\nmass = 1 kg\ncg = (-110, 4) mm\ninertia = 0.006 kg m2\n"

/* `links` goes on with the section of the lever. */
static char *deck_of(const cylinder *c, const char *links, const char *more)
{
    return print("mechanism = inverted-slider-crank\n[ground]\nlength = %.17g m\n[crank]\nlength = "
                 "%.17g m\n[motion]\nspeed = 12 rad/s\ninterval = 5 deg\n[lever]\n%s%s%s",
                 c->d, c->a, c->slide, links, more);
}

/* d BD'/d theta2 for D' the foot of the perpendicular from D to the slide: BD'^2 = BD^2 - h^2 and
** BD^2 = a^2 + d^2 - 2 a d cos(theta2).  Open: B is on the positive side of D'. */
static double growth(const cylinder *c, fourlink_branch branch, double theta2)
{
    double square = c->a * c->a + c->d * c->d - 2 * c->a * c->d * cos(theta2) - c->h * c->h;

    return (double)branch * c->a * c->d * sin(theta2) / sqrt(square);
}

/* A force that turns with its link. */
static void turn_force(const fourlink_instant *at, const fourlink_load *load, fourlink_vector *F)
{
    const fourlink_vector *axis = &at->state.link[load->link].axis;

    assert_int_equal(load->frame, FOURLINK_FRAME_LINK);
    F->x = load->force.x * axis->x - load->force.y * axis->y;
    F->y = load->force.x * axis->y + load->force.y * axis->x;
}

/* The force is pressure times area; what the gas does on the way of the rod, the crank takes up.  A deck with
** masses has that torque in addition to the torque without gas. */
static void check_card(const cylinder *c, const char *links, const char *gas, double area,
                       double back_bar, double back_area)
{
    fourlink_results *with = opened(deck_of(c, links, gas));
    fourlink_results *without = strstr(links, "mass") ? opened(deck_of(c, links, "")) : NULL;
    size_t i;
    int k;

    for (i = 0; i < COUNT(card); i++)
        for (k = 0; k < 2; k++) {
            double at = card[i].theta2, F = (card[i].bar * area - back_bar * back_area) * BAR;
            double way = growth(c, branches[k], at * PI / 180), scale = fabs(F) * c->a;
            double Ts = si_value(with, "Ts", branches[k], at);
            fourlink_instant instant;
            fourlink_load load[2];
            fourlink_vector f[2];
            int j;

            if (without)
                Ts -= si_value(without, "Ts", branches[k], at);
            assert_close(si_value(with, "gas_force", branches[k], at), F, 1e-14);
            assert_near(si_value(with, "slide_v", branches[k], at), 12 * way, 1e-14);
            assert_near(Ts, -F * way, 1e-12 * (scale + 10));
            assert_true(si_value(with, "residual", branches[k], at) < 1e-12);
            assert_int_equal(fourlink_results_at(with, branches[k], at, NULL, &instant, load),
                             FOURLINK_OK);
            assert_close(instant.gas_force, F, 1e-14);
            /* the gas pushes on both, in opposite directions */
            for (j = 0; j < 2; j++)
                turn_force(&instant, &load[j], &f[j]);
            assert_near(f[0].x + f[1].x, 0, 1e-13 * fabs(F));
            assert_near(f[0].y + f[1].y, 0, 1e-13 * fabs(F));
            assert_close(hypot(f[0].x, f[0].y), fabs(F), 1e-13);
        }
    fourlink_results_free(with);
    fourlink_results_free(without);
}

TEST(test_force_and_power)
{
    const double area = PI / 4 * 0.08 * 0.08, rod = PI / 4 * 0.03 * 0.03;
    static const char *const links[] = {LINKS_WITHOUT_MASS, LINKS};
    size_t i, k;

    for (i = 0; i < COUNT(cylinders); i++)
        for (k = 0; k < COUNT(links); k++) {
            check_card(&cylinders[i], links[k], "[gas]\nbore = 80 mm\nindicator = " CARD "\n", area,
                       0, 0);
            check_card(&cylinders[i], links[k],
                       "[gas]\nbore = 80 mm\npiston_rod = 30 mm\nback_pressure = 3 bar\n"
                       "indicator = " CARD "\n",
                       area, 3, area - rod);
        }
}

/* In one turn the crank takes up the area of the card over the way: the mean torque against the trapezoidal
** rule on the column and the way above. */
TEST(test_work_of_a_turn)
{
    const cylinder *c = &cylinders[1];
    static fact_list list;
    double work = 0;
    int i, n = 7200;

    facts_of(deck_of(c, LINKS, "[gas]\nbore = 80 mm\nindicator = " CARD "\n"), &list);
    for (i = 0; i < n; i++) {
        double at = 360. * i / n;

        work += si_value(list.results, "gas_force", FOURLINK_OPEN, at) *
                growth(c, FOURLINK_OPEN, at * PI / 180) * 2 * PI / n;
    }
    check_fact(&list, "mean_torque", FOURLINK_OPEN, work / (2 * PI), 1e-6 * fabs(work));
    assert_true(fabs(work) > 100);
}

/* The largest force is at the highest point of the card. */
TEST(test_extremes)
{
    fourlink_results *r = opened(
        deck_of(&cylinders[0], LINKS_WITHOUT_MASS, "[gas]\nbore = 80 mm\nindicator = " CARD "\n"));
    fourlink_value v;

    assert_int_equal(fourlink_results_value(r, "max(gas_force)", FOURLINK_CROSSED, 0, &v),
                     FOURLINK_OK);
    assert_close(v.value, 31 * BAR * PI / 4 * 0.0064, 1e-12);
    assert_near(v.angle, 30, 1e-6);
    assert_int_equal(fourlink_results_value(r, "min(gas_force)", FOURLINK_OPEN, 0, &v),
                     FOURLINK_OK);
    assert_close(v.value, 0.5 * BAR * PI / 4 * 0.0064, 1e-12);
    assert_near(v.angle, 250, 1e-6);
    fourlink_results_free(r);
}

/* A lever without gas has no such column; an engine has it whatever its rod. */
TEST(test_who_has_it)
{
    fourlink_source source =
        deck_source(deck_of(&cylinders[0], LINKS, "[table]\ncolumns = gas_force\n"));
    fourlink_results *r = opened(deck_of(&cylinders[0], LINKS, ""));
    fourlink_mistake mistake;
    fourlink_value v;

    assert_int_equal(fourlink_results_value(r, "gas_force", FOURLINK_OPEN, 30, &v),
                     FOURLINK_NO_SUCH_NAME);
    fourlink_results_free(r);
    assert_int_equal(fourlink_results_open(&source, 1, &r, &mistake, NULL), FOURLINK_BAD_DECK);
    assert_string_equal(mistake.message, "the column 'gas_force' needs gas; the deck has none");
    r = opened(
        "mechanism = slider-crank\n[crank]\nlength = 0.1 m\n[rod]\nlength = 0.3 m\nmass = 1 kg\n"
        "cg = (100, 20) mm\n[gas]\nbore = 80 mm\npressure = 2 bar\n[motion]\nspeed = 1 rad/s\n");
    assert_close(si_value(r, "gas_force", FOURLINK_OPEN, 30), 2 * BAR * PI / 4 * 0.0064, 1e-14);
    assert_int_equal(fourlink_results_value(r, "piston_effort", FOURLINK_OPEN, 30, &v),
                     FOURLINK_NO_SUCH_NAME);
    fourlink_results_free(r);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
