/* SPDX-License-Identifier: GPL-3.0-or-later
**
** found.c - the linkage found for [synthesis]: its lengths in the deck, and its checks in words.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "mechanics/kind.h"
#include "reader.h"
#include "synthesis.h"

#define MOST_LISTED 10 /* solutions of a search */
#define DEAD \
    1e-6 /* rad, for links of one length: below it rounding decides what is a dead position */
#define ROUNDING 1e-12 /* relative, of the values that prove a linkage */

/* ------------------------------------------------------------------------------------- searching */

static int run_task(deck_synthesis *t, unsigned long max)
{
    switch (t->task) {
    case TASK_FUNCTION:
        return fourlink_synthesis_function(&t->function, max, t->solutions, &t->n);
    case TASK_MOTION:
        return fourlink_synthesis_motion(&t->motion, max, t->solutions, &t->n);
    case TASK_PATH:
        return fourlink_synthesis_path(&t->path, max, t->solutions, &t->n);
    case TASK_QUICK_RETURN:
        return fourlink_synthesis_quick_return(&t->quick_return, max, t->solutions, &t->n);
    case TASK_COGNATE:
    default:
        return fourlink_synthesis_cognate(&t->cognate, max, t->solutions, &t->n);
    }
}

/* The lengths of a function generator are found for a ground of 1 m if another link is given. */
static int run_scaled(deck_synthesis *t, unsigned long max)
{
    int status = run_task(t, max);

    if (status != FOURLINK_OK || !t->scaled_link)
        return status;
    t->function.ground = t->scaled_length / t->solutions[0].design.link[t->scaled_link].length;
    return run_task(t, max);
}

static double degrees(double angle)
{
    return angle * (180 / M_PI);
}

/* The defects in words of a line. */
static void name_defects(deck_synthesis *t)
{
    static const char *const names[] = {
        "branch", "circuit", "order", "dead position", "dead position on the way",
        "reach",  "missed"};
    char *end = t->defects;
    int bit;

    strcpy(end, t->chosen->defects ? "" : "none");
    for (bit = 0; bit < (int)(sizeof names / sizeof names[0]); bit++)
        if (t->chosen->defects & 1 << bit)
            flk_text_join(end + strlen(end), sizeof t->defects - strlen(end), *end ? ", " : "",
                          names[bit], (char *)NULL);
}

static void note(parser *p)
{
    const deck_synthesis *t = p->d->synthesis;
    const fourlink_solution *s = t->chosen;

    if (s->mu_min < t->mu_min)
        flk_mistake(NOTES(p), t->place,
                    "the transmission angle falls to %.4g deg at theta2 = %.4g deg, below %.4g deg",
                    degrees(s->mu_min), degrees(s->mu_min_at), degrees(t->mu_min));
    if (s->ratio > RATIO_USUAL)
        flk_mistake(NOTES(p), t->place,
                    "the longest link is %.4g times as long as the shortest one", s->ratio);
}

int flk_synthesis_run(parser *p)
{
    deck_synthesis *t = p->d->synthesis;
    unsigned long max = p->d->solution > MOST_LISTED ? p->d->solution : MOST_LISTED;

    max = t->task == TASK_PATH && t->path.search ? max : 1;
    t->solutions = flk_reader_keep(p, max * sizeof *t->solutions);
    if (!t->solutions)
        return 0;
    t->status = run_scaled(t, max);
    if (t->status != FOURLINK_OK)
        return flk_mistake(p->mistakes, t->place, "%s", fourlink_status_text(t->status));
    t->n_kept = GSL_MIN(t->n, max);
    if (p->d->solution > t->n_kept)
        return flk_mistake(p->mistakes, t->place, "there is no solution %ld: the task has %ld",
                           (long)p->d->solution, (long)t->n);
    t->chosen = &t->solutions[p->d->solution - 1];
    name_defects(t);
    note(p);
    return 1;
}

double flk_synthesis_error(const deck_synthesis *t, double theta2)
{
    double at = theta2 - t->chosen->crank_turn, error = GSL_NAN, output, turn = 2 * M_PI;
    double low = GSL_MIN(t->wanted.crank[0], t->wanted.crank[1]);

    if (!t->function.wanted)
        return GSL_NAN;
    at -= turn * floor((at - low) / turn + 1e-12);
    output = t->function.wanted(t->function.host, at);
    if (!gsl_finite(output) ||
        fourlink_synthesis_error(t->chosen, at, output, &error) != FOURLINK_OK)
        return GSL_NAN;
    return error;
}

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

