#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_sweep.sh FOURLINK DATA - [sweep] and --part from outside: designs against single runs, parts against the
# whole, bad input, designs that cannot be built, interruption, memory.
. "$(dirname "$0")/../harness.sh"

base() {
    cat <<'DECK'
title = A crank-rocker
mechanism = four-bar
solver = matrix
[ground]
length = 80 mm
[crank]
length = 20 mm
mass = 0.1 kg
cg = 10 mm
[coupler]
length = 66 mm
mass = 0.3 kg
[rocker]
length = 56 mm
mass = 0.2 kg
[load W]
link = rocker
torque = -2 N m
[point P]
link = coupler
at = (30, 10) mm
[motion]
speed = 10.5 rad/s
interval = 45 deg
[table]
columns = theta2, theta4, omega4, mu, Ts, P.x
DECK
}
base >single.deck
first=$(($(wc -l <single.deck) + 1)) # the line of [sweep]

# sweep LINE...: t.deck is the deck with these lines of [sweep]
sweep() {
    { base && echo '[sweep]' && printf '%s\n' "$@"; } >t.deck
}
whole_lines() { [ "$(tail -c 1 "$1" | tr '\n' x)" = x ]; }

# ---------------------------------------------------------------- each design is a single run

sweep 'crank.length = 18 mm to 22 mm step 2 mm' 'load W.torque = -2 N m, 3 N m' 'motion.speed = 10 rad/s, 100 rpm'
run 0 -f csv t.deck
quiet
mv out rows
check 'the header of rows' grep -q '^design,crank.length (m),load W.torque (N.m),motion.speed (rad/s),branch,theta2 (deg),' rows
lines rows $((1 + 12 * 2 * 9))
run 0 t.deck
mv out table
check 'a comment for each design' test "$(grep -c '^# design [0-9]*: crank.length = 0.0' table)" -eq 12
n=0
for length in 18 20 22; do
    for torque in -2 3; do
        for speed in '10 rad/s' '100 rpm'; do
            n=$((n + 1))
            set -- -s "crank.length=$length mm" -s "load W.torque=$torque N m" -s "motion.speed=$speed"
            run 0 -f csv "$@" single.deck
            sed 1d out >one
            sed -n "s/^$n,[^,]*,[^,]*,[^,]*,//p" rows >of_sweep
            same one of_sweep
            lines of_sweep 18
            run 0 "$@" single.deck
            # but for the four lines of extremes, which a sweep leaves to max() and min()
            awk '/^#.*  (max|min)$/ {getline; next} {print}' out >without && mv without out
            awk -v n=$n '/^# design /{on = $3 == n ":"; next} on' table | sed -e :a -e '/^\n*$/{$d;N;ba' -e '}' >of_sweep
            same out of_sweep
        done
    done
done

# parts of vectors, against decks with the vectors
vectors() {
    base
    printf '[load F]\nlink = coupler\nat = 10 mm at 20 deg\nforce = %s\n' "$1"
}
n=0
{ vectors '5 N at 30 deg' && printf '%s\n' '[sweep]' 'load F.force.size = 5 N to 6 N step 1 N' \
    'load F.force.angle = 30 deg, 120 deg' 'coupler.cg.y = -1 cm, 4 mm' 'load F.at.x = 3 mm, 4 mm'; } >t.deck
run 0 -f csv t.deck
quiet
mv out rows
check 'the header of parts' grep -q '^design,load F.force.size (N),load F.force.angle (deg),coupler.cg.y (m),load F.at.x (m),' rows
for force in 5 6; do
    for angle in 30 120; do
        for y in -10 4; do
            for x in 3 4; do
                n=$((n + 1))
                vectors "$force N at $angle deg" >one.deck
                # y of the point is 10 mm sin(20 deg)
                run 0 -f csv -s "coupler.cg=(0, $y) mm" -s "load F.at=($x, 3.4202014332566873) mm" one.deck
                sed 1d out >one
                sed -n "s/^$n,[^,]*,[^,]*,[^,]*,[^,]*,//p" rows >of_sweep
                check "part $n" awk -F, 'NR == FNR {for (i = 2; i < NF; i++) v[FNR, i] = $i; next}
                    {for (i = 2; i < NF; i++) if (($i - v[FNR, i]) ^ 2 > 1e-22 * ($i * $i + 1)) exit bad = 1}
                    END {exit bad + (FNR != 18)}' one of_sweep
            done
        done
    done
