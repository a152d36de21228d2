/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_nine_equations.c - pin forces and driving torque of four-bars and slider-cranks: against
** a multibody solution in absolute coordinates with Lagrange multipliers, against the change of
** kinetic energy and of momentum by differences of positions, and against the classical analytical
** method for engines.
*/
#include "samples.h"

#include <stdlib.h>

#include <gsl/gsl_vector.h>

#define EPS 2.220446049250313e-16

/* ---------------------------------------------------------------------------------------------
** Random mechanisms
** ------------------------------------------------------------------------------------------- */

static int solve(sample *s)
{
    assert_int_equal(fourlink_prepare(&s->design, &s->mechanism), FOURLINK_OK);
    return fourlink_analyse(&s->mechanism, s->branch, &s->crank, s->load, s->n_loads, &s->state,
                            &s->forces);
}

static void draw(uint64_t *seed, int n, double smallest_sine, sample *s)
{
    do
        draw_design(seed, n, s);
    while (solve(s) != FOURLINK_OK || fabs(s->state.sine) < smallest_sine);
}

/* ---------------------------------------------------------------------------------------------
** Second derivation: three free bodies in absolute coordinates
**
** Coordinates q = (x, y of the centre of mass, angle) of links 2, 3, 4.  Eight constraints, two
** for each pin (of the piston: its height and its angle), and the crank's angle as the ninth,
** C(q) = 0.  Then
**
**    J q' = (0 ... 0, omega2),   J q" = gamma,   M q" = Q + J^T lambda
**
** and the multipliers are the forces of the constraints.
** ------------------------------------------------------------------------------------------- */

