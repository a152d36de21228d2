/* SPDX-License-Identifier: GPL-3.0-or-later
**
** printed_rows.c ROWS - what one would write by hand: the positions, velocities, accelerations and forces of
** data/me3491-matrix.deck in a loop, in closed form, and printf of 20 numbers for each row.
*/
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fourlink.h"

static void set_link(fourlink_link *link, double length, double mass, double k, double r, double at)
{
    link->length = length;
    link->mass = mass;
    link->inertia = mass * k * k;
    link->cg.x = r * cos(at);
    link->cg.y = r * sin(at);
}

int main(int argc, char **argv)
{
    const double degree = 3.14159265358979324 / 180;
    double rows = argc > 1 ? strtod(argv[1], NULL) : 360, i;
    fourlink_design d;
    fourlink_mechanism m;
    fourlink_load load;
    fourlink_crank crank = {0, 10.5, 0};
    fourlink_state s;
    fourlink_forces f;

    memset(&d, 0, sizeof d);
    d.kind = FOURLINK_FOUR_BAR;
    d.link[1].length = 0.080;
    set_link(&d.link[2], 0.020, 0.10, 0.008, 0.010, 0);
    set_link(&d.link[3], 0.066, 0.30, 0.025, 0.030, 10 * degree);
    set_link(&d.link[4], 0.056, 0.25, 0.020, 0.028, -5 * degree);
    d.gravity.y = -9.81;
    memset(&load, 0, sizeof load);
    load.link = FOURLINK_FOLLOWER;
    load.torque = 0.5;
    if (fourlink_prepare(&d, &m) != FOURLINK_OK)
        return EXIT_FAILURE;
    for (i = 0; i < rows; i++) {
        crank.theta2 = 360 / rows * i * degree;
        if (fourlink_analyse_dyad(&m, FOURLINK_OPEN, &crank, &load, 1, &s, &f) != FOURLINK_OK)
            return EXIT_FAILURE;
        printf("%10.4f%10.4f%10.4f%10.3f%10.4f%10.4f%10.3f%10.4f%10.5f%10.5f%10.5f%10.5f%10.5f%10."
               "5f%10.5f%10.5f"
               "%12.7f%10.4f%10.4f%12.7f\n",
               crank.theta2 / degree, s.link[3].theta / degree, s.link[3].omega, s.link[3].alpha,
               s.link[4].theta / degree, s.link[4].omega, s.link[4].alpha, s.mu / degree, f.F12x,
               f.F12y, f.F23x, f.F23y, f.F34x, f.F34y, f.F14x, f.F14y, f.Ts, crank.omega2,
               crank.alpha2, f.Ts * crank.omega2);
    }
    return EXIT_SUCCESS;
}
