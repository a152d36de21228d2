/* SPDX-License-Identifier: GPL-3.0-or-later
**
** found_text.c - the linkage found for [synthesis] in the text of its deck: comments on what was found and
** checked, and [expect] sections with the wanted values.
*/
#include <float.h>
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/number.h"
#include "base/trig.h"
#include "mechanics/kind.h"
#include "found_text.h"
#include "numbers.h"
#include "parser.h"
#include "settings.h"
#include "synthesis.h"

/* Below this rounding decides what is dead: rad, for links of one length; else times the root of their
** ratio. */
#define DEAD 1e-6
#define ROUNDING 1e-12 /* relative, of the values that prove a linkage */

/* Add an item to a list: " 1, 3". */
static void append(char list[MESSAGE_SIZE], const char *format, ...)
{
    size_t length = strlen(strcat(list, *list ? "," : ""));
    va_list values;

    va_start(values, format);
    flk_message_list(list + length, MESSAGE_SIZE - length, format, values);
    va_end(values);
}

/* --------------------------------------------------------------------------------------- defects */

/* The positions on a branch, or on none: " 2", "s 1, 3". */
static char *list_positions(const fourlink_solution *s, int branch, char list[MESSAGE_SIZE + 1])
{
    int i;

    memcpy(list, "s", 2);
    for (i = 0; i < s->n_positions && strlen(list) < MESSAGE_SIZE / 3; i++)
        if (s->position[i].branch == branch)
            append(list + 1, " %ld", (long)i + 1);
    return strchr(list, ',') ? list : list + 1;
}

void flk_synthesis_tell_defects(parser *p)
{
    static const char *const texts[] = {
        "branch defect: open at position%s, crossed at position%s",
        "circuit defect: the linkage has to be taken apart between two positions",
        "order defect: the crank does not pass the positions in their order",
        "dead position at position%s",
        "a dead position lies between the first and the last position",
        "the crank does not reach the whole working range",
        "a position is not met"};
    deck_synthesis *t = p->d->synthesis;
    char names[MESSAGE_SIZE] = "", first[MESSAGE_SIZE + 1], second[MESSAGE_SIZE + 1];
    int bit, i;

    for (i = 0; i < (int)(sizeof texts / sizeof texts[0]); i++) {
        bit = 1 << i;
        if (!(t->chosen->defects & bit))
            continue;
        append(names, " %s", fourlink_defect_text(bit));
        flk_mistake(
            &p->d->defects, t->place, texts[i],
            list_positions(t->chosen, bit == FOURLINK_DEFECT_DEAD ? 0 : FOURLINK_OPEN, first),
            list_positions(t->chosen, FOURLINK_CROSSED, second));
    }
    flk_text_copy(flk_text_of(*names ? names + 1 : "none"), t->defects, sizeof t->defects);
}

/* ---------------------------------------------------------------------------------------- values */

static const deck_unit *printed_unit(const parser *p, quantity q)
{
    return q == QUANTITY_LENGTH ? &p->d->synthesis->length : &p->d->bare[q];
}

/* Write a number with 15 digits if no more than rounding is lost: 210 deg, not 209.99999999999997. */
static char *write_number(double si, const deck_unit *u, char out[DIGITS_SIZE])
{
    double value = flk_unit_from_si(si, u->unit), same;
    text t = flk_text_of(flk_digits_short(value, 15, out));

    if (flk_number_read(&t, &same) != NUMBER_OK || fabs(same - value) > 4e-16 * fabs(value))
        flk_number_in_unit(si, &u->unit, out);
    return out;
}

/* Keep a text; empty if out of memory. */
static const char *keep_text(parser *p, const char *string)
{
    const char *kept = flk_reader_copy(p, flk_text_of(string), "");

    return kept ? kept : "";
}

const char *flk_found_value(parser *p, double si, quantity q)
{
    char number[DIGITS_SIZE], value[MESSAGE_SIZE];
    int is_number = q == QUANTITY_NUMBER;

    return keep_text(p, flk_text_join(value, sizeof value,
                                      write_number(si, printed_unit(p, q), number),
                                      is_number ? "" : " ",
                                      is_number ? "" : printed_unit(p, q)->name, (char *)NULL));
}

const char *flk_found_point(parser *p, fourlink_vector at)
{
    const deck_unit *u = printed_unit(p, QUANTITY_LENGTH);
    char x[DIGITS_SIZE], y[DIGITS_SIZE], value[MESSAGE_SIZE];

    return keep_text(p, flk_text_join(value, sizeof value, "(", write_number(at.x, u, x), ", ",
                                      write_number(at.y, u, y), ") ", u->name, (char *)NULL));
}

