#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_readable.sh FOURLINK DATA - texts within the picture, and none on another.
. "$(dirname "$0")/pictures.sh"

needs_gnuplot
for deck in "$fourbar" "$engine"; do
    pictures_of "$deck" motion forces turning-moment polar vectors mechanism
done

# texts SVG: "X Y ANCHOR LETTERS WORDS" of each text that is not turned; letters are characters.  One in a
# box is there twice.
texts() {
    LC_ALL=C tr -d '\200-\277' <"$1" | LC_ALL=C awk '
        /<g transform="translate\(/ {at = $0; turned = /rotate/; sub(/.*translate\(/, "", at); split(at, p, /[,)]/)
            anchor = $0; sub(/.*text-anchor="/, "", anchor); sub(/".*/, "", anchor)}
        /<text>/ && !turned {words = $0; sub(/.*<text[^>]*>/, "", words); sub(/<\/text>.*/, "", words)
            gsub(/<[^>]*>/, "", words); gsub(/&[a-z0-9#]*;/, "x", words)
            if (words != "") print p[1], p[2], anchor, length(words), words}'
}
# A letter is at least so many pixels wide and high.
boxes='function box() {w = 6.5 * $4; l = $3 == "start" ? $1 : $3 == "end" ? $1 - w : $1 - w / 2; r = l + w}'
inside() { # inside SVG: no text goes beyond the picture
    width=$(sed -n 's/.*<svg *.*width="\([0-9]*\)".*/\1/p; s/^ *width="\([0-9]*\)".*/\1/p' "$1" | head -n 1)
    texts "$1" | LC_ALL=C awk -v width="$width" "$boxes"'
        {box(); if (l < 0 || r > width) {print; bad = 1}; n++} END {exit !(n > 5 && width > 100 && !bad)}' >outside
}
apart() { # apart SVG: no text stands on another
    texts "$1" | LC_ALL=C awk "$boxes"'
        {box(); for (i = 1; i <= n; i++) if (W[i] != $0 && l < R[i] && L[i] < r && $2 - Y[i] < 9 && Y[i] - $2 < 9) {
            print W[i] " / " $0; bad = 1}
         n++; L[n] = l; R[n] = r; Y[n] = $2; W[n] = $0}
        END {exit !(n > 5 && !bad)}' >outside
}
readable() {
    check "$1: texts beyond its edge: $(inside "$1"; head -n 3 outside)" inside "$1"
    check "$1: texts on each other: $(apart "$1"; head -n 3 outside)" apart "$1"
}
sed 's/translate(/translate(9/' engine-vectors.svg >wrong.svg
check 'texts beyond the edge are seen' not inside wrong.svg
sed 's/translate([0-9.]*,[0-9.]*)/translate(100,100)/' engine-vectors.svg >wrong.svg
check 'texts on each other are seen' not apart wrong.svg
for kind in motion forces turning-moment vectors mechanism; do
    readable coupler-point-$kind.svg
    readable engine-$kind.svg
done
inside coupler-point-polar.svg
check "polar: texts beyond its edge: $(head -n 3 outside)" inside coupler-point-polar.svg
for angle in 0 45 90 135 225 300; do
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
height=$(sed -n 's/.*<svg *.*height="\([0-9]*\)".*/\1/p; s/^ *width="[0-9]*" height="\([0-9]*\)".*/\1/p' x.svg | head -n 1)
check "values of many loads are in the picture of height $height" \
    test "$(texts x.svg | awk -v h="$height" '$5 ~ /^L[0-9]+$/ && $8 == "N" && $2 < h {n++} END {print n}')" -eq 36
inside x.svg
check "many loads: $(head -n 3 outside)" inside x.svg

# a title that is too long ends in an ellipsis
long_title >long.deck
run 0 --plot=x.svg long.deck
check "a long title: $(inside x.svg; head -n 1 outside)" inside x.svg
check 'a long title is shortened' grep -qF '…</text>' x.svg

finish
