#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_characters.sh FOURLINK DATA - what is not printable reaches no terminal and no picture; a name forges no
# message; csv has no formulas.
. "$(dirname "$0")/../harness.sh"
escape=$(printf '\033')
newline='
'

# is_plain FILE: it has no control characters but a return at the end of a line, none of C1, and what XML has
ends=$(printf '[\001-\014\016-\037\177]$')
c1=$(printf '\302[\200-\237]')
not_xml=$(printf '\357\277[\276\277]')
is_plain() { ! LC_ALL=C grep -q -e '[[:cntrl:]].' -e "$ends" -e "$c1" -e "$not_xml" "$1"; }

is_utf8() { iconv -f UTF-8 -t UTF-8 "$1" >/dev/null 2>&1; }

# printable FILE: UTF-8 without control characters but the ends of lines
printable() {
    check "$1 is not UTF-8" is_utf8 "$1"
    check "$1 has control characters, also of C1, or what XML has not" is_plain "$1"
}

# deck BYTES: a deck that has them in its title, in the names of a load and a point
deck() {
    printf 'title = T%bT\nmechanism = four-bar\n' "$1"
    sed '/^title/d; /^mechanism/d; /^\[expect/,$d' "$alvi"
    printf '[load L%b]\nlink = coupler\nforce = (1, 2) N\nat = (1, 2) mm\n[point P%b]\nlink = coupler\nat = (1, 2) mm\n' "$1" "$1"
}

for bytes in '\0233' '\0302\0233' '\0302\0205' '\0374' '\0377\0376' '\0300\0257' '\0355\0240\0200' '\0364\0220\0200\0200' \
    '\0342\0202' '\0357\0277\0277' '\0357\0277\0276' '\0302'; do
    deck "$bytes" >x.deck
    : >outputs
    for arguments in --list '--wide -c all' --summary '-fcsv -c all' '-fcsv --summary' --expect --matrix; do
        [ "$arguments" = --list ] || arguments="-b open -i 90 $arguments"
        run 0 $arguments x.deck
        cat out >>outputs
    done
    printable outputs
    for format in json; do
        run 0 -b open -f $format x.deck
        check "$format: C1" sh -c '! LC_ALL=C grep -q "$(printf "\302[\200-\237]")" out'
    done
    run 0 -b open --plot-kind=mechanism --plot=x.svg x.deck
    check 'the title of the picture' grep -q '<title>T.*T</title>' x.svg
    printable x.svg
    printf '[crank\n' >>x.deck
    printf 'x%b = 1\n' "$bytes" >>x.deck
    run 2 x.deck
    printable err
done
deck '\0303\0274\0316\0270\0342\0200\0246\0360\0237\0230\0200' >x.deck # what is printable stays
run 0 x.deck
check 'the title stays' grep -q "^# T$(printf '\303\274\316\270\342\200\246\360\237\230\200')T" out

# names of files
for name in "a${newline}b.deck:1: error: forged" "a${escape}[2Jb" "$(printf 'a\302\233b')" "$(printf 'a\374b')" "a$(printf '\r')b" "a${tab}b"; do
    { cat "$alvi"; printf '[expect]\nK = 0.0008\n'; } >"$name.deck"
    run 1 --check "$name.deck"
    printable out
    run 1 -f csv --check "$name.deck" "$name.deck"
    tr -d '\r\n' <out >flat
    printable flat
    run 0 -S "$name.deck" "$alvi"
    printable out
    printf 'x\n' >"$name.deck"
    run 2 "$name.deck"
    printable err
    check "a message of another line: $(cat err)" sh -c '! LC_ALL=C grep -v "^a?.*b.*: error: " err'
    run 3 "$name.missing"
    printable err
    lines err 1
    run 2 "$name.deck" --plot-kind="$name"
    printable err
    run 2 "--$name"
    printable err
    lines err 2
    run 3 -o "nowhere/$name" "$alvi"
    printable err
    lines err 1
    rm -f "$name.deck"
done

# csv: texts that a spreadsheet would compute; numbers are none
for name in '=1+1' '+1+1' '-1+cmd|x!A1' '@SUM(A1)' '=HYPERLINK("x")' '-x'; do
    cp "$alvi" "./$name.deck"
    run 0 -f csv --summary -- "$name.deck" "$alvi"
    check "no apostrophe before $name" sh -c 'grep -q "^\"*'"'"'[-=+@]" out && ! grep -q "^\"*[-=+@]" out'
    rm -f "./$name.deck"
done
cp "$alvi" "x=1.deck"
run 0 -f csv --summary x=1.deck "$alvi"
prints 'x=1.deck,'
cp "$alvi" numbers.deck
printf '[expect]\nat = 60 deg\nomega3 = -3.456 rad/s\nomega4 = -inf\ntheta3 = -1.5e-3\ntheta4 = +4 deg\nalpha4 = -1,5\n' >>numbers.deck
"$fourlink" -f csv --check numbers.deck >out 2>err
for number in '-3.456 rad/s' -inf -1.5e-3 '+4 deg' '"-1,5"'; do
    prints ",$number,"
done
finish
