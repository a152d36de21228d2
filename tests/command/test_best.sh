#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_best.sh FOURLINK DATA - --best: the best design of a sweep, refined, as a deck that can be run.
. "$(dirname "$0")/sweeps.sh"

# best WHICH ARGUMENT...: best.deck is the best design of t.deck, and `value` what its first line says
best() {
    which=$1
    shift
    run 0 --best="$which" "$@" t.deck
    quiet
    cp out best.deck
    value=$(sed -n '1s/.* = \([^ ,]*\).*/\1/p' best.deck)
    check "no sweep: $which" none '^\[sweep\]' best.deck
}
# gives NAME BRANCH VALUE TOLERANCE: best.deck has this value
gives() {
    run 0 -S -f csv -b "$2" best.deck
    check "$1 of the best deck: $(grep "^$1," out)" awk -F, -v name="$1" -v x="$3" -v e="$4" '
        $1 == name {d = $2 - x; ok = d * d <= e * e} END {exit !ok}' out
}

# closed form: mu_min is at crank angle 0 for the crank of
# a crank-rocker, and 45 deg if (d - a)^2 = b^2 + c^2 - 2 b c cos(45 deg)
sweep 'crank.length = 5 mm to 40 mm step 5 mm' 'yield = mu_min >= 45 deg' 'output = max(Ts)'
best 'max swing' -b open
crank=$(awk 'BEGIN {pi = atan2(0, -1); printf "%.9f", 0.08 - sqrt(0.066 ^ 2 + 0.056 ^ 2 - 2 * 0.066 * 0.056 * cos(pi / 4))}')
check "the crank at the limit: $crank" awk -v x="$crank" '/^\[/ {on = $0 == "[crank]"} on && /^length/ {d = $3 - 1000 * x; ok = d * d < 1e-12 && $4 == "mm"} END {exit !ok}' best.deck
gives mu_min open 45 1e-4
gives swing open "$value" 1e-3
# better than each design of the grid that is allowed
run 0 -f csv -b open -s sweep.output=swing t.deck
check 'better than the grid' awk -F, -v best="$value" 'NR > 1 {sub(/\r/, ""); if ($5 >= 45 && $4 > best + 1e-3) bad = 1; n++} END {exit bad || n != 8}' out

# a smooth minimum between designs, of two quantities: each partial derivative is 0 there
sweep 'coupler.length = 60 mm to 75 mm step 5 mm' 'rocker.length = 50 mm to 70 mm step 10 mm' 'output = mu_min'
best 'max mu_min'
at_best=$value
b=$(awk '/^\[/ {on = $0 == "[coupler]"} on && /^length/ {print $3 / 1000}' best.deck)
c=$(awk '/^\[/ {on = $0 == "[rocker]"} on && /^length/ {print $3 / 1000}' best.deck)
for change in "coupler.length=$(awk "BEGIN {print $b * 1.0005}") m" "coupler.length=$(awk "BEGIN {print $b * 0.9995}") m" \
    "rocker.length=$(awk "BEGIN {print $c * 1.0005}") m" "rocker.length=$(awk "BEGIN {print $c * 0.9995}") m"; do
    case $change in # an end of the box may be the best
    coupler.length=0.07[5-9]* | coupler.length=0.059* | rocker.length=0.04* | rocker.length=0.07*) continue ;;
    esac
    run 0 -S -f csv -b open -s "$change" best.deck
    check "nothing is better nearby: $change" awk -F, -v best="$at_best" '$1 == "mu_min" {ok = $2 <= best + 1e-3} END {exit !ok}' out
done

# a quantity that does not matter keeps its value of the grid, also if nothing is better than the grid
sweep 'crank.length = 16 mm to 24 mm step 2 mm' 'motion.speed = 10 rad/s to 50 rad/s in 5' 'output = mu_min'
best 'max mu_min'
check 'the end of a range' awk '/^\[/ {on = $0 == "[crank]"} on && $0 == "length = 16 mm" {ok = 1} END {exit !ok}' best.deck
check 'a speed of the grid' grep -qx 'speed = 10 rad/s' best.deck
best 'max swing' -s 'sweep.yield=mu_min > 55 deg'
check 'beside a refined value' grep -qx 'speed = 10 rad/s' best.deck

# of both branches, the better: of a list, against its table
for output in 'max(Ts)' 'max(omega4)' 'min(omega4)' 'max(theta4)' 'min(alpha4)'; do
    sweep 'crank.length & rocker.length = 20 mm & 56 mm, 18 mm & 58 mm, 22 mm & 53 mm' "output = $output"
    run 0 -f csv t.deck
    tr -d '\r' <out >designs
    for way in max min; do
        best "$way $output"
        check "$way $output: $value" awk -F, -v way=$way -v x="$value" -v name="$output" '
            NR == 1 {for (i = 1; i <= NF; i++) if (index($i, name " (") == 1) at = i}
            NR > 1 && (NR == 2 || (way == "max" ? $at > y : $at < y)) {y = $at + 0}
            END {d = x - y; exit !(at && NR == 7 && d * d <= 1e-10 * y * y)}' designs
    done
done