/* A quantity with its unit, so that it is read again as the same number. */
#define VALUE_SIZE (2 * DIGITS_SIZE + 2 * DECK_NAME_SIZE)

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

static char *value_of(const parser *p, double si, quantity q, char out[VALUE_SIZE])
{
    const deck_unit *u = unit_of(p, q);

    put_number(si, &u->unit, out);
    return q == QUANTITY_NUMBER ? out : strcat(strcat(out, " "), u->name);
}

static char *point_of(const parser *p, fourlink_vector at, char out[VALUE_SIZE])
{
    const deck_unit *u = unit_of(p, QUANTITY_LENGTH);
    char x[DIGITS_SIZE], y[DIGITS_SIZE];

    put_number(at.x, &u->unit, x);
    put_number(at.y, &u->unit, y);
    return flk_text_join(out, VALUE_SIZE, "(", x, ", ", y, ") ", u->name, (char *)NULL);
}

static void set(parser *p, const char *section, const char *key, const char *value)
{
    char name[3 * DECK_NAME_SIZE];

    flk_text_join(name, sizeof name, section, ".", key, (char *)NULL);
    flk_setting_assign(p, p->d->synthesis->place,
                       flk_text_of(flk_reader_copy(p, flk_text_of(name), "")),
                       flk_text_of(flk_reader_copy(p, flk_text_of(value), "")));
}

static void set_quantity(parser *p, const char *section, const char *key, double si, quantity q)
{
    char value[VALUE_SIZE];

    set(p, section, key, value_of(p, si, q, value));
}

/* The lengths that were found; a length that was given stays as it is written. */
static void set_lengths(parser *p)
{
    const fourlink_design *design = &p->d->synthesis->chosen->design;
    const flk_kind *kind = flk_kind_of(design->kind);
    int is_cognate = p->d->synthesis->task == TASK_COGNATE, i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        section_code section = flk_find_section(flk_text_of(kind->link[i]));
        int is_given = IS_SET(flk_setting_by_name(p, section, "length")) && !is_cognate;

        if (design->link[i].length > 0 && !is_given && flk_setting_by_name(p, section, "length") &&
            kind->has_length[i] != FLK_NO_LENGTH)
            set_quantity(p, kind->link[i], "length", design->link[i].length, QUANTITY_LENGTH);
    }
    if (design->kind == FOURLINK_SLIDER_CRANK && design->offset != 0)
        set_quantity(p, "ground", "offset", design->offset, QUANTITY_LENGTH);
    if (design->kind == FOURLINK_INVERTED_SLIDER_CRANK &&
        design->link[FOURLINK_FOLLOWER].length > 0 && !IS_SET(flk_setting_find(p, KEY_LEVER_ANGLE)))
        set_quantity(p, "lever", "angle", design->angle, QUANTITY_ANGLE);
}

/* The working range with all positions, which an order defect may have outside it, unless it is a full turn,
** or the deck says what moves. */
static void set_range(parser *p)
{
    static const key_code others[] = {KEY_MOTION_AT,   KEY_MOTION_TURNS,  KEY_MOTION_MODE,
                                      KEY_MOTION_ROWS, KEY_MOTION_RUN_UP, KEY_MOTION_HOLD,
                                      KEY_MOTION_FROM, KEY_MOTION_TO};
    const fourlink_solution *s = p->d->synthesis->chosen;
    int n = p->d->synthesis->task == TASK_COGNATE ? 6 : 8, i;
    double low = GSL_MIN(s->from, s->to), high = GSL_MAX(s->from, s->to);

    for (i = 0; i < n; i++)
        if (IS_SET(flk_setting_find(p, others[i])))
            return;
    for (i = 0; i < s->n_positions; i++) {
        low = GSL_MIN(low, s->position[i].theta2);
        high = GSL_MAX(high, s->position[i].theta2);
    }
    if (high - low > 2 * M_PI - 1e-9 || high == low)
        return;
    set_quantity(p, "motion", "from", s->from <= s->to ? low : high, QUANTITY_ANGLE);
    set_quantity(p, "motion", "to", s->from <= s->to ? high : low, QUANTITY_ANGLE);
}

