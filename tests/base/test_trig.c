/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_trig.c - sine, cosine, angle and length: values of MPFR with 200 bits, rounded, and what must hold of
** all. trig_trial.c has many more arguments.
*/
#include <float.h>

#include "check.h"
#include "base/trig.h"

/* Distance in units of the last place of `expected`. */
static double ulps(double found, double expected)
{
    int exponent;

    frexp(expected, &exponent);
    return ldexp(fabs(found - expected), 53 - exponent);
}

static void assert_ulps(double found, double expected, double most)
{
    if (!(ulps(found, expected) <= most))
        fail_msg("%a for %a", found, expected);
}

/* Arguments that are hard to reduce, among them the doubles nearest to multiples of 90 deg. */
static void test_known(void **unused)
{
    static const struct {
        double x, sine, cosine;
    } known[] = {
        {0x1.921fb54442d18p+0, 0x1.0000000000000p+0, 0x1.1a62633145c07p-54},
        {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53, -0x1.0000000000000p+0},
        {0x1.2d97c7f3321d2p+2, -0x1.0000000000000p+0, -0x1.a79394c9e8a0ap-53},
        {0x1.921fb54442d18p+2, -0x1.1a62633145c07p-52, 0x1.0000000000000p+0},
        {0x1.921fb54442d18p-1, 0x1.6a09e667f3bccp-1, 0x1.6a09e667f3bcdp-1},
        {0x1.b7cdfd9d7bdbbp-34, 0x1.b7cdfd9d7bdbbp-34, 0x1.0000000000000p+0},
        {0x1.0000000000000p-1, 0x1.eaee8744b05f0p-2, 0x1.c1528065b7d50p-1},
        {0x1.0000000000000p+0, 0x1.aed548f090ceep-1, 0x1.14a280fb5068cp-1},
        {0x1.0000000000000p+1, 0x1.d18f6ead1b446p-1, -0x1.aa22657537205p-2},
        {0x1.4000000000000p+3, -0x1.1689ef5f34f52p-1, -0x1.ad9ac890c6b1fp-1},
        {0x1.6300000000000p+8, -0x1.f9bd0307d1de3p-16, -0x1.fffffffc18e4cp-1},
        {0x1.6000000000000p+3, -0x1.fffeb762e93ebp-1, 0x1.220ae41ee2fdfp-8},
        {0x1.6000000000000p+4, -0x1.220a29f6eb9f4p-7, -0x1.fffadd8d4acdap-1},
        {0x1.979c000000000p+15, -0x1.ffffffffdea62p-1, 0x1.719a47d413c35p-18},
        {0x1.fcd1800000000p+17, 0x1.fffffffff8874p-1, 0x1.5de149ffbf0f4p-19},
        {0x1.1d0d268000000p+25, 0x1.ffffffffffffdp-1, 0x1.c7099117042a8p-26},
        {0x1.86a0000000000p+16, 0x1.24daa9c527e96p-5, -0x1.ffac3841b3da7p-1},
        {0x1.dcd6500000000p+29, 0x1.1778cae83c69bp-1, 0x1.acff8c7364234p-1},
        {0x1.dcd64ffc00000p+29, 0x1.3cb1fcc865abep-4, 0x1.fe77a1c40324bp-1},
        {0x1.b951f1572eba5p+23, -0x1.0000000000000p+0, -0x1.f54f5227a4e84p-60},
        {0x1.b951f1572eba5p+24, 0x1.f54f5227a4e84p-59, -0x1.0000000000000p+0},
        {0x1.b951f1572eba5p+25, -0x1.f54f5227a4e84p-58, 0x1.0000000000000p+0},
        {0x1.b951f1572eba5p+26, -0x1.f54f5227a4e84p-57, 0x1.0000000000000p+0},
        {0x1.6c6cbc45dc8dep+10, 0x1.6d61b58c99c43p-56, 0x1.0000000000000p+0},
        {0x1.b951f1572eba5p+27, -0x1.f54f5227a4e84p-56, 0x1.0000000000000p+0},
        {0x1.6c6cbc45dc8dep+11, 0x1.6d61b58c99c43p-55, 0x1.0000000000000p+0},
        {0x1.39c6fd67805a7p+18, -0x1.0000000000000p+0, -0x1.988efe18ff83fp-55},
    };
    size_t i;

    (void)unused;
    for (i = 0; i < sizeof known / sizeof *known; i++) {
        double sine, cosine;

        flk_sine_cosine(known[i].x, &sine, &cosine);
        assert_ulps(sine, known[i].sine, 1);
        assert_ulps(cosine, known[i].cosine, 1);
        assert_true(flk_sine(known[i].x) == sine && flk_cosine(known[i].x) == cosine);
        flk_sine_cosine(-known[i].x, &sine, &cosine);
        assert_ulps(sine, -known[i].sine, 1);
        assert_ulps(cosine, known[i].cosine, 1);
    }
}

/* Beyond 10^9 an angle that differs a little from x: the bound of trig.h, and 1 ulp of the result. */
static double beyond(double x)
{
    return 1.2e-15 + 3e-32 * fabs(x);
}

