/* SPDX-License-Identifier: GPL-3.0-or-later
**
** laws.c - what must hold for any machine, of random decks of all sections (random_schema.h).
**
**    laws DECKS [FIRST [LAW]]
**
** The text of a deck is changed by a law, through the schema (changed_decks.h), and its results must follow: all
** columns of each row, statuses, extremes, means, facts (same_results.h).  With no LAW each is tried with four decks
** in turn, with `all` with every one.  Decks that fail are left as laws-NUMBER.deck, and laws-NUMBER-LAW.deck changed.
*/
#include "driven_decks.h"
#include "named_values.h"

static int turns_fully(fourlink_results *r)
{
    fourlink_value value;

    return fourlink_results_value(r, "theta2_to", FOURLINK_OPEN, 0, &value) == FOURLINK_OK &&
           value.value * value.to_si > 6.28;
}

static void compare_decks(const char *units)
{
    static side a, b;
    fourlink_results *first = opened(base_text, NULL),
                     *second = first ? opened(changed_text, units) : NULL;
    static const fourlink_branch branches[] = {FOURLINK_OPEN, FOURLINK_CROSSED};
    int swaps, j, k;

    if (first && *number_set)
        fourlink_results_set(first, number_set, value_set.value, NULL);
    if (!first || !second) {
        fourlink_results_free(first);
        fourlink_results_free(second);
        return;
    }
    if (present->factor == factor_mirrored &&
        (strstr(base_text, "/rad\n") || strstr(base_text, "/deg\n")) &&
        (!turns_fully(first) || kind == FOURLINK_INVERTED_SLIDER_CRANK)) {
        /* the angle of a spring begins at the first crank angle that is reached, a lever's there at -180 or 180 deg */
        fourlink_results_free(first);
        fourlink_results_free(second);
        return;
    }
    prepare(&a, first);
    prepare(&b, second);
    /* A mirrored branch of a four-bar is the other one, of others the same; where the mechanism goes on through a change
    ** point at 0 deg, it is on the other branch in a turn on the other side of that. */
    swaps = present->factor == factor_mirrored &&
            (kind == FOURLINK_FOUR_BAR || kind == FOURLINK_INVERTED_SLIDER_CRANK) &&
            (kind == FOURLINK_FOUR_BAR) != (problem_of(first).mechanism.change_folded != 0);
    present->cases++;
    if (a.rows != b.rows || a.c.n != b.c.n)
        fail("%lu rows of %d columns, expected %lu of %d", b.rows, b.c.n, a.rows, a.c.n);
    for (j = 0; j < a.c.n && !has_failed; j++)
        if (strcmp(a.c.list[j].told->name, b.c.list[j].told->name) != 0)
            fail("column %s, expected %s", b.c.list[j].told->name, a.c.list[j].told->name);
    for (k = 0; k < (kind == FOURLINK_SCOTCH_YOKE ? 1 : 2) && !has_failed; k++) {
        fourlink_branch one = branches[k], other = branches[swaps ? 1 - k : k];

        compare_statistics(&a, &b, one, other, compare_branch_rows(&a, &b, one, other, 0));
        if (!has_failed && present->factor != factor_mirrored && !present->rows_backward)
            compare_facts(&a, &b, one);
    }
    fourlink_results_free(first);
    fourlink_results_free(second);
}

/* ----------------------------------------------------------------------------------- one range, or two */

static double cut_at[3], speed_at[3]; /* deg, rad/s: begin, cut, end */
static double acceleration_held;

/* A given motion over some intervals, which is to be cut. */
static int cut_range(deck_lines *d)
{
    double from = seldom(0.5) ? 0 : 7.0 * between_whole(-50, 50), speed = power_of_ten(0, 2);
    int way = seldom(0.5) ? -1 : 1, before = between_whole(1, 30), k;

    if (is_task(d))
        return 0;
    pieces = before + between_whole(1, 30);
    holds = seldom(0.3);
    acceleration_held = seldom(0.5) ? 0 : speed * speed * between(0, 1) * way;
    for (k = 0; k < 3; k++) {
        int passed = k == 0 ? 0 : k == 1 ? before : pieces;

        cut_at[k] = from + 5.0 * way * passed;
        speed_at[k] =
            way * (holds
                       ? speed
                       : sqrt(speed * speed + 2 * fabs(acceleration_held) * 5 * passed * PI / 180));
    }
    drop_sections(&base, SECTION_MOTOR);
    for (k = 0; k < base.n; k++)
        drop_key(&base.block[k], KEY_FLYWHEEL_EXACT);
    set_motion(&base, cut_at[0], cut_at[2], speed_at[0], acceleration_held);
    return 1;
}

