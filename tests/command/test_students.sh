#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_students.sh FOURLINK DATA - a class as it is: names of files, forms of answers, what is nobody's, another's variant.
. "$(dirname "$0")/../harness.sh"

deck() { # NAME CRANK: a variant, and its answers in answers/NAME.expect
    {
        printf 'mechanism = four-bar\n[ground]\nlength = 200 mm\n[crank]\nlength = %s mm\n[coupler]\nlength = 180 mm\n' "$2"
        printf '[rocker]\nlength = 120 mm\n[motion]\nspeed = 200 rpm\ninterval = 10 deg\n[table]\nbranch = open\n'
        printf '[grading]\ntolerance = 1 %%, 0.5 deg\ndigits = 3\n'
    } >"decks/$1.deck"
    "$fourlink" --expect --at='60 deg, 200 deg' -c theta3,theta4,omega4 "decks/$1.deck" >"answers/$1.expect"
}
line() { # NAME MARKS NOTE: the line of a student
    check "$1: $(grep "^\"*$1" out)" grep -q "^$1,$2,6,[^,]*,\"*$3\"*\$" out
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

# decimal marks by [grading]
for mark in comma point; do
    sed "s/^digits.*/decimal = $mark/" 'decks/Jon Ja.deck' >"$mark.deck"
    printf '[expect]\nat = 60 deg\ntheta3 = 20,5 deg\n' >answers.txt
    "$fourlink" --check=answers.txt "$mark.deck" >out 2>err
    check "decimal = $mark" test "$(grep -c '20.5: \|write 20.5' err)" -eq "$([ $mark = point ] && echo 1 || echo 0)"
done
finish
