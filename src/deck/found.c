/* SPDX-License-Identifier: GPL-3.0-or-later
**
** found.c - finds the linkage of [synthesis], whose lengths the deck then has.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "mechanics/kind.h"
#include "build_motor.h"
#include "found.h"
#include "found_text.h"
#include "parser.h"
#include "settings.h"
#include "synthesis.h"
#include "task.h"
#include "values.h"

#define RATIO_USUAL 10.0 /* longest / shortest link, above which there is a note */

/* ------------------------------------------------------------------------------------- searching */

static int run_task(deck_synthesis *t, unsigned long max)
{
    if (t->has_points)
        return fourlink_synthesis_points(&t->points, max, t->solutions, &t->n);
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

/* The lengths of a function generator are found for a ground of 1 m if another link is given, then scaled. */
static int run_scaled(deck_synthesis *t, unsigned long max)
{
    int status = run_task(t, max), i;
    fourlink_solution *s = t->solutions;
    double scale;

    if (status != FOURLINK_OK || !t->scaled_link)
        return status;
    scale = t->scaled_length / s->design.link[t->scaled_link].length;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        s->design.link[i].length *= scale;
        if (!(s->design.link[i].length <= FOURLINK_LENGTH_MAX))
            return FOURLINK_INFINITE_LINK;
        if (!(s->design.link[i].length >= FOURLINK_LENGTH_MIN))
            return FOURLINK_NO_LENGTH;
    }
    s->design.link[t->scaled_link].length = t->scaled_length;
    s->a *= scale;
    s->c *= scale;
    t->function.ground = s->design.link[FOURLINK_GROUND].length;
    return status;
}

static void note(parser *p)
{
    const deck_synthesis *t = p->d->synthesis;
    const fourlink_solution *s = t->chosen;

    if (s->mu_min < t->mu_min)
        flk_mistake(NOTES(p), t->place,
                    "the transmission angle falls to %.4g deg at theta2 = %.4g deg, below %.4g deg",
                    FLK_DEGREES(s->mu_min), FLK_DEGREES(s->mu_min_at), FLK_DEGREES(t->mu_min));
    if (s->is_better_longer)
        flk_mistake(NOTES(p), t->place,
                    "longer links would fit better; this is the best fit with the longest link at "
                    "most 100 times as long as the shortest");
    if (t->has_points && s->defects && !t->points.may_rock)
        flk_mistake(NOTES(p), t->place,
                    "no start led to a crank that turns fully and has no defect: %s "
                    "allows others",
                    s->defects == FOURLINK_DEFECT_ORDER ? "order = any" : "crank_turns = any");
    if (s->ratio > RATIO_USUAL)
        flk_mistake(NOTES(p), t->place,
                    "the longest link is %.4g times as long as the shortest one", s->ratio);
}

/* Take what was found before for the same task. */
static int take_solved(deck_synthesis *t, const deck_synthesis *solved, unsigned long max)
{
    t->n = solved->n;
    t->function.ground = solved->function.ground;
    memcpy(t->solutions, solved->solutions, GSL_MIN(solved->n_kept, max) * sizeof *t->solutions);
    return solved->status;
}

int flk_synthesis_run(parser *p)
{
    deck_synthesis *t = p->d->synthesis;
    const deck_synthesis *solved = p->d->solved;
    unsigned long max = p->d->solution > MOST_LISTED ? p->d->solution : MOST_LISTED;

    max = t->has_points || (t->task == TASK_PATH && t->path.search) ? max : 1;
    t->solutions = flk_reader_keep(p, max * sizeof *t->solutions);
    if (!t->solutions)
        return 0;
    t->status = solved ? take_solved(t, solved, max) : run_scaled(t, max);
    if (t->status == FOURLINK_BAD_CHOICE)
        return flk_mistake(p->mistakes, t->place, "%s: the task takes %s",
                           fourlink_status_text(t->status), t->kind->quick_return);
    p->out_of_memory |= t->status == FOURLINK_NO_MEMORY;
    if (p->out_of_memory)
        return 0;
    if (t->has_points && t->status == FOURLINK_NONE_FOUND)
        return flk_mistake(
            p->mistakes, t->place,
            "no start led to a linkage: allow a smaller mu_min, %slarger boxes or%s, or "
            "more starts by --effort",
            t->points.longest > 0 || t->points.length_ratio > 0 ? "other lengths, " : "",
            t->points.may_rock ? " other timing" : " crank_turns = any");
    if (t->status != FOURLINK_OK)
        return flk_mistake(p->mistakes, t->place, "%s", fourlink_status_text(t->status));
    t->n_kept = GSL_MIN(solved ? solved->n_kept : t->n, max);
    if (p->d->solution > t->n_kept)
        return flk_mistake(p->mistakes, t->place, "there is no solution %ld: the task has %ld",
                           (long)p->d->solution, (long)t->n);
    t->chosen = &t->solutions[p->d->solution - 1];
    if (t->chosen->design.kind != p->d->machine.mechanism.design.kind)
        return flk_mistake(
            p->mistakes, t->place,
            !(t->chosen->design.link[FOURLINK_GROUND].length > 0)
                ? "the right pivot moves along a line: write mechanism = slider-crank"
                : "the right pivot does not move along a line: write right = slider "
                  "30 deg, or mechanism = four-bar");
    flk_synthesis_tell_defects(p);
    note(p);
    return 1;
}

