/* SPDX-License-Identifier: GPL-3.0-or-later
**
** matrix.c - the nine equations of each row, as text.
*/
#include "content.h"

/* theta2 = ANGLE UNIT, branch: BRANCH, and the reason if there are no equations. */
static void put_title(sheet *s, const fourlink_instant *at)
{
    line_put(&s->l, "# theta2 = %12g %s, branch: %s%s%s%s\n", at->row.angle,
             s->v.units[QUANTITY_ANGLE].name, fourlink_branch_text((int)at->branch),
             s->v.problem.axes_on_page ? ", equations in the axes of link 1" : "",
             at->status == FOURLINK_OK ? "" : ": ",
             at->status == FOURLINK_OK ? "" : fourlink_status_text(at->status));
}

static void put_system(sheet *s, const fourlink_instant *at)
{
    const fourlink_mechanism *mechanism = &s->v.problem.mechanism;
    double A[9][9], b[9], x[9];
    int i, j;

    fourlink_system(mechanism, &at->state, s->loads, s->v.problem.n_loads, A, b);
    fourlink_unknowns(mechanism, &at->forces, x);
    line_put(&s->l, "# ");
    for (j = 0; j < 9; j++)
        line_field(&s->l,
                   j == 8 && mechanism->drive
                       ? "drive"
                       : fourlink_unknown_text((int)mechanism->design.kind, j),
                   j ? 13 : 11);
    line_field(&s->l, "x", 17);
    line_field(&s->l, "b", 17);
    line_put(&s->l, "\n");
    for (i = 0; i < 9; i++) {
        for (j = 0; j < 9; j++)
            line_value(&s->l, A[i][j], 6, 13);
        line_value(&s->l, x[i], 9, 17);
        line_value(&s->l, b[i], 9, 17);
        line_put(&s->l, "\n");
    }
}

/* The six equations of output i. */
static void put_system_of_output(sheet *s, const fourlink_instant *at, int i)
{
    const fourlink_mechanism *mechanism = &s->v.problem.mechanism;
    double A[6][6], b[6], x[6];
    int k, j, link = FOURLINK_FOLLOWER + 1 + 2 * i;

    view_group_system(&s->v, at, s->loads, i, A, b, x);
    line_put(&s->l, "\n\n# %s and %s\n# ", fourlink_deck_link_text(s->v.deck, link),
             fourlink_deck_link_text(s->v.deck, link + 1));
    for (j = 0; j < 6; j++)
        line_field(&s->l, fourlink_group_unknown_text(&mechanism->design.group[i], j), j ? 13 : 11);
    line_field(&s->l, "x", 17);
    line_field(&s->l, "b", 17);
    line_put(&s->l, "\n");
    for (k = 0; k < 6; k++) {
        for (j = 0; j < 6; j++)
            line_value(&s->l, A[k][j], 6, 13);
        line_value(&s->l, x[k], 9, 17);
        line_value(&s->l, b[k], 9, 17);
        line_put(&s->l, "\n");
    }
}

void matrix_write(sheet *s)
{
    int i, j, blocks = 0;
    fourlink_instant at;
    unsigned long k;

    line_put(&s->l, "# A x = b in SI units: the columns of A under their unknowns, then the "
                    "solution x and the right-hand side b.\n# Rows: for each of the links 2, 3, 4 "
                    "the forces along x, along y, and the moments about the centre of mass.\n");
    if (s->v.design->n_groups)
        line_put(&s->l,
                 "# Behind them the six of each output, for its two links the same, with the "
                 "moments about the link's origin.\n# S and C are the force along the normal "
                 "of a slot, and its couple.\n");
    for (i = 0; i < s->v.n_branches; i++) {
        for (k = 0; k < s->v.problem.n_rows; k++) {
            int status =
                fourlink_results_row(s->v.results, s->v.branches[i], k, NULL, &at, s->loads);

            if (sheet_is_over(s, &at))
                break;
            line_put(&s->l, blocks++ ? "\n\n" : "");
            put_title(s, &at);
            if (status == FOURLINK_OK)
                put_system(s, &at);
            for (j = 0; j < s->v.design->n_groups && status == FOURLINK_OK; j++)
                put_system_of_output(s, &at, j);
            s->failed += status != FOURLINK_OK && !view_goes_to(&s->v, status);
        }
        sheet_write_stop(s, s->v.branches[i]);
    }
}
