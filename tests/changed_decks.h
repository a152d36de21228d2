/* SPDX-License-Identifier: GPL-3.0-or-later
**
** changed_decks.h - a deck scaled, turned, mirrored, with reversed time, in other units and another order, and what that
** makes of its columns.
*/
#ifndef CHANGED_DECKS_H
#define CHANGED_DECKS_H

#include "same_results.h"

/* ---------------------------------------------------------------------------- what all laws begin with */

static double factor_one(const fourlink_value *of)
{
    (void)of;
    return 1;
}

/* The file of a curve as the points that it has. */
static void write_card_in(deck_line *line)
{
    unsigned long size;
    const char *at = load_card(NULL, "card.csv", &size),
               *unit_name = line->value + strlen("file card.csv deg ");
    char list[LONG_VALUE] = "";
    double x, y;

    if (strncmp(line->value, "file ", 5) != 0)
        return;
    for (at = strchr(at, '\n') + 1; sscanf(at, "%lf %lf", &x, &y) == 2; at = line_end(at))
        append(list, "%s%g deg %g %s", *list ? ", " : "", x, y, unit_name);
    snprintf(line->value, sizeof line->value, "%s", list);
}

/* The deck as the laws take it: all its columns, no file, no sweep, no printed values, and what has a
** default with a dimension said. */
static void make_base(void)
{
    int i, k;

    read_lines(&base, deck_text);
    drop_sections(&base, SECTION_SWEEP);
    drop_sections(&base, SECTION_EXPECT);
    drop_sections(&base, SECTION_MISPRINT);
    drop_sections(&base, SECTION_GRADING);
    for (i = 0; i < base.n; i++)
        for (k = 0; k < base.block[i].n; k++)
            write_card_in(&base.block[i].line[k]);
    set_line(&base, KEY_TOP_AXES, "ground");
    set_line(&base, KEY_TABLE_COLUMNS, "all");
    set_default(&base, KEY_GRAVITY_ACCELERATION, "9.80665 m/s2");
    set_default(&base, KEY_GRAVITY_DIRECTION, "-90 deg");
}

static int is_task(deck_lines *d)
{
    return find_block(d, SECTION_SYNTHESIS) != NULL;
}

/* 1 if the direction of the ground is given by places. */
static int has_pins(deck_lines *d)
{
    return find_block(d, SECTION_PINS) != NULL || find_line(d, KEY_GROUND_TO);
}

/* ---------------------------------------------------------------------------------------------- scales */

static double scales[3]; /* of metre, kilogram and second */

static double factor_of(dimension dim)
{
    return pow(scales[0], dim.m) * pow(scales[1], dim.kg) * pow(scales[2], dim.s);
}

static void scale_number(deck_number *n, const deck_line *line, const void *how)
{
    (void)line;
    (void)how;
    n->value *= factor_of(n->dim);
}

/* The free fall of a pendulum is that of the earth where a deck has no gravity: an acceleration stays as
** it is. */
static void keep_fall(void)
{
    if (strstr(deck_text, "swing_period"))
        scales[0] = scales[2] * scales[2];
}

static double factor_scaled(const fourlink_value *of)
{
    return factor_of(flk_quantities[flk_quantity_find(of->quantity)].dim);
}

/* With powers of two no digit changes, but where GSL chooses its pivots. */
static int scale_by_two(deck_lines *d)
{
    int i;

    if (is_task(d) || find_line(d, KEY_MOTION_MODE))
        return 0;
    set_line(&base, KEY_TOP_SOLVER, "dyad");
    *d = base;
    for (i = 0; i < 3; i++)
        scales[i] = ldexp(1, between_whole(-6, 7));
    keep_fall();
    change_numbers(d, scale_number, NULL);
    return 1;
}

static int scale_by_any(deck_lines *d)
{
    int i;

    for (i = 0; i < 3; i++)
        scales[i] = power_of_ten(-1, 1);
    keep_fall();
    change_numbers(d, scale_number, NULL);
    return 1;
}

/* ------------------------------------------------------------------------------------ turned, mirrored */

