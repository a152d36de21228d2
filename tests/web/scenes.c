/* SPDX-License-Identifier: GPL-3.0-or-later
**
** scenes.c - what the page draws of a deck, by its own program compiled for this machine.
**
**    scenes DECK [FRAMES EVERY]
**
** Prints the scene as JSON, with the crank angle where the page begins, "from".  With the name of a file, that gets every so many of the drawings as they were before they became one
** motion: lines "@ PANEL STEP", each before an SVG. Exit status 1: there is none.
*/
#include "drawing/svg.h"
#include "program.c"

static FILE *frames;
static size_t every;
static long panel = -1;

/* The command is not called. */
int web_main(int argc, char **argv)
{
    (void)argc;
    (void)argv;
    return 3;
}

/* The linker calls these in place of motion_add. */
void __real_motion_add(motion *m, size_t step, const display *d);
void __wrap_motion_add(motion *m, size_t step, const display *d);

void __wrap_motion_add(motion *m, size_t step, const display *d)
{
    panel += m->n_items == 0;
    if (frames && step % every == 0) {
        fprintf(frames, "@ %ld %lu\n", panel, (unsigned long)step);
        svg_write(frames, d, "", "", 1);
    }
    __real_motion_add(m, step, d);
}

static char *read_file(const char *path, size_t *length)
{
    FILE *in = fopen(path, "rb");
    char *text = calloc(1, 1 << 20);

    if (!in || !text)
        exit(2);
    *length = fread(text, 1, (1 << 20) - 1, in);
    fclose(in);
    return text;
}

int main(int argc, char **argv)
{
    size_t length = 0, name = argc > 1 ? strlen(argv[1]) + 1 : 0;
    char *text, *room;

    if (argc != 2 && argc != 4)
        return 2;
    if (argc == 4) {
        frames = fopen(argv[2], "w");
        every = strtoul(argv[3], NULL, 10);
        if (!frames || !every)
            return 2;
    }
    text = read_file(argv[1], &length);
    room = web_room(name + length);
    if (!room)
        return 2;
    memcpy(room, argv[1], name);
    memcpy(room + name, text, length + 1);
    free(text);
    if (web_open(name, length, 1, 0) != FOURLINK_OK || !web_scene(0, v.problem.motion.from, 0)) {
        fprintf(stderr, "%s", web_answer() ? web_answer() : "nothing");
        return 1;
    }
    printf("{\"from\":%.17g,%s", v.problem.motion.from, web_answer() + 1);
    return frames && fclose(frames) != 0;
}
