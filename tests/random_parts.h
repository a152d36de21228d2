/* SPDX-License-Identifier: GPL-3.0-or-later
**
** random_parts.h - a random machine, part by part: lengths, bodies, what acts on them, motions.  random_schema.h makes whole
** decks of them, and adds keys.
*/
#ifndef RANDOM_PARTS_H
#define RANDOM_PARTS_H

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chance.h"

/* ------------------------------------------------------------------------------------------- text */

static char deck_text[20000];
static size_t length;

static void write(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    length += (size_t)vsnprintf(deck_text + length, sizeof deck_text - length, format, arguments);
    va_end(arguments);
}

/* Leave the deck as a file of the present folder. */
static inline void leave_deck(const char *name)
{
    FILE *out = fopen(name, "w");

    if (!out)
        return;
    fwrite(deck_text, 1, length, out);
    fclose(out);
}

/* ------------------------------------------------------------------------------------------- lengths */

enum { A_FOUR_BAR, A_SLIDER_CRANK, AN_INVERTED, A_YOKE };

static int machine; /* A_FOUR_BAR ... */
static const char *const machine_names[] = {"four-bar", "slider-crank", "inverted-slider-crank",
                                            "scotch-yoke"};
static const char *const machine_links[][3] = {{"crank", "coupler", "rocker"},
                                               {"crank", "rod", "piston"},
                                               {"crank", "slider", "lever"},
                                               {"crank", "slider", "yoke"}};

/* dead positions, change points, thin links; far angles, run-ups, stops, many turns; numbers of 17 digits */
static int is_wild;
static double reach;                /* m, of the machine */
static double bar[4], guide_offset; /* m: ground, crank, coupler or rod, rocker */

static const char *any_link(void)
{
    return machine_links[machine][one_of(3)];
}

static int slides_only(const char *link)
{
    return strcmp(link, "piston") == 0 || strcmp(link, "yoke") == 0;
}

static int either_sign(void)
{
    return seldom(0.5) ? -1 : 1;
}

static void write_length(const char *key, double value)
{
    if (is_wild)
        write("%s = %.17g m\n", key, value);
    else
        write("%s = %.6g mm\n", key, 1e3 * value);
}

/* From one that is hardly a change point to one that is. */
static double nearly_one(void)
{
    return 1 + either_sign() * power_of_ten(-3, -2);
}

/* Lengths that make a change point, as sums of sixteenths, which are exact. */
static void draw_change_point(void)
{
    double x = (1 + one_of(15)) / 16.0, y = (1 + one_of(15)) / 16.0, z = (1 + one_of(15)) / 16.0;

    bar[0] = bar[2] = x; /* a parallelogram */
    bar[1] = bar[3] = y;
    switch (one_of(4)) {
    case 0:
        break;
    case 1: /* a deltoid */
        bar[1] = x;
        bar[2] = y;
        break;
    case 2:
        bar[2] = z;
        bar[3] = fabs(x + y - z);
        break;
    default:
        bar[1] = fabs(x + y - z);
        bar[2] = z;
        break;
    }
}

static int can_be_assembled(void)
{
    double sum = bar[0] + bar[1] + bar[2] + bar[3];
    int i;

    for (i = 0; i < 4; i++)
        if (!(bar[i] > 1e-3) || 2 * bar[i] > sum * (1 - 1e-4))
            return 0;
    return 1;
}

static void draw_four_bar(void)
{
    int i, how = one_of(10);

    do {
        for (i = 0; i < 4; i++)
            bar[i] = is_wild ? between(0.1, 1) : between(0.5, 1.4);
        if (!is_wild)
            bar[1] = between(0.1, 0.6);
        else if (how < 3)
            bar[1] = between(how ? 0.05 : 0.003, 0.3); /* most of them crank-rockers */
        else if (how >= 7)
            draw_change_point();
        if (is_wild && how == 9)
            bar[one_of(4)] *= nearly_one();
    } while (!can_be_assembled());
}

static void draw_slider_crank(void)
{
    int how = one_of(10);

    bar[1] = is_wild ? between(0.1, 1) : between(0.1, 0.6);
    bar[2] = is_wild ? bar[1] * between(1.2, 4) : between(0.9, 2.5);
    guide_offset = is_wild ? bar[1] * between(-0.3, 0.3) : between(-0.1, 0.1);
    if (is_wild && seldom(0.5))
        guide_offset = 0;
    if (is_wild && how < 2)
        bar[2] = bar[1] * between(0.4, 1.2);
    if (is_wild && how >= 8) {
        bar[1] = (2 + one_of(14)) / 16.0;
        guide_offset = guide_offset != 0 ? bar[1] / 2 * either_sign() : 0;
        bar[2] = bar[1] + guide_offset;
    }
    if (is_wild && how == 9)
        bar[2] *= nearly_one();
}

