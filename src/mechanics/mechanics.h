/* SPDX-License-Identifier: GPL-3.0-or-later
**
** mechanics.h - declarations that the library's files share but callers do not see.
*/
#ifndef FOURLINK_MECHANICS_H
#define FOURLINK_MECHANICS_H

#include <stddef.h>

#include "fourlink.h"
#include "base/arithmetic.h"

/* A position with sine^2 below this is dead; what remains is rounding error. */
#define FLK_DEAD 1e-14

/* The nine equations are singular if a pivot, scaled so that coefficients are near 1, or the sine of the
** position, which is the determinant of two of them, is below this.  Dead positions are refused earlier, at
** 1e-7. */
#define FLK_SINGULAR 1e-13

/* A sum of lengths below this, relative to the sum of their magnitudes, is rounding error: 807 + 6 and
** 595 + 218 mm are equal, but not in binary. */
#define FLK_ROUNDING 1e-15

/* u1 + u2 (four_bar.c, slider_crank.c) follows from the lengths of links 3 and 4.  If its error exceeds this
** part of half its value, the position is lost in the rounding of much longer links. */
#define FLK_LOST 1e-8

/* 1 if |x| <= max; 0 for larger numbers and NaN.  The same for a vector. */
#define FLK_WITHIN(x, max) (fabs(x) <= (max))
#define FLK_BOTH_WITHIN(v, max) (FLK_WITHIN((v).x, max) && FLK_WITHIN((v).y, max))

/* A case in a switch that returns the text of a code. */
#define FLK_CASE(name, value, text) \
    case name:                      \
        return text;

/* Sets of kinds are sums of fourlink_kind.  This set has all kinds, including future ones. */
#define FLK_EVERY_KIND 0xff

/* NaN for an undefined value, without a sign, which printf would show. */
#define FLK_UNDEFINED fabs(GSL_NAN)

/* n = J v, v turned left by 90 deg */
#define FLK_TURN_LEFT(n, v) ((n).x = 0 - (v).y, (n).y = (v).x)

/* z component of u x v, and u . v */
#define FLK_CROSS(u, v) ((u).x * (v).y - (u).y * (v).x)
#define FLK_DOT(u, v) ((u).x * (v).x + (u).y * (v).y)

/* theta2, rad, at a crank angle of a motion in its unit. */
double flk_motion_theta2(const fourlink_motion *motion, double angle);

/* How many intervals the range of a motion has, also where an unsigned long has no room for so many rows
** (motion.c).  Beyond the most a row number is not exact in floating point. */
#define FLK_MOTION_MOST 1e15
double flk_motion_intervals(const fourlink_motion *motion);

/* The crank angle of row i, in the motion's unit. */
double flk_motion_angle(const fourlink_motion *motion, const fourlink_range *range,
                        unsigned long i);

/* Check loads: FOURLINK_OK, or what is wrong with one of them (nine_equations.c). */
int flk_check_loads(const fourlink_mechanism *mechanism, const fourlink_load *loads,
                    unsigned long n_loads);

/* The same for mass, moment of inertia and centre of mass of a link; for a length (mechanism.c). */
int flk_check_link(const fourlink_link *link);
int flk_check_length(double length);

/* The number of the last link; the data of a moving link. */
#define FLK_LAST_LINK(mechanism) FOURLINK_LAST_LINK(&(mechanism)->design)
#define FLK_LINK(mechanism, i)                               \
    ((i) <= FOURLINK_FOLLOWER ? &(mechanism)->design.link[i] \
                              : &(mechanism)->design.group[((i)-5) / 2].body[((i)-5) % 2])

/* The smallest sine of a position, in size: how near it is to a dead position of links 3 and 4, or of a
** group. */
#define FLK_SINE(state) \
    (fabs((state)->sine) < (state)->group_sine ? fabs((state)->sine) : (state)->group_sine)

/* Copy a state as far as a mechanism uses it: links of groups that it does not have take most of the room. */
#define FLK_STATE_SIZE(mechanism)     \
    (offsetof(fourlink_state, link) + \
     ((size_t)FLK_LAST_LINK(mechanism) + 1) * sizeof(fourlink_link_state))
#define FLK_COPY_STATE(mechanism, to, from) memcpy((to), (from), FLK_STATE_SIZE(mechanism))

/* The angle of an axis, in (-pi, pi]: rounding does not turn 180 deg into -180 deg (mechanism.c). */
double flk_angle_of_axis(const fourlink_vector *axis);

/* F12x, F12y, F23x ... F14y, M14, M34, Ts (kind.c). */
#define FLK_FORCES 11
void flk_list_forces(const fourlink_forces *forces, double list[FLK_FORCES]);

/* Turn a vector from a link's own axes into the frame of link 1: v is the arm from the link's origin to its
** point `at`, or a force that turns with the link. */
#define FLK_TURN(v, link, at)                                   \
    ((v).x = (at).x * (link)->axis.x - (at).y * (link)->axis.y, \
     (v).y = (at).x * (link)->axis.y + (at).y * (link)->axis.x)

/* v, the derivative with respect to theta2 of the point at arm r from a link's origin: its velocity for unit
** crank speed. */
#define FLK_UNIT_VELOCITY(v, link, r) \
    ((v).x = (link)->k_origin.x - (link)->k * (r).y, (v).y = (link)->k_origin.y + (link)->k * (r).x)

/* a, the acceleration of the point at arm r from a link's origin O: a = a_O - omega^2 r + alpha x r. */
#define FLK_ACCELERATION(a, link, r)                                                             \
    ((a).x =                                                                                     \
         (link)->acceleration.x - (link)->omega * (link)->omega * (r).x - (link)->alpha * (r).y, \
     (a).y =                                                                                     \
         (link)->acceleration.y - (link)->omega * (link)->omega * (r).y + (link)->alpha * (r).x)

/* Of the centre of mass of a link: its arm r, its velocity k for unit crank speed, its acceleration a. */
#define FLK_PLACE_MASS(data, link, r, k, a) \
    (FLK_TURN(r, link, (data)->cg), FLK_UNIT_VELOCITY(k, link, r), FLK_ACCELERATION(a, link, r))

/* Of a load on a link: the arm r of its point, its force F in the frame of link 1, and the velocity k of the
** point for unit crank speed. */
#define FLK_PLACE_LOAD(load, link, r, F, k)       \
    do {                                          \
        FLK_TURN(r, link, (load)->at);            \
        (F) = (load)->force;                      \
        if ((load)->frame == FOURLINK_FRAME_LINK) \
            FLK_TURN(F, link, (load)->force);     \
        FLK_UNIT_VELOCITY(k, link, r);            \
    } while (0)

/* The moment equation of a link about its origin O instead of G: with f the right-hand side of its force
** equations, m that of its moment equation, and r = G - O,
**
**    M_O = m + r x f
*/
#define FLK_MOMENT_ABOUT_ORIGIN(body) ((body)->moment + FLK_CROSS((body)->arm, (body)->force))

#endif
