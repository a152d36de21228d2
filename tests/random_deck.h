/* SPDX-License-Identifier: GPL-3.0-or-later
**
** random_deck.h - a random deck, for trials in C: all mechanisms, change points and dead positions,
** loads, gas, motions.
*/
#ifndef RANDOM_DECK_H
#define RANDOM_DECK_H

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

/* ------------------------------------------------------------------------------------------- chance */

static unsigned long long state;

static double chance(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) / 9007199254740992.0;
}

static double between(double low, double high)
{
    return low + (high - low) * chance();
}

static int one_of(int n)
{
    return (int)(n * chance());
}

static int seldom(double share)
{
    return chance() < share;
}

/* ------------------------------------------------------------------------------------------- decks */

#define SEED_OF_YOKES 1000 /* and above: decks of Scotch yokes alone */
static int only_yokes;

static char deck_text[20000];
static size_t length;
static double corners[200]; /* rad; where something happens, in every cycle */
static int n_corners;

static void write(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    length += (size_t)vsnprintf(deck_text + length, sizeof deck_text - length, format, arguments);
    va_end(arguments);
}

static void write_mass(double link)
{
    if (seldom(0.15))
        return;
    write("mass = %.17g kg\ninertia = %.17g kg m2\n", between(0.1, 5), between(0.001, 0.2) * link);
    if (seldom(0.8))
        write("cg = (%.17g, %.17g) m\n", between(-0.1, 1) * link,
              seldom(0.5) ? 0 : between(-0.3, 0.3) * link);
}

/* Lengths that make a change point, as sums of sixteenths, which are exact. */
static void set_change_point(double *d)
{
    double x = (1 + one_of(15)) / 16.0, y = (1 + one_of(15)) / 16.0, z = (1 + one_of(15)) / 16.0;

    switch (one_of(4)) {
    case 0: /* parallelogram */
        d[0] = d[2] = x;
        d[1] = d[3] = y;
        break;
    case 1: /* deltoid */
        d[0] = d[1] = x;
        d[2] = d[3] = y;
        break;
    case 2:
        d[0] = x;
        d[1] = y;
        d[2] = z;
        d[3] = fabs(x + y - z);
        break;
    default:
        d[0] = x;
        d[1] = fabs(x + y - z);
        d[2] = z;
        d[3] = y;
        break;
    }
}

static int can_be_assembled(const double *d)
{
    double sum = d[0] + d[1] + d[2] + d[3];
    int i;

    for (i = 0; i < 4; i++)
        if (!(d[i] > 1e-3) || 2 * d[i] > sum * (1 - 1e-4))
            return 0;
    return 1;
}

static void write_four_bar(double scale)
{
    static const char *const names[] = {"ground", "crank", "coupler", "rocker"};
    double d[4]; /* ground, crank, coupler, rocker */
    int i, how = one_of(10);

    do {
        for (i = 0; i < 4; i++)
            d[i] = between(0.1, 1);
        if (how < 3)
            d[1] = between(0.05, 0.3); /* most of them crank-rockers */
        if (how >= 7)
            set_change_point(d);
        if (how == 9)
            d[one_of(4)] *= 1 + (seldom(0.5) ? -1 : 1) * pow(10, between(-3, -2));
    } while (!can_be_assembled(d));
    write("mechanism = four-bar\n");
    for (i = 0; i < 4; i++) {
        write("[%s]\nlength = %.17g m\n", names[i], d[i] * scale);
        if (i > 0)
            write_mass(d[i] * scale);
        else if (seldom(0.3))
            write("angle = %.17g deg\n", between(-180, 180));
    }
}

static void write_curve(const char *name, double low, double high, const char *scale, double cycle)
{
    int n = 3 + one_of(9), i;

    write("%s = ", name);
    for (i = 0; i < n; i++) {
        double at = floor(cycle * (i + between(0.1, 0.9)) / n);

        corners[n_corners++] = at * PI / 180;
        write("%s%g deg %.17g %s", i ? ", " : "", at, between(low, high), scale);
    }
    write("\n");
}

