/* SPDX-License-Identifier: GPL-3.0-or-later
**
** random_outputs.h - random machines with outputs, for trials in C.
*/
#ifndef RANDOM_OUTPUTS_H
#define RANDOM_OUTPUTS_H

#include "random_parts.h"

static void write_masses_of_output(const char *front)
{
    write("%smass = %.6g kg\n%scg = (%.6g, %.6g) mm\n%sgyration = %.6g mm\n", front,
          between(0.1, 3), front, between(-20, 80), between(-20, 20), front, between(5, 60));
}

static int with_slots;  /* 1: most hang by a slot */
static int has_slot[3]; /* by number of the output: its block takes nothing */

/* A link, of the machine or of an output before, other than `other`, by its number, which is returned. */
static int write_any_link(const char *key, int outputs, int other)
{
    int i;

    do
        i = one_of(3 + 2 * outputs);
    while (i == other || (i > 3 && i % 2 == 0 && has_slot[(i - 3) / 2]));
    if (i < 3)
        write("%s = %s\n", key, machine_links[machine][i]);
    else
        write("%s = %c%s\n", key, 'P' + (i - 3) / 2, (i - 3) % 2 ? ".rod" : "");
    return i;
}

/* The slot of an output, of its own or of the carrying link; the rest as write_output has it. */
static void write_slot(int slides)
{
    int is_own = seldom(0.5);

    write("at = (%.6g, %.6g) mm\nslot = %s\n", between(-40, 80), between(-40, 40),
          is_own ? "output" : "link");
    if (slides || !is_own)
        write("slot_angle = %.6g deg\n", is_own ? between(15, 165) : between(-180, 180));
    if (slides) {
        write("line = (%.6g, %.6g) mm\nangle = %.6g deg\n", between(-100, 200), between(-100, 100),
              between(-180, 180));
    } else {
        write("pivot = (%.6g, %.6g) mm\n", between(-200, 250), between(-200, 200));
        if (is_own)
            write("offset = %.6g mm\n", between(-40, 40));
        else
            write("length = %.6g mm\n", between(60, 350));
        if (seldom(0.5))
            write("side = behind\n");
    }
    write_masses_of_output("");
}

static void write_output(int number)
{
    int slides = seldom(0.5), carrier;

    write("[output %c]\n", 'P' + number);
    carrier = write_any_link("link", number, -1);
    has_slot[number] = with_slots && seldom(0.6);
    if (has_slot[number]) {
        write_slot(slides);
        return;
    }
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

/* A machine with up to three outputs, by rods or most of them by slots, which can hang on one another, and loads on them. */
static inline void make_machine_with_outputs(long number, int slots)
{
    int outputs = between_whole(1, 4), i;

    choose_machine(number);
    memset(has_slot, 0, sizeof has_slot);
    with_slots = slots;
    is_wild = 0;
    has_bodies = 1;
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
        write_spring("S");
    if (seldom(0.2))
        write_friction();
    write("[point Z]\n");
    write_any_link("link", outputs, -1);
    write("at = (%.6g, %.6g) mm\n", between(-40, 80), between(-40, 40));
    write("[motion]\nspeed = %.6g rad/s\ninterval = 10 deg\n", between(-30, 30));
    if (seldom(0.3))
        write("acceleration = %.6g rad/s2\nhold = yes\n", between(-5, 40));
}

#endif
