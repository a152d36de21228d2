#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# integrated_motions.sh PROGRAM DECKS [FIRST] - the actual motion of random machines against an independent integration.
# PROGRAM is integrated_motions.  Decks that fail are left in the current folder.
. "$(dirname "$0")/../python.sh"
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
python3 -B "$tests/random_decks.py" "$2" "$work" motors "${3:-0}" || exit 1
# These differ, and doc/reliability.md says why.
for seed in 315 584 834; do
    [ ! -f "$work/motors-$seed.deck" ] || { rm "$work/motors-$seed.deck" && echo "motors-$seed.deck is left out"; }
done
"$1" "$work"/*.deck >"$work/found"
status=$?
for deck in $(sed -n "s|^\($work/motors-[0-9]*.deck\): .*|\1|p" "$work/found" | sort -u); do
    cp "$deck" .
done
sed "s|^$work/||" "$work/found"
exit $status
