#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_scales.sh FOURLINK DATA - ranges of the axes, of an animation, an instant, a dead position; numbers at
# extremes.
. "$(dirname "$0")/pictures.sh"
# --- an animation has one scale
for deck in "$fourbar" "$engine" "$data/me3491-example-1.deck"; do
    listed 0 x.list --plot-kind=animation "$deck"
    check "$deck: frames" test "$(grep -c '^range' x.list)" -eq 60
    check "$deck: ranges of its frames" test "$(grep '^range' x.list | sort -u | wc -l)" -eq 1
    check "$deck: the letters of its frames move" test "$(places_of B x.list | sort -u | wc -l)" -gt 10
done

# --- an instant: its speed and acceleration in all positions of a cycle
instant="--set=motion.at=40deg --set=motion.speed=-30rad/s"
for acceleration in 0 50; do
    listed 0 x.list --plot-kind=motion --branch=open $instant --set="motion.acceleration=$acceleration rad/s2" "$fourbar"
    check 'a clockwise cycle' grep -q '^range 360 0 ' x.list
    "$fourlink" --format=csv --branch=open $instant --set="motion.acceleration=$acceleration rad/s2" --set='motion.at=-40 deg' \
        --columns=omega4,alpha4 "$fourbar" >csv
    for name in omega4 alpha4; do
        near "$name of a held instant" "$(curve_of ${name}_open x.list | awk '($1 - 320) ^ 2 < 1e-6 {print $2}')" "$(number $name)" 2e-3
    done
    [ $acceleration = 0 ] && held=', speed held' || held=', speed and acceleration held'
    check "told: $held" grep -qF "$held  |  fourlink" x.list
done
listed 0 x.list --plot-kind=motion "$fourbar"
check 'a range is not held' none 'held' x.list

# --- near a dead position
for kind in forces motion polar; do
    listed 0 x.list --plot-kind=$kind "$data/me3491-exercise-1.deck"
    check "$kind: a peak beyond the frame" awk 'function fits(low, high) {n++; if (!(high > low) || high - low > 3000) bad = 1}
        $1 == "range" {fits($4, $5); if ($2 != 110) fits($2, $3)} END {exit !(n >= 4 && !bad)}' x.list
    [ $kind = polar ] || check "$kind: it is told" grep -q '^name .*beyond the frame near a dead position$' x.list
    listed 0 x.list --plot-kind=$kind "$fourbar"
    check "$kind: nothing is beyond the frame" none 'beyond the frame' x.list
done

# --- a restricted motion is drawn over what it covers
listed 1 x.list --plot-kind=motion --branch=open --set='crank.length=100 mm' --set='ground.length=120 mm' --set='coupler.length=40 mm' \
    --set='rocker.length=95 mm' "$alvi"
check 'from the first to the last position' awk '$1 == "range" {n++; if ($2 < 0 || $2 > 27 || $3 < 333 || $3 > 355) bad = 1}
    END {exit bad || !n}' x.list

# --- numbers of extremes: a maximum's above it, a minimum's below; the areas' have the digits of the title
listed 0 x.list --plot-kind=motion "$fourbar"
check 'extremes' awk '/^mark black/ {y = $5}
    $1 == "text" && $3 ~ /^curve/ {above += $5 > y; below += $5 < y; if ($6 == "-0") bad = 1}
    END {exit !(above >= 6 && below >= 6 && !bad)}' x.list

