/* SPDX-License-Identifier: GPL-3.0-or-later
**
** found_text.c - the linkage found for [synthesis] in the text of its deck: comments on what was found and checked, and
** [expect] sections with the wanted values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "mechanics/kind.h"
#include "reader.h"
#include "synthesis.h"

#define DEAD 1e-6      /* rad, for links of one length: below it rounding decides what is dead */
#define ROUNDING 1e-12 /* relative, of the values that prove a linkage */

/* --------------------------------------------------------------------------------------- defects */

/* The positions on a branch: " 1, 3". */
static char *list_positions(const fourlink_solution *s, int branch, char list[MESSAGE_SIZE])
{
    int i;

    list[0] = '\0';
    for (i = 0; i < s->n_positions && strlen(list) < MESSAGE_SIZE / 3; i++)
        if (s->position[i].branch == branch)
            flk_message(list + strlen(list), MESSAGE_SIZE - strlen(list), "%s %ld",
                        *list ? "," : "", (long)i + 1);
    return list;
}

int flk_synthesis_defect(const deck_synthesis *t, int i, char words[MESSAGE_SIZE])
{
    static const char *const texts[] = {
        "branch defect: open at position%s, crossed at%s",
        "circuit defect: the linkage has to be taken apart between two positions",
        "order defect: the crank does not pass the positions in their order",
        "dead position at position%s",
        "a dead position lies between the first and the last position",
        "the crank does not reach the whole working range",
        "a position is not met"};
    const fourlink_solution *s = t->chosen;
    char first[MESSAGE_SIZE], second[MESSAGE_SIZE];
    int bit;

    for (bit = 0; bit < (int)(sizeof texts / sizeof texts[0]); bit++)
        if (s->defects & 1 << bit && i-- == 0) {
            int is_dead = 1 << bit == FOURLINK_DEFECT_DEAD;

            flk_message(words, MESSAGE_SIZE, texts[bit],
                        list_positions(s, is_dead ? 0 : FOURLINK_OPEN, first),
                        list_positions(s, FOURLINK_CROSSED, second));
            return 1;
        }
    return 0;
}

/* ---------------------------------------------------------------------------------------- values */

static const deck_unit *unit_of(const parser *p, quantity q)
{
    return q == QUANTITY_LENGTH ? &p->d->synthesis->length : &p->d->bare[q];
}

/* Write a number with 15 digits if no more than rounding is lost: 210 deg, not 209.99999999999997. */
static void put_number(double si, const unit *u, char out[DIGITS_SIZE])
{
    double value = flk_unit_from_si(si, *u), same;
    text t = flk_text_of(flk_digits_short(value, 15, out));

    if (flk_number_read(&t, &same) != NUMBER_OK || fabs(same - value) > 4e-16 * fabs(value))
        flk_number_in_unit(si, u, out);
}

char *flk_found_value(const parser *p, double si, quantity q, char out[FLK_VALUE_SIZE])
{
    const deck_unit *u = unit_of(p, q);

    put_number(si, &u->unit, out);
    return q == QUANTITY_NUMBER ? out : strcat(strcat(out, " "), u->name);
}

char *flk_found_point(const parser *p, fourlink_vector at, char out[FLK_VALUE_SIZE])
{
    const deck_unit *u = unit_of(p, QUANTITY_LENGTH);
    char x[DIGITS_SIZE], y[DIGITS_SIZE];

    put_number(at.x, &u->unit, x);
    put_number(at.y, &u->unit, y);
    return flk_text_join(out, FLK_VALUE_SIZE, "(", x, ", ", y, ") ", u->name, (char *)NULL);
}

/* ------------------------------------------------------------------------------------------ text */

/* A text that grows line by line. */
typedef struct page {
    parser *p;
    char *lines;
    size_t length, room;
} page;

