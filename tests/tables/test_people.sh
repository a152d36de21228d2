#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_people.sh FOURLINK DATA [all] - tables and summaries in the units of the deck, csv in SI, by people.py; with "all" of
# all decks and of 100 random ones, or as many as RANDOM_DECKS says; there rubbing speeds too, by rubbing.py.
. "$(dirname "$0")/../harness.sh"
needs python3 python3
tests=$(dirname "$decks")
chosen="$alvi $data/dfa-example-1.deck $data/sarkar-12.1.deck $data/whitworth-150-100.deck $decks/gas-engine.deck $decks/rubbing-lever.deck"

if [ "${3-}" ]; then
    mkdir random
    python3 -B "$tests/random_decks.py" "${RANDOM_DECKS-100}" random
    chosen="$data/*.deck $decks/*.deck random/*.deck"
fi
python3 -B "$tests/tables/people.py" "$fourlink" $chosen >out 2>&1
check "$(head -n 3 out)" test $? -eq 0
tail -n 1 out
if [ "${3-}" ]; then # rubbing speeds, also of integrated motions
    mkdir motors
    python3 -B "$tests/random_decks.py" "${RANDOM_DECKS-30}" motors motors
    python3 -B "$tests/tables/rubbing.py" "$fourlink" random/*.deck motors/*.deck "$decks"/rubbing*.deck >out 2>&1
    check "$(head -n 3 out)" test $? -eq 0
    tail -n 1 out
fi

# what [units] gives counts, and speeds go with its lengths; --units=SI leaves nothing of the deck's
{
    cat "$alvi"
    printf '[units]\nangle = rad\n[point P]\nlink = crank\nat = 10 mm\n'
} >some.deck
run 0 -b open -c theta2,P.x,P.vx some.deck
check 'an angle as given, a length as written, a speed in SI' grep -Eq '^# +rad +mm +m/s$' out
run 0 -b open -c theta2,P.x,P.vx -s units.length=cm some.deck
check 'a speed by the length' grep -Eq '^# +rad +cm +cm/s$' out
run 0 -b open -c theta2,P.x,P.vx -s units.length=cm -s units.speed=ft/s some.deck
check 'a speed as given' grep -Eq '^# +rad +cm +ft/s$' out
run 0 -b open -c theta2,P.x,P.vx --units=SI -s units.length=cm some.deck
check 'SI' grep -Eq '^# +deg +m +m/s$' out
run 0 -b open -c theta2,P.x,P.vx --units=SI,kN,mm some.deck
check 'SI but for a length' grep -Eq '^# +deg +mm +mm/s$' out
run 0 -b open -c theta2,P.x,P.vx -s 'crank.length=1 in' some.deck
check 'customary' grep -Eq '^# +rad +in +in/s$' out
run 0 -b open -c theta2,P.x,P.vx -s 'crank.length=0.02' some.deck
check 'a bare length' grep -Eq '^# +rad +m +m/s$' out

# what a bare number means does not follow from the unit that is shown
cp "$decks/gas-engine.deck" engine.deck
run 0 -b open -c theta2,x engine.deck
check 'in the unit of the crank' grep -Eq '^# +deg +(mm|in|cm)$' out
run 0 -b open -c theta2,x --at='theta2 = 1 rad' engine.deck
run 0 -f csv -b open -c x --at='60 deg' engine.deck
x=$(sed -n 's/^open,\([^,]*\),.*/\1/p' out)
run 0 -b open -c theta2,x --at="x = $x" engine.deck
check "a bare length of --at is in m: $x" grep -Eq '^ +60(\.0*)? ' out
run 0 --expect -b open -c x --at='60 deg' engine.deck
mkdir given
cp out given/ann.expect
run 0 --check --answers=given engine.deck
finish
