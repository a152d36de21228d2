/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_scene.c - what is drawn of random machines: velocities and accelerations are the derivatives of places, polygons
** close, each link is in equilibrium.
**
** Derivatives are differences over a short time, by positions of the same motion before and after.
*/
#include "check.h"
#include "random_outputs.h"
#include "view/geometry.h"
#include "view/scene.h"

#define STEP 1e-4 /* of a radian, of the link that turns fastest */
#define CLOSE \
    2e-6 /* of the largest in a comparison: differences have an error of STEP^2 and rounding / STEP */

static view shown;
static fourlink_results *results;

/* ------------------------------------------------------------------------------------------ machines */

static void open_scene(long number, int with_outputs)
{
    fourlink_source source;
    fourlink_mistake mistake;

    if (with_outputs) {
        make_machine_with_outputs(number, (int)(number % 2));
        write(seldom(0.3) ? "drive = P\n" : "");
    } else {
        make_machine(number, EVERYTHING | (seldom(0.5) ? WILD : 0), GIVEN);
    }
    if (!with_outputs && seldom(0.3))
        write("[load P]\nlink = %s\nforce = (%.6g, %.6g) N\nat = (%.6g, 0) mm\n",
              machine_links[machine][2], between(-300, 300), between(-300, 300), between(-80, 80));
    memset(&source, 0, sizeof source);
    source.text = deck_text;
    source.length = length;
    if (fourlink_results_open(&source, 1, &results, &mistake, NULL) != FOURLINK_OK)
        fail_msg("line %ld: %s\n%s", mistake.line, mistake.message, deck_text);
    view_take(&shown, results);
}

/* ------------------------------------------------------------------------------------- derivatives */

enum { BEFORE, NOW, AFTER };
static tracks around[3];
static double step; /* s */

/* The numbers of an instant, and just before and after it. */
static void find_around(const fourlink_instant *now)
{
    const fourlink_crank *crank = &now->row.crank;
    int has_forces = shown.problem.has_forces, i;
    fourlink_instant at = *now;
    double fastest = 0;

    for (i = 2; i <= now->state.last; i++)
        fastest = fmax(fastest,
                       fmax(fabs(now->state.link[i].omega), sqrt(fabs(now->state.link[i].alpha))));
    step = STEP / fastest;
    shown.problem.has_forces = 0;
    for (i = BEFORE; i <= AFTER; i++) {
        double t = (i - NOW) * step, w = crank->omega2 + crank->alpha2 * t;

        at.row.crank.theta2 = crank->theta2 + (crank->omega2 + crank->alpha2 * t / 2) * t;
        at.status =
            fourlink_position(shown.mechanism, now->state.branch, at.row.crank.theta2, &at.state);
        if (at.status == FOURLINK_OK)
            at.status = fourlink_velocity(shown.mechanism, w, &at.state);
        if (at.status == FOURLINK_OK)
            at.status = fourlink_acceleration(shown.mechanism, crank->alpha2, &at.state);
        assert_int_equal(at.status, FOURLINK_OK);
        tracks_find(&around[i], &shown, &at, NULL);
    }
    shown.problem.has_forces = has_forces;
}

/* The fixed tracks by their names here: that of a place, with v or a before it its derivatives. */
static const struct {
    const char *name;
    int number;
} fixed[] = {{"A", TRACK_A},     {"B", TRACK_B},       {"C", TRACK_C},       {"D", TRACK_D},
             {"E1", TRACK_E1},   {"E2", TRACK_E2},     {"vB", TRACK_VB},     {"vC", TRACK_VC},
             {"vCB", TRACK_VCB}, {"vB4", TRACK_VB4},   {"vS", TRACK_VS},     {"aBn", TRACK_ABN},
             {"aBt", TRACK_ABT}, {"aCBn", TRACK_ACBN}, {"aCBt", TRACK_ACBT}, {"aCn", TRACK_ACN},
             {"aCt", TRACK_ACT}, {"aC", TRACK_AC},     {"aB4n", TRACK_AB4N}, {"aB4t", TRACK_AB4T},
             {"aB4", TRACK_AB4}, {"aK", TRACK_AK},     {"aS", TRACK_AS}};

