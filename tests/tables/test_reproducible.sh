#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_reproducible.sh FOURLINK DATA - the same bytes on every run, in every locale and folder.
. "$(dirname "$0")/../harness.sh"

cp "$decks/pump.deck" engine.deck

# repeated ARGUMENT...: the output, in the file first, is the same in a second run and in another locale.
repeated() {
    "$fourlink" "$@" >first
    "$fourlink" "$@" >second
    check "something is printed: fourlink $*" test -s first
    same first second
    env LC_ALL=de_DE.UTF-8 "$fourlink" "$@" >second
    same first second
}

for arguments in "-f csv -c all $matrix" "$matrix" "-m $matrix" "-f paper $alvi" "-c all engine.deck"; do
    repeated $arguments
    env LC_ALL=fr_FR.UTF-8 LANG=tr_TR.UTF-8 LC_NUMERIC=de_DE.UTF-8 "$fourlink" $arguments >second
    same first second
    (cd / && exec env -i "$fourlink" $(echo "$arguments" | sed "s|engine.deck|$work/engine.deck|")) >second
    same first second
done
env LC_ALL=de_DE.UTF-8 "$fourlink" -i '2.5 deg' "$alvi" >second
"$fourlink" -i '2.5 deg' "$alvi" >first
same first second

cp "$decks/gas-engine.deck" engine.deck
cp "$decks/expectations.deck" good.deck

for arguments in "-S engine.deck" "-S -f csv engine.deck" "-C good.deck" "-C -f csv good.deck"; do
    repeated $arguments
done

finish
