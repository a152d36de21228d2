/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_kind.c - the table of kinds as callers see it: names, sliders, the nine unknowns; and the angles
** of links, for every kind.
*/
#include "samples.h"

TEST(test_names)
{
    static const int kinds[3] = {FOURLINK_FOUR_BAR, FOURLINK_SLIDER_CRANK,
                                 FOURLINK_INVERTED_SLIDER_CRANK};
    static const char *const links[3][5] = {{"", "ground", "crank", "coupler", "rocker"},
                                            {"", "ground", "crank", "rod", "piston"},
                                            {"", "ground", "crank", "slider", "lever"}};
    static const char *const forces[3][9] = {
        {"F12x", "F12y", "F23x", "F23y", "F34x", "F34y", "F14x", "F14y", "Ts"},
        {"F12x", "F12y", "F23x", "F23y", "F34x", "F34y", "M14", "N", "Ts"},
        {"F12x", "F12y", "F23x", "F23y", "M34", "N34", "F14x", "F14y", "Ts"}};
    static const int none[] = {-1, 0, 3};
    int kind, i, k;

    assert_string_equal(fourlink_kind_text(FOURLINK_INVERTED_SLIDER_CRANK),
                        "inverted slider-crank");
    assert_string_equal(fourlink_kind_text(FOURLINK_FOUR_BAR), "four-bar linkage");
    assert_string_equal(fourlink_kind_text(FOURLINK_SLIDER_CRANK), "slider-crank");
    for (k = 0; k < 3; k++) {
        kind = kinds[k];
        for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
            assert_string_equal(fourlink_link_text(kind, i), links[k][i]);
        for (i = 0; i < 9; i++)
            assert_string_equal(fourlink_unknown_text(kind, i), forces[k][i]);
        assert_string_equal(fourlink_link_text(kind, 0), "unknown link");
        assert_string_equal(fourlink_link_text(kind, 5), "unknown link");
        assert_string_equal(fourlink_unknown_text(kind, -1), "unknown");
        assert_string_equal(fourlink_unknown_text(kind, 9), "unknown");
    }
    for (i = 0; i < 3; i++) {
        kind = none[i];
        assert_string_equal(fourlink_kind_text(kind), "unknown kind");
        assert_string_equal(fourlink_link_text(kind, FOURLINK_CRANK), "unknown link");
        assert_string_equal(fourlink_unknown_text(kind, 0), "unknown");
        assert_int_equal(fourlink_slides(kind, FOURLINK_FOLLOWER), 0);
    }
}

/* The piston slides along the ground, the slider along the lever, and no other link. */
TEST(test_sliders)
{
    int link;

    for (link = -1; link <= 6; link++) {
        assert_int_equal(fourlink_slides(FOURLINK_FOUR_BAR, link), 0);
        assert_int_equal(fourlink_slides(FOURLINK_SLIDER_CRANK, link),
                         link == FOURLINK_FOLLOWER ? FOURLINK_GROUND : 0);
        assert_int_equal(fourlink_slides(FOURLINK_INVERTED_SLIDER_CRANK, link),
                         link == FOURLINK_COUPLER ? FOURLINK_FOLLOWER : 0);
    }
}