/* -1: there is none */
static int number_of(const char *name)
{
    size_t i;

    for (i = 0; i < COUNT(fixed); i++)
        if (strcmp(fixed[i].name, name) == 0)
            return fixed[i].number;
    return -1;
}

static int has(const tracks *t, int number)
{
    return number >= 0 && t->list[number].is_there;
}

static fourlink_vector get(const tracks *t, int number)
{
    if (!has(t, number))
        fail_msg("no track %d in\n%s", number, deck_text);
    return tracks_vector(t, number);
}

static fourlink_vector at_now(const char *name)
{
    return get(&around[NOW], number_of(name));
}

static fourlink_vector minus(fourlink_vector p, fourlink_vector q)
{
    return place_beside(p, -q.x, -q.y);
}

static fourlink_vector plus(fourlink_vector p, fourlink_vector q)
{
    return place_beside(p, q.x, q.y);
}

static double size_of(fourlink_vector p)
{
    return hypot(p.x, p.y);
}

static double dot(fourlink_vector p, fourlink_vector q)
{
    return p.x * q.x + p.y * q.y;
}

static double cross(fourlink_vector p, fourlink_vector q)
{
    return p.x * q.y - p.y * q.x;
}

/* d/dt of a track */
static fourlink_vector rate_of(int number)
{
    fourlink_vector d = minus(get(&around[AFTER], number), get(&around[BEFORE], number));

    return place_at(d.x / (2 * step), d.y / (2 * step));
}

static fourlink_vector rate(const char *name)
{
    return rate_of(number_of(name));
}

static void same(const char *what, fourlink_vector p, fourlink_vector q, double size)
{
    if (!(size_of(minus(p, q)) <= CLOSE * size))
        fail_msg("%s: (%.9g, %.9g), not (%.9g, %.9g), of %.3g\n%s", what, p.x, p.y, q.x, q.y, size,
                 deck_text);
}

/* As a number times 1. */
static void none(const char *what, double x, double size)
{
    same(what, place_at(x, 0), place_at(0, 0), size);
}

/* The velocity is the rate of the place, the acceleration that of the velocity. */
static void check_point(int place, int velocity, int acceleration, double v, double a)
{
    same("velocity", get(&around[NOW], velocity), rate_of(place), v);
    if (has(&around[NOW], acceleration))
        same("acceleration", get(&around[NOW], acceleration), rate_of(velocity), a);
}

/* A normal and a tangential part: against the arm and across it; they are omega^2 r and alpha r of it, and `whole` is their
** sum. */
static void check_parts(const char *normal, const char *tangential, fourlink_vector arm,
                        fourlink_vector whole, double a)
{
    fourlink_vector n = at_now(normal), t = at_now(tangential);

    none(normal, cross(n, arm), a * size_of(arm));
    assert_true(dot(n, arm) <= 0);
    none(tangential, dot(t, arm), a * size_of(arm));
    same("sum of normal and tangential", plus(n, t), whole, a);
}

/* The angular velocity of the lever, from its ends; 0 for a yoke. */
static double turning_of_lever(void)
{
    fourlink_vector ends = minus(at_now("E2"), at_now("E1")), rates = minus(rate("E2"), rate("E1"));

    return size_of(ends) > 1e-9 ? cross(ends, rates) / dot(ends, ends) : 0;
}

