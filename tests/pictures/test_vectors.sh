#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_vectors.sh FOURLINK DATA - tics and scales of polygons and free bodies, zeros, springs; drawn.py has their
# mechanics.
. "$(dirname "$0")/pictures.sh"
# --- each panel has two tics on each axis, and free bodies have a scale of forces
tics() { # tics SCRIPT: of each panel that is a drawing
    awk 'function few(low, high, step,  n) {n = int(high / step + 1e6) - int(low / step + 1e6); return n < 2}
        $1 == "step" {x = $2; y = $3}
        $1 == "range" {panels++; if (few($2, $3, x) || few($4, $5, y)) bad = 1}
        END {exit !(panels == 9 && !bad)}' "$1"
}
for angle in 0 60 130 200 299; do
    for deck in "$fourbar" "$engine"; do
        listed 0 v.list --plot-kind=vectors --plot-at="$angle deg" --branch=open "$deck"
        check "two tics at $angle deg of $(basename "$deck")" tics v.list
    done
done
sed 's/^step [^ ]*/step 1e9/' v.list >wrong.list
check 'too few tics are seen' not tics wrong.list
arrows v.list | awk -F '\t' '/^free body/ && $2 == "construction"' >scales
check "scales of forces: $(wc -l <scales)" test "$(wc -l <scales)" -eq 3

# --- nothing moves and nothing acts
listed 0 v.list --plot-kind=vectors --set=motion.speed=0 --set=gravity.acceleration=0 --set='load push.force=(0, 0) N' "$fourbar"
check 'all forces are zero' test "$(grep -c ' all forces are zero$' v.list)" -eq 6
check 'all velocities are zero' test -n "$(places_of 'all velocities are zero' v.list)"
check 'all accelerations are zero' test -n "$(places_of 'all accelerations are zero' v.list)"
listed 0 v.list --plot-kind=vectors "$fourbar"
check 'not all is zero' none 'are zero' v.list

# --- the piston's box, and the body out to a centre of mass that is off the line
listed 0 v.list --plot-kind=vectors "$engine"
arrows v.list line >arrows
check 'the box of the piston' test "$(grep -c '^free body of the piston	follower	' arrows)" -eq 4
check 'a straight rod' none '^free body of the rod	construction	' arrows
listed 0 v.list --plot-kind=vectors --set='rod.cg=(100, 40) mm' "$engine"
arrows v.list line >arrows
check 'a rod with its centre of mass off its line' test "$(grep -c '^free body of the rod	construction	' arrows)" -eq 2

# --- springs and dampers
cat >friction.deck <<'END'
mechanism = four-bar
[motion]
speed = 10 rad/s
[ground]
length = 80 mm
[crank]
length = 20 mm
mass = 0.1 kg
cg = 8 mm
[coupler]
length = 66 mm
mass = 0.3 kg
cg = (30, 4) mm
[rocker]
length = 56 mm
[load push]
link = rocker
torque = -0.5 N m
[spring S]
link = rocker
at = (30, 5) mm
to = coupler
to_at = 20 mm
stiffness = 300 N/m
[spring T]
link = rocker
to = ground
stiffness = 0.4 N m/rad
[friction]
A = 0.1
radius_A = 6 mm
B = 0.2
radius_B = 5 mm
C = 0.1
radius_C = 4 mm
[table]
branch = open
END
cat >guide.deck <<'END'
mechanism = slider-crank
[motion]
speed = 10 rad/s
[crank]
length = 50 mm
[rod]
length = 200 mm
mass = 1 kg
cg = 70 mm
[piston]
mass = 2 kg
[load water]
link = piston
force = -400 N
[spring damper]
link = ground
at = 350 mm
to = piston
damping = 200 N s/m
[friction]
A = 0.1
radius_A = 15 mm
C = 0.1
radius_C = 8 mm
guide = 0.2
[table]
branch = open
END
# --- friction of a slider on its lever is in F34, and no arrow of its own
for kind in vectors mechanism; do
    listed 0 v.list --plot-kind=$kind --plot-at='140 deg' "$decks/rubbing-slide.deck"
    quiet
    check "friction is in F34, $kind" none 'friction = ' v.list
done
# the links of an output have no friction, so that their free bodies stay as they are
sed '/^\[expect\]/,$d' "$data/watt-six-bar.deck" >plain.deck
{ cat plain.deck && printf '[friction]\nmu = 0.3\nradius = 12 mm\n'; } >rubbed.deck
for deck in plain rubbed; do
    listed 0 v.list --plot-kind=vectors --branch=open $deck.deck
    arrows v.list | grep '^free body of arm' >$deck.arrows
done
check "arrows of an output: $(wc -l <plain.arrows)" test "$(wc -l <plain.arrows)" -ge 8
check 'they are the same with friction' test "$(paste -d ' ' plain.arrows rubbed.arrows | tr '\t' ' ' |
    awk '{n = NF / 2; for (i = n - 3; i <= n; i++) bad += ($i - $(i + n)) ^ 2 > 1e-4} END {print NR, bad + 0}')" = "$(wc -l <plain.arrows) 0"
# in the mechanism: a zigzag and a spiral in black, their names and forces; a damper has no zigzag
listed 0 v.list --plot-at='20 deg' friction.deck
check 'the name of a spring' test -n "$(places_of S v.list)"
check 'the name of a torsional spring' test -n "$(places_of T v.list)"
check 'the force of a spring' grep -q '^note S = [-0-9.]* N$' v.list
# heads LISTING LOOK X Y: the number of arrows that begin so near to a place
heads() {
    awk -v look="$2" -v x="$3" -v y="$4" '$1 == "arrow" && $2 == look && ($3 - x) ^ 2 + ($4 - y) ^ 2 < 10 ^ 2 {n++}
        END {print n + 0}' "$1"
}
check 'the torque of a torsional spring on the ground, an arc at its pin beside that of the load' test "$(heads v.list load 80 0)" -eq 2
listed 0 w.list --plot-at='20 deg' --set='spring T.to=crank' --set='spring T.link=coupler' friction.deck
check 'of one between two links, an arc on each' test "$(heads w.list load 18.79 6.84)" -eq 2 -a "$(heads w.list load 80 0)" -eq 1
# a crank that is small beside the rest, enlarged: its pin forces and its torque
listed 0 w.list --plot-at='20 deg' --set='crank.length=4 mm' --set='crank.cg=2 mm' --set='coupler.length=60 mm' friction.deck
sed -n '/^name open, /,/^name at the crank, enlarged/p' w.list >inset.list
for force in F₁₂ F₂₃ Tₛ; do
    check "$force in an inset" test -n "$(places_of $force inset.list)"
done
check 'no force of the rocker in it' test -z "$(places_of F₁₄ inset.list)"
check 'friction of pins is no arrow' none '^\(text\|note\) .*friction' v.list
check "the lines of springs: $(grep -c '^line ground' v.list)" test "$(grep -c '^line ground' v.list)" -gt 75
listed 0 w.list --plot-at='20 deg' guide.deck
check 'the name of a damper' test -n "$(places_of damper w.list)"
check "the lines of a damper: $(grep -c '^line ground' w.list)" test "$(grep -c '^line ground' w.list)" -lt 25
listed 0 v.list --plot-kind=animation friction.deck
check 'springs move' test "$(places_of S v.list | wc -l)" -eq 60

finish
