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
#include "rows.h"
#include "view/geometry.h"

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
    double turn = 2 * M_PI / t->v.problem.motion.angle_unit;
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
    const fourlink_motion *motion = &t->v.problem.motion;
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
    const fourlink_problem *p = &t->v.problem;

    for (t->n = 0; t->n < p->n_rows; t->n++)
        t->steps[t->n] =
            view_value(&t->v, QUANTITY_TIME, GSL_MIN_DBL((double)t->n * p->time_step, p->duration));
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
    return t->v.problem.by_time ? view_value(&t->v, QUANTITY_TIME, now->row.time) : now->row.angle;
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
    x->values[i] = vector(view_value(&t->v, q, v.x), view_value(&t->v, q, v.y));
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

/* Put the ends of the way of a piston, or of a slider, and where the lever meets its slide. */
static void put_way(rows *t, unsigned long i, const fourlink_state *state)
{
    double e = t->v.design->offset, near, far;
    int has_slot = t->v.kind.has_slot;

    geometry_find_way(&t->v, state->branch, &near, &far);
    put(t, i, "S1", QUANTITY_LENGTH, has_slot ? geometry_on_slide(state, near) : vector(near, e));
    put(t, i, "S2", QUANTITY_LENGTH, has_slot ? geometry_on_slide(state, far) : vector(far, e));
    if (has_slot)
        put(t, i, "R", QUANTITY_LENGTH, geometry_on_slide(state, geometry_root(&t->v)));
}

/* Put the ends of springs. */
static void put_springs(rows *t, unsigned long i, const fourlink_state *state)
{
    fourlink_spring spring;
    fourlink_vector from, to;
    char name[ROWS_NAME];
    unsigned long k;

    for (k = 0; k < t->v.problem.n_springs; k++) {
        fourlink_deck_spring(t->v.deck, k, NULL, &spring);
        if (spring.is_torsional)
            continue;
        from = geometry_of_link(state, spring.link, &spring.at);
        to = geometry_of_link(state, spring.to, &spring.to_at);
        put(t, i, rows_name("K", k, "P", name), QUANTITY_LENGTH, from);
        put(t, i, rows_name("K", k, "Q", name), QUANTITY_LENGTH, to);
    }
}