static void check_slot(const fourlink_instant *now, double v, double a)
{
    fourlink_vector B = at_now("B"), vS = at_now("vS"), sum;
    double omega = now->state.link[4].omega;

    same("vB = vB4 + vS", plus(at_now("vB4"), vS), at_now("vB"), v);
    none("vS across the slide", cross(vS, now->state.link[3].axis), v);
    if (shown.kind.guided) {
        same("vB4", at_now("vB4"), rate("C"), v);
        same("aB4", at_now("aB4"), rate("vB4"), a); /* it does not turn */
        sum = plus(at_now("aB4"), at_now("aS"));
    } else {
        fourlink_vector r = minus(B, at_now("D"));

        if (shown.lever_high - shown.lever_low > 1e-3)
            none("turning of the lever", turning_of_lever() - omega, fabs(omega) + v / size_of(r));
        same("vB4", at_now("vB4"), place_at(-omega * r.y, omega * r.x), v);
        same("aK", at_now("aK"), place_at(-2 * omega * vS.y, 2 * omega * vS.x), a);
        none("aB4n", cross(at_now("aB4n"), r), a * size_of(r));
        assert_true(dot(at_now("aB4n"), r) <= 0);
        none("aB4t", dot(at_now("aB4t"), r), a * size_of(r));
        same("aB4n", at_now("aB4n"), place_at(-omega * omega * r.x, -omega * omega * r.y), a);
        sum = plus(plus(at_now("aB4n"), at_now("aB4t")), plus(at_now("aK"), at_now("aS")));
    }
    none("aS across the slide", cross(at_now("aS"), now->state.link[3].axis), a);
    same("aB", sum, rate("vB"), a);
}

static void check_rod(double v, double a)
{
    fourlink_vector B = at_now("B"), C = at_now("C");

    check_point(TRACK_C, TRACK_VC, TRACK_AC, v, a);
    same("vCB", at_now("vCB"), minus(rate("C"), rate("B")), v);
    check_parts("aCBn", "aCBt", minus(C, B), rate("vCB"), a);
    if (shown.kind.guided)
        assert_true(has(&around[NOW], TRACK_AC));
    else
        check_parts("aCn", "aCt", minus(C, at_now("D")), rate("vC"), a);
}

/* Pins of outputs, and what they are relative to each other: of a rod, and along slots. */
static void check_output(int i, double v, double a)
{
    const fourlink_group *g = &shown.design->group[i];
    const tracks *t = &around[NOW];
    int first = TRACK_OF_OUTPUT(i);
    fourlink_vector P = get(t, first + OUTPUT_P), Q = get(t, first + OUTPUT_Q), n, sum;

    check_point(first + OUTPUT_P, first + OUTPUT_P + 1, first + OUTPUT_P + 2, v, a);
    check_point(first + OUTPUT_Q, first + OUTPUT_Q + 1, first + OUTPUT_Q + 2, v, a);
    if (g->end == FOURLINK_GROUP_TURNS && g->to > FOURLINK_GROUND)
        check_point(first + OUTPUT_D, first + OUTPUT_D + 1, first + OUTPUT_D + 2, v, a);
    else
        same("pin of an output", rate_of(first + OUTPUT_D),
             g->end == FOURLINK_GROUP_SLIDES ? rate_of(first + OUTPUT_Q) : place_at(0, 0), v);
    if (g->hang == FOURLINK_HANGS_BY_ROD) {
        none("length of a rod", size_of(minus(Q, P)) - g->rod, 1e-6 * g->rod);
        none("vQP", dot(get(t, first + OUTPUT_VQP), minus(Q, P)), v * g->rod);
        n = get(t, first + OUTPUT_AQPN);
        none("aQPn", cross(n, minus(Q, P)), a * g->rod);
        assert_true(dot(n, minus(Q, P)) <= 0);
        none("aQPt", dot(get(t, first + OUTPUT_AQPT), minus(Q, P)), a * g->rod);
        sum = plus(n, get(t, first + OUTPUT_AQPT));
        same("aQP", sum, minus(rate_of(first + OUTPUT_Q + 1), rate_of(first + OUTPUT_P + 1)), a);
    }
}

/* The largest track of a quantity: what differences are compared with. */
static double largest(quantity q)
{
    const tracks *t = &around[NOW];
    double most = 0;
    int i;

    for (i = 0; i < TRACK_COUNT; i++)
        if (has(t, i) && t->list[i].q == q)
            most = fmax(most, size_of(t->list[i].v));
    return most;
}

static long n_points; /* centres of mass and tracer points */

