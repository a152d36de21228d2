#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# bench_unasked.sh FOURLINK DATA - what commands cost, as ratios to a fixed piece of work of the same run: a csv of 360 rows.
# Each stands for work that nobody asked for and was done once: a motion integrated to print a deck, forces for a column of
# angles, a point or a comparison computed again.  Counted in instructions by valgrind, or else in time.
# A bound is about 1.3 times what the ratio was when it was set; one that is above it is marked and, with CHECK=1, a failure.
set -u
fourlink=$(command -v "$1") data=$(cd "$2" && pwd) || exit 1
case $fourlink in /*) ;; *) fourlink=$PWD/$fourlink ;; esac
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
command -v valgrind >/dev/null && counts=1 || counts=0

# cost ARGUMENT...: millions of instructions, or milliseconds
cost() {
    if [ $counts = 1 ]; then
        valgrind --tool=callgrind --callgrind-out-file=/dev/null "$fourlink" "$@" 2>&1 >result |
            awk '/Collected/ {print $4 / 1e6}'
    else
        began=$(date +%s%N)
        for _ in 1 2 3 4 5; do "$fourlink" "$@" >result 2>&1; done
        echo $(($(date +%s%N) - began)) | awk '{print $1 / 5e6}'
    fi
}

failed=0
# ratio BOUND NAME ARGUMENT...
ratio() {
    bound=$1 name=$2
    shift 2
    cost "$@" | awk -v unit="$unit" -v bound="$bound" -v name="$name" -v counts=$counts '
        {
        above = counts && $1 / unit > bound
        printf "%8.2f  at most %-6g %s%s\n", $1 / unit, bound, name, above ? ": above its bound" : ""
        exit above
    }' || failed=$((failed + 1))
}

steady=$data/khurmi-16.11.deck run_up=$data/gerstmayr-run-up.deck plain=$data/me3491-matrix.deck
sweep() { cat "$plain" && printf '\n[sweep]\ncrank.length = 18 mm to 22 mm in %s\noutput = %s\n' "$1" "$2"; }
points() {
    cat "$plain"
    awk -v n="$1" 'BEGIN {while (k++ < n) printf "[point P%d]\nlink = coupler\nat = (%d, %d) mm\n", k, k % 40, k % 7}'
}
sweep 100 'mean(Ts), rms(Ts)' >mean.deck
sweep 100 mean_torque >turning.deck
sweep 3 'max(Ts)' >best.deck
points 100 >p100.deck
awk 'BEGIN {while (k++ < 720) printf "%.1f %.4f\n", k, 10 + 5 * sin(k / 57.3) + 3 * cos(k / 20)}' >card.txt
cat >card.deck <<'DECK'
mechanism = slider-crank
[crank]
length = 5 cm
[rod]
length = 20 cm
[gas]
bore = 10 cm
indicator = file card.txt deg bar
[motion]
speed = 10 rad/s
cycle = 720 deg
DECK
points 400 >p400.deck
"$fourlink" --expect -i '30 deg' "$plain" | sed 's/^\([A-Za-z].*= *-*[0-9]\)/\19/' >wrong

unit=$(cost -f csv -i '1 deg' "$plain")
ratio 0.16 'print the deck of a machine' --print-deck "$steady"
ratio 0.16 'a mistake in the deck of a machine' -c typo "$run_up"
ratio 0.16 'the stroke of a machine' -c stroke "$steady"
ratio 4.2 'solve for the stroke of a machine' --solve='crank.length = 150 mm .. 250 mm where stroke = 420 mm' "$steady"
ratio 3.8 'exact flywheel' "$steady"
ratio 1.2 'run-up, its table' -f csv "$run_up"
ratio 17.8 'csv of all decks' -f csv "$data"/*.deck
ratio 14 'check of all decks' --check "$data"/*.deck
ratio 0.29 '360 rows of an angle' -f csv -c theta4 -i '1 deg' "$plain"
ratio 1.3 '3600 rows of an angle' -c theta4 -i '0.1 deg' "$plain"
ratio 1.95 'picture of the motion' --plot=x.svg --plot-kind=motion "$plain"
ratio 2.7 'picture of the turning moment' --plot=x.svg --plot-kind=turning-moment "$plain"
ratio 5.7 'picture that moves' --plot=x.svg --plot-kind=animation "$plain"
ratio 0.8 'a card of 720 points' -c stroke card.deck
ratio 14 'mean and rms of 100 designs' -f csv mean.deck
ratio 20 'turning moment of 100 designs' -f csv turning.deck
ratio 0.73 'best at the end of a range' --best='min max(Ts)' best.deck
ratio 2.9 'wrong answers, in order' --check=wrong "$plain"
ratio 0.9 'list without a deck' --list
ratio 1.2 'csv of all columns, 100 points' -f csv -c all -i '90 deg' p100.deck
ratio 4.3 'csv of all columns, 400 points' -f csv -c all -i '90 deg' p400.deck
ratio 0.85 'list, 100 points' --list p100.deck
ratio 2.8 'list, 400 points' --list p400.deck
[ "${CHECK-}" != 1 ] || exit $((failed > 0))
