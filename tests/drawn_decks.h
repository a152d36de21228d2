/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drawn_decks.h - a deck by lengths as one by the places of its pins, drawn at some crank angle, turned and moved on the
** page.
*/
#ifndef DRAWN_DECKS_H
#define DRAWN_DECKS_H

#include "changed_decks.h"

#define CLEAR 0.3    /* rad, of the transmission angle where it is drawn */
#define TRIES 100    /* crank angles */
#define FARTHEST 1.0 /* times the size of the drawing, that it is moved */

static double drawn_at, turned;
static int is_rough; /* 1: the lengths stay, and the places are near those of the pins */
static fourlink_branch drawn_branch;

/* A point of the ground's frame on the page. */
static fourlink_vector moved;
static double drawn_size; /* m */

static fourlink_vector on_page(fourlink_vector u)
{
    fourlink_vector v;

    v.x = moved.x + cos(turned) * u.x - sin(turned) * u.y;
    v.y = moved.y + sin(turned) * u.x + cos(turned) * u.y;
    return v;
}

static void set_place(deck_lines *d, key_code key, fourlink_vector u)
{
    char value[100];

    if (seldom(0.8))
        snprintf(value, sizeof value, "(%.17g, %.17g) mm", 1e3 * u.x, 1e3 * u.y);
    else
        snprintf(value, sizeof value, "%.17g m at %.17g rad", hypot(u.x, u.y), atan2(u.y, u.x));
    set_line(d, key, value);
}

static void set_guide(deck_lines *d, double offset)
{
    fourlink_vector u[2];
    char value[200];

    u[0].x = -between(0.2, 2) * drawn_size;
    u[1].x = between(0.2, 2) * drawn_size;
    u[0].y = u[1].y = offset;
    u[0] = on_page(u[0]);
    u[1] = on_page(u[1]);
    snprintf(value, sizeof value, "(%.17g, %.17g), (%.17g, %.17g) mm", 1e3 * u[0].x, 1e3 * u[0].y,
             1e3 * u[1].x, 1e3 * u[1].y);
    set_line(d, KEY_PINS_GUIDE, value);
}

/* A place of a pin: where it is or, drawn roughly, anywhere near it; along a line if it is to be on it. */
#define ROUGH 0.05 /* of the shortest link */

static fourlink_vector near_place(fourlink_vector u, const fourlink_vector *along, double shortest)
{
    double by = ROUGH * shortest * between(-1, 1);

    if (!is_rough)
        return u;
    u.x += along ? by * along->x : by;
    u.y += along ? by * along->y : ROUGH * shortest * between(-1, 1);
    return u;
}

/* A position that is clear of dead ones; a piston is on the side of x, and B beyond C on
** a slide, by which the drawing tells their directions. */
static int find_drawn(const fourlink_mechanism *m, int has_own_slide, fourlink_state *at)
{
    fourlink_crank crank = {0, 0, 0};
    int i;

    drawn_branch = m->design.kind == FOURLINK_SCOTCH_YOKE || has_own_slide || seldom(0.5)
                       ? FOURLINK_OPEN
                       : FOURLINK_CROSSED;
    for (i = 0; i < TRIES; i++) {
        crank.theta2 = drawn_at = between(-PI, PI);
        if (fourlink_analyse(m, drawn_branch, &crank, NULL, 0, at, NULL) == FOURLINK_OK &&
            at->mu > CLEAR && !(m->design.n_groups && at->group_sine < CLEAR) &&
            (m->design.kind != FOURLINK_SLIDER_CRANK ||
             at->link[4].origin.x > 0.01 * m->design.link[2].length) &&
            (m->design.kind != FOURLINK_INVERTED_SLIDER_CRANK ||
             at->slide > 0.01 * m->design.link[2].length))
            return 1;
    }
    return 0;
}

