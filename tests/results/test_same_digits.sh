#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_same_digits.sh FOURLINK DATA - all 17 digits of rows and of extremes, in closed form, are the same on every machine:
# their checksums are those of same_digits.txt.  Not of decks whose motion is integrated: they need powers and logarithms
# of the C library.  With SET in the environment it writes the file anew.
. "$(dirname "$0")/../harness.sh"
expected=$decks/../results/same_digits.txt

# sum ARGUMENT...: of what the command prints
sum() { "$fourlink" --set solver=dyad --format=csv "$@" 2>/dev/null </dev/null | cksum | cut -d ' ' -f 1; }

for deck in "$data"/*.deck; do
    grep -Eq '^ *(mode|exponent) *=' "$deck" && continue
    printf '%s\n' "$(basename "$deck") $(sum "$deck") $(sum --summary "$deck")"
done >found
[ -z "${SET-}" ] || cp found "$expected"
while read -r deck rows summary; do
    check "$deck" grep -qx "$deck $rows $summary" found
done <"$expected"
check 'all decks' test "$(wc -l <found)" -eq "$(wc -l <"$expected")"
finish
