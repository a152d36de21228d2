#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_values.sh FOURLINK DATA [all] - values of decks, a line for each deck and branch: those of --summary, by values.py; with
# "all" of 300 random decks too.
. "$(dirname "$0")/../harness.sh"
needs python3 python3
tests=$(dirname "$decks")

if [ "${3-}" ]; then
    mkdir random
    python3 -B "$tests/random_decks.py" 300 random
    for deck in random/*.deck; do # those without mistakes
        "$fourlink" --summary "$deck" >/dev/null 2>&1
        [ $? -le 1 ] || rm "$deck"
    done
    python3 -B "$tests/command/values.py" "$fourlink" random/*.deck >out 2>&1
else
    python3 -B "$tests/command/values.py" "$fourlink" "$data"/*.deck >out 2>&1
fi
check "$(head -n 3 out)" test $? -eq 0
tail -n 1 out
check "$(tail -n 1 out)" grep -q ', 0 wrong$' out

# a line for each branch; a deck with another unit has another column, a deck that is not read a line too
crusher=$data/me3491-exercise-4.deck
run 0 -f csv -c 'mu_min, max(omega4), crank.length, type' "$alvi" "$crusher"
prints 'deck,branch,mu_min (deg),max(omega4) (rad/s),crank.length (m),type (1),crank.length (cm),status'
check "lines: $(wc -l <out)" test "$(wc -l <out)" -eq 4
check 'crossed' grep -q '^[^,]*alvi-5.1.deck,crossed,58.22[0-9]*,3.77[0-9]*,0.02,crank-rocker,,ok$' out
check 'in cm' grep -q '^[^,]*exercise-4.deck,open,49.45[0-9]*,27.03[0-9]*,,crank-rocker,50,ok$' out
run 3 -f csv -c mu_min "$alvi" missing.deck
check 'a deck that is missing' grep -q '^missing.deck,,,missing.deck: No such file' out
run 0 -c mu_min "$alvi"
prints '# branch           mu_min'
check 'open' grep -q '^ open  *58.2297$' out
run 0 -f json -c mu_min -b open "$alvi"
check 'json' grep -q '^{"deck":null,"branch":"open","mu_min":58.2297[0-9]*,"status":"ok"}$' out
run 0 -f csv -c mu_min -b open --set 'sweep.crank.length=17 mm to 19 mm step 1 mm' "$alvi"
check "a sweep: $(cat out)" grep -q '^design,crank.length (m),branch,mu_min (deg),status$' out

# a name with blanks is one name, with a comma or a blank before and after it; columns are as wide as their names
cat >loads.deck <<'DECK'
mechanism = four-bar
[ground]
length = 80 mm
[coupler]
length = 66 mm
[rocker]
length = 56 mm
[crank]
length = 20 mm
[load H]
link = rocker
force = 3 N at 20 deg
at = 10 mm
[load my own]
link = rocker
torque = 2 N m
DECK
for separator in ', ' ' ' ','; do
    run 0 -f csv -b open -c "mu_min${separator}load H.force.size${separator}load my own.torque${separator}crank.length" loads.deck
    prints 'branch,mu_min (deg),load H.force.size (N),load my own.torque (N.m),crank.length (m),status'
    check "values: $(cat out)" grep -q '^open,58.22[0-9]*,3,2,0.02,ok$' out
done
run 0 -b open -c 'load H.force.size, load my own.torque' loads.deck
check "as wide as their names: $(cat out)" test "$(awk '{print length($0)}' out | sort -u | wc -l)" -eq 1
run 2 -c 'load H' loads.deck
says "unknown column 'load H'"

# what a deck lacks; columns of rows beside values; a mistake of an option is told once
run 1 -f csv -c 'mu_min, stroke' "$alvi"
check "a fact that a four-bar has not: $(cat out)" grep -q '^open,58.22[0-9]*,,..*' out
run 2 -c mu_min,theta4 "$alvi" "$crusher"
says "'mu_min' is one value of the deck, 'theta4' has one in each row: ask for them apart"
check "told once: $(cat err)" test "$(wc -l <err)" -eq 1
run 2 -c thta4 "$alvi" "$crusher" "$data/whitworth-150-100.deck"
says "unknown column 'thta4'; did you mean 'theta4'?"
check "told once: $(cat err)" test "$(wc -l <err)" -eq 1
run 2 -c mu_min --at='30 deg' "$alvi"
says '--at shows rows; the columns are values of the deck'
run 2 -f paper -c mu_min "$alvi"
says 'values of the deck can be printed as table, csv or json only'

# in the deck itself
{ cat "$alvi"; printf '[table]\ncolumns = mu_min, max(omega4)\nbranch = open\n'; } >own.deck
run 0 -f csv own.deck
check "the deck's own: $(cat out)" grep -q '^branch,mu_min (deg),max(omega4) (rad/s),status$' out
run 0 --report=own.html own.deck
# designs of several decks: the lines that each sweep has by itself
for k in 1 2; do
    { cat "$alvi" && printf '[sweep]\ncrank.length = %s mm to 24 mm step %s mm\ncoupler.length = 60 mm, 66 mm\n' "1$k" "$k"; } >sweep-$k.deck
    run 0 -f csv -s 'sweep.output=mu_min, max(omega4), crank.length' sweep-$k.deck
    sed '1d; s/,[^,]*,[^,]*\(,[a-z]*,\)/\1/; s/^/sweep-'$k'.deck,/' out >>each
done
run 0 -f csv -c 'mu_min, max(omega4), crank.length' sweep-1.deck sweep-2.deck "$alvi"
check 'its header' test "$(head -n 1 out)" = 'deck,design,branch,mu_min (deg),max(omega4) (rad/s),crank.length (m),status'
sed '1d; /alvi/d' out >both
same each both
check 'a deck without designs' test "$(grep -c 'alvi-5.1.deck,,[a-z]*,58.2297' out)" -eq 2
run 0 -c 'mu_min' sweep-1.deck "$alvi"
check 'as a table' grep -Eq '^ open +3 +[0-9.]+  sweep-1.deck$' out
run 0 -f json -c mu_min -b open sweep-1.deck "$alvi"
check 'json' grep -q '^{"deck":"sweep-1.deck","design":3,"branch":"open","mu_min":[0-9.]*,"status":"ok"}$' out
run 2 -c theta4 sweep-1.deck "$alvi"
says "of several decks a [sweep] has to have values, by output or --columns='max(Ts), crank.length'"
finish
