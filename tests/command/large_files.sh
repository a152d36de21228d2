#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# large_files.sh FOURLINK DATA - files of up to 64 MB of any contents, as decks, cards and answers: each is read or
# refused within 2 s of processor time, with status 0, 1 or 2.  Prints the time of each; takes minutes.
. "$(dirname "$0")/../harness.sh"
most=67000000 # of a file
deck=7990000  # of what the reader takes apart
worst=0

# timed SECONDS WHAT ARGUMENT...: the program ends within this time
timed() {
    seconds=$1
    what=$2
    shift 2
    sh -c '"$@" >out 2>err </dev/null; echo $?; times' sh "$fourlink" "$@" >times
    time=$(awk 'NR == 3 {for (i = 1; i <= 2; i++) {split($i, t, "[ms]"); s += 60 * t[1] + t[2]}; print s}' times)
    status=$(head -n 1 times)
    echo "  $time s, status $status: $what: $(head -n 1 err | cut -c1-100)"
    check "$what: status $status" test "$status" -le 2
    check "$what: $time s" awk "BEGIN {exit !($time <= $seconds)}"
    worst=$(awk "BEGIN {print $time > $worst ? $time : $worst}")
}

# lines SIZE FORMAT: so many bytes of lines, numbered by %d; bytes SIZE CHARACTER: in one line
lines() {
    awk -v size="$1" -v format="$2" 'BEGIN {
        for (i = 1; n < size; i++) {line = sprintf(format, i); n += length(line); if (n < size) printf "%s", line}}'
}
bytes() { head -c "$1" /dev/zero | tr '\000' "$2"; }

for size in $deck $most; do
    for line in '\n' '#\n' 'x\n' 'x%d\n' '=\n' 'a=b\n' 'x%d = 5\n' 'title = a\n' '[x]\n' '[x%d]\n' '[\n' '[crank]\n' '\r\n' ' \n' \
        '[load F%d]\n' '[point P%d]\n' '[spring S%d]\n' '[expect]\n' '[expect]\nmu = 1\n' '"\n' '\342\210\222\n' '\377\n' \
        'crank.length = %d mm\n'; do
        { cat "$alvi"; lines $size "$line"; } >x.deck
        timed 2 "$size bytes of lines $line" x.deck
        timed 2 "$size bytes of lines $line, checked" --check x.deck
    done
    for section in '[expect]' '[misprint]' '[sweep]' '[units]' '[crank]' '[load F]' '[table]' '[motion]' '[sweep]\noutputs = mu'; do
        for line in 'x%d = 5\n' 'crank.x%d = 1 mm\n' 'x%d\n' 'theta4x%d = 5 m/s\n' 'max(x%d) = 1\n' 'length = %d mm\n'; do
            { cat "$alvi"; printf "$section\n"; lines $size "$line"; } >x.deck
            timed 2 "$size bytes of $section, lines $line" x.deck
            timed 2 "$size bytes of $section, lines $line, checked" --check x.deck
        done
    done
    for start in '' '[table]\ncolumns = ' '[sweep]\ncrank.length = ' '[sweep]\noutputs = ' '[sweep]\nyield = ' \
        '[load F]\nlink = rocker\nforce = ' '[expect]\nmu = ' '[crank]\nmass = ' 'title = ' '[units]\nlength = '; do
        for item in 'x%d, ' '%d mm, ' '%d deg 5 N, ' 'mu, ' '1e%d ' '(' '1*' 'm^' '\302\240' '"' '0' 'a'; do
            { cat "$alvi"; printf "$start"; lines $size "$item"; echo; } >x.deck
            timed 2 "$size bytes of $start$item" x.deck
        done
    done
    for byte in '\000' '\001' '\033' '\177' '\200' '\377' '\t' '\r' '\n' '[' ']' '=' ','; do
        bytes $size "$byte" >x.deck
        timed 2 "$size bytes $byte" x.deck
        timed 2 "$size bytes $byte, answers" --check=x.deck "$alvi"
    done
done

printf 'mechanism = slider-crank\n[crank]\nlength = 5 cm\n[rod]\nlength = 20 cm\n[gas]\nbore = 10 cm\n' >x.deck
printf 'indicator = file card.txt deg bar\n[motion]\nspeed = 10 rad/s\ninterval = 90 deg\n' >>x.deck
for size in $deck $most; do
    for line in '\n' '# x\n' '1 1\n' '%d 1\n' '%d,1\n' '%d;1\n' '%d\t1\n' '%d 1\r' '1\n' 'x\n' 'x%d y\n' '1 1 1 1 1 1\n' '"%d" 1\n' \
        '%d 1 ' '1,' '1e%d 1\n' '%d' '\302\240' '-' '%d 1e999\n'; do
        lines $size "$line" >card.txt
        timed 2 "a card, $size bytes of $line" x.deck
    done
    for byte in '\000' '\377' '\r' ' ' '1' '"' ';'; do
        bytes $size "$byte" >card.txt
        timed 2 "a card, $size bytes $byte" x.deck
    done
done
head -c 70000000 /dev/zero >x.deck
timed 2 'a file larger than 64 MB' x.deck
lines $deck 'x%d = 1\n' >x.expect
timed 2 'answers that no deck has' --check=x.expect "$alvi"
echo "the longest time: $worst s"
finish