/* The record of a kind agrees with the functions that ask for one thing. */
TEST(test_facts)
{
    static const struct {
        int kind;
        const char *name, *letters, *bearings; /* of the joints; p: a pin, s: a slider */
        const char *shapes, *drawn; /* of the moving links: bar, piston or slider, lever, yoke */
        int guided, slotted;
    } cases[] = {{FOURLINK_FOUR_BAR, "four-bar", "ABCD", "pppp", "bbb", "342", 0, 0},
                 {FOURLINK_SLIDER_CRANK, "slider-crank", "ABCC", "ppps", "bbp", "342", 4, 0},
                 {FOURLINK_INVERTED_SLIDER_CRANK, "inverted-slider-crank", "ABBD", "ppsp", "bpl",
                  "432", 0, 4},
                 {FOURLINK_SCOTCH_YOKE, "scotch-yoke", "ABBC", "ppss", "bpy", "432", 4, 4}};
    static const int links[4][2] = {{1, 2}, {2, 3}, {3, 4}, {1, 4}};
    fourlink_kind_facts facts, before;
    size_t k;
    int i;

    for (k = 0; k < COUNT(cases); k++) {
        int kind = cases[k].kind;

        memset(&facts, 0, sizeof facts); /* its padding too, which is compared below */
        assert_int_equal(fourlink_kind_of(kind, &facts), FOURLINK_OK);
        assert_int_equal(facts.kind, kind);
        assert_string_equal(facts.name, cases[k].name);
        assert_string_equal(facts.words, fourlink_kind_text(kind));
        assert_int_equal(facts.guided, cases[k].guided);
        assert_int_equal(facts.slotted, cases[k].slotted);
        assert_string_equal(facts.link[0], "");
        for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
            assert_string_equal(facts.link[i], fourlink_link_text(kind, i));
            assert_int_equal(facts.slides_on[i], fourlink_slides(kind, i));
        }
        for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++) {
            const fourlink_joint *first = &facts.joint[facts.begins[i]];

            assert_int_equal("?bply"[facts.shape[i]], cases[k].shapes[i - FOURLINK_CRANK]);
            assert_int_equal('0' + facts.drawn[i - FOURLINK_CRANK],
                             cases[k].drawn[i - FOURLINK_CRANK]);
            assert_int_equal(first->at, i);
            assert_false(first->is_tip);
            assert_true(first->from == i || first->on == i);
            /* what slides is drawn as a block, and what it slides on has the slot or is the ground */
            assert_int_equal(facts.shape[i] == FOURLINK_SHAPE_BLOCK ||
                                 facts.shape[i] == FOURLINK_SHAPE_YOKE,
                             facts.slides_on[i] != 0);
            assert_int_equal(facts.slides_on[i] == FOURLINK_GROUND, facts.guided == i);
            assert_int_equal(facts.shape[i] == FOURLINK_SHAPE_LEVER ||
                                 facts.shape[i] == FOURLINK_SHAPE_YOKE,
                             facts.slotted == i);
        }
        for (i = 0; i < 4; i++) {
            const fourlink_joint *joint = &facts.joint[i];

            assert_int_equal(joint->letter[0], cases[k].letters[i]);
            assert_int_equal(joint->from, links[i][0]);
            assert_int_equal(joint->on, links[i][1]);
            assert_int_equal(joint->slider != 0, cases[k].bearings[i] == 's');
            if (joint->slider) {
                assert_int_equal(joint->at, joint->slider);
                assert_int_equal(joint->from + joint->on,
                                 joint->slider + facts.slides_on[joint->slider]);
            }
        }
    }
    memcpy(&before, &facts, sizeof facts);
    assert_int_equal(fourlink_kind_of(3, &facts), FOURLINK_BAD_KIND);
    assert_int_equal(fourlink_kind_of(FOURLINK_FOUR_BAR, NULL), FOURLINK_NULL);
    assert_memory_equal(&facts, &before, sizeof facts);
}

/* Draw until the links reach, and not too near a dead position. */
static void draw(uint64_t *seed, int n, sample *s)
{
    do
        draw_design(seed, n, s);
    while (fourlink_prepare(&s->design, &s->mechanism) != FOURLINK_OK ||
           fourlink_analyse(&s->mechanism, s->branch, &s->crank, s->load, s->n_loads, &s->state,
                            &s->forces) != FOURLINK_OK ||
           fabs(s->state.sine) < 0.1);
}

/* The joints of a drawn position are where the record says, on both links. */
TEST(test_places_of_joints)
{
    uint64_t seed = 3;
    sample s;
    int n, i;

    for (n = 0; n < 300; n++) {
        fourlink_kind_facts facts;

        draw(&seed, n, &s);
        assert_int_equal(fourlink_kind_of((int)s.design.kind, &facts), FOURLINK_OK);
        for (i = 0; i < 4; i++) {
            const fourlink_joint *joint = &facts.joint[i];
            const fourlink_link_state *on = &s.state.link[joint->on];
            fourlink_vector tip = {0, 0}, at;

            tip.x = joint->is_tip ? s.design.link[joint->at].length : 0;
            assert_int_equal(fourlink_point(&s.state, joint->at, &tip, &at, NULL, NULL),
                             FOURLINK_OK);
            if (joint->letter[0] == 'A')
                assert_true(at.x == 0 && at.y == 0);
            else if (joint->letter[0] == 'B')
                assert_true(
                    hypot(at.x - s.state.link[3].origin.x, at.y - s.state.link[3].origin.y) == 0);
            else if (joint->letter[0] == 'D' || joint->slider)
                assert_true(at.x == on->origin.x && at.y == on->origin.y);
        }
    }
}

/* The unknowns solve the system of their position. */
TEST(test_unknowns)
{
    uint64_t seed = 1;
    double A[9][9], b[9], x[9];
    sample s;
    int n, i, j;

    for (n = 0; n < 1000; n++) {
        draw(&seed, n, &s);
        assert_int_equal(fourlink_system(&s.mechanism, &s.state, s.load, s.n_loads, A, b),
                         FOURLINK_OK);
        assert_int_equal(fourlink_unknowns(&s.mechanism, &s.forces, x), FOURLINK_OK);
        for (i = 0; i < 9; i++) {
            double left = 0, size = fabs(b[i]);

            for (j = 0; j < 9; j++) {
                left += A[i][j] * x[j];
                size += fabs(A[i][j] * x[j]);
            }
            assert_near(left, b[i], 1e-13 * size + 1e-12);
        }
    }
    assert_int_equal(fourlink_unknowns(NULL, &s.forces, x), FOURLINK_NULL);
    assert_int_equal(fourlink_unknowns(&s.mechanism, NULL, x), FOURLINK_NULL);
    assert_int_equal(fourlink_unknowns(&s.mechanism, &s.forces, NULL), FOURLINK_NULL);
}

