#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_statistics.sh FOURLINK DATA - statistics and yield of a sweep, against an awk program that computes them
# from the designs; the recipe of doc/sweeps.md for joined parts; quantities in step.
. "$(dirname "$0")/sweeps.sh"

# ------------------------------------------------------------------ statistics, computed twice

# independent FILE: name,branch,count,mean,std_dev,min,5 %,25 %,50 %,75 %,95 %,max of each column of numbers, by two
# passes and a sort
independent() {
    tr -d '\r' <"$1" | awk -F, '
        NR == 1 {for (i = 1; i <= NF; i++) {head[i] = $i; sub(/ \(.*/, "", head[i]); if ($i == "branch") b = i}; n_columns = NF; next}
        {for (i = b + 1; i < n_columns; i++) if ($i ~ /^-?[0-9.e+-]+$/) v[i, $b, ++n[i, $b]] = $i + 0}
        END {
            split("0.05 0.25 0.5 0.75 0.95", share, " "); split("open crossed", branches, " ")
            for (k = 1; k <= 2; k++) for (i = b + 1; i < n_columns; i++) {
                branch = branches[k]; m = n[i, branch]; if (!m) continue
                sum = 0; for (j = 1; j <= m; j++) {x[j] = v[i, branch, j]; sum += x[j]}
                mean = sum / m; ss = 0; for (j = 1; j <= m; j++) ss += (x[j] - mean) ^ 2
                for (j = 2; j <= m; j++) {y = x[j]; for (l = j - 1; l >= 1 && x[l] > y; l--) x[l + 1] = x[l]; x[l + 1] = y}
                printf "%s,%s,%d,%.12g,%s,%.12g", head[i], branch, m, mean, (m > 1 ? sprintf("%.12g", sqrt(ss / (m - 1))) : ""), x[1]
                for (q = 1; q <= 5; q++) {
                    h = (m - 1) * share[q] + 1; f = int(h)
                    printf ",%.12g", (f < m ? x[f] + (h - f) * (x[f + 1] - x[f]) : x[m])
                }
                printf ",%.12g\n", x[m]
            }
        }'
}
# agree FILE: the statistics in csv are those of this file
agree() {
    check "statistics against $1: $2" awk -F, '
        NR == FNR {line[$1, $2] = $0; count++; next}
        {sub(/\r$/, "")}
        FNR == 1 || $14 != "" {next}
        {seen++; split(line[$1, $3], w, ",")
         if (w[3] != $4) bad = 1
         for (i = 4; i <= 12; i++) {
             d = w[i] - $(i + 1); if (d < 0) d = -d; s = w[i] < 0 ? -w[i] : w[i]
             if (d > 1e-9 * s + 1e-12 || (w[i] == "") != ($(i + 1) == "")) {print "at " i ": " w[i] " " $(i + 1) " in " $0; bad = 1}}}
        END {exit bad || seen != count || !seen}' "$1" out
}

for n in 1 2 3 20 101; do
    sweep 'coupler.length = 66 mm +- 1 mm' 'rocker.length = 56 mm ± 1 mm normal' "samples = $n" \
        'output = mu_min, max(Ts), type'
    run 0 -f csv t.deck
    independent out >expected
    run 0 -f csv --statistics t.deck
    quiet
    agree expected "$n samples"
    check 'words have none' none '^type,' out
    mv out by_option
    run 0 -f csv -s sweep.statistics=yes t.deck
    same out by_option
done
mv out whole

# designs without a value, unbounded values, one branch
sweep 'crank.length = 5 mm to 80 mm step 5 mm' 'output = mu_min, swing, time_ratio, max(omega4)'
run 0 -f csv -b crossed t.deck
independent out >expected
run 0 -f csv -b crossed --statistics t.deck
check 'crossed alone' none ',open,' out
check 'fewer have a swing' awk -F, '$1 == "mu_min" {m = $4} $1 == "swing" {s = $4} END {exit !(s > 1 && s < m)}' out
check 'an unbounded output' grep -q '^max(omega4),rad/s,crossed,16,inf,,' out
grep -v '^max(omega4)' out >finite && mv finite out
grep -v '^max(omega4)' expected >finite
agree finite 'swing'

# the formats
sweep 'coupler.length = 66 mm, 67 mm, 68 mm' 'output = mu_min' 'statistics = yes'
run 0 -b open t.deck
check 'the title' test "$(head -n 1 out)" = '# A crank-rocker'
lines out 4
check 'numbers only' awk '!/^#/ && NF != 10 {bad = 1} END {exit bad}' out
check 'its name' test "$(sed -n 3p out)" = '# mu_min (deg), open branch'
# lines of at most 100 characters, unless a number would lose most of its digits; columns apart
run 0 -s 'sweep.output=min(Ts), min(alpha4)' -s 'motion.speed=1 rad/s' t.deck
check 'negative numbers' grep -q ' -0[.][0-9]* ' out
check 'narrow' none '.\{101\}' out
run 0 -s 'sweep.output=min(alpha4)' -s 'motion.speed=0.00031 rad/s' t.deck
check 'small negative numbers' grep -q ' -[0-9.]\{7\}e-08 ' out
check 'apart' awk '!/^#/ && NF != 10 {bad = 1} END {exit bad}' out
# more digits have wider columns
run 0 -b open -s table.digits=12 t.deck
check 'all digits' awk '!/^#/ && (NF != 10 || length($2) != 13) {bad = 1} END {exit bad}' out
run 0 -b open -f json t.deck
check 'json' grep -q '^{"name":"mu_min","unit":"deg","branch":"open","count":3,"mean":[0-9.]*,"std_dev":[0-9.]*,"min":.*"5 %":' out
run 0 -b open -f csv t.deck
check 'csv' test "$(head -n 1 out | tr -d '\r')" = \
    'name,unit,branch,count,mean,std_dev,min,5 %,25 %,50 %,75 %,95 %,max,yield,low,high'
run 0 -s sweep.statistics=no t.deck
check 'the designs' grep -q '^#   design' out

# ------------------------------------------------------------------------------------------ yield

sweep 'coupler.length = 66 mm +- 1 mm' 'samples = 50' 'output = max(Ts)' 'yield = mu_min > 58 deg, max(Ts) < 0.688 N m'
run 0 -f csv -s sweep.statistics=no t.deck
mv out designs
yields=$(tr -d '\r' <designs | awk -F, '
    NR == 1 {for (i = 1; i <= NF; i++) {if ($i ~ /^mu_min/) m = i; if ($i ~ /^max\(Ts\)/) t = i}; next}
    $3 == "open" {a += ($m > 58); b += ($t < 0.688); c += ($m > 58 && $t < 0.688)} END {print a * 2, b * 2, c * 2}')
run 0 -f csv t.deck
says 'with a yield, statistics are printed, not designs'
check "yield $yields" test "$(tr -d '\r' <out | awk -F, '$3 == "open" && $14 != "" {printf "%s%s", s, $14; s = " "} END {print ""}')" = "$yields"
check "neither none nor all: $yields" awk -v y="$yields" 'BEGIN {n = split(y, v, " "); for (i = 1; i <= n; i++) if (v[i] <= 0 || v[i] >= 100) bad = 1; exit bad}'
check 'all conditions' grep -q '^all conditions,%,open,50,' out
run 0 t.deck
prints ' of 50 designs: mu_min > 58 deg'
prints ' of 50 designs: all conditions'
# each sign, with a limit that a design meets exactly
sweep 'rocker.mass = 1 kg, 2 kg, 3 kg' 'yield = n > 4, n >= 4, n < 4, n <= 4'
cat >t.deck <<'DECK'
mechanism = slider-crank
[crank]
length = 100 mm
[rod]
length = 400 mm
[motion]
speed = 10 rad/s
[sweep]
rod.length = 300 mm, 400 mm, 500 mm, 50 mm
yield = n > 4, n >= 4, n < 4, n <= 4
DECK
run 0 -f csv -b open t.deck
check 'the signs' test "$(tr -d '\r' <out | awk -F, 'NR > 1 && $14 != "" {printf "%s ", $14}')" = '25 50 50 75 0 '

# Wilson's interval: 8 of 10, 0 of 10 and 10 of 10, from R. G. Newcombe's method 3 (Statistics in Medicine 17,
# 1998), with the numbers computed by hand; and designs without a value, which fail
# interval PASSED CONDITION YIELD LOW HIGH: of ten designs, the others have n = 0.5 and no stroke
interval() {
    rods=$(for i in 1 2 3 4 5 6 7 8 9 10; do
        printf '%s%s mm' "$([ $i -eq 1 ] || echo ', ')" $([ $i -gt "$1" ] && echo $((40 + i)) || echo $((500 + i)))
    done)
    run 0 -f csv -b open -s "sweep.rod.length=$rods" -s "sweep.yield=$2" t.deck
    check "interval of $1, $2: $(tail -n 1 out)" awk -F, -v y="$3" -v l="$4" -v h="$5" '
        function near(a, b) {return (a - b) ^ 2 < 1e-8}
        $14 != "" && NR > 1 {ok = near($14, y) && near($15, l) && near($16, h)} END {exit !ok}' out
}
interval 8 'n > 4' 80 49.01625 94.33178
interval 8 'stroke > 1 mm' 80 49.01625 94.33178
interval 8 'stroke < 1 m' 80 49.01625 94.33178
interval 0 'n > 4' 0 0 27.75328
interval 10 'n > 4' 100 72.24672 100

# ---------------------------------------------------------------- the recipe for joined parts

sweep 'coupler.length = 66 mm +- 1 mm' 'samples = 101' 'output = mu_min, max(Ts), type' 'yield = mu_min > 58 deg'
for k in 1 2 3; do
    run 0 -f csv --part=$k/3 t.deck
    mv out part$k
done
cat part1 part2 part3 >sweep.csv
recipe 'Statistics of the parts' recipe.sh
sh recipe.sh >of_parts
run 0 -f csv -b open t.deck
check "the recipe prints $(cat of_parts)" awk '
    function differs(x, y) {return (x - y) ^ 2 > (1e-5 * x) ^ 2}
    NR == FNR {n = split($0, mine, " "); next}
    {gsub(/\r/, ""); split($0, f, ",")}
    f[1] == "mu_min" {seen++; bad += mine[1] != f[4]; split("5 6 7 8 10 12 13", of, " ")
        for (i = 1; i <= 7; i++) bad += differs(f[of[i]], mine[i + 1])}
    f[1] == "mu_min > 58 deg" {seen++; bad += differs(f[14], 100 * mine[9])}
    END {exit n != 9 || seen != 2 || bad}' of_parts out

# what is refused
usage '--statistics needs all designs, not a --part' --statistics --part=1/2 t.deck
usage '--statistics takes no value' --statistics=all.csv t.deck
run 2 --statistics single.deck
says 'varies nothing'
sweep 'crank.length = 18 mm, 20 mm' 'statistics = yes'
run 2 t.deck
says "t.deck:31: error: statistics need 'output = NAME, ...' in [sweep]"
# refused LINE MESSAGE
refused() {
    sweep 'crank.length = 18 mm, 20 mm' 'output = mu_min' "$1"
    run 2 t.deck
    nothing
    says "t.deck:32: error: $2"
}
refused 'statistics = perhaps' 'expected no or yes'
refused 'yield = mu_min' "expected a condition, such as mu_min > 40 deg, not 'mu_min'"
refused 'yield = mu_min >' 'expected a condition'
refused 'yield = > 40 deg' 'expected a condition'
refused 'yield = mu_min = 40 deg' 'expected a condition'
refused 'yield = mu_min > 40 mm' "'40 mm' is a length; expected an angle"
refused 'yield = mu_min > 40,5 deg' 'expected a condition'
refused 'yield = mu_mn > 40 deg' "'mu_mn' is neither a fact nor"
refused 'yield = Ts < 4 N m' "'Ts' has a value in each row"
refused 'yield = mu_min > 40 deg < 50 deg' "unknown unit '< 50 deg'"

# ------------------------------------------------------------------------------- quantities in step

sweep 'crank.length & coupler.length & load W.torque = 18 mm & 60 mm & 1 N m, 20 mm & 6.6 cm & -2 N m' \
    'motion.speed = 10 rad/s to 30 rad/s step 10 rad/s' 'output = max(Ts), mu_min'
run 0 -f csv -b open t.deck
quiet
mv out stepped
lines stepped 7
check 'the header' grep -q '^design,crank.length (m),coupler.length (m),load W.torque (N.m),motion.speed (rad/s),branch,' stepped
n=0
for set in '18 mm&60 mm&1 N m' '20 mm&66 mm&-2 N m'; do
    for speed in 10 20 30; do
        n=$((n + 1))
        run 0 -f csv -b open -s "sweep.crank.length=${set%%&*}" -s "coupler.length=$(echo "$set" | cut -d'&' -f2)" \
            -s "load W.torque=${set##*&}" -s "motion.speed=$speed rad/s" -s 'sweep.output=max(Ts), mu_min' single.deck
        check "design $n in step" test "$(sed -n '2s/^[^,]*,[^,]*,//p' out)" = "$(sed -n "s/^$n,[^,]*,[^,]*,[^,]*,[^,]*,//p" stepped)"
    done
done
run 0 -f csv -b open -s 'sweep.ground.length & rocker.length=80 mm & 56 mm, 81 mm & 57 mm' -s sweep.output=mu_min single.deck
lines out 3
# refused_step LINE MESSAGE
refused_step() {
    sweep "$1" 'output = mu_min'
    run 2 t.deck
    nothing
    says "t.deck:30: error: $2"
}
refused_step 'crank.length & coupler.length = 18 mm & 60 mm, 20 mm' "expected 2 values in step, such as 18 mm & 60 mm, not '20 mm'"
refused_step 'crank.length & coupler.length = 18 mm & 60 mm & 5 mm' 'expected 2 values in step'
refused_step 'crank.length & coupler.length = 18 mm' 'expected 2 values in step'
refused_step 'crank.length & coupler.length = 18 mm & 60 kg' "'60 kg' is a mass"
refused_step 'crank.length & coupler.length = 18 mm & 60 mm, 20 & 66 mm' 'either all values of a quantity have a unit or none has'
refused_step 'crank.length & coupler.length = 18 mm & 60 mm to 20 mm & 66 mm step 1 mm' 'expected 2 values in step'
refused_step 'crank.length & coupler.length = 18 mm & 60 mm +- 1 mm' "unknown unit '+- 1 mm'"
refused_step 'crank.length & crank.length = 18 mm & 60 mm' "'crank.length' is varied twice"
refused_step 'crank.length & = 18 mm & 60 mm' "expected a quantity before and after '&'"
refused_step 'crank.length = 18 mm & 60 mm, 20 mm & 66 mm' "unknown unit '& 60 mm'"

# the table has one head, and with all digits the numbers of csv
tolerances="--statistics -s table.digits=17 $data/../doc/tolerance.deck"
run 0 $tolerances
check 'one head' test "$(grep -c '^#  count  *mean  *std_dev  *min  *5 %  *25 %  *50 %  *75 %  *95 %  *max$' out)" -eq 1
awk '!/^#/ && NF' out | tr -s ' ' ',' | sed 's/^,//' >rows
"$fourlink" -f csv $tolerances | tr -d '\r' | sed 1d | cut -d, -f4-13 >expected
check 'all digits' cmp rows expected

# where a yield prints statistics, programs are told how to get the designs
sweep 'coupler.length = 66 mm, 67 mm' 'output = mu_min' 'yield = mu_min > 58 deg'
run 0 -f csv t.deck
says 't.deck: note: with a yield, statistics are printed, not designs; --set=sweep.statistics=no prints the designs'
run 0 -f csv --set=sweep.statistics=no t.deck
quiet
lines out 5
for option in --statistics --format=table; do
    run 0 -f csv $option t.deck
    quiet
done

finish
