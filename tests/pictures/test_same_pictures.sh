#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_same_pictures.sh FOURLINK DATA - pictures of all kinds, and reports, are drawn as they were: their checksums are those
# of same_pictures.txt.  Whether they are right is tested elsewhere; most faults in what is only seen, such as a hatch, a
# label's side or the end of a leader, are noticed here alone.  Forces are in closed form, so that they are the same on every
# machine.  Besides the decks of the manuals there are those of `varied`: slanted, clockwise, crossed, in other units, with springs
# and points on all links, without reach, at rest; drawn.py proves their pictures (drawn_all).  Without the report's scripts and style.  After a change that is wanted, look at the pictures; with SET in the
# environment the file is written anew.
. "$(dirname "$0")/../harness.sh"
LC_ALL=C.UTF-8 # a terminal's picture has its cells by the locale
export LC_ALL
expected=$pictures/same_pictures.txt
found=$work/found
kinds=$("$fourlink" --help | awk '/--plot-kind=KIND/ {on = 1; next} /^ +--/ {on = 0} on {print $1}')

# sum FILE: without the version
sum() { sed 's/fourlink [0-9][0-9.]*//g' "$1" | cksum | cut -d ' ' -f 1; }

# picture NAME ARGUMENT...
picture() {
    name=$1
    shift
    rm -f "$work/$name"
    "$fourlink" --set solver=dyad --plot="$work/$name" "$@" >/dev/null 2>&1 </dev/null
    [ ! -s "$work/$name" ] || sum "$work/$name"
}

# report DECK
report() {
    "$fourlink" --set solver=dyad --report="$work/x.html" "$1" >/dev/null 2>&1 </dev/null
    awk '/<(script|style)>/ {off = 1} !off; /<\/(script|style)>/ {off = 0}' "$work/x.html" >"$work/y.html"
    sum "$work/y.html"
}

# all DECK: its pictures
all() {
    line=$1
    for kind in $kinds; do
        line="$line $kind $(picture x.svg --plot-kind="$kind" "$1")"
    done
}

# more DECK: other positions and branches, in a terminal, over another column
more() {
    for kind in mechanism vectors limits klein; do
        for at in '10 deg' '70 deg' '-100 deg, 95 deg, 200 deg'; do
            line="$line $(picture x.svg --plot-kind="$kind" --plot-at="$at" -b both "$1")"
        done
    done
    line="$line $(picture x.txt "$1") $(picture x.txt --plot-kind=columns --columns=Ts,omega4,v --ascii "$1")"
    line="$line $(picture x.svg --plot-kind=columns --columns=F12,F23,F34,F14,Ts --plot-x=theta3 --plot-at='40 deg' "$1")"
    line="$line $(picture x.svg --plot-kind=columns --columns=mu,F12 "$1")"
}

for folder in "$data" "$decks" "$pictures/varied"; do
    cd "$folder" || exit 1
    n=0
    for deck in *.deck; do
        n=$((n + 1))
        # of the longer list every sixth
        [ "$folder" != "$data" ] || [ $((n % 6)) -eq 0 ] || continue
        ! grep -Eq '^ *mode *=' "$deck" || continue
        all "$deck"
        [ "$folder" = "$data" ] || line="$line report $(report "$deck")"
        [ "$folder" != "$pictures/varied" ] || more "$deck"
        echo "$line"
    done
done >"$found"
# the values of a sweep
{ cat "$pictures/varied/started-linkage.deck" && printf '[sweep]\ncrank.length = 22 mm to 40 mm in 7\ncoupler.length = 60 mm, 72 mm\noutput = swing, mu_min\n'; } >"$work/sweep.deck"
{
    line=sweep.deck
    cd "$work" && line="$line $(picture x.svg sweep.deck) $(picture x.svg --plot-kind=columns sweep.deck) $(picture x.txt sweep.deck)"
    echo "$line"
} >>"$found"
cd "$work" || exit 1
[ -z "${SET-}" ] || cp "$found" "$expected"
while read -r deck sums; do
    check "$deck" grep -qxF "$deck $sums" "$found"
done <"$expected"
check 'all decks' test "$(wc -l <"$found")" -eq "$(wc -l <"$expected")"
finish