/* Gaussian elimination with partial pivoting; x replaces b. */
static void eliminate(double A[9][9], double b[9])
{
    int i, j, k;

    for (k = 0; k < 9; k++) {
        int pivot = k;

        for (i = k + 1; i < 9; i++)
            if (fabs(A[i][k]) > fabs(A[pivot][k]))
                pivot = i;
        for (j = 0; j < 9; j++) {
            double swap = A[k][j];

            A[k][j] = A[pivot][j];
            A[pivot][j] = swap;
        }
        {
            double swap = b[k];

            b[k] = b[pivot];
            b[pivot] = swap;
        }
        for (i = k + 1; i < 9; i++) {
            double factor = A[i][k] / A[k][k];

            for (j = k; j < 9; j++)
                A[i][j] -= factor * A[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (k = 8; k >= 0; k--) {
        for (j = k + 1; j < 9; j++)
            b[k] -= A[k][j] * b[j];
        b[k] /= A[k][k];
    }
}

typedef struct constraints {
    double C[9], J[9][9], gamma[9];
} constraints;

/* Add sign * (the point of a body) to the two constraints of a pin.  The body's point is given in
** the link's axes; q is the centre of mass. */
static void add_point(constraints *c, int row, int link, const fourlink_design *design,
                      const double q[9], const double speed[9], double sign, double x, double y)
{
    const double *body = q + 3 * (link - 2);
    double px = x - design->link[link].cg.x, py = y - design->link[link].cg.y;
    double rx = px * cos(body[2]) - py * sin(body[2]), ry = px * sin(body[2]) + py * cos(body[2]);
    double rate = speed[3 * (link - 2) + 2];
    int column = 3 * (link - 2);

    c->C[row] += sign * (body[0] + rx);
    c->C[row + 1] += sign * (body[1] + ry);
    c->J[row][column] += sign;
    c->J[row][column + 2] -= sign * ry;
    c->J[row + 1][column + 1] += sign;
    c->J[row + 1][column + 2] += sign * rx;
    c->gamma[row] += sign * rate * rate * rx;
    c->gamma[row + 1] += sign * rate * rate * ry;
}

static void constrain(const fourlink_design *design, const double q[9], const double speed[9],
                      const fourlink_crank *crank, constraints *c)
{
    const fourlink_link *link = design->link;

    memset(c, 0, sizeof *c);
    add_point(c, 0, 2, design, q, speed, 1, 0, 0);
    add_point(c, 2, 3, design, q, speed, 1, 0, 0);
    add_point(c, 2, 2, design, q, speed, -1, link[2].length, 0);
    if (design->kind == FOURLINK_FOUR_BAR) {
        add_point(c, 4, 4, design, q, speed, 1, link[4].length, 0);
        add_point(c, 4, 3, design, q, speed, -1, link[3].length, 0);
        add_point(c, 6, 4, design, q, speed, 1, 0, 0);
        c->C[6] -= link[1].length;
    } else {
        constraints piston;

        add_point(c, 4, 4, design, q, speed, 1, 0, 0);
        add_point(c, 4, 3, design, q, speed, -1, link[3].length, 0);
        memset(&piston, 0, sizeof piston);
        add_point(&piston, 0, 4, design, q, speed, 1, 0, 0);
        c->C[6] = q[8];
        c->J[6][8] = 1;
        c->C[7] = piston.C[1] - design->offset;
        memcpy(c->J[7], piston.J[1], sizeof c->J[7]);
        c->gamma[7] = piston.gamma[1];
    }
    c->C[8] = q[2] - crank->theta2;
    c->J[8][2] = 1;
    c->gamma[8] = crank->alpha2;
}

/* Newton's iteration towards C(q) = 0 from a position near by. */
static void assemble(const fourlink_design *design, const fourlink_crank *crank, double q[9])
{
    static const double rest[9] = {0};
    double step = 1;
    int n, i;

    for (n = 0; n < 20 && step > 1e-13; n++) {
        constraints c;

        constrain(design, q, rest, crank, &c);
        eliminate(c.J, c.C);
        step = 0;
        for (i = 0; i < 9; i++) {
            q[i] -= c.C[i];
            step = fmax(step, fabs(c.C[i]));
        }
    }
    assert_true(step <= 1e-11);
}

/* The position of a sample, from the angles of its links moved by `shift`. */
static void assemble_sample(const sample *s, double shift, double q[9])
{
    int link;

    for (link = 2; link <= 4; link++) {
        double theta = s->state.link[link].theta + (link > 2 ? shift : 0);
        fourlink_vector cg = s->design.link[link].cg, origin = s->state.link[link].origin;

        q[3 * link - 6] = origin.x + shift + cg.x * cos(theta) - cg.y * sin(theta);
        q[3 * link - 5] = origin.y - shift + cg.x * sin(theta) + cg.y * cos(theta);
        q[3 * link - 4] = theta;
    }
    assemble(&s->design, &s->crank, q);
}

/* Weights and loads as generalised forces at a position. */
static void generalised(const sample *s, const double q[9], double Q[9])
{
    unsigned long n;
    int i;

    for (i = 0; i < 3; i++) {
        Q[3 * i] = s->design.link[i + 2].mass * s->design.gravity.x;
        Q[3 * i + 1] = s->design.link[i + 2].mass * s->design.gravity.y;
        Q[3 * i + 2] = 0;
    }
    for (n = 0; n < s->n_loads; n++) {
        const fourlink_load *load = &s->load[n];
        int at = 3 * (load->link - 2);
        double c = cos(q[at + 2]), z = sin(q[at + 2]);
        double px = load->at.x - s->design.link[load->link].cg.x;
        double py = load->at.y - s->design.link[load->link].cg.y;
        double Fx = load->force.x, Fy = load->force.y;

        if (load->frame == FOURLINK_FRAME_LINK) {
            Fx = load->force.x * c - load->force.y * z;
            Fy = load->force.x * z + load->force.y * c;
        }
        Q[at] += Fx;
        Q[at + 1] += Fy;
        Q[at + 2] += (px * c - py * z) * Fy - (px * z + py * c) * Fx + load->torque;
    }
}

static void solve_with_multipliers(const sample *s, const double q[9], fourlink_forces *f)
{
    static const double rest[9] = {0};
    double speed[9] = {0}, b[9], Q[9], T[9][9];
    constraints c;
    int i, j;

    constrain(&s->design, q, rest, &s->crank, &c);
    speed[8] = s->crank.omega2;
    eliminate(c.J, speed);
    constrain(&s->design, q, speed, &s->crank, &c);
    memcpy(b, c.gamma, sizeof b);
    for (i = 0; i < 9; i++)
        for (j = 0; j < 9; j++)
            T[j][i] = c.J[i][j];
    eliminate(c.J, b);
    generalised(s, q, Q);
    for (i = 0; i < 9; i++) {
        const fourlink_link *link = &s->design.link[i / 3 + 2];

        b[i] = (i % 3 == 2 ? link->inertia : link->mass) * b[i] - Q[i];
    }
    eliminate(T, b);
    memset(f, 0, sizeof *f);
    f->F12x = b[0];
    f->F12y = b[1];
    f->F23x = b[2];
    f->F23y = b[3];
    f->F34x = b[4];
    f->F34y = b[5];
    f->F14y = b[7];
    f->Ts = b[8];
    if (s->design.kind == FOURLINK_FOUR_BAR)
        f->F14x = b[6];
    else
        f->M14 = b[6];
}

TEST(test_multipliers)
{
    uint64_t seed = 1;
    int n;

    for (n = 0; n < 4000; n++) {
        double q[9], arm, sine, tolerance;
        fourlink_forces expected;
        sample s;

        draw(&seed, n, 0.03, &s);
        assemble_sample(&s, 1e-4 * s.state.sine * s.state.sine, q);
        solve_with_multipliers(&s, q, &expected);
        arm = s.design.link[2].length;
        sine = fabs(s.state.sine);
        /* the position, the accelerations and the forces each lose 1/sine */
        tolerance = 2e-13 / sine * largest(&expected, arm);
        assert_near(remainder(s.state.link[3].theta - q[5], 2 * PI), 0, 2e-14 / sine);
        assert_near(remainder(s.state.link[4].theta - q[8], 2 * PI), 0, 2e-14 / sine);
        assert_same_forces(&s.forces, &expected, arm, tolerance);
        assert_near(s.forces.Ts_work, expected.Ts, tolerance * arm);
    }
}

/* ---------------------------------------------------------------------------------------------
** Energy and momentum, from positions alone
** ------------------------------------------------------------------------------------------- */

/* Central differences of order h^4, from f(-2h) ... f(2h). */
static double first(double a, double b, double d, double e, double h)
{
    return (8 * (d - b) - (e - a)) / (12 * h);
}

static double second(double a, double b, double c, double d, double e, double h)
{
    return (16 * (b + d - 2 * c) - (a + e - 2 * c)) / (12 * h * h);
}

/* A step of the crank angle, small beside the distance from a dead position. */
static double small_step(const sample *s)
{
    const fourlink_link *link = s->design.link;
    double slope = s->design.kind == FOURLINK_FOUR_BAR
                       ? 1 + 4 * link[1].length * link[2].length / (link[3].length * link[4].length)
                       : 1 + 4 * link[2].length / link[3].length;

    return 0.02 * s->state.sine * s->state.sine / slope;
}

/* The kinetic energy is I(theta2) omega2^2/2, I from the derivatives of the positions, and the
** power Ts omega2 + Q.q' its rate of change: Ts = I alpha2 + I' omega2^2/2 - Q.dq/dtheta2. */
TEST(test_energy)
{
    enum { N = 9 };
    uint64_t seed = 2;
    int n, i, k;

    for (n = 0; n < 3000; n++) {
        double q[N][9], Q[9], inertia[N] = {0}, power = 0, slope, Ts, scale, h, reduced;
        sample s;

        draw(&seed, n, 0.2, &s);
        h = small_step(&s);
        for (i = 0; i < N; i++) {
            sample near = s;

            near.crank.theta2 += (i - N / 2) * h;
            if (i > 0)
                memcpy(q[i], q[i - 1], sizeof q[i]);
            assemble_sample(&near, 0, q[i]);
        }
        for (i = 2; i < N - 2; i++)
            for (k = 0; k < 9; k++) {
                const fourlink_link *link = &s.design.link[k / 3 + 2];
                double rate = first(q[i - 2][k], q[i - 1][k], q[i + 1][k], q[i + 2][k], h);

                inertia[i] += (k % 3 == 2 ? link->inertia : link->mass) * rate * rate;
                if (i == N / 2) {
                    generalised(&s, q[i], Q);
                    power += Q[k] * rate;
                }
            }
        reduced = inertia[N / 2];
        slope = first(inertia[2], inertia[3], inertia[5], inertia[6], h);
        Ts = reduced * s.crank.alpha2 + slope * s.crank.omega2 * s.crank.omega2 / 2 - power;
        /* The outer points are 4/50 of the way to a singularity: truncation 1e-6 of the distance
        ** to the fourth power; rounding, eps/(h^2 sine), stays below it. */
        scale = reduced * (fabs(s.crank.alpha2) +
                           s.crank.omega2 * s.crank.omega2 / (s.state.sine * s.state.sine)) +
                largest(&s.forces, s.design.link[2].length) + 1;
        assert_near(s.forces.Ts, Ts, 2e-7 * scale);
        assert_near(s.forces.Ts_work, Ts, 2e-7 * scale);
    }
}

/* For each link, the forces on it change its momentum, and their moments about the far pin its
** moment of momentum: accelerations by second differences of the assembled positions in time. */
TEST(test_momentum)
{
    uint64_t seed = 3;
    int n, i, k, link;

    for (n = 0; n < 3000; n++) {
        const fourlink_forces *f;
        double q[5][9], a[9], Q[9], t, scale, speed, length;
        double Bx, By, Cx, Cy, far_x[3], far_y[3];
        sample s;

        draw(&seed, n, 0.2, &s);
        f = &s.forces;
        t = small_step(&s) / (fabs(s.crank.omega2) + sqrt(fabs(s.crank.alpha2)));
        for (i = 0; i < 5; i++) {
            sample near = s;
            double time = (i - 2) * t;

            near.crank.theta2 += (s.crank.omega2 + s.crank.alpha2 * time / 2) * time;
            assemble_sample(&near, 0, q[i]);
        }
        for (k = 0; k < 9; k++)
            a[k] = second(q[0][k], q[1][k], q[2][k], q[3][k], q[4][k], t);
        generalised(&s, q[2], Q);

        length = s.design.link[3].length;
        Bx = s.design.link[2].length * cos(s.crank.theta2);
        By = s.design.link[2].length * sin(s.crank.theta2);
        Cx = Bx + length * cos(q[2][5]);
        Cy = By + length * sin(q[2][5]);
        speed = 1 + s.design.link[2].length / (0.3 * fabs(s.state.sine));
        scale = largest(f, s.design.link[2].length) +
                5 * (s.crank.omega2 * s.crank.omega2 * speed * speed + 30 * speed);
        /* far pins: B of the crank, C of the coupler, D of the rocker; of the piston, A */
        far_x[0] = Bx;
        far_y[0] = By;
        far_x[1] = Cx;
        far_y[1] = Cy;
        far_x[2] = s.design.kind == FOURLINK_FOUR_BAR ? s.design.link[1].length : 0;
        far_y[2] = 0;
        for (link = 0; link < 3; link++) {
            const fourlink_link *data = &s.design.link[link + 2];
            const double *at = &a[3 * link], *known = &Q[3 * link], *G = &q[2][3 * link];
            double X, Y, M, gx = G[0] - far_x[link], gy = G[1] - far_y[link];

            switch (link) {
            case 0:
                X = f->F12x - f->F23x;
                Y = f->F12y - f->F23y;
                M = f->Ts - Bx * f->F12y + By * f->F12x;
                break;
            case 1:
                X = f->F23x - f->F34x;
                Y = f->F23y - f->F34y;
                M = (Bx - Cx) * f->F23y - (By - Cy) * f->F23x;
                break;
            default:
                X = f->F34x + f->F14x;
                Y = f->F34y + f->F14y;
                M = (Cx - far_x[2]) * f->F34y - Cy * f->F34x + f->M14;
                if (s.design.kind == FOURLINK_SLIDER_CRANK)
                    M += Cx * f->F14y - Cy * f->F14x;
            }
            X += known[0];
            Y += known[1];
            M += known[2] + gx * known[1] - gy * known[0];
            assert_near(X, data->mass * at[0], 1e-7 * scale);
            assert_near(Y, data->mass * at[1], 1e-7 * scale);
            assert_near(M, data->inertia * at[2] + data->mass * (gx * at[1] - gy * at[0]),
                        1e-7 * scale);
        }
    }
}

/* ---------------------------------------------------------------------------------------------
** Engines
** ------------------------------------------------------------------------------------------- */

static void engine(sample *s, double r, double l, double rod_mass, double k, double big_end_to_cg,
                   double piston_mass, double theta2, double rpm)
{
    memset(s, 0, sizeof *s);
    s->design.kind = FOURLINK_SLIDER_CRANK;
    s->design.link[2].length = r;
    s->design.link[3].length = l;
    s->design.link[3].mass = rod_mass;
    s->design.link[3].inertia = rod_mass * k * k;
    s->design.link[3].cg.x = big_end_to_cg;
    s->design.link[4].mass = piston_mass;
    s->branch = FOURLINK_OPEN;
    s->crank.theta2 = theta2;
    s->crank.omega2 = 2 * PI * rpm / 60;
}

/* The rod's mass split between its ends, with the couple that corrects its moment of inertia
** (ME3491, DFA), in exact form: the torque of any engine, its line of stroke inclined by gamma. */
TEST(test_analytical_method)
{
    uint64_t seed = 4;
    int n;

    for (n = 0; n < 3000; n++) {
        double r, l, e, b, k, g, gamma, gas, theta, omega, alpha, side;
        double c, z, phi, dphi, ddphi, dX, ddX, ma, mb, L, F, delivered, scale;
        sample s;

        do {
            r = uniform(&seed, 0.05, 0.5);
            l = uniform(&seed, 0.05, 2);
            e = uniform(&seed, -0.2, 0.2);
            theta = uniform(&seed, -PI, PI);
        } while (fabs(r * sin(theta) - e) > 0.95 * l);
        b = uniform(&seed, 0.05, 1) * l;
        k = uniform(&seed, 0.05, 1);
        g = 9.81;
        gamma = uniform(&seed, 0, 2 * PI);
        gas = uniform(&seed, -1e4, 1e4);
        alpha = uniform(&seed, -1000, 1000);
        engine(&s, r, l, uniform(&seed, 0, 10), k, l - b, uniform(&seed, 0, 10), theta,
               uniform(&seed, -3000, 3000));
        omega = s.crank.omega2;
        s.crank.alpha2 = alpha;
        s.branch = n % 2 ? FOURLINK_OPEN : FOURLINK_CROSSED;
        side = n % 2 ? 1 : -1;
        s.design.offset = e;
        s.design.gravity.x = -g * sin(gamma);
        s.design.gravity.y = -g * cos(gamma);
        s.load[0].link = FOURLINK_FOLLOWER;
        s.load[0].force.x = gas;
        s.n_loads = 1;
        assert_int_equal(solve(&s), FOURLINK_OK);

        c = cos(theta);
        z = sin(theta);
        phi = asin((r * z - e) / l);
        dphi = r * c / (l * cos(phi));
        /* derivatives of l sin(phi) = r sin(theta) - e, and of X = r cos(theta) + l cos(phi) */
        ddphi = (r * (alpha * c - omega * omega * z) / l + dphi * dphi * omega * omega * sin(phi)) /
                cos(phi);
        dX = -r * z - side * l * sin(phi) * dphi;
        ddX = -r * (alpha * z + omega * omega * c) -
              side * l * (sin(phi) * ddphi + cos(phi) * dphi * dphi * omega * omega);
        mb = s.design.link[3].mass * (l - b) / l;
        ma = s.design.link[3].mass * b / l;
        L = b + k * k / b;
        F = gas - (s.design.link[4].mass + mb) * (ddX + g * sin(gamma));
        delivered = F * dX + s.design.link[3].mass * b * (l - L) * ddphi * dphi -
                    ma * g * r * cos(theta + gamma) - ma * r * r * alpha;
        scale = fabs(F * dX) + fabs(s.design.link[3].mass * b * (l - L) * ddphi * dphi) +
                fabs(s.design.link[4].mass + mb) * fabs(ddX * dX) + ma * r * (g + r * fabs(alpha)) +
                s.design.link[3].mass * omega * omega * r * r;
        assert_near(s.forces.Ts, -delivered, 1e-14 * scale / (cos(phi) * cos(phi)));

        assert_near(s.state.mu, PI / 2 - fabs(phi), 1e-14 / cos(phi));
        assert_near(s.state.link[4].velocity.x, dX * omega,
                    1e-14 * (1 + r * fabs(omega)) / (cos(phi) * cos(phi)));
        assert_near(s.state.v, -side * s.state.link[4].velocity.x, 0);
        assert_near(s.state.a, -side * s.state.link[4].acceleration.x, 0);
        if (r + l > fabs(e))
            assert_near(s.state.x,
                        sqrt((r + l) * (r + l) - e * e) - side * (r * c + side * l * cos(phi)),
                        1e-14 / cos(phi));
    }
}

/* The obliquity bridges the height of the crank pin over the line of stroke, and no more than a
** right angle: l sin(phi) = r sin(theta2) - e, on both branches. */
TEST(test_obliquity)
{
    uint64_t seed = 13;
    int n;

    for (n = 0; n < 2000; n++) {
        double height;
        sample s;

        draw(&seed, 1, 1e-3, &s);
        height = s.design.link[2].length * sin(s.crank.theta2) - s.design.offset;
        assert_near(s.design.link[3].length * sin(s.state.phi), height, 1e-14);
        assert_near(cos(s.state.phi), fabs(s.state.sine), 1e-14);
        assert_near(fabs(s.state.phi) + s.state.mu, PI / 2, 1e-15);
    }
}

static int slider_crank(double r, double l, double e, fourlink_branch branch, double theta2,
                        sample *s)
{
    engine(s, r, l, 0, 0, 0, 0, theta2, 60 / (2 * PI));
    s->design.offset = e;
    s->branch = branch;
    return solve(s);
}

/* r = l: the rod mirrors the crank, X = 2 r cos(theta2), or (crossed) turns with it and the piston
** stays over A. */
TEST(test_equal_lengths)
{
    sample s;
    int i;

    for (i = 0; i < 1920; i++) {
        double theta2 = (-719.875 + i * 0.75) * DEG;
        double tolerance = 1e-14 / fabs(cos(theta2));

        assert_int_equal(slider_crank(0.3, 0.3, 0, FOURLINK_OPEN, theta2, &s), FOURLINK_OK);
        assert_near(s.state.link[4].origin.x, 0.6 * cos(theta2), tolerance);
        assert_near(s.state.link[4].velocity.x, -0.6 * sin(theta2), tolerance);
        assert_near(remainder(s.state.link[3].theta + theta2, 2 * PI), 0, tolerance);
        assert_int_equal(slider_crank(0.3, 0.3, 0, FOURLINK_CROSSED, theta2, &s), FOURLINK_OK);
        assert_near(s.state.link[4].origin.x, 0, tolerance);
        assert_near(s.state.link[3].omega, 1, tolerance / fabs(cos(theta2)));
    }
}

/* One change point, at +90 deg (l + e = r) or at -90 deg: the piston passes it without a jump, each
** step of it that of the trapezoidal rule, and is on the other side after one revolution. */
TEST(test_one_change_point)
{
    static const struct {
        double r, l, e;
        int degree;
    } lengths[] = {{1, 3, -2, 90}, {0.1, 0.3, -0.2, 90}, {1, 3, 2, -90}, {0.1, 0.3, 0.2, -90}};
    const double step = 0.125 * DEG;
    size_t k;
    int i, crossed;

    for (k = 0; k < COUNT(lengths); k++)
        for (crossed = 0; crossed < 2; crossed++) {
            double r = lengths[k].r, l = lengths[k].l, e = lengths[k].e;
            fourlink_branch branch = crossed ? FOURLINK_CROSSED : FOURLINK_OPEN;
            fourlink_branch other = crossed ? FOURLINK_OPEN : FOURLINK_CROSSED;
            sample s, before;

            assert_int_equal(slider_crank(r, l, e, branch, 0, &s), FOURLINK_OK);
            assert_true((s.state.link[4].origin.x > r) == !crossed);
            assert_int_equal(slider_crank(r, l, e, branch, -720 * DEG - step / 2, &before),
                             FOURLINK_OK);
            for (i = 0; i < 4 * 360 * 8; i++) {
                double theta2 = -720 * DEG + (i + 0.5) * step;

                assert_int_equal(slider_crank(r, l, e, branch, theta2, &s), FOURLINK_OK);
                assert_near(s.state.link[4].origin.x - before.state.link[4].origin.x,
                            step / 2 *
                                (s.state.link[4].velocity.x + before.state.link[4].velocity.x),
                            r * step * step * step);
                before = s;
            }
            for (i = 1; i < 50; i++) {
                double theta2 = i * 7.1 * DEG;

                assert_int_equal(slider_crank(r, l, e, branch, theta2 + 2 * PI, &before),
                                 FOURLINK_OK);
                assert_int_equal(slider_crank(r, l, e, other, theta2, &s), FOURLINK_OK);
                assert_near(before.state.link[4].origin.x, s.state.link[4].origin.x,
                            1e-14 / fabs(s.state.sine));
            }
            for (i = -720; i <= 720; i += 360) {
                assert_int_equal(slider_crank(r, l, e, branch, (lengths[k].degree + i) * DEG, &s),
                                 FOURLINK_CHANGE_POINT);
                assert_int_equal(slider_crank(r, l, e, branch, (-lengths[k].degree + i) * DEG, &s),
                                 FOURLINK_OK);
            }
        }
}

/* Whole millimetres, as in the test of the four-bar. */
TEST(test_change_points_of_decimal_lengths)
{
    uint64_t seed = 15;
    int n, tested = 0;

    for (n = 0; n < 20000; n++) {
        int r = (int)uniform(&seed, 5, 1000), l = (int)uniform(&seed, 5, 1000);
        int e = n % 2 ? r - l : l - r;
        sample s;

        memset(&s, 0, sizeof s);
        s.design.kind = FOURLINK_SLIDER_CRANK;
        s.design.link[2].length = r * 0.001;
        s.design.link[3].length = l * 0.001;
        s.design.offset = e * 0.001;
        assert_int_equal(fourlink_prepare(&s.design, &s.mechanism), FOURLINK_OK);
        assert_int_equal(s.mechanism.change_stretched, l + e == r);
        assert_int_equal(s.mechanism.change_folded, l - e == r);
        tested++;
    }
    assert_true(tested > 5000);
}

/* The rod reaches while |r sin(theta2) - e| <= l. */
TEST(test_rod_too_short)
{
    const double r = 1, l = 0.8, e = 0.1, limit = asin(0.9), lower = asin(-0.7);
    int crossed;
    sample s;

    for (crossed = 0; crossed < 2; crossed++) {
        fourlink_branch branch = crossed ? FOURLINK_CROSSED : FOURLINK_OPEN;

        assert_int_equal(slider_crank(r, l, e, branch, limit, &s), FOURLINK_DEAD_POSITION);
        assert_int_equal(slider_crank(r, l, e, branch, PI - limit, &s), FOURLINK_DEAD_POSITION);
        assert_int_equal(slider_crank(r, l, e, branch, lower, &s), FOURLINK_DEAD_POSITION);
        assert_int_equal(slider_crank(r, l, e, branch, limit + 1e-9, &s), FOURLINK_ROD_TOO_SHORT);
        assert_int_equal(slider_crank(r, l, e, branch, lower - 1e-9, &s), FOURLINK_ROD_TOO_SHORT);
        assert_int_equal(slider_crank(r, l, e, branch, PI / 2, &s), FOURLINK_ROD_TOO_SHORT);
        assert_int_equal(slider_crank(r, l, e, branch, limit - 1e-9, &s), FOURLINK_OK);
        assert_int_equal(slider_crank(r, l, e, branch, lower + 1e-9, &s), FOURLINK_OK);
    }
}

/* Within the range of numbers, nothing overflows. */
TEST(test_extreme_numbers)
{
    uint64_t seed = 14;
    int n, solved = 0;

    for (n = 0; n < 20000; n++) {
        sample s;

        draw_extreme(&seed, n, &s);
        if (solve(&s) != FOURLINK_OK)
            continue;
        solved++;
        assert_finite(&s.forces);
    }
    assert_true(solved > 2000);
}

/* ---------------------------------------------------------------------------------------------
** Identities
** ------------------------------------------------------------------------------------------- */

/* Loads and weights at rest, and inertia alone, add up to both together. */
TEST(test_superposition)
{
    uint64_t seed = 5;
    int n, i;

    for (n = 0; n < 3000; n++) {
        double a[N_FORCES], b[N_FORCES], sum[N_FORCES], arm, scale;
        sample s, at_rest, bare;

        draw(&seed, n, 1e-3, &s);
        at_rest = s;
        at_rest.crank.omega2 = at_rest.crank.alpha2 = 0;
        bare = s;
        bare.design.gravity.x = bare.design.gravity.y = 0;
        bare.n_loads = 0;
        assert_int_equal(solve(&at_rest), FOURLINK_OK);
        assert_int_equal(solve(&bare), FOURLINK_OK);
        arm = s.design.link[2].length;
        list(&at_rest.forces, arm, a);
        list(&bare.forces, arm, b);
        list(&s.forces, arm, sum);
        scale = largest(&at_rest.forces, arm) + largest(&bare.forces, arm);
        /* the three solutions have one matrix; each is backward stable */
        for (i = 0; i < N_FORCES; i++)
            assert_near(sum[i], a[i] + b[i], 2e-14 / fabs(s.state.sine) * scale);
    }
}

TEST(test_residual)
{
    uint64_t seed = 6;
    int n;

    for (n = 0; n < 20000; n++) {
        sample s;

        draw(&seed, n, 1e-5, &s);
        assert_near(s.forces.residual, 0, 300 * EPS / fabs(s.state.sine));
        assert_near(s.forces.Ts_work, s.forces.Ts,
                    300 * EPS / fabs(s.state.sine) * largest(&s.forces, 1));
    }
}

/* Links of 1 mm to 10 m, 1 g to 1 t, with centres of mass far beyond them, loads of 10 mN to 10 kN, from
** rest to 1000 rad/s. */
static void draw_uneven(uint64_t *seed, long n, sample *s)
{
    int i;

    memset(s, 0, sizeof *s);
    s->design.kind = n % 2 ? FOURLINK_SLIDER_CRANK : FOURLINK_FOUR_BAR;
    for (i = 1; i <= 4; i++) {
        fourlink_link *link = &s->design.link[i];

        link->length = pow(10, uniform(seed, -3, 1));
        link->mass = pow(10, uniform(seed, -3, 3));
        link->inertia = link->mass * pow(10, uniform(seed, -6, 1));
        link->cg.x = link->length * uniform(seed, -3, 3);
        link->cg.y = link->length * uniform(seed, -3, 3);
    }
    s->design.offset = n % 2 ? s->design.link[2].length * uniform(seed, -0.5, 0.5) : 0;
    s->design.gravity.y = n % 3 ? -9.81 : 0;
    s->branch = uniform(seed, 0, 1) < 0.5 ? FOURLINK_OPEN : FOURLINK_CROSSED;
    s->crank.theta2 = uniform(seed, -PI, PI);
    s->crank.omega2 = n % 5 ? pow(10, uniform(seed, -2, 3)) : 0;
    s->crank.alpha2 = n % 4 ? 0 : pow(10, uniform(seed, -2, 3));
    s->n_loads = (unsigned long)uniform(seed, 0, 3);
    for (i = 0; i < 2; i++) {
        double size = pow(10, uniform(seed, -2, 4)), direction = uniform(seed, -PI, PI);

        s->load[i].link = (int)uniform(seed, 2, 5);
        s->load[i].force.x = size * cos(direction);
        s->load[i].force.y = size * sin(direction);
        s->load[i].at.x = uniform(seed, -2, 2);
        s->load[i].at.y = uniform(seed, -2, 2);
        s->load[i].torque = n % 7 ? 0 : uniform(seed, -100, 100);
    }
}

/* The largest residual of so many rows, in rounding units times 1/sin(mu); and how many are over 300. */
static double try_residuals(long rows, long *over)
{
    double worst = 0;
    uint64_t seed = 673;
    long n, tried = 0;

    *over = 0;
    for (n = 0; tried < rows; n++) {
        double size;
        sample s;

        draw_uneven(&seed, n, &s);
        if (solve(&s) != FOURLINK_OK)
            continue;
        tried++;
        size = fabs(s.forces.residual * s.state.sine) / EPS;
        *over += size > 300;
        worst = fmax(worst, size);
    }
    return worst;
}

TEST(test_residual_of_uneven_links)
{
    long over;

    assert_in_range((unsigned long)try_residuals(some_of(100000), &over), 0,
                    (unsigned long)some_of(300));
    assert_int_equal(over, 0);
}

/* A balanced crank at constant speed, its centre of mass off its line: each term of the balance is what
** rounding leaves of a right angle, and the residual is its rounding still. */
TEST(test_residual_of_a_balance)
{
    fourlink_design design;
    fourlink_mechanism mechanism;
    fourlink_forces forces;
    fourlink_state state;
    int i;

    memset(&design, 0, sizeof design);
    design.kind = FOURLINK_FOUR_BAR;
    design.link[1].length = 0.080;
    design.link[2].length = 0.020;
    design.link[3].length = 0.066;
    design.link[4].length = 0.056;
    design.link[2].mass = 1;
    design.link[2].cg.x = 0.0069;
    design.link[2].cg.y = 0.0012;
    assert_int_equal(fourlink_prepare(&design, &mechanism), FOURLINK_OK);
    for (i = 0; i < 720; i++) {
        fourlink_crank crank = {0, 10, 0};

        crank.theta2 = i * 0.5 * DEG;
        assert_int_equal(
            fourlink_analyse(&mechanism, FOURLINK_OPEN, &crank, NULL, 0, &state, &forces),
            FOURLINK_OK);
        assert_near(forces.residual, 0, 10 * EPS);
        assert_int_equal(
            fourlink_analyse_dyad(&mechanism, FOURLINK_OPEN, &crank, NULL, 0, &state, &forces),
            FOURLINK_OK);
        assert_near(forces.residual, 0, 10 * EPS);
    }
}

/* The couple of the guide has the size of a force times the length of the rod, however long that is. */
TEST(test_scale_of_the_couple)
{
    double size;

    for (size = 1e-12; size < 1e13; size *= 10) {
        fourlink_state state;
        fourlink_forces forces;
        sample s;

        engine(&s, size, 4 * size, 0, 0, 0, 3, 1, 10);
        s.design.link[4].cg.y = size;
        s.design.gravity.x = s.design.gravity.y = 0;
        assert_int_equal(solve(&s), FOURLINK_OK);
        assert_int_equal(
            fourlink_analyse_dyad(&s.mechanism, s.branch, &s.crank, NULL, 0, &state, &forces),
            FOURLINK_OK);
        /* a_G x m, of a body that does not turn */
        assert_near(s.forces.M14, 3 * state.a * size * (double)s.branch,
                    1e-13 * fabs(3 * state.a * size));
        assert_near(forces.M14, s.forces.M14, 1e-13 * fabs(s.forces.M14));
    }
}

/* Two links far longer than the others: the position keeps its digits, but for the square of the ratio, or
** is refused. */
TEST(test_unequal_links)
{
    uint64_t seed = 77;
    int n, found = 0, lost = 0;

    for (n = 0; n < 20000; n++) {
        fourlink_design design;
        fourlink_mechanism mechanism;
        fourlink_state state;
        double ratio = pow(10, uniform(&seed, 0, 15)), b = uniform(&seed, 0.5, 2), theta2;
        int status;

        memset(&design, 0, sizeof design);
        design.kind = FOURLINK_FOUR_BAR;
        design.link[1].length = ratio;
        design.link[2].length = ratio * (1 + uniform(&seed, -1, 1) / ratio);
        design.link[3].length = b;
        design.link[4].length = 1;
        theta2 = uniform(&seed, -3, 3) / ratio;
        assert_int_equal(fourlink_prepare(&design, &mechanism), FOURLINK_OK);
        status = fourlink_position(&mechanism, FOURLINK_OPEN, theta2, &state);
        lost += status == FOURLINK_LOST_IN_ROUNDING;
        found += status == FOURLINK_OK;
        if (status == FOURLINK_OK)
            for (int i = 3; i < 5; i++)
                assert_near(hypot(state.link[i].axis.x, state.link[i].axis.y), 1,
                            1e-7 / state.sine / state.sine);
    }
    assert_true(found > 3000 && lost > 3000);
}

/* A mechanism that was not prepared, a state that was not filled. */
TEST(test_not_filled)
{
    static const double no_numbers[] = {NAN, INFINITY, -INFINITY};
    fourlink_mechanism none;
    fourlink_state state;
    fourlink_forces forces, before;
    uint64_t seed = 3;
    size_t i;
    int field;

    memset(&none, 0, sizeof none);
    assert_int_equal(fourlink_position(&none, FOURLINK_OPEN, 1, &state), FOURLINK_BAD_KIND);
    memset(&before, 0xa5, sizeof before);
    for (i = 0; i < 3; i++)
        for (field = 0; field < 6; field++) {
            int status;
            sample s;

            draw(&seed, (int)i, 0.1, &s);
            s.design.link[3].mass = s.design.link[3].inertia = 1;
            assert_int_equal(solve(&s), FOURLINK_OK);
            *(field == 0   ? &s.state.link[3].alpha
              : field == 1 ? &s.state.link[3].acceleration.x
              : field == 2 ? &s.state.link[3].axis.x
              : field == 3 ? &s.state.link[3].omega
              : field == 4 ? &s.state.link[4].axis.y
                           : &s.state.link[2].alpha) = no_numbers[i];
            s.mechanism.design.link[2].inertia = 1;
            forces = before;
            status = fourlink_solve(&s.mechanism, &s.state, NULL, 0, &forces);
            assert_true(status == FOURLINK_BAD_NUMBER || status == FOURLINK_SINGULAR);
            status = fourlink_solve_dyad(&s.mechanism, &s.state, NULL, 0, &forces);
            assert_true(status == FOURLINK_BAD_NUMBER || status == FOURLINK_SINGULAR);
            assert_memory_equal(&forces, &before, sizeof forces);
        }
}

/* The residual compares two different computations: velocities that do not belong to the position
** show in it.  And it is 0, not 0/0, when nothing acts. */
TEST(test_residual_notices)
{
    uint64_t seed = 7;
    int n, noticed = 0;
    sample s;

    for (n = 0; n < 200; n++) {
        fourlink_forces forces;

        draw(&seed, n, 0.1, &s);
        s.state.link[3].k *= 1.01;
        assert_int_equal(fourlink_solve(&s.mechanism, &s.state, s.load, s.n_loads, &forces),
                         FOURLINK_OK);
        noticed += fabs(forces.residual) > 1e-6;
    }
    assert_true(noticed > 180);

    memset(&s, 0, sizeof s);
    s.design.kind = FOURLINK_FOUR_BAR;
    for (n = 1; n <= 4; n++)
        s.design.link[n].length = n == 2 ? 1 : 2;
    s.branch = FOURLINK_OPEN;
    s.crank.theta2 = 1;
    s.crank.omega2 = 3;
    assert_int_equal(solve(&s), FOURLINK_OK);
    assert_true(s.forces.residual == 0);
    assert_true(largest(&s.forces, 1) == 0);
}

/* ---------------------------------------------------------------------------------------------
** The nine equations
** ------------------------------------------------------------------------------------------- */

static fourlink_vector point_of(const fourlink_state *state, int link, double x, double y)
{
    fourlink_vector at, position;

    at.x = x;
    at.y = y;
    assert_int_equal(fourlink_point(state, link, &at, &position, NULL, NULL), FOURLINK_OK);
    return position;
}

/* The matrix as the header describes it: column by column, what a unit force does to the links it
** acts on, and its moment about their centres of mass. */
static void expected_matrix(const sample *s, double A[9][9])
{
    const fourlink_link *link = s->design.link;
    int slider = s->design.kind == FOURLINK_SLIDER_CRANK, joint, k;
    fourlink_vector pin[4], G[5];

    for (k = 2; k <= 4; k++)
        G[k] = point_of(&s->state, k, link[k].cg.x, link[k].cg.y);
    pin[0] = point_of(&s->state, 2, 0, 0);
    pin[1] = point_of(&s->state, 2, link[2].length, 0);
    pin[2] = point_of(&s->state, 3, link[3].length, 0);
    pin[3] = slider ? pin[2] : point_of(&s->state, 4, 0, 0);
    memset(A, 0, 81 * sizeof(double));
    for (joint = 0; joint < 4; joint++) { /* F12, F23, F34, F14 */
        int on = joint == 3 ? 4 : joint + 2, by = joint == 3 ? 1 : joint + 1, x = 2 * joint;

        for (k = 2; k <= 4; k++) {
            double sign = k == on ? 1 : k == by ? -1 : 0;

            A[3 * (k - 2)][x] = sign;
            A[3 * (k - 2) + 1][x + 1] = sign;
            A[3 * (k - 2) + 2][x] = -sign * (pin[joint].y - G[k].y);
            A[3 * (k - 2) + 2][x + 1] = sign * (pin[joint].x - G[k].x);
        }
    }
    if (slider) {
        A[6][6] = 0;
        A[8][6] = 1;
    }
    A[2][8] = 1;
}

/* The place of G at a crank angle, from the axes of the link and nothing else. */
static fourlink_vector centre_at(const sample *s, double theta2, int i)
{
    const fourlink_vector *cg = &s->design.link[i].cg;
    fourlink_state at;
    fourlink_vector G;

    assert_int_equal(fourlink_position(&s->mechanism, s->branch, theta2, &at), FOURLINK_OK);
    G.x = at.link[i].origin.x + cg->x * cos(at.link[i].theta) - cg->y * sin(at.link[i].theta);
    G.y = at.link[i].origin.y + cg->x * sin(at.link[i].theta) + cg->y * cos(at.link[i].theta);
    return G;
}

/* Bodies: the motion of G by differences of positions; the right-hand sides of the nine equations, and the
** power that the driving torque balances. */
TEST(test_bodies)
{
    uint64_t seed = 23;
    double h = 1e-4, A[9][9], b[9];
    int n, i;

    for (n = 0; n < 2000; n++) {
        fourlink_body body[FOURLINK_LINKS];
        double power = 0, size = 0;
        sample s;

        draw(&seed, n, 0.2, &s);
        assert_int_equal(fourlink_bodies(&s.mechanism, &s.state, s.load, s.n_loads, body),
                         FOURLINK_OK);
        assert_int_equal(fourlink_system(&s.mechanism, &s.state, s.load, s.n_loads, A, b),
                         FOURLINK_OK);
        for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++) {
            const fourlink_link *data = &s.design.link[i];
            const fourlink_link_state *link = &s.state.link[i];
            const fourlink_body *one = &body[i];
            double omega2 = s.crank.omega2, m = data->mass, *side = b + 3 * (i - 2);
            fourlink_vector before = centre_at(&s, s.crank.theta2 - h, i),
                            now = centre_at(&s, s.crank.theta2, i),
                            after = centre_at(&s, s.crank.theta2 + h, i);
            double kx = (after.x - before.x) / (2 * h), ky = (after.y - before.y) / (2 * h);
            double lx = (after.x - 2 * now.x + before.x) / (h * h),
                   ly = (after.y - 2 * now.y + before.y) / (h * h);
            double large = 1 + fabs(kx) + fabs(ky) + fabs(lx) + fabs(ly);
            double terms[4];
            int k;

            assert_near(one->arm.x, now.x - link->origin.x, 1e-12);
            assert_near(one->arm.y, now.y - link->origin.y, 1e-12);
            assert_near(one->k.x, kx, 2e-5 * large);
            assert_near(one->k.y, ky, 2e-5 * large);
            large *= 1 + fabs(s.crank.alpha2) + omega2 * omega2;
            assert_near(one->acceleration.x, kx * s.crank.alpha2 + lx * omega2 * omega2,
                        2e-4 * large);
            assert_near(one->acceleration.y, ky * s.crank.alpha2 + ly * omega2 * omega2,
                        2e-4 * large);
            large = 1e-12 * (1 + fabs(side[0]) + fabs(side[1]) + fabs(side[2]) + 500);
            assert_near(m * one->acceleration.x - one->weight.x - one->force.x, side[0], large);
            assert_near(m * one->acceleration.y - one->weight.y - one->force.y, side[1], large);
            assert_near(data->inertia * link->alpha - one->moment, side[2], large);
            terms[0] = one->weight.x * one->k.x + one->weight.y * one->k.y;
            terms[1] = -m * (one->acceleration.x * one->k.x + one->acceleration.y * one->k.y);
            terms[2] = -data->inertia * link->alpha * link->k;
            terms[3] = one->work;
            for (k = 0; k < 4; k++) {
                power += terms[k];
                size += fabs(terms[k]);
            }
        }
        assert_near(s.forces.Ts_work, -power, 1e-12 * (1 + size));
        assert_near(s.forces.Ts, -power, 1e-10 * (1 + size));
    }
}

TEST(test_system)
{
    uint64_t seed = 8;
    int n, i, j;

    for (n = 0; n < 3000; n++) {
        double A[9][9], expected[9][9], b[9], x[N_FORCES], q[9], Q[9], sum, scale;
        sample s;

        draw(&seed, n, 1e-3, &s);
        assert_int_equal(fourlink_system(&s.mechanism, &s.state, s.load, s.n_loads, A, b),
                         FOURLINK_OK);
        expected_matrix(&s, expected);
        for (i = 0; i < 9; i++)
            for (j = 0; j < 9; j++)
                assert_near(A[i][j], expected[i][j], 1e-14 / fabs(s.state.sine));

        list(&s.forces, 1, x);
        if (s.design.kind == FOURLINK_SLIDER_CRANK)
            x[6] = s.forces.M14;
        x[8] = s.forces.Ts;
        scale = 0;
        for (j = 0; j < 9; j++)
            scale = fmax(scale, fabs(x[j]));
        for (i = 0; i < 9; i++) {
            sum = 0;
            for (j = 0; j < 9; j++)
                sum += A[i][j] * x[j];
            assert_near(sum, b[i], 2e-14 * scale);
        }

        /* at rest, what is on the right is minus the known forces */
        s.crank.omega2 = s.crank.alpha2 = 0;
        assert_int_equal(solve(&s), FOURLINK_OK);
        assert_int_equal(fourlink_system(&s.mechanism, &s.state, s.load, s.n_loads, A, b),
                         FOURLINK_OK);
        for (i = 0; i < 3; i++) {
            fourlink_vector cg = s.design.link[i + 2].cg;
            fourlink_vector G = point_of(&s.state, i + 2, cg.x, cg.y);

            q[3 * i] = G.x;
            q[3 * i + 1] = G.y;
            q[3 * i + 2] = s.state.link[i + 2].theta;
        }
        generalised(&s, q, Q);
        for (i = 0; i < 9; i++)
            assert_near(b[i], -Q[i], 1e-12 / fabs(s.state.sine));
    }
}

/* ---------------------------------------------------------------------------------------------
** No allocation, no error handler
** ------------------------------------------------------------------------------------------- */

/* Under glibc the program may put its own allocator before the C library's, for itself and for the
** shared libraries alike.  A sanitizer has put its own there already. */
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) || \
    __has_feature(thread_sanitizer)
#define SANITIZED 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANITIZED 1
#endif

#if defined(__GLIBC__) && !defined(SANITIZED)
#define COUNTS_MEMORY

static volatile unsigned long allocations;

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t n, size_t size);
void *__libc_realloc(void *old, size_t size);
void __libc_free(void *old);