static void check_motion(const fourlink_instant *now)
{
    double v, a;
    int i;

    find_around(now);
    v = largest(QUANTITY_SPEED);
    a = largest(QUANTITY_ACCELERATION);
    same("A", at_now("A"), place_at(0, 0), 0);
    check_point(TRACK_B, TRACK_VB, -1, v, a);
    check_parts("aBn", "aBt", minus(at_now("B"), at_now("A")), rate("vB"), a);
    if (shown.kind.slotted)
        check_slot(now, v, a);
    else
        check_rod(v, a);
    for (i = 0; i < shown.design->n_groups; i++)
        check_output(i, v, a);
    for (i = TRACK_CENTRE; i < TRACK_LOAD; i += i + 3 == TRACK_WEIGHT ? TRACK_POINT - i : 3)
        if (has(&around[NOW], i)) {
            check_point(i, i + 1, i + 2, v, a);
            n_points++;
        }
}

/* ------------------------------------------------------------------------------------------ polygons */

enum { CORNERS = 9 };

static scene shown_scene;

/* Each corner is at one place, however it is reached; the sides of a rod's acceleration that are not of this mechanism
** have no track. */
static void check_polygon(const scene_polygon *p)
{
    fourlink_vector places[CORNERS];
    int is_known[CORNERS] = {1, 0, 0, 0, 0, 0, 0, 0, 0}, n = 1, i;
    const scene_side *side;

    places[0] = place_at(0, 0);
    assert_int_equal(p->sides->from, 0);
    assert_non_null(p->letters[0]);
    for (side = p->sides; side->name; side++) {
        fourlink_vector end;

        if (!has(&around[NOW], p->first + side->of))
            continue;
        assert_int_equal(around[NOW].list[p->first + side->of].q, p->q);
        assert_true(side->to < CORNERS && is_known[side->from]);
        end = plus(places[side->from], get(&around[NOW], p->first + side->of));
        if (is_known[side->to])
            same(p->title, places[side->to], end, largest(p->q));
        places[side->to] = end;
        n += !is_known[side->to];
        is_known[side->to] = 1;
    }
    assert_true(n >= 3);
    for (i = 0; i < shown_scene.n_images; i++) /* that of a point is its velocity or acceleration */
        assert_int_equal(around[NOW].list[shown_scene.images[i].of + p->derivative].q, p->q);
}

/* --------------------------------------------------------------------------------------- equilibrium */

static long n_bodies;

/* Forces on the pins P and Q of several outputs have the output's number. */
static void check_name(const scene_force *f)
{
    int n = shown.design->n_groups, i;
    char sub[TRACKS_NAME];

    for (i = 0; i < n; i++) {
        int is_P = f->of == TRACK_OF_OUTPUT(i) + OUTPUT_FP;

        if (!is_P && f->of != TRACK_OF_OUTPUT(i) + OUTPUT_FQ)
            continue;
        snprintf(sub, sizeof sub, n > 1 ? "%c%d" : "%c", is_P ? 'P' : 'Q', i + 1);
        assert_string_equal(f->sub, sub);
    }
}

/* The forces on a link, weight and -m a among them, and their moments about A are in equilibrium. */
static void check_equilibrium(const scene *s, const tracks *t)
{
    double force = 0, arm = 0, moment, torque = 0;
    fourlink_vector sum;
    int link, body, i;

    for (i = 0; i < TRACK_COUNT; i++) {
        if (!has(t, i))
            continue;
        force = fmax(force, t->list[i].q == QUANTITY_FORCE ? size_of(t->list[i].v) : 0);
        torque = fmax(torque, t->list[i].q == QUANTITY_TORQUE ? fabs(t->list[i].v.x) : 0);
        arm = fmax(arm, t->list[i].q == QUANTITY_LENGTH ? size_of(t->list[i].v) : 0);
    }
    for (body = 0; (link = scene_body(&shown, body)) != 0; body++) {
        n_bodies++;
        sum = place_at(0, 0);
        moment = 0;
        for (i = 0; i < s->n_forces; i++)
            if (s->forces[i].on == link) {
                const scene_force *f = &s->forces[i];
                fourlink_vector F = get(t, f->of);

                check_name(f);
                F = place_at(f->sign * F.x, f->sign * F.y);
                sum = plus(sum, F);
                moment += cross(get(t, f->at), F);
            }
        for (i = 0; i < s->n_torques; i++)
            if (s->torques[i].on == link) {
                const scene_force *f = &s->torques[i];

                assert_int_equal(t->list[f->of].q, QUANTITY_TORQUE);
                moment += f->sign * get(t, f->of).x;
                if (f->load != FOURLINK_LOAD_FRICTION) /* which is drawn as circles */
                    get(t, f->at);
            }
        same("forces on a link", sum, place_at(0, 0), force * 1e-3);
        none("moments on a link", moment, (torque + arm * force) * 1e-3);
    }
}

