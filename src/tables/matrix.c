/* SPDX-License-Identifier: GPL-3.0-or-later
**
** matrix.c - the nine equations of each row to text.
*/
#include "base/format.h"
#include "print.h"
#include "table.h"

static void put_equation(FILE *out, const double A[9], double x, double b)
{
    char number[FORMAT_SIZE];
    int j;

    for (j = 0; j < 9; j++)
        print_right(out, format_general(A[j] + 0.0, 6, number), 13);
    print_right(out, format_general(x, 9, number), 17);
    print_right(out, format_general(b, 9, number), 17);
    putc('\n', out);
}

static void put_system(FILE *out, const analysis *a, const result *r)
{
    const deck *d = a->d;
    const fourlink_forces *f = &r->forces;
    int slider_crank = d->design.kind == FOURLINK_SLIDER_CRANK, i;
    double A[9][9], b[9], x[9];
    char number[FORMAT_SIZE];

    fourlink_system(&d->mechanism, &r->state, a->loads, a->n_loads, A, b);
    x[0] = f->F12x;
    x[1] = f->F12y;
    x[2] = f->F23x;
    x[3] = f->F23y;
    x[4] = f->F34x;
    x[5] = f->F34y;
    x[6] = slider_crank ? f->M14 : f->F14x;
    x[7] = f->F14y;
    x[8] = f->Ts;
    fprintf(out, "# theta2 = %s %s, branch: %s\n", print_angle(r->row.angle, number),
            d->units[QUANTITY_ANGLE].name, branch_name(r->branch));
    fprintf(out, "# %11s%13s%13s%13s%13s%13s%13s%13s%13s%17s%17s\n", "F12x", "F12y", "F23x", "F23y",
            "F34x", "F34y", slider_crank ? "M14" : "F14x", slider_crank ? "N" : "F14y", "Ts", "x",
            "b");
    for (i = 0; i < 9; i++)
        put_equation(out, A[i], x[i], b[i]);
}

unsigned long matrix_print(FILE *out, analysis *a)
{
    const deck *d = a->d;
    fourlink_branch branches[2];
    int n = print_branches_of(d, branches), i, blocks = 0;
    unsigned long k, failed = 0;
    char stop[FORMAT_SIZE + 80], number[FORMAT_SIZE];
    result r;

    print_head(out, d);
    fputs("# A x = b in SI units: the columns of A under their unknowns, the solution x, the right "
          "side "
          "b.\n# Rows: forces along x, along y, moments about the centre of mass, of links 2, 3, "
          "4.\n",
          out);
    for (i = 0; i < n; i++) {
        for (k = 0; k < a->range.n_rows; k++) {
            analysis_row(a, branches[i], k, &r);
            if (blocks++)
                fputs("\n\n", out);
            if (r.status == FOURLINK_OK) {
                put_system(out, a, &r);
                continue;
            }
            failed++;
            fprintf(out, "# theta2 = %s %s, branch: %s: %s\n", print_angle(r.row.angle, number),
                    d->units[QUANTITY_ANGLE].name, branch_name(branches[i]),
                    fourlink_status_text(r.status));
        }
        if (a->range.stops) {
            fprintf(out, "# %s\n", print_stop(a, stop));
            failed++;
        }
    }
    return failed;
}
