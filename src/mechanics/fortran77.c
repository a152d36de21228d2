/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fortran77.c - the analysis of one crank position for FORTRAN 77 programs; see fourlink.h.
*/
#include <string.h>

#include "mechanics.h"

enum { LINK_NUMBERS = 5, LOAD_NUMBERS = 7, STATE_NUMBERS = 9 };

/* A small whole number stored as a double; -1 if it is not one. */
static int whole(double x)
{
    int i = 0 <= x && x < 100 ? (int)x : -1;

    return (double)i == x ? i : -1;
}

static void get_design(const double *links, const double *grav, fourlink_design *design)
{
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++, links += LINK_NUMBERS) {
        design->link[i].length = links[0];
        design->link[i].mass = links[1];
        design->link[i].inertia = links[2];
        design->link[i].cg.x = links[3];
        design->link[i].cg.y = links[4];
    }
    design->gravity.x = grav[0];
    design->gravity.y = grav[1];
}

static void get_loads(const double *numbers, int n, fourlink_load *loads)
{
    int i;

    for (i = 0; i < n; i++, numbers += LOAD_NUMBERS) {
        loads[i].link = whole(numbers[0]);
        loads[i].frame = (fourlink_frame)whole(numbers[1]);
        loads[i].force.x = numbers[2];
        loads[i].force.y = numbers[3];
        loads[i].at.x = numbers[4];
        loads[i].at.y = numbers[5];
        loads[i].torque = numbers[6];
    }
}

static void put_state(const fourlink_state *state, double *numbers)
{
    int i;

    memset(numbers, 0, STATE_NUMBERS * sizeof *numbers); /* link 1 */
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++) {
        const fourlink_link_state *link = &state->link[i];
        double *out = numbers + (i - 1) * STATE_NUMBERS;

        out[0] = link->theta;
        out[1] = link->omega;
        out[2] = link->alpha;
        out[3] = link->origin.x;
        out[4] = link->origin.y;
        out[5] = link->velocity.x;
        out[6] = link->velocity.y;
        out[7] = link->acceleration.x;
        out[8] = link->acceleration.y;
    }
}

/* Ten numbers; eleven if there are two couples. */
static void put_forces(const fourlink_forces *forces, int has_two, double *numbers)
{
    double list[FLK_FORCES];
    int i;

    flk_list_forces(forces, list);
    for (i = 0; i < 8; i++)
        numbers[i] = list[i];
    numbers[8] = has_two ? list[8] : list[8] + list[9];
    numbers[9] = list[10];
    if (has_two)
        numbers[10] = list[9];
}

/* `design` is complete except for links and gravity, which are still in the caller's arrays. */
static int analyse(fourlink_design *design, const double *links, const double *grav, int branch,
                   const double *crank_numbers, int n_loads, const double *load_numbers,
                   fourlink_state *state, double *state_numbers, double *force_numbers)
{
    fourlink_load loads[FOURLINK_F77_LOADS];
    fourlink_crank crank;
    fourlink_forces forces;
    int status;

    if (n_loads < 0 || n_loads > FOURLINK_F77_LOADS)
        return FOURLINK_TOO_MANY_LOADS;
    get_design(links, grav, design);
    get_loads(load_numbers, n_loads, loads);
    crank.theta2 = crank_numbers[0];
    crank.omega2 = crank_numbers[1];
    crank.alpha2 = crank_numbers[2];
    status = fourlink_analyse_design(design, (fourlink_branch)branch, &crank, loads,
                                     (unsigned long)n_loads, state, &forces);
    if (status == FOURLINK_OK) {
        put_state(state, state_numbers);
        put_forces(&forces, design->kind == FOURLINK_SCOTCH_YOKE, force_numbers);
    }
    return status;
}

void flfbar_(const double links[20], const double grav[2], const int *ibrnch, const double crank[3],
             const int *nloads, const double *loads, double state[36], double forces[10],
             int *istat)
{
    fourlink_design design;
    fourlink_state at;

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_FOUR_BAR;
    *istat = analyse(&design, links, grav, *ibrnch, crank, *nloads, loads, &at, state, forces);
}

void flslcr_(const double links[20], const double *offset, const double grav[2], const int *ibrnch,
             const double crank[3], const int *nloads, const double *loads, double state[36],
             double forces[10], int *istat)
{
    fourlink_design design;
    fourlink_state at;

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_SLIDER_CRANK;
    design.offset = *offset;
    *istat = analyse(&design, links, grav, *ibrnch, crank, *nloads, loads, &at, state, forces);
}

void flinvs_(const double links[20], const double *offset, const double *angle,
             const double grav[2], const int *ibrnch, const double crank[3], const int *nloads,
             const double *loads, double state[36], double slide[4], double forces[10], int *istat)
{
    fourlink_design design;
    fourlink_state at;

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_INVERTED_SLIDER_CRANK;
    design.offset = *offset;
    design.angle = *angle;
    *istat = analyse(&design, links, grav, *ibrnch, crank, *nloads, loads, &at, state, forces);
    if (*istat != FOURLINK_OK)
        return;
    slide[0] = at.slide;
    slide[1] = at.slide_v;
    slide[2] = at.slide_a;
    slide[3] = at.coriolis;
}

void flyoke_(const double links[20], const double *offset, const double *angle,
             const double grav[2], const double crank[3], const int *nloads, const double *loads,
             double state[36], double slide[3], double forces[11], int *istat)
{
    fourlink_design design;
    fourlink_state at;

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_SCOTCH_YOKE;
    design.offset = *offset;
    design.angle = *angle;
    *istat =
        analyse(&design, links, grav, FOURLINK_OPEN, crank, *nloads, loads, &at, state, forces);
    if (*istat != FOURLINK_OK)
        return;
    slide[0] = at.slide;
    slide[1] = at.slide_v;
    slide[2] = at.slide_a;
}

void fltext_(const int *istat, char *text, unsigned long length)
{
    const char *words = fourlink_status_text(*istat);
    unsigned long n = (unsigned long)strlen(words);

    memset(text, ' ', length);
    memcpy(text, words, n < length ? n : length);
}
