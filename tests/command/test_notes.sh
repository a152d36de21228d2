#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_notes.sh FOURLINK DATA - notes on decks: on standard error, with their lines; they change neither the
# results nor the exit status.
. "$(dirname "$0")/../harness.sh"

# bar LINES: a crank-rocker with these lines in its coupler
bar() {
    printf 'mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\n[rocker]\nlength = 56 mm\n'
    printf '[motion]\nspeed = 10 rad/s\n[coupler]\nlength = 66 mm\n'
    printf "$1"
}
bar 'mass = 0.3 kg\n' >point.deck
bar 'mass = 0.3 kg\ncg = 0 mm\n' >meant.deck
bar 'mass = 0.3 kg\nuniform = yes\n' >slender.deck
bar 'mass = 0.3 kg\ncg = 33 mm\ninertia = 108.9 kg mm2\n' >hand.deck
bar 'mass = 0.3 kg\ncg = 50 %%\ninertia = 108.9 kg mm2\n' >percent.deck
note="point.deck:12: note: [coupler] is a point mass at B: write uniform = yes for a uniform bar, cg = 0 mm if this is meant"

for format in table csv json; do
    for deck in slender hand percent; do
        run 0 -f $format -c theta2,F12,Ts $deck.deck
        quiet
        sed "s/$deck/deck/; /\"name\":\"coupler[.]/d" out >$deck.$format # how the bar is given differs
    done
    same slender.$format hand.$format
    same percent.$format hand.$format
    run 0 -f $format -c theta2,F12,Ts meant.deck
    quiet
    sed 's/meant/deck/' out >meant
    run 0 -f $format -c theta2,F12,Ts point.deck
    sed 's/point/deck/' out >point
    check "one note: $(cat err)" test "$(cat err)" = "$note"
    same point meant
    differ point slender.$format
done

# with every content, and once for a deck
for option in --summary --list --matrix --plot=x.svg; do
    run 0 $option point.deck
    check "one note with $option: $(cat err)" test "$(cat err)" = "$note"
done
run 0 point.deck slender.deck point.deck
lines err 2
run 0 -s 'crank.mass=1 kg' slender.deck
says 'fourlink: --set: note: [crank] is a point mass at A'
{ cat point.deck; printf '[sweep]\ncrank.length = 18 mm to 22 mm in 50\noutput = max(Ts)\n'; } >sweep.deck
run 0 sweep.deck
lines err 1
# a deck with mistakes has only these
bar 'mass = 0.3 kg\ngravity = 3\n' >bad.deck
run 2 bad.deck
lines err 1
says "bad.deck:13: error: unknown key 'gravity' in [coupler]"

finish
