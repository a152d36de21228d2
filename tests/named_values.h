/* SPDX-License-Identifier: GPL-3.0-or-later
**
** named_values.h - values that a deck has by name only, against the columns of its rows.
*/
#ifndef NAMED_VALUES_H
#define NAMED_VALUES_H

#include "drawn_decks.h"

/* A deck of any kind, in the axes of the ground or of the page. */
static int any_axes(deck_lines *d)
{
    if (!seldom(0.5) || !put_on_page(d))
        *d = base;
    return !is_task(d);
}

/* Open the changed deck, unless one of which a sweep was left out has mistakes. */
static fourlink_results *opened_changed(void)
{
    fourlink_results *first = opened(base_text, NULL);

    fourlink_results_free(first);
    return first ? opened(changed_text, NULL) : NULL;
}

static int handle_of(fourlink_results *r, const char *name)
{
    fourlink_value v;

    return fourlink_results_find(r, name, &v) == FOURLINK_OK ? v.handle : 0;
}

/* -------------------------------------------------------------------------------------- opposite forces */

/* What each is the opposite of; components change their sign, sizes do not, directions turn by 180 deg. */
static const char *const opposites[][2] = {
    {"F21x", "F12x"}, {"F21y", "F12y"}, {"F21", "F12"}, {"F21_dir", "F12_dir"},
    {"F32x", "F23x"}, {"F32y", "F23y"}, {"F32", "F23"}, {"F32_dir", "F23_dir"},
    {"F43x", "F34x"}, {"F43y", "F34y"}, {"F43", "F34"}, {"F43_dir", "F34_dir"},
    {"F41x", "F14x"}, {"F41y", "F14y"}, {"F41", "F14"}, {"F41_dir", "F14_dir"},
    {"N43", "N34"},   {"M43", "M34"},   {"M41", "M14"}};

#define N_OPPOSITES ((int)(sizeof opposites / sizeof opposites[0]))

static int is_size(const char *name)
{
    return name[0] == 'F' && name[3] == '\0';
}

/* A direction differs by 180 deg within rounding; all else to the last bit. */
static void compare_opposite(const column *own, double value, double opposite, const char *name,
                             const char *where)
{
    double turn = 2 * PI / own->told->to_si, by = remainder(opposite - value, turn);

    present->values++;
    if (isnan(value) ? !isnan(opposite)
        : own->sort == OF_DIRECTION
            ? fabs(fabs(by) - turn / 2) > 1e-15 * turn || fabs(opposite) > turn / 2
            : opposite != (is_size(name) ? value : -value))
        fail("%s, %s: %.17g, expected the opposite of %.17g", where, name, opposite, value);
    if (opposite == 0 && signbit(opposite))
        fail("%s, %s: -0", where, name);
}

static void compare_opposite_statistics(side *s, int j, const char *name, fourlink_branch branch,
                                        int is_near)
{
    int handle = handle_of(s->r, name), which, status, told;
    fourlink_value v;

    for (which = FOURLINK_MAX; which <= FOURLINK_RMS; which++) {
        int keeps = is_size(name) || which == FOURLINK_RMS,
            of = keeps || which > FOURLINK_MIN ? which : FOURLINK_MAX + FOURLINK_MIN - which;
        double own = statistic(s, j, branch, of, &status);

        told = fourlink_results_get(s->r, handle + which, branch, 0, &v);
        if (status != told)
            fail("statistic %d of %s on %d: status %d, expected %d", which, name, (int)branch, told,
                 status);
        else if (status == FOURLINK_OK)
            compare(sort_of_statistic(which, is_near), keeps ? own : -own, v.value * v.to_si,
                    fmax(2e-3 * size_of_quantity[s->c.list[j].q], fabs(own)),
                    "statistic %d of %s on %d", which, name, (int)branch);
    }
}

/* The opposite forces of every row, and some of their statistics. */
static void compare_opposites(void)
{
    static side s;
    static double row[MOST_COLUMNS], opposite[N_OPPOSITES];
    int handles[N_OPPOSITES], of[N_OPPOSITES], n = 0, j, k, branch, is_near;
    const char *names[N_OPPOSITES];
    char where[100];
    unsigned long i;

    prepare(&s, opened_changed());
    for (k = 0; s.r && k < N_OPPOSITES; k++) {
        j = find_column(&s.c, opposites[k][1]);
        names[n] = opposites[k][0];
        handles[n] = handle_of(s.r, names[n]);
        of[n] = j;
        if ((j >= 0) != (handles[n] > 0) || find_column(&s.c, names[n]) >= 0)
            fail("%s is there, or is not", names[n]);
        n += j >= 0;
    }
    present->cases += n > 0;
    for (branch = FOURLINK_OPEN;
         n && branch >= (kind == FOURLINK_SCOTCH_YOKE ? FOURLINK_OPEN : FOURLINK_CROSSED) &&
         !has_failed;
         branch -= 2) {
        fourlink_branch one = (fourlink_branch)branch;

        is_near = compare_branch_rows(&s, &s, one, one, 0);
        for (i = 0; i < s.rows && !has_failed; i += s.rows / MOST_ROWS + 1) {
            fourlink_results_row(s.r, one, i, row, NULL, NULL);
            fourlink_results_rows(s.r, one, i, 1, (unsigned long)n, handles, opposite);
            snprintf(where, sizeof where, "%s, row %lu", fourlink_branch_text(branch), i);
            for (k = 0; k < n; k++)
                compare_opposite(&s.c.list[of[k]], row[of[k]], opposite[k], names[k], where);
        }
        k = one_of(n);
        if (!has_failed && is_determined(s.r, one, is_near) &&
            has_statistics(&s.c.list[of[k]], FOURLINK_MAX))
            compare_opposite_statistics(&s, of[k], names[k], one, is_near);
    }
    fourlink_results_free(s.r);
}

