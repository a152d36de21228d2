/* SPDX-License-Identifier: GPL-3.0-or-later
**
** designs.h - what the tests of synthesis share: does a linkage found meet its positions, and is all of it
** finite.
*/
#ifndef FOURLINK_TEST_DESIGNS_H
#define FOURLINK_TEST_DESIGNS_H

#include <complex.h>

#include "fourlink.h"
#include "check.h"

/* Assert that a call of a task gives one solution. */
#define FOUND(name, task, s)                                                            \
    do {                                                                                \
        unsigned long n_found = 0;                                                      \
        assert_int_equal(fourlink_synthesis_##name(task, 1, s, &n_found), FOURLINK_OK); \
        assert_int_equal(n_found, 1);                                                   \
    } while (0)

/* Assert that it fails with a status and leaves its outputs alone. */
#define REFUSED(name, task, status)                                                      \
    do {                                                                                 \
        static fourlink_solution before_, after_;                                        \
        unsigned long n_found = 77;                                                      \
        assert_int_equal(fourlink_synthesis_##name(task, 1, &after_, &n_found), status); \
        assert_int_equal(n_found, 77);                                                   \
        assert_memory_equal(&after_, &before_, sizeof after_);                           \
    } while (0)

static inline double length_of(const fourlink_solution *s, int link)
{
    return s->design.link[link].length;
}

static inline double size_of(const fourlink_solution *s)
{
    double size = fmax(fabs(s->design.offset), hypot(s->point.x, s->point.y));

    for (int i = 1; i <= 4; i++)
        size = fmax(size, length_of(s, i));
    return size;
}

/* The distance from a wanted position to that of the analysis, over what rounding can make of it: 1e-12 of
** the size, times the conditions of the system and of the position. */
static inline double miss_of(const fourlink_solution *s, int j, double size)
{
    const fourlink_precision *p = &s->position[j];
    fourlink_mechanism m;
    fourlink_state at;
    double off, b = length_of(s, s->design.kind == FOURLINK_INVERTED_SLIDER_CRANK ? 1 : 3);

    assert_int_equal(fourlink_prepare(&s->design, &m), FOURLINK_OK);
    assert_int_equal(fourlink_position(&m, (fourlink_branch)p->branch, p->theta2, &at),
                     FOURLINK_OK);
    size = fmax(size, size_of(s));
    if (s->has_point) {
        fourlink_vector found;

        assert_int_equal(fourlink_point(&at, FOURLINK_COUPLER, &s->point, &found, NULL, NULL),
                         FOURLINK_OK);
        off = hypot(found.x - p->point.x, found.y - p->point.y) +
              b * fabs(remainder(at.link[3].theta - p->theta3, 2 * PI));
        b /= 1 + hypot(s->point.x, s->point.y) / b;
    } else if (s->design.kind == FOURLINK_SLIDER_CRANK) {
        off = fabs(at.link[4].origin.x - p->output);
    } else {
        off = fabs(remainder(at.link[4].theta - p->output, 2 * PI)) *
              fmax(length_of(s, 4), s->design.link[1].length);
    }
    return off / (1e-12 * size * fmax(1, size / b) * s->condition / fabs(at.sine));
}

/* Every number of a solution is finite, but those of positions that are not reached. */
static inline int is_sound(const fourlink_solution *s)
{
    int sound = isfinite(s->a) && isfinite(s->c) && isfinite(s->crank_turn) &&
                isfinite(s->rocker_turn) && isfinite(s->K[0]) && isfinite(s->K[1]) &&
                isfinite(s->K[2]) && isfinite(s->condition) && isfinite(s->origin.x) &&
                isfinite(s->origin.y) && isfinite(s->direction) && isfinite(s->point.x) &&
                isfinite(s->point.y) && isfinite(s->from) && isfinite(s->to) &&
                isfinite(s->ratio) && isfinite(s->mu_min) && isfinite(s->mu_min_at) &&
                isfinite(s->max_error) && isfinite(s->max_error_at) && isfinite(s->design.offset) &&
                s->condition >= 1 && s->ratio >= 1 && s->mu_min >= 0;

    for (int i = 1; i <= 4; i++)
        sound = sound && isfinite(length_of(s, i));
    for (int j = 0; j < s->n_positions; j++) {
        const fourlink_precision *p = &s->position[j];

        sound = sound && isfinite(p->theta2) && isfinite(p->output) && isfinite(p->theta3) &&
                isfinite(p->point.x) && isfinite(p->point.y) && isfinite(p->residual) &&
                (p->branch == 0 || isfinite(p->error));
    }
    return sound;
}

/* Now and then a bad number. */
static inline double odd_number(uint64_t *seed)
{
    static const double odd[] = {0,        0,         0,      1,     1,    2,    -1,       NAN,
                                 INFINITY, -INFINITY, 1e-300, 1e300, 1e15, 1e16, 1e30,     -1e30,
                                 PI,       PI / 2,    1e-15,  1e-9,  1e9,  -0.0, 4.9e-324, 1e150};
    double which = uniform(seed, 0, 2 * COUNT(odd));

    return which < COUNT(odd)         ? odd[(int)which]
           : which < 1.7 * COUNT(odd) ? uniform(seed, -3, 3)
                                      : floor(uniform(seed, -3, 4));
}

#endif
