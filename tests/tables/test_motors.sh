#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_motors.sh FOURLINK DATA - machines with a motor: their tables, the reason at the end of the rows in every
# format, lists, summaries, sweeps, answers.
. "$(dirname "$0")/../harness.sh"

pump=$data/../doc/motor-pump.deck
stall='motor.stall_torque=60 N m'

run 0 "$pump" -b open
quiet
prints '# run-up from rest; masses of all links; loads process, fan'
check 'the usual columns are those of the actual motion' \
    grep -q '^# theta2  *time  *omega2  *alpha2 .* T_motor' out
check '17 rows' test "$(grep -c '^ ' out)" -eq 17

run 0 "$pump" -s motion.mode=steady -s motion.turns=1 -b open
prints '# steady motion; '
run 0 "$pump" -s motion.mode=free -s 'motion.speed=9 rad/s' -b open
prints '# free motion from 9 rad/s; '

# Where it stalls the rows end, with one reason.
run 1 "$pump" -s "$stall" -b open -c theta2,omega2
quiet
prints '# stalls at 290.539 deg'
check 'seven rows before it' test "$(grep -c '^ ' out)" -eq 7
check 'one reason' test "$(grep -c 'stalls' out)" -eq 1
run 1 "$pump" -s "$stall" -f csv -c theta2,omega2
check 'the reason in csv, on both branches' test "$(grep -c '^[a-z]*,,,stalls at [0-9.]* deg' out)" -eq 2
check 'no row after it' test "$(grep -c '^open' out)" -eq 8
run 1 "$pump" -s "$stall" -f json -c theta2,omega2 -b open
prints '{"status":"stalls at 290.539 deg","values":null}'
run 1 "$pump" -s "$stall" --matrix -b open
check 'matrix: seven blocks and the reason' test "$(grep -c '^# theta2 = ' out)" -eq 7
prints '# stalls at 290.539 deg'
run 1 "$pump" -s "$stall" --expect -b open
run 0 "$pump" -s "$stall" -S -b open
check 'the angle as a fact' grep -q '^stall_angle  *290.539 deg' out
check 'the end of a summary' grep -q '^end  *stalls at 290.539 deg, open$' out
run 0 "$pump" -s "$stall" -S
check 'on both branches' test "$(grep -c '^end  *stalls at [0-9.]* deg, [a-z]*$' out)" -eq 2
run 0 "$pump" -s "$stall" -S -f csv -b open
prints 'end,stalls at 290.539 deg,,,open'
run 0 "$pump" -s "$stall" -S -f json -b open
prints '"value":"stalls at 290.539 deg","theta2":null,"branch":"open"}'
run 0 "$pump" -S
check 'a machine that goes on has none' none '^end ' out
run 0 "$pump" -s motion.mode=steady -s 'motor.stall_torque=20 N m' -S -b open
check 'no steady motion in a summary' grep -q '^end  *no steady motion: .*, open$' out

run 1 "$pump" -s 'motor.stall_torque=-20 N m' -s 'motor.no_load_speed=-10 rad/s' -s motion.turns=1 -b open
prints '# does not start: the torque does not turn the crank'
run 1 "$pump" -s motion.mode=steady -s 'motor.stall_torque=20 N m' -b open
prints '# no steady motion: none was found that repeats and is stable'

# Lists and summaries.
run 0 "$pump" --list
for name in T_motor J energy energy_residual mean_speed mean_speed_textbook period fluctuation_exact run_up_time; do
    check "$name is listed" grep -q "^$name  *[^ ]" out
done
run 0 "$alvi" --list
check 'not of a given motion' test "$(grep -c '^T_motor\|^mean_speed\|^energy_residual' out)" -eq 0
run 0 "$pump" -S
check 'the mean of a run-up is that of the steady motion' \
    grep -q '^mean_speed .*mean over time, of the steady motion' out
run 0 "$pump" -s motion.mode=free -s 'motion.speed=9 rad/s' -S
check 'that of a free motion is of its last cycle' grep -q '^mean_speed .*mean over time, of the last cycle' out
run 0 "$pump" -s motion.mode=free -s 'motion.speed=9 rad/s' -s motion.turns=0.5 -S
check 'half a turn has no mean speed and no period' none '^mean_speed\|^period\|^fluctuation_exact' out
run 0 "$pump" -s motion.mode=free -s 'motion.speed=9 rad/s' -s motion.turns=1 -S -b open
check 'a whole one has' test "$(grep -c '^mean_speed \|^period' out)" -eq 2
run 0 "$pump" -S -f csv
for input in motion.mode motor.stall_torque motor.no_load_speed flywheel.inertia; do
    check "$input is an input" grep -q "^$input," out
done
run 2 "$alvi" -c T_motor
says "the column 'T_motor' needs [motion] mode = free, run-up or steady; the motion is given"

