/* SPDX-License-Identifier: GPL-3.0-or-later
**
** course.c - the course of a deck: what its rows go over, and the motion of the crank along it, given or
** integrated, as a whole and in pieces within which all columns are smooth.
**
** Over the crank angle a piece ends where a load's curve or window has a corner, at dead positions and change
** points, where links lie in one line or nearly so, where a run-up ends, and where the crank is at rest.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "course.h"
#include "mechanics/kind.h"
#include "mechanics/mechanics.h"
#include "mechanics/mechanism.h"
#include "mechanics/spring.h"

#define SHORT 0.5            /* rad, of a piece of rows by time */
#define INSIDE_STRETCH 1e-12 /* rad, or of the length of a stretch: what counts as its end */

/* rad: positions repeat after this. */
static double position_period(const flk_course *c)
{
    const fourlink_mechanism *mechanism = &c->d->machine.mechanism;

    return mechanism->change_stretched != mechanism->change_folded ? 4 * M_PI : 2 * M_PI;
}

/* --------------------------------------------------------------------------------------- over the angle */

static double place_of_angle(const flk_course *c, unsigned long i)
{
    return flk_motion_angle(&c->d->motion, &c->range, i);
}

static int at_given(const flk_course *c, fourlink_branch branch, int side, double angle,
                    fourlink_row *row, flk_actual_row *actual)
{
    (void)branch;
    (void)side;
    (void)actual;
    fourlink_motion_at(&c->d->motion, angle, row);
    return FOURLINK_OK;
}

/* Take a row of the actual motion. */
static int take(int status, const flk_actual_row *actual, double place, fourlink_row *row)
{
    row->crank = actual->crank;
    row->angle = actual->angle;
    row->place = place;
    row->time = actual->time;
    row->side = 0;
    if (status != FOURLINK_OK)
        row->time = row->crank.omega2 = row->crank.alpha2 = FLK_UNDEFINED;
    return status;
}

static int at_angle(const flk_course *c, fourlink_branch branch, int side, double angle,
                    fourlink_row *row, flk_actual_row *actual)
{
    (void)side;
    return take(flk_actual_at(c->actual, branch, angle, actual), actual, angle, row);
}

/* Larger angles have too few digits left after their turns. */
#define ANGLE_MAX 1e9 /* rad, as in decks */

static int find_angle(const flk_course *c, double angle, double *at)
{
    const fourlink_motion *motion = &c->d->motion;
    double turn = c->period / motion->angle_unit, tiny = 1e-9 * turn;
    double first = GSL_MIN(motion->from, c->end), last = GSL_MAX(motion->from, c->end);

    if (!FLK_WITHIN(angle * motion->angle_unit, ANGLE_MAX))
        return 0;
    *at = angle;
    if (angle < first - tiny || angle > last + tiny)
        *at = angle - turn * flk_cycle_count(angle + tiny - first, turn);
    return first - tiny <= *at && *at <= last + tiny;
}

static double whole_length(const flk_course *c)
{
    return fabs(c->end - c->d->motion.from) * c->d->motion.angle_unit;
}

static void begin_angle(const flk_course *c, flk_pieces *x)
{
    x->length = c->actual ? flk_actual_length(c->actual, x->branch) : whole_length(c);
    x->first = c->d->motion.from;
    x->end =
        x->length < whole_length(c) ? flk_actual_facts_of(c->actual, x->branch)->end_angle : c->end;
    x->rate = (c->end < x->first ? -1 : 1) / c->d->motion.angle_unit;
}

/* How the crank starts or ends: from rest, its speed grows as the root of the angle. */
static flk_piece_end end_of_motion(const flk_course *course, double angle)
{
    fourlink_row row;

    fourlink_motion_at(&course->d->motion, angle, &row);
    return row.crank.omega2 == 0 && row.crank.alpha2 != 0 && !course->d->motion.hold
               ? FLK_END_ROOT
               : FLK_END_PLAIN;
}

/* The end of the motion at a length; an actual motion that is shorter than its rows has stalled. */
static flk_piece_end ending(const flk_course *course, double length)
{
    if (course->actual)
        return length < whole_length(course) && !flk_course_repeats(course) ? FLK_END_ROOT
                                                                            : FLK_END_PLAIN;
    return end_of_motion(course, course->end);
}

