#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_report.sh FOURLINK DATA - --report: its page, what it refuses, and what a failure leaves.
. "$(dirname "$0")/../harness.sh"
fourbar=$decks/coupler-point.deck
engine=$decks/engine.deck
has() { check "no '$1' in r.html" grep -qF -e "$1" r.html; }
hasnt() { check "'$1' in r.html" none -F -e "$1" r.html; }

# refused MESSAGE ARGUMENT...: before anything is done
refused() {
    usage "$@"
    check "a file was written: fourlink $*" test ! -e r.html
}
for name in r.txt html r.html.gz .html ''; do
    refused "--report needs a file name that ends in .html or .pdf, not '$name'" --report="$name" "$fourbar"
done
refused '--report does not go with several decks' --report=r.html "$fourbar" "$engine"
refused '--report needs a value' "$fourbar" --report
refused '--best does not go with --report: it prints the best design' --best='max mu_min' --report=r.html "$fourbar"
for name in a.htm A.HTML; do
    run 0 --report=$name -b open "$alvi"
    quiet
    nothing
done
# outputs and inputs with one name
cp "$fourbar" deck.html
run 3 --report=deck.html deck.html
says 'cannot write deck.html: it is also read'
same deck.html "$fourbar"
run 3 --report=r.html --output=r.html "$fourbar"
says 'cannot write r.html: two outputs have this name'
run 3 --report=r.html --output=./r.html "$fourbar"
says 'two outputs have this name'
check 'nothing was written' test ! -e r.html

# the table comes only if it is asked for
run 0 --report=r.html --format=csv "$alvi"
mv out csv
"$fourlink" -f csv "$alvi" >plain
same csv plain
has 'data-save="alvi-5.1.csv" data-from="csv-rows"'
run 0 --report=r.html --output=table "$alvi"
check 'the table' test -s table
run 0 --report=r.html --summary "$alvi"
prints 'crank.length'

# numbers have 6, 9 or 15 digits, as many as the deck asks for; a speed without bounds
for case in 6:-51.0183 7:-51.0182751 12:-51.0182751 13:-51.01827514926; do
    run 0 --report=r.html -b open --set="table.digits=${case%:*}" "$alvi"
    found=$(sed -n 's|.*<th scope="row" data-name="alpha3"><i>α</i><sub>3</sub></th><td>rad/s²</td><td[^>]*>\([^<]*\)<.*|\1|p' r.html)
    check "$case: $found" test "${found%??}" = "${case#*:}" -o "$found" = "${case#*:}"
done
run 1 --report=r.html -b open "$decks/reach.deck"
sed -i 's/<td class="number"[^>]*>/<td>/g' r.html
has '<th scope="row" data-name="omega4"><i>ω</i><sub>4</sub></th><td>rad/s</td><td>−∞</td><td></td><td>∞</td>'

# the sections; one sample, of the first row that is reached if the usual angle is not; words where there are no forces
run 1 --report=r.html -b open --set='motion.from=150 deg' --set='motion.to=350 deg' "$decks/reach.deck"
check 'the sections' test "$(sed -n 's|.*<h2>\(.*\)</h2>|\1|p' r.html | tr '\n' ',')" = \
    '1 Given data,2 Mechanism and results,3 Sample calculation,4 Curves and diagrams,5 All facts and extremes,6 Checks,7 Discussion,8 Tables,9 Deck,'
has 'At θ₂ = 270°, open branch'
has 'The deck has no masses and no loads, so there are no forces.'
run 0 --report=r.html --plot-at='50 deg' -b open "$fourbar"
has 'At θ₂ = 50°'
hasnt 'no masses and no loads'
run 2 --report=none.html --plot-at='50 mm' "$fourbar"
says '--plot-at: error:'
run 2 --report=none.html --plot-at='50,60' "$fourbar"
says '--plot-at: error: a report shows one position, not several'
run 2 --report=none.html --plot-at=150 "$data/me3491-exercise-1.deck"
says 'the motion does not reach theta2 = 150'
check 'no report of a wrong angle' test ! -e none.html

# options that change the deck are named; a change that is not UTF-8, or has a control character
run 0 --report=r.html -b open --set='motion.speed=7 rad/s' "$alvi"
has '<li>--set: <code>motion.speed=7 rad/s</code></li>'
has '<li>--branch: <code>table.branch=open</code></li>'

