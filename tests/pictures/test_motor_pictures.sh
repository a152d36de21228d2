#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_motor_pictures.sh FOURLINK DATA - all kinds of pictures of a machine with a motor.
. "$(dirname "$0")/pictures.sh"
pump=$data/../doc/motor-pump.deck
steady='--set=motion.mode=steady --set=motion.turns=1 --branch=open'
for kind in $kinds speed; do
    [ $kind = animation ] && continue
    run 0 --plot=$kind.svg --plot-kind=$kind $steady "$pump"
    quiet
    svg $kind.svg
done
shows speed.svg 'open: mean = 11.199 rad/s' ω₂ mean 'T motor' Tₛ 'torque (N·m)' 'ω₂ (rad/s)' 'energy (J)'
run 0 --plot=r.svg --plot-kind=columns --plot-x=time --columns=omega2,T_motor --branch=open "$pump"
shows r.svg 'time (s)' 'ω₂ (rad/s)' 'T motor (N·m)'

# a crank that comes to rest: the picture is of the way to there, wherever angles are counted from
{ sed '/^\[motion\]/,$d' "$decks/engine.deck" && printf '[motion]\nmode = free\nspeed = 3 rad/s\nturns = 1\nfrom = 300 deg\n'; } >rest.deck
for from in 300 -60; do
    "$fourlink" --plot=r$from.svg --plot-kind=animation -b open -s "motion.from=$from deg" rest.deck >out 2>err
    says 'stalls'
    grep -o 'data-axes="[^"]*"' r$from.svg >axes$from
    check 'a picture' test -s axes$from
done
same axes300 axes-60

finish
