#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# failed_allocations.sh FOURLINK DATA SHIM [EVERY] - memory runs out: each allocation of many runs fails in turn
# (or every EVERY-th of fewer runs), alone, where there are old files, and with all after it, where there are none.  The run then ends
# as if nothing had happened, byte by byte, or with exit status 3, a message, and files that are old or complete.
# failing_malloc.c says what is right.  There is a run with each option of the program's table, and each question is put
# to machines of each kind, given and driven by motors.
# Prints what became of each run, and how much it tried.
#
# SHIM is failing_malloc.c as a shared library, or 'sanitizer': the program is then built here by $CC with
# AddressSanitizer, UBSan and failing_malloc.c in it.
. "$(dirname "$0")/sweeps.sh"
cd - >/dev/null || exit 1
shim=$3
EVERY=${4:-1}
AT_ONCE=${AT_ONCE:-$(nproc)}
export EVERY AT_ONCE
root=$(cd "$(dirname "$0")/../.." && pwd)
case $shim in /* | sanitizer) ;; *) shim=$PWD/$shim ;; esac
cd "$work" || exit 1
[ -d /proc/self/fd ] || { echo 'skipped: no /proc/self/fd' && exit 77; }

if [ "$shim" = sanitizer ]; then
    # GSL's own allocations are reached in its static library
    ${CC:-cc} -g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all -DWRAPPED \
        -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc -I"$root/include" -I"$root/src" \
        "$root"/src/*/*.c "$root/tests/command/failing_malloc.c" -l:libgsl.a -l:libgslcblas.a -lm -o wrapped || exit 1
    fourlink=$work/wrapped
    shim=
fi

# An rsvg-convert and a Chromium that take no time, and do not convert.
mkdir bin
printf '#!/bin/sh\nexec cat\n' >bin/rsvg-convert
printf '#!/bin/sh\nfor page; do :; done\nexec cat "$page"\n' >bin/chromium
chmod +x bin/rsvg-convert bin/chromium
PATH=$work/bin:$PATH

tries=0 refused=0 same=0 wrong=0 runs=0
began=$(date +%s)

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

input=/dev/null # of the program
WHOLE=0         # 1: for a program that waits for another
export WHOLE
begin() { :; } # what is in the folder at the start

# start ARGUMENT...: the program in FOLDER/run
start() {
    (cd run && exec "$fourlink" "$@" >out 2>err <"$input")
    status=$?
}

# try FAIL_ON USUAL ARGUMENT...: all trials, alone or with those after it; where there are old files, or none
try() {
    FAIL_ON=$1 USUAL=$2
    shift 2
    rm -rf run usual old report [0-9]
    mkdir run
    (cd run && begin)
    start "$@"
    check "exit status $status, expected $USUAL: fourlink $*: $(head -n 1 run/err)" test $status -eq "$USUAL" || return
    mv run usual
    mkdir old
    (cd old && begin)
    for file in usual/*; do
        case ${file##*/} in out | err) continue ;; esac
        [ "$FAIL_ON" -eq 1 ] || [ -h "old/${file##*/}" ] || echo old >"old/${file##*/}"
    done
    cp -R old run
    export FAIL_ON USUAL
    TRIALS=$work LD_PRELOAD=$shim
    export TRIALS LD_PRELOAD
    start "$@"
    unset TRIALS LD_PRELOAD
    last=
    while IFS= read -r line; do
        case $line in FAILED*) check "$line" false fourlink "$@" ;; *) last=$line ;; esac
    done <report
    check 'no report' test -n "$last" || return
    check "not as usual where nothing fails: exit status $status" same_folders "$@"
    # shellcheck disable=SC2086
    set -- $last
    tries=$((tries + $1)) refused=$((refused + $2)) same=$((same + $3)) wrong=$((wrong + $4))
    now_tried=$((now_tried + $1)) now_refused=$((now_refused + $2)) now_same=$((now_same + $3)) now_wrong=$((now_wrong + $4))
}

same_folders() {
    [ $status -eq "$USUAL" ] && for file in usual/*; do
        cmp -s "$file" "run/${file##*/}" || return 1
    done
}

