#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_students.sh FOURLINK DATA [all] - a class as it is: names of files, forms of answers, what is nobody's, another's variant.
. "$(dirname "$0")/../harness.sh"

if [ "${3-}" ]; then # thousands of files as people write them
    needs python3 python3
    python3 -B "$(dirname "$decks")/command/spoilt.py" "$fourlink" 3000 >out 2>&1
    check "$(head -n 20 out)" test $? -eq 0
    tail -n 1 out
    finish
fi

deck() { # NAME CRANK: a variant, and its answers in answers/NAME.expect
    {
        printf 'mechanism = four-bar\n[ground]\nlength = 200 mm\n[crank]\nlength = %s mm\n[coupler]\nlength = 180 mm\n' "$2"
        printf '[rocker]\nlength = 120 mm\n[motion]\nspeed = 200 rpm\ninterval = 10 deg\n[table]\nbranch = open\n'
        printf '[grading]\ntolerance = 1 %%, 0.5 deg\ndigits = 3\n'
    } >"decks/$1.deck"
    "$fourlink" --expect --at='60 deg, 200 deg' -c theta3,theta4,omega4 "decks/$1.deck" >"answers/$1.expect"
}
line() { # NAME MARKS NOTE: the line of a student
    check "$1: $(grep "^\"*$1" out)" grep -q "^$1,$2,6,[^,]*,\"*$3\"*\(,[01]*\)\{6\}\$" out
}

mkdir decks answers
number=40
for name in 'Ada Al' 'Bo By' 'Cy Co' "Zo$(printf '\303\253') D$(printf '\303\274')" 'Eva Em' 'Fay Fu' 'Gus Go' 'Hal Ho' 'Ida In' 'Jon Ja' \
    'Kim Ko' 'Leo Li' 'Mia Mo' 'Ned No' 'Oli Od'; do
    deck "$name" $number
    number=$((number + 2))
done
cd answers || exit 1
mv 'Ada Al.expect' ada_AL.expect.txt
mv 'Bo By.expect' 'Bo-By.txt'
mv "Zo$(printf '\303\253') D$(printf '\303\274').expect" "Zoe Du$(printf '\314\210').expect" # without an accent; with a mark behind
sed -n 's/ = /;/; s/ deg/;deg/; s# rad/s#;rad/s#; s/\./,/; /^at\|^th\|^om/p' 'Cy Co.expect' >'Cy Co.csv' && rm 'Cy Co.expect'
mv 'Eva Em.expect' 'Eva Em.docx'
sed -i 's/^theta3/Theta_3/; s/^omega4/\xcf\x894/; s/^theta4/\xce\xb8\xe2\x82\x84/' 'Fay Fu.expect'
sed -i 's/ = /: /; s/\([0-9]\)\.\([0-9]\)/\1,\2/' 'Gus Go.expect'
sed -i '/^.expect/d' 'Hal Ho.expect'
sed -i 's/^at = 60 deg/at = about 60 deg/' 'Ida In.expect'
cp 'Jon Ja.expect' 'Kim Ko.expect'
sed -i 's/^\(theta[34]\|omega4\) = \(-*[0-9]*\)\.[0-9]*/\1 = \2/' 'Leo Li.expect'
: >'Mia Mo.expect'
sed -i 's/^at = 60 deg/at = 1.0472 rad/; s/^at = 200 deg/at = 3.4907 rad/' 'Ned No.expect'
rm 'Oli Od.expect'
printf 'to do\n' >'Ada Alo.txt'
cd ..

