/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fortran77.c - function generators and quick returns for programs in FORTRAN 77, see fourlink.h.
*/
#include <string.h>

#include "synthesis.h"

static void put_solution(const fourlink_solution *s, double length[4], double *offset,
                         double range[2], double check[4], int *idef)
{
    int i;

    for (i = 0; i < 4; i++)
        length[i] = s->design.link[i + 1].length;
    *offset = s->design.offset;
    range[0] = s->from;
    range[1] = s->to;
    check[0] = s->condition;
    check[1] = s->ratio;
    check[2] = s->mu_min;
    check[3] = s->max_error;
    *idef = s->defects;
}

void flfunc_(const int *kind, const double *ground, const int *n, const double *theta2,
             const double *output, const double *weight, const int *ifit, double length[4],
             double *offset, int *ibrnch, double turn[2], double range[2], double check[4],
             int *idef, int *istat)
{
    fourlink_function_task task;
    fourlink_solution s;
    unsigned long n_found;

    memset(&task, 0, sizeof task);
    task.kind = (fourlink_kind)*kind;
    task.ground = *ground;
    task.n = *n > 0 ? (unsigned long)*n : 0;
    task.theta2 = theta2;
    task.output = output;
    task.weight = weight;
    task.fit = (fourlink_fit)*ifit;
    *istat = fourlink_synthesis_function(&task, 1, &s, &n_found);
    if (*istat != FOURLINK_OK)
        return;
    put_solution(&s, length, offset, range, check, idef);
    *ibrnch = (int)s.branch;
    turn[0] = s.crank_turn;
    turn[1] = s.rocker_turn;
}

void flqret_(const int *itype, const double *ratio, const double *swing, const double *stroke,
             const int *islow, double length[4], double *offset, double range[2], double check[4],
             int *idef, int *istat)
{
    fourlink_quick_return_task task;
    fourlink_solution s;
    unsigned long n_found;

    memset(&task, 0, sizeof task);
    task.type = (fourlink_type)*itype;
    task.time_ratio = *ratio;
    task.swing = *swing;
    task.stroke = *stroke;
    memcpy(task.length + 1, length, 4 * sizeof *length);
    task.offset = *offset;
    task.slow = *islow;
    *istat = fourlink_synthesis_quick_return(&task, 1, &s, &n_found);
    if (*istat == FOURLINK_OK)
        put_solution(&s, length, offset, range, check, idef);
}