/* The coupler point: of a cognate that of the deck, else [point P].  Returns its name. */
static const char *set_point(parser *p)
{
    const deck_synthesis *t = p->d->synthesis;
    char section[2 * DECK_NAME_SIZE] = "point ", value[VALUE_SIZE];
    text name = flk_text_of("P");
    size_t i;

    for (i = 0; i < p->n_uses && t->task == TASK_COGNATE; i++)
        if (p->uses[i].section == SECTION_POINT &&
            flk_setting_of(&p->uses[i], KEY_POINT_LINK)->word == FOURLINK_COUPLER) {
            name = p->uses[i].name;
            break;
        }
    if (!flk_section_find(p, SECTION_POINT, &name))
        flk_section_open(p, SECTION_POINT, name, t->place, NULL);
    flk_text_copy(name, section + strlen(section), DECK_NAME_SIZE);
    set(p, section, "link", "coupler");
    set(p, section, "at", point_of(p, t->chosen->point, value));
    return flk_reader_copy(p, name, "");
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
    char line[MESSAGE_SIZE], number[VALUE_SIZE];
    const char *unit_name = q == QUANTITY_NUMBER ? "" : unit_of(g->p, q)->name;

    put(g, flk_message(line, sizeof line,
                       tolerance > 1e-6 ? "tolerance = %g%s%s" : "tolerance = %.2g%s%s",
                       flk_unit_from_si(tolerance, unit_of(g->p, q)->unit), *unit_name ? " " : "",
                       unit_name));
    put(g, flk_message(line, sizeof line, "%s = %s", name, value_of(g->p, value, q, number)));
}

static void put_section(page *g, const double *theta2, int branch)
{
    char line[MESSAGE_SIZE], number[VALUE_SIZE];

    put(g, "");
    put(g, "[expect]");
    if (theta2)
        put(g, flk_message(line, sizeof line, "at = %s",
                           value_of(g->p, *theta2, QUANTITY_ANGLE, number)));
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
        char line[MESSAGE_SIZE], number[VALUE_SIZE];

        put(g, flk_message(line, sizeof line, "%s.y = %s", point_name,
                           value_of(g->p, at->point.y, QUANTITY_LENGTH, number)));
    }
    put_section(g, &at->theta2, at->branch);
    put_value(g, "theta3", at->theta3, ROUNDING * factor, QUANTITY_ANGLE);
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
        if (s->position[i].status == FOURLINK_OK && s->position[i].mu > DEAD * s->ratio)
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
                degrees(s->mu_min), s->defects ? "with a defect" : "no defect");
    put(g, line);
}

static void put_task(page *g)
{
    const deck_synthesis *t = g->p->d->synthesis;
    const fourlink_solution *s = t->chosen;
    const unit *u = &t->length.unit;
    char line[MESSAGE_SIZE], value[VALUE_SIZE];
    unsigned long i;

    put(g, flk_message(line, sizeof line,
                       "# Found by fourlink --synthesis: solution %ld of %ld of %s:%ld",
                       (long)(s - t->solutions) + 1, (long)t->n, t->place.source, t->place.line));
    for (i = 0; i < t->n_kept && i < MOST_LISTED; i++)
        put_solution(g, i);
    if (t->task == TASK_FUNCTION && s->design.kind == FOURLINK_FOUR_BAR)
        put(g, flk_message(line, sizeof line, "# K1 = %g, K2 = %g, K3 = %g (Freudenstein)", s->K[0],
                           s->K[1], s->K[2]));
    else if (t->task == TASK_FUNCTION)
        put(g, flk_message(line, sizeof line, "# S1 = %g m, S2 = %g m, S3 = %g m2", s->K[0],
                           s->K[1], s->K[2]));
    if (s->crank_turn != 0)
        put(g, flk_message(line, sizeof line,
                           "# a = %g %s: the crank is turned by 180 deg: wanted crank angle = "
                           "theta2 - %g deg",
                           flk_unit_from_si(s->a, *u), t->length.name, degrees(s->crank_turn)));
    if (s->rocker_turn != 0)
        put(g, flk_message(line, sizeof line,
                           "# c = %g %s: the rocker is turned by 180 deg: wanted angle = theta4 - "
                           "%g deg",
                           flk_unit_from_si(s->c, *u), t->length.name, degrees(s->rocker_turn)));
    if (s->has_point) {
        put(g, flk_message(line, sizeof line, "# The pivot A is at %s in the axes of the task,",
                           point_of(g->p, s->origin, value)));
        put(g, flk_message(line, sizeof line, "# where the line from A to D is at %s.",
                           value_of(g->p, s->direction, QUANTITY_ANGLE, value)));
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
                           degrees(s->from), degrees(s->to)));
    put(g, flk_message(line, sizeof line,
                       "#   transmission angle: smallest %.6g deg at theta2 = %.6g deg; at the "
                       "positions %.6g deg",
                       degrees(s->mu_min), degrees(s->mu_min_at), degrees(s->mu_positions)));
    put(g, flk_message(line, sizeof line, "#   condition of the linear equations: %.4g",
                       s->condition));
    if (t->task != TASK_FUNCTION || (!t->function.wanted && t->function.n == 3))
        return;
    if (s->design.kind == FOURLINK_FOUR_BAR)
        flk_message(words, sizeof words, "%.6g deg", degrees(s->max_error));
    else
        flk_message(words, sizeof words, "%.6g %s", flk_unit_from_si(s->max_error, t->length.unit),
                    t->length.name);
    put(g,
        flk_message(line, sizeof line,
                    t->function.wanted ? "#   structural error: largest %s at theta2 = %.6g deg"
                                       : "#   error at the points: largest %s at theta2 = %.6g deg",
                    words, degrees(s->max_error_at)));
    if (t->function.wanted)
        put(g, flk_message(line, sizeof line, "#   in units of y: %.6g",
                           s->max_error * (w->y[1] - w->y[0]) / (w->output[1] - w->output[0])));
}

