/* SPDX-License-Identifier: GPL-3.0-or-later
**
** formulas.h - the motion of linkages and engines by formulas of this file in long double, and extremes
** of these by dense scan.
*/
#ifndef FOURLINK_FORMULAS_H
#define FOURLINK_FORMULAS_H

#include "check.h"

#define PIL 3.14159265358979323846264338327950288L

/* ---------------------------------------------------------------------------------------------
** The mechanisms once more
** ------------------------------------------------------------------------------------------- */

typedef struct own {
    long double a, b, c, d; /* of a slider-crank r, l, - and e */
    int branch;
    long double start, speed, acceleration; /* of the motion, or of this part of it */
    long double mass, gas;                  /* of a piston; force on it towards the crank */
} own;

typedef long double own_column(const own *o, long double theta2);

static inline long double own_omega2(const own *o, long double theta2)
{
    long double square = o->speed * o->speed + 2 * o->acceleration * (theta2 - o->start);

    square = square > 0 ? sqrtl(square) : 0;
    return o->speed < 0 || (o->speed == 0 && o->acceleration < 0) ? -square : square;
}

/* Angles, and their first and second derivatives to theta2. */
typedef struct angles {
    long double t3, t4, k3, k4, kk3, kk4;
} angles;

/* The angles from the triangles ABD and BCD, the derivatives from the loop
**
**    a e^(i theta2) + b e^(i theta3) = d + c e^(i theta4)
*/
static inline angles own_angles(const own *o, long double t)
{
    long double f = sqrtl(o->a * o->a + o->d * o->d - 2 * o->a * o->d * cosl(t));
    long double ADB = atan2l(o->a * sinl(t), o->d - o->a * cosl(t)), x, y, det;
    angles r;

    r.t3 = -ADB + o->branch * acosl((f * f + o->b * o->b - o->c * o->c) / (2 * f * o->b));
    r.t4 = PIL - ADB - o->branch * acosl((f * f + o->c * o->c - o->b * o->b) / (2 * f * o->c));
    /* -b sin(t3) k3 + c sin(t4) k4 = a sin(t), b cos(t3) k3 - c cos(t4) k4 = -a cos(t) */
    det = o->b * o->c * sinl(r.t3 - r.t4);
    x = o->a * sinl(t);
    y = -o->a * cosl(t);
    r.k3 = (-o->c * cosl(r.t4) * x - o->c * sinl(r.t4) * y) / det;
    r.k4 = (-o->b * sinl(r.t3) * y - o->b * cosl(r.t3) * x) / det;
    x = o->a * cosl(t) + o->b * cosl(r.t3) * r.k3 * r.k3 - o->c * cosl(r.t4) * r.k4 * r.k4;
    y = o->a * sinl(t) + o->b * sinl(r.t3) * r.k3 * r.k3 - o->c * sinl(r.t4) * r.k4 * r.k4;
    r.kk3 = (-o->c * cosl(r.t4) * x - o->c * sinl(r.t4) * y) / det;
    r.kk4 = (-o->b * sinl(r.t3) * y - o->b * cosl(r.t3) * x) / det;
    return r;
}

static inline long double own_theta3(const own *o, long double t)
{
    return own_angles(o, t).t3 * 180 / PIL;
}

static inline long double own_theta4(const own *o, long double t)
{
    return own_angles(o, t).t4 * 180 / PIL;
}

static inline long double own_omega3(const own *o, long double t)
{
    return own_angles(o, t).k3 * own_omega2(o, t);
}

static inline long double own_omega4(const own *o, long double t)
{
    return own_angles(o, t).k4 * own_omega2(o, t);
}

static inline long double own_alpha3(const own *o, long double t)
{
    angles r = own_angles(o, t);

    return r.kk3 * own_omega2(o, t) * own_omega2(o, t) + r.k3 * o->acceleration;
}

static inline long double own_alpha4(const own *o, long double t)
{
    angles r = own_angles(o, t);

    return r.kk4 * own_omega2(o, t) * own_omega2(o, t) + r.k4 * o->acceleration;
}

static inline long double own_mu(const own *o, long double t)
{
    long double f2 = o->a * o->a + o->d * o->d - 2 * o->a * o->d * cosl(t);
    long double mu = acosl((o->b * o->b + o->c * o->c - f2) / (2 * o->b * o->c)) * 180 / PIL;

    return mu > 90 ? 180 - mu : mu;
}

/* The piston's coordinate, and its derivatives to theta2: X^2 - 2 X r cos(theta2) ... solved */
typedef struct piston {
    long double h, W, X, k, kk, k3, kk3;
} piston;

static inline piston own_piston(const own *o, long double t)
{
    long double dh = o->a * cosl(t), ddh = -o->a * sinl(t), dW;
    piston p;

    p.h = o->a * sinl(t) - o->d;
    p.W = o->branch * sqrtl(o->b * o->b - p.h * p.h);
    dW = -p.h * dh / p.W;
    p.X = o->a * cosl(t) + p.W;
    p.k = -o->a * sinl(t) + dW;
    p.kk = -o->a * cosl(t) - (dh * dh + p.h * ddh + dW * dW) / p.W;
    p.k3 = -dh / p.W;
    p.kk3 = -ddh / p.W + dh * dW / (p.W * p.W);
    return p;
}