/* ------------------------------------------------------------------------------------------ text */

/* A text that grows line by line. */
typedef struct page {
    parser *p;
    char *lines;
    size_t length, room;
} page;

static void put_line(page *g, const char *format, ...)
{
    char line[MESSAGE_SIZE], *more;
    va_list values;

    va_start(values, format);
    flk_message_list(line, sizeof line, format, values);
    va_end(values);
    if (g->length + strlen(line) + 2 > g->room) {
        more = flk_reader_keep(g->p, 2 * (g->length + MESSAGE_SIZE));
        if (!more)
            return;
        g->room = 2 * (g->length + MESSAGE_SIZE);
        g->lines = g->lines ? strcpy(more, g->lines) : more;
    }
    strcat(strcpy(g->lines + g->length, line), "\n");
    g->length += strlen(line) + 1;
}

/* ---------------------------------------------------------------------------------------- proofs */

/* The factor by which rounding grows on the way from the task to a position. */
static double growth(const fourlink_solution *s, double mu)
{
    double factor = s->ratio / GSL_MAX(flk_sine(mu), 1e-3);

    return factor > 0 && factor < 1e6 ? factor : 1e6;
}

/* [expect] with a value, at a crank angle or, if `theta2` is null, of the whole motion. */
static void put_expect(page *g, const double *theta2, int branch, const char *name, double value,
                       double tolerance, quantity q)
{
    const deck_unit *u = printed_unit(g->p, q);

    put_line(g, "");
    put_line(g, "[expect]");
    if (theta2)
        put_line(g, "at = %s", flk_found_value(g->p, *theta2, QUANTITY_ANGLE));
    put_line(g, "branch = %s", fourlink_branch_text(branch));
    if (tolerance <= 1e-6) /* two digits may be 5 % less */
        tolerance *= 1.06;
    put_line(g, tolerance > 1e-6 ? "tolerance = %g%s%s" : "tolerance = %.2g%s%s",
             flk_unit_from_si(tolerance, u->unit), q == QUANTITY_NUMBER ? "" : " ",
             q == QUANTITY_NUMBER ? "" : u->name);
    put_line(g, "%s = %s", name, flk_found_value(g->p, value, q));
}

static void put_position(page *g, const fourlink_precision *at, const char *point_name)
{
    const deck_synthesis *t = g->p->d->synthesis;
    const fourlink_solution *s = t->chosen;
    double rounding = ROUNDING + 4 * DBL_EPSILON * fabs(at->theta2);
    double small = rounding * growth(s, at->mu), size = 0, error = 0;
    char name[2 * DECK_NAME_SIZE];
    int k;

    for (k = FOURLINK_GROUND; k <= FOURLINK_FOLLOWER; k++)
        size = GSL_MAX(size, s->design.link[k].length);
    if (t->task == TASK_FUNCTION) {
        for (k = 0; k < s->n_positions && t->function.n > 3; k++)
            if (fabs(s->position[k].error) > error) /* it may be NaN */
                error = fabs(s->position[k].error);
        put_expect(g, &at->theta2, at->branch, t->kind->column, at->output,
                   (1 + 1e-6) * error + small * (t->kind->output == QUANTITY_LENGTH ? size : 1),
                   t->kind->output);
        return;
    }
    flk_text_join(name, sizeof name, point_name, ".x", (char *)NULL);
    put_expect(g, &at->theta2, at->branch, name, at->point.x,
               t->has_points ? (1 + 1e-6) * s->largest + small * size : small * size,
               QUANTITY_LENGTH);
    put_line(g, "%s.y = %s", point_name, flk_found_value(g->p, at->point.y, QUANTITY_LENGTH));
    if (t->task != TASK_PATH || !t->has_points)
        put_expect(g, &at->theta2, at->branch, "theta3", at->theta3,
                   t->has_points ? (1 + 1e-6) * fabs(s->max_error) + small : small, QUANTITY_ANGLE);
}

/* 1 if the motion of the deck reaches a crank angle, whatever its turns. */
static int is_reached(parser *p, double theta2)
{
    const setting *at = flk_setting_find(p, KEY_MOTION_AT);
    double from = IS_SET(at) ? at->si[0] : flk_setting_or(p, KEY_MOTION_FROM, 0);
    double to = IS_SET(at) ? from : flk_setting_or(p, KEY_MOTION_TO, from + 2 * M_PI);
    double low = GSL_MIN(from, to);

    return flk_cycle_place(theta2, low, 2 * M_PI) - low <= fabs(to - from) + 1e-12;
}

