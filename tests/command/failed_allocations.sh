#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# failed_allocations.sh FOURLINK DATA SHIM [EVERY] - memory runs out: each allocation of many runs fails in turn
# (or every EVERY-th), alone and with all after it.  The run then ends as if nothing had happened, or with exit
# status 3, a message, and files that are old or complete.  There is a run with each option of the program's table.
# Prints what became of each run, and how much it tried.
#
# SHIM is failing_malloc.c as a shared library, or 'sanitizer': the program is then built here by $CC with
# AddressSanitizer, UBSan and failing_malloc.c in it.
. "$(dirname "$0")/sweeps.sh"
cd - >/dev/null || exit 1
shim=$3
every=${4:-1}
root=$(cd "$(dirname "$0")/../.." && pwd)
case $shim in /* | sanitizer) ;; *) shim=$PWD/$shim ;; esac
cd "$work" || exit 1

if [ "$shim" = sanitizer ]; then
    # GSL's own allocations are reached in its static library
    ${CC:-cc} -g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all -DWRAPPED \
        -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc -I"$root/include" -I"$root/src" \
        "$root"/src/*/*.c "$root/tests/command/failing_malloc.c" -l:libgsl.a -l:libgslcblas.a -lm -o wrapped || exit 1
    fourlink=$work/wrapped
    shim=
fi

mkdir files usual
most=600 # of a run; then a search repeats itself
tries=0
refused=0
picture=plot.svg # what is written beside files/result

# start ARGUMENT...: the program with the shim, where there are old files
start() {
    echo old >files/result
    echo old >"files/$picture"
    LD_PRELOAD=$shim "$fourlink" "$@" >out 2>err </dev/null
    status=$?
}

# first_line FILE, last_line FILE: that line is in $line
first_line() { IFS= read -r line <"$1" || line=; }

last_line() {
    line=
    while IFS= read -r next; do line=$next; done <"$1"
}

is_old_or_complete() {
    first_line "files/$1"
    [ "$line" = old ] || cmp -s "files/$1" "usual/$1" ||
        { [ -f usual/alone ] && cmp -s "files/$1" usual/alone; }
}

only_two_files() {
    set -- files/* files/.[!.]*
    [ "$*" = "files/$picture files/result files/.[!.]*" ]
}

is_refused() {
    last_line err
    case $line in fourlink:*) ;; *) return 1 ;; esac
    [ $status -eq 3 ] && only_two_files && is_old_or_complete result &&
        is_old_or_complete "$picture" && none '^# bad deck' out
}

is_as_usual() {
    [ $status -eq $usual ] && cmp -s err usual/err && cmp -s out usual/out && only_two_files &&
        cmp -s files/result usual/result && cmp -s "files/$picture" "usual/$picture"
}

# The options of the program's table: -x --name in a line each.
"$fourlink" --help | sed -n 's/^ *\(-[a-zA-Z]\)*,* *--\([a-z-]*\).*/\1 --\2/p' | sort -u >options
check "options: $(wc -l <options)" test "$(wc -l <options)" -gt 30
: >tried

# note_options ARGUMENT...: options that are tried, each by its long name
note_options() {
    for argument; do
        case $argument in
        --*) echo "${argument%%=*}" ;;
        -?*) sed -n "s/^$(echo "$argument" | cut -c1-2) //p" options ;;
        esac
    done >>tried
}

# report ARGUMENT...: a line of the table
report() {
    printf '%5d failed: %5d refused, %5d as usual, %d wrong: %s\n' $((tries - tries_before)) $((refused - refused_before)) \
        $((tries - tries_before - refused + refused_before - failed + failed_before)) $((failed - failed_before)) "$*"
}