/* Crank and slotted lever, Whitworth's quick return, oscillating cylinder. */
static void draw_inverted(void)
{
    bar[0] = is_wild ? between(0.2, 1) : between(0.7, 1.5);
    bar[1] = is_wild ? bar[0] * between(0.2, 2.5) : between(0.1, 0.6);
    guide_offset = is_wild ? bar[1] * between(-0.5, 0.5) : between(-0.05, 0.05);
    if (is_wild && seldom(0.5))
        guide_offset = 0;
    if (is_wild && seldom(0.2)) {
        bar[0] = (1 + one_of(15)) / 16.0;
        bar[1] = (1 + one_of(15)) / 16.0;
        guide_offset = bar[1] - bar[0];
    }
}

static void draw_yoke(void)
{
    bar[1] = is_wild ? between(0.1, 1) : between(0.1, 0.6);
    guide_offset = is_wild ? bar[1] * between(-1, 1) : between(-0.3, 0.3);
    if (is_wild && seldom(0.5))
        guide_offset = 0;
}

static void draw_lengths(void)
{
    static void (*const draw[])(void) = {draw_four_bar, draw_slider_crank, draw_inverted,
                                         draw_yoke};
    int i;

    reach = is_wild ? power_of_ten(-1.5, 0.5) : 0.1;
    for (i = 0; i < 4; i++)
        bar[i] = 0;
    guide_offset = 0;
    draw[machine]();
    for (i = 0; i < 4; i++)
        bar[i] *= reach;
    guide_offset *= reach;
}

/* ------------------------------------------------------------------------------------------- bodies */

static int has_bodies; /* 0: links have no masses */

static void write_body(double most)
{
    if (!has_bodies || (is_wild && seldom(0.15)))
        return;
    write("mass = %.6g kg\n", between(0.1, 3));
    if (seldom(0.5))
        write_length("gyration", most * between(0.1, 1));
    else
        write("inertia = %.6g kg m2\n", between(0.001, 0.2) * most);
    if (is_wild && seldom(0.5))
        write("cg = (%.17g, %.17g) m\n", between(-0.1, 1) * most,
              seldom(0.5) ? 0 : between(-0.3, 0.3) * most);
    else if (!is_wild || seldom(0.6))
        write("cg = %.6g mm at %.6g deg\n", 1e3 * between(0, most), between(-20, 20));
}

static void write_ground(void)
{
    write("[ground]\n");
    if (machine == A_FOUR_BAR || machine == AN_INVERTED)
        write_length("length", bar[0]);
    if (machine == A_SLIDER_CRANK || machine == A_YOKE)
        write_length("offset", guide_offset);
    if (is_wild && seldom(0.3))
        write("angle = %.17g deg\n", between(-180, 180));
}

/* A mechanism of `machine`, with its bodies. */
static void write_machine(void)
{
    draw_lengths();
    write("mechanism = %s\n", machine_names[machine]);
    write_ground();
    write("[crank]\n");
    write_length("length", bar[1]);
    write_body(bar[1]);
    write("[%s]\n", machine_links[machine][1]);
    if (bar[2] != 0)
        write_length("length", bar[2]);
    write_body(bar[2] != 0 ? bar[2] : reach / 5);
    write("[%s]\n", machine_links[machine][2]);
    if (machine == A_FOUR_BAR)
        write_length("length", bar[3]);
    if (machine == AN_INVERTED)
        write_length("offset", guide_offset);
    if (machine == A_YOKE && seldom(0.6))
        write("angle = %.6g deg\n", is_wild && seldom(0.1) ? between(2, 10) : between(30, 150));
    if (machine != A_SLIDER_CRANK)
        write_body(reach);
    else if (has_bodies && !(is_wild && seldom(0.2)))
        write("mass = %.6g kg\n", between(0.1, 3));
}

/* ------------------------------------------------------------------------------------------- what acts on it */

static double typical_speed, typical_torque; /* rad/s, N m */
static double load_cycle = 360;              /* deg */

static double load_size(void)
{
    return either_sign() * power_of_ten(-1, 2);
}

static const char *load_key(const char *link)
{
    return slides_only(link) ? "force" : "torque";
}

