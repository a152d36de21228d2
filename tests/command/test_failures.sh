#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_failures.sh FOURLINK DATA - exit status and messages: bad decks, missing files, rows that cannot be
# computed, output that cannot be written.
. "$(dirname "$0")/../harness.sh"

cp "$decks/reach.deck" "$decks/bad.deck" .
cp "$decks/pump.deck" engine.deck

run 2 bad.deck
nothing
says 'bad.deck:5: error: the length must be positive, not -20 mm'
says "bad.deck:7: error: unknown key 'lenght' in [coupler]; did you mean 'length'?"
says "bad.deck:9: error: '56 kg' is a mass; expected a length"
lines err 3
cut -d: -f2 err >numbers
sort -n numbers >sorted
same numbers sorted
run 2 -c nonsense bad.deck # all mistakes in one run, those of the options as well
says 'bad.deck:5: error:'
says "fourlink: --columns: error: unknown column 'nonsense'"
for format in table csv paper; do
    run 2 -f $format bad.deck
    nothing
done
run 2 -l bad.deck
nothing
run 2 -m "$alvi"
nothing
says '--matrix'
run 2 -f paper engine.deck
nothing
says '--format=paper'

run 3 missing.deck
nothing
says 'missing.deck'
says 'No such file'
run 3 "$work"
nothing
says 'Is a directory'
: >empty.deck
run 2 empty.deck
nothing
says 'empty.deck:1: error:'
printf 'mechanism = four-bar\000\n' >null.deck
run 2 null.deck
nothing
says 'null.deck:1: error: control character (0x00)'

# a row that cannot be computed
run 1 reach.deck
quiet
prints '# 120 to 240 deg: not reached: B and D are too far apart'
run 1 -f csv reach.deck
run 1 -f paper reach.deck
prints '# 200 deg, open: cannot be assembled'
run 0 -s 'motion.from=-40 deg' -s 'motion.to=40 deg' reach.deck
run 1 -s 'motion.at=180 deg' reach.deck
run 1 -s 'motion.acceleration=-1 rad/s2' "$alvi" -s 'motion.speed=1 rad/s'
prints '# the crank comes to rest at'

# what is refused prints nothing, in no format and with no content; of several decks the others are printed
cp "$alvi" good.deck
printf '[sweep]\ncrank.length = -1 mm, 300 mm\noutput = mu_min\n' | cat good.deck - >none.deck
for format in table csv json paper; do
    for option in --check --expect --list --matrix --summary --best='max mu_min' --part=1/2 --plot=x.svg \
        --plot=-; do
        for deck in bad.deck empty.deck none.deck; do
            run 2 -f $format "$option" $deck
            nothing
        done
    done
    run 2 -f $format bad.deck empty.deck
    nothing
    run 2 -f $format bad.deck good.deck
    check "$format: the other deck" grep -q good.deck out
    check "$format: nothing of the refused one" none 'bad.deck\|empty.deck' out
    for option in --plot=x.svg --plot=-; do
        run 2 -f $format $option --plot-kind=klein good.deck
        nothing
        says '--plot-kind: error: '
        run 2 -f $format $option --plot-at='9 m' good.deck
        nothing
        says '--plot-at: error: '
        check 'no file' test ! -e x.svg
    done
    run 2 -f $format -o x.txt --plot=x.svg --plot-kind=klein good.deck
    check 'neither file' test ! -e x.svg -a ! -e x.txt
done

# writing fails
if [ -c /dev/full ]; then
    for arguments in "$alvi" "-i 0.1 $alvi" "-f csv $alvi" --help --version "-l $alvi" "-m $matrix"; do
        "$fourlink" $arguments >/dev/full 2>err
        check "/dev/full: fourlink $arguments" test $? -eq 3
        says 'No space left on device'
    done
fi
"$fourlink" "$alvi" 2>err >&-
check 'standard output closed' test $? -eq 3
says 'standard output'

finish