static double angle;

static void turn_number(deck_number *n, const deck_line *line, const void *how)
{
    (void)how;
    if (line->key == KEY_GROUND_ANGLE || line->key == KEY_GRAVITY_DIRECTION)
        n->value += angle / (strcmp(n->unit_name, "rad") == 0 ? 1 : PI / 180) /
                    (strcmp(n->unit_name, "rev") == 0 ? 360 : 1);
}

/* The ground and gravity turn; all else is in the axes of the ground. */
static int turn(deck_lines *d)
{
    if (has_pins(d))
        return 0;
    angle = between(-PI, PI);
    set_default(d, KEY_GROUND_ANGLE, "0 deg");
    change_numbers(d, turn_number, NULL);
    return 1;
}

static int is_torque(dimension dim)
{
    return flk_dimension_equal(dim, flk_quantities[QUANTITY_TORQUE].dim);
}

/* Angles, what they have to do with, and torques change their sign in a mirror, unless they are sizes. */
static int is_turning(dimension dim)
{
    return dim.rad == 1 || is_torque(dim);
}

static const char *value_of(const deck_block *b, key_code key, const char *otherwise)
{
    deck_line *line = line_of((deck_block *)b, key);

    return line ? line->value : otherwise;
}

/* 1 if what a load follows changes its sign in a mirror. */
static int follows_turning(const char *over)
{
    return strncmp(over, "theta", 5) == 0 || strncmp(over, "omega", 5) == 0 ||
           (kind == FOURLINK_SCOTCH_YOKE && strncmp(over, "slide", 5) == 0);
}

/* The value of a load that has the sign of a speed which changes its own. */
static int has_sign_of_speed(const deck_block *b)
{
    return line_of((deck_block *)b, KEY_LOAD_AT_SPEED) &&
           follows_turning(value_of(b, KEY_LOAD_OVER, "theta2"));
}

/* 1 if a place is told along the slot of a yoke, whose direction is turned around: its angle stays below
** 180 deg. */
static int is_along_slot(const deck_block *b, key_code key)
{
    key_code link = key == KEY_SPRING_TO_AT     ? KEY_SPRING_TO
                    : key == KEY_OUTPUT_TO_AT   ? KEY_OUTPUT_TO
                    : key == KEY_ACTUATOR_AT    ? KEY_ACTUATOR_LINK
                    : key == KEY_ACTUATOR_TO_AT ? KEY_ACTUATOR_TO
                    : key == KEY_SPRING_AT      ? KEY_SPRING_LINK
                    : key == KEY_POINT_AT       ? KEY_POINT_LINK
                    : key == KEY_OUTPUT_AT      ? KEY_OUTPUT_LINK
                                                : KEY_LOAD_LINK;
    int is_place =
        key == KEY_SPRING_AT || key == KEY_SPRING_TO_AT || key == KEY_POINT_AT ||
        key == KEY_LOAD_AT || key == KEY_OUTPUT_AT || key == KEY_OUTPUT_TO_AT ||
        key == KEY_ACTUATOR_AT || key == KEY_ACTUATOR_TO_AT ||
        (key == KEY_LOAD_FORCE && strcmp(value_of(b, KEY_LOAD_FRAME, "ground"), "link") == 0);

    return kind == FOURLINK_SCOTCH_YOKE &&
           (key == KEY_SLIDER_CG || key == KEY_SLIDER_SWING_PIN ||
            (is_place && strcmp(value_of(b, link, ""), "slider") == 0));
}

/* 1 for the direction of a slot in the slider of a yoke, which an output runs in. */
static int is_slot_of_slider(const deck_block *b, key_code key)
{
    return kind == FOURLINK_SCOTCH_YOKE && key == KEY_OUTPUT_SLOT_ANGLE &&
           strcmp(value_of(b, KEY_OUTPUT_LINK, ""), "slider") == 0 &&
           strcmp(value_of(b, KEY_OUTPUT_SLOT, ""), "link") == 0;
}

