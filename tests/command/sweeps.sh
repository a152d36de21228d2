# SPDX-License-Identifier: GPL-3.0-or-later
#
# sweeps.sh - what the tests of [sweep] share besides harness.sh: a deck, single.deck, and its sweeps, t.deck.
. "$(dirname "$0")/../harness.sh"

base() {
    cat <<'DECK'
title = A crank-rocker
mechanism = four-bar
solver = matrix
[ground]
length = 80 mm
[crank]
length = 20 mm
mass = 0.1 kg
cg = 10 mm
[coupler]
length = 66 mm
mass = 0.3 kg
cg = 0 mm
[rocker]
length = 56 mm
mass = 0.2 kg
cg = 0 mm
[load W]
link = rocker
torque = -2 N m
[point P]
link = coupler
at = (30, 10) mm
[motion]
speed = 10.5 rad/s
interval = 45 deg
[table]
columns = theta2, theta4, omega4, mu, Ts, P.x
DECK
}
base >single.deck

# sweep LINE...: t.deck is the deck with these lines of [sweep]
sweep() {
    { base && echo '[sweep]' && printf '%s\n' "$@"; } >t.deck
}

document=$(cd "$(dirname "$decks")/../doc" && pwd)/sweeps.md

# recipe HEADING FILE: the first block of code below that heading
recipe() {
    awk -v heading="### $1" '$0 == heading {on = 1; next} on && /^```/ {if (inside++) exit; next}
        on && inside' "$document" >"$2"
    check "doc/sweeps.md has a recipe '$1'" test -s "$2"
}
