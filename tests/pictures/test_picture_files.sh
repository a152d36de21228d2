#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_picture_files.sh FOURLINK DATA - the files of pictures: inputs are kept, links and rights stay.
. "$(dirname "$0")/pictures.sh"

cp "$fourbar" input.svg
cp "$fourbar" input.copy
ln -s input.svg link.svg
for option in --plot=input.svg --plot=./input.svg --plot=link.svg; do
    run 3 $option input.svg
    says 'it is also read'
    same input.svg input.copy
done
"$fourlink" --plot=input.svg <input.svg >out 2>err
check 'standard input is not written over' test $? -eq 3
same input.svg input.copy
mkdir folder.svg
run 3 --plot=folder.svg "$fourbar"
says 'folder.svg: Is a directory'
nothing
run 3 --plot=missing/x.svg "$fourbar"
says 'missing/x.svg: No such file'
nothing
run 3 --plot=x.svg missing.deck
nothing
says 'missing.deck'
check 'no picture without a deck' test ! -e x.svg
printf 'title = nothing\n' >empty.deck
run 2 --plot=x.svg empty.deck
check 'no picture of a wrong deck' test ! -e x.svg
# one file is not both results and picture
for pair in '--output=both.svg --plot=both.svg' '--report=both.svg --plot=both.svg' '--output=./both.svg --plot=both.svg'; do
    rm -f both.svg
    "$fourlink" $pair "$fourbar" >out 2>err
    check "one file for two: $pair" test $? -ne 0
done
# A file that the deck names is an input, and a link to a file is that file.
sed 's/^pressure *=.*/indicator = file card.txt/' "$engine" >card.deck
printf '0 1e5\n90 20e5\n180 3e5\n' >card.txt
cp card.txt before.txt
for option in --output=card.txt --plot=card.txt; do
    run 3 "$option" card.deck
    says 'it is also read'
    same card.txt before.txt
done
: >aim.svg
ln -s aim.svg alias.svg
run 3 --output=aim.svg --plot=alias.svg card.deck
says 'two outputs have this name'
check 'the file is as it was' test ! -s aim.svg

finish
