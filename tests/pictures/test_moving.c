/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_moving.c - the moving drawing of random machines with outputs, of all types: their pins, rods, rockers, sliders and slots
** are at each step where the columns of the table have them.
**
** The drawing has its places from the state.  Here Q of a slider is so far along its line as the column NAME.x says, that of
** a rocker at the angle NAME.theta; P, and the pin of a rocker on a link, are tracer points, added to the deck, with their columns; and Q is
** at the end of the rod at the angle NAME.rod_theta too.
*/
#include "check.h"
#include "random_outputs.h"
#include "pictures/moving.h"
#include "system/memory.h"
#include "view/geometry.h"

#define EVERY 7   /* steps */
#define NEAR 1e-5 /* pixels */
#define BLUNT \
    0.15 /* sine of a slot of a link to the line of its slider: nearer to it the slider is far away */

static moving drawn;
static moving_panel panel;
static view shown;
static fourlink_instant now;
static fourlink_vector first[3]; /* by output: where its block was at the first step, in its slot */
static int has_first[3];
static fourlink_results *results;
static double worst;          /* pixels */
static long compared, tried;  /* places and lines; outputs at a step */
static long of_type[2][3];    /* of these, by what an output is and how it hangs */
static unsigned long at_step; /* that is looked at */

/* ------------------------------------------------------------------------------------------- columns */

/* A column at the step, in SI units. */
static double column(int link, const char *name)
{
    char whole[100];
    fourlink_value v;

    snprintf(whole, sizeof whole, "%s.%s", fourlink_deck_link_text(drawn.p.v.deck, link), name);
    if (fourlink_results_value(results, whole, drawn.branch, drawn.steps.at[at_step], &v) !=
        FOURLINK_OK)
        fail_msg("%s at %g\n%s", whole, drawn.steps.at[at_step], deck_text);
    return v.value * v.to_si;
}

/* A tracer point of the deck. */
static fourlink_vector traced(char sort, int output)
{
    double place[2];
    char name[20];
    fourlink_value v;
    int k;

    for (k = 0; k < 2; k++) {
        snprintf(name, sizeof name, "at%c%d.%c", sort, output, "xy"[k]);
        if (fourlink_results_value(results, name, drawn.branch, drawn.steps.at[at_step], &v) !=
            FOURLINK_OK)
            fail_msg("%s at %g\n%s", name, drawn.steps.at[at_step], deck_text);
        place[k] = v.value * v.to_si;
    }
    return place_at(place[0], place[1]);
}

/* ------------------------------------------------------------------------------------------- drawing */

/* The pixel of a place. */
static fourlink_vector pixel(fourlink_vector at)
{
    const place_box *box = &panel.box, *axes = &panel.axes;
    const fourlink_unit *of_length = &drawn.p.v.units[QUANTITY_LENGTH];
    double turn = geometry_turn(&drawn.p.v), scale = of_length->down / of_length->up;
    double x = (cos(turn) * at.x - sin(turn) * at.y) * scale;
    double y = (sin(turn) * at.x + cos(turn) * at.y) * scale;

    return place_at(
        box->x_min + (x - axes->x_min) / (axes->x_max - axes->x_min) * (box->x_max - box->x_min),
        box->y_max - (y - axes->y_min) / (axes->y_max - axes->y_min) * (box->y_max - box->y_min));
}

/* Place k of an item at the step. */
static fourlink_vector place_of(const motion_item *x, size_t k)
{
    return panel.list.tracks[(x->first + k) * panel.list.n_steps + at_step];
}

static int is_there(size_t item, display_sort sort)
{
    return panel.list.items[item].like.sort == sort &&
           panel.list.items[item].like.part == DISPLAY_DRAWING &&
           motion_has(&panel.list, item, at_step);
}

static void note(double distance, const char *what, int output)
{
    if (!(distance < NEAR))
        fail_msg("%s of output %d: %g pixels from it at %g, %s\n%s", what, output, distance,
                 drawn.steps.at[at_step], fourlink_branch_text((int)drawn.branch), deck_text);
    worst = fmax(worst, distance);
    compared++;
}

static void has_disc(fourlink_vector at, const char *what, int output)
{
    double least = INFINITY;
    size_t i;

    at = pixel(at);
    for (i = 0; i < panel.list.n_items; i++)
        if (is_there(i, DISPLAY_DISC))
            least = fmin(least, place_distance(place_of(&panel.list.items[i], 0), at));
    note(least, what, output);
}

static void has_line(fourlink_vector from, fourlink_vector to, const char *what, int output)
{
    double least = INFINITY;
    size_t i;

    from = pixel(from);
    to = pixel(to);
    for (i = 0; i < panel.list.n_items; i++)
        if (is_there(i, DISPLAY_LINE)) {
            fourlink_vector p = place_of(&panel.list.items[i], 0),
                            q = place_of(&panel.list.items[i], 1);

            least = fmin(least, fmin(fmax(place_distance(p, from), place_distance(q, to)),
                                     fmax(place_distance(q, from), place_distance(p, to))));
        }
    note(least, what, output);
}