# A motion ends at a dead position, at the end of the crank's range: by angle, and by time, where the last row that it
# has is near that angle.
sed 's/^length = 100 mm/length = 260 mm/; s/^length = 250 mm/length = 120 mm/; s/^speed.*/speed = -1 rad\/s\nfrom = 40 deg/' \
    "$decks/../fuzz/decks/free.deck" >dead.deck
sed '/^mode\|^rows\|^time_step\|^duration/d' dead.deck >given.deck # the same range, without an integration
limit=$("$fourlink" -S -f csv -b open given.deck 2>err | awk -F, '$1 == "theta2_from" {print $2; exit}')
run 1 -b open -c theta2 -f csv -s 'motion.time_step=0.1 ms' dead.deck
check 'a dead position by time' grep -q ',dead position' out
check "it is at the limit of the crank, $limit" awk -F, -v limit="$limit" '
    NR > 1 && $2 != "" {d = $2 - limit} END {exit !(d > -1e-9 && d < 1e-4)}' out
sed '/^rows/d; /^time_step/d; s/^duration.*/to = 30 deg\ninterval = 1 deg/' dead.deck >angle.deck
run 1 -b open -c theta2 angle.deck
check 'a dead position by angle' grep -q '^# dead position' out

# Stalls: the crank creeps into an equilibrium, by angle and by time; the torque of the motor has a corner at rest;
# friction turns round there.
sed '/^\[flywheel\]/,/^inertia/d' "$pump" >bare.deck
run 1 -b open -s 'motor.stall_torque=60 N m' bare.deck
prints '# stalls at 252.568 deg'
sed '/^turns/d; s/^interval.*/rows = time\ntime_step = 1 s\nduration = 5 s/' bare.deck >creep.deck
run 0 -b open -c theta2 -f csv -s 'motor.stall_torque=60 N m' creep.deck
check 'it stays there' awk -F, '$1 == "open" {d = $2 - 252.5680; n++} END {exit !(n == 6 && d * d < 1e-6)}' out
sed 's/^stall_torque.*/curve = 0 rad\/s 16 N m, 14 rad\/s 0 N m/; /^no_load/d; s/^inertia = 0.5.*/inertia = 1 kg m2/' "$pump" >curve.deck
run 1 -b open curve.deck
prints '# stalls at 266.917 deg'
run 1 -b open -s 'motor.stall_torque=16 N m' -s 'flywheel.inertia=1 kg m2' "$pump"
prints '# stalls at 266.917 deg'
{ sed 's/^stall_torque.*/torque = 30 N m/; /^no_load/d' bare.deck; printf '[friction]\nguide = 0.001\n'; } >rubs.deck
run 1 -b open rubs.deck
prints '# stalls at 225.609 deg'
run 1 -b open -s friction.guide=0.0001 rubs.deck # without friction 225.615 deg
prints '# stalls at 225.614 deg'

# A load that grows less than with the speed; many turns; an inertia that vanishes.
sed 's/^stall_torque.*/torque = 30 N m/; /^no_load/d; s/^exponent.*/exponent = 0.5/' "$pump" >root.deck
run 0 -b open -c theta2 root.deck
run 0 -b open -c theta2,omega2 -f csv -i 3600deg -s motion.turns=30 bare.deck
check 'the speed has settled' awk -F, '$1 == "open" && $2 > 0 {if (n++ && ($3 - last) ^ 2 > 1e-16) bad++; last = $3} END {exit bad || n != 3}' out
sed 's/^mass = .*/mass = 0 kg/; /^uniform/d; s/^speed.*/speed = 3 rad\/s\nfrom = 3 deg/' "$decks/../fuzz/decks/free.deck" |
    sed '/^\[rocker\]/a mass = 1 kg\ninertia = 0.01 kg m2' | sed '/^mass = 0 kg/d; /^rows/d; /^time_step/d; s/^duration.*/interval = 5 deg/' >light.deck
run 1 -b open -c theta2 light.deck
prints '# nothing that moves has a mass'

# A spring that each turn winds up: no motion is steady.
{ cat "$pump"; printf '[spring V]\nlink = crank\nto = ground\nstiffness = 0.01 N m/rad\n'; } >wound.deck
run 1 -b open -s motion.mode=steady wound.deck
prints '# no steady motion'
run 0 -b open -S wound.deck
check 'nor are its facts known' test "$(grep -c '^mean_speed\|^steady_rate\|^run_up_time' out)" -eq 0

