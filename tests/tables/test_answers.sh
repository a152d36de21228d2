#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_answers.sh FOURLINK DATA - --check=FILE, --check in csv, and a class of decks marked with
# one file of answers.
. "$(dirname "$0")/../harness.sh"

cp "$decks/expectations.deck" good.deck
sed 's/^stroke = 200/stroke = 210/; s/^n = 4/n = 3/' good.deck >wrong.deck
sed 's/^stroke/strok/' good.deck >unknown.deck

# ---------------------------------------------------------------------------------- --check=FILE

cat >answers <<'EOD'
# the answers
[expect]
n = 3.0
[misprint]
stroke = 22 cm
EOD
for form in --check=answers "--check=$work/answers"; do
    run 0 $form good.deck
    quiet
done
lines out 4
prints "answers:3: n = 3.0, computed 3, open"
prints "misprint confirmed"
check 'in place of those of the deck' none good.deck out
run 0 --check=answers wrong.deck # which has other expectations of its own
sed '/^\[expect\]/,$d' good.deck >plain.deck
run 0 --check=answers plain.deck
run 2 --check=answers -C plain.deck # the last one counts: the deck's own, of which there are none
sed 's/22 cm/20 cm/' answers >wrong-answers
run 1 --check=wrong-answers good.deck
prints 'not a misprint'
run 1 --check=answers -s 'rod.length=200 mm' good.deck

# a missing file, and one that is a folder
run 3 --check=missing good.deck
nothing
says 'fourlink: cannot read missing: No such file or directory'
run 3 --check=. good.deck
nothing

# bad lines in it
cat >bad <<'EOD'
[expect]
strok = 200 mm
n = three
[crank]
length = 200 mm
[expect]
stroke
at = 5 mm
EOD
run 2 --check=bad good.deck
check 'no value of two lines' test "$(grep -c '^no value' out)" -eq 2
says 'bad:4: error: expected [expect] or [misprint] in this file, not [crank]'
says "bad:7: error: expected NAME = VALUE, not 'stroke'"
says "bad:8: error: '5 mm' is no angle: the values below it do not count"
cat >bad <<'EOD'

[expect]
xyzzy = 200 mm
n = three
EOD
run 2 --check=bad good.deck
check 'no value of both' test "$(grep -c '^no value' out)" -eq 2
says "bad:3: error: 'xyzzy' is neither a column nor a fact of this deck"
says "bad:4: error: expected a number, such as 0.02, not 'three'"
echo 'n = 3' >bad
run 0 --check=bad good.deck
check 'a value without a header' grep -q '^ok  *bad:1: n = 3, computed 3' out
says 'bad:1: note: no header [expect], read as if it were there'
# what people write: another mark, commas, a colon, letters of any case, a spreadsheet
printf '[expect]\nSTROKE: 200,0 mm\nN = 3,0\n' >bad
run 0 --check=bad good.deck
check 'names and colons' test "$(grep -c '^ok' out)" -eq 2
says 'note: decimal commas, read as points'
printf 'name;value;unit\nstroke;200,0;mm\nn;3\n' >bad
run 0 --check=bad good.deck
check 'a spreadsheet' test "$(grep -c '^ok' out)" -eq 2
printf '\nname;value;unit\nstroke;200,0;mm\n' >bad # an empty line before the names of the columns
run 0 --check=bad good.deck
check 'the second line' test "$(grep -c '^ok' out)" -eq 1
printf 'stroke = 200.0 mm\n[expect]\nn = 3\n' >bad
run 0 --check=bad good.deck
check 'a header that comes later' none 'no header' err
printf 'stroke,200.0,mm\nn,"3"\n' >bad
run 0 --check=bad good.deck
check 'one with commas' test "$(grep -c '^ok' out)" -eq 2
printf '[expect]\nn = 3,0\nstroke = 200.0 mm\n' >bad
run 2 --check=bad good.deck
says "bad:2: error: '3,0': a comma as decimal mark: write 3.0"
{ cat good.deck && printf '[grading]\ndecimal = comma\n'; } >commas.deck
run 0 --check=bad commas.deck
printf '# nothing\n\n' >bad
run 2 --check=bad good.deck
nothing
says 'error: nothing to check'
printf '[expect]\n\001 = 3\n' >bad
run 2 --check=bad good.deck
check 'a control character, with its line' grep -q '^bad:2: error: ' err
: >bad
run 2 --check=bad good.deck
says 'bad:1: error: the file is empty'
# carriage returns, a byte order mark, no end of the last line
printf '\357\273\277[expect]\r\nn = 3.0\r\nstroke = 200 mm' >answers-dos
run 0 --check=answers-dos good.deck
prints '# ok: 2,'

