/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_inverted.c - the inverted slider-crank: against values of an independent solver (absolute
** coordinates, Lagrange multipliers), against the closure of its vectors and its differences in time,
** both solutions of the nine equations against each other, and at change points and dead positions.
**
** An argument is the number of random mechanisms.
*/
#include <stdlib.h>

#include "mechanisms.h"
#include "samples.h"

static int n_samples = 3000;

static fourlink_design lengths(double a, double d, double offset, double c, double gamma)
{
    fourlink_design design;

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_INVERTED_SLIDER_CRANK;
    design.link[1].length = d;
    design.link[2].length = a;
    design.link[4].length = c;
    design.offset = offset;
    design.angle = gamma;
    return design;
}

static fourlink_mechanism prepared(double a, double d, double offset, double c, double gamma)
{
    fourlink_design design = lengths(a, d, offset, c, gamma);
    fourlink_mechanism m;

    assert_int_equal(fourlink_prepare(&design, &m), FOURLINK_OK);
    return m;
}

static fourlink_state at(const fourlink_mechanism *m, fourlink_branch branch, double theta2,
                         double w, double al)
{
    fourlink_state state;

    assert_int_equal(analyse(m, branch, theta2, w, al, &state), FOURLINK_OK);
    return state;
}

static void set_link(fourlink_link *link, double mass, double inertia, double x, double y)
{
    link->mass = mass;
    link->inertia = inertia;
    link->cg.x = x;
    link->cg.y = y;
}

static void set_load(fourlink_load *load, int link, double x, double y, double Fx, double Fy,
                     double torque, fourlink_frame frame)
{
    load->link = link;
    load->at.x = x;
    load->at.y = y;
    load->force.x = Fx;
    load->force.y = Fy;
    load->torque = torque;
    load->frame = frame;
}

/* The mechanisms of the reference values: a slotted lever, Whitworth's with an offset, one with a lever at
** 60 deg to the slide, an oscillating cylinder with gas. */
static unsigned long make_reference(int i, sample *s)
{
    fourlink_link *link = s->design.link;

    memset(s, 0, sizeof *s);
    switch (i) {
    case 0:
        s->design = lengths(0.12, 0.24, 0, 0, 0);
        set_link(&link[2], 0.8, 0.0015, 0.05, 0.004);
        set_link(&link[3], 0.3, 0.00012, 0.002, -0.001);
        set_link(&link[4], 2.5, 0.035, 0.21, 0.012);
        set_load(&s->load[0], 4, 0.45, 0, -150, 0, 0, FOURLINK_FRAME_GROUND);
        s->crank.omega2 = 10;
        break;
    case 1:
        s->design = lengths(0.15, 0.06, 0.02, 0, 0);
        set_link(&link[2], 1.2, 0.004, 0.06, 0);
        set_link(&link[3], 0.25, 0.0001, 0, 0);
        set_link(&link[4], 1.9, 0.02, 0.08, -0.01);
        set_load(&s->load[0], 4, 0, 0, 0, 0, -25, FOURLINK_FRAME_GROUND);
        s->crank.omega2 = 6;
        s->crank.alpha2 = 15;
        break;
    case 2:
        s->design = lengths(0.08, 0.2, 0, 0.13, PI / 3);
        set_link(&link[2], 0.1, 0.0004, 0.04, 0);
        set_link(&link[3], 0.3, 0.001, -0.15, 0.01);
        set_link(&link[4], 0.15, 0.0007, 0.065, 0);
        set_load(&s->load[0], 3, -0.35, 0, 0, -100, 0, FOURLINK_FRAME_GROUND);
        s->crank.omega2 = 10;
        s->crank.alpha2 = -40;
        break;
    default:
        s->design = lengths(0.05, 0.3, 0, 0, 0);
        set_link(&link[2], 0.6, 0.0004, 0, 0);
        set_link(&link[3], 0.9, 0.006, -0.11, 0);
        set_link(&link[4], 3.2, 0.018, 0.03, 0);
        set_load(&s->load[0], 3, 0, 0, 900, 0, 0, FOURLINK_FRAME_LINK);
        set_load(&s->load[1], 4, 0, 0, -900, 0, 0, FOURLINK_FRAME_LINK);
        s->crank.omega2 = 31.41592653589793;
    }
    s->design.gravity.y = -9.81;
    assert_int_equal(fourlink_prepare(&s->design, &s->mechanism), FOURLINK_OK);
    return i < 3 ? 1 : 2;
}

#define N_VALUES 17