# all STATUS ARGUMENT...: every allocation of this run, which usually ends so
all() {
    usual=$1
    shift
    note_options "$@"
    now_tried=0 now_refused=0 now_same=0 now_wrong=0
    try 0 "$usual" "$@" && try 1 "$usual" "$@"
    runs=$((runs + 1))
    printf '%5d failed: %5d refused, %5d as usual, %d wrong: %s\n' $now_tried $now_refused $now_same $now_wrong "$*"
}

# each ARGUMENT...: a question to a machine, which may refuse it; with EVERY each question to one of ten machines
each() {
    question=$((question + 1))
    [ "$EVERY" -eq 1 ] || [ $(((question + machine) % 10)) -eq 0 ] || return 0
    rm -rf run
    mkdir run
    start "$@"
    [ $status -ne 2 ] || unanswered=$((unanswered + 1))
    all $status "$@"
}

# Decks are one folder up from where the program works.
cp "$decks"/*.deck "$data"/alvi-5.1.* "$data/steam-engine-240.deck" "$data/me3491-example-1.deck" \
    "$data/watt-six-bar.deck" "$data/shaper-by-slot.deck" \
    "$data/slide-by-trapezoids.deck" "$data/steering-on-a-rack.deck" "$data/dump-body.deck" .
for deck in springs steady motor free lever; do cp "$decks/../fuzz/decks/$deck.deck" "$deck.deck"; done
sed 's/^indicator.*/indicator = file card.csv deg bar\nclearance = 8 %/' gas-engine.deck >card.deck
printf 'angle,pressure\n0,1\n20,30\n90,6\n540,1\n' >card.csv
sed "s/^duration.*/duration = 40 ms/" free.deck >time.deck # rows by time
sed '/^rows\|^duration\|^time_step/d; s|^speed.*|speed = 20 rad/s|' free.deck >turning.deck
sed 's/^cg = 0 mm//' single.deck >note.deck # point masses: notes
sed 's/^turns.*/to = 20 deg/' motor.deck >run-up.deck # with friction
cat >engine-up.deck <<END
mechanism = slider-crank
[crank]
length = 20 mm
mass = 1 kg
uniform = yes
[rod]
length = 60 mm
mass = 1 kg
uniform = yes
[piston]
mass = 1 kg
[load L]
link = crank
torque = -1 N m
[motor]
stall_torque = 50 N m
no_load_speed = 10 rad/s
[flywheel]
inertia = 0.1
[motion]
mode = run-up
to = 200 deg
interval = 30 deg
END
sed '/^\[motion/,$d' "$data/four-bar-on-a-ram.deck" >ram.deck # a program of the length of an actuator
printf '[motion]\ninput = ram.length\nprogram = 0 s 500 mm, 1 s 540 mm\nlaw = cycloidal\n[table]\nbranch = open\n' >>ram.deck
few='-s motion.interval=90deg'
mkdir alvi
cp alvi-5.1.expect alvi

all 0 -f csv -b open -o result ../time.deck
all 0 -f csv -b open -o result $few ../turning.deck
all 0 -f csv -b open -o result $few ../run-up.deck
all 0 -f csv -o result $few ../watt-six-bar.deck
all 0 --plot=x.svg $few ../watt-six-bar.deck
all 0 -f csv -S -o result $few ../shaper-by-slot.deck
all 0 --plot=x.svg $few ../shaper-by-slot.deck
all 0 -f csv -o result ../slide-by-trapezoids.deck
all 0 -S -o result ../ram.deck
all 0 -f csv -o result ../steering-on-a-rack.deck
all 0 -f csv -o result ../dump-body.deck
all 0 --check -o result ../slide-by-trapezoids.deck
all 0 --plot=x.svg ../slide-by-trapezoids.deck
for format in table csv json; do
    all 0 -f $format -o result $few ../single.deck
done
all 0 -f paper -o result $few ../alvi-5.1.deck
all 0 $few ../note.deck
all 0 --color=never -c all -o result $few -s 'crank.length = 21 mm' ../single.deck
all 0 -o result $few ../gas-engine.deck
all 0 -o result $few ../card.deck
all 1 -o result ../reach.deck
all 2 -o result ../mistakes.deck
all 0 --summary -o result ../card.deck
all 0 --plot=x.svg --plot-kind=columns -c pressure --plot-x=volume ../card.deck
all 0 --summary -f json -o result ../steam-engine-240.deck
all 0 --check -o result ../steam-engine-240.deck
all 0 --check=../alvi-5.1.expect -o result ../alvi-5.1.deck
all 0 --check=../alvi -o result ../alvi-5.1.deck
all 0 --expect --at='0 deg, 90 deg' -o result ../single.deck
all 0 --form --at='0 deg, 90 deg' -o result ../single.deck
all 0 --list -o result ../single.deck
all 0 --matrix -o result $few ../single.deck
input=$work/single.deck
all 0 $few
all 0 -f csv $few - ../single.deck
input=/dev/null
begin() { ln -s result link; }
all 0 -f csv -o link $few ../single.deck
check 'a link stays a link' test -h run/link
begin() { :; }