static void less_from_half_turn(deck_number *n)
{
    unit u;
    text bad;

    flk_unit_read(flk_text_of(n->unit_name[0] ? n->unit_name : "deg"), &u, &bad);
    n->value = flk_unit_from_si(PI, u) - n->value;
}

static void mirror_number(deck_number *n, const deck_line *line, const void *how)
{
    const deck_block *b = how;
    int changes = n->part == COMPONENT_Y || n->part == POLAR;

    if (line->key >= KEY_COUNT)
        return;
    if (line->key == KEY_YOKE_ANGLE || is_slot_of_slider(b, line->key) ||
        (n->part == POLAR && is_along_slot(b, line->key))) {
        less_from_half_turn(n);
        return;
    }
    if (n->part == ARGUMENT)
        changes = is_turning(n->dim) || (line->key != KEY_MOTION_PROGRAM &&
                                         follows_turning(value_of(b, KEY_LOAD_OVER, "theta2")));
    else if (is_along_slot(b, line->key))
        changes = n->part == COMPONENT_X || n->part == WHOLE;
    else if (n->part == WHOLE)
        changes = (flk_key_table[line->key].sign == SIGN_ANY && is_turning(n->dim)) ||
                  line->key == KEY_MOTION_TURNS || line->key == KEY_GROUND_OFFSET ||
                  line->key == KEY_LEVER_OFFSET || line->key == KEY_OUTPUT_OFFSET;
    if (has_sign_of_speed(b) && (line->key == KEY_LOAD_FORCE || line->key == KEY_LOAD_TORQUE) &&
        n->part != POLAR)
        changes = !changes;
    if (changes)
        n->value = -n->value;
}

static void swap_names(deck_block *b, key_code one, key_code other)
{
    deck_line *first = line_of(b, one), *second = line_of(b, other);

    if (first && second) {
        char value[LONG_VALUE];

        memcpy(value, first->value, sizeof value);
        memcpy(first->value, second->value, sizeof value);
        memcpy(second->value, value, sizeof value);
    }
}

static int is_torsional(const deck_block *b)
{
    const char *value = value_of(b, KEY_SPRING_STIFFNESS, value_of(b, KEY_SPRING_DAMPING, ""));

    return strstr(value, "rad") || strstr(value, "/deg");
}

/* 1 if a torsional spring is on the block of a yoke, whose angle is that of the other direction of the
** slot. */
static int has_spring_on_block(const deck_lines *d)
{
    int i, has = 0;

    for (i = 0; i < d->n && kind == FOURLINK_SCOTCH_YOKE; i++)
        has |= is_torsional(&d->block[i]) &&
               (strcmp(value_of(&d->block[i], KEY_SPRING_LINK, ""), "slider") == 0 ||
                strcmp(value_of(&d->block[i], KEY_SPRING_TO, ""), "slider") == 0);
    return has;
}

/* 1 if a motion says which way it goes. */
static int has_sense(deck_lines *d)
{
    return find_line(d, KEY_MOTION_SPEED) || find_line(d, KEY_MOTION_MEAN_SPEED) ||
           find_line(d, KEY_MOTION_ACCELERATION) || find_line(d, KEY_MOTION_TO) ||
           find_line(d, KEY_MOTION_TURNS) || find_line(d, KEY_MOTION_AT) ||
           find_line(d, KEY_MOTION_PROGRAM) || find_block(d, SECTION_MOTOR);
}

