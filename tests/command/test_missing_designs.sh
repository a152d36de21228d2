#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_missing_designs.sh FOURLINK DATA - designs that cannot be built, values that a design
# does not have.
. "$(dirname "$0")/sweeps.sh"

# the first that can be built may come late
sweep 'crank.length = 100 m to 0.02 m in 5000' 'output = mu_min'
run 1 -f csv t.deck
check 'the last design' grep -q '^5000,0.02,open,58[.0-9]*,ok' out

# a file that the deck names is read once: what becomes of it does not matter
{ printf 'mechanism = slider-crank\n[crank]\nlength = 5 cm\n[rod]\nlength = 20 cm\n[piston]\nmass = 1 kg\n'
    printf '[gas]\nbore = 10 cm\nindicator = file card.txt\n[motion]\nspeed = 10 rad/s\n'
    printf '[sweep]\ncrank.length = 2 cm to 9 cm in 4000\noutput = max(gas_force)\n'; } >card.deck
printf '0 1e5\n180 3e5\n' >card.txt
"$fourlink" -f csv card.deck 2>err | { # its output is longer than a pipe holds
    dd bs=1 count=1 2>/dev/null
    rm card.txt
    cat
} >rows.csv
check 'the file was read once' test "$(grep -c ',ok' rows.csv)" -eq 4000

reason='the crank, 300 mm, is longer than the other three together, 202 mm: the linkage cannot be assembled'
for lengths in '20 mm, 300 mm, 22 mm' '300 mm, 20 mm, 22 mm'; do
    sweep "crank.length = $lengths" 'output = swing, type'
    run 1 -f csv t.deck
    quiet
    prints "$reason"
    check 'the others have their values' test "$(grep -c 'crank-rocker,ok' out)" -eq 4
    check 'as many cells in each line' awk -F, '{gsub(/"[^"]*"/, "x"); if (NR > 1 && NF != n) bad = 1; n = NF} END {exit bad + 0}' out
    run 1 t.deck
    check 'a comment of the table' grep -q "^# $reason" out
    holds 'the others have their values' '!/^#/ && NF == 5 && $3 * $3 == 1 && $5 == 1 {n++} END {exit n != 4}'
    prints '# branch: 1 open; -1 crossed'
    prints '# type: 1 crank-rocker; 2 rocker-crank; 3 double crank (drag link)'
    holds 'a legend for each type of a four-bar alone' '
        /^#/ {legend = legend $0} END {exit !(legend ~ /9 change point/ && legend !~ /10 slider|Whitworth/)}'
    check 'lines without a gap' none '^$' out
    sweep "crank.length = $lengths"
    run 1 -f csv t.deck
    prints "$reason"
    lines out $((1 + 2 + 2 * 2 * 9))
    run 1 t.deck
    check 'a comment of the table' grep -q "^# $reason" out
done
for n in 1 2 3; do # and in parts
    "$fourlink" --part=$n/3 -f csv t.deck 2>>err
done >together
"$fourlink" -f csv t.deck >whole 2>err
same together whole

# an output that a design does not have
sweep 'crank.length = 20 mm, 100 mm' 'output = swing, mu_max'
run 1 -f csv t.deck
quiet
check 'an empty cell' grep -q "^2,0.1[0-9]*,open,,[0-9].*,assembled only from [-0-9.]* to [-0-9.]* deg\$" out
run 1 t.deck
check 'nan in the table' grep -Eq '^ +2 +100 +1 +nan +[0-9]' out
check 'no legend of what is not there' none '^# type:' out

# columns that only some designs have: as many cells in each line of csv
base | sed '/^mass/d;/^\[load/,/^torque/d;/^\[table/,$d' >t.deck
printf '[sweep]\ncrank.mass = 0 kg, 1 kg\n' >>t.deck
run 0 -f csv t.deck
check 'as many cells in each row' awk -F, 'NR > 1 && NF != n {bad = 1} {n = NF} END {exit bad + 0}' out

# a column that one design has not: its reason on both branches, the others as they are
base | sed '/^\[table/,$d' >t.deck
printf '[table]\ncolumns = theta2, Ts\n[sweep]\ncoupler.mass = 0.3 kg, 0 kg, 0.1 kg\n' >>t.deck
sed -i '/^\[load/,/^torque/d;/^mass/d;/^gyration/d' t.deck
run 1 -f csv t.deck
quiet
check 'a reason for each branch' test "$(grep -c '^2,0,.*needs masses' out)" -eq 2
check 'the third design' grep -q '^3,0\.1.*,ok' out

# beyond all bounds: infinite; no position at all: a reason
sweep 'rocker.length = 10 mm, 56 mm' 'output = max(omega4), min(omega4)'
run 1 -f csv t.deck
check 'infinite, both ways' grep -q "^1,0.01[0-9]*,open,inf,-inf,assembled only from [-0-9.]* to [-0-9.]* deg" out
check 'finite' grep -Eq '^2,0.056[0-9]*,open,[0-9.]+,-[0-9.]+,ok' out

finish
