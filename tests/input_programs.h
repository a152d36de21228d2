/* SPDX-License-Identifier: GPL-3.0-or-later
**
** input_programs.h - random machines whose piston, yoke, rocker, lever, slide or cylinder goes by a random program over time;
** or an output, or the length of an actuator between any two links, for which there is no closed form.
**
** The range of the input is asked for first; then the program goes between values of it, some of them its ends, where the
** input is at its dead centre.
*/
#ifndef INPUT_PROGRAMS_H
#define INPUT_PROGRAMS_H

#include "fourlink.h"
#include "random_outputs.h"

typedef struct input_choice {
    const char *name, *value, *rate, *second; /* columns */
    const char *unit, *drive;
    int machines; /* bits */
} input_choice;

static const input_choice inputs[] = {
    {"theta4", "theta4", "omega4", "alpha4", "rad", "rocker", 1 << A_FOUR_BAR},
    {"theta4", "theta4", "omega4", "alpha4", "rad", "lever", 1 << AN_INVERTED},
    {"slide", "slide", "slide_v", "slide_a", "m", "slide", 1 << AN_INVERTED},
    {"x", "x", "v", "a", "m", "piston", 1 << A_SLIDER_CRANK},
    {"C.x", "x", "v", "a", "m", "piston", 1 << A_SLIDER_CRANK},
    {"x", "x", "v", "a", "m", "yoke", 1 << A_YOKE},
    {"C.x", "x", "v", "a", "m", "yoke", 1 << A_YOKE},
    {"ram.length", "ram.length", "ram.speed", "ram.acceleration", "m", "ram",
     1 << A_FOUR_BAR | 1 << A_SLIDER_CRANK | 1 << AN_INVERTED | 1 << A_YOKE}};

static int is_searched; /* 1: an output or the length of an actuator between any links */

static const input_choice searched[] = {
    {"P.x", "P.x", "P.v", "P.a", "m", "P", 0},
    {"P.theta", "P.theta", "P.omega", "P.alpha", "rad", "P", 0},
    {"Q.x", "Q.x", "Q.v", "Q.a", "m", "Q", 0},
    {"Q.theta", "Q.theta", "Q.omega", "Q.alpha", "rad", "Q", 0},
    {"ram.length", "ram.length", "ram.speed", "ram.acceleration", "m", "ram", 0}};

static const input_choice *input;
static double input_from, input_to; /* its range, rad or m */
static int input_is_whole;          /* 1: its program may go to the ends of the range */
static int is_by_crank;             /* 1: the crank drives all the same */
static const char *input_side, *input_branch;
static double input_near; /* deg, where the input has several ranges; else NaN */

/* 1 if an output slides on a line. */
static int slides_of(const char *header)
{
    const char *at, *end, *line;

    deck_text[length] = '\0';
    at = strstr(deck_text, header);
    end = strstr(at + 1, "\n[");
    line = strstr(at, "\nline = ");
    return line && (!end || line < end);
}

/* Write up to two outputs, and choose one of them or an actuator, on any links. */
static void choose_searched(void)
{
    int outputs = one_of(3), is_second = outputs == 2 && seldom(0.7), other, i;

    memset(has_slot, 0, sizeof has_slot);
    with_slots = seldom(0.5);
    for (i = 0; i < outputs; i++)
        write_output(i);
    if (!outputs || seldom(0.4)) {
        input = &searched[4];
        write("[actuator ram]\n");
        other = write_any_link("link", outputs, -1);
        write("at = (%.6g, %.6g) mm\n", between(-100, 300), between(-200, 200));
        if (seldom(0.4))
            write("to = ground\n");
        else
            write_any_link("to", outputs, other);
        write("to_at = (%.6g, %.6g) mm\n", between(-300, 300), between(-300, 300));
        return;
    }
    input = &searched[2 * is_second + !slides_of(is_second ? "[output Q]" : "[output P]")];
}

/* The machine without a motion. */
static void make_input_machine(long number)
{
    int i;

    make_machine(number, SPRINGS | FRICTION | (number % 4 == 1 || number % 8 == 7 ? WILD : 0),
                 AN_INSTANT);
    deck_text[length] = '\0';
    length = (size_t)(strstr(deck_text, "[motion]") - deck_text);
    if (is_searched) {
        choose_searched();
    } else {
        do
            i = one_of((int)(sizeof inputs / sizeof inputs[0]));
        while (!(inputs[i].machines & 1 << machine));
        input = &inputs[i];
    }
    input_side = seldom(0.5) ? "rising" : "falling";
    input_branch = machine == A_YOKE || seldom(0.5) ? "open" : "crossed";
    is_by_crank = seldom(0.4);
    if (strcmp(input->drive, "ram") == 0 && !is_searched)
        write("[actuator ram]\nlink = crank\nat = (%.6g, %.6g) mm\nto = ground\n"
              "to_at = (%.6g, %.6g) mm\n",
              between(50, 500), between(-200, 200), between(-500, 500), between(-900, -100));
    write("[table]\ncolumns = all\nbranch = %s\n[motion]\ndrive = %s\n", input_branch,
          is_by_crank ? "crank" : input->drive);
}

static void write_input(void)
{
    write("input = %s\nside = %s\n", input->name, input_side);
    if (input_near == input_near)
        write("near = %.6g deg\n", input_near);
}

/* The lines of the input without its program, over all of its range. */
static void write_input_range(void)
{
    write_input();
    write("speed = 1 %s/s\n", input->unit);
}

static void write_input_program(void)
{
    int n = between_whole(2, 7), is_of_speed = seldom(0.2), i;
    int law = seldom(0.2) ? 0 : one_of(10), is_whole = law != 0 && seldom(0.4) && !is_of_speed;
    double low = is_whole ? 0 : between(0.02, 0.4), high = is_whole ? 1 : between(0.6, 0.98);
    double time = seldom(0.7) ? 0 : between(-1, 1), width = input_to - input_from, part, pace, T;

    input_is_whole = is_whole;
    part = is_whole && seldom(0.5) ? one_of(2) : between(low, high);
    write_input();
    write("program = ");
    if (is_of_speed) { /* there, and back again */
        T = power_of_ten(-1, 0.5);
        pace = width * between(0.2, 0.5) / T;
        write("%.17g s 0 %s/s, %.17g s %.17g %s/s, %.17g s %.17g %s/s, %.17g s 0 %s/s\n", time,
              input->unit, time + T / 2, pace, input->unit, time + T, -pace, input->unit,
              time + 1.5 * T, input->unit);
        write("program_of = speed\nfrom = %.17g %s\n", input_from + width * between(0.1, 0.4),
              input->unit);
        program_times[0] = time;
        program_times[1] = time + T / 2;
        program_times[2] = time + T;
        program_times[3] = time + 1.5 * T;
        n_program_times = 4;
        write("law = %s\n", laws_of_programs[1 + one_of(9)]);
        return;
    }
    n_program_times = n;
    for (i = 0; i < n; i++) {
        program_times[i] = time;
        write("%s%.17g s %.17g %s", i ? ", " : "", time,
              part <= 0   ? input_from
              : part >= 1 ? input_to
                          : input_from + width * part,
              input->unit);
        time += power_of_ten(-1.5, 0.5);
        if (!seldom(0.2))
            part = is_whole && seldom(0.3) ? one_of(2) : between(low, high);
    }
    write("\nlaw = %s\n", laws_of_programs[law]);
}

#endif
