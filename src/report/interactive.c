/* SPDX-License-Identifier: GPL-3.0-or-later
**
** interactive.c - the interactive drawing of a report, its style and its script.
*/
#include "report.h"

void report_put_style(page *p)
{
    (void)p;
}

void report_put_interactive(report *r)
{
    (void)r;
}

void report_put_script(page *p)
{
    (void)p;
}
