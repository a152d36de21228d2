#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_progress.sh FOURLINK DATA - a sweep shows its progress on a terminal, a search its time.
. "$(dirname "$0")/sweeps.sh"
needs script bsdutils

mkdir files
echo old >files/result
sweep 'crank.length = 18 mm to 22 mm in 300000000' 'output = mu_min, swing'
script -qec "timeout 2.2 '$fourlink' -f csv -o files/result t.deck" typed </dev/null >shown 2>&1
check 'progress on a terminal' grep -q 'of 300000000 designs, 0 %' shown
only_file files result

# A search from many starts tells its time on a terminal, and nowhere else.
printf 'mechanism = four-bar\n[synthesis]\ntask = path\npositions = (20, 20) mm, (20, 25) mm, (20, 30) mm, (20, 35) mm\n' >s.deck
script -qec "'$fourlink' --synthesis --effort=8 -o found s.deck" typed </dev/null >shown 2>&1
check 'the time of a search' grep -Eq '64000 starts took [0-9.]+ s' shown
"$fourlink" --synthesis --effort=8 s.deck >again 2>said
check 'not in a file' test ! -s said
check 'the same linkage' cmp found again

finish