static void put(page *g, const char *line)
{
    size_t length = strlen(line), room = 2 * (g->length + length) + 1000;
    char *more = g->lines;

    if (g->length + length + 2 > g->room) {
        more = flk_reader_keep(g->p, room);
        if (!more)
            return;
        if (g->length)
            memcpy(more, g->lines, g->length);
        g->room = room;
        g->lines = more;
    }
    memcpy(more + g->length, line, length);
    more[g->length + length] = '\n';
    g->length += length + 1;
    more[g->length] = '\0';
}

static const char *text_of(const page *g)
{
    return g->lines ? g->lines : "";
}

/* The factor by which rounding grows on the way from the task to a position. */
static double growth(const fourlink_solution *s, double mu)
{
    double factor = s->ratio / GSL_MAX(sin(mu), 1e-3);

    return factor > 0 && factor < 1e6 ? factor : 1e6;
}

/* [expect] with one value of a quantity. */
static void put_value(page *g, const char *name, double value, double tolerance, quantity q)
{
    char line[MESSAGE_SIZE], number[FLK_VALUE_SIZE];
    const char *unit_name = q == QUANTITY_NUMBER ? "" : unit_of(g->p, q)->name;

    put(g, flk_message(line, sizeof line,
                       tolerance > 1e-6 ? "tolerance = %g%s%s" : "tolerance = %.2g%s%s",
                       flk_unit_from_si(tolerance, unit_of(g->p, q)->unit), *unit_name ? " " : "",
                       unit_name));
    put(g,
        flk_message(line, sizeof line, "%s = %s", name, flk_found_value(g->p, value, q, number)));
}

static void put_section(page *g, const double *theta2, int branch)
{
    char line[MESSAGE_SIZE], number[FLK_VALUE_SIZE];

    put(g, "");
    put(g, "[expect]");
    if (theta2)
        put(g, flk_message(line, sizeof line, "at = %s",
                           flk_found_value(g->p, *theta2, QUANTITY_ANGLE, number)));
    put(g, flk_message(line, sizeof line, "branch = %s", fourlink_branch_text(branch)));
}

/* The values that prove a position. */
static void put_position(page *g, const fourlink_solution *s, int i, const char *point_name)
{
    const deck_synthesis *t = g->p->d->synthesis;
    const fourlink_precision *at = &s->position[i];
    int is_fit = t->task == TASK_FUNCTION && t->function.n > 3;
    double factor = growth(s, at->mu), size = 0, error = 0;
    char name[2 * DECK_NAME_SIZE];
    int k;

    for (k = FOURLINK_GROUND; k <= FOURLINK_FOLLOWER; k++)
        size = GSL_MAX(size, s->design.link[k].length);
    for (k = 0; k < s->n_positions && is_fit; k++)
        if (fabs(s->position[k].error) > error) /* it may be NaN */
            error = fabs(s->position[k].error);
    put_section(g, &at->theta2, at->branch);
    if (t->task == TASK_FUNCTION && s->design.kind == FOURLINK_FOUR_BAR) {
        put_value(g, "theta4", at->output, (1 + 1e-6) * error + ROUNDING * factor, QUANTITY_ANGLE);
        return;
    }
    if (t->task == TASK_FUNCTION) {
        put_value(g, "C.x", at->output, (1 + 1e-6) * error + ROUNDING * factor * size,
                  QUANTITY_LENGTH);
        return;
    }
    put_value(g, flk_text_join(name, sizeof name, point_name, ".x", (char *)NULL), at->point.x,
              ROUNDING * factor * size, QUANTITY_LENGTH);
    {
        char line[MESSAGE_SIZE], number[FLK_VALUE_SIZE];

        put(g, flk_message(line, sizeof line, "%s.y = %s", point_name,
                           flk_found_value(g->p, at->point.y, QUANTITY_LENGTH, number)));
    }
    put_section(g, &at->theta2, at->branch);
    put_value(g, "theta3", at->theta3, ROUNDING * factor, QUANTITY_ANGLE);
}