static void write_gas(double share, double wide, double crank, double scale, double cycle)
{
    if (!seldom(share))
        return;
    write("[gas]\nbore = %.17g m\n", between(0.1, wide) * crank * scale);
    if (seldom(0.4))
        write("pressure = %.17g Pa\n", between(0, 2e6));
    else
        write_curve("indicator", 2e4, 3e6, "Pa", cycle);
}

static void write_slider_crank(double scale, double cycle)
{
    double r = between(0.1, 1), l = r * between(1.2, 4),
           e = seldom(0.5) ? 0 : between(-0.3, 0.3) * r;
    int how = one_of(10);

    if (how < 2)
        l = r * between(0.4, 1.2);
    if (how >= 8) {
        r = (2 + one_of(14)) / 16.0;
        e = seldom(0.5) ? 0 : r / 2 * (seldom(0.5) ? 1 : -1);
        l = r + e;
    }
    if (how == 9)
        l *= 1 + (seldom(0.5) ? -1 : 1) * pow(10, between(-3, -2));
    write("mechanism = slider-crank\n[ground]\noffset = %.17g m\n", e * scale);
    if (seldom(0.3))
        write("angle = %.17g deg\n", between(-180, 180));
    write("[crank]\nlength = %.17g m\n", r * scale);
    write_mass(r * scale);
    write("[rod]\nlength = %.17g m\n", l * scale);
    write_mass(l * scale);
    write("[piston]\n");
    if (seldom(0.8))
        write("mass = %.17g kg\n", between(0.1, 5));
    write_gas(0.5, 0.5, r, scale, cycle);
}

/* Crank and slotted lever, Whitworth's quick return, oscillating cylinder; some with a change point. */
static void write_inverted(double scale, double cycle)
{
    double d = between(0.2, 1), a = d * between(0.2, 2.5),
           h = seldom(0.5) ? 0 : between(-0.5, 0.5) * a;

    if (seldom(0.2)) {
        d = (1 + one_of(15)) / 16.0;
        a = (1 + one_of(15)) / 16.0;
        h = a - d;
    }
    write("mechanism = inverted-slider-crank\n[ground]\nlength = %.17g m\n", d * scale);
    if (seldom(0.3))
        write("angle = %.17g deg\n", between(-180, 180));
    write("[crank]\nlength = %.17g m\n", a * scale);
    write_mass(a * scale);
    write("[slider]\n");
    write_mass(0.3 * scale);
    write("[lever]\noffset = %.17g m\n", h * scale);
    write_mass(d * scale);
    write_gas(0.3, 0.3, a, scale, cycle);
}

/* Slots of all directions, some with friction in slot and guide. */
static void write_yoke(double scale, double cycle)
{
    double a = between(0.1, 1), e = seldom(0.5) ? 0 : between(-1, 1) * a;

    write("mechanism = scotch-yoke\n[ground]\noffset = %.17g m\n", e * scale);
    if (seldom(0.3))
        write("angle = %.17g deg\n", between(-180, 180));
    write("[crank]\nlength = %.17g m\n", a * scale);
    write_mass(a * scale);
    write("[slider]\n");
    write_mass(0.3 * scale);
    write("[yoke]\n");
    if (seldom(0.6))
        write("angle = %.17g deg\n", seldom(0.1) ? between(2, 10) : between(20, 160));
    write_mass(a * scale);
    write_gas(0.4, 0.5, a, scale, cycle);
}

enum { A_FOUR_BAR, A_SLIDER_CRANK, AN_INVERTED, A_YOKE };