static const char *load_unit(const char *link)
{
    return slides_only(link) ? "N" : "N m";
}

/* A curve of n points, at arguments that rise from low to high, in a unit_name; each of a size, in its unit_name. */
static void write_points(const char *key, double low, double high, int n, const char *unit_name,
                         const char *size_unit)
{
    int i;

    write("%s = ", key);
    for (i = 0; i < n; i++)
        write("%s%.6g %s %.6g %s", i ? ", " : "", low + (high - low) * (i + between(0.1, 0.9)) / n,
              unit_name, load_size(), size_unit);
    write("\n");
}

static void write_constant_load(const char *link)
{
    int has_torque = !slides_only(link) && seldom(0.5);

    if (has_torque)
        write("torque = %.6g N m\n", between(-20, 20));
    if (!has_torque || (is_wild && seldom(0.4))) {
        if (slides_only(link) && seldom(0.5)) {
            write("force = %.6g N\n", between(-300, 300));
            return;
        }
        write("force = (%.6g, %.6g) N\n", between(-200, 200), between(-200, 200));
        if (!slides_only(link))
            write("at = (%.6g, %.6g) mm\nframe = %s\n", 1e3 * reach * between(-0.2, 1),
                  1e3 * reach * between(-0.3, 0.3), seldom(0.5) ? "link" : "ground");
    }
}

/* It acts over a part of the cycle alone. */
static void write_window(void)
{
    double from = is_wild ? between(-180, 500) : one_of(300);
    double to = from + (is_wild ? between(1, 0.9 * load_cycle) : between_whole(20, 60));

    write("from = %.17g deg\nto = %.17g deg\n", from, to);
}

static void write_load_over_speed(const char *name)
{
    static const char *const choices[4][3][3] = {
        {{"crank", "omega2", "rad/s"},
         {"rocker", "omega4", "rad/s"},
         {"rocker", "omega4", "rad/s"}},
        {{"crank", "omega2", "rad/s"}, {"piston", "v", "m/s"}, {"piston", "v", "m/s"}},
        {{"crank", "omega2", "rad/s"}, {"lever", "omega4", "rad/s"}, {"lever", "slide_v", "m/s"}},
        {{"crank", "omega2", "rad/s"}, {"yoke", "v", "m/s"}, {"yoke", "slide_v", "m/s"}}};
    static const char *const exponents[] = {"1", "1.5", "2", "3"};
    const char *const *choice = choices[machine][one_of(3)];
    double fast = typical_speed * (strcmp(choice[2], "m/s") ? 1 : reach / 2);

    write("[load %s]\nlink = %s\nover = %s\n", name, choice[0], choice[1]);
    if (seldom(0.7))
        write("%s = -%.6g %s\nat_speed = %.6g %s\nexponent = %s\n", load_key(choice[0]),
              power_of_ten(-1, 1.5), load_unit(choice[0]), fast, choice[2], exponents[one_of(4)]);
    else
        write_points(load_key(choice[0]), -fast, fast, between_whole(2, 6), choice[2],
                     load_unit(choice[0]));
}

static void write_load_over_position(const char *name)
{
    static const struct {
        const char *link, *over, *unit_name;
        double low, high; /* of lengths, of `reach` */
    } choices[4][2] = {{{"rocker", "theta4", "deg", 0, 360}, {"rocker", "theta4", "deg", 0, 360}},
                       {{"piston", "x", "m", 0, 1.2}, {"piston", "x", "m", 0, 1.2}},
                       {{"lever", "theta4", "deg", 0, 360}, {"lever", "slide", "m", 0.1, 2}},
                       {{"yoke", "x", "m", 0, 1.2}, {"yoke", "slide", "m", -0.5, 0.5}}};
    int i = one_of(2);
    const char *link = choices[machine][i].link;
    double times = strcmp(choices[machine][i].unit_name, "m") ? 1 : reach;

    write("[load %s]\nlink = %s\nover = %s\n", name, link, choices[machine][i].over);
    write_points(load_key(link), times * choices[machine][i].low, times * choices[machine][i].high,
                 between_whole(3, 6), choices[machine][i].unit_name, load_unit(link));
    if (seldom(0.5))
        write("back = %.6g %s\n", load_size(), load_unit(link));
}