/* A point of a link, as drawn, in place of a key that has it on the link. */
static void set_drawn(deck_block *b, key_code on_link, key_code key, const fourlink_state *drawn,
                      int link, fourlink_vector at)
{
    deck_line *line = line_of(b, on_link);
    fourlink_vector place = at;

    if (!line || seldom(0.4))
        return;
    if (link != FOURLINK_GROUND)
        fourlink_point(drawn, link, &at, &place, NULL, NULL);
    place = on_page(place);
    drop_key(b, on_link);
    line = add_line(b, flk_key_table[key].name, "");
    snprintf(line->value, sizeof line->value, "(%.17g, %.17g) mm", 1e3 * place.x, 1e3 * place.y);
}

/* Points of outputs and their centres of mass by their places. */
static void set_drawn_output(deck_block *b, const fourlink_state *drawn, const fourlink_group *g,
                             int i)
{
    set_drawn(b, KEY_OUTPUT_AT, KEY_OUTPUT_PLACE, drawn, g->link, g->at);
    if (g->to)
        set_drawn(b, KEY_OUTPUT_TO_AT, KEY_OUTPUT_TO_PLACE, drawn, g->to, g->pivot);
    set_drawn(b, KEY_OUTPUT_ROD_CG, KEY_OUTPUT_ROD_CG_PLACE, drawn, FOURLINK_ROD_OF(i),
              g->body[0].cg);
    set_drawn(b, KEY_OUTPUT_END_CG, KEY_OUTPUT_END_CG_PLACE, drawn, FOURLINK_END_OF(i),
              g->body[1].cg);
}

/* A point of a link of an output, by its place on the link, and as drawn. */
static void add_drawn_point(deck_lines *d, const fourlink_state *drawn, const char *name, int link)
{
    deck_lines *decks[2];
    char header[40], value[100];
    fourlink_vector at;
    int i;

    at.x = between(-1, 1) * drawn_size;
    at.y = between(-1, 1) * drawn_size;
    snprintf(header, sizeof header, "[point D%d]", link);
    snprintf(value, sizeof value, "(%.17g, %.17g) m", at.x, at.y);
    decks[0] = &base;
    decks[1] = d;
    for (i = 0; i < 2; i++) {
        deck_block *b = add_block(decks[i], header);

        add_line(b, "link", name);
        add_line(b, "at", value);
    }
    set_drawn(&d->block[d->n - 1], KEY_POINT_AT, KEY_POINT_PLACE, drawn, link, at);
}

/* Points of loads, springs, tracers and outputs, and centres of mass, by their places. */
static void set_drawn_points(deck_lines *d, const fourlink_deck *deck, const fourlink_state *drawn)
{
    static fourlink_load loads[200];
    fourlink_problem problem;
    unsigned long n[3] = {0, 0, 0};
    int n_blocks = d->n, n_outputs = 0;
    fourlink_spring spring;
    fourlink_vector at;
    int i, link, k;

    fourlink_deck_problem(deck, &problem);
    if (problem.n_loads <= 200)
        fourlink_deck_loads(deck, drawn_branch, drawn_at, loads, NULL);
    for (i = 0; i < n_blocks; i++) {
        deck_block *b = &d->block[i];

        if (b->section == SECTION_POINT) {
            fourlink_deck_point(deck, n[0]++, NULL, &link, &at);
            set_drawn(b, KEY_POINT_AT, KEY_POINT_PLACE, drawn, link, at);
        } else if (b->section == SECTION_SPRING) {
            fourlink_deck_spring(deck, n[1]++, NULL, &spring);
            set_drawn(b, KEY_SPRING_AT, KEY_SPRING_PLACE, drawn, spring.link, spring.at);
            set_drawn(b, KEY_SPRING_TO_AT, KEY_SPRING_TO_PLACE, drawn, spring.to, spring.to_at);
        } else if (b->section == SECTION_LOAD && problem.n_loads <= 200) {
            if (loads[n[2]].force.x != 0 ||
                loads[n[2]].force.y != 0) /* one that is off has no place */
                set_drawn(b, KEY_LOAD_AT, KEY_LOAD_PLACE, drawn, loads[n[2]].link, loads[n[2]].at);
            n[2]++;
        } else if (b->section == SECTION_OUTPUT) {
            const fourlink_group *g = &problem.mechanism.design.group[n_outputs];

            set_drawn_output(b, drawn, g, n_outputs);
            for (k = FOURLINK_ROD_OF(n_outputs) + (g->hang != FOURLINK_HANGS_BY_ROD);
                 k <= FOURLINK_END_OF(n_outputs); k++)
                add_drawn_point(d, drawn, fourlink_deck_link_text(deck, k), k);
            n_outputs++;
        }
        for (k = FOURLINK_CRANK; k <= FOURLINK_FOLLOWER; k++)
            if (b->section == flk_section_of_link(problem.mechanism.design.kind, k) &&
                flk_find_key(b->section, flk_text_of("cg")) != KEY_COUNT &&
                !find_block(d, SECTION_BALANCE))
                set_drawn(b, flk_find_key(b->section, flk_text_of("cg")),
                          flk_find_key(b->section, flk_text_of("cg_place")), drawn, k,
                          problem.mechanism.design.link[k].cg);
    }
}

