#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_files.sh FOURLINK DATA - the files that decks name: those of their own folder only.
. "$(dirname "$0")/../harness.sh"

mkdir own own/sub other
printf '0 1\n90 20\n180 4\n' >card.txt
cp card.txt own/card.txt
cp card.txt own/..card.txt
cp card.txt own/sub/card.txt
cp card.txt other/card.txt
cp card.txt owner.txt # begins like the folder
mkdir own-too # begins like the folder, too
cp card.txt own-too/card.txt
ln -s ../other/card.txt own/out.txt
ln -s ../own-too/card.txt own/near.txt
ln -s "$work/own/card.txt" own/in.txt
ln -s ../other own/folder
ln -s own/none.txt own/dangling.txt
ln -s own link

# engine NAME: a deck whose card is this file
engine() {
    printf 'mechanism = slider-crank\n[crank]\nlength = 5 cm\n[rod]\nlength = 20 cm\n[gas]\nbore = 10 cm\n'
    printf 'indicator = file %s deg bar\n[motion]\nspeed = 10 rad/s\ninterval = 90 deg\n' "$1"
}
outside='fourlink: own/x.deck: note: a deck may name files of its own folder only; --allow-files permits others'

for name in card.txt ./card.txt sub/card.txt in.txt ..card.txt .//card.txt '"card.txt"'; do
    engine "$name" >own/x.deck
    run 0 -f csv own/x.deck
    quiet
    mv out expected
    run 0 -f csv --allow-files own/x.deck
    same out expected
    run 0 -f csv link/x.deck
    same out expected
    (cd own && "$fourlink" -f csv x.deck && "$fourlink" -f csv - <x.deck) >twice 2>err
    quiet
    check "$name: beside a deck of this folder, and of standard input" test "$(wc -l <twice)" -eq "$(($(wc -l <expected) * 2))"
done
for name in ../card.txt ../own/card.txt sub/../card.txt "$work/card.txt" "$work/own/card.txt" out.txt near.txt folder/card.txt \
    ../owner.txt sub/../../card.txt; do
    engine "$name" >own/x.deck
    for option in -fcsv --check --list --summary; do
        run 2 $option own/x.deck
        [ $option = --check ] || nothing
        says "own/x.deck:8: error: cannot read the file '"
        says "$outside"
    done
    run 0 -f csv --allow-files own/x.deck
    quiet
    same out expected
done
engine ../card.txt >own/x.deck
(cd own && "$fourlink" <x.deck) >out 2>err
check 'standard input: not from the folder above' test $? -eq 2
nothing
engine card.txt >own/x.deck
run 2 -s "gas.indicator=file $work/card.txt deg bar" own/x.deck
nothing
engine '../card.txt' >own/x.deck
echo '[sweep]
crank.length = 4 cm, 5 cm
output = swing, stroke' >>own/x.deck
run 2 own/x.deck
nothing

# what is not there
for name in none.txt dangling.txt sub/none.txt; do
    engine $name >own/x.deck
    run 2 own/x.deck
    says "own/x.deck:8: error: cannot read the file '$name'"
    lines err 1
done

# a FIFO is not waited for, a device is not read
mkfifo own/fifo
engine fifo >own/x.deck
for option in --allow-files --wide; do
    timeout 10 "$fourlink" $option own/x.deck >out 2>err </dev/null
    check 'a FIFO: refused at once' test $? -eq 2
    says 'it is not a regular file'
done
engine sub >own/x.deck
run 2 own/x.deck
says 'it is not a regular file'
engine /dev/zero >own/x.deck
run 2 --allow-files own/x.deck
says 'it is not a regular file'

# messages quote 20 bytes of a file at most
check_quotes() {
    run 2 own/x.deck
    says "secret.txt:$1: error: "
    check "more than 20 bytes of the file: $(cat err)" awk -v secret="$secret" '
        {for (i = 1; i + 20 <= length(secret); i++) if (index($0, substr(secret, i, 21))) exit 1}' err
}
for secret in 'root:x:0:0:Top secret words:/root:/bin/bash' '5 root:x:0:0:Top-secret-words:/root:/bin/bash' \
    '5 6 root:x:0:0:Topsecretwords:/root' '5;6rootxTopsecretwordsrootrootrootwords' 'a [rootxTopsecretwordsrootrootrootwords] b' \
    '5;12345678901234567890123456789012345678,5' 'phi;p [Topsecretwordsrootrootrootwords]' \
    '5 6 rootxTopsecretwordsrootrootroot,words'; do
    for units in '' 'deg bar' 'bar'; do
        engine secret.txt | sed "s/deg bar/$units/" >own/x.deck
        echo "$secret" >own/secret.txt
        check_quotes 1
        printf '0;1\n%s\n' "$secret" >own/secret.txt
        check_quotes 2
    done
done
# what is shorter is quoted whole, with its reason
printf '0 1\n90 20 bahr\n' >own/secret.txt
engine secret.txt >own/x.deck
run 2 own/x.deck
says "secret.txt:2: error: unknown unit 'bahr' in '90 20 bahr'"

finish