/* theta3 omega3 alpha3 theta4 slide slide_v slide_a coriolis, F12x F12y F23x F23y N34 M34 F14x F14y Ts */
static const struct {
    int mechanism;
    fourlink_branch branch;
    double angle; /* deg */
    double value[N_VALUES];
} reference[] = {
    {0,
     FOURLINK_OPEN,
     35,
     {2.689423912328, -3.703766491851, 115.870930825, 2.689423912328, 0.1575336225983,
      1.048601631477, 7.995705838795, -7.76755117193, 42.05823271788, 105.2565770755,
      45.15129643541, 99.96501147509, -110.2182876103, -0.01811171213509, 85.04976048365,
      -133.6304654997, 7.022088406826}},
    {0,
     FOURLINK_OPEN,
     300,
     {-2.617993877991, -1.331555684734e-15, -57.73502691896, -2.617993877991, 0.2078460969083, -1.2,
      2.545541913954e-15, 3.19573364336e-15, 46.46112435328, -70.2873869405, 48.73825248249,
      -81.43948855564, 101.0811459811, 0.02078373129733, 82.80398244321, 137.4478148595,
      0.4020447304447}},
    {0,
     FOURLINK_CROSSED,
     35,
     {-0.4521687412617, -3.703766491851, 115.870930825, -0.4521687412617, -0.1575336225983,
      -1.048601631477, -7.995705838795, 7.76755117193, -147.8086818545, -285.7525391829,
      -144.715618137, -291.0441047834, -324.5984850184, -0.01004492405538, 308.6166664991,
      375.5158084662, -18.34503903445}},
    {1,
     FOURLINK_OPEN,
     50,
     {1.097183296211, 7.38133360816, -5.48469005211, 1.097183296211, 0.1188689321296,
      0.3480000971432, 1.603237400501, 5.137409625372, -195.9585982146, 110.7496246943,
      -193.4651647318, 100.2690012724, 215.9353277499, 0.000548469005211, 188.1623619674,
      -87.22091108646, 32.47700164949}},
    {1,
     FOURLINK_OPEN,
     310,
     {-1.430565882914, 6.423303777985, 36.55983396107, -1.430565882914, 0.1188689321296,
      -0.3480000971432, -0.1367630852153, -4.470620677438, 217.0567454083, 49.11915364385,
      217.8955228941, 34.66735582883, 220.4968242132, -0.003655983396107, -212.8330815561,
      -5.771872683237, 28.9590239366}},
    {1,
     FOURLINK_CROSSED,
     50,
     {-1.711026770676, 6.423303777985, -4.443315071147, -1.711026770676, -0.1188689321296,
      -0.3480000971432, -1.603237400501, -4.470620677438, -207.5686938557, 41.02500885922,
      -205.0752603728, 30.54438543732, -205.7967363353, 0.0004443315071147, 204.7724192059,
      -3.847271348352, 27.08836116463}},
    {2,
     FOURLINK_OPEN,
     110,
     {3.311715631002, 0.6737176740057, 29.77525504049, 2.264518079806, 0.1463519448371,
      0.7113765593292, -7.829083934205, 0.9585339217869, 29.75160608535, -59.40820997767,
      29.46444720869, -60.06805615229, 164.7966968582, -34.85154695049, -28.12104669967,
      163.7001571879, -0.6072639458676}},
    {2,
     FOURLINK_OPEN,
     280,
     {4.132905159673, 3.47459950411, -15.75496199959, 3.085707608476, 0.1028340201349,
      -0.9388396962383, 0.1590504174336, -6.524183885978, 96.14451077291, 41.8212491554,
      96.37153928446, 40.47410976262, 116.5159204333, -19.67184669529, -97.36805591364,
      65.42149370084, 8.139269511294}},
    {2,
     FOURLINK_CROSSED,
     110,
     {-0.8087766671107, 3.466973188702, -15.61319890866, -1.855974218307, -0.2763519448371,
      -0.7113765593292, 7.829083934205, -4.932646916531, 87.20273653093, 182.1630859426,
      86.91557765427, 181.503239768, 116.5325322276, 24.58164488362, -84.41777221644,
      -78.82540420386, -11.53595615303}},
    {3,
     FOURLINK_OPEN,
     90,
     {2.976443976175, 0.8490790955648, 151.3964152103, 2.976443976175, 0.3041381265149,
      1.549423952328, -7.893500928536, 2.631166976179, 889.646403969, -165.8719307083,
      889.646403969, -171.7579307083, 3.052198254249, 1.303920949083, -889.5738690956,
      168.0140759787, -44.48232019845}},
    {3,
     FOURLINK_OPEN,
     260,
     {-2.983407436104, 1.641290580335, -133.6218316356, -2.983407436104, 0.3125851009405,
      -1.484650800415, -15.27566801047, -4.873486747616, 898.0943346215, 188.3864275744,
      898.0943346215, 182.5004275744, -1.280635744588, -3.319718115387, -890.3268936679,
      -98.93807802726, 42.63796984999}},
    {3,
     FOURLINK_CROSSED,
     90,
     {-0.1651486774146, 0.8490790955648, 151.3964152103, -0.1651486774146, -0.3041381265149,
      -1.549423952328, 7.893500928536, -2.631166976179, -895.8282878636, 69.38418773098,
      -895.8282878636, 63.49818773098, -34.5507334664, -6.418091854887, 895.7557529902,
      -68.13877261114, 44.79141439318}},
};

/* A difference of values; of angles but for whole turns. */
static double difference(int i, double x, double y)
{
    return i == 0 || i == 3 ? remainder(x - y, 2 * PI) : x - y;
}

