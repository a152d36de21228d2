/* SPDX-License-Identifier: GPL-3.0-or-later
**
** random_machine.h - a random deck with more that acts on the links than random_deck.h knows: springs, dampers, friction,
** motors, loads over positions and speeds.
*/
#ifndef RANDOM_MACHINE_H
#define RANDOM_MACHINE_H

#include <string.h>

#include "random_deck.h"

static int machine; /* A_FOUR_BAR ... */
static const char *const machine_names[] = {"four-bar", "slider-crank", "inverted-slider-crank",
                                            "scotch-yoke"};
static const char *const machine_links[][3] = {{"crank", "coupler", "rocker"},
                                               {"crank", "rod", "piston"},
                                               {"crank", "slider", "lever"},
                                               {"crank", "slider", "yoke"}};

/* Every fourth machine is a Scotch yoke, the others are of the other kinds in turn. */
static void choose_machine(long number)
{
    length = 0;
    machine = number % 4 == 3 ? A_YOKE : (int)(number % 3);
}

/* Leave the deck as a file of the present folder. */
static inline void leave_deck(const char *sort, long number)
{
    char name[100];
    FILE *out;

    snprintf(name, sizeof name, "%s-%ld.deck", sort, number);
    out = fopen(name, "w");
    if (!out)
        return;
    fwrite(deck_text, 1, length, out);
    fclose(out);
}

static double power_of_ten(double low, double high)
{
    return pow(10, between(low, high));
}

static int between_whole(int low, int high) /* low ... high - 1 */
{
    return low + one_of(high - low);
}

static void write_body(double size)
{
    write("mass = %.6g kg\n", between(0.1, 3));
    write("cg = %.6g mm at %.6g deg\n", between(0, size), between(-20, 20));
    write("gyration = %.6g mm\n", between(5, size > 5 ? size : 6));
}

static void write_machine(void)
{
    double crank = between(10, 60), coupler, rocker, ground, longest;

    write("mechanism = %s\n[crank]\nlength = %.6g mm\n", machine_names[machine], crank);
    write_body(crank);
    switch (machine) {
    case A_FOUR_BAR:
        do {
            coupler = between(50, 140);
            rocker = between(50, 140);
            ground = between(50, 120);
            longest = fmax(fmax(crank, coupler), fmax(rocker, ground));
        } while (2 * longest >= crank + coupler + rocker + ground);
        write("[coupler]\nlength = %.6g mm\n", coupler);
        write_body(50);
        write("[rocker]\nlength = %.6g mm\n", rocker);
        write_body(50);
        write("[ground]\nlength = %.6g mm\n", ground);
        break;
    case A_SLIDER_CRANK:
        write("[rod]\nlength = %.6g mm\n", between(90, 250));
        write_body(80);
        write("[piston]\nmass = %.6g kg\n[ground]\noffset = %.6g mm\n", between(0.1, 3),
              between(-10, 10));
        break;
    case AN_INVERTED:
        write("[ground]\nlength = %.6g mm\n[slider]\n", between(70, 150));
        write_body(30);
        write("[lever]\noffset = %.6g mm\n", between(-5, 5));
        write_body(100);
        break;
    default:
        write("[ground]\noffset = %.6g mm\n[slider]\n", between(-30, 30));
        write_body(10);
        write("[yoke]\n");
        if (seldom(0.6))
            write("angle = %.6g deg\n", between(40, 140));
        write_body(100);
        break;
    }
}

static int slides_only(const char *link)
{
    return strcmp(link, "piston") == 0 || strcmp(link, "yoke") == 0;
}

static void write_load(const char *link)
{
    int begin;

    if (slides_only(link))
        write("force = %.6g N\n", between(-300, 300));
    else if (seldom(0.5))
        write("torque = %.6g N m\n", between(-10, 10));
    else
        write("force = (%.6g, %.6g) N\nat = (%.6g, %.6g) mm\n", between(-200, 200),
              between(-200, 200), between(0, 60), between(-20, 20));
    if (seldom(0.3)) {
        begin = one_of(300);
        write("from = %d deg\nto = %d deg\n", begin, begin + between_whole(20, 60));
    }
}

