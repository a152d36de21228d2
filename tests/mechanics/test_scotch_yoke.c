/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_scotch_yoke.c - the Scotch yoke: values of an independent program (absolute coordinates with
** multipliers), Newton's and Euler's equations written out here, central differences, identities, friction in
** slot and guide.
*/
#include <complex.h>

#include "check.h"
#include "samples.h"

#define PI 3.14159265358979323846
#define DEG (PI / 180)

static int n_samples = 3000;

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

static void begin(double a, double beta, double e, sample *s)
{
    memset(s, 0, sizeof *s);
    s->branch = FOURLINK_OPEN;
    s->design.kind = FOURLINK_SCOTCH_YOKE;
    s->design.link[2].length = a;
    s->design.angle = beta;
    s->design.offset = e;
    s->design.gravity.y = -9.81;
}

/* Three mechanisms and their friction. */
static void make_reference(int i, sample *s, fourlink_friction *friction)
{
    memset(friction, 0, sizeof *friction);
    if (i == 1) {
        begin(0.06, 90 * DEG, 0, s);
        set_link(&s->design.link[2], 0.8, 0.0012, 0.02, 0);
        set_link(&s->design.link[3], 0.25, 0.0001, 0, 0);
        set_link(&s->design.link[4], 2.4, 0.01, 0.15, 0.01);
        set_load(&s->load[0], 4, 0.3, 0, -400, 0, 0, FOURLINK_FRAME_GROUND);
        s->n_loads = 1;
        friction->circle[0] = 0.001;
        friction->circle[1] = 0.0008;
        friction->slot = 0.08;
        friction->guide = 0.1;
        friction->guide_length = 0.3;
    } else if (i == 2) {
        begin(0.05, 60 * DEG, 0.025, s);
        set_link(&s->design.link[2], 0.5, 0.0006, 0.01, 0.002);
        set_link(&s->design.link[3], 0.3, 0.0002, 0.004, -0.003);
        set_link(&s->design.link[4], 1.6, 0.004, -0.05, 0.02);
        set_load(&s->load[0], 4, 0.1, 0.02, -150, 60, 5, FOURLINK_FRAME_GROUND);
        set_load(&s->load[1], 3, 0.01, 0, 20, -10, 0, FOURLINK_FRAME_LINK);
        s->n_loads = 2;
        friction->circle[0] = 0.0006;
        friction->circle[1] = 0.0005;
        friction->slot = 0.1;
        friction->slot_length = 0.04;
        friction->guide = 0.12;
        friction->guide_length = 0.2;
    } else {
        begin(0.1, 120 * DEG, -0.03, s);
        s->design.gravity.y = 0;
        set_load(&s->load[0], 4, 0, 0, -1000, 0, 0, FOURLINK_FRAME_GROUND);
        s->n_loads = 1;
        friction->slot = friction->guide = 0.15;
    }
    assert_int_equal(fourlink_prepare(&s->design, &s->mechanism), FOURLINK_OK);
}

