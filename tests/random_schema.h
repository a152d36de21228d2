/* SPDX-License-Identifier: GPL-3.0-or-later
**
** random_schema.h - random decks: a machine (random_parts.h) with keys of all sections added, as the schema has them, and options.
**
** It knows the sections, keys, words and quantities from the schema (deck/schema.h), so a new key is tried as soon as it
** is there.  A key gets a value of its form.  It stays if the deck is still one without mistakes, so that what goes
** together is known by the reader alone.  Keys, and pairs of a section and an option, are drawn evenly: always one that
** was tried least.
*/
#ifndef RANDOM_SCHEMA_H
#define RANDOM_SCHEMA_H

#include <limits.h>
#include <string.h>

#include "deck/schema.h"
#include "fourlink.h"
#include "mechanics/kind.h"
#include "random_parts.h"

/* ------------------------------------------------------------------------------------------- values */

#define LONGEST 2000

/* In SI units, by quantity: values are some tenths to some tens of it. */
static const double typical[QUANTITY_COUNT] = {
    0.05, 0.001, 1, 1, 1, 1, 10, 10, 50, 0.01, 100, 10, 1e5, 100, 10, 1000, 10, 10, 0.1, 0.1, 0.3};

/* Units of all quantities; those that fit are tried. */
static const char *const some_units[] = {
    "m",         "mm",    "cm",     "in",      "ft",      "kg",      "g",         "lb",
    "slug",      "s",     "ms",     "rad",     "deg",     "rev",     "rpm",       "rad/s",
    "deg/s",     "rev/s", "rad/s2", "deg/s^2", "N",       "kN",      "lbf",       "kgf",
    "N m",       "N.mm",  "lbf.in", "lbf ft",  "J",       "kJ",      "W",         "kW",
    "hp",        "Pa",    "kPa",    "bar",     "psi",     "N/mm2",   "m/s",       "mm/s",
    "in/s",      "m/s2",  "mm/s2",  "ft/s2",   "kg m2",   "kg.mm2",  "g cm2",     "lb in2",
    "N/m",       "N/mm",  "lbf/in", "N s/m",   "N s/mm",  "N m/rad", "N m/deg",   "lbf in/rad",
    "N m s/rad", "kg m",  "kg mm",  "lb.in",   "%",       "m2",      "mm2",       "lb-in",
    "ft-lb",     "oz-in", "lbf-in", "lb/in",   "lb-s/in", "lb/in2",  "slug-ft^2", "lb-in2",
    "lb-in-s^2", "lbm",   "blobs",  "pounds",  "kips",    "ounces",  "in/sec",    "sec",
    "RPM",       "mph",   "fps",    "ips",     "gn",      "ft-lb/s", "lb-in/rad", "lb-in-s/rad",
    "rad s-1",   "N-m"};

static const char *unit_for(quantity q)
{
    const char *fitting[sizeof some_units / sizeof some_units[0]];
    int n = 0;
    size_t i;
    unit u;
    text bad;

    for (i = 0; i < sizeof some_units / sizeof some_units[0]; i++)
        if (flk_unit_read_as(flk_text_of(some_units[i]), flk_quantities[q].dim, &u, &bad) &&
            flk_dimension_equal(u.dim, flk_quantities[q].dim))
            fitting[n++] = some_units[i];
    return n ? fitting[one_of(n)] : flk_quantities[q].unit;
}

/* Append to a text of LONGEST bytes. */
static void append(char *out, const char *format, ...)
{
    va_list arguments;
    size_t used = strlen(out);

    va_start(arguments, format);
    vsnprintf(out + used, LONGEST - used, format, arguments);
    va_end(arguments);
}

static double size_of(quantity q, value_sign sign)
{
    double size = typical[q] * power_of_ten(-1, seldom(0.05) ? 4 : 1);

    if (q == QUANTITY_ANGLE)
        size = seldom(0.6) ? 15 * one_of(40) * PI / 180 : size;
    return sign == SIGN_ANY && seldom(0.4) ? -size : size;
}

static void append_quantity(char *out, quantity q, value_sign sign)
{
    const char *written = unit_for(q);
    double si = size_of(q, sign);
    text bad;
    unit u;

    flk_unit_read_as(flk_text_of(written), flk_quantities[q].dim, &u, &bad);
    if (q == QUANTITY_NUMBER && seldom(0.7))
        append(out, "%.4g", si);
    else
        append(out, "%.*g %s", seldom(0.2) ? 15 : 5, flk_unit_from_si(si, u), written);
}

static void append_pair(char *out, quantity q)
{
    const char *written = unit_for(q);
    unit u;
    text bad;

    flk_unit_read_as(flk_text_of(written), flk_quantities[q].dim, &u, &bad);
    append(out, "(%.5g, %.5g) %s", flk_unit_from_si(size_of(q, SIGN_ANY), u),
           flk_unit_from_si(size_of(q, SIGN_ANY), u), written);
}

static void append_polar(char *out, quantity q)
{
    append_quantity(out, q, SIGN_NOT_NEGATIVE);
    append(out, " at %d deg", 15 * between_whole(-12, 25));
}

static void append_vector(char *out, quantity q)
{
    switch (one_of(4)) {
    case 0:
        append_quantity(out, q, SIGN_ANY);
        break;
    case 1:
        append_polar(out, q);
        break;
    default:
        append_pair(out, q);
    }
}

