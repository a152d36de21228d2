#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_drawn.sh FOURLINK DATA - the mechanics of what pictures draw, by drawn.py.
. "$(dirname "$0")/../python.sh"
exec python3 -B "$tests/pictures/drawn.py" "$1" "$2" "$tests/decks"
