#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# blocks.sh FOURLINK DATA FILE.test - runs a test that is written as blocks: commands, and what they print.
#
#   # words        a comment
#   needs P PKG    the test is skipped where the program P of the package PKG is not installed
#   file F [B]     the lines below that begin with two blanks are the file F, after those of the file B
#   $ COMMAND      run by sh; several of these lines are one script.  `fourlink` is the program, $DATA and $DECKS are the
#                  folders data and tests/decks, and the test has a folder of its own
#   = N            its exit status, 0 without this line
#   | LINE         its results have this line, after the lines expected above it.  Blanks do not matter, `...` stands for
#                  any words, a number agrees with all that it is when rounded to as many decimals
#   .              its results have no other lines than those
#   + TEXT         its results have this text somewhere;  +3 TEXT: in three lines
#   - TEXT         its results do not have it;  - alone: there are no results
#   ! TEXT         one of its messages has it;  !2 TEXT: two;  !* TEXT: any number
#   {} A => B...   the script runs with A in place of its {}; if it has none, A stands for the {} of the file above, where
#                  // ends a line.  Expected are B: messages if N is 2 or 3, and if not, lines of results
#
# Nothing else is accepted: each message needs its `!`, and a script that ends with 2 or 3 prints no results but those
# expected.
set -u
fourlink=$1 DATA=$(cd "$2" && pwd) test=$3
case $fourlink in /*) ;; *) fourlink=$PWD/$fourlink ;; esac
case $test in /*) ;; *) test=$PWD/$test ;; esac
tests=$(cd "$(dirname "$0")" && pwd)
DECKS=$tests/decks
export DATA DECKS
. "$tests/needs.sh"
while read -r word program package; do
    [ "$word" != needs ] || needs "$program" "$package"
done <"$test"

work=$(mktemp -d) || exit 1
trap 'rm -rf "$work" 2>/dev/null || { chmod -R u+w "$work" && rm -rf "$work"; }' EXIT
trap 'exit 1' HUP INT TERM
mkdir "$work/bin" "$work/folder"
ln -s "$fourlink" "$work/bin/fourlink"
PATH=$work/bin:$PATH
umask 022
cd "$work/folder" && LC_ALL=C awk -f "$tests/blocks.awk" "$test"