static void put_points(rows *t, unsigned long i, const fourlink_state *state)
{
    char name[ROWS_NAME];
    fourlink_vector at;
    unsigned long k;
    int link;

    put(t, i, "A", QUANTITY_LENGTH, zero);
    put(t, i, "B", QUANTITY_LENGTH, state->link[FOURLINK_COUPLER].origin);
    if (!t->v.kind.has_slot)
        put(t, i, "C", QUANTITY_LENGTH, geometry_end(&t->v, state, FOURLINK_COUPLER));
    if (!t->v.kind.has_stroke)
        put(t, i, "D", QUANTITY_LENGTH, state->link[FOURLINK_FOLLOWER].origin);
    if (t->v.kind.has_slot || t->v.kind.has_stroke)
        put_way(t, i, state);
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
        if (t->v.design->link[link].mass > 0)
            put_point(t, i, rows_name("G", (unsigned long)link, "", name), state, link,
                      &t->v.design->link[link].cg);
    for (k = 0; k < t->v.problem.n_points; k++) {
        fourlink_deck_point(t->v.deck, k, NULL, &link, &at);
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
    double length = t->v.design->link[link].length;

    return vector(length * state->link[link].axis.x, length * state->link[link].axis.y);
}

/* v_C = v_B + v_CB; a_C = a_B + a_CB^n + a_CB^t */
static void put_rod(rows *t, unsigned long i, const fourlink_state *state)
{
    fourlink_vector C = vector(t->v.design->link[FOURLINK_COUPLER].length, 0), v = zero, a = zero;
    const fourlink_vector *v_B = &state->link[FOURLINK_COUPLER].velocity;

    fourlink_point(state, FOURLINK_COUPLER, &C, NULL, &v, &a);
    put(t, i, "vC", QUANTITY_SPEED, v);
    put(t, i, "vCB", QUANTITY_SPEED, vector(v.x - v_B->x, v.y - v_B->y));
    put_parts(t, i, "aCBn", "aCBt", &state->link[FOURLINK_COUPLER],
              arm(t, state, FOURLINK_COUPLER));
    if (t->v.kind.has_stroke)
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

static void put_loads(rows *t, unsigned long i, const fourlink_state *state)
{
    char name[ROWS_NAME];
    unsigned long k;

    for (k = 0; k < t->v.problem.n_loads; k++) {
        const fourlink_load *load = &t->loads[k];

        put(t, i, rows_name("L", k, "", name), QUANTITY_LENGTH,
            geometry_of_link(state, load->link, &load->at));
        put(t, i, rows_name("L", k, "F", name), QUANTITY_FORCE, geometry_force(load, state));
        put_number(t, i, rows_name("L", k, "T", name), QUANTITY_TORQUE, load->torque);
    }
}

/* Put weight, -m a_G and -I alpha of each link. */
static void put_inertia(rows *t, unsigned long i, const fourlink_state *state)
{
    const fourlink_vector *g = &t->v.design->gravity;
    fourlink_vector a = zero;
    char name[ROWS_NAME];
    unsigned long link;

    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++) {
        const fourlink_link *body = &t->v.design->link[link];

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

static void put_forces(rows *t, unsigned long i, const fourlink_instant *now)
{
    const fourlink_forces *f = &now->forces;

    put(t, i, "F12", QUANTITY_FORCE, vector(f->F12x, f->F12y));
    put(t, i, "F23", QUANTITY_FORCE, vector(f->F23x, f->F23y));
    put(t, i, "F34", QUANTITY_FORCE, vector(f->F34x, f->F34y));
    put(t, i, "F14", QUANTITY_FORCE,
        vector(t->v.kind.has_stroke ? 0 : f->F14x, f->F14y)); /* N without friction */
    put_number(t, i, "Ts", QUANTITY_TORQUE, view_driving_torque(&t->v, f));
    if (t->v.kind.has_slot)
        put_number(t, i, "M34", QUANTITY_TORQUE, f->M34);
    if (t->v.kind.has_stroke)
        put_number(t, i, "M14", QUANTITY_TORQUE, f->M14);
    put_inertia(t, i, &now->state);
    put_loads(t, i, &now->state);
}

/* -------------------------------------------------------------------------------------------- all of them */

static int draws_all(const rows *t)
{
    return t->v.problem.n_points <= ROWS_POINTS && t->v.problem.n_loads <= ROWS_LOADS &&
           t->v.problem.n_springs <= ROWS_LOADS;
}

/* Open the deck, and with a further assignment unless it is null; 0 without memory or if it has mistakes. */
static int open_deck(rows *t, const fourlink_source *source, const char *further)
{
    fourlink_change *changes = malloc((source->n_changes + 1) * sizeof *changes);
    fourlink_source other = *source;
    int status = FOURLINK_NO_MEMORY;

    fourlink_results_free(t->own);
    t->own = NULL;
    other.whole_cycle = 1;
    other.changes = changes;
    if (changes && source->n_changes)
        memcpy(changes, source->changes, source->n_changes * sizeof *changes);
    if (changes && further) {
        changes[other.n_changes].origin = "--report";
        changes[other.n_changes++].assignment = further;
    }
    if (changes)
        status = fourlink_results_open(&other, 0, &t->own, NULL, NULL);
    free(changes);
    t->out_of_memory |= status == FOURLINK_NO_MEMORY;
    if (status != FOURLINK_OK)
        return 0;
    view_take(&t->v, t->own);
    return 1;
}

/* Open a deck with rows by time again, with the time step of the drawing. */
static int reopen(rows *t, const fourlink_source *source)
{
    char assignment[FORMAT_SIZE + 40], number[FORMAT_SIZE];

    format_general(time_step_of(&t->v.problem), 17, number);
    return open_deck(t, source,
                     flk_text_join(assignment, sizeof assignment, "motion.time_step=", number, " s",
                                   (char *)NULL));
}

int rows_open(rows *t, const fourlink_source *source, fourlink_results *opened, double at)
{
    memset(t, 0, sizeof *t);
    if (opened)
        view_take(&t->v, opened);
    if ((!opened || t->v.problem.one_instant) && !open_deck(t, source, NULL))
        return 0;
    if (!draws_all(t) || (t->v.problem.by_time && !reopen(t, source)))
        return 0;
    t->steps = malloc((MOST_ROWS * 2 + 2) * sizeof *t->steps);
    t->loads = malloc((t->v.problem.n_loads + 1) * sizeof *t->loads);
    if (t->steps && t->v.problem.by_time)
        choose_times(t);
    else if (t->steps)
        choose_angles(t, at);
    t->status = malloc((t->n + 1) * sizeof *t->status);
    t->table = malloc((t->n * t->v.n_columns + 1) * sizeof *t->table);
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
    fourlink_results_free(t->own);
    free(t->steps);
    free(t->status);
    free(t->table);
    free(t->loads);
}

static void compute_row(rows *t, unsigned long i)
{
    fourlink_instant now;
    double r = t->v.design->link[FOURLINK_CRANK].length, theta,
           *values = t->table + i * t->v.n_columns;

    if (t->v.problem.by_time)
        t->status[i] = fourlink_results_row(t->v.results, t->branch, i, values, &now, t->loads);
    else
        t->status[i] =
            fourlink_results_at(t->v.results, t->branch, t->steps[i], values, &now, t->loads);
    if (t->status[i] != FOURLINK_OK) { /* the crank can still be drawn */
        theta = now.row.crank.theta2;
        put(t, i, "A", QUANTITY_LENGTH, zero);
        put(t, i, "B", QUANTITY_LENGTH, vector(r * cos(theta), r * sin(theta)));
        return;
    }
    put_points(t, i, &now.state);
    put(t, i, "vB", QUANTITY_SPEED, now.state.link[FOURLINK_COUPLER].velocity);
    if (t->v.kind.has_slot)
        put_sliding(t, i, &now.state);
    else
        put_rod(t, i, &now.state);
    put_parts(t, i, "aBn", "aBt", &now.state.link[FOURLINK_CRANK],
              arm(t, &now.state, FOURLINK_CRANK));
    if (t->v.problem.has_forces)
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
