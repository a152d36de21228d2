/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_program.c - builds the program of [motion]: the crank angle or the input, or its speed, over time.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "build.h"
#include "build_curve.h"
#include "build_program.h"
#include "curve_text.h"
#include "parser.h"
#include "pieces.h"
#include "settings.h"
#include "values.h"

#define STEPS 60 /* rows of a program, less one, without a time_step */

static flk_law find_law(text word)
{
    int law = 0;

    while (law < FLK_LAW_COUNT && !flk_text_equal(word, flk_law_names[law]))
        law++;
    return (flk_law)law;
}

/* ------------------------------------------------------------------------------------------------- laws */

/* Read the two ramps of a trapezoid, such as 20 % 30 %. */
static int read_ramps(parser *p, const setting *s, text rest, double ramp[2])
{
    quantity_value value;
    size_t i, k;

    for (k = 0; k < 2; k++) {
        text share = rest;

        for (i = 0; i < rest.length && rest.start[i] != '%'; i++)
            ;
        if (i == rest.length)
            break;
        share.length = i + 1;
        rest = flk_text_trim(flk_text_from(rest, i + 1));
        if (!flk_piece_quantity(p, s->place, flk_text_trim(share), s->value, QUANTITY_NUMBER,
                                &value))
            return 0;
        ramp[k] = value.si;
    }
    if (k < 2 || rest.length || !(ramp[0] >= 0 && ramp[1] >= 0 && ramp[0] + ramp[1] <= 1))
        return flk_mistake(p->mistakes, s->place,
                           "the ramps of a trapezoid are two shares of its time, together at most "
                           "100 %%, such as trapezoid 20 %% 30 %%");
    return 1;
}

/* Read a law, such as cycloidal, or trapezoid 20 % 30 %. */
static int read_law(parser *p, const setting *s, text t, flk_program_segment *g)
{
    text word = t, rest = t;

    if (!flk_text_cut(t, " ", &word, &rest))
        rest.length = 0;
    g->law = find_law(word);
    g->ramp[0] = g->ramp[1] = 1.0 / 3;
    if (g->law == FLK_LAW_COUNT || (rest.length && g->law != FLK_LAW_TRAPEZOID))
        return flk_mistake(p->mistakes, s->place,
                           "'%t' is not a law: spline, harmonic, cycloidal, 3-4-5, 4-5-6-7, "
                           "modified-sine, cubic, trapezoid or linear%h",
                           t, flk_text_nearest(word, flk_law_names));
    return !rest.length || read_ramps(p, s, flk_text_trim(rest), g->ramp);
}

/* The law at the end of a point, `0.4 s 90 deg cycloidal`; empty if it has none. */
static text law_of(text item)
{
    text rest = item, word, after, none = {NULL, 0};

    while (flk_text_cut(rest, " ", &word, &rest)) {
        if (!flk_text_cut(rest, " ", &word, &after))
            word = rest;
        if (find_law(word) != FLK_LAW_COUNT)
            return rest;
    }
    return none;
}

/* 1 if the last word of a point is no unit but all but the name of a law. */
static int is_mistyped(text item, text *word)
{
    text rest, bad;
    unit u;

    return flk_text_cut_last(item, " ", &rest, word) && !flk_unit_read(*word, &u, &bad) &&
           flk_text_nearest(*word, flk_law_names);
}

/* Read the laws of the points into the segments that end at them, and put blanks in their places. */
static int read_laws(parser *p, const setting *s, char *points, const flk_program_segment *usual,
                     flk_program_segment *g, size_t n)
{
    text rest = flk_text_of(points), item, law;
    size_t i;

    for (i = 0; flk_piece_item(&rest, &item); i++) {
        flk_program_segment *before = &g[i > 0 && i <= n ? i - 1 : 0];

        law = law_of(item);
        if (i > 0 && i <= n)
            *before = *usual;
        if (!law.length && !is_mistyped(item, &law))
            continue;
        if (i == 0)
            return flk_mistake(p->mistakes, s->place,
                               "the first point has no law: a law is that of the way to its point");
        if (!read_law(p, s, law, before))
            return 0;
        memset(points + (law.start - points), ' ', law.length);
    }
    return 1;
}

/* ------------------------------------------------------------------------------------------------- ends */

/* 1 if the last point is the first one again or, of angles, whole turns later. */
static int comes_back(const flk_program *x, double first, double last)
{
    double turn = 2 * M_PI, apart = last - first;

    if (!x->is_of_speed && x->is_angle)
        apart -= turn * floor(apart / turn + 0.5);
    return fabs(apart) < 1e-9;
}

