/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_notation.c - names and units as a book prints them; the parts of a text.
*/
#include "check.h"
#include "view/notation.h"

static void is_named(const char *plain, const char *printed)
{
    char out[NOTATION_SIZE];

    assert_string_equal(notation_name(plain, out), printed);
}

TEST(names)
{
    is_named("theta2", "θ₂");
    is_named("alpha34", "α₃₄");
    is_named("F12x", "F₁₂ₓ");
    is_named("F34_across", "F₃₄ across");
    is_named("F14_dir", "F₁₄ dir");
    is_named("Ts", "Tₛ");
    is_named("Fsx", "Fₛₓ");
    is_named("mu_min", "μ min");
    is_named("mu", "μ");
    is_named("N", "N");
    is_named("x", "x");
    is_named("I13_x", "I₁₃ x");
    is_named("G3.x", "G₃.x");
    is_named("time_ratio", "time ratio");
    is_named("m_a", "m_a");
    is_named("S.force", "S.force");
    is_named("spring_1.force", "spring_1.force");
    is_named("max(F12)", "max(F₁₂)");
    is_named("rms(time_ratio)", "rms(time ratio)");
    is_named("thetas", "θₛ");
    is_named("theta", "θ");
    is_named("omega2b", "omega2b");
}

TEST(long_subscripts)
{
    notation n;

    assert_int_equal(notation_split("F1234567", &n), 1); /* room for seven letters and the end */
    assert_string_equal(n.sub, "1234567");
    assert_int_equal(notation_split("F12345678", &n), 0);
    assert_string_equal(n.symbol, "F12345678");
    assert_string_equal(n.sub, "");
}

TEST(below)
{
    static const char *const names[][3] = {{"F12x_along", "F", "12x along"},
                                           {"mu_min", "μ", "min"},
                                           {"Ts", "T", "s"},
                                           {"theta4", "θ", "4"}};
    char out[NOTATION_SIZE];
    notation n;
    size_t i;

    for (i = 0; i < COUNT(names); i++) {
        assert_int_equal(notation_split(names[i][0], &n), 1);
        assert_string_equal(n.symbol, names[i][1]);
        assert_string_equal(notation_below(&n, out), names[i][2]);
    }
}

TEST(units)
{
    static const char *const units[][2] = {{"deg/s^2", "\302\260/s\302\262"},
                                           {"deg", "°"},
                                           {"m/s2", "m/s²"},
                                           {"N.m", "N·m"},
                                           {"kg.m2", "kg·m²"},
                                           {"rad/s2", "rad/s²"},
                                           {"1", "1"},
                                           {"lbf.in", "lbf·in"},
                                           {"deg/s2", "°/s²"},
                                           {"mm", "mm"},
                                           {"m4", "m⁴"},
                                           {"m6", "m6"}};
    char out[NOTATION_SIZE];
    size_t i;

    for (i = 0; i < COUNT(units); i++)
        assert_string_equal(notation_unit(units[i][0], out), units[i][1]);
}

/* The parts of a text, as [level words]. */
static void has_parts(const char *words, const char *expected)
{
    notation_part x = {words, 0, 0, 0};
    char found[400] = "";

    while (notation_next(words, &x))
        sprintf(found + strlen(found), "[%s%s%.*s]",
                x.level < 0   ? "_"
                : x.level > 0 ? "^"
                              : "",
                x.is_minus ? "!" : "", (int)x.n, x.words);
    assert_string_equal(found, expected);
}

TEST(parts)
{
    has_parts("", "");
    has_parts("plain words", "[plain words]");
    has_parts("F" NOTATION_SUB "12 = 3", "[F][_12][ = 3]");
    has_parts("a" NOTATION_SUB "B" NOTATION_SUPER "n", "[a][_B][^n]");
    has_parts("-m a" NOTATION_SUB "G2", "[!-][m a][_G2]");
    has_parts("x = -3, y = -4", "[x = ][!-][3, y = ][!-][4]");
    has_parts("slider-crank - 2", "[slider-crank - 2]");
    has_parts("(-1)", "[(][!-][1)]");
}

int main(void)
{
    return run_all_tests(NULL);
}