# min, a list that is not refined, quantities in step, other parts of the deck
sweep 'motion.speed = 10 rad/s, 20 rad/s' 'crank.length & coupler.length = 18 mm & 60 mm, 20 mm & 66 mm' 'output = mu_min'
best 'min max(omega4)' -b open
check 'what was asked for' grep -q '^# The best design of t.deck: min max(omega4) = ' best.deck
check 'of a list' grep -q '^speed = 10 rad/s$' best.deck
check 'in step, crank' awk '/^\[/ {on = $0 == "[crank]"} on && $0 == "length = 18 mm" {ok = 1} END {exit !ok}' best.deck
check 'in step, coupler' awk '/^\[/ {on = $0 == "[coupler]"} on && $0 == "length = 60 mm" {ok = 1} END {exit !ok}' best.deck
check 'the branch of the option' awk '/^\[/ {on = $0 == "[table]"} on && $0 == "branch = open" {ok = 1} END {exit !ok}' best.deck
check 'all else stays' test "$(sed 's/^\(length\|speed\|branch\) = .*//' best.deck | sed '1d;/^$/d')" = \
    "$(sed 's/^\(length\|speed\) = .*//' single.deck | sed '/^$/d')"
run 0 -f csv -S best.deck
gives 'max(omega4)' open "$value" 1e-4

# parts of vectors; comments, several lines, sections and keys that the deck does not have
cat >t.deck <<'DECK'
title = Parts   # of vectors
mechanism = four-bar
[Ground]
length = 80 mm
[sweep]
load.force.angle = 0 deg to 180 deg step 30 deg
point P.at.x = 10 mm to 30 mm step 10 mm
coupler.cg.y = 0 mm, 5 mm
motion.speed = 10 rad/s, 20 rad/s # and what follows
gravity.acceleration = 0 m/s2, 9.81 m/s2

[crank]
length = 20 mm   ; short
[coupler]
length = 66 mm
mass = 0.3 kg
[rocker]
length = 56 mm
[load]
link = rocker
force = 5 N at 30 deg
at = 30 mm
torque = 0 deg 0 N m, # a curve
  90 deg 0.1 N m,
  180 deg 0 N m
[point P]
link = coupler
at = (20, 10) mm
DECK
best 'max max(Ts)' -b open
gives 'max(Ts)' open "$value" 1e-5
for line in '# The best design of t.deck: max max(Ts) = '"$value"' N.m, open branch.' 'title = Parts   # of vectors' \
    'length = 20 mm   ; short' '  90 deg 0.1 N m,' '[motion]' '[gravity]' 'torque = 0 deg 0 N m, # a curve'; do
    check "the line '$line'" grep -qxF -e "$line" best.deck
done
check 'a vector' grep -Eq '^force = \(-?[0-9.e-]+, -?[0-9.e-]+\) N$' best.deck
check 'a point' grep -Eq '^at = \([123][0-9.]*, 10\) mm$' best.deck
check 'a centre of mass' grep -Eq '^cg = \(0, (0|5)\) mm$' best.deck

# which values stand at the end of their range
"$fourlink" -b open -s 'sweep.crank.length=15 mm to 25 mm in 4' -s 'sweep.rocker.length=52 mm to 60 mm in 4' --best='max swing' "$alvi" >ends.deck
check "both at an end: $(head -n 3 ends.deck)" test "$(grep -c '^# \(crank.length = 25\|rocker.length = 52\) mm is at the end of its range\.$' ends.deck)" -eq 2
"$fourlink" -b open -s 'sweep.crank.length=16 mm to 28 mm step 4 mm' -s 'sweep.yield=mu_min > 50 deg' --best='max swing' "$alvi" >within.deck
check 'none at an end' none 'at the end of its range' within.deck
best 'max max(Ts)' -b open -s 'load.torque=0.2 N m'
check 'a curve of several lines is replaced' none '90 deg' best.deck
gives 'max(Ts)' open "$value" 1e-5
best 'max max(Ts)' -s 'load.torque=0.2 N m' -s 'load.torque=0.3 N m' -o best.out 2>/dev/null || :
check 'the last change counts' test "$(grep -c '^torque = 0.3 N m' best.out)" -eq 1
printf '\357\273\277title = T\r\nmechanism = four-bar\r\n[ground]\r\nlength = 80 mm\r\n[crank]\r\nlength = 20 mm\r\n[coupler]\r\nlength = 66 mm\r\n[rocker]\r\nlength = 56 mm\r\n[motion]\r\nspeed = 1 rad/s\r\n[sweep]\r\ncrank.length = 10 mm, 20 mm' >t.deck
best 'max swing'
gives swing crossed "$value" 1e-3
# blanks that do not break
nb=$(printf '\302\240')
sweep 'load W.torque = 1 N m, 2 N m' "crank.length${nb}&${nb}coupler.length = 18${nb}mm${nb}& 60 mm, 20 mm & 66${nb}mm"
sed -i "s/^\[load W\]/[load${nb}W]/; s/^torque = .*/&${nb}# a comment/" t.deck
best 'max max(Ts)' -b open
gives 'max(Ts)' open "$value" 1e-5
check 'the section is found' none '^\[load W\]' best.deck
check 'the comment is found' grep -qx "torque = [12] N m${nb}# a comment" best.deck

