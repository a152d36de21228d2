// SPDX-License-Identifier: GPL-3.0-or-later
//
// cxx98.cpp - the whole job in one call, from C++98: the linkage of data/me3491-matrix.deck at 40 deg.
#include <cmath>
#include <cstdio>

#include <fourlink.h>

static const double radian = 3.14159265358979323846 / 180;

static fourlink_link make_link(double length, double mass, double gyration, double r, double angle)
{
    fourlink_link link = fourlink_link();

    link.length = length;
    link.mass = mass;
    link.inertia = mass * gyration * gyration;
    link.cg.x = r * std::cos(angle * radian);
    link.cg.y = r * std::sin(angle * radian);
    return link;
}

int main()
{
    fourlink_design design = fourlink_design();
    fourlink_load load = fourlink_load();
    fourlink_crank crank = {40 * radian, 10.5, 0};
    fourlink_state state;
    fourlink_forces forces;

    design.kind = FOURLINK_FOUR_BAR;
    design.link[FOURLINK_GROUND].length = 0.080;
    design.link[FOURLINK_CRANK] = make_link(0.020, 0.10, 0.008, 0.010, 0);
    design.link[FOURLINK_COUPLER] = make_link(0.066, 0.30, 0.025, 0.030, 10);
    design.link[FOURLINK_FOLLOWER] = make_link(0.056, 0.25, 0.020, 0.028, -5);
    design.gravity.y = -9.81;
    load.link = FOURLINK_FOLLOWER;
    load.torque = 0.5;

    int status = fourlink_analyse_design(&design, FOURLINK_OPEN, &crank, &load, 1, &state, &forces);
    if (status != FOURLINK_OK) {
        std::puts(fourlink_status_text(status));
        return 1;
    }
    std::printf("theta4 = %.6f deg\n", state.link[FOURLINK_FOLLOWER].theta / radian);
    std::printf("Ts = %.12f N m\n", forces.Ts);
    return 0;
}