/* Combine an end of the motion with that of its position. */
static flk_piece_end join(flk_piece_end of_motion, flk_piece_end of_position)
{
    if (of_position == FLK_END_CHANGE && of_motion == FLK_END_ROOT)
        return FLK_END_CHANGE_REST;
    return of_position == FLK_END_PLAIN ? of_motion : of_position;
}

static void find_direction(const flk_pieces *x, int has_loads, flk_direction *p)
{
    const fourlink_motion *motion = &x->course->d->motion;

    p->corners = x->course->corners;
    p->branch = x->branch;
    p->from = flk_motion_theta2(motion, motion->from);
    p->sense = x->rate < 0 ? -1 : 1;
    p->has_loads = has_loads;
}

/* The kind of end at the beginning of the motion. */
static flk_piece_end first_end(const flk_pieces *x)
{
    const flk_course *c = x->course;
    flk_direction p;

    find_direction(x, 0, &p);
    return join(!c->actual                   ? end_of_motion(c, c->d->motion.from)
                : flk_actual_from_rest(c->d) ? FLK_END_ROOT
                                             : FLK_END_PLAIN,
                flk_corners_first(&p));
}

static void next_over_angle(const flk_pieces *x, flk_piece *piece)
{
    const fourlink_motion *motion = &x->course->d->motion;
    double more[2];
    flk_direction p;

    if (!(piece->from > 0))
        piece->begin = first_end(x);
    find_direction(x, x->has_loads, &p);
    more[0] = motion->run_up * motion->angle_unit; /* 0 is passed */
    more[1] = x->period;
    piece->to = flk_corners_next(&p, piece->from, more, 2, &piece->end);
    if (piece->to < x->length - FLK_CORNERS_CLOSE(x->length))
        return;
    if (piece->to > x->length + FLK_CORNERS_CLOSE(x->length))
        piece->end = FLK_END_PLAIN;
    piece->end = join(ending(x->course, x->length), piece->end);
    piece->to = x->length;
}

/* ----------------------------------------------------------------------------------------- over time, s */

double flk_course_place_of_time(const flk_course *c, unsigned long i)
{
    return GSL_MIN(c->over.first + (double)i * c->over.step, c->over.last);
}

static int at_time(const flk_course *c, fourlink_branch branch, int side, double time,
                   fourlink_row *row, flk_actual_row *actual)
{
    (void)side;
    return take(flk_actual_at_time(c->actual, branch, time, actual), actual, time, row);
}

int flk_course_find_time(const flk_course *c, double time, double *at)
{
    *at = time;
    return time >= c->over.first && time <= c->over.last + 1e-12 * (c->over.last - c->over.first);
}

/* Its length is the angle through which the crank turns, forwards and backwards. */
static void begin_time(const flk_course *c, flk_pieces *x)
{
    x->length = flk_actual_travel(c->actual, x->branch);
    x->first = 0;
    x->end = flk_actual_time(c->actual, x->branch);
    x->rate = x->length > 0 ? x->end / x->length : 0;
}

/* Corners are not known, so pieces are short. */
static void next_over_time(const flk_pieces *x, flk_piece *piece)
{
    piece->begin = piece->end = FLK_END_PLAIN;
    piece->to = piece->from + 2 * SHORT < x->length ? piece->from + SHORT : x->length;
}

/* -------------------------------------------------------------------------------------- by a coordinate */

/* A row without a crank: its speeds are NaN. */
static int without_crank(int status, fourlink_row *row)
{
    if (status != FOURLINK_OK)
        row->crank.omega2 = row->crank.alpha2 = FLK_UNDEFINED;
    return status;
}

void flk_course_prescribed_at(const deck_prescribed *x, double place, flk_prescribed *at,
                              fourlink_row *row)
{
    double of_program[3];

    if (x->program) {
        flk_program_at(x->program, place, of_program);
        row->place = row->time = place;
        at->value = of_program[0];
        at->rate = of_program[1];
        at->second = of_program[2];
        return;
    }
    fourlink_motion_at(&x->motion, x->is_at_crank ? x->motion.from : place, row);
    at->value = x->is_at_crank ? place - x->motion.x_at : row->crank.theta2;
    at->rate = row->crank.omega2;
    at->second = row->crank.alpha2;
}