static void write_spring(void)
{
    const char *link = machine_links[machine][2];
    int turns = !slides_only(link) && seldom(0.5);

    write("[spring S]\nlink = %s\nto = ground\n", link);
    if (turns)
        write("stiffness = %.6g N m/rad\n", between(0.1, 20));
    else
        write("at = (%.6g, 0) mm\nto_at = (%.6g, %.6g) mm\nstiffness = %.6g N/m\nfree_length = "
              "%.6g mm\n",
              between(0, strcmp(link, "piston") ? 60 : 1), between(100, 250), between(100, 250),
              between(10, 3000), between(50, 200));
    if (seldom(0.4))
        write("damping = %.6g %s\n", turns ? between(0.001, 0.1) : between(0.1, 20),
              turns ? "N m s/rad" : "N s/m");
}

static void write_friction(void)
{
    static const char *const pins[] = {"ABC", "ABC", "ABD", "AB"};
    const char *pin;

    write("[friction]\n");
    for (pin = pins[machine]; *pin; pin++)
        write("%c = %.6g\nradius_%c = %.6g mm\n", *pin, between(0.02, 0.15), *pin, between(2, 8));
    if (machine != A_FOUR_BAR)
        write("guide = %.6g\n", between(0.02, 0.15));
    if (machine == A_YOKE) {
        write("slot = %.6g\n", between(0.02, 0.15));
        if (seldom(0.5))
            write("slot_length = %.6g mm\n", between(10, 40));
    }
}

/* ---------------------------------------------------------------------------------------------- outputs */

static void write_masses_of_output(const char *front)
{
    write("%smass = %.6g kg\n%scg = (%.6g, %.6g) mm\n%sgyration = %.6g mm\n", front,
          between(0.1, 3), front, between(-20, 80), between(-20, 20), front, between(5, 60));
}

/* A link, of the machine or of an output before, other than `not`, by its number, which is returned. */
static int write_any_link(const char *key, int outputs, int not )
{
    int i;

    do
        i = one_of(3 + 2 * outputs);
    while (i == not );
    if (i < 3)
        write("%s = %s\n", key, machine_links[machine][i]);
    else
        write("%s = %c%s\n", key, 'P' + (i - 3) / 2, (i - 3) % 2 ? ".rod" : "");
    return i;
}

static void write_output(int number)
{
    int slides = seldom(0.5), carrier;

    write("[output %c]\n", 'P' + number);
    carrier = write_any_link("link", number, -1);
    write("at = (%.6g, %.6g) mm\nrod = %.6g mm\n", between(-40, 80), between(-40, 40),
          between(60, 300));
    if (slides) {
        write("line = (%.6g, %.6g) mm\nangle = %.6g deg\n", between(-100, 200), between(-100, 100),
              between(-180, 180));
    } else {
        write("length = %.6g mm\n", between(60, 250));
        if (seldom(0.7))
            write("pivot = (%.6g, %.6g) mm\n", between(-200, 250), between(-200, 200));
        else {
            write_any_link("to", number, carrier);
            write("to_at = (%.6g, %.6g) mm\n", between(-80, 120), between(-80, 80));
        }
    }
    if (seldom(0.5))
        write("side = %s\n", slides ? "behind" : "right");
    write_masses_of_output("");
    write_masses_of_output("rod_");
}

/* ------------------------------------------------------------------------------ a machine of any sort */

static void write_any_motion(void)
{
    static const char *const modes[] = {"run-up", "steady", "free"};
    int mode;

    if (seldom(0.25)) {
        mode = one_of(3);
        write("[motor]\nstall_torque = %.6g N m\nno_load_speed = %.6g rad/s\n", between(40, 200),
              between(10, 60));
        write("[flywheel]\ninertia = %.6g kg m2\n", between(0.3, 3));
        write("[motion]\nmode = %s\nturns = %d\n", modes[mode], mode == 1 ? 1 : 2);
        if (mode == 2)
            write("speed = %.6g rad/s\n", between(5, 30));
    } else {
        write("[motion]\nspeed = %.6g rad/s\n", between(-30, 30));
        if (seldom(0.3))
            write("acceleration = %.6g rad/s2\nhold = yes\n", between(-5, 40));
    }
    write("interval = 10 deg\n");
}