/* 1 if friction locks the machine somewhere, so that a mean is over less than the whole angle. */
static int locks_between_rows(const side *s, fourlink_branch branch)
{
    int F23 = find_column(&s->c, "F23"), status;

    return strstr(base_text, "[friction]") && F23 >= 0 &&
           isinf(statistic(s, F23, branch, FOURLINK_MAX, &status));
}

/* The rows of a part are those of the whole, an extreme of the whole is that of a part, means add up. */
static void compare_parts(void)
{
    static side whole, part[2];
    double share = (cut_at[1] - cut_at[0]) / (cut_at[2] - cut_at[0]);
    int all = pieces, k, some, which, status, is_near, branch;

    prepare(&whole, opened(base_text, NULL));
    part[0].r = part[1].r = NULL;
    for (k = 0; k < 2 && whole.r; k++) {
        changed = base;
        pieces = k == 0 ? (int)lround(share * all) : all - (int)lround(share * all);
        set_motion(&changed, cut_at[k], cut_at[k + 1], speed_at[k], acceleration_held);
        write_lines(&changed, changed_text, sizeof changed_text);
        prepare(&part[k], opened(changed_text, NULL));
    }
    present->cases += whole.r != NULL;
    for (branch = FOURLINK_OPEN;
         whole.r && branch >= (kind == FOURLINK_SCOTCH_YOKE ? FOURLINK_OPEN : FOURLINK_CROSSED) &&
         !has_failed;
         branch -= 2) {
        fourlink_branch one = (fourlink_branch)branch;

        is_near = compare_branch_rows(&whole, &part[0], one, one, 0);
        is_near |= was_locked;
        is_near |= compare_branch_rows(&whole, &part[1], one, one, part[0].rows - 1);
        for (some = 0;
             some < SOME_COLUMNS && !has_failed && !is_near && is_determined(whole.r, one, is_near);
             some++) {
            int j = one_of(whole.c.n);

            for (which = FOURLINK_MAX;
                 which <= (locks_between_rows(&whole, one) ? FOURLINK_MIN : FOURLINK_RMS) &&
                 has_statistics(&whole.c.list[j], which);
                 which++) {
                double value = statistic(&whole, j, one, which, &status),
                       x = statistic(&part[0], j, one, which, &status),
                       y = statistic(&part[1], j, one, which, &status),
                       size = fmax(sizes[j], 2e-3 * size_of_quantity[whole.c.list[j].q]);

                compare(sort_of_statistic(which, is_near),
                        which == FOURLINK_MAX    ? fmax(x, y)
                        : which == FOURLINK_MIN  ? fmin(x, y)
                        : which == FOURLINK_MEAN ? share * x + (1 - share) * y
                                                 : sqrt(share * x * x + (1 - share) * y * y),
                        value, fmax(size, fabs(value)), "statistic %d of %s on %d", which,
                        whole.c.list[j].told->name, branch);
            }
        }
    }
    fourlink_results_free(whole.r);
    fourlink_results_free(part[0].r);
    fourlink_results_free(part[1].r);
}

/* Rows lie between the extremes, the mean too, and the root mean square between the mean and the larger
** extreme. */
#define NOTHING 1e-12 /* in SI units: less is rounding, of a machine whose forces are 0 */