# --- zeros are 0, and angles go on through half a turn and through a change point
parallelogram="--set=crank.length=40mm --set=coupler.length=80mm --set=rocker.length=40mm"
listed 1 x.list --plot-kind=motion $parallelogram "$fourbar"
check 'no number of rounding' none '^text [^ ]* [^ ]* [^ ]* [^ ]* \([^ ]*e-\|-0$\)' x.list
check 'a zero of rounding is 0' awk '/^curve alpha[34]_open/ {on = 1; next} /^end/ {on = 0} on && NF == 2 {n++; if ($2 ^ 2 > 1e-4) bad = 1} END {exit !(n > 1400 && !bad)}' x.list
follows() { # follows NAME: the curve has no step of more than 20 deg
    curve_of "$1" x.list | awk 'NF == 2 {if (n++ && ($2 - y > 20 || y - $2 > 20)) bad = 1; y = $2} END {exit !(n > 700 && !bad)}'
}
check 'a rocker through a change point' follows theta4_open
check 'its other branch' follows theta4_crossed
listed 0 x.list --plot-kind=motion --set='ground.length=20 mm' --set='crank.length=60 mm' --set='motion.speed=-100 rpm' "$fourbar"
for name in theta3_open theta3_crossed theta4_open theta4_crossed; do
    check "a drag link: $name" follows $name
done
check 'a drag link turns round' awk '/^curve theta4_open/ {on = 1; next} /^end/ {on = 0} on && NF == 2 {if (!n++) first = $2; last = $2}
    END {d = first - last - 360; exit !(d < 0.5 && d > -0.5)}' x.list

# --- the instant of the deck in the picture of its cycle
listed 0 x.list --plot-kind=motion "$data/me3491-example-1.deck"
check 'the instant is marked' test "$(grep -c '^upright [^ ]* 40$' x.list)" -eq 6
check 'the instant is named' test "$(places_of 'θ₂ = 40°' x.list | wc -l)" -eq 6
listed 0 x.list --plot-kind=forces --branch=open --set='motion.at=40 deg' --set='motion.speed=-30 rad/s' "$fourbar"
check 'the instant of a clockwise cycle' test "$(grep -c '^upright [^ ]* 40$' x.list)" -eq 2
listed 0 x.list --plot-kind=motion "$fourbar"
check 'no instant of a range' none '^upright' x.list

# --- forces have one scale for all positions of a motion; where all are below it, a scale of their own
bar() { sed -n 's/^text [^ ]* [^ ]* [^ ]* [^ ]* \([0-9.]* k\{0,1\}N\)$/\1/p' x.list | tail -n 1; }
crusher=$data/me3491-exercise-4.deck
listed 0 x.list --plot-at='-140 deg' "$crusher"
large=$(bar)
listed 0 x.list --plot-at='-20 deg' "$crusher"
check "one scale: $large, $(bar)" test -n "$large" -a "$large" = "$(bar)"
check 'what is too small is said' grep -q 'no arrow below' x.list

# --- a picture is as high as its drawing: the ends of springs are in it
height() { sed -n 's/^picture [0-9]* //p' x.list; }
listed 0 x.list --branch=open "$engine"
low=$(height)
for end in at to_at; do
    { cat "$engine"; printf '[spring S]\nlink = rod\nto = ground\nstiffness = 10 N/m\nat = (60, 0) mm\nto_at = (60, 0) mm\n' |
        sed "s/^$end = .*/$end = (60, 400) mm/"; } >far.deck
    listed 0 x.list --branch=open far.deck
    check "a spring with $end far above: $low, $(height)" test "$(height)" -gt $((low + 20))
done

listed 0 x.list --branch=open --set='ground.angle=30 deg' "$engine"
risen=$(height)
listed 0 x.list --branch=open --set='ground.angle=60 deg' "$engine"
check "an engine rises: $low, $risen, $(height)" test $low -lt $risen -a $risen -lt "$(height)"

# --- a mechanism that is higher than wide is as wide in its picture as another
cat >high.deck <<'DECK'
mechanism = four-bar
[units]
length = mm
[ground]
length = 120
[crank]
length = 100
[coupler]
length = 40
[rocker]
length = 95
[motion]
speed = 60 rpm
interval = 10 deg
DECK
listed 1 x.list --branch=crossed high.deck
check 'it is not small' awk '$1 == "range" {exit !($3 - $2 < 240)}' x.list

finish
