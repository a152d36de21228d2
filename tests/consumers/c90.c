/* SPDX-License-Identifier: GPL-3.0-or-later
**
** c90.c - the whole job in one call, from strict C90: the linkage of data/me3491-matrix.deck at 40 deg.
*/
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <fourlink.h>

static const double radian = 3.14159265358979323846 / 180;

static void set_link(fourlink_link *link, double length, double mass, double gyration, double r,
                     double angle)
{
    link->length = length;
    link->mass = mass;
    link->inertia = mass * gyration * gyration;
    link->cg.x = r * cos(angle * radian);
    link->cg.y = r * sin(angle * radian);
}

int main(void)
{
    fourlink_design design;
    fourlink_crank crank;
    fourlink_load load;
    fourlink_state state;
    fourlink_forces forces;
    int status;

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_FOUR_BAR;
    design.link[FOURLINK_GROUND].length = 0.080;
    set_link(&design.link[FOURLINK_CRANK], 0.020, 0.10, 0.008, 0.010, 0);
    set_link(&design.link[FOURLINK_COUPLER], 0.066, 0.30, 0.025, 0.030, 10);
    set_link(&design.link[FOURLINK_FOLLOWER], 0.056, 0.25, 0.020, 0.028, -5);
    design.gravity.y = -9.81;
    memset(&load, 0, sizeof load);
    load.link = FOURLINK_FOLLOWER;
    load.torque = 0.5;
    crank.theta2 = 40 * radian;
    crank.omega2 = 10.5;
    crank.alpha2 = 0;

    status = fourlink_analyse_design(&design, FOURLINK_OPEN, &crank, &load, 1, &state, &forces);
    if (status != FOURLINK_OK) {
        puts(fourlink_status_text(status));
        return 1;
    }
    printf("theta4 = %.6f deg\n", state.link[FOURLINK_FOLLOWER].theta / radian);
    printf("Ts = %.12f N m\n", forces.Ts);
    return 0;
}
