/* SPDX-License-Identifier: GPL-3.0-or-later
**
** by_program.c - the course of a program over time, of the crank angle or of another coordinate.
*/
#include <float.h>
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/solve.h"
#include "course.h"

/* ----------------------------------------------------------------------------------- of the crank angle */

static int crank_at(const flk_course *c, fourlink_branch branch, int side, double time,
                    fourlink_row *row, flk_actual_row *actual)
{
    double x[3];

    (void)branch;
    (void)side;
    (void)actual;
    flk_program_at(c->d->program, time, x);
    row->place = row->time = time;
    row->angle = (x[0] + c->d->motion.x_at) / c->d->motion.angle_unit;
    row->crank.theta2 = x[0];
    row->crank.omega2 = x[1];
    row->crank.alpha2 = x[2];
    row->side = 0;
    return FLK_WITHIN(x[0] + x[1] + x[2], DBL_MAX) ? FOURLINK_OK : FOURLINK_BAD_NUMBER;
}

/* A rad of the length is the time of a rad at the highest speed. */
static void crank_begin(const flk_course *c, flk_pieces *x)
{
    double speed = flk_program_highest(c->d->program), duration = c->over.last - c->over.first;

    x->first = c->over.first;
    x->end = c->over.last;
    x->length = GSL_MAX(speed * duration, 1);
    x->rate = duration / x->length;
}

/* ------------------------------------------------------------------------------------------ of an input */

#define CLOSE 1e-9 /* of a stretch: a value that is written with fewer digits */

/* A value of a program in a stretch, and by how much the crank angle is then another: whole turns.  An
** angle may be a whole turn from where a stretch has it, and where it can turn fully a program goes over
** any number of turns. */
static double into_stretch(const deck_prescribed *x, const flk_stretch *s, double value,
                           double *beyond)
{
    double low = GSL_MIN(s->from, s->to), width = fabs(s->to - s->from), close = CLOSE * width;
    int is_full = flk_coordinate_turns(x->q, s);
    double turn = is_full ? width : 2 * M_PI, n = floor((value - low + close) / turn);

    *beyond = 0;
    if (x->q->is_angle && (value < low - close || value > low + width + close)) {
        value -= n * turn;
        *beyond = is_full ? s->side * n * (s->theta2_to - s->theta2_from) : 0;
    }
    return GSL_MIN(GSL_MAX(value, low), low + width);
}

static int input_at(const flk_course *c, fourlink_branch branch, int side, double time,
                    fourlink_row *row, flk_actual_row *actual)
{
    const deck *d = c->d;
    const deck_prescribed *x = d->prescribed;
    const fourlink_mechanism *mechanism = &d->machine.mechanism;
    const flk_stretch *s = DECK_STRETCH(x, branch, x->side);
    double of_program[3], beyond, fourth;
    flk_prescribed at;
    int status;

    (void)side;
    (void)actual;
    row->side = x->side;
    flk_program_at(d->program, time, of_program);
    row->place = row->time = time;
    at.value = into_stretch(x, s, of_program[0], &beyond);
    at.rate = of_program[1];
    at.second = of_program[2];
    if (flk_program_from_rest(d->program, time, &fourth))
        status = flk_coordinate_crank_from_rest(x->q, mechanism, branch, s, at.value, fourth,
                                                &row->crank);
    else
        status = flk_coordinate_crank(x->q, mechanism, branch, s, &at, &row->crank);
    row->crank.theta2 += beyond;
    row->angle = (row->crank.theta2 + d->motion.x_at) / d->motion.angle_unit;
    if (status != FOURLINK_OK)
        row->crank.omega2 = row->crank.alpha2 = FLK_UNDEFINED;
    return status;
}

/* theta2 at a time, by the program itself or by its input, also where there is no row. */
static double theta2_by_program(const flk_course *c, fourlink_branch branch, double time)
{
    const deck_prescribed *x = c->d->prescribed;
    double of_program[3], beyond, value;
    const flk_stretch *s;

    flk_program_at(c->d->program, time, of_program);
    if (!x)
        return of_program[0];
    s = DECK_STRETCH(x, branch, x->side);
    value = into_stretch(x, s, of_program[0], &beyond);
    return beyond + flk_coordinate_theta2(x->q, &c->d->machine.mechanism, branch, s, value);
}

/* A rad of the length is the time in which the crank turns through a rad where the coordinate is
** quickest, if it turned evenly with it. */
static void input_begin(const flk_course *c, flk_pieces *x)
{
    const flk_program *program = c->d->program;
    double duration = c->over.last - c->over.first, turned = 0, from, to, most;
    flk_program_reach reach;

    flk_program_limits(program, &reach);
    for (from = c->over.first; from < c->over.last; from = to) {
        to = flk_program_way(program, from);
        turned += fabs(theta2_by_program(c, x->branch, to) - theta2_by_program(c, x->branch, from));
    }
    most = reach.travel > 0 ? flk_program_highest(program) * duration / reach.travel : 1;
    x->first = c->over.first;
    x->end = c->over.last;
    x->length = GSL_MAX(turned * GSL_MAX(most, 1), 1);
    x->rate = duration / x->length;
}

