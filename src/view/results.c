/* SPDX-License-Identifier: GPL-3.0-or-later
**
** results.c - the functions of fourlink.h that need memory.
*/
#include <string.h>

#include "system/memory.h"
#include "results.h"

static int noted(int status)
{
    if (status == FOURLINK_NO_MEMORY)
        memory_note_failure();
    return status;
}

int results_open(const fourlink_source *source, unsigned long max_mistakes,
                 fourlink_results **results, fourlink_mistake *mistakes, unsigned long *n_mistakes)
{
    return noted(fourlink_results_open(source, max_mistakes, results, mistakes, n_mistakes));
}

int results_open_like(const fourlink_source *source, fourlink_results *like,
                      unsigned long max_mistakes, fourlink_results **results,
                      fourlink_mistake *mistakes, unsigned long *n_mistakes)
{
    return noted(
        fourlink_results_open_like(source, like, max_mistakes, results, mistakes, n_mistakes));
}

int results_design(const fourlink_results *from, unsigned long design, unsigned long max_mistakes,
                   fourlink_results **results, fourlink_mistake *mistakes,
                   unsigned long *n_mistakes)
{
    return noted(
        fourlink_results_design(from, design, max_mistakes, results, mistakes, n_mistakes));
}

int results_set(fourlink_results *results, const char *name, double value,
                fourlink_mistake *mistake)
{
    return noted(fourlink_results_set(results, name, value, mistake));
}

int results_put(fourlink_results *results, unsigned long n, const int *handles,
                const double *values)
{
    return noted(fourlink_results_put(results, n, handles, values, NULL));
}

int results_end(fourlink_results *results, fourlink_branch branch, double *angle)
{
    return noted(fourlink_results_end(results, branch, angle));
}

int results_get(fourlink_results *results, int handle, fourlink_branch branch, double angle,
                fourlink_value *value)
{
    return noted(fourlink_results_get(results, handle, branch, angle, value));
}

int results_value(fourlink_results *results, const char *name, fourlink_branch branch, double angle,
                  fourlink_value *value)
{
    return noted(fourlink_results_value(results, name, branch, angle, value));
}

int results_facts(fourlink_results *results, int branch, int groups, const fourlink_value **facts,
                  unsigned long *n)
{
    *n = 0;
    return noted(fourlink_results_facts(results, branch, groups, facts, n));
}

int results_gave_up(int status)
{
    return status == FOURLINK_TOO_LONG || status == FOURLINK_LONG_SEARCH;
}

int results_check(fourlink_results *results, unsigned long i, fourlink_check *check)
{
    if (noted(fourlink_results_check(results, i, check)) == FOURLINK_OK)
        return 1;
    memset(check, 0, sizeof *check);
    check->file = check->unit = "";
    return 0;
}
