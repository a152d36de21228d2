#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_scales.sh FOURLINK DATA - ranges of the axes, of an animation, an instant, a dead position; numbers at
# extremes.
. "$(dirname "$0")/pictures.sh"

# --- an animation has one scale
for deck in "$fourbar" "$engine" "$data/me3491-example-1.deck"; do
    run 0 --plot-script=x.gp --plot-kind=animation "$deck"
    for axis in x y; do
        check "$deck: frames" test "$(grep -c "^set ${axis}range" x.gp)" -eq 60
        check "$deck: ranges of its frames" test "$(grep "^set ${axis}range" x.gp | sort -u | wc -l)" -eq 1
    done
    check "$deck: the letters of its frames move" test "$(grep '^set label "B"' x.gp | sort -u | wc -l)" -gt 10
done

# --- an instant: its speed and acceleration in all positions of a cycle
instant="--set=motion.at=40deg --set=motion.speed=-30rad/s"
for acceleration in 0 50; do
    run 0 --plot=x.svg --plot-script=x.gp --plot-kind=motion --branch=open $instant --set="motion.acceleration=$acceleration rad/s2" "$fourbar"
    check 'a clockwise cycle' grep -q '^set xrange \[0:-360\]$' x.gp
    "$fourlink" --format=csv --branch=open $instant --set="motion.acceleration=$acceleration rad/s2" --set='motion.at=-40 deg' \
        --columns=omega4,alpha4 "$fourbar" >csv
    for name in omega4 alpha4; do
        near "$name of a held instant" "$(awk -v name=$name 'index($0, "$" name "_open ") == 1 {on = 1} /^EOD/ {on = 0}
            on && $1 == -40 {print $2}' x.gp)" "$(number $name)" 1e-6
    done
    [ $acceleration = 0 ] && held=', speed held' || held=', speed and acceleration held'
    check "told: $held" grep -qF "$held  |  fourlink" x.gp
done
run 0 --plot-script=x.gp --plot-kind=motion "$fourbar"
check 'a range is not held' none 'held' x.gp

# --- near a dead position
for kind in forces motion polar; do
    run 0 --plot-script=x.gp --plot-kind=$kind "$data/me3491-exercise-1.deck"
    check "$kind: a peak beyond the frame" awk '/range \[/ && !/xrange \[110/ {n++; r = $3; gsub(/[][]/, "", r); split(r, p, ":")
        if (!(p[2] > p[1] + 0) || p[2] - p[1] > 3000) bad = 1} END {exit !(n >= 4 && !bad)}' x.gp
    [ $kind = polar ] || check "$kind: it is told" grep -q "'beyond the frame near a dead position'" x.gp
    run 0 --plot-script=x.gp --plot-kind=$kind "$fourbar"
    check "$kind: nothing is beyond the frame" none 'beyond the frame' x.gp
done

# --- numbers of extremes: a maximum's above it, a minimum's below; the areas' have the digits of the title
run 0 --plot-script=x.gp --plot-kind=motion "$fourbar"
check 'extremes' awk '/^set label .* pt 7/ {split($NF, o, ","); above += o[2] > 0; below += o[2] < 0; if ($3 ~ /^"-0"$/) bad = 1}
    END {exit !(above >= 6 && below >= 6 && !bad)}' x.gp

finish