void *malloc(size_t size)
{
    allocations++;
    return __libc_malloc(size);
}

void *calloc(size_t n, size_t size)
{
    allocations++;
    return __libc_calloc(n, size);
}

void *realloc(void *old, size_t size)
{
    allocations++;
    return __libc_realloc(old, size);
}

void free(void *old)
{
    __libc_free(old);
}

TEST(test_no_allocation)
{
    unsigned long before = allocations;
    uint64_t seed = 9;
    int n;

    gsl_vector_free(gsl_vector_alloc(9));
    assert_true(allocations > before); /* the counter sees what GSL allocates */
    for (n = 0; n < 200; n++) {
        double A[9][9], b[9];
        fourlink_body body[FOURLINK_LINKS];
        sample s;
        int status;

        draw(&seed, n, 0, &s);
        before = allocations;
        status = fourlink_prepare(&s.design, &s.mechanism);
        status |= fourlink_analyse(&s.mechanism, s.branch, &s.crank, s.load, s.n_loads, &s.state,
                                   &s.forces);
        status |= fourlink_solve(&s.mechanism, &s.state, s.load, s.n_loads, &s.forces);
        status |= fourlink_system(&s.mechanism, &s.state, s.load, s.n_loads, A, b);
        status |= fourlink_bodies(&s.mechanism, &s.state, s.load, s.n_loads, body);
        assert_int_equal(allocations, before);
        assert_int_equal(status, FOURLINK_OK);
    }
}
#endif