done

# size and angle in any order, of a point that the deck does not give
{ base && printf '%s\n' '[sweep]' 'rocker.cg.angle = 0 deg, 90 deg' 'rocker.cg.size = 10 mm, -10 mm' 'output = max(Ts)'; } |
    sed '/^\[load/,/^torque/d' >t.deck
run 0 -f csv -b open t.deck
sed 1d out | cut -d, -f5 >swept
for point in '(10, 0)' '(-10, 0)' '(0, 10)' '(0, -10)'; do
    sed '/^\[load/,/^torque/d' single.deck >one.deck
    "$fourlink" -S -f csv -b open -c Ts -s "rocker.cg=$point mm" one.deck | sed -n 's/^max(Ts),\([^,]*\),.*/\1/p'
done >single
check 'size and angle, either first' test "$(awk '{printf "%.10g ", $1}' swept)" = "$(awk '{printf "%.10g ", $1}' single)"
check 'four of them' test "$(sort -u swept | wc -l)" -eq 4

outputs='max(Ts), min(omega4), mu_min, theta4_max, swing, type, max(P.x), mean_torque'
sweep 'crank.length = 18 mm to 22 mm step 2 mm' 'load W.torque = -2 N m, 3 N m' "output = $outputs"
run 0 -f csv t.deck
quiet
lines out 13
tr -d '\r' <out >lines.csv
n=0
for length in 18 20 22; do
    for torque in -2 3; do
        n=$((n + 1))
        run 0 -f csv -S -s "crank.length=$length mm" -s "load W.torque=$torque N m" single.deck
        tr -d '\r' <out >summary.csv
        for branch in open crossed; do
            check "design $n, $branch, against --summary" awk -F, -v n=$n -v branch=$branch -v bad=0 '
                NR == FNR {if (FNR == 1) for (i = 1; i <= NF; i++) column[$i] = i
                           else {fact = $column["name"]; b = $column["branch"]
                                 if (b == "" || b == branch) value[fact] = $column["value"]}; next}
                FNR == 1 {for (i = 5; i < NF; i++) {split($i, w, " "); name[i] = w[1]}; next}
                $1 == n && $4 == branch {
                    seen++
                    for (i = 5; i < NF; i++)
                        if (!(name[i] in value) || value[name[i]] != $i) {
                            bad++; print name[i] ": " $i " instead of " value[name[i]]}}
                END {exit bad || seen != 1}' summary.csv lines.csv
        done
    done
done

# one branch
run 0 -f csv -b crossed t.deck
lines out 7
check '--branch=crossed' none ',open,' out

# the format table has the numbers of csv
run 0 -s table.digits=15 t.deck
check 'the lines of the table' awk -v bad=0 '
    NR == FNR {if (FNR > 1) {split($0, f, ","); k++; a[k] = f[1]; b[k] = f[2]; c[k] = f[5]}; next}
    !/^#/ {n++; if ($1 != a[n] || ($2 - b[n]) ^ 2 > 1e-24 || ($5 - c[n]) ^ 2 > 1e-20) bad++}
    END {exit bad || n != k || n != 12}' lines.csv out

