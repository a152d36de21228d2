#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_list.sh FOURLINK DATA - --list: the columns and facts of a deck.
. "$(dirname "$0")/../harness.sh"

cp "$decks/pump.deck" engine.deck

run 0 --list "$alvi"
quiet
for name in theta2 time omega2 alpha2 theta3 omega3 alpha3 theta4 omega4 alpha4 mu; do
    check "--list: $name" grep -q "^$name " out
done
check '--list: no forces without masses' none '^F12x ' out
check '--list: unit' grep -Eq '^omega4 +rad/s ' out
for name in thet phi velc; do
    check "--list: the source's $name" grep -qw "$name" out
done
mv out list
run 0 -l "$alvi"
same out list
run 0 -l "$matrix"
for name in F12x F14y Ts F34_dir power residual; do
    check "--list: $name" grep -q "^$name " out
done
run 0 -l engine.deck
for name in x v a phi N M14; do
    check "--list: $name" grep -q "^$name " out
done
check '--list: a slider-crank has no rocker' none '^theta4 ' out
run 0 -l "$alvi" -s 'units.angle=rad'
check '--list: unit of the deck' grep -Eq '^theta3 +rad ' out
# each name of the list is one that --columns takes
run 0 -c "$(sed '1d;/^$/,$d' out | cut -d' ' -f1 | paste -sd,)" "$alvi"

# without a deck: every column and fact that a deck of data/ or of the tests has, but those of its own points and elements
run 0 --list
quiet
grep -v '^$' out | cut -d' ' -f1 >all
check 'each name once' test "$(sort all | uniq -d | tr -d '\n')" = ''
for deck in "$data"/*.deck "$decks"/*.deck; do
    "$fourlink" --list "$deck" 2>/dev/null
done | grep -v '^$' | cut -d' ' -f1 | sort -u | grep -vE '^[a-z]{2,}[.]|^[D-FH-Z][.]' >some
check 'names of many decks' test "$(wc -l <some)" -gt 200
check "not listed without a deck: $(grep -vxFf all some | tr '\n' ' ')" none -vxFf all some
run 0 --list -f json
check 'as json' grep -q '"steady_rate"' out
"$fourlink" --list <"$alvi" >out
same out list
run 0 --list --units=mm
check 'in other units' grep -q '^B.x *mm ' out
run 2 --list --units=furlong
says "'furlong' is not a unit of results"

# The facts stand in --list, behind the columns.
run 0 --list "$alvi"
for fact in type K theta2_from mu_min theta4_max swing time_ratio; do
    holds "$fact in the list" "/^fact/ {on = 1} on && \$1 == \"$fact\" {n++} END {exit n != 1}"
done

finish
