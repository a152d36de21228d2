#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_same_pictures.sh FOURLINK DATA - pictures of all kinds, and reports, are drawn as they were: their checksums are those
# of same_pictures.txt.  Whether they are right is tested elsewhere; most faults in what is only seen, such as a hatch, a
# label's side or the end of a leader, are noticed here alone.  Forces are in closed form, so that they are the same on every
# machine.  Without the report's scripts and style.  After a change that is wanted, look at the pictures; with SET in the
# environment the file is written anew.
. "$(dirname "$0")/../harness.sh"
expected=$pictures/same_pictures.txt
found=$work/found
kinds=$("$fourlink" --help | awk '/--plot-kind=KIND/ {on = 1; next} /^ +--/ {on = 0} on {print $1}')

# sum FILE: without the version
sum() { sed 's/fourlink [0-9][0-9.]*//g' "$1" | cksum | cut -d ' ' -f 1; }

# picture KIND DECK
picture() {
    rm -f "$work/x.svg"
    "$fourlink" --set solver=dyad --plot="$work/x.svg" --plot-kind="$1" "$2" >/dev/null 2>&1 </dev/null
    [ ! -s "$work/x.svg" ] || sum "$work/x.svg"
}

# report DECK
report() {
    "$fourlink" --set solver=dyad --report="$work/x.html" "$1" >/dev/null 2>&1 </dev/null
    awk '/<(script|style)>/ {off = 1} !off; /<\/(script|style)>/ {off = 0}' "$work/x.html" >"$work/y.html"
    sum "$work/y.html"
}

for folder in "$data" "$decks"; do
    cd "$folder" || exit 1
    n=0
    for deck in *.deck; do
        n=$((n + 1))
        # of the longer list every third
        [ "$folder" = "$decks" ] || [ $((n % 3)) -eq 0 ] || continue
        ! grep -Eq '^ *mode *=' "$deck" || continue
        line=$deck
        for kind in $kinds; do
            line="$line $kind $(picture "$kind" "$deck")"
        done
        [ "$folder" = "$data" ] || line="$line report $(report "$deck")"
        echo "$line"
    done
done >"$found"
cd "$work" || exit 1
[ -z "${SET-}" ] || cp "$found" "$expected"
while read -r deck sums; do
    check "$deck" grep -qxF "$deck $sums" "$found"
done <"$expected"
check 'all decks' test "$(wc -l <"$found")" -eq "$(wc -l <"$expected")"
finish