static const struct {
    int mechanism;
    double theta2, omega2, alpha2; /* deg, rad/s, rad/s2 */
    /* X dX d2X slide slide_v slide_a, F12x F12y F23x F23y, N34 M34 M14 N Ts */
    double value[15];
    /* friction_A, _B, _slot, _guide, F14x N34 M34 N M14 F12x F12y F23x F23y Ts Ts0 lost */
    double rubbing[16];
} reference[] = {
    {1,
     40,
     30,
     0,
     {0.0459626665871387, -1.15701769743577, -41.3663999284248, 0.0385672565811924,
      1.37887999761416, -34.7105309230731, 279.348000208761, -7.63327431025446, 290.379040189674,
      -6.2251327307683, -300.72064017178, 0, 16.1223636870477, 23.544, -11.3650083131686},
     {0.2694668724381, 0.2244495796991, 23.23101648384, 10.33293412384, 10.33293412384,
      -290.3877060479, 0.2244495796991, 0.3129835161647, 15.49940118576, 269.0150660849,
      15.59774217358, 280.0461060658, 17.00588375307, -9.404819474314, -11.36500831317,
      58.80566516564}},
    {1,
     215,
     30,
     0,
     {-0.0491491226573395, 1.03243758543188, 44.2342103916056, -0.0344145861810628,
      -1.47447367972019, 30.9731275629565, 529.016446975516, 26.3032825741942, 517.220657537755,
      10.1957818907391, -506.162104939853, 0, -14.9493804314393, 23.544, 17.170247053852},
     {0.5397145661301, 0.4229018051891, 41.33207512164, 10.48883408069, -10.48883408069,
      -516.6509390205, 0.4229018051891, 64.87607512164, -15.73325112104, 539.5052810562,
      -15.02879254745, 527.7094916184, -31.1362932309, 20.52526753942, 17.17024705385,
      100.6506145669}},
    {2,
     110,
     12,
     -40,
     {-0.0297938398148553, -0.445336319381136, 7.85322830035893, 0.0253856652971436,
      -0.236958506180819, -7.02259605368459, 145.763318283797, -100.675410039017, 145.207490324785,
      -105.059073986187, -187.714083871191, -0.102584440325063, -10.1682719605724, 49.5530419355956,
      -5.07797885257123},
     {0.1055508369347, 0.0891971174177, 18.39928544239, 12.42232195588, 12.42232195588,
      -183.9928544239, -0.01338732290736, 63.62667581653, -10.35193496323, 133.3409963279,
      -114.7490439199, 132.7851683689, -119.1327078671, -4.058899370617, -5.077978852571,
      12.22895378345}},
    {2,
     300,
     -12,
     -40,
     {0.0644337567297407, -0.346410161513775, -8.35470053837925, -0.0788675134594813,
      -0.346410161513776, 6.04529946162075, 115.734697119576, -81.3697945396537, 116.372609858478,
      -86.6916918142271, -157.769597221425, -0.123895752051898, -26.8364496630777, 34.5807986107127,
      2.87873023596232},
     {0.07029046597235, 0.06063871240898, 13.1148989775, 29.61157180151, 29.61157180151,
      -131.148989775, -0.1845344644609, 32.6283305701, -24.67630983459, 86.12312531807,
      -79.41732649904, 86.76103805697, -84.73922377361, 1.514394087292, 2.878730235962,
      16.37203378405}},
    {3,
     75,
     5,
     0,
     {0.0989701661684613, -0.408248290463863, -2.04124145231931, 0.146176523316419,
      0.149429245361342, -2.78838767912603, 1000, 577.350269189625, 1000, 577.350269189625,
      -1154.70053837925, 0, 168.790110171876, -577.350269189625, -81.6496580927726},
     {0, 0, 169.3937220116, 106.7017509814, 106.7017509814, -1129.291480078, 0, -711.3450065424,
      165.0759023686, 893.2982490186, 711.3450065424, 893.2982490186, 711.3450065424,
      -67.87502139741, -81.64965809277, 68.87318347679}},
};

TEST(test_reference)
{
    size_t n;
    int closed_form, i;

    for (n = 0; n < COUNT(reference); n++)
        for (closed_form = 0; closed_form < 2; closed_form++) {
            const double *value = reference[n].value, *rubbing = reference[n].rubbing;
            fourlink_friction friction;
            fourlink_losses losses;
            fourlink_forces f;
            sample s;

            make_reference(reference[n].mechanism, &s, &friction);
            s.crank.theta2 = reference[n].theta2 * DEG;
            s.crank.omega2 = reference[n].omega2;
            s.crank.alpha2 = reference[n].alpha2;
            assert_int_equal((closed_form ? fourlink_analyse_dyad : fourlink_analyse)(
                                 &s.mechanism, s.branch, &s.crank, s.load, s.n_loads, &s.state, &f),
                             FOURLINK_OK);
            {
                const fourlink_link_state *yoke = &s.state.link[4];
                const double found[15] = {yoke->origin.x,
                                          yoke->velocity.x,
                                          yoke->acceleration.x,
                                          s.state.slide,
                                          s.state.slide_v,
                                          s.state.slide_a,
                                          f.F12x,
                                          f.F12y,
                                          f.F23x,
                                          f.F23y,
                                          f.N34,
                                          f.M34,
                                          f.M14,
                                          f.F14y,
                                          f.Ts};

                for (i = 0; i < 15; i++)
                    assert_near(found[i], value[i], 1e-12 * fabs(value[i]) + 1e-13);
            }
            assert_near(f.F14x, 0, 1e-12);
            assert_near(f.residual, 0, 1e-14);
            assert_int_equal(fourlink_solve_friction(&s.mechanism, &s.state, s.load, s.n_loads,
                                                     &friction, closed_form, &f, &losses),
                             FOURLINK_OK);
            {
                const double found[16] = {losses.pin[0], losses.pin[1], losses.slot, losses.guide,
                                          f.F14x,        f.N34,         f.M34,       f.F14y,
                                          f.M14,         f.F12x,        f.F12y,      f.F23x,
                                          f.F23y,        f.Ts,          losses.Ts0,  losses.power};

                for (i = 0; i < 16; i++)
                    assert_near(found[i], rubbing[i], 2e-11 * fabs(rubbing[i]) + 1e-12);
            }
        }
}

