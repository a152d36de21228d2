#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# random_drawn.sh FOURLINK RANDOM_DECKS N SCENES - draws N random decks: the mechanics of their pictures by drawn.py, and what the
# script of a report makes of them, and of N with outputs by rods and N by slots, by test_replayed.sh.  It prints how much was
# compared, and takes two seconds a deck.
set -u
tests=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
"$2" machines "$3" "$work" || exit 1
# drawn.py does not know the values of loads over a position
grep -lE '^over = (theta4|x|slide)$' "$work"/*.deck | xargs -r rm
status=0
ALL=1 sh "$tests/python.sh" "$tests/pictures/drawn.py" "$1" "$work" || status=1
for sort in outputs slots; do
    "$2" $sort "$3" "$work" || exit 1
done
sh "$tests/report/test_replayed.sh" "$1" "$tests/../data" "$4" "$work" || status=1
exit $status
