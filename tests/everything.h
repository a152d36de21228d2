/* SPDX-License-Identifier: GPL-3.0-or-later
**
** everything.h - all results of an opened deck as one number, to compare.
*/
#ifndef FOURLINK_EVERYTHING_H
#define FOURLINK_EVERYTHING_H

#include "machines.h"

#define MOST_COLUMNS 200
#define MOST_LOADS 40
#define ROW_SIZE offsetof(fourlink_row, side) /* without what pads it */

typedef struct digest {
    uint64_t hash;
    unsigned long values, refused; /* numbers looked at; answers other than FOURLINK_OK */
} digest;

static inline void note(digest *d, double value)
{
    uint64_t bits = 0;

    if (!isnan(value))
        memcpy(&bits, &value, sizeof bits);
    d->hash = (d->hash ^ bits) * 1099511628211u;
    d->values++;
}

static inline void note_status(digest *d, int status)
{
    note(d, status);
    d->refused += status != FOURLINK_OK;
}

static inline void note_values(digest *d, const double *values, unsigned long n)
{
    while (n-- > 0)
        note(d, values[n]);
}

/* A row without its forces has the same values and the same motion. */
static inline void check_motion(fourlink_results *r, fourlink_branch branch, unsigned long i,
                                unsigned long n)
{
    static const fourlink_forces none;
    double values[MOST_COLUMNS], alone[MOST_COLUMNS];
    fourlink_instant row, motion;
    int status = fourlink_results_row(r, branch, i, values, &row, NULL), along = i % 2;

    if (along)
        status = fourlink_results_along(r, branch, row.row.place, values, &row, NULL);
    assert_int_equal(along ? fourlink_results_motion_along(r, branch, row.row.place, alone, &motion)
                           : fourlink_results_motion(r, branch, i, alone, &motion),
                     status);
    if (status >= FOURLINK_NULL)
        return;
    assert_memory_equal(alone, values, n * sizeof *values);
    assert_memory_equal(&motion.row, &row.row, ROW_SIZE);
    assert_int_equal(motion.row.side, row.row.side);
    if (status == FOURLINK_OK)
        assert_memory_equal(&motion.state.link[FOURLINK_CRANK], &row.state.link[FOURLINK_CRANK],
                            3 * sizeof row.state.link[0]);
    assert_memory_equal(&motion.forces, &none, sizeof none);
    assert_int_equal(fourlink_results_brief(r, branch, i, alone, &motion),
                     fourlink_results_motion(r, branch, i, values, &row));
    assert_memory_equal(alone, values, n * sizeof *values);
    assert_memory_equal(&motion.row, &row.row, ROW_SIZE);
    assert_int_equal(motion.row.side, row.row.side);
    assert_int_equal(motion.status, row.status);
    if (row.status == FOURLINK_OK)
        assert_true(motion.state.mu == row.state.mu && motion.state.sine == row.state.sine &&
                    motion.state.group_sine == row.state.group_sine);
}

/* Call all functions for all that an opened deck has. */
static inline digest exercise(fourlink_results *r)
{
    digest d = {14695981039346656037u, 0, 0};
    double values[MOST_COLUMNS], turn;
    fourlink_load loads[MOST_LOADS];
    const fourlink_value *list;
    fourlink_instant instant;
    fourlink_turning turning;
    unsigned long n, i, j;
    fourlink_problem p;
    fourlink_check c;
    int k;

    fourlink_deck_problem(fourlink_results_deck(r), &p);
    assert_true(p.n_loads <= MOST_LOADS);
    turn = 2 * PI / p.motion.angle_unit;
    for (k = FOURLINK_COLUMNS; k <= FOURLINK_OUTPUTS; k++) {
        fourlink_results_list(r, k, &list, &n);
        for (i = 0; i < n; i++)
            note(&d, list[i].value);
    }
    for (k = 0; k < 2; k++) {
        fourlink_results_list(r, FOURLINK_COLUMNS, &list, &n);
        for (i = 0; i < p.n_rows; i += 1 + p.n_rows / 20) {
            note_status(&d, fourlink_results_row(r, branches[k], i, values, &instant, loads));
            note_values(&d, values, n);
            check_motion(r, branches[k], i, n);
        }
        for (i = 0; i < 24; i++)
            if (fourlink_results_at(r, branches[k], turn * (double)i / 24, values, NULL, NULL) !=
                FOURLINK_NO_SUCH_ANGLE)
                note_values(&d, values, n);
        note_status(&d, fourlink_results_facts(r, branches[k], 7, &list, &n));
        for (i = 0; i < n; i++)
            note(&d, list[i].value);
        note_status(&d, fourlink_results_turning(r, branches[k], &turning));
        fourlink_results_list(r, FOURLINK_ALL_COLUMNS, &list, &n);
        for (i = 0; i < n; i++) {
            fourlink_value v = {0};

            fourlink_results_value(r, list[i].name, branches[k], turn / 5, &v);
            note(&d, v.value);
        }
    }
    for (j = 0; j < p.n_expected; j++) {
        note_status(&d, fourlink_results_check(r, j, &c));
        note(&d, c.computed);
    }
    return d;
}

static inline void read_whole(const char *path, char *text, size_t size)
{
    FILE *in = fopen(path, "r");
    size_t n;

    assert_non_null(in);
    n = fread(text, 1, size - 1, in);
    fclose(in);
    assert_true(n > 0 && n < size - 1);
    text[n] = '\0';
}

#endif
