#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_drawn_decks.sh FOURLINK DATA [N] - N decks of linkages that are drawn on the page, against the command: drawn.js.
. "$(dirname "$0")/../harness.sh"

needs node nodejs
node "$(dirname "$data")/tests/web/drawn.js" "$fourlink" "$(dirname "$data")" "${3-100}" >out 2>&1
check "$(cat out)" grep -q ' 0 failed$' out
finish