/* 1 if the motion of the deck reaches a crank angle, whatever its turns. */
static int is_reached(parser *p, double theta2)
{
    const setting *at = flk_setting_find(p, KEY_MOTION_AT);
    double from = IS_SET(at) ? at->si[0] : flk_setting_or(p, KEY_MOTION_FROM, 0);
    double to = IS_SET(at) ? from : flk_setting_or(p, KEY_MOTION_TO, from + 2 * M_PI);
    double low = GSL_MIN(from, to) - 1e-12, beyond = fmod(theta2 - low, 2 * M_PI);

    return (beyond < 0 ? beyond + 2 * M_PI : beyond) <= fabs(to - from) + 2e-12;
}

/* The facts that prove a quick return. */
static void put_facts(page *g, const fourlink_solution *s)
{
    const fourlink_quick_return_task *t = &g->p->d->synthesis->quick_return;
    double e = ROUNDING * growth(s, s->mu_min);

    if (t->time_ratio > 0) {
        put_section(g, NULL, (int)s->branch);
        put_value(g, "time_ratio", t->time_ratio, e * t->time_ratio, QUANTITY_NUMBER);
    }
    if (t->swing > 0) {
        put_section(g, NULL, (int)s->branch);
        put_value(g, "swing", t->swing, e, QUANTITY_ANGLE);
    }
    if (t->type == FOURLINK_ENGINE) {
        put_section(g, NULL, (int)s->branch);
        put_value(g, "stroke", t->stroke, e * t->stroke, QUANTITY_LENGTH);
    }
}

static void put_proof(page *g, const char *point_name)
{
    const deck_synthesis *t = g->p->d->synthesis;
    const fourlink_solution *s = t->chosen;
    char line[MESSAGE_SIZE];
    int i;

    put(g, "");
    put(g, t->task == TASK_FUNCTION && t->function.n > 3
               ? "# The wanted values, met within the largest error of the fit: fourlink --check"
               : "# The wanted values, met within rounding: fourlink --check");
    if (t->task == TASK_QUICK_RETURN)
        put_facts(g, s);
    for (i = 0; i < s->n_positions && t->task != TASK_QUICK_RETURN; i++)
        if (!is_reached(g->p, s->position[i].theta2))
            put(g, flk_message(line, sizeof line, "# position %ld: %s", (long)i + 1,
                               fourlink_status_text(FOURLINK_NO_SUCH_ANGLE)));
        else if (s->position[i].status == FOURLINK_OK && s->position[i].mu > DEAD * s->ratio)
            put_position(g, s, i, point_name);
        else
            put(g, flk_message(line, sizeof line, "# position %ld: %s", (long)i + 1,
                               fourlink_status_text(s->position[i].status == FOURLINK_OK
                                                        ? FOURLINK_DEAD_POSITION
                                                        : s->position[i].status)));
}

/* ------------------------------------------------------------------------------------- comments */

/* A solution in one line. */
static void put_solution(page *g, unsigned long number)
{
    const deck_synthesis *t = g->p->d->synthesis;
    const fourlink_solution *s = &t->solutions[number];
    const flk_kind *kind = flk_kind_of(s->design.kind);
    const unit *u = &t->length.unit;
    char line[MESSAGE_SIZE];
    size_t n;
    int i;

    flk_message(line, sizeof line, "#   %ld:", (long)number + 1);
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER + 1; i++) {
        double length = i > FOURLINK_FOLLOWER ? s->design.offset : s->design.link[i].length;

        n = strlen(line);
        if (length != 0)
            flk_message(line + n, sizeof line - n, "%s %s %.6g", line[n - 1] == ':' ? "" : ",",
                        i > FOURLINK_FOLLOWER ? "offset" : kind->link[i],
                        flk_unit_from_si(length, *u));
    }
    n = strlen(line);
    flk_message(line + n, sizeof line - n, " (%s); %s, %s; mu_min %.4g deg; %s", t->length.name,
                fourlink_branch_text((int)s->branch), fourlink_type_text((int)s->type),
                FLK_DEGREES(s->mu_min), s->defects ? "with a defect" : "no defect");
    put(g, line);
}

