/* SPDX-License-Identifier: GPL-3.0-or-later
**
** driven_decks.h - a deck at one instant with another drive than the crank, and the same with that effort as a given load.
**
** With the effort of the drive as a load, the crank needs no torque, and every pin has the same force, with its friction.
** Power is the same as with the crank driving, unless friction loses another part of it.
*/
#ifndef DRIVEN_DECKS_H
#define DRIVEN_DECKS_H

#include "prescribed_decks.h"

#define FORCES                                                                                 \
    " F12x F12y F23x F23y F34x F34y F14x F14y N M14 M34 N34 friction_A friction_B friction_C " \
    "friction_D friction_guide friction_slot Fsx "                                             \
    "Fsy Ms "

/* A drive that is tried: of a link, along the slide, an actuator, a load of unknown size. */
static char drive_lines[600], load_lines[900], drive_name[20];
static int driven_ends[2];
static fourlink_vector points[2];

static void draw_drive(double crank)
{
    int sort = one_of(4), i;
    double direction = between(-180, 180);

    *drive_lines = '\0';
    if (sort == 0 && kind == FOURLINK_INVERTED_SLIDER_CRANK) {
        strcpy(drive_name, "slide");
    } else if (sort < 2) {
        snprintf(drive_name, sizeof drive_name, "%s", link_of(4));
    } else if (sort == 2) {
        strcpy(drive_name, "Ram");
        driven_ends[0] = 2 + one_of(3);
        do
            driven_ends[1] = 1 + one_of(4);
        while (driven_ends[1] == driven_ends[0]);
        for (i = 0; i < 2; i++) {
            points[i].x = crank * between(-3, 3);
            points[i].y = crank * between(-3, 3);
        }
        snprintf(drive_lines, sizeof drive_lines,
                 "\n[actuator Ram]\nlink = %s\nat = (%.17g, %.17g) m\nto = %s\nto_at = (%.17g, "
                 "%.17g) m\n",
                 link_of(driven_ends[0]), points[0].x, points[0].y, link_of(driven_ends[1]),
                 points[1].x, points[1].y);
    } else {
        strcpy(drive_name, "Clamp");
        driven_ends[0] = 2 + one_of(3);
        points[0].x = crank * between(-3, 3);
        points[0].y = crank * between(-3, 3);
        points[1].x = cos(direction);
        points[1].y = sin(direction);
        snprintf(drive_lines, sizeof drive_lines,
                 "\n[load Clamp]\nlink = %s\nat = (%.17g, %.17g) m\nforce = unknown at %.17g "
                 "rad\nframe = ground\n",
                 link_of(driven_ends[0]), points[0].x, points[0].y, direction);
    }
}

static void add_load(int link, fourlink_vector at, double Fx, double Fy, const char *frame)
{
    size_t n = strlen(load_lines);

    if (link > 1)
        snprintf(load_lines + n, sizeof load_lines - n,
                 "\n[load Drive%d]\nlink = %s\nat = (%.17g, %.17g) m\nforce = (%.17g, %.17g) "
                 "N\nframe = %s\n",
                 link, link_of(link), at.x, at.y, Fx, Fy, frame);
}

static void place_of(const fourlink_state *at_row, int link, const fourlink_vector *at,
                     fourlink_vector *place)
{
    if (link > 1)
        fourlink_point(at_row, link, at, place, NULL, NULL);
    else
        *place = *at;
}

/* The effort Q as loads. */
static void write_effort(const fourlink_state *at_row, double Q)
{
    const fourlink_link_state *slider = &at_row->link[3], *lever = &at_row->link[4];
    fourlink_vector none = {0, 0}, r, at, P, Q_end;
    double n;

    *load_lines = '\0';
    if (strcmp(drive_name, "slide") == 0) {
        r.x = slider->origin.x - lever->origin.x;
        r.y = slider->origin.y - lever->origin.y;
        at.x = r.x * lever->axis.x + r.y * lever->axis.y;
        at.y = lever->axis.x * r.y - lever->axis.y * r.x;
        add_load(3, none, Q * slider->axis.x, Q * slider->axis.y, "ground");
        add_load(4, at, -Q * slider->axis.x, -Q * slider->axis.y, "ground");
    } else if (strcmp(drive_name, "Ram") == 0) {
        place_of(at_row, driven_ends[0], &points[0], &P);
        place_of(at_row, driven_ends[1], &points[1], &Q_end);
        n = hypot(P.x - Q_end.x, P.y - Q_end.y);
        add_load(driven_ends[0], points[0], Q * (P.x - Q_end.x) / n, Q * (P.y - Q_end.y) / n,
                 "ground");
        add_load(driven_ends[1], points[1], -Q * (P.x - Q_end.x) / n, -Q * (P.y - Q_end.y) / n,
                 "ground");
    } else if (strcmp(drive_name, "Clamp") == 0) {
        add_load(driven_ends[0], points[0], Q * points[1].x, Q * points[1].y, "ground");
    } else if (fourlink_slides(kind, 4)) {
        add_load(4, none, Q, 0, "ground");
    } else {
        snprintf(load_lines, sizeof load_lines, "\n[load Drive4]\nlink = %s\ntorque = %.17g N m\n",
                 link_of(4), Q);
    }
}

