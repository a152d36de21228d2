/* SPDX-License-Identifier: GPL-3.0-or-later
**
** small.c - what takes as long as it is asked to, long and wide tables, sweeps, searches of machines whose motion is
** integrated, is here as if memory ran out.
*/
#include <stddef.h>

#include "fourlink.h"

#define MOST_ROWS 100
#define MOST_DESIGNS 10
#define MOST_COLUMNS 20
#define MOST_INTEGRATED 5

/* The linker calls these in place of the library's functions. */
extern __typeof__(fourlink_results_open) __wrap_fourlink_results_open;
extern __typeof__(fourlink_results_open) __real_fourlink_results_open;
extern __typeof__(fourlink_results_set) __wrap_fourlink_results_set;
extern __typeof__(fourlink_results_set) __real_fourlink_results_set;

static unsigned long n_set; /* since a deck was opened */

int __wrap_fourlink_results_open(const fourlink_source *source, unsigned long max_mistakes,
                                 fourlink_results **results, fourlink_mistake *mistakes,
                                 unsigned long *n_mistakes)
{
    int status = __real_fourlink_results_open(source, max_mistakes, results, mistakes, n_mistakes);
    const fourlink_value *columns;
    unsigned long n_columns;
    fourlink_problem p;

    n_set = 0;
    if (status != FOURLINK_OK)
        return status;
    fourlink_deck_problem(fourlink_results_deck(*results), &p);
    fourlink_results_list(*results, FOURLINK_COLUMNS, &columns, &n_columns);
    if (p.n_rows <= (n_columns > MOST_COLUMNS ? 4 : MOST_ROWS) && p.n_designs <= MOST_DESIGNS)
        return status;
    fourlink_results_free(*results);
    *results = NULL;
    return FOURLINK_NO_MEMORY;
}

int __wrap_fourlink_results_set(fourlink_results *results, const char *name, double value,
                                fourlink_mistake *mistake)
{
    fourlink_problem p;

    fourlink_deck_problem(fourlink_results_deck(results), &p);
    if (p.mode != FOURLINK_MODE_GIVEN && ++n_set > MOST_INTEGRATED)
        return FOURLINK_NO_MEMORY;
    return __real_fourlink_results_set(results, name, value, mistake);
}
