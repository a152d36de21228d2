#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_design.sh FOURLINK DATA - --design and --print-deck: one design of a sweep as a deck, decks as they are computed.
. "$(dirname "$0")/sweeps.sh"

sweep 'crank.length = 18 mm to 22 mm step 2 mm' 'rocker.length = 56 mm, 5.7 cm' 'output = mu_min, max(Ts)'

# the whole sweep has the values of each of its designs
run 0 -f csv t.deck
cp out whole
for n in 1 2 3 4 5 6; do
    run 0 --design=$n --print-deck -o d.deck t.deck
    check "design $n has no [sweep]" none sweep d.deck
    run 0 --design=$n -f csv t.deck
    cp out rows
    run 0 -f csv d.deck
    same out rows
    run 0 --summary -f csv --branch=open d.deck
    check "design $n has the outputs of the sweep" awk -F, -v n=$n \
        'NR == FNR {if ($1 == "max(Ts)") value = $2; next}
         $1 == n && $4 == "open" {ok = ($6 - value) ^ 2 < 1e-24 * value ^ 2} END {exit !ok}' out whole
done
check 'a value is in the unit of its line' grep -q '^length *= 22 mm' d.deck
for option in --expect --summary --matrix --list; do
    run 0 --design=2 $option t.deck
    check "$option works with one design" test -s out
done
run 0 --design=2 -p p.svg t.deck
check 'a picture of one design' test -s p.svg
run 0 --design=2 --report=r.html t.deck
check 'a report of one design' test -s r.html

# without `solver` a sweep solves by dyads, and so does the printed deck
grep -v '^solver' t.deck >default.deck
run 0 --design=5 --print-deck -o d.deck default.deck
check 'the solver of the sweep' grep -qx 'solver = dyad' d.deck
run 0 --design=5 -f csv default.deck
cp out rows
run 0 -f csv d.deck
same out rows

# all into a folder, in names that sort
mkdir -p designs
run 0 --design=all --print-deck -o designs/ t.deck
check 'six decks' test "$(ls designs)" = "$(printf 't-%d.deck\n' 1 2 3 4 5 6)"
run 0 --design=3 --print-deck t.deck
same out designs/t-3.deck
run 3 --design=all --print-deck -o nosuch/ t.deck

# a deck without a sweep is printed with what is set
printf 'mechanism = slider-crank\n[crank]\nlength = 50 mm # r\n[rod]\nlength = 0.2 m\n' >plain.deck
run 0 --print-deck plain.deck
same out plain.deck
run 0 --print-deck --set 'crank.length = 60 mm' plain.deck
check 'a value that is set' grep -qx 'length = 60 mm # r' out

# refused
run 2 --design=7 t.deck
check 'beyond the last' grep -q 'the \[sweep\] has 6 designs' err
run 2 --design=1 plain.deck
check 'no sweep' grep -q -- '--design needs a \[sweep\]' err
run 2 --design=all --print-deck -o designs/ plain.deck
run 2 --print-deck t.deck
check 'which design' grep -q -- '--design=N' err
for wrong in 0 -1 1.5 x ''; do
    run 2 --design="$wrong" t.deck
    check "--design=$wrong" grep -q 'must be a number from 1, or all' err
done
run 2 --design=all t.deck
run 2 --design=1 --part=1/2 t.deck
run 2 --print-deck --summary t.deck
run 2 --print-deck plain.deck plain.deck

finish