double flk_synthesis_error(const deck_synthesis *t, double theta2)
{
    double at = theta2 - t->chosen->crank_turn, error = GSL_NAN, output;
    double low = GSL_MIN(t->wanted.crank[0], t->wanted.crank[1]);

    if (!t->function.wanted)
        return GSL_NAN;
    at = flk_cycle_place(at, low, 2 * M_PI);
    output = t->function.wanted(t->function.host, at);
    return fourlink_synthesis_error(t->chosen, at, output, &error) == FOURLINK_OK ? error : GSL_NAN;
}

int flk_synthesis_range(const deck_synthesis *t, double theta2[2])
{
    int i;

    for (i = 0; i < 2; i++)
        theta2[i] = t->wanted.crank[i] + t->chosen->crank_turn;
    return t->function.wanted != NULL;
}

/* --------------------------------------------------------------------------------------- the deck */

static void assign(parser *p, const char *section, const char *key, const char *value)
{
    char name[3 * DECK_NAME_SIZE];
    const char *kept;

    flk_text_join(name, sizeof name, section, ".", key, (char *)NULL);
    kept = flk_reader_copy(p, flk_text_of(name), "");
    if (kept)
        flk_setting_assign(p, p->d->synthesis->place, flk_text_of(kept), flk_text_of(value));
}

/* The lengths that were found; a length that was given stays as it is written. */
static void set_lengths(parser *p)
{
    const deck_synthesis *t = p->d->synthesis;
    const fourlink_design *design = &t->chosen->design;
    const flk_kind *kind = flk_kind_of(design->kind);
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        section_code section = flk_section_of_link(kind->kind, i);
        const setting *given = flk_setting_by_name(p, section, "length");

        if (design->link[i].length > 0 && kind->has_length[i] != FLK_NO_LENGTH &&
            (!IS_SET(given) || t->task == TASK_COGNATE))
            assign(p, kind->link[i], "length",
                   flk_found_value(p, design->link[i].length, QUANTITY_LENGTH));
    }
    if (t->kind->besides == KEY_GROUND_OFFSET && design->offset != 0)
        assign(p, "ground", "offset", flk_found_value(p, design->offset, QUANTITY_LENGTH));
    if (t->kind->besides == KEY_LEVER_ANGLE && design->link[FOURLINK_FOLLOWER].length > 0 &&
        !IS_SET(flk_setting_find(p, KEY_LEVER_ANGLE)))
        assign(p, "lever", "angle", flk_found_value(p, design->angle, QUANTITY_ANGLE));
}

/* The working range, unless it is a full turn or the deck says what moves. */
static void set_range(parser *p)
{
    static const key_code others[] = {KEY_MOTION_AT,   KEY_MOTION_TURNS,  KEY_MOTION_MODE,
                                      KEY_MOTION_ROWS, KEY_MOTION_RUN_UP, KEY_MOTION_HOLD,
                                      KEY_MOTION_FROM, KEY_MOTION_TO};
    const fourlink_solution *s = p->d->synthesis->chosen;
    int n = p->d->synthesis->task == TASK_COGNATE ? 6 : 8, i;
    double low = GSL_MIN(s->from, s->to), high = GSL_MAX(s->from, s->to);
    int rises = flk_setting_or(p, KEY_MOTION_ACCELERATION, 0) != 0 ? flk_build_sense(p) > 0
                                                                   : s->from <= s->to;

    for (i = 0; i < n; i++)
        if (IS_SET(flk_setting_find(p, others[i])))
            return;
    if (high - low > 2 * M_PI - 1e-9 || high == low)
        return;
    assign(p, "motion", "from", flk_found_value(p, rises ? low : high, QUANTITY_ANGLE));
    assign(p, "motion", "to", flk_found_value(p, rises ? high : low, QUANTITY_ANGLE));
}

/* The coupler point: of a cognate that of the deck, else [point P].  Returns its name. */
static const char *set_point(parser *p)
{
    const deck_synthesis *t = p->d->synthesis;
    char section[2 * DECK_NAME_SIZE] = "point ";
    text name = t->task == TASK_COGNATE ? flk_task_coupler_point(p)->name : flk_text_of("P");

    if (!flk_section_find(p, SECTION_POINT, &name))
        flk_section_open(p, SECTION_POINT, name, t->place, NULL);
    flk_text_copy(name, section + strlen(section), DECK_NAME_SIZE);
    assign(p, section, "link", flk_kind_of(t->chosen->design.kind)->link[FOURLINK_COUPLER]);
    assign(p, section, "at", flk_found_point(p, t->chosen->point));
    return flk_reader_copy(p, name, "");
}

/* The outputs of a [sweep], and of the table of solutions, that names none. */
static const char *outputs_of(const deck_synthesis *t)
{
    int finds_lever = t->kind->kind == FOURLINK_INVERTED_SLIDER_CRANK && t->quick_return.stroke > 0;

    return t->kind->outputs[t->task == TASK_FUNCTION || finds_lever];
}

void flk_synthesis_assign(parser *p)
{
    const deck_synthesis *t = p->d->synthesis;
    deck_sweep *sweep = &p->d->sweep;
    const char *point_name = NULL;

    if (!sweep->output.names.start && !sweep->yield.names.start)
        sweep->output.names = flk_text_of(outputs_of(t));
    set_lengths(p);
    if (t->chosen->has_point)
        point_name = set_point(p);
    set_range(p);
    if (flk_setting_find(p, KEY_TABLE_BRANCH)->word != BRANCH_BOTH)
        assign(p, "table", "branch", fourlink_branch_text((int)t->chosen->branch));
    if (p->out_of_memory)
        return;
    flk_values_read(p, 0);
    flk_found_write(p, point_name);
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
    if (!d || (!list && max) || !n)
        return FOURLINK_NULL;
    flk_deck_give_mistakes(&d->defects, max, list, n);
    return FOURLINK_OK;
}
