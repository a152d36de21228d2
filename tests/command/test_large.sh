#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_large.sh FOURLINK DATA - large files of any contents are read or refused in a time that is linear in their
# size; the limits of a deck and of a card.
. "$(dirname "$0")/../harness.sh"

# fast STATUS ARGUMENT...: the program ends with this status in few seconds of processor time; sanitizers need more
fast() {
    expected=$1
    shift
    (ulimit -t ${TEST_SECONDS:-8} && exec "$fourlink" "$@") >out 2>err </dev/null
    status=$?
    check "exit status $status, expected $expected: fourlink $*" test $status -eq "$expected"
}
# numbered N FORMAT: the format with each of the numbers from 1 to N
numbered() { awk -v n="$1" -v format="$2" 'BEGIN {for (i = 1; i <= n; i++) printf format, i}'; }

for what in '[expect]' '[sweep]' '[crank]'; do
    { cat "$alvi"; echo "[motion2]"; echo "$what"; numbered 100000 'T%d = 5\n'; } >x.deck
    [ "$what" = '[expect]' ] && sed -i.old '/motion2/d' x.deck
    fast "$([ "$what" = '[expect]' ] && echo 0 || echo 2)" x.deck
done
# names that are neither columns nor facts: all are in the results, a similar name only with the first
{ cat "$alvi"; echo '[expect]'; numbered 400000 'theta4_%d = 5\n'; } >x.deck
fast 2 --check --format=csv x.deck
says "x.deck:22: error: 'theta4_1' is neither a column nor a fact of this deck; did you mean 'theta4'?"
says 'fourlink: and 399900 more mistakes'
lines err 101
lines out 400002 # the head, the score
check 'similar names in the results' test "$(grep -c 'did you mean' out)" -eq 1000
{ cat "$alvi"; numbered 5000 'x%d\n'; } >x.deck
fast 2 x.deck
says 'fourlink: and 4900 more mistakes'
lines err 101
{ cat "$alvi"; numbered 400000 '[load F%d]\n'; } >x.deck
fast 2 x.deck
says 'more mistakes'
{ cat "$alvi"; printf '[table]\ncolumns = theta2'; numbered 300000 ',\nx%d'; } >x.deck
fast 2 x.deck
says "unknown column 'x1'"
{ cat "$alvi"; echo '[sweep]'; numbered 100000 'crank.x%d = 1\n'; } >x.deck
fast 2 x.deck
says 'fourlink: and 99900 more mistakes'
yes 'title = a title' | head -n 700000 >x.deck
fast 2 x.deck
says 'more mistakes'
yes '' | head -n 4100000 >x.deck
fast 2 x.deck
says 'x.deck:4000001: error: more than 4,000,000 lines: not a deck'

printf 'mechanism = slider-crank\n[crank]\nlength = 5 cm\n[rod]\nlength = 20 cm\n[gas]\nbore = 10 cm\n' >x.deck
printf 'indicator = file card.txt deg bar\n[motion]\nspeed = 10 rad/s\ninterval = 90 deg\n' >>x.deck
awk 'BEGIN {for (i = 0; i <= 100000; i++) printf "%.4f 1\n", i * 0.003}' >card.txt
fast 2 x.deck
says 'card.txt:100001: error: more than 100,000 points: not a curve'
head -n 100000 card.txt >card.new && mv card.new card.txt
fast 0 --list x.deck
numbered 5000 'x%d\n' >card.txt
fast 2 x.deck
says 'fourlink: and 4' # 99 more are said, the first is a header
awk 'BEGIN {for (i = 0; i < 70000; i++) printf "1"; print ""}' >card.txt
fast 2 x.deck
says 'card.txt:1: error: line longer than 65536 characters'
yes '' | head -n 4100000 >card.txt
fast 2 x.deck
says 'card.txt:4000001: error: more than 4,000,000 lines'

finish
