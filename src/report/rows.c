/* SPDX-License-Identifier: GPL-3.0-or-later
**
** rows.c - the numbers of the interactive drawing.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/format.h"
#include "base/text.h"
#include "pictures/picture.h"
#include "rows.h"

#define MOST_ROWS 361
#define FEWEST_STEPS 120 /* in a revolution */

static const fourlink_vector zero = {0, 0};

static fourlink_vector vector(double x, double y)
{
    fourlink_vector v;

    v.x = x;
    v.y = y;
    return v;
}

double rows_value(const rows *t, quantity q, double si)
{
    return si * t->units[q].down / t->units[q].up;
}

char *rows_name(const char *before, unsigned long i, const char *after, char name[ROWS_NAME])
{
    char number[FORMAT_SIZE];

    return flk_text_join(name, ROWS_NAME, before, format_general((double)i, 10, number), after,
                         (char *)NULL);
}

/* The number of a track; that of tracks if there is none of this name. */
static int number_of(const rows *t, const char *name)
{
    int i;

    for (i = 0; i < t->n_tracks && strcmp(t->tracks[i].name, name) != 0; i++)
        ;
    return i;
}

const rows_track *rows_find(const rows *t, const char *name)
{
    int i = number_of(t, name);

    return i < t->n_tracks ? &t->tracks[i] : NULL;
}

/* ----------------------------------------------------------------------------------------------- the steps */

/* In how many parts so many intervals of the deck are divided, to have so many steps as wanted. */
static unsigned long parts_of(unsigned long intervals, double wanted)
{
    static const unsigned long parts[] = {1, 2, 5, 10, 20, 50, 100, 200, 360};
    unsigned long i;

    if (intervals == 0)
        return 1;
    for (i = 0; i < 8; i++)
        if ((double)(intervals * parts[i]) >= wanted || intervals * parts[i + 1] >= MOST_ROWS)
            break;
    return parts[i];
}

/* Insert a crank angle in its place. */
static void insert(rows *t, double at)
{
    double turn = 2 * M_PI / t->problem.motion.angle_unit;
    double sign = t->steps[t->n - 1] < t->steps[0] ? -1 : 1;
    unsigned long i;

    for (i = 0; i < t->n; i++)
        if (fabs(t->steps[i] - at) < 1e-9 * turn)
            return;
    for (i = 0; i < t->n && sign * t->steps[i] < sign * at; i++)
        ;
    if (i == 0 || i == t->n)
        return;
    memmove(t->steps + i + 1, t->steps + i, (t->n - i) * sizeof *t->steps);
    t->steps[i] = at;
    t->n++;
}

/* The step from row to row of the deck that is drawn: every row, or every so many of them. */
static unsigned long stride_of(unsigned long n_rows)
{
    unsigned long stride = (n_rows - 1 + MOST_ROWS - 2) / (MOST_ROWS - 1);

    return stride ? stride : 1;
}

static void choose_angles(rows *t, double at)
{
    const fourlink_motion *motion = &t->problem.motion;
    unsigned long stride, parts, row, k;
    fourlink_range range;
    fourlink_row here, next;
    double turns;

    fourlink_motion_range(motion, &range);
    stride = stride_of(range.n_rows);
    turns = (double)(range.n_rows - 1) * motion->interval * motion->angle_unit / (2 * M_PI);
    parts = stride > 1 ? 1 : parts_of(range.n_rows - 1, FEWEST_STEPS * GSL_MAX_DBL(turns, 1));
    for (row = 0; row + 1 < range.n_rows; row += stride) {
        fourlink_motion_row(motion, &range, row, &here);
        fourlink_motion_row(motion, &range, row + 1, &next);
        for (k = 0; k < parts; k++)
            t->steps[t->n++] = here.angle + (next.angle - here.angle) * (double)k / (double)parts;
    }
    fourlink_motion_row(motion, &range, range.n_rows - 1, &here);
    t->steps[t->n++] = here.angle;
    if (!gsl_isnan(at))
        insert(t, at);
}

/* The rows of a deck with rows by time, opened with the time step of the drawing. */
static void choose_times(rows *t)
{
    const fourlink_problem *p = &t->problem;

    for (t->n = 0; t->n < p->n_rows; t->n++)
        t->steps[t->n] =
            rows_value(t, QUANTITY_TIME, GSL_MIN_DBL((double)t->n * p->time_step, p->duration));
}