/* Slots of all directions, everything loaded, cranks that turn either way. */
static void draw(uint64_t *seed, sample *s)
{
    int i;

    begin(uniform(seed, 0.02, 1),
          uniform(seed, 3, 177) * DEG * (uniform(seed, 0, 1) < 0.2 ? -1 : 1), uniform(seed, -1, 1),
          s);
    if (uniform(seed, 0, 1) < 0.3)
        s->design.angle = 90 * DEG;
    for (i = 2; i <= 4; i++)
        set_link(&s->design.link[i], uniform(seed, 0, 5), uniform(seed, 0, 0.1),
                 uniform(seed, -0.5, 0.5), uniform(seed, -0.2, 0.2));
    for (i = 0; i < 3; i++)
        set_load(&s->load[i], (int)uniform(seed, 2, 5), uniform(seed, -1, 1), uniform(seed, -1, 1),
                 uniform(seed, -100, 100), uniform(seed, -100, 100), uniform(seed, -50, 50),
                 uniform(seed, 0, 1) < 0.5 ? FOURLINK_FRAME_GROUND : FOURLINK_FRAME_LINK);
    s->n_loads = 3;
    s->design.gravity.x = uniform(seed, -10, 10);
    s->crank.theta2 = uniform(seed, -3 * PI, 3 * PI);
    s->crank.omega2 = uniform(seed, 0, 1) < 0.1 ? 0 : uniform(seed, -10, 10);
    s->crank.alpha2 = uniform(seed, -100, 100);
    assert_int_equal(fourlink_prepare(&s->design, &s->mechanism), FOURLINK_OK);
}

static double cross(fourlink_vector u, double x, double y)
{
    return u.x * y - u.y * x;
}

/* The moment about (x, y) and the force that the loads and the weight exert on a link. */
static void add_loads(const sample *s, int link, fourlink_vector about, double *Fx, double *Fy,
                      double *M)
{
    unsigned long i;

    for (i = 0; i < s->n_loads; i++) {
        const fourlink_load *load = &s->load[i];
        double angle = link == 2 ? s->crank.theta2 : link == 3 ? s->design.angle : 0;
        double turn = load->frame == FOURLINK_FRAME_LINK ? angle : 0;
        double fx = load->force.x * cos(turn) - load->force.y * sin(turn);
        double fy = load->force.x * sin(turn) + load->force.y * cos(turn);
        fourlink_vector r;

        if (load->link != link)
            continue;
        r.x = s->state.link[link].origin.x + load->at.x * cos(angle) - load->at.y * sin(angle) -
              about.x;
        r.y = s->state.link[link].origin.y + load->at.x * sin(angle) + load->at.y * cos(angle) -
              about.y;
        *Fx += fx;
        *Fy += fy;
        *M += load->torque + cross(r, fx, fy);
    }
}