static void compare_bounds(void)
{
    static side s;
    static double row[MOST_COLUMNS];
    int some, which, status, told, branch, is_near;

    prepare(&s, opened(base_text, NULL));
    present->cases += s.r != NULL;
    for (branch = FOURLINK_OPEN;
         s.r && branch >= (kind == FOURLINK_SCOTCH_YOKE ? FOURLINK_OPEN : FOURLINK_CROSSED) &&
         !has_failed;
         branch -= 2) {
        fourlink_branch one = (fourlink_branch)branch;

        is_near = compare_branch_rows(&s, &s, one, one, 0);
        for (some = 0; some < 3 * SOME_COLUMNS && !has_failed && is_determined(s.r, one, is_near);
             some++) {
            int j = one_of(s.c.n);
            double x[5], most, size;
            unsigned long i;

            if (!has_statistics(&s.c.list[j], FOURLINK_MAX))
                continue;
            for (told = 0, which = FOURLINK_MAX; which <= FOURLINK_RMS; which++) {
                x[which] = statistic(&s, j, one, which, &status);
                told |= which < FOURLINK_MEAN && status != FOURLINK_OK;
            }
            if (told) {
                present->undecided++;
                continue;
            }
            most = fmax(fabs(x[FOURLINK_MAX]), fabs(x[FOURLINK_MIN]));
            if (most < NOTHING) {
                present->undecided++;
                continue;
            }
            size = fmax(most, 2e-3 * size_of_quantity[s.c.list[j].q]);
            for (i = 0; i < s.rows; i += s.rows / MOST_ROWS + 1)
                if (fourlink_results_row(s.r, one, i, row, NULL, NULL) == FOURLINK_OK &&
                    !isnan(row[j])) {
                    row[j] *= s.c.list[j].told->to_si;
                    compare(sort_of_statistic(FOURLINK_MAX, is_near),
                            fmin(fmax(row[j], x[FOURLINK_MIN]), x[FOURLINK_MAX]), row[j], size,
                            "%s on %d, row %lu, and its extremes", s.c.list[j].told->name, branch,
                            i);
                }
            if (isnan(x[FOURLINK_MEAN])) { /* unbounded to both sides */
                present->undecided++;
                continue;
            }
            compare(sort_of_statistic(FOURLINK_MEAN, is_near),
                    fmin(fmax(x[FOURLINK_MEAN], x[FOURLINK_MIN]), x[FOURLINK_MAX]),
                    x[FOURLINK_MEAN], size, "mean(%s) on %d, and its extremes",
                    s.c.list[j].told->name, branch);
            compare(sort_of_statistic(FOURLINK_RMS, is_near),
                    fmin(fmax(x[FOURLINK_RMS], fabs(x[FOURLINK_MEAN])), most), x[FOURLINK_RMS],
                    size, "rms(%s) on %d, its mean and its extremes", s.c.list[j].told->name,
                    branch);
        }
    }
    fourlink_results_free(s.r);
}

/* ------------------------------------------------------------------------------------------- a cycle
** later, at a crawl */

/* Two cycles of a steady motion, computed or given. */
static int repeat(deck_lines *d)
{
    double cycle =
        find_line(d, KEY_MOTION_CYCLE) ? atof(find_line(d, KEY_MOTION_CYCLE)->value) : 360;
    int is_steady =
        strcmp(value_of(find_block(d, SECTION_MOTION), KEY_MOTION_MODE, "given"), "steady") == 0;
    double from = 7.0 * between_whole(-50, 50);
    char value[50];
    int i;

    if (is_task(d) || (cycle != 360 && cycle != 720))
        return 0;
    pieces = 60;
    holds = 0;
    for (i = 0; i < base.n; i++)
        if (is_torsional(&base.block[i])) /* its angle is counted through full turns */
            base.block[i].section = SECTION_COUNT;
    drop_sections(&base, SECTION_COUNT);
    if (is_steady && find_line(d, KEY_MOTION_TURNS)) {
        snprintf(value, sizeof value, "%g",
                 (find_line(d, KEY_MOTION_TURNS)->value[0] == '-' ? -2 : 2) * cycle / 360);
        set_line(&base, KEY_MOTION_TURNS, value);
        snprintf(value, sizeof value, "%g deg", 2 * cycle / pieces);
        set_line(&base, KEY_MOTION_INTERVAL, value);
    } else {
        drop_sections(&base, SECTION_MOTOR);
        for (i = 0; i < base.n; i++)
            drop_key(&base.block[i], KEY_FLYWHEEL_EXACT);
        set_motion(&base, from, from + 2 * cycle, power_of_ten(0, 2), 0);
    }
    return 1;
}

/* Rows are those a cycle before, but for the time, which is later by the period. */
static void compare_cycles(void)
{
    static side s, later;
    static double row[MOST_COLUMNS], next[MOST_COLUMNS];
    fourlink_value period;
    int k;

    prepare(&s, opened(base_text, NULL));
    if (s.r &&
        problem_of(s.r).mechanism.change_folded != problem_of(s.r).mechanism.change_stretched) {
        fourlink_results_free(s.r); /* through one change point it comes back after two turns */
        return;
    }
    prepare(&later, s.r);
    later.rows = s.rows / 2 + 1;
    present->cases += s.r != NULL;
    for (k = 0; s.r && k < (kind == FOURLINK_SCOTCH_YOKE ? 1 : 2) && !has_failed; k++) {
        fourlink_branch branch = k == 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;
        int time = find_column(&s.c, "time");

        compare_branch_rows(&s, &later, branch, branch, s.rows / 2);
        if (time >= 0 && fourlink_results_value(s.r, "period", branch, 0, &period) == FOURLINK_OK &&
            fourlink_results_row(s.r, branch, 1, row, NULL, NULL) == FOURLINK_OK &&
            fourlink_results_row(s.r, branch, 1 + s.rows / 2, next, NULL, NULL) == FOURLINK_OK)
            compare(COMPUTED_ROW, period.value * period.to_si,
                    (next[time] - row[time]) * s.c.list[time].told->to_si,
                    period.value * period.to_si, "the period on %d", (int)branch);
    }
    fourlink_results_free(s.r);
}