/* About the x axis. */
static int mirror(deck_lines *d)
{
    int i, k;

    if (is_task(d) || has_spring_on_block(d) || !has_sense(d))
        return 0;
    for (i = 0; i < d->n; i++) {
        deck_block *b = &d->block[i];
        const char *over = value_of(b, KEY_LOAD_OVER, "theta2"),
                   *only = value_of(b, KEY_SPRING_ONLY, "");

        if (line_of(b, KEY_LOAD_FROM) && !line_of(b, KEY_LOAD_TO))
            add_line(b, "to",
                     find_line(d, KEY_MOTION_CYCLE) ? find_line(&base, KEY_MOTION_CYCLE)->value
                                                    : "360 deg");
        if (line_of(b, KEY_LOAD_TO) && !line_of(b, KEY_LOAD_FROM))
            add_line(b, "from", "0 deg");
        for (k = 0; k < b->n; k++) {
            deck_line *line = &b->line[k];
            int turns = (line->key == KEY_MOTOR_CURVE || b->section == SECTION_GAS ||
                         follows_turning(over)) &&
                        strchr(line->value, ',') != NULL;

            if (!has_numbers(line))
                continue;
            change_line(line, mirror_number, b);
            if (turns && (line->key == KEY_MOTOR_CURVE || line->key == KEY_GAS_INDICATOR ||
                          line->key == KEY_LOAD_FORCE || line->key == KEY_LOAD_TORQUE ||
                          line->key == KEY_LOAD_BACK))
                reverse_list(line->value);
        }
        if (line_of(b, KEY_FRICTION_DIRECTION)) {
            int goes_back = strcmp(value_of(b, KEY_FRICTION_DIRECTION, "forward"), "backward") == 0;

            set_line(d, KEY_FRICTION_DIRECTION, goes_back ? "forward" : "backward");
        }
        swap_names(b, KEY_LOAD_FROM, KEY_LOAD_TO);
        if (line_of(b, KEY_LOAD_BACK) && follows_turning(over)) {
            swap_names(b, KEY_LOAD_BACK, KEY_LOAD_FORCE);
            swap_names(b, KEY_LOAD_BACK, KEY_LOAD_TORQUE);
        }
        if (!line_of(b, KEY_OUTPUT_SLOT) &&
            (line_of(b, KEY_OUTPUT_PIVOT) || line_of(b, KEY_OUTPUT_TO))) {
            int is_right = strcmp(value_of(b, KEY_OUTPUT_SIDE, "left"), "right") == 0;

            if (!line_of(b, KEY_OUTPUT_SIDE))
                add_line(b, "side", "left");
            snprintf(line_of(b, KEY_OUTPUT_SIDE)->value, LONG_VALUE, "%s",
                     is_right ? "left" : "right");
        }
        if (kind == FOURLINK_FOUR_BAR && line_of(b, KEY_TABLE_BRANCH)) {
            int is_open = strcmp(value_of(b, KEY_TABLE_BRANCH, ""), "open") == 0;

            if (is_open || strcmp(value_of(b, KEY_TABLE_BRANCH, ""), "crossed") == 0)
                set_line(d, KEY_TABLE_BRANCH, is_open ? "crossed" : "open");
        }
        if (*only && is_torsional(b))
            snprintf(line_of(b, KEY_SPRING_ONLY)->value, LONG_VALUE, "%s",
                     strcmp(only, "pushes") == 0 ? "pulls" : "pushes");
    }
    return 1;
}

static double factor_mirrored(const fourlink_value *of)
{
    static const char to_the_left[] =
        " N side_thrust correction_force N34 coriolis freudenstein_B h2 h3 h4 ",
                      without_sign[] = " mu gamma ", along_slot[] = " slide slide_v slide_a ";
    const char *name = of->name;
    quantity q = flk_quantity_find(of->quantity);
    int is_component = ends_in(name, "y") && !ends_in(name, "ary") &&
                       (q == QUANTITY_LENGTH || q == QUANTITY_SPEED || q == QUANTITY_ACCELERATION ||
                        q == QUANTITY_FORCE);

    if (kind == FOURLINK_SCOTCH_YOKE && ends_in(name, "3_along"))
        return -1;
    if (is_one_of(name, without_sign) || strncmp(name, "friction_", 9) == 0 || ends_in(name, ".mu"))
        return 1;
    if (kind == FOURLINK_SCOTCH_YOKE &&
        (is_one_of(name, " N34 ") || (ends_in(name, "_across") && strstr(name, "3_"))))
        return 1;
    return is_component || is_one_of(name, to_the_left) || ends_in(name, "_across") ||
                   ends_in(name, ".N") || q == QUANTITY_TORQUE || flk_quantities[q].dim.rad == 1 ||
                   strncmp(name, "rubbing_", 8) == 0 ||
                   is_one_of(name, " klein_OM klein_QN klein_IX klein_IY klein_FT crank_effort ") ||
                   (strcmp(name, "mechanical_advantage") == 0 &&
                    (kind == FOURLINK_SLIDER_CRANK || kind == FOURLINK_SCOTCH_YOKE)) ||
                   (kind == FOURLINK_SCOTCH_YOKE && is_one_of(name, along_slot))
               ? -1
               : 1;
}