/* The nine equations of the free bodies with the unknowns that were found; accelerations by central
** differences. */
TEST(test_equations)
{
    uint64_t seed = 2;
    double worst = 0, difference = 0;
    sample s;
    int n, closed_form, i;

    for (n = 0; n < 2 * n_samples; n++) {
        const double t = 1e-4;
        fourlink_state before, after;
        fourlink_crank crank;
        fourlink_vector G, a_G, C, B;
        double size, Fx, Fy, M, rest[9], largest, nx, ny, scale;

        draw(&seed, &s);
        closed_form = n % 2;
        assert_int_equal((closed_form ? fourlink_analyse_dyad
                                      : fourlink_analyse)(&s.mechanism, s.branch, &s.crank, s.load,
                                                          s.n_loads, &s.state, &s.forces),
                         FOURLINK_OK);
        B = s.state.link[3].origin;
        C = s.state.link[4].origin;
        nx = -sin(s.design.angle);
        ny = cos(s.design.angle);
        scale = s.design.link[2].length / fabs(nx);
        assert_near(C.x + s.state.slide * cos(s.design.angle), B.x,
                    1e-13 * scale + 1e-14 / fabs(nx));
        assert_near(C.y + s.state.slide * sin(s.design.angle), B.y,
                    1e-13 * scale + 1e-14 / fabs(nx));
        for (i = 0; i < 2; i++) { /* constant acceleration */
            double dt = i ? t : -t;

            crank.theta2 = s.crank.theta2 + s.crank.omega2 * dt + 0.5 * s.crank.alpha2 * dt * dt;
            crank.omega2 = s.crank.omega2 + s.crank.alpha2 * dt;
            crank.alpha2 = s.crank.alpha2;
            assert_int_equal(fourlink_analyse_dyad(&s.mechanism, s.branch, &crank, NULL, 0,
                                                   i ? &after : &before, NULL),
                             FOURLINK_OK);
        }
#define NEAR_DIFFERENCE(found, lower, upper, unit) \
    difference = fmax(difference, fabs((found) - ((upper) - (lower)) / (2 * t)) / (unit))
        size = scale * (fabs(s.crank.omega2) + 100 * t + 1) *
               (1 + fabs(s.crank.omega2) * fabs(s.crank.omega2) + 100);
        NEAR_DIFFERENCE(s.state.v, before.x, after.x, size);
        NEAR_DIFFERENCE(s.state.a, before.v, after.v, size);
        NEAR_DIFFERENCE(s.state.slide_v, before.slide, after.slide, size);
        NEAR_DIFFERENCE(s.state.slide_a, before.slide_v, after.slide_v, size);
        NEAR_DIFFERENCE(s.state.link[4].acceleration.x, before.link[4].velocity.x,
                        after.link[4].velocity.x, size);

        memset(rest, 0, sizeof rest);
        largest = 1e-300;
        for (i = 2; i <= 4; i++) {
            const fourlink_link *link = &s.design.link[i];
            const fourlink_forces *f = &s.forces;
            double *r = rest + 3 * (i - 2);

            assert_int_equal(fourlink_point(&s.state, i, &link->cg, &G, NULL, &a_G), FOURLINK_OK);
            Fx = link->mass * s.design.gravity.x;
            Fy = link->mass * s.design.gravity.y;
            M = 0;
            add_loads(&s, i, G, &Fx, &Fy, &M);
            r[0] = Fx - link->mass * a_G.x;
            r[1] = Fy - link->mass * a_G.y;
            r[2] = M - link->inertia * (i == 2 ? s.crank.alpha2 : 0);
            G.x = -G.x;
            G.y = -G.y; /* from G to the origin */
#define ADD(px, py, fx, fy)                                                         \
    (r[0] += (fx), r[1] += (fy), r[2] += (G.x + (px)) * (fy) - (G.y + (py)) * (fx), \
     largest = fmax(largest, (fabs(G.x + (px)) + fabs(G.y + (py)) + 1) * (fabs(fx) + fabs(fy))))
            if (i == 2) {
                ADD(0, 0, f->F12x, f->F12y);
                ADD(B.x, B.y, -f->F23x, -f->F23y);
                r[2] += f->Ts;
            } else if (i == 3) {
                ADD(B.x, B.y, f->F23x, f->F23y);
                ADD(B.x, B.y, -f->N34 * nx, -f->N34 * ny);
                r[2] -= f->M34;
            } else {
                ADD(B.x, B.y, f->N34 * nx, f->N34 * ny);
                ADD(C.x, C.y, 0.0, f->F14y);
                r[2] += f->M34 + f->M14;
            }
        }
        for (i = 0; i < 9; i++)
            worst = fmax(worst, fabs(rest[i]) / largest);
        assert_near(s.forces.residual, 0, 1e-12);
        assert_near(s.forces.F34x, s.forces.N34 * nx, 1e-12 * fabs(s.forces.N34) + 1e-13);
        assert_near(s.forces.F34y, s.forces.N34 * ny, 1e-12 * fabs(s.forces.N34) + 1e-13);
    }
    if (worst > 1e-14 || difference > 2e-6)
        fail_msg("equations %g, differences %g", worst, difference);
}

