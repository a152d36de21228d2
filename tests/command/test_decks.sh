#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_decks.sh FOURLINK DATA - decks from standard input, and several decks in one run.
. "$(dirname "$0")/../harness.sh"

cp "$decks/reach.deck" "$decks/bad.deck" .
cp "$decks/pump.deck" engine.deck
: >empty.deck
"$fourlink" "$alvi" >table
"$fourlink" -f csv "$alvi" >csv

# standard input
"$fourlink" <"$alvi" >out 2>err
check 'a deck on standard input' test $? -eq 0
same out table
"$fourlink" - <"$alvi" >out 2>err
same out table
"$fourlink" <bad.deck >out 2>err
check 'a bad deck on standard input' test $? -eq 2
nothing
says '<stdin>:5: error:'
cat "$alvi" | "$fourlink" -f csv - >out
same out csv
"$fourlink" <empty.deck >out 2>err
check 'nothing on standard input' test $? -eq 2
nothing
"$fourlink" <&- >out 2>err
check 'standard input closed' test $? -eq 3
nothing

# several decks, one of them bad: the others still run, and the status is the worst
run 0 -f csv "$alvi" engine.deck
check 'two decks' grep -q '^engine.deck,crossed,' out
for worst in '2 bad.deck' '3 missing.deck' '1 reach.deck'; do
    run ${worst%% *} -f csv "$alvi" ${worst#* } engine.deck
    check "alvi runs with $worst" grep -q "^$alvi,open,40,38.98" out
    check "engine runs with $worst" grep -q '^engine.deck,open,' out
done
run 3 missing.deck bad.deck reach.deck
says 'missing.deck'
says 'bad.deck:5'
prints 'A crank that cannot turn fully'
run 2 reach.deck bad.deck
run 3 -f csv bad.deck missing.deck
nothing
run 0 "$alvi" engine.deck
prints "# deck: $alvi"
prints '# deck: engine.deck'
holds 'four blocks, two blank lines apart' '
    /^$/ {blank++; next} {if (blank) {blocks++; if (blank != 2) bad = 1} blank = 0}
    END {exit bad || blocks != 3}'

finish
