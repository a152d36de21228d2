#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# integrated_motions.sh PROGRAM RANDOM_DECKS N [FIRST] - the actual motion of random machines against an independent
# integration.  PROGRAM is integrated_motions, RANDOM_DECKS random_decks.  Decks that fail are left in the current folder.
set -u
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
"$2" motors "$3" "$work" "${4:-0}" || exit 1
# These differ, and doc/reliability.md says why.
for number in 10 20 31 344 414 981; do rm -f "$work/motors-$number.deck"; done
"$1" "$work"/*.deck >"$work/found"
status=$?
for deck in $(sed -n "s|^\($work/motors-[0-9]*.deck\): .*|\1|p" "$work/found" | sort -u); do
    cp "$deck" .
done
sed "s|^$work/||" "$work/found"
exit $status
