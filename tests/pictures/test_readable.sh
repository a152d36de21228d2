#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_readable.sh FOURLINK DATA - texts within the picture, and none on another.
. "$(dirname "$0")/pictures.sh"

for deck in "$fourbar" "$engine"; do
    pictures_of "$deck" motion forces turning-moment polar vectors mechanism
done

# faults inside|apart|both SVG: the texts beyond the edge of the picture, or on another
faults() { LC_ALL=C awk -v question="$1" -f "$pictures/svg.awk" -f "$pictures/readable.awk" "$2" 2>&1; }
sound() {
    found=$(faults "$1" "$2" | head -n 3)
    check "$2: $found" test -z "$found"
}
readable() { sound both "$1"; }
sed 's/<text x="/&9/' engine-vectors.svg >wrong.svg
check 'texts beyond the edge are seen' test -n "$(faults inside wrong.svg)"
sed 's/<text x="[0-9.]*" y="[0-9.]*"/<text x="100" y="100"/' engine-vectors.svg >wrong.svg
check 'texts on each other are seen' test -n "$(faults apart wrong.svg)"
for kind in motion forces turning-moment vectors mechanism; do
    readable coupler-point-$kind.svg
    readable engine-$kind.svg
done
sound inside coupler-point-polar.svg
for angle in 0 135 300; do
    for branch in open crossed; do
        run 0 --plot=x.svg --plot-kind=klein --plot-at="$angle deg" --branch=$branch "$engine"
        readable x.svg
        shows x.svg O B C M Q N 'v and a are positive away' 'from the inner dead centre'
        run 0 --plot=x.svg --plot-kind=vectors --plot-at="$angle deg" --branch=$branch "$engine"
        readable x.svg
        run 0 --plot=x.svg --plot-kind=vectors --plot-at="$angle deg" --branch=$branch "$fourbar"
        readable x.svg
    done
done
# lengths of millionths of a millimetre, and a motion that is clockwise
set -- --set='ground.length=80e-9 mm' --set='crank.length=20e-9 mm' --set='coupler.length=66e-9 mm' --set='rocker.length=56e-9 mm' \
    --set='motion.speed=-1000 rad/s'
for kind in vectors motion mechanism; do
    run 0 --plot=x.svg --plot-kind=$kind --branch=open "$@" "$alvi"
    readable x.svg
done

# so many loads that their values need a higher picture
awk '1; END {for (i = 0; i < 36; i++) printf "[load L%d]\nlink = coupler\nat = %d mm\nforce = %d N at %d deg\n", i, i, 5 + i, 10 * i}' \
    "$fourbar" >many.deck
run 0 --plot=x.svg --branch=open many.deck
check 'values of many loads are in the picture' test "$(words x.svg | grep -c '^L[0-9]* = [0-9]* N$')" -eq 36
sound inside x.svg

# a title that is too long ends in an ellipsis
long_title >long.deck
run 0 --plot=x.svg long.deck
sound inside x.svg
check 'a long title is shortened' grep -qF '…</text>' x.svg

finish
