#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_output.sh FOURLINK DATA - --output: files, links, devices and pipes, and what a failure leaves.
. "$(dirname "$0")/../harness.sh"

cp "$decks/reach.deck" "$decks/bad.deck" .
"$fourlink" "$alvi" >table
"$fourlink" -f csv "$alvi" >csv

mkdir o
run 0 -o o/x "$alvi"
quiet
nothing
same o/x table
only_file o x
check 'the mode of a new file' test "$(ls -l o/x | cut -c1-10)" = -rw-r--r--
for form in '-oo/x' '--output=o/x' '--output o/x'; do
    rm o/x
    run 0 $form "$alvi"
    same o/x table
done
(umask 077 && "$fourlink" -o o/private "$alvi")
check 'the mode of a new file follows the umask' test "$(ls -l o/private | cut -c1-10)" = -rw-------
rm o/private

echo old >o/x
chmod 640 o/x
run 0 --output=o/x --format=csv "$alvi"
same o/x csv
check 'permissions are kept' test "$(ls -l o/x | cut -c1-10)" = -rw-r-----

# a failure leaves the old file, and none beside it
echo old >o/x
cp o/x old
run 2 -o o/x bad.deck
same o/x old
run 3 -o o/x missing.deck
same o/x old
usage '--format' -o o/x -f xml "$alvi"
same o/x old
(
    trap '' XFSZ
    ulimit -f 8
    exec "$fourlink" -o o/x -i 0.1 "$alvi" 2>>err
)
check 'a file that cannot grow' test $? -eq 3
same o/x old
only_file o x
# the file of a new name is not there at all
(
    trap '' XFSZ
    ulimit -f 8
    exec "$fourlink" -o o/new -i 0.1 "$alvi" 2>>err
)
check 'a new file that cannot grow' test $? -eq 3
only_file o x
"$fourlink" -o o/x -i 0.00004 "$alvi" 2>err &
pid=$!
sleep 0.3 2>/dev/null || sleep 1
kill $pid
wait $pid 2>/dev/null
same o/x old
only_file o x # also after a signal
rm -f o/x.*

# nor does any other signal that ends the program; what runs in the background ignores SIGQUIT
for signal in HUP QUIT ALRM XCPU USR1 USR2 VTALRM PROF; do
    set -- "$fourlink"
    if [ $signal = QUIT ]; then
        env --default-signal=QUIT true 2>/dev/null || continue
        set -- env --default-signal=QUIT "$fourlink"
    fi
    (ulimit -c 0 && exec "$@" -o o/x -i 0.00004 "$alvi" 2>err) &
    pid=$!
    for tenths in 1 2 3 4 5 6 7 8 9 10; do
        [ "$(ls -A o | wc -l)" -eq 2 ] && break
        sleep 0.1 2>/dev/null || sleep 1
    done
    check "$signal: a temporary file while it runs" test "$(ls -A o | wc -l)" -eq 2
    kill -$signal $pid
    wait $pid 2>/dev/null
    status=$?
    check "$signal: status $status" test "$(kill -l $status)" = $signal
    only_file o x
    same o/x old
done

# a name may be as long as the file system allows
longest=$(printf '%0255d' 0)
if : >"o/$longest" 2>/dev/null; then
    run 0 -o "o/$longest" "$alvi"
    same "o/$longest" table
    run 0 -f csv -o "o/$longest" "$alvi"
    same "o/$longest" csv
    rm "o/$longest"
    run 3 -o "o/0$longest" "$alvi"
    says 'name too long' # File name, or Filename
fi
only_file o x

# rows that could not be computed are results like others
run 1 -o o/x reach.deck
check 'rows that fail are written' grep -q '^# 120 to 240 deg: ' o/x
# and so are the good decks beside a bad one
run 2 -o o/x "$alvi" bad.deck
check 'good decks are written' grep -q '38.9863' o/x

run 3 -o nowhere/x "$alvi"
says 'nowhere/x'
says 'No such file'
run 3 -o o "$alvi"
says 'Is a directory'
run 3 -o '' "$alvi"
only_file o x
check 'no temporary file here' test -z "$(ls -A | grep '^\.[A-Za-z0-9]')"
if [ "$(id -u)" -ne 0 ]; then
    mkdir locked
    echo old >locked/x
    chmod 444 locked/x
    run 3 -o locked/x "$alvi"
    says 'locked/x'
    same locked/x old
    chmod 644 locked/x
    chmod 555 locked
    run 3 -o locked/y "$alvi"
    says 'locked/y'
    only_file locked x