/* The linear equations of a function generator as a student writes them, and what follows. */
static void put_equations(page *g)
{
    const deck_synthesis *t = g->p->d->synthesis;
    const fourlink_solution *s = t->chosen;
    int is_four_bar = s->design.kind == FOURLINK_FOUR_BAR;
    double length = is_four_bar ? 1 : flk_unit_to_si(1, t->length.unit);
    char line[MESSAGE_SIZE];
    unsigned long i;

    put(g, is_four_bar
               ? "# K1 cos(theta4) - K2 cos(theta2) + K3 = cos(theta2 - theta4) at the points:"
               : "# S1 X cos(theta2) + S2 sin(theta2) - S3 = X^2 at the points:");
    for (i = 0; i < t->function.n && i < MOST_LISTED; i++) {
        double y = t->output[i] / length, c2, s2, c4, s4;

        flk_vector_direction(t->theta2[i], &c2, &s2);
        flk_vector_direction(y, &c4, &s4);
        put(g, is_four_bar ? flk_message(line, sizeof line, "#   %.6g K1 %s %.6g K2 + K3 = %.6g",
                                         c4, c2 < 0 ? "+" : "-", fabs(c2), c2 * c4 + s2 * s4)
                           : flk_message(line, sizeof line, "#   %.6g S1 %s %.6g S2 - S3 = %.6g",
                                         y * c2, s2 < 0 ? "-" : "+", fabs(s2), y * y));
    }
    if (t->function.n > MOST_LISTED)
        put(g, "#   ...");
    put(g, flk_message(line, sizeof line,
                       is_four_bar ? "# K1 = %g, K2 = %g, K3 = %g" : "# S1 = %g, S2 = %g, S3 = %g",
                       s->K[0] / length, s->K[1] / length, s->K[2] / (length * length)));
    put(g, is_four_bar ? "# a = d/K1, c = d/K2, b^2 = a^2 + c^2 + d^2 - 2 a c K3"
                       : "# r = S1/2, e = S2/S1, l^2 = r^2 + e^2 - S3");
}

/* The equations of a quick return. */
static void put_dead_centres(page *g)
{
    const fourlink_quick_return_task *t = &g->p->d->synthesis->quick_return;
    double sense = t->slow == FOURLINK_SLOW_AGAINST ? -1 : 1, Q = t->time_ratio;
    char line[MESSAGE_SIZE];

    if (t->type == FOURLINK_WHITWORTH) {
        put(g, "# cos(180 deg/(Q + 1)) = d/a");
        return;
    }
    put(g, flk_message(line, sizeof line, "# alpha = %s = %.9g deg",
                       Q > 0 ? "180 deg (Q - 1)/(Q + 1)" : "swing",
                       Q > 0 ? sense * 180 * (Q - 1) / (Q + 1) : FLK_DEGREES(t->swing)));
    if (t->type == FOURLINK_CRANK_ROCKER) {
        put(g, "# a^2 cos^2(alpha/2) + b^2 sin^2(alpha/2) = c^2 sin^2(psi/2), psi the swing");
        put(g, "# a^2 cos^2((psi - alpha)/2) + b^2 sin^2((psi - alpha)/2) = d^2 sin^2(psi/2)");
    } else if (t->type == FOURLINK_ENGINE) {
        put(g, "# r^2 cos^2(alpha/2) + l^2 sin^2(alpha/2) = s^2/4, e = (l^2 - r^2) sin(alpha)/s");
    } else if (t->offset == 0) {
        put(g, "# a = d sin(alpha/2)");
    }
}