/* The crank angle in the stretch of a branch that differs by whole turns. */
static double in_stretch(const flk_stretch *s, double theta2, double period)
{
    return flk_cycle_place(theta2, s->theta2_from - INSIDE_STRETCH, period);
}

/* The rows of one side. */
static unsigned long rows_of_side(const flk_course *c)
{
    return DECK_HAS_BOTH_SIDES(c->d) ? c->range.n_rows / 2 : c->range.n_rows;
}

int flk_course_first_side(const flk_course *c)
{
    return c->d->prescribed ? c->d->prescribed->side : 0;
}

int flk_course_side(const flk_course *c, unsigned long i)
{
    return DECK_HAS_BOTH_SIDES(c->d) && i >= rows_of_side(c) ? FOURLINK_FALLING
                                                             : flk_course_first_side(c);
}

int flk_course_has_side(const flk_course *c, int side)
{
    return side != 0 && (side == flk_course_first_side(c) ||
                         (DECK_HAS_BOTH_SIDES(c->d) && side == FOURLINK_FALLING));
}

static double place_of_coordinate(const flk_course *c, unsigned long i)
{
    fourlink_range range = c->range;

    range.n_rows = rows_of_side(c);
    return flk_motion_angle(&c->d->prescribed->motion, &range,
                            i < range.n_rows ? i : i - range.n_rows);
}

int flk_course_at_input(const flk_course *c, fourlink_branch branch, int side, double place,
                        fourlink_row *row, fourlink_state *state)
{
    const deck *d = c->d;
    const deck_prescribed *x = d->prescribed;
    const flk_stretch *s = DECK_STRETCH(x, branch, side);
    flk_prescribed at;
    int status;

    flk_course_prescribed_at(x, place, &at, row);
    row->crank.theta2 = x->theta2;
    if (x->is_at_crank) {
        status = flk_coordinate_crank_at(x->q, &d->machine.mechanism, branch, &at, &row->crank);
        row->place = at.value;
    } else {
        status = flk_coordinate_crank_in(x->q, &d->machine.mechanism, branch, s, &at, &row->crank,
                                         state);
    }
    row->side = s->side;
    row->angle = (row->crank.theta2 + d->motion.x_at) / d->motion.angle_unit;
    return without_crank(status, row);
}

static int at_coordinate(const flk_course *c, fourlink_branch branch, int side, double place,
                         fourlink_row *row, flk_actual_row *actual)
{
    fourlink_state state;

    (void)actual;
    return flk_course_at_input(c, branch, side, place, row, &state);
}

static int find_coordinate(const flk_course *c, double place, double *at)
{
    double first = GSL_MIN(c->over.first, c->over.last),
           last = GSL_MAX(c->over.first, c->over.last);
    double size = c->d->prescribed->q->is_angle
                      ? 2 * M_PI
                      : c->d->machine.mechanism.design.link[FOURLINK_CRANK].length;
    double tiny = 1e-9 * GSL_MAX(last - first, size);

    *at = place;
    if (c->d->prescribed->q->is_angle && !(first - tiny <= place && place <= last + tiny))
        *at = flk_cycle_place(place, first - tiny, 2 * M_PI);
    return first - tiny <= *at && *at <= last + tiny && !c->d->prescribed->is_at_crank;
}

/* theta2 at a place of a branch and a side. */
static double theta2_at(const flk_course *c, fourlink_branch branch, int side, double place)
{
    const deck_prescribed *x = c->d->prescribed;

    return flk_coordinate_theta2(x->q, &c->d->machine.mechanism, branch,
                                 DECK_STRETCH(x, branch, side), place - x->motion.x_at);
}

/* rad: the way of the crank on a side. */
static double way_of(const flk_course *c, fourlink_branch branch, int side)
{
    return fabs(theta2_at(c, branch, side, c->over.last) -
                theta2_at(c, branch, side, c->over.first));
}