/* The time step of the drawing, s. */
static double time_step_of(const fourlink_problem *p)
{
    unsigned long stride = stride_of(p->n_rows);

    return stride > 1 ? p->time_step * (double)stride
                      : p->time_step / (double)parts_of(p->n_rows - 1, MOST_ROWS);
}

double rows_step_of(const rows *t, const fourlink_instant *now)
{
    return t->problem.by_time ? rows_value(t, QUANTITY_TIME, now->row.time) : now->row.angle;
}

/* ----------------------------------------------------------------------------------------------- tracks */

/* The track of a name, made if there is none; null without memory. */
static rows_track *track_of(rows *t, const char *name)
{
    int number = number_of(t, name);
    rows_track *x = &t->tracks[number];
    unsigned long i;

    if (number < t->n_tracks)
        return x;
    if (t->n_tracks == ROWS_TRACKS)
        return NULL;
    x->values = malloc(t->n * sizeof *x->values);
    if (!x->values) {
        t->out_of_memory = 1;
        return NULL;
    }
    strcpy(x->name, name);
    x->is_number = 0;
    x->size = 0;
    for (i = 0; i < t->n; i++)
        x->values[i] = vector(GSL_NAN, GSL_NAN);
    t->n_tracks++;
    return x;
}

/* Put a vector in SI units into a track. */
static void put(rows *t, unsigned long i, const char *name, quantity q, fourlink_vector v)
{
    rows_track *x = track_of(t, name);

    if (!x)
        return;
    x->values[i] = vector(rows_value(t, q, v.x), rows_value(t, q, v.y));
    x->size = GSL_MAX_DBL(x->size, GSL_MAX_DBL(fabs(x->values[i].x), fabs(x->values[i].y)));
}

static void put_number(rows *t, unsigned long i, const char *name, quantity q, double si)
{
    rows_track *x = track_of(t, name);

    put(t, i, name, q, vector(si, 0));
    if (x)
        x->is_number = 1;
}

/* Put position, velocity and acceleration of a point of a link: P0, vP0, aP0. */
static void put_point(rows *t, unsigned long i, const char *name, const fourlink_state *state,
                      int link, const fourlink_vector *at)
{
    fourlink_vector place = zero, v = zero, a = zero;
    char words[ROWS_NAME];

    fourlink_point(state, link, at, &place, &v, &a);
    put(t, i, name, QUANTITY_LENGTH, place);
    put(t, i, flk_text_join(words, sizeof words, "v", name, (char *)NULL), QUANTITY_SPEED, v);
    put(t, i, flk_text_join(words, sizeof words, "a", name, (char *)NULL), QUANTITY_ACCELERATION,
        a);
}

/* A point of the slide: so far along it from the foot of the perpendicular from D. */
static fourlink_vector on_slide(const fourlink_state *state, double along)
{
    const fourlink_vector *u = &state->link[FOURLINK_COUPLER].axis,
                          *B = &state->link[FOURLINK_COUPLER].origin;

    return vector(B->x + (along - state->s) * u->x, B->y + (along - state->s) * u->y);
}

/* Put the ends of the slot, which the slider needs with the crank at 0 and at 180 deg, and where the lever meets
** the slide. */
static void put_slot(rows *t, unsigned long i, const fourlink_state *state)
{
    const fourlink_mechanism *m = &t->problem.mechanism;
    const fourlink_link *link = m->design.link;
    double sum = link[2].length + link[1].length, sign = state->branch;
    double near = m->folded > 0 ? sqrt(m->folded) : 0;
    double far = sqrt(fabs((sum - m->h) * (sum + m->h)));

    if (m->change_folded)
        near = -far;
    put(t, i, "S1", QUANTITY_LENGTH, on_slide(state, sign * near));
    put(t, i, "S2", QUANTITY_LENGTH, on_slide(state, sign * far));
    put(t, i, "R", QUANTITY_LENGTH, on_slide(state, link[4].length * m->lever.x));
}

/* Put the ends of a piston's stroke. */
static void put_stroke(rows *t, unsigned long i, const fourlink_state *state)
{
    double far = t->problem.mechanism.dead_centre, e = t->design->offset;
    double near = picture_outer_end(&t->problem.mechanism), sign = state->branch;

    put(t, i, "S1", QUANTITY_LENGTH, vector(sign * near, e));
    put(t, i, "S2", QUANTITY_LENGTH, vector(sign * far, e));
}

