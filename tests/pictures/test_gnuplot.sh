#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_gnuplot.sh FOURLINK DATA - without gnuplot, with one that fails, and with one that repeats its script.
. "$(dirname "$0")/pictures.sh"

# broken WHAT PATH MESSAGE: exit status 3, no picture, no old picture touched
broken() {
    for old in yes no; do
        rm -rf pictures
        mkdir pictures
        [ $old = no ] || echo old >pictures/x.svg
        env PATH="$2" "$fourlink" --plot=pictures/x.svg "$fourbar" >out 2>err </dev/null
        check "$1: exit status $?" test $? -eq 3
        nothing
        says 'cannot draw pictures/x.svg'
        says "$3"
        if [ $old = yes ]; then
            check "$1: the old picture" test "$(cat pictures/x.svg)" = old
            only_file pictures x.svg
        else
            only_file pictures ''
        fi
    done
}
broken 'no gnuplot' /nonexistent gnuplot-nox
"$fourlink" "$fourbar" >table
"$(command -v env)" PATH=/nonexistent "$fourlink" --plot=x.svg --format=table "$fourbar" >out 2>err
check 'the table needs no gnuplot' test $? -eq 3
same out table
mkdir bin
broken 'no gnuplot in an empty folder' "$work/bin" gnuplot-nox
"$(command -v env)" PATH=/nonexistent "$fourlink" --plot-script=x.gp "$fourbar" >out 2>err
check 'a script needs no gnuplot' test $? -eq 0
quiet

fake() {
    printf '%s\n' '#!/bin/sh' "$@" >bin/gnuplot
    chmod +x bin/gnuplot
}
fake 'echo half of a picture' 'echo this is what went wrong >&2' 'exit 1'
broken 'gnuplot fails' "$work/bin" 'gnuplot failed'
says 'this is what went wrong'
fake 'echo half of a picture' 'kill -9 $$'
broken 'gnuplot is killed' "$work/bin" 'gnuplot failed'
fake 'exec 0<&-' 'exit 2'
broken 'gnuplot reads nothing' "$work/bin" 'gnuplot failed'
one_line() { check "$1: one line" test "$(wc -l <err)" -eq 1; }
fake 'for i in 1 2 3 4 5; do echo "gnuplot> x"; echo "line $i: invalid command"; done >&2' 'exit 1'
broken 'gnuplot says a lot' "$work/bin" 'gnuplot failed: line 1: invalid command'
one_line 'gnuplot says a lot'
fake 'echo "gnuplot: error while loading shared libraries: libgd.so.3" >&2' 'exit 127'
broken 'gnuplot lacks a library' "$work/bin" 'gnuplot failed: gnuplot: error while loading'
one_line 'gnuplot lacks a library'
chmod -x bin/gnuplot
broken 'gnuplot cannot be run' "$work/bin" 'gnuplot'

# What is written is what gnuplot says: a fake one that repeats its script.
fake 'cat'
rm -f x.svg x.gp
env PATH="$work/bin:$PATH" "$fourlink" --plot=x.svg "$fourbar" >out 2>err
check 'a fake gnuplot' test $? -eq 0
quiet
nothing
run 0 --plot-script=x.gp "$fourbar"
same x.svg x.gp
check 'the head of the script' grep -q '^# mechanism, made by fourlink [0-9.]* for gnuplot 5 or later$' x.gp

# GNUTERM does not count, because the script sets the terminal.
fake 'echo "terminal: $GNUTERM"'
env GNUTERM=xx PATH="$work/bin:$PATH" "$fourlink" --plot=x.svg "$fourbar" >out 2>err
check 'no GNUTERM' grep -qx 'terminal: ' x.svg

# gnuplot ends with the program, whatever signal ends that
fake 'echo $$ >gnuplot.pid' 'exec sleep 60'
is_gone() { # what init has not yet reaped is gone too
    for tenths in 1 2 3 4 5 6 7 8 9 10; do
        kill -0 "$1" 2>/dev/null || return 0
        [ "$(ps -o stat= -p "$1" 2>/dev/null | cut -c1)" = Z ] && return 0
        sleep 0.1 2>/dev/null || sleep 1
    done
    return 1
}
for signal in TERM HUP ALRM XCPU USR1 INT QUIT; do
    set -- "$fourlink"
    case $signal in
    INT | QUIT) # which a script's background ignores
        env --default-signal=$signal true 2>/dev/null || continue
        set -- env --default-signal=$signal "$fourlink"
        ;;
    esac
    for picture in pictures/x.svg -; do
        rm -rf pictures gnuplot.pid
        mkdir pictures
        (ulimit -c 0 && PATH=$work/bin:$PATH && exec "$@" --plot=$picture "$fourbar" >out 2>err </dev/null) &
        pid=$!
        for tenths in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
            [ -s gnuplot.pid ] && break
            sleep 0.1 2>/dev/null || sleep 1
        done
        check "$signal: gnuplot runs" test -s gnuplot.pid
        kill -$signal $pid
        wait $pid 2>/dev/null
        status=$?
        check "$signal: status $status" test "$(kill -l $status)" = $signal
        gnuplot=$(cat gnuplot.pid)
        check "$signal: gnuplot does not go on" is_gone "$gnuplot"
        kill "$gnuplot" 2>/dev/null
        only_file pictures ''
    done
done
rm bin/gnuplot

finish
