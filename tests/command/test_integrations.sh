#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_integrations.sh FOURLINK DATA COUNTED - a motion is integrated once, whatever the number of answers, columns and
# pictures, and whether it succeeds: COUNTED is the command that counts (count_runs.c).
. "$(dirname "$0")/../harness.sh"
counted=$3

# runs ARGUMENT...: how often the command integrates
runs() {
    RUNS_FILE=runs "$counted" "$@" >out 2>err </dev/null
    cat runs
}

# as_often N ARGUMENT...
as_often() {
    wanted=$1
    shift
    n=$(runs "$@")
    check "$n integrations, not $wanted: fourlink $*" test "$n" -eq "$wanted"
}

pump() {
    sed '/^\[motor]/,$d; /^title/d' "$data/../doc/motor-pump.deck"
}

# a motor whose torque grows with its speed, so that no motion is steady, one that stalls in its run-up, one that runs, and rows by time
cat >unsteady.deck <<'END'
mechanism = slider-crank
[crank]
length = 59 mm
mass = 2 kg
[rod]
length = 197 mm
mass = 2.5 kg
[piston]
mass = 1.8 kg
[load P]
link = piston
force = 256 N
[motor]
curve = 0 rad/s 3.5 N m, 190 rad/s 4.2 N m, 375 rad/s 4.9 N m, 470 rad/s 0 N m
ratio = 9.5
[flywheel]
inertia = 0.07 kg m2
[motion]
mode = steady
interval = 10 deg
[table]
branch = open
END
{
    pump
    printf '[motor]\nstall_torque = 25 N m\nno_load_speed = 10 rad/s\n[motion]\nmode = run-up\nturns = 2\ninterval = 10 deg\n'
} >stalls.deck
{
    pump
    printf '[motor]\nstall_torque = 120 N m\nno_load_speed = 14 rad/s\n[motion]\nmode = steady\ninterval = 10 deg\n'
} >runs.deck
{
    pump
    printf '[motion]\nmode = free\nspeed = 5 rad/s\nrows = time\nduration = 1 s\ntime_step = 0.05 s\n'
} >time.deck

mkdir one three thirty
for i in $(seq 30); do
    printf 'at = 40 deg\nomega2 = %d rad/s\nTs = 3 N m\nmax(F12) = 80 N\nmean_speed = 9 rad/s\n' "$i" >thirty/"$i".txt
done
cp thirty/1.txt one
cp thirty/[12].txt thirty/30.txt three

for deck in unsteady stalls runs time; do
    once=$(runs "$deck.deck")
    check "$deck: $once integrations" test "$once" -gt 0
    for options in '-f csv' '-c theta2,omega2,Ts,F12,power' '-c max(Ts),min(F12),mean(omega2)' \
        '-p a.svg --plot-kind=speed -f json' '-p a.svg --report=a.html -f csv' '--answers=one' '--check=one/1.txt'; do
        # shellcheck disable=SC2086 # words
        as_often "$once" $options "$deck.deck"
    done
    { cat $deck.deck; printf '[expect]\nat = 40 deg\nomega2 = 0 rad/s\nmean_speed = 0 rad/s\n'; } >asks.deck
    as_often "$once" --answers=three --scores asks.deck
    as_often "$once" --answers=three --feedback=told/ asks.deck
done

once=$(runs unsteady.deck)
{ cat unsteady.deck; printf '[expect]\nat = 40 deg\nomega2 = 0 rad/s\n'; } >asks.deck
as_often "$once" --answers=thirty --scores asks.deck

# the reason is the same on each of thirty sheets
run 2 --answers=thirty unsteady.deck
sed -n 's/.*no value at theta2 = 40 deg, open: //p' err >reasons
check "$(wc -l <reasons) reasons" test "$(wc -l <reasons)" -eq 60
check "$(sort -u reasons)" test "$(sort -u reasons | wc -l)" -eq 1

# other decks have other motions
sed 's/^inertia = 0.07 kg m2/inertia = 7 kg m2/' unsteady.deck >heavy.deck
heavy=$(runs heavy.deck)
as_often $((once + heavy)) unsteady.deck heavy.deck

# an exercise, which is read without the answers too
printf '[grading]\ntolerance = 1 %%\n[expect]\nat = 40 deg\nomega2 = 1 rad/s\n' >>unsteady.deck
as_often "$once" --check=one/1.txt unsteady.deck
as_often "$once" --answers=thirty unsteady.deck
finish