/* ----------------------------------------------------------------------------------------------- pieces */

/* What is sought along a program: a crank angle. */
typedef struct crank_search {
    const flk_course *course;
    fourlink_branch branch;
    double theta2;
} crank_search;

static double crank_past(double time, void *data)
{
    const crank_search *s = data;

    return theta2_by_program(s->course, s->branch, time) - s->theta2;
}

static double find_crank(crank_search *s, double from, double to)
{
    flk_bracket b = flk_bracket_of(from, to, crank_past(from, s), crank_past(to, s));

    return flk_find_zero(crank_past, s, &b, 0);
}

/* The kind of end at a time: where the stretch of an input ends, its dead centre or a dead position.  At
** rest there without a jump the motion is smooth over the time, but the force of the drive has a pole. */
static flk_piece_end end_at_time(const flk_pieces *x, double time, flk_piece_end of_position)
{
    const deck_prescribed *of = x->course->d->prescribed;
    double of_program[3], beyond, value, fourth, close;
    const flk_stretch *s;

    if (!of)
        return of_position;
    s = DECK_STRETCH(of, x->branch, of->side);
    close = CLOSE * fabs(s->to - s->from);
    flk_program_at(x->course->d->program, time, of_program);
    value = into_stretch(of, s, of_program[0], &beyond);
    if (fabs(value - s->from) > close && fabs(value - s->to) > close)
        return of_position;
    if (flk_course_leaves_dead(x->course, x->branch, of->side, time))
        return FLK_END_PLAIN;
    if (!flk_program_from_rest(x->course->d->program, time, &fourth) || gsl_isnan(fourth))
        return FLK_END_DEAD;
    return x->course->d->has_forces ? FLK_END_POLE : of_position;
}

/* A piece ends with its way, and where the crank passes a corner of the angle. */
static void next_piece(const flk_pieces *x, flk_piece *piece)
{
    const flk_course *c = x->course;
    double from = x->first + piece->from * x->rate, to = flk_program_way(c->d->program, from), way;
    double passed;
    flk_direction p;
    crank_search s;

    p.from = theta2_by_program(c, x->branch, from);
    way = theta2_by_program(c, x->branch, to) - p.from;
    p.corners = c->corners;
    p.branch = x->branch;
    p.sense = way < 0 ? -1 : 1;
    p.has_loads = x->has_loads;
    if (!(piece->from > 0))
        piece->begin = end_at_time(x, from, flk_corners_first(&p));
    way = fabs(way);
    passed = flk_corners_next(&p, 0, NULL, 0, &piece->end);
    if (passed < way - FLK_CORNERS_CLOSE(way)) {
        s.course = c;
        s.branch = x->branch;
        s.theta2 = p.from + p.sense * passed;
        to = find_crank(&s, from, to);
    } else {
        piece->end =
            end_at_time(x, to, passed > way + FLK_CORNERS_CLOSE(way) ? FLK_END_PLAIN : piece->end);
    }
    piece->to = to < x->end ? (to - x->first) / x->rate : x->length;
}

/* ---------------------------------------------------------------------------------------- a crank angle */

#define INSIDE 1e-12 /* rad: what counts as an end of a way */

/* The first time at which an input takes the crank to an angle, less whole periods; 0 if it does not. */
static int pass_by_input(const flk_course *c, fourlink_branch branch, double theta2, double *time)
{
    const fourlink_mechanism *mechanism = &c->d->machine.mechanism;
    double period = mechanism->change_stretched != mechanism->change_folded ? 4 * M_PI : 2 * M_PI;
    double from, to, at[2];
    crank_search s;

    s.course = c;
    s.branch = branch;
    for (from = c->over.first; from < c->over.last; from = to) {
        to = flk_program_way(c->d->program, from);
        at[0] = theta2_by_program(c, branch, from);
        at[1] = theta2_by_program(c, branch, to);
        s.theta2 = flk_cycle_place(theta2, GSL_MIN(at[0], at[1]) - INSIDE, period);
        if (s.theta2 > GSL_MAX(at[0], at[1]) + INSIDE)
            continue;
        s.theta2 = GSL_MIN(GSL_MAX(s.theta2, GSL_MIN(at[0], at[1])), GSL_MAX(at[0], at[1]));
        *time = find_crank(&s, from, to);
        return 1;
    }
    return 0;
}

int flk_course_pass_program(const flk_course *c, fourlink_branch branch, double theta2,
                            double *time)
{
    return c->d->prescribed ? pass_by_input(c, branch, theta2, time)
                            : flk_program_pass(c->d->program, theta2, time);
}

const struct flk_course_type flk_course_by_program = {flk_course_place_of_time, crank_at,
                                                      flk_course_find_time, crank_begin,
                                                      next_piece},
                             flk_course_by_program_of_input = {flk_course_place_of_time, input_at,
                                                               flk_course_find_time, input_begin,
                                                               next_piece};