/* The distance of a place from a line, to its left; NaN if the line is not along the unit vector u, or begins or ends before
** the place. */
static double beside(const motion_item *x, fourlink_vector at, fourlink_vector u)
{
    fourlink_vector p = place_of(x, 0), q = place_of(x, 1);
    double from = u.x * (p.x - at.x) + u.y * (p.y - at.y);
    double to = u.x * (q.x - at.x) + u.y * (q.y - at.y);
    double left = u.x * (p.y - at.y) - u.y * (p.x - at.x);
    double other = u.x * (q.y - at.y) - u.y * (q.x - at.x);

    return fabs(left - other) < 1e-6 && from * to < 0 ? left : NAN;
}

/* Two lines along a direction, with the place in the middle between them: a slot, or a block if the place is also in the middle
** of their length. */
static void has_two_lines(fourlink_vector place, fourlink_vector direction, int is_block,
                          const char *what, int output)
{
    fourlink_vector at = pixel(place), next = pixel(place_beside(place, direction.x, direction.y));
    fourlink_vector u;
    double least = INFINITY, far = place_distance(at, next);
    size_t i, k;

    u = place_at((next.x - at.x) / far, (next.y - at.y) / far);
    for (i = 0; i < panel.list.n_items; i++) {
        const motion_item *x = &panel.list.items[i];
        double left = is_there(i, DISPLAY_LINE) ? beside(x, at, u) : NAN;

        if (!(left > 1e-3))
            continue;
        for (k = 0; k < panel.list.n_items; k++) {
            const motion_item *y = &panel.list.items[k];
            double right = is_there(k, DISPLAY_LINE) ? beside(y, at, u) : NAN, off;
            fourlink_vector middle;

            if (!(right < -1e-3))
                continue;
            off = fabs(left + right);
            middle = place_middle(place_middle(place_of(x, 0), place_of(x, 1)),
                                  place_middle(place_of(y, 0), place_of(y, 1)));
            if (is_block)
                off = fmax(off, place_distance(middle, at));
            least = fmin(least, off);
        }
    }
    note(least, what, output);
}

/* ------------------------------------------------------------------------------------------- outputs */

static fourlink_vector at_angle(fourlink_vector from, double length_of, double theta)
{
    return place_at(from.x + length_of * cos(theta), from.y + length_of * sin(theta));
}

/* The block of a slot is in it, and so it would be where it was at the first step: the slot has one length, and stays where it is
** on its link.  `from` is a point of the link, `axis` the direction of the slot. */
static void compare_slot(int i, fourlink_vector from, fourlink_vector axis, fourlink_vector block)
{
    double x = block.x - from.x, y = block.y - from.y;

    has_two_lines(block, axis, 0, "slot", i);
    if (!has_first[i])
        first[i] = place_at(axis.x * x + axis.y * y, axis.x * y - axis.y * x);
    has_first[i] = 1;
    has_two_lines(place_in(from, axis, first[i].x, first[i].y), axis, 0, "slot at the first step",
                  i);
}

/* The direction of a slot in the carrying link. */
static fourlink_vector slot_of_link(const fourlink_group *g)
{
    return place_in(place_at(0, 0), now.state.link[g->link].axis, g->slot.x, g->slot.y);
}

static void compare_slider(int i, const fourlink_group *g)
{
    double x = column(6 + 2 * i, "x");
    fourlink_vector Q = place_at(g->pivot.x + x * g->direction.x, g->pivot.y + x * g->direction.y);
    fourlink_vector P = traced('P', i), way = place_at(Q.x - P.x, Q.y - P.y), v;
    double far = hypot(way.x, way.y);

    if (g->hang == FOURLINK_HANGS_IN_SLOT &&
        fabs(way.x * g->direction.y - way.y * g->direction.x) < BLUNT * far)
        return;
    tried++;
    of_type[0][g->hang]++;
    has_two_lines(Q, g->direction, 1, "slider", i);
    if (g->hang == FOURLINK_HANGS_BY_ROD) {
        has_line(P, Q, "rod", i);
        has_line(P, at_angle(P, g->rod, column(6 + 2 * i, "rod_theta")), "rod at its angle", i);
    }
    if (g->hang == FOURLINK_HANGS_IN_SLOT)
        compare_slot(i, P, slot_of_link(g), Q);
    if (g->hang == FOURLINK_HANGS_BY_OWN_SLOT) {
        v = place_in(place_at(0, 0), g->direction, g->slot.x, g->slot.y);
        compare_slot(i, Q, v, P);
    }
    if (g->hang != FOURLINK_HANGS_IN_SLOT)
        has_disc(P, "P", i);
    if (g->hang != FOURLINK_HANGS_BY_OWN_SLOT)
        has_disc(Q, "Q", i);
}

