#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_odd_decks.sh FOURLINK DATA - pictures of decks that are at a limit: no number of theirs is none.
. "$(dirname "$0")/pictures.sh"

all='mechanism motion forces turning-moment polar vectors limits klein'
# odd NAME KINDS ARGUMENT...: each kind draws, or says why not
odd() {
    name=$1
    wanted=$2
    shift 2
    drawn_kinds=
    for kind in $wanted; do
        rm -f x.svg
        "$fourlink" --plot=x.svg --plot-kind=$kind "$@" >out 2>err
        status=$?
        case $status in
        0 | 1)
            drawn_kinds="$drawn_kinds $kind"
            check "$name, $kind: messages: $(head -n 2 err)" \
                test "$(grep -c ' rows could not be computed: ' err)$(grep -vc ' rows could not be computed: ' err)" = "${status}0"
            check "$name, $kind: what is no number" awk 'tolower($0) ~ /(^|[^a-z])-?(nan|inf)([^a-z]|$)/ {bad = 1} END {exit bad}' x.svg
            svg x.svg
            ;;
        2)
            check "$name, $kind: one message: $(head -n 2 err)" grep -q '^fourlink: --plot-kind: error: ' err
            check "$name, $kind: a picture of nothing" test ! -e x.svg
            ;;
        *) check "$name, $kind: another exit status; $(head -n 2 err)" false ;;
        esac
    done
}
draws() { check "$name draws:$drawn_kinds, not: $1" test "$drawn_kinds" = " $1"; }

odd 'a crank that cannot turn fully' "$all" "$data/me3491-exercise-1.deck"
draws 'mechanism motion forces polar vectors limits'
odd 'parallelogram' "$all" "$fourbar" --set='crank.length=40 mm' --set='coupler.length=80 mm' --set='rocker.length=40 mm'
draws 'mechanism motion forces polar vectors limits'
odd 'deltoid' 'motion polar vectors' "$fourbar" --set='crank.length=40 mm' --set='ground.length=40 mm' --set='coupler.length=80 mm' \
    --set='rocker.length=80 mm'
draws 'motion polar vectors'
odd 'a crank at rest' "$all" "$fourbar" --set=motion.speed=0
draws 'mechanism motion forces polar vectors limits'
odd 'no force at all' "$all" "$fourbar" --set=motion.speed=0 --set=gravity.acceleration=0 --set='load push.force=(0, 0) N'
draws 'mechanism motion forces polar vectors limits'
odd 'one instant' "$all" "$data/me3491-example-1.deck"
draws 'mechanism motion forces turning-moment polar vectors limits klein'
odd 'a run-up' 'mechanism motion forces polar vectors' "$fourbar" --set=motion.speed=0 \
    --set='motion.acceleration=20 rad/s2' --set='motion.run_up=180 deg'
draws 'mechanism motion forces polar vectors'
odd 'a crank that stops' 'motion forces turning-moment' "$fourbar" --set='motion.acceleration=-100 rad/s2'
draws 'motion forces'
odd 'without masses' "$all" "$alvi"
draws 'mechanism motion vectors limits'
odd 'an offset engine, crossed' 'mechanism motion polar vectors klein' "$engine" --set='ground.offset=60 mm' --branch=crossed
draws 'mechanism motion polar vectors klein'
cat >narrow.deck <<'DECK' # reached within 0.8 deg of 360 deg, between the samples of a drawing
mechanism = four-bar
[ground]
length = 100 mm
[crank]
length = 50 mm
[coupler]
length = 30 mm
[rocker]
length = 20.003 mm
[motion]
speed = 1 rad/s
from = 0.9 deg
to = 360.9 deg
interval = 0.1 deg
DECK
odd 'a narrow reach' 'mechanism vectors' narrow.deck
draws 'mechanism vectors'
odd 'a rod as long as the crank' 'mechanism motion polar klein' "$engine" --set='rod.length=150 mm'
draws 'mechanism motion polar klein'
sed 's/^stroke = 300 mm/length = 150 mm/' "$engine" >short.deck
odd 'a rod shorter than the crank' 'mechanism motion polar klein' short.deck --set='rod.length=120 mm'
draws 'mechanism motion polar klein'
odd 'an engine at its dead centre' 'vectors klein' "$engine" --plot-at='0 deg'
draws 'vectors klein'
odd 'an engine at mid-stroke' 'vectors klein' "$engine" --plot-at='90 deg'
draws 'vectors klein'
odd 'a four-stroke cycle' 'motion turning-moment' "$engine" --set='motion.cycle=720 deg'
draws 'motion turning-moment'
odd 'inches and radians' 'mechanism turning-moment polar vectors' "$fourbar" --set=units.length=in --set=units.angle=rad
draws 'mechanism turning-moment polar vectors'
run 0 --plot=x.svg --set=units.length=in --set=units.angle=rad --plot-at='1 rad' "$fourbar"
shows x.svg 'x (in)' 'y (in)' 'open, θ₂ = 1 rad' 'θ₂ = 1 rad'
run 0 --plot=x.svg --set=units.angle=rad --plot-kind=motion "$fourbar"
shows x.svg 'θ₂ (rad)' 'θ₄ (rad)'
odd 'out of reach' "$all" "$data/me3491-exercise-1.deck" --set='motion.from=150 deg' --set='motion.to=200 deg'
check "nothing is drawn out of reach:$drawn_kinds" test -z "$drawn_kinds"
odd 'a crank that cannot turn fully' animation "$data/me3491-exercise-1.deck"
draws animation
odd 'one instant' animation "$data/me3491-example-1.deck"
draws animation
run 1 --plot=x.svg --plot-kind=animation --set='crank.length=40 mm' --set='rocker.length=40 mm' --set='coupler.length=80 mm' "$fourbar"
svg x.svg

finish
