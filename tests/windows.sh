#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# windows.sh - Windows: the library and the command by MinGW-w64, run by Wine.  Compares the results of decks with
# this machine's, tries what is different there (paths, line ends, names, rsvg-convert), and runs the tests.  For
# Debian 12 or later on amd64, as root, because it installs packages.  GSL and cmocka are compiled from
# Debian's sources.  Debian has no rsvg-convert for Windows: a program that prints its input stands in.
. "$(dirname "$0")/foreign.sh"
# These compile, take an hour when emulated, need signals, links, devices or a terminal of POSIX, names with quotes or
# control characters, or rsvg-convert itself.
others='install|readme|includes|fast_math|brute|interruption|missing_designs|failures|output|files|terminal|readers'
others="$others|rfc4180|speed|test_csv|test_json|test_summary|test_answers|inverted_decks|plot|picture|vectors|klein|kinds"
others="$others|assets|browser|characters|test_columns|report_|test_report|test_pdf|test_pages|sample|test_sweeps|curves|scripts|names|odd_decks|readable|scales"

install cmake make gcc libgsl-dev dpkg-dev mingw-w64 wine wine64
export WINEPREFIX="$work/wine" WINEDEBUG=-all
# A program that waits until this script ends keeps Wine's services: without it each start takes two seconds.
rm -f waiting
mkfifo waiting
wine cmd <waiting >/dev/null 2>&1 &
exec 9>waiting
wine cmd /c ver >/dev/null 2>&1 9>&- # nothing that stays holds it open
wine='/usr/bin/env LC_ALL=C.UTF-8 wine' # it takes names of files as bytes of the locale
mingw=x86_64-w64-mingw32
build_gsl windows $mingw $mingw-gcc
build_cmocka windows -DCMAKE_C_COMPILER=/usr/bin/$mingw-gcc -DCMAKE_SYSTEM_NAME=Windows
usr=$work/windows/usr
configure windows -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_C_COMPILER=/usr/bin/$mingw-gcc \
    -DCMAKE_EXE_LINKER_FLAGS=-static -DGSL_INCLUDE_DIR="$usr/include" -DGSL_LIBRARY="$usr/lib/libgsl.a" \
    -DGSL_CBLAS_LIBRARY="$usr/lib/libgslcblas.a" -DGSL_VERSION=2.7.1 -DCMOCKA_INCLUDE_DIR="$usr/include" \
    -DCMOCKA_LIBRARY="$usr/lib/libcmocka.a" -DFOURLINK_WERROR=OFF # isnan() of its headers warns, in the tests
build windows fourlink_command
status=0
grep 'src/.*warning' windows/build.log && status=1
count $status 'windows: warnings'
emulate windows "$wine"
configure native
build native fourlink_command
random_decks 60
results native/build/fourlink native/results
compare windows