TEST(test_reference)
{
    size_t n;
    int solver, i;

    for (n = 0; n < COUNT(reference); n++)
        for (solver = 0; solver < 2; solver++) {
            const double *value = reference[n].value;
            sample s;
            unsigned long n_loads = make_reference(reference[n].mechanism, &s);
            const fourlink_link_state *link = s.state.link;
            const fourlink_forces *f = &s.forces;

            s.crank.theta2 = reference[n].angle * DEG;
            assert_int_equal((solver ? fourlink_analyse : fourlink_analyse_dyad)(
                                 &s.mechanism, reference[n].branch, &s.crank, s.load, n_loads,
                                 &s.state, &s.forces),
                             FOURLINK_OK);
            {
                const double found[N_VALUES] = {
                    link[3].theta, link[3].omega,   link[3].alpha,   link[4].theta,
                    s.state.slide, s.state.slide_v, s.state.slide_a, s.state.coriolis,
                    f->F12x,       f->F12y,         f->F23x,         f->F23y,
                    f->N34,        f->M34,          f->F14x,         f->F14y,
                    f->Ts};

                /* the last but their digits, 12 of them, and what is left of a difference */
                for (i = 0; i < N_VALUES; i++)
                    assert_near(difference(i, found[i], value[i]), 0,
                                1e-9 * fabs(value[i]) + 1e-12);
            }
            assert_near(link[4].omega, link[3].omega, 0);
            assert_near(link[4].alpha, link[3].alpha, 0);
            assert_near(f->F34x, -f->N34 * sin(link[3].theta), 1e-12 * fabs(f->N34));
            assert_near(f->F34y, f->N34 * cos(link[3].theta), 1e-12 * fabs(f->N34));
            assert_near(f->M14, 0, 0);
            assert_near(f->residual, 0, 1e-13);
        }
}

/* Lengths from 0.02 to 1 m, both forms, both branches, everything loaded; until the links reach, and not
** too near a dead position. */
static void draw(uint64_t *seed, sample *s)
{
    fourlink_design *d = &s->design;
    int i;

    do {
        double gamma = uniform(seed, -PI, PI);

        memset(s, 0, sizeof *s);
        if (uniform(seed, 0, 1) < 0.5)
            *d = lengths(uniform(seed, 0.02, 1), uniform(seed, 0.02, 1), uniform(seed, -0.5, 0.5),
                         0, gamma);
        else
            *d = lengths(uniform(seed, 0.02, 1), uniform(seed, 0.02, 1), 0, uniform(seed, 0.01, 1),
                         gamma);
        for (i = 2; i <= 4; i++)
            set_link(&d->link[i], uniform(seed, 0, 5), uniform(seed, 0, 0.1),
                     uniform(seed, -0.5, 0.5), uniform(seed, -0.2, 0.2));
        for (i = 0; i < 2; i++)
            set_load(&s->load[i], (int)uniform(seed, 2, 5), uniform(seed, -1, 1),
                     uniform(seed, -1, 1), uniform(seed, -100, 100), uniform(seed, -100, 100),
                     uniform(seed, -50, 50),
                     uniform(seed, 0, 1) < 0.5 ? FOURLINK_FRAME_GROUND : FOURLINK_FRAME_LINK);
        d->gravity.x = uniform(seed, -10, 10);
        d->gravity.y = uniform(seed, -10, 10);
        s->branch = uniform(seed, 0, 1) < 0.5 ? FOURLINK_OPEN : FOURLINK_CROSSED;
        s->crank.theta2 = uniform(seed, -3 * PI, 3 * PI);
        s->crank.omega2 = uniform(seed, -10, 10);
        s->crank.alpha2 = uniform(seed, -100, 100);
        assert_int_equal(fourlink_prepare(d, &s->mechanism), FOURLINK_OK);
    } while (fourlink_analyse_dyad(&s->mechanism, s->branch, &s->crank, s->load, 2, &s->state,
                                   &s->forces) != FOURLINK_OK ||
             fabs(s->state.sine) < 1e-3);
}

/* A + a e2 = D + s u + h n, also by the lever's own axes; its derivatives; the accelerations of B by way of
** the crank, and by way of the lever: a_B4 + coriolis n + slide_a u. */
TEST(test_closure)
{
    uint64_t seed = 1;
    sample s;
    int n;

    for (n = 0; n < n_samples; n++) {
        const fourlink_link_state *slider = &s.state.link[3], *lever = &s.state.link[4];
        fourlink_vector on_lever, p, v, a;
        double a2, c, gamma, h, size, f, near;

        draw(&seed, &s);
        a2 = s.design.link[2].length;
        c = s.design.link[4].length;
        gamma = c > 0 ? s.design.angle : 0;
        f = hypot(slider->origin.x - s.design.link[1].length, slider->origin.y);
        size = a2 + s.design.link[1].length + c;
        near = 1e-14 * (1 + size / f) / fabs(s.state.sine);
        h = s.design.offset - c * sin(gamma);
        assert_near(s.state.s * slider->axis.x - h * slider->axis.y + s.design.link[1].length,
                    a2 * cos(s.crank.theta2), near * size);
        assert_near(s.state.s * slider->axis.y + h * slider->axis.x, a2 * sin(s.crank.theta2),
                    near * size);
        assert_near(cos(slider->theta - lever->theta), cos(gamma), 1e-14);
        assert_near(sin(slider->theta - lever->theta), sin(gamma), 1e-14);
        assert_near(hypot(slider->axis.x, slider->axis.y), 1, near);
        assert_true((s.state.s > 0) == (s.branch == FOURLINK_OPEN));
        assert_near(sin(s.state.mu), fabs(s.state.sine), 1e-14);

        /* the point of the lever at B */
        on_lever.x = c + s.state.slide * cos(gamma) - s.design.offset * sin(gamma);
        on_lever.y = s.state.slide * sin(gamma) + s.design.offset * cos(gamma);
        assert_int_equal(fourlink_point(&s.state, 4, &on_lever, &p, &v, &a), FOURLINK_OK);
        assert_near(p.x, slider->origin.x, near * size);
        assert_near(p.y, slider->origin.y, near * size);
        size *= (1 + fabs(slider->k)) * fabs(s.crank.omega2);
        near /= fabs(s.state.sine);
        assert_near(v.x + s.state.slide_v * slider->axis.x, slider->velocity.x, near * size);
        assert_near(v.y + s.state.slide_v * slider->axis.y, slider->velocity.y, near * size);
        size = (fabs(s.state.coriolis) + fabs(s.state.slide_a) + hypot(a.x, a.y) +
                hypot(slider->acceleration.x, slider->acceleration.y));
        near /= fabs(s.state.sine);
        assert_near(a.x - s.state.coriolis * slider->axis.y + s.state.slide_a * slider->axis.x,
                    slider->acceleration.x, 10 * near * size);
        assert_near(a.y + s.state.coriolis * slider->axis.x + s.state.slide_a * slider->axis.y,
                    slider->acceleration.y, 10 * near * size);
    }
}