/* Put the ends of springs. */
static void put_springs(rows *t, unsigned long i, const fourlink_state *state)
{
    fourlink_spring spring;
    fourlink_vector from, to;
    char name[ROWS_NAME];
    unsigned long k;

    for (k = 0; k < t->problem.n_springs; k++) {
        fourlink_deck_spring(t->deck, k, NULL, &spring);
        if (spring.is_torsional)
            continue;
        from = spring.at;
        to = spring.to_at;
        if (spring.link != FOURLINK_GROUND)
            fourlink_point(state, spring.link, &spring.at, &from, NULL, NULL);
        if (spring.to != FOURLINK_GROUND)
            fourlink_point(state, spring.to, &spring.to_at, &to, NULL, NULL);
        put(t, i, rows_name("K", k, "P", name), QUANTITY_LENGTH, from);
        put(t, i, rows_name("K", k, "Q", name), QUANTITY_LENGTH, to);
    }
}

static void put_points(rows *t, unsigned long i, const fourlink_state *state)
{
    fourlink_vector C = vector(t->design->link[3].length, 0), place = zero, at;
    char name[ROWS_NAME];
    unsigned long k;
    int link;

    put(t, i, "A", QUANTITY_LENGTH, zero);
    put(t, i, "B", QUANTITY_LENGTH, state->link[FOURLINK_COUPLER].origin);
    if (!t->kind.has_slot) {
        fourlink_point(state, FOURLINK_COUPLER, &C, &place, NULL, NULL);
        put(t, i, "C", QUANTITY_LENGTH, place);
    }
    if (!t->kind.has_stroke)
        put(t, i, "D", QUANTITY_LENGTH, state->link[FOURLINK_FOLLOWER].origin);
    if (t->kind.has_slot)
        put_slot(t, i, state);
    if (t->kind.has_stroke)
        put_stroke(t, i, state);
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
        if (t->design->link[link].mass > 0)
            put_point(t, i, rows_name("G", (unsigned long)link, "", name), state, link,
                      &t->design->link[link].cg);
    for (k = 0; k < t->problem.n_points; k++) {
        fourlink_deck_point(t->deck, k, NULL, &link, &at);
        put_point(t, i, rows_name("P", k, "", name), state, link, &at);
    }
    put_springs(t, i, state);
}

/* -------------------------------------------------------------------- velocities, accelerations, forces */

/* a^n = -omega^2 r, a^t = alpha x r, of the end of an arm r on a link */
static void put_parts(rows *t, unsigned long i, const char *normal, const char *tangential,
                      const fourlink_link_state *link, fourlink_vector r)
{
    double n = -link->omega * link->omega;

    put(t, i, normal, QUANTITY_ACCELERATION, vector(n * r.x, n * r.y));
    put(t, i, tangential, QUANTITY_ACCELERATION, vector(-link->alpha * r.y, link->alpha * r.x));
}

/* The arm of a link: its length along its axis. */
static fourlink_vector arm(const rows *t, const fourlink_state *state, int link)
{
    double length = t->design->link[link].length;

    return vector(length * state->link[link].axis.x, length * state->link[link].axis.y);
}

/* v_C = v_B + v_CB; a_C = a_B + a_CB^n + a_CB^t */
static void put_rod(rows *t, unsigned long i, const fourlink_state *state)
{
    fourlink_vector C = vector(t->design->link[FOURLINK_COUPLER].length, 0), v = zero, a = zero;
    const fourlink_vector *v_B = &state->link[FOURLINK_COUPLER].velocity;

    fourlink_point(state, FOURLINK_COUPLER, &C, NULL, &v, &a);
    put(t, i, "vC", QUANTITY_SPEED, v);
    put(t, i, "vCB", QUANTITY_SPEED, vector(v.x - v_B->x, v.y - v_B->y));
    put_parts(t, i, "aCBn", "aCBt", &state->link[FOURLINK_COUPLER],
              arm(t, state, FOURLINK_COUPLER));
    if (t->kind.has_stroke)
        put(t, i, "aC", QUANTITY_ACCELERATION, a);
    else
        put_parts(t, i, "aCn", "aCt", &state->link[FOURLINK_FOLLOWER],
                  arm(t, state, FOURLINK_FOLLOWER));
}

