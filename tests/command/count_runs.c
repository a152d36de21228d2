/* SPDX-License-Identifier: GPL-3.0-or-later
**
** count_runs.c - the command that counts how often a motion is integrated, over a range or a duration: the file RUNS_FILE
** gets the number.  It is linked with --wrap for these two functions.
*/
#include <stdio.h>
#include <stdlib.h>

#include "motion/path.h"

int __real_flk_path_run(flk_path *p, double speed, double length);
int __real_flk_path_run_for(flk_path *p, double speed, double duration);
int __wrap_flk_path_run(flk_path *p, double speed, double length);
int __wrap_flk_path_run_for(flk_path *p, double speed, double duration);

static unsigned long runs;

__attribute__((destructor)) static void tell(void)
{
    const char *name = getenv("RUNS_FILE");
    FILE *out = name ? fopen(name, "w") : NULL;

    if (out) {
        fprintf(out, "%lu\n", runs);
        fclose(out);
    }
}

int __wrap_flk_path_run(flk_path *p, double speed, double length)
{
    runs++;
    return __real_flk_path_run(p, speed, length);
}

int __wrap_flk_path_run_for(flk_path *p, double speed, double duration)
{
    runs++;
    return __real_flk_path_run_for(p, speed, duration);
}