static int is_force(const char *name)
{
    return is_one_of(name, FORCES);
}

/* Of a pin, the friction circle: its friction moment / its force.  0 where the force is rounding error of others: without
** mass and load, pins transmit nothing of what drives. */
static double circle_of(const columns *c, const double *row, int pin)
{
    static const char *const forces[] = {"F12", "F23", "F34", "F14"};
    char moment[20];
    double F = named(c, row, forces[pin]), largest = 0;
    int i;

    for (i = 0; i < c->n; i++)
        if (strcmp(c->list[i].told->quantity, "force") == 0 && isfinite(row[i]))
            largest = fmax(largest, fabs(row[i]));
    snprintf(moment, sizeof moment, "friction_%c", 'A' + pin);
    return F > 1e-6 * largest ? named(c, row, moment) / F : 0;
}

/* Strong friction can have two solutions, of which each way of driving comes to its own: then both have the same friction
** circles, and other pin forces.  A circle that differs is a mistake. */
static int is_other_solution(const side *b, const side *c, const double *driven, const double *row,
                             double size)
{
    int pin, k = find_column(&b->c, "F12");

    if (find_column(&b->c, "power_friction") < 0)
        return 0;
    for (pin = 0; pin < 4; pin++)
        if (circle_of(&b->c, driven, pin) > 0 && circle_of(&c->c, row, pin) > 0)
            compare(EXTREME, circle_of(&c->c, row, pin), circle_of(&b->c, driven, pin),
                    1e3 * circle_of(&c->c, row, pin), "the friction circle of pin %d by %s", pin,
                    drive_name);
    return fabs(named(&c->c, row, "Ts")) > 1e-9 * size &&
           fabs(driven[k] - row[find_column(&c->c, "F12")]) > 1e-9 * fabs(driven[k]);
}

/* The loads of what drives: their power is that of the drive, and each is on the link that the list of them tells. */
static void compare_drive_loads(const side *b, const fourlink_instant *now, double Q, double power,
                                double size)
{
    const fourlink_deck *deck = fourlink_results_deck(b->r);
    fourlink_problem problem = problem_of(b->r);
    fourlink_load_info info;
    fourlink_load load[2];
    double found = 0;
    int n = 0, i;

    fourlink_drive_loads(&problem.mechanism, &now->state, Q, load, &n);
    for (i = 0; i < n; i++) {
        const fourlink_link_state *link = &now->state.link[load[i].link];
        fourlink_vector v, F = load[i].force;

        fourlink_point(&now->state, load[i].link, &load[i].at, NULL, &v, NULL);
        if (load[i].frame == FOURLINK_FRAME_LINK) {
            F.x = load[i].force.x * link->axis.x - load[i].force.y * link->axis.y;
            F.y = load[i].force.x * link->axis.y + load[i].force.y * link->axis.x;
        }
        found += F.x * v.x + F.y * v.y + load[i].torque * link->omega;
        if (fourlink_deck_drive(deck, (unsigned long)i, &info) != FOURLINK_OK ||
            info.link != load[i].link || info.has_torque != (load[i].torque != 0))
            fail("load %d of %s is on link %d, listed on %d", i, drive_name, load[i].link,
                 info.link);
    }
    if (n == 0 || fourlink_deck_drive(deck, (unsigned long)n, &info) == FOURLINK_OK)
        fail("%s has %d loads, and others are listed", drive_name, n);
    compare(ROW, power, found, size, "the power of the loads of %s", drive_name);
}