static void append_point(char *out)
{
    static const char *const named[] = {"mid", "end", "origin", "50 %", "G", "-20 %"};
    int steps = 1 + seldom(0.3) + seldom(0.1);

    while (steps--) {
        if (seldom(0.4))
            append(out, "%s", named[one_of(6)]);
        else
            append_vector(out, QUANTITY_LENGTH);
        append(out, "%s", steps ? " + " : "");
    }
}

/* A list over the crank angle, or the file that the loader has; of a motor, over its speed. */
static void append_curve(char *out, key_code code, value_form form, quantity q)
{
    int n = between_whole(2, 7), i;

    for (i = 0; code == KEY_MOTOR_CURVE && i < n; i++)
        append(out, "%s%d rad/s %.5g N m", i ? ", " : "", 10 * i, between(20, 90) * (n - 1 - i));
    if (code == KEY_MOTOR_CURVE)
        return;
    if (form != FORM_VECTOR && seldom(0.2)) {
        append(out, "file card.csv deg %s", unit_for(q));
        return;
    }
    for (i = 0; i < n; i++) {
        append(out, "%s%g deg ", i ? ", " : "", floor(360 * (i + between(0.1, 0.9)) / n));
        if (form == FORM_VECTOR)
            append_pair(out, q);
        else
            append_quantity(out, q, SIGN_ANY);
    }
}

/* What keys that take any text accept; of a key that is not among them any of these. */
static const struct {
    key_code key;
    const char *value;
} some_texts[] = {
    {KEY_TOP_TITLE, "\"A # title; with marks\""},
    {KEY_TOP_TITLE, "Crank & rocker <1>"},
    {KEY_TABLE_COLUMNS, "theta2, theta4, mu, omega4"},
    {KEY_TABLE_COLUMNS, "all"},
    {KEY_TABLE_COLUMNS, "max(omega2), mu_min"},
    {KEY_TABLE_COLUMNS, "theta2, F32x, F21_dir, F43, Ts"},
    {KEY_TABLE_COLUMNS, "mu at 1/3 rev omega2 at -40 deg, max(mu)"},
    {KEY_MOTION_PROGRAM, "0 s 0 deg, 0.4 s 90 deg, 0.6 s 90 deg, 1 s 360 deg"},
    {KEY_MOTION_PROGRAM, "-1 s 30 deg, 0.5 s 400 deg trapezoid 20 % 30 %, 2 s -100 deg linear"},
    {KEY_MOTION_LAW, "3-4-5"},
    {KEY_MOTION_LAW, "modified-sine"},
    {KEY_MOTION_ENDS, "periodic"},
    {KEY_MOTION_ENDS, "0 rad/s, 3 rad/s"},
    {KEY_SWEEP_OUTPUT, "max(omega4), rms(alpha2), mean(mu)"},
    {KEY_SWEEP_OUTPUT, "mu_min"},
    {KEY_SWEEP_OUTPUT, "mu at 30 deg omega2 at pi/6"},
    {KEY_SWEEP_YIELD, "mu_min > 20 deg"},
    {KEY_SWEEP_YIELD, "mu at 50 deg > 20 deg"},
    {KEY_EXPECT_TOLERANCE, "1 %"},
    {KEY_MISPRINT_TOLERANCE, "0.5 rad/s"},
    {KEY_GRADING_TOLERANCE, "1 %, 0.5 deg"},
    {KEY_SYNTHESIS_POINTS, "35 deg 91 deg, 67 deg 102 deg, 100 deg 117 deg"},
    {KEY_SYNTHESIS_POINTS, "35 deg 90 deg, 67 deg 104 deg, 100 deg 117 deg, 120 deg 121 deg"},
    {KEY_SYNTHESIS_WEIGHTS, "1, 2, 1, 3"},
    {KEY_SYNTHESIS_FUNCTION, "log10"},
    {KEY_SYNTHESIS_FUNCTION, "x^0.7"},
    {KEY_SYNTHESIS_ARGUMENT, "1 to 3"},
    {KEY_SYNTHESIS_CRANK, "20 deg to 110 deg"},
    {KEY_SYNTHESIS_ROCKER, "60 deg to 130 deg"},
    {KEY_SYNTHESIS_PISTON, "90 mm to 40 mm"},
    {KEY_SYNTHESIS_POSITIONS, "(0, 0) m 0 deg, (1.1, 0.6) m 20 deg, (2.2, 1.5) m 45 deg"},
    {KEY_SYNTHESIS_POSITIONS, "(10, 20) mm, (26, 24) mm, (44, 22) mm"},
    {KEY_SYNTHESIS_POSITIONS, "(10, 20) mm, (26, 24) mm, (44, 22) mm, (60, 12) mm"},
    {KEY_SYNTHESIS_TIMING, "25 deg, 55 deg"},
    {KEY_SYNTHESIS_TIMING, "equal"},
    {KEY_SYNTHESIS_LEFT, "fixed (0.4, 3.4) m"},
    {KEY_SYNTHESIS_RIGHT, "fixed (0.6, -1.1) m"},
    {KEY_SYNTHESIS_RIGHT, "within (0, -90) mm to (120, 0) mm"}};

