#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_kinds.sh FOURLINK DATA - each kind of picture, of both mechanisms, and each kind of file.
. "$(dirname "$0")/pictures.sh"
LC_ALL=C.UTF-8 # pictures in a terminal have its letters
export LC_ALL

# --- each kind, of both mechanisms
for deck in "$fourbar" "$engine"; do
    base=$(basename "$deck" .deck)
    for kind in $kinds; do
        picture=$base-$kind.svg
        if [ $kind = klein ] && [ $base = coupler-point ]; then
            run 2 --plot=$picture --plot-kind=$kind "$deck"
            says "Klein's construction needs a slider-crank"
            check 'no picture of it' test ! -e $picture
            continue
        fi
        run 0 --plot=$picture --plot-kind=$kind "$deck"
        quiet
        nothing
        check "the rights of $picture" test "$(ls -l $picture | cut -c1-10)" = -rw-r--r--
        svg $picture
        shows $picture "$(sed -n 's/^title *= *//p' "$deck")" "$(basename "$deck")  |  fourlink $version"
    done
done
shows coupler-point-mechanism.svg 'open, θ₂ = 60°' 'crossed, θ₂ = 60°' 'x (mm)' 'y (mm)' 'path of C' \
    'path of P' A B C D P F₁₂ F₂₃ F₃₄ F₁₄ push W₂ W₃ W₄ Tₛ g 'push = 12 N' 'W₃ = 2.943 N' 'pin force, i on j' 'load or weight' '1 ground, 2 crank,' '3 coupler, 4 rocker' 'θ₂ = 60°'
shows coupler-point-motion.svg open crossed 'θ₂ (°)' 'θ₃ (°)' 'θ₄ (°)' 'ω₃ (rad/s)' \
    'ω₄ (rad/s)' 'α₃ (rad/s²)' 'α₄ (rad/s²)'
shows coupler-point-forces.svg open crossed F₁₂ F₂₃ F₃₄ F₁₄ Tₛ 'force (N)' 'Tₛ (N·m)' 'θ₂ (°)'
shows coupler-point-turning-moment.svg 'θ₂ (°)' 'turning moment -Tₛ (N·m)' -Tₛ mean above below
shows coupler-point-polar.svg open '30° apart' 'F₁₂ along (N)' 'F₁₂ across (N)' 'F₃₂ along (N)' 'F₂₃ along (N)' \
    'F₄₃ across (N)' 'F₃₄ along (N)' 'F₁₄ along (N)' 'F₁₄ across (N)' "F₁₄ on the rocker, in its axes"
shows coupler-point-vectors.svg 'open, θ₂ = 60°' 'velocity polygon' 'acceleration polygon' \
    'free body of the crank' 'free body of the coupler' 'free body of the rocker' 'forces on the crank' \
    'forces on the coupler' 'forces on the rocker' vB vC vCB aBn aCBn aCBt aCn aCt '-m aG' 'x (mm/s)' 'y (mm/s²)' \
    'x (N)' 'x (mm)' push
shows engine-mechanism.svg 'open, θ₂ = 60°' 'x (mm)' 'path of C' gas N F₁₂ F₂₃ F₃₄ Tₛ 'gas = 20774 N' 'θ₃ = -16.78°'
shows engine-motion.svg open crossed 'x (mm)' 'v (mm/s)' 'a (mm/s²)' 'θ₃ (°)' 'ω₃ (rad/s)' 'α₃ (rad/s²)'
shows engine-forces.svg F₁₂ F₂₃ F₃₄ N Tₛ 'force (N)' 'Tₛ (N·m)'
shows engine-turning-moment.svg 'turning moment -Tₛ (N·m)' mean
shows engine-polar.svg 'F₁₂ along (N)' 'F₄₃ across (N)' open
# polar: one branch unless both are asked for
check 'polar: not asked for the crossed branch' none '>crossed<' coupler-point-polar.svg
run 0 --plot=x.svg --plot-kind=polar --branch=both "$fourbar"
shows x.svg open crossed
run 0 --plot=x.svg --plot-kind=polar --branch=crossed "$fourbar"
shows x.svg crossed
check 'polar: not asked for the open branch' none '>open<' x.svg
{
    cat "$fourbar"
    printf '[table]\nbranch = both # of them\n'
} >both.deck
run 0 --plot=x.svg --plot-kind=polar both.deck
shows x.svg open crossed
# a comment is not asked for, and neither is the branch of a printed value
cp "$fourbar" own.deck
listed 0 own.list --plot-kind=polar own.deck
echo '# which branch = both' >>own.deck
listed 0 x.list --plot-kind=polar own.deck
same own.list x.list
cp both.deck own.deck
listed 0 own.list --plot-kind=polar own.deck
printf '[expect]\nat = 20 deg\nbranch = open\ntheta4 = 1 deg\n' >>own.deck
listed 0 x.list --plot-kind=polar own.deck
same own.list x.list
# the load of the crusher jumps twice: its curves have two dashed lines from end to end; an arrow leads the way
run 0 --plot=x.svg --plot-kind=polar "$data/me3491-exercise-4.deck"
shows x.svg open jump '30° apart' -90° -180°
listed 0 x.list --plot-kind=polar "$data/me3491-exercise-4.deck"
check 'two jumps of each pin force' awk '/^curve .*_jumps / {on = 1; n = 0; next} on && /^end/ {on = 0; if (n != 4 && n != 5) bad = 1; panels++}
    on && NF == 2 {n++} END {exit !(panels == 6 && !bad)}' x.list
