#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_look.sh FOURLINK DATA - lines in grey, by look.awk; the default position of decks with loads; names and units.
. "$(dirname "$0")/pictures.sh"
look() { awk -f "$pictures/look.awk" "$1" 2>&1; }
run 0 --plot=x.svg "$fourbar"
check "colours: $(look x.svg | head -n 3)" test -z "$(look x.svg)"
# it can fail
for change in 's/^\(.fourlink .coupler{stroke:#\)[0-9A-F]*/\10A2F7A/' 's/^\(.fourlink .load{stroke:#\)[0-9A-F]*/\1E69F00/' \
    's/^\(.fourlink .curve2{stroke:#\)[0-9A-F]*/\1D55E00/' 's/^\(.fourlink .coupler{.*stroke-width:\)[0-9.]*/\15/'; do
    sed "$change" x.svg >wrong.svg
    check "a wrong colour or width is seen: $change" test -n "$(look wrong.svg)"
done

# --- the default position: most loads act, no dead position is near
angle() { sed -n 's/^name .*, θ₂ = \(-*[0-9.]*\)°\(, \)*\(.*\)/\1 \3/p' x.list | head -n 1; }
shows_at() { # shows_at ANGLE REASON ARGUMENT...
    wanted="$1 $2"
    shift 2
    listed 0 x.list --branch=open "$@"
    check "the default: $(angle), expected $wanted" test "$(angle)" = "$wanted"
}
cat >press.deck <<'DECK'
mechanism = slider-crank
[units]
length = mm
[crank]
length = 50
[rod]
length = 180
[piston]
mass = 4 kg
[load press]
link = piston
force = -5 kN
from = 180 deg
to = 350 deg
[motion]
speed = 200 rpm
interval = 10 deg
DECK
shows_at 60 '' "$fourbar"
shows_at 210 'where press acts' press.deck # at 180, 190 and 200 deg crank and rod are nearly in line
shows_at 90 'where press acts' press.deck --set='load press.from=90 deg'
shows_at 60 '' press.deck --set='load press.from=0 deg'
{ cat press.deck && printf '[load tool]\nlink = rod\nat = mid\nforce = (0, -10) N\nfrom = 300 deg\nto = 340 deg\n'; } >two.deck
shows_at 300 'where 2 of 2 loads act' two.deck
shows_at 240 'where press acts' two.deck --set='load press.from=240 deg' --set='load press.to=250 deg' --set='load tool.to=280 deg' \
    --set='load tool.from=270 deg'
shows_at 150 'clear of dead positions' press.deck --set='load press.force=0 N' --set='motion.from=120 deg' --set='motion.to=480 deg' \
    --set='motion.interval=30 deg'
for kind in vectors klein limits; do
    shows_at 210 'where press acts' press.deck --plot-kind=$kind
done
listed 0 x.list --plot-at='60 deg' --branch=open press.deck
check 'no reason for what was asked for' none ' acts' x.list
run 0 --report=x.html --branch=open press.deck
check 'the report shows the same position' grep -q '210' x.html

# --- names and units of a book, but on a terminal
listed 0 x.list --plot-kind=columns --columns=F12x,Ts,alpha3,F12_along,G3.y,mu --branch=open "$fourbar"
for name in 'key curve1 F₁₂ₓ' 'y Tₛ (N·m)' 'y α₃ (rad/s²)' 'key curve2 F₁₂ along' 'y G₃.y (mm)' 'y μ (°)' 'x θ₂ (°)'; do
    check "no $name" grep -qxF "$name" x.list
done
{ cat "$fourbar" && printf '[sweep]\ncrank.length = 20 mm to 24 mm step 2 mm\noutput = time_ratio, mu_min\n'; } >names.deck
listed 0 x.list --plot-kind=columns --branch=open names.deck
check 'the words of a fact' grep -qxF 'y time ratio (1)' x.list
check 'its symbol' grep -qxF 'y μ min (°)' x.list
run 0 --plot=x.txt --plot-kind=columns --columns=F12x,Ts,mu --branch=open "$fourbar"
for name in 'F12x (N)' 'Ts (N.m)' 'mu (deg)' 'theta2 (deg)'; do
    check "a terminal has no $name" grep -qF "$name" x.txt
done

# --- sense of rotation: reversed with the speed
sense() { awk '/^arrow sense/ {s = $3 * $6 - $4 * $5; print (s > 0 ? 1 : -1)}' x.list; }
listed 0 x.list --branch=open "$fourbar"
check "the sense: $(sense)" test "$(sense)" = 1
listed 0 x.list --branch=open --set='motion.speed=-30 rad/s' "$fourbar"
check "the sense, reversed: $(sense)" test "$(sense)" = -1

# --- a slotted lever is drawn to its end; the letters of an animation do not jump
cat >lever.deck <<'DECK'
mechanism = inverted-slider-crank
[units]
length = mm
[ground]
length = 300
[crank]
length = 60
[lever]
mass = 9 kg
cg = 450 mm
inertia = 0.6 kg m2
[load cut]
link = lever
at = 900 mm
force = (0, 1200) N
[motion]
speed = 40 rpm
interval = 10 deg
DECK
listed 0 x.list --plot-at='90 deg' --branch=open lever.deck
check 'the lever ends at its load' awk '/^line follower/ {r = sqrt(($5 - 300) ^ 2 + $6 ^ 2); if (r > 899.9 && r < 900.1) n++}
    END {exit n != 1}' x.list
listed 0 x.list --plot-kind=animation --branch=open "$fourbar"
for letter in A D; do
    places=$(places_of $letter x.list | sort -u | wc -l)
    check "letter $letter stays: $places places" test "$places" -eq 1
done
check 'letter B stays outward of the crank' awk '/^line crank/ {x = $5; y = $6} /^text/ && $6 " " $7 == "B " {
    d = ($4 - x) * x + ($5 - y) * y; if (d < 0) bad = 1; n++} END {exit bad || n != 60}' x.list

finish
