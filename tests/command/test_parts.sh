#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_parts.sh FOURLINK DATA - --part: the parts of a sweep against the whole.
. "$(dirname "$0")/sweeps.sh"

# parts N FORMAT: t.deck in so many parts, made from the last to the first, is `whole`
parts() {
    k=$1
    rm -f part.*
    while [ $k -ge 1 ]; do
        run 0 --part=$k/$1 -f "$2" -o "part.$k" t.deck
        k=$((k - 1))
    done
    all=
    while [ $k -lt "$1" ]; do
        k=$((k + 1))
        all="$all part.$k"
    done
    cat $all >together
    same together whole
    check "$1 parts: a header in one only" test "$(grep -c 'branch\b.*mu' together)" -eq "$(grep -c 'branch\b.*mu' whole)"
}

rows='motion.interval = 90 deg, 120 deg'
for output in "$rows" 'output = mu_min, type, max(Ts)'; do
    sweep 'crank.length = 18 mm to 22 mm step 1 mm' 'rocker.length = 56 mm +- 0.1 mm' 'samples = 2' "$output"
    for format in csv table; do
        run 0 -f $format -o whole t.deck
        for n in 1 2 3 7 30; do
            parts $n $format
        done
        run 0 -P 2/3 -f $format t.deck
        check 'a part is neither empty nor all' test -s out
        differ out whole
    done
    run 0 -f csv --part=2/3 t.deck
    check 'no header in a later part' none '^design' out
done

finish
