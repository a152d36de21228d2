#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_drawn_rows.sh FOURLINK DATA [all] - the mechanics of a report's drawing, by drawn.py: of chosen decks, with
# "all" of every deck.
. "$(dirname "$0")/../python.sh"
[ "${3-}" ] && export ALL=1
exec python3 -B "$tests/report/drawn.py" rows "$1" "$2" "$tests/decks"