static void put_positions(page *g, const char *point_name)
{
    const fourlink_solution *s = g->p->d->synthesis->chosen;
    int i;

    for (i = 0; i < s->n_positions; i++) {
        const fourlink_precision *at = &s->position[i];
        int status = !is_reached(g->p, at->theta2)    ? FOURLINK_NO_SUCH_ANGLE
                     : at->status != FOURLINK_OK      ? at->status
                     : at->mu > DEAD * sqrt(s->ratio) ? FOURLINK_OK
                                                      : FOURLINK_DEAD_POSITION;

        if (status == FOURLINK_OK)
            put_position(g, at, point_name);
        else
            put_line(g, "# position %ld: %s", (long)i + 1, fourlink_status_text(status));
    }
}

/* The facts that prove a quick return.  A slider-crank without offset has no time ratio: it is 1. */
static void put_facts(page *g)
{
    const fourlink_quick_return_task *t = &g->p->d->synthesis->quick_return;
    const fourlink_solution *s = g->p->d->synthesis->chosen;
    double small = ROUNDING * growth(s, s->mu_min);
    int branch = (int)s->branch;

    if (t->time_ratio > 0 && (t->type != FOURLINK_ENGINE || s->design.offset != 0))
        put_expect(g, NULL, branch, "time_ratio", t->time_ratio, small * t->time_ratio,
                   QUANTITY_NUMBER);
    if (t->swing > 0)
        put_expect(g, NULL, branch, "swing", t->swing, small, QUANTITY_ANGLE);
    if (t->type == FOURLINK_ENGINE)
        put_expect(g, NULL, branch, "stroke", t->stroke, small * t->stroke, QUANTITY_LENGTH);
}

/* ------------------------------------------------------------------------------------- comments */

/* A solution in one line. */
static void put_solution(page *g, unsigned long number)
{
    const deck_synthesis *t = g->p->d->synthesis;
    const fourlink_solution *s = &t->solutions[number];
    const flk_kind *kind = flk_kind_of(s->design.kind);
    char lengths[MESSAGE_SIZE] = "";
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER + 1; i++) {
        int is_link = i <= FOURLINK_FOLLOWER;
        double length = is_link ? s->design.link[i].length : s->design.offset;

        if (length != 0)
            append(lengths, " %s %.6g", is_link ? kind->link[i] : "offset",
                   flk_unit_from_si(length, t->length.unit));
    }
    if (t->has_points)
        append(lengths, " rms distance %.4g", flk_unit_from_si(s->rms, t->length.unit));
    put_line(g, "#   %ld:%s (%s); %s, %s; mu_min %.4g deg; %s", (long)number + 1, lengths,
             t->length.name, fourlink_branch_text((int)s->branch), fourlink_type_text((int)s->type),
             FLK_DEGREES(s->mu_min), s->defects ? "with a defect" : "no defect");
}

static void put_task(page *g)
{
    const deck_synthesis *t = g->p->d->synthesis;
    const fourlink_solution *s = t->chosen;
    const deck_unit *u = &t->length;
    double one = t->kind->output == QUANTITY_ANGLE ? 1 : flk_unit_to_si(1, u->unit);
    unsigned long i;

    put_line(g, "# Found by fourlink --synthesis: solution %ld of %ld of %s:%ld",
             (long)(s - t->solutions) + 1, (long)t->n, t->place.source, t->place.line);
    for (i = 0; i < t->n_kept && i < MOST_LISTED; i++)
        put_solution(g, i);
    if (t->n > i)
        put_line(g, "#   %ld more: fourlink --synthesis --format=table", (long)(t->n - i));
    if (t->task == TASK_FUNCTION)
        put_line(g, t->kind->constants, s->K[0] / one, s->K[1] / (one * one),
                 s->K[2] / (one * one));
    if (s->crank_turn != 0)
        put_line(
            g, "# a = %g %s: the crank is turned by 180 deg: wanted crank angle = theta2 - %g deg",
            flk_unit_from_si(s->a, u->unit), u->name, FLK_DEGREES(s->crank_turn));
    if (s->rocker_turn != 0)
        put_line(g, "# c = %g %s: the rocker is turned by 180 deg: wanted angle = theta4 - %g deg",
                 flk_unit_from_si(s->c, u->unit), u->name, FLK_DEGREES(s->rocker_turn));
    if (s->has_point) {
        put_line(g, "# The pivot A is at %s in the axes of the task,",
                 flk_found_point(g->p, s->origin));
        put_line(g, "# where the %s is at %s.",
                 s->design.link[FOURLINK_GROUND].length > 0 ? "line from A to D"
                                                            : "direction of stroke",
                 flk_found_value(g->p, s->direction, QUANTITY_ANGLE));
    }
}