/* Loads K and on, at most so many; with some over speeds and positions. */
static void write_loads(int most, int has_laws)
{
    char name[2] = "K";

    for (most = one_of(most + 1); most > 0; most--, name[0]++) {
        const char *link = any_link();
        int sort = one_of(has_laws ? 5 : 3);

        if (sort == 3) {
            write_load_over_speed(name);
            continue;
        }
        if (sort == 4) {
            write_load_over_position(name);
            continue;
        }
        write("[load %s]\nlink = %s\n", name, link);
        if (sort == 2)
            write_points(load_key(link), 0, load_cycle, between_whole(3, 12), "deg",
                         load_unit(link));
        else
            write_constant_load(link);
        if (sort < 2 && seldom(0.3))
            write_window();
    }
}

static void write_gas(void)
{
    int n = between_whole(3, 12), i;

    if (machine == A_FOUR_BAR)
        return;
    write("[gas]\n");
    write_length("bore", bar[1] * between(0.1, 0.5));
    if (is_wild && seldom(0.4)) {
        write("pressure = %.17g Pa\n", between(0, 2e6));
        return;
    }
    write("indicator = ");
    for (i = 0; i < n; i++)
        write("%s%.6g deg %.6g bar", i ? ", " : "", load_cycle * (i + between(0.1, 0.9)) / n,
              between(0, 20));
    write("\n");
}

/* A spring, a damper or both: of the last link or the crank, about its pin, or between two links or a link and the ground. */
static void write_spring(const char *name)
{
    const char *link = seldom(0.7) ? machine_links[machine][2] : any_link(), *to = "ground";
    int turns = !slides_only(link) && strcmp(link, machine_links[machine][1]) && seldom(0.5);

    write("[spring %s]\nlink = %s\n", name, link);
    if (turns) {
        write("to = ground\n");
        if (seldom(0.7))
            write("stiffness = %.6g N m/rad\n", between(0.1, 20));
        else
            write("damping = %.6g N m s/rad\n", power_of_ten(-3, 0));
        return;
    }
    if (seldom(0.3))
        while (strcmp(to, "ground") == 0 || strcmp(to, link) == 0)
            to = any_link();
    write("to = %s\nat = (%.6g, 0) mm\nto_at = (%.6g, %.6g) mm\n", to,
          1e3 * reach * between(0, slides_only(link) ? 0.01 : 0.6), 1e3 * reach * between(1, 2.5),
          1e3 * reach * between(1, 2.5));
    if (seldom(0.8))
        write("stiffness = %.6g N/m\nfree_length = %.6g mm\n", between(10, 3000),
              1e3 * reach * between(0.5, 2));
    else
        write("damping = %.6g N s/m\n", between(0.1, 20));
}

static void write_friction(void)
{
    static const char *const pins[] = {"ABC", "ABC", "ABD", "AB"};
    const char *pin;

    write("[friction]\n");
    for (pin = pins[machine]; *pin; pin++)
        write("%c = %.6g\nradius_%c = %.6g mm\n", *pin, between(0.02, 0.15), *pin,
              1e3 * reach * between(0.02, 0.08));
    if (machine != A_FOUR_BAR)
        write("guide = %.6g\n", between(0.02, 0.15));
    if (machine != A_FOUR_BAR && seldom(0.3))
        write("guide_length = %.6g mm\n", 1e3 * reach * between(0.3, 0.8));
    if (machine == A_YOKE) {
        write("slot = %.6g\n", between(0.02, 0.15));
        if (seldom(0.5))
            write("slot_length = %.6g mm\n", 1e3 * reach * between(0.1, 0.4));
    }
}

static void write_tracer_points(int most)
{
    char name[3] = "P0";

    for (most = one_of(most + 1); most > 0; most--, name[1]++)
        write("[point %s]\nlink = %s\nat = (%.6g, %.6g) mm\n", name, any_link(),
              1e3 * reach * between(-1, 1.6), seldom(0.5) ? 0 : 1e3 * reach * between(-1, 1));
}

static void write_gravity(void)
{
    write("[gravity]\nacceleration = %s m/s2\ndirection = %.17g deg\n", seldom(0.5) ? "0" : "9.81",
          between(-180, 180));
}

/* ------------------------------------------------------------------------------------------- given motions */

