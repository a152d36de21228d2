#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_drawn_rows.sh FOURLINK DATA - the mechanics of a report's drawing, by drawn.py.
. "$(dirname "$0")/../python.sh"
exec python3 -B "$tests/report/drawn.py" rows "$1" "$2" "$tests/decks"