/* v_B = v_B4 + slide_v u; a_B = a_B4^n + a_B4^t + 2 omega4 x slide_v u + slide_a u, B4 the point of the lever
** at B */
static void put_sliding(rows *t, unsigned long i, const fourlink_state *state)
{
    const fourlink_link_state *lever = &state->link[FOURLINK_FOLLOWER];
    const fourlink_vector *B = &state->link[FOURLINK_COUPLER].origin,
                          *u = &state->link[FOURLINK_COUPLER].axis;
    fourlink_vector r = vector(B->x - lever->origin.x, B->y - lever->origin.y);

    put(t, i, "vB4", QUANTITY_SPEED, vector(-lever->omega * r.y, lever->omega * r.x));
    put(t, i, "vS", QUANTITY_SPEED, vector(state->slide_v * u->x, state->slide_v * u->y));
    put_parts(t, i, "aB4n", "aB4t", lever, r);
    put(t, i, "aK", QUANTITY_ACCELERATION, vector(-state->coriolis * u->y, state->coriolis * u->x));
    put(t, i, "aS", QUANTITY_ACCELERATION, vector(state->slide_a * u->x, state->slide_a * u->y));
}

/* The force of a load in the frame of link 1. */
static fourlink_vector force_of(const fourlink_load *load, const fourlink_state *state)
{
    const fourlink_vector *axis = &state->link[load->link].axis, *F = &load->force;

    if (load->frame == FOURLINK_FRAME_GROUND)
        return *F;
    return vector(F->x * axis->x - F->y * axis->y, F->x * axis->y + F->y * axis->x);
}

static void put_loads(rows *t, unsigned long i, const fourlink_state *state)
{
    fourlink_vector place = zero;
    char name[ROWS_NAME];
    unsigned long k;

    for (k = 0; k < t->problem.n_loads; k++) {
        const fourlink_load *load = &t->loads[k];

        fourlink_point(state, load->link, &load->at, &place, NULL, NULL);
        put(t, i, rows_name("L", k, "", name), QUANTITY_LENGTH, place);
        put(t, i, rows_name("L", k, "F", name), QUANTITY_FORCE, force_of(load, state));
        put_number(t, i, rows_name("L", k, "T", name), QUANTITY_TORQUE, load->torque);
    }
}

/* Put weight, -m a_G and -I alpha of each link. */
static void put_inertia(rows *t, unsigned long i, const fourlink_state *state)
{
    const fourlink_vector *g = &t->design->gravity;
    fourlink_vector a = zero;
    char name[ROWS_NAME];
    unsigned long link;

    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++) {
        const fourlink_link *body = &t->design->link[link];

        if (body->mass > 0) {
            fourlink_point(state, (int)link, &body->cg, NULL, NULL, &a);
            put(t, i, rows_name("W", link, "", name), QUANTITY_FORCE,
                vector(body->mass * g->x, body->mass * g->y));
            put(t, i, rows_name("I", link, "F", name), QUANTITY_FORCE,
                vector(-body->mass * a.x, -body->mass * a.y));
        }
        if (body->inertia > 0)
            put_number(t, i, rows_name("I", link, "T", name), QUANTITY_TORQUE,
                       -body->inertia * state->link[link].alpha);
    }
}

/* In a motion that is not given Ts may be rounding, as without a motor: see picture_torque_rounding. */
static int is_rounding(const rows *t, const fourlink_forces *f)
{
    double arm = t->design->link[FOURLINK_CRANK].length;

    return t->problem.mode != FOURLINK_MODE_GIVEN &&
           fabs(f->Ts) < 1e-12 * arm * gsl_hypot(f->F12x, f->F12y);
}

static void put_forces(rows *t, unsigned long i, const fourlink_instant *now)
{
    const fourlink_forces *f = &now->forces;

    put(t, i, "F12", QUANTITY_FORCE, vector(f->F12x, f->F12y));
    put(t, i, "F23", QUANTITY_FORCE, vector(f->F23x, f->F23y));
    put(t, i, "F34", QUANTITY_FORCE, vector(f->F34x, f->F34y));
    put(t, i, "F14", QUANTITY_FORCE,
        vector(t->kind.has_stroke ? 0 : f->F14x, f->F14y)); /* N without friction */
    put_number(t, i, "Ts", QUANTITY_TORQUE, is_rounding(t, f) ? 0 : f->Ts);
    if (t->kind.has_slot)
        put_number(t, i, "M34", QUANTITY_TORQUE, f->M34);
    if (t->kind.has_stroke)
        put_number(t, i, "M14", QUANTITY_TORQUE, f->M14);
    put_inertia(t, i, &now->state);
    put_loads(t, i, &now->state);
}

/* -------------------------------------------------------------------------------------------- all of them */

static int draws_all(const rows *t)
{
    return t->problem.n_points <= ROWS_POINTS && t->problem.n_loads <= ROWS_LOADS &&
           t->problem.n_springs <= ROWS_LOADS;
}