/* The deck in the axes of the page, with the ground turned as on it, and the same by pins.  With lengths of very
** different sizes the places have too few digits for the shortest. */
static int draw_pins(deck_lines *d)
{
    static const double turns[] = {0, 37 * PI / 180, -120 * PI / 180, PI};
    static const key_code lengths[] = {KEY_CRANK_LENGTH,  KEY_CRANK_STROKE, KEY_COUPLER_LENGTH,
                                       KEY_ROCKER_LENGTH, KEY_ROD_LENGTH,   KEY_GROUND_LENGTH,
                                       KEY_GROUND_OFFSET, KEY_GROUND_ANGLE};
    fourlink_results *r;
    fourlink_vector tip = {0, 0}, ground = {1, 0};
    fourlink_problem problem;
    const fourlink_link *link;
    fourlink_mistake mistake;
    fourlink_state drawn;
    char value[100];
    int i, k, has_own_slide, is_line;
    double shortest;

    write_lines(&base, base_text, sizeof base_text);
    r = is_task(d) || has_pins(d) ? NULL : opened(base_text, NULL);
    if (!r)
        return 0;
    problem = problem_of(r);
    link = problem.mechanism.design.link;
    has_own_slide = kind == FOURLINK_INVERTED_SLIDER_CRANK && !(link[4].length > 0);
    if (!find_drawn(&problem.mechanism, has_own_slide, &drawn)) {
        fourlink_results_free(r);
        return 0;
    }
    drawn_size = fmax(fmax(link[1].length, link[2].length), fmax(link[3].length, link[4].length));
    shortest = link[2].length;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        shortest = link[i].length > 0 ? fmin(shortest, link[i].length) : shortest;
    drawn_size = fmax(drawn_size, fabs(problem.mechanism.design.offset));
    is_rough = fmod(fabs(drawn_at), 0.1) < 0.03; /* three in ten, by what is drawn already */
    if (kind == FOURLINK_SLIDER_CRANK && drawn.link[4].origin.x < 2 * ROUGH * shortest)
        is_rough = 0; /* C could be drawn on the other side of A, from which x would run */
    turned = seldom(0.5) ? turns[one_of(4)] : between(-PI, PI);
    moved.x = seldom(0.3) ? 0 : between(-FARTHEST, FARTHEST) * drawn_size;
    moved.y = seldom(0.3) ? 0 : between(-FARTHEST, FARTHEST) * drawn_size;
    snprintf(value, sizeof value, "%.17g rad", turned);
    set_line(&base, KEY_GROUND_ANGLE, value);
    set_line(&base, KEY_TABLE_BRANCH, fourlink_branch_text(drawn_branch));
    *d = base;
    for (i = 0; i < d->n; i++)
        for (k = 0; k < (int)(sizeof lengths / sizeof *lengths); k++)
            if (flk_key_table[lengths[k]].section == d->block[i].section &&
                (!is_rough || lengths[k] == KEY_GROUND_ANGLE))
                drop_key(&d->block[i], lengths[k]);
    set_drawn_points(d, fourlink_results_deck(r), &drawn);
    fourlink_results_free(r);
    drop_key(find_block(d, SECTION_TABLE), KEY_TABLE_BRANCH);
    if (kind == FOURLINK_INVERTED_SLIDER_CRANK && !has_own_slide && !is_rough) {
        drop_key(find_block(d, SECTION_LEVER), KEY_LEVER_LENGTH);
        drop_key(find_block(d, SECTION_LEVER), KEY_LEVER_ANGLE);
    }
    drop_key(find_block(d, SECTION_TOP), KEY_TOP_AXES);
    set_place(d, KEY_PINS_A, on_page(tip));
    set_place(d, KEY_PINS_B,
              on_page(near_place(drawn.link[3].origin, &drawn.link[2].axis, shortest)));
    tip = drawn.link[4].origin;
    if (kind != FOURLINK_SLIDER_CRANK && kind != FOURLINK_SCOTCH_YOKE) {
        set_place(d, KEY_PINS_D, on_page(near_place(tip, &ground, shortest)));
        tip.x += link[4].length * drawn.link[4].axis.x;
        tip.y += link[4].length * drawn.link[4].axis.y;
    }
    if (kind != FOURLINK_SCOTCH_YOKE && !has_own_slide)
        set_place(
            d, KEY_PINS_C,
            on_page(near_place(tip, kind == FOURLINK_SLIDER_CRANK ? &ground : NULL, shortest)));
    if (is_rough)
        set_line(d, KEY_PINS_ROUGH, "yes");
    if (is_rough && kind == FOURLINK_SLIDER_CRANK) {
        snprintf(value, sizeof value, "%.17g m", problem.mechanism.design.offset);
        set_line(d, KEY_GROUND_OFFSET, value);
        snprintf(value, sizeof value, "%.17g rad", turned);
    }
    is_line = kind == FOURLINK_SCOTCH_YOKE || seldom(0.5);
    if ((kind == FOURLINK_SLIDER_CRANK || kind == FOURLINK_SCOTCH_YOKE) && is_line)
        set_guide(d, problem.mechanism.design.offset);
    else if (kind == FOURLINK_SLIDER_CRANK)
        set_line(d, KEY_GROUND_ANGLE, value);
    write_lines(&base, base_text, sizeof base_text);
    r = open_deck(base_text, NULL, &mistake); /* an input may have no value on this branch alone */
    fourlink_results_free(r);
    return r != NULL;
}