static int read_speeds(parser *p, const setting *s, flk_program *x)
{
    text rest = s->value, item;
    quantity q = x->is_angle
                     ? (x->is_of_speed ? QUANTITY_ANGULAR_ACCELERATION : QUANTITY_ANGULAR_SPEED)
                     : (x->is_of_speed ? QUANTITY_ACCELERATION : QUANTITY_SPEED);
    quantity_value value;
    int n = 0;

    for (; n < 2 && flk_text_split(&rest, ',', &item); n++) {
        if (!flk_piece_quantity(p, s->place, flk_text_trim(item), s->value, q, &value))
            return 0;
        x->speed[n] = value.si;
    }
    x->ends = FLK_ENDS_SPEEDS;
    if (n == 2 && !flk_text_trim(rest).length)
        return 1;
    return flk_mistake(
        p->mistakes, s->place,
        "expected natural, rest, periodic, or the %s at both ends, such as 0 %s, 3 %s, "
        "not '%t'",
        x->is_of_speed ? "accelerations" : "speeds", flk_quantities[q].unit, flk_quantities[q].unit,
        s->value);
}

static int build_program_ends(parser *p, const setting *s, double first, double last,
                              flk_program *x)
{
    int repeats = comes_back(x, first, last);

    if (IS_SET(s) && x->segment[0].law != FLK_LAW_SPLINE &&
        x->segment[x->n - 1].law != FLK_LAW_SPLINE)
        return flk_mistake(p->mistakes, s->place,
                           "'ends' is for a spline; this program ends by other laws");
    x->ends = !IS_SET(s) && repeats ? FLK_ENDS_PERIODIC : FLK_ENDS_NATURAL;
    if (!IS_SET(s) || flk_text_equal(s->value, "natural"))
        return 1;
    if (flk_text_equal(s->value, "rest")) {
        x->ends = FLK_ENDS_SPEEDS;
        return 1;
    }
    if (!flk_text_equal(s->value, "periodic"))
        return read_speeds(p, s, x);
    x->ends = FLK_ENDS_PERIODIC;
    return repeats ||
           flk_mistake(
               p->mistakes, s->place,
               x->is_of_speed ? "the program does not repeat: its last speed is not its first"
               : x->is_angle  ? "the program does not repeat: its last point is neither its "
                                "first nor whole turns later"
                              : "the program does not repeat: its last point is not its first");
}

/* --------------------------------------------------------------------------------------------- programs */

/* Refuse keys of other motions. */
static void check_keys(parser *p)
{
    static const key_code others[] = {
        KEY_MOTION_SPEED,  KEY_MOTION_ACCELERATION, KEY_MOTION_TO,
        KEY_MOTION_TURNS,  KEY_MOTION_INTERVAL,     KEY_MOTION_AT,
        KEY_MOTION_RUN_UP, KEY_MOTION_HOLD,         KEY_MOTION_DURATION};
    const setting *rows = flk_setting_find(p, KEY_MOTION_ROWS),
                  *mode = flk_setting_find(p, KEY_MOTION_MODE),
                  *from = flk_setting_find(p, KEY_MOTION_FROM);
    size_t i;

    for (i = 0; i < sizeof others / sizeof others[0]; i++) {
        const setting *s = flk_setting_find(p, others[i]);

        if (IS_SET(s))
            flk_mistake(p->mistakes, s->place, "'%s' cannot be used with 'program', which has it",
                        flk_key_table[others[i]].name);
    }
    if (IS_SET(rows) && !rows->word)
        flk_mistake(p->mistakes, rows->place, "a program has rows by time");
    if (IS_SET(mode) && mode->word != MODE_GIVEN)
        flk_mistake(p->mistakes, mode->place,
                    "'program' gives the motion, and mode = %t computes it: leave out one",
                    mode->value);
    if (IS_SET(from) && !flk_setting_find(p, KEY_MOTION_PROGRAM_OF)->word)
        flk_mistake(p->mistakes, from->place,
                    "'from' is for a program of speeds; another starts at its first point");
}

static int refuse_points(parser *p, const setting *s, const flk_program *x)
{
    const setting *input = flk_setting_find(p, KEY_MOTION_INPUT);
    char words[DECK_NAME_SIZE] = "crank angle";

    if (x->is_of_speed)
        strcpy(words, "speed");
    else if (input->word)
        flk_text_copy(input->value, words, sizeof words);
    return flk_mistake(
        p->mistakes, s->place, "expected two or more points of time and %s, such as %s, not '%t'",
        words,
        x->is_angle ? (x->is_of_speed ? "0 s 0 rpm, 0.5 s 60 rpm" : "0 s 0 deg, 0.4 s 90 deg")
                    : (x->is_of_speed ? "0 s 0 mm/s, 0.5 s 60 mm/s" : "0 s 0 mm, 0.4 s 50 mm"),
        s->value);
}

/* The quantity of the points: the crank angle, or the input, or its speed. */
static quantity quantity_of(const flk_program *x)
{
    return x->is_angle ? (x->is_of_speed ? QUANTITY_ANGULAR_SPEED : QUANTITY_ANGLE)
                       : (x->is_of_speed ? QUANTITY_SPEED : QUANTITY_LENGTH);
}