check 'the direction of travel' test "$(grep -c '^arrow curve1 ' x.list)" -eq 6
check 'the force jumps by the load' awk '/^curve F14_jumps/ {on = 1; next} /^end/ {on = 0}
    on && NF == 2 {if (++n % 2) {x = $1; y = $2} else {d = sqrt(($1 - x) ^ 2 + ($2 - y) ^ 2); if (d < 500 || d > 6000) bad = 1}}
    END {exit !(n == 4 && !bad)}' x.list
listed 0 x.list --plot-kind=polar "$fourbar"
check 'a steady load does not jump' none '_jumps' x.list
shows engine-vectors.svg 'velocity polygon' 'free body of the rod' 'free body of the piston' 'forces on the piston' gas aC
shows engine-klein.svg "Klein's construction, open, θ₂ = 60°" O B C M Q N K L 'OM = 152.52 mm' 'x (mm)'
check 'the engine has no rocker' none rocker engine-vectors.svg

# --- the other kinds of file
if command -v rsvg-convert >/dev/null; then
    run 0 --plot=x.png "$fourbar"
    quiet
    magic x.png 8 '137 80 78 71 13 10 26 10'
    check "x.png: width and height $(bytes x.png 16 8)" test "$(bytes x.png 16 8)" = '0 0 7 8 0 0 9 244'
    check 'x.png: its end' test "$(tail -c 8 x.png | head -c 4)" = IEND
    run 0 --plot=x.PDF --branch=open "$fourbar"
    quiet
    check 'x.PDF: the head' test "$(head -c 5 x.PDF)" = '%PDF-'
    check 'x.PDF: the end' grep -aq '^%%EOF' x.PDF
fi
for ending in png pdf; do
    "$(command -v env)" PATH=/nonexistent "$fourlink" --plot=y.$ending "$fourbar" >out 2>err
    check "without rsvg-convert: $?" test ! -e y.$ending
    says 'rsvg-convert, which makes png and pdf, is not installed; its package is librsvg2-bin'
done
# what the converter does: its output is the file, byte by byte; why it fails is told; it inherits nothing that is open
mkdir -p bin
# converter LINE...: rsvg-convert is a script of these lines
converter() {
    printf '%s\n' '#!/bin/sh' "$@" >bin/rsvg-convert
    chmod +x bin/rsvg-convert
}
plain_path=$PATH
PATH=$PWD/bin:$PATH
for bytes in 1 8193; do
    converter 'cat >svg' "head -c $bytes svg"
    run 0 --plot=y.png "$fourbar"
    quiet
    check "a picture of $bytes bytes" test "$(head -c $bytes svg)" = "$(cat y.png)"
done
rm y.png
converter 'true <&9 && echo open >inherited' 'echo ran >ran' 'echo x'
run 0 --plot=y.png "$fourbar" 9<"$fourbar"
check 'the converter is run' test -s ran
check 'an open file is not handed on' test ! -e inherited
rm y.png
fails_with() {
    "$fourlink" --plot=y.png "$fourbar" >out 2>err
    check "exit status of a converter that fails: $1" test $? -eq 3
    check "no file: $1" test ! -e y.png
    says "$1"
}
converter 'echo a library is missing >&2' 'exit 127'
fails_with 'rsvg-convert failed: a library is missing'
converter 'echo x' 'kill -9 $$'
fails_with 'rsvg-convert failed'
PATH=$plain_path
"$(command -v env)" PATH=/nonexistent "$fourlink" --plot=y.svg "$fourbar" >out 2>err
check 'an SVG needs no other program' test -s y.svg
# a picture that moves: all frames, the last again the first
for deck in coupler-point engine; do
    check "frames of $deck" test "$(grep -o '<animate [^>]*>' $deck-animation.svg | head -n 1 | tr -dc ';' | wc -c)" -eq 60
    check "$deck is one picture" test "$(grep -c '<title>' $deck-animation.svg)" -eq 1
