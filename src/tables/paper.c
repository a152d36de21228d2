/* SPDX-License-Identifier: GPL-3.0-or-later
**
** paper.c - the format paper: the printout of Alvi, section 5.1.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "sheet.h"

static void open_deck(sheet *s)
{
    sheet_write_gap(s);
    line_put(&s->l, "thet\tVela\tacca\tphi\tbeta\tvelc\tvelb\tAccc\tAccb\n");
}

/* A tab and a number with two decimals. */
static void put_number(line *l, double x)
{
    char number[FORMAT_SIZE];

    line_put(l, "\t%s", format_fixed(x, 2, number));
}

/* The crank's angle and speed have only the decimals they need; the angle has at least two digits. */
static void put_numbers(line *l, const fourlink_instant *at)
{
    const fourlink_link_state *coupler = &at->state.link[3], *rocker = &at->state.link[4];
    double degrees = at->row.crank.theta2 * 180 / M_PI, whole = floor(degrees + 0.5);
    int is_whole = fabs(degrees - whole) < 1e-9;
    char number[FORMAT_SIZE];

    line_put(l, "%s%s\t%4g", is_whole && 0 <= whole && whole < 10 ? "0" : "",
             format_fixed(is_whole ? whole : degrees, is_whole ? 0 : 2, number),
             at->row.crank.omega2);
    put_number(l, at->row.crank.alpha2);
    put_number(l, rocker->theta * 180 / M_PI);
    put_number(l, coupler->theta * 180 / M_PI);
    put_number(l, rocker->omega);
    put_number(l, coupler->omega);
    put_number(l, rocker->alpha);
    put_number(l, coupler->alpha);
}

static void put_row(sheet *s, const sheet_row *row)
{
    if (!row->at)
        line_put(&s->l, "# %s", row->status);
    else if (row->at->status == FOURLINK_OK)
        put_numbers(&s->l, row->at);
    else
        line_put(&s->l, "# %12g %s, %s: %s", row->at->row.angle, s->v.units[QUANTITY_ANGLE].name,
                 fourlink_branch_text((int)row->branch), row->status);
    line_put(&s->l, "\n");
}

static const sheet_frame of_rows = {NULL, open_deck, NULL, NULL};

const sheet_format paper_format = {
    "paper",                                                    /* name */
    {&of_rows, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL}, /* frame */
    NULL,                                                       /* column */
    NULL,                                                       /* listed */
    NULL,                                                       /* limit */
    NULL,                                                       /* fact */
    NULL,                                                       /* block */
    put_row,                                                    /* row */
    NULL,                                                       /* end_block */
    NULL,                                                       /* check */
    NULL,                                                       /* design */
    NULL,                                                       /* values */
    0,                                                          /* layout_size */
    1,                                                          /* is_by_angle */
    0,                                                          /* is_brief */
    NULL,                                                       /* mark */
    NULL,                                                       /* extremes */
    0                                                           /* is_lines */
};