/* With places in the axes of link 1. */
static int draw_in_own_axes(deck_lines *d)
{
    int is_drawn = draw_pins(d);

    if (is_drawn)
        set_line(d, KEY_TOP_AXES, "ground");
    return is_drawn;
}

/* --------------------------------------------------------------------------------- in the axes of the page */

static int is_bare_force;

static void add_turn(deck_number *n)
{
    unit u;
    text bad;

    flk_unit_read(flk_text_of(n->unit_name[0] ? n->unit_name : "deg"), &u, &bad);
    n->value += flk_unit_from_si(turned, u);
}

static void find_bare(deck_number *n, const deck_line *line, const void *how)
{
    (void)line;
    (void)how;
    is_bare_force |=
        n->part == WHOLE && flk_dimension_equal(n->dim, flk_quantities[QUANTITY_FORCE].dim);
}

static void number_on_page(deck_number *n, const deck_line *line, const void *how)
{
    const deck_block *b = how;
    double x = n->value;
    int is_force = line->key == KEY_LOAD_FORCE ||
                   (line->key == KEY_LOAD_BACK && line_of((deck_block *)b, KEY_LOAD_FORCE));
    int turns =
        is_force && !is_bare_force && strcmp(value_of(b, KEY_LOAD_FRAME, "ground"), "ground") == 0;

    if (line->key >= KEY_COUNT)
        return;
    if (flk_key_table[line->key].form == FORM_CRANK ||
        (line->key == KEY_MOTION_PROGRAM &&
         flk_dimension_equal(n->dim, flk_quantities[QUANTITY_ANGLE].dim)) ||
        (n->part == ARGUMENT && b->section == SECTION_LOAD &&
         strncmp(value_of(b, KEY_LOAD_OVER, "theta2"), "theta", 5) == 0) ||
        (turns && n->part == POLAR))
        add_turn(n);
    else if (turns && n->part == COMPONENT_X) {
        n[0].value = cos(turned) * x - sin(turned) * n[1].value;
        n[1].value = sin(turned) * x + cos(turned) * n[1].value;
    }
}