/* Open the deck; 0 without memory or if it has mistakes. */
static int open_deck(rows *t, const fourlink_source *source)
{
    int status = fourlink_results_open(source, 0, &t->results, NULL, NULL);

    t->out_of_memory |= status == FOURLINK_NO_MEMORY;
    if (status != FOURLINK_OK)
        return 0;
    t->deck = fourlink_results_deck(t->results);
    fourlink_deck_problem(t->deck, &t->problem);
    return 1;
}

/* Open a deck with rows by time again, with the time step of the drawing. */
static int reopen(rows *t, const fourlink_source *source)
{
    fourlink_change *changes = malloc((source->n_changes + 1) * sizeof *changes);
    fourlink_source other = *source;
    char assignment[FORMAT_SIZE + 40], number[FORMAT_SIZE];
    int opened;

    t->out_of_memory |= !changes;
    if (!changes)
        return 0;
    if (source->n_changes)
        memcpy(changes, source->changes, source->n_changes * sizeof *changes);
    changes[other.n_changes].origin = "--report";
    changes[other.n_changes++].assignment =
        flk_text_join(assignment, sizeof assignment,
                      "motion.time_step=", format_general(time_step_of(&t->problem), 17, number),
                      " s", (char *)NULL);
    other.changes = changes;
    fourlink_results_free(t->results);
    t->results = NULL;
    opened = open_deck(t, &other);
    free(changes);
    return opened;
}

int rows_open(rows *t, const fourlink_source *source, double at)
{
    fourlink_source whole = *source;
    int q;

    memset(t, 0, sizeof *t);
    whole.whole_cycle = 1;
    if (!open_deck(t, &whole) || !draws_all(t) || (t->problem.by_time && !reopen(t, &whole)))
        return 0;
    t->design = &t->problem.mechanism.design;
    fourlink_kind_of((int)t->design->kind, &t->kind);
    for (q = 0; q < QUANTITY_COUNT; q++)
        fourlink_deck_unit(t->deck, flk_quantities[q].name, &t->units[q]);
    fourlink_results_list(t->results, FOURLINK_COLUMNS, &t->columns, &t->n_columns);
    t->steps = malloc((MOST_ROWS * 2 + 2) * sizeof *t->steps);
    t->loads = malloc((t->problem.n_loads + 1) * sizeof *t->loads);
    if (t->steps && t->problem.by_time)
        choose_times(t);
    else if (t->steps)
        choose_angles(t, at);
    t->status = malloc((t->n + 1) * sizeof *t->status);
    t->table = malloc((t->n * t->n_columns + 1) * sizeof *t->table);
    t->out_of_memory |= !t->steps || !t->status || !t->table || !t->loads;
    return !t->out_of_memory;
}

static void close_branch(rows *t)
{
    while (t->n_tracks > 0)
        free(t->tracks[--t->n_tracks].values);
}

void rows_close(rows *t)
{
    close_branch(t);
    fourlink_results_free(t->results);
    free(t->steps);
    free(t->status);
    free(t->table);
    free(t->loads);
}

static void compute_row(rows *t, unsigned long i)
{
    fourlink_instant now;
    double r = t->design->link[FOURLINK_CRANK].length, theta, *values = t->table + i * t->n_columns;

    if (t->problem.by_time)
        t->status[i] = fourlink_results_row(t->results, t->branch, i, values, &now, t->loads);
    else
        t->status[i] =
            fourlink_results_at(t->results, t->branch, t->steps[i], values, &now, t->loads);
    if (t->status[i] != FOURLINK_OK) { /* the crank can still be drawn */
        theta = now.row.crank.theta2;
        put(t, i, "A", QUANTITY_LENGTH, zero);
        put(t, i, "B", QUANTITY_LENGTH, vector(r * cos(theta), r * sin(theta)));
        return;
    }
    put_points(t, i, &now.state);
    put(t, i, "vB", QUANTITY_SPEED, now.state.link[FOURLINK_COUPLER].velocity);
    if (t->kind.has_slot)
        put_sliding(t, i, &now.state);
    else
        put_rod(t, i, &now.state);
    put_parts(t, i, "aBn", "aBt", &now.state.link[FOURLINK_CRANK],
              arm(t, &now.state, FOURLINK_CRANK));
    if (t->problem.has_forces)
        put_forces(t, i, &now);
}

int rows_compute(rows *t, fourlink_branch branch)
{
    unsigned long i;

    close_branch(t);
    t->branch = branch;
    for (i = 0; i < t->n; i++)
        compute_row(t, i);
    return rows_find(t, "B") != NULL;
}