# samples: the same seed the same bytes, others others
sweep 'coupler.length = 66 mm +- 0.1 mm' 'rocker.length = 56 mm ± 0.1 mm normal' 'samples = 40' 'output = mu_min'
run 0 -f csv t.deck && mv out one
run 0 -f csv t.deck && same out one
run 0 -f csv -s sweep.seed=1 t.deck && same out one
run 0 -f csv -s sweep.seed=2 t.deck && differ out one
lines one 81
for n in 1 17 40; do # a design can be made again from the values of its line
    set -- $(sed -n "s/^$n,\([^,]*\),\([^,]*\),open,\([^,]*\),.*/\1 \2 \3/p" one)
    run 0 -f csv -S -s "coupler.length=$1 m" -s "rocker.length=$2 m" single.deck
    check "sample $n against a single run" awk -F, -v x="$3" '
        /mu_min/ && /open/ {for (i = 1; i <= NF; i++) if ($i ~ /^[0-9.]+$/ && ($i - x) ^ 2 < 1e-18) ok = 1}
        END {exit !ok}' out
done

# per cent
sweep 'coupler.length = 66 mm +- 0.5 %' 'samples = 5' 'output = mu_min'
run 0 -f csv t.deck && mv out per_cent
sweep 'coupler.length = 66 mm +- 0.33 mm' 'samples = 5' 'output = mu_min'
run 0 -f csv t.deck && same out per_cent

# ------------------------------------------------------------------------------------- parts

# parts N FORMAT: t.deck in so many parts, made from the last to the first, is `whole`
parts() {
    k=$1
    rm -f part.*
    while [ $k -ge 1 ]; do
        run 0 --part=$k/$1 -f "$2" -o "part.$k" t.deck
        k=$((k - 1))
    done
    k=0
    while [ $k -lt "$1" ]; do
        k=$((k + 1))
        cat "part.$k"
    done >together
    same together whole
    check "$1 parts: a header in one only" test "$(grep -c 'branch\b.*mu' together)" -eq "$(grep -c 'branch\b.*mu' whole)"
}

rows='motion.interval = 90 deg, 120 deg'
for output in "$rows" 'output = mu_min, type, max(Ts)'; do
    sweep 'crank.length = 18 mm to 22 mm step 1 mm' 'rocker.length = 56 mm +- 0.1 mm' 'samples = 2' "$output"
    for format in csv table; do
        run 0 -f $format -o whole t.deck
        for n in 1 2 3 7 30; do
            parts $n $format
        done
        run 0 -P 2/3 -f $format t.deck
        check 'a part is neither empty nor all' test -s out
        differ out whole
    done
    run 0 -f csv --part=2/3 t.deck
    check 'no header in a later part' none '^design' out
done

run 0 -f csv -o whole t.deck
if command -v parallel >/dev/null; then
    HOME=$work
    export HOME
    cat >fake_ssh <<'SCRIPT'
#!/bin/sh
# ssh [OPTION]... HOST COMMAND...: the command on this machine, with SHELL set, as sshd does
while [ $# -gt 0 ]; do
    case $1 in
    -[lp]) shift 2 ;;
    -*) shift ;;
    *) break ;;
    esac
done
echo "$1" >>"$HOSTS"
[ "$2" = -- ] && shift
shift
SHELL=/bin/sh exec sh -c "$*"
SCRIPT
    chmod +x fake_ssh
    HOSTS=$work/hosts
    export HOSTS
    rm -f part*
    check 'parallel' parallel --will-cite "$fourlink" '--part={}/4' -f csv -o 'part{}.csv' t.deck ::: 1 2 3 4 </dev/null 2>err
    cat part1.csv part2.csv part3.csv part4.csv >together
    same together whole
    check 'parallel --keep-order' parallel --will-cite -k "$fourlink" '--part={}/4' -f csv t.deck ::: 1 2 3 4 </dev/null >together 2>err
    same together whole
    check 'parallel over ssh' parallel --will-cite -k --ssh "$work/fake_ssh" -S 1/one,1/two --wd "$work" \
        "$fourlink" '--part={}/4' -f csv t.deck ::: 1 2 3 4 </dev/null >together 2>err
    same together whole
    check 'both hosts had work' test "$(sort -u hosts | grep -c '^one$\|^two$')" -eq 2