/* The ends of springs on the ground, in the axes of link 1 in one deck and of the page in the other. */
static void set_ground_ends(deck_lines *d)
{
    static const key_code keys[2][2] = {{KEY_SPRING_LINK, KEY_SPRING_AT},
                                        {KEY_SPRING_TO, KEY_SPRING_TO_AT}};
    fourlink_results *r = opened(base_text, NULL);
    fourlink_spring spring;
    unsigned long n = 0;
    int i, k;

    for (i = 0; r && i < base.n; i++) {
        if (base.block[i].section != SECTION_SPRING)
            continue;
        fourlink_deck_spring(fourlink_results_deck(r), n++, NULL, &spring);
        for (k = 0; k < 2; k++) {
            fourlink_vector at = k ? spring.to_at : spring.at;
            int j;

            if (!line_of(&base.block[i], keys[k][1]) ||
                strcmp(value_of(&base.block[i], keys[k][0], ""), "ground") != 0)
                continue;
            snprintf(line_of(&base.block[i], keys[k][1])->value, LONG_VALUE, "(%.17g, %.17g) m",
                     at.x, at.y);
            at = on_page(at);
            for (j = 0; j < d->n; j++)
                if (strcmp(d->block[j].header, base.block[i].header) == 0 &&
                    line_of(&d->block[j], keys[k][1]))
                    snprintf(line_of(&d->block[j], keys[k][1])->value, LONG_VALUE,
                             "(%.17g, %.17g) m", at.x, at.y);
        }
    }
    fourlink_results_free(r);
}

/* A value of the block of this header, if it has the key. */
static void set_of(deck_lines *d, const char *header, key_code key, const char *format, double x,
                   double y)
{
    int j;

    for (j = 0; j < d->n; j++)
        if (strcmp(d->block[j].header, header) == 0 && line_of(&d->block[j], key))
            snprintf(line_of(&d->block[j], key)->value, LONG_VALUE, format, x, y);
}

/* The same of the lines of stroke and the fixed pins of outputs. */
static void set_outputs(deck_lines *d)
{
    static const char place[] = "(%.17g, %.17g) m", in_rad[] = "%.17g rad";
    fourlink_results *r = opened(base_text, NULL);
    const fourlink_group *g = r ? problem_of(r).mechanism.design.group : NULL;
    int i;

    for (i = 0; g && i < base.n; i++) {
        const char *header = base.block[i].header;
        fourlink_vector at;
        double direction;

        if (base.block[i].section != SECTION_OUTPUT)
            continue;
        at = on_page(g->pivot);
        direction = atan2(g->direction.y, g->direction.x);
        set_of(&base, header, KEY_OUTPUT_LINE, place, g->pivot.x, g->pivot.y);
        set_of(&base, header, KEY_OUTPUT_PIVOT, place, g->pivot.x, g->pivot.y);
        set_of(&base, header, KEY_OUTPUT_ANGLE, in_rad, direction, 0);
        set_of(d, header, KEY_OUTPUT_LINE, place, at.x, at.y);
        set_of(d, header, KEY_OUTPUT_PIVOT, place, at.x, at.y);
        set_of(d, header, KEY_OUTPUT_ANGLE, in_rad, direction + turned, 0);
        g++;
    }
    fourlink_results_free(r);
}

