/* SPDX-License-Identifier: GPL-3.0-or-later
**
** paper.c - rows to text: the printout of Alvi, section 5.1.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "print.h"
#include "table.h"

/* -0.00 is printed as 0.00 */
static double no_minus_zero(double x)
{
    return fabs(x) < 0.005 ? 0 : x;
}

/* The printout of Alvi, section 5.1: the crossed branch first at every angle, without the closing
** 360 deg.  Its numbers have two decimals; the crank's angle and speed no more than they need (and
** -0 + 0 is 0). */
static void put_paper_row(FILE *out, const result *r)
{
    const fourlink_state *s = &r->state;
    double degrees = r->row.crank.theta2 * 180 / M_PI, whole = floor(degrees + 0.5);

    if (fabs(degrees - whole) < 1e-9)
        fprintf(out, "%02.0f", whole);
    else
        fprintf(out, "%.2f", degrees);
    fprintf(out, "\t%.4g\t%.2f\t%.2f\t%.2f\t%.2f\t%.2f\t%.2f\t%.2f\n", r->row.crank.omega2 + 0.0,
            no_minus_zero(r->row.crank.alpha2), no_minus_zero(s->link[4].theta * 180 / M_PI),
            no_minus_zero(s->link[3].theta * 180 / M_PI), no_minus_zero(s->link[4].omega),
            no_minus_zero(s->link[3].omega), no_minus_zero(s->link[4].alpha),
            no_minus_zero(s->link[3].alpha));
}

unsigned long paper_print(FILE *out, analysis *a)
{
    const deck *d = a->d;
    unsigned long k, n_rows = a->range.n_rows, failed = 0;
    char number[FORMAT_SIZE + 80];
    result r;
    int i;

    if (d->one_revolution && !a->range.stops && n_rows > 1)
        n_rows--;
    fputs("thet\tVela\tacca\tphi\tbeta\tvelc\tvelb\tAccc\tAccb\n", out);
    for (k = 0; k < n_rows; k++)
        for (i = 0; i < 2; i++) {
            fourlink_branch branch = i == 0 ? FOURLINK_CROSSED : FOURLINK_OPEN;

            if (branch == FOURLINK_OPEN ? !d->open : !d->crossed)
                continue;
            analysis_row(a, branch, k, &r);
            if (r.status == FOURLINK_OK)
                put_paper_row(out, &r);
            else
                fprintf(out, "# %s %s, %s: %s\n", print_angle(r.row.angle, number),
                        d->units[QUANTITY_ANGLE].name, branch_name(branch),
                        fourlink_status_text(r.status));
            failed += r.status != FOURLINK_OK;
        }
    if (a->range.stops) {
        fprintf(out, "# %s\n", print_stop(a, number));
        failed++;
    }
    return failed;
}
