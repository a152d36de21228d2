#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_grade.sh FOURLINK DATA - grading: a folder of answers, scores, bad decks, hints.
. "$(dirname "$0")/../harness.sh"

mkdir class answers
cat >plain.deck <<'DECK'
mechanism = four-bar
[ground]
length = 80 mm
[crank]
length = 20 mm
[coupler]
length = 66 mm
mass = 0.3 kg
cg = 33 mm
[rocker]
length = 56 mm
[motion]
speed = 30 rad/s
interval = 30 deg
DECK
run 0 --expect -c theta4,omega4,Ts --at='40 deg, 150 deg' plain.deck
mv out answers.txt
run 0 --expect -b open -c theta4,omega4,Ts --at='40 deg, 150 deg' plain.deck
mv out open.txt

# ------------------------------------------------------------- a folder with answers for each deck

for name in anna ben carla; do
    cp plain.deck class/$name.deck
    cp answers.txt answers/$name.expect
done
sed -i 's/^cg = 33 mm/cg = 30 mm/' class/ben.deck
for folder in answers answers/ "$work/answers"; do
    run 1 --check="$folder" class/anna.deck class/ben.deck class/carla.deck
    quiet
done
check 'each with its own answers' grep -q "^ok .*answers/anna.expect:10: theta4 = " out
check 'a score for each' test "$(grep -c '^# score: ' out)" -eq 3
check 'the scores' test "$(sed -n 's/^# score: //p' out | tr '\n' ',')" = '12 of 12,8 of 12,12 of 12,'
check 'the last line' test "$(tail -n 1 out)" = '# score: 12 of 12'
run 1 -f csv --check=answers class/anna.deck class/ben.deck class/carla.deck
check 'scores of a spreadsheet' test "$(awk -F, '$4 == "score" {printf "%s %s of %s,", $1, $12, $13}' out)" = \
    'class/anna.deck 12 of 12,class/ben.deck 8 of 12,class/carla.deck 12 of 12,'
check 'one score for each deck' test "$(grep -c ',score,' out)" -eq 4 # and the header
run 0 --check=answers class/anna.deck
check 'the score of one deck' test "$(tail -n 1 out)" = '# score: 12 of 12'

# a deck with mistakes, one without answers, one that is missing: the others are graded
echo 'crank = 20 mn' >>class/carla.deck
cp plain.deck class/dora.deck
run 3 --check=answers class/carla.deck class/dora.deck class/emil.deck class/anna.deck
says 'class/carla.deck:15: error: '
says 'fourlink: class/dora.deck: error: no file of this name in answers'
says 'fourlink: cannot read class/emil.deck: No such file or directory'
check 'bad decks' test "$(sed -n 's/^# bad deck: //p' out | cut -c1-32 | tr '\n' '|')" = \
    'class/carla.deck:15: unknown key|no file of this name in answers|class/emil.deck: No such file or|'
check 'their scores' test "$(sed -n 's/^# score: //p' out | tr '\n' ',')" = '0,0,0,12 of 12,'
run 2 -f csv --check=answers class/carla.deck class/anna.deck
check 'the first mistake of a bad deck' grep -q \
    '^class/carla.deck,,,bad deck,,,,,,,,0,,"*class/carla.deck:15: unknown key' out
run 2 -f csv --check=answers class/carla.deck class/carla.deck
lines out 3
run 2 -f json --check=answers class/carla.deck class/anna.deck
check 'json, a bad deck' grep -q '^{"deck":"class/carla.deck","status":"bad deck","score":0,"message":"class/carla.deck:15: unknown key' out
check 'json, a score' grep -q '^{"deck":"class/anna.deck",.*\],"score":12,"of":12}$' out

# a deck that cannot be read, but is there: no score, and the old scores stay; answers that cannot be read are a row with
# the reason
echo old >scores.csv
mkdir class/fred.deck answers/gina.expect
cp plain.deck class/gina.deck
run 3 --check=answers class/anna.deck class/fred.deck class/gina.deck
says 'fourlink: cannot read class/fred.deck: '
says 'fourlink: cannot read answers/gina.expect: '
check 'no score for the deck' test "$(sed -n 's/^# score: //p' out | tr '\n' ',')" = '12 of 12,0,'
check 'the reason' grep -qF '# bad deck: cannot read answers/gina.expect: it is not a regular file' out
run 3 -f csv --check=answers -o scores.csv class/anna.deck class/fred.deck
check 'the old scores' test "$(cat scores.csv)" = old
run 3 -f csv --check=answers -o gina.csv class/anna.deck class/gina.deck
check 'a row for gina' grep -q '^class/gina.deck,,,bad deck,.*cannot read answers/gina.expect: it is not a regular file' gina.csv
run 3 -f csv --check=answers -o answers/anna.expect class/anna.deck class/ben.deck
same answers.txt answers/anna.expect
rm -r class/fred.deck answers/gina.expect