static void write_loads(int slides, double scale, double cycle)
{
    static const char *const links[4][3] = {{"crank", "coupler", "rocker"},
                                            {"crank", "rod", "piston"},
                                            {"crank", "slider", "lever"},
                                            {"crank", "slider", "yoke"}};
    int n = one_of(3), i;

    for (i = 0; i < n; i++) {
        int link = one_of(3), turns = !(slides == A_SLIDER_CRANK && link == 2),
            has_torque = turns && seldom(0.6);

        write("[load L%d]\nlink = %s\n", i, links[slides][link]);
        if (!has_torque || seldom(0.4)) {
            write("force = (%.17g, %.17g) N\n", between(-200, 200), between(-200, 200));
            if (turns)
                write("at = (%.17g, %.17g) m\nframe = %s\n", between(-0.5, 1) * scale,
                      between(-0.5, 0.5) * scale, seldom(0.5) ? "link" : "ground");
        }
        if (has_torque && seldom(0.5))
            write_curve("torque", -50, 50, "N m", cycle);
        else if (has_torque)
            write("torque = %.17g N m\n", between(-50, 50));
        if (seldom(0.4)) {
            double from = between(-180, 500), to = from + between(1, 0.9 * cycle);

            write("from = %.17g deg\nto = %.17g deg\n", from, to);
            corners[n_corners++] = from * PI / 180;
            corners[n_corners++] = to * PI / 180;
        }
    }
}

static void write_motion(double cycle)
{
    double speed = pow(10, between(0, 2.5)) * (seldom(0.5) ? -1 : 1);
    double turn = speed > 0 ? 1 : -1, from = seldom(0.5) ? 0 : between(-360, 360);
    double interval = (double)(1 + one_of(30)), range;

    write("[motion]\ninterval = %g deg\ncycle = %g deg\n", interval, cycle);
    switch (one_of(8)) {
    case 0: /* from rest */
        write("run_up = %.17g deg\nacceleration = %.17g rad/s2\n", between(5, 400),
              turn * between(1, 100));
        return;
    case 1: /* faster, or slower until it stops */
        write("acceleration = %.17g rad/s2\n", between(-0.1, 0.1) * speed * speed);
        range = between(30, 500);
        break;
    case 2:
        write("hold = yes\nacceleration = %.17g rad/s2\n", between(-1, 1) * speed * speed);
        range = cycle;
        break;
    case 3:
        range = between(30, 360);
        break;
    case 4:
        range = between(360, 1500);
        break;
    default:
        range = cycle;
        break;
    }
    write("speed = %.17g rad/s\n", speed);
    if (from != 0 || range != cycle)
        write("from = %.17g deg\nto = %.17g deg\n", from, from + turn * range);
}

static inline void make_deck(void)
{
    double cycle = seldom(0.2) ? 720 : 360, scale = pow(10, between(-1.5, 0.5));
    static const char *const carriers[] = {"coupler", "rod", "slider", "yoke"};
    int slides = only_yokes     ? A_YOKE
                 : seldom(0.35) ? A_SLIDER_CRANK
                 : seldom(0.25) ? AN_INVERTED
                                : A_FOUR_BAR;
    int n = one_of(3), i;

    length = 0;
    n_corners = 0;
    if (seldom(0.9))
        write("solver = dyad\n");
    if (slides == A_SLIDER_CRANK)
        write_slider_crank(scale, cycle);
    else if (slides == AN_INVERTED)
        write_inverted(scale, cycle);
    else if (slides == A_YOKE)
        write_yoke(scale, cycle);
    else
        write_four_bar(scale);
    write_loads(slides, scale, cycle);
    if (seldom(0.5))
        write("[gravity]\nacceleration = %s m/s2\ndirection = %.17g deg\n",
              seldom(0.5) ? "0" : "9.81", between(-180, 180));
    write_motion(cycle);
    for (i = 0; i < n; i++)
        write("[point P%d]\nlink = %s\nat = (%.17g, %.17g) m\n", i,
              seldom(0.7) ? carriers[slides] : "crank", between(-1, 1) * scale,
              between(-1, 1) * scale);
    write("[table]\ncolumns = all\n");
    for (i = 0; i < 4; i++)
        corners[n_corners++] = i * PI / 2;
}

/* Seed the generator for deck i of a seed. */
static void begin_chance(long seed, long i)
{
    int k;

    only_yokes = seed >= SEED_OF_YOKES;

    state = 0x9E3779B97F4A7C15ULL * (unsigned long long)(seed * 1000003 + i + 1);
    for (k = 0; k < 10; k++)
        chance();
}

#endif