static inline void make_any_machine(long number)
{
    int loads, i;

    choose_machine(number);
    write_machine();
    loads = one_of(3);
    for (i = 0; i < loads; i++) {
        const char *link = machine_links[machine][one_of(3)];

        write("[load L%d]\nlink = %s\n", i, link);
        write_load(link);
    }
    if (seldom(0.3))
        write_spring();
    if (seldom(0.3))
        write_friction();
    write_any_motion();
}

/* The same with up to three outputs, which can hang on one another, and loads on them. */
static inline void make_machine_with_outputs(long number)
{
    int outputs = between_whole(1, 4), i;

    choose_machine(number);
    write_machine();
    for (i = 0; i < outputs; i++)
        write_output(i);
    for (i = 0; i < 3; i++) {
        write("[load L%d]\n", i);
        write_any_link("link", outputs, -1);
        write("force = (%.6g, %.6g) N\nat = (%.6g, %.6g) mm\ntorque = %.6g N m\n%s",
              between(-200, 200), between(-200, 200), between(0, 60), between(-20, 20),
              between(-10, 10), seldom(0.3) ? "frame = link\n" : "");
    }
    if (seldom(0.2))
        write_spring();
    if (seldom(0.2))
        write_friction();
    write("[point Z]\n");
    write_any_link("link", outputs, -1);
    write("at = (%.6g, %.6g) mm\n", between(-40, 80), between(-40, 40));
    write("[motion]\nspeed = %.6g rad/s\ninterval = 10 deg\n", between(-30, 30));
    if (seldom(0.3))
        write("acceleration = %.6g rad/s2\nhold = yes\n", between(-5, 40));
}

/* ------------------------------------------------------- a machine whose motion follows from what drives it */

enum { FREE, RUN_UP, STEADY };

static int mode, sense; /* of the motion: FREE ..., +-1 */
static double typical_speed, typical_torque;
static int has_friction, has_time_rows;