/* Central differences of theta3 and slide in time. */
TEST(test_differences)
{
    const double dt = 1e-5;
    uint64_t seed = 2;
    sample s;
    int n, i;

    for (n = 0; n < n_samples; n++) {
        fourlink_state at_time[3];
        double turned[3], w, size, w_size;

        do
            draw(&seed, &s);
        while (fabs(s.state.sine) < 0.3 || fabs(s.state.s) < 0.3 * s.design.link[2].length);
        for (i = 0; i < 3; i++) {
            double t = (i - 1) * dt;

            at_time[i] = at(&s.mechanism, s.branch,
                            s.crank.theta2 + t * (s.crank.omega2 + s.crank.alpha2 * t / 2),
                            s.crank.omega2 + t * s.crank.alpha2, s.crank.alpha2);
            turned[i] = remainder(at_time[i].link[3].theta - s.state.link[3].theta, 2 * PI);
        }
        w = s.state.link[3].omega;
        w_size = fabs(s.crank.omega2) + fabs(w) + sqrt(fabs(s.crank.alpha2)) + 1;
        w_size *= 1 + s.design.link[2].length / fabs(s.state.s);
        size = s.design.link[1].length + s.design.link[2].length;
        assert_near((turned[2] - turned[0]) / (2 * dt), w, 1e-8 * w_size * w_size * w_size);
        assert_near((at_time[2].link[4].omega - at_time[0].link[4].omega) / (2 * dt),
                    s.state.link[4].alpha, 1e-8 * w_size * w_size * w_size * w_size);
        assert_near((at_time[2].slide - at_time[0].slide) / (2 * dt), s.state.slide_v,
                    1e-8 * size * w_size * w_size * w_size);
        assert_near((at_time[2].slide_v - at_time[0].slide_v) / (2 * dt), s.state.slide_a,
                    1e-8 * size * w_size * w_size * w_size * w_size);
        assert_near(at_time[1].coriolis, 2 * w * s.state.slide_v, 1e-12 * fabs(w) * size * w_size);
    }
}

/* Couples as forces at the crank's length. */
static void forces_of(const fourlink_forces *f, double arm, double value[N_FORCES])
{
    const double all[N_FORCES] = {f->F12x, f->F12y, f->F23x, f->F23y,      f->F34x,
                                  f->F34y, f->F14x, f->F14y, f->M34 / arm, f->Ts / arm};

    memcpy(value, all, sizeof all);
}

/* Both solutions, the power balance, and the sums of forces and moments of the lever. */
TEST(test_solvers)
{
    uint64_t seed = 3;
    double worst = 0;
    sample s;
    int n, i;

    for (n = 0; n < n_samples; n++) {
        double dyad[N_FORCES], matrix[N_FORCES], largest = 0, arm;
        double A[9][9], b[9], x[9];
        fourlink_forces by_matrix;

        draw(&seed, &s);
        arm = s.design.link[2].length;
        assert_int_equal(fourlink_solve(&s.mechanism, &s.state, s.load, 2, &by_matrix),
                         FOURLINK_OK);
        forces_of(&s.forces, arm, dyad);
        forces_of(&by_matrix, arm, matrix);
        for (i = 0; i < N_FORCES; i++)
            largest = fmax(largest, fabs(dyad[i]));
        for (i = 0; i < N_FORCES; i++) {
            double error = fabs(matrix[i] - dyad[i]) / largest * fabs(s.state.sine);

            worst = fmax(worst, error);
            assert_near(error, 0, 1e-12);
        }
        assert_near(s.forces.N34, by_matrix.N34, 1e-12 * largest / fabs(s.state.sine));
        assert_near(s.forces.residual, 0, 1e-12 / fabs(s.state.sine));
        assert_int_equal(fourlink_system(&s.mechanism, &s.state, s.load, 2, A, b), FOURLINK_OK);
        assert_int_equal(fourlink_unknowns(&s.mechanism, &s.forces, x), FOURLINK_OK);
        assert_near(x[4], s.forces.M34, 0);
        assert_near(x[5], s.forces.N34, 0);
        for (i = 0; i < 9; i++) {
            double sum = -b[i], size = fabs(b[i]);
            int j;

            for (j = 0; j < 9; j++) {
                sum += A[i][j] * x[j];
                size += fabs(A[i][j] * x[j]);
            }
            assert_near(sum, 0, 1e-13 * size / fabs(s.state.sine));
        }
    }
    print_message("%d mechanisms: the solutions differ by %.2g times the condition\n", n_samples,
                  worst);
}

typedef struct sum {
    double x, y, moment,
        size; /* about the centre of mass G; the largest force or moment per metre */
    fourlink_vector G;
} sum;