static void put_error(page *g)
{
    const deck_synthesis *t = g->p->d->synthesis;
    const deck_wanted *w = &t->wanted;
    double error = t->chosen->max_error;
    int is_angle = t->kind->output == QUANTITY_ANGLE;

    put_line(g, "#   %s: largest %.6g %s at theta2 = %.6g deg",
             t->function.wanted ? "structural error" : "error at the points",
             is_angle ? FLK_DEGREES(error) : flk_unit_from_si(error, t->length.unit),
             is_angle ? "deg" : t->length.name, FLK_DEGREES(t->chosen->max_error_at));
    if (t->function.wanted)
        put_line(g, "#   in units of y: %.6g",
                 error * (w->y[1] - w->y[0]) / (w->output[1] - w->output[0]));
}

/* How closely many positions are met, and what was searched. */
static void put_distances(page *g)
{
    const deck_synthesis *t = g->p->d->synthesis;
    const fourlink_solution *s = t->chosen;
    const unit u = t->length.unit;
    double one = flk_unit_to_si(1, u);

    put_line(g, "#   the best of %ld starts; a better linkage may exist", (long)s->starts);
    put_line(g, "#   distance %s: root mean square %.6g %s, largest %.6g %s, sum of squares %.6g",
             t->task == TASK_MOTION ? "of the point"
             : t->points.timing     ? "at the given crank angles"
                                    : "from the curve",
             flk_unit_from_si(s->rms, u), t->length.name, flk_unit_from_si(s->largest, u),
             t->length.name, s->sum / (one * one));
    if (t->task == TASK_MOTION)
        put_line(g, "#   angle of the coupler: largest error %.6g deg", FLK_DEGREES(s->max_error));
    if (s->is_swapped)
        put_line(g, "#   the crank stands on the pivot given as right");
}

static void put_checks(page *g)
{
    const deck_synthesis *t = g->p->d->synthesis;
    const fourlink_solution *s = t->chosen;
    const mistakes *defects = &g->p->d->defects;
    size_t i;

    put_line(g, "# Checks");
    put_line(g, "#   type: %s; longest / shortest link %.4g", fourlink_type_text((int)s->type),
             s->ratio);
    for (i = 0; i < defects->count; i++)
        put_line(g, "#   defect: %s", defects->list[i].message);
    if (!s->defects && t->task != TASK_QUICK_RETURN) {
        put_line(g, "#   all positions are on the %s branch and on one circuit%s,",
                 fourlink_branch_text((int)s->branch),
                 s->is_in_order ? ", the crank passes them in their order" : "");
        put_line(g, "#   and %s from theta2 = %.6g to %.6g deg",
                 s->mu_min > DEAD ? "without a dead position" : "through a change point",
                 FLK_DEGREES(s->from), FLK_DEGREES(s->to));
    }
    put_line(
        g,
        "#   transmission angle: smallest %.6g deg at theta2 = %.6g deg; at the positions %.6g deg",
        FLK_DEGREES(s->mu_min), FLK_DEGREES(s->mu_min_at), FLK_DEGREES(s->mu_positions));
    if (s->condition > 1)
        put_line(g, "#   condition of the linear equations: %.4g", s->condition);
    if (t->task == TASK_FUNCTION && (t->function.wanted || t->function.n > 3))
        put_error(g);
    if (t->has_points)
        put_distances(g);
    put_line(g, "");
}

void flk_found_write(parser *p, const char *point_name)
{
    deck_synthesis *t = p->d->synthesis;
    page head, tail;

    memset(&head, 0, sizeof head);
    head.p = p;
    tail = head;
    put_task(&head);
    put_checks(&head);
    put_line(&tail, "");
    put_line(&tail, "# The wanted values, met within %s: fourlink --check",
             t->has_points || (t->task == TASK_FUNCTION && t->function.n > 3)
                 ? "the largest error of the fit"
                 : "rounding");
    if (t->task == TASK_QUICK_RETURN)
        put_facts(&tail);
    else
        put_positions(&tail, point_name);
    t->head = head.lines ? head.lines : "";
    t->tail = tail.lines ? tail.lines : "";
}