else
    echo 'skipped: GNU parallel is not there'
fi

if command -v make >/dev/null; then
    rm -f part*
    cat >Makefile <<MAKE
parts = part1.csv part2.csv part3.csv part4.csv
all.csv: \$(parts)
${tab}cat \$(parts) >all.csv
\$(parts): part%.csv: t.deck
${tab}$fourlink --part=\$*/4 -f csv -o \$@ t.deck || test \$\$? -eq 1
MAKE
    sweep 'crank.length = 18 mm to 26 mm in 5' 'rocker.length = 56 mm, 20 mm' # some rows are out of reach
    run 1 -f csv -o whole t.deck
    check 'make -j4' make -s -j4 </dev/null
    same all.csv whole
    cp part1.csv kept
    rm part3.csv all.csv # as if it had been interrupted
    make -j4 </dev/null >made
    check 'only the part that is not there is made again' test "$(grep -c -e --part= made)" -eq 1
    same all.csv whole
else
    echo 'skipped: make is not there'
fi

# ----------------------------------------------------------------------------------- bad input

# bad LINE MESSAGE SWEEP...: exit 2 with this message at the line of t.deck, counted from [sweep], and no other
bad() {
    line=$(($1 + first))
    message=$2
    shift 2
    sweep "$@"
    run 2 -f csv t.deck
    nothing
    says "t.deck:$line: error: $message"
    check "more than one message for '$*': $(tail -n 1 err)" test "$(wc -l <err)" -eq 1
}
good='crank.length = 18 mm to 22 mm step 1 mm'
toleranced='crank.length = 20 mm +- 1 mm'

bad 1 "unknown key 'lenght' in [crank]; did you mean 'length'?" 'crank.lenght = 1 mm, 2 mm'
bad 1 "unknown section 'crnk'; did you mean 'crank'?" 'crnk.length = 1 mm, 2 mm'
bad 1 'there is no [point Q] in the deck' 'point Q.at = 1 mm'
bad 1 "unknown key 'mechanism' in [sweep]" 'mechanism = 1'
bad 1 "'crank.cg' has parts: vary its .x, .y, .size or .angle" 'crank.cg = 30 mm, 40 mm'
bad 1 "'crank.length' has no parts that can be varied" 'crank.length.x = 30 mm, 40 mm'
bad 1 "'load W.force' is not given: only a part of it varies" 'load W.force.size = 1 N, 2 N'
bad 1 "'1 kg' is a mass; expected an angle" 'crank.cg.angle = 1 kg, 2 kg'
bad 2 "'crank.cg.y' and another part: vary x and y, or size and angle" 'crank.cg.size = 1 mm, 2 mm' 'crank.cg.y = 3 mm, 4 mm'
for key in table.columns sweep.samples expect.x units.length; do
    sweep "$key = 1, 2"
    run 2 t.deck
    nothing
    says "t.deck:$((first + 1)): error: '$key' is no quantity that can be varied"