static void add(sum *s, fourlink_vector at, double x, double y, double couple)
{
    s->x += x;
    s->y += y;
    s->moment += (at.x - s->G.x) * y - (at.y - s->G.y) * x + couple;
    s->size = fmax(s->size, (1 + hypot(at.x - s->G.x, at.y - s->G.y)) * hypot(x, y));
    s->size = fmax(s->size, fabs(couple));
}

/* Newton and Euler for each link by itself: joints, weight and loads give m a_G, and about G I alpha.
** The force of the slider on the lever is F34 at B, and the couple M34. */
TEST(test_free_bodies)
{
    const fourlink_vector A = {0, 0};
    uint64_t seed = 4;
    sample s;
    int n, i, link;

    for (n = 0; n < n_samples; n++) {
        const fourlink_forces *f = &s.forces;
        fourlink_vector B, D = {0, 0};

        draw(&seed, &s);
        B = s.state.link[3].origin;
        D.x = s.design.link[1].length;
        for (link = 2; link <= 4; link++) {
            const fourlink_link *data = &s.design.link[link];
            fourlink_vector a, p;
            sum all = {0, 0, 0, 0, {0, 0}};
            double tolerance;

            fourlink_point(&s.state, link, &data->cg, &all.G, NULL, &a);
            if (link == 2) {
                add(&all, A, f->F12x, f->F12y, f->Ts);
                add(&all, B, -f->F23x, -f->F23y, 0);
            } else if (link == 3) {
                add(&all, B, f->F23x - f->F34x, f->F23y - f->F34y, -f->M34);
            } else {
                add(&all, B, f->F34x, f->F34y, f->M34);
                add(&all, D, f->F14x, f->F14y, 0);
            }
            add(&all, all.G, data->mass * s.design.gravity.x, data->mass * s.design.gravity.y, 0);
            for (i = 0; i < 2; i++) {
                const fourlink_load *load = &s.load[i];
                double turn = load->frame == FOURLINK_FRAME_LINK ? s.state.link[link].theta : 0;

                if (load->link != link)
                    continue;
                fourlink_point(&s.state, link, &load->at, &p, NULL, NULL);
                add(&all, p, load->force.x * cos(turn) - load->force.y * sin(turn),
                    load->force.x * sin(turn) + load->force.y * cos(turn), load->torque);
            }
            tolerance = 1e-12 * all.size / fabs(s.state.sine);
            assert_near(all.x, data->mass * a.x, tolerance);
            assert_near(all.y, data->mass * a.y, tolerance);
            assert_near(all.moment, data->inertia * s.state.link[link].alpha, tolerance);
        }
    }
}

/* theta2, gamma, offset and all that is across turned round mirror the motion at the x axis, and swap the
** signs of what turns; the branch stays. */
TEST(test_mirror)
{
    uint64_t seed = 4;
    sample s;
    int n, i;

    for (n = 0; n < n_samples; n++) {
        sample m;
        double size;

        draw(&seed, &s);
        m = s;
        m.design.offset = -s.design.offset;
        m.design.angle = -s.design.angle;
        m.design.gravity.y = -s.design.gravity.y;
        m.crank.theta2 = -s.crank.theta2;
        m.crank.omega2 = -s.crank.omega2;
        m.crank.alpha2 = -s.crank.alpha2;
        for (i = 2; i <= 4; i++)
            m.design.link[i].cg.y = -s.design.link[i].cg.y;
        for (i = 0; i < 2; i++) {
            m.load[i].force.y = -s.load[i].force.y;
            m.load[i].at.y = -s.load[i].at.y;
            m.load[i].torque = -s.load[i].torque;
        }
        assert_int_equal(fourlink_prepare(&m.design, &m.mechanism), FOURLINK_OK);
        assert_int_equal(
            fourlink_analyse_dyad(&m.mechanism, m.branch, &m.crank, m.load, 2, &m.state, &m.forces),
            FOURLINK_OK);
        size = 1e-9 * (fabs(s.forces.F23x) + fabs(s.forces.F23y) + fabs(s.forces.N34));
        assert_near(m.state.slide, s.state.slide, 1e-12);
        assert_near(m.state.slide_v, s.state.slide_v, 1e-9 * (1 + fabs(s.state.slide_v)));
        assert_near(m.state.link[3].axis.y, -s.state.link[3].axis.y, 1e-12);
        assert_near(m.state.link[4].omega, -s.state.link[4].omega,
                    1e-9 * (1 + fabs(s.state.link[4].omega)));
        assert_near(m.forces.N34, -s.forces.N34, size);
        assert_near(m.forces.F14x, s.forces.F14x, size);
        assert_near(m.forces.F14y, -s.forces.F14y, size);
        assert_near(m.forces.Ts, -s.forces.Ts, size);
    }
}