run 3 --check=answers --scores -f csv decks/*.deck
line 'Ada Al' 6 ''
line 'Bo By' 6 ''
line 'Cy Co' 6 'decimal commas, read as points'
line "Zo$(printf '\303\253') D$(printf '\303\274')" 6 ''
line 'Eva Em' 0 'answers/Eva Em.docx cannot be read: save it as text or csv'
line 'Fay Fu' 6 ''
line 'Gus Go' 6 'decimal commas, read as points'
line 'Hal Ho' 6 'no header \[expect\], read as if it were there'
line 'Ida In' 3 ".*line [0-9]*: 'about 60 deg' is no angle: the values below it do not count.*"
line 'Jon Ja' 6 ''
line 'Kim Ko' '[0-2]' '.*agrees with the variant of Jon Ja: 6 of 6 values.*'
check "Leo Li: $(grep '^Leo' out)" grep -q '^Leo Li,[0-5],6,.*have fewer digits than asked for' out
line 'Mia Mo' 0 'answers/Mia Mo.expect:1: the file is empty'
line 'Ned No' 6 ''
line 'Oli Od' 0 'no file of this name in answers'
says "answers: note: 'Ada Alo.txt' is nobody's: no deck has its name; the nearest is 'Ada Al'"
check 'nothing else is nobody'"'"'s' test "$(grep -c "is nobody's" err)" -eq 1

check 'a column for each question' grep -q '^name,right,of,percent,note,theta3 at 60,theta4 at 60,omega4 at 60,theta3 at 200' out
check 'its marks' grep -q '^Ada Al,6,6,100,,1,1,1,1,1,1$' out
check 'those missing' grep -q '^Ida In,3,6,50,.*,,,,1,1,1$' out

# a text for each, also for those without a file; computed values only if [grading] says so
mkdir feedback
run 3 --check=answers --feedback=feedback/ decks/*.deck
check 'a line each' grep -Eq '^Ada Al +6 +6' out
check 'a text each' test "$(ls feedback | wc -l)" -eq 15
check 'right' grep -Eq '^theta3 at 60 +[0-9.]+ deg +right, 1 of 1$' 'feedback/Ada Al.txt'
check 'wrong' grep -Eq '^theta3 at 60 +[0-9.]+ deg +wrong, 0 of 1' 'feedback/Kim Ko.txt'
check 'no answer' test "$(grep -c 'no answer, 0 of 1$' 'feedback/Oli Od.txt')" -eq 6
check 'why' grep -qx 'no file of this name in answers' 'feedback/Oli Od.txt'
check 'no computed values' none computed 'feedback/Kim Ko.txt'
sed -i 's/^digits.*/feedback = answers/' 'decks/Kim Ko.deck'
run 3 --check=answers --feedback=feedback/ decks/*.deck
check 'computed values' test "$(grep -c 'wrong, 0 of 1; computed [0-9.]* ' 'feedback/Kim Ko.txt')" -eq 4
usage '--feedback needs a folder, such as feedback/' --feedback=feedback --check=answers 'decks/Kim Ko.deck'

# a form: nothing of the solution; not filled in, all is missing; filled in, all is right
run 0 --form --at='60 deg, 200 deg' -c theta3,omega4 'decks/Jon Ja.deck'
check 'no number but those of the places' none -E '^(theta3|omega4) = *-?[0-9]' out
check 'names and units' test "$(grep -c '^theta3 = *# deg$\|^omega4 = *# rad/s$' out)" -eq 4
check 'nothing of the type' none rocker out
cp out form.txt
"$fourlink" --expect --at='60 deg, 200 deg' -c theta3,omega4 'decks/Jon Ja.deck' | sed -n 's/^\(theta3\|omega4\) = //p' >values
awk 'NR == FNR {v[NR] = $0; next} / = *# /{sub(/ = *#.*/, " = " v[++n])} {print}' values form.txt >full.txt
run 0 --check=full.txt 'decks/Jon Ja.deck'
check 'filled in' grep -q '^# score: 4 of 4$' out
{ cat 'decks/Jon Ja.deck' && printf '[expect]\nswing = 7 deg\n[expect]\nat = 60 deg\nomega4 = 3 rad/s\n'; } >own.deck
run 0 --form own.deck
check 'what its own [expect] asks' test "$(grep -c '^swing = *# deg$\|^omega4 = *# rad/s$' out)" -eq 2
check 'not its values' none -E '= [37] ' out
{ cat own.deck && printf '[misprint]\nmu_min = 1 deg\n'; } >misprint.deck
run 0 --form misprint.deck
check 'no misprint is asked for' none mu_min out

# ids and days late of a list of names; a deduction for each day
printf 'late;id;name\n2;007;ADA_AL\n;8;Bo By\n20;9;Jon Ja\n' >names.csv
for variant in decks/*.deck; do sed -i 's/^tolerance.*/&\nlate = 10 %/' "$variant"; done
run 3 --check=answers --scores -f csv --names=names.csv decks/*.deck
check 'its header' grep -q '^name,right,of,percent,note,id,late,total,theta3 at 60,' out
check "two days: $(grep '^Ada' out)" grep -q '^Ada Al,6,6,100,,007,2,4.8,1' out
check 'in time' grep -q '^Bo By,6,6,100,,8,0,6,1' out
check 'no marks below 0' grep -q '^Jon Ja,6,6,100,,9,20,0,1' out
check 'not in the list' grep -q '^Ned No,6,6,100,,,0,6,1' out
printf 'name,late\nBo By,two\n' >names.csv
run 2 --check=answers --scores --names=names.csv decks/*.deck
says 'names.csv:2: error: late must be a number of days, such as 2'
usage '--names needs --design=all or --scores' --check=answers --names=names.csv 'decks/Bo By.deck'
printf 'Ada Al\n' >names.csv
run 2 --check=answers --scores --names=names.csv decks/*.deck
says 'names.csv:1: error: expected the titles of columns: name, id, late'

# a file by itself has the score that it has among others, if the deck is an exercise, with [expect] and [grading]
mkdir alone
printf '[expect]\nat = 60 deg\nomega4 = 6 rad/s\n' >alone/one.txt
run 1 --check=alone/one.txt own.deck
check "of two: $(tail -n 2 out)" grep -qx '# score: 0 of 2' out
run 1 --answers=alone own.deck
check 'the same in a folder' grep -qx '# score: 0 of 2' out
sed '/^.grading/,/^digits/d' own.deck >plain.deck
run 1 --check=alone/one.txt plain.deck
check 'a list of its own' grep -qx '# score: 0 of 1' out

# decimal marks by [grading]
for mark in comma point; do
    sed "s/^digits.*/decimal = $mark/" 'decks/Jon Ja.deck' >"$mark.deck"
    printf '[expect]\nat = 60 deg\ntheta3 = 20,5 deg\n' >answers.txt
    "$fourlink" --check=answers.txt "$mark.deck" >out 2>err
    check "decimal = $mark" test "$(grep -c '20.5: \|write 20.5' err)" -eq "$([ $mark = point ] && echo 1 || echo 0)"
done
finish