# all STATUS ARGUMENT...: every allocation of this run, which usually ends so
all() {
    usual=$1
    shift
    note_options "$@"
    tries_before=$tries refused_before=$refused failed_before=$failed
    unset FAIL_AT FAIL_ON
    COUNT_FILE=$work/count
    export COUNT_FILE
    start "$@"
    unset COUNT_FILE
    cp out err files/* usual
    first_line count
    n=$line
    check "exit status $status, expected $usual, $n allocations: fourlink $*: $(head -n 1 err)" \
        test $status -eq "$usual" -a "$n" -gt 3
    [ "$n" -le $most ] || n=$most
    for FAIL_ON in 0 1; do
        export FAIL_ON
        FAIL_AT=1
        export FAIL_AT
        while [ "$FAIL_AT" -le "$n" ]; do
            start "$@"
            tries=$((tries + 1))
            if is_refused; then
                refused=$((refused + 1))
            elif ! is_as_usual; then
                check "allocation $FAIL_AT of $n (FAIL_ON=$FAIL_ON): exit status $status, usually $usual; files: $(ls -A files); $(head -n 3 err)" \
                    false fourlink "$@"
                rm -f files/* files/.[!.]*
            fi
            FAIL_AT=$((FAIL_AT + every))
        done
    done
    unset FAIL_AT FAIL_ON
    rm -f usual/alone
    report "$*"
}

# all_designs ENDING ARGUMENT...: the same of a run that writes a file for each design into folder/
all_designs() {
    ending=$1
    shift
    note_options "$@"
    tries_before=$tries refused_before=$refused failed_before=$failed
    rm -rf folder complete
    mkdir folder
    COUNT_FILE=$work/count
    export COUNT_FILE
    "$fourlink" "$@" >out 2>err </dev/null
    status=$?
    unset COUNT_FILE
    check "exit status $status: fourlink $*: $(head -n 1 err)" test $status -eq 0
    cp -r folder complete
    first_line count
    n=$line
    for FAIL_ON in 0 1; do
        FAIL_AT=1
        export FAIL_ON FAIL_AT
        while [ "$FAIL_AT" -le "$n" ]; do
            for file in complete/*; do echo old >"folder/${file#*/}"; done
            LD_PRELOAD=$shim "$fourlink" "$@" >out 2>err </dev/null
            status=$?
            tries=$((tries + 1))
            refused=$((refused + (status == 3)))
            for file in folder/* folder/.[!.]*; do
                [ "$file" = 'folder/.[!.]*' ] && continue
                first_line "$file"
                { [ "$line" = old ] && [ $status -eq 3 ]; } || cmp -s "$file" "complete/${file#*/}" ||
                    check "allocation $FAIL_AT of $n (FAIL_ON=$FAIL_ON): exit status $status, $file: $line; $(head -n 1 err)" \
                        false fourlink "$@"
            done
            check "allocation $FAIL_AT: $(ls folder | tr '\n' ' ')" test "$(ls -A folder)" = "$(ls -A complete)"
            [ $status -eq 0 ] || [ $status -eq 3 ] || check "exit status $status at allocation $FAIL_AT" false "$@"
            FAIL_AT=$((FAIL_AT + every))
        done
    done
    unset FAIL_AT FAIL_ON
    report "$*"
}

cp "$decks"/*.deck "$data"/alvi-5.1.* "$data/steam-engine-240.deck" "$data/me3491-example-1.deck" .
sed 's/^indicator.*/indicator = file card.csv deg bar/' gas-engine.deck >card.deck
printf 'angle,pressure\n0,1\n20,30\n90,6\n540,1\n' >card.csv
sed "s/^duration.*/duration = 40 ms/" "$decks/../fuzz/decks/free.deck" >time.deck # rows by time
sed 's/^cg = 0 mm//' single.deck >note.deck # point masses: notes
few='-i 90deg'

# each allocation of an integrated motion: without it the crank would turn as if its motion were given
other=$every every=1
sed '/^rows\|^duration\|^time_step/d; s|^speed.*|speed = 20 rad/s|' time.deck >free.deck
all 0 -f csv -b open -o files/result time.deck
all 0 -f csv -b open -o files/result $few free.deck
every=$other

for format in table csv json; do
    all 0 -f $format -o files/result $few single.deck
done
all 0 -f paper -o files/result $few alvi-5.1.deck
all 0 $few note.deck
all 0 --color=never -c all -o files/result $few -s 'crank.length = 21 mm' single.deck
all 0 -o files/result $few gas-engine.deck
all 0 -o files/result $few card.deck
all 1 -o files/result reach.deck
all 2 -o files/result mistakes.deck
all 0 --summary -o files/result card.deck
all 0 --summary -f json -o files/result steam-engine-240.deck
all 0 --check -o files/result steam-engine-240.deck
all 0 --check=alvi-5.1.expect -o files/result alvi-5.1.deck
all 0 --check=. -o files/result alvi-5.1.deck
# grading: no score because memory failed, neither in a file nor printed
mkdir class answers
for student in anna ben carla; do
    cp alvi-5.1.deck class/$student.deck
    cp alvi-5.1.expect answers/$student.expect
done
sed -i 's/^length *= 66 mm/length = 67 mm/' class/ben.deck
all 1 -f csv --check=answers/ -o files/result class/anna.deck class/ben.deck class/carla.deck
all 1 --check=answers/ class/anna.deck class/ben.deck class/carla.deck
all 1 --answers=answers --scores -f csv -o files/result class/anna.deck
mkdir feedback
printf 'name,id,late\nanna,1,2\n' >names.csv
all 1 --answers=answers --scores --names=names.csv -f csv -o files/result class/anna.deck
all 1 --answers=answers --feedback=feedback/ -o files/result class/anna.deck
all 1 --answers=answers --tolerance='1 %, 1 deg' -o files/result class/anna.deck
echo 'crank = 20 mn' >>class/carla.deck
all 2 -f csv --check=answers/ -o files/result class/carla.deck class/anna.deck
all 0 --expect --at='0 deg, 90 deg' -o files/result single.deck
all 0 --form --at='0 deg, 90 deg' -o files/result single.deck
all 0 --list -o files/result single.deck
all 0 --matrix -o files/result $few single.deck
ln -s files/result link
all 0 -f csv -o link $few single.deck
check 'a link stays a link' test -h link