/* A lever of no length, or one that is a length beyond its slide, is the lever without. */
TEST(test_forms)
{
    uint64_t seed = 5;
    int n;

    for (n = 0; n < n_samples; n++) {
        double a = uniform(&seed, 0.1, 1), d = uniform(&seed, 0.1, 1), c = uniform(&seed, 0.1, 1);
        double gamma = uniform(&seed, -3, 3), theta2 = uniform(&seed, 0.1, 6);
        fourlink_mechanism short_one = prepared(a, d, 0, c, gamma);
        fourlink_mechanism other = prepared(a, d, -c * sin(gamma), 0, 0);
        fourlink_mechanism straight = prepared(a, d, 0, c, 0), plain = prepared(a, d, 0, 0, 0);
        fourlink_state x, y;

        if (fabs(c * sin(gamma)) < 0.9 * fabs(a - d)) {
            x = at(&short_one, FOURLINK_OPEN, theta2, 1, 0);
            y = at(&other, FOURLINK_OPEN, theta2, 1, 0);
            assert_near(x.link[3].theta, y.link[3].theta, 1e-13);
            assert_near(cos(x.link[4].theta + gamma), cos(y.link[4].theta), 1e-13);
            assert_near(x.slide, y.slide - c * cos(gamma), 1e-13);
        }
        x = at(&straight, FOURLINK_CROSSED, theta2, 1, 0);
        y = at(&plain, FOURLINK_CROSSED, theta2, 1, 0);
        assert_near(x.link[4].theta, y.link[4].theta, 0);
        assert_near(x.slide, y.slide - c, 1e-15);
        assert_near(x.link[4].theta, atan2(-a * sin(theta2), d - a * cos(theta2)), 1e-11);
    }
}

/* The lever swings back to where it was, or turns once, with the crank; extremes of its angle, its speed
** and the transmission angle are the limits. */
TEST(test_limits)
{
    const int steps = 2000;
    uint64_t seed = 6;
    int n, i;

    for (n = 0; n < 300; n++) {
        double a = uniform(&seed, 0.1, 1), d = uniform(&seed, 0.1, 1);
        double h = uniform(&seed, -0.95, 0.95) * fabs(a - d), turned = 0, gamma = n % 3 ? 0 : 0.7;
        double c = gamma != 0 ? -h / sin(gamma) : 0, low = 9, high = -9;
        fourlink_mechanism m;
        fourlink_branch branch = n % 2 ? FOURLINK_OPEN : FOURLINK_CROSSED;
        fourlink_limits limits;
        fourlink_reach reach;
        fourlink_type type;

        if (c < 0) {
            gamma -= PI;
            c = -c;
        }
        m = prepared(a, d, gamma != 0 ? 0 : h, c, gamma);
        assert_int_equal(fourlink_limits_of(&m, branch, &limits), FOURLINK_OK);
        assert_int_equal(fourlink_type_of(&m, &type), FOURLINK_OK);
        assert_int_equal(fourlink_reach_of(&m, &reach), FOURLINK_OK);
        assert_int_equal(type, a < d ? FOURLINK_SLOTTED_LEVER : FOURLINK_WHITWORTH);
        assert_int_equal(reach.n_ranges, 1);
        assert_near(reach.to[0], 2 * PI, 0);
        for (i = 0; i < steps; i++) {
            fourlink_state state = at(&m, branch, (i + 0.5) * 2 * PI / steps, 1, 0);

            turned += state.link[4].omega * 2 * PI / steps;
            low = fmin(low, state.mu);
            high = fmax(high, state.mu);
        }
        if (fabs(a - d) > 0.1)
            assert_near(turned, a < d ? 0 : 2 * PI, 1e-4);
        assert_true(limits.mu_min <= low + 1e-12);
        assert_true(limits.mu_max >= high - 1e-12 && high > limits.mu_max - 0.01);
        if (fabs(a - d) > 0.1)
            assert_true(low < limits.mu_min + 0.01);
        assert_int_equal(limits.has_swing, a < d);
        assert_true(limits.time_ratio >= 1);
        if (a < d) {
            double swing = limits.theta4_max - limits.theta4_min;
            fourlink_state first = at(&m, branch, limits.theta2_min, 1, 0);
            fourlink_state last = at(&m, branch, limits.theta2_max, 1, 0);

            assert_near(remainder(first.link[4].theta - limits.theta4_min, 2 * PI), 0, 1e-10);
            assert_near(remainder(last.link[4].theta - limits.theta4_max, 2 * PI), 0, 1e-10);
            assert_near(first.link[4].omega, 0, 1e-10);
            assert_near(last.link[4].omega, 0, 1e-10);
            assert_true(-PI < limits.theta4_min && limits.theta4_min <= PI);
            assert_near(limits.time_ratio, (PI + swing) / (PI - swing), 1e-12);
            assert_near(limits.theta2_max - limits.theta2_min, PI + swing, 1e-12);
            if (h == 0)
                assert_near(swing, 2 * asin(a / d), 1e-12);
        }
    }
}

/* Whitworth's ratio: the tool goes back where the slide is at right angles to AD. */
TEST(test_whitworth)
{
    fourlink_mechanism m = prepared(0.15, 0.06, 0, 0, 0);
    double half = acos(0.06 / 0.15);
    fourlink_limits limits;
    fourlink_state state;

    assert_int_equal(fourlink_limits_of(&m, FOURLINK_OPEN, &limits), FOURLINK_OK);
    assert_near(limits.time_ratio, (PI - half) / half, 1e-13);
    assert_false(limits.has_swing);
    state = at(&m, FOURLINK_OPEN, half, 1, 0);
    assert_near(state.link[4].theta, PI / 2, 1e-13);
    state = at(&m, FOURLINK_OPEN, -half, 1, 0);
    assert_near(state.link[4].theta, -PI / 2, 1e-13);
    assert_near(at(&m, FOURLINK_OPEN, 0, 1, 0).link[4].omega, 0.15 / 0.09, 1e-13);
    assert_near(at(&m, FOURLINK_OPEN, PI, 1, 0).link[4].omega, 0.15 / 0.21, 1e-13);
    m = prepared(0.15, 0.06, 0.02, 0, 0);
    assert_int_equal(fourlink_limits_of(&m, FOURLINK_OPEN, &limits), FOURLINK_OK);
    half = acos(0.04 / 0.15);
    assert_near(at(&m, FOURLINK_OPEN, half, 1, 0).link[4].theta, PI / 2, 1e-13);
    assert_near(limits.time_ratio, 2 * PI / (half + acos(0.08 / 0.15)) - 1, 1e-13);
    m = prepared(32.4296875, 1e-15, 32.27734375, 0,
                 0); /* D at A: the sum of the angles is 180 deg */
    assert_int_equal(fourlink_limits_of(&m, FOURLINK_OPEN, &limits), FOURLINK_OK);
    assert_true(limits.time_ratio >= 1);
}