/* Two links in one line: no position gives such a state, but a caller may. */
static void singular_state(fourlink_kind kind, sample *s)
{
    static const fourlink_vector along = {1, 0}, across = {0, 1};
    int link;

    memset(s, 0, sizeof *s);
    s->design.kind = kind;
    s->design.link[1].length = 4;
    s->design.link[2].length = 2;
    s->design.link[3].length = 5;
    s->design.link[4].length = 3;
    s->design.link[3].mass = 1;
    s->design.gravity.y = -9.81;
    assert_int_equal(fourlink_prepare(&s->design, &s->mechanism), FOURLINK_OK);
    for (link = 2; link <= 4; link++)
        s->state.link[link].axis = along;
    s->state.link[3].origin.x = 2;
    s->state.link[4].origin.x = 4;
    if (kind == FOURLINK_SLIDER_CRANK) {
        s->state.link[3].axis = across;
        s->state.link[4].origin.x = 2;
        s->state.link[4].origin.y = 5;
    }
    s->state.branch = FOURLINK_OPEN;
}

TEST(test_singular)
{
    gsl_error_handler_t *old = gsl_set_error_handler(count_in_gsl);
    double two[2] = {0, 0}, three[3] = {0, 0, 0};
    gsl_vector_view short_one = gsl_vector_view_array(two, 2);
    gsl_vector_view long_one = gsl_vector_view_array(three, 3);
    fourlink_forces forces, pattern;
    uint64_t seed = 10;
    sample s;
    int n;

    memset(&forces, 0xa5, sizeof forces);
    memset(&pattern, 0xa5, sizeof pattern);
    for (n = 0; n < 8; n++) {
        singular_state(n % 2 ? FOURLINK_SLIDER_CRANK : FOURLINK_FOUR_BAR, &s);
        if (n / 2 == 1)
            memset(&s.state, 0, sizeof s.state);
        if (n / 2 == 2)
            s.state.link[3].axis.x = s.state.link[4].origin.x = NAN;
        if (n / 2 == 3)
            s.state.link[3].origin.y = INFINITY;
        assert_int_equal(fourlink_solve(&s.mechanism, &s.state, NULL, 0, &forces),
                         FOURLINK_SINGULAR);
        assert_memory_equal(&forces, &pattern, sizeof forces);
    }
    for (n = 0; n < 2000; n++) {
        draw(&seed, n, 0, &s);
        assert_int_equal(solve(&s), FOURLINK_OK);
    }
    assert_int_equal(handled, 0);
    (void)gsl_vector_memcpy(&short_one.vector, &long_one.vector);
    assert_int_equal(handled, 1);
    gsl_set_error_handler(old);
}