/* From rest, speeding up or slowing down until it stops, over a part of a turn or several, from a far angle. */
static void write_wild_range(int way)
{
    double from = seldom(0.5) ? 0 : between(-360, 360), range = load_cycle, speed = typical_speed;

    write("cycle = %g deg\n", load_cycle);
    switch (one_of(8)) {
    case 0:
        write("run_up = %.17g deg\nacceleration = %.17g rad/s2\n", between(5, 400),
              way * between(1, 100));
        return;
    case 1:
        write("acceleration = %.17g rad/s2\n", between(-0.1, 0.1) * speed * speed);
        range = between(30, 500);
        break;
    case 2:
        write("hold = yes\nacceleration = %.17g rad/s2\n", between(-1, 1) * speed * speed);
        break;
    case 3:
        range = between(30, 360);
        break;
    case 4:
        range = between(360, 1500);
        break;
    default:
        break;
    }
    write("speed = %.17g rad/s\n", way * speed);
    if (from != 0 || range != load_cycle)
        write("from = %.17g deg\nto = %.17g deg\n", from, from + way * range);
}

static void write_given_motion(void)
{
    int way = either_sign();

    write("[motion]\ninterval = %d deg\n", is_wild ? between_whole(1, 31) : 10);
    if (is_wild) {
        write_wild_range(way);
        return;
    }
    write("speed = %.6g rad/s\n", way * typical_speed);
    if (seldom(0.3))
        write("acceleration = %.6g rad/s2\nhold = yes\n", between(-5, 40));
}

/* One crank angle. */
static inline void write_instant(void)
{
    write("[motion]\nat = %.6g deg\nspeed = %.6g rad/s\n", between(-400, 400),
          either_sign() * typical_speed);
    if (seldom(0.5))
        write("acceleration = %.6g rad/s2\nhold = yes\n", between(-300, 300));
}

static const char *const laws_of_programs[] = {
    "spline",        "harmonic", "cycloidal",           "3-4-5",  "4-5-6-7",
    "modified-sine", "cubic",    "trapezoid 30 % 20 %", "linear", "trapezoid"};
static double program_times[10]; /* s */
static int n_program_times;

static void write_program(void)
{
    char number[40];
    int n = between_whole(2, 7), is_of_speed = seldom(0.3), i;
    double time = seldom(0.7) ? 0 : between(-1, 1),
           value = is_of_speed ? between(-9, 9) : between(-200, 200), first = value;

    write("[motion]\nprogram = ");
    n_program_times = n;
    for (i = 0; i < n; i++) {
        snprintf(number, sizeof number, "%.6g", time);
        program_times[i] = atof(number);
        write("%s%.6g s %.8g %s", i ? ", " : "", time, value, is_of_speed ? "rad/s" : "deg");
        if (i && seldom(0.2))
            write(" %s", laws_of_programs[one_of(10)]);
        time += power_of_ten(-1.5, 0.5);
        if (!seldom(0.2))
            value = is_of_speed ? between(-9, 9) : value + between(-200, 300);
        if (i + 2 == n && seldom(0.3))
            value = is_of_speed ? first : first + 360 * one_of(3);
    }
    write("\nlaw = %s\n", laws_of_programs[seldom(0.5) ? 0 : one_of(10)]);
    if (is_of_speed)
        write("program_of = speed\nfrom = %.6g deg\n", between(-90, 90));
}

/* -------------------------------------------------------------------- motions that follow from what drives the machine */

enum { FREE, RUN_UP, STEADY };
enum { MOTOR_TORQUE, MOTOR_STALL, MOTOR_CURVE, MOTOR_POWER, MOTOR_CONSTANT };

/* A motor that drives one way, +-1, some with a gear; returns its sort. */
static int write_motor(int mode, int way)
{
    int sort = one_of(mode == STEADY ? 6 : 4), turn;
    double ratio = seldom(0.6) ? 1 : either_sign() * power_of_ten(-0.5, 1), T, w;

    turn = way * (ratio < 0 ? -1 : 1);
    T = turn * typical_torque / fabs(ratio);
    w = turn * typical_speed * fabs(ratio);
    write("[motor]\n");
    if (sort >= MOTOR_CONSTANT) {
        sort = MOTOR_CONSTANT;
        write("torque = constant\n");
    } else if (sort == MOTOR_TORQUE)
        write("torque = %.6g N m\n", T);
    else if (sort == MOTOR_STALL)
        write("stall_torque = %.6g N m\nno_load_speed = %.6g rad/s\n", T, w);
    else if (sort == MOTOR_POWER)
        write("power = %.6g W\nmax_torque = %.6g N m\n", T * w / 4, T);
    else {
        double at[5] = {0, 0.4 * w, 0.8 * w, w, 1.2 * w},
               torque[5] = {T, T * between(0.6, 1.2), T * between(0.8, 1.8), 0,
                            -T * between(0.5, 1.5)};
        int n = seldom(0.5) ? 5 : 4, i;

        write("curve = ");
        for (i = 0; i < n; i++) {
            int k = w > 0 ? i : n - 1 - i;

            write("%s%.6g rad/s %.6g N m", i ? ", " : "", at[k], torque[k]);
        }
        write("\n");
    }
    if (seldom(0.4))
        write("inertia = %.6g kg m2\n", power_of_ten(-3, 0) / (ratio * ratio));
    if (ratio != 1)
        write("ratio = %.6g\n", ratio);
    return sort;
}

