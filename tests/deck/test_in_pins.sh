#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_in_pins.sh FOURLINK DATA - each deck of data/ by the places of its pins, as --print-deck --pins writes it, has the same rows in
# all columns.  The law "in pins" (laws.c) compares random machines.
. "$(dirname "$0")/../harness.sh"
needs python3 python3

n=0
for deck in "$data"/*.deck "$data"/synthesis/*.deck; do
    grep -q '^ *\[pins\]' "$deck" && continue # which is refused
    options=
    ! grep -q '^\[synthesis' "$deck" || options=--synthesis
    cp "$deck" "${deck%.deck}".* . 2>/dev/null
    "$fourlink" --print-deck $options "${deck##*/}" >old.deck 2>/dev/null
    run 0 --print-deck --pins $options "${deck##*/}"
    mv out new.deck
    check "no pins: $deck" grep -q '^\[pins\]' new.deck
    check "still lengths: $deck" test "$(sed -n '/^\[\(crank\|coupler\|rocker\|rod\)\]/,/^$/s/^length *=/&/p' new.deck | wc -l)" -eq 0
    "$fourlink" -f csv -c all old.deck >old.csv 2>/dev/null
    "$fourlink" -f csv -c all new.deck >new.csv 2>err
    check_file same "$deck" \
        python3 "$decks/../compare.py" --csv old.csv new.csv 1e-12 >same
    n=$((n + 1))
done
check "only $n decks" test $n -gt 40
finish