/* What a [sweep] prints unless it names other outputs. */
static const char *outputs_of(const deck_synthesis *t)
{
    int is_function = t->task == TASK_FUNCTION;

    if (t->chosen->design.kind == FOURLINK_FOUR_BAR)
        return is_function
                   ? "crank_length coupler_length rocker_length mu_range theta4_error defects"
                   : "ground_length crank_length coupler_length rocker_length mu_range defects";
    if (t->chosen->design.kind == FOURLINK_SLIDER_CRANK)
        return is_function ? "crank_length coupler_length line_offset mu_range x_error defects"
                           : "crank_length coupler_length line_offset mu_range defects";
    return "ground_length crank_length defects";
}

void flk_synthesis_assign(parser *p)
{
    deck_synthesis *t = p->d->synthesis;
    const setting *branch = flk_setting_find(p, KEY_TABLE_BRANCH);
    const char *point_name = NULL;
    page head, tail;

    if (!p->d->sweep.output.names.start && !p->d->sweep.yield.names.start)
        p->d->sweep.output.names = flk_text_of(outputs_of(t));
    set_lengths(p);
    if (t->chosen->has_point)
        point_name = set_point(p);
    set_range(p);
    if (branch->word != BRANCH_BOTH)
        set(p, "table", "branch", fourlink_branch_text((int)t->chosen->branch));
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

/* ------------------------------------------------------------------------------------- for hosts */

int fourlink_deck_solutions(const fourlink_deck *d, unsigned long max, fourlink_solution *solutions,
                            unsigned long *chosen, unsigned long *n)
{
    unsigned long i;

    if (!d || (!solutions && max) || !chosen || !n)
        return FOURLINK_NULL;
    if (!d->found)
        return FOURLINK_NO_SUCH_LIST;
    for (i = 0; i < max && i < d->synthesis->n_kept; i++)
        solutions[i] = d->synthesis->solutions[i];
    *chosen = (unsigned long)(d->synthesis->chosen - d->synthesis->solutions);
    *n = d->synthesis->n;
    return FOURLINK_OK;
}

int fourlink_deck_defects(const fourlink_deck *d, unsigned long max, fourlink_mistake *list,
                          unsigned long *n)
{
    char words[MESSAGE_SIZE];
    unsigned long i;

    if (!d || (!list && max) || !n)
        return FOURLINK_NULL;
    *n = 0;
    for (i = 0; d->found && flk_synthesis_defect(d->synthesis, (int)i, words); i++, ++*n)
        if (i < max) {
            flk_text_copy(flk_text_of(d->synthesis->place.source), list[i].file,
                          sizeof list[i].file);
            list[i].line = d->synthesis->place.line;
            memcpy(list[i].message, words, sizeof list[i].message);
        }
    return FOURLINK_OK;
}
