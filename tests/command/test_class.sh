#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_class.sh FOURLINK DATA - a class: variants with names, many answers to one deck, scores, tolerances of the
# instructor.
. "$(dirname "$0")/../harness.sh"

cat >exercise.deck <<'DECK'
mechanism = four-bar
[ground]
length = 80 mm
[crank]
length = 20 mm
[coupler]
length = 66 mm
[rocker]
length = 56 mm
[motion]
speed = 30 rad/s
interval = 30 deg
DECK
# answers NAME LINE...: answers/NAME
mkdir answers
answers() {
    file=answers/$1
    shift
    { echo '[expect]' && printf '%s\n' "$@"; } >"$file"
}
answers anna.expect 'swing = 42.09 deg' 'mu_min = 58.23 deg' 'at = 40 deg' 'theta4 = 103.8 deg'
answers ben.txt 'mu_min = 58.23 deg' 'at = 40 deg' 'theta4 = 103.8 deg'
answers 'c, "d".expect' 'swing = 42 deg' 'mu_min = 59 deg' 'at = 40 deg' 'theta4 = 8e1 deg' 'tolerance = 1000 %'
answers dora.EXPECT 'swing = 42.09 deg' 'mu_mni = 58.23 deg' 'at = 40 deg' 'theta4 = 103.8 deg' 'omega4 = 0.209 rad/s'
sed 's/expect/misprint/' answers/anna.expect >answers/emil.expect
sed 's/42.09/1/' answers/emil.expect >answers/fay.expect
echo '[crank]' >answers/gerd.expect
: >answers/hans.expect
echo notes >answers/.hidden.txt
echo other >answers/read.me

# ------------------------------------------------------------------------------ scores of many answers

run 2 --answers=answers --scores --format=csv exercise.deck
# what is printed without the columns of the three questions
without_questions() { sed 's/,[^,]*,[^,]*,[^,]*$//' out >shown; }
cat >expected <<'CSV'
name,right,of,percent,note
anna,3,3,100,
ben,2,3,66.7,missing: swing
"c, ""d""",3,3,100,sets its own tolerance
dora,2,3,66.7,missing: mu_min; line 3: 'mu_mni' is neither a column nor a fact of this deck; did you mean 'mu_min'?; not asked: omega4 at 40
emil,0,3,0,a value of [misprint] is no answer
fay,0,3,0,a value of [misprint] is no answer
gerd,0,3,0,"answers/gerd.expect: line 1: expected [expect] or [misprint] in this file, not [crank]"
hans,0,3,0,answers/hans.expect:1: the file is empty
CSV
without_questions
same shown expected
says "answers: note: answers set their own tolerance, by 'tolerance' or their last digit"
says '3 are asked, those that a quarter of them have: swing, mu_min, theta4 at 40;'
check 'a mistake has its file' grep -q '^answers/gerd.expect:1: error: ' err
check 'each mistake once' test "$(grep -c gerd err)" -eq 1

run 2 --check=answers/ --scores --format=csv exercise.deck
without_questions
same shown expected
says 'answers/: note: no file has the name of the deck, so all 8 are answers to it'
run 2 --answers answers --scores exercise.deck
check 'a table' grep -Eqx 'ben +2 +3 +66\.7  missing: swing' out
run 2 --answers=answers --scores --format=json exercise.deck
prints '{"name":"ben","right":2,"of":3,"percent":66.700000000000003,"note":"missing: swing"}'
"$fourlink" --answers=answers --scores -f csv - <exercise.deck >out 2>err
check 'the deck on standard input' sh -c 'sed "s/,[^,]*,[^,]*,[^,]*\$//" out | cmp -s - expected'

# one line for each value
run 2 --answers=answers --format=csv exercise.deck
check 'the name of the file' test "$(grep -c '^answers/anna.expect,' out)" -eq 4
check 'its score' grep -q '^answers/ben.txt,,score,,,,,,,,2,3,missing: swing$' out
check 'a broken file' grep -q '^answers/gerd.expect,,bad answers,,,,,,,,0,3,"' out
run 2 --answers=answers exercise.deck
prints '# answers: answers/ben.txt'
prints '# score: 2 of 3'
prints '# note: missing: swing'
prints '# score: 0 of 3'
check 'each mistake once' test "$(grep -c gerd err)" -eq 1
check 'what differs is first' awk '/^# answers: / {ok = 0} /^ok / {ok = 1} /^(differs|no value|not a) / && ok {bad = 1}
    END {exit bad}' out

# the deck's own [expect] is what is asked
{ cat exercise.deck && printf '[expect]\nswing = 42.1 deg\nmu_max = 90 deg\n'; } >asked.deck
run 2 --answers=answers --scores --format=csv asked.deck
check 'two values' grep -q '^anna,1,2,50,"missing: mu_max; not asked: mu_min, theta4 at 40",[0-9,]*$' out
check 'nothing is guessed' none 'a quarter' err