#define CRAWL 1e-9 /* rad/s */

static int move_quickly(deck_lines *d)
{
    int way = seldom(0.5) ? -1 : 1;

    if (is_task(d))
        return 0;
    pieces = between_whole(10, 40);
    holds = 1;
    drop_what_knows_time();
    cut_at[0] = 7.0 * between_whole(-50, 50);
    cut_at[1] = cut_at[0] + 360 * way;
    set_motion(&base, cut_at[0], cut_at[1], way * power_of_ten(-0.5, 2),
               seldom(0.5) ? 0 : way * power_of_ten(0, 3));
    changed = base;
    set_motion(&changed, cut_at[0], cut_at[1], way * CRAWL, 0);
    *d = changed;
    return 1;
}

/* Ts_static is Ts at a crawl, where inertia is nothing, and undefined where friction locks the machine
** there; with Ts_inertia it
** makes Ts. */
static void compare_crawl(void)
{
    static side quick, slow;
    static double row[MOST_COLUMNS], still[MOST_COLUMNS];
    double scale[QUANTITY_COUNT];
    unsigned long i;
    int k, Ts;

    prepare(&quick, opened(base_text, NULL));
    prepare(&slow, quick.r ? opened(changed_text, NULL) : NULL);
    Ts = quick.r && slow.r ? find_column(&quick.c, "Ts") : -1;
    present->cases += Ts >= 0;
    for (k = 0; Ts >= 0 && k < (kind == FOURLINK_SCOTCH_YOKE ? 1 : 2); k++)
        for (i = 0; i < quick.rows && !has_failed; i++) {
            fourlink_branch branch = k == 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;
            int status = fourlink_results_row(quick.r, branch, i, row, NULL, NULL),
                told = fourlink_results_row(slow.r, branch, i, still, NULL, NULL);
            double condition, fixed, size;

            if (status != FOURLINK_OK || (told != FOURLINK_OK && told != FOURLINK_LOCKED))
                continue;
            to_si(&quick.c, row);
            to_si(&slow.c, still);
            condition =
                find_scales(&slow.c, still, problem_of(slow.r).mechanism.design.link[2].length,
                            fabs(named(&slow.c, still, "omega2")), scale);
            fixed = row[find_column(&quick.c, "Ts_static")];
            size = fmax(scale[QUANTITY_TORQUE], 1e-6 * fabs(named(&quick.c, row, "Ts_inertia"))) *
                   condition * condition;
            compare(COMPUTED_ROW, told == FOURLINK_LOCKED ? NAN : still[find_column(&slow.c, "Ts")],
                    fixed, size, "Ts_static on %d, row %lu", (int)branch, i);
            if (!isnan(fixed))
                compare(ROW, row[Ts], fixed + row[find_column(&quick.c, "Ts_inertia")],
                        fmax(size, fmax(fabs(fixed), fabs(row[Ts]))),
                        "Ts on %d, row %lu, of two parts", (int)branch, i);
        }
    fourlink_results_free(quick.r);
    fourlink_results_free(slow.r);
}

/* --------------------------------------------------------------------------------------- by its pins */

/* The branch and the crank angle of the drawing are found again, and the results are the same. */
static void compare_drawn(void)
{
    fourlink_results *r = opened(changed_text, NULL);
    fourlink_problem problem;

    if (r) {
        problem = problem_of(r);
        if (problem.drawn_branch != (int)drawn_branch ||
            !problem.open != (drawn_branch == FOURLINK_CROSSED) ||
            !problem.crossed != (drawn_branch == FOURLINK_OPEN))
            fail("the drawn branch is %d, expected %d", problem.drawn_branch, (int)drawn_branch);
        compare(ROW, drawn_at,
                difference_of_angles(drawn_at, problem.drawn * problem.motion.angle_unit), 1e3,
                "the crank as drawn");
        fourlink_results_free(r);
    }
    compare_decks(NULL);
}