/* A rad of the length is a part of the way of the coordinate, in which the crank turns through a rad on
** average.  Both sides are equally long, also those of one instant, along which nothing moves. */
static void begin_coordinate(const flk_course *c, flk_pieces *x)
{
    double one = way_of(c, x->branch, flk_course_first_side(c));

    x->first = c->over.first;
    x->end = c->over.last;
    x->length = one;
    if (DECK_HAS_BOTH_SIDES(c->d)) {
        one = 0.5 * (one + way_of(c, x->branch, FOURLINK_FALLING));
        x->one_side = one > 0 ? one : 1;
        x->length = 2 * x->one_side;
    }
    x->rate = one > 0 ? (x->end - x->first) / one : 0;
}

/* 1 if a place is a dead position of the crank that has a row: over the input all is smooth there. */
int flk_course_leaves_dead(const flk_course *c, fourlink_branch branch, int side, double place)
{
    const flk_machine *machine = &c->d->machine;
    flk_actual_row actual;
    fourlink_state state;
    fourlink_row row;

    return (!c->d->has_forces || flk_machine_leaves_dead(machine)) &&
           c->type->at(c, branch, side, place, &row, &actual) == FOURLINK_OK &&
           flk_mechanism_stand(&machine->mechanism, branch, &row.crank, &state) ==
               FOURLINK_DEAD_POSITION &&
           flk_course_swing(c, branch, place, row.crank.theta2, 0, &state) == FOURLINK_OK;
}

/* How the motion begins or ends at a place: at a dead centre of the coordinate, at which the crank is
** infinitely quick or comes to rest. */
static flk_piece_end end_at_place(const flk_course *c, fourlink_branch branch, int side,
                                  double place, flk_piece_end of_position)
{
    const deck_prescribed *x = c->d->prescribed;
    const flk_stretch *s = DECK_STRETCH(x, branch, side);
    double value = place - x->motion.x_at, close = INSIDE_STRETCH * fabs(s->to - s->from);
    flk_prescribed at;
    fourlink_row row;

    flk_course_prescribed_at(x, place, &at, &row);
    if (fabs(value - s->from) <= close || fabs(value - s->to) <= close) {
        if (!flk_course_leaves_dead(c, branch, side, place))
            return FLK_END_DEAD;
        of_position = FLK_END_PLAIN;
    }
    return join(at.rate == 0 && at.second != 0 && !x->motion.hold ? FLK_END_ROOT : FLK_END_PLAIN,
                of_position);
}

/* A piece ends where the crank passes a corner of the angle. */
static void next_over_coordinate(const flk_pieces *x, flk_piece *piece)
{
    const flk_course *c = x->course;
    const deck_prescribed *of = c->d->prescribed;
    int is_second = x->one_side > 0 && piece->from >= x->one_side;
    int side = is_second ? FOURLINK_FALLING : flk_course_first_side(c);
    double begin = is_second ? x->one_side : 0;
    double end = x->one_side > 0 && !is_second ? x->one_side : x->length;
    double from = x->first + (piece->from - begin) * x->rate, way, passed;
    double value, to;
    flk_direction p;

    p.corners = c->corners;
    p.branch = x->branch;
    p.from = theta2_at(c, x->branch, side, from);
    way = theta2_at(c, x->branch, side, x->end) - p.from;
    p.sense = way < 0 ? -1 : 1;
    p.has_loads = x->has_loads;
    way = fabs(way);
    if (!(piece->from > begin))
        piece->begin = end_at_place(c, x->branch, side, from, flk_corners_first(&p));
    passed = flk_corners_next(&p, 0, NULL, 0, &piece->end);
    if (passed < way - FLK_CORNERS_CLOSE(way)) {
        value = flk_coordinate_value(of->q, &c->d->machine.mechanism, x->branch,
                                     p.from + p.sense * passed);
        value = flk_coordinate_in_turn(of->q, DECK_STRETCH(of, x->branch, side),
                                       p.from + p.sense * passed, value);
        find_coordinate(c, value + of->motion.x_at, &to);
        piece->to = begin + (to - x->first) / x->rate;
        if (piece->to > piece->from && piece->to < end)
            return;
    }
    piece->end = end_at_place(c, x->branch, side, x->end,
                              passed > way + FLK_CORNERS_CLOSE(way) ? FLK_END_PLAIN : piece->end);
    piece->to = end;
}