# a file with the deck's name is the only one
cp answers/anna.expect answers/exercise.expect
run 0 --check=answers exercise.deck
check 'the score' test "$(tail -n 1 out)" = '# score: 3 of 3'
run 2 --answers=answers --scores exercise.deck
check 'but for --answers' test "$(grep -c '^exercise ' out)" -eq 1
rm answers/exercise.expect

# a form that is half filled in
mkdir forms
printf '[expect]\nswing =\nmu_min = 58.23 deg\n[expect]\nat = 40 deg\ntheta4 =\n' >forms/ina.expect
cp answers/anna.expect forms
run 1 --answers=forms --scores -f csv exercise.deck
prints 'ina,1,3,33.3,"missing: swing, theta4 at 40"'

# a value that is given twice counts if both are right
cp -r answers twice && rm twice/gerd.expect twice/hans.expect
printf '[expect]\nswing = 50 deg\n' >>twice/anna.expect
run 1 --answers=twice --scores -f csv exercise.deck
prints 'anna,2,3,66.7,'

# ------------------------------------------------------------------------------------------ tolerances

score() { sed -n "s/^$1,\([^,]*,[^,]*\),.*/\1/p" out; }
run 2 --answers=answers --scores -f csv --tolerance='1 %' exercise.deck
check 'theirs do not count' grep -q '^"c, ""d""",1,3,33.3,' out
check 'those of Anna' test "$(score anna)" = 3,3
check 'no note on tolerances' none tolerance err
run 2 --answers=answers --scores -f csv --tolerance='2 %' exercise.deck
check 'a wider one' grep -q '^"c, ""d""",2,3,' out
run 2 --answers=answers --scores -f csv --tolerance='0.001 %, 30 deg' exercise.deck
check 'of a quantity' grep -q '^"c, ""d""",3,3,100,,[0-9,]*$' out
{ cat exercise.deck && printf '[grading]\ntolerance = 1 %%\ndigits = 2\nswing = 0.5 %%, 3 marks\nmu_min = 2 %%\n'; } >graded.deck
run 2 --answers=answers --scores -f csv graded.deck
check 'marks' test "$(score anna)" = 5,5
check 'marks of what is missing' test "$(score ben)" = 2,5
check 'by name' grep -q '^"c, ""d""",4,5,80,' out
run 2 --answers=answers --scores -f csv --set 'grading.tolerance=50 %' graded.deck
check 'too few digits' grep -q '^"c, ""d""",4,5,80,' out
run 2 --answers=answers graded.deck
prints 'hint: it has fewer than 2 digits'
for wrong in '0,5 deg' x '-1 %' 5 '1 % 2 deg' ''; do
    run 2 --tolerance="$wrong" --answers=answers exercise.deck
    says '--tolerance: error: expected'
    nothing
done
# a name that nothing has
{ cat asked.deck && printf '[grading]\nswimg = 3 marks\nswing = 2 marks\n'; } >names.deck
run 2 --answers=answers --scores names.deck
says "names.deck:17: note: no value of [expect] has the name 'swimg'"
check 'the other has' none "'swing'" err
# near zero, rounding is not a mistake
printf '[expect]\nat = 90 deg\nmu = 59 deg\n' >own
sed 's/rad.s/rad\/s/; s/^speed.*/speed = 0 rad\/s/' exercise.deck >still.deck
printf '[expect]\nat = 40 deg\nomega4 = 0 rad/s\n' >zero
run 0 --check=zero --tolerance='1 %' still.deck
# decks of students: what they say of grading is told
printf '[grading]\ntolerance = 100 %%\n' | cat exercise.deck - >theirs.deck
cp answers/anna.expect answers/theirs.expect
cp answers/anna.expect answers/exercise.expect
run 0 --check=answers --scores -f csv exercise.deck theirs.deck
check 'a deck with [grading]' grep -q '^theirs,3,3,100,by the \[grading\] of its deck,[0-9,]*$' out
run 0 --check=answers --scores -f csv --tolerance='1 %' exercise.deck theirs.deck
check 'overridden' grep -q '^theirs,3,3,100,,[0-9,]*$' out
rm answers/theirs.expect answers/exercise.expect

# one file of answers, an instructor's, for all decks
cp exercise.deck longer.deck
run 1 --check=answers/emil.expect --scores -f csv exercise.deck longer.deck
quiet
prints 'longer,0,3,0,'
sed -i 's/^length = 80/length = 81/' longer.deck
run 1 --check=answers/anna.expect --scores -f csv exercise.deck longer.deck
quiet
prints 'exercise,3,3,100,'
check 'the other' grep -q '^longer,[012],3,' out
# a deck's own
run 0 --scores asked.deck
check 'its score' grep -Eqx 'asked +2 +2 +100.0' out