# -------------------------------------------------------------------------------- --check, csv

run 1 -C -f csv wrong.deck
quiet
check 'the end of the lines' none "$cr" out
lines out 7
check 'the header' test "$(head -n 1 out)" = \
    'file,line,result,name,theta2,branch,unit,printed,computed,tolerance,score,of,note'
check 'a difference' grep -Eqx 'wrong.deck,10,differs,stroke,,open,m,210 mm,0\.(2|19999999999999[0-9]*|200000000000000[0-9]*),0\.000(5|500000000000[0-9]*|49999999999[0-9]*),,,' out
check 'words' grep -qx 'wrong.deck,11,ok,type,,open,,"slider-crank, the crank turns fully","slider-crank, the crank turns fully",,,,' out
check 'an angle' grep -Eqx 'wrong.deck,14,ok,phi,90,open,deg,19\.47 deg,19\.4712206[0-9]*,0\.00(5|50000000[0-9]*|499999[0-9]*),,,' out
check 'no misprint' grep -Eqx 'wrong.deck,16,not a misprint,n,,open,1,3,(3|2\.99999999999999[0-9]*),0\.5,,,' out
check 'the score' test "$(tail -n 1 out)" = ',,score,,,,,,,,3,5,'
run 0 -C -f csv good.deck
run 2 -C -f csv unknown.deck
check 'no half of a report' none -F 'good.deck,' out

# several decks and one file of answers, as a class is marked
mkdir class
for name in anna ben 'c, "d"'; do cp plain.deck "class/$name.deck"; done
sed 's/300 mm/310 mm/' plain.deck >class/ben.deck
run 1 --check=answers -f csv class/anna.deck class/ben.deck 'class/c, "d".deck'
lines out 10
check 'a column deck' test "$(head -n 1 out)" = \
    "deck,file,line,result,name,theta2,branch,unit,printed,computed,tolerance,score,of,note"
check 'Anna' grep -q '^class/anna.deck,answers,3,ok,n,' out
check 'Ben' grep -q '^class/ben.deck,answers,3,differs,n,' out
check 'c, "d"' grep -q '^"class/c, ""d"".deck",answers,3,ok,n,' out
holds 'two lines each, and the score' 'BEGIN {FS = ","} NR > 1 {n[$1]++} END {for (d in n) if (n[d] != 3) bad = 1; exit bad}'
run 0 --check=answers -f csv class/anna.deck 'class/c, "d".deck'
# each deck is graded whatever becomes of the others; the status is the worst
sed 's/100 mm/100 mn/' plain.deck >class/broken.deck
run 2 --check=answers -f csv class/broken.deck class/ben.deck class/anna.deck
says 'class/broken.deck:3: error: '
check 'the others' test "$(grep -c '^class/anna.deck,\|^class/ben.deck,' out)" -eq 6
run 3 --check=answers -f csv class/missing.deck class/ben.deck class/anna.deck
check 'the others' test "$(grep -c '^class/anna.deck,\|^class/ben.deck,' out)" -eq 6
run 1 --check=answers class/anna.deck class/ben.deck
check 'each under its name' test "$(grep -c '^# deck: class/' out)" -eq 2
check 'a sum for each' test "$(grep -c '^# ok: ' out)" -eq 2
# answers from standard input, or a pipe, which can be read but once
"$fourlink" --check=- class/anna.deck <answers >out 2>err
check 'answers on standard input' test $? -eq 0
prints 'n = 3.0'
"$fourlink" --check=- class/anna.deck 'class/c, "d".deck' <answers >out 2>err
status=$?
check "answers on standard input for two decks: $(head -n 1 err)" test $status -eq 0
check 'both are graded' test "$(grep -c 'n = 3.0' out)" -eq 2

finish