/* ---------------------------------------------------------------------------------------------
** Wrong calls
** ------------------------------------------------------------------------------------------- */

/* All four functions refuse the loads, and leave their outputs as they were. */
static void assert_refused(const sample *s, const fourlink_load *loads, unsigned long n_loads,
                           int status)
{
    struct {
        fourlink_state state;
        fourlink_forces forces;
        double A[9][9], b[9];
        fourlink_body body[FOURLINK_LINKS];
    } out, pattern;

    memset(&out, 0xa5, sizeof out);
    memset(&pattern, 0xa5, sizeof pattern);
    assert_int_equal(fourlink_solve(&s->mechanism, &s->state, loads, n_loads, &out.forces), status);
    assert_int_equal(fourlink_bodies(&s->mechanism, &s->state, loads, n_loads, out.body), status);
    assert_int_equal(fourlink_system(&s->mechanism, &s->state, loads, n_loads, out.A, out.b),
                     status);
    assert_int_equal(fourlink_analyse(&s->mechanism, s->branch, &s->crank, loads, n_loads,
                                      &out.state, &out.forces),
                     status);
    assert_memory_equal(&out, &pattern, sizeof out);
}

TEST(test_bad_loads)
{
    fourlink_load loads[2];
    uint64_t seed = 11;
    sample s;
    int n;

    for (n = 0; n < 2; n++) {
        draw(&seed, n, 0.1, &s);
        memset(loads, 0, sizeof loads);
        loads[0].link = loads[1].link = FOURLINK_FOLLOWER;
        assert_int_equal(fourlink_solve(&s.mechanism, &s.state, loads, 2, &s.forces), FOURLINK_OK);
        try_bad_loads(&s, loads, assert_refused);
        loads[1].at.x = 1.1e15;
        assert_refused(&s, loads, 2, FOURLINK_BAD_NUMBER);
        /* what lies beyond n_loads is not looked at */
        assert_int_equal(fourlink_solve(&s.mechanism, &s.state, loads, 1, &s.forces), FOURLINK_OK);
    }
}

