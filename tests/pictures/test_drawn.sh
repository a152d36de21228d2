#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_drawn.sh FOURLINK DATA [all] - the mechanics of what pictures draw, by drawn.py: some positions of chosen decks,
# with "all" a dozen of every deck on both branches.
. "$(dirname "$0")/../python.sh"
[ "${3-}" ] && export ALL=1
exec python3 -B "$tests/pictures/drawn.py" "$1" "$2" "$tests/decks"
