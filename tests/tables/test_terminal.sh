#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_terminal.sh FOURLINK DATA - on a terminal a table fits the width; elsewhere it is one block.
. "$(dirname "$0")/../harness.sh"

needs script bsdutils
NO_COLOR=1
export NO_COLOR

# shows WIDTH ARGUMENT...: what the program shows on a terminal of this width is in the file out.
shows() {
    COLUMNS=$1
    shift
    export COLUMNS
    command="'$fourlink'"
    for word in "$@"; do command="$command '$word'"; done
    script -qec "$command" /dev/null </dev/null | tr -d '\r' >out
    unset COLUMNS
}
fits() { holds "not wider than $1" "length > $1 {print; bad = 1} END {exit bad}"; }
blocks_fit() { holds "not wider than $1" "/^# branch/ {on = 1} /^# deck/ {on = 0} on && length > $1 {print; bad = 1} END {exit bad}"; }
blocks() { check "$1 blocks" test "$(grep -c '^# *theta2 ' out)" -eq "$1"; }

for deck in "$alvi" "$matrix" "$data"/me3491-ex*.deck "$data"/khurmi-*.deck "$data"/oscillating-cylinder.deck "$decks"/gas-engine.deck \
    "$decks"/pump.deck "$decks"/reach.deck; do
    for width in 80 120; do
        shows $width "$deck"
        fits $width
        check "rows of $deck" grep -Eq '^ *-?[0-9.]+ ' out
        holds 'at most five lines of head' '
            / theta2 / && ++n == 1 {exit bad} !/^#/ {bad = 1} NR > 5 {bad = 1}
            END {exit bad || !n}'
    done
done

sweep=$PWD/sweep.deck
{ cat "$matrix" && printf '[sweep]\ncrank.length = 18 mm, 20 mm\n'; } >"$sweep"
shows 80 -b open -i '60 deg' "$matrix"
blocks 3
holds 'kinematics, forces, torques' '
    /^# theta2/ {n++; names[n] = $0}
    END {exit !(names[1] ~ /theta3.*alpha4 +mu$/ && names[2] ~ /F12x.*F34x +F34y$/ &&
                names[3] ~ /F14x +F14y +Ts$/)}'
holds 'the crank angle in each' '/^ *60 / {n++} END {exit n != 3}'
holds 'the branch once' '/^# branch/ {n++} END {exit n != 1}'
shows 80 -b open -i '60 deg' "$sweep"
fits 80
check 'rows of a sweep' grep -Eq '^ *60 ' out
shows 120 -b open -i '60 deg' "$matrix"
blocks 2
holds 'what belongs together in one block, though some more of it would fit the first' '
    /^# theta2/ {n++; names[n] = $0} END {exit !(names[1] ~ /alpha4 +mu$/ && names[2] ~ /theta2 +F12x.*F14y +Ts$/)}'
shows 200 -b open -i '60 deg' "$matrix"
blocks 1
run 0 -b open -i '60 deg' "$matrix"
cp out piped
blocks 1
shows 200 -b open -i '60 deg' "$matrix"
same out piped
shows 80 --wide -b open -i '60 deg' "$matrix"
same out piped
shows 80 -w -b open -i '60 deg' "$matrix"
same out piped
usage '--wide takes no value' --wide=80 "$matrix"

# The blocks put side by side are the table of a pipe.
shows 80 -b open -i '60 deg' "$matrix"
awk '
    /^$/ {next}
    /^# theta2/ {n = 0; first = ++blocks == 1}
    !blocks {print; next}
    {n++; line[n] = first ? $0 : line[n] substr($0, 9)}
    END {for (i = 1; i <= n; i++) print line[i]}' out >joined
same joined piped

# The width of the terminal itself counts where COLUMNS does not.
sized() { script -qec "stty cols $1; '$fourlink' -b open -i '60 deg' '$matrix'" /dev/null </dev/null | tr -d '\r' >out; }
unset COLUMNS
sized 120
blocks 2
sized 300
blocks 1
for odd in 0 -5 wide 80x 99999999999999999999; do
    COLUMNS=$odd
    export COLUMNS
    sized 120
    blocks 2
done
unset COLUMNS
shows 80 -b open -i '60 deg' "$matrix"
cp out shown
shows '' -b open -i '60 deg' "$matrix" # the terminal of script has no size
same out shown

# The help, lists, summaries and comparisons are broken at blanks, and go on below their last column.
cp "$matrix" m.deck
for width in 60 80 100 120; do
    for option in --help --list --summary --check; do
        shows $width $option m.deck
        fits $width
        check "no blanks at the end of a line of $option" none ' $' out
    done
