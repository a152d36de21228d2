/* SPDX-License-Identifier: GPL-3.0-or-later
**
** figures.c - the report that is made in a page, in place of src/report/figures.c: its figure is the interactive
** drawing, since there is no gnuplot, and no scratch file for the csv that the page saves itself.
*/
#include <errno.h>

#include "base/system.h"
#include "report/report.h"

void report_put_mechanism(report *r)
{
    page_section(&r->page, "mechanism", "Mechanism");
    report_put_interactive(r);
    page_print(&r->page, "</section>\n");
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