static void append_text(char *out, key_code key)
{
    const char *fitting[sizeof some_texts / sizeof some_texts[0]];
    size_t i;
    int n = 0, any;

    for (any = 0; any < 2 && !n; any++)
        for (i = 0; i < sizeof some_texts / sizeof some_texts[0]; i++)
            if (any || some_texts[i].key == key)
                fitting[n++] = some_texts[i].value;
    append(out, "%s", fitting[one_of(n)]);
}

/* Other words for kinds of mechanism, one in ten if a trial wants them. */
static int has_other_words;
static const char *const other_kinds[] = {"4-bar",     "Four bar", "crank-slider", "Shaper",
                                          "whitworth", "boom",     "dump body",    "yoke"};

#define COUNT_OF(list) ((int)(sizeof list / sizeof list[0]))

static void append_value(char *out, const key_info *key, key_code code, const char *const *links)
{
    const char *words[MOST_WORDS];
    quantity q = key->q;
    int n = 0;

    switch (key->form) {
    case FORM_WORD:
        if (code == KEY_TOP_MECHANISM && has_other_words && seldom(0.1)) {
            append(out, "%s", other_kinds[one_of(COUNT_OF(other_kinds))]);
            break;
        }
        /* fall through */
    case FORM_LINK:
    case FORM_BODY:
        flk_key_words(code, links, words);
        while (words[n])
            n++;
        append(out, "%s", n ? words[one_of(n)] : "yes");
        break;
    case FORM_UNIT:
        append(out, "%s", unit_for(q));
        break;
    case FORM_VECTOR:
    case FORM_CURVE:
        if (code == KEY_MOTOR_CURVE || seldom(0.4))
            append_curve(out, code, key->form, q);
        else if (key->form == FORM_VECTOR)
            append_vector(out, q);
        else
            append_quantity(out, q, key->sign);
        break;
    case FORM_POINT:
        append_point(out);
        break;
    case FORM_PLACE:
        if (seldom(0.5))
            append_polar(out, q);
        else
            append_pair(out, q);
        break;
    case FORM_LINE:
        append_pair(out, q);
        append(out, ", ");
        append_pair(out, q);
        break;
    case FORM_CRANK:
        if (seldom(0.2))
            append(out, "drawn");
        else
            append_quantity(out, q, key->sign);
        break;
    case FORM_COUNT:
        append(out, "%d", between_whole(1, 12));
        break;
    case FORM_EITHER:
        if (seldom(0.5))
            q = q == QUANTITY_STIFFNESS ? QUANTITY_TORSIONAL_STIFFNESS
                : q == QUANTITY_DAMPING ? QUANTITY_TORSIONAL_DAMPING
                                        : QUANTITY_TORQUE;
        append_quantity(out, q, key->sign);
        break;
    case FORM_TEXT:
        append_text(out, code);
        break;
    default:
        append_quantity(out, q, key->sign);
    }
}

/* ------------------------------------------------------------------------------------------- keys */

static unsigned long keys_tried[KEY_COUNT], keys_kept[KEY_COUNT];

static const char *load_card(void *host, const char *name, unsigned long *size)
{
    static const char card[] = "# a card\n0 1\n20 3.5\n35 3\n90 1.2\n180 0.6\n300 0.8\n";

    (void)host;
    *size = sizeof card - 1;
    return strcmp(name, "card.csv") == 0 ? card : NULL;
}

/* How a deck is tried: motions that are computed are only read, since to open them takes long; READ does so with
** linkages through points and poses, too. */
typedef enum trying { READ, OPENED } trying;

static int is_only_read(const char *words, trying how)
{
    return (strstr(words, "mode = ") && !strstr(words, "mode = given")) ||
           (how == READ && (strstr(words, "task = path") || strstr(words, "task = motion")));
}

/* The kind of mechanism of a text; 0 if it is a deck with mistakes, or one of very many rows. */
static int kind_of_text(const char *words, trying how)
{
    fourlink_source source;
    fourlink_results *r = NULL;
    fourlink_deck *d = NULL;
    fourlink_problem problem;
    int status;

    memset(&source, 0, sizeof source);
    memset(&problem, 0, sizeof problem);
    source.text = words;
    source.length = (unsigned long)strlen(words);
    source.load = load_card;
    source.synthesis = strstr(words, "[synthesis]") != NULL;
    source.design = FOURLINK_ANY_DESIGN;
    if (is_only_read(words, how))
        status = fourlink_deck_read(words, source.length, load_card, NULL, 0, &d, NULL, NULL);
    else
        status = fourlink_results_open(&source, 0, &r, NULL, NULL);
    if (status == FOURLINK_OK)
        fourlink_deck_problem(d ? d : fourlink_results_deck(r), &problem);
    fourlink_deck_free(d);
    if (r)
        fourlink_results_free(r);
    return problem.n_rows <= 2000 ? (int)problem.mechanism.design.kind : 0;
}

static int is_of_kind(section_code section, int kind)
{
    return (flk_section_table[section].kinds & kind) != 0;
}

