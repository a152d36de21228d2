#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_klein.sh FOURLINK DATA - Klein's construction against its columns.
. "$(dirname "$0")/pictures.sh"

# Klein's construction against its columns, which are positive towards the piston and, OM, with its speed.
for angle in 20 140 300; do
    for branch in open crossed; do
        where="$branch, $angle deg"
        side=$([ $branch = open ] && echo 1 || echo -1)
        run 0 --plot-script=k.gp --plot-kind=klein --plot-at="$angle deg" --branch=$branch "$engine"
        quiet
        arrows k.gp nohead >all
        "$fourlink" --format=csv --branch=$branch --set="motion.at=$angle deg" \
            --columns=klein_OM,klein_ON,klein_BM,klein_BQ,klein_QN,klein_IX,klein_IY,klein_FT,v,a,omega2,omega3,alpha3 "$engine" >csv
        for reading in v a omega3 alpha3; do
            short=$(echo $reading | sed 's/omega3/ω₃/; s/alpha3/α₃/')
            near "$reading as read from the drawing: $where" "$(awk -F '\t' -v name="$short = " '$2 == "note" && index($3, name) == 1 {
                sub(/.* = /, "", $3); print $3 + 0}' all)" "$(number $reading)" 1e-4
        done
        arrows k.gp nohead | grep "^Klein's construction, $branch, θ₂ = $angle°	" >arrows
        set -- $(awk -F '\t' -v s=$side '$2 == 4 {split($3, p, " "); print s * p[1], p[2], p[3], p[4]}' arrows)
        near "ON: $where" "$1" "$(number klein_ON)" 1e-5
        near "N is on the line of stroke: $where" "$2" 0 0
        near "ON ends in O: $where" "$3$4" 00 0
        near "a = omega2^2 ON: $where" "$(number omega2 | awk -v x="$1" '{print $1 * $1 * x / 1000}')" "$(number a)" 2e-5
        set -- $(awk -F '\t' -v s=$side '$2 == 10 {split($3, p, " "); print p[3], s * p[4]; exit}' arrows)
        near "M is above O: $where" "$1" 0 0
        near "OM: $where" "$2" "$(number klein_OM)" 1e-5
        near "v = omega2 OM: $where" "$(number omega2 | awk -v x="$2" '{print $1 * x / 1000}')" "$(number v)" 2e-5
        set -- $(awk -F '\t' '$2 == 10 && ++n > 1 {split($3, p, " "); print p[3] - p[1], p[4] - p[2]}' arrows)
        near "BQ: $where" "$(size "$1" "$2")" "$(number klein_BQ)" 2e-5
        near "QN: $where" "$(size "$3" "$4")" "$(number klein_QN | awk '{print $1 < 0 ? -$1 : $1}')" 2e-5
        near "QN is at right angles to BQ: $where" "$(awk -v a="$1" -v b="$2" -v c="$3" -v d="$4" 'BEGIN {
            print 1 + (a * c + b * d) / sqrt((a * a + b * b) * (c * c + d * d))}')" 1 1e-4
        set -- $(awk -F '\t' '$2 == 8 {split($3, p, " "); print p[3] - p[1], p[4] - p[2]}' arrows)
        near "IX: $where" "$(size "$1" "$2")" "$(number klein_IX | awk '{print $1 < 0 ? -$1 : $1}')" 2e-5
        set -- $(awk -F '\t' '$2 == 7 {split($3, p, " "); print p[3] - p[1], p[4] - p[2]}' arrows)
        near "gO is at right angles to IY: $where" "$(awk -v a="$1" -v b="$2" -v c="$3" -v d="$4" 'BEGIN {
            print 1 + (a * c + b * d) / sqrt((a * a + b * b) * (c * c + d * d))}')" 1 1e-4
        near "IY: $where" "$(size "$3" "$4")" "$(number klein_IY | awk '{print $1 < 0 ? -$1 : $1}')" 2e-5
        for name in OM BM BQ QN ON IX IY FT; do
            near "note of $name: $where" "$(awk -F '\t' -v name="$name = " '$2 == "note" && index($3, name) == 1 {
                split($3, w, " "); print w[3]}' arrows)" "$(number klein_$name)" 1e-4
        done
    done
done

# --- the line of stroke, the slider in its guide, the ground; the crank enlarged where it is small beside the rod
run 0 --plot-script=k.gp --plot-kind=klein --branch=open --set='ground.offset=60 mm' "$engine"
arrows k.gp nohead | grep "^Klein's construction" >whole
check 'the line of stroke' awk -F '\t' '$2 == 9 {split($3, p, " "); if (p[2] == 60 && p[4] == 60 && p[3] - p[1] > 450) n++} END {exit n != 1}' whole
check 'the slider' test "$(awk -F '\t' '$2 == 4' whole | wc -l)" -eq 5
check 'the support and the guide' test "$(awk -F '\t' '$2 == 1' whole | wc -l)" -eq 5
arrows k.gp nohead | grep '^at the crank, enlarged' >inset
for pen in 2 4 7 10; do
    awk -F '\t' -v pen=$pen '$2 == pen {print $3}' inset >small
    awk -F '\t' -v pen=$pen '$2 == pen {print $3}' whole >large
    check "the inset has lines of pen $pen" test -s small
    check "the inset and the whole agree, pen $pen" awk 'NR == FNR {seen[$0] = 1; next} !($0 in seen) {bad = 1} END {exit bad}' large small
done
check 'the inset is larger' awk '/^set xrange/ {r = $3; gsub(/[][]/, "", r); split(r, p, ":"); size[++n] = p[2] - p[1]} END {exit !(n == 2 && size[2] < 0.6 * size[1])}' k.gp
run 1 --plot-script=k.gp --plot-kind=klein --branch=open --set='rod.length=150 mm' "$engine"
check 'a crank as long as the rod is not enlarged' none 'enlarged' k.gp
run 0 --plot-script=k.gp --plot-kind=klein --branch=open --set='motion.acceleration=5 rad/s2' "$engine"
check 'with an acceleration it is said what the construction leaves out' grep -q '^set label "a and α₃ for α₂ = 0"' k.gp

finish