static int has_lengths(deck_lines *d)
{
    return !is_task(d) && !has_pins(d);
}

/* As the library writes it by its pins, at a crank angle at which these tell it. */
static void compare_in_pins(void)
{
    fourlink_results *r = opened(base_text, NULL);
    fourlink_problem problem;
    fourlink_state drawn;
    unsigned long size;
    int is_clear = 0;

    if (r) {
        problem = problem_of(r);
        is_clear = find_drawn(&problem.mechanism, 1, &drawn);
        if (is_clear && (fourlink_deck_write_pins(fourlink_results_deck(r), drawn_at, changed_text,
                                                  sizeof changed_text, &size) != FOURLINK_OK ||
                         size >= sizeof changed_text || !strstr(changed_text, "\n[pins]\n")))
            fail("it is not written");
        fourlink_results_free(r);
    }
    if (is_clear)
        compare_decks(NULL);
}

/* ------------------------------------------------------------------------------------- in axes of a page */

/* Rows are the same when turned back, extremes and means of what has no direction too, and the crank angles of
** extremes where there is one. */
static void compare_on_page(void)
{
    static side a, b;
    static double expected[MOST_COLUMNS], row[MOST_COLUMNS];
    int j, k, which, status, told, is_near;
    char where[100];
    unsigned long i;

    prepare(&a, opened(base_text, NULL));
    prepare(&b, a.r ? opened(changed_text, NULL) : NULL);
    present->cases += a.r && b.r;
    for (k = 0; a.r && b.r && k < (kind == FOURLINK_SCOTCH_YOKE ? 1 : 2) && !has_failed; k++) {
        fourlink_branch one = k == 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;

        compared = one;
        if (a.rows != b.rows || a.c.n != b.c.n)
            fail("%lu rows of %d columns, expected %lu of %d", b.rows, b.c.n, a.rows, a.c.n);
        for (is_near = 0, i = 0; i < b.rows && !has_failed; i += b.rows / MOST_ROWS + 1) {
            status = fourlink_results_row(a.r, one, i, expected, NULL, NULL);
            told = fourlink_results_row(b.r, one, i, row, NULL, NULL);
            is_near |= status != FOURLINK_OK || told != FOURLINK_OK;
            snprintf(where, sizeof where, "%s, row %lu", fourlink_branch_text((int)one), i);
            if (status != told) {
                compare_statuses(&a, expected, status, &b, row, told, where);
                continue;
            }
            if (is_at_free_angle(&a.c, expected) || is_at_free_angle(&b.c, row)) {
                present->undecided++;
                continue;
            }
            turn_row(&b.c, row);
            for (j = 0; j < b.c.n; j++)
                if (isnan(row[j]) && strncmp(b.c.list[j].told->name, "I24", 3) == 0)
                    expected[j] = NAN;
            is_near |= compare_rows(&a, &b, expected, row, where) > NEAR_DEAD;
        }
        is_near |= comes_to_rest(&a, one);
        for (i = 0; i < SOME_COLUMNS && !has_failed && !is_near && is_determined(a.r, one, 0);
             i++) {
            j = one_of(a.c.n);
            if (!has_statistics(&a.c.list[j], FOURLINK_MAX) ||
                is_direction(a.c.list[j].told->name) || other_component(&a.c, j, 'x', 'y') >= 0 ||
                other_component(&a.c, j, 'y', 'x') >= 0)
                continue;
            for (which = FOURLINK_MAX; which <= FOURLINK_RMS; which++) {
                double x = statistic(&a, j, one, which, &status),
                       y = statistic(&b, j, one, which, &told);

                if (status == FOURLINK_OK && told == FOURLINK_OK)
                    compare(sort_of_statistic(which, 0), x, y,
                            doubt_of_motion(a.r, 0) *
                                fmax(2e-3 * size_of_quantity[a.c.list[j].q], fabs(x)),
                            "statistic %d of %s on %d", which, a.c.list[j].told->name, (int)one);
            }
        }
    }
    fourlink_results_free(a.r);
    fourlink_results_free(b.r);
}

/* -------------------------------------------------------------------------------------------- the laws */

