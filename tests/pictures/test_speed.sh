#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_speed.sh FOURLINK DATA - pictures of machines with a motor: the speed with its mean, torques over the speed,
# energy; the other kinds at the actual speed.
. "$(dirname "$0")/pictures.sh"
pump=$data/../doc/motor-pump.deck
steady='--set=motion.mode=steady --set=motion.turns=1 --branch=open'

# fact NAME: of the steady motion
fact() { "$fourlink" -S -f csv -c theta2,omega2,energy $steady "$pump" | tr -d '\r' | awk -F, -v name="$1" '$1 == name {print $2}'; }
points() { curve_of "$1" s.list | sed '/./!d'; } # points NAME: of a curve
mean() { points mean_line | awk 'NR == 1 {print $2}'; }

listed 0 s.list --plot-kind=speed $steady "$pump"
quiet
near 'the mean' "$(mean)" "$(fact mean_speed)" 1e-4
points omega2_open >speed
check 'a curve of the speed' test "$(wc -l <speed)" -eq 721
near 'its largest value' "$(awk '{print $2}' speed | sort -g | tail -n 1)" "$(fact 'max(omega2)')" 1e-4
points T_motor_open >motor
check 'the torque of the motor is on its line' awk '
    {e = $2 - 120 * (1 - $1 / 14); if (e < 0) e = -e; if (e > 0.02) bad++} END {exit bad || NR < 2}' motor
points Ts_open >crank
check 'that on the crank makes a loop' awk '
    {d = $2 - 120 * (1 - $1 / 14); if (d > 5) above++; if (d < -5) below++} END {exit !(above && below)}' crank
points energy_open >energy
near 'the largest energy' "$(awk '{print $2}' energy | sort -g | tail -n 1)" "$(fact 'max(energy)')" 1e-4

# Without a motor the torque on the crank is rounding, and drawn as 0.
sed '/^\[motor/,/^$/d; /^\[flywheel/,/^$/d; s/^mode .*/mode = free\nspeed = 30 rad\/s/; s/^turns .*/turns = 0.5/' "$pump" >free.deck
run 0 -f csv -c Ts --branch=open free.deck
check 'its table has the rounding' awk -F, 'NR > 1 && $2 != 0 {n++} END {exit !n}' out
for kind in speed forces; do
    listed 0 s.list --plot-kind=$kind --branch=open free.deck
    points Ts_open >crank
    check "$kind: a torque of 0" awk '$2 ^ 2 > 1e-9 {bad++} END {exit bad || NR < 2}' crank
done
listed 0 s.list --plot-kind=mechanism --branch=open free.deck
check 'mechanism: no torque' none 'Tₛ' s.list

run 2 --plot=p.svg --plot-kind=speed "$alvi"
says 'this picture needs [motion] mode = free, run-up or steady; the motion is given'
listed 1 s.list --plot-kind=speed --branch=open --set='motor.stall_torque=60 N m' "$pump"
says 'stalls'
listed 2 s.list --plot-kind=speed --branch=open --set='motor.stall_torque=20 N m' $steady "$pump"
says 'no steady motion'
sed '/^turns/d; /^interval/d; s/^mode .*/mode = run-up\nrows = time\ntime_step = 0.1 s\nduration = 1 s/' "$pump" >time.deck

# Rows by time: curves over time, of which those at the times of the rows are the rows; positions by time.
"$fourlink" -f csv -c time,theta2,omega2,F12,v --branch=open time.deck | tr -d '\r' | tail -n +2 >rows
curve() { # NAME COLUMN BLOCK: a curve has the values of this column at the times of the rows, to a thousandth of its largest
    points "$3" >curve
    check "the curve of $1 over time" awk -F '[, ]' -v column="$2" '
        FNR == NR {t[FNR] = $2; y[FNR] = $column; if (y[FNR] ^ 2 > most) most = y[FNR] ^ 2; n = FNR; next}
        {for (i = 1; i <= n; i++) if (($1 - t[i]) ^ 2 < 1e-6 && !seen[i]++ && ($2 - y[i]) ^ 2 > 4e-6 * most) bad++}
        END {for (i = 1; i <= n; i++) if (!seen[i]) bad++; exit bad || n != 11}' rows curve
}
check 'eleven rows' test "$(wc -l <rows)" -eq 11
listed 0 s.list --plot-kind=motion --branch=open time.deck
curve v 6 v_open
check 'no extremes, which belong to angles' test "$(grep -c '^mark black' s.list)" -eq 0
listed 0 s.list --plot-kind=forces --branch=open time.deck
curve F12 5 F12_open
listed 0 s.list --plot-kind=speed --branch=open time.deck
curve omega2 4 omega2_open
listed 0 s.list --plot-kind=columns --columns=theta2 --branch=open time.deck
curve theta2 3 theta2_open
listed 0 s.list --plot-kind=animation --branch=open time.deck
check 'a frame for each sixtieth of the time' test "$(grep -c '^range' s.list)" -eq 60
listed 0 s.list --plot-kind=mechanism --plot-at='40 deg' --branch=open time.deck
listed 2 s.list --plot-kind=mechanism --plot-at='4000 deg' --branch=open time.deck
says 'theta2 = 4000 deg: the crank does not pass it'
listed 2 s.list --plot-kind=polar time.deck
says 'this picture needs [motion] rows = angle; the deck has rows by time'