done
usage "an animation needs a file name that ends in .svg, not 'x.png'" --plot=x.png --plot-kind=animation "$fourbar"
run 0 "$fourbar"
mv out table
run 0 --plot=x.txt "$fourbar"
quiet
nothing
for text in 'Crank-rocker with a coupler point' 'coupler-point.deck' 'open, θ₂ = 60°' 'path of P' 'F₁₂'; do
    check "x.txt: $text" grep -qF -e "$text" x.txt
done
check 'x.txt: nothing but text' none '[[:cntrl:]]' x.txt
run 0 --plot=- "$fourbar"
same out x.txt
run 0 -p - --output=o.txt "$fourbar"
same out x.txt
same o.txt table
"$fourlink" --plot=- - <"$fourbar" >out 2>err
check 'a deck from standard input' grep -qF '<stdin>  |  fourlink' out
if [ -c /dev/full ]; then
    ln -s /dev/full full.txt
    run 3 --plot=full.txt "$fourbar"
    says 'No space left on device'
    "$fourlink" --plot=- --output=o.txt "$fourbar" >/dev/full 2>err
    check '--plot=- on a full disk' test $? -eq 3
fi

# --- a line of stroke that is not level
run 0 --plot=x.svg "$data/dfa-example-2-vertical.deck"
shows x.svg 'x rises at 90°' 'horizontal (mm)' 'vertical (mm)' g x 'F₁₂ = 131.13 kN' '100 kN'
check 'a level line of stroke' none 'x rises' engine-mechanism.svg
check 'axes of a level line of stroke' none 'horizontal' engine-mechanism.svg
# turned TAN SCRIPT: the pins A, B and C as in the level engine, turned by an angle with this tangent
pins() { awk '/^disc white/ {print $3 "," $4}' "$1" | tail -n 3; }
listed 0 x.list --branch=open "$engine"
pins x.list >level
listed 0 x.list --branch=open --set='ground.angle=30 deg' "$engine"
pins x.list >risen
check 'the engine stands as it is inclined' awk -F, 'NR == FNR {x[FNR] = $1; y[FNR] = $2; next}
    {c = sqrt(0.75); X = c * x[FNR] - 0.5 * y[FNR]; Y = 0.5 * x[FNR] + c * y[FNR]; n++
        if ($1 - X > 1e-3 || X - $1 > 1e-3 || $2 - Y > 1e-3 || Y - $2 > 1e-3) bad = 1; if (Y > 50) high = 1}
    END {exit !(n == 3 && high && !bad)}' level risen
check 'gravity acts downwards' awk '$2 == "load" && $3 == $5 && $4 > $6 {down++}
    END {exit !down}' x.list
listed 0 x.list --set=gravity.acceleration=0 --branch=open "$fourbar"
check 'no gravity' test -z "$(places_of g x.list)"

# --- a link with several points has one outline, and each path its own style
{
    cat "$fourbar"
    for at in '10, 30' '50, 30' '30, 5' '40, -20' '60, 10' '20, 12' '25, -9' '33, 8'; do
        n=$((${n:-0} + 1))
        printf '[point Q%s]\nlink = coupler\nat = (%s) mm\n' $n "$at"
    done
} >nine.deck
listed 0 x.list --branch=open nine.deck
styles=$(grep -o '^key [^ ]* path of' x.list | sort -u | wc -l)
check "paths of nine points: $styles styles" test "$styles" -eq 10
check "the outline of the coupler: $(grep -c '^line coupler' x.list) lines" \
    awk '/^line coupler/ {if (n++ && $3 " " $4 != last) jumps++; last = $5 " " $6} END {exit !(n >= 4 && n <= 9 && jumps <= 1)}' x.list

# --- numbers with prefixes
run 0 --plot=x.svg --branch=open --set='load push.force=(0.3, 0.4) MN' "$fourbar"
shows x.svg 'push = 500 kN'
run 0 --plot=x.svg --branch=open --set='load push.force=(0.0003, 0.0004) N' "$fourbar"
shows x.svg 'push = 500 µN'

# --- several positions: the forces are on the first, which is thick
listed 0 x.list --branch=open --plot-at='40 deg, 100 deg, 200 deg' "$fourbar"
check 'one crank is thick' test "$(grep -c '^line crank' x.list)" -eq 1
check 'the others are thin' test "$(grep -c '^line other' x.list)" -eq 6
check 'their angles' test -n "$(places_of 200° x.list)"

finish