# ------------------------------------------------------------------------------------------ variants

{ cat exercise.deck && printf '[sweep]\ncrank.length = 18 mm to 22 mm step 1 mm\n'; } >sweep.deck
printf '\357\273\277Anna\r\n\n  Ben K. \r\nZo\303\253\n' >students.txt
mkdir decks keys reports
run 0 --design=all --print-deck --output=decks/ --names=students.txt sweep.deck
quiet
check 'their decks' test "$(ls decks | wc -l)" -eq 3 -a -f 'decks/Ben K..deck' -a -f "decks/Zo$(printf '\303\253').deck"
run 0 --design=2 --print-deck sweep.deck
same out 'decks/Ben K..deck'
run 0 --design=all --expect --at='40 deg' --columns=theta4 --output=keys/ --names=students.txt sweep.deck
check 'their answers' test "$(ls keys | wc -l)" -eq 3
run 0 --check=keys --scores decks/*.deck
check 'all right' test "$(grep -c ' 2 *2 *100' out)" -eq 3
# answers as Notepad saves them; of two files it is the .expect
mv keys/Anna.expect keys/Anna.txt
echo '[expect]' >'keys/Ben K..txt'
run 0 --check=keys --scores decks/*.deck
says "keys: note: 'Ben K..txt' is not read: 'Ben K..expect' is"
check 'a .txt is an answer' test "$(grep -c ' 2 *2 *100' out)" -eq 3
rm keys/Anna.txt
run 3 --check=keys --scores decks/*.deck
says "decks/Anna.deck: error: no file of this name in keys"
run 0 --design=all --report=reports/ --names=students.txt sweep.deck
check 'their reports' test -s reports/Anna.html
run 0 --design=all --expect --output=keys/ sweep.deck
check 'without names, numbers' test -s keys/sweep-5.expect

# refused: lists of names
for names in 'a/b' '..' "Anna${tab}B" 'anna
Anna' '1
2
3
4
5
6' ''; do
    printf '%s\n' "$names" >bad.txt
    run 2 --design=all --print-deck --output=decks/ --names=bad.txt sweep.deck
    says 'bad.txt'
done
run 3 --design=all --print-deck --output=decks/ --names=missing.txt sweep.deck
usage '--names needs --design=all or --scores' --names=students.txt sweep.deck
usage '--report=FOLDER/ needs --design=all' --report=reports/ exercise.deck
usage '--design=all needs --print-deck or --expect' --design=all --expect sweep.deck
usage '--answers takes one deck' --answers=answers exercise.deck asked.deck
run 2 --design=all --expect --output=keys/ exercise.deck
says '--design needs a [sweep]'
run 3 --answers=missing --scores exercise.deck
nothing
mkdir empty
run 3 --answers=empty --scores exercise.deck
says 'no file in this folder ends in .expect, .txt or .csv'
run 3 --answers=answers --scores -o answers/anna.expect exercise.deck
says 'it is also read'
sed 's/^\[crank/[crnk/' exercise.deck >broken.deck
run 2 --answers=answers --scores broken.deck
nothing
check 'a mistake of the deck is told once' test "$(grep -c 'unknown section' err)" -eq 1

# What is no file that can be read is a row with its reason; the others are graded, and the exit status says 3.  What a
# link leads to outside the folder is not quoted.
cp -r answers odd
mkdir odd/folder.txt
mkfifo odd/fifo.txt
ln -s loop.txt odd/loop.txt
ln -s nothing odd/nothing.txt
ln -s /dev/null odd/device.txt
printf '[expect]\nsecret = 1\n' >secret
ln -s ../secret odd/outside.txt
run 3 --answers=odd --scores -f csv -o marks.csv exercise.deck
for name in folder:'it is not a regular file' fifo:'it is not a regular file' loop:'Too many levels' nothing:'No such file' \
    device:'it is not a regular file' outside:'it is a link to a file outside the folder'; do
    check "the row of ${name%%:*}" grep -q "^${name%%:*},0,.*cannot read .*${name#*:}" marks.csv
done
check 'no file is quoted' none secret marks.csv err
"$fourlink" --answers=answers --scores -f csv exercise.deck >without 2>err
lines marks.csv $(($(wc -l <without) + 6))
run 3 --answers=odd exercise.deck
check 'without --scores too' grep -q 'it is not a regular file' out
mkdir fifos
mkfifo fifos/exercise.expect
run 3 --check=fifos --scores exercise.deck
prints 'it is not a regular file'

finish