/* -------------------------------------------------------------------------------------------- places */

/* A slotted lever reaches to each of its points, and of a yoke along its guide, and no farther. */
static double lever_low, lever_high;

static void extend(const fourlink_vector *at)
{
    if (at->y != 0 && !shown.kind.guided)
        return;
    lever_low = fmin(lever_low, at->x);
    lever_high = fmax(lever_high, at->x);
}

static void check_lever(const tracks *t, const fourlink_load *loads)
{
    const fourlink_link *lever = &shown.design->link[4];
    fourlink_load_info info;
    fourlink_vector at, pin, ends;
    unsigned long i;
    int link;

    lever_low = lever_high = 0;
    if (!shown.kind.slotted)
        return;
    if (lever->mass > 0)
        extend(&lever->cg);
    for (i = 0; fourlink_deck_point(shown.deck, i, NULL, &link, &at) == FOURLINK_OK; i++)
        if (link == 4)
            extend(&at);
    for (i = 0; fourlink_deck_load(shown.deck, i, &info) == FOURLINK_OK; i++)
        if (info.sort == FOURLINK_LOAD_OWN && info.link == 4)
            extend(&loads[i].at);
    for (link = 0; link < shown.design->n_groups; link++) {
        if (shown.design->group[link].link == 4)
            extend(&shown.design->group[link].at);
        if (shown.design->group[link].to == 4)
            extend(&shown.design->group[link].pivot);
    }
    assert_near(shown.lever_low, lever_low, 0);
    assert_near(shown.lever_high, lever_high, 0);
    /* the pin of the lever is on the line of its ends */
    pin = get(t, shown.kind.guided ? TRACK_C : TRACK_D);
    ends = minus(get(t, TRACK_E2), get(t, TRACK_E1));
    none("length of the lever", size_of(ends) - (lever_high - lever_low),
         1e-6 * shown.design->link[2].length);
    same("pin of the lever",
         place_at(dot(minus(pin, get(t, TRACK_E1)), ends),
                  cross(minus(pin, get(t, TRACK_E1)), ends)),
         place_at(-lever_low * size_of(ends), 0), 1e-6 * dot(ends, ends));
}

/* The ends of a linear spring are as far apart as the spring is long. */
static void check_springs(const tracks *t, const fourlink_state *at)
{
    fourlink_spring_state found;
    fourlink_spring spring;
    int i;

    for (i = 0; i < (int)shown.problem.n_springs; i++) {
        fourlink_deck_spring(shown.deck, (unsigned long)i, NULL, &spring);
        if (spring.is_torsional ||
            fourlink_spring_at(shown.mechanism, at, &spring, &found) != FOURLINK_OK)
            continue;
        assert_close(size_of(minus(get(t, TRACK_SPRING + 2 * i), get(t, TRACK_SPRING + 2 * i + 1))),
                     found.length, 1e-12);
    }
}

/* ------------------------------------------------------------------------------------------ all of it */

static long n_instants;