/* Links turn fully, and their angles are those of their axes. */
TEST(test_angles)
{
    uint64_t seed = 2;
    sample s;
    int n, i;

    for (n = 0; n < 100000; n++) {
        draw(&seed, n, &s);
        for (i = FOURLINK_COUPLER; i <= FOURLINK_FOLLOWER; i++) {
            const fourlink_link_state *link = &s.state.link[i];

            if (fabs(link->axis.y) >= 4e-16)
                assert_near(link->theta, atan2(link->axis.y, link->axis.x), 8e-16);
        }
    }
}

/* A rod that is at 180 deg but for rounding is at 180 deg, not at -180. */
TEST(test_half_turn)
{
    static const struct {
        double slope, open, crossed;
    } rods[] = {{0, 0, PI}, {-0.0, 0, PI}, {3e-16, 0, PI}, {-3e-16, 0, PI}, {-5e-16, 0, -PI}};
    fourlink_mechanism mechanism;
    fourlink_design design;
    fourlink_state state;
    size_t i;

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_SLIDER_CRANK;
    design.link[FOURLINK_CRANK].length = 0.25;
    design.link[FOURLINK_COUPLER].length = 1;
    for (i = 0; i < COUNT(rods); i++) {
        design.offset = rods[i].slope;
        assert_int_equal(fourlink_prepare(&design, &mechanism), FOURLINK_OK);
        assert_int_equal(fourlink_position(&mechanism, FOURLINK_OPEN, 0, &state), FOURLINK_OK);
        assert_near(state.link[3].theta, rods[i].open, 1e-15);
        assert_int_equal(fourlink_position(&mechanism, FOURLINK_CROSSED, 0, &state), FOURLINK_OK);
        assert_near(state.link[3].theta, rods[i].crossed, 1e-15);
        assert_true(state.link[4].theta == 0);
    }
}

/* A mechanism that was not prepared. */
TEST(test_not_prepared)
{
    uint64_t seed = 3;
    double A[9][9], b[9];
    fourlink_mechanism none;
    fourlink_type type;
    fourlink_reach reach;
    fourlink_limits limits;
    sample s;

    draw(&seed, 0, &s);
    memset(&none, 0, sizeof none);
    assert_int_equal(fourlink_type_of(&none, &type), FOURLINK_BAD_KIND);
    assert_int_equal(fourlink_reach_of(&none, &reach), FOURLINK_BAD_KIND);
    assert_int_equal(fourlink_limits_of(&none, FOURLINK_OPEN, &limits), FOURLINK_BAD_KIND);
    assert_int_equal(fourlink_velocity(&none, 1, &s.state), FOURLINK_BAD_KIND);
    assert_int_equal(fourlink_acceleration(&none, 1, &s.state), FOURLINK_BAD_KIND);
    assert_int_equal(fourlink_solve(&none, &s.state, NULL, 0, &s.forces), FOURLINK_BAD_KIND);
    assert_int_equal(fourlink_solve_dyad(&none, &s.state, NULL, 0, &s.forces), FOURLINK_BAD_KIND);
    assert_int_equal(fourlink_system(&none, &s.state, NULL, 0, A, b), FOURLINK_BAD_KIND);
    assert_int_equal(fourlink_unknowns(&none, &s.forces, b), FOURLINK_BAD_KIND);
}

/* Every type belongs to one kind. */
TEST(test_types)
{
    static const int kinds[4] = {FOURLINK_FOUR_BAR, FOURLINK_SLIDER_CRANK,
                                 FOURLINK_INVERTED_SLIDER_CRANK, FOURLINK_SCOTCH_YOKE};
    int type, i, counts[4] = {0};

    for (type = -1; type < 40; type++) {
        int n = 0, is_known = strcmp(fourlink_type_text(type), "unknown type") != 0;

        for (i = 0; i < 4; i++) {
            counts[i] += fourlink_has_type(kinds[i], type);
            n += fourlink_has_type(kinds[i], type);
        }
        assert_int_equal(n, is_known);
        assert_int_equal(fourlink_has_type(0, type) + fourlink_has_type(99, type), 0);
    }
    assert_int_equal(counts[0], 9);
    assert_int_equal(counts[1], 3);
    assert_int_equal(counts[3], 1);
    assert_int_equal(counts[2], 4);
    assert_int_equal(fourlink_has_type(FOURLINK_SLIDER_CRANK, FOURLINK_ENGINE), 1);
    assert_int_equal(fourlink_has_type(FOURLINK_SLIDER_CRANK, FOURLINK_WHITWORTH), 0);
}

int main(void)
{
    return run_all_tests(NULL);
}
