#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_kinds.sh FOURLINK DATA - each kind of picture, of both mechanisms, and each kind of file.
. "$(dirname "$0")/pictures.sh"

needs_gnuplot

# --- each kind, of both mechanisms
for deck in "$fourbar" "$engine"; do
    base=$(basename "$deck" .deck)
    run 0 "$deck"
    mv out table
    for kind in $kinds; do
        picture=$base-$kind.svg
        [ $kind = animation ] && picture=$base.gif
        if [ $kind = klein ] && [ $base = coupler-point ]; then
            run 2 --plot=$picture --plot-kind=$kind "$deck"
            says "Klein's construction needs a slider-crank"
            check 'no picture of it' test ! -e $picture
            continue
        fi
        run 0 --plot=$picture --plot-kind=$kind "$deck"
        quiet
        same out table
        check "the rights of $picture" test "$(ls -l $picture | cut -c1-10)" = -rw-r--r--
        [ $kind = animation ] && continue
        svg $picture
        shows $picture "$(sed -n 's/^title *= *//p' "$deck")" "$deck  |  fourlink $version"
    done
done
shows coupler-point-mechanism.svg 'open, theta2 = 60 deg' 'crossed, theta2 = 60 deg' 'x (mm)' 'y (mm)' 'path of C' \
    'path of P' A B C D P F12 F23 F34 F14 push W2 W3 W4 Ts 'push 12 N' 'W3 2.943 N' 'θ₂ = 60°'
shows coupler-point-motion.svg open crossed 'theta2 (deg)' 'theta3 (deg)' 'theta4 (deg)' 'omega3 (rad/s)' \
    'omega4 (rad/s)' 'alpha3 (rad/s2)' 'alpha4 (rad/s2)'
shows coupler-point-forces.svg open crossed F12 F23 F34 F14 Ts 'force (N)' 'Ts (N.m)' 'theta2 (deg)'
shows coupler-point-turning-moment.svg 'theta2 (deg)' 'turning moment -Ts (N.m)' -Ts mean above below
shows coupler-point-polar.svg open crossed 'F12_along (N)' 'F12_across (N)' 'F32_along (N)' 'F23_along (N)' \
    'F43_across (N)' 'F34_along (N)' 'F14_along (N)' 'F14_across (N)' "F14, ground on rocker, in the rocker's axes"
shows coupler-point-vectors.svg 'open, theta2 = 60 deg' 'velocity polygon' 'acceleration polygon' \
    'free body of the crank' 'free body of the coupler' 'free body of the rocker' 'forces on the crank' \
    'forces on the coupler' 'forces on the rocker' vB vC vCB aBn aCBn aCBt aCn aCt '-m aG' 'x (m/s)' 'y (m/s2)' \
    'x (N)' 'x (mm)' push
shows engine-mechanism.svg 'open, theta2 = 60 deg' 'x (mm)' 'path of C' gas N F12 F23 F34 Ts 'gas 20774 N' 'θ₃ = -16.78°'
shows engine-motion.svg open crossed 'x (mm)' 'v (m/s)' 'a (m/s2)' 'theta3 (deg)' 'omega3 (rad/s)' 'alpha3 (rad/s2)'
shows engine-forces.svg F12 F23 F34 N Ts 'force (N)' 'Ts (N.m)'
shows engine-turning-moment.svg 'turning moment -Ts (N.m)' mean
shows engine-polar.svg 'F12_along (N)' 'F43_across (N)' open crossed
shows engine-vectors.svg 'velocity polygon' 'free body of the rod' 'free body of the piston' 'forces on the piston' gas aC
shows engine-klein.svg "Klein's construction, open, theta2 = 60 deg" O B C M Q N K L 'OM = 152.52 mm' 'x (mm)'
check 'the engine has no rocker' none rocker engine-vectors.svg

# --- the other kinds of file
run 0 --plot=x.png "$fourbar"
quiet
magic x.png 8 '137 80 78 71 13 10 26 10'
check "x.png: width and height $(bytes x.png 16 8)" test "$(bytes x.png 16 8)" = '0 0 3 132 0 0 4 48'
check 'x.png: its end' test "$(tail -c 8 x.png | head -c 4)" = IEND
run 0 --plot=x.PDF --branch=open "$fourbar"
quiet
check 'x.PDF: the head' test "$(head -c 5 x.PDF)" = '%PDF-'
check 'x.PDF: the end' test "$(tail -n 1 x.PDF)" = '%%EOF'
magic coupler-point.gif 6 '71 73 70 56 57 97'
magic engine.gif 6 '71 73 70 56 57 97'
check "pictures of the animation: $(frames coupler-point.gif)" test "$(frames coupler-point.gif)" -eq 60
check "pictures of the animation: $(frames engine.gif)" test "$(frames engine.gif)" -eq 60
run 0 --plot=x.gif --plot-kind=motion "$fourbar"
quiet
check "x.gif: $(frames x.gif) pictures" test "$(frames x.gif)" -eq 1
run 0 "$fourbar"
mv out table
run 0 --plot=x.txt "$fourbar"
quiet
same out table
for text in 'Crank-rocker with a coupler point' 'coupler-point.deck' 'open, theta2 = 60 deg' 'path of P' 'F12'; do
    check "x.txt: $text" grep -qF -e "$text" x.txt
done
tr -d '\f' <x.txt >x.lines # gnuplot begins its page with a form feed
check 'x.txt: nothing but text' none '[[:cntrl:]]' x.lines
run 0 --plot=- "$fourbar"
cat table x.txt >expected
same out expected
run 0 -p - --output=o.txt "$fourbar"
same out x.txt
same o.txt table
"$fourlink" --plot=- - <"$fourbar" >out 2>err
check 'a deck from standard input' grep -qF '<stdin>  |  fourlink' out
if [ -c /dev/full ]; then
    ln -s /dev/full full.txt
    run 3 --plot=full.txt "$fourbar"
    says 'No space left on device'
    ln -s /dev/full full.gif
    run 3 --plot=full.gif "$fourbar"
    says 'No space left on device'
    "$fourlink" --plot=- --output=o.txt "$fourbar" >/dev/full 2>err
    check '--plot=- on a full disk' test $? -eq 3
fi

# --- a line of stroke that is not level
run 0 --plot=x.svg "$data/dfa-example-2-vertical.deck"
shows x.svg 'x rises at 90 deg'
check 'a level line of stroke' none 'x rises' engine-mechanism.svg

# --- several positions: the forces are on the first, which is thick
run 0 --plot-script=x.gp --branch=open --plot-at='40 deg, 100 deg, 200 deg' "$fourbar"
check 'one crank is thick' test "$(grep -c ' nohead ls 2$' x.gp)" -eq 1
check 'the others are thin' test "$(grep -c ' nohead ls 11$' x.gp)" -eq 6
check 'their angles' grep -q '^set label "200°" at' x.gp

finish