/* ------------------------------------------------------------------------------------------ at an angle */

/* Angles of the deck's unit: of rows, between them, at the ends of what is reached, at dead positions, anywhere. */
#define SOME_ANGLES 12

static int choose_angles(side *s, fourlink_branch branch, double *angles)
{
    static double row[MOST_COLUMNS];
    static const char *const ends[] = {"theta2_from", "theta2_to"};
    const fourlink_problem problem = problem_of(s->r);
    double turn = 2 * PI / problem.motion.angle_unit, worst = 0;
    fourlink_value v;
    unsigned long i;
    int n = 0, k;

    for (k = 0; k < 2; k++)
        if (fourlink_results_value(s->r, ends[k], branch, 0, &v) == FOURLINK_OK)
            angles[n++] = v.value;
    angles[n] = problem.motion.from;
    for (i = 0; i < s->rows; i += s->rows / MOST_ROWS + 1) /* the row nearest to a dead position */
        if (fourlink_results_row(s->r, branch, i, row, NULL, NULL) == FOURLINK_OK &&
            named(&s->c, row, "condition") > worst) {
            worst = named(&s->c, row, "condition");
            angles[n] = named(&s->c, row, "theta2");
        }
    n++;
    while (n < SOME_ANGLES)
        angles[n++] = problem.motion.from +
                      (seldom(0.5) ? problem.motion.interval * one_of(100) : turn * between(-2, 2));
    return n;
}

/* A value by its name, and by its handle, is that of the row. */
static void compare_at_angle(side *s, int j, fourlink_branch branch, double wanted)
{
    static double row[MOST_COLUMNS];
    const char *name = s->c.list[j].told->name;
    fourlink_value found, v, again;
    char words[200];
    int status, told, at;

    snprintf(words, sizeof words, "%s at %.17g", name, wanted);
    if (strlen(words) >= 64) /* no name is so long */
        return;
    memset(&v, 0, sizeof v);
    if (fourlink_results_find(s->r, words, &found) != FOURLINK_OK) {
        fail("no '%s'", words);
        return;
    }
    at = fourlink_results_at(s->r, branch, found.angle, row, NULL, NULL);
    status = fourlink_results_value(s->r, words, branch, 123, &v);
    told = fourlink_results_get(s->r, found.handle, branch, 456, &again);
    present->values++;
    if (fabs(found.angle - wanted) > 1e-15 * fabs(wanted) || found.has_angle ||
        strcmp(found.name, words) != 0 || strcmp(found.unit, s->c.list[j].told->unit) != 0)
        fail("%s is described as %s at %.17g", words, found.name, found.angle);
    if (told != status || (status == FOURLINK_OK && memcmp(&v, &again, sizeof v) != 0))
        fail("%s on %d: by handle it is another", words, (int)branch);
    if (status == FOURLINK_OK
            ? memcmp(&v.value, &row[j], sizeof v.value) != 0 && !(isnan(v.value) && isnan(row[j]))
            : status != at)
        fail("%s on %d: %.17g, status %d, expected %.17g, %d", words, (int)branch, v.value, status,
             row[j], at);
    if (at == FOURLINK_OK && status != FOURLINK_OK)
        fail("%s on %d: status %d", words, (int)branch, status);
    present->undecided += status != FOURLINK_OK;
}

static void compare_at_angles(void)
{
    static side s;
    double angles[SOME_ANGLES];
    int branch, k, n, some;

    prepare(&s, opened_changed());
    present->cases += s.r != NULL;
    for (branch = FOURLINK_OPEN;
         s.r && branch >= (kind == FOURLINK_SCOTCH_YOKE ? FOURLINK_OPEN : FOURLINK_CROSSED) &&
         !has_failed;
         branch -= 2) {
        n = choose_angles(&s, (fourlink_branch)branch, angles);
        for (k = 0; k < n; k++)
            for (some = 0; some < 8; some++)
                compare_at_angle(&s, one_of(s.c.n), (fourlink_branch)branch, angles[k]);
    }
    fourlink_results_free(s.r);
}

#endif
