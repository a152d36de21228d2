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
        "$fourlink" --format=csv --branch=$branch --set="motion.at=$angle deg" \
            --columns=klein_OM,klein_ON,klein_BM,klein_BQ,klein_QN,klein_IX,klein_IY,klein_FT,v,a,omega2 "$engine" >csv
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

finish