/* One range around 180 deg, whose ends are dead positions; none where the slide passes too far. */
TEST(test_reach)
{
    fourlink_mechanism m = prepared(0.2, 0.3, 0.25, 0, 0);
    double first = acos((0.04 + 0.09 - 0.0625) / 0.12);
    fourlink_limits limits;
    fourlink_reach reach;
    fourlink_state state;
    fourlink_type type;

    assert_int_equal(fourlink_reach_of(&m, &reach), FOURLINK_OK);
    assert_int_equal(reach.n_ranges, 1);
    assert_near(reach.from[0], first, 1e-14);
    assert_near(reach.to[0], 2 * PI - first, 1e-14);
    assert_int_equal(fourlink_type_of(&m, &type), FOURLINK_OK);
    assert_int_equal(type, FOURLINK_INVERTED_ROCKER);
    assert_int_equal(fourlink_limits_of(&m, FOURLINK_OPEN, &limits), FOURLINK_OK);
    assert_near(limits.mu_min, 0, 0);
    assert_near(limits.mu_max, acos(0.5), 1e-14);
    assert_near(limits.time_ratio, 0, 0);
    assert_int_equal(analyse(&m, FOURLINK_OPEN, first + 1e-9, 1, 0, &state), FOURLINK_OK);
    assert_int_equal(analyse(&m, FOURLINK_OPEN, first - 1e-9, 1, 0, &state), FOURLINK_TOO_NEAR);
    assert_int_equal(analyse(&m, FOURLINK_OPEN, first, 1, 0, &state), FOURLINK_DEAD_POSITION);
    m = prepared(0.2, 0.3, -0.51, 0, 0);
    assert_int_equal(fourlink_reach_of(&m, &reach), FOURLINK_OK);
    assert_int_equal(reach.n_ranges, 0);
    assert_int_equal(analyse(&m, FOURLINK_CROSSED, PI, 1, 0, &state), FOURLINK_TOO_NEAR);
}

/* The motion goes smoothly through a change point, and comes back after two turns. */
TEST(test_change_points)
{
    static const double h[] = {0.1, -0.1, 0};
    fourlink_state state, after;
    fourlink_type type;
    int i, n;

    for (i = 0; i < 3; i++) {
        double a = 0.3, d = i < 2 ? 0.2 : 0.3, step = PI / 500;
        fourlink_mechanism m = prepared(a, d, h[i], 0, 0);

        assert_int_equal(fourlink_type_of(&m, &type), FOURLINK_OK);
        assert_int_equal(type, FOURLINK_CHANGE_POINT_INVERTED);
        for (n = -2; n <= 2; n++) {
            assert_int_equal(analyse(&m, FOURLINK_OPEN, 2 * PI * n, 1, 0, &state),
                             FOURLINK_CHANGE_POINT);
            state = at(&m, FOURLINK_OPEN, 2 * PI * n + 1e-5, 1, 0);
            after = at(&m, FOURLINK_OPEN, 2 * PI * n - 1e-5, 1, 0);
            assert_near(state.slide, -after.slide, 1e-9);
            assert_near(cos(state.link[3].theta - after.link[3].theta), 1, 1e-8);
            assert_true(n % 2 ? state.slide < 0 : state.slide > 0);
        }
        for (n = 0; n < 2000; n++) {
            double theta2 = (n + 0.5) * step, root = 2 * sqrt(a * d) * sin(theta2 / 2);

            state = at(&m, FOURLINK_OPEN, theta2, 1, 0);
            assert_near(state.s, root, 1e-12);
            assert_near(at(&m, FOURLINK_CROSSED, theta2, 1, 0).s, -root, 1e-12);
            if (h[i] != 0)
                continue;
            assert_near(remainder(state.link[4].theta - PI / 2 - theta2 / 2, 2 * PI), 0, 1e-10);
            assert_near(state.link[4].omega, 0.5, 1e-10);
        }
    }
}

/* B close to D: digits are not lost. */
TEST(test_near_D)
{
    static const double near[] = {1e-3, 1e-6, 1e-9, -1e-9, -1e-6};
    size_t i;

    for (i = 0; i < COUNT(near); i++) {
        double d = 1, a = 1 + near[i], theta2 = 0.5 * fabs(near[i]);
        double slack = a - d, x = slack - 2 * a * pow(sin(theta2 / 2), 2), y = a * sin(theta2);
        fourlink_mechanism m = prepared(a, d, 0, 0, 0);
        fourlink_state state = at(&m, FOURLINK_OPEN, theta2, 1, 0);

        assert_close(state.slide, hypot(x, y), 1e-14);
        assert_near(state.link[3].theta, atan2(y, x), 1e-14);
        assert_close(state.link[3].k, (a * (x * cos(theta2) + y * sin(theta2))) / (x * x + y * y),
                     1e-13);
    }
}