/* Read the points and laws into the segments of a program. */
static int read_program(parser *p, const setting *s, flk_program *x)
{
    setting read = *s;
    const setting *law = flk_setting_find(p, KEY_MOTION_LAW),
                  *ends = flk_setting_find(p, KEY_MOTION_ENDS);
    int is_file = flk_curve_text_file(s->value, NULL);
    size_t most = is_file ? 0 : flk_text_count(s->value, ','), i;
    char *points = is_file ? NULL : flk_reader_copy(p, s->value, "");
    flk_program_segment usual, *g = flk_reader_keep(p, (most + 1) * sizeof *g);

    memset(&usual, 0, sizeof usual);
    if (!g || (!points && !is_file) ||
        !read_law(p, IS_SET(law) ? law : s, IS_SET(law) ? law->value : flk_text_of("spline"),
                  &usual))
        return 0;
    if (points) {
        if (!read_laws(p, s, points, &usual, g, most))
            return 0;
        read.value = flk_text_of(points);
    }
    read.n_points = 0;
    read.curve = NULL;
    read.argument = QUANTITY_TIME;
    if (!flk_curve_text_read(p, &read, quantity_of(x)))
        return 0;
    if (!read.curve || read.n_points < 2)
        return refuse_points(p, s, x);
    if (!flk_build_is_rising(p, &read, 0, "the times of a program must rise"))
        return 0;
    x->n = (unsigned long)read.n_points - 1;
    x->segment = is_file ? flk_reader_keep(p, x->n * sizeof *g) : g;
    for (i = 0; x->segment && i < x->n; i++) {
        flk_program_segment *to = &x->segment[i];

        if (is_file)
            *to = usual;
        to->begin = read.curve[i].x;
        to->length = read.curve[i + 1].x - to->begin;
        to->value = read.curve[i].y[0] - (x->is_angle && !x->is_of_speed ? p->d->axes.angle : 0);
        to->rise = read.curve[i + 1].y[0] - read.curve[i].y[0];
    }
    return x->segment && build_program_ends(p, ends, read.curve[0].y[0], read.curve[x->n].y[0], x);
}

/* The way of the first point that is not where it begins: 1 or -1. */
static double sense_of(const flk_program *x)
{
    unsigned long i;

    for (i = 0; i < x->n; i++) {
        double way =
            x->is_of_speed && x->segment[i].value != 0 ? x->segment[i].value : x->segment[i].rise;

        if (way != 0)
            return way < 0 ? -1 : 1;
    }
    return 1;
}

static void build_rows(parser *p, const flk_program *x)
{
    const setting *step = flk_setting_find(p, KEY_MOTION_TIME_STEP);
    double duration = flk_program_end(x) - x->segment[0].begin;
    deck_mode *mode = &p->d->mode;

    mode->duration = duration;
    mode->time_step = IS_SET(step) ? step->si[0] : duration / STEPS;
    if (!(mode->time_step > 0) || duration / mode->time_step > MOST_TIMES)
        flk_mistake(p->mistakes, IS_SET(step) ? step->place : flk_reader_end(p),
                    "more than 1,000,000 rows by time (%.6g): give a larger time_step",
                    duration / mode->time_step);
}

int flk_build_program(parser *p)
{
    const setting *s = flk_setting_find(p, KEY_MOTION_PROGRAM),
                  *input = flk_setting_find(p, KEY_MOTION_INPUT);
    static const key_code own[] = {KEY_MOTION_LAW, KEY_MOTION_ENDS, KEY_MOTION_PROGRAM_OF};
    fourlink_motion *motion = &p->d->motion;
    double to_rad = motion->angle_unit, x[3], *room;
    flk_program *program;
    size_t i;

    for (i = 0; i < sizeof own / sizeof own[0] && !IS_SET(s); i++)
        if (IS_SET(flk_setting_find(p, own[i])))
            flk_mistake(p->mistakes, flk_setting_find(p, own[i])->place, "'%s' needs a 'program'",
                        flk_key_table[own[i]].name);
    if (!IS_SET(s))
        return 0;
    check_keys(p);
    p->d->over = &flk_abscissas[1];
    program = flk_reader_keep(p, sizeof *program);
    if (!program)
        return 1;
    program->is_of_speed = flk_setting_find(p, KEY_MOTION_PROGRAM_OF)->word;
    program->is_angle = !input->word || flk_input_is_angle(input);
    program->from = flk_setting_or(p, KEY_MOTION_FROM, 0) - (program->is_angle ? motion->x_at : 0);
    if (!read_program(p, s, program))
        return 1;
    room = flk_reader_keep(p, 3 * (program->n + 1) * sizeof *room);
    if (!room)
        return 1;
    flk_program_prepare(program, room);
    flk_program_at(program, program->segment[0].begin, x);
    if (!input->word) { /* else the crank follows: flk_build_prescribed */
        motion->from = (x[0] + motion->x_at) / to_rad;
        motion->to = motion->from + sense_of(program) * p->d->machine.cycle / to_rad;
    }
    build_rows(p, program);
    p->d->program = program;
    return 1;
}
