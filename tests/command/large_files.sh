#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# large_files.sh FOURLINK DATA [EVERY] - files of 8 MB, the most that is taken apart, and of 64 MB, of any contents, as decks,
# answers and cards: each is read or refused within 2 s of processor time, with status 0, 1 or 2.  Prints the time of
# each; takes many minutes, and a busy machine needs longer.  With EVERY it takes every so many of the contents.
. "$(dirname "$0")/../harness.sh"
eight=7990000
every=${3:-1}
seen=0
worst=0
kinds=0

# timed WHAT ARGUMENT...: the program ends in time
timed() {
    what=$1
    shift
    # shellcheck disable=SC2016
    sh -c '"$@" >out 2>err </dev/null; echo $?; times' sh "$fourlink" "$@" >times
    time=$(awk 'NR == 3 {for (i = 1; i <= 2; i++) {split($i, t, "[ms]"); s += 60 * t[1] + t[2]}; print s}' times)
    status=$(head -n 1 times)
    printf '  %s s, status %s: %s\n' "$time" "$status" "$what"
    check "$what: status $status" test "$status" -le 2
    check "$what: $time s" awk "BEGIN {exit !($time <= 2)}"
    worst=$(awk "BEGIN {print ($time > $worst ? $time : $worst)}")
}

# body FORMAT: 8 MB of this, numbered by %d, in the file body; fails if this one is left out
body() {
    seen=$((seen + 1))
    [ $((seen % every)) -eq 0 ] || return
    awk -v size=$eight -v format="$1" 'BEGIN {
        for (i = 1; n < size; i++) {piece = sprintf(format, i); n += length(piece); if (n < size) printf "%s", piece}}' >body
    kinds=$((kinds + 1))
}

# deck FORMAT WHAT [CHECK]: the file body after a deck and the text FORMAT, once and eight times
deck() {
    # shellcheck disable=SC2059
    { cat "$alvi"; printf "$1"; cat body; } >x.deck
    timed "8 MB of $2" x.deck
    [ $# -lt 3 ] || timed "8 MB of $2, --check" --check x.deck
    cat body body body body body body body >>x.deck
    timed "64 MB of $2" x.deck
}

for line in '\n' '#\n' 'x\n' 'x%d\n' '=\n' 'a=b\n' 'x%d = 5\n' 'title = a\n' '[x]\n' '[x%d]\n' '[\n' '[crank]\n' '\r\n' \
    '[load F%d]\n' '[point P%d]\n' '[spring S%d]\n' '[expect]\nmu = 1\n' '"\n' '\342\210\222\n' '\377\n'; do
    body "$line" && deck '' "lines $line"
done
for line in 'x%d = 5\n' 'max(x%d) = 1\n' 'theta4x%d = 5 m/s\n' 'crank.x%d = 1 mm\n'; do
    body "$line" || continue
    for section in '[expect]' '[misprint]' '[sweep]' '[units]' '[crank]' '[table]'; do
        deck "$section\n" "$section, lines $line" check
    done
done
for item in 'x%d, ' '%d mm, ' '%d deg 5 N, ' '(' '1*' '\302\240' '"' '0'; do
    body "$item" || continue
    for start in '' '[table]\ncolumns = ' '[sweep]\ncrank.length = ' '[expect]\nmu = ' '[load F]\nforce = '; do
        deck "$start" "$start$item"
    done
done
for byte in '\000' '\001' '\033' '\377' '\t' '\r' '[' '=' ','; do
    seen=$((seen + 1))
    [ $((seen % every)) -eq 0 ] || continue
    head -c $eight /dev/zero | tr '\000' "$byte" >body
    deck '' "bytes $byte"
    timed "8 MB of bytes $byte as answers" --check=body "$alvi"
done

printf 'mechanism = slider-crank\n[crank]\nlength = 5 cm\n[rod]\nlength = 20 cm\n[gas]\nbore = 10 cm\n' >engine.deck
printf 'indicator = file card.txt deg bar\n[motion]\nspeed = 10 rad/s\ninterval = 90 deg\n' >>engine.deck
for line in '\n' '# x\n' '1 1\n' '%d 1\n' '%d,1\n' '%d;1\n' '%d\t1\n' '%d 1\r' '1\n' 'x\n' 'x%d y\n' '1 1 1 1 1 1\n' '"%d" 1\n' '%d 1 ' \
    '1e%d 1\n' '%d' '\302\240' '-' '%d 1e999\n' '\377' ' '; do
    body "$line" || continue
    mv body card.txt
    timed "8 MB of a card of $line" engine.deck
    cat card.txt card.txt card.txt card.txt card.txt card.txt card.txt card.txt >body
    mv body card.txt
    timed "64 MB of a card of $line" engine.deck
done
echo "$kinds kinds of contents; the longest time: $worst s"
finish
