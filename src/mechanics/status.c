/* SPDX-License-Identifier: GPL-3.0-or-later
**
** status.c - the texts of the status codes, and the version.
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

const char *fourlink_version(void)
{
    return FOURLINK_VERSION;
}