TEST(test_null)
{
    uint64_t seed = 12;
    double A[9][9], b[9];
    fourlink_body body[FOURLINK_LINKS];
    sample s;

    draw(&seed, 0, 0.1, &s);
    assert_int_equal(fourlink_solve(NULL, &s.state, NULL, 0, &s.forces), FOURLINK_NULL);
    assert_int_equal(fourlink_solve(&s.mechanism, NULL, NULL, 0, &s.forces), FOURLINK_NULL);
    assert_int_equal(fourlink_solve(&s.mechanism, &s.state, NULL, 0, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_system(NULL, &s.state, NULL, 0, A, b), FOURLINK_NULL);
    assert_int_equal(fourlink_system(&s.mechanism, NULL, NULL, 0, A, b), FOURLINK_NULL);
    assert_int_equal(fourlink_system(&s.mechanism, &s.state, NULL, 0, NULL, b), FOURLINK_NULL);
    assert_int_equal(fourlink_system(&s.mechanism, &s.state, NULL, 0, A, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_bodies(NULL, &s.state, NULL, 0, body), FOURLINK_NULL);
    assert_int_equal(fourlink_bodies(&s.mechanism, NULL, NULL, 0, body), FOURLINK_NULL);
    assert_int_equal(fourlink_bodies(&s.mechanism, &s.state, NULL, 1, body), FOURLINK_NULL);
    assert_int_equal(fourlink_bodies(&s.mechanism, &s.state, NULL, 0, NULL), FOURLINK_NULL);
}

/* test_nine_equations ROWS prints the largest residual of so many rows of very unequal links. */
int main(int argc, char **argv)
{
    if (argc > 1) {
        long rows = atol(argv[1]), over;
        double worst = try_residuals(rows, &over);

        printf("%ld rows, largest residual %.1f rounding units / sin(mu), %ld over 300\n", rows,
               worst, over);
        return over > 0;
    }
    return run_all_tests(NULL);
}