done
mkdir -p a-folder-of-a-class-with-a-long-name
cp "$matrix" a-folder-of-a-class-with-a-long-name/m.deck
shows 60 --check a-folder-of-a-class-with-a-long-name/m.deck
fits 60
shows 80 --list "$matrix"
holds 'meanings go on below themselves' '/^ /{n++; if (substr($0, 1, 28) ~ /[^ ]/ || substr($0, 29, 1) == " ") bad = 1} END {exit bad || n < 5}'
for option in --list --summary --check; do
    run 0 $option "$matrix"
    cp out whole
    shows 300 $option "$matrix"
    same out whole
    shows 60 --wide $option "$matrix"
    same out whole
done
run 0 --help
cp out eighty
shows 80 --help
same out eighty
shows 60 --help
holds 'a number and its unit stay together' "/'10\$/ {bad = 1} END {exit bad}"

# In a pipe or a file COLUMNS does not count.
COLUMNS=40
export COLUMNS
run 0 -b open -i '60 deg' "$matrix"
same out piped
unset COLUMNS
shows 40 -o written -b open -i '60 deg' "$matrix"
same written piped
for format in csv json; do
    run 0 -f $format "$matrix"
    tr -d '\r' <out >piped.$format
    shows 60 -f $format "$matrix"
    same out piped.$format
done

# The crank angle leads every block, wherever it was asked for; x and y stay together.
shows 50 -b open -i '90 deg' -c Ts,F12x,F12y,F23x,F23y,theta2,F34x,F34y,theta4 "$matrix"
blocks_fit 50
check 'it leads' test "$(grep -c '^# *theta2 ' out)" -eq "$(grep -c '^# *max ' out)"
holds 'pairs' '/^# *theta2/ {for (i = 2; i <= NF; i++) if ($i ~ /x$/ && $(i + 1) != substr($i, 1, 3) "y") bad = 1}
    END {exit bad}'
# Without it the labels of the extremes stand at the end, and fit too.
shows 60 -b open -i '90 deg' -c Ts,F12x,F12y,F23x,F23y,F34x,F34y,theta4 "$matrix"
blocks_fit 60
holds 'labels at the end' '/  at theta2$/ {n++} END {exit n < 4}'
# One column a block is as narrow as it gets.
shows 1 -b open -i '90 deg' -c theta2,theta4,mu "$matrix"
blocks 2

# What is not reached counts once.
shows 40 -b open "$decks/reach.deck"
holds 'its reason in each block' '/^# 120 to 240 deg: not reached/ {n++} /^# theta2/ {blocks++} END {exit n != blocks || n < 2}'
shows 40 -b open -i '60 deg' "$decks/gas-engine.deck" "$matrix"
holds 'both decks' '/^# deck: / {n++} END {exit n != 2}'
blocks_fit 40

# Colour: on a terminal alone, and not if NO_COLOR is set; files and pipes have it only if asked for.
unset NO_COLOR
escape=$(printf '\033')
TERM=xterm shows 80 -b open "$alvi"
check 'a heading in colour' grep -q "^$escape\[36m# crank 20 mm.*$escape\[0m\$" out
check 'an extreme in bold' grep -q "^$escape\[1m#    max .*$escape\[0m\$" out
check 'rows without colour' grep -q '^ *40 ' out
# of each line with a sign in front: the rows of extremes are bold, all else is a heading
for deck in "$alvi" "$matrix" "$decks/engine.deck"; do
    "$fourlink" --color=always "$deck" >out
    holds 'the colour of each line' '
        BEGIN {colour = "'"$escape"'\\["}
        {is_extreme = $0 ~ /# +(max|min|at) /}
        /^[^#]*#/ && $0 !~ (is_extreme ? "^" colour "1m" : "^" colour "36m") {print; bad = 1}
        is_extreme {n++}
        !/#/ && $0 ~ colour {print; bad = 1}
        END {exit bad || n < 8}'
done
TERM=xterm shows 80 -b open --color=never "$alvi"
check 'never' none "$escape" out
TERM=dumb shows 80 -b open "$alvi"
check 'a dumb terminal' none "$escape" out
TERM=xterm shows 80 -b open -f csv "$alvi"
check 'csv' none "$escape" out
NO_COLOR=1
export NO_COLOR
TERM=xterm shows 80 -b open "$alvi"
check 'NO_COLOR' none "$escape" out
run 0 --color=always -b open "$alvi"
check 'always' grep -q "^$escape\[36m# crank" out
run 2 --color=always -s crank.lenght=3 "$alvi"
check 'a mistake in red' grep -q "$escape\[1;31merror$escape\[0m: unknown key" err
TERM=xterm
export TERM
run 0 -b open "$alvi"
check 'a file' none "$escape" out
run 2 --color=blue "$alvi"
says "--color must be always or never, not 'blue'"
finish
