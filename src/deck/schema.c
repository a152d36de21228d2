/* SPDX-License-Identifier: GPL-3.0-or-later
**
** schema.c - the sections and keys that a deck can have, and what may stand behind each.
*/
#include "deck.h"
#include "schema.h"

#define SECTION_INFO(code, name, repeats, kinds, first) {name, repeats, kinds, first},
const section_info flk_section_table[] = {SECTION_LIST(SECTION_INFO){NULL, 0, 0, KEY_COUNT}};

#define KEY_INFO(section, code, name, form, quantity, sign, kinds) \
    {SECTION_##section, name, FORM_##form, QUANTITY_##quantity, SIGN_##sign, kinds},
const key_info flk_key_table[] = {KEY_LIST(KEY_INFO)};

const word_info flk_word_table[] = {{KEY_TOP_MECHANISM, "four-bar", FOURLINK_FOUR_BAR},
                                    {KEY_TOP_MECHANISM, "slider-crank", FOURLINK_SLIDER_CRANK},
                                    {KEY_TOP_SERIES, "none", FOURLINK_EXACT},
                                    {KEY_TOP_SERIES, "piston", FOURLINK_SERIES_PISTON},
                                    {KEY_TOP_SERIES, "all", FOURLINK_SERIES_ALL},
                                    {KEY_TOP_SOLVER, "matrix", SOLVER_MATRIX},
                                    {KEY_TOP_SOLVER, "dyad", SOLVER_DYAD},
                                    {KEY_MOTION_HOLD, "no", 0},
                                    {KEY_MOTION_HOLD, "yes", 1},
                                    {KEY_LOAD_LINK, "crank", FOURLINK_CRANK},
                                    {KEY_LOAD_LINK, "coupler", FOURLINK_COUPLER},
                                    {KEY_LOAD_LINK, "rod", FOURLINK_COUPLER},
                                    {KEY_LOAD_LINK, "rocker", FOURLINK_FOLLOWER},
                                    {KEY_LOAD_LINK, "piston", FOURLINK_FOLLOWER},
                                    {KEY_TABLE_BRANCH, "open", BRANCH_OPEN},
                                    {KEY_TABLE_BRANCH, "crossed", BRANCH_CROSSED},
                                    {KEY_TABLE_BRANCH, "both", BRANCH_BOTH},
                                    {KEY_EXPECT_BRANCH, "open", BRANCH_OPEN},
                                    {KEY_EXPECT_BRANCH, "crossed", BRANCH_CROSSED},
                                    {KEY_MISPRINT_BRANCH, "open", BRANCH_OPEN},
                                    {KEY_MISPRINT_BRANCH, "crossed", BRANCH_CROSSED},
                                    {KEY_POINT_LINK, "crank", FOURLINK_CRANK},
                                    {KEY_POINT_LINK, "coupler", FOURLINK_COUPLER},
                                    {KEY_POINT_LINK, "rod", FOURLINK_COUPLER},
                                    {KEY_POINT_LINK, "rocker", FOURLINK_FOLLOWER},
                                    {KEY_POINT_LINK, "piston", FOURLINK_FOLLOWER},
                                    {KEY_LOAD_FRAME, "ground", FOURLINK_FRAME_GROUND},
                                    {KEY_LOAD_FRAME, "link", FOURLINK_FRAME_LINK},
                                    {KEY_COUNT, NULL, 0}};

key_code flk_first_key(section_code section)
{
    return flk_section_table[section].first;
}

section_code flk_find_section(text name)
{
    int i;

    for (i = 1; i < SECTION_COUNT; i++)
        if (flk_text_equal(name, flk_section_table[i].name))
            return (section_code)i;
    return SECTION_COUNT;
}
