/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sections.c - sections still to come.
*/
#include "report.h"
void report_put_deck(report *r)
{
    (void)r;
}
void report_put_facts(report *r)
{
    (void)r;
}
void report_put_mechanism(report *r)
{
    report_put_interactive(r);
}
void report_put_sample(report *r)
{
    (void)r;
}
void report_put_curves(report *r)
{
    (void)r;
}
void report_put_tables(report *r)
{
    (void)r;
}
void report_put_checks(report *r)
{
    (void)r;
}