/* What a trial of given motions can compare: keys of these sections are tried. */
#define OF_MACHINES                                                                     \
    (SET_OF(GROUND) | SET_OF(CRANK) | SET_OF(COUPLER) | SET_OF(ROCKER) | SET_OF(ROD) |  \
     SET_OF(PISTON) | SET_OF(SLIDER) | SET_OF(LEVER) | SET_OF(YOKE) | SET_OF(GRAVITY) | \
     SET_OF(LOAD) | SET_OF(SPRING) | SET_OF(GAS) | SET_OF(POINT))
#define SET_OF(section) (1UL << SECTION_##section)
#define EVERY_SECTION (~0UL)

/* Keys that are tried beside another of their section: decks of a number stay what they were before these came. They are the
** last of their sections.  Two keys are left out for it. */
static const struct {
    key_code key, beside;
    const char *value;
    key_code without[2]; /* KEY_COUNT: none */
} followers[] = {
    {KEY_SYNTHESIS_ORDER, KEY_SYNTHESIS_CRANK_TURNS, "any", {KEY_COUNT, KEY_COUNT}},
    {KEY_SYNTHESIS_LENGTHS, KEY_SYNTHESIS_CRANK_TURNS, "5 mm to 300 mm", {KEY_COUNT, KEY_COUNT}},
    {KEY_SYNTHESIS_LENGTH_RATIO, KEY_SYNTHESIS_CRANK_TURNS, "20", {KEY_COUNT, KEY_COUNT}},
    {KEY_UNITS_VOLUME, KEY_UNITS_MASS_MOMENT, "cm3", {KEY_COUNT, KEY_COUNT}},
    {KEY_GAS_CLEARANCE, KEY_GAS_BACK_PRESSURE, "8 mm", {KEY_COUNT, KEY_COUNT}},
    {KEY_GRADING_HINT, KEY_GRADING_UNITS, "half", {KEY_COUNT, KEY_COUNT}},
    {KEY_GRADING_TEXT,
     KEY_GRADING_DIGITS,
     "Find the angle <b> & {1:MC:=2}",
     {KEY_COUNT, KEY_COUNT}},
    {KEY_OUTPUT_SLOT, KEY_OUTPUT_END_MASS, "link", {KEY_OUTPUT_ROD, KEY_COUNT}},
    {KEY_OUTPUT_SLOT_ANGLE, KEY_OUTPUT_END_MASS, "25 deg", {KEY_COUNT, KEY_COUNT}},
    {KEY_OUTPUT_OFFSET,
     KEY_OUTPUT_END_CG,
     "4 mm\nslot = output",
     {KEY_OUTPUT_ROD, KEY_OUTPUT_LENGTH}},
    {KEY_OUTPUT_SLOT_ANGLE,
     KEY_OUTPUT_END_INERTIA,
     "70 deg\nslot = output",
     {KEY_OUTPUT_ROD, KEY_COUNT}},
    {KEY_OUTPUT_END_CG_PLACE, KEY_OUTPUT_END_MASS, "(30, 20) mm", {KEY_OUTPUT_END_CG, KEY_COUNT}},
    {KEY_OUTPUT_ROD_CG_PLACE,
     KEY_OUTPUT_ROD_MASS,
     "40 mm at 60 deg",
     {KEY_OUTPUT_ROD_CG, KEY_COUNT}}};

static int is_follower(key_code k)
{
    size_t i;

    for (i = 0; i < sizeof followers / sizeof *followers; i++)
        if (followers[i].key == k)
            return 1;
    return 0;
}

/* The keys of a section without those that follow another. */
static int count_leaders(section_code section)
{
    key_code k = flk_first_key(section);
    int n = 0;

    for (; k < flk_first_key(section + 1); k++)
        n += !is_follower(k);
    return n;
}

/* The key of this kind and of these sections that was tried least, one of several by chance. */
static key_code rarest_key(int kind, unsigned long sections)
{
    unsigned long least = ULONG_MAX;
    key_code found = 0, k;
    int n = 0;

    for (k = 0; k < KEY_COUNT; k++) {
        if (!(flk_key_table[k].kinds & kind) || !is_of_kind(flk_key_table[k].section, kind) ||
            !(sections >> flk_key_table[k].section & 1) || is_follower(k))
            continue;
        if (keys_tried[k] < least) {
            least = keys_tried[k];
            n = 0;
        }
        if (keys_tried[k] == least && one_of(++n) == 0)
            found = k;
    }
    return found;
}