static double load_size(void)
{
    return power_of_ten(-1, 2) * (seldom(0.5) ? -1 : 1);
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

static void write_load_over_angle(const char *name)
{
    const char *link = machine_links[machine][one_of(3)];

    write("[load %s]\nlink = %s\n", name, link);
    write_points(load_key(link), 0, 360, between_whole(3, 8), "deg", load_unit(link));
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
    double reach = typical_speed * (strcmp(choice[2], "m/s") ? 1 : 0.05);

    write("[load %s]\nlink = %s\nover = %s\n", name, choice[0], choice[1]);
    if (seldom(0.7))
        write("%s = -%.6g %s\nat_speed = %.6g %s\nexponent = %s\n", load_key(choice[0]),
              power_of_ten(-1, 1.5), load_unit(choice[0]), reach, choice[2], exponents[one_of(4)]);
    else
        write_points(load_key(choice[0]), -reach, reach, between_whole(2, 6), choice[2],
                     load_unit(choice[0]));
}

static void write_load_over_position(const char *name)
{
    static const struct {
        const char *link, *over, *unit_name;
        double low, high;
    } choices[4][2] = {{{"rocker", "theta4", "deg", 0, 360}, {"rocker", "theta4", "deg", 0, 360}},
                       {{"piston", "x", "mm", 0, 120}, {"piston", "x", "mm", 0, 120}},
                       {{"lever", "theta4", "deg", 0, 360}, {"lever", "slide", "mm", 10, 200}},
                       {{"yoke", "x", "mm", 0, 120}, {"yoke", "slide", "mm", -50, 50}}};
    int i = one_of(2);
    const char *link = choices[machine][i].link;

    write("[load %s]\nlink = %s\nover = %s\n", name, link, choices[machine][i].over);
    write_points(load_key(link), choices[machine][i].low, choices[machine][i].high,
                 between_whole(3, 6), choices[machine][i].unit_name, load_unit(link));
    if (seldom(0.5))
        write("back = %.6g %s\n", load_size(), load_unit(link));
}

static void write_loads_of_motor(void)
{
    static const char *const names[] = {"K", "L", "M", "N"};
    int loads = one_of(5), i;

    for (i = 0; i < loads; i++) {
        int sort = one_of(5);
        const char *link = machine_links[machine][one_of(3)];

        if (sort == 2)
            write_load_over_angle(names[i]);
        else if (sort == 3)
            write_load_over_speed(names[i]);
        else if (sort == 4)
            write_load_over_position(names[i]);
        else {
            write("[load %s]\nlink = %s\n", names[i], link);
            write_load(link);
        }
    }
    if ((machine == A_SLIDER_CRANK || machine == A_YOKE) && seldom(0.2)) {
        int n = between_whole(3, 8);

        write("[gas]\nbore = %.6g mm\nindicator = ", between(10, 40));
        for (i = 0; i < n; i++)
            write("%s%.6g deg %.6g bar", i ? ", " : "", 360 * (i + between(0.1, 0.9)) / n,
                  between(0, 20));
        write("\n");
    }
    if (seldom(0.3))
        write_spring();
    if (seldom(0.2))
        write("[spring D]\nlink = crank\nto = ground\ndamping = %.6g N m s/rad\n",
              power_of_ten(-3, 0.5));
    if (has_friction) {
        write_friction();
        if (machine != A_FOUR_BAR && seldom(0.5))
            write("guide_length = %.6g mm\n", between(30, 80));
    }
}

enum { MOTOR_TORQUE, MOTOR_STALL, MOTOR_CURVE, MOTOR_POWER, MOTOR_CONSTANT };

/* A motor that drives in the sense of the range, some with a gear; returns its sort. */
static int write_motor(void)
{
    int sort = one_of(mode == STEADY ? 6 : 4), turn;
    double ratio = seldom(0.6) ? 1 : (seldom(0.5) ? -1 : 1) * power_of_ten(-0.5, 1), T, w;

    turn = sense * (ratio < 0 ? -1 : 1);
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

static void write_driven_motion(double from)
{
    static const char *const modes[] = {"free", "run-up", "steady"};
    static const double turns[] = {0.5, 1, 2, 3};
    static const int intervals[] = {7, 10, 15};
    int sort = mode != FREE || seldom(0.6) ? write_motor() : -1;

    if (sort == MOTOR_CONSTANT && seldom(0.3))
        write("[flywheel]\nfluctuation = %.6g\nexact = yes\n", power_of_ten(-2, 0));
    else if (seldom(0.8))
        write("[flywheel]\ninertia = %.6g kg m2\n", power_of_ten(-2.5, 0.5));
    write("[motion]\nmode = %s\nfrom = %.6g deg\n", modes[mode], from);
    if (mode == FREE)
        write("speed = %.6g rad/s\n", sense * typical_speed * between(0.3, 1.5));
    if (sort == MOTOR_CONSTANT)
        write("mean_speed = %.6g rad/s\n", sense * typical_speed);
    if (has_time_rows)
        write("rows = time\nduration = %.6g s\ntime_step = %.6g s\n", 10 / typical_speed,
              0.2 / typical_speed);
    else
        write("turns = %.6g\ninterval = %d deg\n", sense * (mode == STEADY ? 1 : turns[one_of(4)]),
              intervals[one_of(3)]);
    write("[table]\nbranch = %s\n", machine == A_YOKE || seldom(0.5) ? "open" : "crossed");
}

static inline void make_driven_machine(long number)
{
    double from;

    choose_machine(number);
    sense = seldom(0.3) ? -1 : 1;
    mode = one_of(3);
    typical_speed = power_of_ten(0.6, 2.1);
    typical_torque = power_of_ten(0.3, 2.2);
    has_friction = seldom(0.3);
    has_time_rows = mode != STEADY && !has_friction && seldom(0.2);
    from = seldom(0.5) ? 5.0 * between_whole(-20, 60) : 0;
    write_machine();
    write_loads_of_motor();
    write_driven_motion(from);
}

#endif