# the other deck is written
"$fourlink" -f csv -o alone.csv $few single.deck absent.deck 2>err
cp alone.csv usual/alone
all 0 -f csv -o files/result $few single.deck single.deck

sweep 'crank.length = 20 mm, 300 mm, 22 mm' 'output = mu_min, max(Ts)'
all 1 -f csv -o files/result t.deck
all 1 -f json -o files/result t.deck
all 1 -o files/result t.deck
all 1 -f csv --part=2/3 -o files/result t.deck
all 1 -f csv -s 'sweep.yield=mu_min > 40 deg' -o files/result t.deck
all 1 --plot=files/plot.svg --plot-kind=columns -o files/result t.deck
sweep 'crank.length = 20 mm to 22 mm in 2' 'output = swing' # a range: GSL's simplex
all 0 "--best=max swing" -o files/result t.deck
all 0 "--solve=crank.length = 10 mm .. 30 mm where swing = 40 deg" -o files/result alvi-5.1.deck
all 0 -f csv -c "mu_min, max(omega4), crank.length" -o files/result alvi-5.1.deck

for kind in mechanism motion forces turning-moment polar vectors; do
    all 0 --plot=files/plot.svg --plot-kind=$kind -o files/result $few single.deck
done
picture=plot.txt
rm files/plot.svg
all 0 --plot=files/plot.txt --ascii -o files/result $few single.deck
picture=plot.svg
rm files/plot.txt
all 0 --plot=files/plot.svg --plot-kind=klein -o files/result $few steam-engine-240.deck
all 0 --plot=files/plot.svg --plot-kind=turning-moment -o files/result $few gas-engine.deck
all 0 --plot=files/plot.svg --plot-kind=motion -o files/result -b open time.deck

for kind in mechanism limits; do
    all 0 --plot=files/plot.svg --plot-kind=$kind --plot-at='40 deg' -o files/result $few single.deck
done
all 0 --plot=files/plot.svg --plot-kind=columns --plot-x=theta4 -o files/result -b open $few single.deck

# options that the runs above do not have
all 0 --units='mm, kg, rpm' --wide --columns=theta2,B.x --branch=open --interval='90 deg' --output=files/result \
    --set='crank.length = 21 mm' --format=table single.deck
mkdir sub
cp card.csv sub
sed 's,card.csv,sub/../card.csv,' card.deck >elsewhere.deck
all 0 --allow-files -o files/result $few elsewhere.deck
all 1 --check=alvi-5.1.expect --scores --tolerance='1 %' -o files/result alvi-5.1.deck
all 0 --at='30 deg, theta4 = 120 deg' -o files/result -b open single.deck
all 0 --list -f json --output=files/result
all 0 --help
all 0 --version

# synthesis: each task; one solution, all, a report, a check
cp "$data"/synthesis/*.deck "$data"/synthesis/*.expect .
for task in osu-lecture-12 three-positions khurmi-5.3 power-nine quadratic-slider best-return norton-3-2; do
    "$fourlink" --synthesis $task.deck >/dev/null 2>&1
    all $? --synthesis -o files/result $task.deck
done
all 0 --synthesis --solution=1 -f csv -o files/result three-positions.deck
all 0 --synthesis -f csv -o files/result three-positions.deck
all 0 --synthesis --check=osu-lecture-12.expect -o files/result osu-lecture-12.deck

# designs of a sweep as decks, as answers
sweep 'crank.length = 18 mm, 20 mm, 22 mm' 'output = mu_min, max(Ts)'
all 0 --design=2 -f csv -o files/result $few t.deck
all 0 --design=2 --print-deck -o files/result t.deck
printf 'Anna\nBen\n' >class.txt
all_designs .deck --design=all --print-deck --output=folder/ --names=class.txt t.deck
all_designs .expect --design=all --expect --output=folder/ -b open $few t.deck
all_designs .html --design=all --report=folder/ -b open $few t.deck

rm files/plot.svg
picture=report.html
all 0 --synthesis --report=files/report.html -o files/result khurmi-5.3.deck
all 0 --report=files/report.html -o files/result $few single.deck
all 0 --report=files/report.html -o files/result -b open time.deck
all 2 --report=files/report.html -o files/result mistakes.deck

sort -u tried >by_name
while read -r letter name; do
    check "no run with ${name:-$letter}" grep -qxF -e "${name:-$letter}" by_name
done <options

echo "$tries allocations failed: $refused runs ended with exit status 3, $((tries - refused - failed)) as usual"
finish