# A sweep over motor and flywheel.
{
    cat "$pump"
    printf '[sweep]\nmotor.stall_torque = 60 N m, 120 N m\nflywheel.inertia = 0.1 kg m2 to 0.5 kg m2 step 0.4 kg m2\n'
    printf 'output = max(omega2), run_up_time, fluctuation_exact, stall_angle\n'
} >sweep.deck
run 1 sweep.deck -f csv -b open
check 'four designs' test "$(grep -c ',open,' out)" -eq 4
check 'each output is a number in some design' awk -F, '
    NR > 1 {for (i = 5; i <= 8; i++) n[i] += $i > 0}
    END {exit !(n[5] == 4 && n[6] > 0 && n[7] > 0 && n[8] > 0)}' out

# sweep EDIT LINES: the pump changed by sed, with a sweep, in sweep.deck.
sweep() { sed -e "$1" "$pump" >sweep.deck && printf '[sweep]\n%s\n' "$2" >>sweep.deck; }

# A design that lacks an output because its motion ends says why.
sweep 's/^mode.*/mode = steady/; s/^turns.*/turns = 1/; s/^inertia = 0.5.*/inertia = 0.1 kg m2/' \
    'motor.stall_torque = 60 N m, 120 N m
output = period, max(omega2), mean(Ts), flywheel_inertia'
run 1 sweep.deck -f csv
check 'no steady motion' test "$(grep -c '^1,60,[a-z]*,,,,,no steady motion: ' out)" -eq 2
check 'a steady motion' test "$(grep -c '^2,120,.*,ok' out)" -eq 2
run 1 sweep.deck -f json
prints '"period":null,"max(omega2)":null,"mean(Ts)":null,"flywheel_inertia":null,"status":"no steady motion: '
sweep '' 'motor.stall_torque = 60 N m, 120 N m
output = run_up_time, mean_speed'
run 1 sweep.deck -f csv -b open
check 'a run-up that stalls' grep -q '^1,60,open,,,stalls: the crank comes to rest' out
check 'a run-up that does not' grep -q '^2,120,open,[0-9.]*,[0-9.]*,ok' out
# A run-up that stalls has no facts of the steady motion that it does not reach.
sweep 's/^turns.*/turns = 2\nfrom = 150 deg/' 'motor.stall_torque = 65 N m, 70 N m
output = mean_speed, mean_speed_textbook, period, fluctuation_exact, steady_rate, run_up_time, stall_angle'
run 1 sweep.deck -f csv -b open
check 'facts of a run-up that stalls' grep -q '^1,65,open,,,,,,,286\.[0-9]*,stalls: ' out
check 'facts of one that does not' grep -q '^2,70,open,8\.06[0-9]*,[0-9.]*,[0-9.]*,[0-9.]*,[-0-9.e]*,[0-9.]*,,this design has no such fact' out
run 1 sweep.deck -b open
check 'they are nan in a table' grep -q '^  *1  *65  *1  *nan  *nan  *nan  *nan  *nan  *nan  *286' out
run 1 sweep.deck -f json -b open
prints '"mean_speed":null,"mean_speed_textbook":null,"period":null,"fluctuation_exact":null,"steady_rate":null,'
run 0 -s 'motor.stall_torque=65 N m' -s 'motion.from=150 deg' -b open -S "$pump"
check 'nor has its summary' test "$(grep -c '^mean_speed\|^period\|^fluctuation_exact\|^steady_rate\|^run_up_time' out)" -eq 0
sweep '' 'motor.stall_torque = 60 N m, 100 N m
output = stall_angle'
run 1 sweep.deck -f csv -b open
check 'its angle is a number' grep -q '^1,60,open,290.5[0-9]*,ok' out
check 'another has none' grep -q '^2,100,open,,this design has no such fact' out
sweep 's/^stall_torque.*/torque = constant/; /^no_load/d; s/^mode.*/mode = steady/; s/^turns.*/turns = 1/
       s/^inertia = 0.5.*/exact = yes/' 'motion.mean_speed = 12 rad/s, 40 rad/s
flywheel.fluctuation = 10 %, 190 %
output = flywheel_inertia'
run 0 sweep.deck -f csv -b open
check 'four flywheels' test "$(grep -c 'open,[0-9.]*,ok' out)" -eq 4

# Rows by time have no facts of a cycle.
by_time='s/^turns.*/rows = time\ntime_step = 10 ms\nduration = 0.5 s/; /^interval/d'
for fact in run_up_time mean_speed period stall_angle mean_torque; do
    sweep "$by_time" "motor.stall_torque = 60 N m, 120 N m
output = max(omega2), $fact"
    run 2 sweep.deck -f csv
    nothing
    says "sweep.deck:49: error: '$fact' needs rows by angle; [motion] has rows = time"
done
sweep "$by_time" 'motor.stall_torque = 60 N m, 120 N m
output = max(omega2), theta2_from'
run 0 sweep.deck -f csv

# Answers agree with the deck they are of.
run 0 "$pump" --expect -b open
mv out answers
run 0 "$pump" --check=answers
prints 'differs: 0'
finish