done
bad 1 "'1 kg' is a mass; expected a length" 'crank.length = 1 kg, 2 kg'
bad 1 'expected a length' 'crank.length = 18 mm, , 20 mm'
bad 1 "unknown key 'length' in [sweep]; a quantity is named with its section" 'length = 18 mm, 20 mm'
bad 1 "expected a tolerance, such as 0.1 mm or 0.5 %, not ''" 'crank.length = 18 mm +-' 'samples = 2'
bad 1 'a tolerance is of one value, not of a list or a range' 'crank.length = 18 mm, 20 mm +- 1 mm' 'samples = 2'
bad 1 'a tolerance is of one value, not of a list or a range' 'crank.length = 18 mm to 20 mm step 1 mm +- 1 mm' 'samples = 2'
bad 1 'a tolerance in per cent is of a value other than 0' 'ground.angle = 0 deg +- 1 %' 'samples = 2'
bad 1 'a range needs its step' 'crank.length = 18 mm to 22 mm'
bad 1 'the step of the range does not lead' 'crank.length = 18 mm to 22 mm step 0 mm'
bad 1 'the step of the range does not lead' 'crank.length = 18 mm to 22 mm step -1 mm'
bad 1 'the number of values of a range' 'crank.length = 18 mm to 22 mm in 1'
bad 1 'the tolerance, 30 mm, is not smaller than the length, 20 mm' 'crank.length = 20 mm +- 30 mm' 'samples = 3'
bad 1 'the tolerance must be positive, not 0 mm' 'crank.length = 20 mm +- 0 mm' 'samples = 3'
bad 1 'the tolerance must be positive, not -1 mm' 'crank.length = 20 mm +- -1 mm' 'samples = 3'
bad 0 "a tolerance needs 'samples = NUMBER'" "$toleranced"
bad 2 'samples are of a tolerance' "$good" 'samples = 3'
bad 2 'the samples must be positive, not 0' "$toleranced" 'samples = 0'
bad 2 'the samples must be positive, not -4' "$toleranced" 'samples = -4'
bad 2 "expected a whole number, not '1.5'" "$toleranced" 'samples = 1.5'
bad 2 "expected a whole number, not '0.5'" "$toleranced" 'samples = 0.5'
bad 3 'the seed must not be negative, not -1' "$toleranced" 'samples = 3' 'seed = -1'
bad 1 "there is no [sweep .crank] in the deck" 'sweep.crank.length = 20 mm to 30 mm step 2 mm'
bad 2 'a second [sweep]; the first is at line' "$good" '[sweep]' "$good"
bad 0 '[sweep] varies nothing' ''
bad 0 '[sweep] varies nothing' 'output = swing'
bad 2 "'crank.length' a second time" "$good" "$good"
bad 0 'more than 4e9 designs' 'crank.length = 18 mm to 22 mm in 100000' 'rocker.length = 50 mm to 60 mm in 100000'
bad 2 "'mu_mn' is no fact, and no max() or min() of a column, of this deck; did you mean 'mu_min'?" "$good" 'output = swing, mu_mn'
bad 2 "'max(Tx)' is no fact, and no max() or min()" "$good" 'output = max(Tx)'
for column in mu Ts theta2 time omega2; do # those of the crank, too, have many values
    bad 2 "'$column' has many values: name its extremes, max() or min()" "$good" "output = $column"
done

sweep "$good"
for part in 5/4 0/4 1/0 x 1 1/ /4 -1/4 1.5/4 1/4x ''; do
    run 2 --part="$part" t.deck
    nothing
    says '--part'
    says "$part"
done
run 2 --part=1/2 single.deck
nothing
says 'single.deck:1: error: --part needs a [sweep]'
cp t.deck u.deck
run 2 t.deck u.deck
nothing
says 'a [sweep] is worked on alone'
for option in --matrix --summary --format=paper --check; do
    run 2 $option t.deck
    nothing
    says 't.deck:1: error: '
done
printf '[expect]\nmu_min = 58\n' >answers
run 2 --check=answers t.deck
nothing
says 't.deck:1: error: a [sweep] is printed in the formats table and csv'

# ----------------------------------------------------------------- designs that cannot be built

# the first that can be built may come late
sweep 'crank.length = 100 m to 0.02 m in 5000' 'output = mu_min'
run 1 -f csv t.deck
check 'the last design' grep -q '^5000,0.02,open,58[.0-9]*,ok' out

# a file that the deck names is read once: what becomes of it does not matter
{ printf 'mechanism = slider-crank\n[crank]\nlength = 5 cm\n[rod]\nlength = 20 cm\n[piston]\nmass = 1 kg\n'
    printf '[gas]\nbore = 10 cm\nindicator = file card.txt\n[motion]\nspeed = 10 rad/s\n'
    printf '[sweep]\ncrank.length = 2 cm to 9 cm in 4000\noutput = max(gas_force)\n'; } >card.deck
