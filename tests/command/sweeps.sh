# SPDX-License-Identifier: GPL-3.0-or-later
#
# sweeps.sh - what the tests of [sweep] share besides harness.sh: a deck, single.deck, and its sweeps, t.deck.
. "$(dirname "$0")/../harness.sh"

base() { cat "$decks/crank-rocker.deck"; }
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