static void compare_rocker(int i, const fourlink_group *g)
{
    fourlink_vector D = g->to > FOURLINK_GROUND ? traced('D', i) : g->pivot, P = traced('P', i);
    double theta = column(6 + 2 * i, "theta");
    fourlink_vector Q = at_angle(D, g->length, theta);

    tried++;
    of_type[1][g->hang]++;
    has_disc(D, "D", i);
    if (g->hang == FOURLINK_HANGS_BY_OWN_SLOT) {
        compare_slot(i, D, place_at(cos(theta), sin(theta)), P);
        has_disc(P, "P", i);
        return;
    }
    has_line(D, Q, "rocker", i);
    has_disc(Q, "Q", i);
    if (g->hang == FOURLINK_HANGS_IN_SLOT) {
        compare_slot(i, P, slot_of_link(g), Q);
        return;
    }
    has_disc(P, "P", i);
    has_line(P, Q, "rod", i);
    has_line(P, at_angle(P, g->rod, column(6 + 2 * i, "rod_theta")), "rod at its angle", i);
}

/* ------------------------------------------------------------------------------------------- machines */

static fourlink_results *opened(void)
{
    fourlink_source source;
    fourlink_mistake mistake;
    fourlink_results *r = NULL;

    memset(&source, 0, sizeof source);
    source.text = deck_text;
    source.length = length;
    return fourlink_results_open(&source, 1, &r, &mistake, NULL) == FOURLINK_OK ? r : NULL;
}

/* The deck with P, and pins on links, as tracer points; 0 if the deck has mistakes. */
static int open_traced(long number)
{
    const fourlink_group *g;
    fourlink_problem problem;
    int i;

    make_machine_with_outputs(number, (int)(number % 2));
    results = opened();
    if (!results)
        return 0;
    fourlink_deck_problem(fourlink_results_deck(results), &problem);
    g = problem.mechanism.design.group;
    for (i = 0; i < problem.mechanism.design.n_groups; i++) {
        write("[point atP%d]\nlink = %s\nat = (%.17g, %.17g) m\n", i,
              fourlink_deck_link_text(fourlink_results_deck(results), g[i].link), g[i].at.x,
              g[i].at.y);
        if (g[i].to > FOURLINK_GROUND)
            write("[point atD%d]\nlink = %s\nat = (%.17g, %.17g) m\n", i,
                  fourlink_deck_link_text(fourlink_results_deck(results), g[i].to), g[i].pivot.x,
                  g[i].pivot.y);
    }
    fourlink_results_free(results);
    results = opened();
    if (!results)
        fail_msg("with points:\n%s", deck_text);
    return 1;
}

#define STEPS 37

static void compare_branch(const fourlink_source *source, fourlink_branch branch)
{
    double at[STEPS];
    moving_steps steps;
    unsigned long k;
    int i;

    memset(has_first, 0, sizeof has_first);
    for (k = 0; k < STEPS; k++)
        at[k] = 10. * (double)k;
    steps.at = at;
    steps.n = STEPS;
    assert_true(moving_open(&drawn, source, results, branch, &steps));
    if (moving_draw(&drawn, 0, &panel))
        for (at_step = 0; at_step < STEPS; at_step += EVERY) {
            fourlink_results_along(results, branch, at[at_step], NULL, &now, NULL);
            if (now.status != FOURLINK_OK)
                continue;
            for (i = 0; i < drawn.p.v.design->n_groups; i++) {
                const fourlink_group *g = &drawn.p.v.design->group[i];

                (g->end == FOURLINK_GROUP_SLIDES ? compare_slider : compare_rocker)(i, g);
            }
        }
    motion_close(&panel.list);
    moving_close(&drawn);
}

TEST(outputs_are_drawn_where_the_columns_have_them)
{
    long machines = some_of(1500), number, n = 0;
    fourlink_source source;
    int k;

    for (number = 0; number < machines; number++) {
        begin_chance(72, number);
        if (!open_traced(number))
            continue;
        n++;
        memset(&source, 0, sizeof source);
        source.text = deck_text;
        source.length = length;
        view_take(&shown, results);
        for (k = 0; k < shown.n_branches; k++)
            compare_branch(&source, shown.branches[k]);
        fourlink_results_free(results);
    }
    print_message("%ld machines, %ld outputs at a step (rod, own slot, slot of the link: sliders "
                  "%ld, %ld, %ld, rockers "
                  "%ld, %ld, %ld), %ld places and lines, worst %.2g pixels\n",
                  n, tried, of_type[0][FOURLINK_HANGS_BY_ROD],
                  of_type[0][FOURLINK_HANGS_BY_OWN_SLOT], of_type[0][FOURLINK_HANGS_IN_SLOT],
                  of_type[1][FOURLINK_HANGS_BY_ROD], of_type[1][FOURLINK_HANGS_BY_OWN_SLOT],
                  of_type[1][FOURLINK_HANGS_IN_SLOT], compared, worst);
    assert_true(n > machines / 2);
    for (k = 0; k < 6; k++)
        assert_true(of_type[k / 3][k % 3] > machines / 20);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