static void compare_driven_branch(const side *b, fourlink_branch branch, double crank)
{
    static side c;
    static double driven[MOST_COLUMNS], row[MOST_COLUMNS];
    double scale[QUANTITY_COUNT], condition, K, Q, w, size;
    fourlink_instant now;
    int status = fourlink_results_row(b->r, branch, 0, driven, &now, NULL), j, k;
    size_t n;

    if (status != FOURLINK_OK)
        return; /* dead, locked: other trials look at them */
    to_si(&b->c, driven);
    w = named(&b->c, driven, "omega2");
    Q = driven[find_column(&b->c, "drive")];
    K = fabs(now.forces.at_crank / Q) /
        (b->c.list[find_column(&b->c, "drive")].q == QUANTITY_FORCE ? crank : 1);
    if (Q != 0)
        compare_drive_loads(b, &now, Q, named(&b->c, driven, "power"),
                            fabs(now.forces.at_crank * w) * fmax(1, 1 / K));
    write_effort(&now.state, Q);
    snprintf(changed_text, sizeof changed_text, "%s", base_text);
    n = strlen(changed_text);
    snprintf(changed_text + n, sizeof changed_text - n, "%s", load_lines);
    prepare(&c, opened(changed_text, NULL));
    if (!c.r)
        return;
    present->cases++;
    status = fourlink_results_row(c.r, branch, 0, row, NULL, NULL);
    to_si(&c.c, row);
    condition = find_scales(&c.c, row, crank, fabs(w), scale);
    size = condition * condition * fmax(1, 1 / K);
    if (is_other_solution(b, &c, driven, row,
                          size * (scale[QUANTITY_TORQUE] + scale[QUANTITY_FORCE] * crank))) {
        present->undecided++;
        fourlink_results_free(c.r);
        return;
    }
    if (status != FOURLINK_OK)
        fail("%s by %s: status %d with its effort as a load", fourlink_branch_text((int)branch),
             drive_name, status);
    else
        compare(ROW, 0, row[find_column(&c.c, "Ts")],
                size * (scale[QUANTITY_TORQUE] + scale[QUANTITY_FORCE] * crank), "%s by %s: Ts",
                fourlink_branch_text((int)branch), drive_name);
    for (j = 0; j < b->c.n && !has_failed; j++) {
        k = find_column(&c.c, b->c.list[j].told->name);
        if (k < 0 || !is_force(b->c.list[j].told->name))
            continue;
        if (strncmp(b->c.list[j].told->name, "Fs", 2) == 0 ||
            strcmp(b->c.list[j].told->name, "Ms") == 0)
            continue; /* a drive on the ground acts on it, a load does not */
        compare(ROW, row[k], driven[j],
                size * (b->c.list[j].q == QUANTITY_TORQUE
                            ? scale[QUANTITY_TORQUE] + scale[QUANTITY_FORCE] * crank
                            : scale[QUANTITY_FORCE] + scale[QUANTITY_TORQUE] / crank),
                "%s by %s: %s", fourlink_branch_text((int)branch), drive_name,
                b->c.list[j].told->name);
    }
    compare(ROW, Q * named(&b->c, driven, "omega2") * now.forces.at_crank / Q,
            driven[find_column(&b->c, "power")], fabs(now.forces.at_crank * w) + DBL_MIN, "power");
    fourlink_results_free(c.r);
}

static void compare_driven(void)
{
    static side a, b;
    fourlink_problem problem;
    double crank;
    int k;

    prepare(&a, opened(base_text, NULL));
    if (!a.r)
        return;
    problem = problem_of(a.r);
    crank = problem.mechanism.design.link[2].length;
    draw_drive(crank);
    read_lines(&changed, base_text);
    set_line(&changed, KEY_MOTION_DRIVE, drive_name);
    write_lines(&changed, changed_text, sizeof changed_text);
    snprintf(changed_text + strlen(changed_text), sizeof changed_text - strlen(changed_text), "%s",
             drive_lines);
    prepare(&b, problem.axes_on_page || !problem.has_forces ? NULL : opened(changed_text, NULL));
    for (k = 0; b.r && k < (kind == FOURLINK_SCOTCH_YOKE ? 1 : 2) && !has_failed; k++)
        compare_driven_branch(&b, k == 0 ? FOURLINK_OPEN : FOURLINK_CROSSED, crank);
    fourlink_results_free(a.r);
    fourlink_results_free(b.r);
}

#endif
