/* SPDX-License-Identifier: GPL-3.0-or-later
**
** burmester.c - the links that hold a coupler in five poses.
**
** A link is pinned at w to the coupler and at m to the ground.  In pose i the coupler's point is at z_i and
** its angle is phi_i, so that the link is
**
**    d_i = z_i + w e^(i phi_i) - m,   |d_i|^2 = |d_0|^2,   i = 1 ... 4
**
** These four equations have at most four real solutions.  (L. Burmester, Lehrbuch der Kinematik, Leipzig
** 1888; J. M. McCarthy, Geometric Design of Linkages, Springer 2000.)  They are found by Newton's method from
** many starts:
**
**    d|d_i|^2 = 2 (d_i . (e^(i phi_i) dw) - d_i . dm)
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "points.h"

#define STARTS 2000
#define STEPS 40
#define LAST 1e-12    /* a step, in parts of the unknowns, that ends it */
#define FARTHEST 50.0 /* a pin, in sizes of the task */
#define SAME 1e-6

/* The residuals at x = (w, m), their squares' gradient and Gauss's matrix. */
static void set_equations(const flk_points *p, const fourlink_vector e[FLK_POSES],
                          const double x[4], double H[4][FLK_UNKNOWNS], double g[4])
{
    double row[FLK_POSES][4], square[FLK_POSES], r, J[4];
    fourlink_vector d;
    int i, j, k;

    memset(H, 0, 4 * sizeof *H);
    memset(g, 0, 4 * sizeof *g);
    for (i = 0; i < FLK_POSES; i++) {
        d.x = p->point[i].x + e[i].x * x[0] - e[i].y * x[1] - x[2];
        d.y = p->point[i].y + e[i].y * x[0] + e[i].x * x[1] - x[3];
        square[i] = d.x * d.x + d.y * d.y;
        row[i][0] = 2 * (d.x * e[i].x + d.y * e[i].y);
        row[i][1] = 2 * (d.y * e[i].x - d.x * e[i].y);
        row[i][2] = -2 * d.x;
        row[i][3] = -2 * d.y;
    }
    for (i = 1; i < FLK_POSES; i++) {
        r = square[i] - square[0];
        for (k = 0; k < 4; k++)
            J[k] = row[i][k] - row[0][k];
        for (k = 0; k < 4; k++) {
            g[k] += J[k] * r;
            for (j = 0; j < 4; j++)
                H[k][j] += J[k] * J[j];
        }
    }
}

static double size_of(const double x[4])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]);
}

/* Newton's method from x; 0 if it does not end at a solution. */
static int find(const flk_points *p, const fourlink_vector e[FLK_POSES], double x[4])
{
    double H[4][FLK_UNKNOWNS], g[4], step[4], most, far;
    int n, k;

    for (n = 0; n < STEPS; n++) {
        set_equations(p, e, x, H, g);
        if (!flk_solve_normal(4, H, g, step))
            return 0;
        far = size_of(step);
        most = 1 + size_of(x);
        for (k = 0; k < 4; k++)
            x[k] -= step[k] * (far > most ? most / far : 1);
        if (!(far < GSL_POSINF))
            return 0;
        if (far <= LAST * most)
            return size_of(x) <= FARTHEST;
    }
    return 0;
}

int flk_burmester(const flk_points *p, double links[FLK_LINKS][4])
{
    static const unsigned long bases[] = {2, 3, 5, 7};
    double x[4], off[4], r, angle;
    fourlink_vector e[FLK_POSES];
    unsigned long i;
    int n = 0, k, j;

    for (k = 0; k < FLK_POSES; k++) {
        e[k].x = cos(p->angle[k]);
        e[k].y = sin(p->angle[k]);
    }
    for (i = 1; i <= STARTS && n < FLK_LINKS; i++) {
        for (k = 0; k < 4; k += 2) {
            r = pow(10, 1.7 * flk_halton(i, bases[k]) - 0.5);
            angle = 2 * M_PI * flk_halton(i, bases[k + 1]);
            x[k] = r * cos(angle);
            x[k + 1] = r * sin(angle);
        }
        if (!find(p, e, x))
            continue;
        for (k = 0; k < n; k++) {
            for (j = 0; j < 4; j++)
                off[j] = x[j] - links[k][j];
            if (size_of(off) <= SAME * (1 + size_of(x)))
                break;
        }
        if (k == n)
            memcpy(links[n++], x, sizeof x);
    }
    return n;
}

void flk_burmester_linkage(const flk_points *p, const double crank[4], const double rocker[4],
                           fourlink_solution *found)
{
    double beta = atan2(rocker[1] - crank[1], rocker[0] - crank[0]);
    fourlink_link *link = found->design.link;
    fourlink_vector ground, B, C;
    unsigned long j;

    memset(found, 0, sizeof *found);
    found->design.kind = FOURLINK_FOUR_BAR;
    ground.x = rocker[2] - crank[2];
    ground.y = rocker[3] - crank[3];
    found->direction = atan2(ground.y, ground.x);
    found->origin.x = p->centre.x + p->size * crank[2];
    found->origin.y = p->centre.y + p->size * crank[3];
    link[FOURLINK_GROUND].length = p->size * gsl_hypot(ground.x, ground.y);
    link[FOURLINK_COUPLER].length = p->size * gsl_hypot(rocker[0] - crank[0], rocker[1] - crank[1]);
    found->point.x = -p->size * (crank[0] * cos(beta) + crank[1] * sin(beta));
    found->point.y = -p->size * (crank[1] * cos(beta) - crank[0] * sin(beta));
    for (j = 0; j < p->n; j++) {
        double c = cos(p->angle[j]), s = sin(p->angle[j]);

        B.x = p->point[j].x + c * crank[0] - s * crank[1] - crank[2];
        B.y = p->point[j].y + s * crank[0] + c * crank[1] - crank[3];
        C.x = p->point[j].x + c * rocker[0] - s * rocker[1] - rocker[2];
        C.y = p->point[j].y + s * rocker[0] + c * rocker[1] - rocker[3];
        found->position[j].theta2 = atan2(B.y, B.x) - found->direction;
        link[FOURLINK_CRANK].length = p->size * gsl_hypot(B.x, B.y);
        link[FOURLINK_FOLLOWER].length = p->size * gsl_hypot(C.x, C.y);
        found->position[j].theta3 = p->angle[j] + beta - found->direction;
    }
}
