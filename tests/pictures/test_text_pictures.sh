#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_text_pictures.sh FOURLINK DATA - pictures in a terminal: 79 columns, no grid over the curves,
# names of all axes.
. "$(dirname "$0")/pictures.sh"

needs_gnuplot

for deck in "$fourbar" "$engine"; do
    for kind in mechanism motion forces turning-moment polar vectors; do
        run 0 --plot=x.txt --plot-kind=$kind "$deck"
        quiet
        LC_ALL=C tr -d '\200-\277\f' <x.txt >x.letters
        check "$kind in a terminal: $(awk '{if (length($0) > n) n = length($0)} END {print n}' x.letters) columns" \
            awk 'length($0) > 79 {bad = 1} length($0) > 60 {n++} END {exit !(n > 10 && !bad)}' x.letters
        mv x.txt $kind-$(basename "$deck" .deck).txt
    done
done
for name in 'theta3 (deg)' 'theta4 (deg)' 'omega4 (rad/s)' 'alpha4 (rad/s2)' 'theta2 (deg)' 'open ***' 'crossed ###'; do
    check "a terminal's motion: $name" grep -qF -e "$name" motion-coupler-point.txt
done
for name in 'velocity polygon, y (m/s)' 'acceleration polygon, y (m/s2)' 'free body of the rod, y (mm)' 'forces on the piston, y (N)'; do
    check "a terminal's vectors: $name" grep -qF -e "$name" vectors-engine.txt
done
run 0 -b open --plot=x.txt "$data/alvi-5.1.deck"
check 'the coupler is told from the rocker and the crank' awk '
    {crank += gsub(/\*/, ""); coupler += gsub(/#/, ""); rocker += gsub(/\$/, "")}
    END {exit !(crank > 5 && crank < 15 && coupler > 20 && rocker > 12)}' x.txt
check 'moment and mean are told apart' grep -q -e '-Ts \*\**mean ##*' turning-moment-engine.txt
for kind in motion forces turning-moment polar; do
    run 0 --plot-script=x.gp --plot=x.txt --plot-kind=$kind "$fourbar"
    check "$kind: a grid in a terminal" none '^set grid' x.gp
    run 0 --plot-script=x.gp --plot=x.svg --plot-kind=$kind "$fourbar"
    check "$kind: no grid in a picture" grep -q '^set grid' x.gp
done

finish