/* What a section needs beside the key that is tried. */
static const struct {
    section_code section;
    const char *lines;
} companions[] = {
    {SECTION_LOAD, "link = crank\ntorque = -1 N m\n"},
    {SECTION_LOAD, "link = crank\nforce = (12, -7) N\nat = mid\n"},
    {SECTION_LOAD, "link = crank\ntorque = -1 N m\nover = omega2\nat_speed = 10 rad/s\n"},
    {SECTION_SPRING,
     "link = crank\nto = ground\nat = (10, 5) mm\nto_at = (90, 80) mm\nstiffness = 500 N/m\n"},
    {SECTION_SPRING, "link = crank\nto = ground\ndamping = 0.01 N m s/rad\n"},
    {SECTION_MOTOR,
     "stall_torque = 50 N m\nno_load_speed = 20 rad/s\n[motion]\nmode = run-up\nturns = 1\n"},
    {SECTION_MOTOR, "torque = 5 N m\n[flywheel]\ninertia = 0.2 kg m2\n[motion]\nmode = free\nspeed "
                    "= 8 rad/s\nturns = 1\n"},
    {SECTION_SWEEP, "crank.length = 20 mm to 24 mm step 1 mm\noutput = max(mu)\n"},
    {SECTION_SWEEP, "crank.length = 20 mm +- 0.1 mm\nsamples = 3\noutput = mean(omega2)\nyield = "
                    "mean(omega2) < 1e3 rad/s\n"},
    {SECTION_MOTION, "program = 0 s 0 deg, 0.3 s 50 deg, 1 s 360 deg\n"},
    {SECTION_EXPECT, "at = 40 deg\nomega2 = 10 rad/s\n"},
    {SECTION_MISPRINT, "at = 40 deg\nomega2 = 10.5 rad/s\n"},
    {SECTION_GRADING,
     "tolerance = 1 %\nomega2 = 2 marks\n[expect]\nat = 0 deg\nomega2 = 10 rad/s\n"},
    {SECTION_FRICTION, "mu = 0.05\nradius = 5 mm\n"},
    {SECTION_GAS, "bore = 30 mm\npressure = 2 bar\n"},
    {SECTION_POINT, "link = crank\nat = 50 %\n"},
    {SECTION_OUTPUT,
     "link = crank\nat = (9, 4) mm\nrod = 200 mm\nline = (20, 10) mm\nangle = 15 deg\n"},
    {SECTION_OUTPUT,
     "link = crank\nat = (9, 4) mm\nrod = 90 mm\npivot = (140, 30) mm\nlength = 120 mm\n"},
    {SECTION_FLYWHEEL, "inertia = 0.3 kg m2\n"},
    {SECTION_BALANCE, "radius = 30 mm\n"},
    {SECTION_SYNTHESIS, "task = quick-return\ntime_ratio = 1.2\nswing = 50 deg\n"}};

static const char *companion_of(section_code section)
{
    const char *fitting[sizeof companions / sizeof companions[0]];
    int n = 0;
    size_t i;

    for (i = 0; i < sizeof companions / sizeof companions[0]; i++)
        if (companions[i].section == section)
            fitting[n++] = companions[i].lines;
    return n ? fitting[one_of(n)] : "";
}

/* The end of the line at a place of a text, behind its line feed. */
static const char *line_end(const char *at)
{
    const char *end = strchr(at, '\n');

    return end ? end + 1 : at + strlen(at);
}

static int begins_with_key(const char *line, const char *key)
{
    size_t n = strlen(key);

    return strncmp(line, key, n) == 0 && strchr(" =", line[n]) != NULL && line[n] != '\0';
}

/* 1 if a line opens the section, under any name. */
static int opens(const char *line, const char *section)
{
    size_t n = strlen(section);

    return line[0] == '[' && strncmp(line + 1, section, n) == 0 &&
           strchr(" ]", line[1 + n]) != NULL;
}

/* A deck with a line in a section in place of one of the same key, as `out`; of a section that repeats, in the first.  With a
** null value without that key.  A section that the deck does not have is added, with other lines that it needs. */
static void with_line(char *out, size_t size, const char *in, const key_info *key,
                      const char *value, const char *lines)
{
    const char *name = flk_section_table[key->section].name, *at = in, *end;
    int inside = key->section == SECTION_TOP, done = !value, was_inside = 0;
    size_t used = 0;

#define PUT(...) used += (size_t)snprintf(out + used, used < size ? size - used : 0, __VA_ARGS__)
    out[0] = '\0';
    if (inside && value)
        PUT("%s = %s\n", key->name, value);
    done |= inside;
    for (; *at; at = end) {
        end = line_end(at);
        if (*at == '[') {
            was_inside |= inside;
            inside = opens(at, name) && !was_inside;
        }
        if (inside && begins_with_key(at, key->name))
            continue;
        PUT("%.*s", (int)(end - at), at);
        if (*at == '[' && inside && !done) {
            PUT("%s = %s\n", key->name, value);
            done = 1;
        }
    }
    if (!done) {
        PUT(flk_section_table[key->section].repeats ? "[%s N%d]\n" : "[%s]\n", name, one_of(100));
        PUT("%s = %s\n", key->name, value);
        for (at = lines, inside = 1; *at; at = end) {
            end = line_end(at);
            inside &= *at != '[';
            if (!inside || !begins_with_key(at, key->name))
                PUT("%.*s", (int)(end - at), at);
        }
    }
#undef PUT
}

static int keep_if_right(const char *with, int kind, trying how)
{
    if (strlen(with) + 1 >= sizeof deck_text || kind_of_text(with, how) != kind)
        return 0;
    length = strlen(with);
    memcpy(deck_text, with, length + 1);
    return 1;
}

