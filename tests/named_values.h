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

#endif
