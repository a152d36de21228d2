/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fuzz_library.c - the functions of fourlink.h that take structures: any bytes give a status of the list with
** the outputs untouched, or finite numbers.
**
** Input: the bytes of the numbers, each behind a byte that chooses its sort.  Beyond the end they are 0.
*/
#include <float.h>
#include <math.h>

#include "fourlink.h"
#include "input.h"

static part rest;

static unsigned next_byte(void)
{
    unsigned char c;

    if (!rest.length)
        return 0;
    c = (unsigned char)*rest.text++;
    rest.length--;
    return c;
}

static uint64_t next_bytes(int n)
{
    uint64_t bits = 0;

    while (n-- > 0)
        bits = bits << 8 | next_byte();
    return bits;
}

static double next_number(void)
{
    static const double special[] = {
        NAN,      INFINITY,  -INFINITY, 0,      -0.0,  DBL_MAX, -DBL_MAX, DBL_MIN,
        4.9e-324, -4.9e-324, 1e-15,     1e15,   1e-16, 1e30,    -1e30,    1.1e30,
        1,        -1,        2,         1e-300, M_PI,  -M_PI,   M_PI / 2, 1e-8,
        2 * M_PI, 1e7,       1e-7,      3,      0.5,   180,     -M_PI_2,  1e300};
    unsigned sort = next_byte();
    uint64_t bits;
    double x;

    if (sort < 24)
        return special[sort % (sizeof special / sizeof special[0])];
    if (sort < 32)
        return special[next_byte() % (sizeof special / sizeof special[0])];
    if (sort < 160)
        return (double)(int16_t)next_bytes(2) / 256;
    if (sort < 224)
        return fabs((double)(int16_t)next_bytes(2) / 1024);
    bits = next_bytes(8);
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* One of `n` from `first`, or now and then any. */
static int next_code(int first, int n)
{
    unsigned sort = next_byte();

    return sort < 240 ? (int)(sort % (unsigned)n) + first : (int)next_bytes(4);
}

static fourlink_branch next_branch(void)
{
    int code = next_code(1, 2);

    return (fourlink_branch)(code == 2 ? -1 : code);
}

static fourlink_vector next_vector(void)
{
    fourlink_vector v;

    v.x = next_number();
    v.y = next_number();
    return v;
}

static fourlink_design next_design(void)
{
    static const int kinds[] = {0, FOURLINK_FOUR_BAR, FOURLINK_SLIDER_CRANK,
                                FOURLINK_INVERTED_SLIDER_CRANK, FOURLINK_SCOTCH_YOKE};
    int code = next_code(1, 4), i;
    unsigned simple = next_byte();
    fourlink_design d;

    memset(&d, 0, sizeof d);
    d.kind = (fourlink_kind)(code >= 1 && code <= 4 ? kinds[code] : code);
    for (i = 1; i <= 4; i++) {
        d.link[i].length = next_number();
        if (simple & 1)
            d.link[i].length = fabs(d.link[i].length);
        if (i == 1 || simple & 2)
            continue;
        d.link[i].mass = next_number();
        d.link[i].inertia = next_number();
        if (simple & 1) {
            d.link[i].mass = fabs(d.link[i].mass);
            d.link[i].inertia = fabs(d.link[i].inertia);
        }
        d.link[i].cg = next_vector();
    }
    if (simple & 4)
        return d;
    d.offset = next_number();
    d.gravity = next_vector();
    d.angle = next_number();
    return d;
}

static fourlink_load next_load(void)
{
    fourlink_load l;

    l.link = next_code(2, 3);
    l.frame = (fourlink_frame)(next_code(0, 2));
    l.force = next_vector();
    l.at = next_vector();
    l.torque = next_number();
    return l;
}

static int is_known(int status)
{
    return strcmp(fourlink_status_text(status), fourlink_status_text(-12345)) != 0;
}

static int are_finite(const double *x, size_t n)
{
    while (n-- > 0)
        if (!isfinite(x[n]))
            return 0;
    return 1;
}

/* An output is as it was, or of finite numbers. */
#define UNTOUCHED 0x5a
#define PREPARE(output) memset(&(output), UNTOUCHED, sizeof(output))
#define MUST_BE_UNTOUCHED(output) MUST(is_untouched(&(output), sizeof(output)))
#define NUMBERS(output) ((const double *)&(output)), sizeof(output) / sizeof(double)

static int is_untouched(const void *output, size_t n)
{
    const unsigned char *byte = output;

    while (n-- > 0)
        if (byte[n] != UNTOUCHED)
            return 0;
    return 1;
}

static int is_finite_state(const fourlink_state *s)
{
    int i;

    for (i = 2; i <= 4; i++)
        if (!are_finite((const double *)&s->link[i], sizeof s->link[i] / sizeof(double)))
            return 0;
    return are_finite(&s->sine, 10);
}

/* What is known of a mechanism without a crank angle. */
static void ask_mechanism(const fourlink_mechanism *m)
{
    fourlink_branch branch = next_branch();
    fourlink_type type;
    fourlink_reach reach;
    fourlink_limits limits;
    fourlink_rod rod;
    int i;

    MUST(fourlink_type_of(m, &type) == FOURLINK_OK);
    MUST(fourlink_has_type((int)m->design.kind, (int)type));
    MUST(fourlink_reach_of(m, &reach) == FOURLINK_OK);
    MUST(reach.n_ranges >= 0 && reach.n_ranges <= 2);
    for (i = 0; i < reach.n_ranges; i++)
        MUST(isfinite(reach.from[i]) && isfinite(reach.to[i]) && reach.from[i] < reach.to[i]);
    PREPARE(limits);
    if (fourlink_limits_of(m, branch, &limits) == FOURLINK_OK) {
        MUST(limits.mu_min >= 0 && limits.mu_max <= M_PI / 2 + 1e-12);
        MUST(!limits.has_swing || limits.theta4_min <= limits.theta4_max);
        MUST(!limits.has_stroke || (isfinite(limits.stroke) && limits.stroke >= 0));
        MUST(isfinite(limits.time_ratio) && (limits.time_ratio == 0 || limits.time_ratio >= 1));
    } else {
        MUST_BE_UNTOUCHED(limits);
    }
    PREPARE(rod);
    if (fourlink_rod_masses(m, &rod) == FOURLINK_OK)
        MUST(are_finite(NUMBERS(rod)));
    else
        MUST_BE_UNTOUCHED(rod);
}

static void ask_engine(const fourlink_mechanism *m, const fourlink_state *s,
                       const fourlink_load *loads, unsigned long n)
{
    fourlink_series series;
    fourlink_engine engine;
    fourlink_klein klein;

    PREPARE(series);
    if (fourlink_textbook_series(m, s, &series) == FOURLINK_OK)
        MUST(are_finite(NUMBERS(series)));
    else
        MUST_BE_UNTOUCHED(series);
    PREPARE(engine);
    if (fourlink_engine_method(m, s, next_number(), loads, n,
                               (fourlink_approximation)(next_code(0, 3)), &engine) == FOURLINK_OK)
        MUST(are_finite(NUMBERS(engine)));
    else
        MUST_BE_UNTOUCHED(engine);
    PREPARE(klein);
    if (fourlink_klein_construction(m, s, &klein) == FOURLINK_OK)
        MUST(are_finite(&klein.OM, 5)); /* the others are NaN without an inertia force */
    else
        MUST_BE_UNTOUCHED(klein);
}

static void ask_forces(const fourlink_mechanism *m, const fourlink_state *s,
                       const fourlink_load *loads, unsigned long n)
{
    fourlink_forces f;
    double A[9][9], b[9], x[9];
    int status;

    PREPARE(f);
    status = fourlink_solve(m, s, loads, n, &f);
    MUST(is_known(status));
    if (status == FOURLINK_OK) {
        MUST(are_finite(NUMBERS(f)));
        MUST(fourlink_unknowns(m, &f, x) == FOURLINK_OK && are_finite(x, 9));
    } else {
        MUST_BE_UNTOUCHED(f);
    }
    PREPARE(f);
    status = fourlink_solve_dyad(m, s, loads, n, &f);
    MUST(is_known(status));
    if (status == FOURLINK_OK)
        MUST(are_finite(NUMBERS(f)));
    else
        MUST_BE_UNTOUCHED(f);
    PREPARE(b);
    status = fourlink_system(m, s, loads, n, A, b);
    MUST(is_known(status));
    if (status == FOURLINK_OK)
        MUST(are_finite(&A[0][0], 81) && are_finite(b, 9));
    else
        MUST_BE_UNTOUCHED(b);
}

static void ask_friction(const fourlink_mechanism *m, const fourlink_state *s,
                         const fourlink_load *loads, unsigned long n)
{
    fourlink_friction friction;
    fourlink_losses losses;
    fourlink_forces f;
    int status, i;

    memset(&friction, 0, sizeof friction);
    for (i = 0; i < 4; i++)
        friction.circle[i] = next_number();
    friction.guide = next_number();
    friction.guide_length = next_number();
    friction.slot = next_number();
    friction.slot_length = next_number();
    friction.direction = next_code(-1, 3);
    PREPARE(f);
    status = fourlink_solve_friction(m, s, loads, n, &friction, next_code(0, 2) == 1, &f, &losses);
    MUST(is_known(status));
    if (status == FOURLINK_OK)
        MUST(are_finite(NUMBERS(f)) && are_finite(losses.pin, 4) && isfinite(losses.power));
    else
        MUST_BE_UNTOUCHED(f);
}

static void ask_energy(const fourlink_mechanism *m, const fourlink_state *s,
                       const fourlink_load *loads, unsigned long n)
{
    fourlink_spring spring;
    fourlink_spring_state at;
    double value, slope;

    if (fourlink_inertia(m, s, &value, &slope) == FOURLINK_OK)
        MUST(value >= 0 && isfinite(value) && isfinite(slope));
    if (fourlink_generalised_force(m, s, loads, n, &value) == FOURLINK_OK)
        MUST(isfinite(value));
    memset(&spring, 0, sizeof spring);
    spring.link = next_code(1, 4);
    spring.to = next_code(1, 4);
    spring.is_torsional = next_code(0, 2);
    spring.at = next_vector();
    spring.to_at = next_vector();
    spring.stiffness = next_number();
    spring.free_length = next_number();
    spring.preload = next_number();
    spring.damping = next_number();
    spring.only = next_code(0, 3);
    if (fourlink_spring_prepare(m, &spring) == FOURLINK_OK &&
        fourlink_spring_at(m, s, &spring, &at) == FOURLINK_OK)
        MUST(isfinite(at.length) && isfinite(at.force) && isfinite(at.energy) && at.n_loads <= 2);
}

static void ask_balance(const fourlink_mechanism *m)
{
    fourlink_balance balance;
    fourlink_link link, balanced;
    double mass;

    PREPARE(balance);
    if (fourlink_balance_of(m, next_number(), &balance) == FOURLINK_OK)
        MUST(are_finite(NUMBERS(balance)));
    else
        MUST_BE_UNTOUCHED(balance);
    PREPARE(link);
    if (fourlink_uniform_bar(next_number(), next_number(), &link) != FOURLINK_OK) {
        MUST_BE_UNTOUCHED(link);
        return;
    }
    PREPARE(balanced);
    if (fourlink_add_counterweight(&link, &balance.crank, next_number(), &balanced, &mass) ==
        FOURLINK_OK)
        MUST(are_finite(NUMBERS(balanced)) && isfinite(mass));
    else
        MUST_BE_UNTOUCHED(balanced);
}

static void ask_motor(void)
{
    double speeds[4], torques[4], torque;
    fourlink_motor motor;
    int i;

    memset(&motor, 0, sizeof motor);
    motor.kind = (fourlink_motor_kind)next_code(1, 5);
    motor.torque = next_number();
    motor.stall_torque = next_number();
    motor.no_load_speed = next_number();
    motor.power = next_number();
    motor.max_torque = next_number();
    motor.inertia = next_number();
    motor.ratio = next_number();
    for (i = 0; i < 4; i++) {
        speeds[i] = next_number();
        torques[i] = next_number();
    }
    motor.curve_speed = speeds;
    motor.curve_torque = torques;
    motor.n_curve = next_byte() % 5;
    if (fourlink_motor_torque(&motor, next_number(), &torque) == FOURLINK_OK)
        MUST(isfinite(torque));
}

/* Takes a thousand times as long as a position: seldom. */
static void ask_extreme(const fourlink_mechanism *m, const fourlink_load *loads, unsigned long n)
{
    static const char *const names[] = {"max(Ts)", "min(omega4)", "max(F12)", "max(mu)", "?"};
    fourlink_motion motion = {0, 2 * M_PI, 0.1, 2, 0, 0, 0, 0};
    double value, angle;

    if (next_bytes(2) % 2048 == 1 &&
        fourlink_extreme(m, &motion, loads, n, next_branch(), names[next_byte() % 5], &value,
                         &angle) == FOURLINK_OK)
        MUST(!isnan(value));
}

static void ask_position(const fourlink_mechanism *m)
{
    fourlink_branch branch = next_branch();
    fourlink_load loads[3];
    unsigned long n = next_byte() % 4, i;
    fourlink_crank crank = {next_number(), next_number(), next_number()};
    fourlink_vector at = next_vector(), p[3]; /* position, velocity, acceleration */
    fourlink_forces f;
    fourlink_state s;
    int status;

    for (i = 0; i < n; i++)
        loads[i] = next_load();
    PREPARE(s);
    status = fourlink_analyse(m, branch, &crank, loads, n, &s, NULL);
    MUST(is_known(status));
    if (status != FOURLINK_OK) {
        MUST_BE_UNTOUCHED(s);
        return;
    }
    MUST(is_finite_state(&s));
    PREPARE(f);
    status = fourlink_analyse_dyad(m, branch, &crank, loads, n, &s, &f);
    MUST(is_known(status) && status != FOURLINK_SINGULAR);
    if (status == FOURLINK_OK)
        MUST(are_finite(NUMBERS(f)));
    else
        MUST_BE_UNTOUCHED(f);
    PREPARE(p);
    if (fourlink_point(&s, next_code(2, 3), &at, &p[0], &p[1], &p[2]) == FOURLINK_OK)
        MUST(are_finite(&p[0].x, 6));
    else
        MUST_BE_UNTOUCHED(p);
    ask_forces(m, &s, loads, n);
    ask_engine(m, &s, loads, n);
    ask_friction(m, &s, loads, n);
    ask_energy(m, &s, loads, n);
    ask_extreme(m, loads, n);
}

/* A state that the library did not fill may give any numbers, but it must end. */
static void ask_wrong_state(const fourlink_mechanism *m)
{
    fourlink_load load = next_load();
    fourlink_series series;
    fourlink_engine engine;
    fourlink_klein klein;
    fourlink_forces f;
    fourlink_state s;
    double *number = (double *)&s.link[2];
    size_t i;

    memset(&s, 0, sizeof s);
    s.branch = next_branch();
    for (i = 0; i < 3 * sizeof s.link[2] / sizeof *number; i++)
        number[i] = next_number();
    s.sine = next_number();
    MUST(is_known(fourlink_solve(m, &s, &load, 1, &f)));
    MUST(is_known(fourlink_solve_dyad(m, &s, &load, 1, &f)));
    MUST(is_known(fourlink_velocity(m, next_number(), &s)));
    MUST(is_known(fourlink_acceleration(m, next_number(), &s)));
    fourlink_textbook_series(m, &s, &series);
    fourlink_engine_method(m, &s, next_number(), &load, 1, FOURLINK_EXACT, &engine);
    fourlink_klein_construction(m, &s, &klein);
}

static void ask_motion(void)
{
    fourlink_motion m = {next_number(), next_number(), next_number(), next_number(),
                         next_number(), next_number(), next_number(), next_code(0, 2)};
    fourlink_range range;
    fourlink_row row;
    int status;

    PREPARE(range);
    status = fourlink_motion_range(&m, &range);
    MUST(is_known(status));
    if (status != FOURLINK_OK) {
        MUST_BE_UNTOUCHED(range);
        return;
    }
    MUST(range.n_rows >= 1 && isfinite(range.stop_angle));
    PREPARE(row);
    status = fourlink_motion_row(&m, &range, (unsigned long)next_bytes(3) % range.n_rows, &row);
    MUST(is_known(status));
    if (status == FOURLINK_OK)
        MUST(are_finite(NUMBERS(row)));
    else
        MUST_BE_UNTOUCHED(row);
    PREPARE(row);
    status = fourlink_motion_at(&m, next_number(), &row);
    MUST(is_known(status));
    if (status == FOURLINK_OK)
        MUST(are_finite(NUMBERS(row)));
    else
        MUST_BE_UNTOUCHED(row);
}

static void ask_fortran77(void)
{
    double links[20], grav[2], crank[3], loads[14], state[36], slide[4], forces[11];
    double offset = next_number(), angle = next_number();
    int branch = (int)next_branch(), n_loads = next_code(0, 3), status = -1, i;
    char text[40];

    for (i = 0; i < 20; i++)
        links[i] = next_number();
    for (i = 0; i < 14; i++)
        loads[i] = next_number();
    for (i = 0; i < 3; i++)
        crank[i] = next_number();
    grav[0] = next_number();
    grav[1] = next_number();
    if (n_loads > 2 && n_loads <= FOURLINK_F77_LOADS)
        n_loads = 2;
    flfbar_(links, grav, &branch, crank, &n_loads, loads, state, forces, &status);
    MUST(is_known(status) && (status || (are_finite(state, 36) && are_finite(forces, 10))));
    flslcr_(links, &offset, grav, &branch, crank, &n_loads, loads, state, forces, &status);
    MUST(is_known(status) && (status || (are_finite(state, 36) && are_finite(forces, 10))));
    flinvs_(links, &offset, &angle, grav, &branch, crank, &n_loads, loads, state, slide, forces,
            &status);
    MUST(is_known(status) && (status || (are_finite(state, 36) && are_finite(forces, 10))));
    flyoke_(links, &offset, &angle, grav, crank, &n_loads, loads, state, slide, forces, &status);
    MUST(is_known(status) && (status || (are_finite(state, 36) && are_finite(forces, 11))));
    fltext_(&status, text, sizeof text);
}

static void ask_texts(void)
{
    int code = (int)next_bytes(4), other = next_code(1, 5);
    fourlink_kind_facts facts;

    MUST(fourlink_status_text(code) && fourlink_branch_text(code) && fourlink_type_text(code) &&
         fourlink_defect_text(code));
    MUST(fourlink_kind_text(code) && fourlink_link_text(code, other));
    MUST(fourlink_link_text(other, code) && fourlink_unknown_text(other, code));
    fourlink_has_type(code, other);
    fourlink_slides(other, code);
    if (fourlink_kind_of(other, &facts) == FOURLINK_OK)
        MUST(facts.kind == (fourlink_kind)other &&
             strcmp(facts.words, fourlink_kind_text(other)) == 0);
    MUST(fourlink_kind_of(code, NULL) == FOURLINK_NULL);
}

static fourlink_solution solution;

/* No solution, or one of finite numbers. */
static void must_be_a_solution(int status)
{
    int i;

    MUST(is_known(status));
    if (status != FOURLINK_OK) {
        MUST_BE_UNTOUCHED(solution);
        return;
    }
    for (i = 1; i <= 4; i++)
        MUST(isfinite(solution.design.link[i].length));
    MUST(isfinite(solution.design.offset) && isfinite(solution.from) && isfinite(solution.to));
    MUST(are_finite(&solution.a, 10) && are_finite(&solution.point.x, 2));
    MUST(are_finite(&solution.ratio, 3) && are_finite(&solution.max_error, 2));
    for (i = 0; i < solution.n_positions; i++)
        MUST(are_finite(&solution.position[i].theta2, 5) &&
             isfinite(solution.position[i].residual));
}

static fourlink_dyad next_dyad(void)
{
    fourlink_dyad d;

    d.choice = (fourlink_choice)next_code(1, 3);
    d.pivot = next_vector();
    d.rotation[0] = next_number();
    d.rotation[1] = next_number();
    return d;
}

static void ask_function(unsigned long *n)
{
    double theta2[6], output[6], weight[6];
    fourlink_function_task f;
    int i;

    memset(&f, 0, sizeof f);
    for (i = 0; i < 6; i++) {
        theta2[i] = next_number();
        output[i] = next_number();
        weight[i] = next_number();
    }
    f.kind = (fourlink_kind)next_code(1, 2);
    f.ground = next_number();
    f.n = (unsigned long)(next_byte() % 7);
    f.theta2 = theta2;
    f.output = output;
    f.weight = next_byte() & 1 ? weight : NULL;
    f.fit = (fourlink_fit)next_code(0, 2);
    must_be_a_solution(fourlink_synthesis_function(&f, 1, &solution, n));
}

/* A search takes a while: seldom. */
static void ask_points(unsigned long *n)
{
    fourlink_vector point[6];
    double angle[6], timing[6], weight[6];
    fourlink_points_task t;
    int i;

    memset(&t, 0, sizeof t);
    for (i = 0; i < 6; i++) {
        point[i] = next_vector();
        angle[i] = next_number();
        timing[i] = next_number();
        weight[i] = next_number();
    }
    t.kind = (fourlink_kind)next_code(1, 2);
    t.n = (unsigned long)(next_byte() % 7);
    t.point = point;
    t.angle = next_byte() & 1 ? angle : NULL;
    t.timing = next_byte() & 1 ? timing : NULL;
    t.weight = next_byte() & 1 ? weight : NULL;
    t.left.is_given = next_byte() & 1;
    t.left.low = next_vector();
    t.left.high = next_byte() & 1 ? next_vector() : t.left.low;
    t.may_rock = next_byte() & 1;
    t.any_order = next_byte() & 1;
    t.shortest = next_byte() & 1 ? 0.01 : 0;
    t.longest = next_byte() & 1 ? 10 : 0;
    t.length_ratio = next_byte() & 1 ? 6 : 0;
    t.mu_min = next_byte() & 1 ? next_number() : 0;
    must_be_a_solution(fourlink_synthesis_points(&t, 1, &solution, n));
}

static void ask_synthesis(void)
{
    fourlink_motion_task m;
    fourlink_path_task p;
    fourlink_quick_return_task q;
    fourlink_cognate_task c;
    unsigned long n;
    int i;

    PREPARE(solution);
    switch (next_byte() % 5) {
    case 0:
        if (next_byte() % 64 == 1)
            ask_points(&n);
        else
            ask_function(&n);
        break;
    case 1:
        for (i = 0; i < 3; i++) {
            m.point[i] = next_vector();
            m.angle[i] = next_number();
        }
        m.left = next_dyad();
        m.right = next_dyad();
        must_be_a_solution(fourlink_synthesis_motion(&m, 1, &solution, &n));
        break;
    case 2:
        for (i = 0; i < 3; i++)
            p.point[i] = next_vector();
        for (i = 0; i < 2; i++) {
            p.timing[i] = next_number();
            p.rotation[i] = next_number();
        }
        p.search = next_byte() % 64 == 1;
        p.step = p.search ? 0.5 : next_number();
        p.right = next_dyad();
        must_be_a_solution(fourlink_synthesis_path(&p, 1, &solution, &n));
        break;
    case 3:
        q.type = (fourlink_type)next_code(1, 16);
        q.time_ratio = next_number();
        q.swing = next_number();
        q.stroke = next_number();
        for (i = 0; i < 5; i++)
            q.length[i] = next_number();
        q.offset = next_number();
        q.slow = next_code(-1, 3);
        must_be_a_solution(fourlink_synthesis_quick_return(&q, 1, &solution, &n));
        break;
    default:
        c.design = next_design();
        c.branch = next_branch();
        c.point = next_vector();
        c.side = (fourlink_side)next_code(1, 2);
        c.from = next_number();
        c.to = next_number();
        must_be_a_solution(fourlink_synthesis_cognate(&c, 1, &solution, &n));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fourlink_mechanism m;
    fourlink_design d;
    int status;

    rest.text = (const char *)data;
    rest.length = size;
    switch (next_byte() % 8) {
    case 0:
        ask_motion();
        ask_motor();
        ask_texts();
        break;
    case 1:
        ask_fortran77();
        break;
    case 2:
        ask_synthesis();
        break;
    default:
        d = next_design();
        PREPARE(m);
        status = fourlink_prepare(&d, &m);
        MUST(is_known(status));
        if (status != FOURLINK_OK) {
            MUST_BE_UNTOUCHED(m);
        } else {
            ask_mechanism(&m);
            ask_balance(&m);
            ask_position(&m);
            ask_wrong_state(&m);
        }
    }
    return 0;
}