/* Try one more key: alone, in place of another of its section, and with a second one. */
static void try_key(int kind, unsigned long sections)
{
    static char with[sizeof deck_text], less[sizeof deck_text], two[sizeof deck_text];
    char value[LONGEST] = "", second[LONGEST] = "";
    key_code code = rarest_key(kind, sections), first, other;
    const key_info *key = &flk_key_table[code];
    const trying how = key->section == SECTION_SYNTHESIS ? OPENED : READ;
    const char *const *links = flk_kind_of((fourlink_kind)kind)->link;
    int n, i, j, kept;

    first = flk_first_key(key->section);
    n = count_leaders(key->section);
    other = first + (key_code)one_of(n);
    keys_tried[code]++;
    append_value(value, key, code, links);
    append_value(second, &flk_key_table[other], other, links);
    with_line(with, sizeof with, deck_text, key, value, companion_of(key->section));
    kept = keep_if_right(with, kind, how);
    with_line(two, sizeof two, with, &flk_key_table[other], second, "");
    kept = kept || (other != code && keep_if_right(two, kind, how));
    for (i = 0; i < n && !kept; i++)
        if (first + (key_code)i != code) {
            with_line(less, sizeof less, with, &flk_key_table[first + (key_code)i], NULL, "");
            kept = keep_if_right(less, kind, how);
            with_line(less, sizeof less, two, &flk_key_table[first + (key_code)i], NULL, "");
            kept = kept || (first + (key_code)i != other && other != code &&
                            keep_if_right(less, kind, how));
        }
    keys_kept[code] += (unsigned long)kept;
    for (i = 0; kept && i < (int)(sizeof followers / sizeof *followers); i++)
        if (followers[i].beside == code) {
            with_line(less, sizeof less, deck_text, &flk_key_table[followers[i].key],
                      followers[i].value, "");
            for (j = 0; j < 2 && followers[i].without[j] < KEY_COUNT; j++) {
                memcpy(two, less, sizeof two);
                with_line(less, sizeof less, two, &flk_key_table[followers[i].without[j]], NULL,
                          "");
            }
            keys_tried[followers[i].key]++;
            keys_kept[followers[i].key] += (unsigned long)keep_if_right(less, kind, how);
        }
}

/* ------------------------------------------------------------------------------------------- decks of tasks */

static void make_task(void)
{
    static const char *const tasks[] = {
        "[ground]\nlength = 90 mm\n[synthesis]\ntask = function\n"
        "points = 35 deg 91 deg, 67 deg 102 deg, 100 deg 117 deg\n",
        "[ground]\nlength = 90 mm\n[synthesis]\ntask = function\nfit = angle\n"
        "points = 35 deg 91 deg, 67 deg 102 deg, 100 deg 117 deg, 120 deg 124 deg\n",
        "[ground]\nlength = 1 m\n[synthesis]\ntask = function\nfunction = x^1.5\nx = 1 to 4\ncrank "
        "= 30 deg to 120 deg\n"
        "rocker = 60 deg to 150 deg\n",
        "[synthesis]\ntask = motion\npositions = (0, 0) m 0 deg, (1.2, 0.5) m 18 deg, (2.1, 1.6) m "
        "47 deg\n"
        "left = fixed (0.5, 3.5) m\nright = fixed (0.5, -1) m\n",
        "[synthesis]\ntask = path\npositions = (10, 20) mm, (25, 24) mm, (45, 21) mm\ntiming = 20 "
        "deg, 50 deg\n"
        "right = fixed (70, 5) mm\n",
        "[ground]\nlength = 120 mm\n[synthesis]\ntask = quick-return\ntime_ratio = 1.2\nswing = 50 "
        "deg\nchoose = best\n",
        "[coupler]\nlength = 6 in\n[rocker]\nlength = 2.5 in\n[synthesis]\ntask = "
        "quick-return\ntime_ratio = 1\n"
        "swing = 60 deg\n",
        "[crank]\nlength = 20 mm\n[coupler]\nlength = 60 mm\n[rocker]\nlength = 50 "
        "mm\n[ground]\nlength = 70 mm\n"
        "[point P]\nlink = coupler\nat = (30, 20) mm\n[synthesis]\ntask = cognate\nwhich = left\n"};
    static const char *const of_pistons[] = {
        "[synthesis]\ntask = function\nfunction = square\nx = 0 to 1\ncrank = 45 deg to 135 "
        "deg\npiston = 100 mm to 30 mm\n",
        "[ground]\noffset = 10 mm\n[synthesis]\ntask = quick-return\ntime_ratio = 1.1\nstroke = 50 "
        "mm\n"};
    static const char *const of_levers[] = {"[crank]\nlength = 30 mm\n[synthesis]\ntask = "
                                            "quick-return\ntime_ratio = 1.7\nstroke = 120 mm\n",
                                            "[ground]\nlength = 50 mm\n[synthesis]\ntask = "
                                            "quick-return\ntype = whitworth\ntime_ratio = 2.7\n"};

    length = 0;
    switch (one_of(4)) {
    case 0:
        write("mechanism = slider-crank\n%s", of_pistons[one_of(2)]);
        break;
    case 1:
        write("mechanism = inverted-slider-crank\n%s", of_levers[one_of(2)]);
        break;
    default:
        write("mechanism = four-bar\n%s", tasks[one_of(8)]);
    }
}

