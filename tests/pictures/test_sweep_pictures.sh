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
# of many designs as many curves as the eye tells apart, and not one more
sweep 'coupler.length = 60 mm to 64 mm in 12' 'crank.length = 10 mm to 30 mm in 34' 'output = swing'
run 0 --plot=p.svg --plot-kind=columns t.deck
quiet
check 'twelve curves' none median p.svg
sweep 'coupler.length = 60 mm to 64 mm in 13' 'crank.length = 10 mm to 30 mm in 34' 'output = swing'
run 0 --plot=p.svg --plot-kind=columns t.deck
quiet
check 'more are their spread' grep -q median p.svg
# one value
sweep 'motion.speed = 10 rad/s, 20 rad/s' 'output = mu_min'
run 0 --plot=p.svg --plot-kind=columns t.deck
quiet

finish
