#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_result_units.sh FOURLINK DATA - --units: the units of results, whatever those of the deck are.
. "$(dirname "$0")/../harness.sh"

# in_si FILE: csv with each value in SI units, by the units of its header
in_si() {
    awk -F, 'BEGIN {
            f["m"] = f["rad"] = f["rad/s"] = f["rad/s2"] = f["m/s"] = f["m/s2"] = f["N"] = f["N.m"] = f["1"] = f["s"] = 1
            f["mm"] = 0.001; f["deg"] = atan2(0, -1) / 180; f["rpm"] = atan2(0, -1) / 30; f["kN"] = 1000; f["N.mm"] = 0.001}
        {sub(/\r/, "")}
        NR == 1 {for (i = 1; i <= NF; i++) {u = $i; sub(/.*\(/, "", u); sub(/\)/, "", u); factor[i] = f[u]}; next}
        {for (i = 2; i < NF; i++) printf "%.11e ", $i * factor[i]; print ""}' "$1"
}

for deck in "$data/me3491-matrix.deck" "$data/crank-rocker-75.deck" "$data/whitworth-150-100.deck"; do
    columns=theta2,theta3,omega3,alpha3,omega4
    run 0 -f csv -c $columns "$deck"
    in_si out >plain
    run 0 -f csv -c $columns --units='mm, rad, rpm, kN, N mm' "$deck"
    check "the units of $deck" grep -q 'theta2 (rad),theta3 (rad),omega3 (rpm),alpha3 (rad/s2),omega4 (rpm)' out
    in_si out >other
    check "the same results of $deck" sh -c 'paste plain other | awk "{for (i = 1; i <= 5; i++) {d = \$i - \$(i + 5)
        if (d * d > 1e-20 * (1e-9 + \$i * \$i)) exit 1}}"'
done

# bare numbers of the deck keep their unit; those of [expect] too
for deck in $(grep -l "^.expect" "$data"/*.deck); do
    run 0 --check "$deck"
    tail -n 1 out >plain
    run 0 --check --units='in, rad, kN, rpm, lb' "$deck"
    check "the score of $deck" sh -c "tail -n 1 out | cmp - plain"
done
cat >t.deck <<'DECK'
mechanism = four-bar
[units]
length = mm
[ground]
length = 80
[crank]
length = 20
[coupler]
length = 66
[rocker]
length = 56
[motion]
speed = 100 rpm
interval = 90 deg
DECK
run 0 --units=cm -f csv --set 'sweep.crank.length=20, 22' --set 'sweep.output=max(omega4)' t.deck
check 'what a sweep varies, in its unit' grep -q 'crank.length (cm)' out
check '20 mm are 2 cm' awk -F, 'NR == 2 {ok = $2 == 2} END {exit !ok}' out
run 0 --units=cm --print-deck t.deck
check 'the deck is not changed' cmp out t.deck

sed 's/^length = 80/length = 900/' t.deck >long.deck
run 2 --units=m long.deck
check 'a mistake has the unit of the deck' grep -qF 'the ground, 900 mm, is longer' err

run 2 --units='mm, foo' t.deck
check 'a word that is no unit' grep -qxF "fourlink: --units: error: 'foo' is not a unit of results, such as mm, kg or rpm" err
run 2 --units='1/m' t.deck
check 'a unit of no quantity' grep -qF "'1/m' is not a unit of results" err

# Without a unit of results, lengths are in that of the crank in heads, pictures and reports, and in m in tables.
cat >drawn.deck <<'END'
mechanism = slider-crank
[crank]
length = 2.5 in
[rod]
length = 203.2 mm
[motion]
speed = 100 rpm
END
run 0 -b open -c theta2,x drawn.deck
prints '# crank 2.5 in, rod 8 in'
check 'the way of the piston in inches' grep -qx '# *max *5.00000' out
check 'no offer of another unit' none -e '--units' out
run 0 --units=SI -b open -c theta2,x drawn.deck
prints '# crank 0.0635 m, rod 0.2032 m'
check 'in m' grep -qx '# *max *0.127000' out
run 0 -f csv -b open -c theta2,x drawn.deck
prints 'theta2 (deg),x (m)'
for case in '::x (in)' ':--set=units.length=cm:x (cm)' ':--units=mm:x (mm)' ':--units=m:x (m)' ':--set=crank.length=0.1:x (m)'; do
    option=${case#*:}
    option=${option%:*}
    run 0 --plot=x.svg --plot-kind=columns -c x ${option:+"$option"} drawn.deck
    check "$option: no ${case##*:}" grep -qF ">${case##*:}</text>" x.svg
done
finish
