#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_parts.sh FOURLINK DATA - --part: the parts of a sweep against the whole; with GNU parallel and make.
. "$(dirname "$0")/sweeps.sh"

# parts N FORMAT: t.deck in so many parts, made from the last to the first, is `whole`
parts() {
    k=$1
    rm -f part.*
    while [ $k -ge 1 ]; do
        run 0 --part=$k/$1 -f "$2" -o "part.$k" t.deck
        k=$((k - 1))
    done
    k=0
    while [ $k -lt "$1" ]; do
        k=$((k + 1))
        cat "part.$k"
    done >together
    same together whole
    check "$1 parts: a header in one only" test "$(grep -c 'branch\b.*mu' together)" -eq "$(grep -c 'branch\b.*mu' whole)"
}

rows='motion.interval = 90 deg, 120 deg'
for output in "$rows" 'output = mu_min, type, max(Ts)'; do
    sweep 'crank.length = 18 mm to 22 mm step 1 mm' 'rocker.length = 56 mm +- 0.1 mm' 'samples = 2' "$output"
    for format in csv table; do
        run 0 -f $format -o whole t.deck
        for n in 1 2 3 7 30; do
            parts $n $format
        done
        run 0 -P 2/3 -f $format t.deck
        check 'a part is neither empty nor all' test -s out
        differ out whole
    done
    run 0 -f csv --part=2/3 t.deck
    check 'no header in a later part' none '^design' out
done

run 0 -f csv -o whole t.deck
if command -v parallel >/dev/null; then
    HOME=$work
    export HOME
    rm -f part*
    check 'parallel' parallel --will-cite "$fourlink" '--part={}/4' -f csv -o 'part{}.csv' t.deck ::: 1 2 3 4 </dev/null 2>err
    cat part1.csv part2.csv part3.csv part4.csv >together
    same together whole
    check 'parallel --keep-order' parallel --will-cite -k "$fourlink" '--part={}/4' -f csv t.deck ::: 1 2 3 4 </dev/null >together 2>err
    same together whole
else
    echo 'skipped: GNU parallel is not there'
fi

if command -v make >/dev/null; then
    rm -f part*
    cat >Makefile <<MAKE
parts = part1.csv part2.csv part3.csv part4.csv
all.csv: \$(parts)
${tab}cat \$(parts) >all.csv
\$(parts): part%.csv: t.deck
${tab}$fourlink --part=\$*/4 -f csv -o \$@ t.deck || test \$\$? -eq 1
MAKE
    sweep 'crank.length = 18 mm to 26 mm in 5' 'rocker.length = 56 mm, 20 mm' # some rows are out of reach
    run 1 -f csv -o whole t.deck
    check 'make -j4' make -s -j4 </dev/null
    same all.csv whole
    cp part1.csv kept
    rm part3.csv all.csv # as if it had been interrupted
    make -j4 </dev/null >made
    check 'only the part that is not there is made again' test "$(grep -c -e --part= made)" -eq 1
    same all.csv whole
else
    echo 'skipped: make is not there'
fi

finish
