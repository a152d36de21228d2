#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_names.sh FOURLINK DATA - names of files, titles, names of loads: shown as they are, never
# executed.
. "$(dirname "$0")/pictures.sh"

needs_gnuplot
newline='
'

# Each name is that of the deck, of the picture, of the script; nothing of it is executed.
mkdir names
for name in 'a b' "it's" "''" 'q"q' 'x$(touch pwned)' '`touch pwned`' '|touch pwned' '|touch pwned;' '| touch pwned #' \
    'x;touch pwned;x' '!touch pwned' '-x' '--' '100%s%d%n' 'a\nb\' '~x' '~' 'x'"'"'; system("touch pwned"); y='"'"'' \
    '<touch pwned' '@x' '#x' '$x' 'θ' 'a&b<c>' "two${newline}system('touch pwned')${newline}!touch pwned${newline}lines"; do
    cp "$alvi" "names/$name.deck"
    cd names || exit 1
    show=$(printf "%s" "$name" | tr '\n' ' ')
    "$fourlink" --plot-kind=vectors --plot="$name.svg" -- "$name.deck" >../out 2>../err
    status=$?
    case $name in
    *"$newline"*) # may be refused
        check "executed: $show" test ! -e pwned
        [ $status -eq 0 ] && svg "$name.svg"
        rm -f "$name.svg"
        "$fourlink" --plot-kind=vectors --plot="$name.svg" --plot-script=x.gp "$alvi" >../out 2>../err &&
            a_gnuplot - <x.gp >../drawn 2>../said
        check "executed by the script: $show" test ! -e pwned
        ;;
    *)
        check "exit status $status: $show" test $status -eq 0
        cd .. && quiet && cd names || exit 1
        check "not the files of $show: $(ls -A)" test "$(ls -A | wc -l)" -eq 2
        svg "./$name.svg"
        shows "./$name.svg" "$name.deck  |  fourlink $version"
        mv "./$name.svg" ../before.svg
        "$fourlink" --plot-kind=vectors --plot="$name.svg" --plot-script="$name.gp" -- "$name.deck" >../out 2>../err
        check "script: exit status $?: $show" test $? -eq 0
        a_gnuplot - <"./$name.gp" >../drawn 2>../said
        check "gnuplot: exit status $?: $show" test $? -eq 0
        check "gnuplot on $show: $(head -n 2 ../said)" test ! -s ../said
        check "executed by the script: $show" test ! -e pwned
        check "the script of $show has written: $(ls -A)" test "$(ls -A | wc -l)" -eq 3
        same_drawing "./$name.svg" ../before.svg
        ;;
    esac
    cd .. || exit 1
    check "executed: $show" test -z "$(find . -name 'pwned*')"
    rm -rf names
    mkdir names
done

# titles and names of loads and points as they are
titles='plain title
'"it's"' a "title"
back\slash\n \
_^{}@&~ a_1 b^2
<b>&amp;</b> & <!-- >
100 % %s %d %n
$(touch pwned) `touch pwned`
x; system("touch pwned") y
Zähne, θ₂, 四杆, ½
'"'"' . system("touch pwned") . '"'"'
!touch pwned
{/Symbol q} @x'
printf "%s\n" "$titles" >titles
while IFS= read -r title; do
    sed '/^title/d' "$alvi" >body
    { printf 'title = %s\n' "$title" && cat body; } >t.deck
    run 0 --plot=x.svg --plot-kind=vectors t.deck
    quiet
    svg x.svg
    shows x.svg "$title"
done <titles
check 'executed by a title' test ! -e pwned
for name in "o'clock" 'a"b' '<F&G>' '%s%n' 'a\' '`touch-pwned`' '_^{}@' 'θ'; do
    sed "s/^\[load push\]/[load $(printf '%s' "$name" | sed 's/[\\&]/\\&/g')]/" "$fourbar" >t.deck
    run 0 --plot=x.svg t.deck
    quiet
    svg x.svg
    shows x.svg "$name" "$name = 12 N"
done
long_title >long.deck
run 0 --plot=x.svg long.deck
svg x.svg
sed '/^title/d' "$alvi" >untitled.deck
run 0 --plot=x.svg untitled.deck
shows x.svg 'untitled.deck' "untitled.deck  |  fourlink $version"

finish