/* A deck by the places of its pins. */
static void make_drawn(void)
{
    static const char *const others[] = {
        "C = (110, 90) mm\nD = (120, 10) mm\n[coupler]\nmass = 0.5 kg\nuniform = yes\n",
        "C = (180, 20) mm\nguide = (0, 10) mm, (200, 21) mm\n[piston]\nmass = 0.5 kg\n",
        "D = (-60, 90) mm\nC = (-80, 130) mm\n[lever]\nmass = 0.5 kg\ncg = 20 mm\n",
        "guide = (0, 10) mm, (200, -30) mm\n[yoke]\nmass = 0.5 kg\ncg = 20 mm\n"};
    int one = one_of(4);

    length = 0;
    write("mechanism = %s\n[motion]\nspeed = %d rpm\n%s[pins]\n", machine_names[one],
          between_whole(20, 300), seldom(0.5) ? "from = drawn\n" : "");
    write("A = (%d, %d) mm\nB = %d mm at %d deg\n%s", between_whole(-9, 9), between_whole(-9, 9),
          between_whole(20, 40), between_whole(20, 70), others[one]);
}

/* Try so many keys of some sections in the deck. */
static void try_keys(int tries, unsigned long sections)
{
    int kind;

    deck_text[length] = '\0';
    kind = kind_of_text(deck_text, OPENED);
    while (kind && tries--)
        try_key(kind, sections);
}

/* A deck of any sort, with so many keys tried. */
static inline void make_schema_deck(long number, int tries)
{
    switch (number % 4) {
    case 0:
        make_machine(number / 4, WILD | EVERYTHING, seldom(0.1) ? AN_INSTANT : GIVEN);
        break;
    case 1:
        make_machine(number / 4, EVERYTHING, seldom(0.25) ? DRIVEN : seldom(0.2) ? PROGRAM : GIVEN);
        break;
    case 2:
        make_machine(number / 4, EVERYTHING, DRIVEN);
        break;
    default:
        if (seldom(0.3))
            make_drawn();
        else
            make_task();
        break;
    }
    try_keys(tries, EVERY_SECTION);
}

/* A wild machine of a given motion, from its number alone. */
static inline void make_wild_deck(long number)
{
    make_machine(number, WILD | LAWS | SPRINGS | POINTS | GRAVITY | GAS, GIVEN);
    memset(keys_tried, 0, sizeof keys_tried);
    try_keys(one_of(9), OF_MACHINES);
}

/* ------------------------------------------------------------------------------------------- options */

/* Each option of the command, and values that it takes; test_generator.sh compares the names with --help. */
static const struct {
    const char *name, *values[9];
    const char *with;     /* another option that it needs */
    section_code section; /* that it needs; SECTION_TOP: none */
} known_options[] = {
    {"--set",
     {"motion.interval=20 deg", "crank.mass=0.4 kg", "gravity.direction=-60 deg", "table.digits=9"},
     NULL,
     SECTION_TOP},
    {"--branch", {"open", "crossed", "both"}, NULL, SECTION_TOP},
    {"--interval", {"15 deg", "0.5 rad", "7 deg"}, NULL, SECTION_TOP},
    {"--allow-files", {""}, NULL, SECTION_TOP},
    {"--print-deck", {""}, NULL, SECTION_TOP},
    {"--pins", {""}, "--print-deck", SECTION_TOP},
    {"--import", {"link.txt"}, NULL, SECTION_TOP},
    {"--columns",
     {"all", "theta2,theta4,omega4", "max(omega2),mean(omega2)", "omega2,alpha2"},
     NULL,
     SECTION_TOP},
    {"--at",
     {"30 deg", "45 deg,200 deg", "omega2 = 5 rad/s", "-10 deg", "drawn"},
     NULL,
     SECTION_TOP},
    {"--summary", {""}, NULL, SECTION_TOP},
    {"--matrix", {""}, NULL, SECTION_TOP},
    {"--list", {""}, NULL, SECTION_TOP},
    {"--format", {"table", "csv", "json", "jsonl", "paper"}, NULL, SECTION_TOP},
    {"--output", {"out.txt"}, NULL, SECTION_TOP},
    {"--units",
     {"SI", "in, lbf", "mm, rpm, N", "cm, deg/s", "ft, lb-ft", "oz-in"},
     NULL,
     SECTION_TOP},
    {"--wide", {""}, NULL, SECTION_TOP},
    {"--color", {"always", "never"}, NULL, SECTION_TOP},
    {"--check", {"", "=answers.expect"}, NULL, SECTION_TOP},
    {"--answers", {"answers"}, NULL, SECTION_TOP},
    {"--scores", {""}, "--answers=answers", SECTION_TOP},
    {"--feedback", {"feedback/"}, NULL, SECTION_TOP},
    {"--exercise", {"asks.deck"}, "--answers=answers --scores", SECTION_TOP},
    {"--tolerance", {"1 %", "0.5 deg, 2 %"}, NULL, SECTION_TOP},
    {"--expect", {""}, NULL, SECTION_TOP},
    {"--form", {""}, NULL, SECTION_TOP},
    {"--plot", {"out.svg", "out.txt", "-"}, NULL, SECTION_TOP},
    {"--plot-kind",
     {"mechanism", "motion", "forces", "turning-moment", "polar", "vectors", "limits", "columns",
      "exercise"},
     "--plot=out.svg",
     SECTION_TOP},
    {"--plot-at", {"40 deg", "10 deg, 130 deg", "drawn"}, "--plot=out.svg", SECTION_TOP},
    {"--plot-x", {"omega2", "theta4", "time"}, "--plot=out.svg", SECTION_TOP},
    {"--ascii", {""}, "--plot=out.txt", SECTION_TOP},
    {"--report", {"out.html"}, NULL, SECTION_TOP},
    {"--part", {"1/2", "2/2"}, NULL, SECTION_SWEEP},
    {"--design", {"1", "2", "all"}, NULL, SECTION_SWEEP},
    {"--names", {"names.txt"}, "--scores", SECTION_TOP},
    {"--best", {"max max(mu)", "min mean(omega2)"}, NULL, SECTION_SWEEP},
    {"--solve", {"crank.length = 10 mm .. 30 mm where max(omega4) = 3 rad/s"}, NULL, SECTION_TOP},
    {"--synthesis", {""}, NULL, SECTION_SYNTHESIS},
    {"--solution", {"1", "2"}, "--synthesis", SECTION_SYNTHESIS},
    {"--effort", {"1", "2"}, "--synthesis", SECTION_SYNTHESIS},
    {"--quiz", {"out.xml"}, NULL, SECTION_TOP}};