# The turning moment is that of the mean speed.
listed 0 s.list --plot-kind=turning-moment $steady "$pump"
quiet
near 'its mean' "$(mean)" "-$(fact mean_torque | tr -d -)" 1e-4
listed 2 s.list --plot-kind=turning-moment --branch=open "$pump"
says 'the turning moment needs'

# --- a run-up of several turns: the load is averaged over each, the mean comes later, bearings show the last turn
cat >runup.deck <<'DECK'
mechanism = slider-crank
[crank]
length = 40 mm
mass = 1 kg
cg = 0
inertia = 0.002 kg m2
[rod]
length = 150 mm
mass = 0.8 kg
uniform = yes
[piston]
mass = 0.7 kg
[load gas]
link = piston
force = -300 N
from = 180 deg
to = 360 deg
[motor]
stall_torque = 25 N m
no_load_speed = 1500 rpm
[flywheel]
inertia = 0.05 kg m2
[motion]
mode = run-up
turns = 6
interval = 2 deg
[table]
branch = open
DECK
listed 0 s.list --plot-kind=speed runup.deck
quiet
check 'the mean is a later one' grep -q '^name .*later mean = ' s.list
check 'its curve has another name' grep -q '^key [^ ]* later mean$' s.list
sed -n 's/^mark black 2.5 //p' s.list >turns
"$fourlink" -f csv -c theta2,Ts,omega2 runup.deck | tr -d '\r' >rows
averaged() { # the points are the means of the table over whole turns, to 1 % of the largest torque of 25 N m
    awk -F '[, ]' 'NR == FNR {x[++n] = $1; y[n] = $2; next} FNR > 1 && $1 == "open" {
            if (m++) {T += ($3 + t) / 2; w += ($4 + o) / 2; if ((m - 1) % 180 == 0) {
                k++; dT = T / 180 - y[k]; dw = w / 180 - x[k]; if (dT * dT > 0.0625 || dw * dw > 1) bad = 1; T = w = 0}}
            t = $3; o = $4} END {exit bad || n != 6 || k != 6}' turns rows
}
check 'the load of each turn' averaged
awk '{print $1, $2 + 0.5}' turns >more && mv more turns
check 'another load is seen' not averaged
listed 0 s.list --plot-kind=polar runup.deck
check 'bearings of the last turn' grep -q '^subtitle .*, the last turn' s.list
set -- $("$fourlink" -f csv -c theta2,F12_along,F12_across runup.deck | tr -d '\r' | awk -F, '$2 == 1800 {print $3, $4}')
near 'the first force of the last turn' "$(points F12_open | awk 'NR == 1 {print $1}')" "$1" 1e-4
dots=$(grep -c '^mark black 2.5' s.list) panels=$(grep -c '^drawn' s.list)
check "dots of one turn: $dots in $panels panels" test $dots -eq $((13 * panels))
# a machine that stalls: its curves end there, near rest
listed 1 s.list --plot-kind=speed --set='motor.stall_torque=3 N m' runup.deck
stall=$("$fourlink" -c omega2 --set='motor.stall_torque=3 N m' runup.deck | sed -n 's/^# stalls at \([0-9.]*\) deg.*/\1/p')
check "curves over what it turns: $(grep -c "^range 0 $stall" s.list)" test "$(grep -c "^range 0 ${stall%.*}" s.list)" -ge 2
points omega2_open >speed
check 'the last speed is near 0' awk '{if ($2 > most) most = $2; last = $2; x = $1} END {exit !(last < 0.02 * most && most > 10)}' speed

finish