static law laws[] = {
    {.name = "scaled by powers of two",
     .change = scale_by_two,
     .factor = factor_scaled,
     .is_exact = 1},
    {.name = "scaled", .change = scale_by_any, .factor = factor_scaled},
    {.name = "turned", .change = turn, .factor = factor_one},
    {.name = "mirrored", .change = mirror, .factor = factor_mirrored},
    {.name = "time reversed",
     .change = reverse_time,
     .factor = factor_reversed,
     .rows_backward = 1,
     .has_own_time = 1},
    {.name = "other units", .change = change_units, .factor = factor_one},
    {.name = "another order", .change = change_order, .factor = factor_one, .is_exact = 1},
    {.name = "written and read", .change = leave_as_it_is, .factor = factor_one, .is_exact = 1},
    {.name = "in two parts",
     .change = cut_range,
     .factor = factor_one,
     .has_own_time = 1,
     .check = compare_parts},
    {.name = "a cycle later",
     .change = repeat,
     .factor = factor_one,
     .has_own_time = 1,
     .check = compare_cycles},
    {.name = "at a crawl", .change = move_quickly, .factor = factor_one, .check = compare_crawl},
    {.name = "by its pins",
     .change = draw_in_own_axes,
     .factor = factor_one,
     .check = compare_drawn},
    {.name = "by its input",
     .change = move_at_an_instant,
     .factor = factor_one,
     .check = compare_prescribed},
    {.name = "driven elsewhere",
     .change = move_at_an_instant,
     .factor = factor_one,
     .check = compare_driven},
    {.name = "in pins", .change = has_lengths, .factor = factor_one, .check = compare_in_pins},
    {.name = "on a page", .change = put_on_page, .factor = factor_one, .check = compare_on_page},
    {.name = "opposite", .change = any_axes, .factor = factor_one, .check = compare_opposites},
    {.name = "at an angle", .change = any_axes, .factor = factor_one, .check = compare_at_angles},
    {.name = "within bounds", .change = any_deck, .factor = factor_one, .check = compare_bounds}};

static const int kinds[4] = {FOURLINK_FOUR_BAR, FOURLINK_SLIDER_CRANK,
                             FOURLINK_INVERTED_SLIDER_CRANK, FOURLINK_SCOTCH_YOKE};

static void try_law(law *l)
{
    present = l;
    has_failed = 0;
    make_base();
    changed = base;
    *result_units = *number_set = '\0';
    if (!l->change(&changed))
        return;
    write_lines(&base, base_text, sizeof base_text);
    write_lines(&changed, changed_text, sizeof changed_text);
    if (l->check) {
        l->check();
        return;
    }
    if (l->change == leave_as_it_is)
        write_back();
    compare_decks(*result_units ? result_units : NULL);
}

/* Try it, and count its cases by kind. */
static void count_law(law *l)
{
    long before = l->cases;
    int k;

    try_law(l);
    for (k = 0; k < 4; k++)
        l->of_kind[k] += kind == kinds[k] ? l->cases - before : 0;
}

int main(int argc, char **argv)
{
    const int n_laws = (int)(sizeof laws / sizeof laws[0]);
    long n = argc > 1 ? atol(argv[1]) : 100, first = argc > 2 ? atol(argv[2]) : 0, cases = 0;
    int i, k;

    setvbuf(stdout, NULL, _IOLBF, 0);
    for (number = first; number < first + n; number++) {
        begin_chance(1, number);
        make_schema_deck(number, 12 + one_of(30));
        kind = kind_of_text(deck_text, OPENED);
        for (i = 0; i < n_laws && kind; i++)
            if (argc > 3 ? strcmp(argv[3], "all") == 0 || strcmp(argv[3], laws[i].name) == 0
                         : i == number / 4 % n_laws)
                count_law(&laws[i]);
    }
    printf("%-24s %8s %10s %9s  ", "", "cases", "values", "undecided");
    for (k = 0; k < N_SORTS; k++)
        printf(" %9s", sorts[k]);
    printf("\n");
    for (i = 0; i < n_laws; i++) {
        printf("%-24s %8ld %10ld %9ld  ", laws[i].name, laws[i].cases, laws[i].values,
               laws[i].undecided);
        for (k = 0; k < N_SORTS; k++)
            printf(" %9.1e", laws[i].worst[k]);
        printf("\n");
        if (argc > 3 && laws[i].cases)
            printf("%-24s %ld four-bar linkages, %ld slider-cranks, %ld inverted, %ld yokes\n", "",
                   laws[i].of_kind[0], laws[i].of_kind[1], laws[i].of_kind[2], laws[i].of_kind[3]);
        cases += laws[i].cases;
    }
    printf("%ld passed, %ld failed\n", cases - n_failed, n_failed);
    return n_failed > 0 || cases == 0;
}
