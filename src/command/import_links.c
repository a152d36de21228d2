/* SPDX-License-Identifier: GPL-3.0-or-later
**
** import_links.c - the links and pins of a deck among those of a link of PMKS+.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "import_links.h"

#define STEP 15.0    /* deg, of the directions that are drawn */
#define ROUNDED 0.03 /* deg, by which a direction in rad with three decimals can be beside one */

/* ------------------------------------------------------------------------------------- the four links */

/* The number of fixed joints of a link, and one of them. */
static int count_fixed(const import_links *m, text link, const pmks_joint **fixed)
{
    size_t i;
    int n = 0;

    for (i = 0; i < m->from.n_joints; i++)
        if (m->from.joints[i].is_fixed && pmks_has_name(m->from.joints[i].links, link)) {
            *fixed = &m->from.joints[i];
            n++;
        }
    return n;
}

/* Take the crank: the only link of the fixed pin that is the input. */
static int take_crank(import_links *m)
{
    const pmks_joint *A = NULL, *other;
    size_t i;

    for (i = 0; i < m->from.n_joints; i++)
        if (m->from.joints[i].is_input && A)
            return pmks_refuse(&m->from, "there are two inputs, %t and %t: a deck has one crank",
                               A->name, m->from.joints[i].name);
        else if (m->from.joints[i].is_input)
            A = &m->from.joints[i];
    if (!A)
        return pmks_refuse(&m->from, "no joint is the input, which turns the crank");
    if (A->slides || !A->is_fixed)
        return pmks_refuse(&m->from, "the input %t is not a fixed pin, on which a crank turns",
                           A->name);
    if (!A->links.length || flk_text_count(A->links, '|'))
        return pmks_refuse(&m->from, "the input %t must be the pin of one link, not of '%t'",
                           A->name, A->links);
    if (count_fixed(m, A->links, &other) > 1)
        return pmks_refuse(&m->from, "link %t of the input has two fixed joints: it cannot turn",
                           A->links);
    m->pin[PIN_A] = A;
    m->link[2] = A->links;
    return 1;
}

static int are_apart(const pmks_joint *x, const pmks_joint *y)
{
    return x->x != y->x || x->y != y->y;
}

/* Take a link with one fixed joint as link 4, at pin C of the coupler.  Unless `far`, its slide is at C:
** further away it may be that of a rod on the coupler. */
static int take_follower(import_links *m, const pmks_joint *C, int far)
{
    text links = C->links, name;
    const pmks_joint *fixed = NULL;

    while (pmks_next_name(&links, &name)) {
        if (pmks_is_same(name, m->link[3]) || count_fixed(m, name, &fixed) != 1 ||
            (fixed->slides && are_apart(fixed, C) && !far))
            continue;
        m->pin[PIN_C] = C;
        m->link[4] = name;
        *(fixed->slides ? &m->slide : &m->pin[PIN_D]) = fixed;
        return 1;
    }
    return 0;
}

/* Take links 3 and 4, and their pins: a coupler whose own joint slides on the ground, or one with a link that
** turns or slides there. */
static int take_coupler(import_links *m, const pmks_joint *B, int far)
{
    text links = B->links;
    const pmks_joint *fixed = NULL;
    size_t i;
    int n;

    while (pmks_next_name(&links, &m->link[3])) {
        if (pmks_is_same(m->link[3], m->link[2]))
            continue;
        n = count_fixed(m, m->link[3], &fixed);
        if (n == 1 && fixed->slides) {
            m->pin[PIN_C] = m->slide = fixed;
            return 1;
        }
        for (i = 0; i < m->from.n_joints && !n; i++) {
            const pmks_joint *C = &m->from.joints[i];

            if (!C->slides && !C->is_fixed && pmks_has_name(C->links, m->link[3]) &&
                !pmks_has_name(C->links, m->link[2]) && take_follower(m, C, far))
                return 1;
        }
    }
    return 0;
}

static int take_four_links(import_links *m)
{
    size_t i;
    int far;

    if (!take_crank(m))
        return 0;
    for (far = 0; far < 2; far++)
        for (i = 0; i < m->from.n_joints; i++) {
            const pmks_joint *B = &m->from.joints[i];

            if (B->is_fixed || B->slides || !pmks_has_name(B->links, m->link[2]))
                continue;
            m->pin[PIN_B] = B;
            if (take_coupler(m, B, far))
                return 1;
        }
    return pmks_refuse(
        &m->from,
        "no loop of four links has link %t of the input: a deck has the ground, a crank "
        "and two links that join it to a fixed pin or slide",
        m->link[2]);
}

int import_is_rod(int number)
{
    return number >= IMPORT_FIRST_OUTPUT && (number - IMPORT_FIRST_OUTPUT) % 2;
}

int import_number_of(const import_links *m, text link)
{
    int i;

    for (i = 2; i <= 4; i++)
        if (pmks_is_same(m->link[i], link))
            return i;
    for (i = 0; i < m->n_outputs; i++) {
        if (pmks_is_same(m->output[i].follower, link))
            return IMPORT_FIRST_OUTPUT + 2 * i;
        if (pmks_is_same(m->output[i].rod, link))
            return IMPORT_FIRST_OUTPUT + 2 * i + 1;
    }
    return 0;
}