# grading: no score because memory failed, neither in a file nor printed
mkdir class answers
for student in anna ben carla; do
    cp alvi-5.1.deck class/$student.deck
    cp alvi-5.1.expect answers/$student.expect
done
sed -i 's/^length *= 66 mm/length = 67 mm/' class/ben.deck
cat alvi-5.1.deck alvi-5.1.expect >asks.deck
all 1 -f csv --check=../answers/ -o result ../class/anna.deck ../class/ben.deck ../class/carla.deck
all 1 --check=../answers/ ../class/anna.deck ../class/ben.deck ../class/carla.deck
all 0 --answers=../answers --scores -f csv -o result ../asks.deck
printf 'name,id,late\nanna,1,2\n' >names.csv
all 0 --answers=../answers --scores --names=../names.csv -f csv -o result ../asks.deck
all 0 --answers=../answers --feedback=./ -o result ../asks.deck
all 0 --answers=../answers --feedback=./ --format=html ../asks.deck
all 1 --answers=../answers --tolerance='1 %, 1 deg' -o result ../class/anna.deck
all 1 --check=../answers/ --exercise=../asks.deck --scores ../class/anna.deck ../class/ben.deck ../class/carla.deck
all 1 --check=../answers/ --exercise=../asks.deck --scores -f csv -o result ../class/anna.deck ../class/ben.deck ../class/carla.deck
all 1 --check=../answers/ --exercise=../asks.deck --feedback=./ ../class/anna.deck ../class/ben.deck ../class/carla.deck
{ cat asks.deck && printf '[grading]\ntolerance = 1 %%\n[sweep]\ncrank.length = 20 mm, 21 mm, 22 mm\n'; } >variants.deck
mkdir -p platform/'Anna Abel_1_assignsubmission_file'
cp answers/anna.expect 'platform/Anna Abel_1_assignsubmission_file/x.txt' && cp answers/anna.expect 'platform/Ben.txt' && cp answers/anna.expect 'platform/Bn.txt'
printf 'Surname,First name,design\nAbel,Anna,2\n,Ben,\n,Carla,3\n' >designs.csv
all 2 --answers=../platform --scores --names=../designs.csv -f csv -o result ../variants.deck
{ cat alvi-5.1.deck && printf '[sweep]\ncrank.length = 20 mm, 21 mm, 22 mm\n'; } >bare.deck
all 0 --design=all --names=../designs.csv --print-deck -o ./ ../bare.deck # forms that are there stay
all 0 --design=all --names=../designs.csv --plot=./ --plot-kind=exercise ../variants.deck
all 0 --quiz=quiz.xml ../variants.deck
echo 'crank = 20 mn' >>class/carla.deck
all 2 -f csv --check=../answers/ -o result ../class/carla.deck ../class/anna.deck

# many decks
all 0 -f csv -o result $few ../single.deck ../gas-engine.deck
all 0 $few ../single.deck ../gas-engine.deck
all 0 -f csv -c 'mu_min, max(omega4), crank.length' -o result ../alvi-5.1.deck ../single.deck
all 0 -f json -c 'mu_min, max(omega4), crank.length' -o result ../alvi-5.1.deck ../single.deck
all 0 -f csv -c 'omega4 at 30 deg mu at 1/3 rev' -o result ../alvi-5.1.deck ../single.deck
all 0 -S -o result ../single.deck ../slotted-lever.deck
all 3 -f csv -o result $few ../single.deck absent.deck