# what is refused
run 2 --check=answers - class/anna.deck
says 'standard input has no name: --check needs a file, not a folder'
check 'the other is graded' test "$(tail -n 1 out)" = '# score: 12 of 12'
run 3 --check=missing/ class/anna.deck
nothing
says 'cannot read missing/: '
cp answers/anna.expect kept
run 3 --check=answers -o answers/anna.expect class/anna.deck
says 'cannot write answers/anna.expect: it is also read'
same kept answers/anna.expect
echo '[crank]' >answers/dora.expect
run 2 --check=answers class/anna.deck class/dora.deck
says 'answers/dora.expect:1: error: expected [expect] or [misprint] in this file'
check 'answers with a mistake' grep -q '^# bad deck: answers/dora.expect: line 1: ' out

# ------------------------------------------------------------------------------------- one branch

run 0 --check=answers.txt -b open plain.deck
check 'the open branch alone' test "$(tail -n 1 out)" = '# score: 6 of 6'
run 0 --check=answers.txt -b crossed plain.deck
check 'the crossed branch alone' test "$(tail -n 1 out)" = '# score: 6 of 6'
check 'all of it' test "$(grep -c ', crossed$' out)" -eq 6
# answers for the other branch alone are asked of the deck's branch
run 1 --check=open.txt -b crossed plain.deck
check 'the wrong branch' test "$(tail -n 1 out)" = '# score: 0 of 6'
check 'the hint' test "$(grep -c "is the open branch's value\$" out)" -eq 6
# the deck's own [expect] keeps the branch that it names
{ cat plain.deck && cat answers.txt; } >own.deck
run 0 --check -b open own.deck
check 'its own, on both branches' test "$(tail -n 1 out)" = '# score: 12 of 12'

# ------------------------------------------------------------------------------------------ hints

# hint TEXT ANSWER...: the deck's value differs from the answer, with this hint
hint() {
    text=$1
    shift
    { echo '[expect]' && printf '%s\n' "$@"; } >one
    run 1 --check=one plain.deck
    check "$* should hint '$text': $(head -n 1 out)" grep -qF -e "; hint: $text" out
}
# no_hint ANSWER...
no_hint() {
    { echo '[expect]' && printf '%s\n' "$@"; } >one
    run 1 --check=one plain.deck
    check "$* should not hint: $(head -n 1 out)" none -F 'hint' out
}
value() { "$fourlink" -f csv -b "$3" -c "theta2,$1" plain.deck | awk -F, -v x="$2" '$2 == x {printf "%.9g", $3}'; }
product() { awk -v x="$1" -v y="$2" 'BEGIN {printf "%.4g", x * y}'; }
omega4=$(value omega4 60 open)
hint 'the sign is the opposite' 'at = 60 deg' "omega4 = $(product "$omega4" -1) rad/s"
hint 'the computed value is 60/(2 pi) times the expected one: rad/s for rpm?' \
    'at = 60 deg' "omega4 = $(product "$omega4" 0.10471975512) rad/s"
hint 'the computed value is 2 pi/60 times the expected one: rpm for rad/s?' \
    'at = 60 deg' "omega4 = $(product "$omega4" 9.5492965855) rad/s"
alpha4=$(value alpha4 60 open)
hint 'the computed value is (60/(2 pi))^2 times' 'at = 60 deg' "alpha4 = $(product "$alpha4" 0.01096622711) rad/s2"
hint 'the computed value is (2 pi/60)^2 times' 'at = 60 deg' "alpha4 = $(product "$alpha4" 91.18906528) rad/s2"
theta3=$(value theta3 60 open)
hint 'the computed value is 180/pi times' 'at = 60 deg' "theta3 = $(product "$theta3" 0.01745329252) deg"
hint 'the computed value is pi/180 times' 'at = 60 deg' "omega4 = $(product "$omega4" 57.295779513) rad/s"
hint 'the computed value is 1000 times' 'at = 60 deg' "omega4 = $(product "$omega4" 0.001) rad/s"
hint 'the computed value is 1/1000 of' 'at = 60 deg' "omega4 = $(product "$omega4" 1000) rad/s"
crossed=$(product "$(value omega4 60 crossed)" 1)
hint "$crossed rad/s is the crossed branch's value" 'at = 60 deg' "omega4 = $crossed rad/s"
next=$(product "$(value omega4 90 open)" 1)
before=$(product "$(value omega4 30 open)" 1)
hint "$next rad/s is the value of the neighbouring row, theta2 = 90" 'at = 60 deg' "omega4 = $next rad/s"
hint "$before rad/s is the value of the neighbouring row, theta2 = 30" 'at = 60 deg' "omega4 = $before rad/s"
no_hint 'at = 60 deg' 'omega4 = 1.2345 rad/s'
no_hint 'at = 60 deg' 'omega4 = 0.00 rad/s'  # a small number is not a thousandth
no_hint 'at = 60 deg' "omega4 = $(product "$omega4" 1.5) rad/s"
no_hint 'type = double-rocker'
no_hint 'max(omega4) = inf'  # to which every difference is small
printf '[misprint]\nat = 60 deg\nomega4 = %s rad/s\n' "$(product "$omega4" -1)" >one
run 0 --check=one plain.deck
check 'a misprint needs no hint' none hint out
printf '[expect]\nat = 60 deg\nomega4 = %s rad/s\n' "$(product "$omega4" -1)" >one
run 1 -f csv --check=one plain.deck
check 'a hint in csv' grep -q ',the sign is the opposite' out
run 1 -f json --check=one plain.deck
check 'a hint in json' grep -q '"hint":"the sign is the opposite"' out

finish
