/* SPDX-License-Identifier: GPL-3.0-or-later
**
** figures.c - the report that is made in a page, in place of src/report/figures.c and assets.c: its
** figure is the interactive drawing, since there is no gnuplot, and there is no scratch file for the csv
** that the page saves itself.  The page has the style and the script of a report, and puts them in.
*/
#include <errno.h>
#include <stddef.h>

#include "system/system.h"
#include "report/assets.h"
#include "report/report.h"

const char *const assets_style[] = {"@STYLE@", NULL};
const char *const assets_script[] = {"@SCRIPT@", NULL};

void report_put_mechanism(report *r, int is_drawn)
{
    if (!is_drawn) {
        report_put_results(r);
        return;
    }
    page_section(&r->page, "mechanism", "Mechanism");
    report_put_interactive(r);
}

void report_put_curves(report *r)
{
    (void)r;
}

FILE *system_scratch(void)
{
    errno = ENOTSUP;
    return NULL;
}