static void test_large(void **unused)
{
    static const struct {
        double x, sine, cosine;
    } known[] = {
        {1000000100.0, 0x1.7c38da2bab723p-5, 0x1.ff72be4e8ff74p-1},
        {123456789012.345, -0x1.a7b937381844cp-2, -0x1.d21c2dac33789p-1},
        {1e15, 0x1.b76f88136cebap-1, -0x1.06c154609d33fp-1},
        {4503599627370498.0, -0x1.9c50116c55934p-1, -0x1.2f8c9f86fc08ap-1},
        {1e16, 0x1.8f334432ebba5p-1, -0x1.40991e398dbfcp-1},
        {1e22, -0x1.b453ab76bf397p-1, 0x1.0be2cef01c8f4p-1},
        {-1.7e24, 0x1.d5026c54bad38p-1, -0x1.9aba0e0974f6ep-2},
        {1e26, -0x1.b4d731fcc7a84p-2, 0x1.cf12add97502dp-1},
        {1e30, 0x1.31c608f107767p-7, -0x1.fffa4b11f1b45p-1},
    };
    uint64_t seed = 8;
    size_t i;

    (void)unused;
    for (i = 0; i < COUNT(known); i++) {
        double sine, cosine;

        flk_sine_cosine(known[i].x, &sine, &cosine);
        assert_true(fabs(sine - known[i].sine) <= beyond(known[i].x));
        assert_true(fabs(cosine - known[i].cosine) <= beyond(known[i].x));
    }
    for (i = 0; i < 100000; i++) {
        double x = uniform(&seed, 0.6e9, 2e9), s, c, sine, cosine;

        x = i % 2 ? x : ldexp(x, (int)uniform(&seed, 0, 60));
        flk_sine_cosine(x, &s, &c);
        flk_sine_cosine(2 * x, &sine, &cosine);
        assert_true(fabs(sine - 2 * s * c) <= 4 * beyond(x));
        assert_true(fabs(cosine - (c - s) * (c + s)) <= 4 * beyond(x));
        assert_true(fabs(s * s + c * c - 1) < 1e-15 && flk_sine(-x) == -s && flk_cosine(-x) == c);
    }
    assert_true(fabs(flk_sine(DBL_MAX)) <= 1 && isnan(flk_sine(-INFINITY)));
}

static void test_special(void **unused)
{
    double sine, cosine;

    (void)unused;
    flk_sine_cosine(0, &sine, &cosine);
    assert_true(sine == 0 && cosine == 1);
    flk_sine_cosine(1e-300, &sine, &cosine);
    assert_true(sine == 1e-300 && cosine == 1);
    assert_true(isnan(flk_sine(INFINITY)) && isnan(flk_cosine(NAN)));
    assert_true(flk_angle(0, 1) == 0 && flk_angle(0, -1) == M_PI && signbit(flk_angle(-0.0, 1)));
    assert_true(flk_angle(1, 0) == M_PI_2 && flk_angle(-1, 0) == -M_PI_2 &&
                flk_angle(1, 1) == M_PI_4);
    assert_true(flk_angle(-1, -1) == -3 * M_PI_4 && flk_angle(2, 2) == M_PI_4);
    assert_true(flk_angle(INFINITY, 1) == M_PI_2 && isnan(flk_angle(NAN, 1)) &&
                isnan(flk_angle(1, NAN)));
    assert_ulps(flk_angle(DBL_MIN / 8, 3), DBL_MIN / 24, 1);
    assert_ulps(flk_angle(DBL_MAX, DBL_MAX), M_PI_4, 1);
    assert_true(flk_arc_sine(1) == M_PI_2 && flk_arc_sine(-1) == -M_PI_2 && flk_arc_sine(0) == 0);
    assert_true(flk_arc_cosine(1) == 0 && flk_arc_cosine(-1) == M_PI &&
                flk_arc_cosine(0) == M_PI_2);
    assert_true(isnan(flk_arc_sine(1.0000001)) && isnan(flk_arc_cosine(-2)) &&
                isnan(flk_arc_sine(NAN)));
    assert_true(flk_length(3, -4) == 5 && flk_length(0, 0) == 0 && flk_length(-7, 0) == 7);
    assert_ulps(flk_length(3e300, 4e300), 5e300, 2);
    assert_ulps(flk_length(3e-300, 4e-300), 5e-300, 2);
    assert_true(flk_length(DBL_MIN, 0) == DBL_MIN && isinf(flk_length(1, -INFINITY)) &&
                isnan(flk_length(NAN, 1)));
}

/* sin(x + y) and cos(x + y) by the theorem of addition; the angle of (cos x, sin x) is x. */
static void test_random(void **unused)
{
    uint64_t seed = 5;
    int i;

    (void)unused;
    for (i = 0; i < 100000; i++) {
        double x = uniform(&seed, -M_PI, M_PI), size = pow(2, uniform(&seed, -100, 100));
        double y = ldexp(floor(uniform(&seed, -1e6, 1e6)), -20), s, c, sx, cx, sy, cy;

        x = ldexp(floor(ldexp(x, 40)), -40); /* so that x + y is exact */
        flk_sine_cosine(x + y, &s, &c);
        flk_sine_cosine(x, &sx, &cx);
        flk_sine_cosine(y, &sy, &cy);
        assert_true(fabs(s - (sx * cy + cx * sy)) < 5e-16 && fabs(c - (cx * cy - sx * sy)) < 5e-16);
        assert_true(fabs(flk_angle(size * sx, size * cx) - x) < 5e-16);
        assert_true(fabs(flk_length(size * sx, size * cx) / size - 1) < 5e-16);
        assert_true(flk_sine(-x) == -sx && flk_cosine(-x) == cx &&
                    flk_angle(-sx, cx) == -flk_angle(sx, cx));
    }
}

int main(void)
{
    const struct CMUnitTest all[] = {
        cmocka_unit_test(test_known),
        cmocka_unit_test(test_large),
        cmocka_unit_test(test_special),
        cmocka_unit_test(test_random),
    };

    return cmocka_run_group_tests(all, NULL, NULL);
}
