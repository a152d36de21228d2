#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_progress.sh FOURLINK DATA - a sweep shows its progress on a terminal.
. "$(dirname "$0")/sweeps.sh"
needs script bsdutils

mkdir files
echo old >files/result
sweep 'crank.length = 18 mm to 22 mm in 300000000' 'output = mu_min, swing'
script -qec "timeout 2.2 '$fourlink' -f csv -o files/result t.deck" typed </dev/null >shown 2>&1
check 'progress on a terminal' grep -q 'of 300000000 designs, 0 %' shown
only_file files result

finish