TEST(test_bad_designs)
{
    static const double bad[] = {-1, 1e-20, 1e20, NAN};
    static const int status[] = {FOURLINK_BAD_LENGTH, FOURLINK_BAD_NUMBER, FOURLINK_BAD_NUMBER,
                                 FOURLINK_BAD_NUMBER};
    fourlink_mechanism m;
    int i;

    for (i = 0; i < 4; i++) {
        fourlink_design design = lengths(1, 1, 0, bad[i], 0);

        assert_int_equal(fourlink_prepare(&design, &m), status[i]);
        design = lengths(bad[i], 1, 0, 0, 0);
        assert_int_equal(fourlink_prepare(&design, &m), status[i]);
        design = lengths(1, bad[i], 0, 0, 0);
        assert_int_equal(fourlink_prepare(&design, &m), status[i]);
        design = lengths(1, 1, 0, 0, 0);
        design.link[3].length = bad[i]; /* unused */
        assert_int_equal(fourlink_prepare(&design, &m), FOURLINK_OK);
    }
    {
        fourlink_design design = lengths(1, 2, 0, 1, INFINITY);

        assert_int_equal(fourlink_prepare(&design, &m), FOURLINK_BAD_NUMBER);
        design = lengths(1, 2, NAN, 0, 0);
        assert_int_equal(fourlink_prepare(&design, &m), FOURLINK_BAD_NUMBER);
    }
}

/* At the ends of the range of numbers a position that is found has no infinite results. */
TEST(test_extreme_numbers)
{
    uint64_t seed = 7;
    int n, i, found = 0;

    for (n = 0; n < 20000; n++) {
        double large = pow(10, uniform(&seed, -15, 14.5)),
               small = pow(10, uniform(&seed, -15, 14.5));
        sample s;

        memset(&s, 0, sizeof s);
        s.design = lengths((n & 1 ? large : small) * uniform(&seed, 1, 2),
                           (n & 2 ? large : small) * uniform(&seed, 1, 2),
                           (n & 4 ? large : small) * (n % 3 - 1), n & 8 ? large : 0, 1);
        for (i = 2; i <= 4; i++)
            set_link(&s.design.link[i], 1e30, 1e30, large, -small);
        set_load(&s.load[0], 2 + n % 3, 1e15, 1e15, 1e30, 1e30, 1e30, FOURLINK_FRAME_LINK);
        s.crank.theta2 = uniform(&seed, 0, 6.3);
        s.crank.omega2 = s.crank.alpha2 = -1e30;
        assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
        if (fourlink_analyse_dyad(&s.mechanism, FOURLINK_OPEN, &s.crank, s.load, 1, &s.state,
                                  &s.forces) != FOURLINK_OK)
            continue;
        found++;
        assert_true(isfinite(s.state.slide) && isfinite(s.state.slide_a));
        assert_true(isfinite(s.state.link[4].alpha) && isfinite(s.state.link[4].theta));
        assert_true(isfinite(s.forces.N34) && isfinite(s.forces.Ts) && isfinite(s.forces.residual));
    }
    assert_true(found > 5000);
}

/* The call for FORTRAN 77. */
TEST(test_fortran)
{
    static const double gravity[2] = {0, -9.81};
    double links[20] = {0}, loads[7], state[36], slide[4], forces[10];
    int i, branch = -1, n_loads = 1, status = -1;
    double crank[3];
    sample s;

    make_reference(2, &s);
    s.crank.theta2 = 110 * DEG;
    for (i = 1; i <= 4; i++) {
        const fourlink_link *link = &s.design.link[i];
        const double numbers[5] = {link->length, link->mass, link->inertia, link->cg.x, link->cg.y};

        memcpy(&links[5 * (i - 1)], numbers, sizeof numbers);
    }
    loads[0] = s.load[0].link;
    loads[1] = s.load[0].frame;
    loads[2] = s.load[0].force.x;
    loads[3] = s.load[0].force.y;
    loads[4] = s.load[0].at.x;
    loads[5] = s.load[0].at.y;
    loads[6] = s.load[0].torque;
    crank[0] = s.crank.theta2;
    crank[1] = s.crank.omega2;
    crank[2] = s.crank.alpha2;
    flinvs_(links, &s.design.offset, &s.design.angle, gravity, &branch, crank, &n_loads, loads,
            state, slide, forces, &status);
    assert_int_equal(status, FOURLINK_OK);
    assert_int_equal(
        fourlink_analyse(&s.mechanism, FOURLINK_CROSSED, &s.crank, s.load, 1, &s.state, &s.forces),
        FOURLINK_OK);
    assert_near(state[18], s.state.link[3].theta, 0);
    assert_near(state[28], s.state.link[4].omega, 0);
    assert_near(slide[0], s.state.slide, 0);
    assert_near(slide[1], s.state.slide_v, 0);
    assert_near(slide[2], s.state.slide_a, 0);
    assert_near(slide[3], s.state.coriolis, 0);
    assert_near(forces[4], s.forces.F34x, 0);
    assert_near(forces[8], s.forces.M34, 0);
    assert_near(forces[9], s.forces.Ts, 0);
    branch = 0;
    flinvs_(links, &s.design.offset, &s.design.angle, gravity, &branch, crank, &n_loads, loads,
            state, slide, forces, &status);
    assert_int_equal(status, FOURLINK_BAD_BRANCH);
}

int main(int argc, char **argv)
{
    if (argc > 1)
        n_samples = atoi(argv[1]);
    return run_all_tests(NULL);
}