/* ---------------------------------------------------------------------- units, order, written and read */

static char result_units[100];
static double factor_of_x;

static void other_unit(deck_number *n, const deck_line *line, const void *how)
{
    const char *fitting[sizeof some_units / sizeof some_units[0]];
    int count = 0;
    size_t i;
    unit from, to;
    text bad;

    (void)line;
    (void)how;
    if (n->part == COMPONENT_Y) { /* in the unit of x */
        n->value *= factor_of_x;
        return;
    }
    factor_of_x = 1;
    if (!n->unit_name[0] || flk_dimension_equal(n->dim, flk_quantities[QUANTITY_NUMBER].dim))
        return;
    for (i = 0; i < sizeof some_units / sizeof some_units[0]; i++)
        if (flk_unit_read_as(flk_text_of(some_units[i]), n->dim, &to, &bad) &&
            flk_dimension_equal(to.dim, n->dim))
            fitting[count++] = some_units[i];
    if (count == 0)
        return;
    flk_unit_read_as(flk_text_of(n->unit_name), n->dim, &from, &bad);
    snprintf(n->unit_name, sizeof n->unit_name, "%s", fitting[one_of(count)]);
    flk_unit_read_as(flk_text_of(n->unit_name), n->dim, &to, &bad);
    n->value = flk_unit_in(n->value, from, to);
    factor_of_x = flk_unit_in(1, from, to);
}

static int change_units(deck_lines *d)
{
    static const char *const sets[] = {"SI",    "mm, rpm, N",    "in, lbf",
                                       "cm, g", "ft, lb, deg/s", "rad, kW"};

    snprintf(result_units, sizeof result_units, "%s", sets[one_of(6)]);
    change_numbers(d, other_unit, NULL);
    return 1;
}

/* Sections and lines in any order; of loads, springs and points it has a meaning. */
static int change_order(deck_lines *d)
{
    int i, k;

    for (i = d->n - 1; i > 1; i--) {
        deck_block *one = &d->block[i], *other = &d->block[1 + one_of(i)];

        if (!flk_section_table[one->section].repeats &&
            !flk_section_table[other->section].repeats) {
            static deck_block kept;

            kept = *one;
            *one = *other;
            *other = kept;
        }
    }
    for (i = 0; i < d->n; i++)
        for (k = d->block[i].n - 1; k > 0; k--) {
            deck_line *one = &d->block[i].line[k], *other = &d->block[i].line[one_of(k + 1)],
                      kept = *one;

            *one = *other;
            *other = kept;
        }
    return 1;
}

static int any_deck(deck_lines *d)
{
    (void)d;
    return 1;
}

static int leave_as_it_is(deck_lines *d)
{
    return !is_task(d);
}

/* As the library writes it, with a number set, which is also set in the deck that it is compared with. */
static void write_back(void)
{
    fourlink_results *r = opened(base_text, NULL);
    const fourlink_value *list, *input;
    unsigned long size, n;

    if (!r)
        return;
    fourlink_results_list(r, FOURLINK_INPUTS, &list, &n);
    input = &list[one_of((int)n)];
    snprintf(number_set, sizeof number_set, "%s", input->line_unit ? input->name : "");
    if (input->line_unit && fourlink_results_input(r, number_set, &value_set) == FOURLINK_OK)
        value_set.value *= between(0.9, 1.1);
    if (!*number_set || fourlink_results_set(r, number_set, value_set.value, NULL) != FOURLINK_OK)
        *number_set = '\0';
    if (fourlink_deck_write(fourlink_results_deck(r), changed_text, sizeof changed_text, &size) !=
            FOURLINK_OK ||
        size >= sizeof changed_text)
        fail("it is not written");
    fourlink_results_free(r);
}

