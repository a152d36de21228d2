#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_drawn_angle.sh FOURLINK DATA SCENES [all] - the position that a report, or the page, draws first is the deck's.
. "$(dirname "$0")/../python.sh"
[ "${4-}" ] && every=1 || every=3
exec python3 -B "$tests/report/drawn_angle.py" "$1" "$3" $every "$2" "$tests/decks"
