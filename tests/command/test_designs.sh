#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_designs.sh FOURLINK DATA - [sweep]: each design against a single run; outputs, tolerances, samples.
. "$(dirname "$0")/sweeps.sh"

sweep 'crank.length = 18 mm to 22 mm step 2 mm' 'load W.torque = -2 N m, 3 N m' 'motion.speed = 10 rad/s, 100 rpm'
run 0 -f csv t.deck
quiet
mv out rows
check 'the header of rows' grep -q '^design,crank.length (m),load W.torque (N.m),motion.speed (rad/s),branch,theta2 (deg),' rows
lines rows $((1 + 12 * 2 * 9))
run 0 t.deck
mv out table
check 'a comment for each design' test "$(grep -c '^# design [0-9]*: crank.length = [12][0-9] mm' table)" -eq 12
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
            awk '/^# +(max|min|at) / {next} {print}' out >without && mv without out
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
                        if (!(name[i] in value) ||
                            (value[name[i]] - $i) ^ 2 > 1e-26 * $i ^ 2) {
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
run 0 --units=SI -s table.digits=15 t.deck
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

# from the command line
sweep 'crank.length = 18 mm, 20 mm' 'output = mu_min'
run 0 -f csv -s 'sweep.crank.length = 21 mm, 22 mm' t.deck
check 'a sweep by --set' grep -q '^2,0.022,' out
mv out lower
run 0 -f csv -s 'Sweep.crank.length = 21 mm, 22 mm' t.deck
same out lower
run 0 -f csv -s "sweep.crank.length = 21 mm${tab}to${tab}22 mm${tab}step${tab}1 mm" t.deck
same out lower

# the head of a table of designs
{ cat "$alvi"; printf '[sweep]\ncrank.length = 18 mm, 20 mm\noutput = mu_min, type\n'; } >head.deck
run 0 head.deck
prints '# branch: 1 open; -1 crossed'
prints '# type: 1 crank-rocker; 2 rocker-crank; 3 double crank (drag link); 4 double rocker;'
check 'it has a line for each column' grep -qx '#   design    crank.length    branch          mu_min            type' out
check 'types of another kind' none 'slider' out

# The yield: 1 if the outputs meet all conditions, 0 if not or if one has no value; of words there is none.
sweep 'crank.length = 18 mm, 20 mm, 22 mm, 25 mm' 'ground.length = 80 mm, 100 mm, 800 mm' 'output = mu_min, swing' \
    'yield = mu_min > 56 deg, swing <= 42 deg, max(Ts) >= -1 N m'
run 1 -f csv t.deck
check 'each line' awk -F, 'NR == 1 {ok = $5 == "mu_min (deg)" && $6 == "swing (deg)" && $7 == "max(Ts) (N.m)" && $8 == "yield (1)"}
    NR > 1 {want = $5 != "" && $6 != "" && $7 != "" && $5 > 56 && $6 <= 42 && $7 >= -1; n[want]++; if ($8 != want) bad = 1}
    END {exit !(ok && !bad && n[0] > 15 && n[1] == 2)}' out
run 1 t.deck
prints 'yield'

finish
