#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# brute_extremes.sh - the extremes of 10,000 random decks against brute force, in parts that run side by side.
#
#   sh tests/results/brute_extremes.sh [BUILD [PARTS [DECKS [SEED]]]]
#
# BUILD is the build folder.  Decks that fail are left in the current folder.
build=${1:-build} parts=${2:-2} decks=${3:-10000} seed=${4:-1}
each=$(((decks + parts - 1) / parts)) part=0 failed=0 running=
while [ $part -lt "$parts" ]; do
    "$build/brute_extremes" $each "$seed" $((part * each)) >"brute-$seed-$part.txt" &
    running="$running $!"
    part=$((part + 1))
done
for one in $running; do
    wait "$one" || failed=1
done
cat "brute-$seed"-*.txt
exit $failed