# titles and names do no harm
sed "s|^title.*|title = </title><script>alert('1')</script> \"q\" \&amp; <!-- ]]> \\\\ %s|" "$alvi" >"a'b\"<&>]]>.deck"
run 0 --report=r.html "a'b\"<&>]]>.deck"
check 'a script of the title' none -F -e '<script>alert' r.html
run 2 --report=r.html --set=crank.length=-1mm "$alvi"
has '<li>--set: the length must be positive, not -1mm</li>'
run 0 --report=r.html "$decks/expectations.deck"
# mistakes: the deck with its mistakes, in place of results, and not an old report
run 2 --report=r.html "$decks/mistakes.deck"
mv err messages
check 'a mistake for each message' test "$(grep -c '<li>' r.html)" -eq "$(wc -l <messages)"
has '<mark class="text-line" id="line-7">'
has 'Nothing was computed.'
hasnt 'id="sample"'
# a deck that cannot be read, or that cannot serve another option, has no report
rm r.html
run 3 --report=r.html missing.deck
run 2 --report=r.html --check "$fourbar"
check 'no report' test ! -e r.html

# notes, files that the deck names, expected values, rows that could not be computed
printf 'mechanism = four-bar\n[crank]\nlength = 50 mm\n[ground]\nlength=100 mm\n[coupler]\nlength=120 mm\nmass=1 kg\n[rocker]\nlength=90 mm\n[motion]\nspeed=60 rpm\n' >note.deck
run 0 --report=r.html note.deck
has 'Notes on the deck'
run 0 --report=r.html -b open "$data/steam-engine-240.deck"
has 'Klein'
run 0 --report=r.html "$data/me3491-example-2.deck"
has 'misprint confirmed'
run 1 --report=r.html --set='expect.n=6' "$engine"
says 'r.html: expected values differ'
check 'all rows are there' none 'rows' err
run 1 --report=r.html "$decks/reach.deck"
says 'r.html: rows could not be computed'
check 'nothing was expected' none 'expected' err
has 'cannot be assembled'
run 1 --report=r.html "$data/me3491-exercise-1.deck" --set='motion.from=150 deg' --set='motion.to=200 deg'
has 'there is none: cannot be assembled'
run 0 --report=r.html "$data/alvi-5.1.deck"
has 'no masses and no loads'

# no other program is needed, and nothing is missing
PATH=/nonexistent "$fourlink" --report=r.html "$engine" 2>err
check "exit status $?, expected 0 without other programs" test $? -eq 0
quiet
hasnt 'class="missing"'
has '<svg'

# a failure leaves the old file, and none beside it
mkdir o
echo old >o/r.html
cp o/r.html old
run 2 --report=o/r.html --format=csv --interval='0.018 deg' "$fourbar"
nothing
says ':1: error: 20001 rows; a report shows at most 20,000: give a coarser interval with --set=motion.interval'
same o/r.html old
ln -s /dev/full full.html
if [ -c /dev/full ]; then
    run 3 --report=full.html "$engine"
    says 'cannot write full.html: No space left on device'
fi
(
    trap '' XFSZ
    ulimit -f 8
    exec "$fourlink" --report=o/r.html "$engine" 2>>err
)
check 'a file that cannot grow' test $? -eq 3
same o/r.html old
# nor is there one without its csv, for which it has a temporary file: one that cannot be made, one that cannot grow
(
    ulimit -n 4
    exec "$fourlink" --report=o/r.html "$engine"
) 2>err 3>&- 4>&- 5>&- 6>&-
check 'no more files' test $? -eq 3
says 'cannot write o/r.html: its temporary file: '
same o/r.html old
mkfifo pipe.html
cat pipe.html >shown.html &
(
    trap '' XFSZ
    ulimit -f 8
    exec "$fourlink" --report=pipe.html --interval='1 deg' "$engine" 2>err
)
check 'a temporary file that cannot grow' test $? -eq 3
wait
says 'its temporary file: File too large'
run 2 --report=o/r.html --plot-at=x "$engine"
same o/r.html old
only_file o r.html
run 3 --report=nowhere/r.html "$engine"
says 'cannot write nowhere/r.html'
if [ "$(id -u)" -ne 0 ]; then
    chmod a-w o
    run 3 --report=o/new.html "$engine"
    says 'cannot write o/new.html'
    chmod u+w o
    only_file o r.html
fi

finish