/* A slider-crank with a very long rod moves as a yoke at 90 deg; a slot at beta as one at 90 deg with another
** crank. */
TEST(test_limits_and_phases)
{
    uint64_t seed = 3;
    int n;

    for (n = 0; n < n_samples; n++) {
        double a = uniform(&seed, 0.02, 1), beta = uniform(&seed, 5, 175) * DEG,
               e = uniform(&seed, -1, 1);
        double l = 1e5 * a, theta2 = uniform(&seed, -7, 7), omega2 = uniform(&seed, -10, 10),
               sine = sin(beta);
        fourlink_mechanism yoke, engine, right;
        fourlink_state s, of_engine, of_right;
        fourlink_crank crank = {0, 0, 3};
        fourlink_limits limits;
        fourlink_design d;
        double X[2];

        memset(&d, 0, sizeof d);
        d.kind = FOURLINK_SLIDER_CRANK;
        d.link[2].length = a;
        d.link[3].length = l;
        assert_int_equal(fourlink_prepare(&d, &engine), FOURLINK_OK);
        d.kind = FOURLINK_SCOTCH_YOKE;
        d.angle = 90 * DEG;
        assert_int_equal(fourlink_prepare(&d, &right), FOURLINK_OK);
        crank.theta2 = theta2;
        crank.omega2 = omega2;
        assert_int_equal(
            fourlink_analyse_dyad(&right, FOURLINK_OPEN, &crank, NULL, 0, &of_right, NULL), 0);
        assert_int_equal(
            fourlink_analyse_dyad(&engine, FOURLINK_OPEN, &crank, NULL, 0, &of_engine, NULL), 0);
        assert_near(of_right.x, of_engine.x, 1e-5 * a);
        assert_near(of_right.v, of_engine.v, 1e-5 * a * fabs(omega2));
        assert_near(of_right.a, of_engine.a, 2e-5 * a * (omega2 * omega2 + 3));
        assert_near(of_right.x, a * (1 - cos(theta2)), 1e-14 * a);

        d.angle = beta;
        d.offset = e;
        assert_int_equal(fourlink_prepare(&d, &yoke), FOURLINK_OK);
        assert_int_equal(fourlink_analyse_dyad(&yoke, FOURLINK_OPEN, &crank, NULL, 0, &s, NULL), 0);
        crank.theta2 = theta2 + 90 * DEG - beta;
        assert_int_equal(
            fourlink_analyse_dyad(&right, FOURLINK_OPEN, &crank, NULL, 0, &of_right, NULL), 0);
        assert_near(s.x, of_right.x / sine, 1e-13 * (a + fabs(e)) / sine);
        assert_near(s.v, of_right.v / sine, 1e-13 * a * (fabs(omega2) + 1) / sine);
        assert_near(s.a, of_right.a / sine, 1e-13 * a * (omega2 * omega2 + 3) / sine);
        assert_near(s.mu, beta < 90 * DEG ? beta : PI - beta, 1e-14);
        X[0] = s.link[4].origin.x;
        crank.theta2 = theta2 + PI;
        assert_int_equal(fourlink_analyse_dyad(&yoke, FOURLINK_OPEN, &crank, NULL, 0, &s, NULL), 0);
        X[1] = s.link[4].origin.x;
        assert_near(X[0] + X[1], 2 * e / tan(beta), 1e-13 * (a + fabs(e)) / sine);

        assert_int_equal(fourlink_limits_of(&yoke, FOURLINK_OPEN, &limits), FOURLINK_OK);
        assert_near(limits.stroke, 2 * a / sine, 1e-14 * a / sine);
        crank.theta2 = limits.inner;
        assert_int_equal(fourlink_analyse_dyad(&yoke, FOURLINK_OPEN, &crank, NULL, 0, &s, NULL), 0);
        assert_near(s.x, 0, 1e-14 * (a + fabs(e)) / sine);
        crank.theta2 = limits.outer;
        assert_int_equal(fourlink_analyse_dyad(&yoke, FOURLINK_OPEN, &crank, NULL, 0, &s, NULL), 0);
        assert_near(s.x, limits.stroke, 1e-14 * (a + fabs(e)) / sine);
        crank.theta2 = -90 * DEG;
        assert_int_equal(fourlink_analyse_dyad(&yoke, FOURLINK_OPEN, &crank, NULL, 0, &s, NULL), 0);
        assert_near(s.slide, limits.slide_min, 1e-13 * (a + fabs(e)) / sine);
        crank.theta2 = 90 * DEG;
        assert_int_equal(fourlink_analyse_dyad(&yoke, FOURLINK_OPEN, &crank, NULL, 0, &s, NULL), 0);
        assert_near(s.slide, limits.slide_max, 1e-13 * (a + fabs(e)) / sine);
    }
}

