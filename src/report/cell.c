/* SPDX-License-Identifier: GPL-3.0-or-later
**
** cell.c - tables of names and values.
*/
#include <gsl/gsl_math.h>

#include "cell.h"

void cell_begin(page *p, const char *heading, const char *columns)
{
    if (heading)
        page_print(p, "<h3>%s</h3>\n", heading);
    page_print(p,
               "<div class=\"wide\"><table class=\"facts\">\n<thead><tr>%m</tr></thead>\n"
               "<tbody>\n",
               columns);
}

void cell_end(page *p)
{
    page_print(p, "</tbody>\n</table></div>\n");
}

void cell_number(page *p, double value, int digits)
{
    if (gsl_isnan(value))
        page_print(p, "\342\200\223"); /* a dash */
    else if (gsl_isinf(value))
        page_print(p, value > 0 ? "\342\210\236" : "\342\210\222\342\210\236");
    else
        page_print(p, digits > 12 ? "%.15g" : digits > 6 ? "%.9g" : "%.6g", value);
}

void cell_put(page *p, double value, int digits)
{
    page_print(p, "<td>");
    cell_number(p, value, digits);
    page_print(p, "</td>");
}
