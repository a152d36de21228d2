#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_text_pictures.sh FOURLINK DATA - pictures in a terminal: 79 columns, no grid over the curves,
# names of all axes.
. "$(dirname "$0")/pictures.sh"
LC_ALL=C.UTF-8 # pictures in a terminal have its letters
export LC_ALL

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
for name in 'theta3 (deg)' 'theta4 (deg)' 'omega4 (rad/s)' 'alpha4 (rad/s2)' 'theta2 (deg)' 'open' 'crossed'; do
    check "a terminal's motion: $name" grep -qF -e "$name" motion-coupler-point.txt
done
for name in 'velocity polygon, y (mm/s)' 'acceleration polygon, y (mm/s2)' 'free body of the rod, y (mm)' 'forces on the piston, y (N)'; do
    check "a terminal's vectors: $name" grep -qF -e "$name" vectors-engine.txt
done
# lines are Braille, with --ascii or without UTF-8 dots; both have the same shape and the same places
run 0 -b open --plot=braille.txt "$data/alvi-5.1.deck"
check 'Braille' grep -q '⠤\|⠉\|⡇' braille.txt
run 0 -b open --plot=ascii.txt --ascii "$data/alvi-5.1.deck"
check 'nothing but ASCII' none '[^ -~]' ascii.txt
LC_ALL=C LANG= "$fourlink" -b open --plot=c.txt "$data/alvi-5.1.deck"
same c.txt ascii.txt
LC_ALL= LC_CTYPE= LANG=de_DE.utf8 "$fourlink" -b open --plot=c.txt "$data/alvi-5.1.deck"
same c.txt braille.txt
check 'as many lines' test "$(wc -l <ascii.txt)" -eq "$(wc -l <braille.txt)"
check 'Greek letters in words' grep -q 'theta2 = ' ascii.txt
check 'the pins' awk '/A/ {a = 1} /B/ {b = 1} /C/ {c = 1} /D/ {d = 1} END {exit !(a && b && c && d)}' ascii.txt

finish