/* A light yoke with a slot at 90 deg, driven by the crank or driving it: Ts / Ts0 = 1 / (1 -+ f), f = 2 mu
** |s| / l; it locks where the guide is shorter than 2 mu |s|. */
TEST(test_friction)
{
    uint64_t seed = 4;
    int n, locked = 0;

    for (n = 0; n < n_samples; n++) {
        double a = uniform(&seed, 0.02, 1), theta2 = uniform(&seed, 5, 85) * DEG,
               P = uniform(&seed, 1, 100);
        double mu = uniform(&seed, 0.01, 0.3), l = 2 * mu * a * uniform(&seed, 0.2, 4), f, expected;
        int drives = n % 2, status;
        fourlink_friction friction;
        fourlink_losses losses;
        sample s;

        memset(&friction, 0, sizeof friction);
        friction.guide = mu;
        friction.guide_length = l;
        begin(a, 90 * DEG, 0, &s);
        s.design.gravity.y = 0;
        assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
        /* for 0 < theta2 < 180 deg the yoke moves along -x: a force along +x resists it */
        set_load(&s.load[0], 4, 0, 0, drives ? P : -P, 0, 0, FOURLINK_FRAME_GROUND);
        s.crank.theta2 = theta2;
        s.crank.omega2 = 1;
        assert_int_equal(
            fourlink_analyse_dyad(&s.mechanism, s.branch, &s.crank, s.load, 1, &s.state, &s.forces),
            0);
        f = 2 * mu * fabs(s.state.slide) / l;
        status = fourlink_solve_friction(&s.mechanism, &s.state, s.load, 1, &friction, 1, &s.forces,
                                         &losses);
        if (drives && f > 1) {
            assert_int_equal(status, FOURLINK_LOCKED);
            locked++;
            continue;
        }
        if (fabs(f - 1) < 1e-3)
            continue;
        assert_int_equal(status, FOURLINK_OK);
        expected = drives ? 1 / (1 - f) : 1 / (1 + f);
        assert_near(s.forces.Ts / losses.Ts0, expected, 1e-11 * expected / fabs(1 - f));
        assert_near(losses.guide, fabs(P) * f * expected,
                    1e-10 * P * (1 + f * expected) / fabs(1 - f));
        assert_near(losses.slot, 0, 0);
    }
    assert_true(locked > 10);
}

/* A counterweight for all of the yoke's mass leaves no force of inertia along the guide, one for none of it no rotating
** one. */
TEST(test_balance)
{
    uint64_t seed = 5;
    int n, whole;

    for (n = 0; n < n_samples; n++)
        for (whole = 0; whole < 2; whole++) {
            fourlink_balance balance;
            double complex sum;
            double a, w2;
            sample s;

            draw(&seed, &s);
            s.crank.alpha2 = 0;
            assert_int_equal(
                fourlink_analyse_dyad(&s.mechanism, s.branch, &s.crank, NULL, 0, &s.state, NULL),
                0);
            assert_int_equal(fourlink_balance_of(&s.mechanism, whole, &balance), FOURLINK_OK);
            a = s.design.link[2].length;
            w2 = s.crank.omega2 * s.crank.omega2;
            sum = s.design.link[2].mass * (s.design.link[2].cg.x + I * s.design.link[2].cg.y) +
                  s.design.link[3].mass * a + balance.crank.x + I * balance.crank.y;
            sum *= -w2 * cexp(I * s.crank.theta2);
            if (whole)
                assert_near(creal(sum) + s.design.link[4].mass * s.state.link[4].acceleration.x, 0,
                            1e-12 * (1 + w2) * 5 * (1 + a / fabs(sin(s.design.angle))));
            else
                assert_near(cabs(sum), 0, 1e-13 * (1 + w2) * 20);
            assert_near(balance.rocker.x, 0, 0);
        }
}