#define N_OPTIONS ((int)(sizeof known_options / sizeof known_options[0]))

/* Options that are not drawn, so that decks of a number stay: those from this one on stand beside another, every other time. */
#define FIRST_FOLLOWER (N_OPTIONS - 1)
#define FOLLOWED "--tolerance"

static unsigned long pairs_tried[N_OPTIONS][SECTION_COUNT];

static int has_section(section_code section)
{
    const char *at;

    for (at = deck_text; *at; at = line_end(at))
        if (opens(at, flk_section_table[section].name))
            return 1;
    return section == SECTION_TOP;
}

/* The option whose pairs with the sections of this deck were tried least; seldom one that it has no use for. */
static int rarest_option(void)
{
    unsigned long least = ULONG_MAX, tried;
    int o, found = 0, n = 0;
    section_code s;

    for (o = 0; o < FIRST_FOLLOWER; o++) {
        if (!has_section(known_options[o].section) && !seldom(0.02))
            continue;
        tried = ULONG_MAX;
        for (s = 0; s < SECTION_COUNT; s++)
            if (has_section(s) && pairs_tried[o][s] < tried)
                tried = pairs_tried[o][s];
        if (tried < least) {
            least = tried;
            n = 0;
        }
        if (tried == least && one_of(++n) == 0)
            found = o;
    }
    return found;
}

static void count_pairs(int o)
{
    section_code s;

    for (s = 0; s < SECTION_COUNT; s++)
        pairs_tried[o][s] += (unsigned long)has_section(s);
}

/* The options that stand beside this one. */
static void write_followers(FILE *out, int o)
{
    int k;

    if (strcmp(known_options[o].name, FOLLOWED) != 0 || pairs_tried[o][SECTION_TOP] % 2)
        return;
    for (k = FIRST_FOLLOWER; k < N_OPTIONS; k++) {
        count_pairs(k);
        fprintf(out, "%s=%s\n", known_options[k].name, known_options[k].values[0]);
    }
}

/* Some options for the deck, one a line, each as one word. */
static inline void write_options(FILE *out)
{
    int n = 1 + seldom(0.2) + seldom(0.05), has_task = has_section(SECTION_SYNTHESIS), o, values;

    while (n--) {
        o = rarest_option();
        count_pairs(o);
        for (values = 0; values < 9 && known_options[o].values[values]; values++)
            ;
        values = one_of(values);
        fprintf(out, "%s%s%s\n", known_options[o].name,
                *known_options[o].values[values] && *known_options[o].values[values] != '=' ? "="
                                                                                            : "",
                known_options[o].values[values]);
        if (known_options[o].with)
            fprintf(out, "%s\n", known_options[o].with);
        write_followers(out, o);
        has_task &= strcmp(known_options[o].name, "--synthesis") != 0;
    }
    if (has_task)
        fprintf(out, "--synthesis\n");
}

/* How evenly keys, and pairs of an option and a section, were tried. */
static inline void tell_evenness(void)
{
    unsigned long least = ULONG_MAX, most = 0, kept = 0, pairs = 0, without = 0;
    key_code k;
    int o;
    section_code s;

    for (k = 0; k < KEY_COUNT; k++) {
        least = keys_tried[k] < least ? keys_tried[k] : least;
        most = keys_tried[k] > most ? keys_tried[k] : most;
        kept += keys_kept[k] > 0;
        if (!keys_kept[k])
            printf("never kept: %s.%s, tried %lu times\n",
                   flk_section_table[flk_key_table[k].section].name, flk_key_table[k].name,
                   keys_tried[k]);
    }
    printf("keys: %d, each tried %lu to %lu times; %lu were kept in some deck\n", (int)KEY_COUNT,
           least, most, kept);
    least = ULONG_MAX;
    most = 0;
    for (o = 0; o < N_OPTIONS; o++)
        for (s = 0; s < SECTION_COUNT; s++) {
            least = pairs_tried[o][s] < least ? pairs_tried[o][s] : least;
            most = pairs_tried[o][s] > most ? pairs_tried[o][s] : most;
            without += pairs_tried[o][s] == 0;
            pairs++;
        }
    printf("pairs of an option and a section: %lu, each tried %lu to %lu times; %lu never\n", pairs,
           least, most, without);
}

#endif
