/* SPDX-License-Identifier: GPL-3.0-or-later
**
** status.c - the texts of codes, and the version.
*/
#include "mechanics.h"

const char *fourlink_status_text(int status)
{
    switch (status) {
        FOURLINK_STATUS_LIST(FLK_CASE)
    default:
        return "unknown status";
    }
}

const char *fourlink_branch_text(int branch)
{
    return branch == FOURLINK_OPEN ? "open" : "crossed";
}

const char *fourlink_input_side_text(int side)
{
    return side == FOURLINK_FALLING ? "falling" : "rising";
}

const char *fourlink_version(void)
{
    return FOURLINK_VERSION;
}