TEST(test_refused)
{
    static const double parallel[] = {0, PI, -PI, 1e-8, 2 * PI - 1e-9};
    fourlink_mechanism m, untouched;
    fourlink_limits limits;
    fourlink_reach reach;
    fourlink_state state;
    sample s;
    size_t i;

    for (i = 0; i < COUNT(parallel); i++) {
        begin(0.1, parallel[i], 0, &s);
        memset(&m, 7, sizeof m);
        untouched = m;
        assert_int_equal(fourlink_prepare(&s.design, &m), FOURLINK_PARALLEL_SLOT);
        assert_memory_equal(&m, &untouched, sizeof m);
    }
    begin(0, 1, 0, &s);
    assert_int_equal(fourlink_prepare(&s.design, &m), FOURLINK_BAD_LENGTH);
    begin(0.1, 1, 0, &s);
    assert_int_equal(fourlink_prepare(&s.design, &m), FOURLINK_OK);
    assert_int_equal(fourlink_position(&m, FOURLINK_CROSSED, 1, &state), FOURLINK_BAD_BRANCH);
    assert_int_equal(fourlink_limits_of(&m, FOURLINK_CROSSED, &limits), FOURLINK_BAD_BRANCH);
    assert_int_equal(fourlink_reach_of(&m, &reach), FOURLINK_OK);
    assert_true(reach.n_ranges == 1 && reach.from[0] == 0 && reach.to[0] == 2 * PI);
}

/* The call for FORTRAN 77: both couples among the forces. */
TEST(test_fortran)
{
    static const double gravity[2] = {0, -9.81};
    double links[20] = {0}, loads[14], crank[3], state[36], slide[3], forces[11];
    int i, n_loads = 2, status = -1;
    fourlink_friction friction;
    sample s;

    make_reference(2, &s, &friction);
    s.crank.theta2 = 110 * DEG;
    s.crank.omega2 = 12;
    s.crank.alpha2 = -40;
    for (i = 1; i <= 4; i++) {
        const fourlink_link *link = &s.design.link[i];
        const double numbers[5] = {link->length, link->mass, link->inertia, link->cg.x, link->cg.y};

        memcpy(&links[5 * (i - 1)], numbers, sizeof numbers);
    }
    for (i = 0; i < 2; i++) {
        const fourlink_load *load = &s.load[i];
        const double numbers[7] = {load->link, load->frame, load->force.x, load->force.y,
                                   load->at.x, load->at.y,  load->torque};

        memcpy(&loads[7 * i], numbers, sizeof numbers);
    }
    crank[0] = s.crank.theta2;
    crank[1] = s.crank.omega2;
    crank[2] = s.crank.alpha2;
    flyoke_(links, &s.design.offset, &s.design.angle, gravity, crank, &n_loads, loads, state, slide,
            forces, &status);
    assert_int_equal(status, FOURLINK_OK);
    assert_near(state[30], reference[2].value[0], 1e-13);
    assert_near(slide[0], reference[2].value[3], 1e-13);
    assert_near(slide[1], reference[2].value[4], 1e-13);
    assert_near(slide[2], reference[2].value[5], 1e-12);
    assert_near(forces[7], reference[2].value[13], 1e-11);
    assert_near(forces[8], reference[2].value[12], 1e-11);
    assert_near(forces[9], reference[2].value[14], 1e-11);
    assert_near(forces[10], reference[2].value[11], 1e-12);
    s.design.angle = 0;
    forces[9] = 7;
    flyoke_(links, &s.design.offset, &s.design.angle, gravity, crank, &n_loads, loads, state, slide,
            forces, &status);
    assert_int_equal(status, FOURLINK_PARALLEL_SLOT);
    assert_near(forces[9], 7, 0);
}

int main(int argc, char **argv)
{
    if (argc > 1)
        n_samples = atoi(argv[1]);
    return run_all_tests(NULL);
}
