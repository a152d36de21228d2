/* SPDX-License-Identifier: GPL-3.0-or-later
**
** c90.c - the whole job in one call, from strict C90: ME3491's linkage at 40 deg.  Prints the driving
** torque and exits with the status.
*/
#include <stdio.h>
#include <string.h>

#include <fourlink.h>

int main(void)
{
    static const double radian = 3.14159265358979323846 / 180;
    fourlink_design design;
    fourlink_mechanism mechanism;
    fourlink_crank crank;
    fourlink_load load;
    fourlink_state state;
    fourlink_forces forces;
    int status;

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_FOUR_BAR;
    design.link[FOURLINK_GROUND].length = 0.080;
    design.link[FOURLINK_CRANK].length = 0.020;
    design.link[FOURLINK_CRANK].mass = 0.1;
    design.link[FOURLINK_CRANK].cg.x = 0.010;
    design.link[FOURLINK_COUPLER].length = 0.066;
    design.link[FOURLINK_FOLLOWER].length = 0.056;
    design.gravity.y = -9.81;
    memset(&load, 0, sizeof load);
    load.link = FOURLINK_FOLLOWER;
    load.torque = 0.5;
    crank.theta2 = 40 * radian;
    crank.omega2 = 10.5;
    crank.alpha2 = 0;
    status = fourlink_prepare(&design, &mechanism);
    if (status == FOURLINK_OK)
        status = fourlink_analyse(&mechanism, FOURLINK_OPEN, &crank, &load, 1, &state, &forces);
    if (status == FOURLINK_OK)
        printf("Ts = %.12f\n", forces.Ts);
    else
        puts(fourlink_status_text(status));
    return status;
}