sweep 'crank.length = 20 mm, 300 mm, 22 mm' 'output = mu_min, max(Ts)'
all 1 -f csv -o result ../t.deck
all 1 -f json -o result ../t.deck
all 1 -o result ../t.deck
all 1 -f csv --part=2/3 -o result ../t.deck
all 1 -f csv -s 'sweep.yield=mu_min > 40 deg' -o result ../t.deck
all 1 --plot=plot.svg --plot-kind=columns -o result ../t.deck
all 1 -f csv -o result ../t.deck ../single.deck
sweep 'crank.length = 20 mm to 22 mm in 2' 'output = swing, Ts at 30 deg' # a range: GSL's simplex
all 0 -f csv -s 'sweep.yield=Ts at 40 deg > 0 N m' -o result ../t.deck
all 0 "--best=max swing" -o result ../t.deck
all 0 "--best=max theta4 at 30 deg" -o result ../t.deck
all 0 "--solve=crank.length = 10 mm .. 30 mm where swing = 40 deg" -o result ../alvi-5.1.deck
all 0 "--solve=crank.length = 10 mm .. 30 mm where swing = 40 deg" --print-deck -o result ../alvi-5.1.deck
all 0 -f csv "--best=max swing" -o result ../t.deck
all 2 -f jsonl "--best=max swing" -o result ../t.deck ../single.deck
all 0 -f csv "--solve=crank.length = 10 mm .. 30 mm where swing = 40 deg" -o result ../alvi-5.1.deck
all 0 -f jsonl --summary -o result ../single.deck
all 0 -f csv -c "mu_min, max(omega4), crank.length" -o result ../alvi-5.1.deck

for kind in mechanism exercise motion forces turning-moment polar vectors; do
    all 0 --plot=plot.svg --plot-kind=$kind -o result $few ../single.deck
done
all 0 --plot=plot.txt --ascii -o result $few ../single.deck
all 0 --plot=plot.svg --plot-kind=klein -o result $few ../steam-engine-240.deck
all 0 --plot=plot.svg --plot-kind=motion -o result -b open ../time.deck
for kind in mechanism limits; do
    all 0 --plot=plot.svg --plot-kind=$kind --plot-at='40 deg' -o result $few ../single.deck
done
all 0 --plot=plot.svg --plot-kind=columns --plot-x=theta4 -o result -b open $few ../single.deck
WHOLE=1
all 0 --plot=plot.png $few ../single.deck
all 0 --report=report.pdf $few ../single.deck
WHOLE=0

# a text in UTF-16; a value that is sought on the other branch too, whose motion is found then
{ printf '\377\376' && iconv -f UTF-8 -t UTF-16LE single.deck; } >wide.deck
all 0 --report=report.html $few ../wide.deck
{ cat engine-up.deck && printf '[expect]\nat = 60 deg\nomega2 = 1.234 rad/s\n'; } >other.deck
all 1 -b open --check ../other.deck
all 0 -b open --form ../other.deck

# options that the runs above do not have
all 0 --units='mm, kg, rpm' --wide --columns=theta2,B.x --branch=open --interval='90 deg' --output=result \
    --set='crank.length = 21 mm' --format=table ../single.deck
mkdir sub
cp card.csv sub
sed 's,card.csv,sub/../card.csv,' card.deck >elsewhere.deck
all 0 --allow-files -o result $few ../elsewhere.deck
all 1 --check=../alvi-5.1.expect --scores --tolerance='1 %' -o result ../alvi-5.1.deck
all 0 --at='30 deg, theta4 = 120 deg' -o result -b open ../single.deck
all 0 --list -f json --output=result
echo 'j=A,1,2,AB,R,t,0,0.1,t,%0AB,-3,5,AB|BC,R,f,0,0.1,f,%0AC,-11,17,BC|CD,R,f,0,0.1,f,%0AD,1,22,CD,R,t,0,0.1,f,&f=&s=10,false,false,cm' >link.txt
all 0 --import=../link.txt -o result
all 2 ../link.txt
all 0 --help
all 0 --version