# the search stays between the ends of the grid: the longer the crank, the larger the swing
sweep 'crank.length = 10 mm to 20 mm step 5 mm' 'output = swing'
best 'max swing' -b open
crank=$(awk '/^\[/ {on = $0 == "[crank]"} on && /^length/ {print $3 / 1000}' best.deck)
check "the longest crank of the sweep, not $crank" awk -v x="$crank" 'BEGIN {d = x - 0.02; exit !(d * d < 1e-20)}'

# the limit of a yield folds the simplex flat at 73.8 deg; one that starts again from there goes on
sweep 'crank.length = 15 mm to 30 mm step 5 mm' 'coupler.length = 50 mm to 90 mm step 10 mm' \
    'rocker.length = 40 mm to 80 mm step 10 mm' 'yield = mu_min >= 45 deg' 'output = swing'
best 'max swing' -b open
check "beyond the first simplex: $value" awk -v x="$value" 'BEGIN {exit !(x > 81.5)}'

# a # in quotes begins no comment
sweep 'crank.length = 18 mm, 20 mm'
printf '0,0.1\n90,0.2\n360,0.1\n' >'a #1.csv'
sed -i 's/^torque = .*/torque = file "a #1.csv" N m # as measured/' t.deck
best 'max swing' -b open -s 'load W.torque=0.3 N m'
check "a value in place of a quoted name: $(grep '^torque' best.deck)" grep -qx 'torque = 0.3 N m # as measured' best.deck

# what is refused
sweep 'crank.length = 18 mm, 20 mm'
for which in swing 'largest swing' 'max' 'max swing, mu_min' 'max swing mu_min' ''; do
    usage "--best must be 'max NAME' or 'min NAME'" --best="$which" t.deck
done
run 2 --best='max swng' t.deck
nothing
says "--best: error: 'swng' is neither a fact nor the max(), min(), mean() or rms() of a column of this deck; did you mean 'swing'?"
run 2 --best='max Ts' t.deck
says "'Ts' has a value in each row"
run 2 --best='max swing' single.deck
says '--best: error: [sweep] varies nothing'
for other in --summary --check --part=1/2 --format=paper --plot=p.svg; do
    usage 'it prints the best design, as a deck or a line' --best='max swing' $other t.deck
done

# as a line: the design and the value that the deck has
run 0 --best='max swing' t.deck
cp out best.deck
run 0 -f csv -b open -c 'crank.length, swing' best.deck
sed 1d out >of_deck
run 0 -f csv --best='max swing' t.deck
sed 1d out >of_line
check 'the line has the values of the deck' cmp of_line of_deck

# of several decks a line each, as of each alone; a deck without a design too
{ base && printf '[sweep]\nrocker.length = 50 mm to 60 mm step 5 mm\n'; } >other.deck
run 2 -f csv --best='max swing' t.deck single.deck other.deck
cp out all
says '--best: error: [sweep] varies nothing'
says 'note: rocker.length is at the end of its range (other.deck)'
check 'a line each' test "$(cut -d, -f1,2 all | tr '\n' ' ')" = 'deck,branch t.deck,open single.deck, other.deck,open '
fields() { tr ',' '\n' | sed '/^$/d' | sort; }
for deck in t other; do
    run 0 -f csv --best='max swing' $deck.deck
    sed 1d out | fields >alone
    sed -n "s/^$deck.deck,//p" all | fields >beside
    same alone beside
done
for format in json jsonl; do
    run 2 -f $format --best='max swing' t.deck single.deck other.deck
    lines out 4
done
run 2 --best='max swing' t.deck single.deck other.deck
lines out 5
run 1 -f csv --best='max swing' -s 'sweep.yield=mu_min > 89 deg' t.deck
holds 'a line that says why' '/^,,,no design has a value of swing and meets the yield$/ {n++} END {exit n != 1}'
run 1 --best='max type' t.deck
nothing
says '--best: error: type is in words: it has no largest or smallest value'
run 1 --best='max swing' -s 'sweep.yield=mu_min > 89 deg' t.deck
says 'no design has a value of swing and meets the yield'
run 1 --best='max stroke' t.deck
says 'no design has a value of stroke'

# a value that is not known may be the best
{ base | sed '/^\[motion\]/,$d' && printf '[motor]\ntorque = 1 N m\n[motion]\nmode = free\ninterval = 360 deg\nturns = 2\n'; } >turns.deck
{ cat turns.deck && printf '[sweep]\nmotion.turns = 2, 5, 100000\noutput = max(omega2)\n'; } >t.deck
run 1 '--best=max max(omega2)' t.deck
says '--best: error: max(omega2) of some designs is not known: the motion takes too many steps'
check 'the best of the others' grep -qx 'turns = 5' out
prints '# Designs of which it is not known are left out: the motion takes too many steps'
run 1 '--solve=motion.turns = -1e9 .. 1e5 where max(omega2) = 600 rad/s' -b open turns.deck
says 'in a part of the range max(omega2) is not known: the motion takes too many steps'

finish