static void put_task(page *g)
{
    const deck_synthesis *t = g->p->d->synthesis;
    const fourlink_solution *s = t->chosen;
    const unit *u = &t->length.unit;
    char line[MESSAGE_SIZE], value[FLK_VALUE_SIZE];
    unsigned long i;

    put(g, flk_message(line, sizeof line,
                       "# Found by fourlink --synthesis: solution %ld of %ld of %s:%ld",
                       (long)(s - t->solutions) + 1, (long)t->n, t->place.source, t->place.line));
    for (i = 0; i < t->n_kept && i < MOST_LISTED; i++)
        put_solution(g, i);
    if (t->task == TASK_FUNCTION)
        put_equations(g);
    if (t->task == TASK_QUICK_RETURN)
        put_dead_centres(g);
    if (s->crank_turn != 0)
        put(g, flk_message(line, sizeof line,
                           "# a = %g %s: the crank is turned by 180 deg: wanted crank angle = "
                           "theta2 - %g deg",
                           flk_unit_from_si(s->a, *u), t->length.name, FLK_DEGREES(s->crank_turn)));
    if (s->rocker_turn != 0)
        put(g,
            flk_message(line, sizeof line,
                        "# c = %g %s: the rocker is turned by 180 deg: wanted angle = theta4 - "
                        "%g deg",
                        flk_unit_from_si(s->c, *u), t->length.name, FLK_DEGREES(s->rocker_turn)));
    if (s->has_point) {
        put(g, flk_message(line, sizeof line, "# The pivot A is at %s in the axes of the task,",
                           flk_found_point(g->p, s->origin, value)));
        put(g, flk_message(line, sizeof line, "# where the line from A to D is at %s.",
                           flk_found_value(g->p, s->direction, QUANTITY_ANGLE, value)));
    }
}

static void put_checks(page *g)
{
    const deck_synthesis *t = g->p->d->synthesis;
    const fourlink_solution *s = t->chosen;
    const deck_wanted *w = &t->wanted;
    char line[MESSAGE_SIZE], words[MESSAGE_SIZE];
    int i, is_quick = t->task == TASK_QUICK_RETURN;

    put(g, "# Checks");
    put(g, flk_message(line, sizeof line, "#   type: %s; longest / shortest link %.4g",
                       fourlink_type_text((int)s->type), s->ratio));
    for (i = 0; flk_synthesis_defect(t, i, words); i++)
        put(g, flk_message(line, sizeof line, "#   defect: %s", words));
    if (!s->defects && !is_quick)
        put(g, flk_message(line, sizeof line,
                           "#   all positions are on the %s branch and on one circuit, the crank "
                           "passes them in their order,",
                           fourlink_branch_text((int)s->branch)));
    if (!s->defects && !is_quick)
        put(g, flk_message(line, sizeof line,
                           "#   and without a dead position from theta2 = %.6g to %.6g deg",
                           FLK_DEGREES(s->from), FLK_DEGREES(s->to)));
    put(g, flk_message(line, sizeof line,
                       "#   transmission angle: smallest %.6g deg at theta2 = %.6g deg; at the "
                       "positions %.6g deg",
                       FLK_DEGREES(s->mu_min), FLK_DEGREES(s->mu_min_at),
                       FLK_DEGREES(s->mu_positions)));
    put(g, flk_message(line, sizeof line, "#   condition of the linear equations: %.4g",
                       s->condition));
    if (t->task != TASK_FUNCTION || (!t->function.wanted && t->function.n == 3))
        return;
    if (s->design.kind == FOURLINK_FOUR_BAR)
        flk_message(words, sizeof words, "%.6g deg", FLK_DEGREES(s->max_error));
    else
        flk_message(words, sizeof words, "%.6g %s", flk_unit_from_si(s->max_error, t->length.unit),
                    t->length.name);
    put(g,
        flk_message(line, sizeof line,
                    t->function.wanted ? "#   structural error: largest %s at theta2 = %.6g deg"
                                       : "#   error at the points: largest %s at theta2 = %.6g deg",
                    words, FLK_DEGREES(s->max_error_at)));
    if (t->function.wanted)
        put(g, flk_message(line, sizeof line, "#   in units of y: %.6g",
                           s->max_error * (w->y[1] - w->y[0]) / (w->output[1] - w->output[0])));
}

void flk_found_write(parser *p, const char *point_name)
{
    deck_synthesis *t = p->d->synthesis;
    page head, tail;

    memset(&head, 0, sizeof head);
    memset(&tail, 0, sizeof tail);
    head.p = tail.p = p;
    put_task(&head);
    put_checks(&head);
    put(&head, "");
    put_proof(&tail, point_name);
    t->head = text_of(&head);
    t->tail = text_of(&tail);
}