static void check_scene(fourlink_branch branch)
{
    fourlink_load loads[32];
    fourlink_instant now;
    static tracks t;
    scene_polygon polygon;
    int i, k;

    scene_find(&shown_scene, &shown);
    for (i = 0; i < 4; i++) {
        if (fourlink_results_at(results, branch, between(-400, 400), NULL, &now, loads) !=
                FOURLINK_OK ||
            fabs(now.state.sine) < 0.2 || now.state.group_sine < 0.2)
            continue;
        check_motion(&now);
        for (k = 0; k < scene_count_polygons(&shown); k++) {
            scene_find_polygon(&shown, k, &polygon);
            check_polygon(&polygon);
        }
        tracks_find(&t, &shown, &now, loads);
        check_equilibrium(&shown_scene, &t);
        check_lever(&t, loads);
        check_springs(&t, &now.state);
        n_instants++;
    }
}

TEST(scenes_of_random_machines)
{
    int number, i;

    for (number = 0; number < some_of(3000); number++) {
        begin_chance(67, number);
        open_scene(number, 0);
        for (i = 0; i < shown.n_branches; i++)
            check_scene(shown.branches[i]);
        fourlink_results_free(results);
    }
    assert_true(n_instants > number && n_points > number);
}

/* The four links with what outputs do to them, and the links of outputs: how often a slot was there, a pin that moves. */
TEST(scenes_of_random_outputs)
{
    long instants = n_instants, bodies = n_bodies;
    int number, i, types[3][3] = {{0}}, floating = 0, end, hang;

    for (number = 0; number < some_of(3000); number++) {
        begin_chance(68, number);
        open_scene(number, 1);
        for (i = 0; i < shown.design->n_groups; i++) {
            const fourlink_group *g = &shown.design->group[i];

            types[g->end][g->hang]++;
            floating += g->to > FOURLINK_GROUND;
        }
        for (i = 0; i < shown.n_branches; i++)
            check_scene(shown.branches[i]);
        fourlink_results_free(results);
    }
    assert_true(n_instants - instants > number / 2);
    assert_true(n_bodies - bodies > 4 * (n_instants - instants));
    for (end = 1; end < 3; end++)
        for (hang = 0; hang < 3; hang++)
            assert_true(types[end][hang] > 0);
    assert_true(floating > 0);
}

/* -------------------------------------------------------------------------------------------- pins */

TEST(pins_of_torsional_springs)
{
    static const struct {
        int machine, link, to;
        const char *pin;
    } known[] = {
        {A_FOUR_BAR, 2, 1, "A"},     {A_FOUR_BAR, 3, 2, "B"},     {A_FOUR_BAR, 4, 3, "C"},
        {A_FOUR_BAR, 1, 4, "D"},     {A_FOUR_BAR, 4, 1, "D"},     {A_SLIDER_CRANK, 2, 3, "B"},
        {A_SLIDER_CRANK, 3, 4, "C"}, {A_SLIDER_CRANK, 1, 2, "A"}, {AN_INVERTED, 1, 4, "D"},
        {AN_INVERTED, 2, 3, "B"},    {A_YOKE, 3, 2, "B"},         {A_YOKE, 2, 1, "A"}};
    static const int kinds[] = {FOURLINK_FOUR_BAR, FOURLINK_SLIDER_CRANK,
                                FOURLINK_INVERTED_SLIDER_CRANK, FOURLINK_SCOTCH_YOKE};
    fourlink_spring spring;
    size_t i;

    memset(&spring, 0, sizeof spring);
    for (i = 0; i < COUNT(known); i++) {
        assert_int_equal(fourlink_kind_of(kinds[known[i].machine], &shown.kind), FOURLINK_OK);
        spring.link = known[i].link;
        spring.to = known[i].to;
        assert_string_equal(shown.kind.joint[scene_joint_of(&spring)].letter, known[i].pin);
    }
}

TEST(coils_and_dampers)
{
    static const double values[] = {0, 3};
    fourlink_spring spring;
    int i, k;

    memset(&spring, 0, sizeof spring);
    for (i = 0; i < 2; i++)
        for (k = 0; k < 2; k++) {
            spring.stiffness = values[i];
            spring.damping = values[k];
            assert_int_equal(scene_has_damper(&spring), k);
            assert_int_equal(scene_has_coil(&spring), i || !k); /* a preload alone is a coil */
        }
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
