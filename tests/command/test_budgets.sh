#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_budgets.sh FOURLINK DATA - actual motions that no number of steps would finish end with a reason; none runs on.
. "$(dirname "$0")/../harness.sh"

# ends SECONDS STATUS ARGUMENT...: within so much processor time, with this status
ends() {
    seconds=$1
    expected=$2
    shift 2
    (ulimit -t "$seconds" && exec "$fourlink" "$@") >out 2>err </dev/null
    status=$?
    check "exit status $status, expected $expected: fourlink $*" test $status -eq "$expected"
}

fourbar() {
    cat <<'END'
mechanism = four-bar
[ground]
length = 80 mm
[crank]
length = 20 mm
mass = 1 kg
[coupler]
length = 66 mm
mass = 0.3 kg
[rocker]
length = 56 mm
mass = 1 kg
inertia = 0.001 kg m2
END
}
free='[motion]
mode = free
speed = 1 rad/s'

# a torque that no number holds: steps lead to NaN
cat >huge.deck <<'END'
mechanism = slider-crank
[crank]
length = 50 mm
mass = 1 kg
uniform = yes
[rod]
length = 200 mm
[load]
link = crank
over = omega2
torque = 1 N m
at_speed = 1 rad/s
exponent = 30
[motion]
mode = free
speed = 50 rad/s
rows = time
time_step = 1 s
duration = 1 s
END
sed 's/^rows = time/interval = 30 deg/; /^time_step/d; /^duration/d' huge.deck >huge-angle.deck
for deck in huge.deck huge-angle.deck; do
    ends 20 1 $deck
    prints 'grows beyond all numbers'
    ends 20 0 --summary $deck
    prints 'grows beyond all numbers'
    ends 20 1 -f csv $deck
done

# too many turns, and too stiff a spring
{ fourbar && printf '[motor]\ntorque = 1 N m\n%s\nturns = 1e5\ninterval = 1e6 deg\n' "$free"; } >turns.deck
{ fourbar && printf '[spring S]\nlink = crank\nto = ground\nstiffness = 1e12 N m/rad\n[motor]\ntorque = 1 N m\n%s\n' "$free" &&
    printf 'rows = time\ntime_step = 1 ms\nduration = 100 s\n'; } >stiff.deck
for deck in turns.deck stiff.deck; do
    ends 20 1 $deck
    prints 'too many steps'
    check "no extremes of $deck, which depend on the budget" none '^# *max' out
done

# the search for a steady motion is not repeated for each part of a report without rows
{ fourbar && printf '[motor]\nstall_torque = 1 N m\nno_load_speed = 1 rad/s\n[load L]\nlink = rocker\ntorque = -50 N m\n' &&
    printf '[motion]\nmode = steady\ninterval = 30 deg\n'; } >none.deck
ends 20 1 --report=none.html none.deck
check 'a report without rows has no drawing' none -e 'class="mechanism"' none.html
check 'but the reason' grep -q 'no steady motion' none.html

# What took longest or most memory of random decks: at most 5 s of processor time and 200 MB, a report twice that.  (A
# sanitizer needs more address space.)
bounded() {
    seconds=$1
    kilobytes=$2
    shift 2
    (ulimit -t "$seconds"; ulimit -v "$kilobytes"; exec "$fourlink" "$@") >out 2>err </dev/null
    status=$?
    check "exit status $status: fourlink $*: $(tail -n 1 err)" test $status -le 1
}
if (ulimit -v 204800 && "$fourlink" --version >out) 2>err; then
    for deck in "$decks"/../command/slow/*.deck; do
        design=
        grep -q '^\[sweep\]' "$deck" && design=--design=1
        for content in '-f table' '-f csv' --summary; do
            # shellcheck disable=SC2086
            bounded 5 204800 $design $content "$deck"
        done
        # shellcheck disable=SC2086
        bounded 10 409600 $design --report=slow.html "$deck"
    done
fi
# without a [sweep] --design says so before anything is integrated
ends 1 2 --design=1 "$decks/../command/slow/friction-in-a-lever.deck"
says '--design needs a [sweep]'

finish
