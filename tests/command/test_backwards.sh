#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_backwards.sh FOURLINK DATA - questions answered backwards, --solve; solve.py asks random ones.
. "$(dirname "$0")/../harness.sh"

# Closed forms: the swing of a centric quick return, sin(swing/2) = crank/ground; the stroke of a slider-crank, 2 r.
printf 'mechanism = inverted-slider-crank\n[ground]\nlength = 200 mm\n[crank]\nlength = 60 mm\n[motion]\nspeed = 10 rad/s\n' >lever.deck
run 0 -f csv -b open --solve='crank.length = 20 mm .. 180 mm where swing = 60 deg' lever.deck
check "r = d sin 30 deg: $(cat out)" awk -F, 'NR == 2 {ok = $2 > 0.0999999999 && $2 < 0.1000000001} END {exit !ok}' out
check 'one line' test "$(wc -l <out)" -eq 2
printf 'mechanism = slider-crank\n[crank]\nlength = 40 mm\n[rod]\nlength = 150 mm\n[motion]\nspeed = 10 rad/s\n' >engine.deck
run 0 -f csv -b open --solve='crank.length = 10 mm .. 100 mm where stroke = 120 mm' engine.deck
check "stroke: $(cat out)" awk -F, 'NR == 2 {ok = $2 > 0.0599999999 && $2 < 0.0600000001} END {exit !ok}' out
# v = omega r at 90 deg of a centric slider-crank
run 0 -f csv -b open --solve='motion.speed = 1 rad/s .. 100 rad/s where v at 90 deg = 2 m/s' engine.deck
check "speed: $(cat out)" awk -F, 'NR == 2 {ok = $2 > 49.99999999 && $2 < 50.00000001} END {exit !ok}' out
# the value set again
run 0 -f csv -b open --solve='rocker.length = 40 mm .. 70 mm where swing = 50 deg' "$alvi"
check "swing: $(cat out)" test "$(wc -l <out)" -eq 2
at=$(awk -F, 'NR == 2 {print $2}' out)
"$fourlink" -f csv -b open -c swing --set "rocker.length=$at m" "$alvi" >set
check "set again: $(cat set)" awk -F, 'NR == 2 {exit !($2 > 49.9999999999 && $2 < 50.0000000001)}' set

# the deck of the first, lines for people, nothing found
run 0 --print-deck --solve='crank.length = 10 mm .. 30 mm where swing = 40 deg' "$alvi"
check "the deck: $(grep -A 1 '^.crank' out)" grep -q '^length = 19.0401781986504[0-9]* mm$' out
"$fourlink" -f csv -b open -c swing out >set
check "its swing: $(cat set)" awk -F, 'NR == 2 {exit !($2 > 39.9999999999 && $2 < 40.0000000001)}' set
run 0 -b open --solve='crank.length = 10 mm .. 30 mm where swing = 40 deg' "$alvi"
prints 'open      19.0401781987 mm, swing = 40 deg'
run 1 --solve='rocker.length = 40 mm .. 70 mm where swing = 95 deg' "$alvi"
says 'swing is not 95 deg in this range of rocker.length: it goes from 34.6848 to 61.4195'
swing=$("$fourlink" -f csv -b open -c swing "$alvi" | awk -F, 'NR == 2 {print $2}')
run 0 -b open --solve="motion.speed = 1 rad/s .. 5 rad/s where swing = $swing deg" "$alvi"
check 'many lines of a result that stays' test "$(wc -l <out)" -eq 1
says 'the result has this value in a part of the range, or in all of it'

# mistakes
for words in 'crank.length = 1 mm' 'crank.length = 1 mm .. 2 mm' 'crank.length 1 mm .. 2 mm where swing = 3 deg' 'crank.length = 1 mm .. 2 mm where swing'; do
    run 2 --solve="$words" "$alvi"
    says "expected 'KEY = LOW .. HIGH where NAME = VALUE'"
done
run 2 --solve='crank.lengh = 1 mm .. 2 mm where swing = 3 deg' "$alvi"
says "'crank.lengh' is no column, fact, extreme or input of this deck"
run 2 --solve='crank.length = 1 mm .. 2 kg where swing = 3 deg' "$alvi"
says "'2 kg' is a mass; expected a length, such as 80 mm"
run 2 --solve='crank.length = 3 mm .. 2 mm where swing = 3 deg' "$alvi"
says 'the range has to rise: LOW .. HIGH'
run 2 --solve='crank.length = 1 mm .. 2 mm where theta4 = 3 deg' "$alvi"
says "'theta4' has a value in each row: ask for it at a crank angle, 'theta4 at 60 deg', or for its max() or min()"
run 2 --solve='crank.length = 1 mm .. 2 mm where swing at 3 deg = 3 deg' "$alvi"
says "'swing' is one value of the deck: it has none at an angle"
run 2 --solve='crank.length = 1 mm .. 2 mm where swing = 3 deg' "$alvi" "$alvi"
says '--solve prints a table or csv of one deck, and no other output'
finish
