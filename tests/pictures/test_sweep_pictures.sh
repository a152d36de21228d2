#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_sweep_pictures.sh FOURLINK DATA - curves of a sweep.
. "$(dirname "$0")/../command/sweeps.sh"
sweep 'crank.length = 10 mm to 30 mm step 10 mm' 'coupler.length = 60 mm to 64 mm step 2 mm' 'output = swing'
for ending in svg txt; do
    run 0 --plot=p.$ending --plot-kind=columns t.deck
    quiet
    check "as $ending" test -s p.$ending
done
check "the output is named" grep -q 'swing (°)' p.svg
# one value
sweep 'motion.speed = 10 rad/s, 20 rad/s' 'output = mu_min'
run 0 --plot=p.svg --plot-kind=columns t.deck
quiet

finish
