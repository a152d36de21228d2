#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_inverted_decks.sh FOURLINK DATA - decks of inverted slider-cranks: columns, facts, the nine equations,
# gas on rod and cylinder, both solvers, a sweep.
. "$(dirname "$0")/../harness.sh"

cp "$data/oscillating-cylinder.deck" cylinder.deck
cp "$data/khurmi-5.2.deck" lever.deck
cp "$data/whitworth-150-100.deck" whitworth.deck

run 0 --list cylinder.deck
quiet
for column in theta4 slide slide_v slide_a coriolis N34 M34 F14x F34_dir Fsx I24x Ts_static gas_force; do
    check "column $column" grep -q "^$column " out
done
check 'no column of a piston' sh -c '! grep -Eq "^(x|N|M14|phi|piston_effort|klein_OM) " out'

run 0 --matrix -s motion.at=90 cylinder.deck
prints 'M34          N34'
check 'the couple, and the force' grep -Eq ' 3\.05219825 ' out

run 0 lever.deck
prints '# inverted slider-crank: crank and slotted lever'
run 0 --summary lever.deck
prints '# inverted slider-crank'
prints 'crank and slotted lever'
check 'swing' grep -Eq '^swing +60 deg' out
check 'nothing of linkages whose joints are pins' sh -c '! grep -Eq "^(K|theta4_from|theta4_swing) " out'
run 0 --summary whitworth.deck
check 'time ratio of the tool' grep -Eq '^time_ratio +2\.735' out
check 'no swing' sh -c '! grep -q "^swing" out'

run 0 -b both -f csv -c gas_force -s motion.at=90 -s gas.bore=40mm cylinder.deck
check 'pressure times area' awk -F, '$2 > 942.4777 && $2 < 942.4779 {n++} END {exit n != 2}' out
check 'no gas_force without gas' sh -c '"$0" --list "$1" | grep -c ^gas_force | grep -qx 0' "$fourlink" lever.deck

# gas: with the pressures of both sides equal only the rod's area is left; the torque is that of loads
run 0 -b open -c Ts,F14x,residual -s motion.at=90 -s 'crank.mass=0 kg' cylinder.deck
run 0 -b open -c Ts -s motion.at=90 -s gas.back_pressure=7.5bar cylinder.deck
cp out both
run 0 -b open -c Ts -s motion.at=90 -s gas.pressure=0bar cylinder.deck
check 'equal pressures on equal areas are none' cmp -s out both
run 0 -b open -c Ts -s motion.at=90 -s 'gas.piston_rod=10 mm' -s gas.back_pressure=7.5bar cylinder.deck
check 'a rod leaves its area' sh -c '! cmp -s out both'
cat >loads.deck <<'END'
[load rod]
link = slider
force = (900, 0) N
frame = link
[load cylinder]
link = lever
force = (-900, 0) N
at = (0, 0) mm
frame = link
END
sed '/^\[gas\]/,/^pressure/d' cylinder.deck >loaded.deck
cat loads.deck >>loaded.deck
run 0 -b both -c theta2,F12x,F23y,N34,M34,F14x,Ts cylinder.deck
sed '/^#/d' out >by_gas
run 0 -b both -c theta2,F12x,F23y,N34,M34,F14x,Ts loaded.deck
sed '/^#/d' out >by_loads
check 'gas is the two forces' [ "$(head -c 400 by_gas)" = "$(head -c 400 by_loads)" ]

run 0 -b both -c theta2,N34,M34,Ts cylinder.deck
sed '/^#/d' out >by_matrix
run 0 -b both -c theta2,N34,M34,Ts -s solver=dyad cylinder.deck
sed '/^#/d' out >by_dyad
check 'both solvers print the same' cmp -s by_matrix by_dyad

# friction of the guide: F34 has it, N34 not (by hand: 112.5 N, and 0.2 of it along the slide)
cat >rubbed.deck <<'END'
mechanism = inverted-slider-crank
[ground]
length = 0.24 m
[crank]
length = 0.12 m
[slider]
[lever]
[load F]
link = lever
at = (0.45, 0) m
force = (-150, 0) N
[friction]
guide = 0.2
[motion]
speed = 10 rad/s
at = 90 deg
END
run 0 -b open -f csv -c F34x,F34y,F34,F34_dir,F34_along,F34_across,N34,F14x,F14y rubbed.deck
check 'the lever is in balance' awk -F, 'function near(x, y) {return x - y < 1e-9 && y - x < 1e-9}
    NR == 2 {exit !(near($2 + $9, 150) && near($3 + $10, 0) && near($8, -112.5) && near($7, $8) && near($6, 22.5) &&
            near($4 ^ 2, 112.5 ^ 2 + 22.5 ^ 2) && near($4 * cos($5 / 57.29577951308232), $2) && near($4 * sin($5 / 57.29577951308232), $3))}' out
run 0 -b open -f csv -c F34x,F34y,F34,F34_dir,F34_along,F34_across,N34,F14x,F14y -s friction.guide=0 rubbed.deck
check 'without friction F34 is N34' awk -F, 'function near(x, y) {return x - y < 1e-9 && y - x < 1e-9}
    NR == 2 {exit !(near($4, 112.5) && near($7, $8) && near($6, 0))}' out

cat lever.deck - >sweep.deck <<'END'
[sweep]
lever.offset = 0 mm to 20 mm step 10 mm
output = swing, time_ratio, max(coriolis)
END
run 0 -b open --format=csv sweep.deck
check 'a line for each offset' [ "$(wc -l <out)" -ge 4 ]
run 2 -c N lever.deck
prints_error() { check "message '$1'" grep -qF -e "$1" err; }
prints_error "belongs to the slider-crank"

run 2 -b open --plot-kind=klein --plot=klein.svg lever.deck

finish
