/* SPDX-License-Identifier: GPL-3.0-or-later
**
** schema.c - the sections and keys that a deck can have, and the values they take.
*/
#include <string.h>

#include "deck.h"
#include "mechanics/coordinate.h"
#include "mechanics/kind.h"
#include "schema.h"

#define SECTION_INFO(code, name, repeats, kinds, first) {name, repeats, kinds, first},
const section_info flk_section_table[] = {SECTION_LIST(SECTION_INFO){NULL, 0, 0, KEY_COUNT}};

#define KEY_INFO(section, code, name, form, quantity, sign, kinds, meaning) \
    {SECTION_##section, name, FORM_##form, QUANTITY_##quantity, SIGN_##sign, kinds, meaning},
const key_info flk_key_table[] = {KEY_LIST(KEY_INFO)};

#define YES_WORDS(X, key) \
    X(key, "no", 0)       \
    X(key, "yes", 1)

#define SIDE_WORDS(X, key)            \
    X(key, "rising", FOURLINK_RISING) \
    X(key, "falling", FOURLINK_FALLING)

#define BRANCH_WORDS(X, key)    \
    X(key, "open", BRANCH_OPEN) \
    X(key, "crossed", BRANCH_CROSSED)

#define WORD_LIST(X)                                                          \
    X(TOP_MECHANISM, "four-bar", FOURLINK_FOUR_BAR)                           \
    X(TOP_MECHANISM, "slider-crank", FOURLINK_SLIDER_CRANK)                   \
    X(TOP_MECHANISM, "inverted-slider-crank", FOURLINK_INVERTED_SLIDER_CRANK) \
    X(TOP_MECHANISM, "scotch-yoke", FOURLINK_SCOTCH_YOKE)                     \
    X(TOP_SERIES, "none", FOURLINK_EXACT)                                     \
    X(TOP_SERIES, "piston", FOURLINK_SERIES_PISTON)                           \
    X(TOP_SERIES, "all", FOURLINK_SERIES_ALL)                                 \
    X(TOP_AXES, "ground", AXES_GROUND)                                        \
    X(TOP_AXES, "page", AXES_PAGE)                                            \
    X(TOP_SOLVER, "matrix", SOLVER_MATRIX)                                    \
    X(TOP_SOLVER, "dyad", SOLVER_DYAD)                                        \
    YES_WORDS(X, PINS_ROUGH)                                                  \
    YES_WORDS(X, MOTION_HOLD)                                                 \
    X(MOTION_INPUT, "theta2", 0)                                              \
    X(MOTION_INPUT, "theta4", 1)                                              \
    X(MOTION_INPUT, "x", 2)                                                   \
    X(MOTION_INPUT, "C.x", 3)                                                 \
    X(MOTION_INPUT, "slide", 4)                                               \
    SIDE_WORDS(X, MOTION_SIDE)                                                \
    X(MOTION_SIDE, "both", SIDE_BOTH)                                         \
    X(MOTION_MODE, "given", MODE_GIVEN)                                       \
    X(MOTION_MODE, "free", MODE_FREE)                                         \
    X(MOTION_MODE, "run-up", MODE_RUN_UP)                                     \
    X(MOTION_MODE, "steady", MODE_STEADY)                                     \
    X(MOTION_PROGRAM_OF, "angle", 0)                                          \
    X(MOTION_PROGRAM_OF, "speed", 1)                                          \
    X(MOTION_ROWS, "angle", 0)                                                \
    X(MOTION_ROWS, "time", 1)                                                 \
    YES_WORDS(X, FLYWHEEL_EXACT)                                              \
    YES_WORDS(X, CRANK_UNIFORM)                                               \
    YES_WORDS(X, COUPLER_UNIFORM)                                             \
    YES_WORDS(X, ROCKER_UNIFORM)                                              \
    YES_WORDS(X, ROD_UNIFORM)                                                 \
    YES_WORDS(X, LEVER_UNIFORM)                                               \
    YES_WORDS(X, OUTPUT_END_UNIFORM)                                          \
    YES_WORDS(X, OUTPUT_ROD_UNIFORM)                                          \
    X(OUTPUT_SLOT, "output", FOURLINK_HANGS_BY_OWN_SLOT)                      \
    X(OUTPUT_SLOT, "link", FOURLINK_HANGS_IN_SLOT)                            \
    X(OUTPUT_SIDE, "ahead", SIDE_AHEAD)                                       \
    X(OUTPUT_SIDE, "behind", SIDE_BEHIND)                                     \
    X(OUTPUT_SIDE, "left", SIDE_LEFT)                                         \
    X(OUTPUT_SIDE, "right", SIDE_RIGHT)                                       \
    X(GRADING_FEEDBACK, "hints", 0)                                           \
    X(GRADING_FEEDBACK, "answers", 1)                                         \
    X(GRADING_UNITS, "lenient", 0)                                            \
    X(GRADING_UNITS, "strict", 1)                                             \
    X(GRADING_HINT, "none", 0)                                                \
    X(GRADING_HINT, "half", 1)                                                \
    X(GRADING_DECIMAL, "point", DECIMAL_POINT)                                \
    X(GRADING_DECIMAL, "comma", DECIMAL_COMMA)                                \
    X(SYNTHESIS_TASK, "function", TASK_FUNCTION)                              \
    X(SYNTHESIS_TASK, "motion", TASK_MOTION)                                  \
    X(SYNTHESIS_TASK, "path", TASK_PATH)                                      \
    X(SYNTHESIS_TASK, "quick-return", TASK_QUICK_RETURN)                      \
    X(SYNTHESIS_TASK, "cognate", TASK_COGNATE)                                \
    X(SYNTHESIS_FIT, "equation", FOURLINK_FIT_EQUATION)                       \
    X(SYNTHESIS_FIT, "angle", FOURLINK_FIT_ANGLE)                             \
    X(SYNTHESIS_CRANK_TURNS, "fully", 0)                                      \
    X(SYNTHESIS_CRANK_TURNS, "any", 1)                                        \
    X(SYNTHESIS_ORDER, "listed", 0)                                           \
    X(SYNTHESIS_ORDER, "any", 1)                                              \
    X(SYNTHESIS_SLOW, "with", FOURLINK_SLOW_WITH)                             \
    X(SYNTHESIS_SLOW, "against", FOURLINK_SLOW_AGAINST)                       \
    X(SYNTHESIS_TYPE, "slotted-lever", FOURLINK_SLOTTED_LEVER)                \
    X(SYNTHESIS_TYPE, "whitworth", FOURLINK_WHITWORTH)                        \
    X(SYNTHESIS_CHOOSE, "best", 1)                                            \
    X(SYNTHESIS_WHICH, "left", FOURLINK_LEFT)                                 \
    X(SYNTHESIS_WHICH, "right", FOURLINK_RIGHT)                               \
    X(LOAD_OVER, "theta2", FLK_THETA2)                                        \
    X(LOAD_OVER, "theta4", FLK_THETA4)                                        \
    X(LOAD_OVER, "x", FLK_X)                                                  \
    X(LOAD_OVER, "slide", FLK_SLIDE)                                          \
    X(LOAD_OVER, "omega2", FLK_OMEGA2)                                        \
    X(LOAD_OVER, "omega4", FLK_OMEGA4)                                        \
    X(LOAD_OVER, "v", FLK_V)                                                  \
    X(LOAD_OVER, "slide_v", FLK_SLIDE_V)                                      \
    X(SPRING_ONLY, "pushes", FOURLINK_PUSHES)                                 \
    X(SPRING_ONLY, "pulls", FOURLINK_PULLS)                                   \
    X(FRICTION_DIRECTION, "forward", 1)                                       \
    X(FRICTION_DIRECTION, "backward", -1)                                     \
    YES_WORDS(X, BALANCE_CRANK)                                               \
    YES_WORDS(X, BALANCE_ROCKER)                                              \
    YES_WORDS(X, BALANCE_APPLY)                                               \
    BRANCH_WORDS(X, TABLE_BRANCH)                                             \
    X(TABLE_BRANCH, "both", BRANCH_BOTH)                                      \
    SIDE_WORDS(X, EXPECT_SIDE)                                                \
    SIDE_WORDS(X, MISPRINT_SIDE)                                              \
    BRANCH_WORDS(X, EXPECT_BRANCH)                                            \
    BRANCH_WORDS(X, MISPRINT_BRANCH)                                          \
    X(LOAD_FRAME, "ground", FOURLINK_FRAME_GROUND)                            \
    X(LOAD_FRAME, "link", FOURLINK_FRAME_LINK)

#define WORD_INFO(key, word, value) {KEY_##key, word, value},
static const word_info words_of_keys[] = {WORD_LIST(WORD_INFO){KEY_COUNT, NULL, 0}};

/* The links of all kinds of mechanism; the ground is the first. */
static const word_info links[] = {
    {KEY_COUNT, "ground", FOURLINK_GROUND},   {KEY_COUNT, "crank", FOURLINK_CRANK},
    {KEY_COUNT, "coupler", FOURLINK_COUPLER}, {KEY_COUNT, "rod", FOURLINK_COUPLER},
    {KEY_COUNT, "slider", FOURLINK_COUPLER},  {KEY_COUNT, "rocker", FOURLINK_FOLLOWER},
    {KEY_COUNT, "piston", FOURLINK_FOLLOWER}, {KEY_COUNT, "lever", FOURLINK_FOLLOWER},
    {KEY_COUNT, "yoke", FOURLINK_FOLLOWER},   {KEY_COUNT, NULL, 0}};

/* Other names of links, which are those of their sections, too. */
static const struct {
    int kinds;
    const char *written, *meant;
} other_links[] = {{FOURLINK_SLIDER_CRANK, "slider", "piston"},
                   {INVERTED, "boom", "crank"},
                   {INVERTED, "hatch", "crank"},
                   {INVERTED, "tailgate", "crank"},
                   {INVERTED, "tower", "crank"},
                   {INVERTED, "body", "crank"},
                   {INVERTED, "dump-body", "crank"},
                   {INVERTED, "cylinder", "lever"}};

#define OTHER_LINKS (sizeof other_links / sizeof other_links[0])

/* Equal whatever the case of letters, and whether a blank, - or _ joins the words. */
static int is_word(text t, const char *word)
{
    char joined[MESSAGE_SIZE], *c;

    if (t.length >= sizeof joined)
        return 0;
    for (c = flk_text_copy(t, joined, sizeof joined); *c; c++)
        if (*c == '_' || *c == ' ')
            *c = '-';
    return flk_text_equal(t, word) || flk_text_equal(flk_text_of(joined), word);
}

int flk_link_is_other(text name)
{
    size_t i;

    for (i = 0; i < OTHER_LINKS; i++)
        if (is_word(name, other_links[i].written))
            return 1;
    return 0;
}

text flk_link_meant(int kind, text name)
{
    size_t i;

    for (i = 0; i < OTHER_LINKS; i++)
        if ((other_links[i].kinds & kind) && is_word(name, other_links[i].written))
            return flk_text_of(other_links[i].meant);
    return name;
}

void flk_link_add_others(int kind, const char **words, size_t n)
{
    size_t i;

    for (i = 0; i < OTHER_LINKS; i++)
        if (other_links[i].kinds & kind)
            words[n++] = other_links[i].written;
    words[n] = NULL;
}

/* Other words for kinds of mechanism; without the kind that is meant, what to write instead. */
typedef struct other_kind {
    const char *written, *meant, *advice;
    int has_cylinder; /* 1: what its crank is held by is called a cylinder */
} other_kind;

static const other_kind other_kinds[] = {
    {"fourbar", "four-bar", NULL, 0},
    {"4-bar", "four-bar", NULL, 0},
    {"4bar", "four-bar", NULL, 0},
    {"four-bar-linkage", "four-bar", NULL, 0},
    {"crank-rocker", "four-bar", NULL, 0},
    {"crank-slider", "slider-crank", NULL, 0},
    {"slidercrank", "slider-crank", NULL, 0},
    {"whitworth", "inverted-slider-crank", NULL, 0},
    {"quick-return", "inverted-slider-crank", NULL, 0},
    {"shaper", "inverted-slider-crank", NULL, 0},
    {"slotted-lever", "inverted-slider-crank", NULL, 0},
    {"crank-and-slotted-lever", "inverted-slider-crank", NULL, 0},
    {"oscillating-cylinder", "inverted-slider-crank", NULL, 0},
    {"boom", "inverted-slider-crank", NULL, 1},
    {"hatch", "inverted-slider-crank", NULL, 1},
    {"tailgate", "inverted-slider-crank", NULL, 1},
    {"dump-body", "inverted-slider-crank", NULL, 1},
    {"tower", "inverted-slider-crank", NULL, 1},
    {"yoke", "scotch-yoke", NULL, 0},
    {"toggle", NULL,
     "a toggle is a four-bar or, if it presses along a line, a slider-crank: write which", 0},
    {"trammel", NULL,
     "a trammel moves as the rod of a slider-crank whose rod is as long as its crank: write that",
     0},
    {"elliptic-trammel", NULL,
     "a trammel moves as the rod of a slider-crank whose rod is as long as its crank: write that",
     0}};

#define OTHER_KINDS (sizeof other_kinds / sizeof other_kinds[0])

/* The row of other_kinds that a text is; null if the key has none. */
static const other_kind *other_kind_of(key_code key, text t)
{
    size_t i;

    for (i = 0; i < OTHER_KINDS && key == KEY_TOP_MECHANISM; i++)
        if (is_word(t, other_kinds[i].written))
            return &other_kinds[i];
    return NULL;
}

const char *flk_word_advice(key_code key, text t)
{
    const other_kind *other = other_kind_of(key, t);

    return other ? other->advice : NULL;
}

int flk_word_has_cylinder(text mechanism)
{
    const other_kind *other = other_kind_of(KEY_TOP_MECHANISM, mechanism);

    return other && other->has_cylinder;
}

/* The list that has the words of a key. */
static const word_info *words_for(key_code key)
{
    value_form form = flk_key_table[key].form;

    return form == FORM_LINK ? links + 1 : form == FORM_BODY ? links : words_of_keys;
}

key_code flk_first_key(section_code section)
{
    return flk_section_table[section].first;
}

size_t flk_section_keys(section_code section)
{
    return (size_t)(flk_first_key(section + 1) - flk_first_key(section));
}

/* 1 if a word is one of a key; those of links are in a list of their own. */
static int is_of_key(const word_info *w, key_code key)
{
    return w->key == key || w->key == KEY_COUNT;
}

const word_info *flk_word_find(key_code key, int kind, text t)
{
    const word_info *w = words_for(key);
    const other_kind *other = other_kind_of(key, t);

    if (other && other->meant)
        t = flk_text_of(other->meant);
    else if (w->key == KEY_COUNT)
        t = flk_link_meant(kind, t);
    while (w->word && !(is_of_key(w, key) && is_word(t, w->word)))
        w++;
    return w->word ? w : NULL;
}

void flk_key_words(key_code key, const char *const *own_links, const char *words[MOST_WORDS])
{
    const word_info *w;

    for (w = words_for(key); w->word; w++)
        if (is_of_key(w, key) &&
            (!own_links || w->key == key || strcmp(w->word, own_links[w->value]) == 0))
            *words++ = w->word;
    *words = NULL;
}

const char *flk_word_nearest(key_code key, int kind, text t)
{
    const char *known[MOST_WORDS], *others[MOST_OTHER_LINKS + OTHER_KINDS], *nearest;
    size_t n = 0;

    flk_key_words(key, NULL, known);
    for (; n < OTHER_KINDS && key == KEY_TOP_MECHANISM; n++)
        others[n] = other_kinds[n].written;
    flk_link_add_others(words_for(key)->key == KEY_COUNT ? kind : 0, others, n);
    nearest = flk_text_nearest(t, known);
    return nearest ? nearest : flk_text_nearest(t, others);
}

key_code flk_find_key(section_code section, text name)
{
    key_code k;

    for (k = flk_first_key(section); k < flk_first_key(section + 1); k++)
        if (flk_text_equal(name, flk_key_table[k].name))
            return k;
    return KEY_COUNT;
}

section_code flk_find_section(text name)
{
    int i;

    for (i = 1; i < SECTION_COUNT; i++)
        if (flk_text_equal(name, flk_section_table[i].name))
            return (section_code)i;
    return SECTION_COUNT;
}

section_code flk_section_of_link(fourlink_kind kind, int link)
{
    return flk_find_section(flk_text_of(flk_kind_of(kind)->link[link]));
}
