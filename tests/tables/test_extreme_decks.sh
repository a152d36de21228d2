#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_extreme_decks.sh FOURLINK DATA - finite numbers from extreme values; memory for a million rows.
. "$(dirname "$0")/../harness.sh"

cp "$decks/pump.deck" engine.deck

# finite ARGUMENT...: rows of finite numbers, and nothing undefined; an extreme may be inf or -inf
finite() {
    "$fourlink" "$@" >out 2>err
    status=$?
    check "exit status $status: fourlink $*" test $status -le 2
    found=$(awk '/^# column/ {is_key = 1} # what follows are the extremes of a summary
        {line = " " tolower($0) " "}
        !is_key && !/^#|^m[axin]*\(/ && line ~ /[^a-z0-9_](inf|infinity)[^a-z0-9_]/ {inf++}
        line ~ /[^a-z0-9_](nan|infinity)[^a-z0-9_]/ {nan++}
        END {print inf + 0, nan + 0}' out)
    check "inf in a row: fourlink $*" test "${found% *}" = 0
    check "nan: fourlink $*" test "${found#* }" = 0
}
long=$(awk 'BEGIN {printf "m"; for (i = 0; i < 60; i++) printf ".km4"; for (i = 0; i < 60; i++) printf "/km4"}')
for format in table csv paper; do
    for change in 'motion.speed=0' 'motion.speed=1e29 rad/s' 'motion.acceleration=1e29 rad/s2' \
        'motion.speed=-0' 'motion.speed=1e-300' 'crank.length=1e-14 m' 'crank.mass=1e29 kg' \
        'crank.inertia=1e29 kg m2' 'gravity.acceleration=0' 'crank.length=70 mm' \
        'ground.length=20 mm' 'coupler.length=80 mm' 'crank.length=1e14 m' 'motion.at=1e29 rad' \
        'motion.from=1e15' 'table.digits=17' 'load Tl.torque=1e29 N m' "units.length=$long" \
        'units.torque=N m' 'load Tl.force=1e29 N at 20 deg'; do
        finite -f $format -s "$change" "$matrix"
    done
done
finite -s "units.length=$long" engine.deck
finite -f csv -s "units.length=$long" engine.deck
run 0 -f csv -c all engine.deck
run 0 -f csv -c all -s 'motion.speed=0' -s 'rod.mass=0' -s 'rod.inertia=0' -s 'piston.mass=0' engine.deck
check 'a machine at rest without weight' none -Eiw 'nan' out
check 'its advantage at the dead centres' test "$(grep -c inf out)" -eq 6

# an angle beyond what can be computed is a mistake, not an empty table
run 2 -s 'motion.at=1e30 rad' "$alvi"
nothing

# the facts and extremes of the summary
cp "$decks/gas-engine.deck" engine.deck
for change in 'motion.speed=0' 'motion.speed=1e29 rad/s' 'crank.length=2 m' 'ground.offset=199 mm' \
    'motion.at=40 deg' 'motion.run_up=90 deg' 'rod.length=1e14 m' 'piston.mass=1e29 kg' \
    'flywheel.fluctuation=1e-29' 'motion.cycle=0.1 deg' 'crank.length=300 mm' \
    'units.energy=MN m' 'motion.to=0' 'gas.bore=1e-14 m'; do
    finite -S -s "$change" engine.deck
done

finish
