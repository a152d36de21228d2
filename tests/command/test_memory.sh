#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_memory.sh FOURLINK DATA - a table takes the memory of one row, a sweep that of one design, and says nothing where
# nobody looks.
. "$(dirname "$0")/sweeps.sh"

sweep 'crank.length = 18 mm to 22 mm in 3000' 'output = mu_min'
run 0 -f csv t.deck
quiet

# (A sanitizer needs more address space than this.)
sweep 'crank.length = 18 mm to 22 mm in 100000' 'output = swing'
if (ulimit -v 65536 && "$fourlink" --version >out) 2>err; then
    check 'a million rows in 64 MB' sh -c 'ulimit -v 65536 && exec "$0" -b open -i 0.00036 "$1" | wc -l | grep -q "^ *10000[0-9][0-9]"' "$fourlink" "$matrix"
    check '100,000 designs in 64 MB' sh -c 'ulimit -v 65536 && exec "$0" -f csv t.deck | wc -l | grep -q "^ *200001$"' "$fourlink"
fi

# So is that of many decks, and of the answers of many: what each takes is given back.
mkdir decks class
cat "$alvi" - >asked.deck <<'END'
[expect]
swing = 0 deg
mu_min = 0 deg
END
i=0
while [ $i -lt 1500 ]; do
    i=$((i + 1))
    cp "$alvi" decks/d$i.deck
    printf '[expect]\nswing = 41 deg\nmu_min = 58 deg\n' >class/s$i.txt
done
if (ulimit -v 65536 && "$fourlink" --version >out) 2>err; then
    for format in table csv json; do
        check "1500 decks in 64 MB: $format" sh -c 'ulimit -v 65536 && exec "$0" -f '$format' -b open -i 90deg decks/*.deck >out' "$fourlink"
    done
    check '1500 answers in 64 MB' sh -c 'ulimit -v 65536; "$0" --answers=class --scores -f csv "$1" >out; test $? -eq 1' "$fourlink" asked.deck
    lines out 1501
fi
# the first decks of a csv stay open between its header and their rows, the others are read again: their rows are the same,
# and each says once what it has to say
sed '/^\[motion\]/,$d' "$alvi" >plain.deck
printf '[motion]\nspeed = 10 rad/s\nacceleration = 5 rad/s2\nat = 40 deg\n' | cat plain.deck - >noted.deck
for i in 1 2 20 30 40; do cp noted.deck decks/d$i.deck; done
"$fourlink" -f csv -b open -i 90deg decks/d1.deck >one 2>one.err
noted=$(wc -l <one.err)
check "notes of one: $noted" test "$noted" -gt 0
i=0
while [ $i -lt 40 ]; do
    i=$((i + 1))
    echo "decks/d$i.deck"
done >names
"$fourlink" -f csv -b open -i 90deg $(cat names) >out 2>err
check "notes: $(wc -l <err)" test "$(wc -l <err)" -eq $((5 * noted))
while read -r name; do
    "$fourlink" -f csv -b open -i 90deg "$name" decks/d50.deck 2>/dev/null | grep "^$name,"
done <names >expected
sed 1d out | grep '^decks/d' >rows
same rows expected

# what can be read only once is kept
cat "$alvi" | "$fourlink" -f csv - decks/d1.deck >out 2>err
"$fourlink" -f csv "$alvi" decks/d1.deck | sed "s,^$alvi,<stdin>," >expected
same out expected

finish