static inline long double own_x(const own *o, long double t)
{
    return sqrtl((o->a + o->b) * (o->a + o->b) - o->d * o->d) - o->branch * own_piston(o, t).X;
}

static inline long double own_v(const own *o, long double t)
{
    return -o->branch * own_piston(o, t).k * own_omega2(o, t);
}

static inline long double own_a(const own *o, long double t)
{
    piston p = own_piston(o, t);

    return -o->branch * (p.kk * own_omega2(o, t) * own_omega2(o, t) + p.k * o->acceleration);
}

static inline long double own_rod_theta3(const own *o, long double t)
{
    long double angle = asinl(own_piston(o, t).h / o->b) * 180 / PIL;

    return o->branch > 0 ? -angle : 180 + angle;
}

static inline long double own_rod_omega3(const own *o, long double t)
{
    return own_piston(o, t).k3 * own_omega2(o, t);
}

static inline long double own_rod_alpha3(const own *o, long double t)
{
    piston p = own_piston(o, t);

    return p.kk3 * own_omega2(o, t) * own_omega2(o, t) + p.k3 * o->acceleration;
}

static inline long double own_phi(const own *o, long double t)
{
    return asinl(own_piston(o, t).h / o->b) * 180 / PIL;
}

static inline long double own_rod_mu(const own *o, long double t)
{
    return acosl(fabsl(own_piston(o, t).h) / o->b) * 180 / PIL;
}

/* Of a piston with mass and gas, by the power that they take. */
static inline long double own_Ts(const own *o, long double t)
{
    piston p = own_piston(o, t);
    long double w = own_omega2(o, t);

    return p.k * (o->mass * (p.kk * w * w + p.k * o->acceleration) + o->branch * o->gas);
}

/* Lengths of a crank-rocker, not near its change points. */
static inline own random_rocker(uint64_t *seed)
{
    own o = {0};

    do {
        o.a = uniform(seed, 0.1, 0.5);
        o.b = uniform(seed, 0.3, 1);
        o.c = uniform(seed, 0.3, 1);
        o.d = uniform(seed, 0.3, 1);
    } while (o.a > 0.8L * fminl(o.b, fminl(o.c, o.d)) ||
             2 * (o.a + fmaxl(o.b, fmaxl(o.c, o.d))) > 0.9L * (o.a + o.b + o.c + o.d));
    o.speed = uniform(seed, -20, 20);
    return o;
}

static inline own random_engine(uint64_t *seed, int offset)
{
    own o = {0};

    o.a = uniform(seed, 0.1, 0.5);
    o.d = offset ? o.a * uniform(seed, -0.7, 0.7) : 0;
    o.b = (o.a + fabsl(o.d)) * uniform(seed, 1.3, 4);
    o.speed = uniform(seed, -20, 20);
    return o;
}

/* ---------------------------------------------------------------------------------------------
** Extremes by dense scan and golden sections
** ------------------------------------------------------------------------------------------- */

#define SAMPLES 360

typedef struct peaks {
    int n;
    long double value, theta2[64]; /* the value, and all angles at which it occurs */
} peaks;

static inline void keep(peaks *p, int sign, long double value, long double theta2)
{
    long double same = 1e-12L * fabsl(value);

    if (isnan(value) || (p->n && sign * value < sign * p->value - same))
        return;
    if (p->n && sign * value > sign * p->value + same)
        p->n = 0;
    if (!p->n || sign * value > sign * p->value)
        p->value = value;
    if (p->n < 64)
        p->theta2[p->n++] = theta2;
}

static inline long double golden(own_column *f, const own *o, int sign, long double low,
                                 long double high)
{
    const long double g = (sqrtl(5) - 1) / 2;
    long double x = high - g * (high - low), z = low + g * (high - low);
    long double fx = sign * f(o, x), fz = sign * f(o, z);
    int i;

    for (i = 0; i < 52; i++)
        if (fx > fz) {
            high = z;
            z = x, fz = fx;
            x = high - g * (high - low);
            fx = sign * f(o, x);
        } else {
            low = x;
            x = z, fx = fz;
            z = low + g * (high - low);
            fz = sign * f(o, z);
        }
    return (low + high) / 2;
}

/* Add the extremes of one part of a motion to those of the parts before it. */
static inline void scan(own_column *f, const own *o, int sign, long double from, long double to,
                        peaks *p)
{
    long double y[SAMPLES + 1], step = (to - from) / SAMPLES, best = -INFINITY, worst = INFINITY;
    int i;

    for (i = 0; i <= SAMPLES; i++) {
        y[i] = sign * f(o, from + i * step);
        best = y[i] > best ? y[i] : best;
        worst = y[i] < worst ? y[i] : worst;
    }
    keep(p, sign, sign * y[0], from);
    keep(p, sign, sign * y[SAMPLES], to);
    for (i = 0; i <= SAMPLES; i++) {
        long double low = i ? from + (i - 1) * step : from,
                    high = i < SAMPLES ? from + (i + 1) * step : to, at;

        if ((i && y[i - 1] > y[i]) || (i < SAMPLES && y[i + 1] > y[i]) ||
            y[i] < best - 0.01L * (best - worst))
            continue;
        at = golden(f, o, sign, low, high);
        keep(p, sign, f(o, at), at);
    }
}

#endif