static void write_driven_motion(int can_be_over_time)
{
    static const char *const modes[] = {"free", "run-up", "steady"};
    static const double turns[] = {0.5, 1, 2, 3};
    static const int intervals[] = {7, 10, 15};
    double from = seldom(0.5) ? 5.0 * between_whole(-20, 60) : 0;
    int mode = one_of(3), way = seldom(0.3) ? -1 : 1,
        sort = mode != FREE || seldom(0.6) ? write_motor(mode, way) : -1;

    if (sort == MOTOR_CONSTANT && seldom(0.3))
        write("[flywheel]\nfluctuation = %.6g\nexact = yes\n", power_of_ten(-2, 0));
    else if (seldom(0.8))
        write("[flywheel]\ninertia = %.6g kg m2\n", power_of_ten(-2.5, 0.5));
    write("[motion]\nmode = %s\nfrom = %.6g deg\n", modes[mode], from);
    if (mode == FREE)
        write("speed = %.6g rad/s\n", way * typical_speed * between(0.3, 1.5));
    if (sort == MOTOR_CONSTANT)
        write("mean_speed = %.6g rad/s\n", way * typical_speed);
    if (can_be_over_time && mode != STEADY && seldom(0.2))
        write("rows = time\nduration = %.6g s\ntime_step = %.6g s\n", 10 / typical_speed,
              0.2 / typical_speed);
    else
        write("turns = %.6g\ninterval = %d deg\n", way * (mode == STEADY ? 1 : turns[one_of(4)]),
              intervals[one_of(3)]);
    write("[table]\nbranch = %s\n", machine == A_YOKE || seldom(0.5) ? "open" : "crossed");
}

/* ------------------------------------------------------------------------------------------- a machine */

enum {
    WILD = 1,
    LAWS = 2, /* loads over speeds and positions */
    SPRINGS = 4,
    FRICTION = 8,
    POINTS = 16,
    GRAVITY = 32,
    GAS = 64,
    EVERYTHING = LAWS | SPRINGS | FRICTION | POINTS | GRAVITY | GAS
};
typedef enum motion_sort { GIVEN, AN_INSTANT, PROGRAM, DRIVEN } motion_sort;

/* Every fourth machine is a Scotch yoke, the others are of the other kinds in turn. */
static void choose_machine(long number)
{
    length = 0;
    machine = number % 4 == 3 ? A_YOKE : (int)(number % 3);
}

/* A deck with a motion, and some of what it may have: bits of the list above. */
static inline void make_machine(long number, int may_have, motion_sort sort)
{
    int has_friction = (may_have & FRICTION) && seldom(0.3);

    choose_machine(number);
    is_wild = (may_have & WILD) != 0;
    has_bodies = 1;
    load_cycle = is_wild && sort == GIVEN && seldom(0.2) ? 720 : 360;
    typical_speed = sort == DRIVEN ? power_of_ten(0.6, 2.1) : power_of_ten(0, is_wild ? 2.5 : 1.5);
    typical_torque = power_of_ten(0.3, 2.2);
    if (is_wild && seldom(0.9))
        write("solver = dyad\n");
    write_machine();
    write_loads(sort == DRIVEN ? 4 : 2, may_have & LAWS);
    if ((may_have & GAS) && seldom(0.3))
        write_gas();
    if ((may_have & SPRINGS) && seldom(0.3))
        write_spring("S");
    if ((may_have & SPRINGS) && seldom(0.1))
        write_spring("T");
    if (has_friction)
        write_friction();
    if ((may_have & GRAVITY) && seldom(0.5))
        write_gravity();
    if (may_have & POINTS)
        write_tracer_points(2);
    switch (sort) {
    case GIVEN:
        write_given_motion();
        break;
    case AN_INSTANT:
        write_instant();
        break;
    case PROGRAM:
        write_program();
        break;
    default:
        write_driven_motion(!has_friction);
    }
}

#endif