/* The crank at an angle, if the motion has it: what is prescribed follows from the angle. */
static int pass_on_side(const flk_course *c, fourlink_branch branch, int side, double theta2,
                        int *status, fourlink_row *row)
{
    const deck_prescribed *x = c->d->prescribed;
    const flk_stretch *s = DECK_STRETCH(x, branch, side);
    flk_prescribed at = {0, 0, 0};
    double place;

    if (x->is_at_crank) {
        if (fabs(flk_cycle_beside(theta2 - x->theta2, 2 * M_PI)) > INSIDE_STRETCH)
            return 0;
        *status = at_coordinate(c, branch, side, 0, row, NULL);
        return 1;
    }
    row->crank.theta2 = in_stretch(s, theta2, position_period(c));
    if (row->crank.theta2 > s->theta2_to + INSIDE_STRETCH ||
        flk_coordinate_crank_at(x->q, &c->d->machine.mechanism, branch, &at, &row->crank) !=
            FOURLINK_OK)
        return 0;
    at.value = flk_coordinate_in_turn(x->q, s, row->crank.theta2, at.value);
    if (!find_coordinate(c, at.value + x->motion.x_at, &place))
        return 0;
    theta2 = row->crank.theta2;
    flk_course_prescribed_at(x, place, &at, row);
    row->crank.theta2 = theta2;
    *status = without_crank(
        flk_coordinate_crank_at(x->q, &c->d->machine.mechanism, branch, &at, &row->crank), row);
    row->angle = (theta2 + c->d->motion.x_at) / c->d->motion.angle_unit;
    row->place = place;
    row->side = s->side;
    return 1;
}

static int pass_coordinate(const flk_course *c, fourlink_branch branch, double theta2, int *status,
                           fourlink_row *row)
{
    return pass_on_side(c, branch, flk_course_first_side(c), theta2, status, row) ||
           (DECK_HAS_BOTH_SIDES(c->d) &&
            pass_on_side(c, branch, FOURLINK_FALLING, theta2, status, row));
}

static const struct flk_course_type given = {place_of_angle, at_given, find_angle, begin_angle,
                                             next_over_angle},
                                    by_angle = {place_of_angle, at_angle, find_angle, begin_angle,
                                                next_over_angle},
                                    by_time = {flk_course_place_of_time, at_time,
                                               flk_course_find_time, begin_time, next_over_time},
                                    by_coordinate = {place_of_coordinate, at_coordinate,
                                                     find_coordinate, begin_coordinate,
                                                     next_over_coordinate};

/* ------------------------------------------------------------------------------------------- the course */

static const struct flk_course_type *type_of(const deck *d)
{
    return d->prescribed && d->program  ? &flk_course_by_program_of_input
           : d->prescribed              ? &by_coordinate
           : d->program                 ? &flk_course_by_program
           : d->mode.kind == MODE_GIVEN ? &given
           : d->over->is_crank_angle    ? &by_angle
                                        : &by_time;
}

static double period_of(const flk_machine *machine)
{
    const fourlink_mechanism *mechanism = &machine->mechanism;
    double turns = mechanism->change_stretched != mechanism->change_folded ? 2 : 1;

    return GSL_MAX(machine->cycle, turns * 2 * M_PI);
}

int flk_course_open(flk_course *c, const deck *d, flk_acting *acting, flk_actual *actual)
{
    const flk_machine *machine = &d->machine;
    const flk_element *spring;
    size_t i = 0;

    memset(c, 0, sizeof *c);
    c->d = d;
    c->type = type_of(d);
    flk_deck_rows(d, &c->range, &c->over); /* checked by the deck reader */
    c->end = c->over.is_crank_angle ? c->over.last : d->motion.to;
    c->period = period_of(machine);
    for (; (spring = flk_machine_find(machine, &flk_spring_type, i)) != NULL; i++)
        c->winds |= flk_spring_winds(&machine->mechanism, spring->data, c->period);
    c->corners = flk_corners_open(d);
    c->actual = actual;
    c->is_shared = actual != NULL;
    if (c->corners && !actual && d->mode.kind != MODE_GIVEN)
        c->actual = flk_actual_open(d, c->corners, acting, c->end, c->period, c->winds);
    return c->corners && (c->actual || d->mode.kind == MODE_GIVEN);
}