int import_carrier_of(const import_links *m, const pmks_joint *x)
{
    text links = x->links, name;
    int number = 0, one;

    while (pmks_next_name(&links, &name)) {
        one = import_number_of(m, name);
        number = one && (!number || one < number) ? one : number;
    }
    return number;
}

const import_output *import_output_of(const import_links *m, int number)
{
    return number < IMPORT_FIRST_OUTPUT ? NULL : &m->output[(number - IMPORT_FIRST_OUTPUT) / 2];
}

int import_slides(const import_links *m, int number)
{
    const import_output *o = import_output_of(m, number);

    return o ? o->end->slides && !import_is_rod(number) : number == 4 && m->slide;
}

int import_is_pin(const import_links *m, const pmks_joint *x)
{
    int i;

    for (i = 0; i < PINS; i++)
        if (m->pin[i] == x)
            return 1;
    return m->slide == x;
}

/* --------------------------------------------------------------------------------------- directions */

double import_direction(double x, double y, double to_x, double to_y)
{
    return atan2(to_y - y, to_x - x) * 180 / M_PI;
}

double import_direction_of_slide(const pmks_joint *slide)
{
    double drawn = STEP * floor(slide->angle / STEP + 0.5);

    return fabs(slide->angle - drawn) > ROUNDED ? slide->angle : drawn;
}

void import_axis_pins(const import_links *m, int number, const pmks_joint **from,
                      const pmks_joint **to)
{
    const import_output *o = import_output_of(m, number);

    if (o && import_slides(m, number)) {
        *from = *to = o->Q;
    } else if (o) {
        *from = import_is_rod(number) ? o->P : o->end;
        *to = o->Q;
    } else {
        *from = m->pin[number == 2 ? PIN_A : number == 3 ? PIN_B : m->slide ? PIN_C : PIN_D];
        *to = m->pin[number == 2 ? PIN_B : PIN_C];
    }
}

double import_axis(const import_links *m, int number)
{
    const pmks_joint *from, *to;

    if (import_slides(m, number))
        return import_direction_of_slide(number == 4 ? m->slide : import_output_of(m, number)->end);
    import_axis_pins(m, number, &from, &to);
    return import_direction(from->x, from->y, to->x, to->y);
}

/* --------------------------------------------------------------------------------------- the outputs */

/* The joints by which a link ends: those that are fixed, or also on a link of the deck.  `but` is none.
** Returns how many there are, and one of them. */
static int count_ends(const import_links *m, text link, const pmks_joint *but,
                      const pmks_joint **end)
{
    size_t i;
    int n = 0;

    for (i = 0; i < m->from.n_joints; i++) {
        const pmks_joint *x = &m->from.joints[i];

        if (x != but && pmks_has_name(x->links, link) &&
            (x->is_fixed || x->slides || import_carrier_of(m, x))) {
            *end = x;
            n++;
        }
    }
    return n;
}

/* Take the second link of an output, from the pin Q of its rod on. */
static int take_follower_of(const import_links *m, import_output *o)
{
    text links = o->Q->links, name;
    const pmks_joint *end = NULL;

    while (pmks_next_name(&links, &name)) {
        if (pmks_is_same(name, o->rod) || count_ends(m, name, o->Q, &end) != 1 ||
            (end->slides ? !end->is_fixed : !are_apart(end, o->Q)))
            continue;
        o->to = end->is_fixed ? 0 : import_carrier_of(m, end);
        if (o->to == o->carrier)
            continue; /* the two would be one with that link */
        o->follower = name;
        o->end = end;
        return 1;
    }
    return 0;
}

/* Take a link that hangs on the pin P as the rod of an output, with what it moves. */
static int take_rod(import_links *m, const pmks_joint *P, text rod)
{
    import_output *o = &m->output[m->n_outputs];
    const pmks_joint *end = NULL;
    size_t i;
    int n = count_ends(m, rod, P, &end);

    memset(o, 0, sizeof *o);
    o->rod = rod;
    o->P = P;
    o->carrier = import_carrier_of(m, P);
    if (n == 1 && end->slides && end->is_fixed && are_apart(P, end)) {
        o->Q = o->end = end;
        m->n_outputs++;
        return 1;
    }
    for (i = 0; i < m->from.n_joints && !n; i++) {
        o->Q = &m->from.joints[i];
        if (are_apart(P, o->Q) && pmks_has_name(o->Q->links, rod) && take_follower_of(m, o)) {
            m->n_outputs++;
            return 1;
        }
    }
    return 0;
}

/* Take an output that hangs on links which are taken already. */
static int take_output(import_links *m)
{
    size_t i;

    for (i = 0; i < m->from.n_joints; i++) {
        const pmks_joint *P = &m->from.joints[i];
        text links = P->links, name;

        if (P->is_fixed || P->slides || !import_carrier_of(m, P))
            continue;
        while (pmks_next_name(&links, &name))
            if (!import_number_of(m, name) && take_rod(m, P, name))
                return 1;
    }
    return 0;
}

int import_find_links(import_links *m)
{
    if (!take_four_links(m))
        return 0;
    while (m->n_outputs < IMPORT_MOST_OUTPUTS && take_output(m))
        ;
    return 1;
}