# synthesis: each task; one solution, all, a report, a check
mkdir task
cp "$data"/synthesis/*.deck "$data"/synthesis/*.expect task
for task in osu-lecture-12 three-positions khurmi-5.3 power-nine quadratic-slider best-return norton-3-2; do
    "$fourlink" --synthesis task/$task.deck >/dev/null 2>&1
    all $? --synthesis -o result ../task/$task.deck
    all $? --synthesis --summary -o result ../task/$task.deck
done
printf 'mechanism = four-bar\n[synthesis]\ntask = path\npositions = (0, 0) mm, (60, 25) mm, (105, 80) mm\n' >task/many.deck
all 0 --synthesis --effort=1 -o result ../task/many.deck
all 0 --synthesis --solution=1 -o result ../task/three-positions.deck
all 0 --synthesis -f csv -o result ../task/three-positions.deck
all 0 --synthesis --check=../task/osu-lecture-12.expect -o result ../task/osu-lecture-12.deck
all 0 --synthesis --report=report.html ../task/khurmi-5.3.deck

# designs of a sweep as decks, as answers
sweep 'crank.length = 18 mm, 20 mm, 22 mm' 'output = mu_min, max(Ts)'
all 0 --design=2 -f csv -o result $few ../t.deck
all 0 --design=2 --print-deck -o result ../t.deck
printf 'Anna\nBen\n' >class.txt
all 0 --design=all --print-deck --output=./ --names=../class.txt ../t.deck
all 0 --design=all --expect --output=./ -b open $few ../t.deck
all 0 --design=all --report=./ -b open $few ../t.deck

all 0 --report=report.html -o result $few ../single.deck
all 2 --report=report.html -o result ../mistakes.deck

# every question to every sort of machine
unanswered=0 machine=0
for deck in single gas-engine rubbing-yoke slotted-lever springs card steady engine-up turning time; do
    machine=$((machine + 1)) question=0
    "$fourlink" --expect $few $deck.deck >$deck.answers 2>/dev/null
    sed 's/\([0-9]\)\.\([0-9]\)/\1.9\2/' $deck.answers >$deck.wrong # some of them right
    for format in table csv json paper; do
        each -f $format $few -o result ../$deck.deck
    done
    each -c all -w $few ../$deck.deck
    each -S -o result ../$deck.deck
    each -S -f csv -o result ../$deck.deck
    each -S -f json -o result ../$deck.deck
    each -m -f csv $few ../$deck.deck
    each -l -f json -o result ../$deck.deck
    each --expect $few -o result ../$deck.deck
    each --form $few -o result ../$deck.deck
    each --at='50 deg' -f json -o result ../$deck.deck
    each --check=../$deck.answers -f csv -o result ../$deck.deck
    each --check=../$deck.wrong -f json -o result ../$deck.deck
    each --check=../$deck.wrong --scores ../$deck.deck
    each -f csv -c 'max(theta4), min(omega4), mean(omega2), rms(Ts)' -o result ../$deck.deck
    each --print-deck -s 'crank.length = 101 %' ../$deck.deck
    each --print-deck -o result ../$deck.deck
    each --print-deck --pins -o result ../$deck.deck
    for kind in mechanism motion forces turning-moment polar vectors limits klein animation speed columns; do
        each --plot=plot.svg --plot-kind=$kind $few ../$deck.deck
    done
    each --plot=- --plot-kind=mechanism --plot-at='50 deg' ../$deck.deck
    each --report=report.html $few ../$deck.deck
    mkdir -p $deck
    cp $deck.answers $deck/anna.expect
    cp $deck.wrong $deck/ben.expect
    cat $deck.deck $deck.answers >$deck-asks.deck
    each --answers=../$deck --scores -f csv -o result ../$deck-asks.deck
    each --answers=../$deck --feedback=./ ../$deck-asks.deck
    { cat $deck.deck && printf '\n[sweep]\ncrank.mass = 0.1 kg, 0.2 kg\noutput = max(Ts), mean(Ts)\nyield = max(Ts) > 0 N m\n'; } >$deck-sweep.deck
    each -f csv -o result ../$deck-sweep.deck
    each --plot=plot.svg --plot-kind=columns ../$deck-sweep.deck
    each --design=2 --print-deck ../$deck-sweep.deck
    each '--best=min max(Ts)' -o result ../$deck-sweep.deck
    case $deck in steady | engine-up | turning | time) continue ;; esac # some minutes
    each '--solve=crank.mass = 1 g .. 2 kg where max(Ts) = 1 N m' --print-deck ../$deck.deck
done

sort -u tried >by_name
while read -r letter name; do
    check "no run with ${name:-$letter}" grep -qxF -e "${name:-$letter}" by_name
done <options

echo "$runs runs; $tries allocations failed: $refused runs ended with exit status 3, $same as usual, $wrong wrong;" \
    "$(($(date +%s) - began)) s"
echo "$unanswered of the runs are usually refused"
finish