void flk_course_close(flk_course *c)
{
    flk_actual_free(c->is_shared ? NULL : c->actual);
    flk_corners_close(c->corners);
}

int flk_course_stops(const flk_course *c, fourlink_branch branch)
{
    const flk_actual_facts *f = flk_actual_facts_of(c->actual, branch);

    return f && f->status == FOURLINK_TOO_LONG;
}

int flk_course_repeats(const flk_course *c)
{
    const fourlink_motion *motion = &c->d->motion;

    if (c->actual || c->d->program || c->d->prescribed)
        return c->d->mode.kind == MODE_STEADY;
    return !c->winds && motion->run_up <= 0 && !c->range.stops &&
           (motion->acceleration == 0 || motion->hold);
}

int flk_course_is_periodic(const flk_course *c)
{
    const fourlink_mechanism *mechanism = &c->d->machine.mechanism;

    return c->d->one_revolution && flk_course_repeats(c) &&
           mechanism->change_stretched == mechanism->change_folded;
}

int flk_course_pass(const flk_course *c, fourlink_branch branch, double angle, int *status,
                    fourlink_row *row, flk_actual_row *actual)
{
    int is_by_angle = c->over.is_crank_angle;
    double time;

    if (c->d->program) {
        if (!flk_course_pass_program(c, branch, flk_motion_theta2(&c->d->motion, angle), &time))
            return 0;
        *status = c->type->at(c, branch, 0, time, row, actual);
        return 1;
    }
    if (c->d->prescribed)
        return pass_coordinate(c, branch, flk_motion_theta2(&c->d->motion, angle), status, row);
    if (is_by_angle ? !c->type->find(c, angle, &angle)
                    : !FLK_WITHIN(angle * c->d->motion.angle_unit, ANGLE_MAX))
        return 0;
    *status = (c->actual ? at_angle : at_given)(c, branch, 0, angle, row, actual);
    row->place = is_by_angle ? angle : row->time;
    return 1;
}

void flk_course_set_prescribed(const flk_course *c, double place, fourlink_state *state)
{
    const deck_prescribed *x = c->d->prescribed;
    flk_prescribed at;
    fourlink_row row;

    flk_course_prescribed_at(x, place, &at, &row);
    flk_coordinate_set(x->q, &at, state);
}

int flk_course_swing(const flk_course *c, fourlink_branch branch, double place, double theta2,
                     int angles, fourlink_state *state)
{
    const deck_prescribed *x = c->d->prescribed;
    flk_prescribed at;
    fourlink_row row;

    flk_course_prescribed_at(x, place, &at, &row);
    return flk_coordinate_swing(x->q, &c->d->machine.mechanism, branch, &at, theta2, angles, state);
}

/* The crank after an angle passed. */
static int crank_after(const void *data, double passed, fourlink_crank *crank)
{
    const flk_pieces *x = data;
    int is_second = x->one_side > 0 && passed >= x->one_side, status;
    double place = x->first + x->rate * (is_second ? passed - x->one_side : passed);
    flk_actual_row actual;
    fourlink_row row;

    status = x->course->type->at(x->course, x->branch,
                                 is_second ? FOURLINK_FALLING : flk_course_first_side(x->course),
                                 place, &row, &actual);
    *crank = row.crank;
    return status == FOURLINK_OK;
}

/* End a piece where a speed crosses a level of a load. */
static void end_at_speed(const flk_pieces *x, flk_piece *piece)
{
    flk_moving moving;
    double corner;

    moving.branch = x->branch;
    moving.at = crank_after;
    moving.data = x;
    corner = flk_corners_of_speed(x->course->corners, &moving, piece->from, piece->to);
    if (!(corner < piece->to))
        return;
    piece->to = corner;
    piece->end = FLK_END_PLAIN;
}

int flk_pieces_next(const flk_pieces *x, flk_piece *piece)
{
    if (!(piece->to < x->length))
        return 0;
    piece->begin = piece->end;
    piece->from = piece->to;
    x->course->type->next(x, piece);
    if (x->has_loads && x->course->corners->n_of_speed)
        end_at_speed(x, piece);
    return 1;
}
