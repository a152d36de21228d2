#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_klein.sh FOURLINK DATA - what stands beside Klein's construction; drawn.py has its points.
. "$(dirname "$0")/pictures.sh"
# of places that two drawings have
rounded() { awk -F '\t' -v OFS='\t' '{split($3, p, " "); $3 = sprintf("%.1f %.1f %.1f %.1f", p[1], p[2], p[3], p[4]); gsub(/-0\.0/, "0.0", $3); print}'; }

# --- the line of stroke, the slider in its guide, the ground; the crank enlarged where it is small beside the rod
listed 0 k.list --plot-kind=klein --branch=open --set='ground.offset=60 mm' "$engine"
arrows k.list line | rounded | grep "^Klein's construction" >whole
check 'the line of stroke' awk -F '\t' '$2 == "construction" {split($3, p, " "); if (p[2] == 60 && p[4] == 60 && p[3] - p[1] > 450) n++} END {exit n != 1}' whole
check 'the slider' test "$(awk -F '\t' '$2 == "follower"' whole | wc -l)" -eq 5
check 'the support and the guide' test "$(awk -F '\t' '$2 == "ground"' whole | wc -l)" -eq 5
arrows k.list line | rounded | grep '^at the crank, enlarged' >inset
for look in crank follower force result; do
    awk -F '\t' -v look=$look '$2 == look {print $3}' inset >small
    awk -F '\t' -v look=$look '$2 == look {print $3}' whole >large
    check "the inset has lines of the $look" test -s small
    check "the inset and the whole agree, $look" awk 'NR == FNR {seen[$0] = 1; next} !($0 in seen) {bad = 1} END {exit bad}' large small
done
check 'the inset is larger' awk '$1 == "range" {size[++n] = $3 - $2} END {exit !(n == 2 && size[2] < 0.6 * size[1])}' k.list
listed 1 k.list --plot-kind=klein --branch=open --set='rod.length=150 mm' "$engine"
check 'a crank as long as the rod is not enlarged' none 'enlarged' k.list
listed 0 k.list --plot-kind=klein --branch=open --set='motion.acceleration=5 rad/s2' "$engine"
check 'with an acceleration it is said what the construction leaves out' grep -q '^note a and α₃ for α₂ = 0' k.list
listed 0 k.list --plot-kind=klein --branch=open --plot-at='90 deg' "$engine"
check 'no arms about a centre at infinity' none 'I[XY] = ' k.list
listed 0 k.list --plot-kind=klein --branch=open --plot-at='60 deg' "$engine"
check 'arms about the centre' test "$(grep -c 'I[XY] = ' k.list)" -eq 2
check 'names typeset' none '[FW]_C ' k.list
check 'the crank effort by moments' grep -q 'FT IB = m ω₂² gO IY - m g IX' k.list

finish