fi

# symbolic links are followed
mkdir links
echo old >links/target
ln -s target links/link
run 0 -o links/link "$alvi"
check 'a link stays a link' test -h links/link
same links/target table
ln -s absent links/dangling
run 0 -o links/dangling "$alvi"
check 'a link to nothing stays a link' test -h links/dangling
check 'the file it leads to is made' test -f links/absent
ln -s loop links/loop
run 3 -o links/loop "$alvi"
check 'a link to itself stays' test -h links/loop

# devices and pipes are written directly
mkfifo pipe
cat pipe >from_pipe &
run 0 -o pipe "$alvi"
wait $!
same from_pipe table
check 'a pipe stays a pipe' test -p pipe
# Not with the machine's own devices where a mistake of the program could replace them.
if [ ! -w /dev ]; then
    run 0 -o /dev/null "$alvi"
    nothing
    run 3 -o /dev/full "$alvi"
    says '/dev/full'
    says 'No space left on device'
    if [ -L /dev/stdout ]; then # some machines have a file there
        "$fourlink" -o /dev/stdout "$alvi" | cat >out
        same out table
    fi
fi
if [ -e /dev/fd/1 ]; then
    mkdir own
    ln -s /dev/fd/1 own/stdout # as /dev/stdout is
    "$fourlink" -o own/stdout "$alvi" | cat >out
    same out table
    {
        echo before
        "$fourlink" -o own/stdout "$alvi"
        echo after
    } >out 2>err
    {
        echo before
        cat table
        echo after
    } >expected
    same out expected
    check 'standard output is still a link' test -h own/stdout
    # the file that standard output is may have been deleted
    (rm deleted && exec "$fourlink" -o own/stdout "$alvi") >deleted 2>err
    check 'standard output, deleted, is still a link' test -h own/stdout
    only_file own stdout
fi

# a deck is not overwritten
cp "$alvi" mine.deck
ln -s mine.deck alias.deck
ln mine.deck hard.deck
for name in mine.deck ./mine.deck alias.deck hard.deck; do
    run 3 -o $name mine.deck
    says "$name"
    same mine.deck "$alvi"
done
run 3 -o mine.deck "$alvi" alias.deck
same mine.deck "$alvi"
"$fourlink" -o mine.deck <mine.deck >out 2>err
check 'the deck on standard input is not overwritten' test $? -eq 3
same mine.deck "$alvi"

# two outputs are one file, also through links to nothing
mkdir twice
ln -s a.svg twice/b.svg
ln -s b.svg twice/c.svg
ln -s twice folder
for pair in 'twice/a.svg twice/a.svg' 'twice/a.svg twice/b.svg' 'twice/b.svg twice/a.svg' \
    'twice/c.svg twice/b.svg' 'folder/c.svg ./twice/../twice/a.svg'; do
    for option in --plot; do
        run 3 -o ${pair% *} $option=${pair#* } "$alvi"
        says 'two outputs have this name'
        check 'no output' test ! -e twice/a.svg
        check 'the links stay' test -h twice/b.svg -a -h twice/c.svg
    done
done

# nor is anything else that is read: answers, a card, whatever the option and the way to it
sed 's/^indicator.*/indicator = file card.csv deg bar/' "$decks/gas-engine.deck" >card.deck
printf '0 1\n20 30\n90 6\n540 1\n' >card.csv
mkdir answers
printf '[expect]\nat = 0 deg\nmu = 59.4 deg\n' >answers/mine.expect
for file in card.csv answers/mine.expect; do
    rm -rf alias.svg hard.svg keep
    ln -s $file alias.svg
    ln $file hard.svg
    cp $file keep
    for output in $file alias.svg hard.svg; do
        for option in -o; do
            case $file in
            card.csv) run 3 $option$output card.deck ;;
            *)
                run 3 $option$output --check=$file mine.deck
                says 'it is also read'
                run 3 $option$output --check=answers mine.deck
                ;;
            esac
            says 'it is also read'
            nothing
            same $file keep
        done
    done
done

finish