mkfifo card.txt # which has its contents once
printf '0 1e5\n180 3e5\n' >card.txt &
run 0 -f csv card.deck
mv out pipe.csv
check 'the file was read once' test "$(grep -c ',ok' pipe.csv)" -eq 8000

reason='the crank, 300 mm, is longer than the other three together, 202 mm: they cannot be assembled'
for lengths in '20 mm, 300 mm, 22 mm' '300 mm, 20 mm, 22 mm'; do
    sweep "crank.length = $lengths" 'output = swing, type'
    run 1 -f csv t.deck
    quiet
    prints "$reason"
    check 'the others have their values' test "$(grep -c 'crank-rocker,ok' out)" -eq 4
    check 'as many cells in each line' awk -F, '{gsub(/"[^"]*"/, "x"); if (NR > 1 && NF != n) bad = 1; n = NF} END {exit bad + 0}' out
    run 1 t.deck
    check 'a comment of the table' grep -q "^# $reason" out
    check 'the others have their values' test "$(grep -c '"crank-rocker"' out)" -eq 4
    check 'lines without a gap' none '^$' out
    sweep "crank.length = $lengths"
    run 1 -f csv t.deck
    prints "$reason"
    lines out $((1 + 2 + 2 * 2 * 9))
    run 1 t.deck
    check 'a comment of the table' grep -q "^# $reason" out
done
for n in 1 2 3; do # and in parts
    "$fourlink" --part=$n/3 -f csv t.deck 2>>err
done >together
"$fourlink" -f csv t.deck >whole 2>err
same together whole

# an output that a design does not have
sweep 'crank.length = 20 mm, 100 mm' 'output = swing, mu_max'
run 0 -f csv t.deck
quiet
check 'an empty cell' grep -q "^2,0.1[0-9]*,open,,[0-9].*,ok$cr\$" out
run 0 t.deck
check 'nan in the table' grep -Eq '^ +2 +0\.1 +"open" +nan +[0-9]' out

# columns that only some designs have: as many cells in each line of csv
base | sed '/^mass/d;/^\[load/,/^torque/d;/^\[table/,$d' >t.deck
printf '[sweep]\ncrank.mass = 0 kg, 1 kg\n' >>t.deck
run 0 -f csv t.deck
check 'as many cells in each row' awk -F, 'NR > 1 && NF != n {bad = 1} {n = NF} END {exit bad + 0}' out

# a column that one design has not: its reason on both branches, the others as they are
base | sed '/^\[table/,$d' >t.deck
printf '[table]\ncolumns = theta2, Ts\n[sweep]\ncoupler.mass = 0.3 kg, 0 kg, 0.1 kg\n' >>t.deck
sed -i '/^\[load/,/^torque/d;/^mass/d;/^gyration/d' t.deck
run 1 -f csv t.deck
quiet
check 'a reason for each branch' test "$(grep -c '^2,0,.*needs masses' out)" -eq 2
check 'the third design' grep -q '^3,0\.1.*,ok' out

# beyond all bounds: infinite; no position at all: a reason
sweep 'rocker.length = 10 mm, 56 mm' 'output = max(omega4), min(omega4)'
run 0 -f csv t.deck
check 'infinite, both ways' grep -q "^1,0.01[0-9]*,open,inf,-inf,ok$cr\$" out
check 'finite' grep -Eq '^2,0.056[0-9]*,open,[0-9.]+,-[0-9.]+,ok' out

# from the command line
sweep 'crank.length = 18 mm, 20 mm' 'output = mu_min'
run 0 -f csv -s 'sweep.crank.length = 21 mm, 22 mm' t.deck
check 'a sweep by --set' grep -q '^2,0.0219999' out
mv out lower
run 0 -f csv -s 'Sweep.crank.length = 21 mm, 22 mm' t.deck
same out lower
run 0 -f csv -s "sweep.crank.length = 21 mm${tab}to${tab}22 mm${tab}step${tab}1 mm" t.deck
same out lower