/* --------------------------------------------------------------------------------------- time reversed */

static int pieces, holds;

/* Without what knows the direction of time, a motion over a number of intervals, forwards or backwards. */
static void set_motion(deck_lines *d, double from, double to, double speed, double acceleration)
{
    char value[100];
    const char *cycle =
        find_line(d, KEY_MOTION_CYCLE) ? find_line(d, KEY_MOTION_CYCLE)->value : NULL;
    char kept[LONG_VALUE];

    snprintf(kept, sizeof kept, "%s", cycle ? cycle : "");
    drop_sections(d, SECTION_MOTION);
#define SET(key, unit_name, x)                            \
    snprintf(value, sizeof value, "%.17g " unit_name, x); \
    set_line(d, KEY_MOTION_##key, value)
    SET(FROM, "deg", from);
    SET(TO, "deg", to);
    SET(INTERVAL, "deg", fabs(to - from) / pieces);
    SET(SPEED, "rad/s", speed);
    SET(ACCELERATION, "rad/s2", acceleration);
#undef SET
    if (holds)
        set_line(d, KEY_MOTION_HOLD, "yes");
    if (atof(kept) * (strstr(kept, "rad")   ? 180 / PI
                      : strstr(kept, "rev") ? 360
                                            : 1) >=
        fabs(to - from) / pieces)
        set_line(d, KEY_MOTION_CYCLE, kept);
}

/* Without motors, dampers and loads over a speed. */
static void drop_what_knows_time(void)
{
    int i;

    drop_sections(&base, SECTION_MOTOR);
    for (i = 0; i < base.n; i++) {
        deck_block *b = &base.block[i];
        const char *over = value_of(b, KEY_LOAD_OVER, "");

        drop_key(b, KEY_SPRING_DAMPING);
        drop_key(b, KEY_FLYWHEEL_EXACT);
        if ((b->section == SECTION_SPRING && !line_of(b, KEY_SPRING_STIFFNESS)) ||
            strncmp(over, "omega", 5) == 0 || is_one_of(over, " v slide_v "))
            b->section = SECTION_COUNT;
    }
    drop_sections(&base, SECTION_COUNT);
}

static int reverse_time(deck_lines *d)
{
    double from = seldom(0.5) ? 0 : 7.0 * between_whole(-50, 50),
           to = from + 5.0 * between_whole(1, 200);
    double speed = power_of_ten(0, 2),
           acceleration = seldom(0.5) ? 0 : speed * speed * between(-0.3, 1), end;
    int i;

    if (is_task(d))
        return 0;
    pieces = between_whole(1, 60);
    holds = seldom(0.3);
    if (!holds && speed * speed + 2 * acceleration * (to - from) * PI / 180 < 0.1)
        acceleration = -acceleration;
    end = holds ? speed : sqrt(speed * speed + 2 * acceleration * (to - from) * PI / 180);
    drop_sections(&base, SECTION_FRICTION);
    drop_what_knows_time();
    for (i = 0; i < base.n; i++) {
        if (line_of(&base.block[i], KEY_LOAD_BACK))
            base.block[i].section = SECTION_COUNT;
        drop_key(&base.block[i],
                 KEY_LOAD_FROM); /* in a row at an edge it matters where the crank comes from */
        drop_key(&base.block[i], KEY_LOAD_TO);
    }
    drop_sections(&base, SECTION_COUNT);
    *d = base;
    set_motion(&base, from, to, speed, acceleration);
    set_motion(d, to, from, -end, acceleration);
    return 1;
}

static double factor_reversed(const fourlink_value *of)
{
    if (ends_in(of->name, ".v") && strncmp(of->meaning, "speed of", 8) == 0)
        return 1; /* the size of a velocity, not that of an output along its line */
    return flk_quantities[flk_quantity_find(of->quantity)].dim.s % 2 ? -1 : 1;
}

#endif