/* By pins, or by lengths on a page whose origin is A. */
static int put_on_page(deck_lines *d)
{
    char value[100];
    int i, k;

    if (is_task(d) || has_pins(d) || find_line(d, KEY_MOTION_ROWS))
        return 0;
    if (!find_line(d, KEY_MOTION_AT) && !find_line(d, KEY_MOTION_PROGRAM) &&
        strcmp(value_of(find_block(d, SECTION_MOTION), KEY_MOTION_INPUT, "theta2"), "theta2") == 0)
        set_default(&base, KEY_MOTION_FROM, "0 deg");
    for (i = 0; i < base.n; i++) {
        deck_block *b = &base.block[i];

        if (line_of(b, KEY_LOAD_FROM) && !line_of(b, KEY_LOAD_TO))
            add_line(b, "to",
                     find_line(&base, KEY_MOTION_CYCLE) ? find_line(&base, KEY_MOTION_CYCLE)->value
                                                        : "360 deg");
        if (line_of(b, KEY_LOAD_TO) && !line_of(b, KEY_LOAD_FROM))
            add_line(b, "from", "0 deg");
    }
    if (seldom(0.5)) {
        *d = base;
        if (!draw_pins(d))
            return 0;
    } else {
        turned = between(-PI, PI);
        moved.x = moved.y = 0;
        snprintf(value, sizeof value, "%.17g rad", turned);
        set_line(&base, KEY_GROUND_ANGLE, value);
        *d = base;
        set_line(d, KEY_TOP_AXES, "page");
        write_lines(&base, base_text, sizeof base_text);
    }
    set_ground_ends(d);
    set_outputs(d);
    for (i = 0; i < d->n; i++)
        for (k = 0; k < d->block[i].n; k++) {
            deck_line *line = &d->block[i].line[k];

            is_bare_force = 0;
            if (!has_numbers(line) || line->key >= KEY_COUNT ||
                (d->block[i].section != SECTION_LOAD && d->block[i].section != SECTION_MOTION))
                continue;
            change_line(line, find_bare, NULL);
            change_line(line, number_on_page, &d->block[i]);
        }
    return 1;
}

/* The column of the other component, x or y, of a vector; -1 if a column is none. */
static int other_component(const columns *c, int j, char own, char other)
{
    char name[100];
    size_t n = strlen(c->list[j].told->name);

    snprintf(name, sizeof name, "%s", c->list[j].told->name);
    if (n < 2 || name[n - 1] != own || ends_in(name, "_x"))
        return -1;
    name[n - 1] = other;
    return find_column(c, name);
}

static int is_direction(const char *name)
{
    return is_one_of(name, " theta2 theta3 theta4 ") || ends_in(name, "_dir") ||
           ends_in(name, ".theta") || ends_in(name, ".rod_theta");
}

/* A row of the page in the axes of link 1, in the units of its columns. */
static void turn_row(const columns *c, double *row)
{
    int j, k;

    for (j = 0; j < c->n; j++) {
        const fourlink_value *told = c->list[j].told;
        double x = row[j], y, origin_x = 0, origin_y = 0;

        if (is_direction(told->name))
            row[j] -= turned / told->to_si;
        k = other_component(c, j, 'x', 'y');
        if (k < 0)
            continue;
        if (c->list[j].q == QUANTITY_LENGTH) {
            origin_x = moved.x / told->to_si;
            origin_y = moved.y / told->to_si;
        }
        x -= origin_x;
        y = row[k] - origin_y;
        if (isnan(x) || isnan(y)) { /* a centre at infinity */
            row[j] = row[k] = NAN;
            continue;
        }
        row[j] = cos(turned) * x + sin(turned) * y;
        row[k] = cos(turned) * y - sin(turned) * x;
    }
}

#endif