# ------------------------------------------------------------------------------- interruption

sweep 'crank.length = 18 mm to 22 mm in 30000000' 'output = mu_min, swing'
mkdir files
for signal in INT TERM; do
    echo old >files/result
    # what a script starts in the background ignores SIGINT
    if [ $signal = INT ] && ! env --default-signal=INT true 2>/dev/null; then
        echo 'skipped: SIGINT cannot be given its default action here'
        continue
    fi
    set -- env
    [ $signal = INT ] && set -- env --default-signal=INT
    "$@" "$fourlink" -f csv -o files/result t.deck 2>err &
    pid=$!
    sleep 0.5
    check 'a temporary file while it runs' test "$(ls -A files | wc -l)" -eq 2
    kill -$signal $pid
    (sleep 5; kill -9 $pid) 2>/dev/null &
    guard=$!
    wait $pid 2>/dev/null
    status=$?
    kill $guard 2>/dev/null
    check "ended by SIG$signal: $status" test $status -eq "$([ $signal = INT ] && echo 130 || echo 143)"
    only_file files result
    check 'the old file is untouched' test "$(cat files/result)" = old
    check 'no progress where nobody looks' none 'designs,' err

    # to a pipe that is read slowly: whole lines
    mkfifo pipe
    (sleep 1; cat) <pipe >got &
    reader=$!
    "$@" "$fourlink" -f csv t.deck >pipe 2>err &
    pid=$!
    sleep 0.5
    kill -$signal $pid
    wait $pid 2>/dev/null
    wait $reader
    rm pipe
    check 'something arrives' test "$(wc -l <got)" -gt 100
    check "the last line is whole: $(tail -n 1 got)" whole_lines got
    check 'none is left out' awk -F, 'NR > 1 && ($1 != int(NR / 2) || NF != 6) {bad = 1} END {exit bad + 0}' got
done

# progress
sweep 'crank.length = 18 mm to 22 mm in 30000000' 'output = mu_min, swing'
if command -v script >/dev/null; then
    script -qec "timeout 2.5 '$fourlink' -f csv -o files/result t.deck" typed </dev/null >shown 2>&1
    check 'progress on a terminal' grep -q 'of 30000000 designs, 0 %' shown
    only_file files result
else
    echo 'skipped: script is not there'
fi
sweep 'crank.length = 18 mm to 22 mm in 3000' 'output = mu_min'
run 0 -f csv -o files/result t.deck
quiet

# -------------------------------------------------------------------------------------- memory

# Memory is that of one design.  (A sanitizer needs more address space than this.)
sweep 'crank.length = 18 mm to 22 mm in 100000' 'output = swing'
if (ulimit -v 65536 && "$fourlink" --version >out) 2>err; then
    check '100,000 designs in 64 MB' sh -c 'ulimit -v 65536 && exec "$0" -f csv t.deck | wc -l | grep -q "^ *200001$"' "$fourlink"
fi

if command -v valgrind >/dev/null && valgrind -q "$fourlink" --version >out 2>err && [ ! -s err ]; then # not all read clang's symbols
    for output in "$rows" 'output = mu_min, type, max(Ts)'; do
        sweep 'crank.length = 20 mm, 300 mm, 22 mm' 'rocker.length = 56 mm +- 0.1 mm normal' 'samples = 2' "$output"
        for format in csv table; do
            valgrind -q --error-exitcode=9 --leak-check=full "$fourlink" -f $format t.deck >out 2>err
            status=$?
            check "valgrind, $format, $output: $status, $(head -n 3 err)" test $status -eq 1
        done
    done
    sweep 'crank.length = 18 mm to 22 mm step 0 mm' 'rocker.length = 56 mm +- 90 mm' 'samples = 2'
    valgrind -q --error-exitcode=9 --leak-check=full "$fourlink" t.deck >out 2>err
    check 'valgrind, mistakes' test $? -eq 2
else
    echo 'skipped: valgrind is not there, or cannot read the program'
fi

finish