# The one line of doc/platforms.md builds it too.
status=0
(cd "$source" && $mingw-gcc -Iinclude -Isrc -I"$usr/include" src/*/*.c -L"$usr/lib" -lgsl -lgslcblas -lm \
    -o "$work/windows/line.exe") && wine windows/line.exe --version | grep -q '^fourlink ' || status=1
count $status 'windows: the command built by one line'

# ---- what is different there: names are Z:\..., for /
fourlink=$work/windows/build/fourlink
rm -rf try
mkdir -p try/decks try/bin
cd try
here="Z:$(pwd | tr / '\\')"
expect() { # WHAT COMMAND...: it succeeds
    what=$1
    shift
    status=0
    "$@" || status=1
    count $status "windows: $what"
}
says() { grep -qF -e "$1" messages; }
run() { # STATUS ARGUMENT...: fourlink ends with it; its output is in the files out and messages
    wanted=$1
    shift
    got=0
    "$fourlink" "$@" >out 2>messages </dev/null || got=$?
    expect "exit status $got of fourlink $*: $(head -n 2 messages)" test $got -eq "$wanted"
}

alvi=$source/data/alvi-5.1.deck
"$work/native/build/fourlink" "$alvi" >table
cp "$alvi" decks/x.deck
run 0 "$here\\decks\\x.deck"
expect 'a path with a drive and backslashes' cmp table out
run 0 'decks\x.deck'
expect 'a path with backslashes' cmp table out
run 0 decks/x.deck
expect 'a path with slashes' cmp table out
"$fourlink" - <"$alvi" >out
expect 'a deck on standard input' cmp table out
sed 's/$/\r/' "$alvi" >decks/crlf.deck
run 0 'decks\crlf.deck'
expect 'CR LF' cmp table out
cp "$alvi" 'decks/Gelenkviereck – Übung 1 ×.deck'
run 0 'decks\Gelenkviereck – Übung 1 ×.deck'
expect 'a name in UTF-8' cmp table out
run 3 'decks\no – such.deck'
expect 'a message names the file' says 'no – such.deck'
expect 'a message says why' says 'No such file'

# outputs
echo old >new.txt
run 0 --output=new.txt decks/x.deck
expect 'an output in place of an older file' cmp table new.txt
run 0 "--output=$here\\decks\\Tafel ü.txt" decks/x.deck
expect 'an output with a drive and a name in UTF-8' cmp table 'decks/Tafel ü.txt'
printf '[krank]\n' >decks/bad.deck
run 2 --output=new.txt 'decks\bad.deck'
expect 'a bad deck leaves the old output' cmp table new.txt
expect 'a message with a line' says 'decks\bad.deck:1: error: '
run 3 --output=new.txt new.txt
expect 'an output that is also read' says 'it is also read'
run 3 '--output=decks\x.deck' decks/x.deck
expect 'the same by another name' says 'it is also read'
run 3 --output=a.svg '--plot=.\a.svg' decks/x.deck
expect 'two outputs, one name' says 'two outputs have this name'
run 3 '--output=none\new.txt' decks/x.deck
expect 'a folder that is not there' says 'No such file'
run 3 --output=decks decks/x.deck
run 0 --format=csv --output=x.csv decks/x.deck
expect 'csv has no CR' test "$(tr -cd '\r' <x.csv | wc -c)" -eq 0
mkdir class
cp decks/x.deck decks/asked.deck
printf '\n[expect]\nmu_max = 0 deg\n' >>decks/asked.deck
printf '[expect]\r\nmu_max = 90 deg\r\n' >class/anna.txt
printf '[expect]\r\nmu_max = 80 deg\r\n' >class/ben.EXPECT
run 1 '--answers=class\' --scores --format=csv decks/asked.deck
expect 'the answers of a folder' test "$(cut -d, -f1-3 out | tr '\n' ' ')" = 'name,right,of anna,1,1 ben,0,1 '
expect 'no temporary file is left' test -z "$(find . -name '.fourlink*')"

# streams that the shell of Windows redirects: Wine knows those of this one by no name
cp "$alvi" mine.deck
cp "$work"/windows/build/real/fourlink.exe .
got=0
wine cmd /c 'fourlink.exe --output=mine.deck - < mine.deck' 2>messages || got=$?
expect 'a deck on standard input is not replaced' test $got -eq 3
expect 'it stays' cmp mine.deck "$alvi"
"$work/native/build/fourlink" "$alvi" >table
wine cmd /c 'fourlink.exe --output=same.txt mine.deck > same.txt'
expect 'an output that is standard output too' cmp table same.txt

# files that a deck names
mkdir decks/sub
printf '0 1\r\n90 20\r\n180 4\r\n' >decks/sub/card.txt
cp decks/sub/card.txt card.txt
engine() { # NAME: a deck whose card is this file
    printf 'mechanism = slider-crank\n[crank]\nlength = 5 cm\n[rod]\nlength = 20 cm\n[gas]\nbore = 10 cm\n'
    printf 'indicator = file %s deg bar\n[motion]\nspeed = 10 rad/s\ninterval = 90 deg\n' "$1"
}
engine sub/card.txt >decks/engine.deck
"$work/native/build/fourlink" decks/engine.deck >table
run 0 'decks\engine.deck'
expect 'a card' cmp table out
engine 'sub\card.txt' >decks/engine.deck
run 0 'decks\engine.deck'
expect 'a card by a backslash' cmp table out
for name in '..\card.txt' '../card.txt' "$here\\decks\\sub\\card.txt" 'Z:card.txt' '\card.txt' 'sub\..\..\card.txt' nul con sub; do
    engine "$name" >decks/engine.deck
    run 2 'decks\engine.deck'
done
engine '..\card.txt' >decks/engine.deck
run 0 --allow-files 'decks\engine.deck'
expect 'a card outside, permitted' cmp table out

# several decks by a wildcard, which cmd.exe leaves to the program; --check with a folder of answers
mkdir many
cp "$source/data/me3491-matrix.deck" many/a.deck
cp "$source/data/me3491-matrix.deck" many/b.deck
run 0 --check 'many\*.deck'
"$work/native/build/fourlink" --check many/a.deck many/b.deck | tr / '\\' >table
tr / '\\' <out >slashes
expect 'a wildcard' cmp table slashes
"$work/native/build/fourlink" --expect many/a.deck >many/a.expect
run 0 '--check=many\' 'many\a.deck'
run 0 --check=many 'many\a.deck'

# rsvg-convert: a program that copies its input in its place
cat >convert.c <<'C'
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
int main(int argc, char **argv)
{
    int c, i;
    char *fails = getenv("CONVERT_FAILS");
    for (i = 1; i < argc; i++)
        printf("<%s>\n", argv[i]);
    if (fails)
        return fprintf(stderr, "Error reading SVG\n"), atoi(fails);
    while ((c = getchar()) != EOF)
        putchar(c);
    return 0;
}
C

# reports, without what may differ: the last digits of csv, the residual; not of motions that
# are integrated, where more is rounding
mkdir path
ln -s "$(command -v wine)" "$(command -v sh)" path
touch report
for deck in "$source"/data/*.deck; do
    ! grep -q '^mode ' "$deck" || continue
    cp "$deck" mine.deck
    for program in "$fourlink" "$work/native/build/fourlink"; do
        got=0
        PATH=$PWD/path "$program" --report=page.html mine.deck 2>messages || got=$?
        mv report other
        sed -E '/^(open|crossed),/d; s/,-?[0-9]\.[0-9]e[-+][0-9]+\]/]/' page.html | cat messages - >report
        echo "exit status $got" >>report
    done
    expect "the report of ${deck##*/}" cmp other report
done

run 3 --plot=x.png decks/x.deck
expect 'no rsvg-convert' says 'rsvg-convert, which makes png and pdf, is not installed'
expect 'no picture' test ! -e x.png
mkdir here
$mingw-gcc convert.c -o here/rsvg-convert.exe
cd here
run 3 --plot=x.png ../decks/x.deck
expect 'rsvg-convert of the working folder is not run' says 'is not installed'
cd ..
mv here/rsvg-convert.exe bin
WINEPATH="$here\\bin"
export WINEPATH
run 0 --plot=x.png decks/x.deck
run 0 --plot=x.svg decks/x.deck
expect 'a picture' grep -q '<--format=png>' x.png
expect 'all of the SVG is read' grep -q '</svg>' x.png
cp x.png old.png
CONVERT_FAILS=1
export CONVERT_FAILS
run 3 --plot=x.png decks/x.deck
expect 'what it complains about' says 'Error reading SVG'
expect 'the old picture stays' cmp x.png old.png
unset CONVERT_FAILS
expect 'no temporary file is left' test -z "$(find . -name '.fourlink*')"
cd "$work"

build windows all
emulate windows "$wine"
run_tests windows "$others"
finish
